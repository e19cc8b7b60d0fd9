//! Integrals over the mass of the body: the moments and products of inertia behind their definitions.

use crate::algebra::{Fraction, Polynomial, Rational};
use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::letters::particles::place_among;
use crate::verify::letters::usage::{Letter, symbols};
use crate::verify::reason;
use crate::verify::theory::law::inertia;
use crate::verify::values::atoms::{Owner, variable_fraction};
use crate::verify::values::lower::{Lowered, Lowering, TroubleKind, constant, trouble};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::value::Value;
use num_traits::Zero;

/// Labels of what belongs to the body as a whole: the velocity of its mass centre or of a point that is held.
const FIXED_POINTS: [&str; 7] = ["G", "C", "S", "O", "cm", "CM", "0"];

impl Lowering<'_> {
    /// ∫ f dm for f quadratic in the coordinates x, y, z of the body.
    pub(crate) fn integral(&mut self, node: &Node, integrand: &Node, variable: &Node) -> Lowered {
        let unsupported = |message: &str| trouble(TroubleKind::Unsupported, node.span, message);
        let over = match &variable.kind {
            Kind::Symbol(symbol) => symbol.name.clone(),
            _ => return Err(unsupported(reason::INTEGRAL)),
        };
        if !matches!(over.as_str(), "m" | "V") {
            return Err(unsupported(reason::INTEGRAL));
        }
        let mut integrand = integrand.clone();
        plain_density(&mut integrand);
        let (mut value, coordinates) = self.in_coordinates(&integrand, node)?;
        if over == "V" {
            let density = self.letter("rho", None, node)?;
            value = value.map(|entry| entry.clone() / variable_fraction(density));
        }
        // Coordinates on turned axes are put in by what the document says of them.
        let entries = value.entries.iter().map(|entry| {
            let known = self.moment_of(entry, &coordinates);
            known.or_else(|| {
                let normal = self.theory.normal(entry);
                self.moment_of(&normal, &coordinates)
            })
        });
        let entries: Option<Vec<Fraction>> = entries.collect();
        let entries = entries.ok_or_else(|| unsupported(reason::INTEGRAL))?;
        let columns = value.columns;
        Ok(Value::from_fn(value.rows, columns, |r, c| {
            entries[r * columns + c].clone()
        }))
    }

    /// Σ m f over the particles of the body is ∫ f dm.
    pub(crate) fn over_particles(&mut self, node: &Node, index: &Symbol, body: &Node) -> Lowered {
        let mut plain = body.clone();
        plain.change_symbols(&mut |symbol| symbol.subscripts.retain(|s| *s != index.name));
        let load = |symbol: &Symbol| {
            let quantity = self.reading.quantities.get(&Letter::of(symbol));
            matches!(quantity, Some(Quantity::Moment | Quantity::Force))
        };
        if matches!(&plain.kind, Kind::Symbol(symbol) if load(symbol)) {
            return self.value(&plain);
        }
        let Some((variable, integrand)) = per_mass(&plain) else {
            let message = "a sum over an index is not expanded";
            return Err(trouble(TroubleKind::Unsupported, node.span, message));
        };
        let value = self.integral(node, &integrand, &variable);
        match value {
            Err(open) if open.kind == TroubleKind::Unsupported => {
                let own = per_mass(body).map(|(_, integrand)| integrand);
                own.and_then(|own| self.by_own_places(index, &own))
                    .ok_or(open)
            }
            value => value,
        }
    }

    /// ∫ f dm with the places `\vec r_i` of the particles as they are written, and their velocities put in.
    fn by_own_places(&mut self, index: &Symbol, integrand: &Node) -> Option<Value> {
        let symbol = match place_among(&symbols(integrand), &index.name) {
            Some(place) => place.clone(),
            None => {
                let mut symbol = Symbol {
                    name: "r".to_owned(),
                    subscripts: vec![index.name.clone()],
                    ..Symbol::default()
                };
                symbol.style.vector = true;
                symbol
            }
        };
        let place = self.value(&Node {
            kind: Kind::Symbol(symbol),
            span: integrand.span,
        });
        let place = place.ok().filter(Value::is_vector)?;
        let coordinates: Option<Vec<u32>> =
            place.entries.iter().map(Fraction::as_variable).collect();
        let (coordinates, value) = (coordinates?, self.value(integrand).ok()?);
        let mut entries = vec![];
        for entry in &value.entries {
            let normal = self.theory.normal(entry);
            entries.push(self.moment_of(&normal, &coordinates)?);
        }
        let columns = value.columns;
        Some(Value::from_fn(value.rows, columns, |r, c| {
            entries[r * columns + c].clone()
        }))
    }

    /// The integral of a polynomial of the second degree in the coordinates, in terms of the inertia tensor. Measured from
    /// the mass centre, what is linear in them adds up to nothing.
    pub(crate) fn moment_of(&mut self, entry: &Fraction, coordinates: &[u32]) -> Option<Fraction> {
        let second = self.second_moments();
        let mut rest: Polynomial = entry.numerator().clone();
        let below = Fraction::from(entry.denominator().clone());
        if entry
            .denominator()
            .variables()
            .iter()
            .any(|v| coordinates.contains(v))
        {
            return None;
        }
        let mut sum = Fraction::zero();
        for a in 0..3 {
            for b in a..3 {
                let (u, v) = (coordinates[a], coordinates[b]);
                let part = if a == b {
                    rest.coefficient_of(u, 2)
                } else {
                    rest.coefficient_of(u, 1).coefficient_of(v, 1)
                };
                if part.variables().iter().any(|v| coordinates.contains(v)) {
                    return None;
                }
                let (x, y) = (Polynomial::variable(u), Polynomial::variable(v));
                rest -= part.clone() * x * y;
                sum += Fraction::from(part) * second[a][b].clone();
            }
        }
        // What does not change over the body has the whole mass as its factor.
        let fixed = coordinates
            .iter()
            .fold(rest.clone(), |rest, &u| rest.coefficient_of(u, 0));
        if !fixed.is_zero() && self.is_of_whole_body(&fixed) {
            let mass = self.theory.atoms.quantity(Quantity::Mass);
            let mass = variable_fraction(self.theory.atoms.part(mass, 0, 0));
            rest -= fixed.clone();
            sum += Fraction::from(fixed) * mass;
        }
        if self.reading.measures_from_centre {
            for &u in coordinates {
                let part = rest.coefficient_of(u, 1);
                if self.is_of_whole_body(&part) {
                    rest -= part * Polynomial::variable(u);
                }
            }
        }
        rest.is_zero().then(|| sum / below)
    }

    /// Whether a factor is the same all over the body: no place or velocity of a particle is in it.
    fn is_of_whole_body(&self, factor: &Polynomial) -> bool {
        use Quantity::{Acceleration, Force, Position, Velocity};
        let variables = factor.variables();
        let all = variables
            .iter()
            .flat_map(|&v| self.theory.atoms.with_arguments(v));
        let mut owners = all.map(|v| self.theory.atoms.owner(v));
        owners.all(|owner| match owner {
            Some(Owner::Quantity(Position | Velocity | Acceleration | Force, label)) => {
                FIXED_POINTS.contains(&label.as_str())
            }
            Some(Owner::Quantity(..)) => true,
            // A letter of the document may be a distance, which each particle has its own of.
            Some(Owner::Symbol(key)) => key.split(' ').any(|part| FIXED_POINTS.contains(&part)),
            None => false,
        })
    }

    /// ∫ x_a x_b dm from the tensor: J = ½ tr(I) 1 − I, with I the tensor of the equations.
    pub(crate) fn second_moments(&mut self) -> [[Fraction; 3]; 3] {
        let tensor = inertia(&mut self.theory.atoms, self.theory.setting.products);
        let half = constant(Rational::from(1)) / constant(Rational::from(2));
        let trace = tensor[(0, 0)].clone() + tensor[(1, 1)].clone() + tensor[(2, 2)].clone();
        std::array::from_fn(|a| {
            std::array::from_fn(|b| {
                let diagonal = if a == b {
                    half.clone() * trace.clone()
                } else {
                    Fraction::zero()
                };
                diagonal - tensor[(a, b)].clone()
            })
        })
    }
}

/// The density ρ(r) as a symbol.
fn plain_density(node: &mut Node) {
    if let Kind::Call(head, _) = &node.kind
        && matches!(&head.kind, Kind::Symbol(symbol) if symbol.name == "rho")
    {
        node.kind = head.kind.clone();
    }
    node.children_mut().into_iter().for_each(plain_density);
}

/// The mass of a particle and what it is multiplied by: `m_i f_i`, `m_i (f_i)`.
fn per_mass(body: &Node) -> Option<(Node, Node)> {
    let mass =
        |node: &Node| matches!(&node.kind, Kind::Symbol(s) if s.name == "m" && !s.style.vector);
    match &body.kind {
        Kind::Product(factors) if factors.len() > 1 => {
            let at = factors.iter().position(|factor| mass(&factor.node))?;
            let mut rest = factors.clone();
            let removed = rest.remove(at);
            // The sign before the mass, in `r × m v`, is that before what follows it.
            if let Some(next) = rest.get_mut(at).filter(|_| at > 0) {
                (next.operator, next.sign) = (removed.operator, removed.sign);
            }
            let variable = removed.node;
            let kind = Kind::Product(rest);
            Some((
                variable,
                Node {
                    kind,
                    span: body.span,
                },
            ))
        }
        Kind::Call(head, arguments) if mass(head) => match arguments.as_slice() {
            [argument] => Some(((**head).clone(), argument.clone())),
            _ => None,
        },
        _ => None,
    }
}
