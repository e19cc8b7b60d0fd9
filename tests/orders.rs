//! Orders that a sentence supposes in passing.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn an_order_is_supposed_by_how_the_axes_are_numbered() {
    let text = r"The torque-free body turns on principal axes, and we number them so that $I_1 < I_2 < I_3$. Then

$$ (I_1 - I_2)(I_2 - I_3) > 0 $$
";
    assert_eq!(verdicts(text), "ap");
}
