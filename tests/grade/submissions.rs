//! How work is handed in: archives, folders, names, and the roster.

use super::command::{class, grade, results};
use serde_json::Value;
use std::fs;
use std::io::{Cursor, Write};
use std::path::Path;
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

fn good() -> Vec<u8> {
    fs::read("examples/grading/submissions/ada.md").expect("the example")
}

/// A zip archive of these files.
pub(crate) fn zip(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut archive = ZipWriter::new(Cursor::new(vec![]));
    for (name, bytes) in files {
        archive
            .start_file(*name, SimpleFileOptions::default())
            .expect("a file begins");
        archive.write_all(bytes).expect("written");
    }
    archive.finish().expect("an archive").into_inner()
}

/// The results of a class of files, by the command with these options.
fn marked(files: &[(&str, &[u8])], options: &[&str]) -> Value {
    let folder = class(files);
    let (code, said) = grade(folder.path(), options);
    assert!(code == 0 || code == 3, "{said}");
    parsed(folder.path())
}

fn parsed(folder: &Path) -> Value {
    serde_json::from_str(&results(folder)).expect("JSON")
}

fn of<'v>(results: &'v Value, id: &str) -> &'v Value {
    let students = results["students"].as_array().expect("students");
    let found = students.iter().find(|s| s["id"] == id);
    found.unwrap_or_else(|| panic!("{id} is lost: {results}"))
}

fn queue(results: &Value, id: &str) -> String {
    of(results, id)["queue"].as_str().unwrap_or("").to_owned()
}

#[test]
fn an_archive_is_a_folder_of_files() {
    let good = good();
    let text = String::from_utf8(good.clone()).expect("text");
    let (first, second) = text.split_at(text.find("With the axes").expect("its middle"));
    let packed = zip(&[
        ("1.md", first.as_bytes()),
        ("part/2.md", second.as_bytes()),
        ("__MACOSX/1.md", b"\0"),
        (".DS_Store", b"\0"),
    ]);
    let folder = class(&[("ada.zip", &packed)]);
    assert_eq!(grade(folder.path(), &[]).0, 0);
    let results = parsed(folder.path());
    assert_eq!(of(&results, "ada")["marks"], 8.0, "{results}");
    let place = &of(&results, "ada")["milestones"][3];
    assert_eq!(place["file"], "part/2.md");
}

#[test]
fn the_class_may_come_as_one_archive() {
    let good = good();
    let inner = zip(&[("work.md", &good)]);
    let packed = zip(&[
        ("Ada_12/work.md", &good),
        ("Ben_13/work.zip", &inner),
        ("cy.md", &good),
        ("../../dan.md", &good),
    ]);
    let folder = class(&[]);
    fs::remove_dir(folder.path().join("work")).expect("removed");
    fs::write(folder.path().join("work"), packed).expect("written");
    let (code, said) = grade(folder.path(), &[]);
    assert_eq!(code, 3, "{said}");
    let results = parsed(folder.path());
    for id in ["Ada_12", "Ben_13", "cy"] {
        assert_eq!(of(&results, id)["marks"], 8.0, "{results}");
        assert_eq!(queue(&results, id), "");
    }
    let students = results["students"].as_array().expect("students");
    let out = students.iter().find(|s| {
        s["queue"]
            .as_str()
            .is_some_and(|why| why.contains("leads out of the archive"))
    });
    assert!(out.is_some_and(|s| s["marks"] == 0.0), "{results}");
}

#[test]
fn what_archives_hide_is_not_read() {
    let good = good();
    let mut linked = ZipWriter::new(Cursor::new(vec![]));
    linked
        .add_symlink("a.md", "/etc/hostname", SimpleFileOptions::default())
        .expect("a link");
    let linked = linked.finish().expect("an archive").into_inner();
    let out = zip(&[("good.md", &good), ("../../../tmp/polhode-out.md", &good)]);
    let nested = zip(&[("inner.zip", &zip(&[("a.md", &good)]))]);
    let many: Vec<String> = (0..1200).map(|n| format!("{n:04}.md")).collect();
    let many: Vec<(&str, &[u8])> = many.iter().map(|name| (name.as_str(), &b"x"[..])).collect();
    let many = zip(&many);
    let results = marked(
        &[
            ("linked.zip", &linked),
            ("out.zip", &out),
            ("nested.zip", &nested),
            ("many.zip", &many),
            ("torn.zip", &out[..out.len() / 2]),
            ("none.zip", b"no archive"),
            ("ada.md", &good),
        ],
        &[],
    );
    for (id, why) in [
        ("linked", "link"),
        ("out", "leads out of the archive"),
        ("nested", "archive in an archive"),
        ("many", "more than 1000 members"),
        ("torn", "can't be opened"),
        ("none", "can't be opened"),
    ] {
        assert!(queue(&results, id).contains(why), "{id}: {results}");
    }
    assert_eq!(of(&results, "ada")["marks"], 8.0);
    assert!(!Path::new("/tmp/polhode-out.md").exists());
}

#[test]
fn no_path_leads_out_of_an_archive() {
    let good = good();
    let outside = [
        "../a.md",
        "a/../../b.md",
        "/etc/passwd.md",
        "C:\\a.md",
        "..\\a.md",
        "a\0.md",
    ];
    let archives: Vec<_> = (0..)
        .zip(outside)
        .map(|(n, path)| (format!("out{n}.zip"), zip(&[(path, &good)])))
        .chain([("inside.zip".to_owned(), zip(&[("a/./b.md", &good)]))])
        .collect();
    let files: Vec<(&str, &[u8])> = archives
        .iter()
        .map(|(name, bytes)| (name.as_str(), bytes.as_slice()))
        .collect();
    let results = marked(&files, &[]);
    for (n, path) in outside.iter().enumerate() {
        let reason = queue(&results, &format!("out{n}"));
        assert!(
            reason.contains("leads out of the archive"),
            "{path}: {reason}"
        );
    }
    assert_eq!(of(&results, "inside")["marks"], 8.0);
}

#[test]
fn a_bomb_is_not_unpacked() {
    let good = good();
    let zeros = vec![b' '; 64 << 20];
    let bomb = zip(&[("a.md", &zeros), ("b.md", &zeros), ("good.md", &good)]);
    assert!(bomb.len() < 1 << 20, "{}", bomb.len());
    let start = std::time::Instant::now();
    let results = marked(&[("bomb.zip", &bomb), ("ada.md", &good)], &[]);
    assert!(start.elapsed().as_secs_f64() < 20.0);
    assert!(queue(&results, "bomb").contains("too large"), "{results}");
    assert_eq!(of(&results, "ada")["marks"], 8.0);
}

#[test]
fn a_pattern_finds_the_student_in_a_name() {
    let good = good();
    let text = String::from_utf8(good.clone()).expect("text");
    let (first, second) = text.split_at(text.find("With the axes").expect("its middle"));
    let files: [(&str, &[u8]); 4] = [
        ("lovelace_42_1_first.md", first.as_bytes()),
        ("lovelace_42_2_second.md", second.as_bytes()),
        ("babbage_43_9/work.md", &good),
        ("stray.md", &good),
    ];
    let results = marked(&files, &["--id-pattern", r"^[a-z]+_(\d+)_"]);
    assert_eq!(of(&results, "42")["marks"], 8.0, "{results}");
    assert_eq!(of(&results, "43")["marks"], 8.0, "{results}");
    assert_eq!(queue(&results, "42"), "");
    assert!(
        queue(&results, "stray").contains("--id-pattern"),
        "{results}"
    );
    let named = marked(&files, &["--id-pattern", r"^(?<name>[a-z]+)_(?<id>\d+)_"]);
    assert_eq!(of(&named, "42")["marks"], 8.0, "{named}");
}

#[test]
fn the_roster_tells_who_is_missing_and_who_is_unknown() {
    let good = good();
    let folder = class(&[("ada.md", &good), ("eve.md", &good)]);
    let roster = folder.path().join("roster.csv");
    fs::write(
        &roster,
        "Name,Username\r\n\"Lovelace, Ada\",ada\r\nBabbage,ben\r\n",
    )
    .expect("written");
    let roster = roster.to_string_lossy().into_owned();
    let (code, said) = grade(folder.path(), &["--roster", &roster]);
    assert_eq!(code, 3, "{said}");
    let results = parsed(folder.path());
    assert_eq!(results["missing"], serde_json::json!(["ben"]));
    assert_eq!(queue(&results, "ada"), "");
    assert!(queue(&results, "eve").contains("not on the roster"));
    let page = fs::read_to_string(folder.path().join("out/class.html")).expect("a page");
    assert!(page.contains("Who handed in nothing") && page.contains("<li>ben</li>"));
    let (code, said) = grade(folder.path(), &["--roster", "nowhere.csv"]);
    assert_eq!(code, 2);
    assert!(said.contains("nowhere.csv"), "{said}");
}

#[test]
fn a_file_of_a_gigabyte_is_not_read_to_its_end() {
    let folder = class(&[("ada.md", &good())]);
    let large = fs::File::create(folder.path().join("work/large.md")).expect("made");
    large.set_len(1 << 30).expect("a sparse file");
    let packed = fs::File::create(folder.path().join("work/packed.zip")).expect("made");
    packed.set_len(1 << 30).expect("a sparse file");
    let start = std::time::Instant::now();
    assert_eq!(grade(folder.path(), &[]).0, 3);
    assert!(start.elapsed().as_secs_f64() < 20.0);
    let results = parsed(folder.path());
    for id in ["large", "packed"] {
        assert!(queue(&results, id).contains("too large"), "{results}");
    }
    assert_eq!(of(&results, "ada")["marks"], 8.0);
}

#[test]
fn names_that_systems_keep_and_names_without_end_get_files_of_their_own() {
    let good = good();
    let long = format!("{}.md", "n".repeat(240));
    let folder = class(&[("con.md", &good), ("aux.x.md", &good), (&long, &good)]);
    assert_eq!(grade(folder.path(), &[]).0, 3);
    let results = parsed(folder.path());
    assert_eq!(results["students"].as_array().map(Vec::len), Some(3));
    let pages = fs::read_dir(folder.path().join("out/feedback")).expect("pages");
    let names = pages.map(|page| {
        page.expect("a page")
            .file_name()
            .to_string_lossy()
            .into_owned()
    });
    let names: Vec<String> = names.collect();
    assert_eq!(names.len(), 3);
    assert!(
        names
            .iter()
            .all(|name| name.len() < 200 && !name.starts_with("con.")),
        "{names:?}"
    );
}

/// Files are called by plain characters, and an id shows each character that hides or moves others.
#[cfg(unix)]
#[test]
fn a_name_hides_nothing_and_makes_no_path() {
    let good = good();
    let files: [(&str, &[u8]); 5] = [
        ("s017.md", &good),
        ("<script>.md", &good),
        ("a\\b.md", &good),
        ("a\u{202e}b.md", &good),
        ("a\nb.md", &good),
    ];
    let folder = class(&files);
    assert_eq!(grade(folder.path(), &[]).0, 3);
    let results = parsed(folder.path());
    let students = results["students"].as_array().expect("students");
    let ids = students.iter().map(|student| student["id"].as_str());
    let mut ids: Vec<&str> = ids.map(|id| id.expect("an id")).collect();
    ids.sort_unstable();
    assert_eq!(ids, ["%3Cscript%3E", "a%202Eb", "a%5Cb", "a%Ab", "s017"]);
    for page in fs::read_dir(folder.path().join("out/feedback")).expect("pages") {
        let name = page.expect("a page").file_name();
        let name = name.to_string_lossy();
        assert!(
            !name.contains(['/', '\\', '<', '>', '\n', '\u{202e}']),
            "{name}"
        );
    }
    assert!(folder.path().join("out/feedback/s017.html").exists());
}

#[test]
fn ids_that_look_alike_wait_for_a_person() {
    let good = good();
    let files: [(&str, &[u8]); 4] = [
        ("ada.md", &good),
        ("\u{430}da.md", &good),
        ("ben.md", &good),
        ("BEN.tex", b"nothing"),
    ];
    let results = marked(&files, &[]);
    assert!(queue(&results, "\u{430}da").contains("U+0430"), "{results}");
    for id in ["ben", "BEN"] {
        assert!(queue(&results, id).contains("in capitals alone"), "{id}");
    }
    assert_eq!(queue(&results, "ada"), "");
    assert_eq!(of(&results, "ada")["marks"], 8.0);
}

#[test]
fn an_accent_that_a_system_writes_in_another_way_is_the_same_student() {
    let good = good();
    let folder = class(&[("Jose\u{301}.md", &good)]);
    let roster = folder.path().join("roster.csv");
    fs::write(&roster, "id\nJos\u{e9}\n").expect("written");
    let roster = roster.to_string_lossy().into_owned();
    let (code, said) = grade(folder.path(), &["--roster", &roster]);
    assert_eq!(code, 0, "{said}");
    let results = parsed(folder.path());
    assert_eq!(of(&results, "Jos\u{e9}")["marks"], 8.0);
    assert_eq!(results["missing"], serde_json::json!([]));
}
