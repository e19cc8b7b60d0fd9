//! What the rows and columns of a Jacobian stand for.

use crate::mechanics::InertiaParameters;
use crate::motion::Quaternion;
use nalgebra::{DMatrix, Matrix3};

/// A group of rows or columns that belong together, and what they are.
///
/// The name stands in the report. The meaning tells which mistakes are possible: a vector that may be given in other
/// axes, a perturbation that may stand on the other side of the attitude, an order that may be another one.
///
/// ```
/// use polhode::jacobian::Slot;
/// use polhode::motion::Quaternion;
/// let q = Quaternion::new([0.5, 0.5, 0.5, 0.5]);
/// let columns = [Slot::turn("θ", &q), Slot::vector_in_body("ω", &q), Slot::scalar("dt")];
/// assert_eq!(columns.map(|slot| slot.len()), [3, 3, 1]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Slot {
    name: String,
    meaning: Meaning,
}

#[derive(Clone, Debug, PartialEq)]
enum Meaning {
    Numbers(usize),
    /// Three components, and the attitude if it is known.
    Vector(Option<Matrix3<f64>>),
    /// A perturbation of an attitude.
    Turn(Matrix3<f64>),
    Quaternion,
    Inertia(InertiaParameters),
}

/// Another way to write the numbers of a slot.
pub(super) struct Rewriting {
    pub(super) kind: Other,
    /// The slot's own numbers from the others: x = matrix · other. Orthogonal.
    pub(super) matrix: DMatrix<f64>,
}

/// In which way a slot may be written otherwise than asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Other {
    /// A vector in space axes where body axes are asked for, or the other way round.
    Frame,
    /// A perturbation of the attitude on its other side, exp(θ/2) q for q exp(θ/2).
    Side,
    /// A quaternion in the order x, y, z, w.
    QuaternionOrder,
    /// The conjugate of a quaternion.
    QuaternionConjugate,
    /// Parameters of inertia in this order, the products of this slot's or of the order's own sign.
    InertiaOrder(InertiaParameters),
    /// Products of inertia of the other sign, in the order asked for.
    InertiaProducts,
}

impl Slot {
    fn new(name: &str, meaning: Meaning) -> Self {
        Self {
            name: name.to_owned(),
            meaning,
        }
    }

    /// One number.
    pub fn scalar(name: &str) -> Self {
        Self::numbers(name, 1)
    }

    /// `count` numbers of which nothing more is known.
    pub fn numbers(name: &str, count: usize) -> Self {
        Self::new(name, Meaning::Numbers(count))
    }

    /// Three components of a vector.
    pub fn vector(name: &str) -> Self {
        Self::new(name, Meaning::Vector(None))
    }

    /// Three components of a vector in the axes of a body of this attitude (unit quaternion, body → space).
    pub fn vector_in_body(name: &str, attitude: &Quaternion<f64>) -> Self {
        Self::new(name, Meaning::Vector(Some(attitude.matrix())))
    }

    /// Three components of a perturbation θ of this attitude, on the body side: q exp(θ/2).
    pub fn turn(name: &str, attitude: &Quaternion<f64>) -> Self {
        Self::new(name, Meaning::Turn(attitude.matrix()))
    }

    /// The four components w, x, y, z of a quaternion.
    pub fn quaternion(name: &str) -> Self {
        Self::new(name, Meaning::Quaternion)
    }

    /// Six parameters of inertia in the order and of the sign of `parameters`.
    pub fn inertia(name: &str, parameters: InertiaParameters) -> Self {
        Self::new(name, Meaning::Inertia(parameters))
    }

    /// The name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// How many rows or columns it takes.
    #[allow(clippy::len_without_is_empty, reason = "a slot is no collection")]
    pub fn len(&self) -> usize {
        match self.meaning {
            Meaning::Numbers(count) => count,
            Meaning::Vector(_) | Meaning::Turn(_) => 3,
            Meaning::Quaternion => 4,
            Meaning::Inertia(_) => 6,
        }
    }

    /// The name of each row or column.
    pub(super) fn components(&self) -> Vec<String> {
        let letters: &[&str] = match self.meaning {
            Meaning::Numbers(1) => &[""],
            Meaning::Numbers(count) => {
                return (0..count).map(|i| format!("{}[{i}]", self.name)).collect();
            }
            Meaning::Vector(_) | Meaning::Turn(_) => &["x", "y", "z"],
            Meaning::Quaternion => &["w", "x", "y", "z"],
            Meaning::Inertia(parameters) => return self.inertia_components(parameters),
        };
        let named = letters
            .iter()
            .map(|letter| format!("{}{letter}", self.name));
        named.collect()
    }

    fn inertia_components(&self, parameters: InertiaParameters) -> Vec<String> {
        let order: [usize; 6] = parameters
            .of_tensor(&Matrix3::new(1, 4, 5, 4, 2, 6, 5, 6, 3))
            .map(|place: i32| place.unsigned_abs() as usize - 1);
        let pairs = ["xx", "yy", "zz", "xy", "xz", "yz"];
        order
            .map(|place| format!("{}{}", self.name, pairs[place]))
            .into()
    }

    /// The other ways to write the same.
    pub(super) fn rewritings(&self) -> Vec<Rewriting> {
        match &self.meaning {
            Meaning::Numbers(_) | Meaning::Vector(None) => vec![],
            Meaning::Vector(Some(attitude)) => both_ways(Other::Frame, attitude),
            Meaning::Turn(attitude) => both_ways(Other::Side, attitude),
            Meaning::Quaternion => vec![
                Rewriting {
                    kind: Other::QuaternionOrder,
                    matrix: signed_permutation(&[(3, 1.0), (0, 1.0), (1, 1.0), (2, 1.0)]),
                },
                Rewriting {
                    kind: Other::QuaternionConjugate,
                    matrix: signed_permutation(&[(0, 1.0), (1, -1.0), (2, -1.0), (3, -1.0)]),
                },
            ],
            Meaning::Inertia(asked) => inertia_rewritings(*asked),
        }
    }
}

/// Turned by a rotation and by its inverse: which of them it is depends on what is asked for.
fn both_ways(kind: Other, attitude: &Matrix3<f64>) -> Vec<Rewriting> {
    [attitude.transpose(), *attitude]
        .map(|turn| Rewriting {
            kind,
            matrix: DMatrix::from_fn(3, 3, |r, c| turn[(r, c)]),
        })
        .into()
}

/// The matrix whose row r holds the factor `places[r].1` in column `places[r].0`.
fn signed_permutation(places: &[(usize, f64)]) -> DMatrix<f64> {
    DMatrix::from_fn(places.len(), places.len(), |r, c| {
        if places[r].0 == c { places[r].1 } else { 0.0 }
    })
}

/// Every other order with either sign of the products.
fn inertia_rewritings(asked: InertiaParameters) -> Vec<Rewriting> {
    let orders = [
        InertiaParameters::MuJoCo,
        InertiaParameters::Urdf,
        InertiaParameters::Pinocchio,
        InertiaParameters::Lecture,
    ];
    let mut found: Vec<Rewriting> = vec![];
    let identity = DMatrix::identity(6, 6);
    for other in orders {
        for sign in [1.0, -1.0] {
            let columns: Vec<_> = (0..6)
                .map(|k| {
                    let unit = std::array::from_fn(|i| if i == k { 1.0 } else { 0.0 });
                    let tensor = other.tensor::<f64>(unit);
                    let signed =
                        Matrix3::from_fn(|r, c| tensor[(r, c)] * if r == c { 1.0 } else { sign });
                    asked.of_tensor(&signed)
                })
                .collect();
            let matrix = DMatrix::from_fn(6, 6, |r, c| columns[c][r]);
            if matrix == identity || found.iter().any(|known| known.matrix == matrix) {
                continue;
            }
            let kind = match matrix.map(f64::abs) == identity {
                true => Other::InertiaProducts,
                false => Other::InertiaOrder(other),
            };
            found.push(Rewriting { kind, matrix });
        }
    }
    found
}
