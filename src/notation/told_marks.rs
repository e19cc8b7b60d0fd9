//! Commands that a document uses and does not define, and that its author's sentences set around single letters: they
//! only mark these letters, `\uvec{k}`.

use crate::notation::ast::{Kind, Node};
use crate::notation::document::Row;
use crate::notation::token::matching_brace;
use crate::notation::{Macros, read_formula};
use std::collections::BTreeSet;

/// A word that says something of any letter: then a command is an operator.
const FOR_ANY: &str = "any ";

/// How letters may look that a command of the author's own marks, each with the mark of which no rule may speak then.
const LOOKS: [(&str, &str); 4] = [
    ("\\check{#1}", "check"),
    ("\\check{\\mathcal{#1}}", "check"),
    ("\\check{\\hat{#1}}", "hat"),
    ("\\check{\\tilde{#1}}", "tilde"),
];

/// No more commands are looked at.
const MOST: usize = 100;

/// The commands that sentences set around single letters, each with what it stands for.
pub(super) fn told_marks<'s>(
    sentences: impl Iterator<Item = &'s str>,
    macros: &Macros,
) -> Vec<(String, &'static str)> {
    let mut commands: BTreeSet<String> = BTreeSet::new();
    let mut looks = LOOKS.to_vec();
    for sentence in sentences {
        looks.retain(|(_, mark)| !sentence.contains(mark));
        if !sentence.contains(FOR_ANY) && commands.len() < MOST {
            commands.extend(commands_around_letters(sentence).map(str::to_owned));
        }
    }
    let unknown = commands.into_iter();
    let unknown = unknown.filter(|command| is_unknown(command, macros));
    // A letter that one of them marks is another letter than the same one marked by another.
    unknown
        .zip(looks.into_iter().map(|(look, _)| look))
        .collect()
}

/// The commands of a text that have one letter as their argument.
fn commands_around_letters(text: &str) -> impl Iterator<Item = &str> {
    let starts = text.match_indices('\\').map(|(at, _)| at + 1);
    starts.filter_map(|start| {
        let rest = &text[start..];
        let length = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
        let (command, rest) = rest.split_at(length);
        let rest = rest.trim_start();
        let argument = match rest.strip_prefix('{') {
            Some(inside) => inside.get(..matching_brace(inside)?)?,
            None => first_letter(rest)?,
        };
        let argument = argument.trim();
        let is_letter = first_letter(argument) == Some(argument);
        (is_letter && !command.is_empty()).then_some(command)
    })
}

/// The letter that a text begins with: `k`, `\omega`.
fn first_letter(text: &str) -> Option<&str> {
    let length = match text.strip_prefix('\\') {
        Some(rest) => 1 + rest.bytes().take_while(u8::is_ascii_alphabetic).count(),
        None => text
            .chars()
            .next()
            .filter(|c| c.is_alphabetic())?
            .len_utf8(),
    };
    text.get(..length).filter(|letter| *letter != "\\")
}

fn is_unknown(command: &str, macros: &Macros) -> bool {
    // Behind a letter an operator is known.
    let rows = read_formula(&format!("a\\{command}{{a}}"), 0, macros);
    let unknown = format!("\\{command} is not known");
    let error = |row: &Row| match row {
        Row::Expression(node) => has_error(node, &unknown),
        Row::Unreadable { message, .. } => message.contains(&unknown),
        Row::Line(_) => false,
    };
    rows.iter().any(error)
}

fn has_error(node: &Node, about: &str) -> bool {
    matches!(&node.kind, Kind::Error(message) if message.contains(about))
        || node.children().any(|child| has_error(child, about))
}
