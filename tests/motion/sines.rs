//! Sines and cosines side by side against those of the standard library.

#[path = "../../src/motion/sines.rs"]
mod side_by_side;

use side_by_side::{cosines, sines};

#[test]
fn sines_and_cosines_are_right_to_the_last_places() {
    for i in 0..200_000 {
        let near = f64::from(i) * 1e-4 - 10.0;
        let angles = [near, near * 1.7e4, -near * 0.99e5];
        for (found, known) in [
            (sines(angles), angles.map(f64::sin)),
            (cosines(angles), angles.map(f64::cos)),
        ] {
            for (found, known) in found.into_iter().zip(known) {
                assert!((found - known).abs() < 4e-16, "{found} for {known}");
            }
        }
    }
}

#[test]
fn small_angles_large_ones_and_none_are_met() {
    for angle in [0.0, 1e-300, 1e-9, 3.0, 1e6, 1e15, -1e300] {
        let [sine] = sines([angle]);
        assert!((sine - angle.sin()).abs() <= 4e-16 * angle.sin().abs());
    }
    assert!(sines([f64::NAN])[0].is_nan() && cosines([f64::INFINITY])[0].is_nan());
    let negative = sines([-0.0])[0];
    assert!(negative == 0.0 && (cosines([0.0])[0] - 1.0).abs() < 1e-16);
}
