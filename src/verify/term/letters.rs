//! What letters, marks, labels and operators mean, and for which part of the document.

use crate::notation::ast::{Kind, Node};
use crate::verify::model::blows::Side;
use crate::verify::model::common_list::CommonList;
use crate::verify::model::system::FrameId;
use crate::verify::term::customs::Customs;
use crate::verify::term::labels::raised;
use crate::verify::term::quantity::Quantity;
pub(crate) use crate::verify::term::spelled::{
    labelled_letter, letter_names, letters_and_names, loosely, spell, spelled,
};
use crate::verify::term::written::WrittenSymbols;
use std::collections::{BTreeMap, BTreeSet};

/// A place in a document.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct At {
    /// The cell of a notebook, from 0.
    pub(crate) cell: Option<usize>,
    /// The line, from 1.
    pub(crate) line: usize,
    /// The headings that it stands under, outermost first.
    pub(crate) sections: Vec<String>,
}

/// The part of a document for which something holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Reach {
    All,
    Lines {
        cell: Option<usize>,
        first: usize,
        last: usize,
    },
    Cells(Vec<usize>),
    /// A line and all behind it.
    From {
        cell: Option<usize>,
        line: usize,
    },
    Section(String),
    /// The n-th writing on a line.
    Occurrence {
        number: usize,
        cell: Option<usize>,
        line: usize,
    },
    Both(Box<Reach>, Box<Reach>),
    /// One of several parts.
    Any(Vec<Reach>),
}

impl Reach {
    /// Whether a place belongs to it; an occurrence is asked for by its number.
    pub(crate) fn covers(&self, at: &At, number: usize) -> bool {
        match self {
            Self::All => true,
            Self::Lines { cell, first, last } => {
                (cell.is_none() || *cell == at.cell) && (*first..=*last).contains(&at.line)
            }
            Self::Cells(cells) => at.cell.is_some_and(|cell| cells.contains(&cell)),
            Self::From { cell, line } => (at.cell, at.line) >= (*cell, *line),
            Self::Section(title) => at.sections.iter().any(|s| s.trim() == title.trim()),
            Self::Occurrence {
                number: n,
                cell,
                line,
            } => *cell == at.cell && *line == at.line && *n == number,
            Self::Both(a, b) => a.covers(at, number) && b.covers(at, number),
            Self::Any(all) => all.iter().any(|reach| reach.covers(at, number)),
        }
    }

    /// This part of the document, and another one.
    pub(crate) fn or(self, other: Self) -> Self {
        match self {
            Self::Any(mut all) => {
                all.push(other);
                Self::Any(all)
            }
            one => Self::Any(vec![one, other]),
        }
    }

    /// Whether it is made of another one.
    pub(crate) fn holds(&self, part: &Self) -> bool {
        match self {
            Self::Both(a, b) => a.holds(part) || b.holds(part),
            own => own == part,
        }
    }

    /// How narrow it is: the narrower one wins.
    pub(crate) fn narrowness(&self) -> usize {
        match self {
            Self::All => 0,
            Self::From { .. } => 5,
            Self::Cells(_) => 10,
            Self::Section(_) => 20,
            Self::Lines { first, last, .. } => 1_000_000 - last.saturating_sub(*first).min(900_000),
            Self::Occurrence { .. } => 2_000_000,
            Self::Both(a, b) => a.narrowness().max(b.narrowness()) + 1,
            Self::Any(all) => all.iter().map(Self::narrowness).min().unwrap_or(0),
        }
    }
}

/// An operator that a document defines.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Operator {
    /// The cross-product matrix of what it is applied to.
    CrossProductMatrix,
    /// The components of what it is applied to on a frame.
    ComponentsOn(FrameId),
    /// The matrix of the rotation by the length of a vector about it.
    RotationVector,
    /// The matrix of the rotation by an angle about a unit vector that a frame carries.
    RotationAbout(Quantity, FrameId),
    /// The matrix of the rotation by an angle about an axis.
    AxisRotation(usize),
    /// The matrix that takes components to those on the axes after they have turned so.
    AxisRotationOfComponents(usize),
}

/// What a writing means.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Meaning {
    /// A quantity.
    Quantity(Quantity),
    /// Another writing: the same thing.
    Same(Box<Node>),
    /// A function of what stands behind it.
    Operator(Operator),
    /// The first-order change of another writing, where it is worked out.
    Change(Option<Box<Node>>),
    /// The time.
    Time,
}

/// What one writing means, where.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Letter {
    /// The writing, spelled.
    pub(crate) spelled: String,
    /// The same without what only makes it bold or upright.
    pub(crate) loose: String,
    /// How it is printed.
    pub(crate) latex: String,
    pub(crate) meaning: Meaning,
    pub(crate) reach: Reach,
    /// The sentence that says so.
    pub(crate) sentence: String,
    /// Whether it means something else besides: types decide where.
    pub(crate) besides: bool,
    /// Whether it is more than a lone symbol.
    pub(crate) whole: bool,
}

/// What a mark or a label does to the letter that carries it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Effect {
    /// The components on a frame.
    ComponentsOn(FrameId),
    /// The rate seen from a frame.
    RateSeenFrom(FrameId),
    /// What a dot means.
    Rate,
    /// The cross-product matrix.
    CrossProductMatrix,
    /// The value at the instant of this number.
    AtInstant(usize),
    /// The value at a side of a blow.
    AtBlow(Side),
    /// Nothing: the thing itself.
    Itself,
}

/// A mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    Tilde,
    Hat,
    Bar,
    Prime,
    /// A ring above.
    Ring,
    Dot,
    /// A vector or tensor without a label.
    NoLabel,
    /// The unit vector of an axis without a label.
    AxisWithoutLabel,
    /// d/dt.
    Leibniz,
    /// ∂/∂t.
    Partial,
    /// The brackets around a list.
    Brackets,
}

/// A rule for a mark.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MarkRule {
    pub(crate) mark: Mark,
    pub(crate) effect: Effect,
    pub(crate) reach: Reach,
}

/// A rule for a label below or above a letter.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LabelRule {
    pub(crate) label: String,
    pub(crate) effect: Effect,
    /// Whether it means so on rates and brackets alone.
    pub(crate) on_whole: bool,
    /// The number of the component, for labels that number components.
    pub(crate) component: Option<usize>,
    pub(crate) reach: Reach,
}

/// Letters that number things.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct IndexRule {
    pub(crate) letter: String,
    /// What it numbers: the axes of a frame, or a family by its name.
    pub(crate) axes_of: Option<FrameId>,
    /// How many things it numbers that have names.
    pub(crate) members: Option<usize>,
    pub(crate) reach: Reach,
}

/// All that is known of writings.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Letters {
    pub(crate) letters: CommonList<Letter>,
    pub(crate) marks: CommonList<MarkRule>,
    pub(crate) labels: CommonList<LabelRule>,
    pub(crate) indices: CommonList<IndexRule>,
    /// Frames by the labels that they may have.
    pub(crate) frame_names: CommonList<(String, FrameId)>,
    /// The frame of components that say no other.
    pub(crate) component_frame: FrameId,
    pub(crate) customs: Customs,
    /// Letters that with a cross behind them are matrices: `ω×`.
    pub(crate) crossing: Vec<String>,
    /// The instants of which labels speak, spelled, in their order.
    pub(crate) instants: Vec<String>,
    /// What the document writes.
    pub(crate) written: WrittenSymbols,
    /// The lists of letters that partial derivatives take functions of.
    pub(crate) arguments: Vec<Arguments>,
    /// Writings that stand for other formulas.
    pub(crate) means: Vec<(String, Node, Reach)>,
}

/// What partial derivatives take functions of: those of one letter, or all.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Arguments {
    /// The letter, spelled.
    pub(crate) of: Option<String>,
    pub(crate) letters: Vec<Node>,
}

impl Letters {
    /// The narrowest meaning of a spelled writing at a place.
    pub(crate) fn find(
        &self,
        spelled: &str,
        loose: &str,
        at: &At,
        number: usize,
    ) -> Option<&Letter> {
        let best = |exact: bool| {
            let fits = |l: &&Letter| {
                let same = if exact {
                    l.spelled == spelled
                } else {
                    l.loose == loose
                };
                same && !l.besides && l.reach.covers(at, number)
            };
            // The later of two equally narrow ones replaces the earlier.
            let fitting = self.letters.iter().filter(fits);
            fitting.max_by_key(|l| l.reach.narrowness())
        };
        best(true).or_else(|| best(false))
    }

    /// The same for a lone symbol: bold and plain are two letters where the document writes both.
    pub(crate) fn find_lone(
        &self,
        spelled: &str,
        loose: &str,
        at: &At,
        number: usize,
    ) -> Option<&Letter> {
        let found = self.find(spelled, loose, at, number)?;
        let apart = found.spelled != spelled && self.written.has(&found.spelled);
        (!apart).then_some(found)
    }

    /// What a letter means besides.
    pub(crate) fn besides(&self, spelled: &str, at: &At) -> Option<&Letter> {
        let fits = |l: &&Letter| l.besides && l.spelled == spelled && l.reach.covers(at, 0);
        self.letters.iter().find(fits)
    }

    /// One formula that has a letter bold and plain means two letters, wherever they stand.
    pub(crate) fn keep_apart(&mut self, sides: &[Node]) {
        fn collect(node: &Node, found: &mut BTreeMap<String, BTreeSet<String>>) {
            if let Kind::Symbol(symbol) = &node.kind {
                let ways = found.entry(spell(symbol, false)).or_default();
                ways.insert(spell(symbol, true));
            }
            node.children().for_each(|child| collect(child, found));
        }
        let mut found = BTreeMap::new();
        sides.iter().for_each(|side| collect(side, &mut found));
        let several = found.into_values().filter(|ways| ways.len() > 1);
        self.written.keep_apart(several.flatten());
    }

    /// What the author says that a formula means.
    pub(crate) fn told_meaning(&self, spelled: &str, at: &At) -> Option<&Node> {
        let fits =
            |(whole, _, reach): &&(String, Node, Reach)| whole == spelled && reach.covers(at, 1);
        self.means.iter().find(fits).map(|(_, meaning, _)| meaning)
    }

    pub(crate) fn mark(&self, mark: Mark, at: &At) -> Option<&Effect> {
        Some(&self.mark_rule(mark, at)?.effect)
    }

    fn mark_rule(&self, mark: Mark, at: &At) -> Option<&MarkRule> {
        let fits = |r: &&MarkRule| r.mark == mark && r.reach.covers(at, 0);
        let rules = self.marks.iter().filter(fits);
        rules.max_by_key(|r| r.reach.narrowness())
    }

    /// Whether a sentence says of a part of the document what a mark means.
    pub(crate) fn marks_part(&self, mark: Mark, at: &At) -> bool {
        let rule = self.mark_rule(mark, at);
        rule.is_some_and(|rule| rule.reach != Reach::All)
    }

    pub(crate) fn label(&self, label: &str, on_whole: bool, at: &At) -> Option<&LabelRule> {
        let fits =
            |r: &&LabelRule| r.label == label && (!r.on_whole || on_whole) && r.reach.covers(at, 0);
        let rules = self.labels.iter().filter(fits);
        rules.max_by_key(|r| r.reach.narrowness())
    }

    /// How many dimensions space has at a place.
    pub(crate) fn dimensions_at(&self, at: &At) -> usize {
        let told = self
            .customs
            .dimensions
            .iter()
            .filter(|(reach, _)| reach.covers(at, 0));
        told.max_by_key(|(reach, _)| reach.narrowness())
            .map_or(3, |(_, number)| *number)
    }

    pub(crate) fn index(&self, letter: &str, at: &At) -> Option<&IndexRule> {
        let fits = |r: &&IndexRule| r.letter == letter && r.reach.covers(at, 0);
        let rules = self.indices.iter().filter(fits);
        rules.max_by_key(|r| r.reach.narrowness())
    }

    /// What a frame above a letter does to it, where that is a custom.
    pub(crate) fn raised_frame(&self, label: &str) -> Option<Effect> {
        // One that is called by its number has this for a label.
        let numbered = || self.frame(&raised(label));
        let frame = self.frame(label).or_else(numbered);
        let frame = frame.filter(|_| self.customs.raised_frames);
        frame.map(Effect::ComponentsOn)
    }

    pub(crate) fn frame(&self, name: &str) -> Option<FrameId> {
        let found = self.frame_names.iter().find(|(n, _)| n == name);
        found.map(|(_, frame)| *frame)
    }
}
