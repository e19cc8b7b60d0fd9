//! What hangs on massless rods and strings: it stays at their length from where they are held, and they pull along themselves.

use super::heads::{CONSTANT, FORCE, FRICTION, UNIT_VECTOR, WEIGHT, WITHOUT_FRICTION};
use super::kinds::{is_said_to_be_body, name};
use super::one_thing::is_letter;
use super::reader::formula;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term, slot};
use crate::notation::Macros;

/// The noun of the pull of a rod.
const TENSION: &str = "tension";

/// A massless rod with what hangs on it.
struct Tie {
    /// The noun by which the rod is called.
    called: String,
    hanging: Term,
    from: Term,
    length: Term,
    /// The letter of its pull.
    pull: Term,
    declaration: Declaration,
    /// The same sentence about the rod itself.
    rod: Statement,
}

/// "P hangs from O by a massless rod of length `$l$`": P is at the distance l from O, and "the rod" is the line between them.
pub(crate) fn tell_suspended(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let ties: Vec<Tie> = declarations
        .iter()
        .filter_map(|d| tie(d, declarations, macros))
        .collect();
    if ties.is_empty() {
        return;
    }
    let free = moves_freely(declarations);
    declarations.retain(|d| {
        let of_tie = |tie: &Tie| {
            let rod = d.statement == tie.rod && d.text == tie.declaration.text;
            rod || *d == tie.declaration
        };
        let smooth =
            matches!(&d.statement, Statement::Premise(p) if p.head == FRICTION && p.is("no"));
        !smooth && !ties.iter().any(of_tie)
    });
    incline_each(declarations, &ties);
    for declaration in declarations.iter_mut() {
        pull_along(&mut declaration.statement, &ties);
        if let Statement::Is { what, .. } = &mut declaration.statement
            && what.head == "angle"
        {
            let terms = what.slots.iter_mut();
            terms.for_each(|(_, term)| draw_line(term, &ties));
        }
    }
    for tie in &ties {
        let told = statements(tie, declarations);
        declarations.extend(told.into_iter().map(|said| tie.declaration.saying(said)));
        if free {
            let loads = only_loads(tie, &ties, declarations, macros);
            declarations.extend(loads.into_iter().map(|said| tie.declaration.saying(said)));
        }
    }
}

/// A rod of which a sentence says that something hangs on it.
fn tie(declaration: &Declaration, all: &[Declaration], macros: &Macros) -> Option<Tie> {
    let (subjects, slots) = declaration.statement.does("hang")?;
    let ([hanging], Some(from), Some(Term::Name(called))) =
        (subjects, slot(slots, Slot::From), slot(slots, Slot::By))
    else {
        return None;
    };
    let rod = all.iter().find(|d| {
        let rod = d
            .statement
            .subjects()
            .iter()
            .any(|s| name(s).as_ref() == Some(called));
        rod && d.text == declaration.text
    })?;
    let Statement::Is { what: sized, .. } = &rod.statement else {
        return None;
    };
    let length = sized.size("length")?;
    let own = all.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if is_pull(what, called) => subjects.first(),
        _ => None,
    });
    let number = all.iter().position(|d| d == declaration)?;
    let new = || letter(&format!("S_{{rod,{number}}}"), macros);
    // "A massless rod joins O to P": what is fixed does not hang.
    let fixed = is_fixed_point(hanging, all) && !is_fixed_point(from, all);
    let (hanging, from) = match fixed {
        true => (from, hanging),
        false => (hanging, from),
    };
    Some(Tie {
        called: called.clone(),
        hanging: hanging.clone(),
        from: from.clone(),
        length: length.clone(),
        pull: own.cloned().or_else(new)?,
        declaration: declaration.clone(),
        rod: rod.statement.clone(),
    })
}

/// Whether a sentence says that something is a point fixed in a frame.
fn is_fixed_point(term: &Term, all: &[Declaration]) -> bool {
    all.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            let fixed = what.slot(Slot::FixedIn).is_some() || what.is("fixed");
            subjects.contains(term) && fixed && matches!(what.head, "point" | "fixed")
        }
        _ => false,
    })
}

/// Whether the pull of a rod has a letter of its own.
fn is_one_letter(pull: &Term) -> bool {
    matches!(pull, Term::Formula(letter) if is_letter(letter))
}

fn letter(source: &str, macros: &Macros) -> Option<Term> {
    formula(source, false, macros).map(Term::Formula)
}

/// "the tension of the rod", "the force of the string on P"
fn is_pull(what: &NounPhrase, rod: &str) -> bool {
    let of = |term: &Term| match term {
        Term::Name(name) => name == rod,
        Term::Phrase(thing) => thing.head == rod,
        Term::Formula(_) | Term::Member { .. } | Term::Numbers(_) => false,
    };
    matches!(what.head, TENSION | FORCE) && what.all(Slot::Of).any(of)
}

/// Whether sentences count the loads, or say that there is no friction.
fn moves_freely(declarations: &[Declaration]) -> bool {
    declarations.iter().any(|d| match &d.statement {
        Statement::Premise(premise) => premise.is("only") || premise.is("no"),
        Statement::Does { slots, .. } => slots.iter().any(|(_, how)| how.is_noun(WITHOUT_FRICTION)),
        _ => false,
    })
}

/// "the angles of the rods from the downward vertical": those of the lines, in their order.
fn incline_each(declarations: &mut [Declaration], ties: &[Tie]) {
    for declaration in declarations {
        if let Statement::Is { what, .. } = &mut declaration.statement
            && what.head == "angle"
            && let Some(at) = what.slots.iter().position(|(_, of)| is_each(of, ties))
        {
            what.slots.remove(at);
            let lines = ties.iter().map(|tie| (Slot::To, line(tie)));
            what.slots.extend(lines);
        }
    }
}

/// "the rods", of more than one.
fn is_each(term: &Term, ties: &[Tie]) -> bool {
    let plural = |tie: &Tie| match term {
        Term::Name(name) => *name == format!("{}s", tie.called),
        Term::Phrase(all) => all.head == tie.called,
        Term::Formula(_) | Term::Member { .. } | Term::Numbers(_) => false,
    };
    ties.len() > 1 && ties.iter().all(plural)
}

/// Puts the line between its ends in the place of the only rod.
fn draw_line(term: &mut Term, ties: &[Tie]) {
    let [tie] = ties else { return };
    let called = match &*term {
        Term::Name(name) => *name == tie.called,
        Term::Phrase(thing) => thing.head == tie.called && thing.slots.is_empty(),
        _ => false,
    };
    if called {
        *term = line(tie);
    }
}

/// "the line from O to P"
fn line(tie: &Tie) -> Term {
    along(tie, "axis")
}

/// What leads from where a rod is held to what hangs on it.
fn along(tie: &Tie, noun: &'static str) -> Term {
    let ends = vec![
        (Slot::From, tie.from.clone()),
        (Slot::To, tie.hanging.clone()),
    ];
    Term::Phrase(Box::new(NounPhrase::new(noun, ends)))
}

/// The pull of the only rod is a load by its letter.
fn pull_along(statement: &mut Statement, ties: &[Tie]) {
    let [tie] = ties else { return };
    match statement {
        Statement::Is { subjects, what }
            if is_pull(what, &tie.called) && subjects.contains(&tie.pull) =>
        {
            let noun = match is_one_letter(&tie.pull) {
                true => TENSION,
                false => FORCE,
            };
            *what = NounPhrase::new(noun, vec![(Slot::At, tie.hanging.clone())]);
        }
        Statement::Premise(premise) if premise.is("only") => {
            for (_, term) in &mut premise.slots {
                if matches!(&*term, Term::Phrase(load) if is_pull(load, &tie.called)) {
                    term.clone_from(&tie.pull);
                }
            }
        }
        _ => {}
    }
}

/// What a rod says of what hangs on it.
fn statements(tie: &Tie, declarations: &[Declaration]) -> Vec<Statement> {
    let between = vec![
        (Slot::Of, tie.hanging.clone()),
        (Slot::RelativeTo, tie.from.clone()),
    ];
    let distance = NounPhrase::new("distance", between);
    let constant = NounPhrase::new(CONSTANT, vec![]);
    let pull = NounPhrase::new(TENSION, vec![(Slot::At, tie.hanging.clone())]);
    let told = |wanted: &Term| {
        declarations
            .iter()
            .any(|d| d.statement.subjects().contains(wanted))
    };
    let particle = Statement::one_is(tie.hanging.clone(), NounPhrase::new("particle", vec![]));
    let mut said = vec![
        Statement::one_is(tie.length.clone(), distance),
        Statement::one_is(tie.length.clone(), constant),
    ];
    // A formula says along what the rod pulls.
    if is_one_letter(&tie.pull) {
        said.push(Statement::Does {
            subjects: vec![tie.pull.clone()],
            verb: "point",
            slots: vec![(Slot::With, along(tie, UNIT_VECTOR))],
        });
    }
    if !told(&tie.pull) {
        said.push(Statement::one_is(tie.pull.clone(), pull));
    }
    if !is_said_to_be_body(&tie.hanging, declarations) {
        said.push(particle);
    }
    said
}

/// "Its weight and the pulls of the rods are the only forces on what hangs", where no sentence says it.
fn only_loads(
    tie: &Tie,
    ties: &[Tie],
    declarations: &[Declaration],
    macros: &Macros,
) -> Vec<Statement> {
    let counted = declarations.iter().any(|d| match &d.statement {
        Statement::Premise(premise) => {
            premise.is("only") && premise.all(Slot::Of).any(|of| *of == tie.hanging)
        }
        _ => false,
    });
    if counted {
        return vec![];
    }
    let weight = Term::Phrase(Box::new(NounPhrase::new(WEIGHT, vec![])));
    let of = (Slot::Of, tie.hanging.clone());
    let mut slots = vec![of, (Slot::With, weight), (Slot::With, tie.pull.clone())];
    let mut said = vec![];
    for other in ties.iter().filter(|other| other.from == tie.hanging) {
        let Some((back, told)) = pull_back(other, macros) else {
            return vec![];
        };
        slots.push((Slot::With, back));
        said.extend(told);
    }
    let mut premise = NounPhrase::new(FORCE, slots);
    premise.adjectives.push("only");
    said.push(Statement::Premise(premise));
    said
}

/// A rod pulls as much at the thing from which it hangs, towards what hangs on it.
fn pull_back(tie: &Tie, macros: &Macros) -> Option<(Term, Vec<Statement>)> {
    let Term::Formula(pull) = &tie.pull else {
        return None;
    };
    let source = format!("R_{{{}}}", pull.source);
    let back = letter(&source, macros)?;
    let equal = format!("{source}={}", pull.source);
    let at = NounPhrase::new(TENSION, vec![(Slot::At, tie.from.clone())]);
    let said = vec![
        Statement::one_is(back.clone(), at),
        Statement::Does {
            subjects: vec![back.clone()],
            verb: "point",
            slots: vec![(Slot::Along, along(tie, UNIT_VECTOR))],
        },
        Statement::Holds(formula(&equal, false, macros)?),
    ];
    Some((back, said))
}
