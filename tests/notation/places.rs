//! Places in a text: lines, columns and spans.

use polhode::source::{Source, Span};

/// Characters are counted in blocks of so many bytes.
const BLOCK: usize = 1024;

#[test]
fn lines_and_columns_count_from_one_and_in_characters() {
    let source = Source::new("notes", "α = ω̇\nL = I ω\n");
    assert_eq!(source.line_column(0), (1, 1));
    assert_eq!(source.line_column("α = ".len() as u32), (1, 5));
    assert_eq!(source.line_column("α = ω̇\n".len() as u32), (2, 1));
    assert_eq!(source.lines(), 3);
}

#[test]
fn a_column_far_along_a_line_is_counted_in_characters() {
    let text = format!("the one\n{}", "αx ".repeat(2046));
    assert_eq!(text.len() % BLOCK, 0);
    let source = Source::new("notes", text.clone());
    for (offset, _) in text.char_indices().chain([(text.len(), ' ')]) {
        let (before, column) = source.line_column(offset as u32);
        let start = if before == 1 { 0 } else { 8 };
        assert_eq!(column, text[start..offset].chars().count() + 1, "{offset}");
    }
}

#[test]
fn a_span_outside_the_text_is_empty() {
    let source = Source::new("notes", "ω");
    assert_eq!(source.slice(Span::new(1, 2)), "");
    assert_eq!(source.slice(Span::new(5, 9)), "");
}
