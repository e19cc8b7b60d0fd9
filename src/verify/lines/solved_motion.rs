//! Lines that solve an equation of motion, with new symbols for what the motion begins with: `\omega_1 = a\cos(\lambda t + \varphi)`,
//! `\eta = \eta_0 e^{i\lambda t}`.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::lines::given::is_zero;
use crate::verify::lines::growth::lasts;
use crate::verify::lines::line::Read;
use crate::verify::reason;
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::values::atoms::{Atom, variable_fraction};
use crate::verify::verdict::{Finding, Role, Verdict};
use num_traits::Zero;

impl Checker<'_> {
    /// Takes in a line that says how something moves in time, with new constants, if it solves what the laws say of the
    /// motion: the difference of the sides then obeys a linear homogeneous equation, so that it stays nothing where the
    /// constants make it nothing at the beginning.
    pub(crate) fn solves_motion(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, right] = sides else { return false };
        let named = match &inner(left).kind {
            // `\eta(t)` is η.
            Kind::Call(head, arguments) if arguments.len() == 1 => head,
            _ => left,
        };
        // With values at the beginning the constants are no longer any.
        if !self.reading.beginnings.is_empty()
            || !matches!(inner(named).kind, Kind::Symbol(_))
            || !self.speaks_of_time(std::slice::from_ref(right))
            || self.unmentioned(std::slice::from_ref(right)).is_empty() && !has_beginning(right)
            || self.new_symbol(named).is_some()
        {
            return false;
        }
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return false;
        };
        let residuals: Vec<Fraction> = read.residuals().cloned().collect();
        let [residual] = residuals.as_slice() else {
            return false;
        };
        let rest = self.theory.normal(residual);
        let first = self.rate_by_laws(&rest);
        let second = first.as_ref().and_then(|first| self.rate_by_laws(first));
        let (Some(first), Some(second)) = (first, second) else {
            return false;
        };
        let complex = self.lowering(Frame::Moving).complex_parts(&rest).is_some();
        // What obeys an equation of first order obeys one of second order, which more would solve.
        let solved = self.factor_between(&first, &rest).is_some()
            || !complex
                && !self.moves_by_itself(left)
                && self.factor_between(&second, &rest).is_some();
        if !solved && (has_beginning(right) || self.has_new_frequency(&rest, right)) {
            return false;
        }
        if !solved {
            finding.reason = Some(reason::NO_SOLUTION.to_owned());
            self.refuse_solution(left, right, finding);
            return true;
        }
        match complex {
            // One equation for two real ones: which constants are real is not said.
            true => {
                finding.verdict = Verdict::Accepted;
                self.now_known(sides);
            }
            false => self.accept(sides, Role::Given, finding),
        }
        finding.role = Role::Given;
        if finding.verdict == Verdict::Accepted {
            let solves = "it solves the equation of motion, for any values of the new symbols";
            finding.remarks.push(solves.to_owned());
        }
        true
    }

    /// Whether what stands under a sine or an exponential grows with a new symbol, of which the line says what it is.
    fn has_new_frequency(&mut self, rest: &Fraction, right: &Node) -> bool {
        let new = self.unmentioned(std::slice::from_ref(right));
        let inside: Vec<Variable> = rest.variables();
        inside.into_iter().any(|v| {
            let Atom::Kernel { argument, .. } = self.theory.atoms.atom(v).clone() else {
                return false;
            };
            let growth = self.theory.atoms.derivative(&argument);
            let mut met = growth.variables().into_iter();
            met.any(|v| {
                self.theory
                    .atoms
                    .entity_of(v)
                    .is_some_and(|e| new.contains(&e))
            })
        })
    }

    /// Whether the rate of a side is made of the side and of what does not change.
    fn moves_by_itself(&mut self, left: &Node) -> bool {
        let Some(own) = self.lowering(Frame::Moving).scalar(left) else {
            return false;
        };
        let own = self.theory.normal(&own);
        let Some(rate) = self.rate_by_laws(&own) else {
            return false;
        };
        let within = own.variables();
        let others = rate.variables().into_iter().filter(|v| !within.contains(v));
        others
            .collect::<Vec<_>>()
            .into_iter()
            .all(|v| lasts(&mut self.theory, &variable_fraction(v)))
    }

    /// The rate of an expression, where the laws determine it.
    fn rate_by_laws(&mut self, value: &Fraction) -> Option<Fraction> {
        let rate = self.theory.atoms.derivative(value);
        let rate = self.theory.normal(&rate);
        let free = |v: Variable| matches!(self.theory.atoms.atom(v), Atom::Part { order, .. } if *order > 0);
        (!rate.variables().into_iter().any(free)).then_some(rate)
    }

    /// Refutes a line whose right side has a rate, or a second one, that is a multiple of itself, where that of the left
    /// side is not.
    fn refuse_solution(&mut self, left: &Node, right: &Node, finding: &mut Finding) {
        let sides = [left, right].map(|side| self.lowering(Frame::Moving).scalar(side));
        let [Some(own), Some(given)] = sides else {
            return;
        };
        let (mut rate, mut slope) = (own.clone(), given.clone());
        for _ in 0..2 {
            rate = self.theory.atoms.derivative(&rate);
            slope = self.theory.atoms.derivative(&slope);
            let Some(factor) = self.factor_between(&slope, &given) else {
                continue;
            };
            let equations = vec![Equation::of_scalars(rate.clone(), factor * own.clone())];
            if let decision @ Decision::False(_) = decide(&mut self.theory, &equations) {
                self.failed(
                    std::slice::from_ref(left),
                    &Read::of(equations),
                    decision,
                    finding,
                );
                if finding.verdict == Verdict::Refuted {
                    finding.reason = Some(reason::NO_SOLUTION.to_owned());
                    finding.residual = None;
                    let shown = "the values are those of the rate of the left side, and of what it would be";
                    finding.remarks.push(shown.to_owned());
                }
                return;
            }
        }
    }

    /// What an expression is times another one, if that does not change.
    fn factor_between(&mut self, value: &Fraction, of: &Fraction) -> Option<Fraction> {
        let moves = |v: &Variable| matches!(self.theory.atoms.atom(*v), Atom::Part { .. });
        let mut linear = of.variables().into_iter().filter(moves).filter_map(|v| {
            let own = of.numerator().coefficient_of(v, 1);
            (!own.is_zero()).then_some((v, own))
        });
        let (variable, own) = linear.next()?;
        let theirs = value.numerator().coefficient_of(variable, 1);
        let [own, theirs, below, above] = [
            own,
            theirs,
            value.denominator().clone(),
            of.denominator().clone(),
        ]
        .map(Fraction::from);
        let factor = theirs * above / (own * below);
        // A factor that moves may have poles, beyond which a start at nothing says nothing.
        let rest = value.clone() - factor.clone() * of.clone();
        let whole = self.theory.normal(&rest).is_zero();
        (whole && lasts(&mut self.theory, &factor)).then_some(factor)
    }
}

/// Whether the value of something at the time zero stands in a node: `\eta(0)`.
fn has_beginning(node: &Node) -> bool {
    let zero = |arguments: &[Node]| matches!(arguments, [one] if is_zero(one));
    matches!(&node.kind, Kind::Call(_, arguments) if zero(arguments))
        || node.children().any(has_beginning)
}
