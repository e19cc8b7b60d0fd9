//! Values in free variables: by rules, laws and the rates of rules.

use crate::algebra::{Fraction, Polynomial, Variable, compose_by};
use crate::verify::facts::premises::{Facts, MOST_TERMS, OutOfBudget, size};
use crate::verify::model::atoms::{Atoms, Law};
use crate::verify::model::kernels::ADDITION_THEOREMS;

/// What was found of a variable.
#[derive(Clone, Debug)]
pub(super) enum Image {
    /// Nothing tells it.
    Free,
    /// Its value in free variables.
    Known(Fraction),
    /// Its value has more terms than are worked out.
    TooLarge,
}

/// Laws that are mathematics, or say what a letter stands for.
const NO_MECHANICS: [&str; 2] = ["definition", ADDITION_THEOREMS];

impl Facts {
    /// The value of a variable in free variables, if it was found and is not the variable itself.
    fn known_image(&self, variable: Variable) -> Option<&Fraction> {
        match self.images.get(&variable)? {
            Image::Known(value) => Some(value),
            Image::Free | Image::TooLarge => None,
        }
    }

    /// Finds the value of a variable in free variables, by rules, laws and the rates of rules.
    fn find_image(
        &mut self,
        atoms: &mut Atoms,
        variable: Variable,
        depth: usize,
    ) -> Result<(), OutOfBudget> {
        match self.images.get(&variable) {
            None => {}
            Some(Image::TooLarge) => return Err(OutOfBudget),
            // A part of an angle that comes up later tells its sine and cosine.
            Some(Image::Free) if self.is_told_late(atoms, variable) => self.images.clear(),
            Some(Image::Free | Image::Known(_)) => return Ok(()),
        }
        if depth > 60 {
            return Err(OutOfBudget);
        }
        let image = match self.told(atoms, variable) {
            None => Image::Free,
            Some(value) => match self.normal_at(atoms, &value, depth + 1) {
                Ok(value) => Image::Known(value),
                // From further up more might be put in.
                Err(OutOfBudget) if depth > 0 => return Err(OutOfBudget),
                Err(OutOfBudget) => Image::TooLarge,
            },
        };
        let found = !matches!(image, Image::TooLarge);
        self.images.insert(variable, image);
        found.then_some(()).ok_or(OutOfBudget)
    }

    /// Whether a variable that was free has a law by now.
    fn is_told_late(&self, atoms: &Atoms, variable: Variable) -> bool {
        let law = atoms.atom(variable).law.is_some();
        law && !self.is_untold(atoms, variable) && !self.turned.contains(&variable)
    }

    /// Whether neither a rule nor a law that counts here tells a variable.
    pub(crate) fn is_untold(&self, atoms: &Atoms, variable: Variable) -> bool {
        let law = atoms.atom(variable).law.as_ref();
        let counts = law.is_some_and(|law| !self.lawless || NO_MECHANICS.contains(&law.name));
        !counts && !self.rules.contains_key(&variable)
    }

    /// What a rule, a law or the rate of a rule says of a variable, one step deep.
    pub(crate) fn told(&self, atoms: &mut Atoms, variable: Variable) -> Option<Fraction> {
        if let Some(rule) = self.rules.get(&variable) {
            return Some(rule.value.clone());
        }
        if let Some(Law { name, value }) = &atoms.atom(variable).law
            && (!self.lawless || NO_MECHANICS.contains(name))
            && !self.turned.contains(&variable)
        {
            return Some(value.clone());
        }
        let of = atoms
            .atom(variable)
            .rate_of
            .filter(|of| self.rates_are_told(*of))?;
        let value = self.told(atoms, of)?;
        Some(atoms.derivative(&value))
    }

    /// A fraction in free variables alone.
    pub(crate) fn normal(
        &mut self,
        atoms: &mut Atoms,
        of: &Fraction,
    ) -> Result<Fraction, OutOfBudget> {
        self.normal_at(atoms, of, 0)
    }

    /// What is known of a square may bring letters that are told again, so both are put in until nothing changes.
    fn normal_at(
        &mut self,
        atoms: &mut Atoms,
        of: &Fraction,
        depth: usize,
    ) -> Result<Fraction, OutOfBudget> {
        let mut value = self.put_in_values(atoms, of, depth)?;
        for _ in 0..8 {
            match self.without_known_squares(atoms, &value)? {
                Some(lowered) => value = self.put_in_values(atoms, &lowered, depth)?,
                None => return Ok(value),
            }
        }
        Err(OutOfBudget)
    }

    fn put_in_values(
        &mut self,
        atoms: &mut Atoms,
        of: &Fraction,
        depth: usize,
    ) -> Result<Fraction, OutOfBudget> {
        let mut longest = 0;
        for variable in of.variables() {
            self.find_image(atoms, variable, depth)?;
            longest = longest.max(self.known_image(variable).map_or(0, size));
        }
        self.work = self.work.saturating_add(longest.saturating_mul(size(of)));
        let put = |p: &Polynomial| {
            let image = |variable| self.known_image(variable);
            compose_by(p, image, MOST_TERMS).map_err(|_| OutOfBudget)
        };
        let value = match (longest, of.is_polynomial()) {
            (0, _) => of.clone(),
            (_, true) => put(of.numerator())?,
            (_, false) => put(of.numerator())? / put(of.denominator())?,
        };
        value.is_valid().then_some(value).ok_or(OutOfBudget)
    }
}
