//! Words that stand before the names of bodies, in them, and never in them.

/// Words before the name of a body, beside the nouns of which only bodies have something.
pub(super) const BEFORE: [&str; 27] = [
    "mass of",
    "masses of",
    "attitude of",
    "fixed in",
    "fixed to",
    "attached to",
    "at rest in",
    "relative to the",
    "consists of",
    "consist of",
    "comprises",
    "comprise",
    "numbers",
    "acts on",
    "act on",
    "rolls on",
    "slides on",
    "rests on",
    "hinged to",
    "touches",
    "point where",
    "velocity of",
    "speed of",
    "angle of",
    "lagrangian of",
    "strikes",
    "leaves",
];

/// Words by which two bodies of one kind are told apart: they are parts of their names.
pub(super) const APART: [&str; 23] = [
    "upper", "lower", "inner", "outer", "front", "rear", "back", "left", "right", "top", "bottom",
    "middle", "driving", "driven", "fore", "aft", "near", "far", "leading", "trailing", "main",
    "base", "swing",
];

/// What bodies alone do, where the lexicon has no such verb.
pub(super) const OF_BODIES: [&str; 6] = ["exerts", "exert", "carries", "carry", "weighs", "weigh"];

/// Words that say of a body that nothing of it is left out.
pub(super) const ENTIRE: [&str; 3] = ["whole", "entire", "complete"];

/// Words that count, point, compare or say how, and never name a body.
pub(super) const NO_NAMES: [&str; 53] = [
    "same",
    "said",
    "given",
    "aforementioned",
    "considered",
    "left-handed",
    "non-orthogonal",
    "oblique",
    "skew",
    "they",
    "them",
    "both",
    "all",
    "some",
    "none",
    "every",
    "either",
    "neither",
    "former",
    "latter",
    "first",
    "second",
    "third",
    "next",
    "other",
    "others",
    "another",
    "such",
    "this",
    "that",
    "these",
    "those",
    "most",
    "least",
    "not",
    "never",
    "always",
    "only",
    "almost",
    "too",
    "then",
    "per",
    "twice",
    "half",
    "mean",
    "average",
    "own",
    "opposite",
    "momentary",
    "about",
    "quite",
    "rather",
    "very",
];

/// Whether a word may be one of the name of a body: adverbs are not.
pub(crate) fn may_name(word: &str) -> bool {
    !NO_NAMES.contains(&word) && !word.ends_with("ly")
}
