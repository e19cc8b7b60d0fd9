//! Axes that words turn in a plane: "the axes ⟨x'⟩, ⟨y'⟩ are turned about ⟨z⟩ by the angle ⟨θ⟩".

use crate::algebra::Fraction;
use crate::notation::ast::{Function, Kind, Node, Symbol};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::theory::{Premise, Taken};
use crate::verify::values::atoms::variable_fraction;
use crate::verify::values::symbol::Meaning;
use crate::verify::words::book::{has_any, lowered};

const TURNING: &[&str] = &["turn", "rotat", "inclined"];
const AXES: &[&str] = &["axes", "axis", "other two", "frame"];
/// What stands right before the angle.
const BY: &[&str] = &[
    " by",
    " by an angle",
    " by the angle",
    " by angle",
    " through",
    " through an angle",
    " through the angle",
    " at an angle",
];
const NAMES: [&str; 3] = ["x", "y", "z"];
/// The name of the premise.
const NAME: &str = "coordinates on the turned axes";

impl Checker<'_> {
    /// Gives the coordinates on axes with primes, which the moments of inertia have as indices, by those on the axes
    /// used: x' = x cos θ + y sin θ.
    pub(crate) fn turns_in_plane(&mut self, angle: &Node) {
        let said = lowered(&self.sentence);
        let said = said.trim_end();
        let Some(lead) = BY.iter().find_map(|words| said.strip_suffix(words)) else {
            return;
        };
        let counter = ["counterclockwise", "anticlockwise", "counter-clockwise"];
        let clockwise = said.contains("clockwise") && !has_any(said, &counter);
        if !has_any(lead, TURNING) || !has_any(lead, AXES) || clockwise {
            return;
        }
        let axis = lead.rsplit_once("about").map_or("", |(_, axis)| axis);
        let mut words = axis.split(|c: char| !c.is_alphabetic());
        let named = words.find_map(|word| NAMES.iter().position(|name| *name == word));
        if let Some(about) = self.across_primed_axes(named) {
            self.turned_coordinates(about, angle);
        }
    }

    /// The axis across those that the indices of the inertia have with primes, where words name it or two have a prime.
    fn across_primed_axes(&self, named: Option<usize>) -> Option<usize> {
        let met = self.reading.usage.subscripts.values().flatten();
        let primed: String = met.filter(|index| index.contains('\'')).cloned().collect();
        let plain = |at: &usize| !primed.contains(&format!("{}'", NAMES[*at]));
        let mut others = (0..3)
            .filter(plain)
            .filter(|at| named.is_none_or(|named| named == *at));
        let across = others.next().filter(|_| !primed.is_empty())?;
        others.next().is_none().then_some(across)
    }

    fn turned_coordinates(&mut self, about: usize, angle: &Node) {
        let Kind::Symbol(_) = &inner(angle).kind else {
            return;
        };
        let [one, two] = [1, 2].map(|next| NAMES[(about + next) % 3]);
        let of_angle = |f: Function| Kind::Function(f, Box::new(angle.clone()));
        let mut lowering = self.lowering(Frame::Moving);
        let mut value = |kind: Kind, span: Span| lowering.scalar(&Node { kind, span });
        let values = [
            coordinate(one, 0),
            coordinate(two, 0),
            of_angle(Function::Cos),
            of_angle(Function::Sin),
        ]
        .map(|kind| value(kind, angle.span));
        let [Some(x), Some(y), Some(cos), Some(sin)] = values else {
            return;
        };
        let turned: [Fraction; 2] = [
            x.clone() * cos.clone() + y.clone() * sin.clone(),
            y * cos - x * sin,
        ];
        for (name, value) in [one, two].into_iter().zip(turned) {
            let Kind::Symbol(symbol) = coordinate(name, 1) else {
                continue;
            };
            let Meaning::Whole(entity) = self.meaning_of(&symbol) else {
                continue;
            };
            if !self.is_free(entity) {
                continue;
            }
            let own = self.theory.atoms.part(entity, 0, 0);
            let taken = self.theory.assume(Premise {
                name: NAME.to_owned(),
                residuals: vec![variable_fraction(own) - value],
                preferred: vec![own],
                definition: true,
            });
            if taken == Taken::Solved {
                self.known.insert(entity);
                self.tell(angle.span, NAME.to_owned());
            }
        }
    }
}

fn coordinate(name: &str, primes: u8) -> Kind {
    Kind::Symbol(Symbol {
        name: name.to_owned(),
        primes,
        ..Symbol::default()
    })
}
