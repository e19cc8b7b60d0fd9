//! Products of powers of variables, packed into one machine word pair while they fit.

use std::cmp::Ordering;
use std::fmt;

mod short;

/// A variable: an index whose meaning the caller keeps.
pub type Variable = u32;

/// Variables that have a byte of their own in the packed form.
const PACKED: u32 = 15;
/// The top bit of each of the sixteen bytes: set where an exponent has outgrown its byte.
const FULL: u128 = 0x8080_8080_8080_8080_8080_8080_8080_8080;

/// A product of powers of variables, ordered by total degree and then lexicographically.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Monomial(Form);

/// The packed form holds the total degree in the top byte and below it the exponent of variable 0, 1, … 14. The short
/// form lists up to seven variables with their exponents in one word, of any document ([`short`] says how). A monomial
/// is in the first form that it fits, so that equal monomials have equal forms.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Form {
    Packed(Word),
    Short(Word),
    Sparse(Box<[(Variable, u32)]>),
}

/// Sixteen bytes, the upper half first. They are aligned like one word, which makes a term shorter by sixteen bytes.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct Word([u64; 2]);

impl Word {
    #[inline]
    fn bits(self) -> u128 {
        u128::from(self.0[0]) << 64 | u128::from(self.0[1])
    }
}

impl From<u128> for Word {
    #[inline]
    fn from(bits: u128) -> Self {
        Self([(bits >> 64) as u64, bits as u64])
    }
}

impl Monomial {
    /// The empty product.
    #[inline]
    pub fn one() -> Self {
        Self(Form::Packed(Word([0; 2])))
    }

    /// A variable.
    pub fn of(variable: Variable) -> Self {
        Self::ascending(&[(variable, 1)])
    }

    /// A product of powers of different variables.
    pub fn from_powers(powers: impl IntoIterator<Item = (Variable, u32)>) -> Self {
        let mut powers: Vec<_> = powers.into_iter().filter(|&(_, e)| e > 0).collect();
        powers.sort_unstable();
        Self::ascending(&powers)
    }

    /// Of powers with variables ascending and no exponent zero.
    fn ascending(powers: &[(Variable, u32)]) -> Self {
        let degree: u64 = powers.iter().map(|&(_, e)| u64::from(e)).sum();
        if degree < 128 && powers.last().is_none_or(|&(v, _)| v < PACKED) {
            let packed = powers
                .iter()
                .fold(u128::from(degree) << 120, |word, &(v, e)| {
                    word | u128::from(e) << shift(v)
                });
            return Self(Form::Packed(packed.into()));
        }
        match short::word(powers) {
            Some(word) => Self(Form::Short(word.into())),
            None => Self(Form::Sparse(powers.into())),
        }
    }

    /// Of a word in the short form, brought to the form that is its own.
    fn from_word(word: u128) -> Self {
        if word >> 120 < 128 && short::last(word).is_none_or(|v| v < PACKED) {
            let degree = word & 0xff << 120;
            let packed = Factors::Short(word << 8)
                .fold(degree, |packed, (v, e)| packed | u128::from(e) << shift(v));
            return Self(Form::Packed(packed.into()));
        }
        Self(Form::Short(word.into()))
    }

    /// The monomial in the short form, where it fits.
    #[inline]
    fn word(&self) -> Option<u128> {
        match self.0 {
            Form::Short(word) => Some(word.bits()),
            Form::Packed(word) => short::of_packed(word.bits()),
            Form::Sparse(_) => None,
        }
    }

    /// Variables and their exponents, variables ascending.
    pub fn factors(&self) -> impl Iterator<Item = (Variable, u32)> + Clone {
        match &self.0 {
            Form::Packed(word) => Factors::Packed(word.bits() << 8, 0),
            Form::Short(word) => Factors::Short(word.bits() << 8),
            Form::Sparse(powers) => Factors::Sparse(powers.iter()),
        }
    }

    /// Variables and their exponents, variables ascending.
    pub fn powers(&self) -> Vec<(Variable, u32)> {
        self.factors().collect()
    }

    /// The sum of the exponents.
    #[inline]
    pub fn degree(&self) -> u32 {
        match &self.0 {
            Form::Packed(word) | Form::Short(word) => (word.bits() >> 120) as u32,
            Form::Sparse(powers) => powers.iter().map(|&(_, e)| e).sum(),
        }
    }

    /// The exponent of a variable.
    #[inline]
    pub fn exponent(&self, variable: Variable) -> u32 {
        match &self.0 {
            Form::Packed(word) if variable < PACKED => {
                ((word.bits() >> shift(variable)) & 0x7f) as u32
            }
            Form::Packed(_) => 0,
            Form::Short(word) => short::exponent(word.bits(), variable),
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
            let sum = a.bits() + b.bits();
            if sum & FULL == 0 {
                return Self(Form::Packed(sum.into()));
            }
        }
        self.times_in_any_form(other)
    }

    /// Apart from the packed product, which is short enough to stand in line without it.
    #[cold]
    fn times_in_any_form(&self, other: &Self) -> Self {
        if let Form::Packed(Word([0, 0])) = other.0 {
            return self.clone();
        }
        self.merged(other, |a, b| a + b)
    }

    /// Takes on the powers of another.
    #[inline]
    pub fn multiply(&mut self, other: &Self) {
        if let (Form::Packed(a), Form::Packed(b)) = (&mut self.0, &other.0) {
            let sum = a.bits() + b.bits();
            if sum & FULL == 0 {
                *a = sum.into();
                return;
            }
        }
        *self = self.times_in_any_form(other);
    }

    /// The quotient, where every power is there.
    pub fn quotient(&self, other: &Self) -> Option<Self> {
        if let (Form::Packed(a), Form::Packed(b)) = (&self.0, &other.0) {
            // With the top bits set no byte borrows from the next; one that stays set says that its byte had enough.
            let difference = (a.bits() | FULL) - b.bits();
            return (difference & FULL == FULL)
                .then(|| Self(Form::Packed((difference & !FULL).into())));
        }
        let enough = other.factors().all(|(v, e)| self.exponent(v) >= e);
        enough.then(|| self.merged(other, |a, b| a.saturating_sub(b)))
    }

    /// The least common multiple.
    pub fn lcm(&self, other: &Self) -> Self {
        self.merged(other, u32::max)
    }

    /// The greatest common divisor.
    pub fn gcd(&self, other: &Self) -> Self {
        self.merged(other, u32::min)
    }

    /// The monomial without a variable.
    pub fn without(&self, variable: Variable) -> Self {
        match &self.0 {
            Form::Packed(word) if variable < PACKED => {
                let word = word.bits();
                let exponent = word >> shift(variable) & 0x7f;
                let rest = word - (exponent << shift(variable)) - (exponent << 120);
                Self(Form::Packed(rest.into()))
            }
            Form::Packed(word) => Self(Form::Packed(*word)),
            Form::Short(word) => Self::from_word(short::without(word.bits(), variable)),
            Form::Sparse(_) => Self::from_powers(self.factors().filter(|&(v, _)| v != variable)),
        }
    }

    /// Both joined, exponent by exponent.
    fn merged(&self, other: &Self, join: impl Fn(u32, u32) -> u32) -> Self {
        if let (Some(a), Some(b)) = (self.word(), other.word())
            && let Some(word) = short::merged(a, b, &join)
        {
            return Self::from_word(word);
        }
        let (mut a, mut b) = (self.factors().peekable(), other.factors().peekable());
        let mut powers = vec![];
        while let Some(next) = first(a.peek(), b.peek()) {
            let left = a.next_if(|&(v, _)| v == next).map_or(0, |(_, e)| e);
            let right = b.next_if(|&(v, _)| v == next).map_or(0, |(_, e)| e);
            let exponent = join(left, right);
            if exponent > 0 {
                powers.push((next, exponent));
            }
        }
        Self::ascending(&powers)
    }
}

/// The lower of the next variables.
fn first(a: Option<&(Variable, u32)>, b: Option<&(Variable, u32)>) -> Option<Variable> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.0.min(b.0)),
        (one, other) => one.or(other).map(|p| p.0),
    }
}

/// The factors of a monomial that are still to come.
#[derive(Clone)]
enum Factors<'a> {
    /// The bytes of the exponents, the next one on top, and the variable that it belongs to.
    Packed(u128, Variable),
    /// The entries of a short word, the next one on top.
    Short(u128),
    Sparse(std::slice::Iter<'a, (Variable, u32)>),
}

impl Iterator for Factors<'_> {
    type Item = (Variable, u32);

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        match self {
            Self::Packed(0, _) => None,
            Self::Packed(word, variable) => {
                let empty = word.leading_zeros() / 8;
                let (found, rest) = (*variable + empty, *word << (8 * empty));
                let exponent = (rest >> 120) as u32;
                (*word, *variable) = (rest << 8, found + 1);
                Some((found, exponent))
            }
            Self::Short(word) => {
                let entry = short::entry(*word);
                *word <<= short::ENTRY;
                entry
            }
            Self::Sparse(powers) => powers.next().copied(),
        }
    }
}

#[inline]
fn shift(variable: Variable) -> u32 {
    8 * (PACKED - 1 - variable)
}

impl Ord for Monomial {
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        match (&self.0, &other.0) {
            (Form::Packed(a), Form::Packed(b)) | (Form::Short(a), Form::Short(b)) => {
                a.bits().cmp(&b.bits())
            }
            _ => across_forms(self, other),
        }
    }
}

fn across_forms(one: &Monomial, other: &Monomial) -> Ordering {
    let degrees = one.degree().cmp(&other.degree());
    degrees.then_with(|| lexicographic(one.factors(), other.factors()))
}

/// The higher power of the first variable that differs is the greater.
fn lexicographic(
    mut a: impl Iterator<Item = (Variable, u32)>,
    mut b: impl Iterator<Item = (Variable, u32)>,
) -> Ordering {
    loop {
        match (a.next(), b.next()) {
            (Some((v, e)), Some((w, f))) => {
                let order = w.cmp(&v).then(e.cmp(&f));
                if order != Ordering::Equal {
                    return order;
                }
            }
            (a, b) => return a.is_some().cmp(&b.is_some()),
        }
    }
}

impl PartialOrd for Monomial {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Debug for Monomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.factors().try_for_each(|(v, e)| write!(f, "·v{v}^{e}"))
    }
}
