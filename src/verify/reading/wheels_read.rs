//! Wheels: what drives them along their axes, and what is said of each of many that turn in one body.

use crate::algebra::Fraction;
use crate::verify::language::heads::{FORCE, MASS_CENTRE, MOMENT};
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::verify::model::system::{BodyId, FrameId, Rotors};
use crate::verify::reading::bodies_read::singular;
use crate::verify::reading::builder::Builder;
use crate::verify::term::quantity::{Quantity, Whole};
use crate::verify::term::value::{Basis, Value};

impl Builder<'_> {
    /// The rotors that a member is one of.
    pub(super) fn rotors_of(&self, of: &Whole) -> Option<Rotors> {
        let Whole::Member(family, index) = of else {
            return None;
        };
        let body = self.reading.system.families[*family].body?;
        let rotors = self.reading.system.bodies[body].rotors.clone()?;
        (rotors.index == *index).then_some(rotors)
    }

    /// The rotors that a term speaks of, and the body that carries them.
    pub(super) fn carried_rotors(&self, term: &Term) -> Option<(Rotors, BodyId)> {
        let of = self.whole(term)?;
        let rotors = self.rotors_of(&of)?;
        match of {
            Whole::Member(family, _) => Some((rotors, self.reading.system.families[family].body?)),
            Whole::Body(_) => None,
        }
    }

    /// The angular momentum of a rotor along its axis, about its mass centre: J (Ω + g·ω).
    fn momentum_along_axis(&mut self, rotors: &Rotors, body: BodyId) -> Fraction {
        let frame = self.reading.system.bodies[body].frame.unwrap_or(0);
        let ground = self.reading.system.ground;
        let omega = self.system().angular_velocity(frame, ground);
        let spin = rotors.rate.clone() + rotors.axis.dot(&omega);
        rotors.inertia.clone() * spin
    }

    /// "the moment of the hub on wheel `$i$` along `$g_i$`", where it is the only one along that: the rate of the angular
    /// momentum along the axis of the wheel, of one of many or of a body.
    pub(super) fn drive(&mut self, phrase: &NounPhrase) -> Option<Quantity> {
        let upon = phrase.slot(Slot::Upon)?;
        if self.is_between(phrase, None) {
            return None;
        }
        if let Some((rotors, body)) = self.carried_rotors(upon) {
            let momentum = self.momentum_along_axis(&rotors, body);
            let rate = self.system().atoms.derivative(&momentum);
            return Some(Quantity::Known(Value::scalar(rate)));
        }
        let driven = self.declarations.iter().any(|d| match &d.statement {
            Statement::Premise(premise) => is_only_drive(premise, phrase),
            _ => false,
        });
        let of = self.body(upon).filter(|_| driven)?;
        let about = self.pivot_of(phrase, of)?;
        Some(Quantity::Moment { of, about })
    }

    /// Whether what a sentence speaks of is a rotor, and its axis the one that the sentence names.
    pub(super) fn is_axis_of_rotor(
        &mut self,
        term: &Term,
        axis: &Term,
        declaration: &Declaration,
    ) -> bool {
        let (Some((rotors, _)), Term::Formula(letter)) = (self.carried_rotors(term), axis) else {
            return false;
        };
        let axis = self.quantity_of(letter, declaration);
        axis.and_then(|axis| self.vector_of(&axis)) == Some(rotors.axis)
    }

    /// "The force and the moment of the hub are the only loads on wheel `$i$`": what drives it is told by its motion.
    pub(super) fn lists_drive(&self, premise: &NounPhrase) -> bool {
        let of = premise.slot(Slot::Of).and_then(|of| self.whole(of));
        let rotor = of.is_some_and(|of| self.rotors_of(&of).is_some());
        let mut agents = premise.all(Slot::With).map(|load| match load {
            Term::Phrase(load) if matches!(load.head, FORCE | MOMENT) => load.slot(Slot::Of),
            _ => None,
        });
        let first = agents.next().flatten();
        rotor && first.is_some() && agents.all(|agent| agent == first)
    }

    /// "The moment of the hub is the only moment on wheel `$i$` along `$g_i$`": what drives it is told by its motion.
    pub(super) fn only_drive(&self, premise: &NounPhrase) -> Option<()> {
        let of = self.whole(premise.slot(Slot::Of)?)?;
        let known = match &of {
            Whole::Member(..) => self.rotors_of(&of).is_some(),
            Whole::Body(_) => true,
        };
        let agent =
            |load: &Term| matches!(load, Term::Phrase(load) if load.slot(Slot::Of).is_some());
        let one = premise.all(Slot::With).count() == 1 && premise.all(Slot::With).all(agent);
        (known && one && premise.slot(Slot::Along).is_some()).then_some(())
    }

    /// The angular momentum of rotors relative to the body that carries them, Σ J Ω g: their mass centres are at rest in it,
    /// so that it is the same about all points.
    pub(super) fn momentum_of_rotors_in_body(
        &mut self,
        phrase: &NounPhrase,
        relative: FrameId,
    ) -> Option<Quantity> {
        let (Term::Name(plural), None) = (phrase.slot(Slot::Of)?, phrase.slot(Slot::Along)) else {
            return None;
        };
        let family = *self.families.get(singular(plural)?)?;
        let body = self.reading.system.families[family].body?;
        let rotors = self.reading.system.bodies[body].rotors.clone()?;
        let own = self.reading.system.bodies[body].frame == Some(relative);
        let members = self.reading.system.families[family]
            .indices
            .contains(&rotors.index);
        if !own || !members || phrase.slot(Slot::VelocitiesRelativeTo).is_some() {
            return None;
        }
        let one = rotors.axis * (rotors.inertia * rotors.rate);
        let sum = self.system().sum_vector(&one, &rotors.index)?;
        Some(Quantity::Known(Value::vector(&sum, Basis::Itself)))
    }

    /// Whether a place is that of the mass centre of a rotor, on its axis.
    pub(super) fn lies_on_axis_of_rotor(
        &mut self,
        subjects: &[Term],
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) -> bool {
        let ([Term::Phrase(centre)], [(Slot::On, axis)]) = (subjects, slots) else {
            return false;
        };
        let of = centre.slot(Slot::Of).filter(|_| centre.head == MASS_CENTRE);
        of.is_some_and(|of| self.is_axis_of_rotor(of, axis, declaration))
    }

    /// The angular momentum of a rotor about its mass centre along its axis.
    pub(super) fn momentum_of_rotor(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let (of, along) = (phrase.slot(Slot::Of)?, phrase.slot(Slot::Along)?);
        if !self.is_axis_of_rotor(of, along, declaration) {
            return None;
        }
        let (rotors, body) = self.carried_rotors(of)?;
        let momentum = self.momentum_along_axis(&rotors, body);
        Some(Quantity::Known(Value::scalar(momentum)))
    }
}

/// Whether a premise says of a moment of one thing on another along an axis that it is the only one.
fn is_only_drive(premise: &NounPhrase, moment: &NounPhrase) -> bool {
    let same = |one, other| moment.slot(one).is_some() && moment.slot(one) == premise.slot(other);
    let own = premise.all(Slot::With).any(|with| match with {
        Term::Phrase(load) => {
            let alone = load.all(Slot::Of).count() == 1;
            load.head == MOMENT && alone && load.slot(Slot::Of) == moment.slot(Slot::Of)
        }
        _ => false,
    });
    let only = premise.head == MOMENT && premise.is("only");
    let one = premise.all(Slot::With).count() == 1;
    only && one && own && same(Slot::Upon, Slot::Of) && same(Slot::Along, Slot::Along)
}
