//! Mass, inertia, momentum and energy of bodies, and the laws of motion.

use crate::algebra::{Fraction, Place};
use crate::mechanics;
use crate::verify::model::atoms::{Key, Motion, Space, fraction};
use crate::verify::model::system::{Body, BodyId, FrameId, Matrix, PointId, System, Vector};
use num_traits::Zero;

/// Which velocities an angular momentum is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Velocities {
    /// Those seen from the inertial frame.
    Absolute,
    /// Those relative to the point that it is about.
    RelativeToPoint,
}

impl System {
    /// A new body with a mass of its own.
    pub(crate) fn add_body(
        &mut self,
        name: &str,
        frame: Option<FrameId>,
        centre: PointId,
    ) -> BodyId {
        let text = match self.bodies.is_empty() {
            true => "m".to_owned(),
            false => format!("m_{{\\text{{{name}}}}}"),
        };
        let mass = fraction(self.atoms.variable(
            Key::new(text),
            Place::Parameter,
            Motion::Constant,
        ));
        self.atoms.set_positive(&mass);
        self.bodies.push(Body {
            name: name.to_owned(),
            frame,
            centre,
            mass,
            inertia: None,
            base: None,
            parts: vec![],
            rotors: None,
            line: None,
            ends: vec![],
            round: None,
            members: None,
        });
        self.bodies.len() - 1
    }

    /// Whether a point is fixed in a rigid body.
    pub(crate) fn carries(&self, body: BodyId, point: PointId) -> bool {
        let fixed = &self.points[point].fixed_in;
        self.bodies[body]
            .frame
            .is_some_and(|frame| fixed.contains(&frame))
    }

    /// The bodies without parts that a body is made of.
    pub(crate) fn wholes(&self, body: BodyId) -> Vec<BodyId> {
        let parts = &self.bodies[body].parts;
        match parts.is_empty() {
            true => vec![body],
            false => parts.iter().flat_map(|&part| self.wholes(part)).collect(),
        }
    }

    /// The mass of a body.
    pub(crate) fn mass(&mut self, body: BodyId) -> Fraction {
        let mut sum = Fraction::zero();
        for part in self.wholes(body) {
            let mass = self.bodies[part].mass.clone();
            sum += self.over_members(part, mass);
        }
        sum
    }

    /// What a part contributes: where it stands for each member of a family, the sum over all of them.
    pub(crate) fn over_members(&mut self, part: BodyId, of: Fraction) -> Fraction {
        let Some(index) = self.bodies[part].members.clone() else {
            return of;
        };
        self.sum(&of, &index).unwrap_or_else(|| {
            let key = Key::new(format!("\\sum_{{{index}}} {}", self.bodies[part].name));
            fraction(self.atoms.variable(key, Place::Rate, Motion::Free))
        })
    }

    /// The same of a vector or a tensor, entry by entry.
    pub(crate) fn each_over_members<const C: usize>(
        &mut self,
        part: BodyId,
        of: nalgebra::SMatrix<Fraction, 3, C>,
    ) -> nalgebra::SMatrix<Fraction, 3, C> {
        of.map(|entry| self.over_members(part, entry))
    }

    /// The inertia tensor of a whole body about its base point: its mass centre where it has no other.
    fn told_inertia(&mut self, body: BodyId) -> Matrix {
        if let Some(known) = &self.bodies[body].inertia {
            return known.clone();
        }
        let tensor = match self.bodies[body].frame {
            None => Matrix::zeros(),
            Some(frame) => {
                let text = match body {
                    0 => "I".to_owned(),
                    _ => format!("I^{{\\text{{{}}}}}", self.bodies[body].name),
                };
                self.carried_tensor(&text, body, frame)
            }
        };
        self.bodies[body].inertia = Some(tensor.clone());
        tensor
    }

    /// The inertia tensor of a whole body about its mass centre.
    fn central_inertia(&mut self, body: BodyId) -> Matrix {
        let tensor = self.told_inertia(body);
        let Some(base) = self.bodies[body].base else {
            return tensor;
        };
        // Steiner's law the other way round.
        let way = self.position(self.bodies[body].centre, base);
        mechanics::parallel_axis(&tensor, &-self.bodies[body].mass.clone(), &way)
    }

    /// The tensor about its base point and the angular velocity of a whole body that has this one.
    fn spin_about(
        &mut self,
        body: BodyId,
        base: PointId,
        relative: FrameId,
    ) -> Option<(Matrix, Vector)> {
        let frame = self.bodies[body].frame?;
        if self.bodies[body].base != Some(base) {
            return None;
        }
        let omega = self.angular_velocity(frame, relative);
        Some((self.told_inertia(body), omega))
    }

    /// A symmetric tensor that does not change as seen from a frame.
    fn carried_tensor(&mut self, text: &str, body: BodyId, frame: FrameId) -> Matrix {
        let variables = ["x", "y", "z"].map(|row| {
            ["x", "y", "z"].map(|column| {
                let (first, second) = (row.min(column), row.max(column));
                let mut key = Key::new(format!("{text}_{{{first}{second}}}"));
                if row != column {
                    key.space = Space::UntoldProduct(body);
                }
                self.atoms.variable(key, Place::Parameter, Motion::Constant)
            })
        });
        let tensor = Matrix::from_fn(|r, c| fraction(variables[r][c]));
        (0..3).for_each(|k| self.atoms.set_positive(&tensor[(k, k)]));
        if frame != self.work {
            let omega = self.angular_velocity(frame, self.work);
            let turn = mechanics::skew(&omega);
            let rate = mechanics::product(&turn, &tensor) - mechanics::product(&tensor, &turn);
            for (r, row) in variables.iter().enumerate() {
                for (c, &variable) in row.iter().enumerate() {
                    self.atoms.atom_mut(variable).motion = Motion::Rate(rate[(r, c)].clone());
                }
            }
        }
        tensor
    }

    /// The inertia tensor of a body about a point: that of its parts, each shifted by the parallel-axis law.
    pub(crate) fn inertia(&mut self, body: BodyId, about: PointId) -> Matrix {
        let mut sum = Matrix::zeros();
        for part in self.wholes(body) {
            if self.bodies[part].base == Some(about) {
                sum += self.told_inertia(part);
                continue;
            }
            let central = self.central_inertia(part);
            let way = self.position(self.bodies[part].centre, about);
            let own = mechanics::parallel_axis(&central, &self.bodies[part].mass.clone(), &way);
            sum += self.each_over_members(part, own);
        }
        sum
    }

    /// The central inertia and the angular velocity of a whole body; `None` for a particle.
    fn spin(&mut self, body: BodyId, relative: FrameId) -> Option<(Matrix, Vector)> {
        let omega = self.angular_velocity(self.bodies[body].frame?, relative);
        Some((self.central_inertia(body), omega))
    }

    /// The momentum of a body relative to a frame.
    pub(crate) fn momentum(&mut self, body: BodyId, frame: FrameId) -> Vector {
        let mut sum = Vector::zeros();
        for part in self.wholes(body) {
            let velocity = self.velocity(self.bodies[part].centre, frame);
            let own = velocity * self.bodies[part].mass.clone();
            sum += self.each_over_members(part, own);
        }
        sum
    }

    /// The angular momentum of a body about a point, relative to a frame.
    pub(crate) fn angular_momentum(
        &mut self,
        body: BodyId,
        about: PointId,
        frame: FrameId,
        velocities: Velocities,
    ) -> Vector {
        let base = match velocities {
            Velocities::Absolute => Vector::zeros(),
            Velocities::RelativeToPoint => self.velocity(about, frame),
        };
        let mut sum = Vector::zeros();
        for part in self.wholes(body) {
            let (centre, mass) = (self.bodies[part].centre, self.bodies[part].mass.clone());
            if let Some((inertia, omega)) = self.spin_about(part, about, frame) {
                // L_P = I_P ω + m r × v_P, r from P to the mass centre
                let velocity = self.velocity(about, frame) - base.clone();
                let way = self.position(centre, about);
                sum += mechanics::angular_momentum(&inertia, &omega);
                sum += mechanics::cross(&way, &velocity) * mass;
                sum += self.momentum_of_rotors(part);
                continue;
            }
            if let Some((inertia, omega)) = self.spin(part, frame) {
                sum += mechanics::angular_momentum(&inertia, &omega);
            }
            let velocity = self.velocity(centre, frame) - base.clone();
            let way = self.position(centre, about);
            let own = mechanics::cross(&way, &velocity) * mass;
            sum += self.each_over_members(part, own);
            sum += self.momentum_of_rotors(part);
        }
        sum
    }

    /// What wheels add to the angular momentum of the body that they are part of: Σ J Ω g.
    fn momentum_of_rotors(&mut self, body: BodyId) -> Vector {
        let Some(rotors) = self.bodies[body].rotors.clone() else {
            return Vector::zeros();
        };
        let own = rotors.axis * (rotors.inertia * rotors.rate);
        self.sum_vector(&own, &rotors.index)
            .unwrap_or_else(Vector::zeros)
    }

    /// What wheels add to the kinetic energy of the body that they are part of: Σ J Ω (g·ω + Ω/2).
    fn energy_of_rotors(&mut self, body: BodyId, frame: FrameId) -> Fraction {
        let (Some(rotors), Some(own)) = (self.bodies[body].rotors.clone(), self.bodies[body].frame)
        else {
            return Fraction::zero();
        };
        let omega = self.angular_velocity(own, frame);
        let half = Fraction::from_ratio(1, 2) * rotors.rate.clone();
        let energy = rotors.inertia * rotors.rate * (rotors.axis.dot(&omega) + half);
        self.sum(&energy, &rotors.index)
            .unwrap_or_else(Fraction::zero)
    }

    /// The kinetic energy of a body relative to a frame, by König's law; or of rotation alone, which is that of all motion
    /// relative to the mass centre.
    pub(crate) fn kinetic_energy(
        &mut self,
        body: BodyId,
        frame: FrameId,
        rotation_alone: bool,
    ) -> Fraction {
        let mut sum = Fraction::zero();
        let half = Fraction::from_ratio(1, 2);
        for part in self.wholes(body) {
            let (centre, mass) = (self.bodies[part].centre, self.bodies[part].mass.clone());
            sum += self.energy_of_rotors(part, frame);
            if let Some(base) = self.bodies[part].base
                && !rotation_alone
                && self.velocity(base, frame).iter().all(Zero::is_zero)
                && let Some((inertia, omega)) = self.spin_about(part, base, frame)
            {
                sum += mechanics::kinetic_energy(&inertia, &omega);
                continue;
            }
            if let Some((inertia, omega)) = self.spin(part, frame) {
                sum += mechanics::kinetic_energy(&inertia, &omega);
            }
            let whole = self.bodies[body].centre;
            if !rotation_alone || part != body {
                let mut velocity = self.velocity(centre, frame);
                if rotation_alone {
                    velocity -= self.velocity(whole, frame);
                }
                let own = half.clone() * mass * velocity.dot(&velocity);
                sum += self.over_members(part, own);
            }
        }
        sum
    }

    /// The sum of the external forces on a body: the rate of its momentum.
    pub(crate) fn total_force(&mut self, body: BodyId) -> Vector {
        let momentum = self.momentum(body, self.ground);
        self.rate_seen_from(self.ground, &momentum)
    }

    /// The sum of the moments of the external forces about a point, which may move: M_P = dH_P/dt + v_P × p.
    pub(crate) fn total_moment(&mut self, body: BodyId, about: PointId) -> Vector {
        let ground = self.ground;
        let momentum = self.angular_momentum(body, about, ground, Velocities::Absolute);
        let rate = self.rate_seen_from(ground, &momentum);
        let velocity = self.velocity(about, ground);
        let linear = self.momentum(body, ground);
        rate + mechanics::cross(&velocity, &linear)
    }
}
