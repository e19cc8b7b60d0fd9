//! What is said for any frames or points: one sentence for each pair of those that the text names.

use crate::notation::ast::Kind;
use crate::notation::{Macros, read_formula};
use crate::verify::language::indexed_lists::{indices_of_axes, letter_and_index};
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::reading::any_put_in::with_things;
use crate::verify::reading::label_read::named_by_labels;
use crate::verify::reading::names::{EULER_ANGLES, MASS_CENTRE, letter_of, node_of};
use crate::verify::reading::numbered_axes::with_numbered_axes;
use crate::verify::term::written::WrittenSymbols;

/// No more sentences are made of one.
const MOST: usize = 200;

/// Functions of angles for which authors have letters.
const KERNELS: [&str; 3] = ["cosine", "sine", "tangent"];

/// Quantities of which the thing itself is a point.
const OF_POINTS: [&str; 3] = ["position", "velocity", "acceleration"];

/// The declarations with one for each pair of things in the place of what is said for any.
pub(crate) fn instances(
    declarations: &[Declaration],
    written: &WrittenSymbols,
) -> Vec<Declaration> {
    let mut declarations = with_numbered_axes(declarations.to_vec());
    declarations.iter_mut().for_each(name_any);
    declarations.extend(named_by_labels(&declarations, written));
    let declarations = &declarations;
    let frames = named(declarations, |what| what.head == "frame");
    let points = named(declarations, |what| {
        matches!(what.head, "point" | MASS_CENTRE | "particle")
    });
    let angles = angles(declarations);
    let axes = indices_of_axes(declarations);
    let each = declarations.iter().flat_map(|declaration| {
        if let Some(made) = of_each_axis(declaration, &axes) {
            return made;
        }
        if let Some(made) = of_any_angle(declaration, &angles) {
            return made;
        }
        let by_index = any_by_index(&declaration.statement, &frames);
        let by_name = || {
            let any = any_things(&declaration.statement)?;
            let kinds = any.iter().map(|thing| {
                let of_point = stands_for_point(&declaration.statement, thing);
                if of_point {
                    points.clone()
                } else {
                    frames.clone()
                }
            });
            let kinds = kinds.collect();
            Some((any, kinds))
        };
        let Some((any, kinds)) = by_index.or_else(by_name) else {
            return vec![declaration.clone()];
        };
        let kinds: Vec<&Vec<Term>> = kinds.iter().collect();
        let mut made = vec![];
        for chosen in choices(&kinds).into_iter().take(MOST) {
            let statement = with_things(&declaration.statement, &any, &chosen);
            made.extend(statement.map(|statement| Declaration {
                statement,
                ..declaration.clone()
            }));
        }
        made
    });
    each.collect()
}

/// "for any frames `$\\mathcal{X}$` and `$\\mathcal{Y}$`": the letters are the names of frames.
fn name_any(declaration: &mut Declaration) {
    let any = declaration.statement.slots().flatten();
    let any = any.filter(|(slot, _)| *slot == Slot::ForAny);
    let named: Vec<(Term, String)> = any
        .filter_map(|(_, term)| Some((term.clone(), calligraphic(term)?)))
        .collect();
    for term in declaration.statement.terms_mut() {
        if let Some((_, name)) = named.iter().find(|(any, _)| any == term) {
            *term = Term::Name(name.clone());
        }
    }
}

/// The letter of a formula that is one in a font of its own.
fn calligraphic(term: &Term) -> Option<String> {
    let Term::Formula(formula) = term else {
        return None;
    };
    match &node_of(formula)?.kind {
        Kind::Symbol(symbol) if symbol.style.calligraphic => Some(symbol.name.clone()),
        _ => None,
    }
}

/// "`$I_i$` is the moment of inertia about the axis along `$e_i$`", where `$i$` numbers axes: one sentence for each axis.
fn of_each_axis(declaration: &Declaration, indices: &[String]) -> Option<Vec<Declaration>> {
    let Statement::Is { subjects, .. } = &declaration.statement else {
        return None;
    };
    let [Term::Formula(letter)] = subjects.as_slice() else {
        return None;
    };
    let Kind::Symbol(symbol) = &node_of(letter)?.kind else {
        return None;
    };
    let index = symbol
        .subscripts
        .last()
        .filter(|label| indices.contains(label))?;
    let in_label = |term: &Term| match term {
        Term::Formula(formula) => {
            formula.source.contains(&format!("_{index}"))
                || formula.source.contains(&format!("_{{{index}}}"))
        }
        _ => false,
    };
    if !declaration
        .statement
        .terms()
        .into_iter()
        .skip(1)
        .any(in_label)
    {
        return None;
    }
    let one = |number: &str| {
        let things = [Term::Name(number.to_owned())];
        let names = std::slice::from_ref(index);
        let statement = with_things(&declaration.statement, names, &things)?;
        Some(Declaration {
            statement,
            ..declaration.clone()
        })
    };
    ["1", "2", "3"].into_iter().map(one).collect()
}

/// The things that sentences say to be of a kind.
fn named(declarations: &[Declaration], is: impl Fn(&NounPhrase) -> bool) -> Vec<Term> {
    let mut found: Vec<Term> = vec![];
    for declaration in declarations {
        let Statement::Is { subjects, what } = &declaration.statement else {
            continue;
        };
        for subject in subjects {
            let thing = matches!(subject, Term::Name(_) | Term::Formula(_));
            if is(what) && thing && !found.contains(subject) {
                found.push(subject.clone());
            }
        }
    }
    found
}

/// "`$c_\\alpha$` is the cosine of `$\\alpha$`, for any `$\\alpha$`": that of each angle of the text.
fn of_any_angle(declaration: &Declaration, angles: &[Formula]) -> Option<Vec<Declaration>> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return None;
    };
    let [Term::Formula(letter)] = subjects.as_slice() else {
        return None;
    };
    let any = what.all(Slot::ForAny).collect::<Vec<_>>();
    let ([Term::Formula(any)], true) = (any.as_slice(), KERNELS.contains(&what.head)) else {
        return None;
    };
    let one = |angle: &Formula| {
        let source = letter.source.replace(&any.source, &angle.source);
        let row = read_formula(&source, 0, &Macros::default())
            .into_iter()
            .next()?;
        let what = NounPhrase {
            slots: vec![(Slot::Of, Term::Formula(angle.clone()))],
            ..what.clone()
        };
        Some(Declaration {
            statement: Statement::Is {
                subjects: vec![Term::Formula(Formula { source, row })],
                what,
            },
            ..declaration.clone()
        })
    };
    Some(angles.iter().filter_map(one).collect())
}

/// The letters of angles: those that sentences call so, or by which something turns.
fn angles(declarations: &[Declaration]) -> Vec<Formula> {
    let mut found: Vec<Formula> = vec![];
    for declaration in declarations {
        let terms: Vec<&Term> = match &declaration.statement {
            Statement::Is { subjects, what }
                if what.head == EULER_ANGLES || what.head.ends_with("angle") =>
            {
                subjects.iter().collect()
            }
            Statement::Does {
                verb: "turn",
                slots,
                ..
            } => slots
                .iter()
                .filter(|(s, _)| *s == Slot::By)
                .map(|(_, t)| t)
                .collect(),
            _ => vec![],
        };
        for angle in terms.into_iter().filter_map(letter_of) {
            if !found.iter().any(|known| known.source == angle.source) {
                found.push(angle.clone());
            }
        }
    }
    found
}

/// The names for which a sentence speaks of any, where these are things: "for any frames X and Y".
pub(super) fn any_things(statement: &Statement) -> Option<Vec<String>> {
    let slots = match statement {
        Statement::Is { what, .. } => &what.slots,
        Statement::Does {
            verb: "take",
            slots,
            ..
        } => slots,
        _ => return None,
    };
    let any = slots.iter().filter(|(slot, _)| *slot == Slot::ForAny);
    // Vectors and angles stay what they are: "for any frame X and any vector `$v$`".
    let things = any.filter(|(_, term)| !matches!(term, Term::Formula(_)));
    let names: Option<Vec<String>> = things
        .map(|(_, term)| match term {
            Term::Name(name) if name.chars().count() == 1 => Some(name.clone()),
            _ => None,
        })
        .collect();
    names.filter(|names| !names.is_empty() && names.len() <= 3)
}

/// "for any frames `$F_\alpha$` and `$F_\beta$`": the indices, and for each those of the frames with such names.
fn any_by_index(statement: &Statement, frames: &[Term]) -> Option<(Vec<String>, Vec<Vec<Term>>)> {
    let any = statement.slots().flatten();
    let any = any.filter(|(slot, _)| *slot == Slot::ForAny);
    let named: Option<Vec<(String, String)>> =
        any.map(|(_, term)| letter_and_index(term)).collect();
    let named = named.filter(|named| !named.is_empty() && named.len() <= 3)?;
    let own = |(letter, _): &(String, String)| -> Vec<Term> {
        let same = frames.iter().filter_map(letter_and_index);
        let same = same.filter(|(other, _)| other == letter);
        same.map(|(_, index)| Term::Name(index)).collect()
    };
    let kinds: Vec<Vec<Term>> = named.iter().map(own).collect();
    let indices = named.into_iter().map(|(_, index)| index).collect();
    (!kinds.iter().any(Vec::is_empty)).then_some((indices, kinds))
}

/// Whether a name stands where a point does: of a position, or from where it is measured.
pub(super) fn stands_for_point(statement: &Statement, name: &str) -> bool {
    let Statement::Is { what, .. } = statement else {
        return false;
    };
    let of_point = OF_POINTS.contains(&what.head);
    what.slots.iter().any(|(slot, term)| {
        let place = match slot {
            Slot::About => true,
            Slot::Of | Slot::From => of_point,
            Slot::RelativeTo => what.head == OF_POINTS[0],
            _ => false,
        };
        place && matches!(term, Term::Name(n) if n == name)
    })
}

/// Each way to choose one of each kind: of two no thing twice, and of three the last may be one of the others, as the frame is
/// on whose axes components are.
fn choices(kinds: &[&Vec<Term>]) -> Vec<Vec<Term>> {
    let mut chosen: Vec<Vec<Term>> = vec![vec![]];
    for kind in kinds {
        let longer = chosen.iter().flat_map(|before| {
            let others = kind
                .iter()
                .filter(|thing| before.len() == 2 || !before.contains(thing));
            others.map(|thing| [before.as_slice(), std::slice::from_ref(thing)].concat())
        });
        chosen = longer.take(MOST).collect();
    }
    chosen
}
