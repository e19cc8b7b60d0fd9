//! Steady motions: all angles turn evenly, and those that the energy depends on do not turn at all.

use crate::algebra::{Fraction, Monomial, Polynomial, Variable};
use crate::mechanics;
use crate::verify::derivation::nouns::{Key, declared, formula};
use crate::verify::derivation::plan::Subject;
use crate::verify::derivation::story::{Claim, Story};
use crate::verify::derivation::{Law, Subject as About};
use crate::verify::facts::Source;
use crate::verify::language::statement::{Extent, Statement};
use crate::verify::model::atoms::{Nature, fraction, whole};
use crate::verify::model::system::Turn;
use num_traits::Zero;

/// The heading under which a steady motion stands.
pub(super) const STEADY: &str = "Steady motion";

impl Story {
    /// Of the largest whole whose loads are known: the conditions under which its angles keep their rates.
    pub(super) fn tell_steady(&mut self) {
        let mut known = self.plan.bodies.iter().filter(|s| s.loads.is_some());
        let found = known.next_back().cloned().and_then(|s| self.steady_of(&s));
        let (held, even) = found.unwrap_or_default();
        self.close(About::Steady { held, even });
    }

    /// Tells the conditions, and returns the angles that are held and those that change evenly.
    fn steady_of(&mut self, subject: &Subject) -> Option<(Vec<String>, Vec<String>)> {
        let lagrangian = self.lagrangian(subject)?;
        let of = lagrangian.variables();
        let depends = |angle: Variable| {
            let atoms = &self.letters.reading.system.atoms;
            let in_kernel = |v: Variable| {
                let own = atoms.angle_of(v);
                own.is_some_and(|a| a.variables().contains(&angle))
            };
            of.iter().any(|&v| v == angle || in_kernel(v))
        };
        let (held, even): (Vec<Variable>, Vec<Variable>) =
            self.angles().into_iter().partition(|&angle| depends(angle));
        if held.is_empty() || even.is_empty() {
            return None;
        }
        let before = self.letters.facts.clone();
        held.iter().for_each(|&angle| self.suppose(angle, 1));
        even.iter().for_each(|&angle| self.suppose(angle, 2));
        let conditions = held.iter();
        let conditions: Vec<Claim> = conditions
            .filter_map(|&angle| self.condition(&lagrangian, angle, &held))
            .collect();
        self.step(Law::Steady, conditions);
        self.letters.facts = before;
        let named = |angles: &[Variable]| -> Vec<String> {
            let text = |&a: &Variable| self.letters.printed(&fraction(a)).map(|text| text.latex);
            angles.iter().filter_map(text).collect()
        };
        Some((named(&held), named(&even)))
    }

    /// T − V with the rates of the angles put in.
    fn lagrangian(&mut self, subject: &Subject) -> Option<Fraction> {
        let parts = self.letters.reading.system.wholes(subject.body);
        let mut sum = Fraction::zero();
        for part in parts {
            let part = self.subject(part)?;
            if !part.pivoted {
                return None;
            }
            let system = self.letters.system();
            let (frame, ground) = (system.bodies[part.body].frame?, system.ground);
            let omega = system.angular_velocity(frame, ground);
            let tensor = self.tensor(&part, part.about, true)?;
            sum += mechanics::kinetic_energy(&tensor, &omega);
        }
        if let Some((_, potential)) = self.nouns.of(Key::Potential(subject.body)).cloned() {
            let value = self.letters.system().value_of(&potential).ok()?;
            sum -= value.to_scalar().ok()?;
        }
        Some(self.letters.reading.system.atoms.with_squares(&sum))
    }

    /// The angles by which the frames turn.
    fn angles(&self) -> Vec<Variable> {
        let frames = self.letters.reading.system.frames.iter();
        let angles = frames.filter_map(|frame| match &frame.turn {
            Turn::Angle(_, angle) | Turn::About(_, angle) => angle.as_variable(),
            _ => None,
        });
        let mut angles: Vec<Variable> = angles.collect();
        angles.dedup();
        angles
    }

    /// Supposes that a rate of an angle vanishes, under the heading of steady motions.
    fn suppose(&mut self, angle: Variable, order: usize) {
        let mut rate = fraction(angle);
        let Some(text) = self
            .letters
            .printed(&rate)
            .and_then(|text| text.dotted(order))
        else {
            return;
        };
        for _ in 0..order {
            rate = self.letters.system().atoms.derivative(&rate);
        }
        let statement = Statement::Holds(formula(&format!("{} = 0", text.latex)));
        let extent = Extent::Section(STEADY.to_owned());
        let sentence = declared(statement.clone(), extent.clone());
        let source = Source::Declared(sentence.text.clone());
        self.letters.declare(statement, extent);
        let letters = &mut self.letters;
        let put = letters
            .facts
            .extend(&mut letters.reading.system.atoms, &rate, &source);
        let _ = put.is_ok();
    }

    /// ∂L/∂θ where the angles that are held do not turn: Lagrange's equation of a steady motion.
    fn condition(&mut self, of: &Fraction, angle: Variable, held: &[Variable]) -> Option<Claim> {
        let atoms = &self.letters.reading.system.atoms;
        let mut slope = of.partial(angle);
        for variable in of.variables() {
            let of_angle = |a: &Fraction| a.as_variable() == Some(angle);
            let image = match &atoms.atom(variable).nature {
                Nature::Cosine(a) if of_angle(a) => self.kernels(angle)?.1 * whole(-1),
                Nature::Sine(a) if of_angle(a) => self.kernels(angle)?.0,
                _ => continue,
            };
            slope += of.partial(variable) * image;
        }
        let mut left = slope.numerator().clone();
        for &angle in held {
            let rate = self.letters.system().atoms.rate(angle).as_variable()?;
            left = left.coefficient_of(rate, 0);
        }
        let left = self.without_factors(&left);
        let text = self.letters.printed(&left)?;
        Some((text, left, Fraction::zero()))
    }

    /// The cosine and the sine of an angle.
    fn kernels(&self, angle: Variable) -> Option<(Fraction, Fraction)> {
        let mut system = self.letters.reading.system.clone();
        let angle = fraction(angle);
        system.atoms.cosine_sine(&angle)
    }

    /// A sum that vanishes without the factors that do not, as far as the facts still prove it.
    fn without_factors(&mut self, sum: &Polynomial) -> Fraction {
        let mut left = sum.clone();
        for (variable, _) in sum.common_monomial().powers() {
            let shorter = left.divided_by(&Monomial::of(variable));
            if self.letters.vanishes(&Fraction::from(shorter.clone())) {
                left = shorter;
            }
        }
        Fraction::from(left)
    }
}
