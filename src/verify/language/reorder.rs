//! Words that stand elsewhere in the plain form of a sentence: axes, owners, ends of lines, remarks and appositions.

use super::lexicon::{Class, Lexicon};
use super::reader::ARTICLES;
use super::rewrite::put_in;
use super::sentence_parts::begins_with_verb;
use super::words::{Kind, Token};

/// What an order of axes may be that of, or may be called.
const ORDERED: [&str; 6] = [
    "euler",
    "sequence",
    "order",
    "convention",
    "rotation",
    "rotations",
];

/// "z-x-z" as its parts, and so "zxz" before a word for what has an order.
fn parts_of_order<'t>(token: &'t Token, next: Option<&Token>) -> Vec<&'t str> {
    let ordered = next.is_some_and(|next| ORDERED.contains(&next.lower.as_str()));
    let axis = |c: char| "xyzXYZ123".contains(c);
    match ordered && token.text.len() == 3 && token.text.chars().all(axis) {
        true => (0..3).map(|at| &token.text[at..=at]).collect(),
        false => token.text.split('-').collect(),
    }
}

/// "the xz plane", "the x-z plane" as "the plane of x and z".
fn by_two_axes(token: &Token, noun: Option<&Token>) -> Option<Vec<Token>> {
    let noun = noun.filter(|noun| noun.lower == "plane")?;
    let mut letters = token.text.chars().filter(|c| !"-–".contains(*c));
    let (first, second) = (letters.next()?, letters.next()?);
    let axis = |c: char| "xyzXYZ".contains(c);
    if token.kind != Kind::Word || letters.next().is_some() || !axis(first) || !axis(second) {
        return None;
    }
    let word = |text: &str| put_in(Kind::Word, text, token);
    let [first, second] = [first, second].map(|axis| word(&axis.to_string()));
    Some(vec![noun.clone(), word("of"), first, word("and"), second])
}

/// "the z axis" as "the axis z", "the sequence 3-1-3" as "the sequence 3, 1, 3".
pub(crate) fn axes(tokens: &[Token]) -> Vec<Token> {
    let mut plain: Vec<Token> = vec![];
    let mut pair_ends = 0;
    for (at, token) in tokens.iter().enumerate() {
        if let Some(pair) = by_two_axes(token, tokens.get(at + 1)) {
            plain.extend(pair);
            pair_ends = at + 2;
        }
        if at < pair_ends {
            continue;
        }
        let parts = parts_of_order(token, tokens.get(at + 1));
        let short = |part: &&str| part.chars().count() == 1;
        let axis = |t: &Token| matches!(t.lower.as_str(), "axis" | "axes");
        let (letter, noun) = (parts[0], parts.get(1).copied().unwrap_or(""));
        let named = matches!(token.kind, Kind::Word | Kind::Number);
        if named && parts.len() > 2 && parts.iter().all(short) {
            for (place, part) in parts.iter().enumerate() {
                if place > 0 {
                    plain.push(put_in(Kind::Comma, ",", token));
                }
                let kind = match part.chars().all(|c| c.is_ascii_digit()) {
                    true => Kind::Number,
                    false => Kind::Word,
                };
                plain.push(put_in(kind, part, token));
            }
        } else if short(&letter) && matches!(noun, "axis" | "axes") {
            plain.push(put_in(Kind::Word, noun, token));
            plain.push(put_in(Kind::Word, letter, token));
        } else if axis(token)
            && let Some(last) =
                plain.pop_if(|t| t.kind == Kind::Word && short(&t.text.as_str()) && t.text != "a")
        {
            plain.push(token.clone());
            plain.push(last);
        } else {
            plain.push(token.clone());
        }
    }
    plain
}

/// "the wheel's mass" as "the mass of the wheel".
pub(crate) fn possessives(tokens: &[Token], lexicon: &Lexicon) -> Vec<Token> {
    let mut tokens = tokens.to_vec();
    let mut from = 0;
    while let Some(at) = (from..tokens.len()).find(|&at| owner(&tokens[at]).is_some()) {
        from = at + 1;
        let Some(name) = owner(&tokens[at]) else {
            break;
        };
        let words: Vec<&str> = tokens[at + 1..].iter().map(|t| t.lower.as_str()).collect();
        let noun = [Class::Noun, Class::Place, Class::Thing];
        let Some(found) = [0, 1].into_iter().find_map(|skip| {
            let found = lexicon.find(words.get(skip..)?, &noun)?;
            Some(skip + found.length)
        }) else {
            continue;
        };
        // "the outer gimbal's": an adjective may stand between.
        let named_by = |back: &usize| {
            let first = at.checked_sub(*back).map(|start| &tokens[start]);
            let plain = |t: &Token| t.kind == Kind::Word && t.lower == t.text;
            let own = first.is_some_and(|t| ARTICLES.contains(&t.lower.as_str()));
            own && tokens[at - back + 1..at].iter().all(plain)
        };
        let back = (1..=2).find(named_by);
        let article = back.is_some();
        let start = at - back.unwrap_or_default();
        let named = tokens.get(at + 1 + found).is_some_and(|t| {
            t.kind == Kind::Word && t.text.chars().all(char::is_uppercase)
                || t.kind == Kind::Formula
        });
        let end = at + 1 + found + usize::from(named);
        let the = put_in(Kind::Word, "the", &tokens[start]);
        let of = put_in(Kind::Word, "of", &tokens[at]);
        let owner = Token {
            text: name.clone(),
            lower: name.to_lowercase(),
            ..tokens[at].clone()
        };
        let article: &[Token] = if article { &tokens[start..at] } else { &[] };
        tokens = [
            &tokens[..start],
            &[the],
            &tokens[at + 1..end],
            &[of],
            article,
            &[owner],
            &tokens[end..],
        ]
        .concat();
    }
    tokens
}

/// Places of bodies that stand behind the name of the body: "the wheel centre".
const PLACES: [&str; 6] = ["centre", "center", "middle", "midpoint", "end", "tip"];

/// "the wheel centre" as "the centre of the wheel".
pub(crate) fn compounds(tokens: &[Token], lexicon: &Lexicon) -> Vec<Token> {
    let mut tokens = tokens.to_vec();
    for at in 0..tokens.len().saturating_sub(2) {
        let [article, body, place] = &tokens[at..at + 3] else {
            break;
        };
        let words = [body.lower.as_str(), place.lower.as_str()];
        let whole = lexicon
            .find(&words, &Class::ALL)
            .is_some_and(|all| all.length > 1);
        let thing = lexicon.find(&words[..1], &[Class::Thing]).is_some();
        if article.lower == "the" && thing && PLACES.contains(&words[1]) && !whole {
            let of = put_in(Kind::Word, "of", place);
            let plain = [
                article.clone(),
                place.clone(),
                of,
                article.clone(),
                body.clone(),
            ];
            tokens.splice(at..at + 3, plain);
        }
    }
    tokens
}

/// "the line AB" as "the line from A to B".
pub(crate) fn tell_ends_of_lines(tokens: &[Token]) -> Vec<Token> {
    let mut plain: Vec<Token> = vec![];
    let mut told = false;
    for token in tokens {
        let line = plain
            .last()
            .is_some_and(|t| matches!(t.lower.as_str(), "line" | "segment"));
        let towards = told
            && plain
                .last()
                .is_some_and(|t| matches!(t.lower.as_str(), "from" | "to"));
        match ends_of_line(token).filter(|_| line || towards) {
            Some((from, to)) => {
                told = true;
                if !line {
                    plain.extend(["the", "line"].map(|word| put_in(Kind::Word, word, token)));
                }
                for (word, point) in [("from", from), ("to", to)] {
                    plain.extend([word, point].map(|word| put_in(Kind::Word, word, token)));
                }
            }
            None => plain.push(token.clone()),
        }
    }
    plain
}

/// Two points by their names in one word: "AB", "A1B2".
fn ends_of_line(token: &Token) -> Option<(&str, &str)> {
    let capital = |c: char| c.is_ascii_uppercase();
    let behind = |c: char| c.is_ascii_digit() || c == '\'';
    let text = token.text.as_str();
    let second = text.char_indices().skip(1).find(|(_, c)| capital(*c))?.0;
    let (from, to) = text.split_at(second);
    let is_point = |name: &str| name.starts_with(capital) && name.chars().skip(1).all(behind);
    (token.kind == Kind::Word && is_point(from) && is_point(to)).then_some((from, to))
}

/// Whose: "wheel's".
fn owner(token: &Token) -> Option<String> {
    let text = token.text.replace('’', "'");
    let name = text.strip_suffix("'s")?;
    (token.kind == Kind::Word && !name.is_empty()).then(|| name.to_owned())
}

/// The sentence with what stands in brackets in its place among the other words.
pub(crate) fn without_brackets(tokens: &[Token]) -> Vec<Token> {
    let bracket = |t: &&Token| !matches!(t.kind, Kind::Open | Kind::Close);
    tokens.iter().filter(bracket).cloned().collect()
}

/// "O, the tip of the top, is fixed in N" as "O is fixed in N; O is the tip of the top". Any verb may follow.
pub(crate) fn described_first(tokens: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
    let comma = |t: &Token| t.kind == Kind::Comma;
    let open = tokens.iter().position(comma).filter(|&at| at > 0)?;
    let close = open + 1 + tokens[open + 1..].iter().position(comma)?;
    let (subject, inside, rest) = (
        &tokens[..open],
        &tokens[open + 1..close],
        &tokens[close + 1..],
    );
    if !begins_with_verb(rest, lexicon) || inside.is_empty() {
        return None;
    }
    let near = inside.first()?;
    let word = |text: &str| put_in(Kind::Word, text, near);
    let semicolon = put_in(Kind::Semicolon, "", near);
    let second: Vec<Token> = match near.lower.as_str() {
        "of" => [subject, &[word("is"), word("a"), word("body")], inside].concat(),
        "denoted" | "called" | "written" => {
            let name = inside.iter().position(|t| {
                !["denoted", "called", "written", "by", "as"].contains(&t.lower.as_str())
            })?;
            [&inside[name..], &[word("is")], subject].concat()
        }
        _ if near.kind == Kind::Formula => [inside, &[word("is")], subject].concat(),
        _ => [subject, &[word("is")], inside].concat(),
    };
    Some([subject, rest, &[semicolon], &second].concat())
}

/// "The top, which consists of the rod and the disc, is symmetric" as "The top is symmetric; the top consists of the rod and
/// the disc": what is told beside, of the thing named last.
pub(crate) fn told_beside(tokens: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
    let comma = |t: &Token| t.kind == Kind::Comma;
    let relative = |pair: &[Token]| {
        comma(&pair[0]) && matches!(pair[1].lower.as_str(), "which" | "who" | "that")
    };
    let open = tokens.windows(2).position(relative).filter(|&at| at > 0)?;
    let (before, inside) = (&tokens[..open], &tokens[open + 2..]);
    let verb = begins_with_verb(inside, lexicon);
    let close = inside.iter().rposition(comma).filter(|_| verb)?;
    let semicolon = put_in(Kind::Semicolon, "", &tokens[open]);
    let (inside, behind) = (&inside[..close], &inside[close + 1..]);
    Some([before, behind, &[semicolon], last_named(before), inside].concat())
}

/// The thing that is named last: a name or a formula, or a noun with its article.
pub(crate) fn last_named(tokens: &[Token]) -> &[Token] {
    let last = tokens.len().saturating_sub(1);
    let article = |t: &Token| ARTICLES.contains(&t.lower.as_str());
    let noun = tokens
        .last()
        .is_some_and(|t| t.kind == Kind::Word && t.lower == t.text && t.text.len() > 1);
    let start = tokens.iter().rposition(article);
    match start.filter(|&at| noun && last - at <= LONGEST_NAMED) {
        Some(at) => &tokens[at..],
        None => &tokens[last.min(tokens.len())..],
    }
}

/// A thing is named by so many words behind its article at most.
const LONGEST_NAMED: usize = 3;

/// The sentence without what says which numbers an index takes: ", for `$k=1,2,3$`", "(`$j = 1, 2$`)". The members of its
/// family are as many.
pub(crate) fn without_ranges(tokens: &[Token]) -> Option<Vec<Token>> {
    let range = |t: &Token| t.kind == Kind::Formula && counts(&t.text);
    let at = tokens.iter().position(range)?;
    let before = &tokens[..at];
    let bracket = before.last().is_some_and(|t| t.kind == Kind::Open);
    let said = before.last().is_some_and(|t| t.lower == "for");
    let closed = tokens.get(at + 1).is_some_and(|t| t.kind == Kind::Close);
    if !(said || bracket && closed) {
        return None;
    }
    let start = at - 1 - usize::from(said && at > 1 && tokens[at - 2].kind == Kind::Comma);
    let end = at + 1 + usize::from(bracket);
    Some([&tokens[..start], &tokens[end..]].concat())
}

/// "`$c$` and `$s$` with an angle as index are the cosine and the sine of that angle" with the angle as a letter of any name.
pub(crate) fn indexed_by_any(tokens: &[Token]) -> Option<Vec<Token>> {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    let at = words
        .windows(4)
        .position(|w| w[0] == "with" && matches!(w[1], "a" | "an" | "any") && w[3] == "as")?;
    let noun = words[at + 2];
    let index = (at + 4..words.len().min(at + 6))
        .find(|&i| matches!(words[i], "index" | "subscript" | "label"))?;
    let any = put_in(Kind::Formula, ANY_LETTER, &tokens[at]);
    let labelled = |t: &Token| match t.kind {
        Kind::Formula => put_in(Kind::Formula, &format!("{}_{{{ANY_LETTER}}}", t.text), t),
        _ => t.clone(),
    };
    let mut plain: Vec<Token> = tokens[..at].iter().map(labelled).collect();
    for token in &tokens[index + 1..] {
        let pointed = plain
            .last()
            .is_some_and(|t| matches!(t.lower.as_str(), "that" | "the" | "this"));
        if token.lower == noun && pointed {
            plain.pop();
            plain.push(any.clone());
        } else {
            plain.push(token.clone());
        }
    }
    let ending = [(Kind::Comma, ""), (Kind::Word, "for"), (Kind::Word, "any")];
    plain.extend(ending.map(|(kind, text)| put_in(kind, text, &tokens[index])));
    plain.push(any);
    Some(plain)
}

/// Stands for any letter.
const ANY_LETTER: &str = "\\alpha";

/// Whether a formula counts an index through: `k = 1, 2, 3`, `i=1,\ldots,n`.
fn counts(formula: &str) -> bool {
    let Some((index, numbers)) = formula.split_once('=') else {
        return false;
    };
    let letter = index.trim().chars().count() == 1;
    let mut numbers = numbers.split(',');
    let first = numbers
        .next()
        .is_some_and(|n| n.trim().parse::<usize>().is_ok());
    letter && first && numbers.next().is_some()
}
