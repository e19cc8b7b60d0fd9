//! The lines that turn in a plane: that of a rod, and the one from a point to another.

use super::heads::UNIT_VECTOR;
use super::inclinations::Inclination;
use super::kinds::name;
use super::planar_axes::{axis, tells_distance};
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// A line, and what turns with it.
pub(super) enum Line {
    /// Of a body that is long.
    Body(Term),
    Way(Box<Way>),
}

/// From a point to another, with the body in which both are fixed or the frame that turns with them.
pub(super) struct Way {
    from: Term,
    to: Term,
    turning: Term,
    /// Whether no sentence speaks of what turns.
    new: bool,
}

impl Line {
    /// The body or the frame that turns.
    pub(super) fn turning(&self) -> &Term {
        match self {
            Self::Body(body) => body,
            Self::Way(way) => &way.turning,
        }
    }

    /// Whether it is that of a body that is long.
    pub(super) fn is_of_body(&self) -> bool {
        matches!(self, Self::Body(_))
    }

    /// Whether it is the line of a thing, or leads from or to it.
    pub(super) fn is_of(&self, thing: &Term) -> bool {
        match self {
            Self::Body(body) => body == thing,
            Self::Way(way) => [&way.from, &way.to, &way.turning].contains(&thing),
        }
    }

    /// Along which of its axes a body lies, and what the frame is that turns where no sentence speaks of it.
    pub(super) fn besides(&self, number: usize) -> Option<Statement> {
        match self {
            Self::Body(body) => Some(Statement::Does {
                subjects: vec![body.clone()],
                verb: "point",
                slots: vec![(Slot::Along, axis(number, Some(body)))],
            }),
            Self::Way(way) => way.new.then(|| {
                let frame = NounPhrase::new("frame", vec![]);
                Statement::one_is(way.turning.clone(), frame)
            }),
        }
    }

    /// Whether "the line from A to C" is this one, and whether it leads the other way.
    pub(super) fn leads_along(&self, what: &NounPhrase) -> Option<bool> {
        let Self::Way(way) = self else { return None };
        let ends = (what.slot(Slot::From)?, what.slot(Slot::To)?);
        let (forth, back) = ((&way.from, &way.to), (&way.to, &way.from));
        (what.slots.len() == 2 && (ends == forth || ends == back)).then_some(ends == back)
    }

    /// "the unit vector along the rod", "from O to G"
    pub(super) fn is_along(&self, what: &NounPhrase) -> bool {
        match self {
            Self::Body(body) => {
                what.slot(Slot::Along) == Some(body) && what.slot(Slot::To).is_none()
            }
            Self::Way(way) => {
                let from = what.slot(Slot::From) == Some(&way.from);
                from && what.slot(Slot::To) == Some(&way.to)
            }
        }
    }
}

/// The line whose angle a sentence tells.
pub(super) fn resolve(inclination: &Inclination, declarations: &[Declaration]) -> Option<Line> {
    match &inclination.line {
        Term::Phrase(way) if way.head == "axis" => line_between(way, declarations),
        body @ Term::Name(_) => Some(Line::Body(body.clone())),
        letter @ Term::Formula(_) => declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what }
                if what.head == UNIT_VECTOR && subjects.contains(letter) =>
            {
                match what.slot(Slot::Along) {
                    Some(body @ Term::Name(_)) => Some(Line::Body(body.clone())),
                    _ => line_between(what, declarations),
                }
            }
            _ => None,
        }),
        _ => None,
    }
}

/// "the line from O to G"
pub(super) fn line_between(way: &NounPhrase, declarations: &[Declaration]) -> Option<Line> {
    let (from, to) = (way.slot(Slot::From)?, way.slot(Slot::To)?);
    let body = declarations.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "mass centre" && subjects.contains(to) => {
            what.slot(Slot::Of).cloned()
        }
        _ => None,
    });
    // What rolls does not turn with the line to its mass centre.
    let rolls = |d: &Declaration| {
        let rolling = d.statement.does("roll");
        rolling.is_some_and(|(subjects, _)| body.as_ref().is_some_and(|b| subjects.contains(b)))
    };
    let rolling = declarations.iter().any(rolls);
    let body = body.filter(|_| !rolling);
    let new = body.is_none();
    Some(Line::Way(Box::new(Way {
        from: from.clone(),
        to: to.clone(),
        turning: body.or_else(|| way_name(from, to))?,
        new,
    })))
}

/// The name of the frame that turns with the line from a point to another.
pub(super) fn way_name(from: &Term, to: &Term) -> Option<Term> {
    let (from, to) = (name(from)?, name(to)?);
    Some(Term::Name(format!("line from {from} to {to}")))
}

/// "G lies at the distance a from O": along the line.
pub(super) fn place_along(line: &Line, number: usize, declarations: &mut [Declaration]) {
    let Line::Way(way) = line else { return };
    let Way {
        from, to, turning, ..
    } = &**way;
    for declaration in declarations.iter_mut() {
        let Some((one, other, distance)) = tells_distance(&declaration.statement) else {
            continue;
        };
        if (one, other) != (to, from) && (one, other) != (from, to) {
            continue;
        }
        let slots = vec![
            (Slot::At, distance.clone()),
            (Slot::From, from.clone()),
            (Slot::Along, axis(number, Some(turning))),
        ];
        declaration.statement = Statement::Does {
            subjects: vec![to.clone()],
            verb: "lie",
            slots,
        };
    }
}
