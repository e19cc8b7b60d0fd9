//! Two values held against each other as numbers, to the digits shown.

use crate::algebra::{Bound, Fraction, Interval, Proof, Rational, enclosure};
use crate::verify::reason;
use crate::verify::theory::certify::certify_within;
use crate::verify::theory::decide::{Equation, needed};
use crate::verify::theory::ledger::ratio;
use crate::verify::theory::{Name, Theory};
use crate::verify::values::figures::is_number;
use crate::verify::values::value::Value;
use num_traits::Zero;

/// One over this is smaller than any digit that is shown.
const FINEST: i64 = 1_000_000_000_000_000_000;

/// How far a value may lie from a numeral.
#[derive(Clone, Debug)]
pub(crate) struct Tolerance {
    pub half: Rational,
    pub doubt: Rational,
    /// Whether it counts only for values that are not exact.
    pub integer: bool,
}

/// Two sides held against each other.
pub(crate) enum Comparison {
    Agree(Proof, Vec<Name>),
    /// The place, the left value, and whether both are plain rational numbers.
    Differ(usize, Interval, bool),
    /// They are numbers, and it cannot be told.
    Doubtful(&'static str),
    /// Not all are numbers.
    NoNumbers,
}

/// Compares two values, numbers to the digits shown.
pub(crate) fn compare(
    theory: &mut Theory,
    left: &Value,
    right: &Value,
    tolerances: &[Option<Tolerance>],
    decimals: bool,
) -> Comparison {
    let Ok(residual) = left.plus(right, true) else {
        return Comparison::NoNumbers;
    };
    let (mut equations, mut bounds) = (vec![], vec![]);
    for (place, entry) in residual.entries.iter().enumerate() {
        let gap = theory.normal(entry);
        if std::mem::take(&mut theory.exhausted) || !gap.is_valid() {
            return Comparison::Doubtful(reason::GROWN);
        }
        if !is_number(&theory.atoms, &gap) {
            return Comparison::NoNumbers;
        }
        let side = |value: &Value| match value.entries.as_slice() {
            [only] => only.clone(),
            entries => entries.get(place).cloned().unwrap_or_else(Fraction::zero),
        };
        let (l, r) = (side(left), side(right));
        equations.push(Equation::of_scalars(l.clone(), r.clone() + gap.clone()));
        if gap.is_zero() {
            continue;
        }
        let (Some(distance), Some(value)) =
            (theory.number_enclosure(&gap), theory.normal_enclosure(&l))
        else {
            return Comparison::Doubtful("this number has no value that is known here");
        };
        let exact = gap.variables().is_empty() && !decimals;
        let tolerance = tolerances.get(place).and_then(Option::as_ref);
        let Some(tolerance) = tolerance.filter(|t| !(t.integer && exact)) else {
            let zero = Rational::zero();
            if distance.apart(&zero, &zero) {
                return Comparison::Differ(place, value, gap.variables().is_empty());
            }
            // √48 and 12/√3: equal to more digits than anyone shows.
            let fine = Rational::from((1, FINEST));
            if !distance.within(&-fine.clone(), &fine) {
                return Comparison::Doubtful("equal to many digits, and not shown to be equal");
            }
            bounds.push(Bound {
                value: ratio(&gap),
                lower: -fine.clone(),
                upper: fine,
            });
            continue;
        };
        let (lower, upper) = (-tolerance.half.clone(), tolerance.half.clone());
        if distance.within(&lower, &upper) {
            bounds.push(Bound {
                value: ratio(&gap),
                lower,
                upper,
            });
            continue;
        }
        if !distance.apart(&lower, &upper) {
            return Comparison::Doubtful("it lies on the edge of rounding");
        }
        let outward = value.is_positive() == distance.is_positive();
        let cut = tolerance.half.clone() + tolerance.half.clone();
        let loose = tolerance.doubt.clone();
        let loose = if outward { loose.max(cut) } else { loose };
        if distance.within(&-loose.clone(), &loose) && (outward || tolerance.integer) {
            return Comparison::Doubtful("the last digit is cut off rather than rounded");
        }
        return Comparison::Differ(place, value, false);
    }
    match certify_within(theory, &equations, bounds) {
        Some(proof) => {
            let names = needed(theory, &equations, &proof);
            Comparison::Agree(proof, names)
        }
        None => Comparison::Doubtful(reason::NO_PROOF_IN_NUMBERS),
    }
}

impl Theory {
    /// An interval that holds a fraction in normal form, where it is a number.
    pub(crate) fn number_enclosure(&mut self, fraction: &Fraction) -> Option<Interval> {
        self.note_kernels(fraction);
        enclosure(&ratio(fraction), &self.solution.ledger.kernels)
    }

    pub(crate) fn normal_enclosure(&mut self, fraction: &Fraction) -> Option<Interval> {
        let normal = self.normal(fraction);
        is_number(&self.atoms, &normal)
            .then(|| self.number_enclosure(&normal))
            .flatten()
    }

    /// A rational number that is not above a number, and close to it.
    pub(crate) fn rational_below(&mut self, fraction: &Fraction) -> Option<Rational> {
        match fraction.to_rational() {
            Some(exact) => Some(exact),
            None => Some(self.number_enclosure(fraction)?.ends().0),
        }
    }
}
