//! What the subscripts and superscripts of a symbol say: an axis, two axes, a point, or a name.

use crate::notation::ast::Symbol;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, axes, axis};
use crate::verify::values::quantity::{Quantity, Shape};

/// Labels of a moment that say where it comes from: all that acts.
pub(crate) const LOADS: &[&str] = &[
    "ext", "external", "e", "net", "tot", "total", "app", "applied",
];

/// The subscripts of a symbol, sorted by what they say.
#[derive(Clone, Debug, Default)]
pub(crate) struct Subscripts {
    pub(crate) single: Option<u8>,
    /// Whether it is a component of a vector with an index of its own: `\tau_{d1}`.
    pub(crate) of_named: bool,
    pub(crate) double: Option<(u8, u8)>,
    /// What tells apart several entities of one letter: a step index, a word.
    pub(crate) variant: String,
}

/// Letters for points about which moments are taken; they do not make another quantity.
pub(crate) const POINTS: &[&str] = &[
    "G", "O", "C", "G or O", "O or G", "cm", "CM", "cg", "c", "o", "B", "body", "b", "Oxyz",
];

/// Those of them that are labels of the mass centre.
const CENTRES: &[&str] = &["G", "C", "c", "cm", "CM", "cg"];

pub(crate) fn subscripts(symbol: &Symbol, reading: &Reading) -> Subscripts {
    let mut sorted = Subscripts::default();
    let whole = reading.usage.wholes.names(symbol);
    if whole {
        sorted.variant = symbol.subscripts.join(",");
    }
    // Beside I_xx, an I_1 is a moment with a name of its own.
    let letter = Letter::of(symbol);
    let named_apart = reading.quantities.get(&letter) == Some(&Quantity::Inertia)
        && reading.usage.has_lettered_entries(&letter)
        && !reading.turns_to_numbers;
    // A matrix has no component: its index tells it from another.
    let used = reading.usage.get(&letter);
    let known =
        reading.quantities.contains_key(&letter) || reading.components.contains_key(&letter);
    let of_matrix = used.tensor > 0 && used.vector + used.double == 0 && !known;
    // What ω_12 across the axis 3 is says its definition: a vector has no entry 12.
    let quantity = reading.quantities.get(&letter);
    let vector = quantity.is_some_and(|q| q.shape() == Shape::Vector);
    for text in symbol.subscripts.iter().filter(|_| !whole) {
        let text = text.trim();
        // Beside axes 1, 2, 3, z is the vertical.
        let vertical = text == "z" && reading.usage.z_is_vertical(&letter);
        if vertical
            || of_matrix && axis(text).is_some()
            || named_apart && matches!(text, "1" | "2" | "3")
        {
            sorted.variant.push_str(text);
        } else if let Some(index) = axis(text) {
            sorted.single = Some(index);
        } else if let Some(pair) = axes(text).filter(|_| !vector) {
            sorted.double = Some(pair);
        } else if let Some(pair) = primed_axes(text, &letter, reading) {
            sorted.double = Some(pair);
            sorted.variant.push('\'');
        } else if let Some(index) = about_an_angle(text, &letter, reading) {
            sorted.single = Some(index);
        } else if let Some((name, index)) = name_and_index(text, &letter, reading) {
            sorted.single = Some(index);
            sorted.variant.push_str(name);
            sorted.of_named = true;
        } else if let Some((point, index)) = point_and_index(text) {
            sorted.single = Some(index);
            sorted.variant.push_str(point);
        } else {
            sorted.variant.push_str(text);
        }
    }
    sorted
        .variant
        .push_str(&superscripts(symbol, &letter, reading));
    sorted.variant.push_str(&"'".repeat(symbol.primes.into()));
    if symbol.variation {
        sorted.variant.push('δ');
    }
    sorted
}

/// The labels above a symbol that tell several entities of one letter apart.
fn superscripts(symbol: &Symbol, letter: &Letter, reading: &Reading) -> String {
    let always = reading.usage.always_wears(letter, &symbol.superscripts);
    if always || is_of_the_body(symbol, reading) {
        return String::new();
    }
    // Of the two frames of `{}^A\omega^B` each counts.
    let frames = symbol.superscripts.len() > 1;
    let apart = frames || has_inertia_about_points(letter, reading);
    // Momenta and moments are taken about a point, but a position or a velocity is that of the point.
    let of_point = matches!(
        reading.quantities.get(letter),
        Some(Quantity::Position | Quantity::Velocity | Quantity::Acceleration)
    );
    let about = |label: &str| POINTS.contains(&label) && !(of_point && CENTRES.contains(&label));
    let labels = symbol.superscripts.iter().map(|label| label.trim());
    let told = labels.filter(|&label| apart || !about(label));
    told.map(|label| format!("^{label}")).collect()
}

/// Row and column of an entry on turned axes in the plane, `J_{x'y'}`, where the tensor on these has a prime, `J'`, and
/// its products are its entries.
fn primed_axes(text: &str, letter: &Letter, reading: &Reading) -> Option<(u8, u8)> {
    let characters: Vec<char> = text
        .chars()
        .filter(|c| !c.is_whitespace() && *c != ',')
        .collect();
    let [row, '\'', column, '\''] = characters.as_slice() else {
        return None;
    };
    let inertia = reading.quantities.get(letter) == Some(&Quantity::Inertia);
    let usage = &reading.usage;
    let plane = usage.squares.contains_key(letter) && usage.primed.contains(letter);
    let entry = row == column || !usage.negated.contains(letter);
    let pair = axes(&format!("{row}{column}"));
    pair.filter(|_| inertia && plane && entry)
}

/// The axis of roll, pitch or yaw, where moments are told apart by the angles of all three: `\tau_\phi`, `\tau_\theta`,
/// `\tau_\psi`.
fn about_an_angle(text: &str, letter: &Letter, reading: &Reading) -> Option<u8> {
    let angles = ["phi", "theta", "psi"];
    let at = angles.iter().position(|angle| *angle == text)?;
    let moment = reading.quantities.get(letter) == Some(&Quantity::Moment);
    let all = |angles: [&str; 3]| angles.iter().all(|a| reading.usage.has_index(letter, a));
    let other = |index: &&String| axis(index).is_some();
    let met = reading.usage.subscripts.get(letter).into_iter().flatten();
    (moment && all(angles) && met.filter(other).count() == 0).then_some(at as u8)
}

/// Whether a letter of the inertia has the labels of two points: `I_{xx}^O` beside `I_{xx}^G`.
fn has_inertia_about_points(letter: &Letter, reading: &Reading) -> bool {
    let point =
        |label: &&Vec<String>| matches!(label.as_slice(), [p] if POINTS.contains(&p.trim()));
    let labels = reading.usage.superscripts.get(letter).into_iter().flatten();
    reading.quantities.get(letter) == Some(&Quantity::Inertia) && labels.filter(point).count() > 1
}

/// `d1` and `gg,x` are components of the vectors `d` and `gg` of that letter.
fn name_and_index<'t>(text: &'t str, letter: &Letter, reading: &Reading) -> Option<(&'t str, u8)> {
    let (at, _) = text.char_indices().last()?;
    let name = text[..at].trim_end_matches([',', ' ']);
    let index = axis(&text[at..])?;
    let met = !name.is_empty() && reading.usage.has_index(letter, name);
    (met && !POINTS.contains(&name)).then_some((name, index))
}

/// `Gx` is the x component about G.
fn point_and_index(text: &str) -> Option<(&str, u8)> {
    let (at, _) = text.char_indices().last()?;
    let point = text[..at].trim();
    Some((POINTS.contains(&point).then_some("")?, axis(&text[at..])?))
}

/// Whether a moment of inertia is about the point that the body turns about: O, or the only point there is.
pub(crate) fn is_main_point(letter: &Letter, point: &str, reading: &Reading) -> bool {
    let met = reading.usage.subscripts.get(letter);
    let only = met.is_some_and(|all| all.len() == 1);
    POINTS.contains(&point) && (matches!(point, "O" | "o") || only)
}

/// Whether what is written under a quantity tells it from no other of its letter: the `I_C` of `L_C = I_C ω`, the `M_0`
/// about the point 0, the ω_{2/1} of one body in one frame.
pub(crate) fn tells_nothing_apart(
    quantity: Quantity,
    symbol: &Symbol,
    point: &str,
    reading: &Reading,
) -> bool {
    let letter = Letter::of(symbol);
    let used = reading.usage.get(&letter);
    let index = |s: &str| axis(s).is_some() || axes(s).is_some();
    let met = reading.usage.subscripts.get(&letter);
    let mut points = met.into_iter().flatten().filter(|s| !index(s));
    let used_alone = points.all(|s| s == point) && used.naked == 0;
    let whole = match quantity {
        Quantity::Inertia => {
            let marked = symbol.style.vector || symbol.style.tensor || used.tensor > 0;
            // The moment about one axis by the words is a number.
            let moment = reading.moments.iter().any(|m| m.symbol == *symbol);
            marked || !moment && used.component + used.double == 0
        }
        Quantity::Momentum | Quantity::Moment => symbol.style.vector,
        Quantity::Energy => return used_alone && ENERGY_LABELS.contains(&point),
        Quantity::AngularVelocity => {
            let mut others = met.into_iter().flatten().filter(|s| s.contains('/'));
            let alone = others.all(|s| s == point) || is_of_the_body(symbol, reading);
            let between_frames = point.contains('/') && symbol.style.vector && alone;
            let bare = symbol.style.vector || used.component == 0;
            return between_frames || bare && used_alone && matches!(point, "b" | "B" | "body");
        }
        _ => false,
    };
    let load = quantity == Quantity::Moment && LOADS.contains(&point);
    whole && used_alone && (load || POINTS.contains(&point) || point == "0")
}

/// Labels of the only energy of a document: `E_{rot}`.
pub(crate) const ENERGY_LABELS: &[&str] = &["rot", "kin", "k"];

/// The two frames that an angular velocity is between: `{}^N\omega^B`, or `\omega_{B/N}` the other way.
pub(crate) fn between(symbol: &Symbol) -> Option<(String, String)> {
    if let [first, second] = symbol.superscripts.as_slice() {
        return Some((first.clone(), second.clone()));
    }
    let [both] = symbol.subscripts.as_slice() else {
        return None;
    };
    let (first, second) = both.split_once('/')?;
    Some((first.trim().to_owned(), second.trim().to_owned()))
}

/// Whether an angular velocity is that of the turning axes in those at rest, where the document has it both ways and
/// speaks of no third frame.
pub(crate) fn is_of_the_body(symbol: &Symbol, reading: &Reading) -> bool {
    let letter = Letter::of(symbol);
    let turning = [Quantity::AngularVelocity, Quantity::AngularAcceleration];
    let turns = reading.quantities.get(&letter);
    let Some((first, second)) =
        between(symbol).filter(|_| turns.is_some_and(|q| turning.contains(q)))
    else {
        return false;
    };
    let (from, of) = match symbol.superscripts.len() {
        2 => (&first, &second),
        _ => (&second, &first),
    };
    let frames = [from, of].map(|label| reading.frames.of_text(label));
    let pair = |labels: [&str; 2]| {
        labels == [first.as_str(), &second] || labels == [second.as_str(), &first]
    };
    let above = reading.usage.superscripts.get(&letter);
    let mut above = above.into_iter().flatten().filter(|met| !met.is_empty());
    let below = reading.usage.subscripts.get(&letter);
    let mut below = below.into_iter().flatten().filter(|met| met.contains('/'));
    frames == [Some(Frame::Space), Some(Frame::Moving)]
        && above.all(|met| matches!(met.as_slice(), [a, b] if pair([a, b])))
        && below.all(|met| {
            met.split_once('/')
                .is_some_and(|(a, b)| pair([a.trim(), b.trim()]))
        })
}

/// Whether a momentum or moment is about another point than the mass centre, where the document speaks of both.
pub(crate) fn another_point(letter: &Letter, point: &str, reading: &Reading) -> bool {
    let met = reading.usage.subscripts.get(letter);
    let centre = |label: &String| CENTRES.contains(&label.as_str());
    matches!(point, "O" | "o") && met.is_some_and(|all| all.iter().any(centre))
}

/// `k`, `k+1`, `n`: the index of an integration step.
pub(crate) fn step_index(variant: &str) -> bool {
    let mut characters = variant.chars();
    matches!(characters.next(), Some('k' | 'n' | 'i' | 'j'))
        && characters.all(|c| c.is_ascii_digit() || matches!(c, '+' | '-' | '/' | ' '))
}
