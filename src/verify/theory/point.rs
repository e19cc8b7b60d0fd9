//! Points that satisfy the relations that are kept.
//!
//! Variables are drawn one after the other, and as soon as a relation has one unknown it is solved for it, where it is
//! linear or quadratic; a world in which a relation is not met in the end is given up.

use crate::algebra::{Fraction, Polynomial, Variable};
use crate::notation::ast::Function;
use crate::verify::theory::attitude_law::number_of_quaternion;
use crate::verify::theory::kept::Point;
use crate::verify::theory::variety::Variety;
use crate::verify::theory::world::{Kind, Substance, World};
use crate::verify::values::atoms::Atom;
use std::cmp::Reverse;

/// Terms of a relation that worlds are made to satisfy.
const MOST_TERMS: usize = 200;

impl<T: Substance> World<'_, T> {
    /// Puts the world on the variety that a variable belongs to, if it belongs to one; `None` where that fails.
    pub(crate) fn settle(&mut self, variable: Variable) -> Option<()> {
        if self.theory.solution.relations.kept.is_empty() {
            return Some(());
        }
        let varieties = self.theory.varieties();
        let Some(index) = varieties
            .iter()
            .position(|v| v.variables.contains(&variable) || self.is_missed(v, variable))
        else {
            return Some(());
        };
        if !self.drawn.settled.insert(index) {
            return Some(());
        }
        let key = (index, self.seed);
        let known = T::recall(&self.theory.solution.relations, key);
        let point = known.unwrap_or_else(|| {
            let point = self.point(&varieties[index]);
            T::remember(&mut self.theory.solution.relations, key, &point);
            point
        });
        self.lost |= point.is_none();
        for (variable, value) in point?.iter() {
            self.keep(*variable, value.clone());
        }
        Some(())
    }

    fn is_missed(&self, variety: &Variety, variable: Variable) -> bool {
        let entity = self.theory.atoms.entity_of(variable);
        entity.is_some_and(|entity| variety.missed.contains(&entity))
    }

    /// A point of a variety, the same for a seed wherever the world comes to need it.
    fn point(&mut self, variety: &Variety) -> Point<T> {
        // What another variety gives falls out of these relations: it is not settled again.
        let settled = self.drawn.settled.clone();
        let mut world: World<'_, T> = World::new(self.theory, self.seed);
        world.drawn.settled = settled;
        world.meet(variety)?;
        let value = |&v: &Variable| Some((v, world.value(v)?));
        let point = variety.variables.iter().map(value).collect();
        let solved = world.drawn.solved;
        self.drawn.solved.extend(solved);
        point
    }

    fn meet(&mut self, variety: &Variety) -> Option<()> {
        let large = |p: &Polynomial| p.len() > MOST_TERMS;
        if !variety.missed.is_empty() || variety.relations.iter().any(large) {
            return None;
        }
        let mut pending: Vec<(&Polynomial, Vec<Variable>)> = variety
            .relations
            .iter()
            .map(|p| (p, p.variables()))
            .collect();
        let mut order: Vec<Variable> = variety.variables.iter().copied().collect();
        order.sort_by_cached_key(|&v| self.rank(variety, v));
        self.propagate(variety, &mut pending)?;
        for variable in order {
            if !self.is_known(variable) {
                self.draw_on_variety(variable)?;
                self.propagate(variety, &mut pending)?;
            }
        }
        let met = |w: &Fraction| self.fraction(w).is_some_and(|value| value.is_zero());
        variety.written.iter().all(met).then_some(())
    }

    /// Solves every relation that has one unknown left, and holds those without against their values.
    fn propagate(
        &mut self,
        variety: &Variety,
        pending: &mut Vec<(&Polynomial, Vec<Variable>)>,
    ) -> Option<()> {
        loop {
            for (_, variables) in pending.iter_mut() {
                variables.retain(|&v| !self.is_known(v));
            }
            let free = |v: &Variable| !variety.drawn.contains(v);
            let place = pending
                .iter()
                .position(|(_, unknown)| match unknown.as_slice() {
                    [] => true,
                    [only] => free(only),
                    _ => false,
                });
            let Some(place) = place else { return Some(()) };
            let (relation, unknown) = pending.remove(place);
            match unknown.first() {
                Some(&variable) => self.solve_for(relation, variable)?,
                None => self.polynomial(relation)?.is_zero().then_some(())?,
            }
        }
    }

    /// Gives a variable the value that makes a relation vanish.
    fn solve_for(&mut self, relation: &Polynomial, variable: Variable) -> Option<()> {
        let degree = relation.degree_in(variable);
        if degree > 2 {
            return None;
        }
        let mut coefficient = |power| self.polynomial(&relation.coefficient_of(variable, power));
        let (c, b, a) = (coefficient(0)?, coefficient(1)?, coefficient(2)?);
        let value = if !a.is_zero() {
            let two = T::one() + T::one();
            let square = b.clone() * b.clone() - (two.clone() + two.clone()) * a.clone() * c;
            let root = square.root()?;
            let signed = match self.chance() & 1 {
                1 => -root.clone(),
                _ => root.clone(),
            };
            let below = two * a;
            let value = (signed.clone() - b.clone()) / below.clone();
            match self.suits(variable, &value) {
                true => value,
                false => (-signed - b) / below,
            }
        } else if !b.is_zero() {
            -c / b
        } else {
            // The relation no longer speaks of the variable.
            return c.is_zero().then_some(());
        };
        self.suits(variable, &value).then_some(())?;
        self.drawn.solved.insert(variable);
        self.keep(variable, value);
        Some(())
    }

    /// Whether a value can be that of a variable: lengths, moments and masses are not negative.
    fn suits(&self, variable: Variable, value: &T) -> bool {
        match self.theory.atoms.atom(variable) {
            Atom::Kernel { .. } => !value.is_negative(),
            _ => self.kind(variable) != Kind::Positive || !(value.is_negative() || value.is_zero()),
        }
    }

    /// What is drawn first: angles and time, then lengths (in every second world last), then bodies, then the rest,
    /// low rates and high powers first.
    fn rank(&self, variety: &Variety, variable: Variable) -> (u8, u8, Reverse<u32>, Variable) {
        let class = match self.theory.atoms.atom(variable) {
            _ if variety.drawn.contains(&variable) => 0,
            Atom::Kernel { .. } if self.seed.is_multiple_of(2) => 9,
            Atom::Kernel { .. } => 1,
            _ if self.kind(variable) == Kind::Positive => 2,
            _ => 3,
        };
        let order = match self.theory.atoms.atom(variable) {
            Atom::Part { order, .. } => *order,
            _ => 0,
        };
        let degree = variety
            .relations
            .iter()
            .map(|p| p.degree_in(variable))
            .max();
        (class, order, Reverse(degree.unwrap_or(0)), variable)
    }

    fn draw_on_variety(&mut self, variable: Variable) -> Option<()> {
        let root = matches!(
            self.theory.atoms.atom(variable),
            Atom::Kernel {
                function: Function::Sqrt,
                ..
            }
        );
        let value = match self.kind(variable) {
            _ if root => T::draw(Kind::Positive, self.chance()),
            Kind::Any | Kind::Signed if self.seed % 4 > 1 && self.is_plain(variable) => {
                // Points of a sphere with small coordinates: (1, 2, 2)/3, (2, 3, 6)/7.
                let below = [1, 3, 5, 7][(self.seed / 4 % 4) as usize];
                T::draw(Kind::Over(below), self.chance())
            }
            _ => self.free(variable)?,
        };
        self.keep(variable, value);
        Some(())
    }

    fn is_plain(&self, variable: Variable) -> bool {
        let part = matches!(self.theory.atoms.atom(variable), Atom::Part { .. });
        part && number_of_quaternion(&self.theory.atoms, variable).is_none()
    }

    /// Whether no function was drawn whose argument a relation gave: its value would have nothing to do with that.
    pub(crate) fn is_coherent(&self) -> bool {
        let count = self.theory.atoms.count() as Variable;
        (0..count)
            .filter(|&v| self.is_known(v))
            .all(|v| match self.theory.atoms.atom(v) {
                Atom::Kernel { function, argument } if *function != Function::Sqrt => argument
                    .variables()
                    .iter()
                    .all(|v| !self.drawn.solved.contains(v)),
                _ => true,
            })
    }
}
