//! Frequencies: what a line calls the frequency of the oscillation that the line before it describes, ẍ + w²x = 0.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::lines::laws_in_words::{calls_frequency_of_swings, is_of_swings};
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::values::atoms::{Atom, Owner, variable_fraction};
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Diagnosis, Finding, Role, Verdict};
use crate::verify::words::book::lowered;
use num_traits::Zero;

/// Findings that may stand between an equation and the frequency: conditions, numbers.
const NEAR: usize = 2;
/// The same, where the words call it the frequency of the small swings that the equation describes.
const NEAR_SWINGS: usize = 5;

/// What an equation of motion says of small swings.
#[derive(Clone)]
pub(crate) struct Oscillation {
    /// The number of its finding.
    at: usize,
    /// The square of the frequency.
    square: Fraction,
    /// Whether it is what the equation comes down to near zero.
    near_zero: bool,
    /// Whether the equation was proved or accepted.
    firm: bool,
}

/// Words for the motion that an equation describes.
const GOES_ON: &[&str] = &[" grows ", " grow ", " oscillates ", " oscillate "];

impl Oscillation {
    /// Whether it is of an angle that a sine has, which no spin of the body is behind.
    pub(crate) fn is_of_an_angle(&self) -> bool {
        self.near_zero
    }
}

impl Checker<'_> {
    /// Notes w² of an equation ẍ + w²x = 0 in a symbol of the document, or of what it comes down to where x is small.
    pub(crate) fn note_oscillation(&mut self, sides: &[Node], finding: &Finding) {
        let firm = matches!(finding.verdict, Verdict::Accepted | Verdict::Proved(_));
        let left_open = finding.verdict == Verdict::Undecided && self.oscillation.is_none();
        let refuted = finding.verdict == Verdict::Refuted;
        if !firm && !left_open && !refuted || sides.len() != 2 {
            return;
        }
        if !self.theory.atoms.has_second_rates() && !sides.iter().any(is_rate_of_rate) {
            return;
        }
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return;
        };
        let [equation] = read.equations.as_slice() else {
            return;
        };
        let [residual] = equation.residual.entries.as_slice() else {
            return;
        };
        let Some(residual) = (match refuted {
            true => self.motion_in_place_of(residual),
            false => Some(residual.clone()),
        }) else {
            return;
        };
        let exact = self.square_of_frequency(&residual);
        let near_zero = exact.is_none();
        if let Some(square) = exact.or_else(|| self.square_near_zero(&residual)) {
            self.oscillation = Some(Oscillation {
                at: self.findings.len(),
                square,
                near_zero,
                firm: firm || refuted,
            });
        }
    }

    /// What the laws have the second rate in a false equation of motion be.
    fn motion_in_place_of(&mut self, residual: &Fraction) -> Option<Fraction> {
        let second = |v: &u32| matches!(self.theory.atoms.atom(*v), Atom::Part { order: 2, .. });
        let rate = residual.variables().into_iter().find(second)?;
        let value = self.theory.normal(&variable_fraction(rate));
        let known = !value.variables().contains(&rate);
        known.then(|| variable_fraction(rate) - value)
    }

    /// The same of an equation with the sine of an angle, for small angles.
    fn square_near_zero(&mut self, residual: &Fraction) -> Option<Fraction> {
        let atoms = &mut self.theory.atoms;
        let variables = residual.variables().into_iter();
        let angle = variables.clone().find_map(|v| match *atoms.atom(v) {
            Atom::Part {
                entity,
                component: 0,
                order: 2,
            } => Some(entity),
            _ => None,
        })?;
        let place = atoms.part(angle, 0, 0);
        let of_angle = |v: u32| match atoms.atom(v) {
            Atom::Kernel { argument, .. } => argument.variables().contains(&place),
            _ => false,
        };
        if !variables.into_iter().any(of_angle) {
            return None;
        }
        let first = self.small.insert(angle);
        let near = self.low(residual, 1);
        if first {
            self.small.remove(&angle);
        }
        self.square_of_frequency(&near)
    }

    fn square_of_frequency(&mut self, residual: &Fraction) -> Option<Fraction> {
        let above = residual.numerator();
        let atoms = &self.theory.atoms;
        let (entity, component, second) =
            above
                .variables()
                .into_iter()
                .find_map(|v| match *atoms.atom(v) {
                    Atom::Part {
                        entity,
                        component,
                        order: 2,
                    } => Some((entity, component, v)),
                    _ => None,
                })?;
        let small = match &atoms.info(entity).owner {
            Owner::Symbol(_) => component == 0,
            // Beside two small components of ω the third keeps its value.
            Owner::Quantity(quantity, variant) => {
                *quantity == Quantity::AngularVelocity
                    && variant.is_empty()
                    && self.small_turns.len() == 2
                    && self.small_turns.contains(&component)
            }
        };
        if !small {
            return None;
        }
        let first = self.theory.atoms.part(entity, component, 0);
        let (inertia, spring) = (
            above.coefficient_of(second, 1),
            above.coefficient_of(first, 1),
        );
        let made = inertia.clone() * crate::algebra::Polynomial::variable(second)
            + spring.clone() * crate::algebra::Polynomial::variable(first);
        let small_turns = &self.small_turns;
        let apart = |v: &u32| match *self.theory.atoms.atom(*v) {
            Atom::Part {
                entity: other,
                component,
                order,
            } => {
                other != entity
                    || order == 0 && small_turns.len() == 2 && !small_turns.contains(&component)
            }
            _ => self.theory.atoms.entity_of(*v) != Some(entity),
        };
        let constant = inertia
            .variables()
            .iter()
            .chain(&spring.variables())
            .all(apart);
        let oscillates = constant && !spring.is_zero() && (above.clone() - made).is_zero();
        oscillates.then(|| Fraction::from(spring) / Fraction::from(inertia))
    }

    /// Whether a sentence names a frequency in passing: "with the libration frequency".
    pub(crate) fn has_a_frequency(&self, role: Role) -> bool {
        role == Role::Define && !self.firm && lowered(&self.sentence).contains("frequency")
    }

    /// Whether a sentence says how what the equation before it describes goes on: "it grows like exp(st) with ⟨s = …⟩".
    pub(crate) fn goes_on_with(&self, role: Role) -> bool {
        let words = lowered(&self.sentence);
        let behind = GOES_ON.iter().filter_map(|verb| words.rfind(verb)).max();
        role == Role::Assume && !self.firm && behind.is_some_and(|at| words[at..].contains("with"))
    }

    /// Whether a square is one of the frequencies of the document, by its letter.
    fn is_by_letter(&self, square: &Node) -> bool {
        match &inner(square).kind {
            Kind::Power(base, _) => match &inner(base).kind {
                Kind::Symbol(symbol) => self.reading.periods.contains(&Letter::of(symbol)),
                _ => false,
            },
            _ => false,
        }
    }

    /// Whether a law says what the square of a symbol is.
    pub(crate) fn is_tied_by_square(&mut self, left: &Node) -> bool {
        self.square_by_law(left).is_some()
    }

    /// The square of a symbol that stands in `\ddot x + w^2 x = 0`, where the motion of x is known.
    fn square_by_law(&mut self, left: &Node) -> Option<Fraction> {
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return None;
        };
        let entity = self.entity_named(symbol)?;
        let own = self.theory.atoms.part(entity, 0, 0);
        let tied = self
            .theory
            .premises()
            .iter()
            .filter(|p| is_of_swings(&p.name));
        let residuals: Vec<Fraction> = tied.flat_map(|p| p.residuals.clone()).collect();
        residuals.into_iter().find_map(|residual| {
            let above = residual.numerator();
            let leads = above.degree_in(own) == 2 && above.coefficient_of(own, 1).is_zero();
            let square = above.coefficient_of(own, 2);
            let rest = Fraction::from(above.coefficient_of(own, 0));
            leads.then(|| (Fraction::zero() - rest) / Fraction::from(square))
        })
    }

    /// Decides a new symbol, or its square, that the words call the frequency of the oscillation before it, or what a
    /// deviation grows by.
    pub(crate) fn is_frequency(
        &mut self,
        left: &Node,
        right: &Node,
        finding: &mut Finding,
    ) -> bool {
        let words = lowered(&self.sentence);
        let tied = self.square_by_law(left);
        let by_law = tied.is_some();
        let by_motion = tied.map(|square| Oscillation {
            at: self.findings.len(),
            square,
            near_zero: false,
            firm: true,
        });
        let Some(noted) = by_motion.or_else(|| self.oscillation.clone()) else {
            return false;
        };
        let swings = calls_frequency_of_swings(&words);
        if noted.near_zero && !swings {
            return false;
        }
        let square = noted.square;
        let grows = words.contains(" grow");
        let near = if swings { NEAR_SWINGS } else { NEAR };
        let near = self.findings.len() <= noted.at + 1 + near;
        let lone = |node: &Node| matches!(inner(node).kind, Kind::Symbol(_));
        let squared = match &inner(left).kind {
            Kind::Power(base, exponent) => {
                let two = matches!(&exponent.kind, Kind::Number(n) if n.value == num_rational::BigRational::from_integer(2.into()));
                two && lone(base)
            }
            _ => false,
        };
        let called =
            by_law || words.contains("frequency") || grows || squared && self.is_by_letter(left);
        if !near || !called || !squared && !lone(left) {
            return false;
        }
        // Of ẍ = s²x the solutions grow like exp(st).
        let square = if grows { -square } else { square };
        let named = self.entities([left]);
        let inside = square.variables();
        if inside.iter().any(|&v| {
            self.theory
                .atoms
                .entity_of(v)
                .is_some_and(|e| named.contains(&e))
        }) {
            return false;
        }
        let Some(value) = self.lowering(Frame::Moving).scalar(right) else {
            return false;
        };
        let value = match squared {
            true => value,
            false => value.clone() * value,
        };
        // That the frequency is real too would leave no values for a root of the other sign.
        let mut apart = self.theory.left_out.clone();
        let premises = self.theory.premises().iter().map(|p| &p.name);
        apart.extend(premises.filter(|name| is_of_swings(name)).cloned());
        let equation = [Equation::of_scalars(square, value)];
        match self
            .theory
            .without(apart, |theory| decide(theory, &equation))
        {
            Decision::False(_) if !noted.firm => {
                finding.verdict = Verdict::Undecided;
                finding.reason =
                    Some("the equation of motion, which was left open, has another".to_owned());
                true
            }
            Decision::False(witness) => {
                finding.verdict = Verdict::Refuted;
                finding.reason =
                    Some("its square is not what the equation of motion has".to_owned());
                finding.counterexample = Some(*witness);
                finding.diagnosis = Some(Diagnosis {
                    kind: "frequency",
                    message: "the equation of motion has another ratio of its coefficients"
                        .to_owned(),
                    suggestion: None,
                    place: Some(finding.place),
                });
                true
            }
            _ => false,
        }
    }
}

/// Whether a second rate, or the rate of a rate, stands in a node.
pub(crate) fn is_rate_of_rate(node: &Node) -> bool {
    fn most(node: &Node) -> u8 {
        let mut inside = 0;
        node.children()
            .for_each(|child| inside = inside.max(most(child)));
        match &node.kind {
            Kind::TimeDerivative { order, .. } => inside.saturating_add(*order),
            _ => inside,
        }
    }
    most(node) > 1
}
