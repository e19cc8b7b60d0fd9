//! Bodies that turn about their axes of symmetry, where a sentence says in what the axis is fixed and none how the body turns.

use super::heads::{AXES, EULER_ANGLES, MASS_CENTRE, UNIT_VECTOR};
use super::kinds::name;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term};
use super::terms::say_besides;

/// "`$n$` is fixed in A. The disc is symmetric about `$n$`": the disc turns relative to A about n.
pub(crate) fn turn_about_axes_of_symmetry(declarations: &mut Vec<Declaration>) {
    tell_axes_of_shapes(declarations);
    tell_axes_through_points(declarations);
    let spins: Vec<Declaration> = declarations
        .iter()
        .filter_map(|declaration| spin(declaration, declarations))
        .collect();
    declarations.extend(spins);
}

/// "The wheel is a thin disc with its axis along y": it is symmetric about y.
fn tell_axes_of_shapes(declarations: &mut Vec<Declaration>) {
    say_besides(declarations, |statement| {
        let Statement::Is { subjects, what } = statement else {
            return vec![];
        };
        let [body] = subjects.as_slice() else {
            return vec![];
        };
        let axis = |said: &(Slot, Term)| match said {
            (Slot::With, Term::Phrase(axis)) if AXES.contains(&axis.head) => {
                let of_body = axis.slot(Slot::Of).is_none_or(|of| of == body);
                let plain = axis
                    .slots
                    .iter()
                    .all(|(slot, _)| matches!(slot, Slot::Of | Slot::Along));
                axis.slot(Slot::Along).filter(|_| of_body && plain).cloned()
            }
            _ => None,
        };
        let Some((at, along)) = what
            .slots
            .iter()
            .enumerate()
            .find_map(|(at, said)| Some((at, axis(said)?)))
        else {
            return vec![];
        };
        what.slots.remove(at);
        let symmetric = NounPhrase::new("symmetric", vec![(Slot::About, along)]);
        vec![Statement::one_is(body.clone(), symmetric)]
    });
}

/// "The axis of the disc passes through O", where n is the unit vector from there to its mass centre: the disc is symmetric
/// about n.
fn tell_axes_through_points(declarations: &mut [Declaration]) {
    for at in 0..declarations.len() {
        if let Some(statement) = axis_through(&declarations[at].statement, declarations) {
            declarations[at].statement = statement;
        }
    }
}

fn axis_through(statement: &Statement, all: &[Declaration]) -> Option<Statement> {
    let (subjects, slots) = statement.does("pass")?;
    let ([Term::Phrase(axis)], [(Slot::Through, point)]) = (subjects, slots) else {
        return None;
    };
    let ([(Slot::Of, body)], "axis" | "symmetry axis") = (axis.slots.as_slice(), axis.head) else {
        return None;
    };
    let is_centre = |term: &Term| {
        let mut centres = told(all).filter(|(_, what)| what.head == MASS_CENTRE);
        centres.any(|(points, what)| what.slot(Slot::Of) == Some(body) && points.contains(term))
    };
    let between = |what: &NounPhrase| match (what.slot(Slot::From), what.slot(Slot::To)) {
        (Some(from), Some(to)) => from == point && is_centre(to) || to == point && is_centre(from),
        _ => false,
    };
    let mut vectors = told(all).filter(|(_, what)| what.head == UNIT_VECTOR);
    let (units, _) = vectors.find(|(_, what)| between(what))?;
    let about = vec![(Slot::About, units.first()?.clone())];
    let symmetric = NounPhrase::new("symmetric", about);
    Some(Statement::one_is(body.clone(), symmetric))
}

/// What sentences about the whole document say that things are.
fn told(all: &[Declaration]) -> impl Iterator<Item = (&[Term], &NounPhrase)> {
    all.iter()
        .filter_map(|declaration| match &declaration.statement {
            Statement::Is { subjects, what } if declaration.extent == Extent::Document => {
                Some((subjects.as_slice(), what))
            }
            _ => None,
        })
}

fn spin(declaration: &Declaration, all: &[Declaration]) -> Option<Declaration> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return None;
    };
    let ([subject], Extent::Document) = (subjects.as_slice(), &declaration.extent) else {
        return None;
    };
    let (body, axis) = match (what.head, what.slots.as_slice()) {
        ("symmetric", _) => (subject, what.slot(Slot::About)?),
        ("axis", [(Slot::Of, body)]) => (body, subject),
        _ => return None,
    };
    let own: Vec<&Term> = all.iter().flat_map(|d| frames_of(body, d)).collect();
    let of_body = |term: &Term| term == body || own.contains(&term);
    let carrier = told(all).find_map(|(vectors, what)| {
        let carrier = match what.head {
            UNIT_VECTOR | "fixed" => what.slot(Slot::FixedIn),
            "axes" => what.slot(Slot::Of),
            _ => None,
        };
        carrier.filter(|_| vectors.contains(axis))
    })?;
    let turned = |d: &Declaration| tells_turn(d, &of_body);
    if of_body(carrier) || name(carrier).is_none() || all.iter().any(turned) {
        return None;
    }
    Some(declaration.saying(Statement::Does {
        subjects: vec![body.clone()],
        verb: "turn",
        slots: vec![
            (Slot::RelativeTo, carrier.clone()),
            (Slot::About, axis.clone()),
        ],
    }))
}

/// "B is a frame fixed in the body"
fn frames_of<'d>(body: &Term, declaration: &'d Declaration) -> &'d [Term] {
    match &declaration.statement {
        Statement::Is { subjects, what }
            if what.head == "frame" && what.all(Slot::FixedIn).any(|of| of == body) =>
        {
            subjects
        }
        _ => &[],
    }
}

/// Whether a sentence tells how something turns.
fn tells_turn(declaration: &Declaration, own: &impl Fn(&Term) -> bool) -> bool {
    match &declaration.statement {
        Statement::Does {
            subjects,
            verb: "turn" | "take",
            ..
        } => subjects.iter().any(own),
        Statement::Is { subjects, what } => match what.head {
            EULER_ANGLES => what.all(Slot::Of).any(own),
            "frame" => what.slot(Slot::RelativeTo).is_some() && subjects.iter().any(own),
            "fixed" => what.slot(Slot::FixedIn).is_some() && subjects.iter().any(own),
            _ => false,
        },
        _ => false,
    }
}
