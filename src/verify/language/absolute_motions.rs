//! Motions that are called by the frame relative to which they are: "the absolute velocity of G", "the inertial angular velocity".

use super::fixed_axes::inertial_frame;
use super::heads::{
    ACCELERATION, ANGULAR_MOMENTUM, ANGULAR_VELOCITY, KINETIC_ENERGY, MOMENTUM, VELOCITY,
};
use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// Adjectives that say so of a motion.
const TELLING: [&str; 2] = ["absolute", "inertial"];

/// What is relative to a frame.
const MOTIONS: [&str; 10] = [
    VELOCITY,
    ACCELERATION,
    "speed",
    ANGULAR_VELOCITY,
    "angular acceleration",
    MOMENTUM,
    ANGULAR_MOMENTUM,
    KINETIC_ENERGY,
    "kinetic energy of rotation",
    "kinetic energy of translation",
];

/// Says of each such motion that it is relative to the inertial frame, where there is one.
pub(super) fn tell_absolute_motions(declarations: &mut [Declaration]) {
    let Some(ground) = inertial_frame(declarations).filter(|frame| name(frame).is_some()) else {
        return;
    };
    for declaration in declarations {
        if let Statement::Is { what, .. } = &mut declaration.statement {
            tell_motion(what, &ground);
        }
        for term in declaration.statement.terms_mut() {
            if let Term::Phrase(phrase) = term {
                tell_motion(phrase, &ground);
            }
        }
    }
}

fn tell_motion(phrase: &mut NounPhrase, ground: &Term) {
    for (_, inner) in &mut phrase.slots {
        if let Term::Phrase(inner) = inner {
            tell_motion(inner, ground);
        }
    }
    let told = phrase.adjectives.iter().position(|a| TELLING.contains(a));
    let free = phrase.slot(Slot::RelativeTo).is_none() && phrase.slot(Slot::SeenFrom).is_none();
    if let Some(at) = told.filter(|_| free && MOTIONS.contains(&phrase.head)) {
        phrase.adjectives.remove(at);
        phrase.slots.push((Slot::RelativeTo, ground.clone()));
    }
}
