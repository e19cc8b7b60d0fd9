//! What words call a quantity, and where they stand beside a letter.

use crate::verify::quantity::Quantity;

/// Phrases and what they name; the longer stand before the shorter.
const PHRASES: &[(&str, Option<Quantity>)] = &[
    ("moment of momentum", Some(Quantity::Momentum)),
    (
        "relative angular momentum",
        Some(Quantity::RelativeMomentum),
    ),
    ("relative momentum", Some(Quantity::RelativeMomentum)),
    ("wheel momentum", Some(Quantity::RelativeMomentum)),
    ("rotor momentum", Some(Quantity::RelativeMomentum)),
    ("wheel angular momentum", Some(Quantity::RelativeMomentum)),
    ("momentum of the wheel", Some(Quantity::RelativeMomentum)),
    ("momentum of the rotor", Some(Quantity::RelativeMomentum)),
    ("momentum of the flywheel", Some(Quantity::RelativeMomentum)),
    ("angular momentum", Some(Quantity::Momentum)),
    ("linear momentum", Some(Quantity::LinearMomentum)),
    ("kinetic energy", Some(Quantity::Energy)),
    ("rotational energy", Some(Quantity::Energy)),
    ("energy", Some(Quantity::Energy)),
    ("products of inertia", Some(Quantity::Inertia)),
    ("product of inertia", Some(Quantity::Inertia)),
    ("moments of inertia", Some(Quantity::Inertia)),
    ("moment of inertia", Some(Quantity::Inertia)),
    ("principal moments", Some(Quantity::Inertia)),
    ("inertia matrix", Some(Quantity::Inertia)),
    ("inertia tensor", Some(Quantity::Inertia)),
    ("angular acceleration", Some(Quantity::AngularAcceleration)),
    ("precession rate", None),
    ("body rates", Some(Quantity::AngularVelocity)),
    ("angular velocity of the axes", Some(Quantity::FrameRate)),
    ("angular velocity of the frame", Some(Quantity::FrameRate)),
    ("turns with angular velocity", Some(Quantity::FrameRate)),
    ("turns with the angular velocity", Some(Quantity::FrameRate)),
    ("turns with an angular velocity", Some(Quantity::FrameRate)),
    ("turn with angular velocity", Some(Quantity::FrameRate)),
    ("turn with the angular velocity", Some(Quantity::FrameRate)),
    ("turn with an angular velocity", Some(Quantity::FrameRate)),
    ("rotates with angular velocity", Some(Quantity::FrameRate)),
    (
        "rotates with the angular velocity",
        Some(Quantity::FrameRate),
    ),
    (
        "rotates with an angular velocity",
        Some(Quantity::FrameRate),
    ),
    ("rotate with angular velocity", Some(Quantity::FrameRate)),
    (
        "rotate with the angular velocity",
        Some(Quantity::FrameRate),
    ),
    ("rotate with an angular velocity", Some(Quantity::FrameRate)),
    ("rotating with angular velocity", Some(Quantity::FrameRate)),
    (
        "rotating with the angular velocity",
        Some(Quantity::FrameRate),
    ),
    (
        "rotating with an angular velocity",
        Some(Quantity::FrameRate),
    ),
    ("turning with angular velocity", Some(Quantity::FrameRate)),
    (
        "turning with the angular velocity",
        Some(Quantity::FrameRate),
    ),
    (
        "turning with an angular velocity",
        Some(Quantity::FrameRate),
    ),
    ("angular velocity", Some(Quantity::AngularVelocity)),
    ("torque", Some(Quantity::Moment)),
    ("moment", Some(Quantity::Moment)),
    ("couple", Some(Quantity::Moment)),
    ("force", Some(Quantity::Force)),
    ("mass centre", None),
    ("mass center", None),
    ("power", Some(Quantity::Power)),
];

/// The quantity that the words before a formula name, where they come close to it.
pub(super) fn said_before(text: &str) -> Option<Quantity> {
    let near = |(phrase, quantity): &(&str, Option<Quantity>)| {
        let at = text.rfind(phrase)?;
        Some((at + phrase.len(), phrase.len(), *quantity))
    };
    let (end, _, quantity) = PHRASES
        .iter()
        .filter_map(near)
        .max_by_key(|&(end, len, _)| (end, len))?;
    (text.len() - end < 60).then_some(quantity)?
}

/// The quantity in words set right behind a letter: "and $\mathbf K$ the total torque".
pub(super) fn apposition(text: &str, near: bool) -> Option<Quantity> {
    let text = text.strip_prefix(' ').filter(|_| near)?;
    let rest = ["the ", "its "]
        .iter()
        .find_map(|lead| text.strip_prefix(lead))?;
    let rest = ["total ", "resultant ", "external ", "net "]
        .iter()
        .find_map(|word| rest.strip_prefix(word))
        .unwrap_or(rest);
    let found = PHRASES
        .iter()
        .filter(|(phrase, _)| rest.starts_with(phrase));
    found.max_by_key(|(phrase, _)| phrase.len())?.1
}

/// The quantity that the words right after a letter name: "is the angular momentum".
pub(super) fn said_after(text: &str) -> Option<Quantity> {
    let text = text
        .trim_start()
        .trim_start_matches([',', ';'])
        .trim_start();
    let rest = [
        "is the ",
        "is its ",
        "are the ",
        "denotes the ",
        "be the ",
        "represents the ",
        "is called the ",
        "for the ",
    ]
    .iter()
    .find_map(|lead| text.strip_prefix(lead))?;
    let near = |(phrase, quantity): &(&str, Option<Quantity>)| {
        let at = rest.find(phrase)?;
        (at < 30).then_some((at, std::cmp::Reverse(phrase.len()), *quantity))
    };
    PHRASES
        .iter()
        .filter_map(near)
        .min_by_key(|&(at, len, _)| (at, len))?
        .2
}
