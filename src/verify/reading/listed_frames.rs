//! Letters of which a sentence says what they are in several frames: "`$D$` and `$E$` are the rates of `$F$` seen from N and A".

use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// What hangs on a noun by a frame.
const BY_FRAME: [Slot; 3] = [Slot::SeenFrom, Slot::RelativeTo, Slot::On];

/// The sentences, with one for each frame in the place of one about several: the letters go with the frames in order, as many with
/// each. Where they do not come out even the sentence is not understood.
pub(super) fn of_each_frame(declarations: Vec<Declaration>) -> Vec<Declaration> {
    declarations.into_iter().flat_map(each).collect()
}

fn each(declaration: Declaration) -> Vec<Declaration> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return vec![declaration];
    };
    let Some((slot, frames)) = listed(what).filter(|_| subjects.len() > 1) else {
        return vec![declaration];
    };
    if subjects.len() % frames.len() != 0 {
        return vec![declaration.not_understood()];
    }
    let rest = what.slots.iter().filter(|(other, _)| *other != slot);
    let rest: Vec<(Slot, Term)> = rest.cloned().collect();
    let some = subjects.chunks(subjects.len() / frames.len());
    let of_frame = some.zip(frames).map(|(own, frame)| Declaration {
        statement: Statement::Is {
            subjects: own.to_vec(),
            what: NounPhrase {
                slots: [rest.as_slice(), &[(slot, frame)]].concat(),
                ..what.clone()
            },
        },
        ..declaration.clone()
    });
    of_frame.collect()
}

/// The slot in which several frames stand, and these.
fn listed(what: &NounPhrase) -> Option<(Slot, Vec<Term>)> {
    let quantity = crate::verify::language::only_names(what.head) || what.head == "component";
    let lists = BY_FRAME.into_iter().map(|slot| {
        let all: Vec<Term> = what.all(slot).cloned().collect();
        (slot, all)
    });
    let mut lists = lists.filter(|(_, all)| all.len() > 1 && all.iter().all(is_named_as_frame));
    lists.next().filter(|_| quantity)
}

/// Axes have small letters.
fn is_named_as_frame(term: &Term) -> bool {
    match term {
        Term::Name(name) => name.starts_with(char::is_uppercase),
        Term::Formula(formula) => formula.source.starts_with("\\mathcal"),
        _ => false,
    }
}
