//! The motion of one body, from its draw to its outcome.

use crate::motion::{Body, MotionError, State};
use crate::scene::{
    Balance, Course, Group, Member, Outcome, PlanError, Row, Run, Unsettled, Way, foresee, plan,
    sensitivity, settle, way,
};

/// The members of a group and what is asked of them.
pub(super) struct Task<'a> {
    pub(super) group: &'a Group,
    /// The body that all members share, if they share one.
    pub(super) shared: Option<&'a Body>,
    pub(super) run: &'a Run,
}

/// Why a body has no outcome.
pub(super) enum Broken<E> {
    Motion(MotionError),
    Plan(PlanError),
    Sink(E),
}

impl<E> From<MotionError> for Broken<E> {
    fn from(error: MotionError) -> Self {
        Self::Motion(error)
    }
}

/// What a motion under way asks whether to stop.
type Stop<'a> = &'a (dyn Fn() -> bool + 'a);

impl Task<'_> {
    /// The outcome of a member; its rows go to `each`, from the row `first` on. One that is stopped ends where it is.
    pub(super) fn compute<E>(
        &self,
        index: u64,
        first: u64,
        each: &mut dyn FnMut(&Row) -> Result<(), E>,
        stop: Stop<'_>,
    ) -> Result<Outcome, Broken<E>> {
        let member = self.group.member(index, self.shared)?;
        let way = way(&member, self.run).map_err(Broken::Plan)?;
        let mut outcome = match self.moved(&member, way, first, each, stop) {
            Ok(outcome) => outcome,
            // Before its first row: it ends where it began.
            Err(Halt::Stopped) => Outcome::at_start(&member, way),
            Err(Halt::Broken(broken)) => return Err(broken),
        };
        if self.run.outputs.jacobian && outcome.time >= self.run.duration {
            let bound = plan::jacobian_bound(&outcome.way, self.run.tolerance);
            let (wrt, duration) = (&self.run.wrt, self.run.duration);
            let products = self.group.products;
            let found = sensitivity(&member, wrt, products, duration, &outcome.last, bound)?;
            outcome.jacobian = Some(found);
        }
        Ok(outcome)
    }

    fn moved<E>(
        &self,
        member: &Member,
        way: Way,
        first: u64,
        each: &mut dyn FnMut(&Row) -> Result<(), E>,
        stop: Stop<'_>,
    ) -> Result<Outcome, Halt<E>> {
        let run = self.run;
        let balance = Balance::new(member);
        let mut outcome = Outcome {
            time: run.duration,
            ..Outcome::at_start(member, way)
        };
        let (outputs, duration, tolerance) = (&run.outputs, run.duration, run.tolerance);
        if outputs.trajectory || outputs.energy || outputs.momentum {
            if run.estimate_error {
                let (way, error) = foresee(member, way, duration, tolerance, stop)?;
                (outcome.way, outcome.error) = (way, Some(error));
            }
            self.along(member, &balance, first, &mut outcome, each, stop)?;
            return Ok(outcome);
        }
        if run.estimate_error {
            let settled = settle(member, way, duration, tolerance, stop)?;
            (outcome.last, outcome.error, outcome.way) =
                (settled.state, settled.error, settled.way);
        } else {
            outcome.last = Course::new(member, &way)?.last(duration)?;
        }
        let last = outcome.last;
        outcome.note_drift(&balance, duration, &last);
        Ok(outcome)
    }

    /// Goes through the output times, hands the rows on and keeps the largest drift.
    fn along<E>(
        &self,
        member: &Member,
        balance: &Balance,
        first: u64,
        outcome: &mut Outcome,
        each: &mut dyn FnMut(&Row) -> Result<(), E>,
        stop: Stop<'_>,
    ) -> Result<(), Halt<E>> {
        let run = self.run;
        let mut course = Course::new(member, &outcome.way)?;
        if plan::spares_attitude(member, run, &outcome.way) {
            course = course.without_attitude();
            outcome.has_attitude = false;
        }
        // A duration of 10 in intervals of 0.1 has 100 of them, although 0.1 is no number of halves.
        let count = (run.duration / run.output_interval * (1.0 - 4.0 * f64::EPSILON)).ceil() as u64;
        for n in 0..=count {
            let time = match n {
                n if n == count => run.duration,
                n => n as f64 * run.output_interval,
            };
            // Steps of fixed length end at each output time, and others go past it.
            if n < first && !matches!(course, Course::Rk4(_)) {
                continue;
            }
            let state = course.at(time)?;
            if n < first {
                continue;
            }
            outcome.note_drift(balance, time, &state);
            if run.outputs.trajectory {
                let energy = balance.energy(&state);
                let row = Row {
                    time,
                    state,
                    energy,
                };
                each(&row).map_err(|error| Halt::Broken(Broken::Sink(error)))?;
            }
            (outcome.last, outcome.time) = (state, time);
            if n < count && stop() {
                break;
            }
        }
        Ok(())
    }
}

/// Why a motion did not come to its end.
enum Halt<E> {
    Broken(Broken<E>),
    Stopped,
}

impl<E> From<MotionError> for Halt<E> {
    fn from(error: MotionError) -> Self {
        Self::Broken(Broken::Motion(error))
    }
}

impl<E> From<Unsettled> for Halt<E> {
    fn from(error: Unsettled) -> Self {
        match error {
            Unsettled::Motion(error) => error.into(),
            Unsettled::Stopped => Self::Stopped,
        }
    }
}

impl Outcome {
    fn at_start(member: &Member, way: Way) -> Self {
        Self {
            last: member.start,
            has_attitude: true,
            time: 0.0,
            way,
            error: None,
            energy_drift: None,
            momentum_drift: None,
            jacobian: None,
        }
    }

    fn note_drift(&mut self, balance: &Balance, time: f64, state: &State<f64>) {
        let larger =
            |old: Option<f64>, new: Option<f64>| new.map(|new| old.unwrap_or(0.0).max(new));
        self.energy_drift = larger(self.energy_drift, balance.energy_drift(state));
        self.momentum_drift = larger(self.momentum_drift, balance.momentum_drift(time, state));
    }
}
