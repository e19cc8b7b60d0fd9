//! The inertia tensor from noisy data.

use crate::identify_inertia::{gyroscope, identify, normal, torques};
use nalgebra::{Matrix3, SVector};
use polhode::mechanics::{InertiaParameters, possible_body};

/// The squared distance from the truth in standard deviations: of six parameters it is 6 in the mean, and above 27.9 once in ten
/// thousand.
fn distance(tensor: &Matrix3<f64>, seed: u64, deviation: f64) -> f64 {
    let torques = torques(300);
    let measured = gyroscope(tensor, &torques, normal(seed, deviation)).expect("a body");
    let found = identify(&torques, &measured).expect("a fit");
    let entries = InertiaParameters::MuJoCo.tensor(found.entries.into());
    assert_eq!(possible_body(&entries), Ok(()));
    let truth = SVector::<f64, 6>::from(InertiaParameters::MuJoCo.of_tensor(tensor));
    let off = found.entries - truth;
    let inverse = found.covariance.cholesky().expect("a covariance").inverse();
    off.dot(&(inverse * off))
}

#[test]
fn the_truth_lies_within_the_covariance() {
    let truth = Matrix3::new(0.6, 0.02, -0.03, 0.02, 0.8, 0.05, -0.03, 0.05, 1.0);
    let distances: Vec<_> = (0..20).map(|seed| distance(&truth, seed, 0.01)).collect();
    let mean = distances.iter().sum::<f64>() / 20.0;
    assert!(distances.iter().all(|d| *d < 27.9), "{distances:?}");
    // The mean of twenty strays by 0.77 from 6.
    assert!((3.0..9.0).contains(&mean), "{mean}");
}

/// A plate is the limit of what can exist: half of all unguarded fits would lie beyond it.
#[test]
fn a_plate_is_found_as_a_body_that_can_exist() {
    let plate = Matrix3::from_diagonal(&[0.4, 0.6, 1.0].into());
    for seed in 0..8 {
        let torques = torques(300);
        let measured = gyroscope(&plate, &torques, normal(seed, 0.05)).expect("a body");
        let found = identify(&torques, &measured).expect("a fit");
        let entries = InertiaParameters::MuJoCo.tensor(found.entries.into());
        assert_eq!(possible_body(&entries), Ok(()), "{entries}");
        assert!((entries - plate).norm() < 0.05, "{entries}");
    }
}
