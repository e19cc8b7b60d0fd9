//! The part of the document that a sentence speaks of.

use super::headings::PARTS;
use super::phrase::ORDINALS;
use super::reader::{Read, Reader};
use super::statement::{Extent, Formula};
use super::words::Kind;

/// A sentence may speak of so many parts of a document.
const MOST_EXTENTS: usize = 200;

/// How a line is called.
pub(super) const LINES: [&str; 4] = ["line", "lines", "row", "rows"];

/// How parts of a document with a number are called: their heading begins so.
const UNITS: [&str; 9] = [
    "problem", "part", "exercise", "question", "example", "chapter", "step", "case", "task",
];

/// How lines with a label are called.
const EQUATIONS: [&str; 4] = ["equation", "equations", "eq", "eqs"];

impl Reader<'_> {
    /// The extents with which a sentence begins. Several parts of a document beside one another ("on lines 4 and 41")
    /// are several extents.
    pub(crate) fn extents(&mut self) -> Read<Vec<Extent>> {
        let mut extents = vec![Extent::Document];
        if self.take("elsewhere") {
            self.take_sign(Kind::Comma);
            return Ok(extents);
        }
        loop {
            let start = self.at;
            let lines = LINES.contains(&self.word()) || self.at_label();
            let found = self.extent(extents == [Extent::Document])?;
            let verbs = [
                "is", "are", "hold", "holds", "defines", "define", "starts", "start",
            ];
            let verb = verbs.contains(&self.word()) || self.word().starts_with("continue");
            let subject = lines && verb;
            if found.is_empty() || subject {
                self.at = start;
                return Ok(extents);
            }
            extents = self.together(&extents, &found)?;
            self.take_sign(Kind::Comma);
        }
    }

    /// Whether a part of the document is named here: "on line 3", "in the section …".
    pub(crate) fn at_extent(&self) -> bool {
        let next = self.word_at(1);
        let number = |ahead: usize| {
            let token = self.tokens.get(self.at + ahead);
            token.is_some_and(|token| token.kind == Kind::Number)
        };
        match self.word() {
            "on" | "in" if LINES.contains(&next) => number(2),
            "in" if matches!(next, "cell" | "cells") => number(2),
            "in" | "on" if EQUATIONS.contains(&next) => true,
            "between" => LINES.contains(&next),
            "in" if UNITS.contains(&next) => self.numbered(2),
            "in" => PARTS.contains(&next) || next == "the" && PARTS.contains(&self.word_at(2)),
            "from" | "until" => next == "line" && number(2),
            "up" => next == "to" && self.word_at(2) == "line" && number(3),
            _ => false,
        }
    }

    /// Whether a number or a letter stands some words further on.
    fn numbered(&self, ahead: usize) -> bool {
        let token = self.tokens.get(self.at + ahead);
        token.is_some_and(|t| t.kind == Kind::Number || t.text.chars().count() == 1)
    }

    /// The extents of one clause of several, or those that stand behind what it says.
    pub(crate) fn extents_of_clause(&mut self, whole: &[Extent]) -> Read<Option<Vec<Extent>>> {
        let start = self.at;
        self.take_sign(Kind::Comma);
        if self.take("elsewhere") {
            return Ok(Some(vec![Extent::Document]));
        }
        if !self.at_extent() {
            self.at = start;
            return Ok(None);
        }
        let own = self.extents()?;
        self.together(whole, &own).map(Some)
    }

    /// Each of some extents with each of others.
    fn together(&self, some: &[Extent], others: &[Extent]) -> Read<Vec<Extent>> {
        if some.len() * others.len() > MOST_EXTENTS {
            return Err(self.error(
                "too many parts of the document",
                "say it in several sentences",
            ));
        }
        let pairs = some.iter().flat_map(|a| others.iter().map(|b| both(a, b)));
        Ok(pairs.collect())
    }

    /// One extent; none if something else begins here. The first one has a preposition.
    fn extent(&mut self, first: bool) -> Read<Vec<Extent>> {
        let start = self.at;
        if self.take_any(&["on", "in"]) || !first {
            if LINES.contains(&self.word()) {
                return self.lines();
            }
            if self.take_any(&["cell", "cells"]) {
                return Ok(vec![Extent::Cells(self.cells()?)]);
            }
            if EQUATIONS.contains(&self.word()) && self.opens(1) {
                self.at += 1;
                return self.labels_from_to();
            }
            if self.at != start && self.at_label() {
                return self.labels_from_to();
            }
            if UNITS.contains(&self.word()) && self.numbered(1) {
                let title = format!("{} {}", self.word(), self.word_or_number(1));
                self.at += 2;
                return Ok(vec![Extent::Section(title)]);
            }
            if self.take_heads_of_parts() {
                return self.headings();
            }
        }
        self.at = start;
        if self.take("under the heading") || self.take("under the headings") {
            return self.headings();
        }
        if self.word() == "from" && self.opens(1) {
            return self.behind_label();
        }
        if self.take("from line") {
            let first = self.number()?;
            if self.take("to") {
                self.take_any(&LINES);
                return Ok(vec![lines(first, Some(self.number()?))]);
            }
            return match self.take("on") {
                true => Ok(vec![lines(first, None)]),
                false => Err(self.unexpected("end of an extent", "say `from line 38 on`", &[])),
            };
        }
        if self.take("up to line") || self.take("until line") {
            return Ok(vec![lines(1, Some(self.number()?))]);
        }
        if self.word() == "between" {
            return self.between();
        }
        Ok(vec![])
    }

    /// Whether a bracket opens some words further on.
    fn opens(&self, ahead: usize) -> bool {
        let token = self.tokens.get(self.at + ahead);
        token.is_some_and(|token| token.kind == Kind::Open)
    }

    /// "between lines 27 and 48", "between (4) and (9)".
    fn between(&mut self) -> Read<Vec<Extent>> {
        let start = self.at;
        self.at += 1;
        let parted = "say `between lines 4 and 9` or `between (4) and (9)`";
        if self.take_any(&LINES) {
            let first = self.number()?;
            if !self.take("and") {
                return Err(self.unexpected("second line", parted, &[]));
            }
            self.take_any(&LINES);
            return Ok(vec![lines(first, Some(self.number()?))]);
        }
        if !self.opens(0) {
            self.at = start;
            return Ok(vec![]);
        }
        let from = self.label()?;
        if !self.take("and") {
            return Err(self.unexpected("second label", parted, &[]));
        }
        Ok(vec![Extent::Between(from, self.label()?)])
    }

    /// "from (4) on".
    fn behind_label(&mut self) -> Read<Vec<Extent>> {
        self.at += 1;
        let from = self.label()?;
        match self.take("on") {
            true => Ok(vec![Extent::Between(from, String::new())]),
            false => Err(self.unexpected("end of an extent", "say `from (4) on`", &[])),
        }
    }

    /// "line 5", "lines 3 to 17", "lines 4, 8 and 41", with "of cell 2".
    pub(crate) fn lines(&mut self) -> Read<Vec<Extent>> {
        self.take_any(&LINES);
        let mut ranges = vec![];
        loop {
            ranges.push(self.range()?);
            let start = self.at;
            let goes_on = self.take_separator() && {
                self.take_any(&LINES);
                self.kind() == Some(Kind::Number)
            };
            if !goes_on {
                self.at = start;
                break;
            }
        }
        let start = self.at;
        let cell = match self.take_any(&["of", "in"]) && self.take("cell") {
            true => Some(self.number()?),
            false => {
                self.at = start;
                None
            }
        };
        let one = |(first, last)| Extent::Lines {
            cell,
            first,
            last: Some(last),
        };
        Ok(ranges.into_iter().map(one).collect())
    }

    /// "the second `$V$` of line 10"; the line may have been said before. The formula is what the sentence is about.
    pub(crate) fn occurrence(&mut self, extents: &mut Vec<Extent>) -> Read<Option<Formula>> {
        let start = self.at;
        self.take("the");
        let number = ORDINALS.iter().position(|o| *o == self.word());
        self.at += usize::from(number.is_some());
        let place = self.at;
        let (Some(number), Some(formula)) = (number, self.formulas().into_iter().next()) else {
            self.at = start;
            return Ok(None);
        };
        if matches!(self.word(), "of" | "on" | "in") && LINES.contains(&self.word_at(1)) {
            self.at += 1;
            let said = self.lines()?;
            *extents = self.together(extents, &said)?;
        }
        for extent in extents {
            match once(extent, number + 1, &formula.source) {
                Some(narrower) => *extent = narrower,
                None => {
                    self.at = place;
                    return Err(self.error(
                        "it is not said on which line",
                        "say `the second … of line 10`",
                    ));
                }
            }
        }
        Ok(Some(formula))
    }

    /// A word or a number further on, as written.
    fn word_or_number(&self, ahead: usize) -> &str {
        let token = self.tokens.get(self.at + ahead);
        token.map_or("", |token| token.text.as_str())
    }

    fn number(&mut self) -> Read<usize> {
        match self.take_number() {
            Some(number) => Ok(number),
            None => Err(self.unexpected(
                "number",
                "the number of a line or a cell could stand here",
                &[],
            )),
        }
    }

    /// "5", "3 to 17"
    fn range(&mut self) -> Read<(usize, usize)> {
        let first = self.number()?;
        let last = match self.take("to") {
            true => self.number()?,
            false => first,
        };
        if last < first {
            self.at -= 1;
            return Err(self.error("the last line stands before the first", ""));
        }
        Ok((first, last))
    }

    /// The numbers of cells: "2 and 3", "0 to 7 and 9".
    pub(crate) fn cells(&mut self) -> Read<Vec<usize>> {
        let mut cells = vec![];
        loop {
            let (first, last) = self.range()?;
            if last - first >= MOST_EXTENTS {
                return Err(self.error("these are too many cells", ""));
            }
            cells.extend(first..=last);
            let start = self.at;
            if !self.take_separator() || self.kind() != Some(Kind::Number) {
                self.at = start;
                return Ok(cells);
            }
        }
    }

    /// "(4)", "(4) and (7)", "(4) to (7)": the lines with these labels.
    pub(crate) fn labels_from_to(&mut self) -> Read<Vec<Extent>> {
        let mut extents = vec![];
        loop {
            let from = self.label()?;
            let to = match self.take("to") {
                true => self.label()?,
                false => from.clone(),
            };
            extents.push(Extent::Between(from, to));
            let start = self.at;
            if !self.take_separator() || self.kind() != Some(Kind::Open) {
                self.at = start;
                return Ok(extents);
            }
        }
    }

    /// Whether a label in brackets comes next.
    pub(crate) fn at_label(&self) -> bool {
        let closes = self.tokens.get(self.at + 2);
        self.opens(0) && closes.is_some_and(|token| token.kind == Kind::Close)
    }

    /// A label in brackets: "(4)", "(eq:spin)".
    fn label(&mut self) -> Read<String> {
        let found = match self.tokens.get(self.at..self.at + 3) {
            Some([open, label, close]) if open.kind == Kind::Open && close.kind == Kind::Close => {
                Some(label.text.clone())
            }
            _ => None,
        };
        match found {
            Some(label) => {
                self.at += 3;
                Ok(label)
            }
            None => Err(self.unexpected("label", "put the label between brackets", &[])),
        }
    }
}

fn lines(first: usize, last: Option<usize>) -> Extent {
    Extent::Lines {
        cell: None,
        first,
        last,
    }
}

/// One occurrence of a formula on a line.
fn once(extent: &Extent, number: usize, formula: &str) -> Option<Extent> {
    match extent {
        Extent::Lines { cell, first, last } if *last == Some(*first) => Some(Extent::Occurrence {
            number,
            formula: formula.to_owned(),
            cell: *cell,
            line: *first,
        }),
        Extent::Both(a, b) => {
            let narrower = once(b, number, formula)?;
            Some(Extent::Both(a.clone(), Box::new(narrower)))
        }
        _ => None,
    }
}

/// Two extents at once. "Up to line 30 … , on lines 44 to 48 …": where no line is in both, it is the second.
pub(crate) fn both(a: &Extent, b: &Extent) -> Extent {
    common(a, b).unwrap_or_else(|| b.clone())
}

/// What two extents have in common; `None` where no line is in both. Lines of one cell are lines of that cell.
pub(super) fn common(a: &Extent, b: &Extent) -> Option<Extent> {
    use Extent::{Both, Cells, Document, Lines};
    match (a, b) {
        (Document, other) | (other, Document) => Some(other.clone()),
        (Cells(cells), Lines { cell, first, last }) if cell.is_none() && cells.len() == 1 => {
            let (cell, first, last) = (cells.first().copied(), *first, *last);
            Some(Lines { cell, first, last })
        }
        (
            Lines { cell, first, last },
            Lines {
                cell: other,
                first: from,
                last: to,
            },
        ) if cell == other => {
            let first = *first.max(from);
            let last = [*last, *to].into_iter().flatten().min();
            let some = last.is_none_or(|last| first <= last);
            let cell = *cell;
            some.then_some(Lines { cell, first, last })
        }
        _ => Some(Both(Box::new(a.clone()), Box::new(b.clone()))),
    }
}
