//! Reference values and small disturbances: P = P₀ + p.

use crate::algebra::{Fraction, Polynomial, Variable};
use crate::verify::facts::premises::Facts;
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::model::atoms::Law;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;
use num_traits::Zero;

pub(super) const REFERENCE: &str = "reference value";
pub(super) const DISTURBANCE: &str = "disturbance";

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
    }

    fn made_up(&mut self, of: &Formula, declaration: &Declaration) -> Option<()> {
        let reference = self.letter_said(REFERENCE, of)?;
        let disturbance = self.letter_said(DISTURBANCE, of)?;
        let whole = self.mentioned_value(of, declaration)?;
        let reference = self.mentioned_value(&reference, declaration)?;
        let disturbance = self.mentioned_value(&disturbance, declaration)?;
        self.make_up(&whole, &reference, &disturbance)
    }

    /// The letter that a sentence says to be the reference value, or the disturbance, of another.
    fn letter_said(&self, noun: &str, of: &Formula) -> Option<Formula> {
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
    fn of_letter(&self, what: &NounPhrase) -> Option<Formula> {
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

    /// Each component is its reference value and its disturbance; one that is told otherwise already holds the same.
    fn make_up(&mut self, whole: &Value, reference: &Value, disturbance: &Value) -> Option<()> {
        let parts = reference.entries.iter().zip(&disturbance.entries);
        for (entry, (a, b)) in whole.entries.iter().zip(parts) {
            let variable = entry.as_variable()?;
            let atom = self.reading.system.atoms.atom_mut(variable);
            if atom.law.is_some() || a.variables().contains(&variable) {
                continue;
            }
            atom.law = Some(Law {
                name: "definition",
                value: a.clone() + b.clone(),
            });
        }
        Some(())
    }

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
        for premise in self.reading.premises.clone() {
            let atoms = &mut self.reading.system.atoms;
            let value = Facts::default().normal(atoms, &premise.equation).ok()?;
            let is_small = |variable: Variable| {
                let mut at = Some(variable);
                while let Some(variable) = at {
                    if small.contains(&variable) {
                        return true;
                    }
                    at = atoms.atom(variable).rate_of;
                }
                false
            };
            let mut undisturbed = value.numerator().clone();
            for variable in value.numerator().variables() {
                if is_small(variable) {
                    undisturbed = undisturbed.substitute(variable, &Polynomial::zero());
                }
            }
            let mut other = premise.clone();
            other.equation = Fraction::from(undisturbed);
            other.source = Self::source_of(declaration);
            if !other.equation.is_zero() {
                self.reading.premises.push(other);
            }
        }
        Some(())
    }

    /// The variables that sentences say to be small disturbances.
    fn disturbances(&mut self) -> Vec<Variable> {
        let mut variables = vec![];
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            if what.head != DISTURBANCE {
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
