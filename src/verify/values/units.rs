//! Units of measurement as factors to SI: 1 rev/min is 2π/60 rad/s.

use crate::algebra::Rational;
use num_traits::One;

/// A factor: a rational number times a power of π.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Scale {
    /// The rational number.
    pub factor: Rational,
    /// The power of π.
    pub pi: i32,
}

impl Scale {
    fn one() -> Self {
        Self {
            factor: Rational::one(),
            pi: 0,
        }
    }

    /// Whether nothing changes.
    pub(crate) fn is_one(&self) -> bool {
        *self == Self::one()
    }

    /// Whether it is that of a degree.
    pub(crate) fn is_angle(&self) -> bool {
        self.pi == 1 && self.factor == Rational::from((1, 180))
    }

    fn times(mut self, factor: &Rational, pi: i32, exponent: i32) -> Self {
        for _ in 0..exponent.unsigned_abs() {
            self.factor = if exponent < 0 {
                self.factor / factor.clone()
            } else {
                self.factor * factor.clone()
            };
        }
        self.pi += pi * exponent;
        self
    }
}

/// The factor of one unit. Feet and pounds are a system of their own, so they count as one.
fn unit(name: &str) -> Option<(Rational, i32)> {
    let plain = |n: i64, d: i64| Some((Rational::from((n, d)), 0));
    match name {
        "kg" | "m" | "s" | "N" | "rad" | "J" | "W" | "Hz" | "Pa" | "Nm" | "lb" | "ft" | "slug" => {
            plain(1, 1)
        }
        "g" | "mm" | "ms" | "mN" | "mJ" => plain(1, 1000),
        "cm" => plain(1, 100),
        "km" | "kN" | "kJ" | "kW" | "kPa" | "kNm" => plain(1000, 1),
        "MN" | "MJ" | "MW" | "MPa" => plain(1_000_000, 1),
        "min" => plain(60, 1),
        "h" => plain(3600, 1),
        "d" | "day" | "days" => plain(86_400, 1),
        "in" => plain(1, 12),
        "rev" | "turn" => Some((Rational::from(2), 1)),
        "rpm" => Some((Rational::from((1, 30)), 1)),
        "deg" | "°" => Some((Rational::from((1, 180)), 1)),
        _ => None,
    }
}

/// The units of a text such as `kg m^2`, `rad/s`, `rev/min`, each with its power.
///
/// A slash, or `per`, puts the unit behind it below the line.
fn powers(text: &str) -> Vec<(&str, i32)> {
    let mut found = vec![];
    let mut rest = text;
    let mut below = false;
    while let Some(c) = rest.chars().next() {
        if !c.is_alphabetic() && c != '°' {
            below |= c == '/';
            rest = &rest[c.len_utf8()..];
            continue;
        }
        let end = rest
            .find(|c: char| !c.is_alphabetic() && c != '°')
            .unwrap_or(rest.len());
        let (name, after) = rest.split_at(end);
        let (exponent, after) = exponent(after);
        rest = after;
        if name == "per" {
            below = true;
            continue;
        }
        let sign = if std::mem::take(&mut below) { -1 } else { 1 };
        found.push((name, sign * exponent));
    }
    found
}

/// The factor of a unit such as `kg m^2`, `rad/s`, `rev/min` or `N mm`; one where it is not known.
pub(crate) fn scale(text: &str) -> Scale {
    let total = powers(text)
        .into_iter()
        .try_fold(Scale::one(), |total, (name, exponent)| {
            let (factor, pi) = unit(name)?;
            Some(total.times(&factor, pi, exponent))
        });
    total.unwrap_or_else(Scale::one)
}

/// The powers of kilogram, metre and second, doubled so that a root has them too.
pub(crate) type Dimension = [i32; 3];

/// The dimension of a unit; `None` where it is not known or belongs to another system.
pub(crate) fn dimension(text: &str) -> Option<Dimension> {
    let found = powers(text);
    let all = found
        .iter()
        .try_fold([0; 3], |total: Dimension, (name, exponent)| {
            let base: Dimension = match *name {
                "kg" | "g" => [1, 0, 0],
                "m" | "mm" | "cm" | "km" => [0, 1, 0],
                "s" | "ms" | "min" | "h" | "d" | "day" | "days" => [0, 0, 1],
                "N" | "mN" | "kN" | "MN" => [1, 1, -2],
                "J" | "mJ" | "kJ" | "MJ" | "Nm" | "kNm" => [1, 2, -2],
                "W" | "kW" | "MW" => [1, 2, -3],
                "Hz" | "rpm" => [0, 0, -1],
                "Pa" | "kPa" | "MPa" => [1, -1, -2],
                "rad" | "rev" | "turn" | "deg" | "°" => [0; 3],
                _ => return None,
            };
            Some([0, 1, 2].map(|i| total[i] + 2 * exponent * base[i]))
        });
    all.filter(|_| !found.is_empty())
}

/// The power behind a unit: `^2`, `^{-1}`, `²`, or a bare digit; one where none is written.
fn exponent(text: &str) -> (i32, &str) {
    let raised = text.strip_prefix('⁻');
    let mut digits = raised.unwrap_or(text).chars();
    let power = digits
        .next()
        .and_then(|c| "⁰¹²³⁴".chars().position(|d| d == c));
    if let Some(power) = power {
        let power = power as i32;
        return (
            if raised.is_some() { -power } else { power },
            digits.as_str(),
        );
    }
    let inside = text.trim_start_matches(['^', '{', '(']);
    let negative = inside.starts_with('-');
    let digits = inside.strip_prefix('-').unwrap_or(inside);
    let length = digits.bytes().take_while(u8::is_ascii_digit).count();
    match digits[..length].parse::<i32>() {
        Ok(n) if n < 10 => (if negative { -n } else { n }, &digits[length..]),
        _ => (1, text),
    }
}
