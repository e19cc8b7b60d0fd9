//! Members of families, and sums over all of them.
//!
//! A sum is linear: what has no index comes out in front, and what is left is a variable for each product of indexed
//! ones. Of the particles of a rigid body three kinds of such products are laws: Σ m is the mass, Σ m ρ vanishes from
//! the mass centre, and Σ m ρ ρᵀ is ½ tr(I) 1 − I.

use crate::algebra::{Fraction, Monomial, Place, Polynomial, Rational, Variable};
use crate::verify::model::atoms::{Key, Law, Motion, Nature, fraction};
use crate::verify::model::system::{BodyId, ELEMENT, FamilyId, PointId, System, Vector};
use num_traits::{One, Zero};
use std::collections::BTreeSet;

impl System {
    /// The family that an index numbers.
    pub(crate) fn family_of(&self, index: &str) -> Option<FamilyId> {
        self.families
            .iter()
            .position(|f| f.indices.iter().any(|i| i == index))
    }

    /// The index that a label ends with, and the family that it numbers.
    pub(crate) fn index_in(&self, label: &str) -> Option<(FamilyId, String)> {
        let all = self.families.iter().enumerate();
        let indices =
            all.flat_map(|(family, f)| f.indices.iter().map(move |i| (family, i.clone())));
        let fitting =
            indices.filter(|(_, index)| !index.is_empty() && label.ends_with(index.as_str()));
        fitting.max_by_key(|(_, index)| index.len())
    }

    fn tag(&self, family: FamilyId) -> &str {
        match self.families[family].name.as_str() {
            "particle" | "element" | "point mass" | "mass" => "",
            other => other,
        }
    }

    /// The mass of a member.
    pub(crate) fn member_mass(&mut self, family: FamilyId, index: &str) -> Fraction {
        let tag = self.tag(family).to_owned();
        let key = Key::of_member(subscripted("m", &tag, index), index);
        fraction(self.atoms.variable(key, Place::Parameter, Motion::Constant))
    }

    /// The volume of a member: its mass by the density, where that is the same for all.
    pub(crate) fn member_volume(&mut self, family: FamilyId, index: &str) -> Fraction {
        match self.families[family].density.clone() {
            Some(density) => self.member_mass(family, index) / density,
            None => self.own_volume(index),
        }
    }

    /// The density of a member: its mass by its volume, or that of all.
    pub(crate) fn member_density(&mut self, family: FamilyId, index: &str) -> Fraction {
        match self.families[family].density.clone() {
            Some(density) => density,
            None => self.member_mass(family, index) / self.own_volume(index),
        }
    }

    fn own_volume(&mut self, index: &str) -> Fraction {
        let key = Key::of_member(subscripted("V", "", index), index);
        fraction(self.atoms.variable(key, Place::Parameter, Motion::Constant))
    }

    /// Whether a value speaks of one element of a body.
    pub(crate) fn is_of_element(&self, of: &Fraction) -> bool {
        of.variables().into_iter().any(|v| {
            let member = self.atoms.atom(v).key.member.as_ref();
            let family = member.and_then(|index| self.family_of(index));
            family.is_some_and(|family| self.families[family].name == ELEMENT)
        })
    }

    /// Whether the volume of one element stands in a value.
    pub(crate) fn has_volume_of_element(&self, of: &Fraction) -> bool {
        of.variables().into_iter().any(|v| {
            let key = &self.atoms.atom(v).key;
            let member = key.member.as_deref();
            member.is_some_and(|index| key.text == subscripted("V", "", index))
        })
    }

    /// Whether the sums over a family of elements are told by the quantities of one rigid body.
    pub(crate) fn is_rigid_whole(&self, family: FamilyId) -> bool {
        let family = &self.families[family];
        let body = family.body.map(|body| &self.bodies[body]);
        let rigid = body.is_some_and(|body| body.frame.is_some() && body.parts.is_empty());
        rigid || family.name != ELEMENT
    }

    /// The index of a family of which something stands in fractions; its first one where nothing has an index. `None` where
    /// there are several.
    pub(crate) fn index_met(&self, family: FamilyId, of: &[Fraction]) -> Option<String> {
        let own = &self.families[family].indices;
        let variables = of.iter().flat_map(Fraction::variables);
        let met = variables.filter_map(|v| self.atoms.atom(v).key.member.as_ref());
        let met: BTreeSet<&String> = met.collect();
        let mut met = met.into_iter();
        match (met.next(), met.next()) {
            (None, _) => own.first().cloned(),
            (Some(only), None) => own.contains(only).then(|| only.clone()),
            _ => None,
        }
    }

    /// The way from the mass centre of the body to a member.
    fn member_offset(&mut self, family: FamilyId, index: &str) -> Vector {
        let tag = self.tag(family).to_owned();
        let text = subscripted("\\rho", &tag, index);
        let body = self.families[family].body;
        match body.and_then(|body| self.bodies[body].frame) {
            Some(frame) => self.carried_vector(&text, frame, Some(index)),
            None => self.free_vector(&text, Place::Coordinate, Some(index)),
        }
    }

    /// The position of a member from a point.
    pub(crate) fn member_position(
        &mut self,
        family: FamilyId,
        index: &str,
        from: PointId,
    ) -> Vector {
        if let Some(member) = self.families[family].member
            && self.bodies[member].members.as_deref() == Some(index)
        {
            return self.position(self.bodies[member].centre, from);
        }
        let offset = self.member_offset(family, index);
        let centre = match self.families[family].body {
            Some(body) => self.bodies[body].centre,
            None => self.origin(),
        };
        self.position(centre, from) + offset
    }

    /// The external force on a member, such that all of them together are what moves the body.
    pub(crate) fn member_force(&mut self, family: FamilyId, index: &str) -> Vector {
        let force = self.free_vector(
            &subscripted("F", "", index),
            Place::Acceleration,
            Some(index),
        );
        let Some(body) = self.families[family].body else {
            return force;
        };
        let total = self.total_force(body);
        let moment = self.total_moment(body, self.bodies[body].centre);
        let offset = self.member_offset(family, index);
        for k in 0..3 {
            self.law_of_sum(&force[k], index, "newton", total[k].clone());
            let (p, q) = ((k + 1) % 3, (k + 2) % 3);
            let other = self.sum(&(offset[q].clone() * force[p].clone()), index);
            if let Some(other) = other {
                let product = offset[p].clone() * force[q].clone();
                self.law_of_sum(&product, index, "moment", moment[k].clone() + other);
            }
        }
        force
    }

    /// Says what the sum over a product of indexed variables is.
    fn law_of_sum(&mut self, product: &Fraction, index: &str, name: &'static str, value: Fraction) {
        let sum = self.sum(product, index);
        if let Some(variable) = sum.and_then(|sum| sum.as_variable())
            && self.atoms.atom(variable).law.is_none()
        {
            self.atoms.atom_mut(variable).law = Some(Law { name, value });
        }
    }

    /// Whether a variable belongs to the member of an index.
    fn is_indexed(&self, variable: Variable, index: &str) -> bool {
        self.atoms.atom(variable).key.member.as_deref() == Some(index)
    }

    /// The sum of a fraction over all members; `None` where an index stands below.
    pub(crate) fn sum(&mut self, of: &Fraction, index: &str) -> Option<Fraction> {
        let of = &self.atoms.with_squares(of);
        let below = of.denominator().variables();
        let (of, divisor) = match below.iter().any(|&v| self.is_indexed(v, index)) {
            true => (self.with_inverses(of, index)?, Fraction::one()),
            false => (
                Fraction::from(of.numerator().clone()),
                Fraction::from(of.denominator().clone()),
            ),
        };
        let mut groups: Vec<(Monomial, Polynomial)> = vec![];
        for (monomial, coefficient) in of.numerator().terms() {
            let (inner, outer) = self.split(monomial, index);
            let term = Polynomial::term(outer, coefficient.clone());
            match groups.iter_mut().find(|(m, _)| *m == inner) {
                Some((_, sum)) => *sum += term,
                None => groups.push((inner, term)),
            }
        }
        let mut sum = Fraction::zero();
        for (inner, factor) in groups {
            sum += self.sum_of_product(&inner, index) * Fraction::from(factor);
        }
        Some(sum / Fraction::from(of.denominator().clone()) / divisor)
    }

    /// A fraction whose denominator is a product of indexed variables, by variables for their inverses.
    fn with_inverses(&mut self, of: &Fraction, index: &str) -> Option<Fraction> {
        let [(monomial, coefficient)] = of.denominator().terms() else {
            return None;
        };
        let mut value = Fraction::from(of.numerator().clone());
        for (variable, power) in monomial.powers() {
            let inverse = match self.is_indexed(variable, index) {
                true => {
                    let text = format!("{}^{{-1}}", self.atoms.latex(variable));
                    let key = Key::of_member(text, index);
                    fraction(self.atoms.variable(key, Place::Parameter, Motion::Constant))
                }
                false => Fraction::one() / fraction(variable),
            };
            for _ in 0..power {
                value *= inverse.clone();
            }
        }
        let lead = Fraction::from(Polynomial::constant(coefficient.clone()));
        Some(value / lead)
    }

    /// The part of a product that has the index, and the rest.
    fn split(&self, monomial: &Monomial, index: &str) -> (Monomial, Monomial) {
        let powers = monomial.powers().into_iter();
        let (inner, outer): (Vec<_>, Vec<_>) =
            powers.partition(|&(v, _)| self.is_indexed(v, index));
        (Monomial::from_powers(inner), Monomial::from_powers(outer))
    }

    /// The sum of a product of powers of indexed variables.
    fn sum_of_product(&mut self, product: &Monomial, index: &str) -> Fraction {
        let text = self.sum_text(product, index);
        let key = Key::new(text);
        if let Some(known) = self.atoms.find(&key) {
            return fraction(known);
        }
        let law = self.known_sum(product, index);
        let constant = product
            .powers()
            .iter()
            .all(|&(v, _)| self.atoms.rate(v).is_zero());
        let motion = if constant {
            Motion::Constant
        } else {
            Motion::Free
        };
        let variable = self.atoms.variable(key, Place::Rate, motion);
        self.atoms.atom_mut(variable).nature = Nature::Sum(product.clone());
        match law {
            Some(law) => self.atoms.atom_mut(variable).law = Some(law),
            None if !constant => {
                let term = Fraction::from(Polynomial::term(product.clone(), Rational::one()));
                let rate = self.atoms.derivative(&term);
                // The rate of a sum is the sum of the rates, as far as these are worked out.
                if let Some(rate) = self.sum_of_rate(&rate, index) {
                    self.atoms.atom_mut(variable).motion = Motion::Rate(rate);
                }
            }
            None => {}
        }
        fraction(variable)
    }

    /// Rates of jets have no end; the fourth is not asked for.
    fn sum_of_rate(&mut self, rate: &Fraction, index: &str) -> Option<Fraction> {
        let highest = rate
            .variables()
            .into_iter()
            .map(|v| self.atoms.atom(v).key.order)
            .max();
        match highest {
            Some(4..) => None,
            _ => self.sum(rate, index),
        }
    }

    /// The laws of sums over the particles of a rigid body.
    fn known_sum(&mut self, product: &Monomial, index: &str) -> Option<Law> {
        let family = self.family_of(index)?;
        let body = self.families[family].body?;
        self.bodies[body].frame?;
        if self.bodies[body].parts.is_empty() {
            return self.law_of_particles(product, index, family, body);
        }
        None
    }

    fn law_of_particles(
        &mut self,
        product: &Monomial,
        index: &str,
        family: FamilyId,
        body: BodyId,
    ) -> Option<Law> {
        let mass = self.member_mass(family, index).as_variable()?;
        let offset = self.member_offset(family, index);
        let along = |v: Variable| (0..3).find(|&k| offset[k].as_variable() == Some(v));
        let mut axes = vec![];
        for (variable, power) in product.powers() {
            if variable == mass && power == 1 {
                continue;
            }
            let axis = along(variable)?;
            axes.extend(std::iter::repeat_n(axis, power as usize));
        }
        if product.exponent(mass) != 1 {
            return None;
        }
        let (name, value) = match axes[..] {
            [] => ("mass", self.bodies[body].mass.clone()),
            [_] => ("mass centre", Fraction::zero()),
            [j, k] => {
                let tensor = self.inertia(body, self.bodies[body].centre);
                let own = -tensor[(j, k)].clone();
                let half = Fraction::from_ratio(1, 2);
                let value = if j == k {
                    own + half * tensor.trace()
                } else {
                    own
                };
                ("inertia", value)
            }
            _ => return None,
        };
        Some(Law { name, value })
    }

    /// Σ with its product, in LaTeX; the same for every letter that numbers the family.
    fn sum_text(&self, product: &Monomial, index: &str) -> String {
        let mut text = String::from("\\sum ");
        for (variable, power) in product.powers() {
            let mut factor = self.atoms.latex(variable);
            let family = self.family_of(index);
            let first = family.and_then(|f| self.families[f].indices.first());
            if let Some(first) = first.filter(|first| *first != index) {
                factor = factor.replace(&format!("_{{{index}"), &format!("_{{{first}"));
            }
            text.push_str(&factor);
            if power > 1 {
                text.push_str(&format!("^{power}"));
            }
            text.push(' ');
        }
        text.trim_end().to_owned()
    }

    /// The sum of a vector over all members.
    pub(crate) fn sum_vector(&mut self, of: &Vector, index: &str) -> Option<Vector> {
        let mut sum = Vector::zeros();
        for k in 0..3 {
            sum[k] = self.sum(&of[k], index)?;
        }
        Some(sum)
    }
}

/// `m_{i}` of a particle, `m_{\text{wheel},i}` of anything else.
fn subscripted(letter: &str, tag: &str, index: &str) -> String {
    match tag {
        "" => format!("{letter}_{{{index}}}"),
        tag => format!("{letter}_{{{index},\\text{{{tag}}}}}"),
    }
}
