//! Macros that a document defines for itself: `\newcommand`, `\def`, `\DeclareMathOperator`.

use crate::notation::token::matching_brace;
use std::collections::BTreeMap;

/// The macros in force.
#[derive(Clone, Debug, Default)]
pub struct Macros {
    defined: BTreeMap<String, Macro>,
}

#[derive(Clone, Debug)]
struct Macro {
    arguments: usize,
    default: Option<String>,
    body: String,
}

/// Expansion stops at this length: a macro that doubles itself must not fill the memory.
const LONGEST: usize = 100_000;

impl Macros {
    /// Collects the definitions that stand in a text.
    pub fn collect(text: &str) -> Self {
        let mut macros = Self::default();
        let mut at = 0;
        while let Some(i) = text[at..].find('\\') {
            at += i + 1;
            let rest = &text[at..];
            let length = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
            let (name, rest) = rest.split_at(length);
            let defined = match name {
                "newcommand" | "renewcommand" | "providecommand" | "NewDocumentCommand" => {
                    command(rest)
                }
                "DeclareMathOperator" => operator(rest),
                "def" | "gdef" => def(rest),
                "let" => alias(rest),
                _ => None,
            };
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

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.defined.is_empty()
    }

    /// The text with all macros expanded, and for each byte of it the byte of the text that it came from. `None` if the
    /// expansion has no end.
    pub(crate) fn expand(&self, text: &str) -> Option<(String, Vec<u32>)> {
        let mut out = String::with_capacity(text.len());
        let mut origin = Vec::with_capacity(text.len());
        let mut budget = LONGEST;
        self.expand_into(text, None, 0, &mut out, &mut origin, &mut budget)?;
        Some((out, origin))
    }

    fn expand_into(
        &self,
        text: &str,
        place: Option<u32>,
        depth: usize,
        out: &mut String,
        origin: &mut Vec<u32>,
        budget: &mut usize,
    ) -> Option<()> {
        if depth > 20 {
            return None;
        }
        let mut at = 0;
        while at < text.len() {
            let rest = &text[at..];
            let here = place.unwrap_or(u32::try_from(at).unwrap_or(u32::MAX));
            if let Some((used, expansion)) = self.call(rest) {
                *budget = budget.checked_sub(expansion.len() + 1)?;
                self.expand_into(&expansion, Some(here), depth + 1, out, origin, budget)?;
                at += used;
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
            for k in 0..step {
                let k = u32::try_from(k).unwrap_or(0);
                origin.push(if place.is_some() { here } else { here + k });
            }
            at += step;
        }
        Some(())
    }

    /// A macro called at the start of a text: how many bytes the call takes, and what it stands for.
    fn call(&self, text: &str) -> Option<(usize, String)> {
        let rest = text.strip_prefix('\\')?;
        let length = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
        let found = self.defined.get(rest.get(..length)?)?;
        let mut rest = &rest[length..];
        let mut arguments: Vec<String> = vec![];
        if let Some(default) = &found.default {
            arguments.push(match optional(rest) {
                Some((given, after)) => {
                    rest = after;
                    given.to_owned()
                }
                None => default.clone(),
            });
        }
        while arguments.len() < found.arguments {
            let (argument, after) = argument(rest)?;
            arguments.push(argument.to_owned());
            rest = after;
        }
        let mut body = found.body.clone();
        for (i, argument) in arguments.iter().enumerate() {
            body = body.replace(&format!("#{}", i + 1), argument);
            if body.len() > LONGEST {
                return Some((text.len() - rest.len(), "\\undefined".into()));
            }
        }
        // A name must not run into the letter that follows it.
        let closed = if arguments.is_empty() {
            format!("{{{body}}}")
        } else {
            body
        };
        Some((text.len() - rest.len(), closed))
    }
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

fn name(text: &str) -> Option<(String, &str)> {
    let (name, rest) = argument(text.trim_start().trim_start_matches('*'))?;
    let name = name.trim().strip_prefix('\\')?;
    (!name.is_empty() && name.bytes().all(|b| b.is_ascii_alphabetic()))
        .then(|| (name.to_owned(), rest))
}

fn command(text: &str) -> Option<(String, Macro)> {
    let (name, mut rest) = name(text)?;
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

fn operator(text: &str) -> Option<(String, Macro)> {
    let (name, rest) = name(text)?;
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
    let (name, rest) = name(text)?;
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
    let (name, rest) = name(text)?;
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
