//! Pages, gradebooks, classes marked in parts, and runs that go on after they were stopped.

use super::command::{class, grade, results};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

const HOSTILE: &[u8] = b"<script>alert(1)</script> <img src=x onerror=alert(1)>\n\n\
    $$M_x = \\href{javascript:alert(1)}{\\omega_x} \\text{<script>alert(2)</script>}$$\n\n$$M_x = \\omega_x$$\n";

fn example() -> [(&'static str, Vec<u8>); 4] {
    let read =
        |name: &str| fs::read(format!("examples/grading/submissions/{name}")).expect("the example");
    [
        ("ada.md", read("ada.md")),
        ("ben.md", read("ben.md")),
        ("cy.md", read("cy.md")),
        ("=1+1<b>.md", HOSTILE.to_vec()),
    ]
}

fn example_class() -> tempfile::TempDir {
    let files = example();
    let files: Vec<(&str, &[u8])> = files
        .iter()
        .map(|(name, text)| (*name, text.as_slice()))
        .collect();
    class(&files)
}

/// All files below a folder with their texts.
fn tree(folder: &Path) -> BTreeMap<String, String> {
    fn collect(at: &Path, root: &Path, found: &mut BTreeMap<String, String>) {
        for entry in fs::read_dir(at).expect("a folder") {
            let path = entry.expect("an entry").path();
            match path.is_dir() {
                true => collect(&path, root, found),
                false => {
                    let name = path
                        .strip_prefix(root)
                        .expect("below")
                        .to_string_lossy()
                        .into_owned();
                    found.insert(name, fs::read_to_string(&path).expect("text"));
                }
            }
        }
    }
    let mut found = BTreeMap::new();
    collect(folder, folder, &mut found);
    found
}

const ALL: &str = "--gradebook=csv,jsonl,gradescope,prairielearn,moodle,canvas,coderunner,points";

#[test]
fn pages_have_no_active_content() {
    let folder = example_class();
    assert_eq!(grade(folder.path(), &[ALL]).0, 3);
    let files = tree(&folder.path().join("out"));
    let pages: Vec<_> = files
        .iter()
        .filter(|(name, _)| name.ends_with(".html"))
        .collect();
    assert_eq!(pages.len(), 5, "{:?}", files.keys());
    for (name, page) in pages {
        let page = page.to_lowercase();
        for active in [
            "<script",
            "<img",
            "onerror=alert(1)>",
            "href=",
            "src=",
            "url(",
            "<iframe",
            "<object",
        ] {
            assert!(!page.contains(active), "{name} has {active}");
        }
        assert!(page.contains("default-src 'none'"), "{name}");
    }
    assert!(
        files["feedback/ben.html"].contains("<math"),
        "a formula is drawn"
    );
    assert!(files["feedback/ben.html"].contains("follows from an earlier slip"));
}

#[test]
fn gradebooks_have_the_fields_of_their_platforms() {
    let folder = example_class();
    assert_eq!(grade(folder.path(), &[ALL]).0, 3);
    let files = tree(&folder.path().join("out"));
    let parsed = |name: &str| -> Value { serde_json::from_str(&files[name]).expect("JSON") };
    assert_eq!(parsed("gradescope/ben/results.json")["score"], 5.0);
    assert_eq!(
        parsed("gradescope/ben/results.json")["tests"][3]["max_score"],
        2.0
    );
    assert_eq!(
        parsed("prairielearn/ben/results/results.json")["score"],
        0.625
    );
    assert_eq!(
        parsed("prairielearn/%3D1+1%253Cb%253E/results/results.json")["gradable"],
        false
    );
    assert_eq!(parsed("coderunner/ada.json")["fraction"], 1.0);
    assert_eq!(files["points/ben.txt"], "5\n");
    for table in ["marks.csv", "moodle.csv", "canvas.csv"] {
        let rows = files[table].lines();
        assert!(rows.clone().count() >= 5, "{table}");
        assert!(
            rows.into_iter()
                .all(|row| !row.starts_with(['=', '+', '@'])),
            "{}",
            files[table]
        );
    }
    assert!(
        files["canvas.csv"].lines().any(|row| row.contains("5.00")),
        "{}",
        files["canvas.csv"]
    );
    assert_eq!(files["marks.jsonl"].lines().count(), 4);
}

#[test]
fn feedback_may_be_held_back() {
    let folder = example_class();
    grade(folder.path(), &["--feedback", "marks"]);
    let page = fs::read_to_string(folder.path().join("out/feedback/ben.html")).expect("a page");
    assert!(!page.contains("The first slip") && !page.contains("<math"));
    grade(folder.path(), &["--feedback", "place"]);
    let page = fs::read_to_string(folder.path().join("out/feedback/ben.html")).expect("a page");
    assert!(page.contains("The first slip") && !page.contains("sign is wrong"));
}

#[test]
fn what_an_earlier_run_told_does_not_stand_beside_less() {
    let folder = example_class();
    let out = folder.path().join("out");
    let books = "moodle,gradescope,prairielearn,coderunner";
    let all = ["--feedback-format", "html,md,json", "--gradebook", books];
    grade(folder.path(), &all);
    let tells = |files: &BTreeMap<String, String>| {
        let mut texts = files.iter().filter(|(name, _)| {
            !["journal.jsonl", "results.json", "class.html"].contains(&name.as_str())
        });
        texts.any(|(_, text)| text.contains("sign is wrong") || text.contains("is refuted"))
    };
    assert!(tells(&tree(&out)));
    let before = tree(&out).into_keys().collect::<Vec<_>>();
    fs::write(out.join("feedback/zoe.html"), "of last year").expect("written");
    let (_, said) = grade(folder.path(), &["--feedback", "marks"]);
    assert!(said.contains("zoe"), "{said}");
    fs::remove_file(out.join("feedback/zoe.html")).expect("removed");
    assert_eq!(tree(&out).into_keys().collect::<Vec<_>>(), before);
    assert!(!tells(&tree(&out)));
    // Why work waits may tell what is wrong in it.
    let waits = &tree(&out)["prairielearn/%3D1+1%253Cb%253E/results/results.json"];
    assert!(
        waits.contains("\"a person will look at this work\""),
        "{waits}"
    );
}

#[test]
fn work_that_waits_has_no_points_yet() {
    let folder = example_class();
    grade(folder.path(), &["--gradebook", "points,coderunner"]);
    let files = tree(&folder.path().join("out"));
    let name = "%3D1+1%253Cb%253E";
    assert!(
        !files.contains_key(&format!("points/{name}.txt")),
        "{:?}",
        files.keys()
    );
    assert!(files[&format!("points/{name}.waits")].contains("no points yet"));
    let said = &files[&format!("coderunner/{name}.json")];
    assert!(said.contains("A person will look at this work"), "{said}");
    assert!(!files["coderunner/ben.json"].contains("prologuehtml"));
    // When it has some, that file goes.
    fs::write(folder.path().join("work/ben.md"), "nothing").expect("written");
    grade(folder.path(), &["--gradebook", "points"]);
    let files = tree(&folder.path().join("out"));
    assert!(!files.contains_key("points/ben.txt") && files.contains_key("points/ben.waits"));
}

#[test]
fn parts_put_together_are_the_whole() {
    let (whole, cut) = (example_class(), example_class());
    assert_eq!(grade(whole.path(), &[ALL]).0, 3);
    for part in ["1/3", "2/3"] {
        grade(cut.path(), &[ALL, "--shard", part]);
    }
    let merge = |folder: &Path| super::command::merge(folder, &[ALL]);
    let (code, said) = merge(cut.path());
    assert_eq!(code, 2, "{said}");
    grade(cut.path(), &[ALL, "--shard", "3/3"]);
    assert_eq!(merge(cut.path()).0, 3);
    let mut together = tree(&cut.path().join("out"));
    together.retain(|name, _| !name.starts_with("part-"));
    let mut once = tree(&whole.path().join("out"));
    once.remove("journal.jsonl");
    assert_eq!(together, once);
}

#[test]
fn a_run_that_was_stopped_goes_on() {
    let folder = example_class();
    assert_eq!(grade(folder.path(), &["--shard", "1/1"]).0, 3);
    let out = folder.path().join("out");
    let journal = fs::read_to_string(out.join("part-1-of-1.jsonl")).expect("a journal");
    let pages = || tree(&out.join("feedback"));
    let times = || {
        let pages = pages().into_keys().map(|page| {
            let found = fs::metadata(out.join("feedback").join(&page));
            (
                page,
                found.and_then(|found| found.modified()).expect("a time"),
            )
        });
        pages.collect::<Vec<_>>()
    };
    let before = times();
    // As if it had been killed in the middle of the third entry behind what the key said.
    let lines: Vec<&str> = journal.lines().collect();
    let cut = &lines[3][..lines[3].len() / 2];
    let whole = lines[..3].join("\n");
    fs::write(out.join("journal.jsonl"), format!("{whole}\n{cut}")).expect("written");
    assert_eq!(grade(folder.path(), &[]).0, 3);
    let results = results(folder.path());
    assert_eq!(results.matches("\"id\"").count(), 4, "{results}");
    let kept = before.iter().zip(times()).filter(|(a, b)| **a == *b);
    assert_eq!(kept.count(), 2, "the first two are not marked again");
    let journal = fs::read_to_string(out.join("journal.jsonl")).expect("a journal");
    assert_eq!(journal.lines().count(), 5);
}
