//! Vectors and tensors on space axes, told by a label: `\mathbf a^s`, `\mathbf L_{\text{in}}`.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::letters::frame::Frame;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, inner, symbols};
use crate::verify::theory::attitude_law::body_to_space;
use crate::verify::values::atoms::{Atoms, Entity, Owner};
use crate::verify::values::lower::{Lowered, Lowering};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::symbol::{Meaning, meaning};
use crate::verify::values::value::Value;

/// Words and abbreviations for axes of fixed orientation, wherever they stand.
pub(crate) const WORDS: &[&str] = &[
    "in", "inertial", "space", "spatial", "fixed", "lab", "world", "inert",
];
/// Letters for them, where the document speaks of an attitude.
pub(crate) const LETTERS: &[&str] = &["s", "S", "n", "N", "i", "I", "w", "W", "e", "E"];

/// A symbol without the label that puts it on space axes; `None` where it has none.
pub(crate) fn without_label(symbol: &Symbol, reading: &Reading) -> Option<Symbol> {
    if !is_marked(symbol, reading) {
        return None;
    }
    let letters = reading.attitude.is_spoken_of();
    let labels = |text: &str| {
        let text = text.trim();
        WORDS.contains(&text) || (letters && LETTERS.contains(&text))
    };
    let told = !reading
        .usage
        .always_wears(&Letter::of(symbol), &symbol.superscripts);
    let mut bare = symbol.clone();
    bare.subscripts.retain(|text| !labels(text));
    bare.superscripts.retain(|text| !(labels(text) && told));
    (bare != *symbol && !names_the_observer(symbol, reading)).then_some(bare)
}

/// Whether the label of a velocity or an acceleration says who sees it: beside `\mathbf v_{\text{space}}` there is a
/// `\mathbf v_{\text{rot}}`.
fn names_the_observer(symbol: &Symbol, reading: &Reading) -> bool {
    let letter = Letter::of(symbol);
    let quantity = reading.quantities.get(&letter);
    let motion = [Quantity::Velocity, Quantity::Acceleration];
    if !quantity.map_or(matches!(symbol.name.as_str(), "v" | "a"), |q| {
        motion.contains(q)
    }) {
        return false;
    }
    let met = reading.usage.subscripts.get(&letter);
    met.is_some_and(|labels| {
        let mut frames = labels.iter().map(|label| reading.frames.of_text(label));
        frames.any(|frame| frame == Some(Frame::Moving))
    })
}

/// Whether a symbol shows that it is a vector or a tensor, or wears labels of both triads of axes.
fn is_marked(symbol: &Symbol, reading: &Reading) -> bool {
    let marked = symbol.style.vector || symbol.style.tensor || symbol.style.bar;
    let letters = &reading.on_both_axes;
    marked || !letters.is_empty() && letters.contains(&Letter::of(symbol))
}

/// Letters for the body's axes, where the document speaks of an attitude.
pub(crate) const BODY: &[&str] = &["B", "b", "body"];

/// A symbol without the label that puts it on the body's axes, `\mathbf h_B`, or the matrix without the two labels that it
/// leads between, `\mathbf R_{WB}`; `None` where it has none.
pub(crate) fn without_body_label(symbol: &Symbol, reading: &Reading) -> Option<Symbol> {
    if !reading.attitude.is_spoken_of() {
        return None;
    }
    let marked = is_marked(symbol, reading);
    let matrix = reading.attitude.matrix.as_ref() == Some(&Letter::of(symbol));
    let labels = |text: &str| {
        let text = text.trim();
        let both = text.split_at_checked(1);
        let leads = both.is_some_and(|(to, from)| LETTERS.contains(&to) && BODY.contains(&from));
        matrix && leads || marked && !matrix && BODY.contains(&text)
    };
    let mut bare = symbol.clone();
    bare.subscripts.retain(|text| !labels(text));
    (bare != *symbol).then_some(bare)
}

/// Tells what stands on space axes from the same on the axes used.
pub(crate) const ON_SPACE_AXES: &str = " on space axes";

/// What stands on space axes for what stands on the axes used.
pub(crate) fn in_space(meaning: Meaning, atoms: &mut Atoms) -> Meaning {
    match meaning {
        Meaning::Whole(entity) => spatial(entity, atoms).map_or(meaning, Meaning::Whole),
        Meaning::Component(entity, component) => {
            match (spatial(entity, atoms), atoms.info(entity).shape) {
                (Some(turned), Shape::Vector) => Meaning::Component(turned, component),
                _ => meaning,
            }
        }
        other => other,
    }
}

fn spatial(entity: Entity, atoms: &mut Atoms) -> Option<Entity> {
    let info = atoms.info(entity).clone();
    if info.in_body.is_some() {
        return Some(entity);
    }
    let shape = match info.shape {
        Shape::Vector => Shape::Vector,
        Shape::Matrix | Shape::Symmetric => Shape::Matrix,
        Shape::Scalar | Shape::Grid(..) => return None,
    };
    let owner = match info.owner {
        Owner::Quantity(quantity, variant) => {
            Owner::Quantity(quantity, format!("{variant}{ON_SPACE_AXES}"))
        }
        Owner::Symbol(name) => Owner::Symbol(format!("{name}{ON_SPACE_AXES}")),
    };
    let turned = atoms.entity(&owner, shape, false, &format!("{}^s", info.latex));
    atoms.info_mut(turned).in_body = Some(entity);
    Some(turned)
}

impl Lowering<'_> {
    /// The value of a side. A number that is the same on all axes is read as if it stood on the body's.
    pub(crate) fn side(&mut self, side: &Node) -> Lowered {
        let value = self.value(side)?;
        let axes = self.reading.space_axes.as_ref();
        let invariant = axes.is_some_and(|a| a.beside_body && a.is_invariant(side));
        let turned =
            |s: &Symbol| Some(&Quantity::Attitude) == self.reading.quantities.get(&Letter::of(s));
        if !(invariant && value.is_scalar()) || symbols(side).into_iter().any(turned) {
            return Ok(value);
        }
        let mut reading = self.reading.clone();
        reading.space_axes = None;
        let mut lowering = Lowering {
            theory: &mut *self.theory,
            reading: &reading,
            ..*self
        };
        lowering.value(side)
    }

    /// The inverse of a tensor on space axes, R I⁻¹ Rᵀ.
    pub(crate) fn turned_inverse(&mut self, base: &Node) -> Option<Value> {
        let Kind::Symbol(symbol) = &inner(base).kind else {
            return None;
        };
        let Meaning::Whole(entity) = meaning(symbol, self.reading, &mut self.theory.atoms) else {
            return None;
        };
        let in_body = self.theory.atoms.info(entity).in_body?;
        let inverse = self.meaning_value(Meaning::Whole(in_body), 0).inverse();
        let setting = self.theory.setting;
        let turn = body_to_space(&mut self.theory.atoms, setting);
        let turn = Value::from_fn(3, 3, |r, c| turn[(r, c)].clone());
        let turned = turn.times(&inverse.ok()?).ok()?;
        turned.times(&turn.transposed()).ok()
    }

    /// Whether a differentiated operand is a column of numbers of its own, so that every frame sees the same rate: on
    /// space axes, or the vector part of a quaternion.
    pub(crate) fn is_column_of_numbers(&mut self, operand: &Node) -> bool {
        if self.in_space {
            return true;
        }
        let Kind::Symbol(symbol) = &inner(operand).kind else {
            return false;
        };
        match meaning(symbol, self.reading, &mut self.theory.atoms) {
            Meaning::Quaternion(..) => true,
            Meaning::Whole(entity) => self.theory.atoms.info(entity).in_body.is_some(),
            _ => false,
        }
    }
}

/// Whether a line stands on space axes as a whole: a label says so on one of its symbols, and no attitude stands in it that
/// would take the others there.
pub(crate) fn all_in_space(sides: &[Node], reading: &Reading) -> bool {
    let all: Vec<&Symbol> = sides.iter().flat_map(symbols).collect();
    let labelled = || all.iter().any(|s| without_label(s, reading).is_some());
    let turned = |symbol: &&Symbol| {
        reading.attitude.matrix.as_ref() == Some(&Letter::of(symbol))
            || reading.attitude.part(symbol).is_some()
    };
    labelled() && !all.iter().any(turned)
}
