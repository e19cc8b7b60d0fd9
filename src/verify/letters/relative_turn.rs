//! Which of two frames turns, where words say that one has an angular velocity relative to the other.

use crate::notation::document::Document;
use crate::verify::letters::frame::label_of;
use crate::verify::words::book::has_any;
use crate::verify::words::sentences::{Paragraphs, Sentence, sentences};
use std::collections::BTreeSet;

const TURNS: &[&str] = &["angular velocity", "turn", "rotat", "spin", "revolv"];
const RELATIVE: &[&str] = &[
    "relative to",
    "with respect to",
    "as seen from",
    "seen from",
];
/// What may stand between these words and the letter of the frame.
const NOUNS: &[&str] = &["the", "frame", "axes", "system"];

/// "The angular velocity of $F$ relative to $H$": the labels F, which turns, and H, of two labels that are written.
pub(crate) fn turning_and_still(
    document: &Document,
    written: &BTreeSet<String>,
) -> Option<(String, String)> {
    if written.len() != 2 {
        return None;
    }
    let all = sentences(document, Paragraphs::Joined);
    all.iter()
        .find_map(|sentence| in_sentence(sentence, written))
}

fn in_sentence(sentence: &Sentence, written: &BTreeSet<String>) -> Option<(String, String)> {
    let labels: Vec<String> = sentence.symbols().map(|(s, _)| label_of(s)).collect();
    let text = sentence.numbered();
    (0..labels.len()).find_map(|n| {
        let still = written.get(&labels[n])?;
        let turning = written.iter().find(|label| *label != still)?;
        let (before, _) = text.split_once(&format!("⟨{n}⟩"))?;
        let mut lead = before.trim_end();
        while let Some(less) = NOUNS.iter().find_map(|noun| lead.strip_suffix(noun)) {
            lead = less.trim_end();
        }
        let lead = RELATIVE.iter().find_map(|words| lead.strip_suffix(words))?;
        let earlier = labels[..n].contains(turning);
        (earlier && has_any(lead, TURNS)).then(|| (turning.clone(), still.clone()))
    })
}
