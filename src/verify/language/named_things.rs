//! The things that words name, by which clauses aside are told of them.

use super::heads::SIZES;
use super::lexicon::{Class, Lexicon};
use super::reader::ARTICLES;
use super::rewrite::put_in;
use super::sentence_parts::{head, joins, thing_in};
use super::words::{Kind, Token};

/// The words without the sizes at their end: "of mass `$m$` and radius `$r$`".
pub(super) fn without_sizes<'t>(tokens: &'t [Token], lexicon: &Lexicon) -> &'t [Token] {
    let mut now = tokens;
    loop {
        let [before @ .., size, letter] = now else {
            return now;
        };
        let letter = letter.kind == Kind::Formula;
        let words = [size.lower.as_str()];
        let noun = lexicon.find(&words, &[Class::Noun]);
        if !letter || noun.is_none_or(|noun| !SIZES.contains(&noun.entry.name)) {
            return now;
        }
        let joined = |t: &&Token| {
            t.kind == Kind::Comma
                || matches!(t.lower.as_str(), "of" | "with" | "and" | "the" | "a" | "an")
        };
        let skipped = before.iter().rev().take_while(joined).count();
        if skipped == 0 || skipped == before.len() {
            return now;
        }
        now = &before[..before.len() - skipped];
    }
}

/// Whether words stand among others.
pub(super) fn stands_in(words: &[Token], others: &[Token]) -> bool {
    let mut windows = others.windows(words.len().max(1));
    windows.any(|window| {
        window
            .iter()
            .zip(words)
            .all(|(one, other)| one.lower == other.lower)
    })
}

/// "the force of the hoop": the last noun with what it is of.
pub(super) fn with_owner(tokens: &[Token]) -> Option<Vec<Token>> {
    let article = |t: &Token| ARTICLES.contains(&t.lower.as_str()) && t.text != "A";
    let of = tokens.iter().rposition(|t| t.lower == "of")?;
    let start = tokens[..of].iter().rposition(article)?;
    let listed = tokens[start..].iter().any(joins);
    let definite = tokens[start].lower == "the" && !listed;
    definite.then(|| tokens[start..].to_vec())
}

/// What is named last: a name, a letter, or the noun behind the last article, without what describes it.
pub(super) fn named_last(tokens: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
    let article = |t: &Token| ARTICLES.contains(&t.lower.as_str()) && t.text != "A";
    let last = tokens.last()?;
    let letter = last.kind == Kind::Word && last.text.chars().count() == 1;
    // Of letters in a list all may be meant.
    let listed = matches!(tokens, [.., _, and, _] if last.kind == Kind::Formula && joins(and));
    if listed {
        return None;
    }
    if letter || is_name(last) || last.kind == Kind::Formula {
        return Some(vec![last.clone()]);
    }
    let at = tokens.iter().rposition(article)?;
    Some(definite(&tokens[at..], lexicon))
}

/// Whether a word is a name by capitals and numbers: "A", "AB", "P1".
pub(super) fn is_name(token: &Token) -> bool {
    let capital = token.text.chars().next().is_some_and(char::is_uppercase);
    let short = token
        .text
        .chars()
        .all(|c| c.is_uppercase() || c.is_ascii_digit() || c == '_');
    token.kind == Kind::Word && capital && short
}

/// The thing that words name, as it is spoken of again: "a uniform rod" as "the rod", "a disc D" as "D".
pub(super) fn definite(tokens: &[Token], lexicon: &Lexicon) -> Vec<Token> {
    let Some((article, noun)) = tokens.split_first() else {
        return vec![];
    };
    if !matches!(article.lower.as_str(), "the" | "a" | "an") || tokens.len() == 1 {
        return tokens.to_vec();
    }
    let the = put_in(Kind::Word, "the", article);
    let (from, end) = thing_in(noun, lexicon).unwrap_or_else(|| {
        let named = head(tokens, lexicon).len();
        (0, named)
    });
    match noun
        .get(end)
        .filter(|t| is_name(t) || t.kind == Kind::Formula)
    {
        Some(name) => vec![name.clone()],
        None => [&[the], &noun[from..end.max(from)]].concat(),
    }
}

/// The words without a comma at their end.
pub(super) fn without_comma(tokens: &[Token]) -> &[Token] {
    match tokens {
        [rest @ .., comma] if comma.kind == Kind::Comma => rest,
        _ => tokens,
    }
}

/// Words for how forces are directed.
const DIRECTED: [&str; 4] = ["normal", "perpendicular", "parallel", "directed"];

/// "the force of the floor on the disc, which is normal to the floor": it is the force that is directed so.
pub(super) fn is_way_of_load(first: &[Token], rest: &[Token]) -> bool {
    let load = |t: &Token| {
        matches!(
            t.lower.as_str(),
            "force" | "moment" | "reaction" | "friction"
        )
    };
    let way = rest
        .iter()
        .take(3)
        .any(|t| DIRECTED.contains(&t.lower.as_str()));
    way && first.iter().any(load)
}
