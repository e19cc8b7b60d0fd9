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

/// A mass and its place.
pub(crate) type PointMass<'d> = (&'d Node, &'d Node);

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
        let whole = self.text.says(ALONE);
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
    fn second_sums(&mut self, masses: &[PointMass<'_>]) -> Option<[[Fraction; 3]; 3]> {
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
fn point_masses(document: &Document) -> Option<(Vec<PointMass<'_>>, Span)> {
    let (mut mass, mut words) = (None, String::new());
    let (mut found, mut last) = (vec![], None);
    for item in &document.items {
        match item {
            Item::Prose { text, .. } => {
                for part in text.split_inclusive(['.', ';']) {
                    words.push_str(&part.to_lowercase());
                    if part.ends_with(['.', ';']) {
                        if found.len() > 1 {
                            return Some((found, last?));
                        }
                        found.clear();
                        words.clear();
                    }
                }
            }
            Item::Formula(formula) => match (expression(formula), mass) {
                (Some(node), _) if is_mass(node) => mass = Some(node),
                (Some(node), Some(mass))
                    if is_place(node) && has_any(&words, &[" at ", "mass"]) =>
                {
                    found.push((mass, node));
                    last = Some(formula.span);
                }
                _ if found.len() > 1 => return Some((found, last?)),
                _ => words.clear(),
            },
            Item::Heading { .. } => {
                words.clear();
                found.clear();
            }
            Item::Break | Item::Comment { .. } => {}
        }
    }
    None
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
