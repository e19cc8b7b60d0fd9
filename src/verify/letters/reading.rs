//! Which letter stands for which quantity, decided for the document as a whole.
//!
//! The words beside a letter come first ("the angular momentum $\mathbf h$"), then what letters usually mean
//! in this field, given how they are used.

use crate::notation::ast::{Node, Symbol};
use crate::notation::document::Format;
use crate::source::Span;
use crate::verify::letters::attitude_reading::AttitudeReading;
use crate::verify::letters::carried_spin::CarriedSpin;
use crate::verify::letters::frame::Frames;
use crate::verify::letters::imaginary::has_imaginary_unit;
use crate::verify::letters::labelled_wheel::LabelledWheel;
use crate::verify::letters::moving_point::MovingPoint;
use crate::verify::letters::named_axes::Labels;
use crate::verify::letters::particles::{measures_from_centre, place_in_rigid_body};
use crate::verify::letters::rivals::has_differences;
use crate::verify::letters::round_axes::RoundAxes;
use crate::verify::letters::space_axes::{SpaceAxes, momentum_in_space};
use crate::verify::letters::two_points::TwoPoints;
use crate::verify::letters::two_states::TwoStates;
use crate::verify::letters::usage::{Letter, Usage, axis};
use crate::verify::lines::euler_angles::EulerAngles;
use crate::verify::lines::summation::Indices;
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::words::moments_in_words::NamedMoment;
use crate::verify::words::relative_spin::WITHOUT_SPIN;
use crate::verify::words::text::Text;
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
    pub(crate) votes: BTreeMap<(Letter, Quantity), usize>,
    /// What the front matter says of letters and is not understood.
    pub(crate) not_set: Vec<String>,
    /// Letters that words call the identity.
    pub(crate) identities: BTreeSet<Letter>,
    /// Letters that a list of symbols says to be something else than any quantity known here.
    pub(crate) apart: BTreeSet<Letter>,
    /// Letters that words call a residual: what must vanish at the root that is looked for.
    pub(crate) residuals: BTreeSet<Letter>,
    /// Two states of a body whose momenta the document sets equal.
    pub(crate) states: Option<TwoStates>,
    /// Letters that words call a length.
    pub(crate) lengths: BTreeSet<Letter>,
    /// Vectors from one point to another that are no position: their rate is the difference of two velocities.
    pub(crate) arms: BTreeSet<Letter>,
    /// Whether the body turns about one fixed axis, z, and its ω, L, M and I are numbers.
    pub plane: bool,
    /// The axis, fixed in space, that the body turns about.
    pub(crate) fixed_axis: Option<u8>,
    /// The place of a particle, which is fixed in the body.
    pub(crate) particle: Option<Symbol>,
    /// Whether the places of particles are measured from the mass centre.
    pub(crate) measures_from_centre: bool,
    /// What is taken about a point that moves, and the mass centre beside it.
    pub(crate) moving_point: Option<MovingPoint>,
    /// The label of the only point that moments are taken about, where it is none of the customary ones.
    pub(crate) own_point: Option<String>,
    /// Where the sentence stands from which on it does so, where other motions are spoken of before.
    pub(crate) turns_from: Option<u32>,
    /// Whether the rate of the only angle is ω about that axis.
    pub(crate) turns_by_angle: bool,
    /// The axis that the only wheel lies along.
    pub(crate) wheel_axis: Option<u8>,
    /// The number that its momentum is, where that has the letter of the whole.
    pub(crate) labelled_wheel: Option<LabelledWheel>,
    /// Whether a rotor is all that has inertia here: of what carries it, none is written.
    pub(crate) rotor_alone: bool,
    /// The only torque of a turn about one axis, where words say that it brakes: its axis, and where they name it.
    pub(crate) brake: Option<(Symbol, u8, Span)>,
    /// Unit vectors along, around and up.
    pub(crate) round_axes: Option<RoundAxes>,
    /// Whether a line gives the momentum as that of a spin alone: with a label the letter is another rotor's.
    pub(crate) spin_alone: bool,
    /// The moment of inertia in it.
    pub(crate) moment_of_spin: Option<Symbol>,
    /// A spin that is carried round, where all that is written of it are vectors and their sizes.
    pub(crate) carried_spin: Option<CarriedSpin>,
    /// Whether the plain letter i is the imaginary unit.
    pub(crate) imaginary: bool,
    /// Lines that say what something is at the beginning, and how it goes on another line says.
    pub(crate) beginnings: BTreeSet<u32>,
    /// Symbols with what they are at the beginning.
    pub(crate) starts: Vec<(Symbol, Node)>,
    /// Letters whose value has a weight in it.
    pub(crate) totals: BTreeSet<Letter>,
    /// Letters of a period.
    pub(crate) periods: BTreeSet<Letter>,
    /// Whether ω and the inertia are only ever numbers.
    pub(crate) flat: bool,
    /// Whether principal axes are chosen, as any may be.
    pub(crate) on_chosen_axes: bool,
    /// Whether two letters, A and C, stand for the three moments A, A, C.
    pub symmetric: bool,
    /// Whether a symbol that is used before its definition is what its use makes it.
    pub by_use: bool,
    /// Whether the reading is only tried, and what puts false lines right is not looked for.
    pub on_trial: bool,
    /// Whether products of inertia are entries of the matrix, where nothing else says their sign.
    pub products_as_entries: bool,
    /// Indices that are summed over where they are repeated, so that a letter with two of them is an entry of its tensor.
    pub summed: Option<Indices>,
    /// Whether primes are the label of axes that a matrix turns to, whichever way that goes.
    pub turned_primes: bool,
    /// The angles that the body is turned by, where words name them.
    pub euler_angles: Option<EulerAngles>,
    /// Moments that the words give a letter.
    pub moments: Vec<NamedMoment>,
    /// Whether the words name products of inertia.
    pub speaks_of_products: bool,
    /// The letter of the unit vectors along the axes, where it is none of the usual ones.
    pub unit_vectors: Option<Letter>,
    /// Whether the words have axes that do not spin with the body.
    pub axes_without_spin: bool,
    /// Letters of the length of a vector, by words.
    pub(crate) sizes: BTreeMap<Letter, Quantity>,
    /// What the document calls the axes of the body, where that is neither x, y, z nor 1, 2, 3.
    pub(crate) axis_labels: Option<Labels>,
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
    /// The letter that stands on space axes where it has no label.
    pub(crate) plain_in_space: Option<Letter>,
}

impl Reading {
    /// Reads the letters of a document.
    pub(crate) fn of(document: &Text) -> Self {
        let mut reading = Self {
            usage: Usage::of(document),
            frames: Frames::of(document),
            ..Self::default()
        };
        reading.round_axes = RoundAxes::of(&reading.usage);
        reading.imaginary = has_imaginary_unit(document, &reading.usage);
        reading.points = TwoPoints::of(document, &reading.usage);
        reading.by_front_matter(document);
        reading.listen(document);
        reading.note_unit_matrices(document);
        reading.listed_moments(document);
        reading.named_rates(document);
        reading.sequences(has_differences(document));
        reading.one_moment_of_the_row(document);
        reading.by_moments(document);
        reading.flat = reading.is_flat();
        reading.axes_without_spin = document.says(WITHOUT_SPIN);
        reading.note_unit_vectors(document);
        reading.note_totals(document);
        reading.note_periods(document);
        reading.note_arms(document);
        reading.note_beginnings(document);
        reading.note_labelled_wheel(document);
        reading.by_words();
        reading.by_force_law(document);
        reading.part_rivals(document);
        reading.part_stored(document);
        reading.by_attitude(document);
        reading.wheel_speeds();
        reading.by_custom();
        reading.by_momentum_law(document);
        reading.by_inverse_momentum_law(document);
        reading.products_apart();
        reading.by_coefficients(document);
        reading.by_moment_law(document);
        reading.part_wheel_torques(document);
        reading.part_turned_tensor(document);
        reading.part_inverse_tensor(document);
        reading.by_points();
        reading.by_labels(document);
        reading.note_spin_alone(document);
        reading.note_carried_spin(document);
        reading.note_own_point(document);
        reading.in_a_plane();
        reading.about_fixed_axis(document);
        reading.wheel_along_axis(document);
        reading.part_rotor();
        reading.part_brake(document);
        reading.part_labelled_wheel();
        reading.typed_w(document.format == Format::Text);
        reading.note_moving_point(document);
        reading.particle =
            place_in_rigid_body(document).or_else(|| reading.place_carried_round(document));
        reading.measures_from_centre = measures_from_centre(document);
        let matrix = reading.attitude.matrix.as_ref();
        let to_body = reading.attitude.convention.matrix_to_body;
        reading.space_axes = matrix
            .and_then(|matrix| SpaceAxes::of(document, Some(matrix), &reading.quantities, to_body));
        reading.plain_in_space = matrix
            .filter(|_| reading.space_axes.is_none())
            .and_then(|matrix| momentum_in_space(document, matrix, &reading.quantities));
        reading
            .on_both_axes
            .extend(reading.plain_in_space.iter().cloned());
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
        let number =
            named || self.usage.lengths.contains(letter) || self.usage.numbers.contains(letter);
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
        if !symbol.style.tilde || symbol.subscripts.iter().any(|s| axis(s).is_some()) {
            return false;
        }
        let letter = Letter::of(symbol);
        let quantity = self.quantities.get(&letter);
        (self.usage.is_vector(&letter) || quantity.is_some_and(|q| q.shape() == Shape::Vector))
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

    /// The letter of three numbered vectors that words call unit vectors: "the unit vectors ⟨a_1⟩, ⟨a_2⟩, ⟨a_3⟩".
    fn note_unit_vectors(&mut self, document: &Text) {
        let usual = ["e", "b", "n", "u", "E"].map(Letter::plain);
        self.unit_vectors = document.sentences().iter().find_map(|sentence| {
            let text = sentence.named();
            let (_, behind) = text.split_once("unit vectors")?;
            let name = behind.split_once('⟨')?.1.split('⟩').next()?.to_owned();
            let letter = Letter::plain(&name);
            let numbered = |index: &str| {
                let mut symbols = sentence.symbols().map(|(symbol, _)| symbol);
                symbols.any(|s| s.name == name && s.style.vector && s.subscripts == [index])
            };
            let triad = ["1", "2", "3"].iter().all(|index| numbered(index));
            (triad && !usual.contains(&letter)).then_some(letter)
        });
    }

    /// The letters of the attitude, those apart that stand for something else.
    fn by_attitude(&mut self, document: &Text) {
        let taken = |letter: &Letter| {
            self.components.contains_key(letter) || self.quantities.contains_key(letter)
        };
        self.attitude = AttitudeReading::of(document, &taken);
        if let Some(letter) = self.attitude.matrix.clone() {
            self.quantities.insert(letter, Quantity::Attitude);
        }
    }
}
