//! What a line is for, from the sentence that introduces it.

use crate::verify::verdict::Role;
use crate::verify::words::role_words::{
    ASSUME, CLAIM, DEFINE, GIVEN, NO_ROLE, SHORTER, SOURCES, SUPPOSE,
};

/// The role that a sentence gives to a formula that stands behind it.
///
/// Words reach to the end of their sentence, or to a word such as *then* or *gives*; the last role word that is in
/// force decides.
pub(crate) fn role(sentence: &str) -> Role {
    let mut text = Words::of(&main_clauses(sentence)).0;
    for (phrase, word) in SHORTER {
        text = text.replace(&format!(" {phrase} "), &format!(" {word} "));
    }
    // The formula may follow "called the precession rate": a definition, though "called the" alone is none.
    let definition = last_of(
        &text,
        &[
            "define",
            "defined",
            "denote",
            "denoted by",
            "we call",
            "we denote",
        ],
    );
    for phrase in NO_ROLE {
        if last_of(&text, &[phrase]).is_some() {
            text = text.replace(
                &format!(" {phrase} "),
                &format!(" {} ", "_".repeat(phrase.len())),
            );
        }
    }
    if has_left_its_condition(&text) {
        return Role::Claim;
    }
    let claim = last_of(&text, CLAIM);
    let best = [
        (
            last_of(&text, ASSUME).max(last_of(&text, SUPPOSE)),
            Role::Assume,
        ),
        (last_of(&text, DEFINE).max(definition), Role::Define),
        (last_of(&text, GIVEN), Role::Given),
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

/// "With ⟨ω = Ω⟩ the spin is": the condition has ended.
fn has_left_its_condition(text: &str) -> bool {
    let Some((_, trailing)) = text.rsplit_once('⟩') else {
        return false;
    };
    let predicate = [" is ", " are "];
    let weak = [" with ", " for ", " if ", " when "];
    let says_again = [" that is ", " which is "];
    predicate.iter().any(|verb| trailing.ends_with(verb))
        && !says_again.iter().any(|words| trailing.ends_with(words))
        && weak.iter().any(|word| text.contains(word))
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
        let lower = sentence.to_lowercase();
        let words = lower.split(|c| !kept(c)).filter(|word| !word.is_empty());
        let mut text = " ".to_owned();
        words.for_each(|word| text.extend([word, " "]));
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

    /// Whether they derive what follows: "hence", "gives".
    pub(crate) fn derive(&self) -> bool {
        last_of(&self.0, CLAIM).is_some()
    }

    /// Whether they assume what follows in so many words.
    pub(crate) fn assume(&self) -> bool {
        let last = last_of(&self.0, SUPPOSE).max(last_of(&self.0, GIVEN));
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
        let last = last_of(&self.0, &["if", "when", "provided", "whenever"]);
        last.is_some_and(|at| at > 0 && self.0[at..].split_whitespace().count() <= 3)
    }

    /// Whether they name a constraint that a body or a point of it is under.
    pub(crate) fn constrain(&self) -> bool {
        let words = [
            "slip",
            "slips",
            "slipping",
            "rolls",
            "fixed",
            "at rest",
            "pinned",
            "hinged",
            "constrained",
            "stationary",
        ];
        last_of(&self.0, &words).is_some()
    }
}

/// A comma after a formula, and a subject behind it, open the main clause: "where ⟨n⟩ is constant, the equation is".
fn main_clauses(sentence: &str) -> String {
    let mut text = sentence.to_owned();
    for subject in [
        "the", "this", "these", "it", "its", "we", "one", "both", "only", "each", "all", "they",
    ] {
        let opening = format!(", {subject} ");
        let mut from = 0;
        while let Some(at) = text[from..].find(&opening).map(|i| from + i) {
            let inside = &text[..at];
            let formula = inside.rfind('⟩').is_some();
            if formula && !(subject == "the" && goes_on_a_list(inside, &text[at..])) {
                text.insert_str(at + 1, " then");
            }
            from = at + opening.len();
        }
    }
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

/// Where the last of some phrases begins, with the space before it.
fn last_of(text: &str, phrases: &[&str]) -> Option<usize> {
    let spaces = text.bytes().enumerate().rev().filter(|(_, b)| *b == b' ');
    let stands = |rest: &str, phrase: &str| {
        rest.strip_prefix(phrase)
            .is_some_and(|behind| behind.starts_with(' '))
    };
    spaces
        .map(|(at, _)| at)
        .find(|&at| phrases.iter().any(|p| stands(&text[at + 1..], p)))
}

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
        ];
        for (sentence, expected) in cases {
            assert_eq!(role(sentence), expected, "{sentence}");
        }
    }
}
