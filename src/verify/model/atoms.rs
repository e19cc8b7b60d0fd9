//! The variables of the model: components of quantities, their rates, and what the laws say of them.
//!
//! A variable is free, or a law gives its value in variables that were there before it: a triangular set. A free
//! variable of the motion has a rate that is free again; one that the frames carry along has a rate that they give.

use crate::algebra::{Fraction, Monomial, Place, Polynomial, Variable};
use crate::verify::model::blows::Side;
use crate::verify::model::changes::Changes;
use crate::verify::model::system::BodyId;
use crate::verify::model::unplaced::Coordinates;
use foldhash::HashMap;
use num_traits::Zero;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// What a variable is: equal keys are the same variable.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Key {
    /// How it is written, in LaTeX, without dots.
    pub(crate) text: String,
    /// How often it was differentiated.
    pub(crate) order: u8,
    /// The index of the member of a family that it belongs to: the `i` of m_i.
    pub(crate) member: Option<String>,
    /// Whose writing it is.
    pub(crate) space: Space,
    /// How many dimensions space has where it is written, if they are not three.
    pub(crate) dimensions: Option<usize>,
    /// The side of a blow at which it is taken.
    pub(crate) blow: Option<Side>,
}

/// Whose writing a key is: the same text may be a quantity of the model, a letter of the document that is told by a law
/// (the n-th thing of that name), and a letter of which nothing is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub(crate) enum Space {
    #[default]
    Model,
    /// A number that a sentence gives a letter of its own.
    Number,
    Letter(u16),
    Unknown,
    /// A product of inertia of this body, whose tensor nobody has told as a whole.
    UntoldProduct(BodyId),
}

impl Key {
    pub(crate) fn new(text: impl Into<String>) -> Self {
        let text = text.into();
        Self {
            text,
            order: 0,
            member: None,
            space: Space::Model,
            dimensions: None,
            blow: None,
        }
    }

    /// The key of a number that a sentence gives a letter of its own.
    pub(crate) fn of_number(text: impl Into<String>) -> Self {
        Self {
            space: Space::Number,
            ..Self::new(text)
        }
    }

    pub(crate) fn of_member(text: impl Into<String>, index: &str) -> Self {
        let member = Some(index.to_owned());
        Self {
            member,
            ..Self::new(text)
        }
    }
}

/// How a variable changes in time.
#[derive(Clone, Debug)]
pub(crate) enum Motion {
    /// It does not.
    Constant,
    /// Freely: its rate is another variable.
    Free,
    /// At this rate.
    Rate(Fraction),
}

/// What a law says: the value of a variable.
#[derive(Clone, Debug)]
pub(crate) struct Law {
    /// The name that appears in `uses`.
    pub(crate) name: &'static str,
    /// The value.
    pub(crate) value: Fraction,
}

/// What stands behind a variable that is no quantity of its own.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Nature {
    /// A quantity.
    Quantity,
    /// A letter of the document of which nothing is known.
    Unknown,
    /// The sum over all members of a family of this product of powers of their variables.
    Sum(Monomial),
    /// The sine of an angle.
    Sine(Fraction),
    /// The cosine of an angle.
    Cosine(Fraction),
    /// The square root of a value.
    Root(Fraction),
    /// The last component of a unit vector, by its square.
    UnitPart(Fraction),
}

/// A variable.
#[derive(Clone, Debug)]
pub(crate) struct Atom {
    pub(crate) key: Key,
    pub(crate) place: Place,
    pub(crate) motion: Motion,
    pub(crate) law: Option<Law>,
    pub(crate) nature: Nature,
    /// Its square, where a relation gives it: s² = 1 − c².
    pub(crate) square: Option<Polynomial>,
    /// The variable that it is the rate of.
    pub(crate) rate_of: Option<Variable>,
    /// Whether it is positive by what it is: a mass, a size, a moment of inertia.
    pub(crate) positive: bool,
}

/// All variables of a document.
#[derive(Clone, Debug, Default)]
pub(crate) struct Atoms {
    // Many documents begin with the same, and most of them bring up nothing else.
    list: Arc<Vec<Atom>>,
    known: Arc<HashMap<Key, Variable>>,
    rates: Arc<HashMap<Variable, Fraction>>,
    /// Letters that are told to be lengths: of what they are the root.
    pub(super) lengths: Vec<(Fraction, Variable)>,
    /// Letters that are no less than zero because they are lengths.
    sized: BTreeSet<Variable>,
    /// Sines of which a sentence tells that they are no less than zero, or less.
    pub(super) signed: BTreeMap<Variable, bool>,
    /// Letters that sentences say to be small.
    pub(super) small: BTreeSet<Variable>,
    /// Coordinates of points of which no sentence tells where they lie.
    pub(super) unplaced: BTreeSet<Variable>,
    pub(super) coordinates: Coordinates,
    /// Letters that are constant by custom alone, and whether something tells that they change after all.
    pub(super) by_custom: BTreeMap<Variable, bool>,
    /// How many dimensions space has here, if they are not three: one writing is another variable there.
    pub(crate) dimensions: Option<usize>,
    pub(super) changes: Changes,
}

/// A variable as a fraction.
pub(crate) fn fraction(variable: Variable) -> Fraction {
    Fraction::from(Polynomial::variable(variable))
}

/// A whole number as a fraction.
pub(crate) fn whole(number: i64) -> Fraction {
    Fraction::from_ratio(number, 1)
}

/// A rate is made of no more products of terms.
const MOST_PRODUCTS: usize = 200_000;

impl Atoms {
    /// The variable with this key, made free where there is none yet.
    pub(crate) fn variable(&mut self, key: Key, place: Place, motion: Motion) -> Variable {
        let dimensions = self.dimensions;
        self.entered(Key { dimensions, ..key }, place, motion)
    }

    fn entered(&mut self, key: Key, place: Place, motion: Motion) -> Variable {
        if let Some(&known) = self.known.get(&key) {
            return known;
        }
        let variable = self.list.len() as Variable;
        Arc::make_mut(&mut self.known).insert(key.clone(), variable);
        self.changes.note(variable);
        Arc::make_mut(&mut self.list).push(Atom {
            key,
            place,
            motion,
            law: None,
            nature: Nature::Quantity,
            square: None,
            rate_of: None,
            positive: false,
        });
        variable
    }

    pub(crate) fn find(&self, key: &Key) -> Option<Variable> {
        let dimensions = self.dimensions;
        let key = Key {
            dimensions,
            ..key.clone()
        };
        self.known.get(&key).copied()
    }

    pub(crate) fn atom(&self, variable: Variable) -> &Atom {
        &self.list[variable as usize]
    }

    pub(crate) fn atom_mut(&mut self, variable: Variable) -> &mut Atom {
        self.changes.note(variable);
        &mut Arc::make_mut(&mut self.list)[variable as usize]
    }

    pub(crate) fn len(&self) -> usize {
        self.list.len()
    }

    /// All from one on.
    pub(super) fn from(&self, first: usize) -> &[Atom] {
        self.list.get(first..).unwrap_or_default()
    }

    /// Puts these in the place of all from one on, of which they are the first ones, later.
    pub(super) fn replace_from(&mut self, first: usize, added: &[Atom]) {
        let before = self.list.len();
        let list = Arc::make_mut(&mut self.list);
        list.truncate(first);
        list.extend_from_slice(added);
        let (known, rates) = (
            Arc::make_mut(&mut self.known),
            Arc::make_mut(&mut self.rates),
        );
        for variable in before as Variable..list.len() as Variable {
            let Atom { key, rate_of, .. } = &list[variable as usize];
            known.insert(key.clone(), variable);
            if let Some(of) = *rate_of {
                rates.insert(of, fraction(variable));
            }
        }
    }

    /// Leaves out the first numbers, by which other variables of the document are called.
    pub(crate) fn begin_at(&mut self, first: usize) {
        while self.list.len() < first {
            let key = Key::new(format!("\\text{{{}}}", self.list.len()));
            self.variable(key, Place::Parameter, Motion::Constant);
        }
    }

    /// A letter whose value a law gives. One letter may stand for several things in a document.
    pub(crate) fn determined(&mut self, text: &str, place: Place, law: Law) -> Variable {
        let mut key = Key::new(text);
        for thing in 0..u16::MAX {
            key.space = Space::Letter(thing);
            match self.find(&key) {
                None => break,
                Some(known) => {
                    let same = |l: &Law| {
                        l.value.numerator() == law.value.numerator()
                            && l.value.denominator() == law.value.denominator()
                    };
                    if self.atom(known).law.as_ref().is_some_and(same) {
                        return known;
                    }
                }
            }
        }
        let variable = self.variable(key, place, Motion::Free);
        self.atom_mut(variable).law = Some(law);
        variable
    }

    /// The rate of a variable.
    pub(crate) fn rate(&mut self, variable: Variable) -> Fraction {
        let atom = self.atom(variable);
        match &atom.motion {
            Motion::Constant => return Fraction::zero(),
            Motion::Rate(rate) => return rate.clone(),
            Motion::Free => {}
        }
        if let Some(known) = self.rates.get(&variable) {
            return known.clone();
        }
        let (mut key, law) = (atom.key.clone(), atom.law.clone());
        let place = match atom.place {
            Place::Parameter | Place::Coordinate => Place::Rate,
            _ => Place::Acceleration,
        };
        let nature = atom.nature.clone();
        key.order += 1;
        let rate = self.entered(key, place, Motion::Free);
        self.atom_mut(rate).rate_of = Some(variable);
        self.atom_mut(rate).nature = nature;
        Arc::make_mut(&mut self.rates).insert(variable, fraction(rate));
        if let Some(Law { name, value }) = law {
            let value = self.derivative(&value);
            self.atom_mut(rate).law = Some(Law { name, value });
        }
        fraction(rate)
    }

    /// The variable that is the rate of another, if there is one yet.
    pub(crate) fn known_rate(&self, variable: Variable) -> Option<Variable> {
        match &self.atom(variable).motion {
            Motion::Constant => None,
            Motion::Rate(rate) => rate.as_variable(),
            Motion::Free => self.rates.get(&variable)?.as_variable(),
        }
    }

    /// The rate of a fraction; `None` where it has too many terms.
    pub(crate) fn short_derivative(&mut self, of: &Fraction) -> Option<Fraction> {
        let size = |f: &Fraction| f.numerator().len() * f.denominator().len();
        let own = size(of);
        let rates = of.variables().into_iter().map(|v| size(&self.rate(v)));
        let products: usize = rates.map(|rate| own.saturating_mul(rate)).sum();
        (products <= MOST_PRODUCTS).then(|| self.derivative(of))
    }

    /// The rate of a fraction.
    pub(crate) fn derivative(&mut self, of: &Fraction) -> Fraction {
        let rates = of.variables().into_iter().map(|v| (v, self.rate(v)));
        let rates: Vec<(Variable, Fraction)> = rates.filter(|(_, rate)| !rate.is_zero()).collect();
        let whole = |p: &Polynomial| {
            let parts = rates.iter().filter(|(v, _)| p.degree_in(*v) > 0);
            let parts = parts.map(|(v, rate)| Fraction::from(p.partial(*v)) * rate.clone());
            parts.fold(Fraction::zero(), |sum, part| sum + part)
        };
        let above = whole(of.numerator());
        if of.is_polynomial() {
            return above;
        }
        // By the rule for quotients once for all variables: ẋ/y − x ẏ/y².
        let below = Fraction::from(of.denominator().clone());
        match whole(of.denominator()) {
            fixed if fixed.is_zero() => above / below,
            changes => (above - of.clone() * changes) / below,
        }
    }

    /// Says that a value is positive by what it is, where it is a variable.
    pub(crate) fn set_positive(&mut self, value: &Fraction) {
        if let Some(variable) = value.as_variable() {
            self.atom_mut(variable).positive = true;
        }
    }

    /// Whether a polynomial is positive or negative by what its variables are.
    pub(crate) fn has_sign(&self, of: &Polynomial) -> bool {
        let mut terms = of.terms().iter();
        let first = terms.next().map(|(_, c)| c.is_negative());
        terms.all(|(_, c)| Some(c.is_negative()) == first)
            && of.variables().into_iter().all(|v| self.atom(v).positive)
    }

    /// A letter is a length: the root of its square.
    pub(crate) fn tell_root(&mut self, square: Fraction, letter: Variable) {
        let square = self.with_squares(&square);
        self.changes.note_all();
        self.lengths.push((square, letter));
        self.set_length(letter);
    }

    /// Whether a letter is told to be a length.
    pub(crate) fn is_length(&self, letter: Variable) -> bool {
        self.sized.contains(&letter)
    }

    /// Says that a letter is a length: it is no less than zero.
    pub(crate) fn set_length(&mut self, letter: Variable) {
        self.changes.note_all();
        self.sized.insert(letter);
    }

    /// The angle of which a variable is the sine or cosine.
    pub(crate) fn angle_of(&self, variable: Variable) -> Option<&Fraction> {
        match &self.atom(variable).nature {
            Nature::Sine(angle) | Nature::Cosine(angle) => Some(angle),
            _ => None,
        }
    }

    /// Whether nothing is told of a variable, or of what it is a function of.
    pub(crate) fn is_unknown(&self, variable: Variable) -> bool {
        match &self.atom(variable).nature {
            Nature::Unknown => true,
            Nature::Sine(of) | Nature::Cosine(of) | Nature::Root(of) | Nature::UnitPart(of) => {
                of.variables().into_iter().any(|v| self.is_unknown(v))
            }
            Nature::Sum(of) => of.powers().iter().any(|&(v, _)| self.is_unknown(v)),
            Nature::Quantity => false,
        }
    }

    /// A variable in LaTeX, with its dots.
    pub(crate) fn latex(&self, variable: Variable) -> String {
        let key = &self.atom(variable).key;
        match key.order {
            0 => key.text.clone(),
            order => dotted(usize::from(order), &key.text)
                .unwrap_or_else(|| format!("\\frac{{d^{order}}}{{dt^{order}}} {}", key.text)),
        }
    }
}

/// The marks of the first, second, … rate.
const DOTS: [&str; 4] = ["\\dot", "\\ddot", "\\dddot", "\\ddddot"];

/// A letter with the dots of a rate above it and not above its indices; `None` where there is no such mark.
pub(crate) fn dotted(order: usize, text: &str) -> Option<String> {
    let dots = DOTS.get(order.checked_sub(1)?)?;
    let mut depth = 0i32;
    let end = text.char_indices().find(|&(at, c)| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        depth == 0 && at > 0 && (c == '_' || c == '^')
    });
    let (base, rest) = text.split_at(end.map_or(text.len(), |(at, _)| at));
    Some(format!("{dots}{{{base}}}{rest}"))
}
