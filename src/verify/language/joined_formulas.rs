//! Formulas that are written with names and signs outside of their marks: "`$\sin\theta$` u + `$\cos\theta$` z", "n × u", "-x".

use super::words::{Kind, Token};

/// Signs between the parts of a formula, and how a formula writes them.
const SIGNS: [(char, &str); 7] = [
    ('+', "+"),
    ('-', "-"),
    ('−', "-"),
    ('×', "\\times"),
    ('·', "\\cdot"),
    ('=', "="),
    ('≠', "\\ne"),
];

/// Prepositions and verbs behind which a factor and a vector may stand side by side.
const BEFORE_PRODUCTS: [&str; 8] = ["by", "along", "is", "are", "and", "to", "from", "about"];

/// The sign with which a text begins.
pub(super) fn sign(text: &str) -> Option<&str> {
    let first = text.chars().next()?;
    let known = SIGNS.iter().any(|(sign, _)| *sign == first);
    known.then(|| &text[..first.len_utf8()])
}

/// The pieces of a sentence with each formula that stands in several of them in one.
pub(super) fn joined(tokens: Vec<Token>) -> Vec<Token> {
    let mut joined = vec![];
    let mut at = 0;
    while at < tokens.len() {
        match formula(&tokens[at..], tokens[..at].last()) {
            Some((formula, length)) => {
                joined.push(formula);
                at += length;
            }
            None => {
                joined.push(tokens[at].clone());
                at += 1;
            }
        }
    }
    joined
}

/// A formula in several pieces that begins here, and how many they are.
fn formula(tokens: &[Token], before: Option<&Token>) -> Option<(Token, usize)> {
    let mut parts: Vec<&str> = vec![];
    let mut at = 0;
    let mut signs = 0;
    loop {
        if let Some(sign) = tokens.get(at).and_then(written_sign) {
            // A sign begins a formula only where it is that of a number or a name: "-x".
            let begins = parts.is_empty() && sign != "-";
            if begins || tokens.get(at + 1).and_then(operand).is_none() {
                break;
            }
            parts.push(sign);
            signs += 1;
            at += 1;
        } else if !parts.is_empty() && !side_by_side(tokens, at, before) {
            break;
        }
        let Some(text) = tokens.get(at).and_then(operand) else {
            break;
        };
        parts.push(text);
        at += 1;
    }
    let several = signs > 0 && parts.len() > 1 || signs == 0 && parts.len() == 2;
    let first = tokens.first().filter(|_| several)?;
    let formula = Token {
        kind: Kind::Formula,
        text: parts.join(" "),
        lower: String::new(),
        column: first.column,
    };
    Some((formula, at))
}

/// Whether the name here is a vector behind its factor: nothing goes on behind it but another term or the end of a phrase.
fn side_by_side(tokens: &[Token], at: usize, before: Option<&Token>) -> bool {
    let is_factor = |t: &Token| {
        t.kind == Kind::Formula
            && written_sign(t).is_none()
            && !t.text.contains(['=', ',', '<', '>'])
    };
    let [.., factor] = &tokens[..at] else {
        return false;
    };
    let vector = tokens.get(at).filter(|t| t.kind == Kind::Word);
    let small =
        vector.is_some_and(|t| t.text.chars().all(char::is_lowercase) && operand(t).is_some());
    let ends = match tokens.get(at + 1) {
        None => true,
        Some(next) => {
            written_sign(next).is_some()
                || matches!(next.kind, Kind::Comma | Kind::Semicolon | Kind::Close)
                || next.lower == "and"
        }
    };
    let in_place = at > 1 || before.is_some_and(|t| BEFORE_PRODUCTS.contains(&t.lower.as_str()));
    is_factor(factor) && small && ends && in_place
}

/// What a piece is in a formula: another formula, a number, or a name of one letter.
fn operand(token: &Token) -> Option<&str> {
    let letters = token
        .text
        .trim_end_matches(['\'', '′', '’'])
        .chars()
        .count();
    let stands = match token.kind {
        Kind::Formula => written_sign(token).is_none(),
        Kind::Plain | Kind::Number => true,
        Kind::Word => letters == 1,
        _ => false,
    };
    stands.then_some(token.text.as_str())
}

fn written_sign(token: &Token) -> Option<&'static str> {
    let mut signs = SIGNS.iter();
    let (_, written) = signs.find(|(sign, _)| {
        token.kind == Kind::Formula && token.lower.chars().eq(std::iter::once(*sign))
    })?;
    Some(written)
}
