//! The equation, and the ways in which it is often written wrong.

use super::finding::{Finding, Gyroscopic, Where};
use crate::mechanics::angular_acceleration;
use nalgebra::{Matrix3, Vector3};

/// A motion at an instant: ω and torque in body axes, and the rotation matrix of the attitude.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instant {
    pub(super) attitude: Matrix3<f64>,
    pub(super) omega: Vector3<f64>,
    pub(super) torque: Vector3<f64>,
}

/// An equation of motion with no slip or some.
#[derive(Clone, Debug)]
pub(super) struct Model {
    pub(super) slips: Vec<Finding>,
    gyroscopic: f64,
    /// The tensor in ω × Iω and in the inverse.
    tensors: [Tensor; 2],
    torque: Torque,
    space: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Tensor {
    Whole,
    Diagonal,
    Negated,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Torque {
    Body,
    Negated,
    Ignored,
    Turned,
    TurnedBack,
}

/// All models, those with fewer slips first. Those that need an attitude only where one is known.
pub(super) fn models(with_attitude: bool) -> Vec<Model> {
    let mut found = vec![];
    for gyroscopic in [1.0, 0.0, -1.0, 2.0, 0.5] {
        for tensors in pairs([Tensor::Whole, Tensor::Diagonal, Tensor::Negated]) {
            for torque in [
                Torque::Body,
                Torque::Negated,
                Torque::Ignored,
                Torque::Turned,
                Torque::TurnedBack,
            ] {
                for space in [false, true] {
                    let turned = matches!(torque, Torque::Turned | Torque::TurnedBack);
                    if !with_attitude && (turned || space) {
                        continue;
                    }
                    let slips = slips(gyroscopic, tensors, torque, space);
                    found.push(Model {
                        slips,
                        gyroscopic,
                        tensors,
                        torque,
                        space,
                    });
                }
            }
        }
    }
    found.sort_by_key(|model| model.slips.len());
    found
}

fn pairs<T: Copy>(of: [T; 3]) -> impl Iterator<Item = [T; 2]> {
    (0..9).map(move |i| [of[i / 3], of[i % 3]])
}

fn slips(gyroscopic: f64, tensors: [Tensor; 2], torque: Torque, space: bool) -> Vec<Finding> {
    let mut slips = vec![];
    let slip = [
        (0.0, Gyroscopic::Missing),
        (-1.0, Gyroscopic::Negated),
        (2.0, Gyroscopic::Doubled),
        (0.5, Gyroscopic::Halved),
    ];
    let slip = slip
        .iter()
        .find(|(factor, _)| (factor - gyroscopic).abs() < 0.1);
    slips.extend(slip.map(|(_, slip)| Finding::Gyroscopic(*slip)));
    let told = |tensor: Tensor, place: Where| match tensor {
        Tensor::Whole => None,
        Tensor::Diagonal => Some(Finding::DiagonalOnly(place)),
        Tensor::Negated => Some(Finding::ProductsNegated(place)),
    };
    let [term, inverse] = tensors;
    if term == inverse {
        slips.extend(told(term, Where::Everywhere));
    } else {
        slips.extend(told(term, Where::Gyroscopic));
        slips.extend(told(inverse, Where::Inverse));
    }
    slips.extend(match torque {
        Torque::Body => None,
        Torque::Negated => Some(Finding::TorqueNegated),
        Torque::Ignored => Some(Finding::TorqueIgnored),
        Torque::Turned | Torque::TurnedBack => Some(Finding::TorqueInOtherAxes),
    });
    if space {
        slips.push(Finding::TensorInSpaceAxes);
    }
    slips
}

impl Tensor {
    fn of(self, inertia: &Matrix3<f64>) -> Matrix3<f64> {
        let products = match self {
            Self::Whole => 1.0,
            Self::Diagonal => 0.0,
            Self::Negated => -1.0,
        };
        Matrix3::from_fn(|r, c| inertia[(r, c)] * if r == c { 1.0 } else { products })
    }
}

impl Model {
    /// The angular acceleration, body axes, or `None` where the model's tensor has no inverse.
    pub(super) fn acceleration(&self, inertia: &Matrix3<f64>, at: &Instant) -> Vector3<f64> {
        let [term, inverse] = self.tensors.map(|tensor| tensor.of(inertia));
        let torque = match self.torque {
            Torque::Body => at.torque,
            Torque::Negated => -at.torque,
            Torque::Ignored => Vector3::zeros(),
            Torque::Turned => at.attitude * at.torque,
            Torque::TurnedBack => at.attitude.tr_mul(&at.torque),
        };
        let euler = |omega: &Vector3<f64>, torque: &Vector3<f64>| {
            let term = omega.cross(&(term * omega)) * self.gyroscopic;
            // At rest: the inverse alone.
            angular_acceleration(&inverse, &Vector3::zeros(), &(torque - term))
        };
        if self.space {
            let [omega, torque] = [at.omega, torque].map(|v| at.attitude * v);
            at.attitude.tr_mul(&euler(&omega, &torque))
        } else {
            euler(&at.omega, &torque)
        }
    }
}

/// Eight instants in general position: ω and torque so large that each term of the equation counts.
pub(super) fn instants(inertia: &Matrix3<f64>, speed: f64) -> Vec<Instant> {
    use crate::motion::Quaternion;
    // The golden ratio and its like: far from every symmetry.
    let wave = |k: usize, i: usize| (1.618_034 * (3 * k + i + 1) as f64 + 0.3).sin();
    let vector = |k: usize| Vector3::from_fn(|i, _| wave(k, i));
    (0..8)
        .map(|k| {
            let omega = vector(3 * k).normalize() * speed;
            let size = (inertia * omega).norm() * speed;
            Instant {
                attitude: Quaternion::exp(&(vector(3 * k + 1) * 1.5)).matrix(),
                omega,
                torque: vector(3 * k + 2).normalize() * size,
            }
        })
        .collect()
}

/// The model with the fewest slips that gives these accelerations within a part `tolerance` of the largest, and how far off the
/// right one is if there is none.
pub(super) fn identify(
    inertia: &Matrix3<f64>,
    seen: &[(Instant, Vector3<f64>)],
    tolerance: f64,
    with_attitude: bool,
) -> Result<Model, f64> {
    let off = |model: &Model| {
        let size = |v: Vector3<f64>| v.norm();
        let pairs = seen
            .iter()
            .map(|(at, seen)| (model.acceleration(inertia, at), seen));
        let (mut off, mut largest) = (0.0_f64, 0.0_f64);
        for (told, seen) in pairs {
            let apart = size(told - seen);
            off = if apart.is_finite() {
                off.max(apart)
            } else {
                f64::INFINITY
            };
            largest = largest.max(size(told)).max(size(*seen));
        }
        if off > 0.0 { off / largest } else { 0.0 }
    };
    let models = models(with_attitude);
    let right = models.first().map_or(f64::INFINITY, off);
    models
        .into_iter()
        .find(|model| off(model) <= tolerance)
        .ok_or(right)
}
