//! The methods that are compared, each with the one setting that trades time for error.

use crate::bench::{Problem, rival};
use crate::mechanics::Products;
use crate::motion::{
    FixedStep, ImplicitMidpoint, MoserVeselov, Number, Quaternion, Rk4, Scheme, Splitting, State,
    Stepper, System, Taylor, Torque,
};
use crate::scene::{
    Course, Member, Reach, Run, Way, Wrt, is_free, jacobian_bound, sensitivity, settle, size, way,
};
use nalgebra::Vector3;
use std::hint::black_box;

/// A method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contender {
    /// What the plan chooses, without an estimate of its error.
    Plan,
    /// The same with the estimate.
    PlanEstimated,
    /// What the plan chooses with the Jacobian in state, torque and inertia, 15 columns.
    PlanJacobian,
    /// The closed form of the free body.
    Exact,
    /// Taylor series, adaptive.
    Taylor,
    /// DOP853, adaptive.
    Dop853,
    /// Classical Runge–Kutta, fixed step.
    Rk4,
    /// Symmetric splitting of order 4, fixed step.
    Splitting,
    /// Implicit midpoint, fixed step.
    Midpoint,
    /// Moser–Veselov of order 4, fixed step.
    MoserVeselov,
    /// DOP853 of `ode_solvers`.
    RivalDop853,
    /// The same for 15 forward differences besides: the Jacobian that it gives a user.
    RivalDifferences,
    /// Dopri5 of `ode_solvers`.
    RivalDopri5,
    /// Classical Runge–Kutta in single precision.
    Rk4Single,
    /// Taylor series of order 6 in single precision, fixed step.
    TaylorSingle,
}

/// All of them, in the order of tables and diagrams.
pub const CONTENDERS: [Contender; 15] = [
    Contender::Plan,
    Contender::PlanEstimated,
    Contender::PlanJacobian,
    Contender::Exact,
    Contender::Taylor,
    Contender::Dop853,
    Contender::Rk4,
    Contender::Splitting,
    Contender::Midpoint,
    Contender::MoserVeselov,
    Contender::RivalDop853,
    Contender::RivalDifferences,
    Contender::RivalDopri5,
    Contender::Rk4Single,
    Contender::TaylorSingle,
];

impl Contender {
    /// As tables have it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Plan => "plan",
            Self::PlanEstimated => "plan with estimate",
            Self::PlanJacobian => "plan and Jacobian",
            Self::Exact => "closed form",
            Self::Taylor => "Taylor",
            Self::Dop853 => "DOP853",
            Self::Rk4 => "RK4",
            Self::Splitting => "splitting, order 4",
            Self::Midpoint => "implicit midpoint",
            Self::MoserVeselov => "Moser–Veselov, order 4",
            Self::RivalDop853 => "ode_solvers DOP853",
            Self::RivalDifferences => "ode_solvers, differences",
            Self::RivalDopri5 => "ode_solvers Dopri5",
            Self::Rk4Single => "RK4, f32",
            Self::TaylorSingle => "Taylor, f32",
        }
    }

    /// Whether its setting is a tolerance; else it is the length of a step as the angle turned in it.
    pub fn is_adaptive(self) -> bool {
        !matches!(
            self,
            Self::Rk4
                | Self::Splitting
                | Self::Midpoint
                | Self::MoserVeselov
                | Self::Rk4Single
                | Self::TaylorSingle
        )
    }

    /// Whether the plan chooses the method.
    pub fn is_planned(self) -> bool {
        matches!(self, Self::Plan | Self::PlanEstimated | Self::PlanJacobian)
    }

    /// Whether it also gives the Jacobian of the end.
    pub fn has_jacobian(self) -> bool {
        matches!(self, Self::PlanJacobian | Self::RivalDifferences)
    }

    /// Where the plan steps by it, if it ever does.
    pub fn reach(self) -> Option<Reach> {
        match self {
            Self::Taylor => Reach::of(&Way::Taylor { tolerance: 0.0 }),
            Self::Dop853 => Reach::of(&Way::Dop853 { tolerance: 0.0 }),
            _ => None,
        }
    }

    /// Whether it can move the body of a problem.
    pub fn takes(self, member: &Member) -> bool {
        self != Self::Exact || is_free(&member.torque)
    }

    /// The settings of a curve, from rough to fine.
    pub fn settings(self) -> Vec<f64> {
        if self == Self::Exact {
            vec![1.0]
        } else if self.is_adaptive() {
            // The plan may err by its tolerance, and mostly errs by much less: it is asked for less to give as much.
            let first = if self.is_planned() { -3 } else { 7 };
            (first..=45)
                .map(|n| 10f64.powf(-f64::from(n) / 3.0))
                .collect()
        } else {
            (0..=8).map(|n| 0.8 * 0.5f64.powi(n)).collect()
        }
    }

    /// The state at the end of a problem; `None` where the method fails.
    pub fn end(self, problem: &Problem, setting: f64) -> Option<State<f64>> {
        let Problem {
            member, duration, ..
        } = problem;
        let by = |way: Way| Course::new(member, &way).ok()?.last(*duration).ok();
        let tolerance = setting;
        match self {
            Self::Plan => by(way(member, &Run::to_the_end(*duration, tolerance)).ok()?),
            Self::PlanEstimated => {
                let way = way(member, &Run::to_the_end(*duration, tolerance)).ok()?;
                let settled = settle(member, way, *duration, tolerance, &|| false);
                settled.ok().map(|settled| settled.state)
            }
            Self::PlanJacobian => {
                let way = way(member, &Run::to_the_end(*duration, tolerance)).ok()?;
                let last = by(way)?;
                let bound = jacobian_bound(&way, tolerance);
                let found = sensitivity(member, &JACOBIAN, ENTRIES, *duration, &last, bound);
                black_box(found.ok()?);
                Some(last)
            }
            Self::Exact => by(Way::Free),
            Self::Taylor => by(Way::Taylor { tolerance }),
            Self::Dop853 => by(Way::Dop853 { tolerance }),
            Self::Rk4 => fixed(Rk4, member, *duration, setting),
            Self::Splitting => fixed(Splitting::FOURTH, member, *duration, setting),
            Self::Midpoint => fixed(ImplicitMidpoint, member, *duration, setting),
            Self::MoserVeselov => fixed(MoserVeselov::FOURTH, member, *duration, setting),
            Self::RivalDop853 => rival::dop853(member, *duration, tolerance),
            Self::RivalDifferences => rival::differences(member, *duration, tolerance),
            Self::RivalDopri5 => rival::dopri5(member, *duration, tolerance),
            Self::Rk4Single => single(Rk4, member, *duration, setting),
            Self::TaylorSingle => single(Taylor::of_order(6), member, *duration, setting),
        }
    }
}

/// All columns but that of the duration, which is the equation of motion.
const JACOBIAN: Wrt = Wrt {
    dt: false,
    ..Wrt::ALL
};
const ENTRIES: Products = Products::Entries;

/// The step in which the body turns by `angle` as it starts.
fn step(member: &Member, duration: f64, angle: f64) -> f64 {
    let speed = size(&member.start.angular_velocity);
    if speed > 0.0 {
        angle / speed
    } else {
        angle * duration
    }
}

fn fixed<S: Scheme<Torque>>(
    scheme: S,
    member: &Member,
    duration: f64,
    angle: f64,
) -> Option<State<f64>> {
    let system = System::principal(&member.body, member.torque);
    let start = member.body.state_along(&member.start);
    let step = step(member, duration, angle);
    let mut motion = FixedStep::new(scheme, system, start, step).ok()?;
    motion.advance_to(duration).ok()?;
    Some(member.body.state_from(motion.state()))
}

fn single<S: Scheme<Torque>>(
    scheme: S,
    member: &Member,
    duration: f64,
    angle: f64,
) -> Option<State<f64>> {
    let inertia = member.body.inertia().map(f32::of);
    let system = System::over(inertia, member.torque, Vector3::from_element(0.0_f32));
    let start = &member.start;
    let mut state = State {
        attitude: Quaternion::new(start.attitude.components().map(f32::of)),
        angular_velocity: start.angular_velocity.map(f32::of),
    };
    let count = (duration / step(member, duration, angle)).ceil().max(1.0);
    let step = duration / count;
    for n in 0..count as u64 {
        let time = f32::of(n as f64 * step);
        state = scheme.step(&system, time, &state, f32::of(step));
    }
    let state = State {
        attitude: Quaternion::new(state.attitude.components().map(f64::from)).normalised(),
        angular_velocity: state.angular_velocity.map(f64::from),
    };
    state.is_finite().then_some(state)
}
