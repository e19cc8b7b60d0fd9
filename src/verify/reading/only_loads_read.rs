//! "The weight and the force at O are the only loads on the top": what the loads on a body come to.

use crate::algebra::Fraction;
use crate::verify::language::heads::{FORCE, MOMENT};
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Term};
use crate::verify::language::traits::is_force;
use crate::verify::model::loads::{Called, Lasting, Load};
use crate::verify::model::system::{BodyId, PointId, Turn, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::loads_between::one_of_each;
use crate::verify::reading::loads_read::{Acting, lasting_of, letters_of};
use crate::verify::reading::named_loads_read::names_load;
use crate::verify::reading::names::{is_letter, is_marked_vector, node_of};
use crate::verify::term::letters::{Meaning, spelled};
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{Basis, Value};
use num_traits::Zero;

/// The loads on a body that a sentence lists, and the one force that nothing tells.
struct Listed {
    body: BodyId,
    lasting: Lasting,
    loads: Vec<Load>,
    open: Option<(PointId, Option<Formula>)>,
}

impl Builder<'_> {
    /// "The weight and the force at O are the only loads on the top." One force that nothing tells is what the others
    /// leave of the whole; about the point where it acts it has no moment. Of the only forces nothing is said of moments.
    pub(super) fn only_loads(
        &mut self,
        premise: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let body = self.body_of(premise)?;
        // "the only loads on it about G": of others about another point nothing is said.
        if premise.slot(Slot::About).is_some() || premise.slot(Slot::Along).is_some() {
            return None;
        }
        let lasting = self.lasting_of_list(premise);
        let told = self.reading.instants.blow || self.rests_before_blow(body);
        if lasting == Lasting::Blow && !told {
            return None;
        }
        let mut listed = Listed {
            body,
            lasting,
            loads: vec![],
            open: None,
        };
        for load in premise.all(Slot::With) {
            match load {
                Term::Formula(letter) => {
                    self.list_letter(letter, premise, &mut listed, declaration)?
                }
                // "the forces": all that have been told.
                Term::Phrase(all) if is_all(all) => {
                    let told = self.told_forces(body, listed.lasting);
                    listed.loads.extend(told);
                    listed.loads.extend(self.forces_of_springs(body)?);
                }
                // A force along an axis is not told by its letter alone.
                Term::Phrase(load) if load.slot(Slot::Along).is_some() => {
                    let moment = self.moment_along(load, body, declaration)?;
                    listed.loads.push(moment);
                }
                Term::Phrase(loads) => {
                    let each = one_of_each(loads, Slot::Of).into_iter();
                    for load in each.flat_map(|load| one_of_each(&load, Slot::At)) {
                        self.list_load(&load, premise, &mut listed, declaration)?;
                    }
                }
                _ => return None,
            }
        }
        self.hold_loads(&listed, premise.head == "force", declaration)
    }

    /// "the moment `$-c w$` along z": all of a load.
    fn moment_along(
        &mut self,
        load: &NounPhrase,
        body: BodyId,
        declaration: &Declaration,
    ) -> Option<Load> {
        let letters = letters_of(load);
        if letters.is_empty() {
            return self.open_moment_along(load, body, declaration);
        }
        let ([letter], MOMENT) = (letters.as_slice(), load.head) else {
            return None;
        };
        let plain = |(slot, _): &(Slot, Term)| matches!(slot, Slot::Which | Slot::Along);
        let acting = Acting {
            head: MOMENT,
            letter,
            at: None,
            along: load.slot(Slot::Along),
            on: Some(body),
        };
        let value = self.value_of_load(&acting, declaration);
        let value = value.filter(|_| load.slots.iter().all(plain))?;
        Some(Load::unnamed(None, value, Some(body)))
    }

    /// The forces of which sentences tell where they act.
    fn told_forces(&self, body: BodyId, lasting: Lasting) -> Vec<Load> {
        let loads = self.reading.system.loads.iter();
        let told = loads.filter(|load| {
            let named = !matches!(load.called, Called::Nothing);
            let here = load.on.is_none_or(|on| on == body) && load.at.is_some();
            named && !load.part && load.lasting == lasting && here
        });
        told.cloned().collect()
    }

    fn list_letter(
        &mut self,
        letter: &Formula,
        premise: &NounPhrase,
        listed: &mut Listed,
        declaration: &Declaration,
    ) -> Option<()> {
        if let Some(load) = self.load(letter, listed.lasting) {
            listed.loads.push(load);
            return Some(());
        }
        if let Some(loads) = self.loads_of_letter(letter, declaration) {
            listed.loads.extend(loads);
            return Some(());
        }
        let particle = self.reading.system.bodies[listed.body].frame.is_none();
        let at = self.centre_of(listed.body);
        let told = is_letter(letter).then(|| self.quantity_of(letter, declaration));
        // A formula tells what a load is, and so does what a sentence says of a letter: that is not open.
        if told.as_ref().is_none_or(Option::is_some) {
            let value = self.told_load(letter, told.flatten(), declaration)?;
            let weight = self.weight_on(listed.body).map(|weight| weight.value);
            let at_centre = particle || premise.head == "force" || weight.as_ref() == Some(&value);
            listed.loads.push(Load {
                lasting: listed.lasting,
                ..Load::unnamed(at_centre.then_some(Some(at))?, value, None)
            });
            return Some(());
        }
        // A force on a particle acts where that is.
        if listed.open.is_some() || !particle && premise.head != "force" {
            return None;
        }
        listed.open = Some((at, Some(letter.clone())));
        Some(())
    }

    /// What a load is that a formula tells, or a sentence about its letter.
    fn told_load(
        &mut self,
        letter: &Formula,
        told: Option<Quantity>,
        declaration: &Declaration,
    ) -> Option<Vector> {
        let value = match told {
            Some(told) => self.system().value_of(&told).ok()?,
            None => {
                self.tell_letters_of_place(letter, declaration)?;
                self.formula_value(letter, declaration)?
            }
        };
        value.to_vector().ok()
    }

    fn list_load(
        &mut self,
        load: &NounPhrase,
        premise: &NounPhrase,
        listed: &mut Listed,
        declaration: &Declaration,
    ) -> Option<()> {
        let lasting = listed.lasting;
        if let Some(known) = self.told_loads(load, premise, lasting) {
            listed.loads.extend(known);
            return Some(());
        }
        let letters: Vec<&Formula> = letters_of(load);
        if let Some(named) = self.loads_of_letters(&letters, declaration) {
            listed.loads.extend(named);
            return Some(());
        }
        // A force on a particle acts where that is.
        let particle = self.reading.system.bodies[listed.body].frame.is_none();
        if let (true, None, [letter]) = (
            premise.head == "force" || particle && is_force(load.head),
            load.slot(Slot::At),
            letters.as_slice(),
        ) {
            return self.list_letter(letter, premise, listed, declaration);
        }
        if let (true, [letter]) = (names_load(load), letters.as_slice()) {
            let named = self.load_with_letter(load, letter, listed.body, declaration)?;
            listed.loads.extend(named);
            return Some(());
        }
        let at = load.slot(Slot::At).and_then(|term| self.point(term))?;
        if load.head == MOMENT && letters.is_empty() && lasting == Lasting::Always {
            let moment = self.moment_at(at, listed.body)?;
            listed.loads.push(moment);
            return Some(());
        }
        if !is_force(load.head) || lasting_of(load.head) != lasting || letters.len() > 1 {
            return None;
        }
        let letter = letters.first().map(|letter| (*letter).clone());
        // Another sentence may name the force at this point.
        let named = self.loads_on(listed.body, at, lasting);
        if letter.is_none() && !named.is_empty() {
            listed.loads.extend(named);
            return Some(());
        }
        match &listed.open {
            None => listed.open = Some((at, letter)),
            Some(_) => {
                let open = self.open_load(load.head, at, letter, declaration)?;
                listed.loads.push(open);
            }
        }
        Some(())
    }

    /// "the thrust `T`", where no other sentence tells of either: the letter is the vector.
    fn load_with_letter(
        &mut self,
        load: &NounPhrase,
        letter: &Formula,
        body: BodyId,
        declaration: &Declaration,
    ) -> Option<Vec<Load>> {
        if !is_marked_vector(letter) || self.quantity_of(letter, declaration).is_some() {
            return None;
        }
        let mut plain = load.clone();
        plain.slots.retain(|(slot, _)| *slot != Slot::Which);
        let named = self.named_load(&plain, Some(body))?;
        let known = Quantity::Known(Value::vector(&named.first()?.value, Basis::Itself));
        self.denote(letter, Meaning::Quantity(known), declaration);
        Some(named)
    }

    /// "the moment at O": what holds an end may turn it in any way.
    fn moment_at(&mut self, at: PointId, body: BodyId) -> Option<Load> {
        let moment = self.free_load(&format!("M_{{{at},{body}}}"), None)?;
        Some(Load::unnamed(None, moment, Some(body)))
    }

    /// The weight, a load by its noun, or loads by letters that other sentences tell.
    pub(super) fn told_loads(
        &mut self,
        load: &NounPhrase,
        premise: &NounPhrase,
        lasting: Lasting,
    ) -> Option<Vec<Load>> {
        if load.head == "weight" {
            let other = |term| self.body(term) != self.body_of(premise);
            if load.slot(Slot::Of).is_some_and(other) {
                return None;
            }
            let body = self.body_of(premise)?;
            let weight = self.weight_on(body)?;
            return Some(vec![Load { lasting, ..weight }]);
        }
        let letters = letters_of(load);
        let plain = letters.is_empty() && load.head == FORCE && load.slot(Slot::Of).is_none();
        if let (true, Lasting::Always, Some(at), Some(body)) =
            (plain, lasting, load.slot(Slot::At), self.body_of(premise))
            && let Some(at) = self.point(at)
            && let Some(between) = self.force_at_joint(at, body)
        {
            return Some(vec![between]);
        }
        let body = self.body_of(premise);
        if !letters.is_empty() {
            let mut all = letters.iter();
            let known = letters.iter().map(|letter| self.load(letter, lasting));
            let known: Option<Vec<Load>> = known.collect();
            // What the noun names a sentence ties to the letter.
            let tied = known.is_none() && all.all(|letter| self.is_said_to_be(letter, load));
            return if tied {
                self.named_load(load, body)
            } else {
                known
            };
        }
        self.named_load(load, body)
    }

    fn hold_loads(
        &mut self,
        listed: &Listed,
        only_forces: bool,
        declaration: &Declaration,
    ) -> Option<()> {
        let Listed {
            body,
            lasting,
            loads,
            open,
        } = listed;
        let about = match open {
            Some((at, _)) => *at,
            None => self.centre_of(*body),
        };
        if let Some((_, Some(letter))) = open {
            let rest = self.rest_of_loads(listed)?;
            let known = Quantity::Known(Value::vector(&rest, Basis::Itself));
            self.denote(letter, Meaning::Quantity(known), declaration);
            self.reading.system.loads.push(Load {
                called: Called::Letter(node_of(letter).map(spelled).unwrap_or_default()),
                at: Some(about),
                value: rest,
                lasting: *lasting,
                on: Some(*body),
                part: true,
                listed: true,
            });
        }
        // The moment first: proofs come out where its variables have the lower numbers.
        if !only_forces && !self.acts_anywhere(*body, loads) {
            let moment = self.system().rest_of_moment(*body, about, loads, *lasting);
            let moment = self.left_by_loads(moment, (*body, Some(about)), *lasting)?;
            match self.hinge_of(listed) {
                Some(axis) => self.hold(moment.dot(&axis), declaration),
                None => self.hold_zero(&moment, declaration),
            }
        }
        if open.is_none() {
            let rest = self.rest_of_loads(listed)?;
            self.hold_zero(&rest, declaration);
        }
        Some(())
    }

    /// Whether a force on a body that does not turn acts where no sentence tells: of its moment nothing is known, and the
    /// motion needs none.
    fn acts_anywhere(&mut self, body: BodyId, loads: &[Load]) -> bool {
        let ground = self.reading.system.ground;
        let centre = Some(self.centre_of(body));
        let Some(frame) = self.reading.system.bodies[body].frame else {
            return false;
        };
        let turns = self.system().angular_velocity(frame, ground) != Vector::zeros();
        let unplaced = |load: &Load| load.called != Called::Nothing && load.at == centre;
        !turns && loads.iter().any(unplaced)
    }

    /// What is left of the load on a body by those that are listed.
    fn rest_of_loads(&mut self, listed: &Listed) -> Option<Vector> {
        let (body, lasting) = (listed.body, listed.lasting);
        let rest = self.system().rest_of_load(body, &listed.loads, lasting);
        self.left_by_loads(rest, (body, None), lasting)
    }

    /// The axis about which alone a body turns, where a hinge keeps it there: of its tensor nobody tells that none is needed,
    /// or forces at a single point are all that acts on it and its products of inertia call for moments across the axis.
    fn hinge_of(&mut self, listed: &Listed) -> Option<Vector> {
        let ground = self.reading.system.ground;
        let frame = self.reading.system.bodies[listed.body].frame?;
        let parent = self.reading.system.frames[frame].parent?;
        // Against what does not turn it turns as against the ground.
        if self.system().angular_velocity(parent, ground) != Vector::zeros() {
            return None;
        }
        let Turn::Angle(axis, _) = self.reading.system.frames[frame].turn else {
            return None;
        };
        let known = &self.reading.system.bodies[listed.body];
        let tensor = known.inertia.iter().flat_map(|tensor| tensor.iter());
        let variables = tensor.flat_map(Fraction::variables);
        let atoms = &self.reading.system.atoms;
        let told = known.inertia.is_some() && variables.into_iter().all(|v| !atoms.is_unknown(v));
        let skew = known.inertia.as_ref().is_some_and(|tensor| {
            let mut others = (0..3).filter(|other| *other != axis);
            others.any(|other| !tensor[(axis, other)].is_zero())
        });
        let held = !told || skew && listed.acts_at_one_point(known.centre);
        held.then(|| self.system().axis(frame, axis))
    }
}

impl Listed {
    /// Whether nothing but forces acts, and those at the mass centre and one other point.
    fn acts_at_one_point(&self, centre: PointId) -> bool {
        let open = self.open.iter().map(|(at, _)| Some(*at));
        let mut places: Vec<Option<PointId>> =
            self.loads.iter().map(|load| load.at).chain(open).collect();
        places.retain(|at| *at != Some(centre));
        places.dedup();
        places.len() < 2 && !places.contains(&None)
    }
}

/// "the forces", with nothing that tells them from others.
fn is_all(loads: &NounPhrase) -> bool {
    loads.head == "force" && loads.slots.is_empty() && loads.adjectives.is_empty()
}
