//! The motion in which nothing is disturbed.

use crate::algebra::{Fraction, Polynomial, Variable};
use crate::verify::facts::Source;
use crate::verify::facts::premises::Facts;
use crate::verify::facts::small::Small;
use crate::verify::language::heads::REFERENCE;
use crate::verify::language::statement::{Declaration, Statement, Term};
use crate::verify::model::atoms::{Atoms, Motion, Nature};
use crate::verify::reading::builder::Builder;
use num_traits::Zero;
use std::collections::BTreeSet;

impl Builder<'_> {
    /// What is said to obey the equations of motion.
    pub(super) fn read_obeyed(&mut self) {
        for declaration in self.declarations {
            let Statement::Does {
                subjects,
                verb: "obey",
                ..
            } = &declaration.statement
            else {
                continue;
            };
            let references = |t: &Term| matches!(t, Term::Phrase(p) if p.head == REFERENCE);
            let obeyed = subjects.iter().all(references);
            if !obeyed || self.reference_motion(declaration).is_none() {
                self.say_unused(declaration);
            }
        }
    }

    /// "The reference values obey the equations of motion": what is declared holds without the disturbances as well.
    fn reference_motion(&mut self, declaration: &Declaration) -> Option<()> {
        let small = self.disturbances();
        if small.is_empty() {
            return None;
        }
        let references = self.variables_said(REFERENCE, |_, _| true);
        let mut others = vec![];
        for (place, premise) in self.reading.premises.clone().into_iter().enumerate() {
            let atoms = &mut self.reading.system.atoms;
            let value = Facts::default().normal(atoms, &premise.equation).ok()?;
            let above = Fraction::from(value.numerator().clone());
            let calm = undisturbed(atoms, &above, &small)?;
            // What moves and has no reference value of its own is disturbed as well.
            let mut variables = calm.variables().into_iter();
            if !variables.all(|v| is_undisturbed(atoms, v, &references)) {
                others.push((premise.equation.clone(), premise.source.clone()));
                continue;
            }
            let mut other = premise.clone();
            other.equation = calm;
            other.source = Self::source_of(declaration);
            if !other.equation.is_zero() {
                let laws = &mut self.reading.sizes.changes.laws;
                if laws.contains(&place) {
                    laws.push(self.reading.premises.len());
                }
                self.reading.premises.push(other);
            }
        }
        self.tell_places_alone(others, &small, &references)
            .then_some(())
    }

    /// Whether equations say of reference values no more than where things are that have none: each tells another one of
    /// these.
    fn tell_places_alone(
        &mut self,
        equations: Vec<(Fraction, Source)>,
        small: &[Variable],
        references: &[Variable],
    ) -> bool {
        let atoms = &mut self.reading.system.atoms;
        let variables = equations
            .iter()
            .flat_map(|(equation, _)| equation.variables());
        let variables: BTreeSet<Variable> = variables.collect();
        let rates = |v: Variable| atoms.antiderivatives(v);
        let moves = |v: &Variable| {
            let disturbed = rates(*v).any(|v| small.contains(&v));
            !disturbed && !is_undisturbed(atoms, *v, references)
        };
        let places: BTreeSet<Variable> = variables.into_iter().filter(moves).collect();
        let first = |v: &&Variable| !rates(**v).skip(1).any(|v| places.contains(&v));
        let first: Vec<Variable> = places.iter().filter(first).copied().collect();
        let mut facts = Facts::default();
        let count = equations.len();
        facts.extend_all(&mut self.reading.system.atoms, equations);
        let told = first.iter().filter(|v| facts.rule(**v).is_some());
        facts.missing().is_none() && told.count() == count
    }
}

/// Whether a variable stays as it is where nothing is disturbed: it does not change, or is made of reference values.
pub(super) fn is_undisturbed(atoms: &Atoms, variable: Variable, references: &[Variable]) -> bool {
    let atom = atoms.atom(variable);
    if matches!(atom.motion, Motion::Constant) || references.contains(&variable) {
        return true;
    }
    match (&atom.nature, atom.rate_of) {
        (_, Some(of)) => is_undisturbed(atoms, of, references),
        (Nature::Sine(of) | Nature::Cosine(of) | Nature::Root(of), None) => {
            let mut variables = of.variables().into_iter();
            variables.all(|v| v != variable && is_undisturbed(atoms, v, references))
        }
        _ => false,
    }
}

/// A value where all disturbances and their rates are zero; none where it has no value there.
pub(super) fn undisturbed(atoms: &Atoms, value: &Fraction, small: &[Variable]) -> Option<Fraction> {
    let is_small = |variable: Variable| atoms.antiderivatives(variable).any(|v| small.contains(&v));
    let kernels = Small::new(small.to_vec(), 1);
    let calm = |polynomial: &Polynomial| {
        let mut calm = polynomial.clone();
        for (kernel, value) in kernels.kernels(atoms, polynomial) {
            calm = calm.substitute(kernel, &value);
        }
        let small = calm.variables().into_iter().filter(|v| is_small(*v));
        small.fold(calm, |calm, variable| {
            calm.substitute(variable, &Polynomial::zero())
        })
    };
    let below = calm(value.denominator());
    (!below.is_zero()).then(|| Fraction::from(calm(value.numerator())) / Fraction::from(below))
}
