//! What a world must satisfy besides laws and solved premises: the relations that are kept, with their rates.

use crate::algebra::{Fraction, Polynomial, Variable};
use crate::notation::ast::Function;
use crate::verify::theory::attitude_law::number_of_quaternion;
use crate::verify::theory::kept::Relations;
use crate::verify::theory::{HIGHEST_ORDER, Theory};
use crate::verify::values::atoms::{Atom, Entity, Owner};
use crate::verify::values::quantity::Quantity;
use num_traits::Zero;
use std::collections::BTreeSet;
use std::sync::Arc;

/// Relations that hang together by their variables.
#[derive(Clone, Debug, Default)]
pub(crate) struct Variety {
    /// What vanishes, every rule put in: relations, their rates, squares of roots and sines.
    pub(crate) relations: Vec<Polynomial>,
    /// The relations as written, and their rates.
    pub(crate) written: Vec<Fraction>,
    /// The variables that stand in them.
    pub(crate) variables: BTreeSet<Variable>,
    /// Those that no relation is solved for: time, functions of angles and what they are functions of.
    pub(crate) drawn: BTreeSet<Variable>,
    /// What it speaks of, where it is beyond the budget: no world is known to be on it.
    pub(crate) missed: BTreeSet<Entity>,
}

/// Terms of a relation that worlds are made to satisfy.
const MOST_TERMS: usize = 200;
/// Terms of a relation whose rates are followed, with those of what stands under its roots.
const MOST_TERMS_OF_A_RATE: usize = 40;
/// Rates of one relation that are followed.
const MOST_RATES: u8 = 3;

impl Theory {
    /// Makes the worlds of some fractions satisfy the rates of relations up to the order that stands in them.
    pub(crate) fn follow_rates(&mut self, fractions: &[Fraction]) {
        if self.solution.relations.kept.is_empty() {
            return;
        }
        let mut order = 0;
        for fraction in fractions {
            let normal = self.normal(fraction);
            order = self.highest_rate(&normal).max(order);
        }
        let order = order.min(HIGHEST_ORDER);
        if order > self.solution.relations.order {
            self.solution.relations.order = order;
            self.solution.relations.forget();
        }
    }

    /// The order of the rate that a variable is.
    pub(crate) fn order_of(&self, variable: Variable) -> u8 {
        match self.atoms.atom(variable) {
            Atom::Part { order, .. } => *order,
            Atom::SpaceRate { .. } => 1,
            Atom::Kernel { .. } | Atom::Opaque { .. } => 0,
        }
    }

    /// The kept relations, those that hang together in one.
    pub(crate) fn varieties(&mut self) -> Arc<[Variety]> {
        if let Some(known) = &self.solution.relations.varieties {
            return known.clone();
        }
        let Relations { kept, order, .. } = self.solution.relations.clone();
        let normals: Vec<Fraction> = kept.iter().map(|k| self.normal(&k.written)).collect();
        let orders: Vec<u8> = normals.iter().map(|n| self.highest_rate(n)).collect();
        let highest = orders.iter().copied().fold(order, u8::max);
        let mut found: Vec<Variety> = vec![];
        for ((kept, normal), order) in kept.into_iter().zip(normals).zip(orders) {
            let rates = match self.is_momentary(&kept) {
                true => 0,
                false => (highest - order).max(1),
            };
            let mut written = kept.written;
            if rates > MOST_RATES || self.is_heavy(&normal, rates > 0) {
                let mut variety = self.variety(normal.numerator(), written);
                variety.missed = self.entities(&variety.variables);
                join(&mut found, variety);
                continue;
            }
            join(
                &mut found,
                self.variety(normal.numerator(), written.clone()),
            );
            for _ in 0..rates {
                written = self.atoms.derivative(&written);
                let normal = self.normal(&written);
                if !normal.is_zero() {
                    join(
                        &mut found,
                        self.variety(normal.numerator(), written.clone()),
                    );
                }
            }
        }
        let found: Arc<[Variety]> = found.into();
        self.solution.relations.varieties = Some(found.clone());
        found
    }

    /// The highest order of a rate in a fraction.
    pub(crate) fn highest_rate(&self, fraction: &Fraction) -> u8 {
        let variables = fraction.variables().into_iter();
        variables.map(|v| self.order_of(v)).max().unwrap_or(0)
    }

    /// Whether a relation has more terms than is worth while, with those of what stands in its functions.
    pub(crate) fn is_heavy(&self, relation: &Fraction, with_rates: bool) -> bool {
        let inside = relation
            .variables()
            .into_iter()
            .map(|v| match self.atoms.atom(v) {
                Atom::Kernel { argument, .. } => argument.numerator().len(),
                _ => 0,
            });
        let most = if with_rates {
            MOST_TERMS_OF_A_RATE
        } else {
            MOST_TERMS
        };
        relation.numerator().len() + inside.sum::<usize>() > most
    }

    fn entities(&self, variables: &BTreeSet<Variable>) -> BTreeSet<Entity> {
        let entity = |&v: &Variable| self.atoms.entity_of(v);
        variables.iter().filter_map(entity).collect()
    }

    /// One relation with the squares of the functions in it.
    fn variety(&mut self, relation: &Polynomial, written: Fraction) -> Variety {
        let relation = relation.divided_by(&self.content(relation));
        let mut variety = Variety {
            relations: vec![relation.clone()],
            written: vec![written],
            ..Variety::default()
        };
        let mut open = relation.variables();
        while let Some(variable) = open.pop() {
            if !variety.variables.insert(variable) {
                continue;
            }
            if let Atom::Kernel { function, argument } = self.atoms.atom(variable).clone()
                && let Some(square) = self.kernel_square(variable)
            {
                let root = Polynomial::variable(variable);
                let power = square.denominator().clone() * root.clone() * root;
                let relation = power - square.numerator().clone();
                open.extend(relation.variables());
                variety.relations.push(relation);
                if function == Function::Sqrt {
                    open.extend(argument.denominator().variables());
                }
            }
            open.extend(self.drawn_with(variable));
            self.note_drawn(variable, &mut variety.drawn);
        }
        variety
    }

    /// Variables that get their values together with one: the sine with the cosine, the numbers of a unit quaternion.
    fn drawn_with(&mut self, variable: Variable) -> Vec<Variable> {
        if let Some((entity, _)) = number_of_quaternion(&self.atoms, variable) {
            return (0..4).map(|i| self.atoms.part(entity, i, 0)).collect();
        }
        match self.atoms.atom(variable).clone() {
            Atom::Kernel {
                function: Function::Cos,
                argument,
            } => {
                let function = Function::Sin;
                vec![self.atoms.special(Atom::Kernel { function, argument })]
            }
            _ => vec![],
        }
    }

    fn note_drawn(&mut self, variable: Variable, drawn: &mut BTreeSet<Variable>) {
        let time = Owner::Quantity(Quantity::Time, String::new());
        match self.atoms.atom(variable) {
            Atom::Part { entity, .. } => {
                let is_time = self.atoms.info(*entity).owner == time;
                if is_time || number_of_quaternion(&self.atoms, variable).is_some() {
                    drawn.insert(variable);
                }
            }
            Atom::Kernel { function, argument } => {
                if *function != Function::Sqrt {
                    drawn.insert(variable);
                    drawn.extend(argument.variables());
                }
            }
            _ => {
                drawn.insert(variable);
            }
        }
    }
}

/// Adds a variety to others, those that hang together with it in one.
fn join(found: &mut Vec<Variety>, mut new: Variety) {
    let hangs = |v: &Variety| !v.variables.is_disjoint(&new.variables);
    let (joined, apart): (Vec<_>, Vec<_>) = found.drain(..).partition(hangs);
    *found = apart;
    for other in joined {
        let fresh = |p: &Polynomial| !new.relations.contains(p);
        let more: Vec<_> = other.relations.into_iter().filter(fresh).collect();
        new.relations.extend(more);
        new.written.extend(other.written);
        new.variables.extend(other.variables);
        new.drawn.extend(other.drawn);
        new.missed.extend(other.missed);
    }
    found.push(new);
}
