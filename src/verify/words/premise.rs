//! Premises that nobody writes as a line: in words, by the letters that are used, by the kind of motion.

use crate::algebra::{Fraction, Proof, Variable};
use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::Document;
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::body::integrates_a_product;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, axes, axis, inner, symbols};
use crate::verify::lines::line::Read;
use crate::verify::theory::decide::{Decision, ROTOR_ALONE, decide};
use crate::verify::theory::law::Axes;
use crate::verify::theory::{Premise, Taken};
use crate::verify::values::atoms::Entity;
use crate::verify::values::atoms::{Atom, variable_fraction};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::words::book::lowered;
use crate::verify::words::prose::{Said, turns_to_numbered_axes};
use num_traits::Zero;
use std::collections::BTreeSet;

impl Checker<'_> {
    /// Takes in a premise that words set.
    pub(crate) fn take(&mut self, said: Said, span: Span) {
        // Of two sets of axes, the words do not tell which is principal.
        let numbered = turns_to_numbered_axes(&lowered(&self.sentence));
        let apart = self.reading.usage.has_primed_axes() && !numbered;
        if said == Said::Principal && numbered {
            self.leave_lettered_axes();
        }
        if said == Said::Principal && apart {
            return;
        }
        if said == Said::Principal && self.central_axes_are_principal(span) {
            return;
        }
        let name = said.words();
        let new = match said {
            // Beside axes with an angular velocity of their own, they are the other ones.
            Said::SpeaksOfBodyAxes if self.has_frame_rate() => false,
            Said::BodyAxes | Said::SpeaksOfBodyAxes => {
                let new = self.theory.setting.axes != Axes::Body;
                if new {
                    self.note_attached();
                    self.theory.set(|setting| setting.axes = Axes::Body);
                }
                new
            }
            Said::DotsOnBody => self.dots.replace(Frame::Moving) != Some(Frame::Moving),
            Said::DotsInSpace => self.dots.replace(Frame::Space) != Some(Frame::Space),
            Said::Principal
                if self.products_are_given()
                    || self.seeks_moments(span)
                    || self.seeks_angle(span) =>
            {
                false
            }
            Said::Principal => self.vanish(&name, Quantity::Inertia, &[3, 4, 5]),
            Said::SymmetryPlane(a, b) | Said::OnlyProduct(a, b) => {
                let across: Vec<u8> = (3..6).filter(|&c| c != product(a, b)).collect();
                self.vanish(&name, Quantity::Inertia, &across)
            }
            Said::Lamina(a, b) => self.is_flat_body(&name, a, b),
            Said::TorqueFree => self.vanish(&name, Quantity::Moment, &[0, 1, 2]),
        };
        if new {
            self.tell(span, name);
        }
    }

    /// Whether lines say of a product of inertia what it is: the principal axes that words speak of are other ones.
    fn products_are_given(&mut self) -> bool {
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        (3..6).any(|component| {
            let product = self.theory.atoms.value(inertia, component, 0);
            let normal = self.theory.normal(&product);
            normal != product && !normal.is_zero()
        })
    }

    /// A tensor that a line writes out with products of its own does not stand on the principal axes that words spoke of.
    pub(crate) fn note_written_products(&mut self, sides: &[Node]) {
        let [left, right] = sides else { return };
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        let tensor = match &inner(left).kind {
            Kind::Symbol(symbol) => self.meaning_of(symbol),
            _ => return,
        };
        if !matches!(tensor, Meaning::Whole(entity) if entity == inertia) {
            return;
        }
        let Ok(value) = self.lowering(Frame::Moving).value(right) else {
            return;
        };
        let written = |entry: &Fraction| {
            let variables = entry.variables();
            let mut entities = variables.iter().map(|&v| self.theory.atoms.entity_of(v));
            !entry.is_zero() && entities.all(|entity| entity != Some(inertia))
        };
        let off_diagonal = [1, 2, 5].into_iter().filter_map(|at| value.entries.get(at));
        if value.entries.len() == 9 && off_diagonal.into_iter().any(written) {
            let words = Said::Principal.words();
            self.theory.retain(|premise| premise.name != words);
        }
    }

    /// Assumes of a lamina that the moments about two axes in its plane make up the third, where nothing gives that yet.
    fn is_flat_body(&mut self, name: &str, a: u8, b: u8) -> bool {
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        let across = 3 - a - b;
        let [third, first, second] = [across, a, b].map(|c| self.theory.atoms.value(inertia, c, 0));
        if self.theory.normal(&third).as_variable().is_none() {
            return false;
        }
        let premise = Premise {
            name: name.to_owned(),
            residuals: vec![third - first - second],
            preferred: vec![self.theory.atoms.part(inertia, across, 0)],
            definition: false,
        };
        let new = self.theory.assume(premise) == Taken::Solved;
        if new {
            self.keep(name, true);
        }
        new
    }

    /// Whether the document gives the axes an angular velocity of their own.
    pub(crate) fn has_frame_rate(&self) -> bool {
        let mut quantities = self.reading.quantities.values();
        quantities.any(|&q| q == Quantity::FrameRate)
    }

    /// Assumes that components of a quantity are zero.
    pub(crate) fn vanish(&mut self, name: &str, quantity: Quantity, components: &[u8]) -> bool {
        let entity = self.theory.atoms.quantity(quantity);
        self.vanishes_in(name, entity, components)
    }

    /// Components of an entity vanish by words.
    pub(crate) fn vanishes_in(&mut self, name: &str, entity: Entity, components: &[u8]) -> bool {
        let residuals: Vec<Fraction> = components
            .iter()
            .map(|&c| self.theory.atoms.value(entity, c, 0))
            .collect();
        let preferred = components
            .iter()
            .map(|&c| self.theory.atoms.part(entity, c, 0))
            .collect();
        let premise = Premise {
            name: name.to_owned(),
            residuals,
            preferred,
            definition: false,
        };
        let taken = self.theory.assume(premise);
        let new = matches!(taken, Taken::Solved | Taken::Kept);
        // A tensor of which the document only writes the diagonal is on principal axes under every heading.
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        let lasts = entity == inertia && self.reading.writes_only_diagonal();
        if new && !lasts {
            self.scopes.push((name.to_owned(), self.level));
        }
        new
    }

    /// Whether equations hold with no moment, in a document that writes no moment or force anywhere; it is then assumed.
    pub(crate) fn proved_without_moment(&mut self, read: &Read, at: Span) -> Option<Proof> {
        let acts = |q: &Quantity| matches!(q, Quantity::Moment | Quantity::Force);
        let parts = self.reading.components.values().map(|(q, _)| q);
        let all: BTreeSet<&Quantity> = self.reading.quantities.values().chain(parts).collect();
        let acts = all.iter().any(|&q| acts(q)) || self.reading.brake.is_some();
        if acts || !all.contains(&Quantity::Inertia) {
            return None;
        }
        let name = "no moment is written anywhere: ΣM = 0".to_owned();
        if !self.theory.solution.relations.kept.is_empty() || !self.speaks_of_a_spin_rate(read) {
            return None;
        }
        if !self.vanish(&name, Quantity::Moment, &[0, 1, 2]) {
            return None;
        }
        // What no line of the document writes acts in none of its sections.
        self.scopes.retain(|(scope, _)| *scope != name);
        if let Decision::True(proof) = decide(&mut self.theory, &read.equations) {
            self.tell(at, name);
            return Some(proof);
        }
        self.theory.exhausted = false;
        self.theory.retain(|premise| premise.name != name);
        None
    }

    /// Whether a difference is that of an equation of motion: ω̇ is in it, and what multiplies it is no ω, as in a power.
    fn speaks_of_a_spin_rate(&mut self, read: &Read) -> bool {
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let entries: Vec<Fraction> = read.residuals().cloned().collect();
        let rests: Vec<Fraction> = entries.iter().map(|e| self.theory.normal(e)).collect();
        let order = |v: Variable| match self.theory.atoms.atom(v) {
            Atom::Part { entity, order, .. } if *entity == omega => Some(*order),
            _ => None,
        };
        let mut met = false;
        for rest in &rests {
            let rates = rest.variables().into_iter().filter(|&v| order(v) > Some(0));
            for rate in rates {
                let factor = rest.numerator().coefficient_of(rate, 1);
                if factor.variables().into_iter().any(|v| order(v).is_some()) {
                    return false;
                }
                met = true;
            }
        }
        met
    }

    /// The components of ω across an axis that is fixed in space vanish, where the words name such an axis.
    pub(crate) fn turns_about_fixed_axis(&mut self) {
        let Some(axis) = self.reading.fixed_axis else {
            return;
        };
        self.lies_along(
            "it turns about a fixed axis",
            Quantity::AngularVelocity,
            axis,
        );
        if self.reading.turns_by_angle {
            self.turns_by_only_angle(axis);
        }
    }

    /// Of what carries the rotor nothing is said but how it turns: the moment is the one on the rotor.
    pub(crate) fn rotor_is_alone(&mut self) {
        if !self.reading.rotor_alone {
            return;
        }
        self.are_none(ROTOR_ALONE, Quantity::Inertia, 0..6);
    }

    /// The momentum of the only wheel lies along its axis, where the words name that.
    pub(crate) fn wheel_lies_along_axis(&mut self) {
        let Some(axis) = self.reading.wheel_axis else {
            return;
        };
        self.lies_along(
            "the wheel lies along one axis",
            Quantity::RelativeMomentum,
            axis,
        );
    }

    /// The components of a vector across an axis vanish by what it is.
    fn lies_along(&mut self, name: &str, vector: Quantity, axis: u8) {
        self.are_none(name, vector, (0..3).filter(|&c| c != axis));
    }

    /// Components of a quantity are zero by what it is.
    fn are_none(&mut self, name: &str, quantity: Quantity, components: impl Iterator<Item = u8>) {
        let entity = self.theory.atoms.quantity(quantity);
        let parts = components.map(|c| self.theory.atoms.part(entity, c, 0));
        let preferred: Vec<Variable> = parts.collect();
        self.theory.assume(Premise {
            name: name.to_owned(),
            residuals: preferred.iter().map(|&v| variable_fraction(v)).collect(),
            preferred,
            definition: true,
        });
    }

    /// Moments with one index and no product anywhere: the axes are principal, though no word says so.
    pub(crate) fn single_moments(&mut self) {
        if self.reading.plane {
            self.turn_in_the_plane();
        }
        if self.reading.symmetric {
            self.two_equal_moments();
        }
        let inertia: Vec<&Letter> = self
            .reading
            .quantities
            .iter()
            .filter(|(_, q)| **q == Quantity::Inertia)
            .map(|(l, _)| l)
            .collect();
        let by_component = self
            .reading
            .components
            .values()
            .any(|(q, _)| *q == Quantity::Inertia);
        let single = inertia
            .iter()
            .any(|l| self.reading.usage.get(l).component > 0);
        let double = inertia.iter().any(|l| self.reading.usage.get(l).double > 0);
        let whole = inertia.iter().any(|l| {
            let used = self.reading.usage.get(l);
            used.bare + used.tensor + used.vector > 0
        });
        let by_letters = by_component && !whole && !self.reading.speaks_of_products;
        let by_data = double
            && self.reading.writes_only_diagonal()
            && gives_three_moments(self.document, &self.reading);
        let unmentioned = !double && !integrates_a_product(self.document);
        if unmentioned && (single || by_letters) || by_data {
            self.take(Said::Principal, Span::default());
        }
    }

    /// ω is along z.
    fn turn_in_the_plane(&mut self) {
        let name = "a turn about the z axis";
        self.vanish(name, Quantity::AngularVelocity, &[0, 1]);
        self.turns_by_only_angle(2);
    }

    /// ω about an axis is the rate of the only angle, if there is one.
    fn turns_by_only_angle(&mut self, axis: u8) {
        let Some(angle) = self.reading.usage.only_angle() else {
            return;
        };
        let symbol = Symbol {
            name: angle.name,
            ..Symbol::default()
        };
        let Meaning::Whole(entity) = self.meaning_of(&symbol) else {
            return;
        };
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let (turn, rate) = (
            self.theory.atoms.value(omega, axis, 0),
            self.theory.atoms.value(entity, 0, 1),
        );
        let preferred = vec![self.theory.atoms.part(omega, axis, 0)];
        self.theory.assume(Premise {
            name: "the angle of the turn: ω is its rate".to_owned(),
            preferred,
            residuals: vec![turn - rate],
            definition: true,
        });
    }

    /// Moments called A, A, C.
    fn two_equal_moments(&mut self) {
        let entity = self.theory.atoms.quantity(Quantity::Inertia);
        let [first, second] = [0, 1].map(|c| self.theory.atoms.value(entity, c, 0));
        let premise = Premise {
            name: "two moments are equal: I₁ = I₂".to_owned(),
            preferred: vec![self.theory.atoms.part(entity, 1, 0)],
            residuals: vec![second - first],
            definition: true,
        };
        self.theory.assume(premise);
    }
}

/// Whether a document writes the inertia as a function of time.
pub(crate) fn inertia_changes(document: &Document, reading: &Reading) -> bool {
    let inertia = |letter: &Letter| {
        let whole = reading.quantities.get(letter).copied();
        let part = reading.components.get(letter).map(|(q, _)| *q);
        whole.or(part) == Some(Quantity::Inertia)
    };
    let rates = || {
        document
            .lines()
            .filter_map(|line| Some((line.sides.first()?, line.sides.last()?)))
    };
    let changes = |(rate, value): (&Node, &Node)| {
        let of_inertia = match &inner(rate).kind {
            Kind::TimeDerivative { operand, .. } => match &inner(operand).kind {
                Kind::Symbol(symbol) => inertia(&Letter::of(symbol)),
                _ => false,
            },
            _ => false,
        };
        of_inertia && !symbols(value).is_empty()
    };
    reading.usage.functions_of_time.iter().any(inertia) || reading.plane && rates().any(changes)
}

/// Whether lines hand over all three moments of inertia I_xx, I_yy and I_zz, each by something else than inertia and rates.
fn gives_three_moments(document: &Document, reading: &Reading) -> bool {
    let quantity = |symbol: &Symbol| reading.quantities.get(&Letter::of(symbol)).copied();
    let data = |side: &Node| {
        symbols(side).into_iter().all(|symbol| {
            let of_an_axis = |s: &String| axis(s).is_some() || axes(s).is_some();
            // `I_t` is a name of its own, and no entry.
            let name = !symbol.subscripts.is_empty() && !symbol.subscripts.iter().any(of_an_axis);
            match quantity(symbol) {
                None | Some(Quantity::Mass) => true,
                Some(Quantity::Inertia) => name,
                _ => false,
            }
        })
    };
    let moment = |side: &Node| match &inner(side).kind {
        Kind::Symbol(symbol) if quantity(symbol) == Some(Quantity::Inertia) => symbol
            .subscripts
            .iter()
            .find_map(|s| axes(s))
            .map(|(r, _)| r),
        _ => None,
    };
    let handed = document.lines().filter(|line| line.sides.iter().any(data));
    let given: BTreeSet<u8> = handed.flat_map(|l| &l.sides).filter_map(moment).collect();
    given.len() == 3
}

/// The component of the product of inertia of two axes.
fn product(a: u8, b: u8) -> u8 {
    match (a.min(b), a.max(b)) {
        (0, 1) => 3,
        (0, 2) => 4,
        _ => 5,
    }
}
