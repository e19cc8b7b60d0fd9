//! Decides an equation: filter, proof, counterexample, in that order.

use crate::algebra::{Fraction, Proof, Rational};
use crate::mechanics::possible_body;
use crate::notation::ast::Function;
use crate::scalar::{Prime, Surd};
use crate::verify::names::latex;
use crate::verify::reason;
use crate::verify::theory::attitude_law::{UNIT, number_of_quaternion};
use crate::verify::theory::certify::certify;
use crate::verify::theory::kept::Kept;
use crate::verify::theory::law::inertia;
use crate::verify::theory::substances::Witness;
use crate::verify::theory::world::{Substance, World};
use crate::verify::theory::{Name, Theory};
use crate::verify::values::atoms::Atom;
use crate::verify::values::figures::is_pi;
use crate::verify::values::value::{ShapeMismatch, Value};
use crate::verify::verdict::Counterexample;
use foldhash::HashSet;
use num_traits::Zero;
use std::collections::BTreeSet;

/// The premise that a rotor is all that has inertia in a document.
pub(crate) const ROTOR_ALONE: &str = "the moment is the one on the rotor";
/// Worlds that are tried for one in which everything has a value.
const TRIES: u64 = 24;

/// An equation between two values of one shape.
#[derive(Clone, Debug)]
pub(crate) struct Equation {
    /// The left side.
    pub left: Value,
    /// The right side.
    pub right: Value,
    /// Left less right.
    pub residual: Value,
}

impl Equation {
    pub(crate) fn between(left: Value, right: Value) -> Result<Self, ShapeMismatch> {
        let residual = left.plus(&right, true)?;
        Ok(Self {
            left,
            right,
            residual,
        })
    }

    pub(crate) fn of_scalars(left: Fraction, right: Fraction) -> Self {
        let residual = left.clone() - right.clone();
        let [left, right, residual] = [left, right, residual].map(Value::scalar);
        Self {
            left,
            right,
            residual,
        }
    }

    /// A value and zero.
    pub(crate) fn vanishing(value: Value) -> Self {
        Self {
            right: value.map(|_| Fraction::zero()),
            residual: value.clone(),
            left: value,
        }
    }
}

/// What came out.
#[derive(Clone, Debug)]
pub(crate) enum Decision {
    /// It was proved.
    True(Proof),
    /// It fails in a world of small integers.
    False(Box<Counterexample>),
    /// It fails in the prime field, and no small world was found to show it in.
    FalseWithoutWitness,
    /// Neither could be shown, for this reason.
    Open(String),
}

/// Whether an equation holds in a random world of the prime field, which a false one does with a chance of its degree
/// over 2⁶¹; `None` where no world gives it a value.
pub(crate) fn passes_filter(theory: &mut Theory, residual: &Value) -> Option<bool> {
    theory.follow_rates(&residual.entries);
    let found = match vanishes_in_a_world::<Prime>(theory, residual) {
        // Not every number has a root in the prime field; with one more root in it, it has.
        Ok(None) if has_root(theory, residual) => {
            vanishes_in_a_world::<Surd<Prime>>(theory, residual)
        }
        found => found,
    };
    found.unwrap_or_default()
}

/// Whether all entries vanish in the first world that gives them values, if there is one within the budget.
fn vanishes_in_a_world<T: Substance>(
    theory: &mut Theory,
    residual: &Value,
) -> Result<Option<bool>, Exhausted> {
    for seed in 1..=TRIES {
        let mut world: World<T> = World::resumed(theory, seed);
        let values: Option<Vec<T>> = residual.entries.iter().map(|e| world.fraction(e)).collect();
        world.leave();
        if std::mem::take(&mut theory.exhausted) {
            return Err(Exhausted);
        }
        if let Some(values) = values {
            return Ok(Some(values.iter().all(Zero::is_zero)));
        }
    }
    Ok(None)
}

/// The budget ended before a world was made.
struct Exhausted;

/// Whether a root stands in what some entries lead to.
fn has_root(theory: &mut Theory, value: &Value) -> bool {
    let reached = theory.reached_variables(value.entries.iter());
    let root = |v| {
        matches!(
            theory.atoms.atom(v),
            Atom::Kernel {
                function: Function::Sqrt,
                ..
            }
        )
    };
    reached.into_iter().any(root)
}

/// Decides equations that must hold together.
pub(crate) fn decide(theory: &mut Theory, equations: &[Equation]) -> Decision {
    let mut seen = true;
    for equation in equations {
        if equation.residual.entries.iter().any(|e| !e.is_valid()) {
            return Decision::Open("something is divided by zero".to_owned());
        }
        match passes_filter(theory, &equation.residual) {
            Some(false) => return refuted(theory, equation, equations),
            // The normal form may still vanish.
            None => seen &= vanishes(theory, std::slice::from_ref(equation)),
            Some(true) => {}
        }
    }
    // Where relations are kept, a proof may be had though no world was found that satisfies them.
    let proof = match seen || !theory.solution.relations.kept.is_empty() {
        true => certify(theory, equations),
        false => None,
    };
    let reason = match (proof, std::mem::take(&mut theory.exhausted)) {
        (Some(proof), _) => return Decision::True(proof),
        _ if !seen => reason::NO_VALUES,
        (None, true) => reason::BUDGET,
        (None, false) => reason::NO_PROOF,
    };
    Decision::Open(reason.to_owned())
}

/// Whether equations hold exactly, where no proof is to be shown.
pub(crate) fn vanishes(theory: &mut Theory, equations: &[Equation]) -> bool {
    let mut residuals = equations.iter().flat_map(|e| &e.residual.entries);
    let holds = residuals.all(|entry| {
        let normal = theory.normal(entry);
        theory.kernels_reduced(normal).is_zero()
    }) || !theory.solution.relations.kept.is_empty()
        && certify(theory, equations).is_some();
    holds && !std::mem::take(&mut theory.exhausted)
}

fn refuted(theory: &mut Theory, equation: &Equation, equations: &[Equation]) -> Decision {
    if rests_on_a_name(theory, equation) {
        return Decision::Open("it rests on a value that is only named here".to_owned());
    }
    // A normal form may have grown beyond all bounds; numbers do not.
    theory.exhausted = false;
    let found = counterexample(theory, equation);
    if let Some(found) = found {
        return Decision::False(Box::new(found));
    }
    let Some(name) = related(theory, equation) else {
        return Decision::FalseWithoutWitness;
    };
    // The relations may hold on several branches, and the filter look at one where the line fails.
    match certify(theory, equations) {
        Some(proof) => Decision::True(proof),
        None => Decision::Open(format!("{name} could not be solved for a symbol")),
    }
}

/// Whether a difference that is not zero in the prime field may still be zero for the document: something in it is only
/// named.
fn rests_on_a_name(theory: &mut Theory, equation: &Equation) -> bool {
    equation.residual.entries.iter().any(|entry| {
        let variables = theory.normal(entry).variables();
        let mut variables = variables.into_iter();
        variables.any(|v| {
            matches!(theory.atoms.atom(v), Atom::Opaque { .. }) && !is_pi(&theory.atoms, v)
        })
    })
}

/// The name of a relation that is kept and speaks of something in an equation.
fn related(theory: &mut Theory, equation: &Equation) -> Option<Name> {
    let kept = theory.solution.relations.kept.clone();
    let entries = equation.residual.entries.iter();
    let inside: BTreeSet<u32> = entries.flat_map(|e| theory.normal(e).variables()).collect();
    let mut speaks = |kept: &Kept| {
        let variables = theory.normal(&kept.written).variables();
        variables.iter().any(|v| inside.contains(v))
    };
    kept.into_iter()
        .find_map(|kept| speaks(&kept).then_some(kept.name))
}

/// A small world, with a body that can exist, in which the sides differ.
fn counterexample(theory: &mut Theory, equation: &Equation) -> Option<Counterexample> {
    theory.follow_rates(&equation.left.entries);
    theory.follow_rates(&equation.right.entries);
    let found = counterexample_in::<Rational>(theory, equation, TRIES * 8);
    if found.is_some() || !has_root(theory, &equation.residual) {
        return found;
    }
    counterexample_in::<Surd<Rational>>(theory, equation, TRIES)
}

fn counterexample_in<T: Witness>(
    theory: &mut Theory,
    equation: &Equation,
    tries: u64,
) -> Option<Counterexample> {
    for seed in 1..=tries + tries / 4 {
        // Beyond the budget every further world would only cost time.
        if theory.exhausted {
            return None;
        }
        let tensor = inertia(&mut theory.atoms, theory.setting.products);
        let bodiless = theory.premises().iter().any(|p| p.name == ROTOR_ALONE);
        let mut world: World<T> = World::new(theory, seed);
        if seed > tries {
            world.widen(tensor.as_slice());
        }
        world.draw_roots(equation.residual.entries.iter());
        let entries: Option<Vec<T>> = tensor.iter().map(|e| world.fraction(e)).collect();
        let Some(entries) = entries else { continue };
        if !bodiless && !can_exist(&entries) {
            continue;
        }
        let sides = |world: &mut World<T>, value: &Value| -> Option<Vec<T>> {
            value.entries.iter().map(|e| world.fraction(e)).collect()
        };
        let (Some(left), Some(right), Some(gap)) = (
            sides(&mut world, &equation.left),
            sides(&mut world, &equation.right),
            sides(&mut world, &equation.residual),
        ) else {
            continue;
        };
        let Some(place) = gap.iter().position(|g| !g.is_zero()) else {
            continue;
        };
        let exact = |values: &[T]| values.iter().all(T::is_exact);
        if !exact(&left) || !exact(&right) || !exact(&gap) {
            continue;
        }
        let side = |values: &[T]| {
            let shown = values.get(place).or(values.first());
            shown.map_or("0".to_owned(), T::to_string)
        };
        let mut variables: Vec<u32> = vec![];
        for value in [&equation.left, &equation.right] {
            let entry = value.entries.get(place).or(value.entries.first())?;
            variables.extend(
                entry
                    .variables()
                    .into_iter()
                    .filter(|v| !variables.contains(v))
                    .collect::<Vec<_>>(),
            );
        }
        let mut symbols = vec![];
        for variable in variables {
            let value = world.variable(variable)?;
            symbols.push((variable, value.to_string()));
        }
        if !world.is_coherent() {
            continue;
        }
        let symbols = symbols
            .into_iter()
            .map(|(v, value)| (latex(&theory.atoms, v), value))
            .collect();
        let component = component(&equation.residual, place);
        return Some(Counterexample {
            symbols,
            component,
            left: side(&left),
            right: side(&right),
        });
    }
    None
}

/// Whether a body can have a tensor, a thin rod included: its moment about itself is the limit zero.
fn can_exist<T: Witness>(tensor: &[T]) -> bool {
    let body = nalgebra::Matrix3::from_iterator(tensor.iter().map(T::approximate));
    let thickness = 1e-9 * body.trace();
    possible_body(&(body + nalgebra::Matrix3::from_diagonal_element(thickness))).is_ok()
}

/// The name of an entry of a grid.
pub(crate) fn component(value: &Value, place: usize) -> Option<String> {
    match (value.rows, value.columns) {
        (1, 1) => None,
        (3, 1) | (1, 3) => Some(["x", "y", "z"][place % 3].to_owned()),
        (_, columns) => Some(format!(
            "row {}, column {}",
            place / columns + 1,
            place % columns + 1
        )),
    }
}

/// The smallest set of named laws and premises that the equations need, found by leaving each out in turn; a proof that
/// is known tells of some that they are not needed.
pub(crate) fn needed(theory: &mut Theory, equations: &[Equation], proof: &Proof) -> Vec<Name> {
    let residuals: Vec<Fraction> = equations
        .iter()
        .flat_map(|e| e.residual.entries.clone())
        .collect();
    let names = reached(theory, &residuals);
    let mut dropped: BTreeSet<Name> = theory.left_out.clone();
    let mut kept = vec![];
    // As long as nothing that stands in the proof was left out, the proof holds.
    let (inside, mut whole) = (proof.premises(), true);
    for name in names {
        let mut without = dropped.clone();
        without.insert(name.clone());
        let stands = inside.contains(name.as_str());
        let holds = (whole && !stands)
            || theory.without(without.clone(), |theory| {
                equations
                    .iter()
                    .all(|e| passes_filter(theory, &e.residual) == Some(true))
            });
        if holds {
            dropped = without;
            whole &= !stands;
        } else {
            kept.push(name);
        }
    }
    kept
}

/// The names of all laws and premises that the variables of some fractions lead to; document premises first, so that
/// they are the first that are tried to be left out.
pub(crate) fn reached(theory: &mut Theory, fractions: &[Fraction]) -> Vec<Name> {
    let mut open: Vec<u32> = fractions.iter().flat_map(Fraction::variables).collect();
    let (mut seen, mut names) = (HashSet::default(), BTreeSet::new());
    let mut kept = theory.solution.relations.kept.clone();
    loop {
        let Some(variable) = open.pop() else {
            let speaks = |kept: &Kept| kept.written.variables().iter().any(|v| seen.contains(v));
            let Some(place) = kept.iter().position(speaks) else {
                break;
            };
            let relation = kept.remove(place);
            open.extend(relation.written.variables());
            names.insert(relation.name);
            continue;
        };
        if !seen.insert(variable) {
            continue;
        }
        if number_of_quaternion(&theory.atoms, variable).is_some() {
            names.insert(UNIT.to_owned());
        }
        if let Some(rule) = theory.rule(variable) {
            open.extend(rule.value.variables());
            if !rule.name.is_empty() {
                names.insert(rule.name);
            }
        }
    }
    let premises = theory.premises().iter();
    let document: BTreeSet<&str> = premises.map(|p| p.name.as_str()).collect();
    let (first, second): (Vec<_>, Vec<_>) = names
        .into_iter()
        .partition(|name| document.contains(name.as_str()));
    first.into_iter().chain(second).collect()
}
