//! What the symbols of a document's lines stand for, and what is known of that.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node, Symbol};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::symbols;
use crate::verify::values::atoms::Entity;
use crate::verify::values::symbol::{Meaning, meaning};

impl Checker<'_> {
    /// What a symbol stands for.
    pub(crate) fn meaning_of(&mut self, symbol: &Symbol) -> Meaning {
        meaning(symbol, &self.reading, &mut self.theory.atoms)
    }

    /// The entity that a symbol, or the vector or tensor that it is a component of, stands for.
    pub(crate) fn entity_named(&mut self, symbol: &Symbol) -> Option<Entity> {
        self.meaning_of(symbol).entity()
    }

    /// The number that a symbol stands for, which is written in a place.
    pub(crate) fn value_of(&mut self, symbol: &Symbol, span: Span) -> Option<Fraction> {
        let kind = Kind::Symbol(symbol.clone());
        self.lowering(Frame::Moving).scalar(&Node { kind, span })
    }

    /// The entities that the symbols of expressions stand for, from left to right.
    pub(crate) fn entities<'n>(
        &mut self,
        expressions: impl IntoIterator<Item = &'n Node>,
    ) -> Vec<Entity> {
        let named = expressions.into_iter().flat_map(symbols);
        named
            .filter_map(|symbol| self.entity_named(symbol))
            .collect()
    }

    /// Notes that the document has given the symbols of expressions a meaning.
    pub(crate) fn now_known<'n>(&mut self, expressions: impl IntoIterator<Item = &'n Node>) {
        let entities = self.entities(expressions);
        self.known.extend(entities);
    }

    /// Whether no law and no accepted line gives a value.
    pub(crate) fn is_free(&mut self, entity: Entity) -> bool {
        let variable = self.theory.atoms.part(entity, 0, 0);
        self.theory.rule(variable).is_none()
    }
}
