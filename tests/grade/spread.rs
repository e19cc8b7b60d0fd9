//! The example that spreads a class over a cluster, where Python has what it needs.

use super::command::{class, grade, results};
use std::fs;
use std::process::Command;

#[test]
fn a_class_spread_over_dask_is_the_same_class() {
    let python = std::env::var("POLHODE_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let has_dask = Command::new(&python)
        .args(["-c", "import dask.distributed"])
        .output()
        .is_ok_and(|output| output.status.success());
    if !has_dask {
        println!("{python} has no dask.distributed; nothing was tried");
        return;
    }
    let texts = ["ada.md", "ben.md", "cy.md"]
        .map(|name| fs::read(format!("examples/grading/submissions/{name}")).expect("the example"));
    let names: Vec<String> = (0..12).map(|n| format!("s{n:02}.md")).collect();
    let each = names.iter().zip(texts.iter().cycle());
    let files: Vec<(&str, &[u8])> = each
        .map(|(name, text)| (name.as_str(), text.as_slice()))
        .collect();
    let (whole, spread) = (class(&files), class(&files));
    assert_eq!(grade(whole.path(), &[]).0, 0);
    let path = |name: &str| spread.path().join(name);
    let output = Command::new(&python)
        .arg("examples/grading/spread.py")
        .args([path("key.md"), path("work"), path("out")])
        .args(["--parts", "3", "--polhode", env!("CARGO_BIN_EXE_polhode")])
        .output()
        .expect("Python runs");
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    assert_eq!(results(spread.path()), results(whole.path()));
}
