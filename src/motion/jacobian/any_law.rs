//! The Jacobian of the classical Runge–Kutta step under a law of any kind, backwards through its four stages.
//!
//! Only the law runs on dual numbers, in the eight numbers that it sees: attitude, angular velocity and time. All else is
//! known: with M the torque, q̇ = ½ q ω and I ω̇ = M − ω × Iω give at each stage
//!
//! I δω̇ = M_q δq + M_ω δω + M_t δt + Iω × δω − ω × I δω − Y(ω, ω̇) δI,
//!
//! Y the regressor: the inverse is never differentiated. Covectors of the end are taken back through this, side by side.

use crate::mechanics::regressor;
use crate::motion::registers::at_its_best;
use crate::motion::torque::in_body;
use crate::motion::{Frame, Number, Quaternion, Rates, State, StepJacobian, System, TorqueLaw};
use nalgebra::{Matrix3, SMatrix, SVector, Vector3, Vector6};
use num_dual::DualSVec64;

/// One number for each of `R` covectors.
type Side<const R: usize> = [f64; R];

/// Covectors of attitude (w, x, y, z) and angular velocity.
type Covectors<const R: usize> = [Side<R>; 7];

/// The rows of a Jacobian and two that fill up registers.
const ROWS: usize = 8;

/// The step and its Jacobian.
pub(crate) fn step_with_jacobian<const N: usize, L>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
) -> StepJacobian<N>
where
    L: Copy + TorqueLaw<f64> + TorqueLaw<DualSVec64<N>>,
    DualSVec64<N>: Number,
{
    at_its_best(
        #[inline(always)]
        || {
            let (state, columns) =
                pulled::<N, ROWS, L>(
                    system,
                    time,
                    state,
                    step,
                    |r, k| {
                        if r == k { 1.0 } else { 0.0 }
                    },
                );
            let matrix = SMatrix::from_fn(|r, c| columns[c][r]);
            StepJacobian { state, matrix }
        },
    )
}

/// The step and a covector of (θ', ω') times its Jacobian.
pub(crate) fn vjp<const N: usize, L>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
    covector: &Vector6<f64>,
) -> (State<f64>, SVector<f64, N>)
where
    L: Copy + TorqueLaw<f64> + TorqueLaw<DualSVec64<N>>,
    DualSVec64<N>: Number,
{
    at_its_best(
        #[inline(always)]
        || {
            let seed = |_: usize, k: usize| covector[k];
            let (state, columns) = pulled::<N, 1, L>(system, time, state, step, seed);
            (state, SVector::from_fn(|c, _| columns[c][0]))
        },
    )
}

/// The state after the step, and `R` covectors of it, component `k` of which is `seed(r, k)`, taken back to the first `N` inputs.
#[inline(always)]
fn pulled<const N: usize, const R: usize, L>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
    seed: impl Fn(usize, usize) -> f64,
) -> (State<f64>, [Side<R>; N])
where
    L: Copy + TorqueLaw<f64> + TorqueLaw<DualSVec64<N>>,
    DualSVec64<N>: Number,
{
    let stage = |at: f64, state: State<f64>| Stage::new::<N, L>(system, time + at * step, state);
    let first = stage(0.0, *state);
    let second = stage(0.5, state.along(&first.rates, 0.5 * step));
    let third = stage(0.5, state.along(&second.rates, 0.5 * step));
    let fourth = stage(1.0, state.along(&third.rates, step));
    let inner = second.rates.plus(&third.rates, 1.0);
    let sum = first.rates.plus(&inner, 2.0).plus(&fourth.rates, 1.0);
    let end = state.along(&sum, step / 6.0);
    let length = end.attitude.norm_squared().sqrt();
    let end = State {
        attitude: end.attitude * (1.0 / length),
        ..end
    };
    let last = seeded::<R>(&end.attitude, 2.0 / length, seed);
    let mut found = Found::<R>::default();
    // Backwards: what reaches the state of a stage reaches the slope before it.
    plus_along(&mut found.length, &sum, &last, 1.0 / 6.0);
    let mut whole = last;
    let mut reached = fourth.back(&scaled(&last, step / 6.0), 1.0, &mut found);
    for (stage, at, (part, weight)) in [
        (&third, 0.5, (1.0, 3.0)),
        (&second, 0.5, (0.5, 3.0)),
        (&first, 0.0, (0.5, 6.0)),
    ] {
        plus(&mut whole, &reached, 1.0);
        plus_along(&mut found.length, &stage.rates, &reached, part);
        let mut slope = scaled(&last, step / weight);
        plus(&mut slope, &reached, part * step);
        reached = stage.back(&slope, at, &mut found);
    }
    plus(&mut whole, &reached, 1.0);
    (end, columns::<N, R>(&state.attitude, &whole, &found))
}

/// Covectors of torque, inertia and length.
struct Found<const R: usize> {
    torque: [Side<R>; 3],
    inertia: [Side<R>; 6],
    length: Side<R>,
}

impl<const R: usize> Default for Found<R> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            torque: [[0.0; R]; 3],
            inertia: [[0.0; R]; 6],
            length: [0.0; R],
        }
    }
}

/// A stage of a step: its slope and the matrices of its equation of variation.
struct Stage {
    rates: Rates<f64>,
    state: State<f64>,
    inverse: Matrix3<f64>,
    /// What the torque and ω × Iω give for ω, the torque for attitude, time and the added torque.
    by_omega: Matrix3<f64>,
    by_attitude: SMatrix<f64, 3, 4>,
    by_time: Vector3<f64>,
    by_added: Matrix3<f64>,
    by_inertia: SMatrix<f64, 3, 6>,
}

impl Stage {
    #[inline(always)]
    fn new<const N: usize, L>(system: &System<f64, L>, time: f64, state: State<f64>) -> Self
    where
        L: Copy + TorqueLaw<f64> + TorqueLaw<DualSVec64<N>>,
        DualSVec64<N>: Number,
    {
        let rates = system.rates(time, &state);
        let omega = &state.angular_velocity;
        let frame = TorqueLaw::<f64>::added_in(system.law());
        let derivatives = of_torque::<N, L>(system, time, &state);
        let inertia = system.inertia();
        let gyroscopic = (inertia * omega).cross_matrix() - omega.cross_matrix() * inertia;
        let seen = |axis: Vector3<f64>| in_body(frame, &state.attitude, axis);
        Self {
            inverse: *system.inverse(),
            by_omega: derivatives.fixed_columns::<3>(4) + gyroscopic,
            by_attitude: derivatives.fixed_columns::<4>(0).into_owned(),
            by_time: derivatives.fixed_columns::<1>(7).into_owned(),
            by_added: Matrix3::from_columns(&[Vector3::x(), Vector3::y(), Vector3::z()].map(seen)),
            by_inertia: regressor(omega, &rates.angular_acceleration),
            rates,
            state,
        }
    }

    /// Covectors of the slope taken back to the state of the stage, and to what all stages share; the time of the stage is
    /// the start and `at` times the length.
    #[inline(always)]
    fn back<const R: usize>(
        &self,
        slope: &Covectors<R>,
        at: f64,
        found: &mut Found<R>,
    ) -> Covectors<R> {
        let [w, x, y, z] = self.state.attitude.components().map(|c| 0.5 * c);
        let [a, b, c]: [f64; 3] = (self.state.angular_velocity * 0.5).into();
        let mut moment = [[0.0; R]; 3];
        for (row, moment) in moment.iter_mut().enumerate() {
            for k in 0..3 {
                add(moment, &slope[4 + k], self.inverse[(k, row)]);
            }
        }
        let mut state = [[0.0; R]; 7];
        // ½ q ω, transposed in q and in ω.
        let products = [
            [0.0, a, b, c],
            [-a, 0.0, -c, b],
            [-b, c, 0.0, -a],
            [-c, -b, a, 0.0],
        ];
        for (row, factors) in products.iter().enumerate() {
            for (k, factor) in factors.iter().enumerate().filter(|(k, _)| *k != row) {
                add(&mut state[row], &slope[k], *factor);
            }
            for (k, moment) in moment.iter().enumerate() {
                add(&mut state[row], moment, self.by_attitude[(k, row)]);
            }
        }
        let products = [[-x, w, z, -y], [-y, -z, w, x], [-z, y, -x, w]];
        for (row, factors) in products.iter().enumerate() {
            for (k, factor) in factors.iter().enumerate() {
                add(&mut state[4 + row], &slope[k], *factor);
            }
            for (k, moment) in moment.iter().enumerate() {
                add(&mut state[4 + row], moment, self.by_omega[(k, row)]);
                add(&mut found.torque[row], moment, self.by_added[(k, row)]);
            }
        }
        for (k, moment) in moment.iter().enumerate() {
            for (column, inertia) in found.inertia.iter_mut().enumerate() {
                add(inertia, moment, -self.by_inertia[(k, column)]);
            }
            add(&mut found.length, moment, at * self.by_time[k]);
        }
        state
    }
}

/// The derivatives of a law's torque in (w, x, y, z), ω and time, as many at once as the dual number carries.
#[inline(always)]
fn of_torque<const N: usize, L>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
) -> SMatrix<f64, 3, 8>
where
    L: Copy + TorqueLaw<f64> + TorqueLaw<DualSVec64<N>>,
    DualSVec64<N>: Number,
{
    let mut found = SMatrix::<f64, 3, 8>::zeros();
    let frame = TorqueLaw::<f64>::added_in(system.law());
    for first in (0..8).step_by(N.max(1)) {
        let seed = |value: f64, place: usize| {
            let number = DualSVec64::<N>::from_re(value);
            let direction = place.checked_sub(first).filter(|k| *k < N);
            direction.map_or(number, |k| number.derivative(k))
        };
        let attitude = state.attitude.components();
        let omega = &state.angular_velocity;
        let seeded = State {
            attitude: Quaternion::new(std::array::from_fn(|i| seed(attitude[i], i))),
            angular_velocity: Vector3::from_fn(|i, _| seed(omega[i], 4 + i)),
        };
        let mut torque = system.law().torque(seed(time, 7), &seeded);
        // An added torque depends on the attitude where it stands in space; none at all is the most frequent one.
        if frame == Frame::Space && *system.added() != Vector3::zeros() {
            let added = system.added().map(DualSVec64::<N>::from_re);
            torque += in_body(frame, &seeded.attitude, added);
        }
        for row in 0..3 {
            let Some(slopes) = torque[row].eps.0.as_ref() else {
                continue;
            };
            for k in 0..N.min(8 - first) {
                found[(row, first + k)] = slopes[k];
            }
        }
    }
    found
}

/// Covectors of (θ', ω') as those of the quaternion before it is made unit, and of ω'.
#[inline(always)]
fn seeded<const R: usize>(
    attitude: &Quaternion<f64>,
    factor: f64,
    seed: impl Fn(usize, usize) -> f64,
) -> Covectors<R> {
    let mut covectors = [[0.0; R]; 7];
    let turns = turns(attitude, factor);
    for k in 0..3 {
        let side: Side<R> = std::array::from_fn(|r| seed(r, k));
        for (covector, turn) in covectors.iter_mut().zip(&turns) {
            add(covector, &side, turn[k]);
        }
        covectors[4 + k] = std::array::from_fn(|r| seed(r, 3 + k));
    }
    covectors
}

/// The matrix of v ↦ q (0, v) times a factor.
#[inline(always)]
fn turns(attitude: &Quaternion<f64>, factor: f64) -> [[f64; 3]; 4] {
    let [w, x, y, z] = attitude.components().map(|c| c * factor);
    [[-x, -y, -z], [w, -z, y], [z, w, -x], [-y, x, w]]
}

/// The columns of the inputs: a turn of the start moves its quaternion by ½ q θ.
#[inline(always)]
fn columns<const N: usize, const R: usize>(
    attitude: &Quaternion<f64>,
    state: &Covectors<R>,
    found: &Found<R>,
) -> [Side<R>; N] {
    let turns = turns(attitude, 0.5);
    let mut theta = [[0.0; R]; 3];
    for (component, turn) in turns.iter().enumerate() {
        for k in 0..3 {
            add(&mut theta[k], &state[component], turn[k]);
        }
    }
    std::array::from_fn(|column| match column {
        0..3 => theta[column],
        3..6 => state[1 + column],
        6..9 => found.torque[column - 6],
        9..15 => found.inertia[column - 9],
        15 => found.length,
        _ => [0.0; R],
    })
}

#[inline(always)]
fn add<const R: usize>(onto: &mut Side<R>, values: &Side<R>, factor: f64) {
    for r in 0..R {
        onto[r] += factor * values[r];
    }
}

#[inline(always)]
fn plus<const R: usize>(onto: &mut Covectors<R>, other: &Covectors<R>, factor: f64) {
    for (onto, other) in onto.iter_mut().zip(other) {
        add(onto, other, factor);
    }
}

#[inline(always)]
fn scaled<const R: usize>(covectors: &Covectors<R>, factor: f64) -> Covectors<R> {
    covectors.map(|side| side.map(|value| value * factor))
}

/// Covectors times a rate of the state.
#[inline(always)]
fn plus_along<const R: usize>(
    onto: &mut Side<R>,
    rates: &Rates<f64>,
    covectors: &Covectors<R>,
    factor: f64,
) {
    let [w, x, y, z] = rates.attitude.components();
    let [a, b, c]: [f64; 3] = rates.angular_acceleration.into();
    for (rate, covector) in [w, x, y, z, a, b, c].iter().zip(covectors) {
        add(onto, covector, rate * factor);
    }
}
