//! Values at one instant: "at the start ⟨ω_1 = 0⟩" says nothing of ω̇_1.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::notation::document::{Formula, Item, Row};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::lines::given::is_zero;
use crate::verify::theory::Taken;
use crate::verify::theory::decide::{Decision, decide};
use crate::verify::values::atoms::{Atom, Owner};
use crate::verify::values::figures::is_number;
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::Finding;
use crate::verify::words::book::{has_any, lowered};
use num_traits::Zero;

/// Words of a sentence that says how a body moves at one instant.
const AT_ONCE: &[&str] = &[
    "at the start",
    "at the beginning",
    "at the instant",
    "at this instant",
    "at that instant",
    "at an instant",
    "at a given instant",
    "at one instant",
    "at the moment when",
    "at time zero",
    "initially",
];

/// Words between a formula and one that names a moment.
const AT: &[&str] = &["at", "at time", "when"];

impl Checker<'_> {
    /// Whether the words before a formula or behind it are of one instant.
    fn tells_an_instant(&self) -> bool {
        self.instant_behind || has_any(&lowered(&self.sentence), AT_ONCE) || self.names_start()
    }

    /// "At ⟨t = 0⟩, …".
    fn names_start(&self) -> bool {
        let words: Vec<&str> = self.sentence.split_whitespace().collect();
        let start = |at: &[&str]| {
            let zero = at[1] == "t" && at[2] == "0" || at[1] == "t0";
            zero && ["at", "At", "when", "When", "time"].contains(&at[0])
        };
        words.windows(3).any(start)
    }

    /// Hears that a formula speaks of one instant: "⟨ω_1 = 0⟩ and ⟨ω_2 = n⟩ at the start", "⟨ω_1 = 0⟩ at ⟨t = 0⟩".
    pub(crate) fn hear_instant(&mut self, at: usize) {
        self.instant_behind = self.behind_list(at).is_some_and(|(at, text)| {
            let said = AT_ONCE.iter().any(|words| text.starts_with(words));
            said || AT.contains(&text) && self.is_start(at + 2)
        });
    }

    /// Whether an item is ⟨t = 0⟩.
    fn is_start(&self, at: usize) -> bool {
        let Some(Item::Formula(Formula { rows, .. })) = self.document.items.get(at) else {
            return false;
        };
        let Some(Row::Line(line)) = rows.first() else {
            return false;
        };
        let [time, zero] = &line.sides[..] else {
            return false;
        };
        matches!(&inner(time).kind, Kind::Symbol(symbol) if symbol.name == "t") && is_zero(zero)
    }

    /// A vector that moves, given in numbers, is so at one instant: its rate is not zero for that.
    pub(crate) fn mark_instant(&mut self, name: &str, left: &[Variable], right: &[Fraction]) {
        let moves = |checker: &Self, variable: Variable| match *checker.theory.atoms.atom(variable)
        {
            Atom::Part {
                entity, order: 0, ..
            } => match checker.theory.atoms.info(entity).owner {
                Owner::Quantity(quantity, _) => matches!(
                    quantity,
                    Quantity::AngularVelocity
                        | Quantity::FrameRate
                        | Quantity::Momentum
                        | Quantity::Position
                        | Quantity::Velocity
                ),
                Owner::Symbol(_) => !checker.theory.atoms.info(entity).constant,
            },
            _ => false,
        };
        let moving = !left.is_empty() && left.iter().all(|&v| moves(self, v));
        let values = right.iter().map(|entry| self.theory.normal(entry));
        let values: Vec<Fraction> = values.collect();
        let numbers = values.iter().all(|v| is_number(&self.theory.atoms, v));
        let at_once = moving && self.tells_an_instant();
        if at_once || moving && numbers && values.iter().any(|v| !v.is_zero()) {
            self.theory.instants.insert(name.to_owned(), at_once);
        }
    }

    /// ω = 0 is how a body stands at an instant: one that never turned would have no motion to speak of.
    pub(crate) fn mark_rest(&mut self, name: &str, left: &[Variable], right: &[Fraction]) {
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let part = |c| self.theory.atoms.part(omega, c, 0);
        let whole = [0, 1, 2].map(part);
        let all = whole.iter().all(|v| left.contains(v)) && left.len() == whole.len();
        if all && right.iter().all(Zero::is_zero) {
            self.theory.instants.insert(name.to_owned(), false);
        }
    }

    /// Whether a line speaks of the ω̇ of a body at rest, of which nothing is left if it stays so.
    fn would_begin_to_turn(&mut self, sides: &[Node]) -> bool {
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let at_rest = (0..3).all(|c| {
            let rate = self.theory.atoms.value(omega, c, 0);
            self.theory.normal(&rate).is_zero()
        });
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return false;
        };
        let rates = [0, 1, 2].map(|c| self.theory.atoms.part(omega, c, 1));
        at_rest
            && read.equations.iter().any(|equation| {
                let sides = [&equation.left, &equation.right].into_iter();
                let mut met = sides
                    .flat_map(|side| &side.entries)
                    .flat_map(Fraction::variables);
                met.any(|variable| rates.contains(&variable))
            })
    }

    /// Whether a line holds if what is given in numbers stays as it is.
    pub(crate) fn holds_still(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let said_by_words = self.theory.instants.values().all(|&said| said);
        if said_by_words || self.would_begin_to_turn(sides) {
            return false;
        }
        let instants = self.theory.instants.clone();
        self.theory.instants.retain(|_, &mut said| said);
        let steady = self.theory.rebuild() != Taken::Contradiction;
        let mut holds = false;
        if steady && let Ok(readings) = self.readings(sides) {
            for read in readings {
                if let Decision::True(proof) = decide(&mut self.theory, &read.equations)
                    && !self.is_emptied(sides, &read, &proof)
                {
                    self.proved(&read, proof, finding);
                    finding
                        .remarks
                        .push("what is given in numbers is taken as constant".to_owned());
                    holds = true;
                    break;
                }
            }
        }
        self.theory.instants = instants;
        self.theory.rebuild();
        holds
    }
}
