//! Elements of a body, over which integrals run: what is said of "an element of the body", of its volume, and of a point or
//! a position that runs through the body, is said of one member of the family of elements.

use crate::verify::language::heads::{DENSITY, MASS, POSITION, RUN_OVER};
use crate::verify::language::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term};
use crate::verify::model::system::ELEMENT;
use crate::verify::reading::any_read::instances;
use crate::verify::reading::elements_spoken::{
    MOTIONS, body_name, is_differential, is_integral, is_member, is_only_place, is_place_in_body,
    is_unnamed, is_volume, own_member, place_of, placed_by, point_of_body,
};
use crate::verify::reading::names::name_of;
use crate::verify::term::written::WrittenSymbols;
use std::collections::BTreeSet;

/// How deep phrases stand in each other.
const DEEPEST: usize = 8;

/// The elements that sentences speak of.
struct Elements {
    /// One of them.
    member: Term,
    /// The bodies that they are said to be of.
    bodies: BTreeSet<String>,
    /// Letters that are said to run over the body.
    running: Vec<String>,
    /// Whether integrals are said to run over the body.
    integrals: bool,
    /// Whether something is said of where an element is.
    placed: bool,
}

/// The sentences with one member of the family of elements wherever one is spoken of; all as they are where elements of
/// several bodies are.
pub(super) fn with_elements(
    declarations: &[Declaration],
    written: &WrittenSymbols,
) -> Vec<Declaration> {
    let declarations = instances(declarations, written);
    let Some(elements) = Elements::spoken_of(&declarations) else {
        return declarations;
    };
    if elements.bodies.len() > 1 {
        return declarations;
    }
    let points = elements.running_points(&declarations);
    let mut made = vec![];
    for declaration in &declarations {
        let statements = elements.told(&declaration.statement, &points);
        made.extend(statements.into_iter().map(|statement| Declaration {
            statement,
            ..declaration.clone()
        }));
    }
    made.extend(elements.made_up_of(&declarations));
    made
}

impl Elements {
    fn spoken_of(declarations: &[Declaration]) -> Option<Self> {
        let mut elements = Self {
            member: own_member(),
            bodies: BTreeSet::new(),
            running: vec![],
            integrals: false,
            placed: false,
        };
        let mut spoken = false;
        for declaration in declarations {
            let statement = &declaration.statement;
            let terms = statement.terms();
            let named = terms.iter().find(|t| is_member(t));
            if let Some(&named) = named.filter(|_| !spoken) {
                elements.member = named.clone();
            }
            let of_elements = || terms.iter().any(|term| is_member(term) || is_unnamed(term));
            spoken |= elements.hear(statement) || of_elements();
            let moves = |what: &NounPhrase| MOTIONS.contains(&what.head) || what.head == ELEMENT;
            if let Statement::Is { what, .. } = statement {
                let at = what.head == ELEMENT && what.slot(Slot::At).is_some();
                elements.placed |=
                    at || moves(what) && of_elements() || what.head == "component" && of_elements();
            }
            let phrases = terms.iter().filter_map(|term| match term {
                Term::Phrase(phrase) if phrase.head == ELEMENT => phrase.slot(Slot::Of),
                _ => None,
            });
            elements.bodies.extend(phrases.filter_map(body_name));
        }
        spoken.then_some(elements)
    }

    /// What a sentence says of elements by its verb or noun; whether it speaks of them.
    fn hear(&mut self, statement: &Statement) -> bool {
        match statement {
            Statement::Is { subjects, what } if what.head == ELEMENT => {
                self.bodies.extend(what.slot(Slot::Of).and_then(body_name));
                subjects.iter().all(is_differential)
            }
            Statement::Is { what, .. } if what.head == DENSITY => {
                let body = what.slot(Slot::Of).and_then(body_name);
                self.bodies.extend(body.clone());
                body.is_some()
            }
            Statement::Is { subjects, what } if what.head == "volume" => {
                let own = subjects.iter().all(is_differential);
                let of = what.slot(Slot::Of).filter(|_| own);
                self.bodies.extend(of.and_then(body_name));
                own
            }
            Statement::Does {
                subjects,
                verb: RUN_OVER | "number",
                slots,
            } => {
                let over = slots.iter().find(|(slot, _)| *slot == Slot::Of);
                let Some(body) = over.and_then(|(_, term)| body_name(term)) else {
                    return false;
                };
                let integral = subjects.iter().all(is_integral);
                let place = over.is_some_and(|(_, term)| is_place_in_body(term));
                if !integral && !place {
                    return false;
                }
                self.bodies.insert(body);
                self.integrals |= integral;
                if !integral {
                    self.running.extend(subjects.iter().filter_map(name_of));
                }
                true
            }
            _ => false,
        }
    }

    /// "The body consists of elements", where no sentence says of what it consists.
    fn made_up_of(&self, declarations: &[Declaration]) -> Option<Declaration> {
        let body = self.bodies.first()?;
        let consists = declarations.iter().any(|d| match &d.statement {
            Statement::Does {
                subjects,
                verb: "consist",
                ..
            } => subjects.iter().any(|s| name_of(s).as_ref() == Some(body)),
            _ => false,
        });
        let first = declarations.first().filter(|_| !consists)?;
        Some(Declaration {
            statement: Statement::Does {
                subjects: vec![Term::Name(body.clone())],
                verb: "consist",
                slots: vec![(Slot::Of, self.member.clone())],
            },
            extent: Extent::Document,
            ..first.clone()
        })
    }

    /// Points that run through the body: of which letters that run over it are the positions; or the one point of the body
    /// that is spoken of as nothing but a place, where integrals run over the body and no other sentence says which place
    /// varies.
    fn running_points(&self, declarations: &[Declaration]) -> BTreeSet<String> {
        let told = declarations.iter().filter_map(|d| {
            let (letters, point) = placed_by(&d.statement)?;
            let runs = letters.iter().any(|letter| self.running.contains(letter));
            runs.then_some(point)
        });
        let told: BTreeSet<String> = told.filter(|p| is_only_place(p, declarations)).collect();
        if !told.is_empty() || self.placed || !self.integrals || !self.running.is_empty() {
            return told;
        }
        let points = declarations
            .iter()
            .filter_map(|d| point_of_body(&d.statement));
        let points: BTreeSet<String> = points.filter(|p| is_only_place(p, declarations)).collect();
        match points.len() {
            1 => points,
            _ => BTreeSet::new(),
        }
    }

    /// The statements with elements in them.
    fn told(&self, statement: &Statement, points: &BTreeSet<String>) -> Vec<Statement> {
        match statement {
            Statement::Is { subjects, what }
                if matches!(what.head, ELEMENT | "volume")
                    && subjects.iter().all(is_differential) =>
            {
                self.measures(subjects, what)
            }
            Statement::Does {
                subjects,
                verb: RUN_OVER | "number",
                ..
            } if subjects.iter().all(is_integral) => vec![],
            Statement::Does {
                subjects,
                verb: RUN_OVER | "number",
                slots,
            } if self.runs(subjects) => {
                let over = slots.iter().find(|(slot, _)| *slot == Slot::Of);
                let from = match over {
                    Some((_, Term::Phrase(place))) if place.head == POSITION => {
                        place.slot(Slot::RelativeTo)
                    }
                    _ => None,
                };
                match from {
                    Some(from) => vec![self.position(subjects.clone(), from)],
                    // The points whose positions they are run through the body.
                    None if points.is_empty() => vec![statement.clone()],
                    None => vec![],
                }
            }
            Statement::Does { subjects, .. } => {
                let place = placed_by(statement).filter(|(_, point)| points.contains(point));
                match place.and_then(|_| place_of(subjects, statement)) {
                    Some((by, from)) => vec![self.position(vec![by], &from)],
                    None => vec![self.changed(statement, points)],
                }
            }
            _ => vec![self.changed(statement, points)],
        }
    }

    /// Whether letters are said to run over the body.
    fn runs(&self, letters: &[Term]) -> bool {
        let mut names = letters.iter().map(name_of);
        names.all(|name| name.is_some_and(|name| self.running.contains(&name)))
    }

    /// "`dm` is an element of the body [at `r` from O]", "`dV` is its volume element".
    fn measures(&self, subjects: &[Term], what: &NounPhrase) -> Vec<Statement> {
        let of_volume = |term: &Term| matches!(term, Term::Phrase(p) if p.head == "volume");
        let volume = what.head == "volume" || what.slot(Slot::Of).is_some_and(of_volume);
        let head = |subject: &Term| match volume || is_volume(subject) {
            true => "volume",
            false => MASS,
        };
        let mut told: Vec<Statement> = subjects
            .iter()
            .map(|subject| Statement::Is {
                subjects: vec![subject.clone()],
                what: NounPhrase::new(head(subject), vec![(Slot::Of, self.member.clone())]),
            })
            .collect();
        let from = what
            .slot(Slot::From)
            .or_else(|| what.slot(Slot::RelativeTo));
        if let (Some(at), Some(from)) = (what.slot(Slot::At), from) {
            told.push(self.position(vec![at.clone()], from));
        }
        told
    }

    /// "`r` is the position of the element from O."
    fn position(&self, subjects: Vec<Term>, from: &Term) -> Statement {
        let slots = vec![
            (Slot::Of, self.member.clone()),
            (Slot::RelativeTo, from.clone()),
        ];
        Statement::Is {
            subjects,
            what: NounPhrase::new(POSITION, slots),
        }
    }

    /// The statement with a member in the place of "an element of the body", and of points that run through it.
    fn changed(&self, statement: &Statement, points: &BTreeSet<String>) -> Statement {
        let mut changed = statement.clone();
        match &mut changed {
            Statement::Is { what, .. } | Statement::Premise(what) => self.change(what, points, 0),
            Statement::Does { slots, .. } => {
                for (_, term) in slots {
                    self.change_term(term, points, 0);
                }
            }
            _ => {}
        }
        changed
    }

    fn change_term(&self, term: &mut Term, points: &BTreeSet<String>, depth: usize) {
        if is_unnamed(term) {
            *term = self.member.clone();
        } else if let Term::Phrase(inner) = term {
            self.change(inner, points, depth + 1);
        }
    }

    fn change(&self, phrase: &mut NounPhrase, points: &BTreeSet<String>, depth: usize) {
        if depth > DEEPEST {
            return;
        }
        let moves = MOTIONS.contains(&phrase.head);
        let mut more = vec![];
        for (slot, term) in &mut phrase.slots {
            let runs = moves && *slot == Slot::Of;
            if runs && name_of(term).is_some_and(|name| points.contains(&name)) {
                *term = self.member.clone();
                continue;
            }
            // What hangs on the element belongs to its quantity: "the coordinates of an element of the body on B".
            if let Term::Phrase(element) = &*term
                && element.head == ELEMENT
            {
                let rest = element.slots.iter().filter(|(slot, _)| *slot != Slot::Of);
                more.extend(rest.cloned());
            }
            self.change_term(term, points, depth);
        }
        phrase.slots.extend(more);
        self.coordinates(phrase);
    }

    /// The coordinates of an element from a point are the components of its position.
    fn coordinates(&self, phrase: &mut NounPhrase) {
        if phrase.head != "coordinate" || phrase.slot(Slot::Of) != Some(&self.member) {
            return;
        }
        let from = phrase.slot(Slot::RelativeTo).cloned();
        let on = phrase.slot(Slot::On).cloned();
        if let (Some(from), Some(on)) = (from, on) {
            let slots = vec![(Slot::Of, self.member.clone()), (Slot::RelativeTo, from)];
            let position = Term::Phrase(Box::new(NounPhrase::new(POSITION, slots)));
            *phrase = NounPhrase::new("component", vec![(Slot::Of, position), (Slot::On, on)]);
        }
    }
}
