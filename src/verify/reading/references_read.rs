//! Reference values and small disturbances: P = P₀ + p.

use crate::algebra::{Fraction, Variable};
use crate::verify::facts::premises::Facts;
use crate::verify::language::heads::{DISTURBANCE, REFERENCE};
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::model::atoms::Law;
use crate::verify::model::system::System;
use crate::verify::reading::Premise;
use crate::verify::reading::builder::{Builder, MOST_TERMS};
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::node_of;
use crate::verify::reading::reference_motion::{is_undisturbed, undisturbed};
use crate::verify::term::letters::{Meaning, Reach, spelled};
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;

impl Builder<'_> {
    /// "`P_0` is the reference value of `P`, and `p` its small disturbance": both are letters of their own.
    pub(super) fn read_reference(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let of = self.of_letter(what)?;
        let whole = self.formula_value(&of, declaration)?;
        // What a disturbance is of which no reference value has a letter the reference values of others tell.
        if what.head == DISTURBANCE && self.letter_said(REFERENCE, &of).is_none() {
            return Some(());
        }
        for formula in formulas(subjects) {
            let text = formula.source.clone();
            let quantity = match whole.is_scalar() {
                true => Quantity::Scalar {
                    text,
                    constant: false,
                },
                false => Quantity::Vector {
                    text,
                    carried: None,
                },
            };
            self.denote(formula, Meaning::Quantity(quantity), declaration);
            if what.head == REFERENCE {
                let letter = node_of(formula).map(spelled);
                self.reading.sizes.reference.extend(letter);
            }
        }
        Some(())
    }

    /// What a reference value and a disturbance make up.
    pub(super) fn make_up_of_references(&mut self) {
        for declaration in self.declarations {
            let Statement::Is { what, .. } = &declaration.statement else {
                continue;
            };
            if what.head == DISTURBANCE
                && let Some(of) = self.of_letter(what)
                && self.made_up(&of, declaration).is_none()
            {
                self.say_unused(declaration);
            }
        }
        for declaration in self.declarations {
            if let Statement::Is { what, .. } = &declaration.statement
                && what.head == REFERENCE
                && self.hold_lone_reference(what, declaration).is_none()
            {
                self.say_unused(declaration);
            }
        }
        self.reading.sizes.disturbances = self.disturbances().into_iter().collect();
        self.change_by_disturbances();
    }

    /// What the premises of the whole document say so far.
    pub(super) fn facts_so_far(&mut self) -> Facts {
        self.facts_of(|_, _| true)
    }

    /// What some of the premises of the whole document say so far.
    pub(super) fn facts_of(&mut self, wanted: impl Fn(&System, &Premise) -> bool) -> Facts {
        let system = &self.reading.system;
        let premises = self.reading.premises.iter();
        let premises = premises.filter(|p| p.reach == Reach::All && wanted(system, p));
        let premises = premises.map(|p| (p.equation.clone(), p.source.clone()));
        let premises = premises.collect();
        let mut facts = Facts::default();
        facts.extend_all(&mut self.reading.system.atoms, premises);
        facts
    }

    /// Whether all that moves in a value are reference values.
    pub(super) fn is_calm(&mut self, value: &Fraction) -> bool {
        let references = self.variables_said(REFERENCE, |_, _| true);
        let atoms = &self.reading.system.atoms;
        let mut variables = value.variables().into_iter();
        variables.all(|v| is_undisturbed(atoms, v, &references))
    }

    /// A reference value without a letter for the disturbance is what the whole is where nothing is disturbed.
    fn hold_lone_reference(&mut self, what: &NounPhrase, declaration: &Declaration) -> Option<()> {
        let of = self.of_letter(what)?;
        if self.letter_said(DISTURBANCE, &of).is_some() {
            return Some(());
        }
        let reference = self.letter_said(REFERENCE, &of)?;
        let whole = self.mentioned_value(&of, declaration)?;
        let reference = self.mentioned_value(&reference, declaration)?;
        let small = self.disturbances();
        let mut facts = self.facts_so_far();
        for (whole, reference) in whole.entries.iter().zip(&reference.entries) {
            let atoms = &mut self.reading.system.atoms;
            let mut value = Facts::default().normal(atoms, whole).ok()?;
            // What has a variable of its own obeys equations, and so does its reference value; how far it is from it where
            // something is small nothing tells.
            if value.as_variable().is_some() {
                match self.letters_of_orders().next() {
                    Some(_) => return None,
                    None => continue,
                }
            }
            let mut calm = undisturbed(atoms, &value, &small)?;
            if !self.is_calm(&calm) {
                let atoms = &mut self.reading.system.atoms;
                value = facts.normal(atoms, &value).ok()?;
                calm = undisturbed(atoms, &value, &small)?;
            }
            // What moves beside the reference values is disturbed as well.
            if !self.is_calm(&calm) {
                return None;
            }
            self.hold(reference.clone() - calm, declaration);
        }
        Some(())
    }

    fn made_up(&mut self, of: &Formula, declaration: &Declaration) -> Option<()> {
        let Some(reference) = self.letter_said(REFERENCE, of) else {
            return self.disturbed(of, declaration);
        };
        let disturbance = self.letter_said(DISTURBANCE, of)?;
        let whole = self.mentioned_value(of, declaration)?;
        let reference = self.mentioned_value(&reference, declaration)?;
        let disturbance = self.mentioned_value(&disturbance, declaration)?;
        self.make_up(&whole, &reference, &disturbance, declaration);
        Some(())
    }

    /// The disturbance of what has no letter for its reference value: what it is more than where nothing is disturbed.
    fn disturbed(&mut self, of: &Formula, declaration: &Declaration) -> Option<()> {
        let letter = self.letter_said(DISTURBANCE, of)?;
        let whole = self.mentioned_value(of, declaration)?;
        let small = self.disturbances();
        let mut change = whole.clone();
        for entry in &mut change.entries {
            let atoms = &mut self.reading.system.atoms;
            let value = Facts::default().normal(atoms, entry).ok()?;
            let calm = undisturbed(atoms, &value, &small)?;
            // What no disturbance changes has none: its own reference value would have to be told.
            if calm == value {
                return None;
            }
            *entry = value - calm;
        }
        self.denote(
            &letter,
            Meaning::Quantity(Quantity::Known(change)),
            declaration,
        );
        Some(())
    }

    /// The letter that a sentence says to be the reference value, or the disturbance, of another.
    pub(super) fn letter_said(&self, noun: &str, of: &Formula) -> Option<Formula> {
        self.declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == noun => {
                let said = self.of_letter(what)?;
                (said.source == of.source).then(|| formulas(subjects).next().cloned())?
            }
            _ => None,
        })
    }

    /// Whether a sentence says that a letter is the reference value of another.
    pub(super) fn is_reference(&self, letter: &Formula) -> bool {
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == REFERENCE => {
                formulas(subjects).any(|other| other.source == letter.source)
            }
            _ => false,
        })
    }

    /// The letter of which something is the reference value or the disturbance; a disturbance of a reference value is one of
    /// the letter itself.
    pub(super) fn of_letter(&self, what: &NounPhrase) -> Option<Formula> {
        let Some(Term::Formula(of)) = what.slot(Slot::Of) else {
            return None;
        };
        let refers = |d: &Declaration| match &d.statement {
            Statement::Is { subjects, what } if what.head == REFERENCE => {
                let mut letters = formulas(subjects);
                let named = letters.any(|letter| letter.source == of.source);
                match what.slot(Slot::Of) {
                    Some(Term::Formula(whole)) if named => Some(whole.clone()),
                    _ => None,
                }
            }
            _ => None,
        };
        let whole = self.declarations.iter().find_map(refers);
        Some(whole.unwrap_or_else(|| of.clone()))
    }

    /// Each component is its reference value and its disturbance: by definition, or as a premise where it is told already.
    fn make_up(
        &mut self,
        whole: &Value,
        reference: &Value,
        disturbance: &Value,
        declaration: &Declaration,
    ) {
        let parts = reference.entries.iter().zip(&disturbance.entries);
        for (entry, (a, b)) in whole.entries.iter().zip(parts) {
            let sum = a.clone() + b.clone();
            let free = entry.as_variable().filter(|variable| {
                let untold = self.reading.system.atoms.atom(*variable).law.is_none();
                untold && !a.variables().contains(variable)
            });
            match free {
                Some(variable) => {
                    self.tell_kernels(variable, &sum);
                    let atom = self.reading.system.atoms.atom_mut(variable);
                    atom.law = Some(Law {
                        name: "definition",
                        value: sum,
                    });
                }
                None if self.is_made_up_so(entry, &sum) => {}
                None => self.hold(entry.clone() - sum, declaration),
            }
        }
    }

    /// The sines and cosines of an angle that the model has already are those of the sum.
    fn tell_kernels(&mut self, angle: Variable, sum: &Fraction) {
        let atoms = &mut self.reading.system.atoms;
        for (kernel, value) in atoms.sines_by(angle, sum, MOST_TERMS) {
            let name = "definition";
            atoms.atom_mut(kernel).law = Some(Law { name, value });
        }
    }

    /// Whether a letter is defined as this sum.
    fn is_made_up_so(&self, entry: &Fraction, sum: &Fraction) -> bool {
        let variable = entry.as_variable();
        let law = variable.and_then(|v| self.reading.system.atoms.atom(v).law.as_ref());
        law.is_some_and(|law| law.value == *sum)
    }

    /// The variables that sentences say to be small disturbances.
    pub(super) fn disturbances(&mut self) -> Vec<Variable> {
        // What has no reference value of its own is small by the others.
        self.variables_said(DISTURBANCE, |builder, what| {
            let of = builder.of_letter(what);
            of.is_none_or(|of| builder.letter_said(REFERENCE, &of).is_some())
        })
    }

    /// The variables of the letters that sentences say to be something, where it fits.
    pub(super) fn variables_said(
        &mut self,
        noun: &str,
        fits: impl Fn(&Self, &NounPhrase) -> bool,
    ) -> Vec<Variable> {
        let mut variables = vec![];
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            if what.head != noun || !fits(self, what) {
                continue;
            }
            for formula in formulas(subjects) {
                if let Some(value) = self.mentioned_value(formula, declaration) {
                    variables.extend(value.entries.iter().flat_map(Fraction::variables));
                }
            }
        }
        variables
    }
}
