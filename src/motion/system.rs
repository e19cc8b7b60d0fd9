//! A body and the torque on it.

use crate::mechanics::{angular_momentum, apply, cross, possible_body};
use crate::motion::{
    Body, Frame, MotionError, Number, Rates, State, Torque, TorqueLaw,
    torque::{in_body, lift},
};
use nalgebra::{Matrix3, Vector3};
use std::ops::{Add, Div, Mul, Sub};

/// A rigid body about its mass centre or a fixed point, and the law of the torque on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct System<T, L> {
    inertia: Matrix3<T>,
    inverse: Matrix3<T>,
    law: L,
    added: Vector3<T>,
    /// Whether the products of inertia are known to be zero.
    principal: bool,
}

impl<L: TorqueLaw<f64>> System<f64, L> {
    /// The system of an inertia tensor (kg m², body axes, the tensor's own entries) and a law of torque.
    ///
    /// That the tensor is one of a body is tested here, which costs as much as several steps. An optimiser makes the system
    /// once and gives it a torque for each step by [`with_torque`](Self::with_torque); its trial tensors, which may be of no
    /// body, it gives to [`over`](Self::over).
    ///
    /// # Errors
    /// A tensor that no body has.
    pub fn new(inertia: Matrix3<f64>, law: L) -> Result<Self, MotionError> {
        possible_body(&inertia).map_err(MotionError::Inertia)?;
        Ok(Self::over(inertia, law, Vector3::zeros()))
    }
}

impl<L: TorqueLaw<f64>> System<f64, L> {
    /// The whole torque over another number.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn torque_over<T: Number>(&self, time: T, state: &State<T>) -> Vector3<T>
    where
        L: TorqueLaw<T>,
    {
        let frame = TorqueLaw::<f64>::added_in(&self.law);
        let torque = self.law.torque(time, state);
        // None at all is the most frequent one.
        if self.added == Vector3::zeros() {
            return torque;
        }
        torque + in_body(frame, &state.attitude, lift(&self.added))
    }
}

impl System<f64, Torque> {
    /// The system of a body along its principal axes, the law turned with it.
    pub fn principal(body: &Body, law: Torque) -> Self {
        let inertia = Matrix3::from_diagonal(body.moments());
        Self {
            principal: true,
            ..Self::over(inertia, law.along(body.axes()), Vector3::zeros())
        }
    }
}

impl<T: Number, L: TorqueLaw<T>> System<T, L> {
    /// The system over any number, with a constant torque `added` to the law in the axes that the law names; the tensor is not
    /// tested. One without an inverse gives numbers that are not finite.
    ///
    /// ```
    /// use nalgebra::{Matrix3, Vector3};
    /// use polhode::motion::{Rk4, Scheme, State, System, Torque};
    /// // No body has a moment larger than the sum of the others, but an optimiser may come by.
    /// let trial = Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.5));
    /// assert!(System::new(trial, Torque::None).is_err());
    /// let system = System::over(trial, Torque::None, Vector3::zeros());
    /// let start = State::at_rest().turning(Vector3::new(3.0, 0.5, -0.9));
    /// assert!(Rk4.step(&system, 0.0, &start, 0.01).is_finite());
    /// ```
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn over(inertia: Matrix3<T>, law: L, added: Vector3<T>) -> Self {
        let none = |r, c| inertia[(r, c)] == T::zero();
        Self {
            inverse: inverse(&inertia),
            // A product that is zero may yet have a derivative.
            principal: T::DERIVATIVES == 0 && none(0, 1) && none(0, 2) && none(1, 2),
            inertia,
            law,
            added,
        }
    }

    /// The same system with another constant torque added to its law, in the axes that the law names. Costs nothing: what is
    /// known of the tensor is kept.
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    pub fn with_torque(self, added: Vector3<T>) -> Self {
        Self { added, ..self }
    }

    /// The same system, its axes known to be principal or not.
    #[cfg(feature = "batch")]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn along_axes(self, principal: bool) -> Self {
        Self { principal, ..self }
    }

    /// The same system, its axes known to be principal: an inverse of three quotients.
    #[cfg(feature = "emit")]
    pub(crate) fn along_principal_axes(self) -> Self {
        let moments = self.inertia.diagonal();
        Self {
            inverse: Matrix3::from_diagonal(&moments.map(|moment| T::one() / moment)),
            principal: true,
            ..self
        }
    }

    /// The inertia tensor.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn inertia(&self) -> &Matrix3<T> {
        &self.inertia
    }

    /// Its inverse.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn inverse(&self) -> &Matrix3<T> {
        &self.inverse
    }

    /// Whether the axes are known to be principal.
    pub(crate) fn is_principal(&self) -> bool {
        self.principal
    }

    /// The torque added to the law.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn added(&self) -> &Vector3<T> {
        &self.added
    }

    /// The law of torque.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn law(&self) -> &L {
        &self.law
    }

    /// The whole torque at a time in a state, body axes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn torque(&self, time: T, state: &State<T>) -> Vector3<T> {
        let added = match self.law.added_in() {
            Frame::Body => self.added,
            Frame::Space => in_body(Frame::Space, &state.attitude, self.added),
        };
        self.law.torque(time, state) + added
    }

    /// ω̇ = I⁻¹ (M − ω × I ω) from the products (yz, zx, xy) and the squares (x², y², z²) of ω, or from the
    /// same coefficient of their series. The moment differences are formed first: (Iω) × ω would lose what a
    /// needle's moments have in common.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn acceleration_of(
        &self,
        products: &Vector3<T>,
        squares: impl FnOnce() -> Vector3<T>,
        torque: &Vector3<T>,
    ) -> Vector3<T> {
        let (i, [yz, zx, xy]) = (&self.inertia, [products.x, products.y, products.z]);
        let (xx, yy, zz) = (i[(0, 0)], i[(1, 1)], i[(2, 2)]);
        let mut net = torque + Vector3::new((yy - zz) * yz, (zz - xx) * zx, (xx - yy) * xy);
        if self.principal {
            return Vector3::new(
                net.x * self.inverse[(0, 0)],
                net.y * self.inverse[(1, 1)],
                net.z * self.inverse[(2, 2)],
            );
        }
        let square = squares();
        let (pxy, pxz, pyz) = (i[(0, 1)], i[(0, 2)], i[(1, 2)]);
        net.x += pyz * (square.z - square.y) + pxy * zx - pxz * xy;
        net.y += pxz * (square.x - square.z) + pyz * xy - pxy * yz;
        net.z += pxy * (square.y - square.x) + pxz * yz - pyz * zx;
        apply(&self.inverse, &net)
    }

    /// q̇ = ½ q ω, and ω̇ = I⁻¹ (M − ω × I ω) as in
    /// [`angular_acceleration`](crate::mechanics::angular_acceleration), with the inverse formed once.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn rates(&self, time: T, state: &State<T>) -> Rates<T> {
        self.rates_under(self.torque(time, state), state)
    }

    /// The same at a time of which the clock of the law has given the `reading`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn rates_by(&self, reading: T, state: &State<T>) -> Rates<T> {
        self.rates_under(self.law.torque_by(reading, state, &self.added), state)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rates_under(&self, torque: Vector3<T>, state: &State<T>) -> Rates<T> {
        let omega = &state.angular_velocity;
        let angular_acceleration = if self.principal {
            let products = Vector3::new(omega.y * omega.z, omega.z * omega.x, omega.x * omega.y);
            self.acceleration_of(&products, || omega.component_mul(omega), &torque)
        } else {
            let momentum = angular_momentum(&self.inertia, omega);
            apply(&self.inverse, &(torque - cross(omega, &momentum)))
        };
        Rates {
            attitude: state.attitude.rate(omega),
            angular_acceleration,
        }
    }
}

/// The inverse of a symmetric matrix.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn inverse<T: Number>(m: &Matrix3<T>) -> Matrix3<T> {
    let [xx, yy, zz, xy, xz, yz] = inverse_entries(entries(m), T::one());
    Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
}

/// The entries xx, yy, zz, xy, xz, yz of a symmetric matrix.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn entries<T: Copy>(m: &Matrix3<T>) -> [T; 6] {
    [
        m[(0, 0)],
        m[(1, 1)],
        m[(2, 2)],
        m[(0, 1)],
        m[(0, 2)],
        m[(1, 2)],
    ]
}

/// The inverse of a symmetric matrix by its adjugate, without a branch, in the same order of entries. The scale is taken
/// out first by the trace, so that moments of 1e±150 keep their determinant.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn inverse_entries<T>([xx, yy, zz, xy, xz, yz]: [T; 6], one: T) -> [T; 6]
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Div<Output = T>,
{
    let scale = one / (xx + yy + zz);
    let (xx, yy, zz) = (xx * scale, yy * scale, zz * scale);
    let (xy, xz, yz) = (xy * scale, xz * scale, yz * scale);
    let minors = [
        yy * zz - yz * yz,
        xx * zz - xz * xz,
        xx * yy - xy * xy,
        xz * yz - xy * zz,
        xy * yz - xz * yy,
        xy * xz - xx * yz,
    ];
    let determinant = xx * minors[0] + xy * minors[3] + xz * minors[4];
    let back = scale / determinant;
    let [a, b, c, d, e, f] = minors;
    [a * back, b * back, c * back, d * back, e * back, f * back]
}
