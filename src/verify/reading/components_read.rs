//! Components of vectors: by their letters, by an index, along an axis, or as an array.

use crate::notation::ast::Kind;
use crate::notation::document::Row;
use crate::notation::print::latex;
use crate::verify::language::heads::{FORCE, MOMENT, WEIGHT};
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Term};
use crate::verify::model::system::FrameId;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::named_loads_read::names_load;
use crate::verify::reading::names::{index_letter, node_of};
use crate::verify::term::indices::{LABELS, with_number};
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::symbols::symbol_node;

impl Builder<'_> {
    /// "P, Q, R are the components of ω on B."
    pub(super) fn read_components(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        let what = &self.axes_behind_load(what);
        let frame = what.slot(Slot::On).and_then(|term| self.frame(term));
        let of = what.slot(Slot::Of).cloned();
        let of = of.and_then(|term| self.operand(&term, declaration));
        let Some(of) = of.filter(|of| !self.is_scalar(of)) else {
            return self.say_unused(declaration);
        };
        if let Quantity::Known(value) = &of
            && value.is_quaternion()
        {
            return self.read_entries_of_quaternion(subjects, value, declaration);
        }
        let frame = frame
            .or(of.frame())
            .unwrap_or(self.reading.letters.component_frame);
        let which = what.slot(Slot::Which);
        if let Some(Term::Formula(index)) = which {
            return self.read_indexed_component(subjects, index, &of, frame, declaration);
        }
        let single = which.and_then(|term| self.number_of_axis(term));
        if let (Some(along), [Term::Formula(formula)]) = (what.slot(Slot::Along).cloned(), subjects)
        {
            let Some(axis) = self.axis_quantity(&along, declaration) else {
                return self.say_unused(declaration);
            };
            let of = of.boxed();
            let quantity = Quantity::Along {
                of,
                axis: axis.boxed(),
            };
            return self.denote(formula, Meaning::Quantity(quantity), declaration);
        }
        if let (None, [Term::Formula(formula)]) = (single, subjects)
            && node_of(formula).is_some_and(|node| matches!(node.kind, Kind::Symbol(_)))
        {
            let array = Quantity::On(of.boxed(), frame);
            return self.denote(formula, Meaning::Quantity(array), declaration);
        }
        for (place, subject) in subjects.iter().take(3).enumerate() {
            let axis = single.unwrap_or(place);
            if let Term::Formula(formula) = subject {
                let quantity = Quantity::Component {
                    of: of.clone().boxed(),
                    axis,
                    on: frame,
                };
                self.denote(formula, Meaning::Quantity(quantity), declaration);
            }
        }
    }

    /// "the components of the thrust on B": a load is on a body, and what is a frame alone are the axes of the components.
    fn axes_behind_load(&self, what: &NounPhrase) -> NounPhrase {
        let mut what = what.clone();
        if let (None, Some(Term::Phrase(load))) = (what.slot(Slot::On), what.slot(Slot::Of))
            && (names_load(load) || matches!(load.head, FORCE | MOMENT | WEIGHT))
            && let Some(upon) = load.slot(Slot::Of)
            && self.body(upon).is_none()
            && self.frame(upon).is_some()
        {
            let (axes, mut load) = (upon.clone(), load.clone());
            load.slots.retain(|(slot, _)| *slot != Slot::Of);
            what.slots.retain(|(slot, _)| *slot != Slot::Of);
            let split = [(Slot::Of, Term::Phrase(load)), (Slot::On, axes)];
            what.slots.extend(split);
        }
        what
    }

    /// "`$L_i$` is the component `$i$` of `$\mathbf L$`", where `$i$` numbers axes: `$L_1$`, `$L_2$` and `$L_3$` are.
    fn read_indexed_component(
        &mut self,
        subjects: &[Term],
        index: &Formula,
        of: &Quantity,
        frame: FrameId,
        declaration: &Declaration,
    ) {
        let index = index_letter(index);
        let mut rules = self.reading.letters.indices.iter();
        let numbers_axes = rules.any(|rule| rule.letter == index && rule.axes_of.is_some());
        for formula in formulas(subjects).filter(|_| numbers_axes) {
            let Some(Kind::Symbol(symbol)) = node_of(formula).map(|node| &node.kind) else {
                continue;
            };
            if symbol.subscripts.last() != Some(&index) {
                continue;
            }
            for (axis, number) in LABELS[0].into_iter().enumerate() {
                let node = symbol_node(&with_number(symbol, number));
                let component = Quantity::Component {
                    of: of.clone().boxed(),
                    axis,
                    on: frame,
                };
                let numbered = Formula {
                    source: latex(&node),
                    row: Row::Expression(node),
                };
                self.denote(&numbered, Meaning::Quantity(component), declaration);
            }
        }
    }
}
