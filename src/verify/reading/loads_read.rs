//! Loads that sentences name, and what it says that there are no others.

use crate::algebra::Place;
use crate::notation::ast::Kind;
use crate::verify::language::heads::{FORCE, MOMENT};
use crate::verify::language::statement::{
    Declaration, Formula, NounPhrase, Slot, Statement, Term, slot,
};
use crate::verify::language::traits::{is_couple, is_force};
use crate::verify::model::loads::{Called, Lasting, Load};
use crate::verify::model::system::{BodyId, PointId, Vector};
use crate::verify::reading::blows_read::rests_before;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::compounds_read::symbols_in;
use crate::verify::reading::names::{is_letter, is_marked_vector, name_of, node_of};
use crate::verify::reading::reactions_read::is_reaction;
use crate::verify::term::letters::{Meaning, spelled};
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;

/// The noun of a blow.
const IMPULSE: &str = "impulse";

/// Whether a sentence says what the loads on something come to, which a law alone ties to its motion.
pub(crate) fn tells_loads(declaration: &Declaration) -> bool {
    let of_loads = |head: &str| is_force(head) || is_couple(head) || head == "load";
    match &declaration.statement {
        Statement::Premise(premise) => of_loads(premise.head),
        Statement::Is { subjects, what } => {
            let load =
                |subject: &Term| matches!(subject, Term::Phrase(load) if of_loads(load.head));
            what.head == "zero" && subjects.iter().any(load)
        }
        _ => false,
    }
}

/// What a body is that does not move.
pub(super) const AT_REST: &str = "at rest";

/// The noun of the point where a force acts.
const POINT_OF_ACTION: &str = "point of action";

/// What a sentence says of one load.
pub(super) struct Acting<'s> {
    pub(super) head: &'s str,
    pub(super) letter: &'s Formula,
    pub(super) at: Option<PointId>,
    pub(super) along: Option<&'s Term>,
    pub(super) on: Option<BodyId>,
}

impl Builder<'_> {
    /// "The force `F` acts at P", "`T` is the thrust at P along z".
    pub(super) fn read_loads(&mut self) {
        self.read_reactions();
        for declaration in self.declarations {
            let read = match &declaration.statement {
                Statement::Does {
                    subjects,
                    verb: "act",
                    slots,
                } => self.read_acting(subjects, slots, declaration),
                Statement::Is { what, .. }
                    if is_reaction(what) && self.contact_of(what).is_some() =>
                {
                    Some(())
                }
                Statement::Is { subjects, what }
                    if is_force_at(what) && self.load_between(what, None).is_some() =>
                {
                    self.name_load_between(subjects, what, declaration)
                }
                Statement::Is { what, .. } if is_force_at(what) && self.acts_outside(what) => {
                    match self.reversed(what) {
                        Some(_) => continue,
                        None => None,
                    }
                }
                Statement::Is { subjects, what } if is_force_at(what) => {
                    let said = |subject| (what.head, subject);
                    let mut all = subjects.iter().map(said);
                    all.try_for_each(|(head, subject)| match subject {
                        Term::Formula(letter) => {
                            self.add_load(head, letter, &what.slots, declaration)
                        }
                        _ => None,
                    })
                }
                _ => continue,
            };
            read.unwrap_or_else(|| self.say_unused(declaration));
        }
        self.read_opposites();
        self.place_forces();
        self.tell_forces_on_particles();
    }

    /// The points where forces act that no other sentence places.
    fn place_forces(&mut self) {
        for declaration in self.declarations {
            for letter in declaration
                .statement
                .terms()
                .into_iter()
                .filter_map(acting_force)
            {
                if self.load(letter, Lasting::Always).is_some() {
                    continue;
                }
                let text = format!("r_{{{}}}", letter.source);
                let way = self.system().free_vector(&text, Place::Coordinate, None);
                let at = self.system().add_point(&text, Some((0, way)), vec![]);
                let acting = Acting {
                    head: "force",
                    letter,
                    at: Some(at),
                    along: None,
                    on: None,
                };
                if let Some(value) = self.value_of_load(&acting, declaration) {
                    self.push_load(&acting, value);
                }
            }
        }
    }

    fn read_acting(
        &mut self,
        subjects: &[Term],
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) -> Option<()> {
        let on = |slot: Slot| match slot {
            Slot::Of => Slot::Upon,
            slot => slot,
        };
        let slots: Vec<(Slot, Term)> = slots.iter().map(|(s, t)| (on(*s), t.clone())).collect();
        // What acts on something outside acts on no body of the system.
        if slot(&slots, Slot::Upon).is_some_and(|on| self.outside(on, None).is_some()) {
            return None;
        }
        for subject in subjects {
            match subject {
                Term::Formula(letter) => self.add_load(FORCE, letter, &slots, declaration)?,
                Term::Phrase(load) => {
                    let own = load.slots.iter().filter(|(slot, _)| *slot != Slot::Which);
                    let slots = [slots.as_slice(), &own.cloned().collect::<Vec<_>>()].concat();
                    for letter in load.all(Slot::Which) {
                        let Term::Formula(letter) = letter else {
                            return None;
                        };
                        self.add_load(load.head, letter, &slots, declaration)?;
                    }
                    load.slot(Slot::Which)?;
                }
                _ => return None,
            }
        }
        Some(())
    }

    pub(super) fn add_load(
        &mut self,
        head: &str,
        letter: &Formula,
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) -> Option<()> {
        let at = match slot(slots, Slot::At) {
            Some(term) => Some(self.point(term)?),
            None => None,
        };
        // One of many: how many there are no sentence says.
        if self.is_numbered(letter) {
            return None;
        }
        if let Some(known) = self.load(letter, lasting_of(head))
            && known.at == at
        {
            return Some(());
        }
        if at.is_some() != is_force(head) || at.is_none() && !is_couple(head) {
            return None;
        }
        let acting = Acting {
            head,
            letter,
            at,
            along: slot(slots, Slot::Along).or_else(|| self.axis_of_load(slots)),
            on: slot(slots, Slot::Upon).and_then(|on| self.body(on)),
        };
        if let Some(along) = self.told_direction(head, letter, declaration) {
            let value = self.directed_force(letter, &along, declaration)?;
            self.push_load(&acting, value);
            return Some(());
        }
        let value = self.value_of_load(&acting, declaration)?;
        if head == MOMENT || at.is_some() {
            self.push_load(&acting, value);
            return Some(());
        }
        // A moment of a kind is called by its noun.
        let on = acting.on.or_else(|| self.only_body())?;
        if !self
            .loads_called(&Called::Noun(head.to_owned(), on))
            .is_empty()
        {
            return None;
        }
        self.push_named_load((head, on), value, None);
        Some(())
    }

    /// "The moment `K` about z acts": what a moment is about that is no point.
    pub(super) fn axis_of_load<'t>(&self, slots: &'t [(Slot, Term)]) -> Option<&'t Term> {
        let about = slot(slots, Slot::About)?;
        self.point(about).is_none().then_some(about)
    }

    /// "`$F_i$`", where `$i$` numbers things.
    fn is_numbered(&self, letter: &Formula) -> bool {
        let numbers = self
            .declarations
            .iter()
            .filter_map(|d| d.statement.does("number"));
        let mut numbers = numbers
            .flat_map(|(subjects, _)| subjects)
            .filter_map(name_of);
        let letters = node_of(letter).map(symbols_in).unwrap_or_default();
        let carries = |letter: &Formula, index: &String| match node_of(letter).map(|n| &n.kind) {
            Some(Kind::Symbol(symbol)) => symbol.subscripts.contains(index),
            _ => false,
        };
        numbers.any(|index| letters.iter().any(|letter| carries(letter, &index)))
    }

    pub(super) fn push_load(&mut self, acting: &Acting<'_>, value: Vector) {
        let letter = node_of(acting.letter).map(spelled).unwrap_or_default();
        self.system().loads.push(Load {
            called: Called::Letter(letter),
            at: acting.at,
            value,
            lasting: lasting_of(acting.head),
            on: acting.on,
            part: false,
            listed: false,
        });
    }

    /// A letter that is told already, the size of a load along an axis, or a vector by its letter.
    pub(super) fn value_of_load(
        &mut self,
        acting: &Acting<'_>,
        declaration: &Declaration,
    ) -> Option<Vector> {
        if !is_letter(acting.letter) {
            self.tell_letters_of_place(acting.letter, declaration)?;
            let value = self.formula_value(acting.letter, declaration)?;
            return self.load_along(&value, acting.along, declaration);
        }
        if let Some(along) = acting.along.filter(|_| is_marked_vector(acting.letter)) {
            let along = self.direction(along, declaration, None)?;
            return self.directed_force(acting.letter, &along, declaration);
        }
        let known = self.quantity_of(acting.letter, declaration);
        let text = acting.letter.source.clone();
        let quantity = known.clone().unwrap_or(match acting.along {
            Some(_) => Quantity::Scalar {
                text,
                constant: false,
            },
            None => Quantity::Vector {
                text,
                carried: None,
            },
        });
        if known.is_none() {
            let meaning = Meaning::Quantity(quantity.clone());
            self.denote(acting.letter, meaning, declaration);
        }
        let value = self.system().value_of(&quantity).ok()?;
        self.load_along(&value, acting.along, declaration)
    }

    /// A vector, or a number of what points along a direction.
    fn load_along(
        &mut self,
        value: &Value,
        along: Option<&Term>,
        declaration: &Declaration,
    ) -> Option<Vector> {
        match along {
            Some(along) if value.is_scalar() => {
                let along = self.direction(along, declaration, None)?;
                Some(along * value.to_scalar().ok()?)
            }
            _ => value.to_vector().ok(),
        }
    }

    /// A load by its letter.
    pub(super) fn load(&self, letter: &Formula, lasting: Lasting) -> Option<Load> {
        let called = Called::Letter(spelled(node_of(letter)?));
        let mut loads = self.reading.system.loads.iter();
        loads
            .find(|load| load.called == called && load.lasting == lasting)
            .cloned()
    }

    /// Where a force acts, by its letter.
    pub(super) fn where_acts(&self, letter: &Formula) -> Option<PointId> {
        Some(self.acting_there(letter)?.0)
    }

    /// A force by its letter, and the point where it acts.
    pub(super) fn acting_there(&self, letter: &Formula) -> Option<(PointId, Vector)> {
        let load = self.load(letter, Lasting::Always)?;
        Some((load.at?, load.value))
    }

    pub(super) fn loads_at(&self, at: PointId, lasting: Lasting) -> Vec<Load> {
        let loads = self.reading.system.loads.iter();
        let there =
            loads.filter(|load| load.at == Some(at) && load.lasting == lasting && !load.part);
        there.cloned().collect()
    }

    /// A force that nothing tells, beside another one: a vector of its own.
    pub(super) fn open_load(
        &mut self,
        head: &str,
        at: PointId,
        letter: Option<Formula>,
        declaration: &Declaration,
    ) -> Option<Load> {
        let text = format!("F_{{{}}}", self.reading.system.points[at].name);
        let quantity = Quantity::Vector {
            text: letter.as_ref().map_or(text, |l| l.source.clone()),
            carried: None,
        };
        if let Some(letter) = &letter {
            let meaning = Meaning::Quantity(quantity.clone());
            self.denote(letter, meaning, declaration);
        }
        let value = self.system().value_of(&quantity).ok()?.to_vector().ok()?;
        Some(Load {
            lasting: lasting_of(head),
            ..Load::unnamed(Some(at), value, None)
        })
    }
}

/// Whether a noun is that of a force at a point.
pub(super) fn is_force_at(what: &NounPhrase) -> bool {
    is_force(what.head) && what.slot(Slot::At).is_some()
}

/// Whether it is said that something is at rest, and of no blow that comes then.
pub(super) fn rests_for_long(what: &NounPhrase) -> bool {
    what.head == AT_REST && !rests_before(what)
}

pub(super) fn lasting_of(head: &str) -> Lasting {
    match head {
        IMPULSE => Lasting::Blow,
        _ => Lasting::Always,
    }
}

pub(super) fn letters_of(load: &NounPhrase) -> Vec<&Formula> {
    let mut letters = vec![];
    for term in load.all(Slot::Which) {
        if let Term::Formula(letter) = term {
            letters.push(letter);
        }
    }
    letters
}

/// Whether a term is the point where a force acts, and which force.
pub(super) fn acting_force(term: &Term) -> Option<&Formula> {
    match term {
        Term::Phrase(point) if point.head == POINT_OF_ACTION => match point.slot(Slot::Of)? {
            Term::Formula(letter) => Some(letter),
            _ => None,
        },
        _ => None,
    }
}
