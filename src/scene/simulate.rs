//! Runs a scene, body after body, and hands the results on as they come.

use crate::motion::{MotionError, State};
use crate::scene::{
    Balance, Course, Group, Member, PlanError, Run, Scene, Sensitivity, Way, sensitivity, settle,
    way,
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
    for group in &scene.groups {
        let failed = |index: u64| {
            move |reason| RunError::Motion {
                body: group.member_name(index),
                reason,
            }
        };
        let shared = group.shared_body().map_err(failed(0))?;
        for index in 0..group.count {
            if sink.stopped() {
                return Ok(false);
            }
            let member = group
                .member(index, shared.as_ref())
                .map_err(failed(index))?;
            let way = way(&member, &scene.run).map_err(|reason| RunError::Plan {
                body: group.member_name(index),
                reason,
            })?;
            sink.begin(group, index).map_err(RunError::Sink)?;
            let mut outcome =
                body(&member, way, &scene.run, sink).map_err(|error| match error {
                    Broken::Motion(reason) => failed(index)(reason),
                    Broken::Sink(error) => RunError::Sink(error),
                })?;
            let complete = outcome.time >= scene.run.duration;
            if scene.run.outputs.jacobian && complete {
                let wrt = &scene.run.wrt;
                let (time, last) = (outcome.time, outcome.last);
                let found = sensitivity(
                    &member,
                    wrt,
                    group.products,
                    time,
                    &last,
                    scene.run.tolerance,
                );
                outcome.jacobian = Some(found.map_err(failed(index))?);
            }
            sink.end(&outcome).map_err(RunError::Sink)?;
            if !complete {
                return Ok(false);
            }
        }
    }
    Ok(true)
}

enum Broken<E> {
    Motion(MotionError),
    Sink(E),
}

impl<E> From<MotionError> for Broken<E> {
    fn from(error: MotionError) -> Self {
        Self::Motion(error)
    }
}

fn body<S: Sink>(
    member: &Member,
    way: Way,
    run: &Run,
    sink: &mut S,
) -> Result<Outcome, Broken<S::Error>> {
    let balance = Balance::new(member);
    let (state, error, way) = if run.estimate_error {
        let settled = settle(member, way, run.duration, run.tolerance)?;
        (settled.state, settled.error, settled.way)
    } else {
        (Course::new(member, &way)?.at(run.duration)?, None, way)
    };
    let mut outcome = Outcome {
        last: state,
        time: run.duration,
        way,
        error,
        energy_drift: None,
        momentum_drift: None,
        jacobian: None,
    };
    let outputs = &run.outputs;
    if outputs.trajectory || outputs.energy || outputs.momentum {
        along(member, &balance, run, &mut outcome, sink)?;
    } else {
        outcome.note_drift(&balance, run.duration, &state);
    }
    Ok(outcome)
}

/// Goes through the output times, hands the rows on and keeps the largest drift.
fn along<S: Sink>(
    member: &Member,
    balance: &Balance,
    run: &Run,
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
        let state = course.at(time)?;
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
        if n < count && sink.stopped() {
            (outcome.last, outcome.time) = (state, time);
            return Ok(());
        }
    }
    Ok(())
}

impl Outcome {
    fn note_drift(&mut self, balance: &Balance, time: f64, state: &State<f64>) {
        let larger =
            |old: Option<f64>, new: Option<f64>| new.map(|new| old.unwrap_or(0.0).max(new));
        self.energy_drift = larger(self.energy_drift, balance.energy_drift(state));
        self.momentum_drift = larger(self.momentum_drift, balance.momentum_drift(time, state));
    }
}
