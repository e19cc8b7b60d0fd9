//! Directions: along what a term points, and what sentences tell of the letter of a unit vector.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::notation::ast::Kind;
use crate::verify::facts::premises::Facts;
use crate::verify::language::statement::{
    Declaration, Extent, Formula, NounPhrase, Slot, Statement, Term,
};
use crate::verify::model::atoms::whole;
use crate::verify::model::system::{FrameId, PointId, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::definitions_read::{defined_as, is_written_as};
use crate::verify::reading::frames_read::CUSTOMARY;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::{
    UNIT_VECTOR, is_letter, letter_of, name_of, opposite, reach_of,
};
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{Basis, Value};
use num_traits::Zero;

impl Builder<'_> {
    /// "`$u$` is the vector `$v$` in components on N"
    pub(super) fn read_same_vector(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        let Some(vector) = self.same_vector(what, declaration) else {
            return self.say_unused(declaration);
        };
        for formula in formulas(subjects) {
            self.denote(formula, Meaning::Quantity(vector.clone()), declaration);
        }
    }

    fn same_vector(&self, what: &NounPhrase, declaration: &Declaration) -> Option<Quantity> {
        let same = what.slot(Slot::Which).and_then(letter_of)?;
        let vector = self.quantity_of(same, declaration)?;
        Some(match what.slot(Slot::On) {
            Some(on) => Quantity::On(vector.boxed(), self.frame(on)?),
            None => vector,
        })
    }

    /// A vector that a sentence brings up: along what it is told to be, else one of its own.
    pub(super) fn new_vector(
        &mut self,
        letter: &Formula,
        head: &str,
        along: Option<&Quantity>,
        carried: Option<FrameId>,
    ) -> Quantity {
        let text = letter.source.clone();
        match (head, along) {
            ("vector", _) => Quantity::Vector { text, carried },
            (_, Some(axis @ Quantity::Axis(..))) => axis.clone(),
            (_, Some(along)) => match self.size_of(along) {
                Some(size) => Quantity::Scaled(along.clone().boxed(), whole(1) / size),
                None => Quantity::UnitVector { text, carried },
            },
            _ => Quantity::UnitVector { text, carried },
        }
    }

    /// The unit vector that a term names; one that only this sentence tells of is carried by a frame.
    pub(super) fn direction(
        &mut self,
        term: &Term,
        declaration: &Declaration,
        carried: Option<FrameId>,
    ) -> Option<Vector> {
        if let Some(name) = name_of(term)
            && let Some(&(frame, axis)) = self.axes.get(&name)
        {
            return Some(self.system().axis(frame, axis));
        }
        if let Some(opposite) = opposite(term) {
            return Some(-self.direction(&opposite, declaration, carried)?);
        }
        match term {
            Term::Phrase(phrase) if matches!(phrase.head, "axis" | "line") => {
                if let Some((frame, axis)) = self.axis_of_frame(term) {
                    return Some(self.system().axis(frame, axis));
                }
                if let Some(way) = self.way_through_two(phrase) {
                    return self.unit_of_any_length(way);
                }
                let along = phrase.slot(Slot::Along).or(phrase.slot(Slot::Which))?;
                self.direction(&along.clone(), declaration, carried)
            }
            Term::Phrase(phrase) if phrase.head == UNIT_VECTOR => self.direction_to_point(phrase),
            Term::Phrase(phrase) => self.direction_of_plane(phrase),
            Term::Formula(formula) => {
                if self.is_told(formula, declaration) || !is_letter(formula) {
                    let along = self.formula_value(formula, declaration)?.to_vector().ok()?;
                    return match is_sum(formula) {
                        true => self.unit_of_any_length(along),
                        false => self.unit_along(along),
                    };
                }
                if let Some((along, said)) = self.directed_elsewhere(formula) {
                    let along = self.formula_value(&along, said)?.to_vector().ok()?;
                    return self.fixed_direction(along, carried);
                }
                // An axis about which a frame turns is fixed in both.
                let unit = self.unit_vector_of(formula, carried);
                let meaning = Meaning::Quantity(unit.clone());
                let reach = reach_of(&declaration.extent);
                self.denote_within(formula, meaning, reach, declaration);
                self.system().value_of(&unit).ok()?.to_vector().ok()
            }
            Term::Name(name) if self.bodies.contains_key(name) => {
                let body = self.body(term)?;
                self.line_of(body)
            }
            Term::Name(name) => {
                let axis = CUSTOMARY
                    .iter()
                    .find_map(|names| names.iter().position(|n| n == name))?;
                let frame = self.reading.letters.component_frame;
                Some(self.system().axis(frame, axis))
            }
            _ => None,
        }
    }
}

impl Builder<'_> {
    /// "the axis through O and C": the way from the one point to the other, where it is told.
    fn way_through_two(&mut self, line: &NounPhrase) -> Option<Vector> {
        let points: Option<Vec<PointId>> = line
            .slots
            .iter()
            .map(|(slot, term)| self.point(term).filter(|_| *slot == Slot::Through))
            .collect();
        let points = points?;
        let [from, to] = points.as_slice() else {
            return None;
        };
        let way = self.system().position(*to, *from);
        let told = Value::vector(&way, Basis::Itself);
        self.reading.system.is_told(&told).then_some(way)
    }

    /// "the unit vector from Q to P", where the way is told.
    fn direction_to_point(&mut self, unit: &NounPhrase) -> Option<Vector> {
        let from = unit.slot(Slot::From).and_then(|term| self.point(term))?;
        let to = unit.slot(Slot::To).and_then(|term| self.point(term))?;
        let known = |(slot, _): &(Slot, Term)| matches!(slot, Slot::From | Slot::To);
        let way = self.system().position(to, from);
        let told = Value::vector(&way, Basis::Itself);
        let told = self.reading.system.is_told(&told) && unit.slots.iter().all(known);
        told.then(|| self.unit_of_any_length(way))?
    }

    /// A unit vector about which something turns points along what another sentence says, with its sense.
    pub(super) fn hold_direction(
        &mut self,
        unit: &Quantity,
        along: &Quantity,
        declaration: &Declaration,
    ) {
        let vector = |builder: &mut Self, of: &Quantity| {
            let value = builder.system().value_of(of).ok()?;
            (value.basis[0] != Basis::Written).then(|| value.to_vector().ok())?
        };
        let (Some(n), Some(way)) = (vector(self, unit), vector(self, along)) else {
            return self.say_unused(declaration);
        };
        let size = self.size_of(along);
        let apart = match size {
            Some(size) => n * size - way,
            None => mechanics::cross(&n, &way),
        };
        if !self.vanishes(&apart) {
            self.hold_zero(&apart, declaration);
        }
    }

    /// A letter of a unit vector that only sentences tell, of one thing or of each of many, and what carries it.
    pub(super) fn unit_vector_of(&self, letter: &Formula, carried: Option<FrameId>) -> Quantity {
        let text = letter.source.clone();
        let fixed = self.said_fixed(letter);
        let name = name_of(&Term::Formula(letter.clone()));
        let member = name.and_then(|name| {
            let (_, label) = name.split_once('_')?;
            Some(self.reading.system.index_in(label)?.1)
        });
        match member {
            Some(index) => Quantity::MemberVector {
                text,
                carried: fixed.or(carried),
                index,
            },
            None => Quantity::UnitVector {
                text,
                carried: carried.or(fixed),
            },
        }
    }

    /// The frame in which a sentence says that a vector is fixed.
    pub(super) fn said_fixed(&self, letter: &Formula) -> Option<FrameId> {
        let own = |subject: &Term| matches!(subject, Term::Formula(f) if f.source == letter.source);
        let says = |declaration: &&Declaration| match &declaration.statement {
            Statement::Is { subjects, .. } => {
                declaration.extent == Extent::Document && subjects.iter().any(own)
            }
            _ => false,
        };
        let mut said = self.declarations.iter().filter(says);
        said.find_map(|declaration| match &declaration.statement {
            Statement::Is { what, .. } => self.frame(what.slot(Slot::FixedIn)?),
            _ => None,
        })
    }
}

impl<'d> Builder<'d> {
    /// Along what another sentence tells a letter to be: "n is the unit vector along x + y", "`$n = x + y$`".
    pub(super) fn directed_elsewhere(
        &self,
        letter: &Formula,
    ) -> Option<(Formula, &'d Declaration)> {
        let own = |term: &Term| is_written_as(term, letter);
        let mut said = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == UNIT_VECTOR => {
                match what.slot(Slot::Along)? {
                    Term::Formula(along) if subjects.iter().any(own) => Some((along.clone(), d)),
                    _ => None,
                }
            }
            statement => Some((defined_as(letter, statement)?, d)),
        });
        said.find(|(along, _)| !is_letter(along))
    }

    /// A direction with the length one, which does not move in the frame that carries it.
    fn fixed_direction(&mut self, along: Vector, carried: Option<FrameId>) -> Option<Vector> {
        let unit = self.unit_along(along)?;
        let Some(frame) = carried else {
            return Some(unit);
        };
        let value = Value::vector(&unit, Basis::Itself);
        let rate = self.system().rate_of_value(&value, frame).ok()?;
        rate.entries.iter().all(Fraction::is_zero).then_some(unit)
    }

    /// A vector over its length, where that is a number.
    pub(super) fn unit_along(&mut self, along: Vector) -> Option<Vector> {
        self.over_length(along, |square| square.to_rational().is_some())
    }

    /// A vector over its length, which may be told by letters.
    fn unit_of_any_length(&mut self, along: Vector) -> Option<Vector> {
        self.over_length(along, |_| true)
    }

    fn over_length(
        &mut self,
        along: Vector,
        allowed: impl Fn(&Fraction) -> bool,
    ) -> Option<Vector> {
        let atoms = &mut self.reading.system.atoms;
        let square = Facts::default().normal(atoms, &along.dot(&along)).ok()?;
        let zero = square.to_rational().is_some_and(|number| number.is_zero());
        let length = atoms.root(&square).filter(|_| !zero && allowed(&square))?;
        Some(along / length)
    }
}

/// Whether a formula is a combination of others, whose length no sentence need tell.
fn is_sum(formula: &Formula) -> bool {
    let kind = formula.node().map(|node| &node.kind);
    matches!(kind, Some(Kind::Sum(_)))
}
