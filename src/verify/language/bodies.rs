//! Bodies that the lexicon does not have: a text introduces them by what it says of them.

use super::body_words::{APART, BEFORE, ENTIRE, OF_BODIES, may_name};
use super::lexicon::{Class, Inflection, Lexicon};
use super::reader::{ARTICLES, is_glue};
use super::statement::Slot;
use super::traits::{Trait, has};
use super::words::{Kind, Token};
use std::collections::{BTreeMap, BTreeSet};

/// The name of a body has so many words.
pub(crate) const LONGEST_NAME: usize = 4;

/// A text introduces so many bodies.
const MOST_BODIES: usize = 300;

/// The bodies that some sentences introduce, by their names in lower case.
pub(crate) fn introduced<'a>(
    sentences: impl Iterator<Item = &'a [Token]> + Clone,
    lexicon: &Lexicon,
) -> BTreeSet<String> {
    let contexts: Vec<Vec<&str>> = BEFORE.iter().map(|b| b.split(' ').collect()).collect();
    let mut found = BTreeSet::new();
    for tokens in sentences.clone() {
        found.extend(names(tokens, &contexts, lexicon));
        found.extend(consists(tokens, lexicon));
        found.extend(consists_of_its_like(tokens, lexicon));
        if found.len() > MOST_BODIES {
            break;
        }
    }
    let mut mentions: BTreeMap<&str, usize> = BTreeMap::new();
    for tokens in sentences {
        let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
        let mut here = BTreeSet::new();
        for at in 0..words.len() {
            for end in at + 1..=(at + LONGEST_NAME).min(words.len()) {
                here.extend(found.get(&words[at..end].join(" ")));
            }
        }
        for name in here {
            *mentions.entry(name.as_str()).or_default() += 1;
        }
    }
    let again = |name: &str| mentions.get(name).is_some_and(|n| *n > 1);
    let kept = |name: &&String| again(name) || !mistyped(name, lexicon);
    let mut bodies: BTreeSet<String> = found
        .iter()
        .filter(kept)
        .take(MOST_BODIES)
        .cloned()
        .collect();
    let single: Vec<String> = bodies.iter().filter_map(|name| singular(name)).collect();
    bodies.extend(single);
    bodies
}

/// The body of a family: "the legs" has leg `$i$`.
pub(crate) fn singular(name: &str) -> Option<String> {
    let stem = name.strip_suffix('s')?;
    (stem.len() > 2 && !stem.ends_with(['s', 'u', 'i'])).then(|| stem.to_owned())
}

/// Whether a name looks like a word of the lexicon with a slip in it.
fn mistyped(name: &str, lexicon: &Lexicon) -> bool {
    let nouns = [Class::Noun, Class::Place, Class::Thing, Class::Adjective];
    name.split(' ')
        .filter(|word| !lexicon.begins(word))
        .any(|word| {
            let near = lexicon.nearest(word, &nouns);
            let first = near.as_deref().and_then(|near| near.split(' ').next());
            let apart = first.map_or(usize::MAX, |first| strsim::osa_distance(first, word));
            let length = word.chars().count();
            apart == 1 && length > 3 || apart == 2 && length > 7
        })
}

/// The word for what has parts, where no noun follows: "the whole consists of the hub and P".
pub(crate) const WHOLE: &str = "whole";

/// The word for what a sentence says the parts of, where it is none for a thing otherwise: "the drive consists of …".
fn consists(tokens: &[Token], lexicon: &Lexicon) -> Option<String> {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    let nouns = [Class::Thing, Class::Noun, Class::Place, Class::Preposition];
    words.windows(4).find_map(|at| match at {
        ["the", word, "consists", "of"] => {
            let other = *word != WHOLE && lexicon.find(&[word], &nouns).is_some();
            let name = !other && may_name(word) && !is_glue(word);
            name.then(|| (*word).to_owned())
        }
        _ => None,
    })
}

/// "The balanced rotor consists of the rotor and P": what has a body as a part is another one, and the word before its noun tells
/// them apart.
fn consists_of_its_like(tokens: &[Token], lexicon: &Lexicon) -> Option<String> {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    let at = words.windows(2).position(|two| two == ["consists", "of"])?;
    let [.., "the", word, noun] = words[..at] else {
        return None;
    };
    let known = lexicon.find(&[noun], &[Class::Thing]).is_some();
    let part = words[at..].windows(2).any(|two| two == ["the", noun]);
    let name = known && part && !is_glue(word) && word.chars().all(char::is_alphabetic);
    name.then(|| format!("{word} {noun}"))
}

/// The bodies that one sentence introduces.
fn names(tokens: &[Token], contexts: &[Vec<&str>], lexicon: &Lexicon) -> Vec<String> {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    let mut names = vec![];
    for at in 0..words.len() {
        let before = words_before(tokens, at);
        let context = contexts.iter().any(|context| before.ends_with(context));
        if context || owned(&before, lexicon) {
            listed(tokens, at, lexicon, &mut names);
        } else if let Some((name, end)) = name(tokens, at, lexicon)
            && begins(tokens, at)
            && said(&name, &words[past_index(tokens, end)..], lexicon)
        {
            names.push(name);
        }
    }
    names
}

/// The last words before a place; letters between them only name what they say: "the tension `$T$` of the wire".
fn words_before(tokens: &[Token], at: usize) -> Vec<&str> {
    let letter = |t: &&Token| matches!(t.kind, Kind::Formula | Kind::Plain);
    let words = tokens[..at].iter().rev().filter(|t| !letter(t));
    let words = words.take(LONGEST_NAME + 1).map(|t| t.lower.as_str());
    let mut before: Vec<&str> = words.collect();
    before.reverse();
    before
}

/// Whether the last words before a place say something that bodies have, or that is on bodies: "the mass of", "the lift on".
fn owned(before: &[&str], lexicon: &Lexicon) -> bool {
    let Some((preposition, before)) = before.split_last() else {
        return false;
    };
    let noun = (0..before.len()).find_map(|start| {
        let noun = lexicon.find(&before[start..], &[Class::Noun, Class::Place])?;
        (start + noun.length == before.len()).then_some(noun.entry)
    });
    noun.is_some_and(|noun| match *preposition {
        "of" => {
            noun.traits.has(Trait::Bodily)
                || noun.slot("on").is_some()
                || noun.class == Class::Place
        }
        "on" => noun.slot("on") == Some(Slot::Upon),
        _ => false,
    })
}

/// A list of bodies: "the hub, the leg and the foot".
fn listed(tokens: &[Token], mut at: usize, lexicon: &Lexicon, names: &mut Vec<String>) {
    while at < tokens.len() {
        // "the hub and `$n$` blades"
        let counted = at > 0 && matches!(tokens[at].kind, Kind::Formula | Kind::Plain);
        at += usize::from(counted && tokens.get(at + 1).is_some_and(|t| t.kind == Kind::Word));
        match name(tokens, at, lexicon) {
            Some((name, end)) => {
                names.push(name);
                at = end;
            }
            // a body of the lexicon
            None => {
                let article = usize::from(ARTICLES.contains(&tokens[at].lower.as_str()));
                let words: Vec<&str> = tokens[at + article..]
                    .iter()
                    .take(LONGEST_NAME)
                    .map(|t| t.lower.as_str())
                    .collect();
                match lexicon.find(&words, &[Class::Thing]) {
                    Some(thing) => at += article + thing.length,
                    None => return,
                }
            }
        }
        let start = at;
        at += usize::from(tokens.get(at).is_some_and(|t| t.kind == Kind::Comma));
        at += usize::from(tokens.get(at).is_some_and(|t| t.lower == "and"));
        at += usize::from(tokens.get(at).is_some_and(|t| t.lower == "of"));
        if at == start {
            return;
        }
    }
}

/// "the mass of the whole mallet" is that of the mallet.
fn is_stressed(tokens: &[Token]) -> bool {
    let noun = |t: &Token| t.kind == Kind::Word && !is_glue(&t.lower);
    match tokens {
        [word, next, ..] => ENTIRE.contains(&word.lower.as_str()) && noun(next),
        _ => false,
    }
}

/// The name of a body that stands here with its article, or with an index behind it, and where it ends.
fn name(tokens: &[Token], at: usize, lexicon: &Lexicon) -> Option<(String, usize)> {
    let article = ARTICLES.contains(&tokens.get(at)?.lower.as_str());
    let start = at + usize::from(article);
    let mut end = start;
    let mut unknown = false;
    let mut whole = false;
    while let Some(token) = tokens
        .get(end)
        .filter(|_| !whole && end < start + LONGEST_NAME)
    {
        let word = token.lower.as_str();
        let plain = token.kind == Kind::Word
            && word.chars().count() > 2
            && word.chars().all(|c| c.is_alphabetic() || c == '-')
            && (token.text == word || end == 0);
        if !plain || is_no_name(word) {
            break;
        }
        if end == start && is_stressed(&tokens[end..]) {
            break;
        }
        if end == start && tells_apart(&tokens[end..], lexicon) {
            (unknown, end) = (true, end + 1);
            continue;
        }
        if known(tokens, end, lexicon) && !is_named_by_verb(&tokens[at..=end], lexicon) {
            let rest = tokens[end..].iter().take(2);
            let rest: Vec<&str> = rest.map(|t| t.lower.as_str()).collect();
            let other = [Class::Preposition, Class::Noun, Class::Place];
            let other = lexicon.find(&rest, &other).is_some();
            let thing = lexicon.find(&[word], &[Class::Thing]).is_some();
            let verb = lexicon.find(&rest, &[Class::Verb]).is_some();
            whole = thing && !other && !verb || is_part_called_frame(&tokens[start..=end]);
            let adjective = end == start && lexicon.find(&[word], &[Class::Adjective]).is_some();
            if !whole && (!adjective || other) {
                break;
            }
        } else {
            unknown = true;
        }
        end += 1;
    }
    let next = tokens.get(end);
    let index = next.is_some_and(|t| matches!(t.kind, Kind::Formula | Kind::Plain | Kind::Number));
    let described = next.is_some_and(|next| is_noun_here(next, lexicon));
    let last = tokens.get(end.wrapping_sub(1))?;
    let free =
        !known(tokens, end.wrapping_sub(1), lexicon) || is_named_by_verb(&tokens[at..end], lexicon);
    let body = whole || free && last.kind == Kind::Word;
    let counted = start > 0 && matches!(tokens[start - 1].kind, Kind::Formula | Kind::Plain);
    let found = unknown && body && !described && (article || index || counted);
    let words: Vec<&str> = tokens
        .get(start..end)?
        .iter()
        .map(|t| t.lower.as_str())
        .collect();
    found.then(|| (words.join(" "), end))
}

fn is_no_name(word: &str) -> bool {
    is_glue(word) || ARTICLES.contains(&word) || OF_BODIES.contains(&word) || !may_name(word)
}

/// Whether a word behind a name is a noun that it belongs to, and no verb.
fn is_noun_here(next: &Token, lexicon: &Lexicon) -> bool {
    let word = [next.lower.as_str()];
    let verb = lexicon.find(&word, &[Class::Verb]);
    lexicon.find(&word, &[Class::Noun, Class::Place]).is_some()
        && verb.is_none_or(|verb| verb.inflection != Inflection::Ending)
}

/// "upper arm", "front wheel"
fn tells_apart(tokens: &[Token], lexicon: &Lexicon) -> bool {
    let [word, thing, ..] = tokens else {
        return false;
    };
    let both = [word.lower.as_str(), thing.lower.as_str()];
    let thing = |words: &[&str]| lexicon.find(words, &[Class::Thing]);
    let upright = both[0] == "right" && has(both[1], Trait::Right);
    let known = thing(&both).is_some_and(|known| known.length == 2);
    let body = thing(&both[1..]).is_some() || is_part_called_frame(&tokens[..2]);
    APART.contains(&both[0]) && !upright && !known && body
}

/// "the rear frame": of a vehicle, and no frame of reference.
fn is_part_called_frame(tokens: &[Token]) -> bool {
    match tokens {
        [which, frame] => {
            let side = ["rear", "front", "upper", "lower"].contains(&which.lower.as_str());
            side && frame.lower == "frame"
        }
        _ => false,
    }
}

/// Whether an entry of the lexicon begins with the words that stand here.
fn known(tokens: &[Token], at: usize, lexicon: &Lexicon) -> bool {
    let words: Vec<&str> = tokens.iter().skip(at).map(|t| t.lower.as_str()).collect();
    lexicon.find(&words, &Class::ALL).is_some()
}

/// "the mount": behind an article alone a word that is otherwise a verb.
fn is_named_by_verb(tokens: &[Token], lexicon: &Lexicon) -> bool {
    let [article, word] = tokens else {
        return false;
    };
    let word = [word.lower.as_str()];
    let verbs = [Class::Verb, Class::Passive];
    let verb = lexicon.find(&word, &verbs);
    let others = Class::ALL.into_iter().filter(|c| !verbs.contains(c));
    article.lower == "the"
        && verb.is_some_and(|verb| verb.inflection == Inflection::Base)
        && lexicon.find(&word, &others.collect::<Vec<_>>()).is_none()
}

/// Where the name of a member ends: behind its index, and what that counts through in brackets.
fn past_index(tokens: &[Token], end: usize) -> usize {
    let letter = |t: &Token| matches!(t.kind, Kind::Formula | Kind::Plain | Kind::Number);
    let behind = end + usize::from(tokens.get(end).is_some_and(letter));
    match tokens.get(behind..behind + 3) {
        Some([open, counted, close])
            if open.kind == Kind::Open && letter(counted) && close.kind == Kind::Close =>
        {
            behind + 3
        }
        _ => behind,
    }
}

/// Whether the subject of a sentence may begin here: at its beginning or behind an extent.
fn begins(tokens: &[Token], at: usize) -> bool {
    let Some(before) = at.checked_sub(1).and_then(|at| tokens.get(at)) else {
        return true;
    };
    !matches!(
        before.kind,
        Kind::Word | Kind::Formula | Kind::Plain | Kind::Open
    ) || before.lower == "on"
}

/// Whether these words say something of a body: that it is a …, or that it moves.
fn said(name: &str, words: &[&str], lexicon: &Lexicon) -> bool {
    match words {
        [verb, ..] if OF_BODIES.contains(verb) => true,
        ["is", "a" | "an", ..] | ["is", "at", "rest", ..] | ["is", "fixed", ..] => true,
        ["are", rest @ ..] => lexicon
            .find(rest, &[Class::Adjective, Class::Thing])
            .is_some(),
        ["does" | "do", "not", ..] => true,
        // "the movable pulley is massless"
        ["is", rest @ ..] if names_kind(name, lexicon) => {
            lexicon.find(rest, &[Class::Adjective]).is_some()
        }
        _ => lexicon.find(words, &[Class::Verb]).is_some(),
    }
}

/// Whether a name ends with a word for a kind of body.
fn names_kind(name: &str, lexicon: &Lexicon) -> bool {
    let last = name.rsplit(' ').next();
    last.is_some_and(|last| lexicon.find(&[last], &[Class::Thing]).is_some())
}
