//! A moment of inertia that words carry over to a parallel axis: away from the mass centre it grows.

use crate::notation::ast::{Factor, Kind, Node, Symbol, Term};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::two_points::CENTRES;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::lines::defined_squares::is_two;
use crate::verify::lines::points::Law;
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::Finding;
use crate::verify::words::book::{has_any, lowered};

/// Names of the theorem.
const THEOREM: &[&str] = &[
    "parallel axis",
    "parallel-axis",
    "parallel axes",
    "parallel-axes",
    "steiner",
    "huygens",
];
/// Words of an axis through the mass centre.
const THROUGH_CENTRE: &[&str] = &[
    "about a diameter",
    "about its diameter",
    "about any diameter",
    "about the diameter",
    "through the cent",
    "through its cent",
    "through its own cent",
    "through the mass cent",
    "about the cent",
    "about its cent",
    "about its own cent",
    "about the mass cent",
    "through the barycent",
    "central axis",
    "its own axis",
    "centroidal axis",
];
/// Words of the centre of a part.
const OF_A_PART: &[&str] = &[
    "of the base",
    "of its base",
    "of a face",
    "of one face",
    "of the end",
    "of one end",
    "of an edge",
    "of one side",
];
/// Why a line stays open.
const WHICH: &str = "which of the axes goes through the mass centre is not said";
/// Bytes before a line in which the axis is named that it starts from.
const NEAR: u32 = 400;

impl Checker<'_> {
    /// Decides what "by the theorem of parallel axes" makes of a moment, where the line takes the shift off: false, where
    /// words have the axis that it starts from through the mass centre. Where they do not say so, or where it adds the
    /// shift on its way to the centre, it stays open.
    pub(crate) fn shifts_the_wrong_way(
        &mut self,
        left: &Node,
        right: &Node,
        finding: &mut Finding,
    ) -> bool {
        if !self.text.says(THEOREM) {
            return false;
        }
        let clause = lowered(self.sentence.rsplit(['⟩', ';']).next().unwrap_or_default());
        let (Kind::Symbol(symbol), Kind::Sum(terms)) = (&inner(left).kind, &inner(right).kind)
        else {
            return false;
        };
        let label = |label: &String| CENTRES.contains(&label.as_str());
        let inwards = symbol.style.bar
            || symbol.subscripts.iter().any(label)
            || has_any(&clause, THROUGH_CENTRE);
        let wrong = |term: &Term| term.negative != inwards && self.is_shift(&term.node);
        if !has_any(&clause, THEOREM) || !terms.iter().any(wrong) {
            return false;
        }
        let mut turned = terms.clone();
        for term in turned.iter_mut().filter(|term| wrong(term)) {
            term.negative = false;
        }
        let right_way = Node {
            kind: Kind::Sum(turned),
            ..right.clone()
        };
        let sure = !inwards && self.starts_at_centre(finding, clause.len());
        if !sure || !self.takes_moment(symbol, &right_way) {
            finding.reason = Some(WHICH.to_owned());
            return true;
        }
        self.claim(&[left.clone(), right.clone()], finding);
        finding.follows_from = None;
        true
    }

    /// Takes the moment about the other axis in.
    fn takes_moment(&mut self, symbol: &Symbol, value: &Node) -> bool {
        let Ok(value) = self.lowering(Frame::Moving).value(value) else {
            return false;
        };
        let Some(entity) = self.entity_named(symbol) else {
            return false;
        };
        self.known.insert(entity);
        self.take_law(Law::new("parallel-axis", entity, value))
            .is_some()
    }

    /// Whether the words before the clause of a line name an axis through the mass centre.
    fn starts_at_centre(&self, finding: &Finding, clause: usize) -> bool {
        let source = &self.document.source.text;
        let end = (finding.span.start as usize).saturating_sub(clause);
        let start = end.saturating_sub(NEAR as usize);
        let near: String = String::from_utf8_lossy(&source.as_bytes()[start..end]).into();
        let near = lowered(&near).replace('\n', " ");
        has_any(&near, THROUGH_CENTRE) && !has_any(&near, OF_A_PART)
    }

    /// A mass times the square of a length.
    fn is_shift(&self, term: &Node) -> bool {
        let factors = match &inner(term).kind {
            Kind::Product(factors) => factors,
            Kind::Quotient(above, _) => return self.is_shift(above),
            _ => return false,
        };
        let mass = |factor: &Factor| match &inner(&factor.node).kind {
            Kind::Symbol(s) => {
                let quantity = self.reading.quantities.get(&Letter::of(s));
                quantity == Some(&Quantity::Mass) || matches!(s.name.as_str(), "m" | "M")
            }
            _ => false,
        };
        let square = |factor: &Factor| matches!(&inner(&factor.node).kind, Kind::Power(_, two) if is_two(two));
        factors.iter().any(mass) && factors.iter().any(square)
    }
}
