//! The inertia about a point from the one about the mass centre, and with it the angular momentum about that point and the
//! velocity of the mass centre of a body that turns about it.

use crate::algebra::{Fraction, Variable};
use crate::mechanics;
use crate::mechanics::Products;
use crate::notation::ast::{Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::two_points::TwoPoints;
use crate::verify::theory::Premise;
use crate::verify::theory::law::{INERTIA_ENTRIES, Setting, tensor, vector};
use crate::verify::values::about_point::tensor_about;
use crate::verify::values::atoms::{Atoms, Entity, Owner, variable_fraction};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::symbol::Meaning;
use nalgebra::Vector3;
use num_traits::Zero;

/// The name of the law.
const NAME: &str = "parallel-axis";

/// Two tensors or two moments, about the mass centre and about another point or an axis through it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ParallelAxes {
    centre: Entity,
    other: Entity,
    mass: Variable,
    /// The way from one point to the other; no variable stands for zero.
    offset: [Option<Variable>; 3],
    /// The angular momentum about the other point.
    momentum: Option<Entity>,
    /// The velocity of the mass centre.
    velocity: Option<Entity>,
    /// Whether the body turns about the other point.
    pivot: bool,
}

impl ParallelAxes {
    /// What the law connects.
    pub(crate) fn entities(self, atoms: &Atoms) -> Vec<Entity> {
        let variables = self.offset.into_iter().flatten().chain([self.mass]);
        let named = variables.filter_map(|v| atoms.entity_of(v));
        let points = [self.centre, self.other].into_iter();
        points
            .chain(self.momentum)
            .chain(self.velocity)
            .chain(named)
            .collect()
    }

    /// What is a length in the offset of the points.
    pub(crate) fn distances(self, atoms: &Atoms) -> Vec<Entity> {
        let offset = self.offset.into_iter().flatten();
        offset.filter_map(|v| atoms.entity_of(v)).collect()
    }

    /// The moments or tensors that it relates.
    pub(crate) fn inertias(self) -> [Entity; 2] {
        [self.centre, self.other]
    }

    /// Whether an entity is the inertia about the mass centre.
    pub(crate) fn is_centre(self, entity: Entity) -> bool {
        self.centre == entity
    }

    fn offset(self) -> Vector3<Fraction> {
        Vector3::from(
            self.offset
                .map(|v| v.map_or_else(Fraction::zero, variable_fraction)),
        )
    }
}

/// What the law says of a component of an entity's derivative.
pub(crate) fn law(
    atoms: &mut Atoms,
    setting: Setting,
    entity: Entity,
    (component, order): (u8, u8),
) -> Option<(&'static str, Fraction)> {
    let mut pairs = setting.parallel_axes.into_iter().flatten();
    let (name, mut value) =
        pairs.find_map(|pair| at_rest(atoms, setting, pair, entity, component))?;
    for _ in 0..order {
        value = atoms.derivative(&value);
    }
    Some((name, value))
}

fn at_rest(
    atoms: &mut Atoms,
    setting: Setting,
    pair: ParallelAxes,
    entity: Entity,
    component: u8,
) -> Option<(&'static str, Fraction)> {
    let (mass, offset) = (variable_fraction(pair.mass), pair.offset());
    let at = usize::from(component);
    if entity == pair.other && atoms.info(entity).shape == Shape::Scalar {
        let own = atoms.value(pair.centre, 0, 0);
        return Some((NAME, own + mass * offset.dot(&offset)));
    }
    if entity == pair.other {
        let own = tensor(atoms, pair.centre, setting.products);
        let (row, column) = INERTIA_ENTRIES[at % 6];
        let entry = mechanics::parallel_axis(&own, &mass, &offset)[(row, column)].clone();
        let turned = row != column && setting.products == Products::Integrals;
        return Some((NAME, if turned { -entry } else { entry }));
    }
    if Some(entity) == pair.momentum {
        let own = vector(atoms, Quantity::Momentum, 0);
        let velocity = Vector3::from(atoms.vector(pair.velocity?, 0));
        let about = own + mechanics::cross(&offset, &velocity) * mass;
        return Some((NAME, about[at % 3].clone()));
    }
    if pair.pivot && Some(entity) == pair.velocity {
        let omega = vector(atoms, Quantity::AngularVelocity, 0);
        let origin = vector(atoms, Quantity::OriginVelocity, 0);
        let velocity = origin + mechanics::cross(&omega, &offset);
        return Some(("rigid", velocity[at % 3].clone()));
    }
    None
}

impl Checker<'_> {
    /// Puts the law in force where the document relates the inertia about two points.
    pub(crate) fn note_parallel_axes(&mut self) {
        let Some(points) = self.reading.points.clone() else {
            return;
        };
        let tensors = self.tensors_about(&points);
        let moments = self.moments_about(&points);
        let pairs = [tensors, moments];
        if pairs.iter().all(Option::is_none) {
            self.reading.points = None;
            self.theory.atoms.forget_meanings();
            return;
        }
        for pair in pairs.into_iter().flatten() {
            let entities = pair.entities(&self.theory.atoms);
            self.known.extend(entities);
        }
        self.theory.set(|setting| setting.parallel_axes = pairs);
        if let Some(pair) = tensors.filter(|_| self.products_vanish_at_first()) {
            self.products_vanish(pair.centre);
        }
        if let (Some(pair), Some(vector)) = (tensors, &points.vector)
            && points.coordinates.is_some()
        {
            self.coordinates_of(vector, pair);
        }
    }

    /// "The products of inertia vanish", before the axes are moved away from the mass centre.
    fn products_vanish_at_first(&self) -> bool {
        let text = self.text.lower();
        let said = ["products of inertia vanish", "products of inertia are zero"];
        let said = said.iter().filter_map(|words| text.find(words)).min();
        let moved = ["parallel-axis", "parallel axis", "parallel axes", "steiner"];
        let moved = moved.iter().filter_map(|words| text.find(words)).min();
        said.zip(moved).is_some_and(|(said, moved)| said < moved)
    }

    fn products_vanish(&mut self, tensor: Entity) {
        if self.theory.atoms.info(tensor).shape != Shape::Symmetric {
            return;
        }
        let products = [3, 4, 5].map(|c| self.theory.atoms.part(tensor, c, 0));
        self.theory.assume(Premise {
            name: "the products of inertia about the mass centre vanish".to_owned(),
            residuals: products.map(variable_fraction).to_vec(),
            preferred: products.to_vec(),
            definition: false,
        });
    }

    fn tensors_about(&mut self, points: &TwoPoints) -> Option<ParallelAxes> {
        let offset = match (&points.coordinates, &points.vector) {
            (Some(symbols), _) => symbols.each_ref().map(|s| self.number(s)),
            (None, Some(vector)) => match self.meaning_of(vector) {
                Meaning::Whole(entity) if self.theory.atoms.info(entity).shape == Shape::Vector => {
                    [0, 1, 2].map(|c| Some(self.theory.atoms.part(entity, c, 0)))
                }
                _ => return None,
            },
            (None, None) => self.place_of_centre(points.place.as_ref()?)?.map(Some),
        };
        if offset.iter().any(Option::is_none) {
            return None;
        }
        let atoms = &mut self.theory.atoms;
        let [centre, other] =
            [&points.centre, &points.other].map(|label| tensor_about(label, points, atoms));
        let mut named = |symbol: &Option<Symbol>| match symbol.as_ref().map(|s| self.meaning_of(s))
        {
            Some(Meaning::Whole(entity)) => Some(entity),
            _ => None,
        };
        let (momentum, velocity) = (named(&points.momentum), named(&points.velocity));
        let is_vector = |e: &Entity| self.theory.atoms.info(*e).shape == Shape::Vector;
        let (momentum, velocity) = (momentum.filter(is_vector), velocity.filter(is_vector));
        let mass = self.number(&points.mass)?;
        Some(ParallelAxes {
            centre,
            other,
            mass,
            offset,
            momentum,
            velocity,
            pivot: points.pivot,
        })
    }

    /// Variables for a place that words give in expressions.
    fn place_of_centre(&mut self, place: &[Node; 3]) -> Option<[Variable; 3]> {
        let values = place.each_ref().map(|entry| {
            let value = self.lowering(Frame::Moving).value(entry).ok()?;
            value.as_scalar().cloned()
        });
        let [Some(x), Some(y), Some(z)] = values else {
            return None;
        };
        let owner = Owner::Symbol("the place of the mass centre".to_owned());
        let entity = self.theory.atoms.entity(&owner, Shape::Vector, true, "r_G");
        let parts = [0, 1, 2].map(|c| self.theory.atoms.part(entity, c, 0));
        let written = parts.iter().zip([x, y, z]);
        let residuals = written.map(|(&part, value)| variable_fraction(part) - value);
        self.known.insert(entity);
        self.theory.assume(Premise {
            name: "the place of the mass centre by the words".to_owned(),
            residuals: residuals.collect(),
            preferred: parts.to_vec(),
            definition: true,
        });
        Some(parts)
    }

    fn moments_about(&mut self, points: &TwoPoints) -> Option<ParallelAxes> {
        let (other, centre, distance) = points.axes.as_ref()?;
        let entity = |meaning| match meaning {
            Meaning::Whole(entity) | Meaning::Component(entity, _) => Some(entity),
            _ => None,
        };
        let other = entity(self.meaning_of(other))?;
        let centre = entity(self.meaning_of(centre))?;
        let (distance, mass) = (self.number(distance)?, self.number(&points.mass)?);
        let offset = [Some(distance), None, None];
        (other != centre).then_some(ParallelAxes {
            centre,
            other,
            mass,
            offset,
            momentum: None,
            velocity: None,
            pivot: false,
        })
    }

    /// The variable of a symbol that is one number.
    fn number(&mut self, symbol: &Symbol) -> Option<Variable> {
        match self.meaning_of(symbol) {
            Meaning::Component(entity, component) => {
                Some(self.theory.atoms.part(entity, component, 0))
            }
            Meaning::Whole(entity) if self.theory.atoms.info(entity).shape == Shape::Scalar => {
                Some(self.theory.atoms.part(entity, 0, 0))
            }
            _ => None,
        }
    }

    /// The vector to the mass centre has its coordinates.
    fn coordinates_of(&mut self, vector: &Symbol, pair: ParallelAxes) {
        let Meaning::Whole(entity) = self.meaning_of(vector) else {
            return;
        };
        if self.theory.atoms.info(entity).shape != Shape::Vector {
            return;
        }
        let parts = [0, 1, 2].map(|c| self.theory.atoms.part(entity, c, 0));
        let offset = pair.offset();
        let residuals = parts
            .iter()
            .zip(&offset)
            .map(|(&p, o)| variable_fraction(p) - o.clone())
            .collect();
        self.known.insert(entity);
        self.theory.assume(Premise {
            name: "the coordinates of the mass centre".to_owned(),
            residuals,
            preferred: parts.to_vec(),
            definition: true,
        });
    }
}
