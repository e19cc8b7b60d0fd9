//! Links that other documents of the same reading had before.

use crate::algebra::{Argument, Combination, Fraction, Reason};
use crate::notation::ast::{Line, Node, Relation, Symbol};
use crate::notation::document::Format;
use crate::recent::Digest;
use crate::verify::Diagnosis;
use crate::verify::reading::Reading;
use crate::verify::standing::chains::Link;
use crate::verify::standing::hold::{Held, Sides};
use crate::verify::standing::judge::Judge;
use crate::verify::standing::memory::{Formula, Memory, Recall, Wording};
use crate::verify::standing::trial::Tried;
use crate::verify::standing::verdicts::Standing;
use crate::verify::term::integrals::has_integral;
use crate::verify::term::letters::Reach;
use foldhash::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// What links came to whose proofs and sides have more terms is not kept.
const MOST_TERMS: usize = 1_000;

/// What links came to and what put lines right, for documents that begin with the same facts.
#[derive(Clone, Debug, Default)]
pub(crate) struct Links(Memory<Held>, Memory<Correction>, Numbers);

/// The same, as one document uses it.
#[derive(Debug)]
pub(super) struct Recalled(Recall<Held>, Recall<Correction>, Numbers);

/// Numbers that letters come to in each of their forms, in the variables with which the documents begin.
type Numbers = Arc<Mutex<[HashMap<Symbol, Fraction>; FORMS]>>;

/// No more letters are kept in each form: as they are, with a dot, squared.
const MOST_LETTERS: usize = 200;
const FORMS: usize = 3;

/// What puts a line right, with places counted from its first byte, and what it took to find that.
#[derive(Clone, Debug)]
pub(crate) struct Correction {
    pub(crate) diagnosis: Diagnosis,
    pub(crate) spent: usize,
}

/// How a correction is looked for, and how often it was asked before what else the document writes.
pub(crate) struct AskedFor {
    wording: Wording,
    asked: usize,
}

impl Links {
    /// A memory for what is read so, if a link is worth the same on every line.
    pub(crate) fn of(reading: &Reading) -> Option<Self> {
        let everywhere = |reach: &Reach| *reach == Reach::All;
        let sizes = &reading.sizes;
        let one = reading.letters.is_uniform()
            && reading.premises.iter().all(|p| everywhere(&p.reach))
            && reading.settled.is_empty()
            && reading.unused.is_empty()
            && reading.instants.all.is_empty()
            && reading.letters.instants.is_empty()
            && sizes.orders.is_empty()
            && sizes.small.is_empty()
            && sizes.remainders.is_empty();
        one.then(Self::default)
    }

    /// For a document that is read so.
    pub(super) fn used_by(self, reading: &mut Reading) -> Recalled {
        let held = Recall::new(self.0, &mut reading.system);
        Recalled(held, Recall::new(self.1, &mut reading.system), self.2)
    }
}

impl Held {
    /// Whether both are what one link came to.
    fn is_same(&self, other: &Self) -> bool {
        let plain = |held: &Self| {
            (
                held.standing,
                [held.beyond, held.alone, held.restricts, held.at_instants],
            )
        };
        let shown = |held: &Self| held.shown.as_ref().map(Arc::as_ptr);
        Arc::ptr_eq(&self.sides, &other.sides)
            && plain(self) == plain(other)
            && shown(self) == shown(other)
            && self.settles.is_none()
            && other.settles.is_none()
            && (&self.reason, &self.doubt, &self.unknown)
                == (&other.reason, &other.doubt, &other.unknown)
            && self.proof == other.proof
    }
}

impl Judge<'_> {
    /// What one link is worth.
    pub(super) fn hold(&mut self, link: &Link<'_>) -> Held {
        let tree = self.again.tree.take();
        let wording = self.wording(link, tree);
        if let Some(held) = self.recall(wording) {
            return held;
        }
        // What hangs on what else is written is the same where the same is.
        let beside = wording.map(|wording| wording.beside(self.writing()));
        if let Some(held) = self.recall(beside) {
            self.reading.letters.written.note_asked();
            return held;
        }
        let asked = self.reading.letters.written.times_asked();
        self.again.weighed = None;
        let held = self.hold_anew(link);
        let weighed = self.again.weighed.take();
        let hangs = self.reading.letters.written.times_asked() != asked;
        let wording = if hangs { beside } else { wording };
        match weighed.filter(|(_, weighed)| held.is_same(weighed)) {
            Some((other, _)) => self.remember_as(wording, other),
            None => self.remember(wording, &held),
        }
        held
    }

    /// What the document writes, as it is looked for.
    fn writing(&mut self) -> Digest {
        let written = &self.reading.letters.written;
        *self.again.writing.get_or_insert_with(|| written.digest())
    }

    /// What a link is worth whose sides are worked out: the same for all writings of these.
    pub(super) fn weigh(&mut self, link: &Link<'_>, worked_out: Sides) -> Held {
        let plain = self.again.recalled.is_some()
            && worked_out.unknown.is_empty()
            && worked_out.settles.is_none()
            && !link.sides().into_iter().any(has_integral);
        let sides = worked_out.sides.clone();
        let of = plain.then(|| Formula::of_sides(&sides));
        let wording = of.and_then(|of| self.beside(&of));
        let held = match self.recall(wording) {
            Some(held) => held,
            None => {
                let held = self.weigh_anew(link, worked_out);
                self.remember(wording, &held);
                held
            }
        };
        self.again.weighed = wording.map(|wording| (wording, held.clone()));
        held
    }

    /// Whether a link with these sides, in this document or another one, was found to be entailed.
    pub(super) fn is_entailed_by_sides(&mut self, sides: &[(Fraction, Fraction)]) -> bool {
        let wording = self.beside(&Formula::of_sides(sides));
        let held = self.recall(wording);
        held.is_some_and(|held| held.standing == Standing::Entailed)
    }

    /// A link as it is looked for; `None` for one that is not kept.
    fn wording(&mut self, link: &Link<'_>, tree: Option<Digest>) -> Option<Wording> {
        let relation = link.relation;
        if !matches!(relation, Relation::Equal | Relation::Defined) {
            return None;
        }
        self.again.recalled.as_ref()?;
        let of = Formula::of_link(link, tree, relation as usize)?;
        self.beside(&of)
    }

    /// A formula beside the variables that there are; `None` where lines of this document were taken into the facts.
    fn beside(&mut self, of: &Formula<'_>) -> Option<Wording> {
        if self.facts.are_too_many || !self.reading.settled.is_empty() {
            return None;
        }
        let recalled = self.again.recalled.as_mut()?;
        recalled.0.wording(&self.reading.system, of)
    }

    /// How what puts a line right is looked for; `None` where the line does not tell it alone.
    pub(crate) fn correction_of(&mut self, line: &Line) -> Option<AskedFor> {
        let document = self.document;
        let plain = document.macros.is_empty() && !document.macros.decimal_comma;
        let tells_all = plain && document.format != Format::Text && !line.continues;
        if !tells_all || self.facts.are_too_many || !self.reading.settled.is_empty() {
            return None;
        }
        let of = Formula::of_line(line, document.source.slice(line.span))?;
        let recalled = self.again.recalled.as_mut()?;
        Some(AskedFor {
            wording: recalled.1.wording(&self.reading.system, &of)?,
            asked: self.reading.letters.written.times_asked(),
        })
    }

    /// What put the same line right in another document.
    pub(crate) fn recall_correction(&mut self, of: &AskedFor) -> Option<Arc<Correction>> {
        let recalled = self.again.recalled.as_mut()?;
        recalled.1.known(&mut self.reading.system, of.wording)
    }

    /// Keeps what puts a line right, unless it hangs on what else the document writes.
    pub(crate) fn keep_correction(&mut self, of: AskedFor, correction: Correction) {
        let same = self.reading.letters.written.times_asked() == of.asked;
        if let Some(recalled) = self.again.recalled.as_mut().filter(|_| same) {
            let system = &self.reading.system;
            recalled.1.keep(system, of.wording, Arc::new(correction), 0);
        }
    }

    /// The number that a letter came to in one of its forms in another document that is read alike.
    pub(crate) fn number_of_letter(&self, symbol: &Symbol, form: usize) -> Option<Fraction> {
        let recalled = self.again.recalled.as_ref()?;
        if self.facts.are_too_many || !self.reading.settled.is_empty() {
            return None;
        }
        // Nothing in it is ever half done.
        let numbers = recalled.2.lock().unwrap_or_else(PoisonError::into_inner);
        numbers[form].get(symbol).cloned()
    }

    /// What a letter in one of its forms comes to, which is kept if it is a number and the same for all documents.
    pub(crate) fn tried_letter(&mut self, (symbol, form): (&Symbol, usize), node: &Node) -> Tried {
        let state = |own: &Self| {
            let reading = &own.reading;
            (
                reading.system.atoms.changes(),
                reading.letters.written.times_asked(),
            )
        };
        let before = state(self);
        let found = self.tried(node);
        let same =
            state(self) == before && self.reading.settled.is_empty() && !self.facts.are_too_many;
        if let (Tried::Number(number), Some(recalled)) = (&found, &self.again.recalled)
            && same
            && recalled.0.is_of_beginning(number)
        {
            let numbers = recalled.2.lock();
            let numbers = &mut numbers.unwrap_or_else(PoisonError::into_inner)[form];
            if numbers.len() < MOST_LETTERS {
                numbers.insert(symbol.clone(), number.clone());
            }
        }
        found
    }

    fn recall(&mut self, wording: Option<Wording>) -> Option<Held> {
        let recalled = self.again.recalled.as_mut()?;
        let held = recalled.0.known(&mut self.reading.system, wording?)?;
        Some(Held::clone(&held))
    }

    /// Keeps that a link came to what another wording did.
    fn remember_as(&mut self, wording: Option<Wording>, other: Wording) {
        if let (Some(recalled), Some(wording)) = (&mut self.again.recalled, wording) {
            recalled.0.keep_as(&self.reading.system, wording, other);
        }
    }

    fn remember(&mut self, wording: Option<Wording>, held: &Held) {
        let alone = held.unknown.is_empty()
            && held.settles.is_none()
            && !held.beyond
            && !self.facts.are_too_many;
        let terms = terms(held);
        let wording = wording.filter(|_| alone && terms <= MOST_TERMS);
        if let (Some(recalled), Some(wording)) = (&mut self.again.recalled, wording) {
            let system = &self.reading.system;
            recalled
                .0
                .keep(system, wording, Arc::new(held.clone()), terms);
        }
    }
}

/// How many terms a link and its proof have.
fn terms(held: &Held) -> usize {
    let sides = held.sides.iter().flat_map(|(left, right)| [left, right]);
    let sides = sides.map(|side| side.numerator().len() + side.denominator().len());
    let arguments = held.proof.iter().flat_map(|proof| proof.arguments());
    sides.chain(arguments.map(terms_of)).sum()
}

fn terms_of(argument: &Argument) -> usize {
    let facts = argument.facts.iter();
    let facts = facts.map(|fact| match &fact.reason {
        Reason::Combination(by) => fact.value.len() + terms_by(by),
        _ => fact.value.len(),
    });
    let goals = argument.goals.iter().map(|goal| terms_by(&goal.by));
    facts.chain(goals).sum()
}

fn terms_by(by: &Combination) -> usize {
    let cofactors = by.cofactors.iter().map(|(_, cofactor)| cofactor.len());
    by.multiplier.len() + cofactors.sum::<usize>()
}
