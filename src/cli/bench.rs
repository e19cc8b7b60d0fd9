//! `polhode bench`.

mod ensemble;

use crate::bench::{
    CONTENDERS, Contender, Point, Problem, calibrate, floor, measure, problems, problems_of,
    reference, time_to,
};
use crate::cli::chart::{self, Curve, Scale};
use crate::cli::input;
use crate::cli::output::{self, TableForm, failed};
use crate::cli::run::load;
use anstream::ColorChoice;
use clap::Args;
use indicatif::ProgressBar;
use serde_json::json;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Measures run time against error, for the methods on this machine and for those of other crates
#[derive(Args, Debug)]
#[command(after_help = "\
Example:
  polhode bench --quick
  polhode bench --quick --costs costs.toml
  polhode bench --ensemble
  polhode bench --problem top --format csv --out top.csv --diagrams diagrams")]
pub(super) struct Options {
    /// Spend a minute instead of ten
    #[arg(long)]
    quick: bool,
    /// Also with the Jacobian of the end in state, torque and inertia
    #[arg(long)]
    jacobian: bool,
    /// Instead of single bodies, ten thousand heavy tops for 10 s to 1e-9
    #[arg(long, conflicts_with_all = ["jacobian", "problem", "scene", "diagrams", "costs"])]
    ensemble: bool,
    /// Only this problem (again for more): free, separatrix, top, damped, needle, or a body of the scene
    #[arg(long, value_name = "NAME")]
    problem: Vec<String>,
    /// Also the bodies of a scene
    #[arg(long, value_name = "SCENE")]
    scene: Option<PathBuf>,
    /// Text for people, JSON or CSV for programs
    #[arg(long, value_enum, default_value_t = TableForm::Text)]
    format: TableForm,
    /// Write to a file instead of the terminal
    #[arg(long, value_name = "PATH")]
    out: Option<PathBuf>,
    /// Also draw a work-precision diagram (SVG) of each problem into this folder
    #[arg(long, value_name = "FOLDER")]
    diagrams: Option<PathBuf>,
    /// Also write what methods cost on this machine into a file, for `run` and `explain --costs`
    #[arg(long, value_name = "PATH")]
    costs: Option<PathBuf>,
}

/// Measures, and returns the exit code.
pub(super) fn run(options: &Options, color: ColorChoice) -> u8 {
    if options.ensemble {
        return match ensemble::table(options.quick, options.format) {
            Ok(text) => output::deliver(&text, options.out.as_deref(), color),
            Err(code) => code,
        };
    }
    let problems = match chosen(options, color) {
        Ok(problems) => problems,
        Err(code) => return code,
    };
    let points = match points(&problems, &contenders(options.jacobian), options.quick) {
        Ok(points) => points,
        Err(error) => return failed(&error),
    };
    if let Some(folder) = &options.diagrams
        && let Err(error) = diagrams(folder, &problems, &points)
    {
        return failed(&format!("{}: {error}", input::name(folder)));
    }
    if let Some(path) = &options.costs {
        let code = write_costs(path, options.quick, color);
        if code != 0 {
            return code;
        }
    }
    let text = match options.format {
        TableForm::Text => table(&problems, &points),
        TableForm::Csv => csv(&points),
        TableForm::Json => json(&problems, &points),
    };
    output::deliver(&text, options.out.as_deref(), color)
}

fn chosen(options: &Options, color: ColorChoice) -> Result<Vec<Problem>, u8> {
    let mut all = problems().map_err(|error| failed(&error.to_string()))?;
    if let Some(path) = &options.scene {
        let scene = load(path, None, color)?;
        all.extend(problems_of(&scene).map_err(|error| failed(&error.to_string()))?);
    }
    for name in &options.problem {
        if !all.iter().any(|problem| problem.name == *name) {
            let names: Vec<_> = all.iter().map(|problem| problem.name.as_str()).collect();
            return Err(failed(&format!(
                "there is no problem {name:?}; there are {}",
                names.join(", ")
            )));
        }
    }
    if !options.problem.is_empty() {
        all.retain(|problem| options.problem.contains(&problem.name));
    }
    Ok(all)
}

fn write_costs(path: &Path, quick: bool, color: ColorChoice) -> u8 {
    match calibrate(budget(quick)) {
        Ok(costs) => {
            let text = format!("# {}, by polhode bench\n{costs}", machine());
            output::deliver(&text, Some(path), color)
        }
        Err(error) => failed(&error.to_string()),
    }
}

/// The time for each method at each setting.
fn budget(quick: bool) -> Duration {
    Duration::from_millis(if quick { 8 } else { 200 })
}

/// All methods, or those that give the end alone.
fn contenders(jacobian: bool) -> Vec<Contender> {
    let all = CONTENDERS.into_iter();
    all.filter(|contender| jacobian || !contender.has_jacobian())
        .collect()
}

fn points(
    problems: &[Problem],
    contenders: &[Contender],
    quick: bool,
) -> Result<Vec<Point>, String> {
    let budget = budget(quick);
    let mut points = Vec::new();
    let bar = ProgressBar::new((problems.len() * contenders.len()) as u64);
    for problem in problems {
        let truth = reference(&problem.member, &[problem.duration])
            .ok()
            .and_then(|states| states.first().copied())
            .ok_or_else(|| format!("{}: no reference motion", problem.name))?;
        for &contender in contenders {
            bar.inc(1);
            if !contender.takes(&problem.member) {
                continue;
            }
            for setting in contender.settings() {
                points.push(measure(problem, contender, setting, &truth, budget));
            }
        }
    }
    bar.finish_and_clear();
    Ok(points)
}

/// Errors to which the time is said.
const TARGETS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

fn table(problems: &[Problem], points: &[Point]) -> String {
    let mut text = String::new();
    for problem in problems {
        let _ = writeln!(
            text,
            "{}: {}, {} s",
            problem.name, problem.about, problem.duration
        );
        let _ = write!(text, "  {:<26}", "µs to an error of");
        for target in TARGETS {
            let _ = write!(text, "{:>10}", format!("{target:e}"));
        }
        let _ = writeln!(text, "{:>12}", "least error");
        for contender in CONTENDERS {
            let Some(least) = floor(points, &problem.name, contender) else {
                continue;
            };
            let _ = write!(text, "  {:<26}", contender.name());
            for target in TARGETS {
                let time = time_to(points, &problem.name, contender, target);
                let time = time.map_or("–".to_owned(), |time| short(time * 1e6));
                let _ = write!(text, "{time:>10}");
            }
            let _ = writeln!(text, "{least:>12.1e}");
        }
        text.push('\n');
    }
    let _ = writeln!(text, "{}", machine());
    text
}

/// Three digits.
fn short(value: f64) -> String {
    match value {
        v if v < 10.0 => format!("{v:.2}"),
        v if v < 100.0 => format!("{v:.1}"),
        v => format!("{v:.0}"),
    }
}

/// What the times were measured on.
fn machine() -> String {
    let cpu = fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|line| line.starts_with("model name"))?;
        line.split_once(':').map(|(_, name)| name.trim().to_owned())
    });
    let cpu = cpu.unwrap_or_else(|| "unknown processor".to_owned());
    format!(
        "one core of: {cpu}, {} {}",
        std::env::consts::ARCH,
        std::env::consts::OS
    )
}

fn csv(points: &[Point]) -> String {
    let mut text = "problem,method,setting,seconds,error,energy_drift,momentum_drift\n".to_owned();
    let field = |value: Option<f64>| value.map_or(String::new(), |value| format!("{value:e}"));
    for p in points {
        let _ = writeln!(
            text,
            "\"{}\",\"{}\",{:e},{:e},{:e},{},{}",
            p.problem.replace('"', "\"\""),
            p.contender.name(),
            p.setting,
            p.seconds,
            p.error,
            field(p.energy_drift),
            field(p.momentum_drift)
        );
    }
    text
}

fn json(problems: &[Problem], points: &[Point]) -> String {
    let problems: Vec<_> = problems
        .iter()
        .map(|p| json!({"name": p.name, "about": p.about, "duration": p.duration}))
        .collect();
    let finite = |value: f64| value.is_finite().then_some(value);
    let points: Vec<_> = points
        .iter()
        .map(|p| {
            json!({
                "problem": p.problem,
                "method": p.contender.name(),
                "setting": p.setting,
                "seconds": p.seconds,
                "error": finite(p.error),
                "energy_drift": p.energy_drift,
                "momentum_drift": p.momentum_drift,
            })
        })
        .collect();
    let form = json!({"schema": "polhode-bench/1", "machine": machine(), "problems": problems, "points": points});
    format!("{form:#}\n")
}

fn diagrams(folder: &Path, problems: &[Problem], points: &[Point]) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(chart::said)?;
    for problem in problems {
        let curves: Vec<_> = CONTENDERS
            .iter()
            .map(|&contender| Curve {
                name: contender.name().to_owned(),
                points: front(points, &problem.name, contender),
            })
            .filter(|curve| !curve.points.is_empty())
            .collect();
        let svg = diagram(problem, &curves)?;
        let safe = |c: char| {
            if c.is_alphanumeric() || c == '-' {
                c
            } else {
                '_'
            }
        };
        let name: String = problem.name.chars().take(80).map(safe).collect();
        let path = folder.join(format!("work-precision-{name}.svg"));
        fs::write(path, svg).map_err(chart::said)?;
    }
    Ok(())
}

/// Digits and the logarithm of the time, from rough to fine: of the points that no quicker one is as good as.
fn front(points: &[Point], problem: &str, contender: Contender) -> Vec<(f64, f64)> {
    let of = |p: &&Point| p.problem == problem && p.contender == contender && p.error < 1.0;
    let mut all: Vec<_> = points.iter().filter(of).collect();
    all.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
    let mut best = f64::INFINITY;
    all.retain(|p| {
        let better = p.error < best;
        best = best.min(p.error);
        better
    });
    all.iter()
        .map(|p| (-p.error.max(1e-17).log10(), (p.seconds * 1e6).log10()))
        .collect()
}

fn diagram(problem: &Problem, curves: &[Curve]) -> Result<String, String> {
    let times = curves
        .iter()
        .flat_map(|curve| &curve.points)
        .map(|(_, time)| *time);
    let (low, high) = times.fold((0.0_f64, 1.0_f64), |(low, high), t| {
        (low.min(t), high.max(t))
    });
    let title = format!(
        "{}: {}, {} s",
        problem.name, problem.about, problem.duration
    );
    let x = Scale {
        name: "error (rad, and of ω against its size)",
        range: 0.0..17.0,
        label: &|digits| chart::power_of_ten(-digits),
    };
    let y = Scale {
        name: "time of a run, µs",
        range: low.floor()..high.ceil(),
        label: &|exponent| chart::power_of_ten(*exponent),
    };
    chart::picture((980, 620), |area| {
        let plot = chart::above_note(area, &machine())?;
        chart::curves(&plot, &title, &x, &y, curves)
    })
}
