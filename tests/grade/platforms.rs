//! What teaching platforms hand out and take back: a worksheet, and the folders in which their autograders run.

use super::command::{class, grade};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Command;

fn example(name: &str) -> Vec<u8> {
    fs::read(format!("examples/grading/submissions/{name}")).expect("the example")
}

const WORKSHEET: &str = "\u{feff}Identifier,\"Full name\",\"Email address\",Status,Grade,\"Maximum Grade\",\"Grade can be changed\",\"Last modified (submission)\",\"Last modified (grade)\",\"Feedback comments\"\r\n\
\"Participant 41\",\"Lovelace, Ada\",ada@example.org,\"Submitted for grading\",,8.00,Yes,\"Monday, 2 March 2026, 9:00 AM\",-,\r\n\
\"Participant 42\",\"Ben \"\"B\"\" Babbage\",ben@example.org,\"Submitted for grading\",,8.00,Yes,\"Monday, 2 March 2026, 9:01 AM\",-,\"<p>old\nfeedback</p>\"\r\n\
\"Participant 43\",Cy,cy@example.org,\"No submission\",,8.00,Yes,-,-,\r\n";

#[test]
fn a_worksheet_is_filled_and_every_other_byte_is_kept() {
    let (ada, ben) = (example("ada.md"), example("ben.md"));
    let folder = class(&[
        ("Lovelace_41_assignsubmission_file/work.md", &ada),
        ("Babbage_42_assignsubmission_file/work.md", &ben),
        ("Stray_77_assignsubmission_file/work.md", &ben),
    ]);
    let sheet = folder.path().join("sheet.csv");
    fs::write(&sheet, WORKSHEET).expect("written");
    let sheet = sheet.to_string_lossy().into_owned();
    let options = ["--id-pattern", r"_(\d+)_", "--worksheet", &sheet];
    let (code, said) = grade(folder.path(), &options);
    assert_eq!(code, 0, "{said}");
    assert!(said.contains("77"), "{said}");
    let filled = fs::read_to_string(folder.path().join("out/worksheet.csv")).expect("a worksheet");
    let ada = "(1): 1 of 1, line 1 is true; (2): 2 of 2, line 3 is true; (4): 3 of 3, line 5 is true; (5): 2 of 2, line 7 is true";
    let ben = "(1): 1 of 1, line 1 is true; (2): 2 of 2, line 2 is true; (4): 0 of 3, line 6 is refuted; (5): 2 of 2, line 8 follows from the slip in line 6 as it should";
    let expected = WORKSHEET
        .replacen("grading\",,8.00", "grading\",8,8.00", 1)
        .replacen("-,\r\n", &format!("-,\"{ada}\"\r\n"), 1)
        .replacen("grading\",,8.00", "grading\",5,8.00", 1)
        .replacen("\"<p>old\nfeedback</p>\"", &format!("\"{ben}\""), 1);
    assert_eq!(filled, expected);
    assert_eq!(fs::read_to_string(&sheet).expect("the download"), WORKSHEET);
}

#[test]
fn a_worksheet_that_does_not_fit_is_refused() {
    let ada = example("ada.md");
    let folder = class(&[("41.md", &ada)]);
    let sheet = folder.path().join("sheet.csv");
    for (text, why) in [
        (WORKSHEET.replace("8.00", "10.00"), "maximum grade is 10.00"),
        (
            WORKSHEET.replacen("Grade,", "Bewertung,", 1),
            "called Grade",
        ),
        ("Grade\n1\n".to_owned(), "who a student is"),
    ] {
        fs::write(&sheet, text).expect("written");
        let path = sheet.to_string_lossy().into_owned();
        let (code, said) = grade(folder.path(), &["--worksheet", &path]);
        assert_eq!(code, 2, "{said}");
        assert!(said.contains(why), "{said}");
    }
}

/// Runs a script of an autograder in a folder laid out as the platform does it.
#[cfg(unix)]
fn run(script: &Path, root: (&str, &Path)) {
    let bin = Path::new(env!("CARGO_BIN_EXE_polhode"))
        .parent()
        .expect("a folder");
    let path = std::env::var("PATH").unwrap_or_default();
    let output = Command::new("bash")
        .arg(script)
        .env(root.0, root.1)
        .env("PATH", format!("{}:{path}", bin.display()))
        .output()
        .expect("bash runs");
    assert!(output.status.success(), "{output:?}");
}

#[cfg(unix)]
fn copied(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("made");
    for entry in fs::read_dir(from).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_file() {
            fs::copy(&path, to.join(path.file_name().expect("a name"))).expect("copied");
        }
    }
}

#[cfg(unix)]
fn parsed(path: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(path).expect("results")).expect("JSON")
}

#[cfg(unix)]
#[test]
fn the_autograder_for_gradescope_runs_in_its_folders() {
    let root = tempfile::tempdir().expect("a folder");
    let at = |name: &str| root.path().join(name);
    copied(Path::new("examples/grading/gradescope"), &at("source"));
    fs::create_dir_all(at("submission")).expect("made");
    fs::write(at("submission/ben.md"), example("ben.md")).expect("written");
    run(
        &at("source/run_autograder"),
        ("AUTOGRADER_ROOT", root.path()),
    );
    let results = parsed(&at("results/results.json"));
    assert_eq!(results["score"], 5.0);
    assert_eq!(results["output_format"], "md");
    let tests = results["tests"].as_array().expect("tests");
    let marks: Vec<_> = tests.iter().map(|t| (&t["score"], &t["status"])).collect();
    assert_eq!(marks.len(), 4);
    assert_eq!(tests[0]["status"], "passed");
    fs::write(at("submission/ben.md"), b"\xff\xfe").expect("written");
    run(
        &at("source/run_autograder"),
        ("AUTOGRADER_ROOT", root.path()),
    );
    assert_eq!(parsed(&at("results/results.json"))["score"], 0.0);
}

#[cfg(unix)]
#[test]
fn the_grader_for_prairielearn_runs_in_its_folders() {
    let root = tempfile::tempdir().expect("a folder");
    let at = |name: &str| root.path().join(name);
    copied(
        Path::new("examples/grading/prairielearn/tests"),
        &at("tests"),
    );
    fs::create_dir_all(at("student")).expect("made");
    fs::write(at("student/answer.md"), example("ben.md")).expect("written");
    run(&at("tests/run.sh"), ("GRADE_ROOT", root.path()));
    let results = parsed(&at("results/results.json"));
    assert_eq!(
        (&results["gradable"], &results["score"]),
        (&true.into(), &0.625.into())
    );
    fs::write(at("student/answer.md"), b"a\0b").expect("written");
    run(&at("tests/run.sh"), ("GRADE_ROOT", root.path()));
    let results = parsed(&at("results/results.json"));
    assert_eq!(results["gradable"], false);
    assert!(
        results["format_errors"][0]
            .as_str()
            .is_some_and(|why| why.contains("NUL"))
    );
}

#[test]
fn the_examples_have_the_same_key() {
    let key = fs::read_to_string("examples/grading/key.md").expect("the key");
    for copy in ["gradescope/key.md", "prairielearn/tests/key.md"] {
        let copy = fs::read_to_string(Path::new("examples/grading").join(copy)).expect("a key");
        assert_eq!(copy, key);
    }
}
