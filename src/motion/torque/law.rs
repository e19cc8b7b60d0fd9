//! The laws that the library knows.

use super::{Frame, LinearTorque, SpaceLoad, TorqueLaw, in_body};
use crate::motion::sines::{cosines, sines};
use crate::motion::{Number, State};
use crate::scalar::Jet;
use nalgebra::{Matrix3, Scalar, Vector3};
use num_dual::{Dual64, HyperDual64};
use num_traits::Zero;
use std::ops::Neg;

/// What a [`Law`] is made of, over numbers `T`: doubles, or the numbers themselves where the law is to be differentiated in it.
pub trait Coefficient<T: Number>: Scalar + Copy + Zero + Neg<Output = Self> {
    /// Whether it has no derivatives.
    const CONSTANT: bool;

    /// Its product with a number.
    fn times(self, number: T) -> T;

    /// Itself as a number.
    fn number(self) -> T;

    /// Its value.
    fn value(self) -> f64;
}

impl<T: Number> Coefficient<T> for f64 {
    const CONSTANT: bool = true;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn times(self, number: T) -> T {
        number.scaled(self)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn number(self) -> T {
        T::of(self)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn value(self) -> f64 {
        self
    }
}

macro_rules! variable {
    ($([$($generics:tt)*] $number:ty, $value:ident;)*) => {$(
        impl<$($generics)*> Coefficient<$number> for $number {
            const CONSTANT: bool = false;

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn times(self, number: Self) -> Self {
                self * number
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn number(self) -> Self {
                self
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn value(self) -> f64 {
                self.$value
            }
        }
    )*};
}

variable! {
    [const N: usize] Jet<f64, N>, value;
    [] Dual64, re;
    [] HyperDual64, re;
}

/// A law of the library with numbers, as a scene can name it.
pub type Torque = Law<f64>;

/// The laws that the library knows.
///
/// Of doubles each is a [`Torque`]. Of dual numbers it has derivatives in what it is made of: damping, weight, arm, amplitude,
/// frequency and phase, as in [`by_parameters`](crate::motion::jacobian::by_parameters).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law<C> {
    /// A free body.
    None,
    /// A constant vector, N m.
    Constant {
        /// Where it is constant.
        frame: Frame,
        /// Its components there.
        value: Vector3<C>,
    },
    /// Gravity along space −Z on a body that turns about a fixed point: the heavy top.
    Gravity {
        /// m g, N.
        weight: C,
        /// From the fixed point to the centre of mass, body axes, m.
        arm: Vector3<C>,
    },
    /// −c ω.
    Damping {
        /// c, N m s.
        coefficient: C,
    },
    /// A sin(w t + φ).
    Sinusoid {
        /// The axes of the amplitude.
        frame: Frame,
        /// A, N m.
        amplitude: Vector3<C>,
        /// w, rad/s.
        angular_frequency: C,
        /// φ, rad.
        phase: C,
    },
}

impl<T: Number, C: Coefficient<T>> TorqueLaw<T> for Law<C> {
    const LINEAR: bool = C::CONSTANT;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn torque(&self, time: T, state: &State<T>) -> Vector3<T> {
        match self {
            Self::None => Vector3::from_element(T::zero()),
            Self::Constant { frame, value } => match frame {
                Frame::Body => value.map(C::number),
                Frame::Space => state.attitude.constant_to_body(value),
            },
            Self::Gravity { weight, arm } => {
                let down = Vector3::new(C::zero(), C::zero(), -*weight);
                let seen = state.attitude.constant_to_body(&down);
                Vector3::new(
                    arm.y.times(seen.z) - arm.z.times(seen.y),
                    arm.z.times(seen.x) - arm.x.times(seen.z),
                    arm.x.times(seen.y) - arm.y.times(seen.x),
                )
            }
            Self::Damping { coefficient } => {
                let against = -*coefficient;
                state.angular_velocity.map(|omega| against.times(omega))
            }
            Self::Sinusoid { .. } => {
                let [reading, ..] = self.clock([time; 3]);
                self.torque_by(reading, state, &Vector3::zeros())
            }
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn clock(&self, times: [T; 3]) -> [T; 3] {
        match self {
            Self::Sinusoid {
                angular_frequency,
                phase,
                ..
            } => {
                let mut angles = times;
                for angle in &mut angles {
                    *angle = angular_frequency.times(*angle) + phase.number();
                }
                T::sines(angles)
            }
            _ => times,
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn torque_by(&self, reading: T, state: &State<T>, added: &Vector3<T>) -> Vector3<T> {
        let (frame, own) = match self {
            Self::Constant {
                frame: Frame::Space,
                value,
            } => (Frame::Space, value.map(C::number)),
            Self::Sinusoid {
                frame, amplitude, ..
            } => (*frame, amplitude.map(|most| most.times(reading))),
            // In body axes, as what is added.
            _ => (Frame::Body, self.torque(reading, state)),
        };
        // What stands in space is turned as one.
        in_body(frame, &state.attitude, own + added)
    }

    fn added_in(&self) -> Frame {
        match self {
            Self::Constant { frame, .. } | Self::Sinusoid { frame, .. } => *frame,
            _ => Frame::Body,
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
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

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn linear(&self, time: f64) -> Option<LinearTorque> {
        let [torque, ..] = self.linear_at([time; 3])?;
        Some(torque)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn linear_at(&self, times: [f64; 3]) -> Option<[LinearTorque; 3]> {
        if !C::CONSTANT {
            return None;
        }
        let always = match self {
            Self::None => LinearTorque::default(),
            Self::Constant { frame, value } => {
                in_frame(*frame, values::<T, C>(value), Vector3::zeros())
            }
            Self::Gravity { weight, arm } => LinearTorque {
                load: Some(SpaceLoad {
                    value: Vector3::new(0.0, 0.0, -weight.value()),
                    by_time: Vector3::zeros(),
                    arm: Some(values::<T, C>(arm)),
                }),
                ..LinearTorque::default()
            },
            Self::Damping { coefficient } => LinearTorque {
                by_angular_velocity: Some(Matrix3::from_diagonal_element(-coefficient.value())),
                ..LinearTorque::default()
            },
            Self::Sinusoid {
                frame,
                amplitude,
                angular_frequency,
                phase,
            } => {
                let (amplitude, pace) = (values::<T, C>(amplitude), angular_frequency.value());
                let mut angles = times;
                for angle in &mut angles {
                    *angle = pace * *angle + phase.value();
                }
                let ([a, b, c], [p, q, r]) = (sines(angles), cosines(angles));
                return Some([
                    in_frame(*frame, amplitude * a, amplitude * (p * pace)),
                    in_frame(*frame, amplitude * b, amplitude * (q * pace)),
                    in_frame(*frame, amplitude * c, amplitude * (r * pace)),
                ]);
            }
        };
        Some([always; 3])
    }
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn values<T: Number, C: Coefficient<T>>(v: &Vector3<C>) -> Vector3<f64> {
    Vector3::new(v.x.value(), v.y.value(), v.z.value())
}

/// A torque that depends on the time alone, in the axes of a frame.
#[cfg_attr(not(debug_assertions), inline(always))]
fn in_frame(frame: Frame, value: Vector3<f64>, by_time: Vector3<f64>) -> LinearTorque {
    match frame {
        Frame::Body => LinearTorque {
            at_rest: value,
            by_time,
            ..LinearTorque::default()
        },
        Frame::Space => LinearTorque {
            load: Some(SpaceLoad {
                value,
                by_time,
                arm: None,
            }),
            ..LinearTorque::default()
        },
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
