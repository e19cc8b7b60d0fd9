//! Letters with an index at the end of a list of components: "`$w_1$, $w_2$, $w_3$ and $w_j$` are the components of w".

use super::heads::PRINCIPAL_MOMENTS;
use super::reader::formula;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::notation::Macros;
use crate::notation::ast::{Kind, Symbol};

/// Nouns of which a list has one for each axis.
const OF_EACH_AXIS: [&str; 2] = ["component", PRINCIPAL_MOMENTS];

/// Says of each such letter by itself that it is the component with its index, where sentences say that this numbers axes.
pub(crate) fn part_indexed(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let indices = indices_of_axes(declarations);
    if indices.is_empty() {
        return;
    }
    let mut added = vec![];
    for declaration in declarations.iter_mut() {
        let Statement::Is { subjects, what } = &declaration.statement else {
            continue;
        };
        let index = |term: &Term| letter_and_index(term).map(|(_, index)| index);
        let own = |term: &Term| index(term).filter(|index| indices.contains(index));
        let (indexed, plain): (Vec<Term>, Vec<Term>) = subjects
            .iter()
            .cloned()
            .partition(|term| own(term).is_some());
        let listed = OF_EACH_AXIS.contains(&what.head) && what.slot(Slot::Which).is_none();
        if !listed || indexed.is_empty() || plain.len() < 2 {
            continue;
        }
        for letter in indexed {
            let index = own(&letter).and_then(|index| formula(&index, false, macros));
            let said = index.map(|index| one_of(letter, what, index));
            added.extend(said.map(|said| declaration.saying(said)));
        }
        let what = what.clone();
        declaration.statement = Statement::Is {
            subjects: plain,
            what,
        };
    }
    declarations.extend(added);
}

/// "`$w_j$` is the component `$j$` of w"
fn one_of(letter: Term, what: &NounPhrase, index: Formula) -> Statement {
    let mut what = what.clone();
    what.slots.insert(0, (Slot::Which, Term::Formula(index)));
    Statement::one_is(letter, what)
}

/// The letters that sentences say to number axes.
pub(crate) fn indices_of_axes(declarations: &[Declaration]) -> Vec<String> {
    let axes = |(_, term): &(Slot, Term)| matches!(term, Term::Phrase(p) if p.head == "axes");
    let numbering = declarations
        .iter()
        .filter_map(|d| d.statement.does("number"));
    let numbering = numbering.filter(|(_, slots)| slots.iter().any(axes));
    let letters = numbering.flat_map(|(letters, _)| letters);
    let name = |letter: &Term| symbol(letter).map(|symbol| symbol.name.clone());
    letters.filter_map(name).collect()
}

/// The letter and the index of what is written by one with an index, and no other label: `$F_\alpha$`.
pub(crate) fn letter_and_index(term: &Term) -> Option<(String, String)> {
    let symbol = symbol(term).filter(|symbol| symbol.superscripts.is_empty())?;
    match symbol.subscripts.as_slice() {
        [index] => Some((symbol.name.clone(), index.clone())),
        _ => None,
    }
}

fn symbol(term: &Term) -> Option<&Symbol> {
    let Term::Formula(letter) = term else {
        return None;
    };
    match &letter.node()?.kind {
        Kind::Symbol(symbol) => Some(symbol),
        _ => None,
    }
}
