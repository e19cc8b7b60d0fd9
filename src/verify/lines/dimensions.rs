//! Dimensions: a sum of terms that are measured in different units is wrong, whatever the numbers are.
//!
//! Only symbols that the document itself gives in units have a dimension here.

use crate::notation::ast::{Function, Kind, Node, Number};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::usage::{inner, symbols};
use crate::verify::reason;
use crate::verify::values::atoms::Entity;
use crate::verify::values::symbol::Meaning;
use crate::verify::values::units::{Dimension, dimension};
use crate::verify::verdict::{Diagnosis, Finding, Role, Verdict};
use std::collections::BTreeMap;

/// Dimensions of symbols, and of components of them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Dimensions {
    known: BTreeMap<(Entity, u8), Dimension>,
}

/// Terms that cannot be added.
struct Mismatch(Span);

/// What a node is measured in, where that is known.
type Measured = Result<Option<Dimension>, Mismatch>;

/// Counts by which a formula is multiplied or divided; another number may stand for a value.
const COUNTS: [i64; 9] = [1, 2, 3, 4, 5, 6, 8, 10, 12];

impl Checker<'_> {
    /// Refutes a line in which things of different dimensions are added, and notes what its left side is measured in.
    pub(crate) fn measure(&mut self, sides: &[Node], finding: &mut Finding) {
        let settled = matches!(finding.verdict, Verdict::Proved(_) | Verdict::Accepted)
            || finding.reason.as_deref() == Some(reason::MIXED);
        if !settled || sides.len() < 2 {
            return;
        }
        let measured: Vec<Measured> = sides.iter().map(|side| self.dimension_of(side)).collect();
        if let Some(Mismatch(span)) = measured.iter().find_map(|side| side.as_ref().err()) {
            let claimed = finding.role != Role::Assume;
            if claimed && sides.iter().any(|side| !symbols(side).is_empty()) {
                wrong_dimension(*span, finding);
            }
            return;
        }
        if are_in_two_units(sides, &measured) {
            return wrong_dimension(sides[1].span, finding);
        }
        let proved = matches!(finding.verdict, Verdict::Proved(_));
        if proved && self.has_another_unit(sides, &measured) {
            finding.verdict = Verdict::Undecided;
            finding.uses.clear();
            finding.conditions.clear();
            finding.remarks.clear();
            finding.reason = Some("its sides are measured in different units".to_owned());
            return;
        }
        let Kind::Symbol(symbol) = &inner(&sides[0]).kind else {
            return;
        };
        let place = match self.meaning_of(symbol) {
            Meaning::Whole(entity) => (entity, 0),
            Meaning::Component(entity, component) => (entity, component),
            _ => return,
        };
        let found = measured.into_iter().rev().flatten().flatten().next();
        self.dimensions.known.extend(found.map(|d| (place, d)));
    }

    /// Whether a number with a unit stands for what is measured in another: an inertia in kg m.
    fn has_another_unit(&mut self, sides: &[Node], measured: &[Measured]) -> bool {
        let (mut in_units, mut others) = (vec![], vec![]);
        for (side, measured) in sides.iter().zip(measured) {
            let known = measured.as_ref().ok().copied().flatten();
            match &inner(side).kind {
                Kind::WithUnit(..) => in_units.extend(known),
                // Numbers alone are put in without their units.
                _ if symbols(side).is_empty() => {}
                _ => others.extend(known.or_else(|| self.dimension_by_theory(side))),
            }
        }
        let differ = |one: &Dimension| others.iter().any(|other| other != one);
        in_units.iter().any(differ)
    }

    /// What a lone quantity of the theory, or a rate of one, is measured in.
    fn dimension_by_theory(&mut self, side: &Node) -> Option<Dimension> {
        let (symbol, order) = match &inner(side).kind {
            Kind::Symbol(symbol) => (symbol, 0),
            Kind::TimeDerivative { operand, order, .. } => match &inner(operand).kind {
                Kind::Symbol(symbol) => (symbol, i32::from(*order)),
                _ => return None,
            },
            _ => return None,
        };
        let entity = match self.meaning_of(symbol) {
            Meaning::Whole(entity) | Meaning::Component(entity, _) => entity,
            _ => return None,
        };
        let powers = self.powers_of_quantity(entity)?;
        let mut doubled = [0; 3];
        for (own, power) in doubled.iter_mut().zip(powers) {
            let power = power.clone() + power;
            *own = i32::try_from(power.to_integer()?).ok()?;
        }
        doubled[2] -= 2 * order;
        Some(doubled)
    }

    fn dimension_of(&mut self, node: &Node) -> Measured {
        match &inner(node).kind {
            Kind::Symbol(symbol) => Ok(match self.meaning_of(symbol) {
                Meaning::Whole(entity) => self.dimensions.known.get(&(entity, 0)).copied(),
                Meaning::Component(entity, component) => {
                    self.dimensions.known.get(&(entity, component)).copied()
                }
                Meaning::Pi | Meaning::ImaginaryUnit => Some([0; 3]),
                _ => None,
            }),
            Kind::Number(number) => Ok(is_count(number).then_some([0; 3])),
            Kind::WithUnit(inside, unit) => {
                let number = symbols(inside).is_empty();
                Ok(dimension(unit).filter(|_| number))
            }
            Kind::Negate(inside) | Kind::Norm(inside) => self.dimension_of(inside),
            Kind::Sum(terms) => {
                let mut first: Option<Dimension> = None;
                for term in terms {
                    // A number alone has the unit that is left out.
                    let bare = symbols(&term.node).is_empty();
                    let found = self.dimension_of(&term.node)?.filter(|_| !bare);
                    match (first, found) {
                        (Some(one), Some(other)) if one != other => {
                            return Err(Mismatch(term.node.span));
                        }
                        _ => first = first.or(found),
                    }
                }
                Ok(first)
            }
            Kind::Product(factors) => {
                let mut total = Some([0; 3]);
                for factor in factors {
                    let one = self.dimension_of(&factor.node)?;
                    total = combined(total, one, 1);
                }
                Ok(total)
            }
            Kind::Quotient(above, below) => {
                let above = self.dimension_of(above)?;
                let below = self.dimension_of(below)?;
                Ok(combined(above, below, -1))
            }
            Kind::Power(base, exponent) => {
                let base = self.dimension_of(base)?;
                let power = match &inner(exponent).kind {
                    Kind::Number(number) => i32::try_from(number.value.to_integer()).ok(),
                    _ => None,
                };
                let whole =
                    matches!(&inner(exponent).kind, Kind::Number(n) if n.value.is_integer());
                let power = power.filter(|p| whole && p.abs() < 10);
                Ok(base.zip(power).map(|(base, power)| base.map(|d| d * power)))
            }
            Kind::Function(Function::Sqrt, inside) => {
                let inside = self.dimension_of(inside)?;
                let even = inside.filter(|all| all.iter().all(|d| d % 2 == 0));
                Ok(even.map(|all| all.map(|d| d / 2)))
            }
            _ => Ok(None),
        }
    }
}

/// Whether two sides that are numbers with units are measured in different ones.
fn are_in_two_units(sides: &[Node], measured: &[Measured]) -> bool {
    let known = sides.iter().zip(measured).filter_map(|(side, measured)| {
        let number = matches!(inner(side).kind, Kind::WithUnit(..)) && symbols(side).is_empty();
        measured.as_ref().ok().copied().flatten().filter(|_| number)
    });
    let known: Vec<Dimension> = known.collect();
    known.windows(2).any(|pair| pair[0] != pair[1])
}

fn combined(one: Option<Dimension>, other: Option<Dimension>, sign: i32) -> Option<Dimension> {
    let (one, other) = one.zip(other)?;
    Some([0, 1, 2].map(|i| one[i] + sign * other[i]))
}

fn is_count(number: &Number) -> bool {
    let whole = number.decimals.is_none() && number.value.is_integer();
    let value = i64::try_from(number.value.to_integer());
    whole && value.is_ok_and(|value| COUNTS.contains(&value))
}

fn wrong_dimension(span: Span, finding: &mut Finding) {
    finding.verdict = Verdict::Refuted;
    finding.place = span;
    finding.uses.clear();
    finding.conditions.clear();
    finding.remarks.clear();
    finding.reason =
        Some("this term is measured in another unit than the one before it".to_owned());
    finding.diagnosis = Some(Diagnosis {
        kind: "dimension",
        message: "terms of different dimensions are added: a factor is missing".to_owned(),
        suggestion: None,
        place: Some(span),
    });
}
