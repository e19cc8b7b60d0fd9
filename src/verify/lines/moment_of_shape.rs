//! Moments of inertia that no shape has: of a uniform body that the words name they are its mass times squares of its
//! sizes, each by one of a few numbers (R. C. Hibbeler, *Engineering Mechanics: Dynamics*, inside back cover).

use crate::algebra::{Fraction, Rational, Variable};
use crate::verify::check::Checker;
use crate::verify::lines::line::Read;
use crate::verify::values::atoms::Owner;
use crate::verify::values::quantity::Quantity;

/// Words for a shape, and its numbers about the axes through its centre and its border, by its half and whole sizes.
type Shapes = [(&'static [&'static str], &'static [(i64, i64)])];

const SHAPES: &Shapes = &[
    (
        &["sphere", "ball"],
        &[(2, 5), (7, 5), (2, 3), (5, 3), (1, 10), (1, 6)],
    ),
    (&["shell"], &[(2, 3), (5, 3), (1, 2)]),
    (
        &["disc", "disk", "cylinder", "roller"],
        &[(1, 2), (3, 2), (5, 4), (1, 8), (1, 16), (1, 12), (1, 3)],
    ),
    (&["rod", "bar", "stick"], &[(1, 12), (1, 3), (4, 3)]),
    (
        &["plate", "lamina"],
        &[(1, 12), (1, 3), (1, 6), (2, 3), (4, 3), (1, 2)],
    ),
    (&["hoop", "ring"], &[(1, 2), (3, 2), (2, 1)]),
    (&["cone"], &[(3, 10), (3, 20), (3, 80), (3, 5)]),
    (
        &["cube", "cuboid", "box", "block", "brick"],
        &[(1, 12), (1, 3), (1, 6), (2, 3), (4, 3), (8, 3)],
    ),
    (&["ellipsoid"], &[(1, 5), (1, 20)]),
];
/// Numbers of parallel axes at a size or half of it.
const PARALLEL: &[(i64, i64)] = &[(1, 1), (1, 4)];

impl Checker<'_> {
    /// Whether a moment of inertia is given by a mass and sizes with a number that no shape has that the words name.
    pub(crate) fn is_no_moment_of_its_shape(&self, read: &Read) -> bool {
        let moment = |entry: &Fraction| {
            let lone = entry.as_variable();
            lone.is_some_and(|v| self.belongs_to(v, Quantity::Inertia))
        };
        let mut equations = read.equations.iter();
        let right = equations.find(|e| e.left.entries.iter().any(moment));
        let Some(right) = right.and_then(|e| e.right.as_scalar()) else {
            return false;
        };
        let size = |v: &Variable| matches!(self.theory.atoms.owner(*v), Some(Owner::Symbol(_)));
        let mass = |v: &Variable| self.belongs_to(*v, Quantity::Mass);
        let variables = right.variables();
        let told = variables.iter().any(mass) && variables.iter().all(|v| mass(v) || size(v));
        let known = self.numbers_of_shapes();
        let mut terms = right.numerator().terms().iter();
        told && right.is_polynomial()
            && !known.is_empty()
            && terms.any(|(_, number)| !known.contains(number))
    }

    /// The numbers of the shapes that the words name; none where they name no shape.
    fn numbers_of_shapes(&self) -> Vec<Rational> {
        let words = || self.text.lower().split(|c: char| !c.is_alphabetic());
        let named =
            |shape: &str| words().any(|word| word.strip_suffix('s').unwrap_or(word) == shape);
        let shapes = SHAPES
            .iter()
            .filter(|(names, _)| names.iter().any(|name| named(name)));
        let numbers: Vec<(i64, i64)> = shapes.flat_map(|(_, numbers)| *numbers).copied().collect();
        let parallel = PARALLEL.iter().filter(|_| !numbers.is_empty());
        let all = numbers.iter().chain(parallel);
        all.map(|&ratio| Rational::from(ratio)).collect()
    }
}
