//! Terms in descending order, and their sums and products.
//!
//! A single term lies in place: most polynomials of a derivation are a symbol or a number, and no memory is asked for
//! them.

use crate::algebra::work::count_products;
use crate::algebra::{Monomial, Rational};
use foldhash::fast::FixedState;
use num_traits::Zero;
use std::cmp::Ordering;
use std::collections::HashMap;
use std::hash::{Hash, Hasher};

/// A monomial with its coefficient.
pub(super) type Term = (Monomial, Rational);

/// Products of terms from which on like ones are found by hashing: sorted merges are faster below.
const MANY_PRODUCTS: usize = 4096;

/// Terms, monomials descending, no coefficient zero.
#[derive(Clone, Debug)]
pub(super) enum Terms {
    One(Term),
    Any(Vec<Term>),
}

impl Terms {
    pub(super) fn as_slice(&self) -> &[Term] {
        match self {
            Self::One(term) => std::slice::from_ref(term),
            Self::Any(terms) => terms,
        }
    }

    /// Each coefficient negated.
    #[inline]
    pub(super) fn negate(&mut self) {
        match self {
            Self::One((_, coefficient)) => coefficient.negate(),
            Self::Any(terms) => terms.iter_mut().for_each(|(_, c)| c.negate()),
        }
    }

    /// Each term times one that is not zero. The order stays.
    #[inline]
    pub(super) fn multiply(&mut self, monomial: &Monomial, coefficient: &Rational) {
        let one = |(m, c): &mut Term| {
            m.multiply(monomial);
            *c *= coefficient;
        };
        match self {
            Self::One(term) => one(term),
            Self::Any(terms) => terms.iter_mut().for_each(one),
        }
    }

    /// The sum.
    #[inline]
    pub(super) fn plus(self, other: Self) -> Self {
        match (self, other) {
            (Self::One(a), Self::One(b)) => pair(a, b),
            (Self::Any(terms), Self::One(term)) | (Self::One(term), Self::Any(terms)) => {
                Self::Any(inserted(terms, term))
            }
            (Self::Any(a), Self::Any(b)) => Self::Any(merged(a, b)),
        }
    }

    /// The product.
    #[inline]
    pub(super) fn times(mut self, mut other: Self) -> Self {
        count_products(self.as_slice().len(), other.as_slice().len());
        if let Self::One((monomial, coefficient)) = &other {
            self.multiply(monomial, coefficient);
            return self;
        }
        match (&self, &other) {
            (Self::One((monomial, coefficient)), _) => {
                other.multiply(monomial, coefficient);
                other
            }
            _ => Self::Any(product(self.as_slice(), other.as_slice())),
        }
    }
}

/// The products of the terms in pairs.
fn product(a: &[Term], b: &[Term]) -> Vec<Term> {
    let (short, long) = if a.len() <= b.len() { (a, b) } else { (b, a) };
    if short.len().saturating_mul(long.len()) >= MANY_PRODUCTS {
        hashed(short, long)
    } else {
        rows(short, long)
    }
}

#[inline]
fn pair(mut a: Term, b: Term) -> Terms {
    let (first, last) = match a.0.cmp(&b.0) {
        Ordering::Equal => {
            a.1 += b.1;
            return if a.1.is_zero() {
                Terms::default()
            } else {
                Terms::One(a)
            };
        }
        Ordering::Greater => (a, b),
        Ordering::Less => (b, a),
    };
    let mut terms = Vec::with_capacity(4);
    terms.push(first);
    terms.push(last);
    Terms::Any(terms)
}

#[inline]
fn inserted(mut terms: Vec<Term>, term: Term) -> Vec<Term> {
    match terms.binary_search_by(|known| term.0.cmp(&known.0)) {
        Ok(place) => {
            terms[place].1 += term.1;
            if terms[place].1.is_zero() {
                terms.remove(place);
            }
        }
        Err(place) => terms.insert(place, term),
    }
    terms
}

fn merged(mut a: Vec<Term>, b: Vec<Term>) -> Vec<Term> {
    let (Some(last), Some(first)) = (a.last(), b.first()) else {
        return if a.is_empty() { b } else { a };
    };
    if last.0 > first.0 {
        a.extend(b);
        return a;
    }
    let mut terms = Vec::with_capacity(a.len() + b.len());
    let (mut a, mut b) = (a.into_iter(), b.into_iter());
    while let (Some(x), Some(y)) = (a.as_slice().first(), b.as_slice().first()) {
        match x.0.cmp(&y.0) {
            Ordering::Greater => terms.extend(a.next()),
            Ordering::Less => terms.extend(b.next()),
            Ordering::Equal => {
                if let (Some((monomial, mut sum)), Some((_, more))) = (a.next(), b.next()) {
                    sum += more;
                    if !sum.is_zero() {
                        terms.push((monomial, sum));
                    }
                }
            }
        }
    }
    terms.extend(a);
    terms.extend(b);
    terms
}

/// The rows of a product, merged in pairs: each is in order, as multiplying by one monomial keeps it.
fn rows(short: &[Term], long: &[Term]) -> Vec<Term> {
    match short {
        [] => vec![],
        [(monomial, coefficient)] => long
            .iter()
            .map(|(m, c)| (m.times(monomial), c.times(coefficient)))
            .collect(),
        _ => {
            let (upper, lower) = short.split_at(short.len() / 2);
            merged(rows(upper, long), rows(lower, long))
        }
    }
}

fn hashed(short: &[Term], long: &[Term]) -> Vec<Term> {
    let mut sums: HashMap<Monomial, Rational, FixedState> = HashMap::default();
    for (m, c) in short {
        for (n, d) in long {
            *sums.entry(m.times(n)).or_insert_with(Rational::zero) += c.times(d);
        }
    }
    let mut terms: Vec<Term> = sums.into_iter().filter(|(_, c)| !c.is_zero()).collect();
    terms.sort_unstable_by(|a, b| b.0.cmp(&a.0));
    terms
}

impl Default for Terms {
    fn default() -> Self {
        Self::Any(vec![])
    }
}

/// Equal where the terms are, wherever they lie.
impl PartialEq for Terms {
    fn eq(&self, other: &Self) -> bool {
        self.as_slice() == other.as_slice()
    }
}

impl Eq for Terms {}

impl Hash for Terms {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.as_slice().hash(state);
    }
}

impl From<Vec<Term>> for Terms {
    fn from(mut terms: Vec<Term>) -> Self {
        match (terms.len(), terms.pop()) {
            (1, Some(term)) => Self::One(term),
            (_, last) => {
                terms.extend(last);
                Self::Any(terms)
            }
        }
    }
}

impl FromIterator<Term> for Terms {
    fn from_iter<I: IntoIterator<Item = Term>>(terms: I) -> Self {
        let mut terms = terms.into_iter();
        match (terms.next(), terms.next()) {
            (Some(term), None) => Self::One(term),
            (first, second) => Self::Any(first.into_iter().chain(second).chain(terms).collect()),
        }
    }
}
