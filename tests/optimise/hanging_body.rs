//! Ten inertial parameters of a body that hangs from a fixed point, from its angular velocity.

use levenberg_marquardt::LevenbergMarquardt;
use nalgebra::{DMatrix, DVector, SVector, Vector3};
use polhode::mechanics::{InertiaParameters, inertial_parameters, log_cholesky};
use polhode::motion::{Law, MotionError, Number, Rk4, Rollout, State, System, Torque, TorqueLaw};
use polhode::optimise::LeastSquares;

const GRAVITY: f64 = 9.81;
const DT: f64 = 0.02;
const STEPS: usize = 100;

/// m, m c and the tensor about the fixed point. The mass alone moves nothing: the moment is m c × g.
fn body<T: Number>([_, x, y, z, entries @ ..]: [T; 10]) -> System<T, Law<T>>
where
    Law<T>: TorqueLaw<T>,
{
    let law = Law::Gravity {
        weight: T::of(GRAVITY),
        arm: Vector3::new(x, y, z),
    };
    let tensor = InertiaParameters::MuJoCo.tensor(entries);
    System::over(tensor, law, Vector3::from_element(T::of(0.0)))
}

fn run(
    parameters: [f64; 10],
    torques: &[Vector3<f64>],
) -> Result<Rollout<'_, Rk4, Torque>, MotionError> {
    let start = State::at_rest().turning(Vector3::new(1.0, 0.5, -0.9));
    Rollout::new(Rk4, body(parameters), start, DT, torques)
}

#[test]
fn its_tensor_and_its_centre_are_found() {
    let truth = SVector::from([2.0, 0.1, -0.2, 0.5, 0.6, 0.8, 0.7, 0.02, -0.03, 0.05]);
    let torques: Vec<_> = (0..STEPS)
        .map(|k| Vector3::new((0.1 * k as f64).sin(), 0.4, (0.17 * k as f64).cos()))
        .collect();
    let measured = run(truth.into(), &torques).expect("a motion");
    let sample = |state: &State<f64>| state.angular_velocity;
    let guess = SVector::from([2.0, 0.0, 0.0, 0.3, 0.9, 0.9, 0.9, 0.0, 0.0, 0.0]);
    let (guess, _) = log_cholesky(&guess).expect("a body");
    let residuals = |x: &DVector<f64>| {
        let (parameters, by_x) = inertial_parameters(&x.fixed_rows::<10>(0).into_owned());
        let rollout = run(parameters.into(), &torques).ok()?;
        let (mut missed, mut jacobian) = (
            DVector::zeros(3 * STEPS + 1),
            DMatrix::zeros(3 * STEPS + 1, 10),
        );
        let slopes = rollout.by_parameters(body, parameters.into());
        for (k, slopes) in slopes.enumerate() {
            let off = sample(&rollout.states()[k + 1]) - sample(&measured.states()[k + 1]);
            missed.fixed_rows_mut::<3>(3 * k).copy_from(&off);
            let slopes = slopes.fixed_rows::<3>(3) * by_x;
            jacobian.fixed_rows_mut::<3>(3 * k).copy_from(&slopes);
        }
        // The mass comes from the scales.
        missed[3 * STEPS] = parameters[0] - truth[0];
        jacobian.row_mut(3 * STEPS).copy_from(&by_x.row(0));
        Some((missed, jacobian))
    };
    let start = DVector::from_column_slice(guess.as_slice());
    let (problem, report) = LevenbergMarquardt::new().minimize(LeastSquares::new(start, residuals));
    assert!(report.termination.was_successful());
    let (found, _) = inertial_parameters(&problem.parameters().fixed_rows::<10>(0).into_owned());
    assert!((found - truth).amax() < 1e-9, "{found}");
}
