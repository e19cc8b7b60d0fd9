//! A cost and its gradient, as one problem for any solver.

use super::evaluated::{Evaluated, Valued};
use nalgebra::DVector;

/// A cost and its gradient.
pub(super) type Cost = (f64, DVector<f64>);

impl Valued for Cost {
    fn cost(&self) -> f64 {
        self.0
    }

    fn gradient(&self) -> DVector<f64> {
        self.1.clone()
    }
}

/// A cost of which only the gradient is known: that of a whole rollout in all torques, say, where a Jacobian would be large.
///
/// Cost and gradient are computed together, once at each point, by a function that returns `None` where there is no value.
/// The feature `argmin` makes this a `CostFunction` with `Gradient`; where there is no value, a line search turns back.
///
/// ```
/// use nalgebra::{DVector, Matrix3, Vector3, Vector6};
/// use polhode::motion::{Rk4, Rollout, State, System, Torque};
/// use polhode::optimise::Objective;
/// let system = System::new(Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0)), Torque::None)?;
/// let spinning = State::at_rest().turning(Vector3::new(1.0, 0.5, -0.9));
/// // ½ |ω|² at the end, of the torques in ten steps of 0.1 s.
/// let stop = Objective::new(DVector::zeros(30), |x| {
///     let torques: Vec<_> = x.as_slice().chunks(3).map(Vector3::from_column_slice).collect();
///     let rollout = Rollout::new(Rk4, system, spinning, 0.1, &torques).ok()?;
///     let omega = rollout.states()[10].angular_velocity;
///     let mut costs = [Vector6::zeros(); 11];
///     costs[10].fixed_rows_mut::<3>(3).copy_from(&omega);
///     let by_torques = rollout.gradient(&costs).torques;
///     let gradient = DVector::from_iterator(30, by_torques.iter().flatten().copied());
///     Some((omega.norm_squared() / 2.0, gradient))
/// });
/// for _ in 0..40 {
///     let downhill = stop.gradient().ok_or("no motion")? * -4.0;
///     stop.go_to(stop.parameters() + downhill);
/// }
/// assert!(stop.value().ok_or("no motion")? < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Objective<F>(Evaluated<F, Cost>);

impl<F: Fn(&DVector<f64>) -> Option<Cost>> Objective<F> {
    /// The problem of a function that returns cost and gradient, at a start.
    pub fn new(start: DVector<f64>, cost: F) -> Self {
        Self(Evaluated::new(start, cost))
    }

    /// Goes to other parameters.
    pub fn go_to(&self, parameters: DVector<f64>) {
        self.0.go_to(parameters);
    }
}

impl<F> Objective<F> {
    /// Where it is: at the start, or at the parameters that were asked for last.
    pub fn parameters(&self) -> DVector<f64> {
        self.0.parameters()
    }

    /// The cost there.
    pub fn value(&self) -> Option<f64> {
        self.0.found(|(cost, _)| *cost)
    }

    /// The gradient there.
    pub fn gradient(&self) -> Option<DVector<f64>> {
        self.0.found(Valued::gradient)
    }

    /// Cost and gradient, or the wall where there is no value.
    #[cfg(feature = "argmin")]
    pub(super) fn with_wall(&self) -> Option<Cost> {
        self.0.with_wall()
    }
}
