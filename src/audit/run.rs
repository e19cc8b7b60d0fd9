//! Runs of a free body: what a step keeps, and its order.

use super::finding::{Audit, Finding, Witnesses};
use super::step::Step;
use crate::mechanics::vis_viva;
use crate::motion::{Body, FreeBody, State};
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::TAU;

/// Turns of the run, and the least and most steps for them.
const TURNS: f64 = 20.0;
const STEPS: [f64; 2] = [200.0, 20_000.0];

/// Drift that is told, as a part of the whole or in rad.
const DRIFT: f64 = 1e-2;

/// What a free run from `start` keeps, and what is to be said of it.
pub(super) fn free_run(
    f: &mut Step<'_>,
    inertia: &Matrix3<f64>,
    start: &State<f64>,
    dt: f64,
    audit: &mut Audit,
) {
    let steps = TURNS * TAU / (start.angular_velocity.norm() * dt);
    let steps = steps.clamp(STEPS[0], STEPS[1]) as usize;
    let kept = |state: &State<f64>| {
        let momentum = inertia * state.angular_velocity;
        let energy = vis_viva(inertia, &state.angular_velocity);
        (energy, state.attitude.normalised().to_space(&momentum))
    };
    let (energy, momentum) = kept(start);
    let (mut state, mut off_unit) = (*start, 0.0_f64);
    let mut witnesses = Witnesses {
        step: dt,
        steps: 0,
        energy: 0.0,
        momentum: 0.0,
        turned: 0.0,
    };
    while witnesses.steps < steps {
        state = f(&state, &Vector3::zeros(), dt);
        let (now, turned) = kept(&state);
        witnesses.steps += 1;
        witnesses.energy = larger(witnesses.energy, now / energy - 1.0);
        witnesses.momentum = larger(witnesses.momentum, turned.norm() / momentum.norm() - 1.0);
        witnesses.turned = larger(witnesses.turned, turned.angle(&momentum));
        off_unit = larger(off_unit, state.attitude.norm_squared().sqrt() - 1.0);
        // Far beyond every doubt, and before numbers overflow.
        if !state.is_finite() || now > 100.0 * energy {
            break;
        }
    }
    audit.witnesses = Some(witnesses);
    let within = |change: f64, limit: f64| change.abs() <= limit;
    if !within(off_unit, 1e-3) {
        audit.findings.push(Finding::NotUnit(off_unit));
    }
    let grows = witnesses.energy.is_nan() || witnesses.energy > 1.0;
    let drifts = [witnesses.energy, witnesses.momentum, witnesses.turned];
    if grows && audit.findings.is_empty() {
        audit.findings.push(Finding::Unstable(witnesses));
    } else if !drifts.iter().all(|drift| within(*drift, DRIFT)) {
        audit.findings.push(Finding::Drift(witnesses));
    }
}

/// The larger of two numbers by size, or what is not a number.
fn larger(a: f64, b: f64) -> f64 {
    if b.abs() <= a.abs() { a } else { b }
}

/// The order of a step, from the error after eight steps of this length and as many shorter ones.
pub(super) fn order(
    f: &mut Step<'_>,
    inertia: &Matrix3<f64>,
    start: &State<f64>,
    dt: f64,
) -> Option<f64> {
    let body = Body::new(inertia).ok()?;
    let span = 8.0 * dt;
    let exact = FreeBody::new(&body, start).at(span).ok()?;
    let errors: Vec<f64> = (0..7)
        .map(|halvings| {
            let steps = 8 << halvings;
            let h = span / f64::from(steps);
            let mut state = *start;
            for _ in 0..steps {
                state = f(&state, &Vector3::zeros(), h);
            }
            exact.difference(&state).norm()
        })
        .collect();
    let slopes: Vec<f64> = errors
        .windows(2)
        .map(|pair| (pair[0] / pair[1]).log2())
        .collect();
    // Two halvings in a row that agree: neither too long nor lost in rounding.
    let steady = slopes
        .windows(2)
        .rev()
        .find(|pair| pair[1] > 0.5 && (pair[0] - pair[1]).abs() < 0.15);
    steady.map(|pair| pair[1])
}
