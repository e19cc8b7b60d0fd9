//! What words say of symbols that are small, and of what hardly changes or is left out beside them.

use crate::verify::words::book::has_any;

/// Words before and behind symbols that are small.
pub(crate) const BEFORE: &[&str] = &["small", "tiny", "infinitesimal"];
pub(crate) const BEHIND: &[&str] = &[
    "is small",
    "are small",
    "is very small",
    "are very small",
    "are so small",
    "is so small",
    "remain small",
    "remains small",
    "stay small",
    "stays small",
    "is a small",
    "are both small",
    "be small",
    "be both small",
    "are all small",
    "is negligible",
    "is very nearly zero",
    "is nearly zero",
    "is of second order",
    "small.",
    "small,",
    "small;",
    "small:",
    "small and",
    "small compared",
    "both small",
    "being small",
    "are much smaller",
    "is much smaller",
];
/// What becomes of a term that is not kept.
pub(crate) const DROPPED: &[&str] = &[
    "dropped",
    "drop ",
    "neglected",
    "neglect",
    "negligible",
    "ignored",
    "left out",
    "omitted",
    "discarded",
    "second order",
];
/// Words behind and before a product of what is small that leave it out.
pub(crate) const LEFT_OUT: &[&str] = &[
    "is neglected",
    "are neglected",
    "can be neglected",
    "may be neglected",
    "is dropped",
    "are dropped",
    "can be dropped",
    "may be dropped",
    "is ignored",
    "can be ignored",
    "may be ignored",
    "is omitted",
    "is left out",
    "is negligible",
    "are negligible",
    "is of second order",
    "is of the second order",
    "is second order",
];
pub(crate) const LEAVING_OUT: &[&str] = &[
    "neglect",
    "neglecting",
    "drop",
    "dropping",
    "ignore",
    "ignoring",
    "omit",
    "omitting",
    "leave out",
    "leaving out",
];
/// What may stand between these and the product.
pub(crate) const THE_PRODUCT: &[&str] = &[
    "",
    "the product",
    "the term",
    "the small term",
    "the small product",
];
/// What small things are called together.
const SMALL_THINGS: &[&str] = &[
    "small quantities",
    "small ones",
    "small numbers",
    "small terms",
    "small rates",
    "disturbances",
    "perturbations",
    "deviations",
];

/// Whether words in small letters leave out what is of second order: "products of two small quantities are dropped".
pub(crate) fn takes_first_order(text: &str) -> bool {
    let dropped = |clause: &str| {
        let product = ["product", "square"]
            .iter()
            .filter_map(|word| clause.find(word));
        let of_small = |at: usize| has_any(&clause[at..], SMALL_THINGS);
        let theirs = clause.contains("their product") || clause.contains("their squares");
        (theirs || product.into_iter().any(of_small)) && has_any(clause, DROPPED)
    };
    has_any(text, LINEAR) || text.split(['.', ';']).any(dropped)
}

/// Words behind a component of ω that leave out what is of second order in its rate.
pub(crate) const KEPT: &[&str] = &["may be neglected", "can be neglected", "is negligible"];
/// What may stand between a component of ω and the word "constant", where its rate is of second order in the others.
const HARDLY: &[&str] = &[
    "nearly",
    "almost",
    "approximately",
    "essentially",
    "practically",
    "effectively",
    "sensibly",
    "very",
    "a",
    "as",
    "to",
    "be",
    "is",
    "remains",
    "stays",
    "may",
    "can",
    "taken",
    "treated",
    "regarded",
    "considered",
    "then",
    "therefore",
    "first",
    "order",
];
/// Words that leave out what is of second order.
const LINEAR: &[&str] = &[
    "first order",
    "first-order",
    "linearis",
    "lineariz",
    "linear terms",
    "products of small",
    "products of the small",
    "their product may be neglected",
    "their product can be neglected",
    "their product is negligible",
    "neglect their product",
    "drop their product",
    "second-order terms",
    "higher-order terms",
    "higher order terms",
    "terms of second order",
    "terms of higher order",
    "quadratic terms",
    "perturb",
];
/// Whether words behind a component of ω say that it hardly changes: "may be taken as a constant".
pub(crate) fn is_hardly_changed(text: &str) -> bool {
    let clause = text.split(['.', ',', ';', ':', '⟨']).next();
    let mut words = clause.unwrap_or_default().split_whitespace();
    let lead: Vec<&str> = words.by_ref().take_while(|w| *w != "constant").collect();
    let nearly = lead.len() > 1 && lead.iter().all(|word| HARDLY.contains(word));
    let ends = words.next().is_none_or(|word| word != "of");
    nearly && ends && text.contains("constant")
}
