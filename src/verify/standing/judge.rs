//! Goes through a document from top to bottom and judges each line by the facts.

use crate::algebra::{Fraction, Proof};
use crate::notation::ast::Line;
use crate::notation::document::{Document, Format, Formula, Headings, Item, Row};
use crate::recent::Digest;
use crate::source::{self, Span};
use crate::verify::Role;
use crate::verify::facts::Source;
use crate::verify::facts::premises::Facts;
use crate::verify::facts::small::Small;
use crate::verify::reading::Reading;
use crate::verify::standing::chains::{Chain, Link, head_of, known_tree, may_define};
use crate::verify::standing::hold::Held;
use crate::verify::standing::memory::Wording;
use crate::verify::standing::parts::Part;
use crate::verify::standing::prepared::Prepared;
use crate::verify::standing::recalled::Recalled;
use crate::verify::standing::roles::{Purpose, RELATION};
use crate::verify::standing::shown::Shown;
use crate::verify::standing::verdicts::{Answer, Standing, answer};
use crate::verify::standing::written::{
    ends_with_full_stop, has_open_brackets, names_an_instant, without_number, written_symbols,
};
use crate::verify::term::known::Known;
use crate::verify::term::letters::At;
use std::collections::BTreeMap;
use std::sync::Arc;

/// What is said of a line.
#[derive(Clone, Debug)]
pub(crate) struct Judged {
    pub(crate) span: Span,
    /// The side that its links begin with; a row that goes on has it from the rows before.
    pub(crate) head: Span,
    pub(crate) at: At,
    pub(crate) role: Role,
    pub(crate) answer: Answer,
    pub(crate) proof: Option<Proof>,
    pub(crate) reason: Option<String>,
    /// Letters of which nothing is told.
    pub(crate) unknown: Vec<String>,
    /// The numbers in which it fails.
    pub(crate) shown: Option<Arc<Shown>>,
    /// The sides in which it fails, component by component.
    pub(crate) sides: Arc<[(Fraction, Fraction)]>,
}

/// A line that waits for letters.
struct Waiting {
    /// Its place among the lines that are judged.
    place: usize,
    line: Line,
    links: Vec<Link<'static>>,
    purpose: Purpose,
    /// Whether it was looked at again already.
    second_time: bool,
}

/// What is written, besides the line that is looked at.
#[derive(Default)]
pub(super) struct Written {
    /// Up to where sums run over an index, as the document writes it first.
    pub(super) bounds: BTreeMap<String, String>,
    /// The text of a line that is tried and does not stand in the document.
    pub(super) trial: Option<source::Source>,
    /// What the remainders on the line say to be small.
    pub(super) small: Small,
}

/// The words before a line.
#[derive(Default)]
pub(super) struct Words {
    /// The sentence so far.
    pub(super) sentence: String,
    pub(super) headings: Headings,
}

/// A document under way.
pub(crate) struct Judge<'a> {
    pub(crate) document: &'a Document,
    pub(crate) reading: Reading,
    pub(crate) facts: Facts,
    /// What was found out of letters.
    pub(crate) known: Known,
    pub(super) written: Written,
    pub(super) chain: Chain,
    pub(super) at: At,
    pub(super) words: Words,
    pub(crate) judged: Vec<Judged>,
    /// The accepted lines that are in force.
    pub(super) settled_taken: Vec<usize>,
    pub(super) again: Again,
    /// The part of the document whose lines are judged; of others only the letters that they define are taken.
    pub(crate) part: Part,
}

/// Lines that are looked at again, and links that others had before.
#[derive(Default)]
pub(super) struct Again {
    /// Those of this paragraph and of the one before it that wait.
    waiting: Vec<Waiting>,
    /// The accepted ones that define letters.
    pub(super) defining: Vec<(Source, Vec<Link<'static>>)>,
    /// Lines that are taken as given and of which nothing was made.
    pub(super) not_taken_in: Vec<Source>,
    /// What links came to in other documents; none once a line of this one was taken into the facts.
    pub(super) recalled: Option<Recalled>,
    /// What the link that is looked at was found to be worth by its sides, and how that is looked for.
    pub(super) weighed: Option<(Wording, Held)>,
    /// What the document writes, as it is looked for.
    pub(super) writing: Option<Digest>,
    /// What the link that is looked at next is looked for by, where that is known.
    pub(super) tree: Option<Digest>,
}

impl<'a> Judge<'a> {
    /// For a part of a document; the variables of the model are numbered from one on.
    pub(crate) fn new(document: &'a Document, part: Part, first: usize) -> Self {
        let prepared = Prepared::new(&part.declarations, written_symbols(document), first);
        Self::over(document, part, prepared)
    }

    /// For a part of a document that is read so.
    pub(crate) fn over(document: &'a Document, part: Part, prepared: Prepared) -> Self {
        let mut reading = prepared.reading;
        let bounds = reading.letters.written.bounds().clone();
        let recalled = prepared.links.map(|links| links.used_by(&mut reading));
        Self {
            document,
            reading,
            facts: prepared.facts,
            known: prepared.known,
            written: Written {
                bounds,
                trial: None,
                small: Small::default(),
            },
            chain: Chain::told_by(&part.declarations, document),
            at: At::default(),
            words: Words::default(),
            judged: vec![],
            settled_taken: vec![],
            again: Again {
                recalled,
                ..Again::default()
            },
            part,
        }
    }

    /// Judges every line.
    pub(crate) fn run(&mut self) {
        let document = self.document;
        for item in &document.items {
            match item {
                Item::Heading { level, text, .. } => {
                    self.words.headings.enter(*level, text);
                    self.at.sections = self.words.headings.texts();
                    self.words.sentence.clear();
                }
                Item::Prose { text, .. } => self.hear(text),
                Item::Break => {
                    self.look_again();
                    self.words.sentence.push('\n');
                }
                Item::Formula(formula) => self.formula(formula),
                Item::Comment { .. } => {}
            }
        }
        self.look_again();
        let part = &self.part;
        self.judged.retain(|judged| part.has(&judged.at));
    }

    /// Words go on a sentence, or begin the next one.
    fn hear(&mut self, text: &str) {
        // What stands there already has no end.
        let before = self.words.sentence.len();
        self.words.sentence.push_str(text);
        let mut ends = text.rmatch_indices(['.', '!', '?']);
        let end = ends.find(|(at, _)| {
            let rest = &text[at + 1..];
            rest.starts_with([' ', '\n']) || rest.is_empty()
        });
        if let Some((at, _)) = end {
            let rest = self.words.sentence.split_off(before + at + 1);
            self.words.sentence = rest;
        }
        let excess = self.words.sentence.len().saturating_sub(1_000);
        if let Some((at, _)) = self
            .words
            .sentence
            .char_indices()
            .find(|(at, _)| *at >= excess)
        {
            self.words.sentence.drain(..at);
        }
    }

    fn formula(&mut self, formula: &Formula) {
        if let (true, [Row::Expression(head), _, ..]) = (formula.display, formula.rows.as_slice()) {
            self.chain.begin(head);
        }
        for row in &formula.rows {
            match row {
                Row::Line(line) if !formula.display && names_an_instant(line) => {}
                Row::Line(line) => {
                    let named = !formula.display && self.is_only_named(line);
                    self.line(line, formula.display, named);
                }
                Row::Expression(_) => self.words.sentence.push_str(" ⟨⟩ "),
                Row::Unreadable { span, .. } => self.note_unreadable(*span),
            }
        }
        self.words.sentence.extend([" ", RELATION, " "]);
        // A full stop in a display ends the sentence.
        let written = self.document.source.slice(formula.span);
        if formula.display && ends_with_full_stop(written) {
            self.words.sentence.clear();
        }
    }

    /// Judges a line; one that is only named has no verdict but that it is proved.
    fn line(&mut self, line: &Line, display: bool, named: bool) {
        let line = &*without_number(line);
        let place = self.document.place_of_row(line.span.start);
        (self.at.cell, self.at.line) = (place.cell, place.line);
        let links = self.links_of(line);
        let cut = self.document.format == Format::Text
            && has_open_brackets(self.document.source.slice(line.span));
        let elsewhere = self.passes_over(&links);
        if self.reading.left_out(&self.at) || links.is_empty() || cut || elsewhere {
            return;
        }
        self.take_premises();
        self.enter_space();
        self.keep_from_instants();
        self.take_jacobians();
        let held = self.hold_line(line, &links);
        let purpose = self.unless_it_relates(self.purpose_of(line, &links, display), &held);
        if named && held.iter().any(|h| h.standing != Standing::Entailed) {
            return;
        }
        let waits = held
            .iter()
            .any(|h| !h.unknown.is_empty() && h.standing != Standing::Settles);
        let unknown = held.iter().any(|h| !h.unknown.is_empty());
        let defines = held.iter().any(|h| h.standing == Standing::Settles);
        let before = self.judged.len();
        self.conclude(line, head_of(&links), purpose, held);
        let Some(answer) = self.judged.get(before).map(|judged| judged.answer) else {
            return;
        };
        if defines && answer == Answer::Accepted {
            let links = links.iter().cloned().map(Link::into_owned);
            self.again.defining.push((self.source(), links.collect()));
        }
        if waits && answer != Answer::Proved || unknown && answer == Answer::Undecided {
            self.again.waiting.push(Waiting {
                place: before,
                line: line.clone(),
                links: links.into_iter().map(Link::into_owned).collect(),
                purpose,
                second_time: false,
            });
        }
    }

    /// In a space of another number of dimensions every letter is another variable, and is defined there anew.
    pub(super) fn enter_space(&mut self) {
        let dimensions = self.reading.letters.dimensions_at(&self.at);
        if dimensions == self.reading.system.dimensions() {
            return;
        }
        self.known = match dimensions {
            3 => Known::of(self.reading.shapes.clone()),
            _ => Known::default(),
        };
        for (source, links) in self.again.defining.clone() {
            for link in &links {
                let held = self.hold(link);
                if held.settles.is_some() {
                    self.settle(&held, &source, Role::Define);
                }
            }
        }
    }

    /// What the links of a line are worth, and its braces that do not hold.
    fn hold_line(&mut self, line: &Line, links: &[Link<'_>]) -> Vec<Held> {
        self.written.small = self.reading.small_by_remainders(&line.sides, &self.at);
        self.again.tree = known_tree(&self.reading.letters.written, line, links);
        let mut held: Vec<Held> = links.iter().map(|link| self.hold(link)).collect();
        held.extend(self.failing_braces(line));
        held
    }

    /// What is small on the line that is looked at.
    pub(super) fn small_here(&self) -> Small {
        self.reading.small_at(&self.at).and(&self.written.small)
    }

    /// Looks once more at lines that waited for what later lines of their paragraph, or of the next, define.
    fn look_again(&mut self) {
        for mut waiting in std::mem::take(&mut self.again.waiting) {
            let Waiting {
                place,
                line,
                links,
                purpose,
                ..
            } = &waiting;
            let (place, purpose) = (*place, *purpose);
            let at = std::mem::replace(&mut self.at, self.judged[place].at.clone());
            // What a line says for itself is no premise of it.
            let own = self.source();
            self.take_premises_but(Some(&own));
            self.enter_space();
            self.keep_from_instants();
            self.take_jacobians();
            let held = self.hold_line(line, links);
            // What would only be a definition may be one by a later line.
            let told = |h: &Held| match h.standing {
                Standing::Entailed => true,
                Standing::Settles => waiting.second_time || h.unknown.is_empty(),
                Standing::Denied => {
                    h.doubt.is_none() && !may_define(links, &self.reading.letters, &self.at)
                }
                _ => h.unknown.is_empty(),
            };
            if held.iter().all(told) {
                let end = self.judged.len();
                self.conclude(line, head_of(links), purpose, held);
                if let Some(last) = self.judged.get(end).cloned() {
                    self.judged.truncate(end);
                    self.judged[place] = last;
                }
            } else if !waiting.second_time {
                waiting.second_time = true;
                self.again.waiting.push(waiting);
            }
            self.at = at;
        }
    }

    /// The line that is looked at, as one who says that something holds.
    pub(super) fn source(&self) -> Source {
        Source::Line(self.at.cell, self.at.line)
    }

    /// One verdict from what the links came to: the worst of them.
    fn conclude(&mut self, line: &Line, head: Span, purpose: Purpose, held: Vec<Held>) {
        let unheard = !purpose.derived && self.unused_of(&line.sides).is_some();
        let derived = purpose.derived || unheard;
        // Words alone make no assumption of what an unheard sentence may tell of.
        let assumed = matches!(purpose.role, Role::Assume | Role::Given);
        let doubtful = purpose.doubtful || unheard && assumed && !purpose.declared;
        let denied = held.iter().any(|h| h.standing == Standing::Denied);
        let chooses = denied && self.chooses_direction(line);
        let standing = |h: &Held| match (h.standing, purpose.role) {
            // What an author declares to be a definition is assumed: it may fix what sentences leave free.
            (Standing::Denied | Standing::Free, Role::Define)
                if purpose.declared && !h.sides.is_empty() =>
            {
                self.assumed_definition(line, h)
            }
            (Standing::Denied, Role::Claim | Role::Define) if chooses => Standing::Settles,
            (Standing::Denied, Role::Claim | Role::Define) if h.doubt.is_some() => Standing::Open,
            (Standing::Denied | Standing::Free, _) if doubtful => Standing::Open,
            (Standing::Settles, _) if self.defines_by_another_line(h) => Standing::Open,
            // Words alone make no definition of a relation in which no new letter stands alone on a side.
            (Standing::Free, Role::Define) if !purpose.declared && (!h.alone || h.restricts) => {
                Standing::Open
            }
            (standing, _) => standing,
        };
        let answers: Vec<Answer> = held
            .iter()
            .map(|h| answer(purpose.role, derived, standing(h)))
            .collect();
        let Some(worst) = answers.iter().copied().max() else {
            return;
        };
        let mut verdict = worst;
        if self.waits_for_sentence(line, purpose, &held) || self.waits_for_jacobian(&held) {
            verdict = Answer::Undecided;
        } else if worst == Answer::Accepted {
            for held in &held {
                verdict = verdict.max(self.settle(held, &self.source(), purpose.role));
            }
        }
        self.note_if_not_taken_in(line, purpose, verdict, &held);
        let proof = proof_of_all(&held);
        let place = answers.iter().position(|a| *a == worst).unwrap_or(0);
        let chosen = held.into_iter().nth(place);
        let Some(chosen) = chosen else { return };
        self.judged.push(Judged {
            span: line.span,
            head,
            at: self.at.clone(),
            role: purpose.role,
            answer: verdict,
            proof: proof.filter(|_| verdict == Answer::Proved),
            reason: chosen.doubt.or(chosen.reason),
            unknown: chosen.unknown,
            shown: chosen.shown,
            sides: chosen.sides,
        });
    }
}

/// The proof of all links.
fn proof_of_all(held: &[Held]) -> Option<Proof> {
    let mut proofs = held.iter().filter_map(|h| h.proof.as_ref());
    let first = proofs.next()?.clone();
    Some(proofs.fold(first, |all, next| all.and(next)))
}
