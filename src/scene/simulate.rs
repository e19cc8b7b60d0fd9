//! Runs a scene, body after body, and hands the results on as they come.

use crate::motion::{Body, MotionError, State};
use crate::scene::{
    Balance, Course, Group, Member, PlanError, Run, Scene, Sensitivity, Unsettled, Way, foresee,
    plan, sensitivity, settle, way,
};
use std::{error, fmt};

/// What one body did.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The state at the end.
    pub last: State<f64>,
    /// The time of that state, s: the duration, unless the run was stopped.
    pub time: f64,
    /// How it was computed.
    pub way: Way,
    /// The error estimated, where it was.
    pub error: Option<f64>,
    /// The largest drift of the energy at the times that were looked at; `None` where it is not conserved.
    pub energy_drift: Option<f64>,
    /// The same of the angular momentum.
    pub momentum_drift: Option<f64>,
    /// The derivative of the final state, where it was asked for.
    pub jacobian: Option<Sensitivity>,
}

/// One row of a trajectory.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// s.
    pub time: f64,
    /// The state.
    pub state: State<f64>,
    /// J.
    pub energy: f64,
}

/// Where results go. Every call may end the run with an error of its own.
pub trait Sink {
    /// What can go wrong there.
    type Error;

    /// A body begins.
    ///
    /// # Errors
    /// As the sink has them; so below.
    fn begin(&mut self, group: &Group, index: u64) -> Result<(), Self::Error>;

    /// A row of its trajectory, if one is asked for.
    ///
    /// # Errors
    /// As above.
    fn row(&mut self, row: &Row) -> Result<(), Self::Error>;

    /// It ends.
    ///
    /// # Errors
    /// As above.
    fn end(&mut self, outcome: &Outcome) -> Result<(), Self::Error>;

    /// Whether to stop, asked between bodies and between rows: the body under way then ends with the last row.
    fn stopped(&self) -> bool {
        false
    }
}

/// Why a scene was not run to its end.
#[derive(Clone, Debug)]
pub enum RunError<E> {
    /// A body that cannot be, or whose motion stopped being finite.
    Motion {
        /// The name of the body.
        body: String,
        /// Why.
        reason: MotionError,
    },
    /// No plan can be made for a body.
    Plan {
        /// The name of the body.
        body: String,
        /// Why.
        reason: PlanError,
    },
    /// From where the results went.
    Sink(E),
}

impl<E: fmt::Display> fmt::Display for RunError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Motion { body, reason } => write!(f, "body {body:?}: {reason}"),
            Self::Plan { body, reason } => write!(f, "body {body:?}: {reason}"),
            Self::Sink(error) => error.fmt(f),
        }
    }
}

impl<E: error::Error> error::Error for RunError<E> {}

/// Runs all bodies of a scene. Memory does not grow with their number nor with the duration. Returns whether the run
/// came to its end, and was not stopped.
///
/// # Errors
/// A body that cannot be or whose motion is not finite; what the sink has to say.
pub fn simulate<S: Sink>(scene: &Scene, sink: &mut S) -> Result<bool, RunError<S::Error>> {
    simulate_from(scene, Seam::default(), sink)
}

/// Where a run goes on that was begun before.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Seam {
    /// The body, counted through the scene from 0; those before it are left out.
    pub body: u64,
    /// The row of its trajectory, from 0; those before it are left out, and of no account for what drifts.
    pub row: u64,
}

/// Runs a scene as [`simulate()`] does from a body and a row on; both come out as if all had been run.
///
/// # Errors
/// As of [`simulate()`].
pub fn simulate_from<S: Sink>(
    scene: &Scene,
    from: Seam,
    sink: &mut S,
) -> Result<bool, RunError<S::Error>> {
    let mut before = 0;
    for group in &scene.groups {
        let skipped = from.body.saturating_sub(before).min(group.count);
        before += group.count;
        if skipped == group.count {
            continue;
        }
        let shared = group.shared_body().map_err(|reason| RunError::Motion {
            body: group.name.clone(),
            reason,
        })?;
        for index in skipped..group.count {
            if sink.stopped() {
                return Ok(false);
            }
            let number = before - group.count + index;
            let row = if number == from.body { from.row } else { 0 };
            if !one(group, index, shared.as_ref(), (&scene.run, row), sink)? {
                return Ok(false);
            }
        }
    }
    Ok(true)
}

/// Runs one member; returns whether it came to its end.
fn one<S: Sink>(
    group: &Group,
    index: u64,
    shared: Option<&Body>,
    (run, row): (&Run, u64),
    sink: &mut S,
) -> Result<bool, RunError<S::Error>> {
    let failed = |reason| RunError::Motion {
        body: group.member_name(index),
        reason,
    };
    let member = group.member(index, shared).map_err(failed)?;
    let way = way(&member, run).map_err(|reason| RunError::Plan {
        body: group.member_name(index),
        reason,
    })?;
    sink.begin(group, index).map_err(RunError::Sink)?;
    let mut outcome = match body(&member, way, (run, row), sink) {
        Ok(outcome) => outcome,
        Err(Broken::Motion(reason)) => return Err(failed(reason)),
        Err(Broken::Sink(error)) => return Err(RunError::Sink(error)),
        // Before its first row: it ends where it began.
        Err(Broken::Stopped) => Outcome::at_start(&member, way),
    };
    let complete = outcome.time >= run.duration;
    if run.outputs.jacobian && complete {
        let last = outcome.last;
        let bound = outcome.way.step_tolerance().unwrap_or(plan::LEAST);
        let found = sensitivity(
            &member,
            &run.wrt,
            group.products,
            run.duration,
            &last,
            bound,
        );
        outcome.jacobian = Some(found.map_err(failed)?);
    }
    sink.end(&outcome).map_err(RunError::Sink)?;
    Ok(complete)
}

enum Broken<E> {
    Motion(MotionError),
    Sink(E),
    Stopped,
}

impl<E> From<MotionError> for Broken<E> {
    fn from(error: MotionError) -> Self {
        Self::Motion(error)
    }
}

impl<E> From<Unsettled> for Broken<E> {
    fn from(error: Unsettled) -> Self {
        match error {
            Unsettled::Motion(error) => Self::Motion(error),
            Unsettled::Stopped => Self::Stopped,
        }
    }
}

fn body<S: Sink>(
    member: &Member,
    way: Way,
    (run, row): (&Run, u64),
    sink: &mut S,
) -> Result<Outcome, Broken<S::Error>> {
    let balance = Balance::new(member);
    let mut outcome = Outcome {
        time: run.duration,
        ..Outcome::at_start(member, way)
    };
    let outputs = &run.outputs;
    let (duration, tolerance) = (run.duration, run.tolerance);
    if outputs.trajectory || outputs.energy || outputs.momentum {
        if run.estimate_error {
            let stop = || sink.stopped();
            let (way, error) = foresee(member, way, duration, tolerance, &stop)?;
            (outcome.way, outcome.error) = (way, Some(error));
        }
        along(member, &balance, (run, row), &mut outcome, sink)?;
        return Ok(outcome);
    }
    if run.estimate_error {
        let settled = settle(member, way, duration, tolerance, &|| sink.stopped())?;
        (outcome.last, outcome.error, outcome.way) = (settled.state, settled.error, settled.way);
    } else {
        outcome.last = Course::new(member, &way)?.at(duration)?;
    }
    let last = outcome.last;
    outcome.note_drift(&balance, duration, &last);
    Ok(outcome)
}

/// Goes through the output times, hands the rows on and keeps the largest drift.
fn along<S: Sink>(
    member: &Member,
    balance: &Balance,
    (run, first): (&Run, u64),
    outcome: &mut Outcome,
    sink: &mut S,
) -> Result<(), Broken<S::Error>> {
    let mut course = Course::new(member, &outcome.way)?;
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
            sink.row(&row).map_err(Broken::Sink)?;
        }
        (outcome.last, outcome.time) = (state, time);
        if n < count && sink.stopped() {
            break;
        }
    }
    Ok(())
}

impl Outcome {
    fn at_start(member: &Member, way: Way) -> Self {
        Self {
            last: member.start,
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
