//! Inertia, speed and time of any size: the motion of a body k times as heavy is the same, and that of one s times as
//! fast is the same at a time 1/s of it.

use super::turning::{start, tensor};
use nalgebra::Vector3;
use polhode::motion::{
    Body, Dop853, Dop853Motion, FixedStep, FreeBody, ImplicitMidpoint, MoserVeselov, MotionError,
    Rk4, Scheme, Splitting, State, Stepper, System, Taylor, TaylorMotion, Torque,
};

/// A size of the inertia and one of the speed.
type Scale = (f64, f64);

/// With speeds whose square is still a number, also when the size of the inertia is a factor of it.
const SCALES: [Scale; 14] = [
    (1e150, 1.0),
    (1e-150, 1.0),
    (1.0, 1e8),
    (1.0, 1e-8),
    (1e150, 1e-8),
    (1e-150, 1e8),
    (1.0, 1e80),
    (1.0, 1e-75),
    (1.0, 1e-80),
    (1e-70, 1e-80),
    (1.0, 1e140),
    (1.0, 1e-140),
    (1e-150, 1e-75),
    (1e150, 1e75),
];

const TIME: f64 = 2.0;

/// A torque of each kind, of a size that goes with the scale.
fn laws((size, speed): Scale) -> [Torque; 4] {
    let v = Vector3::new(0.3, -0.5, 0.2);
    [
        Torque::None,
        Torque::Damping {
            coefficient: 0.1 * size * speed,
        },
        Torque::Gravity {
            // Not squared first: a speed of 1e-140 is a number, and so is the whole.
            weight: 3.0 * size * speed * speed,
            arm: v,
        },
        Torque::Sinusoid {
            frame: polhode::motion::Frame::Space,
            amplitude: v * (size * speed * speed),
            angular_frequency: 3.0 * speed,
            phase: 0.4,
        },
    ]
}

/// The end of a motion at a scale, ω over its speed.
type End<'a> = &'a dyn Fn(Scale, usize) -> Result<State<f64>, MotionError>;

fn assert_alike(name: &str, end: End<'_>, laws: usize) {
    let mut off = Vec::new();
    for law in 0..laws {
        let plain = end((1.0, 1.0), law).expect("finite");
        for (size, speed) in SCALES {
            let apart = end((size, speed), law).map(|found| {
                let found = found.turning(found.angular_velocity / speed);
                plain.difference(&found).amax()
            });
            // Roundings of some hundred steps, that fall otherwise at another scale.
            if !matches!(apart, Ok(apart) if apart < 1e-11) {
                off.push(format!("law {law}, {size:e} {speed:e}: {apart:?}"));
            }
        }
    }
    assert!(off.is_empty(), "{name}: {off:#?}");
}

fn system(scale: Scale, law: usize) -> (System<f64, Torque>, State<f64>) {
    let system = System::new(tensor() * scale.0, laws(scale)[law]).expect("a body");
    let start = start();
    (system, start.turning(start.angular_velocity * scale.1))
}

fn by_steps<S: Scheme<Torque> + Copy>(
    scheme: S,
) -> impl Fn(Scale, usize) -> Result<State<f64>, MotionError> {
    move |scale, law| {
        let (system, start) = system(scale, law);
        let mut run = FixedStep::new(scheme, system, start, 0.05 / scale.1)?;
        run.advance_to(TIME / scale.1)?;
        Ok(*run.state())
    }
}

#[test]
fn steps_of_fixed_length_do_not_care_for_the_scale() {
    assert_alike("Runge-Kutta", &by_steps(Rk4), 4);
    assert_alike("DOP853", &by_steps(Dop853), 4);
    assert_alike("Taylor", &by_steps(Taylor::of_order(16)), 4);
    assert_alike("splitting", &by_steps(Splitting::SIXTH), 4);
    assert_alike("implicit midpoint", &by_steps(ImplicitMidpoint), 4);
    assert_alike("Moser-Veselov", &by_steps(MoserVeselov::SECOND), 4);
    assert_alike(
        "Moser-Veselov of order 4",
        &by_steps(MoserVeselov::FOURTH),
        4,
    );
}

#[test]
fn the_step_that_follows_from_a_tolerance_does_not_care_for_the_scale() {
    let by_taylor = |scale: Scale, law: usize| {
        let (system, start) = system(scale, law);
        let body = Body::new(system.inertia())?;
        let mut motion = TaylorMotion::new(&body, *system.law(), &start, 1e-15)?;
        motion.advance_to(TIME / scale.1)?;
        Ok(*motion.state())
    };
    assert_alike("Taylor", &by_taylor, 4);
    let by_dop853 = |scale: Scale, law: usize| {
        let (system, start) = system(scale, law);
        let mut motion = Dop853Motion::new(system, &start, 1e-14)?;
        motion.advance_to(TIME / scale.1)?;
        Ok(*motion.state())
    };
    assert_alike("DOP853", &by_dop853, 4);
}

#[test]
fn the_exact_free_body_does_not_care_for_the_scale() {
    let exact = |scale: Scale, law: usize| {
        let (system, start) = system(scale, law);
        let body = Body::new(system.inertia())?;
        let motion = FreeBody::new(&body, &start);
        motion.at(TIME / scale.1)
    };
    assert_alike("exact", &exact, 1);
}

#[test]
fn a_damped_body_comes_to_rest_below_the_smallest_numbers() {
    let body = Body::new(&tensor()).expect("a body");
    let law = Torque::Damping { coefficient: 1.0 };
    let mut series = TaylorMotion::new(&body, law, &start(), 1e-12).expect("a motion");
    let system = System::principal(&body, law);
    let mut steps =
        Dop853Motion::new(system, &body.state_along(&start()), 1e-12).expect("a motion");
    // A thousand times e-fold and more: 1e-308 is the least number with a reciprocal.
    series.advance_to(5e3).expect("rest");
    steps.end_at(5e3).expect("rest");
    let apart = series.state().difference(&body.state_from(steps.state()));
    assert!(apart.amax() < 1e-9, "{apart}");
    assert!(series.state().angular_velocity.amax() < 1e-300);
}
