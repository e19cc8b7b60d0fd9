//! Variables in LaTeX, as the document writes them.

use crate::algebra::{Fraction, Polynomial, Variable};
use crate::notation::ast::Function;
use crate::verify::values::atoms::{Atom, Atoms, Entity, EntityInfo, Owner};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::spatial::ON_SPACE_AXES;
use num_traits::One;

/// Every variable in LaTeX, by its number.
pub(super) fn all(atoms: &Atoms) -> Vec<String> {
    let count = atoms.count() as Variable;
    (0..count).map(|variable| latex(atoms, variable)).collect()
}

/// What a variable is at one instant: a symbol of its own that does not move, such as `\omega_x(0)`.
pub(super) fn at_instant(atoms: &mut Atoms, variable: Variable, instant: &str) -> Entity {
    let moving = latex(atoms, variable);
    let owner = Owner::Symbol(format!("{moving} at {instant}"));
    atoms.entity(&owner, Shape::Scalar, true, &format!("{moving}({instant})"))
}

/// A variable in LaTeX.
pub(super) fn latex(atoms: &Atoms, variable: Variable) -> String {
    match atoms.atom(variable) {
        Atom::Part {
            entity,
            component,
            order,
        } => {
            if let Some(text) = atoms.spelling(*entity, *component) {
                return dotted(text, *order);
            }
            let info = atoms.info(*entity);
            let index = index(info.shape, &info.owner, *component, atoms.numbered);
            let letter = dotted(&on_axes(atoms, info), *order);
            if index.is_empty() {
                letter
            } else {
                subscripted(&letter, &index)
            }
        }
        Atom::Kernel { function, argument } => {
            let inner = fraction(atoms, argument);
            match function {
                Function::Sin => format!("\\sin({inner})"),
                Function::Cos => format!("\\cos({inner})"),
                Function::Exp => format!("e^{{{inner}}}"),
                Function::Ln => format!("\\ln({inner})"),
                _ => format!("\\sqrt{{{inner}}}"),
            }
        }
        Atom::SpaceRate { of, component } => {
            let index = ["x", "y", "z"][usize::from(*component) % 3];
            let inner = fraction(atoms, &of[usize::from(*component) % 3]);
            let letter = inner.split('_').next().unwrap_or(&inner);
            format!("(\\dot{{{letter}}})_{{XYZ,{index}}}")
        }
        Atom::Opaque { latex } => latex.clone(),
    }
}

/// The letter of an entity, with the label of the axes that it stands on where the document writes one.
fn on_axes(atoms: &Atoms, info: &EntityInfo) -> String {
    if let (Some(letters), Owner::Quantity(Quantity::Inertia, _)) =
        (&atoms.inertia_letters, &info.owner)
    {
        let on_body = atoms.body_label.is_some() && info.in_body.is_none();
        return letters[usize::from(on_body)].clone();
    }
    match (&atoms.body_label, &info.owner) {
        (Some(_), _) if info.in_body.is_some() => info.latex.replace("^s", ""),
        (Some(_), Owner::Quantity(Quantity::Attitude | Quantity::Quaternion, _)) => {
            info.latex.clone()
        }
        (Some(label), _) if matches!(info.shape, Shape::Vector | Shape::Symmetric) => {
            format!("{}_{{{label}}}", info.latex)
        }
        _ => info.latex.clone(),
    }
}

/// The name of a function that kernels stand for.
pub(super) fn function(function: Function) -> &'static str {
    match function {
        Function::Sin => "sin",
        Function::Cos => "cos",
        Function::Exp => "exp",
        Function::Ln => "ln",
        _ => "sqrt",
    }
}

/// A letter with dots: `\dot L_x`, `\dot\omega_x`, `\dot{\mathcal{L}}`, `\delta \dot\omega_x`.
fn dotted(letter: &str, order: u8) -> String {
    if let Some(varied) = letter.strip_prefix("\\delta ") {
        return format!("\\delta {}", dotted(varied, order));
    }
    let mark = match order {
        0 => return letter.to_owned(),
        1 => "\\dot",
        2 => "\\ddot",
        n => return format!("{letter}^{{({n})}}"),
    };
    let (head, rest) = letter.split_at(letter.find('_').unwrap_or(letter.len()));
    match head.strip_prefix('\\') {
        Some(command) if command.chars().all(char::is_alphanumeric) => {
            format!("{mark}{head}{rest}")
        }
        None if head.chars().count() == 1 => format!("{mark} {head}{rest}"),
        _ => format!("{mark}{{{head}}}{rest}"),
    }
}

/// A letter with one more index: `v_{O}` and `x` make `v_{O,x}`.
fn subscripted(letter: &str, index: &str) -> String {
    match letter.strip_suffix('}') {
        Some(open) if open.contains("_{") => format!("{open},{index}}}"),
        _ if index.chars().count() == 1 => format!("{letter}_{index}"),
        _ => format!("{letter}_{{{index}}}"),
    }
}

fn index(shape: Shape, owner: &Owner, component: u8, numbered: bool) -> String {
    let family = if numbered {
        ["1", "2", "3"]
    } else {
        ["x", "y", "z"]
    };
    let axis = |i: u8| family[usize::from(i) % 3];
    let of = |text: String| match owner {
        Owner::Quantity(_, variant) => match variant.strip_suffix(ON_SPACE_AXES).unwrap_or(variant)
        {
            "" => text,
            variant => format!("{variant},{text}"),
        },
        Owner::Symbol(_) => text,
    };
    match shape {
        Shape::Scalar => match owner {
            Owner::Quantity(_, variant) => variant.clone(),
            Owner::Symbol(_) => String::new(),
        },
        Shape::Vector => of(axis(component).to_owned()),
        Shape::Symmetric => {
            let (row, column) =
                [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)][usize::from(component) % 6];
            of(format!("{}{}", axis(row), axis(column)))
        }
        Shape::Matrix => format!("{}{}", axis(component / 3), axis(component)),
        Shape::Grid(_, 1) => of(component.to_string()),
        Shape::Grid(_, columns) => {
            format!("{}{}", component / columns + 1, component % columns + 1)
        }
    }
}

/// A polynomial in LaTeX: moments and their like first in each term.
pub(super) fn polynomial(atoms: &Atoms, polynomial: &Polynomial) -> String {
    if polynomial.is_empty() {
        return "0".to_owned();
    }
    let mut text = String::new();
    for (monomial, coefficient) in polynomial.terms() {
        let (negative, size) = (coefficient.is_negative(), coefficient.abs());
        match (text.is_empty(), negative) {
            (true, true) => text.push('-'),
            (true, false) => {}
            (false, true) => text.push_str(" - "),
            (false, false) => text.push_str(" + "),
        }
        let mut powers = monomial.powers();
        powers.sort_by_key(|&(v, _)| (rank(atoms, v), v));
        if !size.is_one() || powers.is_empty() {
            match size.to_string().split_once('/') {
                Some((n, d)) => text.push_str(&format!("\\tfrac{{{n}}}{{{d}}} ")),
                None => text.push_str(&format!("{size} ")),
            }
        }
        let factors: Vec<String> = powers
            .iter()
            .map(|&(v, e)| match (latex(atoms, v), e) {
                (name, 1) => name,
                (name, e) if e < 10 => format!("{name}^{e}"),
                (name, e) => format!("{name}^{{{e}}}"),
            })
            .collect();
        text.push_str(&factors.join(" "));
    }
    text.trim_end().to_owned()
}

/// A fraction in LaTeX.
pub(super) fn fraction(atoms: &Atoms, fraction: &Fraction) -> String {
    let top = polynomial(atoms, fraction.numerator());
    if fraction.is_polynomial() {
        top
    } else {
        format!(
            "\\frac{{{top}}}{{{}}}",
            polynomial(atoms, fraction.denominator())
        )
    }
}

/// Where a factor stands in a term: masses and moments, then symbols, then motions.
fn rank(atoms: &Atoms, variable: Variable) -> u8 {
    match atoms.atom(variable) {
        Atom::Part { entity, order, .. } => match atoms.info(*entity).owner {
            Owner::Quantity(Quantity::Mass, _) => 0,
            Owner::Quantity(Quantity::Inertia, _) => 1,
            Owner::Symbol(_) => 2,
            Owner::Quantity(..) if *order > 0 => 3,
            Owner::Quantity(..) => 4,
        },
        _ => 5,
    }
}
