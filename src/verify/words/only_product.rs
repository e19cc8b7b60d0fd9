//! "The only product of inertia is ⟨E = ∫xz dm⟩": the other two vanish.

use crate::notation::ast::Node;
use crate::notation::document::{Formula, Row};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::axes;
use crate::verify::values::quantity::Quantity;
use crate::verify::words::book::{has_any, lowered};
use crate::verify::words::prose::Said;
use num_traits::Zero;
use std::collections::BTreeSet;

const ONLY: &[&str] = &[
    "only product of inertia",
    "only non-zero product",
    "only nonzero product",
    "only non-vanishing product",
    "only nonvanishing product",
    "single product of inertia",
    "one product of inertia",
    "the other products of inertia vanish",
];

/// What has a plane of symmetry through its longitudinal axis, unless the document says otherwise.
const AIRCRAFT: &[&str] = &["aircraft", "aeroplane", "airplane", "airframe", "glider"];

/// A plane of symmetry without a name.
const UNNAMED: &[&str] = &[
    "has a plane of symmetry",
    "has one plane of symmetry",
    "with a plane of symmetry",
    "with one plane of symmetry",
    "having a plane of symmetry",
];

impl Checker<'_> {
    /// Takes in that a body with a plane of symmetry that no word names, as an aircraft has one along x and z, has no
    /// product of inertia but the one that the document writes.
    pub(crate) fn note_unnamed_plane(&mut self, span: Span) {
        let taken = self
            .theory
            .premises()
            .iter()
            .any(|p| p.residuals.len() == 2 && p.name.contains("plane of symmetry"));
        if taken || !self.text.says(AIRCRAFT) && !self.text.says(UNNAMED) {
            return;
        }
        let Some((a, b)) = self.sole_written_product() else {
            return;
        };
        if (a, b) == (0, 2) || self.text.says(UNNAMED) {
            self.take(Said::OnlyProduct(a, b), span);
        }
    }

    /// The axes of the product of inertia that the document writes alone.
    fn sole_written_product(&self) -> Option<(u8, u8)> {
        let reading = &self.reading;
        let inertia = reading.quantities.iter();
        let inertia = inertia.filter(|(_, q)| **q == Quantity::Inertia);
        let met = inertia
            .filter_map(|(letter, _)| reading.usage.subscripts.get(letter))
            .flatten();
        let products = met.filter_map(|index| {
            let (a, b) = axes(index)?;
            (a != b).then_some((a.min(b), a.max(b)))
        });
        let products: BTreeSet<(u8, u8)> = products.collect();
        let mut products = products.into_iter();
        products.next().filter(|_| products.next().is_none())
    }

    /// Takes in that the formula behind such words, the first of its sentence, is the only product of inertia.
    pub(crate) fn note_only_product(&mut self, formula: &Formula) {
        let clause = self.sentence.rsplit(['⟩', '.', ';']).next();
        if clause.is_some_and(|clause| has_any(&lowered(clause), ONLY)) {
            let sides: Vec<&Node> = match formula.rows.as_slice() {
                [Row::Expression(node)] => vec![node],
                [Row::Line(line)] => line.sides.iter().rev().collect(),
                _ => return,
            };
            self.only_product(&sides, formula.span);
        }
    }

    /// The same of the formula before "… is the only product of inertia".
    pub(crate) fn note_called_only_product(&mut self, words: &str, span: Span) {
        let clause = words.split(['.', ';', ',']).next().unwrap_or_default();
        if clause.trim_start().starts_with("is ")
            && has_any(clause, ONLY)
            && let [one] = self.named.clone().as_slice()
        {
            self.only_product(&[one], span);
        }
    }

    fn only_product(&mut self, named: &[&Node], span: Span) {
        let component = named.iter().find_map(|node| self.product_of_inertia(node));
        if let Some((a, b)) = component.map(|c| [(0, 1), (0, 2), (1, 2)][usize::from(c) - 3]) {
            self.take(Said::OnlyProduct(a, b), span);
        }
    }

    /// The component of the tensor that an expression is, with either sign, if that is a product of inertia.
    pub(crate) fn product_of_inertia(&mut self, node: &Node) -> Option<u8> {
        let value = self.lowering(Frame::Moving).value(node).ok()?;
        let [entry] = value.entries.as_slice() else {
            return None;
        };
        let entry = self.theory.normal(entry);
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        (3..6).find(|&c| {
            let product = self.theory.atoms.value(inertia, c, 0);
            let product = self.theory.normal(&product);
            !product.is_zero() && (entry == product || entry == -product)
        })
    }
}
