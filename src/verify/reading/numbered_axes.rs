//! Axes by a letter that numbers them.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::language::heads::TRANSPOSED_ROW;
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::reading::names::{index_letter, node_of};
use crate::verify::term::indices::with_number;

/// The numbers of the axes of a frame.
const NUMBERS: [&str; 3] = ["1", "2", "3"];

/// The sentences, where "`$b_i$` are the axes of B" and "`$b_i$` is the axis `$i$` of B" say that `$b_1, b_2, b_3$` are the
/// axes of B and that i numbers them.
pub(super) fn with_numbered_axes(declarations: Vec<Declaration>) -> Vec<Declaration> {
    let mut numbering: Vec<String> = declarations.iter().flat_map(indices).collect();
    let mut told = vec![];
    for declaration in declarations {
        let Some(axes) = Axes::of(&declaration) else {
            told.push(declaration);
            continue;
        };
        told.push(declaration.saying(axes.named()));
        if !numbering.contains(&axes.index) {
            numbering.push(axes.index.clone());
            told.push(declaration.saying(axes.numbered()));
        }
    }
    told
}

/// The letters that a sentence says to number something.
fn indices(declaration: &Declaration) -> Vec<String> {
    let numbers = declaration.statement.does("number");
    let letters = numbers.into_iter().flat_map(|(letters, _)| letters);
    let index = |letter: &Term| match letter {
        Term::Formula(letter) => Some(index_letter(letter)),
        _ => None,
    };
    letters.filter_map(index).collect()
}

/// The axes of a frame by one letter with an index.
struct Axes<'d> {
    letter: &'d Node,
    index: String,
    what: NounPhrase,
}

impl<'d> Axes<'d> {
    fn of(declaration: &'d Declaration) -> Option<Self> {
        let Statement::Is { subjects, what } = &declaration.statement else {
            return None;
        };
        let [Term::Formula(letter)] = subjects.as_slice() else {
            return None;
        };
        let letter = node_of(letter)?;
        let Kind::Symbol(symbol) = &letter.kind else {
            return None;
        };
        let index = symbol.subscripts.last()?;
        let own = match (what.head, what.slot(Slot::Which)) {
            ("axes", None) => index.chars().all(char::is_alphabetic) && index.len() == 1,
            ("axis", Some(Term::Formula(which))) => index_letter(which) == *index,
            ("column" | TRANSPOSED_ROW, Some(Term::Formula(which))) => {
                index_letter(which) == *index && what.slot(Slot::Of).is_some()
            }
            _ => false,
        };
        own.then(|| Self {
            letter,
            index: index.clone(),
            what: all_axes(what),
        })
    }

    fn with(&self, change: impl Fn(&Symbol) -> Symbol) -> Term {
        let mut node = self.letter.clone();
        node.change_symbols(&mut |symbol| *symbol = change(symbol));
        Term::Formula(Formula::of(&node))
    }

    fn named(&self) -> Statement {
        let axes = NUMBERS.map(|number| self.with(|symbol| with_number(symbol, number)));
        Statement::Is {
            subjects: axes.into(),
            what: self.what.clone(),
        }
    }

    /// Columns are counted as the axes are.
    fn counted(&self) -> NounPhrase {
        match self.what.head {
            "axes" => self.what.clone(),
            _ => NounPhrase::new("axes", vec![]),
        }
    }

    fn numbered(&self) -> Statement {
        let index = self.with(|_| Symbol {
            name: self.index.clone(),
            ..Symbol::default()
        });
        Statement::Does {
            subjects: vec![index],
            verb: "number",
            slots: vec![(Slot::Of, Term::Phrase(Box::new(self.counted())))],
        }
    }
}

/// "The axis `$i$` of B", "the column `$i$` of `$Q$`": the axes of B, the columns of Q.
fn all_axes(axis: &NounPhrase) -> NounPhrase {
    let slots = axis.slots.iter();
    let slots = slots.filter(|(slot, _)| *slot != Slot::Which);
    NounPhrase {
        head: match axis.head {
            "axis" => "axes",
            head => head,
        },
        adjectives: axis.adjectives.clone(),
        slots: slots.cloned().collect(),
    }
}
