//! What a line is for, from the sentence that introduces it.

use crate::verify::verdict::Role;
use crate::verify::words::book::{Book, has_any, lowered};
use crate::verify::words::role_words::{
    ASSUME, CLAIM, CONDITION, CONSTRAINT, DEFINE, DEFINITION, GIVEN, NO_ROLE, SHORTER, SOURCES,
    SUBJECTS, SUPPOSE,
};
use std::sync::LazyLock;

static ASSUMING: LazyLock<Book> = LazyLock::new(|| words(&[ASSUME, SUPPOSE]));
static CLAIMING: LazyLock<Book> = LazyLock::new(|| words(&[CLAIM]));
static DEFINING: LazyLock<Book> = LazyLock::new(|| words(&[DEFINE]));
static DEFINED: LazyLock<Book> = LazyLock::new(|| words(&[DEFINITION]));
static GIVING: LazyLock<Book> = LazyLock::new(|| words(&[GIVEN]));
static SUPPOSING: LazyLock<Book> = LazyLock::new(|| words(&[SUPPOSE, GIVEN]));
static CONDITIONS: LazyLock<Book> = LazyLock::new(|| words(&[CONDITION]));
static CONSTRAINTS: LazyLock<Book> = LazyLock::new(|| words(&[CONSTRAINT]));
static WITHOUT_ROLE: LazyLock<Book> = LazyLock::new(|| words(&[NO_ROLE]));
static LONGER: LazyLock<Book> =
    LazyLock::new(|| Book::of_words(SHORTER.iter().map(|(phrase, _)| *phrase)));

/// Any word that a role, or what else [`Words`] says, hangs on.
static SPEAKING: LazyLock<Book> = LazyLock::new(|| {
    let lists = [
        ASSUME, SUPPOSE, CLAIM, DEFINE, DEFINITION, GIVEN, CONDITION, CONSTRAINT,
    ];
    let shorter = SHORTER.iter().map(|(phrase, _)| *phrase);
    Book::of_words(lists.into_iter().flatten().copied().chain(shorter))
});

fn words(lists: &[&[&'static str]]) -> Book {
    Book::of_words(lists.iter().copied().flatten().copied())
}

/// The role that a sentence gives to a formula that stands behind it.
///
/// Words reach to the end of their sentence, or to a word such as *then* or *gives*; the last role word that is in
/// force decides.
pub(crate) fn role(sentence: &str) -> Role {
    let mut text = Words::of(&main_clauses(sentence)).0;
    if LONGER.is_in(&text) {
        for (phrase, word) in SHORTER {
            text = text.replace(&format!(" {phrase} "), &format!(" {word} "));
        }
    }
    // The formula may follow "called the precession rate": a definition, though "called the" alone is none.
    let definition = DEFINED.last(&text);
    for phrase in WITHOUT_ROLE.found(&text).into_iter().map(|at| NO_ROLE[at]) {
        text = text.replace(
            &format!(" {phrase} "),
            &format!(" {} ", "_".repeat(phrase.len())),
        );
    }
    if has_left_its_condition(&text) {
        return Role::Claim;
    }
    let claim = CLAIMING.last(&text);
    let best = [
        (ASSUMING.last(&text), Role::Assume),
        (DEFINING.last(&text).max(definition), Role::Define),
        (GIVING.last(&text), Role::Given),
    ];
    let (place, role) = best
        .into_iter()
        .fold((None, Role::Claim), |kept, (place, role)| {
            if place > kept.0 { (place, role) } else { kept }
        });
    if place.is_none() || claim > place {
        Role::Claim
    } else {
        role
    }
}

/// "With ⟨ω = Ω⟩ the spin is": the condition has ended, for what stands there and for further formulas behind it.
fn has_left_its_condition(text: &str) -> bool {
    let ends = [" is ", " are "].map(|verb| text.rfind(verb).map(|at| at + verb.len()));
    let Some(end) = ends.into_iter().flatten().max() else {
        return false;
    };
    let behind = format!(" {}", &text[end..]);
    let formulas = behind.trim().is_empty()
        || behind.contains('⟩') && !ASSUMING.is_in(&behind) && !DEFINING.is_in(&behind);
    formulas && leaves_its_condition(&text[..end])
}

fn leaves_its_condition(text: &str) -> bool {
    let Some((_, trailing)) = text.rsplit_once('⟩') else {
        return false;
    };
    let predicate = [" is ", " are "];
    let weak = [" with ", " for ", " if ", " when "];
    let says_again = [" that is ", " which is "];
    predicate.iter().any(|verb| trailing.ends_with(verb))
        && !says_again.iter().any(|words| trailing.ends_with(words))
        && has_any(text, &weak)
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
pub(crate) struct Words(String);

impl Words {
    /// The words of a sentence; stops within it are spaces.
    pub(crate) fn of(sentence: &str) -> Self {
        let kept = |c: char| c.is_alphanumeric() || matches!(c, '\'' | '-' | '⟨' | '⟩');
        let lower = lowered(sentence);
        let words = lower.split(|c| !kept(c)).filter(|word| !word.is_empty());
        let mut text = " ".to_owned();
        words.for_each(|word| text.extend([word, " "]));
        if !text.contains(" give") && !text.contains(" gave ") {
            return Self(text);
        }
        // What gives a torque derives nothing.
        for load in ["torque", "moment", "couple", "force"] {
            for (gives, acts) in [("gives", "exerts"), ("give", "exert")] {
                for article in ["a", "no", "the"] {
                    let said = format!(" {gives} {article} {load} ");
                    text = text.replace(&said, &format!(" {acts} {article} {load} "));
                }
            }
        }
        for source in SOURCES {
            for gives in ["gives", "give", "gave"] {
                text = text.replace(&format!(" {source} {gives} "), &format!(" {source} given "));
            }
        }
        Self(text)
    }

    /// Whether a role hangs on one of them; else what follows is claimed, and neither derived nor assumed.
    pub(crate) fn speak(&self) -> bool {
        SPEAKING.is_in(&self.0)
    }

    /// Whether they derive what follows: "hence", "gives".
    pub(crate) fn derive(&self) -> bool {
        CLAIMING.is_in(&self.0)
    }

    /// Whether they assume what follows in so many words.
    pub(crate) fn assume(&self) -> bool {
        let last = SUPPOSING.last(&self.0);
        last.is_some_and(|at| !self.0[at..].contains('⟩'))
    }

    /// Whether the last of them picks out a case: "we take ⟨…⟩".
    pub(crate) fn pick(&self) -> bool {
        let verbs = ["take", "choose", "pick", "require", "prescribe", "set"];
        let last = self.0.split_whitespace().next_back();
        let belongs = ["belong to ", "belongs to "]
            .iter()
            .any(|words| self.0.ends_with(words));
        belongs || last.is_some_and(|word| verbs.contains(&word))
    }

    /// Whether what follows is a condition for something that was said: "it is stable if".
    pub(crate) fn condition(&self) -> bool {
        let last = CONDITIONS.last(&self.0);
        last.is_some_and(|at| at > 0 && self.0[at..].split_whitespace().count() <= 3)
    }

    /// Whether they name a constraint that a body or a point of it is under.
    pub(crate) fn constrain(&self) -> bool {
        CONSTRAINTS.is_in(&self.0)
    }
}

/// A comma after a formula, and a subject behind it, open the main clause: "where ⟨n⟩ is constant, the equation is".
fn main_clauses(sentence: &str) -> String {
    let Some(formula) = sentence.find('⟩') else {
        return sentence.to_owned();
    };
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
    text
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sentence_sets_the_role() {
        let cases = [
            (
                "Now choose the principal axes of inertia, that is, assume",
                Role::Assume,
            ),
            ("Let us expand", Role::Claim),
            ("let us say this is", Role::Claim),
            ("Let a vector be resolved on the moving axes:", Role::Assume),
            ("Assume I_xy = 0, then the equation becomes", Role::Claim),
            ("Define the body precession rate", Role::Define),
            ("They are defined by", Role::Define),
            ("The kinetic energy is", Role::Claim),
            ("The plane is a plane of symmetry, so assume", Role::Assume),
            ("Choose the time origin such that", Role::Assume),
            ("With zero torque the equations of motion are", Role::Claim),
            ("Its derivative is given by", Role::Claim),
            ("Combinations with two moments left out", Role::Claim),
            ("For ⟨c = 0⟩ the second line must fall back to", Role::Claim),
            ("For ⟨s > 0⟩ we may also write", Role::Claim),
            ("Solved for the acceleration,", Role::Claim),
            ("If the spin is kept at constant ⟨s⟩, that is", Role::Assume),
            ("With ⟨s = 0⟩ the rate of the spin is", Role::Claim),
            ("The rule for ⟨s⟩ is s ⟨⟩ t ⟨⟩. u ⟨⟩", Role::Claim),
            ("For ⟨s⟩ the rate is ⟨⟩. Now assume", Role::Assume),
        ];
        for (sentence, expected) in cases {
            assert_eq!(role(sentence), expected, "{sentence}");
        }
    }
}
