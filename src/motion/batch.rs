//! Many bodies at once, eight side by side.

mod dispatch;
mod jacobians;

pub use jacobians::Jacobians;

use crate::mechanics::possible_body;
use crate::motion::{
    LANES, Lanes, MotionError, Number, Quaternion, Scheme, State, System, TorqueLaw,
};
use crate::scalar::Jet;
use dispatch::for_each_block;
use nalgebra::{Matrix3, Vector3};
use std::{error::Error, fmt};

/// Bodies under one law of torque, moved together: an ensemble over states, or over states and inertia.
///
/// Eight bodies stand side by side and go through the scheme as one [`Lanes`] each, with the widest registers that the
/// machine has; each body moves as it would alone, to the bit. With the feature `parallel` the blocks of
/// eight are shared out among the threads of the current `rayon` pool. A body takes 56 bytes, and 48 for a tensor of
/// its own.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use polhode::motion::{Batch, Rk4, State, Torque};
///
/// let inertia = Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0));
/// let spins = (0..1000).map(|i| State::at_rest().turning(Vector3::new(3.0, 0.001 * i as f64, -0.9)));
/// let mut batch = Batch::sharing(inertia, spins)?;
/// batch.advance(&Rk4, Torque::Damping { coefficient: 0.1 }, 0.01, 100)?;
/// assert!(batch.state(999).is_some_and(|s| s.angular_velocity.norm() < 3.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Batch {
    len: usize,
    time: f64,
    states: Vec<State<Lanes>>,
    inertia: Inertia,
}

#[derive(Clone, Debug)]
enum Inertia {
    Shared(Matrix3<f64>),
    /// xx, yy, zz, xy, xz, yz.
    Own(Vec<[Lanes; 6]>),
}

/// A body of a batch whose state or torque stopped being finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyDiverged {
    /// The body's place in the batch, from 0.
    pub body: usize,
    /// The time at the start of the steps that failed, s.
    pub time: f64,
}

impl fmt::Display for BodyDiverged {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { body, time } = self;
        write!(
            f,
            "body {body}: the torque or the state is no longer finite after t = {time} s"
        )
    }
}

impl Error for BodyDiverged {}

impl Batch {
    /// Bodies of one inertia tensor (kg m², body axes, the tensor's own entries).
    ///
    /// # Errors
    /// A tensor that no body has.
    pub fn sharing(
        inertia: Matrix3<f64>,
        states: impl IntoIterator<Item = State<f64>>,
    ) -> Result<Self, MotionError> {
        possible_body(&inertia).map_err(MotionError::Inertia)?;
        let states: Vec<_> = states.into_iter().collect();
        Ok(Self {
            len: states.len(),
            time: 0.0,
            states: blocks(&states, side_by_side),
            inertia: Inertia::Shared(inertia),
        })
    }

    /// Bodies of a tensor and a state each.
    ///
    /// # Errors
    /// A tensor that no body has.
    pub fn of_bodies(
        bodies: impl IntoIterator<Item = (Matrix3<f64>, State<f64>)>,
    ) -> Result<Self, MotionError> {
        let (tensors, states): (Vec<_>, Vec<_>) = bodies.into_iter().unzip();
        for tensor in &tensors {
            possible_body(tensor).map_err(MotionError::Inertia)?;
        }
        let entries = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
        Ok(Self {
            len: states.len(),
            time: 0.0,
            states: blocks(&states, side_by_side),
            inertia: Inertia::Own(blocks(&tensors, |block: &[Matrix3<f64>; LANES]| {
                entries.map(|entry| Lanes::new(block.map(|tensor| tensor[entry])))
            })),
        })
    }

    /// How many bodies there are.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The time reached, s.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// The state of a body, `None` past the last.
    pub fn state(&self, body: usize) -> Option<State<f64>> {
        let lane = body % LANES;
        let block = self.states.get(body / LANES).filter(|_| body < self.len)?;
        Some(State {
            attitude: Quaternion::new(block.attitude.components().map(|c| c.to_array()[lane])),
            angular_velocity: block.angular_velocity.map(|c| c.to_array()[lane]),
        })
    }

    /// The states of all bodies in their order.
    pub fn states(&self) -> impl Iterator<Item = State<f64>> + '_ {
        (0..self.len).filter_map(|body| self.state(body))
    }

    /// `count` steps of length `step` (s) for every body, the blocks one after the other: each stays in the
    /// nearest memory until it is done.
    ///
    /// # Errors
    /// The first body whose state stopped being finite; the batch then stands after the steps all the same.
    pub fn advance<S, L>(
        &mut self,
        scheme: &S,
        law: L,
        step: f64,
        count: u64,
    ) -> Result<(), BodyDiverged>
    where
        S: Scheme<L> + Sync,
        L: TorqueLaw<Lanes> + Copy + Send + Sync,
    {
        let start = self.time;
        let inertia = &self.inertia;
        let all = for_each_block(&mut self.states, |index, state: &mut State<Lanes>| {
            let system = inertia.system(index, law);
            for n in 0..count {
                let time = Lanes::of(start + step * n as f64);
                *state = scheme.step(&system, time, state, Lanes::of(step));
            }
            finite(state)
        });
        self.time = start + step * count as f64;
        self.checked(all, start)
    }

    /// One step of every body, and its Jacobian (columns as in [`jacobian`](crate::motion::jacobian), `N` of them)
    /// written to `out`.
    ///
    /// # Errors
    /// As [`advance`](Self::advance).
    pub fn step_with_jacobian<const N: usize, S, L>(
        &mut self,
        scheme: &S,
        law: L,
        step: f64,
        out: &mut Jacobians<N>,
    ) -> Result<(), BodyDiverged>
    where
        S: Scheme<L> + Sync,
        L: TorqueLaw<Lanes> + TorqueLaw<Jet<Lanes, N>> + Copy + Send + Sync,
    {
        let start = self.time;
        let inertia = &self.inertia;
        out.resize(self.len);
        let pairs = self.states.iter_mut().zip(out.blocks_mut());
        let mut pairs: Vec<_> = pairs.collect();
        let all = for_each_block(&mut pairs, |index, (state, columns)| {
            let system = inertia.system(index, law);
            let time = Lanes::of(start);
            scheme.step_with_columns(&system, time, state, Lanes::of(step), columns);
            finite(state)
        });
        self.time = start + step;
        self.checked(all, start)
    }

    fn checked(&self, all_finite: bool, time: f64) -> Result<(), BodyDiverged> {
        if all_finite {
            return Ok(());
        }
        match self.states().position(|state| !state.is_finite()) {
            Some(body) => Err(BodyDiverged { body, time }),
            // What is not finite stands where a block is filled up.
            None => Ok(()),
        }
    }
}

impl Inertia {
    #[inline(always)]
    fn system<L: TorqueLaw<Lanes>>(&self, block: usize, law: L) -> System<Lanes, L> {
        let zero = Vector3::from_element(Lanes::of(0.0));
        match self {
            Self::Shared(tensor) => {
                let products = [tensor[(0, 1)], tensor[(0, 2)], tensor[(1, 2)]];
                let system = System::over(tensor.map(Lanes::of), law, zero);
                system.along_axes(products.iter().all(|p| *p == 0.0))
            }
            Self::Own(tensors) => {
                let [xx, yy, zz, xy, xz, yz] = tensors[block];
                System::over(Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz), law, zero)
            }
        }
    }
}

/// Blocks of eight, the last filled up with its own last one.
fn blocks<T: Copy, B>(all: &[T], block: impl Fn(&[T; LANES]) -> B) -> Vec<B> {
    let filled = |chunk: &[T]| std::array::from_fn(|i| chunk[i.min(chunk.len() - 1)]);
    all.chunks(LANES)
        .map(|chunk| block(&filled(chunk)))
        .collect()
}

fn side_by_side(states: &[State<f64>; LANES]) -> State<Lanes> {
    let part = |get: &dyn Fn(&State<f64>) -> f64| Lanes::new(states.each_ref().map(get));
    let attitude = std::array::from_fn(|i| part(&|s| s.attitude.components()[i]));
    State {
        attitude: Quaternion::new(attitude),
        angular_velocity: Vector3::from_fn(|i, _| part(&|s| s.angular_velocity[i])),
    }
}

/// Whether every component is a finite number: 0 times anything else is not 0.
#[inline(always)]
fn finite(state: &State<Lanes>) -> bool {
    let omega = &state.angular_velocity;
    let sum = state.attitude.norm_squared() + omega.x + omega.y + omega.z;
    let zeros = sum * Lanes::of(0.0);
    zeros.to_array().iter().sum::<f64>() == 0.0
}
