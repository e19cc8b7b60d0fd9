//! Dynamics code under audit: each slip is planted and named, and sound code is not blamed.

#[path = "audit/rapier.rs"]
mod rapier;

use nalgebra::{Matrix3, Vector3};
use polhode::audit::{self, Audit, Finding, Gyroscopic, Turning, Unseen, Where};
use polhode::motion::{
    Dop853, ImplicitMidpoint, MoserVeselov, MotionError, Quaternion, Rk4, Scheme, Splitting, State,
    System, Torque,
};

fn inertia() -> Matrix3<f64> {
    Matrix3::new(0.6, 0.02, -0.03, 0.02, 0.8, 0.05, -0.03, 0.05, 1.0)
}

fn start() -> State<f64> {
    State {
        attitude: Quaternion::exp(&Vector3::new(0.4, -1.1, 0.7)),
        angular_velocity: Vector3::new(3.0, 0.5, -0.9),
    }
}

fn negated() -> Matrix3<f64> {
    Matrix3::from_fn(|r, c| {
        if r == c {
            inertia()[(r, c)]
        } else {
            -inertia()[(r, c)]
        }
    })
}

fn diagonal() -> Matrix3<f64> {
    Matrix3::from_diagonal(&inertia().diagonal())
}

fn inverse(tensor: Matrix3<f64>) -> Matrix3<f64> {
    tensor.try_inverse().expect("regular")
}

/// I⁻¹ (M − factor ω × Iω) with a tensor for each.
fn euler(
    [term, of_inverse]: [Matrix3<f64>; 2],
    factor: f64,
) -> impl Fn(&Vector3<f64>, &Vector3<f64>) -> Vector3<f64> {
    let inverse = inverse(of_inverse);
    move |omega, torque| inverse * (torque - omega.cross(&(term * omega)) * factor)
}

fn of(f: impl Fn(&Vector3<f64>, &Vector3<f64>) -> Vector3<f64>) -> Vec<Finding> {
    audit::acceleration(f, &inertia())
        .expect("a body")
        .findings()
        .to_vec()
}

#[test]
fn slips_of_an_acceleration() {
    let whole = [inertia(), inertia()];
    assert_eq!(of(euler(whole, 1.0)), []);
    for (factor, slip) in [
        (0.0, Gyroscopic::Missing),
        (-1.0, Gyroscopic::Negated),
        (2.0, Gyroscopic::Doubled),
        (0.5, Gyroscopic::Halved),
    ] {
        assert_eq!(of(euler(whole, factor)), [Finding::Gyroscopic(slip)]);
    }
    for (tensor, finding) in [
        (diagonal(), Finding::DiagonalOnly as fn(Where) -> Finding),
        (negated(), Finding::ProductsNegated),
    ] {
        assert_eq!(
            of(euler([tensor, tensor], 1.0)),
            [finding(Where::Everywhere)]
        );
        assert_eq!(
            of(euler([tensor, inertia()], 1.0)),
            [finding(Where::Gyroscopic)]
        );
        assert_eq!(
            of(euler([inertia(), tensor], 1.0)),
            [finding(Where::Inverse)]
        );
    }
    let right = euler(whole, 1.0);
    assert_eq!(of(|w, m| right(w, &-m)), [Finding::TorqueNegated]);
    assert_eq!(
        of(|w, _| right(w, &Vector3::zeros())),
        [Finding::TorqueIgnored]
    );
    let both = euler([diagonal(), diagonal()], -1.0);
    assert_eq!(
        of(both),
        [
            Finding::Gyroscopic(Gyroscopic::Negated),
            Finding::DiagonalOnly(Where::Everywhere)
        ]
    );
    assert!(matches!(of(|w, m| right(w, m) * 1.1)[..], [Finding::Unknown(off)] if off > 0.05));
    assert!(matches!(of(|w, _| w * f64::NAN)[..], [Finding::Unknown(_)]));
}

#[test]
fn what_a_body_does_not_show_is_said() {
    let sphere = Matrix3::identity();
    let audit = audit::acceleration(|_, torque| *torque, &sphere).expect("a body");
    assert!(audit.is_clean());
    assert_eq!(audit.unseen(), [Unseen::Products, Unseen::Gyroscopic]);
    assert!(
        audit.to_string().contains("nothing is said about ω × Iω"),
        "{audit}"
    );
    let audit = audit::acceleration(euler([inertia(), inertia()], 1.0), &inertia());
    assert_eq!(audit.expect("a body").unseen(), []);
}

/// A Runge–Kutta step of any rates, the quaternion made unit.
fn runge_kutta(
    rates: impl Fn(&State<f64>, &Vector3<f64>) -> (Quaternion<f64>, Vector3<f64>),
) -> impl Fn(&State<f64>, &Vector3<f64>, f64) -> State<f64> {
    move |state, torque, dt| {
        let along = |(dq, dw): (Quaternion<f64>, Vector3<f64>), h: f64| State {
            attitude: state.attitude + dq * h,
            angular_velocity: state.angular_velocity + dw * h,
        };
        let first = rates(state, torque);
        let second = rates(&along(first, dt / 2.0), torque);
        let third = rates(&along(second, dt / 2.0), torque);
        let fourth = rates(&along(third, dt), torque);
        let sum = (
            first.0 + second.0 * 2.0 + third.0 * 2.0 + fourth.0,
            first.1 + second.1 * 2.0 + third.1 * 2.0 + fourth.1,
        );
        let end = along(sum, dt / 6.0);
        State {
            attitude: end.attitude.normalised(),
            ..end
        }
    }
}

fn right(state: &State<f64>, torque: &Vector3<f64>) -> (Quaternion<f64>, Vector3<f64>) {
    let omega = state.angular_velocity;
    let alpha = inverse(inertia()) * (torque - omega.cross(&(inertia() * omega)));
    (state.attitude.rate(&omega), alpha)
}

fn audited(f: impl Fn(&State<f64>, &Vector3<f64>, f64) -> State<f64>) -> Audit {
    audit::step(f, &inertia(), &start(), 0.01).expect("a body that turns")
}

/// The first finding: a slip in the equation comes before the drift that it causes.
fn first(f: impl Fn(&State<f64>, &Vector3<f64>, f64) -> State<f64>) -> Finding {
    let audit = audited(f);
    assert!(!audit.is_clean(), "{audit}");
    let slips = audit
        .findings()
        .iter()
        .filter(|f| !matches!(f, Finding::Drift(_)));
    assert_eq!(slips.count(), 1, "{audit}");
    audit.findings()[0]
}

#[test]
fn sound_steps_are_not_blamed() {
    fn step<S: Scheme<Torque>>(
        scheme: S,
    ) -> impl Fn(&State<f64>, &Vector3<f64>, f64) -> State<f64> {
        move |state, torque, dt| {
            let system = System::over(inertia(), Torque::None, *torque);
            scheme.step(&system, 0.0, state, dt)
        }
    }
    let orders = [
        (audited(step(Rk4)), 4.0),
        (audited(step(ImplicitMidpoint)), 2.0),
        (audited(step(Splitting::FOURTH)), 4.0),
        (audited(step(MoserVeselov::SECOND)), 2.0),
        (audited(runge_kutta(right)), 4.0),
    ];
    for (audit, order) in orders {
        assert!(audit.is_clean(), "{audit}");
        assert!(
            (audit.order().expect("an order") - order).abs() < 0.2,
            "{audit}"
        );
    }
    assert!(audited(step(Dop853)).is_clean());
}

/// The same in single precision.
#[test]
fn single_precision_is_enough() {
    let rounded = |v: f64| f64::from(v as f32);
    let step = |state: &State<f64>, torque: &Vector3<f64>, dt: f64| {
        let end = runge_kutta(right)(state, torque, dt);
        State {
            attitude: Quaternion::new(end.attitude.components().map(rounded)),
            angular_velocity: end.angular_velocity.map(rounded),
        }
    };
    let audit = audited(step);
    assert!(audit.is_clean(), "{audit}");
}

#[test]
fn slips_in_the_rate_of_the_angular_velocity() {
    let missing = |state: &State<f64>, torque: &Vector3<f64>| {
        (right(state, torque).0, inverse(inertia()) * torque)
    };
    let audit = audited(runge_kutta(missing));
    assert_eq!(
        audit.findings()[0],
        Finding::Gyroscopic(Gyroscopic::Missing)
    );
    // The witness: ω stays, so the energy does, while the momentum turns in space.
    let witnesses = audit.witnesses().expect("a run");
    assert!(
        witnesses.energy.abs() < 1e-6 && witnesses.turned > 0.1,
        "{audit}"
    );
    let space = |state: &State<f64>, torque: &Vector3<f64>| {
        let turn = state.attitude.normalised();
        let [w, m] = [state.angular_velocity, *torque].map(|v| turn.to_space(&v));
        let alpha = inverse(inertia()) * (m - w.cross(&(inertia() * w)));
        (right(state, torque).0, turn.to_body(&alpha))
    };
    assert_eq!(first(runge_kutta(space)), Finding::TensorInSpaceAxes);
    let torque_in_space = |state: &State<f64>, torque: &Vector3<f64>| {
        right(state, &state.attitude.normalised().to_body(torque))
    };
    assert_eq!(
        first(runge_kutta(torque_in_space)),
        Finding::TorqueInOtherAxes
    );
    let products = |state: &State<f64>, torque: &Vector3<f64>| {
        let omega = state.angular_velocity;
        (
            right(state, torque).0,
            euler([negated(), negated()], 1.0)(&omega, torque),
        )
    };
    assert_eq!(
        first(runge_kutta(products)),
        Finding::ProductsNegated(Where::Everywhere)
    );
}

#[test]
fn slips_in_the_rate_of_the_attitude() {
    let turning = |rate: fn(&Quaternion<f64>, &Vector3<f64>) -> Quaternion<f64>| {
        let rates = move |state: &State<f64>, torque: &Vector3<f64>| {
            let (_, alpha) = right(state, torque);
            (rate(&state.attitude, &state.angular_velocity), alpha)
        };
        first(runge_kutta(rates))
    };
    assert_eq!(
        turning(|q, w| Quaternion { w: 0.0, v: w * 0.5 } * *q),
        Finding::Attitude(Turning::InSpaceAxes)
    );
    assert_eq!(
        turning(|q, w| q.rate(w) * -1.0),
        Finding::Attitude(Turning::Backwards)
    );
    assert_eq!(
        turning(|q, w| q.rate(w) * 2.0),
        Finding::Attitude(Turning::Twice)
    );
    assert_eq!(
        turning(|q, w| q.rate(w) * 0.5),
        Finding::Attitude(Turning::Half)
    );
    assert_eq!(turning(|q, _| *q * 0.0), Finding::Attitude(Turning::Not));
    let other_order = |q: &Quaternion<f64>, w: &Vector3<f64>| {
        // Stored as w, x, y, z and read as x, y, z, w.
        let [x, y, z, s] = q.components();
        let [s, x, y, z] = Quaternion::new([s, x, y, z]).rate(w).components();
        Quaternion::new([x, y, z, s])
    };
    assert_eq!(
        turning(other_order),
        Finding::Attitude(Turning::InOtherOrder)
    );
}

#[test]
fn slips_in_what_comes_back() {
    let shuffled = |state: &State<f64>, torque: &Vector3<f64>, dt: f64| {
        let end = runge_kutta(right)(state, torque, dt);
        let [w, x, y, z] = end.attitude.components();
        State {
            attitude: Quaternion::new([x, y, z, w]),
            ..end
        }
    };
    assert_eq!(first(shuffled), Finding::QuaternionOrder);
    let in_space = |state: &State<f64>, torque: &Vector3<f64>, dt: f64| {
        let end = runge_kutta(right)(state, torque, dt);
        end.turning(end.attitude.to_space(&end.angular_velocity))
    };
    assert_eq!(first(in_space), Finding::VelocityInSpaceAxes);
    let longer = |state: &State<f64>, torque: &Vector3<f64>, dt: f64| {
        runge_kutta(right)(state, torque, dt + 0.05)
    };
    assert_eq!(audited(longer).findings()[0], Finding::NoLimit);
    let never_unit = |state: &State<f64>, torque: &Vector3<f64>, dt: f64| {
        let (dq, dw) = right(state, torque);
        State {
            attitude: state.attitude + dq * dt,
            angular_velocity: state.angular_velocity + dw * dt,
        }
    };
    let audit = audited(never_unit);
    assert!(
        audit
            .findings()
            .iter()
            .any(|f| matches!(f, Finding::NotUnit(_))),
        "{audit}"
    );
}

/// The explicit term, as it is often written, at a spin that it can't follow; and the same at a step that it can.
#[test]
fn an_explicit_gyroscopic_term_is_unstable_at_long_steps() {
    let explicit = |state: &State<f64>, torque: &Vector3<f64>, dt: f64| {
        let (_, alpha) = right(state, torque);
        let omega = state.angular_velocity + alpha * dt;
        State {
            attitude: state.attitude * Quaternion::exp(&(omega * dt)),
            angular_velocity: omega,
        }
    };
    let fast = start().turning(Vector3::new(3.0, 20.0, -2.0));
    let at = |dt| audit::step(explicit, &inertia(), &fast, dt).expect("a body that turns");
    let audit = at(1.0 / 60.0);
    assert!(
        matches!(audit.findings(), [Finding::Unstable(_)]),
        "{audit}"
    );
    assert!(
        (audit.order().expect("an order") - 1.0).abs() < 0.2,
        "{audit}"
    );
    let audit = at(1e-6);
    assert!(audit.is_clean(), "{audit}");
}

#[test]
fn what_cannot_be_audited_is_an_error() {
    let f = runge_kutta(right);
    let lopsided = Matrix3::new(1.0, 0.1, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
    assert!(matches!(
        audit::step(&f, &lopsided, &start(), 0.01),
        Err(MotionError::Inertia(_))
    ));
    assert!(matches!(
        audit::step(&f, &inertia(), &start(), -0.01),
        Err(MotionError::Step { .. })
    ));
    let still = State::at_rest();
    assert_eq!(
        audit::step(&f, &inertia(), &still, 0.01),
        Err(MotionError::AtRest)
    );
    let lost = start().turning(Vector3::new(f64::NAN, 0.0, 0.0));
    assert!(matches!(
        audit::step(&f, &inertia(), &lost, 0.01),
        Err(MotionError::NotFinite { .. })
    ));
}
