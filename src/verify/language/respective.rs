//! "`$A$` and `$B$` are the inertia tensors of the plate about C and of the body about O, respectively, in components on Q": each
//! letter with what hangs on the noun for it, and with what hangs on it for all.

use super::lexicon::Lexicon;
use super::reader::ARTICLES;
use super::rewrite::put_in;
use super::sentence_parts::{head, joins, preposition};
use super::words::{Kind, Token};

/// The word for it.
const RESPECTIVELY: &str = "respectively";

/// A clause for each letter, where as many things hang on the noun by the same prepositions.
pub(super) fn each_with_its_own(tokens: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
    let are = tokens.iter().position(|t| t.lower == "are")?;
    let letter = |t: &&Token| t.kind == Kind::Formula;
    let letters: Vec<&Token> = tokens[..are].iter().filter(letter).collect();
    let listed = tokens[..are].iter().all(|t| letter(&t) || joins(t));
    let rest = &tokens[are + 1..];
    let article = ARTICLES.contains(&rest.first()?.lower.as_str());
    if letters.len() < 2 || !listed || !article {
        return None;
    }
    let noun = 1 + head(rest, lexicon).len();
    let (noun, hanging) = (&rest[..noun], rest.get(noun..)?);
    let (own, shared) = groups(hanging, letters.len(), lexicon)?;
    let is = put_in(Kind::Word, "is", &tokens[are]);
    let semicolon = put_in(Kind::Semicolon, "", &tokens[are]);
    let mut said = vec![];
    for (letter, own) in letters.into_iter().zip(own) {
        if !said.is_empty() {
            said.push(semicolon.clone());
        }
        said.extend([letter.clone(), is.clone()]);
        said.extend([noun, own, shared].concat());
    }
    Some(said)
}

/// What hangs on a noun for each of some letters, and what hangs on it for all: that stands behind the word for it, or by
/// prepositions that only the last one has.
fn groups<'t>(
    hanging: &'t [Token],
    count: usize,
    lexicon: &Lexicon,
) -> Option<(Vec<&'t [Token]>, &'t [Token])> {
    let led = |t: &Token| t.lower == RESPECTIVELY;
    let said = hanging.iter().position(led);
    let comma = |t: &&Token| t.kind == Kind::Comma;
    let (listed, behind) = hanging.split_at(said.unwrap_or(hanging.len()));
    let listed = without_last(listed, |t| comma(&t));
    let behind = behind.get(1..).unwrap_or_default();
    let behind = &behind[behind.iter().take_while(comma).count()..];
    let first = &hanging.first()?.lower;
    preposition(hanging, lexicon)?;
    let again = |at: &usize| listed[*at].lower == *first && joins(&listed[at - 1]);
    let starts: Vec<usize> = (1..listed.len()).filter(again).collect();
    let starts: Vec<usize> = std::iter::once(0).chain(starts).collect();
    let ends = starts.iter().skip(1).copied().chain([listed.len()]);
    let own = starts.iter().zip(ends).map(|(from, to)| &listed[*from..to]);
    let mut own: Vec<&[Token]> = own.map(|own| without_last(own, joins)).collect();
    let led = |own: &[Token]| prepositions(own, lexicon);
    let wanted: Vec<String> = led(own.first()?)
        .into_iter()
        .map(|(_, word)| word)
        .collect();
    let last = led(own.last()?);
    let mut shared = behind;
    if let Some((at, _)) = last.get(wanted.len()).filter(|_| behind.is_empty()) {
        let (mine, others) = own.pop()?.split_at(*at);
        own.push(without_last(mine, joins));
        shared = others;
    }
    let alike = |own: &&[Token]| {
        let words = led(own).into_iter().map(|(_, word)| word);
        words.eq(wanted.iter().cloned())
    };
    let clean = !shared
        .iter()
        .any(|t| t.kind == Kind::Semicolon || t.lower == "and");
    let told = own.len() == count && own.iter().all(alike) && wanted.len() > 1 && clean;
    told.then_some((own, shared))
}

/// Without the signs and words at the end by which a list goes on.
fn without_last(tokens: &[Token], is: impl Fn(&Token) -> bool) -> &[Token] {
    let kept = tokens.iter().rposition(|t| !is(t)).map_or(0, |at| at + 1);
    &tokens[..kept]
}

/// The prepositions of some words, and where they stand.
fn prepositions(tokens: &[Token], lexicon: &Lexicon) -> Vec<(usize, String)> {
    let mut found = vec![];
    let mut at = 0;
    while at < tokens.len() {
        match preposition(&tokens[at..], lexicon) {
            Some(length) => {
                found.push((at, tokens[at].lower.clone()));
                at += length;
            }
            None => at += 1,
        }
    }
    found
}
