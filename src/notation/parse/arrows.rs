//! Arrows that part a formula into statements.

use super::line::relations;
use crate::notation::ast::Relation;
use crate::notation::token::Token;

/// Whether a single arrow stands between two equations, and not in a limit or a mapping: `a = b \to c = d`.
pub(super) fn joins_equations(name: &str, before: &[Token<'_>], behind: &[Token<'_>]) -> bool {
    let equates = |tokens: &[Token<'_>]| {
        let first = relations(tokens).into_iter().next();
        first.is_some_and(|(.., relation)| relation == Relation::Equal)
    };
    matches!(name, "rightarrow" | "longrightarrow" | "to") && equates(before) && equates(behind)
}

/// Whether an arrow parts statements wherever it stands.
pub(super) fn is_arrow(name: &str) -> bool {
    matches!(
        name,
        "Rightarrow"
            | "Longrightarrow"
            | "implies"
            | "iff"
            | "Leftrightarrow"
            | "therefore"
            | "because"
            | "hookrightarrow"
            | "Longleftrightarrow"
            | "Leftarrow"
            | "leadsto"
            | "downarrow"
            | "Downarrow"
            | "impliedby"
            | "rightsquigarrow"
    )
}
