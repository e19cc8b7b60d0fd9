//! A label of the world's axes on the inertia alone: `I_w = R I_b R^T` beside an ω, on world axes too, that wears none.
//!
//! Where all that stands there goes without a label, the inertia may go without it as well.

use crate::notation::ast::Symbol;
use crate::notation::document::Document;
use crate::verify::letters::point_labels::formulas_mut;
use crate::verify::letters::space_axes::turned_labels;
use crate::verify::letters::two_points::every_symbol;
use crate::verify::words::attitude_words::{rate_in_space, sentences};

/// Takes the label of the world's axes off the inertia, where the angular velocity stands on them without one.
pub(crate) fn drop_world_labels(document: &mut Document) {
    let Some((name, world, body)) = turned_labels(document) else {
        return;
    };
    let all = every_symbol(document);
    let worn = |symbol: &Symbol| symbol.subscripts.concat().trim().to_owned();
    let bare = all
        .iter()
        .any(|s| s.name == name && s.subscripts.is_empty());
    let rates = || all.iter().filter(|s| s.name == "omega");
    let labelled = rates().any(|s| [&world, &body].contains(&&worn(s)));
    let plain = rates().any(|s| s.subscripts.is_empty());
    let said: Vec<_> = sentences(document);
    let said = said.iter().filter_map(|s| rate_in_space(&s.text));
    if bare || labelled || !plain || said.reduce(|all, one| all && one) != Some(true) {
        return;
    }
    for node in formulas_mut(document) {
        node.change_symbols(&mut |symbol| {
            if symbol.name == name && worn(symbol) == world {
                symbol.subscripts.clear();
            }
        });
    }
}
