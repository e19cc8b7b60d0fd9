//! Which sides a line sets equal: each against the head of its chain.

use crate::notation::ast::{Kind, Line, Node, Relation};
use crate::notation::document::{Document, Item, Row};
use crate::recent::Digest;
use crate::source::Span;
use crate::verify::language::statement::{Declaration, DeclaredRole, Statement};
use crate::verify::reading::names::{node_of, reach_of};
use crate::verify::term::letters::{At, Letters, Reach, loosely, spelled};
use crate::verify::term::written::WrittenSymbols;
use std::borrow::Cow;

/// Two sides and what is said of them.
#[derive(Clone, Debug)]
pub(crate) struct Link<'l> {
    pub(crate) left: Cow<'l, Node>,
    pub(crate) relation: Relation,
    pub(crate) right: Cow<'l, Node>,
}

impl Link<'_> {
    pub(crate) fn sides(&self) -> [&Node; 2] {
        [&self.left, &self.right]
    }

    /// The same without the line that it is of.
    pub(crate) fn into_owned(self) -> Link<'static> {
        Link {
            left: Cow::Owned(self.left.into_owned()),
            relation: self.relation,
            right: Cow::Owned(self.right.into_owned()),
        }
    }
}

/// Where a chain of rows stands.
#[derive(Clone, Debug, Default)]
pub(crate) struct Chain {
    /// Its first side, as far as rows go on from it.
    head: Option<Node>,
    /// Whether rows of the document go on from others.
    goes_on: bool,
    /// The first sides that sentences tell, and of which lines.
    told: Vec<(Reach, Node)>,
    /// The lines that go on from others, and from which, as sentences say.
    told_from: Vec<(Reach, Reach)>,
    /// The first sides of the lines so far, where a line may go on from any of them.
    firsts: Vec<(At, Node)>,
}

impl Chain {
    /// With the first sides that sentences tell: "line 5 starts from `$X$`".
    pub(crate) fn told_by(declarations: &[Declaration], document: &Document) -> Self {
        let told = declarations.iter().filter_map(|d| match &d.statement {
            Statement::Role {
                lines,
                role: DeclaredRole::StartsFrom(side),
            } => {
                let reach = Reach::Both(Box::new(reach_of(&d.extent)), Box::new(reach_of(lines)));
                Some((reach, node_of(side)?.clone()))
            }
            _ => None,
        });
        let told_from = declarations.iter().filter_map(|d| match &d.statement {
            Statement::Role {
                lines,
                role: DeclaredRole::GoesOnFrom(before),
            } => {
                let reach = Reach::Both(Box::new(reach_of(&d.extent)), Box::new(reach_of(lines)));
                Some((reach, reach_of(before)))
            }
            _ => None,
        });
        Self {
            head: None,
            goes_on: has_rows_that_go_on(document),
            told: told.collect(),
            told_from: told_from.collect(),
            firsts: vec![],
        }
    }

    /// Before the first line of a document.
    pub(crate) fn begin_anew(&mut self, document: &Document) {
        self.head = None;
        self.goes_on = has_rows_that_go_on(document);
    }

    /// The first row of a display that has no relation: the rows below go on from it.
    pub(crate) fn begin(&mut self, head: &Node) {
        self.head = Some(head.clone());
    }

    /// The links of a line; a row that begins with a relation goes on from the head of the chain before it.
    ///
    /// Equals are held against the head, so that one false member does not make the next one false or hide it.
    pub(crate) fn links<'l>(&mut self, line: &'l Line, at: &At) -> Vec<Link<'l>> {
        let (first, rights) = match (line.continues, line.sides.split_first()) {
            (false, Some((first, rights))) => (Some(Cow::Borrowed(first)), rights),
            (false, None) => (None, &[][..]),
            (true, _) => {
                let mut told = self.told.iter();
                let told = told.find(|(reach, _)| reach.covers(at, 0));
                let told = told.map(|(_, side)| side.clone());
                let first = told.or_else(|| self.first_told(at));
                (first.or(self.head.take()).map(Cow::Owned), &line.sides[..])
            }
        };
        if let Some(first) = first.as_deref().filter(|_| !self.told_from.is_empty()) {
            self.firsts.push((at.clone(), first.clone()));
        }
        self.keep(first.as_deref());
        let Some(mut left) = first else {
            return vec![];
        };
        let mut links = vec![];
        for ((relation, _), right) in line.relations.iter().zip(rights) {
            links.push(Link {
                left: left.clone(),
                relation: *relation,
                right: Cow::Borrowed(right),
            });
            // Behind a bound or an approximation the chain goes on from there.
            if !matches!(relation, Relation::Equal | Relation::Defined) {
                left = Cow::Borrowed(right);
                self.keep(Some(right));
            }
        }
        links
    }

    /// The first side of the line from which this one goes on, as a sentence says.
    fn first_told(&self, at: &At) -> Option<Node> {
        let mut told = self.told_from.iter();
        let (_, before) = told.find(|(reach, _)| reach.covers(at, 0))?;
        let mut firsts = self.firsts.iter().rev();
        let (_, first) = firsts.find(|(at, _)| before.covers(at, 0))?;
        Some(first.clone())
    }

    /// Keeps a head for rows that go on from it.
    fn keep(&mut self, head: Option<&Node>) {
        self.head = head.filter(|_| self.goes_on).cloned();
    }
}

fn has_rows_that_go_on(document: &Document) -> bool {
    let mut formulas = document.items.iter().filter_map(|item| match item {
        Item::Formula(formula) => Some(&formula.rows),
        _ => None,
    });
    formulas.any(|rows| {
        let mut rows = rows.iter();
        rows.any(|row| matches!(row, Row::Line(line) if line.continues))
    })
}

/// Whether a letter of which no sentence tells stands alone on a side.
pub(crate) fn may_define(links: &[Link], letters: &Letters, at: &At) -> bool {
    let is_new = |side: &Node| {
        let letter = matches!(side.kind, Kind::Symbol(_) | Kind::Call(..));
        letter
            && letters
                .find(&spelled(side), &loosely(side), at, 0)
                .is_none()
    };
    links
        .iter()
        .any(|link| is_new(&link.left) || is_new(&link.right))
}

/// What the only link of a line of the document is looked for by, if it has the sides of the line.
pub(super) fn known_tree(
    written: &WrittenSymbols,
    line: &Line,
    links: &[Link<'_>],
) -> Option<Digest> {
    let [Link { left, right, .. }] = links else {
        return None;
    };
    let is_side = |side: &Cow<'_, Node>, own: &Node| matches!(side, Cow::Borrowed(side) if std::ptr::eq(*side, own));
    match line.sides.as_slice() {
        [first, last] if is_side(left, first) && is_side(right, last) => written.tree(line.span),
        _ => None,
    }
}

/// Where the first side of some links stands.
pub(super) fn head_of(links: &[Link]) -> Span {
    links.first().map_or(Span::default(), |link| link.left.span)
}
