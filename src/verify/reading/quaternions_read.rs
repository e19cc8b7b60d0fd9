//! Sentences about quaternions.

use crate::algebra::Place;
use crate::verify::language::heads::{
    CONJUGATE, PURE_QUATERNION, QUATERNION, SCALAR_FIRST, SCALAR_LAST, SCALAR_PART, VECTOR_PART,
};
use crate::verify::language::statement::{
    Declaration, Formula, NounPhrase, Slot, Statement, Term, slot,
};
use crate::verify::model::atoms::{Key, Motion, fraction, whole};
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
            self.turn_by_parts(declaration);
            self.turn_by_told_attitude(declaration);
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

    /// "`$w$` is the scalar part of the quaternion of B relative to N": that one has to be known as well.
    fn turn_by_parts(&mut self, declaration: &Declaration) {
        let Statement::Is { what, .. } = &declaration.statement else {
            return;
        };
        let of = what.slot(Slot::Of).and_then(ends_of_quaternion);
        let parts = [SCALAR_PART, VECTOR_PART].contains(&what.head);
        for end in of.filter(|_| parts).map_or(vec![], |(of, to)| vec![of, to]) {
            if let Some(frame) = self.frame(end) {
                self.system().frames[frame].by_quaternion = true;
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
        if phrase.head == PURE_QUATERNION {
            return self.pure_quaternion(phrase, declaration);
        }
        let of = phrase.slot(Slot::Of)?;
        let of = match self.quaternion_between(of) {
            Some(quaternion) => quaternion,
            None => match self.operand(of, declaration)? {
                Quantity::Known(of) => of,
                _ => return None,
            },
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

    /// "the quaternion of B relative to N", which takes components on B to those on N.
    fn quaternion_between(&mut self, term: &Term) -> Option<Value> {
        let (of, relative) = ends_of_quaternion(term)?;
        let (from, to) = (self.frame(of)?, self.frame(relative)?);
        let layout = self.reading.letters.customs.layout;
        self.system().quaternion(to, from, layout)
    }

    /// "the quaternion whose vector part is `$v$` and whose scalar part is zero".
    fn pure_quaternion(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let of = self.operand(phrase.slot(Slot::Of)?, declaration)?;
        let vector = self.system().value_of(&of).ok()?;
        let frame = self.reading.letters.component_frame;
        let vector = self.system().written_out(&vector, frame).ok()?;
        let layout = self.reading.letters.customs.layout;
        let (scalar, first) = layout.places();
        let mut entries = vec![whole(0); 4];
        for (place, entry) in vector.to_vector().ok()?.iter().enumerate() {
            entries[first + place] = entry.clone();
        }
        entries[scalar] = whole(0);
        Some(Quantity::Known(Value::written(4, 1, entries)))
    }
}

/// Of what a quaternion is, and relative to what: "the quaternion of B relative to N".
fn ends_of_quaternion(term: &Term) -> Option<(&Term, &Term)> {
    match term {
        Term::Phrase(of) if of.head == QUATERNION => {
            Some((of.slot(Slot::Of)?, of.slot(Slot::RelativeTo)?))
        }
        _ => None,
    }
}
