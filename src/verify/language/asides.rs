//! What is said of a thing within a sentence about another, as a clause of its own: "a disc that turns about z", "the floor,
//! which is fixed in N,", "a point whose position is `$r$`", "the axle, about which it turns", "hinged at O, a point of N".

use super::heads::SIZES;
use super::lexicon::{Class, Lexicon};
use super::named_things::{
    definite, is_name, is_way_of_load, named_last, stands_in, with_owner, without_comma,
    without_sizes,
};
use super::reader::{ARTICLES, COPULAS};
use super::rewrite::put_in;
use super::sentence_parts::{HELD, begins_with_verb, clause, joins, nouns_end, preposition};
use super::words::{Kind, Token};

/// So many ways to tell the asides of a sentence are tried at most.
const MOST_WAYS: usize = 10;

/// How an aside goes on from the thing that it is said of.
#[derive(Clone, Copy, PartialEq)]
enum Going {
    /// "which turns", "that line 3 defines"
    Which,
    /// "whose mass is `$m$`"
    Whose,
    /// "about which it turns"
    ByPreposition,
    /// "a point fixed in N"
    Apposed,
    /// "hinged at O"
    Done,
}

/// Where an aside begins, and what it says.
struct Aside<'t> {
    going: Going,
    /// What stands before it in its clause, without the comma.
    before: &'t [Token],
    /// The word by which it goes on; the preposition before "which".
    word: &'t [Token],
    /// What it says and all behind it in the clause.
    inside: &'t [Token],
    /// Whether a comma sets it off.
    set_off: bool,
}

/// The sentence with an aside of one of its clauses behind that clause, for each thing that it may be said of and each place
/// where it may end: the likeliest first.
pub(super) fn asides_apart(tokens: &[Token], lexicon: &Lexicon) -> Vec<Vec<Token>> {
    let mut ways = vec![];
    let mut start = 0;
    for now in tokens.split(|t| t.kind == Kind::Semicolon) {
        let end = start + now.len();
        let asides = (1..now.len()).filter_map(|at| aside(now, at, lexicon));
        for aside in asides {
            for told in aside.told(lexicon) {
                ways.push([&tokens[..start], &told, &tokens[end..]].concat());
            }
        }
        start = end + 1;
    }
    ways.truncate(MOST_WAYS);
    ways
}

/// The aside that begins at a place of a clause.
fn aside<'t>(now: &'t [Token], at: usize, lexicon: &Lexicon) -> Option<Aside<'t>> {
    let set_off = now[at - 1].kind == Kind::Comma;
    let before = &now[..at - usize::from(set_off)];
    let word = |at: usize| now.get(at).map_or("", |t: &Token| t.lower.as_str());
    let of = |going, skipped: usize| {
        let (word, inside) = now[at..].split_at(skipped);
        Some(Aside {
            going,
            before,
            word,
            inside,
            set_off,
        })
    };
    if before.is_empty() || !is_word(&now[at]) {
        return None;
    }
    let hangs = before
        .last()
        .is_some_and(|last| preposition(std::slice::from_ref(last), lexicon).is_some());
    match word(at) {
        "which" | "that" | "who" if !hangs => of(Going::Which, 1),
        "whose" => of(Going::Whose, 1),
        "a" | "an" if set_off => of(Going::Apposed, 0),
        "the" if set_off && clause(before, lexicon).is_none() => of(Going::Apposed, 0),
        done if (HELD.contains(&done) || DONE.contains(&done)) && !is_said(before) => {
            of(Going::Done, 0)
        }
        _ => {
            let length = preposition(&now[at..], lexicon)?;
            (word(at + length) == "which").then(|| of(Going::ByPreposition, length))?
        }
    }
}

fn is_word(token: &Token) -> bool {
    token.kind == Kind::Word
}

/// Whether what stands last has its participle as a predicate: "is rigidly".
fn is_said(before: &[Token]) -> bool {
    let mut words = before.iter().rev().map(|t| t.lower.as_str());
    words
        .find(|word| !word.ends_with("ly"))
        .is_some_and(|word| COPULAS.contains(&word) || JOINTS.contains(&word))
}

/// What is said of quantities and of no other things.
const OF_QUANTITIES: [&str; 6] = [
    "constant", "negative", "nonzero", "positive", "small", "zero",
];

/// Words behind which a participle goes on from a verb.
const JOINTS: [&str; 9] = [
    "and", "or", "not", "be", "been", "has", "have", "both", "each",
];

/// What else is done to things and said behind their nouns, and the adverbs of it.
const DONE: [&str; 11] = [
    "supported",
    "welded",
    "joined",
    "clamped",
    "glued",
    "bolted",
    "soldered",
    "rigidly",
    "firmly",
    "freely",
    "driven",
];

impl Aside<'_> {
    /// The clause, and behind it what the aside says.
    fn told(&self, lexicon: &Lexicon) -> Vec<Vec<Token>> {
        let mut ways = vec![];
        let said = clause(self.before, lexicon);
        for whose in self.things(lexicon) {
            for end in self.ends(lexicon) {
                let (inside, behind) = self.inside.split_at(end);
                let inside = without_comma(inside);
                let Some(main) = self.without(behind, said, lexicon) else {
                    continue;
                };
                for told in self.as_clauses(&whose, inside, lexicon) {
                    let semicolon = [put_in(Kind::Semicolon, "", &self.before[0])];
                    ways.push([&main, &semicolon[..], &told].concat());
                }
            }
        }
        ways
    }

    /// Where the aside may end: behind a comma at the next comma or the last; else where the clause goes on with a verb.
    fn ends(&self, lexicon: &Lexicon) -> Vec<usize> {
        let all = self.inside.len();
        let subject = clause(self.before, lexicon).is_none();
        let comma = |&at: &usize| self.inside[at].kind == Kind::Comma;
        let commas = (1..all).filter(comma);
        let mut ends: Vec<usize> = match (subject, self.set_off) {
            // The subject still has no verb.
            (true, true) => commas.clone().collect(),
            (true, false) => {
                let verb = |&at: &usize| begins_with_verb(&self.inside[at..], lexicon);
                (2..all).filter(verb).collect()
            }
            (false, true) => commas.clone().chain([all]).collect(),
            (false, false) => [all].into_iter().chain(commas.clone()).collect(),
        };
        if !subject && !self.set_off {
            let and = |&at: &usize| {
                self.inside[at].lower == "and" && has_verb(&self.inside[at + 1..], lexicon)
            };
            ends.extend((1..all).filter(and));
        }
        ends.truncate(4);
        ends
    }

    /// The clause without its aside: its subject goes on, or another clause is joined.
    fn without(
        &self,
        behind: &[Token],
        said: Option<(&[Token], &[Token], &[Token])>,
        lexicon: &Lexicon,
    ) -> Option<Vec<Token>> {
        let comma = |t: &&Token| t.kind == Kind::Comma;
        let behind = &behind[behind.iter().take_while(comma).count()..];
        let Some((subject, ..)) = said else {
            let goes_on = begins_with_verb(behind, lexicon);
            return goes_on.then(|| [self.before, behind].concat());
        };
        let Some(first) = behind.first() else {
            return Some(self.before.to_vec());
        };
        let and = first.lower == "and";
        let next = &behind[usize::from(and)..];
        let semicolon = [put_in(Kind::Semicolon, "", first)];
        if begins_with_verb(next, lexicon) {
            return and.then(|| [self.before, &semicolon, subject, next].concat());
        }
        match and && has_verb(next, lexicon) {
            true => Some([self.before, &semicolon, next].concat()),
            false => Some([self.before, behind].concat()),
        }
    }

    /// What the aside may be said of: the subject of which it is told what it is, or what is named last, or of what that is.
    fn things(&self, lexicon: &Lexicon) -> Vec<Vec<Token>> {
        let before = without_sizes(self.before, lexicon);
        let mut things = vec![];
        if let Some((subject, ..)) = clause(before, lexicon)
            && (is_way_of_load(before, self.inside) || self.acts())
        {
            return vec![definite(subject, lexicon)];
        }
        if let Some((subject, verb, rest)) = clause(before, lexicon) {
            let is = COPULAS.contains(&verb[0].lower.as_str());
            let indefinite = rest
                .first()
                .is_some_and(|t| matches!(t.lower.as_str(), "a" | "an"));
            let letter = subject.iter().all(|t| t.kind == Kind::Formula || joins(t));
            let one = !rest
                .iter()
                .skip(1)
                .any(|t| ARTICLES.contains(&t.lower.as_str()));
            if is && !letter && (indefinite && one || !self.set_off) {
                return vec![definite(subject, lexicon)];
            }
            if is && letter && self.tells_how_a_quantity_is(rest) {
                return vec![subject.to_vec()];
            }
            things.extend(named_last(rest, lexicon));
            things.extend(with_owner(rest));
            if is && !letter {
                let at = if self.tells_size(lexicon) {
                    0
                } else {
                    things.len()
                };
                things.insert(at, definite(subject, lexicon));
            }
        } else {
            things.extend(named_last(before, lexicon));
            things.push(definite(before, lexicon));
        }
        things.dedup();
        // "the force of the floor, which is normal to the floor": an aside does not name what it is said of.
        things.retain(|thing| !stands_in(thing, self.inside));
        things
    }

    /// "`$n$` is the rate of `$q$`, which is constant": of two quantities the one that the sentence is about, and no body is
    /// constant.
    fn tells_how_a_quantity_is(&self, rest: &[Token]) -> bool {
        let how = |t: &Token| OF_QUANTITIES.contains(&t.lower.as_str());
        let size = match rest {
            [.., before, last] => {
                let hangs = ["of", "along", "about", "on", "in"].contains(&before.lower.as_str());
                last.kind == Kind::Formula && !hangs
            }
            _ => false,
        };
        !size && self.inside.iter().any(how)
    }

    /// A force acts, and not the body that it is told of.
    fn acts(&self) -> bool {
        let first = self.inside.first();
        first.is_some_and(|t| t.lower.starts_with("act"))
    }

    /// Whether a size is told, which no point has: "which has the length `$l$`", "whose mass is `$m$`".
    fn tells_size(&self, lexicon: &Lexicon) -> bool {
        let skipped = |t: &&Token| {
            ARTICLES.contains(&t.lower.as_str()) || matches!(t.lower.as_str(), "has" | "have")
        };
        let inside = &self.inside[self.inside.iter().take_while(skipped).count()..];
        let words: Vec<&str> = inside.iter().take(3).map(|t| t.lower.as_str()).collect();
        let noun = lexicon.find(&words, &[Class::Noun]);
        noun.is_some_and(|noun| SIZES.contains(&noun.entry.name))
    }

    /// What the aside says of a thing, as clauses.
    fn as_clauses(&self, whose: &[Token], inside: &[Token], lexicon: &Lexicon) -> Vec<Vec<Token>> {
        let near = &self.before[0];
        let word = |word: &str| put_in(Kind::Word, word, near);
        let none = vec![];
        match self.going {
            Going::Done | Going::Apposed => vec![[whose, &[word("is")], inside].concat()],
            Going::Which if !begins_subject(inside) => vec![[whose, inside].concat()],
            Going::Which => match clause(inside, lexicon) {
                Some((subject, verb, rest)) => vec![[subject, verb, whose, rest].concat()],
                None => none,
            },
            Going::Whose => possessed(inside, whose, lexicon).into_iter().collect(),
            Going::ByPreposition => {
                let inside = &inside[1..];
                match clause(inside, lexicon) {
                    Some((subject, verb, rest)) => vec![
                        [inside, self.word, whose].concat(),
                        [subject, verb, self.word, whose, rest].concat(),
                    ],
                    None => none,
                }
            }
        }
    }
}

/// "whose centre is C and whose mass centre G lies on z": the centre of the thing is C; the mass centre G of the thing lies on z.
fn possessed(inside: &[Token], whose: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
    let next = inside.windows(2).position(|pair| {
        pair[1].lower == "whose" && (pair[0].lower == "and" || pair[0].kind == Kind::Comma)
    });
    let (own, next) = match next {
        Some(at) => (&inside[..at], Some(&inside[at + 2..])),
        None => (inside, None),
    };
    let near = own.first()?;
    let [the, of] = ["the", "of"].map(|word| put_in(Kind::Word, word, near));
    let (noun, verb, rest) = clause(own, lexicon)?;
    let noun_ends = nouns_end(noun, lexicon);
    (noun_ends > 0).then_some(())?;
    let told = [&[the], noun, &[of], whose, verb, rest].concat();
    let told = without_comma(&told);
    let Some(next) = next else {
        return Some(told.to_vec());
    };
    let semicolon = [put_in(Kind::Semicolon, "", near)];
    Some([told, &semicolon[..], &possessed(next, whose, lexicon)?].concat())
}

/// Whether a clause begins that has a subject of its own: "which the floor supports", "that it touches".
fn begins_subject(inside: &[Token]) -> bool {
    let Some(first) = inside.first() else {
        return false;
    };
    let word = first.lower.as_str();
    let article = ARTICLES.contains(&word) || matches!(word, "it" | "they");
    article || first.kind == Kind::Formula || is_name(first)
}

/// Whether a clause stands here: something before a verb.
fn has_verb(tokens: &[Token], lexicon: &Lexicon) -> bool {
    begins_with_verb(tokens, lexicon) || clause(tokens, lexicon).is_some()
}
