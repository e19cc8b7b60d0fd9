//! What words say of points: which is the mass centre, where it lies, how far it is, whether the body turns about another.

use crate::notation::ast::{Kind, Node, Number, Symbol};
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::words::book::has_any;
use num_rational::BigRational;

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
        let clause = lead.rsplit(',').next().unwrap_or_default();
        let between = ["distance between", "distance of", "distance from"]
            .iter()
            .any(|words| clause.contains(words));
        ["distance", "distance of", "distance is"]
            .iter()
            .any(|words| lead.ends_with(words))
            || between
                && [" is", " be", " called"]
                    .iter()
                    .any(|verb| clause.ends_with(verb))
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

/// Whether words call a letter a unit vector: "let ⟨c⟩ be the unit vector towards the Earth".
pub(crate) fn called_unit(document: &Document, letter: &Letter) -> bool {
    let own = |node: &Node| lone(node).is_some_and(|s| Letter::of(s) == *letter);
    named(document, own).any(|(before, behind)| {
        let mut rest = behind.split_whitespace().filter(|w| !NAMING.contains(w));
        let next = [rest.next(), rest.next()];
        before.trim_end().ends_with("unit vector")
            || next[0] == Some("unit") && next[1].is_some_and(|w| w.starts_with("vector"))
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

/// The place of the mass centre where words give it by three expressions: "the vector from ⟨O⟩ to ⟨G⟩ has the components
/// ⟨a/2⟩, ⟨b/2⟩, ⟨0⟩", "the centre of mass is at ⟨(a/2, b/2, 0)⟩".
pub(crate) fn place_in_words(document: &Document, centre: &str) -> Option<[Node; 3]> {
    let items = &document.items;
    let alone = |at: usize| match items.get(at) {
        Some(Item::Formula(formula)) if !formula.display => match formula.rows.as_slice() {
            [Row::Expression(node)] => Some(node),
            _ => None,
        },
        _ => None,
    };
    let joins = |at: usize| match items.get(at) {
        Some(Item::Prose { text, .. }) => matches!(text.trim(), "," | "and" | ", and"),
        _ => false,
    };
    let listed = |at: usize| {
        let all = [alone(at)?, alone(at + 2)?, alone(at + 4)?];
        (joins(at + 1) && joins(at + 3)).then(|| all.map(Node::clone))
    };
    let called = (1..items.len()).find_map(|at| {
        let Some(Item::Prose { text, .. }) = items.get(at - 1) else {
            return None;
        };
        let text = text.to_lowercase().replace('\n', " ");
        let lead = text.trim_end();
        let called = [
            "components",
            "coordinates",
            "position",
            "located at",
            "lies at",
            "is at",
            "at the point",
        ]
        .iter()
        .any(|words| lead.ends_with(words));
        let place = expressions(alone(at)?).or_else(|| listed(at))?;
        (called && speaks_of_centre(items, at, centre)).then_some(place)
    });
    called.or_else(|| place_of_new_axes(items))
}

/// The mass centre as it is seen from axes that words move away from it: "move the axes to the corner at ⟨x = a⟩, ⟨y = b⟩"
/// put it at −a, −b.
fn place_of_new_axes(items: &[Item]) -> Option<[Node; 3]> {
    let coordinate = |item: Option<&Item>| match item {
        Some(Item::Formula(formula)) if !formula.display => match formula.rows.as_slice() {
            [Row::Line(line)] => match line.sides.as_slice() {
                [left, right] => {
                    let symbol = lone(left).filter(|s| s.subscripts.is_empty())?;
                    let place = ["x", "y", "z"].iter().position(|c| *c == symbol.name)?;
                    Some((place, right.clone()))
                }
                _ => None,
            },
            _ => None,
        },
        _ => None,
    };
    items.iter().enumerate().find_map(|(at, item)| {
        let Item::Prose { text, .. } = item else {
            return None;
        };
        let text = text.to_lowercase().replace('\n', " ");
        let sentence = text.rsplit(". ").next().unwrap_or_default();
        let moved = [
            "move the axes",
            "shift the axes",
            "axes are moved",
            "axes are shifted",
        ];
        if !has_any(sentence, &moved) || !sentence.trim_end().ends_with("at") {
            return None;
        }
        let first = coordinate(items.get(at + 1))?;
        let zero = Node {
            kind: Kind::Number(Number {
                value: BigRational::default(),
                decimals: None,
                exponent: 0,
            }),
            span: first.1.span,
        };
        let mut place = [zero.clone(), zero.clone(), zero];
        for next in [1, 3, 5] {
            let Some((axis, value)) = coordinate(items.get(at + next)) else {
                break;
            };
            place[axis] = Node {
                span: value.span,
                kind: Kind::Negate(Box::new(value)),
            };
        }
        Some(place)
    })
}

/// Whether the sentence before a place has the mass centre in it, by its words or its letter.
fn speaks_of_centre(items: &[Item], at: usize, centre: &str) -> bool {
    for item in items[..at].iter().rev() {
        match item {
            Item::Prose { text, .. } => {
                let text = text.to_lowercase().replace('\n', " ");
                let (end, rest) = match text.rsplit_once(". ") {
                    Some((_, rest)) => (true, rest),
                    None => (false, text.as_str()),
                };
                if CENTRES.iter().any(|words| rest.contains(words)) {
                    return true;
                }
                if end {
                    return false;
                }
            }
            Item::Formula(formula) => {
                let own = |row: &Row| match row {
                    Row::Expression(node) => lone(node).is_some_and(|s| s.name == centre),
                    _ => false,
                };
                if formula.rows.iter().any(own) {
                    return true;
                }
            }
            _ => return false,
        }
    }
    false
}

/// The three expressions of a list or a column.
fn expressions(node: &Node) -> Option<[Node; 3]> {
    let entries: Vec<Node> = match &inner(node).kind {
        Kind::Tuple(entries) => entries.clone(),
        Kind::Matrix(rows) if rows.len() == 1 || rows.iter().all(|row| row.len() == 1) => {
            rows.iter().flatten().cloned().collect()
        }
        Kind::Transpose(inside) => return expressions(inside),
        _ => return None,
    };
    entries.try_into().ok()
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

/// The words before and behind each lone expression of some kind, or left side of a line in the text, within their sentence.
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
        // "The distance is ⟨d = a/2⟩" names d as well.
        let node = match formula.rows.as_slice() {
            [Row::Expression(node)] => node,
            [Row::Line(line)] if !formula.display => line.sides.first()?,
            _ => return None,
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
