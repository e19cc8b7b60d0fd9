//! Motion near a spin that words give as a list, "near the spin ⟨(0, 0, n)⟩": the component along the axis keeps its value.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{axis, inner};
use crate::verify::lines::given::is_zero;
use crate::verify::theory::{Name, Premise};
use crate::verify::values::atoms::{Owner, variable_fraction};
use crate::verify::values::lower::put_in;
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::symbol::Meaning;
use crate::verify::words::book::{has_any, lowered};
use std::collections::{BTreeSet, HashMap};

/// Words before the list.
const NEAR: &[&str] = &[
    "near the spin",
    "near the rotation",
    "near the motion",
    "near the steady spin",
    "near the steady rotation",
    "close to the spin",
    "close to the rotation",
    "about the spin",
    "around the spin",
    "around the rotation",
];

/// Words that call the components of ω small that no line has given.
const OTHERS: &[&str] = &[
    "other components",
    "other two components",
    "other two rates",
    "others",
    "other two",
    "other rates",
];
const VERBS: &[&str] = &[
    "",
    "are ",
    "being ",
    "be ",
    "remain ",
    "stay ",
    "remaining ",
    "staying ",
];
const SMALL: &[&str] = &[
    "small",
    "very small",
    "tiny",
    "infinitesimal",
    "much smaller",
];

impl Checker<'_> {
    /// Takes in that the only component of such a list that is not zero is that of the body.
    pub(crate) fn turns_near(&mut self, node: &Node) {
        let Kind::Tuple(parts) = &inner(node).kind else {
            return;
        };
        let words = lowered(self.sentence.trim_end());
        let said = NEAR.iter().any(|near| words.ends_with(near));
        let mut moving = (0u8..).zip(parts).filter(|(_, part)| !is_zero(part));
        let (Some((axis, rate)), None, 3, true) = (moving.next(), moving.next(), parts.len(), said)
        else {
            return;
        };
        let Some(rate) = self.lowering(Frame::Moving).scalar(rate) else {
            return;
        };
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let own = self.theory.atoms.part(omega, axis, 0);
        let premise = Premise {
            name: "the spin that the motion is near to".to_owned(),
            residuals: vec![variable_fraction(own) - rate],
            preferred: vec![own],
            definition: false,
        };
        if self.take_from_words(premise, node.span) {
            self.now_known([node]);
            self.small_turns.extend((0..3).filter(|&c| c != axis));
            self.drop_second_order();
        }
    }

    /// "With the big spin ⟨Ω⟩ on axis 3", "spins at ⟨n⟩ about the third axis".
    pub(crate) fn spins_about_numbered_axis(&mut self, text: &str, named: &[Node], span: Span) {
        let Some(Kind::Symbol(symbol)) = named.last().map(|node| &inner(node).kind) else {
            return;
        };
        let text = text.trim_start();
        // "Let ⟨Ω⟩ be the spin about axis 3."
        let called = ["be the ", "is the ", "denotes the "];
        let called = called.iter().find_map(|words| text.strip_prefix(words));
        let spin = ["constant spin ", "spin ", "spin rate ", "rate of spin "];
        let called = called.and_then(|rest| spin.iter().find_map(|words| rest.strip_prefix(words)));
        let behind = ["about ", "on ", "around ", "along "];
        let rest = called.unwrap_or(text);
        let Some(rest) = behind.iter().find_map(|word| rest.strip_prefix(word)) else {
            return;
        };
        let words: Vec<&str> = rest.split(|c: char| !c.is_alphanumeric()).take(3).collect();
        let numbered = match words.as_slice() {
            ["axis", number, ..] => axis(number),
            ["the", name, "axis"] => numbered_axis(name),
            _ => None,
        };
        let said = lowered(&self.sentence);
        let clause = said.rsplit([',', ';', ':', '.']).next().unwrap_or_default();
        let spins = called.is_some() || has_any(clause, &["spin", "rate", "speed", " at "]);
        let angle = has_any(clause, &["through", "angle", "turned by", "rotated by"]);
        let other = angle || has_any(clause, &["precess", "frame", "wheel", "rotor", "axes"]);
        let (Some(along), true) = (numbered, spins && !other) else {
            return;
        };
        let (symbol, node) = (symbol.clone(), named.last().cloned());
        let Meaning::Whole(entity) = self.meaning_of(&symbol) else {
            return;
        };
        let info = self.theory.atoms.info(entity);
        let own = matches!(info.owner, Owner::Symbol(_)) && info.shape == Shape::Scalar;
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let parts = [0, 1, 2].map(|c| self.theory.atoms.part(omega, c, 0));
        // What turns about another axis already is no spin of its own.
        if !own || parts.iter().any(|v| self.theory.rule(*v).is_some()) {
            return;
        }
        let turn = parts[usize::from(along)];
        let premise = Premise {
            name: "the spin about the axis that the words give".to_owned(),
            residuals: vec![variable_fraction(turn) - self.theory.atoms.value(entity, 0, 0)],
            preferred: vec![turn],
            definition: false,
        };
        if self.take_from_words(premise, span) {
            self.now_known(&node);
        }
    }

    /// "About axis 1 instead": the spin that a line gave about another axis is about this one.
    pub(crate) fn turns_to_another_axis(&mut self, text: &str, span: Span) {
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let Some(axis) = axis_instead(text) else {
            return;
        };
        if self.moves_disturbed_spin(axis, span) {
            return;
        }
        let near = self.small_turns.len() == 2;
        let new = self.theory.atoms.part(omega, axis, 0);
        let parts = [0, 1, 2].map(|c| self.theory.atoms.part(omega, c, 0));
        let of_spin = |v: &Variable| parts.contains(v) && *v != new;
        let sets = |p: &&Premise| match p.residuals.as_slice() {
            [only] => {
                let met = only.variables();
                let by_a_line = p.name.starts_with("line ");
                by_a_line && met.len() == 2 && met.iter().filter(|v| of_spin(v)).count() == 1
            }
            _ => false,
        };
        let Some(mut premise) = self.theory.premises().iter().find(sets).cloned() else {
            return;
        };
        let met = premise.residuals[0].variables();
        let Some(old) = met.into_iter().find(of_spin) else {
            return;
        };
        self.end_spin();
        self.end_premises(&BTreeSet::from([premise.name]));
        let turned = HashMap::from([(old, variable_fraction(new))]);
        premise.residuals = vec![put_in(&premise.residuals[0], &turned)];
        for variable in premise.preferred.iter_mut().filter(|v| **v == old) {
            *variable = new;
        }
        premise.name = "the same spin about another axis".to_owned();
        if self.take_from_words(premise, span) && near {
            self.small_turns.extend((0..3).filter(|&c| c != axis));
            self.drop_second_order();
        }
    }

    /// The same of a disturbed spin, ω₂ = Ω + ε₂ beside ω₁ = ε₁ and ω₃ = ε₃: another component has the Ω. What lines found
    /// of the ε of the spin before ends.
    fn moves_disturbed_spin(&mut self, axis: u8, span: Span) -> bool {
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let parts = [0, 1, 2].map(|c| self.theory.atoms.part(omega, c, 0));
        let small = |v: Variable| {
            let entity = self.theory.atoms.entity_of(v);
            entity.is_some_and(|entity| self.small.contains(&entity))
        };
        // The line that has a component alone, and beside what is small the spin.
        let disturbed = |part: Variable| {
            self.theory.premises().iter().find_map(|premise| {
                let [residual] = premise.residuals.as_slice() else {
                    return None;
                };
                let met = residual.variables();
                let of_line =
                    premise.name.starts_with("line ") && premise.preferred.contains(&part);
                let own = met.contains(&part) && met.iter().any(|v| small(*v));
                let mut rest = met.into_iter().filter(|v| *v != part && !small(*v));
                let spin = rest.next();
                (of_line && own && rest.next().is_none()).then(|| (premise.clone(), spin))
            })
        };
        let found = parts.map(disturbed);
        let [Some(one), Some(two), Some(three)] = found else {
            return false;
        };
        let all = [one, two, three];
        let mut spinning = all
            .iter()
            .enumerate()
            .filter(|(_, (_, spin))| spin.is_some());
        let (Some((old, (_, Some(spin)))), None) = (spinning.next(), spinning.next()) else {
            return false;
        };
        let (new, spin) = (usize::from(axis), *spin);
        if old == new {
            return false;
        }
        let nothing = Fraction::from_ratio(0, 1);
        let moved = variable_fraction(parts[new]) - variable_fraction(spin);
        let found: BTreeSet<Name> = {
            let premises = self.theory.premises().iter();
            let of_line = premises.filter(|premise| premise.name.starts_with("line "));
            let theirs = of_line.filter(|premise| {
                let mut met = premise.residuals.iter().flat_map(Fraction::variables);
                met.any(small)
            });
            theirs.map(|premise| premise.name.clone()).collect()
        };
        self.end_premises(&found);
        for (at, (mut premise, _)) in all.into_iter().enumerate() {
            let image = match at {
                _ if at == new => HashMap::from([(parts[new], moved.clone())]),
                _ => HashMap::from([(spin, nothing.clone())]),
            };
            premise.residuals = vec![put_in(&premise.residuals[0], &image)];
            premise.name = "the same disturbance of a spin about another axis".to_owned();
            self.take_from_words(premise, span);
        }
        true
    }

    /// "Let ⟨ω_3 = n⟩ be constant and the other components small."
    pub(crate) fn others_are_small(&mut self, text: &str) {
        let behind = OTHERS.iter().filter_map(|others| text.split_once(others));
        let mut rests = behind.map(|(_, rest)| rest.trim_start());
        let small = |rest: &str| {
            let called = |rest: &str| SMALL.iter().any(|word| rest.starts_with(word));
            let mut verbs = VERBS.iter();
            verbs.any(|verb| rest.strip_prefix(verb).is_some_and(called))
        };
        if !rests.any(small) {
            return;
        }
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let given: Vec<u8> = (0..3)
            .filter(|&c| {
                let variable = self.theory.atoms.part(omega, c, 0);
                self.theory.rule(variable).is_some()
            })
            .collect();
        if let [axis] = given.as_slice() {
            self.small_turns.extend((0..3).filter(|c| c != axis));
            self.drop_second_order();
        }
    }
}

/// The axis that words turn to: "about axis 1 instead", "about the first axis instead".
fn axis_instead(text: &str) -> Option<u8> {
    let (before, _) = text.split_once("instead")?;
    let clause = before.rsplit(['.', ';', ':']).next()?;
    let (_, about) = clause.rsplit_once("about ")?;
    let words = about.split(|c: char| !c.is_alphanumeric());
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    let short = words.len() <= 4 && words.contains(&"axis");
    let mut named = words.into_iter().filter_map(numbered_axis);
    named.next().filter(|_| short)
}

fn numbered_axis(word: &str) -> Option<u8> {
    match word {
        "first" => Some(0),
        "second" => Some(1),
        "third" => Some(2),
        other => axis(other),
    }
}
