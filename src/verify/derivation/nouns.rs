//! The quantities of a system by their nouns: what a sentence about a letter would say, and what is read of it.

use crate::notation::{Macros, read_formula};
use crate::verify::derivation::plan::{Plan, Subject};
use crate::verify::language::statement::{
    Declaration, Extent, Formula, NounPhrase, Slot, Statement, Term,
};
use crate::verify::language::{Lexicon, heads, sentence};
use crate::verify::model::system::{BodyId, FrameId};
use crate::verify::reading::Reading;
use crate::verify::reading::builder::build;
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use std::collections::HashMap;
use std::sync::Arc;

/// A quantity that a derivation may speak of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum Key {
    Turn(FrameId),
    Mass(BodyId),
    Way(BodyId),
    Velocity(BodyId),
    Acceleration(BodyId),
    Momentum(BodyId),
    Force(BodyId),
    AngularMomentum(BodyId),
    Moment(BodyId),
    Upward(BodyId),
    Kinetic(BodyId),
    Potential(BodyId),
    Total(BodyId),
    Load(BodyId, usize),
    MomentOfLoad(BodyId, usize),
    Sought,
}

/// Nouns with the quantities that they name.
#[derive(Default)]
pub(super) struct Nouns {
    known: HashMap<Key, (NounPhrase, Quantity)>,
}

/// A letter that no author has, by which a noun is read.
fn stand_in(number: usize) -> String {
    format!("\\xi_{{\\text{{noun {number}}}}}")
}

impl Nouns {
    /// Reads the declarations, and beside them what each noun names; a noun of which nothing is made is left out.
    pub(super) fn read(
        declarations: &[Declaration],
        plan: &Plan,
        sought: Option<&NounPhrase>,
    ) -> (Reading, Self) {
        let mut nouns = of_plan(plan);
        nouns.extend(sought.map(|noun| (Key::Sought, noun.clone())));
        let mut all = declarations.to_vec();
        let said = nouns.iter().enumerate();
        all.extend(said.map(|(number, (_, noun))| telling(&[&stand_in(number)], noun.clone())));
        let mut reading = build(&all, Arc::default(), 0);
        let mut known = HashMap::new();
        for (number, (key, noun)) in nouns.into_iter().enumerate() {
            let letter = stand_in(number);
            let found = reading.letters.letters.iter().find(|l| l.latex == letter);
            if let Some(Meaning::Quantity(quantity)) = found.map(|letter| &letter.meaning) {
                known.insert(key, (noun, quantity.clone()));
            }
        }
        reading
            .letters
            .letters
            .retain(|letter| !letter.latex.starts_with("\\xi_{\\text{noun "));
        (reading, Self { known })
    }

    pub(super) fn of(&self, key: Key) -> Option<&(NounPhrase, Quantity)> {
        self.known.get(&key)
    }

    pub(super) fn sought(&self) -> Option<&Quantity> {
        self.of(Key::Sought).map(|(_, quantity)| quantity)
    }

    /// What else names the quantity that is asked for.
    pub(super) fn key_of_sought(&self) -> Option<Key> {
        let sought = self.sought()?;
        let others = self.known.iter().filter(|(key, _)| **key != Key::Sought);
        let same = others.filter(|(_, (_, quantity))| quantity == sought);
        same.map(|(key, _)| *key).min()
    }
}

/// The declaration that letters are what a noun says.
pub(super) fn telling(letters: &[&str], noun: NounPhrase) -> Declaration {
    let subjects = letters
        .iter()
        .map(|latex| Term::Formula(formula(latex)))
        .collect();
    declared(
        Statement::Is {
            subjects,
            what: noun,
        },
        Extent::Document,
    )
}

/// The declaration of a statement, in the words of the language.
pub(super) fn declared(statement: Statement, extent: Extent) -> Declaration {
    let mut declaration = Declaration {
        statement,
        extent,
        text: String::new(),
        line: 0,
    };
    declaration.text = sentence(&declaration, Lexicon::shared());
    declaration
}

/// A formula as it stands in a sentence.
pub(super) fn formula(latex: &str) -> Formula {
    use crate::notation::ast::{Kind, Node};
    use crate::notation::document::Row;
    let mut rows = read_formula(latex, 0, &Macros::default()).into_iter();
    let row = rows.next().unwrap_or_else(|| {
        Row::Expression(Node {
            kind: Kind::Ellipsis,
            span: crate::source::Span::default(),
        })
    });
    Formula {
        source: latex.to_owned(),
        row,
    }
}

/// The nouns of all that there is to tell.
fn of_plan(plan: &Plan) -> Vec<(Key, NounPhrase)> {
    let mut nouns = vec![];
    for (frame, term) in &plan.frames {
        let slots = vec![
            (Slot::Of, term.clone()),
            (Slot::RelativeTo, plan.ground.clone()),
        ];
        nouns.push((
            Key::Turn(*frame),
            NounPhrase::new(heads::ANGULAR_VELOCITY, slots),
        ));
    }
    for subject in &plan.bodies {
        of_body(plan, subject, &mut nouns);
        of_loads(subject, &mut nouns);
    }
    nouns
}

fn of_body(plan: &Plan, subject: &Subject, nouns: &mut Vec<(Key, NounPhrase)>) {
    let body = subject.body;
    let of = (Slot::Of, subject.term.clone());
    let centre = (Slot::Of, subject.centre_term.clone());
    let about = (Slot::About, subject.about_term.clone());
    let ground = (Slot::RelativeTo, plan.ground.clone());
    let from = (Slot::RelativeTo, subject.about_term.clone());
    let upward = plan.vertical.clone().map(|v| (Slot::Along, v));
    let mut add = |key, head, slots: &[&(Slot, Term)]| {
        let slots = slots.iter().map(|slot| (*slot).clone()).collect();
        let adjectives = match key {
            Key::Force(_) | Key::Moment(_) => vec!["total"],
            _ => vec![],
        };
        let noun = NounPhrase {
            adjectives,
            ..NounPhrase::new(head, slots)
        };
        nouns.push((key, noun));
    };
    add(Key::Mass(body), heads::MASS, &[&of]);
    add(Key::Way(body), heads::POSITION, &[&centre, &from]);
    add(Key::Velocity(body), heads::VELOCITY, &[&centre, &ground]);
    add(
        Key::Acceleration(body),
        heads::ACCELERATION,
        &[&centre, &ground],
    );
    add(Key::Momentum(body), heads::MOMENTUM, &[&of, &ground]);
    add(Key::Force(body), heads::FORCE, &[&of]);
    add(
        Key::AngularMomentum(body),
        heads::ANGULAR_MOMENTUM,
        &[&of, &about, &ground],
    );
    add(Key::Moment(body), heads::MOMENT, &[&of, &about]);
    add(Key::Kinetic(body), heads::KINETIC_ENERGY, &[&of, &ground]);
    add(Key::Potential(body), heads::POTENTIAL_ENERGY, &[&of]);
    add(Key::Total(body), heads::TOTAL_ENERGY, &[&of]);
    if let Some(upward) = &upward {
        let slots = [&of, &about, &ground, upward];
        add(Key::Upward(body), heads::ANGULAR_MOMENTUM, &slots);
    }
}

fn of_loads(subject: &Subject, nouns: &mut Vec<(Key, NounPhrase)>) {
    for (number, load) in subject.loads.iter().flatten().enumerate() {
        let mut force = load.noun.clone();
        force.slots.retain(|(slot, _)| *slot != Slot::Which);
        if force.head == heads::WEIGHT && force.slot(Slot::Of).is_none() {
            force.slots.push((Slot::Of, subject.term.clone()));
        }
        let slots = vec![
            (Slot::Of, Term::Phrase(Box::new(force.clone()))),
            (Slot::About, subject.about_term.clone()),
        ];
        nouns.push((Key::Load(subject.body, number), force));
        nouns.push((
            Key::MomentOfLoad(subject.body, number),
            NounPhrase::new(heads::MOMENT, slots),
        ));
    }
}
