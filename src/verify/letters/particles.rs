//! Which vector is the place of a particle in the sums over particles.

use crate::notation::ast::{Kind, Node, Operator, Symbol};
use crate::notation::document::Document;
use crate::verify::letters::usage::{inner, symbols};
use crate::verify::words::book::has_any;
use crate::verify::words::text::Text;

/// Letters of the place of a particle.
pub(crate) const PLACES: &[&str] = &["r", "rho", "R", "s", "x", "xi"];

/// The place of a particle of a body that the document calls rigid.
pub(crate) fn place_in_rigid_body(document: &Text) -> Option<Symbol> {
    let place = place_of_particle(document)?;
    document.lower().contains("rigid").then(|| place.clone())
}

/// Words that measure a place from what stands behind them.
const FROM: [&str; 5] = [
    "measured from",
    "relative to",
    "measure from",
    "origin at",
    "origin in",
];
const CENTRE: [&str; 3] = ["mass cent", "centre of mass", "center of mass"];
/// What a place is called before "from ⟨G⟩".
const PLACE: [&str; 6] = ["position", "vector", "drawn", "vec", "bf", "boldsymbol"];

/// Whether the words measure places from the mass centre.
pub(crate) fn measures_from_centre(text: &Text) -> bool {
    let mut sentences = text.lower().split(['.', ';']);
    let by_words = text.says(&FROM)
        && sentences.any(|sentence| {
            let mut places = FROM.iter().filter_map(|words| sentence.split_once(words));
            places.any(|(_, behind)| {
                let near: String = behind.chars().take(24).collect();
                CENTRE.iter().any(|words| near.contains(words))
            })
        });
    by_words || text.says(&CENTRE) && measures_from_named_centre(&text.source.text)
}

/// "Whose mass centre ⟨G⟩ …, a particle at ⟨r⟩ from ⟨G⟩".
fn measures_from_named_centre(source: &str) -> bool {
    let plain = source.replace(['$', '(', ')', '\\'], "");
    let lower = plain.to_ascii_lowercase();
    let named = |words: &&str| {
        lower.match_indices(*words).find_map(|(at, _)| {
            let behind = &plain[at + words.len()..];
            let before = [" is the ", " be the ", " denotes the "]
                .iter()
                .find_map(|verb| plain[..at].strip_suffix(verb));
            let space = before.and_then(|before| before.rfind(' '));
            let subject = space.and_then(|space| letter_at(&before?[space..]));
            subject.or_else(|| letter_at(behind.trim_start_matches(char::is_alphabetic)))
        })
    };
    let Some(centre) = CENTRE.iter().find_map(named) else {
        return false;
    };
    let mut froms = plain.match_indices(" from ");
    froms.any(|(at, from)| {
        let before: String = plain[..at].chars().rev().take(24).collect();
        let before: String = before.chars().rev().collect();
        letter_at(&plain[at + from.len() - 1..]) == Some(centre)
            && has_any(&before, &PLACE)
            && !before.contains("distance")
    })
}

/// The capital that a text begins with behind a space, where it is a word by itself.
fn letter_at(text: &str) -> Option<char> {
    let mut characters = text.strip_prefix(' ')?.chars();
    let letter = characters.next().filter(char::is_ascii_uppercase)?;
    let ends = characters.next().is_none_or(|next| !next.is_alphanumeric());
    ends.then_some(letter)
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
            Kind::Integral {
                integrand,
                variable,
                ..
            } if matches!(&variable.kind, Kind::Symbol(s) if s.name == "m") => {
                place_of_element(integrand)
            }
            _ => None,
        };
        here.or_else(|| node.children().find_map(within))
    }
    document
        .lines()
        .flat_map(|line| &line.sides)
        .find_map(within)
}

/// The vector of the place of a mass element, which is crossed with something under an integral.
fn place_of_element(integrand: &Node) -> Option<&Symbol> {
    let crossed = |node: &Node| match &node.kind {
        Kind::Product(factors) => factors.iter().any(|f| f.operator == Operator::Cross),
        _ => false,
    };
    let here = crossed(inner(integrand)).then(|| symbols(integrand));
    let place = |s: &&Symbol| {
        PLACES.contains(&s.name.as_str()) && s.style.vector && s.subscripts.is_empty()
    };
    here?.into_iter().find(place)
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
