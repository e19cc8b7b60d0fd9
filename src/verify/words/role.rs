//! What a line is for, from the sentence that introduces it.

use crate::verify::verdict::Role;
use crate::verify::words::book::{Book, has_any, lowered};
use crate::verify::words::role_words::{
    ASSUME, CLAIM, CONDITION, CONSTRAINT, DEFINE, DEFINITION, GIVEN, NO_ROLE, PREDICATES, SHORTER,
    SOURCES, SUBJECTS, SUPPOSE,
};
use std::collections::BTreeSet;
use std::sync::LazyLock;

/// What a phrase does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Assume,
    Suppose,
    Claim,
    Define,
    Definition,
    Given,
    Condition,
    Constraint,
    Longer,
    NoRole,
}

/// The phrases of each kind, and those that mean what a shorter one does.
const PHRASES: [(Kind, &[&str]); 9] = [
    (Kind::Assume, ASSUME),
    (Kind::Suppose, SUPPOSE),
    (Kind::Claim, CLAIM),
    (Kind::Define, DEFINE),
    (Kind::Definition, DEFINITION),
    (Kind::Given, GIVEN),
    (Kind::Condition, CONDITION),
    (Kind::Constraint, CONSTRAINT),
    (Kind::NoRole, NO_ROLE),
];

fn phrases() -> impl Iterator<Item = (Kind, &'static str)> {
    let each = PHRASES.into_iter();
    let each = each.flat_map(|(kind, phrases)| phrases.iter().map(move |phrase| (kind, *phrase)));
    each.chain(SHORTER.iter().map(|(phrase, _)| (Kind::Longer, *phrase)))
}

static LISTED: LazyLock<Vec<(Kind, &str)>> = LazyLock::new(|| phrases().collect());
static BOOK: LazyLock<Book> = LazyLock::new(|| Book::of_words(phrases().map(|(_, phrase)| phrase)));

/// "With ⟨ω = Ω⟩ the spin is": the condition has ended, for what stands there and for further formulas behind it.
fn has_left_its_condition(text: &str) -> bool {
    let ends = PREDICATES.map(|verb| text.rfind(verb).map(|at| at + verb.len()));
    let Some(end) = ends.into_iter().flatten().max() else {
        return false;
    };
    let behind = format!(" {}", &text[end..]);
    let plain = |behind| {
        let words = Words::new(behind);
        let roles = [Kind::Assume, Kind::Suppose, Kind::Define];
        !roles.into_iter().any(|kind| words.has(kind))
    };
    let formulas = behind.trim().is_empty() || behind.contains('⟩') && plain(behind);
    formulas && leaves_its_condition(&text[..end])
}

fn leaves_its_condition(text: &str) -> bool {
    let Some((_, trailing)) = text.rsplit_once('⟩') else {
        return false;
    };
    let weak = [" with ", " for ", " if ", " when "];
    let says_again = [" that is ", " which is "];
    PREDICATES.iter().any(|verb| trailing.ends_with(verb))
        && !says_again.iter().any(|words| trailing.ends_with(words))
        && has_any(text, &weak)
        && !Words::new(trailing.to_owned()).has(Kind::Suppose)
}

/// Whether a text before a comma ends with a condition: "with ⟨B = 2A⟩", "with ⟨B = 2A⟩ and all else the same".
pub(crate) fn ends_with_condition(text: &str) -> bool {
    let text = format!(" {}", text.trim_end());
    let last = [" with ", " With ", " for ", " For "]
        .iter()
        .filter_map(|word| text.rfind(word))
        .max();
    text.ends_with('⟩')
        || last.is_some_and(|at| text[at..].contains("⟨⟩") && !text[at..].contains(','))
}

/// A sentence in lower case, each of its words between single spaces.
#[derive(Debug)]
pub(crate) struct Words {
    text: String,
    /// Where the last phrase of each kind begins.
    last: [Option<usize>; Kind::NoRole as usize + 1],
}

impl Words {
    /// The words of a sentence; stops within it are spaces.
    pub(crate) fn of(sentence: &str) -> Self {
        Self::new(in_words(sentence))
    }

    fn new(text: String) -> Self {
        let mut last = [None; Kind::NoRole as usize + 1];
        for (which, at, _) in BOOK.places(&text) {
            let known = &mut last[LISTED[which].0 as usize];
            *known = (*known).max(Some(at));
        }
        Self { text, last }
    }

    fn last(&self, kind: Kind) -> Option<usize> {
        self.last[kind as usize]
    }

    fn has(&self, kind: Kind) -> bool {
        self.last(kind).is_some()
    }

    /// The role that they, the words of a sentence, give to a formula that stands behind it.
    ///
    /// Words reach to the end of their sentence, or to a word such as *then* or *gives*; the last role word that is in
    /// force decides.
    pub(crate) fn role(self, sentence: &str) -> Role {
        match main_clauses(sentence) {
            Some(clauses) => Self::of(&clauses).role_of_clauses(),
            None => self.role_of_clauses(),
        }
    }

    fn role_of_clauses(self) -> Role {
        let mut words = self.without_attributes();
        if words.has(Kind::Longer) {
            let mut text = words.text;
            for (phrase, word) in SHORTER {
                text = text.replace(&format!(" {phrase} "), &format!(" {word} "));
            }
            words = Self::new(text);
        }
        // The formula may follow "called the precession rate": a definition, though "called the" alone is none.
        let definition = words.last(Kind::Definition);
        if words.has(Kind::NoRole) {
            let met: BTreeSet<usize> = BOOK.places(&words.text).map(|(which, ..)| which).collect();
            let mut text = words.text;
            for (kind, phrase) in met.into_iter().map(|which| LISTED[which]) {
                if kind == Kind::NoRole {
                    let nothing = "_".repeat(phrase.len());
                    text = text.replace(&format!(" {phrase} "), &format!(" {nothing} "));
                }
            }
            words = Self::new(text);
        }
        if has_left_its_condition(&words.text) {
            return Role::Claim;
        }
        let assumed = words.last(Kind::Assume).max(words.last(Kind::Suppose));
        let best = [
            (assumed, Role::Assume),
            (words.last(Kind::Define).max(definition), Role::Define),
            (words.last(Kind::Given), Role::Given),
        ];
        let (place, role) = best
            .into_iter()
            .fold((None, Role::Claim), |kept, (place, role)| {
                if place > kept.0 { (place, role) } else { kept }
            });
        if place.is_none() || words.last(Kind::Claim) > place {
            Role::Claim
        } else {
            role
        }
    }

    /// "For a given ⟨L⟩ the energy is": there it is an attribute, and hands nothing over.
    fn without_attributes(self) -> Self {
        if !self.text.contains(" given ") {
            return self;
        }
        let words: Vec<&str> = self.text.split_whitespace().collect();
        let attribute = |pair: &[&str]| {
            pair[1] == "given" && ["a", "any", "each", "for", "at", "of"].contains(&pair[0])
        };
        // The last word hands over what stands behind it.
        let inner = &words[..words.len().saturating_sub(1)];
        if !inner.windows(2).any(attribute) {
            return self;
        }
        let mut kept = words.clone();
        for (at, pair) in inner.windows(2).enumerate() {
            if attribute(pair) {
                kept[at + 1] = "_";
            }
        }
        Self::new(format!(" {} ", kept.join(" ")))
    }

    /// Whether a role hangs on one of them; else what follows is claimed, and neither derived nor assumed.
    pub(crate) fn speak(&self) -> bool {
        let (no_role, others) = (Kind::NoRole as usize, &self.last);
        others[..no_role].iter().any(Option::is_some)
    }

    /// Whether they derive what follows: "hence", "gives".
    pub(crate) fn derive(&self) -> bool {
        self.has(Kind::Claim)
    }

    /// Whether the last of them work the formula out: "from (3) we get ⟨…⟩".
    pub(crate) fn obtain(&self) -> bool {
        let ends = [
            "we get ",
            "we obtain ",
            "we find ",
            "it follows that ",
            "yields ",
        ];
        ends.iter().any(|words| self.text.ends_with(words))
    }

    /// Whether they expand equations in what is small, and nothing stands between: "to first order ⟨…⟩".
    pub(crate) fn expand(&self) -> bool {
        ["to first order ", "to the first order "]
            .iter()
            .any(|words| self.text.ends_with(words))
    }

    /// Whether they assume what follows in so many words.
    pub(crate) fn assume(&self) -> bool {
        let last = self.last(Kind::Suppose).max(self.last(Kind::Given));
        last.is_some_and(|at| !self.text[at..].contains('⟩'))
    }

    /// Whether the last of them picks out a case: "we take ⟨…⟩".
    pub(crate) fn pick(&self) -> bool {
        let verbs = ["take", "choose", "pick", "require", "prescribe", "set"];
        let last = self.text.split_whitespace().next_back();
        let belongs = ["belong to ", "belongs to "]
            .iter()
            .any(|words| self.text.ends_with(words));
        belongs || last.is_some_and(|word| verbs.contains(&word))
    }

    /// Whether what follows is a condition for something that was said: "it is stable if".
    pub(crate) fn condition(&self) -> bool {
        let last = self.last(Kind::Condition);
        last.is_some_and(|at| at > 0 && self.text[at..].split_whitespace().count() <= 3)
    }

    /// Whether they name a constraint that a body or a point of it is under.
    pub(crate) fn constrain(&self) -> bool {
        self.has(Kind::Constraint)
    }
}

/// A sentence in lower case, each word of it between single spaces.
fn in_words(sentence: &str) -> String {
    let kept = |c: char| c.is_alphanumeric() || matches!(c, '\'' | '-' | '⟨' | '⟩');
    let lower = lowered(sentence);
    let words = lower.split(|c| !kept(c)).filter(|word| !word.is_empty());
    let mut text = String::with_capacity(lower.len() + 2);
    text.push(' ');
    words.for_each(|word| text.extend([word, " "]));
    // By itself it says what "set" does; behind more, what is put into a formula.
    if matches!(
        text.as_str(),
        " put " | " we put " | " now put " | " we now put "
    ) {
        return text.replace("put", "set");
    }
    if !text.contains(" give") && !text.contains(" gave ") {
        return text;
    }
    // What gives a torque derives nothing.
    for load in ["torque", "moment", "couple", "force"] {
        for (gives, acts) in [("gives", "exerts"), ("give", "exert")] {
            for article in ["a", "no", "the"] {
                for kind in [
                    "",
                    "constant ",
                    "steady ",
                    "small ",
                    "control ",
                    "external ",
                ] {
                    let thing = format!("{article} {kind}{load} ");
                    text = text.replace(&format!(" {gives} {thing}"), &format!(" {acts} {thing}"));
                }
            }
        }
    }
    for source in SOURCES {
        for gives in ["gives", "give", "gave"] {
            text = text.replace(&format!(" {source} {gives} "), &format!(" {source} given "));
        }
    }
    text
}

/// A comma after a formula, and a subject behind it, open the main clause: "where ⟨n⟩ is constant, the equation is".
/// `None` where none does.
fn main_clauses(sentence: &str) -> Option<String> {
    let formula = sentence.find('⟩')?;
    let (mut text, mut from) = (String::new(), 0);
    for (at, _) in sentence.match_indices(", ").filter(|&(at, _)| at > formula) {
        let (inside, behind) = sentence.split_at(at);
        let word = behind[2..].split_once(' ').map(|(word, _)| word);
        let opens = word.is_some_and(|word| {
            SUBJECTS.contains(&word) && !(word == "the" && goes_on_a_list(inside, behind))
        });
        if opens {
            text.push_str(&sentence[from..=at]);
            text.push_str(" then");
            from = at + 1;
        }
    }
    text.push_str(&sentence[from..]);
    (from > 0).then_some(text)
}

/// Whether what stands behind a comma is one more thing of a list: "take ⟨m = 2⟩, the rate ⟨⟩ and the arm".
fn goes_on_a_list(before: &str, behind: &str) -> bool {
    let clause = before.rsplit(". ").next().unwrap_or_default();
    let first = clause
        .split_whitespace()
        .find(|word| *word != "we")
        .unwrap_or_default();
    let asks = [
        "take", "let", "given", "assume", "suppose", "consider", "choose", "set",
    ];
    let noun = |piece: &str| {
        let words = piece.rsplit('⟨').next().unwrap_or_default();
        let words: Vec<&str> = words.split(|c: char| !c.is_alphanumeric()).collect();
        words.iter().filter(|word| !word.is_empty()).count() <= 5
            && !words.iter().any(|word| VERBS.contains(word))
    };
    asks.contains(&first.to_lowercase().as_str()) && behind.split('⟩').all(noun)
}

/// Words that make a main clause of what they stand in.
const VERBS: &[&str] = &[
    "is",
    "are",
    "becomes",
    "become",
    "reads",
    "read",
    "has",
    "have",
    "gives",
    "give",
    "must",
    "can",
    "will",
    "follows",
    "follow",
    "reduces",
    "simplifies",
    "equals",
    "turns",
    "takes",
    "then",
    "so",
    "hence",
    "comes",
    "come",
    "shows",
    "yields",
    "vanishes",
    "vanish",
];
