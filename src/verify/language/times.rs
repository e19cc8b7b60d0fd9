//! Words by which a sentence begins with a time of the motion.

use super::reader::ARTICLES;
use super::words::Token;

/// Nouns of times.
const TIMES: [&str; 9] = [
    "time",
    "times",
    "instant",
    "instants",
    "moment",
    "impact",
    "blow",
    "collision",
    "release",
];

/// "Between the times …", "after the impact": a part of the motion, and none of the document.
pub(super) fn begins_with_time(tokens: &[Token]) -> bool {
    let placed = ["after", "before", "between", "until", "from", "at"];
    let noun = match tokens {
        [first, article, noun, ..] if placed.contains(&first.lower.as_str()) => {
            match ARTICLES.contains(&article.lower.as_str()) {
                true => noun,
                false => article,
            }
        }
        _ => return false,
    };
    TIMES.contains(&noun.lower.as_str())
}
