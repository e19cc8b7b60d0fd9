//! Lines that hand a value over: the mass, the moments of inertia, how fast the body turns.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{inner, symbols, undotted};
use crate::verify::lines::line::Read;
use crate::verify::reason;
use crate::verify::theory::decide::{Equation, passes_filter};
use crate::verify::values::atoms::{Entity, Owner, variable_fraction};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::symbol::Meaning;
use crate::verify::verdict::{Finding, Role, Verdict};
use crate::verify::words::book::lowered;
use num_traits::{One, Zero};

/// Quantities that a problem hands over.
pub(crate) const INPUTS: &[Quantity] = &[
    Quantity::Inertia,
    Quantity::AngularVelocity,
    Quantity::FrameRate,
    Quantity::RelativeMomentum,
    Quantity::OriginVelocity,
    Quantity::Position,
    Quantity::Mass,
];

/// Words of what acts on a body.
const LOADS: &[&str] = &["torque", "moment", "couple", "thruster"];

impl Checker<'_> {
    /// Whether a line only hands over what nothing determines: the mass, a moment of inertia, the angular velocity, by
    /// numbers or by symbols that the theory does not know; or the form of the inertia matrix.
    pub(crate) fn is_given(&mut self, sides: &[Node], read: &Read) -> bool {
        let [first, .., last] = sides else {
            return false;
        };
        // Numbers alone are worked out.
        if self.entities(sides).is_empty() {
            return false;
        }
        if self.is_by_own_components(sides) {
            return self.lies_in_a_plane(sides);
        }
        if self.integrates_another(sides)
            || self.mixes_turns(first, last)
            || self.is_of_any_vector(sides)
        {
            return false;
        }
        let mut named = sides.iter().flat_map(symbols);
        let tied = named.any(|symbol| match self.meaning_of(symbol) {
            Meaning::Whole(entity) => self.theory.is_in_relation(entity),
            _ => false,
        });
        if tied {
            return false;
        }
        // What has a name by now does not vanish by being said so again.
        if is_zero(last) && self.is_named(first) {
            return false;
        }
        let wheels = self.theory.setting.gyrostat && self.only_wheels(first, read);
        if wheels
            || self.is_news(first, read)
            || self.is_load(sides, read)
            || self.gives_momentum(sides)
            || self.narrows_the_body(sides, read)
            || self.fills_in_inertia(sides, read)
            || self.names_entries_anew(sides, read)
            || self.writes_load_out(read)
        {
            return true;
        }
        let zero = is_zero(last);
        let number = zero || is_in_digits(last);
        if number && !zero && !self.asserted && self.is_data_of_inputs(first) {
            return true;
        }
        if number && !self.asserted && !self.firm && self.is_any_moment(first, zero) {
            return true;
        }
        // "A moment about axis 1 alone acts, so ⟨M_2 = M_3 = 0⟩."
        let [loads @ .., _] = sides else { return false };
        let said = lowered(&self.sentence);
        let of_loads = zero && !self.displayed && LOADS.iter().any(|load| said.contains(load));
        if of_loads && loads.iter().all(|side| self.is_any_moment(side, zero)) {
            return true;
        }
        if number && !zero && !self.asserted && self.is_free_rate(first) {
            return true;
        }
        let derived = zero && (self.asserted && self.displayed || self.obtained);
        let motion = derived && self.sets_motion(first) && !self.stands_beside_motion(first);
        let free = self.is_free_input(first)
            || self.is_free_elsewhere(first, &sides[1..])
            || self.turns_with_an_angle(first);
        if motion || !free || self.is_circular(first, read) {
            return false;
        }
        if sides.len() == 2
            && (self.is_free_input(last)
                || self.is_form_of_inertia(read)
                || self.is_turn_of_axes(first, last))
        {
            return true;
        }
        // `I = ∫ … = Ma²/3` where the integral is twice that.
        let multiple = |equation: &Equation| {
            let sides = equation.left.as_scalar().zip(equation.right.as_scalar());
            sides.is_some_and(|(left, right)| {
                let ratio = self.theory.normal(left) / self.theory.normal(right);
                ratio.to_rational().is_some_and(|ratio| !ratio.is_one())
            })
        };
        if read.equations.iter().skip(1).any(multiple) {
            return false;
        }
        let holds: Vec<bool> = (0..read.equations.len())
            .map(|i| passes_filter(&mut self.theory, &read.equations[i].residual) == Some(true))
            .collect();
        // What equals a side that hands something over does so too: `I_zz = I_xx + I_yy = m r²`.
        let mut handed: Vec<_> = sides.iter().map(|side| self.hands_over(side)).collect();
        for i in (0..holds.len()).rev().filter(|&i| holds[i]) {
            handed[i] = handed[i].max(handed[i + 1]);
        }
        (0..holds.len()).all(|i| {
            let [left, right] = [handed[i], handed[i + 1]];
            holds[i]
                || (left.is_some()
                    && right.is_some()
                    && (left, right) != (Some(false), Some(false)))
                || (self.is_free_input(&sides[i]) && self.is_free_input(&sides[i + 1]))
        })
    }

    /// Whether the rate of a vector that may be any stands in a claim: no law here leaves it free.
    fn is_of_any_vector(&mut self, sides: &[Node]) -> bool {
        let mut rated = vec![];
        sides
            .iter()
            .for_each(|side| operands_of_rates(side, &mut rated));
        self.any_vector
            && self.entities(rated).into_iter().any(|entity| {
                let info = self.theory.atoms.info(entity);
                info.shape == Shape::Vector && matches!(info.owner, Owner::Symbol(_))
            })
    }

    /// Whether a vector or its rate is written out by its own components, of which nothing is handed over.
    fn is_by_own_components(&mut self, sides: &[Node]) -> bool {
        let [left, right] = sides else { return false };
        let mut whole = undotted(left);
        while let Kind::InFrame(inside, _) = &whole.kind {
            whole = undotted(inside);
        }
        let Kind::Symbol(symbol) = &whole.kind else {
            return false;
        };
        let Meaning::Whole(entity) = self.meaning_of(symbol) else {
            return false;
        };
        let met: Vec<Meaning> = symbols(right)
            .into_iter()
            .map(|s| self.meaning_of(s))
            .collect();
        let own = |m: &Meaning| matches!(m, Meaning::Component(e, _) if *e == entity);
        let unit = |m: &Meaning| matches!(m, Meaning::UnitVector(_));
        self.theory.atoms.info(entity).shape == Shape::Vector
            && matches!(inner(right).kind, Kind::Sum(_))
            && met.iter().all(|m| own(m) || unit(m))
            && met.iter().any(own)
    }

    /// Whether a force, or a vector of the document, is written out by its own components but for one or two, of which
    /// nothing is said: these vanish.
    fn lies_in_a_plane(&mut self, sides: &[Node]) -> bool {
        // Of a rate the other components are rates too, and do not vanish by being left out.
        if !matches!(inner(&sides[0]).kind, Kind::Symbol(_)) {
            return false;
        }
        let own = self.entities([&sides[0]]).into_iter().all(|entity| {
            match &self.theory.atoms.info(entity).owner {
                Owner::Quantity(quantity, _) => *quantity == Quantity::Force,
                Owner::Symbol(_) => true,
            }
        });
        let Some(read) = self.read(sides, Frame::Moving).ok().filter(|_| own) else {
            return false;
        };
        let right = read.equations.iter().flat_map(|e| &e.right.entries);
        let written: Vec<u32> = right.flat_map(Fraction::variables).collect();
        let entries: Vec<&Fraction> = read.residuals().filter(|rest| !rest.is_zero()).collect();
        let left_out = |rest: &&Fraction| {
            let part = rest.as_variable().filter(|v| !written.contains(v));
            part.is_some_and(|v| !self.theory.mentions(v))
        };
        let left_out = entries.iter().all(left_out);
        // What a force comes to follows from how the body moves, of which nothing is said.
        let mut loose = |rest: &&Fraction| {
            let normal = self.theory.normal(rest);
            let moves = |v: u32| match self.theory.atoms.owner(v) {
                Some(Owner::Quantity(quantity, _)) => {
                    *quantity != Quantity::Mass && !self.theory.mentions(v)
                }
                _ => false,
            };
            normal == **rest || normal.variables().into_iter().any(moves)
        };
        !entries.is_empty() && left_out && entries.iter().all(&mut loose)
    }

    /// Whether a side has a symbol that the theory does not know, or is a number; `None` where a quantity stands in it
    /// that is no input.
    fn hands_over(&mut self, side: &Node) -> Option<bool> {
        let in_time = self.asserted && self.may_turn_in_time();
        let mut foreign = is_in_digits(side);
        for entity in self.entities([side]) {
            match &self.theory.atoms.info(entity).owner {
                Owner::Symbol(_) => foreign |= self.is_free(entity) || self.is_size(entity),
                Owner::Quantity(quantity, _) if *quantity == Quantity::Mass => foreign = true,
                Owner::Quantity(quantity, _)
                    if INPUTS.contains(quantity)
                        || *quantity == Quantity::Time && (!self.asserted || in_time) => {}
                Owner::Quantity(..) => return None,
            }
        }
        Some(foreign)
    }

    /// Whether a symbol is short for masses and lengths: `\mu = Ma^2/12`.
    fn is_size(&mut self, entity: Entity) -> bool {
        let value = self.theory.atoms.value(entity, 0, 0);
        let normal = self.theory.normal(&value);
        let atoms = &self.theory.atoms;
        let size = |v: u32| match atoms.owner(v) {
            Some(Owner::Symbol(_)) => true,
            Some(Owner::Quantity(quantity, _)) => *quantity == Quantity::Mass,
            None => false,
        };
        normal != value && !normal.is_zero() && normal.variables().into_iter().all(size)
    }

    /// Whether a side is a quantity that an earlier line gives by a symbol of the document.
    fn is_named(&mut self, side: &Node) -> bool {
        if !matches!(inner(side).kind, Kind::Symbol(_)) {
            return false;
        }
        let value = self.lowering(Frame::Moving).value(side);
        let value = value.ok().and_then(|value| value.as_scalar().cloned());
        let Some(own) = value.and_then(|value| value.as_variable()) else {
            return false;
        };
        let name = self.theory.normal(&variable_fraction(own)).as_variable();
        name.is_some_and(|name| {
            name != own && matches!(self.theory.atoms.owner(name), Some(Owner::Symbol(_)))
        })
    }

    /// Whether a side stands for a symbol of the document by an earlier line, and the line says that symbol by itself.
    fn is_circular(&mut self, side: &Node, read: &Read) -> bool {
        let Ok(value) = self.lowering(Frame::Moving).value(side) else {
            return false;
        };
        let own = value.entries.iter().flat_map(Fraction::variables);
        let own: Vec<u32> = own.collect();
        let named = value.entries.iter().map(|entry| self.theory.normal(entry));
        let named: Vec<u32> = named.filter_map(|n| n.as_variable()).collect();
        let other = |v: &u32| !own.contains(v);
        let names = |v: u32| matches!(self.theory.atoms.owner(v), Some(Owner::Symbol(_)));
        let renamed: Vec<u32> = named
            .into_iter()
            .filter(|v| other(v) && names(*v))
            .collect();
        let rights = read.equations.iter().flat_map(|e| e.right.entries.clone());
        let rights: Vec<Fraction> = rights.collect();
        rights.iter().any(|right| {
            let right = self.theory.normal(right);
            right.as_variable().is_none() && right.variables().iter().any(|v| renamed.contains(v))
        })
    }

    /// Whether a side is a symbol of the document that no line has said anything of.
    fn is_new_name(&mut self, side: &Node) -> bool {
        let new = self.new_symbol(side);
        new.is_some_and(|(entity, place)| !self.theory.mentions_part(entity, place))
    }

    /// Takes a line in that hands a value over; where its sentence derives it, it is not checked, and that is said.
    pub(crate) fn given(&mut self, sides: &[Node], finding: &mut Finding) {
        // A new name for what is known holds wherever the name does.
        let names = matches!(sides, [_, right] if self.is_new_name(right));
        let role = if names { Role::Define } else { Role::Given };
        self.pass_name_on(sides, &self.line_name(finding));
        let input = self.is_free_input(&sides[0]);
        let read = self.read(sides, Frame::Moving);
        let flat = read.is_ok_and(|read| self.is_said_of_a_lamina(sides, &read));
        self.accept(sides, role, finding);
        if finding.verdict != Verdict::Accepted {
            return;
        }
        self.drop_second_order();
        let lone = |side: &Node| matches!(inner(side).kind, Kind::Symbol(_));
        let zero = sides.last().is_some_and(is_zero);
        let derived = input && zero && self.asserted && self.displayed;
        // "It is then put at ⟨(x, y) = (1, 2) m⟩": a place in units.
        let place = !self.displayed
            && matches!(&inner(&sides[0]).kind, Kind::Tuple(_))
            && matches!(
                sides.last().map(|side| &side.kind),
                Some(Kind::WithUnit(..))
            );
        if derived && !self.sets_motion(&sides[0]) {
            finding.verdict = Verdict::Undecided;
            finding.reason = Some(reason::TAKEN_AS_GIVEN.to_owned());
        } else if zero {
            // It narrows the case down, for reasons that are not in symbols.
            finding.role = Role::Assume;
            finding.remarks.push("taken as an assumption".to_owned());
        } else if (self.asserted || self.is_equation_of_motion(sides))
            && !sides.iter().all(lone)
            && !place
            && (!self.sets_motion(&sides[0]) || self.speaks_of_time(&sides[1..]))
            && !flat
        {
            finding.verdict = Verdict::Undecided;
            finding.reason = Some(reason::TAKEN_AS_GIVEN.to_owned());
        } else {
            finding.role = Role::Given;
            finding.remarks.push("taken as given".to_owned());
        }
    }
}

/// Whether a side is a number, π included.
pub(crate) fn is_in_digits(side: &Node) -> bool {
    symbols(side).iter().all(|symbol| symbol.name == "pi")
}

/// Whether a side is written as a zero, bold or not.
pub(crate) fn is_zero(side: &Node) -> bool {
    matches!(&side.kind, Kind::Number(n) | Kind::Bold(n) if n.value.is_zero())
}

/// What the rates in a tree are of.
pub(crate) fn operands_of_rates<'n>(node: &'n Node, found: &mut Vec<&'n Node>) {
    match &node.kind {
        Kind::TimeDerivative { operand, .. } => found.push(operand),
        _ => node
            .children()
            .for_each(|child| operands_of_rates(child, found)),
    }
}
