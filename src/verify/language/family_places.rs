//! Where each of a family is: "the rotors lie at the distance `$l$` from G along x, y, -x and -y", "rotor 1 is placed from G
//! by `$l$` along x", "P and Q are the middles of the rotors".

use super::bodies::singular;
use super::in_turn::does_in_turn;
use super::is_body;
use super::kinds::name;
use super::reader;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::notation::Macros;
use std::collections::{BTreeMap, BTreeSet};

/// Nouns of the places of things.
const PLACES: [&str; 5] = ["middle", "centre", "hub", "mass centre", "place"];

/// Verbs of where something is.
const LAID: [&str; 3] = ["lie", "place", "be at"];

/// Things of one noun, each with the point where it is.
pub(super) struct Family {
    pub(super) noun: String,
    /// What stands in the place of an index.
    pub(super) labels: Vec<String>,
    pub(super) places: Vec<Term>,
}

/// Which of a family are spoken of.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Of {
    All,
    One(String),
}

impl Family {
    fn new(noun: String, places: Vec<Term>) -> Self {
        let labels = (1..=places.len()).map(|number| number.to_string());
        Self {
            noun,
            labels: labels.collect(),
            places,
        }
    }
}

/// "its middle", "their middles"
pub(super) fn is_place(place: &NounPhrase) -> bool {
    PLACES.contains(&place.head)
}

/// The families of which sentences tell where each is; what tells it of all of them tells it of each.
pub(super) fn families(declarations: &mut Vec<Declaration>) -> Vec<Family> {
    name_numbers(declarations);
    let mut families = by_middles(declarations);
    families.extend(laid_in_turn(declarations));
    families.extend(placed_one_by_one(declarations));
    let once = |family: &Family| families.iter().filter(|f| f.noun == family.noun).count() == 1;
    let known: Vec<bool> = families.iter().map(once).collect();
    let mut known = known.into_iter();
    families.retain(|_| known.next().unwrap_or(false));
    families
}

/// Which of a family a term names, if it names any.
pub(super) fn family_of(term: &Term, noun: &str) -> Option<Of> {
    match term {
        Term::Name(many) => {
            let own = many == noun || singular(many).as_deref() == Some(noun);
            own.then_some(Of::All)
        }
        Term::Member { family, index } if family == noun => Some(Of::One(index.source.clone())),
        Term::Phrase(phrase) if phrase.head == noun => match phrase.slots.as_slice() {
            [] => Some(Of::All),
            [(Slot::Which, which)] => Some(Of::One(name(which)?)),
            _ => None,
        },
        _ => None,
    }
}

/// "P and Q are the middles of the rotors."
fn by_middles(declarations: &[Declaration]) -> Vec<Family> {
    let told = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if PLACES.contains(&what.head) => {
            let [(Slot::Of, of)] = what.slots.as_slice() else {
                return None;
            };
            let noun = family_noun(of)?;
            let subjects = match (family_of(of, &noun)?, subjects.as_slice()) {
                (Of::One(index), [point]) => numbered_points(point, &index, declarations)?,
                (_, all) => all.to_vec(),
            };
            let noun = Some(noun).filter(|_| subjects.len() > 1)?;
            let points = subjects.iter().all(|point| name(point).is_some());
            (points && is_body(&noun)).then(|| Family::new(noun, subjects))
        }
        _ => None,
    });
    told.collect()
}

/// The noun of all things of a family, or of one.
pub(super) fn family_noun(term: &Term) -> Option<String> {
    match term {
        Term::Name(many) => singular(many),
        Term::Member { family, .. } => Some(family.clone()),
        Term::Phrase(phrase) => match phrase.slots.as_slice() {
            [] | [(Slot::Which, _)] => Some(phrase.head.to_owned()),
            _ => None,
        },
        _ => None,
    }
}

/// "`P_i` is the centre of rotor `i`", where sentences place `P_1`, `P_2` and so on.
fn numbered_points(point: &Term, index: &str, declarations: &[Declaration]) -> Option<Vec<Term>> {
    let stem = name(point)?;
    let stem = stem.strip_suffix(&format!("_{index}"))?.to_owned();
    let placed = |number: usize| {
        let own = Some(format!("{stem}_{number}"));
        declarations.iter().find_map(|d| match &d.statement {
            Statement::Does { subjects, verb, .. } if LAID.contains(verb) => subjects
                .iter()
                .find(|subject| name(subject) == own)
                .cloned(),
            _ => None,
        })
    };
    Some((1..).map_while(placed).collect())
}

/// "The rotors lie at the distance `$l$` from G along x and y": each along its own.
fn laid_in_turn(declarations: &mut Vec<Declaration>) -> Vec<Family> {
    let (mut families, mut said, mut spent) = (vec![], vec![], vec![]);
    for (at, declaration) in declarations.iter().enumerate() {
        let Statement::Does {
            subjects,
            verb,
            slots,
        } = &declaration.statement
        else {
            continue;
        };
        let [all @ (Term::Name(_) | Term::Phrase(_))] = subjects.as_slice() else {
            continue;
        };
        let ways = slots.iter().filter(|(s, _)| *s == Slot::Along).count();
        let from = slots.iter().any(|(slot, _)| *slot == Slot::From);
        let Some(noun) = family_noun(all).filter(|noun| is_body(noun)) else {
            continue;
        };
        if ways > 1 && from && LAID.contains(verb) {
            let names: Vec<Term> = (1..=ways)
                .map(|number| Term::Name(format!("{noun} {number}")))
                .collect();
            let each = does_in_turn(&names, verb, slots).into_iter();
            said.extend(each.map(|statement| declaration.saying(statement)));
            spent.push(at);
            families.push(Family::new(noun, names));
        }
    }
    let mut place = 0..;
    declarations.retain(|_| place.next().is_none_or(|at| !spent.contains(&at)));
    declarations.extend(said);
    families
}

/// "Rotor 1 is placed from G by `$l$` along x", and so on, in any order: as many as their highest number, each once.
fn placed_one_by_one(declarations: &[Declaration]) -> Vec<Family> {
    let mut placed: BTreeMap<String, BTreeMap<usize, Term>> = BTreeMap::new();
    let mut lost: BTreeSet<String> = BTreeSet::new();
    for declaration in declarations {
        let Statement::Does { subjects, verb, .. } = &declaration.statement else {
            continue;
        };
        let ([Term::Member { family, index }], true) = (subjects.as_slice(), LAID.contains(verb))
        else {
            continue;
        };
        let own = placed.entry(family.clone()).or_default();
        let twice = match index.source.parse() {
            Ok(number) => own.insert(number, subjects[0].clone()).is_some(),
            Err(_) => true,
        };
        if twice {
            lost.insert(family.clone());
        }
    }
    let all = |(family, each): (String, BTreeMap<usize, Term>)| {
        let whole = each.len() > 1 && each.keys().copied().eq(1..=each.len());
        let known = whole && !lost.contains(&family);
        known.then(|| Family::new(family, each.into_values().collect()))
    };
    placed.into_iter().filter_map(all).collect()
}

/// A formula with a number in the place of the index, wherever that stands alone: in labels and in powers.
pub(super) fn numbered(
    formula: &Formula,
    index: &str,
    number: &str,
    macros: &Macros,
) -> Option<Formula> {
    let source = &formula.source;
    let mut text = String::new();
    let mut rest = 0;
    for (at, _) in source.match_indices(index) {
        let before = source[..at].chars().next_back();
        let after = source[at + index.len()..].chars().next();
        let inside = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '\\');
        if !inside(before) && !inside(after) {
            text.push_str(&source[rest..at]);
            text.push_str(number);
            rest = at + index.len();
        }
    }
    text.push_str(&source[rest..]);
    (rest > 0).then(|| reader::formula(&text, false, macros))?
}

/// "Rotors 1, 2 and 3": each is a rotor.
fn name_numbers(declarations: &mut [Declaration]) {
    for at in 1..declarations.len() {
        let (before, rest) = declarations.split_at_mut(at);
        let same = |d: &&Declaration| d.line == rest[0].line && d.text == rest[0].text;
        let family = before.iter().rev().filter(same).find_map(|d| {
            let numbered = |term: &&Term| matches!(term, Term::Member { index, .. } if index.source.parse::<usize>().is_ok());
            match d.statement.terms().into_iter().find(numbered) {
                Some(Term::Member { family, index }) => Some((family.clone(), index.clone())),
                _ => None,
            }
        });
        let Some((family, index)) = family else {
            continue;
        };
        for term in rest[0].statement.terms_mut() {
            name_number(term, &family, &index);
        }
    }
}

fn name_number(term: &mut Term, family: &str, index: &Formula) {
    match term {
        Term::Numbers(numbers) if numbers.len() == 1 => {
            let index = Formula {
                source: numbers[0].to_string(),
                row: index.row.clone(),
            };
            *term = Term::Member {
                family: family.to_owned(),
                index,
            };
        }
        Term::Phrase(phrase) => {
            let of = phrase
                .slots
                .iter_mut()
                .filter(|(slot, _)| *slot == Slot::Of);
            of.for_each(|(_, term)| name_number(term, family, index));
        }
        _ => {}
    }
}
