//! What a motion has beside the turning: the mass centre's velocity, a point that moves, the attitude, a second point of
//! the body for the inertia.

use super::expr::{Point, Vector};
use super::random::Random;
use super::world::{Nine, Number, Triple, add, cross, n, scaled};
use num_traits::{One, Zero};

/// The mass, the mass centre and the points, on the axes used.
pub(crate) struct Points {
    pub(crate) mass: Number,
    velocity: [Triple; 2],
    linear_momentum: [Triple; 2],
    force: Triple,
    arm: [Triple; 2],
    point_velocity: Triple,
    momentum: [Triple; 2],
    moment: Triple,
    pub(crate) attitude: [Nine; 2],
    pub(crate) place: Triple,
}

fn minus(a: &Triple, b: &Triple) -> Triple {
    add(a, &scaled(b, &n(-1)))
}

impl Points {
    /// Drawn for axes that turn with `frame`, of a body with these momenta and this moment about its mass centre.
    pub(crate) fn draw(
        frame: &Triple,
        omega: &Triple,
        momentum: &[Triple; 2],
        moment: &Triple,
        random: &mut Random,
    ) -> Self {
        let mut number = || n(random.below(18_001) as i64 - 9_000);
        let mut triple = || -> Triple { std::array::from_fn(|_| number()) };
        let velocity = [triple(), triple()];
        let (arm, point_velocity, place) = (triple(), triple(), triple());
        let quaternion = [triple(), triple()];
        let mass = n(1 + random.below(9_000) as i64);
        let linear_momentum = velocity.clone().map(|v| scaled(&v, &mass));
        let force = add(&linear_momentum[1], &cross(frame, &linear_momentum[0]));
        let arm_rate = minus(&minus(&velocity[0], &point_velocity), &cross(frame, &arm));
        let carried = add(
            &cross(&arm_rate, &linear_momentum[0]),
            &cross(&arm, &linear_momentum[1]),
        );
        let about = [
            add(&momentum[0], &cross(&arm, &linear_momentum[0])),
            add(&momentum[1], &carried),
        ];
        Self {
            moment: add(moment, &cross(&arm, &force)),
            attitude: attitude(&quaternion, omega),
            arm: [arm, arm_rate],
            momentum: about,
            mass,
            velocity,
            linear_momentum,
            force,
            point_velocity,
            place,
        }
    }

    pub(crate) fn triple(&self, vector: Vector, dots: usize) -> Option<&Triple> {
        match vector {
            Vector::Velocity | Vector::CentreVelocity => self.velocity.get(dots),
            Vector::LinearMomentum => self.linear_momentum.get(dots),
            Vector::Arm => self.arm.get(dots),
            Vector::PointMomentum => self.momentum.get(dots),
            Vector::Force => (dots == 0).then_some(&self.force),
            Vector::PointVelocity => (dots == 0).then_some(&self.point_velocity),
            Vector::PointMoment => (dots == 0).then_some(&self.moment),
            _ => None,
        }
    }

    /// What an inertia tensor's part has more about a point than about the mass centre: `I_xx` and `I_xy = ∫xy dm`.
    pub(crate) fn shift(&self, point: Point, i: usize, j: usize) -> Number {
        let square = |k: usize| &self.place[k] * &self.place[k];
        match point {
            Point::Centre => Number::zero(),
            Point::Origin if i == j => &self.mass * (square((i + 1) % 3) + square((i + 2) % 3)),
            Point::Origin => &self.mass * &self.place[i] * &self.place[j],
        }
    }
}

/// The matrix of a turning by a quaternion of any length, and its rate for a body that turns with ω on its own axes.
fn attitude(quaternion: &[Triple; 2], omega: &Triple) -> [Nine; 2] {
    let ([x, y, z], w) = (&quaternion[0], &quaternion[1][0]);
    let length: Number = w * w + x * x + y * y + z * z;
    let v = [x, y, z];
    let matrix: Nine = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let (a, b) = ((i + 1) % 3, (i + 2) % 3);
            let two = n(2);
            match (i == j, (i + 1) % 3 == j) {
                (true, _) => n(1) - &two * (v[a] * v[a] + v[b] * v[b]) / &length,
                (_, true) => &two * (v[i] * v[j] - w * v[b]) / &length,
                _ => &two * (v[i] * v[j] + w * v[a]) / &length,
            }
        })
    });
    let rate = product(&matrix, &skew(omega));
    [matrix, rate]
}

/// The matrix of v ×.
pub(crate) fn skew(v: &Triple) -> Nine {
    let columns: [Triple; 3] = std::array::from_fn(|k| cross(v, &identity()[k]));
    transposed(&columns)
}

pub(crate) fn identity() -> Nine {
    std::array::from_fn(|i| {
        std::array::from_fn(|k| {
            if i == k {
                Number::one()
            } else {
                Number::zero()
            }
        })
    })
}

pub(crate) fn transposed(m: &Nine) -> Nine {
    std::array::from_fn(|i| std::array::from_fn(|k| m[k][i].clone()))
}

pub(crate) fn product(a: &Nine, b: &Nine) -> Nine {
    std::array::from_fn(|i| std::array::from_fn(|k| (0..3).map(|j| &a[i][j] * &b[j][k]).sum()))
}
