//! Points whose position has a letter that a formula tells: "`$r$` is the position of P from Q, and `$r=ax+by$`" places P.

use super::heads::POSITION;
use super::statement::{Declaration, Extent, Formula, Slot, Statement, Term};
use crate::notation::ast::Relation;
use crate::notation::document::Row;

/// Places each of them where no other sentence does.
pub(super) fn place_by_formulas(declarations: &mut Vec<Declaration>) {
    let told = declarations
        .iter()
        .filter_map(|d| placed(d, declarations).map(|said| d.saying(said)));
    let told: Vec<Declaration> = told.collect();
    declarations.extend(told);
}

/// "P is placed from Q by `$ax+by$`."
fn placed(declaration: &Declaration, all: &[Declaration]) -> Option<Statement> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return None;
    };
    let ([Term::Formula(letter)], POSITION, [_, _], Extent::Document) = (
        subjects.as_slice(),
        what.head,
        what.slots.as_slice(),
        &declaration.extent,
    ) else {
        return None;
    };
    let (point, from) = (what.slot(Slot::Of)?, what.slot(Slot::RelativeTo)?);
    let named = |term: &Term| matches!(term, Term::Name(_));
    let elsewhere = all.iter().any(|d| {
        let placed = d.statement.places().is_some_and(|(s, _)| s.contains(point));
        placed || tells_place(&d.statement, point)
    });
    let way = all.iter().find_map(|d| way_told(d, letter))?;
    (named(point) && named(from) && !elsewhere).then(|| Statement::Does {
        subjects: vec![point.clone()],
        verb: "place",
        slots: vec![(Slot::From, from.clone()), (Slot::By, Term::Formula(way))],
    })
}

/// Whether a sentence says of a point that it is one of a body: its middle, its mass centre, a point fixed there.
fn tells_place(statement: &Statement, point: &Term) -> bool {
    match statement {
        Statement::Is { subjects, what } => {
            subjects.contains(point) && !matches!(what.head, "particle" | "point" | "bob")
                || subjects.contains(point) && what.slot(Slot::FixedIn).is_some()
        }
        _ => false,
    }
}

/// "`$r = ax+by$`", in the whole document: the right side.
fn way_told(declaration: &Declaration, letter: &Formula) -> Option<Formula> {
    let Statement::Holds(formula) = &declaration.statement else {
        return None;
    };
    let Row::Line(line) = &formula.row else {
        return None;
    };
    let ([left, right], [(Relation::Equal | Relation::Defined, _)]) =
        (line.sides.as_slice(), line.relations.as_slice())
    else {
        return None;
    };
    let own = letter.node().map(Formula::of)?.source == Formula::of(left).source;
    (own && declaration.extent == Extent::Document).then(|| Formula::of(right))
}
