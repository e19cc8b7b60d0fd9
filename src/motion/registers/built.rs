//! Registers of the machine that the crate is built for.

use super::{Arithmetic, Registers};
use std::ops::{Add, Div, Mul, Sub};

/// How many doubles a register holds of the machine that the crate is built for.
pub(super) const WIDEST: usize = if cfg!(target_feature = "avx512f") {
    8
} else if cfg!(target_feature = "avx") {
    4
} else {
    2
};

/// Arrays that compilers lay into registers.
#[derive(Clone, Copy)]
pub(super) struct Built<const N: usize>;

#[derive(Clone, Copy)]
pub(super) struct Pack<const N: usize>([f64; N]);

impl<const N: usize> Registers for Built<N> {
    type Wide = Pack<N>;
    const LANES: usize = N;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn splat(self, value: f64) -> Pack<N> {
        Pack([value; N])
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn load(self, values: &[f64]) -> Pack<N> {
        Pack(values.first_chunk().copied().unwrap_or([0.0; N]))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn store(self, wide: Pack<N>, values: &mut [f64]) {
        if let Some(room) = values.first_chunk_mut() {
            *room = wide.0;
        }
    }
}

/// sum + a b, in one rounding where the machine has it.
#[cfg_attr(not(debug_assertions), inline(always))]
fn fused(sum: f64, a: f64, b: f64) -> f64 {
    if cfg!(any(target_feature = "fma", target_arch = "aarch64")) {
        a.mul_add(b, sum)
    } else {
        sum + a * b
    }
}

impl<const N: usize> Arithmetic for Pack<N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn plus_product(mut self, a: Self, b: Self) -> Self {
        for i in 0..N {
            self.0[i] = fused(self.0[i], a.0[i], b.0[i]);
        }
        self
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn less_product(mut self, a: Self, b: Self) -> Self {
        for i in 0..N {
            self.0[i] = fused(self.0[i], -a.0[i], b.0[i]);
        }
        self
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn constant(self, value: f64) -> Self {
        Self([value; N])
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn root(mut self) -> Self {
        for lane in &mut self.0 {
            *lane = lane.sqrt();
        }
        self
    }
}

macro_rules! lane_by_lane {
    ($($operator:ident $method:ident;)*) => {$(
        impl<const N: usize> $operator for Pack<N> {
            type Output = Self;
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn $method(mut self, other: Self) -> Self {
                for i in 0..N {
                    self.0[i] = self.0[i].$method(other.0[i]);
                }
                self
            }
        }
    )*};
}

lane_by_lane! {
    Add add;
    Sub sub;
    Mul mul;
    Div div;
}
