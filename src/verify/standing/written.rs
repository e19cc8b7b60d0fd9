//! What a line shows of itself before it is worked out.

use crate::notation::ast::{
    Bracket, Factor, FrameLabel, Kind, Line, Node, Operator, Relation, Symbol,
};
use crate::notation::document::{Document, Item, Row};
use crate::notation::print::latex;
use crate::recent::Digest;
use crate::verify::standing::memory::tree_of;
use crate::verify::term::labels::rate_of;
use crate::verify::term::letters::{spell, spelled};
use crate::verify::term::written::{
    PRODUCTS_AS_ENTRIES, PRODUCTS_AS_INTEGRALS, TURNING_RATE, Writing, Written, defined,
};
use foldhash::{HashMap, HashSet};
use num_traits::Zero;
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// A line without the number in brackets that plain text puts before it: `(2.4a) h_x = …`.
pub(super) fn without_number(line: &Line) -> Cow<'_, Line> {
    let numbered = |side: &Node| match &side.kind {
        Kind::Product(factors) => match factors.as_slice() {
            [first, second, ..] if second.operator == Operator::Juxtaposed => {
                matches!(&first.node.kind, Kind::Group(Bracket::Round, inner) if is_number_of_line(inner))
            }
            _ => false,
        },
        _ => false,
    };
    if !line.sides.first().is_some_and(numbered) {
        return Cow::Borrowed(line);
    }
    let mut line = line.clone();
    if let Some(first) = line.sides.first_mut()
        && let Kind::Product(factors) = &mut first.kind
    {
        factors.remove(0);
        if factors.len() == 1 {
            *first = factors.remove(0).node;
        }
    }
    Cow::Owned(line)
}

/// `2.4`, `2.4a`, `12`.
fn is_number_of_line(node: &Node) -> bool {
    match &node.kind {
        Kind::Number(_) => true,
        Kind::Product(factors) => {
            let letter = |f: &Factor| matches!(&f.node.kind, Kind::Symbol(s) if s.name.len() == 1);
            factors.len() == 2
                && matches!(factors[0].node.kind, Kind::Number(_))
                && letter(&factors[1])
        }
        _ => false,
    }
}

/// "at `t = 0`": when something is so, and no claim of its own.
pub(super) fn names_an_instant(line: &Line) -> bool {
    let time = |node: &Node| matches!(&node.kind, Kind::Symbol(s) if s.name == "t" && s.subscripts.is_empty());
    line.sides.len() == 2 && line.sides.first().is_some_and(time)
}

/// The symbols of formulas, spelled, and which occurrence of that writing each is.
pub(super) fn symbols_of(nodes: &[&Node]) -> Vec<(String, usize)> {
    fn collect(node: &Node, found: &mut Vec<(String, usize)>) {
        if let Kind::Symbol(symbol) = &node.kind {
            let writing = spell(symbol, true);
            let before = found.iter().filter(|(other, _)| *other == writing).count();
            found.push((writing, before + 1));
        }
        node.children().for_each(|child| collect(child, found));
    }
    let mut found = vec![];
    nodes.iter().for_each(|node| collect(node, &mut found));
    found
}

/// Whether a letter and its rate stand in formulas side by side.
pub(super) fn stands_with_rate(writing: &str, nodes: &[&Node]) -> bool {
    fn rates(node: &Node, writing: &str) -> usize {
        let own = match &node.kind {
            Kind::TimeDerivative { operand, .. } => match &operand.kind {
                Kind::Symbol(symbol) => usize::from(spell(symbol, true) == writing),
                _ => 0,
            },
            _ => 0,
        };
        own + node
            .children()
            .map(|child| rates(child, writing))
            .sum::<usize>()
    }
    let dotted: usize = nodes.iter().map(|node| rates(node, writing)).sum();
    let all = symbols_of(nodes);
    let all = all.iter().filter(|(other, _)| other == writing).count();
    dotted > 0 && all > dotted
}

/// The symbols that a document writes, spelled, and its lines.
pub(crate) fn written_symbols(document: &Document) -> Written {
    fn collect<'n>(
        node: &'n Node,
        seen: &mut HashSet<(&'n Symbol, bool)>,
        found: &mut BTreeSet<String>,
    ) {
        match &node.kind {
            Kind::Symbol(symbol) if seen.insert((symbol, false)) => {
                found.insert(spell(symbol, true));
            }
            Kind::Matrix(rows) => found.extend(products_in(rows).map(str::to_owned)),
            Kind::TimeDerivative { operand, frame, .. } => {
                let turning = frame
                    .as_ref()
                    .filter(|label| label.text == FrameLabel::TURNING);
                found.extend(turning.map(|_| TURNING_RATE.to_owned()));
                match &operand.kind {
                    Kind::Symbol(symbol) if !seen.insert((symbol, true)) => {}
                    _ => {
                        found.insert(rate_of(&spelled(operand)));
                    }
                }
            }
            _ => {}
        }
        node.children()
            .for_each(|child| collect(child, seen, found));
    }
    let (mut seen, mut found) = (HashSet::default(), BTreeSet::new());
    let mut trees = HashMap::default();
    for item in &document.items {
        let Item::Formula(formula) = item else {
            continue;
        };
        for row in &formula.rows {
            match row {
                Row::Line(line) => {
                    found.extend(defined_letters(line));
                    let sides = line.sides.iter();
                    sides.for_each(|side| collect(side, &mut seen, &mut found));
                    let others = trees.entry(line.span);
                    others
                        .and_modify(|tree| *tree = None)
                        .or_insert_with(|| line_by_tree(line));
                }
                Row::Expression(node) => collect(node, &mut seen, &mut found),
                Row::Unreadable { .. } => {}
            }
        }
    }
    Arc::new(Writing {
        symbols: found,
        trees,
        bounds: bounds_of_sums(document),
    })
}

/// How a matrix writes products of inertia, if it does: each of them twice, with two labels, all as they are or all with a minus.
fn products_in(rows: &[Vec<Node>]) -> Option<&'static str> {
    let mut found = None;
    for (row, column) in [(0, 1), (0, 2), (1, 2)] {
        let (entry, mirrored) = (rows.get(row)?.get(column)?, rows.get(column)?.get(row)?);
        let (symbol, sign) = match (&entry.kind, &mirrored.kind) {
            (Kind::Number(zero), Kind::Number(_)) if zero.value.is_zero() => continue,
            (Kind::Symbol(one), Kind::Symbol(other)) if one == other => (one, PRODUCTS_AS_ENTRIES),
            (Kind::Negate(one), Kind::Negate(_)) => match &one.kind {
                Kind::Symbol(symbol) => (symbol, PRODUCTS_AS_INTEGRALS),
                _ => return None,
            },
            _ => return None,
        };
        let labels = symbol.subscripts.last()?;
        let labels: Vec<char> = labels.chars().collect();
        let two = matches!(labels.as_slice(), [one, other] if one != other);
        if rows.len() != 3 || !two || found.is_some_and(|other| other != sign) {
            return None;
        }
        found = Some(sign);
    }
    found
}

/// The letters alone of which a line says by a sign of its own what they are.
fn defined_letters(line: &Line) -> impl Iterator<Item = String> {
    let pairs = line.sides.iter().zip(line.sides.iter().skip(1));
    let said = pairs
        .zip(&line.relations)
        .filter(|(_, (relation, _))| *relation == Relation::Defined);
    let sides = said.flat_map(|((left, right), _)| [left, right]);
    sides.filter_map(|side| match &side.kind {
        Kind::Symbol(symbol) => Some(defined(&spell(symbol, true))),
        _ => None,
    })
}

/// What a line of two sides is looked for by; `None` where its text tells more than its tree does.
fn line_by_tree(line: &Line) -> Option<Digest> {
    let plain = without_number(line);
    match plain.sides.as_slice() {
        [left, right] if !line.continues => tree_of([left, right]),
        _ => None,
    }
}

/// Up to where sums over each index run, by the letter that a document writes there most often; the first of those.
fn bounds_of_sums(document: &Document) -> BTreeMap<String, String> {
    let mut found: BTreeMap<String, Vec<(String, usize)>> = BTreeMap::new();
    for item in &document.items {
        let Item::Formula(formula) = item else {
            continue;
        };
        let nodes = formula.rows.iter().flat_map(|row| match row {
            Row::Line(line) => line.sides.iter().collect(),
            Row::Expression(node) => vec![node],
            Row::Unreadable { .. } => vec![],
        });
        let mut bounds = vec![];
        nodes.for_each(|node| collect_bounds(node, &mut bounds));
        for (index, bound) in bounds {
            let counts = found.entry(index).or_default();
            match counts.iter_mut().find(|(known, _)| *known == bound) {
                Some((_, times)) => *times += 1,
                None => counts.push((bound, 1)),
            }
        }
    }
    let most_often = |counts: Vec<(String, usize)>| {
        let first = counts.into_iter().rev().max_by_key(|(_, times)| *times);
        first.map(|(bound, _)| bound)
    };
    let all = found.into_iter();
    all.filter_map(|(index, counts)| Some((index, most_often(counts)?)))
        .collect()
}

/// The index of each sum in a tree that runs up to a letter, and that letter; with where the sum begins, if not at 1.
pub(super) fn bounds_in(node: &Node) -> Vec<(String, String)> {
    let mut found = vec![];
    collect_bounds(node, &mut found);
    found
}

fn collect_bounds(node: &Node, found: &mut Vec<(String, String)>) {
    if let Kind::IndexedSum {
        index,
        limits: Some((lower, upper)),
        ..
    } = &node.kind
        && matches!(upper.kind, Kind::Symbol(_))
    {
        let bound = match latex(lower).as_str() {
            "1" => latex(upper),
            first => format!("{} from {first}", latex(upper)),
        };
        found.push((index.name.clone(), bound));
    }
    node.children()
        .for_each(|child| collect_bounds(child, found));
}

/// Whether a display ends with a full stop, delimiters left out: `$$ a = b. $$`.
pub(super) fn ends_with_full_stop(display: &str) -> bool {
    let mut rest = display.trim_end();
    loop {
        let environment = rest.strip_suffix('}').and_then(|inner| {
            let (before, name) = inner.rsplit_once("\\end{")?;
            (!name.contains(['{', '}', '\\'])).then_some(before)
        });
        let delimiters = ["$$", "\\]", "\\\\", "```", "\\,", "~"];
        let shorter = delimiters.iter().find_map(|end| rest.strip_suffix(end));
        match environment.or(shorter) {
            Some(before) => rest = before.trim_end(),
            None => return rest.ends_with('.') && !rest.ends_with(".."),
        }
    }
}

/// Whether a bracket opens in a text that does not close: the formula was cut short.
pub(super) fn has_open_brackets(text: &str) -> bool {
    let count = |c: char| text.matches(c).count();
    count('{') != count('}') || count('(') != count(')') || count('[') != count(']')
}
