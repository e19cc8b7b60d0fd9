//! Feedback: what is told and what is held back, in every form; and pages in a browser.

use super::command::{class, grade};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const FORMS: &str = "--feedback-format=html,md,json";

/// A class of the example's second student, and of one who needs a person.
fn class_of_ben() -> tempfile::TempDir {
    let ben = fs::read("examples/grading/submissions/ben.md").expect("the example");
    let odd =
        b"Let $$\\eta = \\zeta$$ then $$M_x = \\eta$$ and ```a``` <script>alert(1)</script>\n\n\
        $$M_x = \\text{```</math><script>alert(2)</script>} + \\href{javascript:alert(3)}{x}$$\n";
    class(&[("ben.md", &ben), ("odd.md", odd)])
}

fn told(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join("out/feedback").join(name)).expect("feedback")
}

#[test]
fn a_slip_is_named_and_put_right_in_every_form() {
    let folder = class_of_ben();
    grade(folder.path(), &[FORMS]);
    let page = told(folder.path(), "ben.html");
    let markdown = told(folder.path(), "ben.md");
    for text in [&page, &markdown] {
        assert!(
            text.contains("The first slip") && text.contains("It is in line 6."),
            "{text}"
        );
        assert!(
            text.contains("sign is wrong") && text.contains("Write instead"),
            "{text}"
        );
        assert!(text.contains("the left side is"), "{text}");
    }
    assert!(
        markdown.contains("```math\nL_z = I_{zz}\\omega_z - I_{xz}\\omega_x\n```"),
        "{markdown}"
    );
    let json: Value = serde_json::from_str(&told(folder.path(), "ben.json")).expect("JSON");
    assert_eq!(json["schema"], "polhode-feedback/1");
    assert_eq!(json["marks"], 5.0);
    assert_eq!(
        json["lines"][4]["repair"],
        "L_z = I_{zz}\\omega_z - I_{xz}\\omega_x"
    );
}

/// The numbers beside a false line are the numbers of that line: put in, they give what is said of its sides.
#[test]
fn the_numbers_give_what_is_said_of_both_sides() {
    let folder = class_of_ben();
    grade(folder.path(), &[FORMS]);
    let json: Value = serde_json::from_str(&told(folder.path(), "ben.json")).expect("JSON");
    let numbers = &json["lines"][4]["counterexample"];
    let of = |value: &Value| -> f64 {
        value
            .as_str()
            .and_then(|v| v.parse().ok())
            .expect("a number")
    };
    let symbol = |name: &str| of(&numbers["symbols"][name]);
    let right = symbol("I_{zz}") * symbol("\\omega_z") + symbol("I_{xz}") * symbol("\\omega_x");
    assert!(
        (of(&numbers["left"]) - symbol("L_z")).abs() < 1e-12,
        "{numbers}"
    );
    assert!((of(&numbers["right"]) - right).abs() < 1e-12, "{numbers}");
    assert_ne!(numbers["left"], numbers["right"]);
}

#[test]
fn what_is_held_back_stands_in_no_form() {
    let folder = class_of_ben();
    let books = "--gradebook=gradescope,prairielearn,moodle,coderunner";
    for (detail, hidden) in [
        ("place", &["sign", "Write instead", "the left side"][..]),
        (
            "marks",
            &[
                "sign",
                "Write instead",
                "the left side",
                "line 6",
                "refuted",
                "I_{zz}",
            ][..],
        ),
    ] {
        let code = grade(folder.path(), &[FORMS, books, "--feedback", detail]).0;
        assert_eq!(code, 3);
        let mut texts: Vec<String> = ["ben.html", "ben.md", "ben.json"]
            .iter()
            .map(|name| told(folder.path(), name))
            .collect();
        for book in [
            "gradescope/ben/results.json",
            "prairielearn/ben/results/results.json",
            "coderunner/ben.json",
            "moodle.csv",
        ] {
            let path = folder.path().join("out").join(book);
            texts.push(fs::read_to_string(path).expect("a gradebook"));
        }
        for (text, hidden) in texts
            .iter()
            .flat_map(|t| hidden.iter().map(move |h| (t, h)))
        {
            let text = text.lines().filter(|line| !line.starts_with("odd,"));
            let text: String = text.collect();
            assert!(!text.contains(hidden), "{detail} tells {hidden}: {text}");
        }
    }
}

#[test]
fn markdown_has_no_active_content() {
    let folder = class_of_ben();
    grade(folder.path(), &[FORMS]);
    let text = told(folder.path(), "odd.md");
    let mut fence: Option<usize> = None;
    let mut drawn = false;
    for line in text.lines() {
        let ticks = line.chars().take_while(|c| *c == '`').count();
        match fence {
            None if ticks >= 3 => (fence, drawn) = (Some(ticks), line.ends_with("math")),
            Some(open) if ticks >= open && line.chars().all(|c| c == '`') => fence = None,
            None => assert!(
                !line.contains("<script") && !line.contains("](javascript:"),
                "{line}"
            ),
            // What a platform draws may not have a link in it.
            Some(_) => assert!(!drawn || !line.contains("\\href"), "{line}"),
        }
    }
    assert_eq!(fence, None, "{text}");
    assert!(text.contains("\\href"), "{text}");
}

#[test]
fn a_check_is_a_page_too() {
    let folder = class_of_ben();
    let page = folder.path().join("page.html");
    let output = Command::new(env!("CARGO_BIN_EXE_polhode"))
        .args(["check", "--format", "html", "--out"])
        .arg(&page)
        .arg(folder.path().join("key.md"))
        .output()
        .expect("the command runs");
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let page = fs::read_to_string(page).expect("a page");
    assert!(page.contains("default-src 'none'") && page.contains("<math"));
    assert!(
        page.contains(": holds") && !page.contains("marks"),
        "{page}"
    );
}

/// A browser of the Chromium family, where there is one.
fn browser() -> Option<PathBuf> {
    let names = ["chromium", "chromium-browser", "google-chrome", "chrome"];
    let path = std::env::var_os("PATH")?;
    let folders: Vec<PathBuf> = std::env::split_paths(&path).collect();
    let mut found = folders
        .iter()
        .flat_map(|folder| names.map(|name| folder.join(name)));
    found.find(|file| file.is_file())
}

#[test]
fn a_browser_finds_nothing_wrong_with_pages_and_loads_nothing() {
    let Some(browser) = browser() else {
        println!("there is no Chromium here; nothing was tried");
        return;
    };
    let folder = class_of_ben();
    grade(folder.path(), &[FORMS]);
    let out = folder.path().join("out");
    for page in ["feedback/ben.html", "feedback/odd.html", "class.html"] {
        let log = folder.path().join("net.json");
        let output = Command::new(&browser)
            .args([
                "--headless=new",
                "--no-sandbox",
                "--disable-gpu",
                "--disable-background-networking",
                "--disable-component-update",
                "--disable-sync",
                "--no-first-run",
                "--enable-logging=stderr",
                "--dump-dom",
            ])
            .arg(format!(
                "--user-data-dir={}",
                folder.path().join("profile").display()
            ))
            .arg(format!("--log-net-log={}", log.display()))
            .arg(format!("file://{}", out.join(page).display()))
            .output()
            .expect("the browser runs");
        let (shown, said) = (
            String::from_utf8_lossy(&output.stdout),
            String::from_utf8_lossy(&output.stderr),
        );
        assert!(shown.contains("</html>"), "{page}: {said}");
        assert!(!said.contains("CONSOLE"), "{page}: {said}");
        let log = fs::read_to_string(&log).expect("a log of requests");
        let asked = log.split("\"url\":\"").skip(1);
        let asked: Vec<&str> = asked.filter_map(|rest| rest.split('"').next()).collect();
        let mut left = asked.iter().filter(|url| {
            // What the browser asks for itself is no request of the page.
            url.starts_with("http") && !url.contains("google") && !url.contains("gstatic")
        });
        assert_eq!(left.next(), None, "{page}");
    }
}
