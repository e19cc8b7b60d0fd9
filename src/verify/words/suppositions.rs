//! What clauses suppose of a body and its loads, in any of the many ways to say it: a thing and what is said of it.

use crate::verify::words::book::Book;
use std::sync::LazyLock;

/// A thing, what is said of it, and what denies either.
pub(crate) struct Supposition {
    things: Book,
    said: Book,
    denied: Book,
}

impl Supposition {
    /// The supposition that one of some things has one of some words beside it, and none that deny it.
    pub(crate) fn of(things: &[&str], said: &[&str], denied: &[&str]) -> Self {
        Self {
            things: Book::of(things),
            said: Book::of(said),
            denied: Book::of(denied),
        }
    }

    /// Whether a clause of a text in small letters supposes it; a formula is ⟨⟩ there.
    pub(crate) fn is_in(&self, text: &str) -> bool {
        self.things.is_in(text)
            && text
                .split(['.', ';', '!', '?'])
                .any(|clause| self.things.is_in(clause) && self.holds_in(clause))
    }

    fn holds_in(&self, clause: &str) -> bool {
        self.said.is_in(clause) && !self.denied.is_in(clause) && !DENIED.is_in(clause)
    }
}

/// What makes a clause a denial, a consequence or a question.
static DENIED: LazyLock<Book> = LazyLock::new(|| {
    Book::of([
        "not ",
        "n't ",
        "nonzero",
        "non-zero",
        "neither",
        "unless",
        "only if",
        "whether",
        "hence",
        "thus",
        "therefore",
        "so that",
        "follows",
        "conclude",
        "consequently",
        "must",
        "would",
        "general axes",
        "arbitrary axes",
        "in general",
        "need ",
        "shows that",
        "why",
    ])
});

/// That something is nothing.
pub(crate) const NOTHING: &[&str] = &[
    "vanish",
    "zero",
    "disappear",
    "absent",
    "absence",
    "free of",
    "free from",
];
/// That something is left out.
const LEFT_OUT: &[&str] = &[
    "no products of inertia",
    "without products of inertia",
    "drop",
    "neglect",
    "ignor",
    "omit",
];

const PRODUCTS_OF_INERTIA: &[&str] = &[
    "products of inertia",
    "product of inertia",
    "cross-products of inertia",
    "cross products of inertia",
    "off-diagonal",
    "off diagonal",
    "deviation moments",
    "deviational moments",
    "centrifugal moments",
];
static PRODUCTS: LazyLock<Supposition> = LazyLock::new(|| {
    // One or two of them, or those that a formula names, are not all.
    let denied = [
        "⟨",
        "two ",
        "both ",
        "some ",
        "one of",
        "but ",
        "except",
        "only ",
        "remaining",
        "other ",
        "balanc",
        // "No product of inertia is left out."
        "no product of inertia",
        "no products of inertia are",
        "no products of inertia have",
        "none of",
        "without neglect",
        "without drop",
        "without ignor",
        "left out",
    ];
    let said = [NOTHING, LEFT_OUT].concat();
    Supposition::of(PRODUCTS_OF_INERTIA, &said, &denied)
});

const DIAGONAL_FORM: &[&str] = &[
    "principal direction",
    "is diagonal",
    "are diagonal",
    "becomes diagonal",
    "be diagonal",
    "diagonal inertia",
    "diagonal form",
    "diagonal tensor",
    "diagonal matrix",
    "then diagonal",
    "is a diagonal",
    "diagonalis",
    "diagonaliz",
    "eigenbasis",
    "eigenframe",
    "principal basis",
    "principal system",
    "principal triad",
];
static DIAGONAL: LazyLock<Supposition> = LazyLock::new(|| {
    let things = ["inertia", "tensor", "matrix", "axes"];
    Supposition::of(&things, DIAGONAL_FORM, &["off-diagonal inertia"])
});

const PLANES_OF_SYMMETRY: &[&str] = &[
    "planes of symmetry",
    "symmetry planes",
    "symmetric about",
    "symmetrical about",
    "symmetric with respect to",
];
static SYMMETRY_PLANES: LazyLock<Supposition> = LazyLock::new(|| {
    let said = ["three ", "all ", "each "];
    Supposition::of(PLANES_OF_SYMMETRY, &said, &["axis", "axes"])
});

/// What no text is without that supposes so.
static CUES: LazyLock<Book> = LazyLock::new(|| {
    let cues = [PRODUCTS_OF_INERTIA, DIAGONAL_FORM, PLANES_OF_SYMMETRY];
    Book::of(cues.concat())
});

/// Whether a text in small letters supposes that the axes are principal.
pub(crate) fn principal(text: &str) -> bool {
    let mut supposed = [&PRODUCTS, &DIAGONAL, &SYMMETRY_PLANES].into_iter();
    CUES.is_in(text) && supposed.any(|supposed| supposed.is_in(text))
}

/// What denies a phrase.
static NOT_SO: LazyLock<Book> = LazyLock::new(|| {
    Book::of([
        "not ",
        "need not",
        "n't ",
        "general axes",
        "arbitrary",
        // "I go to principal axes only at the end."
        "at the end",
        "at the very end",
        "later on",
        "only later",
        "only afterwards",
    ])
});

/// Whether something in its clause denies a phrase that stands there.
pub(crate) fn is_denied(text: &str, at: usize, end: usize) -> bool {
    let stops = ['.', ';', '!', '?'];
    let before = text[..at].rfind(stops).map_or(0, |i| i + 1);
    let behind = text[at..].find(stops).map_or(text.len(), |i| at + i);
    let clause = &text[before..behind];
    NOT_SO.is_in(&clause.replace(&text[at..end], ""))
}

/// What comes before axes that a law holds on, or that the author does not take.
static ELSEWHERE: LazyLock<Book> = LazyLock::new(|| {
    let law = ["equations ", "equation ", "law ", "they ", "it ", "which "];
    let holds = [
        "assume",
        "assumes",
        "require",
        "requires",
        "need",
        "needs",
        "presuppose",
        "presupposes",
        "hold only",
        "holds only",
        "hold for",
        "hold in",
        "holds for",
        "holds in",
        "apply to",
        "apply in",
        "are valid",
        "is valid",
        "are written for",
        "are written in",
    ];
    let said = law
        .iter()
        .flat_map(|law| holds.map(|holds| format!("{law}{holds}")));
    let others = ["instead of", "rather than", "unlike", "in contrast"].map(str::to_owned);
    Book::of(said.chain(others))
});

/// Whether a phrase in a text in small letters tells on which axes a law holds: the author need not take those.
pub(crate) fn is_of_a_law(text: &str, at: usize) -> bool {
    let clause = text[..at]
        .rfind(['.', ';', '!', '?', ':'])
        .map_or(0, |i| i + 1);
    ELSEWHERE.is_in(&text[clause..at])
}
