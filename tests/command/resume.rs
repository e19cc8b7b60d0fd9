//! A run that goes on from an earlier result, against the same run in one piece.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

fn run(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_polhode"))
        .args(["run", "scene.toml", "--format", "csv"])
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::null())
        .output()
        .expect("the command starts")
}

const BODIES: &str = "[[body]]\nname = 'top, \"a\"'\ninertia = { xx = 0.6, yy = 0.8, zz = 1.0 }\n\
    angular_velocity = [1, -2, { from = 3.0, to = 8.0 }]\ncount = 5\n\
    torque = { kind = 'gravity', weight = 1, arm = [0.1, -0.2, 1] }\n\
    [[body]]\nname = 'free'\ninertia = { xx = 2, yy = 3, zz = 4 }\nangular_velocity = [0.1, 3, 0]\n";

fn scene(folder: &Path, run: &str) {
    let text = format!("{BODIES}[run]\ntolerance = 1e-9\n{run}\n");
    fs::write(folder.join("scene.toml"), text).expect("written");
}

/// The rows of a whole run, and its result when it goes on from the first `n` rows, for several n.
fn check(run_keys: &str, kept: &[usize]) {
    let folder = tempfile::tempdir().expect("a folder");
    scene(folder.path(), run_keys);
    assert!(run(folder.path(), &["--out", "whole.csv"]).status.success());
    let whole = fs::read_to_string(folder.path().join("whole.csv")).expect("a result");
    for &n in kept {
        let part: String = whole.split_inclusive('\n').take(n).collect();
        fs::write(folder.path().join("part.csv"), part).expect("written");
        let output = run(
            folder.path(),
            &["--resume", "part.csv", "--out", "part.csv"],
        );
        assert!(
            output.status.success() && output.stderr.is_empty(),
            "{output:?}"
        );
        let found = fs::read_to_string(folder.path().join("part.csv")).expect("a result");
        assert!(found == whole, "{run_keys}, {n} rows kept");
    }
}

#[test]
fn what_was_stopped_ends_as_a_run_in_one_piece() {
    let trajectory = "duration = 3\noutput_interval = 0.5\noutputs = ['trajectory']";
    check(trajectory, &[1, 2, 5, 8, 9, 20, 36, 37, 43]);
    let fixed = "duration = 3\noutput_interval = 0.45\noutputs = ['trajectory']\nmethod = 'rk4'\nstep = 0.01\nestimate_error = false";
    check(fixed, &[1, 5, 20]);
    check("duration = 3", &[1, 2, 4, 6, 7]);
}

#[test]
fn a_shorter_run_of_several_bodies_goes_on_to_the_longer_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let keys = |duration: f64, outputs: &str| {
        format!("duration = {duration}\noutput_interval = 0.5\noutputs = ['{outputs}']")
    };
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).expect("a result");
    for outputs in ["trajectory", "final"] {
        scene(folder.path(), &keys(2.0, outputs));
        assert!(run(folder.path(), &["--out", "part.csv"]).status.success());
        scene(folder.path(), &keys(4.0, outputs));
        let whole = run(folder.path(), &["--out", "whole.csv"]);
        assert!(whole.status.success());
        // All six bodies, or some, or one of them in part.
        let part = read("part.csv");
        for kept in [31, 16, 6, 4, 2] {
            let first: String = part.split_inclusive('\n').take(kept).collect();
            fs::write(folder.path().join("first.csv"), first).expect("written");
            let output = run(
                folder.path(),
                &["--resume", "first.csv", "--out", "new.csv"],
            );
            assert!(output.status.success(), "{output:?}");
            assert!(read("new.csv") == read("whole.csv"), "{outputs}, {kept}");
        }
        // Of another scene: a name that is none of its own, after bodies that are.
        fs::write(folder.path().join("other.csv"), part + "nobody,2,\n").expect("written");
        let refused = run(
            folder.path(),
            &["--resume", "other.csv", "--out", "none.csv"],
        );
        assert_eq!(refused.status.code(), Some(2));
        assert!(!folder.path().join("none.csv").exists());
    }
}

#[test]
fn a_result_that_disagrees_is_computed_again_and_what_is_none_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    scene(folder.path(), "duration = 3");
    assert!(run(folder.path(), &["--out", "whole.csv"]).status.success());
    let whole = fs::read_to_string(folder.path().join("whole.csv")).expect("a result");
    let mut other = whole.split_inclusive('\n').take(3).collect::<String>();
    let digit = other.len() - 2;
    other.replace_range(digit..=digit, "x");
    fs::write(folder.path().join("other.csv"), other).expect("written");
    let output = run(
        folder.path(),
        &["--resume", "other.csv", "--out", "new.csv"],
    );
    assert!(output.status.success());
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(said.contains("all is computed again"), "{said}");
    let found = fs::read_to_string(folder.path().join("new.csv")).expect("a result");
    assert!(found == whole);
    fs::write(folder.path().join("long.csv"), "x".repeat(100_000)).expect("written");
    for (file, said) in [
        ("none.csv", "none.csv: "),
        ("scene.toml", "line 1 is of no result"),
        ("long.csv", "line 1 is of no result"),
        (".", "is no regular file"),
    ] {
        let output = run(folder.path(), &["--resume", file, "--out", "bad.csv"]);
        assert_eq!(output.status.code(), Some(2));
        assert!(
            String::from_utf8_lossy(&output.stderr).contains(said),
            "{output:?}"
        );
    }
    let text = run(folder.path(), &["--resume", "whole.csv"]);
    assert_eq!(text.status.code(), Some(2));
    assert!(!folder.path().join("bad.csv").exists());
}
