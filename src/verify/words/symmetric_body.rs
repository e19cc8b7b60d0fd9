//! Bodies with two equal moments of inertia, of which a document writes one: "the moments I₁, I₁, I₃", a matrix
//! diag(I₁, I₁, I₃), a symmetric top whose I₂ is nowhere.

use crate::notation::ast::{Function, Kind, Node, Symbol};
use crate::notation::document::{Document, Item, Row};
use crate::source::Span;
use crate::verify::letters::usage::{Letter, Usage, inner, symbols};
use crate::verify::words::book::{Book, has_any, lowered};
use crate::verify::words::labelled_moments::labelled_moments;
use crate::verify::words::moments_in_words::NamedMoment;
use std::sync::LazyLock;

/// Letters of moments of inertia.
const MOMENTS: &[&str] = &["I", "J", "A", "B", "C", "Theta", "lambda"];
/// Words for a body with an axis of symmetry.
pub(crate) const AXIS_OF_SYMMETRY: &[&str] = &[
    "symmetric about",
    "symmetrical about",
    "axis of symmetry",
    "symmetry axis",
    "axially symmetric",
    "axisymmetric",
    "body of revolution",
    "solid of revolution",
    "symmetric top",
    "symmetrical top",
];
/// Other words of which a body with two equal moments is told.
const TWO_EQUAL: &[&str] = &[
    "symmetric body",
    "symmetrical body",
    "symmetric rotor",
    "symmetric gyro",
    "rotational symmetry",
    "rotationally symmetric",
    "axial symmetry",
    "axi-symmetric",
    "of revolution",
    "heavy top",
    "spinning top",
    "two equal",
    "transverse",
    "equatorial",
    "oblate",
    "prolate",
    "spheroid",
    "cylinder",
    "circular disk",
    "circular disc",
];
static SYMMETRIC: LazyLock<Book> =
    LazyLock::new(|| Book::of(AXIS_OF_SYMMETRY.iter().chain(TWO_EQUAL)));

/// The moments that stand for several components, each with those.
pub(crate) fn equal_moments(document: &Document, usage: &Usage) -> Vec<NamedMoment> {
    listed(document, usage)
        .or_else(|| labelled_moments(document))
        .or_else(|| unwritten(document, usage).map(|moment| vec![moment]))
        .unwrap_or_default()
}

/// Three moments in a row of which two are one: a list behind the word, a tuple, a diagonal.
fn listed(document: &Document, usage: &Usage) -> Option<Vec<NamedMoment>> {
    let mut run: Vec<(&Symbol, Span)> = vec![];
    let mut named = false;
    for item in &document.items {
        match item {
            Item::Prose { text, .. } => {
                let joins = matches!(text.trim(), "," | "and" | ", and");
                if !joins {
                    run.clear();
                    let text = text.to_lowercase();
                    let clause = text.rsplit(['.', ';']).next().unwrap_or_default();
                    let of_inertia = has_any(clause, &["principal moments", "inertia"]);
                    named =
                        clause.contains("moments") && (of_inertia || !clause.contains("torque"));
                }
            }
            Item::Formula(formula) => {
                for row in &formula.rows {
                    let nodes: Vec<&Node> = match row {
                        Row::Line(line) => line.sides.iter().collect(),
                        Row::Expression(node) => vec![node],
                        Row::Unreadable { .. } => vec![],
                    };
                    let found = nodes.iter().find_map(|node| diagonal(node));
                    if found.is_some() && !slips(found.iter().flatten(), document, usage) {
                        return found;
                    }
                    let lone = match nodes.as_slice() {
                        [node] if !matches!(row, Row::Line(_)) && named => list(node),
                        _ => vec![],
                    };
                    run.extend(lone.iter().map(|symbol| (*symbol, formula.span)));
                }
                if let Some(found) = row_of_three(&run) {
                    return Some(found);
                }
            }
            Item::Comment { .. } => {}
            Item::Heading { .. } | Item::Break => run.clear(),
        }
    }
    None
}

/// Whether the third moment, whose place one of two on a diagonal takes, is written elsewhere, and nothing says that
/// two are equal: that is a slip of the pen.
fn slips<'m>(
    mut moments: impl Iterator<Item = &'m NamedMoment>,
    document: &Document,
    usage: &Usage,
) -> bool {
    let Some(pair) = moments.find(|moment| moment.components.len() == 2) else {
        return false;
    };
    let [index] = pair.symbol.subscripts.as_slice() else {
        return false;
    };
    let all = [["1", "2", "3"], ["x", "y", "z"], ["xx", "yy", "zz"]];
    let Some(indices) = all.iter().find(|indices| indices.contains(&index.as_str())) else {
        return false;
    };
    let of_pair = |other: &&str| {
        pair.components
            .iter()
            .any(|&c| indices[usize::from(c)] == *other)
    };
    let Some(other) = indices
        .iter()
        .copied()
        .filter(of_pair)
        .find(|other| other != index)
    else {
        return false;
    };
    let letter = Letter::of(&pair.symbol);
    let lone = |side: &Node, index: &str| matches!(&inner(side).kind, Kind::Symbol(s) if Letter::of(s) == letter && s.subscripts == [index]);
    let equal = |item: &Item| match item {
        Item::Formula(formula) => formula.rows.iter().any(|row| {
            let sides = match row {
                Row::Line(line) => line.sides.as_slice(),
                _ => &[],
            };
            [index, other]
                .iter()
                .all(|index| sides.iter().any(|side| lone(side, index)))
        }),
        Item::Prose { text, .. } | Item::Heading { text, .. } => SYMMETRIC.is_in(&lowered(text)),
        _ => false,
    };
    usage.has_index(&letter, other) && !document.items.iter().any(equal)
}

/// The symbols of a list, or the one that a node is.
fn list(node: &Node) -> Vec<&Symbol> {
    match &inner(node).kind {
        Kind::Symbol(symbol) => vec![symbol],
        Kind::Tuple(entries) => entries.iter().flat_map(list).collect(),
        _ => vec![],
    }
}

/// `diag(a, a, c)`, or a matrix with a, a, c on its diagonal and zeros beside it.
fn diagonal(node: &Node) -> Option<Vec<NamedMoment>> {
    let found = match &node.kind {
        Kind::Function(Function::Diag, inside) => list(inside),
        Kind::Matrix(rows) if rows.len() == 3 && rows.iter().all(|row| row.len() == 3) => {
            let entries = rows.iter().enumerate().flat_map(|(r, row)| {
                let row = row.iter().enumerate();
                row.map(move |(c, entry)| (r == c, entry))
            });
            let (on, off): (Vec<_>, Vec<_>) = entries.partition(|(on, _)| *on);
            match off.iter().all(|(_, entry)| symbols(entry).is_empty()) {
                true => on.into_iter().flat_map(|(_, entry)| list(entry)).collect(),
                false => vec![],
            }
        }
        _ => vec![],
    };
    let run: Vec<(&Symbol, Span)> = found.into_iter().map(|s| (s, node.span)).collect();
    let own = row_of_three(&run);
    own.or_else(|| node.children().find_map(diagonal))
}

/// Each of three symbols with its places, where two of them are one and the last or the first stands apart.
fn row_of_three(run: &[(&Symbol, Span)]) -> Option<Vec<NamedMoment>> {
    let [first, second, third] = run else {
        return None;
    };
    let moment = |s: &Symbol| MOMENTS.contains(&s.name.as_str()) && !s.style.vector;
    if !run.iter().all(|(symbol, _)| moment(symbol)) {
        return None;
    }
    let places = match (first.0 == second.0, second.0 == third.0) {
        (true, false) => [(first, vec![0, 1]), (third, vec![2])],
        (false, true) => [(first, vec![0]), (second, vec![1, 2])],
        _ => return None,
    };
    let named = places.map(|(&(symbol, span), components)| NamedMoment {
        symbol: symbol.clone(),
        components,
        span,
    });
    Some(named.to_vec())
}

/// Of a body that words call symmetric, the moment whose equal is nowhere written: I₁ and I₃, and no I₂.
fn unwritten(document: &Document, usage: &Usage) -> Option<NamedMoment> {
    let (letter, equal) = ["I", "J"].into_iter().find_map(|name| {
        let letter = Letter::plain(name);
        let met = usage.subscripts.get(&letter)?;
        let has = |index: &str| met.contains(index);
        let numbered = has("1") && has("3") && !has("2");
        let lettered = has("x") && has("z") && !has("y");
        let double = met.iter().any(|s| s.chars().count() == 2);
        let index = if numbered { "1" } else { "x" };
        ((numbered || lettered) && !double).then_some((name, index))
    })?;
    let span = document.items.iter().find_map(|item| match item {
        Item::Prose { text, span } | Item::Heading { text, span, .. } => {
            SYMMETRIC.is_in(&lowered(text)).then_some(*span)
        }
        _ => None,
    })?;
    Some(NamedMoment {
        symbol: Symbol {
            name: letter.to_owned(),
            subscripts: vec![equal.to_owned()],
            ..Symbol::default()
        },
        components: vec![0, 1],
        span,
    })
}
