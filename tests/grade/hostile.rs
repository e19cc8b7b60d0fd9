//! Submissions that are meant to break the marker: each ends soon, with a reason, and earns nothing by it.

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
