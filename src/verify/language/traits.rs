//! What the lexicon says of a word beside its meaning: the flags behind the `;` of its line.
//!
//! Which shapes are round, which bodies are wheels and which loads are forces stands there alone. Other files ask by
//! [`has`] and hold no lists of nouns.

use super::lexicon::Lexicon;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// One of the flags; `lexicon.txt` says at its head what each means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Trait {
    Premise,
    Operator,
    One,
    Many,
    Part,
    Tells,
    Bodily,
    Shape,
    Round,
    Rim,
    Ball,
    Flat,
    Slender,
    Apex,
    OneSided,
    Hollow,
    Right,
    Wheel,
    Rail,
    Ground,
    Force,
    Couple,
    OfAKind,
    Touch,
}

use Trait::{
    Apex, Ball, Bodily, Couple, Flat, Force, Ground, Hollow, Many, OfAKind, One, OneSided,
    Operator, Part, Premise, Rail, Right, Rim, Round, Shape, Slender, Tells, Touch, Wheel,
};

/// The flags as they are written.
const WRITTEN: [(&str, Trait); 24] = [
    ("premise", Premise),
    ("operator", Operator),
    ("one", One),
    ("many", Many),
    ("part", Part),
    ("tells", Tells),
    ("bodily", Bodily),
    ("shape", Shape),
    ("round", Round),
    ("rim", Rim),
    ("ball", Ball),
    ("flat", Flat),
    ("slender", Slender),
    ("apex", Apex),
    ("one-sided", OneSided),
    ("hollow", Hollow),
    ("right", Right),
    ("wheel", Wheel),
    ("rail", Rail),
    ("ground", Ground),
    ("force", Force),
    ("couple", Couple),
    ("of-a-kind", OfAKind),
    ("touch", Touch),
];

/// Some of the flags.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Traits(u32);

impl Traits {
    /// The flags of a line. Words that are none are left out; a test sees to it that there are none.
    pub(super) fn read(flags: &str) -> Self {
        let known = flags.split_whitespace().filter_map(written);
        Self(known.fold(0, |all, flag| all | bit(flag)))
    }

    pub(crate) fn has(self, flag: Trait) -> bool {
        self.0 & bit(flag) != 0
    }
}

fn written(flag: &str) -> Option<Trait> {
    let mut all = WRITTEN.iter();
    all.find(|(name, _)| *name == flag).map(|(_, flag)| *flag)
}

fn bit(flag: Trait) -> u32 {
    1 << flag as u32
}

/// Whether a noun, by the first form of its entry, has a flag.
pub(crate) fn has(noun: &str, flag: Trait) -> bool {
    static FLAGGED: LazyLock<BTreeMap<&str, u32>> = LazyLock::new(|| {
        let mut flagged = BTreeMap::new();
        for entry in Lexicon::shared().entries() {
            if entry.traits != Traits::default() {
                *flagged.entry(entry.name).or_default() |= entry.traits.0;
            }
        }
        flagged
    });
    let all = FLAGGED.get(noun).copied().unwrap_or_default();
    Traits(all).has(flag)
}

/// Whether a noun is that of a disc or a ring: it lies in a plane, and its axis stands on that.
pub(crate) fn is_round_and_flat(noun: &str) -> bool {
    has(noun, Round) && has(noun, Flat)
}

/// Whether a noun is that of a cone: it has an apex, and its axis goes through that.
pub(crate) fn is_conical(noun: &str) -> bool {
    has(noun, Round) && has(noun, Apex)
}

/// Whether a noun is that of what is round about an axis, with sides along it.
pub(crate) fn is_cylindrical(noun: &str) -> bool {
    has(noun, Rim) && !has(noun, Flat)
}

/// Whether a noun is that of a force that acts at a point.
pub(crate) fn is_force(noun: &str) -> bool {
    has(noun, Force)
}

/// Whether a noun is that of a moment.
pub(crate) fn is_couple(noun: &str) -> bool {
    has(noun, Couple)
}

/// Whether a noun is that of a moment that needs no letter: "the motor moment".
pub(crate) fn is_couple_of_a_kind(noun: &str) -> bool {
    is_couple(noun) && has(noun, OfAKind)
}
