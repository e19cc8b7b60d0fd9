//! Loads: forces at points and couples, as long as they act or as a blow.

use crate::mechanics;
use crate::verify::model::system::{BodyId, PointId, System, Vector};

/// How long a load acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lasting {
    /// As long as the motion does: it changes the momentum at a rate.
    Always,
    /// For an instant, on a body at rest: the momentum is what it brings.
    Blow,
}

/// What a load is called.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Called {
    /// By a letter, as it is written.
    Letter(String),
    /// By its noun, as what acts on a body.
    Noun(String, BodyId),
    /// By its noun, as what a body does to another one, which comes last.
    Between(&'static str, BodyId, BodyId),
    Nothing,
}

/// A load on a body.
#[derive(Clone, Debug)]
pub(crate) struct Load {
    pub(crate) called: Called,
    /// Where the force acts; a couple acts nowhere.
    pub(crate) at: Option<PointId>,
    /// The force, or the moment of the couple.
    pub(crate) value: Vector,
    pub(crate) lasting: Lasting,
    /// The body on which a sentence says that it acts.
    pub(crate) on: Option<BodyId>,
    /// Whether it is a part of another load, which is counted already.
    pub(crate) part: bool,
    /// Whether a sentence says which loads are the only ones on the body.
    pub(crate) listed: bool,
}

impl Load {
    /// A force where it acts, or a couple, that no sentence calls by a name.
    pub(crate) fn unnamed(at: Option<PointId>, value: Vector, on: Option<BodyId>) -> Self {
        Self {
            called: Called::Nothing,
            at,
            value,
            lasting: Lasting::Always,
            on,
            part: false,
            listed: false,
        }
    }

    /// What the body on which another one acts does to that.
    pub(crate) fn opposite(&self) -> Option<Self> {
        let Called::Between(head, agent, on) = self.called else {
            return None;
        };
        Some(Self {
            called: Called::Between(head, on, agent),
            value: -self.value.clone(),
            on: Some(agent),
            ..self.clone()
        })
    }

    fn force(&self) -> Vector {
        match self.at {
            Some(_) => self.value.clone(),
            None => Vector::zeros(),
        }
    }
}

impl System {
    /// What all loads on a body come to: its force, or the momentum that a blow brings it.
    pub(crate) fn whole_load(&mut self, body: BodyId, lasting: Lasting) -> Vector {
        match lasting {
            Lasting::Always => self.total_force(body),
            Lasting::Blow => self.momentum(body, self.ground),
        }
    }

    /// The moment that all loads on a body have about a point, or the angular momentum that a blow brings it.
    pub(crate) fn whole_moment(
        &mut self,
        body: BodyId,
        about: PointId,
        lasting: Lasting,
    ) -> Vector {
        use crate::verify::model::bodies::Velocities::Absolute;
        match lasting {
            Lasting::Always => self.total_moment(body, about),
            Lasting::Blow => self.angular_momentum(body, about, self.ground, Absolute),
        }
    }

    /// What is left of the whole load beside some.
    pub(crate) fn rest_of_load(
        &mut self,
        body: BodyId,
        loads: &[Load],
        lasting: Lasting,
    ) -> Vector {
        let whole = self.whole_load(body, lasting);
        loads.iter().fold(whole, |rest, load| rest - load.force())
    }

    /// What is left of the whole moment about a point beside that of some loads.
    pub(crate) fn rest_of_moment(
        &mut self,
        body: BodyId,
        about: PointId,
        loads: &[Load],
        lasting: Lasting,
    ) -> Vector {
        self.whole_moment(body, about, lasting) - self.moment_of_loads(loads, about)
    }

    /// The moment of some loads about a point.
    pub(crate) fn moment_of_loads(&self, loads: &[Load], about: PointId) -> Vector {
        let moments = loads.iter().map(|load| match load.at {
            Some(at) => mechanics::cross(&self.position(at, about), &load.value),
            None => load.value.clone(),
        });
        moments.fold(Vector::zeros(), |sum, moment| sum + moment)
    }
}
