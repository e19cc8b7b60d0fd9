//! Smooth tracks: their force on what moves along them has no component along the motion.

use crate::verify::language::heads::FORCE;
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::verify::model::system::Vector;
use crate::verify::reading::builder::Builder;

/// The adjective of what has no friction.
const SMOOTH: &str = "smooth";
/// What guides: what moves along an axis moves along it.
const TRACKS: [&str; 6] = ["track", "rail", "guide", "groove", "slot", "wire"];
/// What is smooth where it joins bodies: its moments vanish, and not a component of its force.
const JOINTS: [&str; 4] = ["joint", "pivot", "bearing", "axle"];

impl Builder<'_> {
    /// "The track is smooth": its force on what moves along an axis is across that.
    pub(super) fn hold_smooth_force(
        &mut self,
        mover: &Term,
        axis: &Vector,
        declaration: &Declaration,
    ) -> Option<()> {
        for track in self.smooth_things() {
            if !is_track(&track) || !self.speaks_of_force(&track) {
                continue;
            }
            let slots = vec![(Slot::Of, track), (Slot::Upon, mover.clone())];
            let force = self.quantity(&NounPhrase::new(FORCE, slots), declaration)?;
            let force = self.system().value_of(&force).ok()?.to_vector().ok()?;
            self.hold(force.dot(axis), declaration);
        }
        Some(())
    }

    /// Whether that something is smooth tells nothing of a force of which sentences speak, or what it tells is held.
    pub(super) fn is_smooth_heard(&self, thing: &Term) -> bool {
        let joins = matches!(thing, Term::Name(name) if is_joint(name))
            || matches!(thing, Term::Phrase(joint) if JOINTS.contains(&joint.head));
        let held = is_track(thing) && self.declarations.iter().any(is_along);
        let directed = self.declarations.iter().any(|d| is_directed(d, thing));
        joins || held || directed || !self.speaks_of_force(thing)
    }

    fn smooth_things(&self) -> Vec<Term> {
        let said = self.declarations.iter().map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == SMOOTH => subjects.as_slice(),
            _ => &[],
        });
        said.flatten()
            .filter(|thing| !matches!(thing, Term::Formula(_)))
            .cloned()
            .collect()
    }

    /// Whether a sentence speaks of the force of a thing.
    fn speaks_of_force(&self, thing: &Term) -> bool {
        let of_thing = |term: &Term| is_force_of(term, thing);
        self.declarations.iter().any(|d| {
            let hanging = match &d.statement {
                Statement::Is { what, .. } => what.slots.as_slice(),
                Statement::Premise(premise) => premise.slots.as_slice(),
                Statement::Does { slots, .. } => slots.as_slice(),
                _ => &[],
            };
            let subjects = d.statement.subjects().iter();
            let own = matches!(&d.statement, Statement::Is { what, .. }
                if what.head == FORCE && what.all(Slot::Of).any(|of| of == thing));
            own || subjects
                .chain(hanging.iter().map(|(_, term)| term))
                .any(of_thing)
        })
    }
}

fn is_track(thing: &Term) -> bool {
    let guides = |name: &str| name.split(' ').any(|word| TRACKS.contains(&word));
    match thing {
        Term::Name(name) => guides(name),
        Term::Phrase(phrase) => guides(phrase.head),
        _ => false,
    }
}

fn is_joint(name: &str) -> bool {
    JOINTS.iter().any(|joint| name.starts_with(joint))
}

/// "the cart moves along x"
fn is_along(declaration: &Declaration) -> bool {
    let moves = declaration.statement.does("move");
    let moves = moves.or_else(|| declaration.statement.does("slide"));
    moves.is_some_and(|(_, slots)| slots.iter().any(|(slot, _)| *slot == Slot::Along))
}

/// "`$F$` is the force of the guide on the frame along `$i$`": that the guide is smooth tells no more of this force.
fn is_directed(declaration: &Declaration, thing: &Term) -> bool {
    match &declaration.statement {
        Statement::Is { what, .. } if what.head == FORCE => {
            what.all(Slot::Of).any(|of| of == thing) && what.slot(Slot::Along).is_some()
        }
        _ => false,
    }
}

/// Whether a term is the force of a thing, or something of that.
fn is_force_of(term: &Term, thing: &Term) -> bool {
    let Term::Phrase(phrase) = term else {
        return false;
    };
    let own = phrase.head == FORCE && phrase.all(Slot::Of).any(|of| of == thing);
    own || phrase
        .slots
        .iter()
        .any(|(_, inner)| is_force_of(inner, thing))
}
