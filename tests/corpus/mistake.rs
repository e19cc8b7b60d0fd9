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
    MomentDifference,
    Factor,
    Convention,
    OtherRate,
}

pub(crate) const ALL: &[Mistake] = &[
    Mistake::Sign,
    Mistake::Index,
    Mistake::LostDot,
    Mistake::ExtraDot,
    Mistake::Frame,
    Mistake::CrossOrder,
    Mistake::LostTerm,
    Mistake::MomentDifference,
    Mistake::Factor,
    Mistake::Convention,
    Mistake::OtherRate,
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
            Self::LostTerm => &["missing-term", "frame"],
            Self::MomentDifference => &["inertia-difference", "sign", "index"],
            Self::Factor => &["factor"],
            Self::Convention => &["convention", "sign"],
            Self::OtherRate => &["symbol"],
        }
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
            Self::MomentDifference => line.changed(&difference),
            Self::Factor => line.changed(&factor),
            Self::Convention => vec![other_convention(line)],
            Self::OtherRate => line.changed(&other_rate),
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
    match expr {
        Expr::Sum(terms) if terms.len() > 1 => (0..terms.len())
            .map(|at| {
                let mut terms = terms.clone();
                terms.remove(at);
                match terms.as_slice() {
                    [(false, one)] => one.clone(),
                    _ => Expr::Sum(terms),
                }
            })
            .collect(),
        _ => vec![],
    }
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
    match (moment(0), moment(1), terms.len()) {
        (Some(_), Some(_), 2) => {
            let mut turned = terms.clone();
            turned[0].1 = terms[1].1.clone();
            turned[1].1 = terms[0].1.clone();
            vec![Expr::Sum(turned)]
        }
        _ => vec![],
    }
}

fn factor(expr: &Expr) -> Vec<Expr> {
    match expr {
        Expr::Product(factors) if factors.contains(&Expr::Number(1, 2)) => {
            let rest: Vec<Expr> = factors
                .iter()
                .filter(|f| **f != Expr::Number(1, 2))
                .cloned()
                .collect();
            match rest.as_slice() {
                [one] => vec![one.clone()],
                _ => vec![Expr::Product(rest)],
            }
        }
        Expr::Product(factors) if factors.contains(&Expr::Number(2, 1)) => {
            let rest: Vec<Expr> = factors
                .iter()
                .filter(|f| **f != Expr::Number(2, 1))
                .cloned()
                .collect();
            match rest.as_slice() {
                [one] => vec![one.clone()],
                _ => vec![Expr::Product(rest)],
            }
        }
        _ => vec![],
    }
}

/// Every product of inertia with the other sign.
fn other_convention(line: &Line) -> Line {
    let product = |e: &Expr| matches!(e, Expr::Atom(Atom::Inertia(i, j, 0)) if i != j);
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
