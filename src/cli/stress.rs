//! `polhode stress`.

use crate::bench::{Axis, CONTENDERS, Cell, Contender, axes, cells, held};
use crate::cli::output::{self, TableForm, failed};
use crate::cli::{chart, input};
use anstream::ColorChoice;
use clap::Args;
use indicatif::ProgressBar;
use serde_json::json;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

/// Maps where each method holds: inertia ratios, the separatrix, scales, long runs, single precision
#[derive(Args, Debug)]
#[command(after_help = "\
Example:
  polhode stress --quick
  polhode stress --diagrams diagrams --format csv --out stress.csv")]
pub(super) struct Options {
    /// Leave out durations above 1e4 s
    #[arg(long)]
    quick: bool,
    /// Text for people, JSON or CSV for programs
    #[arg(long, value_enum, default_value_t = TableForm::Text)]
    format: TableForm,
    /// Write to a file instead of the terminal
    #[arg(long, value_name = "PATH")]
    out: Option<PathBuf>,
    /// Also draw a heat map (SVG) of each axis into this folder
    #[arg(long, value_name = "FOLDER")]
    diagrams: Option<PathBuf>,
}

/// The error up to which a method is said to hold.
const HOLDS: f64 = 1e-6;

/// Maps, and returns the exit code.
pub(super) fn run(options: &Options, color: ColorChoice) -> u8 {
    let longest = if options.quick { 1e4 } else { 1e6 };
    let (axes, found) = match map(longest) {
        Ok(found) => found,
        Err(error) => return failed(&error),
    };
    if let Some(folder) = &options.diagrams
        && let Err(error) = diagrams(folder, &axes, &found)
    {
        return failed(&format!("{}: {error}", input::name(folder)));
    }
    let text = match options.format {
        TableForm::Text => text(&axes, &found),
        TableForm::Csv => csv(&found),
        TableForm::Json => json(&axes, &found),
    };
    output::deliver(&text, options.out.as_deref(), color)
}

/// The plan with its estimate steps as the plan without does, and so does what also gives a Jacobian.
fn contenders() -> Vec<Contender> {
    let all = CONTENDERS.into_iter();
    all.filter(|c| *c != Contender::PlanEstimated && !c.has_jacobian())
        .collect()
}

fn map(longest: f64) -> Result<(Vec<Axis>, Vec<Cell>), String> {
    let axes = axes(longest).map_err(chart::said)?;
    let contenders = contenders();
    let count: usize = axes.iter().map(|axis| axis.cases.len()).sum();
    let bar = ProgressBar::new((count * contenders.len()) as u64);
    let mut found = Vec::new();
    for axis in &axes {
        found.extend(cells(axis, &contenders, &mut || bar.inc(1)).map_err(chart::said)?);
    }
    bar.finish_and_clear();
    Ok((axes, found))
}

fn cell<'a>(found: &'a [Cell], axis: &Axis, value: f64, contender: Contender) -> Option<&'a Cell> {
    found.iter().find(|cell| {
        cell.axis == axis.name
            && cell.value.total_cmp(&value).is_eq()
            && cell.point.contender == contender
    })
}

fn field(error: f64) -> String {
    if error.is_finite() {
        format!("{error:.0e}")
    } else {
        "fails".to_owned()
    }
}

fn text(axes: &[Axis], found: &[Cell]) -> String {
    let mut text = String::new();
    for axis in axes {
        let _ = write!(text, "{}: {}\n  {:<25}", axis.name, axis.about, "error at");
        for (value, _) in &axis.cases {
            let _ = write!(text, "{:>9}", format!("{value:e}"));
        }
        text.push('\n');
        for contender in contenders() {
            let errors: Vec<_> = axis
                .cases
                .iter()
                .map(|(value, _)| {
                    cell(found, axis, *value, contender).map(|c| field(c.point.error))
                })
                .collect();
            if errors.iter().all(Option::is_none) {
                continue;
            }
            let _ = write!(text, "  {:<25}", contender.name());
            for error in errors {
                let _ = write!(text, "{:>9}", error.unwrap_or_default());
            }
            text.push('\n');
        }
        text.push('\n');
    }
    text.push_str(&words(axes, found));
    text
}

/// Where each method may be used, in words.
fn words(axes: &[Axis], found: &[Cell]) -> String {
    let mut text = format!("An error of at most {HOLDS:e} is kept by\n");
    for contender in contenders() {
        let mut lost = Vec::new();
        for axis in axes {
            let (_, values) = held(found, axis.name, contender, HOLDS);
            if !values.is_empty() {
                let values: Vec<_> = values.iter().map(|value| format!("{value:e}")).collect();
                lost.push(format!("{} {}", axis.name, values.join(", ")));
            }
        }
        let said = if lost.is_empty() {
            "everywhere".to_owned()
        } else {
            format!("everywhere but at {}", lost.join("; "))
        };
        let _ = writeln!(text, "  {:<25} {said}", contender.name());
    }
    text.push_str("The plan takes it to step within\n");
    for contender in [Contender::Taylor, Contender::Dop853] {
        if let Some(reach) = contender.reach() {
            let _ = writeln!(text, "  {:<25} {reach}", contender.name());
        }
    }
    text
}

fn csv(found: &[Cell]) -> String {
    let mut text =
        "axis,value,method,setting,error,energy_drift,momentum_drift,seconds\n".to_owned();
    let field = |value: Option<f64>| value.map_or(String::new(), |value| format!("{value:e}"));
    for cell in found {
        let p = &cell.point;
        let _ = writeln!(
            text,
            "{},{:e},\"{}\",{:e},{:e},{},{},{:e}",
            cell.axis,
            cell.value,
            p.contender.name(),
            p.setting,
            p.error,
            field(p.energy_drift),
            field(p.momentum_drift),
            p.seconds
        );
    }
    text
}

fn json(axes: &[Axis], found: &[Cell]) -> String {
    let axes: Vec<_> = axes
        .iter()
        .map(|axis| {
            let values: Vec<_> = axis.cases.iter().map(|(value, _)| *value).collect();
            json!({"name": axis.name, "about": axis.about, "values": values})
        })
        .collect();
    let cells: Vec<_> = found
        .iter()
        .map(|cell| {
            let p = &cell.point;
            json!({
                "axis": cell.axis,
                "value": cell.value,
                "method": p.contender.name(),
                "setting": p.setting,
                "error": p.error.is_finite().then_some(p.error),
                "energy_drift": p.energy_drift,
                "momentum_drift": p.momentum_drift,
                "seconds": p.seconds,
            })
        })
        .collect();
    let form = json!({"schema": "polhode-stress/1", "axes": axes, "cells": cells});
    format!("{form:#}\n")
}

fn diagrams(folder: &Path, axes: &[Axis], found: &[Cell]) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(chart::said)?;
    for axis in axes {
        let columns: Vec<_> = axis
            .cases
            .iter()
            .map(|(value, _)| format!("{value:e}"))
            .collect();
        let rows: Vec<_> = contenders()
            .into_iter()
            .map(|contender| {
                let fields = axis.cases.iter().map(|(value, _)| {
                    let error = cell(found, axis, *value, contender)?.point.error;
                    // From 1e-16, pale, to 1, dark.
                    let part = (error.max(1e-16).log10() + 16.0) / 16.0;
                    Some((part, field(error)))
                });
                (contender.name().to_owned(), fields.collect())
            })
            .collect();
        let title = format!("error: {} ({})", axis.name, axis.about);
        let svg = chart::picture((780, 400), |area| {
            chart::heat(area, &title, &columns, &rows)
        })?;
        let name = format!("stability-{}.svg", axis.name.replace(' ', "-"));
        fs::write(folder.join(name), svg).map_err(chart::said)?;
    }
    Ok(())
}
