//! Laws of torque.

use crate::motion::{Number, Quaternion, State};
use nalgebra::{Matrix3, Vector3};

/// The axes that a vector is given in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frame {
    /// Attached to the body.
    Body,
    /// Of fixed orientation.
    Space,
}

/// A torque as a function of time and state, in body axes, N m.
///
/// A closure `|time, state| …` is a law over its own number. A law that is to give Jacobians is generic: it
/// implements this trait for every [`Number`].
///
/// ```
/// use nalgebra::Vector3;
/// use polhode::motion::{Number, State, TorqueLaw};
///
/// /// A drag that grows with the square of the spin about z.
/// struct Drag(f64);
/// impl<T: Number> TorqueLaw<T> for Drag {
///     fn torque(&self, _time: T, state: &State<T>) -> Vector3<T> {
///         let spin = state.angular_velocity.z;
///         Vector3::new(T::zero(), T::zero(), -spin * spin * T::of(self.0))
///     }
/// }
/// let spinning = State::at_rest().turning(Vector3::new(0.0, 0.0, 2.0));
/// assert_eq!(Drag(0.5).torque(0.0, &spinning).z, -2.0);
/// ```
pub trait TorqueLaw<T: Number> {
    /// The torque on the body at `time` (s) in `state`, in body axes. The attitude may be off unit length
    /// by the error of a stage of a step.
    fn torque(&self, time: T, state: &State<T>) -> Vector3<T>;

    /// The axes in which a torque is added to this law when derivatives in the torque are taken.
    fn added_in(&self) -> Frame {
        Frame::Body
    }

    /// Calls `work` with the law, at a place of its own for each of the kinds that it may be of: a loop over many bodies
    /// in there need not ask each time.
    #[inline(always)]
    fn by_kind<R>(self, mut work: impl FnMut(Self) -> R) -> R
    where
        Self: Sized,
    {
        work(self)
    }

    /// Whether the torque depends on ω: the geometric steps take one that does not at less cost.
    fn needs_angular_velocity(&self) -> bool {
        true
    }

    /// The torque at `time` as a constant one and a matrix times ω, if it is such whatever the attitude: then the fast
    /// Jacobians can be taken. Must agree with [`torque`](Self::torque).
    fn without_attitude(&self, _time: f64) -> Option<BodyTorque> {
        None
    }
}

/// A torque that is linear in ω, in body axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyTorque {
    /// The torque on a body at rest, N m.
    pub at_rest: Vector3<f64>,
    /// What ω is multiplied by to be added, `None` for zeros. Row: component of the torque; column: component of ω.
    pub by_angular_velocity: Option<Matrix3<f64>>,
    /// The partial derivative in time.
    pub by_time: Vector3<f64>,
}

impl<T: Number, F: Fn(T, &State<T>) -> Vector3<T>> TorqueLaw<T> for F {
    #[inline(always)]
    fn torque(&self, time: T, state: &State<T>) -> Vector3<T> {
        self(time, state)
    }
}

/// The laws that a scene can name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Torque {
    /// A free body.
    None,
    /// A constant vector, N m.
    Constant {
        /// Where it is constant.
        frame: Frame,
        /// Its components there.
        value: Vector3<f64>,
    },
    /// Gravity along space −Z on a body that turns about a fixed point: the heavy top.
    Gravity {
        /// m g, N.
        weight: f64,
        /// From the fixed point to the centre of mass, body axes, m.
        arm: Vector3<f64>,
    },
    /// −c ω.
    Damping {
        /// c, N m s.
        coefficient: f64,
    },
    /// A sin(w t + φ).
    Sinusoid {
        /// The axes of the amplitude.
        frame: Frame,
        /// A, N m.
        amplitude: Vector3<f64>,
        /// w, rad/s.
        angular_frequency: f64,
        /// φ, rad.
        phase: f64,
    },
}

impl<T: Number> TorqueLaw<T> for Torque {
    #[inline(always)]
    fn torque(&self, time: T, state: &State<T>) -> Vector3<T> {
        match self {
            Self::None => Vector3::from_element(T::zero()),
            Self::Constant { frame, value } => in_body(*frame, &state.attitude, lift(value)),
            Self::Gravity { weight, arm } => {
                let down = Vector3::new(T::zero(), T::zero(), T::of(-*weight));
                lift(arm).cross(&state.attitude.to_body(&down))
            }
            Self::Damping { coefficient } => state.angular_velocity * T::of(-*coefficient),
            Self::Sinusoid {
                frame,
                amplitude,
                angular_frequency,
                phase,
            } => {
                let (sine, _) = (time * T::of(*angular_frequency) + T::of(*phase)).sin_cos();
                in_body(*frame, &state.attitude, lift(amplitude) * sine)
            }
        }
    }

    fn added_in(&self) -> Frame {
        match self {
            Self::Constant { frame, .. } | Self::Sinusoid { frame, .. } => *frame,
            _ => Frame::Body,
        }
    }

    #[inline(always)]
    fn by_kind<R>(self, mut work: impl FnMut(Self) -> R) -> R {
        match self {
            Self::None => work(Self::None),
            Self::Constant {
                frame: Frame::Body,
                value,
            } => work(Self::Constant {
                frame: Frame::Body,
                value,
            }),
            Self::Gravity { weight, arm } => work(Self::Gravity { weight, arm }),
            Self::Damping { coefficient } => work(Self::Damping { coefficient }),
            other => work(other),
        }
    }

    fn needs_angular_velocity(&self) -> bool {
        matches!(self, Self::Damping { .. })
    }

    #[inline(always)]
    fn without_attitude(&self, time: f64) -> Option<BodyTorque> {
        let none = BodyTorque {
            at_rest: Vector3::zeros(),
            by_angular_velocity: None,
            by_time: Vector3::zeros(),
        };
        match *self {
            Self::None => Some(none),
            Self::Constant {
                frame: Frame::Body,
                value,
            } => Some(BodyTorque {
                at_rest: value,
                ..none
            }),
            Self::Damping { coefficient } => Some(BodyTorque {
                by_angular_velocity: Some(Matrix3::from_diagonal_element(-coefficient)),
                ..none
            }),
            Self::Sinusoid {
                frame: Frame::Body,
                amplitude,
                angular_frequency,
                phase,
            } => {
                let (sine, cosine) = (angular_frequency * time + phase).sin_cos();
                Some(BodyTorque {
                    at_rest: amplitude * sine,
                    by_time: amplitude * (cosine * angular_frequency),
                    ..none
                })
            }
            _ => None,
        }
    }
}

impl Torque {
    /// The same law for axes whose columns in the body are `axes`: what stands in body axes is turned.
    pub fn along(&self, axes: &Matrix3<f64>) -> Self {
        let mut law = *self;
        match &mut law {
            Self::Constant {
                frame: Frame::Body,
                value: vector,
            }
            | Self::Gravity { arm: vector, .. }
            | Self::Sinusoid {
                frame: Frame::Body,
                amplitude: vector,
                ..
            } => {
                *vector = axes.tr_mul(vector);
            }
            _ => {}
        }
        law
    }
}

/// A vector of doubles as constants of another number.
#[inline(always)]
pub(crate) fn lift<T: Number>(v: &Vector3<f64>) -> Vector3<T> {
    v.map(T::of)
}

/// The components in the body of a vector that is given in `frame`.
#[inline(always)]
pub(crate) fn in_body<T: Number>(
    frame: Frame,
    attitude: &Quaternion<T>,
    vector: Vector3<T>,
) -> Vector3<T> {
    match frame {
        Frame::Body => vector,
        Frame::Space => attitude.to_body(&vector),
    }
}
