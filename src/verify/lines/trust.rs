//! Whether the reading of a document is good enough to call a line of it false.
//!
//! A refutation is exact for the line as it is read. Where a document was misread (a letter that stands for something
//! else, a supposition in words that were not understood), true lines come out false by the dozen, and hardly one of them
//! is false by a slip that people make. Where a document was read well, nearly every false line is.

use crate::verify::verdict::{Finding, Report, Verdict};
use std::collections::BTreeSet;

/// Slips that a misreading brings about as well: what is missing can always be added.
const NO_EVIDENCE: [&str; 4] = ["missing-term", "extra-term", "symbol", "arithmetic"];
/// So many lines that are not understood may stand in any document.
const FEW: usize = 3;

/// Leaves refutations open that no slip explains, where too much of a document was not understood.
pub(crate) fn withhold(report: &mut Report) {
    let summary = report.summary();
    let slips = report.findings.iter().filter(|f| is_false(f) && is_slip(f));
    let many_false = summary.refuted >= FEW && summary.proved < 3 * summary.refuted;
    let many_open = summary.undecided >= FEW && summary.undecided > summary.proved + slips.count();
    if !many_false && !many_open {
        return;
    }
    let mut false_lines = BTreeSet::new();
    for finding in report.findings.iter_mut().filter(|f| is_false(f)) {
        let carried = finding
            .follows_from
            .is_some_and(|line| false_lines.contains(&line));
        if carried || is_slip(finding) {
            false_lines.insert(finding.source_line);
        } else {
            leave_open(finding);
        }
    }
}

/// False lines that no slip explains, neither their own nor one that they carry on.
pub(crate) fn unexplained(report: &Report) -> impl Iterator<Item = &Finding> {
    let slipped = |f: &&Finding| is_false(f) && !is_slip(f) && f.follows_from.is_none();
    report.findings.iter().filter(slipped)
}

fn leave_open(finding: &mut Finding) {
    finding.verdict = Verdict::Undecided;
    finding.diagnosis = None;
    finding.follows_from = None;
    let reason = "it is false as it is read here, but too little of the document is understood to trust the reading";
    finding.reason = Some(reason.to_owned());
}

fn is_false(finding: &Finding) -> bool {
    finding.verdict == Verdict::Refuted
}

/// Whether a slip that people make turns the line into a true one.
fn is_slip(finding: &Finding) -> bool {
    let slip = finding.diagnosis.as_ref().map(|diagnosis| diagnosis.kind);
    slip.is_some_and(|kind| !NO_EVIDENCE.contains(&kind))
}
