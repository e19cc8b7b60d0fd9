//! The step that is timed, and its Jacobian by central differences.
#![allow(dead_code, reason = "no bench takes all of it")]

use nalgebra::{Matrix3, SMatrix, Vector3, Vector6};
use polhode::motion::{Rk4, Scheme, State, System, Torque};

pub(crate) const STEP: f64 = 0.01;

pub(crate) fn full() -> Matrix3<f64> {
    Matrix3::new(0.6, 0.02, -0.03, 0.02, 0.8, 0.05, -0.03, 0.05, 1.0)
}

pub(crate) fn principal() -> Matrix3<f64> {
    Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0))
}

pub(crate) fn start() -> State<f64> {
    State::at_rest().turning(Vector3::new(3.0, 0.5, -0.9))
}

/// Fifteen columns by thirty steps.
pub(crate) fn central_differences(
    system: &System<f64, Torque>,
    state: &State<f64>,
) -> SMatrix<f64, 6, 15> {
    let width = 6e-6;
    let base = Rk4.step(system, 0.0, state, STEP);
    let end = |column: usize, amount: f64| {
        let (mut inertia, mut added, mut tangent) =
            (*system.inertia(), Vector3::zeros(), Vector6::zeros());
        match column {
            0..6 => tangent[column] = amount,
            6..9 => added[column - 6] = amount,
            _ => {
                let (r, c) = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)][column - 9];
                inertia[(r, c)] += amount;
                inertia[(c, r)] = inertia[(r, c)];
            }
        }
        let moved = System::over(inertia, Torque::None, added);
        base.difference(&Rk4.step(&moved, 0.0, &state.perturbed(&tangent), STEP))
    };
    SMatrix::from_columns(&std::array::from_fn::<_, 15, _>(|c| {
        (end(c, width) - end(c, -width)) / (2.0 * width)
    }))
}
