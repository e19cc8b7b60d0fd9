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
        text: put_in(&equation, &letter.text, &value.text)?,
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

/// A formula with something else wherever a letter stands; `None` where it does not stand.
fn put_in(formula: &str, letter: &str, value: &str) -> Option<String> {
    let letter = letter.trim();
    let mut new = String::new();
    let (mut rest, mut any) = (formula, false);
    while let Some(at) = rest.find(letter).filter(|_| !letter.is_empty()) {
        let (before, from) = rest.split_at(at);
        let after = &from[letter.len()..];
        new.push_str(before);
        // Inside the name of a command, or with a label behind it, it is another letter.
        let inside = new.ends_with(|c: char| c.is_ascii_alphabetic() || c == '\\')
            || after.starts_with(|c: char| {
                c.is_ascii_alphabetic() && letter.starts_with('\\') && !letter.ends_with('}')
            })
            || after.starts_with('_');
        new.push_str(match inside {
            true => letter,
            false => value,
        });
        any |= !inside;
        rest = after;
    }
    new.push_str(rest);
    any.then_some(new)
}
