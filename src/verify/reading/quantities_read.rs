//! From a noun with its slots to a quantity of the model.

use crate::verify::language::heads::{
    ANGULAR_MOMENTUM, CONJUGATE, CONTACT_FORCE, DENSITY, ENERGY_OF_ROTATION, ENERGY_OF_TRANSLATION,
    FORCE, FRICTION, IDENTITY_MATRIX, JACOBIAN, KINETIC_ENERGY, MASS, MASS_MATRIX, MOMENT,
    MOMENT_OF_INERTIA, NORMAL_FORCE, PURE_QUATERNION, ROTATION_MATRIX, SCALAR_PART, SECOND_RATE,
    SPECIFIC_FORCE, TRAVEL, TURNED_VECTOR, VECTOR_PART,
};
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Term};
use crate::verify::model::atoms::whole;
use crate::verify::model::bodies::Velocities;
use crate::verify::model::system::{BodyId, FrameId, PointId, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::densities_read::is_per_unit;
use crate::verify::reading::load_quantities_read::{inertial, with_slots_of_moment};
use crate::verify::reading::named_loads_read::names_load;
use crate::verify::reading::names::{
    ANGULAR_VELOCITY, CROSS_PRODUCT_MATRIX, MASS_CENTRE, POTENTIAL, PRINCIPAL_MOMENTS, PRODUCTS,
    UNIT_VECTOR, name_of, opposite, told,
};
use crate::verify::reading::no_loads_read::leaves_out;
use crate::verify::reading::potentials_of_loads::is_potential_of_weight;
use crate::verify::reading::springs_read::is_spring;
use crate::verify::term::quantity::{Quantity, Whole};
use crate::verify::term::value::{Basis, Value};

/// The part of a vector along a direction, or perpendicular to it.
const PART: &str = "part";

/// Quantities of one point.
const MOTIONS: [&str; 4] = ["position", "displacement", "velocity", "acceleration"];

impl Builder<'_> {
    /// The quantity that a phrase names.
    pub(super) fn quantity(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        // Of several things each has its own.
        if MOTIONS.contains(&phrase.head) && phrase.all(Slot::Of).count() > 1 {
            return None;
        }
        let phrase = &with_slots_of_moment(phrase);
        let mut quantity = self.bare_quantity(phrase, declaration)?;
        if let Some(along) = phrase.slot(Slot::Along).or_else(|| self.axis_about(phrase))
            && !matches!(phrase.head, UNIT_VECTOR | PART | MOMENT_OF_INERTIA)
            && !is_told_along(&quantity)
        {
            let along = self.axis_quantity(&along.clone(), declaration)?;
            quantity = Quantity::Along {
                of: quantity.boxed(),
                axis: along.boxed(),
            };
        }
        if let Some(on) = phrase.slot(Slot::On)
            && !matches!(
                phrase.head,
                "component" | PRINCIPAL_MOMENTS | PRODUCTS | "entry"
            )
        {
            quantity = match (self.frame(on), self.pair_of_axes(phrase)) {
                (Some(frame), _) => Quantity::On(quantity.boxed(), frame),
                (None, pair) => {
                    let (frame, axes) = pair?;
                    Quantity::Pair(quantity.boxed(), frame, axes)
                }
            };
        }
        Some(quantity)
    }

    fn bare_quantity(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let ground = self.reading.system.ground;
        let relative = told(phrase.slot(Slot::RelativeTo), ground, |t| self.frame(t));
        match phrase.head {
            "position" | "displacement" => return self.placed(phrase),
            "distance" => return self.distance(phrase, declaration),
            TRAVEL => return self.travel(phrase, declaration),
            _ => {}
        }
        let relative = relative?;
        Some(match phrase.head {
            "velocity" | "acceleration" => self.motion_of_point(phrase, relative)?,
            "speed" => self.speed(phrase, relative)?,
            SPECIFIC_FORCE => self.specific_force(phrase)?,
            ANGULAR_VELOCITY => {
                let of = self.frame(phrase.slot(Slot::Of)?)?;
                Quantity::AngularVelocity { of, relative }
            }
            "angular acceleration" => {
                let of = self.frame(phrase.slot(Slot::Of)?)?;
                let omega = Quantity::AngularVelocity { of, relative };
                Quantity::Rate {
                    of: omega.boxed(),
                    seen: relative,
                }
            }
            "rate" | SECOND_RATE => self.rate(phrase, declaration)?,
            "magnitude" => {
                let of = self.operand(phrase.slot(Slot::Of)?, declaration)?;
                Quantity::Magnitude(of.boxed())
            }
            "component" if phrase.slot(Slot::Along).is_some() => {
                self.operand(phrase.slot(Slot::Of)?, declaration)?
            }
            "component" => self.numbered_component(phrase, declaration)?,
            PART => self.part(phrase, declaration)?,
            ROTATION_MATRIX => self.rotation_about(phrase, declaration)?,
            CONJUGATE | SCALAR_PART | VECTOR_PART | PURE_QUATERNION => {
                self.part_of_quaternion(phrase, declaration)?
            }
            TURNED_VECTOR => self.turned_vector(phrase, declaration)?,
            CROSS_PRODUCT_MATRIX | IDENTITY_MATRIX | JACOBIAN => {
                self.matrix_of(phrase, declaration)?
            }
            MASS if is_per_unit(phrase) => self.density(phrase, declaration)?,
            MASS => Quantity::Mass(self.whole_of(phrase)?),
            "volume" => self.volume(phrase)?,
            DENSITY => self.density(phrase, declaration)?,
            _ => return self.dynamic_quantity(phrase, declaration, relative),
        })
    }

    /// A matrix by its noun.
    fn matrix_of(&mut self, phrase: &NounPhrase, declaration: &Declaration) -> Option<Quantity> {
        match phrase.head {
            IDENTITY_MATRIX => Some(Quantity::Identity),
            JACOBIAN => self.rate_matrix(phrase, declaration),
            _ => {
                let of = self.operand(phrase.slot(Slot::Of)?, declaration)?;
                Some(Quantity::CrossProductMatrix(of.boxed()))
            }
        }
    }

    /// The magnitude of a velocity; along an axis it is a component.
    fn speed(&self, phrase: &NounPhrase, relative: FrameId) -> Option<Quantity> {
        let of = self.moving_spot(phrase)?;
        let velocity = Quantity::Velocity { of, relative };
        Some(match phrase.slot(Slot::Along) {
            Some(_) => velocity,
            None => Quantity::Magnitude(velocity.boxed()),
        })
    }

    /// What an accelerometer at a point reads: the acceleration of the point relative to the inertial frame, less that of
    /// gravity.
    fn specific_force(&mut self, phrase: &NounPhrase) -> Option<Quantity> {
        let at = phrase.slot(Slot::At).or_else(|| phrase.slot(Slot::Of))?;
        let of = self.spot(at)?;
        let relative = self.reading.system.ground;
        let gravity = self.gravity()?;
        Some(without(Quantity::Acceleration { of, relative }, gravity))
    }

    fn placed(&self, phrase: &NounPhrase) -> Option<Quantity> {
        let of = phrase.slot(Slot::Of)?;
        // What is at a contact for an instant was elsewhere before: its place there has no rate.
        if self.spot_at_contact(of).is_some() {
            return None;
        }
        let of = self.spot(of)?;
        let from = phrase
            .slot(Slot::RelativeTo)
            .or_else(|| phrase.slot(Slot::From));
        // "the displacement of G relative to N": from where it once was.
        let ground = Some(self.reading.system.ground);
        let once = |term: &Term| phrase.head == "displacement" && self.frame(term) == ground;
        let from = told(from, 0, |term| match self.point(term) {
            None if once(term) => Some(0),
            point => point,
        })?;
        Some(Quantity::Position { of, from })
    }

    /// "the part of `v` along n", "… perpendicular to n".
    fn part(&mut self, phrase: &NounPhrase, declaration: &Declaration) -> Option<Quantity> {
        if let Some(plane) = phrase.slot(Slot::In) {
            return self.part_in_plane(phrase.slot(Slot::Of)?, plane, declaration);
        }
        let of = self.operand(phrase.slot(Slot::Of)?, declaration)?;
        let across = phrase.slot(Slot::With);
        let axis = across.or_else(|| phrase.slot(Slot::Along))?;
        let axis = self.axis_quantity(&axis.clone(), declaration)?;
        Some(Quantity::Part {
            of: of.boxed(),
            axis: axis.boxed(),
            across: across.is_some(),
        })
    }

    fn dynamic_quantity(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
        relative: FrameId,
    ) -> Option<Quantity> {
        Some(match phrase.head {
            "inertia tensor" => {
                let of = self.whole_of(phrase)?;
                let about = self.about(phrase, &of)?;
                Quantity::Inertia { of, about }
            }
            MOMENT_OF_INERTIA => self.moment_of_inertia(phrase, declaration)?,
            "momentum" => Quantity::Momentum {
                of: self.whole_of(phrase)?,
                relative,
            },
            ANGULAR_MOMENTUM => {
                if let Some(own) = self.momentum_of_rotor(phrase, declaration) {
                    return Some(own);
                }
                if let Some(all) = self.momentum_of_rotors_in_body(phrase, relative) {
                    return Some(all);
                }
                let of = self.whole_of(phrase)?;
                let about = self.about(phrase, &of)?;
                let velocities = match phrase.slot(Slot::VelocitiesRelativeTo) {
                    // Relative to the frame itself, as without these words.
                    Some(term) if self.frame(term) == Some(relative) => Velocities::Absolute,
                    Some(term) => self.point(term).map(|_| Velocities::RelativeToPoint)?,
                    None => Velocities::Absolute,
                };
                Quantity::AngularMomentum {
                    of,
                    about,
                    relative,
                    velocities,
                }
            }
            FORCE | MOMENT if leaves_out(phrase) => self.total_but_for(phrase, declaration)?,
            FORCE | CONTACT_FORCE | NORMAL_FORCE | FRICTION => self.force(phrase)?,
            head if inertial(head).is_some() => self.inertial_force(phrase)?,
            MASS_MATRIX => self.mass_matrix(phrase, declaration)?,
            "weight" => self.weight(phrase)?,
            "moment" => self.moment(phrase, declaration)?,
            _ if names_load(phrase) => self.named_force(phrase)?,
            _ => return self.energy(phrase, relative),
        })
    }

    fn energy(&mut self, phrase: &NounPhrase, relative: FrameId) -> Option<Quantity> {
        if phrase.head == "height" {
            return self.height(phrase);
        }
        if let Some(body) = as_particle(phrase) {
            let moving = NounPhrase::new(ENERGY_OF_TRANSLATION, vec![(Slot::Of, body.clone())]);
            return self.energy(&moving, relative);
        }
        if let (POTENTIAL, Some(of)) = (phrase.head, phrase.slot(Slot::Of))
            && is_spring(of)
            && phrase.all(Slot::Of).count() == 1
        {
            return self.energy_of_spring(of);
        }
        if is_potential_of_weight(phrase) {
            return self.potential_of_loads(phrase);
        }
        let (of, body) = (self.whole_of(phrase)?, self.body_of(phrase));
        let rotation = self.is_of_rotation(phrase, relative, body)?;
        let kinetic = Quantity::KineticEnergy {
            of: of.clone(),
            relative,
            rotation,
        };
        let energy = |rotation| Quantity::KineticEnergy {
            of: of.clone(),
            relative,
            rotation,
        };
        match phrase.head {
            ENERGY_OF_TRANSLATION => {
                let with_centre = self.moves_with_centre(phrase, body);
                with_centre.then(|| without(energy(false), energy(true)))
            }
            // About a point that is fixed in the body and in space all energy is that of rotation; about another one than the
            // mass centre it is another.
            KINETIC_ENERGY | ENERGY_OF_ROTATION => match phrase.slot(Slot::About) {
                None => Some(kinetic),
                Some(about) => {
                    let about = self.point(about)?;
                    if rotation && about == self.centre_of(body?) {
                        return Some(kinetic);
                    }
                    let fixed = self.is_fixed_point(about, body?);
                    (rotation && fixed).then_some(energy(false))
                }
            },
            POTENTIAL => self.potential_energy(body?),
            "total energy" => self.with_potential(body?, kinetic, 1),
            "Lagrangian" => self.with_potential(body?, kinetic, -1),
            _ => None,
        }
    }

    /// "the kinetic energy of translation of the rod with C": a single body with its mass centre, and not with another point.
    fn moves_with_centre(&self, phrase: &NounPhrase, body: Option<BodyId>) -> bool {
        let Some(with) = phrase.slot(Slot::With) else {
            return true;
        };
        let single = body.filter(|&body| self.reading.system.wholes(body) == [body]);
        single.is_some_and(|body| self.point(with) == Some(self.centre_of(body)))
    }

    /// What a slot names: a letter, or a phrase.
    pub(super) fn operand(&mut self, term: &Term, declaration: &Declaration) -> Option<Quantity> {
        match term {
            Term::Phrase(phrase) => self.quantity(phrase, declaration),
            Term::Formula(formula) => match self.quantity_of(formula, declaration) {
                Some(quantity) => Some(quantity),
                None => self
                    .mentioned_value(formula, declaration)
                    .map(Quantity::Known),
            },
            _ => None,
        }
    }

    pub(super) fn centre_of(&self, body: usize) -> PointId {
        self.reading.system.bodies[body].centre
    }

    /// A direction by its components.
    pub(super) fn axis_vector(&mut self, term: &Term, declaration: &Declaration) -> Option<Vector> {
        let axis = self.axis_quantity(term, declaration)?;
        self.system().value_of(&axis).ok()?.to_vector().ok()
    }

    /// A direction as a quantity.
    pub(super) fn axis_quantity(
        &mut self,
        term: &Term,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        if let Some(name) = name_of(term)
            && let Some(&(frame, axis)) = self.axes.get(&name)
        {
            return Some(Quantity::Axis(frame, axis));
        }
        if let Some(opposite) = opposite(term) {
            let axis = self.axis_quantity(&opposite, declaration)?;
            return Some(Quantity::Scaled(axis.boxed(), whole(-1)));
        }
        if let Term::Formula(formula) = term
            && let Some(quantity) = self.quantity_of(formula, declaration)
        {
            let Quantity::Known(value) = &quantity else {
                return Some(quantity);
            };
            let unit = self.unit_along(value.to_vector().ok()?)?;
            return Some(Quantity::Known(Value::vector(&unit, Basis::Itself)));
        }
        let vector = self.direction(term, declaration, None)?;
        Some(Quantity::Known(Value::vector(&vector, Basis::Itself)))
    }

    fn distance(&mut self, phrase: &NounPhrase, declaration: &Declaration) -> Option<Quantity> {
        let of = self.spot(phrase.slot(Slot::Of)?)?;
        let from = phrase
            .slot(Slot::RelativeTo)
            .or_else(|| phrase.slot(Slot::From))?
            .clone();
        match &from {
            Term::Phrase(axis) => {
                let through = told(axis.slot(Slot::Through), 0, |t| self.point(t))?;
                let along = axis.slot(Slot::Along)?.clone();
                let along = self.axis_quantity(&along, declaration)?;
                Some(Quantity::Distance {
                    of,
                    from: through,
                    axis: along.boxed(),
                })
            }
            other => {
                let from = self.point(other)?;
                Some(Quantity::Magnitude(Quantity::Position { of, from }.boxed()))
            }
        }
    }

    pub(super) fn body_of(&self, phrase: &NounPhrase) -> Option<usize> {
        match self.whole_of(phrase)? {
            Whole::Body(body) => Some(body),
            Whole::Member(..) => None,
        }
    }
}

/// One quantity less another.
pub(super) fn without(whole: Quantity, part: Quantity) -> Quantity {
    Quantity::Sum(vec![
        whole,
        Quantity::Scaled(part.boxed(), crate::verify::model::atoms::whole(-1)),
    ])
}

/// The body of "the kinetic energy of link 1 as a particle at its mass centre".
fn as_particle(energy: &NounPhrase) -> Option<&Term> {
    let Some(Term::Phrase(particle)) = energy.slot(Slot::Of) else {
        return None;
    };
    let body = particle.slot(Slot::Of)?;
    let at_centre = particle.all(Slot::At).all(|at| match at {
        Term::Phrase(at) => at.head == MASS_CENTRE && at.slot(Slot::Of).is_none_or(|of| of == body),
        _ => false,
    });
    let only = energy.head == KINETIC_ENERGY && particle.head == "particle";
    (only && at_centre && energy.slots.len() == 1).then_some(body)
}

/// Whether a quantity is the part along an axis already, as that of a rotor is.
fn is_told_along(quantity: &Quantity) -> bool {
    matches!(quantity, Quantity::Known(value) if value.is_scalar())
}
