//! The key: an instructor's derivation, proved before anything is held against it.

use crate::diagnostic::Severity;
use crate::grade::key::axes::named_axes;
use crate::grade::key::groups::groups;
use crate::grade::key::named_rules::new_rules;
use crate::grade::key::refusal::{at, refusal};
use crate::grade::key::routes::route;
use crate::grade::matching::{self, Board};
use crate::grade::meaning::Meaning;
use crate::grade::policy::{Marks, Policy};
use crate::notation::document::{Document, Format, Sentence};
use crate::notation::{self, document::FrontMatter};
use crate::source::{Source, Span};
use crate::verify::language::statement::Extent;
use crate::verify::{self, Declared, Finding, Report, Role, Sheet, Verdict, Withheld};
use num_traits::Zero;

mod answered;
mod axes;
mod groups;
mod letters;
mod named_rules;
mod refusal;
mod routes;
mod withheld;

pub(super) use answered::QUANTITIES;
pub use answered::{Difference, Told};
pub(super) use named_rules::rules_of;
pub use refusal::Refusal;
pub(super) use routes::Route;

/// A line of the key that carries marks.
#[derive(Clone, Debug)]
pub(super) struct Milestone {
    pub(super) label: String,
    pub(super) max: Marks,
    /// Its lines, by their numbers in the key: several rows may share a label.
    pub(super) lines: Vec<usize>,
    /// The stage that it belongs to.
    pub(super) stage: usize,
    /// Whether it needs a line of its own.
    pub(super) shown: bool,
}

/// What is assumed when a milestone comes. The key's assumptions before it are given for it.
#[derive(Clone, Debug)]
pub(super) struct Stage {
    /// What is declared of every submission, with products of inertia as integrals and as entries.
    pub(super) meaning: [Meaning; 2],
    /// The lines of the key that are given from the beginning: definitions, and assumptions so far.
    pub(super) given: Vec<Span>,
    /// How each line of the key follows from earlier ones.
    pub(super) routes: Vec<Route>,
    /// What is declared and says what its milestones say: they are looked for without it.
    withheld: Withheld,
    /// An earlier stage with the same given, by which lines are judged here too.
    pub(super) judged_as: Option<usize>,
}

/// A key that holds.
#[derive(Clone, Debug)]
pub struct Key {
    /// Its name, as given.
    pub name: String,
    pub(super) document: Document,
    /// The bytes of its lines.
    pub(super) lines: Vec<Span>,
    /// Settings that hold for a submission that makes none.
    pub(super) settings: FrontMatter,
    pub(super) policy: Policy,
    pub(super) milestones: Vec<Milestone>,
    pub(super) stages: Vec<Stage>,
    /// Whether products of inertia are entries, where a submission does not say.
    pub(super) entries: bool,
    /// Whether its meaning is declared.
    pub(super) is_declared: bool,
    sheets: Vec<Vec<Sentence>>,
    /// What its lines take letters for that axes have the names of, in sentences.
    axes: Vec<String>,
    /// How many rules each line uses that no line before it used.
    pub(super) rules: Vec<usize>,
}

impl Key {
    /// Reads a key and proves it.
    ///
    /// # Errors
    ///
    /// All reasons why it can't be used: a line that is refuted, a milestone that is not proved or that says nothing
    /// without a law, a sentence that is not understood, a label that no line has.
    pub fn read(name: &str, text: &str, format: Format) -> Result<Self, Vec<Refusal>> {
        let (mut document, troubles) = notation::read_declared(name, text, format, &[]);
        let errors = troubles.iter().filter(|t| t.severity == Severity::Error);
        let mut wrong: Vec<Refusal> = errors
            .map(|t| at(&document, t.primary.span, t.message.clone()))
            .collect();
        let (policy, unread) = Policy::read(&document.front_matter);
        wrong.extend(unread.into_iter().map(refusal));
        let declared = verify::declarations(&document, &[]);
        for unclear in &declared.misunderstood {
            wrong.push(at(&document, unclear.span, unclear.misread.message.clone()));
        }
        let placed = declared
            .declarations
            .iter()
            .filter(|d| is_placed(&d.extent));
        wrong.extend(placed.map(|said| {
            refusal(format!(
                "\"{}\" speaks of lines of this file; say it of the whole document, or of a section",
                said.text
            ))
        }));
        let report = match declared.is_empty() {
            true => verify::check(&document),
            false => verify::check_declared(&document, &declared),
        };
        wrong.extend(of_report(&document, &report));
        let axes = named_axes(&document, &declared, &report);
        let mut front = std::mem::take(&mut document.front_matter);
        front.other.clear();
        let mut key = Self {
            name: name.to_owned(),
            is_declared: !declared.is_empty(),
            entries: front.products.as_deref() == Some("entries"),
            sheets: vec![std::mem::take(&mut front.sentences)],
            settings: front,
            lines: report.findings.iter().map(|finding| finding.span).collect(),
            milestones: vec![],
            stages: vec![],
            policy,
            document,
            axes,
            rules: new_rules(&report.findings),
        };
        wrong.extend(key.find_milestones(&report));
        if wrong.is_empty() {
            key.withhold();
            wrong.extend(key.lay_routes());
        }
        if wrong.is_empty() {
            Ok(key)
        } else {
            Err(wrong)
        }
    }

    /// The most marks that can be had.
    pub fn max(&self) -> Marks {
        self.milestones.iter().map(|m| m.max).sum()
    }

    /// The labels of the milestones with their marks.
    pub fn milestones(&self) -> impl Iterator<Item = (&str, Marks)> {
        self.milestones.iter().map(|m| (m.label.as_str(), m.max))
    }

    /// The lines that carry marks, by label or by a comment beside them, each with the stage that its place gives it.
    fn find_milestones(&mut self, report: &Report) -> Vec<Refusal> {
        let mut wrong = vec![];
        let groups = groups(&self.document, &report.findings);
        let mut marks: Vec<(Vec<usize>, String, Marks)> = vec![];
        for (label, worth) in &self.policy.marks {
            match groups.iter().find(|group| group.labels.contains(label)) {
                Some(group) => marks.push((group.lines.clone(), label.clone(), *worth)),
                None => wrong.push(refusal(format!("no line has the label {label}"))),
            }
        }
        for group in &groups {
            let Some(worth) = &group.marks else { continue };
            let first = group.lines.first().map(|&line| &report.findings[line]);
            let name = first.map_or(String::new(), |f| format!("line {}", f.source_line));
            let label = group.labels.first().cloned().unwrap_or(name);
            match worth.parse().ok().and_then(Marks::new) {
                Some(worth) => marks.push((group.lines.clone(), label, worth)),
                None => wrong.push(refusal(format!("`marks: {worth}` is no number of marks"))),
            }
        }
        marks.sort_by_key(|(lines, _, _)| lines.first().copied());
        if marks.is_empty() && wrong.is_empty() {
            wrong.push(refusal(
                "no line carries marks; write marks: {\"(1)\": 2} into the front matter".to_owned(),
            ));
        }
        for label in &self.policy.shown {
            if !marks.iter().any(|(_, known, _)| known == label) {
                wrong.push(refusal(format!(
                    "`shown` names {label}, which carries no marks"
                )));
            }
        }
        for (lines, label, max) in marks {
            if self
                .milestones
                .iter()
                .any(|m| m.label == label || m.lines == lines)
            {
                wrong.push(refusal(format!("{label} is given marks twice")));
                continue;
            }
            for &line in &lines {
                wrong.extend(not_proved(&report.findings[line], &label));
            }
            let stage = self.stage_of(report, lines.first().copied().unwrap_or(0));
            let shown = self.policy.shown.contains(&label);
            self.milestones.push(Milestone {
                label,
                max,
                lines,
                stage,
                shown,
            });
        }
        wrong
    }

    /// The stage of a line: the same as that of the last milestone, unless something was assumed in between.
    fn stage_of(&mut self, report: &Report, line: usize) -> usize {
        let before = report.findings.iter().take(line);
        let accepted = before.filter(|f| f.verdict == Verdict::Accepted);
        let (assumed, defined): (Vec<&Finding>, Vec<&Finding>) =
            accepted.partition(|f| matches!(f.role, Role::Assume | Role::Given));
        let sentences: Vec<Sentence> = assumed
            .iter()
            .map(|finding| said(&self.document, finding))
            .collect();
        if let Some(known) = self
            .sheets
            .iter()
            .skip(1)
            .position(|sheet| *sheet == sentences)
        {
            return known;
        }
        let mut given: Vec<Span> = assumed.iter().chain(&defined).map(|f| f.span).collect();
        given.sort_unstable();
        self.sheets.push(sentences);
        let stage = self.stages.len();
        let meaning = [false, true]
            .map(|entries| self.meaning_without(&Withheld::default(), stage, entries, &[]));
        self.stages.push(Stage {
            meaning,
            given,
            routes: vec![],
            withheld: Withheld::default(),
            judged_as: None,
        });
        stage
    }

    /// What is declared of a submission at a stage, with more sentences.
    pub(super) fn meaning(&self, stage: usize, entries: bool, more: &[String]) -> Meaning {
        let own = &self.stages[stage];
        let given = own.judged_as.unwrap_or(stage);
        self.meaning_without(&own.withheld, given, entries, more)
    }

    fn meaning_without(
        &self,
        withheld: &Withheld,
        stage: usize,
        entries: bool,
        more: &[String],
    ) -> Meaning {
        let (mut bare, _) = notation::read("", "", Format::Markdown);
        if !self.is_declared {
            return Meaning::new(Declared::default(), bare, withheld);
        }
        bare.macros = self.document.macros.clone();
        bare.front_matter = FrontMatter {
            products: entries.then(|| "entries".to_owned()),
            ..FrontMatter::default()
        };
        let mut sheets = vec![Sheet {
            source: self.document.source.clone(),
            sentences: self.sheets[0].clone(),
        }];
        let assumed = self.sheets[stage + 1].iter().map(|said| said.text.clone());
        sheets.push(sheet(self.axes.iter().cloned().chain(assumed)));
        sheets.push(sheet(more.iter().cloned()));
        Meaning::new(verify::declarations(&bare, &sheets), bare, withheld)
    }

    /// The key as it is held against others, with the lines that are given.
    pub(super) fn sheet<'a>(&'a self, given: &'a [Span]) -> matching::Sheet<'a, 'a> {
        matching::Sheet {
            document: &self.document,
            lines: &self.lines,
            given,
            written: None,
            entries: self.entries,
        }
    }

    /// The lines that each line follows from without a law; and which milestones can't be told from others.
    fn lay_routes(&mut self) -> Vec<Refusal> {
        let mut wrong = vec![];
        for stage in 0..self.stages.len() {
            let meaning = &self.stages[stage].meaning[usize::from(self.entries)];
            for unclear in &meaning.declared().misunderstood {
                wrong.push(refusal(format!(
                    "an assumption can't be declared: {}",
                    unclear.misread.message
                )));
            }
            let given = &self.stages[stage].given;
            let mut board = Board::new(meaning, self.sheet(given), &[]);
            let last = self
                .milestones
                .iter()
                .filter(|m| m.stage == stage)
                .flat_map(|m| &m.lines)
                .max();
            let last = last.map_or(0, |&last| last + 1).min(board.key.len());
            let routes = (0..last).map(|line| route(&mut board, line)).collect();
            for milestone in self.milestones.iter().filter(|m| m.stage == stage) {
                wrong.extend(not_told_apart(&self.document, &board, milestone));
            }
            self.stages[stage].routes = routes;
        }
        wrong
    }
}

/// A line of a key as a sentence that declares it.
fn said(document: &Document, finding: &Finding) -> Sentence {
    let source = document.source.slice(finding.span).replace('\n', " ");
    let source = source.trim().trim_end_matches(['.', ',', ';']).to_owned();
    Sentence {
        text: format!("${source}$."),
        span: Span::default(),
    }
}

/// Sentences on a sheet of their own.
pub(super) fn sheet(sentences: impl Iterator<Item = String>) -> Sheet {
    let texts: Vec<String> = sentences.collect();
    let mut at = 0;
    let sentences = texts.iter().map(|text| {
        let span = Span::new(at, at + text.len());
        at += text.len() + 1;
        Sentence {
            text: text.clone(),
            span,
        }
    });
    Sheet {
        sentences: sentences.collect(),
        source: Source::new("grading", texts.join("\n")),
    }
}

/// Whether a sentence speaks of places of one file.
fn is_placed(extent: &Extent) -> bool {
    match extent {
        Extent::Document | Extent::Section(_) => false,
        Extent::Both(a, b) => is_placed(a) || is_placed(b),
        _ => true,
    }
}

/// What a check says against a key.
fn of_report(document: &Document, report: &Report) -> Vec<Refusal> {
    let refuted = report
        .findings
        .iter()
        .filter(|f| f.verdict == Verdict::Refuted);
    let reason = |f: &Finding| f.reason.clone().unwrap_or_default();
    let refuted = refuted.map(|f| at(document, f.span, format!("is refuted: {}", reason(f))));
    let unused = report.unused.iter();
    let unused = unused.map(|said| {
        refusal(format!(
            "nothing was made of the sentence \"{}\"",
            said.sentence
        ))
    });
    let questions = report.questions.iter().map(|question| Refusal {
        cell: question.cell,
        source_line: Some(question.source_line),
        message: format!("a question is open: {}", question.text),
    });
    refuted.chain(unused).chain(questions).collect()
}

fn not_proved(finding: &Finding, label: &str) -> Option<Refusal> {
    let proved =
        matches!(finding.verdict, Verdict::Proved(_)) || finding.verdict == Verdict::Refuted;
    let reason = finding.reason.as_deref().unwrap_or("it is taken as given");
    (!proved).then(|| Refusal {
        cell: finding.cell,
        source_line: Some(finding.source_line),
        message: format!("the milestone {label} is not proved: {reason}"),
    })
}

/// Why a milestone can't be looked for: it is not worked out, or true by the notation alone.
fn not_told_apart(document: &Document, board: &Board<'_>, milestone: &Milestone) -> Vec<Refusal> {
    let lines = milestone.lines.iter();
    let wrong = lines.filter_map(|&line| {
        let entry = board.key.get(line)?;
        let message = match &entry.parts {
            None => "is no equation that can be looked for",
            Some(parts) if parts.iter().all(|part| part.residual.is_zero()) => {
                "holds by what is declared alone, so that any line would reach it; give marks to another line"
            }
            Some(_) => return None,
        };
        Some(at(
            document,
            entry.span,
            format!("the milestone {} {message}", milestone.label),
        ))
    });
    wrong.collect()
}
