//! Products of the Jacobian with one vector, from either side, without the matrix.

use super::algebra::{
    Tensor, Turn, Vector, applied, between, matrix, minus, plus, plus_times, pulled, splat,
    symmetric, times, turned,
};
use super::alone::{Alone, full, principal};
use super::stages::{PARTS, Stage, Stages, mean};
use crate::motion::registers::{Arithmetic, Registers, Work, one_at_a_time};
use crate::motion::{State, System, TorqueLaw};
use nalgebra::{SVector, Vector6};

/// The step and its Jacobian times a direction of the input, or `None` if the law gives a torque that depends on the
/// attitude.
#[inline(always)]
pub(crate) fn jvp<L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
    direction: &SVector<f64, 16>,
) -> Option<(State<f64>, Vector6<f64>)> {
    let forward = Forward(&direction.data.0[0]);
    let (state, along) = one_at_a_time(One::new(system, (time, state, step), forward))?;
    Some((state, along.into()))
}

/// The step and a covector of its result times the Jacobian, or `None` if the law gives a torque that depends on the
/// attitude.
#[inline(always)]
pub(crate) fn vjp<L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
    covector: &Vector6<f64>,
) -> Option<(State<f64>, SVector<f64, 16>)> {
    let backward = Backward(&covector.data.0[0]);
    let (state, back) = one_at_a_time(One::new(system, (time, state, step), backward))?;
    Some((state, back.into()))
}

/// A product with the Jacobian, of `N` components.
trait Product<const N: usize> {
    /// The stages of the step, and the product.
    fn of<R: Registers, I: Tensor<R::Wide>>(
        &self,
        alone: &Alone<R>,
        tensor: I,
    ) -> (Stages<R::Wide, I>, [R::Wide; N]);
}

/// One body and a product.
struct One<'a, const N: usize, L, P> {
    system: &'a System<f64, L>,
    step: (f64, &'a State<f64>, f64),
    product: P,
}

impl<'a, const N: usize, L: TorqueLaw<f64>, P: Product<N>> One<'a, N, L, P> {
    #[inline(always)]
    fn new(system: &'a System<f64, L>, step: (f64, &'a State<f64>, f64), product: P) -> Self {
        Self {
            system,
            step,
            product,
        }
    }

    #[inline(always)]
    fn with<R: Registers>(
        &self,
        alone: &Alone<R>,
        tensor: impl Tensor<R::Wide>,
    ) -> (State<f64>, [f64; N]) {
        let (stages, product) = self.product.of(alone, tensor);
        (alone.end(&stages), alone.firsts(product))
    }
}

impl<const N: usize, L: TorqueLaw<f64>, P: Product<N>> Work for One<'_, N, L, P> {
    type Output = Option<(State<f64>, [f64; N])>;

    #[inline(always)]
    fn run<R: Registers>(self, registers: R) -> Self::Output {
        let (system, (time, state, step)) = (self.system, self.step);
        let alone = Alone::new(registers, system, time, state, step)?;
        Some(if system.is_principal() {
            self.with(&alone, principal(system).splat(registers))
        } else {
            self.with(&alone, full(system).splat(registers))
        })
    }
}

/// The Jacobian times a direction of the input (θ, ω, torque, inertia, dt).
struct Forward<'a>(&'a [f64; 16]);

impl Product<6> for Forward<'_> {
    #[inline(always)]
    fn of<R: Registers, I: Tensor<R::Wide>>(
        &self,
        alone: &Alone<R>,
        tensor: I,
    ) -> (Stages<R::Wide, I>, [R::Wide; 6]) {
        let direction = splat(alone.registers, *self.0);
        let [_, _, _, a, b, c, d, e, f, inertia @ .., span] = direction;
        let along = Direction {
            omega: [a, b, c],
            torque: [d, e, f],
            inertia,
            span,
            step: alone.step,
        };
        let ([at_start, midway, at_end], start) = (&alone.moments, alone.omega);
        // Stage by stage, for what a stage leaves behind fills all registers.
        let first = Stage::new(&tensor, at_start, start, None);
        let a = along.first(&tensor, &first);
        let second = first.after(&tensor, midway, start, PARTS[1] * alone.step);
        let b = along.after(&tensor, (&first, &a), &second, PARTS[1]);
        let third = second.after(&tensor, midway, start, PARTS[2] * alone.step);
        let c = along.after(&tensor, (&second, &b), &third, PARTS[2]);
        let fourth = third.after(&tensor, at_end, start, PARTS[3] * alone.step);
        let d = along.after(&tensor, (&third, &c), &fourth, PARTS[3]);
        let stages = Stages::of(tensor, alone.step, [first, second, third, fourth]);
        let mean = Change {
            turn_rate: mean([a.turn_rate, b.turn_rate, c.turn_rate, d.turn_rate]),
            acceleration: mean([
                a.acceleration,
                b.acceleration,
                c.acceleration,
                d.acceleration,
            ]),
        };
        let product = stages.moved(direction, &mean);
        (stages, product)
    }
}

/// A covector of the result (θ', ω') times the Jacobian.
struct Backward<'a>(&'a [f64; 6]);

impl Product<16> for Backward<'_> {
    #[inline(always)]
    fn of<R: Registers, I: Tensor<R::Wide>>(
        &self,
        alone: &Alone<R>,
        tensor: I,
    ) -> (Stages<R::Wide, I>, [R::Wide; 16]) {
        let [a, b, c, x, y, z] = splat(alone.registers, *self.0);
        let stages = alone.stages(tensor);
        let pulled = stages.pulled_back::<16>(Some([a, b, c]), Some([x, y, z]));
        let ([a, b, c], [d, e, f], [g, h, i]) = (pulled.theta, pulled.omega, pulled.torque);
        let [j, k, l, m, n, o] = pulled.inertia;
        let span = pulled.span;
        (stages, [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, span])
    }
}

/// A direction of the input after those of θ.
struct Direction<T> {
    omega: Vector<T>,
    torque: Vector<T>,
    inertia: [T; 6],
    span: T,
    /// The length of the step itself.
    step: f64,
}

/// The change of the rates of a stage.
#[derive(Clone, Copy)]
struct Change<T> {
    turn_rate: Turn<T>,
    acceleration: Vector<T>,
}

impl<T: Arithmetic> Direction<T> {
    #[inline(always)]
    fn first<I: Tensor<T>>(&self, tensor: &I, stage: &Stage<T, I::Kept>) -> Change<T> {
        let acceleration = self.acceleration(tensor, stage, self.omega, self.torque);
        Change {
            turn_rate: turned(stage.turn, times(self.omega, self.span.constant(0.5))),
            acceleration,
        }
    }

    /// The change of the stage after `before`, which stands at a part of the step.
    #[inline(always)]
    fn after<I: Tensor<T>>(
        &self,
        tensor: &I,
        (before, change): (&Stage<T, I::Kept>, &Change<T>),
        stage: &Stage<T, I::Kept>,
        part: f64,
    ) -> Change<T> {
        let (span, longer) = (
            self.span.constant(part * self.step),
            self.span * self.span.constant(part),
        );
        let omega = plus_times(self.omega, change.acceleration, span);
        let omega = plus_times(omega, before.acceleration, longer);
        let torque = plus_times(self.torque, stage.moment.by_time, longer);
        let turn = plus_times(times(change.turn_rate, span), before.turn_rate, longer);
        let half = times(omega, span.constant(0.5));
        Change {
            turn_rate: plus(turned(turn, stage.half), turned(stage.turn, half)),
            acceleration: self.acceleration(tensor, stage, omega, torque),
        }
    }

    #[inline(always)]
    fn acceleration<I: Tensor<T>>(
        &self,
        tensor: &I,
        stage: &Stage<T, I::Kept>,
        omega: Vector<T>,
        torque: Vector<T>,
    ) -> Vector<T> {
        let by_inertia = symmetric(self.inertia, stage.omega);
        let gyroscopic = tensor.along(stage.omega, stage.kept, omega, by_inertia);
        let against = symmetric(self.inertia, stage.acceleration);
        let mut moment = minus(plus(torque, gyroscopic), against);
        if let Some(by_omega) = stage.moment.by_omega {
            moment = plus(moment, applied(by_omega, omega));
        }
        tensor.inverse(moment)
    }
}

impl<T: Arithmetic, I: Tensor<T>> Stages<T, I> {
    /// The change of the result with a direction of the input and the mean of the stages' changes.
    #[inline(always)]
    fn moved(&self, [a, b, c, p, q, r, .., span]: [T; 16], mean: &Change<T>) -> [T; 6] {
        let step = span.constant(self.step);
        let moved = plus_times(times(mean.turn_rate, step), self.mean_turn, span);
        let turned = times(between(self.end, moved), self.unit + self.unit);
        // ∂θ'/∂θ is the turn of the step backwards.
        let theta = pulled(matrix(self.end), [a, b, c]);
        let [a, b, c] = plus_times(turned, theta, self.unit);
        let gained = plus_times([p, q, r], mean.acceleration, step);
        let [x, y, z] = plus_times(gained, self.mean, span);
        [a, b, c, x, y, z]
    }
}
