//! What each line of a document is for: by words, by what it speaks of, by what sentences say of it.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Line, Node, Relation};
use crate::verify::Role;
use crate::verify::model::atoms::fraction;
use crate::verify::standing::chains::Link;
use crate::verify::standing::hold::Held;
use crate::verify::standing::judge::Judge;
use crate::verify::standing::roles::{Purpose, purpose};
use crate::verify::term::letters::{Letter, Meaning, loosely, spelled};
use crate::verify::term::quantity::Quantity;
use std::collections::BTreeSet;

/// Words by which what a sentence says holds in a case alone.
const CONDITIONS: [&str; 5] = ["if", "whenever", "suppose", "unless", "provided"];

/// Who works something out: what they do is no case.
const WORKERS: [&str; 3] = ["i", "we", "you"];

/// Whether the words before a formula in running text make it one of a case.
fn is_conditional(sentence: &str) -> bool {
    let words = || sentence.split(|c: char| !c.is_alphabetic());
    let one_of = |words: &[&str], word: &str| words.iter().any(|w| w.eq_ignore_ascii_case(word));
    let mut pairs = words().zip(words().skip(1));
    pairs.any(|(word, next)| one_of(&CONDITIONS, word) && !one_of(&WORKERS, next))
}

impl Judge<'_> {
    /// Whether a formula stands behind a name and a colon on its line: "(c) Symmetric body: …" says of nothing that it is
    /// so.
    pub(super) fn is_only_named(&self, line: &Line) -> bool {
        let text = &self.document.source.text;
        let before = text[..line.span.range().start].trim_end_matches(['$', '\\', '(', '`']);
        let beside = before
            .rsplit('\n')
            .next()
            .is_some_and(|line| line.contains(':'));
        let paragraph = self.words.sentence.rsplit('\n').next();
        let paragraph = paragraph.unwrap_or("").trim_end();
        beside && paragraph.ends_with(':') && paragraph.split_whitespace().count() <= 5
    }

    /// What the line that is looked at is for; a sentence about the line itself counts most.
    pub(super) fn purpose_of(&self, line: &Line, links: &[Link<'_>], display: bool) -> Purpose {
        let mut purpose = purpose(&self.words.sentence).on(line.continues, links);
        if !display {
            purpose = purpose.in_text(links);
            purpose.doubtful |= is_conditional(&self.words.sentence);
        }
        let sides: Vec<&Node> = links.iter().flat_map(|l| l.sides()).collect();
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

    /// What holds at the start gives the values that the motion starts from. A line there that relates what moves to what
    /// moves may be worked out: it is a claim where it follows, and open where it does not.
    pub(super) fn unless_it_relates(&self, purpose: Purpose, held: &[Held]) -> Purpose {
        let given = purpose.declared && purpose.role == Role::Given;
        let starts = given && self.reading.is_given_at_start(&self.at);
        let atoms = &self.reading.system.atoms;
        let moves = |side: &Fraction| {
            let known = |v: &Variable| !atoms.is_unknown(*v) && !atoms.is_constant(&fraction(*v));
            let variables: BTreeSet<_> = side.variables().into_iter().filter(known).collect();
            variables
        };
        // A value is of one quantity, on one side.
        let relates = |h: &Held| {
            let moving = |(left, right): &(Fraction, Fraction)| (moves(left), moves(right));
            let moving: Vec<_> = h.sides.iter().map(moving).collect();
            let on_left = moving.iter().any(|(left, _)| !left.is_empty());
            let on_right = moving.iter().any(|(_, right)| !right.is_empty());
            let many = moving
                .iter()
                .any(|(left, right)| left.union(right).count() > 1);
            on_left && on_right || many
        };
        match starts && held.iter().any(relates) {
            true => Purpose {
                doubtful: true,
                ..Purpose::default()
            },
            false => purpose,
        }
    }

    /// Whether a line stands in another part, and says nothing of this one.
    pub(super) fn passes_over(&self, links: &[Link<'_>]) -> bool {
        let elsewhere = self
            .part
            .passes_over(links, &self.reading.letters, &self.at);
        elsewhere && !self.binds_as_premise(links)
    }

    /// Whether a line of another part is declared to hold, and this part is a case of that one.
    fn binds_as_premise(&self, links: &[Link<'_>]) -> bool {
        let sides: Vec<&Node> = links.iter().flat_map(|l| l.sides()).collect();
        let role = self.reading.role(&self.at, &sides);
        self.part.is_case_of(&self.at) && matches!(role, Some(Role::Given | Role::Assume))
    }

    /// Whether a line sets a unit vector, of which no sentence tells where it points, to something.
    pub(super) fn chooses_direction(&self, line: &Line) -> bool {
        let [left, _] = line.sides.as_slice() else {
            return false;
        };
        let letters = &self.reading.letters;
        let is_direction = |letter: &Letter| {
            matches!(
                letter.meaning,
                Meaning::Quantity(Quantity::UnitVector { .. })
            )
        };
        if !letters.letters.iter().any(is_direction) {
            return false;
        }
        let told = letters.find(&spelled(left), &loosely(left), &self.at, 1);
        told.is_some_and(is_direction)
    }
}
