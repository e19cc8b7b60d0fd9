//! Momenta about the mass centre and about a point that moves: `\mathbf H_P = \mathbf H_G + \boldsymbol\rho\times m\mathbf v_G`.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::Document;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::two_points::{CENTRES, every_symbol};
use crate::verify::letters::usage::{Letter, inner, symbols};
use crate::verify::values::quantity::Quantity;
use crate::verify::words::sentences::{Paragraphs, sentences};
use std::collections::BTreeSet;

/// The symbols of such a document that belong to one of its points.
#[derive(Clone, Debug, Default)]
pub(crate) struct AtPoint {
    pub(crate) label: String,
    pub(crate) momentum: Option<Symbol>,
    pub(crate) moment: Option<Symbol>,
    pub(crate) position: Option<Symbol>,
    pub(crate) velocity: Option<Symbol>,
    pub(crate) acceleration: Option<Symbol>,
}

/// What a document that speaks of a moving point means by its symbols.
#[derive(Clone, Debug)]
pub(crate) struct MovingPoint {
    pub(crate) centre: AtPoint,
    pub(crate) other: AtPoint,
    /// The vector from the other point to the mass centre.
    pub(crate) arm: Symbol,
    /// Whether the momentum about the other point is made of velocities relative to it.
    pub(crate) relative: bool,
}

impl Reading {
    /// Finds the moving point, whose velocity must be written, and leaves its vectors to the laws that tie the two points.
    pub(crate) fn note_moving_point(&mut self, document: &Document) {
        self.moving_point = self.moving_point_of(document);
        let Some(found) = &self.moving_point else {
            return;
        };
        let points = [&found.centre, &found.other];
        let vectors = points.map(|at| [&at.position, &at.velocity, &at.acceleration]);
        let letters = vectors.into_iter().flatten().flatten().map(Letter::of);
        let letters: Vec<Letter> = letters.chain([Letter::of(&found.arm)]).collect();
        for letter in letters {
            self.quantities.remove(&letter);
        }
    }

    fn moving_point_of(&self, document: &Document) -> Option<MovingPoint> {
        // Beside a resultant force, Newton's law for the mass centre ties the two points.
        if self.points.is_some() || self.speaks_of(Quantity::Force) {
            return None;
        }
        let all = every_symbol(document);
        let of = |s: &Symbol, quantity| self.quantities.get(&Letter::of(s)) == Some(&quantity);
        let momenta = all.iter().filter(|s| of(s, Quantity::Momentum));
        let labels: BTreeSet<&str> = momenta.filter_map(|s| point(s)).collect();
        let labels: Vec<&str> = labels.into_iter().collect();
        let [one, two] = labels.as_slice() else {
            return None;
        };
        let (centre, other) = match CENTRES.iter().find(|c| *c == one || *c == two)? {
            c if c == one => (*one, *two),
            _ => (*two, *one),
        };
        let at = |label: &str| {
            let named = |fits: &dyn Fn(&Symbol) -> bool| {
                let found = all.iter().find(|s| point(s) == Some(label) && fits(s));
                found.map(|s| (**s).clone())
            };
            AtPoint {
                label: label.to_owned(),
                momentum: named(&|s| of(s, Quantity::Momentum)),
                moment: named(&|s| of(s, Quantity::Moment)),
                position: named(&|s| matches!(s.name.as_str(), "r" | "R" | "x")),
                velocity: named(&|s| matches!(s.name.as_str(), "v" | "V")),
                acceleration: named(&|s| s.name == "a"),
            }
        };
        let (centre, other) = (at(centre), at(other));
        other.velocity.as_ref()?;
        let arm = arm(document, &centre, &other)?;
        let relative = other.momentum.as_ref().is_some_and(|momentum| {
            let own = |side: &Node| matches!(&inner(side).kind, Kind::Symbol(s) if s == momentum);
            let shift = |side: &Node| {
                let mut met = symbols(side).into_iter();
                met.any(|s| Some(s) == other.velocity.as_ref()) || holds_rate_of(side, &arm)
            };
            document.lines().any(|line| {
                line.sides.first().is_some_and(own) && line.sides[1..].iter().any(shift)
            })
        });
        Some(MovingPoint {
            centre,
            other,
            arm,
            relative,
        })
    }
}

/// The label of a point at a vector.
fn point(symbol: &Symbol) -> Option<&str> {
    let [label] = symbol.subscripts.as_slice() else {
        return None;
    };
    let capital = label.len() == 1 && label.chars().all(|c| c.is_ascii_uppercase());
    let bare = symbol.superscripts.is_empty() && symbol.primes == 0;
    (symbol.style.vector && bare && (capital || CENTRES.contains(&label.as_str())))
        .then_some(label.as_str())
}

/// The vector from the other point to the centre: by a line, by its own indices, or by words.
fn arm(document: &Document, centre: &AtPoint, other: &AtPoint) -> Option<Symbol> {
    let by_line = || {
        document.lines().find_map(|line| {
            let [left, right] = line.sides.as_slice() else {
                return None;
            };
            let Kind::Sum(terms) = &inner(right).kind else {
                return None;
            };
            let is = |node: &Node, symbol: &Option<Symbol>| {
                matches!((&inner(node).kind, symbol), (Kind::Symbol(a), Some(b)) if a == b)
            };
            let [to, from] = terms.as_slice() else {
                return None;
            };
            let leads = is(&to.node, &centre.position) && is(&from.node, &other.position);
            match &inner(left).kind {
                Kind::Symbol(s) if leads && from.negative && !to.negative => Some(s.clone()),
                _ => None,
            }
        })
    };
    let [c, o] = [&centre.label, &other.label];
    let indices = [format!("{c}/{o}"), format!("{o}{c}")];
    let by_index = || {
        let mut all = every_symbol(document).into_iter();
        all.find(|s| s.style.vector && indices.contains(&s.subscripts.concat()))
            .cloned()
    };
    by_line()
        .or_else(by_index)
        .or_else(|| in_words(document, c, o))
}

/// "The vector from ⟨P⟩ to ⟨G⟩ is ⟨ρ⟩."
fn in_words(document: &Document, centre: &str, other: &str) -> Option<Symbol> {
    let way = format!("from ⟨{other}⟩ to ⟨{centre}⟩");
    sentences(document, Paragraphs::Joined)
        .iter()
        .filter(|sentence| sentence.named().contains(&way))
        .find_map(|sentence| {
            let mut vectors = sentence
                .symbols()
                .filter(|(s, _)| s.style.vector && s.subscripts.is_empty());
            let only = vectors.next().filter(|_| vectors.next().is_none());
            only.map(|(symbol, _)| symbol.clone())
        })
}

pub(crate) fn holds_rate_of(node: &Node, symbol: &Symbol) -> bool {
    let here = match &node.kind {
        Kind::TimeDerivative { operand, .. } => {
            matches!(&inner(operand).kind, Kind::Symbol(s) if s == symbol)
        }
        _ => false,
    };
    here || node.children().any(|child| holds_rate_of(child, symbol))
}
