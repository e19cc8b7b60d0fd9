//! Loads of one component: "`$P\,\hat x$` is the force of the hand" counts along x, and so does a letter for a component of
//! a force that a list has among the only loads on a body.

use super::heads::{UNIT_VECTOR, UNIT_VECTORS};
use super::is_load;
use super::reader::formula;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::notation::Macros;
use crate::notation::ast::{Factor, Kind, Node, Operator, Style, Symbol};

/// A letter times a unit vector.
struct Product {
    source: String,
    letter: Formula,
    along: Term,
}

/// Gives such loads their letter and their direction apart.
pub(crate) fn direct_loads(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let units = match declarations.iter().any(|d| has_vector(&d.statement)) {
        true => unit_vectors(declarations, macros),
        false => vec![],
    };
    for declaration in declarations.iter_mut() {
        count_backwards(&mut declaration.statement, macros);
    }
    let sums = declarations.iter().flat_map(|d| {
        let components = components(&d.statement, &units, macros).into_iter();
        components.map(|component| d.saying(component))
    });
    let sums: Vec<Declaration> = sums.collect();
    declarations.extend(sums);
    let mut told: Vec<Product> = vec![];
    for declaration in declarations.iter_mut() {
        told.extend(direct(&mut declaration.statement, &units));
    }
    let mut counted = vec![];
    for declaration in declarations.iter_mut() {
        let Statement::Premise(premise) = &mut declaration.statement else {
            continue;
        };
        if premise.is("only") {
            let loads = premise
                .slots
                .iter_mut()
                .filter(|(slot, _)| *slot == Slot::With);
            for (_, load) in loads {
                name_by_letter(load, &told);
                counted.extend(letter_of(load).cloned());
            }
        }
    }
    for declaration in declarations.iter_mut() {
        take_component(&mut declaration.statement, &counted);
    }
}

/// Whether it speaks of a load by a product or a sum.
fn has_vector(statement: &Statement) -> bool {
    let loads = match statement {
        Statement::Is { what, .. } => is_load(what.head),
        Statement::Does { verb, .. } => *verb == "act",
        _ => false,
    };
    let vector = |term: &Term| {
        let node = term.letter().and_then(Formula::node);
        node.is_some_and(|node| matches!(node.kind, Kind::Product(_) | Kind::Sum(_)))
    };
    loads && statement.subjects().iter().any(vector)
}

/// The unit vectors and axes of which sentences tell, each as a formula without its marks.
fn unit_vectors(declarations: &[Declaration], macros: &Macros) -> Vec<(Formula, Term)> {
    let named = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            matches!(what.head, "axes" | "axis" | UNIT_VECTOR).then_some(subjects)
        }
        _ => None,
    });
    let written = |term: &Term| match term {
        Term::Name(name) => formula(name, false, macros)?.node().and_then(plain),
        Term::Formula(letter) => letter.node().and_then(plain),
        _ => None,
    };
    let units = named
        .flatten()
        .filter_map(|term| Some((written(term)?, term.clone())));
    units.collect()
}

/// A letter without the mark of a vector.
fn plain(node: &Node) -> Option<Formula> {
    match &node.kind {
        Kind::Symbol(symbol) => Some(Formula::of(&Node {
            kind: Kind::Symbol(Symbol {
                style: Style::default(),
                ..symbol.clone()
            }),
            span: node.span,
        })),
        _ => None,
    }
}

/// A product of a letter and one of the unit vectors.
fn product(formula: &Formula, units: &[(Formula, Term)]) -> Option<Product> {
    let Kind::Product(factors) = &formula.node()?.kind else {
        return None;
    };
    let [letter, unit] = factors.as_slice() else {
        return None;
    };
    let joined = |factor: &&Factor| factor.operator == Operator::Juxtaposed;
    let is_number = |node: &Node| match &node.kind {
        Kind::Symbol(symbol) => !symbol.style.vector && !symbol.style.hat,
        _ => false,
    };
    let fits = joined(&unit) && is_number(&letter.node) && is_written_as_unit(&unit.node);
    let known = plain(&unit.node).filter(|_| fits)?;
    let (_, along) = units.iter().find(|(own, _)| own.source == known.source)?;
    Some(Product {
        source: formula.source.clone(),
        letter: Formula::of(&letter.node),
        along: along.clone(),
    })
}

/// Whether a letter is a unit vector by its mark or by custom; any other one may be a coordinate.
fn is_written_as_unit(node: &Node) -> bool {
    match &node.kind {
        Kind::Symbol(letter) => {
            let marked = letter.style.vector || letter.style.hat;
            marked || UNIT_VECTORS.contains(&letter.name.as_str())
        }
        _ => false,
    }
}

/// "`$P\,\hat x$` is the force of M", "the force `$P\,\hat x$` acts at A".
fn direct(statement: &mut Statement, units: &[(Formula, Term)]) -> Option<Product> {
    match statement {
        Statement::Is { subjects, what } => {
            let [Term::Formula(letter)] = subjects.as_mut_slice() else {
                return None;
            };
            if !is_lasting(what.head) || what.slot(Slot::Along).is_some() {
                return None;
            }
            let product = product(letter, units)?;
            *letter = product.letter.clone();
            what.slots.push((Slot::Along, product.along.clone()));
            Some(product)
        }
        Statement::Does {
            subjects,
            verb: "act",
            slots,
        } => {
            let [subject] = subjects.as_mut_slice() else {
                return None;
            };
            if slots.iter().any(|(slot, _)| *slot == Slot::Along) {
                return None;
            }
            if matches!(subject, Term::Phrase(load) if !is_lasting(load.head)) {
                return None;
            }
            let letter = letter_of_mut(subject)?;
            let product = product(letter, units)?;
            *letter = product.letter.clone();
            slots.push((Slot::Along, product.along.clone()));
            Some(product)
        }
        _ => None,
    }
}

/// "`$X\,i-Y\,j$` is the force of M": `$X$` is the component along i of that force, `$Y$` the one along `$-j$`.
fn components(statement: &Statement, units: &[(Formula, Term)], macros: &Macros) -> Vec<Statement> {
    let Statement::Is { subjects, what } = statement else {
        return vec![];
    };
    let [Term::Formula(sum)] = subjects.as_slice() else {
        return vec![];
    };
    if !is_load(what.head) || what.slot(Slot::Along).is_some() {
        return vec![];
    }
    let terms: Vec<(bool, Formula)> = match sum.node().map(|node| &node.kind) {
        Some(Kind::Sum(terms)) => {
            let each = terms.iter();
            each.map(|term| (term.negative, Formula::of(&term.node)))
                .collect()
        }
        Some(Kind::Negate(inner)) => vec![(true, Formula::of(inner))],
        _ => return vec![],
    };
    let component = |(negative, term): &(bool, Formula)| {
        let product = product(term, units)?;
        let along = match negative {
            true => against(&product.along, macros)?,
            false => product.along,
        };
        let of = Term::Phrase(Box::new(what.clone()));
        let slots = vec![(Slot::Along, along), (Slot::Of, of)];
        Some(Statement::one_is(
            Term::Formula(product.letter),
            NounPhrase::new("component", slots),
        ))
    };
    let all: Option<Vec<Statement>> = terms.iter().map(component).collect();
    all.unwrap_or_default()
}

/// The direction against an axis.
fn against(axis: &Term, macros: &Macros) -> Option<Term> {
    let written = match axis {
        Term::Name(name) => name.clone(),
        Term::Formula(axis) if matches!(axis.node().map(|n| &n.kind), Some(Kind::Symbol(_))) => {
            axis.source.clone()
        }
        _ => return None,
    };
    let opposite = formula(&format!("-{written}"), false, macros)?;
    Some(Term::Formula(opposite))
}

/// "`$-F$` is the component along x of the force": `$F$` is that along `$-x$`.
fn count_backwards(statement: &mut Statement, macros: &Macros) {
    let Statement::Is { subjects, what } = statement else {
        return;
    };
    let ([Term::Formula(letter)], "component") = (subjects.as_mut_slice(), what.head) else {
        return;
    };
    let Some(Kind::Negate(inner)) = letter.node().map(|node| &node.kind) else {
        return;
    };
    let inner = Formula::of(inner);
    let mut along = what
        .slots
        .iter_mut()
        .filter(|(slot, _)| *slot == Slot::Along);
    let Some((_, axis)) = along.next() else {
        return;
    };
    if let Some(opposite) = against(axis, macros) {
        *axis = opposite;
        *letter = inner;
    }
}

/// Whether a noun is that of a load which does not act at one instant alone.
fn is_lasting(head: &str) -> bool {
    is_load(head) && head != "impulse"
}

/// The formula of a load: alone, or beside its noun.
fn letter_of(load: &Term) -> Option<&Formula> {
    match load {
        Term::Phrase(phrase) if !is_load(phrase.head) => None,
        load => load.letter(),
    }
}

fn letter_of_mut(load: &mut Term) -> Option<&mut Formula> {
    match load {
        Term::Formula(letter) => Some(letter),
        Term::Phrase(phrase) if is_load(phrase.head) => {
            let mut own = phrase
                .slots
                .iter_mut()
                .filter(|(slot, _)| *slot == Slot::Which);
            match own.next() {
                Some((_, Term::Formula(letter))) => Some(letter),
                _ => None,
            }
        }
        _ => None,
    }
}

/// In a list a product that another sentence tells is the load of that sentence.
fn name_by_letter(load: &mut Term, told: &[Product]) {
    if let Some(letter) = letter_of_mut(load)
        && let Some(product) = told.iter().find(|product| product.source == letter.source)
    {
        *letter = product.letter.clone();
    }
}

/// "`$P$` is the component along x of the force of M", where a list counts `$P$` itself among the loads.
fn take_component(statement: &mut Statement, counted: &[Formula]) {
    let Statement::Is { subjects, what } = statement else {
        return;
    };
    let [Term::Formula(letter)] = subjects.as_slice() else {
        return;
    };
    let listed = counted.iter().any(|own| own.source == letter.source);
    if !listed || what.head != "component" {
        return;
    }
    let (Some(along), Some(Term::Phrase(load))) = (what.slot(Slot::Along), what.slot(Slot::Of))
    else {
        return;
    };
    if is_load(load.head) && load.slot(Slot::Along).is_none() && what.slots.len() == 2 {
        let mut force = NounPhrase::clone(load);
        force.slots.push((Slot::Along, along.clone()));
        *what = force;
    }
}
