//! What the words of a document say of its attitude: which way the matrix and the quaternion go, and on which axes the
//! angular velocity stands.

use crate::notation::document::Document;
use crate::verify::words::book::has_any;
use crate::verify::words::sentences::{self, Paragraphs};

/// A sentence in lower case, each formula of one symbol as `⟨name⟩`, every other as `⟨⟩`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sentence {
    /// Its words.
    pub text: String,
    /// The lone symbols in it, in their own case.
    pub letters: Vec<String>,
}

/// Which way components are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Way {
    /// From the body to space.
    ToSpace,
    /// From space to the body.
    ToBody,
}

/// Words for axes of fixed orientation.
pub(crate) const SPACE: &[&str] = &[
    "space",
    "spatial",
    "inertial",
    "world",
    "lab ",
    "laboratory",
    "global",
    "fixed frame",
    "fixed axes",
    "earth",
    "ground",
    "reference frame",
];

/// The sentences of a document, those with nothing in them left out.
pub(crate) fn sentences(document: &Document) -> Vec<Sentence> {
    named(&sentences::sentences(document, Paragraphs::Apart))
}

/// The same of sentences that were found.
pub(crate) fn named(all: &[sentences::Sentence]) -> Vec<Sentence> {
    let spoken = all.iter().map(|sentence| Sentence {
        text: sentence.named(),
        letters: sentence.symbols().map(|(s, _)| s.name.clone()).collect(),
    });
    spoken.filter(|s| !s.text.trim().is_empty()).collect()
}

/// Which way a sentence says that something goes, if it does.
///
/// "Takes body components to space components" goes to space; "rotates the space axes into the body axes" does not say
/// where components go, and so says nothing here.
pub(crate) fn way(text: &str) -> Option<Way> {
    if !text.contains("body") {
        return None;
    }
    let text = text
        .replace("relative to", "against")
        .replace("with respect to", "against");
    if text.contains("column") {
        return Some(Way::ToSpace);
    }
    if text.contains(" rows") {
        return Some(Way::ToBody);
    }
    let verb = [
        "takes",
        "take ",
        "turns",
        "maps",
        "transforms",
        "rotates",
        "converts",
        "carries",
        "brings",
        "from ",
        "resolves",
    ];
    let start = verb.iter().filter_map(|v| text.find(v)).min()?;
    let rest = &text[start..];
    let of_axes = rest.starts_with("rotat") || rest.starts_with("turn") || rest.starts_with("carr");
    let components = ["component", "coordinate", "vector", "resolved", "expressed"];
    if of_axes && !has_any(rest, &components) {
        return None;
    }
    let body = rest.find("body")?;
    let space = SPACE.iter().filter_map(|word| rest.find(word)).min()?;
    let between = &rest[body.min(space)..body.max(space)];
    if !has_any(between, &[" to ", " into ", " to\n", "-to-", " onto "]) {
        return None;
    }
    Some(if body < space {
        Way::ToSpace
    } else {
        Way::ToBody
    })
}

/// Whether a sentence says that the angular velocity, as the letter stands, has its components on space axes (`true`) or
/// on the body's (`false`).
pub(crate) fn rate_in_space(text: &str) -> Option<bool> {
    let says = |words: &[&str]| has_any(text, words);
    if !says(&["angular velocity", "body rate", "⟨omega⟩", "⟨ω⟩"]) {
        return None;
    }
    let resolved = says(&[
        "component",
        "resolved",
        "expressed",
        "written",
        "spatial angular velocity",
        "axes",
        "coordinates",
        "body rate",
        "⟨omega⟩ in world",
        "⟨omega⟩ in the world",
        "⟨omega⟩ in space",
        "⟨omega⟩ in the inertial",
    ]);
    // "⟨R⟩ takes body components to space components, ⟨ω⟩ is on space axes": its own clause says it.
    let own = |clause: &&str| has_any(clause, &["⟨omega⟩", "⟨ω⟩"]);
    let clause = text.split([',', ';']).find(own).unwrap_or(text);
    let alone = clause.contains("axes") && has_any(clause, SPACE) && !clause.contains("body");
    match (text.contains("body"), says(SPACE)) {
        _ if !resolved => None,
        (true, true) if alone => Some(true),
        (true, _) => Some(false),
        (false, true) => Some(true),
        _ => None,
    }
}
