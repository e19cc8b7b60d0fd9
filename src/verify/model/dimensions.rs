//! Space of another number of dimensions than three: an angular velocity is a skew-symmetric matrix Ω = Ṙ Rᵀ there, and
//! no vector. A vector that a frame carries changes at the rate Ω v.
//!
//! Entries are those on the work frame, as everywhere in the model.

use crate::algebra::{Fraction, Place};
use crate::verify::model::atoms::{Key, Motion, fraction};
use crate::verify::model::system::{FrameId, PointId, System, Turn, component_text};
use nalgebra::{DMatrix, DVector};
use num_traits::Zero;

impl System {
    /// How many dimensions space has here.
    pub(crate) fn dimensions(&self) -> usize {
        self.atoms.dimensions.unwrap_or(3)
    }

    /// Says how many dimensions space has from here on.
    pub(crate) fn set_dimensions(&mut self, dimensions: usize) {
        self.atoms.dimensions = (dimensions != 3).then_some(dimensions);
    }

    /// The matrix Ω of one frame relative to another; `None` where an axis or an angle tells how they turn.
    pub(crate) fn angular_velocity_matrix(
        &mut self,
        of: FrameId,
        relative: FrameId,
    ) -> Option<DMatrix<Fraction>> {
        let (up, down) = (self.links(of, relative), self.links(relative, of));
        let size = self.dimensions();
        let mut sum = DMatrix::from_element(size, size, Fraction::zero());
        for link in up {
            sum += self.link_matrix(link)?;
        }
        for link in down {
            sum -= self.link_matrix(link)?;
        }
        Some(sum)
    }

    /// Ω of a frame relative to its parent: each entry above the diagonal is free.
    fn link_matrix(&mut self, frame: FrameId) -> Option<DMatrix<Fraction>> {
        let size = self.dimensions();
        let free = match self.frames[frame].turn {
            Turn::Fixed => false,
            Turn::Free => true,
            Turn::Angle(..) | Turn::About(..) | Turn::Rate(..) => return None,
        };
        let mut matrix = DMatrix::from_element(size, size, Fraction::zero());
        for (row, column) in (0..size).flat_map(|r| (0..r).map(move |c| (c, r))) {
            if free {
                let name = &self.frames[frame].name;
                let text = format!("\\Omega^{{{name}}}_{{{}{}}}", row + 1, column + 1);
                let variable = self
                    .atoms
                    .variable(Key::new(text), Place::Rate, Motion::Free);
                matrix[(row, column)] = fraction(variable);
                matrix[(column, row)] = -fraction(variable);
            }
        }
        Some(matrix)
    }

    /// A vector by its letter: one that a frame carries, or one that is free. `None` as for [`Self::angular_velocity_matrix`].
    pub(crate) fn vector_in_space(
        &mut self,
        text: &str,
        carried: Option<FrameId>,
    ) -> Option<DVector<Fraction>> {
        let size = self.dimensions();
        let motion = || carried.map_or(Motion::Free, |_| Motion::Constant);
        let mut new = false;
        let variables: Vec<_> = (0..size)
            .map(|row| {
                let key = Key::new(component_text(text, row));
                new |= self.atoms.find(&key).is_none();
                self.atoms.variable(key, Place::Coordinate, motion())
            })
            .collect();
        let vector = DVector::from_iterator(size, variables.iter().map(|v| fraction(*v)));
        if let Some(frame) = carried
            && new
            && frame != self.work
        {
            let rates = self.angular_velocity_matrix(frame, self.work)? * &vector;
            for (variable, rate) in variables.into_iter().zip(rates.iter()) {
                self.atoms.atom_mut(variable).motion = Motion::Rate(rate.clone());
            }
        }
        Some(vector)
    }

    /// The position of one point from another; `None` where lengths along axes tell where one lies.
    pub(crate) fn position_in_space(
        &mut self,
        of: PointId,
        from: PointId,
    ) -> Option<DVector<Fraction>> {
        Some(self.way_in_space(of)? - self.way_in_space(from)?)
    }

    fn way_in_space(&mut self, point: PointId) -> Option<DVector<Fraction>> {
        let mut sum = DVector::from_element(self.dimensions(), Fraction::zero());
        let mut at = point;
        while let Some((from, way)) = self.points[at].placed.clone() {
            if !way.iter().all(Zero::is_zero) {
                let text = format!("r_{{{}}}", self.points[at].name);
                let letter = way[0].as_variable()?;
                if self.atoms.atom(letter).key.text != component_text(&text, 0) {
                    return None;
                }
                let mut shared = self.points[at].fixed_in.iter();
                let shared = shared.find(|frame| self.points[from].fixed_in.contains(frame));
                sum += self.vector_in_space(&text, shared.copied())?;
            }
            at = from;
        }
        Some(sum)
    }
}
