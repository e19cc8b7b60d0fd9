//! Numerals as they are shown: how much a number may differ from them and still be written so.

use crate::algebra::Rational;
use crate::notation::ast::{Kind, Node, Number};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

/// What is put in the place of each number of a numeral.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// Half a unit of the last digit shown, for numbers with a decimal point or a power of ten.
    Decimals,
    /// Half a unit of an integer.
    Integers,
    /// The same behind a sign of approximation, where zeros at the end are no digits: of 5030 ± 5, and of 100 ± 5, as two
    /// digits are shown at least.
    Rounded,
    /// Half a unit of the last digit that is not zero, or a whole unit of the last one shown: a number that agrees so
    /// far is not surely wrong.
    Doubt,
}

/// Ten to a power.
fn power_of_ten(exponent: i32) -> BigRational {
    BigRational::from_integer(BigInt::from(10)).pow(exponent.clamp(-999, 999))
}

/// The place value of the last digit shown.
fn last_place(number: &Number) -> BigRational {
    let decimals = number
        .decimals
        .map_or(0, |d| i32::try_from(d).unwrap_or(999));
    power_of_ten(number.exponent.saturating_sub(decimals))
}

fn half() -> BigRational {
    BigRational::new(BigInt::one(), BigInt::from(2))
}

fn is_decimal(number: &Number) -> bool {
    number.decimals.is_some() || number.exponent != 0
}

fn part_of(number: &Number, part: Part) -> BigRational {
    let last = last_place(number);
    match part {
        _ if number.value.is_zero() && !is_decimal(number) => BigRational::zero(),
        Part::Decimals if is_decimal(number) => last * half(),
        Part::Integers if !is_decimal(number) => last * half(),
        Part::Rounded if !is_decimal(number) => {
            let ten = power_of_ten(1);
            let mut unit = last;
            while (&number.value / (&unit * &ten)).is_integer()
                && &unit * &ten * &ten <= number.value
            {
                unit *= &ten;
            }
            unit * half()
        }
        Part::Doubt => {
            let mut zeros = last.clone();
            let ten = power_of_ten(1);
            // Trailing zeros of an integer may or may not be shown digits.
            while !is_decimal(number)
                && !number.value.is_zero()
                && (&number.value / (&zeros * &ten)).is_integer()
            {
                zeros *= &ten;
            }
            // Half of a number is no rounding of it: 10 is not what 5 is to the next ten.
            let less_than_half = &number.value * BigRational::new(49.into(), 100.into());
            last.max((zeros * half()).min(less_than_half))
        }
        _ => BigRational::zero(),
    }
}

/// Whether a node is a number, or a list or matrix or sum along unit vectors of numbers, with or without units.
/// `is_axis` tells unit vectors.
pub(crate) fn is_numeral(node: &Node, is_axis: &mut impl FnMut(&Node) -> bool) -> bool {
    match &node.kind {
        Kind::Number(_) => true,
        Kind::Negate(a) | Kind::Group(_, a) | Kind::WithUnit(a, _) | Kind::Transpose(a) => {
            is_numeral(a, is_axis)
        }
        Kind::Tuple(entries) => entries.iter().all(|e| is_numeral(e, is_axis)),
        Kind::Matrix(rows) => rows.iter().flatten().all(|e| is_numeral(e, is_axis)),
        Kind::Sum(terms) => terms.iter().all(|t| is_along_axis(&t.node, is_axis)),
        Kind::Product(_) => is_along_axis(node, is_axis),
        _ => false,
    }
}

/// `12.5 \hat\imath`.
fn is_along_axis(node: &Node, is_axis: &mut impl FnMut(&Node) -> bool) -> bool {
    match &node.kind {
        Kind::Product(factors) => match factors.as_slice() {
            [number, axis] => is_numeral(&number.node, is_axis) && is_axis(&axis.node),
            _ => false,
        },
        Kind::Negate(a) | Kind::Group(_, a) | Kind::WithUnit(a, _) => is_along_axis(a, is_axis),
        _ => false,
    }
}

/// A numeral with something else in the place of each number, and every sign a plus.
pub(crate) fn with(node: &Node, part: Part) -> Node {
    let mut node = node.clone();
    put(&mut node, part);
    node
}

fn put(node: &mut Node, part: Part) {
    if let Kind::Negate(inside) = &mut node.kind {
        let inside = std::mem::replace(&mut **inside, nothing(node.span));
        *node = inside;
        return put(node, part);
    }
    if let Kind::Number(number) = &mut node.kind {
        number.value = part_of(number, part);
        return;
    }
    if let Kind::Sum(terms) = &mut node.kind {
        terms.iter_mut().for_each(|term| term.negative = false);
    }
    node.children_mut()
        .into_iter()
        .for_each(|child| put(child, part));
}

fn nothing(span: crate::source::Span) -> Node {
    Node {
        kind: Kind::Ellipsis,
        span,
    }
}

/// Whether a number with a decimal point stands somewhere in a node.
pub(crate) fn holds_decimals(node: &Node) -> bool {
    match &node.kind {
        Kind::Number(number) => is_decimal(number),
        _ => node.children().any(holds_decimals),
    }
}

/// Whether a unit stands somewhere in a node.
pub(crate) fn holds_unit(node: &Node) -> bool {
    matches!(node.kind, Kind::WithUnit(..)) || node.children().any(holds_unit)
}

/// The texts of all units in a node.
pub(crate) fn units<'a>(node: &'a Node, out: &mut Vec<&'a str>) {
    if let Kind::WithUnit(_, unit) = &node.kind {
        out.push(unit);
    }
    node.children().for_each(|child| units(child, out));
}

/// A number rounded to as many decimals as a numeral shows, as a text in place of the numeral's.
pub(crate) fn rounded(value: f64, like: &Number) -> Option<String> {
    if like.exponent != 0 || !value.is_finite() || value.abs() > 1e15 {
        return None;
    }
    let decimals = usize::try_from(like.decimals.unwrap_or(0)).ok()?;
    Some(format!("{value:.decimals$}"))
}

/// The one number of a scalar numeral, and where it stands.
pub(crate) fn only_number(node: &Node) -> Option<(&Number, crate::source::Span)> {
    match &node.kind {
        Kind::Number(number) => Some((number, node.span)),
        Kind::Group(_, a) | Kind::WithUnit(a, _) | Kind::Negate(a) => only_number(a),
        _ => None,
    }
}

/// The value of a number as written.
pub(crate) fn value(number: &Number) -> Rational {
    Rational::from(number.value.clone())
}
