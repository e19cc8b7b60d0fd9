//! First-order changes and Jacobians.

use crate::algebra::{Fraction, Polynomial, Variable};
use crate::verify::facts::premises::Facts;
use crate::verify::facts::small::Small;
use crate::verify::language::heads::{
    CONSTANT, DISTURBANCE, FIRST_ORDER_CHANGE, OUTPUTS_IN_COLUMNS, OUTPUTS_IN_ROWS,
};
use crate::verify::language::statement::{
    Declaration, Extent, Formula, NounPhrase, Slot, Statement, Term,
};
use crate::verify::model::atoms::Motion;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::{is_letter, node_of};
use crate::verify::reading::{Jacobian, Premise};
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{Basis, Shape, Value};
use num_traits::Zero;
use std::collections::BTreeSet;

/// Laws with changes of more terms are not put in.
const MOST_TERMS: usize = 2_000;

/// Constants that an equation ties together.
struct Tie {
    constants: BTreeSet<Variable>,
    /// Whether it holds in any motion.
    is_law: bool,
}

impl Tie {
    /// Its constants beside those that are others in motions nearby, if it has any of these.
    fn others(&self, varied: &BTreeSet<Variable>) -> Vec<Variable> {
        match self.constants.is_disjoint(varied) {
            true => vec![],
            false => self.constants.difference(varied).copied().collect(),
        }
    }
}

/// Whether what a sentence says holds in any motion of the system, and does not say which motion is looked at.
fn is_law(declaration: &Declaration) -> bool {
    let everywhere = declaration.extent == Extent::Document;
    everywhere
        && match &declaration.statement {
            Statement::Premise(_) => true,
            Statement::Does { verb, .. } => *verb != "hold",
            Statement::Is { what, .. } => !["zero", CONSTANT].contains(&what.head),
            _ => false,
        }
}

impl Builder<'_> {
    /// Notes that the next premise holds in any motion, if it does.
    pub(super) fn note_law(&mut self, declaration: &Declaration) {
        if is_law(declaration) {
            let place = self.reading.premises.len();
            self.reading.sizes.changes.laws.push(place);
        }
    }

    /// "`$\delta x$` is the first-order change of `$x$`."
    pub(super) fn read_change(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let of: Vec<&Formula> = what.all(Slot::Of).filter_map(as_formula).collect();
        let letters: Vec<&Formula> = subjects.iter().filter_map(as_formula).collect();
        if of.len() != letters.len() || letters.len() != subjects.len() {
            return None;
        }
        for (letter, of) in letters.into_iter().zip(of) {
            let node = node_of(of)?.clone();
            let meaning = Meaning::Change(Some(Box::new(node)));
            self.denote(letter, meaning, declaration);
            self.reading.sizes.changes.told = true;
        }
        Some(())
    }

    /// Constants whose changes have letters are others in motions nearby, and so is each that an equation tells by them;
    /// whether no equation leaves open which others are.
    fn vary_constants(&mut self) -> bool {
        let values = self.all_changed_values();
        let entries = values.iter().flat_map(|value| &value.entries);
        let atoms = &self.reading.system.atoms;
        let own = entries.filter_map(Fraction::as_variable);
        let mut varied: BTreeSet<Variable> = own.filter(|v| atoms.may_vary(*v)).collect();
        if varied.is_empty() {
            return true;
        }
        let ties = self.ties_of_constants();
        let atoms = &self.reading.system.atoms;
        let tied = |varied: &BTreeSet<Variable>| {
            let mut laws = ties.iter().filter(|tie| tie.is_law);
            laws.find_map(|tie| match tie.others(varied).as_slice() {
                [one] if atoms.may_vary(*one) => Some(*one),
                _ => None,
            })
        };
        while let Some(constant) = tied(&varied) {
            varied.insert(constant);
        }
        let told = ties.iter().all(|tie| tie.others(&varied).is_empty());
        for constant in varied {
            self.system().atoms.vary_constant(constant);
        }
        told
    }

    /// The equations in which nothing moves.
    fn ties_of_constants(&mut self) -> Vec<Tie> {
        let mut ties = vec![];
        for (place, premise) in self.reading.premises.iter().enumerate() {
            let atoms = &mut self.reading.system.atoms;
            let Ok(equation) = Facts::default().normal(atoms, &premise.equation) else {
                continue;
            };
            let variables = equation.variables().into_iter();
            let constants: BTreeSet<Variable> = variables.flat_map(|v| atoms.roots(v)).collect();
            let moves = |v: &Variable| !matches!(atoms.atom(*v).motion, Motion::Constant);
            if !constants.iter().any(moves) {
                let is_law = self.reading.sizes.changes.laws.contains(&place);
                ties.push(Tie { constants, is_law });
            }
        }
        ties
    }

    /// What holds in any motion holds in motions nearby. Where that is not worked out, nothing is made of changes.
    pub(super) fn vary_laws(&mut self) {
        if !self.reading.sizes.changes.told {
            return;
        }
        let mut whole = self.vary_constants();
        let told = self.told_changes();
        for place in self.reading.sizes.changes.laws.clone() {
            let law = self.reading.premises[place].clone();
            match self.system().atoms.change(&law.equation) {
                Some(change) if change.is_zero() => {}
                Some(change) if change.numerator().len() > MOST_TERMS => whole = false,
                Some(change) if self.is_of_one(&change, &told) => whole = false,
                Some(equation) => {
                    let varied = self.reading.premises.len();
                    self.reading.sizes.changes.laws.push(varied);
                    self.reading.premises.push(Premise { equation, ..law });
                }
                None => whole = false,
            }
        }
        for declaration in self.declarations.iter().filter(|d| says_changes(d)) {
            if !whole || self.stays_as_it_is(declaration) {
                self.leave_change(declaration);
            }
        }
    }

    /// The variables of the changes that have letters.
    fn told_changes(&mut self) -> BTreeSet<Variable> {
        let values = self.all_changed_values();
        let atoms = &mut self.reading.system.atoms;
        let entries = values.iter().flat_map(|value| &value.entries);
        let changes = entries.filter_map(|entry| atoms.change(entry));
        changes.flat_map(|change| change.variables()).collect()
    }

    /// Whether an equation tells one change alone, of those that have letters: so what it comes from is rather told of the
    /// motion at hand.
    fn is_of_one(&self, equation: &Fraction, told: &BTreeSet<Variable>) -> bool {
        let atoms = &self.reading.system.atoms;
        let variables = equation.numerator().variables().into_iter();
        let changes: Vec<Variable> = variables.filter(|v| atoms.is_change(*v)).collect();
        matches!(changes.as_slice(), [one] if told.contains(one))
    }

    /// The change of which a sentence tells is not worked out.
    fn leave_change(&mut self, declaration: &Declaration) {
        self.say_unused(declaration);
        self.take_back(declaration);
    }

    /// The letters of a sentence are no changes in motions nearby, and neither are those that are told by them.
    fn take_back(&mut self, declaration: &Declaration) {
        let Statement::Is { subjects, .. } = &declaration.statement else {
            return;
        };
        let own: Vec<&str> = formulas(subjects).map(|f| f.source.as_str()).collect();
        let by_own = |other: &&Declaration| match &other.statement {
            Statement::Is { what, .. } => {
                let mut of = what.all(Slot::Of).filter_map(as_formula);
                of.any(|of| own.contains(&of.source.as_str()))
            }
            _ => false,
        };
        let others = self.declarations.iter().filter(by_own);
        let mut taken = BTreeSet::new();
        for other in others.chain([declaration]) {
            if let Statement::Is { subjects, .. } = &other.statement {
                taken.extend(formulas(subjects).map(|f| (other.text.as_str(), f.source.as_str())));
            }
        }
        for letter in &mut self.reading.letters.letters {
            if taken.contains(&(letter.sentence.as_str(), letter.latex.as_str())) {
                letter.meaning = Meaning::Change(None);
            }
        }
    }

    /// Whether a part of what has a change told is the same in all motions of the model: the author has more motions in mind.
    fn stays_as_it_is(&mut self, declaration: &Declaration) -> bool {
        let values = self.changed_values(declaration);
        let atoms = &mut self.reading.system.atoms;
        let mut entries = values.iter().flat_map(|value| &value.entries);
        entries.any(|entry| {
            let change = atoms.change(entry);
            change.is_some_and(|change| change.is_zero())
        })
    }

    /// The values of which a sentence tells the changes.
    fn changed_values(&mut self, declaration: &Declaration) -> Vec<Value> {
        let Statement::Is { what, .. } = &declaration.statement else {
            return vec![];
        };
        let of = what.all(Slot::Of).filter_map(as_formula);
        of.filter_map(|of| self.mentioned_value(of, declaration))
            .collect()
    }

    fn all_changed_values(&mut self) -> Vec<Value> {
        let changes = self.declarations.iter().filter(|d| says_changes(d));
        changes.flat_map(|d| self.changed_values(d)).collect()
    }

    /// Where sentences tell small disturbances of what moves, and changes of nothing that moves by itself, the changes of
    /// other quantities are what the disturbances make of them.
    pub(super) fn change_by_disturbances(&mut self) {
        let small = self.disturbances();
        if small.is_empty() {
            return;
        }
        let changes = self.declarations.iter().filter(|d| says_changes(d));
        let mut pairs = vec![];
        for declaration in changes {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            let of = what.all(Slot::Of).filter_map(as_formula);
            pairs.extend(formulas(subjects).zip(of).map(|(a, b)| (a, b, declaration)));
        }
        let disturbed = self.disturbed_variables();
        let mut told = vec![];
        for (letter, of, declaration) in pairs {
            let value = self.mentioned_value(of, declaration);
            let own = |value: &Value| {
                let mut variables = value.entries.iter().filter_map(Fraction::as_variable);
                variables.any(|v| disturbed.contains(&v))
            };
            let Some(value) = value.filter(|value| !own(value)) else {
                self.reading.sizes.changes.disturbances =
                    disturbed.into_iter().chain(small).collect();
                return;
            };
            told.push((letter, self.linear_part(&value, &small), declaration));
        }
        for (letter, part, declaration) in told {
            let Some(part) = part else {
                self.leave_change(declaration);
                continue;
            };
            self.take_back(declaration);
            let known = Meaning::Quantity(Quantity::Known(part));
            self.denote(letter, known, declaration);
        }
        self.reading.sizes.changes.told = false;
    }

    /// The variables of what sentences tell the disturbance of.
    fn disturbed_variables(&mut self) -> BTreeSet<Variable> {
        let mut variables = BTreeSet::new();
        for declaration in self.declarations {
            let Statement::Is { what, .. } = &declaration.statement else {
                continue;
            };
            if what.head == DISTURBANCE
                && let Some(of) = self.of_letter(what)
                && let Some(value) = self.mentioned_value(&of, declaration)
            {
                variables.extend(value.entries.iter().filter_map(Fraction::as_variable));
            }
        }
        variables
    }

    /// A value less what it is where nothing is disturbed, to first order; `None` where more is disturbed than has letters.
    fn linear_part(&mut self, value: &Value, small: &[Variable]) -> Option<Value> {
        let small = Small::new(small.to_vec(), 1);
        let mut facts = self.facts_so_far();
        let mut entries = vec![];
        for entry in &value.entries {
            let atoms = &mut self.reading.system.atoms;
            let normal = facts.normal(atoms, entry).ok()?;
            let (top, bottom) = (normal.numerator(), normal.denominator());
            let disturbed = |v: &Variable| small.speaks_of(atoms, *v);
            if bottom.variables().iter().any(disturbed) {
                return None;
            }
            let part = small.linear_part(atoms, top);
            let calm = small.truncated(atoms, top) - part.clone();
            let slopes: Vec<Variable> = part
                .variables()
                .into_iter()
                .filter(|v| !disturbed(v))
                .collect();
            let below = Fraction::from(bottom.clone());
            let still = slopes
                .into_iter()
                .map(Polynomial::variable)
                .chain([calm, bottom.clone()]);
            for still in still.map(Fraction::from).collect::<Vec<_>>() {
                self.is_calm(&still).then_some(())?;
            }
            entries.push(Fraction::from(part) / below);
        }
        let changes = entries.iter().any(|entry| !entry.is_zero());
        changes.then(|| value.with_entries(entries))
    }

    /// "`$F$` is the Jacobian of `$f$` in `$x$` with outputs in rows": what a line defines as f may stand below.
    pub(super) fn read_jacobian(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let ([Term::Formula(letter)], Some(Term::Formula(of))) = (subjects, what.slot(Slot::Of))
        else {
            return None;
        };
        let with = |head: &str| {
            let mut with = what.slots.iter();
            with.any(|(_, term)| matches!(term, Term::Phrase(phrase) if phrase.head == head))
        };
        let transposed = with(OUTPUTS_IN_COLUMNS);
        if transposed == with(OUTPUTS_IN_ROWS)
            || declaration.extent != Extent::Document
            || !is_letter(letter)
        {
            return None;
        }
        let (mut nodes, mut inputs, mut basis) = (vec![], 0, Basis::Written);
        for by in what.all(Slot::In).map(as_formula) {
            let by = by?;
            let value = self.mentioned_value(by, declaration)?;
            (inputs, basis) = (inputs + value.entries.len(), value.vector_basis());
            nodes.push(node_of(by)?.clone());
        }
        let told = self
            .mentioned_value(of, declaration)
            .filter(|value| !value.is_scalar());
        let outputs = told.as_ref().map_or(inputs, |value| value.entries.len());
        let both_on_axes =
            basis != Basis::Any && told.is_none_or(|told| told.vector_basis() == basis);
        let basis = [if both_on_axes { basis } else { Basis::Written }; 2];
        let (rows, columns) = if transposed {
            (inputs, outputs)
        } else {
            (outputs, inputs)
        };
        let shape = Shape {
            rows,
            columns,
            basis,
        };
        (inputs > 1 && outputs > 1).then_some(())?;
        let node = node_of(letter)?.clone();
        self.reading
            .shapes
            .insert(crate::notation::print::latex(&node), shape);
        self.reading.sizes.changes.jacobians.push(Jacobian {
            letter: node,
            of: node_of(of)?.clone(),
            by: nodes,
            transposed,
            sentence: declaration.sentence().to_owned(),
        });
        Some(())
    }
}

fn says_changes(declaration: &Declaration) -> bool {
    matches!(&declaration.statement, Statement::Is { what, .. } if what.head == FIRST_ORDER_CHANGE)
}

fn as_formula(term: &Term) -> Option<&Formula> {
    match term {
        Term::Formula(formula) => Some(formula),
        _ => None,
    }
}
