//! Unit vectors that a key writes by the names of axes: `\vec i` along the axis i, of which no sentence tells.
//!
//! A key is proved with that, so a submission means the same by it. Left untold, it could be another vector there, and no false
//! line with it would be refuted.

use crate::grade::key::sheet;
use crate::notation::ast::{Kind, Node, Style, Symbol};
use crate::notation::document::{Document, Row};
use crate::source::Span;
use crate::verify::language::statement::{Declaration, Extent, Formula, Statement, Term};
use crate::verify::language::{Lexicon, sentence};
use crate::verify::{self, Declared, Report};

/// The marks of a vector: an arrow or bold type, a hat, and both.
const MARKS: [(bool, bool); 3] = [(true, false), (false, true), (true, true)];

/// Sentences that say of marked letters that they are the axes of their names, if the key holds with them as without.
pub(super) fn named_axes(document: &Document, declared: &Declared, report: &Report) -> Vec<String> {
    let all = declared.declarations.iter();
    let told = all.filter(|said| {
        let axes = matches!(&said.statement, Statement::Is { what, .. } if what.head == "axes");
        axes && said.extent == Extent::Document
    });
    let sentences: Vec<String> = told
        .flat_map(|said| marked_axes(document, declared, said))
        .collect();
    if sentences.is_empty() {
        return sentences;
    }
    let more = verify::declarations(document, &[sheet(sentences.iter().cloned())]);
    let with = verify::judge_declared(document, &more);
    let holds = more.misunderstood.is_empty() && with.summary().proved >= report.summary().proved;
    if holds { sentences } else { vec![] }
}

/// "i, j, k are the axes of A" of the marked letters that stand in a document and in no sentence.
fn marked_axes(document: &Document, declared: &Declared, said: &Declaration) -> Vec<String> {
    let Statement::Is { subjects, what } = &said.statement else {
        return vec![];
    };
    let names: Option<Vec<&str>> = subjects.iter().map(name_of_axis).collect();
    let Some(names) = names.filter(|names| names.len() == 3) else {
        return vec![];
    };
    let marked = MARKS.map(|marks| names.iter().map(|name| letter(name, marks)).collect());
    let new = |letters: &Vec<Node>| {
        let stands = letters.iter().any(|letter| stands(document, letter));
        stands && !letters.iter().any(|letter| is_told(declared, letter))
    };
    let told = marked.into_iter().filter(new).map(|letters| {
        let subjects = letters
            .iter()
            .map(|l| Term::Formula(Formula::of(l)))
            .collect();
        let what = what.clone();
        sentence(
            &said.saying(Statement::Is { subjects, what }),
            Lexicon::shared(),
        )
    });
    told.collect()
}

/// The name of an axis that is a letter without marks and labels.
fn name_of_axis(subject: &Term) -> Option<&str> {
    let name = match subject {
        Term::Name(name) => name.as_str(),
        Term::Formula(formula) => formula.source.as_str(),
        _ => return None,
    };
    name.chars().all(char::is_alphanumeric).then_some(name)
}

fn letter(name: &str, (vector, hat): (bool, bool)) -> Node {
    let style = Style {
        vector,
        hat,
        ..Style::default()
    };
    let symbol = Symbol {
        name: name.to_owned(),
        style,
        ..Symbol::default()
    };
    Node {
        kind: Kind::Symbol(symbol),
        span: Span::default(),
    }
}

/// Whether a sentence speaks of a letter.
pub(super) fn is_told(declared: &Declared, letter: &Node) -> bool {
    let mut all = declared
        .declarations
        .iter()
        .flat_map(|said| said.statement.formulas());
    all.any(|formula| match &formula.row {
        Row::Expression(node) => has(node, letter),
        Row::Line(line) => line.sides.iter().any(|side| has(side, letter)),
        Row::Unreadable { .. } => false,
    })
}

/// Whether a letter stands in a formula of a document.
pub(super) fn stands(document: &Document, letter: &Node) -> bool {
    let mut lines = document.lines();
    lines.any(|line| line.sides.iter().any(|side| has(side, letter)))
}

fn has(node: &Node, letter: &Node) -> bool {
    node.kind == letter.kind || node.children().any(|child| has(child, letter))
}
