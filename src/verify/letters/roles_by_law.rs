//! What no word names and its place in a law does: the A, B, C or λ₁, λ₂, λ₃ that stand beside ω₁, ω₂, ω₃ as moments of
//! inertia, and the moment that a rate of the angular momentum is set equal to.

use crate::notation::ast::{Factor, Kind, Node, Operator, Symbol};
use crate::notation::document::Document;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, axis, inner, symbols, undotted};
use crate::verify::values::quantity::Quantity;
use num_traits::ToPrimitive;

/// What multiplies each component of ω alone: a letter, with that component's index or with none.
type Coefficients = [Option<(Letter, bool)>; 3];

impl Reading {
    /// In a document without a letter for the inertia, the letters that multiply ω_1, ω_2 and ω_3 each.
    pub(crate) fn by_coefficients(&mut self, document: &Document) {
        let inertia = |q: &Quantity| *q == Quantity::Inertia;
        let parts = self.components.values().any(|(q, _)| inertia(q));
        if parts || self.quantities.values().any(inertia) {
            return;
        }
        let mut found = Coefficients::default();
        for line in document.lines() {
            let sides = line.sides.iter();
            sides.for_each(|side| self.coefficients(side, &mut found));
        }
        let [Some(first), Some(second), Some(third)] = found else {
            return;
        };
        match (&first, &second, &third) {
            ((a, true), (b, true), (c, true)) if a == b && b == c => {
                self.quantities.insert(first.0, Quantity::Inertia);
            }
            ((a, false), (b, false), (c, false)) if a != c && b != c => {
                self.symmetric = a == b;
                for (place, (letter, _)) in [first, second, third].into_iter().enumerate().rev() {
                    self.components
                        .insert(letter, (Quantity::Inertia, place as u8));
                }
            }
            _ => {}
        }
    }

    /// The vector that a line sets against m**a** is a force, where words stand nearer to "moment" than to "force".
    pub(crate) fn by_force_law(&mut self, document: &Document) {
        let plain = |node: &Node, name: &str, vector: bool| matches!(&inner(node).kind, Kind::Symbol(s) if s.name == name && s.style.vector == vector);
        for line in document.lines() {
            let [left, right] = line.sides.as_slice() else {
                continue;
            };
            let (Kind::Symbol(symbol), Kind::Product(factors)) =
                (&inner(left).kind, &inner(right).kind)
            else {
                continue;
            };
            let [mass, acceleration] = factors.as_slice() else {
                continue;
            };
            let law = plain(&mass.node, "m", false) && plain(&acceleration.node, "a", true);
            let letter = Letter::of(symbol);
            if law && symbol.style.vector && self.quantities.get(&letter) == Some(&Quantity::Moment)
            {
                self.quantities.insert(letter, Quantity::Force);
            }
        }
    }

    /// What a line has as the inertia times ω is the angular momentum, whatever words stand near other letters.
    pub(crate) fn by_momentum_law(&mut self, document: &Document) {
        let found = document.lines().find_map(|line| {
            let [left, right, ..] = line.sides.as_slice() else {
                return None;
            };
            let (Kind::Symbol(symbol), Kind::Product(factors)) =
                (&inner(left).kind, &inner(right).kind)
            else {
                return None;
            };
            let [inertia, rate] = factors.as_slice() else {
                return None;
            };
            let plain = symbol.style.vector && symbol.subscripts.is_empty();
            let law = self.is_inertia(&inertia.node) && self.is_angular_velocity(&rate.node);
            (plain && law && rate.operator == Operator::Juxtaposed).then(|| Letter::of(symbol))
        });
        let Some(letter) = found else { return };
        let all = self.quantities.iter();
        let momenta = all.filter(|(_, quantity)| **quantity == Quantity::Momentum);
        let called: Vec<Letter> = momenta.map(|(letter, _)| letter.clone()).collect();
        if called.is_empty() || called.contains(&letter) {
            return;
        }
        for other in called {
            self.quantities.remove(&other);
        }
        self.quantities.insert(letter, Quantity::Momentum);
    }

    /// The letter of `\Omega = I^{-1}\Pi`, where nothing else is the angular momentum.
    pub(crate) fn by_inverse_momentum_law(&mut self, document: &Document) {
        if self.speaks_of(Quantity::Momentum) {
            return;
        }
        let found = document.lines().find_map(|line| {
            let [left, right, ..] = line.sides.as_slice() else {
                return None;
            };
            let Kind::Product(factors) = &inner(right).kind else {
                return None;
            };
            let [inverse, momentum] = factors.as_slice() else {
                return None;
            };
            let (Kind::Power(base, exponent), Kind::Symbol(symbol)) =
                (&inner(&inverse.node).kind, &inner(&momentum.node).kind)
            else {
                return None;
            };
            let inverse = exponent_of(exponent) == Some(-1) && self.is_inertia(base);
            let plain = symbol.subscripts.is_empty() && symbol.superscripts.is_empty();
            let letter = Letter::of(symbol);
            let free = plain && !self.quantities.contains_key(&letter);
            (free && inverse && self.is_angular_velocity(left)).then_some(letter)
        });
        if let Some(letter) = found {
            self.quantities.insert(letter, Quantity::Momentum);
        }
    }

    /// The letter of the inertia, or its matrix.
    fn is_inertia(&self, node: &Node) -> bool {
        let of_inertia =
            |symbol: &Symbol| self.quantities.get(&Letter::of(symbol)) == Some(&Quantity::Inertia);
        match &inner(node).kind {
            Kind::Symbol(symbol) => of_inertia(symbol) && symbol.subscripts.is_empty(),
            Kind::Matrix(rows) => {
                let square = rows.len() == 3 && rows.iter().all(|row| row.len() == 3);
                square && symbols(node).into_iter().all(of_inertia)
            }
            _ => false,
        }
    }

    /// The vector ω, or the column of its components.
    fn is_angular_velocity(&self, node: &Node) -> bool {
        let of_rate = |symbol: &Symbol| {
            self.quantities.get(&Letter::of(symbol)) == Some(&Quantity::AngularVelocity)
        };
        match &inner(node).kind {
            Kind::Symbol(symbol) => of_rate(symbol) && symbol.subscripts.is_empty(),
            Kind::Matrix(rows) => {
                let column = rows.len() == 3 && rows.iter().all(|row| row.len() == 1);
                let met = symbols(node);
                column && met.len() == 3 && met.into_iter().all(of_rate)
            }
            _ => false,
        }
    }

    /// In a document without a letter for the moment, the one that a line sets against dL/dt.
    pub(crate) fn by_moment_law(&mut self, document: &Document) {
        if self.quantities.values().any(|q| *q == Quantity::Moment) {
            return;
        }
        let found = document.lines().find_map(|line| {
            let [one, other] = line.sides.as_slice() else {
                return None;
            };
            [(one, other), (other, one)]
                .into_iter()
                .find_map(|(moment, rate)| {
                    let Kind::Symbol(symbol) = &inner(moment).kind else {
                        return None;
                    };
                    let letter = Letter::of(symbol);
                    let new = symbol.style.vector && !self.quantities.contains_key(&letter);
                    (new && self.is_rate_of_momentum(rate)).then_some(letter)
                })
        });
        if let Some(letter) = found {
            self.quantities.insert(letter, Quantity::Moment);
        }
    }

    /// `dL/dt`, or a sum with it.
    fn is_rate_of_momentum(&self, node: &Node) -> bool {
        match &inner(node).kind {
            Kind::Sum(terms) => terms
                .iter()
                .any(|term| !term.negative && self.is_rate_of_momentum(&term.node)),
            Kind::TimeDerivative {
                operand, order: 1, ..
            } => {
                let of = |symbol: &Symbol| self.quantities.get(&Letter::of(symbol)).copied();
                matches!(&inner(operand).kind, Kind::Symbol(s) if s.subscripts.iter().all(|s| axis(s).is_none()) && of(s) == Some(Quantity::Momentum))
            }
            _ => false,
        }
    }

    /// Notes the terms `c ω_k`, dots and a unit vector aside.
    fn coefficients(&self, node: &Node, found: &mut Coefficients) {
        if let Kind::Product(factors) = &node.kind
            && let Some((letter, place, indexed)) = self.coefficient(factors)
        {
            found[usize::from(place)].get_or_insert((letter, indexed));
        }
        node.children()
            .for_each(|child| self.coefficients(child, found));
    }

    fn coefficient(&self, factors: &[Factor]) -> Option<(Letter, u8, bool)> {
        let (first, rest) = factors.split_first()?;
        let (second, units) = rest.split_first()?;
        let unit = |factor: &Factor| matches!(&factor.node.kind, Kind::Symbol(s) if s.style.vector || s.style.hat);
        let beside = rest.iter().all(|f| f.operator == Operator::Juxtaposed);
        if !beside || units.len() > 1 || !units.iter().all(unit) {
            return None;
        }
        let (Kind::Symbol(moment), Kind::Symbol(rate)) =
            (&first.node.kind, &undotted(&second.node).kind)
        else {
            return None;
        };
        let place = index(rate)?;
        let turning = self.quantities.get(&Letter::of(rate)) == Some(&Quantity::AngularVelocity);
        let letter = Letter::of(moment);
        let named = self.quantities.contains_key(&letter) || self.components.contains_key(&letter);
        let plain = !moment.style.vector && !moment.style.hat && !self.usage.get(&letter).moving;
        if !turning || named || !plain {
            return None;
        }
        match (moment.subscripts.is_empty(), index(moment)) {
            (true, _) => Some((letter, place, false)),
            (_, Some(own)) if own == place => Some((letter, place, true)),
            _ => None,
        }
    }
}

fn index(symbol: &Symbol) -> Option<u8> {
    match symbol.subscripts.as_slice() {
        [only] => axis(only),
        _ => None,
    }
}

/// An exponent that is a number.
fn exponent_of(node: &Node) -> Option<i64> {
    match &inner(node).kind {
        Kind::Number(number) => number.value.to_i64(),
        Kind::Negate(inside) => exponent_of(inside).map(|value| -value),
        _ => None,
    }
}
