//! A spin that is carried round, as in plain accounts of the gyroscope: `\vec L = I\vec\omega`, `\vec\tau = \vec\Omega\times\vec L` and, at right
//! angles, `\tau = \Omega I\omega`. What carries the rotor has no inertia of its own.
//!
//! The axes used turn with the axle: x lies along it and z along the velocity that it is carried round at. So each of the
//! numbers is a component of its vector.

use crate::notation::ast::{Factor, Kind, Node, Operator, Symbol};
use crate::notation::document::Document;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, axis, inner};
use crate::verify::values::atoms::{Atoms, Entity, Owner};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::symbol::Meaning;
use crate::verify::words::text::Text;

/// Words of an axle that is carried round.
const CARRIED: &[&str] = &["precess", "gyroscop", "carried round", "goes round"];
/// Words of right angles between the axle and the velocity that it is carried round at.
const SQUARE: &[&str] = &[
    "perpendicular",
    "right angle",
    "orthogonal",
    "horizontal axle",
    "horizontal axis",
    "axle is horizontal",
    "axis is horizontal",
];

/// The symbols of such a document, but for the mark of a vector.
#[derive(Clone, Debug)]
pub(crate) struct CarriedSpin {
    momentum: Symbol,
    turn: Symbol,
    spin: Symbol,
    moment: Option<Letter>,
    /// The momentum, and the moment of inertia times the spin.
    pub(crate) law: [Node; 2],
}

/// The vector of the spin.
pub(crate) fn vector_of_spin(atoms: &mut Atoms) -> Entity {
    let owner = Owner::Symbol("the spin of the rotor".to_owned());
    atoms.entity(&owner, Shape::Vector, true, "\\omega_s")
}

/// Whether a quantity is how a body turns, or the momentum of that.
fn is_of_turning(quantity: Quantity) -> bool {
    matches!(
        quantity,
        Quantity::Momentum | Quantity::AngularVelocity | Quantity::FrameRate
    )
}

impl CarriedSpin {
    /// What a symbol stands for, where it is one of these.
    pub(crate) fn meaning(&self, symbol: &Symbol, atoms: &mut Atoms) -> Option<Meaning> {
        let (entity, along) = if same(symbol, &self.momentum) {
            (atoms.quantity(Quantity::RelativeMomentum), 0)
        } else if same(symbol, &self.turn) {
            (atoms.quantity(Quantity::FrameRate), 2)
        } else if same(symbol, &self.spin) {
            (vector_of_spin(atoms), 0)
        } else if symbol.subscripts.is_empty() && Some(Letter::of(symbol)) == self.moment {
            (atoms.quantity(Quantity::Moment), 1)
        } else {
            return None;
        };
        let bare = symbol.superscripts.is_empty() && symbol.primes == 0 && !symbol.style.hat;
        bare.then_some(match symbol.style.vector {
            true => Meaning::Whole(entity),
            false => Meaning::Component(entity, along),
        })
    }
}

fn same(one: &Symbol, other: &Symbol) -> bool {
    one.name == other.name && one.subscripts == other.subscripts
}

impl Reading {
    /// Finds a momentum that is a moment of inertia times a spin, and the velocity that stands beside it in a cross
    /// product: of another letter, or with another label.
    pub(crate) fn note_carried_spin(&mut self, text: &Text) {
        let said = text.says(CARRIED) && text.says(SQUARE);
        if !said || self.spin_alone || self.writes_components_or_tensors() {
            return;
        }
        let document: &Document = text;
        let sides: Vec<&Node> = document.lines().flat_map(|line| &line.sides).collect();
        let mut crossed: Vec<(Symbol, Symbol)> = vec![];
        sides
            .iter()
            .for_each(|side| self.crossed(side, &mut crossed));
        crossed.dedup();
        let [(momentum, turn)] = crossed.as_slice() else {
            return;
        };
        let mut spins = document.lines().filter_map(|line| {
            let spin = self.spin_of(&line.sides, momentum)?;
            Some((spin, [&line.sides[0], &line.sides[1]]))
        });
        let Some((spin, law)) = spins.next() else {
            return;
        };
        let spin = plain(spin);
        if same(&spin, turn)
            || spins.any(|(other, _)| !same(other, &spin))
            || self.usage.moves(&spin)
        {
            return;
        }
        let moment = self
            .quantities
            .iter()
            .find(|(_, q)| **q == Quantity::Moment);
        let moment = moment.map(|(letter, _)| letter.clone());
        let own = [&momentum, &turn, &&spin].map(|symbol| Letter::of(symbol));
        self.carried_spin = Some(CarriedSpin {
            momentum: momentum.clone(),
            turn: turn.clone(),
            spin,
            moment,
            law: law.map(Node::clone),
        });
        self.quantities.retain(|letter, q| {
            !own.contains(letter) && !is_of_turning(*q) && *q != Quantity::Inertia
        });
        self.quantities
            .insert(own[0].clone(), Quantity::RelativeMomentum);
        self.components.retain(|_, (q, _)| *q != Quantity::Inertia);
        self.moments.clear();
        self.rotor_alone = true;
    }

    /// Whether what turns or its inertia has more than one number: components, a tensor, unit vectors.
    fn writes_components_or_tensors(&self) -> bool {
        let by_parts = self.components.values().any(|(q, _)| is_of_turning(*q));
        let mut whole = self.quantities.iter();
        let directed = whole.any(|(letter, &q)| {
            let used = self.usage.get(letter);
            let parts = used.tensor + used.component + used.double;
            is_of_turning(q) && parts > 0 || q == Quantity::Inertia && parts + used.vector > 0
        });
        let mut letters = self.usage.letters();
        by_parts || directed || letters.any(|(_, used)| used.hats + used.hatted > 0)
    }

    /// Cross products of the momentum with another vector that is a rate.
    fn crossed(&self, node: &Node, found: &mut Vec<(Symbol, Symbol)>) {
        if let Kind::Product(factors) = &node.kind {
            for pair in factors.windows(2) {
                if pair[1].operator == Operator::Cross {
                    let [one, other] = [vector(&pair[0]), vector(&pair[1])];
                    let both = one.zip(other);
                    found.extend(both.and_then(|(one, other)| self.momentum_and_turn(one, other)));
                }
            }
        }
        node.children().for_each(|child| self.crossed(child, found));
    }

    fn momentum_and_turn(&self, one: &Symbol, other: &Symbol) -> Option<(Symbol, Symbol)> {
        let is = |symbol: &Symbol, wanted: &[Quantity]| {
            let quantity = self.quantities.get(&Letter::of(symbol));
            quantity.is_some_and(|q| wanted.contains(q))
        };
        let turning = [Quantity::AngularVelocity, Quantity::FrameRate];
        let pairs = [(one, other), (other, one)];
        let found = pairs.into_iter().find(|(momentum, turn)| {
            is(momentum, &[Quantity::Momentum]) && (is(turn, &turning) || turn.name == "Omega")
        });
        found.map(|(momentum, turn)| (plain(momentum), plain(turn)))
    }

    /// The spin of a line that gives the momentum, whole or its size, as a moment of inertia times it.
    fn spin_of<'n>(&self, sides: &'n [Node], momentum: &Symbol) -> Option<&'n Symbol> {
        let [left, right, ..] = sides else {
            return None;
        };
        let Kind::Symbol(left) = &inner(left).kind else {
            return None;
        };
        let Kind::Product(factors) = &inner(right).kind else {
            return None;
        };
        let [moment, spin] = factors.as_slice() else {
            return None;
        };
        let lone = |factor: &'n Factor| match &inner(&factor.node).kind {
            Kind::Symbol(symbol) => Some(symbol),
            _ => None,
        };
        let (moment, spin) = (lone(moment)?, lone(spin)?);
        let inertia = self.quantities.get(&Letter::of(moment)) == Some(&Quantity::Inertia)
            || matches!(moment.name.as_str(), "I" | "J");
        let rate = matches!(spin.name.as_str(), "omega" | "Omega" | "n" | "s");
        let alike = left.style.vector == spin.style.vector && !moment.style.vector;
        let label = spin.subscripts.iter().all(|label| axis(label).is_none());
        (same(left, momentum) && inertia && rate && alike && label).then_some(spin)
    }
}

fn vector(factor: &Factor) -> Option<&Symbol> {
    match &inner(&factor.node).kind {
        Kind::Symbol(symbol) if symbol.style.vector => Some(symbol),
        _ => None,
    }
}

fn plain(symbol: &Symbol) -> Symbol {
    let mut symbol = symbol.clone();
    symbol.style.vector = false;
    symbol
}
