//! Where the name of a quantity stands beside a letter.

use crate::verify::values::quantity::Quantity;
use crate::verify::words::book::has_any;
use crate::verify::words::quantity_names::{BOOK, LONGEST, PHRASES, is_word};

/// What is said of a quantity, and is not the quantity.
const LAWS: &[&str] = &[
    "theorem of",
    "law of",
    "principle of",
    "balance of",
    "conservation of",
    "rate of",
    "change of",
    "derivative of",
];

/// The single letters that a text names right after such a phrase: "moments A, A, C", with the phrase's quantity.
pub(crate) fn letters_named(text: &str) -> Vec<(String, Quantity)> {
    let lower = text.to_lowercase();
    let mut named = vec![];
    if lower.len() != text.len() {
        return named;
    }
    for (which, at, end) in BOOK.places(&lower) {
        let (phrase, Some(quantity)) = &PHRASES[which] else {
            continue;
        };
        if !is_word(&lower, at, phrase) || !text.is_char_boundary(end) {
            continue;
        }
        let words = text[end..]
            .trim_start_matches('s')
            .split(|c: char| c.is_whitespace() || c == ',')
            .filter(|w| !w.is_empty() && *w != "and");
        let single = |w: &&str| w.chars().count() == 1 && w.chars().all(char::is_alphabetic);
        let found = words.take_while(single).filter(|w| *w != "a" && *w != "I");
        named.extend(found.map(|w| {
            // "Moments A, B, C" are of inertia.
            let inertia = *quantity == Quantity::Moment && matches!(w, "A" | "B" | "C");
            let quantity = if inertia {
                Quantity::Inertia
            } else {
                *quantity
            };
            (w.to_owned(), quantity)
        }));
    }
    named
}

/// What brings a thing in, and names nothing: "with the angular momentum from above this becomes".
const ASIDE: &[&str] = &[
    "with the ",
    "using the ",
    "inserting the ",
    "substituting the ",
    "from the ",
];

/// Words before what there is none of: "without a torque both ⟨T⟩ and ⟨L⟩ are constant" names neither.
const ABSENT: &[&str] = &[
    " no",
    "no external",
    "no applied",
    "without",
    "without a",
    "without an",
    "without any",
    "without an external",
    "without external",
    "in the absence of a",
    "in the absence of",
    "in the absence of an external",
    "in the absence of external",
];

/// Parts of a body that spin in it.
const WHEELS: &[&str] = &[
    "wheel",
    "rotor",
    "gyrostat",
    "propeller",
    "turbine",
    "relative angular momentum",
];

/// Whether a text in small letters speaks of wheels in the body, which have a momentum of their own.
pub(crate) fn speaks_of_wheels(text: &str) -> bool {
    has_any(text, WHEELS)
}

/// Whether what a clause in small letters says of a momentum is said of a wheel: "relative to the airframe the propeller
/// has the angular momentum", "the rotor adds an angular momentum".
fn is_of_a_wheel(clause: &str) -> bool {
    let part = WHEELS
        .iter()
        .filter_map(|word| clause.find(word))
        .any(|at| has_any(&clause[at..], &[" has ", " have "]));
    let adds = |at: usize| {
        has_any(
            &clause[at..],
            &[" adds ", " carries ", " contributes ", " stores "],
        )
    };
    part && clause.contains("relative to")
        || WHEELS.iter().filter_map(|word| clause.find(word)).any(adds)
}

/// Whether what a clause says turns is a body.
fn is_of_a_body(clause: &str) -> bool {
    let bodies = [
        "body",
        "rotor",
        "shaft",
        "disc",
        "disk",
        "plate",
        "top",
        "satellite",
        "cylinder",
        "rod",
        "book",
        "block",
    ];
    let mut words = clause.split(|c: char| !c.is_alphabetic());
    words.any(|word| bodies.contains(&word))
}

/// Whether the words before a phrase end with a wheel whose own the thing is: "the rotor's".
pub(crate) fn ends_with_a_wheel(words: &str) -> bool {
    let last = words.split_whitespace().next_back().unwrap_or_default();
    let owner = last.trim_end_matches(['\'', '’', 's']);
    last.len() > owner.len() && WHEELS.contains(&owner) && last.contains(['\'', '’'])
}

/// Whether "mass" is the end of "centre of mass".
fn is_of_mass(before: &str, phrase: &str) -> bool {
    let point = ["centre of ", "center of ", "element of "];
    phrase == "mass" && point.iter().any(|words| before.ends_with(words))
}

/// Whether the mass centre is the point that a quantity is taken about, and not what is named.
fn is_point(before: &str, named: &str) -> bool {
    let about = [
        "about the ",
        "about its ",
        "around the ",
        "with respect to the ",
    ];
    named.starts_with("mass cent") && about.iter().any(|words| before.ends_with(words))
}

/// Whether a thing is brought in, and another clause follows it.
fn is_aside(before: &str, behind: &str) -> bool {
    let verbs = [
        "becomes", "gives", "yields", "reads", "this is", "we get", "we find", "we have",
    ];
    let adjectives = ["angular ", "total ", "external "];
    let before = adjectives
        .iter()
        .fold(before, |words, adjective| words.trim_end_matches(adjective));
    let brought_in = |ways: &[&str]| ways.iter().any(|words| before.ends_with(words));
    // "Substituting the angular momentum and collecting terms:" announces what comes of it.
    let announces = behind.contains(" and ") || behind.trim_end().ends_with(':');
    brought_in(ASIDE) && has_any(behind, &verbs)
        || brought_in(&["inserting the ", "substituting the "]) && announces
}

/// The quantity that the words before a formula name, where they come close to it.
pub(crate) fn said_before(text: &str, follows: impl Fn(&str) -> bool) -> Option<Quantity> {
    let near = |&(which, at, _): &(usize, usize, usize)| {
        let (phrase, _) = &PHRASES[which];
        is_word(text, at, phrase)
            && !is_of_mass(&text[..at], phrase)
            && !is_point(&text[..at], &text[at..])
            && !is_aside(&text[..at], &text[at..])
    };
    let (which, at, end) = BOOK
        .places(text)
        .filter(near)
        .max_by_key(|&(_, at, end)| (end, end - at))?;
    let quantity = PHRASES[which].1;
    let clause = text[..at].rsplit([',', ';', '.']).next();
    // "The theorem of angular momentum is": the letter before the sign is the moment, or what else it speaks of.
    let lead = clause
        .unwrap_or_default()
        .trim_end()
        .trim_end_matches(" the");
    let behind = &text[end..];
    let of_rate = behind.trim_end().trim_end_matches(" the");
    // "Writing ⟨α⟩ for the angular acceleration, …" names what stands before.
    let named = lead.ends_with("⟨ for") && behind.starts_with(',');
    let law = |text: &str| LAWS.iter().any(|law| text.ends_with(law));
    let absent = ABSENT.iter().any(|words| lead.ends_with(words));
    if named || absent || law(lead) || law(of_rate) {
        return None;
    }
    let of_axes = clause.is_some_and(|words| {
        let subject = |name: &str| words.split_whitespace().any(|word| word == name);
        (subject("frame") || subject("axes")) && !subject("body")
    });
    // "The frame follows the precession but not the spin, so its angular velocity".
    let follows_frame = clause.is_some_and(|words| words.contains(" its"))
        && has_any(
            &text[..at],
            &[
                "frame follows",
                "axes follow",
                "frame turns",
                "frame rotates",
            ],
        );
    let of_axes = of_axes || follows_frame;
    let of_wheel = clause.is_some_and(is_of_a_wheel);
    (follows(&text[end..]) && text.len() - end < 60).then_some(match quantity {
        Some(Quantity::AngularVelocity) if of_axes => Some(Quantity::FrameRate),
        // "The rotor turns with the angular velocity": no axes are spoken of.
        Some(Quantity::FrameRate) if !of_axes && clause.is_some_and(is_of_a_body) => {
            Some(Quantity::AngularVelocity)
        }
        Some(Quantity::Momentum) if of_wheel => Some(Quantity::RelativeMomentum),
        // "The rotor's moment of inertia about its axis is": a number of the part.
        Some(Quantity::Inertia) if clause.is_some_and(ends_with_a_wheel) => None,
        other => other,
    })?
}

/// Whether words that name something reach over the formulas behind them to the next: "the energy about ⟨ is" does to
/// a display; over a formula right behind the words, only its list goes on: "the moments ⟨, ⟨ and ".
pub(crate) fn reaches(text: &str, display: bool) -> bool {
    // "No torque along ⟨e⟩": a direction; "the moments about ⟨A⟩": a point; "linear in ⟨x⟩": what it is made of.
    let related = [
        "along",
        "along the axis",
        "perpendicular to",
        "parallel to",
        " about",
        " about point",
        " about the point",
        " around",
        " at the point",
        "linear in",
        "quadratic in",
        "in terms of",
        "depends on",
        "depend on",
        "function of",
        "functions of",
        "proportional to",
    ];
    if !display && related.iter().any(|words| text.trim_end().ends_with(words)) {
        return false;
    }
    let separators = ["", "and", "or", "&", "/"];
    let mut pieces = text.split('⟨');
    let first = pieces.next().map(str::trim);
    // "The momentum is ⟨L = …⟩ and the bench reads": the formula right behind is what it names.
    if text.contains('⟨') && matches!(first, Some("is" | "are")) {
        return false;
    }
    // "The angular velocity of ⟨B⟩ relative to ⟨A⟩ is": of two things, and then its letter.
    let last = text.rsplit('⟨').next().map(str::trim);
    let of_frames = first.is_some_and(|words| words.starts_with("of"))
        && has_any(text, &["relative to", "with respect to"])
        && matches!(last, Some("is" | "be"));
    if of_frames {
        return true;
    }
    let named = first.is_none_or(|between| matches!(between, "" | "s" | ":"));
    if display && !named {
        return true;
    }
    pieces.all(|between| {
        between
            .split_whitespace()
            .all(|word| separators.contains(&word.trim_end_matches(',')))
    })
}

/// Whether a sentence in small letters is about to list moments of inertia: "the principal moments at ⟨ are ".
pub(crate) fn lists_moments(sentence: &str) -> bool {
    has_any(sentence, &["moments of inertia", "principal moments"])
}

/// The quantity in words set right behind a letter: "and $\mathbf K$ the total torque".
pub(crate) fn apposition(text: &str, near: bool) -> Option<Quantity> {
    let text = text.strip_prefix(' ').filter(|_| near)?;
    let rest = ["the ", "its "]
        .iter()
        .find_map(|lead| text.strip_prefix(lead))?;
    let leads = [
        "total ",
        "resultant ",
        "external ",
        "net ",
        "components of the ",
        "components of its ",
    ];
    let rest = leads
        .iter()
        .find_map(|word| rest.strip_prefix(word))
        .unwrap_or(rest);
    let found = PHRASES
        .iter()
        .filter(|(phrase, _)| rest.starts_with(phrase.as_str()) && is_word(rest, 0, phrase));
    match found.max_by_key(|(phrase, _)| phrase.len())?.1 {
        Some(Quantity::Momentum) if is_in_wheels(rest) => Some(Quantity::RelativeMomentum),
        quantity => quantity,
    }
}

/// The quantity that the words right after a letter name: "is the angular momentum".
pub(crate) fn said_after(text: &str) -> Option<Quantity> {
    let text = text
        .trim_start()
        .trim_start_matches([',', ';'])
        .trim_start();
    let rest = [
        "is the ",
        "is its ",
        "are the ",
        "denotes the ",
        "denotes its ",
        "be the ",
        "be its ",
        "represents the ",
        "is called the ",
        "for the ",
    ]
    .iter()
    .find_map(|lead| text.strip_prefix(lead))?;
    named_first(behind_an_aside(rest), 30)
}

/// What stands behind words in brackets: "(constant, symmetric) inertia matrix".
fn behind_an_aside(text: &str) -> &str {
    let inside = text.strip_prefix('(').and_then(|rest| rest.split_once(')'));
    match inside {
        Some((aside, rest)) if aside.len() < 100 && !aside.contains('⟨') => rest.trim_start(),
        _ => text,
    }
}

/// Whether the words right after a letter call it the identity: "is the 3 × 3 identity matrix".
pub(crate) fn calls_identity(text: &str) -> bool {
    let words: Vec<&str> = text.split_whitespace().take(7).collect();
    let verb = words
        .first()
        .is_some_and(|w| matches!(*w, "is" | "denotes" | "the" | "being" | "for"));
    let article = words.iter().take(3).any(|w| *w == "the" || *w == "an");
    let named = words.iter().any(|w| {
        matches!(
            w.trim_end_matches(['.', ',', ';', ')']),
            "identity" | "unit"
        )
    });
    let matrix =
        text.contains("identity") || text.contains("unit matrix") || text.contains("unit tensor");
    verb && article && named && matrix
}

/// Whether the words before a letter name the unit matrix: "with the unit matrix ⟨E⟩".
pub(crate) fn names_the_identity(before: &str) -> bool {
    let names = [
        "unit matrix",
        "identity matrix",
        "unit tensor",
        "identity tensor",
    ];
    names.iter().any(|name| before.trim_end().ends_with(name))
}

/// The quantity that a text names first, so many bytes from its beginning at most.
pub(crate) fn named_first(rest: &str, within: usize) -> Option<Quantity> {
    let near = BOOK
        .places(rest)
        .take_while(|&(_, _, end)| end <= within + *LONGEST);
    let named = near.filter(|&(which, at, _)| at < within && is_word(rest, at, &PHRASES[which].0));
    let (which, at, _) = named.min_by_key(|&(_, at, end)| (at, std::cmp::Reverse(end)))?;
    match PHRASES[which].1 {
        Some(Quantity::Momentum) if is_in_wheels(&rest[at..]) => Some(Quantity::RelativeMomentum),
        quantity => quantity,
    }
}

/// "Angular momentum stored in the wheels".
fn is_in_wheels(text: &str) -> bool {
    let clause = text.split([',', ';', '.']).next().unwrap_or_default();
    let carried = [
        " in the ",
        " of the ",
        " of a ",
        " of one ",
        " in a ",
        " that the ",
        " which the ",
        " by the ",
    ];
    let part = |at: usize| {
        let rest = &clause[at..];
        WHEELS.iter().any(|w| {
            rest.split_whitespace()
                .take(5)
                .any(|word| word.starts_with(w))
        })
    };
    let whole = ["total", "whole", "with ", "and "];
    // "Of the wheels and ⟨": another thing.
    let own = clause.split(" and ⟨").next().unwrap_or_default();
    let own = own.strip_suffix(" and ").unwrap_or(own);
    !has_any(own, &whole)
        && carried
            .iter()
            .filter_map(|words| clause.find(words))
            .any(part)
}
