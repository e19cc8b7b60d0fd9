//! Parts of a document that speak of systems of their own: a frame that turns otherwise in one section than in another, a
//! point that is placed anew.

use crate::notation::ast::Node;
use crate::notation::document::{Document, Headings, Item, Row};
use crate::verify::language::is_thing;
use crate::verify::language::statement::{Declaration, Extent, Slot, Statement, Term};
use crate::verify::reading::incline_read::tells_lie;
use crate::verify::reading::names::{EULER_ANGLES, UNIT_VECTOR, reach_of};
use crate::verify::reading::order::{exact_key, mentioned_letters};
use crate::verify::standing::chains::{Link, may_define};
use crate::verify::term::letters::{At, Letters, Reach};
use std::collections::BTreeSet;

/// A document with more systems than this is read as one that speaks of a single one.
const MOST_PARTS: usize = 12;

/// Verbs by which a sentence builds the system.
const VERBS: [&str; 5] = ["turn", "lie", "place", "roll", "consist"];

/// The lines for which just some of the sentences about things are in force, and what is declared there.
#[derive(Clone, Debug, Default)]
pub(crate) struct Part {
    pub(crate) declarations: Vec<Declaration>,
    /// Of each sentence about things of a part of the document: which part, and whether it is in force here.
    limits: Vec<(Reach, bool)>,
    /// The letters of sentences that are not in force here: no line elsewhere defines them.
    elsewhere: BTreeSet<String>,
}

impl Part {
    /// Whether a place belongs to it.
    pub(crate) fn has(&self, at: &At) -> bool {
        self.limits
            .iter()
            .all(|(reach, holds)| reach.covers(at, 0) == *holds)
    }

    /// Whether what holds at a place holds here as well: no sentence is in force there that is not in force here.
    pub(crate) fn is_case_of(&self, at: &At) -> bool {
        let mut limits = self.limits.iter();
        limits.all(|(reach, holds)| *holds || !reach.covers(at, 0))
    }

    /// Whether a sentence is in force in it.
    pub(crate) fn says(&self, sentence: &str) -> bool {
        let mut said = self.declarations.iter();
        said.any(|d| d.sentence() == sentence)
    }

    /// Whether a sentence is in force in it and has no part that is no sentence of the language.
    pub(crate) fn hears(&self, sentence: &str) -> bool {
        let own = self.declarations.iter();
        let mut own = own.filter(|d| d.sentence() == sentence).peekable();
        own.peek().is_some() && own.all(|d| !d.is_unread())
    }

    /// Whether a sentence is about a part of the document to which a place belongs.
    pub(crate) fn speaks_of(&self, at: &At) -> bool {
        let reaches = self.declarations.iter().map(|d| reach_of(&d.extent));
        let mut parts = reaches.filter(|reach| *reach != Reach::All);
        parts.any(|reach| reach.covers(at, 0))
    }

    /// A document that speaks of one system.
    pub(crate) fn whole(declarations: &[Declaration]) -> Self {
        Self {
            declarations: declarations.to_vec(),
            limits: vec![],
            elsewhere: BTreeSet::new(),
        }
    }

    /// Whether a line stands in another part, and defines no letter for this one: what a sentence tells there it tells of
    /// that part.
    pub(crate) fn passes_over(&self, links: &[Link<'_>], letters: &Letters, at: &At) -> bool {
        let told = |side: &Node| self.elsewhere.contains(&exact_key(side));
        let mut sides = links.iter().flat_map(|link| link.sides());
        !self.has(at) && (!may_define(links, letters, at) || sides.any(told))
    }
}

/// Whether sentences speak of one system in all of a document.
pub(crate) fn is_of_one_system(declarations: &[Declaration]) -> bool {
    !declarations.iter().any(is_limited)
}

/// The parts of a document, in the order in which they begin.
pub(crate) fn parts(document: &Document, declarations: &[Declaration]) -> Vec<Part> {
    let limited: Vec<Reach> = declarations
        .iter()
        .filter(|d| is_limited(d))
        .map(|d| reach_of(&d.extent))
        .collect();
    if limited.is_empty() {
        return vec![Part::whole(declarations)];
    }
    let mut found: Vec<Vec<bool>> = vec![];
    for at in places(document) {
        let holds: Vec<bool> = limited.iter().map(|reach| reach.covers(&at, 0)).collect();
        if !found.contains(&holds) {
            found.push(holds);
        }
    }
    match found.len() {
        0 | MOST_PARTS.. => vec![Part::whole(declarations)],
        _ => found
            .into_iter()
            .map(|holds| part(declarations, &limited, holds))
            .collect(),
    }
}

/// In a part, what is declared of it alone is declared of all there is, and of what is told more widely it is told anew.
fn part(declarations: &[Declaration], limited: &[Reach], holds: Vec<bool>) -> Part {
    let limits = declarations.iter().filter(|d| is_limited(d)).zip(&holds);
    let (here, others): (Vec<_>, Vec<_>) = limits.partition(|(_, holds)| **holds);
    let told_anew = |wide: &Declaration| {
        let mut narrow = here.iter().map(|(narrow, _)| &narrow.statement);
        narrow.any(|narrow| tells_anew(narrow, &wide.statement))
    };
    let mut in_force = holds.iter();
    let mut own = vec![];
    for declaration in declarations {
        if is_limited(declaration) {
            own.extend(
                in_force
                    .next()
                    .filter(|holds| **holds)
                    .map(|_| Declaration {
                        extent: Extent::Document,
                        ..declaration.clone()
                    }),
            );
        } else if !told_anew(declaration) {
            let of_part = here.iter().any(|(d, _)| d.extent == declaration.extent);
            let mut own_declaration = declaration.clone();
            if of_part && tells_fixed_vector(declaration, declarations) {
                own_declaration.extent = Extent::Document;
            }
            own.push(own_declaration);
        }
    }
    let letters = others
        .iter()
        .flat_map(|(d, _)| mentioned_letters(&d.statement));
    let elsewhere = letters.map(|[exact, _]| exact).collect();
    Part {
        declarations: own,
        limits: limited.iter().cloned().zip(holds).collect(),
        elsewhere,
    }
}

/// Whether a sentence about a part of the document says all that a wider one says: where it holds the other does not.
fn tells_anew(narrow: &Statement, wide: &Statement) -> bool {
    let (
        Statement::Does {
            subjects,
            verb,
            slots,
        },
        Statement::Does {
            subjects: others,
            verb: other,
            slots: told,
        },
    ) = (narrow, wide)
    else {
        return false;
    };
    let again = |(slot, term): &(Slot, Term)| {
        let mut own = slots.iter().filter(|(own, _)| own == slot);
        own.any(|(_, own)| *slot != Slot::RelativeTo || own == term)
    };
    verb == other && subjects == others && told.iter().all(again)
}

/// "On lines 3 to 9 k is a unit vector fixed in N": a vector of the system of this part, where no sentence tells the letter
/// of another one.
fn tells_fixed_vector(declaration: &Declaration, all: &[Declaration]) -> bool {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return false;
    };
    let told_elsewhere = |d: &Declaration| match &d.statement {
        Statement::Is { subjects: own, .. } => {
            d.extent != declaration.extent && own.iter().any(|letter| subjects.contains(letter))
        }
        _ => false,
    };
    let fixed = what.head == UNIT_VECTOR && what.slot(Slot::FixedIn).is_some();
    fixed && !all.iter().any(told_elsewhere)
}

/// Whether a sentence builds the system for a part of the document alone.
fn is_limited(declaration: &Declaration) -> bool {
    let builds = match &declaration.statement {
        Statement::Is { what, .. } => {
            is_thing(what.head) || what.head == EULER_ANGLES || tells_lie(what)
        }
        Statement::Does { verb, .. } => VERBS.contains(verb),
        _ => false,
    };
    let several = matches!(
        declaration.extent,
        Extent::Lines { .. } | Extent::Cells(_) | Extent::Section(_) | Extent::Both(..)
    );
    builds && several
}

/// Where the rows of a document stand.
fn places(document: &Document) -> Vec<At> {
    let mut headings = Headings::default();
    let mut places = vec![];
    for item in &document.items {
        match item {
            Item::Heading { level, text, .. } => {
                headings.enter(*level, text);
            }
            Item::Formula(formula) => {
                let spans = formula.rows.iter().filter_map(|row| match row {
                    Row::Line(line) => Some(line.span),
                    _ => None,
                });
                places.extend(spans.map(|span| {
                    let place = document.place_of_row(span.start);
                    At {
                        cell: place.cell,
                        line: place.line,
                        sections: headings.texts(),
                    }
                }));
            }
            _ => {}
        }
    }
    places
}
