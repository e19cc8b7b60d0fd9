//! The rate at which the axis of a free symmetric body goes round its angular momentum: |L| over the transverse moment
//! (Goldstein, Classical Mechanics, section 5.6, as it is seen from space).

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, symbols, undotted};
use crate::verify::lines::line::Read;
use crate::verify::reason;
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::theory::{Premise, Taken};
use crate::verify::values::atoms::Owner;
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::symbol::MAGNITUDE;
use crate::verify::values::value::Value;
use crate::verify::verdict::{Finding, Role, Verdict};
use crate::verify::words::book::{has_any, lowered};
use crate::verify::words::free_motion_rates::spins_about_own_axis;
use num_traits::{One, Zero};

const NAME: &str = "rate of the axis about the angular momentum";

/// Words of what is seen from space.
const FROM_SPACE: &[&str] = &[
    "inertial",
    "in space",
    "from space",
    "space cone",
    "about the angular momentum",
    "around the angular momentum",
    "about the fixed angular momentum",
    "direction of the angular momentum",
    "about the direction of",
    "circles the direction of",
    "around the direction of",
];
/// Words of what is seen from the body.
const FROM_BODY: &[&str] = &[
    "in the body",
    "from the body",
    "body frame",
    "body axes",
    "body cone",
    "body-fixed",
    "relative to the body",
];

/// Verbs of an axis, seen from space, before what it goes round.
const GOES_ROUND: &[&str] = &[
    "goes round",
    "goes around",
    "go round",
    "go around",
    "turn round",
    "turn around",
    "precess about",
    "precess around",
    "moves round",
    "moves around",
    "turns round",
    "turns around",
    "precesses round",
    "precesses around",
    "precesses about",
    "circles ",
];

impl Checker<'_> {
    /// Decides what a new symbol, or its rate, is said to be by words that call it this rate.
    pub(crate) fn precesses(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, right, rest @ ..] = sides else {
            return false;
        };
        let words = lowered(&self.sentence);
        let called = words.contains("precess") && has_any(&words, FROM_SPACE)
            || words.contains("axis") && self.goes_round_momentum();
        let tail = words.rsplit('⟩').next().unwrap_or_default();
        if spins_about_own_axis(tail) {
            let led_in = lowered(&self.led_in);
            let beside = called
                || led_in.contains("precess") && has_any(&led_in, FROM_SPACE)
                || self.goes_round_letter(&self.led_in);
            return beside && self.spins_beside(sides, finding);
        }
        // Lines further on are of something else.
        let said = GOES_ROUND.iter().chain(FROM_SPACE).chain(&["precess"]);
        let last = said.filter_map(|said| words.rfind(said)).max();
        if last.is_some_and(|at| words[at..].matches('⟩').count() > 2) {
            return false;
        }
        let rated = matches!(
            &left.kind,
            Kind::TimeDerivative { order: 1, .. } | Kind::Symbol(_)
        );
        if !called
            || has_any(&words, FROM_BODY)
            || !rated
            || self.new_symbol(undotted(left)).is_none()
        {
            return false;
        }
        // A rate is a number, and what it is made of too.
        let bare = symbols(right).into_iter().filter(|s| !s.style.vector);
        let before = self.reading.scalars.clone();
        self.reading.scalars.extend(bare.map(Letter::of));
        let settled = self.goes_round(&sides[..2], finding);
        if !settled {
            self.reading.scalars = before;
        } else if finding.verdict == Verdict::Accepted && !rest.is_empty() {
            finding.verdict = Verdict::Undecided;
            self.claim(&sides[1..], finding);
        }
        settled
    }

    /// "The axis goes round ⟨L⟩": the letter is that of the momentum, which stands in the sentence before its mark.
    fn goes_round_momentum(&self) -> bool {
        self.goes_round_letter(&self.sentence)
    }

    /// The same of a clause in small letters, or its words for the momentum.
    pub(crate) fn goes_round_momentum_in(&self, clause: &str) -> bool {
        has_any(clause, FROM_SPACE) && !has_any(clause, FROM_BODY)
            || self.goes_round_letter(&self.sentence)
    }

    fn goes_round_letter(&self, sentence: &str) -> bool {
        GOES_ROUND.iter().any(|words| {
            let behind = sentence.split_once(words).map(|(_, behind)| behind);
            let formula = behind.and_then(|behind| behind.split_once('⟨'));
            let mut names = formula
                .into_iter()
                .flat_map(|(names, _)| names.split_whitespace());
            let name = names.next_back().unwrap_or_default();
            self.reading.quantities.get(&Letter::plain(name)) == Some(&Quantity::Momentum)
        })
    }

    fn goes_round(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let Some(Ok(value)) = sides
            .last()
            .map(|right| self.lowering(Frame::Moving).value(right))
        else {
            return false;
        };
        let Some((length, moment)) = self.momentum_and_moment() else {
            return false;
        };
        // Over the length of the momentum, numbers are found without roots.
        let (Some(value), law) = (value.as_scalar().cloned(), Fraction::one() / moment) else {
            return false;
        };
        let (law, value) = (Value::scalar(law), Value::scalar(value / length));
        // Its sense is the author's own.
        let decided = [value.clone(), value.negated()].map(|value| {
            let equation = Equation::between(law.clone(), value).ok()?;
            Some((
                decide(&mut self.theory, std::slice::from_ref(&equation)),
                equation,
            ))
        });
        let [Some((first, equation)), Some((second, _))] = decided else {
            return false;
        };
        match (first, second) {
            (Decision::True(_), _) | (_, Decision::True(_)) => {
                self.accept(sides, Role::Given, finding);
                let how = "it is the angular momentum over the transverse moment of inertia";
                finding.remarks.push(how.to_owned());
            }
            (decision @ Decision::False(_), Decision::False(_) | Decision::FalseWithoutWitness) => {
                self.now_known(&sides[..1]);
                let read = Read::of(vec![equation]);
                self.failed(sides, &read, decision, finding);
                finding.follows_from = None;
                let over = "the values are over the length of the angular momentum";
                finding.remarks.push(over.to_owned());
                self.take_rate_round_momentum(&sides[0]);
            }
            _ => finding.reason = Some(reason::TAKEN_AS_GIVEN.to_owned()),
        }
        true
    }

    /// Takes a rate for what it is, where the document has it wrong.
    pub(crate) fn take_rate_round_momentum(&mut self, rate: &Node) {
        let (Some(rate), Some((length, moment))) = (
            self.lowering(Frame::Moving).scalar(rate),
            self.momentum_and_moment(),
        ) else {
            return;
        };
        let residual = rate.clone() - length / moment;
        let taken = self.theory.assume(Premise {
            name: NAME.to_owned(),
            residuals: vec![residual],
            preferred: rate.variables(),
            definition: true,
        });
        if taken == Taken::Solved {
            self.keep(NAME, true);
        }
    }

    /// |L| and the transverse moment, of a body that is symmetric and free.
    pub(crate) fn momentum_and_moment(&mut self) -> Option<(Fraction, Fraction)> {
        let moment = self.theory.atoms.quantity(Quantity::Moment);
        let moment = self.theory.atoms.vector(moment, 0);
        if !moment.iter().all(|part| self.theory.normal(part).is_zero()) {
            return None;
        }
        let [_, first, _] = self.theory.symmetry()?;
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        let transverse = self.theory.atoms.value(inertia, first as u8, 0);
        let owner = Owner::Quantity(Quantity::Momentum, MAGNITUDE.to_owned());
        let length = self.theory.atoms.entity(&owner, Shape::Scalar, false, "L");
        Some((self.theory.atoms.value(length, 0, 0), transverse))
    }
}
