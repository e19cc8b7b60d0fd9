//! `polhode help`: the help of a command, or the manuals of what is read.

use crate::cli::output;
use crate::notation::MANUAL;
use crate::scene;
use crate::verify::language;
use anstream::ColorChoice;
use clap::{Args, Command};
use std::collections::BTreeSet;

/// Prints the help of a command, or of what is read: `notation` of documents, the `language` of declarations, `scene` files
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  polhode help check
  polhode help notation
  polhode help language
  polhode help scene")]
pub(super) struct Options {
    /// A command, `notation`, `language` or `scene`
    topic: Option<String>,
}

/// Prints what was asked for and returns the exit code.
pub(super) fn run(options: &Options, mut command: Command, color: ColorChoice) -> u8 {
    let topic = options.topic.as_deref();
    match topic {
        Some("notation") => return output::deliver(&manual(), None, color),
        Some("language") => return output::deliver(&language_manual(), None, color),
        Some("scene") => return output::deliver(scene::MANUAL, None, color),
        _ => {}
    }
    command.build();
    let asked = match topic {
        Some(topic) => command.find_subcommand_mut(topic),
        None => Some(&mut command),
    };
    let Some(asked) = asked else {
        eprintln!(
            "error: there is no help on that; `polhode help` names the commands, and `notation`, `language` and `scene` are topics"
        );
        return 2;
    };
    let text = asked.render_long_help().ansi().to_string();
    output::deliver(&text, None, color)
}

/// The manual of the language; its backticks belong to the sentences.
fn language_manual() -> String {
    let manual = language::manual(&language::Lexicon::default());
    let lines = manual
        .lines()
        .map(|line| line.trim_start_matches('#').trim_start());
    lines.map(|line| format!("{line}\n")).collect()
}

/// The manual for a terminal: each row of a table as its spellings and, below them, what they are read as.
fn manual() -> String {
    let mut text = String::new();
    let mut in_table = false;
    for line in MANUAL.lines() {
        let row = line
            .strip_prefix("| ")
            .and_then(|row| row.strip_suffix('|'));
        match row {
            Some(row) if in_table => text.push_str(&self::row(row)),
            // The heads of the columns; a table follows a blank line and a heading that says enough.
            Some(row) => text.push_str(&heads(row)),
            None => {
                text.push_str(&plain(line.trim_start_matches('#').trim_start()));
                text.push('\n');
            }
        }
        in_table = row.is_some();
    }
    text
}

/// Widest line of spellings.
const WIDTH: usize = 96;

fn cells(row: &str) -> Vec<String> {
    let bar = "\u{1}";
    let row = row.replace("\\|", bar);
    row.split('|')
        .map(|cell| cell.trim().replace(bar, "|"))
        .collect()
}

fn heads(row: &str) -> String {
    let cells = cells(row);
    match cells.as_slice() {
        [first, .., last] if first != "LaTeX" => format!("{first}: {last}\n"),
        _ => String::new(),
    }
}

/// The spellings of a row on as many lines as they need, and below them the last cell.
fn row(row: &str) -> String {
    let cells = cells(row);
    let Some((last, spellings)) = cells.split_last().filter(|(last, _)| *last != "---") else {
        return String::new();
    };
    let mut text = String::new();
    let mut width = WIDTH;
    let code = |cell: &String| pieces(cell).into_iter().filter(|piece| piece.code);
    let mut shown = BTreeSet::new();
    // What two columns have in common is shown once.
    let all = spellings.iter().flat_map(|cell| code(cell));
    for spelling in all.filter(|spelling| shown.insert(spelling.text.clone())) {
        let length = spelling.text.chars().count() + 3;
        if width + length > WIDTH {
            text.push_str(if text.is_empty() { "  " } else { "\n  " });
            width = 0;
        } else {
            text.push_str("   ");
        }
        text.push_str(&spelling.text);
        width += length;
    }
    format!("{text}\n      → {}\n", plain(last))
}

/// A part of a text in Markdown: words, or code between backticks.
struct Piece {
    code: bool,
    text: String,
}

/// The words and the code of a text; a space inside several backticks belongs to them.
fn pieces(text: &str) -> Vec<Piece> {
    let mut out = vec![];
    let mut rest = text;
    while let Some(start) = rest.find('`') {
        let (words, marked) = rest.split_at(start);
        let run = marked.len() - marked.trim_start_matches('`').len();
        let (mark, inner) = marked.split_at(run);
        let Some((code, after)) = inner.split_once(mark) else {
            break;
        };
        out.push(Piece {
            code: false,
            text: words.replace('*', ""),
        });
        let code = if run > 1 { code.trim() } else { code };
        out.push(Piece {
            code: true,
            text: code.to_owned(),
        });
        rest = after;
    }
    out.push(Piece {
        code: false,
        text: rest.replace('*', ""),
    });
    out
}

/// Without the marks of code and of stress.
fn plain(text: &str) -> String {
    pieces(text).into_iter().map(|piece| piece.text).collect()
}
