//! Numbers side by side in the widest registers that the machine has.

#[cfg(not(feature = "batch"))]
mod built;
#[cfg(feature = "batch")]
mod dispatched;

use crate::motion::block::LANES;
use std::ops::{Add, Div, Mul, Sub};

/// Plain arithmetic: of one double, or of as many as a register holds. Each operator rounds once; a product is fused with
/// a sum only where a method says so, and then in every lane of the machine at hand.
pub(crate) trait Arithmetic:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// self + a b, in one rounding where the machine has it.
    fn plus_product(self, a: Self, b: Self) -> Self;

    /// self − a b, in one rounding where the machine has it.
    fn less_product(self, a: Self, b: Self) -> Self;

    /// A constant beside this number.
    fn constant(self, value: f64) -> Self;

    /// The square root.
    fn root(self) -> Self;
}

impl Arithmetic for f64 {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn plus_product(self, a: Self, b: Self) -> Self {
        self + a * b
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn less_product(self, a: Self, b: Self) -> Self {
        self - a * b
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn constant(self, value: f64) -> Self {
        value
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn root(self) -> Self {
        self.sqrt()
    }
}

/// The registers of a machine.
pub(crate) trait Registers: Copy {
    /// What a register holds.
    type Wide: Arithmetic;

    /// How many doubles that is.
    const LANES: usize;

    /// One value in every lane.
    fn splat(self, value: f64) -> Self::Wide;

    /// The first [`LANES`](Self::LANES) of the values, of which there are as many or more.
    fn load(self, values: &[f64]) -> Self::Wide;

    /// Writes the lanes over the first of `values`, of which there are as many or more.
    fn store(self, wide: Self::Wide, values: &mut [f64]);

    /// What stands in the first lane.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn first(self, wide: Self::Wide) -> f64 {
        let mut lanes = [0.0; LANES];
        self.store(wide, &mut lanes);
        lanes[0]
    }
}

/// Something to be done in registers of any width.
pub(crate) trait Work {
    /// What comes of it.
    type Output;

    /// Does it. To be inlined: what is called is compiled for the least of machines.
    fn run<R: Registers>(self, registers: R) -> Self::Output;
}

/// Does the work in the widest registers that the machine has.
#[cfg(feature = "batch")]
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn in_widest<W: Work>(work: W) -> W::Output {
    pulp::Arch::new().dispatch(dispatched::Dispatched(work))
}

/// Does the work, a double at a time, with all that the machine knows to do.
#[cfg(feature = "batch")]
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn one_at_a_time<W: Work>(work: W) -> W::Output {
    pulp::Arch::new().dispatch(dispatched::OneAtATime(work))
}

/// Calls `work` compiled for all that the machine knows to do, to the bit what it gives elsewhere. To be inlined, as what it
/// calls.
#[cfg(feature = "batch")]
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn at_its_best<T>(work: impl FnOnce() -> T) -> T {
    pulp::Arch::new().dispatch(dispatched::Plain(work))
}

/// Calls `work`.
#[cfg(not(feature = "batch"))]
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn at_its_best<T>(work: impl FnOnce() -> T) -> T {
    work()
}

/// Does the work, a double at a time.
#[cfg(not(feature = "batch"))]
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn one_at_a_time<W: Work>(work: W) -> W::Output {
    work.run(built::Built::<1>)
}

/// Does the work in the widest registers of the machine that the crate is built for.
#[cfg(not(feature = "batch"))]
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn in_widest<W: Work>(work: W) -> W::Output {
    work.run(built::Built::<{ built::WIDEST }>)
}
