//! The table of an ensemble.

use crate::bench::{EnsembleTime, ensemble};
use crate::cli::bench::machine;
use crate::cli::output::{TableForm, failed};
use serde_json::json;
use std::fmt::Write;

/// The tops of an ensemble, and the error that is allowed.
const COUNT: usize = 10_000;
const TOLERANCE: f64 = 1e-9;

/// Measures, and returns the table or an exit code.
pub(super) fn table(quick: bool, format: TableForm) -> Result<String, u8> {
    let count = if quick { COUNT / 10 } else { COUNT };
    let found = ensemble(count, TOLERANCE).map_err(|error| failed(&error.to_string()))?;
    Ok(match format {
        TableForm::Text => text(count, &found),
        TableForm::Csv => csv(count, &found),
        TableForm::Json => json(count, &found),
    })
}

fn text(count: usize, found: &[EnsembleTime]) -> String {
    let mut text = format!("{count} heavy tops, 10 s to {TOLERANCE:e}, one after the other\n");
    let (tolerance, error, body) = ("tolerance", "error", "µs a body");
    let _ = writeln!(
        text,
        "  {:<26}{tolerance:>11}{error:>11}{:>9}{body:>11}",
        "", "s"
    );
    for of in found {
        let _ = writeln!(
            text,
            "  {:<26}{:>11}{:>11}{:>9.3}{:>11.1}",
            of.contender.name(),
            format!("{:.1e}", of.setting),
            format!("{:.1e}", of.error),
            of.seconds,
            1e6 * of.seconds / count as f64
        );
    }
    let _ = writeln!(text, "\n{}", machine());
    text
}

fn csv(count: usize, found: &[EnsembleTime]) -> String {
    let mut text = "method,bodies,setting,error,seconds\n".to_owned();
    for of in found {
        let name = of.contender.name();
        let EnsembleTime {
            setting,
            error,
            seconds,
            ..
        } = of;
        let _ = writeln!(text, "\"{name}\",{count},{setting:e},{error:e},{seconds:e}");
    }
    text
}

fn json(count: usize, found: &[EnsembleTime]) -> String {
    let methods: Vec<_> = found
        .iter()
        .map(|of| {
            json!({
                "method": of.contender.name(),
                "setting": of.setting,
                "error": of.error.is_finite().then_some(of.error),
                "seconds": of.seconds,
            })
        })
        .collect();
    let form = json!({"schema": "polhode-ensemble/1", "machine": machine(), "bodies": count, "tolerance": TOLERANCE, "methods": methods});
    format!("{form:#}\n")
}
