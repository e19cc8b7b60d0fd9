//! The semi-axes of an ellipsoid on which a vector ends: `2T = Ap² + Bq² + Cr²` has √(2T/A), √(2T/B), √(2T/C).

use crate::algebra::{Fraction, Polynomial};
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{axis, inner};
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::values::atoms::Atom;
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Finding, Role, Verdict};
use num_traits::Zero;

/// What the squares of the components of a vector are multiplied by in the equation of a surface, and the rest of it.
#[derive(Clone, Debug)]
pub(crate) struct Quadric {
    squares: [Fraction; 3],
    rest: Fraction,
}

impl Checker<'_> {
    /// Notes the surface that a line is the equation of.
    pub(crate) fn note_quadric(&mut self, sides: &[Node], finding: &Finding) {
        let holds = matches!(finding.verdict, Verdict::Accepted | Verdict::Proved(_));
        if !holds || sides.len() != 2 || !self.text.says(&["semi-ax", "semiax"]) {
            return;
        }
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return;
        };
        if let [residual] = read.residuals().collect::<Vec<_>>()[..]
            && let Some(quadric) = self.quadric_of(residual.numerator())
        {
            self.quadric = Some(quadric);
        }
    }

    fn quadric_of(&mut self, equation: &Polynomial) -> Option<Quadric> {
        let vectors = [Quantity::AngularVelocity, Quantity::Momentum];
        vectors.into_iter().find_map(|quantity| {
            let entity = self.theory.atoms.quantity(quantity);
            let parts = [0, 1, 2].map(|c| self.theory.atoms.part(entity, c, 0));
            let squares = parts.map(|part| equation.coefficient_of(part, 2));
            let squared = parts.iter().zip(&squares).map(|(&part, factor)| {
                factor.clone() * Polynomial::variable(part) * Polynomial::variable(part)
            });
            let rest = squared.fold(equation.clone(), |rest, square| rest - square);
            let of_vector = |v: &u32| matches!(self.theory.atoms.atom(*v), Atom::Part { entity: of, .. } if *of == entity);
            let free = |p: &Polynomial| !p.is_zero() && !p.variables().iter().any(of_vector);
            (free(&rest) && squares.iter().all(free)).then(|| Quadric {
                squares: squares.map(Fraction::from),
                rest: rest.into(),
            })
        })
    }

    /// Takes a line in as the name of a semi-axis of the surface above, where it is one.
    pub(crate) fn is_semi_axis(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let ([left, right], Some(quadric)) = (sides, self.quadric.clone()) else {
            return false;
        };
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return false;
        };
        let index = symbol.subscripts.iter().find_map(|s| axis(s));
        let row = self
            .beside
            .iter()
            .position(|(first, _)| first.span == left.span);
        let Some(value) = self.lowering(Frame::Moving).scalar(right) else {
            return false;
        };
        let which = index.map(usize::from).or(row);
        let squares = quadric.squares.iter().enumerate();
        let fits = squares
            .filter(|(at, _)| which.is_none_or(|which| which == *at))
            .any(|(_, factor)| {
                let whole = value.clone() * value.clone() * factor.clone() + quadric.rest.clone();
                let equation = Equation::of_scalars(whole, Fraction::zero());
                matches!(decide(&mut self.theory, &[equation]), Decision::True(_))
            });
        if fits {
            finding.verdict = Verdict::Accepted;
            finding.role = Role::Define;
            finding.reason = None;
            let how = "the surface above ends there on its axis";
            finding.remarks.push(how.to_owned());
            self.now_known(sides);
        }
        fits
    }
}
