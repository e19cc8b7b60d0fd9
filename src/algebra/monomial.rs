//! Products of powers of variables, packed into one machine word pair while they fit.

use std::cmp::Ordering;
use std::fmt;

/// A variable: an index whose meaning the caller keeps.
pub type Variable = u32;

/// Variables that have a byte of their own in the packed form.
const PACKED: u32 = 15;
/// The top bit of each of the sixteen bytes: set where an exponent has outgrown its byte.
const FULL: u128 = 0x8080_8080_8080_8080_8080_8080_8080_8080;

/// A product of powers of variables, ordered by total degree and then lexicographically.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Monomial(Form);

/// The packed form holds the total degree in the top byte and below it the exponent of variable 0, 1, … 14. A
/// monomial that fits is always packed, so that equal monomials have equal forms.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Form {
    Packed(u128),
    Sparse(Box<[(Variable, u32)]>),
}

impl Monomial {
    /// The empty product.
    #[inline]
    pub fn one() -> Self {
        Self(Form::Packed(0))
    }

    /// A variable.
    pub fn of(variable: Variable) -> Self {
        Self::from_powers([(variable, 1)])
    }

    /// A product of powers of different variables.
    pub fn from_powers(powers: impl IntoIterator<Item = (Variable, u32)>) -> Self {
        let mut powers: Vec<_> = powers.into_iter().filter(|&(_, e)| e > 0).collect();
        powers.sort_unstable();
        let degree: u64 = powers.iter().map(|&(_, e)| u64::from(e)).sum();
        if degree < 128 && powers.last().is_none_or(|&(v, _)| v < PACKED) {
            let packed = powers
                .iter()
                .fold(u128::from(degree) << 120, |word, &(v, e)| {
                    word | u128::from(e) << shift(v)
                });
            return Self(Form::Packed(packed));
        }
        Self(Form::Sparse(powers.into()))
    }

    /// Variables and their exponents, variables ascending.
    pub fn powers(&self) -> Vec<(Variable, u32)> {
        match &self.0 {
            Form::Packed(0) => vec![],
            Form::Packed(word) => {
                let power = |v| ((word >> shift(v)) & 0x7f) as u32;
                (0..PACKED)
                    .map(|v| (v, power(v)))
                    .filter(|&(_, e)| e > 0)
                    .collect()
            }
            Form::Sparse(powers) => powers.to_vec(),
        }
    }

    /// The sum of the exponents.
    pub fn degree(&self) -> u32 {
        match &self.0 {
            Form::Packed(word) => (word >> 120) as u32,
            Form::Sparse(powers) => powers.iter().map(|&(_, e)| e).sum(),
        }
    }

    /// The exponent of a variable.
    #[inline]
    pub fn exponent(&self, variable: Variable) -> u32 {
        match &self.0 {
            Form::Packed(word) if variable < PACKED => ((word >> shift(variable)) & 0x7f) as u32,
            Form::Packed(_) => 0,
            Form::Sparse(powers) => powers
                .binary_search_by_key(&variable, |&(v, _)| v)
                .map_or(0, |i| powers[i].1),
        }
    }

    /// The product.
    #[inline]
    pub fn times(&self, other: &Self) -> Self {
        if let (Form::Packed(a), Form::Packed(b)) = (&self.0, &other.0) {
            // Every byte is below 128, so no sum carries into the next; the top bits tell an overflow.
            let sum = a + b;
            if sum & FULL == 0 {
                return Self(Form::Packed(sum));
            }
        }
        Self::merged(&self.powers(), &other.powers(), |a, b| a + b)
    }

    /// The quotient, where every power is there.
    pub fn quotient(&self, other: &Self) -> Option<Self> {
        if let (Form::Packed(a), Form::Packed(b)) = (&self.0, &other.0) {
            // With the top bits set no byte borrows from the next; one that stays set says that its byte had enough.
            let difference = (a | FULL) - b;
            return (difference & FULL == FULL).then_some(Self(Form::Packed(difference & !FULL)));
        }
        let powers = self.powers();
        let rest = |v: Variable| other.exponent(v);
        let enough = other.powers().iter().all(|&(v, e)| self.exponent(v) >= e);
        enough.then(|| Self::from_powers(powers.into_iter().map(|(v, e)| (v, e - rest(v)))))
    }

    /// The least common multiple.
    pub fn lcm(&self, other: &Self) -> Self {
        Self::merged(&self.powers(), &other.powers(), u32::max)
    }

    /// The greatest common divisor.
    pub fn gcd(&self, other: &Self) -> Self {
        Self::merged(&self.powers(), &other.powers(), u32::min)
    }

    /// The monomial without a variable.
    pub fn without(&self, variable: Variable) -> Self {
        Self::from_powers(self.powers().into_iter().filter(|&(v, _)| v != variable))
    }

    fn merged(
        a: &[(Variable, u32)],
        b: &[(Variable, u32)],
        join: impl Fn(u32, u32) -> u32,
    ) -> Self {
        let (mut i, mut j, mut powers) = (0, 0, Vec::with_capacity(a.len() + b.len()));
        while i < a.len() || j < b.len() {
            let (left, right) = (a.get(i), b.get(j));
            let next = left
                .map_or(u32::MAX, |p| p.0)
                .min(right.map_or(u32::MAX, |p| p.0));
            let take = |p: Option<&(Variable, u32)>, at: &mut usize| match p {
                Some(&(v, e)) if v == next => {
                    *at += 1;
                    e
                }
                _ => 0,
            };
            let exponents = (take(left, &mut i), take(right, &mut j));
            powers.push((next, join(exponents.0, exponents.1)));
        }
        Self::from_powers(powers)
    }
}

#[inline]
fn shift(variable: Variable) -> u32 {
    8 * (PACKED - 1 - variable)
}

impl Ord for Monomial {
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        if let (Form::Packed(a), Form::Packed(b)) = (&self.0, &other.0) {
            return a.cmp(b);
        }
        self.degree()
            .cmp(&other.degree())
            .then_with(|| lexicographic(&self.powers(), &other.powers()))
    }
}

/// The higher power of the first variable that differs is the greater.
fn lexicographic(a: &[(Variable, u32)], b: &[(Variable, u32)]) -> Ordering {
    for (&(v, e), &(w, f)) in a.iter().zip(b) {
        let order = w.cmp(&v).then(e.cmp(&f));
        if order != Ordering::Equal {
            return order;
        }
    }
    a.len().cmp(&b.len())
}

impl PartialOrd for Monomial {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Debug for Monomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.powers()
            .iter()
            .try_for_each(|(v, e)| write!(f, "·v{v}^{e}"))
    }
}
