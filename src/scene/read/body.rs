//! `[[body]]`.

use crate::diagnostic::Diagnostic;
use crate::mechanics::Products;
use crate::motion::MotionError;
use crate::scene::read::inertia::inertia;
use crate::scene::read::reader::{Bound, Reader, Table, span};
use crate::scene::read::shape::shape;
use crate::scene::read::torque::torque;
use crate::scene::read::urdf;
use crate::scene::{Group, InertiaForm, Quantity, TorqueForm};
use crate::source::Span;

pub(super) const KEYS: &[&str] = &[
    "name",
    "inertia",
    "shape",
    "urdf",
    "link",
    "about",
    "products",
    "attitude",
    "angular_velocity",
    "torque",
    "count",
    "seed",
];

/// The longest name of a body, in characters.
const LONGEST_NAME: usize = 200;

const UPRIGHT: [Quantity; 4] = [
    Quantity::Fixed(1.0),
    Quantity::Fixed(0.0),
    Quantity::Fixed(0.0),
    Quantity::Fixed(0.0),
];

/// The group and the place of its name.
pub(super) fn group(reader: &mut Reader, table: &Table<'_>) -> Option<(Group, Span)> {
    let name = name(reader, table);
    let products = match table.get("products") {
        Some(value) => reader.word(
            value,
            "convention of products of inertia",
            &[
                ("integrals", Products::Integrals),
                ("entries", Products::Entries),
            ],
        ),
        None if table.get("urdf").is_some() => Some(Products::Entries),
        None => Some(Products::Integrals),
    };
    let inertia = inertia_of(reader, table);
    let attitude = match table.get("attitude") {
        Some(value) => reader.quantities(value, "the attitude", Bound::Any),
        None => Some(UPRIGHT),
    };
    let velocity = reader.required(table, "angular_velocity");
    let angular_velocity =
        velocity.and_then(|v| reader.quantities(v, "the angular velocity", Bound::Any));
    let torque = match table.get("torque") {
        Some(value) => torque(reader, value),
        None => Some(TorqueForm::None),
    };
    let count = count(reader, table);
    let seed = match table.get("seed") {
        Some(value) => reader.whole(value, "the seed"),
        None => Some(0),
    };
    let (name, name_place) = name?;
    let (inertia, inertia_place) = inertia?;
    let group = Group {
        name,
        inertia_place,
        count: count?,
        seed: seed?,
        inertia,
        products: products?,
        attitude: attitude?,
        angular_velocity: angular_velocity?,
        torque: torque?,
    };
    possible(reader, table, &group)?;
    Some((group, name_place))
}

/// The inertia, of a table, of a shape or of a robot's link, and its place.
fn inertia_of(reader: &mut Reader, table: &Table<'_>) -> Option<(InertiaForm, Span)> {
    let given = ["urdf", "shape", "inertia"]
        .map(|key| table.get(key).map(|value| (key, value)))
        .into_iter()
        .flatten()
        .collect::<Vec<_>>();
    if !given.iter().any(|(key, _)| *key == "urdf") {
        for key in ["link", "about"] {
            if let Some(value) = table.get(key) {
                return reader.wrong(
                    value,
                    format!("`{key}` belongs to `urdf`, which is not there"),
                );
            }
        }
    }
    match given[..] {
        [] => {
            let message = format!("{} needs the key `inertia`", table.what);
            let missing = Diagnostic::error("missing-key", table.span, message);
            reader.report(missing.help("or give it a `shape` with its `kind`, `mass` and sizes"));
            None
        }
        [(key, value)] => {
            let form = match key {
                "urdf" => urdf::link(reader, table, value),
                "shape" => shape(reader, value, "kind"),
                _ => inertia(reader, value),
            };
            Some((form?, span(value.span())))
        }
        [(first, _), (second, value), ..] => {
            let own = match second {
                "inertia" => "an inertia of its own",
                _ => "a shape of its own",
            };
            let message = format!("the body has {own} and the inertia of `{first}`");
            let both = Diagnostic::error("bad-value", span(value.span()), message);
            reader.report(both.help(format!("keep one of `{first}` and `{second}`")));
            None
        }
    }
}

fn name(reader: &mut Reader, table: &Table<'_>) -> Option<(String, Span)> {
    let value = reader.required(table, "name")?;
    let name = reader.text(value, "the name")?;
    if name.trim().is_empty() {
        return reader.wrong(value, "the name is empty");
    }
    if name.chars().count() > LONGEST_NAME || name.chars().any(char::is_control) {
        let message = format!("a name has at most {LONGEST_NAME} characters, on one line");
        return reader.wrong(value, message);
    }
    Some((name.to_owned(), span(value.span())))
}

fn count(reader: &mut Reader, table: &Table<'_>) -> Option<u64> {
    let Some(value) = table.get("count") else {
        return Some(1);
    };
    match reader.whole(value, "the count")? {
        0 => reader.wrong(value, "the count is 0: a group has at least one body"),
        count => Some(count),
    }
}

/// That the first member is one that a body can be; drawn members after it are looked at when they are computed.
fn possible(reader: &mut Reader, table: &Table<'_>, group: &Group) -> Option<()> {
    let first = group
        .shared_body()
        .and_then(|body| group.member(0, body.as_ref()));
    let error = first.err();
    let Some(error) = error else {
        return Some(());
    };
    let place = match error {
        MotionError::ZeroAttitude => table.get("attitude").map(|v| span(v.span())),
        _ => Some(group.inertia_place),
    };
    let code = match error {
        MotionError::ZeroAttitude => "bad-value",
        _ => "impossible-inertia",
    };
    let place = place.unwrap_or(table.span);
    reader.report(Diagnostic::error(code, place, error.to_string()));
    None
}
