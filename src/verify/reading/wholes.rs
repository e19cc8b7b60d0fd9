//! Which body a term or a phrase names.

use crate::verify::language::statement::{NounPhrase, Slot, Term};
use crate::verify::model::system::BodyId;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{index_letter, name_of};
use crate::verify::term::quantity::Whole;

impl Builder<'_> {
    pub(super) fn body(&self, term: &Term) -> Option<BodyId> {
        let name = name_of(term)?;
        self.bodies.get(&name).copied()
    }

    pub(super) fn whole(&self, term: &Term) -> Option<Whole> {
        if let Term::Member { family, index } = term {
            let family = *self.families.get(family)?;
            return Some(Whole::Member(family, index_letter(index)));
        }
        self.body(term).map(Whole::Body)
    }

    /// The body that a phrase is of; the only one where it says none, and none where it says several.
    pub(super) fn whole_of(&self, phrase: &NounPhrase) -> Option<Whole> {
        match phrase.all(Slot::Of).collect::<Vec<_>>().as_slice() {
            [term] => self.whole(term),
            [_, ..] => None,
            [] => self.only_body().map(Whole::Body),
        }
    }

    /// Whether a body would be one of its own parts.
    pub(super) fn is_part_of_itself(&self, whole: BodyId, parts: &[BodyId]) -> bool {
        let system = &self.reading.system;
        let mut parts = parts.iter();
        parts.any(|&part| system.wholes(part).contains(&whole))
    }

    /// The only body, or the one of which all others are parts.
    pub(super) fn only_body(&self) -> Option<BodyId> {
        let bodies = &self.reading.system.bodies;
        let own: Vec<BodyId> = (0..bodies.len())
            .filter(|&b| bodies[b].members.is_none())
            .collect();
        let is_part =
            |whole: BodyId, other: BodyId| other == whole || bodies[whole].parts.contains(&other);
        own.iter()
            .copied()
            .find(|&whole| own.iter().all(|&other| is_part(whole, other)))
    }
}
