//! A letter for the rate: "`$D$` is the rate". Lines that write it so are read as if they had dots.

use super::statement::{
    Declaration, Extent, NotationMeaning, NounPhrase, Sign, Slot, Statement, Term,
};
use crate::notation::ast::{DerivativeStyle, Factor, Kind, Node, Operator, Symbol};
use crate::notation::document::{Document, Item, Row};
use std::borrow::Cow;

/// No letter is differentiated more often at once.
const HIGHEST_ORDER: u8 = 9;

/// A document in which the letters that sentences call the rate are rates.
pub(crate) fn with_rates<'d>(
    document: &'d Document,
    declarations: &[Declaration],
) -> Cow<'d, Document> {
    let letters: Vec<Symbol> = declarations.iter().filter_map(rate_letter).collect();
    if letters.is_empty() {
        return Cow::Borrowed(document);
    }
    let mut document = document.clone();
    for item in &mut document.items {
        let Item::Formula(formula) = item else {
            continue;
        };
        for row in &mut formula.rows {
            match row {
                Row::Line(line) => line
                    .sides
                    .iter_mut()
                    .for_each(|s| differentiate(s, &letters)),
                Row::Expression(node) => differentiate(node, &letters),
                Row::Unreadable { .. } => {}
            }
        }
    }
    Cow::Owned(document)
}

/// The letter of a sentence that calls it the rate: "`$D$` is the rate", "`$D x$` is the rate of `$x$`".
pub(crate) fn rate_letter(declaration: &Declaration) -> Option<Symbol> {
    let Statement::Notation {
        sign: Sign::Operator(written),
        meaning: NotationMeaning::Noun(rate),
    } = &declaration.statement
    else {
        return None;
    };
    let whole = declaration.extent == Extent::Document && rate.head == "rate";
    let node = written.node().filter(|_| whole)?;
    match (&node.kind, of(rate)) {
        (Kind::Symbol(letter), Some(None)) => Some(letter.clone()),
        (Kind::Product(factors), Some(Some(operand))) => match factors.as_slice() {
            [sign, rest] if rest.node.kind == operand.kind => lone(&sign.node).cloned(),
            _ => None,
        },
        _ => None,
    }
}

/// "`$D^2$` is the rate of the rate", of a letter that is the rate: it says nothing new.
pub(super) fn repeats_a_rate(declaration: &Declaration, letters: &[Symbol]) -> bool {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return false;
    };
    let ([Term::Formula(written)], "rate") = (subjects.as_slice(), what.head) else {
        return false;
    };
    let rates = what.slots.iter();
    let mut rates = rates.filter(|(slot, term)| *slot == Slot::Of && term.is_noun("rate"));
    let order = written.node().and_then(|node| order(node, letters));
    order == Some(2) && what.slots.len() == 1 && rates.next().is_some()
}

/// Of what a rate is, if it says so; `None` where it says more.
fn of(rate: &NounPhrase) -> Option<Option<&Node>> {
    match rate.slots.as_slice() {
        [] => Some(None),
        [(Slot::Of, Term::Formula(operand)), any @ ..] => {
            let for_any = any.iter().all(|(slot, _)| *slot == Slot::ForAny);
            for_any.then(|| operand.node().map(Some)).flatten()
        }
        _ => None,
    }
}

fn lone(node: &Node) -> Option<&Symbol> {
    match &node.kind {
        Kind::Symbol(symbol) => Some(symbol),
        _ => None,
    }
}

/// Puts a rate in the place of the letter and what stands behind it.
fn differentiate(node: &mut Node, letters: &[Symbol]) {
    node.children_mut()
        .into_iter()
        .for_each(|child| differentiate(child, letters));
    match &mut node.kind {
        Kind::Product(factors) => {
            take_operands(factors, letters);
            if factors.len() == 1 {
                *node = factors.remove(0).node;
            }
        }
        Kind::Call(head, arguments) => {
            let order = order(head, letters);
            if let (Some(order), [_]) = (order, arguments.as_slice()) {
                node.kind = rate(arguments.remove(0), order);
            }
        }
        _ => {}
    }
}

fn take_operands(factors: &mut Vec<Factor>, letters: &[Symbol]) {
    for at in (1..factors.len()).rev() {
        let beside = factors[at].operator == Operator::Juxtaposed;
        let Some(order) = order(&factors[at - 1].node, letters).filter(|_| beside) else {
            continue;
        };
        let operand = factors.remove(at).node;
        factors[at - 1].node.kind = rate(operand, order);
    }
}

fn rate(operand: Node, order: u8) -> Kind {
    Kind::TimeDerivative {
        operand: Box::new(operand),
        order,
        style: DerivativeStyle::Dots,
        frame: None,
    }
}

/// How often a letter or its power differentiates.
fn order(node: &Node, letters: &[Symbol]) -> Option<u8> {
    let is_letter = |node: &Node| lone(node).is_some_and(|symbol| letters.contains(symbol));
    match &node.kind {
        Kind::Symbol(_) => is_letter(node).then_some(1),
        Kind::Power(base, exponent) if is_letter(base) => match &exponent.kind {
            Kind::Number(number) => {
                let order = number.value.to_integer();
                let order = u8::try_from(order)
                    .ok()
                    .filter(|_| number.value.is_integer())?;
                (1..=HIGHEST_ORDER).contains(&order).then_some(order)
            }
            _ => None,
        },
        _ => None,
    }
}
