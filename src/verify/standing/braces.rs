//! What a brace says: `\underbrace{a}_{b}` says that a is b, wherever b is a formula and no remark.

use crate::notation::ast::{Kind, Line, Node, Relation};
use crate::notation::document::Row;
use crate::notation::reread;
use crate::source::Source as Text;
use crate::verify::standing::chains::Link;
use crate::verify::standing::hold::Held;
use crate::verify::standing::judge::Judge;
use crate::verify::standing::verdicts::Standing;
use std::borrow::Cow;

/// The commands, and the script that stands behind their argument.
const BRACES: [(&str, char); 2] = [("\\underbrace", '_'), ("\\overbrace", '^')];

/// Commands of words.
const WORDS: [&str; 4] = ["\\text", "\\mbox", "\\mathrm", "\\rm"];

impl Judge<'_> {
    /// What the braces on a line came to that do not hold. A brace with letters of which nothing is told names a part.
    pub(super) fn failing_braces(&mut self, line: &Line) -> Vec<Held> {
        let document = self.document;
        if self.reading.letters.customs.braces_name_at(&self.at) {
            return vec![];
        }
        let texts = relations_of_braces(document.source.slice(line.span));
        let mut failing = vec![];
        for text in texts {
            let rows = reread(document, &text);
            let [Row::Line(brace)] = rows.as_slice() else {
                continue;
            };
            let ([left, right], [(Relation::Equal, _)]) = (&brace.sides[..], &brace.relations[..])
            else {
                continue;
            };
            if [left, right].into_iter().any(has_error) || !brace.remarks.is_empty() {
                continue;
            }
            let link = Link {
                left: Cow::Borrowed(left),
                relation: Relation::Equal,
                right: Cow::Borrowed(right),
            };
            let before = self.written.trial.replace(Text::new("", text.clone()));
            let held = self.hold(&link);
            self.written.trial = before;
            let known = held.unknown.is_empty() && !held.sides.is_empty();
            if known && matches!(held.standing, Standing::Denied | Standing::Open) {
                failing.push(held);
            }
        }
        failing
    }
}

/// The relations that the braces of a text say, one within another too.
fn relations_of_braces(text: &str) -> Vec<String> {
    let mut found = vec![];
    if !text.contains("brace") {
        return found;
    }
    for (command, script) in BRACES {
        for (at, _) in text.match_indices(command) {
            let Some((part, rest)) = argument(&text[at + command.len()..]) else {
                continue;
            };
            let name = rest.trim_start().strip_prefix(script).and_then(argument);
            let Some((name, _)) = name else { continue };
            let is_number = name.trim().chars().all(|c| c.is_ascii_digit());
            if is_number || WORDS.iter().any(|word| name.contains(word)) {
                continue;
            }
            found.push(match name.trim_start().starts_with('=') {
                true => format!("{part} {name}"),
                false => format!("{part} = {name}"),
            });
        }
    }
    found
}

/// The group in braces that a text begins with, and what stands behind it.
fn argument(text: &str) -> Option<(&str, &str)> {
    let inner = text.trim_start().strip_prefix('{')?;
    let (mut depth, mut escaped) = (1, false);
    for (at, c) in inner.char_indices() {
        depth += match c {
            '{' if !escaped => 1,
            '}' if !escaped => -1,
            _ => 0,
        };
        if depth == 0 {
            return Some((&inner[..at], &inner[at + 1..]));
        }
        escaped = c == '\\' && !escaped;
    }
    None
}

fn has_error(node: &Node) -> bool {
    matches!(node.kind, Kind::Error(_)) || node.children().any(has_error)
}
