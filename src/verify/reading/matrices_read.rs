//! Letters that are made of a matrix, its trace, its inverse and its columns, and operators that take components.

use crate::notation::ast::{Kind, Node};
use crate::notation::document::Row;
use crate::notation::print::latex;
use crate::notation::{Macros, read_formula};
use crate::verify::language::heads::{COFACTORS, TRANSPOSED_ROW};
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Term};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::{letter_of, node_of};
use crate::verify::term::letters::{Meaning, Operator, spelled};
use crate::verify::term::quantity::Quantity;

impl Builder<'_> {
    /// "`$s$` is the trace of `$C$`", "`$H$` is the inverse of `$T$`": that of the letter, whatever it is.
    pub(super) fn read_made_of(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        if let Some(Term::Phrase(of)) = what.slot(Slot::Of)
            && matrix_in(what).is_none()
        {
            return self.read_inverse_of(subjects, what, of, declaration);
        }
        let matrix = matrix_in(what)?;
        if what.head == TRANSPOSED_ROW {
            return self.read_columns_of_matrix(subjects, what, declaration);
        }
        let [Term::Formula(letter)] = subjects else {
            return None;
        };
        // "`$T^{-1}$` is the inverse of `$T$`" says no more than the writing does.
        if is_made_by_writing(letter, what.head, matrix) {
            return Some(());
        }
        if spelled(matrix) == spelled(node_of(letter)?) {
            return None;
        }
        let text = latex(matrix);
        let made = written(&match what.head {
            "trace" => format!("\\operatorname{{tr}}\\left({text}\\right)"),
            "determinant" => format!("\\det\\left({text}\\right)"),
            "inverse" => format!("\\left({text}\\right)^{{-1}}"),
            "transpose" => format!("\\left({text}\\right)^{{T}}"),
            "adjugate" => format!("\\det\\left({text}\\right)\\left({text}\\right)^{{-1}}"),
            COFACTORS => format!(
                "\\det\\left({text}\\right)\\left(\\left({text}\\right)^{{-1}}\\right)^{{T}}"
            ),
            _ => return None,
        })?;
        self.denote(letter, Meaning::Same(Box::new(made)), declaration);
        Some(())
    }

    /// "the inverse of the inertia tensor of the body about G": of what a noun names.
    fn read_inverse_of(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        of: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let of = self.quantity(of, declaration)?;
        let value = self.system().value_of(&of).ok()?;
        let ground = self.reading.letters.component_frame;
        let made = match what.head {
            "trace" => self.system().trace(&value, ground),
            "inverse" => self.system().inverse(&value),
            "transpose" => Ok(value.transposed()),
            _ => return None,
        };
        let made = Meaning::Quantity(Quantity::Known(made.ok()?));
        for letter in formulas(subjects) {
            self.denote(letter, made.clone(), declaration);
        }
        Some(())
    }

    /// "`$q_1$`, `$q_2$`, `$q_3$` are the columns of `$Q$`", "`$v$` is the third column of `$Q$`".
    pub(super) fn read_columns_of_matrix(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let matrix = matrix_in(what)?;
        let letters: Vec<&Formula> = formulas(subjects).collect();
        let all = letters.len() == subjects.len();
        let first = match (what.slot(Slot::Which), letters.len()) {
            (None, 3) => 1,
            (Some(Term::Numbers(which)), 1) => match which[..] {
                [which @ 1..=3] => which,
                _ => return None,
            },
            _ => return None,
        };
        // One of another size has other columns.
        let value = self.mentioned_value(&Formula::of(matrix), declaration);
        if !all || value.is_some_and(|value| !value.is_matrix()) {
            return None;
        }
        let turned = if what.head == TRANSPOSED_ROW {
            "^{T}"
        } else {
            ""
        };
        for (place, letter) in letters.into_iter().enumerate() {
            let chosen = (1..=3).map(|row| usize::from(row == first + place).to_string());
            let chosen = chosen.collect::<Vec<_>>().join(",");
            let text = latex(matrix);
            let column = written(&format!(
                "\\left({text}\\right){turned}\\left({chosen}\\right)"
            ))?;
            self.denote(letter, Meaning::Same(Box::new(column)), declaration);
        }
        Some(())
    }

    /// "`$C_B(v)$` means the components of `$v$` on B, for any vector `$v$`."
    pub(super) fn read_components_or_operator(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        if what.slot(Slot::ForAny).is_none() {
            return self.read_components(subjects, what, declaration);
        }
        let read = self.take_components(subjects, what, declaration);
        read.unwrap_or_else(|| self.say_unused(declaration));
    }

    fn take_components(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let [Term::Formula(written)] = subjects else {
            return None;
        };
        let any: Vec<String> = what.all(Slot::ForAny).filter_map(spelled_letter).collect();
        let of = spelled_letter(what.slot(Slot::Of)?)?;
        let (head, argument) = match &node_of(written)?.kind {
            Kind::Call(head, arguments) => match arguments.as_slice() {
                [argument] => (&**head, argument),
                _ => return None,
            },
            Kind::Product(factors) => match factors.as_slice() {
                [head, argument] => (&head.node, &argument.node),
                _ => return None,
            },
            _ => return None,
        };
        let argument = match &argument.kind {
            Kind::Group(_, inner) => inner,
            _ => argument,
        };
        let frame = self.frame(what.slot(Slot::On)?)?;
        if any != [of.clone()] || spelled(argument) != of {
            return None;
        }
        let operator = Meaning::Operator(Operator::ComponentsOn(frame));
        self.denote(&Formula::of(head), operator, declaration);
        Some(())
    }
}

/// Whether a noun says what is made of a matrix.
pub(super) fn is_made_of_matrix(head: &str) -> bool {
    let one_word = matches!(
        head,
        "trace" | "determinant" | "inverse" | "transpose" | "adjugate"
    );
    one_word || head == TRANSPOSED_ROW || head == COFACTORS
}

/// The letter of the matrix that a noun is of.
fn matrix_in(what: &NounPhrase) -> Option<&Node> {
    let mut of = what.all(Slot::Of);
    let (only, more) = (of.next()?, of.next());
    letter_of(only).and_then(node_of).filter(|_| more.is_none())
}

/// A formula as it stands in a document.
fn written(text: &str) -> Option<Node> {
    match read_formula(text, 0, &Macros::default()).pop()? {
        Row::Expression(node) => Some(node),
        _ => None,
    }
}

/// Whether a formula writes the inverse or the transpose of a matrix.
fn is_made_by_writing(letter: &Formula, head: &str, matrix: &Node) -> bool {
    let base = match node_of(letter).map(|node| &node.kind) {
        Some(Kind::Power(base, exponent)) if head == "inverse" && exponent.is_minus_one() => base,
        Some(Kind::Transpose(base)) if head == "transpose" => base,
        Some(Kind::Function(_, base)) if matches!(head, "trace" | "determinant") => base,
        _ => return false,
    };
    let base = match &base.kind {
        Kind::Group(_, inner) => inner,
        _ => base,
    };
    spelled(base) == spelled(matrix)
}

fn spelled_letter(term: &Term) -> Option<String> {
    letter_of(term).and_then(node_of).map(spelled)
}
