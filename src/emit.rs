//! Code for the equations and their Jacobians, in Rust, C, Python or LaTeX.
//!
//! What [`emit()`] writes is straight-line code with shared subexpressions: no loop, no allocation, no dependency. It comes from
//! the equations that the library itself runs, recorded on a number that remembers what is done with it, so that what is
//! known of a body (a zero product of inertia, equal moments, the tensor itself) stands in no operation. A test stands beside
//! the code and holds it against values of the library.
//!
//! ```
//! use polhode::emit::{KnownInertia, Language, Quantity, Request, emit};
//! let request = Request { known: KnownInertia::Principal, ..Request::new(Quantity::Moment, Language::C) };
//! let code = emit(&request)?;
//! assert!(code.text.contains("moment[0] = i_xx*a_x - (i_yy - i_zz)*w_y*w_z;"));
//! assert_eq!((code.operations.additions, code.operations.multiplications), (6, 9));
//! # Ok::<(), polhode::emit::EmitError>(())
//! ```
//!
//! The build script of another crate can call it, with polhode as a build dependency without its default features and with the
//! feature `emit`; `polhode derive --as` does the same in a terminal.

mod adjoint;
mod body;
mod equations;
mod error;
mod graph;
mod lines;
mod print;
mod routine;
mod sample;

pub use body::KnownInertia;
pub use error::EmitError;
pub use lines::Operations;

use crate::emit::lines::Lines;
use crate::emit::routine::Routine;
use crate::mechanics::InertiaParameters;

/// What to compute.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The moment ΣM = I α + ω × I ω.
    Moment,
    /// The angular acceleration α = I⁻¹ (M − ω × I ω).
    Acceleration,
    /// The angular acceleration and its Jacobian, 3 rows, in ω, torque and inertia.
    Jacobian,
    /// The matrix Y(ω, α), 3 rows, with ΣM = Y · inertia.
    Regressor,
    /// A step of the classical Runge–Kutta method under a torque that is constant in body axes.
    Step,
    /// That step and its Jacobian, 6 rows, in attitude, ω, torque, inertia and dt: see [`jacobian`](crate::motion::jacobian).
    StepJacobian,
}

/// Columns of a Jacobian, in the order in which they stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Column {
    /// θ of q exp(θ/2): 3.
    Attitude,
    /// ω in body axes: 3.
    AngularVelocity,
    /// The torque in body axes: 3.
    Torque,
    /// The parameters that are not known of the inertia.
    Inertia,
    /// The length of the step: 1.
    Dt,
}

/// The language of the code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// A function on arrays, and a test module.
    Rust,
    /// A C99 function, and a `main` that tests it where `POLHODE_TEST` is defined.
    C,
    /// A function on sequences, and a test function that running the file calls.
    Python,
    /// One `align*` of amsmath.
    Latex,
}

/// The numbers that the code runs on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Precision {
    /// `f64`, `double`.
    #[default]
    Double,
    /// `f32`, `float`.
    Single,
}

/// What code to write.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// What it computes.
    pub of: Quantity,
    /// Its language.
    pub language: Language,
    /// Its numbers.
    pub precision: Precision,
    /// What is known of the inertia.
    pub known: KnownInertia,
    /// The order and the sign of the parameters that are not known.
    pub parameters: InertiaParameters,
    /// The columns of a Jacobian; none of them means all that it has.
    pub columns: Vec<Column>,
    /// The name of the function, if it is to have one of its own.
    pub name: Option<String>,
}

/// Code, ready to be written to a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Code {
    /// The text.
    pub text: String,
    /// How many operations the function does.
    pub operations: Operations,
}

impl Quantity {
    /// The columns that its Jacobian has.
    fn columns(self) -> &'static [Column] {
        use Column::{AngularVelocity, Attitude, Dt, Inertia, Torque};
        match self {
            Self::Jacobian => &[AngularVelocity, Torque, Inertia],
            Self::StepJacobian => &[Attitude, AngularVelocity, Torque, Inertia, Dt],
            _ => &[],
        }
    }

    /// The name of its function and the formula.
    fn told(self) -> (&'static str, &'static str) {
        match self {
            Self::Moment => (
                "rigid_body_moment",
                "The moment on a rigid body, I alpha + omega x I omega.",
            ),
            Self::Acceleration => (
                "rigid_body_acceleration",
                "The angular acceleration of a rigid body, I^-1 (torque - omega x I omega).",
            ),
            Self::Jacobian => (
                "rigid_body_acceleration_jacobian",
                "The angular acceleration of a rigid body, I^-1 (torque - omega x I omega), and its Jacobian.",
            ),
            Self::Regressor => (
                "rigid_body_regressor",
                "The matrix of which the product with the inertia is the moment I alpha + omega x I omega.",
            ),
            Self::Step => (
                "rigid_body_step",
                "A step of a rigid body by the classical Runge-Kutta method, the torque constant in the body.",
            ),
            Self::StepJacobian => (
                "rigid_body_step_jacobian",
                "A step of a rigid body by the classical Runge-Kutta method, the torque constant in the body, and its Jacobian.",
            ),
        }
    }
}

impl Request {
    /// Code in double precision for a body of which nothing is known, parameters and columns as in
    /// [`jacobian`](crate::motion::jacobian).
    pub fn new(of: Quantity, language: Language) -> Self {
        Self {
            of,
            language,
            precision: Precision::Double,
            known: KnownInertia::Full,
            parameters: InertiaParameters::MuJoCo,
            columns: vec![],
            name: None,
        }
    }

    /// The columns of the Jacobian in their order.
    fn columns(&self) -> Vec<Column> {
        let all = self.of.columns().iter().copied();
        let asked = |column: &Column| self.columns.is_empty() || self.columns.contains(column);
        all.filter(asked).collect()
    }

    fn name(&self) -> &str {
        self.name.as_deref().unwrap_or(self.of.told().0)
    }
}

/// The code of a request.
///
/// # Errors
/// A tensor that no body has or that the precision can't hold, a column that the quantity's Jacobian has not, a name that is
/// no name in the language, single precision in a language that has none.
pub fn emit(request: &Request) -> Result<Code, EmitError> {
    error::refuse(request)?;
    let routine = Routine::new(request);
    let lines = Lines::new(&routine);
    if !lines.fit(request.precision) {
        return Err(EmitError::OutOfRange);
    }
    let text = print::text(request, &lines);
    Ok(Code {
        text,
        operations: lines.operations(),
    })
}
