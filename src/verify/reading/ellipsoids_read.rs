//! Ellipsoids, whose semi-axes lie along the axes of their frames.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::verify::language::heads::{MASS, PRINCIPAL_AXES, SEMI_AXIS};
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::model::system::{BodyId, FrameId};
use crate::verify::reading::boxes_read::by_axis;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;

/// What may be said of an ellipsoid without making it another one.
const PLAIN: [&str; 4] = ["uniform", "rigid", "solid", "heavy"];

impl Builder<'_> {
    /// The tensor of an ellipsoid by its semi-axes.
    pub(super) fn ellipsoid_body(
        &mut self,
        body: BodyId,
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let frame = self.reading.system.bodies[body].frame?;
        let known = what.slots.iter().all(|(slot, term)| match (slot, term) {
            (Slot::Of, Term::Phrase(size)) => [MASS, SEMI_AXIS].contains(&size.head),
            _ => false,
        });
        if !known || what.adjectives.iter().any(|said| !PLAIN.contains(said)) {
            return None;
        }
        let told = self.told_sides(SEMI_AXIS, body, frame, declaration)?;
        let sizes: Vec<Fraction> = match semi_axes(what) {
            Some(letters) if told.is_empty() && self.has_principal_axes(body, frame) => {
                let sizes = letters.iter().map(|l| self.size_by_letter(l, declaration));
                sizes.collect::<Option<_>>()?
            }
            _ => by_axis(told)?.into_iter().collect::<Option<_>>()?,
        };
        let mass = self.reading.system.bodies[body].mass.clone();
        let pi = self.system().atoms.pi();
        let moments = mechanics::Shape::by_name(what.head)?.moments(&mass, &sizes, &pi)?;
        let work = self.reading.system.work;
        let turn = self.system().rotation(work, frame);
        let tensor = mechanics::inertia_in_axes(&turn, &moments.central_inertia());
        self.reading.system.bodies[body].inertia = Some(tensor);
        Some(())
    }

    /// Whether a sentence says that the axes of a frame are principal axes of a body: then its semi-axes are named in their
    /// order.
    fn has_principal_axes(&self, body: BodyId, frame: FrameId) -> bool {
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Premise(premise) if premise.head == PRINCIPAL_AXES => {
                let of = premise.slot(Slot::Of).and_then(|of| self.body(of));
                let of_frame = match premise.slot(Slot::With) {
                    Some(Term::Phrase(axes)) => axes.slot(Slot::Of).and_then(|of| self.frame(of)),
                    _ => None,
                };
                of == Some(body) && of_frame == Some(frame)
            }
            _ => false,
        })
    }
}

/// "of semi-axes `$a$`, `$b$`, `$c$`", without axes along which these are.
fn semi_axes(what: &NounPhrase) -> Option<Vec<Formula>> {
    let told = what.all(Slot::Of).find_map(|term| match term {
        Term::Phrase(sizes) if sizes.head == SEMI_AXIS => Some(sizes),
        _ => None,
    })?;
    let letters: Vec<Term> = told.all(Slot::Which).cloned().collect();
    let plain = told.slots.iter().all(|(slot, _)| *slot == Slot::Which);
    (plain && letters.len() == 3).then(|| formulas(&letters).cloned().collect())
}
