//! `polhode grade`: files in, results out, exit codes.

use super::KEY;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn polhode(arguments: &[&str]) -> Output {
    let command = Command::new(env!("CARGO_BIN_EXE_polhode"))
        .args(arguments)
        .output();
    command.expect("the command runs")
}

pub(crate) fn grade(folder: &Path, more: &[&str]) -> (i32, String) {
    let path = |name: &str| folder.join(name).to_string_lossy().into_owned();
    let (key, work, out) = (path("key.md"), path("work"), path("out"));
    let mut arguments = vec!["grade", &key, &work, "--out", &out];
    arguments.extend(more);
    let output = polhode(&arguments);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    (output.status.code().unwrap_or(-1), said)
}

/// Puts parts together.
pub(crate) fn merge(folder: &Path, more: &[&str]) -> (i32, String) {
    let path = |name: &str| folder.join(name).to_string_lossy().into_owned();
    let (key, out) = (path("key.md"), path("out"));
    let mut arguments = vec!["grade", &key, "--out", &out, "--merge"];
    arguments.extend(more);
    let output = polhode(&arguments);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    (output.status.code().unwrap_or(-1), said)
}

pub(crate) fn results(folder: &Path) -> String {
    fs::read_to_string(folder.join("out/results.json")).expect("results.json")
}

pub(crate) fn class(files: &[(&str, &[u8])]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("key.md"), KEY).expect("written");
    fs::create_dir(folder.path().join("work")).expect("made");
    for (name, text) in files {
        let path = folder.path().join("work").join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("made");
        fs::write(path, text).expect("written");
    }
    folder
}

#[test]
fn the_example_class_gets_the_marks_that_it_should() {
    let out = tempfile::tempdir().expect("a temporary folder");
    let target = out.path().to_string_lossy().into_owned();
    let output = polhode(&[
        "grade",
        "examples/grading/key.md",
        "examples/grading/submissions",
        "--out",
        &target,
    ]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let text = fs::read_to_string(out.path().join("results.json")).expect("results.json");
    let results: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(results["schema"], "polhode-grade/1");
    assert_eq!(results["max"], 8);
    let students = results["students"].as_array().expect("students");
    let told: Vec<String> = students
        .iter()
        .map(|s| format!("{} {}", s["id"], s["marks"]))
        .collect();
    assert_eq!(told, [r#""ada" 8.0"#, r#""ben" 5.0"#, r#""cy" 0.0"#]);
    assert_eq!(students[1]["first_slip"]["source_line"], 6);
    assert_eq!(students[1]["milestones"][3]["outcome"], "follow-through");
}

#[test]
fn what_cannot_be_read_waits_and_hurts_nobody() {
    let good = fs::read("examples/grading/submissions/ada.md").expect("the example");
    let files: [(&str, &[u8]); 9] = [
        ("ada.md", &good),
        ("nul.md", b"a\0b"),
        ("bytes.md", b"\xff\xfe\x00"),
        ("empty.md", b""),
        ("paper.pdf", b"%PDF"),
        ("two.md", &good),
        ("two.tex", b"nothing"),
        ("folder/one.md", &good),
        ("=HYPERLINK(1)<script>.md", &good),
    ];
    let folder = class(&files);
    let large = vec![b'x'; 3 << 20];
    fs::write(folder.path().join("work/large.md"), large).expect("written");
    #[cfg(unix)]
    std::os::unix::fs::symlink("/etc/hostname", folder.path().join("work/link.md"))
        .expect("linked");
    let (code, said) = grade(folder.path(), &[]);
    assert_eq!(code, 3, "{said}");
    let results: Value = serde_json::from_str(&results(folder.path())).expect("JSON");
    let students = results["students"].as_array().expect("students");
    let of = |id: &str| {
        students
            .iter()
            .find(|s| s["id"] == id)
            .unwrap_or_else(|| panic!("{id} is lost"))
    };
    assert_eq!(of("ada")["marks"], 8.0);
    assert_eq!(of("folder")["marks"], 8.0);
    for id in [
        "nul",
        "bytes",
        "empty",
        "paper",
        "two",
        "large",
        "=HYPERLINK(1)%3Cscript%3E",
    ] {
        assert!(of(id)["queue"].is_string(), "{id}");
    }
    #[cfg(unix)]
    assert!(
        of("link")["queue"]
            .as_str()
            .is_some_and(|reason| reason.contains("link"))
    );
}

#[test]
fn the_results_are_the_same_on_any_number_of_threads() {
    let good = fs::read("examples/grading/submissions/ben.md").expect("the example");
    let names: Vec<String> = (0..24).map(|n| format!("s{n:02}.md")).collect();
    let files: Vec<(&str, &[u8])> = names
        .iter()
        .map(|name| (name.as_str(), good.as_slice()))
        .collect();
    let folder = class(&files);
    let mut seen = vec![];
    for threads in ["1", "2", "7"] {
        assert_eq!(grade(folder.path(), &["--threads", threads]).0, 0);
        seen.push(results(folder.path()));
    }
    assert!(seen.windows(2).all(|pair| pair[0] == pair[1]));
}

#[test]
fn a_key_or_a_folder_that_cannot_be_used_ends_with_two() {
    let folder = class(&[]);
    let (code, said) = grade(folder.path(), &[]);
    assert_eq!(code, 2);
    assert!(said.contains("nothing in it to mark"), "{said}");
    fs::write(folder.path().join("key.md"), "no marks").expect("written");
    let (code, said) = grade(folder.path(), &[]);
    assert_eq!(code, 2);
    assert!(said.contains("no line carries marks"), "{said}");
}

#[test]
fn a_key_is_checked_alone() {
    let output = polhode(&["grade", "--check-key", "examples/grading/key.md"]);
    assert_eq!(output.status.code(), Some(0));
    assert!(String::from_utf8_lossy(&output.stdout).contains("(5): 2"));
}

#[test]
fn results_do_not_lie_among_the_submissions() {
    let folder = class(&[("ada.md", b"nothing")]);
    let path = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    for out in ["work", "work/out", "work/../work/a/b"] {
        let output = polhode(&["grade", &path("key.md"), &path("work"), "--out", &path(out)]);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{out}: {said}");
        assert!(said.contains("--out"), "{said}");
    }
    assert!(!folder.path().join("work/journal.jsonl").exists());
}

#[test]
fn an_answer_for_nobody_is_said() {
    let folder = class(&[("ada.md", b"nothing"), ("ben.md", b"nothing")]);
    let answers = folder.path().join("answers");
    fs::create_dir(&answers).expect("made");
    for name in ["adda", "ben", "quentin"] {
        fs::write(answers.join(format!("{name}.txt")), "# none\n").expect("written");
    }
    let answers = answers.to_string_lossy().into_owned();
    let (_, said) = grade(folder.path(), &["--answers", &answers]);
    assert!(said.contains("did you mean ada.txt?"), "{said}");
    assert!(
        said.contains("quentin.txt: nobody") && !said.contains("ben.txt: nobody"),
        "{said}"
    );
}
