//! First-order changes of values, and the δ before brackets.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::{Macros, document::Row, read_formula};
use crate::verify::term::evaluate::NOT_WORKED_OUT;
use crate::verify::term::letters::{Letter, Meaning, loosely, spelled};
use crate::verify::term::lower::Lowering;
use crate::verify::term::value::{Basis, Trouble, Value, Valued, beyond};

impl Lowering<'_> {
    /// The change of a value, entry by entry: that of a vector itself would hang on the frame from which it is seen.
    pub(super) fn change(&mut self, value: &Value) -> Valued {
        let work = self.system.work;
        let on_work = |basis: &Basis| match basis {
            Basis::On(frame) => *frame == work,
            Basis::Itself => false,
            Basis::Any | Basis::Written => true,
        };
        if !value.is_scalar() && !value.is_zero() && !value.basis.iter().all(on_work) {
            return beyond(NOT_WORKED_OUT);
        }
        let atoms = &mut self.system.atoms;
        let changes: Option<Vec<_>> = value.entries.iter().map(|e| atoms.change(e)).collect();
        match changes {
            Some(entries) => Ok(value.with_entries(entries)),
            None => beyond(NOT_WORKED_OUT),
        }
    }

    /// The change of what a letter or another writing stands for.
    pub(super) fn change_of_writing(&mut self, of: Option<&Node>) -> Valued {
        let Some(node) = of else {
            return beyond(NOT_WORKED_OUT);
        };
        self.deeper(|lowering| {
            let value = lowering.value(node)?;
            lowering.change(&value)
        })
    }

    /// `\delta(S(\omega)J\omega)`, where sentences tell of first-order changes and none what δ is.
    pub(super) fn change_of_brackets(&mut self, head: &Node, arguments: &[Node]) -> Option<Valued> {
        let ([argument], Kind::Symbol(symbol)) = (arguments, &head.kind) else {
            return None;
        };
        let plain = Symbol {
            name: "delta".to_owned(),
            ..Symbol::default()
        };
        let told = self
            .letters
            .find(&spelled(head), &loosely(head), self.at, 0);
        let letters = self.letters.letters.iter();
        let mut changes = letters.filter_map(|l| match &l.meaning {
            Meaning::Change(of) => Some(of.is_some()),
            _ => None,
        });
        let worked_out = changes
            .next()
            .map(|first| first && changes.all(|other| other));
        if *symbol != plain || told.is_some() {
            return None;
        }
        if !worked_out? {
            return Some(beyond(NOT_WORKED_OUT));
        }
        Some(self.value(argument).and_then(|value| self.change(&value)))
    }

    /// The functions that sentences or lines tell under a letter: `f(x)`.
    fn calls_of(&self, head: &Node) -> Vec<Node> {
        let own = spelled(head);
        let mut letters: Vec<&Letter> = self.letters.letters.iter().collect();
        letters.retain(|letter| letter.reach.covers(self.at, 1));
        let written = letters.into_iter().map(|letter| &letter.latex);
        let written = written.chain(self.known.shapes.keys());
        let calls = written
            .filter(|text| text.contains('('))
            .filter_map(|text| call_in(text));
        calls
            .filter(|(other, _)| spelled(other) == own)
            .map(|(_, call)| call)
            .collect()
    }

    /// Whether a letter of which alone nothing is told is one of a function.
    pub(super) fn is_function(&self, head: &Node) -> bool {
        let told = self
            .letters
            .find(&spelled(head), &loosely(head), self.at, 0);
        let symbol = matches!(head.kind, Kind::Symbol(_));
        symbol && told.is_none() && !self.calls_of(head).is_empty()
    }

    /// `f(x_k)`, where it is told what `f(x)` is and both arguments are the same.
    pub(super) fn function_at_same(
        &mut self,
        head: &Node,
        arguments: &[Node],
    ) -> Result<Option<Value>, Trouble> {
        let ([argument], Kind::Symbol(_)) = (arguments, &head.kind) else {
            return Ok(None);
        };
        for call in self.calls_of(head) {
            let Kind::Call(_, others) = &call.kind else {
                continue;
            };
            let [other] = others.as_slice() else {
                continue;
            };
            if spelled(other) == spelled(argument) {
                return Ok(None);
            }
            let unknown = self.unknown.clone();
            let (one, two) = (self.value(other)?, self.value(argument)?);
            if one == two {
                return self.value(&call).map(Some);
            }
            self.unknown = unknown;
        }
        Ok(None)
    }
}

/// The head of a writing that is a function of something, and the whole.
fn call_in(text: &str) -> Option<(Node, Node)> {
    let Row::Expression(node) = read_formula(text, 0, &Macros::default()).pop()? else {
        return None;
    };
    match &node.kind {
        Kind::Call(head, _) => Some(((**head).clone(), node)),
        _ => None,
    }
}
