//! `[run]`.

use crate::diagnostic::Diagnostic;
use crate::scene::read::reader::{Bound, Reader, Table, Value, span};
use crate::scene::{Costs, Method, Outputs, Run, Wrt};

pub(super) const KEYS: &[&str] = &[
    "duration",
    "tolerance",
    "method",
    "step",
    "outputs",
    "wrt",
    "output_interval",
    "estimate_error",
];

/// Tolerances that mean something: above rounding, and below a tenth of a radian.
const TOLERANCES: std::ops::RangeInclusive<f64> = 1e-15..=0.1;
/// Rows of a trajectory, and steps of fixed length.
const MOST_ROWS: f64 = 1e9;
const MOST_STEPS: f64 = 4e9;

pub(super) fn run(reader: &mut Reader, table: &Table<'_>) -> Option<Run> {
    let duration = reader.required(table, "duration");
    let duration = duration.and_then(|v| reader.number(v, "the duration", Bound::Positive));
    let tolerance = match table.get("tolerance") {
        Some(value) => tolerance(reader, value),
        None => Some(1e-10),
    };
    let outputs = match table.get("outputs") {
        Some(value) => outputs(reader, value),
        None => Some(Outputs {
            last: true,
            ..Outputs::NONE
        }),
    };
    let wrt = wrt(reader, table, outputs);
    let method = method(reader, table);
    let step = step(reader, table, method, duration);
    let output_interval = match table.get("output_interval") {
        Some(value) => interval(reader, value, duration),
        None => duration.map(|duration| duration / 100.0),
    };
    let estimate_error = match table.get("estimate_error") {
        Some(value) => reader.flag(value, "estimate_error"),
        None => Some(true),
    };
    Some(Run {
        duration: duration?,
        tolerance: tolerance?,
        method: method?,
        step: step?,
        outputs: outputs?,
        wrt: wrt?,
        output_interval: output_interval?,
        estimate_error: estimate_error?,
        costs: Costs::default(),
    })
}

fn tolerance(reader: &mut Reader, value: &Value<'_>) -> Option<f64> {
    let tolerance = reader.number(value, "the tolerance", Bound::Positive)?;
    if TOLERANCES.contains(&tolerance) {
        return Some(tolerance);
    }
    let (least, most) = (TOLERANCES.start(), TOLERANCES.end());
    let message = if tolerance < *least {
        format!("the tolerance {tolerance:e} is below what doubles can hold")
    } else {
        format!("the tolerance {tolerance:e} is too large to mean anything")
    };
    let outside = Diagnostic::error("bad-value", span(value.span()), message);
    reader.report(outside.help(format!("take one between {least:e} and {most}")));
    None
}

fn interval(reader: &mut Reader, value: &Value<'_>, duration: Option<f64>) -> Option<f64> {
    let interval = reader.number(value, "the output interval", Bound::Positive)?;
    let rows = duration? / interval;
    if rows > MOST_ROWS {
        return reader.wrong(
            value,
            format!(
                "the trajectory would have {rows:.1e} rows, and at most {MOST_ROWS:.0e} are written"
            ),
        );
    }
    Some(interval)
}

fn method(reader: &mut Reader, table: &Table<'_>) -> Option<Method> {
    match table.get("method") {
        Some(value) => reader.word(value, "method", &Method::NAMES),
        None => Some(Method::Auto),
    }
}

/// The step, which a method of fixed step needs and no other takes.
fn step(
    reader: &mut Reader,
    table: &Table<'_>,
    method: Option<Method>,
    duration: Option<f64>,
) -> Option<Option<f64>> {
    let fixed = method? == Method::Rk4;
    let Some(value) = table.get("step") else {
        if fixed {
            reader.required(table, "step")?;
        }
        return Some(None);
    };
    let step = reader.number(value, "the step", Bound::Positive)?;
    if !fixed {
        return reader.wrong(value, "a step is for a method of fixed step, such as `rk4`");
    }
    let steps = duration? / step;
    if steps > MOST_STEPS {
        return reader.wrong(
            value,
            format!("the run would take {steps:.1e} steps, and at most {MOST_STEPS:.0e} are taken"),
        );
    }
    Some(Some(step))
}

fn outputs(reader: &mut Reader, value: &Value<'_>) -> Option<Outputs> {
    let words = [
        ("final", 0),
        ("trajectory", 1),
        ("energy", 2),
        ("momentum", 3),
        ("jacobian", 4),
    ];
    let found = words_of(reader, value, "output", &words)?;
    if found.is_empty() {
        return reader.wrong(value, "no output is asked for");
    }
    Some(Outputs {
        last: found.contains(&0),
        trajectory: found.contains(&1),
        energy: found.contains(&2),
        momentum: found.contains(&3),
        jacobian: found.contains(&4),
    })
}

fn wrt(reader: &mut Reader, table: &Table<'_>, outputs: Option<Outputs>) -> Option<Wrt> {
    let asked = outputs?.jacobian;
    let Some(value) = table.get("wrt") else {
        return Some(if asked { Wrt::ALL } else { Wrt::NONE });
    };
    let words = [
        ("attitude", 0),
        ("angular_velocity", 1),
        ("torque", 2),
        ("inertia", 3),
        ("dt", 4),
    ];
    let found = words_of(reader, value, "block of the Jacobian", &words)?;
    // Harmless where no Jacobian is asked for: a scene is often switched between the two.
    Some(Wrt {
        attitude: asked && found.contains(&0),
        angular_velocity: asked && found.contains(&1),
        torque: asked && found.contains(&2),
        inertia: asked && found.contains(&3),
        dt: asked && found.contains(&4),
    })
}

fn words_of(
    reader: &mut Reader,
    value: &Value<'_>,
    what: &str,
    words: &[(&str, usize)],
) -> Option<Vec<usize>> {
    let list = reader.list(value, what)?;
    let found: Vec<_> = list
        .iter()
        .map(|value| reader.word(value, what, words))
        .collect();
    found.into_iter().collect()
}
