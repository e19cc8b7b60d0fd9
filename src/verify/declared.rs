//! Checks a document whose meaning is declared: each line is judged by the facts, and what is not known is asked.

use crate::notation::ast::{Kind, Line, Node, Symbol};
use crate::notation::document::{Document, Headings, Item, Row};
use crate::notation::print::latex;
use crate::source::Span;
use crate::verify::declarations::Declared;
use crate::verify::declared::judgment::{Judgment, judgments};
use crate::verify::facts::proof::uses;
use crate::verify::language::messages::under_condition;
use crate::verify::language::rate_letters::with_rates;
use crate::verify::language::spoken_conditions::Lead;
use crate::verify::language::statement::{Declaration, Statement};
use crate::verify::language::wants::Wants;
use crate::verify::reading::names::are_products;
use crate::verify::reason;
use crate::verify::standing::judge::Judged;
use crate::verify::standing::verdicts::Answer;
use crate::verify::term::letters::At;
use crate::verify::verdict::{
    Convention, Finding, Passed, Question, Report, Role, Unused, Verdict,
};
use std::collections::{BTreeMap, HashMap, HashSet};

mod judgment;

pub(crate) use judgment::Shared;

/// Of more sentences that the model is too large for nothing is said.
const MOST_BEYOND: usize = 4;

/// No letter is longer than this.
const LONGEST_LETTER: usize = 80;

/// Why a refuted line is false, where nothing else is said.
const DIFFER: &str = "the sides differ";

/// Checks every line of a document by what is declared of it.
pub fn check_declared(document: &Document, declared: &Declared) -> Report {
    if let [first, others @ ..] = declared.cases.as_slice() {
        let others: Vec<Report> = others.iter().map(|c| judge_declared(document, c)).collect();
        let report = check_declared(document, first).in_all_cases(&others);
        return Report {
            meaning: declared.meaning(),
            ..report
        };
    }
    let document = &*with_rates(document, &declared.declarations);
    let mut judgments = judgments(document, &declared.declarations, std::iter::empty());
    judgments.iter_mut().for_each(Judgment::correct);
    whole_report(document, declared, &judgments)
}

/// The same without looking for what would put false lines right.
pub fn judge_declared(document: &Document, declared: &Declared) -> Report {
    let document = &*with_rates(document, &declared.declarations);
    let judgments = judgments(document, &declared.declarations, std::iter::empty());
    whole_report(document, declared, &judgments)
}

/// With what the sentences say, and what variables stand for.
fn whole_report(document: &Document, declared: &Declared, judgments: &[Judgment<'_>]) -> Report {
    Report {
        variables: judgments.iter().flat_map(Judgment::variables).collect(),
        meaning: declared.meaning(),
        ..report(document, declared, judgments, Residuals::Shown)
    }
}

fn report(
    document: &Document,
    declared: &Declared,
    judgments: &[Judgment<'_>],
    residuals: Residuals,
) -> Report {
    let each = judgments.iter();
    let each = each.flat_map(|own| own.judge.judged.iter().map(move |judged| (own, judged)));
    let mut rows = Rows {
        document,
        judgments,
        residuals,
        judged: each
            .map(|(own, judged)| (judged.span, (own, judged)))
            .collect(),
        written: HashMap::new(),
        unwritten: vec![],
        headings: Headings::default(),
        lead: Lead::default(),
        findings: vec![],
        passed: vec![],
    };
    document.items.iter().for_each(|item| rows.item(item));
    let questions = rows.questions();
    let (findings, passed) = (rows.findings, rows.passed);
    Report {
        path: document.source.name.clone(),
        products: convention(judgments, &declared.declarations),
        questions,
        findings,
        from_prose: vec![],
        readings: vec![],
        passed,
        variables: vec![],
        meaning: vec![],
        unused: [under_no_heading(document, declared), unused(judgments)].concat(),
    }
}

/// Whether a report shows what is left of the differences of false lines: it takes a while to print, and who marks a class
/// has no use for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Residuals {
    Shown,
    LeftOut,
}

/// Sentences that the grammar understands and of which nothing was made.
fn unused(judgments: &[Judgment<'_>]) -> Vec<Unused> {
    let mut found: Vec<Unused> = vec![];
    let each = judgments.iter().flat_map(|own| &own.judge.reading.unused);
    // What one part of a document has no use for another may need.
    let in_each = |sentence: &str| {
        let mut all = judgments.iter().filter(|own| own.judge.part.says(sentence));
        all.all(|own| {
            let mut unused = own.judge.reading.unused.iter();
            unused.any(|u| u.sentence == sentence)
        })
    };
    // One with words that say something else with the rest of it was understood word by word.
    let heard = |sentence: &str| {
        let mut all = judgments.iter();
        all.any(|own| own.judge.part.hears(sentence))
    };
    let said = each.filter(|unused| unused.understood || heard(&unused.sentence));
    for unused in said.filter(|unused| in_each(&unused.sentence)) {
        let told = found.iter().filter(|known| known.beyond).count();
        let known = found.iter().any(|known| known.sentence == unused.sentence);
        if !known && (!unused.beyond || told < MOST_BEYOND) {
            found.push(Unused {
                sentence: unused.sentence.clone(),
                beyond: unused.beyond,
                wants: unused.wants.clone(),
            });
        }
    }
    found
}

/// Sentences about sections that the document does not have.
fn under_no_heading(document: &Document, declared: &Declared) -> Vec<Unused> {
    let headings = document.items.iter().filter_map(|item| match item {
        Item::Heading { text, .. } => Some(text.trim()),
        _ => None,
    });
    let headings: HashSet<&str> = headings.collect();
    let each = declared.declarations.iter();
    let missing = each.filter_map(|said| {
        let title = said
            .extent
            .section()
            .filter(|t| !headings.contains(t.trim()))?;
        Some(Unused {
            sentence: said.sentence().to_owned(),
            beyond: false,
            wants: Some(Wants::Heading(title.to_owned())),
        })
    });
    missing.collect()
}

/// The convention for products of inertia, and whether a sentence says it.
fn convention(judgments: &[Judgment<'_>], declarations: &[Declaration]) -> Convention {
    let says = |declaration: &Declaration| match &declaration.statement {
        Statement::Is { subjects, .. } => subjects.iter().any(are_products),
        _ => false,
    };
    Convention {
        name: match judgments.first() {
            Some(own) if !own.judge.reading.letters.customs.integrals => "entries",
            _ => "integrals",
        },
        decided_by: match declarations.iter().any(says) {
            true => "declared",
            false => "default",
        },
    }
}

/// Goes through the rows of a document and says of each what became of it.
struct Rows<'a> {
    document: &'a Document,
    judgments: &'a [Judgment<'a>],
    residuals: Residuals,
    judged: BTreeMap<Span, (&'a Judgment<'a>, &'a Judged)>,
    /// Letters as they are printed, and as the author writes them first.
    written: HashMap<String, String>,
    /// Sides whose letters are not among them yet.
    unwritten: Vec<&'a Node>,
    headings: Headings,
    lead: Lead,
    findings: Vec<Finding>,
    passed: Vec<Passed>,
}

impl<'a> Rows<'a> {
    fn item(&mut self, item: &'a Item) {
        match item {
            Item::Heading { level, text, .. } => {
                self.headings.enter(*level, text);
            }
            Item::Formula(formula) => formula.rows.iter().for_each(|row| self.row(row)),
            Item::Prose { .. } | Item::Break | Item::Comment { .. } => {}
        }
        self.lead.pass(item);
    }

    fn row(&mut self, row: &'a Row) {
        let span = match row {
            Row::Line(line) => line.span,
            Row::Expression(node) => return self.pass(node.span, "expression"),
            Row::Unreadable { span, .. } => *span,
        };
        let at = self.at(span);
        let left_out = |own: &Judgment<'_>| own.judge.reading.left_out(&at);
        if self.judgments.first().is_some_and(left_out) {
            return self.pass(span, "left out");
        }
        let finding = match row {
            Row::Line(line) => self.line(line),
            Row::Unreadable { message, help, .. } => {
                let mut finding = Finding::undecided(self.document, Role::Claim, span);
                finding.verdict = Verdict::Unreadable;
                finding.reason = Some(message.clone());
                finding.remarks.extend(help.clone());
                finding
            }
            Row::Expression(_) => return,
        };
        self.findings.push(finding);
    }

    fn line(&mut self, line: &'a Line) -> Finding {
        self.unwritten.extend(&line.sides);
        let mut finding = Finding::undecided(self.document, Role::Claim, line.span);
        finding.label = line.labels.first().cloned();
        match self.judged.get(&line.span).copied() {
            Some((own, judged)) => self.tell(&mut finding, own, judged),
            None if line.continues => {
                finding.reason = Some(reason::GOES_ON_FROM_NONE.to_owned());
            }
            None => finding.reason = Some("no words say that it holds".to_owned()),
        }
        self.doubt_under_condition(&mut finding);
        // A sentence may say what a writing means that is not read otherwise.
        if finding.verdict == Verdict::Undecided
            && let Some((message, place)) = line.sides.iter().find_map(error_in)
        {
            finding.verdict = Verdict::Unreadable;
            finding.reason = Some(message);
            finding.place = place;
        }
        finding
    }

    /// Leaves a false line open that holds under a condition of the text, of which the declarations don't speak.
    fn doubt_under_condition(&self, finding: &mut Finding) {
        if finding.verdict != Verdict::Refuted {
            return;
        }
        let Some(condition) = self.lead.condition() else {
            return;
        };
        let at = self.at(finding.span);
        let mut parts = self.judgments.iter().map(|own| &own.judge.part);
        if !parts.any(|part| part.speaks_of(&at)) {
            finding.leave_open(under_condition(condition));
        }
    }

    fn at(&self, span: Span) -> At {
        let place = self.document.place_of_row(span.start);
        At {
            cell: place.cell,
            line: place.line,
            sections: self.headings.texts(),
        }
    }

    fn pass(&mut self, span: Span, what: &'static str) {
        let place = self.document.place_of_row(span.start);
        self.passed.push(Passed {
            span,
            source_line: place.line,
            cell: place.cell,
            what,
        });
    }
}

/// What stands in a tree that could not be read.
fn error_in(node: &Node) -> Option<(String, Span)> {
    match &node.kind {
        Kind::Error(message) => Some((message.clone(), node.span)),
        _ => node.children().find_map(error_in),
    }
}

impl Rows<'_> {
    /// Says of a line what the judge said.
    fn tell(&mut self, finding: &mut Finding, own: &Judgment<'_>, judged: &Judged) {
        finding.role = judged.role;
        finding.verdict = match (judged.answer, &judged.proof) {
            (Answer::Proved, Some(proof)) => {
                finding.uses = uses(proof);
                finding.conditions = own.conditions(proof, judged, &finding.source);
                Verdict::Proved(proof.clone())
            }
            (Answer::Proved, None) | (Answer::Undecided, _) => {
                finding.reason = Some(self.open_because(judged));
                Verdict::Undecided
            }
            (Answer::Accepted, _) => Verdict::Accepted,
            (Answer::Refuted, _) => {
                finding.diagnosis = own.corrections.get(&judged.span).cloned();
                let reason = judged.reason.clone();
                finding.reason = Some(reason.unwrap_or_else(|| DIFFER.to_owned()));
                if let Some(shown) = &judged.shown {
                    if self.residuals == Residuals::Shown {
                        finding.residual = own.residual(judged, shown, &finding.source);
                    }
                    finding.counterexample =
                        Some(own.counterexample(judged, shown, &finding.source));
                }
                Verdict::Refuted
            }
        };
    }
}

impl Rows<'_> {
    /// Why a line stays open.
    fn open_because(&mut self, judged: &Judged) -> String {
        let unknown = judged.unknown.iter();
        let letters: Vec<String> = unknown
            .map(|l| format!("`{}`", self.as_written(l)))
            .collect();
        match (letters.split_last(), &judged.reason) {
            (None, Some(reason)) => reason.clone(),
            (None, None) => "no proof was found".to_owned(),
            (Some((last, [])), _) => format!("no sentence says what {last} is"),
            (Some((last, first)), _) => {
                format!("no sentence says what {} and {last} are", first.join(", "))
            }
        }
    }

    /// A letter as the author writes it first.
    fn as_written<'s>(&'s mut self, letter: &'s str) -> &'s str {
        let mut seen = HashSet::new();
        for side in std::mem::take(&mut self.unwritten) {
            self.note(side, &mut seen);
        }
        self.written.get(letter).map_or(letter, String::as_str)
    }

    /// Notes how the author writes the letters of a tree; those that were seen are printed as before, and the first counts.
    fn note<'n>(&mut self, node: &'n Node, seen: &mut HashSet<&'n Symbol>) {
        if let Kind::Symbol(symbol) = &node.kind {
            let written = self.document.source.slice(node.span).trim();
            if !written.is_empty() && written.len() <= LONGEST_LETTER && seen.insert(symbol) {
                let printed = latex(node);
                self.written
                    .entry(printed)
                    .or_insert_with(|| written.to_owned());
            }
        }
        let children = node.children();
        children.for_each(|child| self.note(child, seen));
    }

    /// Each letter of which nothing is told and for which lines wait, that for which most wait first.
    fn questions(&mut self) -> Vec<Question> {
        let mut asked: Vec<Question> = vec![];
        let mut places: HashMap<&str, usize> = HashMap::new();
        let open = self.judged.values().map(|(_, judged)| *judged);
        let open: Vec<&Judged> = open.filter(|j| j.answer == Answer::Undecided).collect();
        for judged in open {
            for letter in &judged.unknown {
                let at = *places.entry(letter).or_insert(asked.len());
                if at == asked.len() {
                    asked.push(Question {
                        text: format!("what is `{}`?", self.as_written(letter)),
                        cell: judged.at.cell,
                        source_line: judged.at.line,
                        answers: vec![],
                        lines: vec![],
                    });
                }
                asked[at].lines.push(judged.at.line);
            }
        }
        asked.sort_by_key(|question| std::cmp::Reverse(question.lines.len()));
        asked.iter_mut().for_each(|question| question.lines.dedup());
        asked
    }
}
