//! Which work an answer in the key touches: a sentence that says what a letter is changes nothing where this letter does not
//! stand.
//!
//! Where it is in doubt all work is touched: marking anew costs time alone.

use crate::grade::key::{Key, sheet};
use crate::grade::paper::Work;
use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::{Document, Format, Item, Row, Sentence};
use crate::notation::{self};
use crate::verify;
use crate::verify::language::statement::{Declaration, Extent, Formula, Slot, Statement, Term};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// What a letter may be said to be without a word on how things move or what acts on them.
pub(in crate::grade) const QUANTITIES: [&str; 11] = [
    "angular velocity",
    "angular acceleration",
    "angular momentum",
    "momentum",
    "velocity",
    "acceleration",
    "inertia tensor",
    "moment of inertia",
    "kinetic energy",
    "mass",
    "component",
];

/// What a key says, kept beside the marks that were given by it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Told {
    /// Its text without the sentences that declare something.
    pub rest: String,
    /// These sentences.
    pub sentences: Vec<String>,
}

/// The letters of which one key tells and another does not, all else being the same.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    letters: BTreeSet<String>,
}

impl Key {
    /// What it says, to be compared with what it said before; `None` for a notebook, of which not all is text.
    pub fn told(&self) -> Option<Told> {
        let labels: Vec<&str> = self.milestones().map(|(label, _)| label).collect();
        let sentences = &self.sheets[0];
        (self.document.format != Format::Notebook).then(|| Told {
            rest: format!("{}\n{}", labels.join("\n"), rest(&self.document, sentences)),
            sentences: sentences.iter().map(|said| said.text.clone()).collect(),
        })
    }

    /// How this key differs from what it told before; `None` where any work may be touched.
    pub fn differs_from(&self, before: &Told) -> Option<Difference> {
        let now = self.told()?;
        if now.rest != before.rest || !self.document.macros.is_empty() {
            return None;
        }
        let [old, new] = [&before.sentences, &now.sentences];
        let both = [(declared(old)?, new), (declared(new)?, old)];
        let stays = |(declared, others): &(Vec<Clause>, &Vec<String>)| -> Vec<String> {
            let stays = declared.iter().filter(|said| others.contains(&said.text));
            stays.map(|said| said.meant.clone()).collect()
        };
        // What stays must say the same: a sentence may go on from the one before it.
        if stays(&both[0]) != stays(&both[1]) {
            return None;
        }
        let (mut letters, mut things) = (BTreeSet::new(), vec![]);
        for (declared, others) in &both {
            for said in declared.iter().filter(|said| !others.contains(&said.text)) {
                let (own, of) = told_of_letters(&said.declaration)?;
                letters.extend(own);
                things.extend(of);
            }
        }
        let stay: Vec<&String> = old.iter().filter(|text| new.contains(text)).collect();
        let in_key = letters_of(&self.document)?;
        let is_used = |letter: &String| {
            in_key.contains(letter) || stay.iter().any(|text| mentions(text, letter))
        };
        let is_known = |thing: &String| {
            letters.contains(thing) || stay.iter().any(|text| text.contains(thing.as_str()))
        };
        let apart = things.iter().all(is_known) && !letters.iter().any(is_used);
        apart.then_some(Difference { letters })
    }
}

/// What one sentence declares.
struct Clause {
    text: String,
    declaration: Declaration,
    /// In the words of the language.
    meant: String,
}

/// What sentences declare; `None` where one is not understood.
fn declared(sentences: &[String]) -> Option<Vec<Clause>> {
    let (bare, _) = notation::read("", "", Format::Markdown);
    let declared = verify::declarations(&bare, &[sheet(sentences.iter().cloned())]);
    let meaning = declared.meaning();
    if !declared.misunderstood.is_empty() || meaning.len() != declared.declarations.len() {
        return None;
    }
    let each = declared.declarations.into_iter().zip(meaning);
    let clauses = each.map(|(declaration, meant)| {
        Some(Clause {
            text: sentences.get(declaration.line.checked_sub(1)?)?.clone(),
            declaration,
            meant: meant.sentence,
        })
    });
    clauses.collect()
}

/// The letters of which a sentence says no more than what quantity they are, and the things whose quantity it is.
fn told_of_letters(said: &Declaration) -> Option<(Vec<String>, Vec<String>)> {
    let Statement::Is { subjects, what } = &said.statement else {
        return None;
    };
    let is_plain = said.extent == Extent::Document
        && QUANTITIES.contains(&what.head)
        && what.adjectives.is_empty();
    let letters = subjects.iter().map(letter);
    let things = what.slots.iter().map(|(slot, term)| match (slot, term) {
        (
            Slot::Of | Slot::About | Slot::RelativeTo | Slot::SeenFrom | Slot::On,
            Term::Name(name),
        ) => Some(name.clone()),
        (Slot::Of | Slot::About | Slot::RelativeTo | Slot::SeenFrom | Slot::On, term) => {
            letter(term)
        }
        _ => None,
    });
    let letters: Option<Vec<String>> = letters.collect();
    let things: Option<Vec<String>> = things.collect();
    is_plain.then_some((letters?, things?))
}

/// The letter of a formula that is one symbol.
fn letter(term: &Term) -> Option<String> {
    match term {
        Term::Formula(Formula {
            row:
                Row::Expression(Node {
                    kind: Kind::Symbol(symbol),
                    ..
                }),
            ..
        }) => Some(symbol.name.clone()),
        _ => None,
    }
}

/// The text of a document without the lines that have nothing but these sentences.
fn rest(document: &Document, sentences: &[Sentence]) -> String {
    let (mut rest, mut at) = (String::new(), 0);
    for line in document.source.text.split_inclusive('\n') {
        let begin = at;
        at += line.len();
        let in_sentence = |at: usize| {
            let mut spans = sentences.iter().map(|said| said.span.range());
            spans.any(|span| span.contains(&at))
        };
        let others = line.char_indices();
        let others = others.filter(|(offset, _)| !in_sentence(begin + offset));
        let others: String = others.map(|(_, c)| c).collect();
        let is_list = matches!(others.trim(), "-" | "- \"\"" | "- ''" | "% polhode:");
        if !is_list || others.len() == line.len() {
            rest.push_str(line);
        }
    }
    rest
}

/// Whether a letter may stand in a sentence.
fn mentions(text: &str, letter: &str) -> bool {
    if text.chars().any(|c| c.is_alphabetic() && !c.is_ascii()) {
        return true;
    }
    let mut parts = text.split(['$', '`']).enumerate();
    parts.any(|(at, part)| match at % 2 == 1 {
        true => stands_in_formula(part, letter),
        false => {
            // It may have an index.
            let mut words = part.split(|c: char| !c.is_ascii_alphabetic());
            words.any(|word| word.starts_with(letter) && word.len() <= letter.len() + 2)
        }
    })
}

/// Whether a letter may stand in a formula, where what touches may be several letters.
fn stands_in_formula(formula: &str, letter: &str) -> bool {
    let is_letter = |c: char| c.is_ascii_alphabetic();
    formula.split('\\').enumerate().any(|(at, part)| {
        let end = part.find(|c| !is_letter(c)).unwrap_or(part.len());
        let (command, others) = part.split_at(if at == 0 { 0 } else { end });
        command == letter || others.contains(letter)
    })
}

/// The letters and words of a document; `None` where not all of it is read.
fn letters_of(document: &Document) -> Option<BTreeSet<String>> {
    let mut found = BTreeSet::new();
    for item in &document.items {
        match item {
            Item::Prose { text, .. } | Item::Heading { text, .. } => words(text, &mut found),
            Item::Formula(formula) => {
                for row in &formula.rows {
                    match row {
                        Row::Line(line) => {
                            line.remarks.iter().for_each(|said| words(said, &mut found));
                            found.extend(line.ranges.iter().map(|(index, _)| index.clone()));
                            let mut sides = line.sides.iter();
                            sides.try_for_each(|side| collect(side, &mut found))?;
                        }
                        Row::Expression(node) => collect(node, &mut found)?,
                        Row::Unreadable { .. } => return None,
                    }
                }
            }
            Item::Break | Item::Comment { .. } => {}
        }
    }
    Some(found)
}

fn collect(node: &Node, found: &mut BTreeSet<String>) -> Option<()> {
    match &node.kind {
        Kind::Error(_) => return None,
        Kind::Symbol(symbol) => of_symbol(symbol, found),
        Kind::IndexedSum { index, .. } => of_symbol(index, found),
        Kind::InFrame(_, label)
        | Kind::TimeDerivative {
            frame: Some(label), ..
        } => {
            label_letters(&label.text, found);
        }
        _ => {}
    }
    let mut children = node.children();
    children.try_for_each(|child| collect(child, found))
}

fn of_symbol(symbol: &Symbol, found: &mut BTreeSet<String>) {
    found.insert(symbol.name.clone());
    let labels = symbol.subscripts.iter().chain(&symbol.superscripts);
    labels.for_each(|label| label_letters(label, found));
}

/// A label may be a word, or several letters side by side.
fn label_letters(label: &str, found: &mut BTreeSet<String>) {
    words(label, found);
    found.extend(
        label
            .chars()
            .filter(|c| c.is_alphabetic())
            .map(String::from),
    );
}

fn words(text: &str, found: &mut BTreeSet<String>) {
    let words = text.split(|c: char| !c.is_alphanumeric());
    found.extend(words.filter(|word| !word.is_empty()).map(str::to_owned));
}

impl Difference {
    /// Whether the marks of a work may be others by it.
    pub fn touches(&self, work: &Work) -> bool {
        !work.answers.is_empty()
            || work.texts.iter().any(|text| {
                let (document, _) = notation::read(&text.name, &text.text, text.format);
                let letters = letters_of(&document);
                letters.is_none_or(|own| !own.is_disjoint(&self.letters))
            })
    }
}
