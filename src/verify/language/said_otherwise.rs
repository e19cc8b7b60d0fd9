//! Sums of letters, planes of symmetry, speeds of what moves, and potential energies counted from a surface, in the terms of
//! other sentences.

use super::heads::{CONTACT_POINT, PLANE_OF_SYMMETRY, POTENTIAL_ENERGY};
use super::is_quantity;
use super::reader::formula;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::notation::Macros;

/// The noun of how fast a point moves, by which a letter behind "with" is one.
const SPEED: &str = "speed";

/// Brings them to these terms.
pub(crate) fn say_plainly(declarations: &mut Vec<Declaration>, macros: &Macros) {
    for declaration in declarations.iter_mut() {
        let other =
            vector_of(&declaration.statement).or_else(|| plane_first(&declaration.statement));
        if let Some(other) = other {
            declaration.statement = other;
        }
    }
    let told = declarations.drain(..).flat_map(|declaration| {
        match equations(&declaration.statement, macros) {
            Some(said) => said.into_iter().map(|s| declaration.saying(s)).collect(),
            None => vec![declaration],
        }
    });
    let told: Vec<Declaration> = told.collect();
    *declarations = told;
    let mut told = Vec::with_capacity(declarations.len());
    for mut declaration in declarations.drain(..) {
        let names_speed = declaration.text.contains(SPEED);
        let speed = names_speed.then(|| take_speed(&mut declaration.statement));
        let speed = speed.flatten().map(|speed| declaration.saying(speed));
        told.push(declaration);
        told.extend(speed);
    }
    *declarations = told;
    let zeros: Vec<Option<Statement>> = declarations
        .iter()
        .map(|d| zero_on_surface(&d.statement, declarations))
        .collect();
    for (declaration, zero) in declarations.iter_mut().zip(zeros) {
        if let Some(zero) = zero {
            declaration.statement = zero;
        }
    }
}

/// "`$E$` is the sum of `$T$` and `$V$`": E = T + V. "`$a$` and `$b$` are the squares of `$c$` and `$d$`": each is that of its
/// own. The change of two letters is their difference.
fn equations(statement: &Statement, macros: &Macros) -> Option<Vec<Statement>> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let source = |term: &Term| match term {
        Term::Formula(part) => Some(part.source.clone()),
        _ => None,
    };
    let parts = what.slots.iter().map(|(slot, term)| match slot {
        Slot::Of => source(term),
        _ => None,
    });
    let parts: Vec<String> = parts.collect::<Option<_>>()?;
    let letters: Vec<String> = subjects.iter().map(source).collect::<Option<_>>()?;
    let of_one = |sides: Vec<String>| (letters.len() == 1).then_some(sides);
    let sides = match (what.head, parts.as_slice()) {
        ("sum", [_, _, ..]) => of_one(vec![parts.join("+")])?,
        ("change", [one, other]) => of_one(vec![format!("{one}-({other})")])?,
        ("square", [_, ..]) => parts.iter().map(|part| format!("({part})^2")).collect(),
        _ => return None,
    };
    let equation = |(letter, side): (&String, &String)| {
        formula(&format!("{letter}={side}"), false, macros).map(Statement::Holds)
    };
    let pairs = letters.len() == sides.len() && what.adjectives.is_empty();
    pairs.then(|| letters.iter().zip(&sides).map(equation).collect())?
}

/// "`$g$` is the vector of the acceleration of gravity on N": it is that acceleration.
fn vector_of(statement: &Statement) -> Option<Statement> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let [(Slot::Of, Term::Phrase(quantity)), others @ ..] = what.slots.as_slice() else {
        return None;
    };
    let plain = what.head == "vector" && what.adjectives.is_empty();
    (plain && is_quantity(quantity.head)).then(|| Statement::Is {
        subjects: subjects.clone(),
        what: NounPhrase {
            slots: [quantity.slots.as_slice(), others].concat(),
            ..(**quantity).clone()
        },
    })
}

/// "The plane of symmetry of the aircraft is the plane of x and z": that plane is one of symmetry.
fn plane_first(statement: &Statement) -> Option<Statement> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    match (subjects.as_slice(), what.head) {
        ([Term::Phrase(of_symmetry)], "plane") if of_symmetry.head == PLANE_OF_SYMMETRY => {
            let plane = Term::Phrase(Box::new(what.clone()));
            Some(Statement::one_is(plane, (**of_symmetry).clone()))
        }
        _ => None,
    }
}

/// "P moves along the table relative to N with the speed `$v$`": v is its speed, where the sentence has this noun.
fn take_speed(statement: &mut Statement) -> Option<Statement> {
    let Statement::Does {
        subjects,
        verb: "move",
        slots,
    } = statement
    else {
        return None;
    };
    let [mover] = subjects.as_slice() else {
        return None;
    };
    let speed = |said: &(Slot, Term)| matches!(said, (Slot::With, Term::Formula(_)));
    let at = slots.iter().position(speed)?;
    let relative = slots.iter().filter(|(slot, _)| *slot == Slot::RelativeTo);
    let of = std::iter::once((Slot::Of, mover.clone()));
    let what = NounPhrase::new(SPEED, of.chain(relative.cloned()).collect());
    let (_, letter) = slots.remove(at);
    // Along a thing it moves anyhow.
    slots.retain(|said| !matches!(said, (Slot::Along, Term::Name(_))));
    Some(Statement::one_is(letter, what))
}

/// "`$V$` is zero on the table", of a potential energy: it is zero where the body touches that.
fn zero_on_surface(statement: &Statement, declarations: &[Declaration]) -> Option<Statement> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let ([letter], "zero", [(Slot::At, surface)]) =
        (subjects.as_slice(), what.head, what.slots.as_slice())
    else {
        return None;
    };
    let body = declarations.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == POTENTIAL_ENERGY => subjects
            .contains(letter)
            .then(|| what.slot(Slot::Of))
            .flatten(),
        _ => None,
    })?;
    let point = declarations.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == CONTACT_POINT => {
            let own = what.all(Slot::Of).any(|of| of == body);
            let there = what.slot(Slot::On) == Some(surface);
            (own && there).then(|| subjects.first()).flatten()
        }
        _ => None,
    })?;
    let of = [(Slot::Of, body.clone()), (Slot::At, point.clone())];
    let mut zero = NounPhrase::new(POTENTIAL_ENERGY, of.to_vec());
    zero.adjectives.push("zero");
    Some(Statement::Premise(zero))
}
