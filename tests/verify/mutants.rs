//! A wrong line is never proved: each sign, index, dot and frame of the derivations is flipped, one at a time.
//!
//! A line that holds, and of which one term is changed, holds no more, unless the term vanishes or the new one is
//! equal to it. The few mutants for which that is so are listed with the reason; every other one must be refuted.

use polhode::notation::{document::Format, read};
use polhode::verify::{Finding, Role, Verdict, check};
use std::collections::BTreeMap;
use std::fs;
use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Mutants that are true, by a part of the mutated line, and why.
const TRUE: &[(&str, &str)] = &[
    (
        r"(\dot{\vec{\Omega}})_{xyz} = (\dot{\vec{\Omega}})_{xyz}",
        "both sides are the same",
    ),
    (
        r"(\dot{\vec{\Omega}})_{XYZ} = (\dot{\vec{\Omega}})_{XYZ}",
        "both sides are the same",
    ),
    (
        r"\dot{\omega}_y = 0",
        "ω_y is assumed to be zero at all times",
    ),
];

/// Mutants without a meaning, by a part of the mutated line: it divides by what is assumed to be zero. They must be
/// neither proved nor accepted.
const MEANINGLESS: &[&str] = &[
    r"{I_{xy}}",
    r"{I_{yx}}",
    r"{I_{yz}}",
    r"{I_{zy}}",
    r"{I_{xz}}",
    r"{I_{zx}}",
];

/// One change of a document.
struct Mutant {
    /// The bytes that are replaced.
    range: Range<usize>,
    with: &'static str,
}

#[test]
fn no_mutant_of_a_derivation_is_proved_and_all_false_ones_are_refuted() {
    let mut files: Vec<_> = fs::read_dir("derivations")
        .expect("the derivations")
        .map(|entry| entry.expect("readable").path())
        .collect();
    files.sort();
    let mut wrong = Vec::new();
    for file in files {
        let text = fs::read_to_string(&file).expect("UTF-8");
        let mutants = mutants(&text);
        assert!(!mutants.is_empty(), "{}: nothing to flip", file.display());
        let found = verdicts(&text, &mutants);
        let mut count = BTreeMap::new();
        for (mutant, (verdict, line)) in mutants.iter().zip(&found) {
            *count.entry(*verdict).or_insert(0) += 1;
            let listed = |list: &[&str]| list.iter().any(|part| line.contains(part));
            let right = match *verdict {
                "refuted" => !TRUE.iter().any(|(part, _)| line.contains(part)),
                "proved" => TRUE.iter().any(|(part, _)| line.contains(part)),
                "undecided" => listed(MEANINGLESS),
                _ => false,
            };
            if !right {
                let at = text[..mutant.range.start].lines().count();
                wrong.push(format!("{}:{at}: {verdict}: {line}", file.display()));
            }
        }
        println!("{}: {count:?}", file.display());
    }
    assert!(
        wrong.is_empty(),
        "{} mutants:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}

/// The verdict on the mutated line, and that line, for each mutant.
fn verdicts(text: &str, mutants: &[Mutant]) -> Vec<(&'static str, String)> {
    let next = AtomicUsize::new(0);
    let results = Mutex::new(vec![("", String::new()); mutants.len()]);
    let work = || {
        while let Some((i, mutant)) = {
            let i = next.fetch_add(1, Ordering::Relaxed);
            mutants.get(i).map(|mutant| (i, mutant))
        } {
            let result = verdict(text, mutant);
            results.lock().expect("no thread panicked")[i] = result;
        }
    };
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get());
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(work);
        }
    });
    results.into_inner().expect("no thread panicked")
}

fn verdict(text: &str, mutant: &Mutant) -> (&'static str, String) {
    let mut changed = text.to_owned();
    changed.replace_range(mutant.range.clone(), mutant.with);
    let at = mutant.range.start;
    let holds = |finding: &&Finding| {
        let span = finding.span.range();
        span.start <= at && at <= span.end
    };
    let findings = findings(&changed);
    let line = findings.iter().filter(holds).min_by_key(|f| f.source.len());
    match line {
        Some(line) => (line.verdict.name(), line.source.clone()),
        None => (
            "lost",
            changed[at.saturating_sub(20)..].chars().take(60).collect(),
        ),
    }
}

fn findings(text: &str) -> Vec<Finding> {
    let (document, _) = read("mutant.md", text, Format::Markdown);
    check(&document).findings
}

/// Every flip in every claim that was proved.
fn mutants(text: &str) -> Vec<Mutant> {
    let findings = findings(text);
    let claims = findings
        .iter()
        .filter(|f| f.role == Role::Claim && matches!(f.verdict, Verdict::Proved(_)));
    let mut all: Vec<_> = claims.flat_map(|f| flips(text, f.span.range())).collect();
    all.sort_by_key(|m| m.range.start);
    all.dedup_by_key(|m| (m.range.clone(), m.with));
    all
}

fn flips(text: &str, line: Range<usize>) -> Vec<Mutant> {
    let mut flips = Vec::new();
    for at in line.clone() {
        let Some(rest) = text.get(at..line.end) else {
            continue;
        };
        let before = &text[line.start..at];
        flips.extend(
            sign(rest)
                .or_else(|| frame(before, rest))
                .map(|(n, with)| Mutant {
                    range: at..at + n,
                    with,
                }),
        );
        flips.extend(dot(rest).map(|n| Mutant {
            range: at..at + n,
            with: "",
        }));
        flips.extend(indices(before, rest).map(|(offset, with)| Mutant {
            range: at + offset..at + offset + 1,
            with,
        }));
    }
    flips
}

/// The other sign.
fn sign(rest: &str) -> Option<(usize, &'static str)> {
    match rest.as_bytes().first()? {
        b'+' => Some((1, "-")),
        b'-' => Some((1, "+")),
        _ => None,
    }
}

/// The other frame of a derivative.
fn frame(before: &str, rest: &str) -> Option<(usize, &'static str)> {
    let pairs = [
        ("_{XYZ}", "_{xyz}"),
        ("_{xyz}", "_{XYZ}"),
        ("_{XY}", "_{xy}"),
        ("_{xy}", "_{XY}"),
    ];
    let (old, new) = pairs.iter().find(|(old, _)| rest.starts_with(old))?;
    before.ends_with(')').then_some((old.len(), new))
}

/// A dot that is lost: the length of its command.
fn dot(rest: &str) -> Option<usize> {
    rest.strip_prefix("\\dot")?
        .starts_with(|c: char| !c.is_alphabetic())
        .then_some("\\dot".len())
}

/// The letters of a subscript, or of a unit vector, each with the next one in the ring.
fn indices(before: &str, rest: &str) -> impl Iterator<Item = (usize, &'static str)> {
    let (skip, len) = if let Some(inner) = rest.strip_prefix("_{") {
        (2, inner.find('}').unwrap_or(0))
    } else if rest.starts_with('_') {
        (1, 1)
    } else if rest.starts_with("\\hat{") {
        (5, 1)
    } else {
        (0, 0)
    };
    let letters = rest.get(skip..skip + len).unwrap_or("");
    let is_index = !before.ends_with(')') && letters.chars().all(|c| next(c).is_some());
    let letters = if is_index { letters } else { "" };
    letters
        .char_indices()
        .filter_map(move |(i, c)| Some((skip + i, next(c)?)))
}

fn next(letter: char) -> Option<&'static str> {
    Some(match letter {
        'x' => "y",
        'y' => "z",
        'z' => "x",
        'i' => "j",
        'j' => "k",
        'k' => "i",
        '1' => "2",
        '2' => "3",
        '3' => "1",
        _ => return None,
    })
}
