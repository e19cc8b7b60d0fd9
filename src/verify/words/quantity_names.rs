//! The names of quantities.

use crate::verify::values::quantity::Quantity;
use crate::verify::words::book::Book;
use std::sync::LazyLock;

/// What the phrases for a quantity name; `None` keeps a phrase from being read as a shorter one in it.
const NAMES: &[(Option<Quantity>, &[&str])] = &[
    (
        Some(Quantity::RelativeMomentum),
        &[
            "relative angular momentum",
            "relative momentum",
            "wheel momentum",
            "rotor momentum",
            "wheel angular momentum",
            "momentum of the wheel",
            "momentum of the rotor",
            "momentum of the flywheel",
            "momentum of the wheels",
            "momentum of the rotors",
            "wheel's momentum",
            "wheel's angular momentum",
            "rotor's momentum",
            "rotor's angular momentum",
            "momentum relative to the body",
            "momentum relative to the satellite",
            "momentum relative to the spacecraft",
            "momentum relative to the platform",
            "momentum relative to the housing",
            "momentum relative to the carrier",
            "spin momentum",
            "spin angular momentum",
            "spin part of the angular momentum",
            "stored momentum",
            "internal momentum",
            "extra momentum",
        ],
    ),
    (
        Some(Quantity::Momentum),
        &[
            "moment of momentum",
            "angular momentum",
            "kinetic moment",
            "momentum",
            "moment cinétique",
            "moment cinetique",
        ],
    ),
    (Some(Quantity::LinearMomentum), &["linear momentum"]),
    (
        Some(Quantity::Energy),
        &[
            "kinetic energy",
            "rotational energy",
            "energy",
            "hamiltonian",
        ],
    ),
    (
        Some(Quantity::Inertia),
        &[
            "products of inertia",
            "product of inertia",
            "moments of inertia",
            "moment of inertia",
            "principal moments",
            "inertia matrix",
            "inertia tensor",
        ],
    ),
    (
        Some(Quantity::AngularAcceleration),
        &["angular acceleration"],
    ),
    (
        Some(Quantity::FrameRate),
        &[
            "angular velocity of the axes",
            "angular velocity of the frame",
        ],
    ),
    (
        Some(Quantity::AngularVelocity),
        &["body rates", "angular velocity"],
    ),
    (
        Some(Quantity::Moment),
        &[
            "torque",
            "moment",
            "couple",
            "moment of force",
            "moment of the force",
            "moment of all force",
            "moment of applied force",
            "moment of the applied force",
            "moment of external force",
            "moment of the external force",
            "moment of all external force",
        ],
    ),
    // What drives the wheels acts on the body the other way round.
    (
        None,
        &[
            "motor torque",
            "wheel torque",
            "torque of the motor",
            "torque on the wheel",
            "torque on the rotor",
            "torques of the motors",
            "torque that the wheels exert",
            "torque which the wheels exert",
            "torque that the wheel exerts",
            "torque exerted by the wheels",
            "torque exerted by the wheel",
            "torque of the wheels",
            "torque from the wheels",
            "torque by the wheels",
            "reaction torque",
        ],
    ),
    (Some(Quantity::Force), &["force"]),
    (Some(Quantity::Power), &["power"]),
    (Some(Quantity::Mass), &["mass"]),
    (Some(Quantity::Acceleration), &["acceleration"]),
    (
        None,
        &[
            "precession rate",
            "magnetic moment",
            "dipole moment",
            "bending moment",
            "mass centre",
            "mass center",
            "moment of the impulse",
            "moment of the blow",
            "potential energy",
            "total energy",
            "lagrangian",
            "gravitational acceleration",
            "acceleration of gravity",
            "acceleration due to gravity",
        ],
    ),
];

/// How something is said to turn: "rotates with the angular velocity".
const TURNING: &[&str] = &["turn", "turns", "turning", "rotate", "rotates", "rotating"];

/// Phrases and what they name.
pub(crate) static PHRASES: LazyLock<Vec<(String, Option<Quantity>)>> = LazyLock::new(|| {
    let named = NAMES
        .iter()
        .flat_map(|(quantity, phrases)| phrases.iter().map(|p| (p.to_string(), *quantity)));
    let turning = TURNING.iter().flat_map(|verb| {
        ["", "the ", "an "].map(|article| {
            let phrase = format!("{verb} with {article}angular velocity");
            (phrase, Some(Quantity::FrameRate))
        })
    });
    named.chain(turning).collect()
});

/// The book of them, in the same order.
pub(crate) static BOOK: LazyLock<Book> =
    LazyLock::new(|| Book::of(PHRASES.iter().map(|(phrase, _)| phrase)));

/// The bytes of the longest.
pub(crate) static LONGEST: LazyLock<usize> =
    LazyLock::new(|| PHRASES.iter().map(|(p, _)| p.len()).max().unwrap_or(0));

/// Whether a phrase that stands at a place is whole words, a plural included: not the "moment" of "momentum", nor the
/// "torque" of "torque-free".
pub(crate) fn is_word(text: &str, at: usize, phrase: &str) -> bool {
    let letter = |c: Option<char>| c.is_some_and(char::is_alphabetic);
    let rest = &text[at + phrase.len()..];
    let rest = rest.strip_prefix('s').unwrap_or(rest);
    let absent = rest.starts_with("-free") || rest.starts_with(" free ");
    !absent && !letter(text[..at].chars().next_back()) && !letter(rest.chars().next())
}
