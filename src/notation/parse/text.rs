//! Words in formulas: labels, remarks, units, and the plain text of a script.

use super::Parser;
use crate::notation::ast::{Kind, Node};
use crate::notation::token::{Lexeme, Token};

/// The tokens as plain text: commands and braces taken off, spaces left out.
pub(super) fn plain(tokens: &[Token<'_>]) -> String {
    let mut out = String::with_capacity(tokens.len());
    let mut over = None;
    for token in tokens {
        match token.kind {
            Lexeme::Letter(c) | Lexeme::Char(c) => {
                out.push(c);
                out.extend(over.take());
            }
            // The centroidal axes x̄ and the axes x are not the same.
            Lexeme::Command("bar" | "overline") => over = Some('\u{304}'),
            Lexeme::Command("tilde" | "widetilde") => over = Some('\u{303}'),
            // A dot in a label is none of the letter's.
            Lexeme::Command("dot") => over = Some('\u{307}'),
            Lexeme::Number(text) => out.push_str(text),
            Lexeme::Text(text) => {
                let lead = text.starts_with(' ') && !out.is_empty();
                out.push_str(if lead { " " } else { "" });
                out.push_str(text.trim());
                out.push_str(if text.ends_with(' ') { " " } else { "" });
            }
            Lexeme::Command("prime") => out.push('\''),
            Lexeme::Command("times") => out.push('×'),
            Lexeme::Command(name) if !super::letter::takes_argument(name) => {
                out.push_str(super::letter::greek(name).unwrap_or(name));
            }
            _ => {}
        }
    }
    let trimmed = out.trim();
    match trimmed.len() == out.len() {
        true => out,
        false => trimmed.to_owned(),
    }
}

/// What a piece of text in a formula is.
#[derive(Debug, PartialEq)]
pub(super) enum Words {
    Label(String),
    Remark(String),
}

/// `--- (3)`, `(8.6)`, `(iv)` are labels; all else is a remark.
pub(super) fn words(text: &str) -> Words {
    let flat = text
        .replace("\\textcircled", "")
        .replace(['{', '}', '$'], "");
    let flat = flat.trim().trim_end_matches(['.', ',']);
    let dashed = flat.trim_start_matches(['-', '–', '—', '.', '…', ' ']);
    let bracketed = dashed
        .strip_prefix('(')
        .or_else(|| dashed.strip_prefix('['))
        .and_then(|rest| rest.strip_suffix([')', ']']));
    match bracketed {
        Some(inner) if is_label(inner) => Words::Label(format!("({})", inner.trim())),
        None if dashed.len() < flat.len() && is_label(dashed) => {
            Words::Label(format!("({dashed})"))
        }
        _ => Words::Remark(text.trim().to_owned()),
    }
}

pub(super) fn is_label(text: &str) -> bool {
    let text = text
        .trim()
        .trim_start_matches("eq. ")
        .trim_start_matches("Eq. ");
    let number = text.starts_with(|c: char| c.is_ascii_digit())
        || matches!(
            text.as_bytes(),
            [b'A'..=b'Z', b'.' | b'0'..=b'9' | b'-', ..]
        )
        || (!text.is_empty()
            && text
                .bytes()
                .all(|b| matches!(b, b'i' | b'v' | b'x' | b'I' | b'V' | b'X')))
        || matches!(text.as_bytes(), [b'a'..=b'z'])
        || (!text.is_empty() && text.bytes().all(|b| matches!(b, b'*')));
    number
        && text.len() <= 12
        && text
            .bytes()
            .all(|b| b.is_ascii_alphanumeric() || matches!(b, b'.' | b'-' | b'*' | b'\'' | b':'))
}

/// `eq:name`, by which texts refer to a formula: a word, a colon and a name.
pub(super) fn is_named_label(text: &str) -> bool {
    let kinds = ["eq", "eqn", "equation", "eqs"];
    let name = |b: u8| b.is_ascii_alphanumeric() || matches!(b, b'.' | b'-' | b'_' | b':');
    text.trim().split_once(':').is_some_and(|(kind, named)| {
        kinds.contains(&kind) && named.len() > 1 && named.bytes().all(name)
    })
}

/// Words that stand between two relations.
pub(super) fn joins(text: &str) -> bool {
    let word = text
        .trim()
        .trim_matches([',', ';', '.'])
        .to_ascii_lowercase();
    matches!(
        word.as_str(),
        "and"
            | "or"
            | "so"
            | "hence"
            | "then"
            | "thus"
            | "but"
            | "therefore"
            | "where"
            | "with"
            | "so that"
            | "which gives"
            | "gives"
            | "i.e."
            | "that is"
            | "because"
            | "since"
            | "while"
            | "also"
            | "for"
            | "for all"
            | "for each"
            | "if"
            | "when"
            | "only if"
            | "if and only if"
            | "provided"
            | "provided that"
            | "given"
            | "given that"
            | "implies"
            | "yields"
            | "hence also"
            | "and hence"
            | "and thus"
            | "and so"
            | "and also"
            | "where also"
            | "as"
    )
}

/// Text that is one symbol, as in `\text{Iyy}` or `\text{KE}`, and no word of a sentence.
pub(super) fn is_symbol(text: &str) -> bool {
    let text = text.trim();
    let name = !text.is_empty() && text.len() <= 8 && text.chars().all(char::is_alphanumeric);
    let capitals = text
        .chars()
        .skip(1)
        .any(|c| c.is_uppercase() || c.is_numeric());
    let known = crate::notation::plain_words::word(text).is_some();
    name && !joins(text) && (text.chars().count() <= 2 || capitals || known)
}

const UNITS: &[&str] = &[
    "kg", "m", "s", "N", "rad", "J", "W", "Hz", "g", "cm", "mm", "km", "min", "rpm", "deg", "h",
    "ms", "Nm", "kN", "kJ", "lb", "ft", "slug", "rev", "Pa", "in",
];

/// Whether a text says that the left side keeps its value: `\text{const}`.
pub(super) fn is_constant(text: &str) -> bool {
    matches!(
        text.trim()
            .trim_end_matches('.')
            .to_ascii_lowercase()
            .as_str(),
        "const" | "constant" | "konst"
    )
}

/// Whether a text is a unit of measurement: `kg m^2`, `rad/s`.
pub(crate) fn is_unit(text: &str) -> bool {
    let mut pieces = text
        .split(|c: char| !c.is_ascii_alphabetic())
        .filter(|p| !p.is_empty())
        .peekable();
    pieces.peek().is_some() && pieces.all(|piece| UNITS.contains(&piece))
}

impl Parser<'_, '_> {
    /// A unit behind a number.
    pub(super) fn unit(&mut self, node: Node, start: usize) -> Node {
        let before = self.at;
        self.skip_spaces();
        let text = match self.peek() {
            Some(Lexeme::Text(text)) if is_unit(text) => {
                self.at += 1;
                let mut text = text.trim().to_owned();
                while let Some(more) = self.more_unit() {
                    text.push_str(&more);
                }
                text
            }
            Some(Lexeme::Command("mathrm" | "rm" | "si" | "unit")) => {
                self.at += 1;
                let mut text = unit_text(self.argument());
                if !is_unit(&text) {
                    self.at = before;
                    return node;
                }
                while let Some(more) = self.more_unit() {
                    text.push_str(&more);
                }
                text
            }
            _ => {
                self.at = before;
                return node;
            }
        };
        self.node(Kind::WithUnit(Box::new(node), text), start)
    }

    /// `\mathrm{kg}\,\mathrm{m}^2`: the pieces after the first.
    fn more_unit(&mut self) -> Option<String> {
        let before = self.at;
        let mut probe = self.clone();
        if probe.take(Lexeme::Superscript) {
            let text = plain(probe.argument());
            self.at = probe.at;
            return Some(format!("^{text}"));
        }
        probe.skip_spaces();
        let slash = probe.take(Lexeme::Char('/'));
        if !slash {
            probe.take(Lexeme::Command("cdot"));
        }
        let text = match probe.peek()? {
            Lexeme::Command("mathrm" | "rm") => {
                probe.at += 1;
                unit_text(probe.argument())
            }
            Lexeme::Text(text) => {
                probe.at += 1;
                text.to_owned()
            }
            _ => return None,
        };
        let sign = if slash { "/" } else { " " };
        (is_unit(&text) && probe.at > before).then(|| {
            self.at = probe.at;
            format!("{sign}{text}")
        })
    }
}

pub(super) fn unit_text(tokens: &[Token<'_>]) -> String {
    let mut out = String::new();
    for token in tokens {
        match token.kind {
            Lexeme::Letter(c) | Lexeme::Char(c) => {
                if token.spaced && !out.is_empty() {
                    out.push(' ');
                }
                out.push(c);
            }
            Lexeme::Number(text) | Lexeme::Text(text) => out.push_str(text),
            Lexeme::Superscript => out.push('^'),
            Lexeme::Space(_) | Lexeme::Command("cdot") => out.push(' '),
            _ => {}
        }
    }
    out
}

/// A tag as it is shown: `(5)`.
pub(super) fn tag(text: &str) -> String {
    let text = text.trim().trim_matches('$');
    if text.starts_with('(') {
        text.to_owned()
    } else {
        format!("({text})")
    }
}
