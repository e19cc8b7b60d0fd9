//! Derivatives of a function that is known by its values alone, over a whole range of steps, each with its own error.
//!
//! With one step a difference quotient says nothing of its error. Over a ladder of steps it does: from large to small ones
//! successive quotients come together with the square of the step, until rounding drives them apart as its inverse.

use nalgebra::DVector;

/// Steps a ladder has, each a quarter of the one before.
const RUNGS: usize = 60;

/// An entry of the Jacobian from differences.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quotient {
    /// The quotient of the step that tells most.
    pub(super) value: f64,
    /// What it may be off; infinite if no step tells anything.
    pub(super) error: f64,
    /// Whether both one-sided quotients come together.
    pub(super) smooth: bool,
    /// The slope of the Taylor remainder of a given derivative, if more than rounding remains.
    pub(super) slope: Option<f64>,
}

/// The values of a function at a point, and at the steps of a ladder on both sides of it.
pub(super) struct Ladder {
    middle: DVector<f64>,
    rungs: Vec<Rung>,
}

struct Rung {
    /// Half the span between both points, and the steps to each.
    step: f64,
    ahead: (f64, DVector<f64>),
    behind: (f64, DVector<f64>),
}

impl Ladder {
    /// The values along input `column`, whose natural scale is at most `largest`.
    pub(super) fn new(
        f: &impl Fn(&DVector<f64>) -> DVector<f64>,
        at: &DVector<f64>,
        column: usize,
        largest: f64,
    ) -> Self {
        let value = |shift: f64| {
            let mut moved = at.clone();
            moved[column] += shift;
            // What is really added: the sum is rounded.
            (moved[column] - at[column], f(&moved))
        };
        let steps = (0..RUNGS).map(|k| 0.37 * largest * 0.25_f64.powi(k as i32));
        let rungs = steps.map(|step| {
            let (ahead, behind) = (value(step), value(-step));
            let step = (ahead.0 - behind.0) / 2.0;
            Rung {
                step,
                ahead,
                behind,
            }
        });
        let apart = |rung: &Rung| rung.step > 4.0 * f64::EPSILON * at[column].abs();
        Self {
            middle: f(at),
            rungs: rungs.filter(apart).collect(),
        }
    }

    /// The derivative of output `row`, and the remainder's slope for a `given` one.
    pub(super) fn quotient(&self, row: usize, given: f64) -> Quotient {
        let all: Vec<_> = self
            .rungs
            .iter()
            .filter_map(|rung| self.sample(rung, row))
            .collect();
        // Once a value moves at all, steps at which it doesn't are lost in its granularity.
        let moves = all.iter().any(|s| s.rise != 0.0);
        let samples: Vec<_> = all
            .into_iter()
            .filter(|s| !moves || s.rise != 0.0)
            .collect();
        let rated = rated(&samples);
        let trusted = (0..rated.len()).filter(|&k| {
            let (value, error) = rated[k];
            let smaller = &rated[k + 1..];
            smaller
                .iter()
                .all(|(other, theirs)| (value - other).abs() <= error + theirs)
        });
        let best = trusted.min_by(|a, b| rated[*a].1.total_cmp(&rated[*b].1));
        let Some(best) = best.filter(|k| rated[*k].1.is_finite()) else {
            return Quotient {
                value: f64::NAN,
                error: f64::INFINITY,
                smooth: true,
                slope: None,
            };
        };
        let (value, error) = rated[best];
        Quotient {
            value,
            error,
            smooth: is_smooth(&samples, &rated, best),
            slope: slope(&samples, given),
        }
    }

    fn sample(&self, rung: &Rung, row: usize) -> Option<Sample> {
        let (ahead, behind, middle) = (rung.ahead.1[row], rung.behind.1[row], self.middle[row]);
        let size = ahead.abs().max(behind.abs()).max(middle.abs());
        size.is_finite().then(|| Sample {
            step: rung.step,
            rise: ahead - behind,
            ahead: (rung.ahead.0, ahead - middle),
            behind: (rung.behind.0, behind - middle),
            rounding: 4.0 * f64::EPSILON * size,
        })
    }
}

/// The differences of one output at one step.
struct Sample {
    step: f64,
    rise: f64,
    ahead: (f64, f64),
    behind: (f64, f64),
    /// What rounding of the values alone may do to a difference.
    rounding: f64,
}

/// The central quotient at each step, and what it may be off: as much as quotients of smaller steps move, the noise of which
/// grows as the inverse of the step.
fn rated(samples: &[Sample]) -> Vec<(f64, f64)> {
    let quotient = |sample: &Sample| sample.rise / (2.0 * sample.step);
    let mut noise = 0.0_f64;
    let mut rated: Vec<_> = samples
        .windows(2)
        .rev()
        .map(|pair| {
            let (value, step) = (quotient(&pair[0]), pair[0].step);
            noise = noise.max((value - quotient(&pair[1])).abs() * step);
            (value, 2.0 * noise.max(pair[0].rounding) / step)
        })
        .collect();
    rated.reverse();
    rated
}

/// Whether the quotients ahead and behind come together: of a smooth function their gap falls with the step, by 64 over
/// three rungs.
fn is_smooth(samples: &[Sample], rated: &[(f64, f64)], best: usize) -> bool {
    let gap = |s: &Sample| (s.ahead.1 / s.ahead.0 - s.behind.1 / s.behind.0).abs();
    let narrow = best.max(3);
    let (Some(sample), Some((_, error))) = (samples.get(narrow), rated.get(narrow)) else {
        return true;
    };
    let noise = 8.0 * (sample.rounding / sample.step + error);
    gap(sample) <= gap(&samples[narrow - 3]) / 4.0 + noise
}

/// The median slope of |f(x + h) − f(x) − h J| over log h, where it stands out of rounding.
fn slope(samples: &[Sample], given: f64) -> Option<f64> {
    let remainder = |s: &Sample| {
        let (step, rise) = s.ahead;
        (
            (rise - step * given).abs(),
            s.rounding + 4.0 * f64::EPSILON * (step * given).abs(),
        )
    };
    let mut slopes: Vec<_> = samples
        .windows(2)
        .filter_map(|pair| {
            let ((wide, _), (narrow, noise)) = (remainder(&pair[0]), remainder(&pair[1]));
            let clear = narrow > 30.0 * noise && wide > 0.0;
            clear.then(|| (wide / narrow).ln() / (pair[0].ahead.0 / pair[1].ahead.0).ln())
        })
        .collect();
    // Steps far too large tell of other places of the function: the finer half counts.
    let mut finer = slopes.split_off(slopes.len() / 2);
    finer.sort_by(f64::total_cmp);
    finer.get(finer.len() / 2).copied()
}
