//! Lines with a running index: `ℓ_i = I_i ω_i (i = 1, 2, 3)` is three lines, and Σ_i a three-term sum.

use crate::notation::ast::{Kind, Line, Node, Relation, Symbol, Term};
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::primes::dots_for_primes;
use crate::verify::letters::usage::{Letter, Usage, symbols};
use crate::verify::lines::summation::Indices;
use crate::verify::verdict::{Finding, Verdict};
use num_traits::ToPrimitive;

/// An index never runs further in this field.
const LONGEST: u32 = 6;

/// Nodes that a sum is written out to at most.
pub(crate) const MOST_NODES: usize = 20_000;

/// The nodes that an expression is made of.
pub(crate) fn size(node: &Node) -> usize {
    node.children().fold(1, |all, child| all + size(child))
}

/// The document with running indices written out, and those that are summed over where they are repeated.
pub(crate) fn written_out(document: &Document) -> (Document, Option<Indices>) {
    let mut document = document.clone();
    dots_for_primes(&mut document);
    let mut indices = Indices::of(&document);
    if let Some(indices) = &mut indices {
        indices.write_out(&mut document);
    }
    if !document.items.iter().any(runs) {
        return (document, indices);
    }
    let usage = Usage::of(&document);
    for item in &mut document.items {
        if let Item::Formula(formula) = item {
            let rows = std::mem::take(&mut formula.rows);
            formula.rows = rows
                .into_iter()
                .flat_map(|row| rows_of(row, &usage))
                .collect();
        }
    }
    (document, indices)
}

/// Whether a line is several: an index runs, over a range, in a sum, or as a letter i at a symbol; or a chain mixes
/// equalities with other relations.
fn runs(item: &Item) -> bool {
    let Item::Formula(formula) = item else {
        return false;
    };
    formula.rows.iter().any(|row| match row {
        Row::Line(line) => {
            let others = line.relations.iter().any(|(r, _)| !is_equality(*r));
            others || !line.ranges.is_empty() || line.sides.iter().any(has_index)
        }
        Row::Expression(_) | Row::Unreadable { .. } => false,
    })
}

fn has_index(node: &Node) -> bool {
    let mut found = match &node.kind {
        Kind::IndexedSum { .. } => true,
        Kind::Symbol(symbol) => symbol.subscripts.iter().any(|s| s == "i"),
        _ => false,
    };
    node.children()
        .for_each(|child| found = found || has_index(child));
    found
}

fn rows_of(row: Row, usage: &Usage) -> Vec<Row> {
    let Row::Line(mut line) = row else {
        return vec![row];
    };
    for side in &mut line.sides {
        sums(side, usage);
    }
    let mut lines = vec![line];
    let ranges = std::mem::take(&mut lines[0].ranges);
    let free = ranges
        .is_empty()
        .then(|| free_index(&lines[0], usage))
        .flatten();
    for (index, values) in ranges.into_iter().chain(free) {
        if lines.len() * values.len() > LONGEST as usize * LONGEST as usize {
            break;
        }
        let set = |line: &Line, value: &String| {
            let mut line = line.clone();
            line.sides
                .iter_mut()
                .for_each(|side| put(side, &index, value));
            line
        };
        lines = lines
            .iter()
            .flat_map(|line| values.iter().map(|v| set(line, v)).collect::<Vec<_>>())
            .collect();
    }
    lines.into_iter().flat_map(links).map(Row::Line).collect()
}

/// A chain of equalities and other relations, `I_1 = I_2 \ne I_3`, as lines that have but one kind.
fn links(line: Line) -> Vec<Line> {
    let kinds: Vec<bool> = line
        .relations
        .iter()
        .map(|(r, _)| is_equality(*r))
        .collect();
    let mixed = kinds.contains(&true) && kinds.contains(&false);
    let Some(sides) = (mixed && !line.continues).then_some(&line.sides) else {
        return vec![line];
    };
    let mut links: Vec<Line> = vec![];
    for (at, relation) in line.relations.iter().enumerate() {
        let goes_on = at > 0 && kinds[at - 1] && kinds[at];
        match links.last_mut().filter(|_| goes_on) {
            Some(link) => {
                link.sides.push(sides[at + 1].clone());
                link.relations.push(*relation);
            }
            None => links.push(Line {
                sides: sides[at..at + 2].to_vec(),
                relations: vec![*relation],
                ..line.clone()
            }),
        }
    }
    links
}

/// Whether a relation says that its sides are one.
pub(crate) fn is_equality(relation: Relation) -> bool {
    matches!(
        relation,
        Relation::Equal | Relation::Defined | Relation::Approximate
    )
}

/// An index i without a range runs over the axes if each letter that carries it has components elsewhere.
fn free_index(line: &Line, usage: &Usage) -> Option<(String, Vec<String>)> {
    let all = line.sides.iter().flat_map(symbols);
    let indexed: Vec<&Symbol> = all
        .filter(|s| s.subscripts.iter().any(|s| s == "i"))
        .collect();
    let mut numbered = indexed.iter().filter_map(|s| components(s, usage));
    let values = numbered.next()?;
    // The u_i of `u_i = τ_i/I_i` may be met with this index alone.
    let alone = |s: &&Symbol| {
        let met = usage.subscripts.get(&Letter::of(s));
        met.is_none_or(|met| met.iter().all(|index| index == "i"))
    };
    let known = |s: &&Symbol| components(s, usage).is_some() || alone(s);
    let one_family = numbered.all(|other| other == values);
    let several = one_family && indexed.iter().all(known);
    several.then(|| ("i".into(), values.map(String::from).to_vec()))
}

/// The names of a letter's components in this document.
fn components(symbol: &Symbol, usage: &Usage) -> Option<[&'static str; 3]> {
    let met = usage.subscripts.get(&Letter::of(symbol))?;
    if met.contains("1") || met.contains("2") {
        Some(["1", "2", "3"])
    } else {
        (met.contains("x") || met.contains("y")).then_some(["x", "y", "z"])
    }
}

/// An index letter replaced by its value, in subscripts of one or two letters.
fn put(node: &mut Node, index: &str, value: &str) {
    node.change_symbols(&mut |symbol| {
        for subscript in &mut symbol.subscripts {
            let pair =
                subscript.chars().count() == 2 && subscript.chars().all(char::is_alphanumeric);
            if subscript == index {
                value.clone_into(subscript);
            } else if pair && index.len() == 1 && subscript.contains(index) {
                *subscript = subscript.replace(index, value);
            }
        }
    });
}

/// Sums over an index with known limits become sums of terms.
fn sums(node: &mut Node, usage: &Usage) {
    node.children_mut()
        .into_iter()
        .for_each(|child| sums(child, usage));
    let Kind::IndexedSum {
        index,
        limits,
        body,
    } = &node.kind
    else {
        return;
    };
    let values = match limits {
        Some((from, to)) => between(from, to),
        None => {
            let carries = |s: &&Symbol| s.subscripts.contains(&index.name);
            let indexed: Vec<_> = symbols(body).into_iter().filter(carries).collect();
            let all = indexed.iter().all(|s| components(s, usage).is_some());
            // Each component along its unit vector.
            let unit = |s: &&&Symbol| {
                matches!(s.name.as_str(), "e" | "b") && (s.style.hat || s.style.vector)
            };
            let along = indexed.iter().find(unit);
            let first = indexed.first().filter(|_| all).or(along);
            let values = first.and_then(|s| components(s, usage));
            let values = values.or(along.map(|_| ["1", "2", "3"]));
            values.map(|values| values.map(String::from).to_vec())
        }
    };
    let Some(values) = values.filter(|values| values.len() * size(body) <= MOST_NODES) else {
        return;
    };
    let terms = values.iter().map(|value| {
        let mut node = (**body).clone();
        put(&mut node, &index.name, value);
        Term {
            negative: false,
            sign: node.span.before(),
            node,
        }
    });
    let terms: Vec<Term> = terms.collect();
    let sum = match <[Term; 1]>::try_from(terms) {
        Ok([only]) => only.node.kind,
        Err(terms) => Kind::Sum(terms),
    };
    node.kind = sum;
}

fn between(from: &Node, to: &Node) -> Option<Vec<String>> {
    let number = |node: &Node| match &node.kind {
        Kind::Number(n) => n.value.to_u32(),
        _ => None,
    };
    let (from, to) = (number(from)?, number(to)?);
    (from <= to && to <= LONGEST).then(|| (from..=to).map(|n| n.to_string()).collect())
}

/// A line that an index was written out of has one finding: the worst of its parts, or all of them together.
pub(crate) fn merged(findings: Vec<Finding>) -> Vec<Finding> {
    let grave = |f: &Finding| match f.verdict {
        Verdict::Refuted => 4,
        Verdict::Unreadable => 3,
        Verdict::Undecided => 2,
        Verdict::Accepted => 1,
        Verdict::Proved(_) => 0,
    };
    let mut out: Vec<Finding> = vec![];
    for finding in findings {
        match out
            .last_mut()
            .filter(|last| last.span == finding.span && last.cell == finding.cell)
        {
            Some(last) if grave(&finding) > grave(last) => *last = finding,
            Some(last) if grave(&finding) == grave(last) => {
                let new = |name: &String| !last.uses.contains(name);
                let uses: Vec<String> = finding.uses.into_iter().filter(new).collect();
                last.uses.extend(uses);
                let new = |text: &String| !last.conditions.contains(text);
                let conditions: Vec<String> = finding.conditions.into_iter().filter(new).collect();
                last.conditions.extend(conditions);
                if let (Verdict::Proved(proof), Verdict::Proved(more)) =
                    (&mut last.verdict, &finding.verdict)
                {
                    *proof = proof.and(more);
                }
            }
            Some(_) => {}
            None => out.push(finding),
        }
    }
    out
}
