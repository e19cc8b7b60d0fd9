//! Unit vectors that a key writes by the names of axes: `\vec i` along the axis i, of which no sentence tells.
//!
//! A key is proved with that, so a submission means the same by it. Left untold, it could be another vector there, and no false
//! line with it would be refuted.

use crate::grade::key::sheet;
use crate::notation::ast::{Kind, Node, Style};
use crate::notation::document::{Document, Item, Row};
use crate::verify::language::statement::{Extent, Statement};
use crate::verify::{self, Declared, Report};

/// The marks of a vector, and the styles that they make.
const MARKS: [(&str, Style); 3] = [
    ("\\vec", marked(true, false)),
    ("\\hat", marked(false, true)),
    ("\\hat\\vec", marked(true, true)),
];

const fn marked(vector: bool, hat: bool) -> Style {
    Style {
        vector,
        hat,
        bar: false,
        tensor: false,
        calligraphic: false,
        tilde: false,
        upright: false,
        other: false,
    }
}

/// Sentences that say of marked letters that they are the axes of their names, if the key holds with them as without.
pub(super) fn named_axes(document: &Document, declared: &Declared, report: &Report) -> Vec<String> {
    let all = declared.declarations.iter();
    let told = all.filter(|said| {
        let axes = matches!(&said.statement, Statement::Is { what, .. } if what.head == "axes");
        axes && said.extent == Extent::Document
    });
    let sentences: Vec<String> = told
        .flat_map(|said| marked_axes(document, declared, said.sentence()))
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
fn marked_axes(document: &Document, declared: &Declared, sentence: &str) -> Vec<String> {
    let Some((names, of)) = sentence.split_once(" are the axes") else {
        return vec![];
    };
    let names = names.replace(" and ", ",");
    let names = names
        .split(',')
        .map(|name| name.trim_matches([' ', '$', '`']));
    let names: Vec<&str> = names.filter(|name| !name.is_empty()).collect();
    let plain = |name: &&str| name.chars().all(char::is_alphanumeric);
    if names.len() != 3 || !names.iter().all(plain) {
        return vec![];
    }
    let written = MARKS.iter().filter(|(mark, style)| {
        let told = |name: &&str| {
            let written = format!("{}{name}", mark.replace("\\hat\\vec", "\\hat{\\vec"));
            let bare = |text: &str| text.replace([' ', '{', '}'], "");
            let mut all = declared.declarations.iter();
            all.any(|said| bare(said.sentence()).contains(&bare(&written)))
        };
        names.iter().any(|name| stands(document, name, style)) && !names.iter().any(told)
    });
    let sentences = written.map(|(mark, _)| {
        let letters = names.iter().map(|name| match *mark {
            "\\hat\\vec" => format!("$\\hat{{\\vec {name}}}$"),
            mark => format!("${mark} {name}$"),
        });
        let letters: Vec<String> = letters.collect();
        format!("{} are the axes{of}", letters.join(", "))
    });
    sentences.collect()
}

/// Whether a letter stands in a formula with these marks alone.
fn stands(document: &Document, name: &str, style: &Style) -> bool {
    let lines = document.items.iter().filter_map(|item| match item {
        Item::Formula(formula) => Some(&formula.rows),
        _ => None,
    });
    let mut lines = lines.flatten().filter_map(|row| match row {
        Row::Line(line) => Some(line),
        _ => None,
    });
    lines.any(|line| line.sides.iter().any(|side| has(side, name, style)))
}

fn has(node: &Node, name: &str, style: &Style) -> bool {
    let own = matches!(&node.kind, Kind::Symbol(symbol) if symbol.name == name && symbol.style == *style && symbol.subscripts.is_empty());
    own || node.children().any(|child| has(child, name, style))
}
