//! `torque`.

use crate::motion::Frame;
use crate::scene::read::reader::{Bound, Reader, Table, Value};
use crate::scene::{Quantity, TorqueForm};

const KINDS: [(&str, &[&str]); 5] = [
    ("none", &[]),
    ("constant", &["frame", "value"]),
    ("gravity", &["weight", "arm"]),
    ("damping", &["coefficient"]),
    (
        "sinusoid",
        &["frame", "amplitude", "angular_frequency", "phase"],
    ),
];

pub(super) fn torque(reader: &mut Reader, value: &Value<'_>) -> Option<TorqueForm> {
    // The kind says which keys there can be, so it is looked at first.
    let Some(kind) = value.get_ref().get("kind") else {
        let table = reader.table(value, "a torque", &["kind"])?;
        reader.required(&table, "kind")?;
        return None;
    };
    let names = KINDS.map(|(name, keys)| (name, (name, keys)));
    let (name, keys) = reader.word(kind, "kind of torque", &names)?;
    let table = reader.table(value, "a torque of this kind", &[&["kind"], keys].concat())?;
    match name {
        "none" => Some(TorqueForm::None),
        "constant" => {
            let (frame, value) = (frame(reader, &table), vector(reader, &table, "value"));
            Some(TorqueForm::Constant {
                frame: frame?,
                value: value?,
            })
        }
        "gravity" => {
            let weight = number(reader, &table, "weight", Bound::NotNegative);
            let arm = vector(reader, &table, "arm");
            Some(TorqueForm::Gravity {
                weight: weight?,
                arm: arm?,
            })
        }
        "damping" => number(reader, &table, "coefficient", Bound::NotNegative)
            .map(|coefficient| TorqueForm::Damping { coefficient }),
        _ => {
            let (frame, amplitude) = (frame(reader, &table), vector(reader, &table, "amplitude"));
            let frequency = number(reader, &table, "angular_frequency", Bound::Any);
            let phase = match table.get("phase") {
                Some(value) => reader.quantity(value, "the phase", Bound::Any),
                None => Some(Quantity::Fixed(0.0)),
            };
            Some(TorqueForm::Sinusoid {
                frame: frame?,
                amplitude: amplitude?,
                angular_frequency: frequency?,
                phase: phase?,
            })
        }
    }
}

fn frame(reader: &mut Reader, table: &Table<'_>) -> Option<Frame> {
    match table.get("frame") {
        Some(value) => reader.word(
            value,
            "frame",
            &[("body", Frame::Body), ("space", Frame::Space)],
        ),
        None => Some(Frame::Body),
    }
}

fn number(reader: &mut Reader, table: &Table<'_>, key: &str, bound: Bound) -> Option<Quantity> {
    let value = reader.required(table, key)?;
    reader.quantity(value, &format!("the {}", key.replace('_', " ")), bound)
}

fn vector(reader: &mut Reader, table: &Table<'_>, key: &str) -> Option<[Quantity; 3]> {
    let value = reader.required(table, key)?;
    reader.quantities(value, &format!("the {key} of the torque"), Bound::Any)
}
