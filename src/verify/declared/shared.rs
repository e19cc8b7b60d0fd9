//! Sentences that many documents share: what they make is made once.

use crate::notation::document::Document;
use crate::verify::declarations::Declared;
use crate::verify::declared::judgment::{Judgment, OwnLetters, judgments};
use crate::verify::declared::report;
use crate::verify::reading::LineRole;
use crate::verify::standing::judge::Judge;
use crate::verify::standing::parts::{Part, is_of_one_system};
use crate::verify::standing::prepared::Prepared;
use crate::verify::standing::written::written_symbols;
use crate::verify::term::letters::Reach;
use crate::verify::{Finding, Report, Role};
use std::cell::RefCell;
use std::sync::Arc;

/// No more readings are kept: documents differ in what they write in few ways that count.
const MOST_READINGS: usize = 32;

/// What is declared of many documents. For those that would be read alike it is read once.
#[derive(Clone, Debug)]
pub(crate) struct Shared {
    pub(crate) declared: Declared,
    /// A document without a line, in whose notation the sentences are written.
    bare: Document,
    readings: RefCell<Vec<Read>>,
}

/// What the sentences make of documents that are read alike.
#[derive(Clone, Debug)]
struct Read {
    prepared: Prepared,
    own: Arc<OwnLetters>,
}

impl Shared {
    /// Of these sentences, written in the notation of a document without a line.
    pub(crate) fn new(declared: Declared, bare: Document) -> Self {
        Self {
            declared,
            bare,
            readings: RefCell::default(),
        }
    }

    /// Judges every line of a document, and looks for what would put false ones right. The report leaves out what the
    /// sentences say, which is the same for all documents.
    pub(crate) fn check(&self, document: &Document) -> Report {
        let mut judgments = self.judgments(document, &[]);
        judgments.iter_mut().for_each(Judgment::correct);
        report(document, &self.declared, &judgments)
    }

    /// The same without looking for what would put false lines right, and with some lines taken as claimed.
    pub(crate) fn judge(&self, document: &Document, claimed: &[&Finding]) -> Report {
        report(document, &self.declared, &self.judgments(document, claimed))
    }

    fn judgments<'d>(&self, document: &'d Document, claimed: &[&Finding]) -> Vec<Judgment<'d>> {
        let claims = claimed.iter().map(|finding| {
            let reach = Reach::Lines {
                cell: finding.cell,
                first: finding.source_line,
                last: finding.source_line,
            };
            LineRole::new(reach, Some(Role::Claim))
        });
        if !is_of_one_system(&self.declared.declarations) {
            return judgments(document, &self.declared.declarations, claims);
        }
        let (mut prepared, own) = self.reading(document);
        prepared.reading.roles.extend(claims);
        let mut judge = Judge::over(document, Part::default(), prepared);
        judge.run();
        vec![Judgment::of(judge, own, 0)]
    }

    /// The reading of a document.
    fn reading(&self, document: &Document) -> (Prepared, Arc<OwnLetters>) {
        let mut readings = self.readings.borrow_mut();
        let known = readings.iter().find_map(|read| {
            let prepared = read.prepared.for_document(document)?;
            Some((prepared, read.own.clone()))
        });
        known.unwrap_or_else(|| {
            let written = written_symbols(document);
            let mut prepared = Prepared::new(&self.declared.declarations, written, 0);
            prepared.work_out();
            let own = OwnLetters::of(&self.bare, &mut prepared.reading, &mut prepared.known);
            let own = Arc::new(own);
            if readings.len() < MOST_READINGS {
                readings.push(Read {
                    prepared: prepared.clone(),
                    own: own.clone(),
                });
            }
            (prepared, own)
        })
    }
}
