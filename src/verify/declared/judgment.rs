//! What the judge says of a part of the document, in the author's letters.

use crate::algebra::{
    Fraction, Letter, Monomial, Polynomial, Printer, Proof, Rational, Style, Variable,
};
use crate::notation::document::{Document, Row};
use crate::notation::reread;
use crate::source::Span;
use crate::verify::correction::search::corrections;
use crate::verify::declarations::Declared;
use crate::verify::declared::{Residuals, report};
use crate::verify::language::rate_letters::with_rates;
use crate::verify::language::statement::Declaration;
use crate::verify::model::atoms::{Atoms, dotted};
use crate::verify::reading::builder::place_in;
use crate::verify::reading::{LineRole, Reading};
use crate::verify::standing::extents::located;
use crate::verify::standing::given_lines::with_given_lines;
use crate::verify::standing::judge::{Judge, Judged};
use crate::verify::standing::parts::{Part, is_of_one_system, parts};
use crate::verify::standing::prepared::Prepared;
use crate::verify::standing::shown::Shown;
use crate::verify::standing::written::written_symbols;
use crate::verify::term::known::Known;
use crate::verify::term::letters::{At, Meaning, Reach};
use crate::verify::term::lower::Lowering;
use crate::verify::term::value::Value;
use crate::verify::term::written::Written;
use crate::verify::verdict::{Counterexample, Diagnosis};
use crate::verify::{Finding, Report, Role};
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::ops::Range;
use std::sync::Arc;

/// A residual of more terms than this is not shown.
const LONGEST_RESIDUAL: usize = 40;

/// The lines of a part of the document, judged.
pub(super) struct Judgment<'a> {
    pub(super) judge: Judge<'a>,
    own: Arc<OwnLetters>,
    /// What would put refuted lines right.
    pub(super) corrections: HashMap<Span, Diagnosis>,
    /// The numbers of its variables.
    numbers: Range<usize>,
}

/// Each part of a document, judged by what is declared of it. No two parts have a variable in common.
pub(super) fn judgments<'a>(
    document: &'a Document,
    declarations: &[Declaration],
    roles: impl Iterator<Item = LineRole> + Clone,
) -> Vec<Judgment<'a>> {
    let mut first = 0;
    let declarations = with_given_lines(document, located(document, declarations));
    let judged = parts(document, &declarations).into_iter().map(|part| {
        let mut judge = Judge::new(document, part, first);
        judge.reading.roles.extend(roles.clone());
        judge.run();
        let own = OwnLetters::of(document, &mut judge.reading, &mut judge.known);
        let before = std::mem::replace(&mut first, judge.reading.system.atoms.len());
        Judgment::of(judge, Arc::new(own), before)
    });
    judged.collect()
}

impl<'a> Judgment<'a> {
    /// Of lines that are judged, whose letters are these, and whose variables are numbered from a number on.
    pub(super) fn of(judge: Judge<'a>, own: Arc<OwnLetters>, first: usize) -> Self {
        Self {
            own,
            corrections: HashMap::new(),
            numbers: first..judge.reading.system.atoms.len(),
            judge,
        }
    }
}

impl Judgment<'_> {
    /// Looks for what would put its refuted lines right.
    pub(super) fn correct(&mut self) {
        self.corrections = corrections(&mut self.judge);
    }

    /// What its variables stand for, in LaTeX.
    pub(super) fn variables(&self) -> Vec<String> {
        let atoms = &self.judge.reading.system.atoms;
        let numbers = self.numbers.clone();
        numbers
            .map(|v| self.own.anywhere(atoms, v as Variable))
            .collect()
    }

    pub(super) fn conditions(&self, proof: &Proof, judged: &Judged, source: &str) -> Vec<String> {
        let mut found: Vec<String> = vec![];
        let arguments = proof.arguments().iter();
        let conditions = arguments.flat_map(|argument| &argument.conditions);
        for condition in conditions.filter(|condition| !is_positive(condition)) {
            let condition = Fraction::from(condition.clone());
            let text = format!("{} \\ne 0", self.printed(&condition, judged, source));
            if !found.contains(&text) {
                found.push(text);
            }
        }
        found
    }

    fn printed(&self, of: &Fraction, judged: &Judged, source: &str) -> String {
        let atoms = &self.judge.reading.system.atoms;
        self.own.printed(of, atoms, &judged.at, source)
    }

    /// Left less right as written, or with what is known put in where that is too long.
    pub(super) fn residual(&self, judged: &Judged, shown: &Shown, source: &str) -> Option<String> {
        let (left, right) = judged.sides.get(shown.place)?;
        let written = left.clone() - right.clone();
        let short = |f: &&Fraction| f.numerator().len() + f.denominator().len() <= LONGEST_RESIDUAL;
        let chosen = [&written, &shown.residual].into_iter().find(short);
        chosen.map(|chosen| self.printed(chosen, judged, source))
    }

    pub(super) fn counterexample(
        &self,
        judged: &Judged,
        shown: &Shown,
        source: &str,
    ) -> Counterexample {
        let atoms = &self.judge.reading.system.atoms;
        let letters = shown.letters.iter().map(|(letter, value)| {
            let name = self.own.on_line(atoms, *letter, &judged.at, source);
            let value = match self.own.is_opposite(atoms, *letter) {
                true => -value.clone(),
                false => value.clone(),
            };
            (name, value.to_string())
        });
        Counterexample {
            symbols: letters.collect(),
            component: component(judged.sides.len(), shown.place),
            left: shown.left.to_string(),
            right: shown.right.to_string(),
        }
    }
}

/// The name of a component: its number in a vector, row and column in a matrix.
fn component(count: usize, place: usize) -> Option<String> {
    if count <= 1 {
        return None;
    }
    Some(match (3..=8).find(|size| size * size == count) {
        Some(size) => format!("row {}, column {}", place / size + 1, place % size + 1),
        None => (place + 1).to_string(),
    })
}

/// Whether a polynomial is positive for all real numbers: a positive number and squares.
fn is_positive(of: &Polynomial) -> bool {
    let square = |(monomial, coefficient): &(Monomial, Rational)| {
        let even = monomial.powers().iter().all(|(_, power)| power % 2 == 0);
        even && !coefficient.is_negative()
    };
    let is_number = |(monomial, _): &(Monomial, Rational)| monomial.powers().is_empty();
    of.terms().iter().all(square) && of.terms().iter().any(is_number)
}

/// No more readings are kept: documents differ in what they write in few ways that count.
const MOST_READINGS: usize = 32;

/// What is declared of many documents. For those that would be read alike it is read once.
#[derive(Clone, Debug)]
pub(crate) struct Shared {
    pub(crate) declared: Declared,
    /// Whether the sentences speak of one system in all of a document.
    is_of_one_system: bool,
    /// A document without a line, in whose notation the sentences are written.
    bare: Document,
    readings: RefCell<Vec<Read>>,
}

/// What the sentences make of documents that are read alike.
#[derive(Clone, Debug)]
struct Read {
    prepared: Prepared,
    own: Arc<OwnLetters>,
}

/// The symbols that a document writes, which are known of the one that was handed in.
fn symbols_of(document: &Document, handed_in: &Document, written: &Written) -> Written {
    match std::ptr::eq(document, handed_in) {
        true => written.clone(),
        false => written_symbols(document),
    }
}

impl Shared {
    /// Of these sentences, written in the notation of a document without a line.
    pub(crate) fn new(declared: Declared, bare: Document) -> Self {
        Self {
            is_of_one_system: is_of_one_system(&declared.declarations),
            declared,
            bare,
            readings: RefCell::default(),
        }
    }

    /// Judges every line of a document, and looks for what would put false ones right. The report leaves out what the
    /// sentences say, which is the same for all documents.
    pub(crate) fn check(&self, document: &Document, written: &Written) -> Report {
        let read = with_rates(document, &self.declared.declarations);
        let written = symbols_of(&read, document, written);
        let mut judgments = self.judgments(&read, &written, &[]);
        judgments.iter_mut().for_each(Judgment::correct);
        report(&read, &self.declared, &judgments, Residuals::LeftOut)
    }

    /// The same without looking for what would put false lines right, and with some lines taken as claimed.
    pub(crate) fn judge(
        &self,
        document: &Document,
        written: &Written,
        claimed: &[&Finding],
    ) -> Report {
        let read = with_rates(document, &self.declared.declarations);
        let written = symbols_of(&read, document, written);
        let judgments = self.judgments(&read, &written, claimed);
        report(&read, &self.declared, &judgments, Residuals::LeftOut)
    }

    fn judgments<'d>(
        &self,
        document: &'d Document,
        written: &Written,
        claimed: &[&Finding],
    ) -> Vec<Judgment<'d>> {
        let claims = claimed.iter().map(|finding| {
            let reach = Reach::Lines {
                cell: finding.cell,
                first: finding.source_line,
                last: finding.source_line,
            };
            LineRole::new(reach, Some(Role::Claim))
        });
        if !self.is_of_one_system {
            return judgments(document, &self.declared.declarations, claims);
        }
        let (mut prepared, own) = self.reading(written);
        prepared.reading.roles.extend(claims);
        let mut judge = Judge::over(document, Part::default(), prepared);
        judge.run();
        vec![Judgment::of(judge, own, 0)]
    }

    /// The reading of a document that writes these symbols.
    fn reading(&self, written: &Written) -> (Prepared, Arc<OwnLetters>) {
        let mut readings = self.readings.borrow_mut();
        let known = readings.iter().find_map(|read| {
            let prepared = read.prepared.for_writing(written)?;
            Some((prepared, read.own.clone()))
        });
        known.unwrap_or_else(|| {
            let mut prepared = Prepared::new(&self.declared.declarations, written.clone(), 0);
            prepared.work_out();
            let own = OwnLetters::of(&self.bare, &mut prepared.reading, &mut prepared.known);
            let own = Arc::new(own);
            prepared.known.share(&prepared.reading.system);
            if readings.len() < MOST_READINGS {
                readings.push(Read {
                    prepared: prepared.clone(),
                    own: own.clone(),
                });
            }
            (prepared, own)
        })
    }
}

/// The letters that stand for a variable each, and where.
#[derive(Debug, Default)]
pub(super) struct OwnLetters {
    of: BTreeMap<Variable, Vec<(String, Reach)>>,
    /// Entries of tensors that are written as products of inertia, with the other sign.
    opposite: BTreeSet<Variable>,
}

impl OwnLetters {
    /// Those of a document, by what is declared of it.
    pub(super) fn of(document: &Document, reading: &mut Reading, known: &mut Known) -> Self {
        let mut own = Self::default();
        let letters = reading.letters.clone();
        // What lines settle changes no letter that sentences tell of.
        let shapes = std::mem::take(&mut known.shapes);
        for letter in &letters.letters {
            if !matches!(letter.meaning, Meaning::Quantity(_)) {
                continue;
            }
            let rows = reread(document, &letter.latex);
            let [Row::Expression(node)] = rows.as_slice() else {
                continue;
            };
            let at = place_in(&letter.reach);
            let system = &mut reading.system;
            let mut lowering = Lowering::new(system, &letters, &document.source, &at, known);
            let value = lowering.value(node);
            if let Ok(value) = &value
                && letters.customs.integrals
            {
                let told = letters.customs.products.of_inertia_told;
                let products = products_of_inertia(value).into_iter();
                let own_sign = |v: &Variable| told || system.atoms.atom(*v).law.is_none();
                own.opposite.extend(products.filter(own_sign));
            }
            let entry = value.ok().filter(|value| value.entries.len() == 1);
            if let Some(variable) = entry.and_then(|value| value.entries[0].as_variable()) {
                let named = own.of.entry(variable).or_default();
                named.push((letter.latex.clone(), letter.reach.clone()));
            }
        }
        known.shapes = shapes;
        own
    }

    /// A variable in the letters of a line: in one that stands in it, else in one that is declared there.
    pub(super) fn on_line(
        &self,
        atoms: &Atoms,
        variable: Variable,
        at: &At,
        source: &str,
    ) -> String {
        self.name(atoms, variable, |known| {
            let here = |(_, reach): &&(String, Reach)| reach.covers(at, 1);
            let written = known.iter().filter(here);
            let mut written = written.filter(|(letter, _)| source.contains(letter.as_str()));
            written.next().or_else(|| known.iter().find(here))
        })
    }

    /// A variable in the letter that stands for it in all of the document.
    pub(super) fn anywhere(&self, atoms: &Atoms, variable: Variable) -> String {
        self.name(atoms, variable, |known| {
            known.iter().find(|(_, reach)| *reach == Reach::All)
        })
    }

    fn name<'s>(
        &'s self,
        atoms: &Atoms,
        variable: Variable,
        choose: impl Fn(&'s [(String, Reach)]) -> Option<&'s (String, Reach)>,
    ) -> String {
        let (mut base, mut dots) = (variable, 0usize);
        loop {
            let known = self.of.get(&base).and_then(|known| choose(known));
            match (known, atoms.atom(base).rate_of) {
                (Some((letter, _)), _) if dots == 0 => return letter.clone(),
                (Some((letter, _)), _) => {
                    return dotted(dots, letter).unwrap_or_else(|| atoms.latex(variable));
                }
                (None, Some(of)) => (base, dots) = (of, dots + 1),
                _ => return atoms.latex(variable),
            }
        }
    }

    /// Whether the letter of a variable stands for its opposite: a product of inertia that is an integral.
    pub(super) fn is_opposite(&self, atoms: &Atoms, variable: Variable) -> bool {
        let mut base = variable;
        while let Some(of) = atoms.atom(base).rate_of {
            base = of;
        }
        self.opposite.contains(&base)
    }

    /// A fraction with letters in the place of variables.
    fn in_letters(&self, of: &Fraction, atoms: &Atoms) -> Fraction {
        let written = |polynomial: &Polynomial| {
            let terms = polynomial.terms().iter().map(|(monomial, number)| {
                let powers = monomial.powers().into_iter();
                let turned = powers.filter(|(v, _)| self.is_opposite(atoms, *v));
                match turned.map(|(_, power)| power).sum::<u32>() % 2 {
                    0 => (monomial.clone(), number.clone()),
                    _ => (monomial.clone(), -number.clone()),
                }
            });
            Polynomial::from_terms(terms.collect())
        };
        let turned = Fraction::new(written(of.numerator()), written(of.denominator()));
        turned.unwrap_or_else(|| of.clone())
    }

    /// A fraction in the letters of a line.
    pub(super) fn printed(&self, of: &Fraction, atoms: &Atoms, at: &At, source: &str) -> String {
        let of = &self.in_letters(of, atoms);
        let letters = |variable: Variable| Letter {
            text: self.on_line(atoms, variable, at, source),
            place: atoms.atom(variable).place,
        };
        Printer::new(Style::Latex, &letters).fraction(of)
    }
}

/// The variables off the diagonal of a symmetric tensor.
fn products_of_inertia(value: &Value) -> Vec<Variable> {
    let symmetric = value.is_matrix()
        && value.basis[0] == value.basis[1]
        && value.transposed().entries == value.entries;
    let off_diagonal = value
        .entries
        .iter()
        .enumerate()
        .filter(|(at, _)| at % 4 != 0);
    match symmetric {
        true => off_diagonal
            .filter_map(|(_, entry)| entry.as_variable())
            .collect(),
        false => vec![],
    }
}
