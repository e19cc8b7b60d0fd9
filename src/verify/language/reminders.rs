//! "The component of `$w$` along `$i$` is `$p$`, that along `$j$` is `$q$`": the noun of the first clause with all that hangs on it,
//! but for what the later clause tells otherwise.

use super::lexicon::Lexicon;
use super::reader::{ARTICLES, COPULAS};
use super::rewrite::put_in;
use super::sentence_parts::{head, joins, preposition};
use super::words::{Kind, Token};

/// A noun, and what hangs on it by its prepositions.
struct Spoken<'t> {
    noun: &'t [Token],
    hanging: Vec<&'t [Token]>,
}

/// The sentence with that noun for each "that" at the beginning of a clause.
pub(super) fn reminded_at_start(tokens: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
    let copula = |t: &Token| COPULAS.contains(&t.lower.as_str());
    let article = ARTICLES.contains(&tokens.first()?.lower.as_str());
    let end = tokens.iter().position(copula)?;
    let spoken = spoken(&tokens[..end], lexicon).filter(|_| article)?;
    let mut said = tokens[..end].to_vec();
    let mut at = end;
    let mut any = false;
    while at < tokens.len() {
        let begins = joins(&tokens[at - 1]) || tokens[at - 1].kind == Kind::Semicolon;
        let reminds = tokens[at].lower == "that" && begins;
        let length = preposition(&tokens[at + 1..], lexicon).filter(|_| reminds);
        if length.is_none() {
            said.push(tokens[at].clone());
            at += 1;
            continue;
        }
        let rest = &tokens[at + 1..];
        let is_joint = |t: &Token| t.kind == Kind::Semicolon || joins(t);
        let clause = rest.iter().position(is_joint).unwrap_or(rest.len());
        let verb = rest[..clause].iter().position(copula);
        let letter = clause
            .checked_sub(1)
            .filter(|&i| rest[i].kind == Kind::Formula);
        let own = verb.or(letter.filter(|&i| i > 1))?;
        let kept = said
            .iter()
            .rposition(|t| !is_joint(t))
            .map_or(0, |at| at + 1);
        said.truncate(kept);
        said.push(put_in(Kind::Semicolon, "", &tokens[at]));
        said.extend(spoken.again(&rest[..own], lexicon)?);
        if verb.is_none() {
            said.push(put_in(Kind::Word, "is", &rest[own]));
        }
        at += 1 + own;
        any = true;
    }
    any.then_some(said)
}

/// The noun with which a clause begins, and what hangs on it.
fn spoken<'t>(subject: &'t [Token], lexicon: &Lexicon) -> Option<Spoken<'t>> {
    let noun = 1 + head(subject, lexicon).len();
    let hanging = hanging_in(subject.get(noun..)?, lexicon)?;
    Some(Spoken {
        noun: &subject[..noun],
        hanging,
    })
}

/// Words cut before each preposition.
fn hanging_in<'t>(tokens: &'t [Token], lexicon: &Lexicon) -> Option<Vec<&'t [Token]>> {
    let mut starts = vec![];
    let mut at = 0;
    while at < tokens.len() {
        match preposition(&tokens[at..], lexicon) {
            Some(length) => {
                starts.push(at);
                at += length;
            }
            None if starts.is_empty() => return None,
            None => at += 1,
        }
    }
    let ends = starts.iter().skip(1).copied().chain([tokens.len()]);
    Some(
        starts
            .iter()
            .zip(ends)
            .map(|(from, to)| &tokens[*from..to])
            .collect(),
    )
}

impl Spoken<'_> {
    /// The noun again, with other things behind some of its prepositions.
    fn again(&self, other: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
        let other = hanging_in(other, lexicon)?;
        let led_by = |part: &[Token], by: &[Token]| part[0].lower == by[0].lower;
        let count = |all: &[&[Token]], by: &[Token]| all.iter().filter(|p| led_by(p, by)).count();
        // Where a preposition stands twice, it is not said which of the two is meant.
        let doubtful = |part: &&[Token]| count(&other, part) > 1 || count(&self.hanging, part) > 1;
        if other.iter().any(doubtful) {
            return None;
        }
        let (article, noun) = self.noun.split_first()?;
        let mut said = vec![put_in(Kind::Word, &article.lower, article)];
        said.extend_from_slice(noun);
        for part in &self.hanging {
            let own = other.iter().find(|own| led_by(own, part));
            said.extend_from_slice(own.unwrap_or(part));
        }
        let new = other.iter().filter(|own| count(&self.hanging, own) == 0);
        new.for_each(|own| said.extend_from_slice(own));
        Some(said)
    }
}
