//! What is said of each line.

use crate::algebra::{Proof, Variable};
use crate::notation::document::Document;
use crate::source::Span;
use crate::verify::language::messages::{IN_BOTH_CASES, OPEN_CASE};
use crate::verify::language::wants::Wants;

/// What a line is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// It says that something is so.
    Claim,
    /// It is handed over from outside.
    Given,
    /// It narrows the motion or the body, to the end of its section.
    Assume,
    /// It gives a symbol its meaning.
    Define,
}

impl Role {
    /// The word that the JSON form uses.
    pub fn name(self) -> &'static str {
        match self {
            Self::Claim => "claim",
            Self::Given => "given",
            Self::Assume => "assume",
            Self::Define => "define",
        }
    }
}

/// The answer to a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// An exact proof was found and multiplied out; it is here.
    Proved(Proof),
    /// A given, an assumption or a definition that is consistent with what stands before it.
    Accepted,
    /// There is a possible body and motion for which it is false, or it has no meaning as typed.
    Refuted,
    /// Neither was shown; or it is false as it is read, and too little of the document is understood to trust that.
    Undecided,
    /// It could not be read.
    Unreadable,
}

impl Verdict {
    /// The word that the JSON form uses.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Proved(_) => "proved",
            Self::Accepted => "accepted",
            Self::Refuted => "refuted",
            Self::Undecided => "undecided",
            Self::Unreadable => "unreadable",
        }
    }
}

/// Values for which a refuted line fails, as anyone can put them in.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Counterexample {
    /// Each symbol of the line in LaTeX with its value, in the order of the line.
    pub symbols: Vec<(String, String)>,
    /// The component that differs, for vector and matrix lines: `x`, `2`, `row 1, column 3`.
    pub component: Option<String>,
    /// The value of the left side.
    pub left: String,
    /// The value of the right side.
    pub right: String,
}

/// What the mistake is, and its repair.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnosis {
    /// The name of the mistake: `sign`, `missing-dot`, `frame`, …
    pub kind: &'static str,
    /// One clause that says it.
    pub message: String,
    /// The line as it should stand, in the author's notation; proved.
    pub suggestion: Option<String>,
    /// The bytes to change.
    pub place: Option<Span>,
}

/// What is said of one line.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The bytes of the line.
    pub span: Span,
    /// The line of the file (within the cell, for a notebook) on which it starts, from 1.
    pub source_line: usize,
    /// The column on which it starts, from 1, in characters.
    pub source_column: usize,
    /// The notebook cell, from 0.
    pub cell: Option<usize>,
    /// The line as written.
    pub source: String,
    /// Its label.
    pub label: Option<String>,
    /// What it is for.
    pub role: Role,
    /// The answer.
    pub verdict: Verdict,
    /// One clause that gives the reason, for every verdict but `Proved` and `Accepted`.
    pub reason: Option<String>,
    /// The bytes that the reason speaks of; the whole line where there is no better place.
    pub place: Span,
    /// Laws, assumptions and earlier lines that the proof needs.
    pub uses: Vec<String>,
    /// What must not be zero for the line to have a meaning, in LaTeX: `I_{xx} \ne 0`.
    pub conditions: Vec<String>,
    /// Remarks: how an ambiguous notation was read, a premise cited and not needed.
    pub remarks: Vec<String>,
    /// Left side less right side in the author's symbols, in LaTeX.
    pub residual: Option<String>,
    /// Where it fails.
    pub counterexample: Option<Counterexample>,
    /// The likely mistake.
    pub diagnosis: Option<Diagnosis>,
    /// The source line of the earlier line whose error this one only carries forward.
    pub follows_from: Option<usize>,
}

impl Finding {
    /// Takes the verdict back, and says why.
    pub(crate) fn leave_open(&mut self, reason: impl Into<String>) {
        self.verdict = Verdict::Undecided;
        self.reason = Some(reason.into());
        self.uses.clear();
        self.conditions.clear();
        self.residual = None;
        self.counterexample = None;
        self.diagnosis = None;
        self.follows_from = None;
    }

    /// A finding of which nothing is said yet.
    pub(crate) fn undecided(document: &Document, role: Role, span: Span) -> Self {
        let place = document.place(span.start);
        Self {
            span,
            source_line: document.place_of_row(span.start).line,
            source_column: place.column,
            cell: place.cell,
            source: document.source.slice(span).trim().to_owned(),
            label: None,
            role,
            verdict: Verdict::Undecided,
            reason: None,
            place: span,
            uses: vec![],
            conditions: vec![],
            remarks: vec![],
            residual: None,
            counterexample: None,
            diagnosis: None,
            follows_from: None,
        }
    }
}

/// Something that stands in the document and was not taken as a line.
#[derive(Clone, Debug)]
pub struct Passed {
    /// Where.
    pub span: Span,
    /// The line of the file (within the cell), from 1.
    pub source_line: usize,
    /// The notebook cell, from 0.
    pub cell: Option<usize>,
    /// What it is: `expression`, `text`, …
    pub what: &'static str,
}

/// A premise that the words of the document set.
#[derive(Clone, Debug, PartialEq)]
pub struct FromProse {
    /// The words.
    pub span: Span,
    /// The line of the file (within the cell), from 1.
    pub source_line: usize,
    /// What was taken from them: `principal axes: I_xy = I_yz = I_zx = 0`.
    pub premise: String,
}

/// A sentence by which a document was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Meant {
    /// The sentence, in the words of the language.
    pub sentence: String,
    /// Where it comes from: `line 12`.
    pub source: String,
}

/// What is not known, and what would help.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Question {
    /// The question: "what is `n`?"
    pub text: String,
    /// The notebook cell of the first line that waits, from 0.
    pub cell: Option<usize>,
    /// The source line of the first line that waits.
    pub source_line: usize,
    /// What it could be.
    pub answers: Vec<Answer>,
    /// The source lines that wait.
    pub lines: Vec<usize>,
}

/// A sentence that would answer a question.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// The sentence.
    pub sentence: String,
    /// The source lines that hold with it.
    pub holds: Vec<usize>,
    /// The source lines that fail with it.
    pub fails: Vec<usize>,
}

/// What is said of a document.
#[derive(Clone, Debug)]
pub struct Report {
    /// The document's name.
    pub path: String,
    /// The convention for products of inertia, and where it comes from.
    pub products: Convention,
    /// One finding for each line, in the order of the document.
    pub findings: Vec<Finding>,
    /// Premises read from prose.
    pub from_prose: Vec<FromProse>,
    /// How letters with more than one meaning were read: `L: angular momentum`.
    pub readings: Vec<String>,
    /// What was no line.
    pub passed: Vec<Passed>,
    /// What each variable of the proofs stands for, in LaTeX, by its number.
    pub variables: Vec<String>,
    /// The sentences by which it was read.
    pub meaning: Vec<Meant>,
    /// What is not known, that for which most lines wait first.
    pub questions: Vec<Question>,
    /// Sentences as declared of which nothing was made.
    pub unused: Vec<Unused>,
}

/// A sentence of which nothing was made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unused {
    /// As it was declared.
    pub sentence: String,
    /// Whether the model would grow larger with it than what is worked out.
    pub beyond: bool,
    /// What would help, where that is known.
    pub wants: Option<Wants>,
}

/// The sign convention for products of inertia.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Convention {
    /// `integrals` (I_xy = ∫xy dm) or `entries` (I_xy is the tensor's entry).
    pub name: &'static str,
    /// What decided: `a matrix of the document`, `front matter`, `default`.
    pub decided_by: &'static str,
}

/// How many lines got each verdict.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[expect(missing_docs, reason = "each counts the verdict of that name")]
pub struct Summary {
    pub proved: usize,
    pub accepted: usize,
    pub refuted: usize,
    pub undecided: usize,
    pub unreadable: usize,
}

impl Report {
    /// The report of the first case, where each line has the verdict that it has in all of them, or none.
    pub(crate) fn in_all_cases(mut self, others: &[Self]) -> Self {
        for (at, finding) in self.findings.iter_mut().enumerate() {
            let same = |other: &Self| {
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
                false => finding.leave_open(OPEN_CASE),
            }
        }
        self
    }

    /// What a variable of a proof stands for, in LaTeX.
    pub fn variable(&self, variable: Variable) -> &str {
        let name = self.variables.get(variable as usize);
        name.map_or("", String::as_str)
    }

    /// Counts the verdicts.
    pub fn summary(&self) -> Summary {
        let mut summary = Summary::default();
        for finding in &self.findings {
            *match finding.verdict {
                Verdict::Proved(_) => &mut summary.proved,
                Verdict::Accepted => &mut summary.accepted,
                Verdict::Refuted => &mut summary.refuted,
                Verdict::Undecided => &mut summary.undecided,
                Verdict::Unreadable => &mut summary.unreadable,
            } += 1;
        }
        summary
    }
}
