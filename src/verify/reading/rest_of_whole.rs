//! The mass centre of a part of which nothing is told, where that of the whole and of the other parts stand.

use crate::verify::model::system::{FrameId, PointId, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::points_spoken::Spoken;

impl Builder<'_> {
    /// "C, the mass centre of the spacecraft, is fixed in the hub": where the last of the parts is of which nothing is told
    /// follows from C and the others.
    pub(super) fn leave_rest_of_wholes(&self, all: &mut [Spoken]) {
        for whole in 0..self.reading.system.bodies.len() {
            let parts = self.reading.system.wholes(whole);
            let told = all.iter().position(|s| s.centre_of == Some(whole));
            let Some(place) = told.filter(|_| parts != [whole]) else {
                continue;
            };
            let fixed_in = all[place].fixed_in.clone();
            let carries = |part: &usize| {
                self.frame_of_part(*part)
                    .is_some_and(|f| fixed_in.contains(&f))
            };
            let own = |part: usize| all.iter().position(|s| s.is_centre_of(part));
            let untold = |part: &usize| {
                let own = own(*part).filter(|at| {
                    all[*at].lies.is_none() && all[*at].fixed_in.is_empty() && *at != place
                })?;
                let placed = carries(part) || self.has_ends(*part);
                let each = self.reading.system.bodies[*part].members.is_some();
                (!placed && !each).then_some((*part, own))
            };
            let last = parts.iter().rev().find_map(untold);
            let Some((part, own_place)) = last.filter(|_| parts.iter().any(carries)) else {
                continue;
            };
            let stays = |frame: &FrameId| {
                let mut others = parts.iter().filter(|other| **other != part);
                others.all(|other| {
                    let fixed = own(*other).is_some_and(|at| all[at].fixed_in.contains(frame));
                    fixed || self.frame_of_part(*other) == Some(*frame)
                })
            };
            let stays: Vec<FrameId> = fixed_in.iter().copied().filter(stays).collect();
            all[place].centre_of = None;
            all[place].also_centre_of.push(whole);
            all[own_place].fixed_in = stays;
            all[own_place].rest_of = Some(whole);
        }
    }

    /// Where the mass centre of a part is, from those of the whole and of the other parts: (m r − Σ mᵢ rᵢ) over the part's mass.
    pub(super) fn centre_of_rest(&mut self, spoken: &Spoken) -> Option<(PointId, Vector)> {
        let (whole, part) = (spoken.rest_of?, spoken.centre_of?);
        let centre = self.centre_of(whole);
        let mut sum = Vector::zeros();
        for other in self.reading.system.wholes(whole) {
            if other != part {
                let mass = self.reading.system.bodies[other].mass.clone();
                let own = self.centre_of(other);
                let way = self.reading.system.position(own, centre) * mass;
                sum -= self.reading.system.each_over_members(other, way);
            }
        }
        Some((centre, sum / self.reading.system.bodies[part].mass.clone()))
    }

    fn frame_of_part(&self, body: usize) -> Option<FrameId> {
        self.reading.system.bodies[body].frame
    }
}
