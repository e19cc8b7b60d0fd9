//! Places by coordinates: "P is placed from G by `$a$`, `$b$`, `$c$` on B", "`$a$`, `$b$`, `$c$` are the coordinates of P on B from G".

use super::reader::formula;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::notation::Macros;

/// Brings them to columns, and to components of positions.
pub(crate) fn tell_coordinates(declarations: &mut [Declaration], macros: &Macros) {
    for declaration in declarations {
        if let Some(placed) = placed_by_coordinates(&declaration.statement) {
            declaration.statement = placed;
        } else if let Some(lying) = placed_along(&declaration.statement) {
            declaration.statement = lying;
        }
        match &mut declaration.statement {
            Statement::Does {
                verb: "place",
                slots,
                ..
            } => place_by_column(slots, macros),
            Statement::Is { what, .. } => of_position(what),
            _ => {}
        }
    }
}

/// "`$a$`, `$b$`, `$c$` are the coordinates of P on B from G": they place it.
fn placed_by_coordinates(statement: &Statement) -> Option<Statement> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let what = match what.slots.first() {
        Some((Slot::Of, Term::Phrase(of))) if what.head == "component" => with_frame(of, what),
        _ => what.clone(),
    };
    let (point @ Term::Name(_), from, on) = (
        what.slot(Slot::Of)?,
        what.slot(Slot::RelativeTo)?,
        what.slot(Slot::On)?,
    ) else {
        return None;
    };
    let ways = subjects.iter().map(|way| (Slot::By, way.clone()));
    let slots = [(Slot::From, from.clone()), (Slot::On, on.clone())];
    let plain = what.head == "coordinate" && what.slots.len() == 3 && subjects.len() == 3;
    plain.then(|| Statement::Does {
        subjects: vec![point.clone()],
        verb: "place",
        slots: slots.into_iter().chain(ways).collect(),
    })
}

/// "P is placed from G by `$s$` along x": it lies there at that distance.
fn placed_along(statement: &Statement) -> Option<Statement> {
    let (subjects, slots) = statement.does("place")?;
    let mut ways = slots.iter().filter(|(slot, _)| *slot == Slot::By);
    let ((_, way), None) = (ways.next()?, ways.next()) else {
        return None;
    };
    let along = slots
        .iter()
        .filter(|(slot, _)| *slot == Slot::Along)
        .count();
    let others = slots.iter().filter(|(slot, _)| *slot != Slot::By);
    let distance = NounPhrase::new("distance", vec![(Slot::Which, way.clone())]);
    let at = (Slot::At, Term::Phrase(Box::new(distance)));
    (along == 1).then(|| Statement::Does {
        subjects: subjects.to_vec(),
        verb: "lie",
        slots: others.cloned().chain([at]).collect(),
    })
}

/// A noun with the frame on which its components are.
fn with_frame(of: &NounPhrase, components: &NounPhrase) -> NounPhrase {
    let on = components
        .slots
        .iter()
        .filter(|(slot, _)| *slot == Slot::On);
    NounPhrase {
        slots: of.slots.iter().chain(on).cloned().collect(),
        ..of.clone()
    }
}

/// "by the column `$(a, b, c)$`", "by `$a$`, `$b$` and `$c$` on B"
fn place_by_column(slots: &mut Vec<(Slot, Term)>, macros: &Macros) {
    for (slot, term) in slots.iter_mut() {
        if let (Slot::By, Term::Phrase(column)) = (&*slot, &*term)
            && let ("column" | "vector", [(Slot::Which, written @ Term::Formula(_))]) =
                (column.head, column.slots.as_slice())
        {
            *term = written.clone();
        }
    }
    let ways = slots.iter().filter(|(slot, _)| *slot == Slot::By);
    let sources = ways.map(|(_, term)| match term {
        Term::Formula(way) => Some(way.source.as_str()),
        _ => None,
    });
    let on = slots.iter().any(|(slot, _)| *slot == Slot::On);
    let Some([first, second, third]) = sources
        .collect::<Option<Vec<_>>>()
        .and_then(|all| <[&str; 3]>::try_from(all).ok())
        .filter(|_| on)
    else {
        return;
    };
    let column = format!("({first}, {second}, {third})");
    if let Some(column) = formula(&column, false, macros) {
        slots.retain(|(slot, _)| *slot != Slot::By);
        slots.push((Slot::By, Term::Formula(column)));
    }
}

/// "the coordinates of P on B from G": the components of its position.
fn of_position(what: &mut NounPhrase) {
    if what.head == "coordinate" && what.slot(Slot::RelativeTo).is_some() {
        let (on, of): (Vec<_>, Vec<_>) = std::mem::take(&mut what.slots)
            .into_iter()
            .partition(|(s, _)| *s == Slot::On);
        let position = Term::Phrase(Box::new(NounPhrase::new("position", of)));
        what.head = "component";
        what.slots = std::iter::once((Slot::Of, position)).chain(on).collect();
        return;
    }
    if what.head != "component" {
        return;
    }
    for (slot, term) in &mut what.slots {
        if let (Slot::Of, Term::Phrase(coordinate)) = (&*slot, &*term)
            && coordinate.head == "coordinate"
            && coordinate.slot(Slot::RelativeTo).is_some()
        {
            let position = NounPhrase::new("position", coordinate.slots.clone());
            *term = Term::Phrase(Box::new(position));
        }
    }
}
