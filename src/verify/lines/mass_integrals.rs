//! Moments and products of inertia by their integrals: `I_xx = ∫(y² + z²) dm` is a definition, and with another
//! integrand it is none.

use crate::algebra::{Polynomial, Variable};
use crate::notation::ast::{Kind, Node, Number, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{inner, symbols};
use crate::verify::values::atoms::{Owner, variable_fraction};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::symbol::Meaning;
use crate::verify::verdict::{Finding, Role, Verdict};
use num_rational::BigRational;
use num_traits::{One, Zero};

/// Rows and columns of the components of a symmetric tensor.
const PLACES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// How far an integral is another one than the moment of inertia has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Another {
    None,
    /// The square of the axis's own coordinate: some call that its moment.
    Square,
    Sum,
}

impl Checker<'_> {
    /// Claims a moment of inertia that stands beside the integral of something else, whatever the words make of it.
    pub(crate) fn slips_in_integral(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let another = self.another_integral(sides);
        if another == Another::None {
            return false;
        }
        self.now_known(&sides[1..]);
        finding.role = Role::Claim;
        if another == Another::Sum {
            self.claim(sides, finding);
        }
        if finding.verdict == Verdict::Accepted || another == Another::Square {
            finding.verdict = Verdict::Undecided;
            finding.reason = Some("this moment of inertia has another integral".to_owned());
        }
        true
    }

    pub(crate) fn integrates_another(&mut self, sides: &[Node]) -> bool {
        self.another_integral(sides) != Another::None
    }

    /// The integral over the mass in x, y and z that stands beside a moment or product of inertia and is not its own,
    /// not even of a body in a plane or on a line.
    fn another_integral(&mut self, sides: &[Node]) -> Another {
        let [first, rest @ ..] = sides else {
            return Another::None;
        };
        let Kind::Symbol(symbol) = &inner(first).kind else {
            return Another::None;
        };
        let Meaning::Component(entity, component) = self.meaning_of(symbol) else {
            return Another::None;
        };
        let info = self.theory.atoms.info(entity);
        let inertia = matches!(info.owner, Owner::Quantity(Quantity::Inertia, _));
        let place = PLACES.get(usize::from(component));
        let place = place.filter(|_| inertia && info.shape == Shape::Symmetric);
        let Some(&place) = place.filter(|_| symbol.primes == 0) else {
            return Another::None;
        };
        let found = rest.iter().map(|side| self.other_than(side, place));
        found.max().unwrap_or(Another::None)
    }

    fn other_than(&mut self, side: &Node, place: (usize, usize)) -> Another {
        let Some((found, coordinates)) = self.integrand(side) else {
            return Another::None;
        };
        let square = |i: usize| {
            let part = Polynomial::variable(coordinates[i]);
            part.clone() * part
        };
        let own = match place {
            (0, 0) => square(1) + square(2),
            (1, 1) => square(0) + square(2),
            (2, 2) => square(0) + square(1),
            (a, b) => Polynomial::variable(coordinates[a]) * Polynomial::variable(coordinates[b]),
        };
        // What does not stand there may be zero all over the body.
        let met = found.variables();
        let away: Vec<Variable> = coordinates
            .into_iter()
            .filter(|v| !met.contains(v))
            .collect();
        let is_own = (0..1 << away.len()).any(|zeros: usize| {
            let zeros = (0..away.len()).filter(|i| zeros >> i & 1 == 1);
            let own = zeros.fold(own.clone(), |left, i| {
                left.substitute(away[i], &Polynomial::zero())
            });
            let turned = place.0 != place.1 && found == -own.clone();
            !own.is_zero() && (found == own || turned)
        });
        match is_own {
            true => Another::None,
            false if place.0 == place.1 && found == square(place.0) => Another::Square,
            false => Another::Sum,
        }
    }

    /// What is integrated over the mass in a side, in the coordinates alone.
    fn integrand(&mut self, side: &Node) -> Option<(Polynomial, [Variable; 3])> {
        let mut integrand = side.clone();
        if !bare_of_integrals(&mut integrand) && !bare_of_masses(&mut integrand) {
            return None;
        }
        let mut lowering = self.lowering(Frame::Moving);
        let (value, coordinates) = lowering.in_coordinates(&integrand, side).ok()?;
        let coordinates: [Variable; 3] = coordinates.try_into().ok()?;
        let free = |v: Variable| self.theory.normal(&variable_fraction(v)).as_variable() == Some(v);
        if !coordinates.into_iter().all(free) {
            return None;
        }
        let found = value.as_scalar().filter(|found| found.is_polynomial())?;
        let found = found.numerator().clone();
        let only = found.variables().iter().all(|v| coordinates.contains(v));
        only.then_some((found, coordinates))
    }
}

/// Puts the integrand in the place of each integral over the mass; whether there is any.
fn bare_of_integrals(node: &mut Node) -> bool {
    let bare = match &node.kind {
        Kind::Integral {
            integrand,
            variable,
            limits: None,
        } if matches!(&variable.kind, Kind::Symbol(s) if s.name == "m") => {
            Some((**integrand).clone())
        }
        _ => None,
    };
    match bare {
        Some(integrand) => {
            *node = integrand;
            true
        }
        None => node
            .children_mut()
            .into_iter()
            .fold(false, |any, child| bare_of_integrals(child) | any),
    }
}

/// Puts what is summed in the place of each sum over the masses, `\sum m_i (y_i^2 + z_i^2)`, and one for the mass; whether
/// there is any.
fn bare_of_masses(node: &mut Node) -> bool {
    let mut indices = vec![];
    take_sums_away(node, &mut indices);
    if indices.is_empty() {
        return false;
    }
    node.change_symbols(&mut |symbol| symbol.subscripts.retain(|s| !indices.contains(s)));
    true
}

/// Notes the index of each sum over the masses; an empty one where they have none.
fn take_sums_away(node: &mut Node, indices: &mut Vec<String>) {
    if let Kind::IndexedSum { index, body, .. } = &node.kind {
        let index = index.name.clone();
        let mass = |s: &&Symbol| s.name == "m" && s.subscripts == [index.as_str()];
        if symbols(body).iter().any(mass) {
            let mut body = (**body).clone();
            put_one_for_mass(&mut body, &|s| s.subscripts == [index.as_str()]);
            *node = body;
            indices.push(index);
        }
        return;
    }
    let mut met = vec![];
    let resultant = |s: &Symbol| s.resultant;
    for symbol in symbols(node) {
        if symbol.name == "m" && resultant(symbol) {
            met.push(symbol.subscripts.first().cloned().unwrap_or_default());
        }
    }
    if met.is_empty() {
        node.children_mut()
            .into_iter()
            .for_each(|child| take_sums_away(child, indices));
    } else {
        put_one_for_mass(node, &resultant);
        indices.extend(met);
    }
}

fn put_one_for_mass(node: &mut Node, is_mass: &dyn Fn(&Symbol) -> bool) {
    if matches!(&node.kind, Kind::Symbol(s) if s.name == "m" && is_mass(s)) {
        node.kind = Kind::Number(Number {
            value: BigRational::one(),
            decimals: None,
            exponent: 0,
        });
        return;
    }
    node.children_mut()
        .into_iter()
        .for_each(|child| put_one_for_mass(child, is_mass));
}
