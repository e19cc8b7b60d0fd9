//! The time from text to tree.
//!
//! Targets, on one core: a typical line 5 µs, a time per byte that does not grow from 1 KB to 1 MB, and 100 ms for a
//! megabyte that was made to hurt.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use polhode::notation::{Macros, document::Format, read, read_formula};
use std::hint::black_box;

/// Lines of the lecture, from short to long.
const LINES: [(&str, &str); 4] = [
    (
        "inertia",
        r"L_x = I_{xx}\omega_x - I_{xy}\omega_y - I_{xz}\omega_z",
    ),
    (
        "moment",
        r"\Sigma M_x = \dot L_x - L_y\omega_z + L_z\omega_y",
    ),
    (
        "vectors",
        r"\left(\frac{d\vec L}{dt}\right)_{XYZ} = \left(\frac{d\vec L}{dt}\right)_{xyz} + \vec\Omega\times\vec L",
    ),
    (
        "expanded",
        r"\Sigma M_x = I_{xx}\dot\omega_x - (I_{yy} - I_{zz})\omega_y\omega_z - I_{xy}(\dot\omega_y - \omega_z\omega_x) - I_{xz}(\dot\omega_z + \omega_x\omega_y) - I_{yz}(\omega_y^2 - \omega_z^2)",
    ),
];

fn lines(c: &mut Criterion) {
    let mut group = c.benchmark_group("reading a line");
    let macros = Macros::default();
    for (name, line) in LINES {
        group.throughput(Throughput::Bytes(line.len() as u64));
        group.bench_function(name, |b| {
            b.iter(|| read_formula(black_box(line), 0, &macros))
        });
    }
}

/// A document of at least so many bytes, with words around its formulas as in a lecture.
fn lecture(bytes: usize) -> String {
    let mut text = String::from("# A lecture\n\nThe axes are attached to the body.\n\n");
    for (_, line) in LINES.iter().cycle() {
        if text.len() >= bytes {
            break;
        }
        text.push_str("By the laws, with the terms written out, it is found that\n\n$$");
        text.push_str(line);
        text.push_str("$$\n\nwhere $\\omega_x$ is the first component.\n\n");
    }
    text
}

fn documents(c: &mut Criterion) {
    let mut group = c.benchmark_group("reading a document");
    group.sample_size(10);
    for kilobytes in [1, 10, 100, 1000] {
        let text = lecture(kilobytes * 1000);
        let (_, troubles) = read("bench.md", &text, Format::Markdown);
        assert!(troubles.is_empty(), "{troubles:?}");
        group.throughput(Throughput::Bytes(text.len() as u64));
        for (name, format) in [("Markdown", Format::Markdown), ("LaTeX", Format::Latex)] {
            group.bench_with_input(BenchmarkId::new(name, kilobytes), &text, |b, text| {
                b.iter(|| read("bench", black_box(text), format))
            });
        }
    }
}

/// A megabyte of a piece.
fn megabyte(piece: &str) -> String {
    piece.repeat(1_000_000 / piece.len())
}

/// Inputs of a megabyte that were made to hurt.
fn hostile() -> Vec<(&'static str, String)> {
    let bomb = "\\newcommand{\\a}{\\b\\b\\b\\b}\\newcommand{\\b}{\\c\\c\\c\\c}\\newcommand{\\c}{\\d\\d\\d\\d}\n\
                \\newcommand{\\d}{\\e\\e\\e\\e}\\newcommand{\\e}{\\f\\f\\f\\f}\\newcommand{\\f}{x x x x x x}\n\n";
    vec![
        (
            "one line of a million characters",
            format!("$${}$$", megabyte("a + ")),
        ),
        ("one nest", format!("$${}$$", megabyte("("))),
        (
            "nests",
            megabyte(&format!("$${}x{}$$\n\n", "(".repeat(500), ")".repeat(500))),
        ),
        (
            "braces",
            megabyte(&format!(
                "$${}x{}$$\n\n",
                "{".repeat(9000),
                "}".repeat(9000)
            )),
        ),
        ("formulas that are not closed", megabyte("$$ a = b\n\n")),
        ("dollars", megabyte("$")),
        ("backslashes", megabyte("\\[")),
        ("a macro bomb", format!("{bomb}{}", megabyte("$\\a = 0$ "))),
        ("NUL bytes", megabyte("$a \0 = b$ ")),
        ("marks of direction", megabyte("$a \u{202e}= b$ ")),
    ]
}

fn adversaries(c: &mut Criterion) {
    let mut group = c.benchmark_group("reading a megabyte that was made to hurt");
    group.sample_size(10);
    for (name, text) in hostile() {
        group.throughput(Throughput::Bytes(text.len() as u64));
        group.bench_function(name, |b| {
            b.iter(|| read("bench.md", black_box(&text), Format::Markdown))
        });
    }
}

criterion_group!(benches, lines, documents, adversaries);
criterion_main!(benches);
