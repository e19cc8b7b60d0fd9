//! Monomials of up to seven variables in one word: the degree in the top byte, then an entry of sixteen bits for each
//! variable, variables ascending.
//!
//! An entry holds 1023 − v in its ten upper bits and the exponent below. So words compare as monomials do: by degree,
//! then by the first variable that one of them has and the other has not, or has in a lower power.

use super::Variable;

/// Bits of an entry.
pub(super) const ENTRY: u32 = 16;
/// Bits of its exponent.
const EXPONENT: u32 = 6;
/// The exponent's place in an entry.
const MASK: u32 = (1 << EXPONENT) - 1;
/// What a variable is taken from.
const TOP: u32 = 1023;
/// The entries that a word has room for.
const ENTRIES: u32 = 7;

/// The word of powers with variables ascending and no exponent zero, where it has room for them.
pub(super) fn word(powers: &[(Variable, u32)]) -> Option<u128> {
    let mut word = Word::default();
    for &(variable, exponent) in powers {
        if variable >= TOP {
            return None;
        }
        word.push(TOP - variable, exponent)?;
    }
    word.finish()
}

/// The word of a packed monomial.
#[inline]
pub(super) fn of_packed(packed: u128) -> Option<u128> {
    let mut word = Word::default();
    for (variable, exponent) in super::Factors::Packed(packed << 8, 0) {
        word.push(TOP - variable, exponent)?;
    }
    word.finish()
}

/// The entry on top of a word that was shifted by its degree.
#[inline]
pub(super) fn entry(shifted: u128) -> Option<(Variable, u32)> {
    let entry = (shifted >> (128 - ENTRY)) as u32;
    (entry != 0).then(|| (TOP - (entry >> EXPONENT), entry & MASK))
}

/// The last variable of a word.
#[inline]
pub(super) fn last(word: u128) -> Option<Variable> {
    let entries = word << 8;
    let lowest = entries.checked_shr(entries.trailing_zeros() / ENTRY * ENTRY)?;
    Some(TOP - (u32::from(lowest as u16) >> EXPONENT))
}

/// The exponent of a variable.
#[inline]
pub(super) fn exponent(word: u128, variable: Variable) -> u32 {
    let mut rest = word << 8;
    while let Some((v, e)) = entry(rest) {
        if v == variable {
            return e;
        }
        rest <<= ENTRY;
    }
    0
}

/// A word without the entry of a variable.
#[inline]
pub(super) fn without(word: u128, variable: Variable) -> u128 {
    let (mut rest, mut above) = (word << 8, 0);
    while let Some((v, exponent)) = entry(rest) {
        rest <<= ENTRY;
        if v == variable {
            let degree = (word >> 120) - u128::from(exponent);
            let below = rest >> above;
            let kept = (word << 8) & !(u128::MAX >> above);
            return degree << 120 | (kept | below) >> 8;
        }
        above += ENTRY;
    }
    word
}

/// Two words joined, exponent by exponent, where the result has room.
#[inline]
pub(super) fn merged(a: u128, b: u128, join: impl Fn(u32, u32) -> u32) -> Option<u128> {
    let (mut a, mut b) = (a << 8, b << 8);
    let mut word = Word::default();
    loop {
        let (left, right) = ((a >> (128 - ENTRY)) as u32, (b >> (128 - ENTRY)) as u32);
        let next = (left >> EXPONENT).max(right >> EXPONENT);
        if next == 0 {
            return word.finish();
        }
        let mut exponents = (0, 0);
        if left >> EXPONENT == next {
            exponents.0 = left & MASK;
            a <<= ENTRY;
        }
        if right >> EXPONENT == next {
            exponents.1 = right & MASK;
            b <<= ENTRY;
        }
        let exponent = join(exponents.0, exponents.1);
        if exponent > 0 {
            word.push(next, exponent)?;
        }
    }
}

/// A word that is being written.
#[derive(Default)]
struct Word {
    entries: u128,
    count: u32,
    degree: u32,
}

impl Word {
    #[inline]
    fn push(&mut self, inverted: u32, exponent: u32) -> Option<()> {
        if self.count == ENTRIES || exponent > MASK {
            return None;
        }
        self.count += 1;
        self.degree += exponent;
        let entry = u128::from(inverted << EXPONENT | exponent);
        self.entries |= entry << (120 - ENTRY * self.count);
        Some(())
    }

    #[inline]
    fn finish(self) -> Option<u128> {
        (self.degree < 256).then(|| u128::from(self.degree) << 120 | self.entries)
    }
}
