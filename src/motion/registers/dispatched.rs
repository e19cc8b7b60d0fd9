//! Registers of the machine that the program runs on.

use super::{Arithmetic, Registers, Work};
use pulp::{Simd, WithSimd};
use std::ops::{Add, Div, Mul, Sub};

pub(super) struct Dispatched<W>(pub(super) W);

/// As wide as a register and a line of the cache.
#[repr(align(64))]
struct Line(#[allow(dead_code, reason = "its place alone matters")] u8);

impl<W: Work> WithSimd for Dispatched<W> {
    type Output = W::Output;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn with_simd<S: Simd>(self, simd: S) -> W::Output {
        // With something on the stack that has to stand at the start of a line, the compiler puts registers aside at such
        // places too; otherwise most of them lie across two lines, or none, as the caller's stack happens to stand.
        std::hint::black_box(&mut Line(0));
        self.0.run(Widest(simd))
    }
}

pub(super) struct Plain<F>(pub(super) F);

impl<T, F: FnOnce() -> T> WithSimd for Plain<F> {
    type Output = T;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn with_simd<S: Simd>(self, _: S) -> T {
        (self.0)()
    }
}

pub(super) struct OneAtATime<W>(pub(super) W);

impl<W: Work> WithSimd for OneAtATime<W> {
    type Output = W::Output;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn with_simd<S: Simd>(self, _: S) -> W::Output {
        // Four doubles and more come with fused products.
        if S::F64_LANES >= 4 {
            self.0.run(Single::<true>)
        } else {
            self.0.run(Single::<false>)
        }
    }
}

/// Registers of one double.
#[derive(Clone, Copy)]
struct Single<const FUSED: bool>;

#[derive(Clone, Copy)]
struct One<const FUSED: bool>(f64);

impl<const FUSED: bool> Registers for Single<FUSED> {
    type Wide = One<FUSED>;
    const LANES: usize = 1;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn splat(self, value: f64) -> One<FUSED> {
        One(value)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn load(self, values: &[f64]) -> One<FUSED> {
        One(values.first().copied().unwrap_or_default())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn store(self, wide: One<FUSED>, values: &mut [f64]) {
        if let Some(first) = values.first_mut() {
            *first = wide.0;
        }
    }
}

impl<const FUSED: bool> Arithmetic for One<FUSED> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn plus_product(self, a: Self, b: Self) -> Self {
        Self(match FUSED {
            true => a.0.mul_add(b.0, self.0),
            false => self.0 + a.0 * b.0,
        })
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn less_product(self, a: Self, b: Self) -> Self {
        Self(match FUSED {
            true => (-a.0).mul_add(b.0, self.0),
            false => self.0 - a.0 * b.0,
        })
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn constant(self, value: f64) -> Self {
        Self(value)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn root(self) -> Self {
        Self(self.0.sqrt())
    }
}

/// The registers of the machine at hand.
#[derive(Clone, Copy)]
struct Widest<S>(S);

/// A register full of doubles.
#[derive(Clone, Copy)]
struct Wide<S: Simd>(S, S::f64s);

impl<S: Simd> Registers for Widest<S> {
    type Wide = Wide<S>;
    const LANES: usize = S::F64_LANES;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn splat(self, value: f64) -> Wide<S> {
        Wide(self.0, self.0.splat_f64s(value))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn load(self, values: &[f64]) -> Wide<S> {
        match S::as_simd_f64s(values).0.first() {
            Some(wide) => Wide(self.0, *wide),
            None => self.splat(0.0),
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn store(self, wide: Wide<S>, values: &mut [f64]) {
        if let Some(first) = S::as_mut_simd_f64s(values).0.first_mut() {
            *first = wide.1;
        }
    }
}

impl<S: Simd> Arithmetic for Wide<S> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn plus_product(self, a: Self, b: Self) -> Self {
        Self(self.0, self.0.mul_add_e_f64s(a.1, b.1, self.1))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn less_product(self, a: Self, b: Self) -> Self {
        Self(self.0, self.0.negate_mul_add_e_f64s(a.1, b.1, self.1))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn constant(self, value: f64) -> Self {
        Self(self.0, self.0.splat_f64s(value))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn root(self) -> Self {
        Self(self.0, self.0.sqrt_f64s(self.1))
    }
}

macro_rules! lane_by_lane {
    ($($operator:ident $method:ident $lanes:ident;)*) => {$(
        impl<S: Simd> $operator for Wide<S> {
            type Output = Self;
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn $method(self, other: Self) -> Self {
                Self(self.0, self.0.$lanes(self.1, other.1))
            }
        }

        impl<const FUSED: bool> $operator for One<FUSED> {
            type Output = Self;
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }
    )*};
}

lane_by_lane! {
    Add add add_f64s;
    Sub sub sub_f64s;
    Mul mul mul_f64s;
    Div div div_f64s;
}
