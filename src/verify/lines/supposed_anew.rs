//! What is supposed anew: a vector to vanish of which the case at hand had supposed something else, a symbol to be another
//! component.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node};
use crate::notation::document::line_name;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::lines::given::is_zero;
use crate::verify::theory::{Name, Premise};
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Finding, Role};
use crate::verify::words::book::{has_any, lowered};

/// Words that leave a value behind.
const AGAIN: &[&str] = &["back to", "return to", "returning to", "again"];

impl Checker<'_> {
    /// Whether a vector that the case at hand supposes to be something is now supposed to vanish: "with ⟨u = −Dω⟩", and then
    /// "now let the motors rest, ⟨u = 0⟩".
    pub(crate) fn supposes_anew(&mut self, sides: &[Node]) -> bool {
        let [first, last] = sides else { return false };
        if !is_zero(last) || !matches!(inner(first).kind, Kind::Symbol(_)) {
            return false;
        }
        let Ok(value) = self.lowering(Frame::Moving).value(first) else {
            return false;
        };
        let own: Option<Vec<u32>> = value.entries.iter().map(Fraction::as_variable).collect();
        let Some(own) = own.filter(|own| own.len() == 3) else {
            return false;
        };
        let supposed = |p: &Premise| self.cases.is_supposed_now(&p.name) && p.residuals.len() == 3;
        let by_others = |p: &Premise| {
            let mut entries = p.residuals.iter().zip(&own);
            entries.all(|(r, v)| r.variables().contains(v) && r.as_variable().is_none())
        };
        let mut premises = self.theory.premises().iter();
        premises.any(|p| supposed(p) && by_others(p))
    }

    /// Whether a component of ω is now supposed to be what another one was, and lines were derived in between.
    pub(crate) fn turns_about_another(&mut self, sides: &[Node]) -> bool {
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        if self.entities(sides.first()) != [omega] {
            return false;
        }
        let before = self.names_of_siblings(sides);
        let made = |f: &Finding| {
            let place = line_name(f.cell, f.source_line);
            let again = format!("{place} (");
            let mut names = before.iter();
            names.any(|name| *name == place || name.starts_with(&again))
        };
        let mut since = self.findings.iter().skip_while(|f| !made(f));
        since.any(|f| f.role == Role::Claim)
    }

    /// Ends what lines supposed of a symbol that is any again: "we go back to a general ⟨s⟩".
    pub(crate) fn is_any_again(&mut self, node: &Node) {
        let said = lowered(&self.sentence);
        let any = ["general", "arbitrary"]
            .iter()
            .any(|word| said.trim_end().ends_with(word));
        let (Kind::Symbol(symbol), true) = (&inner(node).kind, any && has_any(&said, AGAIN)) else {
            return;
        };
        let Some(entity) = self.entity_named(symbol) else {
            return;
        };
        let atoms = &self.theory.atoms;
        let own = |v: &u32| atoms.entity_of(*v) == Some(entity);
        let premises = self.theory.premises().iter();
        let supposed =
            premises.filter(|p| p.name.starts_with("line ") && p.preferred.iter().any(own));
        let ended = supposed.map(|p| p.name.clone()).collect();
        self.end_premises(&ended);
    }

    /// Lines that say of another component that it is the symbol on the right: ⟨ω₂ = n⟩ where the line at hand has ⟨ω₃ = n⟩.
    pub(crate) fn names_of_siblings(&mut self, sides: &[Node]) -> Vec<Name> {
        let mut lowering = self.lowering(Frame::Moving);
        let mut part = |side: &Node| lowering.scalar(side)?.as_variable();
        let [left, right] = sides else { return vec![] };
        let (Some(left), Some(right)) = (part(left), part(right)) else {
            return vec![];
        };
        let owner = self.theory.atoms.entity_of(left);
        let names_sibling = |residual: &Fraction| {
            let variables = residual.variables();
            let sibling = |&v: &u32| v != left && self.theory.atoms.entity_of(v) == owner;
            variables.len() == 2 && variables.contains(&right) && variables.iter().any(sibling)
        };
        let premises = self.theory.premises().iter();
        let found = premises.filter(|p| p.residuals.iter().all(names_sibling));
        found.map(|p| p.name.clone()).collect()
    }
}
