//! How the variables of a derivation are written.

use crate::algebra::{Letter, Place, Polynomial, Printer, Style, Variable};

/// A formula in both styles.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Formula {
    pub(super) latex: String,
    pub(super) unicode: String,
}

/// A formula of vectors, which no polynomial prints.
pub(super) fn vector(latex: &str, unicode: &str) -> Formula {
    Formula {
        latex: latex.to_owned(),
        unicode: unicode.to_owned(),
    }
}

/// What a variable stands for. The order is that in which factors are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Symbol {
    /// I_xx, I_yy, I_zz, I_xy, I_xz, I_yz.
    Inertia,
    /// Their rates.
    InertiaRate,
    /// L.
    Momentum,
    /// ω.
    Omega,
    /// Ω.
    Frame,
    /// The rate of L.
    MomentumRate,
    /// The rate of ω.
    OmegaRate,
}

const SYMBOLS: [Symbol; 7] = [
    Symbol::Inertia,
    Symbol::InertiaRate,
    Symbol::Momentum,
    Symbol::Omega,
    Symbol::Frame,
    Symbol::MomentumRate,
    Symbol::OmegaRate,
];
/// Variables kept for a symbol: the six numbers of a tensor.
const EACH: u32 = 6;
const TENSOR: [&str; 6] = ["xx", "yy", "zz", "xy", "xz", "yz"];
const AXES: [&str; 6] = ["x", "y", "z", "", "", ""];

impl Symbol {
    /// The variable of a component.
    pub(super) fn variable(self, component: usize) -> Variable {
        let place = SYMBOLS.iter().position(|s| *s == self).unwrap_or(0);
        place as Variable * EACH + component as Variable
    }

    /// The component as a polynomial.
    pub(super) fn of(self, component: usize) -> Polynomial {
        Polynomial::variable(self.variable(component))
    }

    /// The component as a formula.
    pub(super) fn formula(self, component: usize) -> Formula {
        formula(&self.of(component))
    }

    fn letter(self, component: usize, style: Style) -> Letter {
        let (latex, unicode, place) = match self {
            Self::Inertia => ("I", "I", Place::Parameter),
            Self::InertiaRate => ("\\dot{I}", "I\u{307}", Place::Parameter),
            Self::Momentum => ("L", "L", Place::Rate),
            Self::Omega => ("\\omega", "ω", Place::Rate),
            Self::Frame => ("\\Omega", "Ω", Place::Rate),
            Self::MomentumRate => ("\\dot{L}", "L\u{307}", Place::Acceleration),
            Self::OmegaRate => ("\\dot{\\omega}", "ω\u{307}", Place::Acceleration),
        };
        let index = match self {
            Self::Inertia | Self::InertiaRate => TENSOR[component],
            _ => AXES[component],
        };
        let text = match style {
            Style::Latex if index.len() > 1 => format!("{latex}_{{{index}}}"),
            Style::Latex => format!("{latex}_{index}"),
            Style::Unicode => format!("{unicode}_{index}"),
        };
        Letter { text, place }
    }
}

fn letter(variable: Variable, style: Style) -> Letter {
    let place = (variable / EACH) as usize % SYMBOLS.len();
    SYMBOLS[place].letter((variable % EACH) as usize, style)
}

/// The polynomial, multiplied out.
pub(super) fn formula(polynomial: &Polynomial) -> Formula {
    both(|printer| printer.polynomial(polynomial))
}

/// The polynomial, collected by the products of rates with moments of inertia in parentheses.
pub(super) fn collected(polynomial: &Polynomial) -> Formula {
    let rates = [Symbol::Omega, Symbol::Frame, Symbol::OmegaRate];
    let by: Vec<_> = rates
        .iter()
        .flat_map(|s| (0..3).map(|i| s.variable(i)))
        .collect();
    both(|printer| printer.collected(polynomial, &by))
}

fn both(text: impl Fn(&Printer<'_>) -> String) -> Formula {
    let in_style = |style| text(&Printer::new(style, &|v| letter(v, style)));
    Formula {
        latex: in_style(Style::Latex),
        unicode: in_style(Style::Unicode),
    }
}
