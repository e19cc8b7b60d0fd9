//! Why an entry of a Jacobian may be wrong.

use super::slot::Other;
use nalgebra::Vector3;
use std::fmt;

/// What turns the right entries of a region into the given ones.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Kind {
    /// The sign is the other one.
    Sign,
    /// Zeros stand where something belongs.
    Missing,
    /// Something stands where zeros belong.
    Extra,
    /// Rows and columns are exchanged.
    Transposed,
    /// Two rows are swapped, counted from 0.
    SwappedRows(usize, usize),
    /// Two columns are swapped, counted from 0.
    SwappedColumns(usize, usize),
    /// The rows of two slots, counted from 0, have changed places.
    RowSlots(usize, usize),
    /// The columns of two slots, counted from 0, have changed places.
    ColumnSlots(usize, usize),
    /// Every entry is multiplied by this number.
    Factor(f64),
    /// A slot is written otherwise than asked for.
    Written(Other),
    /// This multiple of the identity has been added.
    Identity(f64),
    /// The matrix of v × has been added.
    CrossTerm(Vector3<f64>),
    /// It agrees to so many digits: a difference quotient, or a rounded constant.
    Approximate(i32),
    /// It has another shape than the derivative of the function: rows and columns given, rows and columns wanted.
    Shape([usize; 2], [usize; 2]),
}

/// A likely cause, and the entries that it explains.
#[derive(Clone, Debug, PartialEq)]
pub struct Cause {
    /// What happened.
    pub kind: Kind,
    /// What may have happened as well: in this region it comes to the same.
    pub or: Vec<Kind>,
    /// The region's rows, counted from 0.
    pub rows: Vec<usize>,
    /// The region's columns, counted from 0.
    pub columns: Vec<usize>,
    /// How many wrong entries it explains.
    pub explains: usize,
}

impl Kind {
    /// The less, the likelier where two causes explain the same.
    pub(super) fn cost(&self) -> u8 {
        match self {
            Self::Factor(factor) if !is_two(*factor) => 1,
            Self::Identity(_) => 1,
            Self::CrossTerm(_) | Self::Approximate(_) => 2,
            _ => 0,
        }
    }

    /// What happened, in words that go before the name of a region.
    pub(super) fn told(&self) -> String {
        match self {
            Self::Sign => "wrong sign".into(),
            Self::Missing => "missing (zeros stand there)".into(),
            Self::Extra => "should be zero".into(),
            Self::Transposed => "transposed".into(),
            Self::SwappedRows(..) => "swapped rows".into(),
            Self::SwappedColumns(..) => "swapped columns".into(),
            Self::RowSlots(..) => "rows in another order of the slots".into(),
            Self::ColumnSlots(..) => "columns in another order of the slots".into(),
            Self::Factor(factor) => format!("a factor of {factor:.6} too much"),
            Self::Written(other) => other.to_string(),
            Self::Identity(factor) if *factor < 0.0 => {
                format!("{:.6} times the identity is missing", -factor)
            }
            Self::Identity(factor) => format!("{factor:.6} times the identity too much"),
            Self::CrossTerm(v) => format!(
                "a term [v]× too much, v = ({:.6e}, {:.6e}, {:.6e})",
                v.x, v.y, v.z
            ),
            Self::Approximate(digits) => format!(
                "right to {digits} digits only: a difference quotient or a rounded constant"
            ),
            Self::Shape([rows, columns], [right, wide]) => {
                format!("{rows} × {columns} given, and the derivative is {right} × {wide}")
            }
        }
    }
}

/// Whether a factor is one that comes from a lost or doubled half.
fn is_two(factor: f64) -> bool {
    [2.0, 0.5].contains(&factor)
}

impl fmt::Display for Other {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use crate::mechanics::InertiaParameters;
        let order = match self {
            Self::Frame => return f.write_str("other axes: space for body, or body for space"),
            Self::Side => {
                return f.write_str(
                    "the attitude is perturbed on its other side: exp(θ/2) q for q exp(θ/2)",
                );
            }
            Self::QuaternionOrder => return f.write_str("quaternion in the order x, y, z, w"),
            Self::QuaternionConjugate => return f.write_str("conjugate quaternion"),
            Self::InertiaProducts => return f.write_str("products of inertia of the other sign"),
            Self::InertiaOrder(order) => order,
        };
        let order = match order {
            InertiaParameters::Lecture => "Ixx, Iyy, Izz, Ixy, Ixz, Iyz as integrals",
            InertiaParameters::Urdf => "ixx, ixy, ixz, iyy, iyz, izz (URDF)",
            InertiaParameters::MuJoCo => "xx, yy, zz, xy, xz, yz (MuJoCo)",
            InertiaParameters::Pinocchio => "xx, xy, yy, xz, yz, zz (Pinocchio)",
        };
        write!(f, "inertia in the order {order}")
    }
}
