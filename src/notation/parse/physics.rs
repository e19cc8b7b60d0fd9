//! Matrices by commands with one argument, those of plain TeX and of the package physics, as the environments that they
//! stand for.

use super::bracket_end;
use crate::notation::token::{Lexeme, Token};

/// Longer matrices are written as environments.
const LONGEST: usize = 400;

/// The environment of a command, given the bracket behind it.
fn environment(name: &str, bracket: Lexeme<'_>) -> Option<&'static str> {
    let bare = matches!(bracket, Lexeme::Open);
    Some(match (name, bracket) {
        ("mqty" | "smqty" | "matrixquantity", Lexeme::Char('|')) => "vmatrix",
        ("mqty" | "smqty" | "matrixquantity", _) => "matrix",
        ("matrix", _) if bare => "matrix",
        ("pmqty" | "pmatrix", _) if bare => "pmatrix",
        ("bmqty" | "bmatrix", _) if bare => "bmatrix",
        ("vmatrix", _) if bare => "vmatrix",
        ("vmqty" | "mdet" | "matrixdeterminant", _) if bare => "vmatrix",
        _ => return None,
    })
}

/// `\mqty(a & b \\ c & d)` with `\begin{matrix}` and `\end{matrix}` in place of its brackets.
pub(super) fn spelled_out<'a>(tokens: &[Token<'a>]) -> Vec<Token<'a>> {
    let mut out = tokens.to_vec();
    for i in 0..tokens.len().saturating_sub(1) {
        let Lexeme::Command(name) = tokens[i].kind else {
            continue;
        };
        let open = i + 1;
        let Some(environment) = environment(name, tokens[open].kind) else {
            continue;
        };
        let near = &tokens[..tokens.len().min(open + LONGEST)];
        let bar = |t: &Token<'_>| t.kind == Lexeme::Char('|');
        let close = match tokens[open].kind {
            Lexeme::Char('|') => near[open + 1..].iter().position(bar).map(|n| open + 1 + n),
            Lexeme::Open | Lexeme::Char('(' | '[') => bracket_end(near, open),
            _ => None,
        };
        if let Some(close) = close {
            out[i].kind = Lexeme::Begin(environment);
            // The bracket that opened stands for nothing now.
            out[open].kind = Lexeme::Space(0);
            out[close].kind = Lexeme::End(environment);
            without_spacing_of_rows(&mut out[open..close]);
        }
    }
    out
}

/// `\noalign{\smallskip}` between rows only sets them apart.
fn without_spacing_of_rows(tokens: &mut [Token<'_>]) {
    for at in 0..tokens.len().saturating_sub(1) {
        let spacing = tokens[at].kind == Lexeme::Command("noalign");
        let opens = tokens[at + 1].kind == Lexeme::Open;
        if let Some(close) = bracket_end(tokens, at + 1).filter(|_| spacing && opens) {
            for token in &mut tokens[at..=close] {
                token.kind = Lexeme::Space(0);
            }
        }
    }
}
