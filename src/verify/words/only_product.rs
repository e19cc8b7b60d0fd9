//! "The only product of inertia is ⟨E = ∫xz dm⟩": the other two vanish.

use crate::notation::ast::Node;
use crate::notation::document::{Formula, Row};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::values::quantity::Quantity;
use crate::verify::words::book::{has_any, lowered};
use crate::verify::words::prose::Said;
use num_traits::Zero;

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

impl Checker<'_> {
    /// Takes in that an aircraft of which the document writes the product I_xz alone has no other.
    pub(crate) fn note_plane_of_aircraft(&mut self, span: Span) {
        let taken = self
            .theory
            .premises()
            .iter()
            .any(|p| p.residuals.len() == 2 && p.name.contains("plane of symmetry"));
        if taken || !self.text.says(AIRCRAFT) {
            return;
        }
        let usage = &self.reading.usage;
        let inertia = self
            .reading
            .quantities
            .iter()
            .filter(|(_, q)| **q == Quantity::Inertia);
        let met: Vec<&String> = inertia
            .filter_map(|(letter, _)| usage.subscripts.get(letter))
            .flatten()
            .collect();
        let has = |names: &[&str]| met.iter().any(|index| names.contains(&index.as_str()));
        if has(&["xz", "zx"]) && !has(&["xy", "yx", "yz", "zy"]) {
            self.take(Said::OnlyProduct(0, 2), span);
        }
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
