//! Words around a formula that deny it, ask it or take it back: "it is not true that …", "is it …?", "… (false)".

use crate::grade::paper::withdrawn::{ANSWERED, ASKED, Claim, FORMULA};

/// What words make of a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Heard {
    Nothing,
    Denied,
    Asked,
    /// Words that deny stand near it, and it can't be told what they deny.
    Doubtful,
    /// It is asked, and then answered.
    Answered,
}

impl Heard {
    pub(super) fn into_claim(self) -> Claim {
        match self {
            Self::Nothing => Claim::Made,
            Self::Denied => Claim::Withdrawn("words beside it take it back"),
            Self::Asked => Claim::Withdrawn(ASKED),
            Self::Doubtful => Claim::Unclear("words beside it may take it back"),
            Self::Answered => Claim::Unclear(ANSWERED),
        }
    }
}

/// No more bytes of words are looked at before a formula, and behind it.
const REACH: usize = 400;

/// What denies all that follows in its clause.
const DENIALS: [&[&str]; 9] = [
    &["not", "true", "that"],
    &["isn't", "true", "that"],
    &["not", "the", "case", "that"],
    &["not", "correct", "that"],
    &["not", "right", "that"],
    &["false", "that"],
    &["untrue", "that"],
    &["wrong", "that"],
    &["incorrect", "that"],
];

/// What begins something else in a sentence.
const TURNS: [&str; 12] = [
    "but",
    "rather",
    "so",
    "then",
    "hence",
    "thus",
    "therefore",
    "since",
    "because",
    "as",
    "however",
    "instead",
];

const NEGATIONS: [&str; 16] = [
    "not", "never", "cannot", "can't", "don't", "doesn't", "didn't", "isn't", "aren't", "won't",
    "no", "nor", "neither", "without", "unlike", "hardly",
];

/// What may stand between a negation and the formula that it denies.
const BETWEEN: [&str; 24] = [
    "the", "a", "that", "simply", "just", "equal", "to", "be", "have", "get", "obtain", "find",
    "hold", "write", "say", "claim", "true", "right", "correct", "as", "of", "line", "equation",
    "law",
];

/// What a formula that is denied is not had, found or held by.
const HAD: [&str; 5] = ["have", "be", "get", "obtain", "hold"];

const FALSE: [&str; 6] = [
    "false",
    "wrong",
    "incorrect",
    "untrue",
    "mistaken",
    "nonsense",
];

/// What may lead into a sentence that takes something back.
const FILLERS: [&str; 15] = [
    "no",
    "but",
    "oh",
    "sorry",
    "oops",
    "hmm",
    "wait",
    "well",
    "actually",
    "however",
    "and",
    "clearly",
    "obviously",
    "which",
    "of",
];

const SUBJECTS: [&str; 8] = [
    "this", "that", "it", "these", "they", "which", "line", "equation",
];

/// What a question begins with that asks whether.
const WHETHER: [&str; 17] = [
    "is", "are", "was", "were", "does", "do", "did", "can", "could", "would", "should", "has",
    "have", "will", "isn't", "aren't", "doesn't",
];

const ANSWERS: [&str; 9] = [
    "yes",
    "yeah",
    "indeed",
    "right",
    "correct",
    "true",
    "exactly",
    "sure",
    "certainly",
];

/// What the words before a formula and behind it make of it.
pub(super) fn around(before: &str, behind: &str, display: bool) -> Heard {
    let (before, behind) = (last_of(before), first_of(behind));
    let sentence = &before[last_end(before)..];
    let (own, next) = parted(behind, display);
    if own.ends_with('?') {
        return asked(sentence, next);
    }
    match (ahead(sentence), self::behind(own)) {
        (Heard::Denied, _) | (_, Heard::Denied) => Heard::Denied,
        (Heard::Nothing, Heard::Nothing) => match taken_back(next) {
            Heard::Denied => Heard::Denied,
            _ => Heard::Nothing,
        },
        _ => Heard::Doubtful,
    }
}

/// What the rest of a sentence, or a remark, makes of the formula before it.
pub(super) fn behind(rest: &str) -> Heard {
    match taken_back(rest) {
        Heard::Nothing
            if words(rest)
                .iter()
                .any(|word| FALSE.contains(&word.as_str())) =>
        {
            Heard::Doubtful
        }
        heard => heard,
    }
}

/// What the words of a sentence make of the formula behind them.
fn ahead(sentence: &str) -> Heard {
    let words = words(sentence);
    let denied = DENIALS.iter().filter_map(|denial| {
        let at = words
            .windows(denial.len())
            .rposition(|own| own == *denial)?;
        Some(at + denial.len())
    });
    if let Some(end) = denied.max() {
        let rest = &words[end..];
        if rest.iter().any(|word| TURNS.contains(&word.as_str())) {
            return Heard::Nothing;
        }
        let other = |word: &String| matches!(word.as_str(), "and" | "or") || word.contains(FORMULA);
        return match rest.iter().any(other) {
            true => Heard::Doubtful,
            false => Heard::Denied,
        };
    }
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let clause = words
        .rsplit(|word| matches!(*word, "," | ";" | ":"))
        .find(|clause| !clause.is_empty())
        .unwrap_or_default();
    if let [.., "instead" | "rather" | "contrary" | "unlike", _] = clause {
        return Heard::Doubtful;
    }
    let Some(at) = clause.iter().rposition(|word| NEGATIONS.contains(word)) else {
        let near = clause.iter().rev().take(3);
        return match near.into_iter().any(|word| FALSE.contains(word)) {
            true => Heard::Doubtful,
            false => Heard::Nothing,
        };
    };
    match &clause[at + 1..] {
        [verb] if HAD.contains(verb) => Heard::Denied,
        between if between.iter().all(|word| BETWEEN.contains(word)) => Heard::Doubtful,
        _ => Heard::Nothing,
    }
}

/// Whether a sentence says of what stands before it that it is wrong: "(false)", "is not true", "No, that is wrong."
fn taken_back(sentence: &str) -> Heard {
    let all = words(sentence);
    let all: Vec<&str> = all.iter().map(String::as_str).collect();
    let clauses: Vec<&[&str]> = all
        .split(|word| matches!(*word, "," | ";" | ":"))
        .filter(|clause| !clause.is_empty())
        .collect();
    for clause in clauses.iter().take(2) {
        let start = clause.iter().take_while(|word| FILLERS.contains(word));
        let rest = &clause[start.count().min(clause.len())..];
        if rest.is_empty() && **clause != ["which"] && clause.contains(&"no") {
            return Heard::Denied;
        }
        let subject = rest.first().is_some_and(|word| SUBJECTS.contains(word));
        let rest = &rest[usize::from(subject)..];
        let verb = rest.first().is_some_and(|word| WHETHER.contains(word));
        let negated = ["isn't", "aren't", "doesn't", "cannot", "can't"];
        let said = match rest {
            [word] if FALSE.contains(word) => true,
            [_, .., word] if verb && FALSE.contains(word) && rest.len() < 6 => true,
            [_, "not", "true" | "right" | "correct" | "so" | "hold"] if verb => true,
            [no, "true" | "right" | "correct" | "so" | "hold" | "be"] => negated.contains(no),
            [no, "be", "true" | "right" | "correct"] => negated.contains(no),
            _ => false,
        };
        if said {
            return Heard::Denied;
        }
        if !start_only(clause) {
            break;
        }
    }
    Heard::Nothing
}

/// Whether a clause is but a lead into the next one.
fn start_only(clause: &[&str]) -> bool {
    clause.iter().all(|word| FILLERS.contains(word))
}

/// A question is not claimed, unless it presupposes its formula or is answered.
fn asked(sentence: &str, answer: &str) -> Heard {
    let words = words(sentence);
    let lead = ["so", "and", "but", "or", "then", "now", ",", "\u{fffc}"];
    let first = words.iter().find(|word| !lead.contains(&word.as_str()));
    if first.is_some_and(|word| !WHETHER.contains(&word.as_str())) {
        return Heard::Doubtful;
    }
    match is_yes(answer) {
        true => Heard::Answered,
        false => Heard::Asked,
    }
}

/// Whether a sentence begins as one that says yes.
pub(super) fn is_yes(answer: &str) -> bool {
    let words = words(answer);
    let mut words = words.iter().map(String::as_str).filter(|word| *word != ",");
    match (words.next(), words.next()) {
        (Some("it" | "this" | "that"), Some("is" | "does" | "holds")) => true,
        (first, _) => {
            first.is_some_and(|word| ANSWERS.contains(&word)) || answer.contains('\u{2713}')
        }
    }
}

/// The rest of the sentence behind a formula with the sign that ends it, and what stands behind that.
fn parted(behind: &str, display: bool) -> (&str, &str) {
    let anew = behind.trim_start().chars().next();
    if display && anew.is_some_and(char::is_uppercase) {
        return ("", next_sentence(behind));
    }
    let end = first_end(behind);
    (behind[..end].trim_end(), next_sentence(&behind[end..]))
}

fn next_sentence(text: &str) -> &str {
    &text[..first_end(text)]
}

/// Where the first sentence of a text ends, its sign taken in.
fn first_end(text: &str) -> usize {
    ends(text).next().unwrap_or(text.len())
}

/// Where the last sentence of a text begins.
fn last_end(text: &str) -> usize {
    ends(text).last().unwrap_or(0)
}

fn ends(text: &str) -> impl Iterator<Item = usize> {
    let signs = text.match_indices(['.', '!', '?']);
    let closes = move |(at, _): &(usize, &str)| {
        let behind = text[at + 1..].chars().next();
        let abbreviated = ["e.g", "i.e", "eq", "eqs", "cf", "fig", "resp"];
        let before = text[..*at].to_lowercase();
        let word = before.rsplit([' ', '\n', '(']).next().unwrap_or("");
        behind.is_none_or(|c| c.is_whitespace() || c == FORMULA || c == ')')
            && !abbreviated.contains(&word)
    };
    signs.filter(closes).map(|(at, sign)| at + sign.len())
}

fn last_of(text: &str) -> &str {
    let starts = text.len().saturating_sub(REACH)..=text.len();
    let start = starts.into_iter().find(|&at| text.is_char_boundary(at));
    &text[start.unwrap_or(text.len())..]
}

fn first_of(text: &str) -> &str {
    let ends = (0..=REACH.min(text.len())).rev();
    let end = ends.into_iter().find(|&at| text.is_char_boundary(at));
    &text[..end.unwrap_or(0)]
}

/// Words in small letters, and commas, semicolons, colons and formulas between them.
fn words(text: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    for c in text.chars().map(|c| if c == '\u{2019}' { '\'' } else { c }) {
        match c {
            c if c.is_alphanumeric() || c == '\'' => {
                if let Some(last) = words.last_mut() {
                    last.extend(c.to_lowercase());
                }
            }
            ';' | ':' | FORMULA => words.extend([c.to_string(), String::new()]),
            ',' | '(' | ')' | '\n' | '\u{2013}' | '\u{2014}' => {
                words.extend([",".to_owned(), String::new()]);
            }
            _ => words.push(String::new()),
        }
    }
    words.retain(|word| !word.is_empty());
    words
}
