//! `polhode plot`.

use crate::cli::chart::{self, Area, Curve, Scale};
use crate::cli::run::load;
use crate::cli::{input, output};
use crate::motion::State;
use crate::scene::{Balance, Course, Group, Member, Run, Way, foresee, way};
use anstream::ColorChoice;
use clap::Args;
use polhode::{herpolhode, polhode};
use std::path::PathBuf;

mod polhode;

/// Draws a body of a scene (SVG): ω over time, what drifts, the polhode and the herpolhode
#[derive(Args, Debug)]
#[command(after_help = "\
Example:
  polhode plot handle.toml --out handle.svg
  polhode plot satellites.toml --body tumbling --out tumbling.svg")]
pub(super) struct Options {
    /// A scene (.toml), or - for standard input
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// The body [default: the first]
    #[arg(long, value_name = "NAME")]
    body: Option<String>,
    /// Write to a file instead of the terminal
    #[arg(long, value_name = "PATH")]
    out: Option<PathBuf>,
}

/// Draws, and returns the exit code.
pub(super) fn run(options: &Options, color: ColorChoice) -> u8 {
    let scene = match load(&options.scene, None, color) {
        Ok(scene) => scene,
        Err(code) => return code,
    };
    let named = |group: &&Group| options.body.as_ref().is_none_or(|name| group.name == *name);
    let Some(group) = scene.groups.iter().find(named) else {
        let names: Vec<_> = scene
            .groups
            .iter()
            .map(|group| group.name.as_str())
            .collect();
        let name = input::name(&options.scene);
        eprintln!(
            "error: {name}: no body of that name; there are {}",
            names.join(", ")
        );
        return 2;
    };
    match svg(group, &scene.run) {
        Ok(svg) => output::deliver(&svg, options.out.as_deref(), color),
        Err(error) => {
            let name = input::name(&options.scene);
            eprintln!("error: {name}: body {:?}: {error}", group.name);
            2
        }
    }
}

/// Times at which the motion is drawn.
const TIMES: u32 = 2000;

/// A motion at equal times.
struct Track {
    member: Member,
    rows: Vec<(f64, State<f64>)>,
}

fn track(group: &Group, run: &Run) -> Result<(Track, Way), String> {
    let shared = group.shared_body().map_err(chart::said)?;
    let member = group.member(0, shared.as_ref()).map_err(chart::said)?;
    let way = way(&member, run).map_err(chart::said)?;
    let (way, _) = foresee(&member, way, run.duration, run.tolerance, &|| false)
        .map_err(|_| "the motion stops being finite".to_owned())?;
    let mut course = Course::new(&member, &way).map_err(chart::said)?;
    let rows: Result<Vec<_>, _> = (0..=TIMES)
        .map(|n| {
            let time = run.duration * (f64::from(n) / f64::from(TIMES));
            course.at(time).map(|state| (time, state))
        })
        .collect();
    let rows = rows.map_err(chart::said)?;
    Ok((Track { member, rows }, way))
}

fn svg(group: &Group, run: &Run) -> Result<String, String> {
    let (track, way) = track(group, run)?;
    chart::picture((1280, 940), |area| {
        let (above, below) = area.split_vertically(470);
        let (left, right) = above.split_horizontally(640);
        spins(&left, &format!("{}, {way}", group.name), &track)?;
        drifts(&right, &track)?;
        let (left, right) = below.split_horizontally(640);
        polhode(&left, &track)?;
        herpolhode(&right, &track)
    })
}

/// The least and the largest of some numbers, with a little room on both sides.
fn room(values: impl Iterator<Item = f64>) -> std::ops::Range<f64> {
    let fold = |(low, high): (f64, f64), v: f64| (low.min(v), high.max(v));
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), fold);
    let margin = match 0.05 * (high - low) {
        m if m > 0.0 && m.is_finite() => m,
        _ => low.abs().max(1.0) * 0.1,
    };
    low - margin..high + margin
}

fn number(value: &f64) -> String {
    let rounded = format!("{value:.4}");
    let trimmed = rounded.trim_end_matches('0').trim_end_matches('.');
    match value.abs() {
        v if v >= 1e5 || (v < 1e-3 && v > 0.0) => format!("{value:.1e}"),
        _ => trimmed.to_owned(),
    }
}

fn spins(area: &Area<'_>, title: &str, track: &Track) -> Result<(), String> {
    let curves: Vec<_> = ["ωx", "ωy", "ωz"]
        .iter()
        .enumerate()
        .map(|(k, name)| Curve {
            name: (*name).to_owned(),
            points: track
                .rows
                .iter()
                .map(|(t, s)| (*t, s.angular_velocity[k]))
                .collect(),
        })
        .collect();
    let all = curves
        .iter()
        .flat_map(|curve| curve.points.iter().map(|(_, y)| *y));
    let y = Scale {
        name: "rad/s, body axes",
        range: room(all),
        label: &number,
    };
    chart::curves(area, title, &times(track), &y, &curves)
}

fn times(track: &Track) -> Scale<'static> {
    let end = track.rows.last().map_or(1.0, |(t, _)| *t);
    Scale {
        name: "time, s",
        range: 0.0..end,
        label: &number,
    }
}

/// What is smaller than rounding is drawn there.
const FLOOR: f64 = 1e-17;

fn drifts(area: &Area<'_>, track: &Track) -> Result<(), String> {
    let balance = Balance::new(&track.member);
    // The largest so far: the drift itself is noise on its way there.
    let curve = |name: &str, drift: &dyn Fn(f64, &State<f64>) -> Option<f64>| {
        let mut largest = FLOOR;
        let mut grown = |t: f64, found: f64| {
            largest = largest.max(found);
            (t, largest.log10())
        };
        let points = track.rows.iter().skip(1);
        Curve {
            name: name.to_owned(),
            points: points
                .filter_map(|(t, s)| Some(grown(*t, drift(*t, s)?)))
                .collect(),
        }
    };
    let mut curves = vec![
        curve("energy", &|_, state| balance.energy_drift(state)),
        curve("angular momentum", &|time, state| {
            balance.momentum_drift(time, state)
        }),
    ];
    curves.retain(|curve| !curve.points.is_empty());
    let title = if curves.is_empty() {
        "neither energy nor momentum is conserved"
    } else {
        "largest drift so far of what is conserved"
    };
    let highest = curves.iter().flat_map(|c| c.points.iter().map(|(_, y)| *y));
    let y = Scale {
        name: "relative to its size",
        range: -17.0..highest.fold(-14.0, f64::max).ceil(),
        label: &|exponent| chart::power_of_ten(*exponent),
    };
    chart::curves(area, title, &times(track), &y, &curves)
}
