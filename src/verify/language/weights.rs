//! Weights that are written out, and where potential energies are zero: "the weight `$mg$`" tells the letter of gravity.

use super::heads::{GRAVITY, MASS, POTENTIAL_ENERGY, WEIGHT};
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use super::terms::say_besides;
use crate::notation::ast::{Kind, Node};
use crate::notation::document::Row;

/// "`$V$` is the potential energy of the rod, zero at O": where it is zero is a sentence of its own.
fn tell_zeros(declarations: &mut Vec<Declaration>) {
    say_besides(declarations, |statement| {
        let Statement::Is { subjects, what } = statement else {
            return vec![];
        };
        let zero = what.slots.iter().position(|(_, term)| is_zero(term));
        let taken = zero
            .filter(|_| what.head == POTENTIAL_ENERGY)
            .map(|at| what.slots.remove(at));
        match taken {
            Some((_, Term::Phrase(zero))) => vec![Statement::Is {
                subjects: subjects.clone(),
                what: *zero,
            }],
            _ => vec![],
        }
    });
}

fn is_zero(term: &Term) -> bool {
    matches!(term, Term::Phrase(zero) if zero.head == "zero" && zero.slot(Slot::At).is_some())
}

/// "The weight `$mg$` and the force at O are the only loads": where m is a mass, g is the acceleration of gravity.
pub(crate) fn tell_gravity(declarations: &mut Vec<Declaration>) {
    tell_zeros(declarations);
    tell_products(declarations);
    let masses: Vec<String> = declarations.iter().flat_map(masses_in).collect();
    let mut found: Option<Declaration> = None;
    for declaration in declarations.iter_mut() {
        let before = declaration.clone();
        let (Statement::Premise(NounPhrase { slots, .. }) | Statement::Does { slots, .. }) =
            &mut declaration.statement
        else {
            continue;
        };
        for at in 0..slots.len() {
            let Some(weight) = written_weight(&slots[at].1) else {
                continue;
            };
            if !masses.contains(&weight.mass) {
                continue;
            }
            let slot = slots[at].0;
            slots[at].1 = Term::Phrase(Box::new(NounPhrase::new(WEIGHT, vec![])));
            slots.extend(weight.others.into_iter().map(|other| (slot, other)));
            found.get_or_insert(Declaration {
                statement: Statement::Is {
                    subjects: vec![Term::Formula(weight.gravity)],
                    what: NounPhrase::new(GRAVITY, vec![]),
                },
                ..before.clone()
            });
        }
    }
    let told = |d: &Declaration| matches!(&d.statement, Statement::Is { what, .. } if what.head == GRAVITY);
    if !declarations.iter().any(told) {
        declarations.extend(found);
    }
}

/// "`$mg$` is the weight of the rod", where the rod has the mass m and g is the acceleration of gravity: it says no more.
/// Where no sentence tells g it is that acceleration.
fn tell_products(declarations: &mut [Declaration]) {
    let telling: Vec<(String, Statement)> = declarations
        .iter()
        .flat_map(|d| masses_in(d).into_iter().map(|m| (m, d.statement.clone())))
        .collect();
    for declaration in declarations {
        let Statement::Is { subjects, what } = &mut declaration.statement else {
            continue;
        };
        let ([Term::Formula(product)], WEIGHT, [(Slot::Of, body)]) =
            (subjects.as_slice(), what.head, what.slots.as_slice())
        else {
            continue;
        };
        let Some((mass, gravity)) = mass_and_gravity(product) else {
            continue;
        };
        let of_body = |said: &Statement| match said {
            Statement::Is { subjects, what } => {
                subjects.contains(body) || what.head == MASS && what.slot(Slot::Of) == Some(body)
            }
            _ => false,
        };
        if telling.iter().any(|(m, said)| *m == mass && of_body(said)) {
            declaration.statement =
                Statement::one_is(Term::Formula(gravity), NounPhrase::new(GRAVITY, vec![]));
        }
    }
}

/// A weight with its formula.
struct Written {
    /// The letter of the mass.
    mass: String,
    gravity: Formula,
    /// Other loads that the list names behind it.
    others: Vec<Term>,
}

/// "the weight `$mg$`", "the weight of magnitude `$mg$`"
fn written_weight(term: &Term) -> Option<Written> {
    let Term::Phrase(weight) = term else {
        return None;
    };
    if weight.head != WEIGHT {
        return None;
    }
    let magnitude = weight.all(Slot::Of).find_map(|of| match of {
        Term::Phrase(size) if size.head == "magnitude" => size.slot(Slot::Which),
        _ => None,
    });
    let Some(Term::Formula(formula)) = weight.slot(Slot::Which).or(magnitude) else {
        return None;
    };
    let (mass, gravity) = mass_and_gravity(formula)?;
    let others = weight
        .all(Slot::Of)
        .filter(|of| !matches!(of, Term::Phrase(p) if p.head == "magnitude"));
    Some(Written {
        mass,
        gravity,
        others: others.cloned().collect(),
    })
}

/// The letters of "`$mg$`".
fn mass_and_gravity(formula: &Formula) -> Option<(String, Formula)> {
    let Row::Expression(node) = &formula.row else {
        return None;
    };
    let Kind::Product(factors) = &node.kind else {
        return None;
    };
    let is_g = |node: &Node| matches!(&node.kind, Kind::Symbol(symbol) if symbol.name == "g");
    match factors.as_slice() {
        [mass, gravity] if is_g(&gravity.node) => {
            Some((Formula::of(&mass.node).source, Formula::of(&gravity.node)))
        }
        _ => None,
    }
}

/// The letters that a sentence says to be masses.
fn masses_in(declaration: &Declaration) -> Vec<String> {
    let source = |term: &Term| match term {
        Term::Formula(Formula {
            row: Row::Expression(node),
            ..
        }) => Some(Formula::of(node).source),
        _ => None,
    };
    let own = match &declaration.statement {
        Statement::Is { subjects, what } if what.head == MASS => subjects.as_slice(),
        _ => &[],
    };
    let sizes = declaration
        .statement
        .terms()
        .into_iter()
        .filter_map(|term| match term {
            Term::Phrase(size) if size.head == MASS => size.slot(Slot::Which),
            _ => None,
        });
    own.iter().chain(sizes).filter_map(source).collect()
}
