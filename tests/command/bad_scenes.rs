//! Scenes that can't be run and places that can't be written, as a user meets them: an error with its place, exit code 2,
//! and nothing half-written.

use super::start::polhode;
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

fn said(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).expect("UTF-8")
}

/// The file names in a folder, sorted.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("readable");
    let mut names: Vec<_> = entries
        .map(|entry| {
            let name = entry.expect("an entry").file_name();
            name.into_string().expect("UTF-8")
        })
        .collect();
    names.sort();
    names
}

const BODY: &str = "[[body]]\nname = 'a'\ninertia = { xx = 2, yy = 3, zz = 4 }\n\
                    angular_velocity = [1, 3, 0.2]\n";

/// A scene, the line and column of what is wrong with it, and what is said of it.
const BAD: &[(&str, &str, &str)] = &[
    ("", "1:1", "no body"),
    ("[run]\nduration = 1\n", "1:1", "no body"),
    ("B B [run]\nduration = 1\n", "6:8", "duplicate-name"),
    (
        "[[body]]\nname = 'a'\ninertia = { xx = 1, yy = 1, zz = 3 }\nangular_velocity = [1, 0, 0]\n[run]\nduration = 1\n",
        "3:11",
        "impossible-inertia",
    ),
    ("B [run]\nduration = -1\n", "6:12", "has to be positive"),
    (
        "B [run]\nduration = 1\ntolerance = 1e-17\n",
        "7:13",
        "below what doubles can hold",
    ),
    (
        "B torque = { kind = 'constant', value = [nan, 0, 0] }\n[run]\nduration = 1\n",
        "5:40",
        "has to be finite",
    ),
    (
        "B [run]\nduration = 1\noutputs = ['finla']\n",
        "7:12",
        "write `final`",
    ),
    (
        "B count = 1000000000\n[run]\nduration = 1\n",
        "5:9",
        "too-many-bodies",
    ),
];

#[test]
fn a_bad_scene_is_refused_at_its_place_by_each_command_that_reads_it() {
    for (scene, place, reason) in BAD {
        let folder = tempfile::tempdir().expect("a folder");
        let scene = scene.replace("B ", BODY);
        fs::write(folder.path().join("scene.toml"), &scene).expect("written");
        for command in ["run", "explain", "plot"] {
            let output = polhode(folder.path(), &[command, "scene.toml", "--out", "result"]);
            let said = said(&output);
            assert_eq!(output.status.code(), Some(2), "{command}: {scene}\n{said}");
            assert!(
                said.contains(&format!("scene.toml:{place}")) && said.contains(reason),
                "{command}: {scene}\nwanted {reason:?} at {place}, got\n{said}"
            );
            assert!(output.stdout.is_empty());
            assert_eq!(names(folder.path()), ["scene.toml"], "{command}: {scene}");
        }
    }
}

#[test]
fn a_motion_that_runs_away_leaves_no_half_result() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = format!(
        "{BODY}{}torque = {{ kind = 'constant', value = [1e308, 0, 1e308] }}\n[run]\nduration = 1e9\n",
        BODY.replace("'a'", "'wild'")
    );
    fs::write(folder.path().join("scene.toml"), scene).expect("written");
    let output = polhode(folder.path(), &["run", "scene.toml", "--out", "result"]);
    let said = said(&output);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("scene.toml: body \"wild\""), "{said}");
    assert_eq!(names(folder.path()), ["scene.toml"]);
}

/// A folder with a scene of many rows.
fn long(duration: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = format!(
        "{BODY}[run]\nduration = {duration}\noutput_interval = 0.001\noutputs = ['trajectory']\n"
    );
    fs::write(folder.path().join("scene.toml"), scene).expect("written");
    folder
}

#[test]
fn a_place_that_can_not_be_written_is_named() {
    let folder = long("1");
    fs::create_dir(folder.path().join("taken")).expect("a folder");
    for out in ["nowhere/result", "taken", "scene.toml/result"] {
        for command in ["run", "explain", "plot"] {
            let output = polhode(folder.path(), &[command, "scene.toml", "--out", out]);
            let said = said(&output);
            assert_eq!(output.status.code(), Some(2), "{command} {out}: {said}");
            assert!(said.starts_with(&format!("error: {out}: ")), "{said}");
            assert_eq!(names(folder.path()), ["scene.toml", "taken"]);
        }
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error() {
    let folder = long("10");
    for form in ["text", "json", "csv"] {
        let arguments = ["run", "scene.toml", "--format", form, "--out", "/dev/full"];
        let output = polhode(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(2), "{form}");
        let said = said(&output);
        assert!(
            said.starts_with("error: /dev/full: No space left"),
            "{said}"
        );
        let full = fs::File::create("/dev/full").expect("a full device");
        let piped = Command::new(env!("CARGO_BIN_EXE_polhode"))
            .args(["run", "scene.toml", "--format", form])
            .current_dir(folder.path())
            .stdout(full)
            .output()
            .expect("the command starts");
        assert_eq!(piped.status.code(), Some(2), "{form}");
        assert!(String::from_utf8_lossy(&piped.stderr).contains("No space left"));
    }
    assert_eq!(names(folder.path()), ["scene.toml"]);
}

#[cfg(unix)]
#[test]
fn control_c_leaves_whole_rows_up_to_the_time_said() {
    // Nobody waits for 1e9 rows.
    let folder = long("1e6");
    fs::write(folder.path().join("result.csv"), "of old\n").expect("written");
    let child = Command::new(env!("CARGO_BIN_EXE_polhode"))
        .args([
            "run",
            "scene.toml",
            "--format",
            "csv",
            "--out",
            "result.csv",
        ])
        .current_dir(folder.path())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    // Some rows are on the disk, so it is well under way and listens.
    let begun = || {
        let entries = fs::read_dir(folder.path()).expect("readable");
        entries.flatten().any(|entry| {
            let grown = entry.metadata().is_ok_and(|data| data.len() > 100_000);
            grown && entry.file_name() != "result.csv"
        })
    };
    while !begun() {
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    let old = fs::read_to_string(folder.path().join("result.csv")).expect("a result");
    assert_eq!(
        old, "of old\n",
        "the old result stands until the new one is complete"
    );
    let kill = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(kill.expect("kill is there").success());
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(130));
    let text = fs::read_to_string(folder.path().join("result.csv")).expect("a result");
    assert!(text.ends_with('\n') && text.lines().all(|line| line.split(',').count() == 10));
    let last = text.lines().last().and_then(|line| line.split(',').nth(1));
    let said = said(&output);
    let until = format!("complete up to t = {} s of \"a\"", last.expect("a time"));
    assert!(said.contains(&until), "{said}");
    assert_eq!(names(folder.path()), ["result.csv", "scene.toml"]);
}
