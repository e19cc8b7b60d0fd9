//! What lines say of each other by algebra and definitions alone, without the laws that make them true.
//!
//! `L_x = I ω_x` and `M_x = I ω̇_x` are both true of one body, and each follows from the other only by a law. Here every
//! quantity keeps a variable of its own and no law of mechanics is put in, so that one line follows from another only if
//! it says the same, in components, in vectors, or with a definition put in.

use crate::algebra::{Fraction, Polynomial, Variable};
use crate::notation::ast::{Line, Relation};
use crate::notation::document::{Document, Headings, Item, Row};
use crate::source::Span;
use crate::verify::facts::Source;
use crate::verify::facts::premises::Facts;
use crate::verify::language::statement::Declaration;
use crate::verify::model::atoms::fraction;
use crate::verify::model::system::KeptApart;
use crate::verify::reading::loads_read::tells_loads;
use crate::verify::standing::chains::known_tree;
use crate::verify::standing::heard::{Heard, Recalled, Worded};
use crate::verify::standing::judge::Judge;
use crate::verify::standing::memory::Wording;
use crate::verify::standing::parts::Part;
use crate::verify::standing::prepared::Prepared;
use crate::verify::standing::written::{names_an_instant, without_number, written_symbols};
use crate::verify::term::letters::At;
use crate::verify::term::written::Written;
use foldhash::HashMap;
use num_traits::Zero;
use std::sync::Arc;

/// Values of more terms are not looked at for what laws say.
const MOST_OF_LAW: usize = 500;

/// The two sides of a component.
type Pair = (Fraction, Fraction);

/// What one line says.
#[derive(Clone, Debug)]
pub(crate) struct Said {
    /// The bytes of the line.
    pub(crate) span: Span,
    /// Its left and right sides, component by component; `None` where they are not worked out.
    pub(crate) sides: Option<Arc<[Pair]>>,
    /// The first side and the last one of a chain, component by component; none where there are but two.
    pub(crate) ends: Vec<Pair>,
    /// Whether it says what a letter is of which nothing was told.
    pub(crate) defines: bool,
    /// How its sides are looked for, if that is known.
    pub(super) of: Option<Wording>,
}

/// What is declared and does not count here: what is looked for would be known by it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Withheld {
    /// Sentences that hold something.
    pub(crate) sentences: Vec<String>,
    /// Whether it is withheld what a letter comes to by a law, where that is one variable.
    pub(crate) values: bool,
}

/// What was worked out with a document, for others to go on from.
#[derive(Clone, Debug)]
pub(crate) struct WorkedOut {
    prepared: Prepared,
    /// What was taken in.
    settled: Vec<(Fraction, Source)>,
    /// What documents that go on from it were found to say, if a link says the same on every line.
    heard: Option<Heard>,
}

/// Documents under one reading, in which laws say nothing.
pub(crate) struct Apart<'a> {
    pub(super) judge: Judge<'a>,
    pub(super) facts: Facts,
    /// What was taken in.
    settled: Vec<(Fraction, Source)>,
    /// What other documents that go on from the same say.
    pub(super) recalled: Option<Recalled>,
    /// Whether nothing but that was taken in from which it goes on.
    pub(super) is_fresh: bool,
}

impl<'a> Apart<'a> {
    /// A reading by these declarations, of which some are not taken to hold: sentences that tell loads, which is a law, and
    /// what is withheld.
    pub(crate) fn new(
        document: &'a Document,
        declarations: &[Declaration],
        withheld: &Withheld,
    ) -> Self {
        let mut prepared = Prepared::new(declarations, written_symbols(document), 0);
        prepared.reading.system.apart = match withheld.values {
            true => KeptApart::Variables,
            false => KeptApart::Terms,
        };
        let laws = declarations.iter().filter(|said| tells_loads(said));
        let named = withheld.sentences.iter().map(String::as_str);
        let silent: Vec<&str> = laws.map(Declaration::sentence).chain(named).collect();
        for premise in &mut prepared.reading.premises {
            if matches!(&premise.source, Source::Declared(said) if silent.contains(&said.as_str()))
            {
                premise.equation = Fraction::zero();
            }
        }
        Self {
            judge: Judge::over(document, Part::default(), prepared),
            facts: Facts::default(),
            settled: vec![],
            recalled: None,
            is_fresh: false,
        }
    }

    /// To go on with from what was worked out with a document, and taken in.
    pub(crate) fn after(document: &'a Document, worked_out: &WorkedOut) -> Self {
        let mut prepared = worked_out.prepared.clone();
        let facts = std::mem::take(&mut prepared.facts);
        let system = &mut prepared.reading.system;
        let heard = worked_out.heard.clone();
        let recalled = heard.map(|heard| heard.used_by(system));
        Self {
            judge: Judge::over(document, Part::default(), prepared),
            facts,
            settled: worked_out.settled.clone(),
            recalled,
            is_fresh: true,
        }
    }

    /// What was worked out so far, and all letters besides, with these definitions taken in.
    pub(crate) fn worked_out(mut self, definitions: &[&Said]) -> WorkedOut {
        let (reading, known) = (&mut self.judge.reading, &mut self.judge.known);
        reading.system.set_dimensions(3);
        known.work_out(&reading.letters, &mut reading.system);
        self.settle(definitions);
        self.judge.reading.system.atoms.bring_up_rates();
        let reading = &self.judge.reading;
        self.judge.known.share(&reading.system);
        let uniform = reading.letters.is_uniform();
        let prepared = Prepared {
            reading: self.judge.reading,
            known: self.judge.known,
            facts: self.facts,
            links: None,
        };
        WorkedOut {
            prepared,
            settled: self.settled,
            heard: uniform.then(Heard::default),
        }
    }

    /// What each line of a document says, with products of inertia as entries or as integrals. A line of running text
    /// that only names an instant says nothing.
    pub(crate) fn lines(
        &mut self,
        document: &'a Document,
        written: &Written,
        entries: bool,
    ) -> Vec<Said> {
        let customs = &mut self.judge.reading.letters.customs;
        let same_customs = customs.integrals != entries;
        customs.integrals = !entries;
        self.judge.document = document;
        self.judge.chain.begin_anew(document);
        self.judge.words.headings = Headings::default();
        self.judge.at = At::default();
        self.judge.reading.letters.written.replace(written.clone());
        match same_customs {
            true => self.judge.known.forget_what_hangs_on_writing(),
            false => self.judge.known.forget_symbols(),
        }
        let mut said = vec![];
        for item in &document.items {
            match item {
                Item::Heading { level, text, .. } => {
                    self.judge.words.headings.enter(*level, text);
                    self.judge.at.sections = self.judge.words.headings.texts();
                }
                Item::Formula(formula) => {
                    for row in &formula.rows {
                        if let Row::Line(line) = row
                            && (formula.display || !names_an_instant(line))
                        {
                            said.push(self.line(line));
                        }
                    }
                }
                _ => {}
            }
        }
        said
    }

    fn line(&mut self, line: &Line) -> Said {
        let place = self.judge.document.place_of_row(line.span.start);
        (self.judge.at.cell, self.judge.at.line) = (place.cell, place.line);
        let plain = without_number(line);
        let links = self.judge.chain.links(&plain, &self.judge.at);
        let tree = known_tree(&self.judge.reading.letters.written, &plain, &links);
        let (mut each, mut defines): (Vec<Option<Worded>>, _) = (vec![], false);
        for link in &links {
            let equal = matches!(link.relation, Relation::Equal | Relation::Defined);
            let worked_out = equal.then(|| self.sides_of(link, tree));
            let one = worked_out.and_then(Result::ok);
            let told = one.as_ref().filter(|_| each.iter().all(Option::is_some));
            if let Some((letter, left, _)) = told.and_then(|one| one.sides.settles.as_ref()) {
                self.judge.known.shapes.insert(letter.clone(), left.shape());
                // What has a shape by a line of this document has none in others.
                self.recalled = None;
                defines = true;
            }
            each.push(one);
        }
        let each: Option<Vec<_>> = each.into_iter().collect();
        let of = match each.as_deref() {
            Some([only]) => only.of,
            _ => None,
        };
        let (sides, ends) = each.map_or((None, vec![]), |each| all_of(&each));
        Said {
            span: line.span,
            sides,
            ends,
            defines,
            of,
        }
    }

    /// Takes in what is declared for the whole document, and these definitions. To be called when all lines are there.
    pub(crate) fn settle(&mut self, definitions: &[&Said]) {
        let reading = &self.judge.reading;
        let declared = reading.active_premises(&At::default()).into_iter();
        let mut premises = self.same_quantities();
        premises.extend(declared.map(|at| {
            let premise = &reading.premises[at];
            (premise.equation.clone(), premise.source.clone())
        }));
        premises.extend(definitions.iter().flat_map(|said| equations(said)));
        if premises == self.settled && !premises.is_empty() {
            return;
        }
        self.is_fresh = false;
        self.facts = Facts::lawless();
        let atoms = &mut self.judge.reading.system.atoms;
        self.facts.extend_all(atoms, premises.clone());
        self.settled = premises;
    }

    /// Variables to which one law gives one value are one quantity: the `L_x` of `L` and a letter of its own.
    fn same_quantities(&self) -> Vec<(Fraction, Source)> {
        let atoms = &self.judge.reading.system.atoms;
        let mut first: HashMap<(&str, &Polynomial, &Polynomial), Variable> = HashMap::default();
        let mut same = vec![];
        for variable in 0..atoms.len() as Variable {
            let atom = atoms.atom(variable);
            let Some(law) = atom.law.as_ref().filter(|_| atom.rate_of.is_none()) else {
                continue;
            };
            let (above, below) = (law.value.numerator(), law.value.denominator());
            let other = *first.entry((law.name, above, below)).or_insert(variable);
            if other != variable {
                let source = Source::Declared(atoms.latex(variable));
                same.push((fraction(variable) - fraction(other), source));
            }
        }
        same
    }

    /// What laws say of the quantities of this document alone: that two are the same which different laws give one value, as
    /// the moment and the rate of the angular momentum; and what one is by others, as that rate by the angular momentum.
    pub(crate) fn laws(&self) -> Vec<Fraction> {
        let system = &self.judge.reading.system;
        let mut known: HashMap<(Polynomial, Polynomial), Vec<(&str, Variable)>> =
            HashMap::default();
        let mut laws = vec![];
        for variable in 0..system.atoms.len() as Variable {
            let atom = system.atoms.atom(variable);
            let Some(law) = atom.law.as_ref().filter(|_| atom.rate_of.is_none()) else {
                continue;
            };
            let told = |v| system.atoms.atom(v).law.is_some();
            let value = system.expanded(&law.value, &[]);
            if law.value.variables().into_iter().any(told) {
                laws.push(fraction(variable) - law.value.clone());
            }
            if value.variables().is_empty() || value.numerator().len() > MOST_OF_LAW {
                continue;
            }
            let same = (value.numerator().clone(), value.denominator().clone());
            let same = known.entry(same).or_default();
            let other = same.first().filter(|(name, _)| *name != law.name);
            laws.extend(other.map(|(_, other)| fraction(variable) - fraction(*other)));
            same.push((law.name, variable));
        }
        laws
    }

    /// Whether a value is made up of what never changes.
    pub(crate) fn is_constant(&self, value: &Fraction) -> bool {
        self.judge.reading.system.atoms.is_constant(value)
    }

    /// A value with what is taken in put in; `None` where it grows too large.
    pub(crate) fn normal(&mut self, of: &Fraction) -> Option<Fraction> {
        let atoms = &mut self.judge.reading.system.atoms;
        self.facts.normal(atoms, of).ok()
    }

    /// Whether nothing is told of a variable.
    pub(crate) fn is_unknown(&self, variable: Variable) -> bool {
        self.judge.reading.system.atoms.is_unknown(variable)
    }
}

/// The sides of all links of a line, if there are any, and the ends of the chain.
fn all_of(links: &[Worded]) -> (Option<Arc<[Pair]>>, Vec<Pair>) {
    let mut each = links.iter().map(|one| &one.sides.sides);
    let sides: Arc<[Pair]> = match links {
        [only] => only.sides.sides.clone(),
        _ => each.clone().flat_map(|sides| &**sides).cloned().collect(),
    };
    let ends = ends(&sides, each.next().map_or(0, |first| first.len()));
    (Some(sides).filter(|sides| !sides.is_empty()), ends)
}

/// The first side of a chain and its last one, of which the first link has so many components.
fn ends(sides: &[Pair], components: usize) -> Vec<Pair> {
    let Some(last) = sides.len().checked_sub(components).filter(|&at| at > 0) else {
        return vec![];
    };
    let ends = sides[..components].iter().zip(&sides[last..]);
    ends.map(|((left, _), (_, right))| (left.clone(), right.clone()))
        .collect()
}

fn equations(said: &Said) -> Vec<(Fraction, Source)> {
    let sides = said.sides.iter().flat_map(|sides| &**sides);
    let differences = sides.map(|(left, right)| left.clone() - right.clone());
    let source = || Source::Line(None, 0);
    differences.map(|equation| (equation, source())).collect()
}
