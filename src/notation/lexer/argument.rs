//! What stands behind a command and belongs to it: a star, braces, a length.

use super::Lexer;
use crate::notation::token::{Lexeme, beginning, matching_brace};

impl<'a> Lexer<'a> {
    /// The star of `\tag*`.
    pub(super) fn starred(&mut self) {
        if self.rest().starts_with('*') {
            self.at += 1;
        }
    }

    /// What stands in the braces that follow; the empty string where none do.
    pub(super) fn braced(&mut self) -> &'a str {
        let rest = self.rest().trim_start();
        let Some(inner) = rest.strip_prefix('{') else {
            return "";
        };
        let length = matching_brace(inner).unwrap_or(inner.len());
        self.at = (self.text.len() - inner.len() + length + 1).min(self.text.len());
        &inner[..length]
    }

    /// Whether a relation stands in the braces that follow: what marks it as a whole marks no letter.
    pub(super) fn holds_relation(&self) -> bool {
        let inner = self.rest().trim_start().strip_prefix('{');
        inner.is_some_and(|inner| {
            let length = matching_brace(inner).unwrap_or(inner.len());
            inner[..length].contains('=') || inner[..length].contains("\\begin")
        })
    }

    /// `[b]`, which says how tall something is made.
    pub(super) fn option(&mut self) {
        let rest = self.rest();
        if let Some(end) = rest
            .strip_prefix('[')
            .and_then(|r| beginning(r, 40).find(']'))
        {
            self.at += end + 2;
        }
    }

    /// `{1em}` of a `\hspace`.
    pub(super) fn hspace(&mut self, start: usize) {
        self.starred();
        let length = self.braced().trim();
        let number = length.trim_end_matches(|c: char| c.is_ascii_alphabetic());
        let unit = match length[number.len()..].trim() {
            "em" => 18.0,
            "cm" => 51.0,
            "mm" => 5.1,
            "in" => 130.0,
            "ex" => 7.7,
            _ => 1.8,
        };
        let width = number.trim().parse::<f32>().unwrap_or(3.0) * unit;
        // A cast from a float stops at the ends of the range.
        self.push(Lexeme::Space(width.max(0.0) as u8), start);
    }

    /// A length without braces: `\mkern-3mu`, `\hskip 1em`.
    pub(super) fn dimension(&mut self) {
        let rest = beginning(self.rest(), 24).trim_start();
        let part = |c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.');
        let unit = rest.trim_start_matches(part).trim_start();
        let units = ["mu", "em", "ex", "pt", "cm", "mm", "in", "sp"];
        if let Some(unit) = units.iter().find_map(|u| unit.strip_prefix(u)) {
            self.at += beginning(self.rest(), 24).len() - unit.len();
        }
    }
}
