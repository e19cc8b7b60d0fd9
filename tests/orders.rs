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

#[test]
fn orders_hold_in_a_motion_that_would_contradict_them() {
    // A constant spin about the middle axis makes the other two moments equal, or leaves no motion about them.
    for constant in ["", " with a constant $n$"] {
        let text = format!(
            "Principal axes, no torque. Order the moments: $I_1 < I_2 < I_3$. Let $\\omega_2 = n${constant}. \
             Define $k = (I_3 - I_2)(I_2 - I_1) n^2/(I_1 I_3)$. Then\n\n$$ k > 0 $$\n"
        );
        assert_eq!(verdicts(&text), "aaap");
    }
}
