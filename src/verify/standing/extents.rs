//! Parts of a document that a sentence names by what stands there: from one label to another, under a numbered heading.

use crate::notation::document::{Document, Item, Row};
use crate::verify::language::statement::{Declaration, Extent};

/// The declarations with the lines that labels stand on, and headings as they are written. A sentence about labels that
/// the document does not have is one that was not understood.
pub(crate) fn located(document: &Document, declarations: &[Declaration]) -> Vec<Declaration> {
    let places = Places::of(document);
    let one = |declaration: &Declaration| match places.located(&declaration.extent) {
        Some(extent) => Declaration {
            extent,
            ..declaration.clone()
        },
        None => Declaration {
            line: declaration.line,
            ..Declaration::unread(declaration.text.clone())
        },
    };
    declarations.iter().map(one).collect()
}

/// What stands where in a document.
struct Places {
    /// Labels, with their cells and lines.
    labels: Vec<(String, Option<usize>, usize)>,
    headings: Vec<String>,
}

impl Places {
    fn of(document: &Document) -> Self {
        let (mut labels, mut headings) = (vec![], vec![]);
        for item in &document.items {
            match item {
                Item::Heading { text, .. } => headings.push(text.trim().to_owned()),
                Item::Formula(formula) => {
                    for row in &formula.rows {
                        let Row::Line(line) = row else { continue };
                        let place = document.place_of_row(line.span.start);
                        let own = line.labels.iter().map(|label| bare(label));
                        labels.extend(own.map(|label| (label, place.cell, place.line)));
                    }
                }
                _ => {}
            }
        }
        Self { labels, headings }
    }

    /// The same part of the document by lines and whole headings; `None` if a label stands nowhere.
    fn located(&self, extent: &Extent) -> Option<Extent> {
        Some(match extent {
            Extent::Between(from, to) => {
                let (cell, first) = self.label(from)?;
                let last = match to.is_empty() {
                    true => None,
                    false => Some(self.label(to)?),
                };
                if last.is_some_and(|(end, line)| end != cell || line < first) {
                    return None;
                }
                Extent::Lines {
                    cell,
                    first,
                    last: last.map(|(_, line)| line),
                }
            }
            Extent::Section(title) => {
                let mut headings = self.headings.iter();
                let heading = headings.find(|heading| begins(heading, title));
                Extent::Section(heading.unwrap_or(title).clone())
            }
            Extent::Both(a, b) => {
                Extent::Both(Box::new(self.located(a)?), Box::new(self.located(b)?))
            }
            other => other.clone(),
        })
    }

    fn label(&self, label: &str) -> Option<(Option<usize>, usize)> {
        let label = bare(label);
        let mut own = self.labels.iter().filter(|(known, ..)| *known == label);
        own.next().map(|(_, cell, line)| (*cell, *line))
    }
}

/// A label without its brackets.
fn bare(label: &str) -> String {
    label
        .trim_matches(|c: char| c == '(' || c == ')' || c.is_whitespace())
        .to_owned()
}

/// Whether a heading is a title, or begins with it as with a number: "Problem 2. The rolling cone".
fn begins(heading: &str, title: &str) -> bool {
    let (heading, title) = (heading.to_lowercase(), title.trim().to_lowercase());
    let numbered = title.ends_with(|c: char| c.is_ascii_digit()) || title.contains(' ');
    let rest = heading.strip_prefix(&title);
    rest.is_some_and(|rest| {
        rest.is_empty() || numbered && !rest.starts_with(|c: char| c.is_alphanumeric())
    })
}
