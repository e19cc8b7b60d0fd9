//! Submissions that are meant to break the marker: each ends soon, with a reason, and earns nothing by it.

use super::command::class;
use super::{marked, outcomes};

#[test]
fn a_hostile_text_ends_soon_with_a_reason() {
    let nested = |open: &str, close: &str, n: usize| {
        format!("$${}x{} = 1$$", open.repeat(n), close.repeat(n))
    };
    let texts = [
        ("deep groups", nested("(", ")", 20_000)),
        ("deep braces", nested("{", "}", 20_000)),
        ("deep fractions", nested("\\frac{1}{", "}", 5_000)),
        ("a tower", "$$M_x = \\omega_x^{10^9}$$".to_owned()),
        ("an expansion", "$$M_x = (\\omega_x + \\omega_y + I_{xx} + I_{yy} + L_x + L_y + L_z + I_{zz})^{10000}$$".to_owned()),
        (
            "macros",
            format!(
                "$$\\newcommand{{\\a}}{{xx}}{} M_x = \\z$$",
                ('a'..='y').map(|c| {
                    let next = char::from(c as u8 + 1);
                    format!("\\newcommand{{\\{next}}}{{\\{c}\\{c}\\{c}\\{c}}}")
                }).collect::<String>()
            ),
        ),
        ("many lines", "$$M_x = 1$$\n\n".repeat(5_000)),
        ("a long line", format!("$$M_x = {}$$", "\\omega_x + ".repeat(50_000))),
        ("bidi", "$$M_x = \u{202e}\\omega_x$$".to_owned()),
        ("script", "<script>alert(1)</script> $$M_x = \\href{javascript:alert(1)}{\\omega_x}$$".to_owned()),
    ];
    for (name, text) in texts {
        let start = std::time::Instant::now();
        let graded = marked(&text);
        let seconds = start.elapsed().as_secs_f64();
        println!("{name}: {seconds:.2} s, {:?}", graded.queue);
        assert!(!outcomes(&graded).contains(&"full"), "{name}: {graded:?}");
        assert!(
            graded.queue.is_some() || graded.marks.to_string() == "0",
            "{name}"
        );
    }
}

#[test]
fn what_hides_in_a_formula_is_said() {
    for (text, why) in [
        ("$$M_x = \u{202e}\\omega_x$$", "direction of writing"),
        ("$$M_\u{445} = \\dot L_x$$", "U+0445"),
        ("$$\u{39c}_x = \\dot L_x$$", "U+039C"),
    ] {
        let graded = marked(text);
        let queue = graded.queue.unwrap_or_default();
        assert!(queue.contains(why), "{text}: {queue}");
        assert_eq!(graded.marks.to_string(), "0");
    }
}

/// Peak memory of the command, in megabytes, and its seconds, for one submission.
#[cfg(target_os = "linux")]
fn cost(name: &str, text: &[u8]) -> (u64, f64) {
    let folder = class(&[(name, text)]);
    let path = |name: &str| folder.path().join(name);
    let start = std::time::Instant::now();
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_polhode"))
        .arg("grade")
        .args([path("key.md"), path("work")])
        .arg("--out")
        .arg(path("out"))
        .args(["--threads", "1"])
        .stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::null())
        .spawn()
        .expect("the command runs");
    let mut peak = 0;
    while child.try_wait().expect("waited for").is_none() {
        let status = std::fs::read_to_string(format!("/proc/{}/status", child.id()));
        let status = status.unwrap_or_default();
        let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kilobytes = line.and_then(|line| line.split_whitespace().next()?.parse::<u64>().ok());
        peak = peak.max(kilobytes.unwrap_or(0));
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    let results = std::fs::read_to_string(path("out/results.json")).unwrap_or_default();
    assert!(results.contains("\"id\""), "{name} is lost");
    assert!(
        !results.contains("\"queue\": null"),
        "{name} is not in the queue"
    );
    (peak >> 10, start.elapsed().as_secs_f64())
}

/// Texts that ask for more than is worked out.
pub(super) fn too_much() -> [(&'static str, Vec<u8>); 12] {
    let sum = |n: usize| {
        (0..n)
            .map(|k| format!("a_{{{k}}}"))
            .collect::<Vec<_>>()
            .join("+")
    };
    let powers = (0..60).map(|k| format!("$$M_x = ({})^{{{}}}$$\n\n", sum(8), 2 + k % 9));
    let products = (0..40).map(|_| {
        let factor = "(\\omega_x + \\omega_y + \\omega_z + I_{xx} + I_{yy} + I_{zz})";
        format!("$$M_x = {}$$\n\n", factor.repeat(12))
    });
    let nested = format!("$$M_x = {}1{}$$", "\\frac{1}{1+".repeat(60), "}".repeat(60));
    let rates = format!(
        "$$M_x = \\frac{{d^{{40}}}}{{dt^{{40}}}}({})$$",
        "\\omega_x\\omega_y".repeat(20)
    );
    let many = "$$M_x = \\dot L_x + \\omega_y L_z - 2\\omega_z L_y$$\n\n".repeat(390);
    let matrices = format!(
        "$$M_x = {}$$",
        "\\begin{bmatrix}1&2&3\\\\4&5&6\\\\7&8&9\\end{bmatrix}".repeat(300)
    );
    let squares = (0..390).map(|k| format!("$$a_{{{}}} = a_{{{k}}}^2 + a_{{{k}}}$$\n\n", k + 1));
    let squares = format!(
        "Let $$a_0 = \\omega_x + \\omega_y$$\n\n{}",
        squares.collect::<String>()
    );
    let sums = (1..390).map(|k| {
        let (next, before) = (k + 1, k - 1);
        format!("$$a_{{{next}}} = 2a_{{{k}}} + \\omega_z a_{{{before}}}$$\n\n")
    });
    let sums = sums.collect::<String>();
    let roots = format!(
        "$$M_x = \\frac{{d}}{{dt}}{}\\omega_x{}$$",
        "\\sqrt{1+".repeat(30),
        "}".repeat(30)
    );
    [
        ("squares.md", squares.into_bytes()),
        ("sums.md", sums.into_bytes()),
        ("roots.md", roots.into_bytes()),
        ("powers.md", powers.collect::<String>().into_bytes()),
        ("products.md", products.collect::<String>().into_bytes()),
        ("fractions.md", nested.into_bytes()),
        ("rates.md", rates.into_bytes()),
        ("lines.md", many.into_bytes()),
        ("matrices.md", matrices.into_bytes()),
        ("million.md", b"x\n".repeat(1_000_000)),
        (
            "homoglyph.md",
            "$$M_\u{445} = \\dot L_\u{445} + \u{3c9}_y L_z$$"
                .as_bytes()
                .to_vec(),
        ),
        ("dollars.md", "$".repeat(900_000).into_bytes()),
    ]
}

/// The key takes its part of both; what is left is for the submission.
#[cfg(target_os = "linux")]
#[test]
fn time_and_memory_are_bounded() {
    let hostile = too_much();
    let (least, usual) = cost("prose.md", b"nothing");
    println!("the key alone: {least} MB, {usual:.2} s");
    let mut over = vec![];
    for (name, text) in hostile {
        let (memory, seconds) = cost(name, &text);
        println!("{name}: {memory} MB, {seconds:.2} s");
        // Two seconds of an optimised build; this one may take five times as long.
        if memory > least + 256 || seconds > usual + 10.0 {
            over.push(format!("{name}: {memory} MB, {seconds:.2} s"));
        }
    }
    assert!(over.is_empty(), "{over:?}");
}
