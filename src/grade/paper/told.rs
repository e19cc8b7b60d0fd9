//! What a student says of letters and marks in the text: "The dot means the rate seen from B", "The angular momentum is
//! $H = I\omega$".
//!
//! It holds for this student in place of what the sheet says, as an answer of staff would. What is not understood goes to a
//! person.

use crate::grade::key::{Key, QUANTITIES, sheet};
use crate::notation;
use crate::notation::ast::Kind;
use crate::notation::document::{Document, Format, Formula, Item, Row, line_name};
use crate::verify;
use crate::verify::language::statement::{Declaration, NounPhrase, Statement, Term};

/// What a student tells of meanings.
#[derive(Default)]
pub(super) struct Told {
    /// In the declared language.
    pub(super) sentences: Vec<String>,
    /// Sentences that are about meanings for sure and were not understood: a person should look.
    pub(super) unheard: Vec<String>,
    /// Sentences that may be about meanings: of consequence where marks are missing.
    pub(super) doubts: Vec<String>,
}

/// No more sentences are tried.
const MOST: usize = 40;

/// A longer sentence says more than what a letter is.
const LONGEST: usize = 240;

/// What begins a sentence and says nothing in it.
const LEADS: [&str; 12] = [
    "where",
    "here",
    "note that",
    "and",
    "now",
    "throughout",
    "also",
    "with",
    "recall that",
    "we use that",
    "in this solution",
    "below",
];

/// What begins a sentence that holds from its place on.
const FROM_HERE: [&str; 5] = [
    "in what follows",
    "from here on",
    "from now on",
    "henceforth",
    "in the following",
];

/// What a sentence about meanings has in it.
const TELLING: [&str; 12] = [
    " means ",
    " mean ",
    " denotes ",
    " denote ",
    " stands for ",
    " stand for ",
    " is the ",
    " are the ",
    " has components ",
    " have components ",
    " be the ",
    " is also written ",
];

/// Marks on letters.
const MARKS: [&str; 8] = [
    "dot", "prime", "tilde", "hat", "bar", "overdot", "star", "label",
];

/// Words between the name of a quantity and its formula.
const VERBS: [&str; 12] = [
    "is",
    "are",
    "reads",
    "becomes",
    "equals",
    "be",
    "given",
    "by",
    "then",
    "therefore",
    "thus",
    "now",
];

/// Quantities that the system determines where words say of what they are.
const DETERMINED: [&str; 2] = ["kinetic energy", "angular momentum"];

/// What the text of a document tells.
pub(super) fn told(key: &Key, document: &Document, several: bool) -> Told {
    let mut found = Told::default();
    let mut tried = 0;
    for spoken in spoken(key, document) {
        if tried >= MOST {
            let line = line_name(spoken.cell, spoken.line);
            found.doubts.push(format!(
                "from {line} on what it tells of letters was not looked at"
            ));
            break;
        }
        let heard = match &spoken.names {
            Some(letter) => named(key, &spoken.text, letter),
            None => sentence(key, &spoken, several),
        };
        let named = spoken
            .names
            .as_ref()
            .is_some_and(|letter| !letter.is_empty());
        tried += usize::from(named || tells(&spoken.text));
        let line = line_name(spoken.cell, spoken.line);
        let quoted = spoken.text.trim();
        match heard {
            Heard::Nothing => {}
            Heard::Sentence(said) => found.sentences.push(said),
            Heard::Unheard => found.unheard.push(format!(
                "{line} says what something means, and it is not understood: \"{quoted}\""
            )),
            Heard::Doubt => found.doubts.push(format!(
                "{line} may say that something means another thing than on the sheet: \"{quoted}\""
            )),
        }
    }
    found
}

/// What became of a sentence.
#[derive(PartialEq, Eq)]
enum Heard {
    Nothing,
    Sentence(String),
    Unheard,
    Doubt,
}

/// A sentence, or the beginning of one that a display ends.
struct Spoken {
    text: String,
    cell: Option<usize>,
    line: usize,
    /// The left side of this display, if it is a letter.
    names: Option<String>,
}

fn spoken(key: &Key, document: &Document) -> Vec<Spoken> {
    let mut found: Vec<Spoken> = vec![];
    let (mut text, mut start) = (String::new(), None);
    let mut end = |text: &mut String, start: &mut Option<u32>, names: Option<String>| {
        let place = document.place(start.take().unwrap_or(0));
        let text = std::mem::take(text);
        if !text.trim().is_empty() && text.len() <= LONGEST {
            found.push(Spoken {
                text,
                cell: place.cell,
                line: place.line,
                names,
            });
        }
    };
    for item in &document.items {
        match item {
            Item::Prose { text: words, span } => {
                let mut at = span.start;
                for part in words.split_inclusive(['.', '!', '?', ';']) {
                    start = start.or((!part.trim().is_empty()).then_some(at));
                    text.push_str(part);
                    at = (at + u32::try_from(part.len()).unwrap_or(0)).min(span.end);
                    if part.ends_with(['.', '!', '?', ';']) {
                        end(&mut text, &mut start, None);
                    }
                }
            }
            Item::Formula(formula) if formula.display => {
                let names = letter_of(key, document, formula);
                end(&mut text, &mut start, names.or(Some(String::new())));
            }
            Item::Formula(formula) => {
                start = start.or(Some(formula.span.start));
                text.push_str(&quoted(document, formula));
            }
            Item::Break | Item::Heading { .. } => end(&mut text, &mut start, None),
            Item::Comment { .. } => {}
        }
    }
    end(&mut text, &mut start, None);
    found
}

/// A formula in running text, as sentences of the language hold it.
fn quoted(document: &Document, formula: &Formula) -> String {
    let written = document.source.slice(formula.span);
    if document.format == Format::Text {
        return format!("`{written}`");
    }
    let inside = written
        .trim_start_matches('$')
        .trim_end_matches('$')
        .trim_start_matches("\\(")
        .trim_end_matches("\\)");
    format!("${}$", inside.trim())
}

/// The letter that a display says something of.
fn letter_of(key: &Key, document: &Document, formula: &Formula) -> Option<String> {
    let Some(Row::Line(line)) = formula.rows.first() else {
        return None;
    };
    let first = line.sides.first().filter(|_| !line.continues)?;
    // Of a letter of the sheet it tells nothing new.
    let letter = matches!(first.kind, Kind::Symbol(_)) && !key.speaks_of(first);
    letter.then(|| document.source.slice(first.span).trim().to_owned())
}

/// What a whole sentence tells.
fn sentence(key: &Key, spoken: &Spoken, several: bool) -> Heard {
    let (said, from_here) = without_lead(&spoken.text);
    let padded = format!(" {} ", said.to_lowercase());
    let words: Vec<&str> = padded.split_whitespace().collect();
    let of_mark =
        matches!(words.as_slice(), ["the" | "a" | "an", mark, ..] if MARKS.contains(mark));
    let formula = said.contains(['$', '`']);
    if !tells(said) || !(formula || of_mark) || said.contains('=') {
        return Heard::Nothing;
    }
    let begins = said.starts_with(['$', '`']);
    let means = [" means ", " denotes ", " stands for ", " has components "];
    let for_sure = (of_mark || begins) && means.iter().any(|cue| padded.contains(cue));
    let unheard = match for_sure && !is_plain(&padded) {
        true => Heard::Unheard,
        false => Heard::Nothing,
    };
    let said = said.trim_end_matches(['.', ',', ';', '!']).to_owned() + ".";
    let Some(declared) = read(&said) else {
        return unheard;
    };
    match weighed(key, &declared) {
        Heard::Sentence(told) => match (from_here, several || spoken.cell.is_some()) {
            (false, _) => Heard::Sentence(told),
            (true, true) => Heard::Unheard,
            (true, false) => Heard::Sentence(format!("From line {} on {told}", spoken.line)),
        },
        Heard::Nothing => Heard::Nothing,
        Heard::Unheard => unheard,
        Heard::Doubt => Heard::Doubt,
    }
}

/// Whether words may say what something means.
fn tells(words: &str) -> bool {
    let padded = format!(" {} ", words.to_lowercase());
    TELLING.iter().any(|cue| padded.contains(cue))
}

/// Whether a sentence says what is so for everybody.
fn is_plain(sentence: &str) -> bool {
    let usual = [
        "time derivative",
        "derivative with respect to time",
        "differentiation",
    ];
    usual.iter().any(|words| sentence.contains(words))
}

/// What a sentence that is understood changes for a student.
fn weighed(key: &Key, declared: &[Declaration]) -> Heard {
    let [only] = declared else {
        return Heard::Unheard;
    };
    let told = only.sentence().to_owned() + ".";
    let heard = match &only.statement {
        Statement::Notation { .. } | Statement::Means { .. } => Heard::Sentence(told),
        Statement::Does { verb, .. } if *verb == "have" => Heard::Sentence(told),
        Statement::Same { .. } => Heard::Sentence(told),
        Statement::Is { subjects, what } if QUANTITIES.contains(&what.head) => {
            is(key, subjects, what, told)
        }
        _ if told.contains("components on") => Heard::Sentence(told),
        _ => return Heard::Nothing,
    };
    match &heard {
        Heard::Sentence(said) if !key.understands(said) => Heard::Unheard,
        _ => heard,
    }
}

/// What it changes that letters are a quantity.
fn is(key: &Key, subjects: &[Term], what: &NounPhrase, told: String) -> Heard {
    let known = subjects.iter().map(|letter| key.told_of(letter));
    let known: Vec<Option<&NounPhrase>> = known.collect();
    let same = |before: &NounPhrase| before.head == what.head;
    let within = |before: &NounPhrase| what.slots.iter().all(|slot| before.slots.contains(slot));
    match (known.as_slice(), subjects) {
        ([Some(before), ..], _) if same(before) && within(before) => Heard::Nothing,
        ([Some(before), ..], _) if same(before) => Heard::Doubt,
        ([Some(_), ..], _) => Heard::Sentence(told),
        ([None], [letter]) => match (key.letter_for(what), written(letter)) {
            (Some(other), Some(letter)) => {
                Heard::Sentence(format!("${letter}$ is the same as ${other}$."))
            }
            _ => Heard::Sentence(told),
        },
        _ => Heard::Sentence(told),
    }
}

/// What it tells that words name a quantity and a display says what that is: "The angular momentum is $$H = I\omega$$".
fn named(key: &Key, words: &str, letter: &str) -> Heard {
    let clause = words.rsplit([',', ';', ':']).next().unwrap_or(words);
    let (clause, _) = without_lead(clause);
    let mut noun: Vec<&str> = clause.split_whitespace().collect();
    while noun
        .last()
        .is_some_and(|word| VERBS.contains(&word.to_lowercase().as_str()))
    {
        noun.pop();
    }
    let begins = noun.iter().rposition(|word| {
        matches!(
            word.to_lowercase().as_str(),
            "the" | "its" | "so" | "then" | "hence"
        )
    });
    let Some(begins) = begins.filter(|_| !letter.is_empty() && !words.contains(['$', '`'])) else {
        return Heard::Nothing;
    };
    // "the angular momentum of the rotor" has the article twice.
    let first = noun
        .iter()
        .position(|word| word.eq_ignore_ascii_case("the"));
    let noun = noun[first.unwrap_or(begins) + 1..].join(" ");
    let said = format!("${letter}$ is the {noun}.");
    let Some(declared) = read(&said) else {
        return Heard::Nothing;
    };
    match declared.as_slice() {
        [
            Declaration {
                statement: Statement::Is { subjects, what },
                ..
            },
        ] if QUANTITIES.contains(&what.head) => match subjects.as_slice() {
            [own] if key.told_of(own).is_none() => names(key, letter, what, said),
            _ => Heard::Nothing,
        },
        _ => Heard::Nothing,
    }
}

/// What it tells that a letter of the student's own is a quantity. Where the sheet has no letter for it, the quantity itself
/// is meant if the system determines it: a wrong formula for it is no definition.
fn names(key: &Key, letter: &str, what: &NounPhrase, said: String) -> Heard {
    let told = match key.letter_for(what) {
        Some(other) => format!("${letter}$ is the same as ${other}$."),
        None if DETERMINED.contains(&what.head) && !what.slots.is_empty() => said,
        None => return Heard::Nothing,
    };
    match key.understands(&told) {
        true => Heard::Sentence(told),
        false => Heard::Nothing,
    }
}

/// A sentence without what leads into it, and whether that says that it holds from here on.
fn without_lead(text: &str) -> (&str, bool) {
    let (mut rest, mut from_here) = (text, false);
    loop {
        let trimmed = rest
            .trim_start_matches(|c: char| c.is_whitespace() || matches!(c, ',' | ':' | '(' | '-'));
        let lead = LEADS.iter().chain(&FROM_HERE).find(|lead| {
            let start = trimmed.get(..lead.len());
            let behind = trimmed.get(lead.len()..).unwrap_or("");
            start.is_some_and(|start| start.eq_ignore_ascii_case(lead))
                && behind.starts_with([' ', ',', ':'])
        });
        let Some(lead) = lead else {
            return (trimmed, from_here);
        };
        from_here |= FROM_HERE.contains(lead);
        rest = &trimmed[lead.len()..];
    }
}

/// A sentence alone, if it is understood.
fn read(sentence: &str) -> Option<Vec<Declaration>> {
    let (bare, _) = notation::read("", "", Format::Markdown);
    let declared = verify::declarations(&bare, &[sheet(std::iter::once(sentence.to_owned()))]);
    let read = declared.misunderstood.is_empty() && !declared.declarations.is_empty();
    let read = read && !declared.declarations.iter().any(Declaration::is_unread);
    read.then_some(declared.declarations)
}

fn written(letter: &Term) -> Option<&str> {
    match letter {
        Term::Formula(formula) => Some(&formula.source),
        _ => None,
    }
}
