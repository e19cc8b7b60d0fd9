//! How far rounding the input of a free motion moves its end.

use crate::motion::{FreeBody, State};
use crate::scene::Member;
use crate::scene::accuracy::{LOST, ROUNDING, distance, size};
use nalgebra::Vector3;

/// The error to expect of the closed form of a free motion at its end `here`: by a bound where that is enough for the tolerance,
/// else by trial.
pub(crate) fn free_error(member: &Member, here: &State<f64>, duration: f64, tolerance: f64) -> f64 {
    match bound(member, duration) {
        Some(bound) if bound <= tolerance => bound,
        _ => by_trial(member, here, duration),
    }
}

/// A bound of the error, from the phase u = λt + u₀ of the elliptic functions and the turn about L.
///
/// To move ω by ε |ω| moves ln k'² by s ε with s = 2 |ω| Σ Iᵢ dᵢ |ωᵢ| / |D₂|, the quarter period K(k') by half of that
/// (it is ln 4/k' near the separatrix, and flatter away from it), and phase and turn by as much in each of the periods.
/// `None` where ω stays on an axis, which may be the unstable one.
fn bound(member: &Member, duration: f64) -> Option<f64> {
    let speed = size(&member.start.angular_velocity);
    let moments = member.body.moments() / member.body.moments().z;
    let omega = member.body.axes().tr_mul(&member.start.angular_velocity) / speed;
    let (d21, d32, d31) = (
        moments.y - moments.x,
        moments.z - moments.y,
        moments.z - moments.x,
    );
    let [t1, t2, t3] = [0, 1, 2].map(|i| moments[i] * omega[i] * omega[i]);
    let of_sn = (t3 * d32 - t1 * d21).abs();
    let (outer, of_cn) = if t3 * d32 >= t1 * d21 {
        (d32, t2 * d21 + t3 * d31)
    } else {
        (d21, t1 * d31 + t2 * d32)
    };
    let complementary = (of_sn * d31 / (of_cn * outer)).sqrt();
    let quarter = (4.0 / complementary).ln();
    let moved = moments.z * d32 * omega.z.abs() + moments.x * d21 * omega.x.abs();
    // Moments are rounded too.
    let slope = 2.0 * (moved + t1 + t3) / of_sn;
    let angle = speed * duration;
    let bound = ROUNDING * (1.0 + slope + angle * (1.0 + 0.5 * slope / quarter));
    (bound.is_finite() && complementary > 0.0).then_some(bound)
}

/// By moving the initial ω a little each way: the state after it moves by the conditioning of the problem.
fn by_trial(member: &Member, here: &State<f64>, duration: f64) -> f64 {
    let omega = member.start.angular_velocity;
    let speed = size(&omega);
    if speed == 0.0 {
        return ROUNDING;
    }
    let end = |omega: Vector3<f64>| {
        let start = member.start.turning(omega);
        FreeBody::new(&member.body, &start).at(duration)
    };
    let mut largest = 0.0_f64;
    for shift in [1e-9, 1e-13] {
        largest = 0.0;
        for k in 0..3 {
            let mut moved = omega;
            moved[k] += shift * speed;
            let off = end(moved).map_or(f64::INFINITY, |there| distance(here, &there, speed));
            largest = largest.max(off / shift);
        }
        if largest * shift < LOST {
            break;
        }
    }
    ROUNDING * largest.max(1.0 + speed * duration)
}
