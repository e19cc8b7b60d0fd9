//! First integrals: what does not change by the equations of motion is what it is at any instant.
//!
//! Candidates are energies, components of momenta, and what changes evenly in time. One whose rate vanishes by what holds is
//! equal to the value that is told of an instant. Nothing else of it is carried to other times.

use crate::algebra::{Fraction, Polynomial, Rational, Variable, compose_by};
use crate::verify::facts::Source;
use crate::verify::facts::premises::Facts;
use crate::verify::facts::proof::prove;
use crate::verify::facts::small::Small;
use crate::verify::model::atoms::{Atoms, Nature, whole};
use crate::verify::reading::Premise;
use crate::verify::standing::judge::Judge;
use num_traits::Zero;
use std::collections::BTreeMap;

/// First integrals are looked for at no more lines.
const MOST_TRIES: usize = 12;

/// Values of more terms are not put in.
const MOST_TERMS: usize = 2_000;

/// Values of variables at an instant.
pub(super) type Images = BTreeMap<Variable, Fraction>;

/// What is told of an instant.
#[derive(Default)]
struct Then {
    images: Images,
    /// What follows between constants.
    ties: Vec<(Fraction, Source)>,
    /// Of which nothing was made.
    left: Vec<Fraction>,
}

impl Then {
    /// Takes in what vanishes then; `None` where it is not solved yet.
    fn take(
        &mut self,
        facts: &mut Facts,
        atoms: &mut Atoms,
        value: &Fraction,
        source: &Source,
    ) -> Option<()> {
        if let Some(kernels) = angle_at_instant(atoms, value) {
            self.images.extend(kernels);
            return Some(());
        }
        let normal = facts.normal(atoms, value).ok()?;
        let then = put_in(&normal, &self.images)?;
        if then.is_zero() {
            return Some(());
        }
        if is_constant(atoms, &then) {
            self.ties.push((then, source.clone()));
            return Some(());
        }
        let (variable, solved) = solved_for_motion(atoms, then.numerator())?;
        let own = Images::from([(variable, solved.clone())]);
        for image in self.images.values_mut() {
            *image = put_in(image, &own)?;
        }
        self.images.insert(variable, solved);
        Some(())
    }
}

impl Judge<'_> {
    /// Puts in what is kept from instants, as far as it is known by now.
    pub(super) fn keep_from_instants(&mut self) {
        let instants = &self.reading.instants;
        let told: Vec<usize> = instants.told().collect();
        // What holds at an instant alone is no law of the motion, and a sentence of which nothing was made may be one.
        let unsure = instants.taken.is_some() || !self.reading.unused.is_empty();
        let instants = &mut self.reading.instants;
        if told.is_empty() || unsure || instants.tries >= MOST_TRIES {
            return;
        }
        instants.tries += 1;
        for &instant in &told {
            self.tie_values(instant);
        }
        for candidate in std::mem::take(&mut self.reading.instants.candidates) {
            let mut waits = false;
            for &instant in &told {
                let source = Source::Instant(self.reading.instants.all[instant].name.clone());
                match self.kept(&candidate, instant) {
                    Some(equation) => self.take_kept(equation, source),
                    None => waits = true,
                }
            }
            if waits {
                self.reading.instants.candidates.push(candidate);
            }
        }
    }

    /// Values at one instant that tell each other: of x and of what is worked out from x.
    fn tie_values(&mut self, instant: usize) {
        let mut facts = self.facts.clone();
        let Then { ties, left, .. } = self.values_at(&mut facts, &[instant]);
        let instants = &mut self.reading.instants;
        let letters = left.iter().flat_map(Fraction::variables);
        let untied = letters.filter(|letter| instants.letters.contains(letter));
        let untied: Vec<Variable> = untied.collect();
        instants.untied.extend(untied);
        for (tie, source) in ties {
            self.take_kept(tie, source);
        }
    }

    fn take_kept(&mut self, equation: Fraction, source: Source) {
        let atoms = &mut self.reading.system.atoms;
        let follows = |facts: &mut Facts, atoms: &mut Atoms| {
            let normal = facts.normal(atoms, &equation);
            normal.is_ok_and(|normal| normal.is_zero())
        };
        if follows(&mut self.facts, atoms) {
            return;
        }
        if self.facts.extend(atoms, &equation, &source).is_err() {
            self.facts.miss(&source);
        }
        let reach = self.reading.reach_of_line(&self.at, false);
        self.settled_taken.push(self.reading.settled.len());
        self.reading.settled.push(Premise {
            equation,
            source,
            reach,
        });
    }

    /// A candidate less its value at an instant, if it is a first integral and this value is known.
    fn kept(&mut self, candidate: &Fraction, instant: usize) -> Option<Fraction> {
        let atoms = &mut self.reading.system.atoms;
        let rate = atoms.short_derivative(candidate)?;
        if !self.facts.normal(atoms, &rate).ok()?.is_zero() {
            return None;
        }
        let mut facts = self.facts.clone();
        // What only vanishes where points happen not to lie somewhere need not be kept.
        if atoms.has_unplaced() {
            prove(
                &mut facts,
                atoms,
                &[(rate, Fraction::zero())],
                &Small::default(),
            )?;
        }
        let value = self.at_instants(&mut facts, candidate, &[instant])?;
        let atoms = &mut self.reading.system.atoms;
        let constant = value.variables().into_iter().all(|v| {
            let rate = atoms.rate(v);
            let rate = self.facts.normal(atoms, &rate);
            !atoms.is_unknown(v) && rate.is_ok_and(|rate| rate.is_zero())
        });
        // What is told of its letters stays told by others.
        let now = self.facts.normal(atoms, candidate).ok()?;
        constant.then(|| now - value)
    }

    /// A value at instants, in what is told of them leaves free.
    fn at_instants(
        &mut self,
        facts: &mut Facts,
        of: &Fraction,
        instants: &[usize],
    ) -> Option<Fraction> {
        let Then { images, .. } = self.values_at(facts, instants);
        let atoms = &mut self.reading.system.atoms;
        let normal = facts.normal(atoms, of).ok()?;
        let then = put_in(&normal, &images)?;
        facts.normal(atoms, &then).ok()
    }

    /// What is so at instants that are one. A rate that vanishes then need not stay so: nothing is differentiated.
    fn values_at(&mut self, facts: &mut Facts, instants: &[usize]) -> Then {
        let mut then = Then::default();
        let all = &self.reading.instants.all;
        let values = instants.iter().flat_map(|&instant| &all[instant].values);
        let mut waiting: Vec<(Fraction, Source)> = values.cloned().collect();
        let mut before = usize::MAX;
        while waiting.len() < before {
            before = waiting.len();
            for (value, source) in std::mem::take(&mut waiting) {
                let atoms = &mut self.reading.system.atoms;
                if then.take(facts, atoms, &value, &source).is_none() {
                    waiting.push((value, source));
                }
            }
        }
        then.left = waiting.into_iter().map(|(value, _)| value).collect();
        then
    }

    /// Whether a line may hold in a motion of which values are told at an instant: it does so then, as far as known.
    pub(super) fn may_hold_in_motion(&mut self, sides: &[(Fraction, Fraction)]) -> bool {
        // What is kept may be solved for what the values at the start let vanish.
        let mut all = self.premises();
        all.retain(|(_, source)| !matches!(source, Source::Instant(_)));
        let mut facts = Facts::default();
        facts.extend_all(&mut self.reading.system.atoms, all);
        let told: Vec<usize> = self.reading.instants.told().collect();
        if told.is_empty() {
            return false;
        }
        // Two instants may be one.
        let mut each = told.chunks(1).chain([told.as_slice()]);
        each.any(|instants| {
            sides.iter().all(|(left, right)| {
                let then = self.at_instants(&mut facts, &(left.clone() - right.clone()), instants);
                then.is_none_or(|then| then.is_zero())
            })
        })
    }
}

/// Whether something but time changes in what is left over.
pub(super) fn moves(atoms: &mut Atoms, residuals: &[Fraction]) -> bool {
    let time = atoms.known_time();
    let mut variables = residuals.iter().flat_map(Fraction::variables);
    variables.any(|v| Some(v) != time && !atoms.rate(v).is_zero())
}

/// Whether nothing in a value moves.
fn is_constant(atoms: &mut Atoms, value: &Fraction) -> bool {
    let mut variables = value.variables().into_iter();
    variables.all(|v| !atoms.is_unknown(v) && atoms.rate(v).is_zero())
}

/// A fraction with values put in for variables; `None` where its denominator vanishes.
pub(super) fn put_in(of: &Fraction, images: &Images) -> Option<Fraction> {
    let put = |p: &Polynomial| compose_by(p, |v| images.get(&v), MOST_TERMS).ok();
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

/// The cosine and the sine of an angle that is told at an instant, as a part of π or in constants.
fn angle_at_instant(atoms: &mut Atoms, value: &Fraction) -> Option<Vec<(Variable, Fraction)>> {
    let polynomial = value.is_polynomial().then(|| value.numerator().clone())?;
    let variables = polynomial.variables().into_iter();
    let moving: Vec<Variable> = variables.filter(|&v| !atoms.rate(v).is_zero()).collect();
    let &[angle] = moving.as_slice() else {
        return None;
    };
    let slope = polynomial.coefficient_of(angle, 1).is_constant()?;
    let rest = polynomial.coefficient_of(angle, 0);
    let is_rate = atoms.atom(angle).rate_of.is_some();
    if polynomial.degree_in(angle) != 1
        || slope.is_zero()
        || is_rate
        || Some(angle) == atoms.known_time()
    {
        return None;
    }
    let slope = Fraction::from(Polynomial::constant(slope));
    let then = Fraction::from(-rest) / slope;
    let kernels = match part_of_pi(atoms, &then) {
        Some(part) => kernels_of_part(atoms, part)?,
        None => atoms.cosine_sine(&then)?,
    };
    let (cosine, sine) = kernels_of(atoms, angle)?;
    Some(vec![(angle, then), (cosine, kernels.0), (sine, kernels.1)])
}

/// How many times π an angle is, if it is told so.
fn part_of_pi(atoms: &Atoms, angle: &Fraction) -> Option<Rational> {
    if angle.is_zero() {
        return Some(Rational::zero());
    }
    let pi = Fraction::from(Polynomial::variable(atoms.known_pi()?));
    (angle.clone() / pi).to_rational()
}

/// The cosine and the sine of a multiple of 15° that has exact ones.
fn kernels_of_part(atoms: &mut Atoms, part: Rational) -> Option<(Fraction, Fraction)> {
    let steps = Fraction::from(Polynomial::constant(part * Rational::from((12, 1))));
    let step = (0..24).find(|step| {
        let turns = (steps.clone() - whole(*step)) / whole(24);
        let turns = turns.to_rational();
        turns.is_some_and(|turns| turns.to_big().is_integer())
    })?;
    Some((
        atoms.cosine_of_steps(step)?,
        atoms.cosine_of_steps(step + 18)?,
    ))
}

/// The variables of the cosine and the sine of an angle.
fn kernels_of(atoms: &mut Atoms, angle: Variable) -> Option<(Variable, Variable)> {
    let angle = crate::verify::model::atoms::fraction(angle);
    let (cosine, sine) = atoms.cosine_sine(&angle)?;
    Some((cosine.as_variable()?, sine.as_variable()?))
}
