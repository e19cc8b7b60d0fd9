//! How values are printed: collected by rates, with common properties in front, whichever is shorter.

use crate::algebra::{
    Fraction, Letter as Sign, Monomial, Place, Polynomial, Printer, Rational, Style, Variable,
};
use crate::verify::derivation::letters::Letters;
use crate::verify::derivation::text::Text;
use num_traits::Zero;
use std::collections::BTreeMap;

/// A row of more terms is not printed.
const LONGEST: usize = 40;

/// How variables are written, and where in a product.
type Signs = BTreeMap<Variable, (Text, Place)>;

impl Letters {
    /// A value in letters; `None` where it has none for some variable, or is too long.
    pub(super) fn printed(&self, of: &Fraction) -> Option<Text> {
        let atoms = &self.reading.system.atoms;
        let mut signs = Signs::new();
        for variable in of.variables() {
            let place = match atoms.angle_of(variable) {
                Some(_) => Place::Function,
                None => atoms.atom(variable).place,
            };
            signs.insert(variable, (self.text_of(variable)?, place));
        }
        let sum = match of.is_polynomial() {
            true => Some(of.numerator().clone()),
            false => self.with_quotients(of, &mut signs),
        };
        let length = sum.as_ref().map_or(
            of.numerator().len() + of.denominator().len(),
            Polynomial::len,
        );
        if length > LONGEST {
            return None;
        }
        Some(Text {
            latex: written(sum.as_ref(), of, &signs, Style::Latex),
            unicode: written(sum.as_ref(), of, &signs, Style::Unicode),
        })
    }

    /// A fraction as a sum in which each quotient of properties is a property of its own:
    /// I ω + (m M/(m + M)) b² ω. `None` where more than properties stand below.
    fn with_quotients(&self, of: &Fraction, signs: &mut Signs) -> Option<Polynomial> {
        let below = of.denominator();
        let divisors = below.variables();
        let is_property = |v: &Variable| signs.get(v).is_some_and(|(_, p)| *p == Place::Parameter);
        if !divisors.iter().all(is_property) {
            return None;
        }
        let mut groups: BTreeMap<Monomial, Polynomial> = BTreeMap::new();
        for (monomial, number) in of.numerator().terms() {
            let (inner, outer): (Vec<_>, Vec<_>) = monomial
                .powers()
                .into_iter()
                .partition(|(v, _)| divisors.contains(v));
            let group = groups.entry(Monomial::from_powers(outer));
            let term = Polynomial::term(Monomial::from_powers(inner), number.clone());
            *group.or_insert_with(Polynomial::zero) += term;
        }
        let (mut sum, mut known) = (Polynomial::zero(), vec![]);
        for (outer, above) in groups {
            let quotient = self.reduced(&above, below);
            let mut outer = Polynomial::term(outer, Rational::from((1, 1)));
            let quotient = match quotient.numerator().leading_coefficient().is_negative() {
                true => {
                    outer = -outer;
                    -quotient
                }
                false => quotient,
            };
            if quotient.is_polynomial() {
                sum += quotient.numerator().clone() * outer;
                continue;
            }
            let same = |(q, _): &&(Fraction, Variable)| {
                q.numerator() == quotient.numerator() && q.denominator() == quotient.denominator()
            };
            let variable = match known.iter().find(same) {
                Some((_, variable)) => *variable,
                None => {
                    let first = self.reading.system.atoms.len();
                    let variable = (first + known.len()) as Variable;
                    let text = quotient_text(&quotient, signs);
                    signs.insert(variable, (text, Place::Parameter));
                    known.push((quotient, variable));
                    variable
                }
            };
            sum += Polynomial::variable(variable) * outer;
        }
        Some(sum)
    }

    /// A quotient without the factors that are masses of wholes.
    fn reduced(&self, above: &Polynomial, below: &Polynomial) -> Fraction {
        let (mut above, mut below) = (above.clone(), below.clone());
        let system = &self.reading.system;
        let wholes = (0..system.bodies.len()).filter(|&b| !system.bodies[b].parts.is_empty());
        let mass = |body| {
            let parts = system.wholes(body).into_iter();
            parts.fold(Fraction::zero(), |sum, part| {
                sum + system.bodies[part].mass.clone()
            })
        };
        for mass in wholes.map(mass) {
            let factor = mass.numerator();
            while let (Some(a), Some(b)) =
                (above.exact_quotient(factor), below.exact_quotient(factor))
            {
                (above, below) = (a, b);
            }
        }
        match above.exact_quotient(&below) {
            Some(whole) => Fraction::from(whole),
            None => Fraction::new(above, below).unwrap_or_else(Fraction::zero),
        }
    }
}

/// A quotient as one factor.
fn quotient_text(quotient: &Fraction, signs: &Signs) -> Text {
    let write = |style| {
        let sign = |variable: Variable| sign(signs, style, variable);
        Printer::new(style, &sign).fraction(quotient)
    };
    Text {
        latex: write(Style::Latex),
        unicode: format!("({})", write(Style::Unicode)),
    }
}

fn sign(signs: &Signs, style: Style, variable: Variable) -> Sign {
    let (text, place) = signs
        .get(&variable)
        .cloned()
        .unwrap_or((Text::default(), Place::Parameter));
    Sign {
        text: match style {
            Style::Latex => text.latex,
            Style::Unicode => text.unicode,
        },
        place,
    }
}

/// A sum collected by its rates, or by all that is no property, or with common properties in front.
fn written(sum: Option<&Polynomial>, of: &Fraction, signs: &Signs, style: Style) -> String {
    let sign = |variable: Variable| sign(signs, style, variable);
    let printer = Printer::new(style, &sign);
    let Some(sum) = sum else {
        return printer.fraction(of);
    };
    let place = |v: &Variable| signs.get(v).map(|(_, place)| *place);
    let mut others = sum.variables();
    others.retain(|v| place(v) != Some(Place::Parameter));
    let mut rates = others.clone();
    rates.retain(|v| matches!(place(v), Some(Place::Rate | Place::Acceleration)));
    let by_rates = printer.collected(sum, &rates);
    let by_all = printer.collected(sum, &others);
    let collected = match by_all.len() < by_rates.len() {
        true => by_all,
        false => by_rates,
    };
    let accelerates = others.iter().any(|v| place(v) == Some(Place::Acceleration));
    let (text, groups) = factored(&printer, sum, signs, &rates, style);
    let one = groups == 1 && text.len() <= collected.len() + 2;
    match groups > 0 && (one || !accelerates && text.len() < collected.len()) {
        true => text,
        false => collected,
    }
}

/// A sum with common properties in front, and how many there are.
fn factored(
    printer: &Printer<'_>,
    sum: &Polynomial,
    signs: &Signs,
    rates: &[Variable],
    style: Style,
) -> (String, usize) {
    let groups = by_properties(sum, signs);
    let minus = match style {
        Style::Latex => "-",
        Style::Unicode => "−",
    };
    let mut text = String::new();
    for ((property, number), terms) in &groups {
        let leads_negative = terms.terms().iter().all(|(_, c)| c.is_negative());
        let factor = Polynomial::term(property.clone(), number.clone());
        let (inner, factor) = match leads_negative {
            true => (-terms.clone(), -factor),
            false => (terms.clone(), factor),
        };
        let term = match terms.len() > 1 && property.degree() > 0 {
            true => format!(
                "{} ({})",
                printer.polynomial(&factor),
                printer.collected(&inner, rates)
            ),
            false => printer.polynomial(&(inner * factor)),
        };
        match (text.is_empty(), term.strip_prefix(minus)) {
            (true, _) => text.push_str(&term),
            (false, Some(rest)) => text.push_str(&format!(" {minus} {rest}")),
            (false, None) => text.push_str(&format!(" + {term}")),
        }
    }
    (text, groups.len())
}

/// The terms of a sum by what they have of properties and by the size of their numbers.
fn by_properties(sum: &Polynomial, signs: &Signs) -> Vec<((Monomial, Rational), Polynomial)> {
    let is_property = |v: Variable| signs.get(&v).is_some_and(|(_, p)| *p == Place::Parameter);
    let mut groups: Vec<((Monomial, Rational), Polynomial)> = vec![];
    for (monomial, number) in sum.terms() {
        let (properties, rest): (Vec<_>, Vec<_>) = monomial
            .powers()
            .into_iter()
            .partition(|(v, _)| is_property(*v));
        let key = (Monomial::from_powers(properties), number.abs());
        let sign = Rational::from((if number.is_negative() { -1 } else { 1 }, 1));
        let term = Polynomial::term(Monomial::from_powers(rest), sign);
        match groups.iter_mut().find(|(k, _)| *k == key) {
            Some((_, terms)) => *terms += term,
            None => groups.push((key, term)),
        }
    }
    groups
}
