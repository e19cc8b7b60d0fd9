//! Products of the Jacobian with one vector, from either side, without the matrix.

use super::algebra::splat;
use super::alone::{Alone, full, principal};
use super::along::{Direction, along};
use super::tensor::Tensor;
use crate::motion::registers::{Arithmetic, Registers, Work, one_at_a_time};
use crate::motion::{State, System, TorqueLaw};
use nalgebra::{SVector, Vector6};

/// A state and zeros overwritten by the state after the step and the Jacobian times a direction of its first `N` inputs;
/// `false` if the law gives a torque that depends on the attitude. In place, for copies would take as long as the work.
#[inline(always)]
pub(crate) fn jvp<const N: usize, L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    step: f64,
    direction: &SVector<f64, N>,
    (state, product): &mut (State<f64>, Vector6<f64>),
) -> bool {
    one_at_a_time(One {
        system,
        time,
        step,
        given: Forward(&direction.data.0[0]),
        state,
        product: &mut product.data.0[0],
    })
}

/// The same of a covector of the result times the first `N` columns of the Jacobian.
#[inline(always)]
pub(crate) fn vjp<const N: usize, L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    step: f64,
    covector: &Vector6<f64>,
    (state, product): &mut (State<f64>, SVector<f64, N>),
) -> bool {
    one_at_a_time(One {
        system,
        time,
        step,
        given: Backward(&covector.data.0[0]),
        state,
        product: &mut product.data.0[0],
    })
}

/// What the Jacobian is multiplied by, for a product of `M` components.
trait Given<const M: usize> {
    /// Writes the state after the step and the product.
    fn write<R: Registers>(
        &self,
        alone: &Alone<R>,
        tensor: impl Tensor<R::Wide>,
        state: &mut State<f64>,
        product: &mut [f64; M],
    );
}

/// One body and a product.
struct One<'a, const M: usize, L, G> {
    system: &'a System<f64, L>,
    time: f64,
    step: f64,
    given: G,
    state: &'a mut State<f64>,
    product: &'a mut [f64; M],
}

impl<const M: usize, L: TorqueLaw<f64>, G: Given<M>> Work for One<'_, M, L, G> {
    type Output = bool;

    #[inline(always)]
    fn run<R: Registers>(self, registers: R) -> bool {
        let (system, state) = (self.system, self.state);
        let Some(alone) = Alone::new(registers, system, self.time, state, self.step) else {
            return false;
        };
        if system.is_principal() {
            let tensor = principal(system).splat(registers);
            self.given.write(&alone, tensor, state, self.product);
        } else {
            let tensor = full(system).splat(registers);
            self.given.write(&alone, tensor, state, self.product);
        }
        true
    }
}

/// The Jacobian times a direction of the first `N` of the input (θ, ω, torque, inertia, dt).
struct Forward<'a, const N: usize>(&'a [f64; N]);

impl<const N: usize> Forward<'_, N> {
    #[inline(always)]
    fn direction<R: Registers>(&self, registers: R) -> Direction<R::Wide> {
        let mut all = [registers.splat(0.0); 16];
        for (i, place) in all.iter_mut().enumerate() {
            // One by one: a loop over the given ones becomes a copy, and what was just copied is slow to read.
            if let Some(value) = self.0.get(i) {
                *place = registers.splat(*value);
            }
        }
        let [a, b, c, d, e, f, g, h, i, inertia @ .., span] = all;
        Direction {
            theta: [a, b, c],
            omega: [d, e, f],
            torque: [g, h, i],
            inertia,
            span,
        }
    }
}

impl<const N: usize> Given<6> for Forward<'_, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn write<R: Registers>(
        &self,
        alone: &Alone<R>,
        tensor: impl Tensor<R::Wide>,
        state: &mut State<f64>,
        product: &mut [f64; 6],
    ) {
        let direction = self.direction(alone.registers);
        let (stages, along) = along(tensor, alone.omega, alone.step, &alone.moments, &direction);
        *product = alone.firsts(along);
        *state = alone.end(&stages);
    }
}

/// A covector of the result (θ', ω') times the first `N` columns of the Jacobian.
struct Backward<'a>(&'a [f64; 6]);

/// The first `N` of a covector of the input.
#[inline(always)]
fn firsts<T: Arithmetic, const N: usize>(all: [T; 16]) -> [T; N] {
    let mut firsts = [all[0]; N];
    for (first, value) in firsts.iter_mut().zip(all) {
        *first = value;
    }
    firsts
}

impl<const N: usize> Given<N> for Backward<'_> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn write<R: Registers>(
        &self,
        alone: &Alone<R>,
        tensor: impl Tensor<R::Wide>,
        state: &mut State<f64>,
        product: &mut [f64; N],
    ) {
        let [a, b, c, x, y, z] = splat(alone.registers, *self.0);
        let stages = alone.stages(tensor);
        // Before the way back, which need not wait for the root.
        *state = alone.end(&stages);
        let pulled = stages.pulled_back::<N>(Some([a, b, c]), Some([x, y, z]));
        *product = alone.firsts(firsts(pulled.flat()));
    }
}
