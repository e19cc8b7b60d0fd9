//! Points that are called by a word besides their letter: "O, the shoulder, is fixed in B", "the shoulder O". The word says
//! nothing more of the point: every sentence gets the letter in its place.

use super::lexicon::Lexicon;
use super::phrase::NOUNS;
use super::rewrite::put_in;
use super::statement::Misread;
use super::words::{Kind, Token};
use std::collections::BTreeMap;

/// What points of arms and legs are called, which may stand before the letter as well.
const JOINTS: [&str; 12] = [
    "shoulder",
    "elbow",
    "wrist",
    "hip",
    "knee",
    "ankle",
    "neck",
    "waist",
    "knuckle",
    "fingertip",
    "toe",
    "heel",
];

/// Words that a word for a place may hold which says where the point is: such a word is no mere name.
const PLACES: [&str; 17] = [
    "cent", "mid", "point", "focus", "vertex", "apex", "pole", "node", "zenith", "nadir", "top",
    "bottom", "end", "helion", "foot", "corner", "edge",
];

/// What frames are called, which may stand before the letter as well: "the laboratory N is an inertial frame".
const FRAMES: [&str; 7] = [
    "laboratory",
    "lab",
    "workshop",
    "room",
    "hall",
    "observatory",
    "base",
];

/// What points are called, each with its letter; none where a word is said of two.
type Called = BTreeMap<String, Option<Token>>;

/// Puts the letters of points in the place of the words by which they are called as well.
pub(super) fn name_by_letters(sentences: &mut [Result<Vec<Token>, Misread>], lexicon: &Lexicon) {
    let mut called = Called::new();
    for tokens in sentences.iter().flatten() {
        for at in 0..tokens.len() {
            if let Some((word, letter)) = told(tokens, at, lexicon) {
                let other =
                    |known: &Option<Token>| known.as_ref().is_none_or(|k| k.text != letter.text);
                match called.get(word) {
                    Some(known) if other(known) => called.insert(word.to_owned(), None),
                    Some(_) => None,
                    None => called.insert(word.to_owned(), Some(letter.clone())),
                };
            }
        }
    }
    if called.is_empty() {
        return;
    }
    for tokens in sentences.iter_mut().flatten() {
        *tokens = by_letters(tokens, &called, lexicon);
    }
}

/// The word by which a point is called, and its letter, where a sentence tells them here.
fn told<'t>(tokens: &'t [Token], at: usize, lexicon: &Lexicon) -> Option<(&'t str, &'t Token)> {
    match tokens.get(at..)? {
        [letter, rest @ ..] if is_letter(letter) && aside(tokens, at, lexicon) > 0 => {
            let word = rest.iter().find(|t| is_name(t, lexicon))?;
            Some((word.lower.as_str(), letter))
        }
        [the, word, letter, ..] if is_article(the) && is_joint(word) && is_letter(letter) => {
            Some((word.lower.as_str(), letter))
        }
        [the, word, letter, is, what @ ..]
            if is_article(the) && is_frame(word) && is_letter(letter) && is.lower == "is" =>
        {
            let frame = |t: &Token| matches!(t.lower.as_str(), "frame" | "inertial");
            let told = what.iter().take(3).any(frame);
            told.then_some((word.lower.as_str(), letter))
        }
        _ => None,
    }
}

/// How many pieces behind a letter only tell what it is called besides: ", the shoulder," before a verb, ", called the
/// shoulder,", "(the shoulder)", "is the shoulder" before ", a point".
fn aside(tokens: &[Token], at: usize, lexicon: &Lexicon) -> usize {
    let rest = &tokens[at + 1..];
    let Some(opening) = rest.first() else {
        return 0;
    };
    let said = rest
        .get(1)
        .is_some_and(|t| CALLED.contains(&t.lower.as_str()));
    let article = 1 + usize::from(said);
    let (Some(the), Some(word)) = (rest.get(article), rest.get(article + 1)) else {
        return 0;
    };
    if !is_article(the) || !is_name(word, lexicon) {
        return 0;
    }
    let behind = rest.get(article + 2);
    let kind = behind.map(|t| t.kind);
    match (opening.kind, kind) {
        (Kind::Open, Some(Kind::Close)) => article + 3,
        (Kind::Comma, None) => article + 2,
        (Kind::Comma, Some(Kind::Comma)) if !said && is_listed(tokens, at, article, lexicon) => 0,
        (Kind::Comma, Some(Kind::Comma)) => article + 3,
        (Kind::Word, Some(Kind::Comma)) if opening.lower == "is" && !said => {
            match rest.get(article + 3..) {
                // "O is the shoulder, a point of the arm": the letter is a point of the arm.
                Some([a, point, ..]) if is_a(a) && point.lower == "point" => article + 2,
                _ => 0,
            }
        }
        _ => 0,
    }
}

/// Whether a letter and the word behind it are members of a list: "O, the knob, and the rod".
fn is_listed(tokens: &[Token], at: usize, article: usize, lexicon: &Lexicon) -> bool {
    let listed = |t: &Token| t.kind == Kind::Comma;
    let before = at.checked_sub(1).and_then(|before| tokens.get(before));
    if before.is_some_and(listed) && at > 1 && is_letter(&tokens[at - 2]) {
        return true;
    }
    let behind = &tokens[at + article + 4..];
    let joined = usize::from(behind.first().is_some_and(|t| t.lower == "and"));
    match behind.get(joined) {
        // "O, the shoulder, and A, the elbow, are …"
        Some(next) if joined == 1 && is_letter(next) => {
            aside(tokens, at + article + 5, lexicon) == 0
        }
        Some(next) => joined == 1 || is_article(next) || next.kind != Kind::Word,
        None => true,
    }
}

const CALLED: [&str; 4] = ["called", "named", "termed", "or"];

/// One capital letter, with or without a number.
fn is_letter(token: &Token) -> bool {
    let mut signs = token.text.chars();
    let capital = signs.next().is_some_and(|sign| sign.is_ascii_uppercase());
    let rest = signs.all(|sign| sign.is_ascii_digit() || "_{}".contains(sign));
    let kind = matches!(token.kind, Kind::Word | Kind::Formula | Kind::Plain);
    kind && capital && rest
}

fn is_article(token: &Token) -> bool {
    token.kind == Kind::Word && matches!(token.lower.as_str(), "the" | "its")
}

fn is_a(token: &Token) -> bool {
    token.kind == Kind::Word && token.lower == "a"
}

fn is_joint(token: &Token) -> bool {
    token.kind == Kind::Word && JOINTS.contains(&token.lower.as_str())
}

fn is_frame(token: &Token) -> bool {
    token.kind == Kind::Word && FRAMES.contains(&token.lower.as_str())
}

/// Whether a word is none of the language and does not say where a point is.
fn is_name(token: &Token, lexicon: &Lexicon) -> bool {
    let word = token.lower.as_str();
    let small = token.kind == Kind::Word && token.text == word && word.chars().count() > 2;
    let place = PLACES.iter().any(|place| word.contains(place));
    let plain = small && word.chars().all(|sign| sign.is_ascii_lowercase());
    is_joint(token) || plain && !place && !lexicon.begins(word)
}

/// A sentence with letters in the place of what points are called.
fn by_letters(tokens: &[Token], called: &Called, lexicon: &Lexicon) -> Vec<Token> {
    let mut said = vec![];
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        if let Some((put, length)) = lettered(&tokens[at..], called, lexicon) {
            said.extend(put);
            at += length;
            continue;
        }
        said.push(token.clone());
        at += 1;
        if !is_letter(token) {
            continue;
        }
        let aside = aside(tokens, at - 1, lexicon);
        // "O is the shoulder, a point of the arm": the verb stands where the comma stood.
        if aside > 0 && tokens[at].lower == "is" {
            said.push(tokens[at].clone());
            at += 1;
        }
        at += aside;
    }
    said
}

/// What stands for "the shoulder", "the shoulder O" and "the shoulder joint" at the beginning of some words, and how many of
/// them these are.
fn lettered(tokens: &[Token], called: &Called, lexicon: &Lexicon) -> Option<(Vec<Token>, usize)> {
    let (the, word) = (tokens.first()?, tokens.get(1)?);
    let own = called.get(&word.lower).filter(|_| is_article(the))?;
    let next = tokens.get(2);
    if let Some(letter) = next.filter(|next| is_letter(next)) {
        let other = own.as_ref().is_some_and(|own| own.text != letter.text);
        return (!other).then(|| (vec![], 2));
    }
    let letter = Token {
        column: the.column,
        ..own.clone()?
    };
    let noun = next.filter(|next| {
        next.kind == Kind::Word && lexicon.find(&[next.lower.as_str()], &NOUNS).is_some()
    });
    Some(match noun {
        // "the laboratory frame"
        Some(_) if is_frame(word) => return None,
        Some(noun) => {
            let [the, at] = ["the", "at"].map(|word| put_in(Kind::Word, word, noun));
            (vec![the, noun.clone(), at, letter], 3)
        }
        None => (vec![letter], 2),
    })
}
