//! Polynomials and fractions as people write them.

use num_traits::Zero;
use polhode::algebra::{Fraction, Letter, Place, Polynomial, Printer, Rational, Style, Variable};

const NAMES: [&str; 4] = ["I_{xx}", "\\omega_x", "\\dot{\\omega}_x", "x^2"];

fn letters(variable: Variable) -> Letter {
    let places = [
        Place::Parameter,
        Place::Rate,
        Place::Acceleration,
        Place::Coordinate,
    ];
    let at = variable as usize % 4;
    Letter {
        text: NAMES[at].to_owned(),
        place: places[at],
    }
}

#[test]
fn accelerations_lead_and_halves_are_small() {
    let [i, w, a, x] = [0, 1, 2, 3].map(Polynomial::variable);
    let half = Polynomial::constant(Rational::from((1, 2)));
    let sum = i.clone() * a - half * i * w.clone() * w - x.clone() * x;
    assert_eq!(
        Printer::new(Style::Latex, &letters).polynomial(&sum),
        "I_{xx} \\dot{\\omega}_x - \\tfrac{1}{2} I_{xx} \\omega_x^{2} - (x^2)^{2}"
    );
}

#[test]
fn functions_stand_last_and_carry_their_exponents() {
    let letters = |variable: Variable| match variable {
        0 => Letter {
            text: "\\sin \\theta".to_owned(),
            place: Place::Function,
        },
        _ => Letter {
            text: "\\dot{\\psi}".to_owned(),
            place: Place::Rate,
        },
    };
    let [sine, rate] = [0, 1].map(Polynomial::variable);
    let product = sine.clone() * sine * rate;
    assert_eq!(
        Printer::new(Style::Latex, &letters).polynomial(&product),
        "\\dot{\\psi} \\sin^{2} \\theta"
    );
}

#[test]
fn nothing_is_zero_and_a_denominator_is_seen() {
    let printer = Printer::new(Style::Unicode, &letters);
    assert_eq!(printer.polynomial(&Polynomial::zero()), "0");
    let [i, w] = [0, 1].map(|v| Fraction::from(Polynomial::variable(v)));
    assert_eq!(
        printer.fraction(&((i.clone() + w) / i)),
        "(\\omega_x + I_{xx})/I_{xx}"
    );
}
