//! Components of vectors: by their letters, by an index, along an axis, or as an array.

use crate::notation::ast::{Kind, Node};
use crate::verify::language::heads::{FORCE, MOMENT, WEIGHT};
use crate::verify::language::statement::{
    Declaration, Extent, Formula, NounPhrase, Slot, Statement, Term,
};
use crate::verify::model::system::FrameId;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::named_loads_read::names_load;
use crate::verify::reading::names::{UNIT_VECTOR, index_letter, node_of, told};
use crate::verify::reading::no_loads_read::is_exception;
use crate::verify::reading::relations_read::is_tensor;
use crate::verify::term::indices::{LABELS, with_number};
use crate::verify::term::letters::{Meaning, spelled};
use crate::verify::term::quantity::Quantity;
use crate::verify::term::symbols::symbol_node;

/// Nouns of which a direction says what they are.
const DIRECTED: [&str; 3] = [UNIT_VECTOR, "vector", "part"];

impl Builder<'_> {
    /// What is of a letter follows it: where a part of the document has another meaning for the letter, its magnitude is
    /// that of the other.
    pub(super) fn read_where_letter_differs(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        let (Extent::Document, "magnitude" | "component" | "rate", Some(of)) =
            (&declaration.extent, what.head, what.slot(Slot::Of))
        else {
            return;
        };
        let writing = |term: &Term| match term {
            Term::Formula(formula) => node_of(formula).map(spelled),
            _ => None,
        };
        let (Some(letter), own) = (writing(of), subjects.iter().filter_map(writing)) else {
            return;
        };
        let own: Vec<String> = own.collect();
        let tells = |d: &Declaration, letters: &[String]| match &d.statement {
            Statement::Is { subjects, .. } => {
                let mut told = subjects.iter().filter_map(writing);
                told.any(|told| letters.contains(&told))
            }
            _ => false,
        };
        let letter = [letter];
        for other in self.declarations {
            let extent = &other.extent;
            let elsewhere = *extent != Extent::Document && tells(other, &letter);
            let mut there = self.declarations.iter().filter(|d| d.extent == *extent);
            if elsewhere && !there.any(|d| tells(d, &own)) {
                let there = Declaration {
                    extent: extent.clone(),
                    ..declaration.clone()
                };
                self.read_noun(subjects, what, &there);
            }
        }
    }

    /// "P, Q, R are the components of ω on B."
    pub(super) fn read_components(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        if what.all(Slot::Of).count() > 1 {
            return self.read_components_of_each(subjects, what, declaration);
        }
        let what = &without_inner_directions(&self.axes_behind_load(&exceptions_inside(what)));
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
            let index = index_letter(index);
            let letters = formulas(subjects);
            return letters.for_each(|letter| {
                self.read_indexed_component(letter, &index, &of, frame, declaration);
            });
        }
        let single = which.and_then(|term| self.number_of_axis(term));
        let along: Vec<Term> = what.all(Slot::Along).cloned().collect();
        if !along.is_empty() && along.len() == subjects.len() {
            for (subject, along) in subjects.iter().zip(&along) {
                self.read_component_along(subject, along, &of, declaration);
            }
            return;
        }
        if along.len() > 1 && subjects.len() == 1 {
            return self.say_unused(declaration);
        }
        if let (None, [Term::Formula(formula)]) = (single, subjects)
            && node_of(formula).is_some_and(is_letter)
        {
            return self.read_array(formula, of, frame, declaration);
        }
        // A tensor has more entries than three.
        if is_tensor(&of) {
            return self.say_unused(declaration);
        }
        self.tell_each(
            components_in_order(subjects, &of, single, frame),
            declaration,
        );
    }

    /// "`$u$` are the components of `$v$` on B": the array of them, or one for each value of an index.
    fn read_array(
        &mut self,
        formula: &Formula,
        of: Quantity,
        frame: FrameId,
        declaration: &Declaration,
    ) {
        match self.index_of_axes(formula) {
            Some(index) => self.read_indexed_component(formula, &index, &of, frame, declaration),
            None => {
                let array = Quantity::On(of.boxed(), frame);
                self.denote(formula, Meaning::Quantity(array), declaration);
            }
        }
    }

    /// Letters first, each once; what is made of them, and a letter that stands again, holds by what they are.
    fn tell_each(&mut self, entries: Vec<(&Formula, Quantity)>, declaration: &Declaration) {
        let mut told: Vec<&Formula> = vec![];
        let mut others = vec![];
        for (formula, quantity) in entries {
            let again = told.iter().any(|known| known.source == formula.source);
            if again || self.is_worked_out(formula, declaration) {
                others.push((formula, quantity));
            } else {
                told.push(formula);
                self.tell(formula, quantity, declaration);
            }
        }
        for (formula, quantity) in others {
            self.hold_formula_is(formula, &quantity, declaration);
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

    /// "the third component of `$v$` on B"
    pub(super) fn numbered_component(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let which: Vec<&Term> = phrase.all(Slot::Which).collect();
        let ([number], 1) = (which.as_slice(), phrase.all(Slot::Of).count()) else {
            return None;
        };
        let several = matches!(number, Term::Numbers(numbers) if numbers.len() != 1);
        let axis = self.number_of_axis(number).filter(|_| !several)?;
        let of = self.operand(phrase.slot(Slot::Of)?, declaration)?;
        let vector = self.vector_of(&of).is_some();
        let custom = of.frame().unwrap_or(self.reading.letters.component_frame);
        let on = told(phrase.slot(Slot::On), custom, |term| self.frame(term))?;
        vector.then(|| Quantity::Component {
            of: of.boxed(),
            axis,
            on,
        })
    }

    /// "`$v$` and `$a$` are the components along x of the velocity and the acceleration of P": one for each.
    fn read_components_of_each(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        let each: Vec<Term> = what.all(Slot::Of).cloned().collect();
        if each.len() != subjects.len() {
            return self.say_unused(declaration);
        }
        let whose = match each.last() {
            Some(Term::Phrase(last)) => last.slots.clone(),
            _ => vec![],
        };
        let beside = what.slots.iter().filter(|(slot, _)| *slot != Slot::Of);
        let beside: Vec<(Slot, Term)> = beside.cloned().collect();
        for (subject, mut of) in subjects.iter().zip(each) {
            // "the velocity and the acceleration of P": of P are both.
            if let Term::Phrase(phrase) = &mut of
                && phrase.slots.is_empty()
            {
                phrase.slots.clone_from(&whose);
            }
            let mut one = what.clone();
            one.slots = [vec![(Slot::Of, of)], beside.clone()].concat();
            self.read_components(std::slice::from_ref(subject), &one, declaration);
        }
    }

    fn read_component_along(
        &mut self,
        subject: &Term,
        along: &Term,
        of: &Quantity,
        declaration: &Declaration,
    ) {
        let (Term::Formula(formula), Some(axis)) =
            (subject, self.axis_quantity(along, declaration))
        else {
            return self.say_unused(declaration);
        };
        let along = Quantity::Along {
            of: of.clone().boxed(),
            axis: axis.boxed(),
        };
        self.tell(formula, along, declaration);
    }

    /// "`$\omega_i$` are the components of `$\omega$` on B": with a label that is the name of no frame.
    pub(super) fn is_indexed_vector(
        &self,
        formula: &Formula,
        subjects: &[Term],
        what: &NounPhrase,
    ) -> bool {
        let symbol = |node: Option<&Node>| match node.map(|node| &node.kind) {
            Some(Kind::Symbol(symbol)) => Some((symbol.name.clone(), symbol.subscripts.clone())),
            _ => None,
        };
        let (Some((own, labels)), Some(Term::Formula(of))) =
            (symbol(node_of(formula)), what.slot(Slot::Of))
        else {
            return false;
        };
        let of_itself = symbol(node_of(of)) == Some((own, vec![]));
        of_itself && subjects.len() == 1 && !labels.iter().any(|label| self.names_frame(label))
    }

    /// Whether a label is the name of a frame, in small letters.
    fn names_frame(&self, label: &str) -> bool {
        self.frames.keys().any(|name| name.to_lowercase() == label)
    }

    /// The index of "`$\omega_i$` are the components of `$\omega$`", where it numbers axes and names no frame.
    pub(super) fn index_of_axes(&self, formula: &Formula) -> Option<String> {
        let Kind::Symbol(symbol) = &node_of(formula)?.kind else {
            return None;
        };
        let index = symbol.subscripts.last()?;
        (self.numbers_axes(index) && !self.names_frame(index)).then(|| index.clone())
    }

    fn numbers_axes(&self, index: &str) -> bool {
        let mut rules = self.reading.letters.indices.iter();
        rules.any(|rule| rule.letter == index && rule.axes_of.is_some())
    }

    /// "`$L_i$` is the component `$i$` of `$\mathbf L$`", where `$i$` numbers axes: `$L_1$`, `$L_2$` and `$L_3$` are.
    fn read_indexed_component(
        &mut self,
        formula: &Formula,
        index: &str,
        of: &Quantity,
        frame: FrameId,
        declaration: &Declaration,
    ) {
        let Some(Kind::Symbol(symbol)) = node_of(formula).map(|node| &node.kind) else {
            return;
        };
        let indexed = symbol.subscripts.last().is_some_and(|last| last == index);
        if !indexed || !self.numbers_axes(index) {
            return;
        }
        for (axis, number) in LABELS[0].into_iter().enumerate() {
            let node = symbol_node(&with_number(symbol, number));
            let component = Quantity::Component {
                of: of.clone().boxed(),
                axis,
                on: frame,
            };
            let meaning = Meaning::Quantity(component);
            self.denote(&Formula::of(&node), meaning, declaration);
        }
    }
}

/// "the first and third components of `$v$`": each by its number.
pub(super) fn each_component(phrase: &NounPhrase) -> Option<Vec<NounPhrase>> {
    let which: Vec<&Term> = phrase.all(Slot::Which).collect();
    if phrase.head != "component" || which.len() < 2 {
        return None;
    }
    let rest = phrase.slots.iter().filter(|(slot, _)| *slot != Slot::Which);
    let rest: Vec<(Slot, Term)> = rest.cloned().collect();
    let each = which.into_iter().map(|number| {
        let own = (Slot::Which, number.clone());
        NounPhrase {
            slots: std::iter::once(own).chain(rest.clone()).collect(),
            ..phrase.clone()
        }
    });
    Some(each.collect())
}

/// "The components of the force on the body except the weight": it is left out of the force.
fn exceptions_inside(what: &NounPhrase) -> NounPhrase {
    let mut what = what.clone();
    let slots = std::mem::take(&mut what.slots).into_iter();
    let (left_out, mut rest): (Vec<_>, Vec<_>) = slots.partition(|(_, term)| is_exception(term));
    let load = rest.iter_mut().find_map(|(slot, term)| match term {
        Term::Phrase(load) if *slot == Slot::Of => Some(load),
        _ => None,
    });
    match load {
        Some(load) => load.slots.extend(left_out),
        None => rest.extend(left_out),
    }
    what.slots = rest;
    what
}

/// "The component of the velocity of P along x": the direction is that of the component, wherever it hangs.
fn without_inner_directions(what: &NounPhrase) -> NounPhrase {
    let mut outer = what.clone();
    if outer.slot(Slot::Along).is_some() || outer.slot(Slot::Which).is_some() {
        return outer;
    }
    let mut moved = vec![];
    for (slot, term) in &mut outer.slots {
        if let (Slot::Of, Term::Phrase(inner)) = (&slot, term)
            && !DIRECTED.contains(&inner.head)
        {
            let (along, rest) = std::mem::take(&mut inner.slots)
                .into_iter()
                .partition(|(slot, _)| *slot == Slot::Along);
            inner.slots = rest;
            moved.extend::<Vec<_>>(along);
        }
    }
    outer.slots.extend(moved);
    outer
}

/// Letters for the components of a vector in their order, or for a single one.
fn components_in_order<'t>(
    subjects: &'t [Term],
    of: &Quantity,
    single: Option<usize>,
    on: FrameId,
) -> Vec<(&'t Formula, Quantity)> {
    let component = |place: usize| Quantity::Component {
        of: of.clone().boxed(),
        axis: single.unwrap_or(place),
        on,
    };
    let all = subjects.iter().take(3).enumerate();
    let letters = all.filter_map(|(place, subject)| match subject {
        Term::Formula(formula) => Some((formula, component(place))),
        _ => None,
    });
    letters.collect()
}

/// A letter, also in brackets: "`[J]`".
fn is_letter(node: &Node) -> bool {
    match &node.kind {
        Kind::Symbol(_) => true,
        Kind::Group(_, inner) => is_letter(inner),
        _ => false,
    }
}
