//! The page of one student as Markdown, for platforms that show that.

use crate::grade::{Graded, Key, Line};
use crate::report::grade::page::in_words;
use crate::report::html::{is_drawn, sentence, verdict};

/// The page of a student, of what is told.
pub fn student(key: &Key, told: &Graded) -> String {
    let mut text = format!(
        "# {}\n\n**{}** of {} marks\n\n",
        plain(&told.id),
        told.marks,
        key.max()
    );
    if told.queue.is_some() {
        text.push_str("A person will look at this work; the marks may change.\n\n");
    }
    text.push_str("| Milestone | Marks | Result |\n| --- | --- | --- |\n");
    for reached in &told.milestones {
        let why = match reached.reason.is_empty() {
            true => String::new(),
            false => format!(". {}", prose(&reached.reason)),
        };
        text.push_str(&format!(
            "| {} | {} of {} | {}{why} |\n",
            plain(&reached.label),
            reached.marks,
            reached.max,
            in_words(reached.outcome)
        ));
    }
    for note in &told.notes {
        text.push_str(&format!("\n{}\n", prose(note)));
    }
    if let Some(slip) = &told.first_slip {
        text.push_str(&format!(
            "\n## The first slip\n\nIt is in {}.",
            plain(&slip.place.to_string())
        ));
        if !slip.message.is_empty() {
            text.push_str(&format!(" {}", prose(&slip.message)));
        }
        text.push('\n');
        if let Some(repair) = &slip.repair {
            text.push_str(&format!("\nWrite instead:\n\n{}", formula(repair)));
        }
    }
    let mut own = told.assumptions.iter().filter(|a| !a.in_key).peekable();
    if own.peek().is_some() {
        text.push_str("\n## What you assume and the task does not\n\n");
    }
    for assumption in own {
        let place = plain(&assumption.place.to_string());
        text.push_str(&format!("{place}:\n\n{}\n", formula(&assumption.text)));
    }
    if !told.lines.is_empty() {
        text.push_str("\n## Your lines\n");
    }
    told.lines.iter().for_each(|one| text.push_str(&line(one)));
    text
}

fn line(line: &Line) -> String {
    let place = plain(&line.place.to_string());
    let mut text = format!("\n{place}: {}\n\n{}", verdict(line), formula(&line.source));
    if let Some(said) = line.mistake.as_ref().or(line.reason.as_ref()) {
        text.push_str(&format!("\n{}\n", prose(said)));
    }
    if let Some(repair) = &line.repair {
        text.push_str(&format!("\nWrite instead:\n\n{}", formula(repair)));
    }
    if let Some(numbers) = &line.counterexample {
        let each = numbers.symbols.iter();
        let each: Vec<String> = each
            .map(|(symbol, value)| format!("{} = {}", code(symbol), plain(value)))
            .collect();
        text.push_str(&format!(
            "\nWith {} the left side is {} and the right side is {}.\n",
            each.join(", "),
            plain(&numbers.left),
            plain(&numbers.right)
        ));
    }
    text
}

/// A formula in a fence that nothing in it closes. One that is not drawn on the page, as it may have a link in it, is not
/// drawn by platforms either.
fn formula(source: &str) -> String {
    let fence = "`".repeat((longest_run(source) + 1).max(3));
    let language = if is_drawn(source) { "math" } else { "" };
    format!("{fence}{language}\n{}\n{fence}\n", source.trim())
}

/// A symbol as it is written.
fn code(symbol: &str) -> String {
    let fence = "`".repeat(longest_run(symbol) + 1);
    format!("{fence}{}{fence}", symbol.replace(['\n', '\r'], " "))
}

/// The longest row of backticks in a text.
fn longest_run(text: &str) -> usize {
    if !text.contains('`') {
        return 0;
    }
    let rows = text.split(|c| c != '`').map(str::len);
    rows.max().unwrap_or(0)
}

/// A clause as a sentence, in which formulas between backticks are code.
fn prose(clause: &str) -> String {
    let said = sentence(clause).replace('|', "\u{2223}");
    let parts = said.split('`').enumerate();
    let parts = parts.map(|(at, part)| match at % 2 == 1 && !part.is_empty() {
        true => code(part),
        false => plain(part),
    });
    parts.collect()
}

/// Text in which no character marks anything up.
fn plain(text: &str) -> String {
    let mut plain = String::with_capacity(text.len() + text.len() / 8);
    for c in text.chars() {
        match c {
            '<' => plain.push_str("&lt;"),
            '>' => plain.push_str("&gt;"),
            '&' => plain.push_str("&amp;"),
            '\n' | '\r' | '\t' => plain.push(' '),
            '\\' | '`' | '*' | '_' | '{' | '}' | '[' | ']' | '#' | '|' | '!' | '~' | '$' => {
                plain.extend(['\\', c]);
            }
            _ => plain.push(c),
        }
    }
    plain
}
