//! Small oscillations about where a letter is zero: what the equations of motion come to there tells their frequency.

use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::model::swings::{Pace, Swing};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::oscillations_read::{ANGULAR_FREQUENCY, FREQUENCY, PERIOD};
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;

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
        let mut facts = self.facts_so_far();
        let atoms = &mut self.system().atoms;
        let rate = atoms.rate(x).as_variable()?;
        let acceleration = atoms.rate(rate);
        let acceleration = facts.normal(atoms, &acceleration).ok()?;
        let stiffness = self.system().stiffness(&acceleration, x)?;
        let pace = match head {
            PERIOD => Pace::Period,
            FREQUENCY => Pace::Frequency,
            _ => Pace::AngularFrequency,
        };
        // ẍ = −ω² x to first order.
        let angular_frequency = self.system().atoms.root(&stiffness)?;
        let told = self.system().pace(pace, angular_frequency);
        self.reading.sizes.swings.push(Swing {
            of: x,
            pace,
            told: told.clone(),
        });
        let known = Quantity::ByRule(Value::scalar(told));
        self.denote(letter, Meaning::Quantity(known), declaration);
        Some(())
    }
}
