//! Derivatives in time and in other things.

use crate::algebra::{Fraction, Place, Variable};
use crate::notation::ast::{DerivativeStyle, FrameLabel, Kind, Node};
use crate::verify::model::system::FrameId;
use crate::verify::term::labels::plain;
use crate::verify::term::letters::{Arguments, Effect, Mark, spell, spelled};
use crate::verify::term::lower::Lowering;
use crate::verify::term::symbols::symbol_node;
use crate::verify::term::value::{Basis, Trouble, Value, Valued, beyond};
use std::collections::BTreeSet;

/// Why a partial derivative is not worked out.
const DRIVEN: &str = "a partial derivative of an acceleration or a load";
const NOT_FREE: &str = "a partial derivative in something that is no free variable";

impl Lowering<'_> {
    /// A derivative in time.
    pub(super) fn time_derivative(
        &mut self,
        operand: &Node,
        order: u8,
        style: DerivativeStyle,
        frame: Option<&FrameLabel>,
    ) -> Valued {
        if let Some((letter, side)) = self.rate_at_blow(operand) {
            let rate = self.time_derivative(&letter, order, style, frame)?;
            return self.at_blow(&rate, side);
        }
        if let Some((letter, above)) = self.frame_above_rate(operand, frame)? {
            return self.time_derivative(&letter, order, style, Some(&above));
        }
        let value = self.value(operand)?;
        self.rate_of(&value, order, style, frame)
    }

    /// "A frame at the upper left of a dotted vector means the rate seen from that frame": the letter without it, and the
    /// frame. A letter that a sentence tells with this label keeps it.
    fn frame_above_rate(
        &mut self,
        operand: &Node,
        frame: Option<&FrameLabel>,
    ) -> Result<Option<(Node, FrameLabel)>, Trouble> {
        let letters = self.letters;
        let Kind::Symbol(symbol) = &operand.kind else {
            return Ok(None);
        };
        // A second label may say what the components are on.
        let ([label], None, true) = (
            symbol.superscripts.as_slice(),
            frame,
            letters.customs.frames_above_rates,
        ) else {
            return Ok(None);
        };
        let mut bare = symbol.clone();
        bare.superscripts.clear();
        let name = plain(label);
        let told = letters.find(&spell(symbol, true), &spell(symbol, false), self.at, 0);
        let ruled = told.is_some() || self.effect_of(&name, false).is_some();
        if ruled || letters.frame(&name).is_none() || self.known(&bare)?.is_none() {
            return Ok(None);
        }
        let (text, span) = (label.clone(), operand.span);
        Ok(Some((symbol_node(&bare), FrameLabel { text, span })))
    }

    /// The rate of a value, as seen from the frame that the writing says.
    pub(super) fn rate_of(
        &mut self,
        value: &Value,
        order: u8,
        style: DerivativeStyle,
        frame: Option<&FrameLabel>,
    ) -> Valued {
        if order > 4 {
            return beyond("a rate this high");
        }
        let (seen, labelled) = match frame {
            Some(label) => (self.frame_of_rate(&plain(&label.text))?, true),
            None => self.customary_rate(mark_of(style)),
        };
        let mut rate = value.clone();
        for _ in 0..order {
            rate = match labelled {
                true => self.seen_from(&rate, seen)?,
                false => self.system.rate_of_value(&rate, seen)?,
            };
        }
        Ok(rate)
    }

    /// Whose rate a derivative without a label is.
    fn customary_frame(&self, mark: Mark) -> FrameId {
        match self.letters.mark(mark, self.at) {
            Some(Effect::RateSeenFrom(frame)) => *frame,
            _ => self.system.ground,
        }
    }

    /// Whose rate a derivative without a label is, and whether it is the rate of the vector itself, whichever axes its
    /// components are on: where that is said of this part of the document alone, and where vectors have components on some
    /// axes only by a rule for all of them.
    fn customary_rate(&self, mark: Mark) -> (FrameId, bool) {
        let seen = matches!(
            self.letters.mark(mark, self.at),
            Some(Effect::RateSeenFrom(_))
        );
        let by_rule = self.letters.mark(Mark::NoLabel, self.at);
        let by_rule = matches!(by_rule, Some(Effect::ComponentsOn(_)));
        let of_part = self.letters.marks_part(mark, self.at);
        (self.customary_frame(mark), of_part || seen && by_rule)
    }

    /// The frame that a label on a derivative names.
    fn frame_of_rate(&self, label: &str) -> Result<FrameId, Trouble> {
        if let Some(Effect::RateSeenFrom(frame)) = self.effect_of(label, true) {
            return Ok(frame);
        }
        // A ring over a vector and a prime behind a bracket have labels of their own: a sentence says what these mean.
        let mark = match label {
            FrameLabel::TURNING => Some(Mark::Ring),
            "\u{2032}" => Some(Mark::Prime),
            _ => None,
        };
        if let Some(mark) = mark
            && let Some(Effect::RateSeenFrom(frame)) = self.letters.mark(mark, self.at)
        {
            return Ok(*frame);
        }
        let named = self.letters.frame(label);
        named.ok_or_else(|| Trouble::Unknown(label.to_owned()))
    }

    /// The rate of the vector itself, whichever axes its components were taken on.
    fn seen_from(&mut self, value: &Value, frame: FrameId) -> Valued {
        let basis = value.basis.map(|basis| match basis {
            Basis::On(_) => Basis::Itself,
            other => other,
        });
        let rate = self.system.rate_of_value(
            &Value {
                basis,
                ..value.clone()
            },
            frame,
        )?;
        Ok(Value {
            basis: value.basis,
            ..rate
        })
    }

    /// A derivative in something other than time.
    pub(super) fn derivative(
        &mut self,
        operand: &Node,
        variables: &[Node],
        partial: bool,
    ) -> Valued {
        let value = self.value(operand)?;
        let [variable] = variables else {
            return beyond("a derivative of higher order in something other than time");
        };
        let by = self.value(variable)?;
        if partial && by == Value::scalar(self.system.atoms.time()) {
            // What is held fixed is for the author to say.
            if self.letters.mark(Mark::Partial, self.at).is_none() {
                return beyond("a partial derivative in time");
            }
            let seen = self.customary_frame(Mark::Partial);
            return self.system.rate_of_value(&value, seen);
        }
        if by.is_scalar() && !partial {
            return self.along_motion(&value, &by);
        }
        self.partial((operand, &value), variable, &by)
    }

    /// df/dx where both move: the quotient of the rates.
    fn along_motion(&mut self, value: &Value, by: &Value) -> Valued {
        let ground = self.system.ground;
        let (top, bottom) = (
            self.system.rate_of_value(value, ground)?,
            self.system.rate_of_value(by, ground)?,
        );
        self.system.quotient(&top, &bottom)
    }

    /// What the author says that ∂f/∂x takes functions of, where that is said; of those that name x no other is looked at.
    fn arguments_with(&mut self, f: &Node, x: &Node, by: &Value) -> Result<Vec<Variable>, Trouble> {
        for list in self.arguments_told(f, x)? {
            let mut arguments = vec![];
            for node in &list.letters {
                arguments.extend(self.value(node)?.entries);
            }
            if by.entries.iter().all(|entry| arguments.contains(entry)) {
                let variables = arguments.iter().filter_map(Fraction::as_variable);
                return Ok(variables.map(|v| self.system.renamed(v)).collect());
            }
        }
        Ok(vec![])
    }

    /// The lists of arguments that are told of f or of everything, those with x first of all. Of a formula that no sentence
    /// names they are known where all lists with x are one.
    fn arguments_told(&self, f: &Node, x: &Node) -> Result<Vec<Arguments>, Trouble> {
        let (f, x) = (spelled(f), spelled(x));
        let all = || self.letters.arguments.iter();
        let own = |list: &&Arguments| list.of.as_ref() == Some(&f);
        let names = |list: &&Arguments| list.letters.iter().any(|node| spelled(node) == x);
        let told: Vec<&Arguments> = match all().find(own) {
            Some(_) => all().filter(own).collect(),
            None if all().any(|list| list.of.is_none()) => {
                all().filter(|list| list.of.is_none()).collect()
            }
            None => {
                let written = |list: &Arguments| -> BTreeSet<String> {
                    list.letters.iter().map(spelled).collect()
                };
                let lists: BTreeSet<_> = all().filter(names).map(written).collect();
                if lists.len() > 1 {
                    return beyond(NOT_FREE);
                }
                all().collect()
            }
        };
        let (naming, others): (Vec<_>, Vec<_>) = told.into_iter().partition(names);
        let chosen = if naming.is_empty() { others } else { naming };
        Ok(chosen.into_iter().cloned().collect())
    }

    /// Whether the equations of motion tell a variable by where and how fast things are: an acceleration, a load.
    fn is_driven(&self, variable: Variable) -> bool {
        self.system.atoms.atom(variable).place == Place::Acceleration
    }

    /// Whether an expression has a coordinate of a point that no sentence places: relations may tell it by the variable.
    fn has_hidden_beside(&self, entry: &Fraction, variable: Variable) -> bool {
        let hidden = |v: Variable| self.system.atoms.is_hidden(v);
        !hidden(variable) && entry.variables().into_iter().any(hidden)
    }

    /// ∂f/∂x, with everything that laws tell put in and all other free variables, or arguments, held fixed.
    fn partial(&mut self, (f, value): (&Node, &Value), x: &Node, by: &Value) -> Valued {
        let kept = self.arguments_with(f, x, by)?;
        let mut expanded = vec![];
        for entry in &value.entries {
            // What a letter depends on of which nothing is told, nobody knows.
            let mut letters = entry.variables().into_iter();
            if letters.any(|letter| self.system.atoms.is_unknown(letter)) {
                return beyond(NOT_FREE);
            }
            match self.system.in_arguments(entry, &kept) {
                Some(entry) => expanded.push(entry),
                None => return beyond(NOT_FREE),
            }
        }
        let mut entries = vec![];
        for entry in &expanded {
            for variable in &by.entries {
                let variable = self.system.expanded(variable, &kept);
                let Some(variable) = variable.as_variable() else {
                    return beyond(NOT_FREE);
                };
                if self.system.atoms.is_unknown(variable) {
                    return beyond(NOT_FREE);
                }
                if !self.is_driven(variable)
                    && entry.variables().into_iter().any(|v| self.is_driven(v))
                {
                    return beyond(DRIVEN);
                }
                if self.has_hidden_beside(entry, variable) {
                    return beyond(NOT_FREE);
                }
                entries.push(self.system.partial(entry, variable));
            }
        }
        let columns = if by.is_scalar() {
            value.columns
        } else {
            by.entries.len()
        };
        match (value.is_scalar(), by.is_scalar()) {
            (true, false) => Ok(Value {
                rows: by.rows,
                columns: by.columns,
                entries,
                basis: by.basis,
            }),
            (_, true) => Ok(Value {
                entries,
                ..value.clone()
            }),
            _ => Ok(Value {
                rows: value.rows,
                columns,
                entries,
                basis: [value.vector_basis(), by.vector_basis()],
            }),
        }
    }
}

/// The mark of a derivative in time.
fn mark_of(style: DerivativeStyle) -> Mark {
    match style {
        DerivativeStyle::Dots => Mark::Dot,
        DerivativeStyle::Leibniz => Mark::Leibniz,
    }
}
