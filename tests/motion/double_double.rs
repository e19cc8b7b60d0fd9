//! Free motion to some thirty digits: Taylor series in double-double arithmetic, which shares nothing with the library.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// The unevaluated sum of two doubles (Dekker 1971).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Double(f64, f64);

fn two_sum(a: f64, b: f64) -> Double {
    let s = a + b;
    let t = s - a;
    Double(s, (a - (s - t)) + (b - t))
}

impl Double {
    pub(crate) const ZERO: Self = Self(0.0, 0.0);

    pub(crate) fn of(x: f64) -> Self {
        Self(x, 0.0)
    }

    pub(crate) fn value(self) -> f64 {
        self.0 + self.1
    }
}

impl Add for Double {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        let s = two_sum(self.0, o.0);
        let t = two_sum(self.1, o.1);
        let u = two_sum(s.0, s.1 + t.0);
        two_sum(u.0, u.1 + t.1)
    }
}

impl Neg for Double {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl Sub for Double {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + -o
    }
}

impl Mul for Double {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        let p = self.0 * o.0;
        let e = self.0.mul_add(o.0, -p) + (self.0 * o.1 + self.1 * o.0);
        two_sum(p, e)
    }
}

impl Div for Double {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let q = Self::of(self.0 / o.0);
        let r = self - q * o;
        let q2 = Self::of(r.0 / o.0);
        let r2 = r - q2 * o;
        q + q2 + Self::of(r2.0 / o.0)
    }
}

/// ω₁ ω₂ ω₃, q (w, x, y, z), and the direction down in body axes.
pub(crate) type Motion = [Double; 10];

const ORDER: usize = 30;

/// The free motion along principal axes with `moments`, from `start`, for `time`, in `steps` equal steps.
#[allow(dead_code, reason = "each test takes one of the two motions")]
pub(crate) fn free_motion(moments: [f64; 3], start: [f64; 7], time: f64, steps: u32) -> Motion {
    heavy_top(moments, start, [0.0; 3], time, steps)
}

/// The same under a weight of one newton at `arm`.
pub(crate) fn heavy_top(
    moments: [f64; 3],
    start: [f64; 7],
    arm: [f64; 3],
    time: f64,
    steps: u32,
) -> Motion {
    let [a, b, c] = moments.map(Double::of);
    let body = Body {
        ratios: [(b - c) / a, (c - a) / b, (a - b) / c],
        moments: [a, b, c],
        arm: arm.map(Double::of),
    };
    let h = Double::of(time) / Double::of(f64::from(steps));
    let [_, _, _, w, x, y, z] = start.map(Double::of);
    let two = Double::of(2.0);
    let mut state = [Double::ZERO; 10];
    for (to, from) in state.iter_mut().zip(start) {
        *to = Double::of(from);
    }
    // Rᵀ (0, 0, −1).
    state[7] = -(two * (x * z - w * y));
    state[8] = -(two * (y * z + w * x));
    state[9] = -(w * w - x * x - y * y + z * z);
    (0..steps).fold(state, |state, _| body.step(&state, h))
}

struct Body {
    ratios: [Double; 3],
    moments: [Double; 3],
    arm: [Double; 3],
}

impl Body {
    fn step(&self, state: &Motion, h: Double) -> Motion {
        let mut s = [[Double::ZERO; ORDER + 1]; 10];
        for (series, value) in s.iter_mut().zip(state) {
            series[0] = *value;
        }
        for n in 0..ORDER {
            let next = self.coefficients(&s, n);
            for (series, value) in s.iter_mut().zip(next) {
                series[n + 1] = value;
            }
        }
        s.map(|series| {
            series
                .iter()
                .rev()
                .fold(Double::ZERO, |sum, c| sum * h + *c)
        })
    }

    fn coefficients(&self, s: &[[Double; ORDER + 1]; 10], n: usize) -> Motion {
        let over = Double::of(1.0) / Double::of((n + 1) as f64);
        let product =
            |i: usize, j: usize| (0..=n).fold(Double::ZERO, |sum, m| sum + s[i][m] * s[j][n - m]);
        let mut next = [Double::ZERO; 10];
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let weight = self.arm[j] * s[7 + k][n] - self.arm[k] * s[7 + j][n];
            next[i] = (self.ratios[i] * product(j, k) + weight / self.moments[i]) * over;
            next[7 + i] = (product(7 + j, k) - product(7 + k, j)) * over;
        }
        let half = over * Double::of(0.5);
        // q̇ = ½ q (0, ω).
        next[3] = -(product(4, 0) + product(5, 1) + product(6, 2)) * half;
        next[4] = (product(3, 0) + product(5, 2) - product(6, 1)) * half;
        next[5] = (product(3, 1) + product(6, 0) - product(4, 2)) * half;
        next[6] = (product(3, 2) + product(4, 1) - product(5, 0)) * half;
        next
    }
}
