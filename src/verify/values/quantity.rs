//! The vocabulary of the theory: the quantities that the laws connect.

/// A quantity of rigid-body mechanics.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Quantity {
    /// ω, of the body.
    AngularVelocity,
    /// Ω, of the axes used.
    FrameRate,
    /// α = ω̇.
    AngularAcceleration,
    /// L = I ω.
    Momentum,
    /// h, of wheels relative to the body that carries them.
    RelativeMomentum,
    /// ΣM.
    Moment,
    /// The inertia tensor.
    Inertia,
    /// T = ½ ω·L.
    Energy,
    /// P = M·ω.
    Power,
    /// r, from the origin of the moving axes.
    Position,
    /// v, of a point.
    Velocity,
    /// v, of the mass centre, where no position is spoken of.
    CentreVelocity,
    /// v_O, of the origin of the moving axes.
    OriginVelocity,
    /// a, of a point.
    Acceleration,
    /// ΣF.
    Force,
    /// p = m v.
    LinearMomentum,
    /// m.
    Mass,
    /// t.
    Time,
    /// R, the matrix between components in the body and in space.
    Attitude,
    /// q, the unit quaternion of the attitude: [w, x, y, z].
    Quaternion,
}

/// The shape of a quantity or a symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shape {
    /// One number.
    Scalar,
    /// Three components on the axes used.
    Vector,
    /// A symmetric tensor: xx, yy, zz, xy, xz, yz.
    Symmetric,
    /// Nine entries, row by row.
    Matrix,
    /// A grid of another size: rows and columns; entries row by row.
    Grid(u8, u8),
}

impl Shape {
    /// The number of independent components.
    pub fn components(self) -> u8 {
        match self {
            Self::Scalar => 1,
            Self::Vector => 3,
            Self::Symmetric => 6,
            Self::Matrix => 9,
            Self::Grid(rows, columns) => rows.saturating_mul(columns),
        }
    }
}

impl Quantity {
    /// Those that a front matter can name.
    pub(crate) const NAMED: [Self; 15] = [
        Self::AngularVelocity,
        Self::FrameRate,
        Self::AngularAcceleration,
        Self::Momentum,
        Self::RelativeMomentum,
        Self::Moment,
        Self::Inertia,
        Self::Energy,
        Self::Power,
        Self::Position,
        Self::Velocity,
        Self::Acceleration,
        Self::Force,
        Self::LinearMomentum,
        Self::Mass,
    ];

    /// The shape of its value.
    pub fn shape(self) -> Shape {
        match self {
            Self::Energy | Self::Power | Self::Mass | Self::Time => Shape::Scalar,
            Self::Inertia => Shape::Symmetric,
            Self::Attitude => Shape::Matrix,
            Self::Quaternion => Shape::Grid(4, 1),
            _ => Shape::Vector,
        }
    }

    /// Whether it has no rate in any axes.
    pub fn constant(self) -> bool {
        matches!(self, Self::Mass)
    }

    /// Its name in prose and in front matter.
    pub fn name(self) -> &'static str {
        match self {
            Self::AngularVelocity => "angular velocity",
            Self::FrameRate => "angular velocity of the axes",
            Self::AngularAcceleration => "angular acceleration",
            Self::Momentum => "angular momentum",
            Self::RelativeMomentum => "angular momentum of the wheels",
            Self::Moment => "moment",
            Self::Inertia => "inertia",
            Self::Energy => "kinetic energy",
            Self::Power => "power",
            Self::Position => "position",
            Self::Velocity => "velocity",
            Self::CentreVelocity => "velocity of the mass centre",
            Self::OriginVelocity => "velocity of the origin",
            Self::Acceleration => "acceleration",
            Self::Force => "force",
            Self::LinearMomentum => "linear momentum",
            Self::Mass => "mass",
            Self::Time => "time",
            Self::Attitude => "attitude matrix",
            Self::Quaternion => "attitude quaternion",
        }
    }
}
