//! The density of a body, and the mass and volume of its elements.

use crate::algebra::Place;
use crate::verify::language::heads::PER_UNIT;
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::verify::model::atoms::{Key, Motion, fraction};
use crate::verify::model::system::{BodyId, ELEMENT};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{index_letter, name_of};
use crate::verify::reading::shapes_read::is_shape;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;

impl Builder<'_> {
    /// "the volume of element `dm`".
    pub(super) fn volume(&self, phrase: &NounPhrase) -> Option<Quantity> {
        match phrase.slot(Slot::Of)? {
            Term::Member { family, index } if family == ELEMENT => {
                let family = *self.families.get(ELEMENT)?;
                Some(Quantity::Volume(family, index_letter(index)))
            }
            _ => None,
        }
    }

    /// "the density of the body": that of one of its elements, the same for each where it is said to be constant.
    pub(super) fn density(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let of = phrase.slot(Slot::Of)?;
        // That of a plate is by its area, that of a rod by its length: which one the shape tells.
        if let Some(body) = self.body(of)
            && let Some((shape, told)) = self.said_to_be(body, is_shape)
        {
            return self.density_of_shape(body, phrase, shape, told);
        }
        let family = *self.families.get(ELEMENT)?;
        let Statement::Is { subjects, .. } = &declaration.statement else {
            return None;
        };
        let [Term::Formula(letter)] = subjects.as_slice() else {
            return None;
        };
        let body = match of {
            Term::Member { .. } => self.reading.system.families[family].body,
            body => self.body(body),
        };
        if body.is_none() || self.reading.system.families[family].body != body {
            return None;
        }
        let index = self.reading.system.families[family]
            .indices
            .first()?
            .clone();
        if phrase.is("uniform") || self.is_the_same_all_over(&[of, &subjects[0]]) {
            let key = Key::new(letter.source.clone());
            let atoms = &mut self.reading.system.atoms;
            let density = fraction(atoms.variable(key, Place::Parameter, Motion::Constant));
            atoms.set_positive(&density);
            self.reading.system.families[family].density = Some(density);
        }
        Some(Quantity::Density(family, index))
    }

    /// The mass of a uniform body by its length, area or volume.
    fn density_of_shape(
        &mut self,
        body: BodyId,
        phrase: &NounPhrase,
        shape: &NounPhrase,
        told: &Declaration,
    ) -> Option<Quantity> {
        if !shape.is("uniform") || self.is_made_otherwise(body) {
            return None;
        }
        let (content, dimension) = self.content_of_shape(body, shape, told)?;
        let unit = dimension.checked_sub(1).map(usize::from)?;
        let said = phrase.all(Slot::With).all(|term| match term {
            Term::Phrase(per) => PER_UNIT.get(unit) == Some(&per.head),
            _ => false,
        });
        let density = self.reading.system.bodies[body].mass.clone() / content;
        said.then_some(Quantity::Known(Value::scalar(density)))
    }

    /// Whether a body is said to be uniform, or a letter to be constant.
    fn is_the_same_all_over(&self, things: &[&Term]) -> bool {
        let names: Vec<String> = things.iter().filter_map(|term| name_of(term)).collect();
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                let same = what.head == "constant" || what.is("uniform");
                let mut subjects = subjects.iter().filter_map(name_of);
                same && subjects.any(|name| names.contains(&name))
            }
            _ => false,
        })
    }
}

/// "per unit length"
pub(super) fn is_per_unit(phrase: &NounPhrase) -> bool {
    let of_unit = |term: &Term| matches!(term, Term::Phrase(unit) if PER_UNIT.contains(&unit.head));
    phrase.all(Slot::With).any(of_unit)
}
