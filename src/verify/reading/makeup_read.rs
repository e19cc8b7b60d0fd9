//! How the mass of a body is spread, where a sentence says that it is not spread evenly over its shape.

use crate::verify::language::centres::MIDDLES;
use crate::verify::language::heads::{DENSITY, MASS, MASS_CENTRE};
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::verify::language::traits::{Trait, has};
use crate::verify::model::system::BodyId;
use crate::verify::reading::builder::Builder;

/// What is said of a shape whose mass does not fill it.
pub(super) const HOLLOW: &str = "hollow";

/// What is denied of a body of which the mass is not spread evenly.
const EVEN: [&str; 3] = ["uniform", "solid", "constant"];

/// The verb of what is not the same everywhere.
const DIFFER: &str = "differ";

/// "The density of the wheel is not constant", "the wheel is not uniform": a fact of the body, and no denial that tells nothing.
pub(super) fn if_spread_unevenly(declaration: Declaration) -> Declaration {
    let told = match &declaration.statement {
        Statement::Is { subjects, what } if is_denial(what) => match subjects.as_slice() {
            [Term::Formula(_)] | [] => None,
            subjects => Some(subjects.to_vec()),
        },
        Statement::Premise(what) if is_denial_of_density(what) => {
            let mut plain = what.clone();
            plain.adjectives.clear();
            Some(vec![Term::Phrase(Box::new(plain))])
        }
        _ => None,
    };
    match told {
        Some(subjects) => declaration.saying(Statement::Does {
            subjects,
            verb: DIFFER,
            slots: vec![],
        }),
        None => declaration,
    }
}

fn is_denial(what: &NounPhrase) -> bool {
    what.is("not") && EVEN.contains(&what.head) && what.slots.is_empty()
}

fn is_denial_of_density(what: &NounPhrase) -> bool {
    let even = EVEN.iter().any(|even| what.is(even));
    what.is("not") && even && what.head == DENSITY
}

impl Builder<'_> {
    /// Whether a sentence says of a body, or of its mass or density, what no shape of uniform density has.
    pub(super) fn is_made_otherwise(&self, body: BodyId) -> bool {
        if self.is_unbalanced(body) {
            return true;
        }
        let own = |term: &Term| self.body(term) == Some(body);
        let of_mass = |term: &Term| match term {
            Term::Phrase(of) if [MASS, DENSITY].contains(&of.head) => of
                .slot(Slot::Of)
                .map_or(self.only_body() == Some(body), own),
            _ => false,
        };
        if self.has_mass_off_its_middle(body) {
            return true;
        }
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                let hollow = what.head == HOLLOW && what.adjectives.is_empty();
                let by_shape = self.is_shaped(body, |noun| has(noun, Trait::Hollow));
                hollow && !by_shape && subjects.iter().any(own)
            }
            Statement::Does { subjects, verb, .. } => {
                subjects.iter().any(of_mass) || *verb == DIFFER && subjects.iter().any(own)
            }
            _ => false,
        })
    }

    /// Whether sentences name the middle of a body and its mass centre apart, and none says that it is uniform.
    fn has_mass_off_its_middle(&self, body: BodyId) -> bool {
        let named = |heads: &[&str]| {
            self.declarations.iter().any(|d| match &d.statement {
                Statement::Is { what, .. } if heads.contains(&what.head) => {
                    let of = what.slot(Slot::Of);
                    of.is_some_and(|of| self.body(of) == Some(body))
                }
                _ => false,
            })
        };
        let one_sided = self.is_shaped(body, |noun| has(noun, Trait::OneSided));
        !one_sided && named(&MIDDLES) && named(&[MASS_CENTRE])
    }
}
