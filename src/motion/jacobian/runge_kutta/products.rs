//! Products of the Jacobian with one vector, from either side, without the matrix.

use super::algebra::{
    Full, Principal, Tensor, Turn, Vector, applied, between, matrix, minus, plus, plus_times,
    pulled, splat, symmetric, times, turned,
};
use super::alone::{Alone, full, principal};
use super::momentum;
use super::stages::{PARTS, Stage, Stages, mean};
use crate::motion::registers::{Arithmetic, Registers, Work, one_at_a_time};
use crate::motion::{State, System, TorqueLaw};
use nalgebra::{SVector, Vector6};

/// The step and its Jacobian times a direction of its first `N` inputs, or `None` if the law gives a torque that depends on
/// the attitude.
#[inline(always)]
pub(crate) fn jvp<const N: usize, L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
    direction: &SVector<f64, N>,
) -> Option<(State<f64>, Vector6<f64>)> {
    let forward = Forward(&direction.data.0[0]);
    let one = One::<6, _, _>::new(system, (time, state, step), forward);
    let (state, along) = one_at_a_time(one)?;
    Some((state, along.into()))
}

/// The step and a covector of its result times the first `N` columns of the Jacobian, or `None` if the law gives a torque
/// that depends on the attitude.
#[inline(always)]
pub(crate) fn vjp<const N: usize, L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
    covector: &Vector6<f64>,
) -> Option<(State<f64>, SVector<f64, N>)> {
    let backward = Backward(&covector.data.0[0]);
    let one = One::<N, _, _>::new(system, (time, state, step), backward);
    let (state, back) = one_at_a_time(one)?;
    Some((state, back.into()))
}

/// A product with the Jacobian, of `M` components.
trait Product<const M: usize> {
    /// The state after the step, and the product, for a body of any axes.
    fn of_full<R: Registers>(
        &self,
        alone: &Alone<R>,
        tensor: Full<R::Wide>,
    ) -> (State<f64>, [R::Wide; M]);

    /// The same for one along its principal axes.
    fn of_principal<R: Registers>(
        &self,
        alone: &Alone<R>,
        tensor: Principal<R::Wide>,
    ) -> (State<f64>, [R::Wide; M]);
}

/// One body and a product.
struct One<'a, const M: usize, L, P> {
    system: &'a System<f64, L>,
    step: (f64, &'a State<f64>, f64),
    product: P,
}

impl<'a, const M: usize, L: TorqueLaw<f64>, P: Product<M>> One<'a, M, L, P> {
    #[inline(always)]
    fn new(system: &'a System<f64, L>, step: (f64, &'a State<f64>, f64), product: P) -> Self {
        Self {
            system,
            step,
            product,
        }
    }
}

impl<const M: usize, L: TorqueLaw<f64>, P: Product<M>> Work for One<'_, M, L, P> {
    type Output = Option<(State<f64>, [f64; M])>;

    #[inline(always)]
    fn run<R: Registers>(self, registers: R) -> Self::Output {
        let (system, (time, state, step)) = (self.system, self.step);
        let alone = Alone::new(registers, system, time, state, step)?;
        let (state, product) = if system.is_principal() {
            let tensor = principal(system).splat(registers);
            self.product.of_principal(&alone, tensor)
        } else {
            let tensor = full(system).splat(registers);
            self.product.of_full(&alone, tensor)
        };
        Some((state, alone.firsts(product)))
    }
}

/// The Jacobian times a direction of the first `N` of the input (θ, ω, torque, inertia, dt).
struct Forward<'a, const N: usize>(&'a [f64; N]);

impl<const N: usize> Forward<'_, N> {
    #[inline(always)]
    fn direction<R: Registers>(&self, registers: R) -> momentum::Direction<R::Wide> {
        let mut all = [registers.splat(0.0); 16];
        for (place, value) in all.iter_mut().zip(self.0) {
            *place = registers.splat(*value);
        }
        let [a, b, c, d, e, f, g, h, i, inertia @ .., span] = all;
        momentum::Direction {
            theta: [a, b, c],
            omega: [d, e, f],
            torque: [g, h, i],
            inertia,
            span,
        }
    }
}

impl<const N: usize> Product<6> for Forward<'_, N> {
    #[inline(always)]
    fn of_full<R: Registers>(
        &self,
        alone: &Alone<R>,
        tensor: Full<R::Wide>,
    ) -> (State<f64>, [R::Wide; 6]) {
        let step = momentum::Step::new(tensor, alone.omega, alone.step, &alone.moments);
        let along = step.along::<N>(&self.direction(alone.registers));
        (alone.state(step.state(alone.attitude, alone.omega)), along)
    }

    #[inline(always)]
    fn of_principal<R: Registers>(
        &self,
        alone: &Alone<R>,
        tensor: Principal<R::Wide>,
    ) -> (State<f64>, [R::Wide; 6]) {
        let given = self.direction(alone.registers);
        let along = Direction {
            omega: given.omega,
            torque: given.torque,
            inertia: given.inertia,
            span: given.span,
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
        let product = stages.moved((given.theta, given.omega, given.span), &mean);
        (alone.end(&stages), product)
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

impl<const N: usize> Product<N> for Backward<'_> {
    #[inline(always)]
    fn of_full<R: Registers>(
        &self,
        alone: &Alone<R>,
        tensor: Full<R::Wide>,
    ) -> (State<f64>, [R::Wide; N]) {
        let [a, b, c, x, y, z] = splat(alone.registers, *self.0);
        let step = momentum::Step::new(tensor, alone.omega, alone.step, &alone.moments);
        let pulled = step.back::<N>([a, b, c], [x, y, z]);
        (
            alone.state(step.state(alone.attitude, alone.omega)),
            firsts(pulled.flat()),
        )
    }

    #[inline(always)]
    fn of_principal<R: Registers>(
        &self,
        alone: &Alone<R>,
        tensor: Principal<R::Wide>,
    ) -> (State<f64>, [R::Wide; N]) {
        let [a, b, c, x, y, z] = splat(alone.registers, *self.0);
        let stages = alone.stages(tensor);
        let pulled = stages.pulled_back::<N>(Some([a, b, c]), Some([x, y, z]));
        (alone.end(&stages), firsts(pulled.flat()))
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
    fn moved(&self, (theta, omega, span): (Vector<T>, Vector<T>, T), mean: &Change<T>) -> [T; 6] {
        let step = span.constant(self.step);
        let moved = plus_times(times(mean.turn_rate, step), self.mean_turn, span);
        let turned = times(between(self.end, moved), self.unit + self.unit);
        // ∂θ'/∂θ is the turn of the step backwards.
        let theta = pulled(matrix(self.end), theta);
        let [a, b, c] = plus_times(turned, theta, self.unit);
        let gained = plus_times(omega, mean.acceleration, step);
        let [x, y, z] = plus_times(gained, self.mean, span);
        [a, b, c, x, y, z]
    }
}
