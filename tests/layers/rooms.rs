//! The rooms of `verify`: each imports only what stands before it, and what is in them stays small.

use super::ratchet::{ROOMS, part};
use super::source::{Source, files, functions, parts, structs};
use std::path::Path;

/// A room and the rooms that it may name. The sentences of `language` know the system's names and nothing else of it.
const BEFORE: [(&str, &[&str]); 8] = [
    ("model", &[]),
    ("language", &["model"]),
    ("term", &["model"]),
    ("facts", &["model", "term"]),
    ("reading", &["model", "term", "facts", "language"]),
    (
        "standing",
        &["model", "term", "facts", "language", "reading"],
    ),
    (
        "correction",
        &["model", "term", "facts", "language", "reading", "standing"],
    ),
    (
        "derivation",
        &["model", "term", "facts", "language", "reading", "standing"],
    ),
];

/// Modules of the library that `language` may name.
const BELOW_LANGUAGE: [&str; 4] = ["source", "diagnostic", "notation", "verify"];

/// Lines that a function may have, and fields that a struct may have.
const LINES: usize = 60;
const FIELDS: usize = 12;

#[test]
fn a_room_imports_only_the_rooms_before_it() {
    let mut wrong = vec![];
    for source in rooms() {
        let room = part(&source.path);
        let (_, before) = BEFORE
            .iter()
            .find(|(name, _)| *name == room)
            .expect("a room");
        for name in in_verify(&source.path, &source.code) {
            if name != room && !before.contains(&name.as_str()) {
                wrong.push(format!(
                    "{}: {room} may not name {name}",
                    source.path.display()
                ));
            }
        }
        for name in super::named(&source.code) {
            if room == "language" && !BELOW_LANGUAGE.contains(&name.as_str()) {
                wrong.push(format!(
                    "{}: language may not name {name}",
                    source.path.display()
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn functions_and_structs_of_the_rooms_are_small() {
    let mut wrong = vec![];
    for source in rooms() {
        let path = source.path.display();
        for (name, first, lines) in functions(&source.code) {
            if lines > LINES {
                wrong.push(format!(
                    "{path}:{first}: {name} has {lines} lines, more than {LINES}"
                ));
            }
        }
        for (name, fields) in structs(&source.code) {
            if fields > FIELDS {
                wrong.push(format!(
                    "{path}: {name} has {fields} fields, more than {FIELDS}"
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn rooms() -> impl Iterator<Item = Source> {
    let all = ROOMS
        .iter()
        .flat_map(|room| files(&Path::new("src/verify").join(room)));
    all.map(Source::read)
}

/// The parts of `verify` that a file of it names: by their full path, or through the modules above the file.
fn in_verify(path: &Path, code: &str) -> Vec<String> {
    let inside = path.strip_prefix("src/verify").unwrap_or(path);
    let above = "super::".repeat(inside.components().count());
    let mut names = super::named_behind(code, "crate::verify::");
    names.extend(super::named_behind(code, &above));
    // Types that `verify` gives to all are no parts of it.
    names.retain(|name| name != "super" && !name.starts_with(char::is_uppercase));
    names
}

#[test]
fn what_is_wrong_in_a_room_would_be_seen() {
    let text = "use crate::verify::{facts::Facts, words};\nuse super::super::{lines::Line, Role};\n\
                /* { */ fn long(a: &'static str) -> char {\n    let text = r#\"}\"#;\n    '}'\n}\n\
                struct Wide<T> {\n    a: Map<T, u8>,\n    pub b: fn(u8, u8) -> u8, // c, d\n}\nstruct Unit;\n";
    let (code, literals) = parts(text);
    let file = Path::new("src/verify/model/frames.rs");
    assert_eq!(in_verify(file, &code), ["facts", "words", "lines"]);
    assert_eq!(functions(&code), [("long", 3, 4)]);
    assert_eq!(structs(&code), [("Wide", 2)]);
    assert_eq!(literals, ["}"]);
}
