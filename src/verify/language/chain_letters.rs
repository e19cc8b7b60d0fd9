//! Letters of the things of a chain: what a sentence says of "`$\omega_i$`" and frame `$i$` it says of `$\omega_{i+1}$` and
//! frame `$i+1$`, and of any frames what it says "for any frames `$j$` and `$k$`".

use super::chains::{NEIGHBOURS, is_frame, thing};
use super::extent::common;
use super::messages::{number_of_frame, numbered_frame};
use super::reader::formula;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term};
use crate::notation::Macros;
use std::collections::BTreeSet;

/// What is put in the place of a letter that numbers things.
#[derive(Clone)]
struct Instead {
    letter: String,
    number: String,
}

/// What the sentences about letters say of the neighbours and the numbers among the things, where no sentence tells those
/// letters. Of a thing that only one part of the document speaks of they are told there alone.
pub(super) fn letters_of_others(
    declarations: &[Declaration],
    letter: &str,
    things: &BTreeSet<String>,
    macros: &Macros,
) -> Vec<Declaration> {
    let known = |thing: &String| things.contains(thing);
    let frames = things.iter().filter_map(|thing| number_of_frame(thing));
    let (numbers, of_letter): (Vec<&str>, Vec<&str>) = frames.partition(|n| is_number(n));
    let mut letters: BTreeSet<String> = declarations.iter().flat_map(subjects_written).collect();
    let mut told = numbered_frames(declarations, &numbers, letter, things);
    for declaration in declarations {
        let any = any_frames(&declaration.statement);
        let choices: Vec<Vec<Instead>> = match any.as_slice() {
            [] => {
                let neighbours = NEIGHBOURS.iter().map(|behind| format!("{letter}{behind}"));
                let numbers = numbers.iter().map(|number| (*number).to_owned());
                let all = neighbours.chain(numbers);
                all.map(|number| vec![Instead::new(letter, &number)])
                    .collect()
            }
            any => [&of_letter, &numbers]
                .into_iter()
                .flat_map(|numbers| all_choices(any, numbers))
                .collect(),
        };
        for instead in choices {
            let Some(statement) = in_place(&declaration.statement, &instead, macros) else {
                continue;
            };
            let mut own = declaration.saying(statement);
            let spoken: Vec<String> = numbered(&own.statement, letter).collect();
            let subjects = subjects_written(&own);
            let new = !subjects.is_empty() && subjects.iter().all(|own| !letters.contains(own));
            if new && !spoken.is_empty() && spoken.iter().all(known) {
                let parts = spoken
                    .iter()
                    .map(|thing| part_of(thing, declarations, letter));
                let narrow = parts
                    .into_iter()
                    .try_fold(own.extent.clone(), |all, part| common(&all, &part));
                if let Some(extent) = narrow {
                    letters.extend(subjects);
                    own.extent = extent;
                    told.push(own);
                }
            }
        }
    }
    told
}

/// Whether a sentence tells letters "for any frames", and they are told for each of the chain.
pub(super) fn is_told_for_each(declaration: &Declaration, told: &[Declaration]) -> bool {
    let same = |own: &Declaration| own.line == declaration.line && own.text == declaration.text;
    !any_frames(&declaration.statement).is_empty() && told.iter().any(same)
}

/// "frame 2" is a frame, and that of link 2 where sentences speak of that as well.
fn numbered_frames(
    declarations: &[Declaration],
    numbers: &[&str],
    letter: &str,
    things: &BTreeSet<String>,
) -> Vec<Declaration> {
    let Some(general) = declarations.iter().find(|d| is_frame(&d.statement, letter)) else {
        return vec![];
    };
    let link = match &general.statement {
        Statement::Is { what, .. } => match what.slot(Slot::FixedIn) {
            Some(Term::Member { family, index }) if index.source == letter => Some(family),
            _ => None,
        },
        _ => None,
    };
    let told = numbers.iter().filter_map(|number| {
        let own = numbered_frame(number);
        let mut said = declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == "frame" => {
                Some(subjects.iter().filter_map(|subject| thing(subject, letter)))
            }
            _ => None,
        });
        if said.any(|mut subjects| subjects.any(|subject| subject == own)) {
            return None;
        }
        let carrier = link.map(|link| (link, format!("{link} {number}")));
        let carrier = carrier.filter(|(_, carrier)| things.contains(carrier));
        let fixed = carrier.map(|(_, carrier)| (Slot::FixedIn, Term::Name(carrier)));
        let what = NounPhrase::new("frame", fixed.into_iter().collect());
        Some(Declaration {
            statement: Statement::one_is(Term::Name(own.clone()), what),
            extent: part_of(&own, declarations, letter),
            ..general.clone()
        })
    });
    told.collect()
}

/// The only part of the document that speaks of a thing; else all of it.
fn part_of(thing: &str, declarations: &[Declaration], letter: &str) -> Extent {
    let speaks = |d: &&Declaration| numbered(&d.statement, letter).any(|own| own == thing);
    let mut parts = declarations.iter().filter(speaks).map(|d| &d.extent);
    match parts.next() {
        Some(first) if parts.all(|part| part == first) => first.clone(),
        _ => Extent::Document,
    }
}

fn is_number(number: &str) -> bool {
    number.chars().all(|c| c.is_ascii_digit())
}

/// The letters behind "for any frames".
fn any_frames(statement: &Statement) -> Vec<String> {
    let slots = match statement {
        Statement::Is { what, .. } => what.slots.as_slice(),
        Statement::Does { slots, .. } => slots.as_slice(),
        _ => &[],
    };
    let any = slots.iter().filter(|(slot, _)| *slot == Slot::ForAny);
    any.filter_map(|(_, term)| match term {
        Term::Formula(letter) => Some(letter.source.clone()),
        Term::Name(letter) => Some(letter.clone()),
        _ => None,
    })
    .collect()
}

/// Each of some letters in the place of each of others, no two the same.
fn all_choices(any: &[String], numbers: &[&str]) -> Vec<Vec<Instead>> {
    let mut choices: Vec<Vec<Instead>> = vec![vec![]];
    for letter in any {
        let longer = choices.iter().flat_map(|chosen| {
            let free = numbers
                .iter()
                .filter(|n| chosen.iter().all(|c: &Instead| c.number != **n));
            free.map(|n| [chosen.as_slice(), &[Instead::new(letter, n)]].concat())
        });
        choices = longer.collect();
    }
    choices
}

/// The letters of the subjects, as they are written.
fn subjects_written(declaration: &Declaration) -> Vec<String> {
    let subjects = declaration.statement.subjects().iter();
    let letters = subjects.map(|subject| match subject {
        Term::Formula(letter) => {
            let signs = letter.source.chars();
            Some(
                signs
                    .filter(|c| !c.is_whitespace() && !"{}".contains(*c))
                    .collect(),
            )
        }
        _ => None,
    });
    letters.collect::<Option<_>>().unwrap_or_default()
}

/// The things with numbers of which a statement speaks.
fn numbered<'s>(statement: &'s Statement, letter: &'s str) -> impl Iterator<Item = String> + 's {
    let terms = statement.terms().into_iter();
    terms.filter_map(|term| match term {
        Term::Name(name) => number_of_frame(name).map(|_| name.clone()),
        Term::Phrase(frame) if frame.head == "frame" => match frame.slot(Slot::Which) {
            Some(Term::Numbers(numbers)) => {
                let number = numbers.first()?;
                Some(numbered_frame(&number.to_string()))
            }
            _ => thing(term, letter),
        },
        _ => thing(term, letter),
    })
}

/// A statement with numbers in the place of letters; `None` where that goes beyond the neighbours.
fn in_place(statement: &Statement, instead: &[Instead], macros: &Macros) -> Option<Statement> {
    let mut own = statement.clone();
    let slots = match &mut own {
        Statement::Is { what, .. } => &mut what.slots,
        Statement::Does { slots, .. } => slots,
        _ => return None,
    };
    slots.retain(|(slot, _)| *slot != Slot::ForAny);
    for term in own.terms_mut() {
        put(term, instead, macros)?;
    }
    Some(own)
}

fn put(term: &mut Term, instead: &[Instead], macros: &Macros) -> Option<()> {
    match term {
        Term::Formula(index) if replaced(&index.source, instead).is_some() => {
            let number = replaced(&index.source, instead)??;
            *term = match is_number(&number) {
                true => Term::Name(numbered_frame(&number)),
                false => Term::Formula(formula(&number, false, macros)?),
            };
        }
        Term::Formula(letter) | Term::Member { index: letter, .. } => {
            let source = written(&letter.source, instead)?;
            if source != letter.source {
                *letter = formula(&source, false, macros)?;
            }
        }
        Term::Phrase(phrase) => {
            for (slot, term) in &mut phrase.slots {
                put(term, instead, macros)?;
                if let (Slot::Which, Term::Name(frame)) = (slot, &*term)
                    && let Some(number) = number_of_frame(frame)
                {
                    *term = Term::Numbers(vec![number.parse().ok()?]);
                }
            }
        }
        _ => {}
    }
    Some(())
}

/// A formula that is a number itself, or has it for a label.
fn written(source: &str, instead: &[Instead]) -> Option<String> {
    if let Some(number) = replaced(source, instead) {
        return number;
    }
    let (mut out, mut rest) = (String::new(), source);
    while let Some(at) = rest.find(['_', '^']) {
        let (before, label) = rest.split_at(at + 1);
        out.push_str(before);
        let (label, behind) = label_of(label);
        match replaced(label, instead) {
            Some(number) => out.push_str(&format!("{{{}}}", number?)),
            None => out.push_str(label),
        }
        rest = behind;
    }
    out.push_str(rest);
    Some(out)
}

/// The label behind its sign, with the braces around it, and what follows.
fn label_of(source: &str) -> (&str, &str) {
    let end = match source.starts_with('{') {
        true => source.find('}').map_or(source.len(), |at| at + 1),
        false => source.chars().next().map_or(0, char::len_utf8),
    };
    source.split_at(end)
}

/// What stands in the place of a number: `None` where it is none of these letters, `Some(None)` beyond the neighbours.
fn replaced(source: &str, instead: &[Instead]) -> Option<Option<String>> {
    let signs = source.chars();
    let index: String = signs
        .filter(|c| !c.is_whitespace() && !"{}".contains(*c))
        .collect();
    instead.iter().find_map(|instead| {
        let by = shift(index.strip_prefix(&instead.letter)?)?;
        Some(instead.shifted(by))
    })
}

/// By how many a neighbour stands behind.
fn shift(behind: &str) -> Option<i32> {
    let at = NEIGHBOURS.iter().position(|n| *n == behind)?;
    i32::try_from(at).ok().map(|at| at - 1)
}

impl Instead {
    fn new(letter: &str, number: &str) -> Self {
        Self {
            letter: letter.to_owned(),
            number: number.to_owned(),
        }
    }

    /// The number that stands so far behind, among the neighbours.
    fn shifted(&self, by: i32) -> Option<String> {
        if let Ok(number) = self.number.parse::<i32>() {
            let next = number + by;
            return (next >= 0).then(|| next.to_string());
        }
        let base = self.number.trim_end_matches(['+', '-', '1']);
        let own = shift(self.number.strip_prefix(base)?)?;
        let next = NEIGHBOURS.iter().find(|n| shift(n) == Some(by + own))?;
        Some(format!("{base}{next}"))
    }
}
