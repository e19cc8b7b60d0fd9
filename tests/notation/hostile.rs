//! Input that was made to hurt: it ends in a message, the stack holds, and the rest of the document is read.

use super::outline::{self, document};
use polhode::notation::document::Format;
use polhode::notation::read;
use polhode::verify::check;

/// Reads a display between two good lines; both must be read.
fn between(formula: &str) -> Vec<String> {
    let text = format!("$$a = b$$\n\n$$\n{formula}\n$$\n\n$$c = d$$\n");
    let (document, troubles) = read("a.md", &text, Format::Markdown);
    let rows = outline::formulas(&document);
    assert!(rows.starts_with("a = b\n"), "{formula:.40}");
    assert!(rows.ends_with("\nc = d"), "{formula:.40}");
    troubles
        .into_iter()
        .map(|trouble| trouble.message)
        .collect()
}

#[test]
fn ten_thousand_levels_are_refused_with_a_message() {
    let nested = [
        ("{", "}"),
        ("(", ")"),
        ("[", "]"),
        ("\\left(", "\\right)"),
        ("\\left|", "\\right|"),
        ("\\frac{a}{", "}"),
        ("\\sqrt{", "}"),
        ("\\dot{", "}"),
        ("\\vec{", "}"),
        ("\\cos\\theta(", ")"),
        ("\\sin(", ")"),
        ("f(", ")"),
        ("d(", ")/dt"),
        ("\\frac{d}{dt}(", ")"),
        ("\\frac{dx}{d", "}"),
        ("x^{", "}"),
        ("\\overset{.}{", "}"),
        ("\\begin{bmatrix}", "\\end{bmatrix}"),
        ("\\underbrace{", "}"),
    ];
    for (open, close) in nested {
        let text = format!("{}x{}", open.repeat(10_000), close.repeat(10_000));
        let said = between(&text);
        let deep = |said: &String| said.contains("nested") || said.contains("too long");
        assert!(
            !said.is_empty() && said.iter().all(deep),
            "{open}: {said:?}"
        );
    }
}

#[test]
fn chains_without_brackets_do_not_exhaust_the_stack() {
    let units = [
        "\\dot",
        "\\vec",
        "\\sqrt",
        "\\sin",
        "\\frac",
        "\\delta",
        "\\Sigma",
        "\\partial_x",
        "\\sum_i",
        "\\frac{d}{dt}",
        "{}^a",
        "^a",
        "a/",
        "a^",
        "a_",
        "d/d",
        "dx/dt",
        "-",
        "'",
        "|_a",
        "\\int_0^1",
        "\\overset{.}",
        "\\begin{aligned}",
        "\\begin{array}[",
        "\\boxed{a=",
        "\\dv",
        "\\\\[",
        "&",
        "\\unknown{",
        "\\text{",
    ];
    for unit in units {
        let _ = between(&unit.repeat(5_000));
    }
}

#[test]
fn braces_and_bars_that_never_meet_are_told() {
    for formula in [
        "a = (b",
        "a = \\left[ b",
        "a = |b",
        "a = b)",
        "} a = b",
        "a^",
        "a = ",
    ] {
        let said = between(formula);
        assert_eq!(said.len(), 1, "{formula}: {said:?}");
    }
}

#[test]
fn a_display_that_is_not_closed_ends_with_its_paragraph() {
    for open in ["$$ x = ", "\\[ x = ", "\\begin{align} x = "] {
        let text = format!("$a = b$\n\n{open}\n\nThen $c = d$.");
        let (document, troubles) = read("a.md", &text, Format::Markdown);
        assert_eq!(troubles.len(), 1, "{open}");
        assert!(troubles[0].message.contains("not closed"), "{open}");
        let rows = outline::formulas(&document);
        assert!(rows.starts_with("a = b\n"), "{open}: {rows}");
    }
}

#[test]
fn macros_that_grow_without_end_are_stopped() {
    let bomb = "\\newcommand{\\a}{\\b\\b\\b\\b}\\newcommand{\\b}{\\c\\c\\c\\c}\\newcommand{\\c}{\\d\\d\\d\\d}\n\
                \\newcommand{\\d}{\\e\\e\\e\\e}\\newcommand{\\e}{\\f\\f\\f\\f}\\newcommand{\\f}{\\g\\g\\g\\g}\n\
                \\newcommand{\\g}{\\h\\h\\h\\h}\\newcommand{\\h}{x x x x x x x x x x}\n\n";
    let selfish = "\\newcommand{\\a}{\\a\\a}\n\n";
    let argument = "\\newcommand{\\a}[1]{\\a{#1#1}}\n\n";
    for (definitions, call) in [(bomb, "\\a"), (selfish, "\\a"), (argument, "\\a{x}")] {
        let text = format!(
            "{definitions}{}$c = d$",
            format!("${call} = 0$ ").repeat(1000)
        );
        let (document, troubles) = read("a.tex", &text, Format::Latex);
        assert!(troubles.len() >= 900, "{call}: {}", troubles.len());
        assert!(troubles[0].message.contains("without end"), "{troubles:?}");
        let rows = outline::formulas(&document);
        assert!(rows.ends_with("c = d") || rows.ends_with("without end"));
    }
}

#[test]
fn settings_and_notebooks_that_nest_without_end_are_refused() {
    let aliases: String = ('b'..='k')
        .zip('a'..)
        .map(|(name, of)| format!("{name}: &{name} [{}]\n", format!("*{of},").repeat(20)))
        .collect();
    let yaml = format!("---\na: &a [x]\n{aliases}---\n$a = b$");
    let (bombed, troubles) = read("a.md", &yaml, Format::Markdown);
    assert_eq!(outline::formulas(&bombed), "a = b");
    assert_eq!(troubles.len(), 1);
    let deep = format!("---\na: {}\n---\n$a = b$", "[".repeat(30_000));
    let (deep, troubles) = read("a.md", &deep, Format::Markdown);
    assert_eq!(outline::formulas(&deep), "a = b");
    assert_eq!(troubles.len(), 1);
    let (_, troubles) = read("a.ipynb", &"[".repeat(100_000), Format::Notebook);
    assert_eq!(troubles.len(), 1);
}

#[test]
fn hidden_characters_are_told_and_change_nothing_unseen() {
    for (character, word) in [
        ('\0', "NUL"),
        ('\u{202e}', "direction"),
        ('\u{2066}', "direction"),
    ] {
        let text = format!("Then $a {character}= b$ and $c = d$.");
        let (document, troubles) = read("a.md", &text, Format::Markdown);
        assert!(troubles.iter().any(|t| t.message.contains(word)), "{word}");
        let rows = outline::formulas(&document);
        assert!(
            rows.starts_with("unreadable") && rows.ends_with("c = d"),
            "{word}: {rows}"
        );
    }
    // Marks that only keep letters apart are no part of a formula.
    assert_eq!(
        document("$a\u{200b} =\u{200f} b$", Format::Markdown),
        "a = b"
    );
}

#[test]
fn a_line_of_a_million_characters_is_refused_and_the_rest_is_read() {
    let said = between(&"a + ".repeat(250_000));
    assert_eq!(said, ["a formula that is too long to be read"]);
    let plain = format!("a = {}b\nc = d\n", "a + ".repeat(250_000));
    let (read, troubles) = read("a.txt", &plain, Format::Text);
    assert_eq!(troubles.len(), 1);
    assert!(outline::formulas(&read).ends_with("c = d"));
}

#[test]
fn the_tallest_trees_that_are_read_are_checked_on_a_small_stack() {
    let nested = [
        ("(", ")"),
        ("\\frac{a}{", "}"),
        ("\\frac{d}{dt}", ""),
        ("\\sum_i", ""),
        ("(", ")_a^b_c_d_e_f_g_h"),
        ("(", "/a/b/c/d/e/f/g/h)"),
        ("\\begin{bmatrix}", "\\end{bmatrix}"),
        ("f(", ")"),
        ("x^{", "}"),
        ("-", ""),
    ];
    for (open, close) in nested {
        for depth in [8, 14, 30, 48, 50, 98, 100, 120] {
            let text = format!("$$x = {}x{}$$", open.repeat(depth), close.repeat(depth));
            let (document, troubles) = read("a.md", &text, Format::Markdown);
            let report = check(&document);
            assert_eq!(report.findings.len(), 1, "{open} {depth}");
            assert!(
                depth < 60 || open == "-" || troubles.len() == 1,
                "{open} {depth}"
            );
        }
    }
}

#[test]
fn a_line_of_a_million_characters_is_told_and_the_rest_is_read() {
    let long = [
        ("h the momentum ", Format::Text),
        ("$a", Format::Markdown),
        ("Let $a$ be the mass, ", Format::Markdown),
        ("Let $a$ be the mass, ", Format::Latex),
        ("a = b ", Format::Text),
    ];
    for (words, format) in long {
        let line = words.repeat(1_000_000 / words.len());
        let relation = match format {
            Format::Text => "a = b",
            _ => "$a = b$",
        };
        let text = format!("{relation}\n\n{line}\n\n{relation}\n");
        let (document, troubles) = read("a", &text, format);
        assert_eq!(outline::formulas(&document), "a = b\na = b");
        let [trouble] = troubles.as_slice() else {
            panic!("{words}: {troubles:?}");
        };
        assert!(trouble.message.contains("too long"), "{}", trouble.message);
        assert_eq!(
            document.source.line_column(trouble.primary.span.start),
            (3, 1)
        );
    }
}

#[test]
fn a_picture_in_a_line_of_markdown_is_no_formula() {
    let picture = "QUJD".repeat(50_000);
    let text = format!("$a = b$\n\n![](data:image/png;base64,{picture})\n\n$c = d$\n");
    let (document, troubles) = read("a.md", &text, Format::Markdown);
    assert!(troubles.is_empty());
    assert_eq!(outline::formulas(&document), "a = b\nc = d");
    let cell = serde_json::json!({"cells": [{"cell_type": "markdown", "source": text}]});
    let (document, troubles) = read("a.ipynb", &cell.to_string(), Format::Notebook);
    assert!(troubles.is_empty());
    assert_eq!(outline::formulas(&document), "a = b\nc = d");
}
