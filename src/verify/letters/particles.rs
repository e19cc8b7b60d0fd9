//! Which vector is the place of a particle in the sums over particles.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::Document;
use crate::verify::letters::usage::symbols;
use crate::verify::repair::lines;
use crate::verify::words::text::Text;

/// Letters of the place of a particle.
const PLACES: &[&str] = &["r", "rho", "R", "s", "x", "xi"];

/// The place of a particle of a body that the document calls rigid.
pub(crate) fn place_in_rigid_body(document: &Text) -> Option<Symbol> {
    let place = place_of_particle(document)?;
    document.lower().contains("rigid").then(|| place.clone())
}

/// Whether the words measure places from the mass centre.
pub(crate) fn measures_from_centre(text: &Text) -> bool {
    let from = [
        "measured from",
        "relative to",
        "measure from",
        "origin at",
        "origin in",
    ];
    let centre = ["mass cent", "centre of mass", "center of mass"];
    let mut sentences = text.lower().split(['.', ';']);
    text.says(&from)
        && sentences.any(|sentence| {
            let mut places = from.iter().filter_map(|words| sentence.split_once(words));
            places.any(|(_, behind)| {
                let near: String = behind.chars().take(24).collect();
                centre.iter().any(|words| near.contains(words))
            })
        })
}

/// The vector with the index of a sum over masses that is the place of a particle.
fn place_of_particle(document: &Document) -> Option<&Symbol> {
    fn within(node: &Node) -> Option<&Symbol> {
        let here = match &node.kind {
            Kind::IndexedSum { index, body, .. } => {
                let met = symbols(body);
                let own = |s: &Symbol| s.subscripts.as_slice() == [index.name.clone()];
                let mass = met.iter().any(|s| s.name == "m" && own(s));
                place_among(&met, &index.name).filter(|_| mass)
            }
            _ => None,
        };
        here.or_else(|| node.children().find_map(within))
    }
    lines(document)
        .flat_map(|line| &line.sides)
        .find_map(within)
}

/// The place of a particle among the symbols of a sum over an index.
pub(crate) fn place_among<'s>(met: &[&'s Symbol], index: &str) -> Option<&'s Symbol> {
    PLACES.iter().find_map(|name| {
        let place = |s: &&&Symbol| {
            s.name == *name
                && s.style.vector
                && matches!(s.subscripts.as_slice(), [i] if i == index)
        };
        met.iter().find(place).copied()
    })
}
