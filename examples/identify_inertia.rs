//! The inertia tensor of a body from noisy gyroscope data, and how well it is known.

use levenberg_marquardt::LevenbergMarquardt;
use nalgebra::{DMatrix, DVector, Matrix3, Matrix6, SVector, Vector3};
use polhode::mechanics::{InertiaParameters, possible_inertia};
use polhode::motion::{MotionError, Rk4, Rollout, State, System, Torque};
use polhode::optimise::LeastSquares;

/// Seconds from one sample to the next.
pub const DT: f64 = 0.02;

/// What is found.
pub struct Identified {
    /// The tensor's xx, yy, zz, xy, xz, yz, kg m².
    pub entries: SVector<f64, 6>,
    /// Their covariance.
    pub covariance: Matrix6<f64>,
    /// How often residuals and Jacobian were computed.
    pub evaluations: usize,
}

/// The angular velocity that a gyroscope measures on a body that starts at rest, one sample after each torque.
pub fn gyroscope(
    tensor: &Matrix3<f64>,
    torques: &[Vector3<f64>],
    mut noise: impl FnMut() -> f64,
) -> Result<Vec<Vector3<f64>>, MotionError> {
    let system = System::new(*tensor, Torque::None)?;
    let rollout = Rollout::new(Rk4, system, State::at_rest(), DT, torques)?;
    let seen = rollout.states()[1..]
        .iter()
        .map(|state| state.angular_velocity);
    Ok(seen.map(|omega| omega.map(|c| c + noise())).collect())
}

/// How much a guess far from a ball counts: enough to keep a plate, which stands at infinity, from running there.
const PRIOR: f64 = 1e-4;

/// Where the search begins: 1 kg m² about each axis, in log-Cholesky parameters.
pub fn ball() -> DVector<f64> {
    DVector::from_vec(vec![-0.5 * 2.0_f64.ln(), 0.0, 0.0, 0.0, 0.0, 0.0])
}

/// What the motion of a guess misses, and its derivative. The guess is in log-Cholesky parameters: each is a body that can exist.
pub fn residuals(
    torques: &[Vector3<f64>],
    measured: &[Vector3<f64>],
) -> impl Fn(&DVector<f64>) -> Option<(DVector<f64>, DMatrix<f64>)> {
    let last = 3 * measured.len();
    move |guess| {
        let (tensor, by_guess) = possible_inertia(&guess.fixed_rows::<6>(0).into_owned());
        let system = System::new(tensor, Torque::None).ok()?;
        let rollout = Rollout::new(Rk4, system, State::at_rest(), DT, torques).ok()?;
        let (mut missed, mut jacobian) = (DVector::zeros(last + 6), DMatrix::zeros(last + 6, 6));
        let states = rollout.states()[1..].iter().zip(rollout.by_inertia());
        for (k, ((state, by_inertia), seen)) in states.zip(measured).enumerate() {
            let off = state.angular_velocity - seen;
            missed.fixed_rows_mut::<3>(3 * k).copy_from(&off);
            let slopes = by_inertia.fixed_rows::<3>(3) * by_guess;
            jacobian.fixed_rows_mut::<3>(3 * k).copy_from(&slopes);
        }
        let prior = (guess - ball()) * PRIOR;
        missed.rows_mut(last, 6).copy_from(&prior);
        jacobian.rows_mut(last, 6).fill_diagonal(PRIOR);
        Some((missed, jacobian))
    }
}

/// The tensor whose motion under known torques comes closest to what was measured.
pub fn identify(torques: &[Vector3<f64>], measured: &[Vector3<f64>]) -> Option<Identified> {
    let problem = LeastSquares::new(ball(), residuals(torques, measured));
    let (problem, report) = LevenbergMarquardt::new().minimize(problem);
    if !report.termination.was_successful() {
        return None;
    }
    let found = problem.parameters().fixed_rows::<6>(0).into_owned();
    let (tensor, by_found) = possible_inertia(&found);
    let covariance = problem.covariance()?.fixed_view::<6, 6>(0, 0).into_owned();
    Some(Identified {
        entries: InertiaParameters::MuJoCo.of_tensor(&tensor).into(),
        covariance: by_found * covariance * by_found.transpose(),
        evaluations: report.number_of_evaluations,
    })
}

/// Torques that turn the body every way.
pub fn torques(count: usize) -> Vec<Vector3<f64>> {
    let at = |t: f64| {
        Vector3::new(
            (1.3 * t).sin(),
            0.8 * (2.1 * t).cos(),
            (0.7 * t + 1.0).sin(),
        )
    };
    (0..count).map(|k| at(DT * k as f64)).collect()
}

/// Normally distributed numbers (Box and Muller 1958; splitmix64 beneath).
pub fn normal(mut seed: u64, deviation: f64) -> impl FnMut() -> f64 {
    let mut uniform = move || {
        seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = (seed ^ (seed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    };
    move || {
        let (radius, angle) = ((-2.0 * (1.0 - uniform()).ln()).sqrt(), uniform());
        deviation * radius * (std::f64::consts::TAU * angle).cos()
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let truth = Matrix3::new(0.6, 0.02, -0.03, 0.02, 0.8, 0.05, -0.03, 0.05, 1.0);
    let torques = torques(300);
    let measured = gyroscope(&truth, &torques, normal(1, 0.01))?;
    let found = identify(&torques, &measured).ok_or("no fit")?;
    for (k, name) in ["xx", "yy", "zz", "xy", "xz", "yz"].into_iter().enumerate() {
        let deviation = found.covariance[(k, k)].sqrt();
        println!("I_{name} = {:8.5} ± {deviation:.5} kg m²", found.entries[k]);
    }
    Ok(())
}
