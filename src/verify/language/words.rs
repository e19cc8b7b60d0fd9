//! A sentence as words, formulas and signs.

use super::joined_formulas::{joined, sign};
use super::statement::Misread;
use std::borrow::Cow;

/// A sentence with more words than this is not read: nobody writes one.
const MOST_TOKENS: usize = 400;

/// A piece of a sentence.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Token {
    /// What it is.
    pub(crate) kind: Kind,
    /// As written, without the marks of a formula or a heading.
    pub(crate) text: String,
    /// In lower case, for a word.
    pub(crate) lower: String,
    /// The column of its first character, from 1.
    pub(crate) column: usize,
}

/// What a piece of a sentence is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A word or a name.
    Word,
    /// `$…$`.
    Formula,
    /// `` `…` ``: a formula in plain text.
    Plain,
    /// Digits.
    Number,
    /// `"…"`.
    Quoted,
    /// `,`
    Comma,
    /// `;`
    Semicolon,
    /// `(`
    Open,
    /// `)`
    Close,
}

/// Parts a sentence. The stop at its end is left out.
pub(crate) fn tokens(sentence: &str, line: usize) -> Result<Vec<Token>, Misread> {
    let mut tokens = vec![];
    let mut rest = sentence;
    let mut column = 1;
    loop {
        let trimmed = rest.trim_start();
        column += rest[..rest.len() - trimmed.len()].chars().count();
        let Some(first) = trimmed.chars().next() else {
            return in_one_piece(with_letters(tokens), line);
        };
        if matches!(first, '.') && trimmed[1..].trim().is_empty() {
            return in_one_piece(with_letters(tokens), line);
        }
        if tokens.len() == MOST_TOKENS {
            return Err(wrong(
                line,
                column,
                "the sentence is too long",
                "say it in several",
            ));
        }
        // What stands behind a colon says more of what stands before it.
        if first == ':' && !tokens.is_empty() {
            tokens.push(Token {
                kind: Kind::Comma,
                text: ":".into(),
                lower: String::new(),
                column,
            });
            column += 1;
            rest = &trimmed[1..];
            continue;
        }
        let (kind, text, length) =
            token(trimmed, first).map_err(|(message, help)| wrong(line, column, message, help))?;
        let text = match kind {
            Kind::Word => unmarked(text),
            _ => Cow::Borrowed(text),
        };
        tokens.push(Token {
            kind,
            lower: match kind {
                Kind::Word => text.to_lowercase(),
                // A sign and a number may be spoken of as words.
                Kind::Formula | Kind::Plain if SIGNS.contains(&&*text) => text.to_string(),
                Kind::Formula if text.bytes().all(|b| b.is_ascii_digit()) => text.to_string(),
                Kind::Formula if sign(trimmed).is_some() => text.to_string(),
                _ => String::new(),
            },
            text: text.into_owned(),
            column,
        });
        column += trimmed[..length].chars().count();
        rest = &trimmed[length..];
    }
}

/// The pieces with formulas joined; a sign that is left alone is one of which a sentence may speak, or an error.
fn in_one_piece(tokens: Vec<Token>, line: usize) -> Result<Vec<Token>, Misread> {
    let tokens = joined(tokens);
    let alone = tokens.iter().find(|token| {
        let outside = token.kind == Kind::Formula && sign(&token.lower).is_some();
        outside && !SIGNS.contains(&token.lower.as_str())
    });
    match alone {
        Some(sign) => Err(wrong(line, sign.column, NO_MEANING.0, NO_MEANING.1)),
        None => Ok(tokens),
    }
}

/// What is wrong with a sign that joins no formulas, and what to do.
const NO_MEANING: (&str, &str) = (
    "this sign has no meaning in a sentence",
    "put a formula between dollar signs",
);

/// Signs of which sentences say how they are read.
const SIGNS: [&str; 11] = [
    "\\times",
    "\\pm",
    "−",
    "-",
    "∴",
    "\\therefore",
    "\\_",
    "_",
    "\\neq",
    "\\ne",
    "≠",
];

/// Words that stand behind a name, and behind no article.
const BEHIND_NAMES: [&str; 22] = [
    "about",
    "and",
    "are",
    "as",
    "at",
    "by",
    "coincides",
    "from",
    "has",
    "in",
    "is",
    "moves",
    "of",
    "on",
    "or",
    "relative",
    "rotates",
    "seen",
    "through",
    "to",
    "turns",
    "with",
];

/// "about a by the angle": where no noun follows, `a` is a letter and no article.
fn with_letters(mut tokens: Vec<Token>) -> Vec<Token> {
    for at in 0..tokens.len() {
        let alone = tokens.get(at + 1).is_none_or(|next| match next.kind {
            Kind::Word => BEHIND_NAMES.contains(&next.lower.as_str()),
            Kind::Comma | Kind::Semicolon | Kind::Close => true,
            _ => false,
        });
        if tokens[at].kind == Kind::Word && tokens[at].text == "a" && alone {
            tokens[at].kind = Kind::Plain;
            tokens[at].lower = String::new();
        }
    }
    tokens
}

/// The short name of a thing that is written between braces.
fn in_braces(text: &str) -> Option<&str> {
    let (name, _) = text.strip_prefix('{')?.split_once('}')?;
    let short = name.chars().count() <= LONGEST_NAME;
    (short && !name.is_empty() && name.chars().all(char::is_alphanumeric)).then_some(name)
}

/// A name between braces has no more letters.
const LONGEST_NAME: usize = 4;

/// The first piece of a text: what it is, its text and how many bytes it takes.
fn token(text: &str, first: char) -> Result<(Kind, &str, usize), (&'static str, &'static str)> {
    let single = |kind| Ok((kind, &text[..1], 1));
    match first {
        _ if SIGNS.contains(&alone(text)) => Ok((Kind::Formula, alone(text), alone(text).len())),
        ',' => single(Kind::Comma),
        '—' | '–' => Ok((Kind::Comma, &text[..first.len_utf8()], first.len_utf8())),
        ';' => single(Kind::Semicolon),
        '(' => single(Kind::Open),
        ')' => single(Kind::Close),
        '$' => enclosed(text, '$', Kind::Formula),
        '`' => enclosed(text, '`', Kind::Plain),
        // "{b}": a name in braces
        '{' if in_braces(text).is_some() => {
            let name = in_braces(text).unwrap_or_default();
            Ok((Kind::Word, name, name.len() + 2))
        }
        '"' => enclosed(text, '"', Kind::Quoted),
        '“' => enclosed(text, '”', Kind::Quoted),
        c if c.is_alphanumeric() || "*_'′".contains(c) => Ok(word(text)),
        '\\' if text.starts_with("\\(") => enclosed_by(text, "\\)"),
        '\\' => Ok((Kind::Formula, raw(text), raw(text).len())),
        '.' => Err(("a second sentence begins here", "write one sentence a line")),
        _ => match sign(text) {
            Some(sign) => Ok((Kind::Formula, sign, sign.len())),
            None => Err(NO_MEANING),
        },
    }
}

/// Text up to a closing sign; one behind a backslash does not close.
fn enclosed(
    text: &str,
    close: char,
    kind: Kind,
) -> Result<(Kind, &str, usize), (&'static str, &'static str)> {
    let mut escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        if c == close && !escaped {
            let start = text.chars().next().map_or(1, char::len_utf8);
            return Ok((kind, text[start..at].trim(), at + c.len_utf8()));
        }
        escaped = c == '\\' && !escaped;
    }
    Err(match kind {
        Kind::Quoted => (
            "the quotation is not closed",
            "close it with a quotation mark",
        ),
        _ => (
            "the formula is not closed",
            "close it with the sign that opened it",
        ),
    })
}

/// `\( … \)`
fn enclosed_by<'t>(
    text: &'t str,
    close: &str,
) -> Result<(Kind, &'t str, usize), (&'static str, &'static str)> {
    let inside = text.find(close).and_then(|at| Some((at, text.get(2..at)?)));
    let (at, inside) = inside.ok_or((
        "the formula is not closed",
        "close it with the sign that opened it",
    ))?;
    Ok((Kind::Formula, inside.trim(), at + close.len()))
}

/// What stands up to the next gap, without the stop at its end.
fn alone(text: &str) -> &str {
    let gap = text.find(char::is_whitespace).unwrap_or(text.len());
    text[..gap].trim_end_matches(['.', ',', ';'])
}

/// A formula outside of its signs: a command with what stands close behind it, `\diff{f}{t}`.
fn raw(text: &str) -> &str {
    let mut depth = 0usize;
    let ends = |&(_, c): &(usize, char)| {
        match c {
            '{' => depth += 1,
            '}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        c.is_whitespace() && depth == 0
    };
    let end = text
        .char_indices()
        .find(ends)
        .map_or(text.len(), |(at, _)| at);
    text[..end].trim_end_matches(['.', ',', ';', ')'])
}

fn word(text: &str) -> (Kind, &str, usize) {
    let short = |short: &&&str| {
        text.get(..short.len())
            .is_some_and(|t| t.eq_ignore_ascii_case(short))
    };
    if let Some(short) = SHORT.iter().find(short) {
        return (Kind::Word, &text[..short.len()], short.len());
    }
    let inside = |c: char| c.is_alphanumeric() || "*_'′’-{}^".contains(c);
    let goes_on = |rest: &str| rest.chars().nth(1).is_some_and(char::is_alphanumeric);
    let ends =
        |&(at, c): &(usize, char)| !(inside(c) || (matches!(c, ':' | '.') && goes_on(&text[at..])));
    let length = text
        .char_indices()
        .find(ends)
        .map_or(text.len(), |(at, _)| at);
    let word = &text[..length];
    let number = word.bytes().all(|b| b.is_ascii_digit());
    (if number { Kind::Number } else { Kind::Word }, word, length)
}

/// A word without the stars and lines that make it bold or slanted.
fn unmarked(word: &str) -> Cow<'_, str> {
    let bare = word.trim_matches(['*', '_']);
    match bare.contains('*') {
        true => Cow::Owned(bare.replace('*', "")),
        false => Cow::Borrowed(bare),
    }
}

/// Short forms that end in a stop.
const SHORT: [&str; 5] = ["w.r.t.", "i.e.", "e.g.", "resp.", "approx."];

/// An error at a place.
pub(crate) fn wrong(line: usize, column: usize, message: &str, help: &str) -> Misread {
    Misread {
        line,
        column,
        message: message.to_owned(),
        help: (!help.is_empty()).then(|| help.to_owned()),
    }
}
