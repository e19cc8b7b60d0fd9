//! News: lines that say of forces, moments and symbols of the document what nothing before determines.

use crate::algebra::{Fraction, Polynomial, Variable};
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, inner, undotted};
use crate::verify::lines::line::Read;
use crate::verify::theory::decide::Equation;
use crate::verify::values::atoms::{Atom, Owner, variable_fraction};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::value::Value;
use crate::verify::verdict::{Finding, Verdict};
use crate::verify::words::torque_free::speaks_of_a_torque;
use num_traits::Zero;

impl Checker<'_> {
    pub(crate) fn is_new_fact(&mut self, sides: &[Node]) -> bool {
        let read = self.read(sides, Frame::Moving);
        read.is_ok_and(|read| self.is_news(&sides[0], &read))
    }

    /// Whether a line says something of a symbol of the document that nothing before determines: a force and what it
    /// does, or how such symbols balance. It may be true or not, and no line so far can tell.
    pub(crate) fn is_news(&mut self, first: &Node, read: &Read) -> bool {
        let [equation] = read.equations.as_slice() else {
            return false;
        };
        let alone = matches!(undotted(first).kind, Kind::Symbol(_));
        // How a momentum about another point changes is for a law to say.
        let changes = matches!(inner(first).kind, Kind::TimeDerivative { .. });
        if changes
            && self
                .entities([first])
                .into_iter()
                .any(|e| self.is_about_another_point(e))
        {
            return false;
        }
        let entries = equation.residual.entries.iter();
        let rests: Vec<Fraction> = entries.map(|entry| self.theory.normal(entry)).collect();
        let differs = |rest: &Fraction| !rest.is_zero();
        if !rests.is_empty() && rests.iter().all(|rest| self.is_balance_of_forces(rest)) {
            return true;
        }
        rests.iter().any(differs)
            && rests.iter().enumerate().all(|(i, rest)| {
                let entry = |side: &Value| side.entries.get(i).cloned();
                let named = entry(&equation.left).and_then(|left| left.as_variable());
                match named.filter(|_| alone) {
                    _ if !differs(rest) => true,
                    Some(v) => self.is_value(v, entry(&equation.right), rest),
                    // What an equation of motion says of them is not that they vanish.
                    None => !self.moment_at(equation, i) && self.is_balance(rest),
                }
            })
    }

    /// Whether a difference from a variable says what that is, of which the document says nothing else.
    fn is_value(&mut self, variable: Variable, value: Option<Fraction>, rest: &Fraction) -> bool {
        // What a velocity is may stand on a line that was left open.
        let of_theory = matches!(self.theory.atoms.owner(variable), Some(Owner::Quantity(..)));
        let entity = self.theory.atoms.entity_of(variable);
        if of_theory && entity.is_some_and(|entity| self.is_in_doubt(entity)) {
            return false;
        }
        // What stands on the right by earlier lines is no news.
        let Some(value) = value.map(|value| self.theory.normal(&value)) else {
            return false;
        };
        let mut met = value.variables().into_iter();
        !met.any(|v| self.theory.atoms.with_arguments(v).contains(&variable))
            && self.is_own(variable)
            && self.is_solved_by_own(rest, variable)
    }

    /// Whether what must vanish relates symbols of the document, and nothing before speaks of one of them.
    fn is_balance(&mut self, rest: &Fraction) -> bool {
        let variables = rest.variables();
        let untouched = |&v: &Variable| self.is_own(v) && !self.theory.mentions(v);
        !variables.is_empty()
            && variables.iter().all(untouched)
            && variables.iter().all(|&v| is_solved_by(rest, v))
    }

    /// Whether what must vanish is a sum of forces along one line, ⟨F_A + F_B = 0⟩: no law here says what others act.
    fn is_balance_of_forces(&self, rest: &Fraction) -> bool {
        let force = |v: Variable| match self.theory.atoms.owner(v) {
            Some(Owner::Symbol(key)) => {
                let letter = key.split(' ').next().unwrap_or_default();
                let quantity = self.reading.quantities.get(&Letter::plain(letter));
                quantity == Some(&Quantity::Force)
            }
            _ => false,
        };
        let variables = rest.variables();
        let linear = rest.numerator().len() == variables.len() && rest.is_polynomial();
        variables.len() > 1 && linear && variables.into_iter().all(force)
    }

    /// A moment or a force by symbols of the document, one of them new: what acts on the body.
    pub(crate) fn is_load(&mut self, sides: &[Node], read: &Read) -> bool {
        let [left, right] = sides else { return false };
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return false;
        };
        let Some(entity) = self.entity_named(symbol) else {
            return false;
        };
        // What several forces come to follows from where and how they act.
        let sums = [
            "combine to",
            "add up to",
            "sum up to",
            "together give",
            "amount to",
        ];
        if sums.iter().any(|words| self.sentence.contains(words)) {
            return false;
        }
        let load = |q: &Quantity| matches!(q, Quantity::Moment | Quantity::Force);
        let owner = &self.theory.atoms.info(entity).owner;
        let acts = matches!(owner, Owner::Quantity(quantity, variant) if load(quantity) && variant.is_empty());
        let beside = self.theory.setting.other_moments.has(entity);
        if !acts && (!beside || self.asserted || self.obtained) {
            return false;
        }
        let by_gradient = self.is_gravity_gradient(read);
        let mut new = vec![];
        for entity in self.entities([right]) {
            match &self.theory.atoms.info(entity).owner {
                Owner::Symbol(key) if key.ends_with(" number") => return false,
                Owner::Symbol(_)
                    if self.loads.contains(&entity) || !self.theory.mentions_entity(entity) =>
                {
                    new.push(entity);
                }
                Owner::Quantity(Quantity::Inertia, _) if by_gradient => {}
                Owner::Quantity(Quantity::Inertia | Quantity::Momentum | Quantity::Moment, _) => {
                    return false;
                }
                _ => {}
            }
        }
        let first = by_gradient && !self.theory.mentions_entity(entity);
        let load = (first || !new.is_empty()) && read.equations.len() == 1;
        if load {
            self.loads.extend(new);
        }
        load
    }

    /// Whether an equation of motion holds but for symbols of the document and rates of turning, where no letter stands
    /// for a moment: these are what acts, as in `I\dot\omega_1 + … = -c\omega_1`.
    pub(crate) fn writes_load_out(&mut self, read: &Read) -> bool {
        if self.writes_moments() || !speaks_of_a_torque(self.text.lower()) {
            return false;
        }
        let moment = self.theory.atoms.quantity(Quantity::Moment);
        let moments = [0, 1, 2].map(|c| self.theory.atoms.value(moment, c, 0));
        let moments = moments.map(|moment| self.theory.normal(&moment));
        // What acts is written out once.
        let open = |moment: &Fraction| !self.is_load_by_rates(moment);
        let moments: Vec<Fraction> = moments.into_iter().filter(open).collect();
        let entries: Vec<Fraction> = read.residuals().cloned().collect();
        entries.iter().all(|entry| {
            let rest = self.theory.normal(entry);
            let mut loads = moments
                .iter()
                .flat_map(|moment| [rest.clone() - moment.clone(), rest.clone() + moment.clone()]);
            loads.any(|load| self.is_load_by_rates(&load))
        })
    }

    /// Whether a value is made of symbols of the document, one at least, and of how the body turns.
    fn is_load_by_rates(&self, load: &Fraction) -> bool {
        let atoms = &self.theory.atoms;
        let own = |v: &Variable| matches!(atoms.owner(*v), Some(Owner::Symbol(_)));
        let turns = |v: &Variable| {
            matches!(atoms.atom(*v), Atom::Part { order: 0, .. })
                && matches!(
                    atoms.owner(*v),
                    Some(Owner::Quantity(Quantity::AngularVelocity, _))
                )
        };
        let variables = load.variables();
        variables.iter().any(own) && variables.iter().all(|v| own(v) || turns(v))
    }

    /// `N = l × W = …`: what acts, and what that comes to.
    pub(crate) fn hands_over_a_load(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        // After lines that were left open, what the moment is may follow from them.
        if sides.len() < 3 || self.asserted || self.has_doubts() {
            return false;
        }
        let Ok(read) = self.read(&sides[..2], Frame::Moving) else {
            return false;
        };
        if !self.is_load(&sides[..2], &read) {
            return false;
        }
        self.given(&sides[..2], finding);
        if finding.verdict == Verdict::Accepted {
            finding.verdict = Verdict::Undecided;
            self.claim(&sides[1..], finding);
        }
        true
    }

    fn moment_at(&self, equation: &Equation, place: usize) -> bool {
        let entry = equation.residual.entries.get(place);
        entry.is_some_and(|entry| self.has_moment(entry))
    }

    /// Whether the moment stands in what must vanish.
    pub(crate) fn has_moment(&self, entry: &Fraction) -> bool {
        let moment = |v: u32| matches!(self.theory.atoms.owner(v), Some(Owner::Quantity(Quantity::Moment, variant)) if variant.is_empty());
        entry.variables().into_iter().any(moment)
    }

    /// Whether a variable is a symbol of the document, or a force or velocity, that nothing determines.
    fn is_own(&mut self, variable: Variable) -> bool {
        self.is_own_free(variable) || self.is_length_of_own(variable)
    }

    /// Whether a variable is by definition a free component of a vector of the document over its length: of R/R.
    fn is_length_of_own(&mut self, variable: Variable) -> bool {
        let value = self.theory.normal(&variable_fraction(variable));
        let own = |v: u32| matches!(self.theory.atoms.owner(v), Some(Owner::Symbol(_)));
        value.variables().into_iter().all(own) && is_quotient(&value)
    }

    fn is_own_free(&mut self, variable: Variable) -> bool {
        let own = match self.theory.atoms.owner(variable) {
            Some(Owner::Symbol(_)) => true,
            Some(Owner::Quantity(quantity, variant)) => {
                matches!(quantity, Quantity::Force | Quantity::OriginVelocity)
                    || *quantity == Quantity::Velocity && !variant.is_empty()
            }
            None => false,
        };
        own && self
            .theory
            .normal(&variable_fraction(variable))
            .as_variable()
            == Some(variable)
    }

    /// Whether a difference says what a variable is, or what the acceleration is that a force gives.
    fn is_solved_by_own(&mut self, difference: &Fraction, variable: Variable) -> bool {
        let value = self.theory.normal(&variable_fraction(variable));
        let acceleration = |v: Variable| {
            let owner = self.theory.atoms.owner(v);
            matches!(owner, Some(Owner::Quantity(Quantity::Acceleration, _)))
        };
        let mut variables = value.variables().into_iter();
        let part = is_quotient(&value).then(|| value.numerator().variables().first().copied());
        let part = part.flatten();
        let Some(own) = variables.find(|&v| v == variable || acceleration(v) || Some(v) == part)
        else {
            return false;
        };
        let above = difference.numerator();
        let factor = above.coefficient_of(own, 1);
        above.degree_in(own) == 1
            && (factor.is_constant().is_some() || self.theory.never_zero(&factor))
    }
}

/// Whether a value is one variable over another.
fn is_quotient(value: &Fraction) -> bool {
    let lone = |p: &Polynomial| {
        p.len() == 1 && matches!(p.variables().as_slice(), [v] if p.degree_in(*v) == 1)
    };
    lone(value.numerator()) && lone(value.denominator())
}

/// Whether a difference is a number times a variable, and more without it.
fn is_solved_by(difference: &Fraction, variable: Variable) -> bool {
    let above = difference.numerator();
    above.degree_in(variable) == 1
        && above.coefficient_of(variable, 1).is_constant().is_some()
        && !difference.denominator().variables().contains(&variable)
}
