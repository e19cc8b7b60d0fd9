//! What a line is by the words around it and by what stands in it.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn what_is_solved_for_is_no_assumption() {
    let with = |value: &str| {
        let text = format!(
            "A force $P$ keeps the block of weight $W$ up, so that\n\n$$ \\mathbf M = b(W - P)\\,\\mathbf j $$\n\n\
             Let $M_y = -c$. Setting the moment equal to this and solving for the force,\n\n$$ P = {value} $$\n"
        );
        verdicts(&text).chars().last()
    };
    assert_eq!(with("W + \\frac{c}{b}"), Some('p'));
    assert_eq!(with("W - \\frac{c}{b}"), Some('r'));
}

#[test]
fn a_force_may_lie_in_a_plane() {
    let with = |force: &str| {
        verdicts(&format!(
            "The body turns with $\\vec\\omega$. A support acts with the force $\\vec F = {force}$.\n"
        ))
    };
    assert_eq!(with("F_x\\hat i + F_y\\hat j"), "a");
    assert_ne!(with("F_x\\hat i + F_y\\hat i"), "a");
    assert_ne!(with("F_x\\hat j + F_y\\hat i"), "a");
}

#[test]
fn what_is_said_to_be_equal_is_supposed() {
    let text = "The four speeds are equal, $n_1 = n_2 = n_3 = n_4$.\n\n$$ n_1 - n_2 + n_3 - n_4 = 0 $$\n\n\
                $$ n_1 + n_2 + n_3 = 2n_4 $$\n";
    assert_eq!(verdicts(text), "apr");
}
