//! What equations of motion other than the true one say of small oscillations, and what their paces say of each other.

use crate::algebra::{Fraction, Polynomial, Variable, compose};
use crate::verify::model::swings::{Pace, Swing};
use crate::verify::standing::apart::Apart;
use crate::verify::term::quantity::BY_RULE;
use num_traits::Zero;
use std::collections::HashMap;

/// Goals of more terms are left as they are.
const MOST_TERMS: usize = 1_000;

impl Apart<'_> {
    /// Whether this speaks of a period or a frequency that a rule tells.
    pub(crate) fn is_by_rule(&self, of: &Fraction) -> bool {
        let paces = self.paces();
        paces
            .iter()
            .any(|(letter, _)| of.numerator().degree_in(*letter) > 0)
    }

    /// The period or the frequency that an equation speaks of, where it speaks of one.
    pub(crate) fn pace_in(&self, equation: &Fraction) -> Option<Variable> {
        let paces = self.paces().into_iter().map(|(letter, _)| letter);
        let mut paces = paces.filter(|letter| equation.numerator().degree_in(*letter) > 0);
        paces.next().filter(|_| paces.next().is_none())
    }

    /// Goals with the periods and frequencies put in that equations tell by the rule, and the equations that do not tell
    /// them. An equation of motion says nothing else of what never changes.
    pub(crate) fn by_rule(
        &mut self,
        goals: Vec<Fraction>,
        equations: Vec<Fraction>,
    ) -> (Vec<Fraction>, Vec<Fraction>) {
        let paces = self.paces();
        let asked = |letter: Variable| {
            let mut goals = goals.iter();
            goals.any(|goal| goal.numerator().degree_in(letter) > 0)
        };
        let (mut told, mut used) = (HashMap::new(), vec![]);
        for (letter, swing) in paces.iter().filter(|(letter, _)| asked(*letter)) {
            for (at, equation) in equations.iter().enumerate() {
                let others = paces.iter().filter(|(other, _)| other != letter);
                if let Some(frequency) = self.frequency(equation, swing, others) {
                    let system = &mut self.judge.reading.system;
                    told.insert(*letter, system.pace(swing.pace, frequency));
                    used.push(at);
                    break;
                }
            }
        }
        if told.is_empty() {
            return (goals, equations);
        }
        let put = |of: &Polynomial| compose(of, &told, MOST_TERMS).ok();
        let put = |of: &Fraction| Some(put(of.numerator())? / put(of.denominator())?);
        let goals = goals.iter().map(|goal| put(goal).unwrap_or(goal.clone()));
        let equations = equations.into_iter().enumerate();
        let others = equations.filter(|(at, _)| !used.contains(at));
        (goals.collect(), others.map(|(_, own)| own).collect())
    }

    /// The angular frequency of a swing by an equation of motion, or by one that tells another of its paces.
    fn frequency<'s>(
        &mut self,
        equation: &Fraction,
        swing: &Swing,
        others: impl Iterator<Item = &'s (Variable, Swing)>,
    ) -> Option<Fraction> {
        let system = &mut self.judge.reading.system;
        if let Some(acceleration) = system.acceleration_by(equation, swing.of) {
            let stiffness = system.stiffness(&acceleration, swing.of)?;
            return system.atoms.root(&stiffness);
        }
        let mut others = others.filter(|(_, other)| other.of == swing.of);
        others.find_map(|(letter, other)| self.by_pace(equation, *letter, other.pace))
    }

    /// The letters that the rule tells.
    fn paces(&self) -> Vec<(Variable, Swing)> {
        let reading = &self.judge.reading;
        let swings = &reading.sizes.swings;
        if swings.is_empty() {
            return vec![];
        }
        let atoms = &reading.system.atoms;
        let letters = (0..atoms.len() as Variable).filter_map(|letter| {
            let law = atoms.atom(letter).law.as_ref()?;
            let mut swings = swings.iter();
            let swing = swings.find(|swing| law.name == BY_RULE && law.value == swing.told)?;
            Some((letter, swing.clone()))
        });
        letters.collect()
    }

    /// The angular frequency by an equation that says what a pace or its square is.
    fn by_pace(&mut self, equation: &Fraction, letter: Variable, pace: Pace) -> Option<Fraction> {
        let equation = equation.numerator();
        let power = equation.degree_in(letter);
        let slope = Fraction::from(equation.coefficient_of(letter, power));
        let rest = Fraction::from(equation.coefficient_of(letter, 0));
        let system = &mut self.judge.reading.system;
        let own = match power {
            1 => -rest / slope,
            2 if equation.coefficient_of(letter, 1).is_zero() => {
                system.atoms.root(&(-rest / slope))?
            }
            _ => return None,
        };
        (!own.is_zero()).then(|| system.angular_frequency(pace, own))
    }
}
