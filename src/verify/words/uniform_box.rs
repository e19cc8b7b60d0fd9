//! The moments of a uniform box: "with the edges ⟨a⟩, ⟨b⟩, ⟨c⟩ along ⟨x⟩, ⟨y⟩, ⟨z⟩", I_x = m(b² + c²)/12 and so on about its
//! centre (R. C. Hibbeler, *Engineering Mechanics: Dynamics*, inside back cover).

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::Symbol;
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::usage::axis;
use crate::verify::theory::Premise;
use crate::verify::values::atoms::variable_fraction;
use crate::verify::values::quantity::Quantity;
use crate::verify::words::sentences::{Paragraphs, sentences};
use num_traits::Zero;

/// The name of the law.
const LAW: &str = "the moments of a uniform box";
const BOXES: &[&str] = &["box", "cuboid", "block", "brick", "parallelepiped"];
const UNIFORM: &[&str] = &["uniform", "solid", "homogeneous"];
/// Words for points that are not the centre.
const OTHER_POINTS: &[&str] = &[
    "corner",
    "parallel axis",
    "parallel axes",
    "parallel-axis",
    "steiner",
    "pivot",
    "hinge",
];
const EDGES: &[&str] = &["edges", "sides", "edge lengths", "side lengths"];
const ALONG: &[&str] = &["along", "parallel to"];

impl Checker<'_> {
    /// Takes the law in, where words give the edges.
    pub(crate) fn take_uniform_box(&mut self) {
        let said = self.reading.points.is_none() && self.text.says(BOXES);
        if !said || !self.text.says(UNIFORM) || self.text.says(OTHER_POINTS) {
            return;
        }
        let Some((edges, span)) = self.edges_along_axes() else {
            return;
        };
        let edges = edges.map(|edge| self.value_of(&edge, span));
        let [Some(a), Some(b), Some(c)] = edges else {
            return;
        };
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        let mass = self.theory.atoms.quantity(Quantity::Mass);
        let mass = self.theory.atoms.value(mass, 0, 0);
        let squares = [a, b, c].map(|edge| edge.clone() * edge);
        let all = squares
            .iter()
            .fold(Fraction::zero(), |sum, s| sum + s.clone());
        let twelfth = Fraction::from_ratio(1, 12) * mass;
        let preferred: Vec<Variable> = (0..3)
            .map(|component| self.theory.atoms.part(inertia, component, 0))
            .collect();
        let moments = preferred.iter().zip(squares).map(|(&moment, own)| {
            variable_fraction(moment) - twelfth.clone() * (all.clone() - own)
        });
        let premise = Premise {
            name: LAW.to_owned(),
            residuals: moments.collect(),
            preferred,
            definition: false,
        };
        self.take_from_words(premise, span);
    }

    /// The edges along the three axes, where a sentence lists both.
    fn edges_along_axes(&self) -> Option<([Symbol; 3], Span)> {
        let all = sentences(self.document, Paragraphs::Joined);
        all.iter().find_map(|sentence| {
            let text = sentence.numbered();
            let edges = EDGES.iter().find_map(|word| text.split_once(*word))?.1;
            let (edges, axes) = ALONG.iter().find_map(|word| edges.split_once(*word))?;
            let symbols: Vec<&Symbol> = sentence.symbols().map(|(symbol, _)| symbol).collect();
            let listed = |text: &str| -> Vec<&Symbol> {
                let marks = text.split('⟨').skip(1);
                let places = marks.filter_map(|mark| mark.split_once('⟩')?.0.parse::<usize>().ok());
                places.filter_map(|at| symbols.get(at).copied()).collect()
            };
            let (edges, axes) = (listed(edges), listed(axes));
            let mut found = [None, None, None];
            for (edge, along) in edges.iter().zip(axes.iter().take(3)) {
                let along = axis(&along.name).filter(|_| along.subscripts.is_empty())?;
                *found.get_mut(usize::from(along))? = Some((*edge).clone());
            }
            let [Some(x), Some(y), Some(z)] = found else {
                return None;
            };
            let (_, span) = sentence.symbols().next()?;
            (edges.len() == 3).then_some(([x, y, z], span))
        })
    }
}
