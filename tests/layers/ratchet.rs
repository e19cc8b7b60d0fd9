//! What `verify` has too much of, and may only have less of: each number falls until the old house is gone.

use super::source::{Source, files, structs};
use std::path::Path;

/// What is counted, and how many there may be. When there are fewer, lower the number; never raise one.
const MOST: [(&str, usize); 6] = [
    ("blocks `impl Checker`", 142),
    ("literals of English in the old house, but for `words`", 805),
    (
        "literals of English in the new rooms, but for `language`",
        92,
    ),
    ("fields of `Checker`", 66),
    ("fields of `Reading`", 63),
    ("files outside the new rooms", 279),
];

/// The rooms of the new house, which have rules of their own.
pub(super) const ROOMS: [&str; 8] = [
    "model",
    "term",
    "facts",
    "language",
    "reading",
    "standing",
    "derivation",
    "correction",
];

#[test]
fn what_verify_has_too_much_of_only_falls() {
    let sources: Vec<_> = files(Path::new("src/verify"))
        .into_iter()
        .map(Source::read)
        .collect();
    let (new, old): (Vec<_>, Vec<_>) = sources
        .iter()
        .partition(|source| ROOMS.contains(&part(&source.path).as_str()));
    let fields = |name| {
        let found = old.iter().flat_map(|source| structs(&source.code));
        let fields = found.filter(|(found, _)| *found == name);
        fields.map(|(_, fields)| fields).max().unwrap_or(0)
    };
    let english = |sources: &[&Source], but_for: &str| {
        let others = sources.iter().filter(|s| part(&s.path) != but_for);
        let literals = others.flat_map(|source| &source.literals);
        literals.filter(|literal| is_english(literal)).count()
    };
    let now = [
        old.iter().map(|source| blocks(&source.code)).sum(),
        english(&old, "words"),
        english(&new, "language"),
        fields("Checker"),
        fields("Reading"),
        old.iter()
            .filter(|s| s.path != Path::new("src/verify.rs"))
            .count(),
    ];
    let told: Vec<_> = MOST
        .iter()
        .zip(now)
        .filter(|((_, most), now)| most != now)
        .map(|((what, most), now)| match now > *most {
            true => format!("{now} {what}, and {most} is the most that there may be"),
            false => format!("only {now} {what}: lower the {most} of the table in this test"),
        })
        .collect();
    assert!(told.is_empty(), "{}", told.join("\n"));
}

/// The file or folder of `verify` that a file belongs to.
pub(super) fn part(path: &Path) -> String {
    let inside = path.strip_prefix("src/verify").unwrap_or(path);
    let first = inside.components().next().map(|c| c.as_os_str());
    let first = first.unwrap_or_default().to_string_lossy();
    first.trim_end_matches(".rs").to_owned()
}

/// The blocks of methods of the checker.
fn blocks(code: &str) -> usize {
    let heads = code.lines().filter(|line| line.starts_with("impl"));
    heads.filter(|line| line.contains(" Checker<")).count()
}

/// Two words or more in small letters.
fn is_english(literal: &str) -> bool {
    let is_word = |word: &&str| {
        let word = word.trim_matches([',', '.', ';', ':', '(', ')', '?', '`', '"']);
        word.len() > 1 && word.chars().all(|c| c.is_ascii_lowercase())
    };
    literal.split_whitespace().filter(is_word).count() > 1
}

#[test]
fn english_and_formulas_are_told_apart() {
    assert!(is_english("the mass centre"));
    assert!(is_english("{name} is no vector"));
    assert!(!is_english("torque"));
    assert!(!is_english("\\omega_x = a b"));
    assert!(!is_english("x y z"));
}
