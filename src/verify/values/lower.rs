//! From a tree to its value: a grid of fractions in the document's variables.

use crate::algebra::{Fraction, Polynomial, Rational, Variable};
use crate::notation::ast::{FrameLabel, Kind, Node};
use crate::source::Span;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{axes, axis, inner};
use crate::verify::reason;
use crate::verify::theory::Theory;
use crate::verify::theory::law::tensor;
use crate::verify::values::atoms::{Atom, variable_fraction};
use crate::verify::values::call::place_of_slope;
use crate::verify::values::figures::Figures;
use crate::verify::values::quantity::Shape;
use crate::verify::values::spatial::in_space;
use crate::verify::values::symbol::{Meaning, meaning};
use crate::verify::values::value::{ShapeMismatch, Value};
use num_traits::Zero;
use std::collections::HashMap;

/// Why a formula has no value.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Trouble {
    /// What is the matter.
    pub kind: TroubleKind,
    /// One clause that says it.
    pub message: String,
    /// Where.
    pub span: Span,
}

/// The kinds of trouble.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TroubleKind {
    /// The shapes do not fit.
    IllTyped,
    /// The reader did not understand it.
    Unreadable,
    /// It is understood and nothing is known of it yet.
    Unsupported,
}

/// A definition of a function: its parameter's components and its value.
#[derive(Clone, Debug)]
pub(crate) struct FunctionOf {
    /// The variables of the parameter.
    pub parameter: Vec<u32>,
    /// The value in them.
    pub value: Value,
}

/// What a formula is lowered with.
pub(crate) struct Lowering<'a> {
    /// Laws, premises and variables.
    pub theory: &'a mut Theory,
    /// Letters.
    pub reading: &'a Reading,
    /// The frame that a derivative of a vector without a label is taken in.
    pub unlabelled: Frame,
    /// Whether a vector without label was differentiated.
    pub met_unlabelled: bool,
    /// Whether every vector of the line stands on space axes.
    pub in_space: bool,
    /// Functions that the document defines.
    pub functions: &'a HashMap<String, FunctionOf>,
    /// Numbers of the document.
    pub figures: &'a Figures,
}

pub(crate) type Lowered = Result<Value, Trouble>;

pub(crate) fn trouble(kind: TroubleKind, span: Span, message: impl Into<String>) -> Trouble {
    Trouble {
        kind,
        message: message.into(),
        span,
    }
}

/// Rows of a unit matrix at most.
const LARGEST_UNIT: usize = 12;

impl Lowering<'_> {
    /// The value of a node.
    pub(crate) fn value(&mut self, node: &Node) -> Lowered {
        let ill = |ShapeMismatch(message)| trouble(TroubleKind::IllTyped, node.span, message);
        match &node.kind {
            Kind::Number(number) => Ok(Value::scalar(self.number(number))),
            Kind::WithUnit(inside, unit) => self.with_unit(inside, unit),
            Kind::Bold(number) if number.value.is_zero() => Ok(Value::scalar(Fraction::zero())),
            Kind::Bold(_) => Ok(Value::identity(3)),
            Kind::Symbol(symbol) => {
                let mut meaning = meaning(symbol, self.reading, &mut self.theory.atoms);
                if self.in_space {
                    meaning = in_space(meaning, &mut self.theory.atoms);
                }
                self.is_taken_somewhere(symbol, node.span)?;
                let value = self.meaning_value(meaning, 0);
                if self.reading.marks_skew(symbol) {
                    return value.skew().map_err(ill);
                }
                Ok(value)
            }
            Kind::Negate(a) => Ok(self.value(a)?.negated()),
            Kind::Group(_, a) => self.value(a),
            Kind::InFrame(a, label)
                if matches!(&a.kind, Kind::Bold(_)) && size(label).is_some() =>
            {
                Ok(Value::identity(size(label).unwrap_or(3)))
            }
            // `[r × v]_x` is a component.
            Kind::InFrame(a, label) => {
                if let Some(at) = place_of_slope(a, label) {
                    return self.call(node, inner(a), &[at]);
                }
                let value = self.value(a)?;
                if (value.rows, value.columns) == (3, 3) {
                    return self.entry(&value, label);
                }
                Ok(match axis(&label.text) {
                    Some(index) if value.is_vector() => {
                        Value::scalar(value.entries[usize::from(index)].clone())
                    }
                    _ => value,
                })
            }
            Kind::Sum(terms) => {
                let values = terms.iter().map(|term| self.value(&term.node));
                let values = values.collect::<Result<Vec<Value>, Trouble>>()?;
                let matrix = values.iter().find(|value| value.rows > 1).cloned();
                let mut sum = Value::scalar(Fraction::zero());
                for (term, value) in terms.iter().zip(values) {
                    // The 1 of `1 + hA` is the unit matrix.
                    let unit = matrix.as_ref().and_then(|m| value.unit_of_size(m));
                    let value = unit.unwrap_or(value);
                    let (left, value) = self.aligned(sum, value);
                    sum = left
                        .joined(value, term.negative)
                        .map_err(|ShapeMismatch(m)| {
                            trouble(
                                TroubleKind::IllTyped,
                                term.node.span,
                                format!("cannot add {m}"),
                            )
                        })?;
                }
                Ok(sum)
            }
            Kind::Product(factors) => self.product(node, factors),
            Kind::Quotient(a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                if !b.is_scalar() || b.is_zero() {
                    return Err(ill(ShapeMismatch(format!(
                        "cannot divide by {}",
                        if b.is_scalar() {
                            "zero"
                        } else {
                            "a vector or matrix"
                        }
                    ))));
                }
                Ok(a.map(|entry| entry.clone() / b.entries[0].clone()))
            }
            Kind::Power(base, exponent) => self.power(node, base, exponent),
            // `[a\;b]^T` is a column, as the list alone is.
            Kind::Transpose(a) if is_other_list(a) => self.value(a),
            Kind::Transpose(a) => Ok(self.value(a)?.transposed()),
            Kind::Skew(a) => self.value(a)?.skew().map_err(ill),
            Kind::Norm(a) => self.norm(a),
            Kind::Tuple(entries) => self.tuple(node, entries),
            Kind::Matrix(rows) => self.grid(node, rows),
            Kind::Determinant(rows) => self.determinant(node, rows),
            Kind::TimeDerivative {
                operand,
                order,
                frame,
                ..
            } => self.time_derivative(operand, *order, frame.as_ref()),
            Kind::Derivative {
                operand, variables, ..
            } => self.derivative(node, operand, variables),
            Kind::Function(function, argument) => self.function(node, *function, argument),
            Kind::Call(head, arguments) => self.call(node, head, arguments),
            Kind::Error(message) => {
                Err(trouble(TroubleKind::Unreadable, node.span, message.clone()))
            }
            Kind::Ellipsis => Err(trouble(
                TroubleKind::Unsupported,
                node.span,
                "something is left out here",
            )),
            Kind::PlusMinus(_) => Err(trouble(
                TroubleKind::Unsupported,
                node.span,
                "± has no single value",
            )),
            Kind::Integral {
                integrand,
                variable,
                limits: None,
            } => self.integral(node, integrand, variable),
            Kind::Integral {
                integrand,
                variable,
                limits: Some((from, to)),
            } if matches!(&variable.kind, Kind::Symbol(_)) => {
                self.between(node, integrand, variable, (&**from, &**to))
            }
            Kind::Integral { .. } => Err(trouble(
                TroubleKind::Unsupported,
                node.span,
                reason::INTEGRAL,
            )),
            Kind::IndexedSum {
                index,
                limits: None,
                body,
            } => self.over_particles(node, index, body),
            Kind::IndexedSum { .. } => Err(trouble(
                TroubleKind::Unsupported,
                node.span,
                "a sum over an index is not expanded",
            )),
        }
    }

    /// The value of a node that is a number.
    pub(crate) fn scalar(&mut self, node: &Node) -> Option<Fraction> {
        self.value(node).ok()?.as_scalar().cloned()
    }

    /// `[I\,]_{xy}`, or the whole matrix where the label is that of a frame.
    fn entry(&self, matrix: &Value, label: &FrameLabel) -> Lowered {
        if let Some((row, column)) = axes(&label.text) {
            let entry = matrix.at(row.into(), column.into());
            return Ok(Value::scalar(entry.clone()));
        }
        match self.reading.frames.of_label(label) {
            Some(_) => Ok(matrix.clone()),
            None => Err(trouble(
                TroubleKind::Unsupported,
                label.span,
                format!("the entry `{}` of a matrix is not known", label.text),
            )),
        }
    }

    /// The value of what a symbol stands for, differentiated `order` times in the axes used.
    pub(crate) fn meaning_value(&mut self, meaning: Meaning, order: u8) -> Value {
        match meaning {
            Meaning::UnitVector(_) | Meaning::Identity | Meaning::Pi if order > 0 => {
                Value::from_fn(3, 1, |_, _| Fraction::zero())
            }
            Meaning::ImaginaryUnit if order > 0 => Value::scalar(Fraction::zero()),
            Meaning::ImaginaryUnit => Value::scalar(self.imaginary_unit()),
            Meaning::Quaternion(entity, part) => self.quaternion_part(entity, part),
            Meaning::UnitVector(component) => Value::axis(component.into()),
            Meaning::Identity => Value::identity(3),
            Meaning::Pi => {
                Value::scalar(variable_fraction(self.theory.atoms.special(Atom::Opaque {
                    latex: "\\pi".to_owned(),
                })))
            }
            Meaning::Component(entity, component) => {
                Value::scalar(self.theory.atoms.value(entity, component, order))
            }
            Meaning::Whole(entity) => {
                let shape = self.theory.atoms.info(entity).shape;
                let atoms = &mut self.theory.atoms;
                match shape {
                    Shape::Scalar => Value::scalar(atoms.value(entity, 0, order)),
                    Shape::Vector => Value::column(atoms.vector(entity, order)),
                    Shape::Symmetric => {
                        let tensor = tensor(atoms, entity, self.theory.setting.products);
                        let size = if self.reading.tensors_are_plane() {
                            2
                        } else {
                            3
                        };
                        Value::from_fn(size, size, |r, c| tensor[(r, c)].clone())
                    }
                    Shape::Matrix => {
                        Value::from_fn(3, 3, |r, c| atoms.value(entity, (3 * r + c) as u8, order))
                    }
                    Shape::Grid(rows, columns) => {
                        let (rows, columns) = (usize::from(rows), usize::from(columns));
                        Value::from_fn(rows, columns, |r, c| {
                            atoms.value(entity, (columns * r + c) as u8, order)
                        })
                    }
                }
            }
        }
    }
}

/// A list of two numbers, or of more than three.
fn is_other_list(node: &Node) -> bool {
    matches!(&node.kind, Kind::Tuple(entries) if entries.len() != 3)
}

/// A number as a fraction.
pub(crate) fn constant(value: Rational) -> Fraction {
    Fraction::from(Polynomial::constant(value))
}

/// A fraction with its variables replaced.
pub(crate) fn substituted(fraction: &Fraction, image: &impl Fn(u32) -> Fraction) -> Fraction {
    let lift = |c: &Rational| constant(c.clone());
    fraction.numerator().evaluate(image, lift) / fraction.denominator().evaluate(image, lift)
}

/// A fraction with values for some of its variables.
pub(crate) fn put_in(value: &Fraction, images: &HashMap<Variable, Fraction>) -> Fraction {
    let image = |v| images.get(&v).cloned();
    substituted(value, &|v| image(v).unwrap_or_else(|| variable_fraction(v)))
}

/// The rows of a unit matrix, where they are written under it: `4×4`, `3`.
fn size(label: &FrameLabel) -> Option<usize> {
    let mut numbers = label
        .text
        .split('×')
        .map(|n| n.trim().parse::<usize>().ok());
    let rows = numbers.next()??;
    let square = numbers.all(|n| n == Some(rows));
    (square && (2..=LARGEST_UNIT).contains(&rows)).then_some(rows)
}
