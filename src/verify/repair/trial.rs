//! An edited line on trial: whether it is read, says something and is true.

use crate::notation::ast::{Line, Node};
use crate::notation::document::Row;
use crate::notation::reread;
use crate::verify::check::Checker;
use crate::verify::correction::edit::{Edit, edited};
use crate::verify::lines::constancy::keep_their_value;
use crate::verify::lines::line::Read;
use crate::verify::theory::decide::{passes_filter, vanishes};
use crate::verify::values::value::Value;
use std::collections::HashMap;

/// Texts that are tried for one line at most.
const CANDIDATES: usize = 3000;

/// The line that is repaired, and how many texts may still be tried.
pub(crate) struct Search<'a> {
    line: &'a Line,
    left: usize,
    /// Texts that were read before: most are looked at whole, and then by component.
    read: HashMap<String, Option<Vec<Read>>>,
}

impl<'a> Search<'a> {
    /// The search for what puts a line right.
    pub(crate) fn of(line: &'a Line) -> Self {
        Self {
            line,
            left: CANDIDATES,
            read: HashMap::new(),
        }
    }
}

impl Checker<'_> {
    /// The text with the edits, if it is read as one line, says something, and is proved.
    pub(crate) fn proved_with(
        &mut self,
        edits: &[&Edit],
        search: &mut Search<'_>,
    ) -> Option<String> {
        let text = self.edited_text(edits, search)?;
        let reads = self.reads(&text, search)?;
        for read in reads {
            let holds = read
                .equations
                .iter()
                .all(|e| passes_filter(&mut self.theory, &e.residual) == Some(true));
            if holds
                && !self.says_nothing(&read)
                && !self.empties(&text, search.line)
                && (vanishes(&mut self.theory, &read.equations) || self.squares_hold(&read))
            {
                return Some(without_alignment(text.trim()));
            }
        }
        None
    }

    /// Both sides vanish, and neither is written as zero.
    fn says_nothing(&mut self, read: &Read) -> bool {
        read.equations.iter().any(|e| {
            let written = e.left.is_zero() || e.right.is_zero();
            !written && passes_filter(&mut self.theory, &e.left) == Some(true)
        })
    }

    /// Whether a part of the text vanishes that does not in the line as it stands.
    fn empties(&mut self, text: &str, line: &Line) -> bool {
        let rows = reread(self.document, text);
        match rows.as_slice() {
            [Row::Line(new)] => self.hollow(&new.sides) > self.hollow(&line.sides),
            _ => true,
        }
    }

    pub(crate) fn edited_text(&self, edits: &[&Edit], search: &mut Search<'_>) -> Option<String> {
        search.left = search.left.checked_sub(1)?;
        let text = self.document.source.slice(search.line.span);
        edited(text, search.line.span.start, edits)
    }

    /// The equations of a text that stands in the place of the line.
    pub(crate) fn reads(&mut self, text: &str, search: &mut Search<'_>) -> Option<Vec<Read>> {
        if let Some(known) = search.read.get(text) {
            return known.clone();
        }
        let found = self.read_anew(text, search);
        search.read.insert(text.to_owned(), found.clone());
        found
    }

    fn read_anew(&mut self, text: &str, search: &Search<'_>) -> Option<Vec<Read>> {
        let rows = reread(self.document, text);
        let [Row::Line(line)] = rows.as_slice() else {
            return None;
        };
        let mut sides: Vec<Node> = line.sides.clone();
        if line.continues {
            sides.insert(0, self.last_side.clone()?);
        }
        let relations = search.line.relations.len();
        if line.relations.len() != relations || tautology(&sides, text) {
            return None;
        }
        keep_their_value(&mut sides);
        let summed = self.reading.summed.as_ref();
        match summed.and_then(|summed| {
            summed.lines(&Line {
                sides: sides.clone(),
                ..line.clone()
            })
        }) {
            Some(lines) => self.together(&lines),
            None => self.readings(&sides).ok(),
        }
    }

    /// The equations of lines that are one with its indices written out.
    fn together(&mut self, lines: &[Line]) -> Option<Vec<Read>> {
        let mut all: Option<Read> = None;
        for line in lines {
            let read = self.readings(&line.sides).ok()?.into_iter().next()?;
            match &mut all {
                Some(all) => all.equations.extend(read.equations),
                None => all = Some(read),
            }
        }
        Some(vec![all?])
    }

    /// Which components of the equation differ, with some edits.
    pub(crate) fn mask(&mut self, edits: &[&Edit], search: &mut Search<'_>) -> Option<Vec<bool>> {
        let text = self.edited_text(edits, search)?;
        let reads = self.reads(&text, search)?;
        let [equation] = reads.first()?.equations.as_slice() else {
            return None;
        };
        let entry = |i: usize| Value::scalar(equation.residual.entries[i].clone());
        let count = equation.residual.entries.len();
        (0..count)
            .map(|i| Some(!passes_filter(&mut self.theory, &entry(i))?))
            .collect()
    }
}

/// Marks of alignment mean nothing outside the environment that the line stands in.
fn without_alignment(text: &str) -> String {
    match text.contains("\\begin") {
        true => text.to_owned(),
        false => text.replace('&', ""),
    }
}

/// Two sides that are written alike say nothing.
fn tautology(sides: &[Node], text: &str) -> bool {
    let written = |node: &Node| -> String {
        text.get(node.span.range())
            .unwrap_or("")
            .chars()
            .filter(|c| !c.is_whitespace())
            .collect()
    };
    sides
        .windows(2)
        .any(|pair| pair[0].span != pair[1].span && written(&pair[0]) == written(&pair[1]))
}
