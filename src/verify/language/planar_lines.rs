//! The lines that turn in a plane: that of a rod, and the one from a point to another.

use super::heads::{MASS_CENTRE, POSITION, UNIT_VECTOR};
use super::inclinations::Inclination;
use super::kinds::name;
use super::planar_axes::{axis, tells_distance};
use super::reader::formula;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use super::told_sizes::told_size;
use super::traits::{Trait, has};
use crate::notation::Macros;

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
    /// Whether what turns is called by both points.
    named: bool,
    /// Whether that is a rod.
    rod: bool,
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
            Self::Way(way) if way.rod => Some(Statement::Does {
                subjects: vec![way.turning.clone()],
                verb: "point",
                slots: vec![(Slot::Along, axis(number, Some(&way.turning)))],
            }),
            Self::Way(way) => way.new.then(|| {
                let frame = NounPhrase::new("frame", vec![]);
                Statement::one_is(way.turning.clone(), frame)
            }),
        }
    }

    /// Whether what turns is a body that is long, or one that is called by both points.
    pub(super) fn is_of_long_body(&self) -> bool {
        self.is_of_body() || matches!(self, Self::Way(way) if way.named)
    }

    /// Whether it turns with a frame of its own while a sentence tells otherwise where its end is.
    pub(super) fn is_told_otherwise(&self, declarations: &[Declaration]) -> bool {
        matches!(self, Self::Way(way) if way.is_beside(declarations))
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
    if let Some(turning) = called_by(from, to, declarations) {
        let rod = declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                has(what.head, Trait::Slender) && subjects.contains(&turning)
            }
            _ => false,
        });
        return Some(Line::Way(Box::new(Way {
            from: from.clone(),
            to: to.clone(),
            turning,
            new: false,
            named: true,
            rod,
        })));
    }
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
        named: false,
        rod: false,
    })))
}

/// The body that is called by two of its points, as the crank OA is: it turns with the line between them.
fn called_by(from: &Term, to: &Term, declarations: &[Declaration]) -> Option<Term> {
    let (from, to) = (name(from)?, name(to)?);
    let names = [format!("{from}{to}"), format!("{to}{from}")].map(Term::Name);
    let is_thing = |name: &Term| {
        declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                !matches!(what.head, "frame" | "axis") && subjects.contains(name)
            }
            _ => false,
        })
    };
    names.into_iter().find(is_thing)
}

/// The name of the frame that turns with the line from a point to another.
pub(super) fn way_name(from: &Term, to: &Term) -> Option<Term> {
    let (from, to) = (name(from)?, name(to)?);
    Some(Term::Name(format!("line from {from} to {to}")))
}

/// A rod that is called by both points, or another body of which a sentence tells how long it is between them: its other end and
/// its middle lie along the line. A point that no sentence places lies along it as well.
pub(super) fn place_ends(
    line: &Line,
    number: usize,
    declarations: &mut Vec<Declaration>,
    macros: &Macros,
) -> Vec<Statement> {
    let Line::Way(way) = line else { return vec![] };
    let along = || (Slot::Along, axis(number, Some(&way.turning)));
    let lie = |subject: Term, at: Term| Statement::Does {
        subjects: vec![subject],
        verb: "lie",
        slots: vec![(Slot::At, at), (Slot::From, way.from.clone()), along()],
    };
    if declarations
        .iter()
        .any(|d| is_placed(&d.statement, &way.to))
    {
        return vec![];
    }
    let Some(length) = length_of(&way.turning, declarations) else {
        return way.somewhere(number, declarations, macros);
    };
    let ends = [&way.from, &way.to];
    declarations.retain(|d| !is_end(&d.statement, &ends, &way.turning));
    let fixed = NounPhrase::new("point", vec![(Slot::FixedIn, way.turning.clone())]);
    let mut told = vec![
        lie(way.to.clone(), Term::Formula(length.clone())),
        Statement::one_is(way.from.clone(), fixed),
    ];
    let half = formula(&format!("\\frac{{{}}}{{2}}", length.source), false, macros);
    let uniform = declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => what.is("uniform") && subjects.contains(&way.turning),
        _ => false,
    });
    if let Some(half) = half.filter(|_| way.rod && uniform) {
        let centre = NounPhrase::new(MASS_CENTRE, vec![(Slot::Of, way.turning.clone())]);
        told.push(lie(Term::Phrase(Box::new(centre)), Term::Formula(half)));
    }
    told
}

impl Way {
    /// How far a point is along a new line of which no sentence tells it: a letter stands for that.
    fn somewhere(
        &self,
        number: usize,
        declarations: &[Declaration],
        macros: &Macros,
    ) -> Vec<Statement> {
        let centre = declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                what.head == MASS_CENTRE && subjects.contains(&self.to)
            }
            _ => false,
        });
        let ends = (name(&self.from), name(&self.to));
        let (true, (Some(from), Some(to))) = (self.new && !centre, ends) else {
            return vec![];
        };
        let source = format!("\\ell_{{\\mathrm{{{from}}}\\mathrm{{{to}}}}}");
        let Some(letter) = formula(&source, false, macros).map(Term::Formula) else {
            return vec![];
        };
        let along = axis(number, Some(&self.turning));
        let slots = vec![
            (Slot::At, letter.clone()),
            (Slot::From, self.from.clone()),
            (Slot::Along, along),
        ];
        let lies = Statement::Does {
            subjects: vec![self.to.clone()],
            verb: "lie",
            slots,
        };
        let positive = NounPhrase::new("positive", vec![]);
        vec![lies, Statement::one_is(letter, positive)]
    }

    /// Whether no sentence speaks of what turns, while one tells where the point is otherwise.
    fn is_beside(&self, declarations: &[Declaration]) -> bool {
        let told = |d: &Declaration| {
            is_placed(&d.statement, &self.to) && tells_distance(&d.statement).is_none()
        };
        self.new && declarations.iter().any(told)
    }
}

/// Whether a sentence tells where a point is.
fn is_placed(statement: &Statement, point: &Term) -> bool {
    match statement {
        Statement::Does {
            subjects,
            verb: "lie" | "place",
            slots,
        } => subjects.contains(point) && !slots.iter().any(|(slot, _)| *slot == Slot::On),
        Statement::Is { what, .. } => {
            what.head == POSITION && what.slot(Slot::Of) == Some(point) && what.slots.len() < 3
        }
        _ => false,
    }
}

/// How long a body is.
fn length_of(body: &Term, declarations: &[Declaration]) -> Option<Formula> {
    told_size("length", body, declarations).cloned()
}

/// "A is an end of the rod."
fn is_end(statement: &Statement, points: &[&Term], body: &Term) -> bool {
    match statement {
        Statement::Is { subjects, what } if what.head == "end" => {
            what.slot(Slot::Of) == Some(body) && subjects.iter().all(|s| points.contains(&s))
        }
        _ => false,
    }
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
