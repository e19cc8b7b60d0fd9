//! The true motion, to more digits than a double has.

use crate::bench::Double;
use crate::motion::{MotionError, Number, Quaternion, Scheme, State, System, Taylor};
use crate::scene::Member;
use nalgebra::Vector3;

/// Order of the series and the angle turned in a step: the truncation is some 1e-20.
const ORDER: usize = 28;
const ANGLE: f64 = 0.2;
/// The most steps: about ten minutes.
const MOST_STEPS: f64 = 1e7;

/// The states of a member at ascending `times`, by short Taylor steps in double-double arithmetic, rounded at the end.
///
/// # Errors
/// A motion that takes more than ten million steps, or stops being finite.
pub fn reference(member: &Member, times: &[f64]) -> Result<Vec<State<f64>>, MotionError> {
    let lift = |v: &Vector3<f64>| v.map(Double::of);
    let inertia = member.body.inertia().map(Double::of);
    let system = System::over(
        inertia,
        member.torque,
        Vector3::from_element(Double::of(0.0)),
    );
    let start = &member.start;
    let attitude = Quaternion::new(start.attitude.components().map(Double::of));
    let mut state = State {
        attitude: attitude.normalised(),
        angular_velocity: lift(&start.angular_velocity),
    };
    let scheme = Taylor::of_order(ORDER);
    let (mut time, mut steps) = (0.0, 0.0);
    let mut found = Vec::with_capacity(times.len());
    for &until in times {
        while time < until {
            let step = step(member, &state).min(until - time);
            let next = time + step;
            state = scheme.step(
                &system,
                Double::of(time),
                &state,
                Double::of(next) - Double::of(time),
            );
            time = next;
            steps += 1.0;
            if steps > MOST_STEPS {
                let most = MOST_STEPS as u64;
                return Err(MotionError::TooManySteps {
                    needed: f64::INFINITY,
                    most,
                });
            }
            if !state.angular_velocity.iter().all(|c| c.value().is_finite()) {
                return Err(MotionError::Diverged { time });
            }
        }
        found.push(rounded(&state));
    }
    Ok(found)
}

/// A span in which the body turns by a small angle, and its speed changes little.
fn step(member: &Member, state: &State<Double>) -> f64 {
    let omega = state.angular_velocity.map(Double::value);
    let system = System::over(*member.body.inertia(), member.torque, Vector3::zeros());
    let alpha = system
        .rates(0.0, &rounded(state))
        .angular_acceleration
        .norm();
    let speed = omega.norm();
    let rate = speed
        .max(alpha.sqrt())
        .max(if speed > 0.0 { alpha / speed } else { 0.0 });
    let frequency = match member.torque {
        crate::motion::Torque::Sinusoid {
            angular_frequency, ..
        } => angular_frequency.abs(),
        _ => 0.0,
    };
    ANGLE / rate.max(frequency).max(1e-300)
}

fn rounded(state: &State<Double>) -> State<f64> {
    State {
        attitude: Quaternion::new(state.attitude.components().map(Double::value)),
        angular_velocity: state.angular_velocity.map(Double::value),
    }
}
