//! Checks the text form of a certificate with arithmetic of its own: maps from powers to big rationals.

use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};
use std::collections::BTreeMap;

type Powers = BTreeMap<String, u32>;

/// A polynomial: powers of variables with their coefficients, none of them zero.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Sum(BTreeMap<Powers, BigRational>);

impl Sum {
    fn number(value: BigRational) -> Self {
        Self::default().with(Powers::new(), value)
    }

    fn variable(name: &str) -> Self {
        let powers = Powers::from([(name.to_owned(), 1)]);
        Self::default().with(powers, BigRational::one())
    }

    fn with(mut self, powers: Powers, value: BigRational) -> Self {
        let entry = self
            .0
            .entry(powers.clone())
            .or_insert_with(BigRational::zero);
        *entry += value;
        if entry.is_zero() {
            self.0.remove(&powers);
        }
        self
    }

    fn plus(&self, other: &Self, factor: i64) -> Self {
        let factor = BigRational::from_integer(factor.into());
        let terms = other.0.iter();
        terms.fold(self.clone(), |sum, (p, c)| sum.with(p.clone(), c * &factor))
    }

    fn times(&self, other: &Self) -> Self {
        let mut product = Self::default();
        for (p, c) in &self.0 {
            for (q, d) in &other.0 {
                let mut powers = p.clone();
                for (name, exponent) in q {
                    *powers.entry(name.clone()).or_default() += exponent;
                }
                product = product.with(powers, c * d);
            }
        }
        product
    }

    fn partial(&self, name: &str) -> Self {
        let mut slope = Self::default();
        for (powers, c) in &self.0 {
            let mut lower = powers.clone();
            let Some(exponent) = lower.remove(name) else {
                continue;
            };
            if exponent > 1 {
                lower.insert(name.to_owned(), exponent - 1);
            }
            slope = slope.with(lower, c * BigRational::from_integer(exponent.into()));
        }
        slope
    }

    fn variables(&self) -> Vec<String> {
        let mut names: Vec<_> = self.0.keys().flat_map(|p| p.keys().cloned()).collect();
        names.sort();
        names.dedup();
        names
    }

    fn is_number(&self) -> bool {
        self.0.keys().all(Powers::is_empty)
    }

    /// The quotient by a polynomial, where it leaves nothing.
    fn over(&self, divisor: &Self) -> Option<Self> {
        let mut names = self.variables();
        names.extend(divisor.variables());
        let (lead, by) = divisor.lead(&names)?;
        let (mut rest, mut quotient) = (self.clone(), Self::default());
        while let Some((powers, c)) = rest.lead(&names) {
            let mut factor = powers.clone();
            for (name, exponent) in lead {
                let left = factor.get_mut(name)?;
                *left = left.checked_sub(*exponent)?;
            }
            factor.retain(|_, exponent| *exponent > 0);
            let term = Self::default().with(factor, c / by);
            rest = rest.plus(&term.times(divisor), -1);
            quotient = quotient.plus(&term, 1);
        }
        Some(quotient)
    }

    /// The term that is first in the lexicographic order of these variables.
    fn lead(&self, names: &[String]) -> Option<(&Powers, &BigRational)> {
        let exponents = |powers: &Powers| -> Vec<u32> {
            let exponent = |name| powers.get(name).copied().unwrap_or(0);
            names.iter().map(exponent).collect()
        };
        self.0.iter().max_by_key(|(powers, _)| exponents(powers))
    }
}

/// `3/2*v0^2*v1 - v2`.
pub(super) fn sum(text: &str) -> Sum {
    let spaced = text.replace(" - ", " + -");
    spaced
        .split(" + ")
        .filter(|term| *term != "0")
        .fold(Sum::default(), |total, term| {
            let (sign, term) = match term.strip_prefix('-') {
                Some(rest) => (-1, rest),
                None => (1, term),
            };
            let product = term
                .split('*')
                .fold(Sum::number(BigRational::one()), |product, factor| {
                    product.times(&self::factor(factor))
                });
            total.plus(&product, sign)
        })
}

fn factor(text: &str) -> Sum {
    if !text.starts_with('v') {
        return Sum::number(text.parse().expect("a number"));
    }
    let (name, exponent) = text.split_once('^').unwrap_or((text, "1"));
    let exponent: u32 = exponent.parse().expect("an exponent");
    (0..exponent).fold(Sum::number(BigRational::one()), |power, _| {
        power.times(&Sum::variable(name))
    })
}

fn ratio(text: &str) -> (Sum, Sum) {
    let inside = text
        .strip_prefix('(')
        .and_then(|t| t.strip_suffix(')'))
        .expect("brackets");
    let (top, bottom) = inside.split_once(") / (").expect("a fraction");
    (sum(top), sum(bottom))
}

#[derive(Default)]
struct Certificate {
    rates: BTreeMap<String, (Sum, Sum)>,
    kernels: BTreeMap<String, (String, Sum, Sum)>,
    conditions: Vec<Sum>,
    facts: Vec<Sum>,
    goals: usize,
}

/// Whether the text is a certificate that holds; the row at fault where it does not.
pub(super) fn check(text: &str) -> Result<(), String> {
    let rows: Vec<(&str, &str)> = text
        .lines()
        .map(|row| row.split_once(' ').unwrap_or((row, "")))
        .collect();
    if rows.first() != Some(&("polhode-certificate/1", "")) || rows.last() != Some(&("end", "")) {
        return Err("no certificate".to_owned());
    }
    let mut certificate = Certificate::default();
    for (at, (word, rest)) in rows.iter().enumerate() {
        certificate
            .row(&rows[at..], word, rest)
            .ok_or_else(|| format!("row {}: {word} {rest}", at + 1))?;
    }
    if certificate.goals == 0 {
        Err("no goal".to_owned())
    } else {
        Ok(())
    }
}

impl Certificate {
    fn row(&mut self, rows: &[(&str, &str)], word: &str, rest: &str) -> Option<()> {
        match word {
            "rate" => {
                let (name, value) = rest.split_once(' ')?;
                self.rates.insert(name.to_owned(), ratio(value));
            }
            "kernel" => {
                let mut parts = rest.splitn(3, ' ');
                let (name, function, value) = (parts.next()?, parts.next()?, ratio(parts.next()?));
                self.kernels
                    .insert(name.to_owned(), (function.to_owned(), value.0, value.1));
            }
            "condition" => self.conditions.push(sum(rest)),
            "fact" => {
                let (name, value) = rest.split_once(' ')?;
                let value = sum(value);
                self.fact(&value, rows)?;
                (name == format!("f{}", self.facts.len())).then_some(())?;
                self.facts.push(value);
            }
            "goal" => {
                let [_, left, right, ..] = rows else {
                    return None;
                };
                (left.0 == "left" && right.0 == "right").then_some(())?;
                let (left, right) = (ratio(left.1), ratio(right.1));
                self.allowed(&left.1)?;
                self.allowed(&right.1)?;
                let difference = left.0.times(&right.1).plus(&right.0.times(&left.1), -1);
                self.combines(&difference, &rows[3..])?;
                self.goals += 1;
            }
            "bound" => {
                let [_, ("lower", lower), ("upper", upper), ..] = rows else {
                    return None;
                };
                let (top, bottom) = ratio(rest);
                let value = self.number(&top)? / self.number(&bottom)?;
                let end = |text: &str| text.parse::<BigRational>().ok()?.to_f64();
                // Doubles hold fifteen digits; nobody shows so many.
                let slack = 1e-13 * value.abs();
                (end(lower)? - slack <= value && value <= end(upper)? + slack).then_some(())?;
            }
            _ => {}
        }
        Some(())
    }

    /// The value of a polynomial in functions of numbers.
    fn number(&self, of: &Sum) -> Option<f64> {
        let mut total = 0.0;
        for (powers, coefficient) in &of.0 {
            let mut term = coefficient.to_f64()?;
            for (name, exponent) in powers {
                let (function, top, bottom) = self.kernels.get(name)?;
                let argument = self.number(top)? / self.number(bottom)?;
                let value = match function.as_str() {
                    "pi" => std::f64::consts::PI,
                    "sqrt" => argument.sqrt(),
                    "sin" => argument.sin(),
                    "cos" => argument.cos(),
                    "exp" => argument.exp(),
                    "ln" => argument.ln(),
                    _ => return None,
                };
                term *= value.powi(i32::try_from(*exponent).ok()?);
            }
            total += term;
        }
        Some(total)
    }

    fn fact(&self, value: &Sum, rows: &[(&str, &str)]) -> Option<()> {
        let ("reason", reason) = rows.get(1)? else {
            return None;
        };
        let words: Vec<&str> = reason.split(' ').collect();
        let expected = match words.as_slice() {
            ["premise", ..] => return Some(()),
            ["combination"] => return self.combines(value, &rows[2..]),
            ["circle", s, c] => {
                let (sine, cosine) = (self.kernels.get(*s)?, self.kernels.get(*c)?);
                let same = sine.1 == cosine.1 && sine.2 == cosine.2;
                (sine.0 == "sin" && cosine.0 == "cos" && same).then_some(())?;
                self.allowed(&sine.2)?;
                let square = |name: &str| Sum::variable(name).times(&Sum::variable(name));
                square(s)
                    .plus(&square(c), 1)
                    .plus(&Sum::number(BigRational::one()), -1)
            }
            ["root", r] => {
                let (function, top, bottom) = self.kernels.get(*r)?;
                (function == "sqrt").then_some(())?;
                self.allowed(bottom)?;
                bottom
                    .times(&Sum::variable(r))
                    .times(&Sum::variable(r))
                    .plus(top, -1)
            }
            ["rate", of] => self.rate(self.earlier(of)?)?,
            ["congruence", one, other, by] => {
                let (a, b) = (self.kernels.get(*one)?, self.kernels.get(*other)?);
                let equal = a.1.times(&b.2).plus(&b.1.times(&a.2), -1);
                (a.0 == b.0 && *self.earlier(by)? == equal).then_some(())?;
                self.allowed(&a.2)?;
                self.allowed(&b.2)?;
                Sum::variable(one).plus(&Sum::variable(other), -1)
            }
            _ => return None,
        };
        (*value == expected).then_some(())
    }

    fn rate(&self, of: &Sum) -> Option<Sum> {
        let names = of.variables();
        let mut total = Sum::default();
        for name in &names {
            let (top, bottom) = self.rates.get(name)?;
            self.allowed(bottom)?;
            let mut term = of.partial(name).times(top);
            for other in names.iter().filter(|other| *other != name) {
                term = term.times(&self.rates.get(other)?.1);
            }
            total = total.plus(&term, 1);
        }
        Some(total)
    }

    fn earlier(&self, name: &str) -> Option<&Sum> {
        self.facts
            .get(name.strip_prefix('f')?.parse::<usize>().ok()?)
    }

    fn combines(&self, value: &Sum, rows: &[(&str, &str)]) -> Option<()> {
        let ("multiplier", multiplier) = rows.first()? else {
            return None;
        };
        let multiplier = sum(multiplier);
        self.allowed(&multiplier)?;
        let mut left = multiplier.times(value);
        for (_, row) in rows[1..].iter().take_while(|(word, _)| *word == "cofactor") {
            let (fact, cofactor) = row.split_once(' ')?;
            left = left.plus(&sum(cofactor).times(self.earlier(fact)?), -1);
        }
        left.0.is_empty().then_some(())
    }

    /// A divisor is a number that is not zero, times powers of conditions.
    fn allowed(&self, divisor: &Sum) -> Option<()> {
        let mut rest = divisor.clone();
        for condition in self.conditions.iter().filter(|c| !c.is_number()) {
            while !rest.is_number() {
                let Some(quotient) = rest.over(condition) else {
                    break;
                };
                rest = quotient;
            }
        }
        (rest.is_number() && !rest.0.is_empty()).then_some(())
    }
}
