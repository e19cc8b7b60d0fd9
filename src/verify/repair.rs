//! The cheapest change that makes a false line provable: where it stands, what it is, and the line as it should be.

pub(super) mod carried;
pub(super) mod convention_slips;
pub(super) mod edit;
pub(super) mod hollow;
pub(super) mod lost_factors;
pub(super) mod lost_terms;
pub(super) mod lost_vectors;
pub(super) mod order;
pub(super) mod other_letters;
pub(super) mod places;
pub(super) mod shown;
pub(super) mod slips;
pub(super) mod terms;
pub(super) mod vocabulary;
pub(super) mod wanted;

use crate::notation::ast::{FrameLabel, Kind, Line, Node, Symbol};
use crate::notation::document::{Document, Item, Row};
use crate::notation::reread;
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::frame::{Frame, labels};
use crate::verify::lines::line::Read;
use crate::verify::repair::convention_slips::sign_flips;
use crate::verify::repair::edit::{Edit, edited};
use crate::verify::repair::slips::Slips;
use crate::verify::theory::decide::{passes_filter, vanishes};
use crate::verify::values::value::Value;
use crate::verify::verdict::{Diagnosis, Finding};

/// Texts that are tried for one line at most.
const CANDIDATES: usize = 3000;
/// Slips that put one symbol in the place of another.
const SYMBOLS: &[&str] = &["index", "symbol"];
/// Edits that are tried two at a time.
const PAIRED: usize = 40;

impl Checker<'_> {
    /// Says what is wrong with a refuted line, if a change of one or two places, or a lost term, makes it true.
    pub(super) fn diagnose(&mut self, line: &Line, finding: &mut Finding) {
        if line.span.end - line.span.start > 2000 {
            return;
        }
        // Indices that are summed over are put right where they are written.
        let summed = self.reading.summed.as_ref();
        let written = summed.and_then(|summed| summed.as_written(line)).cloned();
        let line = written.as_ref().unwrap_or(line);
        let slips = Slips::new(&self.document.source, &self.reading, self.frame_labels());
        let inside =
            |edit: &Edit| line.span.start <= edit.span.start && edit.span.end <= line.span.end;
        let mut edits: Vec<Edit> = slips.of(&line.sides).into_iter().filter(inside).collect();
        edits.extend(self.lost_transport(line));
        edits.sort_by_key(|edit| (edit.cost, edit.span));
        let mut search = Search {
            line,
            left: CANDIDATES,
        };
        finding.diagnosis = self.convention_slip(line, &mut search);
        if finding.diagnosis.is_some() {
            return;
        }
        let wanted = self.wanted(line, &mut search);
        let mut all = edits.clone();
        if let Some(wanted) = &wanted {
            // A symbol's place in which the line is linear has been solved for; nothing else fits there.
            all.retain(|edit| !SYMBOLS.contains(&edit.kind) || !wanted.covers(edit.span));
            all.extend(wanted.symbols());
        }
        all.extend(self.lost_vectors(line, &mut search));
        all.extend(self.lost_masses(line));
        all.extend(self.other_letters(line, wanted.as_ref()));
        // The sign of a resultant belongs to its letter alone: no other stands behind it.
        let text = &self.document.source.text;
        let summed = |edit: &Edit| {
            let before = text.get(..edit.span.start as usize).unwrap_or_default();
            ["\\Sigma", "\\sum", "Σ"]
                .iter()
                .any(|sign| before.trim_end().ends_with(sign))
        };
        all.retain(|edit| edit.kind != "symbol" || !summed(edit));
        all.sort_by_key(|edit| (edit.cost, edit.span));
        finding.diagnosis = self
            .single(&all, &mut search)
            .or_else(|| self.alike(&edits, &mut search))
            .or_else(|| self.by_component(&edits, &mut search))
            .or_else(|| self.inertia_held(line, &mut search))
            .or_else(|| self.single(&wanted.as_ref()?.terms(), &mut search))
            .or_else(|| self.lost_term(line, &mut search))
            .or_else(|| self.pairs(&edits, &mut search));
    }

    fn single(&mut self, edits: &[Edit], search: &mut Search<'_>) -> Option<Diagnosis> {
        edits.iter().find_map(|edit| self.tried(&[edit], search))
    }

    /// One slip made throughout the line: every square lost, every sign.
    fn alike(&mut self, edits: &[Edit], search: &mut Search<'_>) -> Option<Diagnosis> {
        let mut classes: Vec<(&'static str, &str)> = vec![];
        let once = |edit: &&Edit| {
            !matches!(
                edit.kind,
                "missing-dot" | "extra-dot" | "frame" | "extra-term"
            )
        };
        for edit in edits.iter().filter(once) {
            let class = (edit.kind, edit.message.as_str());
            if !classes.contains(&class) {
                classes.push(class);
            }
        }
        classes.into_iter().find_map(|(kind, message)| {
            let mut all: Vec<&Edit> = vec![];
            for edit in edits
                .iter()
                .filter(|e| e.kind == kind && e.message == message)
            {
                if all.iter().all(|other| apart(other.span, edit.span)) {
                    all.push(edit);
                }
            }
            (all.len() > 1).then(|| self.tried(&all, search)).flatten()
        })
    }

    /// The same slip in each component of a vector equation, found one component at a time.
    fn by_component(&mut self, edits: &[Edit], search: &mut Search<'_>) -> Option<Diagnosis> {
        let wrong = self.mask(&[], search)?;
        if wrong.len() < 2 || wrong.iter().filter(|w| **w).count() < 2 {
            return None;
        }
        let mut chosen: Vec<Option<&Edit>> = vec![None; wrong.len()];
        for edit in edits {
            let Some(mask) = self.mask(&[edit], search) else {
                continue;
            };
            if mask.len() != wrong.len()
                || mask.iter().zip(&wrong).any(|(now, before)| *now && !before)
            {
                continue;
            }
            for (slot, (now, before)) in chosen.iter_mut().zip(mask.iter().zip(&wrong)) {
                if *before && !now && slot.is_none() {
                    *slot = Some(edit);
                }
            }
        }
        let mut all: Vec<&Edit> = vec![];
        for (slot, before) in chosen.iter().zip(&wrong) {
            let edit = match (slot, before) {
                (Some(edit), true) => *edit,
                (None, true) => return None,
                _ => continue,
            };
            if !all.contains(&edit) {
                all.push(edit);
            }
        }
        self.tried(&all, search)
    }

    fn pairs(&mut self, edits: &[Edit], search: &mut Search<'_>) -> Option<Diagnosis> {
        let few = &edits[..edits.len().min(PAIRED)];
        for (i, first) in few.iter().enumerate() {
            for second in few[i + 1..]
                .iter()
                .filter(|second| apart(first.span, second.span))
            {
                if let Some(found) = self.tried(&[first, second], search) {
                    return Some(found);
                }
            }
        }
        None
    }

    /// The line with some edits, if that is true.
    pub(super) fn tried(&mut self, edits: &[&Edit], search: &mut Search<'_>) -> Option<Diagnosis> {
        let text = self.proved_with(edits, search)?;
        let first = edits.iter().min_by_key(|edit| edit.span)?;
        let mut kinds: Vec<&'static str> = edits.iter().map(|edit| edit.kind).collect();
        kinds.dedup();
        let message = match (edits.len(), kinds.as_slice()) {
            (1, _) => first.message.clone(),
            (n, [_]) => format!("{}, in {n} places", first.message),
            _ => edits
                .iter()
                .map(|e| e.message.clone())
                .collect::<Vec<_>>()
                .join("; and "),
        };
        Some(Diagnosis {
            kind: first.kind,
            message,
            suggestion: Some(text),
            place: Some(first.span),
        })
    }

    /// The text with the edits, if it is read as one line, says something, and is proved.
    fn proved_with(&mut self, edits: &[&Edit], search: &mut Search<'_>) -> Option<String> {
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
                && vanishes(&mut self.theory, &read.equations)
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

    fn edited_text(&self, edits: &[&Edit], search: &mut Search<'_>) -> Option<String> {
        search.left = search.left.checked_sub(1)?;
        let text = self.document.source.slice(search.line.span);
        edited(text, search.line.span.start, edits)
    }

    /// The equations of a text that stands in the place of the line.
    pub(super) fn reads(&mut self, text: &str, search: &Search<'_>) -> Option<Vec<Read>> {
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
    fn mask(&mut self, edits: &[&Edit], search: &mut Search<'_>) -> Option<Vec<bool>> {
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

    /// Every product of inertia with the other sign, if that makes the line true.
    fn convention_slip(&mut self, line: &Line, search: &mut Search<'_>) -> Option<Diagnosis> {
        let edits = sign_flips(&line.sides, &self.reading);
        let all: Vec<&Edit> = edits.iter().collect();
        let before = |f: &Finding| f.diagnosis.as_ref().is_some_and(|d| d.kind == "convention");
        // One flipped sign alone is a slip of sign, unless the document has shown the other convention before.
        if all.is_empty() || (all.len() == 1 && !self.findings.iter().any(before)) {
            return None;
        }
        let text = self.proved_with(&all, search)?;
        Some(Diagnosis {
            kind: "convention",
            message: format!(
                "the products of inertia have the sign of the other convention; this document uses {}",
                self.convention.name
            ),
            suggestion: Some(text),
            place: edits.first().map(|edit| edit.span),
        })
    }

    /// The labels that the document writes for the space frame and for the moving one.
    pub(super) fn frame_labels(&self) -> [String; 2] {
        let mut found: [Option<String>; 2] = [None, None];
        let mut look = |label: &FrameLabel| {
            let slot = match self.reading.frames.of_label(label) {
                Some(Frame::Space) => &mut found[0],
                Some(Frame::Moving) => &mut found[1],
                None => return,
            };
            slot.get_or_insert_with(|| {
                self.document
                    .source
                    .slice(label.span)
                    .trim_matches(['{', '}'])
                    .to_owned()
            });
        };
        lines(self.document)
            .flat_map(|l| &l.sides)
            .for_each(|side| labels(side, &mut look));
        let [space, moving] = found;
        [
            space.unwrap_or_else(|| "XYZ".into()),
            moving.unwrap_or_else(|| "xyz".into()),
        ]
    }
}

/// The line that is repaired, and how many texts may still be tried.
pub(super) struct Search<'a> {
    line: &'a Line,
    left: usize,
}

/// Marks of alignment mean nothing outside the environment that the line stands in.
fn without_alignment(text: &str) -> String {
    match text.contains("\\begin") {
        true => text.to_owned(),
        false => text.replace('&', ""),
    }
}

fn apart(a: Span, b: Span) -> bool {
    a.end <= b.start || b.end <= a.start
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

pub(super) fn lines(document: &Document) -> impl Iterator<Item = &Line> {
    let formulas = document.items.iter().filter_map(|item| match item {
        Item::Formula(formula) => Some(formula),
        _ => None,
    });
    formulas.flat_map(|f| &f.rows).filter_map(|row| match row {
        Row::Line(line) => Some(line),
        _ => None,
    })
}

pub(super) fn first_symbol(document: &Document, wanted: &impl Fn(&Symbol) -> bool) -> Option<Span> {
    fn find(node: &Node, wanted: &impl Fn(&Symbol) -> bool) -> Option<Span> {
        match &node.kind {
            Kind::Symbol(symbol) if wanted(symbol) => Some(node.span),
            _ => node
                .children()
                .into_iter()
                .find_map(|child| find(child, wanted)),
        }
    }
    lines(document)
        .flat_map(|l| &l.sides)
        .find_map(|side| find(side, wanted))
}
