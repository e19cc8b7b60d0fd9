//! Formulas in the two styles in which a derivation is printed.

use crate::notation::ast::Node;
use crate::notation::document::Row;
use crate::notation::{Macros, print, read_formula};
use crate::verify::model::atoms;

/// A formula in LaTeX and in plain text; both are read as the same.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Text {
    /// Without dollar signs.
    pub latex: String,
    /// With Unicode signs.
    pub unicode: String,
}

/// Commands that only make a letter that of a vector.
const VECTORS: [&str; 6] = [
    "\\vec",
    "\\mathbf",
    "\\boldsymbol",
    "\\bm",
    "\\overrightarrow",
    "\\underline",
];

/// Marks of one dot and two.
const DOTS: [char; 2] = ['\u{307}', '\u{308}'];

impl Text {
    /// A formula without a relation, or a line.
    pub fn of(latex: &str) -> Self {
        let unicode = match read_formula(latex, 0, &Macros::default())
            .into_iter()
            .next()
        {
            Some(Row::Expression(node)) => print::unicode(&node),
            Some(Row::Line(line)) => print::unicode_line(&line).trim_end().to_owned(),
            _ => latex.to_owned(),
        };
        Self {
            latex: latex.to_owned(),
            unicode: without_braces(&unicode),
        }
    }

    /// A letter as an author writes it.
    pub(super) fn of_letter(latex: &str) -> Self {
        let unicode = node(latex).map_or_else(|| latex.to_owned(), |node| print::unicode(&node));
        Self {
            latex: latex.to_owned(),
            unicode: without_braces(&unicode),
        }
    }

    /// The component of a letter on an axis with a label: the x of `\vec{L}` is `L_x`.
    pub(super) fn of_component(latex: &str, label: &str) -> Self {
        let plain = without_vector(latex);
        let text = match plain.rsplit_once('_') {
            Some((letter, index)) if !index.contains(['{', '}', ' ']) => {
                format!("{letter}_{{{index},{label}}}")
            }
            Some((letter, index)) if index.starts_with('{') && index.ends_with('}') => {
                format!("{letter}_{{{},{label}}}", &index[1..index.len() - 1])
            }
            _ if label.chars().count() > 1 => format!("{plain}_{{{label}}}"),
            _ => format!("{plain}_{label}"),
        };
        Self::of_letter(&text)
    }

    /// The rate of a letter.
    pub(super) fn dotted(&self, order: usize) -> Option<Self> {
        let latex = atoms::dotted(order, &self.latex)?;
        let mark = DOTS.get(order.checked_sub(1)?);
        let drawn = !self.unicode.starts_with('\\') && !self.unicode.contains(' ');
        let unicode = match mark.filter(|_| drawn) {
            Some(mark) => {
                let is_mark = |c: char| ('\u{300}'..'\u{370}').contains(&c) || c == '\u{20d7}';
                let mut letters = self.unicode.char_indices().skip(1);
                let end = letters.find(|(_, c)| !is_mark(*c));
                let (base, rest) = self
                    .unicode
                    .split_at(end.map_or(self.unicode.len(), |(at, _)| at));
                format!("{base}{mark}{rest}")
            }
            None => latex.clone(),
        };
        Some(Self { latex, unicode })
    }
}

/// The tree of a letter.
pub(super) fn node(latex: &str) -> Option<Node> {
    match read_formula(latex, 0, &Macros::default())
        .into_iter()
        .next()
    {
        Some(Row::Expression(node)) => Some(node),
        _ => None,
    }
}

/// A letter without what makes it that of a vector: `\vec{L}_G` is `L_G`.
fn without_vector(latex: &str) -> String {
    for command in VECTORS {
        let Some(rest) = latex.strip_prefix(command) else {
            continue;
        };
        if let Some(inner) = rest.strip_prefix('{')
            && let Some(end) = inner.find('}')
        {
            return format!("{}{}", &inner[..end], &inner[end + 1..]);
        }
        if rest.starts_with([' ', '\\']) {
            return rest.trim_start().to_owned();
        }
    }
    latex.to_owned()
}

/// Braces around one character of an index, or around two letters, say nothing.
fn without_braces(unicode: &str) -> String {
    let mut text = String::new();
    let mut rest = unicode;
    while let Some(at) = rest.find("_{") {
        text.push_str(&rest[..=at]);
        let inner = &rest[at + 2..];
        let index = inner.split('}').next().unwrap_or_default();
        let letters = index.chars().all(char::is_alphabetic);
        let plain = match index.chars().count() {
            1 => index != "{",
            2 => letters,
            _ => false,
        };
        match inner.strip_prefix(index).and_then(|r| r.strip_prefix('}')) {
            Some(behind) if plain => {
                text.push_str(index);
                rest = behind;
            }
            _ => {
                text.push('{');
                rest = inner;
            }
        }
    }
    text.push_str(rest);
    text
}
