//! Sentences that leave open which of two things is so.

#[path = "../../src/verify/language/either.rs"]
mod one_or_the_other;

use one_or_the_other::cases;

#[test]
fn one_of_two_things_is_meant() {
    let both = cases("O is the mass centre of the body or a point fixed in N and in B.");
    let both = both.map(|both| both.join(" "));
    let told = "O is the mass centre of the body. O is a point fixed in N and in B.";
    assert_eq!(both.as_deref(), Some(told));
    assert_eq!(cases("O is at rest or moves evenly."), None);
    assert_eq!(cases("The rod is long."), None);
}
