//! A fit of six inertia parameters to 300 samples: the exact Jacobian against forward and central differences, one solver.

use criterion::{Criterion, criterion_group, criterion_main};
use levenberg_marquardt::LevenbergMarquardt;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use polhode::mechanics::possible_inertia;
use polhode::motion::{Rk4, Rollout, State, System, Torque};
use polhode::optimise::LeastSquares;

#[path = "../examples/identify_inertia.rs"]
#[allow(dead_code, unreachable_pub, reason = "it is a program of its own")]
mod identify_inertia;

use identify_inertia::{DT, ball, gyroscope, normal, residuals, torques};

/// Residuals and their Jacobian, where there are such.
type Residuals = Option<(DVector<f64>, DMatrix<f64>)>;

/// The residuals alone, as one without derivatives would have them.
fn missed(
    guess: &DVector<f64>,
    torques: &[Vector3<f64>],
    measured: &[Vector3<f64>],
) -> Option<DVector<f64>> {
    let (tensor, _) = possible_inertia(&guess.fixed_rows::<6>(0).into_owned());
    let system = System::new(tensor, Torque::None).ok()?;
    let rollout = Rollout::new(Rk4, system, State::at_rest(), DT, torques).ok()?;
    let pairs = rollout.states()[1..].iter().zip(measured);
    let off = pairs.flat_map(|(state, seen)| {
        let off: [f64; 3] = (state.angular_velocity - seen).into();
        off
    });
    Some(DVector::from_iterator(3 * measured.len(), off))
}

/// The same with quotients of differences: each side of a step, ahead and behind.
fn differenced(
    value: impl Fn(&DVector<f64>) -> Option<DVector<f64>>,
    sides: [f64; 2],
) -> impl Fn(&DVector<f64>) -> Residuals {
    move |at| {
        let middle = value(at)?;
        let mut jacobian = DMatrix::zeros(middle.len(), at.len());
        for column in 0..at.len() {
            let side = |shift: f64| match shift == 0.0 {
                true => Some(middle.clone()),
                false => {
                    let mut moved = at.clone();
                    moved[column] += shift;
                    value(&moved)
                }
            };
            let [ahead, behind] = sides.map(side);
            let rise = ahead? - behind?;
            jacobian.set_column(column, &(rise / (sides[0] - sides[1])));
        }
        Some((middle, jacobian))
    }
}

fn fit(criterion: &mut Criterion) {
    let truth = Matrix3::new(0.6, 0.02, -0.03, 0.02, 0.8, 0.05, -0.03, 0.05, 1.0);
    let torques = torques(300);
    let measured = gyroscope(&truth, &torques, normal(1, 0.01)).expect("a body");
    let value = |guess: &DVector<f64>| missed(guess, &torques, &measured);
    let mut group = criterion.benchmark_group("identify");
    let mut solve = |name: &str, residuals: &dyn Fn(&DVector<f64>) -> Residuals| {
        let run = || LevenbergMarquardt::new().minimize(LeastSquares::new(ball(), residuals));
        let (problem, report) = run();
        let gradient = problem
            .gauss_newton_step()
            .map_or(f64::NAN, |step| step.norm());
        println!(
            "{name}: {} evaluations, and Newton's next step is {gradient:.0e}",
            report.number_of_evaluations
        );
        group.bench_function(name, |b| b.iter(run));
    };
    solve("exact", &residuals(&torques, &measured));
    solve("forward differences", &differenced(value, [1e-8, 0.0]));
    solve("central differences", &differenced(value, [1e-5, -1e-5]));
    group.finish();
}

criterion_group!(benches, fit);
criterion_main!(benches);
