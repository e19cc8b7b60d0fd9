//! Both sides of a blow: which labels and letters mean values just before it and just after it, and what holds there.

use crate::verify::language::heads::{INSTANT, SUDDEN};
use crate::verify::language::statement::{
    Declaration, Formula, NotationMeaning, NounPhrase, Slot, Statement, Term,
};
use crate::verify::model::blows::Side;
use crate::verify::model::loads::Lasting;
use crate::verify::model::system::{BodyId, PointId, Vector};
use crate::verify::reading::Premise;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::loads_read::{AT_REST, lasting_of};
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{Basis, Value};

impl Builder<'_> {
    /// Whether sentences tell of both sides of a blow.
    pub(super) fn look_for_blow(&mut self) {
        self.reading.instants.blow = self.declarations.iter().any(|d| match &d.statement {
            Statement::Notation {
                meaning: NotationMeaning::Noun(instants),
                ..
            } => instants.head == INSTANT && instants.all(Slot::Which).any(|t| side(t).is_some()),
            _ => tells_letter_at_blow(d),
        });
    }

    /// "`$u$` is the velocity of G relative to N just after the impulse", "`$J$` is the impulse of the bullet on the rod".
    /// False where a sentence is of no blow.
    pub(super) fn read_letter_at_blow(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> bool {
        if !tells_letter_at_blow(declaration) {
            let read = self.read_impulse_of_strike(subjects, what, declaration);
            return read.is_some();
        }
        if self.denote_at_blow(subjects, what, declaration).is_none() {
            self.say_unused(declaration);
        }
        true
    }

    fn denote_at_blow(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let [Term::Formula(letter)] = subjects else {
            return None;
        };
        let mut always = what.clone();
        let side = take_side(&mut always)?;
        let quantity = self.quantity(&always, declaration)?;
        let mut value = self.system().value_of(&quantity).ok()?;
        for entry in &mut value.entries {
            *entry = self.reading.system.at_blow(entry, side)?;
        }
        self.denote_value_at_blow(letter, value, declaration)
    }

    /// A letter, or the one letter of a formula of which nothing is told, that makes up a value at a side of a blow.
    fn denote_value_at_blow(
        &mut self,
        formula: &Formula,
        value: Value,
        declaration: &Declaration,
    ) -> Option<()> {
        let held = self.hold_formula_at_blow(formula, &value, declaration);
        held.unwrap_or_else(|| {
            let known = Meaning::Quantity(Quantity::Known(value));
            self.denote(formula, known, declaration);
        });
        Some(())
    }

    /// "`$J$` is the impulse of the bullet on the rod", where that strikes it.
    fn read_impulse_of_strike(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let [Term::Formula(letter)] = subjects else {
            return None;
        };
        let impulse = self.impulse_of_strike(what)?;
        let value = match what.slot(Slot::Along) {
            Some(along) => {
                let along = self.direction(along, declaration, None)?;
                let along = self.reading.system.vector_at_blow(&along, Side::After)?;
                Value::scalar(along.dot(&impulse))
            }
            None => Value::vector(&impulse, Basis::Itself),
        };
        self.denote_value_at_blow(letter, value, declaration)
    }

    /// What always holds does so on both sides of the blow, and what rests before it has no velocity there.
    pub(super) fn hold_at_blow(&mut self) {
        if !self.reading.instants.blow {
            return self.rest_before_no_blow();
        }
        self.hold_strike();
        for premise in &self.reading.premises.clone() {
            for side in [Side::Before, Side::After] {
                let then = self.reading.system.at_blow(&premise.equation, side);
                if let Some(equation) = then.filter(|then| *then != premise.equation) {
                    self.reading.premises.push(Premise {
                        equation,
                        ..premise.clone()
                    });
                }
            }
        }
        for declaration in self.declarations {
            if let Statement::Is { subjects, what } = &declaration.statement
                && rests_before(what)
                && self.hold_rest_before(subjects, declaration).is_none()
            {
                self.say_unused(declaration);
            }
        }
    }

    /// Without a load that is a blow nothing is made of it that something rests before one.
    fn rest_before_no_blow(&mut self) {
        let mut loads = self.reading.system.loads.iter();
        if loads.any(|load| load.lasting == Lasting::Blow) {
            return;
        }
        for declaration in self.declarations {
            if matches!(&declaration.statement, Statement::Is { what, .. } if rests_before(what)) {
                self.say_unused(declaration);
            }
        }
    }

    fn hold_rest_before(&mut self, subjects: &[Term], declaration: &Declaration) -> Option<()> {
        for subject in subjects {
            let body = self.body(subject)?;
            for rate in self.rates_of(body) {
                let then = self.reading.system.vector_at_blow(&rate, Side::Before)?;
                self.hold_zero(&then, declaration);
            }
        }
        Some(())
    }

    /// The velocity of the mass centre of a body, and how it turns.
    fn rates_of(&mut self, body: BodyId) -> Vec<Vector> {
        let (ground, centre) = (self.reading.system.ground, self.centre_of(body));
        let mut rates = vec![self.system().velocity(centre, ground)];
        if let Some(frame) = self.reading.system.bodies[body].frame {
            rates.push(self.system().angular_velocity(frame, ground));
        }
        rates
    }

    /// What loads leave of all that acts on a body, or of its moment about a point: of a blow whose sides are told, what the
    /// momentum changes by beside what they bring.
    pub(super) fn left_by_loads(
        &mut self,
        rest: Vector,
        (body, about): (BodyId, Option<PointId>),
        lasting: Lasting,
    ) -> Option<Vector> {
        if lasting == Lasting::Always || !self.reading.instants.blow {
            return Some(rest);
        }
        let system = &mut self.reading.system;
        let whole = match about {
            Some(about) => system.whole_moment(body, about, lasting),
            None => system.whole_load(body, lasting),
        };
        let before = system.vector_at_blow(&whole, Side::Before)?;
        let after = system.vector_at_blow(&whole, Side::After)?;
        Some(after - before - (whole - rest))
    }

    /// How long the loads act that a sentence lists: of "the only loads" that are all blows the sentence tells no others.
    pub(super) fn lasting_of_list(&self, premise: &NounPhrase) -> Lasting {
        let mut listed = premise.all(Slot::With);
        let blow = |term: &Term| match term {
            Term::Formula(letter) => self.load(letter, Lasting::Blow).is_some(),
            Term::Phrase(load) => lasting_of(load.head) == Lasting::Blow,
            _ => false,
        };
        match premise.head == "load" && listed.all(blow) && self.reading.instants.blow {
            true => Lasting::Blow,
            false => lasting_of(premise.head),
        }
    }

    /// "The rod is at rest before the impulse."
    pub(super) fn rests_before_blow(&self, body: usize) -> bool {
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } if rests_before(what) => {
                let mut bodies = subjects.iter().map(|subject| self.body(subject));
                bodies.any(|of| of == Some(body))
            }
            _ => false,
        })
    }
}

/// Whether a sentence says what a letter is at a side of a blow.
pub(super) fn tells_letter_at_blow(declaration: &Declaration) -> bool {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return false;
    };
    let letters: Vec<&Formula> = formulas(subjects).collect();
    letters.len() == subjects.len() && !matches!(what.head, AT_REST | "zero") && is_at_blow(what)
}

/// Whether a quantity is one at a side of a blow.
pub(super) fn is_at_blow(what: &NounPhrase) -> bool {
    take_side(&mut what.clone()).is_some()
}

/// Whether it is said that something is at rest before a blow.
pub(super) fn rests_before(what: &NounPhrase) -> bool {
    what.head == AT_REST
        && what
            .slots
            .iter()
            .any(|(_, term)| side(term) == Some(Side::Before))
}

/// Takes the side of a blow out of a phrase: "the velocity of the mass centre of the rod just before the impulse".
fn take_side(phrase: &mut NounPhrase) -> Option<Side> {
    if let Some(at) = phrase
        .slots
        .iter()
        .position(|(_, term)| side(term).is_some())
    {
        let (_, term) = phrase.slots.remove(at);
        return side(&term);
    }
    phrase.slots.iter_mut().find_map(|(_, term)| match term {
        Term::Phrase(inner) => take_side(inner),
        _ => None,
    })
}

/// "just before the impulse"
pub(super) fn side(term: &Term) -> Option<Side> {
    let Term::Phrase(when) = term else {
        return None;
    };
    let side = match when.head {
        "before" => Side::Before,
        "after" => Side::After,
        _ => return None,
    };
    let mut events = when.all(Slot::Of);
    let blow = |term: &Term| match term {
        // Which of several is left open.
        Term::Phrase(event) => {
            let mut slots = event.slots.iter();
            let named = slots.all(|(_, term)| matches!(term, Term::Formula(_)));
            SUDDEN.contains(&event.head) && event.adjectives.is_empty() && named
        }
        _ => false,
    };
    (when.slots.len() == 1 && events.any(blow)).then_some(side)
}
