//! The limit of a function of the step's length as it goes to zero.

use nalgebra::SVector;

/// Halvings of the step.
const HALVINGS: usize = 10;
/// Lengths that one extrapolation takes.
const POINTS: usize = 5;

/// A limit and what it may be off.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limit<const N: usize> {
    pub(super) value: SVector<f64, N>,
    pub(super) error: f64,
}

/// The limit of `f(h)` for h → 0, by the polynomial through the values at five lengths (Neville), of all groups of five between
/// `longest` and a thousandth of it the one that is known best.
pub(super) fn limit<const N: usize>(
    longest: f64,
    mut f: impl FnMut(f64) -> SVector<f64, N>,
) -> Limit<N> {
    let values: Vec<_> = (0..HALVINGS)
        .map(|k| f(longest * 0.5_f64.powi(k as i32)))
        .collect();
    let groups = values.windows(POINTS).map(extrapolated);
    let best = groups.min_by(|a, b| a.error.total_cmp(&b.error));
    best.unwrap_or(Limit {
        value: SVector::zeros(),
        error: f64::INFINITY,
    })
}

/// From values at h, h/2, h/4 …; the error is that between the last two orders, and between neighbours of the last.
fn extrapolated<const N: usize>(values: &[SVector<f64, N>]) -> Limit<N> {
    let mut row = values.to_vec();
    let mut before = row.clone();
    for order in 1..values.len() {
        let factor = 2.0_f64.powi(order as i32);
        let next = row
            .windows(2)
            .map(|pair| (pair[1] * factor - pair[0]) / (factor - 1.0));
        let next: Vec<_> = next.collect();
        before = std::mem::replace(&mut row, next);
    }
    let value = row.last().copied().unwrap_or_else(SVector::zeros);
    let last = before.iter().map(|other| (other - value).norm());
    let error = last.fold(0.0, f64::max);
    let finite = value.iter().all(|x| x.is_finite()) && error.is_finite();
    Limit {
        value,
        error: if finite { error } else { f64::INFINITY },
    }
}
