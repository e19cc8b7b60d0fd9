//! Why lines stay open, in words that more than one step has to know.

pub(super) const TAKEN_AS_GIVEN: &str = "taken as given below: nothing here determines it";
pub(super) const RESTS_ON_GIVEN: &str =
    "a line that was taken as given, and may be false, gives this value";
pub(super) const PROVED_BY_ITSELF: &str = "it is proved only by what it says itself";
pub(super) const OTHER_DOTS: &str =
    "a dot without a frame means something else here than in a line before";
pub(super) const SLOPE_OF_VECTOR: &str =
    "a partial derivative of a vector in a number is not decided";
pub(super) const OTHER_KIND: &str =
    "its letter stands for a thing of another kind in this document";
pub(super) const GOES_ON_FROM_NONE: &str = "the line goes on from no other";
/// A remark of a line that says when, and nothing more.
pub(super) const NAMES_A_MOMENT: &str = "names a moment of the motion";
pub(super) const AT_A_MOMENT: &str = "it speaks of a moment of the motion, and may hold then alone";
pub(super) const RELATION: &str = "this relation is not decided";
pub(super) const INTEGRAL: &str = "an integral is not evaluated";
pub(super) const OTHER_CASE: &str = "it speaks of another case than that of the numbers given";
pub(super) const MANY_FALSE: &str =
    "its mistake is not searched for, as many lines before it are false";
pub(super) const FALSE_VALUE: &str = "a value in it is that of an earlier line, which is false";
pub(super) const DRIVES_A_PART: &str = "how what drives a part of the body turns it is not decided";
pub(super) const NO_SOLUTION: &str = "it does not solve the equation of motion that the laws give";
pub(super) const NO_PROOF: &str = "equal in every trial, and no proof was found";
pub(super) const EMPTIED: &str =
    "what stands here vanishes by what is supposed, as it would with any factor";
pub(super) const NO_WITNESS: &str =
    "it differs in the prime field, and no small counterexample was found";
pub(super) const NO_VALUES: &str = "no values could be put in";
pub(super) const NO_PROOF_IN_NUMBERS: &str = "equal to the digits shown, and no proof was found";
pub(super) const GROWN: &str = "the numbers grew beyond what is computed";
pub(super) const MIXED: &str = "what is added here is not of one dimension";
pub(super) const BUDGET: &str =
    "budget: equal in every trial, and the proof grew beyond the terms allowed";

/// Whether a line that stays open for a reason leaves the lines after it as they are.
pub(super) fn leaves_no_doubt(reason: &str) -> bool {
    [
        TAKEN_AS_GIVEN,
        RESTS_ON_GIVEN,
        RELATION,
        INTEGRAL,
        OTHER_CASE,
        FALSE_VALUE,
        DRIVES_A_PART,
        NO_PROOF,
        BUDGET,
    ]
    .contains(&reason)
}

/// Whether a line stays open because nothing says what a symbol of it is.
pub(super) fn names_unsaid(reason: &str) -> bool {
    reason.starts_with("nothing before says what")
}
