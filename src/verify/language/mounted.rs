//! Wheels that turn about their axes of symmetry in what carries them: their mass centres stay where they are.

use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// "The wheel is symmetric about `$a$`; the wheel turns relative to B about `$a$`": its mass centre is fixed in B, where no
/// sentence tells where it is.
pub(crate) fn mount_wheels(declarations: &mut Vec<Declaration>) {
    let mut mounted: Vec<Declaration> = vec![];
    for declaration in declarations.iter() {
        let Statement::Does {
            subjects,
            verb: "turn",
            slots,
        } = &declaration.statement
        else {
            continue;
        };
        let term = |wanted| slots.iter().find(|(slot, _)| *slot == wanted);
        let (Some((_, about)), Some((_, carrier))) = (term(Slot::About), term(Slot::RelativeTo))
        else {
            continue;
        };
        for body in subjects {
            let own = is_symmetric_about(declarations, body, direction(about));
            if own && is_part(declarations, body) && !is_placed(declarations, body) {
                let slots = vec![(Slot::Of, body.clone()), (Slot::FixedIn, carrier.clone())];
                mounted.push(Declaration {
                    statement: Statement::Premise(NounPhrase {
                        adjectives: vec!["fixed"],
                        ..NounPhrase::new("mass centre", slots)
                    }),
                    ..declaration.clone()
                });
            }
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

fn is_symmetric_about(declarations: &[Declaration], body: &Term, axis: &Term) -> bool {
    declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "symmetric" => {
            let about = what.slot(Slot::About).map(direction);
            subjects.contains(body) && about == Some(axis)
        }
        _ => false,
    })
}

/// Whether a body is one of those of which another consists.
fn is_part(declarations: &[Declaration], body: &Term) -> bool {
    declarations.iter().any(|d| match &d.statement {
        Statement::Does {
            verb: "consist",
            slots,
            ..
        } => slots.iter().any(|(_, part)| part == body),
        _ => false,
    })
}

/// Whether a sentence tells where the mass centre of a body is, or that it is a point.
fn is_placed(declarations: &[Declaration], body: &Term) -> bool {
    let centre = |term: &Term| match term {
        Term::Phrase(p) => p.head == "mass centre" && p.all(Slot::Of).any(|of| of == body),
        _ => false,
    };
    declarations.iter().any(|d| {
        let told = match &d.statement {
            Statement::Is { what, .. } | Statement::Premise(what) => {
                what.head == "mass centre" && what.all(Slot::Of).any(|of| of == body)
            }
            _ => false,
        };
        told || d.statement.subjects().iter().any(centre)
    })
}
