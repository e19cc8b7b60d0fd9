//! Votes of the words for what a letter stands for, and how they are counted.

use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::naming::{jacobian_named, named_letters};
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, axis, symbols};
use crate::verify::values::quantity::Quantity;
use crate::verify::words::legend::{
    in_a_legend, listed_apart, names_a_length, names_a_size, names_the_lagrangian,
    names_wheel_speeds,
};
use crate::verify::words::phrases::{
    apposition, calls_identity, letters_named, lists_moments, names_the_identity, reaches,
    said_after, said_before, speaks_of_wheels,
};
use crate::verify::words::prose::turns_to_numbered_axes;
use crate::verify::words::residuals::names_a_residual;
use crate::verify::words::running_sentence::keep_end;
use crate::verify::words::torque_free::torque_free;
use std::collections::BTreeMap;

/// Bytes before a formula in which words may name it.
const NEAR: usize = 400;

impl Reading {
    /// Votes of the words that stand before and after a letter.
    pub(crate) fn listen(&mut self, document: &Document) {
        let mut before = String::new();
        // The words since the last formula with a letter in it.
        let mut since = String::new();
        let mut last: Vec<Letter> = vec![];
        let mut listed: Vec<Letter> = vec![];
        // Whether no paragraph ended since the last formula, and whether one did right behind it.
        let (mut near, mut ended) = (false, false);
        let mut opens_paragraph = false;
        for item in &document.items {
            match item {
                Item::Prose { text, .. } => {
                    for (letter, quantity) in letters_named(text) {
                        self.vote(Letter::plain(&letter), quantity, 3);
                    }
                    // "For the torque …" behind a display opens a sentence of its own.
                    let opens = text.trim_start().starts_with(char::is_uppercase);
                    let text = text.to_lowercase();
                    // A title in plain text, "3. Energy", names nothing in the paragraph below it.
                    if opens && opens_paragraph {
                        before.clear();
                    }
                    self.supposed_constant(&before, &text, &mut listed);
                    self.speaks_of_energy |= text.contains("energy");
                    self.speaks_of_force |= text.contains("force");
                    self.speaks_of_wheels |= speaks_of_wheels(&text);
                    self.speaks_of_no_torque |= torque_free(&text);
                    self.speaks_of_products |=
                        text.contains("products of inertia") || text.contains("product of inertia");
                    self.turns_to_numbers |= turns_to_numbered_axes(&text);
                    self.speaks_of_roll |= text.contains("roll") && text.contains("pitch");
                    let after = said_after(&text).filter(|_| !opens);
                    let after = after.or_else(|| apposition(&text, near));
                    since.push_str(&text);
                    if calls_identity(&since) {
                        self.identities.extend(last.iter().cloned());
                    }
                    if let Some(quantity) = after.or_else(|| in_a_legend(&text, near, ended)) {
                        last.drain(..)
                            .for_each(|letter| self.vote(letter, quantity, 5));
                    }
                    if listed_apart(&text, near) || (near || ended) && names_wheel_speeds(&text) {
                        self.apart.extend(last.drain(..));
                    }
                    let blank = text.trim().is_empty();
                    near &= blank;
                    ended = false;
                    opens_paragraph &= blank;
                    before.push_str(&text);
                    if let Some(end) = before.rfind(['.', '!', '?']) {
                        before.drain(..=end);
                    }
                }
                Item::Formula(formula) => {
                    keep_end(&mut before, NEAR);
                    // "⟨E⟩ the ⟨3 × 3⟩ identity": a size names nothing.
                    if !formula.display && formula.rows.iter().all(is_without_letters) {
                        before.push('⟨');
                        continue;
                    }
                    since.clear();
                    // What opens a paragraph, or an entry of a list, is not named by the one before.
                    if std::mem::take(&mut opens_paragraph) && !formula.display {
                        before.clear();
                    }
                    let named = formula
                        .rows
                        .iter()
                        .flat_map(named_letters)
                        .collect::<Vec<_>>();
                    let called = before.contains("jacobian");
                    let rows = formula.rows.iter();
                    self.apart
                        .extend(rows.filter_map(|row| jacobian_named(row, called)));
                    if names_a_length(&before) {
                        self.lengths.extend(named.iter().cloned());
                    }
                    if names_a_residual(&before) {
                        self.residuals.extend(named.iter().take(1).cloned());
                    }
                    if names_the_lagrangian(&before) {
                        self.apart.extend(named.iter().take(1).cloned());
                    }
                    if names_the_identity(&before) {
                        self.identities.extend(named.iter().take(1).cloned());
                    }
                    if names_a_size(&before) {
                        self.apart.extend(named.iter().cloned());
                    }
                    let display = formula.display;
                    let said = said_before(&before, |after| reaches(after, display));
                    if let Some(quantity) = said {
                        // "The moments and the angular momentum are": each letter to its own.
                        let usual =
                            |l: &&Letter| usual_letters(quantity).contains(&l.name.as_str());
                        let apart = display && named.len() > 1 && named.iter().any(|l| usual(&l));
                        for letter in named.iter().filter(|l| !apart || usual(l)) {
                            self.vote(
                                letter.clone(),
                                quantity,
                                if formula.display { 2 } else { 3 },
                            );
                        }
                    }
                    if !display && lists_moments(&before) {
                        let moment = |l: &&Letter| matches!(l.name.as_str(), "A" | "B" | "C");
                        let moments = named.iter().filter(moment);
                        moments.for_each(|l| self.vote(l.clone(), Quantity::Inertia, 1));
                    }
                    let lines = formula
                        .rows
                        .iter()
                        .filter(|row| matches!(row, Row::Line(_)));
                    self.left_sides.extend(lines.flat_map(named_letters));
                    listed.extend(named.iter().cloned());
                    last = named;
                    // Behind a line, "the" opens the main clause: "With ⟨B = 2A⟩ the momentum is".
                    let names = |row: &Row| matches!(row, Row::Expression(_));
                    near = !formula.display && formula.rows.iter().all(names);
                    ended = false;
                    if formula.display {
                        before.clear();
                    } else {
                        before.push('⟨');
                    }
                }
                Item::Heading { .. } => before.clear(),
                Item::Break => {
                    opens_paragraph = true;
                    ended |= std::mem::take(&mut near);
                }
                Item::Comment { .. } => {}
            }
        }
    }

    pub(crate) fn vote(&mut self, letter: Letter, quantity: Quantity, weight: usize) {
        // "The force at the end x": a coordinate.
        if matches!(letter.name.as_str(), "x" | "y" | "z" | "t") {
            return;
        }
        // An ω without an Ω beside it is the body's own.
        let quantity = match quantity {
            Quantity::FrameRate if letter.name != "Omega" && !self.has("Omega") => {
                Quantity::AngularVelocity
            }
            // "On the principal axes, with the moments ⟨Θ_1⟩".
            Quantity::Moment if matches!(letter.name.as_str(), "Theta" | "J" | "I") => {
                Quantity::Inertia
            }
            other => other,
        };
        *self.votes.entry((letter, quantity)).or_default() += weight;
    }

    pub(crate) fn votes_for(&self, letter: &Letter, quantity: Quantity) -> usize {
        self.votes
            .get(&(letter.clone(), quantity))
            .copied()
            .unwrap_or(0)
    }

    /// Letters that the words name.
    pub(crate) fn by_words(&mut self) {
        let mut best: BTreeMap<&Letter, (usize, Quantity)> = BTreeMap::new();
        let called = self.votes.iter();
        let called = called.filter(|((letter, _), _)| !self.numbers_unit_vectors(letter));
        for ((letter, quantity), votes) in called {
            if best.get(letter).is_none_or(|(most, _)| votes > most) && self.fits(letter, *quantity)
            {
                best.insert(letter, (*votes, *quantity));
            }
        }
        let chosen: Vec<_> = best.into_iter().map(|(l, (_, q))| (l.clone(), q)).collect();
        let masses = self.votes.keys().filter(|(_, q)| *q == Quantity::Mass);
        let apart = masses.map(|(letter, _)| letter.clone()).filter(|letter| {
            let used = self.usage.get(letter);
            used.bare > 0 && used.vector > 0 && self.is_mass(letter)
        });
        self.bare = apart.map(|letter| (letter, Quantity::Mass)).collect();
        for (letter, quantity) in chosen {
            let wheels = quantity == Quantity::RelativeMomentum;
            let whole = wheels && self.is_whole_beside_a_part(&letter);
            self.wheels_apart |= whole;
            let quantity = if whole { Quantity::Momentum } else { quantity };
            self.quantities.entry(letter).or_insert(quantity);
        }
        self.part_turns();
    }

    /// Whether words call a vector the angular momentum, and its letter with a label that of the wheels: h beside h_w.
    fn is_whole_beside_a_part(&self, letter: &Letter) -> bool {
        let labels = self.usage.subscripts.get(letter);
        let labelled = labels.is_some_and(|all| all.iter().any(|s| axis(s).is_none()));
        let called = self.votes_for(letter, Quantity::Momentum) > 0;
        labelled && called && self.usage.get(letter).vector > 0
    }

    /// Whether a letter may be the body's mass: an m, or an M without an m beside it.
    fn is_mass(&self, letter: &Letter) -> bool {
        // The m of dm stands in integrals alone; m_1 and m_2 are parts of the whole.
        let m = Letter::plain("m");
        let other = self.votes_for(&m, Quantity::Mass) > 0 && !self.usage.has_index(&m, "1");
        letter.name == "m" || letter.name == "M" && !other
    }

    /// Whether a vector by a Greek letter may be an angular velocity, as words call it, where none has a usual letter.
    fn turns_by_words(&self, letter: &Letter) -> bool {
        let greek = [
            "sigma", "nu", "eta", "varpi", "psi", "Psi", "lambda", "kappa", "zeta",
        ];
        greek.contains(&letter.name.as_str())
            && self.usage.get(letter).vector > 0
            && !TURNING.iter().any(|name| self.has(name))
    }

    /// Whether a letter is used as such a quantity is.
    fn fits(&self, letter: &Letter, quantity: Quantity) -> bool {
        let used = self.usage.get(letter);
        match quantity {
            _ if self.periods.contains(letter) => false,
            // Beside a T, E is the sum of it and a potential energy.
            Quantity::Energy if letter.name == "E" && self.has_bare("T") => false,
            Quantity::Energy if self.totals.contains(letter) => false,
            // "The kinetic energy of the plate (for any a and b)": sides are small letters, energies large ones.
            Quantity::Power if matches!(letter.name.as_str(), "T" | "E" | "K") => false,
            Quantity::Energy | Quantity::Power => {
                // An angle is no energy: "losing energy means that θ grows".
                let small = letter.name.chars().all(char::is_lowercase);
                let own = matches!(letter.name.as_str(), "e" | "epsilon" | "varepsilon");
                (!small || own) && used.bare > 0 && used.vector == 0
            }
            Quantity::Inertia => {
                let usual = matches!(letter.name.as_str(), "I" | "J" | "Theta" | "A" | "B" | "C");
                // Beside a tensor they are its eigenvalues.
                let tensors = ["I", "J", "Theta"].map(Letter::plain);
                let beside = tensors.iter().any(|t| self.usage.letters.contains_key(t));
                let numbered = ["1", "2", "3"]
                    .iter()
                    .all(|i| self.usage.has_index(letter, i));
                let values = letter.name == "lambda" && numbered && used.vector == 0 && !beside;
                // Words may give the whole tensor another letter, which stands before vectors alone.
                let more = |t: &Letter| {
                    let used = self.usage.get(t);
                    used.naked + used.tensor + used.double > 0
                };
                let whole = used.component + used.double == 0 && !tensors.iter().any(more);
                let other = matches!(letter.name.as_str(), "D" | "K" | "S" | "P") && whole;
                (usual || values || other) && !self.components.contains_key(letter)
            }
            // Beside an ω with components, Ω turns something else.
            Quantity::AngularVelocity
                if letter.name == "Omega"
                    && self.usage.get(&Letter::plain("omega")).component > 0
                    && self.votes_for(&Letter::plain("omega"), Quantity::FrameRate) == 0 =>
            {
                false
            }
            Quantity::FrameRate | Quantity::AngularVelocity => {
                (self.flat || used.vector + used.component > 0)
                    && (TURNING.contains(&letter.name.as_str()) || self.turns_by_words(letter))
            }
            Quantity::Mass => used.vector + used.component == 0 && self.is_mass(letter),
            Quantity::Momentum if letter.name == "p" || used.resultant > 0 => false,
            // Words that stand nearer to a moment than to the momentum beside it.
            Quantity::Momentum
                if matches!(letter.name.as_str(), "M" | "tau" | "Gamma")
                    && ["H", "L", "h"].iter().any(|name| {
                        let other = self.usage.get(&Letter::plain(name));
                        other.vector + other.component > 0
                    }) =>
            {
                false
            }
            // Beside an inertia I, a vector with one index at most.
            Quantity::Momentum if letter.name == "J" => {
                let inertia = self.usage.letters.contains_key(&Letter::plain("I"));
                inertia && used.double + used.tensor == 0 && used.vector + used.component > 0
            }
            // "The moment of F": the force is meant, and its own letter stays its own.
            Quantity::Moment if matches!(letter.name.as_str(), "F" | "R" | "W" | "r" | "v") => {
                false
            }
            Quantity::AngularAcceleration if self.flat && used.vector + used.component == 0 => {
                letter.name == "alpha"
            }
            Quantity::Force | Quantity::AngularAcceleration
                if matches!(letter.name.as_str(), "M" | "tau" | "Gamma" | "T" | "L") =>
            {
                false
            }
            Quantity::Moment | Quantity::Momentum
                if self.flat && used.vector + used.component == 0 =>
            {
                !matches!(
                    letter.name.as_str(),
                    "omega" | "Omega" | "I" | "J" | "Theta" | "m"
                )
            }
            Quantity::Acceleration => letter.name == "a" && used.vector + used.component > 0,
            Quantity::RelativeMomentum => {
                self.speaks_of_wheels && used.vector + used.component + used.bare > 0
            }
            _ => {
                used.vector + used.component > 0
                    && !matches!(letter.name.as_str(), "omega" | "Omega" | "I" | "J")
            }
        }
    }
}

/// The letters that an angular velocity mostly has.
const TURNING: &[&str] = &["omega", "Omega", "w", "Ω"];

/// Whether a row is an expression of numbers alone.
fn is_without_letters(row: &Row) -> bool {
    matches!(row, Row::Expression(node) if symbols(node).is_empty())
}

/// The letters that a vector mostly has.
fn usual_letters(quantity: Quantity) -> &'static [&'static str] {
    match quantity {
        Quantity::Momentum => &["L", "H"],
        Quantity::Moment => &["M", "N", "tau", "Gamma"],
        _ => &[],
    }
}
