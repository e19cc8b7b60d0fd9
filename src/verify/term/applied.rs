//! Letters before brackets that are applied to what stands in them, and not multiplied by it.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Bracket, Kind, Node, Operator as Sign, Symbol};
use crate::notation::print;
use crate::verify::model::system::{Matrix, System};
use crate::verify::term::functions::sum_of_calls;
use crate::verify::term::letters::{Effect, Meaning, Operator, loosely, spell, spelled};
use crate::verify::term::lower::Lowering;
use crate::verify::term::symbols::symbol_node;
use crate::verify::term::value::{AT_INSTANT, Basis, Trouble, Value, Valued, beyond};
use std::collections::BTreeSet;

impl Lowering<'_> {
    /// A letter before brackets: a function that the document defines, a function of time, or a product.
    pub(super) fn call(&mut self, head: &Node, arguments: &[Node]) -> Valued {
        let operator = self
            .letters
            .find(&spelled(head), &loosely(head), self.at, 0)
            .map(|l| l.meaning.clone());
        if let (Some(Meaning::Operator(operator)), [argument]) = (operator, arguments) {
            let value = self.value(argument)?;
            // An operator on vectors beside the time is another letter, `S(t)` beside `S(v)`.
            let of_vectors = matches!(
                operator,
                Operator::CrossProductMatrix | Operator::RotationVector | Operator::ComponentsOn(_)
            );
            if of_vectors
                && is_time(argument)
                && let Kind::Symbol(symbol) = &head.kind
            {
                return self.unknown_by(symbol, text_of_function(symbol, arguments));
            }
            return self.applied(operator, value);
        }
        let product = self.times_bracketed(head, arguments);
        if let Some(value) = product.or_else(|| self.change_of_brackets(head, arguments)) {
            return value;
        }
        if let Some(sum) = sum_of_calls(head, arguments) {
            return self.value(&sum);
        }
        if let [argument] = arguments
            && is_time(argument)
        {
            return self.value(head);
        }
        if self.is_density_at(head, arguments) {
            return self.value(head);
        }
        if let Some(value) = self.function_at_same(head, arguments)? {
            return Ok(value);
        }
        if let Some(value) = self.function_of_letters(head, arguments)? {
            return Ok(value);
        }
        let left = self.value(head)?;
        let [argument] = arguments else {
            // No vector is multiplied by a list: these are what it depends on.
            return match left.is_vector() || self.turned_by(head, arguments).is_some() {
                true => Ok(left),
                false => beyond("a function of several arguments"),
            };
        };
        let right = self.value(argument)?;
        if is_function_of(&left, &right, self.system) {
            return Ok(left);
        }
        // `\omega(0)` is no product.
        if right.is_zero() && !left.is_zero() && self.changes(&left) {
            return beyond(AT_INSTANT);
        }
        let custom = self.custom();
        self.joined(&left, Sign::Juxtaposed, &right, custom)
    }

    /// What an operator of the document makes of a value.
    fn applied(&mut self, operator: Operator, value: Value) -> Valued {
        match operator {
            Operator::CrossProductMatrix => self.affected(value, &Effect::CrossProductMatrix),
            Operator::RotationVector => self.rotation_by_length(&value),
            Operator::RotationAbout(axis, frame) => {
                self.rotation_about(&axis, frame, &value.to_scalar()?)
            }
            Operator::ComponentsOn(frame) => self.affected(value, &Effect::ComponentsOn(frame)),
            Operator::AxisRotation(axis) => self.axis_rotation(axis, &value.to_scalar()?),
            Operator::AxisRotationOfComponents(axis) => {
                self.axis_rotation(axis, &-value.to_scalar()?)
            }
        }
    }

    /// A letter of which nothing is told behind which letters stand in brackets is a function of them, `H(\eta)`: a letter of
    /// its own for each of its arguments.
    fn function_of_letters(
        &mut self,
        head: &Node,
        arguments: &[Node],
    ) -> Result<Option<Value>, Trouble> {
        let Kind::Symbol(symbol) = &head.kind else {
            return Ok(None);
        };
        let letter = |node: &Node| matches!(node.kind, Kind::Symbol(_));
        if !arguments.iter().all(letter) {
            return Ok(None);
        }
        let told = self
            .letters
            .find(&spelled(head), &loosely(head), self.at, 0);
        // "`$T$` is the same as `$T(\phi)$`": the letter alone is short for the function.
        let short = told.is_some_and(|told| match &told.meaning {
            Meaning::Same(node) => {
                matches!(&node.kind, Kind::Call(own, _) if spelled(own) == spelled(head))
            }
            _ => false,
        });
        if !short && self.known(symbol)?.is_some() {
            return Ok(None);
        }
        self.unknown_by(symbol, text_of_function(symbol, arguments))
            .map(Some)
    }

    /// `R(\alpha)`, `R^T(\alpha(t))`, `R(\phi, \theta, \psi)` of a matrix that turns by these angles.
    pub(super) fn matrix_of_angle(&mut self, run: &[&Node]) -> Option<Value> {
        let [matrix, argument, ..] = run else {
            return None;
        };
        let letter = |node: &Node| matches!(node.kind, Kind::Symbol(_));
        let head = match &matrix.kind {
            Kind::Power(base, _) | Kind::Transpose(base) => letter(base),
            _ => letter(matrix),
        };
        let angles = match &argument.kind {
            Kind::Group(Bracket::Round, inner) => std::slice::from_ref(&**inner),
            Kind::Tuple(list) => list.as_slice(),
            _ => return None,
        };
        let alone = |angle: &Node| match &angle.kind {
            Kind::Call(angle, of) => letter(angle) && of.iter().all(is_time),
            _ => letter(angle),
        };
        if !head || !angles.iter().all(alone) {
            return None;
        }
        // Where it is none, the letters are met once more.
        let before = self.occurrences.clone();
        let turned = self.turned_by(matrix, angles);
        if turned.is_none() {
            self.occurrences = before;
        }
        turned
    }

    /// A matrix that each of some angles turns.
    fn turned_by(&mut self, matrix: &Node, angles: &[Node]) -> Option<Value> {
        let matrix = self.value(matrix).ok()?;
        let mut each = angles.iter();
        let all = each.all(|angle| {
            let angle = self.value(angle);
            angle.is_ok_and(|angle| is_function_of(&matrix, &angle, self.system))
        });
        all.then_some(matrix)
    }

    /// Whether a sentence says that a letter acts on what stands in brackets behind it.
    fn is_operator(&self, letter: &Node) -> bool {
        let told = self
            .letters
            .find(&spelled(letter), &loosely(letter), self.at, 0);
        told.is_some_and(|letter| matches!(letter.meaning, Meaning::Operator(_)))
    }

    /// The transpose of a formula; of `r(r)^T` with two vectors only that of the second.
    pub(super) fn transpose(&mut self, inner: &Node) -> Valued {
        if let Kind::Call(head, arguments) = &inner.kind
            && let ([argument], Kind::Symbol(_)) = (arguments.as_slice(), &head.kind)
            && !self.is_function(head)
            && !self.is_operator(head)
        {
            let (left, right) = (self.value(head), self.value(argument));
            if let (Ok(left), Ok(right)) = (left, right)
                && left.is_vector()
                && right.is_vector()
            {
                let custom = self.custom();
                return self.system.times(&left, &right.transposed(), custom);
            }
        }
        let value = self.value(inner)?;
        // A list is a column already.
        Ok(match is_list(inner) && value.is_vector() {
            true => value,
            false => value.transposed(),
        })
    }

    /// Whether sentences tell of a letter that has a label at the upper right without it.
    fn is_told_without_label(&self, letter: &Node) -> bool {
        let Kind::Symbol(symbol) = &letter.kind else {
            return false;
        };
        let mut bare = symbol.clone();
        let (exact, loose) = match bare.superscripts.pop() {
            Some(_) => (spell(&bare, true), spell(&bare, false)),
            None => return false,
        };
        self.letters.find(&exact, &loose, self.at, 0).is_some()
    }

    /// `R(a)^T`, `W(v)^2`: what the operator or the function gives is raised, and not what it acts on.
    pub(super) fn raised_call(&self, run: &[&Node]) -> Option<Node> {
        let [letter, raised, ..] = run else {
            return None;
        };
        if !matches!(raised.kind, Kind::Transpose(_) | Kind::Power(..)) {
            return None;
        }
        let known = self
            .letters
            .find(&spelled(letter), &loosely(letter), self.at, 0);
        let applied = match known {
            Some(known) => matches!(known.meaning, Meaning::Operator(_)),
            // `r^b`, where the label only says on which axes, is no more of a function than r is.
            None => self.is_function(letter) && !self.is_told_without_label(letter),
        };
        if !applied {
            return None;
        }
        let call = |argument: &Node| match &argument.kind {
            Kind::Group(_, inner) => Some(Box::new(Node {
                span: raised.span,
                kind: Kind::Call(Box::new((*letter).clone()), vec![(**inner).clone()]),
            })),
            _ => None,
        };
        let kind = match &raised.kind {
            Kind::Transpose(argument) => Kind::Transpose(call(argument)?),
            Kind::Power(argument, exponent) => Kind::Power(call(argument)?, exponent.clone()),
            _ => return None,
        };
        Some(Node {
            span: raised.span,
            kind,
        })
    }
}

/// Whether a value is told by the letters that stand in brackets behind it, `R(\alpha)` where R turns by α, or by the entries
/// of a column of angles, `R(\eta)`.
pub(super) fn is_function_of(value: &Value, argument: &Value, system: &mut System) -> bool {
    let letters = argument.entries.iter().map(Fraction::as_variable);
    let Some(letters) = letters.collect::<Option<Vec<Variable>>>() else {
        return false;
    };
    if (value.rows, value.columns) != (3, 3) {
        return false;
    }
    // What only takes components to other axes turns as these do.
    let turned = match value.basis {
        [Basis::On(to), Basis::On(from)] => system.rotation(to, from),
        _ => Matrix::zeros(),
    };
    let entries = value.entries.iter().chain(turned.iter());
    let functions = entries.flat_map(Fraction::variables);
    let angles = functions.filter_map(|v| system.atoms.angle_of(v));
    let told_by: BTreeSet<Variable> = angles.flat_map(|angle| angle.variables()).collect();
    let all = letters.len() == 1 || told_by.iter().all(|angle| letters.contains(angle));
    all && letters.iter().any(|letter| told_by.contains(letter))
}

pub(super) fn is_time(argument: &Node) -> bool {
    matches!(&argument.kind, Kind::Symbol(Symbol { name, .. }) if name == "t")
}

/// The letter of a function for its arguments.
pub(crate) fn text_of_function(symbol: &Symbol, arguments: &[Node]) -> String {
    let arguments: Vec<String> = arguments.iter().map(print::latex).collect();
    let head = print::latex(&symbol_node(symbol));
    format!("{head}({})", arguments.join(", "))
}

/// Whether a formula is a list of numbers in brackets.
fn is_list(node: &Node) -> bool {
    match &node.kind {
        Kind::Group(_, inner) => is_list(inner),
        Kind::Tuple(_) => true,
        _ => false,
    }
}
