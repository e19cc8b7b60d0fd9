//! Loads of one body on another: "the force and the moment of the hub on the wheel". What the other one does to the first
//! is their opposite.

use crate::verify::language::heads::{FORCE, MOMENT};
use crate::verify::language::statement::{
    Declaration, Formula, NounPhrase, Slot, Statement, Term, slot,
};
use crate::verify::language::traits::is_couple_of_a_kind;
use crate::verify::model::loads::{Called, Lasting, Load};
use crate::verify::model::system::{BodyId, Point, PointId, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::load_quantities_read::with_slots_of_moment;
use crate::verify::reading::loads_read::{Acting, letters_of};
use crate::verify::reading::named_loads_read::names_load;
use crate::verify::reading::names::node_of;
use crate::verify::term::letters::{Meaning, spelled};
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{Basis, Value};

/// A body that acts, and the one on which it does.
#[derive(Clone, Copy, PartialEq)]
struct Pair {
    agent: BodyId,
    on: BodyId,
}

impl Pair {
    fn called(self, head: &'static str) -> Called {
        Called::Between(head, self.agent, self.on)
    }

    fn turned(self) -> Self {
        Self {
            agent: self.on,
            on: self.agent,
        }
    }
}

impl Builder<'_> {
    /// A load of one body on another, the same wherever sentences speak of it. A force acts where it is said to, else at the
    /// joint of the two, else at a mass centre; the moment is what is left about that point.
    pub(super) fn load_between(&mut self, phrase: &NounPhrase, on: Option<BodyId>) -> Option<Load> {
        let pair = self.acting_pair(phrase, on)?;
        let at = match (phrase.head, phrase.slot(Slot::At)) {
            (head, _) if head != FORCE => None,
            (_, Some(at)) => Some(self.point(at)?),
            (_, None) => Some(self.joint_of(pair)),
        };
        self.load_of_pair(phrase.head, pair, at)
    }

    fn load_of_pair(
        &mut self,
        head: &'static str,
        pair: Pair,
        at: Option<PointId>,
    ) -> Option<Load> {
        if let Some(known) = self.loads_called(&pair.called(head)).pop() {
            return (at == known.at).then_some(known);
        }
        let load = match self.loads_called(&pair.turned().called(head)).pop() {
            Some(opposite) => opposite.opposite().filter(|load| load.at == at)?,
            None => {
                let text = format!("{head}_{{{},{}}}", pair.agent, pair.on);
                Load {
                    called: pair.called(head),
                    at,
                    value: self.free_load(&text, None)?,
                    lasting: Lasting::Always,
                    on: Some(pair.on),
                    part: false,
                    listed: false,
                }
            }
        };
        self.system().loads.push(load.clone());
        Some(load)
    }

    /// "the force at P", where P is fixed in a body and in one other, and sentences speak of the force of one of them on the
    /// other: this one.
    pub(super) fn force_at_joint(&mut self, at: PointId, on: BodyId) -> Option<Load> {
        let system = &self.reading.system;
        let carries = |body: &BodyId| {
            let frame = system.bodies[*body].frame;
            frame.is_some_and(|frame| system.points[at].fixed_in.contains(&frame))
        };
        let others = (0..system.bodies.len()).filter(|body| *body != on);
        let agents: Vec<BodyId> = others.filter(|body| carries(body)).collect();
        let (true, [agent]) = (carries(&on), agents.as_slice()) else {
            return None;
        };
        let pair = Pair { agent: *agent, on };
        if self.forces_between(pair).next().is_none() && !self.lists_force_between(pair) {
            return None;
        }
        let between = self.load_of_pair(FORCE, pair, Some(at))?;
        // Where another force acts there as well it is open which one is meant.
        let loads = self.loads_on(on, at, Lasting::Always);
        let same = |load: &Load| load.value == between.value || self.names_between(load, pair);
        loads.iter().all(same).then_some(between)
    }

    /// Whether a load is told by the letter of the force of one of two bodies on the other.
    fn names_between(&self, load: &Load, pair: Pair) -> bool {
        let Called::Letter(letter) = &load.called else {
            return false;
        };
        let own = |formula: &Formula| node_of(formula).map(spelled).as_ref() == Some(letter);
        let mut named = self.forces_between(pair);
        named.any(|subjects| formulas(subjects).any(own))
    }

    /// What sentences say to be the force of one of two bodies on the other.
    fn forces_between(&self, pair: Pair) -> impl Iterator<Item = &[Term]> {
        self.declarations
            .iter()
            .filter_map(move |d| match &d.statement {
                Statement::Is { subjects, what } if what.head == FORCE => {
                    let told = self.acting_pair(what, None)?;
                    (told == pair || told == pair.turned()).then_some(subjects.as_slice())
                }
                _ => None,
            })
    }

    /// Whether a list of the loads on one of two bodies has the force of the other one.
    fn lists_force_between(&self, pair: Pair) -> bool {
        self.declarations.iter().any(|d| {
            let Statement::Premise(premise) = &d.statement else {
                return false;
            };
            let on = premise.slot(Slot::Of).and_then(|of| self.body(of));
            premise.all(Slot::With).any(|load| match load {
                Term::Phrase(load) if load.head == FORCE => {
                    let told = self.acting_pair(load, on);
                    told == Some(pair) || told == Some(pair.turned())
                }
                _ => false,
            })
        })
    }

    /// The force or the moment of one body on another as a quantity.
    pub(super) fn quantity_between(&mut self, phrase: &NounPhrase) -> Option<Quantity> {
        let load = self.load_between(phrase, None)?;
        if let (MOMENT, Some(about)) = (phrase.head, phrase.slot(Slot::About)) {
            let about = self.point(about)?;
            let pair = self.acting_pair(phrase, None)?;
            // About another point the force has a moment as well.
            if about != self.joint_of(pair) {
                return None;
            }
        }
        Some(Quantity::Known(Value::vector(&load.value, Basis::Itself)))
    }

    /// "`F` is the force of link 1 on link 2 at P": the vector, or how much of it there is along a direction.
    pub(super) fn name_load_between(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let value = self.load_between(what, None)?.value;
        let value = match what.slot(Slot::Along) {
            Some(along) => {
                let along = self.direction(along, declaration, None)?;
                Value::scalar(value.dot(&along))
            }
            None => Value::vector(&value, Basis::Itself),
        };
        let known = Quantity::Known(value);
        let known = match what.slot(Slot::On).and_then(|on| self.frame(on)) {
            Some(frame) => Quantity::On(known.boxed(), frame),
            None => known,
        };
        for letter in formulas(subjects) {
            self.denote(letter, Meaning::Quantity(known.clone()), declaration);
        }
        Some(())
    }

    /// The loads at a point that act on a body.
    pub(super) fn loads_on(&self, body: BodyId, at: PointId, lasting: Lasting) -> Vec<Load> {
        let loads = self.loads_at(at, lasting).into_iter();
        loads
            .filter(|load| load.on.is_none_or(|on| on == body))
            .collect()
    }

    /// Whether a load is one of a body on another.
    pub(super) fn is_between(&self, phrase: &NounPhrase, on: Option<BodyId>) -> bool {
        self.acting_pair(phrase, on).is_some()
    }

    /// Whether the only moments along an axis are several, or one of another body of the system.
    pub(super) fn lists_moments(&self, premise: &NounPhrase) -> bool {
        let on = self.body_of(premise);
        let between = |load: &Term| match load {
            Term::Phrase(load) => {
                let by_letters = load.slot(Slot::Of).is_none() && !letters_of(load).is_empty();
                self.is_between(load, on) || load.all(Slot::Of).count() > 1 || by_letters
            }
            Term::Formula(_) => true,
            _ => false,
        };
        let along = premise.slot(Slot::Along).is_some();
        along && (premise.all(Slot::With).count() > 1 || premise.all(Slot::With).any(between))
    }

    /// "The moments of the base and of link 2 are the only moments on link 1 along z": they come to the total moment along
    /// it, about a point that rests in space or the mass centre.
    pub(super) fn only_moments(
        &mut self,
        premise: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let body = self.body_of(premise)?;
        let along = self.direction(premise.slot(Slot::Along)?, declaration, None)?;
        let about = self.pivot_of(premise, body)?;
        let mut rest = self.system().total_moment(body, about);
        for load in premise.all(Slot::With) {
            let load = match load {
                Term::Phrase(load) if load.head == MOMENT => load,
                Term::Formula(letter) => {
                    rest -= self.moment_by_letter(letter, premise, body, declaration)?;
                    continue;
                }
                _ => return None,
            };
            // "the moment `$-k\theta$`", "the moments `$K$` and `$M$`"
            if load.slot(Slot::Of).is_none() {
                let own = |slot: &Slot| matches!(slot, Slot::Which | Slot::Along);
                let along = load.slot(Slot::Along);
                let same = along.is_none() || along == premise.slot(Slot::Along);
                if !same || !load.slots.iter().all(|(slot, _)| own(slot)) {
                    return None;
                }
                for letter in letters_of(load) {
                    rest -= self.moment_by_letter(letter, premise, body, declaration)?;
                }
                continue;
            }
            // "The moments of the base and of link 2": one of each.
            for agent in load.all(Slot::Of) {
                let slots = load.slots.iter().filter(|(slot, _)| *slot != Slot::Of);
                let mut slots: Vec<(Slot, Term)> = slots.cloned().collect();
                slots.push((Slot::Of, agent.clone()));
                let own = NounPhrase::new(MOMENT, slots);
                let loads = self.named_load(&own, Some(body))?;
                rest -= self.system().moment_of_loads(&loads, about);
            }
        }
        self.hold(rest.dot(&along), declaration);
        self.mark_listed(premise);
        Some(())
    }

    /// A moment on a body along the axis of a list, by its letter or its formula.
    fn moment_by_letter(
        &mut self,
        letter: &Formula,
        premise: &NounPhrase,
        body: BodyId,
        declaration: &Declaration,
    ) -> Option<Vector> {
        let acting = Acting {
            head: MOMENT,
            letter,
            at: None,
            along: premise.slot(Slot::Along),
            on: Some(body),
        };
        self.value_of_load(&acting, declaration)
    }

    /// "The moment of the motor on the wheel is along z": it has no other component.
    pub(super) fn loads_point(
        &mut self,
        subjects: &[Term],
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) -> Option<()> {
        let along = slot(slots, Slot::Along)?;
        let along = self.direction(along, declaration, None)?;
        for subject in subjects {
            let Term::Phrase(load) = subject else {
                return None;
            };
            let quantity = match load.head {
                _ if names_load(load) || self.names_touch(load) => self.named_force(load),
                FORCE => self.force(load),
                MOMENT => self.moment(&with_slots_of_moment(load), declaration),
                _ => None,
            };
            let value = self.system().value_of(&quantity?).ok()?.to_vector().ok()?;
            self.hold_zero(&crate::mechanics::cross(&value, &along), declaration);
        }
        Some(())
    }

    /// "the motor moment": the one of its kind between a body and another one, where sentences tell whose it is.
    pub(super) fn kind_between(&self, phrase: &NounPhrase, body: BodyId) -> Option<Load> {
        let of_a_kind = is_couple_of_a_kind(phrase.head);
        let plain = of_a_kind && phrase.slots.is_empty() && phrase.adjectives.is_empty();
        let loads = self.reading.system.loads.iter();
        let pairs = loads.filter_map(|load| match load.called {
            Called::Between(head, agent, on) if head == phrase.head => {
                let pair = Pair { agent, on };
                (agent == body || on == body).then_some((pair, load))
            }
            _ => None,
        });
        let pairs: Vec<(Pair, &Load)> = pairs.filter(|_| plain).collect();
        let (first, load) = pairs.first()?;
        let same = |pair: &Pair| {
            [pair.agent, pair.on]
                .iter()
                .all(|b| [first.agent, first.on].contains(b))
        };
        if !pairs.iter().all(|(pair, _)| same(pair)) {
            return None;
        }
        match first.on == body {
            true => Some((*load).clone()),
            false => load.opposite(),
        }
    }

    /// The loads on the body of a list are told, and no others act on it.
    pub(super) fn mark_listed(&mut self, premise: &NounPhrase) {
        let body = self.body_of(premise);
        let loads = self.reading.system.loads.iter_mut();
        loads
            .filter(|load| load.on.is_some() && load.on == body)
            .for_each(|load| load.listed = true);
    }

    fn acting_pair(&self, phrase: &NounPhrase, on: Option<BodyId>) -> Option<Pair> {
        let agent = self.body(phrase.slot(Slot::Of)?)?;
        let on = match phrase.slot(Slot::Upon) {
            Some(upon) => self.body(upon)?,
            None => on?,
        };
        let rigid = |body: BodyId| self.reading.system.bodies[body].frame.is_some();
        let load = matches!(phrase.head, FORCE | MOMENT)
            || phrase.slot(Slot::Upon).is_some() && is_couple_of_a_kind(phrase.head);
        // A surface on which something rolls acts as a plane does, where that touches it.
        let surface = self.is_rolled_on(agent) || self.is_rolled_on(on);
        (load && !surface && agent != on && rigid(agent) && rigid(on)).then_some(Pair { agent, on })
    }

    /// A point that is fixed in both bodies, or the mass centre of the one that was named first.
    fn joint_of(&self, pair: Pair) -> PointId {
        let system = &self.reading.system;
        let frames = [pair.agent, pair.on].map(|body| system.bodies[body].frame);
        let in_both = |p: &Point| frames.iter().flatten().all(|f| p.fixed_in.contains(f));
        let joint = system.points.iter().position(in_both);
        // It is one point, whichever of the two acts.
        joint.unwrap_or(system.bodies[pair.agent.min(pair.on)].centre)
    }
}

/// "the moments of the base and of link 2", "the forces at P and at Q": one of each.
pub(super) fn one_of_each(load: &NounPhrase, several: Slot) -> Vec<NounPhrase> {
    let named = |term: &Term| matches!(term, Term::Name(_) | Term::Member { .. });
    let lettered = load.slot(Slot::Which).is_some();
    if lettered || load.all(several).count() < 2 || !load.all(several).all(named) {
        return vec![load.clone()];
    }
    let others = load.slots.iter().filter(|(slot, _)| *slot != several);
    let others: Vec<(Slot, Term)> = others.cloned().collect();
    let each = load.all(several).map(|term| NounPhrase {
        slots: [others.as_slice(), &[(several, term.clone())]].concat(),
        ..load.clone()
    });
    each.collect()
}
