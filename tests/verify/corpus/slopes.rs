//! Families about derivatives: gradients, the Jacobian of the acceleration, the quaternion, the tensor's rate.

use super::expr::{
    Atom, Expr, Line, Vector, equal, frame, half, inertia, minus, momentum, omega, over, plus,
    rate, square, times,
};
use super::family::{product, ring, signed};

pub(crate) fn gradients() -> Vec<Line> {
    let slope = |i, j| Expr::Atom(Atom::Partial((Vector::Momentum, i, 0), j));
    let mut lines = ring(|i| equal(momentum(i), Expr::Atom(Atom::EnergyPartial(i))));
    lines.extend(ring(|i| equal(slope(i, i), inertia(i, i))));
    lines.extend(ring(|i| {
        let j = (i + 1) % 3;
        equal(slope(i, j), signed(vec![(true, inertia(i, j))]))
    }));
    lines
}

pub(crate) fn jacobian() -> Vec<Line> {
    let slope = |i, j| Expr::Atom(Atom::Partial((Vector::Omega, i, 1), j));
    let entry = |i: usize, j: usize, other: usize| {
        let top = product([
            minus(inertia(i + 1, i + 1), inertia(i + 2, i + 2)),
            omega(other),
        ]);
        equal(slope(i, j % 3), over(top, inertia(i, i)))
    };
    let first = (0..3).map(|i| entry(i, i + 1, i + 2));
    let second = (0..3).map(|i| entry(i, i + 2, i + 1));
    let diagonal = (0..3).map(|i| equal(slope(i, i), Expr::Number(0, 1)));
    first.chain(second).chain(diagonal).collect()
}

fn part(i: usize) -> Expr {
    Expr::Atom(Atom::Quaternion(i, 0))
}

fn part_rate(i: usize) -> Expr {
    Expr::Atom(Atom::Quaternion(i, 1))
}

/// w ω_i + (v × ω)_i, with v = (x, y, z).
fn turned_part(i: usize) -> Expr {
    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
    signed(vec![
        (false, product([part(0), omega(i)])),
        (false, product([part(j + 1), omega(k)])),
        (true, product([part(k + 1), omega(j)])),
    ])
}

/// q̇ = ½ q ω, ω on the axes of the body.
pub(crate) fn quaternion_rule() -> Vec<Line> {
    let scalar = plus((0..3).map(|i| product([part(i + 1), omega(i)])).collect());
    let first = signed(vec![(true, product([half(), scalar]))]);
    let rest = ring(|i| equal(part_rate(i + 1), product([half(), turned_part(i)])));
    std::iter::once(equal(part_rate(0), first))
        .chain(rest)
        .collect()
}

pub(crate) fn quaternion() -> Vec<Line> {
    let two = || Expr::Number(2, 1);
    let zero = || Expr::Number(0, 1);
    let mut lines = ring(|i| equal(product([two(), part_rate(i + 1)]), turned_part(i)));
    let products = plus((0..4).map(|i| product([part(i), part_rate(i)])).collect());
    lines.push(equal(products, zero()));
    let length = || plus((0..4).map(|i| square(part(i))).collect());
    lines.push(equal(rate(length()), zero()));
    lines.extend(ring(|i| {
        let (j, k) = ((i + 1) % 3 + 1, (i + 2) % 3 + 1);
        let terms = [
            (0, i + 1, false),
            (i + 1, 0, true),
            (k, j, false),
            (j, k, true),
        ];
        let terms = terms.map(|(a, b, negative)| (negative, product([part(a), part_rate(b)])));
        let right = product([two(), signed(terms.into())]);
        equal(product([length(), omega(i)]), right)
    }));
    lines
}

/// İ = [ω − Ω]× I − I [ω − Ω]×, by entries, with I_ij the integrals.
pub(crate) fn tensor_rate() -> Vec<Line> {
    let past = |i: usize| minus(omega(i), frame(i));
    ring(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let two = || Expr::Number(2, 1);
        let terms = vec![
            (false, times(vec![two(), past(k), inertia(i, j)])),
            (true, times(vec![two(), past(j), inertia(i, k)])),
        ];
        equal(Expr::Atom(Atom::Inertia(i, i, 1)), signed(terms))
    })
}
