//! Products of the Jacobian with one vector, from either side, without the matrix.

use super::algebra::splat;
use super::alone::{Task, alone, end, firsts};
use super::along::{Direction, along};
use super::moments::Moments;
use super::stages::{Stages, Start};
use super::tensor::Tensor;
use crate::motion::registers::{Registers, Work, one_at_a_time};
use crate::motion::system::entries;
use crate::motion::{Number, Quaternion, SmoothLaw, State, System, TorqueLaw};
use crate::scalar::Jet;
use nalgebra::{SVector, Vector3, Vector6};

/// A state and zeros overwritten by the state after a step and the Jacobian times a direction of its first `N` inputs;
/// `false` if the law is said to be linear and is not. In place, for copies would take as long as the work.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn jvp<const N: usize, L: SmoothLaw>(
    system: &System<f64, L>,
    time: f64,
    start: &State<f64>,
    step: f64,
    direction: &SVector<f64, N>,
    (state, product): &mut (State<f64>, Vector6<f64>),
) -> bool {
    one_at_a_time(One {
        system,
        time,
        step,
        state: start,
        task: Forward {
            direction: &direction.data.0[0],
            state,
            product: &mut product.data.0[0],
        },
    })
}

/// The same of a covector of the result times the first `N` columns of the Jacobian.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn vjp<const N: usize, L: SmoothLaw>(
    system: &System<f64, L>,
    time: f64,
    start: &State<f64>,
    step: f64,
    covector: &Vector6<f64>,
    (state, product): &mut (State<f64>, SVector<f64, N>),
) -> bool {
    one_at_a_time(One {
        system,
        time,
        step,
        state: start,
        task: Backward {
            covector: &covector.data.0[0],
            state,
            product: &mut product.data.0[0],
        },
    })
}

/// What a covector of the result of a step is of the tensor and of the torque at each stage.
#[derive(Clone, Copy)]
pub(crate) struct Felt {
    /// Of the tensor's entries xx, yy, zz, xy, xz, yz.
    pub(crate) inertia: [f64; 6],
    /// The state at each stage, and the covector of the torque there, body axes.
    pub(crate) torques: [(State<f64>, Vector3<f64>); 4],
}

impl Felt {
    /// That of no covector.
    pub(crate) fn in_state(state: &State<f64>) -> Self {
        Self {
            inertia: [0.0; 6],
            torques: [(*state, Vector3::zeros()); 4],
        }
    }

    /// The covector of the parameters of a step's system.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn by_parameters<const P: usize, K: TorqueLaw<Jet<f64, P>>>(
        &self,
        variable: &System<Jet<f64, P>, K>,
        (time, step): (f64, f64),
    ) -> SVector<f64, P> {
        let mut gradient = SVector::zeros();
        let mut add = |number: Jet<f64, P>, of: f64| {
            gradient += SVector::from(number.partials) * of;
        };
        for (entry, of) in entries(variable.inertia()).into_iter().zip(self.inertia) {
            add(entry, of);
        }
        let (law, added) = (variable.law(), variable.added());
        let times = [time, time + 0.5 * step, time + step];
        let [start, middle, end] = law.clock(times.map(Number::of));
        let readings = [start, middle, middle, end];
        for ((state, of), reading) in self.torques.iter().zip(readings) {
            let there = State {
                attitude: Quaternion::new(state.attitude.components().map(Number::of)),
                angular_velocity: state.angular_velocity.map(Number::of),
            };
            let torque = law.torque_by(reading, &there, added);
            for i in 0..3 {
                add(torque[i], of[i]);
            }
        }
        gradient
    }
}

/// Overwrites what a covector of the result of a step is of what makes it; `false` if the law is said to be linear and is not.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn felt<L: SmoothLaw>(
    system: &System<f64, L>,
    (time, step): (f64, f64),
    state: &State<f64>,
    covector: &Vector6<f64>,
    felt: &mut Felt,
) -> bool {
    one_at_a_time(One {
        system,
        time,
        step,
        state,
        task: Inward {
            covector: &covector.data.0[0],
            felt,
        },
    })
}

/// One body and a product.
struct One<'a, L, T> {
    system: &'a System<f64, L>,
    time: f64,
    step: f64,
    state: &'a State<f64>,
    task: T,
}

impl<L: SmoothLaw, T: Task> Work for One<'_, L, T> {
    type Output = bool;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<R: Registers>(self, registers: R) -> bool {
        let times = (self.time, self.step);
        alone(registers, self.system, times, self.state, self.task)
    }
}

/// The Jacobian times a direction of the first `N` of the input (θ, ω, torque, inertia, dt).
struct Forward<'a, const N: usize> {
    direction: &'a [f64; N],
    state: &'a mut State<f64>,
    product: &'a mut [f64; 6],
}

impl<const N: usize> Forward<'_, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn direction<R: Registers>(&self, registers: R) -> Direction<R::Wide> {
        let mut all = [registers.splat(0.0); 16];
        for (i, place) in all.iter_mut().enumerate() {
            // One by one: a loop over the given ones becomes a copy, and what was just copied is slow to read.
            if let Some(value) = self.direction.get(i) {
                *place = registers.splat(*value);
            }
        }
        let [a, b, c, d, e, f, g, h, i, inertia @ .., span] = all;
        Direction {
            theta: [a, b, c],
            omega: [d, e, f],
            torque: [g, h, i],
            inertia,
            span: (N > 15).then_some(span),
        }
    }
}

impl<const N: usize> Task for Forward<'_, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<R: Registers>(
        self,
        registers: R,
        start: Start<R::Wide>,
        tensor: impl Tensor<R::Wide>,
        moments: &impl Moments<R::Wide>,
    ) {
        let direction = self.direction(registers);
        let (stages, along) = along(tensor, moments, start, &direction);
        *self.product = firsts(registers, along);
        *self.state = end(registers, &stages);
    }
}

/// A covector of the result (θ', ω') times the first `N` columns of the Jacobian.
struct Backward<'a, const N: usize> {
    covector: &'a [f64; 6],
    state: &'a mut State<f64>,
    product: &'a mut [f64; N],
}

impl<const N: usize> Task for Backward<'_, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<R: Registers>(
        self,
        registers: R,
        start: Start<R::Wide>,
        tensor: impl Tensor<R::Wide>,
        moments: &impl Moments<R::Wide>,
    ) {
        let [a, b, c, x, y, z] = splat(registers, *self.covector);
        let stages = Stages::new(tensor, moments, start);
        // Before the way back, which need not wait for the root.
        *self.state = end(registers, &stages);
        let pulled = stages.pulled_back::<N>(Some([a, b, c]), Some([x, y, z]));
        *self.product = firsts(registers, first(pulled.flat()));
    }
}

/// A covector of the result back to the tensor and the torques.
struct Inward<'a> {
    covector: &'a [f64; 6],
    felt: &'a mut Felt,
}

impl Task for Inward<'_> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<R: Registers>(
        self,
        registers: R,
        start: Start<R::Wide>,
        tensor: impl Tensor<R::Wide>,
        moments: &impl Moments<R::Wide>,
    ) {
        let [a, b, c, x, y, z] = splat(registers, *self.covector);
        let stages = Stages::new(tensor, moments, start);
        let pulled = stages.pulled_back::<15>(Some([a, b, c]), Some([x, y, z]));
        self.felt.inertia = firsts(registers, pulled.inertia);
        for (i, (state, torque)) in self.felt.torques.iter_mut().enumerate() {
            let (attitude, omega) = stages.place(i);
            *state = State {
                attitude: Quaternion::new(firsts(registers, attitude)),
                angular_velocity: firsts(registers, omega).into(),
            };
            *torque = firsts(registers, pulled.torques[i]).into();
        }
    }
}

/// The first `N` of a covector of the input.
#[cfg_attr(not(debug_assertions), inline(always))]
fn first<T: Copy, const N: usize>(all: [T; 16]) -> [T; N] {
    let mut first = [all[0]; N];
    for (first, value) in first.iter_mut().zip(all) {
        *first = value;
    }
    first
}
