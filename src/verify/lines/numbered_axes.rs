//! Axes told by numbers beside axes told by letters: whether the two sets are one.

use crate::notation::ast::{Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::usage::{Letter, axes, axis, symbols};
use crate::verify::values::atoms::Owner;
use crate::verify::values::quantity::Quantity;

/// Words of axes that are laid out anew.
const LAID_OUT: &[&str] = &[
    "complete the frame",
    "completes the frame",
    "completing the frame",
    "complete the triad",
    "completes the triad",
    "completing the triad",
];

impl Checker<'_> {
    /// Ends what lines supposed of the products of inertia on other axes, before numbers name the principal ones.
    pub(crate) fn leave_lettered_axes(&mut self) {
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        let products = [3, 4, 5].map(|c| self.theory.atoms.part(inertia, c, 0));
        let premises = self.theory.premises().iter();
        let of_products = premises.filter(|premise| {
            let mut residuals = premise.residuals.iter();
            premise.name.starts_with("line ")
                && residuals.any(|r| r.variables().iter().any(|v| products.contains(v)))
        });
        let ended = of_products.map(|premise| premise.name.clone()).collect();
        self.end_premises(&ended);
    }

    /// Numbered components in a line, where moments of inertia are numbered and about x and y as well: nothing says
    /// whether the two sets of axes are one.
    pub(crate) fn on_numbered_axes(&self, sides: &[Node]) -> Option<String> {
        let usage = &self.reading.usage;
        let quantities = &self.reading.quantities;
        let lettered =
            |letter: &Letter| ["x", "y"].iter().all(|axis| usage.has_index(letter, axis));
        let moment = |letter: &Letter| quantities.get(letter) == Some(&Quantity::Inertia);
        let entries =
            |letter: &Letter| usage.has_lettered_entries(letter) && usage.has_index(letter, "1");
        let told_apart = !self.reading.turns_to_numbers
            && quantities
                .keys()
                .any(|letter| moment(letter) && entries(letter));
        let of_both = |symbol: &&Symbol| {
            let letter = Letter::of(symbol);
            let numbered = matches!(symbol.subscripts.as_slice(), [s] if matches!(s.as_str(), "1" | "2" | "3"));
            let beside = match moment(&letter) {
                true => lettered(&letter) && !self.reading.turns_to_numbers,
                false => told_apart && quantities.contains_key(&letter),
            };
            numbered && beside
        };
        let mut found = sides.iter().flat_map(symbols).filter(of_both);
        // What a line has said of it, it stands for.
        let found = found.find(|symbol| !self.is_own_and_said(symbol))?;
        Some(format!(
            "nothing before says whether `{}` is about the axes x, y, z",
            found.name
        ))
    }

    /// Lettered components in a line, where others are numbered and words lay out axes x, y, z of their own: "let ⟨z⟩ run
    /// along the shaft and ⟨x⟩ complete the frame".
    pub(crate) fn on_lettered_axes(&self, sides: &[Node]) -> Option<String> {
        if !self.text.says(LAID_OUT) {
            return None;
        }
        let usage = &self.reading.usage;
        let of_body = |letter: &&Letter| self.reading.quantities.contains_key(*letter);
        let mut letters = usage.subscripts.keys().filter(of_body);
        let numbered =
            letters.any(|letter| ["1", "2", "3"].iter().any(|i| usage.has_index(letter, i)));
        let lettered = |symbol: &&Symbol| {
            let place = |index: &String| axis(index).is_some() || axes(index).is_some();
            let letter = |index: &String| place(index) && index.starts_with(['x', 'y', 'z']);
            self.reading.quantities.contains_key(&Letter::of(symbol))
                && symbol.subscripts.iter().any(letter)
        };
        let mut met = sides.iter().flat_map(symbols).filter(lettered);
        let found = met
            .find(|symbol| !self.is_own_and_said(symbol))
            .filter(|_| numbered)?;
        Some(format!(
            "nothing before ties the axes of `{}` to the numbered ones",
            found.name
        ))
    }

    fn is_own_and_said(&self, symbol: &Symbol) -> bool {
        let entity = self.theory.atoms.meaning(symbol).and_then(|m| m.entity());
        entity.is_some_and(|entity| {
            let own = matches!(self.theory.atoms.info(entity).owner, Owner::Symbol(_));
            own && self.theory.mentions_entity(entity)
        })
    }
}
