//! A symbol back from its text: its letter, dots, index and label.

use super::expr::{Atom, Expr, Point, Seen, Vector};
use super::parse::Reader;

/// A letter with what it stands for.
enum Letter {
    Vector(Vector),
    Inertia,
    Attitude,
    Scalar(Atom),
}

const LETTERS: &[(&str, Vector)] = &[
    ("\\Sigma \\vec{M}", Vector::Moment),
    ("\\Sigma M", Vector::Moment),
    ("ΣM", Vector::Moment),
    ("M", Vector::Moment),
    ("N", Vector::Moment),
    ("\\tau", Vector::Moment),
    ("τ", Vector::Moment),
    ("\\Gamma", Vector::Moment),
    ("L", Vector::Momentum),
    ("H", Vector::Momentum),
    ("\\omega", Vector::Omega),
    ("ω", Vector::Omega),
    ("\\Omega", Vector::Frame),
    ("Ω", Vector::Frame),
    ("\\vec{p}", Vector::LinearMomentum),
    ("Q", Vector::LinearMomentum),
    ("\\vec{r}", Vector::Arm),
    ("\\rho", Vector::Arm),
    ("v", Vector::Velocity),
    ("F", Vector::Force),
];

impl Reader<'_> {
    pub(super) fn symbol(&mut self) -> Option<Expr> {
        let mut dots = u8::from(self.take("\\dot"));
        let braced = self.take("{");
        let letter = self.letter()?;
        dots += u8::from(self.take("\u{307}"));
        let mut index = self.index();
        let mut label = self.label();
        if braced {
            self.take("}").then_some(())?;
            index.extend(self.index());
            label = label.or(self.label());
        }
        Some(match letter {
            Letter::Attitude => self.transposed(Expr::Attitude(dots, false)),
            // A p with an index is no rate.
            Letter::Scalar(Atom::Part(_, 0, _)) if !index.is_empty() => {
                Expr::Atom(Atom::Part(Vector::LinearMomentum, *index.first()?, dots))
            }
            Letter::Scalar(Atom::Quaternion(i, _)) if label.is_some() => {
                Expr::Atom(Atom::Place(i.checked_sub(1)?))
            }
            Letter::Scalar(Atom::Mass) => Expr::Atom(Atom::Mass),
            Letter::Vector(vector) if label.is_some() => {
                let vector = of_point(vector, label?)?;
                let seen = if dots == 0 { Seen::Value } else { Seen::Moving };
                Expr::Whole(vector, seen)
            }
            Letter::Vector(vector) => match index.as_slice() {
                [] if dots == 0 => Expr::Whole(vector, Seen::Value),
                [] => Expr::Whole(vector, Seen::Moving),
                [i] => Expr::Atom(Atom::Part(vector, *i, dots)),
                _ => return None,
            },
            Letter::Inertia => match index.as_slice() {
                [] => Expr::Tensor(dots),
                [i] if label.is_some() => Expr::Atom(Atom::About(label?, *i, *i)),
                [i, j] if label.is_some() => Expr::Atom(Atom::About(label?, *i.min(j), *i.max(j))),
                [i] => Expr::Atom(Atom::Inertia(*i, *i, dots)),
                [i, j] => Expr::Atom(Atom::Inertia(*i.min(j), *i.max(j), dots)),
                _ => return None,
            },
            Letter::Scalar(Atom::Part(vector, i, _)) => Expr::Atom(Atom::Part(vector, i, dots)),
            Letter::Scalar(Atom::Quaternion(i, _)) => Expr::Atom(Atom::Quaternion(i, dots)),
            Letter::Scalar(_) => Expr::Atom(Atom::Energy(dots)),
        })
    }

    fn letter(&mut self) -> Option<Letter> {
        for (name, vector) in LETTERS {
            if self.take(name) {
                return Some(Letter::Vector(*vector));
            }
        }
        if self.take("\\vec{") {
            let inside = self.letter()?;
            return self.take("}").then_some(inside);
        }
        if self.take("\\vec") {
            return self.letter();
        }
        if self.take("I") || self.take("J") {
            return Some(Letter::Inertia);
        }
        if self.take("T") {
            return Some(Letter::Scalar(Atom::Energy(0)));
        }
        if self.take("R") {
            return Some(Letter::Attitude);
        }
        if self.take("m") {
            return Some(Letter::Scalar(Atom::Mass));
        }
        let rates = ["p", "q", "r"].iter().position(|name| self.take(name));
        if let Some(i) = rates {
            return Some(Letter::Scalar(Atom::Part(Vector::Omega, i, 0)));
        }
        let part = ["w", "x", "y", "z"]
            .iter()
            .position(|name| self.take(name))?;
        Some(Letter::Scalar(Atom::Quaternion(part, 0)))
    }

    /// The point that a quantity is about, or the one whose coordinate or velocity it is.
    fn label(&mut self) -> Option<Point> {
        let labels = [
            ("_G", Point::Centre),
            ("_{G}", Point::Centre),
            ("^G", Point::Centre),
            ("^O", Point::Origin),
            ("_P", Point::Origin),
            ("_{P}", Point::Origin),
        ];
        let mut labels = labels.into_iter();
        labels.find_map(|(text, point)| self.take(text).then_some(point))
    }

    fn index(&mut self) -> Vec<usize> {
        let Some(rest) = self.rest.strip_prefix('_') else {
            return vec![];
        };
        let braced = rest.strip_prefix('{');
        let rest = braced.unwrap_or(rest);
        let axis = |c: char| "xyz".find(c).or_else(|| "123".find(c));
        let index: Vec<usize> = rest.chars().map_while(axis).collect();
        if index.is_empty() {
            return vec![];
        }
        let rest = &rest[index.len()..];
        self.rest = braced.and_then(|_| rest.strip_prefix('}')).unwrap_or(rest);
        index
    }
}

/// A vector with the label of a point: P is the one that moves.
fn of_point(vector: Vector, point: Point) -> Option<Vector> {
    Some(match (vector, point) {
        (Vector::Velocity, Point::Centre) => Vector::CentreVelocity,
        (Vector::Velocity, Point::Origin) => Vector::PointVelocity,
        (Vector::Momentum, Point::Centre) => Vector::CentreMomentum,
        (Vector::Momentum, Point::Origin) => Vector::PointMomentum,
        (Vector::Moment, Point::Centre) => Vector::CentreMoment,
        (Vector::Moment, Point::Origin) => Vector::PointMoment,
        _ => return None,
    })
}

/// The rate of a symbol, as one with a dot.
pub(super) fn moving(inside: Expr) -> Option<Expr> {
    Some(match inside {
        Expr::Whole(vector, Seen::Value) => Expr::Whole(vector, Seen::Moving),
        Expr::Tensor(0) => Expr::Tensor(1),
        Expr::Attitude(0, turned) => Expr::Attitude(1, turned),
        Expr::Atom(Atom::Part(vector, i, 0)) => Expr::Atom(Atom::Part(vector, i, 1)),
        Expr::Atom(Atom::Inertia(i, j, 0)) => Expr::Atom(Atom::Inertia(i, j, 1)),
        Expr::Atom(Atom::Energy(0)) => Expr::Atom(Atom::Energy(1)),
        Expr::Atom(Atom::Quaternion(i, 0)) => Expr::Atom(Atom::Quaternion(i, 1)),
        _ => return None,
    })
}
