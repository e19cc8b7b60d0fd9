//! Sentences that say several things of one thing at once, as one clause for each: "A uniform rod of mass `$m$` that turns
//! about z is hinged at O" says that the rod is uniform, has a mass, turns, and is hinged.

use super::heads::SIZES;
use super::lexicon::{Class, Lexicon};
use super::reader::{ARTICLES, COPULAS};
use super::rewrite::put_in;
use super::sentence_parts::{clause, head, thing_in};
use super::words::{Kind, Token};

/// A sentence is told apart no more often.
const MOST_TIMES: usize = 6;

/// The clauses of a sentence, each saying one thing; `None` where it says no more than one.
pub(super) fn told_apart(tokens: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
    let mut now: Option<Vec<Token>> = None;
    for _ in 0..MOST_TIMES {
        let tokens = now.as_deref().unwrap_or(tokens);
        let (done, last) = split_last(tokens);
        let Some(next) = relative_clause(last, lexicon).or_else(|| described(last, lexicon)) else {
            break;
        };
        now = Some([done, &next].concat());
    }
    now
}

/// The clauses before the last semicolon, with it, and the last clause.
fn split_last(tokens: &[Token]) -> (&[Token], &[Token]) {
    let at = tokens.iter().rposition(|t| t.kind == Kind::Semicolon);
    tokens.split_at(at.map_or(0, |at| at + 1))
}

/// "A rod of mass `$m$` swings" as "The rod is a rod of mass `$m$`; the rod swings".
fn described(tokens: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
    let (subject, verb, rest) = clause(tokens, lexicon)?;
    let (article, noun) = subject.split_first()?;
    if !ARTICLES.contains(&article.lower.as_str()) {
        return None;
    }
    let (start, end) = thing_in(noun, lexicon)?;
    let named = noun.get(end).filter(|t| is_name(t));
    let described = end + usize::from(named.is_some());
    let behind = &noun[described..];
    let sized = behind
        .first()
        .is_some_and(|t| matches!(t.lower.as_str(), "of" | "with"))
        && names_size(&behind[1..], lexicon);
    let new = article.lower != "the" && start > 0 && behind.is_empty();
    if !sized && !new {
        return None;
    }
    let [the, is, a] = ["the", "is", "a"].map(|word| put_in(Kind::Word, word, article));
    let own: Vec<Token> = match named {
        Some(name) => vec![name.clone()],
        None => [std::slice::from_ref(&the), &noun[start..end]].concat(),
    };
    let semicolon = put_in(Kind::Semicolon, "", article);
    let what = [&[is, a], &noun[..end], behind].concat();
    Some([&own, &what[..], &[semicolon], &own, verb, rest].concat())
}

fn is_name(token: &Token) -> bool {
    let capital = token.text.chars().next().is_some_and(char::is_uppercase);
    token.kind == Kind::Word && capital && token.text.chars().count() <= 2
}

/// Whether a size or a mass comes next: "mass `$m$`", "equal lengths".
fn names_size(tokens: &[Token], lexicon: &Lexicon) -> bool {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    let article = usize::from(words.first().is_some_and(|word| ARTICLES.contains(word)));
    let words = words.get(article..).unwrap_or_default();
    let adjective = lexicon
        .find(words, &[Class::Adjective])
        .map_or(0, |a| a.length);
    [0, adjective].iter().any(|&skip| {
        let noun = lexicon.find(words.get(skip..).unwrap_or_default(), &[Class::Noun]);
        noun.is_some_and(|noun| SIZES.contains(&noun.entry.name))
    })
}

/// "X is a disc that rolls" as "X is a disc; X rolls", "on a floor whose normal is n" as "on a floor; the normal of the floor
/// is n".
fn relative_clause(tokens: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
    let (subject, verb, rest) = clause(tokens, lexicon)?;
    let behind = subject.len() + verb.len();
    let at = (0..rest.len()).find(|&at| at > 0 && opens_clause(rest, at, lexicon))?;
    let before = &tokens[..behind + at];
    let predicate = &before[behind..];
    let (relative, inside) = rest[at..].split_first()?;
    let (inside, more) = inside.split_at(end_of_clause(inside));
    let is = verb
        .first()
        .is_some_and(|t| COPULAS.contains(&t.lower.as_str()));
    let letter = subject.last().is_some_and(|t| t.kind == Kind::Formula);
    let whose = match is {
        true if is_one_noun(predicate) && !letter => subject.to_vec(),
        // Of two nouns it may be either.
        true if begins_with_article(predicate) => return None,
        _ => named_last(predicate, lexicon)?,
    };
    let joint = [put_in(Kind::Semicolon, "", relative)];
    let told = match relative.lower.as_str() {
        "whose" => {
            let (noun, _, _) = clause(inside, lexicon)?;
            let [the, of] = ["the", "of"].map(|word| put_in(Kind::Word, word, relative));
            [&[the], noun, &[of], &whose, &inside[noun.len()..]].concat()
        }
        _ => [&whose, inside].concat(),
    };
    let more = match more.split_first() {
        Some((_, rest)) if joins_verb(rest, lexicon) => [subject, &rest[1..]].concat(),
        Some((_, rest)) => rest.to_vec(),
        None => return Some([before, &joint, &told].concat()),
    };
    Some([before, &joint, &told, &joint, &more].concat())
}

/// Whether a clause about the noun before begins here.
fn opens_clause(tokens: &[Token], at: usize, lexicon: &Lexicon) -> bool {
    let words: Vec<&str> = tokens[at..].iter().map(|t| t.lower.as_str()).collect();
    let verb = |from: usize| {
        let rest = words.get(from..).unwrap_or_default();
        rest.first().is_some_and(|word| COPULAS.contains(word))
            || lexicon.find(rest, &[Class::Verb]).is_some()
    };
    let hangs = lexicon
        .find(&[tokens[at - 1].lower.as_str()], &[Class::Preposition])
        .is_some();
    match words[0] {
        "that" | "which" => !hangs && tokens[at - 1].kind != Kind::Comma && verb(1),
        "whose" => tokens[at - 1].kind != Kind::Comma && (2..words.len().min(6)).any(verb),
        _ => false,
    }
}

/// Where a relative clause ends: where another clause is joined.
fn end_of_clause(inside: &[Token]) -> usize {
    let ends = |at: usize| {
        let joined = inside.get(at + 1).is_some_and(|t| t.lower == "and");
        inside[at].kind == Kind::Comma && joined
    };
    (0..inside.len())
        .find(|&at| ends(at))
        .unwrap_or(inside.len())
}

/// "and turns about z": what goes on with the subject.
fn joins_verb(tokens: &[Token], lexicon: &Lexicon) -> bool {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    let rest = words.get(1..).unwrap_or_default();
    let verb = rest.first().is_some_and(|word| COPULAS.contains(word))
        || lexicon.find(rest, &[Class::Verb]).is_some();
    words.first() == Some(&"and") && verb
}

/// Whether a predicate is a noun with an article, and no other noun with an article stands in it.
fn is_one_noun(predicate: &[Token]) -> bool {
    let article = |t: &Token| ARTICLES.contains(&t.lower.as_str());
    let last = predicate.iter().rposition(article);
    last == Some(0)
}

fn begins_with_article(tokens: &[Token]) -> bool {
    tokens
        .first()
        .is_some_and(|t| ARTICLES.contains(&t.lower.as_str()))
}

/// What is named last: by its own name, or by the noun with the last article, without what describes it.
fn named_last(tokens: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
    let article = |t: &Token| ARTICLES.contains(&t.lower.as_str());
    if let [.., before, last] = tokens
        && is_name(last)
        && before.kind == Kind::Word
    {
        return Some(vec![last.clone()]);
    }
    let at = tokens.iter().rposition(article)?;
    let noun = head(&tokens[at..], lexicon);
    (!noun.is_empty()).then(|| [&[put_in(Kind::Word, "the", &tokens[at])], noun].concat())
}
