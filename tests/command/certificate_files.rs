//! Certificates as files: each is checked again by arithmetic of the tests' own and by SymPy, and none that was tampered
//! with is believed.

use super::multiply_out;
use num_traits::One;
use polhode::algebra::{Argument, Polynomial, Reason};
use polhode::notation::{document::Format, read};
use polhode::report::{Checked, certificate};
use polhode::verify::{Verdict, check};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::{env, fs};
use tempfile::TempDir;

fn checked(name: &str, text: &str) -> Checked {
    let (document, diagnostics) = read(name, text, Format::Markdown);
    let report = check(&document);
    Checked {
        document,
        diagnostics,
        report,
    }
}

fn derivations() -> Vec<Checked> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations");
    let entries = fs::read_dir(folder).expect("a folder of the repository");
    let mut paths: Vec<PathBuf> = entries.map(|e| e.expect("readable").path()).collect();
    paths.sort();
    let name = |path: &Path| path.file_name().map(|n| n.to_string_lossy().into_owned());
    paths
        .iter()
        .map(|path| {
            let text = fs::read_to_string(path).expect("a file of the repository");
            checked(&name(path).expect("a name"), &text)
        })
        .collect()
}

fn arguments(checked: &Checked) -> Vec<Argument> {
    let findings = checked.report.findings.iter();
    findings
        .flat_map(|finding| match &finding.verdict {
            Verdict::Proved(proof) => proof.arguments().to_vec(),
            _ => vec![],
        })
        .collect()
}

#[test]
fn every_certificate_of_the_derivations_multiplies_out_elsewhere() {
    for checked in derivations() {
        let name = &checked.report.path;
        let files = certificate::files(&checked);
        assert_eq!(files.len(), checked.report.summary().proved + 1, "{name}");
        for file in files.iter().filter(|file| file.name.ends_with(".txt")) {
            assert_eq!(
                multiply_out::check(&file.text),
                Ok(()),
                "{name}: {}",
                file.name
            );
        }
    }
}

/// Each row of a kind changed in the ways that a forger or a slip of the program would.
fn forged(text: &str) -> Vec<String> {
    let rows: Vec<&str> = text.lines().collect();
    let with = |at: usize, row: String| {
        let mut rows: Vec<&str> = rows.clone();
        rows[at] = &row;
        rows.join("\n")
    };
    let mut all = vec![];
    for (at, row) in rows.iter().enumerate() {
        let word = row.split(' ').next().unwrap_or("");
        match word {
            "left" | "right" => all.push(with(at, row.replacen('(', "(v0*v1 + ", 1))),
            "cofactor" | "fact" => all.push(with(at, format!("{row} + v0"))),
            "multiplier" => all.push(with(at, "multiplier 0".to_owned())),
            _ => {}
        }
        if word == "condition" {
            all.push(with(at, "condition 7".to_owned()));
        }
    }
    all
}

#[test]
fn no_forged_text_is_believed() {
    let mut forgeries = 0;
    for checked in derivations() {
        for file in certificate::files(&checked)
            .iter()
            .filter(|f| f.name.ends_with(".txt"))
        {
            for text in forged(&file.text) {
                // A premise may say what it likes; then what rests on it must fail.
                assert!(
                    multiply_out::check(&text).is_err(),
                    "{}:\n{text}",
                    file.name
                );
                forgeries += 1;
            }
        }
    }
    assert!(forgeries > 1_000, "{forgeries}");
}

/// An argument in which one polynomial or one reason is not what it was.
fn tampered(argument: &Argument) -> Vec<Argument> {
    let one = Polynomial::one();
    let mut all = vec![];
    let mut change = |edit: &dyn Fn(&mut Argument)| {
        let mut copy = argument.clone();
        edit(&mut copy);
        all.push(copy);
    };
    for i in 0..argument.goals.len() {
        change(&|a| a.goals[i].left.numerator += one.clone());
        change(&|a| a.goals[i].right.denominator = Polynomial::default());
        change(&|a| a.goals[i].by.multiplier = Polynomial::default());
        for j in 0..argument.goals[i].by.cofactors.len() {
            change(&|a| a.goals[i].by.cofactors[j].1 += one.clone());
            change(&|a| a.goals[i].by.cofactors[j].0 = usize::MAX);
        }
    }
    for i in 0..argument.facts.len() {
        change(&|a| a.facts[i].value += Polynomial::variable(100_000));
        change(&|a| a.facts[i].reason = Reason::Rate(i));
        change(&|a| a.facts[i].reason = Reason::Root(u32::MAX));
        change(&|a| a.facts[i].reason = Reason::Premise(String::new()));
    }
    for i in 0..argument.conditions.len() {
        change(&|a| drop(a.conditions.remove(i)));
    }
    change(&|a| a.goals.clear());
    all
}

#[test]
fn the_checker_refuses_every_tampered_argument() {
    let mut tries = 0;
    for argument in derivations().iter().flat_map(arguments) {
        assert!(argument.clone().checked().is_ok());
        for wrong in tampered(&argument) {
            assert!(
                wrong.clone().checked().is_err(),
                "{argument:?}\nas\n{wrong:?}"
            );
            tries += 1;
        }
    }
    assert!(tries > 1_000, "{tries}");
}

/// A Python that has SymPy: the one at hand, or one in a new virtual environment.
fn python(folder: &Path) -> Option<PathBuf> {
    let has_sympy = |python: &Path| {
        let output = Command::new(python).args(["-c", "import sympy"]).output();
        output.is_ok_and(|output| output.status.success())
    };
    let own = PathBuf::from("python3");
    if has_sympy(&own) {
        return Some(own);
    }
    let environment = folder.join("environment");
    let made = Command::new(&own)
        .args(["-m", "venv"])
        .arg(&environment)
        .output()
        .ok()?;
    let new = environment.join("bin").join("python3");
    let install = ["-m", "pip", "install", "--quiet", "sympy"];
    let installed = made.status.success()
        && Command::new(&new)
            .args(install)
            .output()
            .ok()?
            .status
            .success();
    (installed && has_sympy(&new)).then_some(new)
}

fn run(python: &Path, folder: &Path, script: &str) -> Output {
    let path = folder.join("recheck.py");
    fs::write(&path, script).expect("a file that can be written");
    Command::new(python)
        .arg(&path)
        .output()
        .expect("Python starts")
}

#[test]
fn sympy_agrees_and_refuses_a_forged_script() {
    let folder = TempDir::new().expect("a temporary folder");
    let Some(python) = python(folder.path()) else {
        eprintln!(
            "NOT TESTED: there is no Python with SymPy here, and none could be installed; no script was run"
        );
        return;
    };
    for checked in derivations() {
        let name = &checked.report.path;
        let script = certificate::script(&checked);
        let output = run(&python, folder.path(), &script);
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        let count = checked.report.summary().proved;
        assert!(
            output.status.success(),
            "{name}: {said}{}",
            String::from_utf8_lossy(&output.stderr)
        );
        assert!(
            said.ends_with(&format!("{count} of {count} proofs hold\n")),
            "{name}: {said}"
        );
        let at = script.rfind("c.goal(").expect("a goal") + "c.goal(".len();
        let forged = format!("{}v0 + {}", &script[..at], &script[at..]);
        let output = run(&python, folder.path(), &forged);
        assert_eq!(
            output.status.code(),
            Some(1),
            "{name}: the forged goal passes"
        );
    }
}

#[test]
fn hostile_texts_are_quoted() {
    let name = "x\"\n\"\"\"\nimport os; os._exit(77)\n\u{1b}[31m\u{202e}\u{1d4db}.md";
    let text = "Let $b = \\text{\"\"\"; import os; os.exit(77)} a$.\n\nThen $a\\,{\"} = a\\,{\"}$ and $a_{\\text{\\u000a\"}} = a_{\\text{\\u000a\"}}$, $2 a = a + a$.\n";
    let checked = checked(name, text);
    assert!(checked.report.summary().proved > 0);
    for file in certificate::files(&checked) {
        assert!(file.text.is_ascii(), "{}", file.name);
        assert!(!file.text.contains(['\u{1b}', '\r']), "{}", file.name);
        let plain = |c: char| c.is_ascii_alphanumeric() || ".-_".contains(c);
        assert!(file.name.chars().all(plain), "{}", file.name);
        if file.name.ends_with(".txt") {
            assert_eq!(multiply_out::check(&file.text), Ok(()));
        }
    }
    let folder = TempDir::new().expect("a temporary folder");
    if let Some(python) = python(folder.path()) {
        let output = run(&python, folder.path(), &certificate::script(&checked));
        assert_eq!(
            output.status.code(),
            Some(0),
            "{}",
            String::from_utf8_lossy(&output.stderr)
        );
    }
}

#[test]
fn folders_are_named_safely_and_apart() {
    let mut taken = vec![];
    for path in [
        "a/notes.md",
        "b/notes.md",
        "B/Notes.md",
        "..",
        "",
        "a/..\\..\\x",
        "-",
        "ä.md",
        &"x".repeat(500),
    ] {
        let name = certificate::folder(path, &taken);
        let plain = |c: char| c.is_ascii_alphanumeric() || ".-_".contains(c);
        assert!(
            name.chars().all(plain) && !name.starts_with(['.', '-']),
            "{name}"
        );
        assert!(name.len() < 100 && !taken.contains(&name), "{name}");
        taken.push(name);
    }
}

#[test]
fn the_command_writes_them_and_clears_away_old_ones() {
    let folder = TempDir::new().expect("a temporary folder");
    let notes = folder.path().join("notes.md");
    let command = |text: &str| {
        fs::write(&notes, text).expect("a file that can be written");
        let mut command = Command::new(env!("CARGO_BIN_EXE_polhode"));
        let command = command.current_dir(folder.path());
        command
            .args(["check", "notes.md", "--certificate", "proofs"])
            .output()
            .expect("the command starts")
    };
    let names = || {
        let entries = fs::read_dir(folder.path().join("proofs/notes.md")).expect("a folder");
        let mut names: Vec<String> = entries
            .map(|e| {
                e.expect("readable")
                    .file_name()
                    .into_string()
                    .expect("ASCII")
            })
            .collect();
        names.sort();
        names
    };
    let output = command("$2 a = a + a$ and $3 a = a + 2 a$.\n\n$4 a = 2 a + 2 a$\n");
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(
        names(),
        [
            "line-0001-2.txt",
            "line-0001.txt",
            "line-0003.txt",
            "recheck.py"
        ]
    );
    let own = folder.path().join("proofs/notes.md/mine.txt");
    fs::write(&own, "not a certificate").expect("a file that can be written");
    command("$2 a = a + a$\n");
    assert_eq!(names(), ["line-0001.txt", "mine.txt", "recheck.py"]);
}
