//! Laws of torque.

mod law;

pub use law::{Coefficient, Law, Torque};

use crate::motion::{Number, Quaternion, State};
use crate::scalar::Jet;
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
/// A closure `|time: f64, state: &State<f64>| …` is a law over doubles. A law that is to give Jacobians is generic: it
/// implements this trait for every [`Number`], and for speed its function is `#[cfg_attr(not(debug_assertions), inline(always))]`, so that it is compiled for the
/// machine at hand with the step around it. What is constant in it costs less by [`Number::scaled`] and
/// [`Quaternion::constant_to_body`] than as a number without derivatives.
///
/// ```
/// use nalgebra::Vector3;
/// use polhode::motion::{Number, State, TorqueLaw};
///
/// /// A drag that grows with the square of the spin about z.
/// #[derive(Clone, Copy)]
/// struct Drag(f64);
/// impl<T: Number> TorqueLaw<T> for Drag {
///     #[cfg_attr(not(debug_assertions), inline(always))]
///     fn torque(&self, _time: T, state: &State<T>) -> Vector3<T> {
///         let spin = state.angular_velocity.z;
///         Vector3::new(T::zero(), T::zero(), -(spin * spin).scaled(self.0))
///     }
/// }
/// let spinning = State::at_rest().turning(Vector3::new(0.0, 0.0, 2.0));
/// assert_eq!(Drag(0.5).torque(0.0, &spinning).z, -2.0);
/// ```
///
/// A closure has no derivatives, and the compiler says so:
///
/// ```compile_fail,E0277
/// use nalgebra::Matrix3;
/// use polhode::motion::{Rk4, Scheme, State, System};
/// let drag = |_: f64, state: &State<f64>| -state.angular_velocity;
/// let system = System::new(Matrix3::identity(), drag).expect("a body");
/// let step = Rk4.step_with_jacobian::<6>(&system, 0.0, &State::at_rest(), 0.1);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no law of torque over `{T}`",
    label = "gives no torque over `{T}`",
    note = "a closure `|time: f64, state: &State<f64>| -> Vector3<f64>` is a law without derivatives; name the types of its arguments",
    note = "for derivatives write `#[derive(Clone, Copy)] struct Law;` and `impl<T: Number> TorqueLaw<T> for Law`"
)]
pub trait TorqueLaw<T: Number> {
    /// Whether [`linear`](Self::linear) is to be asked: known beforehand, so that no code is made for what does not occur.
    const LINEAR: bool = false;

    /// The torque on the body at `time` (s) in `state`, in body axes. The attitude may be off unit length
    /// by the error of a stage of a step.
    fn torque(&self, time: T, state: &State<T>) -> Vector3<T>;

    /// What the law needs of the times at the start, in the middle and at the end of a step, to be worked out once for all stages:
    /// the sines of a wave. The times themselves unless it is written out, and then [`torque_by`](Self::torque_by) is as well.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn clock(&self, times: [T; 3]) -> [T; 3] {
        times
    }

    /// The torque on the body in `state` and one `added` to it in the axes of [`added_in`](Self::added_in), at a time of which
    /// [`clock`](Self::clock) has given the `reading`. Must agree with [`torque`](Self::torque).
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn torque_by(&self, reading: T, state: &State<T>, added: &Vector3<T>) -> Vector3<T> {
        self.torque(reading, state) + in_body(self.added_in(), &state.attitude, *added)
    }

    /// The axes in which a torque is added to this law when derivatives in the torque are taken.
    fn added_in(&self) -> Frame {
        Frame::Body
    }

    /// Calls `work` with the law, at a place of its own for each of the kinds that it may be of: a loop over many bodies
    /// in there need not ask each time.
    #[cfg_attr(not(debug_assertions), inline(always))]
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

    /// The torque at `time` in parts, if it is linear in ω and in one vector that stands in space, whatever the state: then no
    /// dual number is needed for its derivatives. Must agree with [`torque`](Self::torque).
    fn linear(&self, _time: f64) -> Option<LinearTorque> {
        None
    }

    /// The same at the start, in the middle and at the end of a step. Written out where that is had at less cost together.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn linear_at(&self, [a, b, c]: [f64; 3]) -> Option<[LinearTorque; 3]> {
        Some([self.linear(a)?, self.linear(b)?, self.linear(c)?])
    }
}

/// A law over all the numbers that derivatives are taken with, as every `Copy` law that is generic over its number is.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no law of torque with derivatives",
    note = "write `#[derive(Clone, Copy)] struct Law;` and `impl<T: Number> TorqueLaw<T> for Law`"
)]
pub trait SmoothLaw:
    Copy + TorqueLaw<f64> + TorqueLaw<Jet<f64, 1>> + TorqueLaw<Jet<f64, SIDE>>
{
}

impl<L> SmoothLaw for L where
    L: Copy + TorqueLaw<f64> + TorqueLaw<Jet<f64, 1>> + TorqueLaw<Jet<f64, SIDE>>
{
}

/// How many derivatives are taken side by side, 8: as many as the widest registers hold, and as state and time have numbers.
pub(crate) const SIDE: usize = 8;

/// A law as it is from a time on: a motion that starts at a time t₀ is that of its law from t₀ on, which starts at 0.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use polhode::motion::{Frame, Later, Rk4, State, System, Torque, jacobian::flow};
///
/// let wave = Torque::Sinusoid {
///     frame: Frame::Space,
///     amplitude: Vector3::new(0.1, -0.2, 0.3),
///     angular_frequency: 2.0,
///     phase: 0.3,
/// };
/// let inertia = Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0));
/// let (whole, later) = (System::new(inertia, wave)?, System::new(inertia, Later { law: wave, from: 0.5 })?);
/// let start = State::at_rest().turning(Vector3::new(3.0, 0.5, -0.9));
/// let first = flow::by_steps::<15, _, _>(&Rk4, &whole, &start, 0.01, 0.5)?;
/// let second = flow::by_steps::<15, _, _>(&Rk4, &later, &first.state, 0.01, 0.5)?;
/// let both = flow::by_steps::<15, _, _>(&Rk4, &whole, &start, 0.01, 1.0)?;
/// assert!((first.then(&second).matrix - both.matrix).amax() < 1e-12);
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Later<L> {
    /// The law.
    pub law: L,
    /// What is its time where this one's is 0, s.
    pub from: f64,
}

impl<T: Number, L: TorqueLaw<T>> TorqueLaw<T> for Later<L> {
    const LINEAR: bool = L::LINEAR;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn torque(&self, time: T, state: &State<T>) -> Vector3<T> {
        self.law.torque(time + T::of(self.from), state)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn clock(&self, [a, b, c]: [T; 3]) -> [T; 3] {
        let from = T::of(self.from);
        self.law.clock([a + from, b + from, c + from])
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn torque_by(&self, reading: T, state: &State<T>, added: &Vector3<T>) -> Vector3<T> {
        self.law.torque_by(reading, state, added)
    }

    fn added_in(&self) -> Frame {
        self.law.added_in()
    }

    fn needs_angular_velocity(&self) -> bool {
        self.law.needs_angular_velocity()
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn linear(&self, time: f64) -> Option<LinearTorque> {
        self.law.linear(time + self.from)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn linear_at(&self, [a, b, c]: [f64; 3]) -> Option<[LinearTorque; 3]> {
        let from = self.from;
        self.law.linear_at([a + from, b + from, c + from])
    }
}

/// A torque that is linear in ω and in one vector that stands in space.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LinearTorque {
    /// What depends on the time alone, body axes, N m.
    pub at_rest: Vector3<f64>,
    /// Its derivative in time.
    pub by_time: Vector3<f64>,
    /// What ω is multiplied by to be added, `None` for zeros. Row: component of the torque; column: component of ω.
    pub by_angular_velocity: Option<Matrix3<f64>>,
    /// What stands in space.
    pub load: Option<SpaceLoad>,
}

/// A torque that stands in space, or a force there that acts at an arm of the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpaceLoad {
    /// The torque, N m, or the force, N; space axes.
    pub value: Vector3<f64>,
    /// Its derivative in time.
    pub by_time: Vector3<f64>,
    /// The arm of a force, body axes, m.
    pub arm: Option<Vector3<f64>>,
}

impl LinearTorque {
    /// Whether the torque is the same in every attitude.
    pub fn looks_away(&self) -> bool {
        self.load.is_none()
    }
}

impl<F: Fn(f64, &State<f64>) -> Vector3<f64>> TorqueLaw<f64> for F {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn torque(&self, time: f64, state: &State<f64>) -> Vector3<f64> {
        self(time, state)
    }
}

/// A vector of doubles as constants of another number.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn lift<T: Number>(v: &Vector3<f64>) -> Vector3<T> {
    v.map(T::of)
}

/// The components in the body of a vector that is given in `frame`.
#[cfg_attr(not(debug_assertions), inline(always))]
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
