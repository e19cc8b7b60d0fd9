//! Inertia about two points: which labels name the points, which of them is the mass centre, and what leads from one to
//! the other.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::point_labels::{BAR, COORDINATES, ENTRIES, Place, about, bears};
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, Usage, axis, inner, symbols};
use crate::verify::letters::wholes::terms;
use crate::verify::values::quantity::Quantity;
use crate::verify::words::points_in_words::{
    called_centre, calls_distance, holds_still, lone, place_in_words, places,
};
use std::collections::BTreeSet;

/// Labels of the mass centre, the surest first.
pub(crate) const CENTRES: &[&str] = &[
    BAR, "cm", "CM", "com", "COM", "cg", "CG", "mc", "G", "g", "S", "C", "c", "*",
];

/// What a document that relates the inertia about one point to that about another means by its labels.
#[derive(Clone, Debug)]
pub(crate) struct TwoPoints {
    letters: BTreeSet<Letter>,
    /// Letters that stand for a tensor where no mark is on them.
    unmarked: BTreeSet<Letter>,
    /// The label of the mass centre.
    pub centre: String,
    /// The label of the other point.
    pub other: String,
    /// The point of the tensor that momentum and energy are made of.
    pub main: String,
    /// The mass.
    pub mass: Symbol,
    /// The vector from one point to the other, where one is written.
    pub vector: Option<Symbol>,
    /// Its components, where they have letters of their own.
    pub coordinates: Option<[Symbol; 3]>,
    /// Its components in expressions, where words give them.
    pub place: Option<[Node; 3]>,
    /// Two moments about one axis each, and the distance of the axes.
    pub axes: Option<(Symbol, Symbol, Symbol)>,
    /// The angular momentum about the other point, beside that about the mass centre.
    pub momentum: Option<Symbol>,
    /// The velocity of the mass centre.
    pub velocity: Option<Symbol>,
    /// Whether the words let the body turn about the other point.
    pub pivot: bool,
}

impl TwoPoints {
    /// Finds the points of a document; `None` where none of its lines relates the inertia about two.
    pub(crate) fn of(document: &Document, usage: &Usage) -> Option<Self> {
        let mut lines = relations(document);
        let centre = centre(document, &labels(&lines))?;
        let of_centre = |s: &&Symbol| about(s).is_some_and(|(label, _)| label == centre);
        lines.retain(|line| line.iter().any(of_centre));
        let written = lines.iter().find_map(|line| mass(line));
        let mass = written.or_else(|| mass(&every_symbol(document)))?;
        let labels = labels(&lines);
        let others: Vec<String> = labels.into_iter().filter(|l| *l != centre).collect();
        // Beside `\mathbf I_O`, an `I_xx` without a label is about O too.
        let other = match others.as_slice() {
            [one] => one.clone(),
            [bare, one] | [one, bare] if bare.is_empty() => one.clone(),
            _ => return None,
        };
        let used = beside_tensors(document, &lines, &mass);
        let tensors = lines.iter().flatten().filter(|s| about(s).is_some());
        let mut found = Self {
            letters: tensors.map(|s| Letter::of(s)).collect(),
            unmarked: BTreeSet::new(),
            vector: vector(&used, usage),
            coordinates: None,
            place: place_in_words(document, &centre),
            axes: None,
            pivot: holds_still(document),
            main: centre.clone(),
            centre,
            other,
            mass,
            momentum: None,
            velocity: None,
        };
        found.unmarked = found.unmarked_tensors(document);
        found.coordinates = found.coordinates(document, &used);
        found.axes = found.moments(document, &lines);
        found.motion(document);
        Some(found)
    }

    /// Which point momentum and energy are about, and the symbols of the motion with the label of a point.
    fn motion(&mut self, document: &Document) {
        let all = every_symbol(document);
        let labelled = |names: &[&str], label: &str| {
            let named = |s: &&&Symbol| names.contains(&s.name.as_str()) && bears(s, label);
            all.iter().find(named).map(|s| (*s).clone())
        };
        let of_centre = labelled(MOMENTA, &self.centre);
        let of_other = labelled(MOMENTA, &self.other);
        self.velocity = labelled(&["v", "V"], &self.centre);
        let central = of_centre.is_some() || of_other.is_none() && self.velocity.is_some();
        if self.other.is_empty() || !self.centre.is_empty() && !central {
            self.main = self.other.clone();
        }
        self.momentum = of_centre.and(of_other);
    }

    /// The point and the part of the inertia that a symbol names, where it names one of the two points.
    pub(crate) fn place(&self, symbol: &Symbol) -> Option<(&str, Place)> {
        let (label, place) = about(symbol)?;
        let letter = Letter::of(symbol);
        if !self.letters.contains(&letter) {
            return None;
        }
        let point = match label {
            label if label == self.centre => &self.centre,
            label if label == self.other || label.is_empty() => &self.other,
            _ => return None,
        };
        let place = match place {
            Place::Whole(false) if self.unmarked.contains(&letter) => Place::Whole(true),
            place => place,
        };
        Some((point, place))
    }

    /// The letters that have two points.
    pub(crate) fn letters(&self) -> impl Iterator<Item = &Letter> {
        self.letters.iter()
    }

    /// Takes the points off the symbols of a line that says by an integral what they are: about whichever point.
    pub(crate) fn unlabel_integrals(&self, sides: &mut [Node]) {
        if !sides
            .iter()
            .any(|side| matches!(inner(side).kind, Kind::Integral { .. }))
        {
            return;
        }
        for side in sides {
            side.change_symbols(&mut |symbol| {
                if let Some((_, Place::Entry(component))) = self.place(symbol) {
                    symbol.superscripts.clear();
                    symbol.subscripts = vec![ENTRIES[usize::from(component) % 6].to_owned()];
                }
            });
        }
    }

    /// Letters whose unmarked form stands in lines of matrices.
    fn unmarked_tensors(&self, document: &Document) -> BTreeSet<Letter> {
        let matrices = formulas(document).filter(|sides| sides.iter().any(is_matrix));
        let met = matrices.flatten().flat_map(symbols);
        let plain = met.filter(|s| matches!(about(s), Some((_, Place::Whole(false)))));
        plain
            .map(Letter::of)
            .filter(|l| self.letters.contains(l))
            .collect()
    }

    /// Three letters for the coordinates of the mass centre: a list that the words call so or that the vector is set equal
    /// to, x_G, y_G, z_G, or d_x, d_y, d_z without a vector d.
    fn coordinates(&self, document: &Document, used: &[&Symbol]) -> Option<[Symbol; 3]> {
        let met = |list: &[Symbol; 3]| list.iter().filter(|s| used.contains(s)).count() > 1;
        let listed = places(document, &self.vector)
            .into_iter()
            .find(|list| met(list));
        let with = |symbol: &Symbol, name: &str| Symbol {
            name: name.to_owned(),
            ..symbol.clone()
        };
        let custom = || {
            let plain = used.iter().find(|s| {
                let marked = !s.subscripts.is_empty() || !s.superscripts.is_empty() || s.style.bar;
                COORDINATES.contains(&s.name.as_str()) && marked
            })?;
            Some(COORDINATES.map(|name| with(plain, name)))
        };
        let indexed = || {
            let part = used
                .iter()
                .find(|s| s.subscripts.iter().any(|i| axis(i).is_some()))?;
            let family = match part
                .subscripts
                .iter()
                .any(|i| i.starts_with(['x', 'y', 'z']))
            {
                true => ["x", "y", "z"],
                false => ["1", "2", "3"],
            };
            Some(family.map(|new| {
                let mut symbol = (*part).clone();
                for index in symbol.subscripts.iter_mut().filter(|i| axis(i).is_some()) {
                    *index = new.to_owned();
                }
                symbol
            }))
        };
        let indexed = || indexed().filter(|_| self.vector.is_none());
        // Plain text has letters as words: "the coordinates a, b, c".
        let spelled = || {
            let lists = ["a, b, c", "a, b and c"];
            let said = document.items.iter().any(|item| match item {
                Item::Prose { text, .. } => {
                    text.contains("coordinates") && lists.iter().any(|list| text.contains(list))
                }
                _ => false,
            });
            let list = ["a", "b", "c"].map(|name| Symbol {
                name: name.to_owned(),
                ..Symbol::default()
            });
            Some(list).filter(|list| said && met(list))
        };
        listed.or_else(custom).or_else(indexed).or_else(spelled)
    }

    /// Two moments about one axis each, in a line with the square of what the words call a distance.
    fn moments(
        &self,
        document: &Document,
        lines: &[Vec<&Symbol>],
    ) -> Option<(Symbol, Symbol, Symbol)> {
        lines.iter().find_map(|line| {
            let whole = |label: &str| {
                let is = |s: &&&Symbol| {
                    about(s).is_some_and(|(l, p)| l == label && p == Place::Whole(false))
                };
                line.iter().find(is).copied().cloned()
            };
            let (other, centre) = (whole(&self.other)?, whole(&self.centre)?);
            if self.unmarked.contains(&Letter::of(&other)) {
                return None;
            }
            let distance = line.iter().find(|s| calls_distance(document, s))?;
            Some((other, centre, (*distance).clone()))
        })
    }
}

/// Letters of the angular momentum and the moment.
const MOMENTA: &[&str] = &["L", "H", "M", "N", "tau", "Gamma", "h"];

fn formulas(document: &Document) -> impl Iterator<Item = &Vec<Node>> {
    let rows = document.items.iter().filter_map(|item| match item {
        Item::Formula(formula) => Some(&formula.rows),
        _ => None,
    });
    rows.flatten().filter_map(|row| match row {
        Row::Line(line) => Some(&line.sides),
        _ => None,
    })
}

/// The symbols of all lines.
pub(crate) fn every_symbol(document: &Document) -> Vec<&Symbol> {
    formulas(document).flatten().flat_map(symbols).collect()
}

/// The symbols of the lines in which a letter of inertia with one label is a sum of the same with another label and of
/// something with a mass, or with what the words call a distance, where a slip may have lost the mass.
fn relations(document: &Document) -> Vec<Vec<&Symbol>> {
    let related = formulas(document).filter(|sides| {
        let terms = sides.iter().flat_map(terms).filter_map(lone);
        relates(&terms.collect::<Vec<_>>(), sides)
    });
    let met = related.map(|sides| {
        let all = sides.iter().flat_map(symbols).collect::<Vec<_>>();
        (all, sides.iter().any(shifts))
    });
    let distance = |line: &[&Symbol]| line.iter().any(|s| calls_distance(document, s));
    met.filter(|(line, shifts)| mass(line).is_some() || *shifts || distance(line))
        .map(|(line, _)| line)
        .collect()
}

/// Whether a side has the dyad, the cross product matrix or the length of a vector, as what a tensor changes by from
/// point to point has.
fn shifts(side: &Node) -> bool {
    let own = matches!(
        side.kind,
        Kind::Transpose(_) | Kind::Skew(_) | Kind::Norm(_)
    );
    own || side.children().any(shifts)
}

/// Whether all tensors of a line stand alone or as terms, under one letter with two labels: a balance of many bodies is
/// another matter.
fn relates(terms: &[&Symbol], sides: &[Node]) -> bool {
    let labelled = |s: &&Symbol| Some((Letter::of(s), about(s)?.0));
    let alone: Vec<(Letter, String)> = terms.iter().filter_map(labelled).collect();
    let met = sides
        .iter()
        .flat_map(symbols)
        .filter(|s| about(s).is_some());
    let labels: BTreeSet<&String> = alone.iter().map(|(_, label)| label).collect();
    let letters: BTreeSet<&Letter> = alone.iter().map(|(letter, _)| letter).collect();
    met.count() == alone.len() && labels.len() == 2 && letters.len() == 1
}

/// The symbols that a bracket of their own follows: the S of `S(d)`.
fn heads<'n>(node: &'n Node, found: &mut Vec<&'n Symbol>) {
    if let Kind::Call(head, _) = &node.kind {
        found.extend(lone(head));
    }
    node.children().for_each(|child| heads(child, found));
}

fn mass(line: &[&Symbol]) -> Option<Symbol> {
    let named = |s: &&&Symbol| {
        matches!(s.name.as_str(), "m" | "M") && !s.style.vector && s.subscripts.is_empty()
    };
    line.iter().find(named).map(|s| (*s).clone())
}

/// The symbols of lines but for tensors, the mass and the names of functions.
fn beside_tensors<'d>(
    document: &'d Document,
    lines: &[Vec<&'d Symbol>],
    mass: &Symbol,
) -> Vec<&'d Symbol> {
    let mut functions = vec![];
    for side in formulas(document).flatten() {
        heads(side, &mut functions);
    }
    let all = lines.iter().flatten().copied();
    all.filter(|s| about(s).is_none() && *s != mass && !functions.contains(s))
        .collect()
}

fn labels(lines: &[Vec<&Symbol>]) -> BTreeSet<String> {
    let all = lines.iter().flatten();
    all.filter_map(|s| Some(about(s)?.0)).collect()
}

/// The label of the mass centre: by the words, by custom, or the tensor without a label beside one with.
fn centre(document: &Document, labels: &BTreeSet<String>) -> Option<String> {
    let said = labels.iter().find(|label| called_centre(document, label));
    let custom = || CENTRES.iter().find_map(|c| labels.get(*c));
    let bare = || labels.get("");
    said.or_else(custom).or_else(bare).cloned()
}

/// The one vector that stands in the relations.
fn vector(used: &[&Symbol], usage: &Usage) -> Option<Symbol> {
    let mut found: Option<Symbol> = None;
    for symbol in used {
        let letter = Letter::of(symbol);
        let parts = symbol.subscripts.iter().any(|i| axis(i).is_some());
        // The identity is none.
        let unit = symbol.name == "E";
        if !(symbol.style.vector || usage.is_vector(&letter)) || parts || unit {
            continue;
        }
        let mut whole = (*symbol).clone();
        whole.style.tilde = false;
        // `d^2` is the square of the length.
        whole.style.vector = true;
        match &found {
            Some(other) if *other != whole => return None,
            _ => found = Some(whole),
        }
    }
    found
}

/// Whether a matrix is written in a node: rows, a transpose, the matrix of a cross product, an identity, a dyad.
fn is_matrix(node: &Node) -> bool {
    let own = match &node.kind {
        Kind::Matrix(_) | Kind::Transpose(_) | Kind::Skew(_) | Kind::Bold(_) => true,
        Kind::Symbol(symbol) => symbol.style.vector || symbol.style.tensor,
        _ => false,
    };
    own || node.children().any(is_matrix)
}

impl Reading {
    /// A letter that has two points is the inertia, and what multiplies the offset between them the mass.
    pub(crate) fn by_points(&mut self) {
        let Some(points) = &self.points else { return };
        let letters = points.letters();
        let mass = Letter::of(&points.mass);
        let kind = self.quantities.get(&mass);
        if kind.is_some_and(|q| *q != Quantity::Mass) {
            self.bare.insert(mass, Quantity::Mass);
        }
        let free = letters.filter(|letter| !self.components.contains_key(letter));
        let all: Vec<Letter> = free.cloned().collect();
        self.quantities
            .extend(all.into_iter().map(|letter| (letter, Quantity::Inertia)));
    }
}
