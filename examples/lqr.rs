//! A body that spins about its middle axis, which it would leave, is held there by a linear regulator.

use nalgebra::{Matrix3, Matrix6, SMatrix, Vector3, Vector6};
use polhode::motion::{MotionError, Rk4, Scheme, State, System, Torque};

/// Seconds a step.
pub const DT: f64 = 0.05;

/// The regulator of a motion whose linearisation is the same at each step: torque = −gain · error.
pub struct Regulator {
    /// Rows: torque in body axes; columns: error (θ, ω).
    pub gain: SMatrix<f64, 3, 6>,
    /// The cost that is still to come is errorᵀ · cost · error.
    pub cost: Matrix6<f64>,
    /// The error after a step, of the error before it, without the regulator.
    pub open: Matrix6<f64>,
    /// The same with the regulator.
    pub closed: Matrix6<f64>,
}

/// Weight of the error (θ, ω) in the cost, summed over all steps.
pub const ERROR: f64 = 1.0;
/// Weight of the torque.
pub const TORQUE: f64 = 0.1;

impl Regulator {
    /// By Riccati's recursion, backwards until it stands still.
    pub fn new(system: &System<f64, Torque>, reference: &State<f64>) -> Option<Self> {
        let step = Rk4.step_with_jacobian::<9>(system, 0.0, reference, DT);
        let (a, b) = (step.by_state(), step.by_torque());
        let mut cost = Matrix6::identity() * ERROR;
        for _ in 0..10_000 {
            let weight = Matrix3::identity() * TORQUE + b.transpose() * cost * b;
            let gain = weight.try_inverse()? * b.transpose() * cost * a;
            let closed = a - b * gain;
            let next = Matrix6::identity() * ERROR + a.transpose() * cost * closed;
            if (next - cost).amax() < 1e-12 * cost.amax() {
                return Some(Self {
                    gain,
                    cost,
                    open: a,
                    closed,
                });
            }
            cost = (next + next.transpose()) / 2.0;
        }
        None
    }
}

/// The error after each step and the cost, the body left `off` the reference at the start.
pub fn run(
    system: &System<f64, Torque>,
    regulator: &Regulator,
    mut reference: State<f64>,
    off: &Vector6<f64>,
    steps: usize,
) -> (Vec<Vector6<f64>>, f64) {
    let (mut state, mut cost) = (reference.perturbed(off), 0.0);
    let errors = (0..steps).map(|k| {
        let error = reference.difference(&state);
        let torque = -regulator.gain * error;
        cost += ERROR * error.norm_squared() + TORQUE * torque.norm_squared();
        let time = k as f64 * DT;
        state = Rk4.step(&system.with_torque(torque), time, &state, DT);
        reference = Rk4.step(system, time, &reference, DT);
        error
    });
    (errors.collect(), cost)
}

/// A body, and its spin about the middle axis.
pub fn spinning() -> Result<(System<f64, Torque>, State<f64>), MotionError> {
    let inertia = Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0));
    let system = System::new(inertia, Torque::None)?;
    Ok((
        system,
        State::at_rest().turning(Vector3::new(0.0, 2.0, 0.0)),
    ))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (system, reference) = spinning()?;
    let regulator = Regulator::new(&system, &reference).ok_or("no regulator")?;
    let off = Vector6::new(0.2, -0.1, 0.15, 0.1, 0.3, -0.2);
    let (errors, cost) = run(&system, &regulator, reference, &off, 400);
    for (k, error) in errors.iter().enumerate().step_by(40) {
        println!("{:4.1} s: error {:.2e}", k as f64 * DT, error.norm());
    }
    println!(
        "cost {cost:.3}, by the linear theory {:.3}",
        off.dot(&(regulator.cost * off))
    );
    Ok(())
}
