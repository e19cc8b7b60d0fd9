//! The sign of a difference: `(I_1 - I_2)(I_2 - I_3) > 0` where the document orders the moments.
//!
//! A moment that is greater than another is that one and something positive. With this put in, a polynomial of which all
//! terms have one sign has that sign. What is proved with a certificate is that the difference is the sum of those terms.

use crate::algebra::{Fraction, Polynomial, Rational, Variable};
use crate::notation::ast::{Line, Node, Relation};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::lines::line::Read;
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::values::atoms::{Atom, Owner, variable_fraction};
use crate::verify::values::lower::constant;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::value::Value;
use crate::verify::verdict::{Finding, Verdict};
use std::cmp::Ordering;

/// Orders that a document may keep.
const MOST_ORDERS: usize = 16;
/// Terms of a difference whose sign is looked for.
const MOST_TERMS: usize = 200;

/// One quantity that is greater than another.
#[derive(Clone, Debug)]
pub(crate) struct Order {
    greater: Variable,
    smaller: Variable,
    /// What is positive: the difference, by a variable of its own.
    difference: Variable,
    level: u8,
}

impl Checker<'_> {
    /// Keeps what an accepted line says of which quantity is greater, to the end of its section.
    pub(crate) fn note_orders(&mut self, line: &Line) {
        for (pair, (relation, _)) in line.sides.windows(2).zip(&line.relations) {
            let (greater, smaller) = match relation {
                Relation::Greater => (&pair[0], &pair[1]),
                Relation::Less => (&pair[1], &pair[0]),
                _ => continue,
            };
            let (Some(greater), Some(smaller)) = (self.lone(greater), self.lone(smaller)) else {
                continue;
            };
            let latex = format!("\\text{{({greater} over {smaller})}}");
            let difference = self.theory.atoms.special(Atom::Opaque { latex });
            self.orders
                .retain(|o| (o.greater, o.smaller) != (smaller, greater));
            if self.orders.len() < MOST_ORDERS {
                let level = self.level;
                self.orders.push(Order {
                    greater,
                    smaller,
                    difference,
                    level,
                });
            }
        }
    }

    /// Forgets the orders of sections that a heading ends.
    pub(crate) fn end_orders(&mut self, level: u8) {
        self.orders.retain(|order| order.level < level);
    }

    fn lone(&mut self, side: &Node) -> Option<Variable> {
        let value = self.lowering(Frame::Moving).scalar(side)?;
        self.theory.normal(&value).as_variable()
    }

    /// Decides a line of <, ≤, >, ≥ by the signs of its differences, where those are known.
    pub(crate) fn decide_signs(&mut self, line: &Line, finding: &mut Finding) {
        let Ok(read) = self.read(&line.sides, Frame::Moving) else {
            return;
        };
        if read.residuals().count() != line.relations.len() {
            return;
        }
        let entries: Vec<Fraction> = read.residuals().cloned().collect();
        let mut equations = vec![];
        for (entry, (relation, _)) in entries.iter().zip(&line.relations) {
            let Some((sign, form)) = self.sign(entry) else {
                return;
            };
            let holds = match relation {
                Relation::Less | Relation::LessOrEqual => sign == Ordering::Less,
                _ => sign == Ordering::Greater,
            };
            if !holds {
                finding.verdict = Verdict::Refuted;
                finding.reason = Some("the difference has the other sign".to_owned());
                return;
            }
            let scalar = |entry: Fraction| Value::scalar(entry);
            equations.push(Equation {
                left: scalar(entry.clone()),
                right: scalar(form.clone()),
                residual: scalar(entry.clone() - form),
            });
        }
        let read = Read {
            equations,
            unlabelled: Frame::Moving,
            ambiguous: false,
            to_order: false,
        };
        if let Decision::True(proof) = decide(&mut self.theory, &read.equations) {
            finding.reason = None;
            self.proved(&read, proof, finding);
            let ordered = "each term of the difference has this sign";
            finding.remarks.push(ordered.to_owned());
        }
    }

    /// The strict sign of a difference, and the sum of terms of that sign that it is.
    fn sign(&mut self, entry: &Fraction) -> Option<(Ordering, Fraction)> {
        let normal = self.theory.normal(entry);
        [entry.clone(), normal]
            .iter()
            .find_map(|whole| self.sign_as_written(whole))
    }

    fn sign_as_written(&self, whole: &Fraction) -> Option<(Ordering, Fraction)> {
        let (above, below) = (whole.numerator(), whole.denominator());
        let (above, below) = (self.parted(above)?, self.parted(below)?);
        let sign = match self.of_terms(&above)? == self.of_terms(&below)? {
            true => Ordering::Greater,
            false => Ordering::Less,
        };
        let back = |v: Variable| match self.orders.iter().find(|o| o.difference == v) {
            Some(order) => variable_fraction(order.greater) - variable_fraction(order.smaller),
            None => variable_fraction(v),
        };
        let lift = |c: &Rational| constant(c.clone());
        let form = above.evaluate(back, lift) / below.evaluate(back, lift);
        Some((sign, form))
    }

    /// A polynomial with the greater of two quantities as the smaller and their difference.
    fn parted(&self, polynomial: &Polynomial) -> Option<Polynomial> {
        let mut parted = polynomial.clone();
        for _ in 0..self.orders.len() {
            for order in &self.orders {
                if parted.len() > MOST_TERMS {
                    return None;
                }
                let sum =
                    Polynomial::variable(order.smaller) + Polynomial::variable(order.difference);
                parted = parted.substitute(order.greater, &sum);
            }
        }
        Some(parted)
    }

    /// The sign that all terms have.
    fn of_terms(&self, polynomial: &Polynomial) -> Option<Ordering> {
        let mut signs = polynomial.terms().iter().map(|(monomial, coefficient)| {
            let positive = monomial.factors().all(|(v, _)| self.is_positive(v));
            positive.then(|| !coefficient.is_negative())
        });
        let first = signs.next()??;
        let all = signs.all(|sign| sign == Some(first));
        all.then_some(match first {
            true => Ordering::Greater,
            false => Ordering::Less,
        })
    }

    /// Whether a variable is a moment of inertia, a mass, or a difference that is positive.
    fn is_positive(&self, variable: Variable) -> bool {
        if self.orders.iter().any(|o| o.difference == variable) {
            return true;
        }
        let atoms = &self.theory.atoms;
        let Atom::Part {
            component,
            order: 0,
            ..
        } = atoms.atom(variable)
        else {
            return false;
        };
        match atoms.owner(variable) {
            Some(Owner::Quantity(Quantity::Inertia, _)) => *component < 3,
            Some(Owner::Quantity(Quantity::Mass, _)) => true,
            _ => false,
        }
    }
}
