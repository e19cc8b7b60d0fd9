//! Derivatives of a step by central differences.

use crate::num_dual_step::pulled_back;
use crate::turns::{TURNS, in_turns, repeated};
use nalgebra::{SMatrix, SVector, Vector3, Vector6};
use polhode::motion::{Rk4, Scheme, SmoothLaw, State, System};
use std::hint::black_box;

const STEP: f64 = crate::reference_step::STEP;
const WIDTH: f64 = 6e-6;

/// The tangent of the result with the input moved by an amount along a direction.
#[cfg_attr(not(debug_assertions), inline(always))]
fn moved<L: SmoothLaw>(
    system: &System<f64, L>,
    state: &State<f64>,
    base: &State<f64>,
    by: &SVector<f64, 15>,
) -> Vector6<f64> {
    let mut inertia = *system.inertia();
    for (i, (r, c)) in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]
        .into_iter()
        .enumerate()
    {
        inertia[(r, c)] += by[9 + i];
        inertia[(c, r)] = inertia[(r, c)];
    }
    let torque = by.fixed_rows::<3>(6).into_owned();
    let moved = System::over(inertia, *system.law(), torque);
    let start = state.perturbed(&by.fixed_rows::<6>(0).into_owned());
    base.difference(&Rk4.step(&moved, 0.0, &start, STEP))
}

fn columns<const N: usize, L: SmoothLaw>(
    system: &System<f64, L>,
    state: &State<f64>,
) -> SMatrix<f64, 6, N> {
    let base = Rk4.step(system, 0.0, state, STEP);
    let mut matrix = SMatrix::<f64, 6, N>::zeros();
    for k in 0..N {
        let mut by = SVector::<f64, 15>::zeros();
        by[k] = WIDTH;
        let forward = moved(system, state, &base, &by);
        by[k] = -WIDTH;
        let backward = moved(system, state, &base, &by);
        matrix.set_column(k, &((forward - backward) / (2.0 * WIDTH)));
    }
    matrix
}

fn along<L: SmoothLaw>(
    system: &System<f64, L>,
    state: &State<f64>,
    direction: &SVector<f64, 15>,
) -> Vector6<f64> {
    let base = Rk4.step(system, 0.0, state, STEP);
    let by = direction * WIDTH;
    let (forward, backward) = (
        moved(system, state, &base, &by),
        moved(system, state, &base, &-by),
    );
    (forward - backward) / (2.0 * WIDTH)
}

/// The step's own time, and those of its derivatives; the gradient of many steps by the columns of each.
pub(crate) fn times<L: SmoothLaw>(
    system: &System<f64, L>,
    state: &State<f64>,
    torques: &[Vector3<f64>],
    costs: &[Vector6<f64>],
) -> [f64; 7] {
    let (direction, covector) = (&SVector::from_element(0.1), &Vector6::from_element(0.3));
    let (system, state) = black_box((system, state));
    in_turns(
        TURNS,
        [
            repeated!(Rk4.step(black_box(system), 0.0, state, STEP)),
            repeated!(columns::<6, L>(black_box(system), state)),
            repeated!(columns::<9, L>(black_box(system), state)),
            repeated!(columns::<15, L>(black_box(system), state)),
            repeated!(along(black_box(system), state, direction)),
            repeated!(columns::<15, L>(black_box(system), state).tr_mul(black_box(covector))),
            repeated!(gradient(system, state, torques, costs)),
        ],
    )
}

/// The covector of the start, backwards through the columns of each step.
fn gradient<L: SmoothLaw>(
    system: &System<f64, L>,
    state: &State<f64>,
    torques: &[Vector3<f64>],
    costs: &[Vector6<f64>],
) -> SVector<f64, 15> {
    let (mut state, mut steps) = (*state, Vec::with_capacity(torques.len()));
    for torque in torques {
        let system = system.with_torque(*torque);
        steps.push(columns::<15, L>(&system, &state));
        state = Rk4.step(&system, 0.0, &state, STEP);
    }
    pulled_back(&steps, costs)
}
