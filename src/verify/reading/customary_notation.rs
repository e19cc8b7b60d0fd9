//! Rules of writing that say no more than what is custom.

use crate::notation::ast::{DerivativeStyle, Factor, Kind, Operator};
use crate::verify::language::heads::{
    CONJUGATE, DOUBLE_BARS, FULL_STOP, INVERSE_MAP, PLAIN_LETTER, QUATERNION_PRODUCT, SECOND_RATE,
    SQUARE_OF_VECTOR, TENSOR_PRODUCT, TWO_DOTS,
};
use crate::verify::language::statement::{Formula, NotationMeaning, Sign, Slot};
use crate::verify::reading::names::{CROSS_PRODUCT_MATRIX, node_of};
use crate::verify::term::labels::{plain, without_commands};

/// Whether a rule says no more than what is custom: that a dot is a rate, that a × b is the cross product. Of which
/// coordinates a function is, its own law says.
pub(super) fn is_custom(sign: &Sign, meaning: &NotationMeaning) -> bool {
    let NotationMeaning::Noun(phrase) = meaning else {
        return false;
    };
    match sign {
        Sign::Operator(product) if phrase.head == TENSOR_PRODUCT => has_outer_product(product),
        Sign::Operator(dots) if phrase.head == "rate" => phrase.slots.is_empty() && is_dotted(dots),
        Sign::Operator(_) => matches!(
            phrase.head,
            "function"
                | "cross product"
                | "dot product"
                | "trace"
                | "determinant"
                | QUATERNION_PRODUCT
                | "transpose"
        ),
        Sign::Custom(DOUBLE_BARS) => matches!(phrase.head, "magnitude" | "length"),
        Sign::Custom(SQUARE_OF_VECTOR | FULL_STOP) => phrase.head == "dot product",
        Sign::Custom(PLAIN_LETTER) => phrase.head == "magnitude",
        Sign::Mark(_) if phrase.head == CONJUGATE => true,
        Sign::Mark("vee") => phrase.head == INVERSE_MAP,
        Sign::Mark("wedge" | "cross") => phrase.head == CROSS_PRODUCT_MATRIX,
        Sign::Label { labels, .. } => labels.iter().all(|label| match phrase.head {
            "transpose" => is_t(label),
            INVERSE_MAP => label.trim_matches(['\\', '$', '{', '}', ' ']) == "vee",
            head => head == "inverse" && plain_label(label) == "-1",
        }),
        Sign::Mark(TWO_DOTS) => phrase.head == SECOND_RATE && phrase.slots.is_empty(),
        Sign::Mark(mark) if mark.starts_with("dot") && !mark.ends_with("vector") => {
            phrase.head == "rate" && phrase.slot(Slot::SeenFrom).is_none()
        }
        _ => false,
    }
}

/// Whether a superscript is that of a transpose.
fn is_t(label: &str) -> bool {
    matches!(plain_label(label).as_str(), "T" | "top" | "intercal")
}

/// A label without commands and braces.
pub(super) fn plain_label(label: &str) -> String {
    plain(&without_commands(label).replace(['{', '}', '$'], ""))
}

/// Whether a formula writes a rate with dots: `\dot{()}`, `()\dot{}`.
fn is_dotted(formula: &Formula) -> bool {
    let style = match node_of(formula).map(|node| &node.kind) {
        Some(Kind::TimeDerivative { style, .. }) => style,
        _ => return false,
    };
    *style == DerivativeStyle::Dots
}

/// Whether a formula is a product with the sign that always means the outer one.
fn has_outer_product(formula: &Formula) -> bool {
    let outer = |f: &Factor| f.operator == Operator::Tensor;
    match node_of(formula).map(|node| &node.kind) {
        Some(Kind::Product(factors)) => factors.iter().any(outer),
        _ => false,
    }
}
