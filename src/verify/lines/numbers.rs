//! Lines in numbers: proved to the digits shown, or refuted where a digit shown is wrong.
//!
//! An author rounds on the way and goes on with what was written down. So a line holds if it agrees with the exact
//! values, or with any of the rounded ones in their place; it is false only where no choice among them agrees.

use crate::algebra::{Interval, Proof};
use crate::notation::ast::{Kind, Node, Relation};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::lines::decimals::{Part, holds_decimals, holds_unit, is_numeral, units, with};
use crate::verify::lines::digits::{Comparison, Tolerance, compare};
use crate::verify::lines::line::Read;
use crate::verify::lines::multiples::over_common_symbols;
use crate::verify::theory::{Name, Theory};
use crate::verify::values::figures::Alternative;
use crate::verify::values::symbol::Meaning;
use crate::verify::values::units::scale;
use crate::verify::values::value::Value;
use crate::verify::verdict::{Finding, Verdict};
use num_traits::Zero;
use std::collections::BTreeSet;

/// Other values that are tried together with others.
const MOST_CHOICES: usize = 4;

/// What came out of a line in numbers.
pub(crate) enum Numerical {
    /// It holds; the premises used, and whether some digits were rounded.
    Holds(Proof, Vec<Name>, bool),
    /// It does not: the side that shows it, the place in it, the value that it should have, and whether that differs
    /// by plain rational numbers.
    Fails(usize, usize, Interval, bool),
    /// It is not decided.
    Open(&'static str),
    /// It is no line in numbers.
    NoNumbers,
}

impl Checker<'_> {
    /// Decides a chain of sides by their numbers; `after` sides of the line follow it.
    pub(crate) fn by_numbers(
        &mut self,
        sides: &[Node],
        after: usize,
        unlabelled: Frame,
    ) -> Numerical {
        let (mut proofs, mut uses, mut rounding): (Option<Proof>, Vec<Name>, bool) =
            (None, vec![], false);
        for pair in 0..sides.len().saturating_sub(1) {
            let from_end = after + sides.len() - 2 - pair;
            let (mut value, mut shown) = (pair, pair + 1);
            let mut tolerances = self.tolerances(&sides[shown], from_end, unlabelled);
            if tolerances.iter().all(Option::is_none) {
                let before = self.tolerances(&sides[value], from_end, unlabelled);
                if before.iter().any(Option::is_some) {
                    (value, shown, tolerances) = (shown, value, before);
                }
            }
            rounding |= tolerances.iter().any(Option::is_some);
            match self.pair([&sides[value], &sides[shown]], &tolerances, unlabelled) {
                Comparison::Agree(proof, names) => {
                    uses.extend(names);
                    proofs = Some(proofs.map_or(proof.clone(), |before| before.and(&proof)));
                }
                Comparison::Differ(place, value, plain) => {
                    return Numerical::Fails(shown, place, value, plain);
                }
                Comparison::Doubtful(reason) => return Numerical::Open(reason),
                Comparison::NoNumbers => return Numerical::NoNumbers,
            }
        }
        let mut seen = BTreeSet::new();
        uses.retain(|name| seen.insert(name.clone()));
        proofs.map_or(Numerical::NoNumbers, |proof| {
            Numerical::Holds(proof, uses, rounding)
        })
    }

    /// The sign of relation before the side that stands this many before the last.
    fn approximate(&self, from_end: usize) -> bool {
        let relations = &self.figures.relations;
        let at = relations.len().checked_sub(1 + from_end);
        at.and_then(|at| relations.get(at)) == Some(&Relation::Approximate)
    }

    /// How exactly each entry of a side is shown; `None` for the exact ones.
    fn tolerances(
        &mut self,
        side: &Node,
        from_end: usize,
        unlabelled: Frame,
    ) -> Vec<Option<Tolerance>> {
        let mut axes = |node: &Node| match &node.kind {
            Kind::Symbol(symbol) => matches!(self.meaning_of(symbol), Meaning::UnitVector(_)),
            _ => false,
        };
        if !is_numeral(side, &mut axes) {
            return vec![];
        }
        let approximate = self.approximate(from_end);
        let integers = match approximate {
            true => Part::Rounded,
            false => Part::Integers,
        };
        let parts = [Part::Decimals, integers, Part::Doubt];
        let values: Option<Vec<Value>> = parts
            .iter()
            .map(|part| self.lowering(unlabelled).value(&with(side, *part)).ok())
            .collect();
        let Some([decimals, integers, doubt]) = values.and_then(|v| <[Value; 3]>::try_from(v).ok())
        else {
            return vec![];
        };
        (0..decimals.entries.len())
            .map(|place| {
                let mut below = |value: &Value| self.theory.rational_below(&value.entries[place]);
                let (fine, whole, doubt) = (below(&decimals)?, below(&integers)?, below(&doubt)?);
                let integer = fine.is_zero() && !approximate;
                let half = fine + whole;
                (!half.is_zero()).then_some(Tolerance {
                    half,
                    doubt,
                    integer,
                })
            })
            .collect()
    }

    /// Two neighbouring sides, in every way that the author may have rounded.
    fn pair(
        &mut self,
        sides: [&Node; 2],
        tolerances: &[Option<Tolerance>],
        unlabelled: Frame,
    ) -> Comparison {
        let decimals = self.figures.decimals || sides.into_iter().any(holds_decimals);
        let (mut worst, mut doubt) = (None, None);
        for (left, right) in self.ways(sides, unlabelled) {
            for choice in self.choices(&left, &right) {
                let held =
                    |theory: &mut Theory| compare(theory, &left, &right, tolerances, decimals);
                let Some(found) = self.theory.with_values(&choice, held) else {
                    continue;
                };
                match found {
                    Comparison::Agree(..) => return found,
                    Comparison::NoNumbers if worst.is_none() && doubt.is_none() => return found,
                    Comparison::Doubtful(reason) => doubt = doubt.or(Some(reason)),
                    _ => worst = worst.or(Some(found)),
                }
            }
        }
        match doubt {
            Some(reason) => Comparison::Doubtful(reason),
            None => worst.unwrap_or(Comparison::NoNumbers),
        }
    }

    /// The values of two sides: as written; numerals as what they were rounded from; units passed over.
    fn ways(&mut self, two: [&Node; 2], unlabelled: Frame) -> Vec<(Value, Value)> {
        let mut texts = vec![];
        two.into_iter().for_each(|side| units(side, &mut texts));
        let scaled = texts.iter().any(|unit| !scale(unit).is_one());
        // A degree is never passed over: its sine would be that of as many radians.
        let angle = texts.iter().any(|unit| scale(unit).is_angle());
        let raw = scaled && !angle && !two.into_iter().all(holds_unit);
        let mut ways = vec![];
        for raw in [Some(false), raw.then_some(true)].into_iter().flatten() {
            for (first, second) in [(false, false), (true, false), (false, true), (true, true)] {
                let mut value = |side: &Node, unrounded: bool| {
                    (self.figures.raw, self.figures.unrounded) = (raw, unrounded);
                    self.lowering(unlabelled).value(side).ok()
                };
                if let (Some(left), Some(right)) = (value(two[0], first), value(two[1], second))
                    && !ways.iter().any(|(l, r): &(Value, Value)| {
                        l.entries == left.entries && r.entries == right.entries
                    })
                {
                    ways.push((left, right));
                }
            }
        }
        (self.figures.raw, self.figures.unrounded) = (false, false);
        ways
    }

    /// Every choice among the other values that two sides reach; none of them first.
    fn choices(&mut self, left: &Value, right: &Value) -> Vec<Vec<Alternative>> {
        let entries = left.entries.iter().chain(&right.entries);
        let reached = self.theory.reached_variables(entries);
        let all = self.figures.alternatives.iter().rev();
        let near: Vec<Alternative> = all
            .filter(|a| reached.contains(&a.variable))
            .take(MOST_CHOICES)
            .cloned()
            .collect();
        (0..1_usize << near.len())
            .map(|mask| {
                let chosen = |i: &usize| mask >> i & 1 == 1;
                (0..near.len())
                    .filter(chosen)
                    .map(|i| near[i].clone())
                    .collect()
            })
            .collect()
    }

    /// Says of a line what its numbers say; `false` where it is not a line in numbers.
    pub(crate) fn settled_by_numbers(
        &mut self,
        sides: &[Node],
        read: &Read,
        open: bool,
        finding: &mut Finding,
    ) -> bool {
        let mut compared = sides.to_vec();
        let mut found = self.by_numbers(sides, 0, read.unlabelled);
        if matches!(found, Numerical::NoNumbers)
            && let Some(ratios) = over_common_symbols(sides)
        {
            found = self.by_numbers(&ratios, 0, read.unlabelled);
            compared = ratios;
        }
        match found {
            Numerical::Holds(proof, uses, rounding) => {
                finding.uses = uses;
                finding.conditions = self.conditions(&proof);
                finding.verdict = Verdict::Proved(proof);
                if rounding {
                    finding.remarks.push("to the digits shown".to_owned());
                }
            }
            Numerical::Open(reason) => finding.reason = Some(reason.to_owned()),
            // Where plain numbers differ, the search for a slip knows more to say.
            Numerical::Fails(.., true) if !open => return false,
            Numerical::Fails(shown, place, value, _) => {
                self.wrong_digits(&compared[shown], place, &value, finding);
            }
            Numerical::NoNumbers => return false,
        }
        true
    }
}
