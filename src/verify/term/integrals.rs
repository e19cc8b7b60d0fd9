//! Integrals over a body: sums over its elements of what is integrated, times the mass or the volume of each.

use crate::notation::ast::{Kind, Node};
use crate::verify::model::system::{ELEMENT, FamilyId};
use crate::verify::term::labels::without_commands;
use crate::verify::term::letters::{Meaning, loosely, spelled};
use crate::verify::term::lower::Lowering;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{Value, Valued, beyond};

const OTHER_INTEGRAL: &str = "this integral";

/// What an integral takes of each element.
#[derive(Clone, Copy, PartialEq)]
enum Measure {
    Mass,
    Volume,
}

impl Lowering<'_> {
    pub(super) fn integral(&mut self, node: &Node) -> Valued {
        let Kind::Integral {
            integrand,
            variable,
            limits: None,
        } = &node.kind
        else {
            return beyond(OTHER_INTEGRAL);
        };
        let Some((family, measure)) = self.measured_by(variable) else {
            return beyond(OTHER_INTEGRAL);
        };
        let whole = self.system.is_rigid_whole(family) && self.is_over_all_of(node, family);
        if has_integral(integrand) || !whole {
            return beyond(OTHER_INTEGRAL);
        }
        let value = self.value(integrand)?;
        let Some(index) = self.system.index_met(family, &value.entries) else {
            return beyond(OTHER_INTEGRAL);
        };
        let amount = match measure {
            Measure::Mass => self.system.member_mass(family, &index),
            Measure::Volume => self.system.member_volume(family, &index),
        };
        let custom = self.custom();
        let term = self.system.times(&Value::scalar(amount), &value, custom)?;
        self.summed(&term, &index)
    }

    /// The family whose members a differential is of, and what of them it is: by its own name, or `dm` and `dV` of the
    /// elements of a body.
    fn measured_by(&self, variable: &Node) -> Option<(FamilyId, Measure)> {
        let Kind::Symbol(symbol) = &variable.kind else {
            return None;
        };
        let name = symbol.name.as_str();
        let label = format!("d{name}");
        let families = &self.system.families;
        let named = |own: &String| *own == label || own == name;
        let own = families.iter().position(|f| f.indices.iter().any(named));
        let plain = !symbol.style.vector && symbol.subscripts.is_empty() && symbol.primes == 0;
        let element = || families.iter().position(|f| f.name == ELEMENT);
        match name {
            "V" if plain && self.tells_density() => Some((own.or_else(element)?, Measure::Volume)),
            "m" if plain => Some((own.or_else(element)?, Measure::Mass)),
            _ => Some((own?, Measure::Mass)),
        }
    }

    fn tells_density(&self) -> bool {
        let mut letters = self.letters.letters.iter();
        letters.any(|l| matches!(&l.meaning, Meaning::Quantity(Quantity::Density(..))))
    }

    /// Whether the range below an integral names no other body or frame than the one whose elements it sums over.
    fn is_over_all_of(&self, node: &Node, family: FamilyId) -> bool {
        let written = self.source.slice(node.span);
        let below = written
            .split_once('_')
            .map(|(sign, rest)| (sign.trim(), rest));
        let Some((_, rest)) = below.filter(|(sign, _)| is_sign(sign)) else {
            return true;
        };
        let range = first_group(rest);
        let body = self.system.families[family].body;
        let frame = body.and_then(|body| self.system.bodies[body].frame);
        let bodies = self.system.bodies.iter().enumerate();
        let mut bodies = bodies.filter(|(id, _)| Some(*id) != body);
        let frames = self.system.frames.iter().enumerate();
        let mut frames = frames.filter(|(id, _)| Some(*id) != frame);
        bodies.all(|(_, body)| body.name != range) && frames.all(|(_, frame)| frame.name != range)
    }

    /// `\rho(\mathbf r)`: the density at a place.
    pub(super) fn is_density_at(&self, head: &Node, arguments: &[Node]) -> bool {
        let letter = self
            .letters
            .find(&spelled(head), &loosely(head), self.at, 0);
        let density =
            letter.is_some_and(|l| matches!(&l.meaning, Meaning::Quantity(Quantity::Density(..))));
        let symbols = arguments.iter().all(|a| matches!(a.kind, Kind::Symbol(_)));
        let place = match arguments {
            [
                Node {
                    kind: Kind::Symbol(place),
                    ..
                },
            ] => place.style.vector && arguments.iter().all(|a| self.is_position(a)),
            _ => symbols && arguments.len() > 1,
        };
        density && place
    }

    /// Whether a letter is told to be the position of something.
    fn is_position(&self, letter: &Node) -> bool {
        let (exact, loose) = (spelled(letter), loosely(letter));
        let told = self.letters.find(&exact, &loose, self.at, 0);
        told.is_some_and(|told| match &told.meaning {
            Meaning::Quantity(Quantity::On(of, _)) => matches!(**of, Quantity::Position { .. }),
            Meaning::Quantity(of) => matches!(of, Quantity::Position { .. }),
            _ => false,
        })
    }
}

/// The sign of an integral, with what may stand before its range.
fn is_sign(written: &str) -> bool {
    let sign = written
        .trim_end_matches("\\limits")
        .trim_end_matches("\\nolimits");
    matches!(
        sign.trim(),
        "\\int" | "\\iint" | "\\iiint" | "\\oint" | "∫" | "∭"
    )
}

/// The letters of what stands in the first braces, or of the first sign where there are none.
fn first_group(text: &str) -> String {
    let text = text.trim_start();
    let group = match text.strip_prefix('{') {
        Some(inside) => {
            let mut depth = 1;
            let end = inside.find(|c| {
                depth += i32::from(c == '{') - i32::from(c == '}');
                depth == 0
            });
            &inside[..end.unwrap_or(inside.len())]
        }
        None => &text[..text.chars().next().map_or(0, char::len_utf8)],
    };
    let plain = without_commands(group);
    plain.chars().filter(|c| c.is_alphanumeric()).collect()
}

/// Whether an integral stands in a formula.
pub(crate) fn has_integral(node: &Node) -> bool {
    matches!(node.kind, Kind::Integral { .. }) || node.children().any(has_integral)
}
