//! Lines that speak of values at instants.
//!
//! Of one instant the line is judged as of any time. Of two, the second is any time t and the first a fixed one: both sides
//! are the same if they are so at the first, and their difference does not change.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node};
use crate::verify::language::messages::OTHER_INSTANTS;
use crate::verify::model::atoms::Nature;
use crate::verify::standing::chains::Link;
use crate::verify::standing::hold::{Held, Sides};
use crate::verify::standing::judge::Judge;
use crate::verify::standing::kept::{Images, put_in};
use crate::verify::standing::sides::both;
use crate::verify::standing::verdicts::Standing;
use crate::verify::term::at_instants::{Kept, Present};
use crate::verify::term::value::{GROWN, Trouble, Value};
use num_traits::Zero;
use std::collections::BTreeSet;

/// Differences are looked at with no more rates at the first instant.
const MOST_RATES: usize = 3;

impl Judge<'_> {
    /// What a link is worth that speaks of instants; none if it does not.
    pub(super) fn hold_at_instants(&mut self, link: &Link<'_>) -> Option<Held> {
        if self.reading.instants.blow {
            return Some(self.hold_at_blow(link));
        }
        if self.reading.letters.instants.is_empty() {
            return None;
        }
        let mut instants = BTreeSet::new();
        let known = link
            .sides()
            .into_iter()
            .all(|side| self.note_instants(side, false, &mut instants));
        let last = *instants.last()?;
        if !known || instants.len() > 2 {
            return Some(Held::open(OTHER_INSTANTS));
        }
        let held = match self.difference_at(link, last) {
            Ok((difference, unknown)) => self.hold_difference(link, difference, &unknown),
            Err(untold) => self.hold_sides(link, Err(untold)),
        };
        if held.standing == Standing::Denied && self.reading.instants.labelled {
            return Some(Held::open(OTHER_INSTANTS));
        }
        Some(Held {
            at_instants: true,
            ..held
        })
    }

    /// What a link is worth where sentences tell of both sides of a blow. What moves and has no label is taken at neither of
    /// them: such a link may be meant of one, and is not denied.
    fn hold_at_blow(&mut self, link: &Link<'_>) -> Held {
        let sides = self.sides(link, &BTreeSet::new());
        let held = self.hold_sides(link, sides);
        let all: Vec<Fraction> = held
            .sides
            .iter()
            .flat_map(|(l, r)| [l, r])
            .cloned()
            .collect();
        let system = &mut self.reading.system;
        let moves = all.is_empty() || all.iter().any(|side| system.moves_at_blow(side));
        match held.standing {
            Standing::Denied if moves => Held::open(OTHER_INSTANTS),
            _ => held,
        }
    }

    /// The instants that labels and limits of integrals name; false where a rate is taken of what does not change.
    fn note_instants(&self, node: &Node, in_rate: bool, found: &mut BTreeSet<usize>) -> bool {
        let letters = &self.reading.letters;
        let own = match &node.kind {
            Kind::Symbol(symbol) => letters.instant_of(symbol, &self.at),
            Kind::Integral {
                limits: Some((from, to)),
                ..
            } => {
                found.extend(letters.instant(from));
                letters.instant(to)
            }
            _ => None,
        };
        found.extend(own);
        let rate = in_rate || matches!(node.kind, Kind::TimeDerivative { .. });
        let mut parts = node.children();
        !(own.is_some() && in_rate) && parts.all(|part| self.note_instants(part, rate, found))
    }

    /// The left side less the right one at a time t, and the letters of which nothing is told.
    fn difference_at(
        &mut self,
        link: &Link<'_>,
        present: usize,
    ) -> Result<(Value, Vec<String>), (Trouble, Vec<String>)> {
        let mut lowering = self.lowering();
        lowering.present = Present::Is(present);
        let pair = both(&mut lowering, link);
        let unknown: Vec<String> = lowering.unknown.keys().cloned().collect();
        let pair = pair.map_err(|trouble| (trouble, unknown.clone()))?;
        let entries = pair.left.entries.iter().zip(&pair.right.entries);
        let entries = entries.map(|(left, right)| left.clone() - right.clone());
        Ok((pair.left.with_entries(entries.collect()), unknown))
    }

    fn hold_difference(&mut self, link: &Link<'_>, difference: Value, unknown: &[String]) -> Held {
        let (Some(first), Some(rate)) = (self.at_first(&difference), self.rate_of(&difference))
        else {
            return Held::open(GROWN);
        };
        let alone = first == difference.entries;
        let both = match alone {
            true => first,
            false => [first, rate.entries].concat(),
        };
        let held = self.weigh(link, vanishing(both, unknown));
        if alone || held.standing != Standing::Denied {
            return held;
        }
        let mut rate = Some(difference);
        for _ in 0..MOST_RATES {
            let Some(first) = rate.as_ref().and_then(|rate| self.at_first(rate)) else {
                break;
            };
            let held = self.weigh(link, vanishing(first, unknown));
            if held.standing == Standing::Denied {
                return held;
            }
            rate = rate.and_then(|rate| self.rate_of(&rate));
        }
        Held {
            unknown: unknown.to_vec(),
            ..Held::open(OTHER_INSTANTS)
        }
    }

    fn rate_of(&mut self, value: &Value) -> Option<Value> {
        let ground = self.reading.system.ground;
        self.reading.system.rate_of_value(value, ground).ok()
    }

    /// What a value is where the present is the first instant.
    fn at_first(&mut self, value: &Value) -> Option<Vec<Fraction>> {
        let kept = self.known.kept.iter().flat_map(Kept::at_first);
        let mut images: Images = kept.map(|(v, f)| (v, f.clone())).collect();
        // A root has the value of what stands below it.
        let atoms = &mut self.reading.system.atoms;
        for variable in value.entries.iter().flat_map(Fraction::variables) {
            if let Nature::Root(of) = atoms.atom(variable).nature.clone() {
                let root = atoms.root(&put_in(&of, &images)?)?;
                images.insert(variable, root);
            }
        }
        let entries = value.entries.iter();
        entries.map(|entry| put_in(entry, &images)).collect()
    }
}

/// Sides of which the one is zero.
fn vanishing(entries: Vec<Fraction>, unknown: &[String]) -> Sides {
    let sides = entries.into_iter().map(|entry| (entry, Fraction::zero()));
    Sides {
        sides: sides.collect(),
        unknown: unknown.to_vec(),
        settles: None,
    }
}
