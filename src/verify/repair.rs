//! The cheapest change that makes a false line provable: where it stands, what it is, and the line as it should be.

pub(super) mod axis_slips;
pub(super) mod carried;
pub(super) mod convention_slips;
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
pub(super) mod trial;
pub(super) mod vocabulary;
pub(super) mod wanted;

use crate::notation::ast::{FrameLabel, Kind, Line, Node, Symbol};
use crate::notation::document::Document;
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::correction::edit::Edit;
use crate::verify::letters::frame::{Frame, labels};
use crate::verify::repair::slips::Slips;
use crate::verify::repair::trial::Search;
use crate::verify::verdict::{Diagnosis, Finding};

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
        let mut search = Search::of(line);
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

    /// The labels that the document writes for the space frame and for the moving one.
    pub(super) fn frame_labels(&self) -> [String; 2] {
        let labels = self.frame_labels.get_or_init(|| self.labels_of_frames());
        labels.clone()
    }

    fn labels_of_frames(&self) -> [String; 2] {
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
        self.document
            .lines()
            .flat_map(|l| &l.sides)
            .for_each(|side| labels(side, &mut look));
        let [space, moving] = found;
        [
            space.unwrap_or_else(|| "XYZ".into()),
            moving.unwrap_or_else(|| "xyz".into()),
        ]
    }
}

fn apart(a: Span, b: Span) -> bool {
    a.end <= b.start || b.end <= a.start
}

pub(super) fn first_symbol(document: &Document, wanted: &impl Fn(&Symbol) -> bool) -> Option<Span> {
    fn find(node: &Node, wanted: &impl Fn(&Symbol) -> bool) -> Option<Span> {
        match &node.kind {
            Kind::Symbol(symbol) if wanted(symbol) => Some(node.span),
            _ => node.children().find_map(|child| find(child, wanted)),
        }
    }
    document
        .lines()
        .flat_map(|l| &l.sides)
        .find_map(|side| find(side, wanted))
}
