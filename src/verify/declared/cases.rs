//! A document of which sentences leave more than one case.

use crate::verify::language::messages::{IN_BOTH_CASES, OPEN_CASE};
use crate::verify::verdict::{Finding, Report, Verdict};

/// The report of the first case, where each line has the verdict that it has in all of them, or none.
pub(super) fn in_all_cases(mut first: Report, others: &[Report]) -> Report {
    for (at, finding) in first.findings.iter_mut().enumerate() {
        let same = |other: &Report| {
            let other = other.findings.get(at);
            other.is_some_and(|other| {
                other.span == finding.span && other.verdict.name() == finding.verdict.name()
            })
        };
        match others.iter().all(same) {
            true if matches!(finding.verdict, Verdict::Proved(_)) => {
                finding.remarks.push(IN_BOTH_CASES.to_owned());
            }
            true => {}
            false => leave_open(finding),
        }
    }
    first
}

/// Takes a verdict back.
pub(super) fn leave_open(finding: &mut Finding) {
    finding.verdict = Verdict::Undecided;
    finding.reason = Some(OPEN_CASE.to_owned());
    finding.uses.clear();
    finding.conditions.clear();
    finding.residual = None;
    finding.counterexample = None;
    finding.diagnosis = None;
    finding.follows_from = None;
}
