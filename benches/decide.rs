//! The time from text to verdict: certificate, premises and all.
//!
//! Targets, on one core: a typical line 30 µs, the search for the mistake of a false line 2 ms, and a time per line that
//! stays within a factor of two from ten lines to ten thousand. A zero test of the component line alone takes 1.5 ms by
//! a hand-picked `expand` in SymPy and 24 ms by `simplify`.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use polhode::notation::{document::Format, read};
use polhode::verify::{Report, check};
use std::hint::black_box;

/// The one of the command.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

const OPENING: &str = "The axes are attached to the body.\n\n";
/// Lines of the lecture, each proved by the laws alone.
const LINES: [&str; 5] = [
    r"$$\Sigma M_x = \dot L_x - L_y\omega_z + L_z\omega_y$$",
    r"$$L_x = I_{xx}\omega_x - I_{xy}\omega_y - I_{xz}\omega_z$$",
    r"$$\Sigma M_z = \dot L_z - L_x\omega_y + L_y\omega_x$$",
    r"$$\dot L_x = I_{xx}\dot\omega_x - I_{xy}\dot\omega_y - I_{xz}\dot\omega_z$$",
    r"$$\Sigma M_x = I_{xx}\dot\omega_x - (I_{yy} - I_{zz})\omega_y\omega_z - I_{xy}(\dot\omega_y - \omega_z\omega_x) - I_{xz}(\dot\omega_z + \omega_x\omega_y) - I_{yz}(\omega_y^2 - \omega_z^2)$$",
];
/// The last of them with one sign turned.
const FALSE: &str = r"$$\Sigma M_x = I_{xx}\dot\omega_x - (I_{yy} - I_{zz})\omega_y\omega_z - I_{xy}(\dot\omega_y + \omega_z\omega_x) - I_{xz}(\dot\omega_z + \omega_x\omega_y) - I_{yz}(\omega_y^2 - \omega_z^2)$$";

fn checked(text: &str) -> Report {
    let (document, _) = read("bench.md", text, Format::Markdown);
    check(&document)
}

/// A line with words before it, as in a lecture.
fn told(line: &str) -> String {
    format!("By the laws, with the terms written out, it is found that\n{line}\n\n")
}

fn document(lines: usize) -> String {
    document_of(&LINES, lines)
}

fn document_of(kinds: &[&str], lines: usize) -> String {
    let told = kinds.iter().cycle().take(lines).map(|line| told(line));
    OPENING.to_owned() + &told.collect::<String>()
}

fn lines(c: &mut Criterion) {
    let mut group = c.benchmark_group("from text to verdict");
    for (name, line) in ["moment", "inertia", "moment about z", "rate", "expanded"]
        .iter()
        .zip(LINES)
    {
        // The same line again and again, so that what a document costs once is shared.
        let text = format!("{OPENING}{}", told(line).repeat(100));
        assert_eq!(checked(&text).summary().proved, 100, "{name}");
        group.throughput(Throughput::Elements(100));
        group.bench_function(*name, |b| b.iter(|| checked(black_box(&text))));
    }
}

fn reading(c: &mut Criterion) {
    let mut group = c.benchmark_group("reading alone");
    group.throughput(Throughput::Elements(100));
    // A typical line, and with the long one among them.
    for (name, kinds) in [("typical lines", &LINES[..4]), ("a hundred lines", &LINES)] {
        let text = document_of(kinds, 100);
        group.bench_function(name, |b| {
            b.iter(|| read("bench.md", black_box(&text), Format::Markdown))
        });
    }
}

fn repair(c: &mut Criterion) {
    let (whole, without) = (
        format!("{OPENING}{FALSE}\n"),
        format!("{OPENING}{}\n", LINES[4]),
    );
    let report = checked(&whole);
    let diagnosis = report.findings[0].diagnosis.as_ref();
    assert_eq!(diagnosis.map(|d| d.kind), Some("sign"), "the slip is named");
    let mut group = c.benchmark_group("a document of one line");
    group.bench_function("true", |b| b.iter(|| checked(black_box(&without))));
    group.bench_function("false, with the search for its mistake", |b| {
        b.iter(|| checked(black_box(&whole)))
    });
}

fn growth(c: &mut Criterion) {
    let mut group = c.benchmark_group("lines of one document");
    group.sample_size(10);
    for count in [10, 100, 1_000, 10_000] {
        let text = document(count);
        assert_eq!(checked(&text).summary().proved, count);
        group.throughput(Throughput::Elements(count as u64));
        group.bench_with_input(BenchmarkId::from_parameter(count), &text, |b, text| {
            b.iter(|| checked(black_box(text)))
        });
    }
}

criterion_group!(benches, lines, reading, repair, growth);
criterion_main!(benches);
