//! What acts on what, as one clause for each load: "At C the floor acts on the wheel with the normal force `$N$` along y and
//! the friction `$F$` along `$-x$`" as "`$N$` is the normal force of the floor on the wheel at C along y", and so on.

use super::lexicon::{Class, Lexicon};
use super::reader::ARTICLES;
use super::rewrite::put_in;
use super::sentence_words::Words;
use super::told_acting::{Acting, Load};
use super::traits::Trait;
use super::words::{Kind, Token};

/// Verbs of what loads another thing.
const ACTS: [&str; 16] = [
    "acts",
    "act",
    "exerts",
    "exert",
    "applies",
    "apply",
    "pushes",
    "push",
    "pulls",
    "pull",
    "presses",
    "press",
    "drives",
    "drive",
    "transmits",
    "transmit",
];

/// The same of what is loaded.
const ACTED_ON: [&str; 5] = ["pulled", "pushed", "pressed", "driven", "loaded"];

/// Words at which the name of a thing or a direction ends.
const ENDS: [&str; 14] = [
    "on", "upon", "against", "to", "onto", "with", "at", "along", "in", "about", "and", "by",
    "from", "whose",
];

/// Words before what is loaded.
const UPON: [&str; 5] = ["on", "upon", "against", "to", "onto"];

/// The clauses of a sentence that says with what loads things act on others.
pub(super) fn loads_apart(tokens: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
    let words = Words::of(tokens);
    let acts = |word: &&str| ACTS.contains(word) || ACTED_ON.contains(word);
    if !words.lower.iter().any(acts) {
        return None;
    }
    let reader = Reader { words, lexicon };
    let mut acting = Acting::default();
    let mut at = 0;
    if reader.words.word(at) == "at" {
        let (place, behind) = reader.place_before(at + 1)?;
        acting.at = place;
        at = behind + usize::from(reader.words.is(behind, Kind::Comma));
    }
    let mut clauses = vec![];
    loop {
        let (behind, elliptic) = reader.clause(at, &mut acting)?;
        if elliptic && clauses.is_empty() {
            return None;
        }
        if acting.loads.is_empty() || acting.body.is_empty() {
            return None;
        }
        clauses.extend(acting.clauses(&tokens[0]));
        if behind == tokens.len() {
            return Some(clauses);
        }
        at = reader.words.joint(behind)?;
        let next = Acting {
            body: acting.body,
            ..Acting::default()
        };
        let before = std::mem::replace(&mut acting, next);
        if UPON.contains(&reader.words.word(at)) {
            at = reader.on_another(at, before, &mut acting)?;
            clauses.extend(acting.clauses(&tokens[0]));
            if at == tokens.len() {
                return Some(clauses);
            }
            at = reader.words.joint(at)?;
        }
    }
}

/// The words of a sentence.
struct Reader<'t> {
    words: Words<'t>,
    lexicon: &'t Lexicon,
}

impl<'t> Reader<'t> {
    /// What is named from a place on, up to the next preposition or sign, and to the next article where it is `short`.
    fn name(&self, at: usize, short: bool) -> Option<(&'t [Token], usize)> {
        let ends = |i: &usize| {
            let sign = self.words.is(*i, Kind::Comma) || self.words.is(*i, Kind::Semicolon);
            let word = ENDS.contains(&self.words.word(*i)) || ACTS.contains(&self.words.word(*i));
            sign || word || short && *i > at && ARTICLES.contains(&self.words.word(*i))
        };
        let end = (at..self.words.tokens.len())
            .find(ends)
            .unwrap_or(self.words.tokens.len());
        (end > at).then(|| (&self.words.tokens[at..end], end))
    }

    /// A place at the beginning: of "P gear 1" a capital alone.
    fn place_before(&self, at: usize) -> Option<(&'t [Token], usize)> {
        let (place, behind) = self.name(at, true)?;
        let first = place.first()?;
        let point = first.text.chars().count() == 1 && first.text.chars().all(char::is_uppercase);
        match point && place.len() > 1 {
            true => Some((&place[..1], at + 1)),
            false => Some((place, behind)),
        }
    }

    /// "the normal force `$N$` along y": the load, and where it ends.
    fn load(&self, at: usize) -> Option<(Load<'t>, usize)> {
        let start = at + usize::from(ARTICLES.contains(&self.words.word(at)));
        if let Some(load) = self.by_components(start) {
            return Some(load);
        }
        let letter = (start..self.words.tokens.len().min(start + 6))
            .find(|&i| self.words.is(i, Kind::Formula))?;
        let noun = self.load_noun(start, letter)?;
        let mut load = Load {
            noun: &self.words.tokens[noun..letter],
            letter: self.words.tokens[letter..=letter].to_vec(),
            at: &[],
            along: vec![],
            components: false,
        };
        let mut at = letter + 1;
        while let Some(behind) = self.place_of(at, &mut load) {
            at = behind;
        }
        Some((load, at))
    }

    /// "force whose components along x and y are `$X$` and `$Y$`", where the clause ends behind it.
    fn by_components(&self, start: usize) -> Option<(Load<'t>, usize)> {
        let whose =
            (start + 1..self.words.tokens.len()).find(|&i| self.words.word(i) == "whose")?;
        let noun = self.load_noun(start, whose)?;
        let said = [1, 2].map(|i| self.words.word(whose + i)) == ["components", "along"];
        let are =
            (whose..self.words.tokens.len()).find(|&i| self.words.word(i) == "are" && said)?;
        let respectively =
            (are..self.words.tokens.len()).find(|&i| self.words.word(i) == "respectively");
        let end = respectively.map_or(self.words.tokens.len(), |i| {
            i - usize::from(self.words.is(i - 1, Kind::Comma))
        });
        let load = Load {
            noun: &self.words.tokens[noun..whose],
            letter: self.words.tokens.get(are + 1..end)?.to_vec(),
            at: &[],
            along: self.words.tokens.get(whose + 2..are)?.to_vec(),
            components: true,
        };
        let last = respectively.map_or(end, |i| i + 1);
        (last == self.words.tokens.len() && end > are + 1).then_some((load, last))
    }

    /// Where the noun of a load begins that ends at a place: adjectives that the direction tells again stand before it.
    fn load_noun(&self, start: usize, end: usize) -> Option<usize> {
        let idle = |i: usize| matches!(self.words.word(i), "horizontal" | "vertical");
        let first = (start..end).find(|&i| !idle(i))?;
        let found = self
            .lexicon
            .find(self.words.lower.get(first..end)?, &[Class::Noun])?;
        (found.entry.is_load() && first + found.length == end).then_some(first)
    }

    /// "at P", "along x", "in the direction of x": what stands behind the letter of a load.
    fn place_of(&self, at: usize, load: &mut Load<'t>) -> Option<usize> {
        if self.words.word(at) == "at" && load.at.is_empty() {
            let (place, behind) = self.name(at + 1, false)?;
            load.at = place;
            return Some(behind);
        }
        let (along, behind) = self.direction(at)?;
        load.along.is_empty().then(|| load.along = along)?;
        Some(behind)
    }

    /// "along x", "in the direction of x", "about z".
    fn direction(&self, at: usize) -> Option<(Vec<Token>, usize)> {
        let directed =
            usize::from(self.words.is(at, Kind::Comma) && self.words.word(at + 1) == "directed")
                * 2;
        let at = at + directed + usize::from(self.words.word(at) == "directed");
        if let Some(told) = self.direction_of_plane(at) {
            return Some(told);
        }
        let (skipped, word) = match self.words.word(at) {
            "in" if [1, 2, 3].map(|i| self.words.word(at + i)) == ["the", "direction", "of"] => {
                (4, "along")
            }
            "along" => (1, "along"),
            // A moment about an axis is that along it.
            "about" => (1, "along"),
            _ => return None,
        };
        let (direction, behind) = self.name(at + skipped, false)?;
        let word = put_in(Kind::Word, word, &self.words.tokens[at]);
        Some(([&[word], direction].concat(), behind))
    }

    /// "up the slope", "away from the floor", "upward" as "along the uphill direction of the slope", "along the normal of the
    /// floor", "along the upward vertical".
    fn direction_of_plane(&self, at: usize) -> Option<(Vec<Token>, usize)> {
        let article = |i: usize| ARTICLES.contains(&self.words.word(i));
        let (said, named): (&[&str], usize) = match self.words.word(at) {
            "up" if article(at + 1) => (&["along", "the", "uphill", "direction", "of"], at + 1),
            "down" if article(at + 1) => (&["along", "the", "downhill", "direction", "of"], at + 1),
            "away" if self.words.word(at + 1) == "from" && article(at + 2) => {
                (&["along", "the", "normal", "of"], at + 2)
            }
            "upward" | "upwards" => (&["along", "the", "upward", "vertical"], 0),
            "downward" | "downwards" => (&["along", "the", "downward", "vertical"], 0),
            _ => return None,
        };
        let place = &self.words.tokens[at];
        let mut words: Vec<Token> = said
            .iter()
            .map(|word| put_in(Kind::Word, word, place))
            .collect();
        if named == 0 {
            return Some((words, at + 1));
        }
        let (plane, behind) = self.name(named, false)?;
        words.extend(plane.iter().cloned());
        Some((words, behind))
    }

    /// "with the force `$F$` along x and the friction `$R$` along y": all loads of a list, and where it ends.
    fn loads(&self, at: usize, acting: &mut Acting<'t>) -> Option<usize> {
        let (load, mut behind) = self.load(at)?;
        acting.loads.push(load);
        while let Some(next) = self.words.joint(behind) {
            let next = next + usize::from(self.words.word(next) == "with");
            let Some((load, after)) = self.load(next) else {
                break;
            };
            // "and the force F acts …" begins another clause
            if matches!(self.words.word(after), "acts" | "is") {
                break;
            }
            acting.loads.push(load);
            behind = after;
        }
        Some(behind)
    }

    /// One clause, where it ends, and whether its verb is left out.
    fn clause(&self, at: usize, acting: &mut Acting<'t>) -> Option<(usize, bool)> {
        if self.load(at).is_some() {
            return Some((self.of_loads(at, acting)?, false));
        }
        let (agent, end) = self.name(at, false)?;
        self.is_thing(agent).then_some(())?;
        let (place, verb) = self.place_of_agent(end).unwrap_or((&[], end));
        if self.words.word(verb) == "with" {
            acting.agent = agent;
            return Some((self.loads(verb + 1, acting)?, true));
        }
        if let Some(acted) = self.acted_on(agent) {
            acting.body = &agent[..acted];
            let mut at = verb;
            while let Some(behind) = self.part(at, acting) {
                at = behind;
            }
            (self.words.word(at) == "by").then_some(())?;
            return Some((self.loads(at + 1, acting)?, false));
        }
        ACTS.contains(&self.words.word(verb)).then_some(())?;
        acting.agent = agent;
        // What the clause before spoke of is loaded where this one names nothing else.
        let before = std::mem::take(&mut acting.body);
        let mut at = verb + 1;
        while let Some(behind) = self.part(at, acting) {
            at = behind;
        }
        // "and the floor acts on it": nothing acts on itself.
        let again = matches!(acting.body, [it] if matches!(it.lower.as_str(), "it" | "them"));
        if acting.body.is_empty() || again && !before.is_empty() {
            acting.body = before;
        }
        if acting.at.is_empty() && acting.loads.iter().all(|load| self.is_force(load)) {
            acting.at = place;
        }
        Some((at, false))
    }

    /// "The motor at O acts on …": where what acts is, and where the verb stands.
    fn place_of_agent(&self, at: usize) -> Option<(&'t [Token], usize)> {
        let (place, verb) = self.name(at + 1, false)?;
        (self.words.word(at) == "at" && ACTS.contains(&self.words.word(verb)))
            .then_some((place, verb))
    }

    /// Whether a load acts at a point.
    fn is_force(&self, load: &Load<'t>) -> bool {
        let words: Vec<&str> = load.noun.iter().map(|t| t.lower.as_str()).collect();
        let noun = self.lexicon.find(&words, &[Class::Noun]);
        noun.is_some_and(|noun| noun.entry.traits.has(Trait::Force))
    }

    /// "… and on the arm with the opposite moment": what acted in the clause before acts on another body as well.
    fn on_another(&self, at: usize, before: Acting<'t>, acting: &mut Acting<'t>) -> Option<usize> {
        let (body, with) = self.name(at + 1, true)?;
        (acting.agent, acting.body) = (before.agent, body);
        let opposite = [1, 2].map(|i| self.words.word(with + i)) == ["the", "opposite"];
        (self.words.word(with) == "with").then_some(())?;
        if !opposite {
            return self.loads(with + 1, acting);
        }
        let noun = self.load_noun(with + 3, with + 4)?;
        acting.loads = before.loads;
        acting.along = before.along;
        for letter in acting.loads.iter_mut().flat_map(|load| &mut load.letter) {
            letter.text.insert(0, '-');
        }
        (acting.loads.len() == 1).then_some(noun + 1)
    }

    /// "The force `$F$` along x and the force `$R$` along y act on the rod at A."
    fn of_loads(&self, at: usize, acting: &mut Acting<'t>) -> Option<usize> {
        let verb = self.loads(at, acting)?;
        let several = acting.loads.len() > 1;
        (several && matches!(self.words.word(verb), "act" | "acts")).then_some(())?;
        let mut at = verb + 1;
        while let Some(behind) = self.part(at, acting) {
            at = behind;
        }
        Some(at)
    }

    /// Whether words name a thing: no list, no load, nothing in a formula but its letter.
    fn is_thing(&self, agent: &[Token]) -> bool {
        let words: Vec<&str> = agent.iter().map(|t| t.lower.as_str()).collect();
        let load = |at: usize| {
            let noun = self.lexicon.find(&words[at..], &[Class::Noun]);
            noun.is_some_and(|noun| noun.entry.is_load())
        };
        let formula = |t: &Token| matches!(t.kind, Kind::Formula | Kind::Plain);
        // What drives something on the other side of a gear is called its load.
        if words == ["the", "load"] {
            return true;
        }
        !(0..words.len()).any(load) && !agent.iter().any(formula) && words.len() <= 6
    }

    /// Where the words "is pulled" begin at the end of some words.
    fn acted_on(&self, words: &[Token]) -> Option<usize> {
        let [body @ .., is, acted] = words else {
            return None;
        };
        let passive = matches!(is.lower.as_str(), "is" | "are");
        let acted = ACTED_ON.contains(&acted.lower.as_str());
        (passive && acted && !body.is_empty()).then_some(body.len())
    }

    /// The next part behind the verb: on what, at what point, along what, with what.
    fn part(&self, at: usize, acting: &mut Acting<'t>) -> Option<usize> {
        let word = self.words.word(at);
        if UPON.contains(&word) && acting.body.is_empty() {
            let (body, behind) = self.name(at + 1, true)?;
            acting.body = body;
            return self.is_thing(body).then_some(behind);
        }
        if word == "at" && acting.at.is_empty() {
            let (place, behind) = self.name(at + 1, false)?;
            acting.at = place;
            return Some(behind);
        }
        if word == "with" && acting.loads.is_empty() {
            return self.loads(at + 1, acting);
        }
        if let Some((along, behind)) = self.direction(at).filter(|_| acting.along.is_empty()) {
            acting.along = along;
            return Some(behind);
        }
        if acting.loads.is_empty() && self.load(at).is_some() {
            return self.loads(at, acting);
        }
        let (body, behind) = self.name(at, false).filter(|_| acting.body.is_empty())?;
        acting.body = body;
        // "drives gear 1"
        let numbered = matches!(body, [_, number] if number.text.parse::<u8>().is_ok());
        let named = ARTICLES.contains(&word) || numbered;
        (named && self.is_thing(body)).then_some(behind)
    }
}
