//! Forces of planes on bodies that touch them: the whole, its part along the normal, and its part in the plane; and the
//! directions in which forces point.

use crate::algebra::Fraction;
use crate::verify::language::heads::{
    CONTACT_FORCE, DOWNHILL, FORCE, FRICTION, NORMAL_FORCE, UPHILL, WEIGHT,
};
use crate::verify::language::statement::{
    Declaration, Formula, NounPhrase, Slot, Statement, Term, slot,
};
use crate::verify::language::traits;
use crate::verify::model::contact::Contact;
use crate::verify::model::loads::{Called, Lasting, Load};
use crate::verify::model::system::{PointId, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::loads_read::{is_force_at, letters_of};
use crate::verify::reading::names::{is_marked_vector, node_of};
use crate::verify::term::letters::{Meaning, spelled};
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{Basis, Value};

/// Nouns of the parts of what a plane does to a body.
const PARTS: [&str; 2] = [NORMAL_FORCE, FRICTION];

impl Builder<'_> {
    /// "`N` is the normal force of the incline on the disc", "the friction `f` at C", "`F` is the weight of the disc".
    pub(super) fn read_reactions(&mut self) {
        for declaration in self.declarations {
            let of = |what| match &declaration.statement {
                Statement::Premise(premise) => premise,
                _ => what,
            };
            let named: Vec<(&NounPhrase, Vec<&Formula>)> = match &declaration.statement {
                Statement::Is { subjects, what } => {
                    vec![(what, formulas(subjects).collect())]
                }
                Statement::Premise(premise) if premise.is("only") => {
                    let loads = premise.all(Slot::With).filter_map(as_phrase);
                    loads.map(|load| (load, letters_of(load))).collect()
                }
                _ => continue,
            };
            for (what, letters) in named {
                let reaction = reaction_said(what);
                for letter in letters {
                    let read = match &reaction {
                        Some(reaction) => self.read_reaction(reaction, letter, declaration),
                        None if what.head == WEIGHT => {
                            self.read_weight(of(what), letter, declaration)
                        }
                        None => Some(()),
                    };
                    read.unwrap_or_else(|| self.say_unused(declaration));
                }
            }
        }
    }

    /// A letter for the weight is a load at the mass centre.
    fn read_weight(
        &mut self,
        what: &NounPhrase,
        letter: &Formula,
        declaration: &Declaration,
    ) -> Option<()> {
        let body = self.body_of(what)?;
        let weight = self.weight(what)?;
        if !is_marked_vector(letter) {
            return Some(());
        }
        let value = self.system().value_of(&weight).ok()?.to_vector().ok()?;
        if self.quantity_of(letter, declaration).is_none() {
            self.denote(letter, Meaning::Quantity(weight), declaration);
        }
        let at = self.centre_of(body);
        self.push_force(letter, at, value, false);
        Some(())
    }

    /// What a plane does to a body, by its letter. Where a sentence counts the whole force at the contact among the loads,
    /// this is a part of that; else it is a load of its own.
    fn read_reaction(
        &mut self,
        what: &NounPhrase,
        letter: &Formula,
        declaration: &Declaration,
    ) -> Option<()> {
        let Some(contact) = self.contact_of(what) else {
            // A force at a point of which nothing says that a plane touches it is a load like others.
            return is_force_at(what).then_some(());
        };
        let normal = contact.plane.normal.clone();
        let told = match what.slot(Slot::Along).cloned() {
            Some(along) => Some(self.direction(&along, declaration, None)?),
            None => self.told_direction(what.head, letter, declaration),
        };
        let along = told.or_else(|| (what.head == NORMAL_FORCE).then(|| normal.clone()));
        if let Some(whole) = self.whole_at(&contact) {
            let upright = normal.clone() * normal.dot(&whole);
            let part = match what.head {
                FRICTION => whole - upright,
                _ => upright,
            };
            self.name_part(letter, &part, along.as_ref(), declaration)?;
            self.push_force(letter, contact.point, part, true);
            return Some(());
        }
        let value = match along {
            Some(along) => self.directed_force(letter, &along, declaration)?,
            None if is_marked_vector(letter) => {
                let text = letter.source.clone();
                let free = Quantity::Vector {
                    text,
                    carried: None,
                };
                let free = self.system().value_of(&free).ok()?.to_vector().ok()?;
                let flat = free.clone() - normal.clone() * normal.dot(&free);
                self.denote_vector(letter, &flat, declaration);
                flat
            }
            None => return None,
        };
        self.push_force(letter, contact.point, value, false);
        Some(())
    }

    /// A part of a force by its letter: the vector, or how much of it there is along a direction.
    fn name_part(
        &mut self,
        letter: &Formula,
        part: &Vector,
        along: Option<&Vector>,
        declaration: &Declaration,
    ) -> Option<()> {
        let size = along.map(|along| part.dot(along));
        match size {
            Some(size) if !is_marked_vector(letter) => {
                let known = Quantity::Known(Value::scalar(size));
                self.denote(letter, Meaning::Quantity(known), declaration);
            }
            Some(_) => {
                let along = along.cloned()?;
                let value = self.directed_force(letter, &along, declaration)?;
                self.hold_zero(&(value - part), declaration);
            }
            None if is_marked_vector(letter) => self.denote_vector(letter, part, declaration),
            None => return None,
        }
        Some(())
    }

    fn denote_vector(&mut self, letter: &Formula, value: &Vector, declaration: &Declaration) {
        let known = Quantity::Known(Value::vector(value, Basis::Itself));
        self.denote(letter, Meaning::Quantity(known), declaration);
    }

    fn push_force(&mut self, letter: &Formula, at: PointId, value: Vector, part: bool) {
        let letter = node_of(letter).map(spelled).unwrap_or_default();
        self.system().loads.push(Load {
            called: Called::Letter(letter),
            at: Some(at),
            value,
            part,
            listed: false,
            on: None,
            lasting: Lasting::Always,
        });
    }

    /// A force that points in a direction: as much of it as its letter says, or as the magnitude of the vector does.
    pub(super) fn directed_force(
        &mut self,
        letter: &Formula,
        along: &Vector,
        declaration: &Declaration,
    ) -> Option<Vector> {
        let vector = is_marked_vector(letter);
        let known = self.quantity_of(letter, declaration);
        let text = match vector {
            true => format!("|{}|", letter.source),
            false => letter.source.clone(),
        };
        let own = Quantity::Scalar {
            text,
            constant: false,
        };
        let size = match (&known, vector) {
            (Some(known), false) => known.clone(),
            _ => own,
        };
        let size_now = self.system().value_of(&size).ok()?.to_scalar().ok()?;
        let value = along * size_now.clone();
        match vector {
            true => {
                self.tell_magnitude(along, &size_now);
                self.denote_vector(letter, &value, declaration);
            }
            false if known.is_none() => self.denote(letter, Meaning::Quantity(size), declaration),
            false => {}
        }
        Some(value)
    }

    /// The magnitude of what points in a direction is how much of it there is.
    fn tell_magnitude(&mut self, along: &Vector, size: &Fraction) {
        if let Some(letter) = size.as_variable() {
            let square = along.dot(along) * size.clone() * size.clone();
            self.system().atoms.tell_root(square, letter);
        }
    }

    /// The contact at which a force acts: by its point, or by the plane and the body.
    pub(super) fn contact_of(&self, what: &NounPhrase) -> Option<Contact> {
        let mut contacts = self.reading.system.contacts.iter();
        if let Some(at) = what.slot(Slot::At) {
            let at = self.point(at)?;
            return contacts.find(|contact| contact.point == at).cloned();
        }
        let of: Vec<&Term> = what.all(Slot::Of).chain(what.all(Slot::Upon)).collect();
        let plane = |term: &&&Term| self.plane(Some(term)).is_some();
        if what.head == FORCE && !of.iter().any(|term| plane(&term)) {
            return None;
        }
        let is = |contact: &&Contact| {
            of.iter().all(|term| {
                self.body(term) == Some(contact.body)
                    || self.plane(Some(term)).map(|plane| plane.name).as_deref()
                        == Some(&contact.plane.name)
            })
        };
        let mut fitting = contacts.filter(is);
        let first = fitting.next()?.clone();
        fitting.next().is_none().then_some(first)
    }

    /// The whole force at a contact, where a sentence counts it among the loads.
    fn whole_at(&mut self, contact: &Contact) -> Option<Vector> {
        let declarations = self.declarations;
        let counted = declarations.iter().any(|d| match &d.statement {
            Statement::Premise(premise) if premise.is("only") => {
                let mut loads = premise.all(Slot::With).filter_map(as_phrase);
                loads.any(|load| {
                    matches!(load.head, FORCE | CONTACT_FORCE)
                        && letters_of(load).is_empty()
                        && self
                            .contact_of(load)
                            .is_some_and(|c| c.point == contact.point)
                })
            }
            _ => false,
        });
        if counted {
            self.name_whole_at(contact);
        }
        let force = counted.then(|| self.force_at(contact.point)).flatten()?;
        self.system().value_of(&force).ok()?.to_vector().ok()
    }

    /// In which direction a sentence says that a force points, by its letter or its noun.
    pub(super) fn told_direction(
        &mut self,
        head: &str,
        letter: &Formula,
        declaration: &Declaration,
    ) -> Option<Vector> {
        let declarations = self.declarations;
        let own = |subject: &Term| match subject {
            Term::Formula(formula) => same_letter(formula, letter),
            Term::Phrase(phrase) => {
                let letters = letters_of(phrase);
                let named = letters.iter().any(|other| same_letter(other, letter));
                named || phrase.head == head && letters.is_empty()
            }
            _ => false,
        };
        declarations.iter().find_map(|d| match &d.statement {
            Statement::Does {
                subjects,
                verb: verb @ ("point" | "act"),
                slots,
            } if subjects.iter().any(own) => {
                let along = slot(slots, Slot::Along).cloned();
                // A number that acts along a direction may be negative.
                let along = along.filter(|_| *verb == "point" || is_marked_vector(letter));
                let against = slot(slots, Slot::With).filter(|_| *verb == "point");
                match (along, against.cloned()) {
                    (Some(along), _) => self.direction(&along, declaration, None),
                    (_, Some(against)) => Some(-self.direction(&against, declaration, None)?),
                    _ => None,
                }
            }
            Statement::Is { subjects, what }
                if matches!(what.head, DOWNHILL | UPHILL) && subjects.iter().any(own) =>
            {
                self.direction_of_plane(what)
            }
            _ => None,
        })
    }

    /// Whether a term is a force that sentences speak of: the friction, or a letter that they say to be a force.
    pub(super) fn is_force(&self, term: &Term) -> bool {
        let is_force = |head: &str| traits::is_force(head) || PARTS.contains(&head);
        let letter = match term {
            Term::Formula(letter) => letter,
            Term::Phrase(phrase) => return is_force(phrase.head),
            _ => return false,
        };
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } if is_force(what.head) || is_reaction(what) => {
                formulas(subjects).any(|own| same_letter(own, letter))
            }
            Statement::Premise(premise) if premise.is("only") => {
                premise.all(Slot::With).any(|load| match load {
                    Term::Formula(own) => same_letter(own, letter),
                    Term::Phrase(load) => {
                        letters_of(load).iter().any(|own| same_letter(own, letter))
                    }
                    _ => false,
                })
            }
            Statement::Does {
                subjects,
                verb: "act",
                ..
            } => formulas(subjects).any(|own| same_letter(own, letter)),
            _ => false,
        })
    }

    /// "the part of `v` in the floor".
    pub(super) fn part_in_plane(
        &mut self,
        of: &Term,
        plane: &Term,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let of = self.operand(of, declaration)?;
        let normal = self.plane(Some(plane))?.normal;
        let normal = Quantity::Known(Value::vector(&normal, Basis::Itself));
        Some(Quantity::Part {
            of: of.boxed(),
            axis: normal.boxed(),
            across: true,
        })
    }

    /// The force of a plane on a body, all of its parts that have letters together.
    pub(super) fn reaction(&mut self, phrase: &NounPhrase) -> Option<Quantity> {
        let contact = self.contact_of(phrase)?;
        // Where no sentence counts all loads, one without a letter may act there as well.
        let counts = |d: &Declaration| match &d.statement {
            Statement::Premise(premise) if premise.is("only") => {
                self.body_of(premise) == Some(contact.body)
            }
            _ => false,
        };
        if !self.declarations.iter().any(counts) {
            return None;
        }
        let whole = self.force_at(contact.point)?;
        let value = self.system().value_of(&whole).ok()?.to_vector().ok()?;
        let normal = contact.plane.normal;
        let upright = normal.clone() * normal.dot(&value);
        let part = match phrase.head {
            NORMAL_FORCE => upright,
            FRICTION => value - upright,
            _ => value,
        };
        Some(Quantity::Known(Value::vector(&part, Basis::Itself)))
    }
}

/// Whether a noun is that of the normal force or the friction: their sentences are read with the loads.
pub(super) fn is_reaction(what: &NounPhrase) -> bool {
    reaction_said(what).is_some()
}

/// A part of what a plane does to a body: by its noun, or as the part of the force in the plane.
fn reaction_said(what: &NounPhrase) -> Option<NounPhrase> {
    if PARTS.contains(&what.head) {
        return Some(what.clone());
    }
    let plane = what.slot(Slot::In).filter(|_| what.head == "part")?;
    let force = as_phrase(what.slot(Slot::Of)?).filter(|force| force.head == FORCE)?;
    let mut friction = NounPhrase::new(FRICTION, force.slots.clone());
    if friction.slots.is_empty() {
        friction.slots.push((Slot::Of, plane.clone()));
    }
    Some(friction)
}

/// Whether two formulas write one letter.
pub(super) fn same_letter(one: &Formula, other: &Formula) -> bool {
    match (node_of(one), node_of(other)) {
        (Some(one), Some(other)) => spelled(one) == spelled(other),
        _ => false,
    }
}

fn as_phrase(term: &Term) -> Option<&NounPhrase> {
    match term {
        Term::Phrase(phrase) => Some(phrase),
        _ => None,
    }
}
