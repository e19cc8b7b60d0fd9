//! Bodies, their parts, and the families that their members make.

use crate::verify::language::statement::{
    Declaration, Formula, NounPhrase, Slot, Statement, Term, slot,
};
use crate::verify::language::traits::{Trait, has};
use crate::verify::language::{heads::MASS, is_bodily, is_body};
use crate::verify::model::system::{BodyId, ELEMENT, Family, Rotors};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{MASS_CENTRE, index_letter, is_letter, name_of};
use crate::verify::reading::shapes_read::is_shape;
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::{Quantity, Whole};

/// Nouns of bodies that say no more than that there is one.
pub(super) const WHOLES: [&str; 4] = ["body", "rigid body", "particle", "system"];

/// The name of the body that stands for each particle of several.
pub(super) const EACH: &str = "each";

/// Words that count the members of a family.
const COUNTS: [&str; 5] = ["two", "three", "four", "five", "six"];

/// Members that any body has.
const PARTICLES: [&str; 2] = ["particle", ELEMENT];

impl Builder<'_> {
    /// Gives each body its place, in the order in which they are named.
    pub(super) fn name_bodies(&mut self) {
        self.system().origin();
        for declaration in self.declarations {
            match &declaration.statement {
                Statement::Is { subjects, what } => self.bodies_of_noun(subjects, what),
                Statement::Does {
                    subjects,
                    verb: "consist",
                    slots,
                } => self.bodies_of_parts(subjects, slots, declaration),
                _ => {}
            }
        }
        // Of which whole the members are is told by then.
        for declaration in self.declarations {
            if let Some((subjects, slots)) = declaration.statement.does("number") {
                self.number(subjects, slots);
            }
        }
        self.bodies_with_quantities();
        self.number_members();
        self.stand_for_members();
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            if what.head == "frame"
                && let Some(body) = what.slot(Slot::FixedIn).and_then(|t| self.body(t))
                && let Some(frame) = subjects.first().and_then(|s| self.frame(s))
            {
                // Other frames fixed in it are turned against the first one.
                self.reading.system.bodies[body].frame.get_or_insert(frame);
            }
        }
        self.fix_bodies_in_frames();
        for (name, &body) in &self.bodies {
            let known = self.reading.system.bodies[body].frame.is_some();
            if let Some(&frame) = self.frames.get(name).filter(|_| !known) {
                self.reading.system.bodies[body].frame = Some(frame);
            }
        }
        self.lay_rods_in_frames();
        for (whole, hub) in self.hubs.clone() {
            self.reading.system.bodies[whole].frame = self.reading.system.bodies[hub].frame;
        }
        self.add_frames_of_bodies();
    }

    fn bodies_of_noun(&mut self, subjects: &[Term], what: &NounPhrase) {
        match what.head {
            "frame" => {
                if let Some(Term::Name(name)) = what.slot(Slot::FixedIn)
                    && (!self.frames.contains_key(name) || is_body(name))
                {
                    self.add_named_body(name);
                }
            }
            MASS_CENTRE => {
                if let Some(Term::Name(name)) = what.slot(Slot::Of) {
                    self.add_named_body(name);
                }
            }
            head if WHOLES.contains(&head) || is_shape(head) => {
                for subject in subjects {
                    if let Some(name) = name_of(subject) {
                        self.add_named_body(&name);
                    }
                }
            }
            _ => {}
        }
    }

    /// What has a momentum, or points that are fixed in it, is a body, also where no sentence says that it is one.
    fn bodies_with_quantities(&mut self) {
        for declaration in self.declarations {
            let Statement::Is { what, .. } = &declaration.statement else {
                continue;
            };
            let slot = match what.head {
                "point" => Slot::FixedIn,
                head if is_bodily(head) => Slot::Of,
                _ => continue,
            };
            for term in what.all(slot) {
                if let Term::Name(name) = term
                    && name.starts_with(char::is_lowercase)
                    && singular(name).is_none()
                    && (!self.frames.contains_key(name) || is_body(name))
                    && !self.is_plane(name)
                {
                    self.add_named_body(name);
                }
            }
        }
    }

    /// Whether a sentence says that something is a plane, or a frame.
    fn is_plane(&self, name: &str) -> bool {
        let said = self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } if matches!(what.head, "plane" | "frame") => {
                subjects.iter().any(|s| name_of(s).as_deref() == Some(name))
            }
            _ => false,
        });
        said || has(name, Trait::Ground)
    }

    pub(super) fn add_named_body(&mut self, name: &str) -> BodyId {
        if let Some(&known) = self.bodies.get(name) {
            return known;
        }
        let origin = self.system().origin();
        let body = self.system().add_body(name, None, origin);
        self.bodies.insert(name.to_owned(), body);
        body
    }

    /// "The spacecraft consists of the hub and the wheels."
    fn bodies_of_parts(
        &mut self,
        subjects: &[Term],
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) {
        let [subject] = subjects else { return };
        let Some(name) = name_of(subject) else { return };
        let whole = self.add_named_body(&name);
        let beside = slots.iter().filter(|(slot, _)| *slot == Slot::Of).count() > 1;
        let (mut parts, mut families) = (vec![], 0);
        for (slot, term) in slots {
            if *slot != Slot::Of {
                continue;
            }
            match term {
                Term::Member { family, index } => {
                    self.add_family(family, Some(whole));
                    let id = self.families[family];
                    self.reading.system.families[id]
                        .indices
                        .push(index_letter(index));
                }
                // How many members a family has is not worked with.
                Term::Name(part) if part.split(' ').any(|word| COUNTS.contains(&word)) => {
                    self.say_unused(declaration);
                }
                Term::Name(part) => match singular(part) {
                    // Particles beside other parts move on their own: they make up no rigid body with these.
                    Some("particle") if beside => {
                        self.add_family("particle", None);
                        parts.push(self.add_named_body(EACH));
                    }
                    Some(family) => {
                        self.add_family(family, Some(whole));
                        families += 1;
                    }
                    None => parts.push(self.add_named_body(part)),
                },
                Term::Phrase(phrase) => match self.parts_of_phrase(phrase) {
                    Some(own) => parts.extend(own),
                    None => self.say_unused(declaration),
                },
                _ => self.say_unused(declaration),
            }
        }
        if self.is_part_of_itself(whole, &parts) {
            return self.say_unused(declaration);
        }
        // A hub with its wheels is one rigid body with rotors.
        if let (1.., [hub]) = (families, parts.as_slice()) {
            self.hubs.push((whole, *hub));
            return;
        }
        self.reading.system.bodies[whole].parts = parts;
    }

    /// "the particles P1 and P2", "a particle of the rod".
    fn parts_of_phrase(&mut self, phrase: &NounPhrase) -> Option<Vec<BodyId>> {
        let named = phrase.slots.iter().all(|(slot, _)| *slot == Slot::Which);
        if named && !phrase.slots.is_empty() {
            let names: Option<Vec<String>> = phrase.all(Slot::Which).map(name_of).collect();
            let own = names?.into_iter().map(|name| self.add_named_body(&name));
            return Some(own.collect());
        }
        let of = phrase
            .slot(Slot::Of)
            .filter(|_| phrase.head == "particle")?;
        let of = self.body(of)?;
        let name = format!("particle of {}", self.reading.system.bodies[of].name);
        let own = self.add_named_body(&name);
        self.points_of.push((own, of));
        Some(vec![own])
    }

    fn add_family(&mut self, name: &str, body: Option<BodyId>) {
        if let Some(&known) = self.families.get(name) {
            let family = &mut self.reading.system.families[known];
            family.body = family.body.or(body);
            return;
        }
        let family = Family {
            name: name.to_owned(),
            body,
            indices: vec![],
            member: None,
            density: None,
        };
        self.reading.system.families.push(family);
        self.families
            .insert(name.to_owned(), self.reading.system.families.len() - 1);
    }

    /// "`i` numbers the particles."
    fn number(&mut self, subjects: &[Term], slots: &[(Slot, Term)]) {
        let [(Slot::Of, Term::Name(plural))] = slots else {
            return;
        };
        let name = singular(plural).unwrap_or(plural).to_owned();
        for subject in subjects {
            if let Term::Formula(formula) = subject {
                self.number_with(&name, index_letter(formula));
            }
        }
    }

    /// "particle `i`" says that `i` numbers the particles.
    fn number_members(&mut self) {
        for declaration in self.declarations {
            for term in declaration.statement.terms() {
                let Term::Member { family, index } = term else {
                    continue;
                };
                let known = self.families.contains_key(family);
                if !known && !PARTICLES.contains(&family.as_str()) {
                    continue;
                }
                let letter = index_letter(index);
                // The elements are those of the only body.
                let element = family == ELEMENT && self.bodies.len() == 1;
                if element || letter.chars().all(|c| c.is_ascii_lowercase()) && letter.len() == 1 {
                    self.number_with(family, letter);
                }
            }
        }
    }

    /// The body that stands for each of the particles has the mass of one.
    fn stand_for_members(&mut self) {
        let (Some(&family), Some(&body)) = (self.families.get("particle"), self.bodies.get(EACH))
        else {
            return;
        };
        let system = &mut self.reading.system;
        let index = system.families[family].indices.first().cloned();
        let index = index.unwrap_or_else(|| "i".to_owned());
        system.bodies[body].mass = system.member_mass(family, &index);
        system.bodies[body].members = Some(index);
        system.families[family].member = Some(body);
    }

    fn number_with(&mut self, family: &str, letter: String) {
        let body = (!self.reading.system.bodies.is_empty()).then_some(0);
        self.add_family(family, body);
        let family = self.families[family];
        let indices = &mut self.reading.system.families[family].indices;
        if !indices.contains(&letter) {
            indices.push(letter);
        }
    }

    /// Wheels of a family: "wheel `i` turns relative to B about `g_i` at the rate `\Omega_i`".
    fn read_rotors(&mut self) {
        for declaration in self.declarations {
            let Some(([Term::Member { family, index }], slots)) =
                declaration.statement.does("turn")
            else {
                continue;
            };
            let Some(&family) = self.families.get(family) else {
                continue;
            };
            let Some(body) = self.reading.system.families[family].body else {
                continue;
            };
            let index = index_letter(index);
            let frame = self.reading.system.bodies[body].frame;
            let about = slot(slots, Slot::About).cloned();
            let Some(Term::Formula(axis)) = about else {
                continue;
            };
            let unit = Quantity::MemberVector {
                text: axis.source.clone(),
                carried: frame,
                index: index.clone(),
            };
            self.denote(&axis, Meaning::Quantity(unit.clone()), declaration);
            let rate = slot(slots, Slot::At).cloned();
            let Some(rate) = rate.and_then(|term| self.scalar_term(&term, declaration)) else {
                continue;
            };
            let inertia = Quantity::MemberScalar {
                text: format!("J_{{{index}}}"),
                index: index.clone(),
            };
            let values = (
                self.system().value_of(&unit),
                self.system().value_of(&inertia),
            );
            let (Ok(axis), Ok(inertia)) = values else {
                continue;
            };
            let (Ok(axis), Ok(inertia)) = (axis.to_vector(), inertia.to_scalar()) else {
                continue;
            };
            self.reading.system.bodies[body].rotors = Some(Rotors {
                index,
                axis,
                rate,
                inertia,
            });
        }
    }

    /// What sentences say of bodies once points stand: masses and shapes.
    pub(super) fn finish_bodies(&mut self) {
        self.read_massless();
        for (own, of) in self.points_of.clone() {
            self.reading.system.bodies[own].centre = self.reading.system.bodies[of].centre;
            self.reading.system.bodies[own].mass = self.reading.system.bodies[of].mass.clone();
        }
        self.read_rotors();
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            if !(WHOLES.contains(&what.head) || is_shape(what.head)) {
                continue;
            }
            for subject in subjects {
                if let Some(body) = self.body(subject) {
                    self.read_sizes(body, what, declaration);
                }
            }
        }
        self.find_bases();
        self.tell_tensors_of_wheels();
    }

    /// "P is a particle of mass `$m$`", "the rods are thin rods of length `$l$`".
    fn read_sizes(&mut self, body: BodyId, what: &NounPhrase, declaration: &Declaration) {
        if !is_shape(what.head) {
            self.round_body(body, what, declaration);
        } else if self.shape_body(body, what, declaration).is_none() {
            self.say_unused(declaration);
        }
        // A formula of letters waits for what tells these.
        for formula in masses_said(what).filter(|mass| is_letter(mass)) {
            self.name_mass(body, formula, declaration);
        }
    }

    fn name_mass(&mut self, body: BodyId, formula: &Formula, declaration: &Declaration) {
        let quantity = Quantity::Mass(Whole::Body(body));
        match self.told_there(formula, declaration) {
            // Two bodies with one letter have the same mass.
            Some(told) => self.hold_quantities(&told, &quantity, declaration),
            None => self.denote(formula, Meaning::Quantity(quantity), declaration),
        }
    }
}

/// "a particle of mass `$m$`"
pub(super) fn masses_said(what: &NounPhrase) -> impl Iterator<Item = &Formula> {
    what.all(Slot::Of).filter_map(|size| match size {
        Term::Phrase(size) if size.head == MASS => match size.slot(Slot::Which)? {
            Term::Formula(formula) => Some(formula),
            _ => None,
        },
        _ => None,
    })
}

/// The family that a plural names: "the wheels", "the particles", and not "the chassis".
pub(super) fn singular(plural: &str) -> Option<&str> {
    plural
        .strip_suffix('s')
        .filter(|rest| !rest.ends_with(['s', 'i']) && rest.len() > 2)
}
