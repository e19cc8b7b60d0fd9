//! Macros that a document defines for itself: `\newcommand`, `\def`, `\DeclareMathOperator`.

mod definition;
mod reach;

use crate::notation::token::{beginning, matching_brace};
use crate::notation::triads::Triads;
use crate::source::Span;
use definition::{braces, definition_end, is_whole};
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};

/// The macros in force, and the decimal sign beside them.
#[derive(Clone, Debug, Default)]
pub struct Macros {
    defined: BTreeMap<String, Macro>,
    /// How many bytes all expansions of the document together may still have.
    left: Cell<usize>,
    /// Macros that were seen to expand without end: they are not tried in every formula again.
    endless: RefCell<BTreeSet<String>>,
    /// Whether `2,5` is a number.
    pub(crate) decimal_comma: bool,
    /// The vectors of which a plain text writes the components as words.
    pub(crate) triads: Triads,
}

#[derive(Clone, Debug)]
struct Macro {
    arguments: usize,
    default: Option<String>,
    body: String,
}

/// No definition is longer, and no document has more of them.
const LONGEST_DEFINITION: usize = 4096;
const MOST_DEFINITIONS: usize = 1000;

/// What the expansions of a document may have together, however short it is.
const SHORTEST_DOCUMENT: usize = 500_000;

/// Expansion stops at this length: a macro that doubles itself must not fill the memory.
const LONGEST: usize = 100_000;

/// A formula may have so many bytes of expansions, and so many more for each of its own: what a few bytes unfold to
/// without being longer than any line is a bomb.
const SHORTEST_FORMULA: usize = 5_000;
const MOST_PER_BYTE: usize = 50;

impl Macros {
    /// Collects the definitions that stand in a text.
    pub fn collect(text: &str) -> Self {
        let mut macros = Self {
            defined: BTreeMap::new(),
            left: Cell::new(SHORTEST_DOCUMENT + 2 * text.len()),
            endless: RefCell::default(),
            decimal_comma: false,
            triads: Triads::default(),
        };
        let mut at = 0;
        let mut tried = 0;
        while let Some(i) = text[at..].find('\\') {
            at += i + 1;
            let rest = beginning(&text[at..], LONGEST_DEFINITION);
            let length = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
            let (name, rest) = rest.split_at(length);
            let defined = match name {
                "newcommand" | "renewcommand" | "providecommand" => command(rest),
                "NewDocumentCommand" | "RenewDocumentCommand" | "DeclareDocumentCommand" => {
                    document_command(rest)
                }
                "DeclareMathOperator" => operator(rest),
                "def" | "gdef" => def(rest),
                "let" => alias(rest),
                _ => None,
            };
            tried += usize::from(
                name.to_lowercase().contains("command") || matches!(name, "def" | "gdef"),
            );
            if tried > MOST_DEFINITIONS {
                break;
            }
            if let Some((name, found)) = defined {
                macros.defined.insert(name, found);
            }
            at += length.max(
                rest.chars()
                    .next()
                    .filter(|_| length == 0)
                    .map_or(0, char::len_utf8),
            );
        }
        macros
    }

    /// The same macros in a document that may part decimals by a comma.
    pub(crate) fn with_decimal_comma(self, decimal_comma: bool) -> Self {
        Self {
            decimal_comma,
            ..self
        }
    }

    /// The same macros with commands of one argument beside them, or of none where what they stand for has none.
    pub(crate) fn with_marks(mut self, marks: &[(String, String)]) -> Self {
        for (command, body) in marks {
            let mark = Macro {
                arguments: usize::from(body.contains("#1")),
                default: None,
                body: body.clone(),
            };
            self.defined.entry(command.clone()).or_insert(mark);
        }
        self
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.defined.is_empty()
    }

    /// Lets the expansions to come have at least so many bytes together.
    pub(crate) fn allow(&self, bytes: usize) {
        self.left.set(self.left.get().max(bytes));
    }

    /// The text with all macros expanded, and for each byte of it what it came from: a byte of the text, or the call of
    /// a macro. `None` if the expansion has no end.
    pub(crate) fn expand(&self, text: &str) -> Option<(String, Vec<Span>)> {
        let mut out = String::with_capacity(text.len());
        let mut origin = Vec::with_capacity(text.len());
        let fair = SHORTEST_FORMULA + MOST_PER_BYTE * text.len();
        let allowed = LONGEST.min(fair).min(self.left.get());
        let mut budget = allowed;
        let done = self.expand_into(text, None, 0, &mut out, &mut origin, &mut budget);
        self.left.set(self.left.get() - (allowed - budget));
        done.map(|()| (out, origin))
    }

    fn expand_into(
        &self,
        text: &str,
        call: Option<Span>,
        depth: usize,
        out: &mut String,
        origin: &mut Vec<Span>,
        budget: &mut usize,
    ) -> Option<()> {
        if depth > 20 {
            return None;
        }
        let braces = braces(text);
        let mut at = 0;
        while at < text.len() {
            let rest = &text[at..];
            if self.endless.borrow().contains(name(rest)) {
                return None;
            }
            if let Some((after, expansion)) = self.call(text, at, &braces) {
                *budget = budget.checked_sub(expansion.len() + 1)?;
                let call = call.unwrap_or(Span::new(at, after));
                let done = self.expand_into(&expansion, Some(call), depth + 1, out, origin, budget);
                if done.is_none() && depth == 0 {
                    self.endless.borrow_mut().insert(name(rest).to_owned());
                }
                done?;
                at = after;
                continue;
            }
            // A definition states nothing, and what stands in it is no call.
            if depth == 0
                && let Some(after) = definition_end(text, at, &braces)
            {
                out.push(' ');
                origin.push(Span::new(at, after));
                at = after;
                continue;
            }
            let command = rest.strip_prefix('\\').map_or(0, |r| {
                1 + r.bytes().take_while(u8::is_ascii_alphabetic).count()
            });
            let step = if command > 1 {
                command
            } else {
                rest.chars().next().map_or(1, char::len_utf8)
            };
            out.push_str(&rest[..step]);
            origin.extend((at..at + step).map(|k| call.unwrap_or(Span::new(k, k + 1))));
            at += step;
        }
        Some(())
    }

    /// A macro called at an offset: where the call ends, and what it stands for.
    fn call(&self, text: &str, at: usize, braces: &[usize]) -> Option<(usize, String)> {
        let is_script = text[..at].trim_end().ends_with(['^', '_']);
        let rest = text[at..].strip_prefix('\\')?;
        let length = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
        let found = self.defined.get(rest.get(..length)?)?;
        let mut at = at + 1 + length;
        let mut arguments: Vec<&str> = vec![];
        if let Some(default) = &found.default {
            arguments.push(match optional(beginning(&text[at..], LONGEST_DEFINITION)) {
                Some((given, _)) => {
                    at += text[at..].find(']').map_or(0, |i| i + 1);
                    given
                }
                None => default,
            });
        }
        while arguments.len() < found.arguments {
            at += text[at..].len() - text[at..].trim_start().len();
            let argument = match braces.get(at) {
                Some(&close) if text[at..].starts_with('{') => {
                    let closed = (close < text.len()).then_some(close)?;
                    text.get(at + 1..closed)?
                }
                _ => argument(beginning(&text[at..], LONGEST_DEFINITION))?.0,
            };
            at += argument.len() + if text[at..].starts_with('{') { 2 } else { 0 };
            arguments.push(argument);
        }
        let body = found.filled(&arguments);
        if body.len() > LONGEST {
            return Some((at, "\\undefined".into()));
        }
        // A name must not run into the letter that follows it; an exponent must reach what stands before it, a
        // derivative what stands behind it, and half a bracket its other half.
        let reaches_out = body.trim_start().starts_with(['^', '_'])
            || !is_script && self.begins_fraction(&body)
            || self.ends_asking(&body)
            || !is_whole(&body);
        let closed = if reaches_out {
            format!("{body} ")
        } else if arguments.is_empty() {
            format!("{{{body}}}")
        } else {
            body
        };
        Some((at, closed))
    }
}

impl Macro {
    /// The body with the arguments in their places.
    fn filled(&self, arguments: &[&str]) -> String {
        let mut out = String::with_capacity(self.body.len());
        let mut rest = self.body.as_str();
        while let Some(i) = rest.find('#') {
            out.push_str(&rest[..i]);
            rest = &rest[i + 1..];
            let digit = rest.chars().next().and_then(|c| c.to_digit(10));
            let argument = digit.and_then(|n| arguments.get((n as usize).wrapping_sub(1)));
            match argument {
                Some(argument) => {
                    out.push_str(argument);
                    rest = &rest[1..];
                }
                None => out.push('#'),
            }
            if out.len() > LONGEST {
                break;
            }
        }
        out.push_str(rest);
        out
    }
}

/// The name of the command that a text begins with; the empty string where none does.
fn name(text: &str) -> &str {
    let Some(rest) = text.strip_prefix('\\') else {
        return "";
    };
    &rest[..rest.bytes().take_while(u8::is_ascii_alphabetic).count()]
}

fn argument(text: &str) -> Option<(&str, &str)> {
    let text = text.trim_start();
    if let Some(inner) = text.strip_prefix('{') {
        let end = matching_brace(inner)?;
        return Some((&inner[..end], &inner[end + 1..]));
    }
    let length = match text.strip_prefix('\\') {
        Some(rest) => {
            1 + rest
                .bytes()
                .take_while(u8::is_ascii_alphabetic)
                .count()
                .max(1)
        }
        None => text.chars().next()?.len_utf8(),
    };
    Some((text.get(..length)?, text.get(length..)?))
}

fn optional(text: &str) -> Option<(&str, &str)> {
    let inner = text.trim_start().strip_prefix('[')?;
    let end = inner.find(']')?;
    Some((&inner[..end], &inner[end + 1..]))
}

fn defined_name(text: &str) -> Option<(String, &str)> {
    let (name, rest) = argument(text.trim_start().trim_start_matches('*'))?;
    let name = name.trim().strip_prefix('\\')?;
    (!name.is_empty() && name.bytes().all(|b| b.is_ascii_alphabetic()))
        .then(|| (name.to_owned(), rest))
}

fn command(text: &str) -> Option<(String, Macro)> {
    let (name, mut rest) = defined_name(text)?;
    let mut arguments = 0;
    let mut default = None;
    if let Some((count, after)) = optional(rest) {
        arguments = count.trim().parse().ok().filter(|n| *n <= 9)?;
        rest = after;
        if let Some((given, after)) = optional(rest) {
            default = Some(given.to_owned());
            rest = after;
        }
    }
    let (body, _) = argument(rest)?;
    Some((
        name,
        Macro {
            arguments,
            default,
            body: body.to_owned(),
        },
    ))
}

/// `\NewDocumentCommand{\pd}{O{t} m}{…}`: arguments that must stand, the first of them optional at most.
fn document_command(text: &str) -> Option<(String, Macro)> {
    let (name, rest) = defined_name(text)?;
    let (kinds, rest) = argument(rest)?;
    let kinds = kinds.trim();
    let (default, needed) = match kinds.strip_prefix('O').map(argument) {
        Some(default) => {
            let (default, needed) = default?;
            (Some(default.to_owned()), needed)
        }
        None => (None, kinds),
    };
    let needed: Vec<char> = needed.chars().filter(|c| !c.is_whitespace()).collect();
    let arguments = needed.len() + usize::from(default.is_some());
    let (body, _) = argument(rest)?;
    let plain = needed.iter().all(|kind| *kind == 'm') && arguments <= 9;
    plain.then(|| {
        let body = body.to_owned();
        (
            name,
            Macro {
                arguments,
                default,
                body,
            },
        )
    })
}

fn operator(text: &str) -> Option<(String, Macro)> {
    let (name, rest) = defined_name(text)?;
    let (body, _) = argument(rest)?;
    Some((
        name,
        Macro {
            arguments: 0,
            default: None,
            body: format!("\\operatorname{{{body}}}"),
        },
    ))
}

/// `\let\eps=\epsilon`.
fn alias(text: &str) -> Option<(String, Macro)> {
    let (name, rest) = defined_name(text)?;
    let rest = rest.trim_start().trim_start_matches('=').trim_start();
    let (body, _) = argument(rest).filter(|(body, _)| body.starts_with('\\'))?;
    let body = body.to_owned();
    Some((
        name,
        Macro {
            arguments: 0,
            default: None,
            body,
        },
    ))
}

fn def(text: &str) -> Option<(String, Macro)> {
    let (name, rest) = defined_name(text)?;
    let brace = rest.find('{')?;
    let arguments = rest[..brace].matches('#').count();
    let (body, _) = argument(&rest[brace..])?;
    (arguments <= 9).then(|| {
        (
            name,
            Macro {
                arguments,
                default: None,
                body: body.to_owned(),
            },
        )
    })
}
