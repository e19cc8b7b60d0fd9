//! Bodies of point masses at places in words: "two masses ⟨m⟩ sit at ⟨(r, 0, a)⟩ and ⟨(-r, 0, -a)⟩", ∫ x_a x_b dm = Σ m x_a x_b.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::notation::document::{Document, Formula, Item, Row};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{inner, symbols};
use crate::verify::theory::Premise;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::value::Value;
use crate::verify::words::book::has_any;
use num_traits::Zero;

/// The name of the law.
const LAW: &str = "the point masses";
const MASSES: &[&str] = &["point mass", "masses", "particles", "small weights"];
/// Words of bodies in which nothing else has mass.
const ALONE: &[&str] = &[
    "light arm",
    "light rod",
    "light shaft",
    "massless",
    "weightless",
    "without mass",
    "replace",
    "consists of",
    "dumbbell",
    "dumb-bell",
];

/// Bodies that carry masses and have some of their own.
const BODIES: &[&str] = &[
    "rotor",
    "shaft",
    "disc",
    "disk",
    "wheel",
    "plate",
    "satellite",
    "spacecraft",
    "rod",
    "beam",
    "crank",
    "counterweight",
    "weights",
    "hull",
    "drum",
    "cylinder",
    "sphere",
    " bar ",
    "ring",
    "propeller",
    "platform",
    "turntable",
    "table",
    "frame of mass",
    "block",
    "balanc",
];
/// Numbers of masses in words.
const NUMBERS: &[(&str, usize)] = &[
    ("two", 2),
    ("three", 3),
    ("four", 4),
    ("five", 5),
    ("six", 6),
    ("eight", 8),
];

/// A mass and its place.
pub(crate) type PointMass = (Node, Node);

impl Checker<'_> {
    /// Finds the sentence with the masses.
    pub(crate) fn find_point_masses(&mut self) {
        if self.reading.points.is_none() && self.text.says(MASSES) {
            self.point_masses = point_masses(self.document);
        }
    }

    /// Takes in the products of inertia of such a body, and its moments where nothing else has mass, behind the sentence
    /// that says so.
    pub(crate) fn take_point_masses(&mut self, at: Span) {
        let said = |(_, span): &mut (_, Span)| span.end <= at.start;
        let Some((masses, span)) = self.point_masses.take_if(said) else {
            return;
        };
        let Some(sums) = self.second_sums(&masses) else {
            return;
        };
        let second = self.lowering(Frame::Moving).second_moments();
        let whole = self.text.says(ALONE) || !self.text.says(BODIES);
        let pairs = (0..3).flat_map(|a| (a..3).map(move |b| (a, b)));
        let said = pairs.filter(|(a, b)| whole || a != b);
        let residuals = said.map(|(a, b)| second[a][b].clone() - sums[a][b].clone());
        let residuals: Vec<Fraction> = residuals.collect();
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        let components = if whole { 0..6 } else { 3..6 };
        let preferred = components.map(|component| self.theory.atoms.part(inertia, component, 0));
        let preferred: Vec<Variable> = preferred.collect();
        let premise = Premise {
            name: LAW.to_owned(),
            residuals,
            preferred,
            definition: false,
        };
        self.take_from_words(premise, span);
    }

    /// Σ m x_a x_b.
    fn second_sums(&mut self, masses: &[PointMass]) -> Option<[[Fraction; 3]; 3]> {
        let zero = Fraction::zero;
        let mut sums: [[Fraction; 3]; 3] = std::array::from_fn(|_| [zero(), zero(), zero()]);
        for (mass, place) in masses {
            let mass = self.lowering(Frame::Moving).scalar(mass)?;
            let place = self.lowering(Frame::Moving).value(place).ok();
            let place = place.filter(Value::is_vector)?.entries;
            for a in 0..3 {
                for b in a..3 {
                    sums[a][b] += mass.clone() * place[a].clone() * place[b].clone();
                }
            }
        }
        Some(sums)
    }
}

/// The masses of the first sentence that has places of masses in it, and where the last of them stands.
fn point_masses(document: &Document) -> Option<(Vec<PointMass>, Span)> {
    let mut said = Masses::default();
    let mut words = String::new();
    for item in &document.items {
        match item {
            Item::Prose { text, .. } => {
                for part in text.split_inclusive(['.', ';']) {
                    words.push_str(&part.to_lowercase());
                    said.count = number(&words).or(said.count);
                    if part.ends_with(['.', ';']) {
                        if said.places.len() > 1 {
                            return said.paired();
                        }
                        said.places.clear();
                        words.clear();
                    }
                }
            }
            Item::Formula(formula) => match expression(formula) {
                Some(node) if is_mass(node) => said.hear_mass(node),
                Some(node)
                    if is_place(node)
                        && !said.listed.is_empty()
                        && has_any(&words, &[" at ", "mass"]) =>
                {
                    let listed = said.listed.clone();
                    let all = places(node).into_iter();
                    said.places.extend(all.map(|place| (listed.clone(), place)));
                    said.last = formula.span;
                }
                _ if said.places.len() > 1 => return said.paired(),
                _ => words.clear(),
            },
            Item::Heading { .. } => {
                words.clear();
                said.places.clear();
            }
            Item::Break | Item::Comment { .. } => {}
        }
    }
    None
}

/// The masses that words list, and the places that they give them.
#[derive(Default)]
struct Masses<'d> {
    /// The masses that stand before the places.
    listed: Vec<&'d Node>,
    /// Each place, with the masses before it.
    places: Vec<(Vec<&'d Node>, Node)>,
    /// How many there are by the words.
    count: Option<usize>,
    last: Span,
}

impl<'d> Masses<'d> {
    fn hear_mass(&mut self, mass: &'d Node) {
        let behind_places = self
            .places
            .last()
            .is_some_and(|(listed, _)| *listed == self.listed);
        if behind_places {
            self.listed.clear();
        }
        self.listed.push(mass);
    }

    /// Each mass with its place: one for all, one before each, or as many as there are places, one after the other.
    fn paired(self) -> Option<(Vec<PointMass>, Span)> {
        let several = self.count.filter(|count| *count != self.places.len());
        let in_turn = self
            .places
            .iter()
            .all(|(listed, _)| listed.len() == self.places.len());
        let one_each = self.places.iter().all(|(listed, _)| listed.len() == 1);
        if several.is_some() || !in_turn && !one_each {
            return None;
        }
        let places = self.places.into_iter().enumerate();
        let masses = places.map(|(at, (listed, place))| {
            let mass = if one_each { listed[0] } else { listed[at] };
            (mass.clone(), place)
        });
        Some((masses.collect(), self.last))
    }
}

/// How many masses a text says that there are, the last number in it.
fn number(text: &str) -> Option<usize> {
    let mut words = text.split(|c: char| !c.is_alphabetic()).rev();
    words.find_map(|word| {
        NUMBERS
            .iter()
            .find(|(name, _)| *name == word)
            .map(|(_, n)| *n)
    })
}

/// The places of a tuple: with ± before some of its entries, one for every choice of the signs.
fn places(node: &Node) -> Vec<Node> {
    let Kind::Tuple(entries) = &inner(node).kind else {
        return vec![];
    };
    let mut all: Vec<Vec<Node>> = vec![vec![]];
    for entry in entries {
        let signed = match &entry.kind {
            Kind::PlusMinus(inside) => {
                let negative = Node {
                    kind: Kind::Negate(inside.clone()),
                    span: entry.span,
                };
                vec![(**inside).clone(), negative]
            }
            _ => vec![entry.clone()],
        };
        let with = |place: &Vec<Node>| {
            let place = place.clone();
            signed.iter().map(move |entry| {
                let mut place = place.clone();
                place.push(entry.clone());
                place
            })
        };
        all = all.iter().flat_map(with).collect();
    }
    let tuple = |entries| Node {
        kind: Kind::Tuple(entries),
        span: node.span,
    };
    all.into_iter().map(tuple).collect()
}

fn expression(formula: &Formula) -> Option<&Node> {
    match formula.rows.as_slice() {
        [Row::Expression(node)] => Some(node),
        _ => None,
    }
}

/// `m`, `2m`, `m_1`.
fn is_mass(node: &Node) -> bool {
    let met = symbols(node);
    !met.is_empty() && met.iter().all(|s| matches!(s.name.as_str(), "m" | "M"))
}

/// `(r, 0, -a)`.
fn is_place(node: &Node) -> bool {
    let running = |node: &Node| {
        symbols(node)
            .iter()
            .any(|s| s.subscripts.contains(&"i".to_owned()))
    };
    matches!(&inner(node).kind, Kind::Tuple(entries) if entries.len() == 3) && !running(node)
}
