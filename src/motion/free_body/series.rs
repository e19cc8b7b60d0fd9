//! Jacobi's functions and the phase of the attitude as theta series, from either end of the modulus.

use super::elliptic::{complete, incomplete};
use std::f64::consts::PI;

/// Terms of each series. The nome is at most exp(−π/√2) = 0.11, and its 25th power is below rounding.
const TERMS: usize = 5;

/// The values at one argument u.
#[derive(Clone, Copy, Debug)]
pub(super) struct Values {
    pub(super) sn: f64,
    pub(super) cn: f64,
    pub(super) dn: f64,
    /// A number (real and imaginary part) whose argument is the phase that belongs to u: twice it is what 1/(G + A dn)
    /// integrates to, less a part linear in u.
    pub(super) phase: (f64, f64),
}

/// Jacobi's functions of one modulus, and the phase of one pole.
///
/// The phase is arg θ₄(πu/2K + iπw/2K; q²): its derivative has the poles of 1/(1 + dn(u)/dn(iw)), with residues
/// ±i/2. So the angle about the angular momentum is a uniform turn and twice this argument, and nothing
/// cancels. (Van Zon and Schofield, J. Comput. Phys. 225 (2007), have θ₄ of nome q and an arctangent besides.)
#[derive(Clone, Copy, Debug)]
pub(super) enum Series {
    /// By the nome q = exp(−πK'/K): trigonometric.
    Nome(Nome),
    /// By the nome of the complementary modulus, exp(−πK/K'): hyperbolic, and sech and tanh on the separatrix.
    Complementary(Complementary),
}

impl Series {
    /// The series of the moduli k and k' (k² + k'² = 1, each given, as neither can be had from the other
    /// where it is small), and of the pole's place w with sc(w, k') = `pole`.
    ///
    /// Returns the quarter period K with it, infinite on the separatrix.
    pub(super) fn new(modulus: f64, complementary: f64, pole: f64) -> (Self, f64) {
        let (quarter, other) = (complete(complementary), complete(modulus));
        // Both nomes are smallest at once where K' / K = 1/√2, for the series in q² and q^½ besides.
        if other * std::f64::consts::SQRT_2 > quarter {
            let w = incomplete(pole, modulus, other);
            (Self::Nome(Nome::new(quarter, other, w)), quarter)
        } else {
            let w = incomplete(pole, modulus, other);
            let series = Complementary::new(quarter, other, w);
            (Self::Complementary(series), quarter)
        }
    }

    /// The rate of the phase in u at u = 0, and what the phase gains in every half period 2K.
    pub(super) fn rate_and_gain(&self) -> (f64, f64) {
        match self {
            Self::Nome(series) => (series.rate_at_zero, 0.0),
            Self::Complementary(series) => (series.rate_at_zero, series.gain),
        }
    }

    /// The functions at u in −K ..= K.
    pub(super) fn at(&self, u: f64) -> Values {
        match self {
            Self::Nome(series) => series.at(u),
            Self::Complementary(series) => series.at(u),
        }
    }
}

/// Coefficients of the series in cos and sin of multiples of z = πu/2K.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nome {
    scale: f64,
    /// (−1)ⁿ 2 q^(n²) for θ₄, n = 1 …; of θ₃ the absolute values.
    even: [f64; TERMS],
    /// q^(n(n+1)) for θ₂, n = 0 …; of θ₁ with alternating signs.
    odd: [f64; TERMS],
    /// The same as `even` for nome q², times cosh and sinh of nπw/K.
    phase: [(f64, f64); TERMS],
    factors: [f64; 3],
    rate_at_zero: f64,
}

impl Nome {
    fn new(quarter: f64, other: f64, w: f64) -> Self {
        let log = -PI * other / quarter;
        let power = |exponent: usize| {
            if exponent == 0 {
                1.0
            } else {
                (log * exponent as f64).exp()
            }
        };
        let sign = |n: usize| if n.is_multiple_of(2) { 1.0 } else { -1.0 };
        let even = std::array::from_fn(|i| 2.0 * sign(i + 1) * power((i + 1) * (i + 1)));
        let odd: [f64; TERMS] = std::array::from_fn(|n| power(n * (n + 1)));
        let phase = std::array::from_fn(|i| {
            let n = (i + 1) as f64;
            if other.is_infinite() {
                return (0.0, 0.0);
            }
            let (base, turn) = (2.0 * n * n * log, n * PI * w / quarter);
            let (up, down) = ((base + turn).exp(), (base - turn).exp());
            (sign(i + 1) * (up + down), sign(i + 1) * (up - down))
        });
        let theta4 = 1.0 + even.iter().sum::<f64>();
        let theta3 = 1.0 + even.iter().map(|c| c.abs()).sum::<f64>();
        let theta2 = odd.iter().sum::<f64>();
        let slope: f64 = (1..)
            .zip(&phase)
            .map(|(n, c)| -2.0 * f64::from(n) * c.1)
            .sum();
        let real = 1.0 + phase.iter().map(|c| c.0).sum::<f64>();
        let scale = PI / (2.0 * quarter);
        Self {
            scale,
            even,
            odd,
            phase,
            factors: [theta3 / theta2, theta4 / theta2, theta4 / theta3],
            rate_at_zero: scale * slope / real,
        }
    }

    fn at(&self, u: f64) -> Values {
        let (s1, c1) = (self.scale * u).sin_cos();
        let (s2, c2) = (2.0 * s1 * c1, (c1 - s1) * (c1 + s1));
        let (mut theta3, mut theta4, mut real, mut imaginary) = (1.0, 1.0, 1.0, 0.0);
        let (mut theta1, mut theta2, mut sign) = (0.0, 0.0, 1.0);
        let ((mut so, mut co), (mut se, mut ce)) = ((s1, c1), (s2, c2));
        for n in 0..TERMS {
            theta1 += sign * self.odd[n] * so;
            theta2 += self.odd[n] * co;
            theta4 += self.even[n] * ce;
            theta3 -= sign * self.even[n] * ce;
            real += self.phase[n].0 * ce;
            imaginary -= self.phase[n].1 * se;
            sign = -sign;
            (so, co) = (so * c2 + co * s2, co * c2 - so * s2);
            (se, ce) = (se * c2 + ce * s2, ce * c2 - se * s2);
        }
        Values {
            sn: self.factors[0] * theta1 / theta4,
            cn: self.factors[1] * theta2 / theta4,
            dn: self.factors[2] * theta3 / theta4,
            phase: (real, imaginary),
        }
    }
}

/// Coefficients of the series in exponentials of ζ = πu/2K', by Jacobi's imaginary transformation.
#[derive(Clone, Copy, Debug)]
pub(super) struct Complementary {
    scale: f64,
    /// πK/2K', the ζ of a quarter period.
    quarter: f64,
    /// q'^(n²) for n = 0 …
    squares: [f64; TERMS + 1],
    /// q'^(n²/2) cos and sin of (2n + 1) πw/4K'.
    phase: [(f64, f64); TERMS],
    factors: [f64; 3],
    rate_at_zero: f64,
    gain: f64,
}

impl Complementary {
    fn new(quarter: f64, other: f64, w: f64) -> Self {
        let scale = PI / (2.0 * other);
        let end = scale * quarter;
        let power = |exponent: f64| {
            if exponent == 0.0 {
                1.0
            } else {
                (-2.0 * end * exponent).exp()
            }
        };
        let squares = std::array::from_fn(|n| power((n * n) as f64));
        let eta = 0.5 * scale * w;
        let angle = |n: usize| (((2 * n + 1) as f64) * eta).sin_cos();
        let phase = std::array::from_fn(|n| {
            let (sine, cosine) = angle(n);
            let weight = power(0.5 * (n * n) as f64);
            (weight * cosine, weight * sine)
        });
        let (mut slope, mut real) = (0.0, 0.0);
        for n in 0..TERMS {
            let (sine, cosine) = angle(n);
            let weight = power(0.5 * (n * (n + 1)) as f64);
            slope += weight * (2 * n + 1) as f64 * sine;
            real += weight * cosine;
        }
        let theta2: f64 = (0..TERMS).map(|n| power((n * (n + 1)) as f64)).sum();
        let theta3 = 2.0 * squares.iter().sum::<f64>() - 1.0;
        let theta4 = (1.0 - squares[1]) - squares[1] + 2.0 * (squares[2] - squares[3] + squares[4]);
        Self {
            scale,
            quarter: end,
            squares,
            phase,
            factors: [
                theta3 / theta4,
                2.0 * theta2 / theta4,
                2.0 * theta2 / theta3,
            ],
            rate_at_zero: 0.5 * scale * slope / real,
            gain: -0.5 * PI * w / other,
        }
    }

    fn at(&self, u: f64) -> Values {
        let zeta = (self.scale * u).abs();
        // How far behind the peak and how far before the next: e^(−2ζ) and q' e^(2ζ), both at most 1.
        let small = (-zeta).exp();
        let back = small * small;
        let ahead_root = (zeta - self.quarter).exp();
        let ahead = ahead_root * ahead_root;
        let (mut theta1, mut theta2) = (-(-2.0 * zeta).exp_m1(), 1.0 + back);
        let rest = -(2.0 * (zeta - self.quarter)).exp_m1();
        let mut theta4 = rest - self.squares[1] * back;
        let mut theta3 = 1.0 + ahead + self.squares[1] * back;
        let (mut real, mut imaginary) = (
            self.phase[0].0 * (1.0 + small),
            self.phase[0].1 * -(-zeta).exp_m1(),
        );
        let (mut aheads, mut ahead_roots) = (ahead, ahead_root);
        let (mut backs, mut odd, mut small_odd, mut sign) = (back, back, small, -1.0);
        // The terms between: e^(−2nζ) q'^(n²) and its growing partner, scaled by what the first one grows by.
        for n in 1..TERMS {
            let between = self.squares[n] * aheads;
            odd *= back * back;
            theta1 += sign * between * (1.0 - odd);
            theta2 += between * (1.0 + odd);
            small_odd *= back;
            real += self.phase[n].0 * ahead_roots * (1.0 + small_odd);
            imaginary += self.phase[n].1 * ahead_roots * (1.0 - small_odd);
            backs *= back;
            aheads *= ahead;
            ahead_roots *= ahead_root;
            // q'^(m² − m) e^… and q'^(m²) e^…, m = n + 1.
            let growing = self.growing(n + 1) * aheads;
            let falling = self.squares[n + 1] * backs;
            sign = -sign;
            theta4 += sign * (growing + falling);
            theta3 += growing + falling;
        }
        let side = 1.0_f64.copysign(u);
        Values {
            sn: side * self.factors[0] * theta1 / theta2,
            cn: small * self.factors[1] * theta4 / theta2,
            dn: small * self.factors[2] * theta3 / theta2,
            phase: (real, side * imaginary),
        }
    }

    /// q'^(n² − n).
    fn growing(&self, n: usize) -> f64 {
        // n² − n = (n − 1)² + (n − 1).
        self.squares[n - 1] * self.squares[1].powi(n as i32 - 1)
    }
}
