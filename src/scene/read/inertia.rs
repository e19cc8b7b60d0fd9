//! `inertia`.

use crate::diagnostic::Diagnostic;
use crate::scene::read::reader::{Bound, Reader, Value};
use crate::scene::read::shape::shape;
use crate::scene::{InertiaForm, Point, Quantity};

pub(super) const ZERO: Quantity = Quantity::Fixed(0.0);

/// The most point masses of a body.
const MOST_POINTS: usize = 100_000;

/// The points that a tensor can be about, and whether that is the origin of the positions.
pub(super) const POINTS: &[(&str, bool)] = &[("centre", false), ("origin", true)];

const FORMS: &str = "an inertia is { xx, yy, zz, xy, xz, yz }, { principal = […] }, { shape = \"…\", mass, … } or \
                     { points = […] }";

pub(super) fn inertia(reader: &mut Reader, value: &Value<'_>) -> Option<InertiaForm> {
    let Some(entries) = value.get_ref().as_table() else {
        return reader.wrong(value, FORMS);
    };
    let has = |key: &str| entries.contains_key(key);
    if has("principal") {
        principal(reader, value)
    } else if has("shape") {
        shape(reader, value, "shape")
    } else if has("points") {
        points(reader, value)
    } else {
        tensor(reader, value)
    }
}

fn tensor(reader: &mut Reader, value: &Value<'_>) -> Option<InertiaForm> {
    let table = reader.table(value, "an inertia", &["xx", "yy", "zz", "xy", "xz", "yz"])?;
    if table.entries.is_empty() {
        let empty = Diagnostic::error("missing-key", table.span, "the inertia is empty");
        reader.report(empty.help(FORMS));
        return None;
    }
    let moments = ["xx", "yy", "zz"].map(|key| {
        let value = reader.required(&table, key)?;
        reader.quantity(value, &format!("I_{key}"), Bound::Any)
    });
    let products = ["xy", "xz", "yz"].map(|key| match table.get(key) {
        Some(value) => reader.quantity(value, &format!("I_{key}"), Bound::Any),
        None => Some(ZERO),
    });
    Some(InertiaForm::Tensor {
        moments: three(moments)?,
        products: three(products)?,
    })
}

fn principal(reader: &mut Reader, value: &Value<'_>) -> Option<InertiaForm> {
    let table = reader.table(value, "a principal inertia", &["principal", "axes"])?;
    let moments = reader.required(&table, "principal")?;
    let moments = reader.quantities(moments, "the principal moments", Bound::Positive);
    let axes = match table.get("axes") {
        Some(value) => reader.quantities(value, "the axes", Bound::Any),
        None => Some([Quantity::Fixed(1.0), ZERO, ZERO, ZERO]),
    };
    Some(InertiaForm::Principal {
        moments: moments?,
        axes: axes?,
    })
}

fn points(reader: &mut Reader, value: &Value<'_>) -> Option<InertiaForm> {
    let table = reader.table(value, "an inertia of points", &["points", "about"])?;
    let about_origin = match table.get("about") {
        Some(value) => reader.word(value, "point of reference", POINTS),
        None => Some(false),
    };
    let value = reader.required(&table, "points")?;
    let list = reader.list(value, "the points")?;
    if list.len() > MOST_POINTS {
        return reader.wrong(value, format!("a body has at most {MOST_POINTS} points"));
    }
    let points: Option<Vec<_>> = list.iter().map(|value| point(reader, value)).collect();
    Some(InertiaForm::Points {
        points: points?,
        about_origin: about_origin?,
    })
}

fn point(reader: &mut Reader, value: &Value<'_>) -> Option<Point> {
    let table = reader.table(value, "a point", &["mass", "position"])?;
    let mass = reader.required(&table, "mass")?;
    let mass = reader.quantity(mass, "the mass", Bound::Positive);
    let position = reader.required(&table, "position")?;
    let position = reader.quantities(position, "the position", Bound::Any);
    Some(Point {
        mass: mass?,
        position: position?,
    })
}

fn three(found: [Option<Quantity>; 3]) -> Option<[Quantity; 3]> {
    let [x, y, z] = found;
    Some([x?, y?, z?])
}
