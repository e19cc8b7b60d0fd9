//! Functions, and sums over an index.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::notation::ast::{Function, Kind, Node, Symbol};
use crate::verify::model::frames::{about_axis, about_vector};
use crate::verify::model::system::{FrameId, Matrix};
use crate::verify::term::letters::Effect;
use crate::verify::term::lower::Lowering;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{Basis, OTHER_ARGUMENT, Value, Valued, beyond};
use num_traits::{One, ToPrimitive, Zero};
use std::ops::Range;

/// So long is what stands before the exponent of `e^{x}`; `\\exp` is longer.
const LONGEST_BASE: u32 = 3;

impl Lowering<'_> {
    /// The letter e of `e^2` where a sentence tells what it is: no base of the natural logarithm.
    pub(super) fn told_base(&mut self, node: &Node) -> Option<Node> {
        let Kind::Function(Function::Exp, exponent) = &node.kind else {
            return None;
        };
        let e = Symbol {
            name: "e".into(),
            ..Symbol::default()
        };
        let base = Node {
            kind: Kind::Symbol(e),
            span: node.span,
        };
        let before = exponent.span.start.checked_sub(node.span.start)?;
        if before > LONGEST_BASE {
            return None;
        }
        let (unknown, met) = (self.unknown.clone(), self.occurrences.clone());
        let value = self.value(&base);
        (self.unknown, self.occurrences) = (unknown, met);
        let atoms = &self.system.atoms;
        let told = |f: &Fraction| f.variables().iter().all(|v| !atoms.is_unknown(*v));
        let told = value.is_ok_and(|value| value.is_scalar() && value.entries.iter().all(told));
        told.then_some(base)
    }

    pub(super) fn function(&mut self, function: Function, inner: &Node) -> Valued {
        if function == Function::Skew {
            let value = self.value(inner)?;
            return self.affected(value, &Effect::CrossProductMatrix);
        }
        let value = self.value(inner)?;
        match function {
            Function::Det => Ok(Value::scalar(mechanics::determinant(&value.to_matrix()?))),
            Function::Vee => value.vector_of_cross_product_matrix(),
            Function::Trace => {
                let custom = self.custom();
                self.system.trace(&value, custom)
            }
            Function::Sqrt => {
                let inside = value.to_scalar()?;
                self.system.root(&inside)
            }
            Function::Diag => {
                let d = value.to_vector()?;
                let entry = |at: usize| {
                    if at / 3 == at % 3 {
                        d[at / 3].clone()
                    } else {
                        Fraction::zero()
                    }
                };
                Ok(Value::written(3, 3, (0..9).map(entry).collect()))
            }
            Function::Exp | Function::Ln if !value.is_scalar() => beyond(OTHER_ARGUMENT),
            _ => self.trigonometric(function, &value.to_scalar()?),
        }
    }

    pub(super) fn trigonometric(&mut self, function: Function, angle: &Fraction) -> Valued {
        let Some((cosine, sine)) = self.system.atoms.cosine_sine(angle) else {
            return beyond(OTHER_ARGUMENT);
        };
        let one = Fraction::one();
        let value = match function {
            Function::Sin => sine,
            Function::Cos => cosine,
            Function::Tan => sine / cosine,
            Function::Cot => cosine / sine,
            Function::Sec => one / cosine,
            Function::Csc => one / sine,
            _ => return beyond(OTHER_ARGUMENT),
        };
        Ok(Value::scalar(value))
    }

    /// The matrix of the rotation by an angle about an axis.
    pub(super) fn axis_rotation(&mut self, axis: usize, angle: &Fraction) -> Valued {
        let Some((cosine, sine)) = self.system.atoms.cosine_sine(angle) else {
            return beyond(OTHER_ARGUMENT);
        };
        Ok(Value::matrix(
            &about_axis(axis, &cosine, &sine),
            [Basis::Written; 2],
        ))
    }

    /// The matrix of the rotation by an angle about a unit vector, by its components on the frame that carries it.
    pub(super) fn rotation_about(
        &mut self,
        axis: &Quantity,
        frame: FrameId,
        angle: &Fraction,
    ) -> Valued {
        let axis = self.system.value_of(axis)?;
        let n = self.system.written_out(&axis, frame)?.to_vector()?;
        let Some((cosine, sine)) = self.system.atoms.cosine_sine(angle) else {
            return beyond(OTHER_ARGUMENT);
        };
        let matrix = about_vector(&n, &cosine, &sine);
        Ok(Value::matrix(&matrix, [Basis::Written; 2]))
    }

    /// The matrix of the rotation by the length θ of a vector v about v/θ, which is the same for both roots θ of v·v.
    pub(super) fn rotation_by_length(&mut self, value: &Value) -> Valued {
        let v = value.to_vector()?;
        let atoms = &mut self.system.atoms;
        let square = atoms.with_squares(&v.dot(&v));
        if square.is_zero() {
            return Ok(Value::matrix(&Matrix::identity(), [Basis::Written; 2]));
        }
        let Some(length) = atoms.root_of_either_sign(&square) else {
            return beyond(OTHER_ARGUMENT);
        };
        let Some((cosine, sine)) = atoms.cosine_sine(&length) else {
            return beyond(OTHER_ARGUMENT);
        };
        let n = v.map(|component| component / length.clone());
        let matrix = about_vector(&n, &cosine, &sine);
        Ok(Value::matrix(&matrix, [Basis::Written; 2]))
    }

    pub(super) fn indexed_sum(&mut self, sum: &Node) -> Valued {
        let Kind::IndexedSum {
            index,
            limits,
            body,
        } = &sum.kind
        else {
            return self.value(sum);
        };
        let rule = self.letters.index(&index.name, self.at);
        let of_axes = rule.is_some_and(|rule| rule.axes_of.is_some());
        let of_axes = of_axes || self.system.family_of(&index.name).is_none();
        let members = rule.and_then(|rule| rule.members);
        let between = match members.filter(|_| limits.as_ref().is_none_or(is_over_all)) {
            Some(count) => Some((1, count)),
            None => limits.as_ref().map_or(Some((1, 3)), axes_between),
        };
        if let Some((first, last)) = between.filter(|_| of_axes) {
            return self.sum_of_axes(&index.name, first - 1..last, body);
        }
        if of_axes || !limits.as_ref().is_none_or(is_over_all) {
            return beyond("a sum over some of its members");
        }
        let term = self.value(body)?;
        self.summed(&term, &index.name)
    }

    pub(super) fn sum_over_axes(&mut self, letter: &str, body: &Node) -> Valued {
        self.sum_of_axes(letter, 0..3, body)
    }

    fn sum_of_axes(&mut self, letter: &str, axes: Range<usize>, body: &Node) -> Valued {
        let before = self.axes.get(letter).copied();
        let mut sum = Value::scalar(Fraction::zero());
        for axis in axes {
            self.axes.insert(letter.to_owned(), axis);
            let term = self.value(body)?;
            let custom = self.custom();
            sum = self.system.plus(&sum, &term, custom)?;
        }
        match before {
            Some(axis) => self.axes.insert(letter.to_owned(), axis),
            None => self.axes.remove(letter),
        };
        Ok(sum)
    }

    pub(super) fn summed(&mut self, term: &Value, index: &str) -> Valued {
        let sums = term
            .entries
            .iter()
            .map(|entry| self.system.sum(entry, index));
        match sums.collect::<Option<Vec<_>>>() {
            Some(entries) => Ok(Value {
                entries,
                ..term.clone()
            }),
            None => beyond("a sum with its index below a line"),
        }
    }
}

/// A whole number as it stands in a formula.
fn number_of(node: &Node) -> Option<i64> {
    match &node.kind {
        Kind::Number(number) if number.value.is_integer() => number.value.to_integer().to_i64(),
        Kind::Group(_, inner) => number_of(inner),
        _ => None,
    }
}

/// The first and the last axis of a sum, where both are numbers of axes.
fn axes_between((lower, upper): &(Box<Node>, Box<Node>)) -> Option<(usize, usize)> {
    let axis = |node| number_of(node).and_then(|number| usize::try_from(number).ok());
    let (first, last) = (axis(lower)?, axis(upper)?);
    (1 <= first && first <= last && last <= 3).then_some((first, last))
}

/// Whether a sum over the members of a family begins with the first and ends with the last: at a letter for their number.
fn is_over_all((lower, upper): &(Box<Node>, Box<Node>)) -> bool {
    number_of(lower).is_some_and(|first| first <= 1) && matches!(upper.kind, Kind::Symbol(_))
}

/// The sum reaches over what its last factor is multiplied by.
pub(super) fn sum_of_calls(head: &Node, arguments: &[Node]) -> Option<Node> {
    let Kind::IndexedSum {
        index,
        limits,
        body,
    } = &head.kind
    else {
        return None;
    };
    let body = Node {
        span: body.span,
        kind: Kind::Call(body.clone(), arguments.to_vec()),
    };
    let kind = Kind::IndexedSum {
        index: index.clone(),
        limits: limits.clone(),
        body: Box::new(body),
    };
    Some(Node {
        span: head.span,
        kind,
    })
}
