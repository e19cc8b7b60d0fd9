//! What ties letters and directions together: angles between, entries of a tensor, sizes, energies, heights.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node};
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::model::atoms::whole;
use crate::verify::model::system::{Frame, FrameId, Turn, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::{node_of, reach_of, told};
use crate::verify::term::indices::{LABELS, with_number};
use crate::verify::term::labels::letters_of;
use crate::verify::term::letters::{Meaning, loosely, spelled};
use crate::verify::term::quantity::Quantity;
use crate::verify::term::symbols::symbol_node;
use crate::verify::term::value::Value;
use num_traits::Zero;

/// The order of the entries of a symmetric tensor, where their letters do not say it.
const ENTRIES: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]];

impl Builder<'_> {
    /// "The angle between n and z is `\theta`": n·z = |n| |z| cos θ.
    pub(super) fn read_angle(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let ends: Vec<Term> = what.all(Slot::Between).cloned().collect();
        let [one, other] = ends.as_slice() else {
            return None;
        };
        if self.are_incline_and_level(&ends.iter().collect::<Vec<_>>()) && self.is_tilted() {
            return Some(());
        }
        let Some(Term::Formula(letter)) = subjects.first() else {
            return None;
        };
        if self.are_told_perpendicular(&ends) && self.quantity_of(letter, declaration).is_none() {
            return self.denote_right_angle(letter, declaration);
        }
        let angle = self.scalar(letter, declaration)?;
        if self.turns_by_line(one, other, &angle) {
            return Some(());
        }
        let one = self.vector(one, declaration)?;
        let other = self.vector(other, declaration)?;
        let (cosine, sine) = self.system().atoms.cosine_sine(&angle)?;
        // The angle between two vectors is one of a half turn.
        if sine
            .as_variable()
            .is_some_and(|v| !self.system().atoms.has_told_sign(v))
        {
            self.system().atoms.tell_sign(&sine, false);
        }
        let difference = self.beside_cosine(&one, &other, cosine.clone())?;
        self.hold_unless_told(difference, &[cosine, sine], declaration);
        Some(())
    }

    /// By how much the product of two vectors differs from what it is where their angle has a cosine.
    fn beside_cosine(
        &mut self,
        one: &Vector,
        other: &Vector,
        cosine: Fraction,
    ) -> Option<Fraction> {
        let lengths = one.dot(one) * other.dot(other);
        let length = self.system().atoms.root(&lengths)?;
        // No vector that makes an angle with another one is zero.
        self.system().atoms.set_positive(&length);
        Some(one.dot(other) - length * cosine)
    }

    /// "`$\theta$` is the angle from z to n", where n is turned by it: the turns tell no less.
    pub(super) fn is_angle_by_turns(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> bool {
        let follows = self.angle_of_turns(subjects, what, declaration);
        follows.is_some_and(|difference| difference.is_zero())
    }

    /// By how much the cosine of the angle of a turn differs from that of the angle that it is said to be.
    fn angle_of_turns(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Fraction> {
        let [Term::Formula(letter)] = subjects else {
            return None;
        };
        let (from, to) = (what.slot(Slot::From)?, what.slot(Slot::To)?);
        let angle = self.scalar(letter, declaration)?;
        let by_it = |frame: &Frame| match &frame.turn {
            Turn::Angle(_, by) | Turn::About(_, by) => **by == angle,
            _ => false,
        };
        if !self.reading.system.frames.iter().any(by_it) {
            return None;
        }
        let from = self.vector(from, declaration)?;
        let to = self.vector(to, declaration)?;
        let (cosine, _) = self.system().atoms.cosine_sine(&angle)?;
        self.beside_cosine(&from, &to, cosine)
    }

    /// The vector that a term names: a letter, an axis, a position.
    pub(super) fn vector(&mut self, term: &Term, declaration: &Declaration) -> Option<Vector> {
        if let Some(quantity) = self.operand(term, declaration)
            && let Ok(value) = self.system().value_of(&quantity)
            && let Ok(vector) = value.to_vector()
        {
            return Some(vector);
        }
        self.direction(term, declaration, None)
    }

    /// "n is perpendicular to j", "e is horizontal".
    pub(super) fn read_perpendicular(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let others: Vec<Term> = what.all(Slot::With).cloned().collect();
        let mut directions = vec![];
        for other in &others {
            directions.push(self.vector(other, declaration)?);
        }
        if what.head == "horizontal" {
            self.bearings.vertical?;
            directions.push(self.upward());
        }
        for subject in subjects {
            let vector = self.vector(subject, declaration)?;
            for direction in &directions {
                self.hold(vector.dot(direction), declaration);
            }
        }
        (!directions.is_empty()).then_some(())
    }

    /// "`I_{xx}`, …, `I_{yz}` are entries of `I`": by the labels of the letters, or in the customary order.
    pub(super) fn read_entries(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let of = what.slot(Slot::Of).cloned()?;
        if self.read_entries_of_untold_matrix(subjects, what, declaration) {
            return Some(());
        }
        let of = self.operand(&of, declaration)?;
        let on = what
            .slot(Slot::On)
            .and_then(|term| self.frame(term))
            .or(of.frame());
        let on = on.unwrap_or(self.reading.letters.component_frame);
        if self.is_vector(&of) {
            let mut components = what.clone();
            components.head = "component";
            self.read_components(subjects, &components, declaration);
            return Some(());
        }
        let numbered = told_entries(what);
        if let Quantity::Known(value) = &of
            && value.is_quaternion()
            && what.slot(Slot::Which).is_none()
        {
            self.read_entries_of_quaternion(subjects, value, declaration);
            return Some(());
        }
        let in_order = what.slot(Slot::Which).is_none();
        for (place, formula) in formulas(subjects).enumerate() {
            if self.read_all_entries(formula, &of, on, !in_order, declaration) {
                continue;
            }
            // By its numbers it is the entry itself; letters of a tensor follow the convention of signs.
            let told = numbered.get(place).copied();
            let [row, column] = told
                .or_else(|| labelled_entry(formula))
                .or(ENTRIES.get(place).copied().filter(|_| in_order))?;
            if let Quantity::Known(value) = &of
                && (value.rows, value.columns) != (3, 3)
            {
                let entry = Quantity::Known(known_entry(value, row, column)?);
                self.denote(formula, Meaning::Quantity(entry), declaration);
                continue;
            }
            let integral = told.is_none() && is_tensor(&of) && self.says_integrals(declaration);
            let quantity = Quantity::Entry {
                of: of.clone().boxed(),
                row,
                column,
                on,
                integral,
            };
            self.denote(formula, Meaning::Quantity(quantity), declaration);
        }
        Some(())
    }

    /// "`I_{jk}` are the entries of `I`", where j and k number axes: each by its numbers or by its axes.
    fn read_all_entries(
        &mut self,
        formula: &Formula,
        of: &Quantity,
        on: FrameId,
        counted: bool,
        declaration: &Declaration,
    ) -> bool {
        let integral = !counted && is_tensor(of) && self.says_integrals(declaration);
        let letters = self.letters_of_entries(formula);
        for (letter, [row, column]) in &letters {
            let quantity = Quantity::Entry {
                of: of.clone().boxed(),
                row: *row,
                column: *column,
                on,
                integral: integral && row != column,
            };
            self.denote(letter, Meaning::Quantity(quantity), declaration);
        }
        !letters.is_empty()
    }

    /// The letters of all entries, where a letter with two labels that number axes stands for them.
    pub(super) fn letters_of_entries(&self, formula: &Formula) -> Vec<(Formula, [usize; 2])> {
        let Some(Kind::Symbol(symbol)) = node_of(formula).map(|node| &node.kind) else {
            return vec![];
        };
        let letters = &self.reading.letters.indices;
        let number = |letter: &str| letters.iter().any(|rule| rule.letter == letter);
        let numbers = |label: &String| {
            let letters = letters_of(label, number);
            letters.len() == 2 && letters.iter().all(|letter| number(letter))
        };
        if !symbol.subscripts.last().is_some_and(numbers) {
            return vec![];
        }
        let each = LABELS
            .iter()
            .flat_map(|names| (0..9).map(move |n| (names, [n / 3, n % 3])));
        let letter = |(names, [row, column]): (&[&str; 3], [usize; 2])| {
            let labelled = with_number(symbol, &format!("{}{}", names[row], names[column]));
            (Formula::of(&symbol_node(&labelled)), [row, column])
        };
        each.map(letter).collect()
    }

    pub(super) fn read_same(&mut self, declaration: &Declaration) {
        let Statement::Same { subjects, others } = &declaration.statement else {
            return;
        };
        for (subject, other) in subjects.iter().zip(others) {
            if let (Some(one), Some(two)) = (self.point(subject), self.point(other)) {
                let way = self.system().position(one, two);
                self.hold_zero(&way, declaration);
                continue;
            }
            let (Term::Formula(subject), Term::Formula(other)) = (subject, other) else {
                continue;
            };
            // A letter that is told already is equal to the other there, or another thing if it is of another kind.
            if self.is_told(subject, declaration) {
                let left = self.formula_value(subject, declaration);
                let right = self.formula_value(other, declaration);
                let size = |value: &Value| (value.rows, value.columns);
                match (left, right) {
                    (Some(left), Some(right)) if size(&left) == size(&right) => {
                        self.hold_equal(&left, &right, declaration);
                        continue;
                    }
                    (Some(_), Some(_)) => {}
                    _ => {
                        self.say_unused(declaration);
                        continue;
                    }
                }
            }
            // One letter in two ways of writing that are read alike is told nothing.
            let other =
                node_of(other).filter(|o| node_of(subject).map(spelled) != Some(spelled(o)));
            if let Some(node) = other {
                self.denote(subject, Meaning::Same(Box::new(node.clone())), declaration);
            }
        }
    }

    pub(super) fn read_means(&mut self, declaration: &Declaration) {
        let Statement::Means { written, meaning } = &declaration.statement else {
            return;
        };
        if let (Some(written), Some(meaning)) = (node_of(written), node_of(meaning)) {
            let reach = reach_of(&declaration.extent);
            self.reading
                .letters
                .means
                .push((loosely_or_spelled(written), meaning.clone(), reach));
        }
    }

    /// A size of a body is a constant of its own.
    pub(super) fn read_size(&mut self, subjects: &[Term], declaration: &Declaration) {
        for formula in formulas(subjects) {
            self.denote_number(formula, declaration);
        }
    }

    /// A letter that is a number of its own and does not change.
    pub(super) fn denote_number(
        &mut self,
        letter: &Formula,
        declaration: &Declaration,
    ) -> Quantity {
        let number = Quantity::Scalar {
            text: letter.source.clone(),
            constant: true,
        };
        self.denote(letter, Meaning::Quantity(number.clone()), declaration);
        number
    }

    /// The height of a point above another.
    pub(super) fn height(&mut self, phrase: &NounPhrase) -> Option<Quantity> {
        let of = self.spot(phrase.slot(Slot::Of)?)?;
        let from = told(phrase.slot(Slot::With), 0, |t| self.point(t))?;
        let vertical = self.bearings.vertical?;
        let along = Quantity::Component {
            of: Quantity::Position { of, from }.boxed(),
            axis: vertical.axis,
            on: vertical.frame,
        };
        Some(match vertical.points_down {
            true => Quantity::Scaled(along.boxed(), whole(-1)),
            false => along,
        })
    }

    /// "`$n$` is the value of `$\omega_3$`": another letter for it.
    pub(super) fn read_value(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let ([Term::Formula(letter)], [(Slot::Of, Term::Formula(formula))]) =
            (subjects, what.slots.as_slice())
        else {
            return self.read_value_at_step(subjects, what, declaration);
        };
        let same = Meaning::Same(Box::new(node_of(formula)?.clone()));
        self.denote(letter, same, declaration);
        Some(())
    }
}

/// Row and column by the label of a letter: the xy of `I_{xy}`.
pub(super) fn labelled_entry(formula: &Formula) -> Option<[usize; 2]> {
    let Kind::Symbol(symbol) = &node_of(formula)?.kind else {
        return None;
    };
    let label = symbol.subscripts.last()?;
    let axis = |c: char| "xyz".find(c).or_else(|| "123".find(c));
    let axes: Option<Vec<usize>> = label.chars().filter(|c| *c != ',').map(axis).collect();
    match axes?.as_slice() {
        &[row, column] => Some([row, column]),
        _ => None,
    }
}

/// Whether the products of a tensor have a convention.
pub(super) fn is_tensor(quantity: &Quantity) -> bool {
    match quantity {
        Quantity::Inertia { .. } => true,
        Quantity::On(of, _) => is_tensor(of),
        _ => false,
    }
}

/// An entry of a matrix of any size, where it has one there.
fn known_entry(value: &Value, row: usize, column: usize) -> Option<Value> {
    let labelled = value.entries.get(row * value.columns + column);
    let entry = labelled.filter(|_| column < value.columns)?;
    Some(Value::scalar(entry.clone()))
}

/// Rows and columns that are told by their numbers.
pub(super) fn told_entries(what: &NounPhrase) -> Vec<[usize; 2]> {
    what.all(Slot::Which).filter_map(entry_numbers).collect()
}

/// The numbers of "entry (2, 3)", counted from 0.
fn entry_numbers(term: &Term) -> Option<[usize; 2]> {
    match term {
        Term::Numbers(numbers) => match numbers.as_slice() {
            &[row @ 1..=3, column @ 1..=3] => Some([row - 1, column - 1]),
            _ => None,
        },
        _ => None,
    }
}

fn loosely_or_spelled(node: &Node) -> String {
    let exact = spelled(node);
    if exact.is_empty() {
        loosely(node)
    } else {
        exact
    }
}
