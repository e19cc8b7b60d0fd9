//! What a sentence that was not understood may change where it tells what bodies are made up of.

use crate::verify::language::heads::{
    ANGULAR_MOMENTUM, INERTIA_TENSOR, KINETIC_ENERGY, MOMENT, MOMENT_OF_INERTIA, MOMENTUM,
    OF_PARTS, POTENTIAL_ENERGY, PRINCIPAL_MOMENTS, TOTAL_ENERGY,
};
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{letter_of, nodes_of, reach_of};
use crate::verify::reading::unused::{Touches, Unused};
use crate::verify::term::letters::spelled;
use std::collections::BTreeSet;

/// What the parts of a body add up to.
const ADDED_UP: [&str; 9] = [
    ANGULAR_MOMENTUM,
    INERTIA_TENSOR,
    KINETIC_ENERGY,
    MOMENT,
    MOMENT_OF_INERTIA,
    MOMENTUM,
    POTENTIAL_ENERGY,
    PRINCIPAL_MOMENTS,
    TOTAL_ENERGY,
];

impl Builder<'_> {
    /// "The satellite is … the system of the hub and the wheel", of which nothing was understood: the momentum of the satellite
    /// needn't be that of one rigid body, and what holds of its inertia and of the moments on it neither.
    pub(super) fn say_makeup_unheard(&mut self) {
        let lost = |d: &&Declaration| d.may_speak_of(&OF_PARTS);
        let lost: Vec<&Declaration> = self.declarations.iter().filter(lost).collect();
        if lost.is_empty() {
            return;
        }
        let wholes = self.letters_of_bodies();
        for declaration in lost {
            self.reading.unused.push(Unused {
                sentence: declaration.sentence().to_owned(),
                understood: false,
                beyond: false,
                names: false,
                tells: false,
                wants: None,
                reach: reach_of(&declaration.extent),
                letters: Some(BTreeSet::new()),
                about: BTreeSet::new(),
                connected: None,
                touches: Touches::Written(wholes.clone()),
            });
        }
    }

    /// The letters, spelled, of what the parts of bodies add up to.
    fn letters_of_bodies(&self) -> Vec<String> {
        let of_body = |what: &NounPhrase| {
            let slots = [Slot::Of, Slot::Upon];
            let mut things = slots.iter().flat_map(|slot| what.all(*slot));
            ADDED_UP.contains(&what.head) && things.any(|thing| self.body(thing).is_some())
        };
        let told = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } if of_body(what) => Some(subjects),
            _ => None,
        });
        let letters = told.flatten().filter_map(letter_of);
        letters.flat_map(nodes_of).map(spelled).collect()
    }
}
