//! What is said of the work of one student.

use crate::grade::policy::Marks;
use crate::notation::document::Document;
use crate::source::Span;
use crate::verify::{Counterexample, Finding, Verdict};
use serde::{Deserialize, Serialize};

/// Where a line stands in the work of a student.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Place {
    /// The file, where there are several.
    pub file: Option<String>,
    /// The notebook cell, from 0.
    pub cell: Option<usize>,
    /// The line of the file, or of the cell, from 1.
    pub source_line: usize,
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if let Some(file) = &self.file {
            write!(f, "{file}, ")?;
        }
        if let Some(cell) = self.cell {
            write!(f, "cell {cell}, ")?;
        }
        write!(f, "line {}", self.source_line)
    }
}

/// What became of a milestone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Outcome {
    /// It is reached by true lines.
    Full,
    /// It is wrong, and only carries on an earlier slip.
    FollowThrough,
    /// It is not reached.
    None,
    /// A person should look.
    Human,
}

impl Outcome {
    /// The word that the JSON form uses.
    pub fn name(self) -> &'static str {
        match self {
            Self::Full => "full",
            Self::FollowThrough => "follow-through",
            Self::None => "none",
            Self::Human => "human",
        }
    }
}

/// One milestone in the work of one student.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reached {
    /// The label of the milestone in the key.
    pub label: String,
    /// What it is worth.
    pub max: Marks,
    /// What is given.
    pub marks: Marks,
    /// What became of it.
    pub outcome: Outcome,
    /// The line that decides it.
    pub place: Option<Place>,
    /// Why, in one sentence.
    pub reason: String,
}

/// The first line that is wrong by itself.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Slip {
    /// Where it stands.
    pub place: Place,
    /// The name of the mistake: `sign`, `missing-term`, …
    pub kind: String,
    /// One clause that says it.
    pub message: String,
    /// The line as it should stand.
    pub repair: Option<String>,
}

/// Something that a student assumes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Assumption {
    /// Where it stands.
    pub place: Place,
    /// As written.
    pub text: String,
    /// Whether the key makes it too, or it follows from what the key declares.
    pub in_key: bool,
}

/// Numbers for which a line fails, as anyone can put them in.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Numbers {
    /// Each symbol of the line in LaTeX with its value.
    pub symbols: Vec<(String, String)>,
    /// The component that differs.
    pub component: Option<String>,
    /// The value of the left side.
    pub left: String,
    /// The value of the right side.
    pub right: String,
}

impl From<Counterexample> for Numbers {
    fn from(of: Counterexample) -> Self {
        Self {
            symbols: of.symbols,
            component: of.component,
            left: of.left,
            right: of.right,
        }
    }
}

/// One line of a student with its verdict.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// Where it stands.
    pub place: Place,
    /// As written.
    pub source: String,
    /// `proved`, `refuted`, `accepted`, `undecided`, `unreadable`, `withdrawn`.
    pub verdict: String,
    /// Why, where there is something to say.
    pub reason: Option<String>,
    /// The likely mistake, in one clause.
    pub mistake: Option<String>,
    /// The line as it should stand.
    pub repair: Option<String>,
    /// The numbers in which it fails.
    pub counterexample: Option<Numbers>,
    /// Whether it only carries on an earlier slip.
    pub carried: bool,
}

impl Line {
    /// A line of a file by what was found of it.
    pub fn of(finding: &Finding, file: Option<String>) -> Self {
        let refuted = finding.verdict == Verdict::Refuted;
        let diagnosis = finding.diagnosis.as_ref().filter(|_| refuted);
        let counterexample = finding.counterexample.clone().filter(|_| refuted);
        Self {
            place: Place {
                file,
                cell: finding.cell,
                source_line: finding.source_line,
            },
            source: finding.source.clone(),
            verdict: finding.verdict.name().to_owned(),
            reason: finding.reason.clone(),
            mistake: diagnosis.map(|diagnosis| diagnosis.message.clone()),
            repair: diagnosis.and_then(|diagnosis| diagnosis.suggestion.clone()),
            counterexample: counterexample.map(Numbers::from),
            carried: finding.follows_from.is_some(),
        }
    }

    /// A line of a document that its author does not claim, with why.
    pub(super) fn withdrawn(
        document: &Document,
        span: Span,
        file: Option<String>,
        why: &str,
    ) -> Self {
        let place = document.place_of_row(span.start);
        Self {
            place: Place {
                file,
                cell: place.cell,
                source_line: place.line,
            },
            source: document.source.slice(span).to_owned(),
            verdict: "withdrawn".to_owned(),
            reason: Some(why.to_owned()),
            mistake: None,
            repair: None,
            counterexample: None,
            carried: false,
        }
    }
}

/// The work of one student, marked.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Graded {
    /// The student.
    pub id: String,
    /// The sum.
    pub marks: Marks,
    /// The milestones in the order of the key.
    pub milestones: Vec<Reached>,
    /// The first slip.
    pub first_slip: Option<Slip>,
    /// What is assumed.
    pub assumptions: Vec<Assumption>,
    /// Why a person should look.
    pub queue: Option<String>,
    /// Every line with its verdict.
    pub lines: Vec<Line>,
    /// Letters that nothing tells of, as questions, each with the number of lines that wait.
    pub questions: Vec<(String, usize)>,
    /// How the work was read where it was read in another way than the sheet says.
    #[serde(default)]
    pub notes: Vec<String>,
}
