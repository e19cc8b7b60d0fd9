//! Values at instants. One instant of a line is looked at as any time: what holds then whenever it is holds at all times.
//! Values at the others are constants of space.

use crate::algebra::{Fraction, Place, Variable};
use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::print;
use crate::verify::model::atoms::{Key, Motion, Space, fraction};
use crate::verify::model::blows::Side;
use crate::verify::model::system::component_text;
use crate::verify::term::labels::plain;
use crate::verify::term::letters::{At, Effect, Letter, Letters, spell, spelled};
use crate::verify::term::lower::Lowering;
use crate::verify::term::symbols::symbol_node;
use crate::verify::term::value::{AT_INSTANT, Basis, Trouble, Value, Valued, beyond};
use num_traits::Zero;

/// At which instant what stands on a line is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Present {
    /// The line speaks of none.
    #[default]
    Untold,
    /// At the one of this number, which is any time.
    Is(usize),
    /// At all that an integral runs over.
    Running,
}

/// Letters of a value at another instant, or of an integral.
#[derive(Clone, Debug)]
pub(crate) struct Kept {
    text: String,
    basis: [Basis; 2],
    letters: Vec<Variable>,
    /// How fast they change, as seen from space.
    rates: Vec<Fraction>,
    /// What they are where that instant is the present one.
    first: Vec<Fraction>,
}

impl Kept {
    /// Each letter with what it is where that instant is the present one.
    pub(crate) fn at_first(&self) -> impl Iterator<Item = (Variable, &Fraction)> {
        self.letters.iter().copied().zip(&self.first)
    }
}

/// A symbol without its last label.
fn unlabelled(symbol: &Symbol) -> Symbol {
    let mut base = symbol.clone();
    base.subscripts.pop();
    base
}

impl Letters {
    /// The number of the instant that a label of a letter means.
    pub(crate) fn instant_of(&self, symbol: &Symbol, at: &At) -> Option<usize> {
        match self.time_of(symbol, at)? {
            Effect::AtInstant(instant) => Some(*instant),
            _ => None,
        }
    }

    /// The side of a blow that a label of a letter means.
    fn side_of(&self, symbol: &Symbol, at: &At) -> Option<Side> {
        match self.time_of(symbol, at)? {
            Effect::AtBlow(side) => Some(*side),
            _ => None,
        }
    }

    /// What a label of a letter says of the time.
    fn time_of(&self, symbol: &Symbol, at: &At) -> Option<&Effect> {
        let label = plain(symbol.subscripts.last()?);
        // A letter of which a sentence tells what it is has the label for a part of its name.
        let own = spell(symbol, true);
        let told = |letter: &Letter| letter.spelled == own && letter.reach.covers(at, 1);
        if self.letters.iter().any(told) {
            return None;
        }
        Some(&self.label(&label, false, at)?.effect)
    }

    /// Whether a formula has a letter with a label that means an instant.
    pub(crate) fn speaks_of_instant(&self, node: &Node, at: &At) -> bool {
        let own = match &node.kind {
            Kind::Symbol(symbol) => self.instant_of(symbol, at).is_some(),
            _ => false,
        };
        own || node.children().any(|part| self.speaks_of_instant(part, at))
    }

    /// The number of the instant that a letter is: the `t_0` that sentences speak of.
    pub(crate) fn instant(&self, node: &Node) -> Option<usize> {
        let own = spelled(node);
        self.instants.iter().position(|instant| *instant == own)
    }
}

impl Lowering<'_> {
    /// `p_0`, where the label means an instant: the value of p then.
    pub(super) fn labelled_by_instant(&mut self, symbol: &Symbol) -> Option<Valued> {
        if let Some(side) = self.letters.side_of(symbol, self.at) {
            let known = self.told(&unlabelled(symbol)).transpose()?;
            return Some(known.and_then(|value| self.at_blow(&value, side)));
        }
        let instant = self.letters.instant_of(symbol, self.at)?;
        let known = match self.known(&unlabelled(symbol)) {
            Ok(known) => known?.0,
            Err(trouble) => return Some(Err(trouble)),
        };
        Some(match self.present {
            Present::Is(present) if present == instant => Ok(known),
            Present::Is(_) | Present::Running => {
                let text = print::latex(&symbol_node(symbol));
                self.kept_from(known, &text)
            }
            Present::Untold => beyond(AT_INSTANT),
        })
    }

    /// A letter that a sentence tells, or with which one tells something else: "B turns about z at the rate `$\\omega$`".
    fn told(&mut self, symbol: &Symbol) -> Result<Option<Value>, Trouble> {
        if let Some((value, _)) = self.known(symbol)? {
            return Ok(Some(value));
        }
        let key = Key {
            space: Space::Unknown,
            ..Key::new(print::latex(&symbol_node(symbol)))
        };
        let atoms = &self.system.atoms;
        let letter = atoms.find(&key).filter(|letter| !atoms.is_unknown(*letter));
        Ok(letter.map(|letter| Value::scalar(fraction(letter))))
    }

    /// A value at a side of a blow.
    pub(super) fn at_blow(&mut self, value: &Value, side: Side) -> Valued {
        let entries = value.entries.iter();
        let then: Option<Vec<Fraction>> = entries
            .map(|entry| self.system.at_blow(entry, side))
            .collect();
        match then {
            Some(entries) => Ok(value.with_entries(entries)),
            None => beyond(AT_INSTANT),
        }
    }

    /// `\dot\theta_0`, where the label means a side of a blow: the rate is taken before its value there.
    pub(super) fn rate_at_blow(&self, operand: &Node) -> Option<(Node, Side)> {
        let Kind::Symbol(symbol) = &operand.kind else {
            return None;
        };
        let side = self.letters.side_of(symbol, self.at)?;
        let node = symbol_node(&unlabelled(symbol));
        Some((node, side))
    }

    /// A letter on a line that speaks of instants, which changes, and no label says at which of them it is taken.
    pub(super) fn stands_at_no_instant(&mut self, symbol: &Symbol, value: &Value) -> bool {
        let told = self.letters.instant_of(symbol, self.at).is_some();
        !told && matches!(self.present, Present::Is(_)) && self.changes(value)
    }

    pub(super) fn changes(&mut self, value: &Value) -> bool {
        let ground = self.system.ground;
        let rate = self.system.rate_of_value(value, ground);
        rate.map_or(true, |rate| !rate.is_zero())
    }

    /// What a value was at another instant: it does not change any more, as seen from space.
    fn kept_from(&mut self, value: Value, text: &str) -> Valued {
        if !self.changes(&value) {
            return Ok(value);
        }
        let zeros = vec![Fraction::zero(); value.entries.len()];
        let now = value.entries.clone();
        self.moving(&value, text, &zeros, now)
    }

    /// ∫ f dt from one instant to the present one: it is zero at the first and changes at the rate f.
    pub(super) fn integral_in_time(&mut self, node: &Node) -> Option<Valued> {
        let Kind::Integral {
            integrand,
            variable,
            limits: Some((from, to)),
        } = &node.kind
        else {
            return None;
        };
        let from = self.letters.instant(from)?;
        let time =
            matches!(&variable.kind, Kind::Symbol(s) if s.name == "t" && s.subscripts.is_empty());
        let present = Some(self.present) == self.letters.instant(to).map(Present::Is);
        if !time || !present {
            return None;
        }
        let empty = self.present == Present::Is(from);
        let present = std::mem::replace(&mut self.present, Present::Running);
        let value = self.value(integrand);
        self.present = present;
        if empty {
            let zero = |value: Value| {
                let zeros = vec![Fraction::zero(); value.entries.len()];
                value.with_entries(zeros)
            };
            return Some(value.map(zero));
        }
        Some(value.and_then(|value| {
            let text = self.source.slice(node.span).to_owned();
            let rates = value.entries.clone();
            let zeros = vec![Fraction::zero(); rates.len()];
            self.moving(&value, &text, &rates, zeros)
        }))
    }

    /// A value of new letters in the shape of another: how fast they change as seen from space, and what they are at the
    /// first instant in letters of the present.
    fn moving(
        &mut self,
        shape: &Value,
        text: &str,
        rates: &[Fraction],
        first: Vec<Fraction>,
    ) -> Valued {
        let same = |kept: &&Kept| {
            let writing = kept.text == text && kept.basis == shape.basis;
            writing && kept.rates == rates && kept.first == first
        };
        let of = |letters: &[Variable]| letters.iter().map(|v| fraction(*v)).collect();
        if let Some(kept) = self.known.kept.iter().find(same) {
            return Ok(shape.with_entries(of(&kept.letters)));
        }
        // One writing may stand for several things in a document.
        let marks = "'".repeat(self.known.kept.iter().filter(|k| k.text == text).count());
        let atoms = &mut self.system.atoms;
        let letters = (0..shape.entries.len()).map(|at| {
            let key = Key::of_number(component_text(&format!("{text}{marks}"), at));
            atoms.variable(key, Place::Coordinate, Motion::Constant)
        });
        let letters: Vec<Variable> = letters.collect();
        let value = shape.with_entries(of(&letters));
        // So far they are constant on the axes on which all is worked out, and what is seen from space is due to these.
        let ground = self.system.ground;
        let turning = self.system.rate_of_value(&value, ground)?;
        for (at, letter) in letters.iter().enumerate() {
            let rate = rates[at].clone() - turning.entries[at].clone();
            if !rate.is_zero() {
                self.system.atoms.atom_mut(*letter).motion = Motion::Rate(rate);
            }
        }
        self.known.kept.push(Kept {
            text: text.to_owned(),
            basis: shape.basis,
            letters,
            rates: rates.to_vec(),
            first,
        });
        Ok(value)
    }
}
