//! Lines that name the components of a vector: `\mathbf r_b = (r_x, r_y, r_z)`.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::usage::inner;
use crate::verify::values::atoms::Entity;
use crate::verify::values::quantity::Shape;
use crate::verify::values::symbol::Meaning;
use crate::verify::verdict::Finding;

impl Checker<'_> {
    /// Takes in a line that gives the components of a vector their names, where nothing determines either.
    pub(crate) fn names_components(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, right] = sides else { return false };
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return false;
        };
        let Meaning::Whole(whole) = self.meaning_of(symbol) else {
            return false;
        };
        let entries: Vec<&Node> = match &inner(right).kind {
            Kind::Tuple(entries) => entries.iter().collect(),
            Kind::Matrix(rows) => rows.iter().flatten().collect(),
            _ => return false,
        };
        let vector = self.theory.atoms.info(whole).shape == Shape::Vector;
        let free = |checker: &mut Self, entity: Entity, component: u8| {
            let value = checker.theory.atoms.value(entity, component, 0);
            checker.theory.normal(&value).as_variable() == Fraction::as_variable(&value)
        };
        if !vector || entries.len() != 3 || !(0..3).all(|c| free(self, whole, c)) {
            return false;
        }
        for (at, entry) in (0..3).zip(entries) {
            let Kind::Symbol(symbol) = &inner(entry).kind else {
                return false;
            };
            let named = match self.meaning_of(symbol) {
                Meaning::Component(entity, component) if component == at => (entity, component),
                Meaning::Whole(entity) => (entity, 0),
                _ => return false,
            };
            if named.0 == whole || !free(self, named.0, named.1) {
                return false;
            }
        }
        self.accept_definition(sides, finding)
    }
}
