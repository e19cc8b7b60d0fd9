//! Which letter stands for which quantity, decided for the document as a whole.
//!
//! The words beside a letter come first ("the angular momentum $\mathbf h$"), then what letters usually mean
//! in this field, given how they are used.

use crate::notation::ast::{Node, Symbol};
use crate::notation::document::{Document, Format, Item, Row};
use crate::verify::check::keep_end;
use crate::verify::letters::attitude_reading::AttitudeReading;
use crate::verify::letters::frame::Frames;
use crate::verify::letters::naming::{jacobian_named, named_letters};
use crate::verify::letters::rivals::has_differences;
use crate::verify::letters::space_axes::SpaceAxes;
use crate::verify::letters::two_points::TwoPoints;
use crate::verify::letters::usage::{Letter, Usage, axis};
use crate::verify::lines::euler_angles::EulerAngles;
use crate::verify::lines::summation::Indices;
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::words::legend::{in_a_legend, listed_apart, names_a_size, names_wheel_speeds};
use crate::verify::words::moments_in_words::NamedMoment;
use crate::verify::words::phrases::{
    apposition, calls_identity, letters_named, lists_moments, reaches, said_after, said_before,
    speaks_of_wheels,
};
use crate::verify::words::prose::turns_to_numbered_axes;
use crate::verify::words::torque_free::torque_free;
use std::collections::{BTreeMap, BTreeSet};

/// What letters stand for.
#[derive(Clone, Debug, Default)]
pub(crate) struct Reading {
    /// Letters that are whole quantities, with components by index.
    pub quantities: BTreeMap<Letter, Quantity>,
    /// Letters without index that are one component: p, q, r; A, B, C; L, M, N.
    pub components: BTreeMap<Letter, (Quantity, u8)>,
    /// What a vector's letter is where it stands without mark and index: the mass M beside a moment **M**.
    pub bare: BTreeMap<Letter, Quantity>,
    /// How letters are used.
    pub usage: Usage,
    /// The frames that labels name.
    pub frames: Frames,
    /// The attitude matrix and the quaternion.
    pub attitude: AttitudeReading,
    /// The label of the body's axes, where plain letters stand on space axes.
    pub space_axes: Option<SpaceAxes>,
    /// Letters of vectors that are numbers in the line that is being read.
    pub scalars: BTreeSet<Letter>,
    votes: BTreeMap<(Letter, Quantity), usize>,
    /// Letters that words call the identity.
    pub(crate) identities: BTreeSet<Letter>,
    /// Letters that a list of symbols says to be something else than any quantity known here.
    pub(crate) apart: BTreeSet<Letter>,
    /// Vectors from one point to another that are no position: their rate is the difference of two velocities.
    pub(crate) arms: BTreeSet<Letter>,
    /// Whether the body turns about one fixed axis, z, and its ω, L, M and I are numbers.
    pub plane: bool,
    /// The axis, fixed in space, that the body turns about.
    pub(crate) fixed_axis: Option<u8>,
    /// The axis that the only wheel lies along.
    pub(crate) wheel_axis: Option<u8>,
    /// Lines that say what something is at the beginning, and how it goes on another line says.
    pub(crate) beginnings: BTreeSet<u32>,
    /// Symbols with what they are at the beginning.
    pub(crate) starts: Vec<(Symbol, Node)>,
    /// Letters whose value has a weight in it.
    pub(crate) totals: BTreeSet<Letter>,
    /// Whether ω and the inertia are only ever numbers.
    pub(crate) flat: bool,
    /// Whether principal axes are chosen, as any may be.
    pub(crate) on_chosen_axes: bool,
    /// Whether two letters, A and C, stand for the three moments A, A, C.
    pub symmetric: bool,
    /// Whether a symbol that is used before its definition is what its use makes it.
    pub by_use: bool,
    /// Indices that are summed over where they are repeated, so that a letter with two of them is an entry of its tensor.
    pub summed: Option<Indices>,
    /// The angles that the body is turned by, where words name them.
    pub euler_angles: Option<EulerAngles>,
    /// Moments that the words give a letter.
    pub moments: Vec<NamedMoment>,
    /// Whether the words name products of inertia.
    pub speaks_of_products: bool,
    /// Whether the words turn from lettered axes to numbered ones that are principal.
    pub turns_to_numbers: bool,
    pub(crate) speaks_of_energy: bool,
    pub(crate) speaks_of_no_torque: bool,
    pub(crate) speaks_of_force: bool,
    pub(crate) speaks_of_roll: bool,
    pub(crate) speaks_of_wheels: bool,
    /// The points that the inertia is taken about, where they are two.
    pub(crate) points: Option<TwoPoints>,
    /// Whether the momentum of the wheels has the letter of the whole with a label.
    pub(crate) wheels_apart: bool,
    /// Letters that stand alone on the left of a line.
    pub(crate) left_sides: BTreeSet<Letter>,
    /// Letters of vectors and tensors that a label puts on the body's axes or on space axes, without any other mark.
    pub(crate) on_both_axes: BTreeSet<Letter>,
}

/// Bytes before a formula in which words may name it.
const NEAR: usize = 400;

impl Reading {
    /// Reads the letters of a document.
    pub(crate) fn of(document: &Document) -> Self {
        let mut reading = Self {
            usage: Usage::of(document),
            frames: Frames::of(document),
            ..Self::default()
        };
        reading.points = TwoPoints::of(document, &reading.usage);
        reading.listen(document);
        reading.listed_moments(document);
        reading.named_rates(document);
        reading.sequences(has_differences(document));
        reading.by_moments(document);
        reading.flat = reading.is_flat();
        reading.note_totals(document);
        reading.note_arms(document);
        reading.note_beginnings(document);
        reading.by_words();
        reading.part_rivals(document);
        reading.by_attitude(document);
        reading.wheel_speeds();
        reading.by_custom();
        reading.by_coefficients(document);
        reading.by_moment_law(document);
        reading.by_points();
        reading.by_labels(document);
        reading.in_a_plane();
        reading.about_fixed_axis(document);
        reading.wheel_along_axis(document);
        reading.typed_w(document.format == Format::Text);
        let matrix = reading.attitude.matrix.as_ref();
        reading.space_axes =
            matrix.and_then(|matrix| SpaceAxes::of(document, Some(matrix), &reading.quantities));
        reading
    }

    /// Whether what symbols stand for is the same on every line.
    pub(crate) fn is_settled(&self) -> bool {
        self.scalars.is_empty() && self.space_axes.is_none() && self.attitude.layouts.is_empty()
    }

    /// Whether a vector's letter without a mark is a number: where the document sets it equal to a component, or where
    /// only that makes sense of a line.
    pub(crate) fn is_scalar(&self, letter: &Letter) -> bool {
        let named = self.usage.components_named.contains_key(letter);
        let number = named || self.usage.lengths.contains(letter);
        self.scalars.contains(letter) || (number && self.usage.get(letter).crossed_bare == 0)
    }

    /// Whether some letter stands for a quantity or a component of it.
    pub(crate) fn speaks_of(&self, quantity: Quantity) -> bool {
        let mut whole = self.quantities.values();
        let mut parts = self.components.values();
        whole.any(|&q| q == quantity) || parts.any(|&(q, _)| q == quantity)
    }

    /// Whether a tilde makes a vector the matrix of its cross product: the `[\tilde\omega]` beside a vector ω.
    pub(crate) fn marks_skew(&self, symbol: &Symbol) -> bool {
        let letter = Letter::of(symbol);
        let quantity = self.quantities.get(&letter);
        symbol.style.tilde
            && symbol.subscripts.iter().all(|s| axis(s).is_none())
            && (self.usage.is_vector(&letter)
                || quantity.is_some_and(|q| q.shape() == Shape::Vector))
            && !self.usage.apart_under_tilde.contains(&letter)
    }

    /// Whether an e without a mark stands for unit vectors: it is only met with the number of an axis, and no line says
    /// what it is.
    pub(crate) fn numbers_unit_vectors(&self, letter: &Letter) -> bool {
        let used = self.usage.get(letter);
        let met = self.usage.subscripts.get(letter);
        letter.name == "e"
            && used.bare == 0
            && met.is_some_and(|all| all.iter().all(|s| axis(s).is_some()))
            && !self.left_sides.contains(letter)
    }

    /// The letters of the attitude, those apart that stand for something else.
    fn by_attitude(&mut self, document: &Document) {
        let taken = |letter: &Letter| {
            self.components.contains_key(letter) || self.quantities.contains_key(letter)
        };
        self.attitude = AttitudeReading::of(document, &taken);
        if let Some(letter) = self.attitude.matrix.clone() {
            self.quantities.insert(letter, Quantity::Attitude);
        }
    }

    /// Votes of the words that stand before and after a letter.
    fn listen(&mut self, document: &Document) {
        let mut before = String::new();
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
                    if calls_identity(&text) {
                        self.identities.extend(last.iter().cloned());
                    }
                    if let Some(quantity) = after.or_else(|| in_a_legend(&text, near, ended)) {
                        last.drain(..)
                            .for_each(|letter| self.vote(letter, quantity, 5));
                    }
                    if listed_apart(&text, near) || (near || ended) && names_wheel_speeds(&text) {
                        self.apart.extend(last.drain(..));
                    }
                    ended = false;
                    opens_paragraph &= text.trim().is_empty();
                    before.push_str(&text);
                    if let Some(end) = before.rfind(['.', '!', '?']) {
                        before.drain(..=end);
                    }
                }
                Item::Formula(formula) => {
                    keep_end(&mut before, NEAR);
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
                    if names_a_size(&before) {
                        self.apart.extend(named.iter().cloned());
                    }
                    let display = formula.display;
                    let said = said_before(&before, |after| reaches(after, display));
                    if let Some(quantity) = said {
                        for letter in &named {
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
        *self.votes.entry((letter, quantity)).or_default() += weight;
    }

    pub(crate) fn votes_for(&self, letter: &Letter, quantity: Quantity) -> usize {
        self.votes
            .get(&(letter.clone(), quantity))
            .copied()
            .unwrap_or(0)
    }

    /// Letters that the words name.
    fn by_words(&mut self) {
        let mut best: BTreeMap<&Letter, (usize, Quantity)> = BTreeMap::new();
        for ((letter, quantity), votes) in &self.votes {
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
        // The m of dm stands in integrals alone.
        let other = self.votes_for(&Letter::plain("m"), Quantity::Mass) > 0;
        letter.name == "m" || letter.name == "M" && !other
    }

    /// Whether a letter is used as such a quantity is.
    fn fits(&self, letter: &Letter, quantity: Quantity) -> bool {
        let used = self.usage.get(letter);
        match quantity {
            // Beside a T, E is the sum of it and a potential energy.
            Quantity::Energy if letter.name == "E" && self.has_bare("T") => false,
            Quantity::Energy if self.totals.contains(letter) => false,
            // "The kinetic energy of the plate (for any a and b)": sides are small letters, energies large ones.
            Quantity::Power if matches!(letter.name.as_str(), "T" | "E" | "K") => false,
            Quantity::Energy | Quantity::Power => {
                let small = letter.name.len() == 1 && letter.name.chars().all(char::is_lowercase);
                (!small || letter.name == "e") && used.bare > 0 && used.vector == 0
            }
            Quantity::Inertia => {
                matches!(letter.name.as_str(), "I" | "J" | "Theta" | "A" | "B" | "C")
                    && !self.components.contains_key(letter)
            }
            // An ω without an Ω beside it is the body's own.
            Quantity::FrameRate if letter.name != "Omega" && !self.has("Omega") => false,
            Quantity::FrameRate | Quantity::AngularVelocity => {
                (self.flat || used.vector + used.component > 0)
                    && matches!(letter.name.as_str(), "omega" | "Omega" | "w" | "Ω")
            }
            Quantity::Mass => used.vector + used.component == 0 && self.is_mass(letter),
            Quantity::Momentum if letter.name == "p" || used.resultant > 0 => false,
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
