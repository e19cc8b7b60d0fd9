//! Tries the changes of a false line by the facts in force where it stands, until one of them makes it provable.

use crate::notation::ast::{Kind, Line, Node, Symbol};
use crate::notation::document::{Document, Format};
use crate::source::Span;
use crate::verify::Diagnosis;
use crate::verify::correction::by_terms::{Letters, Terms};
use crate::verify::correction::edit::{Edit, edited};
use crate::verify::correction::slips::{Change, OTHER_LETTER, Slip, other_letters, slips};
use crate::verify::standing::judge::{Judge, Judged};
use crate::verify::standing::recalled::Correction;
use crate::verify::standing::verdicts::Answer;
use std::collections::{BTreeSet, HashMap};
use std::ops::Range;
use std::rc::Rc;

/// A line longer than this is not put right.
const LONGEST: u32 = 2_000;

/// No more texts are tried for one line.
const MOST_TRIED: usize = 600;

/// No more false lines of a document are put right.
const MOST_LINES: usize = 200;

/// What may be spent on a document: each text that is tried costs the number of terms of its line, and this besides.
const MOST_WORK: usize = 500_000;
const LEAST_COST: usize = 10;

/// Signs and dots are more likely than this.
const LIKELIEST: u32 = 12;

/// What would put the refuted lines of a document right, by the place of the line.
pub(crate) fn corrections(judge: &mut Judge<'_>) -> HashMap<Span, Diagnosis> {
    let document = judge.document;
    let refuted = judge.judged.iter().filter(|j| j.answer == Answer::Refuted);
    let refuted: HashMap<Span, Judged> = refuted.map(|j| (j.span, j.clone())).collect();
    let short = |line: &&Line| line.span.end - line.span.start <= LONGEST;
    let each = document
        .lines()
        .filter(|line| refuted.contains_key(&line.span));
    let each: Vec<&Line> = each.filter(short).take(MOST_LINES).collect();
    let (mut found, mut left) = (HashMap::new(), MOST_WORK);
    let mut letters = Rc::default();
    for line in each {
        if !judge.is_alike_everywhere() {
            letters = Rc::default();
        }
        let correction = recalled_or_found(judge, line, &refuted[&line.span], &letters, &mut left);
        found.extend(correction.map(|diagnosis| (line.span, diagnosis)));
    }
    found
}

/// What puts a line right, as it did in another document or found anew.
fn recalled_or_found(
    judge: &mut Judge<'_>,
    line: &Line,
    judged: &Judged,
    letters: &Rc<Letters>,
    left: &mut usize,
) -> Option<Diagnosis> {
    let start = line.span.start;
    let asked = judge.correction_of(line);
    let known = asked.as_ref().and_then(|of| judge.recall_correction(of));
    if let Some(known) = known.filter(|known| known.spent <= *left) {
        *left -= known.spent;
        let place = known.diagnosis.place;
        return Some(Diagnosis {
            place: place.map(|place| place.shifted(start as usize)),
            ..known.diagnosis.clone()
        });
    }
    let before = *left;
    let (diagnosis, cost) = correction(judge, line, judged, letters, left)?;
    // Which other letters are tried hangs on the document.
    if let Some(of) = asked.filter(|_| cost < OTHER_LETTER) {
        let own = |at: u32| (at - start) as usize;
        let place = diagnosis.place;
        let kept = Diagnosis {
            place: place.map(|place| Span::new(own(place.start), own(place.end))),
            ..diagnosis.clone()
        };
        let spent = before - *left;
        judge.keep_correction(
            of,
            Correction {
                diagnosis: kept,
                spent,
            },
        );
    }
    Some(diagnosis)
}

/// The likeliest single change that makes a line provable, as far as what is left allows to look for it, and how unlikely
/// it is.
fn correction(
    judge: &mut Judge<'_>,
    line: &Line,
    judged: &Judged,
    known: &Rc<Letters>,
    left: &mut usize,
) -> Option<(Diagnosis, u32)> {
    let cost = LEAST_COST + terms(judged);
    let document = judge.document;
    // Most lines are put right by one of the likeliest: the others are made where these are not.
    let of = |costs: Range<u32>| {
        let slips = move || slips(&document.source, line, costs);
        std::iter::once_with(slips).flatten()
    };
    let others = || other_letters(&document.source, line, &letters(document, line));
    let others = std::iter::once_with(others).flatten();
    let likelier = of(0..LIKELIEST).chain(of(LIKELIEST..OTHER_LETTER));
    let mut slips = likelier.chain(others).chain(of(OTHER_LETTER..u32::MAX));
    let before = judge.stand_at(&judged.at);
    let mut tried = BTreeSet::new();
    let terms = match is_told_by_tree(document, line) {
        true => Terms::of(judge, line, judged, known),
        false => None,
    };
    let found = slips.find_map(|Slip { edit, change }| {
        if tried.len() == MOST_TRIED || *left < cost {
            return None;
        }
        let text = edited(document.source.slice(line.span), line.span.start, &[&edit])?;
        let new = tried.insert(text.clone());
        if new {
            *left -= cost;
        }
        let holds = new
            && may_hold(judge, line, terms.as_ref(), &edit, change.as_ref())
            && !says_nothing(&text)
            && judge.follows_as(&text, judged.head, line);
        let cost = edit.cost;
        holds.then(|| (diagnosis(edit, &text), cost))
    });
    judge.stand_at(&before);
    found
}

/// Whether a changed line may hold, as far as its tree tells that without reading it anew.
fn may_hold(
    judge: &mut Judge<'_>,
    line: &Line,
    terms: Option<&Terms<'_>>,
    edit: &Edit,
    change: Option<&Change>,
) -> bool {
    let told = terms.zip(change);
    let told = told.and_then(|(terms, change)| terms.may_hold(judge, edit.span, change));
    told.unwrap_or_else(|| match change {
        Some(Change::Symbol(symbol)) if is_told_by_tree(judge.document, line) => {
            judge.may_follow_with(line, edit.span, symbol)
        }
        _ => true,
    })
}

/// Whether a change to the text of a line is one to its tree at the same place: in plain text what touches may be one word.
fn is_told_by_tree(document: &Document, line: &Line) -> bool {
    document.format != Format::Text && !line.continues
}

/// How many terms a line has when its products are multiplied out.
fn terms(judged: &Judged) -> usize {
    let sides = judged.sides.iter().flat_map(|(left, right)| [left, right]);
    sides
        .map(|side| side.numerator().len() + side.denominator().len())
        .sum()
}

fn diagnosis(edit: Edit, text: &str) -> Diagnosis {
    // Marks of alignment mean nothing outside the environment that the line stands in.
    let text = match text.contains("\\begin") {
        true => text.to_owned(),
        false => text.replace('&', ""),
    };
    Diagnosis {
        kind: edit.kind,
        message: edit.message,
        suggestion: Some(text.trim().to_owned()),
        place: Some(edit.span),
    }
}

/// Two sides that are written alike say nothing.
fn says_nothing(text: &str) -> bool {
    let plain = |side: &str| -> String {
        let characters = side.chars();
        characters
            .filter(|c| !c.is_whitespace() && *c != '&')
            .collect()
    };
    let sides: Vec<String> = text.split('=').map(plain).collect();
    sides.windows(2).any(|pair| pair[0] == pair[1])
}

/// The symbols that a document writes, with their writings, those of the line first.
fn letters<'d>(document: &'d Document, line: &'d Line) -> Vec<(&'d str, &'d Symbol)> {
    fn collect<'d>(document: &'d Document, node: &'d Node, found: &mut Vec<(&'d str, &'d Symbol)>) {
        if let Kind::Symbol(symbol) = &node.kind
            && !symbol.resultant
        {
            let text = document.source.slice(node.span).trim();
            if !text.is_empty() && !found.iter().any(|(known, _)| *known == text) {
                found.push((text, symbol));
            }
        }
        let children = node.children();
        children.for_each(|child| collect(document, child, found));
    }
    let mut found = vec![];
    let own = line.sides.iter();
    let all = document.lines().flat_map(|line| &line.sides);
    for side in own.chain(all) {
        collect(document, side, &mut found);
    }
    found
}
