//! Each line of the files in `tests/documents/` gets the verdict that stands beside its document.
//!
//! All differences are told at once, the worst first. `DOCUMENTS=wheels` takes only the files with that in their name;
//! `UPDATE_DOCUMENTS=1` writes what was found into the files, all but a proof in place of a refutation or the other way
//! round.

use crate::common::documents::{Sample, opening, samples, samples_of};
use polhode::notation::read;
use polhode::verify::{Finding, Verdict, check};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{env, fmt, fs, thread};

/// How much a difference weighs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Weight {
    /// A proof in place of a refutation, or the other way round.
    Turned,
    /// What was decided is left open, or there are other lines than before.
    Lost,
    /// Something else.
    Changed,
    /// What was left open is decided.
    Gained,
}

/// What a document gets in place of what it must get.
struct Difference<'a> {
    sample: &'a Sample,
    weight: Weight,
    /// The verdicts of all of its lines; none where the verifier broke down.
    found: Option<String>,
    /// A text for each line that differs.
    told: Vec<String>,
}

#[test]
fn every_line_gets_the_verdict_that_stands_beside_its_document() {
    let wanted = env::var("DOCUMENTS").unwrap_or_default();
    let mut samples = samples();
    samples.retain(|sample| sample.file.to_string_lossy().contains(&wanted));
    assert!(!samples.is_empty(), "no documents");
    let mut differences = differences(&samples);
    if env::var_os("UPDATE_DOCUMENTS").is_some() {
        differences.retain(|difference| match &difference.found {
            Some(found) if difference.weight != Weight::Turned => {
                write(difference.sample, found);
                false
            }
            _ => true,
        });
    }
    let lines: usize = samples.iter().map(|s| s.expected.len()).sum();
    let count = |weight| differences.iter().filter(|d| d.weight == weight).count();
    assert!(
        differences.is_empty(),
        "{}of {} documents with {lines} lines {} turned, {} lost, {} changed, {} gained a verdict",
        differences
            .iter()
            .map(ToString::to_string)
            .collect::<String>(),
        samples.len(),
        count(Weight::Turned),
        count(Weight::Lost),
        count(Weight::Changed),
        count(Weight::Gained),
    );
}

/// All differences, the worst first.
fn differences(samples: &[Sample]) -> Vec<Difference<'_>> {
    let (next, found) = (AtomicUsize::new(0), Mutex::new(BTreeMap::new()));
    let threads = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some(sample) = samples.get(next.fetch_add(1, Ordering::Relaxed)) {
                    if let Some(difference) = difference(sample) {
                        let key = (difference.weight, &sample.file, sample.place);
                        found.lock().expect("no panic").insert(key, difference);
                    }
                }
            });
        }
    });
    let found = found.into_inner().expect("no panic");
    found.into_values().collect()
}

fn difference(sample: &Sample) -> Option<Difference<'_>> {
    let report = catch_unwind(AssertUnwindSafe(|| {
        let (document, _) = read("a document", &sample.text, sample.format);
        check(&document)
    }));
    let Ok(report) = report else {
        let told = vec!["the verifier broke down\n".to_owned()];
        let (weight, found) = (Weight::Turned, None);
        return Some(Difference {
            sample,
            weight,
            found,
            told,
        });
    };
    let letters: Vec<char> = report.findings.iter().map(letter).collect();
    let mut weights = vec![];
    let mut told = vec![];
    if letters.len() != sample.expected.len() {
        weights.push(Weight::Lost);
        let (expected, found) = (sample.expected.len(), letters.len());
        told.push(format!("{expected} lines expected, {found} found\n"));
    }
    for (finding, expected) in report.findings.iter().zip(&sample.expected) {
        if !expected.contains(letter(finding)) {
            weights.push(weight(expected, letter(finding)));
            told.push(telling(expected, finding));
        }
    }
    let weight = weights.into_iter().min()?;
    let found = Some(letters.into_iter().collect());
    Some(Difference {
        sample,
        weight,
        found,
        told,
    })
}

fn letter(finding: &Finding) -> char {
    match finding.verdict {
        Verdict::Proved(_) => 'p',
        Verdict::Accepted => 'a',
        Verdict::Refuted => 'r',
        Verdict::Undecided => 'u',
        Verdict::Unreadable => '?',
    }
}

fn weight(expected: &str, found: char) -> Weight {
    let open = |letter| matches!(letter, 'u' | '?');
    match (expected, found) {
        ("p", 'r') | ("r", 'p') => Weight::Turned,
        (_, found) if open(found) => Weight::Lost,
        (expected, _) if expected.chars().all(open) => Weight::Gained,
        _ => Weight::Changed,
    }
}

fn telling(expected: &str, finding: &Finding) -> String {
    let names = expected.chars().map(|letter| match letter {
        'p' => "proved",
        'a' => "accepted",
        'r' => "refuted",
        'u' => "undecided",
        _ => "unreadable",
    });
    format!(
        "line {}: expected {}, got {}{}\n        {}\n",
        finding.source_line,
        names.collect::<Vec<_>>().join(" or "),
        finding.verdict.name(),
        finding
            .reason
            .as_ref()
            .map(|r| format!(" ({r})"))
            .unwrap_or_default(),
        finding.source.replace('\n', "\n        "),
    )
}

impl fmt::Display for Difference<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Sample {
            file,
            place,
            heading,
            ..
        } = self.sample;
        writeln!(
            f,
            "{}:{place}: {heading}: {:?}",
            file.display(),
            self.weight
        )?;
        self.told
            .iter()
            .try_for_each(|line| write!(f, "    {line}"))
    }
}

/// Writes verdicts beside a document. Letters in brackets stay where one of them was found.
fn write(sample: &Sample, found: &str) {
    let text = fs::read_to_string(&sample.file).expect("readable");
    let (fence, kind, _) = text
        .lines()
        .nth(sample.place - 1)
        .and_then(opening)
        .expect("a block");
    let letters = found
        .chars()
        .enumerate()
        .map(|(i, letter)| match sample.expected.get(i) {
            Some(any) if any.len() > 1 && any.contains(letter) => format!("[{any}]"),
            _ => letter.to_string(),
        });
    let letters = if found.is_empty() {
        "-".to_owned()
    } else {
        letters.collect()
    };
    let line = format!("{fence}{kind} {letters}");
    let mut lines: Vec<&str> = text.lines().collect();
    lines[sample.place - 1] = &line;
    fs::write(&sample.file, lines.join("\n") + "\n").expect("writable");
}

/// Three documents: a line that holds, one that does not, and one of which nothing is known.
const FILE: &str = "## Euler\n\n```markdown p\nOn principal axes\n\n$$ L_x = I_x\\omega_x $$\n```\n\n\
    ```diff [au]\n-$$ L_x = I_x\\omega_x $$\n+$$ L_x = 2 I_x\\omega_x $$\n```\n\n\
    ```diff -\n-$$ L_x = I_x\\omega_x $$\n```\n";

#[test]
fn a_wrong_verdict_would_be_seen() {
    let samples = samples_of(Path::new("here.md"), FILE);
    let texts: Vec<_> = samples.iter().map(|s| s.text.lines().last()).collect();
    assert_eq!(texts[0], Some("$$ L_x = I_x\\omega_x $$"));
    assert_eq!(texts[1], Some("$$ L_x = 2 I_x\\omega_x $$"));
    assert_eq!(samples[2].text, "On principal axes\n\n");
    let found = differences(&samples);
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].weight, Weight::Changed);
    let said = found[0].to_string();
    assert!(
        said.starts_with(
            "here.md:9: Euler: Changed\n    line 3: expected accepted or undecided, got refuted"
        ),
        "{said}"
    );
}

#[test]
fn every_file_has_documents() {
    let mut files: BTreeMap<PathBuf, usize> = BTreeMap::new();
    for sample in samples() {
        assert!(
            !sample.heading.is_empty(),
            "{:?}:{}",
            sample.file,
            sample.place
        );
        *files.entry(sample.file).or_default() += 1;
    }
    let all = fs::read_dir("tests/documents")
        .expect("the documents")
        .count();
    assert_eq!(files.len(), all, "a file without a document");
}
