//! Sentences with a word that the model has nothing for, and that turns what they say into something else: they tell nothing.

use crate::notation::ast::Kind;
use crate::verify::language::adjectives::{has_plain_adjectives, idle_adjective};
use crate::verify::language::heads::{
    DOWNHILL, EXCEPT, KEEPS_DIRECTION, MASS, NOTHING, OPPOSITE_TO, PLAIN_ADVERBS, POSITIVE_ABOUT,
    POSITIVE_TOWARDS, TOWARDS, TOWARDS_GROWING, UNDERBRACE, UPHILL, VERTICAL, WAY_OF_SETTING,
    WEIGHT,
};
use crate::verify::language::statement::{
    Declaration, NotationMeaning, NounPhrase, Sign, Slot, Statement, Term,
};
use crate::verify::language::wants::Wants;
use crate::verify::language::{is_body, is_load, only_names};
use crate::verify::reading::contradictory::unless_contradictory;
use crate::verify::reading::corners_read::CORNER;
use crate::verify::reading::densities_read::is_per_unit;
use crate::verify::reading::instants_read::instant_of;
use crate::verify::reading::listed_frames::of_each_frame;
use crate::verify::reading::makeup_read::if_spread_unevenly;
use crate::verify::reading::names::node_of;
use crate::verify::reading::values_told::with_zero_said;
use std::collections::BTreeMap;

/// Verbs of motions, whose adverbs say how.
const MOTIONS: [&str; 4] = ["turn", "roll", "swing", "precess"];

/// Which way something is counted, where no axis tells it.
const SENSES: [&str; 5] = [
    POSITIVE_TOWARDS,
    POSITIVE_ABOUT,
    OPPOSITE_TO,
    TOWARDS,
    TOWARDS_GROWING,
];

/// What bodies have and their masses have not.
const SIZES: [&str; 5] = ["radius", "length", "height", "width", MASS];

/// Directions that a letter is said to be.
const DIRECTIONS: [&str; 3] = [VERTICAL, DOWNHILL, UPHILL];

/// The sentences, and one that was not understood in the place of each that tells nothing; and of those of which one can
/// say why: they contradict another one, or a word in them is idle.
pub(super) fn heard(declarations: Vec<Declaration>) -> (Vec<Declaration>, BTreeMap<String, Wants>) {
    let (left, contradictions) = unless_contradictory(declarations);
    let all = of_each_frame(left).into_iter().map(with_zero_said);
    let all: Vec<Declaration> = all.collect();
    let idle = all.iter().filter_map(|declaration| {
        let (word, noun) = idle_adjective(&declaration.statement)?;
        let wants = Wants::Adjective(word.to_owned(), noun.to_owned());
        Some((declaration.sentence().to_owned(), wants))
    });
    let mut wants: BTreeMap<String, Wants> = idle.collect();
    let otherwise = contradictions.into_iter();
    wants.extend(otherwise.map(|(sentence, other)| (sentence, Wants::OneOfTwo(other))));
    (all.into_iter().map(heard_or_unread).collect(), wants)
}

/// The sentence, or one that was not understood in its place.
fn heard_or_unread(declaration: Declaration) -> Declaration {
    let declaration = if_spread_unevenly(declaration);
    match is_misheard(&declaration.statement) {
        true => declaration.not_understood(),
        false => declaration,
    }
}

fn is_misheard(statement: &Statement) -> bool {
    let several = statement.subjects().len();
    let twice = |slots: &[(Slot, Term)]| is_said_twice(slots, several);
    // The edges at a corner run along several axes.
    let corner = matches!(statement, Statement::Is { what, .. } if what.head == CORNER);
    if !has_plain_adjectives(statement) || !corner && statement.slots().any(twice) {
        return true;
    }
    match statement {
        // A formula that cannot be read says nothing of what it is to explain.
        Statement::Means { meaning, .. } => node_of(meaning).is_none(),
        Statement::Same { others, .. } => others.iter().any(|other| match other {
            Term::Formula(formula) => node_of(formula).is_none(),
            _ => false,
        }),
        // What a thing consists of are things.
        Statement::Does {
            verb: "consist",
            slots,
            ..
        } => slots.iter().any(|(_, term)| is_quantity(term)),
        // From which direction the vertical is turned, and towards which one, tells all.
        Statement::Does {
            subjects,
            verb: "turn",
            slots,
        } if subjects.iter().all(|subject| subject.is_noun(VERTICAL)) => {
            let mut hows = slots.iter().filter(|(slot, _)| *slot == Slot::With);
            hows.any(|(_, how)| !how.is_noun(TOWARDS))
        }
        Statement::Does { verb, slots, .. } => is_done_otherwise(verb, slots),
        Statement::Is { subjects, what } => {
            // What would be fixed in itself is another thing.
            let itself = what.all(Slot::FixedIn).any(|of| subjects.contains(of));
            itself || statement.tells_sense() || is_told_otherwise(subjects, what)
        }
        Statement::Premise(what) => is_premise_misheard(what),
        // Primes and labels mean nothing by themselves; other signs do by custom.
        Statement::Notation { sign, meaning } => {
            let plain = matches!(
                sign,
                Sign::Mark("prime")
                    | Sign::Label { .. }
                    | Sign::Custom(UNDERBRACE | WAY_OF_SETTING)
            );
            // One label has no components on two frames.
            let on_several = match meaning {
                NotationMeaning::Noun(noun) => noun.all(Slot::On).count() > 1,
                _ => false,
            };
            let labelled = matches!(sign, Sign::Label { .. });
            *meaning == NotationMeaning::Fixed(NOTHING) && !plain || labelled && on_several
        }
        _ => false,
    }
}

/// Whether a premise says more, or other, than what is worked with.
fn is_premise_misheard(what: &NounPhrase) -> bool {
    // Where or when alone nothing else acts is not worked with.
    let listed = is_load(what.head) && (what.is("only") || what.is("no"));
    let placed = |at: &Term| instant_of(Slot::At, at).is_none();
    listed && what.all(Slot::At).any(placed)
        || (what.head != MASS && is_per_unit(what))
        || has_reversed(&what.slots)
}

/// Whether something is said to be what a word makes another thing.
fn is_told_otherwise(subjects: &[Term], what: &NounPhrase) -> bool {
    let with = is_body(what.head) && what.all(Slot::With).any(is_of_thing);
    let together = subjects.len() > 1 && has_total(what);
    let turned = |subject: &Term| is_negative(subject) || is_weight(subject);
    let opposite = DIRECTIONS.contains(&what.head) && subjects.iter().any(turned);
    let counted = what.head != "angle" && has_sense(what);
    let per_unit = what.head != MASS && is_per_unit(what);
    let less = only_names(what.head) && what.all(Slot::With).any(takes_away);
    // A component along the negative third axis is the opposite of that along it.
    let told = |slot: Slot, axis: &Term| {
        let numbered = matches!(axis, Term::Phrase(axis) if axis.slot(Slot::Which).is_some());
        what.head == "component" && slot == Slot::Along && numbered
    };
    let mut slots = what.slots.iter();
    let reversed = slots.any(|(slot, term)| is_reversed(term) && !told(*slot, term));
    // The axes of a frame are none, and no formula of letters is a body.
    let other = what.head == "frame" && subjects.iter().any(is_of_frame);
    let upon_formula = is_load(what.head) && what.all(Slot::Upon).any(is_negative);
    // A mass has no size but itself.
    let of_mass = SIZES.contains(&what.head) && what.all(Slot::Of).any(|of| of.is_noun(MASS));
    let strange = other || upon_formula || of_mass;
    with || less || together || opposite || counted || per_unit || reversed || strange
}

/// "the axes of A"
fn is_of_frame(subject: &Term) -> bool {
    matches!(subject, Term::Phrase(part) if ["axes", "axis", "point"].contains(&part.head))
}

/// "except the sign"; of a total load other loads may be left out.
fn takes_away(how: &Term) -> bool {
    let load = |of: &Term| matches!(of, Term::Phrase(load) if is_load(load.head));
    match how {
        Term::Phrase(except) => except.head == EXCEPT && !except.all(Slot::Of).all(load),
        _ => false,
    }
}

/// Whether something is done in a way that makes another thing of it.
fn is_done_otherwise(verb: &str, slots: &[(Slot, Term)]) -> bool {
    // "P lies along x, and Q opposite to it": which side Q is on is not said of P.
    let opposite =
        matches!(verb, "lie" | "place") && slots.iter().any(|(_, how)| how.is_noun(OPPOSITE_TO));
    let strange = |(slot, how): &(Slot, Term)| *slot == Slot::With && !is_plain(how);
    // About a negative axis a thing turns the other way, and along one a point lies on the other side.
    let from = slots.iter().any(|(slot, _)| *slot == Slot::From);
    let about = |(slot, _): &&(Slot, Term)| match slot {
        Slot::About => verb == "turn",
        Slot::Along => verb == "lie" && from,
        _ => false,
    };
    let mut others = slots.iter().filter(|slot| !about(slot));
    // At a thing, a motion is one at some time alone: "at the top".
    let timed = |(slot, at): &(Slot, Term)| *slot == Slot::At && is_of_thing(at);
    let moves = MOTIONS.contains(&verb);
    opposite
        || moves && slots.iter().any(strange)
        || (moves || verb == KEEPS_DIRECTION) && slots.iter().any(timed)
        || others.any(|(_, term)| is_reversed(term))
}

/// What is said once of a thing: a second one is of another thing, or makes the first another one.
const ONCE: [Slot; 9] = [
    Slot::About,
    Slot::RelativeTo,
    Slot::SeenFrom,
    Slot::Along,
    Slot::By,
    Slot::At,
    Slot::Through,
    Slot::From,
    Slot::To,
];

fn is_quantity(term: &Term) -> bool {
    matches!(term, Term::Phrase(phrase) if only_names(phrase.head))
}

/// "P and Q are particles of total mass `$m$`": neither has what both have together.
fn has_total(what: &NounPhrase) -> bool {
    let total = |size: &Term| matches!(size, Term::Phrase(size) if size.is("total"));
    is_body(what.head) && what.all(Slot::Of).any(total)
}

/// Whether it is, and not once of each of several subjects.
fn is_said_twice(slots: &[(Slot, Term)], several: usize) -> bool {
    // Of several conditions each holds.
    let said = |wanted: &Slot| {
        let own = |(slot, term): &&(Slot, Term)| slot == wanted && !term.is_condition();
        slots.iter().filter(own).count()
    };
    let mut said = ONCE.iter().map(said);
    said.any(|times| times > 1 && times != several)
}

/// "a hub with a wheel"
fn is_of_thing(term: &Term) -> bool {
    match term {
        Term::Phrase(phrase) => is_body(phrase.head),
        Term::Name(name) => is_body(name),
        _ => false,
    }
}

/// "`$-z$` is the upward vertical"
fn is_negative(subject: &Term) -> bool {
    match subject {
        Term::Formula(formula) => {
            node_of(formula).is_some_and(|node| matches!(node.kind, Kind::Negate(_)))
        }
        _ => false,
    }
}

/// "Gravity points up": where up is it does not say.
fn is_weight(subject: &Term) -> bool {
    matches!(subject, Term::Phrase(weight) if weight.head == WEIGHT)
}

fn has_reversed(slots: &[(Slot, Term)]) -> bool {
    slots.iter().any(|(_, term)| is_reversed(term))
}

/// Whether it is said which way something is counted.
fn has_sense(what: &NounPhrase) -> bool {
    what.slots.iter().any(|(_, term)| match term {
        Term::Phrase(inner) => SENSES.contains(&inner.head) || has_sense(inner),
        _ => false,
    })
}

/// "clockwise", "without friction" change what a motion is; "without slipping" and "freely" are what the model knows.
fn is_plain(how: &Term) -> bool {
    matches!(how, Term::Phrase(how) if PLAIN_ADVERBS.contains(&how.head))
}

/// "the negative z axis"
fn is_reversed(term: &Term) -> bool {
    let of = |phrase: &NounPhrase| {
        phrase.is("negative") || phrase.slots.iter().any(|(_, term)| is_reversed(term))
    };
    matches!(term, Term::Phrase(phrase) if of(phrase))
}
