//! A time step under audit.

use super::acceleration::unseen;
use super::finding::{Audit, Finding, Turning};
use super::limit::{Limit, limit};
use super::model::{Instant, identify, instants};
use super::run::{free_run, order};
use crate::mechanics::possible_body;
use crate::motion::{MotionError, Quaternion, State};
use nalgebra::{Matrix3, SVector, Vector3};

/// A step as it is called here: state, torque in body axes, length.
pub(super) type Step<'a> = dyn FnMut(&State<f64>, &Vector3<f64>, f64) -> State<f64> + 'a;

/// Audits `f(state, torque, dt)`, which gives the state of a body with this inertia tensor a time `dt` later.
///
/// State and torque in body axes, the quaternion scalar first and from body to space; to audit code of other conventions,
/// translate in `f`. `start` is a state that the code is meant for: its speed is that of all runs. `dt` is the step that the
/// code is meant for; shorter ones, down to a thousandth, are taken to find the equation behind it. Single precision is
/// enough.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use polhode::audit::{self, Finding};
/// use polhode::motion::{Quaternion, State};
///
/// let inertia = Matrix3::new(0.6, 0.02, -0.03, 0.02, 0.8, 0.05, -0.03, 0.05, 1.0);
/// let inverse = inertia.try_inverse().expect("a body");
/// // As games step: ω by the explicit equation, then the attitude by the new ω.
/// let explicit = |state: &State<f64>, torque: &Vector3<f64>, dt: f64| {
///     let omega = state.angular_velocity;
///     let omega = omega + inverse * (torque - omega.cross(&(inertia * omega))) * dt;
///     State { attitude: state.attitude * Quaternion::exp(&(omega * dt)), angular_velocity: omega }
/// };
/// let start = State::at_rest().turning(Vector3::new(3.0, 20.0, -2.0));
/// let audit = audit::step(explicit, &inertia, &start, 1.0 / 60.0)?;
/// assert!(matches!(audit.findings(), [Finding::Unstable(_)]), "{audit}");
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
///
/// # Errors
/// A tensor that no body has; a step that is not positive and finite; a start at rest or not finite, which shows nothing.
pub fn step(
    mut f: impl FnMut(&State<f64>, &Vector3<f64>, f64) -> State<f64>,
    inertia: &Matrix3<f64>,
    start: &State<f64>,
    dt: f64,
) -> Result<Audit, MotionError> {
    possible_body(inertia).map_err(MotionError::Inertia)?;
    if !(dt > 0.0 && dt.is_finite()) {
        return Err(MotionError::Step { step: dt });
    }
    let speed = start.angular_velocity.norm();
    if !start.is_finite() {
        return Err(MotionError::NotFinite {
            what: "the sum of the start's components",
            value: speed,
        });
    }
    if speed == 0.0 {
        return Err(MotionError::AtRest);
    }
    let mut audit = Audit {
        findings: vec![],
        witnesses: None,
        order: None,
        unseen: unseen(inertia),
    };
    let instants = instants(inertia, speed);
    let Some(form) = form(&mut f, &instants, dt, &mut audit.findings) else {
        audit.findings.push(Finding::NoLimit);
        return Ok(audit);
    };
    let mut f =
        |state: &State<f64>, torque: &Vector3<f64>, dt: f64| form.read(&f(state, torque, dt));
    rates(&mut f, inertia, &instants, dt, &mut audit.findings);
    if audit.findings.is_empty() {
        audit.order = order(&mut f, inertia, start, dt);
    }
    free_run(&mut f, inertia, start, dt, &mut audit);
    Ok(audit)
}

/// In which form a state comes back.
#[derive(Clone, Copy, Debug, Default)]
struct Form {
    vector_first: bool,
    in_space: bool,
}

impl Form {
    fn read(&self, state: &State<f64>) -> State<f64> {
        let mut read = *state;
        if self.vector_first {
            let [x, y, z, w] = state.attitude.components();
            read.attitude = Quaternion::new([w, x, y, z]);
        }
        if self.in_space {
            read.angular_velocity = read.attitude.normalised().to_body(&state.angular_velocity);
        }
        read
    }
}

/// The form of what comes back from a step of no length, if it is one that is known.
fn form(
    f: &mut Step<'_>,
    instants: &[Instant],
    dt: f64,
    findings: &mut Vec<Finding>,
) -> Option<Form> {
    let ends: Vec<_> = instants
        .iter()
        .map(|at| {
            let state = state(at);
            let limit = limit(dt, |h| {
                let end = f(&state, &at.torque, h);
                let ([w, x, y, z], omega) = (end.attitude.components(), end.angular_velocity);
                SVector::from([w, x, y, z, omega.x, omega.y, omega.z])
            });
            (state, limit)
        })
        .collect();
    let forms = [false, true].map(|vector_first| {
        [false, true].map(|in_space| Form {
            vector_first,
            in_space,
        })
    });
    let fits = |form: &Form| {
        ends.iter().all(|(state, end)| {
            let [w, x, y, z, a, b, c] = end.value.into();
            let end_state = form.read(&State {
                attitude: Quaternion::new([w, x, y, z]),
                angular_velocity: Vector3::new(a, b, c),
            });
            let apart = |sign: f64| {
                let components = end_state.attitude.components().into_iter();
                let pairs = components.zip(state.attitude.components());
                pairs.map(|(a, b)| (a - sign * b).abs()).fold(0.0, f64::max)
            };
            let turned = apart(1.0).min(apart(-1.0));
            let omega = (end_state.angular_velocity - state.angular_velocity).norm();
            let allowed = 1e-4 + 4.0 * end.error;
            turned <= allowed && omega <= allowed * state.angular_velocity.norm().max(1.0)
        })
    };
    let form = forms.into_iter().flatten().find(fits)?;
    if form.vector_first {
        findings.push(Finding::QuaternionOrder);
    }
    if form.in_space {
        findings.push(Finding::VelocityInSpaceAxes);
    }
    Some(form)
}

fn state(at: &Instant) -> State<f64> {
    State {
        attitude: Quaternion::of_matrix(&at.attitude),
        angular_velocity: at.omega,
    }
}

/// Which equation the rates of the state obey as the step goes to zero.
fn rates(
    f: &mut Step<'_>,
    inertia: &Matrix3<f64>,
    instants: &[Instant],
    dt: f64,
    findings: &mut Vec<Finding>,
) {
    let found: Vec<(Instant, Limit<6>)> = instants
        .iter()
        .map(|at| {
            let before = state(at);
            let limit = limit(dt, |h| before.difference(&f(&before, &at.torque, h)) / h);
            (*at, limit)
        })
        .collect();
    let part = |(at, limit): &(Instant, Limit<6>)| limit.error / at.omega.norm_squared();
    let error = found.iter().map(part).fold(0.0, f64::max);
    let seen: Vec<_> = found
        .iter()
        .map(|(at, limit)| (*at, limit.value.fixed_rows::<3>(3).into_owned()))
        .collect();
    let turns: Vec<_> = found
        .iter()
        .map(|(at, limit)| (*at, limit.value.fixed_rows::<3>(0).into_owned()))
        .collect();
    if error.is_nan() || error >= 0.05 {
        findings.push(Finding::NoLimit);
        return;
    }
    let tolerance = 1e-6_f64.max(4.0 * error);
    match identify(inertia, &seen, tolerance, true) {
        Ok(model) => findings.extend(model.slips),
        Err(off) => findings.push(Finding::Unknown(off)),
    }
    let pace = instants
        .iter()
        .map(|at| at.omega.norm())
        .fold(1.0, f64::max);
    findings.extend(turning(&turns, 1e-5_f64.max(tolerance * pace)));
}

/// How the attitude turns, if not as it should; the rate of the turn θ of the body side is then not ω.
fn turning(seen: &[(Instant, Vector3<f64>)], tolerance: f64) -> Option<Finding> {
    let other_order = |at: &Instant| {
        let [w, x, y, z] = state(at).attitude.components();
        let [rz, rw, rx, ry] = Quaternion::new([z, w, x, y]).rate(&at.omega).components();
        let back = Quaternion::new([w, x, y, z]).conjugate();
        (back * Quaternion::new([rw, rx, ry, rz])).v * 2.0
    };
    type Way<'a> = (Option<Turning>, &'a dyn Fn(&Instant) -> Vector3<f64>);
    let ways: [Way<'_>; 7] = [
        (None, &|at| at.omega),
        (Some(Turning::Not), &|_| Vector3::zeros()),
        (Some(Turning::InSpaceAxes), &|at| {
            at.attitude.tr_mul(&at.omega)
        }),
        (Some(Turning::Backwards), &|at| -at.omega),
        (Some(Turning::Twice), &|at| at.omega * 2.0),
        (Some(Turning::Half), &|at| at.omega * 0.5),
        (Some(Turning::InOtherOrder), &other_order),
    ];
    let fits = |(_, way): &&Way<'_>| {
        seen.iter()
            .all(|(at, rate)| (way(at) - rate).norm() <= tolerance * at.omega.norm())
    };
    match ways.iter().find(fits) {
        Some((turning, _)) => turning.map(Finding::Attitude),
        None => {
            let off = seen
                .iter()
                .map(|(at, rate)| (rate - at.omega).norm() / at.omega.norm());
            Some(Finding::UnknownTurning(off.fold(0.0, f64::max)))
        }
    }
}
