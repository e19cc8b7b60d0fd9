//! Lowers the tree of a formula to a value.

use crate::algebra::{Fraction, Polynomial, Rational};
use crate::mechanics;
use crate::notation::ast::{Bracket, Kind, Node, Number, Term};
use crate::source::Source;
use crate::verify::model::system::{FrameId, System};
use crate::verify::term::at_instants::Present;
use crate::verify::term::known::Known;
use crate::verify::term::letters::{At, Effect, Letters, Mark, loosely, spelled};
use crate::verify::term::quantity::Quantity;
use crate::verify::term::symbols::on;
use crate::verify::term::value::{Basis, OTHER_ARGUMENT, Trouble, Value, Valued, beyond};
use num_traits::{One, Zero};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// How deep meanings may stand in meanings.
const DEEPEST: usize = 24;

/// Which occurrences of the letters on a line are looked at.
#[derive(Clone, Debug, Default)]
pub(crate) struct Occurrences {
    /// Where letters have the meaning that they have besides: a writing, and which of its occurrences.
    pub(crate) besides: BTreeSet<(String, usize)>,
    /// How often each writing stood on the line so far.
    pub(crate) counts: HashMap<String, usize>,
}

/// What lowering a formula needs and finds.
pub(crate) struct Lowering<'a> {
    pub(crate) system: &'a mut System,
    pub(crate) letters: &'a Letters,
    pub(crate) source: &'a Source,
    pub(crate) at: &'a At,
    /// The axes that index letters number in this reading of the line.
    pub(crate) axes: BTreeMap<String, usize>,
    /// What was found out of letters so far.
    pub(crate) known: &'a mut Known,
    /// Letters of which nothing is told, and whether a sign tells that they are vectors.
    pub(crate) unknown: BTreeMap<String, bool>,
    /// The frames of components that were met since it was last emptied.
    pub(crate) frames_seen: BTreeSet<usize>,
    pub(crate) occurrences: Occurrences,
    /// At which instant what stands on the line is.
    pub(crate) present: Present,
    pub(super) only_known: bool,
    depth: usize,
}

impl<'a> Lowering<'a> {
    pub(crate) fn new(
        system: &'a mut System,
        letters: &'a Letters,
        source: &'a Source,
        at: &'a At,
        known: &'a mut Known,
    ) -> Self {
        system.set_dimensions(letters.dimensions_at(at));
        known.enter(system.dimensions(), letters);
        Self {
            system,
            letters,
            source,
            at,
            axes: BTreeMap::new(),
            known,
            unknown: BTreeMap::new(),
            frames_seen: BTreeSet::new(),
            occurrences: Occurrences::default(),
            present: Present::default(),
            only_known: false,
            depth: 0,
        }
    }

    /// Whether what is worked out stands on the line, and not in the meaning of a letter.
    pub(super) fn is_on_line(&self) -> bool {
        self.depth == 0
    }

    pub(super) fn count(&mut self, spelled: &str) -> usize {
        let counts = &mut self.occurrences.counts;
        let count = counts.entry(spelled.to_owned()).or_default();
        *count += 1;
        *count
    }

    /// The frame of lists, where a sentence says it.
    pub(super) fn frame_of_brackets(&self) -> Option<FrameId> {
        match self.letters.mark(Mark::Brackets, self.at) {
            Some(Effect::ComponentsOn(frame)) => Some(*frame),
            _ => None,
        }
    }

    /// The frame of lists that say no other.
    pub(crate) fn custom(&self) -> FrameId {
        let seen = self.frames_seen.first();
        let seen = seen.filter(|_| self.frames_seen.len() == 1).copied();
        let told = self.frame_of_brackets().or(seen);
        told.unwrap_or(self.letters.component_frame)
    }

    /// Follows a meaning that is itself a formula.
    pub(super) fn deeper(&mut self, value: impl FnOnce(&mut Self) -> Valued) -> Valued {
        if self.depth >= DEEPEST {
            return beyond("meanings that go round in a circle");
        }
        // What stands in a meaning does not stand on the line.
        let before = self.occurrences.clone();
        self.occurrences.besides.clear();
        self.depth += 1;
        let value = value(self);
        self.depth -= 1;
        self.occurrences = before;
        value
    }

    fn group(&mut self, bracket: Bracket, inner: &Node) -> Valued {
        // "Braces hold components on B": those of the vector that stands in them.
        if bracket == Bracket::Curly
            && let Some(frame) = self.frame_of_brackets()
        {
            let value = self.unlabelled(|lowering| lowering.value(inner))?;
            return Ok(match value.basis == [Basis::Itself; 2] {
                true => on(value, frame),
                false => value,
            });
        }
        let value = self.value(inner)?;
        let alone = matches!(inner.kind, Kind::Symbol(_) | Kind::InFrame(..));
        self.in_brackets(value, alone && bracket == Bracket::Square)
    }

    fn matrix(&mut self, rows: &[Vec<Node>]) -> Valued {
        let single = matches!(rows, [row] if row.len() == 1);
        let value = self.list(rows, false)?;
        self.in_brackets(value, single)
    }

    /// What square brackets make of a vector, where a sentence says so.
    fn in_brackets(&mut self, value: Value, square: bool) -> Valued {
        match square && self.letters.customs.crossing_brackets && value.is_vector() {
            true => value.cross_product_matrix(),
            false => Ok(value),
        }
    }

    /// The value of a node.
    pub(crate) fn value(&mut self, node: &Node) -> Valued {
        if let Some(value) = self.as_a_whole(node) {
            return value;
        }
        match &node.kind {
            Kind::Number(number) => Ok(Value::scalar(constant(number))),
            Kind::Bold(number) => self.bold(number),
            Kind::Symbol(symbol) => self.symbol(symbol),
            Kind::Negate(inner) => Ok(self.value(inner)?.negated()),
            Kind::Sum(terms) => self.sum(terms),
            Kind::Product(factors) => self.product_of(node, factors),
            Kind::Quotient(top, bottom) => self.quotient(top, bottom),
            Kind::Power(base, exponent) => self.power(base, exponent),
            Kind::Transpose(inner) => self.transpose(inner),
            Kind::Skew(inner) => self.skew(node, inner),
            Kind::Group(bracket, inner) => self.group(*bracket, inner),
            Kind::Norm(inner) => self.norm(inner),
            Kind::Tuple(entries) => match self.product_in_brackets(node, entries) {
                Some(product) => product,
                None => self.tuple(std::slice::from_ref(entries)),
            },
            Kind::Matrix(rows) => self.matrix(rows),
            Kind::Determinant(rows) => self.determinant(rows),
            Kind::TimeDerivative {
                operand,
                order,
                style,
                frame,
            } => match (&operand.kind, frame) {
                (Kind::Symbol(symbol), None) => {
                    let rate = |own: &mut Self| own.time_derivative(operand, *order, *style, None);
                    self.rate_of_symbol(symbol, (*order, *style), rate)
                }
                _ => self.time_derivative(operand, *order, *style, frame.as_ref()),
            },
            Kind::Derivative {
                operand,
                variables,
                partial,
            } => self.derivative(operand, variables, *partial),
            Kind::Function(function, inner) => match self.told_base(node) {
                Some(base) => self.power(&base, inner),
                None => self.function(*function, inner),
            },
            Kind::Call(head, arguments) => self.call(head, arguments),
            Kind::InFrame(inner, label) if is_size(&label.text) => self.sized(inner),
            Kind::InFrame(inner, label) => self.in_frame(inner, &label.text),
            Kind::Integral { .. } => match self.integral_in_time(node) {
                Some(value) => value,
                None => self.integral(node),
            },
            Kind::IndexedSum { .. } => self.indexed_sum(node),
            Kind::WithUnit(number, unit) => self.with_unit(number, unit),
            Kind::PlusMinus(_) => beyond("a sign that is left open"),
            Kind::Ellipsis => beyond("something left out"),
            Kind::Error(message) => beyond(message.clone()),
        }
    }

    /// The value of a letter that stands for a quantity; it is worked out once.
    pub(super) fn letter(&mut self, text: &str, quantity: &Quantity) -> Valued {
        if let Some(value) = self.known.value(text, quantity) {
            return value.clone();
        }
        let value = self.system.letter(text, quantity);
        self.known.keep(text, quantity, &value);
        value
    }

    fn bold(&mut self, number: &Number) -> Valued {
        let (value, size) = (constant(number), self.system.dimensions());
        match value.is_zero() {
            true => Ok(Value {
                basis: [Basis::Any; 2],
                ..Value::written(size, 1, vec![Fraction::zero(); size])
            }),
            false => Ok(self.system.value_of(&Quantity::Identity)?.scaled(&value)),
        }
    }

    /// 0 and 1 with their size below: a matrix.
    fn sized(&mut self, inner: &Node) -> Valued {
        let number = self.value(inner)?.to_scalar()?;
        let one = self.system.value_of(&Quantity::Identity)?;
        Ok(one.scaled(&number))
    }

    fn sum(&mut self, terms: &[Term]) -> Valued {
        let mut sum = Value::scalar(Fraction::zero());
        for term in terms {
            let mut value = self.value(&term.node)?;
            if term.negative {
                value = value.negated();
            }
            if let (Some(one), Some(other)) = (sum.as_number(), value.as_number()) {
                *one += std::mem::replace(other, Fraction::zero());
                continue;
            }
            let custom = self.custom();
            (sum, value) = self.beside_quaternions(sum, value)?;
            (sum, value) = self.beside_matrix(sum, value)?;
            sum = self.system.plus(&sum, &value, custom)?;
        }
        Ok(sum)
    }

    fn power(&mut self, base: &Node, exponent: &Node) -> Valued {
        // A label that the reader took for a power: B in ω^B, once in brackets.
        if let Kind::Symbol(label) = &exponent.kind
            && let Some(effect) = self.effect_of(&label.name, false)
        {
            let value = self.value(base)?;
            return self.affected(value, &effect);
        }
        let exponent = self.value(exponent)?.to_scalar()?;
        // A length is squared without its root.
        if let Kind::Norm(inner) = &base.kind
            && let Some(power) = exponent.to_rational().and_then(|p| p.to_integer())
            && power > 0
            && power % 2 == 0
        {
            let inner = self.value(inner)?;
            if !inner.is_matrix() {
                let custom = self.custom();
                let square = self.system.dot(&inner, &inner, custom)?;
                return self.whole_power(&square, power / 2);
            }
        }
        let value = self.value(base)?;
        // Nobody writes a power of zero of a letter; it is a label, of which no sentence speaks.
        if exponent.is_zero() && matches!(base.kind, Kind::Symbol(_)) {
            return beyond("a label or a power of zero");
        }
        if let Some(power) = exponent.to_rational().and_then(|p| p.to_integer()) {
            return self.whole_power(&value, power);
        }
        let twice = exponent.to_rational().map(|p| p * Rational::from(2));
        let Some(twice) = twice.and_then(|twice| twice.to_integer()) else {
            return beyond("a power that is no whole or half number");
        };
        let root = self.system.root(&value.to_scalar()?)?;
        self.whole_power(&root, twice)
    }

    fn whole_power(&mut self, value: &Value, power: i64) -> Valued {
        if power < 0 {
            if value.is_quaternion() && power == -1 {
                return self.inverse_quaternion(value);
            }
            let inverse = self.system.inverse(value)?;
            return self.whole_power(&inverse, -power);
        }
        if power > 24 {
            return beyond("a power this high");
        }
        if value.is_vector() && power == 2 {
            let custom = self.custom();
            return self.system.dot(value, value, custom);
        }
        let mut product = match value.is_scalar() {
            true => Value::scalar(Fraction::one()),
            false => self.system.value_of(&Quantity::Identity)?,
        };
        for _ in 0..power {
            let custom = self.custom();
            product = self.system.times(&product, value, custom)?;
        }
        Ok(product)
    }

    fn skew(&mut self, node: &Node, inner: &Node) -> Valued {
        let written = self.source.slice(node.span);
        let mark = if written.contains("tilde") {
            Some(Mark::Tilde)
        } else if written.contains("hat") {
            Some(Mark::Hat)
        } else {
            None
        };
        let effect = mark.and_then(|mark| self.letters.mark(mark, self.at).cloned());
        // A mark that no sentence gives a meaning makes another letter.
        if let (Some(Mark::Tilde), None, Kind::Symbol(symbol)) = (mark, &effect, &inner.kind) {
            let mut marked = symbol.clone();
            marked.style.tilde = true;
            return self.symbol(&marked);
        }
        let value = match (&effect, &inner.kind) {
            (Some(Effect::CrossProductMatrix), Kind::Symbol(symbol)) => self.vector(symbol)?,
            _ => self.value(inner)?,
        };
        self.affected(value, &effect.unwrap_or(Effect::CrossProductMatrix))
    }

    fn norm(&mut self, inner: &Node) -> Valued {
        let value = self.value(inner)?;
        if value.is_matrix() {
            return Ok(Value::scalar(mechanics::determinant(&value.to_matrix()?)));
        }
        let custom = self.custom();
        let square = match value.is_scalar() {
            true => value.entries[0].clone() * value.entries[0].clone(),
            false => self.system.dot(&value, &value, custom)?.to_scalar()?,
        };
        let size = self.system.root(&square)?;
        // |sin θ| is not sin θ where nothing tells that θ is an angle of a half turn.
        match self.system.atoms.has_sine_of_any_sign(&size.to_scalar()?) {
            true => beyond(OTHER_ARGUMENT),
            false => Ok(size),
        }
    }

    fn in_frame(&mut self, inner: &Node, label: &str) -> Valued {
        if let Some(effect) = self.effect_of(label, true) {
            let value = self.value(inner)?;
            return match (&effect, self.lists_rates(inner)) {
                (Effect::RateSeenFrom(_), Some(true)) => Ok(value),
                (Effect::RateSeenFrom(_), _) => Err(Trouble::Unknown(label.to_owned())),
                _ => self.affected(value, &effect),
            };
        }
        if let Some((axes, frame)) = self.axes_of_label(label) {
            let value = self.value(inner)?;
            let frame = value
                .frame()
                .or(frame)
                .unwrap_or(self.letters.component_frame);
            return self.entry(&value, &axes, frame);
        }
        if let Some(frame) = self.letters.frame(label) {
            let value = self.value(inner)?;
            return self.affected(value, &Effect::ComponentsOn(frame));
        }
        Err(Trouble::Unknown(label.to_owned()))
    }

    /// Whether sentences tell what the rates in a list are, which its label then says once more; `None` for no such list.
    fn lists_rates(&self, list: &Node) -> Option<bool> {
        let rows = match &list.kind {
            Kind::Group(_, inner) => return self.lists_rates(inner),
            Kind::Matrix(rows) => rows.as_slice(),
            Kind::Tuple(entries) => std::slice::from_ref(entries),
            _ => return None,
        };
        let rate = |entry: &Node| matches!(entry.kind, Kind::TimeDerivative { .. });
        let told = |entry: &Node| {
            let (exact, loose) = (spelled(entry), loosely(entry));
            self.letters.find(&exact, &loose, self.at, 0).is_some()
        };
        let mut entries = rows.iter().flatten();
        entries
            .clone()
            .any(rate)
            .then(|| entries.all(|entry| rate(entry) && told(entry)))
    }
}

pub(super) fn constant(number: &Number) -> Fraction {
    match number.value.is_zero() {
        true => Fraction::zero(),
        false => Fraction::from(Polynomial::constant(Rational::from(number.value.clone()))),
    }
}

/// `3×3`.
fn is_size(label: &str) -> bool {
    let plain: String = label.chars().filter(|c| !c.is_whitespace()).collect();
    matches!(plain.as_str(), "3×3" | "3x3" | "3\\times3" | "3")
}
