//! First integrals: what does not change by the equations of motion is what it was at the start.
//!
//! Candidates are energies and components of momenta. One whose rate vanishes by what holds is equal to the value that
//! the lines about the start give it. Nothing else of these lines is carried to other times.

use crate::algebra::{Fraction, Polynomial, Rational, Variable, compose};
use crate::verify::facts::Source;
use crate::verify::facts::premises::Facts;
use crate::verify::model::atoms::{Atoms, Nature, whole};
use crate::verify::reading::Premise;
use crate::verify::standing::judge::Judge;
use num_traits::Zero;
use std::collections::{BTreeMap, HashMap};

/// First integrals are looked for at no more lines.
const MOST_TRIES: usize = 12;

/// Values of more terms are not put in.
const MOST_TERMS: usize = 2_000;

/// Values of variables at the start.
type Images = BTreeMap<Variable, Fraction>;

impl Judge<'_> {
    /// Puts in what is kept from the start, as far as it is known by now.
    pub(super) fn keep_from_start(&mut self) {
        let start = &mut self.reading.start;
        if start.values.is_empty() || start.instants.len() > 1 || start.tries >= MOST_TRIES {
            return;
        }
        start.tries += 1;
        for candidate in std::mem::take(&mut self.reading.start.candidates) {
            match self.kept(&candidate) {
                Some(equation) => self.take_kept(equation),
                None => self.reading.start.candidates.push(candidate),
            }
        }
    }

    fn take_kept(&mut self, equation: Fraction) {
        let atoms = &mut self.reading.system.atoms;
        let follows = |facts: &mut Facts, atoms: &mut Atoms| {
            let normal = facts.normal(atoms, &equation);
            normal.is_ok_and(|normal| normal.is_zero())
        };
        if follows(&mut self.facts, atoms) {
            return;
        }
        if self.facts.extend(atoms, &equation, &Source::Start).is_err() {
            self.facts.miss(&Source::Start);
        }
        let reach = self.reading.reach_of_line(&self.at);
        self.settled_taken.push(self.reading.settled.len());
        self.reading.settled.push(Premise {
            equation,
            source: Source::Start,
            reach,
        });
    }

    /// A candidate less its value at the start, if it is a first integral and this value is known.
    fn kept(&mut self, candidate: &Fraction) -> Option<Fraction> {
        let atoms = &mut self.reading.system.atoms;
        let rate = atoms.short_derivative(candidate)?;
        if !self.facts.normal(atoms, &rate).ok()?.is_zero() {
            return None;
        }
        let mut facts = self.facts.clone();
        let value = self.at_start(&mut facts, candidate)?;
        let atoms = &mut self.reading.system.atoms;
        let constant = value.variables().into_iter().all(|v| {
            let rate = atoms.rate(v);
            let rate = self.facts.normal(atoms, &rate);
            !atoms.is_unknown(v) && rate.is_ok_and(|rate| rate.is_zero())
        });
        constant.then(|| candidate.clone() - value)
    }

    /// A value at the start, in what the lines about the start leave free.
    fn at_start(&mut self, facts: &mut Facts, of: &Fraction) -> Option<Fraction> {
        let images = self.images_at_start(facts)?;
        let atoms = &mut self.reading.system.atoms;
        let normal = facts.normal(atoms, of).ok()?;
        let then = put_in(&normal, &images)?;
        facts.normal(atoms, &then).ok()
    }

    /// What variables are at the start. A rate that vanishes then need not stay so: nothing is differentiated.
    fn images_at_start(&mut self, facts: &mut Facts) -> Option<Images> {
        let mut images = Images::new();
        for value in self.reading.start.values.clone() {
            let atoms = &mut self.reading.system.atoms;
            if let Some(kernels) = angle_at_start(atoms, &value) {
                images.extend(kernels);
                continue;
            }
            let normal = facts.normal(atoms, &value).ok()?;
            let then = put_in(&normal, &images)?;
            if then.is_zero() {
                continue;
            }
            let (variable, solved) = solved_for_motion(atoms, then.numerator())?;
            let own = Images::from([(variable, solved.clone())]);
            for image in images.values_mut() {
                *image = put_in(image, &own)?;
            }
            images.insert(variable, solved);
        }
        Some(images)
    }

    /// Whether a line may hold in the motion that begins with the values at the start: it does so then, as far as known.
    pub(super) fn may_hold_from_start(&mut self, sides: &[(Fraction, Fraction)]) -> bool {
        if self.reading.start.values.is_empty() {
            return false;
        }
        // What is kept may be solved for what the values at the start let vanish.
        let mut all = self.premises();
        all.retain(|(_, source)| *source != Source::Start);
        let mut facts = Facts::default();
        facts.extend_all(&mut self.reading.system.atoms, all);
        sides.iter().all(|(left, right)| {
            let then = self.at_start(&mut facts, &(left.clone() - right.clone()));
            then.is_none_or(|then| then.is_zero())
        })
    }
}

/// A fraction with values put in for variables; `None` where its denominator vanishes.
fn put_in(of: &Fraction, images: &Images) -> Option<Fraction> {
    let images: HashMap<Variable, Fraction> = images.clone().into_iter().collect();
    let put = |p: &Polynomial| compose(p, &images, MOST_TERMS).ok();
    let (top, bottom) = (put(of.numerator())?, put(of.denominator())?);
    (!bottom.is_zero()).then(|| top / bottom)
}

/// An equation solved for the highest rate, or a coordinate, that it is linear in.
fn solved_for_motion(atoms: &mut Atoms, equation: &Polynomial) -> Option<(Variable, Fraction)> {
    let linear = equation.variables().into_iter().filter(|&v| {
        let kernel = !matches!(atoms.atom(v).nature, Nature::Quantity | Nature::Unknown);
        equation.degree_in(v) == 1 && !kernel && !atoms.rate(v).is_zero()
    });
    let linear: Vec<Variable> = linear.collect();
    let variable = linear
        .into_iter()
        .max_by_key(|&v| (atoms.atom(v).key.order, !atoms.is_unknown(v), v))?;
    let slope = equation.coefficient_of(variable, 1);
    let rest = equation.coefficient_of(variable, 0);
    Some((variable, Fraction::new(-rest, slope)?))
}

/// The cosine and the sine of an angle that a line says at the start as a part of π.
fn angle_at_start(atoms: &mut Atoms, value: &Fraction) -> Option<Vec<(Variable, Fraction)>> {
    let polynomial = value.is_polynomial().then(|| value.numerator().clone())?;
    let pi = atoms.known_pi();
    let others = polynomial.variables().into_iter();
    let angles: Vec<Variable> = others.filter(|v| Some(*v) != pi).collect();
    let &[angle] = angles.as_slice() else {
        return None;
    };
    let slope = polynomial.coefficient_of(angle, 1).is_constant()?;
    let rest = polynomial.coefficient_of(angle, 0);
    let part = match pi {
        Some(pi) if rest.degree_in(pi) == 1 && rest.coefficient_of(pi, 0).is_zero() => {
            rest.coefficient_of(pi, 1).is_constant()?
        }
        _ if rest.is_zero() => Rational::zero(),
        _ => return None,
    };
    let is_rate = atoms.atom(angle).rate_of.is_some();
    if polynomial.degree_in(angle) != 1 || slope.is_zero() || is_rate {
        return None;
    }
    let whole_angle = Fraction::from(-rest) / Fraction::from(Polynomial::constant(slope.clone()));
    let steps = -part * Rational::from((12, 1)) / slope;
    let steps = Fraction::from(Polynomial::constant(steps));
    let (cosine, sine) = kernels_of(atoms, angle)?;
    let step = (0..24).find(|step| {
        let turns = (steps.clone() - whole(*step)) / whole(24);
        let turns = turns.to_rational();
        turns.is_some_and(|turns| turns.to_big().is_integer())
    })?;
    Some(vec![
        (angle, whole_angle),
        (cosine, atoms.cosine_of_steps(step)?),
        (sine, atoms.cosine_of_steps(step + 18)?),
    ])
}

/// The variables of the cosine and the sine of an angle.
fn kernels_of(atoms: &mut Atoms, angle: Variable) -> Option<(Variable, Variable)> {
    let angle = crate::verify::model::atoms::fraction(angle);
    let (cosine, sine) = atoms.cosine_sine(&angle)?;
    Some((cosine.as_variable()?, sine.as_variable()?))
}
