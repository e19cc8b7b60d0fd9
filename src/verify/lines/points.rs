//! What a symbol is that a claim is the first to speak of, where its name and the laws say so: the acceleration of a point
//! whose velocity is known, the angular momentum about a second point, the moment of inertia about an axis.

use crate::algebra::{Fraction, Rational, Variable};
use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::two_points::every_symbol;
use crate::verify::letters::usage::{Letter, inner, symbols};
use crate::verify::theory::law::inertia;
use crate::verify::theory::{Premise, Taken};
use crate::verify::values::atoms::{Entity, variable_fraction};
use crate::verify::values::lower::constant;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::values::value::Value;
use crate::verify::verdict::{Finding, Verdict};
use nalgebra::Vector3;

/// The value that a law gives to a new symbol.
pub(crate) struct Law {
    name: &'static str,
    entity: Entity,
    value: Value,
    /// The power of the symbol that has the value.
    power: u32,
    /// What vanishes beside: the length of a unit vector less one.
    beside: Vec<Fraction>,
    /// Whether words say so, and the line is no definition then, whatever becomes of it.
    said: bool,
}

impl Law {
    /// A law that gives an entity its value.
    pub(crate) fn new(name: &'static str, entity: Entity, value: Value) -> Self {
        Self {
            name,
            entity,
            value,
            power: 1,
            beside: vec![],
            said: false,
        }
    }

    /// The same, as words have it.
    pub(crate) fn said(self) -> Self {
        Self { said: true, ..self }
    }

    /// The same with the value's sign turned round.
    pub(crate) fn negated(self) -> Self {
        let value = self.value.negated();
        Self { value, ..self }
    }

    /// The same, where the value is that of the entity's square.
    pub(crate) fn squared(self) -> Self {
        Self { power: 2, ..self }
    }
}

impl Checker<'_> {
    /// Lets laws say what the new symbols of a claim are, where it can be decided with them.
    pub(crate) fn tie_new_symbols(&mut self, sides: &[Node], finding: &Finding) {
        let mut taken = vec![];
        let laws = self.laws_of_new_symbols(sides);
        let said = laws.iter().any(|law| law.said);
        for law in laws {
            taken.extend(self.take_law(law));
        }
        if taken.is_empty() {
            return;
        }
        let verdict = self.verdict_as_claim(sides, finding);
        if !said && !matches!(verdict, Verdict::Proved(_) | Verdict::Refuted) {
            taken.push(self.line_name(finding));
            self.scopes.retain(|(name, _)| !taken.contains(name));
            self.theory.retain(|premise| !taken.contains(&premise.name));
        }
    }

    fn laws_of_new_symbols(&mut self, sides: &[Node]) -> Vec<Law> {
        let met: Vec<&Symbol> = sides.iter().flat_map(symbols).collect();
        let Some(first) = sides.first().map(inner) else {
            return vec![];
        };
        self.note_points_at_rest(&met);
        let mut laws: Vec<Law> = self.law_in_words(first, sides.get(1)).into_iter().collect();
        laws.extend(met.iter().find_map(|s| self.turned_round(s)));
        laws.extend(self.moment_about_gimbal(sides));
        laws.extend(self.frequency_in_equation(sides));
        let framed: Vec<Law> = met.iter().filter_map(|s| self.in_named_frame(s)).collect();
        let of_points = framed.is_empty();
        laws.extend(met.iter().filter_map(|s| self.beside_a_prime(s, &met)));
        laws.extend(framed);
        let Kind::Symbol(left) = &first.kind else {
            return laws;
        };
        laws.extend(self.points_of_one_body(left, &met));
        laws.extend(self.element_about_fixed_point(left, &met));
        laws.extend(self.rate_of_position(left, sides));
        if of_points && self.is_new(left) && is_acceleration(left) && self.is_velocity_known(left) {
            let points = met.iter().filter(|s| is_acceleration(s));
            laws.extend(points.filter_map(|s| self.acceleration(s)));
        }
        laws.extend(self.momentum_about(left, &met));
        if self.is_new(left) {
            laws.extend(self.total_energy(left));
        }
        laws.extend(met.iter().filter_map(|s| self.moment_about_axis(s)));
        laws
    }

    pub(crate) fn take_law(&mut self, law: Law) -> Option<String> {
        let entries = law.value.entries.iter().enumerate();
        let (preferred, residuals): (Vec<Variable>, Vec<Fraction>) = entries
            .map(|(i, entry)| {
                let variable = self.theory.atoms.part(law.entity, i as u8, 0);
                let own = variable_fraction(variable);
                let powers = std::iter::repeat_n(&own, law.power as usize);
                let power = powers.fold(constant(Rational::from(1)), |whole, own| {
                    whole * own.clone()
                });
                (variable, power - entry.clone())
            })
            .unzip();
        let latex = self.theory.atoms.info(law.entity).latex.clone();
        let name = format!("{}: {latex}", law.name);
        self.theory.atoms.info_mut(law.entity).constant = false;
        let taken = self.theory.assume(Premise {
            name: name.clone(),
            residuals,
            preferred,
            definition: true,
        });
        if !matches!(taken, Taken::Solved | Taken::Kept) {
            return None;
        }
        if !law.beside.is_empty() {
            self.theory.assume(Premise {
                name: name.clone(),
                residuals: law.beside,
                preferred: vec![],
                definition: true,
            });
        }
        self.keep(&name, true);
        Some(name)
    }

    /// Whether nothing has said of a symbol what it is.
    pub(crate) fn is_new(&mut self, symbol: &Symbol) -> bool {
        let Meaning::Whole(entity) = self.meaning_of(symbol) else {
            return false;
        };
        self.is_free(entity) && !self.theory.mentions_entity(entity)
    }

    fn is_velocity_known(&mut self, acceleration: &Symbol) -> bool {
        let velocity = self.entity_named(&velocity(acceleration));
        velocity.is_some_and(|velocity| !self.is_free(velocity))
    }

    /// a = dv/dt of the same point, seen from space.
    fn acceleration(&mut self, symbol: &Symbol) -> Option<Law> {
        let velocity = self.entity_named(&velocity(symbol))?;
        let known = !self.is_free(velocity) || self.theory.mentions_entity(velocity);
        if !self.is_new(symbol) || !known {
            return None;
        }
        let entity = self.entity_named(symbol)?;
        let velocity = Value::column(self.theory.atoms.vector(velocity, 0));
        let value = self.lowering(Frame::Space).space_rate(&velocity);
        Some(Law::new("kinematics", entity, value))
    }

    /// L_P = L_C + r × m v_C with r from P to the mass centre C.
    fn momentum_about(&mut self, symbol: &Symbol, met: &[&Symbol]) -> Option<Law> {
        let quantity =
            |checker: &Self, s: &Symbol| checker.reading.quantities.get(&Letter::of(s)).copied();
        let new = self.is_new(symbol) && symbol.style.vector;
        if !new || quantity(self, symbol) != Some(Quantity::Momentum) {
            return None;
        }
        let point = label(symbol).filter(|point| !point.is_empty())?;
        let main = self.theory.atoms.quantity(Quantity::Momentum);
        let central = met
            .iter()
            .find(|s| self.meaning_of(s) == Meaning::Whole(main))?;
        let centre = label(central).filter(|centre| !centre.is_empty())?;
        let mut moving = met.iter().filter(|s| matches!(s.name.as_str(), "v" | "V"));
        let velocity = moving.next().filter(|s| label(s) == Some(centre))?;
        if moving.next().is_some() {
            return None;
        }
        let (offset, sign) = met.iter().find_map(|s| {
            let sign = self.leads(s, point, centre)?;
            Some((self.entity_named(s)?, sign))
        })?;
        let velocity = self.entity_named(velocity)?;
        self.known.extend([offset, velocity]);
        let [offset, velocity] =
            [offset, velocity].map(|e| Value::column(self.theory.atoms.vector(e, 0)));
        let mass = self.theory.atoms.quantity(Quantity::Mass);
        let mass = self.theory.atoms.value(mass, 0, 0);
        let own = Value::column(self.theory.atoms.vector(main, 0));
        let shift = offset.cross(&velocity).ok()?.scaled(&mass);
        let value = own.plus(&shift, !sign).ok()?;
        let entity = self.entity_named(symbol)?;
        Some(Law::new("momentum about another point", entity, value).said())
    }

    /// Whether a vector leads from a point to another, or the other way (false).
    pub(crate) fn leads(&self, symbol: &Symbol, from: &str, to: &str) -> Option<bool> {
        let index = symbol.subscripts.concat();
        let (there, back) = (format!("{from}{to}"), format!("{to}{from}"));
        let arrow = symbol.style.vector && index.is_empty();
        match () {
            () if arrow && symbol.name == there => Some(true),
            () if arrow && symbol.name == back => Some(false),
            () if index == format!("{to}/{from}") => Some(true),
            () if index == format!("{from}/{to}") => Some(false),
            () if (index == there || index == back) && self.says_from(from, to) => Some(true),
            () if (index == there || index == back) && self.says_from(to, from) => Some(false),
            () => None,
        }
    }

    /// Whether the words have "from P to C".
    fn says_from(&self, from: &str, to: &str) -> bool {
        let text = &self.document.source.text;
        let plain: String = text
            .chars()
            .filter(|c| !matches!(c, '$' | '\\' | '(' | ')'))
            .collect();
        plain.contains(&format!("from {from} to {to}"))
    }

    /// I_u = u·(I u) for a unit vector u.
    pub(crate) fn moment_about_axis(&mut self, symbol: &Symbol) -> Option<Law> {
        let letter = Letter::of(symbol);
        if self.reading.quantities.get(&letter) != Some(&Quantity::Inertia) || !self.is_new(symbol)
        {
            return None;
        }
        let [index] = symbol.subscripts.as_slice() else {
            return None;
        };
        let unit = |s: &&Symbol| s.style.hat && s.name == *index && s.subscripts.is_empty();
        let direction = every_symbol(self.document).into_iter().find(unit)?;
        let Meaning::Whole(direction) = self.meaning_of(direction) else {
            return None;
        };
        let entity = self.entity_named(symbol)?;
        let along = Vector3::from(self.theory.atoms.vector(direction, 0));
        let unit = vec![along.dot(&along) - Fraction::from_ratio(1, 1)];
        let tensor = inertia(&mut self.theory.atoms, self.theory.setting.products);
        let value = Value::scalar(along.dot(&(tensor * along.clone())));
        Some(Law {
            beside: unit,
            ..Law::new("inertia about an axis", entity, value)
        })
    }
}

/// The letter of a point at a symbol, or none.
pub(crate) fn label(symbol: &Symbol) -> Option<&str> {
    match symbol.subscripts.as_slice() {
        [] => Some(""),
        [one] if one.len() == 1 && one.chars().all(|c| c.is_ascii_uppercase()) => Some(one),
        _ => None,
    }
}

fn is_acceleration(symbol: &Symbol) -> bool {
    let bare = symbol.superscripts.is_empty() && symbol.primes == 0;
    symbol.name == "a" && symbol.style.vector && bare && label(symbol).is_some()
}

fn velocity(acceleration: &Symbol) -> Symbol {
    Symbol {
        name: "v".to_owned(),
        ..acceleration.clone()
    }
}
