//! Derivatives of a function that is known by its values alone, over a whole range of steps, each with its own error.
//!
//! With one step a difference quotient says nothing of its error. Over a ladder of steps it does: from large to small ones
//! successive quotients come together with the square of the step, until rounding drives them apart as its inverse.

use nalgebra::DVector;

/// Steps a ladder has, each a quarter of the one before.
const RUNGS: usize = 60;

/// An entry of the Jacobian from differences.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Quotient {
    /// The quotient of the step that tells most.
    pub(super) value: f64,
    /// What it may be off; infinite if no step tells anything.
    pub(super) error: f64,
    /// The largest of the values at steps that agree with it.
    pub(super) size: f64,
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
    /// The same, a little wider: what of the quotient is noise right here.
    wider: [(f64, DVector<f64>); 2],
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
                wider: [value(1.07 * step), value(-1.07 * step)],
            }
        });
        let apart = |rung: &Rung| rung.step > 4.0 * f64::EPSILON * at[column].abs();
        Self {
            middle: f(at),
            rungs: rungs.filter(apart).collect(),
        }
    }

    /// The derivative of output `row`, and the remainder's slope for a `given` one.
    pub(super) fn quotient(&self, row: usize, grain: Grain, given: f64) -> Quotient {
        let samples: Vec<_> = self
            .rungs
            .iter()
            .filter_map(|rung| self.sample(rung, row, grain.precision))
            .collect();
        let rated = rated(&samples);
        let trusted = trusted(&samples, &rated);
        let Some(&best) = trusted.first() else {
            return Quotient {
                value: f64::NAN,
                error: f64::INFINITY,
                size: 0.0,
                smooth: true,
                slope: None,
            };
        };
        let (value, mut error) = rated[best];
        if samples.iter().all(|s| s.rise == 0.0) {
            // What moves by less than the grain is not seen to move.
            error += grain.size / samples[best].step;
        }
        Quotient {
            value,
            error,
            size: trusted.iter().map(|k| samples[*k].size).fold(0.0, f64::max),
            smooth: is_smooth(&samples, &rated, best),
            slope: slope(&samples, given),
        }
    }

    fn sample(&self, rung: &Rung, row: usize, precision: f64) -> Option<Sample> {
        let (ahead, behind, middle) = (rung.ahead.1[row], rung.behind.1[row], self.middle[row]);
        let size = ahead.abs().max(behind.abs()).max(middle.abs());
        let [(far, high), (near, low)] = &rung.wider;
        let (rise, wider) = (ahead - behind, (high[row] - low[row]) / (far - near));
        size.is_finite().then(|| Sample {
            step: rung.step,
            rise,
            ahead: (rung.ahead.0, ahead - middle),
            behind: (rung.behind.0, behind - middle),
            size,
            noise: (rise / (2.0 * rung.step) - wider).abs() * rung.step,
            rounding: 4.0 * precision * size,
        })
    }
}

/// How finely the values of an output are grained.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grain {
    /// The rounding of a value relative to it.
    precision: f64,
    /// The least change that was seen.
    size: f64,
}

impl Grain {
    /// The grain of output `row`: of doubles, or of singles if all values are such.
    pub(super) fn of(ladders: &[Ladder], row: usize) -> Self {
        let values = || {
            let rungs = |ladder: &'_ Ladder| -> Vec<(f64, f64)> {
                let middle = ladder.middle[row];
                let ahead = ladder.rungs.iter().map(|rung| (rung.ahead.1[row], middle));
                ahead.collect()
            };
            ladders.iter().flat_map(rungs)
        };
        let moves = values().map(|(y, middle)| (y - middle).abs());
        let size = moves
            .filter(|change| *change > 0.0)
            .fold(f64::INFINITY, f64::min);
        #[allow(clippy::float_cmp, reason = "a single is exactly itself")]
        let singles = size.is_finite() && values().all(|(y, _)| f64::from(y as f32) == y);
        Self {
            precision: if singles {
                f32::EPSILON.into()
            } else {
                f64::EPSILON
            },
            size: if size.is_finite() { size } else { 0.0 },
        }
    }
}

/// The differences of one output at one step.
struct Sample {
    step: f64,
    rise: f64,
    ahead: (f64, f64),
    behind: (f64, f64),
    /// The largest of its values.
    size: f64,
    /// How much the quotient depends on the very step, times the step.
    noise: f64,
    /// What rounding of the values alone may do to a difference.
    rounding: f64,
}

/// The central quotient at each step, and what it may be off: as much as quotients of this step and of smaller ones move, the
/// noise of which grows as the inverse of the step. The next larger step counts too: two quotients may agree by chance.
fn rated(samples: &[Sample]) -> Vec<(f64, f64)> {
    let quotient = |sample: &Sample| sample.rise / (2.0 * sample.step);
    let moves = samples.windows(2).map(|pair| {
        let apart = quotient(&pair[0]) - quotient(&pair[1]);
        apart.abs() * pair[0].step
    });
    let mut noise: Vec<f64> = moves.collect();
    for k in (1..noise.len()).rev() {
        noise[k - 1] = noise[k - 1].max(noise[k]);
    }
    let rate = |(k, sample): (usize, &Sample)| {
        let noise = noise
            .get(k.saturating_sub(1))
            .copied()
            .unwrap_or(f64::INFINITY);
        let error = 2.0 * noise.max(sample.noise).max(sample.rounding) / sample.step;
        (quotient(sample), error)
    };
    samples.iter().enumerate().map(rate).collect()
}

/// The steps whose quotients agree with those of all smaller steps within both errors, by place, the one that is known best
/// first.
///
/// Steps far above the scale of the function agree with nothing below. Once a value moves at all, steps at which it does not
/// are lost in its granularity. The last few steps have too little below them to be judged by. And a step over which the value
/// moves well out of the noise of small steps has to resolve what it does: else it spans several waves.
fn trusted(samples: &[Sample], rated: &[(f64, f64)]) -> Vec<usize> {
    let moves = samples.iter().any(|s| s.rise != 0.0);
    let told: Vec<_> = (0..samples.len().saturating_sub(3))
        .filter(|k| rated[*k].1.is_finite() && (!moves || samples[*k].rise != 0.0))
        .collect();
    let unresolved = |k: usize| rated[k].1 * samples[k].step;
    let noise = told
        .iter()
        .rev()
        .take(4)
        .map(|k| unresolved(*k))
        .fold(0.0, f64::max);
    let resolves = |k: &usize| {
        let moved = samples[*k].ahead.1.abs().max(samples[*k].behind.1.abs());
        unresolved(*k) <= 0.1 * moved || moved <= 8.0 * noise
    };
    let agrees = |(place, k): (usize, &usize)| {
        let (value, error) = rated[*k];
        let mut smaller = told[place + 1..].iter().map(|other| rated[*other]);
        let agree = smaller.all(|(other, theirs)| (value - other).abs() <= error + theirs);
        (agree && resolves(k)).then_some(*k)
    };
    let mut trusted: Vec<_> = told.iter().enumerate().filter_map(agrees).collect();
    trusted.sort_by(|a, b| rated[*a].1.total_cmp(&rated[*b].1));
    trusted
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
