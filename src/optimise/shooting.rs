//! Multiple shooting: states at nodes that are steps apart, and how far the steps miss them.

use super::sparse::Blocks;
use crate::motion::{Scheme, SmoothLaw, State, System};
use nalgebra::{DVector, Vector3, Vector6};

/// States at nodes, and a torque for the step from each node to the next one: the unknowns of multiple shooting.
///
/// A tangent of it is (θ, ω) of node 0, the torque of step 0, (θ, ω) of node 1 and so on: 9 numbers a step, and 6 for the last
/// node, so that the Jacobian of [`defects`](Self::defects) is banded.
///
/// ```
/// use nalgebra::{DMatrix, Matrix3, Vector3};
/// use polhode::motion::{Rk4, State, System, Torque};
/// use polhode::optimise::Nodes;
/// let system = System::new(Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0)), Torque::None)?;
/// let spinning = State::at_rest().turning(Vector3::new(1.0, 0.5, -0.9));
/// let mut nodes = Nodes { states: vec![spinning; 4], torques: vec![Vector3::zeros(); 3] };
/// // Newton's steps to a motion: with the least change, as there is more than one.
/// for _ in 0..5 {
///     let (missed, by_nodes) = nodes.defects(&Rk4, &system, 0.1);
///     let matrix = DMatrix::from(&by_nodes.csc(missed.len(), nodes.dimension()));
///     let change = matrix.pseudo_inverse(1e-12)? * -missed;
///     nodes = nodes.perturbed(&change);
/// }
/// assert!(nodes.defects(&Rk4, &system, 0.1).0.norm() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Nodes {
    /// The states: one more than there are steps.
    pub states: Vec<State<f64>>,
    /// The torque that is added in each step, in the axes that the law names.
    pub torques: Vec<Vector3<f64>>,
}

/// Numbers of a tangent from one node to the next.
const EACH: usize = 9;

impl Nodes {
    /// How many numbers a tangent has.
    pub fn dimension(&self) -> usize {
        EACH * self.torques.len() + 6
    }

    /// The defects, six a step: the tangent from the node after a step to where the step ends; and their Jacobian in the tangent
    /// of all nodes, two blocks a row: 6 × 9 in the node and the torque before, 6 × 6 in the node after.
    pub fn defects<S, L>(
        &self,
        scheme: &S,
        system: &System<f64, L>,
        step: f64,
    ) -> (DVector<f64>, Blocks)
    where
        S: Scheme<L>,
        L: SmoothLaw,
    {
        let mut values = DVector::zeros(6 * self.torques.len());
        let mut jacobian = Blocks::default();
        let pairs = self.states.windows(2).zip(&self.torques).enumerate();
        for (k, (pair, torque)) in pairs {
            let system = system.with_torque(*torque);
            let time = k as f64 * step;
            let end = scheme.step_with_jacobian::<EACH>(&system, time, &pair[0], step);
            let (missed, [by_node, by_end]) = pair[1].difference_with_jacobians(&end.state);
            values.fixed_rows_mut::<6>(6 * k).copy_from(&missed);
            jacobian.add(6 * k, EACH * k, &(by_end * end.matrix));
            jacobian.add(6 * k, EACH * (k + 1), &by_node);
        }
        (values, jacobian)
    }

    /// The nodes moved by a tangent of [`dimension`](Self::dimension) numbers; what it lacks is zero.
    #[must_use]
    pub fn perturbed(&self, tangent: &DVector<f64>) -> Self {
        let part = |first: usize, i: usize| tangent.get(first + i).copied().unwrap_or(0.0);
        let states = self.states.iter().enumerate();
        let torques = self.torques.iter().enumerate();
        Self {
            states: states
                .map(|(k, state)| state.perturbed(&Vector6::from_fn(|i, _| part(EACH * k, i))))
                .collect(),
            torques: torques
                .map(|(k, torque)| torque + Vector3::from_fn(|i, _| part(EACH * k + 6, i)))
                .collect(),
        }
    }
}
