//! Formulas of which a sentence writes some parts between dollar signs and others as names: "by `$x$` u", "n = `$c$` x + `$s$` y".

use super::words::{Kind, Token};

/// Signs that join the parts of a formula.
const JOINING: [&str; 4] = ["=", "+", "-", "−"];

/// The sentence with each such formula as one; `None` where it has none.
pub(crate) fn joined(tokens: &[Token]) -> Option<Vec<Token>> {
    let (mut new, mut at, mut any) = (vec![], 0, false);
    while let Some(token) = tokens.get(at) {
        let length = length_at(&tokens[at..]);
        if length > 1 {
            new.push(Token {
                kind: Kind::Formula,
                text: written(&tokens[at..at + length]),
                lower: String::new(),
                column: token.column,
            });
            any = true;
        } else {
            new.push(token.clone());
        }
        at += length.max(1);
    }
    any.then_some(new)
}

/// How many pieces are one formula, from the first one on: parts with signs between them, each a formula, a name, or a
/// formula and a name that it multiplies. One that has neither a sign nor a product is none.
fn length_at(tokens: &[Token]) -> usize {
    let (mut end, mut made) = (0, false);
    loop {
        let sign = tokens.get(end).is_some_and(is_sign);
        if end > 0 && !sign {
            break;
        }
        let start = end + usize::from(sign);
        let number = tokens.get(start).is_some_and(is_factor);
        let name = tokens.get(start + usize::from(number)).is_some_and(is_name);
        if !number && !name {
            break;
        }
        made |= sign && end > 0 || number && name;
        end = start + usize::from(number) + usize::from(name);
    }
    if made { end } else { 0 }
}

fn is_sign(token: &Token) -> bool {
    token.kind == Kind::Formula && JOINING.contains(&token.text.as_str())
}

fn is_factor(token: &Token) -> bool {
    matches!(token.kind, Kind::Formula | Kind::Plain | Kind::Number) && !is_sign(token)
}

/// A small letter with or without a number: a capital may be a body or a point that something is said of.
fn is_name(token: &Token) -> bool {
    let mut letters = token.text.chars();
    let small = letters.next().is_some_and(char::is_lowercase);
    let number = letters.all(|c| c.is_ascii_digit());
    token.kind == Kind::Word && small && number && token.text != "a"
}

fn written(tokens: &[Token]) -> String {
    let parts = tokens.iter().map(|token| match token.kind {
        Kind::Word => with_index(&token.text),
        _ if !is_sign(token) && is_sum(&token.text) => format!("({})", token.text),
        _ => token.text.clone(),
    });
    parts.collect::<Vec<_>>().join(" ")
}

/// "e1" is e₁ in a formula.
fn with_index(name: &str) -> String {
    let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
    match &name[letters.len()..] {
        "" => name.to_owned(),
        index => format!("{letters}_{{{index}}}"),
    }
}

fn is_sum(formula: &str) -> bool {
    let behind_sign = formula.trim_start_matches(['+', '-', '−', ' ']);
    behind_sign.contains(['+', '-', '−'])
}
