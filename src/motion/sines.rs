//! Sines and cosines of several angles side by side, where the call of a function for each would take as long as the step.

use std::f64::consts::FRAC_1_PI;

/// Angles below this are reduced here, rad; those above by the function of the machine.
const LARGE: f64 = 1e6;

/// 3·2⁵¹: a number that is added to it is rounded to an integer, of which the last bit says whether it is odd.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// π in two parts: the products of the first with the integers met here are exact.
const PI: [f64; 2] = [3.141_592_653_468_251_2, 1.215_420_101_301_238_4e-10];

/// (sin r − r)/r³ in powers of r².
const SERIES: [f64; 10] = [
    -1.0 / 6.0,
    1.0 / 120.0,
    -1.0 / 5_040.0,
    1.0 / 362_880.0,
    -1.0 / 39_916_800.0,
    1.0 / 6_227_020_800.0,
    -1.0 / 1_307_674_368_000.0,
    1.0 / 355_687_428_096_000.0,
    -1.0 / 121_645_100_408_832_000.0,
    1.0 / 51_090_942_171_709_440_000.0,
];

/// The sines of angles in radians. By loops, for what a closure of an iterator does is not compiled for the machine at hand.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn sines<const N: usize>(angles: [f64; N]) -> [f64; N] {
    let mut sines = angles;
    if are_small(angles) {
        for sine in &mut sines {
            let rounded = *sine * FRAC_1_PI + ROUND;
            *sine = from_multiple(*sine, rounded - ROUND, rounded);
        }
    } else {
        for sine in &mut sines {
            *sine = sine.sin();
        }
    }
    sines
}

/// The cosines of angles in radians.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn cosines<const N: usize>(angles: [f64; N]) -> [f64; N] {
    let mut cosines = angles;
    if are_small(angles) {
        for cosine in &mut cosines {
            let rounded = (*cosine * FRAC_1_PI + 0.5) + ROUND;
            *cosine = from_multiple(*cosine, rounded - ROUND - 0.5, rounded);
        }
    } else {
        for cosine in &mut cosines {
            *cosine = cosine.cos();
        }
    }
    cosines
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn are_small<const N: usize>(angles: [f64; N]) -> bool {
    let mut all = true;
    for angle in angles {
        all &= angle.abs() < LARGE;
    }
    all
}

/// (−1)ⁿ sin(x − π `multiple`), n the integer that was `rounded`. The terms in the order in which they are known, so that little
/// waits for what stands before.
#[cfg_attr(not(debug_assertions), inline(always))]
fn from_multiple(angle: f64, multiple: f64, rounded: f64) -> f64 {
    let r = angle - multiple * PI[0] - multiple * PI[1];
    let [a, b, c, d, e, f, g, h, i, j] = SERIES;
    let (z, cube) = (r * r, r * (r * r));
    let (z2, z4) = (z * z, (z * z) * (z * z));
    let low = (a + b * z) + (c + d * z) * z2;
    let middle = (e + f * z) + (g + h * z) * z2;
    let high = i + j * z;
    let sine = (r + middle * (cube * z4)) + (low + high * (z4 * z4)) * cube;
    f64::from_bits(sine.to_bits() ^ (rounded.to_bits() << 63))
}
