//! Lists and tables of symbols: "ω: angular velocity", "| H | angular momentum |".

use crate::verify::values::quantity::Quantity;
use crate::verify::words::phrases::named_first;

/// How far into its words an entry names the quantity.
const WITHIN: usize = 16;

/// The quantity in the words of an entry, right behind the symbol or (in the next cell) behind the end of its own.
pub(crate) fn in_a_legend(text: &str, near: bool, ended: bool) -> Option<Quantity> {
    let (entry, set_off) = entry(text);
    (set_off && near || ended)
        .then(|| named_first(entry, WITHIN))
        .flatten()
}

/// Whether an entry right behind the symbol names none of the quantities.
pub(crate) fn listed_apart(text: &str, near: bool) -> bool {
    let (entry, set_off) = entry(text);
    set_off && near && entry.len() > WITHIN && named_first(entry, WITHIN).is_none()
}

/// What has a size and is none of the quantities.
const SIZES: &[&str] = &[
    "length",
    "lengths",
    "height",
    "width",
    "thickness",
    "radius",
    "diameter",
    "side",
    "sides",
    "edge",
    "distance",
    "arm",
    "weight",
    "period",
    "load",
    "angle",
];

/// Whether the last word before a symbol calls it a size: "a rod of length ⟨".
pub(crate) fn names_a_size(before: &str) -> bool {
    let last = before.split_whitespace().next_back();
    last.is_some_and(|word| SIZES.contains(&word))
        && !names_a_side_of_an_equation(before)
        && !names_a_time(before)
}

/// Whether the clause before a formula calls it the Lagrangian: "the Lagrangian of the top is ⟨".
pub(crate) fn names_the_lagrangian(before: &str) -> bool {
    let before = before.trim_end_matches(['.', ':', ' ', '⟩']);
    let clause = before.rsplit(['⟨', ',', ';', '.', ':']).next();
    let (_, behind) = match clause.and_then(|clause| clause.rsplit_once("lagrang")) {
        Some(named) => named,
        None => return false,
    };
    // "Lagrange's equation for θ is" names another thing.
    let function = ["ian", "e function", "e's function", "ean"];
    function.iter().any(|end| behind.starts_with(end))
        && !["equation", "gives", "yields", "follow", "derive"]
            .iter()
            .any(|word| behind.contains(word))
}

/// "A step of length ⟨", "time intervals of length ⟨": a time, and no length.
fn names_a_time(before: &str) -> bool {
    let words = before.trim_end_matches(['⟨', ',', ' ']);
    let of = words.trim_end_matches('s').strip_suffix("length");
    let of = of.map(|of| of.trim_end().trim_end_matches(" the"));
    let of = of.and_then(|of| of.trim_end().strip_suffix(" of"));
    let thing = of.map(|of| of.trim_end().trim_end_matches('s'));
    let times = ["step", "interval", "time", "period"];
    thing.is_some_and(|thing| times.iter().any(|time| thing.ends_with(time)))
        || ["step length ", "step size "]
            .iter()
            .any(|said| before.ends_with(said))
}

/// "The right-hand sides ⟨": of equations, and no lengths.
fn names_a_side_of_an_equation(before: &str) -> bool {
    let words = before.trim_end_matches(['⟨', ',', ' ']);
    let of = words.trim_end_matches('s').strip_suffix("side");
    of.is_some_and(|of| of.trim_end_matches([' ', '-']).ends_with("hand"))
}

/// What is measured as a length.
const LENGTHS: &[&str] = &[
    "length",
    "lengths",
    "height",
    "width",
    "thickness",
    "radius",
    "radii",
    "diameter",
    "side",
    "sides",
    "edge",
    "edges",
    "distance",
];

/// Whether the last words before a symbol, or before the list that it stands in, call it a length: "edges ⟨, ⟨ and ⟨".
pub(crate) fn names_a_length(before: &str) -> bool {
    let words = before.split_whitespace().rev();
    let word = |word: &&str| !matches!(word.trim_matches(['⟨', ',']), "" | "and");
    words
        .map(|word| word.trim_end_matches(['⟨', ',']))
        .find(|last| word(last))
        .is_some_and(|last| LENGTHS.contains(&last))
        && !names_a_side_of_an_equation(before)
        && !names_a_time(before)
}

/// Whether the words behind a symbol call it the speeds of wheels.
pub(crate) fn names_wheel_speeds(text: &str) -> bool {
    let clause = text.split(['.', ';', ',']).next().unwrap_or_default();
    let start: Vec<&str> = clause.split_whitespace().take(8).collect();
    // "The inertia ⟨ carries a rotor at the rate": what comes first is another thing.
    let other = ["carries", "has", "holds", "contains", "bears", "with"];
    if start.first().is_some_and(|word| other.contains(word)) {
        return false;
    }
    let spoken = |names: &[&str]| {
        start
            .iter()
            .any(|word| names.iter().any(|n| word.starts_with(n)))
    };
    spoken(&["speed", "rate"]) && spoken(&["wheel", "rotor", "propeller", "flywheel"])
}

/// The words of an entry, and whether a sign sets them off from the symbol.
fn entry(text: &str) -> (&str, bool) {
    let words = text.trim_start();
    let entry = words.trim_start_matches([':', '–', '—', '-', '=', '|']);
    let set_off = entry.len() < words.len() || text.starts_with("  ");
    let entry = entry.trim_start();
    let bare = ["the ", "its "]
        .iter()
        .find_map(|article| entry.strip_prefix(article));
    (bare.unwrap_or(entry), set_off)
}
