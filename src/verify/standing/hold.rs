//! What one link of a line is worth by the facts.

use crate::algebra::{Fraction, Proof};
use crate::notation::ast::{DerivativeStyle, Kind, Node, Number, Relation};
use crate::verify::facts::premises::OutOfBudget;
use crate::verify::facts::proof::prove;
use crate::verify::language::messages;
use crate::verify::standing::chains::Link;
use crate::verify::standing::indices::{assignments, by_entries, cyclic_assignments, free_letters};
use crate::verify::standing::judge::Judge;
use crate::verify::standing::shown::Shown;
use crate::verify::standing::sides::{Both, both, factors};
use crate::verify::standing::verdicts::Standing;
use crate::verify::standing::written::bounds_in;
use crate::verify::term::lower::Lowering;
use crate::verify::term::value::{GROWN, Trouble, Value};
use num_traits::Zero;
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::sync::Arc;

/// What one link of a line came to.
#[derive(Clone, Debug)]
pub(super) struct Held {
    pub(super) standing: Standing,
    pub(super) reason: Option<String>,
    /// Why a denial is not to be trusted: something that is said is not in force.
    pub(super) doubt: Option<String>,
    /// Whether the premises in force together are too many for an answer.
    pub(super) beyond: bool,
    pub(super) proof: Option<Proof>,
    pub(super) unknown: Vec<String>,
    /// Whether a letter of which nothing is told stands alone on a side or is a factor of it, and no line has settled it.
    pub(super) alone: bool,
    /// Whether it would say something of the motion that its new letters do not tell.
    pub(super) restricts: bool,
    pub(super) sides: Arc<[(Fraction, Fraction)]>,
    pub(super) shown: Option<Arc<Shown>>,
    /// The letter that it settles, with its value.
    pub(super) settles: Option<(String, Value, Value)>,
    /// Whether it speaks of values at instants: then it is no fact of all times.
    pub(super) at_instants: bool,
}

/// The sides of a link, component by component.
#[derive(Clone, Debug, Default)]
pub(super) struct Sides {
    pub(super) sides: Arc<[(Fraction, Fraction)]>,
    /// Letters of which nothing is told.
    pub(super) unknown: Vec<String>,
    /// The letter that it settles, with its value.
    pub(super) settles: Option<(String, Value, Value)>,
}

/// The sides, or why there are none.
pub(super) type WorkedOut = Result<Sides, Untold>;

/// Why there are no sides, and the letters of which nothing is told.
pub(super) type Untold = (Trouble, Vec<String>);

impl Held {
    pub(super) fn open(reason: impl Into<String>) -> Self {
        Self {
            standing: Standing::Open,
            reason: Some(reason.into()),
            doubt: None,
            beyond: false,
            restricts: false,
            proof: None,
            unknown: vec![],
            alone: false,
            sides: Arc::default(),
            shown: None,
            settles: None,
            at_instants: false,
        }
    }
}

impl Judge<'_> {
    /// What one link is worth, worked out.
    pub(super) fn hold_anew(&mut self, link: &Link<'_>) -> Held {
        if let Some(sentence) = self.unread_rule() {
            return Held::open(nothing_made_of(sentence));
        }
        let held = self.hold_told(link);
        match self.unread_of(&link.sides(), &held.unknown) {
            Some(sentence) => Held::open(nothing_made_of(sentence)),
            None => held,
        }
    }

    /// The same by the sentences that are understood.
    fn hold_told(&mut self, link: &Link<'_>) -> Held {
        if let Some(bound) = self.other_bound(link) {
            return Held::open(messages::unknown_bound(&bound));
        }
        match link.relation {
            Relation::Equal | Relation::Defined => self.hold_equal(link),
            Relation::NotEqual => self.hold_unequal(link),
            Relation::Approximate => {
                let held = self.hold_equal(link);
                match held.standing {
                    Standing::Entailed => held,
                    _ => Held::open("an approximation is not decided"),
                }
            }
            relation => self.hold_order(link, relation),
        }
    }

    fn hold_unequal(&mut self, link: &Link<'_>) -> Held {
        let mut held = self.hold_equal(link);
        let atoms = &self.reading.system.atoms;
        // Where they are the same only if something does not vanish, they may differ.
        let always = held.proof.as_ref().is_some_and(|proof| {
            let mut conditions = proof.arguments().iter().flat_map(|a| &a.conditions);
            conditions.all(|condition| atoms.has_sign(condition))
        });
        let lengths = self.speaks_of_lengths(&held.sides);
        (held.standing, held.reason) = match held.standing {
            Standing::Entailed if always => {
                (Standing::Denied, Some(messages::ALWAYS_THE_SAME.into()))
            }
            Standing::Entailed => (Standing::Open, Some(messages::MOSTLY_THE_SAME.into())),
            // Of a length only the square is told: that they differ may be a matter of its sign.
            Standing::Denied if lengths => (Standing::Open, Some(messages::OPEN_RELATION.into())),
            // There is a world in which they differ, and more is not said.
            Standing::Denied => (Standing::Differs, None),
            other => (other, held.reason),
        };
        held.proof = None;
        held
    }

    /// Whether only the square is told of a letter in the sides.
    fn speaks_of_lengths(&self, sides: &[(Fraction, Fraction)]) -> bool {
        let atoms = &self.reading.system.atoms;
        let sides = sides.iter().flat_map(|(left, right)| [left, right]);
        let mut letters = sides.flat_map(Fraction::variables);
        letters.any(|letter| {
            let letter = atoms.atom(letter).rate_of.unwrap_or(letter);
            atoms.atom(letter).square.is_some() || self.facts.square(letter).is_some()
        })
    }

    /// Up to where a sum runs on a link, if that is another letter than the document writes first.
    fn other_bound(&self, link: &Link<'_>) -> Option<String> {
        self.written.bounds.first_key_value()?;
        let nodes = link.sides().into_iter();
        let mut all = nodes.flat_map(bounds_in);
        let other =
            all.find(|(index, bound)| self.written.bounds.get(index).is_some_and(|b| b != bound));
        other.map(|(_, bound)| bound)
    }

    /// "= const": the rate of the other side vanishes.
    fn hold_constant(&mut self, link: &Link<'_>) -> Held {
        let zero = Node {
            kind: Kind::Number(Number {
                value: Zero::zero(),
                decimals: None,
                exponent: 0,
            }),
            span: link.right.span,
        };
        let rate = Kind::TimeDerivative {
            operand: Box::new(link.left.clone().into_owned()),
            order: 1,
            style: DerivativeStyle::Dots,
            frame: None,
        };
        let left = Node {
            kind: rate,
            span: link.left.span,
        };
        self.hold_equal(&Link {
            left: Cow::Owned(left),
            relation: Relation::Equal,
            right: Cow::Owned(zero),
        })
    }

    fn hold_equal(&mut self, link: &Link<'_>) -> Held {
        if is_constant_word(&link.right) {
            let mut held = self.hold_constant(link);
            // Often it says which motion is looked at, and not what follows of all.
            if held.standing == Standing::Denied {
                held.standing = Standing::Open;
                held.reason = Some("it is constant in some motions alone".into());
            }
            return held;
        }
        if let Some(held) = self.hold_either(link) {
            return held;
        }
        if let Some(held) = self.hold_at_instants(link) {
            return held;
        }
        match self.sides(link, &BTreeSet::new()) {
            Err((Trouble::IllTyped(_), _)) if !self.doubled(link).is_empty() => {
                self.hold_by_types(link)
            }
            worked_out => {
                let held = self.hold_sides(link, worked_out);
                self.or_by_axes(link, held)
            }
        }
    }

    pub(super) fn hold_sides(&mut self, link: &Link<'_>, sides: WorkedOut) -> Held {
        match sides {
            Ok(sides) => self.weigh(link, sides),
            Err((Trouble::IllTyped(message), unknown))
                if unknown.is_empty()
                    && self.unused_of(link.sides()).is_none()
                    && self.reading.system.dimensions() == 3 =>
            {
                let mut held = Held::open(message);
                held.standing = Standing::Denied;
                held
            }
            Err((trouble, unknown)) => {
                let mut held = Held::open(String::from(trouble));
                held.unknown = unknown;
                held
            }
        }
    }

    /// What lowers the formulas of the line that is looked at.
    pub(super) fn lowering(&mut self) -> Lowering<'_> {
        Lowering::new(
            &mut self.reading.system,
            &self.reading.letters,
            self.written.trial.as_ref().unwrap_or(&self.document.source),
            &self.at,
            &mut self.known,
        )
    }

    /// Both sides of a link, for every axis that its free indices may number.
    pub(super) fn sides(
        &mut self,
        link: &Link<'_>,
        besides: &BTreeSet<(String, usize)>,
    ) -> WorkedOut {
        if let Some(settled) = self.settled_by_relation(link) {
            return Ok(settled);
        }
        let (letters, nodes) = (&self.reading.letters, link.sides());
        let by_entries = by_entries(letters, &self.at, link);
        let free = || assignments(&free_letters(letters, &self.at, &nodes));
        let readings = cyclic_assignments(letters, &self.at, &nodes).unwrap_or_else(free);
        let (mut all, mut sides) = (Sides::default(), vec![]);
        for axes in readings {
            let mut lowering = self.lowering();
            lowering.axes = axes;
            lowering.occurrences.besides.clone_from(besides);
            let pair = both(&mut lowering, link);
            all.unknown.extend(lowering.unknown.keys().cloned());
            match pair {
                Ok(Both {
                    left,
                    right,
                    settles,
                }) => {
                    let entries = left.entries.iter().cloned();
                    sides.extend(entries.zip(right.entries.iter().cloned()));
                    all.settles = settles.map(|letter| (letter, left, right));
                }
                Err(trouble) => {
                    let trouble = match trouble {
                        Trouble::IllTyped(_) if by_entries => {
                            Trouble::Beyond(messages::BY_ENTRIES.into())
                        }
                        trouble => trouble,
                    };
                    if matches!(trouble, Trouble::IllTyped(_)) {
                        all.unknown
                            .retain(|letter| lowering.unknown.get(letter) != Some(&true));
                    }
                    return Err((trouble, all.unknown));
                }
            }
        }
        all.unknown.sort();
        all.unknown.dedup();
        all.sides = sides.into();
        Ok(all)
    }

    /// What is left of each difference in free variables, to first order where that is asked for.
    pub(super) fn residuals(
        &mut self,
        sides: &[(Fraction, Fraction)],
    ) -> Result<Vec<Fraction>, OutOfBudget> {
        let small = self.small_here();
        let mut residuals = vec![];
        for (left, right) in sides {
            let difference = left.clone() - right.clone();
            let atoms = &mut self.reading.system.atoms;
            let residual = self.facts.normal(atoms, &difference)?;
            // Over what is small a first order is made of a second one.
            if small.vanishes(atoms, residual.denominator()) {
                return Err(OutOfBudget);
            }
            residuals.push(match small.is_empty() {
                true => residual,
                false => Fraction::from(small.truncated(atoms, residual.numerator())),
            });
        }
        Ok(residuals)
    }

    /// What a link is worth whose sides are worked out, weighed anew.
    pub(super) fn weigh_anew(&mut self, link: &Link<'_>, worked_out: Sides) -> Held {
        if self.facts.are_too_many
            && let Some(held) = self.weigh_by_needed(link, &worked_out)
        {
            return held;
        }
        let sides = worked_out.clone();
        let held = match self.residuals(&worked_out.sides) {
            Ok(residuals) => self.weigh_residuals(link, worked_out, &residuals),
            Err(OutOfBudget) => Held {
                beyond: true,
                unknown: worked_out.unknown,
                sides: worked_out.sides,
                settles: worked_out.settles,
                ..Held::open(GROWN)
            },
        };
        if !held.beyond {
            return held;
        }
        let tried = std::mem::replace(&mut self.facts.are_too_many, true);
        let by_relevant = (!tried)
            .then(|| self.weigh_by_needed(link, &sides))
            .flatten();
        let to_order = by_relevant.or_else(|| self.weigh_to_order(link, &sides));
        to_order.unwrap_or_else(|| self.weigh_by_few_premises(held))
    }

    /// What a link is worth by what is left of its differences.
    pub(super) fn weigh_residuals(
        &mut self,
        link: &Link<'_>,
        worked_out: Sides,
        residuals: &[Fraction],
    ) -> Held {
        let Sides {
            sides,
            unknown,
            settles,
        } = worked_out;
        let small = self.small_here();
        let alone = self.has_new_letter_alone(link, &unknown);
        let equal = residuals.iter().all(Zero::is_zero);
        if equal && self.differs_in_second_order(&sides, &small) {
            return Held::open(messages::SECOND_ORDER);
        }
        let atoms = &mut self.reading.system.atoms;
        let mut held = Held {
            unknown,
            alone,
            sides,
            settles,
            reason: None,
            ..Held::open("")
        };
        if equal {
            held.proof = prove(&mut self.facts, atoms, &held.sides, &small);
            held.standing = Standing::Entailed;
            if held.proof.is_none() {
                held.standing = Standing::Open;
                held.reason = Some("the proof was not found in the budget".into());
                held.beyond = true;
            }
            return held;
        }
        let free = residuals.iter().flat_map(Fraction::variables);
        let free: BTreeSet<_> = free.filter(|&v| atoms.is_unknown(v)).collect();
        let open = !free.is_empty();
        // A new letter that is taken as a number beside matrices would say more than what it is.
        held.restricts = held.sides.len() > 3 && free.len() < 3;
        held.standing = match (open, &held.settles) {
            (true, Some(_)) => Standing::Settles,
            (true, None) => Standing::Free,
            (false, _) => Standing::Denied,
        };
        if held.standing == Standing::Denied {
            self.deny(link, &mut held, residuals);
        } else {
            held.reason = Some("letters of which nothing is told leave it open".into());
        }
        held
    }

    /// Whether one of these letters is a side of a link, or a factor of one, and no line has settled it: only sentences
    /// may tell its shape.
    fn has_new_letter_alone(&self, link: &Link<'_>, unknown: &[String]) -> bool {
        let letters = link.sides().into_iter().flat_map(factors);
        let mut new = letters.filter(|letter| {
            self.reading.shapes.contains_key(letter) || !self.known.shapes.contains_key(letter)
        });
        !unknown.is_empty() && new.any(|letter| unknown.contains(&letter))
    }
}

/// `const`, `\text{const.}`
fn is_constant_word(node: &Node) -> bool {
    matches!(&node.kind, Kind::Symbol(s) if matches!(s.name.trim_end_matches('.'), "const" | "constant"))
}

pub(super) fn nothing_made_of(sentence: &str) -> String {
    format!("nothing was made of the sentence \"{sentence}\"")
}
