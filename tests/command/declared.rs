//! Documents whose meaning is declared in sentences: where the sentences come from, and what is said of the lines.

use super::start::polhode;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use tempfile::TempDir;

/// What the rotor is, one sentence a line.
const RING: [&str; 13] = [
    "N is an inertial frame.",
    "B is a frame fixed in the rotor.",
    "The rotor is a rigid body.",
    "x, y, z are the axes of B.",
    "G is the mass centre of the rotor.",
    "The axes of B are principal axes of the rotor.",
    r"$\omega_x$, $\omega_y$, $\omega_z$ are the components of $\vec\omega$ on B.",
    r"$\vec\omega$ is the angular velocity of the rotor relative to N.",
    r"$\vec N$ is the total moment on the rotor about G.",
    r"$N_x$, $N_y$, $N_z$ are the components of $\vec N$ on B.",
    r"$P$, $Q$, $R$ are the principal moments of the rotor about G on B.",
    r"$E$ is the kinetic energy of rotation of the rotor relative to N.",
    r"$z$ is any vector.",
];

/// What is written of it: two lines that hold, one that fails, one of a letter of which nothing is told.
const LINES: &str = r"# A ring

On its principal axes
$$N_x = P\dot\omega_x + (R - Q)\omega_y\omega_z \tag{1}$$
so that the power is
$$\dot E = N_x\omega_x + N_y\omega_y + N_z\omega_z \tag{2}$$
With a wrong sign it becomes
$$N_x = P\dot\omega_x + (R + Q)\omega_y\omega_z \tag{3}$$
and hence
$$\eta\zeta = N_x\zeta \tag{4}$$
";

const VERDICTS: [&str; 4] = ["proved", "proved", "refuted", "undecided"];

fn front_matter(sentences: &[&str]) -> String {
    let items: String = sentences.iter().map(|s| format!("- {s}\n")).collect();
    format!("---\ntitle: A ring\npolhode:\n{items}---\n")
}

fn latex() -> String {
    let (top, rest) = RING.split_at(6);
    let comments = |sentences: &[&str]| -> String {
        sentences
            .iter()
            .map(|s| format!("% polhode: {s}\n"))
            .collect()
    };
    let body = LINES.replacen("# A ring", r"\section{A ring}", 1);
    let (top, rest) = (comments(top), comments(rest));
    format!(
        "{top}% polhode: products: entries\n\\begin{{document}}\n{rest}{body}\\end{{document}}\n"
    )
}

fn notebook() -> String {
    let cell = |kind: &str, source: &str| serde_json::json!({"cell_type": kind, "metadata": {}, "source": source});
    let cells = [
        cell("code", "import math"),
        cell("markdown", &format!("{}\nWords.", front_matter(&RING))),
        cell("markdown", LINES),
    ];
    serde_json::json!({"cells": cells, "metadata": {}, "nbformat": 4, "nbformat_minor": 5})
        .to_string()
}

fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (name, text) in files {
        fs::write(folder.path().join(name), text).expect("a file that can be written");
    }
    folder
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

/// The document of the JSON report that a command gives.
fn document(folder: &Path, arguments: &[&str]) -> Value {
    let output = polhode(
        folder,
        &[&["check", "--format", "json"], arguments].concat(),
    );
    let report: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    report["documents"][0].clone()
}

fn verdicts(document: &Value) -> Vec<String> {
    let lines = document["lines"].as_array().expect("lines");
    lines
        .iter()
        .map(|line| line["verdict"].as_str().unwrap_or("").to_owned())
        .collect()
}

fn complained(folder: &Path, arguments: &[&str], code: i32) -> (String, Value) {
    let output: Output = polhode(folder, &[&["check"], arguments].concat());
    assert_eq!(output.status.code(), Some(code));
    let with_json = polhode(
        folder,
        &[&["check", "--format", "json"], arguments].concat(),
    );
    let report: Value = serde_json::from_slice(&with_json.stdout).expect("JSON");
    (text(&output.stderr), report["errors"][0].clone())
}

#[test]
fn sentences_come_from_front_matter_comments_notebooks_and_files() {
    let with_front_matter = format!("{}{LINES}", front_matter(&RING));
    let sheet = RING.map(|s| format!("{s}\n")).concat();
    let (latex, notebook) = (latex(), notebook());
    let folder = folder(&[
        ("ring.md", &with_front_matter),
        ("ring.tex", &latex),
        ("ring.ipynb", &notebook),
        ("bare.md", LINES),
        ("ring.declare", &sheet),
        ("half.md", &format!("{}{LINES}", front_matter(&RING[..5]))),
        ("rest.declare", &RING[5..].map_to_lines()),
    ]);
    for arguments in [
        &["ring.md"][..],
        &["ring.tex"],
        &["ring.ipynb"],
        &["bare.md", "--declare", "ring.declare"],
        &["half.md", "--declare", "rest.declare"],
    ] {
        let document = document(folder.path(), arguments);
        assert_eq!(verdicts(&document), VERDICTS, "{arguments:?}");
    }
}

trait Lines {
    fn map_to_lines(&self) -> String;
}

impl Lines for [&str] {
    fn map_to_lines(&self) -> String {
        self.iter().map(|s| format!("{s}\n")).collect()
    }
}

#[test]
fn a_false_line_comes_with_numbers_in_the_letters_of_its_author() {
    let folder = folder(&[("ring.md", &format!("{}{LINES}", front_matter(&RING)))]);
    let document = document(folder.path(), &["ring.md"]);
    let line = &document["lines"][2];
    assert_eq!(
        (&line["label"], &line["reason"]),
        (&"(3)".into(), &"the sides differ".into())
    );
    let numbers = &line["counterexample"];
    let symbols = numbers["symbols"].as_object().expect("symbols");
    let at = |name: &str| -> i64 {
        let value = symbols.get(name).and_then(Value::as_str);
        value
            .and_then(|v| v.parse().ok())
            .unwrap_or_else(|| panic!("{name} in {symbols:?}"))
    };
    let right =
        at("P") * at(r"\dot{\omega}_x") + (at("R") + at("Q")) * at(r"\omega_y") * at(r"\omega_z");
    assert_eq!(numbers["right"], right.to_string());
    assert_eq!(numbers["left"], at("N_x").to_string());
    let residual = line["residual"].as_str().expect("a residual");
    assert!(residual.contains(r"Q \omega_y \omega_z"), "{residual}");
}

#[test]
fn what_is_not_told_is_asked() {
    let folder = folder(&[("ring.md", &format!("{}{LINES}", front_matter(&RING)))]);
    let document = document(folder.path(), &["ring.md"]);
    let question = &document["questions"][0];
    assert_eq!(question["text"], r"what is `\eta`?");
    let line = document["lines"][3]["source_line"].clone();
    assert_eq!(
        (&question["source_line"], &question["lines"]),
        (&line, &Value::from(vec![line.clone()]))
    );
    let shown = text(&polhode(folder.path(), &["check", "ring.md"]).stdout);
    assert!(
        shown.contains(r"question: what is `\eta`? 1 line waits for it"),
        "{shown}"
    );
}

#[test]
fn a_sentence_that_is_not_understood_is_an_error_at_its_word() {
    let wrong = ["N is an inertial frame.", "`$s$` is the spinn of B."];
    let folder = folder(&[
        ("ring.md", &format!("{}{LINES}", front_matter(&wrong))),
        ("ring.tex", "% polhode: prodcuts: entries\n$a = b$\n"),
        ("bare.md", LINES),
        ("wrong.declare", "# a remark\n- N is an inertial framme.\n"),
    ]);
    let (shown, error) = complained(folder.path(), &["ring.md"], 3);
    assert!(
        shown.contains("ring.md:5:16") && shown.contains("`spinn`"),
        "{shown}"
    );
    assert_eq!(
        (&error["source_line"], &error["source_column"]),
        (&5.into(), &16.into())
    );
    let (shown, _) = complained(folder.path(), &["ring.tex"], 3);
    assert!(
        shown.contains("ring.tex:1:12") && shown.contains("the settings are"),
        "{shown}"
    );
    let (shown, error) = complained(folder.path(), &["bare.md", "--declare", "wrong.declare"], 3);
    assert!(
        shown.contains("wrong.declare:2:20") && shown.contains("did you mean `frame`?"),
        "{shown}"
    );
    assert_eq!(
        (&error["path"], &error["help"]),
        (&"wrong.declare".into(), &"did you mean `frame`?".into())
    );
    let (shown, _) = complained(
        folder.path(),
        &["bare.md", "--declare", "nowhere.declare"],
        2,
    );
    assert!(shown.contains("there is no such file"), "{shown}");
}

#[test]
fn beside_a_sentence_that_is_not_understood_lines_are_proved_and_none_is_refuted() {
    let of_letter = RING.map(|s| s.replace("is the kinetic", "is the grand kinetic"));
    let of_thing = RING.map(|s| s.replace("G is the mass centre", "G is the grand mass centre"));
    let named = |sentences: &[String; 13]| sentences.each_ref().map(|s| s.as_str()).map_to_lines();
    let folder = folder(&[
        ("bare.md", LINES),
        ("letter.declare", &named(&of_letter)),
        ("thing.declare", &named(&of_thing)),
    ]);
    let told = |sheet| verdicts(&document(folder.path(), &["bare.md", "--declare", sheet]));
    // Of the energy nothing is known, and what is denied may hold by what was not understood.
    assert_eq!(
        told("letter.declare"),
        ["proved", "undecided", "undecided", "undecided"]
    );
    // What is said of a point may change the meaning of every letter.
    assert_eq!(told("thing.declare"), ["undecided"; 4]);
}

#[test]
fn a_sentence_of_which_nothing_is_made_is_a_warning() {
    let mut sentences = RING.to_vec();
    sentences.push("A tilde means the dot product.");
    let folder = folder(&[
        ("ring.md", &format!("{}{LINES}", front_matter(&sentences))),
        ("bare.md", LINES),
        ("ring.declare", &sentences.map_to_lines()),
    ]);
    let output = polhode(folder.path(), &["check", "ring.md"]);
    let said = r#"nothing was made of the sentence "A tilde means the dot product""#;
    let shown = text(&output.stdout);
    assert!(
        shown.contains(said) && shown.contains("ring.md:17:3"),
        "{shown}"
    );
    let output = polhode(
        folder.path(),
        &["check", "bare.md", "--declare", "ring.declare"],
    );
    assert!(text(&output.stderr).contains(said));
    assert!(text(&output.stderr).contains("ring.declare:14:1"));
}

#[test]
fn a_sentence_of_which_nothing_is_made_says_what_it_waits_for() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the box.
$e_1, e_2, e_3$ are the axes of B.
G is the mass centre of the box.
$\\eta$ is the scalar part of $q$.
$q$ takes components on the axes of D to components on B, scalar first.
$\\zeta$ is the scalar part of $p$.
";
    let folder = folder(&[("a.md", "$$ a=b $$\n"), ("a.declare", sentences)]);
    let output = polhode(folder.path(), &["check", "a.md", "--declare", "a.declare"]);
    let shown = text(&output.stderr);
    for said in [
        "no sentence says what `p` is",
        "it waits for another sentence of which nothing was made: \"$q$ takes components",
    ] {
        assert!(shown.contains(said), "{said}\n{shown}");
    }
}

#[test]
fn what_meaning_prints_gives_the_same_verdicts() {
    let folder = folder(&[
        ("ring.md", &format!("{}{LINES}", front_matter(&RING))),
        ("bare.md", LINES),
    ]);
    let output = polhode(folder.path(), &["check", "--meaning", "ring.md"]);
    assert_eq!(output.status.code(), Some(0));
    let meaning = text(&output.stdout);
    assert!(
        meaning.starts_with("polhode:\n- N is an inertial frame.  # line 4\n"),
        "{meaning}"
    );
    fs::write(folder.path().join("again.declare"), &meaning).expect("written");
    fs::write(
        folder.path().join("again.md"),
        format!("---\n{meaning}---\n{LINES}"),
    )
    .expect("written");
    for arguments in [
        &["again.md"][..],
        &["bare.md", "--declare", "again.declare"],
    ] {
        assert_eq!(
            verdicts(&document(folder.path(), arguments)),
            VERDICTS,
            "{arguments:?}"
        );
    }
    let again = polhode(folder.path(), &["check", "--meaning", "again.md"]);
    let without_places = |text: &str| -> Vec<String> {
        text.lines()
            .map(|line| line.split("  #").next().unwrap_or("").to_owned())
            .collect()
    };
    assert_eq!(
        without_places(&text(&again.stdout)),
        without_places(&meaning)
    );
    let bare = polhode(folder.path(), &["check", "--meaning", "bare.md"]);
    assert!(text(&bare.stdout).contains("# nothing is declared"));
}

#[test]
fn settings_say_their_sentence_and_lists_may_be_quoted() {
    let list = "---\npolhode: [\"N is an inertial frame.\", 'B is a frame fixed in the rotor.']\nproducts: entries\n---\n$a = b$\n";
    let folder = folder(&[
        ("list.md", list),
        ("old.md", "---\nproducts: entries\n---\n$a = b$\n"),
    ]);
    let said = document(folder.path(), &["list.md"]);
    let sources: Vec<&str> = said["meaning"]
        .as_array()
        .expect("sentences")
        .iter()
        .filter_map(|meant| meant["source"].as_str())
        .collect();
    assert_eq!(sources, ["line 2", "line 2", "front matter"]);
    assert_eq!(
        (&said["products"], &said["products_decided_by"]),
        (&"entries".into(), &"declared".into())
    );
    let old = document(folder.path(), &["old.md"]);
    assert_eq!(
        (&old["meaning"], &old["products_decided_by"]),
        (&Value::Array(vec![]), &"front matter".into())
    );
}

#[test]
fn certificates_of_declared_documents_hold_in_python() {
    let folder = folder(&[
        ("ring.md", &format!("{}{LINES}", front_matter(&RING))),
        ("ring.ipynb", &notebook()),
    ]);
    polhode(
        folder.path(),
        &["check", "--certificate", "proofs", "ring.md", "ring.ipynb"],
    );
    let written = fs::read_to_string(folder.path().join("proofs/ring.ipynb/cell-2-line-0004.txt"));
    assert!(
        written
            .expect("a certificate")
            .contains("\ncell 2\nline 4\n")
    );
    let script = folder.path().join("proofs/ring.md/recheck.py");
    let Ok(output) = Command::new("python3").arg(&script).output() else {
        return;
    };
    let shown = text(&output.stdout);
    if text(&output.stderr).contains("No module named 'sympy'") {
        return;
    }
    assert!(output.status.success(), "{shown}{}", text(&output.stderr));
    assert!(shown.contains("2 of 2 proofs hold"), "{shown}");
    assert!(
        shown.contains(r"ring.md:23: holds: \dot E = N_x\omega_x"),
        "{shown}"
    );
}

#[test]
fn the_example_of_the_readme_runs() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let wheel = document(
        here,
        &["--declare", "examples/wheel.declare", "examples/wheel.md"],
    );
    assert_eq!(
        verdicts(&wheel),
        ["proved", "proved", "refuted", "proved", "undecided"]
    );
}

#[test]
fn a_heavy_top_in_plain_text_is_judged_by_its_sentences() {
    let top = r"---
polhode:
- N is an inertial frame.
- `Z` is the upward vertical.
- The top is a rigid body of mass `m`.
- B is a frame fixed in the top.
- x, y, z are the axes of B.
- O is a point fixed in N and in B.
- G is the mass centre of the top.
- G lies at the distance `l` from O along z.
- `A`, `A`, `C` are the principal moments of the top
  about O on B.
- `a`, `b`, `c` are the Euler angles of B relative to N in the order `Z`, x, z.
- `g` is the acceleration of gravity.
- The weight and the force at O are the only loads on the top.
- `V` is the potential energy of the top.
- The potential energy is zero at O.
---
The potential energy of the top is

    V = m g l cos(b)

and not

    V = m g l sin(b)
";
    let folder = folder(&[("top.txt", top)]);
    let document = document(folder.path(), &["top.txt"]);
    assert_eq!(verdicts(&document), ["proved", "refuted"], "{document:#}");
}

#[test]
fn hostile_declarations_end_soon() {
    let many = format!(
        "---\npolhode:\n{}---\n$a = b$\n",
        "- N is a frame.\n".repeat(3_000)
    );
    let comments = "% polhode: N is an inertial frame.\n".repeat(5_000);
    let odd = "---\npolhode:\n- \n- '\n- \"\\\n-\n- # \n  - ' # '\n- $\n- `\n---\n$a = b$\n";
    let long = format!("---\npolhode:\n- {}\n---\n", "the frame of ".repeat(2_000));
    let folder = folder(&[
        ("many.md", &many),
        ("many.tex", &comments),
        ("odd.md", odd),
        ("long.md", &long),
    ]);
    for name in ["many.md", "many.tex", "odd.md", "long.md"] {
        let output = polhode(folder.path(), &["check", name]);
        assert!(
            output.status.code().is_some_and(|code| code < 4),
            "{name}: {}",
            text(&output.stderr)
        );
    }
}

#[test]
fn the_language_has_a_manual() {
    let output = polhode(Path::new("."), &["help", "language"]);
    assert_eq!(output.status.code(), Some(0));
    let manual = text(&output.stdout);
    for said in [
        "The language of declarations",
        "is an inertial frame",
        "angular momentum",
    ] {
        assert!(manual.contains(said), "{said}");
    }
    assert!(!manual.lines().any(|line| line.starts_with('#')));
}
