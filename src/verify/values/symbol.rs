//! What a symbol of a formula stands for.

use crate::notation::ast::Symbol;
use crate::verify::letters::attitude_reading::Part;
use crate::verify::letters::imaginary::is_plain_i;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::space_axes::SpaceAxes;
use crate::verify::letters::turned_primes::TURNED;
use crate::verify::letters::usage::Letter;
use crate::verify::values::about_point::about_a_point;
use crate::verify::values::atoms::{Atoms, Entity, Owner};
use crate::verify::values::own_symbol::of_symbol;
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::spatial::{in_space, without_body_label, without_label};
use crate::verify::values::subscript::{
    POINTS, Subscripts, another_point, is_main_point, step_index, subscripts, tells_nothing_apart,
};
use crate::verify::words::sizes_of_vectors::is_bare;

/// What a symbol stands for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Meaning {
    /// A whole quantity or symbol.
    Whole(Entity),
    /// One component of it.
    Component(Entity, u8),
    /// The unit vector along an axis of the axes used.
    UnitVector(u8),
    /// The identity matrix.
    Identity,
    /// π.
    Pi,
    /// The root of −1.
    ImaginaryUnit,
    /// The attitude quaternion, its conjugate or its vector part.
    Quaternion(Entity, Part),
}

impl Meaning {
    /// What it is, or is a component of, where that has a value of its own.
    pub(crate) fn entity(&self) -> Option<Entity> {
        match *self {
            Self::Whole(entity) | Self::Component(entity, _) => Some(entity),
            _ => None,
        }
    }
}

/// The variant of a velocity that may be any point's.
pub(crate) const ANY_POINT: &str = "any point";

/// The variant of a vector quantity that is its length.
pub(crate) const MAGNITUDE: &str = "magnitude";

/// Decides what a symbol stands for.
pub(crate) fn meaning(symbol: &Symbol, reading: &Reading, atoms: &mut Atoms) -> Meaning {
    if !reading.is_settled() {
        return on_axes(symbol, reading, atoms);
    }
    if let Some(known) = atoms.meaning(symbol) {
        return known;
    }
    let found = on_axes(symbol, reading, atoms);
    atoms.note_meaning(symbol, found);
    found
}

fn on_axes(symbol: &Symbol, reading: &Reading, atoms: &mut Atoms) -> Meaning {
    let on_body = |a: &&SpaceAxes| a.beside_body || a.left;
    let Some(axes) = reading.space_axes.as_ref().filter(on_body) else {
        return as_written(symbol, reading, atoms);
    };
    if let Some(bare) = axes.without_label(symbol) {
        return as_written(&bare, reading, atoms);
    }
    if axes.left {
        return as_written(symbol, reading, atoms);
    }
    match reading.quantities.get(&Letter::of(symbol)) {
        Some(Quantity::Attitude) => as_written(symbol, reading, atoms),
        _ => in_space(as_written(symbol, reading, atoms), atoms),
    }
}

/// The same, where every symbol stands on the axes used unless a mark of its own says otherwise, or that it has none.
fn as_written(symbol: &Symbol, reading: &Reading, atoms: &mut Atoms) -> Meaning {
    let plain = symbol.subscripts.is_empty() && symbol.superscripts.is_empty();
    let meaning = by_marks(symbol, reading, atoms);
    match &reading.plain_in_space {
        Some(letter) if plain && Letter::of(symbol) == *letter => in_space(meaning, atoms),
        _ => meaning,
    }
}

fn by_marks(symbol: &Symbol, reading: &Reading, atoms: &mut Atoms) -> Meaning {
    if let Some(spin) = &reading.carried_spin
        && let Some(meaning) = spin.meaning(symbol, atoms)
    {
        return meaning;
    }
    if let Some(part) = reading.attitude.part(symbol) {
        let entity = atoms.quantity(Quantity::Quaternion);
        return match part {
            Part::Number(at) => Meaning::Component(entity, at),
            part => Meaning::Quaternion(entity, part),
        };
    }
    if let Some(bare) = without_label(symbol, reading) {
        let meaning = as_written(&bare, reading, atoms);
        return in_space(meaning, atoms);
    }
    if let Some(bare) = without_body_label(symbol, reading) {
        return by_marks(&bare, reading, atoms);
    }
    if reading.marks_skew(symbol) {
        let mut vector = symbol.clone();
        vector.style.tilde = false;
        return as_written(&vector, reading, atoms);
    }
    if let Some(meaning) = about_a_point(symbol, reading, atoms) {
        return meaning;
    }
    if let Some(wheel) = reading.labelled_wheel.as_ref().filter(|w| w.is(symbol)) {
        let wheels = atoms.quantity(Quantity::RelativeMomentum);
        return Meaning::Component(wheels, wheel.axis);
    }
    if let Some(&quantity) = reading
        .sizes
        .get(&Letter::of(symbol))
        .filter(|_| is_bare(symbol))
    {
        let owner = Owner::Quantity(quantity, MAGNITUDE.to_owned());
        let latex = latex_name(&symbol.name);
        return Meaning::Whole(atoms.entity(&owner, Shape::Scalar, false, &latex));
    }
    let mut sorted = subscripts(symbol, reading);
    let letter = Letter::of(symbol);
    let quantity = reading.quantities.get(&letter);
    let own_point = reading.own_point.as_deref() == Some(sorted.variant.as_str());
    if own_point
        || quantity.is_some_and(|&q| tells_nothing_apart(q, symbol, &sorted.variant, reading))
    {
        sorted.variant.clear();
    }
    let named = reading.usage.wholes.names(symbol);
    if let Some(meaning) = constant(symbol, &sorted, reading).filter(|_| !named) {
        return meaning;
    }
    let unmarked = sorted.single.is_none() && sorted.double.is_none() && !symbol.style.vector;
    // The Ω₀ of a turn about one axis is a value that Ω has at some time.
    let at_some_time = reading.plane && matches!(sorted.variant.as_str(), "0" | "i" | "f");
    if unmarked
        && (!at_some_time || reading.usage.moves(symbol))
        && let Some(&(quantity, component)) = reading.components.get(&letter)
    {
        let mut variant = quantity_variant(quantity, &sorted.variant);
        if quantity == Quantity::Inertia && is_main_point(&letter, &variant, reading) {
            variant.clear();
        }
        let entity = quantity_entity(quantity, &variant, &letter.name, atoms);
        return Meaning::Component(entity, component);
    }
    let about = sorted.variant.is_empty() || POINTS.contains(&sorted.variant.as_str());
    let lone = unmarked && about && !symbol.style.bar;
    if lone && let Some(&quantity) = reading.bare.get(&letter) {
        return of_quantity(quantity, &letter, &sorted, atoms);
    }
    if lone && let Some(meaning) = scalar(&letter, reading, atoms) {
        return meaning;
    }
    match reading.quantities.get(&letter) {
        // The law speaks of the force on the particle; others have letters of their own.
        Some(Quantity::Force) if letter.name != "F" => {
            of_symbol(symbol, &letter, &sorted, reading, atoms)
        }
        Some(&quantity)
            if !is_on_turned_axes(&sorted, reading)
                && is_quantity(quantity, symbol, &sorted, reading) =>
        {
            of_quantity(quantity, &letter, &sorted, atoms)
        }
        _ => of_symbol(symbol, &letter, &sorted, reading, atoms),
    }
}

/// Whether a label is that of axes which a matrix of the document turns to: what the symbol is follows from its line.
pub(crate) fn is_on_turned_axes(sorted: &Subscripts, reading: &Reading) -> bool {
    reading.turned_primes && sorted.variant == TURNED
}

/// What a vector's letter stands for where it is written as a number: a component that the document calls so, the
/// magnitude of a momentum or a moment, or else a number of its own.
fn scalar(letter: &Letter, reading: &Reading, atoms: &mut Atoms) -> Option<Meaning> {
    let quantity = *reading.quantities.get(letter)?;
    if !matches!(quantity.shape(), Shape::Vector | Shape::Symmetric) || !reading.is_scalar(letter) {
        return None;
    }
    if let Some(&component) = reading.usage.components_named.get(letter) {
        let entity = quantity_entity(quantity, "", &letter.name, atoms);
        return Some(Meaning::Component(entity, component));
    }
    let latex = latex_name(&letter.name);
    let length = matches!(quantity, Quantity::Momentum | Quantity::Moment)
        || reading.usage.lengths.contains(letter)
        || reading.spin_alone && !reading.usage.numbers.contains(letter);
    let owner = if length {
        Owner::Quantity(quantity, MAGNITUDE.to_owned())
    } else {
        Owner::Symbol(format!("{} number", letter.name))
    };
    let constant = !length && !reading.usage.get(letter).moving;
    Some(Meaning::Whole(atoms.entity(
        &owner,
        Shape::Scalar,
        constant,
        &latex,
    )))
}

/// Unit vectors, the identity and π.
fn constant(symbol: &Symbol, sorted: &Subscripts, reading: &Reading) -> Option<Meaning> {
    let round = reading.round_axes.as_ref();
    if let Some(axis) = round.and_then(|axes| axes.axis(symbol)) {
        return Some(Meaning::UnitVector(axis));
    }
    let marked = symbol.style.hat || symbol.style.vector || reading.is_plain_unit(symbol);
    let axis_of_name = match symbol.name.as_str() {
        "i" | "x" => Some(0),
        "j" | "y" => Some(1),
        "k" | "z" => Some(2),
        _ => None,
    };
    // Beside the triad x̂, ŷ, ẑ a k̂ is a direction of its own.
    let hatted = |name: &str| reading.usage.get(&Letter::plain(name)).hats > 0;
    let beside = hatted("x") && hatted("y") && hatted("z") && !hatted("i") && !hatted("j");
    let is_letter = match symbol.name.as_str() {
        "i" | "j" | "k" => !beside,
        _ => symbol.style.hat || symbol.style.vector && reading.usage.vectors_xyz,
    };
    // Beside e₁, e₂, e₃ a lone k is a direction of its own.
    let alone = symbol.name == "k" && symbol.style.vector && reading.usage.k_alone;
    if marked
        && is_letter
        && !alone
        && sorted.variant.is_empty()
        && sorted.single.is_none()
        && let Some(component) = axis_of_name
    {
        return Some(Meaning::UnitVector(component));
    }
    let named = reading.unit_vectors.as_ref() == Some(&Letter::of(symbol));
    let basis = named || matches!(symbol.name.as_str(), "e" | "b" | "n" | "u" | "E");
    if basis
        && (symbol.style.hat
            || symbol.style.vector
            || reading.numbers_unit_vectors(&Letter::of(symbol)))
        && sorted.variant.is_empty()
        && let Some(component) = sorted.single
    {
        return Some(Meaning::UnitVector(component));
    }
    // What moves or is a vector is no number: the spatial momentum π beside Π.
    let used = reading.usage.get(&Letter::of(symbol));
    let number = symbol.subscripts.is_empty() && !used.moving && used.vector == 0;
    match symbol.name.as_str() {
        "pi" if number => Some(Meaning::Pi),
        "i" if reading.imaginary && is_plain_i(symbol) => Some(Meaning::ImaginaryUnit),
        _ if reading.is_identity(symbol) => Some(Meaning::Identity),
        _ => None,
    }
}

/// Whether a label is that of a state before or behind a step, or, where steps are counted, of the mean of both.
fn is_state(label: &str, reading: &Reading) -> bool {
    let between = ["bar", "m", "mid", "half", "1/2", "+", "*", "^*"];
    step_index(label) || between.contains(&label) && reading.usage.counts_steps()
}

/// Whether this use of the letter is the quantity and not a namesake: a bare Ω in a document whose frame rate is
/// an indexed Ω is still that; an `I_s` is a moment with a name of its own.
fn is_quantity(
    quantity: Quantity,
    symbol: &Symbol,
    sorted: &Subscripts,
    reading: &Reading,
) -> bool {
    let letter = Letter::of(symbol);
    let marked = symbol.style.vector
        || symbol.style.bar
        || sorted.single.is_some()
        || reading.usage.wholes.is_vector(symbol);
    match quantity {
        Quantity::Inertia => sorted.variant.is_empty(),
        Quantity::Energy if step_index(&sorted.variant) => reading.usage.counts_steps(),
        Quantity::Energy | Quantity::Power => !marked && sorted.variant.is_empty(),
        Quantity::RelativeMomentum if reading.spin_alone => sorted.variant.is_empty(),
        // The h_w of a wheel, never marked and without a component, is a number.
        Quantity::RelativeMomentum => {
            let used = reading.usage.get(&letter);
            // Nor is the h_0 beside a marked h one.
            let number = used.vector > 0 && symbol.subscripts == ["0"];
            let vector = used.component > 0
                || reading.usage.is_vector(&letter)
                || reading.crosses_bare_momentum();
            marked || !number && vector
        }
        Quantity::Attitude => sorted.variant.is_empty() && sorted.single.is_none(),
        Quantity::Mass | Quantity::Time => !marked && sorted.variant.is_empty(),
        Quantity::AngularVelocity | Quantity::FrameRate => {
            // ω_n or ω_0 without marks, beside a vector ω, is a scalar of its own.
            sorted.variant.is_empty() || marked || is_state(&sorted.variant, reading)
        }
        Quantity::Momentum if is_state(&sorted.variant, reading) => true,
        Quantity::Momentum | Quantity::Moment => {
            sorted.variant.is_empty()
                || (POINTS.contains(&sorted.variant.as_str())
                    && !another_point(&letter, &sorted.variant, reading))
                || step_index(&sorted.variant)
        }
        // Where vectors have marks, the F_A of a bearing that has none is a number.
        Quantity::Force if reading.usage.letters.values().any(|used| used.vector > 0) => {
            marked || reading.usage.is_vector(&letter)
        }
        _ => marked || reading.usage.is_vector(&letter) || !sorted.variant.is_empty(),
    }
}

fn quantity_variant(quantity: Quantity, variant: &str) -> String {
    if quantity == Quantity::RelativeMomentum {
        return String::new();
    }
    let about_a_point = matches!(
        quantity,
        Quantity::Momentum | Quantity::Moment | Quantity::Energy
    );
    if about_a_point && POINTS.contains(&variant) {
        String::new()
    } else {
        variant.to_owned()
    }
}

/// The entity of a quantity, its variant told by a word.
pub(crate) fn quantity_entity(
    quantity: Quantity,
    variant: &str,
    name: &str,
    atoms: &mut Atoms,
) -> Entity {
    let origin = matches!(variant, "O" | "o" | "0") && quantity == Quantity::Velocity;
    let (quantity, variant) = match quantity {
        _ if origin => (Quantity::OriginVelocity, ""),
        // The velocity of the moving point is the one that the law speaks of.
        Quantity::Velocity if matches!(variant, "P" | "p") => (Quantity::Velocity, ""),
        Quantity::Velocity if variant.is_empty() => (Quantity::Velocity, ANY_POINT),
        _ => (quantity, variant),
    };
    let owner = Owner::Quantity(quantity, variant.to_owned());
    atoms.entity(
        &owner,
        quantity.shape(),
        quantity.constant(),
        &latex_name(name),
    )
}

fn of_quantity(
    quantity: Quantity,
    letter: &Letter,
    sorted: &Subscripts,
    atoms: &mut Atoms,
) -> Meaning {
    let variant = quantity_variant(quantity, &sorted.variant);
    let entity = quantity_entity(quantity, &variant, &letter.name, atoms);
    match (quantity, sorted.single, sorted.double) {
        (Quantity::Inertia, _, Some((row, column))) => {
            let component = match (row.min(column), row.max(column)) {
                (0, 1) => 3,
                (0, 2) => 4,
                (1, 2) => 5,
                (r, _) => r,
            };
            Meaning::Component(entity, component)
        }
        (Quantity::Attitude, _, Some((row, column))) => {
            Meaning::Component(entity, 3 * row + column)
        }
        (_, Some(index), _) => Meaning::Component(entity, index),
        _ => Meaning::Whole(entity),
    }
}

/// The LaTeX of a letter: a command where the name is one.
pub(crate) fn latex_name(name: &str) -> String {
    let one_letter = name.chars().count() == 1;
    let greek = name.chars().all(|c| c.is_ascii_alphabetic())
        && name.chars().any(|c| c.is_ascii_lowercase());
    if one_letter || !greek {
        name.to_owned()
    } else {
        format!("\\{name}")
    }
}
