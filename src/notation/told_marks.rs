//! Commands that a document uses and does not define. Its author's sentences set them around single letters, which they
//! only mark, `\uvec{k}`, or speak of them as of letters, `\th`.

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

/// The commands that sentences set around single letters or name as letters, each with what it stands for.
pub(super) fn told_marks<'s>(
    sentences: impl Iterator<Item = &'s str>,
    text: &str,
    macros: &Macros,
) -> Vec<(String, String)> {
    let mut letters: BTreeSet<String> = BTreeSet::new();
    let mut commands: BTreeSet<String> = BTreeSet::new();
    let mut looks = LOOKS.to_vec();
    for sentence in sentences {
        looks.retain(|(_, mark)| !sentence.contains(mark));
        if !sentence.contains(FOR_ANY) && commands.len() < MOST {
            commands.extend(commands_around_letters(sentence).map(str::to_owned));
        }
        if letters.len() < MOST {
            letters.extend(commands_alone(sentence).map(str::to_owned));
        }
    }
    letters.retain(|command| !takes_argument(command, text) && is_unknown(command, macros));
    commands.retain(|command| !letters.contains(command));
    let unknown = commands.into_iter();
    let unknown = unknown.filter(|command| is_unknown(command, macros));
    // A letter that one of them marks is another letter than the same one marked by another.
    let marks = unknown.zip(looks.into_iter().map(|(look, _)| look.to_owned()));
    let named = letters.into_iter().map(|letter| {
        let name = format!("\\mathrm{{{letter}}}");
        (letter, name)
    });
    marks.chain(named).collect()
}

/// The commands that stand alone as formulas of a sentence: `$\th$`.
fn commands_alone(sentence: &str) -> impl Iterator<Item = &str> {
    let formulas = sentence.split(['$', '`']).skip(1).step_by(2);
    let commands = formulas.filter_map(|formula| formula.trim().strip_prefix('\\'));
    commands.filter(|command| {
        !command.is_empty() && command.bytes().all(|byte| byte.is_ascii_alphabetic())
    })
}

/// Whether a text writes a command with an argument in braces or brackets of its own: no letter has one.
fn takes_argument(command: &str, text: &str) -> bool {
    let call = format!("\\{command}");
    let mut calls = text
        .match_indices(&call)
        .map(|(at, call)| &text[at + call.len()..]);
    calls.any(|rest| rest.trim_start().starts_with(['{', '[']))
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
