//! The times of code that another library generates, from a script.

use std::process::Command;

/// Nanoseconds by law and row.
pub(crate) struct Times(Vec<(String, String, f64)>);

impl Times {
    pub(crate) fn get(&self, law: &str, row: &str) -> Option<f64> {
        let found = self.0.iter().find(|(l, r, _)| l == law && r == row);
        found.map(|(_, _, time)| *time)
    }
}

/// The times of a script of this folder, or none and why.
pub(crate) fn times(library: &str, script: &str) -> Times {
    let script = format!("{}/benches/rivals/{script}", env!("CARGO_MANIFEST_DIR"));
    let native = cfg!(target_feature = "avx2");
    let run = Command::new("python3")
        .arg(script)
        .args(native.then_some("--native"))
        .output();
    let text = match run {
        Ok(output) if output.status.success() => {
            String::from_utf8_lossy(&output.stdout).into_owned()
        }
        Ok(output) => {
            let why = String::from_utf8_lossy(&output.stderr).into_owned();
            println!(
                "{library} is left out: {}",
                why.lines().last().unwrap_or("it failed")
            );
            String::new()
        }
        Err(error) => {
            println!("{library} is left out: python3: {error}");
            String::new()
        }
    };
    let row = |line: &str| {
        let mut parts = line.split('\t');
        let (law, row) = (parts.next()?.to_owned(), parts.next()?.to_owned());
        Some((law, row, parts.next()?.parse().ok()?))
    };
    Times(text.lines().filter_map(row).collect())
}
