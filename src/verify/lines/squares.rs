//! Lines between magnitudes: `\sqrt{L_x^2 + L_y^2} = I\omega`. The squares of the sides are equal, and so are
//! their signs.

use crate::algebra::{Fraction, Proof, Rational};
use crate::notation::ast::Function;
use crate::verify::check::Checker;
use crate::verify::lines::line::Read;
use crate::verify::names;
use crate::verify::theory::decide::{Decision, Equation, decide, passes_filter};
use crate::verify::theory::world::{Kind, Substance, World};
use crate::verify::values::atoms::{Atom, variable_fraction};
use crate::verify::values::value::Value;
use crate::verify::verdict::Finding;
use num_traits::ToPrimitive;

/// Worlds in which both sides have one sign, before it is believed.
const WORLDS: usize = 6;
/// Worlds that are tried for them.
const TRIES: u64 = 48;

/// Worlds of decimals in which sizes, rates and angles are positive; only signs are read off them.
impl Substance for f64 {
    fn lift(value: &Rational) -> Option<Self> {
        value.to_big().to_f64()
    }
    fn root(&self) -> Option<Self> {
        (*self >= 0.0).then(|| self.sqrt())
    }
    fn draw(kind: Kind, chance: u64) -> Self {
        let part = (chance >> 11) as f64 / (1u64 << 53) as f64;
        match kind {
            Kind::Positive => 4.0 + 4.0 * part,
            Kind::Small | Kind::Over(_) => part - 0.5,
            Kind::Signed if chance & 1 == 0 => -0.1 - part,
            // The tangent of a quarter of an acute angle is below this too.
            Kind::Any | Kind::Signed => 0.02 + 0.16 * part,
        }
    }
    fn is_negative(&self) -> bool {
        *self < 0.0
    }
}

/// The equations of the squares, their proof, and what must not be negative.
type BySquares = (Read, Proof, Vec<Fraction>);

/// The equation of the squares of two sides.
fn squared(left: &Fraction, right: &Fraction) -> Equation {
    let square = |side: &Fraction| side.clone() * side.clone();
    Equation::of_scalars(square(left), square(right))
}

impl Checker<'_> {
    /// Proves a line with roots in it by the squares of its sides, under the condition that their signs are those that
    /// they have where lengths and rates are positive; leaves it open where these do not tell. False where the squares
    /// differ, or the signs are opposite.
    pub(crate) fn settled_by_squares(
        &mut self,
        read: &Read,
        open: bool,
        finding: &mut Finding,
    ) -> bool {
        let Some(settled) = self.by_squares(read) else {
            return false;
        };
        let Some((read, proof, positive)) = settled else {
            if !open {
                finding.reason = Some("it holds up to a sign that is not known here".to_owned());
            }
            return !open;
        };
        self.proved(&read, proof, finding);
        for side in positive {
            let shown = names::fraction(&self.theory.atoms, &side);
            finding.conditions.push(format!("{shown} \\ge 0"));
        }
        finding
            .remarks
            .push("the squares of the sides are equal".to_owned());
        true
    }

    /// The squares of a line with roots in it, their proof and what must not be negative; nothing inside where the signs
    /// of the sides do not tell, `None` where the squares differ.
    fn by_squares(&mut self, read: &Read) -> Option<Option<BySquares>> {
        // No world here is on the points of relations that are kept.
        if !self.theory.solution.relations.kept.is_empty() {
            return None;
        }
        let (mut equations, mut positive) = (vec![], vec![]);
        let (mut known, mut rooted) = (true, false);
        for equation in &read.equations {
            let sides = (
                equation.left.entries.as_slice(),
                equation.right.entries.as_slice(),
            );
            let ([left], [right]) = sides else {
                return None;
            };
            if !self.has_root(left) && !self.has_root(right) {
                if passes_filter(&mut self.theory, &equation.residual) != Some(true) {
                    return None;
                }
                equations.push(equation.clone());
                continue;
            }
            rooted = true;
            let (mut left, mut right) = (left.clone(), right.clone());
            let mut squares = squared(&left, &right);
            if passes_filter(&mut self.theory, &squares.residual) == Some(false) {
                let (root, rest) = self.root_alone(&equation.residual)?;
                (left, right) = (root, rest);
                squares = squared(&left, &right);
                if passes_filter(&mut self.theory, &squares.residual) == Some(false) {
                    return None;
                }
            }
            let (left, right) = (&left, &right);
            match self.have_one_sign(left, right) {
                Some(true) => {}
                Some(false) => return None,
                None => known = false,
            }
            positive.extend(match (self.is_root(left), self.is_root(right)) {
                (true, true) => None,
                (true, false) => Some(right.clone()),
                (false, true) => Some(left.clone()),
                (false, false) => Some(left.clone() * right.clone()),
            });
            equations.push(squares);
        }
        if !rooted {
            return None;
        }
        let read = Read {
            equations,
            unlabelled: read.unlabelled,
            ambiguous: read.ambiguous,
            to_order: read.to_order,
        };
        Some(match decide(&mut self.theory, &read.equations) {
            Decision::True(proof) if known => Some((read, proof, positive)),
            _ => None,
        })
    }

    /// Whether a line with roots in it is proved by the squares of its sides.
    pub(crate) fn squares_hold(&mut self, read: &Read) -> bool {
        matches!(self.by_squares(read), Some(Some(_)))
    }

    /// The only root in a difference that vanishes, and what it then is, which is not negative.
    fn root_alone(&mut self, residual: &Value) -> Option<(Fraction, Fraction)> {
        let difference = self.theory.normal(residual.as_scalar()?);
        let sum = difference.numerator();
        let variables = sum.variables().into_iter();
        let mut roots = variables.filter(|&v| self.is_root(&variable_fraction(v)));
        let (root, None) = (roots.next()?, roots.next()) else {
            return None;
        };
        let [rest, factor] = [0, 1].map(|k| Fraction::from(sum.coefficient_of(root, k)));
        let value = -rest / factor;
        let root_of_it = sum.degree_in(root) == 1 && self.is_no_less_than_zero(&value);
        root_of_it.then(|| (variable_fraction(root), value))
    }

    fn is_root(&self, side: &Fraction) -> bool {
        let atom = side.as_variable().map(|v| self.theory.atoms.atom(v));
        matches!(atom, Some(Atom::Kernel { function, .. }) if *function == Function::Sqrt)
    }

    /// Whether a root that is not a number stands in a side, or in what it is made of.
    fn has_root(&mut self, side: &Fraction) -> bool {
        let reached = self.theory.reached_variables([side].into_iter());
        reached.into_iter().any(|variable| {
            let atom = self.theory.atoms.atom(variable);
            matches!(atom, Atom::Kernel { function: Function::Sqrt, argument } if argument.to_rational().is_none())
        })
    }

    /// Whether two sides have the same sign, or opposite ones, wherever sizes, rates and angles are positive.
    fn have_one_sign(&mut self, left: &Fraction, right: &Fraction) -> Option<bool> {
        let mut same = vec![];
        for seed in 1..=TRIES {
            let mut world: World<f64> = World::new(&mut self.theory, seed);
            let values = world.fraction(left).zip(world.fraction(right));
            if std::mem::take(&mut self.theory.exhausted) {
                return None;
            }
            let product = values.map(|(left, right)| left * right);
            same.extend(product.filter(|p| p.abs() > 0.0).map(|p| p > 0.0));
            if same.len() == WORLDS {
                break;
            }
        }
        let first = *same.first()?;
        (same.len() == WORLDS && same.iter().all(|one| *one == first)).then_some(first)
    }
}
