//! What can be kept of a sentence that is not understood as a whole.

use super::clause::as_formula;
use super::reader::COPULAS;
use super::sentence_parts::joins;
use super::statement::{Declaration, Misread, Statement, Term, Touched};
use super::times::begins_with_time;
use super::unread::CONDITIONS;
use super::words::{Kind, Token};

/// Reads a sentence.
type Sentence<'r> = &'r dyn Fn(&[Token]) -> Result<Vec<Declaration>, Misread>;

/// Words that may take back what stands before them.
const TAKING_BACK: [&str; 16] = [
    "not", "no", "but", "except", "unless", "only", "until", "instead", "rather", "never",
    "without", "neither", "however", "less", "than", "or",
];

/// Words that beside those of a condition begin what a whole sentence depends on: a place, a part of the document.
const LEADING: [&str; 13] = [
    "unless", "except", "as", "for", "at", "in", "on", "only", "without", "with", "from", "under",
    "between",
];

/// Words that may begin a part of the document.
const PLACING: [&str; 11] = [
    "except", "only", "after", "before", "until", "from", "on", "in", "between", "behind", "above",
];

/// Whether what goes on from a clause says when it holds: "at `$q=0$`".
fn has_condition(tokens: &[Token]) -> bool {
    let formula = |t: &Token| matches!(t.kind, Kind::Formula | Kind::Plain);
    let valued = |pair: &[Token]| pair[0].lower == "at" && formula(&pair[1]);
    tokens.iter().any(is_condition) || tokens.windows(2).any(valued)
}

fn is_condition(token: &Token) -> bool {
    CONDITIONS.contains(&token.lower.as_str())
}

/// Whether a sentence may begin with a part of the document.
pub(super) fn may_be_limited(tokens: &[Token]) -> bool {
    let first = tokens.first();
    first.is_some_and(|first| PLACING.contains(&first.lower.as_str())) && !begins_with_time(tokens)
}

/// Nouns of what a thing is, however it moves. A shape may lack something.
const CATEGORIES: [&str; 8] = [
    "frame",
    "point",
    "mass centre",
    "axes",
    "plane",
    "particle",
    "body",
    "rigid body",
];

/// Words behind which stands what follows.
const CONCLUDING: [&str; 4] = ["so", "hence", "therefore", "thus"];

/// Words that stand for what a clause before says.
const POINTING_BACK: [&str; 9] = [
    "it", "its", "they", "their", "them", "that", "those", "this", "these",
];

/// The subject of a clause has no more words than this.
const LONGEST_SUBJECT: usize = 7;

/// What a sentence says by the clauses that are understood, and the rest; `None` for the rest where nothing is left that
/// could say something new.
pub(super) fn kept<'t>(
    tokens: &'t [Token],
    reader: Sentence<'_>,
) -> (Vec<Declaration>, Option<&'t [Token]>) {
    let (mut said, mut rest) = begun(tokens, reader);
    if said.is_empty() {
        (said, rest) = ended(tokens, reader);
    }
    if let Some((last, before)) = last_clause(rest, reader) {
        said.extend(last);
        rest = before;
    }
    // What is said to follow says nothing new.
    let follows = !said.is_empty() && rest.first().is_some_and(concludes);
    (said, (!follows).then_some(rest))
}

/// What the last clause behind a semicolon says by itself, and what stands before it.
fn last_clause<'t>(
    rest: &'t [Token],
    reader: Sentence<'_>,
) -> Option<(Vec<Declaration>, &'t [Token])> {
    let at = rest.iter().rposition(|t| t.kind == Kind::Semicolon)?;
    let (before, last) = (&rest[..at], &rest[at + 1..]);
    let points_back = |t: &Token| POINTING_BACK.contains(&t.lower.as_str());
    let alone = !before.is_empty() && !last.iter().any(points_back);
    let said = reader(last).ok().filter(|_| alone)?;
    said.iter()
        .all(|s| is_categorical(&s.statement))
        .then_some((said, before))
}

/// What a sentence says before what is not understood, and the rest. The rest has to be a clause of its own, with a
/// subject and a verb, for what goes on from a clause may change what it says. What something is stays so however the
/// sentence goes on: "N is an inertial frame, …".
fn begun<'t>(tokens: &'t [Token], reader: Sentence<'_>) -> (Vec<Declaration>, &'t [Token]) {
    let letters = |said: &Declaration| match &said.statement {
        Statement::Is { subjects, .. } => subjects.iter().all(|s| matches!(s, Term::Formula(_))),
        _ => false,
    };
    for at in (1..tokens.len()).rev() {
        let joined = tokens[at..].iter().take_while(|t| joins(t)).count();
        let next = &tokens[at + joined..];
        let formula = |t: &Token| matches!(t.kind, Kind::Formula | Kind::Plain);
        let letter = next.len() > 1 && formula(&next[0]) && next[1].kind == Kind::Word;
        let apart = tokens[at].kind == Kind::Comma && has_own_subject(next);
        let clause = joined > 0 && (letter || apart);
        let follows = tokens[at].kind == Kind::Comma && next.first().is_some_and(concludes);
        let adds = !next.is_empty()
            && !tokens[at..].iter().any(takes_back)
            && !has_condition(&tokens[at..]);
        // What a participle hangs on is behind it.
        let open = tokens[at - 1].lower.ends_with("ed");
        if open || !(clause || adds || follows) {
            continue;
        }
        if let Ok(said) = reader(&tokens[..at])
            && (follows
                || clause && (said.iter().all(letters) || apart)
                || adds && said.iter().all(|said| is_categorical(&said.statement)))
        {
            return (said, next);
        }
    }
    (vec![], tokens)
}

/// What the last clause of a sentence says by itself, and the clauses before it, which are not understood.
fn ended<'t>(tokens: &'t [Token], reader: Sentence<'_>) -> (Vec<Declaration>, &'t [Token]) {
    let leading = |t: &Token| is_condition(t) || LEADING.contains(&t.lower.as_str());
    if tokens.first().is_some_and(leading) {
        return (vec![], tokens);
    }
    let points_back = |t: &Token| POINTING_BACK.contains(&t.lower.as_str());
    for at in 1..tokens.len() {
        let parted = matches!(tokens[at].kind, Kind::Semicolon | Kind::Comma);
        let joined = tokens[at..].iter().take_while(|t| parts(t)).count();
        let last = &tokens[(at + joined).min(tokens.len())..];
        let limited = tokens[..at].iter().any(begins_extent);
        // Without a verb before it a comma stands in a list.
        let copula = |t: &Token| COPULAS.contains(&t.lower.as_str());
        let in_list = tokens[at].kind == Kind::Comma && !tokens[..at].iter().any(copula);
        if !parted || limited || in_list || last.is_empty() || last.iter().any(points_back) {
            continue;
        }
        let told = |said: &Declaration| !matches!(said.statement, Statement::Holds(_));
        if let Ok(said) = reader(last)
            && !said.is_empty()
            && said.iter().all(told)
        {
            return (said, &tokens[..at]);
        }
    }
    (vec![], tokens)
}

fn parts(token: &Token) -> bool {
    matches!(token.kind, Kind::Semicolon | Kind::Comma) || token.lower == "and"
}

/// Words that may begin the part of the document of which a whole sentence speaks.
fn begins_extent(token: &Token) -> bool {
    matches!(
        token.lower.as_str(),
        "line" | "lines" | "section" | "cell" | "cells"
    )
}

/// Whether a statement says what a thing is.
fn is_categorical(statement: &Statement) -> bool {
    matches!(statement, Statement::Is { what, .. } if CATEGORIES.contains(&what.head))
}

fn takes_back(token: &Token) -> bool {
    TAKING_BACK.contains(&token.lower.as_str()) || token.lower.ends_with("n't")
}

fn concludes(token: &Token) -> bool {
    CONCLUDING.contains(&token.lower.as_str())
}

/// Whether a clause begins with a noun and its article, and a verb follows: "the third of them is …".
fn has_own_subject(clause: &[Token]) -> bool {
    let article = |t: &Token| matches!(t.lower.as_str(), "the" | "its" | "their" | "there");
    let verb = |t: &Token| COPULAS.contains(&t.lower.as_str());
    clause.first().is_some_and(article) && clause.iter().take(LONGEST_SUBJECT).any(verb)
}

/// A clause that is not understood may speak of what those before it are about.
pub(super) fn speak_of_subjects(unread: &mut Declaration, before: &[Declaration]) {
    let Statement::Unread {
        touched: Touched::Letters { formulas, .. } | Touched::Written(formulas),
        ..
    } = &mut unread.statement
    else {
        return;
    };
    let subjects = before.iter().flat_map(|said| said.statement.subjects());
    formulas.extend(subjects.filter_map(as_formula));
}
