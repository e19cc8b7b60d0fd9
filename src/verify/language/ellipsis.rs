//! Several things said in one sentence: where it parts, and the words that its parts leave out.

use super::lexicon::{Class, Lexicon};
use super::reader::{ARTICLES, COPULAS};
use super::rewrite::put_in;
use super::words::{Kind, Token};

/// Words by which clauses are joined.
const JOINS: [&str; 8] = [
    "and", "while", "whereas", "where", "but", "with", "likewise", "then",
];

/// Words that go on from a thing named just before.
const RELATIVES: [&str; 3] = ["which", "that", "who"];

/// Nouns of which "that" and "those" remind.
const REMINDERS: [&str; 3] = ["that", "those", "one"];

/// The sentence with a semicolon in the place of what joins two clauses there, and with the words that the second one may
/// have left out; none where no clauses are joined.
pub(crate) fn parted_at(tokens: &[Token], at: usize, lexicon: &Lexicon) -> Vec<Vec<Token>> {
    let joined = tokens[at..].iter().take_while(|t| joins(t)).count();
    let start = tokens[..at]
        .iter()
        .rposition(|t| t.kind == Kind::Semicolon)
        .map_or(0, |semicolon| semicolon + 1);
    let (before, first) = tokens[..at].split_at(start);
    let second = &tokens[at + joined..];
    let end = second.iter().position(|t| t.kind == Kind::Semicolon);
    let (second, behind) = second.split_at(end.unwrap_or(second.len()));
    let relative = second.first().is_some_and(is_relative);
    if joined == 0 && !relative || first.is_empty() || second.is_empty() {
        return vec![];
    }
    let sentence = |clauses: (Vec<Token>, Vec<Token>)| {
        let semicolon = put_in(Kind::Semicolon, "", &tokens[at]);
        [before, &clauses.0, &[semicolon], &clauses.1, behind].concat()
    };
    completed(first, second, lexicon)
        .into_iter()
        .map(sentence)
        .collect()
}

fn is_relative(token: &Token) -> bool {
    let word = token.lower.as_str();
    token.kind == Kind::Word && (RELATIVES.contains(&word) || word == "whose")
}

/// A clause that begins with "which" or "whose", said of the thing named last, or of the subject.
fn related(first: &[Token], second: &[Token], lexicon: &Lexicon) -> Vec<Vec<Token>> {
    let Some((relative, rest)) = second.split_first().filter(|(t, _)| is_relative(t)) else {
        return vec![];
    };
    let last = first.last().map(std::slice::from_ref).unwrap_or_default();
    let subject = clause(first, lexicon).map_or(first, |(subject, ..)| subject);
    let whose = |owner: &[Token]| {
        let noun = nouns_end(rest, lexicon);
        let [the, of] = ["the", "of"].map(|word| put_in(Kind::Word, word, relative));
        [&[the], &rest[..noun], &[of], owner, &rest[noun..]].concat()
    };
    [last, subject]
        .iter()
        .map(|owner| match relative.lower.as_str() {
            "whose" => whose(owner),
            _ => [owner, rest].concat(),
        })
        .collect()
}

/// Where the noun ends with which something begins.
fn nouns_end(tokens: &[Token], lexicon: &Lexicon) -> usize {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    let nouns = [Class::Noun, Class::Place];
    let found = (0..tokens.len().min(4)).find_map(|at| {
        let noun = lexicon.find(&words[at..], &nouns)?;
        Some(at + noun.length)
    });
    found.unwrap_or(0)
}

/// How weak the signs are by which two clauses may be joined at a place: a comma and a word, a word, a comma.
pub(crate) fn joint_weakness(tokens: &[Token], at: usize) -> u8 {
    let comma = |t: &&Token| t.kind == Kind::Comma;
    let joined: Vec<&Token> = tokens[at..].iter().take_while(|t| joins(t)).collect();
    match (joined.iter().any(comma), joined.iter().any(|t| !comma(t))) {
        (true, true) => 0,
        (false, true) => 1,
        _ => 2,
    }
}

fn joins(token: &Token) -> bool {
    token.kind == Kind::Comma || token.kind == Kind::Word && JOINS.contains(&token.lower.as_str())
}

/// Two clauses with what each may leave out to the other.
fn completed(
    first: &[Token],
    second: &[Token],
    lexicon: &Lexicon,
) -> Vec<(Vec<Token>, Vec<Token>)> {
    let mut all = vec![(first.to_vec(), second.to_vec())];
    let Some((subject, verb, rest)) = clause(first, lexicon) else {
        return all;
    };
    let whole = first.to_vec();
    let relative = related(first, second, lexicon);
    all.extend(relative.into_iter().map(|second| (whole.clone(), second)));
    all.extend(
        likewise(second, verb, rest)
            .into_iter()
            .map(|second| (whole.clone(), second)),
    );
    let reminded = match agrees(second) {
        true => reminded(second, rest, lexicon),
        false => return all,
    };
    all.push((whole.clone(), reminded.clone()));
    // "and `$b$` the mass of C": the verb of the first
    for second in [second, &reminded] {
        let end = subject_of_gap(second);
        if end > 0 {
            let verb = in_number(verb, &second[..end]);
            let filled = [&second[..end], &verb, &second[end..]].concat();
            all.push((whole.clone(), filled));
        }
        // "and is fixed in B": the subject of the first
        let same = [subject, second].concat();
        all.push((whole.clone(), same));
    }
    let shared = all
        .iter()
        .filter_map(|(_, second)| shared_tail(first, second, lexicon));
    let shared: Vec<_> = shared.collect();
    all.extend(shared);
    all
}

/// "and so is C", "as are A and k": the same is said of another subject.
fn likewise(second: &[Token], verb: &[Token], rest: &[Token]) -> Vec<Vec<Token>> {
    let mut all = vec![];
    let led = second
        .first()
        .is_some_and(|t| ["so", "as"].contains(&t.lower.as_str()));
    if led {
        all.push(second[1..].to_vec());
    }
    let skipped = usize::from(led);
    if let Some(word) = second.get(skipped)
        && matches!(word.lower.as_str(), "is" | "are" | "does" | "do")
    {
        all.push([&second[skipped + 1..], verb, rest].concat());
    }
    all
}

/// "the mass, and `$J$` the inertia tensor, of the hub": what hangs on both stands at the end.
fn shared_tail(
    first: &[Token],
    second: &[Token],
    lexicon: &Lexicon,
) -> Option<(Vec<Token>, Vec<Token>)> {
    let all = |t: &Token| ["both", "all"].contains(&t.lower.as_str());
    let (at, word) = second.iter().enumerate().skip(1).find(|(at, t)| {
        let rest: Vec<&str> = second[*at..].iter().map(|t| t.lower.as_str()).collect();
        let hangs = lexicon.find(&rest, &[Class::Preposition]).is_some();
        hangs && second[at - 1].kind == Kind::Comma || all(t)
    })?;
    let tail = &second[at + usize::from(all(word))..];
    let own = &second[..at];
    let comma = own.last().is_some_and(|last| last.kind == Kind::Comma);
    let own = &own[..own.len() - usize::from(comma)];
    Some(([first, tail].concat(), [own, tail].concat()))
}

/// Subject, verb, and the rest of a clause.
fn clause<'t>(
    tokens: &'t [Token],
    lexicon: &Lexicon,
) -> Option<(&'t [Token], &'t [Token], &'t [Token])> {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    let (at, length) = (1..tokens.len()).find_map(|at| {
        if COPULAS.contains(&words[at]) || matches!(words[at], "means" | "mean") {
            return Some((at, 1));
        }
        let verb = lexicon.find(&words[at..], &[Class::Verb])?;
        let nouns = [Class::Noun, Class::Place, Class::Thing];
        let noun = lexicon.find(&words[at..], &nouns);
        noun.is_none().then_some((at, verb.length))
    })?;
    let (subject, rest) = tokens.split_at(at);
    let (verb, rest) = rest.split_at(length);
    Some((subject, verb, rest))
}

/// Whether "that" stands behind one subject, and "those" behind several.
fn agrees(clause: &[Token]) -> bool {
    let subject = subject_of_gap(clause);
    match clause.get(subject).map(|t| t.lower.as_str()) {
        Some("that") => !is_list(&clause[..subject]),
        Some("those") => is_list(&clause[..subject]),
        _ => true,
    }
}

fn is_list(tokens: &[Token]) -> bool {
    let formula = |t: &Token| matches!(t.kind, Kind::Formula | Kind::Plain) && t.text.contains(',');
    tokens.iter().any(|t| joins(t) || formula(t))
}

/// The verb of one thing or of several.
fn in_number(verb: &[Token], subject: &[Token]) -> Vec<Token> {
    let many = is_list(subject);
    let one = |token: &Token| match (token.lower.as_str(), many) {
        ("is", true) => put_in(Kind::Word, "are", token),
        ("are", false) => put_in(Kind::Word, "is", token),
        _ => token.clone(),
    };
    verb.iter().map(one).collect()
}

/// The clause with the noun of the first one for "that" and "those".
fn reminded(second: &[Token], rest: &[Token], lexicon: &Lexicon) -> Vec<Token> {
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
        "of" => head(rest, lexicon),
        _ => owned(rest, lexicon),
    };
    let before = &second[..at - usize::from(article)];
    [before, &[the], noun, &second[at + 1..]].concat()
}

/// The noun with which something begins, without its article: what stands before the first preposition.
fn head<'t>(tokens: &'t [Token], lexicon: &Lexicon) -> &'t [Token] {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    let start = usize::from(words.first().is_some_and(|word| ARTICLES.contains(word)));
    let nouns = [Class::Noun, Class::Place, Class::Thing];
    let mut at = start;
    while at < tokens.len() {
        if let Some(noun) = lexicon.find(&words[at..], &nouns) {
            return &tokens[start..at + noun.length];
        }
        if lexicon.find(&words[at..], &[Class::Preposition]).is_some() {
            break;
        }
        at += 1;
    }
    &tokens[start..at]
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
    if tokens.get(of).is_none_or(|t| t.lower != "of") {
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

/// How many pieces the subject of a clause takes that has lost its verb: formulas or names up to an article or a preposition.
fn subject_of_gap(tokens: &[Token]) -> usize {
    let ends = |t: &Token| {
        t.kind == Kind::Word && t.lower == t.text && t.text.chars().count() > 1 && t.lower != "and"
    };
    tokens.iter().position(ends).unwrap_or(0)
}
