//! What a line is for, by the words that lead into it.

use crate::notation::ast::{Kind, Line, Node};
use crate::notation::print::latex;
use crate::recent::Recent;
use crate::verify::Role;
use crate::verify::language::cues::{Cue, denies_assumption, last_cue};
use crate::verify::standing::chains::Link;
use crate::verify::standing::hold::Held;
use crate::verify::standing::judge::Judge;
use crate::verify::standing::verdicts::Standing;
use crate::verify::term::letters::{Meaning, loosely, spelled};
use crate::verify::term::quantity::Quantity;
use std::cell::RefCell;

/// What stands in a sentence for a relation.
pub(crate) const RELATION: &str = "⟨=⟩";

/// The role of a line and whether words derive it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Purpose {
    pub(crate) role: Role,
    /// "hence", "we find": it is said to follow.
    pub(crate) derived: bool,
    /// Words alone do not say that it holds: it is led in as an assumption but relates several quantities, or it is a
    /// value in running text, which may be spoken of as a case.
    pub(crate) doubtful: bool,
    /// A sentence says what the line is for.
    pub(crate) declared: bool,
}

impl Default for Purpose {
    fn default() -> Self {
        Self {
            role: Role::Claim,
            derived: false,
            doubtful: false,
            declared: false,
        }
    }
}

impl Purpose {
    /// A role that words give.
    fn of(role: Role) -> Self {
        Self {
            role,
            ..Self::default()
        }
    }

    /// The purpose of a line with these links. An assumption says what one quantity is; a row that goes on from one
    /// with more than a quantity is worked out from it, and so is one that goes on from a definition.
    pub(crate) fn on(mut self, continues: bool, links: &[Link<'_>]) -> Self {
        // What a row goes on from is defined already.
        if continues && self.role == Role::Define {
            self.role = Role::Claim;
        }
        let assumed = matches!(self.role, Role::Assume | Role::Given);
        let told =
            |link: &Link<'_>| is_quantity(&link.left) && !continues || is_quantity(&link.right);
        if assumed && !links.iter().all(told) {
            match continues {
                true => self.role = Role::Claim,
                false => self.doubtful = true,
            }
        }
        self
    }

    /// The purpose of a line in running text.
    pub(crate) fn in_text(mut self, links: &[Link<'_>]) -> Self {
        let value = |link: &Link<'_>| is_quantity(&link.left) && is_value(&link.right);
        self.doubtful |= !self.derived && links.iter().all(value);
        self
    }
}

/// Whether a formula is a number.
fn is_value(node: &Node) -> bool {
    match &node.kind {
        Kind::Number(_) => true,
        Kind::Symbol(symbol) => symbol.name == "pi",
        _ => node.children().next().is_some() && node.children().all(is_value),
    }
}

/// Whether a formula is one quantity, its rate, its negative, or a number of it.
fn is_quantity(node: &Node) -> bool {
    match &node.kind {
        Kind::Number(_) | Kind::Symbol(_) => true,
        Kind::Group(_, inner) | Kind::Negate(inner) => is_quantity(inner),
        Kind::TimeDerivative { operand, .. } => is_quantity(operand),
        _ => node.children().next().is_none(),
    }
}

thread_local! {
    /// The sentences that were heard last: lines are looked at several times.
    static HEARD: RefCell<Recent<String, Purpose>> = RefCell::new(Recent::of(MOST_BYTES));
}

/// No more bytes of sentences are kept.
const MOST_BYTES: usize = 1 << 16;

/// What the words of a sentence so far make of the next formula: the last cue counts.
pub(crate) fn purpose(sentence: &str) -> Purpose {
    HEARD.with_borrow_mut(|heard| {
        heard.get(sentence).unwrap_or_else(|| {
            let purpose = told_by(sentence);
            heard.insert(sentence.to_owned(), purpose, sentence.len());
            purpose
        })
    })
}

fn told_by(sentence: &str) -> Purpose {
    let mut purpose = Purpose::default();
    if is_told_in_brackets(sentence) {
        return purpose;
    }
    let (before, behind) = last_paragraph(sentence);
    let goes_on = behind.chars().find(|c| c.is_alphabetic());
    let anew = goes_on.is_some_and(char::is_uppercase);
    if let Some(cue) = last_cue(if anew { behind } else { sentence }) {
        purpose = match cue {
            Cue::Derive => Purpose {
                derived: true,
                ..Purpose::default()
            },
            Cue::Define => Purpose::of(Role::Define),
            Cue::Assume => Purpose::of(Role::Assume),
            Cue::Give => Purpose::of(Role::Given),
        };
    }
    let assumes = matches!(purpose.role, Role::Assume | Role::Given);
    if assumes && denies_assumption(if anew { behind } else { sentence }) {
        return Purpose {
            doubtful: true,
            ..Purpose::default()
        };
    }
    // What is assumed stands in the paragraph behind the words, or words go on from it.
    let assumed = matches!(purpose.role, Role::Assume | Role::Given);
    if assumed && before.is_some() && goes_on.is_none() {
        purpose = Purpose {
            doubtful: true,
            ..Purpose::default()
        };
    }
    purpose
}

impl Judge<'_> {
    /// How a line stands that does not hold but is declared a definition: of a letter that another line has defined, or of
    /// which a sentence says what it is, nobody knows which of the two holds.
    pub(super) fn assumed_definition(&self, line: &Line, held: &Held) -> Standing {
        let letter = line.sides.first().map(spelled);
        let defined = |link: &Link<'_>| Some(spelled(&link.left)) == letter;
        let mut before = self.again.defining.iter().flat_map(|(_, links)| links);
        let told =
            held.standing == Standing::Denied && held.unknown.is_empty() && self.is_left_told(line);
        match told || before.any(defined) {
            true => Standing::Open,
            false => Standing::Free,
        }
    }

    /// Whether the left side of a line is the letter that it is said to define, and a sentence says what quantity that is.
    fn is_left_told(&self, line: &Line) -> bool {
        let Some(left) = line.sides.first() else {
            return false;
        };
        let letters = &self.reading.letters;
        let found = letters.find(&spelled(left), &loosely(left), &self.at, 0);
        let own = |quantity: &Quantity| {
            matches!(
                quantity,
                Quantity::Scalar { .. }
                    | Quantity::Vector { .. }
                    | Quantity::UnitVector { .. }
                    | Quantity::MemberScalar { .. }
                    | Quantity::MemberVector { .. }
            )
        };
        let told = found.is_some_and(
            |letter| matches!(&letter.meaning, Meaning::Quantity(quantity) if !own(quantity)),
        );
        told && self.reading.is_defined_at(&latex(left), &self.at)
    }

    /// Whether what a link settles is said to be defined by another line.
    pub(super) fn defines_by_another_line(&self, held: &Held) -> bool {
        let letter = held.settles.as_ref().map(|(letter, ..)| letter);
        letter.is_some_and(|letter| self.reading.is_defined_elsewhere(letter, &self.at))
    }
}

/// What stands behind the last formula that ends a paragraph, and what stands before that, if there is one.
fn last_paragraph(sentence: &str) -> (Option<&str>, &str) {
    let ends = sentence.rmatch_indices('\n').map(|(at, _)| at);
    let mut before = ends.filter_map(|at| {
        let before = sentence[..at].trim_end_matches(' ');
        before.strip_suffix(RELATION)
    });
    match before.next() {
        Some(before) => (Some(before), &sentence[before.len() + RELATION.len()..]),
        None => (None, sentence),
    }
}

/// Whether a sentence has said what it leads in with a formula in brackets, and ended there: "we assume that the body is
/// symmetric (`A = B`)".
fn is_told_in_brackets(sentence: &str) -> bool {
    let behind = sentence
        .rsplit_once(RELATION)
        .map(|(_, behind)| behind.trim());
    behind == Some(")")
}
