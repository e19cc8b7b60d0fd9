//! `polhode derive --as`: the equations as code.

use crate::cli::output;
use crate::emit::{Column, KnownInertia, Language, Precision, Quantity, Request, emit};
use crate::mechanics::InertiaParameters;
use crate::report::derive::Body;
use anstream::ColorChoice;
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use nalgebra::{Matrix3, Vector3};
use std::path::Path;

#[derive(Args, Debug)]
#[command(next_help_heading = "Code")]
pub(super) struct CodeOptions {
    /// Write code instead of the derivation, with a test beside it
    #[arg(long = "as", value_name = "LANGUAGE", value_parser = one_of(&LANGUAGES), requires = "of",
        conflicts_with_all = ["declare", "component", "axes", "format"])]
    language: Option<Language>,
    /// What the code computes; the Jacobians come with their value
    #[arg(long, value_name = "QUANTITY", value_parser = one_of(&QUANTITIES), requires = "language")]
    of: Option<Quantity>,
    /// The tensor as numbers, kg m²: three principal moments, or six in the order of --parameters; else --body says what is known
    #[arg(
        long,
        value_name = "NUMBERS",
        value_delimiter = ',',
        allow_negative_numbers = true,
        requires = "language",
        conflicts_with = "body"
    )]
    inertia: Vec<f64>,
    /// The order and the sign of the inertia parameters
    #[arg(long, value_name = "ORDER", value_parser = one_of(&PARAMETERS), default_value = "entries", requires = "language")]
    parameters: InertiaParameters,
    /// The columns of a Jacobian, all if left out
    #[arg(long, value_name = "COLUMNS", value_delimiter = ',', value_parser = one_of(&COLUMNS), requires = "language")]
    wrt: Vec<Column>,
    /// The numbers that the code runs on
    #[arg(long, value_name = "TYPE", value_parser = one_of(&PRECISIONS), default_value = "f64", requires = "language")]
    precision: Precision,
    /// The name of the function
    #[arg(long, value_name = "NAME", requires = "language")]
    name: Option<String>,
}

/// A name of a value, the value, and what it is.
type Named<T> = (&'static str, T, &'static str);

const LANGUAGES: [Named<Language>; 4] = [
    (
        "rust",
        Language::Rust,
        "a function on arrays, with a test module",
    ),
    (
        "c",
        Language::C,
        "a C99 function, and a test program where POLHODE_TEST is defined",
    ),
    (
        "python",
        Language::Python,
        "a function on sequences, with a test function",
    ),
    ("latex", Language::Latex, "an align* of amsmath"),
];

const QUANTITIES: [Named<Quantity>; 6] = [
    ("moment", Quantity::Moment, "I α + ω × I ω"),
    ("acceleration", Quantity::Acceleration, "I⁻¹ (M − ω × I ω)"),
    (
        "jacobian",
        Quantity::Jacobian,
        "of the acceleration in ω, torque and inertia",
    ),
    (
        "regressor",
        Quantity::Regressor,
        "Y(ω, α), of which the product with the inertia is the moment",
    ),
    (
        "step",
        Quantity::Step,
        "of the classical Runge–Kutta method",
    ),
    (
        "step-jacobian",
        Quantity::StepJacobian,
        "of that step in attitude, ω, torque, inertia and dt",
    ),
];

const PARAMETERS: [Named<InertiaParameters>; 4] = [
    (
        "entries",
        InertiaParameters::MuJoCo,
        "xx, yy, zz, xy, xz, yz of the tensor, as in MuJoCo",
    ),
    (
        "integrals",
        InertiaParameters::Lecture,
        "the same with I_xy = ∫xy dm, as in textbooks",
    ),
    (
        "urdf",
        InertiaParameters::Urdf,
        "xx, xy, xz, yy, yz, zz of the tensor",
    ),
    (
        "pinocchio",
        InertiaParameters::Pinocchio,
        "xx, xy, yy, xz, yz, zz of the tensor",
    ),
];

const COLUMNS: [Named<Column>; 5] = [
    ("attitude", Column::Attitude, "θ of q exp(θ/2)"),
    (
        "angular_velocity",
        Column::AngularVelocity,
        "ω in body axes",
    ),
    ("torque", Column::Torque, "in body axes"),
    ("inertia", Column::Inertia, "what is not known of it"),
    ("dt", Column::Dt, "the length of the step"),
];

const PRECISIONS: [Named<Precision>; 2] = [
    ("f64", Precision::Double, "double precision"),
    ("f32", Precision::Single, "single precision"),
];

/// Takes one of these names.
fn one_of<T: Copy + Send + Sync>(
    names: &'static [Named<T>],
) -> impl TypedValueParser<Value = T> + use<T> {
    let values = names
        .iter()
        .map(|(name, _, help)| PossibleValue::new(*name).help(*help));
    PossibleValuesParser::new(values).try_map(|given| {
        let found = names.iter().find(|(name, ..)| *name == given);
        found.map(|(_, value, _)| *value).ok_or("no such name")
    })
}

impl CodeOptions {
    /// Writes the code and returns the exit code; `None` if a derivation is asked for.
    pub(super) fn run(&self, body: Body, out: Option<&Path>, color: ColorChoice) -> Option<u8> {
        let (language, of) = (self.language?, self.of?);
        let Some(known) = self.known(body) else {
            let message = "--inertia takes three principal moments, or six numbers in the order of --parameters";
            return Some(output::failed(message));
        };
        let request = Request {
            precision: self.precision,
            known,
            parameters: self.parameters,
            columns: self.wrt.clone(),
            name: self.name.clone(),
            ..Request::new(of, language)
        };
        Some(match emit(&request) {
            Ok(code) => output::deliver(&code.text, out, color),
            Err(error) => output::failed(&error.to_string()),
        })
    }

    fn known(&self, body: Body) -> Option<KnownInertia> {
        match *self.inertia {
            [] => Some(match body {
                Body::Full => KnownInertia::Full,
                Body::OnePlane => KnownInertia::OnePlane,
                Body::Principal => KnownInertia::Principal,
                Body::Axisymmetric => KnownInertia::Axisymmetric,
                Body::Sphere => KnownInertia::Sphere,
            }),
            [a, b, c] => {
                let tensor = Matrix3::from_diagonal(&Vector3::new(a, b, c));
                Some(KnownInertia::Tensor(tensor))
            }
            _ => {
                let numbers = self.inertia.as_slice().try_into().ok()?;
                Some(KnownInertia::Tensor(self.parameters.tensor::<f64>(numbers)))
            }
        }
    }
}
