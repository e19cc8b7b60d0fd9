//! Gradebooks: the marks of a class in the forms that teaching platforms take.
//!
//! Platforms that mark one submission at a time get a file for each student, in the folder that they look into. No cell
//! of a table begins as a formula of a spreadsheet does.

use crate::grade::{Graded, Key, Outcome, Reached};
use crate::report::grade::told::{Detail, told};
use serde_json::{Value, json};
use std::ops::Deref;

/// A form of a gradebook.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Form {
    /// A table with a row for each student and a column for each milestone.
    Csv,
    /// One JSON object a line.
    Jsonl,
    /// `results.json` of an autograder of Gradescope.
    Gradescope,
    /// `results/results.json` of an external grader of PrairieLearn.
    Prairielearn,
    /// A table for the gradebook of Moodle.
    Moodle,
    /// A table for the gradebook of Canvas.
    Canvas,
    /// What a combinator template grader of CodeRunner prints.
    Coderunner,
    /// The points as a number alone, as nbgrader and otter-grader take them.
    Points,
}

impl Form {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Csv,
        Self::Jsonl,
        Self::Gradescope,
        Self::Prairielearn,
        Self::Moodle,
        Self::Canvas,
        Self::Coderunner,
        Self::Points,
    ];

    /// The file of the class, or the folder with a file for each student, below the folder of results.
    pub fn place(self) -> &'static str {
        match self {
            Self::Csv => "marks.csv",
            Self::Jsonl => "marks.jsonl",
            Self::Gradescope => "gradescope",
            Self::Prairielearn => "prairielearn",
            Self::Moodle => "moodle.csv",
            Self::Canvas => "canvas.csv",
            Self::Coderunner => "coderunner",
            Self::Points => "points",
        }
    }
}

/// A file of a gradebook.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Its path below the folder of results, with slashes.
    pub path: String,
    /// Its text.
    pub text: String,
}

/// The file of one student, of what is told; none for a form that is a table of the class. `stem` names the student in
/// paths, and `page` is the student's page as Markdown.
pub fn of_student(
    form: Form,
    key: &Key,
    graded: &Graded,
    stem: &str,
    page: &impl Deref<Target = String>,
) -> Option<File> {
    let (path, value) = match form {
        Form::Gradescope => (
            format!("gradescope/{stem}/results.json"),
            gradescope(graded, page),
        ),
        Form::Prairielearn => (
            format!("prairielearn/{stem}/results/results.json"),
            prairielearn(key, graded),
        ),
        Form::Coderunner => (format!("coderunner/{stem}.json"), coderunner(key, graded)),
        Form::Points => {
            let [done, waiting] = points(stem);
            return Some(match &graded.queue {
                None => File {
                    path: done,
                    text: format!("{}\n", graded.marks),
                },
                // A number would be taken for the grade.
                Some(_) => File {
                    path: waiting,
                    text: "a person will look at this work; it has no points yet\n".to_owned(),
                },
            });
        }
        Form::Csv | Form::Jsonl | Form::Moodle | Form::Canvas => return None,
    };
    let text = serde_json::to_string_pretty(&value).unwrap_or_default() + "\n";
    Some(File { path, text })
}

/// Where the points of a student stand, and where it stands that there are none yet.
fn points(stem: &str) -> [String; 2] {
    [format!("points/{stem}.txt"), format!("points/{stem}.waits")]
}

/// The files of a student in another state, which must not stand beside those of this one.
pub fn outdated(form: Form, graded: &Graded, stem: &str) -> Option<String> {
    let [done, waiting] = points(stem);
    let other = match graded.queue {
        None => waiting,
        Some(_) => done,
    };
    (form == Form::Points).then_some(other)
}

/// The file of a class with no student in it yet; none for a form with a file for each student.
pub fn head_of_class(form: Form, key: &Key) -> Option<File> {
    let text = match form {
        Form::Csv => {
            let labels = key.milestones().map(|(label, _)| label.to_owned());
            let head = ["student", "marks", "max"].map(str::to_owned).into_iter();
            let titles = head.chain(labels).chain(["queue".to_owned()]);
            row(titles)
        }
        Form::Jsonl => String::new(),
        Form::Moodle => {
            let titles = ["Username", "Grade", "Feedback"].map(str::to_owned);
            row(titles)
        }
        Form::Canvas => canvas_head(key),
        _ => return None,
    };
    Some(File {
        path: form.place().to_owned(),
        text,
    })
}

/// The row of one student in the file of a class. A table that students see has what they are told.
pub fn row_of_class(form: Form, key: &Key, student: &Graded, detail: Detail) -> String {
    match form {
        Form::Csv => marks(key, student),
        Form::Jsonl => line(key, student),
        Form::Moodle => moodle(student, detail),
        Form::Canvas => canvas(student),
        _ => String::new(),
    }
}

/// A cell of a table: in quotes where it must be, and never a formula.
pub(super) fn cell(text: &str) -> String {
    let harmless = match text
        .trim_start()
        .starts_with(['=', '+', '-', '@', '\t', '\r', '|', '%'])
    {
        true => format!("'{text}"),
        false => text.to_owned(),
    };
    let harmless = harmless.replace(['\n', '\r', '\t', '\0'], " ");
    match harmless.contains([',', '"', ';', '\'']) {
        true => format!("\"{}\"", harmless.replace('"', "\"\"")),
        false => harmless,
    }
}

fn row(cells: impl IntoIterator<Item = String>) -> String {
    let cells: Vec<String> = cells.into_iter().map(|text| cell(&text)).collect();
    cells.join(",") + "\n"
}

fn marks(key: &Key, student: &Graded) -> String {
    let own = [
        student.id.clone(),
        student.marks.to_string(),
        key.max().to_string(),
    ];
    let each = student.milestones.iter().map(|m| m.marks.to_string());
    let queue = student.queue.clone().unwrap_or_default();
    row(own.into_iter().chain(each).chain([queue]))
}

fn line(key: &Key, student: &Graded) -> String {
    let each = student.milestones.iter();
    let each: serde_json::Map<String, Value> = each
        .map(|m| (m.label.clone(), json!(m.marks.to_f64())))
        .collect();
    let line = json!({
        "student": student.id, "marks": student.marks.to_f64(), "max": key.max().to_f64(),
        "milestones": each, "queue": student.queue,
    });
    line.to_string() + "\n"
}

/// A student who waits for a person has no grade yet.
fn moodle(student: &Graded, detail: Detail) -> String {
    let grade = match student.queue {
        Some(_) => "-".to_owned(),
        None => student.marks.to_string(),
    };
    // A lone hyphen is no formula; Moodle takes it for no grade.
    let cells = [
        cell(&student.id),
        grade,
        cell(&feedback(&told(student, detail))),
    ];
    cells.join(",") + "\n"
}

fn canvas_head(key: &Key) -> String {
    let title = key
        .name
        .rsplit_once('.')
        .map_or(key.name.as_str(), |(stem, _)| stem);
    let head = [
        "Student",
        "ID",
        "SIS User ID",
        "SIS Login ID",
        "Section",
        title,
    ]
    .map(str::to_owned);
    let most = key.max().to_f64();
    row(head) + &format!("    Points Possible,,,,,{most:.2}\n")
}

fn canvas(student: &Graded) -> String {
    let grade = match student.queue {
        Some(_) => String::new(),
        None => format!("{:.2}", student.marks.to_f64()),
    };
    let id = student.id.as_str();
    row([id, "", "", id, "", &grade].map(str::to_owned))
}

/// What is told of the milestones, as the text of a page.
pub(super) fn feedback(told: &Graded) -> String {
    let each = told.milestones.iter().map(|m| match m.reason.as_str() {
        "" => format!("{}: {} of {}", m.label, m.marks, m.max),
        reason => format!("{}: {} of {}, {reason}", m.label, m.marks, m.max),
    });
    let text = each.collect::<Vec<_>>().join("; ");
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

fn gradescope(graded: &Graded, page: &str) -> Value {
    let test = |(at, m): (usize, &Reached)| {
        json!({
            "name": m.label, "name_format": "text", "number": (at + 1).to_string(),
            "score": m.marks.to_f64(), "max_score": m.max.to_f64(),
            "status": if m.outcome == Outcome::Full { "passed" } else { "failed" },
            "output": m.reason, "output_format": "text",
        })
    };
    let tests: Vec<Value> = graded.milestones.iter().enumerate().map(test).collect();
    json!({
        "score": graded.marks.to_f64(), "output": page, "output_format": "md",
        "stdout_visibility": "hidden", "tests": tests,
    })
}

fn prairielearn(key: &Key, graded: &Graded) -> Value {
    let test = |m: &Reached| json!({"name": m.label, "points": m.marks.to_f64(), "max_points": m.max.to_f64(), "message": m.reason});
    let tests: Vec<Value> = graded.milestones.iter().map(test).collect();
    match &graded.queue {
        // Work that could not be marked costs no attempt.
        Some(reason) => json!({"gradable": false, "format_errors": [reason], "tests": tests}),
        None => json!({
            "gradable": true, "score": part(key, graded), "output": output(key, graded), "tests": tests,
        }),
    }
}

fn coderunner(key: &Key, graded: &Graded) -> Value {
    let mut table = vec![json!(["iscorrect", "Milestone", "Marks", "Result"])];
    table.extend(graded.milestones.iter().map(|m| {
        let marks = format!("{} of {}", m.marks, m.max);
        json!([m.outcome == Outcome::Full, m.label, marks, m.reason])
    }));
    let mut result = json!({
        "fraction": part(key, graded), "testresults": table, "columnformats": ["%s", "%s", "%s"],
    });
    if graded.queue.is_some() {
        let waits = "<p>A person will look at this work; these are not its marks yet.</p>";
        result["prologuehtml"] = json!(waits);
    }
    result
}

/// The part of all marks, from 0 to 1.
fn part(key: &Key, graded: &Graded) -> f64 {
    let most = key.max().to_f64();
    if most > 0.0 {
        (graded.marks.to_f64() / most).min(1.0)
    } else {
        0.0
    }
}

fn output(key: &Key, graded: &Graded) -> String {
    let waits = if graded.queue.is_some() {
        "; a person will look at it"
    } else {
        ""
    };
    format!("{} of {}{waits}", graded.marks, key.max())
}
