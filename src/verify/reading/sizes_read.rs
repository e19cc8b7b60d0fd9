//! Sizes of shapes: by their letters, in whichever sentence they are told.

use crate::algebra::Fraction;
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::model::system::BodyId;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{is_letter, letter_of};
use crate::verify::reading::shapes_read::is_shape;
use crate::verify::term::quantity::Quantity;

impl Builder<'_> {
    /// A size by its letter; one of which nothing is said is a constant without a letter.
    pub(super) fn size_of_shape(
        &mut self,
        body: BodyId,
        what: &NounPhrase,
        wanted: &str,
        declaration: &Declaration,
    ) -> Option<Fraction> {
        let told = size_in(what, wanted).or_else(|| self.said_size(body, wanted));
        if let Some(formula) = told {
            return self.size_by_letter(&formula, declaration);
        }
        let name = &self.reading.system.bodies[body].name;
        let quantity = Quantity::Scalar {
            text: format!("\\text{{{wanted} of {name}}}"),
            constant: true,
        };
        let size = self.system().value_of(&quantity).ok()?.to_scalar().ok()?;
        self.system().atoms.set_positive(&size);
        Some(size)
    }

    /// A size that a formula tells: a letter is a positive constant.
    pub(super) fn size_by_letter(
        &mut self,
        formula: &Formula,
        declaration: &Declaration,
    ) -> Option<Fraction> {
        if !is_letter(formula) {
            self.tell_letters_of_place(formula, declaration)?;
            return self.formula_value(formula, declaration)?.to_scalar().ok();
        }
        let quantity = self.denote_number(formula, declaration);
        let size = self.system().value_of(&quantity).ok()?.to_scalar().ok()?;
        self.system().atoms.set_positive(&size);
        Some(size)
    }

    /// "`$r$` is the radius of the disc", in a sentence of its own.
    pub(super) fn said_size(&self, body: BodyId, wanted: &str) -> Option<Formula> {
        let mut said = self.declarations.iter();
        said.find_map(|d| match &d.statement {
            Statement::Is { subjects, what } if is_size(what.head, wanted) => {
                let of = what.slot(Slot::Of).and_then(|term| self.body(term))?;
                let letter = subjects.first().and_then(letter_of)?;
                (of == body && subjects.len() == 1).then(|| letter.clone())
            }
            // The shape may be told once more, with its sizes.
            Statement::Is { subjects, what } if is_shape(what.head) => {
                let own = subjects.iter().any(|term| self.body(term) == Some(body));
                size_in(what, wanted).filter(|_| own)
            }
            _ => None,
        })
    }
}

/// What a size of a shape is also called: the height of a cylinder is its length.
const SAME_SIZE: [(&str, &str); 4] = [
    ("side", "edge"),
    ("length", "edge"),
    ("length", "height"),
    ("thickness", "height"),
];

/// The letter of a size that is told with a shape: "of radius `$r$`".
fn size_in(what: &NounPhrase, wanted: &str) -> Option<Formula> {
    what.all(Slot::Of).find_map(|term| match term {
        Term::Phrase(size) if is_size(size.head, wanted) => letter_of(term).cloned(),
        _ => None,
    })
}

pub(super) fn is_size(said: &str, wanted: &str) -> bool {
    said == wanted || SAME_SIZE.contains(&(said, wanted))
}
