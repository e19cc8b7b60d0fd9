//! Letters that are told by more than one noun: vectors, operators, principal moments.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::notation::ast::{Kind, Node};
use crate::verify::language::statement::{
    Declaration, Extent, Formula, NounPhrase, Slot, Statement, Term, slot,
};
use crate::verify::model::atoms::whole;
use crate::verify::model::contact::Round;
use crate::verify::model::system::FrameId;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::{UNIT_VECTOR, is_letter, name_of_formula, node_of, told};
use crate::verify::term::indices::{LABELS, with_number};
use crate::verify::term::letters::{Mark, Meaning, spelled};
use crate::verify::term::quantity::{Quantity, Spot};
use crate::verify::term::symbols::symbol_node;
use crate::verify::term::value::{Basis, Shape, Value};
use num_traits::Zero;

impl Builder<'_> {
    /// "`$p_j$` is a unit vector fixed in B", where j numbers things: by it they may be placed.
    pub(super) fn name_vectors_of_members(&mut self) {
        let turns = self
            .declarations
            .iter()
            .filter_map(|d| d.statement.does("turn"));
        let about = turns.filter_map(|(_, slots)| slot(slots, Slot::About));
        let axes: Vec<&Term> = about.collect();
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            let along = what.slot(Slot::Along).or(what.slot(Slot::To));
            if what.head != UNIT_VECTOR || along.is_some() {
                continue;
            }
            // What is not said to be fixed in one frame moves.
            let Some(carried) = what.slot(Slot::FixedIn).and_then(|term| self.frame(term)) else {
                continue;
            };
            // What a member turns about is told where its turn is.
            let subjects = subjects.iter().filter(|subject| !axes.contains(subject));
            let subjects: Vec<Term> = subjects.cloned().collect();
            for formula in formulas(&subjects) {
                let unit = self.unit_vector_of(formula, Some(carried));
                if matches!(unit, Quantity::MemberVector { .. }) {
                    self.denote(formula, Meaning::Quantity(unit), declaration);
                }
            }
        }
    }

    /// "z is the unit vector along the angular momentum", of an axis by its name.
    fn read_axes_along(&mut self, subjects: &[Term], along: &Quantity, declaration: &Declaration) {
        for name in subjects.iter().filter(|s| matches!(s, Term::Name(_))) {
            let Some((frame, axis)) = self.axis_of_frame(name) else {
                continue;
            };
            let axis = Quantity::Axis(frame, axis);
            if axis != *along && self.hold_parallel(&axis, along, declaration).is_none() {
                self.say_unused(declaration);
            }
        }
    }

    pub(super) fn read_vectors(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        let carried = what.slot(Slot::FixedIn).and_then(|term| self.frame(term));
        if self.names_known_axis(subjects, what) {
            return;
        }
        let Some(along) = self.said_direction(what, declaration) else {
            return self.say_unused(declaration);
        };
        if let Some(along) = &along {
            self.read_axes_along(subjects, along, declaration);
        }
        for formula in formulas(subjects) {
            let carried = carried.or_else(|| self.said_fixed(formula));
            // Where a frame turns about it, that sentence has told more.
            let known = self.quantity_of(formula, declaration);
            // An axis is a unit vector.
            let everywhere = declaration.extent == Extent::Document && along.is_none();
            let told = self.is_axis_of_attitude(formula)
                || matches!(known, Some(Quantity::MemberVector { .. }))
                || matches!(known, Some(Quantity::Axis(..)))
                    && everywhere
                    && what.head == UNIT_VECTOR
                || matches!(known, Some(Quantity::UnitVector { carried: k, .. }) if carried.is_none() || k == carried);
            let on = what.slot(Slot::On).and_then(|term| self.frame(term));
            if told {
                if let (Some(unit @ Quantity::UnitVector { .. }), Some(along)) = (&known, &along)
                    && what.head == UNIT_VECTOR
                {
                    self.hold_direction(unit, along, declaration);
                }
                self.put_on_axes(formula, known, on, declaration);
                continue;
            }
            // A letter that another sentence makes an axis is no vector of its own.
            if along.is_none() && self.axes.get(&name_of_formula(formula)).is_some() {
                self.say_unused(declaration);
                continue;
            }
            // The axis of a turn is told by where it leads as well.
            if let (Some(axis @ Quantity::Axis(..)), Some(along)) = (&known, &along)
                && what.head == UNIT_VECTOR
                && self.hold_parallel(axis, along, declaration).is_some()
            {
                continue;
            }
            let quantity = self.new_vector(formula, what.head, along.as_ref(), carried);
            let quantity = on_axes(quantity, on);
            self.denote(formula, Meaning::Quantity(quantity), declaration);
        }
    }

    /// "`$u$` is a unit vector in components on N", of which another sentence has told what turns about it.
    fn put_on_axes(
        &mut self,
        letter: &Formula,
        known: Option<Quantity>,
        on: Option<FrameId>,
        declaration: &Declaration,
    ) {
        if let (Some(known @ Quantity::UnitVector { .. }), Some(frame)) = (known, on) {
            let on = Quantity::On(known.boxed(), frame);
            self.denote(letter, Meaning::Quantity(on), declaration);
        }
    }

    pub(super) fn size_of(&mut self, vector: &Quantity) -> Option<Fraction> {
        let size = Quantity::Magnitude(vector.clone().boxed());
        self.system().value_of(&size).ok()?.to_scalar().ok()
    }

    fn hold_parallel(
        &mut self,
        axis: &Quantity,
        along: &Quantity,
        declaration: &Declaration,
    ) -> Option<()> {
        if matches!(along, Quantity::Axis(..)) {
            return None;
        }
        let axis = self.system().value_of(axis).ok()?.to_vector().ok()?;
        let along = self.system().value_of(along).ok()?.to_vector().ok()?;
        if !self.is_placed_along(&axis, &along, declaration) {
            self.hold_zero(&mechanics::cross(&axis, &along), declaration);
        }
        Some(())
    }

    /// Along what a vector is said to be: `Some(None)` where nothing is said, `None` where it is not understood.
    fn said_direction(
        &mut self,
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Option<Quantity>> {
        let between = what.slot(Slot::From).is_some() && what.slot(Slot::To).is_some();
        let ends_said = what.slot(Slot::From).is_some() || what.slot(Slot::To).is_some();
        Some(match what.slot(Slot::Along).cloned() {
            // "along the rod from A to B": what it is along has no sense of its own.
            Some(_) if !between && ends_said => return None,
            Some(line) if between => {
                self.body(&line)?;
                Some(self.way_between(what)?)
            }
            None if what.slot(Slot::To).is_some() => Some(self.way_between(what)?),
            None if what.slot(Slot::With).is_some() => Some(self.normal_of_shape(what)?),
            // Of a vector that no sentence tells it is only said that it has a direction.
            Some(term @ Term::Formula(_)) => self.operand(&term, declaration),
            Some(name @ Term::Name(_)) if what.slot(Slot::Of).is_some() => {
                let (frame, axis) = self.axis_said(what, &name)?;
                Some(Quantity::Axis(frame, axis))
            }
            Some(term) => Some(self.direction_named(&term, declaration)?),
            None => None,
        })
    }

    /// "the unit vector from O to G": along the position of the one from the other.
    fn way_between(&mut self, what: &NounPhrase) -> Option<Quantity> {
        let from = what.slot(Slot::From).and_then(|term| self.point(term))?;
        let to = what.slot(Slot::To).and_then(|term| self.point(term))?;
        Some(Quantity::Position {
            of: Spot::Point(to),
            from,
        })
    }

    /// "the unit vector perpendicular to the plane of the ring": along the axis about which that is round.
    fn normal_of_shape(&self, what: &NounPhrase) -> Option<Quantity> {
        let across = match what.slot(Slot::With)? {
            Term::Phrase(plane) if plane.head == "plane" => plane.slot(Slot::Of)?,
            _ => return None,
        };
        let body = &self.reading.system.bodies[self.body(across)?];
        match (&body.round, body.frame) {
            (Some(Round::Rim { axis, .. }), Some(frame)) => Some(Quantity::Axis(frame, *axis)),
            _ => None,
        }
    }

    /// What a unit vector is along: an axis, or a vector by its letter.
    fn direction_named(&mut self, term: &Term, declaration: &Declaration) -> Option<Quantity> {
        match self.operand(term, declaration) {
            Some(along) => Some(along),
            None => self.axis_quantity(term, declaration),
        }
    }

    /// A constant whose square is −1.
    pub(super) fn read_imaginary_unit(&mut self, subjects: &[Term], declaration: &Declaration) {
        for formula in formulas(subjects) {
            let unit = Quantity::Scalar {
                text: formula.source.clone(),
                constant: true,
            };
            let value = self.system().value_of(&unit);
            self.denote(formula, Meaning::Quantity(unit), declaration);
            if let Some(unit) = value.ok().and_then(|value| value.to_scalar().ok()) {
                self.hold(unit.clone() * unit + whole(1), declaration);
            }
        }
    }

    /// What vanishes where a value is constant: a vector is so in the inertial frame. A reference value stands for those of
    /// the components.
    pub(super) fn rates_of_constant(&mut self, formula: &Formula, value: &Value) -> Vec<Fraction> {
        if self.is_reference(formula) {
            let atoms = &mut self.system().atoms;
            let rates = value.entries.iter().map(|entry| atoms.derivative(entry));
            return rates.collect();
        }
        let ground = self.reading.system.ground;
        let rate = self.system().rate_of_value(value, ground);
        rate.map_or(vec![], |rate| rate.entries.into_iter().collect())
    }

    /// "`c_\phi` and `s_\phi` are the cosine and the sine of `\phi`."
    pub(super) fn read_kernels(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        let angles: Vec<Term> = what.all(Slot::Of).cloned().collect();
        for (formula, angle) in formulas(subjects).zip(angles) {
            let Some(angle) = self.scalar_term(&angle, declaration) else {
                continue;
            };
            let Some((cosine, sine)) = self.system().atoms.cosine_sine(&angle) else {
                continue;
            };
            let value = match what.head {
                "cosine" => cosine,
                "sine" => sine,
                _ => sine / cosine,
            };
            let known = Quantity::Known(Value::scalar(value));
            self.denote(formula, Meaning::Quantity(known), declaration);
        }
    }

    /// "A, A, C are the principal moments of the top about O on B": the products vanish, and A is two moments.
    pub(super) fn read_principal_moments(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        let tensor = match what.slot(Slot::Of) {
            Some(Term::Formula(formula))
                if is_letter(formula) && self.quantity_of(formula, declaration).is_none() =>
            {
                return self.read_moments_of_letter(formula);
            }
            Some(Term::Formula(formula)) => {
                self.operand(&Term::Formula(formula.clone()), declaration)
            }
            _ => self.whole_of(what).and_then(|of| {
                let about = self.about(what, &of)?;
                Some(Quantity::Inertia { of, about })
            }),
        };
        let customary = self.reading.letters.component_frame;
        let frame = told(what.slot(Slot::On), customary, |t| self.frame(t));
        let (Some(tensor), Some(frame)) = (tensor, frame) else {
            return self.say_unused(declaration);
        };
        self.read_diagonal(subjects, &tensor, frame, declaration);
        for (row, column) in [(0, 1), (0, 2), (1, 2)] {
            let zero = Quantity::Known(Value::scalar(Zero::zero()));
            let product = entry_of(&tensor, row, column, frame);
            self.hold_quantities(&product, &zero, declaration);
        }
    }

    /// The entries of a tensor on its diagonal, by their order; one letter for two of them says that these are equal.
    fn read_diagonal(
        &mut self,
        subjects: &[Term],
        tensor: &Quantity,
        on: FrameId,
        declaration: &Declaration,
    ) {
        let mut seen: Vec<(String, usize)> = vec![];
        let told: Vec<Formula> = match subjects {
            [Term::Formula(indexed)] => self.each_of_axes(indexed),
            _ => formulas(subjects).take(3).cloned().collect(),
        };
        // Of fewer letters it is not known to which axes they belong.
        if told.len() < 3 {
            return self.say_unused(declaration);
        }
        for (axis, formula) in told.iter().enumerate() {
            let spelled = node_of(formula).map(spelled).unwrap_or_default();
            let own = entry_of(tensor, axis, axis, on);
            match seen.iter().find(|(s, _)| *s == spelled) {
                Some(&(_, first)) => {
                    let first = entry_of(tensor, first, first, on);
                    self.hold_quantities(&first, &own, declaration);
                }
                None => self.denote(formula, Meaning::Quantity(own), declaration),
            }
            seen.push((spelled, axis));
        }
    }

    /// "`$I_i$`", where `$i$` numbers axes: `$I_1$`, `$I_2$` and `$I_3$`; another letter is alone.
    fn each_of_axes(&self, indexed: &Formula) -> Vec<Formula> {
        let node = node_of(indexed).map(|node| &node.kind);
        match (node, self.index_of_axes(indexed)) {
            (Some(Kind::Symbol(symbol)), Some(_)) => {
                let each = LABELS[0].into_iter();
                each.map(|number| Formula::of(&symbol_node(&with_number(symbol, number))))
                    .collect()
            }
            _ => vec![indexed.clone()],
        }
    }

    /// "`$A$`, `$B$`, `$C$` are the moments of inertia of the body about the axes of B through G": one for each axis.
    pub(super) fn read_moments_about_axes(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let (of, about) = (self.whole_of(what)?, what.slot(Slot::About)?);
        let frame = match about {
            Term::Phrase(axes) if axes.head == "axes" => {
                axes.slot(Slot::Of).or(axes.slot(Slot::FixedIn))
            }
            Term::Phrase(_) => None,
            _ => what.slot(Slot::On),
        };
        let frame = self.frame(frame?)?;
        let tensor = Quantity::Inertia {
            about: self.about(what, &of)?,
            of,
        };
        self.read_diagonal(subjects, &tensor, frame, declaration);
        Some(())
    }

    /// Principal moments of a tensor that a line defines: their labels number its axes.
    pub(super) fn read_moments_of_letter(&mut self, formula: &Formula) {
        let Some(node) = node_of(formula) else { return };
        let shape = Shape {
            rows: 3,
            columns: 3,
            basis: [Basis::Itself; 2],
        };
        self.reading
            .shapes
            .insert(crate::notation::print::latex(node), shape);
    }
}

/// An entry of a tensor on a frame.
pub(super) fn entry_of(tensor: &Quantity, row: usize, column: usize, on: FrameId) -> Quantity {
    Quantity::Entry {
        of: tensor.clone().boxed(),
        row,
        column,
        on,
        integral: false,
    }
}

/// The mark of a letter: `\hat v`, `\tilde v`.
pub(super) fn mark_on(node: &Node) -> Option<Mark> {
    match &node.kind {
        Kind::Symbol(symbol) if symbol.style.hat => Some(Mark::Hat),
        Kind::Symbol(symbol) if symbol.style.tilde => Some(Mark::Tilde),
        _ => None,
    }
}

/// A vector, or its components on a frame where one is said.
fn on_axes(vector: Quantity, frame: Option<FrameId>) -> Quantity {
    match frame {
        Some(frame) => Quantity::On(vector.boxed(), frame),
        None => vector,
    }
}
