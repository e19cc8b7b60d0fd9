//! The JSON form of a check: schema `polhode-check/1`.

use crate::diagnostic::{Diagnostic, Severity};
use crate::report::{Checked, Failure};
use crate::verify::{
    Answer, Counterexample, Diagnosis, Finding, FromProse, Meant, Passed, Question, Summary,
};
use serde::Serialize;
use serde_json::{Map, Value};

/// Checked documents and inputs that could not be read, as one JSON object with a line break at its end.
///
/// # Errors
///
/// None that a text could cause; the type is that of the serialiser.
pub fn check(checked: &[Checked], failures: &[Failure]) -> serde_json::Result<String> {
    let form = Form {
        schema: "polhode-check/1",
        documents: checked.iter().map(DocumentForm::of).collect(),
        errors: failures.iter().map(FailureForm::of).collect(),
    };
    serde_json::to_string_pretty(&form).map(|text| text + "\n")
}

#[derive(Serialize)]
struct Form<'a> {
    schema: &'static str,
    documents: Vec<DocumentForm<'a>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    errors: Vec<FailureForm<'a>>,
}

#[derive(Serialize)]
struct FailureForm<'a> {
    path: &'a str,
    message: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    cell: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    source_line: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    source_column: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    help: Option<&'a str>,
}

impl<'a> FailureForm<'a> {
    fn of(failure: &'a Failure) -> Self {
        Self {
            path: &failure.path,
            message: &failure.message,
            cell: failure.cell,
            source_line: failure.place.map(|(line, _)| line),
            source_column: failure.place.map(|(_, column)| column),
            help: failure.help.as_deref(),
        }
    }
}

#[derive(Serialize)]
struct DocumentForm<'a> {
    path: &'a str,
    products: &'static str,
    lines: Vec<LineForm<'a>>,
    summary: SummaryForm,
    products_decided_by: &'static str,
    readings: &'a [String],
    from_prose: Vec<FromProseForm<'a>>,
    passed: Vec<PassedForm>,
    diagnostics: Vec<DiagnosticForm<'a>>,
    meaning: Vec<MeantForm<'a>>,
    questions: Vec<QuestionForm<'a>>,
}

impl<'a> DocumentForm<'a> {
    fn of(checked: &'a Checked) -> Self {
        let report = &checked.report;
        let diagnostics = checked.diagnostics.iter();
        let prose = report.from_prose.iter();
        Self {
            path: &report.path,
            products: report.products.name,
            lines: report.findings.iter().map(LineForm::of).collect(),
            summary: SummaryForm::of(report.summary()),
            products_decided_by: report.products.decided_by,
            readings: &report.readings,
            from_prose: prose.map(|said| FromProseForm::of(checked, said)).collect(),
            passed: report.passed.iter().map(PassedForm::of).collect(),
            diagnostics: diagnostics
                .map(|diagnostic| DiagnosticForm::of(checked, diagnostic))
                .collect(),
            meaning: report.meaning.iter().map(MeantForm::of).collect(),
            questions: report.questions.iter().map(QuestionForm::of).collect(),
        }
    }
}

#[derive(Serialize)]
struct LineForm<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    cell: Option<usize>,
    source_line: usize,
    source_column: usize,
    source: &'a str,
    label: Option<&'a str>,
    role: &'static str,
    verdict: &'static str,
    uses: &'a [String],
    conditions: &'a [String],
    residual: Option<&'a str>,
    counterexample: Option<CounterexampleForm<'a>>,
    diagnosis: Option<DiagnosisForm<'a>>,
    follows_from: Option<usize>,
    reason: Option<&'a str>,
    remarks: &'a [String],
}

impl<'a> LineForm<'a> {
    fn of(finding: &'a Finding) -> Self {
        Self {
            cell: finding.cell,
            source_line: finding.source_line,
            source_column: finding.source_column,
            source: &finding.source,
            label: finding.label.as_deref(),
            role: finding.role.name(),
            verdict: finding.verdict.name(),
            uses: &finding.uses,
            conditions: &finding.conditions,
            residual: finding.residual.as_deref(),
            counterexample: finding.counterexample.as_ref().map(CounterexampleForm::of),
            diagnosis: finding.diagnosis.as_ref().map(DiagnosisForm::of),
            follows_from: finding.follows_from,
            reason: finding.reason.as_deref(),
            remarks: &finding.remarks,
        }
    }
}

#[derive(Serialize)]
struct CounterexampleForm<'a> {
    symbols: Map<String, Value>,
    left: &'a str,
    right: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    component: Option<&'a str>,
}

impl<'a> CounterexampleForm<'a> {
    fn of(counterexample: &'a Counterexample) -> Self {
        let symbols = counterexample.symbols.iter();
        Self {
            symbols: symbols
                .map(|(name, value)| (name.clone(), Value::from(value.as_str())))
                .collect(),
            left: &counterexample.left,
            right: &counterexample.right,
            component: counterexample.component.as_deref(),
        }
    }
}

#[derive(Serialize)]
struct DiagnosisForm<'a> {
    kind: &'static str,
    message: &'a str,
    suggestion: Option<&'a str>,
}

impl<'a> DiagnosisForm<'a> {
    fn of(diagnosis: &'a Diagnosis) -> Self {
        Self {
            kind: diagnosis.kind,
            message: &diagnosis.message,
            suggestion: diagnosis.suggestion.as_deref(),
        }
    }
}

#[derive(Serialize)]
struct SummaryForm {
    proved: usize,
    accepted: usize,
    refuted: usize,
    undecided: usize,
    unreadable: usize,
}

impl SummaryForm {
    fn of(summary: Summary) -> Self {
        Self {
            proved: summary.proved,
            accepted: summary.accepted,
            refuted: summary.refuted,
            undecided: summary.undecided,
            unreadable: summary.unreadable,
        }
    }
}

#[derive(Serialize)]
struct FromProseForm<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    cell: Option<usize>,
    source_line: usize,
    premise: &'a str,
}

impl<'a> FromProseForm<'a> {
    fn of(checked: &Checked, from_prose: &'a FromProse) -> Self {
        Self {
            cell: checked.document.place(from_prose.span.start).cell,
            source_line: from_prose.source_line,
            premise: &from_prose.premise,
        }
    }
}

#[derive(Serialize)]
struct PassedForm {
    #[serde(skip_serializing_if = "Option::is_none")]
    cell: Option<usize>,
    source_line: usize,
    what: &'static str,
}

impl PassedForm {
    fn of(passed: &Passed) -> Self {
        Self {
            cell: passed.cell,
            source_line: passed.source_line,
            what: passed.what,
        }
    }
}

#[derive(Serialize)]
struct DiagnosticForm<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    cell: Option<usize>,
    source_line: usize,
    source_column: usize,
    severity: &'static str,
    code: &'static str,
    message: &'a str,
    notes: &'a [String],
    helps: &'a [String],
}

impl<'a> DiagnosticForm<'a> {
    fn of(checked: &Checked, diagnostic: &'a Diagnostic) -> Self {
        let place = checked.document.place(diagnostic.primary.span.start);
        Self {
            cell: place.cell,
            source_line: place.line,
            source_column: place.column,
            severity: match diagnostic.severity {
                Severity::Note => "note",
                Severity::Warning => "warning",
                Severity::Error => "error",
            },
            code: diagnostic.code,
            message: &diagnostic.message,
            notes: &diagnostic.notes,
            helps: &diagnostic.helps,
        }
    }
}

#[derive(Serialize)]
struct MeantForm<'a> {
    sentence: &'a str,
    source: &'a str,
}

impl<'a> MeantForm<'a> {
    fn of(meant: &'a Meant) -> Self {
        Self {
            sentence: &meant.sentence,
            source: &meant.source,
        }
    }
}

#[derive(Serialize)]
struct QuestionForm<'a> {
    text: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    cell: Option<usize>,
    source_line: usize,
    answers: Vec<AnswerForm<'a>>,
    lines: &'a [usize],
}

impl<'a> QuestionForm<'a> {
    fn of(question: &'a Question) -> Self {
        Self {
            text: &question.text,
            cell: question.cell,
            source_line: question.source_line,
            answers: question.answers.iter().map(AnswerForm::of).collect(),
            lines: &question.lines,
        }
    }
}

#[derive(Serialize)]
struct AnswerForm<'a> {
    sentence: &'a str,
    holds: &'a [usize],
    fails: &'a [usize],
}

impl<'a> AnswerForm<'a> {
    fn of(answer: &'a Answer) -> Self {
        Self {
            sentence: &answer.sentence,
            holds: &answer.holds,
            fails: &answer.fails,
        }
    }
}
