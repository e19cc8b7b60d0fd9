//! Forces on particles: they act where the particle is, and a list of loads may be all that names them.

use crate::verify::language::heads::FORCE;
use crate::verify::language::statement::{Declaration, Formula, Slot, Statement, Term};
use crate::verify::model::system::BodyId;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::loads_read::{Acting, letters_of};
use crate::verify::reading::names::is_letter;
use crate::verify::reading::reactions_read::same_letter;

impl Builder<'_> {
    /// "The forces `S` and `T` are the only loads on P": they act where the particle is.
    pub(super) fn tell_forces_on_particles(&mut self) {
        for declaration in self.declarations {
            let Statement::Premise(list) = &declaration.statement else {
                continue;
            };
            let body = self.body_of(list).filter(|_| list.is("only"));
            let particle = |body: &BodyId| self.reading.system.bodies[*body].is_particle();
            let Some(body) = body.filter(particle) else {
                continue;
            };
            let letters = list.all(Slot::With).flat_map(plain_forces);
            let mut new: Vec<&Formula> = letters.collect();
            new.retain(|letter| {
                let told = self.declarations.iter().any(|d| tells_letter(d, letter));
                !told && self.quantity_of(letter, declaration).is_none()
            });
            // One alone is what the others leave.
            for letter in new.iter().copied().filter(|_| new.len() > 1) {
                let acting = Acting {
                    head: FORCE,
                    letter,
                    at: Some(self.centre_of(body)),
                    along: None,
                    on: Some(body),
                };
                if let Some(value) = self.value_of_load(&acting, declaration) {
                    self.push_load(&acting, value);
                }
            }
        }
    }
}

/// What a list of loads calls a force without saying more: a letter, or "the force `S`".
fn plain_forces(load: &Term) -> Vec<&Formula> {
    match load {
        Term::Formula(letter) if is_letter(letter) => vec![letter],
        Term::Phrase(load) if load.head == FORCE => {
            let plain = load.slots.iter().all(|(slot, _)| *slot == Slot::Which);
            letters_of(load).into_iter().filter(|_| plain).collect()
        }
        _ => vec![],
    }
}

/// Whether a sentence says what a letter is.
fn tells_letter(declaration: &Declaration, letter: &Formula) -> bool {
    let own = |subject: &Term| match subject {
        Term::Formula(own) => same_letter(own, letter),
        Term::Phrase(load) => letters_of(load).iter().any(|own| same_letter(own, letter)),
        _ => false,
    };
    declaration.statement.subjects().iter().any(own)
}
