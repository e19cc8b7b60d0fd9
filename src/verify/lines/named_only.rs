//! Claims whose left side is new and which are no mere definitions: what the words or the theory have it be is more than
//! its name, and such a line is not taken on trust.

use crate::notation::ast::{Factor, Kind, Node, Operator, Symbol, Term};
use crate::verify::check::Checker;
use crate::verify::letters::usage::{Letter, inner, symbols};
use crate::verify::reason::DRIVES_A_PART;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::verdict::Finding;
use crate::verify::words::book::{has_any, lowered};

/// What drives a wheel in the body, and turns that as well.
const DRIVES: &[&str] = &[
    "motor torque",
    "torque of the motor",
    "torque on the wheel",
    "torque on the rotor",
];

impl Checker<'_> {
    /// Leaves a line open that would be a definition but for what it speaks of, claimed or in passing.
    pub(crate) fn is_more_than_a_name(
        &mut self,
        left: &Node,
        right: &Node,
        claimed: bool,
        finding: &mut Finding,
    ) -> bool {
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return false;
        };
        if self.is_on_border(left, right, finding)
            || claimed && self.shifts_the_wrong_way(left, right, finding)
        {
            return true;
        }
        let words = lowered(&self.sentence);
        let of_a_surface = has_any(&words, &["semi-ax", "semiax"]);
        if claimed && of_a_surface && self.is_semi_axis(&[left.clone(), right.clone()], finding) {
            return true;
        }
        let reason = if claimed && of_a_surface {
            "whether the surface has these axes is not decided"
        } else if claimed && self.displayed && is_multiple_of_unprimed(symbol, right) {
            "how the new value follows from the old one is not decided"
        } else if claimed
            && DRIVES.iter().any(|word| words.contains(word))
            && !self.is_rate_of_wheel(right)
            && !self.is_rate_of_stored(right)
        {
            DRIVES_A_PART
        } else if self.speaks_of_vertical_momentum() {
            "which way the vertical points on the axes used is not known"
        } else if self.misses_motion_of_point(symbol, right) {
            "about a point that may move, more than the rate of the momentum stands on this side"
        } else if self.turns_the_arm_round(symbol, right) {
            "the arm of the momentum runs from the point to the mass centre, and stands before the momentum"
        } else if self.accelerates_another_point(symbol, right) {
            "the force is the mass times the acceleration of the mass centre, not of any point"
        } else if claimed && self.equates_two_points(symbol, right) {
            "what it is about one point does not follow so from what it is about the other"
        } else if let Some(reason) = self.worked_out(symbol).filter(|_| claimed) {
            reason
        } else {
            return false;
        };
        finding.reason = Some(reason.to_owned());
        true
    }

    /// Whether an expression is the rate of the vector of what the wheels have, of which nothing is said.
    fn is_rate_of_stored(&mut self, right: &Node) -> bool {
        let stored = self.theory.atoms.quantity(Quantity::RelativeMomentum);
        let Kind::TimeDerivative {
            operand, order: 1, ..
        } = &inner(right).kind
        else {
            return false;
        };
        let whole = matches!(&inner(operand).kind, Kind::Symbol(symbol)
            if self.meaning_of(symbol) == Meaning::Whole(stored));
        whole && !self.theory.mentions_entity(stored)
    }

    /// Whether a force is the mass times the acceleration of a point that is not the mass centre by its label, where those
    /// of several points are written.
    fn accelerates_another_point(&self, symbol: &Symbol, right: &Node) -> bool {
        let Kind::Product(factors) = &inner(right).kind else {
            return false;
        };
        let force = self.reading.quantities.get(&Letter::of(symbol)) == Some(&Quantity::Force);
        let centres = [
            "G", "C", "S", "g", "c", "cm", "CM", "cg", "CG", "com", "\\ast", "*",
        ];
        force
            && factors
                .iter()
                .any(|factor| match &inner(&factor.node).kind {
                    Kind::Symbol(point) if point.name == "a" && point.style.vector => {
                        let labels = self.reading.usage.subscripts.get(&Letter::of(point));
                        let several = labels.is_some_and(|all| all.len() > 1);
                        let centre = |label: &String| centres.contains(&label.trim());
                        several && !point.subscripts.iter().any(centre)
                    }
                    _ => false,
                })
    }

    /// Whether an inertia or a momentum about a point is that about the mass centre and nothing more, or several times that
    /// beside what one mass adds: `H_P = H_G`, `I_O = 2 I_C + m r²`.
    fn equates_two_points(&self, symbol: &Symbol, right: &Node) -> bool {
        let letter = Letter::of(symbol);
        let quantity = self.reading.quantities.get(&letter);
        let point = |s: &Symbol| match s.subscripts.as_slice() {
            [one] => one.len() == 1 && one.starts_with(|c: char| c.is_ascii_uppercase()),
            _ => false,
        };
        if !matches!(quantity, Some(Quantity::Momentum | Quantity::Inertia)) || !point(symbol) {
            return false;
        }
        let centre = |s: &Symbol| point(s) && matches!(s.subscripts[0].as_str(), "C" | "G" | "S");
        let other = |node: &Node| matches!(&inner(node).kind, Kind::Symbol(s) if Letter::of(s) == letter && centre(s) && s != symbol);
        let times = |node: &Node| match &inner(node).kind {
            Kind::Product(factors) => match &inner(&factors[0].node).kind {
                Kind::Number(number) => Some(number.value.clone()),
                _ => None,
            },
            _ => None,
        };
        match &inner(right).kind {
            Kind::Symbol(_) => quantity == Some(&Quantity::Momentum) && other(right),
            Kind::Sum(terms) => match terms.as_slice() {
                [own, shift] => {
                    let factors = match &inner(&own.node).kind {
                        Kind::Product(factors) => factors.as_slice(),
                        _ => return false,
                    };
                    let multiple = matches!(factors, [_, one] if other(&one.node));
                    multiple && times(&own.node).is_some() && times(&own.node) != times(&shift.node)
                }
                _ => false,
            },
            _ => false,
        }
    }

    /// Whether a momentum about another point has `m v × r`, or an arm that runs the other way, beside the one about the
    /// mass centre.
    fn turns_the_arm_round(&self, symbol: &Symbol, right: &Node) -> bool {
        let letter = Letter::of(symbol);
        let Kind::Sum(terms) = &inner(right).kind else {
            return false;
        };
        let own = |term: &Term| matches!(&inner(&term.node).kind, Kind::Symbol(s) if Letter::of(s) == letter);
        if self.reading.quantities.get(&letter) != Some(&Quantity::Momentum)
            || !terms.iter().any(own)
        {
            return false;
        }
        let points = labels(symbol);
        terms.iter().any(|term| {
            self.arm(&term.node, &points)
                .is_some_and(|forward| forward == term.negative)
        })
    }

    /// Whether a term is `r × m v` with the arm from the point, or that turned round once; `None` for anything else.
    fn arm(&self, node: &Node, point: &str) -> Option<bool> {
        let Kind::Product(factors) = &inner(node).kind else {
            return None;
        };
        let mut operands = factors.chunk_by(|_, next| next.operator != Operator::Cross);
        let (first, second) = (operands.next()?, operands.next()?);
        let arm = |operand: &[Factor]| self.ends_of(operand, point);
        let moving = [
            Quantity::Velocity,
            Quantity::CentreVelocity,
            Quantity::LinearMomentum,
        ];
        let (forward, before) = match (arm(first), arm(second)) {
            (Some(forward), None) if self.one_of(second, &moving).is_some() => (forward, true),
            (None, Some(forward)) if self.one_of(first, &moving).is_some() => (forward, false),
            _ => return None,
        };
        Some(before == forward?)
    }

    /// Whether the position in an operand, or the difference of two of them, starts at a point; `None` within where it
    /// does not say.
    fn ends_of(&self, operand: &[Factor], point: &str) -> Option<Option<bool>> {
        let position = |node: &Node| match &inner(node).kind {
            Kind::Symbol(s) => {
                let quantity = self.reading.quantities.get(&Letter::of(s));
                (quantity == Some(&Quantity::Position)).then(|| labels(s))
            }
            _ => None,
        };
        let difference = operand
            .iter()
            .find_map(|factor| match &inner(&factor.node).kind {
                Kind::Sum(terms) => match terms.as_slice() {
                    [one, other] if one.negative != other.negative => {
                        let (to, from) = if one.negative {
                            (other, one)
                        } else {
                            (one, other)
                        };
                        Some((position(&from.node)?, position(&to.node)?))
                    }
                    _ => None,
                },
                _ => None,
            });
        match difference {
            Some((from, to)) => Some(tells_start(&from, &to, point)),
            None => {
                let arm = self.one_of(operand, &[Quantity::Position])?;
                Some(starts_at(&labels(&arm), point))
            }
        }
    }

    /// The symbol of an operand that is one of some quantities.
    fn one_of(&self, operand: &[Factor], quantities: &[Quantity]) -> Option<Symbol> {
        let mut found = operand.iter().flat_map(|factor| symbols(&factor.node));
        let named = |s: &&Symbol| {
            let quantity = self.reading.quantities.get(&Letter::of(s));
            quantity.is_some_and(|q| quantities.contains(q))
        };
        found.find(named).cloned()
    }
}

/// Whether an arrow starts at a point: `PC` does at P, `C/P` too, and `CP` does not; `None` where its index does not say.
fn starts_at(arrow: &str, point: &str) -> Option<bool> {
    let (from, to) = match arrow.split_once('/') {
        Some((to, from)) => (from, to),
        None => arrow.split_at_checked(1)?,
    };
    tells_start(from, to, point)
}

fn tells_start(from: &str, to: &str, point: &str) -> Option<bool> {
    match (from == point, to == point) {
        (true, false) => Some(true),
        (false, true) => Some(false),
        _ => None,
    }
}

/// `X' = 2 X`.
fn is_multiple_of_unprimed(symbol: &Symbol, right: &Node) -> bool {
    let all = symbols(right);
    let plain =
        |s: &&Symbol| s.name == symbol.name && s.primes == 0 && s.subscripts == symbol.subscripts;
    let product = matches!(inner(right).kind, Kind::Product(_) | Kind::Quotient(..));
    symbol.primes > 0 && product && matches!(all.as_slice(), [only] if plain(only))
}

/// All that stands under and over a symbol.
fn labels(symbol: &Symbol) -> String {
    let written = symbol.subscripts.iter().chain(&symbol.superscripts);
    written.map(String::as_str).collect()
}
