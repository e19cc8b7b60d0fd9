//! Loads that a noun names without a letter: "the thrust", "the drag on the aircraft".

use crate::verify::language::heads::{CONTACT_FORCE, FORCE, MOMENT};
use crate::verify::language::statement::{
    Declaration, Formula, NounPhrase, Slot, Statement, Term, slot,
};
use crate::verify::language::traits::{Trait, has, is_couple, is_couple_of_a_kind};
use crate::verify::model::loads::{Called, Lasting, Load};
use crate::verify::model::system::{BodyId, PointId, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::loads_read::{is_force_at, letters_of};
use crate::verify::reading::names::is_marked_vector;
use crate::verify::reading::reactions_read::{is_reaction, same_letter};
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{Basis, Value};

/// Whether a phrase names a load by its noun, and not by the point where it acts.
pub(super) fn names_load(phrase: &NounPhrase) -> bool {
    has(phrase.head, Trait::OfAKind) && phrase.slot(Slot::At).is_none()
}

/// Whether what is said to be a load may be its size alone: a letter that is not written as a vector, of which no components
/// are told.
pub(super) fn may_be_size(subject: &Term, what: &NounPhrase) -> bool {
    let Term::Formula(formula) = subject else {
        return false;
    };
    !is_marked_vector(formula) && what.slot(Slot::On).is_none() && what.slot(Slot::Along).is_none()
}

impl Builder<'_> {
    /// The force of a load and its couple: what a noun names first is unknown, and the same wherever the noun stands again.
    pub(super) fn named_load(
        &mut self,
        phrase: &NounPhrase,
        on: Option<BodyId>,
    ) -> Option<Vec<Load>> {
        match self.is_by_spring(phrase) {
            true => self.loads_of_spring(phrase, on),
            false => self.load_by_noun(phrase, on),
        }
    }

    fn load_by_noun(&mut self, phrase: &NounPhrase, on: Option<BodyId>) -> Option<Vec<Load>> {
        let of_kind = |own: &Self| on.and_then(|body| own.kind_between(phrase, body));
        let between = self.load_between(phrase, on);
        if let Some(load) = between.or_else(|| of_kind(self)) {
            return Some(vec![load]);
        }
        let agent = self.agent_outside(phrase, on);
        if !names_load(phrase) && agent.is_none() && !self.names_touch(phrase) {
            return self.touch_told(phrase, on?);
        }
        let body = match (&agent, phrase.slot(Slot::Of)) {
            (Some(_), _) => match phrase.slot(Slot::Upon) {
                Some(upon) => self.body(upon)?,
                None => self.part_acted_on(phrase, on?)?,
            },
            // What another body exerts is no load of a kind that acts on that body.
            (None, Some(_)) if phrase.slot(Slot::Upon).is_some() => return None,
            (None, Some(_)) => self.body_of(phrase)?,
            (None, None) => on.or_else(|| self.body_of(phrase))?,
        };
        let mut told = match agent.is_some() && !is_force_at(phrase) {
            true => self.forces_of_agent(phrase, body),
            false => vec![],
        };
        if told.is_empty() {
            told = self.letters_told_by(phrase, body);
        }
        let by_noun = Called::Noun(noun_of(phrase, agent.as_deref()), body);
        if !told.is_empty() && self.loads_called(&by_noun).is_empty() {
            let loads = told.into_iter();
            return loads
                .map(|letter| self.load(letter, Lasting::Always))
                .collect();
        }
        let noun = match phrase.is("total") {
            true if !self.lists_in_whole(phrase) => return None,
            true => noun_of(&NounPhrase::new(phrase.head, vec![]), agent.as_deref()),
            false => noun_of(phrase, agent.as_deref()),
        };
        let called = Called::Noun(noun.clone(), body);
        if self.loads_called(&called).is_empty() {
            let label = format!("{noun},{}", self.reading.system.bodies[body].name);
            if phrase.head == FORCE || !is_couple(phrase.head) {
                let force = self.free_load(&format!("F_{{{label}}}"), None)?;
                self.push_named_load((&noun, body), force, Some(self.centre_of(body)));
            }
            let particle = self.reading.system.bodies[body].frame.is_none();
            if !particle || phrase.head != FORCE {
                let text = format!("M_{{{label}}}");
                let axis = self.axis_of_moment(phrase, body);
                let moment = self.free_load(&text, axis)?;
                self.push_named_load((&noun, body), moment, None);
            }
        }
        Some(self.loads_called(&called))
    }

    /// Whether a noun names what something does to a body by touching it, where the model has nothing that touches: a load
    /// like others, of which nothing more is known.
    pub(super) fn names_touch(&self, phrase: &NounPhrase) -> bool {
        has(phrase.head, Trait::Touch)
            && phrase.slot(Slot::At).is_none()
            && self.reading.system.contacts.is_empty()
    }

    /// "the friction", "the normal force" on a body that touches one plane: by the letters that sentences tell for them.
    fn touch_told(&mut self, phrase: &NounPhrase, body: BodyId) -> Option<Vec<Load>> {
        let contacts = self.reading.system.contacts.iter();
        let one = contacts.filter(|contact| contact.body == body).count() == 1;
        if !one || !has(phrase.head, Trait::Touch) || phrase.slot(Slot::At).is_some() {
            return None;
        }
        let told = self.letters_told_by(phrase, body);
        let loads = told.iter().map(|letter| self.load(letter, Lasting::Always));
        let loads: Option<Vec<Load>> = loads.collect();
        loads.filter(|loads| loads.len() == 1)
    }

    /// The letters and formulas that sentences tell for what a noun names on a body: "The thrust `F k` acts on the rocket at
    /// G" for "the thrust".
    fn letters_told_by(&self, phrase: &NounPhrase, body: BodyId) -> Vec<&Formula> {
        let agent = |load: &'_ NounPhrase| {
            let of = load.slot(Slot::Of).filter(|of| self.body(of) != Some(body));
            of.cloned()
        };
        let own = agent(phrase);
        let same = |load: &NounPhrase| {
            let plain = phrase.adjectives.is_empty() || load.adjectives == phrase.adjectives;
            load.head == phrase.head && plain && (own.is_none() || agent(load) == own)
        };
        let here = |slots: &[(Slot, Term)]| {
            let on = slot(slots, Slot::Upon).or_else(|| slot(slots, Slot::Of));
            on.is_none_or(|on| self.body(on).is_none_or(|on| on == body))
        };
        let mut told = vec![];
        for declaration in self.declarations {
            match &declaration.statement {
                Statement::Does {
                    subjects,
                    verb: "act",
                    slots,
                } if here(slots) => {
                    for subject in subjects {
                        if let Term::Phrase(load) = subject
                            && same(load)
                        {
                            told.extend(letters_of(load));
                        }
                    }
                }
                Statement::Is { subjects, what }
                    if (is_force_at(what) || is_reaction(what))
                        && same(what)
                        && here(&what.slots) =>
                {
                    told.extend(formulas(subjects));
                }
                _ => {}
            }
        }
        told
    }

    /// "the total aerodynamic force", where a sentence lists "the aerodynamic forces" among the only loads: all of them.
    fn lists_in_whole(&self, phrase: &NounPhrase) -> bool {
        let all = |term: &Term| match term {
            Term::Phrase(load) => {
                load.head == phrase.head && load.adjectives.is_empty() && load.slots.is_empty()
            }
            _ => false,
        };
        let lists = |d: &Declaration| match &d.statement {
            Statement::Premise(premise) => premise.is("only") && premise.all(Slot::With).any(all),
            _ => false,
        };
        phrase.adjectives == ["total"] && self.declarations.iter().any(lists)
    }

    pub(super) fn loads_called(&self, called: &Called) -> Vec<Load> {
        let loads = self.reading.system.loads.iter();
        loads
            .filter(|load| load.called == *called)
            .cloned()
            .collect()
    }

    /// A force or a moment of which nothing is told, or only along which axis it is.
    pub(super) fn free_load(&mut self, text: &str, along: Option<Vector>) -> Option<Vector> {
        let text = text.to_owned();
        let system = self.system();
        match along {
            Some(axis) => {
                let constant = false;
                let size = system.value_of(&Quantity::Scalar { text, constant });
                Some(axis * size.ok()?.to_scalar().ok()?)
            }
            None => {
                let carried = None;
                let free = system.value_of(&Quantity::Vector { text, carried });
                free.ok()?.to_vector().ok()
            }
        }
    }

    pub(super) fn push_named_load(
        &mut self,
        (noun, on): (&str, BodyId),
        value: Vector,
        at: Option<PointId>,
    ) {
        self.system().loads.push(Load {
            called: Called::Noun(noun.to_owned(), on),
            at,
            value,
            lasting: Lasting::Always,
            on: Some(on),
            part: false,
            listed: false,
        });
    }

    /// The letters of forces that something else exerts on a body at points.
    pub(super) fn forces_of_agent(&self, phrase: &NounPhrase, body: BodyId) -> Vec<&Formula> {
        let said = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                let same = what.head == phrase.head && what.slot(Slot::Of) == phrase.slot(Slot::Of);
                let on = what.slot(Slot::Upon).and_then(|upon| self.body(upon));
                (same && is_force_at(what) && on == Some(body)).then_some(subjects)
            }
            _ => None,
        });
        said.flat_map(|subjects| formulas(subjects)).collect()
    }

    /// The force of a load that a noun names, or its moment where the noun is of one.
    pub(super) fn named_force(&mut self, phrase: &NounPhrase) -> Option<Quantity> {
        let loads = self.named_load(phrase, None)?;
        let value = Value::vector(&loads.first()?.value, Basis::Itself);
        Some(Quantity::Known(value))
    }

    /// The moment about a point of a load that a noun names.
    pub(super) fn named_moment(&mut self, phrase: &NounPhrase, about: PointId) -> Option<Quantity> {
        let loads = self.named_load(phrase, None)?;
        let moment = self.reading.system.moment_of_loads(&loads, about);
        Some(Quantity::Known(Value::vector(&moment, Basis::Itself)))
    }

    /// The loads that letters stand for, where sentences say of each which load it is.
    pub(super) fn loads_of_letters(
        &mut self,
        letters: &[&Formula],
        declaration: &Declaration,
    ) -> Option<Vec<Load>> {
        let each = letters.iter();
        let named = each.map(|letter| self.loads_of_letter(letter, declaration));
        let named: Vec<Load> = named.collect::<Option<Vec<_>>>()?.concat();
        Some(named).filter(|named| !named.is_empty())
    }

    /// Whether a sentence says that a letter is a load of this kind.
    pub(super) fn is_said_to_be(&self, letter: &Formula, load: &NounPhrase) -> bool {
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == load.head => {
                formulas(subjects).any(|own| same_letter(own, letter))
            }
            _ => false,
        })
    }

    /// The loads that a letter stands for, where a sentence says which load it is.
    pub(super) fn loads_of_letter(
        &mut self,
        letter: &Formula,
        declaration: &Declaration,
    ) -> Option<Vec<Load>> {
        if let Some(load) = self.spring_by_letter(letter) {
            return Some(vec![load]);
        }
        let quantity = self.quantity_of(letter, declaration)?;
        let value = self.system().value_of(&quantity).ok()?;
        if let Ok(size) = value.to_scalar() {
            let value = self.axis_of_letter(letter)? * size;
            return Some(vec![Load::unnamed(None, value, None)]);
        }
        let value = value.to_vector().ok()?;
        let loads = &self.reading.system.loads;
        let own = loads.iter().find(|load| {
            !matches!(load.called, Called::Letter(_) | Called::Nothing) && load.value == value
        })?;
        Some(self.loads_called(&own.called.clone()))
    }

    /// "`K` is the moment of the motor on the wheel along z": the axis along which a letter says how much of a moment there is.
    fn axis_of_letter(&mut self, letter: &Formula) -> Option<Vector> {
        let declarations = self.declarations;
        let (along, said) = declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                let own = formulas(subjects).any(|own| same_letter(own, letter));
                let one = is_couple_of_a_kind(what.head)
                    || what.head == MOMENT
                        && (self.agent_outside(what, None).is_some()
                            || self.is_between(what, None));
                let along = what
                    .slot(Slot::Along)
                    .or_else(|| self.axis_of_load(&what.slots));
                along.filter(|_| own && one).map(|along| (along, d))
            }
            _ => None,
        })?;
        self.direction(&along.clone(), said, None)
    }
}

/// What a load is called that a noun names: with its adjectives, and by what exerts it.
pub(super) fn noun_of(load: &NounPhrase, agent: Option<&str>) -> String {
    // What something does to a body that it touches is its force.
    let head = match load.head {
        CONTACT_FORCE if agent.is_some() => FORCE,
        head => head,
    };
    let noun = [load.adjectives.as_slice(), &[head]].concat();
    let agent = agent.map_or_else(String::new, |agent| format!(" of {agent}"));
    noun.join(" ") + &agent
}
