//! `polhode derive`.

use crate::cli::output;
use crate::report::derive::{Axes, Body, Component, DeriveOptions, derive};
use anstream::ColorChoice;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// Prints the derivation itself, from ΣM = dL/dt to Euler's equations; check proves what it prints
#[derive(Args, Debug)]
#[command(after_help = "\
Example:
  polhode derive --body one-plane --component x
  polhode derive --axes turning --format latex --out derivation.tex")]
pub(super) struct Options {
    /// The components to print
    #[arg(long, value_enum, default_value_t = ComponentName::All)]
    component: ComponentName,
    /// What is known of the body's products of inertia
    #[arg(long, value_enum, default_value_t = BodyName::Full)]
    body: BodyName,
    /// Axes that turn with the body, or on their own
    #[arg(long, value_enum, default_value_t = AxesName::Body)]
    axes: AxesName,
    /// What to write
    #[arg(long, value_enum, default_value_t = Form::Markdown)]
    format: Form,
    /// Write to a file instead of the terminal
    #[arg(long, value_name = "PATH")]
    out: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum ComponentName {
    X,
    Y,
    Z,
    All,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum BodyName {
    /// All three products of inertia
    Full,
    /// Only I_xz: xz is a plane of symmetry
    OnePlane,
    /// No products of inertia
    Principal,
    /// No products, two equal moments
    Axisymmetric,
    /// No products, three equal moments
    Sphere,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum AxesName {
    /// Attached to the body, Ω = ω
    Body,
    /// With an angular velocity Ω of their own
    Turning,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Form {
    Markdown,
    Latex,
    Unicode,
    Json,
}

impl Options {
    fn derive_options(&self) -> DeriveOptions {
        DeriveOptions {
            component: match self.component {
                ComponentName::X => Component::X,
                ComponentName::Y => Component::Y,
                ComponentName::Z => Component::Z,
                ComponentName::All => Component::All,
            },
            body: match self.body {
                BodyName::Full => Body::Full,
                BodyName::OnePlane => Body::OnePlane,
                BodyName::Principal => Body::Principal,
                BodyName::Axisymmetric => Body::Axisymmetric,
                BodyName::Sphere => Body::Sphere,
            },
            axes: match self.axes {
                AxesName::Body => Axes::Body,
                AxesName::Turning => Axes::Turning,
            },
        }
    }
}

/// Prints the derivation and returns the exit code.
pub(super) fn run(options: &Options, color: ColorChoice) -> u8 {
    let derivation = derive(&options.derive_options());
    let text = match options.format {
        Form::Markdown => derivation.markdown(),
        Form::Latex => derivation.latex(),
        Form::Unicode => derivation.unicode(),
        Form::Json => match derivation.json() {
            Ok(text) => text,
            Err(error) => {
                eprintln!("error: {error}");
                return 2;
            }
        },
    };
    output::deliver(&text, options.out.as_deref(), color)
}
