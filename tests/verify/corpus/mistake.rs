//! Each mistake that people make, put into a line in every place where it can be made.

use super::expr::{Atom, Expr, Line, Seen, Vector};

/// A mistake.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Mistake {
    Sign,
    Index,
    LostDot,
    ExtraDot,
    Frame,
    CrossOrder,
    LostTerm,
    LostTransport,
    LostProduct,
    MomentDifference,
    Factor,
    Convention,
    LostMass,
    Transpose,
    ScalarInertia,
    InertiaRate,
    MovingPoint,
    OtherRate,
    OtherSymbol,
}

pub(crate) const ALL: &[Mistake] = &[
    Mistake::Sign,
    Mistake::Index,
    Mistake::LostDot,
    Mistake::ExtraDot,
    Mistake::Frame,
    Mistake::CrossOrder,
    Mistake::LostTerm,
    Mistake::LostTransport,
    Mistake::LostProduct,
    Mistake::MomentDifference,
    Mistake::Factor,
    Mistake::Convention,
    Mistake::LostMass,
    Mistake::Transpose,
    Mistake::ScalarInertia,
    Mistake::InertiaRate,
    Mistake::MovingPoint,
    Mistake::OtherRate,
    Mistake::OtherSymbol,
];

impl Mistake {
    /// What the diagnosis may call it. A slip that two words describe equally well has both.
    pub(crate) fn kinds(self) -> &'static [&'static str] {
        match self {
            // The one product of inertia of a line with its sign turned is the other convention too, and a turned
            // difference of moments is a turned sign.
            Self::Sign => &["sign", "convention", "inertia-difference", "cross-order"],
            Self::Index => &["index", "inertia-difference"],
            // L̇ = Iω has a dot too many on the left, or lacks one on the right.
            Self::LostDot => &["missing-dot", "extra-dot"],
            Self::ExtraDot => &["extra-dot", "missing-dot"],
            Self::Frame => &["frame", "missing-term", "extra-term"],
            Self::CrossOrder => &["cross-order", "sign"],
            // M = (dL/dt)_xyz lacks ω × L, or names the wrong frame.
            Self::LostTerm | Self::LostTransport => &["missing-term", "frame"],
            Self::LostProduct | Self::InertiaRate | Self::MovingPoint => &["missing-term"],
            Self::MomentDifference => &["inertia-difference", "sign", "index"],
            Self::Factor => &["factor"],
            Self::Convention => &["convention", "sign"],
            Self::LostMass => &["factor"],
            Self::Transpose => &["transpose"],
            Self::ScalarInertia => &["scalar-inertia"],
            Self::OtherRate => &["symbol"],
            // Where the moment belongs, the momentum lacks a dot.
            Self::OtherSymbol => &["symbol", "missing-dot", "extra-dot"],
        }
    }

    /// Whether few families have a place for it.
    pub(crate) fn is_rare(self) -> bool {
        matches!(
            self,
            Self::LostMass
                | Self::Transpose
                | Self::ScalarInertia
                | Self::InertiaRate
                | Self::MovingPoint
        )
    }

    /// Every line with this mistake made once.
    pub(crate) fn made(self, line: &Line) -> Vec<Line> {
        match self {
            Self::Sign => line.changed(&sign),
            Self::Index => line.changed(&index),
            Self::LostDot => line.changed(&lost_dot),
            Self::ExtraDot => line.changed(&extra_dot),
            Self::Frame => line.changed(&frame),
            Self::CrossOrder => line.changed(&|e| match e {
                Expr::Cross(a, b) => vec![Expr::Cross(b.clone(), a.clone())],
                _ => vec![],
            }),
            Self::LostTerm => line.changed(&lost_term),
            Self::LostTransport => line.changed(&|e| lost(e, &is_cross)),
            Self::LostProduct => line.changed(&|e| lost(e, &is_product_of_inertia)),
            Self::MomentDifference => line.changed(&difference),
            Self::Factor => line.changed(&factor),
            Self::Convention => vec![other_convention(line)],
            Self::LostMass => line.changed(&lost_mass),
            Self::Transpose => line.changed(&transposed),
            Self::ScalarInertia => line.changed(&inertia_put_first),
            Self::InertiaRate => inertia_held(line),
            Self::MovingPoint => line.changed(&|e| lost(e, &is_of_moving_point)),
            Self::OtherRate => line.changed(&other_rate),
            Self::OtherSymbol => other_symbols(line),
        }
    }
}

fn sign(expr: &Expr) -> Vec<Expr> {
    let Expr::Sum(terms) = expr else {
        return vec![];
    };
    (0..terms.len())
        .map(|at| {
            let mut terms = terms.clone();
            terms[at].0 = !terms[at].0;
            Expr::Sum(terms)
        })
        .collect()
}

fn index(expr: &Expr) -> Vec<Expr> {
    let others = |i: usize| [(i + 1) % 3, (i + 2) % 3];
    match expr {
        Expr::Atom(Atom::Part(vector, i, dots)) => others(*i)
            .map(|i| Expr::Atom(Atom::Part(*vector, i, *dots)))
            .into(),
        Expr::Atom(Atom::Inertia(i, j, dots)) => {
            let new = |i: usize, j: usize| Expr::Atom(Atom::Inertia(i.min(j), i.max(j), *dots));
            let one = others(*i).into_iter().map(|i| new(i, *j));
            one.chain(others(*j).into_iter().map(|j| new(*i, j)))
                .collect()
        }
        _ => vec![],
    }
}

fn lost_dot(expr: &Expr) -> Vec<Expr> {
    match expr {
        Expr::Atom(Atom::Part(vector, i, 1)) => vec![Expr::Atom(Atom::Part(*vector, *i, 0))],
        Expr::Atom(Atom::Energy(1)) => vec![Expr::Atom(Atom::Energy(0))],
        Expr::Atom(Atom::Quaternion(i, 1)) => vec![Expr::Atom(Atom::Quaternion(*i, 0))],
        _ => vec![],
    }
}

fn extra_dot(expr: &Expr) -> Vec<Expr> {
    match expr {
        Expr::Atom(Atom::Part(Vector::Moment, ..)) => vec![],
        Expr::Atom(Atom::Part(vector, i, 0)) => vec![Expr::Atom(Atom::Part(*vector, *i, 1))],
        Expr::Atom(Atom::Quaternion(i, 0)) => vec![Expr::Atom(Atom::Quaternion(*i, 1))],
        _ => vec![],
    }
}

fn frame(expr: &Expr) -> Vec<Expr> {
    match expr {
        Expr::Whole(v, Seen::Space) => vec![Expr::Whole(*v, Seen::Moving)],
        Expr::Whole(v, Seen::Moving) => vec![Expr::Whole(*v, Seen::Space)],
        _ => vec![],
    }
}

fn lost_term(expr: &Expr) -> Vec<Expr> {
    lost(expr, &|_| true)
}

/// One of the terms of a sum lost, of those of some kind.
fn lost(expr: &Expr, kind: &dyn Fn(&Expr) -> bool) -> Vec<Expr> {
    let Expr::Sum(terms) = expr else {
        return vec![];
    };
    let of_kind = (0..terms.len()).filter(|&at| terms.len() > 1 && kind(&terms[at].1));
    of_kind
        .map(|at| {
            let mut terms = terms.clone();
            terms.remove(at);
            sum(terms)
        })
        .collect()
}

/// A sum, which a single term is not.
fn sum(terms: Vec<(bool, Expr)>) -> Expr {
    match terms.as_slice() {
        [(false, one)] => one.clone(),
        _ => Expr::Sum(terms),
    }
}

/// A product, which a single factor is not.
fn product(factors: Vec<Expr>) -> Expr {
    match factors.as_slice() {
        [one] => one.clone(),
        _ => Expr::Product(factors),
    }
}

fn is_cross(term: &Expr) -> bool {
    matches!(term, Expr::Cross(..))
}

fn is_product_of_inertia(term: &Expr) -> bool {
    term.any(&|e| matches!(e, Expr::Atom(Atom::Inertia(i, j, _)) if i != j))
        && !matches!(term, Expr::Sum(_))
}

fn is_of_moving_point(term: &Expr) -> bool {
    term.any(&|e| matches!(e, Expr::Whole(Vector::PointVelocity, _)))
        && matches!(term, Expr::Cross(..) | Expr::Product(_))
}

/// The two moments of a difference changed for each other, or one of them for the third.
fn difference(expr: &Expr) -> Vec<Expr> {
    let Expr::Sum(terms) = expr else {
        return vec![];
    };
    let moment = |at: usize| match terms.get(at) {
        Some((_, Expr::Atom(Atom::Inertia(i, j, 0)))) if i == j => Some(*i),
        _ => None,
    };
    let (Some(i), Some(j), 2) = (moment(0), moment(1), terms.len()) else {
        return vec![];
    };
    let with = |i: usize, j: usize| {
        let mut terms = terms.clone();
        terms[0].1 = Expr::Atom(Atom::Inertia(i, i, 0));
        terms[1].1 = Expr::Atom(Atom::Inertia(j, j, 0));
        Expr::Sum(terms)
    };
    let mut all = vec![with(j, i)];
    if i != j {
        all.extend([with(i, 3 - i - j), with(3 - i - j, j)]);
    }
    all
}

/// A factor ½ or 2 lost, or one too many.
fn factor(expr: &Expr) -> Vec<Expr> {
    let Expr::Product(factors) = expr else {
        return vec![];
    };
    let numbers = [Expr::Number(1, 2), Expr::Number(2, 1)];
    if let Some(at) = factors.iter().position(|f| numbers.contains(f)) {
        let mut rest = factors.clone();
        rest.remove(at);
        return vec![product(rest)];
    }
    if factors.iter().all(Expr::is_scalar) {
        let more = |number: &Expr| {
            let first = std::iter::once(number.clone());
            Expr::Product(first.chain(factors.iter().cloned()).collect())
        };
        return numbers.iter().map(more).collect();
    }
    vec![]
}

fn lost_mass(expr: &Expr) -> Vec<Expr> {
    match expr {
        Expr::Product(factors) => {
            let mass = |f: &Expr| *f == Expr::Atom(Atom::Mass);
            let rest: Vec<Expr> = factors.iter().filter(|f| !mass(f)).cloned().collect();
            match rest.len() == factors.len() || rest.is_empty() {
                true => vec![],
                false => vec![product(rest)],
            }
        }
        _ => vec![],
    }
}

fn transposed(expr: &Expr) -> Vec<Expr> {
    match expr {
        Expr::Attitude(dots, turned) => vec![Expr::Attitude(*dots, !turned)],
        _ => vec![],
    }
}

/// `a × (I b)` written as `I (a × b)`, as if I were a number.
fn inertia_put_first(expr: &Expr) -> Vec<Expr> {
    let split = |factor: &Expr| match factor {
        Expr::Product(factors) => match factors.as_slice() {
            [Expr::Tensor(0), rest @ ..] => Some(product(rest.to_vec())),
            _ => None,
        },
        _ => None,
    };
    let (a, b) = match expr {
        Expr::Cross(a, b) | Expr::Dot(a, b) => (a, b),
        _ => return vec![],
    };
    let joined = |a: Expr, b: Expr| match expr {
        Expr::Cross(..) => Expr::Cross(Box::new(a), Box::new(b)),
        _ => Expr::Dot(Box::new(a), Box::new(b)),
    };
    let first = |inner: Expr| Expr::Product(vec![Expr::Tensor(0), inner]);
    let left = split(a).map(|a| first(joined(a, (**b).clone())));
    let right = split(b).map(|b| first(joined((**a).clone(), b)));
    left.into_iter().chain(right).collect()
}

/// The rates of the inertia left out, as if the axes turned with the body.
fn inertia_held(line: &Line) -> Vec<Line> {
    let changes = |term: &Expr| {
        let rate = |e: &Expr| matches!(e, Expr::Tensor(1) | Expr::Atom(Atom::Inertia(_, _, 1)));
        !matches!(term, Expr::Sum(_)) && term.any(&rate)
    };
    let mut without = |expr: Expr| match expr {
        Expr::Sum(terms) if !terms.iter().all(|(_, term)| changes(term)) => sum(terms
            .into_iter()
            .filter(|(_, term)| !changes(term))
            .collect()),
        other => other,
    };
    let (left, right) = (line.left.map(&mut without), line.right.map(&mut without));
    let held = Line { left, right };
    if held == *line { vec![] } else { vec![held] }
}

/// Every product of inertia with the other sign.
fn other_convention(line: &Line) -> Line {
    let product = |e: &Expr| matches!(e, Expr::Atom(Atom::Inertia(i, j, _)) if i != j);
    let flip = |e: Expr| match e {
        Expr::Sum(terms) => Expr::Sum(
            terms
                .into_iter()
                .map(|(negative, term)| {
                    let here = product(&term)
                        || matches!(&term, Expr::Product(factors) if factors.iter().any(product));
                    (negative != here, term)
                })
                .collect(),
        ),
        other => other,
    };
    Line {
        left: line.left.map(&mut { flip }),
        right: line.right.map(&mut { flip }),
    }
}

fn other_rate(expr: &Expr) -> Vec<Expr> {
    let other = |vector: &Vector| match vector {
        Vector::Omega => Some(Vector::Frame),
        Vector::Frame => Some(Vector::Omega),
        _ => None,
    };
    match expr {
        Expr::Atom(Atom::Part(vector, i, dots)) => other(vector)
            .map(|v| Expr::Atom(Atom::Part(v, *i, *dots)))
            .into_iter()
            .collect(),
        Expr::Whole(vector, seen) => other(vector)
            .map(|v| Expr::Whole(v, *seen))
            .into_iter()
            .collect(),
        _ => vec![],
    }
}

/// A component of the momentum for one of the moment, and the other way, or for one of the angular velocity.
fn other_symbols(line: &Line) -> Vec<Line> {
    // A derivative in ω says which letter is meant.
    if line.any(&|e| matches!(e, Expr::Atom(Atom::EnergyPartial(_)))) {
        return vec![];
    }
    line.changed(&|e| match e {
        Expr::Atom(Atom::Part(vector, i, 0)) => {
            let other = match vector {
                Vector::Moment | Vector::Omega => Vector::Momentum,
                Vector::Momentum => Vector::Moment,
                _ => return vec![],
            };
            vec![Expr::Atom(Atom::Part(other, *i, 0))]
        }
        _ => vec![],
    })
}
