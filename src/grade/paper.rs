//! The work of one student: its texts, its lines, and what each line is worth at each stage of the key.

use crate::grade::key::Key;
use crate::grade::meaning::Meaning;
use crate::grade::paper::judged::{Checked, at_stage, is_assumption};
use crate::grade::paper::products::products;
use crate::grade::paper::texts::Texts;
use crate::grade::paper::withdrawn::Withdrawn;
use crate::grade::result::Place;
use crate::notation::document::{Document, Format};
use crate::source::Span;
use crate::verify::{Finding, Verdict, Written, written_symbols};
use std::borrow::Cow;
use std::collections::BTreeMap;

mod chains;
mod denied;
mod judged;
mod products;
mod texts;
mod told;
mod withdrawn;

/// A text of a student.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// The name of its file.
    pub name: String,
    /// What kind of file it is.
    pub format: Format,
    /// The whole text.
    pub text: String,
}

/// What a student hands in.
#[derive(Clone, Debug, PartialEq)]
pub struct Work {
    /// The student.
    pub id: String,
    /// The texts, in the order in which they are read.
    pub texts: Vec<Text>,
    /// What is wrong with how it was handed in: a person should look.
    pub troubles: Vec<String>,
    /// What a person answered to questions about it: sentences that declare something for this work alone.
    pub answers: Vec<String>,
}

impl Work {
    /// One text of one student.
    pub fn of_text(id: &str, name: &str, format: Format, text: &str) -> Self {
        let text = Text {
            name: name.to_owned(),
            format,
            text: text.to_owned(),
        };
        Self {
            id: id.to_owned(),
            texts: vec![text],
            troubles: vec![],
            answers: vec![],
        }
    }
}

/// What a line is worth at a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Worth {
    /// It is proved, and rests on nothing that the key does not give.
    True,
    /// It is refuted.
    False,
    /// It is proved by what the student assumes and the key does not.
    Resting,
    /// It is assumed.
    Assumed,
    /// It says what a letter of the student's own is.
    Defined,
    /// It is not decided, or not read.
    Open,
}

/// One line.
#[derive(Clone, Debug)]
pub(super) struct PaperLine {
    /// Its document.
    pub(super) document: usize,
    /// Its number in the document.
    pub(super) number: usize,
    pub(super) place: Place,
    /// For each stage.
    pub(super) worth: Vec<Worth>,
    /// For each stage, what was found.
    pub(super) found: Vec<Finding>,
    /// Whether it is proved where it is taken as claimed at the last stage.
    pub(super) follows_from_key: bool,
}

impl PaperLine {
    /// A line that may not be claimed is left open.
    fn leave_open_if_unclear(&mut self, withdrawn: &Withdrawn) {
        let own = self.found[0].span;
        let within = |span: &Span| span.start <= own.start && own.end <= span.end;
        let mut unclear = withdrawn.unclear.iter();
        if let Some((_, why)) = unclear.find(|(span, _)| within(span)) {
            self.worth.fill(Worth::Open);
            for found in &mut self.found {
                found.leave_open((*why).to_owned());
            }
        }
    }

    /// Whether it is false at some stage and never true: where less is given it may be open.
    pub(super) fn is_wrong(&self) -> bool {
        let mut worth = self.worth.iter();
        let never = worth.all(|worth| matches!(worth, Worth::False | Worth::Open));
        never && self.worth.contains(&Worth::False)
    }

    /// What was found at the stage that is kindest to it; of those that find it wrong, one that can put it right.
    pub(super) fn kindest(&self) -> &Finding {
        let rank = |(worth, found): &(&Worth, &Finding)| match worth {
            Worth::True => 0,
            Worth::Resting => 1,
            Worth::Assumed | Worth::Defined => 2,
            Worth::Open if !self.is_wrong() => 3,
            Worth::Open => 6,
            Worth::False if found.diagnosis.is_some() => 4,
            Worth::False => 5,
        };
        let each = self.worth.iter().zip(&self.found);
        each.min_by_key(rank)
            .map_or(&self.found[0], |(_, found)| found)
    }
}

/// The work of a student, read and checked.
pub(super) struct Paper<'k> {
    pub(super) documents: Vec<Document>,
    /// The symbols that each document writes.
    pub(super) written: Vec<Written>,
    pub(super) lines: Vec<PaperLine>,
    /// For each document, the bytes of its lines.
    pub(super) spans: Vec<Vec<Span>>,
    /// Whether products of inertia are entries here.
    pub(super) entries: bool,
    /// For each stage, what it means.
    pub(super) meaning: Vec<Cow<'k, Meaning>>,
    /// Why a person should look.
    pub(super) troubles: Vec<String>,
    pub(super) questions: Vec<(String, usize)>,
    /// For each document, what the student does not claim.
    pub(super) withdrawn: Vec<Withdrawn>,
    pub(super) remarks: Remarks,
}

/// What is said beside the marks.
#[derive(Default)]
pub(super) struct Remarks {
    /// How the work was read where it was read in another way than the sheet says.
    pub(super) notes: Vec<String>,
    /// Why a person should look if marks are missing.
    pub(super) doubts: Vec<String>,
}

impl<'k> Paper<'k> {
    /// Reads and checks the work of a student.
    pub(super) fn read(key: &'k Key, work: &Work) -> Self {
        let Texts {
            documents,
            withdrawn,
            mut told,
            doubts,
            mut troubles,
            products: said,
        } = texts::read(key, work);
        let products = products(key, said.as_deref(), &documents);
        let entries = products.entries;
        let mut notes: Vec<String> = products.note.into_iter().collect();
        notes.extend(
            told.iter()
                .map(|said| format!("taken as you say: {}", said.replace('$', "`"))),
        );
        // What staff answer rules what a student says.
        told.extend(work.answers.iter().cloned());
        let answers = told;
        let written: Vec<Written> = documents.iter().map(written_symbols).collect();
        let meaning = meaning(key, entries, &answers);
        let unclear = meaning.iter().flat_map(|own| &own.declared().misunderstood);
        if let Some(unclear) = unclear.take(1).next() {
            let why = &unclear.misread.message;
            troubles.push(format!("an answer is not understood: {why}"));
        }
        let mut each: Vec<Checked> = vec![];
        for (number, stage) in key.stages.iter().enumerate() {
            each.push(match stage.judged_as {
                Some(same) => each[same].clone(),
                None => {
                    let read = (&documents[..], &written[..]);
                    at_stage(key, number, entries, &meaning[number], &answers, read)
                }
            });
        }
        let spans = spans(&each, documents.len());
        let several = documents.len() > 1;
        let questions = questions(&each);
        let mut lines = lines(each, &documents, several);
        lines.iter_mut().for_each(|line| {
            line.leave_open_if_unclear(&withdrawn[line.document]);
        });
        Self {
            questions,
            lines,
            documents,
            written,
            spans,
            entries,
            meaning,
            troubles,
            withdrawn,
            remarks: Remarks { notes, doubts },
        }
    }

    /// The lines of a document that are given at a stage: definitions of the student's own letters.
    pub(super) fn given(&self, document: usize, stage: usize) -> Vec<Span> {
        let own = self.lines.iter().filter(|line| line.document == document);
        let defined = own.filter(|line| line.worth[stage] == Worth::Defined);
        defined.map(|line| line.found[stage].span).collect()
    }
}

/// What a work means at each stage: by the key, and by what was answered.
fn meaning<'k>(key: &'k Key, entries: bool, answers: &[String]) -> Vec<Cow<'k, Meaning>> {
    let stages = key.stages.iter().enumerate();
    let meaning = stages.map(|(number, stage)| match answers.is_empty() {
        true => Cow::Borrowed(&stage.meaning[usize::from(entries)]),
        false => Cow::Owned(key.meaning(number, entries, answers)),
    });
    meaning.collect()
}

fn spans(each: &[Checked], documents: usize) -> Vec<Vec<Span>> {
    let of = |document: usize| {
        let report = each
            .first()
            .and_then(|checked| checked.reports.get(document));
        report.map_or(vec![], |report| {
            report.findings.iter().map(|f| f.span).collect()
        })
    };
    (0..documents).map(of).collect()
}

fn lines(mut each: Vec<Checked>, documents: &[Document], several: bool) -> Vec<PaperLine> {
    let mut lines: Vec<PaperLine> = vec![];
    for (document, text) in documents.iter().enumerate() {
        let mut reports = each.iter_mut().map(|checked| {
            let report = checked.reports.get_mut(document);
            report.map_or(vec![], |report| std::mem::take(&mut report.findings))
        });
        let Some(first) = reports.next() else {
            continue;
        };
        let mut later: Vec<_> = reports.map(Vec::into_iter).collect();
        for (number, finding) in first.into_iter().enumerate() {
            let (cell, source_line) = (finding.cell, finding.source_line);
            let others = later.iter_mut().map(Iterator::next);
            let others: Vec<Finding> = others
                .map(|found| found.unwrap_or_else(|| finding.clone()))
                .collect();
            let found: Vec<Finding> = std::iter::once(finding).chain(others).collect();
            let claims = each.iter().map(|checked| {
                let reports = checked.claimed.as_ref()?;
                reports[document].findings.get(number)
            });
            let proved = |claim: &Finding| matches!(claim.verdict, Verdict::Proved(_));
            lines.push(PaperLine {
                document,
                number,
                place: Place {
                    file: several.then(|| text.source.name.clone()),
                    cell,
                    source_line,
                },
                worth: (claims.clone().zip(&found))
                    .map(|(claim, found)| worth(found, claim))
                    .collect(),
                follows_from_key: claims.flatten().any(proved),
                found,
            });
        }
    }
    lines
}

/// What a line is worth by what was found of it, and by what was found with nothing assumed.
fn worth(found: &Finding, claimed: Option<&Finding>) -> Worth {
    match (&found.verdict, claimed.map(|f| &f.verdict)) {
        (Verdict::Proved(_), None | Some(Verdict::Proved(_))) => Worth::True,
        (Verdict::Proved(_), Some(Verdict::Refuted)) => Worth::Resting,
        // Without what is assumed it is not decided: it may rest on it or on something else.
        (Verdict::Proved(_), Some(_)) => Worth::Open,
        (Verdict::Refuted, _) => Worth::False,
        (Verdict::Accepted, _) if is_assumption(found) => Worth::Assumed,
        (Verdict::Accepted, _) => Worth::Defined,
        (Verdict::Undecided | Verdict::Unreadable, _) => Worth::Open,
    }
}

fn questions(each: &[Checked]) -> Vec<(String, usize)> {
    let mut asked: BTreeMap<String, usize> = BTreeMap::new();
    let reports = each.first().map_or(&[][..], |checked| &checked.reports);
    for question in reports.iter().flat_map(|report| &report.questions) {
        *asked.entry(question.text.clone()).or_default() += question.lines.len();
    }
    asked.into_iter().collect()
}
