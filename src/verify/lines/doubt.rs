//! Doubt: why a difference that is there may be no mistake, but a line before it that was not understood.

use crate::algebra::{Fraction, Monomial, Rational, Variable};
use crate::notation::ast::{Function, Kind, Line};
use crate::verify::check::Checker;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::lines::line::Read;
use crate::verify::names;
use crate::verify::reason::{AT_A_MOMENT, NAMES_A_MOMENT, leaves_no_doubt};
use crate::verify::theory::law::Axes;
use crate::verify::values::atoms::{Atom, Entity, Owner};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::verdict::{Finding, Role, Verdict};
use num_rational::BigRational;
use std::collections::BTreeSet;

/// What earlier lines leave in doubt.
#[derive(Clone, Debug, Default)]
pub(crate) struct Doubts {
    /// Symbols of the document in lines that were left open.
    symbols: BTreeSet<Entity>,
    /// The line that sets the body or its motion up, and was left open.
    setting: Option<String>,
    /// Values in numbers that false lines show.
    pub(super) values: Vec<BigRational>,
}

/// Quantities that set a body and its motion up.
const SETTING: &[Quantity] = &[
    Quantity::Inertia,
    Quantity::AngularVelocity,
    Quantity::FrameRate,
    Quantity::Momentum,
    Quantity::Moment,
];

impl Checker<'_> {
    /// Notes what a line that was left open leaves in doubt.
    pub(crate) fn note_doubt(&mut self, line: &Line, finding: &Finding) {
        self.note_false_value(line, finding);
        let without_value = self.has_no_value(&line.sides, finding);
        self.doubts.symbols.extend(without_value);
        let open = match finding.verdict {
            Verdict::Undecided => !finding.reason.as_deref().is_some_and(leaves_no_doubt),
            Verdict::Unreadable => true,
            _ => false,
        };
        if !open {
            return;
        }
        let mut sets_up = finding.role != Role::Claim;
        // What holds at a moment alone leaves in doubt what it gives a value, and nothing beside.
        let at_a_moment = finding.reason.as_deref() == Some(AT_A_MOMENT);
        let doubted = if at_a_moment { 1 } else { line.sides.len() };
        let unsaid = self.only_says_of_new(line, finding);
        for side in line.sides.iter().take(doubted) {
            let lone = matches!(inner(side).kind, Kind::Symbol(_));
            for entity in self.entities([side]) {
                if unsaid && self.theory.mentions_entity(entity) {
                    continue;
                }
                match &self.theory.atoms.info(entity).owner {
                    Owner::Quantity(quantity, variant) if variant.is_empty() => {
                        sets_up |= lone && SETTING.contains(quantity);
                        // No law here says what a force is: the letter may well mean something else.
                        if lone && *quantity == Quantity::Force {
                            self.doubts.symbols.insert(entity);
                        }
                    }
                    _ => {
                        self.doubts.symbols.insert(entity);
                    }
                }
            }
        }
        if sets_up && self.doubts.setting.is_none() {
            self.doubts.setting = Some(self.line_name(finding));
        }
    }

    /// Whether lines were left open.
    pub(crate) fn has_doubts(&self) -> bool {
        !self.doubts.symbols.is_empty() || self.doubts.setting.is_some()
    }

    /// Notes that nothing in force says any more what a symbol is.
    pub(crate) fn leave_in_doubt(&mut self, symbol: Variable) {
        let entity = self.theory.atoms.entity_of(symbol);
        self.doubts.symbols.extend(entity);
    }

    /// Whether a line that was left open speaks of an entity.
    pub(crate) fn is_in_doubt(&self, entity: Entity) -> bool {
        self.doubts.symbols.contains(&entity)
    }

    /// Why a difference need not be a mistake of this line; `None` where it must be one.
    pub(crate) fn doubt(&mut self, read: &Read) -> Option<String> {
        if self.follows_no_spin(read) {
            return Some("the axes may turn without the spin of the body".to_owned());
        }
        if self.turns_a_lone_wheel(read) {
            return Some("nothing before says along what the spin momentum lies".to_owned());
        }
        if self.since_start(read).is_some() {
            return Some("how the motion begins is not said".to_owned());
        }
        if let Some(name) = self.gives_a_free_square(read) {
            return Some(format!("nothing before determines `{name}`"));
        }
        if self.lacks_energy_of_wheels(read) {
            return Some("nothing before says what energy the wheels have".to_owned());
        }
        let unsaid = self.lies_along_a_direction(read);
        if let Some(name) = unsaid.or_else(|| self.first_said(read)) {
            return Some(format!("nothing before says what `{name}` is"));
        }
        if self.is_at_a_moment() {
            return Some(AT_A_MOMENT.to_owned());
        }
        if let Some(name) = self.untied(read) {
            return Some(format!("nothing before ties `{name}` to the motion"));
        }
        for entry in read.residuals() {
            for variable in self.theory.normal(entry).variables() {
                if self.is_passed_over(variable) {
                    let name = names::latex(&self.theory.atoms, variable);
                    return Some(format!("nothing before says what `{name}` is"));
                }
                for entity in self.entities_in(variable) {
                    if self.doubts.symbols.contains(&entity) {
                        let name = names::latex(&self.theory.atoms, variable);
                        return Some(format!("a line about `{name}` was left open before"));
                    }
                    let owner = &self.theory.atoms.info(entity).owner;
                    let inertia = matches!(owner, Owner::Quantity(Quantity::Inertia, _));
                    // "L = 2m **r** × **v**": it says itself what they are.
                    if inertia
                        && !self.reading.speaks_of(Quantity::Inertia)
                        && self.gives_a_momentum_by_masses(read)
                    {
                        return Some(
                            "nothing before says what the moments of inertia are".to_owned(),
                        );
                    }
                    if let (Owner::Quantity(..), Some(line)) = (owner, &self.doubts.setting) {
                        return Some(format!("{line}, which sets the motion up, was left open"));
                    }
                }
            }
        }
        None
    }

    /// Whether a line gives the momentum by masses: `L = 2m **r** × **v**`.
    fn gives_a_momentum_by_masses(&self, read: &Read) -> bool {
        let owner = |v: Variable| self.theory.atoms.owner(v);
        let mass = |v: &Variable| match owner(*v) {
            Some(Owner::Quantity(quantity, _)) => *quantity == Quantity::Mass,
            Some(Owner::Symbol(name)) => name == "m" || name.starts_with("m "),
            None => false,
        };
        let momentum = |entry: &Fraction| {
            let owner = entry.as_variable().and_then(owner);
            matches!(owner, Some(Owner::Quantity(Quantity::Momentum, _)))
        };
        let [equation] = read.equations.as_slice() else {
            return false;
        };
        equation.left.entries.iter().all(momentum)
            && read
                .residuals()
                .any(|entry| entry.variables().iter().any(mass))
    }

    /// A constant of the document whose power the text gives, ⟨k² = a²/12⟩, and that no rule gives: lines that use it do
    /// not say what it is.
    fn gives_a_free_square(&mut self, read: &Read) -> Option<String> {
        let [equation] = read.equations.as_slice() else {
            return None;
        };
        let left = equation.left.as_scalar()?;
        let &[variable] = left.variables().as_slice() else {
            return None;
        };
        let entity = self.theory.atoms.entity_of(variable)?;
        let info = self.theory.atoms.info(entity);
        let own = matches!(info.owner, Owner::Symbol(_)) && info.constant;
        let free = own
            && !self.displayed
            && left.as_variable().is_none()
            && self.theory.rule(variable).is_none()
            && !self.theory.is_in_relation(entity);
        free.then(|| names::latex(&self.theory.atoms, variable))
    }

    /// A component of a vector **e** of the document in what differs: such a letter is a direction that the words give.
    fn lies_along_a_direction(&mut self, read: &Read) -> Option<String> {
        let entries: Vec<Fraction> = read.residuals().cloned().collect();
        entries.iter().find_map(|entry| {
            let variables = self.theory.normal(entry).variables();
            let direction = |v: &Variable| match *self.theory.atoms.atom(*v) {
                Atom::Part { entity, .. } => {
                    let info = self.theory.atoms.info(entity);
                    let named = matches!(&info.owner, Owner::Symbol(key) if key.starts_with("e "));
                    named && info.shape == Shape::Vector && !self.any_vector
                }
                _ => false,
            };
            let found = variables.into_iter().find(direction)?;
            Some(names::latex(&self.theory.atoms, found))
        })
    }

    /// Whether a variable is a component of the inertia about the mass centre that is left unsaid where others are told:
    /// an author who writes I_xy = 0 of a cuboid means the other products too.
    fn is_passed_over(&self, variable: u32) -> bool {
        let Atom::Part {
            entity, component, ..
        } = *self.theory.atoms.atom(variable)
        else {
            return false;
        };
        let mut pairs = self.theory.setting.parallel_axes.iter().flatten();
        pairs.any(|pair| pair.is_centre(entity))
            && self.theory.mentions_entity(entity)
            && !self.theory.mentions_part(entity, Some(component))
    }

    /// Whether the sentence of the line at hand has named a moment: "released at ⟨θ = π/2⟩, it passes … with".
    fn is_at_a_moment(&self) -> bool {
        let named = |f: &Finding| f.remarks.iter().any(|remark| remark == NAMES_A_MOMENT);
        let near = self.sentence.matches('⟩').count().min(2);
        self.findings.iter().rev().take(near).any(named)
    }

    /// Whether a difference has an angle in it, in a document that writes the vertical on the axes used and gives these
    /// no angular velocity: they may follow the axis of a top and not its spin.
    fn follows_no_spin(&self, read: &Read) -> bool {
        let angle = |v: u32| matches!(self.theory.atoms.atom(v), Atom::Kernel { .. });
        let named = self.reading.speaks_of(Quantity::FrameRate)
            || self.theory.setting.axes == Axes::Turning;
        let mut variables = read.residuals().flat_map(Fraction::variables);
        self.reading.usage.k_alone && !named && variables.any(angle)
    }

    /// A number or matrix of the document alone that stands beside quantities of the theory in what differs, and that
    /// no accepted line connects with them: with another value of it the sides might be equal.
    fn untied(&mut self, read: &Read) -> Option<String> {
        let mut loose = None;
        let mut mechanical = false;
        let tied = self.tied();
        let left = read.equations.iter().flat_map(|e| &e.left.entries);
        let named: BTreeSet<u32> = left.filter_map(Fraction::as_variable).collect();
        for entry in read.residuals() {
            mechanical |= self.has_moment(entry);
            for variable in self.theory.normal(entry).variables() {
                for variable in self.theory.atoms.with_arguments(variable) {
                    let Atom::Part { entity, order, .. } = *self.theory.atoms.atom(variable) else {
                        continue;
                    };
                    let info = self.theory.atoms.info(entity);
                    match &info.owner {
                        Owner::Quantity(_, variant) if variant.is_empty() => mechanical = true,
                        // The moment about some other point follows no law that is known here.
                        _ if self.is_about_another_point(entity) => {
                            mechanical = true;
                            loose = Some(names::latex(&self.theory.atoms, variable));
                        }
                        // Nor does the acceleration of a point of which this line is the first to say what it is.
                        Owner::Quantity(Quantity::Acceleration, _) if named.contains(&variable) => {
                            mechanical = true;
                            loose = Some(names::latex(&self.theory.atoms, variable));
                        }
                        _ if order > 0 && info.shape == Shape::Vector => {
                            let moves_freely = !self.any_vector && !self.rate_is_tied(entity);
                            loose = moves_freely
                                .then(|| names::latex(&self.theory.atoms, variable))
                                .or(loose);
                        }
                        _ if tied.contains(&entity) => {}
                        _ if info.shape != Shape::Vector => {
                            loose = Some(names::latex(&self.theory.atoms, variable));
                        }
                        _ => {}
                    }
                }
            }
        }
        if let Some(name) = self
            .may_rest(read)
            .or_else(|| self.angle_beside_omega(read))
        {
            return Some(name);
        }
        // The law of a force speaks of a particle; how it makes a moment is not known here.
        let owned = |v: u32, quantity: Quantity| {
            let owner = self.theory.atoms.owner(v);
            matches!(owner, Some(Owner::Quantity(found, _)) if *found == quantity)
        };
        let of = |quantity: Quantity| {
            let mut variables = read.residuals().flat_map(Fraction::variables);
            variables.any(|v| owned(v, quantity))
        };
        if of(Quantity::Force) && of(Quantity::Moment) {
            return Some("the force".to_owned());
        }
        loose.filter(|_| mechanical)
    }

    /// The rate of an angle in a difference that has a component of ω too: what turns by the angles is not all said.
    fn angle_beside_omega(&mut self, read: &Read) -> Option<String> {
        let whole = Owner::Quantity(Quantity::AngularVelocity, String::new());
        let mut rate = None;
        let (mut omega, mut angle) = (false, false);
        for entry in read.residuals() {
            for variable in self.theory.normal(entry).variables() {
                angle |= matches!(
                    self.theory.atoms.atom(variable),
                    Atom::Kernel {
                        function: Function::Sin | Function::Cos,
                        ..
                    }
                );
                let Atom::Part { entity, order, .. } = *self.theory.atoms.atom(variable) else {
                    continue;
                };
                let info = self.theory.atoms.info(entity);
                omega |= order == 0 && info.owner == whole;
                let own = matches!(info.owner, Owner::Symbol(_)) && info.shape == Shape::Scalar;
                if own && order > 0 {
                    rate = Some(names::latex(&self.theory.atoms, variable));
                }
            }
        }
        rate.filter(|_| omega && angle)
    }

    /// The rate of a position that alone makes the difference: the point may be one of the body, and nothing says so.
    fn may_rest(&mut self, read: &Read) -> Option<String> {
        let written: Vec<u32> = read.residuals().flat_map(Fraction::variables).collect();
        let from_space = |&v: &u32| matches!(self.theory.atoms.atom(v), Atom::SpaceRate { .. });
        // Who writes the rate on the axes used has it that the point moves there.
        let moves = written.iter().any(|&v| self.is_rate_of_a_point(v));
        if moves || !written.iter().any(from_space) {
            return None;
        }
        let mut rate = None;
        for entry in read.residuals() {
            let rest = self.theory.normal(entry);
            let rates: Vec<u32> = rest
                .variables()
                .into_iter()
                .filter(|&v| self.is_rate_of_a_point(v))
                .collect();
            let without = |(monomial, _): &(Monomial, Rational)| {
                rates.iter().all(|&v| monomial.exponent(v) == 0)
            };
            if rest.numerator().terms().iter().any(without) {
                return None;
            }
            rate = rate.or(rates.first().copied());
        }
        rate.map(|v| names::latex(&self.theory.atoms, v))
    }

    fn is_rate_of_a_point(&self, variable: u32) -> bool {
        let Atom::Part { entity, order, .. } = *self.theory.atoms.atom(variable) else {
            return false;
        };
        let owner = &self.theory.atoms.info(entity).owner;
        order > 0
            && matches!(owner, Owner::Quantity(Quantity::Position, _))
            && !self.rate_is_tied(entity)
    }

    /// Whether a symbol has the letter of the moment or the momentum: the M_P beside an M.
    pub(crate) fn is_about_another_point(&self, entity: Entity) -> bool {
        let laws = |q: &Quantity| matches!(q, Quantity::Moment | Quantity::Momentum);
        let info = self.theory.atoms.info(entity);
        match &info.owner {
            Owner::Quantity(quantity, variant) => laws(quantity) && !variant.is_empty(),
            Owner::Symbol(key) => {
                let letter = key.split(' ').next().unwrap_or_default();
                let quantity = self.reading.quantities.get(&Letter::plain(letter));
                info.shape == Shape::Vector && quantity.is_some_and(laws)
            }
        }
    }

    /// Whether an accepted line has a rate of an entity in it.
    fn rate_is_tied(&self, entity: Entity) -> bool {
        let atoms = &self.theory.atoms;
        let own = |v: u32| atoms.entity_of(v) == Some(entity);
        let rate = |v: u32| match atoms.atom(v) {
            Atom::Part { order, .. } => *order > 0 && own(v),
            Atom::SpaceRate { of, .. } => of.iter().flat_map(Fraction::variables).any(own),
            _ => false,
        };
        let premises = self.theory.premises().iter();
        premises
            .flat_map(|p| &p.residuals)
            .any(|r| r.variables().into_iter().any(rate))
    }

    /// The entity of a variable, or those in the argument of a kernel.
    pub(super) fn entities_in(&self, variable: u32) -> Vec<Entity> {
        let atoms = &self.theory.atoms;
        let inside = atoms.with_arguments(variable).into_iter();
        inside.filter_map(|v| atoms.entity_of(v)).collect()
    }
}
