//! What is said of slips and of lines that stay open.

pub(crate) const HALF_MISSING: &str = "a factor ½ is missing";
pub(crate) const TWO_MISSING: &str = "a factor 2 is missing";
pub(crate) const SIGN: &str = "the sign is wrong";
pub(crate) const TRANSPOSED: &str = "a transpose too many";
pub(crate) const EXTRA_TERM: &str = "this term does not belong here";
pub(crate) const CROSS_ORDER: &str = "the factors of × are swapped";
pub(crate) const ORDER: &str = "the factors are swapped";
pub(crate) const DOT_MISSING: &str = "a dot is missing";
pub(crate) const SQUARE_MISSING: &str = "a square is missing";
pub(crate) const TRANSPOSE_MISSING: &str = "a transpose is missing";
pub(crate) const EXTRA_DOT: &str = "a dot too many";
pub(crate) const EXTRA_SQUARE: &str = "a square too many";
pub(crate) const EXTRA_INVERSE: &str = "an inverse too many";
pub(crate) const EXTRA_TWO: &str = "a factor 2 too many";
pub(crate) const EXTRA_HALF: &str = "a factor ½ too many";

/// Why a relation to first order is open whose sides have no terms of first order.
pub(crate) const SECOND_ORDER: &str = "both sides are of second order in what is small";

pub(crate) const OTHER_INSTANTS: &str = "values at these instants";
pub(crate) const NO_NUMBERS: &str = "no numbers were found in which it fails";
pub(crate) const SQUARES_DIFFER: &str = "the squares of the sides differ";
pub(crate) const BY_ENTRIES: &str = "a matrix by its entries between brackets";
pub(crate) const OPEN_RELATION: &str = "this relation is not decided";
pub(crate) const SMALL_BY_OTHERS: &str = "what is small is told by other letters";
pub(crate) const LOADS_NOT_LISTED: &str =
    "no sentence says which loads are the only ones on the body on which this one acts";
pub(crate) const ONE_ELEMENT: &str =
    "something of a single element is left over, such as a density that may vary";
pub(crate) const UNTIED: &str = "a value at an instant is not worked out";
pub(crate) const HOLDS_AT_INSTANT: &str =
    "it holds at an instant, and the motion from there is not worked out";
pub(crate) const IN_BOTH_CASES: &str =
    "it holds in both cases that a sentence leaves open; the proof is that of the first";
pub(crate) const OPEN_CASE: &str =
    "it depends on which of two things is so, and a sentence leaves that open";
pub(crate) const OPEN_MEANING: &str = "the types do not tell which of its meanings a letter has";
pub(crate) const OPEN_SIGNS: &str = "more than one sign is left open";
pub(crate) const ALWAYS_THE_SAME: &str = "both sides are always the same";
pub(crate) const MOSTLY_THE_SAME: &str = "both sides are the same, but where something vanishes";

/// What was written, and what should be.
pub(crate) fn should_be(written: &str, wanted: &str) -> String {
    format!("{written} should be {wanted}")
}

/// A line is taken as given, and what it says is not taken in: others may hold by it.
pub(crate) fn not_taken_in(line: &str) -> String {
    format!("{line} is taken as given, and nothing was made of it")
}

/// A line holds on principal axes, of which no sentence tells.
pub(crate) fn untold_products(body: &str) -> String {
    format!(
        "it holds where the products of inertia of {body} are zero, and no sentence tells them: say which axes are principal"
    )
}

/// The text puts a condition on a line that is false without it.
pub(crate) fn under_condition(condition: &str) -> String {
    format!(
        "the text puts a condition on it that no sentence declares: \"{condition}\"; say for which lines it holds"
    )
}

/// A sum runs up to a letter of which nothing is told.
pub(crate) fn unknown_bound(bound: &str) -> String {
    format!("no sentence says how far a sum up to `{bound}` runs")
}
/// Why what is said of motions nearby is not denied.
pub(crate) const WIDER_MEANINGS: &str =
    "it holds by what its letters mean outside the section in which they are told anew";
pub(crate) const OTHER_MOTIONS: &str = "what is told of this motion may hold in motions nearby";

/// Why a line is left open that may tell how a frame turns.
pub(crate) fn untold_attitude(frame: &str) -> String {
    format!("no sentence says how {frame} turns, and this may say it")
}

/// The name of the point from which a frame's places are counted, where the author gives none.
pub(crate) fn origin_of(frame: &str) -> String {
    format!("origin of {frame}")
}

/// The number by which a frame is called.
pub(crate) fn number_of_frame(name: &str) -> Option<&str> {
    name.strip_prefix(&numbered_frame(""))
}

/// The name of a frame that is called by its number.
pub(crate) fn numbered_frame(number: &str) -> String {
    format!("frame {number}")
}
