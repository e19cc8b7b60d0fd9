//! What words say of the torque on a body: that none acts, or that there is one.

use crate::verify::words::book::{Book, has_any, lowered};
use crate::verify::words::suppositions::{NOTHING, Supposition, is_denied};
use std::sync::LazyLock;

/// Set phrases for a motion without a torque.
const FREE: &[&str] = &[
    "no torque",
    "torque-free",
    "torque free",
    "zero torque",
    "no moment acts",
    "free of torque",
    "no moments act",
    "moment-free",
    "absence of torque",
    "without torque",
    "force-free",
    "free motion",
    "free rigid body",
    "free body",
    "left to itself",
    "freely about its centre of mass",
    "freely about its center of mass",
    "freely about its mass centre",
    "freely about its mass center",
];
static FREE_BOOK: LazyLock<Book> = LazyLock::new(|| Book::of(FREE));

/// What a torque that is denied may be called, between the "no" and the thing: "no outside torque".
const KINDS: &[&str] = &[
    "outside",
    "external",
    "applied",
    "net",
    "resultant",
    "outer",
    "disturbing",
];
const THINGS: &[&str] = &[
    "torque", "torques", "moment", "moments", "couple", "couples",
];

static NO_TORQUE: LazyLock<Supposition> = LazyLock::new(|| {
    let things = [
        "torque",
        "moment ",
        "moments ",
        "moment,",
        "moments,",
        "couple ",
        "couples ",
        "moment⟨",
    ];
    // A part of it, or of something else.
    let denied = [
        "of inertia",
        "principal moment",
        "moment of momentum",
        "deviation",
        "centrifugal",
        "both ",
        "component",
        "along",
        "about the axis",
        "about this axis",
        "about its axis",
        "about the other",
        "about two axes",
        "other two",
        " axis",
        "gyroscopic",
        "friction",
        "damping",
        "product",
        "angular velocity",
        "work",
        "motor",
        "wheel",
        "control",
        "input",
        "gravity gradient",
        "equal",
        "then ",
        "needs",
    ];
    Supposition::of(&things, NOTHING, &denied)
});

const FREE_MOTION: &[&str] = &[
    "freely",
    "free rotation",
    "free precession",
    "free tumbling",
];
static FREELY: LazyLock<Supposition> = LazyLock::new(|| {
    let said = [
        "rotat", "tumbl", "spin", "moves", "moving", "flies", "precess", "body",
    ];
    let denied = [
        "about", "can ", "may ", "fall", "hinge", "pivot", "axle", "bearing", "point",
    ];
    Supposition::of(FREE_MOTION, &said, &denied)
});

const FORCE_FREE: &[&str] = &[
    "no forces act",
    "no force acts",
    "no external forces",
    "without external forces",
];
static NO_FORCE: LazyLock<Supposition> = LazyLock::new(|| {
    Supposition::of(
        FORCE_FREE,
        &[""],
        &["but ", "except", "other than", "along"],
    )
});

/// Words between a torque and its axis, and what an axis is called.
const ABOUT: &[&str] = &["about", "along", "around", "on"];
const AXES: &[&str] = &["axis", "shaft", "axle", "hinge", "line", "vertical"];

/// What a weight does to have a moment, and words of a body that nothing else touches.
const HAS: &[&str] = &[
    "has", "exerts", "gives", "makes", "produces", "have", "exert",
];
const ALOFT: &[&str] = &[
    "in the air",
    "in flight",
    "airborne",
    "aloft",
    "in free fall",
    "freely falling",
];
/// What may yet have one.
const OTHER_LOADS: &[&str] = &["but ", "except", "resistance", "drag", "only", "axes"];

const THERE: &[&str] = &["is no ", "are no ", "with no ", "without "];

/// What no text is without that says that no torque acts.
static CUES: LazyLock<Book> = LazyLock::new(|| {
    Book::of([FREE, KINDS, NOTHING, FREE_MOTION, FORCE_FREE, THERE, ALOFT].concat())
});

/// Whether a text in small letters says that no torque acts.
pub(crate) fn torque_free(text: &str) -> bool {
    if !CUES.is_in(text) {
        return false;
    }
    // A word may stand at the end of its line.
    let text = &format!("{} ", text.replace('\n', " "));
    let says = || {
        let mut supposed = [&NO_TORQUE, &FREELY, &NO_FORCE].into_iter();
        let mut set = FREE_BOOK.places(text);
        let whole = |at: usize, end: usize| {
            let free = text[at..end].contains("free");
            free || !is_about_an_axis(&text[end..])
        };
        set.any(|(_, at, end)| !is_denied(text, at, end) && whole(at, end))
            || denies_a_kind(text)
            || there_is_none(text)
            || weight_has_no_moment(text)
            || supposed.any(|supposed| supposed.is_in(text))
    };
    says()
}

/// Whether words behind "no torque" have it about one axis alone: "acts about the shaft".
fn is_about_an_axis(behind: &str) -> bool {
    let clause = behind.split(['.', ';', ',', '!', '?']).next();
    let words = words(clause.unwrap_or_default());
    let at = words.iter().position(|word| ABOUT.contains(word));
    let named = at.map_or(&[][..], |at| &words[at..]);
    let has = |any: &[&str]| named.iter().any(|word| any.contains(word));
    has(AXES) && !has(&["any", "all", "each", "every", "three", "no"])
}

/// Whether a text speaks of a torque, other than that there is none.
pub(crate) fn speaks_of_a_torque(text: &str) -> bool {
    let mut text = lowered(text);
    for phrase in FREE {
        text = text.replace(phrase, "");
    }
    let words = words(&text);
    let denied = |at: usize| at >= 2 && denies(&words[at - 2..=at]);
    // Equations that are coupled have no couple.
    let couple = |word: &str| matches!(word, "couple" | "couples");
    let named = |word: &str| couple(word) || has_any(word, &["torque", "motor", "damp"]);
    let mut all = words.iter().enumerate();
    all.any(|(at, word)| named(word) && !denied(at))
}

/// "No outside torque", "without applied moments": a denial, a word for the kind, and the thing.
fn denies_a_kind(text: &str) -> bool {
    let mut names = ["torque", "moment", "couple"].iter();
    names.any(|name| text.contains(name)) && words(text).windows(3).any(denies)
}

/// "There is no moment", "without a torque": none of any kind, about no axis in particular.
fn there_is_none(text: &str) -> bool {
    const PARTS: &[&str] = &["of", "about", "along", "around", "in", "arm", "from", "due"];
    let words = words(text);
    (0..words.len()).any(|at| {
        let (thing, behind) = match words[at..] {
            ["is" | "are" | "with", "no", thing, ..] => (thing, words.get(at + 3)),
            ["without", "a" | "an" | "any", thing, ..] => (thing, words.get(at + 3)),
            ["without", thing, ..] => (thing, words.get(at + 2)),
            _ => return false,
        };
        THINGS.contains(&thing) && behind.is_none_or(|word| !PARTS.contains(word))
    })
}

/// "The weight has no moment about the centre of mass", of a body on which nothing else acts: so it flies.
fn weight_has_no_moment(text: &str) -> bool {
    let mut clauses = text.split(['.', ';', '!', '?']);
    clauses.any(|clause| {
        let said = words(clause);
        let has = |any: &[&str]| said.iter().any(|word| any.contains(word));
        let mut threes = said.windows(3);
        let none = threes.any(|three| {
            matches!(three, [verb, "no", thing] if HAS.contains(verb) && THINGS.contains(thing))
        });
        none && has(&["weight", "gravity"])
            && has_any(clause, ALOFT)
            && !has(AXES)
            && !has_any(clause, OTHER_LOADS)
    })
}

fn denies(words: &[&str]) -> bool {
    matches!(words, ["no" | "without", kind, thing] if KINDS.contains(kind) && THINGS.contains(thing))
}

fn words(text: &str) -> Vec<&str> {
    let words = text.split(|c: char| !c.is_alphanumeric());
    words.filter(|word| !word.is_empty()).collect()
}
