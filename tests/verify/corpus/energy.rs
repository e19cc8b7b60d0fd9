//! Families about the kinetic energy and what is conserved.

use super::expr::{
    Atom, Expr, Line, Seen, Vector, cross, dot, equal, half, inertia, minus, moment, momentum,
    momentum_dot, omega, omega_dot, over, plus, rate, square, times,
};
use super::family::{product, signed, whole};

pub(crate) fn energy() -> Vec<Line> {
    let energy = || Expr::Atom(Atom::Energy(0));
    let rate_of_energy = || Expr::Atom(Atom::Energy(1));
    let sum = |a: &dyn Fn(usize) -> Expr, b: &dyn Fn(usize) -> Expr| {
        plus((0..3).map(|i| product([a(i), b(i)])).collect())
    };
    let squares = (0..3).map(|i| product([inertia(i, i), square(omega(i))]));
    let mixed =
        [(0, 1), (0, 2), (1, 2)].map(|(i, j)| times(vec![inertia(i, j), omega(i), omega(j)]));
    let mut all = vec![(false, product([half(), plus(squares.collect())]))];
    all.extend(mixed.into_iter().map(|e| (true, e)));
    vec![
        equal(
            energy(),
            product([half(), dot(whole(Vector::Omega), whole(Vector::Momentum))]),
        ),
        equal(energy(), product([half(), sum(&momentum, &omega)])),
        equal(energy(), signed(all)),
        equal(
            rate_of_energy(),
            dot(whole(Vector::Moment), whole(Vector::Omega)),
        ),
        equal(rate_of_energy(), sum(&moment, &omega)),
        equal(rate_of_energy(), sum(&omega, &momentum_dot)),
    ]
}

pub(crate) fn principal_energy() -> Vec<Line> {
    let energy = || Expr::Atom(Atom::Energy(0));
    let squares = |of: &dyn Fn(usize) -> Expr| {
        plus(
            (0..3)
                .map(|i| product([inertia(i, i), square(of(i))]))
                .collect(),
        )
    };
    let quotients = (0..3)
        .map(|i| over(square(momentum(i)), inertia(i, i)))
        .collect();
    let powers = (0..3)
        .map(|i| times(vec![inertia(i, i), omega(i), omega_dot(i)]))
        .collect();
    vec![
        equal(energy(), product([half(), squares(&omega)])),
        equal(product([Expr::Number(2, 1), energy()]), plus(quotients)),
        equal(Expr::Atom(Atom::Energy(1)), plus(powers)),
    ]
}

pub(crate) fn conservation() -> Vec<Line> {
    let zero = || Expr::Number(0, 1);
    let squares = plus((0..3).map(|i| square(momentum(i))).collect());
    let products = plus(
        (0..3)
            .map(|i| product([momentum(i), momentum_dot(i)]))
            .collect(),
    );
    vec![
        equal(Expr::Atom(Atom::Energy(1)), zero()),
        equal(rate(squares), zero()),
        equal(products, zero()),
        equal(
            Expr::Whole(Vector::Momentum, Seen::Moving),
            cross(whole(Vector::Momentum), whole(Vector::Omega)),
        ),
        equal(
            momentum_dot(0),
            minus(
                product([momentum(1), omega(2)]),
                product([momentum(2), omega(1)]),
            ),
        ),
    ]
}
