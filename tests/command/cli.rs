//! The command as a user sees it: what it prints, what it writes, how it ends.

use super::start::polhode;
use serde_json::Value;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use tempfile::TempDir;

const GOOD: &str = r"# The moment

With the axes attached to the body, the moment about the mass centre is
$$\Sigma M_x = \dot L_x - L_y\omega_z + L_z\omega_y \tag{1}$$

For principal axes $L_x = I_x\omega_x$.
";

const BAD: &str = r"With the axes attached to the body, the moment about the mass centre is
$$\Sigma M_x = \dot L_x - L_y\omega_z + L_z\omega_y \tag{1}$$
and with a dot lost
$$\Sigma M_x = L_x - L_y\omega_z + L_z\omega_y \tag{2}$$
";

const OPEN: &str = "Here $L_x = \\unknown{x}$ stands.\n";

/// A folder with the documents, to run the command in.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (name, text) in [("good.md", GOOD), ("bad.md", BAD), ("open.md", OPEN)] {
        put(folder.path(), name, text.as_bytes());
    }
    folder
}

fn put(folder: &Path, name: &str, bytes: &[u8]) {
    fs::write(folder.join(name), bytes).expect("a file that can be written");
}

/// Runs the command with a text on its standard input.
fn with_input(arguments: &[&str], input: &[u8]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_polhode"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    let mut pipe = child.stdin.take().expect("a pipe");
    pipe.write_all(input).expect("the command reads");
    drop(pipe);
    child.wait_with_output().expect("the command ends")
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("UTF-8")
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).expect("UTF-8")
}

fn code(output: &Output) -> i32 {
    output.status.code().expect("an exit code, not a signal")
}

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).expect("JSON")
}

#[test]
fn the_exit_code_tells_the_worst_verdict_and_an_unread_file_beats_all() {
    let folder = folder();
    let code_of = |files: &[&str]| code(&polhode(folder.path(), &[&["check"], files].concat()));
    assert_eq!(code_of(&["good.md"]), 0);
    assert_eq!(code_of(&["bad.md"]), 1);
    assert_eq!(code_of(&["open.md"]), 3);
    assert_eq!(code_of(&["good.md", "open.md"]), 3);
    assert_eq!(code_of(&["open.md", "bad.md", "good.md"]), 1);
    assert_eq!(code_of(&["bad.md", "missing.md"]), 2);
    assert_eq!(code_of(&[]), 2, "no file is a usage error");
    assert_eq!(code_of(&["--format", "poem", "good.md"]), 2);
}

#[test]
fn a_file_that_cannot_be_read_leaves_the_others_reported() {
    let folder = folder();
    let output = polhode(folder.path(), &["check", "missing.md", "good.md"]);
    assert_eq!(code(&output), 2);
    assert_eq!(
        stderr(&output),
        "error: missing.md: there is no such file\n"
    );
    assert!(
        stdout(&output).ends_with("good.md: 2 proved\n"),
        "{}",
        stdout(&output)
    );
}

#[test]
fn a_refuted_line_is_drawn_at_its_place_and_the_rest_is_listed() {
    let folder = folder();
    let text = stdout(&polhode(folder.path(), &["check", "bad.md"]));
    assert!(text.starts_with("refuted"), "{text}");
    let drawn = [
        "--> bad.md:4:",
        r"4 | $$\Sigma M_x = L_x - L_y\omega_z + L_z\omega_y \tag{2}$$",
        "= note: left side less right side is `",
        "the left side is ",
        "  line 2  (1)  proved by body-axes, moment, transport",
        "bad.md: 1 proved, 1 refuted",
    ];
    for part in drawn {
        assert!(text.contains(part), "no {part:?} in\n{text}");
    }
}

#[test]
fn verbose_quotes_the_lines_that_hold_and_lists_what_was_none() {
    let folder = folder();
    put(folder.path(), "named.md", b"Let $I$ be the inertia.\n");
    let text = stdout(&polhode(folder.path(), &["check", "--verbose", "good.md"]));
    assert!(
        text.contains("\n    \\Sigma M_x = \\dot L_x - L_y"),
        "{text}"
    );
    let text = stdout(&polhode(folder.path(), &["check", "--verbose", "named.md"]));
    assert!(text.contains("line 1  not a line"), "{text}");
    assert!(text.ends_with("named.md: no line to check\n"), "{text}");
}

#[test]
fn json_has_the_keys_of_the_schema_in_their_order() {
    let folder = folder();
    let output = polhode(folder.path(), &["check", "--format", "json", "bad.md"]);
    let form = json(&output);
    assert_eq!(form["schema"], "polhode-check/1");
    let document = &form["documents"][0];
    assert_eq!(document["path"], "bad.md");
    assert_eq!(document["products"], "integrals");
    let line = &document["lines"][1];
    let keys: Vec<_> = line.as_object().expect("an object").keys().collect();
    let schema = [
        "source_line",
        "source_column",
        "source",
        "label",
        "role",
        "verdict",
        "uses",
        "conditions",
        "residual",
        "counterexample",
        "diagnosis",
        "follows_from",
    ];
    assert_eq!(keys[..schema.len()], schema);
    assert_eq!(line["source_line"], 4);
    assert_eq!(line["label"], "(2)");
    assert_eq!(line["role"], "claim");
    assert_eq!(line["verdict"], "refuted");
    assert_eq!(line["follows_from"], Value::Null);
    assert!(line["counterexample"]["symbols"].is_object());
    assert_ne!(
        line["counterexample"]["left"],
        line["counterexample"]["right"]
    );
    let summary = serde_json::json!(
        {"proved": 1, "accepted": 0, "refuted": 1, "undecided": 0, "unreadable": 0});
    assert_eq!(document["summary"], summary);
}

#[test]
fn json_stays_json_when_a_file_cannot_be_read() {
    let folder = folder();
    let output = polhode(
        folder.path(),
        &["check", "--format", "json", "missing.md", "good.md"],
    );
    let form = json(&output);
    assert_eq!(code(&output), 2);
    assert_eq!(form["documents"].as_array().map(Vec::len), Some(1));
    assert_eq!(form["errors"][0]["path"], "missing.md");
}

#[test]
fn a_notebook_line_is_placed_in_its_cell() {
    let folder = folder();
    let notebook = serde_json::json!({
    "nbformat": 4, "nbformat_minor": 5, "metadata": {},
    "cells": [
        {"cell_type": "code", "metadata": {}, "outputs": [], "source": "1"},
        {"cell_type": "markdown", "metadata": {}, "source": BAD},
    ]});
    put(folder.path(), "work.ipynb", notebook.to_string().as_bytes());
    let output = polhode(folder.path(), &["check", "--format", "json", "work.ipynb"]);
    let line = &json(&output)["documents"][0]["lines"][1];
    assert_eq!(
        (&line["cell"], &line["source_line"]),
        (&1.into(), &4.into())
    );
    let text = stdout(&polhode(folder.path(), &["check", "work.ipynb"]));
    assert!(text.contains("--> work.ipynb, cell 1:4:"), "{text}");
    assert!(text.contains("  cell 1, line 2  (1)  proved"), "{text}");
}

#[test]
fn standard_input_is_a_document_of_the_kind_that_is_said() {
    let output = with_input(&["check", "--format", "json", "-"], GOOD.as_bytes());
    assert_eq!(code(&output), 0);
    assert_eq!(json(&output)["documents"][0]["path"], "<stdin>");
    let tex = "\\begin{equation}\\vec L = I\\vec\\omega\\end{equation}\n";
    let output = with_input(
        &["check", "--as", "tex", "--format", "json", "-"],
        tex.as_bytes(),
    );
    assert_eq!(
        json(&output)["documents"][0]["lines"][0]["verdict"],
        "proved"
    );
}

#[test]
fn colours_come_only_where_they_are_wanted() {
    let folder = folder();
    let plain = polhode(folder.path(), &["check", "bad.md"]);
    assert!(!plain.stdout.contains(&0x1b));
    let coloured = polhode(folder.path(), &["check", "--color", "always", "bad.md"]);
    assert!(coloured.stdout.contains(&0x1b));
}

#[test]
fn a_result_file_is_whole_plain_and_never_an_input() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    put(folder.path(), "report.txt", b"old");
    let arguments = [
        "check",
        "--color",
        "always",
        "--out",
        "report.txt",
        "bad.md",
    ];
    let output = polhode(folder.path(), &arguments);
    assert_eq!((code(&output), stdout(&output).as_str()), (1, ""));
    let text = fs::read_to_string(at("report.txt")).expect("a report");
    assert!(
        text.ends_with("bad.md: 1 proved, 1 refuted\n") && !text.contains('\u{1b}'),
        "{text}"
    );

    let output = polhode(folder.path(), &["check", "--out", "good.md", "good.md"]);
    assert_eq!(code(&output), 2);
    assert_eq!(fs::read_to_string(at("good.md")).expect("untouched"), GOOD);

    let output = polhode(
        folder.path(),
        &["check", "--out", "no/such/folder.txt", "good.md"],
    );
    assert_eq!(code(&output), 2);
    assert!(stderr(&output).starts_with("error: no/such/folder.txt: "));
    let left: Vec<_> = fs::read_dir(folder.path()).expect("readable").collect();
    assert_eq!(left.len(), 4, "nothing half-written is left: {left:?}");
}

#[test]
fn a_reader_that_leaves_early_is_no_panic() {
    let folder = folder();
    put(folder.path(), "long.md", BAD.repeat(40).as_bytes());
    let mut child = Command::new(env!("CARGO_BIN_EXE_polhode"))
        .args(["check", "--format", "json", "long.md"])
        .current_dir(folder.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("the command ends");
    assert_eq!(stderr(&output), "");
    assert_eq!(code(&output), 1);
}

#[test]
fn a_derivation_that_is_printed_can_be_checked() {
    let folder = folder();
    let output = polhode(folder.path(), &["derive", "--out", "derived.md"]);
    assert_eq!((code(&output), stdout(&output).as_str()), (0, ""));
    assert_eq!(code(&polhode(folder.path(), &["check", "derived.md"])), 0);
    let output = polhode(folder.path(), &["derive", "--body", "dumpling"]);
    assert_eq!(code(&output), 2);
    assert!(
        stderr(&output).contains("one-plane"),
        "the values are listed"
    );
}

#[test]
fn help_gives_an_example() {
    let folder = folder();
    let output = polhode(folder.path(), &["check", "--help"]);
    assert_eq!(code(&output), 0);
    assert!(stdout(&output).contains("polhode check notes.md"));
}
