//! A spin that words move to another axis: "now the steady spin ⟨n⟩ is about ⟨z⟩".

use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::usage::inner;
use crate::verify::theory::{Name, Premise};
use crate::verify::values::atoms::{Owner, variable_fraction};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::symbol::Meaning;
use crate::verify::words::book::{has_any, lowered};
use std::collections::BTreeSet;

const SPIN: &[&str] = &["spin", "rotation", "turn"];
const ABOUT: &[&str] = &[
    "is about",
    "is about the",
    "is around",
    "is around the",
    "is along",
    "is along the",
];
/// The name of the premise.
const NAME: &str = "the same spin about the axis that the words give";

impl Checker<'_> {
    /// Gives the component along an axis the rate that an earlier case has another turn with. Where that was disturbed,
    /// the other two are small now.
    pub(crate) fn spin_is_about(&mut self, axis: &Node) {
        let place = match &inner(axis).kind {
            Kind::Symbol(symbol) if symbol.subscripts.is_empty() => {
                ["x", "y", "z"].iter().position(|name| *name == symbol.name)
            }
            _ => None,
        };
        let said = lowered(&self.sentence);
        let clause = said
            .trim_end()
            .rsplit(['.', ';', ':'])
            .next()
            .unwrap_or_default();
        let lead = ABOUT.iter().find_map(|words| clause.strip_suffix(words));
        let spins = lead.is_some_and(|lead| lead.trim_end().ends_with("⟨⟩") && has_any(lead, SPIN));
        let (Some(place), true, Some(rate)) = (place, spins, self.last_alone.clone()) else {
            return;
        };
        let Kind::Symbol(rate) = &inner(&rate).kind else {
            return;
        };
        let Meaning::Whole(entity) = self.meaning_of(rate) else {
            return;
        };
        let info = self.theory.atoms.info(entity);
        let own = matches!(info.owner, Owner::Symbol(_)) && info.shape == Shape::Scalar;
        if !own || !self.theory.mentions_entity(entity) {
            return;
        }
        let rate = self.theory.atoms.value(entity, 0, 0);
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let parts = [0, 1, 2].map(|c| self.theory.atoms.part(omega, c, 0));
        let disturbed = self.linear || self.small_turns.len() == 2;
        let premises = self.theory.premises().iter();
        let given = premises.filter(|p| {
            let said = p.name.starts_with("line ") || p.name == NAME;
            said && p.preferred.iter().any(|v| parts.contains(v))
        });
        let ended: BTreeSet<Name> = given.map(|p| p.name.clone()).collect();
        self.end_spin();
        self.end_premises(&ended);
        let premise = Premise {
            name: NAME.to_owned(),
            residuals: vec![variable_fraction(parts[place]) - rate],
            preferred: vec![parts[place]],
            definition: false,
        };
        if self.take_from_words(premise, axis.span) && disturbed {
            self.small_turns
                .extend((0..3).filter(|&c| usize::from(c) != place));
            self.drop_second_order();
        }
    }
}
