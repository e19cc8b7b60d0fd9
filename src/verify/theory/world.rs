//! A world: a value for every variable, the free ones drawn, the others had from the laws and premises.

use crate::algebra::{Fraction, Polynomial, Rational, Variable};
use crate::notation::ast::Function;
use crate::scalar::Field;
use crate::verify::theory::Theory;
use crate::verify::theory::attitude_law::{UNIT, number_of_quaternion, square_of_scalar_part};
use crate::verify::theory::kept::{Point, Relations};
use crate::verify::theory::kernel_facts::turned;
use crate::verify::values::atoms::{Atom, Entity, Owner};
use crate::verify::values::figures::is_pi;
use crate::verify::values::quantity::{Quantity, Shape};
use std::collections::BTreeSet;

/// Whole multiples of an angle whose sines and cosines are had from those of the angle.
const MOST_TURNS: i64 = 16;

/// A scalar that worlds are made of.
pub(crate) trait Substance: Field {
    /// The scalar of a rational number, where there is one.
    fn lift(value: &Rational) -> Option<Self>;
    /// A square root, where there is one.
    fn root(&self) -> Option<Self>;
    /// A value for a free variable; `kind` tells what range suits it.
    fn draw(kind: Kind, chance: u64) -> Self;
    /// Whether it is below zero, where that has a meaning.
    fn is_negative(&self) -> bool;
    /// The point of a variety that was found for a seed, if points of this kind are remembered.
    fn recall(_: &Relations, _: (usize, u64)) -> Option<Point<Self>> {
        None
    }
    /// Remembers a point of a variety, if points of this kind are.
    fn remember(_: &mut Relations, _: (usize, u64), _: &Point<Self>) {}
    /// The world of a seed, if worlds of this kind are kept.
    fn recall_world(_: &mut Relations, _: u64) -> Option<Drawn<Self>> {
        None
    }
    /// Keeps a world, if worlds of this kind are.
    fn remember_world(_: &mut Relations, _: u64, _: Drawn<Self>) {}
}

/// What a free variable is, as far as a sensible value for it goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A moment of inertia or a mass: positive.
    Positive,
    /// A product of inertia: small.
    Small,
    /// A component of a vector, or a rate: of either sign.
    Signed,
    /// Anything else.
    Any,
    /// A small multiple of one over this.
    Over(i64),
}

/// What is known of a world.
#[derive(Clone, Debug)]
pub(crate) struct Drawn<T> {
    /// By variable.
    values: Vec<Option<T>>,
    state: u64,
    /// Varieties that the world was put on, by their place.
    pub(crate) settled: BTreeSet<usize>,
    /// Variables that relations gave.
    pub(crate) solved: BTreeSet<Variable>,
    /// How often what is known of entities had changed.
    changes: usize,
}

/// A value for every variable that is asked for.
pub(crate) struct World<'a, T> {
    pub(crate) theory: &'a mut Theory,
    pub(crate) drawn: Drawn<T>,
    open: BTreeSet<Variable>,
    pub(crate) seed: u64,
    /// Whether some variety was missed.
    pub(crate) lost: bool,
}

impl<'a, T: Substance> World<'a, T> {
    /// The world that a seed makes; the same seed makes the same world everywhere.
    pub(crate) fn new(theory: &'a mut Theory, seed: u64) -> Self {
        let state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0x5851_F42D_4C95_7F2D;
        let drawn = Drawn {
            values: vec![],
            state,
            settled: BTreeSet::new(),
            solved: BTreeSet::new(),
            changes: theory.atoms.changes(),
        };
        Self::with(theory, seed, drawn)
    }

    fn with(theory: &'a mut Theory, seed: u64, drawn: Drawn<T>) -> Self {
        Self {
            theory,
            drawn,
            open: BTreeSet::new(),
            seed,
            lost: false,
        }
    }

    /// The value of a fraction; `None` where a denominator vanishes or a root does not exist in this world.
    pub(crate) fn fraction(&mut self, fraction: &Fraction) -> Option<T> {
        let bottom = self.polynomial(fraction.denominator())?;
        if bottom.is_zero() {
            return None;
        }
        let top = self.polynomial(fraction.numerator())?;
        // Most denominators are one, and an inverse in the prime field takes a hundred products.
        Some(if bottom.is_one() { top } else { top / bottom })
    }

    pub(crate) fn polynomial(&mut self, polynomial: &Polynomial) -> Option<T> {
        let mut sum = T::zero();
        for (monomial, coefficient) in polynomial.terms() {
            let mut product = T::lift(coefficient)?;
            for (variable, exponent) in monomial.factors() {
                let value = self.variable(variable)?;
                for _ in 0..exponent {
                    product *= value.clone();
                }
            }
            sum += product;
        }
        Some(sum)
    }

    /// The value of a variable.
    pub(crate) fn variable(&mut self, variable: Variable) -> Option<T> {
        if let Some(Some(value)) = self.drawn.values.get(variable as usize) {
            return Some(value.clone());
        }
        let ruled = if self.open.insert(variable) {
            self.theory.rule(variable)
        } else {
            None
        };
        let value = match ruled {
            Some(rule) => self.fraction(&rule.value),
            None => self.on_variety(variable),
        };
        self.open.remove(&variable);
        if self.theory.exhausted || self.lost {
            return None;
        }
        let value = value?;
        self.keep(variable, value.clone());
        Some(value)
    }

    /// The value that a variable has by now.
    pub(crate) fn value(&self, variable: Variable) -> Option<T> {
        self.drawn.values.get(variable as usize).cloned().flatten()
    }

    pub(crate) fn is_known(&self, variable: Variable) -> bool {
        matches!(self.drawn.values.get(variable as usize), Some(Some(_)))
    }

    pub(crate) fn keep(&mut self, variable: Variable, value: T) {
        let place = variable as usize;
        let values = &mut self.drawn.values;
        if values.len() <= place {
            values.resize(place + 1, None);
        }
        values[place] = Some(value);
    }

    fn on_variety(&mut self, variable: Variable) -> Option<T> {
        self.settle(variable)?;
        self.value(variable).or_else(|| self.free(variable))
    }

    /// A value for a variable that nothing rules.
    pub(crate) fn free(&mut self, variable: Variable) -> Option<T> {
        match self.theory.atoms.atom(variable).clone() {
            Atom::Kernel {
                function: Function::Sin | Function::Cos,
                argument,
            } => {
                self.circle(argument);
                self.value(variable)
            }
            Atom::Kernel {
                function: Function::Sqrt,
                argument,
            } => self.fraction(&argument)?.root(),
            Atom::Part { .. } if self.draws_quaternion(variable) => self.quaternion(variable),
            Atom::Part { .. } => Some(T::draw(self.kind(variable), self.chance())),
            // No polynomial in π vanishes unless it is zero, so any value shows a difference; this one is close.
            Atom::Opaque { .. } if is_pi(&self.theory.atoms, variable) => {
                T::lift(&Rational::from((355, 113)))
            }
            _ => Some(T::draw(Kind::Any, self.chance())),
        }
    }

    /// Gives the moments of inertia that nothing rules large values near each other, so that a body exists whatever its
    /// products are: a long one, where the third moment has a value.
    pub(crate) fn widen(&mut self, tensor: &[Fraction]) {
        let sizes = [12, 60, 300, 2000];
        let size = sizes[self.seed as usize % sizes.len()];
        for (axis, entry) in (0..).zip(tensor.iter().step_by(4)) {
            if let Some(moment) = entry.as_variable()
                && self.theory.rule(moment).is_none()
                && let Some(value) = T::lift(&Rational::from(size + axis))
            {
                self.keep(moment, value);
            }
        }
    }

    /// What a free variable is.
    pub(crate) fn kind(&self, variable: Variable) -> Kind {
        let Atom::Part {
            entity,
            component,
            order,
        } = *self.theory.atoms.atom(variable)
        else {
            return Kind::Any;
        };
        match self.theory.atoms.info(entity).owner {
            Owner::Quantity(Quantity::Inertia, _) if component >= 3 => Kind::Small,
            Owner::Quantity(Quantity::Inertia | Quantity::Mass, _) if order == 0 => Kind::Positive,
            _ if order > 0 || self.theory.atoms.info(entity).shape == Shape::Vector => Kind::Signed,
            _ => Kind::Any,
        }
    }

    /// A point of the unit circle, (2u, 1 − u²)/(1 + u²), for the sine and cosine of one angle.
    fn circle(&mut self, argument: Fraction) {
        if let Some((turns, angle)) = turns_of(&argument) {
            return self.turned_circle(argument, turns, angle);
        }
        let time = Owner::Quantity(Quantity::Time, String::new());
        let moves = |v: Variable| {
            let info = self
                .theory
                .atoms
                .entity_of(v)
                .map(|e| self.theory.atoms.info(e));
            info.is_some_and(|info| !info.constant || info.owner == time)
        };
        let kind = match argument.variables().into_iter().any(moves) {
            true => Kind::Signed,
            false => Kind::Any,
        };
        let u = T::draw(kind, self.chance());
        let square = u.clone() * u.clone();
        let whole = T::one() + square.clone();
        if whole.is_zero() {
            return;
        }
        let [sin, cos] = self.sine_and_cosine(&argument);
        self.keep(sin, (u.clone() + u) / whole.clone());
        self.keep(cos, (T::one() - square) / whole);
    }

    /// The sine and cosine of 2x by those of x, which may stand beside them.
    fn turned_circle(&mut self, argument: Fraction, turns: i64, angle: Fraction) {
        let [sin, cos] = self.sine_and_cosine(&angle);
        if self.value(sin).is_none() {
            self.circle(angle);
        }
        let Some(one) = self.value(sin).zip(self.value(cos)) else {
            return;
        };
        let (sine, cosine) = turned((T::zero(), T::one()), &one, turns);
        let [sin, cos] = self.sine_and_cosine(&argument);
        self.keep(sin, sine);
        self.keep(cos, cosine);
    }

    fn sine_and_cosine(&mut self, argument: &Fraction) -> [Variable; 2] {
        [Function::Sin, Function::Cos].map(|function| {
            let argument = argument.clone();
            self.theory
                .atoms
                .special(Atom::Kernel { function, argument })
        })
    }

    /// Whether a variable belongs to a unit quaternion that is drawn as a whole; where premises rule some of its numbers,
    /// the scalar part alone is had from the others.
    fn draws_quaternion(&mut self, variable: Variable) -> bool {
        let Some((entity, component)) = number_of_quaternion(&self.theory.atoms, variable) else {
            return false;
        };
        !self.theory.left_out.contains(UNIT) && (component == 0 || !self.is_ruled(entity))
    }

    fn is_ruled(&mut self, quaternion: Entity) -> bool {
        let mut numbers = (0..4)
            .map(|i| self.theory.atoms.part(quaternion, i, 0))
            .collect::<Vec<_>>();
        numbers.drain(..).any(|v| self.theory.rule(v).is_some())
    }

    /// A number of a unit quaternion: all four by three free numbers, [1 − s, 2σ]/(1 + s) with s = σ·σ (the modified
    /// Rodrigues parameters: Schaub and Junkins, Analytical Mechanics of Space Systems, section 3.5).
    fn quaternion(&mut self, variable: Variable) -> Option<T> {
        let (entity, component) = number_of_quaternion(&self.theory.atoms, variable)?;
        if self.is_ruled(entity) {
            let square = square_of_scalar_part(&mut self.theory.atoms, variable)?;
            return self.fraction(&square)?.root();
        }
        let sigma = [0; 3].map(|_| T::draw(Kind::Any, self.chance()));
        let squares = sigma.iter().map(|s| s.clone() * s.clone());
        let square = squares.fold(T::zero(), |sum, s| sum + s);
        let whole = T::one() + square.clone();
        if whole.is_zero() {
            return None;
        }
        let [x, y, z] = sigma.map(|s| (s.clone() + s) / whole.clone());
        let numbers = [(T::one() - square) / whole, x, y, z];
        for (i, number) in (0..4).zip(&numbers) {
            let variable = self.theory.atoms.part(entity, i, 0);
            self.keep(variable, number.clone());
        }
        numbers.get(usize::from(component)).cloned()
    }

    /// The next number of the sequence (splitmix64: Steele, Lea, Flood 2014).
    pub(crate) fn chance(&mut self) -> u64 {
        let state = &mut self.drawn.state;
        *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = *state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }
}

impl<'a, T: Substance> World<'a, T> {
    /// The world that a seed makes, with what was drawn in it for other equations since the rules are as they are.
    pub(crate) fn resumed(theory: &'a mut Theory, seed: u64) -> Self {
        let known = T::recall_world(&mut theory.solution.relations, seed);
        match known.filter(|drawn| drawn.changes == theory.atoms.changes()) {
            Some(drawn) => Self::with(theory, seed, drawn),
            None => Self::new(theory, seed),
        }
    }

    /// Keeps what was drawn, unless the world was given up.
    pub(crate) fn leave(self) {
        if !self.lost && !self.theory.exhausted {
            T::remember_world(&mut self.theory.solution.relations, self.seed, self.drawn);
        }
    }
}

/// The whole number of times that an angle goes into an argument, if that is more than one, and the angle.
fn turns_of(argument: &Fraction) -> Option<(i64, Fraction)> {
    let content = argument.numerator().content();
    let turns = content
        .to_integer()
        .filter(|n| n.abs() > 1 && n.abs() <= MOST_TURNS)?;
    Some((
        turns,
        argument.clone() / Fraction::from(Polynomial::constant(content)),
    ))
}
