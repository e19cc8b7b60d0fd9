//! Polynomials and fractions as text, in the order in which a physicist writes them.

use crate::algebra::{Fraction, Monomial, Polynomial, Rational, Variable};
use num_traits::One;
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// What the text is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// LaTeX mathematics, without dollar signs.
    Latex,
    /// Plain text with Unicode signs.
    Unicode,
}

/// What a variable is, which decides where it stands.
///
/// Within a product the earlier place comes first (`I_xx` before `ω_x`); a sum begins with the terms that hold
/// the latest place (`I_xx ω̇_x` before `I_zz ω_y ω_z`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    /// A property of the body or of the setting: mass, inertia, a length.
    Parameter,
    /// A coordinate, an angle, a function of one.
    Coordinate,
    /// A velocity, a momentum.
    Rate,
    /// An acceleration, a rate of momentum, a moment.
    Acceleration,
    /// A sine or cosine: written last in a product, so that nothing is taken for its argument. It leads no sum.
    Function,
}

/// How a variable is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Letter {
    /// The text, in the style asked for.
    pub text: String,
    /// What it is.
    pub place: Place,
}

/// Writes polynomials and fractions with the letters of the caller.
///
/// ```
/// use polhode::algebra::{Letter, Place, Polynomial, Printer, Style};
/// let letters = |v: u32| match v {
///     0 => Letter { text: "I_yy".into(), place: Place::Parameter },
///     1 => Letter { text: "I_zz".into(), place: Place::Parameter },
///     _ => Letter { text: format!("ω_{}", ["y", "z"][v as usize - 2]), place: Place::Rate },
/// };
/// let [b, c, y, z] = [0, 1, 2, 3].map(Polynomial::variable);
/// let printer = Printer::new(Style::Unicode, &letters);
/// let gyroscopic = (c - b) * y * z;
/// assert_eq!(printer.polynomial(&gyroscopic), "I_zz ω_y ω_z − I_yy ω_y ω_z");
/// assert_eq!(printer.collected(&gyroscopic, &[2, 3]), "(I_zz − I_yy) ω_y ω_z");
/// ```
pub struct Printer<'a> {
    style: Style,
    letters: &'a dyn Fn(Variable) -> Letter,
}

impl<'a> Printer<'a> {
    /// A printer in a style, with a letter for each variable.
    pub fn new(style: Style, letters: &'a dyn Fn(Variable) -> Letter) -> Self {
        Self { style, letters }
    }

    /// The polynomial, multiplied out.
    pub fn polynomial(&self, polynomial: &Polynomial) -> String {
        let mut terms: Vec<_> = polynomial.terms().iter().collect();
        terms.sort_by_cached_key(|(monomial, c)| self.rank(monomial, c.is_negative()));
        let signed = terms.into_iter().map(|(monomial, coefficient)| {
            (
                coefficient.is_negative(),
                self.term(&coefficient.abs(), monomial),
            )
        });
        self.sum(signed)
    }

    /// The polynomial as a sum of products of the variables `by`, each with its coefficient in parentheses.
    pub fn collected(&self, polynomial: &Polynomial, by: &[Variable]) -> String {
        let mut groups: BTreeMap<Monomial, Vec<(Monomial, Rational)>> = BTreeMap::new();
        for (monomial, coefficient) in polynomial.terms() {
            let (taken, rest): (Vec<_>, Vec<_>) = monomial
                .powers()
                .into_iter()
                .partition(|(v, _)| by.contains(v));
            let group = groups.entry(Monomial::from_powers(taken)).or_default();
            group.push((Monomial::from_powers(rest), coefficient.clone()));
        }
        let mut groups: Vec<_> = groups
            .into_iter()
            .map(|(monomial, terms)| (monomial, Polynomial::from_terms(terms)))
            .collect();
        groups.sort_by_cached_key(|(monomial, factor)| {
            self.rank(monomial, self.leads_negative(factor))
        });
        self.sum(
            groups
                .iter()
                .map(|(monomial, factor)| self.group(monomial, factor)),
        )
    }

    /// The fraction; without a denominator where there is none.
    pub fn fraction(&self, fraction: &Fraction) -> String {
        let top = self.polynomial(fraction.numerator());
        if fraction
            .denominator()
            .is_constant()
            .is_some_and(|d| d.is_one())
        {
            return top;
        }
        let bottom = self.polynomial(fraction.denominator());
        match self.style {
            Style::Latex => format!("\\frac{{{top}}}{{{bottom}}}"),
            Style::Unicode => {
                let top = parenthesised_if(top, fraction.numerator().len() > 1);
                let single = fraction.denominator().terms();
                let is_letter = matches!(single, [(m, _)] if m.degree() == 1);
                format!("{top}/{}", parenthesised_if(bottom, !is_letter))
            }
        }
    }

    /// A number.
    pub fn number(&self, value: &Rational) -> String {
        let sign = if value.is_negative() {
            self.minus()
        } else {
            ""
        };
        format!("{sign}{}", self.magnitude(&value.abs()))
    }

    /// Terms with accelerations first, then few factors before many, then plus before minus, then by variable.
    fn rank(&self, monomial: &Monomial, negative: bool) -> impl Ord + use<> {
        let factors = self.factors(monomial);
        let places = factors.iter().map(|f| f.place);
        let latest = places.filter(|p| *p != Place::Function).max();
        let moving = |f: &&Factor| f.place != Place::Parameter;
        let degree: u32 = factors.iter().filter(moving).map(|f| f.exponent).sum();
        let order: Vec<_> = factors
            .iter()
            .map(|f| (f.place, f.variable, Reverse(f.exponent)))
            .collect();
        (Reverse(latest), degree, negative, order)
    }

    fn leads_negative(&self, polynomial: &Polynomial) -> bool {
        polynomial.terms().iter().all(|(_, c)| c.is_negative())
    }

    fn group(&self, monomial: &Monomial, factor: &Polynomial) -> (bool, String) {
        if let [(rest, coefficient)] = factor.terms() {
            let text = self.term(&coefficient.abs(), &rest.times(monomial));
            return (coefficient.is_negative(), text);
        }
        let negative = self.leads_negative(factor);
        let inner = self.polynomial(&if negative {
            -factor.clone()
        } else {
            factor.clone()
        });
        if monomial.degree() == 0 {
            // Nothing was collected: a sum of its own, in parentheses only behind a minus.
            return (negative, parenthesised_if(inner, negative));
        }
        (
            negative,
            format!("({inner}) {}", self.term(&Rational::one(), monomial)),
        )
    }

    fn sum(&self, terms: impl Iterator<Item = (bool, String)>) -> String {
        let mut text = String::new();
        for (negative, term) in terms {
            match (text.is_empty(), negative) {
                (true, true) => text.push_str(self.minus()),
                (true, false) => {}
                (false, true) => text.push_str(&format!(" {} ", self.minus())),
                (false, false) => text.push_str(" + "),
            }
            text.push_str(&term);
        }
        if text.is_empty() {
            "0".to_owned()
        } else {
            text
        }
    }

    fn minus(&self) -> &'static str {
        match self.style {
            Style::Latex => "-",
            Style::Unicode => "−",
        }
    }

    /// A term without its sign.
    fn term(&self, coefficient: &Rational, monomial: &Monomial) -> String {
        let factors = self.factors(monomial);
        let letters = factors.iter().map(|f| self.power(&f.text, f.exponent));
        let number =
            (!coefficient.is_one() || monomial.degree() == 0).then(|| self.magnitude(coefficient));
        number
            .into_iter()
            .chain(letters)
            .collect::<Vec<_>>()
            .join(" ")
    }

    fn factors(&self, monomial: &Monomial) -> Vec<Factor> {
        let mut factors: Vec<_> = monomial
            .powers()
            .into_iter()
            .map(|(variable, exponent)| {
                let Letter { text, place } = (self.letters)(variable);
                Factor {
                    place,
                    variable,
                    exponent,
                    text,
                }
            })
            .collect();
        factors.sort_by_key(|f| (f.place, f.variable));
        factors
    }

    fn magnitude(&self, value: &Rational) -> String {
        let text = value.to_string();
        let Some((top, bottom)) = text.split_once('/') else {
            return text;
        };
        match (self.style, text.as_str()) {
            (Style::Latex, _) => format!("\\tfrac{{{top}}}{{{bottom}}}"),
            (Style::Unicode, "1/2") => "½".to_owned(),
            (Style::Unicode, "1/3") => "⅓".to_owned(),
            (Style::Unicode, "2/3") => "⅔".to_owned(),
            (Style::Unicode, "1/4") => "¼".to_owned(),
            (Style::Unicode, "3/4") => "¾".to_owned(),
            (Style::Unicode, _) => format!("({text})"),
        }
    }

    fn power(&self, letter: &str, exponent: u32) -> String {
        if exponent == 1 {
            return letter.to_owned();
        }
        // The exponent of a function stands before its argument: sin² θ.
        let (base, argument) = match letter.split_once(' ') {
            Some((function @ ("\\sin" | "\\cos" | "sin" | "cos"), argument)) => {
                (function.to_owned(), format!(" {argument}"))
            }
            _ => {
                let several = letter.contains(['^', ' ', '/']);
                (parenthesised_if(letter.to_owned(), several), String::new())
            }
        };
        match self.style {
            Style::Latex => format!("{base}^{{{exponent}}}{argument}"),
            Style::Unicode => base + &superscript(exponent) + &argument,
        }
    }
}

struct Factor {
    place: Place,
    variable: Variable,
    exponent: u32,
    text: String,
}

fn parenthesised_if(text: String, needed: bool) -> String {
    if needed { format!("({text})") } else { text }
}

fn superscript(number: u32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    number
        .to_string()
        .bytes()
        .map(|digit| DIGITS[usize::from(digit - b'0') % 10])
        .collect()
}
