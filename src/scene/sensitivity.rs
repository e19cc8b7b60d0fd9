//! The derivative of a final state in the initial state and the parameters.

use crate::mechanics::Products;
use crate::motion::{MotionError, Scheme, State, System, Taylor, Torque, TorqueLaw};
use crate::scene::{Member, Wrt, distance};
use nalgebra::{Matrix3, SMatrix, Vector3};

/// The blocks of the Jacobian that were asked for; rows (θ, ω), θ' = Log(q⁻¹ q_perturbed).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sensitivity {
    /// In the initial attitude, θ of q exp(θ/2).
    pub attitude: Option<SMatrix<f64, 6, 3>>,
    /// In the initial ω.
    pub angular_velocity: Option<SMatrix<f64, 6, 3>>,
    /// In a constant torque added in the axes that the law names.
    pub torque: Option<SMatrix<f64, 6, 3>>,
    /// In xx, yy, zz, xy, xz, yz of the scene's own sign convention, ω at the start held.
    pub inertia: Option<SMatrix<f64, 6, 6>>,
    /// In the duration.
    pub dt: Option<SMatrix<f64, 6, 1>>,
}

/// Order of the series that carries the derivatives.
const ORDER: usize = 20;
/// Steps for a turn of one radian, to begin with.
const STEPS: f64 = 1.0;
/// The most times that the steps are halved.
const HALVINGS: u32 = 24;
/// The most steps of all.
const MOST_STEPS: f64 = 1e9;

/// The blocks that `wrt` names, at the `last` state of the motion of `member` after `duration`.
///
/// The derivatives are those of a run by Taylor series of order 20, whose steps are halved until it ends within
/// `tolerance` of `last`: right derivatives of a right motion. What is known by symmetry is written down: turned as a
/// whole, a motion under a torque that does not look at the attitude is turned as a whole.
///
/// # Errors
/// A motion that stops being finite, or that no number of steps brings to `last`.
pub fn sensitivity(
    member: &Member,
    wrt: &Wrt,
    products: Products,
    duration: f64,
    last: &State<f64>,
    tolerance: f64,
) -> Result<Sensitivity, MotionError> {
    let system = System::new(*member.body.inertia(), member.torque)?;
    let blind = looks_away(member);
    let mut found = Sensitivity::default();
    if wrt.inertia {
        let matrix = carried::<15>(member, &system, duration, last, tolerance)?;
        found.take(&matrix, wrt);
        let mut inertia = matrix.fixed_columns::<6>(9).into_owned();
        if products == Products::Integrals {
            inertia.fixed_columns_mut::<3>(3).neg_mut();
        }
        found.inertia = Some(inertia);
    } else if wrt.torque {
        let matrix = carried::<9>(member, &system, duration, last, tolerance)?;
        found.take(&matrix, wrt);
    } else if wrt.angular_velocity || (wrt.attitude && !blind) {
        let matrix = carried::<6>(member, &system, duration, last, tolerance)?;
        found.take(&matrix, wrt);
    }
    if wrt.attitude && blind {
        let turn = (last.attitude.conjugate() * member.start.attitude).matrix();
        let mut block = SMatrix::<f64, 6, 3>::zeros();
        block.fixed_view_mut::<3, 3>(0, 0).copy_from(&turn);
        found.attitude = Some(block);
    }
    if wrt.dt {
        let rates = system.rates(duration, last);
        let (omega, alpha) = (last.angular_velocity, rates.angular_acceleration);
        found.dt = Some(SMatrix::from_iterator(
            omega.iter().chain(alpha.iter()).copied(),
        ));
    }
    Ok(found)
}

impl Sensitivity {
    fn take<const N: usize>(&mut self, matrix: &SMatrix<f64, 6, N>, wrt: &Wrt) {
        let block = |first: usize| SMatrix::from_fn(|r, c| matrix[(r, first + c)]);
        self.attitude = wrt.attitude.then(|| block(0));
        self.angular_velocity = wrt.angular_velocity.then(|| block(3));
        self.torque = (wrt.torque && N >= 9).then(|| block(6));
    }
}

/// Whether the torque does not depend on the attitude.
pub(crate) fn looks_away(member: &Member) -> bool {
    let law: &dyn TorqueLaw<f64> = &member.torque;
    law.without_attitude(0.0, &Vector3::zeros()).is_some()
}

/// The derivative of the end in (θ, ω, torque, inertia), the first `N` columns.
fn carried<const N: usize>(
    member: &Member,
    system: &System<f64, Torque>,
    duration: f64,
    last: &State<f64>,
    tolerance: f64,
) -> Result<SMatrix<f64, 6, N>, MotionError>
where
    num_dual::DualSVec64<N>: crate::motion::Number,
{
    let speed = member.start.angular_velocity.norm();
    let speed = speed.max(last.angular_velocity.norm());
    let mut count = (STEPS * speed * duration).ceil().max(1.0);
    let mut best: Option<(f64, SMatrix<f64, 6, N>)> = None;
    for _ in 0..HALVINGS {
        if count > MOST_STEPS {
            break;
        }
        let (state, matrix) = chain(member, system, duration, count as u64);
        let off = distance(last, &state, speed);
        let worse = best.as_ref().is_some_and(|(least, _)| off >= 0.5 * least);
        if best.as_ref().is_none_or(|(least, _)| off < *least) && off.is_finite() {
            best = Some((off, matrix));
        }
        // What halving does not mend is rounding.
        if off <= tolerance || (worse && off < 1e-3) {
            break;
        }
        count *= 2.0;
    }
    match best {
        Some((off, matrix)) if off < 1e-3 => Ok(matrix),
        _ => Err(MotionError::Diverged { time: 0.0 }),
    }
}

fn chain<const N: usize>(
    member: &Member,
    system: &System<f64, Torque>,
    duration: f64,
    count: u64,
) -> (State<f64>, SMatrix<f64, 6, N>)
where
    num_dual::DualSVec64<N>: crate::motion::Number,
{
    let scheme = Taylor::of_order(ORDER);
    let mut state = member.start;
    let mut total = SMatrix::<f64, 6, N>::zeros();
    total
        .fixed_view_mut::<3, 3>(0, 0)
        .copy_from(&Matrix3::identity());
    total
        .fixed_view_mut::<3, 3>(3, 3)
        .copy_from(&Matrix3::identity());
    let at = |n: u64| duration * (n as f64 / count as f64);
    for n in 0..count {
        let step = scheme.step_with_jacobian::<N>(system, at(n), &state, at(n + 1) - at(n));
        let by_state = step.matrix.fixed_columns::<6>(0).into_owned();
        let mut next = by_state * total;
        for column in 6..N {
            let own = step.matrix.column(column);
            let mut sum = next.column_mut(column);
            sum += own;
        }
        (state, total) = (step.state, next);
        if !state.is_finite() {
            break;
        }
    }
    (state, total)
}
