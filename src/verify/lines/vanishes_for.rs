//! Conditions under which what stands before is zero: "it vanishes for ⟨tan 2θ = …⟩".

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Function, Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::theory::Premise;
use crate::verify::theory::decide::{Decision, Equation, decide, passes_filter};
use crate::verify::values::atoms::{Atom, variable_fraction};
use crate::verify::values::lower::{put_in, substituted};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::value::Value;
use crate::verify::verdict::{Finding, Role, Verdict};
use crate::verify::words::book::{has_any, lowered};
use std::collections::{BTreeSet, HashMap};

const VANISHES: &[&str] = &[
    "vanishes",
    "vanish",
    "is zero",
    "disappears",
    "becomes zero",
];
const UNDER: &[&str] = &[
    "for",
    "if",
    "when",
    "at",
    "where",
    "provided",
    "provided that",
];

impl Checker<'_> {
    /// Checks that the last side before is zero if a line holds, where the words say so, and supposes the line then.
    pub(crate) fn vanishes_for(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let subject = match says_so(&self.sentence) {
            true => self.last_side.clone(),
            false => self
                .last_product
                .clone()
                .filter(|_| says_of_product(&self.sentence)),
        };
        let Some(subject) = subject else {
            return false;
        };
        let Ok(subject) = self.lowering(Frame::Moving).value(&subject) else {
            return false;
        };
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return false;
        };
        if !self.drop_condition(&subject) {
            return false;
        }
        let Some(subject) = self.at_the_angle_of(&subject, &sides[0]) else {
            return false;
        };
        let name = self.line_name(finding);
        self.theory.assume(Premise {
            name: name.clone(),
            residuals: read.residuals().cloned().collect(),
            preferred: vec![],
            definition: false,
        });
        match decide(&mut self.theory, &[Equation::vanishing(subject)]) {
            Decision::True(_) => {
                self.keep(&name, false);
                finding.role = Role::Assume;
                finding.verdict = Verdict::Accepted;
                finding
                    .remarks
                    .push("what stands before vanishes then".to_owned());
                return true;
            }
            Decision::False(witness) => {
                finding.verdict = Verdict::Refuted;
                finding.reason = Some("what stands before does not vanish then".to_owned());
                finding.counterexample = Some(*witness);
            }
            _ => {}
        }
        self.theory.retain(|premise| premise.name != name);
        finding.verdict == Verdict::Refuted
    }
}

impl Checker<'_> {
    /// A value with the angle of a tangent in the place of its own, where it has one only and the tangent another:
    /// "the product vanishes on axes that are inclined at the angle ⟨ε⟩"; `None` where it has no angle at all.
    fn at_the_angle_of(&mut self, subject: &Value, side: &Node) -> Option<Value> {
        let Kind::Function(Function::Tan, argument) = &inner(side).kind else {
            return Some(subject.clone());
        };
        let argument = self.lowering(Frame::Moving).scalar(argument)?;
        let normal = subject.map(|entry| self.theory.normal(entry));
        let kernels: Vec<(Variable, Function, Fraction)> = normal
            .entries
            .iter()
            .flat_map(Fraction::variables)
            .filter_map(|v| match self.theory.atoms.atom(v) {
                Atom::Kernel { function, argument } => Some((v, *function, argument.clone())),
                _ => None,
            })
            .collect();
        let own: BTreeSet<Variable> = kernels.iter().flat_map(|(_, _, a)| a.variables()).collect();
        let inside = argument.variables();
        let own = own.first().copied().filter(|_| own.len() == 1)?;
        let [other] = inside.as_slice() else {
            return None;
        };
        if own == *other {
            return Some(subject.clone());
        }
        let turned: HashMap<Variable, Fraction> = kernels
            .into_iter()
            .map(|(v, function, argument)| {
                let argument = substituted(&argument, &|_| variable_fraction(*other));
                (v, self.theory.kernel(function, argument))
            })
            .collect();
        Some(normal.map(|entry| put_in(entry, &turned)))
    }

    /// Lets go of a condition right before that says what the line at hand says anew: "principal when ⟨I_{x'y'} = 0⟩, which
    /// happens at the angle given by"; `false` where the value vanishes without it.
    fn drop_condition(&mut self, subject: &Value) -> bool {
        if passes_filter(&mut self.theory, subject) != Some(true) {
            return true;
        }
        let accepted = matches!(self.findings.last(), Some(f) if f.verdict == Verdict::Accepted);
        let last = self.theory.premises().last().filter(|_| accepted);
        let name = last.map(|premise| premise.name.clone());
        let Some(name) = name else { return false };
        self.theory.retain(|premise| premise.name != name);
        passes_filter(&mut self.theory, subject) != Some(true)
    }

    /// Keeps the product of inertia that a line says most lately what it is.
    pub(crate) fn note_product(&mut self, sides: &[Node]) {
        let [left, _, ..] = sides else { return };
        if let Kind::Symbol(symbol) = &inner(left).kind
            && self.reading.quantities.get(&Letter::of(symbol)) == Some(&Quantity::Inertia)
        {
            let index = symbol.subscripts.concat();
            // Of `x'y'` and of `xz_s` too.
            let mut letters = index.chars().filter(char::is_ascii_alphabetic);
            let named = |c: char| matches!(c, 'x' | 'y' | 'z' | 'X' | 'Y' | 'Z');
            let (first, second) = (letters.next(), letters.next());
            if let (Some(a), Some(b)) = (first, second)
                && a != b
                && (letters.next().is_none() || named(a) && named(b))
                && named(a) == named(b)
            {
                self.last_product = Some(left.clone());
            }
        }
    }
}

/// "The product of inertia vanishes on axes which are found from": words before a formula say of the product that was
/// spoken of last that it is zero then.
fn says_of_product(sentence: &str) -> bool {
    let text = lowered(sentence);
    let text = text.trim_end_matches([' ', '.', ':']);
    let determined = [
        "found from",
        "given by",
        "determined by",
        "follow from",
        "follows from",
    ];
    let vanishes = has_any(
        text,
        &["product of inertia", "product vanish", "product is zero"],
    ) && has_any(text, VANISHES);
    let principal = has_any(text, &["axes are principal", "axes become principal"]);
    let inclined = text.contains("angle") && text.ends_with(" with");
    (vanishes || principal)
        && determined
            .iter()
            .chain(UNDER)
            .any(|end| text.ends_with(end))
        || vanishes && inclined
}

/// Whether the words behind the last formula say so of it.
fn says_so(sentence: &str) -> bool {
    let text = lowered(sentence.rsplit('⟩').next().unwrap_or_default());
    // A paragraph that ends there ends no sentence.
    let text = text.trim_end_matches([' ', '.', ':']);
    let first = text
        .split_whitespace()
        .find(|word| word.starts_with(char::is_alphabetic));
    let end = |text: &str| {
        UNDER
            .iter()
            .find_map(|word| Some(text.strip_suffix(word)?.trim_end().len()))
    };
    matches!(first, Some("it" | "this" | "which"))
        && end(text).is_some_and(|at| VANISHES.iter().any(|verb| text[..at].ends_with(verb)))
}
