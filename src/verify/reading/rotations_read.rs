//! Matrices of rotations by an angle about a vector, and functions that give them.

use crate::notation::ast::{Bracket, Function, Kind, Node};
use crate::verify::language::heads::COMPONENT_ROTATION;
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Term};
use crate::verify::model::frames::about_vector;
use crate::verify::model::system::{FrameId, unit};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::{CROSS_PRODUCT_MATRIX, letter_of, node_of, reach_of};
use crate::verify::reading::vectors_read::mark_on;
use crate::verify::term::letters::{Effect, MarkRule, Meaning, Operator, spelled};
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{Basis, Value};
use num_traits::One;

impl Builder<'_> {
    /// "`W(v)` is the cross-product matrix of `v`, for any vector `v`", "`R_x(a)` is the rotation matrix about x by `a`, for any
    /// angle `a`."
    pub(super) fn read_operator(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        let axes: Vec<&Term> = what.all(Slot::About).collect();
        let source = |slot| what.slot(slot).and_then(letter_of).map(|f| &f.source);
        if source(Slot::By).is_some_and(|by| Some(by) != source(Slot::ForAny))
            && !axes.is_empty()
            && !is_by_length(what)
        {
            return self.say_unused(declaration);
        }
        for (place, formula) in formulas(subjects).enumerate() {
            let Some(node) = node_of(formula) else {
                continue;
            };
            if let (CROSS_PRODUCT_MATRIX, Some(mark)) = (what.head, mark_on(node)) {
                self.reading.letters.marks.push(MarkRule {
                    mark,
                    effect: Effect::CrossProductMatrix,
                    reach: reach_of(&declaration.extent),
                });
                continue;
            }
            if what.head == CROSS_PRODUCT_MATRIX && is_in_square_brackets(node) {
                self.reading.letters.customs.crossing_brackets = true;
                continue;
            }
            let head = match &node.kind {
                // It is read so anyway.
                Kind::Function(..) | Kind::Skew(_) => continue,
                Kind::Call(head, _) => Some((**head).clone()),
                Kind::Product(factors) => factors.first().map(|f| f.node.clone()),
                _ => None,
            };
            let Some(head) = head else {
                return self.say_unused(declaration);
            };
            let about = axes.get(place).or(axes.last()).copied();
            let axis = about.and_then(|term| self.number_of_axis(term));
            let operator = match (what.head, axis) {
                (CROSS_PRODUCT_MATRIX, _) => Operator::CrossProductMatrix,
                (COMPONENT_ROTATION, Some(axis)) => Operator::AxisRotationOfComponents(axis),
                (_, Some(axis)) => Operator::AxisRotation(axis),
                (_, None) => match about.filter(|_| !is_by_length(what)) {
                    Some(vector) => match self.carried_unit_vector(vector, declaration) {
                        Some((vector, frame)) => Operator::RotationAbout(vector, frame),
                        None => return self.say_unused(declaration),
                    },
                    None => Operator::RotationVector,
                },
            };
            let head = Formula::of(&head);
            self.denote(&head, Meaning::Operator(operator), declaration);
        }
    }

    /// A unit vector by its letter, and the frame in which it is fixed.
    fn carried_unit_vector(
        &mut self,
        term: &Term,
        declaration: &Declaration,
    ) -> Option<(Quantity, FrameId)> {
        let Term::Formula(letter) = term else {
            return None;
        };
        let frame = self.said_fixed(letter)?;
        let told = self.quantity_of(letter, declaration);
        let vector = told.unwrap_or_else(|| self.unit_vector_of(letter, Some(frame)));
        Some((vector, frame))
    }

    /// "`$R$` is the matrix of the rotation by `$\\theta$` about `$n$`", a unit vector.
    pub(super) fn rotation_about(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let about = phrase.slot(Slot::About)?;
        let (n, basis) = match self.number_of_axis(about) {
            // The axis of a count has no frame: what the matrix is written on is not told.
            Some(number) if is_count(about) => (unit(number), Basis::Written),
            _ => {
                let axis = self.operand(about, declaration)?;
                let axis = self.system().value_of(&axis).ok()?;
                (axis.to_vector().ok()?, axis.vector_basis())
            }
        };
        let angle = self.scalar_term(phrase.slot(Slot::By)?, declaration)?;
        let (cosine, sine) = self.system().atoms.cosine_sine(&angle)?;
        let one = self.system().atoms.with_squares(&n.dot(&n));
        if !one.is_one() {
            return None;
        }
        let matrix = about_vector(&n, &cosine, &sine);
        Some(Quantity::Known(Value::matrix(&matrix, [basis; 2])))
    }

    /// "`$v$` turned about `$u$` by the angle `$a$`".
    pub(super) fn turned_vector(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let Quantity::Known(matrix) = self.rotation_about(phrase, declaration)? else {
            return None;
        };
        let of = self.operand(phrase.slot(Slot::Of)?, declaration)?;
        let vector = self.system().value_of(&of).ok()?;
        let told = vector.is_vector() && vector.basis[0] != Basis::Written;
        let told = told && matrix.basis[0] != Basis::Written;
        let turned = matrix.to_matrix().ok()? * vector.to_vector().ok()?;
        told.then(|| Quantity::Known(Value::vector(&turned, vector.basis[0])))
    }
}

/// "The third axis": one of which no frame is told.
fn is_count(axis: &Term) -> bool {
    let counted =
        |(slot, term): &(Slot, Term)| *slot == Slot::Which && matches!(term, Term::Numbers(_));
    matches!(axis, Term::Phrase(axis) if axis.slots.iter().all(counted))
}

/// "`$Q(v)$` is the matrix of the rotation by `$|v|$` about `$v$`": a function of the vector, for any.
pub(super) fn turns_by_argument(subjects: &[Term], what: &NounPhrase) -> bool {
    let about = what.slot(Slot::About).and_then(letter_of).and_then(node_of);
    let about = about.map(spelled);
    let of_it = |formula: &Formula| {
        let last = node_of(formula).and_then(|node| match &node.kind {
            Kind::Call(_, arguments) => arguments.last(),
            Kind::Product(factors) if factors.len() == 2 => factors.last().map(|f| &f.node),
            _ => None,
        });
        last.is_some() && last.map(spelled) == about
    };
    is_by_length(what) && formulas(subjects).all(of_it)
}

/// "by `$|v|$` about `$v$`, for any vector `$v$`", "by the length of `$v$`"
fn is_by_length(what: &NounPhrase) -> bool {
    let letter = |slot| what.slot(slot).and_then(letter_of).and_then(node_of);
    let by = match what.slot(Slot::By) {
        Some(Term::Phrase(by)) if ["length", "magnitude"].contains(&by.head) => {
            by.slot(Slot::Of).and_then(letter_of).and_then(node_of)
        }
        Some(by) => match letter_of(by).and_then(node_of).map(|node| &node.kind) {
            Some(Kind::Norm(inner) | Kind::Function(Function::Abs, inner)) => Some(&**inner),
            _ => None,
        },
        None => None,
    };
    let about = letter(Slot::About).map(spelled);
    let any = letter(Slot::ForAny).map(spelled);
    about.is_some() && by.map(spelled) == about && (any.is_none() || any == about)
}

/// `[a]`
fn is_in_square_brackets(node: &Node) -> bool {
    let letter = |inner: &Node| matches!(inner.kind, Kind::Symbol(_));
    match &node.kind {
        Kind::Group(Bracket::Square, inner) => letter(inner),
        Kind::Matrix(rows) => {
            matches!(rows.as_slice(), [row] if matches!(row.as_slice(), [only] if letter(only)))
        }
        _ => false,
    }
}
