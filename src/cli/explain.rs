//! `polhode explain`.

use crate::cli::input;
use crate::cli::output::{self, Form, failed};
use crate::cli::run::load;
use crate::scene::{Explanation, Scene, explain};
use annotate_snippets::normalize_untrusted_str;
use anstream::ColorChoice;
use clap::Args;
use serde_json::json;
use std::fmt::Write;
use std::path::PathBuf;

/// Says what a scene needs and what is skipped, without running it
#[derive(Args, Debug)]
#[command(after_help = "\
Example:
  polhode explain top.toml
  polhode explain top.toml --format json

What can be written in a scene: polhode help scene")]
pub(super) struct Options {
    /// A scene (.toml), or - for standard input
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Plan by the costs of this machine, a file of `polhode bench --costs` [default: those of a common server]
    #[arg(long, value_name = "FILE")]
    costs: Option<PathBuf>,
    /// Text for people or JSON for programs
    #[arg(long, value_enum, default_value_t = Form::Text)]
    format: Form,
    /// Write to a file instead of the terminal
    #[arg(long, value_name = "PATH")]
    out: Option<PathBuf>,
}

/// Explains the plan and returns the exit code.
pub(super) fn run(options: &Options, color: ColorChoice) -> u8 {
    let scene = match load(&options.scene, options.costs.as_deref(), color) {
        Ok(scene) => scene,
        Err(code) => return code,
    };
    let mut explanations = Vec::new();
    for group in &scene.groups {
        match explain(group, &scene.run) {
            Ok(explanation) => explanations.push(explanation),
            Err(error) => {
                let name = input::name(&options.scene);
                return failed(&format!("{name}: body {:?}: {error}", group.name));
            }
        }
    }
    let text = match options.format {
        Form::Text => text(&scene, &explanations),
        Form::Json => json(&scene, &explanations),
    };
    output::deliver(&text, options.out.as_deref(), color)
}

fn text(scene: &Scene, explanations: &[Explanation]) -> String {
    let mut text = String::new();
    for found in explanations {
        let name = normalize_untrusted_str(&found.name);
        let many = match found.count {
            1 => String::new(),
            n => format!(" × {n}"),
        };
        let _ = writeln!(text, "{name}{many}");
        for (head, value) in [
            ("body", found.body.clone()),
            ("torque", found.torque.clone()),
            ("asks for", found.asks.join(", ")),
            ("method", found.way.to_string()),
            ("because", found.why.clone()),
            ("costs", format!("about {}", time(found.seconds))),
        ] {
            let _ = writeln!(text, "  {head:<9} {value}");
        }
        for skip in &found.skipped {
            let _ = writeln!(text, "  skips     {}: {}", skip.what, skip.why);
        }
        text.push('\n');
    }
    let run = &scene.run;
    let total = explanations.iter().map(|found| found.seconds).sum();
    let _ = writeln!(
        text,
        "{} s to {:e}, about {} on one core{}",
        run.duration,
        run.tolerance,
        time(total),
        if run.estimate_error {
            ", and a quarter to as much again for the estimate of the error"
        } else {
            ""
        }
    );
    text
}

/// A time with its unit, in two digits.
fn time(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s < 1e-6 => (s * 1e9, "ns"),
        s if s < 1e-3 => (s * 1e6, "µs"),
        s if s < 1.0 => (s * 1e3, "ms"),
        s => (s, "s"),
    };
    if value < 10.0 {
        format!("{value:.1} {unit}")
    } else {
        format!("{value:.0} {unit}")
    }
}

fn json(scene: &Scene, explanations: &[Explanation]) -> String {
    let bodies: Vec<_> = explanations
        .iter()
        .map(|found| {
            let skipped = found
                .skipped
                .iter()
                .map(|skip| json!({"what": skip.what, "why": skip.why}));
            json!({
                "name": found.name,
                "count": found.count,
                "body": found.body,
                "torque": found.torque,
                "asks": found.asks,
                "method": found.way.to_string(),
                "step_tolerance": found.way.step_tolerance(),
                "why": found.why,
                "seconds": found.seconds,
                "skipped": skipped.collect::<Vec<_>>(),
            })
        })
        .collect();
    let run = json!({"duration": scene.run.duration, "tolerance": scene.run.tolerance});
    let form = json!({"schema": "polhode-explain/1", "run": run, "bodies": bodies});
    format!("{form:#}\n")
}
