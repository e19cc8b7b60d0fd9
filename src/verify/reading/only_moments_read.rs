//! "`$L$` and `$M$` are the only moments on the body about G": what they come to about that point. "A driving moment along z", one
//! of the only loads: it has any size.

use crate::verify::language::heads::MOMENT;
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::language::traits::is_couple;
use crate::verify::model::loads::Load;
use crate::verify::model::system::{BodyId, PointId};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::loads_read::letters_of;
use crate::verify::reading::named_loads_read::names_load;
use crate::verify::reading::reactions_read::same_letter;

impl Builder<'_> {
    /// "a driving moment along z", "the moment of the motor along z": of any size that no sentence tells by a letter, or what
    /// a moment that sentences name comes to along that axis.
    pub(super) fn open_moment_along(
        &mut self,
        load: &NounPhrase,
        body: BodyId,
        declaration: &Declaration,
    ) -> Option<Load> {
        let along = load.slot(Slot::Along)?;
        let plain = |(slot, _): &(Slot, Term)| matches!(slot, Slot::Of | Slot::Along);
        if !is_couple(load.head) || !load.slots.iter().all(plain) {
            return None;
        }
        let along = self.direction(along, declaration, None)?;
        let mut whole = load.clone();
        whole.slots.retain(|(slot, _)| *slot != Slot::Along);
        let moment = match whole.head == MOMENT && whole.slots.is_empty() {
            true => self.free_load(&format!("M_{{\\parallel,{body}}}"), Some(along))?,
            false => match self.named_load(&whole, Some(body))?.as_slice() {
                [named] if named.at.is_none() => along.clone() * named.value.dot(&along),
                _ => return None,
            },
        };
        Some(Load::unnamed(None, moment, Some(body)))
    }

    /// Whether a sentence lists moments about a point, on no axis alone.
    pub(super) fn lists_moments_about_point(&self, premise: &NounPhrase) -> bool {
        premise.slot(Slot::Along).is_none() && self.point_of_list(premise).is_some()
    }

    /// The point about which the moments of a list are: the one that is said, or the one of each of them.
    fn point_of_list(&self, premise: &NounPhrase) -> Option<PointId> {
        if let Some(about) = premise.slot(Slot::About) {
            return self.point(about);
        }
        let moments = self.moments_of_list(premise)?;
        let about = |moment: &NounPhrase| moment.slot(Slot::About).and_then(|at| self.point(at));
        let first = about(moments.first()?)?;
        let same = moments.iter().all(|moment| about(moment) == Some(first));
        same.then_some(first)
    }

    /// The moments of a list, each as a noun says it: of a letter the noun is that of the sentence that tells it.
    fn moments_of_list(&self, premise: &NounPhrase) -> Option<Vec<NounPhrase>> {
        let mut moments = vec![];
        for term in premise.all(Slot::With) {
            match term {
                Term::Formula(letter) => moments.push(self.moment_said(letter)?),
                Term::Phrase(moment) if moment.head == MOMENT => {
                    match letters_of(moment).as_slice() {
                        [] => moments.extend(each_moment(moment)),
                        letters if moment.slot(Slot::Of).is_none() => {
                            for letter in letters {
                                moments.push(self.moment_said(letter)?);
                            }
                        }
                        _ => return None,
                    }
                }
                _ => return None,
            }
        }
        Some(moments)
    }

    fn moment_said(&self, letter: &Formula) -> Option<NounPhrase> {
        self.declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == MOMENT => formulas(subjects)
                .any(|own| same_letter(own, letter))
                .then(|| what.clone()),
            _ => None,
        })
    }

    /// They come to the total moment on the body about the point.
    pub(super) fn only_moments_about_point(
        &mut self,
        premise: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let body = self.body_of(premise)?;
        let about = self.point_of_list(premise)?;
        let mut rest = self.system().total_moment(body, about);
        for mut moment in self.moments_of_list(premise)? {
            let on = moment.slot(Slot::Upon);
            if on.is_some_and(|on| self.body(on) != Some(body)) {
                return None;
            }
            give_to_body(&mut moment, premise.slot(Slot::Of)?);
            match moment.slot(Slot::About) {
                Some(own) if self.point(own) != Some(about) => return None,
                Some(_) => {}
                None => {
                    let at = premise.slot(Slot::About)?.clone();
                    moment.slots.push((Slot::About, at));
                }
            }
            let moment = self.moment(&moment, declaration)?;
            let moment = self.system().value_of(&moment).ok()?;
            rest -= moment.to_vector().ok()?;
        }
        self.hold_zero(&rest, declaration);
        self.mark_listed(premise);
        Some(())
    }
}

/// "the moments of the drag and of the thrust", "the moment of the drag and the moment of the thrust": one of each.
pub(super) fn each_moment(moments: &NounPhrase) -> Vec<NounPhrase> {
    let others = moments.slots.iter().filter(|(slot, _)| *slot != Slot::Of);
    let others: Vec<(Slot, Term)> = others.cloned().collect();
    let each = moments.all(Slot::Of).map(|of| match of {
        Term::Phrase(own) if own.head == MOMENT => (**own).clone(),
        of => NounPhrase {
            slots: [&[(Slot::Of, of.clone())], others.as_slice()].concat(),
            ..moments.clone()
        },
    });
    each.collect()
}

/// "the moment of the thrust": of the thrust on the body of which the list is.
fn give_to_body(moment: &mut NounPhrase, body: &Term) {
    let load = moment.slots.iter_mut().find_map(|(slot, term)| match term {
        Term::Phrase(load) if *slot == Slot::Of && names_load(load) => Some(load),
        _ => None,
    });
    if let Some(load) = load
        && load.slot(Slot::Of).is_none()
        && load.slot(Slot::Upon).is_none()
    {
        load.slots.push((Slot::Of, body.clone()));
    }
}
