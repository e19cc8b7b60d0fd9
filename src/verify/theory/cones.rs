//! Angles that the angular momentum or the angular velocity makes with the axis of symmetry: their sine and cosine are
//! those of the triangle of the transverse and the axial part.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::Function;
use crate::verify::theory::Theory;
use crate::verify::values::atoms::{Atom, Atoms};
use crate::verify::values::quantity::Quantity;
use num_traits::{One, Zero};

impl Theory {
    /// Sine and cosine of an angle that words call that of a vector with the axis; `None` for any other, and where the
    /// body is not symmetric or turns by this angle.
    pub(crate) fn cone(&mut self, angle: Variable) -> Option<(Fraction, Fraction)> {
        let (quantity, named) = *self.cones.get(&angle)?;
        let vector = self.normals_of(quantity);
        let rate = self.normals_of(Quantity::AngularVelocity);
        let (momentum, wheels) = (quantity == Quantity::Momentum, self.setting.gyrostat);
        let [axial, first, second] = match momentum && wheels {
            true => across(&vector, &rate)?,
            false => self.symmetry()?,
        };
        if named.is_some_and(|named| usize::from(named) != axial) {
            return None;
        }
        let turns = |f: &Fraction| {
            let mut inside = f.variables().into_iter();
            inside.any(|v| wraps(&self.atoms, v, angle))
        };
        if vector.iter().any(turns) {
            return None;
        }
        let inertia = self.atoms.quantity(Quantity::Inertia);
        let moment = self.atoms.value(inertia, first as u8, 0);
        let factor = match quantity {
            Quantity::Momentum if wheels => vector[first].clone() / rate[first].clone(),
            Quantity::Momentum => self.normal(&moment),
            _ => Fraction::one(),
        };
        let along = |at: usize| (vector[at].clone() - factor.clone() * rate[at].clone()).is_zero();
        if !along(first) || !along(second) {
            return None;
        }
        let square = |f: &Fraction| f.clone() * f.clone();
        let whole = vector
            .iter()
            .fold(Fraction::zero(), |sum, part| sum + square(part));
        let across = self.root(square(&rate[first]) + square(&rate[second]));
        let length = self.root(whole);
        if length.is_zero() {
            return None;
        }
        Some((
            factor * across / length.clone(),
            vector[axial].clone() / length,
        ))
    }

    /// The axis about which the moments of inertia are equal, and the other two.
    pub(crate) fn symmetry(&mut self) -> Option<[usize; 3]> {
        let inertia = self.atoms.quantity(Quantity::Inertia);
        let moments = [0, 1, 2].map(|c| self.atoms.value(inertia, c, 0));
        let moments = moments.map(|moment| self.normal(&moment));
        let axes = [[2, 0, 1], [0, 1, 2], [1, 2, 0]];
        axes.into_iter()
            .find(|[_, a, b]| (moments[*a].clone() - moments[*b].clone()).is_zero())
    }

    fn normals_of(&mut self, quantity: Quantity) -> [Fraction; 3] {
        let entity = self.atoms.quantity(quantity);
        [0, 1, 2].map(|c| {
            let part = self.atoms.value(entity, c, 0);
            self.normal(&part)
        })
    }

    fn root(&mut self, square: Fraction) -> Fraction {
        match square.to_rational().and_then(|r| r.exact_sqrt()) {
            Some(root) => crate::verify::values::lower::constant(root),
            None => {
                let root = self.kernel(Function::Sqrt, square);
                self.normal(&root)
            }
        }
    }
}

/// The axis of wheels in a body that is symmetric about it, and the other two: the momentum across the axis is a multiple of
/// the angular velocity, and along it is not.
fn across(momentum: &[Fraction; 3], rate: &[Fraction; 3]) -> Option<[usize; 3]> {
    let turning: Vec<Variable> = rate.iter().flat_map(Fraction::variables).collect();
    let axes = [[2, 0, 1], [0, 1, 2], [1, 2, 0]];
    axes.into_iter().find(|&[axial, first, second]| {
        if rate[first].is_zero() {
            return false;
        }
        let factor = momentum[first].clone() / rate[first].clone();
        let lies = |at: usize| (momentum[at].clone() - factor.clone() * rate[at].clone()).is_zero();
        let moment = factor.variables().iter().all(|v| !turning.contains(v));
        moment && lies(second) && !lies(axial)
    })
}

/// Whether a variable is a function of another.
fn wraps(atoms: &Atoms, kernel: Variable, angle: Variable) -> bool {
    matches!(atoms.atom(kernel), Atom::Kernel { .. })
        && atoms.with_arguments(kernel).contains(&angle)
}
