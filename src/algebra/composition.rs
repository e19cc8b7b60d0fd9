//! Fractions put in for the variables of a polynomial, over one common denominator.
//!
//! Adding term by term would multiply denominators again and again; here each denominator stands below once, in the
//! highest power that any term needs.

use crate::algebra::{Fraction, Polynomial, Variable};
use foldhash::fast::FixedState;
use num_traits::One;
use std::hash::BuildHasher;

type HashMap<K, V, S = FixedState> = std::collections::HashMap<K, V, S>;

/// Why nothing was put in: a product would have had more terms than allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLarge;

impl std::fmt::Display for TooLarge {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("a product grew beyond the number of terms that is allowed")
    }
}

impl std::error::Error for TooLarge {}

/// The polynomial with each variable replaced by its image; variables without one stay.
///
/// # Errors
///
/// [`TooLarge`] where a product of intermediate results could have more than `most` terms.
pub fn compose<S: BuildHasher>(
    polynomial: &Polynomial,
    images: &HashMap<Variable, Fraction, S>,
    most: usize,
) -> Result<Fraction, TooLarge> {
    compose_by(polynomial, |variable| images.get(&variable), most)
}

/// The same with what tells the image of a variable.
///
/// # Errors
///
/// As [`compose`].
pub fn compose_by<'i>(
    polynomial: &Polynomial,
    image: impl Fn(Variable) -> Option<&'i Fraction>,
    most: usize,
) -> Result<Fraction, TooLarge> {
    let mut below = Denominators::of(polynomial, &image);
    let mut powers: HashMap<Variable, Vec<Polynomial>> = HashMap::default();
    let mut sum = Summands::default();
    for (monomial, coefficient) in polynomial.terms() {
        // What stays is multiplied in one piece.
        let mut stay = monomial.clone();
        let told = monomial
            .factors()
            .filter_map(|(v, e)| Some((v, e, image(v)?)));
        told.clone()
            .for_each(|(variable, ..)| stay = stay.without(variable));
        let mut product = Polynomial::term(stay, coefficient.clone());
        let mut used = vec![0; below.distinct.len()];
        for (variable, exponent, image) in told {
            let known = powers
                .entry(variable)
                .or_insert_with(|| vec![Polynomial::one(), image.numerator().clone()]);
            raise(known, exponent as usize, most)?;
            product = product
                .product_within(&known[exponent as usize], most)
                .ok_or(TooLarge)?;
            if let Some(&class) = below.class.get(&variable) {
                used[class] += exponent;
            }
        }
        for (class, used) in used.into_iter().enumerate() {
            let missing = (below.highest[class] - used) as usize;
            raise(&mut below.distinct[class], missing, most)?;
            product = product
                .product_within(&below.distinct[class][missing], most)
                .ok_or(TooLarge)?;
        }
        sum.add(product, most)?;
    }
    let sum = sum.total();
    let mut denominator = Polynomial::one();
    for (class, &power) in below.highest.iter().enumerate() {
        raise(&mut below.distinct[class], power as usize, most)?;
        denominator = denominator
            .product_within(&below.distinct[class][power as usize], most)
            .ok_or(TooLarge)?;
    }
    Ok(Fraction::from(sum) / Fraction::from(denominator))
}

/// A sum in parts, each at least twice as long as the next, so that a term is moved a few times only.
#[derive(Default)]
struct Summands(Vec<Polynomial>);

impl Summands {
    fn add(&mut self, polynomial: Polynomial, most: usize) -> Result<(), TooLarge> {
        let mut last = polynomial;
        while let Some(part) = self.0.pop_if(|part| part.len() < 2 * last.len()) {
            last += part;
        }
        if last.len() > most {
            return Err(TooLarge);
        }
        self.0.push(last);
        Ok(())
    }

    fn total(self) -> Polynomial {
        let mut parts = self.0.into_iter().rev();
        let first = parts.next().unwrap_or_default();
        parts.fold(first, |sum, part| sum + part)
    }
}

/// The different denominators of the images, with their powers, and the highest power that is needed.
struct Denominators {
    distinct: Vec<Vec<Polynomial>>,
    highest: Vec<u32>,
    class: HashMap<Variable, usize>,
}

impl Denominators {
    fn of<'i>(polynomial: &Polynomial, image: &impl Fn(Variable) -> Option<&'i Fraction>) -> Self {
        let mut all = Self {
            distinct: vec![],
            highest: vec![],
            class: HashMap::default(),
        };
        for variable in polynomial.variables() {
            let Some(image) = image(variable) else {
                continue;
            };
            let below = image.denominator();
            if below.is_one() {
                continue;
            }
            let place = all
                .distinct
                .iter()
                .position(|known| known[1] == *below)
                .unwrap_or_else(|| {
                    all.distinct.push(vec![Polynomial::one(), below.clone()]);
                    all.highest.push(0);
                    all.distinct.len() - 1
                });
            all.class.insert(variable, place);
        }
        if all.distinct.is_empty() {
            return all;
        }
        for (monomial, _) in polynomial.terms() {
            let mut used = vec![0; all.distinct.len()];
            for (variable, exponent) in monomial.factors() {
                if let Some(&class) = all.class.get(&variable) {
                    used[class] += exponent;
                }
            }
            for (highest, used) in all.highest.iter_mut().zip(used) {
                *highest = (*highest).max(used);
            }
        }
        all
    }
}

/// Makes the powers of a polynomial known up to an exponent.
fn raise(known: &mut Vec<Polynomial>, exponent: usize, most: usize) -> Result<(), TooLarge> {
    while known.len() <= exponent {
        let next = known[known.len() - 1]
            .product_within(&known[1], most)
            .ok_or(TooLarge)?;
        known.push(next);
    }
    Ok(())
}
