//! Virtual power (Jourdain's principle): in each motion that the constraints allow, the loads have as much power as the rates
//! of the momenta. The forces of ideal constraints have none, so that nobody need name them.

use crate::algebra::{Fraction, Place, Variable};
use crate::verify::model::atoms::Motion;
use crate::verify::model::loads::Load;
use crate::verify::model::system::{BodyId, System, Vector};
use num_traits::Zero;

/// More speeds than these are not worked with.
const MOST_SPEEDS: usize = 8;

/// A velocity or an angular velocity, and the force or the moment that has power by it.
pub(crate) type Effort = (Vector, Vector);

impl System {
    /// What loads and the changes of momenta do on bodies, each with the velocity by which it has power.
    pub(crate) fn efforts(&mut self, bodies: &[BodyId], loads: &[Load]) -> Option<Vec<Effort>> {
        let mut efforts: Vec<Effort> = vec![];
        for &body in bodies {
            efforts.extend(self.inertial_efforts(body));
        }
        for load in loads {
            efforts.push((self.velocity_of_load(load)?, load.value.clone()));
        }
        for (velocity, _) in &mut efforts {
            *velocity = velocity.map(|part| self.expanded(&part, &[]));
        }
        Some(efforts)
    }

    /// The equations of motion: one for each speed in which the velocities are linear, where these have all constraints put in.
    /// `steady` are speeds that something keeps as they are. `None` where the velocities are not linear.
    pub(crate) fn equations_by_virtual_power(
        &self,
        efforts: &[Effort],
        steady: &[Variable],
    ) -> Option<Vec<Fraction>> {
        let speeds = self.speeds_in(efforts)?;
        let force = |speed: Variable| {
            let power = efforts.iter().map(|(velocity, effort)| {
                let partial = velocity.map(|part| part.partial(speed));
                partial.dot(effort)
            });
            power.fold(Fraction::zero(), |sum, power| sum + power)
        };
        let free = speeds.iter().filter(|speed| !steady.contains(speed));
        let equations: Vec<Fraction> = free.map(|&speed| force(speed)).collect();
        (!equations.is_empty()).then_some(equations)
    }

    /// What the change of its momenta takes from the loads on a body.
    fn inertial_efforts(&mut self, body: BodyId) -> Vec<Effort> {
        let (centre, ground) = (self.bodies[body].centre, self.ground);
        let mut own = vec![(self.velocity(centre, ground), -self.total_force(body))];
        if let Some(frame) = self.bodies[body].frame {
            let omega = self.angular_velocity(frame, ground);
            own.push((omega, -self.total_moment(body, centre)));
        }
        own
    }

    /// The velocity of the point of a body at which a force acts, or the angular velocity of the body on which a couple does.
    fn velocity_of_load(&mut self, load: &Load) -> Option<Vector> {
        let ground = self.ground;
        let frame = load.on.and_then(|body| self.bodies[body].frame);
        match (load.at, load.on) {
            (None, _) => Some(self.angular_velocity(frame?, ground)),
            (Some(at), Some(body)) if frame.is_some() => {
                let there = self.body_point(body, at)?;
                Some(self.carried_velocity(there, ground))
            }
            (Some(at), _) => Some(self.velocity(at, ground)),
        }
    }

    /// The speeds in which velocities are linear; `None` where they are not, or where these are too many.
    fn speeds_in(&self, efforts: &[Effort]) -> Option<Vec<Variable>> {
        let parts = || efforts.iter().flat_map(|(velocity, _)| velocity.iter());
        let mut speeds: Vec<Variable> = parts().flat_map(Fraction::variables).collect();
        speeds.retain(|&v| self.is_speed(v));
        speeds.sort_unstable();
        speeds.dedup();
        let linear = parts().all(|part| self.is_linear(part, &speeds));
        (linear && speeds.len() <= MOST_SPEEDS).then_some(speeds)
    }

    fn is_speed(&self, variable: Variable) -> bool {
        let steady = match &self.atoms.atom(variable).motion {
            Motion::Constant => true,
            Motion::Rate(rate) => rate.is_zero(),
            Motion::Free => false,
        };
        self.atoms.atom(variable).place == Place::Rate && !steady
    }

    fn is_linear(&self, part: &Fraction, speeds: &[Variable]) -> bool {
        let free = |f: Fraction| f.variables().iter().all(|v| !speeds.contains(v));
        speeds.iter().all(|&speed| free(part.partial(speed)))
    }

    /// Whether an equation is a constraint: between coordinates, or linear in speeds.
    pub(crate) fn is_constraint(&self, equation: &Fraction) -> bool {
        let told = self.expanded(equation, &[]);
        let above = Fraction::from(told.numerator().clone());
        let variables = above.variables();
        let driven = |v: &Variable| self.atoms.atom(*v).place == Place::Acceleration;
        let speeds: Vec<Variable> = variables
            .iter()
            .copied()
            .filter(|&v| self.is_speed(v))
            .collect();
        !variables.iter().any(driven) && self.is_linear(&above, &speeds)
    }

    /// The speed of which an equation says that it does not change.
    pub(crate) fn kept_speed(&self, equation: &Fraction) -> Option<Variable> {
        let told = self.expanded(equation, &[]);
        self.atoms.atom(told.as_variable()?).rate_of
    }
}
