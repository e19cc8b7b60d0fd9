//! The imaginary unit: who joins two equations in one complex equation writes it i.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::letters::usage::{Letter, Usage, axis, inner, symbols};
use crate::verify::words::book::has_any;
use crate::verify::words::text::Text;

/// Words of those who calculate with complex numbers, and what they write for the unit.
const SAID: &[&str] = &["complex", "imaginary", "\\sqrt{-1}"];

/// Whether the plain letter i is the imaginary unit: complex numbers are spoken of or written, and i is never anything
/// that moves, has an index or a direction.
pub(crate) fn has_imaginary_unit(text: &Text, usage: &Usage) -> bool {
    let used = usage.get(&Letter::plain("i"));
    let sides = || text.lines().flat_map(|line| &line.sides);
    // Beside a unit vector with a mark, an upright i is the unit; with an upright j or k it is one of a triad.
    let upright = |name: &str| {
        let mut all = sides().flat_map(symbols);
        all.any(|s| s.name == name && s.style.upright && !s.style.vector && !s.style.hat)
    };
    let upright = upright("i") && !upright("j") && !upright("k");
    let marked = used.vector + used.hats > 0 && !upright;
    let number = used.bare > 0 && used.component + used.double + used.tensor == 0 && !marked;
    let plain = number && !used.moving && (!usage.plain_units || upright);
    plain && (has_any(text.lower(), SAID) || sides().any(joins))
}

/// An upright i, or `\omega_1 + i\omega_2`: one component of a vector, and i times another.
fn joins(node: &Node) -> bool {
    let upright = |s: &Symbol| is_plain_i(s) && s.style.upright;
    if symbols(node).into_iter().any(upright) {
        return true;
    }
    let Kind::Sum(terms) = &inner(node).kind else {
        return node.children().any(joins);
    };
    let component = |symbols: &[&Symbol]| match symbols {
        [one] if one.subscripts.iter().any(|s| axis(s).is_some()) => Some(Letter::of(one)),
        _ => None,
    };
    let [real, imaginary] = terms.as_slice() else {
        return false;
    };
    let met = symbols(&imaginary.node);
    let (units, others): (Vec<&Symbol>, Vec<&Symbol>) =
        met.into_iter().partition(|s| is_plain_i(s));
    let first = component(&symbols(&real.node));
    units.len() == 1 && first.is_some() && first == component(&others)
}

/// Whether a symbol is a letter i and nothing else.
pub(crate) fn is_plain_i(symbol: &Symbol) -> bool {
    let bare = symbol.subscripts.is_empty() && symbol.superscripts.is_empty();
    symbol.name == "i" && bare && symbol.primes == 0 && !symbol.style.vector && !symbol.style.hat
}
