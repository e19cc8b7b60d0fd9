//! Functions of the state and their Jacobians: `\dot\omega = f(\omega, u)`, "the Jacobian of f is ⟨J(ω) = …⟩".

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{inner, symbols};
use crate::verify::lines::given::is_zero;
use crate::verify::theory::{Premise, Taken};
use crate::verify::values::atoms::Entity;
use crate::verify::values::call::name_of_function;
use crate::verify::values::lower::FunctionOf;
use crate::verify::values::value::Value;
use crate::verify::verdict::{Finding, Role, Verdict};
use crate::verify::words::book::lowered;

impl Checker<'_> {
    /// `F(ω) = …` defines a function. Where the words call it a Jacobian, that is what it must be.
    pub(crate) fn defines_function(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, right, rest @ ..] = sides else {
            return false;
        };
        let Kind::Call(head, arguments) = &left.kind else {
            return self.names_on_the_right(sides, finding);
        };
        let Some((entity, None)) = self.new_symbol(head) else {
            return false;
        };
        if matches!(arguments.as_slice(), [only] if matches!(&inner(only).kind, Kind::Symbol(s) if s.name == "t"))
        {
            return false;
        }
        let named = |s: &&Symbol| name_of_function(&s.name, &s.subscripts);
        let Some(name) = symbols(head).first().map(named) else {
            return false;
        };
        let Some(parameter) = self.parameter(arguments) else {
            return false;
        };
        let jacobian = self.jacobian_in_words(&parameter);
        let value = match &jacobian {
            Some(value) => Ok(value.clone()),
            None => self.lowering(Frame::Moving).value(right),
        };
        let Ok(value) = value else { return false };
        if !self.bind_function(entity, name, FunctionOf { parameter, value }, finding) {
            return false;
        }
        if jacobian.is_some() {
            self.claim(sides, finding);
        } else if rest.is_empty() {
            finding.verdict = Verdict::Accepted;
            finding.role = Role::Define;
        } else {
            self.claim(&sides[1..], finding);
        }
        true
    }

    /// "After convergence ⟨r = 0⟩" of a function r: what is sought is found, and the function vanishes there.
    pub(crate) fn finds_the_root(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, right] = sides else { return false };
        let (Kind::Symbol(symbol), true) = (&inner(left).kind, is_zero(right)) else {
            return false;
        };
        if self.displayed || self.asserted || self.obtained || !symbol.subscripts.is_empty() {
            return false;
        }
        let name = name_of_function(&symbol.name, &symbol.subscripts);
        let Some(function) = self.functions.get(&name).cloned() else {
            return false;
        };
        let name = self.line_name(finding);
        let taken = self.theory.assume(Premise {
            name: name.clone(),
            residuals: function.value.entries,
            preferred: vec![],
            definition: false,
        });
        if taken == Taken::Contradiction {
            return false;
        }
        self.keep(&name, false);
        self.note_assumption(&name, Role::Assume);
        finding.verdict = Verdict::Accepted;
        finding.role = Role::Assume;
        true
    }

    /// The variables of arguments that are lone symbols.
    fn parameter(&mut self, arguments: &[Node]) -> Option<Vec<Variable>> {
        let mut all = vec![];
        for argument in arguments {
            let at = self.lowering(Frame::Moving).value(argument).ok()?;
            let variables: Option<Vec<Variable>> =
                at.entries.iter().map(Fraction::as_variable).collect();
            all.extend(variables?);
        }
        Some(all)
    }

    fn bind_function(
        &mut self,
        entity: Entity,
        name: String,
        function: FunctionOf,
        finding: &Finding,
    ) -> bool {
        let Some(residuals) = self.bind(entity, None, &function.value) else {
            return false;
        };
        let preferred = residuals.iter().map(|(v, _)| *v).collect();
        let residuals = residuals.into_iter().map(|(_, r)| r).collect();
        let line = self.line_name(finding);
        self.theory.assume(Premise {
            name: line.clone(),
            residuals,
            preferred,
            definition: true,
        });
        self.keep(&line, true);
        self.functions.insert(name, function);
        self.known.insert(entity);
        true
    }

    /// The Jacobian of the one function of such a parameter, where the sentence says that a line writes it down.
    fn jacobian_in_words(&mut self, parameter: &[Variable]) -> Option<Value> {
        if !lowered(&self.sentence).contains("jacobian") {
            return None;
        }
        let mut same = self.functions.values().filter(|f| f.parameter == parameter);
        let (Some(function), None) = (same.next().cloned(), same.next()) else {
            return None;
        };
        self.lowering(Frame::Moving)
            .jacobian(&function.value, parameter)
    }

    /// `\dot\omega = f(\omega, u)` for an f that nothing has said anything of: the right side is the new name.
    fn names_on_the_right(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, right, rest @ ..] = sides else {
            return false;
        };
        let Kind::Call(head, arguments) = &inner(right).kind else {
            return false;
        };
        let lone = |node: &Node| matches!(inner(node).kind, Kind::Symbol(_));
        // One bracket alone may be a factor.
        let of_state = arguments.len() > 1 || is_rate_of(left, arguments);
        if !of_state || !arguments.iter().all(lone) || self.new_symbol(left).is_some() {
            return false;
        }
        let Some((entity, None)) = self.new_symbol(head) else {
            return false;
        };
        let new = self.is_free(entity) && !self.theory.mentions_entity(entity);
        let value = self.lowering(Frame::Moving).value(left);
        let (true, Ok(value), Some(parameter)) = (new, value, self.parameter(arguments)) else {
            return false;
        };
        let named = |s: &&Symbol| name_of_function(&s.name, &s.subscripts);
        let name = symbols(head).first().map(named);
        let function = FunctionOf { parameter, value };
        if !self.bind_function(entity, name.unwrap_or_default(), function, finding) {
            return false;
        }
        finding.verdict = Verdict::Accepted;
        finding.role = Role::Define;
        if !rest.is_empty() {
            finding.role = Role::Claim;
            finding.verdict = Verdict::Undecided;
            self.claim(&[&sides[..1], rest].concat(), finding);
        }
        true
    }
}

/// Whether a line says that the rate of something is a function of it.
pub(crate) fn gives_a_rate_by_name(sides: &[Node]) -> bool {
    let [left, right, ..] = sides else {
        return false;
    };
    matches!(&inner(right).kind, Kind::Call(_, arguments) if is_rate_of(left, arguments))
}

/// Whether a side is the rate of the first argument: the left side of `\dot\omega = f(\omega)`.
fn is_rate_of(side: &Node, arguments: &[Node]) -> bool {
    let Kind::TimeDerivative {
        operand, order: 1, ..
    } = &inner(side).kind
    else {
        return false;
    };
    let symbol = |node: &Node| symbols(node).first().map(|s| (*s).clone());
    let first = arguments.first().and_then(symbol);
    first.is_some() && symbol(operand) == first
}
