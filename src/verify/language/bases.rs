//! "z points from O to the centre of the base", where O is the apex of the cone: z is its axis of symmetry.

use super::rewrite::put_in;
use super::words::{Kind, Token};
use std::collections::BTreeMap;

/// Verbs of what a line does between two points.
const LEADS: [&str; 5] = ["points", "runs", "goes", "leads", "extends"];

/// Names the axis in the place of the way from the apex to the base.
pub(super) fn name_axes_to_bases<E>(sentences: &mut [Result<Vec<Token>, E>]) {
    let mut apexes: BTreeMap<String, Vec<Token>> = BTreeMap::new();
    for tokens in sentences.iter().flatten() {
        if let [point, is, the, apex, of, whose @ ..] = tokens.as_slice()
            && [is, the, apex, of].map(|t| t.lower.as_str()) == ["is", "the", "apex", "of"]
            && let [_, noun] = whose
            && noun.kind == Kind::Word
        {
            apexes.insert(point.text.clone(), whose.to_vec());
        }
    }
    for tokens in sentences.iter_mut().flatten() {
        if let Some(said) = axis_to_base(tokens, &apexes) {
            *tokens = said;
        }
    }
}

/// "z is the axis of symmetry of the cone"
fn axis_to_base(tokens: &[Token], apexes: &BTreeMap<String, Vec<Token>>) -> Option<Vec<Token>> {
    let [axis, leads, from, apex, to, the, middle, of, its, base] = tokens else {
        return None;
    };
    let words = [from, to, the, of, base].map(|t| t.lower.as_str());
    let way = matches!(
        words,
        ["from", "to" | "towards" | "toward", "the", "of", "base"]
    );
    let middle = matches!(middle.lower.as_str(), "centre" | "center" | "middle");
    let own = matches!(its.lower.as_str(), "the" | "its");
    let whose = apexes.get(&apex.text)?;
    if !way || !middle || !own || !LEADS.contains(&leads.lower.as_str()) {
        return None;
    }
    let words = ["is", "the", "axis", "of", "symmetry", "of"];
    let words = words.map(|word| put_in(Kind::Word, word, leads));
    Some([std::slice::from_ref(axis), &words, whose].concat())
}
