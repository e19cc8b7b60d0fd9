//! Runs that are stopped, that find no room, or that are done again.

use super::command::{class, grade, results};
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

fn many(students: usize) -> tempfile::TempDir {
    let names: Vec<String> = (0..students).map(|n| format!("s{n:03}.md")).collect();
    let texts: Vec<Vec<u8>> = ["ada.md", "ben.md", "cy.md"]
        .iter()
        .map(|name| fs::read(format!("examples/grading/submissions/{name}")).expect("the example"))
        .collect();
    let files: Vec<(&str, &[u8])> = names
        .iter()
        .enumerate()
        .map(|(at, name)| (name.as_str(), texts[at % 3].as_slice()))
        .collect();
    class(&files)
}

fn journal(folder: &Path) -> String {
    fs::read_to_string(folder.join("out/journal.jsonl")).unwrap_or_default()
}

#[test]
fn the_journal_is_the_same_on_any_number_of_threads() {
    let seen = ["1", "3"].map(|threads| {
        let folder = many(20);
        assert_eq!(grade(folder.path(), &["--threads", threads]).0, 0);
        journal(folder.path())
    });
    // Before the students stands what the key said.
    assert_eq!(seen[0].lines().count(), 21);
    assert_eq!(seen[0], seen[1]);
}

#[cfg(unix)]
#[test]
fn a_run_that_is_killed_loses_nothing_and_goes_on() {
    let (whole, cut) = (many(120), many(120));
    assert_eq!(grade(whole.path(), &[]).0, 0);
    let path = |name: &str| cut.path().join(name);
    let mut child = Command::new(env!("CARGO_BIN_EXE_polhode"))
        .arg("grade")
        .args([path("key.md"), path("work")])
        .arg("--out")
        .arg(path("out"))
        .args(["--threads", "1"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the command runs");
    // SIGKILL as soon as some are marked.
    let begun = std::time::Instant::now();
    while journal(cut.path()).lines().count() < 5 && begun.elapsed().as_secs() < 60 {
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    child.kill().expect("killed");
    child.wait().expect("ended");
    let kept = journal(cut.path()).lines().count();
    println!("{kept} of 120 were marked when it was killed");
    assert!((5..120).contains(&kept), "{kept}");
    assert!(!path("out/results.json").exists());
    assert_eq!(grade(cut.path(), &[]).0, 0);
    assert_eq!(results(cut.path()), results(whole.path()));
    assert_eq!(journal(cut.path()), journal(whole.path()));
    assert_eq!(pages(cut.path()), pages(whole.path()));
}

/// The names of all files in the folder of pages.
fn pages(folder: &Path) -> Vec<std::ffi::OsString> {
    let files = fs::read_dir(folder.join("out/feedback")).expect("pages");
    let mut names: Vec<_> = files
        .map(|file| file.expect("a page").file_name())
        .collect();
    names.sort();
    names
}

#[test]
fn a_page_that_was_under_way_in_a_killed_run_is_gone_after_the_next_one() {
    let folder = many(3);
    let left = folder.path().join("out/feedback/.s001.html.part");
    fs::create_dir_all(folder.path().join("out/feedback")).expect("made");
    fs::write(&left, "half a page").expect("written");
    assert_eq!(grade(folder.path(), &[]).0, 0);
    assert_eq!(
        pages(folder.path()),
        ["s000.html", "s001.html", "s002.html"]
    );
    let page = fs::read_to_string(folder.path().join("out/feedback/s001.html"));
    assert!(page.expect("a page").trim_end().ends_with("</html>"));
}

#[cfg(unix)]
#[test]
fn a_folder_that_cannot_be_written_is_an_error_with_its_name() {
    let folder = many(3);
    // A file stands where the folder of results should be made.
    fs::write(folder.path().join("out"), "in the way").expect("written");
    let (code, said) = grade(folder.path(), &[]);
    assert_eq!(code, 2);
    assert!(said.contains("out"), "{said}");
    fs::remove_file(folder.path().join("out")).expect("removed");
    // The pages can't be written; the marks that were given before stay.
    fs::create_dir(folder.path().join("out")).expect("made");
    fs::write(folder.path().join("out/feedback"), "in the way").expect("written");
    let (code, said) = grade(folder.path(), &[]);
    assert_eq!(code, 2);
    assert!(said.contains("feedback"), "{said}");
    fs::remove_file(folder.path().join("out/feedback")).expect("removed");
    assert_eq!(grade(folder.path(), &[]).0, 0);
}

/// A limit on the size of files is what a full disk looks like to a program: a write that fails in its middle.
#[cfg(unix)]
#[test]
fn a_full_disk_is_an_error_and_the_next_run_goes_on() {
    let (whole, cut) = (many(60), many(60));
    assert_eq!(grade(whole.path(), &[]).0, 0);
    let path = |name: &str| cut.path().join(name).to_string_lossy().into_owned();
    let script = format!(
        "trap '' XFSZ; ulimit -f 16; exec {} grade {} {} --out {} --threads 1",
        env!("CARGO_BIN_EXE_polhode"),
        path("key.md"),
        path("work"),
        path("out")
    );
    let output = Command::new("bash")
        .args(["-c", &script])
        .output()
        .expect("bash runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(
        said.contains("too large") || said.contains("space"),
        "{said}"
    );
    assert!(!journal(cut.path()).is_empty());
    assert_eq!(grade(cut.path(), &[]).0, 0);
    assert_eq!(results(cut.path()), results(whole.path()));
    assert_eq!(journal(cut.path()), journal(whole.path()));
}

#[test]
fn a_later_run_marks_only_what_changed() {
    let folder = many(3);
    assert_eq!(grade(folder.path(), &[]).0, 0);
    let page = |name: &str| folder.path().join("out/feedback").join(name);
    let stamp = |name: &str| {
        fs::metadata(page(name))
            .and_then(|m| m.modified())
            .expect("a time")
    };
    let before = stamp("s001.html");
    fs::remove_file(page("s002.html")).expect("removed");
    fs::write(folder.path().join("work/s000.md"), "nothing").expect("written");
    assert_eq!(grade(folder.path(), &[]).0, 3);
    assert!(page("s002.html").is_file());
    assert_eq!(stamp("s001.html"), before);
    assert!(results(folder.path()).contains("\"id\": \"s000\",\n      \"marks\": 0.0"));
}

#[test]
fn an_answer_for_one_student_changes_no_other() {
    let law =
        "In rotating axes $$\\vec M = (\\dot{\\vec L})_{xyz} + \\vec\\omega\\times\\vec L.$$\n";
    let own =
        format!("{law}$$\\vec M = (\\dot{{\\vec H}})_{{xyz}} + \\vec\\omega\\times\\vec H$$\n");
    let folder = class(&[("ada.md", own.as_bytes()), ("ben.md", own.as_bytes())]);
    assert_eq!(grade(folder.path(), &[]).0, 3);
    let page = fs::read_to_string(folder.path().join("out/class.html")).expect("a page");
    assert!(page.contains("It stands in 2 submissions"), "{page}");
    let answers = folder.path().join("answers");
    fs::create_dir(&answers).expect("made");
    let said =
        "# asked by mail\n$\\vec H$ is the angular momentum of the rotor about G relative to N.\n";
    fs::write(answers.join("ada.txt"), said).expect("written");
    let answers = answers.to_string_lossy().into_owned();
    grade(folder.path(), &["--answers", &answers]);
    let page = fs::read_to_string(folder.path().join("out/class.html")).expect("a page");
    assert!(page.contains("It stands in 1 submission;"), "{page}");
    let unclear = folder.path().join("answers/ben.txt");
    fs::write(unclear, "It is what it is.\n").expect("written");
    grade(folder.path(), &["--answers", &answers]);
    assert!(results(folder.path()).contains("an answer is not understood"));
}

/// When each file was written that has the marks of a student.
fn written(folder: &Path, id: &str) -> std::time::SystemTime {
    let page = folder.join(format!("out/feedback/{id}.html"));
    let time = fs::metadata(page).and_then(|page| page.modified());
    time.expect("a time")
}

#[test]
fn an_answer_in_the_key_marks_anew_only_what_it_touches() {
    let law = |letter: &str| {
        let law = "$$\\vec M = (\\dot{\\vec L})_{xyz} + \\vec\\omega\\times\\vec L$$\n";
        law.replace('L', letter)
    };
    let files = [("ada.md", law("H")), ("ben.md", law("L"))];
    let files = files
        .each_ref()
        .map(|(name, text)| (*name, text.as_bytes()));
    let (folder, fresh) = (class(&files), class(&files));
    assert_eq!(grade(folder.path(), &[]).0, 3);
    let before = ["ada", "ben"].map(|id| written(folder.path(), id));
    let key = |letter: &str, of: &str| {
        let answer = format!("- ${letter}$ is the angular momentum of the rotor {of}.\n---\n\n#");
        super::KEY.replace("---\n\n#", &answer)
    };
    let told = key("\\vec H", "about G relative to N");
    for place in [&folder, &fresh] {
        fs::write(place.path().join("key.md"), &told).expect("written");
        assert_eq!(grade(place.path(), &[]).0, 0);
    }
    assert!(written(folder.path(), "ada") > before[0]);
    assert_eq!(written(folder.path(), "ben"), before[1]);
    // As if all were marked anew.
    assert_eq!(results(folder.path()), results(fresh.path()));
    assert_eq!(journal(folder.path()), journal(fresh.path()));
    // What is said of a letter that stands in other sentences, or of one that all write, touches all.
    for told in [
        key("\\vec H", "about G relative to N").replace("\\vec H", "\\vec M"),
        super::KEY.replace("mass centre", "centre of mass"),
        super::KEY.replace("\"(5)\": 2", "\"(5)\": 4"),
    ] {
        fs::write(folder.path().join("key.md"), &told).expect("written");
        let before = written(folder.path(), "ben");
        if grade(folder.path(), &[]).0 != 2 {
            assert!(written(folder.path(), "ben") > before, "{told}");
        }
    }
}

#[test]
fn a_line_of_the_journal_that_was_changed_does_not_count() {
    let folder = many(3);
    assert_eq!(grade(folder.path(), &[]).0, 0);
    let (right, whole) = (results(folder.path()), journal(folder.path()));
    let lines: Vec<&str> = whole.lines().collect();
    // Ben has five marks; what another run wrote into his line is JSON all the same.
    let other = lines[2].replacen("\"marks\":5.0", "\"marks\":8.0", 1);
    let other = match other == lines[2] {
        true => lines[2].replacen("\"marks\":5000", "\"marks\":8000", 1),
        false => other,
    };
    assert_ne!(other, lines[2]);
    let spliced = format!("{}\n{}\n{other}\n{}\n", lines[0], lines[1], lines[3]);
    fs::write(folder.path().join("out/journal.jsonl"), spliced).expect("written");
    assert_eq!(grade(folder.path(), &[]).0, 0);
    assert_eq!(results(folder.path()), right);
    assert_eq!(journal(folder.path()), whole);
}

#[test]
fn two_runs_at_once_do_not_write_into_one_folder() {
    let folder = many(2);
    let out = folder.path().join("out");
    fs::create_dir(&out).expect("made");
    let lock = fs::File::create(out.join(".lock")).expect("made");
    lock.lock().expect("held");
    for more in [&[][..], &["--shard", "1/2"]] {
        let (code, said) = grade(folder.path(), more);
        assert_eq!(code, 2, "{said}");
        assert!(
            said.contains("another run") && said.contains("--out"),
            "{said}"
        );
        assert!(journal(folder.path()).is_empty());
    }
    // Parts go on beside each other, and none beside itself.
    lock.unlock().expect("free");
    lock.lock_shared().expect("held");
    let own = fs::File::create(out.join("part-1-of-2.lock")).expect("made");
    own.lock().expect("held");
    assert_eq!(grade(folder.path(), &["--shard", "1/2"]).0, 2);
    assert_eq!(grade(folder.path(), &["--shard", "2/2"]).0, 0);
    assert_eq!(super::command::merge(folder.path(), &[]).0, 2);
    // What a killed run leaves is held by nobody.
    drop((lock, own));
    assert_eq!(grade(folder.path(), &["--shard", "1/2"]).0, 0);
    assert_eq!(super::command::merge(folder.path(), &[]).0, 0);
}
