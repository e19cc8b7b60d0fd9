//! The names of things, however they are written.

use crate::notation::ast::{Kind, Node};
use crate::notation::document::Row;
use crate::notation::{Macros, read_formula};
use crate::verify::language::heads::{GRAVITY, OTHER_PRODUCTS};
use crate::verify::language::statement::{Extent, Formula, NounPhrase, Slot, Term};
use crate::verify::term::labels::without_commands;
use crate::verify::term::letters::Reach;

/// The noun of the entries of a tensor off its diagonal.
pub(crate) const PRODUCTS: &str = "products of inertia";

/// Whether a term names the products of inertia.
pub(crate) fn are_products(term: &Term) -> bool {
    matches!(term, Term::Phrase(phrase) if is_of_products(phrase))
}

/// Whether a noun is that of products of inertia.
pub(crate) fn is_of_products(phrase: &NounPhrase) -> bool {
    [PRODUCTS, OTHER_PRODUCTS].contains(&phrase.head)
}

/// The noun of the entries of a tensor on its principal axes.
pub(crate) const PRINCIPAL_MOMENTS: &str = "principal moments";

pub(crate) use crate::verify::language::heads::EULER_ANGLES;

/// The noun of how a frame turns.
pub(crate) const ANGULAR_VELOCITY: &str = "angular velocity";

/// The noun of the matrix that a cross product is.
pub(crate) const CROSS_PRODUCT_MATRIX: &str = "cross-product matrix";

pub(crate) use crate::verify::language::heads::{MASS_CENTRE, UNIT_VECTOR};

/// The noun of the energy that a body has by its place.
pub(crate) const POTENTIAL: &str = "potential energy";

/// A name as it is looked up: a letter in dollars and the same letter in plain text are one name.
pub(crate) fn name_of(term: &Term) -> Option<String> {
    match term {
        Term::Name(name) => Some(name.trim().to_owned()),
        Term::Formula(formula) => Some(name_of_formula(formula)),
        // An axis may be called by its number.
        Term::Numbers(numbers) => match numbers.as_slice() {
            [number] => Some(number.to_string()),
            _ => None,
        },
        // A noun alone is a name as well, "the ring", and so is a frame of a kind: "the body frame".
        Term::Phrase(phrase) if phrase.slots.is_empty() && phrase.adjectives.is_empty() => {
            Some(phrase.head.to_owned())
        }
        Term::Phrase(phrase) if phrase.head == "frame" => match phrase.slots.as_slice() {
            [] => Some(format!("{} frame", phrase.adjectives.join(" "))),
            [(Slot::Of, Term::Name(body))] => Some(format!("{body} frame")),
            _ => None,
        },
        _ => None,
    }
}

/// A letter as a name: calligraphic ones differ from plain ones, bold ones do not.
pub(crate) fn name_of_formula(formula: &Formula) -> String {
    match node_of(formula).map(|node| &node.kind) {
        Some(Kind::Symbol(symbol)) => {
            let mut name = symbol.name.clone();
            if symbol.style.calligraphic {
                name.push_str("~cal");
            }
            for label in &symbol.subscripts {
                name.push('_');
                name.push_str(label);
            }
            name.push_str(&"'".repeat(usize::from(symbol.primes)));
            name
        }
        _ => formula.source.trim().to_owned(),
    }
}

/// The letter of a quantity, alone or behind its noun: "`$\\theta$`", "the angle `$\\theta$`".
pub(crate) fn letter_of(term: &Term) -> Option<&Formula> {
    match term {
        Term::Formula(formula) => Some(formula),
        Term::Phrase(phrase) => match phrase.slot(Slot::Which)? {
            Term::Formula(formula) => Some(formula),
            _ => None,
        },
        _ => None,
    }
}

/// Whether a formula is a letter, with or without marks and labels.
pub(crate) fn is_letter(formula: &Formula) -> bool {
    node_of(formula).is_some_and(|node| matches!(node.kind, Kind::Symbol(_)))
}

/// Whether a letter carries the mark of a vector.
pub(crate) fn is_marked_vector(letter: &Formula) -> bool {
    let node = node_of(letter).map(|node| &node.kind);
    matches!(node, Some(Kind::Symbol(symbol)) if symbol.style.vector)
}

/// What an axis is along: z for "the axis through G along z".
pub(crate) fn along_of(axis: &Term) -> &Term {
    match axis {
        Term::Phrase(line) => line.slot(Slot::Along).unwrap_or(axis),
        _ => axis,
    }
}

/// `x` of `-x`: the direction against which something points.
pub(crate) fn opposite(term: &Term) -> Option<Term> {
    if let Term::Phrase(axis) = term
        && axis.is("negative")
    {
        let mut axis = axis.clone();
        axis.adjectives.retain(|a| *a != "negative");
        return Some(Term::Phrase(axis));
    }
    let Term::Formula(formula) = term else {
        return None;
    };
    let Kind::Negate(inner) = &node_of(formula)?.kind else {
        return None;
    };
    Some(Term::Formula(Formula::of(inner)))
}

/// The expression that a formula is, if it is one.
pub(crate) fn node_of(formula: &Formula) -> Option<&Node> {
    formula.node()
}

/// The tree of a formula, or those of its sides.
pub(crate) fn nodes_of(formula: &Formula) -> &[Node] {
    match &formula.row {
        Row::Expression(node) => std::slice::from_ref(node),
        Row::Line(line) => &line.sides,
        Row::Unreadable { .. } => &[],
    }
}

/// The letter of an index: the i of "wheel $i$".
pub(crate) fn index_letter(formula: &Formula) -> String {
    match node_of(formula).map(|node| &node.kind) {
        Some(Kind::Symbol(symbol)) => symbol.name.clone(),
        _ => without_commands(&formula.source)
            .chars()
            .filter(|c| c.is_alphanumeric())
            .collect(),
    }
}

/// The part of a document that an extent names.
pub(crate) fn reach_of(extent: &Extent) -> Reach {
    match extent {
        Extent::Document => Reach::All,
        Extent::Lines { cell, first, last } => Reach::Lines {
            cell: *cell,
            first: *first,
            last: last.unwrap_or(usize::MAX),
        },
        Extent::Cells(cells) => Reach::Cells(cells.clone()),
        Extent::Section(title) => Reach::Section(title.clone()),
        // Labels are looked up in the document; what is left of them stands nowhere.
        Extent::Between(..) => Reach::Cells(vec![]),
        Extent::Occurrence {
            number, cell, line, ..
        } => Reach::Occurrence {
            number: *number,
            cell: *cell,
            line: *line,
        },
        Extent::Both(a, b) => Reach::Both(Box::new(reach_of(a)), Box::new(reach_of(b))),
    }
}

/// What a slot names; where nothing is said, what is customary. Nothing where it is said and not known.
pub(crate) fn told<T>(
    slot: Option<&Term>,
    customary: T,
    known: impl Fn(&Term) -> Option<T>,
) -> Option<T> {
    match slot {
        Some(term) => known(term),
        None => Some(customary),
    }
}

/// Whether a noun is the acceleration of gravity, or how great it is.
pub(crate) fn tells_gravity(what: &NounPhrase) -> bool {
    let of = what.slot(Slot::Of);
    what.head == GRAVITY
        || what.head == "magnitude"
            && matches!(of, Some(Term::Phrase(phrase)) if phrase.head == GRAVITY)
}

/// A formula by its writing.
pub(crate) fn written(source: &str) -> Option<Formula> {
    let row = read_formula(source, 0, &Macros::default()).pop()?;
    let source = source.to_owned();
    Some(Formula { source, row })
}
