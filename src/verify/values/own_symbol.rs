//! Symbols of the document's own: the theory does not know them, and how they are used tells what they are.

use crate::notation::ast::Symbol;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::Letter;
use crate::verify::values::atoms::{Atoms, Owner};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::subscript::{Subscripts, subscripts};
use crate::verify::values::symbol::{Meaning, is_on_turned_axes, latex_name};

/// A symbol that the theory does not know.
pub(crate) fn of_symbol(
    symbol: &Symbol,
    letter: &Letter,
    sorted: &Subscripts,
    reading: &Reading,
    atoms: &mut Atoms,
) -> Meaning {
    let used = reading.usage.get(letter);
    // An unmarked letter of a quantity with a word for an index (ω_m, T_s) is a number of its own.
    let of_quantity =
        reading.quantities.contains_key(letter) || reading.components.contains_key(letter);
    let named = !sorted.variant.is_empty() && of_quantity;
    // The same vector on turned axes is one.
    let turned = is_on_turned_axes(sorted, reading);
    let always_hatted =
        symbol.style.hat && used.bare == used.hats && letter.name.chars().count() == 1;
    // Beside the unit vector x̂ an x is a coordinate.
    let axis_letter = matches!(letter.name.as_str(), "x" | "y" | "z");
    let coordinate = axis_letter && used.vector == used.hatted;
    let is_vector = reading.usage.is_vector(letter) && !coordinate;
    let marks = symbol.style.vector
        || always_hatted
        || (symbol.style.bar && sorted.single.is_some())
        || reading.usage.wholes.is_vector(symbol)
        || sorted.of_named && reading.quantities.get(letter) != Some(&Quantity::Inertia)
        || (is_vector && (!named || turned) && !reading.is_scalar(letter))
        || used.component > 1 && sorted.single.is_some();
    // A letter that some line sets against a square of numbers is a matrix before that line too.
    let square = used.tensor > 0 && symbol.subscripts.is_empty() && symbol.superscripts.is_empty();
    let tensor = symbol.style.tensor
        || sorted.double.is_some()
        || square && !symbol.style.vector
        || symbol.style.vector && reading.usage.applied.contains(letter)
        || reading.usage.wholes.is_grid(symbol) && !sorted.variant.is_empty()
        || has_entries(letter, sorted, reading)
        || symbol.style.vector
            && sorted.single.is_none()
            && used.double > 0
            && used.component == 0
            && letter.name.starts_with(char::is_uppercase);
    let entry = used.tensor > 0
        && sorted
            .double
            .is_some_and(|(row, column)| row.max(column) < 2);
    let size = reading.usage.squares.get(letter);
    let size = size.filter(|_| square || entry);
    let shape = if let Some(&rows) = size {
        Shape::Grid(rows, rows)
    } else if tensor {
        Shape::Matrix
    } else if marks {
        Shape::Vector
    } else {
        Shape::Scalar
    };
    let mut key = format!(
        "{}{}",
        letter.name,
        if letter.calligraphic {
            " calligraphic"
        } else {
            ""
        }
    );
    // The components of a unit vector ĉ are written c₁, c₂, c₃.
    let only_hatted = marks && used.bare == used.hats && used.vector == used.hatted;
    if (symbol.style.hat && !only_hatted) || symbol.style.tilde {
        key.push_str(if symbol.style.hat { " hat" } else { " tilde" });
    }
    if !sorted.variant.is_empty() {
        key = format!("{key} {}", sorted.variant);
    }
    let index = if shape == Shape::Scalar {
        sorted.single
    } else {
        None
    };
    if let Some(index) = index {
        key = format!("{key} _{index}");
    }
    let mut latex = latex_name(&letter.name);
    if !symbol.subscripts.is_empty() && (shape == Shape::Scalar || !sorted.variant.is_empty()) {
        latex = format!("{latex}_{{{}}}", symbol.subscripts.join(","));
    }
    let entity = atoms.entity(
        &Owner::Symbol(format!("{key} {shape:?}")),
        shape,
        if named || reading.usage.is_labelled(letter) || is_value(&sorted.variant) {
            !reading.usage.moves(symbol)
        } else {
            !used.moving
        },
        &latex,
    );
    match (shape, sorted.single, sorted.double) {
        (Shape::Vector, Some(index), _) => Meaning::Component(entity, index),
        (Shape::Matrix, _, Some((row, column))) => Meaning::Component(entity, 3 * row + column),
        (Shape::Grid(rows, _), _, Some((row, column))) if entry => {
            Meaning::Component(entity, rows * row + column)
        }
        _ => Meaning::Whole(entity),
    }
}

/// Whether the entries of a tensor with the same label are written somewhere: `I_{s,xx}` of `I_s`.
fn has_entries(letter: &Letter, sorted: &Subscripts, reading: &Reading) -> bool {
    let inertia = reading.quantities.get(letter) == Some(&Quantity::Inertia);
    let whole = sorted.single.is_none() && sorted.double.is_none() && !sorted.variant.is_empty();
    let mut entries = reading.usage.entries.iter();
    inertia
        && whole
        && entries.any(|entry| {
            Letter::of(entry) == *letter && {
                let other = subscripts(entry, reading);
                other.double.is_some() && other.variant == sorted.variant
            }
        })
}

/// Whether a label makes of what moves one of its values: the amplitude φ₀ of φ.
fn is_value(label: &str) -> bool {
    matches!(label, "0" | "m" | "max" | "min" | "eq")
}
