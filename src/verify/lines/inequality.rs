//! Lines that are no equations: ≠, <, ≤, >, ≥.

use crate::notation::ast::{Kind, Line, Node, Relation};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::lines::given::is_zero;
use crate::verify::lines::index::is_equality;
use crate::verify::lines::limits::ARROWS;
use crate::verify::reason;
use crate::verify::verdict::{Finding, Role, Verdict};
use crate::verify::words::role::Words;
use num_traits::Zero;

impl Checker<'_> {
    /// Settles a line that has another relation than an equality; `false` where it has none.
    pub(crate) fn no_equation(&mut self, line: &Line, role: Role, finding: &mut Finding) -> bool {
        let mut others = line.relations.iter().filter(|(r, _)| !is_equality(*r));
        let Some(&(relation, place)) = others.next() else {
            return false;
        };
        finding.reason = Some(reason::RELATION.to_owned());
        finding.place = place;
        let ordered = matches!(
            relation,
            Relation::Less | Relation::LessOrEqual | Relation::Greater | Relation::GreaterOrEqual
        );
        let text = self.document.source.slice(place);
        match relation {
            // `J \in \mathbb{R}^{3\times 3}` says where a symbol lives.
            Relation::Other if matches!(text.trim(), "\\in" | "∈") => {
                finding.verdict = Verdict::Accepted;
                finding.role = Role::Define;
                finding.reason = None;
            }
            Relation::Other if ARROWS.contains(&text.trim()) => self.takes_limit(line, finding),
            Relation::NotEqual if line.relations.len() == 1 => self.not_equal(line, role, finding),
            _ if ordered && self.has_real_roots(line, finding) => {}
            // A criterion is not shown by what is said to follow from it.
            _ if ordered && self.displayed && Words::of(&self.sentence).condition() => {}
            // What is handed over may be false for every body all the same.
            _ if ordered && role != Role::Claim && self.has_wrong_sign(line, finding) => {}
            _ if ordered && role != Role::Claim => {
                self.note_orders(line);
                finding.verdict = Verdict::Accepted;
                finding.reason = None;
            }
            // "We number them so that I₁ < I₂ < I₃."
            _ if ordered && !(self.asserted && self.displayed) && self.orders_inputs(line) => {
                self.note_orders(line);
                finding.verdict = Verdict::Accepted;
                finding.reason = None;
                finding.role = Role::Given;
                finding.remarks.push("taken as given".to_owned());
            }
            _ if ordered => self.decide_signs(line, finding),
            _ => {}
        }
        true
    }

    /// Refutes an order of what is determined, where its differences have the other sign.
    fn has_wrong_sign(&mut self, line: &Line, finding: &mut Finding) -> bool {
        if self.orders_inputs(line) {
            return false;
        }
        let mut tried = finding.clone();
        self.decide_signs(line, &mut tried);
        let wrong = tried.verdict == Verdict::Refuted;
        if wrong {
            *finding = tried;
        }
        wrong
    }

    /// `I_1 < I_2 < I_3`, `m > 0`: an order among what nothing determines, and numbers.
    fn orders_inputs(&mut self, line: &Line) -> bool {
        let beside_zero = !self.displayed && line.sides.len() == 2 && is_zero(&line.sides[1]);
        let free = |checker: &mut Self, side: &Node| {
            let own = beside_zero && checker.new_symbol(side).is_some();
            let own = own || checker.names_moment(side);
            matches!(side.kind, Kind::Number(_)) || checker.is_free_input(side) || own
        };
        line.sides.iter().all(|side| free(self, side))
    }

    /// Whether a side is a symbol that words call a moment of inertia.
    fn names_moment(&self, side: &Node) -> bool {
        let mut named = self.reading.moments.iter();
        matches!(&side.kind, Kind::Symbol(symbol) if named.any(|moment| moment.symbol == *symbol))
    }

    /// `a ≠ b` keeps a case apart, and is false where the sides are equal by what stands before.
    fn not_equal(&mut self, line: &Line, role: Role, finding: &mut Finding) {
        let Ok(read) = self.read(&line.sides, Frame::Moving) else {
            return;
        };
        let residuals: Vec<_> = read.residuals().cloned().collect();
        let differences = residuals.iter().map(|entry| self.theory.normal(entry));
        let differences: Vec<_> = differences.collect();
        let free = |d: &crate::algebra::Fraction| d.to_rational().is_none();
        if differences.iter().all(Zero::is_zero) {
            finding.verdict = Verdict::Refuted;
            finding.reason = Some("the sides are equal".to_owned());
        } else if role != Role::Claim || differences.iter().any(free) {
            finding.verdict = Verdict::Accepted;
            finding.reason = None;
            finding.role = if role == Role::Claim {
                Role::Assume
            } else {
                role
            };
        }
    }
}
