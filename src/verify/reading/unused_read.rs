//! Sentences of which nothing was made, and what they keep from being denied.

use crate::notation::ast::Node;
use crate::verify::language::heads::{CONSTANT, FORCE, KEEPS_DIRECTION, MOMENT};
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::verify::language::{is_body, is_quantity};
use crate::verify::model::system::BodyId;
use crate::verify::reading::bodies_read::WHOLES;
use crate::verify::reading::builder::{Builder, MOST_TERMS, place_in};
use crate::verify::reading::corners_read::CORNER;
use crate::verify::reading::makeup_read::HOLLOW;
use crate::verify::reading::named_loads_read::names_load;
use crate::verify::reading::names::{node_of, nodes_of, reach_of};
use crate::verify::reading::parallels_read::are_moments;
use crate::verify::reading::touched::{tells_anew, touched_by};
use crate::verify::reading::unused::{Unused, letters_of_subjects};
use crate::verify::reading::unused_letters::{in_formula, is_small, letters_named_by};
use crate::verify::term::letters::spelled;

/// Verbs that build the system or name letters.
const HEARD: [&str; 11] = [
    KEEPS_DIRECTION,
    "act",
    "obey",
    "roll",
    "turn",
    "take",
    "have components",
    "number",
    "consist",
    "lie",
    "place",
];

/// Verbs of motions by which nothing is turned.
pub(super) const MOVING: [&str; 4] = ["move", "slide", "swing", "fall"];

/// Places of which the model knows nothing.
const UNPLACED: [&str; 9] = [
    "middle", "end", "rim", "corner", "centre", "apex", "pivot", "base", "surface",
];

/// After so many sentences that were too much no more are taken in.
const MOST_BEYOND: usize = 4;

impl Builder<'_> {
    /// Values at instants that labels mean: what is told of them is not worked with.
    fn say_instants_unheard(&mut self) {
        if self.reading.letters.instants.is_empty() {
            return;
        }
        for declaration in self.declarations {
            let at = place_in(&reach_of(&declaration.extent));
            let letters = &self.reading.letters;
            let formulas = declaration.statement.formulas();
            let mut nodes = formulas.into_iter().flat_map(nodes_of);
            if nodes.any(|node| letters.speaks_of_instant(node, &at)) {
                self.reading.instants.labelled = true;
                self.say_unused(declaration);
            }
        }
    }

    /// Verbs and nouns for which the model has no law yet.
    pub(super) fn say_unheard(&mut self) {
        self.say_instants_unheard();
        self.say_springs_unread();
        self.say_statements_unheard();
        self.say_unbound();
        self.say_makeup_unheard();
    }

    fn say_statements_unheard(&mut self) {
        for declaration in self.declarations {
            let heard = match &declaration.statement {
                Statement::Does {
                    verb: "incline", ..
                } => self.is_tilted(),
                Statement::Does {
                    subjects,
                    verb: "lie",
                    slots,
                } => {
                    self.is_lying_heard(subjects, slots)
                        || self.lies_on_axis_of_rotor(subjects, slots, declaration)
                        || self.tells_height_above_contact(&declaration.statement)
                }
                Statement::Does {
                    subjects,
                    verb: "point",
                    ..
                } if are_moments(subjects) => true,
                Statement::Does {
                    subjects,
                    verb: "point",
                    slots,
                } if self.axis_along_letter(subjects, slots).is_some() => true,
                Statement::Does {
                    subjects,
                    verb: "point",
                    ..
                } => subjects.iter().all(|subject| {
                    let body = self.body(subject);
                    let line = body.and_then(|body| self.reading.system.bodies[body].line);
                    let letter = matches!(subject, Term::Formula(_));
                    line.is_some() || letter || self.is_force(subject)
                }),
                Statement::Does { verb, .. } if MOVING.contains(verb) => {
                    self.moves_as_modelled(declaration)
                }
                Statement::Does {
                    subjects,
                    verb: "pass",
                    ..
                } => subjects.iter().all(|axis| self.is_axis_of_surface(axis)),
                Statement::Does {
                    verb: "strike" | "stick",
                    ..
                } => self.is_strike_read(),
                Statement::Does { verb, .. } => HEARD.contains(verb),
                Statement::Is { subjects, what } => self.has_use_for(subjects, what),
                Statement::Unread { .. } => false,
                _ => true,
            };
            if !heard {
                self.say_unused(declaration);
            }
        }
    }

    /// Whether the model moves things as a sentence says that they move.
    pub(super) fn moves_as_modelled(&mut self, declaration: &Declaration) -> bool {
        match &declaration.statement {
            Statement::Does {
                subjects,
                verb: "move" | "slide",
                ..
            } if self.move_as_points(subjects) => true,
            Statement::Does {
                subjects,
                verb: "move",
                slots,
            } if self.plane_of_motion(subjects, slots, declaration).is_some() => true,
            Statement::Does {
                subjects,
                verb: "swing" | "move" | "fall",
                ..
            } => subjects.iter().all(|subject| self.swings(subject)),
            _ => false,
        }
    }

    fn swings(&self, subject: &Term) -> bool {
        let swings = |body| self.turns_in_plane(body) && self.moves_in_vertical_plane(body);
        self.body(subject).is_some_and(swings)
    }

    /// "The axis of the tube passes through O": of a tube in which something rolls.
    fn is_axis_of_surface(&self, axis: &Term) -> bool {
        match axis {
            Term::Phrase(axis) if axis.head == "axis" => {
                self.is_place_of_surface(axis.slot(Slot::Of))
            }
            _ => false,
        }
    }

    /// Whether the model has something for what is said of things: nothing yet for the ends and rims of bodies, for several
    /// bodies that are one, and for those that are free.
    fn has_use_for(&self, subjects: &[Term], what: &NounPhrase) -> bool {
        let of_body = what
            .slot(Slot::Of)
            .and_then(|term| self.body(term))
            .is_some();
        // What acts need not be placed.
        let acts = matches!(what.head, FORCE | MOMENT);
        let rim = what.all(Slot::Of).any(|term| match term {
            Term::Phrase(of) => !acts && UNPLACED.contains(&of.head),
            _ => false,
        });
        let one = what.is("one") && WHOLES.contains(&what.head) && subjects.len() > 1;
        let things = !subjects.iter().all(|subject| in_formula(subject).is_some());
        let sized = what.head == "vector" && what.slot(Slot::Of).is_some();
        let resting = what.head == "point" && what.slot(Slot::At).is_some();
        // What is fixed in something that the model has not is not said to be free of it.
        let thing = |t: &Term| match t {
            Term::Name(name) => name.starts_with(char::is_lowercase),
            term => matches!(term, Term::Phrase(_) | Term::Formula(_)),
        };
        let mut fixed_in = what.all(Slot::FixedIn);
        let lost = fixed_in.any(|t| thing(t) && self.frame(t).is_none());
        // What is smooth tells of loads, which another sentence lists or none does.
        let of_loads = ["smooth", "rough"].contains(&what.head) && !self.lists_loads();
        let nothing = what.head == "free"
            || what.head == "equal" && things
            || sized
            || resting
            || lost
            || of_loads
            || what.head == HOLLOW
            || what.head == "smooth" && !subjects.iter().all(|s| self.is_smooth_heard(s));
        let placed = match what.head {
            CORNER => subjects.iter().all(|s| self.is_corner_placed(s)),
            "centre" => self.is_place_of_surface(what.slot(Slot::Of)),
            _ => self.is_end_placed(what),
        };
        let named = |t: &Term| what.head == "centre" && self.is_only_named(t);
        let idle = what.slot(Slot::Of).is_some_and(named);
        let unplaced = UNPLACED.contains(&what.head) && !placed && !idle;
        !(of_body && unplaced || rim || one || nothing)
    }

    /// Whether sentences speak of a body only as of what acts on others, and of its centre: where that is matters to nothing.
    fn is_only_named(&self, thing: &Term) -> bool {
        let Some(body) = self.body(thing) else {
            return false;
        };
        self.declarations.iter().all(|d| {
            let own = |term: &Term| self.speaks_of_body(term, body);
            match &d.statement {
                Statement::Is { subjects, what } => {
                    let bare = is_body(what.head) && what.slots.is_empty();
                    let centre = what.head == "centre" && what.slots.len() == 1;
                    let hanging = what.slots.iter().any(|(_, term)| own(term));
                    let told = !is_load(what) && hanging && !centre;
                    !told && (bare || !subjects.iter().any(own))
                }
                statement => {
                    let (slots, about) = match statement {
                        Statement::Premise(premise) => (premise.slots.as_slice(), &[][..]),
                        Statement::Does {
                            subjects, slots, ..
                        } => (slots.as_slice(), subjects.as_slice()),
                        statement => (&[][..], statement.subjects()),
                    };
                    let mut terms = slots.iter().map(|(_, term)| term).chain(about);
                    !terms.any(own)
                }
            }
        })
    }

    /// Whether a term speaks of a body, but as of what acts on another one.
    fn speaks_of_body(&self, term: &Term, body: BodyId) -> bool {
        let hanging = match term {
            Term::Phrase(phrase) if !is_load(phrase) => {
                let mut slots = phrase.slots.iter();
                slots.any(|(_, inner)| self.speaks_of_body(inner, body))
            }
            _ => false,
        };
        hanging || self.body(term) == Some(body)
    }

    /// Whether a sentence says which loads are the only ones.
    pub(super) fn lists_loads(&self) -> bool {
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Premise(premise) => premise.is("only") || premise.is("no"),
            _ => false,
        })
    }

    /// Each statement of a sentence of several is one of its own, with its letters.
    pub(super) fn say_unused(&mut self, declaration: &Declaration) {
        let sentence = declaration.sentence().to_owned();
        let reach = reach_of(&declaration.extent);
        let letters = self.letters_left(declaration);
        let about = letters_of_subjects(&declaration.statement);
        let known = |u: &Unused| {
            let same = u.about == about && (u.letters.is_none() || u.letters == letters);
            u.sentence == sentence && u.reach == reach && same
        };
        if self.reading.unused.iter().any(known) {
            return;
        }
        self.reading.unused.push(Unused {
            sentence,
            understood: !declaration.is_unread(),
            beyond: false,
            names: names_quantity(&declaration.statement),
            tells: tells_anew(&declaration.statement),
            wants: None,
            reach,
            letters,
            about,
            connected: None,
            touches: touched_by(&declaration.statement, self.declarations),
        });
    }

    /// What a sentence says a letter to be is not what another one says: nothing is known of the letter.
    pub(super) fn say_told_otherwise(&mut self, declaration: &Declaration) {
        self.say_unused(declaration);
        let sentence = declaration.sentence();
        let own = self.reading.unused.iter_mut();
        own.filter(|u| u.sentence == sentence)
            .for_each(|unused| unused.tells = true);
    }

    /// What a sentence says makes the model larger than what is worked out: it is not in force.
    pub(super) fn say_beyond(&mut self, declaration: &Declaration) {
        self.say_unused(declaration);
        // Where several sentences were too much, the next ones will be: the work ends.
        self.reading.terms += MOST_TERMS / MOST_BEYOND;
        let sentence = declaration.sentence();
        let own = self.reading.unused.iter_mut();
        own.filter(|u| u.sentence == sentence).for_each(|unused| {
            (unused.letters, unused.beyond) = (None, true);
        });
    }

    /// A sentence about a letter that another one tells of as well says more than what the letter is.
    pub(super) fn widen_unused(&mut self) {
        for declaration in self.declarations {
            let Some(nodes) = letters_named_by(&declaration.statement) else {
                continue;
            };
            // That a letter is small matters where it stands, whatever it is.
            if is_small(&declaration.statement) {
                continue;
            }
            let mut known = self.reading.letters.letters.iter();
            let told = known.any(|letter| nodes.iter().any(|node| spelled(node) == letter.spelled));
            let elsewhere = self
                .declarations
                .iter()
                .any(|other| other.line != declaration.line && speaks_of(&other.statement, &nodes));
            if told && elsewhere {
                let sentence = declaration.sentence();
                let own = self.reading.unused.iter_mut();
                own.filter(|u| u.sentence == sentence)
                    .for_each(|unused| unused.letters = None);
            }
        }
    }
}

/// Whether a noun means what acts on bodies.
pub(super) fn is_load(what: &NounPhrase) -> bool {
    names_load(what) || matches!(what.head, FORCE | MOMENT)
}

/// Whether a sentence says what quantity something is, and of no adjective alone.
fn names_quantity(statement: &Statement) -> bool {
    matches!(statement, Statement::Is { what, .. } if is_quantity(what.head) && what.head != CONSTANT)
}

/// Whether one of some letters stands in a statement.
fn speaks_of(statement: &Statement, letters: &[&Node]) -> bool {
    let terms = statement.terms().into_iter();
    let mut formulas = terms.filter_map(|term| match term {
        Term::Formula(formula) => node_of(formula),
        _ => None,
    });
    formulas.any(|formula| {
        letters
            .iter()
            .any(|letter| spelled(letter) == spelled(formula))
    })
}
