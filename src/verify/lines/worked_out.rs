//! Lines that would hand a value over but for what they are of: the least value of a known letter, what two sides that are
//! equated come to, the angle of the principal axes. They are worked out, and where nothing here does so they stay open.

use crate::notation::ast::{Function, Kind, Node, Symbol};
use crate::notation::document::{Item, Row};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::usage::{Letter, inner, symbols};
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Finding, Role};
use crate::verify::words::book::{has_any, lowered};

/// Labels of a value at a border; the greatest value of what swings is its amplitude, and may be named.
const EXTREMES: &[&str] = &["min", "crit"];
/// Words of two sides that are set equal.
const EQUATED: &[&str] = &["equating", "equate the", "we equate", "setting both sides"];
/// Words of axes without products of inertia.
const NO_PRODUCT: &[&str] = &["vanish", "disappear", "is zero", "principal"];

impl Checker<'_> {
    /// Why what a new symbol is claimed to be follows from more than its name.
    pub(crate) fn worked_out(&mut self, symbol: &Symbol) -> Option<&'static str> {
        if self.is_extreme_of_known(symbol) {
            return Some("what its least value is follows from a condition that is not decided");
        }
        let words = lowered(&self.sentence);
        let met = self
            .entity_named(symbol)
            .is_some_and(|entity| self.theory.mentions_entity(entity));
        let equated = self.displayed && met && has_any(&words, EQUATED);
        equated.then_some("how it follows from the sides that are equated is not decided")
    }

    /// The n_min of an n that lines before have.
    fn is_extreme_of_known(&mut self, symbol: &Symbol) -> bool {
        let Some((label, others)) = symbol.subscripts.split_last() else {
            return false;
        };
        if !EXTREMES.contains(&label.as_str()) {
            return false;
        }
        let bare = Symbol {
            subscripts: others.to_vec(),
            ..symbol.clone()
        };
        let entity = self.entity_named(&bare);
        entity.is_some_and(|entity| self.theory.mentions_entity(entity))
    }

    /// Leaves open what the angle of axes without products of inertia is said to be: `\tan 2\beta = 2I_{xy}/(I_x - I_y)`.
    pub(crate) fn is_angle_of_principal_axes(
        &mut self,
        sides: &[Node],
        role: Role,
        finding: &mut Finding,
    ) -> bool {
        let [left, right] = sides else { return false };
        let tangent = matches!(&inner(left).kind, Kind::Function(Function::Tan, _));
        let said = has_any(&lowered(&self.sentence), NO_PRODUCT);
        if !tangent || !said || !self.displayed || role == Role::Claim {
            return false;
        }
        let made_of_moments = self.has_products(right);
        if made_of_moments {
            finding.role = Role::Claim;
            finding.reason =
                Some("which way the angle of these axes is measured is not known".to_owned());
        }
        made_of_moments
    }

    /// Whether the display behind words of axes without products says by a product at which angle these lie: they are others
    /// than those used.
    pub(crate) fn seeks_angle(&self, span: Span) -> bool {
        let next = self.document.items.iter().find_map(|item| match item {
            Item::Formula(formula) if formula.display && formula.span.start >= span.end => {
                formula.rows.first()
            }
            _ => None,
        });
        let Some(Row::Line(line)) = next else {
            return false;
        };
        let [left, right] = line.sides.as_slice() else {
            return false;
        };
        let tangent = matches!(&inner(left).kind, Kind::Function(Function::Tan, _));
        tangent && self.has_products(right)
    }

    /// Whether products of inertia stand in a side.
    fn has_products(&self, side: &Node) -> bool {
        let two = |s: &Symbol| {
            let axes: Vec<char> = s.subscripts.iter().flat_map(|s| s.chars()).collect();
            matches!(axes.as_slice(), [one, other] if one != other)
        };
        let mut all = symbols(side).into_iter();
        all.any(|s| self.is_letter_of(Quantity::Inertia, s) && two(s))
    }

    /// Whether entries of a column are those of a momentum, and moments of inertia stand in what they are said to be.
    pub(crate) fn is_momentum_by_moments(&self, left: &Node, right: &Node) -> bool {
        let (mut entries, mut all) = (symbols(left).into_iter(), symbols(right).into_iter());
        entries.all(|s| self.is_letter_of(Quantity::Momentum, s))
            && all.any(|s| self.is_letter_of(Quantity::Inertia, s))
    }

    fn is_letter_of(&self, quantity: Quantity, symbol: &Symbol) -> bool {
        self.reading.quantities.get(&Letter::plain(&symbol.name)) == Some(&quantity)
    }
}
