//! What a statement speaks of.

use super::clause::as_formula;
use super::statement::{Declaration, Extent, Formula, NounPhrase, Slot, Statement, Term, Touched};
use crate::notation::ast::Node;
use crate::notation::document::Row;
use crate::notation::print::latex;

/// What is said of a number, and of how a letter is counted.
const SIGNS: [&str; 2] = ["positive", "negative"];

/// What does something, and what hangs on the verb.
pub(crate) type Doing<'s> = (&'s [Term], &'s [(Slot, Term)]);

impl Term {
    /// The formula that a term is, or that stands beside its noun.
    pub(crate) fn letter(&self) -> Option<&Formula> {
        match self {
            Self::Formula(letter) => Some(letter),
            Self::Phrase(phrase) => match phrase.slot(Slot::Which)? {
                Self::Formula(letter) => Some(letter),
                _ => None,
            },
            _ => None,
        }
    }
}

impl Statement {
    /// What a clause is about.
    pub(crate) fn subjects(&self) -> &[Term] {
        match self {
            Self::Is { subjects, .. }
            | Self::Same { subjects, .. }
            | Self::Does { subjects, .. } => subjects,
            _ => &[],
        }
    }

    /// What a verb is said of, and what hangs on it.
    pub(crate) fn does(&self, wanted: &str) -> Option<Doing<'_>> {
        match self {
            Self::Does {
                subjects,
                verb,
                slots,
            } if *verb == wanted => Some((subjects, slots)),
            _ => None,
        }
    }

    /// What is said to lie or to be placed somewhere, and where.
    pub(crate) fn places(&self) -> Option<Doing<'_>> {
        self.does("lie").or_else(|| self.does("place"))
    }

    /// "G is the middle of the rod": what one thing is.
    pub(crate) fn one_is(subject: Term, what: NounPhrase) -> Self {
        let subjects = vec![subject];
        Self::Is { subjects, what }
    }

    /// What hangs on the verb or the noun of a clause, and on each of its phrases.
    pub(crate) fn slots(&self) -> impl Iterator<Item = &[(Slot, Term)]> {
        let own: &[(Slot, Term)] = match self {
            Self::Is { what, .. } | Self::Premise(what) => &what.slots,
            Self::Does { slots, .. } => slots,
            _ => &[],
        };
        let phrases = self.terms().into_iter().filter_map(|term| match term {
            Term::Phrase(phrase) => Some(phrase.slots.as_slice()),
            _ => None,
        });
        std::iter::once(own).chain(phrases)
    }

    /// All terms of a clause, those inside phrases as well.
    pub(crate) fn terms(&self) -> Vec<&Term> {
        let (first, slots): (Vec<&Term>, &[(Slot, Term)]) = match self {
            Self::Is { subjects, what } => (subjects.iter().collect(), &what.slots),
            Self::Same { subjects, others } => (subjects.iter().chain(others).collect(), &[]),
            Self::Does {
                subjects, slots, ..
            } => (subjects.iter().collect(), slots),
            Self::Premise(phrase) => (vec![], &phrase.slots),
            _ => (vec![], &[]),
        };
        let mut terms = first;
        terms.extend(slots.iter().map(|(_, term)| term));
        let mut at = 0;
        while let Some(&term) = terms.get(at) {
            if let Term::Phrase(phrase) = term {
                terms.extend(phrase.slots.iter().map(|(_, term)| term));
            }
            at += 1;
        }
        terms
    }

    /// All formulas of a clause, or the one that is said to hold.
    pub(crate) fn formulas(&self) -> Vec<&Formula> {
        let terms = self.terms().into_iter();
        let formulas = terms.filter_map(|term| match term {
            Term::Formula(formula) => Some(formula),
            _ => None,
        });
        match self {
            Self::Holds(formula) => vec![formula],
            _ => formulas.collect(),
        }
    }

    /// What a clause is about, and what hangs on its noun or verb.
    pub(crate) fn terms_mut(&mut self) -> Vec<&mut Term> {
        fn slots(slots: &mut [(Slot, Term)]) -> Vec<&mut Term> {
            slots.iter_mut().map(|(_, term)| term).collect()
        }
        let (mut terms, hanging): (Vec<&mut Term>, Vec<&mut Term>) = match self {
            Self::Is { subjects, what } => (subjects.iter_mut().collect(), slots(&mut what.slots)),
            Self::Same { subjects, others } => {
                (subjects.iter_mut().chain(others).collect(), vec![])
            }
            Self::Does {
                subjects,
                slots: own,
                ..
            } => (subjects.iter_mut().collect(), slots(own)),
            Self::Premise(phrase) => (vec![], slots(&mut phrase.slots)),
            _ => (vec![], vec![]),
        };
        terms.extend(hanging);
        terms
    }
}

impl Declaration {
    /// A sentence that was not read, and may tell of anything.
    pub(crate) fn unread(text: String) -> Self {
        Self {
            statement: Statement::Unread {
                letters: vec![],
                touched: Touched::Everything,
            },
            extent: Extent::Document,
            text,
            line: 0,
        }
    }

    /// The sentence as one that was not understood: one about letters may change what these mean.
    pub(crate) fn not_understood(self) -> Self {
        let subjects = self.statement.subjects();
        let letters = subjects.iter().map(as_formula);
        let letters: Option<Vec<Formula>> = letters.collect();
        let named = letters.filter(|letters| !letters.is_empty());
        // How things move and what acts on them changes no letter but those that tell of it.
        let moving = match &self.statement {
            Statement::Premise(premise) if premise.is("not") => None,
            // From where a turn is counted, and which way.
            Statement::Does {
                verb: "turn",
                slots,
                ..
            } if slots.iter().any(|(slot, _)| *slot == Slot::With) => None,
            Statement::Does { .. } | Statement::Premise(_) => {
                let terms = self.statement.terms().into_iter();
                Some(terms.filter_map(as_formula).collect())
            }
            _ => None,
        };
        let anew = self.extent != Extent::Document || self.statement.tells_sense();
        let touched = match named.or(moving) {
            // What a letter is said to be, or not to be, may be more than what other sentences tell of it.
            Some(formulas) if !anew && matches!(self.statement, Statement::Is { .. }) => {
                Touched::Written(formulas)
            }
            Some(formulas) => Touched::Letters { formulas, anew },
            None => Touched::Everything,
        };
        let letters = vec![];
        Self {
            statement: Statement::Unread { letters, touched },
            ..self
        }
    }

    /// Another thing that the sentence says.
    pub(crate) fn saying(&self, statement: Statement) -> Self {
        Self {
            statement,
            ..self.clone()
        }
    }

    /// The sentence as it is named in messages: without its full stop.
    pub(crate) fn sentence(&self) -> &str {
        self.text.trim_end_matches('.')
    }

    /// Whether the sentence was not understood and has one of some words in lower case.
    pub(crate) fn may_speak_of(&self, words: &[&str]) -> bool {
        let plain = |word: &str| {
            let word = word.trim_matches(|c: char| !c.is_alphanumeric());
            words.contains(&word.to_lowercase().as_str())
        };
        self.is_unread() && self.text.split_whitespace().any(plain)
    }

    /// Whether the sentence was not understood.
    pub fn is_unread(&self) -> bool {
        matches!(self.statement, Statement::Unread { .. })
    }
}

/// Adds what sentences say besides; what is left of each is put in its place.
pub(crate) fn say_besides(
    declarations: &mut Vec<Declaration>,
    mut besides: impl FnMut(&mut Statement) -> Vec<Statement>,
) {
    let mut told = vec![];
    for declaration in declarations.iter_mut() {
        let statements = besides(&mut declaration.statement);
        told.extend(statements.into_iter().map(|s| declaration.saying(s)));
    }
    declarations.extend(told);
}

impl Statement {
    /// "`$M$` is positive towards growing `$\\theta$`": how a letter is counted, whatever other sentences tell of it.
    pub(crate) fn tells_sense(&self) -> bool {
        match self {
            Self::Is { what, .. } => SIGNS.contains(&what.head) && what.slot(Slot::With).is_some(),
            _ => false,
        }
    }
}

impl Term {
    /// Whether it is said by a noun or an adverb, whatever hangs on it.
    pub(crate) fn is_noun(&self, head: &str) -> bool {
        matches!(self, Self::Phrase(phrase) if phrase.head == head)
    }

    /// Whether it is a relation: behind "at" and "when" a condition.
    pub(crate) fn is_condition(&self) -> bool {
        matches!(self, Self::Formula(formula) if matches!(formula.row, Row::Line(_)))
    }
}

impl NounPhrase {
    /// "a rod of length `$l$`": how large it is by a noun.
    pub(crate) fn size(&self, noun: &str) -> Option<&Term> {
        self.all(Slot::Of).find_map(|of| match of {
            Term::Phrase(size) if size.head == noun => size.slot(Slot::Which),
            _ => None,
        })
    }
}

impl Formula {
    /// Its tree, if it is an expression.
    pub(crate) fn node(&self) -> Option<&Node> {
        match &self.row {
            Row::Expression(node) => Some(node),
            _ => None,
        }
    }

    /// A formula that stands inside another one.
    pub(crate) fn of(node: &Node) -> Self {
        Self {
            source: latex(node),
            row: Row::Expression(node.clone()),
        }
    }
}

/// Takes out the sentences at some places.
pub(super) fn leave_out(declarations: &mut Vec<Declaration>, places: &[usize]) {
    let mut at = 0..;
    declarations.retain(|_| at.next().is_some_and(|at| !places.contains(&at)));
}
