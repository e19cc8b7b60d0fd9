//! Three angles that words name, "precession, nutation and spin", "yaw, pitch and roll": what the angular velocity is in
//! their rates.
//!
//! With the turns R = R₁R₂R₃ about the axes a₁, a₂, a₃, the angular velocity on body axes is
//! R₃ᵀR₂ᵀa₁ q̇₁ + R₃ᵀa₂ q̇₂ + a₃ q̇₃ (Goldstein, Poole and Safko, Classical Mechanics, section 4.9). Where the words leave
//! several sequences, or axes, the document's own lines tell which is meant: the one under which most of them hold.

use crate::algebra::{Fraction, Rational, Variable};
use crate::mechanics;
use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, undotted};
use crate::verify::lines::index::is_equality;
use crate::verify::lines::line::Read;
use crate::verify::theory::decide::{Decision, decide, passes_filter};
use crate::verify::theory::law::Axes;
use crate::verify::theory::{Premise, Taken, Theory};
use crate::verify::values::atoms::{Atom, Entity, Owner, variable_fraction};
use crate::verify::values::lower::constant;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::values::value::Value;
use crate::verify::verdict::Finding;
use crate::verify::words::euler_words::{Sequence, leaves_out_the_spin};
use nalgebra::{Matrix3, Vector3};
use num_traits::Zero;
use std::collections::BTreeSet;

/// Lines that are tried against each reading of the angles at most.
const MOST_LINES: usize = 60;
/// Terms that may be written in a document read so: the rates of rates grow fast where a magnitude is made of them.
const MOST_TERMS: usize = 30_000;
/// Letters of angles, in the order in which a body is turned by them; the second is the angle between two axes.
const PRECESSION: [&[&str]; 3] = [&["phi", "varphi"], &["theta", "vartheta"], &["psi"]];
const GREEK: [&[&str]; 3] = [&["alpha"], &["beta"], &["gamma"]];

/// The axes on which ω has the components that a document gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum On {
    /// The axes of the body.
    Body,
    /// Axes that follow the first two turns.
    Nodes,
    /// Axes of fixed orientation.
    Space,
}

/// Three turns, one after the other, with the axes that components are taken on.
#[derive(Clone, Debug)]
pub(crate) struct EulerAngles {
    sequence: Sequence,
    letters: [Letter; 3],
    on: On,
}

impl EulerAngles {
    fn words(&self) -> String {
        let turns = self
            .sequence
            .iter()
            .zip(&self.letters)
            .map(|(&axis, letter)| {
                let axis = ["x", "y", "z"][usize::from(axis) % 3];
                format!("{} about {axis}", letter.name)
            });
        let turns: Vec<String> = turns.collect();
        let on = match self.on {
            On::Body => "body axes",
            On::Nodes => "axes that follow the first two turns",
            On::Space => "axes of fixed orientation",
        };
        format!(
            "angular velocity of the turns {}, on {on}",
            turns.join(", ")
        )
    }
}

impl Checker<'_> {
    /// The reading of the angles that words name under which most lines of the document hold; `None` where no words
    /// name them, where no line holds by it, or where two readings have as many and other lines.
    pub(crate) fn euler_angles(&mut self, sequences: &[Sequence]) -> Option<EulerAngles> {
        let letters = self.three_angles()?;
        self.suppose_a_symmetric_body();
        let spoken = self.lines_of_angles(&letters);
        let mut best: Option<(Vec<bool>, EulerAngles)> = None;
        let mut tied = false;
        for angles in self.allowed(sequences, &letters) {
            let mut theory = self.theory.clone();
            self.put_in(&mut theory, &angles)?;
            let mut holds = |value: &Value| passes_filter(&mut theory, value) == Some(true);
            let held: Vec<bool> = spoken.iter().map(&mut holds).collect();
            let count = |held: &[bool]| held.iter().filter(|held| **held).count();
            let most = best.as_ref().map_or(0, |(best, _)| count(best));
            if count(&held) > most {
                (best, tied) = (Some((held, angles)), false);
            } else if count(&held) == most && best.as_ref().is_some_and(|(best, _)| *best != held) {
                tied = true;
            }
        }
        best.filter(|_| !tied).map(|(_, angles)| angles)
    }

    /// Takes in ahead what lines say of moments that are equal, `I_1 = I_2 = A`, and that the axes are principal where no
    /// product is written.
    fn suppose_a_symmetric_body(&mut self) {
        if self.reading.writes_only_diagonal() {
            self.vanish("principal axes", Quantity::Inertia, &[3, 4, 5]);
        }
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        let lone = |side: &Node| matches!(undotted(side).kind, Kind::Symbol(_));
        for line in self.document.lines() {
            let equal = line.relations.iter().all(|(r, _)| is_equality(*r));
            let of_body = equal
                && line.sides.len() > 1
                && line.sides.iter().all(lone)
                && self.entities(&line.sides).contains(&inertia);
            if !of_body {
                continue;
            }
            let Ok(read) = self.read(&line.sides, Frame::Moving) else {
                continue;
            };
            let residuals: Vec<Fraction> = read.residuals().cloned().collect();
            let preferred = residuals.iter().flat_map(Fraction::variables).collect();
            self.theory.assume(Premise {
                name: "equal moments".to_owned(),
                residuals,
                preferred,
                definition: false,
            });
        }
    }

    /// Takes the angles in: what ω is by their rates.
    pub(crate) fn take_euler_angles(&mut self, angles: &EulerAngles) {
        let mut theory = self.theory.clone();
        if self.put_in(&mut theory, angles).is_some() {
            self.theory = theory;
            self.theory.terms_left = Some(MOST_TERMS);
            let entities: Vec<Entity> = angles
                .letters
                .iter()
                .filter_map(|letter| self.angle(letter))
                .collect();
            self.known.extend(entities);
        }
    }

    /// Proves a line with second rates of the angles on body axes with their rates solved for, and not the components of
    /// ω: Euler's equations then give them.
    pub(crate) fn proved_by_rates_of_angles(&mut self, read: &Read, finding: &mut Finding) -> bool {
        let angles = self.reading.euler_angles.clone();
        let Some(angles) = angles.filter(|angles| angles.on == On::Body) else {
            return false;
        };
        let letters = angles.letters.iter();
        let entities: Vec<Entity> = letters.filter_map(|letter| self.angle(letter)).collect();
        let rate = |v: Variable| matches!(self.theory.atoms.atom(v), Atom::Part { entity, order: 2.., .. } if entities.contains(entity));
        let mut residuals = read.residuals();
        if !residuals.any(|r| r.variables().into_iter().any(rate)) {
            return false;
        }
        let name = angles.words();
        let mut premises = self.theory.premises().iter();
        let Some(mut turns) = premises.find(|p| p.name == name).cloned() else {
            return false;
        };
        let mut theory = self.theory.clone();
        turns.preferred = entities
            .iter()
            .map(|e| theory.atoms.part(*e, 0, 1))
            .collect();
        theory.retain(|premise| premise.name != name);
        theory.assume(turns);
        let Decision::True(proof) = decide(&mut theory, &read.equations) else {
            return false;
        };
        let before = std::mem::replace(&mut self.theory, theory);
        self.proved(read, proof, finding);
        self.theory = before;
        true
    }

    /// Whether a line gives the rate of an angle by the angular velocity, which the angles of the words make already.
    pub(crate) fn gives_rate_of_angle(&mut self, left: &Node, rest: &[Node]) -> bool {
        let Some(angles) = self.reading.euler_angles.clone() else {
            return false;
        };
        let entity = match &undotted(left).kind {
            Kind::Symbol(symbol) => self.entity_named(symbol),
            _ => None,
        };
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let letters = angles.letters.iter();
        let turned: Vec<Entity> = letters.filter_map(|letter| self.angle(letter)).collect();
        entity.is_some_and(|entity| turned.contains(&entity))
            && self.entities(rest).contains(&omega)
    }

    /// The three angles of the document, in the order in which a top is turned by them.
    fn three_angles(&mut self) -> Option<[Letter; 3]> {
        for family in [PRECESSION, GREEK] {
            let used = family.map(|names| {
                let mut letters = names.iter().map(|name| Letter::plain(name));
                letters.find(|letter| self.reading.usage.get(letter).bare > 0)
            });
            let [Some(first), Some(second), Some(third)] = used else {
                continue;
            };
            let letters = [first, second, third];
            let moving = |letter: &&Letter| self.reading.usage.get(letter).moving;
            if letters.iter().filter(moving).count() >= 2
                && letters.iter().all(|letter| self.angle(letter).is_some())
            {
                return Some(letters);
            }
        }
        None
    }

    fn angle(&mut self, letter: &Letter) -> Option<Entity> {
        let symbol = Symbol {
            name: letter.name.clone(),
            ..Symbol::default()
        };
        match self.meaning_of(&symbol) {
            Meaning::Whole(entity) => {
                let own = matches!(self.theory.atoms.info(entity).owner, Owner::Symbol(_));
                own.then_some(entity)
            }
            _ => None,
        }
    }

    /// The readings that the words allow, the likelier first.
    fn allowed(&self, sequences: &[Sequence], [phi, theta, psi]: &[Letter; 3]) -> Vec<EulerAngles> {
        let turning = self.theory.setting.axes == Axes::Turning;
        let axes = match turning || leaves_out_the_spin(self.text) {
            true => [On::Nodes, On::Body, On::Space],
            false => [On::Body, On::Nodes, On::Space],
        };
        let mut all = vec![];
        for &sequence in sequences {
            let orders = [[phi, theta, psi], [psi, theta, phi]];
            // Yaw is ψ and comes first; so does the precession φ.
            let orders = match sequence[0] == sequence[2] {
                true => orders,
                false => [orders[1], orders[0]],
            };
            for on in axes {
                all.extend(orders.iter().map(|letters| EulerAngles {
                    sequence,
                    letters: letters.map(Letter::clone),
                    on,
                }));
            }
        }
        all
    }

    /// Differences of the sides of lines that have rates of the angles, or ω and the angles, and quantities of the theory
    /// alone, and that do not hold already.
    fn lines_of_angles(&mut self, letters: &[Letter; 3]) -> Vec<Value> {
        let angles: BTreeSet<Entity> = letters.iter().filter_map(|l| self.angle(l)).collect();
        let mut found = vec![];
        let mut before: Option<Node> = None;
        for line in self.document.lines() {
            let mut sides = line.sides.clone();
            if let (true, Some(side)) = (line.continues, before.take()) {
                sides.insert(0, side);
            }
            before = sides.last().cloned();
            let Ok(read) = self.read(&sides, Frame::Moving) else {
                continue;
            };
            for equation in read.equations {
                if self.speaks_of(&angles, &equation.residual)
                    && passes_filter(&mut self.theory, &equation.residual) == Some(false)
                {
                    found.push(equation.residual);
                }
            }
            if found.len() >= MOST_LINES {
                break;
            }
        }
        found
    }

    fn speaks_of(&self, angles: &BTreeSet<Entity>, residual: &Value) -> bool {
        let atoms = &self.theory.atoms;
        let (mut rate, mut own) = (false, true);
        for variable in residual.entries.iter().flat_map(Fraction::variables) {
            rate |= matches!(atoms.atom(variable), Atom::Part { entity, order: 1.., .. }
                if angles.contains(entity));
            own &= atoms.with_arguments(variable).into_iter().all(|v| {
                let of_theory =
                    matches!(atoms.owner(v), Some(Owner::Quantity(_, label)) if label.is_empty());
                of_theory
                    || atoms
                        .entity_of(v)
                        .is_some_and(|entity| angles.contains(&entity))
            });
        }
        rate && own
    }

    /// Adds to a theory what ω, and the angular velocity of the axes, are.
    fn put_in(&mut self, theory: &mut Theory, angles: &EulerAngles) -> Option<()> {
        let [body, axes] = self.rates_of(angles)?;
        // Kernels may be new.
        theory.atoms = self.theory.atoms.clone();
        if angles.on == On::Nodes && theory.setting.axes == Axes::Body {
            theory.set(|setting| setting.axes = Axes::Turning);
        }
        let mut given = vec![(Quantity::AngularVelocity, body)];
        if angles.on == On::Nodes {
            given.push((Quantity::FrameRate, axes));
        }
        for (quantity, value) in given {
            let entity = theory.atoms.quantity(quantity);
            let own: Vec<Variable> = (0..3).map(|c| theory.atoms.part(entity, c, 0)).collect();
            let residuals = own.iter().zip(value.iter());
            let taken = theory.assume(Premise {
                name: angles.words(),
                residuals: residuals
                    .map(|(&own, value)| variable_fraction(own) - value.clone())
                    .collect(),
                preferred: own.clone(),
                definition: true,
            });
            if taken == Taken::Contradiction {
                return None;
            }
        }
        Some(())
    }

    /// The axis that the first turn is about, on the axes of a reading.
    pub(crate) fn first_axis(&mut self, angles: &EulerAngles) -> Option<Vector3<Fraction>> {
        let mut axis = Vector3::from_element(Fraction::zero());
        axis[usize::from(angles.sequence[0])] = constant(Rational::from(1));
        let followed = match angles.on {
            On::Body => 3,
            On::Nodes => 2,
            On::Space => 1,
        };
        for (&turn, letter) in angles
            .sequence
            .iter()
            .zip(&angles.letters)
            .take(followed)
            .skip(1)
        {
            let entity = self.angle(letter)?;
            let variable = self.theory.atoms.part(entity, 0, 0);
            let turn = self.elementary(usize::from(turn), variable, 1)?;
            axis = mechanics::apply(&turn.transpose(), &axis);
        }
        Some(axis)
    }

    /// ω, and the angular velocity of axes that follow the first two turns, on the axes of a reading.
    fn rates_of(&mut self, angles: &EulerAngles) -> Option<[Vector3<Fraction>; 2]> {
        let mut rates = vec![];
        let mut turns: Vec<Matrix3<Fraction>> = vec![];
        for (&axis, letter) in angles.sequence.iter().zip(&angles.letters) {
            let entity = self.angle(letter)?;
            let variable = self.theory.atoms.part(entity, 0, 0);
            let mut rate = Vector3::from_element(Fraction::zero());
            rate[usize::from(axis)] = self.theory.atoms.rate(variable);
            rates.push(rate);
            turns.push(self.elementary(usize::from(axis), variable, 1)?);
        }
        let [first, second, third] = rates.as_slice() else {
            return None;
        };
        let [one, two, three] = turns.as_slice() else {
            return None;
        };
        let back = |turn: &Matrix3<Fraction>, vector: &Vector3<Fraction>| {
            mechanics::apply(&turn.transpose(), vector)
        };
        Some(match angles.on {
            On::Nodes => {
                let axes = back(two, first) + second.clone();
                [axes.clone() + third.clone(), axes]
            }
            On::Body => {
                let axes = back(two, first) + second.clone();
                [back(three, &axes) + third.clone(), axes]
            }
            On::Space => {
                let last = mechanics::apply(two, third) + second.clone();
                let whole = first.clone() + mechanics::apply(one, &last);
                [whole.clone(), whole]
            }
        })
    }
}
