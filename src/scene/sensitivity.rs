//! The derivative of a final state in the initial state and the parameters.

use crate::mechanics::Products;
use crate::motion::jacobian::flow;
use crate::motion::{MotionError, State, System, TorqueLaw};
use crate::scene::{Member, Wrt};
use nalgebra::SMatrix;

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

/// The blocks that `wrt` names, at the `last` state of the motion of `member` after `duration`.
///
/// The derivatives are carried along the motion by the equation of variation, the error of each step of DOP853 below
/// `bound`: right derivatives of a right motion. What is known by symmetry is written down: turned as a whole, a motion under a
/// torque that does not look at the attitude is turned as a whole.
///
/// # Errors
/// A motion that stops being finite, or takes too many steps.
pub fn sensitivity(
    member: &Member,
    wrt: &Wrt,
    products: Products,
    duration: f64,
    last: &State<f64>,
    bound: f64,
) -> Result<Sensitivity, MotionError> {
    let blind = looks_away(member);
    let mut found = Sensitivity::default();
    if wrt.inertia {
        let matrix = carried::<15>(member, duration, bound)?;
        found.take(&matrix, wrt);
        let mut inertia = matrix.fixed_columns::<6>(9).into_owned();
        if products == Products::Integrals {
            inertia.fixed_columns_mut::<3>(3).neg_mut();
        }
        found.inertia = Some(inertia);
    } else if wrt.torque {
        found.take(&carried::<9>(member, duration, bound)?, wrt);
    } else if wrt.angular_velocity || (wrt.attitude && !blind) {
        found.take(&carried::<6>(member, duration, bound)?, wrt);
    }
    if wrt.attitude && blind {
        let turn = (last.attitude.conjugate() * member.start.attitude).matrix();
        let mut block = SMatrix::<f64, 6, 3>::zeros();
        block.fixed_view_mut::<3, 3>(0, 0).copy_from(&turn);
        found.attitude = Some(block);
    }
    if wrt.dt {
        let system = System::new(*member.body.inertia(), member.torque)?;
        let rates = system.rates(duration, last);
        let (omega, alpha) = (last.angular_velocity, rates.angular_acceleration);
        let column = omega.iter().chain(alpha.iter()).copied();
        found.dt = Some(SMatrix::from_iterator(column));
    }
    Ok(found)
}

/// The derivative of the end in (θ, ω, torque, inertia), the first `N` columns.
fn carried<const N: usize>(
    member: &Member,
    duration: f64,
    bound: f64,
) -> Result<SMatrix<f64, 6, N>, MotionError> {
    let Member {
        body,
        start,
        torque,
    } = member;
    Ok(flow::by_variation::<N>(body, *torque, start, bound, duration)?.matrix)
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
    TorqueLaw::<f64>::linear(&member.torque, 0.0).is_some_and(|torque| torque.looks_away())
}
