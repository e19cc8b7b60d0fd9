//! Words that stand for what the sentences before spoke of: "it", "its", "that of", "this frame".

use super::first_rotations::with_first_rotations;
use super::heads::{ACCELERATION, ANGULAR_VELOCITY, MASS, POSITION, VELOCITY};
use super::lexicon::{Class, Lexicon};
use super::reader::{ARTICLES, COPULAS};
use super::reorder::last_named;
use super::rewrite::put_in;
use super::sentence_parts::{clause, head, is_list, joins, nouns_end, preposition, thing_in};
use super::traits::Trait;
use super::words::{Kind, Token};

/// Words before a noun that has been said.
const POINTING: [&str; 4] = ["that", "this", "those", "these"];

/// Nouns of which "that" and "those" remind.
const REMINDERS: [&str; 3] = ["that", "those", "one"];

/// Looks no further back than so many sentences.
const FURTHEST: usize = 12;

/// The sentence with what was said before in the place of the words that remind of it, each reading on its own; `said`
/// are the sentences before, in their order.
pub(crate) fn referring(tokens: &[Token], said: &[&[Token]], lexicon: &Lexicon) -> Vec<Vec<Token>> {
    let mut all: Vec<Vec<Token>> = said_before(tokens, lexicon).into_iter().collect();
    let last = said.last().copied().unwrap_or_default();
    all.extend(with_first_rotations(tokens, last));
    let mut clauses = said.iter().rev().filter_map(|said| clause(said, lexicon));
    let Some((subject, _, rest)) = clauses.clone().next() else {
        return all;
    };
    let that_of = reminded(tokens, rest, lexicon);
    if that_of != tokens {
        all.push(that_of);
    }
    all.extend(its(
        tokens,
        owner_meant(tokens, subject, rest, lexicon),
        lexicon,
    ));
    if tokens
        .first()
        .is_some_and(|t| matches!(t.lower.as_str(), "it" | "they"))
    {
        all.extend(meant_by_it(tokens, subject, rest));
    }
    let pointed = pointed_at(tokens, lexicon);
    if let Some((at, end)) = pointed {
        let noun = &tokens[at + 1..end];
        let same = |(_, _, rest): &(_, _, &[Token])| words(head(rest, lexicon)) == words(noun);
        let found = clauses.by_ref().take(FURTHEST).find(same);
        all.extend(found.map(|(subject, ..)| [&tokens[..at], subject, &tokens[end..]].concat()));
    }
    all
}

/// "its mass centre and its inertia tensor about that point": a noun that the sentence itself has said.
fn said_before(tokens: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
    let (at, end) = pointed_at(tokens, lexicon)?;
    let noun = words(&tokens[at + 1..end]);
    let before = &tokens[..at];
    let last = (0..before.len())
        .rev()
        .find(|&to| words(&before[..=to]).ends_with(&noun))?;
    let article = |t: &Token| ARTICLES.contains(&t.lower.as_str());
    let from = before[..last].iter().rposition(article)?;
    let end_of_owner = last + owner_behind(&before[last + 1..]);
    Some([before, &before[from..=end_of_owner], &tokens[end..]].concat())
}

/// How many words say whose a noun is that stands before them: "of B", "of the wheel".
fn owner_behind(tokens: &[Token]) -> usize {
    let (Some(of), Some(owner)) = (tokens.first(), tokens.get(1)) else {
        return 0;
    };
    let named = owner.kind == Kind::Formula || owner.text.chars().all(char::is_uppercase);
    match of.lower == "of" {
        true if named => 2,
        true if ARTICLES.contains(&owner.lower.as_str()) && tokens.len() > 2 => 3,
        _ => 0,
    }
}

/// Whose something is that only things have and not their quantities: behind "`$v$` is the velocity of P" its acceleration is
/// that of P.
fn owner_meant<'t>(
    tokens: &[Token],
    subject: &'t [Token],
    rest: &'t [Token],
    lexicon: &Lexicon,
) -> &'t [Token] {
    let pronoun = |t: &Token| matches!(t.lower.as_str(), "its" | "their");
    let behind = tokens.iter().position(pronoun).map(|at| &tokens[at + 1..]);
    let said: Vec<&str> = behind.map(words).unwrap_or_default();
    let of_things = (0..said.len().min(3)).find_map(|at| {
        let noun = lexicon.find(&said[at..], &[Class::Noun])?;
        Some(noun.entry.traits.has(Trait::Bodily) || OF_THINGS.contains(&noun.entry.name))
    });
    let letters = subject.iter().all(|t| t.kind == Kind::Formula || joins(t));
    match owner_said(rest, lexicon).filter(|_| letters && of_things == Some(true)) {
        Some(owner) => owner,
        None => subject,
    }
}

/// Whose a quantity is that a sentence tells: "the velocity of P relative to N".
fn owner_said<'t>(rest: &'t [Token], lexicon: &Lexicon) -> Option<&'t [Token]> {
    rest.first().filter(|t| t.lower == "the")?;
    lexicon.find(&words(head(rest, lexicon)), &[Class::Noun])?;
    let of = rest.iter().position(|t| t.lower == "of")?;
    let behind = &rest[of + 1..];
    let ends = |&at: &usize| joins(&behind[at]) || preposition(&behind[at..], lexicon).is_some();
    let end = (0..behind.len()).find(ends).unwrap_or(behind.len());
    (end > 0).then_some(&behind[..end])
}

/// What points and bodies have, and their quantities have not.
const OF_THINGS: [&str; 7] = [
    POSITION,
    VELOCITY,
    ACCELERATION,
    ANGULAR_VELOCITY,
    MASS,
    "speed",
    "angular acceleration",
];

/// "Its mass is `$m$`", "B is its frame": the mass, and the frame, of what the sentence before is about.
fn its(tokens: &[Token], subject: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
    let at = tokens
        .iter()
        .position(|t| matches!(t.lower.as_str(), "its" | "their"))?;
    let behind_verb = at > 0 && COPULAS.contains(&tokens[at - 1].lower.as_str());
    if at > 0 && !behind_verb {
        return None;
    }
    let (first, rest) = tokens[at..].split_first()?;
    // Another word may be brought to a noun.
    let end = nouns_end(rest, lexicon).max(usize::from(!rest.is_empty()));
    // "its axis z": the letter belongs to the noun
    let axis = end > 0 && matches!(rest[end - 1].lower.as_str(), "axis" | "axes");
    let letter = rest.get(end).filter(|t| t.text.chars().count() == 1);
    let named = axis && letter.is_some_and(|t| t.kind == Kind::Word);
    let (noun, behind) = rest.split_at(end + usize::from(named));
    let [the, of] = ["the", "of"].map(|word| put_in(Kind::Word, word, first));
    // "its mass is `$m$` and its radius is `$a$`" speaks of one thing
    let and = behind
        .windows(2)
        .position(|pair| pair[0].lower == "and" && pair[1].lower == first.lower);
    let again = and.filter(|_| at == 0).and_then(|and| {
        let (before, next) = behind.split_at(and + 1);
        Some([before, &its(next, subject, lexicon)?].concat())
    });
    let behind = again.as_deref().unwrap_or(behind);
    Some([&tokens[..at], &[the], noun, &[of], subject, behind].concat())
}

/// Where a noun stands behind "that" or "this": it has been said before.
fn pointed_at(tokens: &[Token], lexicon: &Lexicon) -> Option<(usize, usize)> {
    let at = tokens
        .iter()
        .position(|t| POINTING.contains(&t.lower.as_str()))?;
    let rest = &tokens[at + 1..];
    let noun = head(rest, lexicon).len();
    (noun > 0).then_some((at, at + 1 + noun))
}

fn words(tokens: &[Token]) -> Vec<&str> {
    tokens.iter().map(|t| t.lower.as_str()).collect()
}

/// "and O is a point fixed in it": the thing of which the first clause speaks. "They" and "them" are several: its subject
/// if that is a list, or what it names last.
pub(super) fn meant_by_it(
    second: &[Token],
    subject: &[Token],
    rest: &[Token],
) -> Option<Vec<Token>> {
    let pronoun = |t: &Token| ["it", "them", "they"].contains(&t.lower.as_str());
    // "both are constant"
    let begins = second.iter().position(|t| t.kind != Kind::Semicolon)?;
    let verb = second.get(begins + 1).is_some_and(|t| t.lower == "are");
    let both = (second[begins].lower == "both" && verb).then_some(begins);
    let at = both.or_else(|| second.iter().position(pronoun))?;
    let owned = |t: &Token| matches!(t.lower.as_str(), "its" | "their");
    if subject.iter().any(owned) {
        return None;
    }
    let several = second[at].lower != "it";
    let many = |tokens: &[Token]| {
        is_list(tokens)
            || tokens
                .last()
                .is_some_and(|t| t.lower.len() > 2 && t.lower.ends_with('s'))
    };
    let last = last_named(rest);
    let meant = match several && !many(subject) {
        true => Some(last).filter(|last| many(last)),
        false => Some(subject),
    };
    Some([&second[..at], meant?, &second[at + 1..]].concat())
}

/// "…; on line 3 it is written `$w$`": each "it" with what the clause before speaks of.
pub(crate) fn with_its(tokens: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
    let semicolon = tokens.iter().position(|t| t.kind == Kind::Semicolon)?;
    let (first, second) = tokens.split_at(semicolon);
    let (subject, _, rest) = clause(first, lexicon)?;
    let second = meant_by_it(second, subject, rest)?;
    Some([first, &second].concat())
}

/// "The body is symmetric about the third axis of the frame B fixed in it": behind a preposition it is the thing that is named
/// before.
pub(crate) fn with_it_inside(tokens: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
    let it = |at: usize| tokens[at].lower == "it" && at > 0;
    let at = (0..tokens.len()).find(|&at| it(at))?;
    let hangs = lexicon.find(&[tokens[at - 1].lower.as_str()], &[Class::Preposition]);
    let hangs = hangs.is_some() || tokens[at - 1].lower == "of";
    let before = &tokens[..at];
    let article = |from: &usize| ARTICLES.contains(&before[*from].lower.as_str());
    let thing = |from: usize| {
        let (_, end) = thing_in(&before[from + 1..], lexicon)?;
        Some(from..from + 1 + end)
    };
    let named = (0..before.len()).rev().filter(article).find_map(thing)?;
    hangs.then(|| [before, &tokens[named], &tokens[at + 1..]].concat())
}

/// The clause with the noun of the first one for "that" and "those".
pub(super) fn reminded(second: &[Token], spoken: &[Token], lexicon: &Lexicon) -> Vec<Token> {
    let reminds = |at: usize| {
        let rest: Vec<&str> = second[at + 1..].iter().map(|t| t.lower.as_str()).collect();
        REMINDERS.contains(&second[at].lower.as_str())
            && lexicon.find(&rest, &[Class::Preposition]).is_some()
    };
    let Some(at) = (0..second.len()).find(|&at| reminds(at)) else {
        return second.to_vec();
    };
    let article = at > 0 && ARTICLES.contains(&second[at - 1].lower.as_str());
    let the = put_in(Kind::Word, "the", &second[at]);
    // "the one about P" is of the same thing
    let noun = match second[at + 1].lower.as_str() {
        "of" => head(spoken, lexicon),
        _ => owned(spoken, lexicon),
    };
    let before = &second[..at - usize::from(article)];
    [before, &[the], noun, &second[at + 1..]].concat()
}

/// The noun with which something begins, and whose it is.
fn owned<'t>(tokens: &'t [Token], lexicon: &Lexicon) -> &'t [Token] {
    let noun = head(tokens, lexicon);
    let start = usize::from(
        tokens
            .first()
            .is_some_and(|t| ARTICLES.contains(&t.lower.as_str())),
    );
    let of = start + noun.len();
    if tokens
        .get(of)
        .is_none_or(|t| !matches!(t.lower.as_str(), "of" | "on"))
    {
        return noun;
    }
    let hangs = |at: usize| {
        let rest: Vec<&str> = tokens[at..].iter().map(|t| t.lower.as_str()).collect();
        tokens[at].kind == Kind::Comma || lexicon.find(&rest, &[Class::Preposition]).is_some()
    };
    let end = (of + 1..tokens.len())
        .find(|&at| hangs(at))
        .unwrap_or(tokens.len());
    &tokens[start..end]
}
