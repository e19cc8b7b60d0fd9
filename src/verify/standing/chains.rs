//! Which sides a line sets equal: each against the head of its chain.

use crate::notation::ast::{Kind, Line, Node, Relation};
use crate::source::Span;
use crate::verify::language::statement::{Declaration, DeclaredRole, Statement};
use crate::verify::reading::names::{node_of, reach_of};
use crate::verify::term::letters::{At, Letters, Reach, loosely, spelled};

/// Two sides and what is said of them.
#[derive(Clone, Debug)]
pub(crate) struct Link {
    pub(crate) left: Node,
    pub(crate) relation: Relation,
    pub(crate) right: Node,
}

/// Where a chain of rows stands.
#[derive(Clone, Debug, Default)]
pub(crate) struct Chain {
    /// Its first side.
    head: Option<Node>,
    /// The first sides that sentences tell, and of which lines.
    told: Vec<(Reach, Node)>,
}

impl Chain {
    /// With the first sides that sentences tell: "line 5 starts from `$X$`".
    pub(crate) fn told_by(declarations: &[Declaration]) -> Self {
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
        Self {
            head: None,
            told: told.collect(),
        }
    }

    /// Before the first line.
    pub(crate) fn begin_anew(&mut self) {
        self.head = None;
    }

    /// The first row of a display that has no relation: the rows below go on from it.
    pub(crate) fn begin(&mut self, head: &Node) {
        self.head = Some(head.clone());
    }

    /// The links of a line; a row that begins with a relation goes on from the head of the chain before it.
    ///
    /// Equals are held against the head, so that one false member does not make the next one false or hide it.
    pub(crate) fn links(&mut self, line: &Line, at: &At) -> Vec<Link> {
        if !line.continues {
            self.head = line.sides.first().cloned();
        } else if let Some((_, side)) = self.told.iter().find(|(reach, _)| reach.covers(at, 0)) {
            self.head = Some(side.clone());
        }
        let Some(head) = self.head.clone() else {
            return vec![];
        };
        let rights = if line.continues {
            &line.sides[..]
        } else {
            line.sides.get(1..).unwrap_or(&[])
        };
        let mut links = vec![];
        let mut left = head;
        for ((relation, _), right) in line.relations.iter().zip(rights) {
            links.push(Link {
                left: left.clone(),
                relation: *relation,
                right: right.clone(),
            });
            // Behind a bound or an approximation the chain goes on from there.
            if !matches!(relation, Relation::Equal | Relation::Defined) {
                left = right.clone();
                self.head = Some(right.clone());
            }
        }
        links
    }
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

/// Where the first side of some links stands.
pub(super) fn head_of(links: &[Link]) -> Span {
    links.first().map_or(Span::default(), |link| link.left.span)
}
