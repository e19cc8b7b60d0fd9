//! Lines that hand over what a body is like: the form of its inertia matrix, a relation of its moments.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::lines::given::INPUTS;
use crate::verify::lines::line::Read;
use crate::verify::values::atoms::{Atom, Owner};
use crate::verify::values::quantity::Quantity;
use crate::verify::words::book::{has_any, lowered};
use num_traits::Zero;
use std::collections::BTreeSet;

impl Checker<'_> {
    /// `J = [[J_x, 0, …], …]`: the entries are its own, or a zero in the place of a product.
    pub(crate) fn is_form_of_inertia(&mut self, read: &Read) -> bool {
        let [equation] = read.equations.as_slice() else {
            return false;
        };
        let (left, right) = (equation.left.entries.iter(), &equation.right.entries);
        // A zero stands on both sides of the diagonal.
        let mirrored = |at: usize| at % 3 * 3 + at / 3;
        let lone = |at: usize| {
            let zero = |at: usize| right.get(at).is_some_and(Zero::is_zero);
            zero(at) != zero(mirrored(at))
        };
        equation.left.rows == 3
            && equation.left.columns == 3
            && !(0..9).any(lone)
            && left.zip(&equation.right.entries).all(|(own, written)| {
                written.is_zero() || (own.clone() - written.clone()).is_zero()
            })
    }

    /// `J = [[A, 0, -E], …]` in symbols that nothing is said of before: it names the entries, whatever they are made of.
    pub(crate) fn names_entries_anew(&mut self, sides: &[Node], read: &Read) -> bool {
        let ([left, _], [equation]) = (sides, read.equations.as_slice()) else {
            return false;
        };
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        let right = &equation.right.entries;
        if self.entities([left]) != [inertia] || right.len() != 9 {
            return false;
        }
        let entries = (0..9).map(|at| (&right[at], &right[at % 3 * 3 + at / 3]));
        let mut named = BTreeSet::new();
        let new = entries.into_iter().all(|(entry, mirrored)| {
            let symbol = entry
                .as_variable()
                .or_else(|| (-entry.clone()).as_variable());
            named.extend(symbol);
            let owner = symbol.and_then(|v| self.theory.atoms.owner(v));
            let entity = symbol.and_then(|v| self.theory.atoms.entity_of(v));
            let new = matches!(owner, Some(Owner::Symbol(_)))
                && entity.is_some_and(|entity| !self.theory.mentions_entity(entity));
            entry == mirrored && (entry.is_zero() || new)
        });
        new && named.len() > 2
    }

    /// `I = μ[[8, -3, -3], …]` where lines before give some of the entries: these agree, and the rest is handed over.
    pub(crate) fn fills_in_inertia(&mut self, sides: &[Node], read: &Read) -> bool {
        let ([left, _], [equation]) = (sides, read.equations.as_slice()) else {
            return false;
        };
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        if self.entities([left]) != [inertia] || equation.left.entries.len() != 9 {
            return false;
        }
        let mut free = false;
        let (lefts, rests) = (&equation.left.entries, &equation.residual.entries);
        let agrees = lefts.iter().zip(rests).all(|(left, rest)| {
            let open =
                |f: &Fraction| f.as_variable().is_some() || (-f.clone()).as_variable().is_some();
            let (left, rest) = (self.theory.normal(left), self.theory.normal(rest));
            free |= open(&left);
            rest.is_zero() || open(&left)
        });
        let written = equation.right.entries.iter().flat_map(Fraction::variables);
        let own = |v: u32| self.theory.atoms.entity_of(v) == Some(inertia);
        agrees && free && !written.into_iter().any(own)
    }

    /// Whether a side is made of moments of inertia and rates that nothing determines, more than one: `(C - A)/A`.
    pub(crate) fn is_data_of_inputs(&mut self, side: &Node) -> bool {
        if matches!(inner(side).kind, Kind::Symbol(_)) {
            return false;
        }
        let Ok(value) = self.lowering(Frame::Moving).value(side) else {
            return false;
        };
        let inputs = |entry: &Fraction| {
            let variables = entry.variables().into_iter();
            let mut inside = variables.flat_map(|v| self.theory.atoms.with_arguments(v));
            inside.all(|v| {
                let owner = self.theory.atoms.owner(v);
                matches!(owner, Some(Owner::Quantity(q, _)) if INPUTS.contains(q))
            })
        };
        let known = value.entries.iter().all(inputs);
        known
            && value.entries.iter().all(|entry| {
                !entry.variables().is_empty()
                    && self.theory.normal(entry).variables() == entry.variables()
            })
    }

    /// Whether a line sets one moment of inertia equal to the sum of two others, as they are of a lamina: C = A + B.
    pub(crate) fn narrows_the_body(&mut self, sides: &[Node], read: &Read) -> bool {
        let ([left, _], [equation]) = (sides, read.equations.as_slice()) else {
            return false;
        };
        let (Kind::Symbol(_), [residual]) =
            (&inner(left).kind, equation.residual.entries.as_slice())
        else {
            return false;
        };
        let said = self.theory.normal(residual);
        // With more in it, a line says more.
        if self.is_ratio_of_moments(&said) && self.is_ratio_of_moments(residual) {
            return true;
        }
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        let [x, y, z] = [0, 1, 2].map(|c| self.theory.atoms.value(inertia, c, 0));
        // Of moments that all have their values, it is a claim.
        let free = |moment: &Fraction| self.theory.normal(moment).as_variable().is_some();
        if ![&x, &y, &z].into_iter().any(free) {
            return false;
        }
        let sums = [
            z.clone() - x.clone() - y.clone(),
            x.clone() - y.clone() - z.clone(),
            y - z - x,
        ];
        sums.iter().any(|sum| {
            let flat = self.theory.normal(sum);
            let own = flat.variables().len() > 1;
            own && ((said.clone() - flat.clone()).is_zero() || (said.clone() + flat).is_zero())
        })
    }

    /// Whether a difference is that of one moment of inertia and so many times another, `I_3 - 2 I_1`, both free.
    fn is_ratio_of_moments(&self, said: &Fraction) -> bool {
        let moment = |v: Variable| {
            let part = matches!(
                self.theory.atoms.atom(v),
                Atom::Part {
                    component: 0..3,
                    order: 0,
                    ..
                }
            );
            part && matches!(
                self.theory.atoms.owner(v),
                Some(Owner::Quantity(Quantity::Inertia, _))
            )
        };
        let terms = said.numerator().terms();
        let [(first, one), (second, other)] = terms else {
            return false;
        };
        let linear = [first, second]
            .iter()
            .all(|monomial| monomial.degree() == 1);
        linear
            && one.is_negative() != other.is_negative()
            && said.variables().into_iter().all(moment)
    }

    /// Whether a line says so, and its sentence speaks of a flat body.
    pub(crate) fn is_said_of_a_lamina(&mut self, sides: &[Node], read: &Read) -> bool {
        let text = lowered(&self.sentence);
        let flat = has_any(&text, &["thin", "lamina", "flat"]);
        flat && self.narrows_the_body(sides, read)
    }
}
