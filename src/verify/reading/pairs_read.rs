//! Columns of two entries: the components of vectors on two axes of a frame, for motion in the plane of both.

use crate::verify::language::heads::COLUMNS_OF_TWO;
use crate::verify::language::statement::{
    NotationMeaning, NounPhrase, Sign, Slot, Statement, Term,
};
use crate::verify::model::system::{AxisPair, FrameId};
use crate::verify::reading::builder::Builder;

impl Builder<'_> {
    /// "A column of two holds the first two components on N", "… components on x and y".
    pub(super) fn read_columns_of_two(&mut self) {
        for declaration in self.declarations {
            let Statement::Notation {
                sign: Sign::Custom(COLUMNS_OF_TWO),
                meaning,
            } = &declaration.statement
            else {
                continue;
            };
            let NotationMeaning::Noun(phrase) = meaning else {
                self.say_unused(declaration);
                continue;
            };
            let on = phrase.slot(Slot::On).and_then(|on| self.frame(on));
            let first = on.filter(|_| are_the_first(phrase));
            let pair = first.map(|frame| (frame, [0, 1]));
            match pair.or_else(|| self.pair_of_axes(phrase)) {
                Some((frame, axes)) if phrase.head == "component" => {
                    let told = true;
                    self.system().axis_pair = Some(AxisPair { frame, axes, told });
                }
                _ => self.say_unused(declaration),
            }
        }
    }

    /// "in components on x and y": two axes of one frame.
    pub(super) fn pair_of_axes(&self, phrase: &NounPhrase) -> Option<(FrameId, [usize; 2])> {
        self.pair_of(phrase.all(Slot::On).cloned())
    }

    /// Two axes of one frame.
    pub(super) fn pair_of(
        &self,
        axes: impl Iterator<Item = Term>,
    ) -> Option<(FrameId, [usize; 2])> {
        let axes: Option<Vec<(FrameId, usize)>> =
            axes.map(|axis| self.axis_of_frame(&axis)).collect();
        match axes?.as_slice() {
            &[(frame, one), (other, two)] if frame == other && one != two => {
                Some((frame, [one, two]))
            }
            _ => None,
        }
    }
}

/// "the first two components on N": not the last ones.
fn are_the_first(components: &NounPhrase) -> bool {
    let which = components.slot(Slot::Which);
    which.is_none_or(|which| *which == Term::Numbers(vec![1]))
}
