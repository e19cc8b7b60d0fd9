//! Wheels that a line brings in: the momentum of body and wheels, `H = Iω + J_w Ω`, in symbols of the document.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, axis, inner, undotted};
use crate::verify::lines::line::Read;
use crate::verify::theory::{Premise, Taken};
use crate::verify::values::atoms::{Atom, Owner, variable_fraction};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::verdict::{Finding, Role, Verdict};
use num_traits::Zero;

impl Checker<'_> {
    /// In a document about wheels, a momentum that is Iω and more by symbols of the document has that more in the wheels.
    pub(crate) fn brings_wheels(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, _] = sides else { return false };
        if self.theory.setting.gyrostat || !self.reading.speaks_of_wheels {
            return false;
        }
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return false;
        };
        let momentum = self.theory.atoms.quantity(Quantity::Momentum);
        if self.meaning_of(symbol) != Meaning::Whole(momentum) {
            return false;
        }
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return false;
        };
        let rests: Vec<_> = read.residuals().cloned().collect();
        let rests: Vec<_> = rests.iter().map(|rest| self.theory.normal(rest)).collect();
        // The moment of inertia of a wheel alone has a label.
        let own = |v: u32| match self.theory.atoms.owner(v) {
            Some(Owner::Symbol(_)) => true,
            Some(Owner::Quantity(quantity, variant)) => {
                *quantity == Quantity::Inertia && !variant.is_empty()
            }
            None => false,
        };
        let foreign = rests.iter().filter(|rest| !rest.is_zero()).all(|rest| {
            let variables = rest.variables();
            !variables.is_empty() && variables.into_iter().all(own)
        });
        let brings = foreign && rests.len() == 3 && rests.iter().any(|rest| !rest.is_zero());
        brings && self.take_wheels(rests, sides, finding)
    }

    /// Whether the sides differ by the momentum of the wheels alone, which the line thereby hands over: it stands alone
    /// on the left, or what it is stands in symbols of the document.
    pub(crate) fn only_wheels(&mut self, first: &Node, read: &Read) -> bool {
        let own = |owner: &Option<&Owner>| matches!(owner, Some(Owner::Symbol(_)));
        let wheels = |owner: &Option<&Owner>| {
            matches!(owner, Some(Owner::Quantity(Quantity::RelativeMomentum, _)))
        };
        let moment = self.theory.atoms.quantity(Quantity::Moment);
        // Of an equation of motion, what is left is no news of the wheels.
        let alone = matches!(&undotted(first).kind, Kind::Symbol(symbol) if self.meaning_of(symbol).entity() != Some(moment));
        let stored = self.theory.atoms.quantity(Quantity::RelativeMomentum);
        let theirs = self.entities([first]).contains(&stored);
        let (mut met, mut lost) = (false, 0);
        let told = read.residuals().all(|entry| {
            let rest = self.theory.normal(entry);
            let variables = rest.variables();
            let atoms = &self.theory.atoms;
            let owners: Vec<_> = variables.iter().map(|&v| atoms.owner(v)).collect();
            met |= owners.iter().any(wheels);
            let own_one = owners.iter().any(own);
            // The Jσ of a wheel is one term beside what is theirs.
            let one_each = rest.is_polynomial() && rest.numerator().terms().len() == 2;
            let once = rest.as_variable().or_else(|| (-rest).as_variable());
            lost += usize::from(!owners.is_empty() && !own_one);
            // The wheel has what it has along the axis that it lies along.
            let along = |v: Variable| match *self.theory.atoms.atom(v) {
                Atom::Part {
                    component,
                    order: 0,
                    ..
                } => self.reading.wheel_axis == Some(component),
                _ => false,
            };
            let once = once.is_some_and(|v| !along(v) && (theirs || !self.writes_stored_part(v)));
            let told = owners.is_empty() || own_one || alone && once;
            told && (owners.len() <= 2 || one_each) && owners.iter().all(|o| own(o) || wheels(o))
        });
        // A momentum that has lost all of theirs says nothing of them.
        told && met && (lost < 3 || self.is_free_input(first))
    }

    /// Whether the document writes a component of the momentum of the wheels, which a line without it has then lost.
    fn writes_stored_part(&self, variable: Variable) -> bool {
        let Atom::Part { component, .. } = *self.theory.atoms.atom(variable) else {
            return false;
        };
        let reading = &self.reading;
        let stored = |quantity: &Quantity| *quantity == Quantity::RelativeMomentum;
        let letters = reading.quantities.iter().filter(|(_, q)| stored(q));
        let mut indices = letters.filter_map(|(letter, _)| reading.usage.subscripts.get(letter));
        let mut named = reading.components.values();
        indices.any(|met| met.iter().any(|index| axis(index) == Some(component)))
            || named.any(|(q, part)| stored(q) && *part == component)
    }

    /// Whether an expression is the rate of the momentum that the only wheel has along its axis, `J (\dot\omega_3 + \dot\sigma)`:
    /// what its motor gives it.
    pub(crate) fn is_rate_of_wheel(&mut self, right: &Node) -> bool {
        let Some((axis, inertia)) = self.only_wheel() else {
            return false;
        };
        let Ok(value) = self.lowering(Frame::Moving).value(right) else {
            return false;
        };
        let Some(value) = value.as_scalar().cloned() else {
            return false;
        };
        let wheels = self.theory.atoms.quantity(Quantity::RelativeMomentum);
        let body = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let stored = self.theory.atoms.vector(wheels, 1)[usize::from(axis)].clone();
        let turned = self.theory.atoms.vector(body, 1)[usize::from(axis)].clone();
        let rest = value - stored - variable_fraction(inertia) * turned;
        self.theory.normal(&rest).is_zero()
    }

    /// A kinetic energy in which the moment of inertia of the only wheel stands is that of body and wheel: with the
    /// relative momentum J s along an axis, ½ ω·Iω + ω·h + ½ J s² (Hughes, Spacecraft Attitude Dynamics, section 3.4).
    pub(crate) fn note_wheel_energy(&mut self, sides: &[Node]) {
        let [left, right @ ..] = sides else { return };
        if !self.theory.setting.gyrostat || self.knows_energy_of_wheels() {
            return;
        }
        let energy = self.theory.atoms.quantity(Quantity::Energy);
        if self.entities([left]) != [energy] {
            return;
        }
        let Some((axis, inertia)) = self.only_wheel() else {
            return;
        };
        let met = self.entities(right);
        let own = self.theory.atoms.entity_of(inertia);
        if own.is_some_and(|own| met.contains(&own)) {
            self.theory
                .set(|setting| setting.wheel_inertia = Some((axis, inertia)));
        }
    }

    /// The axis along which the relative momentum is a constant times a rate, and that constant.
    fn only_wheel(&mut self) -> Option<(u8, Variable)> {
        let wheels = self.theory.atoms.quantity(Quantity::RelativeMomentum);
        let stored = self.theory.atoms.vector(wheels, 0);
        let stored = stored.each_ref().map(|part| self.theory.normal(part));
        let mut along = (0..3).filter(|&axis| !stored[axis].is_zero());
        let (Some(axis), None) = (along.next(), along.next()) else {
            return None;
        };
        let [one, other] = stored[axis].variables().as_slice().try_into().ok()?;
        let product = variable_fraction(one) * variable_fraction(other);
        let info = |v: Variable| Some(self.theory.atoms.info(self.theory.atoms.entity_of(v)?));
        let moment = |v: Variable| {
            let named = |name: &str| {
                let letter = Letter::plain(name);
                let whole = self.reading.quantities.get(&letter);
                whole == Some(&Quantity::Inertia)
            };
            match info(v).map(|info| &info.owner) {
                Some(Owner::Quantity(quantity, _)) => *quantity == Quantity::Inertia,
                Some(Owner::Symbol(key)) => key.split(' ').next().is_some_and(named),
                None => false,
            }
        };
        let moves = |v: Variable| info(v).is_some_and(|info| !info.constant);
        let inertia = match (moment(one), moment(other)) {
            (true, false) => one,
            (false, true) => other,
            (false, false) if moves(other) && !moves(one) => one,
            (false, false) if moves(one) && !moves(other) => other,
            _ => return None,
        };
        (stored[axis] == product).then_some((axis as u8, inertia))
    }

    fn knows_energy_of_wheels(&self) -> bool {
        let setting = &self.theory.setting;
        setting.wheel_inertia.is_some() || setting.energy_of_parts.is_some()
    }

    /// Whether a difference from the kinetic energy has something of the wheels in it, and nothing says what their own is.
    pub(crate) fn lacks_energy_of_wheels(&mut self, read: &Read) -> bool {
        let energy = self.theory.atoms.quantity(Quantity::Energy);
        let energy = self.theory.atoms.part(energy, 0, 0);
        if !self.theory.setting.gyrostat || self.knows_energy_of_wheels() {
            return false;
        }
        let residuals: Vec<Fraction> = read.residuals().cloned().collect();
        let wheels = self.theory.atoms.quantity(Quantity::RelativeMomentum);
        let stored = self.theory.atoms.vector(wheels, 0);
        let stored = stored.iter().map(|part| self.theory.normal(part));
        let of_wheels: Vec<Variable> = stored.flat_map(|part| part.variables()).collect();
        residuals.iter().any(|residual| {
            let rest = self.theory.normal(residual).variables();
            residual.variables().contains(&energy) && rest.iter().any(|v| of_wheels.contains(v))
        })
    }

    /// Gives the wheels the momentum that is missing beside Iω: what Iω less the right side has, but for the sign.
    pub(crate) fn take_wheels(
        &mut self,
        rests: Vec<Fraction>,
        sides: &[Node],
        finding: &mut Finding,
    ) -> bool {
        self.theory.set(|setting| setting.gyrostat = true);
        let wheels = self.theory.atoms.quantity(Quantity::RelativeMomentum);
        let parts: Vec<Variable> = (0..3)
            .map(|component| self.theory.atoms.part(wheels, component, 0))
            .collect();
        let within: Vec<Variable> = rests.iter().flat_map(Fraction::variables).collect();
        self.let_wheels_change(&within);
        let stored = parts.iter().zip(rests);
        let name = self.line_name(finding);
        let taken = self.theory.assume(Premise {
            name: name.clone(),
            residuals: stored
                .map(|(&v, rest)| variable_fraction(v) + rest)
                .collect(),
            preferred: parts,
            definition: true,
        });
        if taken != Taken::Solved {
            return false;
        }
        self.keep(&name, true);
        self.now_known(sides);
        finding.verdict = Verdict::Accepted;
        finding.role = Role::Given;
        let said = "taken as given: what is beside Iω is in the wheels";
        finding.remarks.push(said.to_owned());
        true
    }
}
