//! Lines as trees, apart from the tree that the verifier reads.

/// A quantity with components in the axes used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Vector {
    Omega,
    Frame,
    Momentum,
    Moment,
    /// The velocity of the mass centre, where the page has no other.
    Velocity,
    Force,
    /// The momentum m v.
    LinearMomentum,
    /// From a moving point P to the mass centre G.
    Arm,
    CentreVelocity,
    PointVelocity,
    CentreMomentum,
    PointMomentum,
    CentreMoment,
    PointMoment,
}

/// What a moment of inertia is taken about, where the page has two points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Point {
    Centre,
    Origin,
}

/// A number of the motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Atom {
    /// A component, with dots.
    Part(Vector, usize, u8),
    /// A moment (equal indices) or product of inertia, with dots.
    Inertia(usize, usize, u8),
    Energy(u8),
    /// A part of the quaternion w, x, y, z, with dots.
    Quaternion(usize, u8),
    /// ∂ of a component in another component, whichever of the two are dotted.
    Partial((Vector, usize, u8), usize),
    /// ∂T/∂ω_i.
    EnergyPartial(usize),
    Mass,
    /// A moment or product of inertia about one of two points.
    About(Point, usize, usize),
    /// A coordinate of the mass centre from the other of the two.
    Place(usize),
}

/// Who sees the rate of a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Seen {
    /// No rate.
    Value,
    Space,
    Moving,
}

/// A side of a line.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Expr {
    Number(i64, i64),
    Atom(Atom),
    Whole(Vector, Seen),
    /// The inertia tensor, with dots.
    Tensor(u8),
    /// The matrix that takes components on the body's axes to those in space, with dots, and whether transposed.
    Attitude(u8, bool),
    /// The matrix of ω ×.
    Skew,
    Identity,
    /// Terms, each with whether it is subtracted.
    Sum(Vec<(bool, Expr)>),
    Product(Vec<Expr>),
    Quotient(Box<Expr>, Box<Expr>),
    Square(Box<Expr>),
    /// The rate of a scalar.
    Rate(Box<Expr>),
    Cross(Box<Expr>, Box<Expr>),
    Dot(Box<Expr>, Box<Expr>),
    Column(Vec<Expr>),
    Matrix(Vec<Expr>),
}

/// An equation.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Line {
    pub(crate) left: Expr,
    pub(crate) right: Expr,
}

impl Expr {
    pub(crate) fn children(&self) -> Vec<&Expr> {
        match self {
            Self::Number(..)
            | Self::Atom(_)
            | Self::Whole(..)
            | Self::Tensor(_)
            | Self::Attitude(..)
            | Self::Skew
            | Self::Identity => vec![],
            Self::Sum(terms) => terms.iter().map(|(_, e)| e).collect(),
            Self::Product(all) | Self::Column(all) | Self::Matrix(all) => all.iter().collect(),
            Self::Quotient(a, b) | Self::Cross(a, b) | Self::Dot(a, b) => vec![a, b],
            Self::Square(a) | Self::Rate(a) => vec![a],
        }
    }

    fn child_mut(&mut self, at: usize) -> Option<&mut Expr> {
        match self {
            Self::Sum(terms) => terms.get_mut(at).map(|(_, e)| e),
            Self::Product(all) | Self::Column(all) | Self::Matrix(all) => all.get_mut(at),
            Self::Quotient(a, b) | Self::Cross(a, b) | Self::Dot(a, b) => {
                [a, b].into_iter().nth(at).map(|boxed| &mut **boxed)
            }
            Self::Square(a) | Self::Rate(a) => (at == 0).then_some(a),
            _ => None,
        }
    }

    /// Every tree that comes of changing one node in one of the ways that `change` knows.
    pub(crate) fn changed(&self, change: &dyn Fn(&Expr) -> Vec<Expr>) -> Vec<Expr> {
        let mut all = change(self);
        for (i, child) in self.children().into_iter().enumerate() {
            for new in child.changed(change) {
                let mut whole = self.clone();
                if let Some(place) = whole.child_mut(i) {
                    *place = new;
                    all.push(whole);
                }
            }
        }
        all
    }

    /// The tree with each node put through a change, from the leaves up.
    pub(crate) fn map(&self, change: &mut dyn FnMut(Expr) -> Expr) -> Expr {
        let mut whole = self.clone();
        for (i, child) in self.children().into_iter().enumerate() {
            let new = child.map(change);
            if let Some(place) = whole.child_mut(i) {
                *place = new;
            }
        }
        change(whole)
    }

    /// Whether a node anywhere has a property.
    pub(crate) fn any(&self, property: &dyn Fn(&Expr) -> bool) -> bool {
        property(self) || self.children().into_iter().any(|child| child.any(property))
    }

    /// Whether it is neither vector nor matrix.
    pub(crate) fn is_scalar(&self) -> bool {
        match self {
            Self::Whole(..)
            | Self::Tensor(_)
            | Self::Attitude(..)
            | Self::Skew
            | Self::Identity
            | Self::Cross(..)
            | Self::Column(_)
            | Self::Matrix(_) => false,
            Self::Dot(..) => true,
            other => other.children().into_iter().all(Self::is_scalar),
        }
    }
}

impl Line {
    pub(crate) fn any(&self, property: &dyn Fn(&Expr) -> bool) -> bool {
        self.left.any(property) || self.right.any(property)
    }

    /// Every line with one node changed.
    pub(crate) fn changed(&self, change: &dyn Fn(&Expr) -> Vec<Expr>) -> Vec<Line> {
        let left = self.left.changed(change).into_iter().map(|left| Line {
            left,
            right: self.right.clone(),
        });
        let right = self.right.changed(change).into_iter().map(|right| Line {
            left: self.left.clone(),
            right,
        });
        left.chain(right).collect()
    }
}

pub(crate) fn omega(i: usize) -> Expr {
    Expr::Atom(Atom::Part(Vector::Omega, i % 3, 0))
}

pub(crate) fn omega_dot(i: usize) -> Expr {
    Expr::Atom(Atom::Part(Vector::Omega, i % 3, 1))
}

pub(crate) fn momentum(i: usize) -> Expr {
    Expr::Atom(Atom::Part(Vector::Momentum, i % 3, 0))
}

pub(crate) fn momentum_dot(i: usize) -> Expr {
    Expr::Atom(Atom::Part(Vector::Momentum, i % 3, 1))
}

pub(crate) fn moment(i: usize) -> Expr {
    Expr::Atom(Atom::Part(Vector::Moment, i % 3, 0))
}

pub(crate) fn frame(i: usize) -> Expr {
    Expr::Atom(Atom::Part(Vector::Frame, i % 3, 0))
}

/// A moment or product of inertia, indices in the order of the alphabet.
pub(crate) fn inertia(i: usize, j: usize) -> Expr {
    let (i, j) = (i % 3, j % 3);
    Expr::Atom(Atom::Inertia(i.min(j), i.max(j), 0))
}

pub(crate) fn plus(terms: Vec<Expr>) -> Expr {
    Expr::Sum(terms.into_iter().map(|e| (false, e)).collect())
}

pub(crate) fn minus(a: Expr, b: Expr) -> Expr {
    Expr::Sum(vec![(false, a), (true, b)])
}

pub(crate) fn times(factors: Vec<Expr>) -> Expr {
    Expr::Product(factors)
}

pub(crate) fn over(a: Expr, b: Expr) -> Expr {
    Expr::Quotient(Box::new(a), Box::new(b))
}

pub(crate) fn square(a: Expr) -> Expr {
    Expr::Square(Box::new(a))
}

pub(crate) fn rate(a: Expr) -> Expr {
    Expr::Rate(Box::new(a))
}

pub(crate) fn cross(a: Expr, b: Expr) -> Expr {
    Expr::Cross(Box::new(a), Box::new(b))
}

pub(crate) fn dot(a: Expr, b: Expr) -> Expr {
    Expr::Dot(Box::new(a), Box::new(b))
}

pub(crate) fn half() -> Expr {
    Expr::Number(1, 2)
}

pub(crate) fn equal(left: Expr, right: Expr) -> Line {
    Line { left, right }
}
