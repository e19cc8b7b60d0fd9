//! Rates and angles that words call small, all of them at once: "small rates, so their products are dropped".

use crate::algebra::Fraction;
use crate::notation::ast::{Function, Symbol};
use crate::verify::check::Checker;
use crate::verify::values::atoms::{Atom, Entity, Owner};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::words::small_words::DROPPED;
use std::collections::BTreeSet;

/// What turns, in the plural.
const RATES: &[&str] = &["rates", "angular velocities", "velocities"];
/// Words before and behind them.
const SMALL_BEFORE: &[&str] = &["small", "tiny", "infinitesimal"];
const SMALL_BEHIND: &[&str] = &[
    "are small",
    "are all small",
    "remain small",
    "stay small",
    "are very small",
];
/// Words between "products of" and what turns.
const OF: &[&str] = &[
    "",
    "the ",
    "two ",
    "two of the ",
    "angular ",
    "the angular ",
    "body ",
    "these ",
];
/// Words that pick some of them out.
const SOME: &[&str] = &[
    "transverse",
    "cross ",
    "other",
    "two of",
    "roll and",
    "yaw and",
    "both",
    "lateral",
];

/// Words that keep the first powers of the rates alone.
const TO_FIRST_ORDER: &[&str] = &[
    "first order in the rates",
    "first order in the body rates",
    "first order in the angular velocity",
    "first order in the angular rates",
    "first order in all rates",
    "linear in the rates",
];

/// States in which nothing turns, about which equations are linearised.
const AT_REST: &[&str] = &[
    "straight flight",
    "level flight",
    "about rest",
    "about the state of rest",
    "about the rest position",
];

/// Words that take the angles of a document small.
const FOR_SMALL: &[&str] = &[
    "for small angles",
    "for small oscillations",
    "for small swings",
    "for small tilts",
    "for small deflections",
    "for small motions",
];

/// Whether a sentence calls every rate of turning small, or drops the products of any two.
fn calls_rates_small(sentence: &str) -> bool {
    let called = RATES.iter().any(|noun| {
        let before = SMALL_BEFORE.iter().any(|small| {
            let near = ["", " angular", " body", " attitude"];
            near.iter()
                .any(|kind| sentence.contains(&format!("{small}{kind} {noun}")))
        });
        let behind = SMALL_BEHIND
            .iter()
            .any(|small| sentence.contains(&format!("{noun} {small}")));
        before || behind
    });
    let some = SOME.iter().any(|word| sentence.contains(word));
    let order = TO_FIRST_ORDER.iter().any(|words| sentence.contains(words));
    let about_rest =
        sentence.contains("lineari") && AT_REST.iter().any(|words| sentence.contains(words));
    called && !some || order || about_rest || drops_products(sentence)
}

/// "Products of two rates are dropped."
fn drops_products(sentence: &str) -> bool {
    let behind = ["products of ", "product of "]
        .iter()
        .find_map(|lead| Some(sentence.split_once(lead)?.1));
    let Some(behind) = behind else { return false };
    let dropped = DROPPED.iter().any(|word| sentence.contains(word));
    dropped
        && RATES.iter().any(|noun| {
            OF.iter()
                .any(|of| behind.starts_with(&format!("{of}{noun}")))
        })
}

/// "All angles and rates are small."
fn calls_angles_small(sentence: &str) -> bool {
    let nouns = [
        "angles are",
        "angles and rates are",
        "angles and the rates are",
    ];
    let behind = nouns.iter().any(|noun| {
        ["small", "all small"]
            .iter()
            .any(|small| sentence.contains(&format!("{noun} {small}")))
    });
    behind
        || sentence.contains("small angles and rates")
        || sentence.contains("small angles and small rates")
}

impl Checker<'_> {
    /// Notes rates and angles that the words call small as a whole; equations are then taken to first order in them.
    pub(crate) fn note_small_rates(&mut self, text: &str) {
        let text = text.replace('\n', " ");
        // "For small angles, ⟨\ddot θ + … = 0⟩."
        if FOR_SMALL.iter().any(|words| text.contains(words)) {
            self.linear = true;
            self.call_angles_small();
        }
        for sentence in text.split(['.', ';']).filter(|s| {
            ["rates", "velocities", "lineari"]
                .iter()
                .any(|word| s.contains(word))
        }) {
            if !calls_rates_small(sentence) {
                continue;
            }
            let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
            self.small.insert(omega);
            self.linear = true;
            if calls_angles_small(sentence) {
                self.call_angles_small();
            }
        }
    }

    /// The angles of roll, pitch and yaw that the document writes, or else the one angle that moves and has a sine.
    fn call_angles_small(&mut self) {
        let before = self.small.len();
        for name in ["phi", "theta", "psi"] {
            let symbol = Symbol {
                name: name.to_owned(),
                ..Symbol::default()
            };
            if let (true, Meaning::Whole(entity)) =
                (self.reading.has(name), self.meaning_of(&symbol))
            {
                self.small.insert(entity);
            }
        }
        if self.small.len() == before
            && let [angle] = self.moving_angles().as_slice()
        {
            self.small.insert(*angle);
        }
    }

    /// Symbols of the document that move, and of which a premise has the sine or cosine.
    fn moving_angles(&self) -> Vec<Entity> {
        let atoms = &self.theory.atoms;
        let written = self.theory.premises().iter().flat_map(|p| &p.residuals);
        let kernels = written.flat_map(Fraction::variables);
        let arguments = kernels.flat_map(|v| match atoms.atom(v) {
            Atom::Kernel {
                function: Function::Sin | Function::Cos,
                argument,
            } => argument.variables(),
            _ => vec![],
        });
        let entities = arguments.filter_map(|v| atoms.entity_of(v));
        let moving = entities.filter(|&e| {
            let info = atoms.info(e);
            !info.constant && matches!(info.owner, Owner::Symbol(_))
        });
        let moving: BTreeSet<Entity> = moving.collect();
        moving.into_iter().collect()
    }
}
