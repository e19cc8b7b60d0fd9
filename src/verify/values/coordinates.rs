//! The coordinates of a particle in an integral over the mass: of a vector, or the letters x, y, z and x₁, x₂, x₃.

use crate::algebra::{Fraction, Polynomial, Variable};
use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::letters::particles::PLACES;
use crate::verify::letters::usage::{Letter, symbols};
use crate::verify::values::atoms::{Entity, Owner, variable_fraction};
use crate::verify::values::lower::{Lowering, Trouble, TroubleKind, put_in, trouble};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::value::Value;
use num_traits::Zero;
use std::collections::{BTreeSet, HashMap};

/// The letters of the coordinates.
const LETTERS: [(&str, Option<&str>); 3] = [("x", None), ("y", None), ("z", None)];

/// The coordinates as a letter with numbers.
fn numbered_letters(name: &str) -> [(&str, Option<&str>); 3] {
    ["1", "2", "3"].map(|index| (name, Some(index)))
}

impl Lowering<'_> {
    /// An integrand in the coordinates of a particle, and these.
    pub(crate) fn in_coordinates(
        &mut self,
        integrand: &Node,
        node: &Node,
    ) -> Result<(Value, Vec<Variable>), Trouble> {
        let value = self.value(integrand)?;
        let coordinates = self.coordinates(&value, integrand, node)?;
        let of_letters = self.other_letters(&coordinates, integrand, node);
        let value = value.map(|entry| put_in(entry, &of_letters));
        let value = self.with_distance(value, &coordinates, integrand, node);
        Ok((value, coordinates))
    }

    /// Beside a coordinate r is the distance from the origin: `∫(r² − x²) dm`. Alone it may be that from an axis.
    fn with_distance(
        &mut self,
        value: Value,
        coordinates: &[Variable],
        integrand: &Node,
        node: &Node,
    ) -> Value {
        let plain = |s: &&Symbol| s.name == "r" && !s.style.vector && s.subscripts.is_empty();
        let measured = symbols(integrand).iter().any(plain);
        let beside = |v: Variable| coordinates.contains(&v);
        let met = |entry: &Fraction| entry.variables().into_iter().any(beside);
        if !measured || !value.entries.iter().any(met) {
            return value;
        }
        let Ok(distance) = self.letter("r", None, node) else {
            return value;
        };
        let square = |&v: &Variable| Polynomial::variable(v) * Polynomial::variable(v);
        let square = coordinates
            .iter()
            .map(square)
            .fold(Polynomial::zero(), |sum, s| sum + s);
        value.map(|entry| {
            let top = entry.numerator();
            let squared = top.coefficient_of(distance, 2);
            let whole = top.coefficient_of(distance, 0) + squared.clone() * square.clone();
            let even = top.degree_in(distance) == 2 && top.coefficient_of(distance, 1).is_zero();
            match even && entry.is_polynomial() {
                true => Fraction::from(whole) / Fraction::from(entry.denominator().clone()),
                false => entry.clone(),
            }
        })
    }

    /// The components of the place of a particle in an integrand: of a vector, or the letters x, y, z and x₁, x₂, x₃.
    fn coordinates(
        &mut self,
        value: &Value,
        integrand: &Node,
        node: &Node,
    ) -> Result<Vec<Variable>, Trouble> {
        let position = self.theory.atoms.quantity(Quantity::Position);
        let arm = [0, 1, 2].map(|c| self.theory.atoms.part(position, c, 0));
        let by_arm = |entry: &Fraction| arm.iter().any(|v| entry.variables().contains(v));
        if value.entries.iter().any(by_arm) {
            return Ok(arm.to_vec());
        }
        let place = self.place_in(integrand);
        if let Some(place) = place.or_else(|| self.place_behind(value)) {
            return Ok(place);
        }
        let usage = &self.reading.usage;
        let numbered = ["x", "r"].into_iter().find(|name| {
            let letter = Letter::plain(name);
            ["1", "2", "3"].iter().all(|i| usage.has_index(&letter, i))
        });
        let plain = |s: &&Symbol| s.subscripts.is_empty() && ["y", "z"].contains(&&*s.name);
        let names = match numbered.filter(|_| !symbols(integrand).iter().any(plain)) {
            Some(name) => numbered_letters(name),
            None => LETTERS,
        };
        let letters = names.into_iter();
        letters
            .map(|(name, index)| self.letter(name, index, node))
            .collect()
    }

    /// Beside a vector the letters of an integrand are its components: `∫(r² − x²) dm`, `∫(r²δ_{ij} − x_i x_j) dm`.
    fn other_letters(
        &mut self,
        coordinates: &[Variable],
        integrand: &Node,
        node: &Node,
    ) -> HashMap<Variable, Fraction> {
        let met = symbols(integrand);
        let mut found = HashMap::new();
        for names in [numbered_letters("x"), LETTERS] {
            for ((name, index), &own) in names.into_iter().zip(coordinates) {
                let written = |s: &&Symbol| {
                    s.name == name
                        && !s.style.vector
                        && s.subscripts.first().map(String::as_str) == index
                };
                if met.iter().any(written)
                    && let Ok(letter) = self.letter(name, index, node)
                    && letter != own
                    && self.theory.rule(letter).is_none()
                {
                    found.insert(letter, variable_fraction(own));
                }
            }
        }
        found
    }

    /// The components of the vector that is the place of a particle in an integrand.
    fn place_in(&mut self, integrand: &Node) -> Option<Vec<u32>> {
        let place = |s: &&Symbol| {
            s.style.vector && s.subscripts.is_empty() && PLACES.contains(&s.name.as_str())
        };
        let symbol = symbols(integrand).into_iter().find(place)?;
        let place = self.value(&Node {
            kind: Kind::Symbol(symbol.clone()),
            span: integrand.span,
        });
        let place = place.ok().filter(Value::is_vector)?;
        place.entries.iter().map(Fraction::as_variable).collect()
    }

    /// The components of the place that the velocities in an integrand follow from.
    fn place_behind(&mut self, value: &Value) -> Option<Vec<u32>> {
        let normals = value.entries.iter().map(|entry| self.theory.normal(entry));
        let normals: Vec<Fraction> = normals.collect();
        let met: BTreeSet<Entity> = normals
            .iter()
            .flat_map(Fraction::variables)
            .filter_map(|variable| self.theory.atoms.entity_of(variable))
            .collect();
        let place = met.into_iter().find(|&entity| {
            let info = self.theory.atoms.info(entity);
            info.shape == Shape::Vector
                && match &info.owner {
                    Owner::Quantity(quantity, _) => *quantity == Quantity::Position,
                    Owner::Symbol(key) => key
                        .split(' ')
                        .next()
                        .is_some_and(|name| PLACES.contains(&name)),
                }
        })?;
        Some(
            (0..3)
                .map(|c| self.theory.atoms.part(place, c, 0))
                .collect(),
        )
    }

    /// The variable of a plain letter, or of one with an index.
    pub(crate) fn letter(
        &mut self,
        name: &str,
        index: Option<&str>,
        node: &Node,
    ) -> Result<Variable, Trouble> {
        let symbol = Symbol {
            name: name.to_owned(),
            subscripts: index.into_iter().map(str::to_owned).collect(),
            ..Symbol::default()
        };
        let value = self.value(&Node {
            kind: Kind::Symbol(symbol),
            span: node.span,
        })?;
        let variable = value.as_scalar().and_then(Fraction::as_variable);
        variable.ok_or_else(|| {
            trouble(
                TroubleKind::Unsupported,
                node.span,
                "the coordinates of this integral are not known",
            )
        })
    }
}
