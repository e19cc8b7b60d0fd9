//! The step of eight bodies side by side in registers, to the bit that of each alone.

use crate::motion::block::{Block, LANES, Lane, Tensors};
use crate::motion::registers::{Arithmetic, Registers, Work, in_widest};
use crate::motion::system::inverse_entries;
use crate::motion::{LinearTorque, TorqueLaw};

/// Eight steps, or `false` if the law gives a torque that depends on the attitude. Never inlined: the callers are many, one
/// for each kind of law, tensor and machine, and this is as large as all of them.
#[inline(never)]
pub(super) fn block_step<L: TorqueLaw<f64>>(
    law: &L,
    tensors: &Tensors<'_>,
    time: f64,
    block: &mut Block,
    step: f64,
) -> bool {
    in_widest(Eight {
        law,
        tensors,
        time,
        step,
        block,
    })
}

struct Eight<'a, L> {
    law: &'a L,
    tensors: &'a Tensors<'a>,
    time: f64,
    step: f64,
    block: &'a mut Block,
}

impl<L: TorqueLaw<f64>> Work for Eight<'_, L> {
    type Output = bool;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<R: Registers>(self, registers: R) -> bool {
        let (law, time, step) = (self.law, self.time, self.step);
        let Some([a, b, c]) = law.linear_at([time, time + step * 0.5, time + step]) else {
            return false;
        };
        if ![&a, &b, &c].into_iter().all(LinearTorque::looks_away) {
            return false;
        }
        let moments = [
            Moment::of(registers, &a),
            Moment::of(registers, &b),
            Moment::of(registers, &c),
        ];
        for first in (0..LANES).step_by(R::LANES) {
            let lanes = Lanes {
                registers,
                first,
                step,
                moments: &moments,
            };
            lanes.of(self.tensors, self.block);
        }
        true
    }
}

/// A torque that is linear in ω, the same for all bodies.
#[derive(Clone, Copy)]
struct Moment<T> {
    at_rest: [T; 3],
    by_omega: Option<[[T; 3]; 3]>,
}

impl<T: Arithmetic> Moment<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of<R: Registers<Wide = T>>(registers: R, torque: &LinearTorque) -> Self {
        let [x, y, z] = torque.at_rest.into();
        let mut by_omega = None;
        if let Some(m) = torque.by_angular_velocity {
            let zero = registers.splat(0.0);
            let mut rows = [[zero; 3]; 3];
            for r in 0..3 {
                for c in 0..3 {
                    rows[r][c] = registers.splat(m[(r, c)]);
                }
            }
            by_omega = Some(rows);
        }
        Self {
            at_rest: [registers.splat(x), registers.splat(y), registers.splat(z)],
            by_omega,
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn at(&self, [x, y, z]: [T; 3]) -> [T; 3] {
        let mut torque = self.at_rest;
        if let Some(rows) = self.by_omega {
            for i in 0..3 {
                let [a, b, c] = rows[i];
                torque[i] = torque[i] + (a * x + b * y + c * z);
            }
        }
        torque
    }
}

/// Tensors of bodies side by side.
trait Inertia<T> {
    /// ω̇ = I⁻¹ (M − ω × I ω), the operations in the order of
    /// [`System::rates`](crate::motion::System::rates).
    fn acceleration(&self, torque: [T; 3], omega: [T; 3]) -> [T; 3];
}

/// xx, yy, zz, xy, xz, yz.
struct Full<T> {
    entries: [T; 6],
    inverse: [T; 6],
}

struct Principal<T> {
    /// I_y − I_z and cyclic.
    differences: [T; 3],
    inverse: [T; 3],
}

impl<T: Arithmetic> Principal<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn new([x, y, z]: [T; 3], inverse: [T; 3]) -> Self {
        Self {
            differences: [y - z, z - x, x - y],
            inverse,
        }
    }
}

impl<T: Arithmetic> Inertia<T> for Full<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn acceleration(&self, [a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> [T; 3] {
        let [l, m, n] = times(self.entries, [x, y, z]);
        let net = [
            a - (y * n - z * m),
            b - (z * l - x * n),
            c - (x * m - y * l),
        ];
        times(self.inverse, net)
    }
}

impl<T: Arithmetic> Inertia<T> for Principal<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn acceleration(&self, [a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> [T; 3] {
        let ([d, e, f], [p, q, r]) = (self.differences, self.inverse);
        [
            (a + d * (y * z)) * p,
            (b + e * (z * x)) * q,
            (c + f * (x * y)) * r,
        ]
    }
}

/// A symmetric matrix times a vector.
#[cfg_attr(not(debug_assertions), inline(always))]
fn times<T: Arithmetic>([xx, yy, zz, xy, xz, yz]: [T; 6], [x, y, z]: [T; 3]) -> [T; 3] {
    [
        xx * x + xy * y + xz * z,
        xy * x + yy * y + yz * z,
        xz * x + yz * y + zz * z,
    ]
}

/// As many bodies of a block as a register holds, from `first` on.
struct Lanes<'a, R: Registers> {
    registers: R,
    first: usize,
    step: f64,
    moments: &'a [Moment<R::Wide>; 3],
}

impl<R: Registers> Lanes<'_, R> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn splat<const N: usize>(&self, values: [f64; N]) -> [R::Wide; N] {
        let mut wide = [self.registers.splat(0.0); N];
        for i in 0..N {
            wide[i] = self.registers.splat(values[i]);
        }
        wide
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn loaded<const N: usize>(&self, lanes: &[Lane; N]) -> [R::Wide; N] {
        let mut wide = [self.registers.splat(0.0); N];
        for i in 0..N {
            wide[i] = self.registers.load(&lanes[i][self.first..]);
        }
        wide
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of(&self, tensors: &Tensors<'_>, block: &mut Block) {
        match tensors {
            Tensors::Principal { moments, inverse } => self.advance(
                block,
                &Principal::new(self.splat(*moments), self.splat(*inverse)),
            ),
            Tensors::Shared { entries, inverse } => self.advance(
                block,
                &Full {
                    entries: self.splat(*entries),
                    inverse: self.splat(*inverse),
                },
            ),
            Tensors::OwnPrincipal(own) => {
                let entries = self.loaded(own);
                let [a, b, c, ..] = inverse_entries(entries, self.registers.splat(1.0));
                let [x, y, z, ..] = entries;
                self.advance(block, &Principal::new([x, y, z], [a, b, c]));
            }
            Tensors::Own(own) => {
                let entries = self.loaded(own);
                let inverse = inverse_entries(entries, self.registers.splat(1.0));
                self.advance(block, &Full { entries, inverse });
            }
        }
    }

    /// The step, the operations in the order of the generic one.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn advance(&self, block: &mut Block, tensor: &impl Inertia<R::Wide>) {
        let start = self.loaded(block.lanes());
        let [at_start, midway, at_end] = self.moments;
        let [half, whole, sixth, one, two] = self.splat([
            self.step * 0.5,
            self.step,
            self.step * (1.0 / 6.0),
            1.0,
            2.0,
        ]);
        let first = rates(tensor, at_start, start);
        let second = rates(tensor, midway, along(start, first, half));
        let third = rates(tensor, midway, along(start, second, half));
        let fourth = rates(tensor, at_end, along(start, third, whole));
        let mut sum = first;
        for i in 0..7 {
            sum[i] = sum[i] + (second[i] + third[i]) * two + fourth[i];
        }
        let mut end = along(start, sum, sixth);
        let [w, x, y, z, ..] = end;
        let size = one / (w * w + x * x + y * y + z * z).root();
        for component in &mut end[..4] {
            *component = *component * size;
        }
        for (lane, value) in block.lanes_mut().iter_mut().zip(end) {
            self.registers.store(value, &mut lane[self.first..]);
        }
    }
}

/// w, x, y, z and ω a span further.
#[cfg_attr(not(debug_assertions), inline(always))]
fn along<T: Arithmetic>(mut state: [T; 7], rates: [T; 7], span: T) -> [T; 7] {
    for i in 0..7 {
        state[i] = state[i] + rates[i] * span;
    }
    state
}

/// q̇ = ½ q ω and ω̇.
#[cfg_attr(not(debug_assertions), inline(always))]
fn rates<T: Arithmetic>(
    tensor: &impl Inertia<T>,
    moment: &Moment<T>,
    [w, x, y, z, p, q, r]: [T; 7],
) -> [T; 7] {
    let (half, zero) = (w.constant(0.5), w.constant(0.0));
    let [a, b, c] = [p * half, q * half, r * half];
    let [d, e, f] = tensor.acceleration(moment.at([p, q, r]), [p, q, r]);
    [
        zero - (x * a + y * b + z * c),
        w * a + y * c - z * b,
        w * b - x * c + z * a,
        w * c + x * b - y * a,
        d,
        e,
        f,
    ]
}
