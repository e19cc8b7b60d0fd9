//! Many bodies at once, eight side by side.

mod dispatch;
mod jacobians;

pub use jacobians::Jacobians;

use crate::mechanics::possible_body;
use crate::motion::stepper::positive;
use crate::motion::system::{entries, inverse};
use crate::motion::{
    Block, LANES, Lane, MotionError, Scheme, SmoothLaw, State, System, Tensors, TorqueLaw,
};
use dispatch::{for_each_block, for_each_share};
use nalgebra::{Matrix3, Vector3};

/// Bodies under one law of torque, moved together: an ensemble over states, or over states and inertia.
///
/// Eight bodies stand side by side, component by component, so that a step of plain arithmetic such as
/// [`Rk4`](crate::motion::Rk4) runs on registers as wide as the machine has; each body moves as it would alone, to
/// the bit where the eight are all along their principal axes or none is. With the feature `parallel` the blocks of
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
    blocks: Vec<Block>,
    inertia: Inertia,
}

#[derive(Clone, Debug)]
enum Inertia {
    Shared(Matrix3<f64>, Tensors<'static>),
    /// xx, yy, zz, xy, xz, yz.
    Own(Vec<[Lane; 6]>),
}

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
            blocks: in_blocks(&states, Block::new),
            inertia: Inertia::Shared(inertia, shared(&inertia)),
        })
    }

    /// Bodies of a tensor and a state each.
    ///
    /// # Errors
    /// The first body whose tensor no body has.
    pub fn of_bodies(
        bodies: impl IntoIterator<Item = (Matrix3<f64>, State<f64>)>,
    ) -> Result<Self, MotionError> {
        let (tensors, states): (Vec<_>, Vec<_>) = bodies.into_iter().unzip();
        for (body, tensor) in tensors.iter().enumerate() {
            possible_body(tensor).map_err(|reason| MotionError::BodyInertia { body, reason })?;
        }
        Ok(Self {
            len: states.len(),
            time: 0.0,
            blocks: in_blocks(&states, Block::new),
            inertia: Inertia::Own(in_blocks(&tensors, |block: &[Matrix3<f64>; LANES]| {
                let of_each = block.map(|tensor| entries(&tensor));
                std::array::from_fn(|entry| of_each.map(|body| body[entry]))
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
        let block = self.blocks.get(body / LANES).filter(|_| body < self.len)?;
        Some(block.get(body % LANES))
    }

    /// The states of all bodies in their order.
    pub fn states(&self) -> impl Iterator<Item = State<f64>> + '_ {
        (0..self.len).filter_map(|body| self.state(body))
    }

    /// `count` steps of length `step` (s) for every body, the blocks one after the other: each stays in the
    /// nearest memory until it is done.
    ///
    /// # Errors
    /// A step that is not positive and finite: nothing has moved then. The first body whose torque or state stopped being
    /// finite, in time and then in number: its block of eight has stopped there, the others stand after the steps.
    pub fn advance<S, L>(
        &mut self,
        scheme: &S,
        law: L,
        step: f64,
        count: u64,
    ) -> Result<(), MotionError>
    where
        S: Scheme<L> + Sync,
        L: TorqueLaw<f64> + Copy + Send + Sync,
    {
        positive(step)?;
        let start = self.time;
        let inertia = &self.inertia;
        let failed = for_each_block(
            &mut self.blocks,
            #[cfg_attr(not(debug_assertions), inline(always))]
            |index, block: &mut Block| {
                law.by_kind(
                    #[cfg_attr(not(debug_assertions), inline(always))]
                    |law| match inertia {
                        Inertia::Shared(tensor, shared) if is_diagonal(tensor) => {
                            let system = of(*tensor, law).along_axes(true);
                            steps(
                                scheme,
                                shared,
                                (law, |_| system),
                                block,
                                (start, step, count),
                            )
                        }
                        Inertia::Shared(tensor, shared) => {
                            let system = of(*tensor, law);
                            steps(
                                scheme,
                                shared,
                                (law, |_| system),
                                block,
                                (start, step, count),
                            )
                        }
                        Inertia::Own(tensors) => {
                            let own = &tensors[index];
                            let principal = are_diagonal(own);
                            let system =
                                |lane: usize| of(tensor_of(own, lane), law).along_axes(principal);
                            let tensors = match principal {
                                true => Tensors::OwnPrincipal(own),
                                false => Tensors::Own(own),
                            };
                            steps(scheme, &tensors, (law, system), block, (start, step, count))
                        }
                    },
                )
            },
        );
        self.time = start + step * count as f64;
        failed.map_or(Ok(()), |Failed { time, body }| {
            Err(MotionError::BodyDiverged { body, time })
        })
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
    ) -> Result<(), MotionError>
    where
        S: Scheme<L> + Sync,
        L: SmoothLaw + Send + Sync,
    {
        positive(step)?;
        let start = self.time;
        let inertia = &self.inertia;
        out.resize(self.len);
        let mut pairs: Vec<_> = self.blocks.iter_mut().zip(out.blocks_mut()).collect();
        // The scheme itself takes to the widest registers.
        let failed = for_each_share(&mut pairs, |first, pairs| {
            let mut failed = None;
            for (i, (block, columns)) in pairs.iter_mut().enumerate() {
                match inertia {
                    Inertia::Shared(tensor, _) => {
                        let system = of(*tensor, law).along_axes(is_diagonal(tensor));
                        scheme.block_with_jacobian(&|_| system, start, block, step, columns);
                    }
                    Inertia::Own(tensors) => {
                        let own = &tensors[first + i];
                        let principal = are_diagonal(own);
                        let system =
                            |lane: usize| of(tensor_of(own, lane), law).along_axes(principal);
                        scheme.block_with_jacobian(&system, start, block, step, columns);
                    }
                }
                failed = Failed::first(
                    failed,
                    Failed::within(block, start).map(|f| f.in_block(first + i)),
                );
            }
            failed
        });
        self.time = start + step;
        failed.map_or(Ok(()), |Failed { time, body }| {
            Err(MotionError::BodyDiverged { body, time })
        })
    }
}

/// A body that stopped being finite, and the time at the start of the step in which it did.
#[derive(Clone, Copy)]
struct Failed {
    time: f64,
    body: usize,
}

impl Failed {
    /// The first lane of a block that is not finite.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn within(block: &Block, time: f64) -> Option<Self> {
        if block.is_finite() {
            return None;
        }
        // The last block is filled up with its own last body: what fails there failed in that body before.
        let body = (0..LANES).find(|lane| !block.get(*lane).is_finite())?;
        Some(Self { time, body })
    }

    /// A lane of a block as a body of the batch.
    fn in_block(self, index: usize) -> Self {
        Self {
            body: self.body + index * LANES,
            ..self
        }
    }

    /// Whichever comes first.
    fn first(a: Option<Self>, b: Option<Self>) -> Option<Self> {
        match (a, b) {
            (Some(a), Some(b)) if (b.time, b.body) < (a.time, a.body) => Some(b),
            (Some(a), _) => Some(a),
            (None, b) => b,
        }
    }
}

/// The steps of a block. Straight through the bodies, so that they share registers.
#[cfg_attr(not(debug_assertions), inline(always))]
fn steps<S: Scheme<L>, L: TorqueLaw<f64>>(
    scheme: &S,
    tensors: &Tensors<'_>,
    (law, system): (L, impl Fn(usize) -> System<f64, L>),
    block: &mut Block,
    (start, step, count): (f64, f64, u64),
) -> Option<Failed> {
    for n in 0..count {
        let time = start + step * n as f64;
        if !scheme.block_step(&law, tensors, time, block, step) {
            for lane in 0..LANES {
                let end = scheme.step(&system(lane), time, &block.get(lane), step);
                block.set(lane, &end);
            }
        }
        if !block.is_finite() {
            return Failed::within(block, time);
        }
    }
    None
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn of<L: TorqueLaw<f64>>(tensor: Matrix3<f64>, law: L) -> System<f64, L> {
    System::over(tensor, law, Vector3::zeros())
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn tensor_of([xx, yy, zz, xy, xz, yz]: &[Lane; 6], lane: usize) -> Matrix3<f64> {
    let [xy, xz, yz] = [xy[lane], xz[lane], yz[lane]];
    Matrix3::new(xx[lane], xy, xz, xy, yy[lane], yz, xz, yz, zz[lane])
}

fn is_diagonal(tensor: &Matrix3<f64>) -> bool {
    [(0, 1), (0, 2), (1, 2)]
        .iter()
        .all(|entry| tensor[*entry] == 0.0)
}

/// A tensor that all bodies share.
fn shared(tensor: &Matrix3<f64>) -> Tensors<'static> {
    let (entries, inverse) = (entries(tensor), entries(&inverse(tensor)));
    let ([x, y, z, ..], [a, b, c, ..]) = (entries, inverse);
    match is_diagonal(tensor) {
        true => Tensors::Principal {
            moments: [x, y, z],
            inverse: [a, b, c],
        },
        false => Tensors::Shared { entries, inverse },
    }
}

/// Whether the products of inertia of all bodies of a block are zero.
#[cfg_attr(not(debug_assertions), inline(always))]
fn are_diagonal([_, _, _, xy, xz, yz]: &[Lane; 6]) -> bool {
    let mut none = true;
    for lane in 0..LANES {
        none &= xy[lane] == 0.0 && xz[lane] == 0.0 && yz[lane] == 0.0;
    }
    none
}

/// Blocks of eight, the last filled up with its own last one.
fn in_blocks<T: Copy, B>(all: &[T], block: impl Fn(&[T; LANES]) -> B) -> Vec<B> {
    let filled = |chunk: &[T]| std::array::from_fn(|i| chunk[i.min(chunk.len() - 1)]);
    all.chunks(LANES)
        .map(|chunk| block(&filled(chunk)))
        .collect()
}
