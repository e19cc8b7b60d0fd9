//! Sines and cosines: variables with a relation, which they are functions of.

use crate::algebra::{Fraction, Monomial, Place, Polynomial, Rational, Variable};
use crate::verify::model::atoms::{Atoms, Key, Law, Motion, Nature, fraction, whole};
use num_traits::{One, Zero};

/// How π is written.
const PI: &str = "\\pi";

/// What sines and cosines of sums are by.
pub(crate) const ADDITION_THEOREMS: &str = "addition theorems";

/// The cosine and the sine of a sum of two angles, by those of each.
fn of_sum(one: &(Fraction, Fraction), other: &(Fraction, Fraction)) -> (Fraction, Fraction) {
    let ((c, s), (d, t)) = (one, other);
    (
        c.clone() * d.clone() - s.clone() * t.clone(),
        s.clone() * d.clone() + c.clone() * t.clone(),
    )
}

/// The cosine and the sine of a multiple of an angle.
fn of_multiple(times: i64, angle: &(Fraction, Fraction)) -> (Fraction, Fraction) {
    let none = (Fraction::one(), Fraction::zero());
    (0..times).fold(none, |sum, _| of_sum(&sum, angle))
}

/// Of what is written of parts of an angle, halves, thirds and so on, so many are looked for.
const MOST_PARTS: i64 = 4;

impl Atoms {
    /// The cosine and the sine of an angle.
    ///
    /// An angle is a sum of terms; each term has a kernel of its own, and the addition theorems do the rest.
    pub(crate) fn cosine_sine(&mut self, angle: &Fraction) -> Option<(Fraction, Fraction)> {
        if angle.is_zero() {
            return Some((Fraction::one(), Fraction::zero()));
        }
        if angle.numerator().len() > 1 && angle.is_polynomial() {
            let term = |(m, c): &(Monomial, Rational)| {
                Fraction::from(Polynomial::constant(c.clone()).times_term(m, &Rational::one()))
            };
            let terms: Vec<Fraction> = angle.numerator().terms().iter().map(term).collect();
            let mut sum = (Fraction::one(), Fraction::zero());
            for term in terms {
                let (c, s) = self.cosine_sine(&term)?;
                sum = of_sum(&sum, &(c, s));
            }
            return Some(sum);
        }
        let factor = angle.numerator().leading_coefficient();
        let unit = angle.clone() / Fraction::from(Polynomial::constant(factor.clone()));
        if self.is_pi(&unit) {
            // Of other parts of π nothing is known, and a kernel would be free to be anything.
            let steps = (factor * Rational::from((12, 1))).to_integer()?;
            let cosine = self.cosine_of_steps(steps)?;
            return Some((cosine, self.cosine_of_steps(steps.checked_add(18)?)?));
        }
        self.cosine_sine_of_multiple(&unit, &factor)
    }

    /// The number π.
    pub(crate) fn pi(&mut self) -> Fraction {
        fraction(self.variable(Key::of_number(PI), Place::Parameter, Motion::Constant))
    }

    /// The time.
    pub(crate) fn time(&mut self) -> Fraction {
        let motion = Motion::Rate(Fraction::one());
        fraction(self.variable(Key::new("t"), Place::Coordinate, motion))
    }

    /// The variable of time, where anything has it.
    pub(crate) fn known_time(&self) -> Option<Variable> {
        self.find(&Key::new("t"))
    }

    /// The variable of π, where anything has it.
    pub(crate) fn known_pi(&self) -> Option<Variable> {
        self.find(&Key::of_number(PI))
    }

    fn is_pi(&self, unit: &Fraction) -> bool {
        let pi = self.known_pi();
        pi.is_some() && unit.as_variable() == pi
    }

    /// The cosine of so many times 15°, for multiples of 30° and 45°.
    pub(crate) fn cosine_of_steps(&mut self, steps: i64) -> Option<Fraction> {
        let half = Fraction::from_ratio(1, 2);
        match steps.rem_euclid(24) {
            steps @ 13..=23 => self.cosine_of_steps(24 - steps),
            steps @ 7..=12 => Some(-self.cosine_of_steps(12 - steps)?),
            0 => Some(Fraction::one()),
            2 => Some(self.root(&whole(3))? * half),
            3 => Some(self.root(&whole(2))? * half),
            4 => Some(half),
            6 => Some(Fraction::zero()),
            _ => None,
        }
    }

    /// Of p/q times a unit: the p-th multiple of the kernel of 1/q of it.
    pub(super) fn cosine_sine_of_multiple(
        &mut self,
        unit: &Fraction,
        factor: &Rational,
    ) -> Option<(Fraction, Fraction)> {
        let big = factor.abs().to_big();
        let (p, q) = (
            i64::try_from(big.numer()).ok()?,
            i64::try_from(big.denom()).ok()?,
        );
        if p > 12 || q > 12 {
            return None;
        }
        let (cosine, sine) = of_multiple(p, &self.kernel(unit, q)?);
        Some((cosine, if factor.is_negative() { -sine } else { sine }))
    }

    /// The kernel of 1/q of a unit angle. That of the angle itself is told by the one of its half, where both stand.
    pub(super) fn kernel(&mut self, unit: &Fraction, q: i64) -> Option<(Fraction, Fraction)> {
        if let Some(sum) = self.sum_of_angles(unit, q) {
            return self.cosine_sine(&sum);
        }
        let angle = unit.clone() / whole(q);
        if angle.to_rational().is_some() {
            return None;
        }
        let text = self.angle_text(&angle);
        let member = self.member_of(&angle);
        let key = |f: &str| Key {
            member: member.clone(),
            ..Key::new(format!("{f}{text}"))
        };
        let [cosine, sine] = ["\\cos ", "\\sin "].map(key);
        if let (Some(c), Some(s)) = (self.find(&cosine), self.find(&sine)) {
            return Some((fraction(c), fraction(s)));
        }
        let rate = self.derivative(&angle);
        let c = self.variable(cosine, Place::Coordinate, Motion::Free);
        let s = self.variable(sine, Place::Coordinate, Motion::Free);
        self.atom_mut(c).motion = Motion::Rate(-(fraction(s) * rate.clone()));
        self.atom_mut(s).motion = Motion::Rate(fraction(c) * rate);
        self.atom_mut(c).nature = Nature::Cosine(angle.clone());
        self.atom_mut(s).nature = Nature::Sine(angle);
        let square = Polynomial::variable(c) * Polynomial::variable(c);
        self.atom_mut(s).square = Some(Polynomial::one() - square);
        // What is known of the double angle is told by this one from now on.
        if q > 1 {
            self.tell_by_parts(unit, q, &(fraction(c), fraction(s)));
        }
        self.tell_by_known_part(unit, q, [c, s]);
        Some((fraction(c), fraction(s)))
    }

    /// A kernel of a part of the angle that is there already tells the new one.
    fn tell_by_known_part(&mut self, unit: &Fraction, q: i64, [c, s]: [Variable; 2]) {
        let part = (2..=MOST_PARTS).find_map(|parts| {
            let text = self.angle_text(&(unit.clone() / whole(q * parts)));
            let [cosine, sine] =
                ["\\cos ", "\\sin "].map(|f| self.find(&Key::new(format!("{f}{text}"))));
            Some((parts, (fraction(cosine?), fraction(sine?))))
        });
        let Some((parts, kernel)) = part else { return };
        self.tell_by_part([c, s], parts, &kernel);
    }

    /// The cosine and the sine of an angle are those of a part of it, so many times.
    fn tell_by_part(
        &mut self,
        [cosine, sine]: [Variable; 2],
        times: i64,
        kernel: &(Fraction, Fraction),
    ) {
        self.changes.note_all();
        let (of_cosine, of_sine) = of_multiple(times, kernel);
        for (letter, value) in [(cosine, of_cosine), (sine, of_sine)] {
            self.atom_mut(letter).law = Some(Law {
                name: ADDITION_THEOREMS,
                value,
            });
        }
        self.atom_mut(sine).square = None;
    }

    /// The sum of other angles that an angle is by definition, where it has no sine of its own yet.
    fn sum_of_angles(&self, unit: &Fraction, q: i64) -> Option<Fraction> {
        let variable = unit.as_variable().filter(|_| q == 1)?;
        let law = self.atom(variable).law.as_ref()?;
        let own = Key::new(format!("\\sin {}", self.angle_text(unit)));
        let sum = law.value.numerator().len() > 1 && law.value.is_polynomial();
        (law.name == "definition" && sum && self.find(&own).is_none()).then(|| law.value.clone())
    }

    fn tell_by_parts(&mut self, unit: &Fraction, q: i64, kernel: &(Fraction, Fraction)) {
        for whole_part in 1..q {
            if q % whole_part != 0 {
                continue;
            }
            let text = self.angle_text(&(unit.clone() / whole(whole_part)));
            let keys = ["\\cos ", "\\sin "].map(|f| Key::new(format!("{f}{text}")));
            let [Some(cosine), Some(sine)] = keys.map(|k| self.find(&k)) else {
                continue;
            };
            self.tell_by_part([cosine, sine], q / whole_part, kernel);
        }
    }

    pub(super) fn angle_text(&self, angle: &Fraction) -> String {
        let letters = |v: Variable| crate::algebra::Letter {
            text: self.latex(v),
            place: self.atom(v).place,
        };
        crate::algebra::Printer::new(crate::algebra::Style::Latex, &letters).fraction(angle)
    }

    /// The index of the member that a value belongs to.
    pub(super) fn member_of(&self, value: &Fraction) -> Option<String> {
        value
            .variables()
            .into_iter()
            .find_map(|v| self.atom(v).key.member.clone())
    }

    /// Whether a variable is no less than zero by what it is: a root, a length, a mass.
    pub(super) fn is_size(&self, variable: Variable) -> bool {
        let atom = self.atom(variable);
        let root = matches!(atom.nature, Nature::Root(_));
        root || atom.positive || self.is_length(variable)
    }

    /// Whether a sentence tells the sign of a sine or a cosine.
    pub(crate) fn has_told_sign(&self, variable: Variable) -> bool {
        self.signed.contains_key(&variable)
    }

    /// Says whether a sine or a cosine is no less than zero, or negative, where it is a variable.
    pub(crate) fn tell_sign(&mut self, value: &Fraction, negative: bool) {
        if let Some(variable) = value.as_variable() {
            self.changes.note_all();
            self.signed.insert(variable, negative);
        }
    }

    /// The root of a square that is not negative, by what its letters are: itself or its opposite. Where nothing tells the
    /// sign of a sine, in a length it is taken as one of an angle below π.
    pub(super) fn not_negative(&self, root: Polynomial) -> Option<Polynomial> {
        let negative = |v| match self.signed.get(&v) {
            Some(negative) => Some(*negative),
            None => {
                let sine = matches!(self.atom(v).nature, Nature::Sine(_));
                (sine || self.is_size(v)).then_some(false)
            }
        };
        if let [(monomial, coefficient)] = root.terms() {
            let odd = monomial.factors().filter(|(_, power)| power % 2 == 1);
            let signs: Option<Vec<bool>> = odd.map(|(v, _)| negative(v)).collect();
            let negative = signs?.into_iter().filter(|negative| *negative).count() % 2 == 1;
            return Some(match negative != coefficient.is_negative() {
                true => -root,
                false => root,
            });
        }
        let positive = root.terms().iter().all(|(_, c)| !c.is_negative());
        let mut variables = root.variables().into_iter();
        (positive && variables.all(|v| negative(v) == Some(false))).then_some(root)
    }

    /// Whether the sign of a sine in a value is told by no sentence.
    pub(crate) fn has_sine_of_any_sign(&self, value: &Fraction) -> bool {
        let untold = |v: &Variable| {
            let sine = matches!(self.atom(*v).nature, Nature::Sine(_));
            sine && !self.atom(*v).positive && !self.signed.contains_key(v)
        };
        value.variables().iter().any(untold)
    }

    /// Whether a value is no less than zero by what its letters are: a product of lengths and of even powers.
    pub(crate) fn is_never_negative(&self, of: &Fraction) -> bool {
        let one = |p: &Polynomial| match p.terms() {
            [(monomial, coefficient)] => {
                let mut odd = monomial.factors().filter(|(_, power)| power % 2 == 1);
                !coefficient.is_negative() && odd.all(|(v, _)| self.is_size(v))
            }
            terms => terms.is_empty(),
        };
        one(of.numerator()) && one(of.denominator())
    }
}
