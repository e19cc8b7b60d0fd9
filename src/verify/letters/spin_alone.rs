//! A rotor whose spin is all that has a momentum, as in the plain account of the gyroscope: `\vec L = I\omega_s\,\hat r` on axes
//! that turn at Ω, and what the turn itself adds is left out.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Line, Node, Symbol};
use crate::notation::document::Document;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::spin_axis::unit_axis;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::theory::Premise;
use crate::verify::values::atoms::Owner;
use crate::verify::values::quantity::Quantity;

/// The name of a premise.
const TURN: &str = "the angular velocity of the axes by its number";

impl Reading {
    /// Takes the momentum for that of a rotor where a line gives it by a moment of inertia, one rate and a unit vector, and
    /// the axes turn at a vector Ω, or at ω where the rate has another letter.
    pub(crate) fn note_spin_alone(&mut self, document: &Document) {
        let directed = |letter: &Letter| self.usage.get(letter).is_directed();
        let of = |quantity: Quantity| {
            let all = self.quantities.iter();
            all.filter(move |(_, q)| **q == quantity).map(|(l, _)| l)
        };
        let [turn, omega] = ["Omega", "omega"].map(Letter::plain);
        let turns_at_omega = self.usage.get(&turn).vector == 0;
        let rates = |(q, _): &(Quantity, u8)| match q {
            Quantity::AngularVelocity => !turns_at_omega,
            q => *q == Quantity::Momentum,
        };
        let by_parts = self.components.values().any(rates);
        let turns = match turns_at_omega {
            true => self.usage.get(&omega).vector > 0,
            false => !directed(&omega),
        };
        if !turns || by_parts || of(Quantity::Inertia).any(directed) {
            return;
        }
        let momentum = |symbol: &Symbol| {
            let whole = symbol.style.vector && symbol.subscripts.is_empty();
            let letter = Letter::of(symbol);
            (whole && self.quantities.get(&letter) == Some(&Quantity::Momentum)).then_some(letter)
        };
        let mut given = vec![];
        for line in document.lines() {
            let [left, right] = line.sides.as_slice() else {
                continue;
            };
            if let Kind::Symbol(symbol) = &inner(left).kind
                && let Some(letter) = momentum(symbol)
            {
                given.push((letter, self.spin(right)));
            }
        }
        let [(letter, Some((moment, rate)))] = given.as_slice() else {
            return;
        };
        if turns_at_omega {
            if Letter::of(rate) == omega {
                return;
            }
            self.quantities.insert(omega, Quantity::FrameRate);
            for (quantity, _) in self.components.values_mut() {
                if *quantity == Quantity::AngularVelocity {
                    *quantity = Quantity::FrameRate;
                }
            }
        }
        // The ω of the spin is a number.
        if rate.subscripts.is_empty() {
            self.quantities.remove(&Letter::of(rate));
        }
        self.quantities
            .insert(letter.clone(), Quantity::RelativeMomentum);
        // No moment of the rotor is one of what carries it.
        self.components.retain(|_, (q, _)| *q != Quantity::Inertia);
        self.moments.clear();
        self.spin_alone = true;
        self.moment_of_spin = Some((*moment).clone());
    }

    /// The factors of a side that is a moment of inertia times a rate along one unit vector.
    fn spin<'n>(&self, side: &'n Node) -> Option<(&'n Symbol, &'n Symbol)> {
        let Kind::Product(factors) = &inner(side).kind else {
            return None;
        };
        let mut symbols = factors
            .iter()
            .map(|factor| match &inner(&factor.node).kind {
                Kind::Symbol(symbol) => Some(symbol),
                _ => None,
            });
        let (Some(moment), Some(rate), Some(axis), None) = (
            symbols.next().flatten(),
            symbols.next().flatten(),
            symbols.next().flatten(),
            symbols.next(),
        ) else {
            return None;
        };
        let round = self.round_axes.as_ref().and_then(|axes| axes.axis(axis));
        let unit = axis.style.hat || unit_axis(axis).or(round).is_some();
        let inertia = |s: &Symbol| {
            let (letter, whole) = (Letter::of(s), Quantity::Inertia);
            let part = self.components.get(&letter).map(|(q, _)| q);
            self.quantities.get(&letter).or(part) == Some(&whole)
        };
        let spin = unit && inertia(moment) && !inertia(rate) && !rate.style.vector;
        spin.then_some((moment, rate))
    }
}

impl Checker<'_> {
    /// Takes a line `\vec\Omega = \Omega\,\hat z` in from the start, where it is the only one of its kind: Ω is that number before
    /// the vector is written too.
    pub(crate) fn turns_at_its_number(&mut self) {
        if !self.reading.spin_alone {
            return;
        }
        let rate = Letter::plain("Omega");
        let named = |line: &&Line| {
            let [left, right] = line.sides.as_slice() else {
                return false;
            };
            let vector = matches!(&inner(left).kind, Kind::Symbol(s) if s.style.vector && Letter::of(s) == rate);
            let Kind::Product(factors) = &inner(right).kind else {
                return false;
            };
            let lone = |node: &Node| matches!(&inner(node).kind, Kind::Symbol(s) if !s.style.vector && s.subscripts.is_empty() && Letter::of(s) == rate);
            vector && factors.len() == 2 && lone(&factors[0].node)
        };
        let mut found = self.document.lines().filter(named);
        let (Some(line), None) = (found.next(), found.next()) else {
            return;
        };
        let Ok(read) = self.read(&line.sides, Frame::Moving) else {
            return;
        };
        let left = read.equations.iter().flat_map(|e| &e.left.entries);
        let preferred = left.flat_map(Fraction::variables).collect();
        self.theory.assume(Premise {
            name: TURN.to_owned(),
            residuals: read.residuals().cloned().collect(),
            preferred,
            definition: true,
        });
    }

    /// Whether a side is the moment of inertia of a spin alone, which no law determines.
    pub(crate) fn is_moment_of_spin(&self, side: &Node) -> bool {
        let moment = self.reading.moment_of_spin.as_ref();
        matches!(&inner(side).kind, Kind::Symbol(symbol) if Some(symbol) == moment)
    }

    /// What the moment on a spin alone determines is how the axes turn.
    pub(crate) fn rates_of_turn(&self, sides: &[Fraction]) -> Vec<Variable> {
        let turns = |v: &Variable| match self.theory.atoms.owner(*v) {
            Some(Owner::Quantity(quantity, _)) => {
                matches!(quantity, Quantity::FrameRate | Quantity::AngularVelocity)
            }
            Some(Owner::Symbol(key)) => key == "Omega number",
            None => false,
        };
        match self.reading.spin_alone {
            true => sides
                .iter()
                .flat_map(Fraction::variables)
                .filter(turns)
                .collect(),
            false => vec![],
        }
    }
}
