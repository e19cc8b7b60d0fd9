//! Discrete steps: values before and after one, told apart by a number over the letter.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

const STEP: &str = r"The torque-free body has the principal moments $I_1$, $I_2$, $I_3$, and $I$ is its constant inertia matrix. A step of the size $h$ is defined by

$$ I\omega^{k+1} = I\omega^k + h\,(I\omega^k)\times\omega^k $$

For the increment $d = \omega^{k+1} - \omega^k$ it follows that

$$ \omega^k\cdot I d = 0 $$
";

#[test]
fn a_number_over_a_vector_counts_the_steps() {
    assert_eq!(verdicts(STEP), "aap");
    let bracketed = STEP.replace("^{k+1}", "^{(k+1)}").replace("^k", "^{(k)}");
    assert_eq!(verdicts(&bracketed), "aap");
    let other = STEP.replace(r"\omega^k\cdot I d", r"\omega^{k+1}\cdot I d");
    assert_eq!(verdicts(&other), "aar");
}
