//! A derivation as Markdown, LaTeX, plain text and JSON.

use crate::report::derive::{About, Block, Derivation, Piece, Row};
use crate::verify::derivation::Text;
use serde::Serialize;

impl Derivation {
    /// Markdown with LaTeX mathematics; `polhode check` reads it.
    pub fn markdown(&self) -> String {
        let blocks = self.blocks.iter().map(|block| match block {
            Block::Heading(level, text) => format!("{} {text}\n", "#".repeat(*level)),
            Block::Prose(pieces) => latex_prose(pieces) + "\n",
            Block::Display(rows) => format!("$$\n{}\n$$\n", latex_display(rows)),
        });
        self.front_matter() + &blocks.collect::<Vec<_>>().join("\n")
    }

    /// The sentences about letters, in front of all.
    fn front_matter(&self) -> String {
        match &self.about {
            About::System { letters } if !letters.is_empty() => {
                format!("---\npolhode:\n- {}\n---\n\n", letters.join("\n- "))
            }
            _ => String::new(),
        }
    }

    /// A LaTeX file of its own.
    pub fn latex(&self) -> String {
        let blocks = self.blocks.iter().map(|block| match block {
            Block::Heading(1, text) => format!("\\section*{{{text}}}\n"),
            Block::Heading(_, text) => format!("\\subsection*{{{text}}}\n"),
            Block::Prose(pieces) => latex_prose(pieces) + "\n",
            Block::Display(rows) => latex_align(rows),
        });
        let body = blocks.collect::<Vec<_>>().join("\n");
        let comments = match &self.about {
            About::System { letters } => letters.iter(),
            About::Body { .. } => [].iter(),
        };
        let comments: String = comments
            .map(|sentence| format!("% polhode: {sentence}\n"))
            .collect();
        format!(
            "{comments}\\documentclass{{article}}\n\\usepackage{{amsmath}}\n\\begin{{document}}\n\n{body}\n\\end{{document}}\n"
        )
    }

    /// Plain text with Unicode signs.
    pub fn unicode(&self) -> String {
        let blocks = self.blocks.iter().map(|block| match block {
            Block::Heading(level, text) => {
                let rule = if *level == 1 { "=" } else { "-" };
                format!("{text}\n{}\n", rule.repeat(text.chars().count()))
            }
            Block::Prose(pieces) => unicode_prose(pieces) + "\n",
            Block::Display(rows) => unicode_display(rows),
        });
        self.front_matter() + &blocks.collect::<Vec<_>>().join("\n")
    }

    /// JSON: the options, and every block with its lines in both styles.
    ///
    /// # Errors
    /// None in practice: strings always serialise.
    pub fn json(&self) -> serde_json::Result<String> {
        let blocks = self.blocks.iter().map(|block| match block {
            Block::Heading(level, text) => JsonBlock::Heading {
                level: *level,
                heading: text,
            },
            Block::Prose(pieces) => JsonBlock::Prose {
                latex: latex_prose(pieces),
                unicode: unicode_prose(pieces),
            },
            Block::Display(rows) => JsonBlock::Lines {
                lines: rows.iter().map(JsonLine::from).collect(),
            },
        });
        let page = JsonPage {
            schema: "polhode-derive/1",
            about: &self.about,
            blocks: blocks.collect(),
        };
        serde_json::to_string_pretty(&page).map(|text| text + "\n")
    }
}

#[derive(Serialize)]
struct JsonPage<'a> {
    schema: &'static str,
    #[serde(flatten)]
    about: &'a About,
    blocks: Vec<JsonBlock<'a>>,
}

#[derive(Serialize)]
#[serde(untagged)]
enum JsonBlock<'a> {
    Heading { level: usize, heading: &'a str },
    Prose { latex: String, unicode: String },
    Lines { lines: Vec<JsonLine> },
}

#[derive(Serialize)]
struct JsonLine {
    label: String,
    latex: String,
    unicode: String,
}

impl From<&Row> for JsonLine {
    fn from(row: &Row) -> Self {
        Self {
            label: format!("({})", row.label),
            latex: format!("{} = {}", row.left.latex, row.right.latex),
            unicode: format!("{} = {}", row.left.unicode, row.right.unicode),
        }
    }
}

fn latex_prose(pieces: &[Piece]) -> String {
    let text = pieces.iter().map(|piece| match piece {
        Piece::Words(words) => (*words).to_owned(),
        Piece::Sentence(sentence) => sentence.clone(),
        Piece::Formula(formula) => format!("${}$", formula.latex),
    });
    text.collect()
}

fn unicode_prose(pieces: &[Piece]) -> String {
    let text = pieces.iter().map(|piece| match piece {
        Piece::Words(words) => words.replace('$', ""),
        Piece::Sentence(sentence) => without_dollars(sentence),
        Piece::Formula(formula) => formula.unicode.clone(),
    });
    text.collect()
}

fn latex_display(rows: &[Row]) -> String {
    if let [row] = rows {
        return format!(
            "{} = {} \\tag{{{}}}",
            row.left.latex, row.right.latex, row.label
        );
    }
    format!("\\begin{{align}}\n{}\n\\end{{align}}", latex_rows(rows))
}

fn latex_align(rows: &[Row]) -> String {
    format!("\\begin{{align}}\n{}\n\\end{{align}}\n", latex_rows(rows))
}

fn latex_rows(rows: &[Row]) -> String {
    let rows = rows.iter().map(|row| {
        format!(
            "{} &= {} \\tag{{{}}}",
            row.left.latex, row.right.latex, row.label
        )
    });
    rows.collect::<Vec<_>>().join(" \\\\\n")
}

/// Without labels, as a number in parentheses behind a line of plain text would be a factor.
fn unicode_display(rows: &[Row]) -> String {
    let lines = rows
        .iter()
        .map(|row| format!("    {} = {}\n", row.left.unicode, row.right.unicode));
    lines.collect()
}

/// A sentence with its formulas in Unicode.
fn without_dollars(sentence: &str) -> String {
    let parts = sentence.split('$').enumerate();
    let shown = parts.map(|(number, part)| match number % 2 {
        0 => part.to_owned(),
        _ => Text::of(part).unicode,
    });
    shown.collect()
}
