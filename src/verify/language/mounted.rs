//! Wheels that turn about their axes of symmetry in what carries them: their mass centres stay where they are.

use super::statement::{Declaration, NounPhrase, Slot, Statement, Term, slot};

/// "The wheel is symmetric about `$a$`; the wheel turns relative to B about `$a$`": its mass centre is fixed in B, where no
/// sentence tells where it is.
pub(crate) fn mount_wheels(declarations: &mut Vec<Declaration>) {
    let symmetric: Vec<(&Term, &Term)> = declarations.iter().flat_map(symmetries).collect();
    let parts: Vec<&Term> = declarations.iter().flat_map(parts).collect();
    let placed: Vec<&Term> = declarations.iter().flat_map(placed).collect();
    let mut mounted: Vec<Declaration> = vec![];
    for declaration in declarations.iter() {
        let Some((subjects, slots)) = declaration.statement.does("turn") else {
            continue;
        };
        let (Some(about), Some(carrier)) =
            (slot(slots, Slot::About), slot(slots, Slot::RelativeTo))
        else {
            continue;
        };
        let wheel = |body: &&Term| {
            let own = symmetric.contains(&(*body, direction(about)));
            own && parts.contains(body) && !placed.contains(body)
        };
        for body in subjects.iter().filter(wheel) {
            let slots = vec![(Slot::Of, body.clone()), (Slot::FixedIn, carrier.clone())];
            mounted.push(declaration.saying(Statement::Premise(NounPhrase {
                adjectives: vec!["fixed"],
                ..NounPhrase::new("mass centre", slots)
            })));
        }
    }
    declarations.extend(mounted);
}

/// The direction of an axis: "the axis through O along `$a$`".
fn direction(axis: &Term) -> &Term {
    match axis {
        Term::Phrase(phrase) => phrase.slot(Slot::Along).unwrap_or(axis),
        _ => axis,
    }
}

/// The bodies that are symmetric by a sentence, each with the direction of its axis.
pub(super) fn symmetries(declaration: &Declaration) -> Vec<(&Term, &Term)> {
    match &declaration.statement {
        Statement::Is { subjects, what } if what.head == "symmetric" => {
            let axis = what.slot(Slot::About).map(direction);
            let pairs = axis.into_iter();
            pairs
                .flat_map(|axis| subjects.iter().map(move |body| (body, axis)))
                .collect()
        }
        _ => vec![],
    }
}

/// The bodies of which another consists by a sentence.
fn parts(declaration: &Declaration) -> impl Iterator<Item = &Term> {
    let consists = declaration.statement.does("consist");
    let parts = consists.into_iter().flat_map(|(_, slots)| slots);
    parts.map(|(_, part)| part)
}

/// The bodies of whose mass centre a sentence tells where it is, or that it is a point.
fn placed(declaration: &Declaration) -> Vec<&Term> {
    let said = match &declaration.statement {
        Statement::Is { what, .. } | Statement::Premise(what) => Some(what),
        _ => None,
    };
    let subjects = declaration.statement.subjects().iter();
    let phrases = subjects.filter_map(|subject| match subject {
        Term::Phrase(phrase) => Some(&**phrase),
        _ => None,
    });
    let centres = said.into_iter().chain(phrases);
    centres
        .filter(|what| what.head == "mass centre")
        .flat_map(|what| what.all(Slot::Of))
        .collect()
}
