//! Several things said in one sentence: where it parts, and the words that its parts leave out.

use super::anaphora::{meant_by_it, reminded};
use super::heads::SIZES;
use super::lexicon::{Class, Lexicon};
use super::named_things::{is_way_of_load, stands_in, without_comma};
use super::reader::{ARTICLES, COPULAS};
use super::reorder::last_named;
use super::rewrite::put_in;
use super::sentence_parts::{HELD, clause, is_list, joins, nouns_end, preposition};
use super::words::{Kind, Token};

/// What things do and letters do not.
const MOVES: [&str; 15] = [
    "lies", "lie", "moves", "turns", "rolls", "slides", "swings", "rests", "hangs", "hang",
    "spins", "rotates", "stands", "touches", "carries",
];

/// Words for what the clause before speaks of.
const PRONOUNS: [&str; 2] = ["it", "they"];

/// Words that go on from a thing named just before.
const RELATIVES: [&str; 3] = ["which", "that", "who"];

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
    let listed = is_condition(first) && matches!(second, [formula] if is_formula(formula));
    let nothing = first.is_empty() || second.is_empty() || listed;
    let timed = is_time(&tokens[at..at + joined], second);
    if joined == 0 && !relative || nothing || timed || in_list(tokens, at) {
        return vec![];
    }
    let sentence = |clauses: (Vec<Token>, Vec<Token>)| {
        let semicolon = put_in(Kind::Semicolon, "", &tokens[at]);
        [before, &clauses.0, &[semicolon], &clauses.1, behind].concat()
    };
    let clauses = match joined {
        0 => related(without_comma(first), second, lexicon)
            .into_iter()
            .map(|second| (first.to_vec(), second))
            .collect(),
        _ => completed(first, second, lexicon),
    };
    clauses.into_iter().map(sentence).collect()
}

/// Whether what joins two clauses makes the second one the time in which alone the first holds: "while it moves". Behind a
/// comma, and where the next clause says what another letter is, the word only sets one beside the other.
fn is_time(joined: &[Token], second: &[Token]) -> bool {
    let [.., word] = joined else { return false };
    let letter = second.first().is_some_and(|t| t.kind == Kind::Formula);
    let pronoun = second
        .first()
        .is_some_and(|t| PRONOUNS.contains(&t.lower.as_str()));
    word.lower == "while" && (joined.len() == 1 && !letter || pronoun)
}

/// Whether words end with a condition: a formula that stands alone behind it is another one, and no clause.
fn is_condition(tokens: &[Token]) -> bool {
    match tokens {
        [.., when, formula] => CONDITIONAL.contains(&when.lower.as_str()) && is_formula(formula),
        _ => false,
    }
}

fn is_formula(token: &Token) -> bool {
    matches!(token.kind, Kind::Formula | Kind::Plain)
}

/// Words before a formula by which it is a condition.
const CONDITIONAL: [&str; 6] = ["at", "when", "while", "for", "where", "if"];

/// Whether a comma stands between the letters of a list that begins behind another comma: "on B, `$a$`, `$b$` those of C".
fn in_list(tokens: &[Token], at: usize) -> bool {
    let formula = |t: &Token| matches!(t.kind, Kind::Formula | Kind::Plain);
    let mut before = &tokens[..at];
    while let [rest @ .., comma, letter] = before
        && formula(letter)
        && joins(comma)
    {
        if rest.last().is_some_and(|t| !formula(t) && !joins(t)) {
            return true;
        }
        before = rest;
    }
    false
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
    let several = rest.iter().any(|t| t.lower == "are");
    let last = match last_letters(first).filter(|_| several) {
        Some(letters) => letters,
        None => last_named(first),
    };
    let subject = clause(first, lexicon).map_or(first, |(subject, ..)| subject);
    // "which it touches at C"
    if let [it, rest @ ..] = rest
        && matches!(it.lower.as_str(), "it" | "they")
    {
        let words: Vec<&str> = rest.iter().map(|t| t.lower.as_str()).collect();
        let verb = lexicon.find(&words, &[Class::Verb]);
        let (verb, behind) = rest.split_at(verb.map_or(0, |verb| verb.length));
        return vec![[subject, verb, last, behind].concat()];
    }
    let whose = |owner: &[Token]| {
        let noun = nouns_end(rest, lexicon);
        let [the, of] = ["the", "of"].map(|word| put_in(Kind::Word, word, relative));
        [&[the], &rest[..noun], &[of], owner, &rest[noun..]].concat()
    };
    // A force acts, and not the body that it is told of.
    let acts = rest.first().is_some_and(|t| t.lower.starts_with("act"));
    // A thing lies and moves, and not the size that was told of it.
    let moves = rest
        .first()
        .is_some_and(|t| MOVES.contains(&t.lower.as_str()));
    let letter = |tokens: &[Token]| tokens.iter().all(|t| t.kind == Kind::Formula);
    let moves =
        (moves || is_joined(rest) && ends_with_size(first)) && letter(last) && !letter(subject);
    // "the kinetic energy of the top, which is not zero": a letter is, and not a thing.
    let valued =
        (is_of_quantities(rest) || is_way_of_load(first, rest)) && letter(subject) && !letter(last);
    // "B is the body frame, which is fixed in the body": what B is said to be is B.
    let whole = clause(first, lexicon).is_some_and(|(_, verb, said)| {
        let is = matches!(verb, [verb] if COPULAS.contains(&verb.lower.as_str()));
        let article = last
            .first()
            .is_some_and(|t| ARTICLES.contains(&t.lower.as_str()));
        is && article && said.len() == last.len()
    });
    let owners = match acts || moves || valued || whole {
        true => [subject, last],
        false => [last, subject],
    };
    // A clause does not name what it is said of.
    let owners = owners.iter().filter(|owner| !stands_in(owner, rest));
    owners
        .flat_map(|owner| match relative.lower.as_str() {
            "whose" => vec![whose(owner)],
            // "which is fixed in B", "which line 7 defines"
            _ => vec![[owner, rest].concat(), [rest, owner].concat()],
        })
        .collect()
}

/// What else is said of bodies, and not of the sizes that are told of them.
const JOINED: [&str; 3] = ["fixed", "released", "symmetric"];

/// "is hinged at O", "are rigidly attached"
fn is_joined(rest: &[Token]) -> bool {
    let mut words = rest.iter().map(|t| t.lower.as_str());
    let copula = words.next().is_some_and(|word| COPULAS.contains(&word));
    copula
        && words
            .find(|word| !word.ends_with("ly"))
            .is_some_and(|word| HELD.contains(&word) || JOINED.contains(&word))
}

/// "of mass `$m$` and length `$l$`": the letter at the end is that of a size.
fn ends_with_size(first: &[Token]) -> bool {
    match first {
        [.., size, letter] => letter.kind == Kind::Formula && SIZES.contains(&size.lower.as_str()),
        _ => false,
    }
}

/// What only quantities are.
const OF_QUANTITIES: [&str; 6] = [
    "zero", "positive", "negative", "nonzero", "constant", "small",
];

/// "is not zero"
fn is_of_quantities(rest: &[Token]) -> bool {
    let mut words = rest.iter().map(|t| t.lower.as_str());
    let copula = words.next().is_some_and(|word| COPULAS.contains(&word));
    copula
        && words
            .find(|word| *word != "not")
            .is_some_and(|word| OF_QUANTITIES.contains(&word))
}

/// The letters at the end of a clause, if they are several.
fn last_letters(tokens: &[Token]) -> Option<&[Token]> {
    let listed = |t: &Token| t.kind == Kind::Formula || joins(t);
    let start = tokens
        .iter()
        .rposition(|t| !listed(t))
        .map_or(0, |at| at + 1);
    let letters = &tokens[start..];
    let count = letters.iter().filter(|t| t.kind == Kind::Formula).count();
    (count > 1).then_some(letters)
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
    all.extend(described(first, second).map(|second| (whole.clone(), second)));
    let others = likewise(second, verb, rest);
    let others = others
        .into_iter()
        .chain(instead(first, second, lexicon))
        .chain(meant_by_it(second, subject, rest));
    all.extend(others.map(|second| (whole.clone(), second)));
    if !agrees(second) {
        return all;
    }
    let reminded = [rest, subject].map(|spoken| reminded(second, spoken, lexicon));
    all.extend(
        reminded
            .iter()
            .map(|second| (whole.clone(), second.clone())),
    );
    // "and `$b$` the mass of C": the verb of the first
    // A letter does not do what a thing does.
    let letter = |tokens: &[Token]| tokens.first().is_some_and(|t| t.kind == Kind::Formula);
    for second in [second, &reminded[0]] {
        if letter(second) && !letter(subject) {
            continue;
        }
        for end in subjects_of_gap(second, lexicon) {
            all.extend(fuller(first, second, (subject, end), lexicon).map(|s| (whole.clone(), s)));
            let verb = in_number(verb, &second[..end]);
            let filled = [&second[..end], &verb, &second[end..]].concat();
            all.push((whole.clone(), filled));
        }
        // "and is fixed in B", "and fixed in B": the subject of the first
        if !letter(second) {
            all.push((whole.clone(), [subject, second].concat()));
        }
        let words: Vec<&str> = second.iter().map(|t| t.lower.as_str()).collect();
        let said = [Class::Adjective, Class::Preposition, Class::Passive];
        if lexicon.find(&words, &said).is_some() {
            all.push((whole.clone(), [subject, verb, second].concat()));
        }
    }
    let shared = all
        .iter()
        .filter_map(|(_, second)| shared_tail(first, second, lexicon));
    let shared: Vec<_> = shared.collect();
    all.extend(shared);
    all
}

/// "about O, a point fixed in N": what was named last is that.
fn described(first: &[Token], second: &[Token]) -> Option<Vec<Token>> {
    let article = |t: &&Token| t.kind == Kind::Word && matches!(t.text.as_str(), "a" | "an");
    let is = put_in(Kind::Word, "is", second.first().filter(article)?);
    Some([last_named(first), &[is], second].concat())
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

/// "and also of the wheel": the same is said with another end.
fn instead(first: &[Token], second: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
    let also = second.first().is_some_and(|t| t.lower == "also");
    let second = &second[usize::from(also)..];
    let word = second.first()?;
    preposition(second, lexicon)?;
    let at = first.iter().rposition(|t| t.lower == word.lower)?;
    Some([&first[..at], second].concat())
}

/// "P is placed from O by `$r$`, and Q by `$s$`": another subject, and another end behind the same preposition.
fn fuller(
    first: &[Token],
    second: &[Token],
    (subject, end): (&[Token], usize),
    lexicon: &Lexicon,
) -> Option<Vec<Token>> {
    let rest = &second[end..];
    preposition(rest, lexicon)?;
    let word = rest.first()?;
    let at = first.iter().rposition(|t| t.lower == word.lower)?;
    let said = first.get(subject.len()..at)?;
    // "with the angular velocity `$p$`, the rotor with `$q$`": the noun of the first letter is that of the second.
    let noun = match (&first[at + 1..], &rest[1..]) {
        ([noun @ .., own], [other]) if is_formula(own) && is_formula(other) => noun,
        _ => &[],
    };
    let noun = match noun
        .first()
        .is_some_and(|t| ARTICLES.contains(&t.lower.as_str()))
    {
        true if !noun.iter().any(is_formula) => noun,
        _ => &[],
    };
    Some([&second[..end], said, &rest[..1], noun, &rest[1..]].concat())
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

/// Whether "that" stands behind one subject, and "those" behind several.
fn agrees(clause: &[Token]) -> bool {
    let subject = subject_of_gap(clause);
    match clause.get(subject).map(|t| t.lower.as_str()) {
        Some("that") => !is_list(&clause[..subject]),
        Some("those") => is_list(&clause[..subject]),
        _ => true,
    }
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

/// How many pieces the subject of a clause takes that has lost its verb: formulas or names up to an article or a preposition.
fn subject_of_gap(tokens: &[Token]) -> usize {
    let ends = |t: &Token| {
        let word = t.lower == t.text && t.text.chars().count() > 1 && t.lower != "and";
        t.kind == Kind::Word && (word || t.text == "a")
    };
    tokens.iter().position(ends).unwrap_or(0)
}

/// The same where the subject may be a phrase as well, "a prime", "the label S": it ends where another article stands, or
/// something that hangs on it.
fn subjects_of_gap(tokens: &[Token], lexicon: &Lexicon) -> Vec<usize> {
    let article = |t: &Token| ARTICLES.contains(&t.lower.as_str());
    match subject_of_gap(tokens) {
        0 if tokens.first().is_some_and(article) => {
            let ends = |&at: &usize| {
                article(&tokens[at])
                    || tokens[at].lower == "that"
                    || preposition(&tokens[at..], lexicon).is_some()
            };
            (2..tokens.len()).find(ends).into_iter().collect()
        }
        0 => vec![],
        end => vec![end],
    }
}
