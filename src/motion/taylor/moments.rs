//! The series of a torque.

use super::series::{MOST, Term, Turned, turned};
use crate::motion::{Frame, Number, State, System, Torque};
use nalgebra::Vector3;

/// The series of the torque, grown with the motion, in the series' unit of time.
pub(super) struct Moments<T> {
    law: Torque,
    unit: T,
    /// A torque constant in body axes.
    body: Vector3<T>,
    /// Whether there are a torque or a force, and an amplitude, that are constant in space.
    pub(super) space: bool,
    pub(super) amplitude: bool,
}

impl<T: Number> Moments<T> {
    /// With what stands beside order 0.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn begin(
        first: &mut Term<T>,
        system: &System<T, Torque>,
        (time, state): (T, &State<T>),
        unit: T,
    ) -> Self {
        // By the unit twice, whose square may be no number.
        let lift = |v: &Vector3<f64>| v.map(|c| T::of(c) * unit * unit);
        let added = system.added() * unit * unit;
        let (mut body, mut space, mut moving) = (Vector3::from_element(T::zero()), None, None);
        match system.law() {
            Torque::None | Torque::Damping { .. } => body = added,
            Torque::Constant {
                frame: Frame::Body,
                value,
            } => body = added + lift(value),
            Torque::Constant {
                frame: Frame::Space,
                value,
            } => space = Some(added + lift(value)),
            Torque::Gravity { weight, .. } => {
                body = added;
                space = Some(lift(&Vector3::new(0.0, 0.0, -*weight)));
            }
            Torque::Sinusoid {
                frame,
                amplitude,
                angular_frequency,
                phase,
            } => {
                let angle = time * T::of(*angular_frequency) + T::of(*phase);
                (first.sine, first.cosine) = angle.sin_cos();
                match frame {
                    Frame::Body => body = added,
                    Frame::Space => (space, moving) = (Some(added), Some(lift(amplitude))),
                }
            }
        }
        let seen = |vector: &Vector3<T>| {
            let [x, y, z] = state.attitude.to_body(vector).into();
            turned([x, y, z, T::zero()])
        };
        if let Some(vector) = &space {
            first.space = seen(vector);
        }
        if let Some(vector) = &moving {
            first.amplitude = seen(vector);
        }
        Self {
            law: *system.law(),
            unit,
            body,
            space: space.is_some(),
            amplitude: moving.is_some(),
        }
    }

    /// The coefficient of the torque in body axes of the highest of these orders.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn coefficient(&self, terms: &[Term<T>]) -> Vector3<T> {
        let none = Vector3::from_element(T::zero());
        let Some(last) = terms.last() else {
            return none;
        };
        let mut sum = if terms.len() == 1 { self.body } else { none };
        let vector = |[[x, y, z, _], ..]: &Turned<T>| Vector3::new(*x, *y, *z);
        if self.space {
            let seen = vector(&last.space);
            sum += match &self.law {
                Torque::Gravity { arm, .. } => arm.map(T::of).cross(&seen),
                _ => seen,
            };
        }
        match &self.law {
            Torque::Damping { coefficient } => {
                sum -= vector(&last.omega) * (T::of(*coefficient) * self.unit);
            }
            Torque::Sinusoid { .. } if self.amplitude => {
                for (a, b) in terms.iter().zip(terms.iter().rev()) {
                    sum += vector(&a.amplitude) * b.sine;
                }
            }
            Torque::Sinusoid { amplitude, .. } => {
                let factor = self.unit * last.sine;
                sum += amplitude.map(|a| T::of(a) * self.unit * factor);
            }
            _ => {}
        }
        sum
    }

    /// Grows a sinusoid from order `n` to the next; `next` is 1/(n + 1).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn carry(&self, terms: &mut [Term<T>; MOST + 1], n: usize, next: T) {
        if let Torque::Sinusoid {
            angular_frequency, ..
        } = &self.law
        {
            let turn = next * self.unit * T::of(*angular_frequency);
            let (sine, cosine) = (terms[n].cosine * turn, -terms[n].sine * turn);
            (terms[n + 1].sine, terms[n + 1].cosine) = (sine, cosine);
        }
    }
}
