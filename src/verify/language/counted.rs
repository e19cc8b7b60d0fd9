//! Things that are counted and have no names: "the rotor consists of two particles" speaks of particle 1 and particle 2.

use super::is_body;
use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// Words for how many things there are.
const COUNTS: [(&str, usize); 5] = [
    ("two", 2),
    ("three", 3),
    ("four", 4),
    ("five", 5),
    ("six", 6),
];

/// Things of one noun, by their numbers.
struct Counted {
    noun: &'static str,
    count: usize,
}

impl Counted {
    fn names(&self) -> impl Iterator<Item = Term> + '_ {
        (1..=self.count).map(|number| Term::Name(format!("{} {number}", self.noun)))
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
    let mut found = declarations.iter().enumerate();
    let found = found.find_map(|(at, declaration)| {
        let (_, slots) = declaration.statement.does("consist")?;
        let parts = slots.iter().enumerate();
        let mut parts = parts.filter_map(|(n, (_, part))| Some((n, counted(part)?)));
        let (part, (counted, what)) = parts.next()?;
        parts.next().is_none().then_some((at, part, counted, what))
    });
    let Some((at, part, counted, what)) = found else {
        return;
    };
    let terms = declarations.iter().flat_map(|d| d.statement.terms());
    let mut families = terms.filter_map(|term| match term {
        Term::Member { family, .. } => Some(family),
        _ => None,
    });
    if families.any(|family| family == counted.noun) {
        return;
    }
    if let Statement::Does { slots, .. } = &mut declarations[at].statement {
        slots.splice(part..=part, counted.names().map(|name| (Slot::Of, name)));
    }
    let are = Statement::Is {
        subjects: counted.names().collect(),
        what,
    };
    let mut told = vec![declarations[at].saying(are)];
    for declaration in declarations.iter_mut() {
        told.extend(of_each(declaration, &counted));
    }
    declarations.extend(told);
}

/// "two particles of mass `$m$`": how many of what, and what they are.
fn counted(part: &Term) -> Option<(Counted, NounPhrase)> {
    let Term::Phrase(part) = part else {
        return None;
    };
    let count = COUNTS.iter().find(|(word, _)| part.is(word))?.1;
    let mut what = (**part).clone();
    what.adjectives
        .retain(|said| COUNTS.iter().all(|(word, _)| word != said));
    is_body(part.head).then_some((
        Counted {
            noun: part.head,
            count,
        },
        what,
    ))
}

/// "`$a$` and `$b$` are the positions of the particles": each that of its own.
fn of_each(declaration: &mut Declaration, counted: &Counted) -> Vec<Declaration> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return vec![];
    };
    let all = what.slots.iter().position(|(_, of)| counted.are(of));
    let Some(at) = all.filter(|_| subjects.len() == counted.count) else {
        return vec![];
    };
    let letters = subjects.iter().all(|subject| name(subject).is_some());
    if !letters || what.head == counted.noun {
        return vec![];
    }
    let mut said = subjects.iter().zip(counted.names()).map(|(subject, own)| {
        let mut what = what.clone();
        what.slots[at].1 = own;
        declaration.saying(Statement::one_is(subject.clone(), what))
    });
    let first = said.next();
    let rest = said.collect();
    if let Some(first) = first {
        *declaration = first;
    }
    rest
}
