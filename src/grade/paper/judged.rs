//! What is found of the lines of a submission at one stage of the key.

use crate::grade::key::Key;
use crate::grade::meaning::Meaning;
use crate::notation::ast::{Kind, Relation};
use crate::notation::document::{Document, Item};
use crate::verify::{Finding, Report, Role, Verdict, Written};

/// What was found of all documents at one stage.
#[derive(Clone)]
pub(super) struct Checked {
    pub(super) reports: Vec<Report>,
    /// With what is assumed taken as claimed; none where nothing is assumed.
    pub(super) claimed: Option<Vec<Report>>,
}

/// Checks all documents at a stage, and again with what they assume taken as claimed.
pub(super) fn at_stage(
    key: &Key,
    stage: usize,
    entries: bool,
    meaning: &Meaning,
    answers: &[String],
    (documents, written): (&[Document], &[Written]),
) -> Checked {
    // With the most given, one change may put a line right.
    let mut later = key.stages.iter().skip(stage + 1);
    let is_last = later.all(|later| later.judged_as.is_some());
    let each = || documents.iter().zip(written);
    let reports = each().map(|(document, written)| match is_last {
        true => meaning.check(document, written),
        false => meaning.judge(document, written),
    });
    let mut reports: Vec<Report> = reports.collect();
    let claimed = |reports: &[Report]| {
        let assumes = |report: &Report| report.findings.iter().any(is_assumption);
        if !reports.iter().any(assumes) {
            return None;
        }
        let claimed = each().zip(reports).map(|((document, written), report)| {
            let assumed = report.findings.iter().filter(|f| is_assumption(f));
            let assumed: Vec<&Finding> = assumed.collect();
            match (key.is_declared, answers.is_empty()) {
                (false, _) => return meaning.judge(&with_claims(document, &assumed), written),
                (true, true) => return meaning.judge_as_claimed(document, written, &assumed),
                // What was answered may say what a line is for, and then counts.
                (true, false) => {}
            }
            let roles = assumed.iter().map(|f| match f.cell {
                Some(cell) => format!("Line {} of cell {cell} is a claim.", f.source_line),
                None => format!("Line {} is a claim.", f.source_line),
            });
            let roles: Vec<String> = roles.chain(answers.iter().cloned()).collect();
            key.meaning(stage, entries, &roles).judge(document, written)
        });
        Some(claimed.collect::<Vec<Report>>())
    };
    let first = claimed(&reports);
    let names = |claims: &Vec<Report>| name_letters(key, documents, &mut reports, claims);
    let claimed = match first.as_ref().is_some_and(names) {
        true => claimed(&reports),
        false => first,
    };
    Checked { reports, claimed }
}

/// Takes what only gives a new letter for a definition: "let τ = M" assumes nothing. Says whether there was any.
fn name_letters(
    key: &Key,
    documents: &[Document],
    reports: &mut [Report],
    claims: &[Report],
) -> bool {
    let mut found = false;
    for ((document, report), claims) in documents.iter().zip(reports).zip(claims) {
        for (finding, claim) in report.findings.iter_mut().zip(&claims.findings) {
            let open = is_assumption(finding) && claim.verdict == Verdict::Undecided;
            if open && names_letter(key, document, finding) {
                finding.role = Role::Define;
                found = true;
            }
        }
    }
    found
}

/// Whether a side of an equation is a letter of which the key does not speak.
fn names_letter(key: &Key, document: &Document, finding: &Finding) -> bool {
    let line = document.lines().find(|line| line.span == finding.span);
    line.is_some_and(|line| {
        let equal = line
            .relations
            .iter()
            .all(|(relation, _)| *relation == Relation::Equal);
        let mut sides = line.sides.iter();
        equal && sides.any(|side| matches!(side.kind, Kind::Symbol(_)) && !key.speaks_of(side))
    })
}

pub(super) fn is_assumption(finding: &Finding) -> bool {
    finding.verdict == Verdict::Accepted && matches!(finding.role, Role::Assume | Role::Given)
}

/// A document in which comments say that these lines are claimed.
fn with_claims(document: &Document, lines: &[&Finding]) -> Document {
    let mut claimed = document.clone();
    claimed.items.clear();
    for item in &document.items {
        if let Item::Formula(formula) = item {
            let inside = |f: &&&Finding| {
                formula.span.start <= f.span.start && f.span.end <= formula.span.end
            };
            if lines.iter().any(|f| inside(&f)) {
                claimed.items.push(Item::Comment {
                    text: "claim".to_owned(),
                    span: formula.span.before(),
                });
            }
        }
        claimed.items.push(item.clone());
    }
    claimed
}
