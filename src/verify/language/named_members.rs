//! Members by their names: "the rotor consists of `$P_1$` and `$P_2$`; `$i$` numbers the particles" says which one each number
//! is.

use super::bodies::singular;
use super::counted::names_of_counted;
use super::counted_by_name::name_counted;
use super::is_thing;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::notation::document::Row;

/// As many as letters with numbers are looked for.
const MOST: usize = 3;

/// The members of a whole that have names with the numbers from 1 on.
struct Named {
    family: String,
    index: Formula,
    members: Vec<Term>,
}

/// What is said of member `$i$` is said of each by its name, with its number in the place of `$i$`.
pub(crate) fn name_members(declarations: &mut Vec<Declaration>) {
    name_counted(declarations);
    tell_listed(declarations);
    let Some(named) = named(declarations) else {
        return refuse_numbers(declarations);
    };
    let mut told = vec![];
    for declaration in declarations.drain(..) {
        if numbers(&declaration.statement).is_some() {
            told.push(declaration.saying(named.numbering()));
            continue;
        }
        match named.each(&declaration.statement) {
            Some(each) => told.extend(each.into_iter().map(|s| declaration.saying(s))),
            None => told.push(declaration),
        }
    }
    *declarations = told;
}

/// "It consists of the particles P and Q": each of them is one.
fn tell_listed(declarations: &mut Vec<Declaration>) {
    let mut told = vec![];
    for declaration in declarations.iter() {
        let Some((wholes, parts)) = declaration.statement.does("consist") else {
            continue;
        };
        let Some((noun, own)) = listed(parts, declarations) else {
            continue;
        };
        let are = Statement::Is {
            subjects: own.clone(),
            what: NounPhrase::new(noun, vec![]),
        };
        let consist = Statement::Does {
            subjects: wholes.to_vec(),
            verb: "consist",
            slots: own.into_iter().map(|part| (Slot::Of, part)).collect(),
        };
        told.push((declaration.saying(consist), declaration.saying(are)));
    }
    for (consist, are) in told {
        let own =
            |d: &&mut Declaration| d.line == consist.line && d.statement.does("consist").is_some();
        if let Some(declaration) = declarations.iter_mut().find(own) {
            *declaration = consist;
        }
        declarations.push(are);
    }
}

/// The names behind "the particles", where the list has nothing else and no sentence says what else one of them is.
fn listed(
    parts: &[(Slot, Term)],
    declarations: &[Declaration],
) -> Option<(&'static str, Vec<Term>)> {
    let [(Slot::Of, Term::Phrase(first)), rest @ ..] = parts else {
        return None;
    };
    let which = first.slots.iter().all(|(slot, _)| *slot == Slot::Which);
    let plain = which && first.adjectives.is_empty() && first.head == "particle";
    let own = first
        .all(Slot::Which)
        .chain(rest.iter().map(|(_, part)| part));
    let own: Vec<Term> = own.cloned().collect();
    let proper = |term: &Term| match term {
        Term::Name(name) => name.starts_with(char::is_uppercase),
        Term::Formula(_) => true,
        _ => false,
    };
    let other = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } => {
            is_thing(what.head)
                && what.head != first.head
                && subjects.iter().any(|s| own.contains(s))
        }
        _ => false,
    };
    let told = plain && own.len() > 1 && own.iter().all(proper);
    (told && !declarations.iter().any(other)).then_some((first.head, own))
}

/// Where a letter numbers things of which some have names without numbers, nobody knows which one each number is.
fn refuse_numbers(declarations: &mut [Declaration]) {
    let families: Vec<String> = declarations
        .iter()
        .filter_map(|d| Some(numbers(&d.statement)?.1))
        .filter(|family| has_named_parts(declarations, family))
        .collect();
    for declaration in declarations {
        let of_family =
            |term: &&Term| matches!(term, Term::Member { family, .. } if families.contains(family));
        let counts = numbers(&declaration.statement).is_some_and(|(_, f)| families.contains(&f));
        if counts || declaration.statement.terms().iter().any(of_family) {
            *declaration = declaration.clone().not_understood();
        }
    }
}

/// Whether something consists of things of a family that have names.
fn has_named_parts(declarations: &[Declaration], family: &str) -> bool {
    let wholes = declarations
        .iter()
        .filter_map(|d| d.statement.does("consist"));
    let mut parts = wholes.flat_map(|(_, parts)| parts);
    parts.any(|(_, part)| is_said_to_be(declarations, part, family))
}

/// The members, where one whole consists of nothing else and one letter numbers them.
fn named(declarations: &[Declaration]) -> Option<Named> {
    let mut said = declarations.iter().filter_map(|d| numbers(&d.statement));
    let (index, family) = said.next().filter(|_| said.next().is_none())?;
    let mut wholes = declarations
        .iter()
        .filter_map(|d| d.statement.does("consist"));
    let (_, parts) = wholes.next().filter(|_| wholes.next().is_none())?;
    if let Some(members) = parts
        .iter()
        .find_map(|(_, part)| names_of_counted(part, &family))
    {
        return Some(Named {
            family,
            index,
            members,
        });
    }
    let (members, of_family): (Vec<Term>, bool) = match parts {
        [(Slot::Of, Term::Phrase(all))] => {
            (all.all(Slot::Which).cloned().collect(), all.head == family)
        }
        parts => (parts.iter().map(|(_, part)| part.clone()).collect(), false),
    };
    let mut each = members.iter().zip(1..);
    let numbered = each.all(|(member, number)| is_number(member, number));
    let mut own = members.iter();
    let are = of_family || own.all(|member| is_said_to_be(declarations, member, &family));
    let known = numbered && (2..=MOST).contains(&members.len()) && are;
    known.then_some(Named {
        family,
        index,
        members,
    })
}

/// Whether a sentence says that a thing is one of a family.
fn is_said_to_be(declarations: &[Declaration], thing: &Term, family: &str) -> bool {
    let named = matches!(thing, Term::Name(_) | Term::Formula(_));
    let own = |subject: &Term| match (written(subject), written(thing)) {
        (Some(one), Some(other)) => one == other,
        _ => named && subject == thing,
    };
    declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => what.head == family && subjects.iter().any(own),
        _ => false,
    })
}

/// Whether the name of a thing ends with its number, behind a low line.
fn is_number(member: &Term, number: usize) -> bool {
    written(member).is_some_and(|(_, label)| label == number.to_string())
}

/// The letter and the label of a name.
fn written(member: &Term) -> Option<(&str, &str)> {
    let name = match member {
        Term::Name(name) => name,
        Term::Formula(letter) => &letter.source,
        _ => return None,
    };
    let numbered = || {
        let digits = name
            .find(|c: char| c.is_ascii_digit())
            .filter(|at| *at > 0)?;
        Some(name.split_at(digits))
    };
    let (letter, label) = name.split_once('_').or_else(numbered)?;
    Some((letter, label.trim_matches(['{', '}'])))
}

/// "`$i$` numbers the particles": with which letter, and which family.
fn numbers(statement: &Statement) -> Option<(Formula, String)> {
    let ([Term::Formula(index)], [(Slot::Of, Term::Name(many))]) = statement.does("number")? else {
        return None;
    };
    Some((index.clone(), singular(many)?))
}

impl Named {
    /// "`$i$` numbers P and Q."
    fn numbering(&self) -> Statement {
        Statement::Does {
            subjects: vec![Term::Formula(self.index.clone())],
            verb: "number",
            slots: self.members.iter().map(|m| (Slot::Of, m.clone())).collect(),
        }
    }

    /// What a statement about member `$i$` says of each.
    fn each(&self, statement: &Statement) -> Option<Vec<Statement>> {
        let terms = statement.terms();
        if !terms.iter().any(|term| self.is_member(term)) {
            return None;
        }
        let each = self.members.iter().zip(1..);
        let told = each.map(|(member, number): (&Term, usize)| {
            let mut own = statement.clone();
            for term in own.terms_mut() {
                self.put(member, number, term);
            }
            own
        });
        Some(told.collect())
    }

    /// "particle `$i$`", "`$P_i$`"
    fn is_member(&self, term: &Term) -> bool {
        if let Term::Member { family, index } = term {
            return *family == self.family && index.source == self.index.source;
        }
        let letter = self.members.first().and_then(written);
        let own = written(term).filter(|(_, label)| *label == self.index.source);
        own.is_some_and(|(own, _)| letter.is_some_and(|(letter, _)| letter == own))
    }

    /// Puts a member and its number in the place of the index.
    fn put(&self, member: &Term, number: usize, term: &mut Term) {
        if self.is_member(term) {
            *term = member.clone();
            return;
        }
        match term {
            Term::Formula(formula) => {
                if let Some(numbered) = self.with_number(formula, number) {
                    *formula = numbered;
                }
            }
            Term::Phrase(phrase) => {
                let inner = phrase.slots.iter_mut();
                inner.for_each(|(_, term)| self.put(member, number, term));
            }
            _ => {}
        }
    }

    /// A formula whose letters have the number in the place of the index.
    fn with_number(&self, formula: &Formula, number: usize) -> Option<Formula> {
        let Row::Expression(node) = &formula.row else {
            return None;
        };
        let mut node = node.clone();
        let mut changed = false;
        node.change_symbols(&mut |symbol| {
            for label in symbol
                .subscripts
                .iter_mut()
                .filter(|l| **l == self.index.source.trim_start_matches('\\'))
            {
                *label = number.to_string();
                changed = true;
            }
        });
        changed.then(|| Formula::of(&node))
    }
}
