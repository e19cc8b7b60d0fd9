//! Ways to write a line that leave its meaning alone.

use super::expr::{Atom, Expr, Line, Vector, inertia, momentum, omega};
use super::random::Random;

/// A line with the same meaning, written otherwise in a few places.
pub(crate) fn rewritten(line: &Line, random: &mut Random) -> Line {
    let mut line = line.clone();
    for _ in 0..random.below(5) {
        line = step(line, random);
    }
    line
}

fn step(line: Line, random: &mut Random) -> Line {
    let choice = random.below(6);
    let variants = match choice {
        0 => line.changed(&|e| reordered(e)),
        1 => line.changed(&|e| grouped(e)),
        2 => line.changed(&|e| distributed(e)),
        3 => line.changed(&|e| turned(e)),
        4 => line.changed(&|e| squares(e)),
        _ => moved(&line),
    };
    random.pick(&variants).cloned().unwrap_or(line)
}

/// A rotation of the terms of a sum or of the scalar factors of a product.
fn reordered(expr: &Expr) -> Vec<Expr> {
    match expr {
        Expr::Sum(terms) => (1..terms.len())
            .map(|by| {
                let mut terms = terms.clone();
                terms.rotate_left(by);
                Expr::Sum(terms)
            })
            .collect(),
        Expr::Product(factors) if factors.iter().all(Expr::is_scalar) => (0..factors.len())
            .flat_map(|i| (0..i).map(move |j| (i, j)))
            .map(|(i, j)| {
                let mut factors = factors.clone();
                factors.swap(i, j);
                Expr::Product(factors)
            })
            .collect(),
        Expr::Dot(a, b) => vec![Expr::Dot(b.clone(), a.clone())],
        _ => vec![],
    }
}

/// Two or more terms of a sum in parentheses of their own.
fn grouped(expr: &Expr) -> Vec<Expr> {
    let Expr::Sum(terms) = expr else {
        return vec![];
    };
    (1..terms.len().saturating_sub(1))
        .map(|at| {
            let negative = terms[at].0;
            let inside = terms[at..]
                .iter()
                .map(|(sign, e)| (*sign != negative, e.clone()));
            let mut outside = terms[..at].to_vec();
            outside.push((negative, Expr::Sum(inside.collect())));
            Expr::Sum(outside)
        })
        .collect()
}

/// a (b + c) multiplied out, and a group of terms opened.
fn distributed(expr: &Expr) -> Vec<Expr> {
    match expr {
        Expr::Product(factors) => factors
            .iter()
            .enumerate()
            .filter_map(|(at, factor)| match factor {
                Expr::Sum(terms) => Some(Expr::Sum(
                    terms
                        .iter()
                        .map(|(sign, term)| {
                            let mut factors = factors.clone();
                            factors[at] = term.clone();
                            (*sign, flat(factors))
                        })
                        .collect(),
                )),
                _ => None,
            })
            .collect(),
        Expr::Sum(terms) => terms
            .iter()
            .enumerate()
            .filter_map(|(at, (negative, term))| {
                let inner = opened(term)?;
                let mut terms = terms.clone();
                terms.splice(
                    at..=at,
                    inner.into_iter().map(|(sign, e)| (sign != *negative, e)),
                );
                Some(Expr::Sum(terms))
            })
            .collect(),
        _ => vec![],
    }
}

fn opened(term: &Expr) -> Option<Vec<(bool, Expr)>> {
    match term {
        Expr::Sum(inner) => Some(inner.clone()),
        Expr::Product(_) => match distributed(term).pop()? {
            Expr::Sum(inner) => Some(inner),
            _ => None,
        },
        _ => None,
    }
}

/// Products in products become one product.
fn flat(factors: Vec<Expr>) -> Expr {
    let open = |factor| match factor {
        Expr::Product(inner) => inner,
        other => vec![other],
    };
    Expr::Product(factors.into_iter().flat_map(open).collect())
}

/// − (b − a) c for + (a − b) c.
fn turned(expr: &Expr) -> Vec<Expr> {
    let Expr::Sum(terms) = expr else {
        return vec![];
    };
    let turn = |term: &Expr| match term {
        Expr::Product(factors) => {
            let at = factors
                .iter()
                .position(|f| matches!(f, Expr::Sum(t) if t.len() == 2))?;
            let mut factors = factors.clone();
            if let Expr::Sum(inner) = &mut factors[at] {
                inner.reverse();
                inner
                    .iter_mut()
                    .for_each(|(negative, _)| *negative = !*negative);
            }
            Some(Expr::Product(factors))
        }
        _ => None,
    };
    (0..terms.len())
        .filter_map(|at| {
            let mut terms = terms.clone();
            terms[at] = (!terms[at].0, turn(&terms[at].1)?);
            Some(Expr::Sum(terms))
        })
        .collect()
}

/// a a for a², and the other way.
fn squares(expr: &Expr) -> Vec<Expr> {
    match expr {
        Expr::Square(a) if a.is_scalar() => vec![Expr::Product(vec![(**a).clone(), (**a).clone()])],
        Expr::Product(factors) => match factors.as_slice() {
            [a, b] if a == b && a.is_scalar() => vec![Expr::Square(Box::new(a.clone()))],
            _ => vec![],
        },
        _ => vec![],
    }
}

/// A term of the right side on the left, with the other sign.
fn moved(line: &Line) -> Vec<Line> {
    let (Expr::Sum(terms), true) = (&line.right, line.left != Expr::Number(0, 1)) else {
        return vec![];
    };
    if terms.len() < 3 {
        return vec![];
    }
    (0..terms.len())
        .map(|at| {
            let mut rest = terms.clone();
            let (negative, term) = rest.remove(at);
            let mut left = match &line.left {
                Expr::Sum(left) => left.clone(),
                other => vec![(false, other.clone())],
            };
            left.push((!negative, term));
            Line {
                left: Expr::Sum(left),
                right: Expr::Sum(rest),
            }
        })
        .collect()
}

/// The components of the momentum by the tensor's row, where the line has them without a dot.
pub(crate) fn substituted(line: &Line, principal: bool) -> Vec<Line> {
    line.changed(&|e| match e {
        Expr::Atom(Atom::Part(Vector::Momentum, i, 0)) if *e == momentum(*i) => {
            let term = |j: usize| Expr::Product(vec![inertia(*i, j), omega(j)]);
            let rest = [i + 1, i + 2].map(|j| (true, term(j)));
            let mut terms = vec![(false, term(*i))];
            terms.extend(rest.into_iter().filter(|_| !principal));
            vec![if principal {
                term(*i)
            } else {
                Expr::Sum(terms)
            }]
        }
        _ => vec![],
    })
}
