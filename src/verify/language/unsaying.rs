//! Words by which a sentence may take back what is assumed of all things of a kind, or may tell how formulas are read.

use super::reader::Reader;
use super::words::Kind;

/// Words that take something back.
pub(super) const DENYING: [&str; 6] = ["not", "no", "never", "except", "unless", "without"];

/// Words of what is not as bodies, frames and angles are by default.
pub(super) const RETRACTING: [&str; 53] = [
    "left-handed",
    "handed",
    "elastic",
    "flexible",
    "deformable",
    "deforms",
    "fluid",
    "liquid",
    "hole",
    "hollow",
    "cut",
    "removed",
    "half",
    "quarter",
    "part",
    "oblique",
    "clockwise",
    "means",
    "mean",
    "denotes",
    "stands",
    "changes",
    "varies",
    "grows",
    "loses",
    "triad",
    "inverted",
    "left",
    "left-hand",
    "hand",
    "usual",
    "opposite",
    "backward",
    "backwards",
    "reversed",
    "burns",
    "leaks",
    "ejects",
    "gathers",
    "drops",
    "sheds",
    "consumes",
    "expels",
    "absorbs",
    "melts",
    "wears",
    "falls",
    "bends",
    "stretches",
    "rain",
    "sand",
    "fuel",
    "snow",
];

/// What stands before "not" where a verb follows.
const AUXILIARIES: [&str; 4] = ["do", "does", "can", "may"];

/// Words of how something is counted or written.
const RULING: [&str; 21] = [
    "sign",
    "signs",
    "sense",
    "angle",
    "angles",
    "unit",
    "units",
    "counted",
    "measured",
    "letter",
    "letters",
    "bold",
    "written",
    "negative",
    "positive",
    "degrees",
    "radians",
    "notation",
    "components",
    "direction",
    "read",
];

/// Words of how formulas are to be read.
const OF_READING: [&str; 12] = [
    "sign", "signs", "counted", "measured", "letter", "letters", "label", "labels", "bold",
    "written", "notation", "read",
];

impl Reader<'_> {
    /// Whether a word may take back what is assumed of all things of a kind, or may be of a rule.
    pub(super) fn takes_back(&self) -> bool {
        self.denies_or(retracts)
    }

    /// Whether a word may take back what is assumed of all things of a kind, or tells how formulas are read.
    pub(super) fn unsays(&self) -> bool {
        self.denies_or(|word| RETRACTING.contains(&word) || OF_READING.contains(&word))
    }

    fn denies_or(&self, retracts: fn(&str) -> bool) -> bool {
        let tokens = self.tokens.get(self.at..).unwrap_or_default();
        let word = |at: usize| tokens.get(at).map_or("", |t| t.lower.as_str());
        // That something does not act, or that nothing does, adds to what is known.
        let denies = |at: usize| match word(at) {
            "not" => at == 0 || !AUXILIARIES.contains(&word(at - 1)),
            "no" => word(at + 1) == "longer",
            "without" => false,
            denying => DENYING.contains(&denying),
        };
        // "while `$u$` is positive"
        let condition = |at: usize| at > 1 && tokens[at - 2].kind == Kind::Formula;
        (0..tokens.len()).any(|at| denies(at) || retracts(word(at)) && !condition(at))
    }
}

/// Whether a word may take back what is assumed of things, or may tell how something is counted or written.
pub(super) fn retracts(word: &str) -> bool {
    RETRACTING.contains(&word) || RULING.contains(&word)
}

/// Whether a word may be of a rule for other lines than those of which a sentence speaks.
pub(super) fn may_be_rule(word: &str) -> bool {
    let says = ["that", "means", "mean", "says", "say", "where", "whose"];
    RULING.contains(&word) || OF_READING.contains(&word) || says.contains(&word)
}
