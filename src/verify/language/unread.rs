//! What can be told of a sentence that is not understood: of which letters it speaks, and what it may change.

use super::clause::as_formula;
use super::extent::LINES;
use super::heads::OF_COUNTING;
use super::lexicon::Class;
use super::one_thing::{is_letter, is_of_one_thing};
use super::phrase::NOUNS;
use super::reader::{ARTICLES, COPULAS, Read, Reader};
use super::sign::LABELS;
use super::statement::{Extent, Formula, Sign, Touched};
use super::times::begins_with_time;
use super::unsaying::{DENYING, RETRACTING, may_be_rule, retracts};
use super::words::{Kind, Token};
use crate::notation::document::Row;

/// Words that behind "for" say something of a letter with any labels.
const FOR_ALL: [&str; 4] = ["any", "every", "each", "all"];

/// Words for what the sentence before spoke of.
const PRONOUNS: [&str; 3] = ["it", "they", "both"];

/// Prepositions by which a noun goes on behind a comma.
const DESCRIBING: [&str; 6] = ["as", "in", "on", "of", "with", "from"];

/// Verbs of what a thing has.
const OWNING: [&str; 5] = ["have", "have components", "consist", "depend", "hold"];

/// Prepositions that behind "is" say what a thing is.
const OF_WHAT_IT_IS: [&str; 5] = ["of", "with", "as", "with axes", "with edges"];

/// What is written on a line.
const FORMULAS: [&str; 7] = [
    "formula",
    "formulas",
    "relation",
    "equation",
    "equality",
    "expression",
    "statement",
];

/// Words that begin a time or a case in which alone something holds.
pub(super) const CONDITIONS: [&str; 12] = [
    "if",
    "when",
    "whenever",
    "while",
    "after",
    "before",
    "until",
    "during",
    "once",
    "provided",
    "assuming",
    "initially",
];

/// Words by which a sentence may say how all formulas are read.
const OF_CONVENTIONS: [&str; 33] = [
    "vector",
    "vectors",
    "tensor",
    "tensors",
    "matrix",
    "matrices",
    "column",
    "columns",
    "row",
    "rows",
    "entry",
    "entries",
    "component",
    "basis",
    "rate",
    "rates",
    "derivative",
    "derivatives",
    "differentiated",
    "product",
    "products",
    "resolved",
    "expressed",
    "seen",
    "taken",
    "order",
    "convention",
    "conventions",
    "equation",
    "equations",
    "formula",
    "line",
    "lines",
];

/// The signs that a sentence speaks of, and whether it may be a rule beside them.
#[derive(Default)]
struct Signs {
    found: Vec<Sign>,
    other_rule: bool,
}

impl Reader<'_> {
    /// The letters of a sentence that only says what quantities they are: "`$s$` and `$t$` are … rates …".
    pub(crate) fn letters_told(&mut self) -> Read<Vec<Formula>> {
        let subjects = self.terms()?;
        let formulas: Option<Vec<Formula>> = subjects.iter().map(as_formula).collect();
        let says_what = self.take_any(&COPULAS)
            && (ARTICLES.contains(&self.word()) || self.at_formula() && !self.joins_more());
        if !says_what {
            return Ok(vec![]);
        }
        let nouns = (self.at..self.tokens.len()).filter_map(|at| {
            self.at = at;
            self.find(&NOUNS)
        });
        let names = nouns.take(1).all(|noun| noun.entry.only_names());
        Ok(formulas.filter(|_| names).unwrap_or_default())
    }

    /// The lines of a formula that a sentence is about: "The second formula of line 5 …". It changes them alone.
    pub(crate) fn lines_of_formula(&mut self) -> Option<Vec<Extent>> {
        self.at = 0;
        let first = self.tokens.iter().take(3);
        let about = ARTICLES.contains(&self.word())
            && first.skip(1).any(|t| FORMULAS.contains(&t.lower.as_str()));
        let line = |pair: &[Token]| {
            LINES.contains(&pair[0].lower.as_str()) && pair[1].kind == Kind::Number
        };
        let rule = self.tokens.iter().any(|t| may_be_rule(&t.lower));
        let lines = self.tokens.windows(2).position(line);
        let lines = lines.filter(|_| about && !rule)?;
        self.at = lines;
        let found = self.spoken_of().ok().flatten();
        self.at = 0;
        found
    }

    /// What a sentence may change, from behind the part of the document that it is said of: one that is said of a part may
    /// tell there of anything anew.
    pub(crate) fn touched(&mut self, of_a_part: bool) -> Touched {
        let start = self.at;
        let subjects = self.subjects();
        let joined = self.joins_more();
        self.at = start;
        let sign_first = self.at_sign_with_article();
        self.at = start;
        let things = !sign_first && self.is_about_things();
        self.at = start;
        // How things move and what acts on them changes no letter but those that tell of it.
        let moves = things && self.says_what_a_thing_does() || !sign_first && self.adds_a_premise();
        let moving = moves && !of_a_part;
        let (formulas, signs) = self.formulas_and_signs(!subjects.is_empty());
        self.at = start;
        let letters = !subjects.is_empty() && subjects.iter().all(is_of_one_thing);
        let rule_behind = letters && joined && (signs.other_rule || !signs.found.is_empty());
        let written = |s: &Formula| !matches!(s.row, Row::Line(_));
        let operator = subjects.iter().any(|s| written(s) && !is_of_one_thing(s));
        let for_all = |at: usize| {
            FOR_ALL.contains(&self.tokens[at].lower.as_str()) && self.tokens[at - 1].lower == "for"
        };
        let any = (1..self.tokens.len()).any(for_all);
        let whole = !signs.other_rule && !of_a_part;
        let tells = things && !rule_behind && !self.unsays() && self.says_what_is_known();
        let adds = moving || tells && !of_a_part;
        let adds =
            adds || things && !rule_behind && !of_a_part && self.leaves_formulas_as_they_are();
        // What it says of a thing may take back what is assumed of all things: "it is a left-handed frame", "it has a hole".
        if adds && signs.found.is_empty() {
            let anew = false;
            Touched::Letters { formulas, anew }
        } else if things || rule_behind {
            Touched::Everything
        } else if letters || whole && !formulas.is_empty() && signs.found.is_empty() && !operator {
            // Of a formula of several letters it may say something that leaves the letters as they are.
            let letter = subjects.iter().any(is_letter);
            let has = |list: &[&str]| self.tokens.iter().any(|t| list.contains(&t.lower.as_str()));
            let changes = subjects.is_empty() && has(&RETRACTING);
            let anew = (any || of_a_part || changes) && (subjects.is_empty() || letter);
            // From where a letter is counted, and which way, nothing else tells.
            match (has(&OF_COUNTING), letter) {
                (true, true) if !anew => Touched::Written(subjects),
                (true, false) if self.begins_with_named() => Touched::Written(formulas),
                _ => Touched::Letters { formulas, anew },
            }
        } else if operator {
            Touched::Signs(subjects.into_iter().map(Sign::Operator).collect())
        } else if !signs.found.is_empty() && (sign_first || whole) {
            Touched::Signs(signs.found)
        } else {
            Touched::Everything
        }
    }

    /// Whether it speaks of loads, and no word of it is one of how formulas are read, or takes back what is assumed of things:
    /// without it less is known, and what is known means the same.
    fn leaves_formulas_as_they_are(&mut self) -> bool {
        let start = self.at;
        let (mut rules, mut loads) = (self.takes_back() || self.unsays(), false);
        while !rules && !self.done() {
            loads |= self.at_load();
            let word = self.word();
            rules = may_be_rule(word) || OF_CONVENTIONS.contains(&word) || self.at_rule(false);
            self.at += 1;
        }
        self.at = start;
        loads && !rules
    }

    /// The formulas that a sentence is about; none if it is about something else as well.
    fn subjects(&mut self) -> Vec<Formula> {
        let mut subjects = self.formulas();
        while !subjects.is_empty() && self.take_separator() {
            match self.at_formula() {
                true => subjects.extend(self.formulas()),
                false => return vec![],
            }
        }
        subjects
    }

    /// Whether another clause is joined to what is said of the subject: it may be a rule.
    fn joins_more(&self) -> bool {
        let joins = |t: &Token| matches!(t.kind, Kind::Semicolon | Kind::Comma) || t.lower == "and";
        let formula = |t: &Token| matches!(t.kind, Kind::Formula | Kind::Plain);
        let rest = self.tokens.get(self.at..).unwrap_or_default();
        let first = rest.iter().position(|t| t.kind == Kind::Word);
        let behind = first.map_or(rest, |first| &rest[first..]);
        let joint = |pair: &[Token]| joins(&pair[0]) && !joins(&pair[1]) && !formula(&pair[1]);
        let described = |pair: &[Token]| DESCRIBING.contains(&pair[1].lower.as_str());
        behind
            .windows(2)
            .any(|pair| joint(pair) && !described(pair))
    }

    /// Whether the subject is a thing, a place, or what the sentence before spoke of, and no way to write something.
    fn is_about_things(&mut self) -> bool {
        if PRONOUNS.contains(&self.word()) || self.at_name() {
            return true;
        }
        if self.find(&[Class::Custom, Class::Mark]).is_some() {
            return false;
        }
        self.take_any(&ARTICLES) && {
            let sign = self.find(&[Class::Custom, Class::Mark, Class::Meaning]);
            sign.is_none() && self.at_thing()
        }
    }

    /// Whether the first verb behind a thing says what it does or undergoes, and not what it is or has.
    fn says_what_a_thing_does(&mut self) -> bool {
        let start = self.at;
        let mut words = self.tokens[start..].iter().map(|t| t.lower.as_str());
        let denies = words.any(|word| DENYING.contains(&word) || retracts(word));
        let undergoes = self.skip_to_verb() == Some(true);
        self.at += usize::from(undergoes);
        let does = match undergoes {
            true => self.find(&[Class::Passive, Class::Preposition]),
            false => self.find(&[Class::Verb]),
        };
        self.at = start;
        let is = |name: &str| match undergoes {
            true => !OF_WHAT_IT_IS.contains(&name),
            false => !OWNING.contains(&name),
        };
        !denies && does.is_some_and(|verb| is(verb.entry.name))
    }

    /// Whether it tells what a thing is or does, what a load does, or what holds at a time or under a condition: that adds to
    /// what is known. What would take back what is assumed of all things of a kind does not.
    fn adds_a_premise(&mut self) -> bool {
        if self.takes_back() || self.at_formula() {
            return false;
        }
        let conditional = CONDITIONS.contains(&self.word())
            || self.word() == "at" && ARTICLES.contains(&self.word_at(1))
            || begins_with_time(self.tokens.get(self.at..).unwrap_or_default());
        let start = self.at;
        let mut from_start = |says: fn(&mut Self) -> bool| {
            let said = says(self);
            self.at = start;
            said
        };
        conditional
            || from_start(Self::begins_with_load)
            || from_start(Self::says_of_which_kind)
            || from_start(Self::says_what_things_do)
    }

    /// Whether it tells what a thing, a place or a load does, and of no way to write or to count: "The strings do not stretch
    /// …". What a thing is may take back what is assumed of all things of its kind.
    fn says_what_things_do(&mut self) -> bool {
        let (mut things, mut other) = (false, false);
        while !self.done() {
            other |= self.at_rule(false) || COPULAS.contains(&self.word());
            things |= self.at_name() || self.at_thing() || self.at_load();
            self.at += 1;
        }
        things && !other
    }

    fn at_thing(&self) -> bool {
        self.find(&[Class::Thing, Class::Place]).is_some()
    }

    fn at_load(&self) -> bool {
        let noun = self.find(&[Class::Noun]);
        noun.is_some_and(|noun| noun.entry.is_load())
    }

    /// "The lift …", "the force of the hoop …"
    fn begins_with_load(&mut self) -> bool {
        self.take_any(&ARTICLES) && self.at_load()
    }

    /// Whether it says what something does, or that it is one of the things and quantities that are known. Such a sentence adds
    /// to what is known; an adjective, and what a thing has, may take back what is assumed of all things of its kind.
    fn says_what_is_known(&mut self) -> bool {
        let start = self.at;
        let says = match self.skip_to_verb() {
            Some(true) => {
                self.at += 1;
                let article = self.take_any(&ARTICLES);
                self.skip_adjectives();
                let named = self.find(&[Class::Thing, Class::Place, Class::Noun]);
                let placed = self.find(&[Class::Passive, Class::Preposition]);
                article && named.is_some() || placed.is_some()
            }
            Some(false) => {
                let verb = self.find(&[Class::Verb]);
                verb.is_some_and(|verb| !OWNING.contains(&verb.entry.name))
            }
            None => false,
        };
        self.at = start;
        says
    }

    /// Goes to the first verb, and says whether it is "is" or "are".
    fn skip_to_verb(&mut self) -> Option<bool> {
        let verb = (self.at..self.tokens.len()).find(|&at| {
            self.at = at;
            COPULAS.contains(&self.word()) || self.find(&[Class::Verb]).is_some()
        });
        verb.map(|_| COPULAS.contains(&self.word()))
    }

    fn skip_adjectives(&mut self) {
        while let Some(adjective) = self.find(&[Class::Adjective]) {
            self.at += adjective.length;
        }
    }

    /// "… is a particle …", "… are two thin rods …", "… are the only loads …"
    fn says_of_which_kind(&mut self) -> bool {
        let copula = (self.at..self.tokens.len())
            .find(|&at| COPULAS.contains(&self.tokens[at].lower.as_str()));
        let Some(copula) = copula else {
            return false;
        };
        self.at = copula + 1;
        self.take_any(&ARTICLES);
        if self.take("only") && self.at_load() {
            return true;
        }
        self.skip_adjectives();
        let kind = self.find(&[Class::Thing, Class::Place]);
        kind.is_some_and(|kind| kind.entry.class == Class::Thing || kind.entry.name == "point")
    }

    /// Whether the name of a sign comes next.
    fn at_sign_with_article(&mut self) -> bool {
        self.take_any(&["a", "an", "the"]);
        let sign = self.find(&[Class::Mark, Class::Custom]);
        LABELS.contains(&self.word()) || sign.is_some_and(|sign| !self.speaks_of_body(sign.length))
    }

    /// All formulas of a sentence, and all signs; a sentence whose subject is a formula makes no convention of it.
    fn formulas_and_signs(&mut self, by_formula: bool) -> (Vec<Formula>, Signs) {
        let (mut formulas, mut signs) = (vec![], Signs::default());
        self.at = 0;
        while !self.done() {
            if self.at_formula() {
                formulas.extend(self.formulas());
                continue;
            }
            let sign = self.find(&[Class::Mark, Class::Custom]);
            match sign.filter(|sign| !self.speaks_of_body(sign.length)) {
                Some(sign) => {
                    signs.found.push(match sign.entry.class {
                        Class::Mark => Sign::Mark(sign.entry.name),
                        _ => Sign::Custom(sign.entry.name),
                    });
                    self.at += sign.length;
                }
                None if LABELS.contains(&self.word()) => {
                    self.at += 1;
                    match self.named_labels() {
                        Some(labels) => signs.found.push(labels),
                        None => signs.other_rule = true,
                    }
                }
                None => {
                    signs.other_rule |= self.at_rule(by_formula);
                    self.at += 1;
                }
            }
        }
        (formulas, signs)
    }

    /// The labels that follow the word for them, if some do.
    fn named_labels(&mut self) -> Option<Sign> {
        let hangs = self.find(&[Class::Preposition, Class::Verb]).is_some();
        match hangs || self.is_glue() {
            true => None,
            false => self.labels().ok(),
        }
    }
}
