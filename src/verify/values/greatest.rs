//! The greatest size of what oscillates by an explicit sine or cosine of the time: `\max|G| = a` for `G = a\cos kt`.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Function, Kind, Node};
use crate::verify::letters::usage::inner;
use crate::verify::values::atoms::{Atom, Owner};
use crate::verify::values::lower::Lowering;
use crate::verify::values::quantity::Quantity;
use num_traits::Zero;

impl Lowering<'_> {
    /// The amplitude of such a value; `None` where it varies in another way.
    pub(crate) fn greatest(&mut self, argument: &Node) -> Option<Fraction> {
        let inside = match &inner(argument).kind {
            Kind::Norm(inside) | Kind::Function(Function::Abs, inside) => inside,
            _ => return None,
        };
        let value = self.scalar(inside)?;
        let value = self.theory.normal(&value);
        let moving: Vec<Variable> = value
            .variables()
            .into_iter()
            .filter(|&v| self.runs(v))
            .collect();
        let [wave] = moving[..] else { return None };
        let harmonic = matches!(
            self.theory.atoms.atom(wave),
            Atom::Kernel {
                function: Function::Sin | Function::Cos,
                ..
            }
        );
        let above = value.numerator();
        let alone = above.degree_in(wave) == 1 && above.coefficient_of(wave, 0).is_zero();
        let below = value.denominator().degree_in(wave) == 0;
        if !(harmonic && alone && below) {
            return None;
        }
        let amplitude = Fraction::from(above.coefficient_of(wave, 1));
        self.kernel(
            Function::Abs,
            amplitude / Fraction::from(value.denominator().clone()),
        )
    }

    /// Whether the time stands in a variable.
    fn runs(&self, variable: Variable) -> bool {
        let inside = self.theory.atoms.with_arguments(variable);
        inside.into_iter().any(|v| {
            let owner = self.theory.atoms.owner(v);
            matches!(owner, Some(Owner::Quantity(Quantity::Time, _)))
        })
    }
}
