//! Moments and products of inertia on turned axes: `I_{x'x'}`, `I_{uv}`, where the document says what the coordinates on
//! these axes are.

use crate::algebra::{Fraction, Variable};
use crate::mechanics::Products;
use crate::notation::ast::{Kind, Node, Symbol};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, symbols};
use crate::verify::theory::Premise;
use crate::verify::values::atoms::{Entity, Owner, variable_fraction};
use crate::verify::values::lower::Lowering;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::words::prose::Said;
use num_traits::Zero;

/// The name of the premise that a moment on turned axes is the integral over its own coordinates.
const NAME: &str = "moments on turned axes";

impl Checker<'_> {
    /// Takes the moments on turned axes in a line as the integrals that they are. A line that gives one by an integral of
    /// its own says itself what it is.
    pub(crate) fn note_turned_moments(&mut self, sides: &[Node]) {
        if sides.iter().any(has_integral) {
            return;
        }
        let all: Vec<Symbol> = sides.iter().flat_map(symbols).cloned().collect();
        for symbol in all {
            let Some((entity, value)) = self.turned_moment(&symbol) else {
                continue;
            };
            let atoms = &mut self.theory.atoms;
            atoms.info_mut(entity).constant = false;
            // The angle is what the coordinates make it.
            let inside = value
                .variables()
                .into_iter()
                .flat_map(|v| atoms.with_arguments(v));
            let angles: Vec<Entity> = inside.filter_map(|v| atoms.entity_of(v)).collect();
            self.known.extend(angles);
            let own = self.theory.atoms.part(entity, 0, 0);
            self.theory.assume(Premise {
                name: NAME.to_owned(),
                residuals: vec![variable_fraction(own) - value],
                preferred: vec![own],
                definition: true,
            });
            self.known.insert(entity);
        }
    }

    /// ∫ (r² − a²) dm for two equal indices, ∫ ab dm, with the sign of the convention, for two others.
    fn turned_moment(&mut self, symbol: &Symbol) -> Option<(Entity, Fraction)> {
        if self.reading.quantities.get(&Letter::of(symbol)) != Some(&Quantity::Inertia) {
            return None;
        }
        let [index] = symbol.subscripts.as_slice() else {
            return None;
        };
        let [a, b] = coordinates(index)?;
        let Meaning::Whole(entity) = self.meaning_of(symbol) else {
            return None;
        };
        let own = matches!(self.theory.atoms.info(entity).owner, Owner::Symbol(_));
        if !own || self.theory.mentions_entity(entity) || !self.is_free(entity) {
            return None;
        }
        let entries = self.theory.setting.products == Products::Entries;
        let mut lowering = self.lowering(Frame::Moving);
        let axes = ["x", "y", "z"].map(|name| lowering.coordinate(&coordinate(name, 0)));
        let [Some(x), Some(y), Some(z)] = axes else {
            return None;
        };
        let axes: Vec<Variable> = [&x, &y, &z]
            .into_iter()
            .filter_map(Fraction::as_variable)
            .collect();
        let (a_value, b_value) = (lowering.turned(&a, &axes)?, lowering.turned(&b, &axes)?);
        let square = |v: &Fraction| v.clone() * v.clone();
        let integrand = match a == b {
            true => square(&x) + square(&y) + square(&z) - square(&a_value),
            false if entries => -(a_value * b_value),
            false => a_value * b_value,
        };
        Some((entity, lowering.moment_of(&integrand, &axes)?))
    }
}

impl Checker<'_> {
    /// Where the integrals of a line leave the body no extent along an axis, its products across that plane vanish too.
    pub(crate) fn note_flat_body(&mut self, sides: &[Node], span: Span) {
        if !sides.iter().any(has_integral) {
            return;
        }
        let second = self.lowering(Frame::Moving).second_moments();
        for (across, [a, b]) in [(0, [1, 2]), (1, [0, 2]), (2, [0, 1])] {
            if self.theory.normal(&second[across][across]).is_zero() {
                self.take(Said::SymmetryPlane(a, b), span);
            }
        }
    }
}

impl Lowering<'_> {
    fn coordinate(&mut self, symbol: &Symbol) -> Option<Fraction> {
        let kind = Kind::Symbol(symbol.clone());
        let span = Span::default();
        self.scalar(&Node { kind, span })
    }

    /// A coordinate on turned axes in those on the axes used; `None` where no line says what it is.
    fn turned(&mut self, symbol: &Symbol, axes: &[Variable]) -> Option<Fraction> {
        let written = self.coordinate(symbol)?;
        let value = self.theory.normal(&written);
        let said = axes.iter().any(|v| value.variables().contains(v));
        (value != written && said && !value.is_zero()).then_some(value)
    }
}

fn coordinate(name: &str, primes: u8) -> Symbol {
    Symbol {
        name: name.to_owned(),
        primes,
        ..Symbol::default()
    }
}

/// The two coordinates of an index: `x'y'`, `uu`, `u`.
fn coordinates(index: &str) -> Option<[Symbol; 2]> {
    let mut found: Vec<Symbol> = vec![];
    for c in index.chars().filter(|c| !matches!(c, ' ' | ',')) {
        match c {
            '\'' | '′' => found.last_mut()?.primes += 1,
            c if c.is_alphabetic() => found.push(coordinate(&c.to_string(), 0)),
            _ => return None,
        }
    }
    // `I_{x'}` is the moment about that axis.
    if found.len() == 1 {
        found.push(found[0].clone());
    }
    found.try_into().ok()
}

fn has_integral(node: &Node) -> bool {
    matches!(node.kind, Kind::Integral { .. }) || node.children().any(has_integral)
}
