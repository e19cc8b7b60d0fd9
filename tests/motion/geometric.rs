//! The geometric steps: their order, what they keep, and that they run backwards.

use super::turning::{bracket_defect, start, tensor};
use nalgebra::Vector3;
use polhode::motion::{
    Body, Dop853, FixedStep, Frame, ImplicitMidpoint, MoserVeselov, Rk4, Scheme, Splitting, State,
    Stepper, System, Taylor, Torque, TorqueLaw, jacobian,
};

fn free() -> System<f64, Torque> {
    System::new(tensor(), Torque::None).expect("a body")
}

fn top() -> System<f64, Torque> {
    let arm = Vector3::new(0.1, -0.2, 0.5);
    System::new(tensor(), Torque::Gravity { weight: 3.0, arm }).expect("a body")
}

/// The end of a run of steps `h`.
fn end<S: Scheme<Torque>>(scheme: S, system: System<f64, Torque>, h: f64, time: f64) -> State<f64> {
    let mut run = FixedStep::new(scheme, system, start(), h).expect("a step");
    run.advance_to(time).expect("finite");
    *run.state()
}

fn order<S: Scheme<Torque> + Copy>(scheme: S, system: System<f64, Torque>, h: f64) -> f64 {
    let exact = end(Taylor::of_order(24), system, 0.05, 2.0);
    let error = |h| exact.difference(&end(scheme, system, h, 2.0)).norm();
    (error(h) / error(0.5 * h)).log2()
}

#[track_caller]
fn assert_order<S: Scheme<Torque> + Copy>(scheme: S, system: System<f64, Torque>, h: f64, p: f64) {
    let found = order(scheme, system, h);
    assert!((found - p).abs() < 0.35, "{found} for {p}");
}

#[test]
fn each_step_has_its_order() {
    let body = Body::new(&tensor()).expect("a body");
    for system in [free(), top(), System::principal(&body, *top().law())] {
        assert_order(Splitting::SECOND, system, 0.02, 2.0);
        assert_order(Splitting::FOURTH, system, 0.1, 4.0);
        assert_order(Splitting::SIXTH, system, 0.2, 6.0);
        assert_order(ImplicitMidpoint, system, 0.02, 2.0);
        assert_order(MoserVeselov::SECOND, system, 0.02, 2.0);
    }
    assert_order(MoserVeselov::FOURTH, free(), 0.1, 4.0);
    assert_order(MoserVeselov::SIXTH, free(), 0.1, 6.0);
    assert_order(MoserVeselov::EIGHTH, free(), 0.2, 8.0);
    assert_order(MoserVeselov::TENTH, free(), 0.25, 10.0);
    assert_order(MoserVeselov::FOURTH, top(), 0.02, 2.0);
}

#[test]
fn a_torque_of_the_time_or_of_the_speed_keeps_the_order() {
    let sinusoid = |frame| Torque::Sinusoid {
        frame,
        amplitude: Vector3::new(0.5, -0.3, 0.8),
        angular_frequency: 1.5,
        phase: 0.4,
    };
    for law in [
        Torque::Damping { coefficient: 0.5 },
        sinusoid(Frame::Body),
        sinusoid(Frame::Space),
    ] {
        let system = System::new(tensor(), law).expect("a body");
        assert_order(Splitting::SECOND, system, 0.02, 2.0);
        assert_order(Splitting::FOURTH, system, 0.1, 4.0);
        assert_order(Splitting::SIXTH, system, 0.2, 6.0);
        assert_order(ImplicitMidpoint, system, 0.02, 2.0);
        assert_order(MoserVeselov::FOURTH, system, 0.02, 2.0);
    }
}

fn energy(system: &System<f64, Torque>, state: &State<f64>) -> f64 {
    let omega = &state.angular_velocity;
    let kinetic = 0.5 * omega.dot(&(system.inertia() * omega));
    match system.law() {
        Torque::Gravity { weight, arm } => kinetic + weight * state.attitude.to_space(arm).z,
        _ => kinetic,
    }
}

fn momentum(system: &System<f64, Torque>, state: &State<f64>) -> Vector3<f64> {
    state
        .attitude
        .to_space(&(system.inertia() * state.angular_velocity))
}

/// The largest changes of energy and of momentum in `steps` steps.
fn drifts<S: Scheme<Torque>>(
    scheme: &S,
    system: &System<f64, Torque>,
    h: f64,
    steps: u32,
) -> (f64, f64) {
    let mut state = start();
    let (e, m) = (energy(system, &state), momentum(system, &state));
    let (mut most, mut turned) = (0.0_f64, 0.0_f64);
    for n in 0..steps {
        state = scheme.step(system, h * f64::from(n), &state, h);
        most = most.max((energy(system, &state) - e).abs() / e.abs());
        turned = turned.max((momentum(system, &state) - m).norm() / m.norm());
    }
    (most, turned)
}

#[test]
fn the_momentum_of_a_free_body_stays_and_the_energy_does_not_drift() {
    let system = free();
    // Each step rounds some ten times; three thousand of them walk at random or at worst add up.
    let rounding = 3_000.0 * 1e-15;
    for (scheme, bound) in [
        (Splitting::SECOND, 1e-1),
        (Splitting::FOURTH, 1e-3),
        (Splitting::SIXTH, 1e-4),
    ] {
        let (short, turned) = drifts(&scheme, &system, 0.2, 200);
        assert!(turned < rounding && short < bound, "{short:e} {turned:e}");
        let (long, turned) = drifts(&scheme, &system, 0.2, 3_000);
        assert!(turned < rounding, "{turned:e}");
        assert!(
            long < 1.5 * short + rounding,
            "{scheme:?}: {short:e} then {long:e}"
        );
    }
    for (energy, turned) in [
        drifts(&ImplicitMidpoint, &system, 0.2, 3_000),
        drifts(&MoserVeselov::SECOND, &system, 0.2, 3_000),
        drifts(&MoserVeselov::FOURTH, &system, 0.2, 3_000),
        drifts(&MoserVeselov::TENTH, &system, 0.2, 3_000),
    ] {
        assert!(
            energy < rounding && turned < rounding,
            "{energy:e} {turned:e}"
        );
    }
}

#[test]
fn the_energy_of_a_top_does_not_drift_either() {
    let system = top();
    let bounded = |(short, _): (f64, f64), (long, _): (f64, f64)| {
        assert!(long < 2.0 * short && short < 0.1, "{short:e} then {long:e}");
    };
    let (few, many) = (400, 4_000);
    for scheme in [Splitting::SECOND, Splitting::FOURTH, Splitting::SIXTH] {
        bounded(
            drifts(&scheme, &system, 0.1, few),
            drifts(&scheme, &system, 0.1, many),
        );
    }
    bounded(
        drifts(&MoserVeselov::SECOND, &system, 0.1, few),
        drifts(&MoserVeselov::SECOND, &system, 0.1, many),
    );
}

fn reversed<S: Scheme<Torque>>(scheme: &S, system: &System<f64, Torque>, time: f64) -> f64 {
    let there = scheme.step(system, time, &start(), 0.3);
    let back = scheme.step(system, time + 0.3, &there, -0.3);
    start().difference(&back).norm()
}

#[test]
fn a_step_back_undoes_a_step() {
    let sinusoid = System::new(
        tensor(),
        Torque::Sinusoid {
            frame: Frame::Space,
            amplitude: Vector3::new(0.5, -0.3, 0.8),
            angular_frequency: 1.5,
            phase: 0.4,
        },
    )
    .expect("a body");
    for system in [free(), top(), sinusoid] {
        for found in [
            reversed(&Splitting::SECOND, &system, 0.7),
            reversed(&Splitting::FOURTH, &system, 0.7),
            reversed(&Splitting::SIXTH, &system, 0.7),
            reversed(&ImplicitMidpoint, &system, 0.7),
            reversed(&MoserVeselov::SECOND, &system, 0.7),
            reversed(&MoserVeselov::FOURTH, &system, 0.7),
            reversed(&MoserVeselov::TENTH, &system, 0.7),
        ] {
            assert!(found < 2e-14, "{found:e}");
        }
        // What is not symmetric does not.
        assert!(reversed(&Rk4, &system, 0.7) > 1e-8);
    }
}

fn defect<S: Scheme<Torque>>(scheme: &S, system: &System<f64, Torque>) -> f64
where
    Torque: TorqueLaw<f64>,
{
    let step = jacobian::by_dual_numbers::<6, _, _>(scheme, system, 0.0, &start(), 0.3);
    bracket_defect(system.inertia(), step.matrix, &step.state)
}

#[test]
fn symplectic_steps_keep_the_brackets() {
    for system in [free(), top()] {
        for scheme in [Splitting::SECOND, Splitting::FOURTH, Splitting::SIXTH] {
            assert!(defect(&scheme, &system) < 1e-13);
        }
        let found = defect(&MoserVeselov::SECOND, &system);
        assert!(found < 1e-13, "{found:e}");
        assert!(defect(&Dop853, &system) < 1e-6);
    }
    // These keep energy and momentum, and the brackets to their order only.
    for found in [
        defect(&ImplicitMidpoint, &free()),
        defect(&MoserVeselov::FOURTH, &free()),
    ] {
        assert!((1e-5..1e-1).contains(&found), "{found:e}");
    }
}
