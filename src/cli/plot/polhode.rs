//! The path of ω in the body, and the one in space.

use crate::cli::chart::{Area, Curve, Scale, colour, curves, said};
use crate::cli::plot::{Track, number, room};
use crate::mechanics::angular_momentum;
use nalgebra::{Matrix3, Vector3};
use plotters::prelude::Text;
use plotters::prelude::{ChartBuilder, LineSeries, RGBColor};
use plotters::style::{Color, IntoFont};

/// Lines of the ellipsoid's net, each way, and points of a line.
const NET: u32 = 8;
const FINE: u32 = 72;

/// The polhode: ω(t) on the ellipsoid ω·Iω = 2T of its first moment, seen from the first octant of the principal axes.
pub(super) fn polhode(area: &Area<'_>, track: &Track) -> Result<(), String> {
    let body = &track.member.body;
    let seen: Vec<_> = track
        .rows
        .iter()
        .map(|(_, state)| body.axes().tr_mul(&state.angular_velocity))
        .collect();
    let first = seen.first().copied().unwrap_or_else(Vector3::zeros);
    let twice_energy = first.dot(&body.moments().component_mul(&first));
    let semi_axes = body.moments().map(|moment| (twice_energy / moment).sqrt());
    let ellipsoid = track.member.torque == crate::motion::Torque::None && twice_energy > 0.0;
    let reach = seen.iter().map(|w| w.norm()).fold(0.0, f64::max);
    let reach = if ellipsoid {
        reach.max(semi_axes.amax())
    } else {
        reach.max(1e-300)
    };
    let view = view();
    let flat = |v: &Vector3<f64>| {
        let p = view * v / reach;
        (p.x, p.y)
    };
    let mut chart = ChartBuilder::on(area)
        .margin(10)
        .caption("polhode: ω in the body, principal axes", ("sans-serif", 17))
        .build_cartesian_2d(-1.35..1.35, -1.0..1.0)
        .map_err(said)?;
    let grey = RGBColor(200, 200, 200);
    if ellipsoid {
        for line in net(&semi_axes) {
            let points = line.iter().map(flat);
            chart
                .draw_series(LineSeries::new(points, grey.stroke_width(1)))
                .map_err(said)?;
        }
    }
    for k in 0..3 {
        let axis = Vector3::from_fn(|r, _| if r == k { 1.1 * reach } else { 0.0 });
        let ends = [Vector3::zeros(), axis];
        let line = LineSeries::new(ends.iter().map(flat), colour(7).stroke_width(1));
        chart.draw_series(line).map_err(said)?;
        let name = Text::new(
            format!("ω{}", k + 1),
            flat(&(axis * 1.03)),
            ("sans-serif", 14).into_font(),
        );
        chart.draw_series([name]).map_err(said)?;
    }
    // What lies behind is thin.
    for (front, width, ink) in [(false, 1, 6), (true, 2, 2)] {
        for run in runs(&seen, |w| ((view * w).z >= 0.0) == front) {
            let line = LineSeries::new(run.iter().map(flat), colour(ink).stroke_width(width));
            chart.draw_series(line).map_err(said)?;
        }
    }
    Ok(())
}

/// The runs of neighbouring points that satisfy a condition.
fn runs(points: &[Vector3<f64>], holds: impl Fn(&Vector3<f64>) -> bool) -> Vec<&[Vector3<f64>]> {
    points
        .chunk_by(|a, b| holds(a) == holds(b))
        .filter(|run| run.first().is_some_and(&holds))
        .collect()
}

/// From the side and above: screen x, screen y, towards the eye.
fn view() -> Matrix3<f64> {
    let (turn, tilt) = (-0.6_f64, 0.45_f64);
    let (s, c) = turn.sin_cos();
    let (p, q) = tilt.sin_cos();
    Matrix3::new(-s, c, 0.0, -p * c, -p * s, q, q * c, q * s, p)
}

/// Circles of latitude and longitude of an ellipsoid.
fn net(semi_axes: &Vector3<f64>) -> Vec<Vec<Vector3<f64>>> {
    let turn = |n: u32, of: u32| std::f64::consts::TAU * f64::from(n) / f64::from(of);
    let point = |polar: f64, around: f64| {
        Vector3::new(
            polar.sin() * around.cos(),
            polar.sin() * around.sin(),
            polar.cos(),
        )
        .component_mul(semi_axes)
    };
    let latitudes = (1..NET).map(|n| {
        let polar = 0.5 * turn(n, NET);
        (0..=FINE).map(|m| point(polar, turn(m, FINE))).collect()
    });
    let longitudes = (0..NET).map(|n| {
        let around = 0.5 * turn(n, NET);
        (0..=FINE).map(|m| point(turn(m, FINE), around)).collect()
    });
    latitudes.chain(longitudes).collect()
}

/// The herpolhode: ω in space, seen along the angular momentum at the start.
pub(super) fn herpolhode(area: &Area<'_>, track: &Track) -> Result<(), String> {
    let Some((_, start)) = track.rows.first() else {
        return Ok(());
    };
    let momentum = angular_momentum(track.member.body.inertia(), &start.angular_velocity);
    let [right, up] = across(&start.attitude.to_space(&momentum));
    let points: Vec<_> = track
        .rows
        .iter()
        .map(|(_, state)| {
            let omega = state.attitude.to_space(&state.angular_velocity);
            (right.dot(&omega), up.dot(&omega))
        })
        .collect();
    // The same scale both ways.
    let (x, y) = (
        room(points.iter().map(|p| p.0)),
        room(points.iter().map(|p| p.1)),
    );
    let half = 0.5 * (x.end - x.start).max(y.end - y.start);
    let around = |range: std::ops::Range<f64>, part: f64| {
        let middle = 0.5 * (range.start + range.end);
        middle - part * half..middle + part * half
    };
    let scale = |name, range| Scale {
        name,
        range,
        label: &number,
    };
    let curve = Curve {
        name: "ω in space".to_owned(),
        points,
    };
    let (x, y) = (
        scale("rad/s", around(x, 1.0)),
        scale("rad/s", around(y, 1.0)),
    );
    curves(
        area,
        "herpolhode: ω in space, seen along L",
        &x,
        &y,
        &[curve],
    )
}

/// Two directions across a vector; across z where it has none.
fn across(vector: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let along = vector.try_normalize(0.0).unwrap_or_else(Vector3::z);
    let least = along.iamin();
    let helper = Vector3::from_fn(|r, _| if r == least { 1.0 } else { 0.0 });
    let right = helper.cross(&along).normalize();
    [right, along.cross(&right)]
}
