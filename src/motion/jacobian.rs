//! The Jacobian of a step.
//!
//! Rows (θ', ω'), columns (θ, ω, torque, inertia, dt) in this order, as many as are asked for: `N` is 6 for the
//! state alone, 9 with the torque, 15 with the inertia, 16 with the length of the step. What is not asked
//! for is not computed.
//!
//! θ is a rotation of the body side, q exp(θ/2), before and after. The torque is a constant one added to
//! the law, in the axes that the law names. The inertia is the tensor's own entries xx, yy, zz, xy, xz, yz (an
//! off-diagonal entry and its mirror image move together), at constant ω.
//!
//! # What it costs
//!
//! A step of [`Rk4`](crate::motion::Rk4) with 15 columns takes three and a half plain steps of a free body, 172 ns on one core of an
//! AMD EPYC, and the product with one vector two. Under gravity, a torque in space or damping all of these take 1.1 to 1.5 times
//! that, under a sinusoid in space 1.4 to 1.6 times. Of a law of one's own only the torque is run on dual numbers, at each of the
//! four stages: 1.6 to 2.5 times, if its function is `#[cfg_attr(not(debug_assertions), inline(always))]`. `cargo bench --bench laws` has all laws beside num-dual,
//! differences, CasADi and SymForce.
//!
//! The feature `batch` finds out what registers the machine has. Without it the code is made for the machine that the crate is
//! built for: on any x86-64 the step with 15 columns then takes 290 ns instead of 172, and the products 130 and 110 ns instead of
//! 88 and 98. The plain step takes the same.
//!
//! # Second derivatives
//!
//! Every step is generic over its [`Number`], so a scalar of the result that one chooses has its second derivatives by
//! hyper-dual numbers of the crate `num_dual`, to rounding: seed two inputs, read gradient and mixed derivative.
//!
//! ```
//! use nalgebra::{Matrix3, Vector3};
//! use num_dual::HyperDual64;
//! use polhode::motion::{Number, Rk4, Scheme, State, System, Torque};
//!
//! /// (ω_z − 0.2)² after a step of 0.1 s from ω = (a, b, 0.3).
//! fn cost<T: Number>(a: T, b: T) -> T {
//!     let tensor = Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0)).map(T::of);
//!     let system = System::over(tensor, Torque::None, Vector3::from_element(T::of(0.0)));
//!     let start = State::at_rest().turning(Vector3::new(a, b, T::of(0.3)));
//!     let end = Rk4.step(&system, T::of(0.0), &start, T::of(0.1));
//!     let missed = end.angular_velocity.z - T::of(0.2);
//!     missed * missed
//! }
//!
//! let at = |a, b| cost(HyperDual64::new(a, 1.0, 0.0, 0.0), HyperDual64::new(b, 0.0, 1.0, 0.0));
//! let (gradient, mixed) = ([at(3.0, 0.5).eps1, at(3.0, 0.5).eps2], at(3.0, 0.5).eps1eps2);
//! // The mixed derivative is what the gradient does, here by a central difference.
//! let difference = (at(3.001, 0.5).eps2 - at(2.999, 0.5).eps2) / 0.002;
//! assert!((difference - mixed).abs() < 1e-8 && mixed.abs() > 1e-4);
//! assert!((gradient[0] - (cost(3.001, 0.5) - cost(2.999, 0.5)) / 0.002).abs() < 1e-8);
//! ```

pub(super) mod chain;
pub mod flow;
pub(crate) mod runge_kutta;
mod variation;

use crate::motion::torque::SIDE;
use crate::motion::{Number, Quaternion, Scheme, SmoothLaw, State, System, TorqueLaw};
use crate::scalar::Jet;
use nalgebra::{Matrix3, Matrix6, SMatrix, SVector, Vector3, Vector6};

/// The state after a step and its Jacobian of 6 rows and `N` columns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepJacobian<const N: usize> {
    /// The state after the step.
    pub state: State<f64>,
    /// ∂(θ', ω')/∂(θ, ω, torque, inertia, dt), the first `N` columns.
    pub matrix: SMatrix<f64, 6, N>,
}

/// One step of `scheme` and its Jacobian, by running the step on dual numbers.
///
/// The reference that faster paths are held against: it is right to rounding for every generic scheme and law.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use polhode::motion::{Rk4, State, System, Torque, jacobian};
///
/// let system = System::new(Matrix3::from_diagonal(&Vector3::new(2.0, 3.0, 4.0)), Torque::None)?;
/// let start = State::at_rest().turning(Vector3::new(0.0, 3.0, 1e-3));
/// let step = jacobian::by_dual_numbers::<16, _, _>(&Rk4, &system, 0.0, &start, 0.01);
/// // A free body does not know its attitude.
/// assert!(step.matrix.fixed_view::<3, 3>(3, 0).norm() == 0.0);
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
pub fn by_dual_numbers<const N: usize, S, L>(
    scheme: &S,
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
) -> StepJacobian<N>
where
    S: Scheme<L> + ?Sized,
    L: SmoothLaw,
{
    let mut found = StepJacobian {
        state: *state,
        matrix: SMatrix::<f64, 6, N>::zeros(),
    };
    for first in (0..N.max(1)).step_by(SIDE) {
        let variable =
            |value, column: usize| Jet::<f64, SIDE>::variable(value, column.wrapping_sub(first));
        let seed = Seed::new(&variable, system.inertia(), state, step);
        let (state, columns) = tangents(&seed.stepped(scheme, system, time));
        for (mut onto, column) in found.matrix.column_iter_mut().skip(first).zip(columns) {
            onto.copy_from(&column);
        }
        found.state = state;
    }
    found
}

/// The columns by name. Asking for columns that `N` does not have is an error of the compiler.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use polhode::motion::{Rk4, Scheme, State, System, Torque};
/// let system = System::new(Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0)), Torque::None)?;
/// let start = State::at_rest().turning(Vector3::new(3.0, 0.5, -0.9));
/// let first = Rk4.step_with_jacobian::<9>(&system, 0.0, &start, 0.01);
/// let second = Rk4.step_with_jacobian::<9>(&system, 0.01, &first.state, 0.01);
/// let both = first.then(&second);
/// assert!((both.by_state() - second.by_state() * first.by_state()).norm() < 1e-15);
/// assert!((both.by_torque() - second.by_state() * first.by_torque() - second.by_torque()).norm() < 1e-15);
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
///
/// ```compile_fail
/// # use polhode::motion::StepJacobian;
/// fn no_torque(step: &StepJacobian<6>) {
///     step.by_torque();
/// }
/// # let step = StepJacobian { state: polhode::motion::State::at_rest(), matrix: nalgebra::SMatrix::zeros() };
/// # no_torque(&step);
/// ```
impl<const N: usize> StepJacobian<N> {
    /// ∂(θ', ω')/∂(θ, ω): 6 × 6.
    pub fn by_state(&self) -> Matrix6<f64> {
        const { assert!(N >= 6, "the state takes 6 columns") };
        self.columns::<6>(0)
    }

    /// ∂(θ', ω')/∂θ: 6 × 3, θ on the body side of the attitude.
    pub fn by_attitude(&self) -> SMatrix<f64, 6, 3> {
        const { assert!(N >= 3, "the attitude takes 3 columns") };
        self.columns::<3>(0)
    }

    /// ∂(θ', ω')/∂ω: 6 × 3.
    pub fn by_angular_velocity(&self) -> SMatrix<f64, 6, 3> {
        const { assert!(N >= 6, "ω stands in columns 3 to 5") };
        self.columns::<3>(3)
    }

    /// ∂(θ', ω')/∂ torque: 6 × 3, the torque constant in the axes that the law names.
    pub fn by_torque(&self) -> SMatrix<f64, 6, 3> {
        const { assert!(N >= 9, "ask for 9 columns or more to have the torque") };
        self.columns::<3>(6)
    }

    /// ∂(θ', ω')/∂ inertia: 6 × 6, the tensor's entries xx, yy, zz, xy, xz, yz.
    pub fn by_inertia(&self) -> Matrix6<f64> {
        const { assert!(N >= 15, "ask for 15 columns or more to have the inertia") };
        self.columns::<6>(9)
    }

    /// ∂(θ', ω')/∂ dt: the rate of the state at the end.
    pub fn by_dt(&self) -> Vector6<f64> {
        const { assert!(N >= 16, "ask for 16 columns to have the length") };
        self.columns::<1>(15)
    }

    fn columns<const C: usize>(&self, first: usize) -> SMatrix<f64, 6, C> {
        self.matrix.fixed_columns::<C>(first).into_owned()
    }

    /// This step and then the `next`, as one: torque, inertia and length are the same in both and move together.
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        const { assert!(N >= 6, "the state takes 6 columns") };
        let mut whole = Self {
            state: next.state,
            matrix: self.matrix,
        };
        chain::chain(&mut whole.matrix, 0, &next.matrix);
        whole
    }

    /// The state, and a covector of (θ', ω') times the matrix.
    pub(crate) fn pulled_back(&self, covector: &Vector6<f64>) -> (State<f64>, SVector<f64, N>) {
        (self.state, self.matrix.tr_mul(covector))
    }
}

/// One step of `scheme`, and its Jacobian times a `direction` of the first `N` of (θ, ω, torque, inertia, dt), by running the step on
/// dual numbers of one derivative.
pub fn jvp<const N: usize, S, L>(
    scheme: &S,
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
    direction: &SVector<f64, N>,
) -> (State<f64>, Vector6<f64>)
where
    S: Scheme<L> + ?Sized,
    L: SmoothLaw,
{
    let variable = |value, column: usize| {
        let along = direction.get(column).copied().unwrap_or(0.0);
        Jet::moving(value, along)
    };
    let seed = Seed::new(&variable, system.inertia(), state, step);
    let (state, [along]) = tangents(&seed.stepped(scheme, system, time));
    (state, along)
}

/// One step of `scheme`, and its Jacobian in the `P` parameters that a system is made of: rows (θ', ω').
///
/// The parameters are dual numbers, and so are the tensor, the torque added and what the law is made of: damping, weight, arm,
/// amplitude, frequency or phase of a [`Law`](crate::motion::Law), or the fields of a law of one's own. For many steps there is
/// [`Rollout::by_parameters`](crate::motion::Rollout::by_parameters).
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use polhode::motion::{Law, Number, Rk4, State, System, jacobian};
///
/// let inertia = Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0));
/// let start = State::at_rest().turning(Vector3::new(3.0, 0.5, -0.9));
/// // A top of which the weight and the height of its centre are sought.
/// let top = |[weight, height]: [_; 2]| {
///     let law = Law::Gravity { weight, arm: Vector3::z() * height };
///     System::over(inertia.map(Number::of), law, Vector3::zeros())
/// };
/// let at = |values| jacobian::by_parameters(&Rk4, top, values, (0.0, 0.1), &start);
/// let (end, by_parameters) = at([9.81, 0.2]);
/// let difference = end.difference(&at([9.81, 0.2 + 1e-6]).0) / 1e-6;
/// assert!((by_parameters.column(1) - difference).norm() < 1e-6);
/// ```
pub fn by_parameters<const P: usize, S, L>(
    scheme: &S,
    system: impl Fn([Jet<f64, P>; P]) -> System<Jet<f64, P>, L>,
    parameters: [f64; P],
    (time, step): (f64, f64),
    state: &State<f64>,
) -> (State<f64>, SMatrix<f64, 6, P>)
where
    S: Scheme<L> + ?Sized,
    L: TorqueLaw<Jet<f64, P>>,
{
    let system = system(std::array::from_fn(|i| Jet::variable(parameters[i], i)));
    let start = State {
        attitude: Quaternion::new(state.attitude.components().map(Number::of)),
        angular_velocity: state.angular_velocity.map(Number::of),
    };
    let end = scheme.step(&system, Number::of(time), &start, Number::of(step));
    let (state, columns) = tangents(&end);
    (state, SMatrix::from_columns(&columns))
}

/// A step's input as numbers of which column `c` is the variable `c`.
struct Seed<T> {
    state: State<T>,
    added: Vector3<T>,
    inertia: Matrix3<T>,
    step: T,
}

impl<T: Number> Seed<T> {
    /// Seeds by `variable(value, column)`.
    fn new(
        variable: &impl Fn(f64, usize) -> T,
        inertia: &Matrix3<f64>,
        state: &State<f64>,
        step: f64,
    ) -> Self {
        // exp(θ/2) to first order in θ, which is 0.
        let half = Vector3::from_fn(|i, _| variable(0.0, i) * T::of(0.5));
        let turn = Quaternion {
            w: T::one(),
            v: half,
        };
        let attitude = Quaternion::new(state.attitude.components().map(T::of));
        let entry = |r: usize, c: usize| variable(inertia[(r, c)], 9 + INERTIA_COLUMN[r][c]);
        let omega = &state.angular_velocity;
        Self {
            state: State {
                attitude: attitude * turn,
                angular_velocity: Vector3::from_fn(|i, _| variable(omega[i], 3 + i)),
            },
            added: Vector3::from_fn(|i, _| variable(0.0, 6 + i)),
            inertia: Matrix3::from_fn(entry),
            step: variable(step, 15),
        }
    }

    /// The state after one step of `scheme` from here.
    fn stepped<S, L>(self, scheme: &S, system: &System<f64, L>, time: f64) -> State<T>
    where
        S: Scheme<L> + ?Sized,
        L: SmoothLaw + TorqueLaw<T>,
    {
        let added = self.added + system.added().map(T::of);
        let system = System::over(self.inertia, *system.law(), added);
        scheme.step(&system, T::of(time), &self.state, self.step)
    }
}

/// The place of each tensor entry in the order xx, yy, zz, xy, xz, yz.
const INERTIA_COLUMN: [[usize; 3]; 3] = [[0, 3, 4], [3, 1, 5], [4, 5, 2]];

/// Values and tangent derivatives of a state of dual numbers. δθ = 2 Im(q⁻¹ δq) for a unit q; what δq has along
/// q is real and drops out.
fn tangents<const K: usize>(end: &State<Jet<f64, K>>) -> (State<f64>, [Vector6<f64>; K]) {
    let attitude = Quaternion::new(end.attitude.components().map(|c| c.value));
    let angular_velocity = end.angular_velocity.map(|c| c.value);
    let columns = std::array::from_fn(|k| {
        let rate = Quaternion::new(end.attitude.components().map(|c| c.partials[k]));
        let theta = (attitude.conjugate() * rate).v * 2.0;
        let omega = end.angular_velocity.map(|c| c.partials[k]);
        Vector6::new(theta.x, theta.y, theta.z, omega.x, omega.y, omega.z)
    });
    let state = State {
        attitude,
        angular_velocity,
    };
    (state, columns)
}
