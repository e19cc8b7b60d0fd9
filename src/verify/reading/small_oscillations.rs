//! Small oscillations about where a letter is zero: what the equations of motion come to there tells their frequency.

use crate::algebra::{Fraction, Place, Polynomial, Variable, compose};
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::model::atoms::{Motion, Nature, fraction, whole};
use crate::verify::reading::builder::{Builder, MOST_TERMS};
use crate::verify::reading::oscillations_read::{ANGULAR_FREQUENCY, FREQUENCY, PERIOD};
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;
use num_traits::{One, Zero};
use std::collections::HashMap;

/// The noun of what swings to and fro.
const OSCILLATION: &str = "oscillation";

/// The letter whose small oscillations a phrase speaks of.
pub(super) fn small_oscillation(what: &NounPhrase) -> Option<&Formula> {
    let [(Slot::Of, Term::Phrase(of))] = what.slots.as_slice() else {
        return None;
    };
    let small = of.head == OSCILLATION && of.is("small") && what.adjectives.is_empty();
    match of.slots.as_slice() {
        [(Slot::Of, Term::Formula(letter))] if small => Some(letter),
        _ => None,
    }
}

impl Builder<'_> {
    /// The equations of motion that lists of working loads tell, and what they come to for small oscillations.
    pub(super) fn hold_equations_of_motion(&mut self) {
        self.hold_working_loads();
        self.hold_small_oscillations();
    }

    /// "`$T$` is the period of the small oscillations of `$x$`": ẍ = −(2π/T)² x to first order, by the equations of motion.
    fn hold_small_oscillations(&mut self) {
        for declaration in self.declarations {
            if let Statement::Is { subjects, what } = &declaration.statement
                && [PERIOD, FREQUENCY, ANGULAR_FREQUENCY].contains(&what.head)
                && let Some(of) = small_oscillation(what)
            {
                let held = self.hold_small_oscillation(subjects, what.head, of, declaration);
                held.unwrap_or_else(|| self.say_unused(declaration));
            }
            if let Statement::Is { subjects, what } = &declaration.statement
                && let Some(turning) = self.frame_of_period(what)
            {
                let held = self.hold_period_of_turn(subjects, turning, declaration);
                held.unwrap_or_else(|| self.say_unused(declaration));
            }
        }
    }

    fn hold_small_oscillation(
        &mut self,
        subjects: &[Term],
        head: &str,
        of: &Formula,
        declaration: &Declaration,
    ) -> Option<()> {
        let [Term::Formula(letter)] = subjects else {
            return None;
        };
        let x = self.scalar(of, declaration)?.as_variable()?;
        let stiffness = self.stiffness_about_zero(x)?;
        let atoms = &mut self.system().atoms;
        let (root, turn) = (atoms.root(&stiffness)?, atoms.pi() * whole(2));
        let told = match head {
            PERIOD => turn / root,
            FREQUENCY => root / turn,
            _ => root,
        };
        let known = Quantity::ByRule(Value::scalar(told));
        self.denote(letter, Meaning::Quantity(known), declaration);
        Some(())
    }

    /// −∂ẍ/∂x where x and its rate are zero and stay so, if nothing but constants stands there.
    fn stiffness_about_zero(&mut self, x: Variable) -> Option<Fraction> {
        let mut facts = self.facts_so_far();
        let atoms = &mut self.reading.system.atoms;
        let rate = atoms.rate(x).as_variable()?;
        let acceleration = atoms.rate(rate);
        let told = facts.normal(atoms, &acceleration).ok()?;
        let told = self.system().expanded(&told, &[x, rate]);
        let slope = self.system().partial(&told, x);
        let damping = self.system().partial(&told, rate);
        let [rest, slope, damping] =
            [told, slope, damping].map(|value| self.at_zero(&value, x, rate));
        let constant = |f: &Fraction| {
            let atoms = &self.reading.system.atoms;
            let mut variables = f.variables().into_iter();
            variables.all(|v| {
                let atom = atoms.atom(v);
                atom.place == Place::Parameter || matches!(atom.motion, Motion::Constant)
            })
        };
        let slope = slope.filter(|slope| constant(slope) && !slope.is_zero())?;
        (rest?.is_zero() && damping?.is_zero()).then(|| -slope)
    }

    /// A value where a variable and its rate are zero.
    fn at_zero(&mut self, value: &Fraction, x: Variable, rate: Variable) -> Option<Fraction> {
        let mut images: HashMap<Variable, Fraction> = HashMap::new();
        images.insert(x, Fraction::zero());
        images.insert(rate, Fraction::zero());
        for kernel in value.variables() {
            match &self.reading.system.atoms.atom(kernel).nature {
                Nature::Sine(of) if *of == fraction(x) => images.insert(kernel, Fraction::zero()),
                Nature::Cosine(of) if *of == fraction(x) => images.insert(kernel, Fraction::one()),
                _ => None,
            };
        }
        let put = |p: &Polynomial| compose(p, &images, MOST_TERMS).ok();
        let below = put(value.denominator())?;
        (!below.is_zero()).then_some(put(value.numerator())? / below)
    }
}
