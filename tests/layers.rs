//! The house keeps one direction: a module imports only what stands below it, and no file grows past a screenful of ideas.

mod layers {
    mod ratchet;
    mod rooms;
    pub(crate) mod source;

    use super::{named, named_behind};
}

use layers::source::{Source, files};
use std::{fs, path::Path};

/// A module and the modules that it may name. What is not listed is not allowed.
const LAYERS: &[(&str, &[&str])] = &[
    ("source", &[]),
    ("recent", &[]),
    ("diagnostic", &["source"]),
    ("scalar", &[]),
    ("notation", &["recent", "source", "diagnostic"]),
    ("algebra", &["source", "diagnostic", "scalar", "notation"]),
    ("mechanics", &["scalar"]),
    ("motion", &["scalar", "mechanics"]),
    ("jacobian", &["scalar", "mechanics", "motion"]),
    ("audit", &["scalar", "mechanics", "motion"]),
    ("emit", &["scalar", "mechanics", "motion"]),
    (
        "optimise",
        &["scalar", "mechanics", "motion", "jacobian", "audit"],
    ),
    (
        "verify",
        &[
            "recent",
            "source",
            "diagnostic",
            "scalar",
            "notation",
            "algebra",
            "mechanics",
        ],
    ),
    (
        "grade",
        &[
            "recent",
            "source",
            "diagnostic",
            "scalar",
            "notation",
            "algebra",
            "mechanics",
            "verify",
        ],
    ),
    (
        "report",
        &[
            "recent",
            "source",
            "diagnostic",
            "notation",
            "algebra",
            "mechanics",
            "verify",
            "grade",
        ],
    ),
    (
        "scene",
        &["source", "diagnostic", "scalar", "mechanics", "motion"],
    ),
    ("bench", &["scalar", "mechanics", "motion", "scene"]),
];

/// Lines that a file may have.
const LIMIT: usize = 420;

#[test]
fn each_module_imports_only_what_is_below_it() {
    let mut wrong = Vec::new();
    for (module, below) in LAYERS {
        for file in files(&Path::new("src").join(module)) {
            let text = fs::read_to_string(&file).expect("readable");
            for name in named(&text) {
                if name != *module && !below.contains(&name.as_str()) {
                    wrong.push(format!("{}: {module} may not name {name}", file.display()));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_file_is_one_idea() {
    let long: Vec<_> = files(Path::new("src"))
        .into_iter()
        .map(|file| {
            (
                fs::read_to_string(&file).expect("readable").lines().count(),
                file,
            )
        })
        .filter(|(lines, _)| *lines > LIMIT)
        .collect();
    assert!(long.is_empty(), "over {LIMIT} lines: {long:?}");
}

/// Cargo builds the library once, and not again with tests in it: those would never run.
#[test]
fn the_tests_of_the_library_stand_beside_it() {
    let tested = |source: &Source| {
        let mut marks = ["#[test]", "cfg(test", "cfg(all(test", "cfg(any(test"].into_iter();
        marks.any(|mark| source.code.contains(mark))
    };
    let sources = files(Path::new("src")).into_iter().map(Source::read);
    let inside: Vec<_> = sources.filter(tested).map(|source| source.path).collect();
    assert!(
        inside.is_empty(),
        "put these tests into `tests/`: {inside:?}"
    );
}

#[test]
fn an_upward_import_would_be_seen() {
    let names = named(
        "use crate::{verify::{check, Ledger}, scalar::Ring};\nlet x = crate::report::text(&a);",
    );
    assert_eq!(names, ["verify", "scalar", "report"]);
}

/// The top-level modules that a text names after `crate::`, in braces or alone.
fn named(text: &str) -> Vec<String> {
    named_behind(text, "crate::")
}

/// The modules that a text names right behind a path.
fn named_behind(text: &str, path: &str) -> Vec<String> {
    let word = |s: &str| {
        s.trim_start()
            .split(|c: char| !c.is_alphanumeric() && c != '_')
            .next()
            .unwrap_or("")
            .to_owned()
    };
    let mut names = Vec::new();
    for rest in text.split(path).skip(1) {
        match rest.strip_prefix('{') {
            Some(group) => names.extend(members(group).into_iter().map(word)),
            None => names.push(word(rest)),
        }
    }
    names.retain(|name| !name.is_empty());
    names
}

/// The entries of a group in braces, at its own depth.
fn members(group: &str) -> Vec<&str> {
    let (mut depth, mut start, mut found) = (1, 0, Vec::new());
    for (i, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 || (depth == 1 && c == ',') {
            found.push(&group[start..i]);
            start = i + 1;
        }
        if depth == 0 {
            break;
        }
    }
    found
}
