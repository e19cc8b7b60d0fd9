//! Functions and calls.

use crate::algebra::Fraction;
use crate::notation::ast::{FrameLabel, Function, Kind, Node, Symbol};
use crate::source::Span;
use crate::verify::letters::usage::{Letter, axis, inner, symbols, undotted};
use crate::verify::names;
use crate::verify::theory::law::Dynamics;
use crate::verify::values::atoms::{Atom, variable_fraction};
use crate::verify::values::lower::{
    FunctionOf, Lowered, Lowering, Trouble, TroubleKind, put_in, substituted, trouble,
};
use crate::verify::values::value::{ShapeMismatch, Value};
use num_traits::Zero;
use std::collections::HashMap;

impl Lowering<'_> {
    pub(crate) fn function(&mut self, node: &Node, function: Function, argument: &Node) -> Lowered {
        if function == Function::Max
            && let Some(greatest) = self.greatest(argument)
        {
            return Ok(Value::scalar(greatest));
        }
        let value = self.value(argument)?;
        let ill = |ShapeMismatch(message)| trouble(TroubleKind::IllTyped, node.span, message);
        match function {
            // What has a determinant or a trace is a matrix, and this letter was not read as one.
            Function::Det | Function::Trace if value.is_scalar() => {
                let message = "nothing before says of what matrix this is";
                return Err(trouble(TroubleKind::Unsupported, node.span, message));
            }
            Function::Det => return value.determinant().map(Value::scalar).map_err(ill),
            Function::Trace => return value.trace().map_err(ill),
            Function::Skew => return value.skew().map_err(ill),
            Function::Diag => {
                let n = value.entries.len();
                return Ok(Value::from_fn(n, n, |r, c| {
                    if r == c {
                        value.entries[r].clone()
                    } else {
                        Fraction::zero()
                    }
                }));
            }
            _ => {}
        }
        if function == Function::Exp
            && let Some(turn) = self.turn_in_a_plane(&value)
        {
            return Ok(turn);
        }
        if !value.is_scalar() {
            return Err(trouble(
                TroubleKind::IllTyped,
                node.span,
                format!("a function of {}", value.shape()),
            ));
        }
        let argument = self.theory.normal(&value.entries[0]);
        self.kernel(function, argument)
            .map(Value::scalar)
            .ok_or_else(|| {
                trouble(
                    TroubleKind::Unsupported,
                    node.span,
                    "nothing is known of this function",
                )
            })
    }

    /// The exponential of \[0, −a; a, 0\]: the turn through a.
    fn turn_in_a_plane(&mut self, value: &Value) -> Option<Value> {
        if value.rows != 2 || value.columns != 2 {
            return None;
        }
        let entries = value.map(|entry| self.theory.normal(entry)).entries;
        let [first, minus, angle, last] = entries.try_into().ok()?;
        if !first.is_zero() || !last.is_zero() || !(minus + angle.clone()).is_zero() {
            return None;
        }
        let cosine = self.kernel(Function::Cos, angle.clone())?;
        let sine = self.kernel(Function::Sin, angle)?;
        Some(Value::from_fn(2, 2, |r, c| match (r, c) {
            (0, 1) => -sine.clone(),
            (1, 0) => sine.clone(),
            _ => cosine.clone(),
        }))
    }

    /// A symbol with a bracket behind it: a function that the document defined, a quantity at time t, or a product.
    pub(crate) fn call(&mut self, node: &Node, head: &Node, arguments: &[Node]) -> Lowered {
        if let [argument] = arguments {
            if matches!(&inner(argument).kind, Kind::Symbol(s) if s.name == "t" && s.subscripts.is_empty())
            {
                return self.value(head);
            }
            if let Some(value) = self.applied(head, arguments)? {
                return Ok(value);
            }
            if let Some(value) = self.variation(head, argument)? {
                return Ok(value);
            }
            if matches!(head.kind, Kind::Derivative { .. })
                && let Some(value) = self.at_one_step(head, arguments)?
            {
                return Ok(value);
            }
            if let Some(value) = self.at_an_instant(head, argument)? {
                return Ok(value);
            }
            if let Some(value) = self.elsewhere(head, argument)? {
                return Ok(value);
            }
            let (left, right) = (self.value(head)?, self.value(argument)?);
            // S(a), the skew matrix of a.
            if matches!(&head.kind, Kind::Symbol(s) if s.name == "S" && s.subscripts.is_empty())
                && right.is_vector()
            {
                let ill = |ShapeMismatch(m)| trouble(TroubleKind::IllTyped, node.span, m);
                return right.skew().map_err(ill);
            }
            if let Some(matrix) = self.matrix_of(head, &right) {
                return Ok(matrix);
            }
            return self
                .juxtaposed(&left, &right)
                .map_err(|ShapeMismatch(m)| trouble(TroubleKind::IllTyped, node.span, m));
        }
        if let Some(value) = self.applied(head, arguments)? {
            return Ok(value);
        }
        if let Some(value) = self.made_of(head, arguments)? {
            return Ok(value);
        }
        if let Some(value) = self.at_one_step(head, arguments)? {
            return Ok(value);
        }
        Err(trouble(
            TroubleKind::Unsupported,
            node.span,
            "a function of several arguments is not known here",
        ))
    }

    /// `\omega(0)`, `s(t_0)`: what moves, at one instant, is a symbol of its own that does not.
    fn at_an_instant(&mut self, head: &Node, at: &Node) -> Result<Option<Value>, Trouble> {
        let Some((instant, symbol)) = instant(at).zip(symbols(undotted(head)).first().copied())
        else {
            return Ok(None);
        };
        let letter = Letter::of(symbol);
        let usage = &self.reading.usage;
        let moves = usage.get(&letter).moving || usage.functions_of_time.contains(&letter);
        let value = self.value(head)?;
        let turns = self.reading.quantities.get(&letter).copied();
        let parts = self.reading.components.get(&letter).map(|(q, _)| *q);
        let turns = turns.or(parts).is_some_and(|q| !q.constant());
        if !(moves || turns) || !matches!(undotted(head).kind, Kind::Symbol(_)) {
            return Ok(None);
        }
        let entries = value.entries.iter().map(|entry| {
            let named = entry.as_variable()?;
            let own = names::at_instant(&mut self.theory.atoms, named, &instant);
            Some(self.theory.atoms.value(own, 0, 0))
        });
        let entries: Option<Vec<Fraction>> = entries.collect();
        Ok(entries.map(|entries| {
            Value::from_fn(value.rows, value.columns, |r, c| {
                entries[r * value.columns + c].clone()
            })
        }))
    }

    /// `A(ω_k)` where A was defined with ω in it: A with ω_k in the place of ω.
    fn elsewhere(&mut self, head: &Node, argument: &Node) -> Result<Option<Value>, Trouble> {
        let (Kind::Symbol(_), Kind::Symbol(at)) = (&head.kind, &inner(argument).kind) else {
            return Ok(None);
        };
        let mut base = at.clone();
        base.subscripts.clear();
        if base == *at {
            return self.of_its_own(head, argument);
        }
        let base = Node {
            kind: Kind::Symbol(base),
            span: argument.span,
        };
        let (value, from, to) = (self.value(head)?, self.value(&base)?, self.value(argument)?);
        if value.is_scalar() && from.is_scalar() {
            return Ok(None);
        }
        Ok(self.with_values(&value, &from.entries, &to.entries))
    }

    /// `\dot\omega(\omega_k, \tau_k)`, where laws say what the rate is in ω and τ: that, with the values of step k.
    fn at_one_step(&mut self, head: &Node, arguments: &[Node]) -> Result<Option<Value>, Trouble> {
        let (mut from, mut to) = (vec![], vec![]);
        for argument in arguments {
            let mut base = inner(argument).clone();
            let Kind::Symbol(symbol) = &mut base.kind else {
                return Ok(None);
            };
            if symbol.subscripts.pop().is_none() {
                return Ok(None);
            }
            from.extend(self.value(&base)?.entries);
            to.extend(self.value(argument)?.entries);
        }
        let value = self.value(head)?;
        // The rate is what follows from the state and the moment.
        let put_in = |lowering: &mut Self| lowering.with_values(&value, &from, &to);
        let at_step = self.with_dynamics(Dynamics::Forward, put_in);
        // The slopes of what is linear are the same everywhere.
        let slope = matches!(head.kind, Kind::Derivative { .. });
        Ok(at_step.or_else(|| slope.then_some(value)))
    }

    /// A value with others in the place of some variables; `None` where it does not depend on them.
    fn with_values(&mut self, value: &Value, from: &[Fraction], to: &[Fraction]) -> Option<Value> {
        let parameters: Vec<u32> = from.iter().filter_map(Fraction::as_variable).collect();
        let value = value.map(|entry| self.theory.normal(entry));
        let met = value.entries.iter().flat_map(Fraction::variables);
        let depends = met.into_iter().any(|v| parameters.contains(&v));
        if !depends || parameters.len() != to.len() {
            return None;
        }
        let images: HashMap<u32, Fraction> =
            parameters.into_iter().zip(to.iter().cloned()).collect();
        Some(value.map(|entry| put_in(entry, &images)))
    }

    /// `T(ω)`, a number that depends on the vector in the brackets: that number.
    fn of_its_own(&mut self, head: &Node, argument: &Node) -> Result<Option<Value>, Trouble> {
        let (value, at) = (self.value(head)?, self.value(argument)?);
        let parameters: Option<Vec<u32>> = at.entries.iter().map(Fraction::as_variable).collect();
        let (Some(parameters), true, true) = (parameters, value.is_scalar(), at.is_vector()) else {
            return Ok(None);
        };
        let made_of = self.theory.normal(&value.entries[0]).variables();
        let depends = parameters.iter().any(|p| made_of.contains(p));
        Ok(depends.then_some(value))
    }

    /// `f(ω, u)` where earlier lines say what f is, in ω and u: that.
    fn made_of(&mut self, head: &Node, arguments: &[Node]) -> Result<Option<Value>, Trouble> {
        let lone = |node: &Node| matches!(inner(node).kind, Kind::Symbol(_));
        if !lone(head) || !arguments.iter().all(lone) {
            return Ok(None);
        }
        let value = self.value(head)?;
        let met = self.theory.reached_variables(value.entries.iter());
        for argument in arguments {
            let at = self.value(argument)?;
            if !at
                .entries
                .iter()
                .any(|entry| entry.as_variable().is_some_and(|v| met.contains(&v)))
            {
                return Ok(None);
            }
        }
        Ok(Some(value))
    }

    /// A defined function at arguments: the parameters' variables replaced.
    pub(crate) fn applied(
        &mut self,
        head: &Node,
        arguments: &[Node],
    ) -> Result<Option<Value>, Trouble> {
        // A derivative of the function is something else.
        let Kind::Symbol(symbol) = &inner(head).kind else {
            return Ok(None);
        };
        let Some(function) = self.function_of(symbol) else {
            return Ok(None);
        };
        let mut at = vec![];
        for argument in arguments {
            at.extend(self.value(argument)?.entries);
        }
        if at.len() != function.parameter.len() {
            return Ok(None);
        }
        let moves = at
            .iter()
            .map(Fraction::as_variable)
            .ne(function.parameter.iter().map(|&p| Some(p)));
        let mut value = function.value;
        if moves && self.has_rates(&value) {
            // The rate is what follows from the state and the moment.
            value = self.with_dynamics(Dynamics::Forward, |lowering| {
                value.map(|entry| lowering.theory.normal(entry))
            });
            if self.has_rates(&value) {
                let message = format!("what `{}` is elsewhere is not known", symbol.name);
                return Err(trouble(TroubleKind::Unsupported, head.span, message));
            }
        }
        let image = |v: u32| {
            let place = function.parameter.iter().position(|&p| p == v);
            place.map_or_else(|| variable_fraction(v), |i| at[i].clone())
        };
        Ok(Some(value.map(|entry| substituted(entry, &image))))
    }

    /// Refuses the component f₁ of a function f(ω) that stands without an argument where steps are counted: nothing says at
    /// which of them it is meant.
    pub(crate) fn is_taken_somewhere(&self, symbol: &Symbol, span: Span) -> Result<(), Trouble> {
        let whole = Symbol {
            subscripts: vec![],
            ..symbol.clone()
        };
        let component = matches!(symbol.subscripts.as_slice(), [index] if axis(index).is_some());
        let part = component && self.function_of(&whole).is_some();
        if !part || !self.reading.usage.counts_steps() {
            return Ok(());
        }
        let message = format!("nothing before says where `{}` is taken", symbol.name);
        Err(trouble(TroubleKind::Unsupported, span, message))
    }

    /// The function that the document gave a name, or a component of it: the f₁ of `f_1(\omega)`.
    pub(crate) fn function_of(&self, symbol: &Symbol) -> Option<FunctionOf> {
        let named =
            |indices: &[String]| self.functions.get(&name_of_function(&symbol.name, indices));
        if let Some(function) = named(&symbol.subscripts) {
            return Some(function.clone());
        }
        let [index] = symbol.subscripts.as_slice() else {
            return None;
        };
        let (function, place) = named(&[]).zip(axis(index))?;
        let entry = function.value.entries.get(usize::from(place));
        let entry = entry.filter(|_| function.value.is_vector())?;
        Some(FunctionOf {
            parameter: function.parameter.clone(),
            value: Value::scalar(entry.clone()),
        })
    }

    /// Whether the rate of something stands in a value.
    fn has_rates(&self, value: &Value) -> bool {
        let mut variables = value.entries.iter().flat_map(Fraction::variables);
        variables
            .any(|v| matches!(self.theory.atoms.atom(v), Atom::Part { order, .. } if *order > 0))
    }
}

/// The name of a function, its indices included.
pub(crate) fn name_of_function(name: &str, indices: &[String]) -> String {
    let parts = std::iter::once(name).chain(indices.iter().map(String::as_str));
    parts.collect::<Vec<_>>().join("_")
}

/// Where `\left.\frac{\partial f}{\partial\omega}\right|_{\omega_k}` is taken: its variable with the index that the bar has.
pub(crate) fn place_of_slope(slope: &Node, label: &FrameLabel) -> Option<Node> {
    let Kind::Derivative { variables, .. } = &inner(slope).kind else {
        return None;
    };
    let [variable] = variables.as_slice() else {
        return None;
    };
    let Kind::Symbol(symbol) = &inner(variable).kind else {
        return None;
    };
    let text = label.text.rsplit('=').next().unwrap_or_default().trim();
    let index = text.strip_prefix(symbol.name.as_str()).unwrap_or(text);
    let step = |index: &str| matches!(index, "k" | "n" | "0" | "k+1" | "n+1");
    let mut at = symbol.clone();
    at.subscripts.push(index.to_owned());
    let own = symbol.subscripts.is_empty() && step(index);
    own.then_some(Node {
        kind: Kind::Symbol(at),
        span: label.span,
    })
}

/// The instant that an argument names: 0, or t with an index.
fn instant(node: &Node) -> Option<String> {
    match &inner(node).kind {
        Kind::Number(number) if number.value.is_zero() => Some("0".to_owned()),
        Kind::Symbol(symbol) if symbol.name == "t" => {
            let [index] = symbol.subscripts.as_slice() else {
                return None;
            };
            Some(format!("t_{index}"))
        }
        _ => None,
    }
}
