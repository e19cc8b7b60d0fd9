//! What words call a quantity, and where they stand beside a letter.

use crate::verify::quantity::Quantity;

/// Phrases and what they name; the longer stand before the shorter.
const PHRASES: &[(&str, Option<Quantity>)] = &[
    ("moment of momentum", Some(Quantity::Momentum)),
    (
        "relative angular momentum",
        Some(Quantity::RelativeMomentum),
    ),
    ("relative momentum", Some(Quantity::RelativeMomentum)),
    ("wheel momentum", Some(Quantity::RelativeMomentum)),
    ("rotor momentum", Some(Quantity::RelativeMomentum)),
    ("wheel angular momentum", Some(Quantity::RelativeMomentum)),
    ("momentum of the wheel", Some(Quantity::RelativeMomentum)),
    ("momentum of the rotor", Some(Quantity::RelativeMomentum)),
    ("momentum of the flywheel", Some(Quantity::RelativeMomentum)),
    ("angular momentum", Some(Quantity::Momentum)),
    ("momentum", Some(Quantity::Momentum)),
    ("linear momentum", Some(Quantity::LinearMomentum)),
    ("extra momentum", Some(Quantity::RelativeMomentum)),
    ("kinetic energy", Some(Quantity::Energy)),
    ("rotational energy", Some(Quantity::Energy)),
    ("energy", Some(Quantity::Energy)),
    ("products of inertia", Some(Quantity::Inertia)),
    ("product of inertia", Some(Quantity::Inertia)),
    ("moments of inertia", Some(Quantity::Inertia)),
    ("moment of inertia", Some(Quantity::Inertia)),
    ("principal moments", Some(Quantity::Inertia)),
    ("inertia matrix", Some(Quantity::Inertia)),
    ("inertia tensor", Some(Quantity::Inertia)),
    ("angular acceleration", Some(Quantity::AngularAcceleration)),
    ("precession rate", None),
    ("body rates", Some(Quantity::AngularVelocity)),
    ("angular velocity of the axes", Some(Quantity::FrameRate)),
    ("angular velocity of the frame", Some(Quantity::FrameRate)),
    ("turns with angular velocity", Some(Quantity::FrameRate)),
    ("turns with the angular velocity", Some(Quantity::FrameRate)),
    ("turns with an angular velocity", Some(Quantity::FrameRate)),
    ("turn with angular velocity", Some(Quantity::FrameRate)),
    ("turn with the angular velocity", Some(Quantity::FrameRate)),
    ("turn with an angular velocity", Some(Quantity::FrameRate)),
    ("rotates with angular velocity", Some(Quantity::FrameRate)),
    (
        "rotates with the angular velocity",
        Some(Quantity::FrameRate),
    ),
    (
        "rotates with an angular velocity",
        Some(Quantity::FrameRate),
    ),
    ("rotate with angular velocity", Some(Quantity::FrameRate)),
    (
        "rotate with the angular velocity",
        Some(Quantity::FrameRate),
    ),
    ("rotate with an angular velocity", Some(Quantity::FrameRate)),
    ("rotating with angular velocity", Some(Quantity::FrameRate)),
    (
        "rotating with the angular velocity",
        Some(Quantity::FrameRate),
    ),
    (
        "rotating with an angular velocity",
        Some(Quantity::FrameRate),
    ),
    ("turning with angular velocity", Some(Quantity::FrameRate)),
    (
        "turning with the angular velocity",
        Some(Quantity::FrameRate),
    ),
    (
        "turning with an angular velocity",
        Some(Quantity::FrameRate),
    ),
    ("angular velocity", Some(Quantity::AngularVelocity)),
    ("torque", Some(Quantity::Moment)),
    ("moment", Some(Quantity::Moment)),
    ("couple", Some(Quantity::Moment)),
    ("force", Some(Quantity::Force)),
    ("mass centre", None),
    ("mass center", None),
    ("power", Some(Quantity::Power)),
];

/// Whether a phrase that stands at a place is whole words, a plural included: not the "moment" of "momentum".
fn is_word(text: &str, at: usize, phrase: &str) -> bool {
    let letter = |c: Option<char>| c.is_some_and(char::is_alphabetic);
    let rest = &text[at + phrase.len()..];
    let rest = rest.strip_prefix('s').unwrap_or(rest);
    !letter(text[..at].chars().next_back()) && !letter(rest.chars().next())
}

/// The single letters that a text names right after such a phrase: "moments A, A, C", with the phrase's quantity.
pub(super) fn letters_named(text: &str) -> Vec<(String, Quantity)> {
    let lower = text.to_lowercase();
    let mut named = vec![];
    if lower.len() != text.len() {
        return named;
    }
    for (phrase, quantity) in PHRASES {
        let Some(quantity) = quantity else { continue };
        for (at, _) in lower.match_indices(phrase) {
            if !is_word(&lower, at, phrase) || !text.is_char_boundary(at + phrase.len()) {
                continue;
            }
            let rest = text[at + phrase.len()..].trim_start_matches('s');
            let words = rest
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
    }
    named
}

/// The quantity that the words before a formula name, where they come close to it.
pub(super) fn said_before(text: &str) -> Option<Quantity> {
    let near = |(phrase, quantity): &(&str, Option<Quantity>)| {
        let at = text
            .rmatch_indices(phrase)
            .find(|&(at, _)| is_word(text, at, phrase))?
            .0;
        Some((at + phrase.len(), phrase.len(), *quantity))
    };
    let (end, _, quantity) = PHRASES
        .iter()
        .filter_map(near)
        .max_by_key(|&(end, len, _)| (end, len))?;
    (text.len() - end < 60).then_some(quantity)?
}

/// The quantity in words set right behind a letter: "and $\mathbf K$ the total torque".
pub(super) fn apposition(text: &str, near: bool) -> Option<Quantity> {
    let text = text.strip_prefix(' ').filter(|_| near)?;
    let rest = ["the ", "its "]
        .iter()
        .find_map(|lead| text.strip_prefix(lead))?;
    let rest = ["total ", "resultant ", "external ", "net "]
        .iter()
        .find_map(|word| rest.strip_prefix(word))
        .unwrap_or(rest);
    let found = PHRASES
        .iter()
        .filter(|(phrase, _)| rest.starts_with(phrase) && is_word(rest, 0, phrase));
    found.max_by_key(|(phrase, _)| phrase.len())?.1
}

/// The quantity that the words right after a letter name: "is the angular momentum".
pub(super) fn said_after(text: &str) -> Option<Quantity> {
    let text = text
        .trim_start()
        .trim_start_matches([',', ';'])
        .trim_start();
    let rest = [
        "is the ",
        "is its ",
        "are the ",
        "denotes the ",
        "be the ",
        "represents the ",
        "is called the ",
        "for the ",
    ]
    .iter()
    .find_map(|lead| text.strip_prefix(lead))?;
    let near = |(phrase, quantity): &(&str, Option<Quantity>)| {
        let at = rest
            .match_indices(phrase)
            .find(|&(at, _)| is_word(rest, at, phrase))?
            .0;
        (at < 30).then_some((at, std::cmp::Reverse(phrase.len()), *quantity))
    };
    PHRASES
        .iter()
        .filter_map(near)
        .min_by_key(|&(at, len, _)| (at, len))?
        .2
}
