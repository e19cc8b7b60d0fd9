//! What words say of points: which is the mass centre, where it lies, how far it is, whether the body turns about another.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::usage::inner;
use crate::verify::words::book::has_any;

const CENTRES: &[&str] = &[
    "mass centre",
    "mass center",
    "centre of mass",
    "center of mass",
    "centroid",
    "centre of gravity",
    "center of gravity",
    "barycentre",
    "barycenter",
    "centre of inertia",
    "center of inertia",
];
/// Words between a name and what it names.
const NAMING: &[&str] = &[
    "at",
    "is",
    "be",
    "the",
    "point",
    "called",
    "its",
    "body's",
    "denotes",
    "denote",
    "by",
    "for",
    "a",
    "with",
    "coordinates",
];
/// What is said before or behind the coordinates of a point.
const PLACING: &[&str] = &[
    "coordinate",
    "position",
    "offset",
    "displace",
    "located",
    "lies at",
    "is at",
    "from",
];
/// What is said of a point that the body turns about.
const PIVOTS: &[&str] = &[
    "fixed point",
    "point fixed",
    "pivot",
    "hinge",
    "is fixed",
    "held fixed",
    "at rest",
    "pinned",
];

/// Whether a document calls a point by this label its mass centre.
pub(crate) fn called_centre(document: &Document, label: &str) -> bool {
    named(document, |node| lone(node).is_some_and(|s| s.name == label)).any(|(before, behind)| {
        let mut words: Vec<&str> = before.split_whitespace().collect();
        while words.last().is_some_and(|word| NAMING.contains(word)) {
            words.pop();
        }
        let lead = words.join(" ");
        let mut rest = behind.split_whitespace().peekable();
        let verb = rest
            .next_if(|w| matches!(*w, "is" | "be" | "denotes" | "denote" | "for"))
            .is_some();
        while rest.next_if(|w| NAMING.contains(w)).is_some() {}
        let rest: Vec<&str> = rest.collect();
        let rest = rest.join(" ");
        CENTRES
            .iter()
            .any(|c| lead.ends_with(c) || verb && rest.starts_with(c))
    })
}

/// Whether words call a symbol a distance: "at the distance d", "d is the distance".
pub(crate) fn calls_distance(document: &Document, symbol: &Symbol) -> bool {
    let by_formula = named(document, |node| lone(node) == Some(symbol)).any(|(before, behind)| {
        let lead = before.trim_end();
        let mut rest = behind
            .trim_start_matches(|c: char| !c.is_alphabetic())
            .split_whitespace();
        let mut said = rest.find(|word| !NAMING.contains(word));
        ["distance", "distance of", "distance is"]
            .iter()
            .any(|words| lead.ends_with(words))
            || said.take().is_some_and(|word| word.starts_with("distance"))
    });
    by_formula
        || prose(document).any(|text| {
            let name = symbol.name.to_lowercase();
            let mut words = text
                .split(|c: char| !c.is_alphanumeric())
                .filter(|w| !w.is_empty() && !NAMING.contains(w) && *w != "0");
            let words: Vec<&str> = words.by_ref().collect();
            let own = |word: &str| word == name || name == "ell" && word == "ℓ";
            words.windows(2).any(
                |pair| matches!(pair, [word, of] | [of, word] if *of == "distance" && own(word)),
            )
        })
}

/// Lists of three symbols that words call the place of a point, or that a vector is set equal to.
pub(crate) fn places(document: &Document, vector: &Option<Symbol>) -> Vec<[Symbol; 3]> {
    let said = named(document, |node| triple(node).is_some());
    let placed = said.filter(|(before, behind)| {
        let near = |text: &str| has_any(text, PLACING);
        near(before) || near(behind)
    });
    let lists = placed.map(|(before, _)| before.len());
    let spoken = lists.count() > 0;
    let mut found = vec![];
    for item in &document.items {
        let Item::Formula(formula) = item else {
            continue;
        };
        for row in &formula.rows {
            match row {
                Row::Expression(node) if spoken => found.extend(triple(node)),
                Row::Line(line) => {
                    let same = |node: &Node| {
                        lone(node).is_some_and(|s| {
                            vector
                                .as_ref()
                                .is_none_or(|v| v.name == s.name && v.subscripts == s.subscripts)
                        })
                    };
                    if line.sides.iter().any(same) {
                        found.extend(line.sides.iter().filter_map(triple));
                    }
                }
                _ => {}
            }
        }
    }
    found
}

/// Whether the words speak of a point that the body turns about.
pub(crate) fn holds_still(document: &Document) -> bool {
    prose(document).any(|text| has_any(&text, PIVOTS))
}

fn prose(document: &Document) -> impl Iterator<Item = String> {
    document.items.iter().filter_map(|item| match item {
        Item::Prose { text, .. } => Some(text.to_lowercase().replace('\n', " ")),
        _ => None,
    })
}

/// The words before and behind each lone expression of some kind, within their sentence.
fn named<'d>(
    document: &'d Document,
    wanted: impl Fn(&Node) -> bool + 'd,
) -> impl Iterator<Item = (String, String)> + 'd {
    let items = &document.items;
    let text = |at: Option<usize>| match at.and_then(|at| items.get(at)) {
        Some(Item::Prose { text, .. }) => text.to_lowercase().replace('\n', " "),
        _ => String::new(),
    };
    items.iter().enumerate().filter_map(move |(at, item)| {
        let Item::Formula(formula) = item else {
            return None;
        };
        let [Row::Expression(node)] = formula.rows.as_slice() else {
            return None;
        };
        wanted(node).then_some(())?;
        let (before, behind) = (text(at.checked_sub(1)), text(Some(at + 1)));
        let lead = before.rsplit(". ").next().unwrap_or_default().to_owned();
        let rest = behind.split(". ").next().unwrap_or_default().to_owned();
        Some((lead, rest))
    })
}

/// The symbol that a node is.
pub(crate) fn lone(node: &Node) -> Option<&Symbol> {
    match &inner(node).kind {
        Kind::Symbol(symbol) => Some(symbol),
        _ => None,
    }
}

/// The symbols of a list, a column or a sum along three unit vectors.
fn triple(node: &Node) -> Option<[Symbol; 3]> {
    let entries: Vec<&Node> = match &inner(node).kind {
        Kind::Tuple(entries) => entries.iter().collect(),
        Kind::Matrix(rows) if rows.len() == 1 || rows.iter().all(|row| row.len() == 1) => {
            rows.iter().flatten().collect()
        }
        Kind::Transpose(inside) => return triple(inside),
        _ => return None,
    };
    let all: Vec<Symbol> = entries.into_iter().filter_map(lone).cloned().collect();
    let distinct = all.iter().enumerate().all(|(i, s)| !all[..i].contains(s));
    <[Symbol; 3]>::try_from(all).ok().filter(|_| distinct)
}
