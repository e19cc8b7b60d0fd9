//! Findings as a compiler draws them: how much of a text is shown around a place.

use polhode::diagnostic::Diagnostic;
use polhode::report::terminal::diagnostics;
use polhode::source::{Source, Span};

/// The drawing of a finding at a place of a text, without colours.
fn drawn(text: &str, start: usize, end: usize) -> String {
    let wrong = Diagnostic::error("a-code", Span::new(start, end), "something is wrong");
    let drawn = diagnostics(&Source::new("notes", text), &[wrong]);
    anstream::adapter::strip_str(&drawn).to_string()
}

/// How many characters of the drawing are under a place.
fn underlined(drawn: &str) -> usize {
    drawn.matches('^').count()
}

#[test]
fn whole_lines_are_shown_around_a_place() {
    let drawn = drawn("one\ntwo α\nthree\nfour\nfive", 8, 13);
    for (line, is_shown) in [
        ("one", false),
        ("2 |", true),
        ("two α", true),
        ("three", true),
        ("four", false),
        ("five", false),
    ] {
        assert_eq!(drawn.contains(line), is_shown, "{line}: {drawn}");
    }
    assert!(drawn.contains("notes:2:5"), "{drawn}");
}

#[test]
fn an_overlong_line_is_cut_to_a_window() {
    let drawn = drawn(&"é".repeat(2_000), 2_000, 2_002);
    assert!(drawn.contains("notes:1:1001"), "{drawn}");
    assert!(drawn.matches('é').count() <= 241, "{drawn}");
    assert_eq!(underlined(&drawn), 1, "{drawn}");
}

#[test]
fn a_place_outside_the_text_or_inside_a_character_is_no_panic() {
    assert!(drawn("ω", 5, 9).contains("ω"));
    let inside = drawn("ωω", 1, 3);
    assert_eq!(underlined(&inside), 1, "{inside}");
}
