//! Runs a scene, body after body, and hands the results on as they come.

mod compute;
mod several;

use crate::motion::{MotionError, State};
use crate::scene::{Group, PlanError, Scene, Sensitivity, Way};
use compute::{Broken, Task};
use std::convert::Infallible;
use std::{error, fmt};

/// What one body did.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The state at the end.
    pub last: State<f64>,
    /// Whether its attitude is known: it is not computed where nobody asks for it and the torque does not look at it.
    pub has_attitude: bool,
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

    /// Says whether to stop, asked between bodies and between rows on every thread that computes: a body under way then
    /// ends with the last row.
    fn stop(&self) -> fn() -> bool {
        || false
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
/// With the feature `parallel` several bodies are computed at once, unless their trajectories are asked for; the results
/// are the same, in the same order.
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
        let row = if skipped > 0 || before == from.body {
            from.row
        } else {
            0
        };
        before += group.count;
        if skipped == group.count {
            continue;
        }
        let shared = group.shared_body().map_err(|reason| RunError::Motion {
            body: group.name.clone(),
            reason,
        })?;
        let task = Task {
            group,
            shared: shared.as_ref(),
            run: &scene.run,
        };
        let complete = if scene.run.outputs.trajectory {
            one_by_one(&task, skipped, row, sink)?
        } else {
            in_shares(&task, skipped, sink)?
        };
        if !complete {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Runs the members from the first on, and hands on their rows as they come; whether all came to their end.
fn one_by_one<S: Sink>(
    task: &Task<'_>,
    first: u64,
    row: u64,
    sink: &mut S,
) -> Result<bool, RunError<S::Error>> {
    let stop = sink.stop();
    for index in first..task.group.count {
        if stop() {
            return Ok(false);
        }
        sink.begin(task.group, index).map_err(RunError::Sink)?;
        let from = if index == first { row } else { 0 };
        let outcome = task
            .compute(index, from, &mut |row| sink.row(row), &stop)
            .map_err(|broken| broken.of(task.group.member_name(index), |error| error))?;
        sink.end(&outcome).map_err(RunError::Sink)?;
        if outcome.time < task.run.duration {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Runs the members from the first on, several at once, and hands on their ends in order; whether all came to it.
fn in_shares<S: Sink>(
    task: &Task<'_>,
    first: u64,
    sink: &mut S,
) -> Result<bool, RunError<S::Error>> {
    let stop = sink.stop();
    let mut shares = several::Shares::new(first..task.group.count);
    while let Some(share) = shares.next() {
        if stop() {
            return Ok(false);
        }
        let all = several::map(share.clone(), |index| {
            task.compute::<Infallible>(index, 0, &mut |_| Ok(()), &stop)
        });
        for (index, found) in share.zip(all) {
            let name = || task.group.member_name(index);
            let outcome = found.map_err(|broken| broken.of(name(), |never| match never {}))?;
            sink.begin(task.group, index).map_err(RunError::Sink)?;
            sink.end(&outcome).map_err(RunError::Sink)?;
            if outcome.time < task.run.duration {
                return Ok(false);
            }
        }
    }
    Ok(true)
}

impl<E> Broken<E> {
    fn of<F>(self, body: String, of_sink: impl FnOnce(E) -> F) -> RunError<F> {
        match self {
            Self::Motion(reason) => RunError::Motion { body, reason },
            Self::Plan(reason) => RunError::Plan { body, reason },
            Self::Sink(error) => RunError::Sink(of_sink(error)),
        }
    }
}
