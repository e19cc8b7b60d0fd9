//! A linear regulator from the linearised step.

use crate::lqr::{Regulator, run, spinning};
use nalgebra::Vector6;

#[test]
fn a_spin_that_would_be_left_is_held() {
    let (system, reference) = spinning().expect("a body");
    let regulator = Regulator::new(&system, &reference).expect("a regulator");
    let radius = |m: &nalgebra::Matrix6<f64>| m.complex_eigenvalues().map(|l| l.norm()).amax();
    assert!(radius(&regulator.open) > 1.02 && radius(&regulator.closed) < 1.0);
    let off = Vector6::new(0.2, -0.1, 0.15, 0.1, 0.3, -0.2);
    let (errors, _) = run(&system, &regulator, reference, &off, 400);
    assert!(errors[399].norm() < 1e-6 * off.norm());
    // Near the reference the cost is that of the linear theory.
    let near = off * 1e-4;
    let (_, cost) = run(&system, &regulator, reference, &near, 1000);
    let expected = near.dot(&(regulator.cost * near));
    assert!(
        (cost - expected).abs() < 1e-4 * expected,
        "{cost} for {expected}"
    );
    // And no other gain costs less.
    for entry in 0..18 {
        for change in [0.9, 1.1] {
            let mut other = Regulator { ..regulator };
            other.gain[entry] = regulator.gain[entry] * change + 1e-2 * (change - 1.0);
            let (_, more) = run(&system, &other, reference, &near, 1000);
            assert!(more > cost, "entry {entry}: {more} for {cost}");
        }
    }
}
