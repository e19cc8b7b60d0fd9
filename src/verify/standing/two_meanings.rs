//! Letters that may mean two things: a number and the axis of that name.

use crate::verify::language::messages::OPEN_MEANING;
use crate::verify::standing::chains::Link;
use crate::verify::standing::hold::Held;
use crate::verify::standing::judge::Judge;
use crate::verify::standing::verdicts::Standing;
use crate::verify::standing::written::{stands_with_rate, symbols_of};
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use std::collections::BTreeSet;

/// Letters with two meanings are taken in either at no more places of a link.
const MOST_DOUBLED: usize = 6;

/// A writing, and which of its occurrences.
type Place = (String, usize);

impl Judge<'_> {
    /// Where letters mean two things, that is meant with which the types fit, if it is one.
    pub(super) fn hold_by_types(&mut self, link: &Link<'_>) -> Held {
        let doubled = self.doubled(link);
        let choices = (1..1usize << doubled.len().min(MOST_DOUBLED)).map(|choice| {
            let chosen = doubled.iter().enumerate();
            let chosen = chosen.filter(|(at, _)| choice >> at & 1 == 1);
            chosen.map(|(_, place)| place.clone()).collect()
        });
        let choices: Vec<BTreeSet<Place>> = choices.collect();
        let fitting = choices.into_iter().filter_map(|choice| {
            let sides = self.sides(link, &choice);
            sides.is_ok().then_some((choice, sides))
        });
        let fitting: Vec<_> = fitting.take(2).collect();
        let Ok([(choice, sides)]) = <[_; 1]>::try_from(fitting) else {
            return Held::open(OPEN_MEANING);
        };
        let held = self.hold_sides(link, sides);
        match held.standing {
            Standing::Denied if self.may_be_no_axis(&choice) => Held::open(OPEN_MEANING),
            _ => held,
        }
    }

    /// A letter of which nothing is told but that an axis has its name may be that of a number or of another vector as well.
    fn may_be_no_axis(&self, choice: &BTreeSet<Place>) -> bool {
        let named = &self.reading.letters.customs.named_only;
        choice.iter().any(|(writing, _)| named.contains(writing))
    }

    /// Letters of which nothing is told are the axes of their names where a line follows by that. Where it does not, they
    /// may be something else; a line that is false of the axes is not taken for one that tells what they are.
    pub(super) fn or_by_axes(&mut self, link: &Link<'_>, held: Held) -> Held {
        let open = matches!(
            held.standing,
            Standing::Open | Standing::Free | Standing::Settles
        );
        if !open || held.unknown.is_empty() {
            return held;
        }
        let mut named = self.doubled(link);
        named.retain(|(writing, _)| {
            let letter = self.reading.letters.besides(writing, &self.at);
            letter.is_some_and(|letter| held.unknown.contains(&letter.latex))
        });
        // An axis at rest has no rate: what stands beside its own is a number.
        let sides = link.sides();
        let counted = named
            .iter()
            .any(|(writing, _)| self.is_axis_at_rest(writing) && stands_with_rate(writing, &sides));
        if named.is_empty() || counted {
            return held;
        }
        let named: BTreeSet<Place> = named.into_iter().collect();
        let worked_out = self.sides(link, &named);
        match worked_out
            .is_ok()
            .then(|| self.hold_sides(link, worked_out))
        {
            Some(by_axes) if by_axes.standing == Standing::Entailed => by_axes,
            Some(by_axes) if by_axes.standing == Standing::Denied => {
                match self.may_be_no_axis(&named) {
                    true => Held::open(OPEN_MEANING),
                    false => by_axes,
                }
            }
            _ => held,
        }
    }

    fn is_axis_at_rest(&self, writing: &str) -> bool {
        let letter = self.reading.letters.besides(writing, &self.at);
        let ground = self.reading.system.ground;
        letter.is_some_and(|letter| match &letter.meaning {
            Meaning::Quantity(Quantity::Axis(frame, _)) => *frame == ground,
            _ => false,
        })
    }

    /// The places on a link of letters that mean something besides, and of which no line says what they are.
    pub(super) fn doubled(&self, link: &Link<'_>) -> Vec<Place> {
        let symbols = symbols_of(&link.sides());
        let has = |(writing, _): &Place| {
            let letter = self.reading.letters.besides(writing, &self.at);
            letter.is_some_and(|letter| !self.known.shapes.contains_key(&letter.latex))
        };
        symbols.into_iter().filter(has).collect()
    }
}
