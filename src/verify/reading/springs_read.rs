//! Linear springs between two points: "A spring of stiffness `$k$` and natural length `$L$` extends from P to Q".
//!
//! A spring is no body and has no place in the model: what it does is known wherever sentences speak of it, by its ends and
//! sizes. Where a sentence says more of springs than these, nothing is known of any.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::verify::language::heads::{FORCE, MOMENT, NATURAL_LENGTH};
use crate::verify::language::statement::{
    Declaration, Extent, Formula, NounPhrase, Slot, Statement, Term,
};
use crate::verify::model::loads::Load;
use crate::verify::model::system::{BodyId, PointId, Vector};
use crate::verify::reading::body_ends::END;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::{POTENTIAL, letter_of, name_of, node_of, nodes_of};
use crate::verify::reading::potentials_read::tells_zero_of_potential;
use crate::verify::reading::reactions_read::same_letter;
use crate::verify::term::letters::spelled;
use crate::verify::term::quantity::{Quantity, Spot, Whole};
use crate::verify::term::value::{Basis, Value};

const SPRING: &str = "spring";
const STIFFNESS: &str = "stiffness";
/// What is said of a spring that has a stiffness against turning.
const TWISTING: [&str; 3] = ["torsion", "rotational", "spiral"];

/// What a sentence may say a letter to be of a spring, which the law of springs tells.
const TOLD_BY_LAW: [&str; 3] = [FORCE, MOMENT, POTENTIAL];

/// A spring of which all is told.
struct Spring {
    ends: [PointId; 2],
    stiffness: Fraction,
    natural_length: Fraction,
    length: Fraction,
}

/// Where the end of a spring is.
#[derive(Clone, Copy, PartialEq)]
enum Held {
    /// In space: no work is done there.
    AtRest,
    By(BodyId),
    Unknown,
}

/// Whether a term names a spring that is stretched: "the spring", "spring 1", "the left spring".
pub(super) fn is_spring(term: &Term) -> bool {
    let twists = |name: &str| TWISTING.iter().any(|twisting| name.contains(twisting));
    spring_name(term).is_some_and(|name| !twists(&name))
}

/// The spring of which a load is what it does: "the force of the spring", "the moment of the force of the spring".
fn spring_of(load: &NounPhrase) -> Option<&Term> {
    match load.slot(Slot::Of) {
        Some(Term::Phrase(force)) if force.head == FORCE => spring_of(force),
        of => of.filter(|of| is_spring(of)),
    }
}

pub(super) fn is_of_spring(load: &NounPhrase) -> bool {
    spring_of(load).is_some()
}

/// The name of a spring of any kind. Adjectives alone may tell one from another.
fn spring_name(term: &Term) -> Option<String> {
    let named = match term {
        Term::Phrase(phrase) if phrase.head == SPRING && phrase.slots.is_empty() => {
            Some([phrase.adjectives.as_slice(), &[SPRING]].concat().join(" "))
        }
        term => name_of(term),
    };
    named.filter(|name| name.split(' ').any(|word| word == SPRING))
}

/// Whether a sentence speaks of what has a potential energy of its own, whichever force it exerts.
pub(super) fn speaks_of_spring(declaration: &Declaration) -> bool {
    let elastic = |term: &Term| match term {
        Term::Phrase(phrase) => phrase.head == SPRING || phrase.head == STIFFNESS,
        Term::Member { family, .. } => family == SPRING,
        _ => spring_name(term).is_some(),
    };
    let head = match &declaration.statement {
        Statement::Is { what, .. } => what.head == STIFFNESS,
        _ => false,
    };
    head || declaration.statement.terms().into_iter().any(elastic)
        || declaration.may_speak_of(&[SPRING])
}

/// Whether a sentence says nothing of springs, or what the law of springs knows of them.
fn is_plain(declaration: &Declaration) -> bool {
    if !speaks_of_spring(declaration) {
        return true;
    }
    match &declaration.statement {
        Statement::Is { what, .. } => {
            let alone = what.slot(Slot::Of).is_some_and(is_spring) && what.slots.len() == 1;
            match what.head {
                END | STIFFNESS | NATURAL_LENGTH => alone && what.adjectives.is_empty(),
                head => TOLD_BY_LAW.contains(&head),
            }
        }
        Statement::Premise(premise) => premise.is("only"),
        _ => false,
    }
}

impl<'a> Builder<'a> {
    /// What the only sentence of its kind says of a spring.
    fn said_of_spring(&self, spring: &Term, head: &str) -> Option<(Vec<Term>, Declaration)> {
        let said = self.declarations.iter().filter(|d| match &d.statement {
            Statement::Is { what, .. } => what.head == head && what.slot(Slot::Of) == Some(spring),
            _ => false,
        });
        let [only] = said.collect::<Vec<_>>()[..] else {
            return None;
        };
        // What is told of a part of the document is not told of all.
        (only.extent == Extent::Document).then_some(())?;
        Some((only.statement.subjects().to_vec(), only.clone()))
    }

    /// Whether a load is what a spring does of which a sentence tells the ends: its law says what that is. Another one is
    /// something outside of which no more is known.
    pub(super) fn is_by_spring(&self, load: &NounPhrase) -> bool {
        let ends = |spring| self.said_of_spring(spring, END).is_some();
        spring_of(load).is_some_and(ends)
    }

    /// Whether sentences tell of each spring once, of sizes that do not change, and of none between the parts of a whole.
    fn springs_are_plain(&self) -> bool {
        let all = self.declarations;
        let of = |head: &'static str| {
            all.iter().filter_map(move |d| match &d.statement {
                Statement::Is { subjects, what } if what.head == head => {
                    Some((subjects, what.slot(Slot::Of)?))
                }
                _ => None,
            })
        };
        let springs: Vec<&Term> = of(END)
            .map(|(_, of)| of)
            .filter(|of| is_spring(of))
            .collect();
        let once = |spring: &&Term| springs.iter().filter(|other| *other == spring).count() == 1;
        let sizes: Vec<&Term> = of(STIFFNESS)
            .chain(of(NATURAL_LENGTH))
            .flat_map(|(s, _)| s)
            .collect();
        let changes = |d: &Declaration| match &d.statement {
            Statement::Is { subjects, what } => {
                what.head == "function" && subjects.iter().any(|s| sizes.contains(&s))
            }
            Statement::Holds(formula) => {
                let side = |size: &&Term| letter_of(size).is_some_and(|l| is_side(formula, l));
                sizes.iter().any(side)
            }
            _ => false,
        };
        let wholes = all.iter().filter_map(|d| d.statement.does("consist"));
        let wholes: Vec<&Term> = wholes.flat_map(|(wholes, _)| wholes).collect();
        let on_whole = |load: &NounPhrase| {
            let mut on = load.all(Slot::Of).chain(load.all(Slot::Upon));
            on.any(|body| wholes.contains(&body))
        };
        let whole = all.iter().any(|d| match &d.statement {
            Statement::Premise(load) => on_whole(load),
            _ => false,
        });
        let moving = of(END).any(|(ends, of)| {
            let at_rest = |end: &Term| {
                let point = self.point(end);
                point.is_some_and(|p| !self.reading.system.points[p].fixed_in.is_empty())
            };
            is_spring(of) && !ends.iter().any(at_rest)
        });
        all.iter().all(is_plain)
            && springs.iter().all(once)
            && !all.iter().any(changes)
            && !(whole && moving)
    }

    /// Where nothing is known of a spring, what sentences say of it is not worked with.
    pub(super) fn say_springs_unread(&mut self) {
        if self.springs_named().is_empty() || self.springs_are_plain() {
            return;
        }
        for declaration in self.declarations.iter().filter(|d| speaks_of_spring(d)) {
            self.say_unused(declaration);
        }
    }

    fn size_of_spring(&mut self, spring: &Term, head: &str) -> Option<Fraction> {
        let (subjects, declaration) = self.said_of_spring(spring, head)?;
        let [letter] = subjects.as_slice() else {
            return None;
        };
        self.size_by_letter(letter_of(letter)?, &declaration)
    }

    fn spring(&mut self, named: &Term) -> Option<Spring> {
        if !is_spring(named) || !self.springs_are_plain() {
            return None;
        }
        let (ends, _) = self.said_of_spring(named, END)?;
        let [first, second] = ends.as_slice() else {
            return None;
        };
        let ends = [self.point(first)?, self.point(second)?];
        let (of, from) = (Spot::Point(ends[0]), ends[1]);
        let length = Quantity::Magnitude(Quantity::Position { of, from }.boxed());
        Some(Spring {
            ends,
            stiffness: self.size_of_spring(named, STIFFNESS)?,
            natural_length: self.size_of_spring(named, NATURAL_LENGTH)?,
            length: self.system().value_of(&length).ok()?.to_scalar().ok()?,
        })
    }

    /// By what an end of a spring is held.
    fn holds_end(&mut self, end: PointId) -> Held {
        let system = &self.reading.system;
        let carries =
            |body: &BodyId| system.bodies[*body].parts.is_empty() && system.carries(*body, end);
        let is = |body: &BodyId| {
            system.bodies[*body].is_particle() && system.bodies[*body].centre == end
        };
        let ground = system.ground;
        let held = (0..system.bodies.len()).find(|body| carries(body) || is(body));
        let rests = |own: &mut Self| own.system().velocity(end, ground) == Vector::zeros();
        match held {
            _ if rests(self) => Held::AtRest,
            Some(body) => Held::By(body),
            None => Held::Unknown,
        }
    }

    /// What a spring does to some bodies: a force at each of its ends that is on one of them.
    fn loads_of(&mut self, spring: &Spring, bodies: &[BodyId]) -> Option<Vec<Load>> {
        let mut held = spring.ends.map(|end| self.holds_end(end));
        // Of two ends one of which rests the other is on the only body, where no sentence says what carries it.
        if let (&[body], true) = (bodies, held.contains(&Held::AtRest)) {
            let moving = held.iter_mut().find(|held| **held == Held::Unknown);
            moving.into_iter().for_each(|held| *held = Held::By(body));
        }
        let mut loads = vec![];
        for (held, [end, other]) in held.into_iter().zip([[0, 1], [1, 0]]) {
            let on = match held {
                Held::By(body) if bodies.contains(&body) => body,
                Held::By(_) | Held::AtRest => continue,
                Held::Unknown => return None,
            };
            let [end, other] = [end, other].map(|end| spring.ends[end]);
            let way = self.reading.system.position(end, other);
            loads.push(Load::unnamed(Some(end), spring.force(&way), Some(on)));
        }
        Some(loads)
    }

    /// The loads that "the force of the spring" or "the moment of the spring" names: on the body that the phrase says, or on this
    /// one, or on all.
    pub(super) fn loads_of_spring(
        &mut self,
        phrase: &NounPhrase,
        on: Option<BodyId>,
    ) -> Option<Vec<Load>> {
        let named = phrase.slot(Slot::Of).filter(|of| is_spring(of))?;
        let plain = phrase.slot(Slot::At).is_none() && phrase.slot(Slot::Along).is_none();
        if !plain || !matches!(phrase.head, FORCE | MOMENT) {
            return None;
        }
        let on = match phrase.slot(Slot::Upon) {
            Some(upon) => Some(self.body(upon)?),
            None => on,
        };
        let system = &self.reading.system;
        let whole = |body: &BodyId| system.bodies[*body].parts.is_empty();
        let bodies = match on {
            Some(body) => system.wholes(body),
            None => (0..system.bodies.len()).filter(whole).collect(),
        };
        let spring = self.spring(named)?;
        self.loads_of(&spring, &bodies)
    }

    /// The same where no more than one body may be meant.
    fn load_of_spring(&mut self, phrase: &NounPhrase) -> Option<Load> {
        let loads = self.loads_of_spring(phrase, None)?;
        let [load] = loads.as_slice() else {
            return None;
        };
        Some(load.clone())
    }

    /// The load of a letter of which a sentence says that it is the force of a spring.
    pub(super) fn spring_by_letter(&mut self, letter: &Formula) -> Option<Load> {
        let declarations = self.declarations;
        let what = declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == FORCE => {
                let own = formulas(subjects).any(|own| same_letter(own, letter));
                own.then_some(what)
            }
            _ => None,
        })?;
        self.load_of_spring(what)
    }

    /// "the force of the spring on the rod"
    pub(super) fn force_of_spring(&mut self, phrase: &NounPhrase) -> Option<Quantity> {
        let mut whole = phrase.clone();
        whole.slots.retain(|(slot, _)| *slot != Slot::Along);
        let load = self.load_of_spring(&whole)?;
        Some(Quantity::Known(Value::vector(&load.value, Basis::Itself)))
    }

    /// "the moment of the spring about O", "… of the force of the spring …", "… about the axis through O along z".
    pub(super) fn moment_of_spring(&mut self, moment: &NounPhrase) -> Option<Quantity> {
        moment.slot(Slot::About)?;
        let mut phrase = match moment.slot(Slot::Of)? {
            Term::Phrase(force) if force.head == FORCE => (**force).clone(),
            _ => moment.clone(),
        };
        phrase.slots.retain(|(slot, _)| *slot != Slot::Along);
        let load = self.load_of_spring(&phrase)?;
        let about = self.about(moment, &Whole::Body(load.on?))?;
        let moment = self.reading.system.moment_of_loads(&[load], about);
        Some(Quantity::Known(Value::vector(&moment, Basis::Itself)))
    }

    /// The terms by which sentences name springs.
    fn springs_named(&self) -> Vec<&'a Term> {
        let mut springs: Vec<&Term> = vec![];
        for term in self.declarations.iter().flat_map(|d| d.statement.terms()) {
            if is_spring(term) && !springs.contains(&term) {
                springs.push(term);
            }
        }
        springs
    }

    /// The forces of all springs on a body.
    pub(super) fn forces_of_springs(&mut self, body: BodyId) -> Option<Vec<Load>> {
        let own = self.reading.system.wholes(body);
        let mut forces = vec![];
        for named in self.springs_named() {
            let spring = self.spring(named)?;
            forces.extend(self.loads_of(&spring, &own)?);
        }
        Some(forces)
    }

    /// The potential energy of a spring. Where a sentence says for which values it is zero it is another one.
    pub(super) fn energy_of_spring(&mut self, named: &Term) -> Option<Quantity> {
        let declarations = self.declarations;
        let is_own = |letter: &Term| {
            declarations.iter().any(|d| match &d.statement {
                Statement::Is { subjects, what } if what.head == POTENTIAL => {
                    what.slot(Slot::Of).is_some_and(is_spring) && subjects.contains(letter)
                }
                _ => false,
            })
        };
        let shifts = |d: &Declaration| {
            let subjects = d.statement.subjects();
            tells_zero_of_potential(d, declarations) && subjects.iter().any(is_own)
        };
        if declarations.iter().any(shifts) {
            return None;
        }
        let spring = self.spring(named)?;
        Some(Quantity::Known(Value::scalar(spring.energy())))
    }

    /// The potential energies of the springs that act on a body from points at rest, or between parts of it; none is known
    /// where a spring is not told in full or does work on something else as well.
    pub(super) fn energies_of_springs(&mut self, body: BodyId) -> Option<Vec<Fraction>> {
        if !self.declarations.iter().all(is_plain) {
            return None;
        }
        let own = self.reading.system.wholes(body);
        let mut energies = vec![];
        for named in self.springs_named() {
            let spring = self.spring(named)?;
            let held = spring.ends.map(|end| self.holds_end(end));
            let inside = |held: &Held| matches!(held, Held::By(by) if own.contains(by));
            match held.iter().any(inside) {
                _ if held.contains(&Held::Unknown) => return None,
                true if held.iter().all(|h| inside(h) || *h == Held::AtRest) => {
                    energies.push(spring.energy());
                }
                true => return None,
                false => {}
            }
        }
        Some(energies)
    }
}

impl Spring {
    /// The force on the end that is this way from the other one.
    fn force(&self, way: &Vector) -> Vector {
        mechanics::spring_force(&self.stiffness, &self.natural_length, way, &self.length)
    }

    fn energy(&self) -> Fraction {
        mechanics::spring_energy(&self.stiffness, &self.natural_length, &self.length)
    }
}

/// Whether a letter is a side of an equation by itself.
fn is_side(formula: &Formula, letter: &Formula) -> bool {
    let Some(letter) = node_of(letter).map(spelled) else {
        return false;
    };
    nodes_of(formula).iter().any(|side| spelled(side) == letter)
}
