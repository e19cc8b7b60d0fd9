//! What each line of a document is for: by words, by what it speaks of, by what sentences say of it.

use crate::notation::ast::{Line, Node, Relation};
use crate::verify::Role;
use crate::verify::standing::chains::Link;
use crate::verify::standing::judge::Judge;
use crate::verify::standing::roles::{Purpose, purpose};

impl Judge<'_> {
    /// What the line that is looked at is for; a sentence about the line itself counts most.
    pub(super) fn purpose_of(&self, line: &Line, links: &[Link], display: bool) -> Purpose {
        let mut purpose = purpose(&self.words.sentence).on(line.continues, links);
        if !display {
            purpose = purpose.in_text(links);
        }
        let sides: Vec<&Node> = links.iter().flat_map(|l| [&l.left, &l.right]).collect();
        if !purpose.derived && self.reading.chooses_reference(&sides) {
            purpose.role = Role::Assume;
        }
        if let Some(role) = self.reading.role(&self.at, &sides) {
            purpose = Purpose {
                role,
                derived: role == Role::Claim,
                declared: true,
                ..Purpose::default()
            };
        }
        if line.relations.iter().all(|(r, _)| *r == Relation::Defined) {
            purpose.role = Role::Define;
        }
        purpose
    }
}
