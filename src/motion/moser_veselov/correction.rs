//! The corrections of the inverse tensor that raise the order of the discrete Moser–Veselov step.
//!
//! The inverse becomes (1 + s) I⁻¹ + d 1, with s and d polynomials in the step squared that depend on the invariants and
//! on the moments' symmetric functions alone. Found by running the exact motion and the discrete one on power series of
//! the step over the rationals and comparing the turn at each order: two numbers meet three equations, for every body. In
//! form they are those of Hairer and Vilmart (2006).

use crate::motion::Number;

/// A factor, and the powers of x = h² G²/(2 det), y = h² T/det, of the sum of the pairs of moments, and of the determinant;
/// the trace is 1.
type Term = (f64, [usize; 4]);

/// s, term by term: of h², h⁴, h⁶, h⁸.
const OF_INVERSE: [&[Term]; 4] = [
    &[(-1.0 / 3.0, [0, 1, 1, 0]), (1.0 / 6.0, [1, 0, 0, 0])],
    &[
        (1.0 / 30.0, [0, 2, 2, 0]),
        (-1.0 / 60.0, [0, 2, 0, 1]),
        (-1.0 / 30.0, [1, 1, 1, 0]),
        (2.0 / 15.0, [1, 1, 0, 1]),
        (1.0 / 30.0, [2, 0, 0, 0]),
        (-1.0 / 10.0, [2, 0, 1, 0]),
    ],
    &[
        (-1.0 / 630.0, [0, 3, 3, 0]),
        (1.0 / 630.0, [0, 3, 1, 1]),
        (1.0 / 35.0, [0, 3, 0, 2]),
        (1.0 / 420.0, [1, 2, 2, 0]),
        (41.0 / 2520.0, [1, 2, 0, 1]),
        (-53.0 / 630.0, [1, 2, 1, 1]),
        (-1.0 / 70.0, [2, 1, 1, 0]),
        (11.0 / 210.0, [2, 1, 2, 0]),
        (-1.0 / 84.0, [2, 1, 0, 1]),
        (17.0 / 2520.0, [3, 0, 0, 0]),
        (-11.0 / 420.0, [3, 0, 1, 0]),
        (5.0 / 126.0, [3, 0, 0, 1]),
    ],
    &[
        (1.0 / 22_680.0, [0, 4, 4, 0]),
        (-1.0 / 15_120.0, [0, 4, 2, 1]),
        (17.0 / 5040.0, [0, 4, 0, 2]),
        (-3.0 / 280.0, [0, 4, 1, 2]),
        (-1.0 / 11_340.0, [1, 3, 3, 0]),
        (-11.0 / 1890.0, [1, 3, 1, 1]),
        (23.0 / 945.0, [1, 3, 2, 1]),
        (-23.0 / 1260.0, [1, 3, 0, 2]),
        (13.0 / 3780.0, [2, 2, 2, 0]),
        (-17.0 / 1260.0, [2, 2, 3, 0]),
        (1.0 / 2520.0, [2, 2, 0, 1]),
        (1.0 / 252.0, [2, 2, 1, 1]),
        (53.0 / 1260.0, [2, 2, 0, 2]),
        (-11.0 / 3240.0, [3, 1, 1, 0]),
        (17.0 / 1260.0, [3, 1, 2, 0]),
        (47.0 / 7560.0, [3, 1, 0, 1]),
        (-47.0 / 945.0, [3, 1, 1, 1]),
        (31.0 / 22_680.0, [4, 0, 0, 0]),
        (-19.0 / 2520.0, [4, 0, 1, 0]),
        (1.0 / 120.0, [4, 0, 2, 0]),
        (97.0 / 15_120.0, [4, 0, 0, 1]),
    ],
];

/// d, term by term.
const OF_UNITY: [&[Term]; 4] = [
    &[(1.0 / 6.0, [0, 1, 0, 0]), (-1.0 / 3.0, [1, 0, 0, 0])],
    &[
        (-1.0 / 60.0, [0, 2, 1, 0]),
        (-1.0 / 10.0, [0, 2, 0, 1]),
        (-1.0 / 60.0, [1, 1, 0, 0]),
        (2.0 / 15.0, [1, 1, 1, 0]),
        (-1.0 / 60.0, [2, 0, 0, 0]),
    ],
    &[
        (1.0 / 1260.0, [0, 3, 2, 0]),
        (-13.0 / 1260.0, [0, 3, 0, 1]),
        (1.0 / 42.0, [0, 3, 1, 1]),
        (13.0 / 2520.0, [1, 2, 1, 0]),
        (-8.0 / 315.0, [1, 2, 2, 0]),
        (11.0 / 252.0, [1, 2, 0, 1]),
        (1.0 / 1260.0, [2, 1, 0, 0]),
        (-1.0 / 1260.0, [2, 1, 1, 0]),
        (-22.0 / 315.0, [2, 1, 0, 1]),
        (-19.0 / 2520.0, [3, 0, 0, 0]),
        (1.0 / 35.0, [3, 0, 1, 0]),
    ],
    &[
        (-1.0 / 45_360.0, [0, 4, 3, 0]),
        (-1.0 / 7560.0, [0, 4, 1, 1]),
        (-1.0 / 360.0, [0, 4, 2, 1]),
        (17.0 / 1680.0, [0, 4, 0, 2]),
        (-1.0 / 1512.0, [1, 3, 2, 0]),
        (8.0 / 2835.0, [1, 3, 3, 0]),
        (97.0 / 22_680.0, [1, 3, 0, 1]),
        (-23.0 / 1890.0, [1, 3, 1, 1]),
        (-1.0 / 35.0, [1, 3, 0, 2]),
        (-1.0 / 1512.0, [2, 2, 1, 0]),
        (19.0 / 7560.0, [2, 2, 2, 0]),
        (-19.0 / 1080.0, [2, 2, 0, 1]),
        (89.0 / 1890.0, [2, 2, 1, 1]),
        (-1.0 / 45_360.0, [3, 1, 0, 0]),
        (37.0 / 7560.0, [3, 1, 1, 0]),
        (-2.0 / 105.0, [3, 1, 2, 0]),
        (19.0 / 1260.0, [3, 1, 0, 1]),
        (-61.0 / 45_360.0, [4, 0, 0, 0]),
        (3.0 / 560.0, [4, 0, 1, 0]),
        (-61.0 / 4536.0, [4, 0, 0, 1]),
    ],
];

/// s and d to the `count`-th power of h², at most 4, for a tensor of trace 1. `arguments` are x, y, the sum of the pairs of
/// moments and the determinant.
pub(super) fn correction<T: Number>(count: usize, arguments: [T; 4]) -> (T, T) {
    let powers = arguments.map(|base| {
        let mut powers = [T::one(); 5];
        for n in 1..5 {
            powers[n] = powers[n - 1] * base;
        }
        powers
    });
    let sum = |tables: [&[Term]; 4]| {
        let mut sum = T::zero();
        for (factor, [a, b, c, d]) in tables.iter().take(count).copied().flatten() {
            let [x, y, pairs, determinant] = &powers;
            sum += x[*a] * y[*b] * pairs[*c] * determinant[*d] * T::of(*factor);
        }
        sum
    };
    (sum(OF_INVERSE), sum(OF_UNITY))
}
