//! Loads of each of a family: "`$T_i$` is the thrust of rotor `$i$` along z" says of each rotor that its force acts where it
//! is, and "the thrusts of the rotors" are these forces.

use super::family_places::{Family, Of, families, family_noun, family_of, is_place, numbered};
use super::heads::{ANGULAR_VELOCITY, FORCE, MOMENT};
use super::reader::formula;
use super::statement::{Declaration, Extent, Formula, NounPhrase, Slot, Statement, Term, slot};
use super::told_loads::{LoadsOfFamily, function_of_time, placed_forces, put_loads};
use crate::notation::Macros;

/// Nouns of forces that each of a family may exert.
const FORCES: [&str; 5] = [FORCE, "thrust", "lift", "tension", "aerodynamic force"];

/// Nouns of moments that each of a family may exert.
const MOMENTS: [&str; 5] = [
    MOMENT,
    "drag moment",
    "control moment",
    "motor moment",
    "aerodynamic moment",
];

/// How large the loads of a family are: letters for each, and along what.
struct Sized {
    letters: Vec<Formula>,
    /// The places where they act.
    places: Vec<Term>,
    along: Option<String>,
    moments: bool,
    /// Whether the letters are said to be magnitudes.
    magnitudes: bool,
}

/// Says of each of the loads where and on what it acts, and puts them where sentences speak of all of them.
pub(crate) fn tell_loads_of_families(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let families = families(declarations);
    let mut told: Vec<LoadsOfFamily> = vec![];
    let mut spent = vec![];
    let mut said = vec![];
    for family in &families {
        if declarations
            .iter()
            .any(|d| tells_otherwise(&d.statement, family))
        {
            continue;
        }
        let whole = declarations.iter().enumerate();
        for (at, declaration) in whole.filter(|(_, d)| d.extent == Extent::Document) {
            let Some((sized, noun)) = sized(&declaration.statement, family, declarations, macros)
            else {
                continue;
            };
            let loads = sized.loads(macros);
            let acting = loads.and_then(|loads| {
                let acting = acting(&loads, &sized, family, &noun, declarations)?;
                Some((loads, acting))
            });
            let Some((loads, acting)) = acting else {
                continue;
            };
            said.extend(acting.into_iter().map(|s| declaration.saying(s)));
            spent.push(at);
            let own = LoadsOfFamily {
                family: family.noun.clone(),
                noun: noun.head,
                class: if sized.moments { MOMENT } else { FORCE },
                agent: agent(&noun, family),
                sum: sized.sum(&loads),
                magnitudes: sized.magnitudes,
                count: family.places.len(),
                only_placed: false,
                loads,
            };
            match told.iter_mut().find(|all| all.goes_with(&own)) {
                Some(all) => all.take_in(own),
                None => told.push(own),
            }
        }
        if told.iter().any(|own| own.family == family.noun) {
            let ways = declarations.iter().enumerate();
            let ways = ways.filter(|(_, d)| tells_way(&d.statement, family));
            spent.extend(ways.map(|(at, _)| at));
        }
    }
    let mut place = 0..;
    declarations.retain(|_| place.next().is_none_or(|at| !spent.contains(&at)));
    told.extend(placed_forces(declarations));
    put_loads(declarations, &told, macros);
    let driven = told.iter().any(|own| own.only_placed) || !families.is_empty();
    if driven {
        tell_rates(declarations);
    }
    declarations.extend(said);
}

/// The letters of the loads of a family, and the noun that a sentence has for these.
fn sized(
    statement: &Statement,
    family: &Family,
    declarations: &[Declaration],
    macros: &Macros,
) -> Option<(Sized, NounPhrase)> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let (magnitudes, noun) = match (what.head, what.slots.as_slice()) {
        ("magnitude", [(Slot::Of, Term::Phrase(noun))]) => (true, &**noun),
        _ => (false, what),
    };
    let moments = is_load(noun)?;
    let of = of_family(noun, family)?;
    let place = |at: &Term| match at {
        Term::Phrase(place) => is_place(place),
        _ => false,
    };
    let known = noun.slots.iter().all(|(slot, term)| match slot {
        Slot::Of | Slot::Upon | Slot::Along => true,
        Slot::About | Slot::At => place(term),
        _ => false,
    });
    let letters = letters(subjects, &of, family, macros)?;
    let places = match (&of, letters.len()) {
        (Of::One(label), 1) => {
            let at = family.labels.iter().position(|own| own == label)?;
            vec![family.places[at].clone()]
        }
        _ => family.places.clone(),
    };
    let along = match noun.all(Slot::Along).collect::<Vec<_>>().as_slice() {
        [] => way(family, moments, declarations),
        [axis] => Some(written(axis)?),
        _ => return None,
    };
    // A length has no direction of its own.
    let directed = along.is_some() || !magnitudes;
    let plain = noun.adjectives.is_empty() && what.adjectives.is_empty();
    (known && plain && directed).then(|| {
        let sized = Sized {
            letters,
            places,
            along,
            moments,
            magnitudes,
        };
        (sized, noun.clone())
    })
}

/// Nouns of how fast each of a family turns.
const RATES: [&str; 5] = ["spin", "speed", "rate", "angular speed", ANGULAR_VELOCITY];

/// "`$a$` and `$b$` are the spins of the rotors", where no sentence tells of the rotors as bodies: letters of which nothing
/// else is known than that they change with the time.
fn tell_rates(declarations: &mut [Declaration]) {
    let turning: Vec<String> = declarations.iter().flat_map(tells_of_bodies).collect();
    for declaration in declarations {
        let Statement::Is { subjects, what } = &mut declaration.statement else {
            continue;
        };
        let letters = subjects.iter().all(|s| matches!(s, Term::Formula(_)));
        let plain = what.slots.iter().all(|(slot, term)| match slot {
            Slot::Of => family_noun(term).is_some_and(|noun| !turning.contains(&noun)),
            Slot::RelativeTo => true,
            _ => false,
        });
        let of = what.slot(Slot::Of).is_some();
        if letters && plain && of && subjects.len() > 1 && RATES.contains(&what.head) {
            *what = function_of_time();
        }
    }
}

/// The things of which a sentence tells more than how fast they turn and what they exert.
fn tells_of_bodies(declaration: &Declaration) -> Vec<String> {
    let told: Vec<Term> = match &declaration.statement {
        Statement::Does {
            subjects,
            verb,
            slots,
        } => match *verb {
            "turn" | "roll" | "spin" => subjects.clone(),
            "consist" => slots.iter().map(|(_, term)| term.clone()).collect(),
            _ => vec![],
        },
        Statement::Is { what, .. } if !RATES.contains(&what.head) && !is_place(what) => {
            if is_load(what).is_some() {
                return vec![];
            }
            let slots = what.slots.iter();
            let whose = slots.filter(|(slot, _)| matches!(slot, Slot::Of | Slot::FixedIn));
            whose.map(|(_, term)| term.clone()).collect()
        }
        _ => vec![],
    };
    told.iter().filter_map(family_noun).collect()
}

/// Whether a noun is that of a moment, and not of a force.
fn is_load(noun: &NounPhrase) -> Option<bool> {
    let moment = MOMENTS.contains(&noun.head);
    (moment || FORCES.contains(&noun.head)).then_some(moment)
}

/// Of which of a family a load is.
fn of_family(noun: &NounPhrase, family: &Family) -> Option<Of> {
    let own = |slot: Slot| {
        noun.all(slot)
            .find_map(|term| family_of(term, &family.noun))
    };
    own(Slot::Of).or_else(|| own(Slot::Upon))
}

/// Whether a load is that of each of a family.
fn of_all(noun: &NounPhrase, family: &Family) -> bool {
    match of_family(noun, family) {
        Some(Of::All) => true,
        Some(Of::One(index)) => !family.labels.contains(&index),
        None => false,
    }
}

/// What exerts the loads on each of a family: "the forces of the air on the rotors".
fn agent(noun: &NounPhrase, family: &Family) -> Option<Term> {
    let mut others = noun
        .all(Slot::Of)
        .filter(|term| family_of(term, &family.noun).is_none());
    others.next().cloned()
}

/// The letter of each: as many as there are, or one with the index in the place of the number.
fn letters(subjects: &[Term], of: &Of, family: &Family, macros: &Macros) -> Option<Vec<Formula>> {
    let count = family.places.len();
    let all: Option<Vec<Formula>> = subjects
        .iter()
        .map(|subject| match subject {
            Term::Formula(letter) => Some(letter.clone()),
            _ => None,
        })
        .collect();
    match (all?.as_slice(), of) {
        (all, Of::All) if all.len() == count => Some(all.to_vec()),
        // Only as a label a letter is an index: else it may be a coefficient.
        ([one], Of::All) => ["i", "j", "k", "n"].iter().find_map(|index| {
            let label = [format!("_{index}"), format!("_{{{index}}}")];
            if !label
                .iter()
                .any(|label| one.source.contains(label.as_str()))
            {
                return None;
            }
            let labels = family.labels.iter();
            let each = labels.map(|label| numbered(one, index, label, macros));
            each.collect()
        }),
        ([one], Of::One(index)) if !family.labels.contains(index) => {
            let each = family.labels.iter();
            let each = each.map(|label| numbered(one, index, label, macros));
            each.collect()
        }
        ([one], Of::One(label)) if family.labels.contains(label) => Some(vec![one.clone()]),
        _ => None,
    }
}

/// Along what the loads of a family point, if a sentence tells it: "the thrust of each rotor points along z".
fn way(family: &Family, moments: bool, declarations: &[Declaration]) -> Option<String> {
    let mut ways = declarations.iter().filter_map(|d| {
        let (subjects, slots) = d.statement.does("point").or(d.statement.does("act"))?;
        let [Term::Phrase(noun)] = subjects else {
            return None;
        };
        let own = is_load(noun)? == moments && of_all(noun, family);
        let along = slot(slots, Slot::Along).map(|axis| (axis, false));
        let against = slot(slots, Slot::With).map(|axis| (axis, true));
        let (axis, against) = along.or(against).filter(|_| own)?;
        let axis = written(axis)?;
        Some(if against { opposite(&axis) } else { axis })
    });
    let first = ways.next()?;
    ways.all(|other| other == first).then_some(first)
}

/// Whether all that a sentence tells is where the loads of a family act and along what.
fn tells_way(statement: &Statement, family: &Family) -> bool {
    let place = |at: &Term| match at {
        Term::Phrase(place) => is_place(place),
        _ => false,
    };
    match statement.does("point").or(statement.does("act")) {
        Some(([Term::Phrase(noun)], slots)) => {
            let own = is_load(noun).is_some() && of_all(noun, family);
            let letterless = noun.slot(Slot::Which).is_none();
            own && letterless
                && slots.iter().all(|(slot, term)| match slot {
                    Slot::At => place(term),
                    slot => matches!(slot, Slot::Along | Slot::With),
                })
        }
        _ => match statement {
            Statement::Premise(noun) => {
                let directed = noun.is("parallel") && is_load(noun).is_some();
                directed && of_family(noun, family).is_some()
            }
            _ => false,
        },
    }
}

/// Whether a sentence tells where loads act or along what in a way that is not worked with: of one of them, or at a place of its
/// own.
fn tells_otherwise(statement: &Statement, family: &Family) -> bool {
    match statement.does("point").or(statement.does("act")) {
        Some(([Term::Phrase(noun)], _)) => {
            let letterless = noun.slot(Slot::Which).is_none() && is_load(noun).is_some();
            let own = of_family(noun, family).is_some() || noun.slots.is_empty();
            letterless && own && !tells_way(statement, family)
        }
        _ => false,
    }
}

/// An axis as it stands in a formula.
fn written(axis: &Term) -> Option<String> {
    match axis {
        Term::Name(name) => Some(name.clone()),
        Term::Formula(formula) => Some(formula.source.clone()),
        _ => None,
    }
}

fn opposite(axis: &str) -> String {
    match axis.trim().strip_prefix('-') {
        Some(axis) => axis.trim().to_owned(),
        None => format!("-{axis}"),
    }
}

impl Sized {
    /// The loads as vectors.
    fn loads(&self, macros: &Macros) -> Option<Vec<Formula>> {
        let Some(axis) = &self.along else {
            return Some(self.letters.clone());
        };
        let (sign, axis) = match axis.trim().strip_prefix('-') {
            Some(axis) => ("-", axis.trim()),
            None => ("", axis.trim()),
        };
        let vector = |letter: &Formula| {
            let sum = letter.source.contains(['+', '-']);
            let own = match sum {
                true => format!("\\left({}\\right)", letter.source),
                false => letter.source.clone(),
            };
            formula(&format!("{sign}{own} {axis}"), false, macros)
        };
        self.letters.iter().map(vector).collect()
    }

    /// What their sum is: of lengths along one axis the sum of these, else that of the vectors.
    fn sum(&self, loads: &[Formula]) -> Vec<String> {
        let along = self.magnitudes || self.along.is_some();
        let all = if along { &self.letters } else { loads };
        all.iter().map(|letter| letter.source.clone()).collect()
    }
}

/// That each force acts where the one is that exerts it, and each moment on the body on which the loads act.
fn acting(
    loads: &[Formula],
    sized: &Sized,
    family: &Family,
    noun: &NounPhrase,
    declarations: &[Declaration],
) -> Option<Vec<Statement>> {
    let body = match sized.moments {
        true => Some(loaded(noun, family, declarations)?),
        false => None,
    };
    let each = loads.iter().zip(&sized.places).map(|(load, place)| {
        let slot = match &body {
            Some(body) => (Slot::Of, body.clone()),
            None => (Slot::At, place.clone()),
        };
        let head = if sized.moments { MOMENT } else { FORCE };
        let which = vec![(Slot::Which, Term::Formula(load.clone()))];
        Statement::Does {
            subjects: vec![Term::Phrase(Box::new(NounPhrase::new(head, which)))],
            verb: "act",
            slots: vec![slot],
        }
    });
    Some(each.collect())
}

/// The body on which the loads act: that which the sentence names, or the one whose only loads a sentence lists.
fn loaded(noun: &NounPhrase, family: &Family, declarations: &[Declaration]) -> Option<Term> {
    let named = noun.slot(Slot::Upon);
    if let Some(named) = named.filter(|term| family_of(term, &family.noun).is_none()) {
        return Some(named.clone());
    }
    let mut lists = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Premise(list) if list.is("only") => list.slot(Slot::Of),
        _ => None,
    });
    let first = lists.next()?;
    lists.all(|other| other == first).then(|| first.clone())
}
