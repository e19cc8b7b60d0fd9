//! The sign of a difference: `(I_1 - I_2)(I_2 - I_3) > 0` where the document orders the moments.
//!
//! A moment that is greater than another is that one and something positive. With this put in, a polynomial of which all
//! terms have one sign has that sign. What is proved with a certificate is that the difference is the sum of those terms.
//! Of any body two moments are together no less than the third: I_x = b + c, I_y = c + a, I_z = a + b with a = ∫x² dm ≥ 0.

use crate::algebra::{Fraction, Polynomial, Rational, Variable};
use crate::notation::ast::{Line, Node, Relation};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::lines::given::is_zero;
use crate::verify::lines::line::Read;
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::values::atoms::{Atom, Owner, variable_fraction};
use crate::verify::values::lower::{constant, put_in};
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Finding, Verdict};
use std::collections::HashMap;

/// Orders that a document may keep.
const MOST_ORDERS: usize = 16;
/// Terms of a difference whose sign is looked for.
const MOST_TERMS: usize = 200;

/// A sign that all terms have, and whether one of them is not zero for sure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Sign {
    negative: bool,
    strict: bool,
}

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
            if let (true, Some(variable)) = (is_zero(smaller), self.lone(greater)) {
                self.positive.insert(variable);
            }
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

    /// Keeps that words call a symbol positive: "the positive constant ⟨c⟩".
    pub(crate) fn call_positive(&mut self, node: &Node) {
        let variable = self.lone(node);
        self.positive.extend(variable);
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
        if !self.orders_hold() {
            return;
        }
        let entries: Vec<Fraction> = read.residuals().cloned().collect();
        let mut equations = vec![];
        for (entry, (relation, _)) in entries.iter().zip(&line.relations) {
            let Some((sign, form)) = self.sign(entry) else {
                return;
            };
            let (below, or_equal) = match relation {
                Relation::Less => (true, false),
                Relation::LessOrEqual => (true, true),
                Relation::GreaterOrEqual => (false, true),
                _ => (false, false),
            };
            // Where terms can vanish, they need not.
            if sign.negative != below {
                finding.verdict = Verdict::Refuted;
                finding.reason = Some("the difference has the other sign".to_owned());
                return;
            }
            if !sign.strict && !or_equal {
                return;
            }
            equations.push(Equation::of_scalars(entry.clone(), form));
        }
        let read = Read::of(equations);
        if let Decision::True(proof) = decide(&mut self.theory, &read.equations) {
            finding.reason = None;
            self.proved(&read, proof, finding);
            let ordered = "each term of the difference has this sign where it is not zero";
            finding.remarks.push(ordered.to_owned());
        }
    }

    /// Whether what lines say of orders agrees with what they say otherwise: of an exact motion about the middle axis, I₁ = I₃.
    fn orders_hold(&mut self) -> bool {
        self.orders.clone().into_iter().all(|order| {
            let difference = variable_fraction(order.greater) - variable_fraction(order.smaller);
            let difference = self.theory.normal(&difference);
            let sign = self.sign_of(&difference, None);
            sign.is_none_or(|(sign, _)| !sign.negative)
        })
    }

    /// Whether a value is known to be zero or more.
    pub(crate) fn is_no_less_than_zero(&mut self, value: &Fraction) -> bool {
        let sign = self.sign(value);
        sign.is_some_and(|(sign, _)| !sign.negative)
    }

    /// The sign of a difference, and the sum of terms of that sign that it is.
    fn sign(&mut self, entry: &Fraction) -> Option<(Sign, Fraction)> {
        let normal = self.theory.normal(entry);
        let squares = self.squares_of_position();
        let forms = [entry.clone(), self.as_lines_say(entry), normal];
        let written = forms.iter().find_map(|whole| self.sign_of(whole, None));
        written.or_else(|| {
            forms
                .iter()
                .find_map(|whole| self.sign_of(whole, Some(&squares)))
        })
    }

    /// A value with what lines say that its symbols are, as these are written: squares stay squares.
    fn as_lines_say(&self, entry: &Fraction) -> Fraction {
        let mut images = HashMap::new();
        for variable in entry.variables() {
            let mut premises = self.theory.premises().iter();
            let image = premises.find_map(|premise| match premise.residuals.as_slice() {
                [residual] if premise.preferred.contains(&variable) => {
                    let above = residual.numerator();
                    let [rest, factor] =
                        [0, 1].map(|k| Fraction::from(above.coefficient_of(variable, k)));
                    (above.degree_in(variable) == 1).then(|| -rest / factor)
                }
                _ => None,
            });
            images.extend(image.map(|image| (variable, image)));
        }
        put_in(entry, &images)
    }

    /// The moments of inertia, each with a variable for what the other two exceed it by: twice ∫x² dm.
    fn squares_of_position(&mut self) -> [(Variable, Variable); 3] {
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        ["x", "y", "z"].map(|axis| {
            let latex = format!("\\text{{2∫}}{axis}^2\\text{{dm}}");
            let moment = match axis {
                "x" => 0,
                "y" => 1,
                _ => 2,
            };
            let moment = self.theory.atoms.part(inertia, moment, 0);
            (moment, self.theory.atoms.special(Atom::Opaque { latex }))
        })
    }

    fn sign_of(
        &self,
        whole: &Fraction,
        squares: Option<&[(Variable, Variable); 3]>,
    ) -> Option<(Sign, Fraction)> {
        let parted = |polynomial| match squares {
            Some(squares) => by_squares(polynomial, squares),
            None => self.parted(polynomial),
        };
        let (above, below) = (parted(whole.numerator())?, parted(whole.denominator())?);
        let below_sign = self.of_terms(&below, &[]).filter(|sign| sign.strict)?;
        let squares = squares.map_or(&[][..], |squares| squares);
        let mut sign = self.of_terms(&above, squares)?;
        sign.negative ^= below_sign.negative;
        let back = |v: Variable| {
            if let Some(at) = squares.iter().position(|(_, square)| *square == v) {
                let of = |i: usize| variable_fraction(squares[i % 3].0);
                return of(at + 1) + of(at + 2) - of(at);
            }
            match self.orders.iter().find(|o| o.difference == v) {
                Some(order) => variable_fraction(order.greater) - variable_fraction(order.smaller),
                None => variable_fraction(v),
            }
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

    /// The sign that all terms have; even powers, and the squares of a position, are never below zero.
    fn of_terms(&self, polynomial: &Polynomial, squares: &[(Variable, Variable)]) -> Option<Sign> {
        let mut whole: Option<Sign> = None;
        // Where the square of a rate is a factor of all, that rate is not zero: nothing else would turn.
        let common = polynomial.common_monomial();
        for (monomial, coefficient) in polynomial.terms() {
            let mut factors = monomial.factors();
            let whole_square = |v, p| p % 2 == 0 && (self.rests(v) || common.exponent(v) == p);
            let strict = factors.all(|(v, p)| self.is_positive(v) || whole_square(v, p));
            let square = |v| squares.iter().any(|(_, square)| *square == v);
            let mut factors = monomial.factors();
            let known = factors.all(|(v, p)| p % 2 == 0 || self.is_positive(v) || square(v));
            let negative = coefficient.is_negative();
            let before = whole.filter(|before| before.negative != negative);
            if !known || before.is_some() {
                return None;
            }
            let strict = strict || whole.is_some_and(|before| before.strict);
            whole = Some(Sign { negative, strict });
        }
        whole
    }

    /// Whether a variable is a number of the document's own that does not change: nobody names a zero.
    fn rests(&self, variable: Variable) -> bool {
        let atoms = &self.theory.atoms;
        let entity = atoms.entity_of(variable).map(|e| atoms.info(e));
        entity.is_some_and(|info| info.constant && matches!(info.owner, Owner::Symbol(_)))
    }

    /// Whether a variable is a moment of inertia, a mass, or a difference that is positive.
    fn is_positive(&self, variable: Variable) -> bool {
        let ordered = self.orders.iter().any(|o| o.difference == variable);
        if ordered || self.positive.contains(&variable) {
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

/// A polynomial with each moment as half of what it exceeds the difference of the other two by.
fn by_squares(polynomial: &Polynomial, squares: &[(Variable, Variable); 3]) -> Option<Polynomial> {
    if polynomial.len() > MOST_TERMS {
        return None;
    }
    let half = Polynomial::constant(Rational::from((1, 2)));
    let mut parted = polynomial.clone();
    for (at, (moment, _)) in squares.iter().enumerate() {
        let of = |i: usize| Polynomial::variable(squares[i % 3].1);
        let sum = (of(at + 1) + of(at + 2)) * half.clone();
        parted = parted.substitute(*moment, &sum);
    }
    Some(parted)
}
