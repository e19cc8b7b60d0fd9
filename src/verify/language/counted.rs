//! Things that are counted and have no names: "the rotor consists of two particles" speaks of particle 1 and particle 2.

use super::counted_by_name::named_things;
use super::in_turn::{does_in_turn, each_of_its_own};
use super::is_body;
use super::kinds::name;
use super::phrase::ORDINALS;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use super::terms::say_besides;

/// Words for how many things there are.
const COUNTS: [(&str, usize); 5] = [
    ("two", 2),
    ("three", 3),
    ("four", 4),
    ("five", 5),
    ("six", 6),
];

/// Verbs of where each of several lies.
const LAID: [&str; 2] = ["lie", "point"];

/// Things of one noun, by their numbers.
struct Counted {
    noun: &'static str,
    count: usize,
    /// Their names, where sentences tell of so many by letters: "motor `$f$`".
    lettered: Vec<Term>,
    /// What the sentence that counts them says of each.
    what: Option<NounPhrase>,
}

impl Counted {
    fn names(&self) -> impl Iterator<Item = Term> + '_ {
        let own = |number: usize| self.lettered.get(number - 1).cloned();
        let numbered = |number| Term::Name(format!("{} {number}", self.noun));
        (1..=self.count).map(move |number| own(number).unwrap_or_else(|| numbered(number)))
    }

    /// "motor `$f$`" by its name.
    fn name_members(&self, term: &mut Term) {
        match term {
            Term::Member { family, index } if *family == self.noun => {
                *term = Term::Name(format!("{family} {}", index.source));
            }
            Term::Phrase(phrase) => {
                let inner = phrase.slots.iter_mut();
                inner.for_each(|(_, term)| self.name_members(term));
            }
            _ => {}
        }
    }

    /// "the particles", where these are meant.
    fn are(&self, term: &Term) -> bool {
        match term {
            Term::Name(name) => *name == format!("{}s", self.noun),
            Term::Phrase(all) => all.head == self.noun && all.slots.is_empty(),
            Term::Formula(_) | Term::Member { .. } | Term::Numbers(_) => false,
        }
    }
}

/// Gives numbers to the parts of a whole that are counted, where no letter numbers them.
pub(crate) fn number_counted(declarations: &mut Vec<Declaration>) {
    let mut all: Vec<Counted> = vec![];
    for at in 0..declarations.len() {
        all.extend(number_parts(declarations, at));
    }
    let mut told = vec![];
    for declaration in declarations.iter_mut() {
        let said = all.iter().find_map(|own| own.each(declaration, &all));
        if let Some((first, rest)) = said.as_deref().and_then(<[Declaration]>::split_first) {
            *declaration = first.clone();
            told.extend(rest.iter().cloned());
        }
    }
    declarations.extend(told);
    for own in all.iter().filter(|own| !own.lettered.is_empty()) {
        let terms = declarations
            .iter_mut()
            .flat_map(|d| d.statement.terms_mut());
        terms.for_each(|term| own.name_members(term));
    }
}

/// "Rod 1 and rod 2 lie along the axes x and y with their middles at G": each along its own, with its own middle there.
pub(crate) fn lay_in_turn(declarations: &mut Vec<Declaration>) {
    say_besides(declarations, |statement| {
        let Statement::Does {
            subjects,
            verb,
            slots,
        } = &*statement
        else {
            return vec![];
        };
        let axes = axes_listed(slots).filter(|_| LAID.contains(verb));
        if subjects.len() < 2 || axes.is_none_or(|axes| axes.len() != subjects.len()) {
            return vec![];
        }
        let slots: Vec<(Slot, Term)> = slots.iter().flat_map(spread).collect();
        let mut said = does_in_turn(subjects, verb, &slots);
        let all = subjects.clone();
        for (own, statement) in all.iter().zip(&mut said) {
            if let Statement::Does { slots, .. } = statement {
                slots
                    .iter_mut()
                    .for_each(|(_, term)| keep_own(term, own, &all));
            }
        }
        *statement = said.remove(0);
        said
    });
}

/// Of a place that is told of several things that of one of them: "their middles".
fn keep_own(term: &mut Term, own: &Term, all: &[Term]) {
    if let Term::Phrase(place) = term {
        place
            .slots
            .retain(|(slot, of)| *slot != Slot::Of || of == own || !all.contains(of));
    }
}

/// Puts the names of the parts where a sentence counts them, and adds what it says of these.
fn number_parts(declarations: &mut Vec<Declaration>, at: usize) -> Vec<Counted> {
    let Some((_, slots)) = declarations[at].statement.does("consist") else {
        return vec![];
    };
    let counted = slots.iter().map(|(_, part)| counted(part, declarations));
    let counted: Vec<Option<Counted>> = counted.collect();
    let parts = slots.iter().zip(&counted);
    let parts = parts.flat_map(|(part, own)| match own {
        Some(own) => own.names().map(|name| (Slot::Of, name)).collect(),
        None => vec![part.clone()],
    });
    let parts = parts.collect();
    if let Statement::Does { slots, .. } = &mut declarations[at].statement {
        *slots = parts;
    }
    let counted: Vec<Counted> = counted.into_iter().flatten().collect();
    for own in &counted {
        let are = own.what.iter().flat_map(without_likeness);
        let are = are.map(|what| Statement::Is {
            subjects: own.names().collect(),
            what,
        });
        let are: Vec<Declaration> = are.map(|are| declarations[at].saying(are)).collect();
        declarations.extend(are);
    }
    counted
}

/// "Equal wheels": what they are, and that they are equal.
fn without_likeness(what: &NounPhrase) -> Vec<NounPhrase> {
    let mut plain = what.clone();
    plain.adjectives.retain(|said| *said != EQUAL);
    let equal = what.is(EQUAL).then(|| NounPhrase::new(EQUAL, vec![]));
    std::iter::once(plain).chain(equal).collect()
}

const EQUAL: &str = "equal";

/// The names of things of a family that are counted: "three wheels".
pub(super) fn names_of_counted(part: &Term, family: &str) -> Option<Vec<Term>> {
    let Term::Phrase(part) = part else {
        return None;
    };
    let count = COUNTS.iter().find(|(word, _)| part.is(word))?.1;
    let name = |number| Term::Name(format!("{family} {number}"));
    (part.head == family && is_body(part.head)).then(|| (1..=count).map(name).collect())
}

/// How many things a part counts, and what they are: "two particles of mass `$m$`".
pub(super) fn count_of_part(part: &Term) -> Option<(usize, &NounPhrase)> {
    let Term::Phrase(part) = part else {
        return None;
    };
    let count = COUNTS.iter().find(|(word, _)| part.is(word))?.1;
    is_body(part.head).then_some((count, part))
}

/// "two particles of mass `$m$`", "the rods": how many of what, and what they are.
fn counted(part: &Term, declarations: &[Declaration]) -> Option<Counted> {
    let found = match part {
        Term::Phrase(part) => {
            let count = COUNTS.iter().find(|(word, _)| part.is(word))?.1;
            let mut what = (**part).clone();
            without_counts(&mut what);
            is_body(part.head).then_some(Counted {
                noun: part.head,
                count,
                lettered: vec![],
                what: Some(what),
            })?
        }
        Term::Name(many) => Counted {
            noun: super::body_noun(many.strip_suffix('s')?)?,
            count: declarations.iter().find_map(|d| count_of(many, d))?,
            lettered: vec![],
            what: None,
        },
        _ => return None,
    };
    // Where other things of this noun have names no sentence says which of them are counted.
    if !named_things(found.noun, declarations).is_empty() {
        return None;
    }
    let letters = letters_of_members(found.noun, declarations);
    if letters.is_empty() {
        return Some(found);
    }
    let name = |letter: &String| Term::Name(format!("{} {letter}", found.noun));
    let lettered = letters.iter().map(name).collect();
    (letters.len() == found.count).then_some(Counted { lettered, ..found })
}

/// The letters behind a noun, each once: "motor `$f$`". "Particle 1" is one of those that are counted.
fn letters_of_members(noun: &str, declarations: &[Declaration]) -> Vec<String> {
    let mut letters: Vec<String> = vec![];
    for term in declarations.iter().flat_map(|d| d.statement.terms()) {
        if let Term::Member { family, index } = term
            && family == noun
            && !index.source.chars().all(|c| c.is_ascii_digit())
            && !letters.contains(&index.source)
        {
            letters.push(index.source.clone());
        }
    }
    letters
}

/// Of how many things a sentence tells where each of them lies: "the rods lie along the axes x and y".
fn count_of(many: &str, declaration: &Declaration) -> Option<usize> {
    let Statement::Does {
        subjects,
        verb,
        slots,
    } = &declaration.statement
    else {
        return None;
    };
    let own = subjects.iter().any(|s| name(s).as_deref() == Some(many));
    let listed = axes_listed(slots)?;
    (own && LAID.contains(verb) && listed.len() > 1).then_some(listed.len())
}

/// "along the axes x and y": these.
pub(super) fn axes_listed(slots: &[(Slot, Term)]) -> Option<Vec<Term>> {
    let axes = slots.iter().find_map(|(slot, term)| match term {
        Term::Phrase(axes) if *slot == Slot::Along && axes.head == "axes" => Some(axes),
        _ => None,
    })?;
    Some(axes.all(Slot::Which).cloned().collect())
}

impl Counted {
    /// What a sentence about all of them says of each, where it says something else of each.
    fn each(&self, declaration: &Declaration, all: &[Self]) -> Option<Vec<Declaration>> {
        let said = match &declaration.statement {
            Statement::Is { subjects, what } => match subjects.as_slice() {
                [subject] if self.are(subject) => {
                    let names: Vec<Term> = self.names().collect();
                    each_of_its_own(names, what.clone())
                }
                subjects => self.of_each(subjects, what)?,
            },
            Statement::Does {
                subjects,
                verb,
                slots,
            } if matches!(subjects.as_slice(), [all] if self.are(all)) => {
                match self.at_ends(slots, all) {
                    Some(said) => said,
                    None if LAID.contains(verb) => self.laid(verb, slots),
                    None => return None,
                }
            }
            // "The particles have equal masses."
            Statement::Premise(what) => {
                let at = what.slots.iter().position(|(_, of)| self.are(of))?;
                let mut what = what.clone();
                let names = self.names().map(|name| (Slot::Of, name));
                what.slots.splice(at..=at, names);
                vec![Statement::Premise(what)]
            }
            _ => return None,
        };
        Some(said.into_iter().map(|s| declaration.saying(s)).collect())
    }

    /// "`$a$` and `$b$` are the positions of the particles": each that of its own; "G is the middle of the rods": of each.
    fn of_each(&self, subjects: &[Term], what: &NounPhrase) -> Option<Vec<Statement>> {
        let at = what.slots.iter().position(|(_, of)| self.are(of))?;
        let letters = subjects.iter().all(|subject| name(subject).is_some());
        if subjects.len() != self.count || !letters || what.head == self.noun {
            return None;
        }
        let said = subjects.iter().zip(self.names()).map(|(subject, own)| {
            let mut what = what.clone();
            what.slots[at].1 = own;
            Statement::one_is(subject.clone(), what)
        });
        Some(said.collect())
    }

    /// "The rods lie along the axes x and y with their middles at G."
    fn laid(&self, verb: &'static str, slots: &[(Slot, Term)]) -> Vec<Statement> {
        let names: Vec<Term> = self.names().collect();
        let slots: Vec<(Slot, Term)> = slots.iter().flat_map(spread).collect();
        let mut said = does_in_turn(&names, verb, &slots);
        for statement in &mut said {
            let Statement::Does {
                subjects, slots, ..
            } = statement
            else {
                continue;
            };
            let own = subjects.first().filter(|_| subjects.len() == 1).cloned();
            let places = slots.iter_mut().filter_map(|(_, term)| match term {
                Term::Phrase(place) => Some(place),
                _ => None,
            });
            for (place, own) in places.zip(own.iter().cycle()) {
                let of = place.slots.iter_mut().filter(|(_, of)| self.are(of));
                of.for_each(|(_, of)| *of = own.clone());
            }
        }
        said
    }

    /// "The particles lie at the ends of the rods": two at each, where there are as many.
    fn at_ends(&self, slots: &[(Slot, Term)], all: &[Self]) -> Option<Vec<Statement>> {
        let [(Slot::At, Term::Phrase(end))] = slots else {
            return None;
        };
        let [(Slot::Of, of)] = end.slots.as_slice() else {
            return None;
        };
        let long = match all.iter().find(|other| other.are(of)) {
            Some(rods) => rods.names().collect(),
            None => vec![of.clone()],
        };
        if end.head != "end" || self.count != 2 * long.len() {
            return None;
        }
        let own = |(number, particle): (usize, Term)| {
            let mut end = NounPhrase::new("end", vec![(Slot::Of, long[number / 2].clone())]);
            end.adjectives = vec![ORDINALS[number % 2]];
            Statement::Does {
                subjects: vec![particle],
                verb: "lie",
                slots: vec![(Slot::At, Term::Phrase(Box::new(end)))],
            }
        };
        Some(self.names().enumerate().map(own).collect())
    }
}

/// "`$a$` and `$b$` are the first two components of `$v$`": the first and the second one.
pub(crate) fn part_first(declarations: Vec<Declaration>) -> Vec<Declaration> {
    let first = Term::Numbers(vec![1]);
    let mut parted = vec![];
    for declaration in declarations {
        match &declaration.statement {
            Statement::Is { subjects, what }
                if subjects.len() > 1
                    && what.slot(Slot::Which) == Some(&first)
                    && COUNTS.iter().any(|(count, _)| what.is(count)) =>
            {
                for (at, subject) in subjects.iter().enumerate() {
                    let mut own = what.clone();
                    without_counts(&mut own);
                    let which = own
                        .slots
                        .iter_mut()
                        .filter(|(slot, _)| *slot == Slot::Which);
                    which.for_each(|(_, number)| *number = Term::Numbers(vec![at + 1]));
                    parted.push(declaration.saying(Statement::one_is(subject.clone(), own)));
                }
            }
            _ => parted.push(declaration),
        }
    }
    parted
}

/// A noun without the words for how many there are.
pub(super) fn without_counts(what: &mut NounPhrase) {
    let counts = |said: &&str| COUNTS.iter().any(|(word, _)| word == said);
    what.adjectives.retain(|said| !counts(said));
}

/// "along the axes x and y" as "along x and y".
fn spread(slot: &(Slot, Term)) -> Vec<(Slot, Term)> {
    match axes_listed(std::slice::from_ref(slot)) {
        Some(axes) if !axes.is_empty() => axes.into_iter().map(|a| (Slot::Along, a)).collect(),
        _ => vec![slot.clone()],
    }
}
