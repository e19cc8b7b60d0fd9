//! `{a \over b}`, TeX's own way to write a fraction, as `{\frac{a}{b}}`.

use crate::notation::token::{Lexeme, Token};
use std::borrow::Cow;

/// The sign between what stands above and what stands below.
const OVER: Lexeme<'static> = Lexeme::Command("over");

/// The tokens with each group that holds one `\over` written as a fraction.
pub(super) fn with_fractions<'t, 'a>(tokens: &'t [Token<'a>]) -> Cow<'t, [Token<'a>]> {
    if !tokens.iter().any(|token| token.kind == OVER) {
        return Cow::Borrowed(tokens);
    }
    let mut out: Vec<Token<'a>> = Vec::with_capacity(tokens.len() + 8);
    // Where what each open group holds starts.
    let mut groups: Vec<usize> = vec![];
    for &token in tokens {
        match token.kind {
            Lexeme::Open => groups.push(out.len() + 1),
            Lexeme::Close => {
                if let Some(inside) = groups.pop().map(|start| out.split_off(start)) {
                    out.extend(fraction(inside));
                }
            }
            _ => {}
        }
        out.push(token);
    }
    Cow::Owned(out)
}

/// What a group holds, all groups in which are settled, as a fraction if one `\over` parts it.
fn fraction(inside: Vec<Token<'_>>) -> Vec<Token<'_>> {
    let mut depth = 0usize;
    let mut strokes = vec![];
    for (at, token) in inside.iter().enumerate() {
        match token.kind {
            Lexeme::Open => depth += 1,
            Lexeme::Close => depth = depth.saturating_sub(1),
            OVER if depth == 0 => strokes.push(at),
            _ => {}
        }
    }
    let [stroke] = strokes.as_slice() else {
        return inside;
    };
    let sign = inside[*stroke];
    let with = |kind| Token { kind, ..sign };
    let parts = [&inside[..*stroke], &inside[*stroke + 1..]];
    let grouped = parts.into_iter().flat_map(|part| {
        let ends = [with(Lexeme::Open), with(Lexeme::Close)];
        let [open, close] = ends;
        [open]
            .into_iter()
            .chain(part.iter().copied())
            .chain([close])
    });
    [with(Lexeme::Command("frac"))]
        .into_iter()
        .chain(grouped)
        .collect()
}
