//! Sentences about quaternions.

use crate::algebra::Place;
use crate::verify::language::heads::{CONJUGATE, SCALAR_FIRST, SCALAR_LAST, SCALAR_PART};
use crate::verify::language::statement::{
    Declaration, Formula, NounPhrase, Slot, Statement, Term, slot,
};
use crate::verify::model::atoms::{Key, Motion, fraction};
use crate::verify::model::system::FrameId;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::definitions_read::is_written_as;
use crate::verify::reading::letters_read::formulas;
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::quaternions::Layout;
use crate::verify::term::value::Value;

/// The layout that a sentence gives a quaternion: "scalar first".
pub(super) fn layout(slots: &[(Slot, Term)]) -> Option<Layout> {
    slots.iter().find_map(|(_, term)| match term {
        Term::Phrase(adverb) if adverb.head == SCALAR_FIRST => Some(Layout::ScalarFirst),
        Term::Phrase(adverb) if adverb.head == SCALAR_LAST => Some(Layout::ScalarLast),
        _ => None,
    })
}

/// "`$a$` and `$b$` are any quaternions, scalar first": nothing ties them to how something turns.
pub(super) fn is_free_quaternion(what: &NounPhrase) -> bool {
    what.is("any")
        && what
            .slots
            .iter()
            .all(|said| layout(std::slice::from_ref(said)).is_some())
}

impl Builder<'_> {
    /// Letters of quaternions that may be any, of four numbers each.
    pub(super) fn read_free_quaternions(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        let told = self.declarations.iter().flat_map(|d| d.statement.slots());
        let mut layouts: Vec<Layout> = told.filter_map(layout).collect();
        layouts.dedup();
        // All quaternions of a text have one layout.
        if layouts.len() > 1 {
            return self.say_unused(declaration);
        }
        let own = layout(&what.slots);
        let layout = own.unwrap_or(self.reading.letters.customs.layout);
        self.reading.letters.customs.layout = layout;
        for formula in formulas(subjects) {
            if self.quantity_of(formula, declaration).is_some()
                || self.is_told(formula, declaration)
            {
                continue;
            }
            let text = &formula.source;
            let entry = |place: usize| {
                let key = Key::of_number(format!("({text})_{place}"));
                fraction(
                    self.system()
                        .atoms
                        .variable(key, Place::Coordinate, Motion::Free),
                )
            };
            let entries = (0..4).map(entry).collect();
            let free = Quantity::Known(Value::written(4, 1, entries));
            self.denote(formula, Meaning::Quantity(free), declaration);
        }
    }

    /// Frames of whose quaternion a sentence speaks, which has to be known before any rotation is worked out.
    pub(super) fn turn_by_quaternions(&mut self) {
        for declaration in self.declarations {
            let Statement::Does {
                verb: "take",
                slots,
                ..
            } = &declaration.statement
            else {
                continue;
            };
            if layout(slots).is_none() {
                continue;
            }
            for end in [Slot::From, Slot::To] {
                if let Some(frame) = slot(slots, end).and_then(|term| self.frame(term)) {
                    self.system().frames[frame].by_quaternion = true;
                }
            }
        }
    }

    /// "`$q$` takes components on B to components on N, scalar first." All quaternions of a text have one layout.
    pub(super) fn denote_quaternion(
        &mut self,
        formula: &Formula,
        (from, to): (FrameId, FrameId),
        layout: Layout,
        declaration: &Declaration,
    ) {
        self.reading.letters.customs.layout = layout;
        match self.system().quaternion(to, from, layout) {
            Some(value) => {
                let known = Meaning::Quantity(Quantity::Known(value));
                self.denote(formula, known, declaration);
            }
            None => self.say_unused(declaration),
        }
    }

    /// "`$q_0$`, `$q_1$`, `$q_2$`, `$q_3$` are the components of `$q$`", in the order of its layout.
    pub(super) fn read_entries_of_quaternion(
        &mut self,
        subjects: &[Term],
        of: &Value,
        declaration: &Declaration,
    ) {
        if formulas(subjects).count() != of.entries.len() {
            return self.say_unused(declaration);
        }
        for (formula, entry) in formulas(subjects).zip(&of.entries) {
            let entry = Quantity::Known(Value::scalar(entry.clone()));
            self.denote(formula, Meaning::Quantity(entry), declaration);
        }
    }

    /// Whether another sentence says of a letter between which frames it takes components, as a quaternion.
    pub(super) fn is_told_turn(&self, letter: &Formula) -> bool {
        self.declarations.iter().any(|d| {
            let taking = d.statement.does("take");
            taking.is_some_and(|(subjects, slots)| {
                let own = |term: &Term| is_written_as(term, letter);
                layout(slots).is_some() && subjects.iter().any(own)
            })
        })
    }

    /// The conjugate of a quaternion, its scalar part or its vector part.
    pub(super) fn part_of_quaternion(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let Quantity::Known(of) = self.operand(phrase.slot(Slot::Of)?, declaration)? else {
            return None;
        };
        if !of.is_quaternion() {
            return None;
        }
        let layout = self.reading.letters.customs.layout;
        let (scalar, vector) = layout.places();
        Some(Quantity::Known(match phrase.head {
            CONJUGATE => of.conjugate(layout),
            SCALAR_PART => Value::scalar(of.entries[scalar].clone()),
            _ => Value::written(3, 1, of.entries[vector..vector + 3].to_vec()),
        }))
    }
}
