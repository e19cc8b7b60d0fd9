//! Uniform bodies by name and sizes: `shape = { kind = … }`, and `inertia = { shape = … }`.

use crate::diagnostic::Diagnostic;
use crate::mechanics::{Shape, Size};
use crate::scene::read::inertia::ZERO;
use crate::scene::read::reader::{Bound, Reader, Table, Value};
use crate::scene::{InertiaForm, Quantity};

/// The shape that the key `kind` of a table names, with its mass, its sizes and the offset of the point that it turns about.
pub(super) fn shape(
    reader: &mut Reader,
    value: &Value<'_>,
    kind: &'static str,
) -> Option<InertiaForm> {
    // The kind says which keys there can be, so it is looked at first.
    let Some(name) = value.get_ref().get(kind) else {
        let keys: Vec<_> = given(value).collect();
        let table = reader.table(value, "a shape", &keys)?;
        reader.required(&table, kind)?;
        return None;
    };
    let words: Vec<_> = Shape::all().map(|shape| (shape.name(), shape)).collect();
    let named = reader.word(name, "shape", &words)?;
    let has = |key| value.get_ref().get(key).is_some();
    let shape = if named.name() == "rod" && has("radius") {
        Shape::by_name("thick rod").unwrap_or(named)
    } else {
        named
    };
    let keys: Vec<_> = shape.sizes().iter().map(key).collect();
    let known: Vec<_> = [kind, "mass", "offset"]
        .into_iter()
        .chain(keys.iter().map(String::as_str))
        .collect();
    let table = reader.table(value, "an inertia of this shape", &known)?;
    if shape.name() == "rod" {
        let message = "a rod without thickness has no moment about its own axis";
        let thin = Diagnostic::error("missing-key", table.span, message);
        reader.report(thin.help("give its `radius`"));
        return None;
    }
    let mass = reader.required(&table, "mass");
    let mass = mass.and_then(|value| reader.quantity(value, "the mass", Bound::Positive));
    let sizes = sizes(reader, &table, shape);
    let offset = match table.get("offset") {
        Some(value) => reader.quantities(value, "the offset", Bound::Any),
        None => Some([ZERO; 3]),
    };
    Some(InertiaForm::Shape {
        shape,
        sizes: sizes?,
        mass: mass?,
        offset: offset?,
    })
}

/// The keys that a table has: without its kind none of them is wrong.
fn given<'a>(value: &'a Value<'_>) -> impl Iterator<Item = &'a str> {
    let entries = value.get_ref().as_table().into_iter();
    entries.flat_map(|table| table.keys().map(|key| key.get_ref().as_ref()))
}

/// The key of a size: its name with `_` between the words.
fn key(size: &Size) -> String {
    size.name.replace([' ', '-'], "_")
}

/// The numbers of all sizes, one after another.
fn sizes(reader: &mut Reader, table: &Table<'_>, shape: Shape) -> Option<Vec<Quantity>> {
    let each: Vec<_> = shape
        .sizes()
        .iter()
        .map(|of| size(reader, table, of))
        .collect();
    let numbers: Vec<_> = each.into_iter().collect::<Option<Vec<_>>>()?.concat();
    if let [Quantity::Fixed(inner), Quantity::Fixed(outer), ..] = numbers[..]
        && let Some(value) = table.get("inner_radius")
        && inner > outer
    {
        let message = format!("the inner radius is {inner}, and the outer radius is {outer}");
        return reader.wrong(value, message + ": the inner one has to be the smaller");
    }
    Some(numbers)
}

fn size(reader: &mut Reader, table: &Table<'_>, size: &Size) -> Option<Vec<Quantity>> {
    let value = reader.required(table, &key(size))?;
    let what = format!("the {}", size.name);
    let bound = if size.is_place {
        Bound::Any
    } else {
        Bound::Positive
    };
    if size.count == 1 {
        return reader.quantity(value, &what, bound).map(|one| vec![one]);
    }
    reader.components(value, &what, size.count, bound)
}
