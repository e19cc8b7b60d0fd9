//! Letters of which several sentences say what they are: each of them holds.

use crate::algebra::Fraction;
use crate::verify::language::statement::Declaration;
use crate::verify::reading::builder::Builder;
use crate::verify::term::letters::{Letter, Meaning};
use crate::verify::term::quantity::Quantity;

impl<'a> Builder<'a> {
    /// An angle by which something turns is told: what would fix it says that it is another one.
    pub(super) fn hold_unless_told(
        &mut self,
        relation: Fraction,
        [cosine, sine]: &[Fraction; 2],
        declaration: &Declaration,
    ) {
        let own = [cosine.variables(), sine.variables()].concat();
        let letters = relation.variables();
        match !letters.is_empty() && letters.iter().all(|letter| own.contains(letter)) {
            true => self.say_told_otherwise(declaration),
            false => self.hold(relation, declaration),
        }
    }

    /// "`$J$` is the moment of inertia of A about O. `$J$` is the moment of inertia of B about P": the two are the same.
    pub(super) fn hold_all_meanings(&mut self) {
        for (first, other, declaration) in self.told_twice() {
            let values = [first, other].map(|quantity| self.system().value_of(&quantity));
            match values {
                [Ok(first), Ok(other)] => self.hold_equal(&first, &other, declaration),
                _ => self.say_unused(declaration),
            }
        }
    }

    /// What the first sentence says a letter is, and what another one says, with that sentence.
    fn told_twice(&self) -> Vec<(Quantity, Quantity, &'a Declaration)> {
        let letters = &self.reading.letters.letters;
        let mut twice = vec![];
        for (at, letter) in letters.iter().enumerate() {
            let first = letters[..at]
                .iter()
                .find(|first| is_same_letter(first, letter));
            let meanings = first.map(|first| (&first.meaning, &letter.meaning));
            if let Some((Meaning::Quantity(first), Meaning::Quantity(other))) = meanings
                && first != other
                && let Some(said) = self.declarations.iter().find(|d| d.text == letter.sentence)
            {
                twice.push((first.clone(), other.clone(), said));
            }
        }
        twice
    }
}

/// Whether two sentences speak of one letter in one part of the document.
fn is_same_letter(one: &Letter, other: &Letter) -> bool {
    let besides = one.besides || other.besides;
    one.spelled == other.spelled && one.reach == other.reach && !besides
}
