//! Letters that are the values of others at the steps of a computation.

use crate::algebra::{Fraction, Place};
use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::language::heads::STEP_SIZE;
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::{is_letter, node_of, written};
use crate::verify::term::letters::{Meaning, spelled};

/// The noun of one of the instants that a computation goes through.
pub(super) const STEP: &str = "step";
/// The step by which x becomes x + h ẋ.
pub(super) const EXPLICIT_EULER: &str = "explicit Euler";

impl Builder<'_> {
    /// "`$x_k$` is the value of `$x$` at step `$k$`": it is x then, and where the step is explicit Euler, `$x_{k+1}$` is
    /// what x and its rate make of it in the time of a step: in the letter for that, or `$t_{k+1}-t_k$`.
    pub(super) fn read_value_at_step(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let Some(Term::Phrase(step)) = what.slot(Slot::At) else {
            return None;
        };
        let (STEP, Some(Term::Formula(index)), Some(Term::Formula(of))) =
            (step.head, step.slot(Slot::Which), what.slot(Slot::Of))
        else {
            return None;
        };
        let index = index.source.as_str();
        for letter in formulas(subjects) {
            let next = next_letter(letter, index)?;
            let size = self.step_size();
            if self.is_time(of) {
                self.denote_number(letter, declaration);
                match size {
                    Some(size) => {
                        self.denote_as(&next, &format!("{}+{size}", letter.source), declaration)?
                    }
                    None => {
                        self.denote_number(&next, declaration);
                    }
                }
                continue;
            }
            let same = Meaning::Same(Box::new(node_of(of)?.clone()));
            self.denote(letter, same, declaration);
            if self.steps_explicitly() && self.moves(of, declaration) {
                let size = size.unwrap_or_else(|| format!("(t_{{{index}+1}}-t_{{{index}}})"));
                let source = format!("{0}+{size}\\,\\frac{{d}}{{dt}}{0}", of.source);
                self.denote_as(&next, &source, declaration)?;
            }
        }
        Some(())
    }

    /// Makes a letter another way to write a formula.
    fn denote_as(
        &mut self,
        letter: &Formula,
        formula: &str,
        declaration: &Declaration,
    ) -> Option<()> {
        let value = node_of(&written(formula)?)?.clone();
        self.denote(letter, Meaning::Same(Box::new(value)), declaration);
        Some(())
    }

    /// The letter that sentences give the time of one step, as long as all steps are as long.
    pub(super) fn step_size(&self) -> Option<String> {
        let mut said = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == STEP_SIZE => Some(subjects),
            _ => None,
        });
        let (subjects, None) = (said.next()?, said.next()) else {
            return None;
        };
        let [Term::Formula(letter)] = subjects.as_slice() else {
            return None;
        };
        is_letter(letter).then(|| letter.source.clone())
    }

    /// "`$h$` is the length of the step."
    pub(super) fn read_step_size(
        &mut self,
        subjects: &[Term],
        declaration: &Declaration,
    ) -> Option<()> {
        self.step_size()?;
        self.read_size(subjects, declaration);
        Some(())
    }

    /// Whether a letter is that of the time.
    pub(super) fn is_time(&self, letter: &Formula) -> bool {
        let writing = node_of(letter).map(spelled);
        let told = &self.reading.letters.letters;
        let mut time = told.iter().filter(|l| matches!(l.meaning, Meaning::Time));
        letter.source == "t" || time.any(|l| Some(&l.spelled) == writing.as_ref())
    }

    /// Whether a sentence says that the step is explicit Euler.
    pub(super) fn steps_explicitly(&self) -> bool {
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { what, .. } => what.head == EXPLICIT_EULER,
            _ => false,
        })
    }

    /// Whether a letter is one of what moves, and no load.
    pub(super) fn moves(&mut self, letter: &Formula, declaration: &Declaration) -> bool {
        let Some(value) = self.mentioned_value(letter, declaration) else {
            return false;
        };
        let atoms = &self.reading.system.atoms;
        let moves = |variable| {
            let atom = atoms.atom(variable);
            matches!(atom.place, Place::Coordinate | Place::Rate) && atom.law.is_none()
        };
        let variables = value.entries.iter().flat_map(Fraction::variables);
        variables.into_iter().all(moves)
    }
}

/// `x_{k+1}` of `x_k`.
pub(super) fn next_letter(letter: &Formula, index: &str) -> Option<Formula> {
    let node = node_of(letter)?;
    fn raised(node: &Node, index: &str) -> Option<Node> {
        let kind = match &node.kind {
            Kind::Symbol(symbol) => {
                let last = symbol.subscripts.last().filter(|last| *last == index)?;
                let mut subscripts = symbol.subscripts.clone();
                subscripts.pop();
                subscripts.push(format!("{last}+1"));
                Kind::Symbol(Symbol {
                    subscripts,
                    ..symbol.clone()
                })
            }
            Kind::Power(base, label) => Kind::Power(Box::new(raised(base, index)?), label.clone()),
            _ => return None,
        };
        Some(Node {
            kind,
            span: node.span,
        })
    }
    Some(Formula::of(&raised(node, index)?))
}
