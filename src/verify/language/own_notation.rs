//! Sentences about writing that say in the author's own signs what a rule of notation says, and those that say nothing new.

use super::heads::{FRAME_BEFORE_RATE, RATE_FROM_FRAME};
use super::rate_letters::{rate_letter, repeats_a_rate};
use super::statement::{
    Declaration, Formula, NotationMeaning, NounPhrase, Sign, Slot, Statement, Term,
};
use crate::notation::ast::{Kind, Symbol};
use crate::notation::document::Row;
use crate::notation::print::latex;

/// "`\frac{^X d}{dt}` is the rate seen from X, for any frame X" is the rule for a frame at the upper left of a rate; "`a_{b}` is
/// the same as `a_b`" needs no sentence.
pub(crate) fn tell_own_notation(declarations: &mut Vec<Declaration>) {
    declarations.retain(|declaration| !is_written_alike(&declaration.statement));
    let rates: Vec<Symbol> = declarations.iter().filter_map(rate_letter).collect();
    declarations.retain(|declaration| !repeats_a_rate(declaration, &rates));
    leave_equal_signs(declarations);
    for declaration in declarations {
        if let Some(rule) = rule_by_example(&declaration.statement) {
            declaration.statement = rule;
        }
        let Statement::Notation {
            sign,
            meaning: meaning @ NotationMeaning::Noun(_),
        } = &mut declaration.statement
        else {
            continue;
        };
        let (Sign::Operator(written), NotationMeaning::Noun(rate)) = (&*sign, &*meaning) else {
            continue;
        };
        if frame_of_rate(rate).is_some_and(|frame| bears(&written.source, frame)) {
            *sign = Sign::Custom(FRAME_BEFORE_RATE);
            *meaning = NotationMeaning::Fixed(RATE_FROM_FRAME);
        }
    }
}

/// "`\frac{d'H}{dt}` is the rate of `H` seen from B": so a d with this label is read before any letter.
fn rule_by_example(statement: &Statement) -> Option<Statement> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let ([Term::Formula(written)], "rate", [_, _]) =
        (subjects.as_slice(), what.head, what.slots.as_slice())
    else {
        return None;
    };
    let (of, seen) = (what.slot(Slot::Of)?, what.slot(Slot::SeenFrom)?);
    let Row::Expression(rate) = &written.row else {
        return None;
    };
    let Kind::TimeDerivative {
        operand,
        frame: Some(_),
        ..
    } = &rate.kind
    else {
        return None;
    };
    let of = match of {
        Term::Formula(Formula {
            row: Row::Expression(of),
            ..
        }) => latex(of),
        Term::Name(letter) => letter.clone(),
        _ => return None,
    };
    (of == latex(operand)).then(|| Statement::Notation {
        sign: Sign::Operator(written.clone()),
        meaning: NotationMeaning::Noun(NounPhrase::new(
            "rate",
            vec![(Slot::SeenFrom, seen.clone())],
        )),
    })
}

/// The letter of the frame from which a rate is seen, where it stands for any frame.
fn frame_of_rate(rate: &NounPhrase) -> Option<&str> {
    let (Term::Name(seen), Term::Name(any)) =
        (rate.slot(Slot::SeenFrom)?, rate.slot(Slot::ForAny)?)
    else {
        return None;
    };
    (rate.head == "rate" && seen == any).then_some(seen)
}

/// Whether a derivative in time is written with a letter at its upper left.
fn bears(written: &str, frame: &str) -> bool {
    let plain = bare(written);
    let rate = plain.ends_with("dt");
    let before = plain.split("d").next().unwrap_or_default();
    let before = before
        .trim_start_matches("\\frac")
        .trim_end_matches("\\frac");
    rate && before.strip_prefix('^') == Some(frame)
}

/// Whether a sentence says that formulas are the same that differ in braces and spaces alone.
fn is_written_alike(statement: &Statement) -> bool {
    let Statement::Same { subjects, others } = statement else {
        return false;
    };
    let alike = |pair: (&Term, &Term)| match pair {
        (Term::Formula(a), Term::Formula(b)) => bare(&a.source) == bare(&b.source),
        _ => false,
    };
    let pairs = subjects.len() == others.len() && !subjects.is_empty();
    pairs && subjects.iter().zip(others).all(alike)
}

/// "`^N` and `^{N}` are the same", of signs that cannot stand alone.
fn leave_equal_signs(declarations: &mut Vec<Declaration>) {
    let sign = |d: &Declaration| match &d.statement {
        Statement::Notation {
            sign: Sign::Operator(written),
            meaning: NotationMeaning::Fixed("the same"),
        } => Some((d.line, bare(&written.source))),
        _ => None,
    };
    let all: Vec<(usize, String)> = declarations.iter().filter_map(sign).collect();
    declarations.retain(|d| {
        let Some((line, written)) = sign(d) else {
            return true;
        };
        let mut beside = all.iter().filter(|(other, _)| *other == line);
        let several = beside.clone().count() > 1;
        !(several && beside.all(|(_, other)| *other == written))
    });
}

/// A formula without braces and spaces.
fn bare(written: &str) -> String {
    let kept = written
        .chars()
        .filter(|c| !c.is_whitespace() && !"{}".contains(*c));
    kept.collect()
}
