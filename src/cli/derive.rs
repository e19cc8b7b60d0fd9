//! `polhode derive`.

mod code;

use crate::cli::{declare, output};
use crate::diagnostic::Diagnostic;
use crate::notation::{self, document::Format};
use crate::report::derive::{
    Axes, Body, Component, Derivation, DeriveOptions, derive, of_system, proved_part,
};
use crate::report::terminal;
use crate::source::{Source, Span};
use crate::verify::derivation::{Refusal, Wish, derive_system};
use crate::verify::{self, Declared};
use anstream::ColorChoice;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// Prints the derivation itself, from the laws to the equations of motion; check proves what it prints
#[derive(Args, Debug)]
#[command(after_help = "\
Example:
  polhode derive --body one-plane --component x
  polhode derive --axes turning --format latex --out derivation.tex

Of any system that a file declares, one sentence a line (polhode help language):
  polhode derive --declare examples/heavy-top.declare
  polhode derive --declare examples/heavy-top.declare --find \"the moment on the top about O\"

As code for a program:
  polhode derive --as c --of jacobian --body principal --out acceleration.c
  polhode derive --as rust --of step-jacobian --inertia 0.6,0.8,1.0 --wrt attitude,angular_velocity --precision f32

Exit code: 0 the derivation is printed, 2 a file can't be read or a sentence is not understood.")]
pub(super) struct Options {
    /// Sentences that declare a system, one a line: derive that system and not one body
    #[arg(long, value_name = "FILE", conflicts_with_all = ["component", "body", "axes"])]
    declare: Vec<PathBuf>,
    /// The one quantity to derive, in the words of the declarations: "the moment on the top about O"
    #[arg(long, value_name = "NOUN", requires = "declare")]
    find: Option<String>,
    /// Also tell under which condition the motion of the system is steady
    #[arg(long, requires = "declare")]
    steady: bool,
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
    #[command(flatten)]
    code: code::CodeOptions,
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
    let (body, out) = (options.derive_options().body, options.out.as_deref());
    if let Some(exit) = options.code.run(body, out, color) {
        return exit;
    }
    let derivation = match options.declare.is_empty() {
        true => derive(&options.derive_options()),
        false => match system(options, color) {
            Some(derivation) => derivation,
            None => return 2,
        },
    };
    let text = match options.format {
        Form::Markdown => derivation.markdown(),
        Form::Latex => derivation.latex(),
        Form::Unicode => derivation.unicode(),
        Form::Json => match derivation.json() {
            Ok(text) => text,
            Err(error) => return output::failed(&error.to_string()),
        },
    };
    output::deliver(&text, out, color)
}

/// The derivation of the declared system; says what is wrong where there is none.
fn system(options: &Options, color: ColorChoice) -> Option<Derivation> {
    let (sheets, failures) = declare::sheets(&options.declare);
    for failure in &failures {
        eprintln!("error: {}: {}", failure.path, failure.message);
    }
    let (nothing, _) = notation::read("", "", Format::Markdown);
    let declared = verify::declarations(&nothing, &sheets);
    let wrong = declare::misunderstood(&nothing, &sheets, &declared, color);
    if !(failures.is_empty() && wrong.is_empty()) {
        return None;
    }
    let wish = Wish {
        find: options.find.clone(),
        steady: options.steady,
    };
    match derive_system(&declared, &wish) {
        Ok(derived) => {
            let (proved, left_out) = proved_part(&derived, &sheets);
            if left_out > 0 {
                eprintln!(
                    "warning: {left_out} lines are left out, as check does not prove them by these declarations"
                );
            }
            if proved.parts.iter().all(|part| part.steps.is_empty()) {
                return None;
            }
            Some(of_system(&proved))
        }
        Err(refusal) => {
            refused(&refusal, &declared, options, color);
            None
        }
    }
}

fn refused(refusal: &Refusal, declared: &Declared, options: &Options, color: ColorChoice) {
    let sought = options.find.clone().unwrap_or_default();
    let (message, help, from) = match refusal {
        Refusal::Misread(misread) => {
            let column = misread.column.saturating_sub(1);
            let at = sought.char_indices().nth(column).map(|(at, _)| at);
            (
                misread.message.clone(),
                misread.help.clone(),
                at.unwrap_or(sought.len()),
            )
        }
        Refusal::NoSuchQuantity => (
            "the declared system has no such quantity".to_owned(),
            Some(
                "name a quantity with its body, point and frame; polhode help language".to_owned(),
            ),
            0,
        ),
        Refusal::NotWritten => (
            "this is too long to be written in the letters of the declarations".to_owned(),
            Some("declare letters for its parts, or other axes for its components".to_owned()),
            0,
        ),
        Refusal::NothingToDerive => {
            let message = match declared.is_empty() {
                true => "the files declare nothing",
                false => "no sentence speaks of a body or of a frame that turns",
            };
            eprintln!("error: {message}; polhode help language");
            return;
        }
    };
    let mut diagnostic = Diagnostic::error("find", Span::new(from, sought.len()), message);
    diagnostic.helps.extend(help);
    let text = terminal::diagnostics(&Source::new("--find", sought), &[diagnostic]);
    output::say(&text, color);
}
