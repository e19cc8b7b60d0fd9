//! Lines that hand over how the body or the axes turn.

use crate::algebra::Variable;
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, inner, symbols};
use crate::verify::lines::given::is_zero;
use crate::verify::reason::TAKEN_AS_GIVEN;
use crate::verify::values::atoms::{Atom, Owner};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::verdict::{Finding, Role, Verdict};
use num_traits::{One, Zero};

impl Checker<'_> {
    /// Whether a side is the rate of the angular velocity, or of a component of it, that nothing determines.
    pub(crate) fn is_free_rate(&mut self, side: &Node) -> bool {
        let Kind::TimeDerivative { operand, .. } = &inner(side).kind else {
            return false;
        };
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let turning = self.entities([&**operand]) == [omega];
        let Ok(value) = self.lowering(Frame::Moving).value(side) else {
            return false;
        };
        let mut entries = value.entries.iter();
        turning && entries.all(|entry| self.theory.normal(entry).as_variable().is_some())
    }

    /// Whether a side is the moment, or one component of it, that a free rate of ω̇ makes: its value follows from nothing.
    /// Zero is such a value while nothing says how the body turns, or in a list of data.
    pub(crate) fn is_any_moment(&mut self, side: &Node, zero: bool) -> bool {
        let Kind::Symbol(symbol) = &inner(side).kind else {
            return false;
        };
        let moment = self.theory.atoms.quantity(Quantity::Moment);
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let components = match self.meaning_of(symbol) {
            Meaning::Whole(entity) if entity == moment => 0..3,
            Meaning::Component(entity, c) if entity == moment => c..c + 1,
            _ => return false,
        };
        let line = self.document.place(side.span.start).line;
        let listed = |f: &Finding| f.role == Role::Assume && f.source_line == line;
        let last = self.findings.last();
        let data = last.is_some_and(|f| f.role == Role::Given || zero && listed(f));
        let turns_freely = (0..3).all(|c| {
            let rate = self.theory.atoms.value(omega, c, 0);
            let rate = self.theory.normal(&rate);
            rate.as_variable().is_some() || rate.is_zero() && self.reading.plane
        });
        let mut driven = components.filter(|c| !self.reading.plane || *c == 2);
        (data || turns_freely || !zero)
            && driven.all(|c| {
                let value = self.theory.atoms.value(moment, c, 0);
                let made_of = self.theory.normal(&value).variables();
                let rates = (0..3).map(|k| self.theory.atoms.part(omega, k, 1));
                rates.into_iter().any(|rate| made_of.contains(&rate))
            })
    }

    /// Whether a line says what the momentum is of a body of which nothing says how it turns: by a blow, in numbers.
    pub(crate) fn gives_momentum(&mut self, sides: &[Node]) -> bool {
        let [left, right] = sides else { return false };
        // Over the particles of a body the momentum is made of how it turns.
        if sums_up(right) {
            return false;
        }
        let whole = |quantity| Owner::Quantity(quantity, String::new());
        let turns = |owner: &Owner| {
            use Quantity::{
                AngularAcceleration, AngularVelocity, Energy, Inertia, Moment, Momentum, Power,
            };
            let of_turning = [
                AngularVelocity,
                AngularAcceleration,
                Inertia,
                Moment,
                Momentum,
                Energy,
                Power,
            ];
            of_turning
                .into_iter()
                .any(|quantity| *owner == whole(quantity))
        };
        let mut written = symbols(right).into_iter().map(Letter::of);
        let rate = |letter: Letter| {
            self.reading.quantities.get(&letter) == Some(&Quantity::AngularVelocity)
        };
        if written.any(rate) {
            return false;
        }
        let (named, made_of) = (self.entities([left]), self.entities([right]));
        let owner = |entity: &_| &self.theory.atoms.info(*entity).owner;
        let momentum =
            matches!(named.as_slice(), [one] if *owner(one) == whole(Quantity::Momentum));
        if !momentum || made_of.is_empty() || made_of.iter().any(|entity| turns(owner(entity))) {
            return false;
        }
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        (0..3).all(|component| {
            let variable = self.theory.atoms.part(omega, component, 0);
            self.theory.rule(variable).is_none()
        })
    }

    /// Whether a side is how the body or the axes turn, which no law determines: words that derive it speak of the
    /// figure ("the axes point so that").
    pub(crate) fn sets_motion(&mut self, side: &Node) -> bool {
        let turns = |q: &Quantity| matches!(q, Quantity::AngularVelocity | Quantity::FrameRate);
        self.entities([side]).first().is_some_and(|entity| {
            matches!(&self.theory.atoms.info(*entity).owner, Owner::Quantity(q, _) if turns(q))
        })
    }

    /// Whether a line says how the axes turn by how the body does: they follow all of it but a spin.
    pub(crate) fn is_turn_of_axes(&mut self, first: &Node, last: &Node) -> bool {
        let turns = |checker: &Self, entity| match &checker.theory.atoms.info(entity).owner {
            Owner::Quantity(q, _) => {
                matches!(q, Quantity::AngularVelocity | Quantity::FrameRate)
            }
            Owner::Symbol(_) => true,
        };
        let axes = self.entities([first]).first().is_some_and(|&entity| {
            matches!(
                &self.theory.atoms.info(entity).owner,
                Owner::Quantity(Quantity::FrameRate, _)
            )
        });
        axes && !is_multiple(last)
            && self
                .entities([last])
                .into_iter()
                .all(|entity| turns(self, entity))
    }

    /// Whether a component of how the axes turn stands beside another one of how the body does.
    pub(crate) fn mixes_turns(&mut self, first: &Node, last: &Node) -> bool {
        let mut turn = |side: &Node| {
            let Kind::Symbol(symbol) = &inner(side).kind else {
                return None;
            };
            let Meaning::Component(entity, component) = self.meaning_of(symbol) else {
                return None;
            };
            match self.theory.atoms.info(entity).owner {
                Owner::Quantity(q @ (Quantity::AngularVelocity | Quantity::FrameRate), _) => {
                    Some((q, component))
                }
                _ => None,
            }
        };
        let (one, other) = (turn(first), turn(last));
        one.zip(other)
            .is_some_and(|(one, other)| one.0 != other.0 && one.1 != other.1)
            || self.is_share_of_turn(first, last)
    }

    /// Whether the axes are said to turn so many times as fast as the body.
    fn is_share_of_turn(&mut self, first: &Node, last: &Node) -> bool {
        let rate = self.theory.atoms.quantity(Quantity::FrameRate);
        if self.entities([first]) != [rate] {
            return false;
        }
        let Ok(value) = self.lowering(Frame::Moving).value(last) else {
            return false;
        };
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let omega = self.theory.atoms.vector(omega, 0);
        let mut parts = value.entries.iter().zip(omega);
        value.is_vector()
            && parts.all(|(part, whole)| {
                let ratio = (part.clone() / whole).to_rational();
                ratio.is_some_and(|ratio| !ratio.is_one())
            })
    }

    /// Whether a line in the same breath gives another component of how the body turns.
    pub(crate) fn stands_beside_motion(&mut self, side: &Node) -> bool {
        let beside = std::mem::take(&mut self.beside);
        let given = beside.iter().any(|(left, last)| {
            left.span != side.span
                && !is_zero(last)
                && self.sets_motion(left)
                && self.is_free_input(left)
        });
        self.beside = beside;
        if given {
            return self.sets_motion(side);
        }
        let line = self.document.place(side.span.start).line;
        let handed = self.findings.last().is_some_and(|before| {
            before.role == Role::Given
                && before.verdict == Verdict::Accepted
                && before.source_line + 1 >= line
        });
        handed && self.sets_motion(side)
    }

    /// Whether nothing rules how the body begins to turn, and a line right before gives one component of that: "then
    /// ⟨ω₁ = n⟩, ⟨ω₂ = Ω cos nt⟩" is of the figure, and no motion that follows from a moment.
    pub(crate) fn may_turn_in_time(&mut self) -> bool {
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let free = (0..3).all(|component| {
            let rate = self.theory.atoms.value(omega, component, 1);
            let own = self.theory.atoms.part(omega, component, 1);
            let made_of = self.theory.normal(&rate).variables();
            let mut inside = made_of
                .into_iter()
                .flat_map(|v| self.theory.atoms.with_arguments(v));
            inside.all(|v| v == own || self.is_of_the_figure(v))
        });
        free && self
            .findings
            .last()
            .is_some_and(|before| match &before.reason {
                Some(reason) => reason == TAKEN_AS_GIVEN,
                None => before.verdict == Verdict::Accepted && before.role == Role::Given,
            })
    }

    /// Whether a variable is a symbol of the document, the time, or a function of these.
    fn is_of_the_figure(&self, variable: Variable) -> bool {
        match self.theory.atoms.owner(variable) {
            Some(Owner::Symbol(_)) => true,
            Some(Owner::Quantity(quantity, _)) => *quantity == Quantity::Time,
            None => matches!(self.theory.atoms.atom(variable), Atom::Kernel { .. }),
        }
    }

    /// Whether the time stands in some sides.
    pub(crate) fn speaks_of_time(&mut self, sides: &[Node]) -> bool {
        let time = Owner::Quantity(Quantity::Time, String::new());
        let entities = self.entities(sides);
        let mut owners = entities.iter().map(|e| &self.theory.atoms.info(*e).owner);
        owners.any(|owner| *owner == time)
    }

    /// Whether a display says the second rate of a symbol of which earlier lines speak: what follows from laws, which
    /// may not be known here.
    pub(crate) fn is_equation_of_motion(&mut self, sides: &[Node]) -> bool {
        let second = match &inner(&sides[0]).kind {
            Kind::TimeDerivative { operand, order, .. } => {
                *order >= 2 && self.is_mentioned(operand)
            }
            _ => false,
        };
        second && self.displayed
    }

    /// Whether an earlier line speaks of something in a node.
    fn is_mentioned(&mut self, node: &Node) -> bool {
        let entities = self.entities([node]);
        entities
            .into_iter()
            .any(|entity| self.theory.mentions_entity(entity))
    }
}

/// Whether a sum over particles or an integral stands in a side.
fn sums_up(side: &Node) -> bool {
    let own = matches!(side.kind, Kind::IndexedSum { .. } | Kind::Integral { .. });
    own || side.children().any(sums_up)
}

/// Whether a side is a symbol, or so many times one.
fn is_multiple(side: &Node) -> bool {
    let number = |node: &Node| matches!(inner(node).kind, Kind::Number(_));
    match &inner(side).kind {
        Kind::Symbol(_) => true,
        Kind::Negate(inside) => is_multiple(inside),
        Kind::Product(factors) => {
            let mut others = factors.iter().filter(|factor| !number(&factor.node));
            others.next().is_some_and(|one| is_multiple(&one.node)) && others.next().is_none()
        }
        _ => false,
    }
}
