//! Lines that a student writes and does not claim: they are struck out, denied in words, or only asked.
//!
//! Such a line earns nothing and costs nothing. Where it can't be told whether a line is meant, it stays open.

use crate::grade::paper::denied::{self, Heard};
use crate::notation::document::{Document, Formula, Item, Row};
use crate::notation::{Struck, struck};
use crate::source::{Source, Span};

/// What stands for a formula among words.
pub(super) const FORMULA: char = '\u{fffc}';

/// Signs that ask whether two sides are equal.
const ASKING: [&str; 3] = ["?", "\u{225f}", "\\questeq"];

pub(super) const ASKED: &str = "it is only asked";
pub(super) const ANSWERED: &str = "it is asked, and something is answered";

/// Marks that strike out the letter before them.
const OVERLAID: [char; 2] = ['\u{335}', '\u{336}'];

/// What becomes of a line before it is looked at.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Claim {
    Made,
    /// With why it is not claimed.
    Withdrawn(&'static str),
    /// With why it can't be told.
    Unclear(&'static str),
}

impl Claim {
    /// What makes less of a line.
    fn or(self, other: Self) -> Self {
        match (self, other) {
            (Self::Withdrawn(why), _) | (_, Self::Withdrawn(why)) => Self::Withdrawn(why),
            (Self::Unclear(why), _) | (_, Self::Unclear(why)) => Self::Unclear(why),
            (Self::Made, Self::Made) => Self::Made,
        }
    }
}

/// The lines of a document that are not claimed, and those of which it can't be told, each with why.
#[derive(Clone, Debug, Default)]
pub(in crate::grade) struct Withdrawn {
    pub(in crate::grade) lines: Vec<(Span, &'static str)>,
    pub(in crate::grade) unclear: Vec<(Span, &'static str)>,
}

/// Takes the lines out of a document that are not claimed.
pub(super) fn take_out(document: &mut Document) -> Withdrawn {
    let struck = struck(document);
    let said = claims_by_words(document);
    let mut found = Withdrawn::default();
    let (source, items) = (&document.source, &mut document.items);
    for (at, item) in items.iter_mut().enumerate() {
        let Item::Formula(formula) = item else {
            continue;
        };
        let words = said.iter().find(|(place, _)| *place == at);
        let words = words.map_or(Claim::Made, |(_, claim)| claim.clone());
        let mut before = Claim::Made;
        formula.rows.retain(|row| {
            let Some((span, goes_on)) = line(row) else {
                return true;
            };
            let own = by_marks(source, span, &struck)
                .or(by_signs(source, row, span))
                .or(words.clone());
            let claim = match (&before, own) {
                (Claim::Withdrawn(_) | Claim::Unclear(_), Claim::Made) if goes_on => {
                    Claim::Unclear("it goes on from a line that is not claimed")
                }
                (_, Claim::Withdrawn(ASKED)) if words == Claim::Unclear(ANSWERED) => words.clone(),
                (_, own) => own,
            };
            before = claim.clone();
            match claim {
                Claim::Made => {}
                Claim::Withdrawn(why) => found.lines.push((span, why)),
                Claim::Unclear(why) => found.unclear.push((span, why)),
            }
            !matches!(before, Claim::Withdrawn(_))
        });
    }
    items.retain(|item| !matches!(item, Item::Formula(formula) if formula.rows.is_empty()));
    found
}

/// The bytes of a row that states something, or that may, and whether it goes on from the row before it.
fn line(row: &Row) -> Option<(Span, bool)> {
    match row {
        Row::Line(line) => Some((line.span, line.continues)),
        Row::Unreadable { span, .. } => Some((*span, false)),
        Row::Expression(_) => None,
    }
}

/// Whether marks strike out a line, or a part of it that does not cancel with another part.
fn by_marks(source: &Source, span: Span, struck: &Struck) -> Claim {
    let text = source.slice(span);
    if text.contains(OVERLAID) {
        return Claim::Unclear("a part of it is struck out");
    }
    let touches = |other: &&Span| other.start < span.end && span.start < other.end;
    let own: Vec<Span> = struck.sure.iter().filter(touches).copied().collect();
    if !own.is_empty() {
        let left = span.range().filter(|&at| {
            let mut inside = own.iter().map(|struck| struck.range());
            !inside.any(|struck| struck.contains(&at))
        });
        let bytes = source.text.as_bytes();
        let says = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_alphanumeric);
        if !left.into_iter().any(says) {
            return Claim::Withdrawn("it is struck out");
        }
        let parts: Vec<&str> = own.iter().map(|struck| source.slice(*struck)).collect();
        let alone = |part: &str| parts.iter().filter(|other| **other == part).count() == 1;
        if parts.iter().any(|part| alone(part)) {
            return Claim::Unclear("a part of it is struck out");
        }
    }
    match struck.unsure.iter().any(|other| touches(&other)) {
        true => Claim::Unclear("it may be struck out"),
        false => Claim::Made,
    }
}

/// Whether a line has a sign that asks, or a remark beside it takes it back.
fn by_signs(source: &Source, row: &Row, span: Span) -> Claim {
    let (plain, texts) = parted(source.slice(span));
    let asks = |text: &str| ASKING.iter().any(|sign| text.contains(sign));
    let alone = |text: &str| matches!(text.trim_matches([' ', '(', ')']), "?" | "??");
    if asks(&plain) || texts.iter().any(|text| alone(text)) {
        return Claim::Withdrawn(ASKED);
    }
    let remarks: &[String] = match row {
        Row::Line(line) => &line.remarks,
        _ => &[],
    };
    let mut claim = Claim::Made;
    for text in texts.into_iter().chain(remarks.iter().map(String::as_str)) {
        claim = claim.or(match denied::behind(text) {
            Heard::Nothing if alone(text) => Claim::Withdrawn(ASKED),
            Heard::Nothing if asks(text) => Claim::Unclear("a remark beside it asks something"),
            heard => heard.into_claim(),
        });
    }
    claim
}

/// A formula without the words in it, and these words.
fn parted(formula: &str) -> (String, Vec<&str>) {
    let (mut plain, mut texts, mut rest) = (String::new(), vec![], formula);
    while let Some(at) = rest.find("\\text").or_else(|| rest.find("\\mbox")) {
        plain.push_str(&rest[..at]);
        let Some((_, inside)) = rest[at..].split_once('{') else {
            break;
        };
        let end = inside.find('}').unwrap_or(inside.len());
        texts.push(&inside[..end]);
        rest = inside.get(end + 1..).unwrap_or("");
    }
    plain.push_str(rest);
    (plain, texts)
}

/// The formulas of a document that words deny or ask, by their places among the items.
fn claims_by_words(document: &Document) -> Vec<(usize, Claim)> {
    let mut found = vec![];
    let (mut text, mut places) = (String::new(), vec![]);
    for (at, item) in document.items.iter().enumerate() {
        match item {
            Item::Heading { .. } => {
                claims_in(&document.source, &text, &places, &mut found);
                text.clear();
                places.clear();
            }
            Item::Prose { text: words, .. } => text.push_str(words),
            Item::Break => text.push('\n'),
            Item::Comment { .. } => {}
            Item::Formula(formula) => {
                places.push((at, text.len(), formula));
                text.push(FORMULA);
                if let Some(end) = end_of_sentence(&document.source, formula) {
                    text.extend([end, ' ']);
                }
            }
        }
    }
    claims_in(&document.source, &text, &places, &mut found);
    found
}

/// The sign in a display that ends the sentence.
fn end_of_sentence(source: &Source, formula: &Formula) -> Option<char> {
    let inside = source.slice(formula.span).trim_end_matches(['$', ']', ')']);
    let last = inside.trim_end().trim_end_matches('\\').trim_end();
    let last = last.chars().next_back();
    last.filter(|end| formula.display && matches!(end, '.' | '!' | '?'))
}

fn claims_in(
    source: &Source,
    text: &str,
    places: &[(usize, usize, &Formula)],
    found: &mut Vec<(usize, Claim)>,
) {
    for (at, place, formula) in places {
        let states = formula.rows.iter().filter(|row| line(row).is_some());
        let before = &text[..*place];
        let behind = &text[place + FORMULA.len_utf8()..];
        let claim = denied::around(before, behind, formula.display).into_claim();
        let asks = ASKING
            .iter()
            .any(|sign| source.slice(formula.span).contains(sign));
        let claim = match asks && denied::is_yes(behind.trim_start_matches(['?', ' '])) {
            true => Claim::Unclear(ANSWERED),
            false => claim,
        };
        let claim = match (claim, states.count()) {
            (Claim::Made, _) | (_, 0) => continue,
            (Claim::Withdrawn(_), 2..) => {
                Claim::Unclear("words take back something beside it, and it has several lines")
            }
            (claim, _) => claim,
        };
        found.push((*at, claim));
    }
}
