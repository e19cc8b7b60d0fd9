//! How one thing turns relative to another, its parts in any order: "relative to A, C is rotated through the angle `$b$` about x"
//! and "`$b$` is the angle by which C is turned about x with respect to A" as "C turns relative to A about x by the angle `$b$`".

use super::lexicon::Lexicon;
use super::reader::{ARTICLES, COPULAS};
use super::rewrite::put_in;
use super::sentence_parts::clause;
use super::sentence_words::Words;
use super::words::{Kind, Token};

/// Verbs of what turns.
const TURNS: [&str; 8] = [
    "turns", "turn", "rotates", "rotate", "spins", "spin", "revolves", "revolve",
];

/// The same behind "is".
const TURNED: [&str; 5] = ["turned", "rotated", "turning", "rotating", "spinning"];

/// Behind "is", with "from" and "by a rotation".
const OBTAINED: [&str; 6] = [
    "obtained",
    "reached",
    "got",
    "derived",
    "generated",
    "produced",
];

/// The same without "is".
const RESULTS: [&str; 8] = [
    "results", "result", "arises", "arise", "follows", "follow", "comes", "come",
];

/// What a rotation does with that from which it starts, before "to" or "into" and what becomes of it.
const TAKES: [&str; 8] = [
    "takes",
    "brings",
    "carries",
    "turns",
    "rotates",
    "moves",
    "transforms",
    "leads",
];

/// Words before that against which it turns.
const AGAINST: [&[&str]; 4] = [
    &["relative", "to"],
    &["with", "respect", "to"],
    &["with", "regard", "to"],
    &["against"],
];

/// Words at which a name ends.
const ENDS: [&str; 14] = [
    "relative", "with", "against", "about", "around", "by", "through", "at", "from", "in", "and",
    "to", "into", "on",
];

/// What is said of one turn.
#[derive(Default)]
struct Turn<'t> {
    subject: &'t [Token],
    from: &'t [Token],
    about: &'t [Token],
    by: &'t [Token],
    rate: &'t [Token],
    constant: bool,
    several: bool,
    /// "from" leads to that from which it turns.
    obtained: bool,
}

/// The words of a sentence that speaks of a turn.
fn speaks_of_turns(tokens: &[Token]) -> Option<Words<'_>> {
    let words = Words::of(tokens);
    let turn = |word: &&str| {
        let verb = TURNS.contains(word) || TURNED.contains(word);
        verb || matches!(*word, "rotation" | "turn" | "spin" | "rotating" | "turning")
    };
    words.lower.iter().any(turn).then_some(words)
}

/// A sentence that names an angle or a rate of a turn, or tells what a rotation brings where.
pub(super) fn turns_named(tokens: &[Token]) -> Option<Vec<Token>> {
    let reader = speaks_of_turns(tokens)?;
    let turn = reader
        .letter_first()
        .or_else(|| reader.letter_last())
        .or_else(|| reader.rotation_first())?;
    turn.is_whole().then(|| turn.told(&tokens[0]))
}

/// The clauses of a sentence that begins with one of how a thing turns.
pub(super) fn turns_apart(tokens: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
    let reader = speaks_of_turns(tokens)?;
    let mut told = vec![];
    let mut at = 0;
    while let Some((turn, behind)) = reader.clause(at).filter(|(turn, _)| turn.is_whole()) {
        told.extend(turn.told(&tokens[0]));
        if behind == tokens.len() {
            return Some(told);
        }
        at = reader.joint(behind)?;
        if let Some(constant) = reader.stays_constant(at, &turn) {
            told.extend(constant);
            return Some(told);
        }
    }
    let rest = &tokens[at..];
    let says = clause(rest, lexicon).is_some_and(|(subject, _, _)| {
        let first = subject[0].lower.as_str();
        ARTICLES.contains(&first) || matches!(subject[0].kind, Kind::Formula)
    });
    (at > 0 && says).then(|| [&told, rest].concat())
}

impl<'t> Words<'t> {
    /// Where it goes on behind some words that stand here.
    fn behind(&self, at: usize, words: &[&str]) -> Option<usize> {
        let here = (0..words.len()).all(|i| self.word(at + i) == words[i]);
        here.then_some(at + words.len())
    }

    fn behind_any(&self, at: usize, words: &[&str]) -> usize {
        at + usize::from(words.contains(&self.word(at)))
    }

    /// What is named from a place on, and where it ends.
    fn name(&self, at: usize) -> Option<(&'t [Token], usize)> {
        let ends = |i: &usize| {
            let sign = self.is(*i, Kind::Comma) || self.is(*i, Kind::Semicolon);
            let word = self.word(*i);
            let verb = [&TURNS[..], &COPULAS, &RESULTS, &["has", "have"]]
                .iter()
                .any(|verbs| verbs.contains(&word));
            sign || ENDS.contains(&word) || verb && *i > at
        };
        let end = (at..self.tokens.len()).find(ends);
        let end = end.unwrap_or(self.tokens.len());
        let name = self.tokens.get(at..end)?;
        let formula = |t: &Token| matches!(t.kind, Kind::Formula | Kind::Plain | Kind::Number);
        let one = name.len() == 1 || !name.iter().rev().skip(1).any(formula);
        let plain = !matches!(self.word(at), "which" | "that" | "it" | "its");
        (end > at && end - at <= LONGEST_NAME && one && plain).then_some((name, end))
    }

    /// Where the letter of an axis stands behind "the axis" or "the vertical".
    fn axis(&self, at: usize) -> Option<usize> {
        let start = self.behind_any(at, &["the", "its"]);
        let own = self.behind_any(start, &["own", "fixed"]);
        let noun = self.behind_any(own, &["axis", "vertical", "direction"]);
        let comma = usize::from(self.is(noun, Kind::Comma) && self.word(at) == "its");
        (noun > own && self.letter(noun + comma).is_some()).then_some(noun + comma)
    }

    /// A letter, behind words that may introduce it.
    fn letter(&self, at: usize) -> Option<(&'t [Token], usize)> {
        let one = self.is(at, Kind::Formula) && !self.tokens[at].text.contains(',');
        (one || self.is(at, Kind::Plain)).then(|| (&self.tokens[at..=at], at + 1))
    }

    /// The next part of a turn: against what, about what, by what angle, at what rate.
    fn part(&self, at: usize, turn: &mut Turn<'t>) -> Option<usize> {
        let from = if turn.obtained { "from" } else { "in" };
        let against = AGAINST.iter().find_map(|words| self.behind(at, words));
        if let Some(start) = against.or_else(|| self.behind(at, &[from])) {
            let (name, end) = self.name(start)?;
            let place = matches!(
                self.lower[end - 1],
                "sense" | "direction" | "plane" | "order"
            );
            return fill(&mut turn.from, name, end).filter(|_| !place);
        }
        match self.word(at) {
            "about" | "around" => {
                let named = self.axis(at + 1);
                let (name, end) = self.name(named.unwrap_or(at + 1))?;
                // "about its axis, `$n$`,"
                let closed = self.word(at + 1) == "its" && self.is(end, Kind::Comma);
                let end = end + usize::from(named.is_some() && closed);
                fill(&mut turn.about, name, end)
            }
            "by" | "through" | "of" => self.angle(at + 1, turn),
            "at" | "with" => self.rate(at + 1, turn),
            _ => None,
        }
    }

    /// "the angle `$a$`", or "a rotation", whose parts follow.
    fn angle(&self, at: usize, turn: &mut Turn<'t>) -> Option<usize> {
        let start = self.behind_any(at, &ARTICLES);
        if matches!(
            self.word(start),
            "rotation" | "turn" | "turning" | "rotating"
        ) {
            let end = start + 1;
            return match self.letter(end) {
                Some((letter, end)) => fill(&mut turn.by, letter, end),
                None => turn.obtained.then_some(end),
            };
        }
        let rotation = self.behind_any(start, &["rotation"]);
        let start = self.behind_any(rotation, &["angle"]);
        let start = self.behind(start, &["of", "rotation"]).unwrap_or(start);
        let (letter, end) = self.letter(start)?;
        fill(&mut turn.by, letter, end)
    }

    /// "the constant rate `$w$`".
    fn rate(&self, at: usize, turn: &mut Turn<'t>) -> Option<usize> {
        let start = self.behind_any(at, &ARTICLES);
        let steady = self.behind_any(start, &["constant", "uniform", "steady"]);
        let kind = self.behind_any(steady, &["angular", "spin", "rotation"]);
        let noun = self.behind_any(kind, &["rate", "speed", "velocity"]);
        let (letter, end) = self.letter(self.behind_any(noun, &["of"]))?;
        turn.constant |= steady > start;
        let end = fill(&mut turn.rate, letter, end)?;
        (noun > kind).then_some(end)
    }

    fn parts(&self, mut at: usize, turn: &mut Turn<'t>) -> usize {
        while let Some(end) = self.part(at, turn) {
            at = end;
        }
        at
    }

    /// Where it goes on behind a verb of turning.
    fn verb(&self, at: usize, turn: &mut Turn<'t>) -> Option<usize> {
        let word = self.word(at);
        if TURNS.contains(&word) {
            turn.several = !word.ends_with('s');
            return Some(at + 1);
        }
        if RESULTS.contains(&word) {
            (turn.several, turn.obtained) = (!word.ends_with('s'), true);
            return Some(at + 1);
        }
        let is = matches!(word, "is" | "are" | "has" | "have");
        let been = self.behind_any(at + 1, &["been", "being"]);
        turn.several = matches!(word, "are" | "have");
        turn.obtained = OBTAINED.contains(&self.word(been)) || self.word(been) == "turned";
        let turned = turn.obtained || TURNED.contains(&self.word(been));
        (is && turned).then_some(been + 1)
    }

    /// "Relative to A, C is rotated through the angle `$b$` about x": a turn, and where its clause ends.
    fn clause(&self, at: usize) -> Option<(Turn<'t>, usize)> {
        let mut turn = Turn::default();
        let front = self.parts(at, &mut turn);
        let start = front + usize::from(front > at && self.is(front, Kind::Comma));
        let end = self.subject_and_verb(start, &mut turn)?;
        let end = self.parts(end, &mut turn);
        Some((turn, end))
    }

    fn subject_and_verb(&self, at: usize, turn: &mut Turn<'t>) -> Option<usize> {
        let (subject, end) = self.name(at)?;
        turn.subject = subject;
        self.verb(end, turn)
    }

    /// Where "the angle by which C turns about x" or "the spin rate of C relative to A" ends.
    fn noun(&self, at: usize, turn: &mut Turn<'t>) -> Option<(bool, usize)> {
        let start = self.behind_any(at, &ARTICLES);
        let steady = self.behind_any(start, &["constant", "uniform", "steady"]);
        turn.constant |= steady > start;
        let kind = self.behind_any(steady, &["angular", "spin", "rotation", "turning"]);
        let rate = matches!(self.word(kind), "rate" | "speed");
        let mut end = self.behind_any(kind, &["angle", "rate", "speed"]);
        let of = self.behind(end, &["of", "rotation"]);
        let turning = kind > steady || of.is_some();
        end = of.filter(|_| end > kind).unwrap_or(end);
        let which = ["by", "through", "at", "with"].contains(&self.word(end));
        if which && self.word(end + 1) == "which" && end > kind {
            let front = self.parts(end + 2, turn);
            let front = front + usize::from(self.is(front, Kind::Comma));
            let verb = self.subject_and_verb(front, turn)?;
            return Some((rate, self.parts(verb, turn)));
        }
        let (subject, behind) = self.name(self.behind(end, &["of"])?)?;
        turn.subject = subject;
        (turning && end > kind).then_some((rate, self.parts(behind, turn)))
    }

    /// "`$b$` is the angle by which C is turned about x".
    fn letter_first(&self) -> Option<Turn<'t>> {
        let (letter, is) = self.letter(0)?;
        let start = self.behind(is, &["is"])?;
        let mut turn = Turn::default();
        let (rate, end) = self.noun(start, &mut turn)?;
        turn.set(rate, letter)?;
        (end == self.tokens.len()).then_some(turn)
    }

    /// "The angle by which C is turned about x is `$b$`".
    fn letter_last(&self) -> Option<Turn<'t>> {
        let mut turn = Turn::default();
        let front = self.parts(0, &mut turn);
        let start = front + usize::from(front > 0 && self.is(front, Kind::Comma));
        let (rate, end) = self.noun(start, &mut turn)?;
        let (letter, end) = self.letter(self.behind(end, &["is"])?)?;
        turn.set(rate, letter)?;
        (end == self.tokens.len()).then_some(turn)
    }

    /// "A rotation about x by the angle `$b$` takes A to C".
    fn rotation_first(&self) -> Option<Turn<'t>> {
        let start = self.behind_any(0, &ARTICLES);
        let rotation = self.behind_any(start, &["rotation", "turn"]);
        let mut turn = Turn::default();
        let verb = self.parts(rotation, &mut turn);
        let takes = rotation > start && TAKES.contains(&self.word(verb));
        let (from, to) = self.name(verb + 1).filter(|_| takes)?;
        let (subject, end) = self.name(self.behind_any(to, &["to", "into"]))?;
        (turn.from, turn.subject) = (from, subject);
        let named = end == self.tokens.len() && to < end - subject.len();
        (named && from.len() <= 2 && subject.len() <= 2).then_some(turn)
    }

    /// "which is constant" behind a turn with a letter.
    fn stays_constant(&self, at: usize, turn: &Turn<'t>) -> Option<Vec<Token>> {
        let is = self.behind(at, &["which"])?;
        let verb = ["is", "stays", "remains"].contains(&self.word(is));
        let whole = self.word(is + 1) == "constant" && is + 2 == self.tokens.len();
        let letter = [turn.by, turn.rate].concat();
        let word = |text| put_in(Kind::Word, text, &self.tokens[at]);
        (verb && whole).then(|| [letter.as_slice(), &["is", "constant"].map(word)].concat())
    }
}

/// No name has more words.
const LONGEST_NAME: usize = 6;

/// A part that is not told twice.
fn fill<'t>(part: &mut &'t [Token], told: &'t [Token], end: usize) -> Option<usize> {
    part.is_empty().then(|| *part = told)?;
    Some(end)
}

impl<'t> Turn<'t> {
    /// The letter of its angle or its rate.
    fn set(&mut self, rate: bool, letter: &'t [Token]) -> Option<()> {
        let part = if rate { &mut self.rate } else { &mut self.by };
        fill(part, letter, 0).map(|_| ())
    }

    /// Whether it says what turns about what, and how far or how fast.
    fn is_whole(&self) -> bool {
        let amount = self.by.is_empty() != self.rate.is_empty();
        amount && !self.subject.is_empty() && !self.about.is_empty()
    }

    /// "C turns relative to A about x by the angle `$b$`;"
    fn told(&self, near: &Token) -> Vec<Token> {
        let words = |text: &str| -> Vec<Token> {
            let word = |word: &str| put_in(Kind::Word, word, near);
            text.split(' ').map(word).collect()
        };
        let part = |text: &str, tokens: &[Token]| match tokens {
            [] => vec![],
            tokens => [words(text), tokens.to_vec()].concat(),
        };
        let rate = match self.constant {
            true => "at the constant rate",
            false => "at the rate",
        };
        [
            self.subject,
            &words(if self.several { "turn" } else { "turns" }),
            &part("relative to", self.from),
            &part("about", self.about),
            &part("by the angle", self.by),
            &part(rate, self.rate),
            &[put_in(Kind::Semicolon, "", near)],
        ]
        .concat()
    }
}
