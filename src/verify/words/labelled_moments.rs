//! The two moments of a body with an axis of symmetry, told by labels alone: `I_s` and `I_t`, `I_\parallel` and `I_\perp`.

use crate::notation::document::{Document, Item};
use crate::source::Span;
use crate::verify::letters::two_points::every_symbol;
use crate::verify::letters::usage::Letter;
use crate::verify::words::book::{has_any, lowered};
use crate::verify::words::moments_in_words::NamedMoment;
use crate::verify::words::symmetric_body::AXIS_OF_SYMMETRY;
use std::collections::BTreeSet;

const AXIAL: &[&str] = &["s", "a", "ax", "axial", "par", "parallel", "∥", "p"];
const TRANSVERSE: &[&str] = &["t", "tr", "trans", "perp", "⊥", "d"];
/// Words for a round body, beside those for an axis of symmetry.
const ROUND: &[&str] = &["diameter", "diametral", "polar moment"];

/// The moments of a letter that has just one label of each kind, where the words speak of the axis of symmetry.
pub(crate) fn labelled_moments(document: &Document) -> Option<Vec<NamedMoment>> {
    let said = document.items.iter().any(|item| match item {
        Item::Prose { text, .. } | Item::Heading { text, .. } => {
            let text = lowered(text);
            has_any(&text, AXIS_OF_SYMMETRY) || has_any(&text, ROUND)
        }
        _ => false,
    });
    if !said {
        return None;
    }
    let all = every_symbol(document);
    ["I", "J"].into_iter().find_map(|name| {
        let letter = Letter::plain(name);
        let own = all.iter().filter(|s| Letter::of(s) == letter);
        let met: BTreeSet<&[String]> = own.map(|s| s.subscripts.as_slice()).collect();
        let with = |labels: &[&str]| {
            let mut found = met
                .iter()
                .filter(|all| matches!(all, [one] if labels.contains(&one.as_str())));
            found.next().filter(|_| met.len() == 2)
        };
        let (axial, transverse) = (with(AXIAL)?, with(TRANSVERSE)?);
        let moment = |subscripts: &[String], components: Vec<u8>| {
            let symbol = all
                .iter()
                .find(|s| Letter::of(s) == letter && s.subscripts == subscripts)?;
            Some(NamedMoment {
                symbol: (*symbol).clone(),
                components,
                span: Span::default(),
            })
        };
        Some(vec![
            moment(transverse, vec![0, 1])?,
            moment(axial, vec![2])?,
        ])
    })
}
