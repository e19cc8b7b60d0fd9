//! The signs of which a rule speaks that is not understood: what does not carry one is not changed by it.

use super::reader::{ARTICLES, Reader};
use super::words::{Kind, Token};

/// Verbs of a rule.
const MEANS: [&str; 8] = [
    "means",
    "mean",
    "denotes",
    "denote",
    "stands",
    "stand",
    "signifies",
    "indicates",
];

/// Verbs of a rule, where the sign stands at something that is written.
const TELLS: [&str; 8] = [
    "is", "are", "holds", "hold", "marks", "mark", "shows", "says",
];

/// Where a sign stands.
const STANDS: [&str; 12] = [
    "over", "under", "above", "below", "on", "at", "behind", "before", "beside", "around", "about",
    "between",
];

/// What is written.
const WRITTEN: [&str; 18] = [
    "letter",
    "letters",
    "symbol",
    "symbols",
    "formula",
    "formulas",
    "vector",
    "vectors",
    "matrix",
    "matrices",
    "term",
    "terms",
    "factor",
    "factors",
    "quantity",
    "quantities",
    "expression",
    "expressions",
];

/// Words behind which what lacks a sign has a meaning, too.
const BESIDES: [&str; 10] = [
    "without",
    "no",
    "not",
    "other",
    "else",
    "otherwise",
    "plain",
    "same",
    "unless",
    "missing",
];

/// How signs are called, and how they are written.
const SIGNS: [(&[&str], &[&str]); 19] = [
    (
        &["label", "labels"],
        &[
            "_", "^", "₀", "₁", "₂", "₃", "₄", "ₓ", "ᵢ", "ⱼ", "⁰", "¹", "²", "³",
        ],
    ),
    (
        &["brace", "braces", "curly"],
        &["\\{", "cases", "brace", "\\left.", "⏟", "⏞"],
    ),
    (
        &["bracket", "brackets"],
        &["[", "(", "\\{", "matrix", "array", "\\langle", "⟨"],
    ),
    (
        &["parenthesis", "parentheses", "triple", "triples"],
        &["(", "pmatrix"],
    ),
    (
        &["cross", "crosses"],
        &["\\times", "\\cross", "×", "\\wedge", "∧"],
    ),
    (
        &[
            "exponent",
            "exponents",
            "superscript",
            "superscripts",
            "upper",
            "raised",
        ],
        &["^", "ᵀ", "⁻", "⁰", "¹", "²", "³"],
    ),
    (
        &["subscript", "subscripts", "lower", "lowered"],
        &["_", "₀", "₁", "₂", "₃", "₄", "ₓ", "ᵢ", "ⱼ"],
    ),
    (&["prime", "primes"], &["'", "\\prime", "′", "″"]),
    (&["arrow", "arrows"], &["\\vec", "arrow", "→", "\\to", "⃗"]),
    (&["hat", "hats", "circumflex"], &["hat", "̂"]),
    (&["tilde", "tildes"], &["tilde", "\\sim", "~", "̃"]),
    (
        &["bar", "bars"],
        &["bar", "overline", "|", "vert", "mid", "̄"],
    ),
    (
        &["star", "asterisk", "stars"],
        &["*", "\\ast", "\\star", "∗", "⋆"],
    ),
    (&["dagger"], &["dagger", "†"]),
    (&["colon", "colons"], &[":", "\\colon"]),
    (&["semicolon", "semicolons"], &[";"]),
    (&["sum", "sums", "sigma"], &["\\sum", "∑", "Σ"]),
    (&["integral", "integrals"], &["int", "∫"]),
    (
        &["box", "boxes", "frame-box"],
        &["boxed", "\\square", "\\Box", "□"],
    ),
];

/// Which of these are labels, and which brackets.
const LABELS: usize = 0;
const BRACKETS: usize = 2;

/// Labels behind brackets, as they are written.
const BEHIND_BRACKETS: [&str; 18] = [
    "]_", "] _", ")_", ") _", "|_", "| _", "\\}_", "\\} _", "vert_", "rangle_", "matrix}_", "]^",
    ")^", "|^", "\\}^", "vert^", "rangle^", "matrix}^",
];

impl Reader<'_> {
    /// How the first sign of which a rule speaks may be written; that of each one where it speaks of one or another. What a
    /// sign means is a rule for what carries it alone, if nothing is said of what lacks it.
    pub(super) fn written_signs(&self) -> Option<Vec<String>> {
        let rest = self.tokens.get(self.at..).unwrap_or_default();
        let is = |t: &Token, list: &[&str]| list.contains(&t.lower.as_str());
        let tells = |at: &usize| {
            let stands = |pair: &[Token]| is(&pair[0], &STANDS) && is(&pair[1], &WRITTEN);
            let plain: Vec<Token> = rest[..*at].to_vec();
            let plain: Vec<Token> = plain.into_iter().filter(|t| !is(t, &ARTICLES)).collect();
            is(&rest[*at], &TELLS) && plain.windows(2).any(stands)
        };
        let means = rest.iter().position(|t| is(t, &MEANS));
        let verb = means.or_else(|| (0..rest.len()).find(tells))?;
        let subject = &rest[..verb];
        let begins_with_word = subject.first().is_some_and(|t| t.kind == Kind::Word);
        if !begins_with_word || rest.iter().any(|t| is(t, &BESIDES)) {
            return None;
        }
        let several = subject.iter().any(|t| is(t, &["or", "and"]));
        let named = |sign: usize| subject.iter().any(|t| is(t, SIGNS[sign].0));
        if named(LABELS) && named(BRACKETS) && !several {
            return Some(BEHIND_BRACKETS.map(str::to_owned).to_vec());
        }
        let signs = |t: &Token| {
            let mut all = SIGNS.iter();
            all.find_map(|(called, written)| is(t, called).then_some(*written))
        };
        let found = subject.iter().filter_map(signs);
        let found: Vec<&[&str]> = found.take(if several { usize::MAX } else { 1 }).collect();
        let written = found.concat();
        (!written.is_empty()).then(|| written.into_iter().map(str::to_owned).collect())
    }
}
