//! What a symbol stands for: its own sentence first, then its labels and marks, then custom.

use crate::notation::ast::{DerivativeStyle, Kind, Node, Symbol};
use crate::notation::print;
use crate::verify::model::system::FrameId;
use crate::verify::term::labels::plain;
use crate::verify::term::letters::{Effect, Letter, Mark, Meaning, spell};
use crate::verify::term::lower::Lowering;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{AT_INSTANT, Basis, Trouble, Value, Valued, beyond};

/// Why the rate of a vector is not read of a mark that speaks of no frame.
const RATE_OF_VECTOR: &str = "a rate that is seen from no frame";

/// Labels that number the axes of whatever frame is meant.
const NUMBERED: [[&str; 3]; 3] = [["x", "y", "z"], ["1", "2", "3"], ["X", "Y", "Z"]];

impl Lowering<'_> {
    /// The value of a symbol, worked out anew.
    pub(super) fn new_symbol(&mut self, symbol: &Symbol) -> Valued {
        let letters = self.letters;
        let exact = spell(symbol, true);
        let number = self.count(&exact);
        if self.occurrences.besides.contains(&(exact.clone(), number))
            && let Some(letter) = letters.besides(&exact, self.at)
        {
            return self.meant(letter, symbol, None);
        }
        if let Some(letter) = letters.find_lone(&exact, &spell(symbol, false), self.at, number) {
            return self.meant(letter, symbol, None);
        }
        if let Some(value) = self.reindexed(symbol)? {
            return Ok(value);
        }
        let numbered = self.by_number(symbol);
        if let Some((letter, false)) = &numbered {
            return self.meant(letter, symbol, None);
        }
        if let Some(value) = self.by_label(symbol)? {
            return Ok(value);
        }
        if let Some((letter, _)) = &numbered {
            return self.meant(letter, symbol, None);
        }
        if let Some(value) = self.by_mark(symbol)? {
            return Ok(value);
        }
        if let Some(value) = self.conjugate(symbol)? {
            return Ok(value);
        }
        if let Some(value) = self.by_custom(symbol) {
            return value;
        }
        self.unknown(symbol)
    }

    /// The value of a letter that a sentence tells.
    fn meant(&mut self, letter: &Letter, symbol: &Symbol, index: Option<(&str, &str)>) -> Valued {
        match &letter.meaning {
            Meaning::Quantity(quantity) => {
                if let Some(frame) = quantity.frame() {
                    self.frames_seen.insert(frame);
                }
                let value = match index {
                    Some((from, to)) => {
                        let text = letter.latex.replace(&format!("_{from}"), &format!("_{to}"));
                        self.letter(&text, &quantity.with_index(from, to))
                    }
                    None => self.letter(&letter.latex, quantity),
                };
                let axis = matches!(quantity, Quantity::Axis(..));
                Ok(self.without_label(value?, symbol, axis))
            }
            Meaning::Same(node) => self.deeper(|lowering| lowering.value(node)),
            Meaning::Change(of) => self.change_of_writing(of.as_deref()),
            Meaning::Time => Ok(Value::scalar(self.system.atoms.time())),
            Meaning::Operator(_) => Err(Trouble::Beyond(format!(
                "`{}` stands without what it acts on",
                letter.latex
            ))),
        }
    }

    /// A symbol of a member, by the letter of another member: what is told of m_i holds for m_j.
    fn reindexed(&mut self, symbol: &Symbol) -> Result<Option<Value>, Trouble> {
        let letters = self.letters;
        for (at, label) in symbol.subscripts.iter().enumerate() {
            let Some((family, to)) = self.system.index_in(label) else {
                continue;
            };
            for from in self.system.families[family].indices.clone() {
                if from == to {
                    continue;
                }
                let mut other = symbol.clone();
                let stem = &label[..label.len() - to.len()];
                other.subscripts[at] = format!("{stem}{from}");
                let (exact, loose) = (spell(&other, true), spell(&other, false));
                let found = letters.find(&exact, &loose, self.at, 0);
                if let Some(letter) = found {
                    return self.meant(letter, symbol, Some((&from, &to))).map(Some);
                }
            }
        }
        Ok(None)
    }

    /// A letter with one label more than a sentence tells of: a component, an entry, components on a frame.
    fn by_label(&mut self, symbol: &Symbol) -> Result<Option<Value>, Trouble> {
        if let Some(value) = self.labelled_by_instant(symbol) {
            return value.map(Some);
        }
        if let Some(label) = symbol.superscripts.last() {
            let mut base = symbol.clone();
            let label = plain(label);
            base.superscripts.pop();
            let effect = self.effect_of(&label, false);
            if let Some(effect) = effect.or_else(|| self.letters.raised_frame(&label)) {
                return match self.known(&base)? {
                    Some((value, _)) => self.affected(value, &effect).map(Some),
                    None => Ok(None),
                };
            }
        }
        let Some(last) = symbol.subscripts.last().map(|l| plain(l)) else {
            return Ok(None);
        };
        // An index without an axis is no letter of its own, and one of things with names numbers no components.
        let end = last.chars().next_back().map(|end| end.to_string());
        let rule = end
            .as_deref()
            .and_then(|letter| self.letters.index(letter, self.at));
        if rule.is_some_and(|rule| rule.members.is_some()) {
            return Ok(None);
        }
        let of_axes = rule.is_some_and(|rule| rule.axes_of.is_some());
        if of_axes && !end.is_some_and(|letter| self.axes.contains_key(&letter)) {
            return Err(Trouble::Beyond(
                "an index that stands for no axis here".into(),
            ));
        }
        let mut base = symbol.clone();
        base.subscripts.pop();
        if let Some(value) = self.component(&base, &last)? {
            return Ok(Some(value));
        }
        if let Some(effect) = self.effect_of(&last, false) {
            // A label of a letter that nothing is told of belongs to the letter.
            return match self.known(&base)? {
                Some((value, _)) => self.affected(value, &effect).map(Some),
                None => Ok(None),
            };
        }
        // The label may be the end of a longer one: `b1` on body axes, `s1`.
        let mut letters = last.chars();
        let Some(end) = letters.next_back().filter(|_| !letters.as_str().is_empty()) else {
            return Ok(None);
        };
        base.subscripts.push(letters.as_str().to_owned());
        self.component(&base, &end.to_string())
    }

    /// What a label of a frame or by a rule does.
    pub(super) fn effect_of(&self, label: &str, on_whole: bool) -> Option<Effect> {
        if let Some(rule) = self.letters.label(label, on_whole, self.at)
            && rule.component.is_none()
        {
            return Some(rule.effect.clone());
        }
        None
    }

    /// What a mark or a label makes of a value.
    pub(super) fn affected(&mut self, value: Value, effect: &Effect) -> Valued {
        Ok(match effect {
            Effect::ComponentsOn(frame) => {
                self.frames_seen.insert(*frame);
                on(value, *frame)
            }
            Effect::RateSeenFrom(frame) => self.system.rate_of_value(&value, *frame)?,
            Effect::Rate if value.is_scalar() => {
                let ground = self.system.ground;
                self.system.rate_of_value(&value, ground)?
            }
            Effect::Rate => return beyond(RATE_OF_VECTOR),
            Effect::CrossProductMatrix => value.cross_product_matrix()?,
            Effect::AtInstant(_) => return beyond(AT_INSTANT),
            Effect::AtBlow(side) => self.at_blow(&value, *side)?,
            Effect::Itself => value,
        })
    }

    /// A component of a vector or an entry of a tensor.
    fn component(&mut self, base: &Symbol, label: &str) -> Result<Option<Value>, Trouble> {
        let Some((axes, frame)) = self.axes_of_label(label) else {
            return Ok(None);
        };
        // A component is no vector: one drawn as such has a number of its own, unless sentences tell of the letter without it.
        let text = print::latex(&symbol_node(base));
        if base.style.vector && self.known.shapes.contains_key(&text) && !self.is_said(base) {
            return Ok(None);
        }
        let Some((value, own)) = self.known(base)? else {
            return Ok(None);
        };
        // A matrix between two frames has no principal moments: with one label it is another letter, `R_3(\psi)` beside `R`.
        let between = value.is_matrix() && value.basis[0] != value.basis[1] && axes.len() == 1;
        if value.is_scalar() || value.is_quaternion() || between {
            return Ok(None);
        }
        let frame = own.or(frame).unwrap_or(self.letters.component_frame);
        self.entry(&value, &axes, frame).map(Some)
    }

    /// Whether a sentence tells of a letter here.
    fn is_said(&self, symbol: &Symbol) -> bool {
        let (exact, loose) = (spell(symbol, true), spell(symbol, false));
        self.letters.find(&exact, &loose, self.at, 0).is_some()
    }

    /// A component or an entry on the axes of a frame. One label of a tensor is a principal moment.
    pub(super) fn entry(&mut self, value: &Value, axes: &[usize], frame: FrameId) -> Valued {
        self.frames_seen.insert(frame);
        // A matrix between two frames has its rows on the one and its columns on the other.
        let between = value.is_matrix() && value.basis[0] != value.basis[1];
        let out = match value.basis.contains(&Basis::Written) {
            true => value.clone(),
            false if between => self.system.written_out(value, frame)?,
            false => self.system.written_out(&on(value.clone(), frame), frame)?,
        };
        let at = |row: usize, column: usize| out.entries.get(row * out.columns + column).cloned();
        let entry = match *axes {
            [axis] if value.is_vector() || value.is_row() => out.entries.get(axis).cloned(),
            [axis] => at(axis, axis),
            [row, column] if value.is_matrix() => {
                let entry = at(row, column);
                let integral = self.letters.customs.integrals
                    && row != column
                    && self.written_as_products(value);
                if integral { entry.map(|e| -e) } else { entry }
            }
            _ => None,
        };
        entry.map(Value::scalar).ok_or_else(|| {
            Trouble::IllTyped(format!(
                "{} has no component with these labels",
                value.shape()
            ))
        })
    }

    /// The axes that a label numbers, and the frame that it names.
    pub(super) fn axes_of_label(&self, label: &str) -> Option<(Vec<usize>, Option<FrameId>)> {
        let rule = self.letters.label(label, false, self.at);
        if let Some((axis, rule)) = rule.and_then(|r| Some((r.component?, r))) {
            let frame = match rule.effect {
                Effect::ComponentsOn(frame) => Some(frame),
                _ => None,
            };
            return Some((vec![axis], frame));
        }
        if let Some(axis) = self.axis_of_letter(label) {
            return Some((
                vec![axis],
                self.letters.index(label, self.at).and_then(|r| r.axes_of),
            ));
        }
        let letters: Vec<String> = label.chars().map(String::from).collect();
        if letters.is_empty() || letters.len() > 2 {
            return None;
        }
        let named = &self.letters.customs.named_axes;
        let axes: Option<Vec<usize>> = letters
            .iter()
            .map(|l| {
                let numbered = NUMBERED
                    .iter()
                    .find_map(|names| names.iter().position(|n| n == l));
                let named = named.get(l).map(|(_, axis)| *axis);
                self.axis_of_letter(l).or(named).or(numbered)
            })
            .collect();
        let rule = self.letters.label(&letters[0], false, self.at);
        let frame = rule.and_then(|r| match (r.component, &r.effect) {
            (Some(_), Effect::ComponentsOn(frame)) => Some(*frame),
            _ => None,
        });
        let frame = frame.or_else(|| named.get(&letters[0]).map(|(frame, _)| *frame));
        axes.map(|axes| (axes, frame))
    }

    /// The axis that an index letter has in this reading of the line.
    pub(super) fn axis_of_letter(&self, letter: &str) -> Option<usize> {
        self.axes.get(letter).copied()
    }

    /// The value of a symbol that sentences tell of, with the frame of its components; `None` where none does.
    pub(super) fn known(
        &mut self,
        symbol: &Symbol,
    ) -> Result<Option<(Value, Option<FrameId>)>, Trouble> {
        let exact = spell(symbol, true);
        let number = self
            .occurrences
            .counts
            .get(&exact)
            .copied()
            .unwrap_or(0)
            .max(1);
        let letters = self.letters;
        let found = letters.find(&exact, &spell(symbol, false), self.at, number);
        let Some(letter) = found else {
            let before = std::mem::replace(&mut self.only_known, true);
            let value = self.reindexed(symbol).and_then(|value| match value {
                Some(value) => Ok(Some(value)),
                None => self.by_label(symbol),
            });
            self.only_known = before;
            let text = print::latex(&symbol_node(symbol));
            if matches!(value, Ok(None) | Err(Trouble::Unknown(_)))
                && self.known.shapes.contains_key(&text)
            {
                let value = self.unknown(symbol)?;
                return Ok(Some((value, None)));
            }
            return match value {
                Ok(value) => Ok(value.map(|value| {
                    let frame = value.frame();
                    (value, frame)
                })),
                Err(Trouble::Unknown(_)) => Ok(None),
                Err(trouble) => Err(trouble),
            };
        };
        let value = self.meant(letter, symbol, None)?;
        let frame = value.frame();
        Ok(Some((value, frame)))
    }

    fn by_mark(&mut self, symbol: &Symbol) -> Result<Option<Value>, Trouble> {
        let mut base = symbol.clone();
        let mark = if symbol.primes > 0 {
            base.primes -= 1;
            Mark::Prime
        } else if symbol.style.tilde {
            base.style.tilde = false;
            Mark::Tilde
        } else if symbol.style.hat {
            base.style.hat = false;
            Mark::Hat
        } else if symbol.style.bar {
            base.style.bar = false;
            Mark::Bar
        } else {
            return Ok(None);
        };
        let Some(effect) = self.letters.mark(mark, self.at).cloned() else {
            return Ok(None);
        };
        if effect == Effect::Rate {
            return self.value(&dotted(&base)).map(Some);
        }
        let value = self.unlabelled(|lowering| match effect {
            Effect::CrossProductMatrix => lowering.vector(&base),
            _ => lowering.symbol(&base),
        })?;
        self.affected(value, &effect).map(Some)
    }

    /// Of what a mark acts on, a rule for writings without a mark says nothing.
    pub(super) fn unlabelled(&mut self, value: impl FnOnce(&mut Self) -> Valued) -> Valued {
        let value = value(self)?;
        match self.letters.mark(Mark::NoLabel, self.at) {
            Some(Effect::ComponentsOn(frame)) if value.vector_basis() == Basis::On(*frame) => {
                Ok(Value {
                    basis: [Basis::Itself; 2],
                    ..value
                })
            }
            _ => Ok(value),
        }
    }
}

/// A value as components on a frame.
pub(super) fn on(value: Value, frame: FrameId) -> Value {
    match value.is_scalar() || value.is_zero() && value.basis == [Basis::Any; 2] {
        true => value,
        false => Value {
            basis: [Basis::On(frame); 2],
            ..value
        },
    }
}

/// The frame that an array is on.
pub(crate) fn symbol_node(symbol: &Symbol) -> Node {
    Node {
        kind: Kind::Symbol(symbol.clone()),
        span: crate::source::Span::default(),
    }
}

/// A letter with a dot.
fn dotted(symbol: &Symbol) -> Node {
    let kind = Kind::TimeDerivative {
        operand: Box::new(symbol_node(symbol)),
        order: 1,
        style: DerivativeStyle::Dots,
        frame: None,
    };
    let span = crate::source::Span::default();
    Node { kind, span }
}
