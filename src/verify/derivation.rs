//! Derives a declared system from the laws: what each letter is, row by row, in the letters of the author.
//!
//! `plan` says of which frames and bodies there is something to tell, `nouns` names their quantities in the language of
//! declarations, `letters` writes values in the author's letters and finds letters where the author has none, `kinematics`,
//! `dynamics`, `energy` and `steady` go through the laws. A row is told only where the facts prove it.

mod dynamics;
mod energy;
mod inertia;
mod kinematics;
mod letters;
mod names;
mod nouns;
mod plan;
mod printing;
mod sought;
mod steady;
mod story;
mod text;

pub use text::Text;

use crate::notation::Macros;
use crate::verify::Declared;
use crate::verify::derivation::nouns::Nouns;
use crate::verify::derivation::plan::Plan;
use crate::verify::derivation::story::Story;
use crate::verify::language::statement::{Misread, NounPhrase, Statement};
use crate::verify::language::{Lexicon, read_sentence};

/// What to derive of a system.
#[derive(Clone, Debug, Default)]
pub struct Wish {
    /// The one quantity that is asked for, as a noun phrase: "the moment on the top about O". All of them where none is.
    pub find: Option<String>,
    /// Whether steady motions are looked for.
    pub steady: bool,
}

/// The derivation of a system.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Derived {
    /// The noun of the one quantity that was asked for.
    pub sought: Option<String>,
    /// The name of the frame on whose axes components are taken.
    pub axes: String,
    /// Sentences that declare the letters which the author has not.
    pub sentences: Vec<String>,
    /// The frames, each body, and what else was asked for.
    pub parts: Vec<Part>,
}

/// All steps about one subject.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// What it is about.
    pub subject: Subject,
    /// The steps in order.
    pub steps: Vec<Step>,
}

/// What a part of a derivation is about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Subject {
    /// How the frames turn.
    Frames,
    /// A body, by its name with an article: "the top".
    Body(String),
    /// Motions in which the angles that the energy depends on do not change.
    Steady {
        /// The letters of these; none where no steady motion is found.
        held: Vec<String>,
        /// Those of the others, which change at constant rates.
        even: Vec<String>,
    },
}

/// One law and what it gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The law.
    pub law: Law,
    /// Sentences that say what the new letters are.
    pub letters: Vec<String>,
    /// What follows. Components that are zero have no row.
    pub rows: Vec<Row>,
}

/// A relation between two sides.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// The left side.
    pub left: Text,
    /// The right side.
    pub right: Text,
}

/// Why rows hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Law {
    /// Angular velocities add up along a chain of frames.
    AngularVelocities,
    /// A point of a turning body moves with ω × r.
    PointOfBody,
    /// A velocity is the rate of a position.
    Velocity,
    /// An acceleration is the rate of a velocity, by the transport law.
    Acceleration,
    /// p = m v.
    Momentum,
    /// The sum of the forces is the rate of the momentum.
    Newton,
    /// L = I ω.
    AngularMomentum,
    /// The angular momentum of a whole is that of its parts.
    SumOfParts,
    /// The moment is the rate of the angular momentum, by the transport law.
    Moment,
    /// The same with the angular momentum put in.
    MomentPutIn,
    /// The weight on the axes used.
    Weight,
    /// The moments of loads.
    MomentsOfLoads,
    /// The moment that the motion needs is that of the loads.
    Equations,
    /// The force that the motion needs is that of the loads.
    EquationsOfCentre,
    /// T = ½ ω·L of a body that turns about a fixed point.
    KineticEnergy,
    /// ½ m v² of the mass centre, and that of the turning about it.
    Koenig,
    /// The energy of the weight.
    PotentialEnergy,
    /// The sum of both.
    TotalEnergy,
    /// What does not change.
    FirstIntegrals,
    /// What a steady motion needs.
    Steady,
    /// Nothing but what the quantity is.
    Definition,
}

/// Why there is no derivation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// The quantity that is asked for is not understood; columns count in the phrase.
    Misread(Misread),
    /// It is understood, and the system has no such quantity.
    NoSuchQuantity,
    /// It is known, and too long to be written in the author's letters.
    NotWritten,
    /// No sentence speaks of a frame that turns or of a body.
    NothingToDerive,
}

/// Derives what is declared.
///
/// ```
/// use polhode::notation::{document::Format, read, sentences};
/// use polhode::source::Source;
/// use polhode::verify::derivation::{Law, Wish, derive_system};
/// use polhode::verify::{Sheet, declarations};
///
/// let text = "N is an inertial frame.\nB is a frame fixed in the rotor.\n\
///     x, y, z are the axes of B.\nO is a point fixed in N and in B.\n\
///     B turns relative to N about z by the angle `\\theta`.\n\
///     `C` is the moment of inertia of the rotor about the axis through O along z.\n\
///     The axes of B are principal axes of the rotor about O.\n";
/// let sheet = Sheet { source: Source::new("rotor", text), sentences: sentences(text) };
/// let (document, _) = read("", "", Format::Markdown);
/// let declared = declarations(&document, &[sheet]);
/// let wish = Wish { find: Some("the moment on the rotor about O".into()), steady: false };
/// let derived = derive_system(&declared, &wish).expect("a derivation");
/// let last = derived.parts.last().and_then(|part| part.steps.last()).expect("a step");
/// assert_eq!(last.law, Law::Moment);
/// assert_eq!(last.rows[0].right.latex, "C \\ddot{\\theta}");
/// ```
///
/// # Errors
/// Where the wish is not understood, or nothing is declared that could be derived.
pub fn derive_system(declared: &Declared, wish: &Wish) -> Result<Derived, Refusal> {
    let declarations = declared.declarations.as_slice();
    let sought = wish.find.as_deref().map(phrase).transpose()?;
    let plan = Plan::of(declarations);
    if plan.frames.is_empty() && plan.bodies.is_empty() {
        return Err(Refusal::NothingToDerive);
    }
    let (reading, nouns) = Nouns::read(declarations, &plan, sought.as_ref());
    if sought.is_some() && nouns.sought().is_none() {
        return Err(Refusal::NoSuchQuantity);
    }
    let mut story = Story::new(reading, nouns, plan, declarations);
    match sought {
        Some(_) => story.tell_sought(),
        None => story.tell_all(),
    }
    if wish.steady {
        story.tell_steady();
    }
    let derived = story.finish(wish.find.clone());
    match derived.parts.iter().all(|part| part.steps.is_empty()) {
        true => Err(Refusal::NotWritten),
        false => Ok(derived),
    }
}

/// The noun phrase that a text is: as behind "is" in a sentence about a letter.
fn phrase(text: &str) -> Result<NounPhrase, Refusal> {
    const BEFORE: &str = "$X$ is ";
    let sentence = format!("{BEFORE}{}", text.trim().trim_end_matches('.'));
    let before = BEFORE.chars().count();
    let misread = |mut wrong: Misread| {
        wrong.column = wrong.column.saturating_sub(before).max(1);
        Refusal::Misread(wrong)
    };
    let read = read_sentence(&sentence, 1, &Macros::default(), Lexicon::shared());
    let said = read.map_err(misread)?.into_iter().next();
    match said.map(|declaration| declaration.statement) {
        Some(Statement::Is { what, .. }) => Ok(what),
        _ => Err(Refusal::NoSuchQuantity),
    }
}
