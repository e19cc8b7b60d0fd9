//! An angle that a line takes as small: `\sin\theta \approx \theta`.

use crate::notation::ast::{Function, Kind, Node, Relation};
use crate::verify::check::Checker;
use crate::verify::letters::usage::inner;
use crate::verify::verdict::{Finding, Role, Verdict};

impl Checker<'_> {
    /// Takes in `\sin\theta \approx \theta`: the angle is small from here on.
    pub(crate) fn takes_small_angle(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, right] = sides else { return false };
        let Kind::Function(Function::Sin | Function::Tan, argument) = &inner(left).kind else {
            return false;
        };
        let (Kind::Symbol(of), Kind::Symbol(angle)) = (&inner(argument).kind, &inner(right).kind)
        else {
            return false;
        };
        let approximate = self.figures.relations.contains(&Relation::Approximate);
        let named = self.entity_named(angle);
        let already = named.is_some_and(|entity| self.small.contains(&entity));
        if of != angle || !approximate || already || self.asserted {
            return false;
        }
        self.call_small(right);
        self.linear = true;
        finding.verdict = Verdict::Accepted;
        finding.role = Role::Assume;
        finding.remarks.push("the angle is small".to_owned());
        true
    }
}
