//! Letters of vectors that are numbers in one line: the bare ω of `\omega = \dot\theta` beside a vector **ω**.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, axes, axis, inner, symbols};
use crate::verify::lines::functions::gives_a_rate_by_name;
use crate::verify::values::lower::TroubleKind;
use crate::verify::values::quantity::Shape;
use std::collections::BTreeSet;

impl Checker<'_> {
    /// A line that is ill-typed with every vector's letter a vector may make sense with the bare ones as numbers.
    pub(crate) fn note_scalars(&mut self, sides: &[Node]) {
        let column = |head: &Node| matches!(&inner(head).kind, Kind::Symbol(s) if self.reading.usage.is_vector(&Letter::of(s)));
        let function =
            |side: &Node| matches!(&inner(side).kind, Kind::Call(head, _) if column(head));
        let names = gives_a_rate_by_name(sides) || sides.first().is_some_and(function);
        if names || self.given_scalars(sides) {
            return;
        }
        // A symbol that is defined here takes any shape, unless it shows one.
        let marked = |side: &Node| matches!(&inner(side).kind, Kind::Symbol(s) if s.style.vector);
        let shown = sides.first().is_some_and(marked);
        // `J(ω) = ∂f/∂ω` gives a function its name.
        let slope = matches!(
            sides.get(1).map(|side| &side.kind),
            Some(Kind::Derivative { .. })
        );
        let named = |side: &Node| match &side.kind {
            Kind::Call(head, _) if slope => (**head).clone(),
            _ => side.clone(),
        };
        let new = sides.first().map(named);
        let new = new.and_then(|side| self.new_symbol(&side));
        let defines = new.is_some_and(|(_, place)| place.is_none()) && !shown;
        let sides = if defines { &sides[1..] } else { sides };
        let index = |s: &String| axis(s).is_some() || axes(s).is_some();
        let bare = |s: &&Symbol| !s.style.vector && !s.subscripts.iter().any(index);
        let bare: BTreeSet<Letter> = sides
            .iter()
            .flat_map(symbols)
            .filter(bare)
            .map(Letter::of)
            .collect();
        let several = |letter: &Letter| {
            let quantity = self.reading.quantities.get(letter);
            quantity.is_some_and(|q| q.shape() != Shape::Scalar)
                || self.reading.usage.is_vector(letter)
        };
        if !bare.iter().any(several) {
            return;
        }
        let tried = self.read(sides, Frame::Moving);
        let ill_typed = tried.is_err_and(|trouble| trouble.kind == TroubleKind::IllTyped);
        let numbers = ill_typed || defines && self.is_made_of_numbers(&sides[0], &bare);
        if !numbers {
            return;
        }
        self.reading.scalars = bare;
        if self.read(sides, Frame::Moving).is_err() {
            self.reading.scalars.clear();
        }
    }
}
