//! What equations of motion other than the true one say of small oscillations, and what their paces say of each other.

use crate::algebra::{Fraction, Variable};
use crate::verify::model::atoms::fraction;
use crate::verify::model::swings::{Pace, Swing};
use crate::verify::standing::apart::Apart;
use crate::verify::term::quantity::BY_RULE;
use num_traits::Zero;

impl Apart<'_> {
    /// What equations say of the frequencies and periods in these goals, by the rule that tells them.
    pub(crate) fn by_rule(&mut self, goals: &[Fraction], equations: &[Fraction]) -> Vec<Fraction> {
        let swings = self.judge.reading.sizes.swings.clone();
        let own: Vec<(Variable, Swing)> = swings
            .into_iter()
            .flat_map(|swing| {
                let letters = self.letters_of(&swing);
                letters.into_iter().map(move |v| (v, swing.clone()))
            })
            .collect();
        let is_asked = |(v, _): &(Variable, Swing)| {
            goals.iter().any(|goal| goal.numerator().degree_in(*v) > 0)
        };
        let mut told = vec![];
        for (letter, swing) in own.iter().filter(|own| is_asked(own)) {
            for equation in equations {
                let by_motion = self.by_motion(equation, swing.of);
                let mut others = own
                    .iter()
                    .filter(|(other, of)| other != letter && of.of == swing.of);
                let by_other =
                    || others.find_map(|(other, of)| self.by_pace(equation, *other, of.pace));
                if let Some(frequency) = by_motion.or_else(by_other) {
                    let system = &mut self.judge.reading.system;
                    told.push(fraction(*letter) - system.pace(swing.pace, frequency));
                }
            }
        }
        told
    }

    /// The letters that stand for the pace of a swing.
    fn letters_of(&self, swing: &Swing) -> Vec<Variable> {
        let atoms = &self.judge.reading.system.atoms;
        let all = 0..atoms.len() as Variable;
        let told = |v: &Variable| {
            let law = atoms.atom(*v).law.as_ref();
            law.is_some_and(|law| law.name == BY_RULE && law.value == swing.told)
        };
        all.filter(told).collect()
    }

    /// The angular frequency of x by an equation of motion.
    fn by_motion(&mut self, equation: &Fraction, x: Variable) -> Option<Fraction> {
        let system = &mut self.judge.reading.system;
        let acceleration = system.acceleration_by(equation, x)?;
        let stiffness = system.stiffness(&acceleration, x)?;
        system.atoms.root(&stiffness)
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
