//! Where the roots of an equation above are real: "that is, ⟨C²n² ≥ 4Amgh⟩", and the least value for which they are.

use crate::algebra::{Fraction, Monomial, Rational, Variable};
use crate::notation::ast::{Function, Kind, Line, Node, Relation, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::names;
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::values::atoms::{Atom, variable_fraction};
use crate::verify::values::lower::put_in;
use crate::verify::values::lower::{Lowering, constant, substituted};
use crate::verify::values::value::Value;
use crate::verify::verdict::{Diagnosis, Finding, Verdict};
use crate::verify::words::book::{has_any, lowered};
use num_traits::{One, Zero};
use std::collections::{BTreeSet, HashMap};

/// Words of an angle that goes to zero.
const UPRIGHT: &[&str] = &["small", "vertical", "upright", "sleep"];
/// Words of a motion that the roots of an equation are.
const POSSIBLE: &[&str] = &[
    "possible only",
    "only possible",
    "is possible if",
    "is possible when",
    "exist only",
    "exists only",
    "exists if",
    "exist if",
];
const NOT_REAL: &[&str] = &[
    "no real",
    "not real",
    "complex",
    "imaginary",
    "no longer",
    "cease",
];

impl Checker<'_> {
    /// Decides an inequality that words call the condition for real roots, by the discriminant of an equation above.
    pub(crate) fn has_real_roots(&mut self, line: &Line, finding: &mut Finding) -> bool {
        let words = lowered(&self.sentence);
        let [(relation, _)] = line.relations.as_slice() else {
            return false;
        };
        let below = matches!(relation, Relation::Less | Relation::LessOrEqual);
        let said = words.contains("real") && words.contains("root") || has_any(&words, POSSIBLE);
        if !said || has_any(&words, NOT_REAL) {
            return false;
        }
        let Ok(read) = self.read(&line.sides, Frame::Moving) else {
            return false;
        };
        let [difference] = read.residuals().collect::<Vec<_>>()[..] else {
            return false;
        };
        let sign = constant(Rational::from(if below { -1 } else { 1 }));
        let difference = difference.clone() * sign;
        let small = has_any(&words, UPRIGHT);
        let Some(discriminant) = self.discriminant_like(&difference, small) else {
            return false;
        };
        let ratio = (difference / discriminant.clone()).to_rational();
        if ratio.is_some_and(|ratio| !ratio.is_negative()) {
            finding.verdict = Verdict::Accepted;
            finding.reason = None;
            finding
                .remarks
                .push("the discriminant of the equation above".to_owned());
        } else {
            finding.verdict = Verdict::Refuted;
            finding.reason = Some("this is not where the roots are real".to_owned());
        }
        self.border = Some(discriminant);
        true
    }

    /// The discriminant of the last equation for which it has the terms of a difference, with other numbers maybe.
    fn discriminant_like(&mut self, difference: &Fraction, small: bool) -> Option<Fraction> {
        let terms = monomials(difference);
        let equations: Vec<Fraction> = self
            .balances
            .iter()
            .chain(&self.equations)
            .cloned()
            .collect();
        for equation in equations.iter().rev() {
            for unknown in equation.numerator().variables() {
                if equation.numerator().degree_in(unknown) != 2 {
                    continue;
                }
                let [c, b, a] = [0, 1, 2]
                    .map(|n| Fraction::from(equation.numerator().coefficient_of(unknown, n)));
                let four = constant(Rational::from(4));
                let whole = b.clone() * b - four * a * c;
                let upright = small.then(|| self.upright(&whole));
                for candidate in upright.into_iter().chain([whole]) {
                    if monomials(&candidate) == terms {
                        return Some(candidate);
                    }
                }
            }
        }
        None
    }

    /// A value where every angle is zero.
    fn upright(&self, value: &Fraction) -> Fraction {
        substituted(value, &|v| match self.theory.atoms.atom(v) {
            Atom::Kernel {
                function: Function::Sin,
                ..
            } => Fraction::zero(),
            Atom::Kernel {
                function: Function::Cos,
                ..
            } => Fraction::one(),
            _ => variable_fraction(v),
        })
    }

    /// Decides the least value of a symbol by the discriminant, which vanishes there: `n_{\min} = \frac{2}{C}\sqrt{Amgh}`.
    pub(crate) fn is_on_border(
        &mut self,
        left: &Node,
        right: &Node,
        finding: &mut Finding,
    ) -> bool {
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return false;
        };
        let bare = Symbol {
            subscripts: vec![],
            ..symbol.clone()
        };
        let (Some(border), Some(entity)) = (self.border.clone(), self.entity_named(&bare)) else {
            return false;
        };
        let variable: Variable = self.theory.atoms.part(entity, 0, 0);
        if !border.variables().contains(&variable) {
            return false;
        }
        // What the document supposes of the motion may be the very equation.
        let names = self.theory.premises().iter().map(|p| p.name.clone());
        let names: BTreeSet<String> = names.collect();
        let decided = |lowering: &mut Lowering<'_>| {
            let value = lowering.scalar(right)?;
            let square = |n: i64| {
                let value = value.clone() * constant(Rational::from(n));
                put_in(&border, &HashMap::from([(variable, value)]))
            };
            let (at, nowhere) = (square(1), square(0));
            let equation = Equation::vanishing(Value::scalar(at.clone()));
            let decision = decide(lowering.theory, &[equation]);
            let [at, nowhere] = [at, nowhere].map(|v| lowering.theory.normal(&v));
            let lost = (nowhere.clone() / (nowhere - at)).to_rational();
            Some((decision, lost.and_then(|square| square.exact_sqrt())))
        };
        let Some((decision, lost)) = self.lowering_without(names, decided) else {
            return false;
        };
        match decision {
            Decision::True(_) => {
                finding.verdict = Verdict::Accepted;
                let how = "the discriminant of the equation above is zero there";
                finding.remarks.push(how.to_owned());
            }
            Decision::False(witness) => {
                finding.verdict = Verdict::Refuted;
                let how = "the discriminant of the equation above is not zero there";
                finding.reason = Some(how.to_owned());
                finding.counterexample = Some(*witness);
                finding.diagnosis = lost.map(|factor| self.lost_in_front(factor, left, right));
            }
            _ => return false,
        }
        true
    }

    /// A number that the right side has to be multiplied by.
    pub(crate) fn lost_in_front(&self, factor: Rational, left: &Node, right: &Node) -> Diagnosis {
        let factor = names::fraction(&self.theory.atoms, &constant(factor));
        let [left, text] = [left, right].map(|side| self.document.source.slice(side.span).trim());
        Diagnosis {
            kind: "factor",
            message: format!("a factor {factor} is missing"),
            suggestion: Some(format!("{left} = {factor} {text}")),
            place: Some(right.span),
        }
    }
}

/// The terms of a polynomial without their numbers.
fn monomials(value: &Fraction) -> BTreeSet<Monomial> {
    let terms = value.numerator().terms().iter();
    terms.map(|(monomial, _)| monomial.clone()).collect()
}
