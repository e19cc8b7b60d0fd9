//! Documents of a turn about one fixed axis, in which ω, L, M and I are numbers, or ω alone is.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::Document;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, axis, inner};
use crate::verify::values::quantity::Quantity;
use crate::verify::words::text::Text;
use std::collections::BTreeSet;

/// How a sentence begins that turns to one motion of several.
const CASES: &[&str] = &["consider", "now", "suppose", "let", "for", "in the case"];

impl Reading {
    /// Whether the inertia and the rate of turning are only ever numbers, as of a turn about one fixed axis.
    pub(crate) fn is_flat(&self) -> bool {
        let number = |name: &str| !self.usage.get(&Letter::plain(name)).is_directed();
        let letters = ["omega", "Omega", "I", "J", "Theta", "L", "H", "h", "M"];
        let inertia = ["I", "J", "Theta"];
        self.components.is_empty()
            && letters.into_iter().all(number)
            && inertia.into_iter().any(|name| self.has_bare(name))
            && ["omega", "Omega"]
                .into_iter()
                .any(|name| self.has_bare(name))
    }

    /// "The rotor turns about the fixed ⟨z⟩ axis": a bare ω of which no component is written, but the one that it is said
    /// to be, is the one about that axis.
    pub(crate) fn about_fixed_axis(&mut self, document: &Text) {
        self.note_bare_rate(document);
        let letter = self.quantities.iter().find_map(|(letter, quantity)| {
            let used = self.usage.get(letter);
            let bare = used.bare > 0 && (used.component == 0 || self.only_named_component(letter));
            (*quantity == Quantity::AngularVelocity && bare).then(|| letter.clone())
        });
        // In plain text ω × L is written in the letter of the number.
        let crossed = letter
            .as_ref()
            .is_some_and(|letter| self.usage.get(letter).crossed_bare > 0);
        let others = self
            .components
            .values()
            .any(|(q, _)| *q == Quantity::AngularVelocity);
        // Where ω is only ever a number, it need not be said that the axis is fixed.
        let number = letter.as_ref();
        let number = number.is_some_and(|letter| self.usage.get(letter).vector == 0) && !crossed;
        if letter.is_none() && !others && !self.plane && self.euler_angles.is_none() {
            return self.through_an_angle(document);
        }
        let axis = document
            .named_sentences()
            .iter()
            .find_map(|s| fixed_axis(&s.text, number))
            .or_else(|| {
                letter
                    .as_ref()
                    .filter(|_| number)
                    .and_then(|l| self.axis_of_moment(document, l))
            });
        let named = letter.as_ref();
        let named = named.and_then(|letter| self.usage.components_named.get(letter));
        let axis = axis.filter(|axis| named.is_none_or(|named| named == axis));
        if let (Some(letter), Some(axis), false) = (letter, axis, others || self.plane) {
            self.usage.components_named.insert(letter, axis);
            self.fixed_axis = Some(axis);
            let momentum = self.quantities.iter().find_map(|(letter, quantity)| {
                let used = self.usage.get(letter);
                let bare = used.bare > 0 && used.component + used.vector == 0;
                (*quantity == Quantity::Momentum && bare).then(|| letter.clone())
            });
            self.usage
                .components_named
                .extend(momentum.map(|letter| (letter, axis)));
            let rate = Letter::plain("alpha");
            let called = self.votes_for(&rate, Quantity::AngularAcceleration) > 0;
            if called && self.has_bare("alpha") {
                self.quantities.remove(&rate);
                self.components
                    .insert(rate, (Quantity::AngularAcceleration, axis));
            }
        }
    }

    /// "The shaft turns at ⟨Ω⟩ about ⟨z⟩": in a document without an ω, a bare Ω is the rate at which the body turns.
    fn note_bare_rate(&mut self, document: &Text) {
        let rate = Letter::plain("Omega");
        let turns = |q: &Quantity| *q == Quantity::AngularVelocity;
        let taken = self.quantities.values().any(turns)
            || self.components.values().any(|(q, _)| turns(q))
            || self.quantities.contains_key(&rate);
        if taken || !self.has_bare("Omega") || self.plane || self.euler_angles.is_some() {
            return;
        }
        let said = |text: &str| {
            let Some((before, behind)) = text.split_once("⟨Omega⟩") else {
                return false;
            };
            // Nor does it matter which comes first: "turns about ⟨z⟩ with ⟨Ω⟩".
            let rate = ["with", "at", "rate", "speed"];
            let then = rate.iter().any(|word| before.trim_end().ends_with(word));
            let about = behind.contains("about") || then && before.contains("about");
            about && fixed_axis(text, true).is_some()
        };
        if document.named_sentences().iter().any(|s| said(&s.text)) {
            self.quantities.insert(rate, Quantity::AngularVelocity);
        }
    }

    /// Whether the only component written of a letter is the one that a line says it to be: `ω_z = ω`.
    fn only_named_component(&self, letter: &Letter) -> bool {
        let Some(named) = self.usage.components_named.get(letter) else {
            return false;
        };
        let met = self.usage.subscripts.get(letter);
        met.is_some_and(|met| met.iter().all(|index| axis(index) == Some(*named)))
    }

    /// "The rotor turns about the ⟨z⟩ axis through the angle ⟨φ⟩", where no ω is written before.
    fn through_an_angle(&mut self, document: &Text) {
        let rates = |q: &Quantity| *q == Quantity::AngularVelocity;
        let written = self.quantities.values().any(rates);
        if self.usage.only_angle().is_none() {
            return;
        }
        let found = document.sentences().iter().find_map(|sentence| {
            let text = sentence.named();
            let axis = fixed_axis(&text, true).filter(|_| text.contains("angle"))?;
            let begins = CASES.iter().any(|word| text.trim_start().starts_with(word));
            let from = sentence.symbols().next().filter(|_| begins);
            if written && (from.is_none() || !text.contains("through the angle")) {
                return None;
            }
            Some((axis, from.map(|(_, span)| span.start)))
        });
        self.fixed_axis = found.map(|(axis, _)| axis);
        self.turns_from = found.and_then(|(_, from)| from);
        self.turns_by_angle = found.is_some();
    }

    /// The axis k of the only moment I_k that a number ω multiplies: of `T = \frac12 I_1\omega^2`.
    fn axis_of_moment(&self, document: &Document, rate: &Letter) -> Option<u8> {
        let mut met = BTreeSet::new();
        let products = document.lines().flat_map(|line| &line.sides);
        products.for_each(|side| self.moments_beside(side, rate, &mut met));
        let mut met = met.into_iter();
        met.next().filter(|_| met.next().is_none())
    }

    fn moments_beside(&self, node: &Node, rate: &Letter, met: &mut BTreeSet<u8>) {
        if let Kind::Product(factors) = &node.kind {
            let symbol = |node: &'_ Node| match &inner(node).kind {
                Kind::Symbol(symbol) => Some(symbol.clone()),
                Kind::Power(base, _) => match &inner(base).kind {
                    Kind::Symbol(symbol) => Some(symbol.clone()),
                    _ => None,
                },
                _ => None,
            };
            let all: Vec<Symbol> = factors.iter().filter_map(|f| symbol(&f.node)).collect();
            let inertia =
                |s: &&Symbol| self.quantities.get(&Letter::of(s)) == Some(&Quantity::Inertia);
            if all
                .iter()
                .any(|s| Letter::of(s) == *rate && s.subscripts.is_empty())
            {
                let labels = all.iter().filter(inertia).flat_map(|s| &s.subscripts);
                met.extend(labels.filter_map(|label| axis(label)));
            }
        }
        node.children()
            .for_each(|child| self.moments_beside(child, rate, met));
    }

    /// "A wheel along the second body axis with the momentum ⟨h⟩": a number is the component along that axis.
    pub(crate) fn wheel_along_axis(&mut self, document: &Text) {
        let of_wheels = |q: &Quantity| *q == Quantity::RelativeMomentum;
        let mut letters = self.quantities.iter().filter(|(_, q)| of_wheels(q));
        let (Some((letter, _)), None) = (letters.next(), letters.next()) else {
            return;
        };
        let used = self.usage.get(letter);
        if used.vector + used.component > 0 {
            return;
        }
        let letter = letter.clone();
        let axis = document
            .named_sentences()
            .iter()
            .find_map(|s| wheel_axis(&s.text));
        if let Some(axis) = axis {
            self.quantities.remove(&letter);
            self.components
                .insert(letter, (Quantity::RelativeMomentum, axis));
            self.wheel_axis = Some(axis);
        }
    }

    /// A document that speaks of the momentum of a rotor along its axle, and of no inertia but the number that this has:
    /// the letter of that is no tensor.
    pub(crate) fn part_rotor(&mut self) {
        let of = |quantity: Quantity| move |(_, q): &(&Letter, &Quantity)| **q == quantity;
        let directed = |letter: &Letter| self.usage.get(letter).is_directed();
        let rotor = self
            .quantities
            .iter()
            .filter(of(Quantity::RelativeMomentum));
        let rotor = rotor
            .filter(|(letter, _)| self.usage.get(letter).vector > 0)
            .count()
            == 1;
        let whole = self.speaks_of(Quantity::Momentum);
        let parts = self
            .components
            .values()
            .any(|(q, _)| *q == Quantity::Inertia);
        let moments = self.quantities.iter().filter(of(Quantity::Inertia));
        let moments: Vec<Letter> = moments.map(|(letter, _)| letter.clone()).collect();
        if rotor && !whole && !parts && !moments.is_empty() && !moments.iter().any(directed) {
            for letter in moments {
                self.quantities.remove(&letter);
            }
            self.rotor_alone = true;
        }
    }

    /// A document in which ω and the inertia are numbers of a wheel, with its label, speaks of no body that has a momentum, an
    /// energy and a moment by the laws: `E = \frac12 J_f\omega_f^2`, `H = J_f\omega_f`.
    pub(crate) fn part_labelled_wheel(&mut self) {
        let labelled = |letter: &Letter| {
            let used = self.usage.get(letter);
            !used.is_directed() && used.naked == 0 && used.bare > 0
        };
        let is =
            |quantity: &Quantity| matches!(quantity, Quantity::AngularVelocity | Quantity::Inertia);
        let of_body = self.quantities.iter().filter(|(_, quantity)| is(quantity));
        let of_body: Vec<Letter> = of_body.map(|(letter, _)| letter.clone()).collect();
        let parts = self.components.values().any(|(quantity, _)| is(quantity));
        if parts || !self.speaks_of_wheels || of_body.len() != 2 || !of_body.iter().all(labelled) {
            return;
        }
        let of_body = |quantity: &Quantity| matches!(quantity, Quantity::Energy | Quantity::Moment);
        self.quantities.retain(|_, quantity| !of_body(quantity));
        for quantity in self.quantities.values_mut() {
            if *quantity == Quantity::Momentum {
                *quantity = Quantity::RelativeMomentum;
            }
        }
    }

    /// A document in which ω, L, M and I are only ever numbers speaks of a turn about one fixed axis, z.
    pub(crate) fn in_a_plane(&mut self) {
        let turning = |q: &Quantity| {
            matches!(
                q,
                Quantity::AngularVelocity
                    | Quantity::AngularAcceleration
                    | Quantity::Momentum
                    | Quantity::Moment
                    | Quantity::Inertia
            )
        };
        let letters: Vec<(Letter, Quantity)> = self
            .quantities
            .iter()
            .filter(|(_, q)| turning(q))
            .map(|(l, q)| (l.clone(), *q))
            .collect();
        let number = |letter: &Letter| {
            let used = self.usage.get(letter);
            let indices = self.usage.subscripts.get(letter);
            let points = indices.is_none_or(|all| !all.iter().any(|s| runs(s)));
            points && !used.is_directed()
        };
        let spins = |(_, q): &(Letter, Quantity)| *q == Quantity::AngularVelocity;
        let turns = self.usage.only_angle().is_some() || letters.iter().any(spins);
        let weighs = letters.iter().any(|(_, q)| *q == Quantity::Inertia);
        let parts = self.components.values().any(|(q, _)| turning(q));
        let turned = self.attitude.matrix.is_some();
        if turns && weighs && !parts && !turned && letters.iter().all(|(l, _)| number(l)) {
            for (letter, quantity) in letters {
                self.quantities.remove(&letter);
                self.components.insert(letter, (quantity, 2));
            }
            self.plane = true;
        }
    }
}

/// Whether an index runs: i, jk, k+1.
fn runs(index: &str) -> bool {
    let mut letters = index.chars().filter(|c| c.is_alphabetic());
    let runs = |c| matches!(c, 'i'..='n');
    index.len() <= 3 && letters.next().is_some_and(runs) && letters.all(runs)
}

/// The axis that a sentence has the body turn about, where that is fixed in space, or ω is said to be the rate about it,
/// or is `known` to be.
fn fixed_axis(sentence: &str, known: bool) -> Option<u8> {
    let turns = [
        "turns",
        "rotates",
        "spins",
        "rotating",
        "turning",
        "spinning",
        "runs",
        "rotation",
        "motion",
        "angular velocity ⟨omega⟩",
        "angular speed ⟨omega⟩",
    ];
    let sentence = &sentence.replace("of motion", "");
    let at = turns.iter().filter_map(|verb| sentence.find(verb)).min()?;
    let about = &sentence[at + sentence[at..].find("about")? + "about".len()..];
    let near: String = about.chars().take(40).collect();
    let near = near.split([',', ';']).next()?;
    // Of a body: a frame may turn as it likes.
    let of_body = !sentence.contains("frame");
    let lettered = near
        .split_whitespace()
        .next()
        .is_some_and(|word| matches!(word.trim_matches(['⟨', '⟩', '.']), "x" | "y" | "z"));
    let fixed = (lettered || near.contains("axis")) && (known && of_body || near.contains("fixed"));
    let rate = of_body
        && ["velocity ", "speed ", "rate "].iter().any(|word| {
            ["omega", "Omega"]
                .iter()
                .any(|name| sentence.contains(&format!("{word}⟨{name}⟩")))
        });
    let mut words = near.split(|c: char| c.is_whitespace() || c == '-');
    let named = words.find_map(|word| {
        let letter = word.trim_matches(['⟨', '⟩', '.']);
        matches!(letter, "x" | "y" | "z" | "1" | "2" | "3").then(|| axis(letter))
    });
    named.flatten().filter(|_| fixed || rate)
}

/// The axis along which a sentence puts a wheel, or its momentum.
pub(crate) fn wheel_axis(sentence: &str) -> Option<u8> {
    let (_, along) = sentence.split_once("momentum along ").unwrap_or_default();
    let named = along.split_whitespace().next().unwrap_or_default();
    if let Some(axis) = axis(named.trim_matches(['⟨', '⟩', ','])) {
        return Some(axis);
    }
    let wheel = ["wheel", "rotor"]
        .iter()
        .filter_map(|w| sentence.find(w))
        .min()?;
    let about = [
        "along the ",
        "about the ",
        "parallel to the ",
        "parallel to ",
    ];
    let at = about
        .iter()
        .filter_map(|words| Some(sentence[wheel..].find(words)? + words.len()))
        .min()?;
    let near: String = sentence[wheel + at..].chars().take(30).collect();
    let before = &sentence[wheel..wheel + at];
    if !near.contains("axis") && !before.ends_with("axis parallel to ") {
        return None;
    }
    let mut words = near.split(|c: char| c.is_whitespace() || matches!(c, '-' | '~'));
    words.find_map(|word| match word.trim_matches(['⟨', '⟩', '.', ',']) {
        "first" | "roll" => Some(0),
        "second" | "pitch" => Some(1),
        "third" | "yaw" => Some(2),
        letter => axis(letter),
    })
}
