//! Points that a sentence only places: "`$F$` acts at the point placed from G by `$r$`" speaks of a point of its own.

use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// Gives these points names, and says where each is.
pub(crate) fn name_placed_points(declarations: &mut Vec<Declaration>) {
    act_in_turn(declarations);
    let mut told: Vec<Declaration> = vec![];
    for declaration in declarations.iter_mut() {
        let mut placed = vec![];
        for term in declaration.statement.terms_mut() {
            name_point(term, &mut placed);
        }
        for statement in placed {
            if told.iter().all(|known| known.statement != statement) {
                told.push(declaration.saying(statement));
            }
        }
    }
    declarations.extend(told);
}

/// Puts a name in the place of a point that is placed by one way.
fn name_point(term: &mut Term, told: &mut Vec<Statement>) {
    let Term::Phrase(point) = term else { return };
    if let ("point", [(Slot::From, from), (Slot::By, by)]) = (point.head, point.slots.as_slice())
        && let (Some(start), Some(way)) = (name(from), name(by))
    {
        let called = Term::Name(format!("point at {way} from {start}"));
        told.push(Statement::Does {
            subjects: vec![called.clone()],
            verb: "place",
            slots: point.slots.clone(),
        });
        *term = called;
        return;
    }
    for (_, inner) in &mut point.slots {
        name_point(inner, told);
    }
}

/// "The forces `$F$` and `$G$` act at the points placed from O by `$a$` and `$b$`": each at its own.
fn act_in_turn(declarations: &mut Vec<Declaration>) {
    let mut told = vec![];
    declarations.retain(|declaration| {
        let each = acting_in_turn(&declaration.statement);
        let several = each.is_some();
        let each = each.into_iter().flatten();
        told.extend(each.map(|said| declaration.saying(said)));
        !several
    });
    declarations.extend(told);
}

fn acting_in_turn(statement: &Statement) -> Option<Vec<Statement>> {
    let (subjects, slots) = statement.does("act")?;
    let [(Slot::At, Term::Phrase(points))] = slots else {
        return None;
    };
    let ways: Vec<&Term> = points.all(Slot::By).collect();
    let from = points.slot(Slot::From)?;
    let loads: Vec<Term> = match subjects {
        [Term::Phrase(loads)] => {
            let each = loads.all(Slot::Which).map(|letter| {
                let which = vec![(Slot::Which, letter.clone())];
                Term::Phrase(Box::new(NounPhrase::new(loads.head, which)))
            });
            each.collect()
        }
        letters => letters.to_vec(),
    };
    if points.head != "point" || ways.len() < 2 || ways.len() != loads.len() {
        return None;
    }
    let each = loads.into_iter().zip(ways).map(|(load, way)| {
        let slots = vec![(Slot::From, from.clone()), (Slot::By, way.clone())];
        let at = Term::Phrase(Box::new(NounPhrase::new("point", slots)));
        Statement::Does {
            subjects: vec![load],
            verb: "act",
            slots: vec![(Slot::At, at)],
        }
    });
    Some(each.collect())
}
