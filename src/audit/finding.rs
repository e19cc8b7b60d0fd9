//! What an audit found.

use std::fmt;

/// What an acceleration or a step does otherwise than the equation says.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Finding {
    /// The term ω × Iω.
    Gyroscopic(Gyroscopic),
    /// Of the tensor only the diagonal is used.
    DiagonalOnly(Where),
    /// The products of inertia have the other sign.
    ProductsNegated(Where),
    /// The torque acts with the other sign.
    TorqueNegated,
    /// The torque does not act.
    TorqueIgnored,
    /// The torque is given in body axes and used as if it stood in space axes, or turned the wrong way.
    TorqueInOtherAxes,
    /// The tensor of the body axes is used in space axes, as if it did not turn with the body.
    TensorInSpaceAxes,
    /// The angular velocity that comes back stands in space axes.
    VelocityInSpaceAxes,
    /// How the attitude follows the angular velocity.
    Attitude(Turning),
    /// The attitude comes back as (x, y, z, w).
    QuaternionOrder,
    /// The attitude comes back off unit length by this.
    NotUnit(f64),
    /// As the step goes to zero the state does not come back to where it was, or its rates have no limit.
    NoLimit,
    /// It is none of the equations that are known here; the relative difference from the right one.
    Unknown(f64),
    /// The attitude turns in none of the ways that are known here; the relative difference from the right one.
    UnknownTurning(f64),
    /// A free body gains energy without bound at this step.
    Unstable(Witnesses),
    /// A free body's energy or momentum drifts by more than a hundredth in the run.
    Drift(Witnesses),
}

/// What is wrong with ω × Iω.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gyroscopic {
    /// It is not there.
    Missing,
    /// It has the other sign.
    Negated,
    /// It counts twice.
    Doubled,
    /// It counts half.
    Halved,
}

/// Where a wrong tensor stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Where {
    /// In ω × Iω and in the inverse.
    Everywhere,
    /// In ω × Iω alone.
    Gyroscopic,
    /// In the inverse alone.
    Inverse,
}

/// How an attitude turns that should obey q̇ = ½ q ω.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turning {
    /// It does not.
    Not,
    /// By ½ ω q: ω of the body axes applied as one of space axes.
    InSpaceAxes,
    /// By −½ q ω: as the conjugate.
    Backwards,
    /// Twice as fast: the ½ is lost.
    Twice,
    /// Half as fast.
    Half,
    /// As if its components were in the order x, y, z, w.
    InOtherOrder,
}

/// What a free run at the audited step kept: the largest changes on the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Witnesses {
    /// The length of the step, s.
    pub step: f64,
    /// Steps taken.
    pub steps: usize,
    /// Relative change of the kinetic energy.
    pub energy: f64,
    /// Relative change of the momentum's size.
    pub momentum: f64,
    /// The angle by which the momentum has turned in space, rad.
    pub turned: f64,
}

/// What was found, in the order of weight. Its `Display` says it in words.
#[derive(Clone, Debug, PartialEq)]
pub struct Audit {
    pub(super) findings: Vec<Finding>,
    pub(super) witnesses: Option<Witnesses>,
    pub(super) order: Option<f64>,
    pub(super) unseen: Vec<Unseen>,
}

/// What this body does not show, whatever the code does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unseen {
    /// Its products of inertia are zero.
    Products,
    /// Its moments are equal, so ω × Iω is zero.
    Gyroscopic,
}

impl Audit {
    /// What is wrong; empty if nothing is.
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// Whether nothing was found.
    pub fn is_clean(&self) -> bool {
        self.findings.is_empty()
    }

    /// What the free run of a step kept.
    pub fn witnesses(&self) -> Option<&Witnesses> {
        self.witnesses.as_ref()
    }

    /// What nothing is said about, as the body does not show it: audit another one as well.
    pub fn unseen(&self) -> &[Unseen] {
        &self.unseen
    }

    /// The order of a step: its error over a fixed span falls with this power of its length. `None` for an acceleration, and
    /// where rounding hides it.
    pub fn order(&self) -> Option<f64> {
        self.order
    }
}

impl fmt::Display for Audit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.findings.len() {
            0 => write!(f, "nothing wrong was found")?,
            1 => write!(f, "1 thing is wrong:")?,
            count => write!(f, "{count} things are wrong:")?,
        }
        for finding in &self.findings {
            write!(f, "\n  {finding}")?;
        }
        if let Some(order) = self.order {
            write!(f, "\nthe step is of order {order:.1}")?;
        }
        let told = |finding: &Finding| matches!(finding, Finding::Unstable(_) | Finding::Drift(_));
        if let Some(witnesses) = &self.witnesses
            && !self.findings.iter().any(told)
        {
            write!(f, "\na free run: {witnesses}")?;
        }
        for unseen in &self.unseen {
            let what = match unseen {
                Unseen::Products => {
                    "the products of inertia are zero, so nothing is said about them"
                }
                Unseen::Gyroscopic => "the moments are equal, so nothing is said about ω × Iω",
            };
            write!(f, "\n{what}: audit another body as well")?;
        }
        Ok(())
    }
}

impl fmt::Display for Witnesses {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "within {} steps of {} s the energy changes by up to {:+.1e} of itself, the size of the momentum by {:+.1e} \
             and its direction in space by {:.1e} rad",
            self.steps, self.step, self.energy, self.momentum, self.turned
        )
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Gyroscopic(slip) => {
                let (what, then) = match slip {
                    Gyroscopic::Missing => ("is missing", "subtract it from the torque"),
                    Gyroscopic::Negated => ("has the wrong sign", "I ω̇ = M − ω × Iω"),
                    Gyroscopic::Doubled => ("counts twice", "subtract it once"),
                    Gyroscopic::Halved => ("counts half", "subtract it whole"),
                };
                write!(f, "the gyroscopic term ω × Iω {what}: {then}")
            }
            Self::DiagonalOnly(place) => {
                write!(f, "only the diagonal of the inertia tensor is used{place}: its products count too")
            }
            Self::ProductsNegated(place) => write!(
                f,
                "the products of inertia have the other sign{place}: the tensor holds −∫xy dm off its diagonal"
            ),
            Self::TorqueNegated => f.write_str("the torque acts with the wrong sign"),
            Self::TorqueIgnored => f.write_str("the torque has no effect"),
            Self::TorqueInOtherAxes => {
                f.write_str("body and space axes are mixed: the torque in body axes is taken in other ones")
            }
            Self::TensorInSpaceAxes => f.write_str(
                "body and space axes are mixed: the tensor of the body axes is used with vectors in space axes. \
                 In space axes it is R I Rᵀ",
            ),
            Self::VelocityInSpaceAxes => f.write_str(
                "body and space axes are mixed: the angular velocity goes in along body axes and comes back along space axes",
            ),
            Self::Attitude(turning) => write!(f, "{turning}; it should turn by q̇ = ½ q ω"),
            Self::QuaternionOrder => f.write_str(
                "the attitude comes back in the order x, y, z, w and went in as w, x, y, z",
            ),
            Self::NotUnit(off) => {
                write!(f, "the attitude comes back off unit length by {off:.1e}: normalise it")
            }
            Self::NoLimit => f.write_str(
                "as the step goes to zero the change of the state over it has no limit: the step depends on something else \
                 than the state, or its length is not what it was asked for",
            ),
            Self::Unknown(off) => write!(
                f,
                "the acceleration is off by {off:.1e} of itself, in none of the ways that are known here"
            ),
            Self::UnknownTurning(off) => write!(
                f,
                "the attitude turns at a rate that is off by {off:.1e} of ω, in none of the ways that are known here"
            ),
            Self::Unstable(witnesses) => write!(
                f,
                "a free body gains energy at this step, as with an explicit gyroscopic term: {witnesses}. \
                 Take a shorter step, or the term implicitly"
            ),
            Self::Drift(witnesses) => write!(f, "a free body drifts at this step: {witnesses}"),
        }
    }
}

impl fmt::Display for Where {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Everywhere => "",
            Self::Gyroscopic => " in ω × Iω",
            Self::Inverse => " in the inverse",
        })
    }
}

impl fmt::Display for Turning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Not => "the attitude does not turn",
            Self::InSpaceAxes => {
                "body and space axes are mixed: the attitude turns by ½ ω q, as if ω stood in space axes"
            }
            Self::Backwards => "the attitude turns backwards, as the conjugate quaternion",
            Self::Twice => "the attitude turns twice as fast: the ½ is lost",
            Self::Half => "the attitude turns half as fast",
            Self::InOtherOrder => {
                "the attitude turns as if its components stood in the order x, y, z, w"
            }
        })
    }
}
