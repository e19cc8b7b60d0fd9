//! Small quantities: lines that hold to the order to which they are written.
//!
//! Of `A ≈ B` with small symbols in it, what A − B has beyond the order of B is taken over to the right side, term by
//! term of Taylor's series; what is left must vanish exactly, and is proved and refuted like any other line.

use crate::algebra::{Fraction, Monomial, Polynomial, Variable};
use crate::notation::ast::{Function, Kind, Node, Relation};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::lines::given::is_zero;
use crate::verify::theory::Premise;
use crate::verify::theory::decide::Equation;
use crate::verify::values::atoms::{Atom, Owner};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::values::value::Value;
use crate::verify::words::small_words::{
    BEFORE, BEHIND, KEPT, is_hardly_changed, takes_first_order,
};
use num_traits::{One, Zero};

/// The end of the name of a premise that a component of ω hardly changes.
const OF_SECOND: &str = " is of second order";
/// The highest order to which the series of a sine and a cosine are taken.
const HIGHEST: u32 = 3;

impl Checker<'_> {
    /// Notes symbols of an expression that the words before it call small.
    pub(crate) fn small_before(&mut self, node: &Node) {
        let near = self.sentence.split_whitespace().rev().take(3);
        let clause: Vec<String> = near.map(|word| word.to_lowercase()).collect();
        if clause.iter().any(|word| BEFORE.contains(&word.as_str())) || self.goes_on_small() {
            self.call_small(node);
            // "For small ⟨θ⟩ this is ⟨…⟩": to first order.
            self.linear |= clause.starts_with(&["small".to_owned(), "for".to_owned()]);
        }
        self.linear |= self.leaves_out(node);
        if clause.iter().any(|word| word == "positive") {
            self.call_positive(node);
        }
    }

    /// "The small components ⟨ω_1⟩ and": whether the list that goes on has begun with one of ω that is called small.
    fn goes_on_small(&mut self) -> bool {
        let words = self.sentence.trim_end();
        let joined = words.ends_with("⟩ and") || words.ends_with("⟩,") || words.ends_with("⟩, and");
        let last = match self.named.last().map(|node| &inner(node).kind) {
            Some(Kind::Symbol(symbol)) if joined => symbol.clone(),
            _ => return false,
        };
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        matches!(self.meaning_of(&last), Meaning::Component(entity, axis)
            if entity == omega && self.small_turns.contains(&axis))
    }

    /// Notes the expressions of a list that the words behind it call small.
    pub(crate) fn small_behind(&mut self, text: &str, named: &[Node]) {
        let positive = ["is positive", "are positive", "is a positive"];
        if positive.iter().any(|words| text.starts_with(words)) {
            named.iter().for_each(|node| self.call_positive(node));
        } else if self.are_left_out(text, named) {
            self.linear = true;
        } else if BEHIND.iter().any(|words| text.starts_with(words)) {
            named.iter().for_each(|node| self.call_small(node));
        } else if let [node] = named
            && (KEPT.iter().any(|words| text.starts_with(words)) || is_hardly_changed(text))
        {
            self.hardly_changes(node);
        } else if let [node] = named {
            self.spins_about_this_now(text, node);
        }
    }

    /// Whether sides say of a small angle what its functions are to first order: "we put ⟨sin α = α⟩ and ⟨cos α = 1⟩"; or
    /// that a product of what is small is nothing: "since ⟨λμ ≈ 0⟩".
    pub(crate) fn is_first_order(&mut self, sides: &[Node]) -> bool {
        let [left, right] = sides else { return false };
        if is_zero(right) {
            let value = self.lowering(Frame::Moving).value(left);
            return value.is_ok_and(|value| self.is_of_second_order(&value));
        }
        let Kind::Function(function, argument) = &inner(left).kind else {
            return false;
        };
        let angle = self.entities([&**argument]);
        let lone = matches!(&inner(argument).kind, Kind::Symbol(_));
        let small = lone && angle.iter().all(|entity| self.small.contains(entity));
        let one = matches!(&right.kind, Kind::Number(n) if n.value.is_one());
        let same = matches!(&inner(right).kind, Kind::Symbol(_)) && self.entities([right]) == angle;
        small
            && match function {
                Function::Sin | Function::Tan => same,
                Function::Cos => one,
                _ => false,
            }
    }

    /// Whether every term of a value is a product of small ones.
    pub(crate) fn is_of_second_order(&self, value: &Value) -> bool {
        value.entries.iter().all(|entry| {
            let mut orders = self.orders(entry).into_iter();
            entry.is_polynomial() && orders.len() > 0 && orders.all(|order| order > 1)
        })
    }

    /// Whether words in small letters take equations to first order in what is small, until the next heading.
    pub(crate) fn note_linear(&mut self, text: &str) {
        self.linear |= takes_first_order(text);
        self.note_small_rates(text);
        self.others_are_small(text);
    }

    pub(crate) fn call_small(&mut self, node: &Node) {
        if let Kind::Tuple(entries) = &inner(node).kind {
            return entries.iter().for_each(|entry| self.call_small(entry));
        }
        // "The ⟨ε_i⟩ are small": each of them.
        if let Kind::Symbol(symbol) = &node.kind
            && let [index] = symbol.subscripts.as_slice()
            && matches!(index.as_str(), "i" | "j" | "k")
        {
            for axis in ["1", "2", "3", "x", "y", "z"] {
                if self.reading.usage.has_index(&Letter::of(symbol), axis) {
                    let mut one = node.clone();
                    one.change_symbols(&mut |symbol| symbol.subscripts = vec![axis.to_owned()]);
                    self.call_small(&one);
                }
            }
        }
        if let Kind::TimeDerivative {
            operand, order: 1, ..
        } = &inner(node).kind
            && self.hardly_changes(operand)
        {
            return;
        }
        let entities = self.entities([node]);
        self.small.extend(entities);
        if let Kind::Symbol(symbol) = &inner(node).kind
            && let Meaning::Component(entity, component) = self.meaning_of(symbol)
            && entity == self.theory.atoms.quantity(Quantity::AngularVelocity)
        {
            let own = self.theory.atoms.part(entity, component, 0);
            self.end_exact_spin(own);
            self.small_turns.insert(component);
        }
        self.drop_second_order();
    }

    /// Supposes that a component of ω keeps its value, where its rate is of second order in the other two: the equation
    /// of motion about its axis is dropped, and the linear ones go on without it.
    pub(crate) fn hardly_changes(&mut self, node: &Node) -> bool {
        let Kind::Symbol(symbol) = &inner(node).kind else {
            return false;
        };
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let Meaning::Component(entity, axis) = self.meaning_of(symbol) else {
            return false;
        };
        if entity != omega || self.reading.fixed_axis.is_some() {
            return false;
        }
        self.small_turns.remove(&axis);
        self.theory.set(|setting| setting.dropped_axis = Some(axis));
        let rate = self.theory.atoms.value(entity, axis, 1);
        let name = format!("{}{OF_SECOND}", self.document.source.slice(node.span));
        // Where the body spins about another axis now, what was said of the one before is over.
        self.theory
            .retain(|premise| premise.name == name || !premise.name.ends_with(OF_SECOND));
        let premise = Premise {
            name,
            preferred: rate.as_variable().into_iter().collect(),
            residuals: vec![rate],
            definition: false,
        };
        self.take_from_words(premise, node.span);
        true
    }

    /// Where two components of ω are small and the third was given: the rate of that one is of second order, and the
    /// linear equations go on without it. A heading ends this.
    pub(crate) fn drop_second_order(&mut self) {
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        for component in 0..3 {
            let value = self.theory.atoms.value(omega, component, 0);
            let normal = self.theory.normal(&value);
            let mut terms = normal.numerator().terms().iter();
            let small = |monomial: &Monomial| monomial.factors().any(|(v, _)| self.is_small(v));
            if normal != value && !normal.is_zero() && terms.all(|(monomial, _)| small(monomial)) {
                self.small_turns.insert(component);
            }
        }
        // Where the body spins about another axis now, that one is not small any more.
        if self.small_turns.len() == 3 {
            for component in 0..3 {
                let value = self.theory.atoms.value(omega, component, 0);
                let normal = self.theory.normal(&value);
                if normal != value && !self.has_small(&normal) {
                    self.small_turns.remove(&component);
                }
            }
        }
        let mut large = (0..3).filter(|c| !self.small_turns.contains(c));
        let (1, Some(axis)) = (large.clone().count(), large.next()) else {
            return;
        };
        let value = self.theory.atoms.value(omega, axis, 0);
        // A deviation in it has an equation of its own.
        let normal = self.theory.normal(&value);
        let given = normal != value && !self.has_small(&normal);
        if given && self.theory.setting.dropped_axis != Some(axis) {
            self.theory.set(|setting| setting.dropped_axis = Some(axis));
        }
    }

    /// Calls symbols small that nothing has spoken of: they stand in the place of others that were.
    pub(crate) fn small_as_before(&mut self, sides: &[Node]) {
        for entity in self.entities(sides) {
            let own = matches!(self.theory.atoms.info(entity).owner, Owner::Symbol(_));
            if own && !self.known.contains(&entity) {
                self.small.insert(entity);
            }
        }
    }

    /// Forgets which components were small.
    pub(crate) fn end_small_turns(&mut self) {
        self.linear = false;
        self.end_spin();
    }

    /// Forgets which component was the spin, as the body turns about another axis.
    pub(crate) fn end_spin(&mut self) {
        self.oscillation.take_if(|noted| !noted.is_of_an_angle());
        self.small_turns.clear();
        if self.theory.setting.dropped_axis.is_some() {
            self.theory.set(|setting| setting.dropped_axis = None);
        }
    }

    /// Equations of the line at hand to the order of their right sides, where something in them is small; whether any is.
    pub(crate) fn keep_order(&mut self, equations: &mut [Equation]) -> bool {
        let approximate = self.linear || self.figures.relations.contains(&Relation::Approximate);
        let mut cut = false;
        for equation in equations.iter_mut().filter(|_| approximate) {
            cut |= self.cut_off(equation).is_some();
        }
        cut
    }

    fn cut_off(&mut self, equation: &mut Equation) -> Option<()> {
        let sides = [&equation.right, &equation.left];
        let shown = sides.into_iter().find(|side| !side.is_zero())?;
        let order = shown.entries.iter().map(|entry| self.order(entry)).max()?;
        // What is said to vanish does so to the order to which it is written, and to first order where the words say so.
        let vanishes = equation.left.is_zero() || equation.right.is_zero();
        let order = match vanishes {
            true => order.max(u32::from(self.linear)),
            false => self.lowest_order(equation, order),
        };
        let entries = equation.residual.entries.iter();
        let whole: Vec<Fraction> = entries.map(|entry| self.theory.normal(entry)).collect();
        if order > HIGHEST
            || !whole.iter().any(|entry| self.has_small(entry))
            || whole.iter().any(|entry| self.divides_by_small(entry))
        {
            return None;
        }
        let higher = whole.into_iter().map(|whole| {
            let low = self.low(&whole, order);
            whole - low
        });
        let higher = higher.collect();
        let higher = Value {
            entries: higher,
            ..equation.residual.clone()
        };
        equation.right = equation.right.plus(&higher, false).ok()?;
        equation.residual = equation.residual.plus(&higher, true).ok()?;
        Some(())
    }

    /// The first order, from one on, to which anything is left of the sides: a moment that turns a body through small
    /// angles is small itself.
    fn lowest_order(&mut self, equation: &Equation, from: u32) -> u32 {
        let sides = [&equation.left, &equation.right].into_iter();
        let sides = sides.flat_map(|side| &side.entries);
        let whole: Vec<Fraction> = sides.map(|entry| self.theory.normal(entry)).collect();
        let mut left_over =
            (from..=HIGHEST).filter(|&order| whole.iter().any(|w| !self.low(w, order).is_zero()));
        left_over.next().unwrap_or(from)
    }

    /// The terms up to an order in the small symbols.
    pub(crate) fn low(&mut self, whole: &Fraction, order: u32) -> Fraction {
        let mut above = whole.numerator().clone();
        for variable in above.variables() {
            if let Some(series) = self.series(variable) {
                above = above.substitute(variable, &series);
            }
        }
        let kept = above.terms().iter().filter(|(monomial, _)| {
            let degree = monomial
                .factors()
                .map(|(v, power)| power * u32::from(self.is_small(v)));
            degree.sum::<u32>() <= order
        });
        let low = Polynomial::from_terms(kept.cloned().collect());
        Fraction::new(low, whole.denominator().clone()).unwrap_or_else(|| whole.clone())
    }

    /// Whether a value is divided by something small, or has the root of it, which is as small as what it is taken of.
    fn divides_by_small(&self, entry: &Fraction) -> bool {
        let root = |v: Variable| {
            matches!(self.theory.atoms.atom(v), Atom::Kernel { function: Function::Sqrt, argument }
                if self.has_small(argument))
        };
        let below = entry.denominator().variables();
        below.into_iter().any(|v| self.is_small(v)) || entry.variables().into_iter().any(root)
    }

    /// The highest order of a term as it is written.
    fn order(&self, entry: &Fraction) -> u32 {
        self.orders(entry).into_iter().max().unwrap_or(0)
    }

    /// The order of each term.
    fn orders(&self, entry: &Fraction) -> Vec<u32> {
        let terms = entry.numerator().terms().iter();
        let order = |(monomial, _): &(Monomial, _)| {
            let factors = monomial.factors();
            factors.map(|(v, power)| power * self.order_of(v)).sum()
        };
        terms.map(order).collect()
    }

    fn order_of(&self, variable: Variable) -> u32 {
        match self.theory.atoms.atom(variable) {
            Atom::Kernel {
                function: Function::Sin,
                argument,
            } => u32::from(argument.variables().iter().any(|&v| self.is_small(v))),
            _ => u32::from(self.is_small(variable)),
        }
    }

    pub(crate) fn has_small(&self, entry: &Fraction) -> bool {
        let mut inside = entry
            .variables()
            .into_iter()
            .flat_map(|v| self.theory.atoms.with_arguments(v));
        inside.any(|v| self.is_small(v))
    }

    /// Whether a variable, or what it is a rate of, is small: by words, or by the δ of a variation.
    fn is_small(&self, variable: Variable) -> bool {
        let Atom::Part {
            entity, component, ..
        } = *self.theory.atoms.atom(variable)
        else {
            return false;
        };
        let rate = Owner::Quantity(Quantity::AngularVelocity, String::new());
        if !self.small_turns.is_empty() && self.theory.atoms.info(entity).owner == rate {
            return self.small_turns.contains(&component);
        }
        let varied = match &self.theory.atoms.info(entity).owner {
            Owner::Quantity(_, variant) => variant.ends_with('δ'),
            Owner::Symbol(key) => key.split(' ').any(|part| part.ends_with('δ')),
        };
        varied || self.small.contains(&entity)
    }

    /// Taylor's series of the sine or cosine of a small angle.
    fn series(&mut self, variable: Variable) -> Option<Polynomial> {
        let Atom::Kernel { function, argument } = self.theory.atoms.atom(variable).clone() else {
            return None;
        };
        let angle = argument.numerator().clone();
        let small = angle.variables().iter().all(|&v| self.is_small(v));
        if !small || !argument.is_polynomial() || angle.is_zero() {
            return None;
        }
        let ratio = |p, q| Fraction::from_ratio(p, q).numerator().clone();
        let square = angle.clone() * angle.clone();
        match function {
            Function::Sin => Some(angle.clone() + ratio(-1, 6) * square * angle),
            Function::Cos => {
                let fourth = square.clone() * square.clone();
                Some(ratio(1, 1) + ratio(-1, 2) * square + ratio(1, 24) * fourth)
            }
            _ => None,
        }
    }
}
