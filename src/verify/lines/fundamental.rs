//! `x(b) - x(a) = \int_a^b \dot x\,dt`: what a quantity gains is the integral of its rate.

use crate::notation::ast::{Kind, Node, Term};
use crate::verify::check::Checker;
use crate::verify::letters::usage::inner;
use crate::verify::reason;
use crate::verify::verdict::{Finding, Verdict};

impl Checker<'_> {
    /// Puts the integral in the place of the gain beside it, and says whether it did; `None` where a value at some time is
    /// left beside an integral over time: what it is, is not known here.
    pub(crate) fn puts_integral_for_gain(&self, sides: &mut [Node]) -> Option<bool> {
        if !sides.iter().any(over_time) {
            return Some(false);
        }
        let mut gained = false;
        for at in 1..sides.len() {
            if gains(&sides[at - 1], &sides[at]) {
                sides[at - 1] = sides[at].clone();
                gained = true;
            } else if gains(&sides[at], &sides[at - 1]) {
                sides[at] = sides[at - 1].clone();
                gained = true;
            }
        }
        (!sides.iter().any(has_call)).then_some(gained)
    }

    /// Leaves a line open that fails with an integral in the place of a gain: no values of the gain can be shown.
    pub(crate) fn leave_gain_open(&self, gained: bool, finding: &mut Finding) {
        if gained && finding.verdict == Verdict::Refuted {
            finding.verdict = Verdict::Undecided;
            finding.reason = Some(reason::INTEGRAL.to_owned());
            finding.counterexample = None;
            finding.residual = None;
        }
    }
}

/// Whether a definite integral over t stands in a node.
fn over_time(node: &Node) -> bool {
    let own = match &node.kind {
        Kind::Integral {
            variable,
            limits: Some(_),
            ..
        } => matches!(&variable.kind, Kind::Symbol(s) if s.name == "t"),
        _ => false,
    };
    own || node.children().any(over_time)
}

fn has_call(node: &Node) -> bool {
    matches!(node.kind, Kind::Call(..)) || node.children().any(has_call)
}

/// Whether one side is `x(b) - x(a)` and the other the integral of ẋ from a to b.
fn gains(gain: &Node, integral: &Node) -> bool {
    let (
        Kind::Sum(terms),
        Kind::Integral {
            integrand,
            limits: Some((from, to)),
            ..
        },
    ) = (&inner(gain).kind, &inner(integral).kind)
    else {
        return false;
    };
    let Kind::TimeDerivative {
        operand,
        order: 1,
        frame: None,
        ..
    } = &inner(integrand).kind
    else {
        return false;
    };
    let at = |term: &Term, limit: &Node| match &inner(&term.node).kind {
        Kind::Call(head, arguments) => {
            matches!(arguments.as_slice(), [one] if same(one, limit)) && same(head, operand)
        }
        _ => false,
    };
    match terms.as_slice() {
        [last, first] => !last.negative && first.negative && at(last, to) && at(first, from),
        _ => false,
    }
}

/// Whether two nodes are one symbol or one number.
fn same(one: &Node, other: &Node) -> bool {
    match (&inner(one).kind, &inner(other).kind) {
        (Kind::Symbol(a), Kind::Symbol(b)) => a == b,
        (Kind::Number(a), Kind::Number(b)) => a.value == b.value,
        _ => false,
    }
}
