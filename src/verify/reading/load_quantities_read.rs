//! Forces and moments by their nouns: of bodies and members, of weights, and of turning frames.

use crate::verify::language::heads::{FORCE, MOMENT, WEIGHT};
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::language::traits::{Trait, has, is_force};
use crate::verify::model::inertial_loads::Inertial;
use crate::verify::model::loads::{Called, Lasting, Load};
use crate::verify::model::system::{BodyId, PointId, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::loads_outside::opposite;
use crate::verify::reading::loads_read::letters_of;
use crate::verify::reading::named_loads_read::names_load;
use crate::verify::reading::only_moments_read::each_moment;
use crate::verify::reading::quantities_read::without;
use crate::verify::term::quantity::{Quantity, Spot, Whole};
use crate::verify::term::value::{Basis, Value};
use std::collections::BTreeSet;

impl Builder<'_> {
    pub(super) fn force(&mut self, phrase: &NounPhrase) -> Option<Quantity> {
        if self.is_by_spring(phrase) {
            return self.force_of_spring(phrase);
        }
        if let Some(reaction) = self.reaction(phrase) {
            return Some(reaction);
        }
        if let Some(between) = self.quantity_between(phrase) {
            return Some(between);
        }
        if self.agent_outside(phrase, None).is_some() {
            return self.named_force(phrase);
        }
        if self.acts_outside(phrase) {
            let reversed = self.reversed(phrase)?;
            return self.force(&reversed).map(opposite);
        }
        if let Some(at) = phrase.slot(Slot::At) {
            return self.point(at).and_then(|at| self.force_at(at));
        }
        if is_one_of_several(phrase) {
            return None;
        }
        // What touches a body is not all that acts on it.
        if phrase.head != FORCE {
            return self.named_force(phrase);
        }
        let of = self.whole_of(phrase)?;
        match of {
            Whole::Member(family, index) if phrase.is("external") => {
                Some(Quantity::ExternalForce(family, index))
            }
            Whole::Body(body) if phrase.is(NON_GRAVITATIONAL) => {
                let weight = self.weight_of(body)?;
                Some(without(Quantity::Force(Whole::Body(body)), weight))
            }
            _ if phrase.is(NON_GRAVITATIONAL) => None,
            of => Some(Quantity::Force(of)),
        }
    }

    /// The force at a point: the one that a letter names, or the one of which it is said that it acts there.
    pub(super) fn force_at(&mut self, at: PointId) -> Option<Quantity> {
        let value = match self.loads_at(at, Lasting::Always).as_slice() {
            // At a joint each of two bodies acts on the other.
            named if act_on_several(named) => return None,
            named @ [_, ..] => {
                let values = named.iter().map(|load| &load.value);
                values.fold(Vector::zeros(), |sum, value| sum + value)
            }
            [] => {
                let declaration = self
                    .declarations
                    .iter()
                    .find(|d| self.has_force_at(d, at))?;
                let load = self.open_load("force", at, None, declaration)?;
                self.system().loads.push(load.clone());
                load.value
            }
        };
        Some(Quantity::Known(Value::vector(&value, Basis::Itself)))
    }

    /// Whether a sentence says of a force at a point that it is one of the only loads.
    fn has_force_at(&self, declaration: &Declaration, at: PointId) -> bool {
        let Statement::Premise(premise) = &declaration.statement else {
            return false;
        };
        let mut loads = premise.all(Slot::With);
        premise.is("only")
            && loads.any(|load| match load {
                Term::Phrase(load) if is_force(load.head) => {
                    load.slot(Slot::At).and_then(|term| self.point(term)) == Some(at)
                }
                _ => false,
            })
    }

    pub(super) fn moment(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        if self.is_by_spring(phrase) {
            return self.moment_of_spring(phrase);
        }
        if let Some(drive) = self.drive(phrase) {
            return Some(drive);
        }
        if let Some(between) = self.quantity_between(phrase) {
            return Some(between);
        }
        if self.agent_outside(phrase, None).is_some() {
            return self.moment_from_outside(phrase);
        }
        if self.acts_outside(phrase) {
            let reversed = self.reversed(phrase)?;
            return self.moment(&reversed, declaration).map(opposite);
        }
        if is_one_of_several(phrase) {
            return None;
        }
        if phrase.all(Slot::Of).count() > 1 {
            let each = each_moment(phrase).into_iter();
            let each = each.map(|own| self.moment(&own, declaration));
            return each.collect::<Option<Vec<_>>>().map(Quantity::Sum);
        }
        match phrase.slot(Slot::Of)? {
            Term::Formula(formula) => {
                let about = phrase.slot(Slot::About).and_then(|term| self.point(term))?;
                self.moment_of_letter(&formula.clone(), about, declaration)
            }
            Term::Phrase(load) if inertial(load.head).is_some() => {
                let about = phrase.slot(Slot::About).and_then(|term| self.point(term))?;
                about_point(self.inertial_force(load)?, about)
            }
            Term::Phrase(load) if names_load(load) => {
                let about = match phrase.slot(Slot::About) {
                    Some(term) => self.point(term)?,
                    None => self.centre_of(self.body_of(load)?),
                };
                self.named_moment(load, about)
            }
            Term::Phrase(load) if acts_at_point(load) => {
                self.moment_of_force(load, phrase, declaration)
            }
            _ => {
                let of = self.whole_of(phrase)?;
                let about = self.about(phrase, &of)?;
                match of {
                    Whole::Body(of) => Some(Quantity::Moment { of, about }),
                    of @ Whole::Member(..) => Some(moment_on_member(phrase, of, about)),
                }
            }
        }
    }

    /// "the moment of the force `F` about Q", "… of the force at P about Q", "… of the weight about O".
    fn moment_of_force(
        &mut self,
        load: &NounPhrase,
        moment: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let about = moment.slot(Slot::About).and_then(|term| self.point(term))?;
        // A part of the force has another moment.
        if load.slot(Slot::Along).is_some() {
            return None;
        }
        let (force, at) = match (letters_of(load).as_slice(), load.slot(Slot::At)) {
            ([letter], _) => return self.moment_of_letter(&(*letter).clone(), about, declaration),
            ([], Some(at)) if load.head == FORCE => (self.force(load)?, self.point(at)?),
            ([], None) if load.head == WEIGHT => {
                (self.weight(load)?, self.centre_of(self.body_of(load)?))
            }
            _ => return None,
        };
        Some(Quantity::MomentOf {
            force: force.boxed(),
            at: Spot::Point(at),
            about,
        })
    }

    /// "the moment of the motor on the wheel"
    fn moment_from_outside(&mut self, phrase: &NounPhrase) -> Option<Quantity> {
        let about = match phrase.slot(Slot::About) {
            Some(about) => self.point(about)?,
            None => self.centre_of(self.body(phrase.slot(Slot::Upon)?)?),
        };
        self.named_moment(phrase, about)
    }

    /// "the Coriolis force on P in A".
    pub(super) fn inertial_force(&self, phrase: &NounPhrase) -> Option<Quantity> {
        let frame = phrase.slot(Slot::RelativeTo);
        Some(Quantity::InertialForce {
            kind: inertial(phrase.head)?,
            of: self.whole(phrase.slot(Slot::Of)?)?,
            frame: self.frame(frame?)?,
            about: None,
        })
    }

    /// The moment of a force by its letter.
    fn moment_of_letter(
        &self,
        letter: &Formula,
        about: PointId,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        // A formula that is no letter tells no quantity, but may be a force that acts somewhere.
        let force = self.quantity_of(letter, declaration);
        if matches!(force, Some(Quantity::InertialForce { .. })) {
            return about_point(force?, about);
        }
        let (force, at) = match force {
            Some(Quantity::ExternalForce(family, ref index)) => {
                let at = Spot::Member(family, index.clone());
                (force?, at)
            }
            // All that acts on a particle acts where that is.
            Some(Quantity::Force(Whole::Body(body)))
                if self.reading.system.bodies[body].frame.is_none() =>
            {
                (force?, Spot::Point(self.centre_of(body)))
            }
            _ => {
                let (at, vector) = self.acting_there(letter)?;
                let force = Quantity::Known(Value::vector(&vector, Basis::Itself));
                (force, Spot::Point(at))
            }
        };
        Some(Quantity::MomentOf {
            force: force.boxed(),
            at,
            about,
        })
    }

    /// m g of a body.
    pub(super) fn weight(&mut self, phrase: &NounPhrase) -> Option<Quantity> {
        self.weight_of(self.body_of(phrase)?)
    }

    /// The weight of a body as a load on it.
    pub(super) fn weight_on(&mut self, body: BodyId) -> Option<Load> {
        let weight = self.weight_of(body)?;
        let value = self.system().value_of(&weight).ok()?.to_vector().ok()?;
        Some(Load::unnamed(Some(self.centre_of(body)), value, Some(body)))
    }

    fn weight_of(&mut self, body: BodyId) -> Option<Quantity> {
        let mass = self.reading.system.mass(body);
        let gravity = self.gravity()?;
        Some(Quantity::Scaled(gravity.boxed(), mass))
    }
}

/// Said of all forces but the weight.
const NON_GRAVITATIONAL: &str = "non-gravitational";

/// The moment of the force on a particle: of all of it, of what comes from outside, or of what does not.
fn moment_on_member(phrase: &NounPhrase, of: Whole, about: PointId) -> Quantity {
    let Whole::Member(family, index) = of.clone() else {
        return Quantity::Force(of);
    };
    let at = Spot::Member(family, index.clone());
    let moment = |force: Quantity| Quantity::MomentOf {
        force: force.boxed(),
        at: at.clone(),
        about,
    };
    let external = || moment(Quantity::ExternalForce(family, index.clone()));
    match (phrase.is("external"), phrase.is("internal")) {
        (true, _) => external(),
        (_, true) => without(moment(Quantity::Force(of)), external()),
        _ => moment(Quantity::Force(of)),
    }
}

/// Whether a noun is that of a force that acts at a point.
fn acts_at_point(load: &NounPhrase) -> bool {
    is_force(load.head) || load.head == WEIGHT || has(load.head, Trait::Touch)
}

/// Whether a noun is that of a load, and not of what exerts one.
pub(super) fn is_load(noun: &NounPhrase) -> bool {
    acts_at_point(noun) || names_load(noun) || inertial(noun.head).is_some()
}

/// "the moment of the force `F` about Q along `e`": a force is about no point, and what follows that is said of its moment.
pub(super) fn with_slots_of_moment(phrase: &NounPhrase) -> NounPhrase {
    let mut moment = phrase.clone();
    let of = moment.slots.iter_mut().find(|(slot, _)| *slot == Slot::Of);
    if let (MOMENT, Some((_, Term::Phrase(load)))) = (phrase.head, of)
        && is_load(load)
        && let Some(about) = load.slots.iter().position(|(slot, _)| *slot == Slot::About)
    {
        let of_moment = load.slots.split_off(about);
        moment.slots.extend(of_moment);
    }
    moment
}

/// Whether a load is one of several, or of one body on another: it is not the total of them.
fn is_one_of_several(load: &NounPhrase) -> bool {
    load.is("one") || load.slot(Slot::Upon).is_some()
}

/// The force of a turning frame that a noun names.
pub(super) fn inertial(head: &str) -> Option<Inertial> {
    Some(match head {
        "Coriolis force" => Inertial::Coriolis,
        "centrifugal force" => Inertial::Centrifugal,
        "Euler force" => Inertial::Euler,
        _ => return None,
    })
}

/// The moment of the force of a turning frame.
fn about_point(force: Quantity, point: PointId) -> Option<Quantity> {
    match force {
        Quantity::InertialForce {
            kind, of, frame, ..
        } => Some(Quantity::InertialForce {
            kind,
            of,
            frame,
            about: Some(point),
        }),
        _ => None,
    }
}

/// Whether loads that nouns name act on several bodies.
fn act_on_several(loads: &[Load]) -> bool {
    let bodies = loads.iter().filter_map(|load| match load.called {
        Called::Noun(_, on) | Called::Between(_, _, on) => Some(on),
        _ => None,
    });
    bodies.collect::<BTreeSet<_>>().len() > 1
}
