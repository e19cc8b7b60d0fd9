//! Families between tensors and vectors: the attitude matrix, a tensor on axes that it turns past, vectors that the
//! tensor is put to.

use super::expr::{
    Atom, Expr, Line, Seen, Vector, cross, dot, equal, half, inertia, minus, momentum_dot, omega,
    omega_dot, plus,
};
use super::family::{product, ring, signed, whole};

pub(crate) fn attitude() -> Vec<Line> {
    let matrix = |dots| Expr::Attitude(dots, false);
    let turned = |dots| Expr::Attitude(dots, true);
    let negative = |e| signed(vec![(true, e)]);
    vec![
        equal(matrix(1), product([matrix(0), Expr::Skew])),
        equal(Expr::Skew, product([turned(0), matrix(1)])),
        equal(product([turned(0), matrix(0)]), Expr::Identity),
        equal(turned(1), negative(product([Expr::Skew, turned(0)]))),
        equal(
            product([turned(1), matrix(0)]),
            negative(product([turned(0), matrix(1)])),
        ),
        equal(
            product([matrix(1), turned(0)]),
            Expr::Product(vec![matrix(0), Expr::Skew, turned(0)]),
        ),
    ]
}

/// The rate of I ω on axes that turn past the body: İ ω + I ω̇.
pub(crate) fn changing_inertia() -> Vec<Line> {
    use Vector::{Frame, Moment, Momentum, Omega};
    let rates = || {
        vec![
            product([Expr::Tensor(1), whole(Omega)]),
            product([Expr::Tensor(0), Expr::Whole(Omega, Seen::Moving)]),
        ]
    };
    let with = |more: Expr| plus(rates().into_iter().chain([more]).collect());
    let turned = product([Expr::Tensor(0), whole(Omega)]);
    let mut lines = vec![
        equal(Expr::Whole(Momentum, Seen::Moving), plus(rates())),
        equal(whole(Moment), with(cross(whole(Frame), turned))),
        equal(whole(Moment), with(cross(whole(Frame), whole(Momentum)))),
    ];
    lines.extend(ring(|i| {
        let entry_rate = |j: usize| {
            let (a, b) = (i.min(j % 3), i.max(j % 3));
            Expr::Atom(Atom::Inertia(a, b, 1))
        };
        let terms = (i..i + 3).flat_map(|j| {
            [
                (j != i, product([entry_rate(j), omega(j)])),
                (j != i, product([inertia(i, j), omega_dot(j)])),
            ]
        });
        equal(momentum_dot(i), signed(terms.collect()))
    }));
    lines
}

pub(crate) fn tensor_and_vectors() -> Vec<Line> {
    use Vector::{Moment, Momentum, Omega};
    let turned = || product([Expr::Tensor(0), whole(Omega)]);
    let rate = || Expr::Whole(Omega, Seen::Moving);
    let inertial = || product([Expr::Tensor(0), rate()]);
    let gyroscopic = || cross(whole(Omega), turned());
    let energy = |dots| Expr::Atom(Atom::Energy(dots));
    vec![
        equal(whole(Moment), plus(vec![inertial(), gyroscopic()])),
        equal(
            Expr::Whole(Momentum, Seen::Space),
            plus(vec![inertial(), gyroscopic()]),
        ),
        equal(minus(whole(Moment), inertial()), gyroscopic()),
        equal(
            cross(whole(Momentum), whole(Omega)),
            cross(turned(), whole(Omega)),
        ),
        equal(energy(0), product([half(), dot(whole(Omega), turned())])),
        equal(
            dot(whole(Momentum), whole(Omega)),
            dot(whole(Omega), turned()),
        ),
        equal(energy(1), dot(whole(Omega), inertial())),
    ]
}
