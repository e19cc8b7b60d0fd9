//! Data: values in numbers that a document hands over, and lines that need them.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Line, Node, Symbol};
use crate::notation::document::line_name;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, inner, symbols};
use crate::verify::lines::decimals::holds_decimals;
use crate::verify::lines::given::is_zero;
use crate::verify::lines::numbers::Numerical;
use crate::verify::reason::{RESTS_ON_GIVEN, TAKEN_AS_GIVEN};
use crate::verify::theory::{MOMENTARY, Name, Rule, Taken, Theory};
use crate::verify::values::atoms::{Atom, variable_fraction};
use crate::verify::values::figures::{Alternative, is_number};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::value::Value;
use crate::verify::verdict::{Finding, Role, Verdict};
use num_traits::Zero;
use std::collections::BTreeSet;

impl Checker<'_> {
    /// A free symbol, its value in numbers, and that value worked out: the first pair is data, the others are claims.
    pub(crate) fn works_out(&mut self, sides: &[Node], role: Role, finding: &mut Finding) -> bool {
        // Numbers on all sides can be checked, whatever the words make of them.
        let lone = sides.first().is_some_and(|side| self.is_free_symbol(side));
        let known = sides.len() > 1 && !lone && role != Role::Claim;
        if known && self.is_in_numbers(sides) {
            self.claim(sides, finding);
            return true;
        }
        // A zero behind others is no number that was worked out.
        let zero = sides.last().is_some_and(is_zero);
        if sides.len() < 3 || !lone || zero || !self.is_in_numbers(&sides[1..]) {
            return false;
        }
        self.accept(&sides[..2], role, finding);
        if finding.verdict != Verdict::Accepted {
            return true;
        }
        finding.verdict = Verdict::Undecided;
        let before = std::mem::take(&mut finding.remarks);
        self.claim(&sides[1..], finding);
        finding.remarks.splice(0..0, before);
        true
    }

    /// Reads letters as numbers that were given as numbers before; `false` where the line makes no sense so.
    pub(crate) fn given_scalars(&mut self, sides: &[Node]) -> bool {
        let bare = |s: &&Symbol| !s.style.vector && s.subscripts.is_empty();
        let letters = sides.iter().flat_map(symbols).filter(bare).map(Letter::of);
        let known = |letter: &Letter| self.figures.scalars.contains(letter);
        let scalars: BTreeSet<Letter> = letters.filter(known).collect();
        if scalars.is_empty() {
            return false;
        }
        self.reading.scalars = scalars;
        let fits = self.read(sides, Frame::Moving).is_ok();
        if !fits {
            self.reading.scalars.clear();
        }
        fits
    }

    /// Whether a side is a lone symbol of which nothing says the value.
    fn is_free_symbol(&mut self, side: &Node) -> bool {
        matches!(inner(side).kind, Kind::Symbol(_)) && self.is_free_value(side)
    }

    /// Whether a side stands for variables of which nothing says the value.
    pub(crate) fn is_free_value(&mut self, side: &Node) -> bool {
        let Ok(value) = self.lowering(Frame::Moving).value(side) else {
            return false;
        };
        let mut free = |entry: &Fraction| {
            let variable = entry.as_variable();
            variable.is_some_and(|v| {
                matches!(self.theory.atoms.atom(v), Atom::Part { .. })
                    && self.theory.normal(entry) == variable_fraction(v)
            })
        };
        value.entries.iter().all(&mut free)
    }

    /// Whether a side is the angular velocity, and nothing gives all of its components yet.
    pub(crate) fn is_rate_with_a_free_part(&mut self, side: &Node) -> bool {
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let whole = self.theory.atoms.vector(omega, 0);
        let value = self.lowering(Frame::Moving).value(side);
        let own = value.is_ok_and(|value| value.entries == whole);
        own && whole.iter().any(|part| self.theory.normal(part) == *part)
    }

    /// Whether all sides come down to numbers.
    pub(crate) fn is_in_numbers(&mut self, sides: &[Node]) -> bool {
        sides.iter().all(|side| {
            let value = self.lowering(Frame::Moving).value(side);
            value.is_ok_and(|value| {
                value.entries.iter().all(|entry| {
                    let normal = self.theory.normal(entry);
                    is_number(&self.theory.atoms, &normal)
                })
            })
        })
    }

    /// Whether a line sets numbers with a decimal point against something of which the numbers are not known.
    pub(crate) fn lacks_numbers(&mut self, sides: &[Node]) -> bool {
        let figures = |side: &Node| symbols(side).is_empty() && holds_decimals(side);
        sides.iter().any(figures) && !self.is_in_numbers(sides)
    }

    /// Sides without symbols that are worked out wrongly refute a line, whatever its other sides mean.
    pub(crate) fn wrong_arithmetic(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let plain = |side: &Node| symbols(side).into_iter().all(|s| s.name == "pi");
        for (i, pair) in sides.windows(2).enumerate() {
            if !pair.iter().all(plain) {
                continue;
            }
            let after = sides.len() - 2 - i;
            if let Numerical::Fails(shown, place, value, _) =
                self.by_numbers(pair, after, Frame::Moving)
            {
                self.wrong_digits(&pair[shown], place, &value, finding);
                return true;
            }
        }
        false
    }

    /// Leaves a value in numbers open that rests on a line which was taken as given without a check.
    pub(crate) fn withhold_value(&self, line: &Line, finding: &mut Finding) {
        let vanishes = line
            .sides
            .last()
            .is_some_and(|side| matches!(&side.kind, Kind::Number(n) if n.value.is_zero()));
        let numbers = !vanishes
            && line.sides.len() > 1
            && symbols(&line.sides[line.sides.len() - 1]).is_empty();
        if !numbers || !matches!(finding.verdict, Verdict::Proved(_)) {
            return;
        }
        let unchecked = |f: &&Finding| {
            f.verdict == Verdict::Undecided && f.reason.as_deref() == Some(TAKEN_AS_GIVEN)
        };
        let named = |f: &Finding| line_name(f.cell, f.source_line);
        let mut names = self.findings.iter().filter(unchecked).map(named);
        if names.any(|name| finding.uses.contains(&name)) {
            finding.verdict = Verdict::Undecided;
            finding.reason = Some(RESTS_ON_GIVEN.to_owned());
        }
    }
}

impl Theory {
    /// Works with other values in the place of what gives some variables; `None` where these contradict the rest.
    pub(crate) fn with_values<R>(
        &mut self,
        values: &[Alternative],
        work: impl FnOnce(&mut Self) -> R,
    ) -> Option<R> {
        if values.is_empty() {
            return Some(work(self));
        }
        let mut left_out = self.left_out.clone();
        for value in values {
            if let Atom::Part {
                entity, component, ..
            } = *self.atoms.atom(value.variable)
            {
                let parts = [component, component | MOMENTARY];
                let rules = parts.map(|c| self.solution.rules.get(&(entity, c)));
                left_out.extend(
                    rules
                        .into_iter()
                        .flatten()
                        .map(|(_, rule)| rule.name.clone()),
                );
            }
        }
        let fixed = std::mem::replace(&mut self.fixed, values.to_vec());
        let result = self.without(left_out, |theory| {
            (theory.rebuild() != Taken::Contradiction).then(|| work(theory))
        });
        self.fixed = fixed;
        result
    }

    /// Leaves out what gives these symbols values in numbers, as a derivative in them is one of the formula and not of
    /// its value; what was left out before is returned.
    pub(crate) fn leave_out_point(&mut self, by: &Value) -> BTreeSet<Name> {
        let before = self.left_out.clone();
        for variable in by.entries.iter().filter_map(Fraction::as_variable) {
            let Some(rule) = self.rule(variable) else {
                continue;
            };
            let document = self.premises().iter().any(|p| p.name == rule.name);
            let value = self.normal(&rule.value);
            if document && is_number(&self.atoms, &value) {
                self.left_out.insert(rule.name);
            }
        }
        before
    }

    /// Puts the other values in force.
    pub(crate) fn put_fixed(&mut self) {
        for fixed in self.fixed.clone() {
            if self.left_out.contains(&fixed.name) {
                continue;
            }
            let residual = variable_fraction(fixed.variable) - fixed.value.clone();
            let rule = Rule {
                name: fixed.name,
                value: fixed.value.into(),
            };
            self.insert(fixed.variable, &residual, rule);
        }
    }

    /// Every variable that some fractions lead to.
    pub(crate) fn reached_variables<'a>(
        &mut self,
        fractions: impl Iterator<Item = &'a Fraction>,
    ) -> BTreeSet<Variable> {
        let mut open: Vec<Variable> = fractions.flat_map(Fraction::variables).collect();
        let mut seen = BTreeSet::new();
        while let Some(variable) = open.pop() {
            if seen.insert(variable)
                && let Some(rule) = self.rule(variable)
            {
                open.extend(rule.value.variables());
            }
        }
        seen
    }
}
