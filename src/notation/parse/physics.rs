//! Matrices by the commands of the package physics, as the environments that they stand for.

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
        ("pmqty", _) if bare => "pmatrix",
        ("bmqty", _) if bare => "bmatrix",
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
        }
    }
    out
}
