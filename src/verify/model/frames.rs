//! How frames are turned against one another: the chain of angular velocities, and rotation matrices.
//!
//! A frame that turns freely has its attitude by the vector g = n tan(θ/2) of Gibbs and Rodrigues:
//! `R = ((1 − g²) 1 + 2 g gᵀ + 2 [g]×) / (1 + g²)`, which is every rotation but half turns, without a relation between
//! the entries; ġ = ½ (ω + g × ω + (g·ω) g) with ω on the turned frame (Shuster, A survey of attitude
//! representations, 1993).

use crate::algebra::{Fraction, Place};
use crate::mechanics;
use crate::verify::model::atoms::{Key, Motion, fraction, whole};
use crate::verify::model::system::{Axis, Frame, FrameId, Matrix, System, Turn, Vector, unit};
use nalgebra::Vector4;
use num_traits::{One, Zero};

/// Through more frames that turn freely one on the other no rotation is worked out: each makes the entries ten times as long.
const MOST_FREE_TURNS: usize = 3;

impl System {
    /// A new frame.
    pub(crate) fn add_frame(&mut self, name: &str, parent: Option<FrameId>, turn: Turn) -> FrameId {
        self.frames.push(Frame {
            name: name.to_owned(),
            parent,
            turn,
            by_quaternion: false,
        });
        self.frames.len() - 1
    }

    /// A frame and those that it is turned against, up to the first.
    fn chain(&self, frame: FrameId) -> Vec<FrameId> {
        let mut chain = vec![frame];
        while let Some(parent) = self.frames[chain[chain.len() - 1]].parent {
            // Frames are turned against earlier ones alone, so this ends.
            chain.push(parent);
        }
        chain
    }

    /// Whether a frame is another one, or is turned against it through others.
    fn stands_on(&self, frame: FrameId, other: FrameId) -> bool {
        self.chain(frame).contains(&other)
    }

    /// The frames on the way from one frame up to the last that the other does not stand on as well.
    pub(super) fn links(&self, frame: FrameId, other: FrameId) -> Vec<FrameId> {
        let theirs = self.chain(other);
        let own = self.chain(frame).into_iter();
        own.take_while(|f| !theirs.contains(f)).collect()
    }

    /// How far two frames are apart: ten for each link that turns freely, one for each by an angle.
    pub(crate) fn distance(&self, one: FrameId, other: FrameId, easy: &[FrameId]) -> usize {
        let links = self
            .links(one, other)
            .into_iter()
            .chain(self.links(other, one));
        links
            .map(|link| if easy.contains(&link) { 1 } else { 10 })
            .sum()
    }

    /// The angular velocity of one frame relative to another: the sum along the chain.
    pub(crate) fn angular_velocity(&mut self, of: FrameId, relative: FrameId) -> Vector {
        let (up, down) = (self.links(of, relative), self.links(relative, of));
        let mut sum = Vector::zeros();
        for link in up {
            sum += self.link_velocity(link);
        }
        for link in down {
            sum -= self.link_velocity(link);
        }
        sum
    }

    /// The angular velocity of a frame relative to its parent.
    fn link_velocity(&mut self, frame: FrameId) -> Vector {
        match self.frames[frame].turn.clone() {
            Turn::Fixed => Vector::zeros(),
            Turn::Free => {
                let text = format!("\\omega^{{{}}}", self.frames[frame].name);
                self.free_vector(&text, Place::Rate, None)
            }
            Turn::Angle(axis, angle) => {
                let rate = self.atoms.derivative(&angle);
                self.axis(frame, axis) * rate
            }
            Turn::About(axis, angle) => {
                let rate = self.atoms.derivative(&angle);
                let anchor = self.anchor(frame);
                mechanics::apply(&self.rotation(self.work, anchor), &axis) * rate
            }
            Turn::Rate(Axis::Number(axis), rate) => self.axis(frame, axis) * *rate,
            Turn::Rate(Axis::Along(axis), rate) => *axis * *rate,
        }
    }

    /// The nearer one to the work frame of a frame and its parent.
    pub(crate) fn anchor(&self, frame: FrameId) -> FrameId {
        let parent = self.frames[frame].parent;
        let other = parent.filter(|_| !self.stands_on(self.work, frame));
        other.unwrap_or(frame)
    }

    /// The unit vector along an axis of a frame.
    pub(crate) fn axis(&mut self, frame: FrameId, axis: usize) -> Vector {
        if frame == self.work {
            return unit(axis);
        }
        // The axis about which a frame turns is the same on its parent, which may be nearer.
        let shares = |link: FrameId| self.frames[link].turn.axis() == Some(axis);
        if let Some(parent) = self.frames[frame].parent
            && shares(frame)
            && !self.stands_on(self.work, frame)
        {
            return self.axis(parent, axis);
        }
        let mut links = self.links(self.work, frame).into_iter();
        if let Some(link) = links.find(|&f| self.frames[f].parent == Some(frame) && shares(f)) {
            return self.axis(link, axis);
        }
        self.rotation(self.work, frame).column(axis).into_owned()
    }

    /// The matrix that takes components on one frame to components on another.
    pub(crate) fn rotation(&mut self, to: FrameId, from: FrameId) -> Matrix {
        let (up, down) = (self.links(from, to), self.links(to, from));
        let free = up
            .iter()
            .chain(&down)
            .filter(|&&link| self.turns_freely(link));
        if free.count() > MOST_FREE_TURNS {
            return Matrix::from_element(Fraction::none());
        }
        let mut matrix = Matrix::identity();
        for link in down {
            matrix = mechanics::product(&matrix, &self.link_rotation(link).transpose());
        }
        // From the common frame down to `from`: outermost first.
        for link in up.into_iter().rev() {
            matrix = mechanics::product(&matrix, &self.link_rotation(link));
        }
        matrix
    }

    /// Whether no angle gives the rotation of a frame against its parent.
    fn turns_freely(&self, frame: FrameId) -> bool {
        matches!(
            self.frames[frame].turn,
            Turn::Free | Turn::Rate(Axis::Along(_), _)
        )
    }

    /// The matrix that takes components on a frame to components on its parent.
    fn link_rotation(&mut self, frame: FrameId) -> Matrix {
        match self.frames[frame].turn.clone() {
            Turn::Fixed => Matrix::identity(),
            Turn::Angle(axis, angle) => match self.atoms.cosine_sine(&angle) {
                Some((cosine, sine)) => about_axis(axis, &cosine, &sine),
                None => self.free_rotation(frame),
            },
            Turn::About(axis, angle) => match self.atoms.cosine_sine(&angle) {
                Some((cosine, sine)) => about_vector(&axis, &cosine, &sine),
                None => self.free_rotation(frame),
            },
            Turn::Rate(Axis::Number(axis), rate) => {
                let text = format!("\\theta^{{{}}}", self.frames[frame].name);
                let angle =
                    self.atoms
                        .variable(Key::new(text), Place::Coordinate, Motion::Rate(*rate));
                match self.atoms.cosine_sine(&fraction(angle)) {
                    Some((cosine, sine)) => about_axis(axis, &cosine, &sine),
                    None => self.free_rotation(frame),
                }
            }
            Turn::Free | Turn::Rate(Axis::Along(_), _) => self.free_rotation(frame),
        }
    }

    /// The unit quaternion, scalar first, by which q v q* takes components on one frame to components on another, where each
    /// frame between them turns by a quaternion, or by an angle.
    pub(crate) fn unit_quaternion(
        &mut self,
        to: FrameId,
        from: FrameId,
    ) -> Option<Vector4<Fraction>> {
        let (up, down) = (self.links(from, to), self.links(to, from));
        let mut links = vec![];
        for link in down {
            links.push(mechanics::quaternion_conjugate(
                &self.quaternion_of_link(link)?,
            ));
        }
        for link in up.into_iter().rev() {
            links.push(self.quaternion_of_link(link)?);
        }
        let product = |first, second| mechanics::quaternion_product(&first, &second);
        links.into_iter().reduce(product)
    }

    /// The one by which it takes components on a frame to components on its parent. That of a turn by an angle about a unit
    /// vector n is (cos θ/2, n sin θ/2).
    fn quaternion_of_link(&mut self, frame: FrameId) -> Option<Vector4<Fraction>> {
        let (axis, angle) = match self.frames[frame].turn.clone() {
            Turn::Free if self.frames[frame].by_quaternion => {
                return Some(self.quaternion_of_turn(frame));
            }
            Turn::Angle(axis, angle) => (unit(axis), angle),
            Turn::About(axis, angle) => (*axis, angle),
            _ => return None,
        };
        let half = *angle * Fraction::from_ratio(1, 2);
        let (cosine, sine) = self.atoms.cosine_sine(&half)?;
        let [x, y, z] = [0, 1, 2].map(|k| axis[k].clone() * sine.clone());
        Some(Vector4::new(cosine, x, y, z))
    }

    /// The unit quaternion of a frame that turns freely, by modified Rodrigues parameters σ, which leave no root:
    /// (1 − σ², 2 σ)/(1 + σ²), with σ̇ = ((1 − σ²) ω ± 2 σ × ω + 2 σ (σ·ω))/4 (Schaub and Junkins, Analytical Mechanics of
    /// Space Systems, 3.5).
    fn quaternion_of_turn(&mut self, frame: FrameId) -> Vector4<Fraction> {
        let (sigma, new) = self.parameters_of_turn("\\sigma", frame);
        let square = sigma.dot(&sigma);
        let rest = Fraction::one() - square.clone();
        if new {
            let (omega, turned) = self.turn_on_its_side(frame);
            let cross = mechanics::cross(&sigma, &omega) * whole(2);
            let along = sigma.clone() * sigma.dot(&omega) * whole(2);
            let others = if turned { along + cross } else { along - cross };
            let rate = (omega * rest.clone() + others) * Fraction::from_ratio(1, 4);
            self.set_rates(&sigma, &rate);
        }
        let below = Fraction::one() + square;
        let vector = sigma * (whole(2) / below.clone());
        let [x, y, z] = [0, 1, 2].map(|k| vector[k].clone());
        Vector4::new(rest / below, x, y, z)
    }

    /// Three variables by which a frame is turned, and whether they are new.
    fn parameters_of_turn(&mut self, letter: &str, frame: FrameId) -> (Vector, bool) {
        let text = format!("{letter}^{{{}}}", self.frames[frame].name);
        let keys = [0, 1, 2].map(|k| Key::new(super::system::component_text(&text, k)));
        let known = self.atoms.find(&keys[0]).is_some();
        let variables = keys.map(|key| self.atoms.variable(key, Place::Coordinate, Motion::Free));
        (Vector::from(variables.map(fraction)), !known)
    }

    fn set_rates(&mut self, variables: &Vector, rates: &Vector) {
        for (variable, rate) in variables.iter().zip(rates.iter()) {
            if let Some(variable) = variable.as_variable() {
                self.atoms.atom_mut(variable).motion = Motion::Rate(rate.clone());
            }
        }
    }

    /// The rotation by Gibbs' vector, whose rate follows the angular velocity, or by the quaternion of which a sentence speaks.
    fn free_rotation(&mut self, frame: FrameId) -> Matrix {
        if self.frames[frame].by_quaternion {
            return mechanics::rotation(&self.quaternion_of_turn(frame));
        }
        let (g, new) = self.parameters_of_turn("g", frame);
        if new {
            let rate = self.rate_of_free_rotation(frame, &g);
            self.set_rates(&g, &rate);
        }
        let square = g.dot(&g);
        let below = Fraction::one() + square.clone();
        let cross = mechanics::skew(&g);
        Matrix::from_fn(|r, c| {
            let diagonal = if r == c {
                Fraction::one() - square.clone()
            } else {
                Fraction::zero()
            };
            let entry = diagonal + whole(2) * (g[r].clone() * g[c].clone() + cross[(r, c)].clone());
            entry / below.clone()
        })
    }

    /// ġ = (ω ± g × ω + g (g·ω))/2.
    fn rate_of_free_rotation(&mut self, frame: FrameId, g: &Vector) -> Vector {
        let (omega, turned) = self.turn_on_its_side(frame);
        let cross = mechanics::cross(g, &omega);
        let along = g.clone() * g.dot(&omega);
        let sum = if turned {
            omega + cross + along
        } else {
            omega - cross + along
        };
        sum * Fraction::from_ratio(1, 2)
    }

    /// The angular velocity of a frame relative to its parent by its components on the side on which the work frame stands,
    /// and whether that is the side of the frame.
    fn turn_on_its_side(&mut self, frame: FrameId) -> (Vector, bool) {
        let omega = self.link_velocity(frame);
        let turned = self.stands_on(self.work, frame);
        let side = match (turned, self.frames[frame].parent) {
            (false, Some(parent)) => parent,
            _ => frame,
        };
        (
            mechanics::apply(&self.rotation(side, self.work), &omega),
            turned,
        )
    }
}

/// The matrix of the rotation about a unit vector n: `cos θ 1 + sin θ [n]× + (1 − cos θ) n nᵀ` (Rodrigues).
pub(crate) fn about_vector(n: &Vector, cosine: &Fraction, sine: &Fraction) -> Matrix {
    let along = n * n.transpose() * (Fraction::one() - cosine.clone());
    Matrix::from_diagonal_element(cosine.clone()) + mechanics::skew(n) * sine.clone() + along
}

/// The matrix of the rotation about an axis: it takes components on a frame that is turned so to components on its parent.
pub(crate) fn about_axis(axis: usize, cosine: &Fraction, sine: &Fraction) -> Matrix {
    Matrix::from_fn(|r, c| {
        if r == axis || c == axis {
            return whole(i64::from(r == c));
        }
        match ((r + 3 - axis) % 3, (c + 3 - axis) % 3) {
            (1, 2) => -sine.clone(),
            (2, 1) => sine.clone(),
            _ => cosine.clone(),
        }
    })
}
