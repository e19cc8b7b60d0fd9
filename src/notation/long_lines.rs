//! Lines that no person writes: they are told and not read, so that a file of one line ends at once.

use super::document::Format;
use crate::diagnostic::Diagnostic;
use crate::source::Span;
use std::borrow::Cow;

/// A line of more bytes than this is not read; a paragraph in one line has a few thousand.
const LONGEST_LINE: usize = 100_000;

/// The text with blanks in the place of its longest lines, each told if formulas may stand in it.
///
/// What stands behind keeps its place. A picture that stands in a line of Markdown holds no formula.
pub(super) fn blanked<'a>(
    text: &'a str,
    format: Format,
    troubles: &mut Vec<Diagnostic>,
) -> Cow<'a, str> {
    if text.len() <= LONGEST_LINE {
        return Cow::Borrowed(text);
    }
    let mut kept = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        let inside = line.trim_end_matches(['\r', '\n']);
        if inside.len() <= LONGEST_LINE {
            kept.push_str(line);
            continue;
        }
        if format == Format::Text || inside.contains(['$', '\\', '`']) {
            let span = Span::new(kept.len(), kept.len() + inside.len());
            let message = "a line that is too long to be read";
            let help = "break it into lines";
            troubles.push(Diagnostic::error("unreadable", span, message).help(help));
        }
        kept.extend(std::iter::repeat_n(' ', inside.len()));
        kept.push_str(&line[inside.len()..]);
    }
    Cow::Owned(kept)
}
