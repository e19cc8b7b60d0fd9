//! How sentences speak of the elements of a body, and of points that run through it.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::Row;
use crate::source::Span;
use crate::verify::language::heads::{MASS, POSITION};
use crate::verify::language::statement::{Declaration, Formula, Slot, Statement, Term, slot};
use crate::verify::model::system::ELEMENT;
use crate::verify::reading::names::{index_letter, name_of};

/// The letter of an element that has none.
const OWN_LETTER: &str = "dm";

/// Quantities of one point.
pub(super) const MOTIONS: [&str; 5] = [
    POSITION,
    "velocity",
    "acceleration",
    "distance",
    "displacement",
];

pub(super) fn own_member() -> Term {
    let symbol = Symbol {
        name: OWN_LETTER.to_owned(),
        ..Symbol::default()
    };
    Term::Member {
        family: ELEMENT.to_owned(),
        index: Formula {
            source: OWN_LETTER.to_owned(),
            row: Row::Expression(Node {
                kind: Kind::Symbol(symbol),
                span: Span::default(),
            }),
        },
    }
}

pub(super) fn is_member(term: &Term) -> bool {
    matches!(term, Term::Member { family, .. } if family == ELEMENT)
}

/// "an element of the body", "the element".
pub(super) fn is_unnamed(term: &Term) -> bool {
    match term {
        Term::Phrase(phrase) => phrase.head == ELEMENT,
        Term::Name(name) => name == ELEMENT,
        _ => false,
    }
}

/// `dm`, `\mathrm dV`.
pub(super) fn is_differential(term: &Term) -> bool {
    let Term::Formula(formula) = term else {
        return false;
    };
    let letters = index_letter(formula);
    let mut rest = letters.chars();
    rest.next() == Some('d') && rest.next().is_some()
}

pub(super) fn is_volume(term: &Term) -> bool {
    matches!(term, Term::Formula(formula) if index_letter(formula).ends_with('V'))
}

/// "the integrals", `\int_V`.
pub(super) fn is_integral(term: &Term) -> bool {
    match term {
        Term::Phrase(phrase) => phrase.head == "integral",
        Term::Name(name) => name == "integral" || name == "integrals",
        Term::Formula(formula) => formula.source.trim_start().starts_with("\\int"),
        _ => false,
    }
}

/// The body that something runs over: "the body", "the volume of the body", "the positions of the body".
pub(super) fn body_name(term: &Term) -> Option<String> {
    match term {
        Term::Name(name) if name != ELEMENT => Some(name.clone()),
        Term::Phrase(phrase) if matches!(phrase.head, MASS | "volume" | POSITION | "point") => {
            match phrase.slot(Slot::Of)? {
                Term::Name(name) => Some(name.clone()),
                _ => None,
            }
        }
        _ => None,
    }
}

/// "the positions of the body", and the body itself: what a letter runs over that is a place.
pub(super) fn is_place_in_body(term: &Term) -> bool {
    match term {
        Term::Phrase(phrase) => matches!(phrase.head, "volume" | POSITION | "point"),
        Term::Name(name) => name.starts_with(char::is_lowercase) && !name.ends_with('s'),
        _ => false,
    }
}

/// The letters of the position of a point, and the point.
pub(super) fn placed_by(statement: &Statement) -> Option<(Vec<String>, String)> {
    match statement {
        Statement::Is { subjects, what } if what.head == POSITION => {
            let point = name_of(what.slot(Slot::Of)?)?;
            Some((subjects.iter().filter_map(name_of).collect(), point))
        }
        Statement::Does { subjects, .. } => {
            let (by, _) = place_of(subjects, statement)?;
            Some((vec![name_of(&by)?], name_of(subjects.first()?)?))
        }
        _ => None,
    }
}

/// "P is placed from O by `r`": the letter, and the point from which it is.
pub(super) fn place_of(subjects: &[Term], statement: &Statement) -> Option<(Term, Term)> {
    let (_, slots) = statement.does("place")?;
    let from = slot(slots, Slot::From).or_else(|| slot(slots, Slot::RelativeTo))?;
    let by = slot(slots, Slot::By).filter(|by| matches!(by, Term::Formula(_)))?;
    (subjects.len() == 1).then(|| (by.clone(), from.clone()))
}

/// "P is a point of the body."
pub(super) fn point_of_body(statement: &Statement) -> Option<String> {
    match statement {
        Statement::Is { subjects, what } if what.head == "point" => {
            let of = what.slot(Slot::Of).or_else(|| what.slot(Slot::FixedIn));
            match (of, subjects.as_slice()) {
                (Some(Term::Name(_)), [point]) => name_of(point),
                _ => None,
            }
        }
        _ => None,
    }
}

/// Whether a point is spoken of only as a point of the body, and by its own position, velocity and acceleration.
pub(super) fn is_only_place(point: &str, declarations: &[Declaration]) -> bool {
    let is_it = |term: &&Term| name_of(term).as_deref() == Some(point);
    declarations.iter().all(|d| {
        let statement = &d.statement;
        let times = statement.terms().into_iter().filter(is_it).count();
        let own = match statement {
            Statement::Is { subjects, what } if what.head == "point" => {
                subjects.iter().filter(is_it).count()
            }
            Statement::Is { what, .. } if MOTIONS.contains(&what.head) => {
                what.all(Slot::Of).filter(is_it).count()
            }
            Statement::Is { what, .. } if what.head == "component" => {
                let motion = what
                    .slot(Slot::Of)
                    .into_iter()
                    .filter_map(|term| match term {
                        Term::Phrase(phrase) if MOTIONS.contains(&phrase.head) => {
                            phrase.slot(Slot::Of)
                        }
                        _ => None,
                    });
                motion.filter(is_it).count()
            }
            Statement::Does { subjects, .. } if place_of(subjects, statement).is_some() => 1,
            _ => 0,
        };
        times == own
    })
}
