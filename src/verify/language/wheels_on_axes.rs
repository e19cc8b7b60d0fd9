//! Wheels by their names: each turns about its own axis, where no sentence tells that axis otherwise.

use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// Bodies that are made to turn about their own axes.
const WHEELS: [&str; 7] = [
    "wheel",
    "flywheel",
    "pulley",
    "turntable",
    "gear",
    "drum",
    "roller",
];

/// Shapes that are round about one axis.
const ROUND: [&str; 4] = ["disc", "ring", "cylinder", "tube"];

/// Nouns of the line about which a body is round.
const AXES: [&str; 3] = ["axis", "symmetry axis", "spin axis"];

/// "The pulley is a uniform disc. It turns about z": it is symmetric about z.
pub(super) fn turn_wheels_about_their_axes(declarations: &mut Vec<Declaration>) {
    let round: Vec<Declaration> = declarations
        .iter()
        .filter_map(|declaration| symmetric(declaration, declarations))
        .collect();
    declarations.extend(round);
}

fn symmetric(declaration: &Declaration, all: &[Declaration]) -> Option<Declaration> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return None;
    };
    let [body] = subjects.as_slice() else {
        return None;
    };
    let called = name(body)?;
    let wheel = called.split(' ').any(|word| WHEELS.contains(&word));
    if !wheel || !ROUND.contains(&what.head) || all.iter().any(|d| tells_axis(body, d)) {
        return None;
    }
    let mut turns = all.iter().filter_map(|d| axis_of_turn(body, d, all));
    let axis = turns
        .next()
        .filter(|axis| turns.all(|other| other == *axis))?;
    let about = vec![(Slot::About, axis.clone())];
    Some(declaration.saying(Statement::one_is(
        body.clone(),
        NounPhrase::new("symmetric", about),
    )))
}

/// Whether a sentence says about what a body is round, or along what it lies.
fn tells_axis(body: &Term, declaration: &Declaration) -> bool {
    let own =
        |phrase: &NounPhrase| AXES.contains(&phrase.head) && phrase.slot(Slot::Of) == Some(body);
    let named = |term: &Term| matches!(term, Term::Phrase(phrase) if own(phrase));
    match &declaration.statement {
        Statement::Is { subjects, what } => {
            let symmetric = what.head == "symmetric" && subjects.contains(body);
            symmetric || own(what) || subjects.iter().any(named)
        }
        Statement::Does {
            subjects,
            verb: "lie" | "point",
            ..
        } => subjects.contains(body) || subjects.iter().any(named),
        _ => false,
    }
}

/// The direction about which a sentence says that a body turns, or a frame that is fixed in it.
fn axis_of_turn<'d>(
    body: &Term,
    declaration: &'d Declaration,
    all: &[Declaration],
) -> Option<&'d Term> {
    let (subjects, slots) = declaration.statement.does("turn")?;
    let frame_of_body = |frame: &Term| {
        all.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                let fixed = what.head == "frame" && what.slot(Slot::FixedIn) == Some(body);
                fixed && subjects.contains(frame)
            }
            _ => false,
        })
    };
    if !subjects.iter().any(|own| own == body || frame_of_body(own)) {
        return None;
    }
    match slots
        .iter()
        .find(|(slot, _)| *slot == Slot::About)
        .map(|(_, about)| about)?
    {
        Term::Phrase(axis) => axis.slot(Slot::Along),
        about => Some(about),
    }
}
