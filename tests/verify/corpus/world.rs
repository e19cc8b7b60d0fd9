//! A motion of a body in rational numbers, and what a line comes to there.
//!
//! Nothing of the crate is used: the tensor's rate, the momentum and the moment are worked out here once more.

use super::expr::{Atom, Expr, Line, Seen, Vector};
use super::points::{Points, identity, product, skew, transposed};
use super::random::Random;
use num_rational::BigRational;
use num_traits::{One, Zero};

pub(crate) type Number = BigRational;
pub(crate) type Triple = [Number; 3];
pub(crate) type Nine = [Triple; 3];

/// The body that a document speaks of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Body {
    Full,
    Principal,
    /// Principal, and the first two moments are equal.
    Symmetric,
}

/// What holds in a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Premises {
    pub(crate) body: Body,
    /// The axes turn with an angular velocity of their own.
    pub(crate) turning: bool,
    /// No moment acts.
    pub(crate) free: bool,
}

/// A value at every symbol, with its rate.
pub(crate) struct World {
    omega: [Triple; 2],
    frame: [Triple; 2],
    inertia: [Nine; 2],
    momentum: [Triple; 2],
    moment: Triple,
    quaternion: [[Number; 4]; 2],
    points: Points,
}

/// A value with its rate, for scalars; vectors and matrices have the value alone.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    Scalar(Number, Option<Number>),
    Triple(Triple),
    Nine(Box<Nine>),
}

pub(crate) fn n(value: i64) -> Number {
    Number::from_integer(value.into())
}

pub(crate) fn cross(a: &Triple, b: &Triple) -> Triple {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &a[j] * &b[k] - &a[k] * &b[j]
    })
}

fn dot(a: &Triple, b: &Triple) -> Number {
    (0..3).map(|i| &a[i] * &b[i]).sum()
}

pub(crate) fn add(a: &Triple, b: &Triple) -> Triple {
    std::array::from_fn(|i| &a[i] + &b[i])
}

pub(crate) fn scaled(a: &Triple, by: &Number) -> Triple {
    std::array::from_fn(|i| &a[i] * by)
}

fn apply(m: &Nine, v: &Triple) -> Triple {
    std::array::from_fn(|i| dot(&m[i], v))
}

/// Cramer's rule; the inertia tensors drawn here are diagonally dominant, hence regular.
fn solve(m: &Nine, v: &Triple) -> Triple {
    let column = |k: usize| -> Triple { std::array::from_fn(|i| m[i][k].clone()) };
    let determinant = |a: &Triple, b: &Triple, c: &Triple| dot(a, &cross(b, c));
    let whole = determinant(&column(0), &column(1), &column(2));
    std::array::from_fn(|k| {
        let with = |at: usize| if at == k { v.clone() } else { column(at) };
        determinant(&with(0), &with(1), &with(2)) / &whole
    })
}

/// d/dt of a tensor that the body carries, on axes that it turns past with `w`.
fn tensor_rate(tensor: &Nine, w: &Triple) -> Nine {
    let columns: [Triple; 3] = std::array::from_fn(|k| {
        let column: Triple = std::array::from_fn(|i| tensor[i][k].clone());
        cross(w, &column)
    });
    // The tensor is symmetric, so the second half of [w]I − I[w] is the transpose of the first.
    std::array::from_fn(|i| std::array::from_fn(|k| &columns[k][i] + &columns[i][k]))
}

impl World {
    pub(crate) fn draw(premises: Premises, random: &mut Random) -> Self {
        let mut number = |most: usize| n(random.below(2 * most + 1) as i64 - most as i64);
        let mut triple = || -> Triple { std::array::from_fn(|_| number(9_000)) };
        let (omega, mut omega_rate) = (triple(), triple());
        let (own, own_rate, products, shares) = (triple(), triple(), triple(), triple());
        let quaternion: [Number; 4] = std::array::from_fn(|_| number(9_000));
        let mut diagonal: Triple = std::array::from_fn(|i| n(40_000) + &shares[i]);
        if premises.body == Body::Symmetric {
            diagonal[1] = diagonal[0].clone();
        }
        let tensor: Nine = std::array::from_fn(|i| {
            std::array::from_fn(|j| match (i == j, premises.body) {
                (true, _) => diagonal[i].clone(),
                (false, Body::Full) => -products[i + j - 1].clone(),
                (false, _) => Number::zero(),
            })
        });
        let frame = if premises.turning { own } else { omega.clone() };
        let past: Triple = std::array::from_fn(|i| &omega[i] - &frame[i]);
        let tensor_dot = tensor_rate(&tensor, &past);
        let momentum = apply(&tensor, &omega);
        let carried = add(&apply(&tensor_dot, &omega), &cross(&frame, &momentum));
        if premises.free {
            omega_rate = solve(&tensor, &scaled(&carried, &n(-1)));
        }
        let momentum_rate = add(&apply(&tensor_dot, &omega), &apply(&tensor, &omega_rate));
        let moment = add(&momentum_rate, &cross(&frame, &momentum));
        let frame_rate = if premises.turning {
            own_rate
        } else {
            omega_rate.clone()
        };
        let momenta = [momentum, momentum_rate];
        Self {
            points: Points::draw(&frame, &omega, &momenta, &moment, random),
            quaternion: [quaternion.clone(), hamilton_rate(&quaternion, &omega)],
            omega: [omega, omega_rate],
            frame: [frame, frame_rate],
            inertia: [tensor, tensor_dot],
            momentum: momenta,
            moment,
        }
    }

    fn triple(&self, vector: Vector, dots: usize) -> Option<&Triple> {
        match vector {
            Vector::Omega => self.omega.get(dots),
            Vector::Frame => self.frame.get(dots),
            Vector::Momentum | Vector::CentreMomentum => self.momentum.get(dots),
            Vector::Moment | Vector::CentreMoment => (dots == 0).then_some(&self.moment),
            moving => self.points.triple(moving, dots),
        }
    }

    fn atom(&self, atom: Atom) -> Option<Number> {
        Some(match atom {
            Atom::Part(vector, i, dots) => self.triple(vector, dots.into())?[i].clone(),
            Atom::Inertia(i, j, dots) => {
                let entry = &self.inertia.get(usize::from(dots))?[i][j];
                if i == j { entry.clone() } else { -entry }
            }
            Atom::Energy(0) => dot(&self.omega[0], &self.momentum[0]) / n(2),
            Atom::Energy(1) => {
                let parts = [(0, 1), (1, 0)].map(|(a, b)| dot(&self.omega[a], &self.momentum[b]));
                parts.into_iter().sum::<Number>() / n(2)
            }
            Atom::Energy(_) => return None,
            Atom::Quaternion(i, dots) => self.quaternion.get(usize::from(dots))?[i].clone(),
            Atom::Partial((Vector::Momentum, i, 0), j) => self.inertia[0][i][j].clone(),
            Atom::Partial((Vector::Omega, i, 1), j) => self.acceleration_slope(i, j),
            Atom::Partial(..) => return None,
            Atom::EnergyPartial(i) => self.momentum[0][i].clone(),
            Atom::Mass => self.points.mass.clone(),
            Atom::About(point, i, j) => {
                self.atom(Atom::Inertia(i, j, 0))? + self.points.shift(point, i, j)
            }
            Atom::Place(i) => self.points.place[i].clone(),
        })
    }

    /// ∂ω̇_i/∂ω_j on body axes with the moment held: I ω̇ = M − ω × Iω, differentiated.
    fn acceleration_slope(&self, i: usize, j: usize) -> Number {
        let unit: Triple = std::array::from_fn(|k| {
            if k == j {
                Number::one()
            } else {
                Number::zero()
            }
        });
        let gyroscopic = add(
            &cross(&unit, &self.momentum[0]),
            &cross(&self.omega[0], &apply(&self.inertia[0], &unit)),
        );
        let [x, y, z] = solve(&self.inertia[0], &scaled(&gyroscopic, &n(-1)));
        [x, y, z][i].clone()
    }

    /// What an expression comes to; `None` where it has no meaning.
    pub(crate) fn value(&self, expr: &Expr) -> Option<Value> {
        Some(match expr {
            Expr::Number(a, b) => Value::Scalar(n(*a) / n(*b), Some(Number::zero())),
            Expr::Atom(atom) => Value::Scalar(self.atom(*atom)?, self.atom_rate(*atom)),
            Expr::Whole(vector, seen) => self.whole(*vector, *seen)?,
            Expr::Tensor(dots) => nine(self.inertia.get(usize::from(*dots))?.clone()),
            Expr::Attitude(dots, turned) => {
                let matrix = self.points.attitude.get(usize::from(*dots))?;
                nine(if *turned {
                    transposed(matrix)
                } else {
                    matrix.clone()
                })
            }
            Expr::Skew => nine(skew(&self.omega[0])),
            Expr::Identity => nine(identity()),
            Expr::Sum(terms) => {
                let mut terms = terms.iter().map(|(negative, e)| {
                    let value = self.value(e)?;
                    Some(if *negative {
                        value.scaled(&n(-1))
                    } else {
                        value
                    })
                });
                let first = terms.next()??;
                terms.try_fold(first, |sum, term| sum.plus(&term?))?
            }
            Expr::Product(factors) => {
                let mut factors = factors.iter().map(|e| self.value(e));
                let first = factors.next()??;
                factors.try_fold(first, |product, factor| product.times(&factor?))?
            }
            Expr::Quotient(a, b) => self.value(a)?.over(&self.value(b)?)?,
            Expr::Square(a) => match self.value(a)? {
                Value::Triple(v) => Value::Scalar(dot(&v, &v), None),
                value => value.clone().times(&value)?,
            },
            Expr::Rate(a) => match self.value(a)? {
                Value::Scalar(_, rate) => Value::Scalar(rate?, None),
                _ => return None,
            },
            Expr::Cross(a, b) => {
                Value::Triple(cross(&self.value(a)?.triple()?, &self.value(b)?.triple()?))
            }
            Expr::Dot(a, b) => self.product_rate(a, b)?,
            Expr::Column(entries) => Value::Triple(self.three(entries)?),
            Expr::Matrix(entries) => {
                let rows: Vec<Triple> = entries
                    .chunks(3)
                    .map(|row| self.three(row))
                    .collect::<Option<_>>()?;
                nine(rows.try_into().ok()?)
            }
        })
    }

    fn whole(&self, vector: Vector, seen: Seen) -> Option<Value> {
        let dots = usize::from(seen != Seen::Value);
        let value = self.triple(vector, dots)?;
        Some(Value::Triple(match seen {
            Seen::Space => add(value, &cross(&self.frame[0], self.triple(vector, 0)?)),
            _ => value.clone(),
        }))
    }

    /// a · b, with its rate where both are whole vectors: the same in all axes.
    fn product_rate(&self, a: &Expr, b: &Expr) -> Option<Value> {
        let value = dot(&self.value(a)?.triple()?, &self.value(b)?.triple()?);
        let rate = match (a, b) {
            (Expr::Whole(a, Seen::Value), Expr::Whole(b, Seen::Value)) => (|| {
                let one = dot(self.triple(*a, 1)?, self.triple(*b, 0)?);
                Some(one + dot(self.triple(*a, 0)?, self.triple(*b, 1)?))
            })(),
            _ => None,
        };
        Some(Value::Scalar(value, rate))
    }

    fn atom_rate(&self, atom: Atom) -> Option<Number> {
        self.atom(match atom {
            Atom::Part(vector, i, dots) => Atom::Part(vector, i, dots + 1),
            Atom::Inertia(i, j, dots) => Atom::Inertia(i, j, dots + 1),
            Atom::Energy(dots) => Atom::Energy(dots + 1),
            Atom::Quaternion(i, dots) => Atom::Quaternion(i, dots + 1),
            Atom::Mass => return Some(Number::zero()),
            _ => return None,
        })
    }

    fn three(&self, entries: &[Expr]) -> Option<Triple> {
        let values: Vec<Number> = entries
            .iter()
            .map(|e| match self.value(e)? {
                Value::Scalar(value, _) => Some(value),
                _ => None,
            })
            .collect::<Option<_>>()?;
        values.try_into().ok()
    }

    /// Whether both sides of a line agree here; `None` where it has no meaning.
    pub(crate) fn holds(&self, line: &Line) -> Option<bool> {
        let sides = [self.value(&line.left)?, self.value(&line.right)?];
        Some(match sides {
            [Value::Scalar(a, _), Value::Scalar(b, _)] => a == b,
            [Value::Triple(a), Value::Triple(b)] => a == b,
            [Value::Nine(a), Value::Nine(b)] => a == b,
            // A zero without an arrow stands for the zero vector.
            [Value::Triple(a), Value::Scalar(b, _)] if b.is_zero() => a.iter().all(Zero::is_zero),
            _ => return None,
        })
    }
}

/// q̇ = ½ q ω by Hamilton's rule, ω on the axes of the body.
fn hamilton_rate(q: &[Number; 4], omega: &Triple) -> [Number; 4] {
    let vector: Triple = std::array::from_fn(|i| q[i + 1].clone());
    let turned = add(&scaled(omega, &q[0]), &cross(&vector, omega));
    let half = Number::new(1.into(), 2.into());
    let rest = scaled(&turned, &half);
    let first = -dot(&vector, omega) * half;
    let [x, y, z] = rest;
    [first, x, y, z]
}

fn nine(entries: Nine) -> Value {
    Value::Nine(Box::new(entries))
}

impl Value {
    fn triple(self) -> Option<Triple> {
        match self {
            Self::Triple(triple) => Some(triple),
            _ => None,
        }
    }

    fn scaled(self, by: &Number) -> Self {
        match self {
            Self::Scalar(a, rate) => Self::Scalar(a * by, rate.map(|r| r * by)),
            Self::Triple(a) => Self::Triple(scaled(&a, by)),
            Self::Nine(a) => nine(a.map(|row| scaled(&row, by))),
        }
    }

    fn plus(self, other: &Self) -> Option<Self> {
        Some(match (self, other) {
            (Self::Scalar(a, da), Self::Scalar(b, db)) => {
                Self::Scalar(a + b, da.zip(db.as_ref()).map(|(da, db)| da + db))
            }
            (Self::Triple(a), Self::Triple(b)) => Self::Triple(add(&a, b)),
            (Self::Nine(a), Self::Nine(b)) => nine(std::array::from_fn(|i| add(&a[i], &b[i]))),
            _ => return None,
        })
    }

    fn times(self, other: &Self) -> Option<Self> {
        Some(match (self, other) {
            (Self::Scalar(a, da), Self::Scalar(b, db)) => {
                let rate = da.zip(db.as_ref()).map(|(da, db)| da * b + &a * db);
                Self::Scalar(a * b, rate)
            }
            (Self::Scalar(a, _), other) => other.clone().scaled(&a),
            (whole, Self::Scalar(b, _)) => whole.scaled(b),
            (Self::Nine(a), Self::Triple(b)) => Self::Triple(apply(&a, b)),
            (Self::Nine(a), Self::Nine(b)) => nine(product(&a, b)),
            _ => return None,
        })
    }

    fn over(self, other: &Self) -> Option<Self> {
        let Self::Scalar(b, db) = other else {
            return None;
        };
        if b.is_zero() {
            return None;
        }
        Some(match self {
            Self::Scalar(a, da) => {
                let rate = da
                    .zip(db.as_ref())
                    .map(|(da, db)| (da * b - &a * db) / (b * b));
                Self::Scalar(a / b, rate)
            }
            whole => whole.scaled(&b.recip()),
        })
    }
}

/// Whether a line holds in all motions: asked at random points, where a false one holds with a chance below 1 in 1000 each.
pub(crate) fn is_true(worlds: &[World], line: &Line) -> Option<bool> {
    let all: Option<Vec<bool>> = worlds.iter().map(|world| world.holds(line)).collect();
    Some(all?.into_iter().all(|holds| holds))
}
