//! A matrix that a line tells by what it makes of a vector: the E of `\dot\Phi = E\,\omega`, where ω may be any.

use crate::algebra::{Fraction, Polynomial, Variable};
use crate::notation::ast::{Factor, Kind, Node, Operator};
use crate::verify::model::atoms::Atoms;
use crate::verify::standing::chains::Link;
use crate::verify::standing::hold::Sides;
use crate::verify::standing::judge::Judge;
use crate::verify::standing::sides::lone;
use crate::verify::term::value::Value;
use num_traits::{One, Zero};
use std::collections::BTreeSet;

/// Letters before others that make differentials of them.
const DIFFERENTIALS: [&str; 4] = ["d", "\\mathrm{d}", "\\delta", "\\Delta"];

/// A side that is a product with a letter: what stands before it, the letter, whether it is inverted, the vector behind it.
struct Applied<'n> {
    scale: Vec<&'n Node>,
    letter: (String, &'n Node),
    inverted: bool,
    vector: Node,
}

impl Judge<'_> {
    /// What a letter is by a relation of two vectors, where nothing else tells it; `None` where the line says something else.
    pub(super) fn settled_by_relation(&mut self, link: &Link<'_>) -> Option<Sides> {
        let [left, right] = link.sides();
        let ways = [(left, right), (right, left)];
        ways.into_iter().find_map(|(side, other)| {
            let is_told = |letter: &Node| self.known.is_told(letter, &self.reading.letters);
            let applied = applied(side, is_told)?;
            self.settled_by(&applied, other)
        })
    }

    fn settled_by(&mut self, applied: &Applied<'_>, other: &Node) -> Option<Sides> {
        let (name, letter) = &applied.letter;
        let mut lowering = self.lowering();
        lowering.value(letter).ok()?;
        if !lowering.unknown.contains_key(name) || lowering.known.shapes.contains_key(name) {
            return None;
        }
        lowering.unknown.clear();
        let custom = lowering.custom();
        let [vector, told] = [&applied.vector, other].map(|node| {
            let value = lowering.value(node).ok()?;
            lowering.system.written_out(&value, custom).ok()
        });
        let (vector, told) = (vector?, told?);
        let mut scale = Fraction::one();
        for factor in &applied.scale {
            scale *= lowering.value(factor).ok()?.to_scalar().ok()?;
        }
        // What an earlier line settles is known by its shape.
        let mut letters = lowering.unknown.keys();
        let all_told = letters.all(|letter| lowering.known.shapes.contains_key(letter));
        let sure = all_told && !scale.is_zero();
        if !sure || vector.columns != 1 || told.columns != 1 || vector.rows != told.rows {
            return None;
        }
        let entries = self.matrix_between(&vector.entries, &told.entries)?;
        let entries = entries.into_iter().map(|entry| entry / scale.clone());
        let size = vector.rows;
        let matrix = Value::written(size, size, entries.collect());
        let mut lowering = self.lowering();
        let matrix = match applied.inverted {
            true => lowering.system.inverse(&matrix).ok()?,
            false => matrix,
        };
        let unknown = lowering.unknown_of_shape(name, matrix.shape());
        let sides = unknown
            .entries
            .iter()
            .cloned()
            .zip(matrix.entries.iter().cloned());
        Some(Sides {
            sides: sides.collect(),
            unknown: vec![name.clone()],
            settles: Some((name.clone(), unknown, matrix)),
        })
    }

    /// The matrix that makes one column of another, by rows, where the other may be any and nothing but it moves the first.
    fn matrix_between(&mut self, of: &[Fraction], told: &[Fraction]) -> Option<Vec<Fraction>> {
        let atoms = &mut self.reading.system.atoms;
        let facts = &mut self.facts;
        let mut normal = |all: &[Fraction]| -> Option<Vec<Fraction>> {
            all.iter()
                .map(|one| facts.normal(atoms, one).ok())
                .collect()
        };
        let (of, told) = (normal(of)?, normal(told)?);
        let free = free_rates(atoms, &of);
        if free.len() != of.len() {
            return None;
        }
        let (below, above) = (slopes(&of, &free)?, slopes(&told, &free)?);
        let size = free.len();
        let inverse = self
            .reading
            .system
            .inverse(&Value::written(size, size, below))
            .ok()?;
        let entry = |row: usize, column: usize| {
            let products = (0..size).map(|k| {
                above[row * size + k].clone() * inverse.entries[k * size + column].clone()
            });
            products.fold(Fraction::zero(), |sum, product| sum + product)
        };
        let places = (0..size * size).map(|place| entry(place / size, place % size));
        Some(places.collect())
    }
}

/// A side as a letter, of which nothing is told, that is multiplied with a vector.
fn applied(side: &Node, is_told: impl Fn(&Node) -> bool) -> Option<Applied<'_>> {
    let Kind::Product(factors) = &side.kind else {
        return None;
    };
    let plain = |f: &Factor| matches!(f.operator, Operator::Juxtaposed | Operator::Dot);
    let at = factors.len().checked_sub(2)?;
    if !factors.iter().all(plain) {
        return None;
    }
    let (letter, inverted) = match &factors[at].node.kind {
        Kind::Power(base, exponent) if exponent.is_minus_one() => (&**base, true),
        _ => (&factors[at].node, false),
    };
    if is_told(letter) {
        return None;
    }
    let name = lone(letter)?;
    if DIFFERENTIALS.contains(&name.as_str()) {
        return None;
    }
    Some(Applied {
        scale: factors[..at].iter().map(|f| &f.node).collect(),
        letter: (name, letter),
        inverted,
        vector: factors[at + 1].node.clone(),
    })
}

/// The rates, or the entries themselves, of which a column is made.
fn free_rates(atoms: &Atoms, column: &[Fraction]) -> Vec<Variable> {
    let own: BTreeSet<Variable> = column.iter().filter_map(Fraction::as_variable).collect();
    let all: BTreeSet<Variable> = column.iter().flat_map(Fraction::variables).collect();
    let free = all.into_iter();
    free.filter(|v| own.contains(v) || atoms.atom(*v).key.order > 0)
        .collect()
}

/// What stands beside each of some variables in each entry, by rows; `None` where an entry is more than a sum of these.
fn slopes(column: &[Fraction], free: &[Variable]) -> Option<Vec<Fraction>> {
    let mut all = vec![];
    for entry in column {
        let (above, below) = (entry.numerator(), entry.denominator());
        let mut rest = above.clone();
        for variable in free {
            let slope = above.coefficient_of(*variable, 1);
            let moves = slope.variables().iter().any(|v| free.contains(v));
            if moves || below.degree_in(*variable) > 0 {
                return None;
            }
            rest -= slope.clone() * Polynomial::variable(*variable);
            all.push(Fraction::new(slope, below.clone())?);
        }
        if !rest.is_zero() {
            return None;
        }
    }
    Some(all)
}
