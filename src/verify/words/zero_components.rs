//! Components that words call zero: "⟨ω_x⟩ and ⟨ω_y⟩ vanish", "the body turns about ⟨z⟩ only".

use crate::notation::ast::{Kind, Node};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::usage::inner;
use crate::verify::values::atoms::Owner;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::words::book::{has_any, lowered};
use crate::verify::words::role::Words;

/// What is said right behind the components.
const ZERO: &[&str] = &[
    "are zero",
    "are both zero",
    "are always zero",
    "are identically zero",
    "is zero",
    "is always zero",
    "vanish",
    "both vanish",
    "vanishes",
];
const TURNS: &[&str] = &["turn", "rotat", "spin", "driven", "spun"];
/// Words of what is yet to be shown, or of another body.
const OPEN: &[&str] = &[
    "show", "prove", "whether", "where", "see that", "find", "frame", "axes",
];
/// Words before a line that says the same.
const SO: &[&str] = &["so", "hence", "thus", "i.e.", "that"];
/// The names of the axes in words.
const AXES: [[&str; 2]; 3] = [["x", "1"], ["y", "2"], ["z", "3"]];
/// The name of the premise.
const NAME: &str = "components of the angular velocity that the words call zero";

impl Checker<'_> {
    /// Takes in that the components of ω that stand right before these words, a piece of prose in small letters, are zero.
    pub(crate) fn zero_components(&mut self, text: &str, named: &[Node], span: Span) {
        let said = lowered(&self.sentence);
        let derived = Words::of(&self.sentence).derive() || has_any(&said, OPEN);
        let rest = text.trim_start_matches(',').trim_start();
        let zero = ZERO.iter().any(|words| {
            let behind = rest.strip_prefix(words);
            behind.is_some_and(|behind| !behind.starts_with(char::is_alphanumeric))
        });
        if derived || !zero || named.is_empty() {
            return;
        }
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let components: Option<Vec<u8>> = named
            .iter()
            .map(|node| self.component_of_turn(node))
            .collect();
        if let Some(components) = components
            && self.vanishes_in(NAME, omega, &components)
        {
            self.tell(span, NAME.to_owned());
        }
    }

    fn component_of_turn(&mut self, node: &Node) -> Option<u8> {
        let Kind::Symbol(symbol) = &inner(node).kind else {
            return None;
        };
        let Meaning::Component(entity, component) = self.meaning_of(symbol) else {
            return None;
        };
        let owner = &self.theory.atoms.info(entity).owner;
        let turns =
            matches!(owner, Owner::Quantity(Quantity::AngularVelocity, label) if label.is_empty());
        turns.then_some(component)
    }

    /// Takes in that the body turns about one axis alone.
    pub(crate) fn turns_about_one_axis_only(&mut self, text: &str, span: Span) {
        let behind = ["only", "alone"]
            .iter()
            .find_map(|word| text.split_once(word));
        // "About ⟨z⟩ only, so ⟨ω = ω k⟩": the line says it.
        let said_by_line = |(_, rest): (&str, &str)| {
            let clause = rest.split(['.', ';']).next().unwrap_or_default();
            clause
                .split_whitespace()
                .any(|word| SO.contains(&word.trim_matches(',')))
        };
        if behind.is_none_or(said_by_line) {
            return;
        }
        let said = format!("{}{text}", lowered(&self.sentence)).replace("⟨⟩", "");
        let said: Vec<&str> = said.split_whitespace().collect();
        let said = said.join(" ");
        let derived = Words::of(&self.sentence).derive();
        let axis = said.split(['.', ';', ':']).find_map(|clause| {
            let turns = has_any(clause, TURNS) && !has_any(clause, OPEN);
            let about = |names: &[&str; 2]| names.iter().any(|name| is_about_alone(clause, name));
            AXES.iter().position(about).filter(|_| turns)
        });
        let Some(axis) = axis.filter(|_| !derived) else {
            return;
        };
        let others: Vec<u8> = (0..3).filter(|c| usize::from(*c) != axis).collect();
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        if self.vanishes_in(NAME, omega, &others) {
            self.tell(span, NAME.to_owned());
        }
    }
}

/// "About the z axis only."
fn is_about_alone(clause: &str, name: &str) -> bool {
    let axes = [
        format!("about {name}"),
        format!("about the {name} axis"),
        format!("about the {name}-axis"),
        format!("about axis {name}"),
    ];
    axes.iter().any(|axis| {
        clause.contains(&format!("{axis} only"))
            || clause.contains(&format!("{axis} alone"))
            || clause.ends_with(&format!("only {axis}"))
    })
}
