//! "`$c$` is the value of `$x$` at which `$f$` is zero": f vanishes with c for x.

use super::words::{Kind, Token};

/// Words behind the letter that may have many values.
const AT_WHICH: [&[&str]; 6] = [
    &["at", "which"],
    &["for", "which"],
    &["with", "which"],
    &["where"],
    &["that", "makes"],
    &["which", "makes"],
];

/// What is said of what vanishes.
const VANISHES: [&[&str]; 6] = [
    &["is", "zero"],
    &["is", "0"],
    &["vanishes"],
    &["becomes", "zero"],
    &["zero"],
    &["vanish"],
];

/// The equation that holds for the value; `None` where the sentence says something else.
pub(crate) fn value_at_which(tokens: &[Token]) -> Option<Vec<Token>> {
    let (value, rest) = tokens.split_first()?;
    let rest = behind(rest, &["is", "the", "value", "of"])?;
    let (letter, rest) = rest.split_first()?;
    let rest = AT_WHICH.iter().find_map(|words| behind(rest, words))?;
    let (formula, rest) = rest.split_first()?;
    let formulas = [value, letter, formula];
    if !formulas.iter().all(|token| token.kind == Kind::Formula) {
        return None;
    }
    let vanishes = VANISHES
        .iter()
        .any(|words| behind(rest, words).is_some_and(<[Token]>::is_empty));
    let equation = match (formula.text.contains('='), vanishes, rest) {
        (false, true, _) => format!("{} = 0", formula.text),
        (true, false, []) => formula.text.clone(),
        _ => return None,
    };
    Some(vec![Token {
        text: with_value(&equation, &letter.text, &value.text)?,
        ..formula.clone()
    }])
}

/// What stands behind some words, if they come first.
fn behind<'t>(tokens: &'t [Token], words: &[&str]) -> Option<&'t [Token]> {
    let said = |(token, word): (&Token, &&str)| match token.kind {
        Kind::Word => token.lower == **word,
        Kind::Number => token.text == **word,
        _ => false,
    };
    let rest = tokens.get(words.len()..)?;
    tokens.iter().zip(words).all(said).then_some(rest)
}

/// A formula with something else wherever a letter stands; `None` where it does not stand. With a label or a prime behind it
/// it is another letter.
fn with_value(formula: &str, letter: &str, value: &str) -> Option<String> {
    let (all, own) = (pieces(formula), pieces(letter.trim()));
    let (mut new, mut at, mut any) = (String::new(), 0, false);
    while let Some(piece) = all.get(at) {
        let behind = all.get(at + own.len());
        let labelled = behind.is_some_and(|piece| matches!(*piece, "_" | "'"));
        if !own.is_empty() && all[at..].starts_with(&own) && !labelled {
            // Between letters no command may run into the next one.
            new.push_str(&format!(" {value} "));
            at += own.len();
            any = true;
        } else {
            new.push_str(piece);
            at += 1;
        }
    }
    any.then_some(new)
}

/// A formula as commands and single signs.
fn pieces(formula: &str) -> Vec<&str> {
    let (mut rest, mut pieces) = (formula, vec![]);
    while let Some(first) = rest.chars().next() {
        let length = match first {
            '\\' => {
                let name = rest[1..].bytes().take_while(u8::is_ascii_alphabetic);
                1 + name.count()
            }
            first => first.len_utf8(),
        };
        let (piece, behind) = rest.split_at(length);
        pieces.push(piece);
        rest = behind;
    }
    pieces
}
