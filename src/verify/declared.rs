//! Checks a document whose meaning is declared: each line is judged by the facts, and what is not known is asked.

use crate::algebra::{Fraction, Proof, Variable};
use crate::notation::ast::{Kind, Line, Node};
use crate::notation::document::{Document, Headings, Item, Row};
use crate::notation::print::latex;
use crate::source::Span;
use crate::verify::correction::search::corrections;
use crate::verify::declarations::Declared;
use crate::verify::declared::own::OwnLetters;
use crate::verify::facts::proof::uses;
use crate::verify::language::statement::{Declaration, Statement, Term};
use crate::verify::reading::Reading;
use crate::verify::standing::judge::{Judge, Judged};
use crate::verify::standing::shown::Shown;
use crate::verify::standing::verdicts::Answer;
use crate::verify::term::letters::At;
use crate::verify::verdict::{
    Convention, Counterexample, Diagnosis, Finding, Passed, Question, Report, Role, Verdict,
};
use std::collections::{BTreeMap, HashMap};

mod own;

/// A residual of more terms than this is not shown.
const LONGEST_RESIDUAL: usize = 40;

/// No letter is longer than this.
const LONGEST_LETTER: usize = 80;

/// Why a refuted line is false, where nothing else is said.
const DIFFER: &str = "the sides differ";

/// Checks every line of a document by what is declared of it.
pub fn check_declared(document: &Document, declared: &Declared) -> Report {
    let mut judge = Judge::new(document, &declared.declarations);
    judge.run();
    let corrections = corrections(&mut judge);
    report(document, declared, judge, &corrections)
}

/// The same without looking for what would put false lines right.
pub fn judge_declared(document: &Document, declared: &Declared) -> Report {
    let mut judge = Judge::new(document, &declared.declarations);
    judge.run();
    report(document, declared, judge, &HashMap::new())
}

fn report(
    document: &Document,
    declared: &Declared,
    mut judge: Judge<'_>,
    corrections: &HashMap<Span, Diagnosis>,
) -> Report {
    let declarations = declared.declarations.as_slice();
    let own = OwnLetters::of(document, &mut judge.reading);
    let each = judge.judged.iter();
    let mut rows = Rows {
        document,
        reading: &judge.reading,
        own: &own,
        judged: each.map(|judged| (judged.span, judged)).collect(),
        corrections,
        written: HashMap::new(),
        headings: Headings::default(),
        findings: vec![],
        passed: vec![],
    };
    document.items.iter().for_each(|item| rows.item(item));
    let questions = rows.questions();
    let (findings, passed) = (rows.findings, rows.passed);
    let atoms = &judge.reading.system.atoms;
    let variables = 0..atoms.len() as Variable;
    Report {
        path: document.source.name.clone(),
        products: convention(&judge.reading, declarations),
        questions,
        findings,
        from_prose: vec![],
        readings: vec![],
        passed,
        variables: variables.map(|v| own.anywhere(atoms, v)).collect(),
        meaning: declared.meaning(),
        unused: judge
            .reading
            .unused
            .iter()
            .filter(|unused| unused.understood)
            .map(|unused| unused.sentence.clone())
            .collect(),
    }
}

/// The convention for products of inertia, and whether a sentence says it.
fn convention(reading: &Reading, declarations: &[Declaration]) -> Convention {
    let products = |term: &Term| matches!(term, Term::Phrase(p) if p.head == "products of inertia");
    let says = |declaration: &Declaration| match &declaration.statement {
        Statement::Is { subjects, .. } => subjects.iter().any(products),
        _ => false,
    };
    Convention {
        name: match reading.letters.customs.integrals {
            true => "integrals",
            false => "entries",
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
    reading: &'a Reading,
    own: &'a OwnLetters,
    judged: BTreeMap<Span, &'a Judged>,
    /// What would put refuted lines right.
    corrections: &'a HashMap<Span, Diagnosis>,
    /// Letters as they are printed, and as the author writes them first.
    written: HashMap<String, String>,
    headings: Headings,
    findings: Vec<Finding>,
    passed: Vec<Passed>,
}

impl Rows<'_> {
    fn item(&mut self, item: &Item) {
        match item {
            Item::Heading { level, text, .. } => {
                self.headings.enter(*level, text);
            }
            Item::Formula(formula) => formula.rows.iter().for_each(|row| self.row(row)),
            Item::Prose { .. } | Item::Break | Item::Comment { .. } => {}
        }
    }

    fn row(&mut self, row: &Row) {
        let span = match row {
            Row::Line(line) => line.span,
            Row::Expression(node) => return self.pass(node.span, "expression"),
            Row::Unreadable { span, .. } => *span,
        };
        if self.reading.left_out(&self.at(span)) {
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

    fn line(&mut self, line: &Line) -> Finding {
        line.sides.iter().for_each(|side| self.note(side));
        let mut finding = Finding::undecided(self.document, Role::Claim, line.span);
        finding.label = line.labels.first().cloned();
        match self.judged.get(&line.span) {
            Some(judged) => self.tell(&mut finding, judged),
            None => finding.reason = Some("the line goes on from no other".to_owned()),
        }
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

    fn at(&self, span: Span) -> At {
        let place = self.document.place(span.start);
        At {
            cell: place.cell,
            line: place.line,
            sections: self.headings.texts(),
        }
    }

    fn pass(&mut self, span: Span, what: &'static str) {
        let place = self.document.place(span.start);
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
    fn tell(&self, finding: &mut Finding, judged: &Judged) {
        finding.role = judged.role;
        finding.verdict = match (judged.answer, &judged.proof) {
            (Answer::Proved, Some(proof)) => {
                finding.uses = uses(proof);
                finding.conditions = self.conditions(proof, judged, &finding.source);
                Verdict::Proved(proof.clone())
            }
            (Answer::Proved, None) | (Answer::Undecided, _) => {
                finding.reason = Some(self.open_because(judged));
                Verdict::Undecided
            }
            (Answer::Accepted, _) => Verdict::Accepted,
            (Answer::Refuted, _) => {
                finding.diagnosis = self.corrections.get(&judged.span).cloned();
                let reason = judged.reason.clone();
                finding.reason = Some(reason.unwrap_or_else(|| DIFFER.to_owned()));
                if let Some(shown) = &judged.shown {
                    finding.residual = self.residual(judged, shown, &finding.source);
                    finding.counterexample =
                        Some(self.counterexample(judged, shown, &finding.source));
                }
                Verdict::Refuted
            }
        };
    }

    fn conditions(&self, proof: &Proof, judged: &Judged, source: &str) -> Vec<String> {
        let mut found: Vec<String> = vec![];
        let arguments = proof.arguments().iter();
        for condition in arguments.flat_map(|argument| &argument.conditions) {
            let condition = Fraction::from(condition.clone());
            let text = format!("{} \\ne 0", self.printed(&condition, judged, source));
            if !found.contains(&text) {
                found.push(text);
            }
        }
        found
    }

    fn printed(&self, of: &Fraction, judged: &Judged, source: &str) -> String {
        let atoms = &self.reading.system.atoms;
        self.own.printed(of, atoms, &judged.at, source)
    }

    /// Left less right as written, or with what is known put in where that is too long.
    fn residual(&self, judged: &Judged, shown: &Shown, source: &str) -> Option<String> {
        let (left, right) = judged.sides.get(shown.place)?;
        let written = left.clone() - right.clone();
        let short = |f: &&Fraction| f.numerator().len() + f.denominator().len() <= LONGEST_RESIDUAL;
        let chosen = [&written, &shown.residual].into_iter().find(short);
        chosen.map(|chosen| self.printed(chosen, judged, source))
    }

    fn counterexample(&self, judged: &Judged, shown: &Shown, source: &str) -> Counterexample {
        let atoms = &self.reading.system.atoms;
        let letters = shown.letters.iter().map(|(letter, value)| {
            let name = self.own.on_line(atoms, *letter, &judged.at, source);
            let value = match self.own.is_opposite(atoms, *letter) {
                true => -value.clone(),
                false => value.clone(),
            };
            (name, value.to_string())
        });
        Counterexample {
            symbols: letters.collect(),
            component: component(judged.sides.len(), shown.place),
            left: shown.left.to_string(),
            right: shown.right.to_string(),
        }
    }
}

impl Rows<'_> {
    /// Why a line stays open.
    fn open_because(&self, judged: &Judged) -> String {
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
    fn as_written<'s>(&'s self, letter: &'s str) -> &'s str {
        self.written.get(letter).map_or(letter, String::as_str)
    }

    /// Notes how the author writes the letters of a tree.
    fn note(&mut self, node: &Node) {
        if let Kind::Symbol(_) = &node.kind {
            let written = self.document.source.slice(node.span).trim();
            if !written.is_empty() && written.len() <= LONGEST_LETTER {
                let printed = latex(node);
                self.written
                    .entry(printed)
                    .or_insert_with(|| written.to_owned());
            }
        }
        node.children().for_each(|child| self.note(child));
    }

    /// Each letter of which nothing is told and for which lines wait, that for which most wait first.
    fn questions(&self) -> Vec<Question> {
        let mut asked: Vec<Question> = vec![];
        let mut places: HashMap<&str, usize> = HashMap::new();
        let open = self.judged.values();
        for judged in open.filter(|judged| judged.answer == Answer::Undecided) {
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

/// The name of a component: its number in a vector, row and column in a matrix.
fn component(count: usize, place: usize) -> Option<String> {
    if count <= 1 {
        return None;
    }
    Some(match (3..=8).find(|size| size * size == count) {
        Some(size) => format!("row {}, column {}", place / size + 1, place % size + 1),
        None => (place + 1).to_string(),
    })
}
