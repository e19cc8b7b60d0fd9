//! Products: what stands side by side binds first, then crosses, then dots.

use crate::algebra::Place;
use crate::notation::ast::{Bracket, Factor, Kind, Node, Operator as Sign};
use crate::verify::model::atoms::{Key, Motion, Space, fraction};
use crate::verify::model::system::FrameId;
use crate::verify::term::indices::axis_letters;
use crate::verify::term::letters::{Meaning, loosely, spelled};
use crate::verify::term::lower::Lowering;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{Trouble, Value, Valued, beyond};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Why a product without factors has no value.
const EMPTY: &str = "an empty product";

impl Lowering<'_> {
    /// The value of a product.
    pub(super) fn product(&mut self, factors: &[Factor]) -> Valued {
        if let Some(letter) = self.summed_letter(factors) {
            let kind = Kind::Product(factors.to_vec());
            let span = factors
                .first()
                .map_or_else(Default::default, |f| f.node.span);
            return self.sum_over_axes(&letter, &Node { kind, span });
        }
        let crossed = self.with_crossing_letters(factors);
        let mut runs: Vec<(Sign, Vec<&Node>)> = vec![];
        for factor in crossed.iter() {
            match (factor.operator, runs.last_mut()) {
                (Sign::Juxtaposed, Some((_, run))) => run.push(&factor.node),
                (sign, _) => runs.push((sign, vec![&factor.node])),
            }
        }
        let mut values: Vec<(Sign, Value)> = vec![];
        for (at, (sign, run)) in runs.iter().enumerate() {
            let before_cross = runs.get(at + 1).is_some_and(|(s, _)| *s == Sign::Cross);
            match self.run(run) {
                Err(Trouble::IllTyped(why)) if *sign == Sign::Dot => {
                    let split = self.dotted_first(run);
                    values.extend(split.ok_or(Trouble::IllTyped(why))?);
                }
                Ok(value) if before_cross && value.is_scalar() => {
                    match self.row_before_cross(run) {
                        Some((row, last)) => {
                            values.extend([(*sign, row), (Sign::Juxtaposed, last)]);
                        }
                        None => values.push((*sign, value)),
                    }
                }
                value => values.push((*sign, value?)),
            }
        }
        let custom = self.custom();
        for sign in [Sign::Tensor, Sign::Cross, Sign::Dot] {
            // Repeated crosses are taken from the right, and so the others, for which it does not matter.
            while let Some(at) = values
                .iter()
                .rposition(|(s, _)| *s == sign)
                .filter(|&at| at > 0)
            {
                let (_, right) = values.remove(at);
                let left = values[at - 1].1.clone();
                values[at - 1].1 = self.joined(&left, sign, &right, custom)?;
            }
        }
        let mut values = values.into_iter().map(|(_, value)| value);
        let Some(mut product) = values.next() else {
            return beyond(EMPTY);
        };
        for value in values {
            product = self.joined(&product, Sign::Juxtaposed, &value, custom)?;
        }
        Ok(product)
    }

    /// Of `b c` behind a dot, two vectors side by side: in `a · b c` the dot is that of a and b.
    fn dotted_first(&mut self, run: &[&Node]) -> Option<[(Sign, Value); 2]> {
        let (first, rest) = run.split_at_checked(1)?;
        let (first, rest) = (self.run(first).ok()?, self.run(rest).ok()?);
        let parts = first.is_vector() && !rest.is_scalar();
        parts.then_some([(Sign::Dot, first), (Sign::Juxtaposed, rest)])
    }

    /// Of `pᵀ a` before a cross, a row and a vector side by side: in `pᵀ a × b` the cross is that of a and b.
    fn row_before_cross(&mut self, run: &[&Node]) -> Option<(Value, Value)> {
        let (rest, last) = run.split_last_chunk::<1>()?;
        let (rest, last) = (self.run(rest).ok()?, self.run(last).ok()?);
        (rest.is_row() && last.is_vector()).then_some((rest, last))
    }

    /// A letter without an axis that stands once in each of two factors: it is summed over, where that is the convention.
    fn summed_letter(&self, factors: &[Factor]) -> Option<String> {
        if !self.letters.customs.sums_at(self.at) {
            return None;
        }
        let mut times: BTreeMap<String, Vec<usize>> = BTreeMap::new();
        for factor in factors {
            for (letter, count) in axis_letters(self.letters, self.at, &factor.node) {
                times.entry(letter).or_default().push(count);
            }
        }
        // A factor that has a letter twice sums over it by itself.
        times
            .into_iter()
            .find(|(letter, counts)| counts == &[1, 1] && !self.axes.contains_key(letter))
            .map(|(letter, _)| letter)
    }

    /// A letter of which `ω×` is said to be a matrix stands as that matrix.
    fn with_crossing_letters<'f>(&self, factors: &'f [Factor]) -> Cow<'f, [Factor]> {
        if self.letters.crossing.is_empty() {
            return Cow::Borrowed(factors);
        }
        let mut all = factors.to_vec();
        for at in 1..all.len() {
            if all[at].operator == Sign::Cross
                && self.letters.crossing.contains(&spelled(&all[at - 1].node))
            {
                let node = all[at - 1].node.clone();
                all[at - 1].node = Node {
                    span: node.span,
                    kind: Kind::Skew(Box::new(node)),
                };
                all[at].operator = Sign::Juxtaposed;
            }
        }
        Cow::Owned(all)
    }

    /// The value of factors that belong together, and how many they are.
    fn several(&mut self, run: &[&Node]) -> Option<(usize, Valued)> {
        if let Some(raised) = self.raised_call(run) {
            return Some((2, self.value(&raised)));
        }
        if let Some(found) = self.phrase(run).or_else(|| self.rate_of_call(run)) {
            return Some(found);
        }
        if let Some(matrix) = self.matrix_of_angle(run) {
            return Some((2, Ok(matrix)));
        }
        let differential = run.len() > 1 && self.is_differential(run[0]);
        differential.then(|| (2, self.differential(run[1], run.len() == 2)))
    }

    /// Factors side by side. Matrices act on what stands right of them, so the product is taken from the right.
    fn run(&mut self, run: &[&Node]) -> Valued {
        let mut values = vec![];
        let mut at = 0;
        while at < run.len() {
            // d/dt before a product reaches over all of it.
            if let Kind::TimeDerivative {
                operand,
                order,
                style,
                frame,
            } = &run[at].kind
                && is_empty(operand)
            {
                let rest = self.run(&run[at + 1..])?;
                values.push(self.rate_of(&rest, *order, *style, frame.as_ref())?);
                break;
            }
            if let Some(whole) = self.sum_over_rest(&run[at..]) {
                values.push(self.value(&whole)?);
                break;
            }
            if let Some((length, value)) = self.several(&run[at..]) {
                values.push(value?);
                at += length;
                continue;
            }
            let value = self.value(run[at])?;
            let dyad = match values.last() {
                Some(left)
                    if left.is_itself()
                        && value.is_itself()
                        && self.makes_dyad(run[at - 1], run[at]) =>
                {
                    Some(self.dyad(left, &value)?)
                }
                _ => None,
            };
            if dyad.is_some() {
                values.pop();
            }
            values.push(dyad.unwrap_or(value));
            at += 1;
        }
        match self.joined_from_the_right(&values) {
            // `$a^T a E$`: the row and the column come first, where a column before a matrix is nothing.
            Err(Trouble::IllTyped(why)) => self
                .joined_from_the_left(&values)
                .map_err(|_| Trouble::IllTyped(why)),
            product => product,
        }
    }

    /// Numbers wait: a row before a number and a column is taken as a row before a column.
    fn joined_from_the_right(&mut self, values: &[Value]) -> Valued {
        let custom = self.custom();
        let Some((last, before)) = values.split_last() else {
            return beyond(EMPTY);
        };
        let mut product = last.clone();
        for left in before.iter().rev() {
            product = self.joined(left, Sign::Juxtaposed, &product, custom)?;
        }
        Ok(product)
    }

    fn joined_from_the_left(&mut self, values: &[Value]) -> Valued {
        let custom = self.custom();
        let Some((first, behind)) = values.split_first() else {
            return beyond(EMPTY);
        };
        let mut product = first.clone();
        for right in behind {
            product = self.joined(&product, Sign::Juxtaposed, right, custom)?;
        }
        Ok(product)
    }

    /// Unit vectors side by side are a dyad; other vectors are where a sentence says so.
    fn makes_dyad(&self, left: &Node, right: &Node) -> bool {
        let unit = |node: &Node| {
            let told = || {
                self.letters
                    .find(&spelled(node), &loosely(node), self.at, 1)
            };
            has_hat(node)
                || told().is_some_and(|letter| {
                    matches!(
                        &letter.meaning,
                        Meaning::Quantity(Quantity::Axis(..) | Quantity::UnitVector { .. })
                    )
                })
        };
        self.letters.customs.products.dyads || unit(left) && unit(right)
    }

    /// a b of two vectors that are no columns of numbers.
    fn dyad(&mut self, a: &Value, b: &Value) -> Valued {
        let custom = self.custom();
        self.system.times(a, &b.transposed(), custom)
    }

    /// A sum reaches over the factors behind it that have its index.
    fn sum_over_rest(&self, run: &[&Node]) -> Option<Node> {
        let [
            Node {
                kind:
                    Kind::IndexedSum {
                        index,
                        limits,
                        body,
                    },
                span,
            },
            rest @ ..,
        ] = run
        else {
            return None;
        };
        if !rest.iter().any(|node| has_index(node, &index.name)) {
            return None;
        }
        let factor = |node: &Node| Factor {
            operator: Sign::Juxtaposed,
            sign: crate::source::Span::default(),
            node: node.clone(),
        };
        let factors = std::iter::once(&**body)
            .chain(rest.iter().copied())
            .map(factor)
            .collect();
        let body = Node {
            span: *span,
            kind: Kind::Product(factors),
        };
        let (index, limits) = (index.clone(), limits.clone());
        Some(Node {
            span: *span,
            kind: Kind::IndexedSum {
                index,
                limits,
                body: Box::new(body),
            },
        })
    }

    /// Whether a letter is the d of a differential: none that a sentence uses as a letter of its own.
    fn is_differential(&self, node: &Node) -> bool {
        let Kind::Symbol(symbol) = &node.kind else {
            return false;
        };
        let marked = symbol.style.tilde || symbol.style.hat || symbol.style.bar;
        let plain = symbol.name == "d" && symbol.subscripts.is_empty() && symbol.primes == 0;
        let plain = plain && !marked;
        let own = Key {
            space: Space::Unknown,
            ..Key::new(&symbol.name)
        };
        plain
            && (symbol.style.upright || self.system.atoms.find(&own).is_none())
            && self
                .letters
                .find(&spelled(node), &loosely(node), self.at, 0)
                .is_none()
    }

    /// dx is the rate of x times dt. Before further factors the d of what does not change is rather a letter of its own.
    fn differential(&mut self, of: &Node, last: bool) -> Valued {
        let key = Key::new("dt");
        let dt = self
            .system
            .atoms
            .variable(key, Place::Rate, Motion::Constant);
        let value = self.value(of)?;
        let ground = self.system.ground;
        let rate = self.system.rate_of_value(&value, ground)?;
        match rate.is_zero() && !last {
            true => Err(Trouble::Unknown("d".to_owned())),
            false => Ok(rate.scaled(&fraction(dt))),
        }
    }

    /// Letters side by side that have a meaning as a whole, from the beginning of a run.
    fn phrase(&mut self, run: &[&Node]) -> Option<(usize, Valued)> {
        if run.len() < 2 || !self.letters.has_phrases() {
            return None;
        }
        let most = run.len().min(4);
        (2..=most).rev().find_map(|length| {
            let whole = run[..length]
                .iter()
                .map(|node| spelled(node))
                .collect::<Vec<_>>()
                .join(" ");
            Some((length, self.meaning_of(&whole, Some(&whole), 1)?))
        })
    }

    /// `\dot R(\psi)`, where `R(\psi)` has a meaning as a whole.
    fn rate_of_call(&mut self, run: &[&Node]) -> Option<(usize, Valued)> {
        let [rate, argument, ..] = run else {
            return None;
        };
        let (Kind::TimeDerivative { .. }, Kind::Group(Bracket::Round, inner)) =
            (&rate.kind, &argument.kind)
        else {
            return None;
        };
        let call = Node {
            kind: Kind::Call(Box::new((*rate).clone()), vec![(**inner).clone()]),
            span: rate.span,
        };
        Some((2, self.as_a_whole(&call)?))
    }

    /// Two values with a sign between them.
    pub(super) fn joined(
        &mut self,
        left: &Value,
        sign: Sign,
        right: &Value,
        custom: FrameId,
    ) -> Valued {
        let quaternions = left.is_quaternion() || right.is_quaternion();
        let factors = [left, right]
            .iter()
            .all(|v| v.is_quaternion() || v.is_vector());
        let dots = self.letters.customs.products.quaternion_dots && sign == Sign::Dot;
        if quaternions && factors && (dots || matches!(sign, Sign::Tensor | Sign::Juxtaposed)) {
            let layout = self.letters.customs.layout;
            return self.system.quaternion_product(left, right, layout);
        }
        match sign {
            Sign::Juxtaposed => self.system.times(left, right, custom),
            Sign::Dot => self.system.dot(left, right, custom),
            Sign::Cross => self.crossed(left, right, custom),
            Sign::Tensor if left.is_vector() && right.is_vector() => {
                let row = right.transposed();
                self.system.times(left, &row, custom)
            }
            Sign::Tensor => beyond("a tensor product of these"),
        }
    }
}

/// Whether a letter is marked as a unit vector.
fn has_hat(node: &Node) -> bool {
    matches!(&node.kind, Kind::Symbol(symbol) if symbol.style.hat)
}

/// Whether a derivative stands before what it acts on.
fn is_empty(operand: &Node) -> bool {
    matches!(&operand.kind, Kind::Product(factors) if factors.is_empty())
}

/// Whether a symbol in a formula has an index among its labels.
fn has_index(node: &Node, index: &str) -> bool {
    let own = match &node.kind {
        Kind::Symbol(symbol) => symbol.subscripts.iter().any(|label| label.ends_with(index)),
        _ => false,
    };
    own || node
        .children()
        .into_iter()
        .any(|child| has_index(child, index))
}
