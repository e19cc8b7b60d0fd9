//! Bounds of angles: what they say of the signs of sines and cosines.

use crate::algebra::{Fraction, Rational};
use crate::notation::print::latex;
use crate::verify::language::statement::{Declaration, Extent, Formula, Statement};
use crate::verify::model::atoms::{Key, Space};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{node_of, reach_of};
use num_traits::Zero;

/// Where in half turns the sine and the cosine of an angle are positive.
const POSITIVE: [[(i64, i64); 2]; 2] = [[(0, 1), (1, 1)], [(-1, 2), (1, 2)]];

impl Builder<'_> {
    /// "`$\\theta$` lies between `$0$` and `$\\pi/2$`": neither its sine nor its cosine vanishes.
    ///
    /// What other letters are may hang on that: it is read of each angle as soon as a sentence has told it. The sentences
    /// of those that none has told yet are left.
    pub(super) fn read_bounds<'d>(
        &mut self,
        of: impl IntoIterator<Item = &'d Declaration>,
    ) -> Vec<&'d Declaration> {
        let mut left = vec![];
        for declaration in of {
            let Statement::Bounds {
                subject,
                lower,
                upper,
            } = &declaration.statement
            else {
                continue;
            };
            if !self.is_known_letter(subject, declaration) {
                left.push(declaration);
                continue;
            }
            let mut value = |formula| self.scalar_of(formula, declaration);
            if let (Some(angle), Some(lower), Some(upper)) =
                (value(subject), value(lower), value(upper))
            {
                self.bound_angle(&angle, [lower, upper], declaration);
            }
        }
        left
    }

    /// Whether a sentence has told or used a letter so far.
    fn is_known_letter(&self, letter: &Formula, declaration: &Declaration) -> bool {
        let key = |node| Key {
            space: Space::Unknown,
            ..Key::new(latex(node))
        };
        let used = node_of(letter).map(key);
        let used = used.is_some_and(|key| self.reading.system.atoms.find(&key).is_some());
        used || self.quantity_of(letter, declaration).is_some()
    }

    fn scalar_of(&mut self, formula: &Formula, declaration: &Declaration) -> Option<Fraction> {
        let value = self.mentioned_value(formula, declaration)?;
        value.to_scalar().ok()
    }

    fn bound_angle(&mut self, angle: &Fraction, ends: [Fraction; 2], declaration: &Declaration) {
        let ends = ends.map(|end| self.half_turns(&end));
        let [Some(lower), Some(upper)] = ends else {
            return;
        };
        let Some((cosine, sine)) = self.system().atoms.cosine_sine(angle) else {
            return;
        };
        for (function, [least, most]) in [sine, cosine].into_iter().zip(POSITIVE) {
            let within = |turns: i64| {
                let moved = |(p, q): (i64, i64)| Rational::from((p + turns * q, q));
                lower >= moved(least) && upper <= moved(most)
            };
            let whole = declaration.extent == Extent::Document;
            if whole && (within(1) || within(-1)) {
                self.system().atoms.tell_sign(&function, true);
            }
            if !within(0) {
                continue;
            }
            if whole {
                self.system().atoms.set_positive(&function);
            }
            let order = (reach_of(&declaration.extent), function);
            self.reading.sizes.orders.push(order);
        }
    }

    /// How many times π a value is.
    fn half_turns(&mut self, value: &Fraction) -> Option<Rational> {
        if value.is_zero() {
            return Some(Rational::zero());
        }
        let pi = self.system().atoms.pi();
        (value.clone() / pi).to_rational()
    }
}
