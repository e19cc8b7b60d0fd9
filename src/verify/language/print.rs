//! Statements as sentences, each word in its first form.

mod phrases;

use super::heads::INSTANT;
use super::lexicon::{Class, Entry, Lexicon};
use super::statement::{
    Declaration, DeclaredRole, Extent, Formula, NotationMeaning, NounPhrase, Sign, Slot, Statement,
    Term,
};
use phrases::Printer;

/// A declaration as a sentence that reads back as the same one.
///
/// Where a name inside a phrase could be taken with two nouns the sentence may read otherwise; none of the customary
/// statements is of that kind.
pub fn sentence(declaration: &Declaration, lexicon: &Lexicon) -> String {
    if declaration.is_unread() {
        return declaration.text.clone();
    }
    let printer = Printer { lexicon };
    let text = printer.statement(&declaration.statement);
    let text = match extent(&declaration.extent) {
        Some(extent) => match (
            once(&declaration.extent),
            printer.subject(&declaration.statement),
        ) {
            (Some(number), Some(subject)) => {
                let said = text.strip_prefix(&subject).unwrap_or(&text);
                format!("{extent} the {} {subject}{said}", ordinal(number))
            }
            _ => format!("{extent} {text}"),
        },
        None => text,
    };
    format!("{}.", capital(&text))
}

/// The words of an extent; none for the whole document.
fn extent(extent: &Extent) -> Option<String> {
    Some(match extent {
        Extent::Document => return None,
        Extent::Lines {
            first, last: None, ..
        } => format!("from line {first} on"),
        Extent::Lines {
            cell: Some(cell),
            first,
            last,
        } => {
            format!("in cell {cell}, {},", lines(*first, *last))
        }
        Extent::Lines { first, last, .. } => format!("on {}", lines(*first, *last)),
        Extent::Cells(cells) => {
            let numbers: Vec<String> = cells.iter().map(usize::to_string).collect();
            let noun = if cells.len() == 1 { "cell" } else { "cells" };
            format!("in {noun} {}", listed(&numbers))
        }
        Extent::Section(heading) => format!("in the section \"{heading}\""),
        Extent::Between(a, b) if b.is_empty() => format!("from ({a}) on"),
        Extent::Between(a, b) => format!("between ({a}) and ({b})"),
        Extent::Occurrence {
            cell: Some(cell),
            line,
            ..
        } => format!("in cell {cell}, line {line},"),
        Extent::Occurrence { line, .. } => format!("on line {line}"),
        Extent::Both(a, b) => {
            let (a, b) = (
                self::extent(a).unwrap_or_default(),
                self::extent(b).unwrap_or_default(),
            );
            format!("{} {b}", a.trim_end_matches(','))
        }
    })
}

/// Which occurrence on a line an extent is.
fn once(extent: &Extent) -> Option<usize> {
    match extent {
        Extent::Occurrence { number, .. } => Some(*number),
        Extent::Both(_, b) => once(b),
        _ => None,
    }
}

fn lines(first: usize, last: Option<usize>) -> String {
    match last {
        Some(last) if last != first => format!("lines {first} to {last}"),
        _ => format!("line {first}"),
    }
}

/// "a, b and c".
fn listed(parts: &[String]) -> String {
    match parts {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

fn ordinal(number: usize) -> &'static str {
    let ordinals = super::phrase::ORDINALS;
    ordinals
        .get(number.saturating_sub(1))
        .copied()
        .unwrap_or("first")
}

/// With a capital where the sentence begins with a word and not with a name.
fn capital(text: &str) -> String {
    let word = text.split([' ', ',']).next().unwrap_or_default();
    let plain = word.bytes().all(|b| b.is_ascii_lowercase());
    let short = ["a", "an", "on", "in", "no"].contains(&word);
    match text.get(..1) {
        Some(first) if plain && (word.len() > 2 || short) => {
            format!("{}{}", first.to_uppercase(), &text[1..])
        }
        _ => text.to_owned(),
    }
}

impl Printer<'_> {
    /// How the subject of a statement is printed.
    fn subject(&self, statement: &Statement) -> Option<String> {
        match statement {
            Statement::Is { subjects, .. } | Statement::Same { subjects, .. } => {
                Some(self.terms(subjects))
            }
            Statement::Means { written, .. } => Some(self.formula(written)),
            Statement::Does { subjects, .. } => Some(self.terms(subjects)),
            _ => None,
        }
    }

    fn statement(&self, statement: &Statement) -> String {
        match statement {
            Statement::Is { subjects, what } => {
                let many = self.many(subjects);
                let is = if many { "are" } else { "is" };
                let also = if what.is("also") { " also" } else { "" };
                format!(
                    "{} {is}{also} {}",
                    self.terms(subjects),
                    self.predicate(what, many)
                )
            }
            Statement::Same { subjects, others } => {
                let is = if self.many(subjects) { "are" } else { "is" };
                format!(
                    "{} {is} the same as {}",
                    self.terms(subjects),
                    self.terms(others)
                )
            }
            Statement::Does {
                subjects,
                verb,
                slots,
            } => self.does(subjects, verb, slots),
            Statement::Holds(formula) => self.formula(formula),
            Statement::LineHolds { lines, slots } => self.line_holds(lines, slots),
            Statement::Bounds {
                subject,
                lower,
                upper,
            } => format!(
                "{} lies between {} and {}",
                self.formula(subject),
                self.formula(lower),
                self.formula(upper)
            ),
            Statement::Means { written, meaning } => {
                format!("{} means {}", self.formula(written), self.formula(meaning))
            }
            Statement::Notation { sign, meaning } => self.rule(sign, meaning),
            Statement::Role { lines, role } => self.role(lines, role),
            Statement::Premise(phrase) => self.premise(phrase),
            Statement::Unread { .. } => String::new(),
        }
    }

    fn does(&self, subjects: &[Term], verb: &str, slots: &[(Slot, Term)]) -> String {
        let many = self.many(subjects);
        let entry = self.lexicon.entry(verb, &[Class::Verb, Class::Passive]);
        let verb = match entry {
            Some(entry) if entry.class == Class::Passive => {
                format!("{} {}", if many { "are" } else { "is" }, entry.participle)
            }
            Some(entry) if !many => entry.ending.clone(),
            _ => verb.to_owned(),
        };
        format!(
            "{} {verb}{}",
            self.terms(subjects),
            self.slots(entry, slots, false)
        )
    }

    fn line_holds(&self, lines: &Extent, slots: &[(Slot, Term)]) -> String {
        let (subject, many) = of_lines(lines);
        let hold = if many { "hold" } else { "holds" };
        let terms: Vec<Term> = slots.iter().map(|(_, term)| term.clone()).collect();
        let place = match slots.first() {
            None => String::new(),
            Some((Slot::In, Term::Phrase(section))) => match section.slot(Slot::Which) {
                Some(Term::Name(heading)) => format!(" in the section \"{heading}\""),
                _ => format!(" to first order in {}", self.terms(&terms)),
            },
            Some((Slot::In, _)) => format!(" to first order in {}", self.terms(&terms)),
            Some((Slot::InSecondOrder, _)) => {
                format!(" to second order in {}", self.terms(&terms))
            }
            Some((_, Term::Phrase(instant))) if instant.head == INSTANT => {
                match instant.slot(Slot::Which) {
                    Some(Term::Name(words)) => format!(" at the instant {words}"),
                    _ => format!(" at {}", self.terms(&terms)),
                }
            }
            Some(_) => format!(" at {}", self.terms(&terms)),
        };
        format!("{subject} {hold}{place}")
    }

    fn role(&self, lines: &Extent, role: &DeclaredRole) -> String {
        let (subject, many) = of_lines(lines);
        let role = match (role, many) {
            (DeclaredRole::Given, false) => "is given",
            (DeclaredRole::Given, true) => "are given",
            (DeclaredRole::Assume, false) => "is assumed",
            (DeclaredRole::Assume, true) => "are assumed",
            (DeclaredRole::Claim, false) => "is a claim",
            (DeclaredRole::Claim, true) => "are claims",
            (DeclaredRole::LeftOut, false) => "is left out",
            (DeclaredRole::LeftOut, true) => "are left out",
            (DeclaredRole::Define(None), false) => "is a definition",
            (DeclaredRole::Define(None), true) => "are definitions",
            (DeclaredRole::Define(Some(formula)), _) => {
                let define = if many { "define" } else { "defines" };
                return format!("{subject} {define} {}", self.formula(formula));
            }
            (DeclaredRole::StartsFrom(formula), _) => {
                let start = if many { "start from" } else { "starts from" };
                return format!("{subject} {start} {}", self.formula(formula));
            }
            (DeclaredRole::GoesOnFrom(before), _) => {
                let goes_on = if many { "continue" } else { "continues" };
                let before = of_lines(before).0.to_lowercase();
                return format!("{subject} {goes_on} {before}");
            }
        };
        format!("{subject} {role}")
    }

    fn rule(&self, sign: &Sign, meaning: &NotationMeaning) -> String {
        let (sign, many, operator) = match sign {
            Sign::Mark(name) | Sign::Custom(name) => {
                let entry = self.lexicon.entry(name, &[Class::Mark, Class::Custom]);
                let many = entry.is_some_and(|entry| entry.plural);
                let words = entry.map_or_else(|| (*name).to_owned(), |entry| self.sign(entry));
                (if many { words } else { with_article(&words) }, many, false)
            }
            Sign::Label { labels, on_whole } => {
                let many = labels.len() > 1;
                let noun = if many { "labels" } else { "label" };
                let shown: Vec<String> = labels.iter().map(|label| format!("${label}$")).collect();
                let on_whole = match meaning {
                    _ if !on_whole => "",
                    NotationMeaning::Noun(noun) if noun.head == "component" => " on brackets",
                    _ => " on a rate",
                };
                (
                    format!("the {noun} {}{on_whole}", listed(&shown)),
                    many,
                    false,
                )
            }
            Sign::Operator(formula) => (self.formula(formula), false, true),
        };
        let is = if many { "are" } else { "is" };
        let means = match (operator, many) {
            (true, _) => "is",
            (false, true) => "mean",
            (false, false) => "means",
        };
        match meaning {
            NotationMeaning::Fixed(name) if name.starts_with("joins") => format!("{sign} {name}"),
            NotationMeaning::Fixed(name) => format!("{sign} {is} {name}"),
            NotationMeaning::FunctionsOf(formulas) => {
                let shown: Vec<String> = formulas.iter().map(|f| self.formula(f)).collect();
                format!("{sign} takes functions of {}", listed(&shown))
            }
            NotationMeaning::Noun(phrase) if phrase.head == "function" => {
                let terms: Vec<Term> = phrase.all(Slot::Of).cloned().collect();
                format!("{sign} takes functions of {}", self.terms(&terms))
            }
            NotationMeaning::Noun(phrase) => format!("{sign} {means} {}", self.meaning(phrase)),
        }
    }

    /// The words of a mark or a custom: one that is the lack of something has a longer form.
    fn sign(&self, entry: &Entry) -> String {
        let mut longest = entry.name.to_owned();
        if entry.name.starts_with("no ") {
            for form in self.lexicon.synonyms(entry) {
                if form.split(' ').count() > longest.split(' ').count() {
                    longest = form;
                }
            }
        }
        longest
    }

    fn premise(&self, phrase: &NounPhrase) -> String {
        let (withs, rest): (Vec<_>, Vec<_>) = phrase
            .slots
            .iter()
            .cloned()
            .partition(|(slot, _)| *slot == Slot::With);
        let mut noun = NounPhrase {
            slots: rest,
            ..phrase.clone()
        };
        if let ("dimension", Some(Term::Numbers(numbers))) = (phrase.head, phrase.slot(Slot::Which))
        {
            let number = numbers.first().copied().unwrap_or_default();
            return format!("space has {number} dimensions");
        }
        if phrase.is("no") {
            noun.adjectives.retain(|a| *a != "no");
            let slots = std::mem::take(&mut noun.slots);
            let act = self.lexicon.entry("act", &[Class::Verb]);
            let except = withs.iter().filter_map(|(_, term)| self.adverb(term));
            return format!(
                "no {} acts{}{}",
                self.bare(&noun, false),
                self.slots(act, &slots, false),
                except.collect::<String>()
            );
        }
        if !withs.is_empty() {
            let subjects: Vec<Term> = withs.into_iter().map(|(_, term)| term).collect();
            let many = self.many(&subjects);
            let is = if many { "are" } else { "is" };
            return format!(
                "{} {is} {}",
                self.terms(&subjects),
                self.predicate(&noun, many)
            );
        }
        let Some(last) = noun.adjectives.pop() else {
            return self.described(&noun);
        };
        let not = noun.is("not");
        noun.adjectives.retain(|a| *a != "not");
        let entry = self.lexicon.entry(last, &[Class::Adjective]);
        let noun_entry = self.lexicon.entry(noun.head, &super::phrase::NOUNS);
        let has =
            |entry: Option<&Entry>, slot| entry.is_some_and(|e| e.preposition(slot).is_some());
        let takes =
            |slot: Slot| has(entry, slot) || (slot != Slot::Which && !has(noun_entry, slot));
        let (behind, before): (Vec<_>, Vec<_>) =
            noun.slots.into_iter().partition(|(slot, _)| takes(*slot));
        noun.slots = before;
        let what = NounPhrase {
            head: last,
            adjectives: if not { vec!["not"] } else { vec![] },
            slots: behind,
        };
        let subject = self.described(&noun);
        format!("{subject} is {}", self.predicate(&what, false))
    }

    /// A formula between dollar signs, or between backticks if it was read as plain text.
    fn formula(&self, formula: &Formula) -> String {
        let none = crate::notation::Macros::default();
        let reads = |plain| {
            let rows = super::reader::rows(&formula.source, plain, &none);
            rows.first() == Some(&formula.row)
        };
        match reads(true) && !reads(false) {
            true => format!("`{}`", formula.source),
            false => format!("${}$", formula.source),
        }
    }
}

/// The subject of a sentence about lines, and whether it is in the plural.
fn of_lines(extent: &Extent) -> (String, bool) {
    match extent {
        Extent::Lines { cell, first, last } => {
            let cell = cell.map_or(String::new(), |cell| format!(" of cell {cell}"));
            let many = last.is_some_and(|last| last != *first);
            (format!("{}{cell}", lines(*first, *last)), many)
        }
        Extent::Cells(cells) => {
            let numbers: Vec<String> = cells.iter().map(usize::to_string).collect();
            let noun = if cells.len() == 1 { "cell" } else { "cells" };
            (format!("{noun} {}", listed(&numbers)), cells.len() > 1)
        }
        Extent::Section(heading) => (format!("the section \"{heading}\""), false),
        Extent::Document => ("everything".to_owned(), false),
        _ => (String::new(), false),
    }
}

/// A noun with "a" or "an".
fn with_article(noun: &str) -> String {
    let vowel = noun.starts_with(['a', 'e', 'i', 'o', 'u']) && !noun.starts_with("un");
    let vowel = vowel || noun.starts_with("uns");
    format!("{} {noun}", if vowel { "an" } else { "a" })
}
