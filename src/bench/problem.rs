//! Motions on which methods are compared.

use crate::motion::{Body, MotionError, State, Torque};
use crate::scene::{Member, Scene};
use nalgebra::{Matrix3, Vector3};

/// A motion that methods are held against.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// A short name, as the command line and file names have it.
    pub name: String,
    /// One line about it.
    pub about: String,
    /// The body, its start and its torque.
    pub member: Member,
    /// s.
    pub duration: f64,
}

impl Problem {
    fn new(
        name: &str,
        about: &str,
        moments: [f64; 3],
        omega: [f64; 3],
        torque: Torque,
        duration: f64,
    ) -> Result<Self, MotionError> {
        Ok(Self {
            name: name.to_owned(),
            about: about.to_owned(),
            member: Member {
                body: Body::new(&Matrix3::from_diagonal(&moments.into()))?,
                start: State::new([1.0, 0.0, 0.0, 0.0], omega)?,
                torque,
            },
            duration,
        })
    }
}

/// The problems that `polhode bench` comes with.
///
/// # Errors
/// None for these bodies.
pub fn problems() -> Result<Vec<Problem>, MotionError> {
    let (general, free) = ([0.6, 0.8, 1.0], [3.0, 0.5, -0.9]);
    let top = |weight: f64| Torque::Gravity {
        weight,
        arm: Vector3::new(0.1, -0.2, 1.0),
    };
    Ok(vec![
        Problem::new(
            "free",
            "free body, five turns",
            general,
            free,
            Torque::None,
            10.0,
        )?,
        Problem::new(
            "separatrix",
            "free body spun about its middle axis, 1e-6 off: it flips over",
            [2.0, 3.0, 4.0],
            [0.0, 3.0, 3e-6],
            Torque::None,
            20.0,
        )?,
        Problem::new(
            "top",
            "heavy top",
            general,
            [1.0, -2.0, 8.0],
            top(1.0),
            10.0,
        )?,
        Problem::new(
            "damped",
            "tumbling body, damped",
            general,
            free,
            Torque::Damping { coefficient: 0.1 },
            10.0,
        )?,
        Problem::new(
            "needle",
            "heavy top, one moment a thousandth of the others",
            [1e-3, 1.0, 1.0],
            [20.0, 0.5, -0.4],
            Torque::Gravity {
                weight: 1.0,
                arm: Vector3::new(1e-3, 0.0, 0.0),
            },
            2.0,
        )?,
    ])
}

/// The first member of each body of a scene, as problems.
///
/// # Errors
/// A body that cannot be.
pub fn problems_of(scene: &Scene) -> Result<Vec<Problem>, MotionError> {
    let groups = scene.groups.iter();
    groups
        .map(|group| {
            let shared = group.shared_body()?;
            Ok(Problem {
                name: group.name.clone(),
                about: "from the scene".to_owned(),
                member: group.member(0, shared.as_ref())?,
                duration: scene.run.duration,
            })
        })
        .collect()
}
