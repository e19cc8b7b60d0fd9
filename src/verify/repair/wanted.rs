//! What would have to stand in a place for a false line to hold.
//!
//! The difference of the sides is linear in what stands in most places of a line. Then two readings, of the line and
//! of the line with 1 added at the place, give the value that is wanted there; a table of what the document could
//! write there names it. All values are taken in one world of the prime field, so that the table is a look-up; what
//! comes out is an edit like any other, and is proved before it is shown.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Line};
use crate::notation::document::Format;
use crate::scalar::Prime;
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::correction::edit::{Edit, edited};
use crate::verify::letters::frame::Frame;
use crate::verify::repair::places::{Around, Place, Role, visit};
use crate::verify::repair::trial::Search;
use crate::verify::repair::vocabulary::{Word, difference};
use crate::verify::theory::world::World;
use num_traits::{One, Zero};
use std::collections::HashMap;

/// Places of a line that are looked at.
const PLACES: usize = 80;
/// Worlds that are tried for one in which the line has a value.
const WORLDS: u64 = 6;

/// A place with what decides what is wanted there.
struct Probe<'a> {
    place: Place<'a>,
    text: String,
    value: Fraction,
    /// The difference of the sides with 1 added here.
    shifted: Vec<Fraction>,
}

/// A place, and what must stand there.
pub(crate) struct Slot<'a> {
    place: Place<'a>,
    text: String,
    /// The value that stands there.
    now: Prime,
    /// What must be added to it.
    pub(crate) more: Prime,
}

/// What is wanted in each place of a line, and the words that could stand there.
pub(crate) struct Wanted<'a> {
    pub(crate) slots: Vec<Slot<'a>>,
    pub(crate) words: Vec<Word>,
    /// The value of each word, where it has one that is not zero.
    pub(crate) values: Vec<Option<Prime>>,
    /// Whether the document is plain text.
    pub(crate) unicode: bool,
    at: HashMap<Prime, usize>,
}

impl Checker<'_> {
    /// What is wanted in each place of a line; `None` where the line has no value.
    pub(crate) fn wanted<'n>(
        &mut self,
        line: &'n Line,
        search: &mut Search<'_>,
    ) -> Option<Wanted<'n>> {
        let residual = self.residual_with(line, &[], search)?;
        let mut places = vec![];
        for side in &line.sides {
            visit(side, Around::Nothing, &mut places);
        }
        places.retain(|place| !place.roles.is_empty());
        places.truncate(PLACES);
        let probes: Vec<Probe<'n>> = places
            .into_iter()
            .filter_map(|place| self.probe(line, place, residual.len(), search))
            .collect();
        let words = self.vocabulary(line);
        let unicode = self.document.format == Format::Text;
        let theory = &mut self.theory;
        let found = (1..=WORLDS).find_map(|seed| {
            let mut world: World<Prime> = World::new(theory, seed);
            let gap = values(&mut world, &residual)?;
            let wants: Vec<Option<(Prime, Prime)>> = probes
                .iter()
                .map(|probe| want(&mut world, probe, &gap))
                .collect();
            let known: Vec<Option<Prime>> = words
                .iter()
                .map(|word| world.fraction(&word.value).filter(|value| !value.is_zero()))
                .collect();
            Some((wants, known))
        });
        let exhausted = std::mem::take(&mut self.theory.exhausted);
        let (wants, values) = found.filter(|_| !exhausted)?;
        let slot = |(probe, want): (Probe<'n>, Option<(Prime, Prime)>)| {
            let (now, more) = want?;
            Some(Slot {
                place: probe.place,
                text: probe.text,
                now,
                more,
            })
        };
        let slots = probes.into_iter().zip(wants).filter_map(slot).collect();
        let mut at = HashMap::new();
        for (i, value) in values.iter().enumerate() {
            if let Some(value) = value {
                at.entry(*value).or_insert(i);
            }
        }
        Some(Wanted {
            slots,
            words,
            values,
            unicode,
            at,
        })
    }

    /// The difference of the sides of the line, with some edits.
    pub(crate) fn residual_with(
        &mut self,
        line: &Line,
        edits: &[&Edit],
        search: &mut Search<'_>,
    ) -> Option<Vec<Fraction>> {
        let text = self.document.source.slice(line.span);
        let text = edited(text, line.span.start, edits)?;
        let reads = self.reads(&text, search)?;
        Some(reads.first()?.residuals().cloned().collect())
    }

    fn probe<'n>(
        &mut self,
        line: &Line,
        place: Place<'n>,
        entries: usize,
        search: &mut Search<'_>,
    ) -> Option<Probe<'n>> {
        let span = place.node.span;
        if span.start < line.span.start || line.span.end < span.end {
            return None;
        }
        let value = self.lowering(Frame::Moving).scalar(place.node)?;
        let text = self.document.source.slice(span).to_owned();
        let edit = Edit {
            span,
            text: format!("({text} + 1)"),
            kind: "",
            message: String::new(),
            cost: 0,
        };
        let shifted = self.residual_with(line, &[&edit], search)?;
        (shifted.len() == entries).then_some(Probe {
            place,
            text,
            value,
            shifted,
        })
    }
}

pub(crate) fn values(world: &mut World<'_, Prime>, fractions: &[Fraction]) -> Option<Vec<Prime>> {
    fractions.iter().map(|f| world.fraction(f)).collect()
}

/// What stands in a place, and the one value to be added to it that makes every component of the difference vanish.
fn want(world: &mut World<'_, Prime>, probe: &Probe<'_>, gap: &[Prime]) -> Option<(Prime, Prime)> {
    let shifted = values(world, &probe.shifted)?;
    let now = world.fraction(&probe.value)?;
    let mut more = None;
    for (gap, shifted) in gap.iter().zip(shifted) {
        match (shifted - *gap).inverse() {
            None if !gap.is_zero() => return None,
            None => {}
            Some(inverse) => {
                let here = -*gap * inverse;
                if *more.get_or_insert(here) != here {
                    return None;
                }
            }
        }
    }
    more.filter(|more| !more.is_zero()).map(|more| (now, more))
}

impl Wanted<'_> {
    /// Edits of one symbol, one factor or sign, and one lost symbol.
    pub(crate) fn symbols(&self) -> Vec<Edit> {
        let each = |slot: &Slot<'_>| -> Vec<Edit> {
            let edit = |role: &Role| match role {
                Role::Symbol => self.other_symbol(slot),
                Role::Term => slot.other_factor(self.unicode),
                Role::Sum => self.lost_symbol(slot),
            };
            let single = slot.place.roles.iter().filter_map(edit);
            single.chain(self.lost_parameter(slot)).collect()
        };
        self.slots.iter().flat_map(each).collect()
    }

    fn lost_symbol(&self, slot: &Slot<'_>) -> Option<Edit> {
        let signs = [("+", slot.more), ("-", -slot.more)];
        let term = signs
            .into_iter()
            .find_map(|(sign, value)| Some(format!(" {sign} {}", self.word(value)?.text)))?;
        Some(slot.with_term(&term, 18))
    }

    /// A mass, or another number of the document, that a term or a sum is to be multiplied by.
    fn lost_parameter(&self, slot: &Slot<'_>) -> Option<Edit> {
        let ratio = (slot.now + slot.more) * slot.now.inverse()?;
        let word = self.word(ratio).filter(|word| word.is_parameter())?;
        let sum = matches!(slot.place.node.kind, Kind::Negate(_) | Kind::Sum(_));
        let text = match sum {
            true => format!("{} ({})", word.text, slot.text),
            false => format!("{} {}", word.text, slot.text),
        };
        let message = format!("a factor {} is missing", word.text);
        Some(slot.edit(text, "factor", 12, message))
    }

    /// Whether every other symbol at these bytes has been thought of.
    pub(crate) fn covers(&self, span: Span) -> bool {
        let there = |slot: &Slot<'_>| {
            slot.place.roles.contains(&Role::Symbol) && slot.place.node.span == span
        };
        self.slots.iter().any(there)
    }

    fn other_symbol(&self, slot: &Slot<'_>) -> Option<Edit> {
        // By its text: what stands there may be zero, or equal to another.
        let written = self
            .words
            .iter()
            .find(|word| word.text == slot.text.trim())?;
        let wanted = self.word(slot.now + slot.more)?;
        let (kind, cost) = difference(written, wanted)?;
        let message = match kind {
            "missing-dot" => "a dot is missing".to_owned(),
            "extra-dot" => "a dot too many".to_owned(),
            _ => format!("{} should be {}", slot.text.trim(), wanted.text),
        };
        Some(slot.edit(wanted.text.clone(), kind, cost, message))
    }

    fn word(&self, value: Prime) -> Option<&Word> {
        self.at.get(&value).and_then(|&i| self.words.get(i))
    }
}

impl Slot<'_> {
    fn edit(&self, text: String, kind: &'static str, cost: u32, message: String) -> Edit {
        Edit {
            span: self.place.node.span,
            text,
            kind,
            message,
            cost,
        }
    }

    /// Whether a term of several factors may be added here.
    pub(crate) fn is_sum(&self) -> bool {
        self.place.roles.contains(&Role::Sum)
            && (self.place.around != Around::Factors
                || matches!(self.place.node.kind, Kind::Sum(_)))
    }

    /// The edit that adds a term with its sign.
    pub(crate) fn with_term(&self, term: &str, cost: u32) -> Edit {
        let whole = format!("{}{term}", self.text);
        let whole = match self.place.around {
            Around::Nothing => whole,
            _ => format!("({whole})"),
        };
        self.edit(
            whole,
            "missing-term",
            cost,
            format!("a term is missing:{term}"),
        )
    }

    fn other_factor(&self, unicode: bool) -> Option<Edit> {
        let ratio = (self.now + self.more) * self.now.inverse()?;
        let text = match self.place.node.kind {
            Kind::Negate(_) | Kind::Sum(_) => format!("({})", self.text),
            _ => self.text.clone(),
        };
        let half = if unicode { "½" } else { "\\tfrac{1}{2}" };
        let missing = |number: &str| format!("a factor {number} is missing");
        if ratio == Prime::new(2) {
            return Some(self.edit(format!("2 {text}"), "factor", 15, missing("2")));
        }
        if ratio + ratio == Prime::one() {
            return Some(self.edit(format!("{half} {text}"), "factor", 14, missing("½")));
        }
        let sign = ratio == -Prime::one() && self.place.around == Around::Nothing;
        // Of s = a b, the sign is wrong on the right.
        let cost = match self.place.node.kind {
            Kind::Symbol(_) | Kind::TimeDerivative { .. } => 16,
            _ => 11,
        };
        sign.then(|| {
            self.edit(
                format!("-{text}"),
                "sign",
                cost,
                "the sign is wrong".to_owned(),
            )
        })
    }
}
