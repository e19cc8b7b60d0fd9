//! What is declared to hold, and roles of lines.

use crate::notation::ast::{Line, Relation};
use crate::notation::document::Row;
use crate::notation::print::latex;
use crate::verify::Role;
use crate::verify::language::heads::{MASS, PLANE_OF_SYMMETRY};
use crate::verify::language::statement::{
    Declaration, DeclaredRole, Extent, Formula, NounPhrase, Slot, Statement, Term,
};
use crate::verify::model::bodies::Velocities;
use crate::verify::model::system::{BodyId, FrameId, PointId};
use crate::verify::reading::LineRole;
use crate::verify::reading::balance_read::is_balance;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{MASS_CENTRE, POTENTIAL, node_of, reach_of};
use crate::verify::reading::potentials_read::tells_zero_of_potential;
use crate::verify::reading::zeros_read::ZERO;
use crate::verify::term::letters::Reach;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;
use num_traits::Zero;

impl Builder<'_> {
    /// Takes in the premises.
    pub(super) fn read_premises(&mut self) {
        for (frame, relative, point, declaration) in std::mem::take(&mut self.through) {
            if let Some(point) = self.point(&point) {
                self.hold_axis_through(frame, relative, point, &declaration);
            }
        }
        // What lists of loads leave open is told by them, for all other premises.
        let lists =
            |d: &&Declaration| matches!(&d.statement, Statement::Premise(list) if list.is("only"));
        let all = self.declarations.iter();
        let (lists, others): (Vec<&Declaration>, Vec<&Declaration>) = all.partition(lists);
        for declaration in lists.into_iter().chain(others) {
            match &declaration.statement {
                Statement::Premise(_) | Statement::Holds(_) if self.is_full() => {
                    self.say_beyond(declaration);
                }
                Statement::Premise(premise) => self.read_premise(premise, declaration),
                Statement::Is { subjects, what } if what.head == "zero" && !what.is("not") => {
                    // Where a potential energy is zero the energy itself tells.
                    let of_potential = what.slot(Slot::At).is_some()
                        && tells_zero_of_potential(declaration, self.declarations);
                    // Before and after a blow is not always.
                    let always = what.slots.is_empty();
                    if !of_potential {
                        let read = always.then(|| self.read_zeros(subjects, declaration));
                        let read = read.flatten();
                        read.unwrap_or_else(|| self.say_unused(declaration));
                    }
                }
                Statement::Holds(formula) => self.read_formula(formula, declaration),
                Statement::Is { subjects, what }
                    if matches!(what.head, "orthogonal" | "horizontal") =>
                {
                    let read = self.read_perpendicular(subjects, what, declaration);
                    read.unwrap_or_else(|| self.say_unused(declaration));
                }
                Statement::Is { subjects, what } if what.head == "parallel" => {
                    self.read_parallel_to(subjects, &what.slots, declaration);
                }
                Statement::Does {
                    subjects,
                    verb,
                    slots,
                } => self.read_direction(subjects, verb, slots, declaration),
                Statement::Is { subjects, what } if what.head == "symmetric" => {
                    self.read_symmetry(subjects, what, declaration);
                }
                Statement::Is { subjects, what } if is_balance(what.head) => {
                    self.read_balance(subjects, what, declaration);
                }
                Statement::Is { subjects, what } if what.head == PLANE_OF_SYMMETRY => {
                    let read = self.read_plane_of_symmetry(subjects, what, declaration);
                    read.unwrap_or_else(|| self.say_unused(declaration));
                }
                _ => {}
            }
        }
    }

    /// The point of a turning frame that lies on its axis has no velocity, where the axis passes through a point at rest.
    fn hold_axis_through(
        &mut self,
        frame: FrameId,
        relative: FrameId,
        point: PointId,
        declaration: &Declaration,
    ) {
        let points = &self.reading.system.points;
        let rests = points[point].fixed_in.contains(&relative);
        if points[point].fixed_in.contains(&frame) || !rests {
            return;
        }
        let Some(own) = points.iter().position(|p| p.fixed_in.contains(&frame)) else {
            return;
        };
        let velocity = self.system().velocity(own, relative);
        let omega = self.system().angular_velocity(frame, relative);
        let way = self.system().position(point, own);
        let velocity = velocity + crate::mechanics::cross(&omega, &way);
        self.hold_zero(&velocity, declaration);
    }

    fn read_premise(&mut self, premise: &NounPhrase, declaration: &Declaration) {
        let done = match premise.head {
            "principal axes" => self.principal_axes(premise, declaration),
            MASS if premise.is("equal") => self.equal_masses(premise, declaration),
            "moment" if premise.is("only") && self.lists_moments(premise) => {
                self.only_moments(premise, declaration)
            }
            "moment" if premise.is("only") && self.lists_moments_about_point(premise) => {
                self.only_moments_about_point(premise, declaration)
            }
            "moment" if premise.is("only") => self.only_drive(premise),
            "moment" if premise.is("no") => self.no_moment(premise, declaration),
            "force" if premise.is("no") => self.no_force(premise, declaration),
            "load" if premise.is("only") && self.lists_drive(premise) => Some(()),
            "load" | "force" if premise.is("only") && self.is_list_of_joined(premise) => Some(()),
            "load" | "force" | "impulse" if premise.is("only") => self
                .only_loads(premise, declaration)
                .map(|()| self.mark_listed(premise)),
            "load" if premise.is("no") => self
                .no_force(premise, declaration)
                .and_then(|()| self.no_moment(premise, declaration)),
            MASS_CENTRE if premise.is("fixed") => self.hold_centre(premise, declaration),
            POTENTIAL => Some(()),
            "dimension" => match premise.slot(Slot::Which) {
                Some(Term::Numbers(numbers)) => numbers.first().map(|number| {
                    let reach = reach_of(&declaration.extent);
                    self.reading
                        .letters
                        .customs
                        .dimensions
                        .push((reach, *number));
                }),
                _ => None,
            },
            _ if premise.is(ZERO) && !premise.is("not") => self.zero_premise(premise, declaration),
            _ => None,
        };
        if done.is_none() {
            self.say_unused(declaration);
        }
    }

    /// "The masses of P and Q are equal."
    fn equal_masses(&mut self, premise: &NounPhrase, declaration: &Declaration) -> Option<()> {
        let bodies = premise.all(Slot::Of).map(|of| self.body(of));
        let bodies: Vec<BodyId> = bodies.collect::<Option<_>>()?;
        let (first, others) = bodies.split_first().filter(|(_, rest)| !rest.is_empty())?;
        for other in others {
            let masses = self.reading.system.mass(*first) - self.reading.system.mass(*other);
            self.hold(masses, declaration);
        }
        Some(())
    }

    /// "Line 135 holds in the section "The Spherical Top"": it is assumed there.
    fn read_line_holds(
        &mut self,
        lines: &Extent,
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) {
        let section = slots.iter().find_map(|(_, term)| match term {
            Term::Phrase(phrase) if phrase.head == "section" => match phrase.slot(Slot::Which) {
                Some(Term::Name(title)) => Some(title.clone()),
                _ => None,
            },
            _ => None,
        });
        if section.is_none() && self.read_order_of_lines(lines, slots, declaration) {
            return;
        }
        let lines = match lines {
            // "On lines 3 to 9 everything holds …"
            Extent::Document => reach_of(&declaration.extent),
            lines => reach_of(lines),
        };
        if self.lines_hold_at(&lines, slots, declaration).is_some() {
            return;
        }
        match section {
            Some(title) => self
                .reading
                .held
                .push((lines.clone(), Reach::Section(title))),
            // A line that holds at a time or in a case that is not worked with holds in no other line.
            None => {
                let then = self.reading.instants.named(declaration.sentence());
                then.lines.push(lines.clone());
                self.say_unused(declaration);
            }
        }
        self.reading
            .roles
            .push(LineRole::new(lines, Some(Role::Assume)));
    }

    /// A bare formula: it holds.
    fn read_formula(&mut self, formula: &Formula, declaration: &Declaration) {
        let Row::Line(Line {
            sides, relations, ..
        }) = &formula.row
        else {
            return self.say_unused(declaration);
        };
        // What a line defines is told there, and what it is may be no number.
        if sides
            .iter()
            .any(|side| self.waits_for_line(side, declaration))
        {
            return self.say_unused(declaration);
        }
        let equal = relations
            .iter()
            .all(|(r, _)| matches!(r, Relation::Equal | Relation::Defined));
        self.reading.letters.keep_apart(sides);
        let value = |builder: &mut Self, node: &crate::notation::ast::Node| {
            let formula = Formula::of(node);
            builder.mentioned_value(&formula, declaration)
        };
        let values: Vec<Option<Value>> = sides.iter().map(|side| value(self, side)).collect();
        if !equal {
            let relations: Vec<Relation> = relations.iter().map(|(r, _)| *r).collect();
            let told = self.read_order(&values, &relations, declaration);
            return told.unwrap_or_else(|| self.say_unused(declaration));
        }
        // Of what a letter is tells a formula with a side on which all is known.
        let system = &mut self.reading.system;
        if values.iter().flatten().any(|value| system.is_told(value)) {
            values
                .iter()
                .flatten()
                .for_each(|value| system.trust(value));
        }
        if values.iter().any(Option::is_none) {
            self.say_unused(declaration);
        }
        for pair in values.windows(2) {
            if let [Some(left), Some(right)] = pair {
                self.hold_equal(&left.clone(), &right.clone(), declaration);
            }
        }
    }

    /// Energies and components of momenta, which the equations of motion may keep constant.
    pub(super) fn read_candidates(&mut self) {
        if self.reading.instants.all.is_empty() {
            return;
        }
        self.begin_time();
        let ground = self.reading.system.ground;
        for body in 0..self.reading.system.bodies.len() {
            let energy = self.system().kinetic_energy(body, ground, false);
            let potential = self.potential_energy(body);
            let potential = potential.and_then(|v| self.system().value_of(&v).ok());
            let potential = potential.and_then(|v| v.to_scalar().ok());
            let sum = energy + potential.unwrap_or_else(Zero::zero);
            self.reading.instants.candidates.push(sum);
            let centre = self.centre_of(body);
            let points = &self.reading.system.points;
            let about = points.iter().enumerate();
            let about = about.filter(|(at, p)| *at == centre || p.fixed_in.contains(&ground));
            for about in about.map(|(at, _)| at).collect::<Vec<_>>() {
                let momentum =
                    self.system()
                        .angular_momentum(body, about, ground, Velocities::Absolute);
                for frame in 0..self.reading.system.frames.len() {
                    for axis in 0..3 {
                        let along = self.system().axis(frame, axis).dot(&momentum);
                        self.reading.instants.candidates.push(along);
                    }
                }
            }
        }
    }

    /// "`$A > B$`", "`$A \\ne B$`": nothing follows from it for an equation, but numbers against one have to obey it.
    fn read_order(
        &mut self,
        values: &[Option<Value>],
        relations: &[Relation],
        declaration: &Declaration,
    ) -> Option<()> {
        for (pair, relation) in values.windows(2).zip(relations) {
            let [left, right] = pair else { return None };
            let (left, right) = (
                left.clone()?.to_scalar().ok()?,
                right.clone()?.to_scalar().ok()?,
            );
            let greater = match relation {
                Relation::Greater | Relation::GreaterOrEqual => left - right,
                Relation::Less | Relation::LessOrEqual => right - left,
                Relation::NotEqual => continue,
                _ => return None,
            };
            let reach = reach_of(&declaration.extent);
            self.reading.sizes.orders.push((reach, greater));
        }
        Some(())
    }

    /// Declared roles of lines.
    pub(super) fn read_roles(&mut self) {
        for declaration in self.declarations {
            if let Statement::LineHolds { lines, slots } = &declaration.statement {
                self.read_line_holds(lines, slots, declaration);
            }
            let Statement::Role { lines, role } = &declaration.statement else {
                continue;
            };
            let there = reach_of(&declaration.extent);
            let reach = match (lines, &declaration.extent) {
                (Extent::Document, _) => there.clone(),
                (lines, Extent::Cells(_)) => {
                    Reach::Both(Box::new(there.clone()), Box::new(reach_of(lines)))
                }
                (lines, _) => reach_of(lines),
            };
            let defines = match role {
                DeclaredRole::Define(formula) => formula.as_ref().and_then(node_of).map(latex),
                _ => None,
            };
            // "On lines 4 to 9 line 3 is assumed": it holds there alone.
            if matches!(role, DeclaredRole::Assume) && declaration.extent != Extent::Document {
                let mut held = self.reading.held.iter_mut();
                match held.find(|(lines, _)| *lines == reach) {
                    Some((_, before)) => *before = before.clone().or(there),
                    None => self.reading.held.push((reach.clone(), there)),
                }
            }
            let role = match role {
                DeclaredRole::Given => Some(Role::Given),
                DeclaredRole::Assume => Some(Role::Assume),
                DeclaredRole::Claim => Some(Role::Claim),
                DeclaredRole::Define(_) => Some(Role::Define),
                DeclaredRole::LeftOut => None,
                // It says how the line is read, and nothing of what it is.
                DeclaredRole::StartsFrom(_) | DeclaredRole::GoesOnFrom(_) => continue,
            };
            self.reading.roles.push(LineRole {
                reach,
                role,
                defines,
            });
        }
    }
}

pub(super) fn zero() -> Quantity {
    Quantity::Known(Value::scalar(Zero::zero()))
}
