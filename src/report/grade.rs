//! What is shown of a class that was marked: `results.json`, a page for each student, one of the class, and gradebooks.

pub mod class;
pub mod gradebook;
pub mod markdown;
pub mod page;
pub mod table;
pub mod told;
pub mod worksheet;

use crate::grade::{Assumption, Graded, Key, Line, Marks, Place, Reached, Slip};
use serde::{Serialize, Serializer};
use std::cell::Cell;
use std::collections::BTreeMap;
use std::io::{self, Write};

/// Writes the results of a class as one JSON object (schema `polhode-grade/1`), with a line break at its end. Where there is
/// a roster, `missing` has those on it who handed in nothing.
///
/// # Errors
///
/// Those of the writer.
pub fn results(
    key: &Key,
    students: impl IntoIterator<Item = Graded>,
    missing: Option<&[String]>,
    mut to: impl Write,
) -> io::Result<()> {
    let form = Form {
        schema: "polhode-grade/1",
        key: &key.name,
        max: Shortest(key.max()),
        students: Students(Cell::new(Some(students.into_iter()))),
        missing,
    };
    serde_json::to_writer_pretty(&mut to, &form)?;
    to.write_all(b"\n")
}

/// Students, each made into JSON when it is written. They are written once.
struct Students<I>(Cell<Option<I>>);

impl<I: Iterator<Item = Graded>> Serialize for Students<I> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.take().into_iter().flatten().map(Student))
    }
}

struct Student(Graded);

impl Serialize for Student {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        StudentForm::of(&self.0).serialize(serializer)
    }
}

/// What one student is told, as one JSON object, with a line break at its end.
///
/// # Errors
///
/// None that a submission could cause; the type is that of the serialiser.
pub fn student(key: &Key, told: &Graded) -> serde_json::Result<String> {
    let form = ToldForm {
        schema: "polhode-feedback/1",
        max: Shortest(key.max()),
        student: StudentForm {
            queue: told
                .queue
                .as_ref()
                .map(|_| "a person will look at this work"),
            ..StudentForm::of(told)
        },
        notes: &told.notes,
        lines: told.lines.iter().map(LineForm::of).collect(),
    };
    serde_json::to_string_pretty(&form).map(|text| text + "\n")
}

#[derive(Serialize)]
struct ToldForm<'a> {
    schema: &'static str,
    max: Shortest,
    #[serde(flatten)]
    student: StudentForm<'a>,
    notes: &'a [String],
    lines: Vec<LineForm<'a>>,
}

#[derive(Serialize)]
struct LineForm<'a> {
    #[serde(flatten)]
    place: PlaceForm<'a>,
    source: &'a str,
    verdict: &'a str,
    carried: bool,
    reason: Option<&'a str>,
    mistake: Option<&'a str>,
    repair: Option<&'a str>,
    counterexample: Option<NumbersForm<'a>>,
}

#[derive(Serialize)]
struct NumbersForm<'a> {
    symbols: BTreeMap<&'a str, &'a str>,
    component: Option<&'a str>,
    left: &'a str,
    right: &'a str,
}

impl<'a> LineForm<'a> {
    fn of(line: &'a Line) -> Self {
        let numbers = line.counterexample.as_ref().map(|numbers| {
            let symbols = numbers.symbols.iter();
            NumbersForm {
                symbols: symbols.map(|(s, v)| (s.as_str(), v.as_str())).collect(),
                component: numbers.component.as_deref(),
                left: &numbers.left,
                right: &numbers.right,
            }
        });
        Self {
            place: PlaceForm::of(Some(&line.place)),
            source: &line.source,
            verdict: &line.verdict,
            carried: line.carried,
            reason: line.reason.as_deref(),
            mistake: line.mistake.as_deref(),
            repair: line.repair.as_deref(),
            counterexample: numbers,
        }
    }
}

/// Marks as a whole number where they are one.
struct Shortest(Marks);

impl Serialize for Shortest {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0.whole() {
            Some(whole) => serializer.serialize_u64(whole),
            None => serializer.serialize_f64(self.0.to_f64()),
        }
    }
}

#[derive(Serialize)]
#[serde(bound = "I: Iterator<Item = Graded>")]
struct Form<'a, I> {
    schema: &'static str,
    key: &'a str,
    max: Shortest,
    students: Students<I>,
    #[serde(skip_serializing_if = "Option::is_none")]
    missing: Option<&'a [String]>,
}

#[derive(Serialize)]
struct StudentForm<'a> {
    id: &'a str,
    marks: f64,
    milestones: Vec<ReachedForm<'a>>,
    first_slip: Option<SlipForm<'a>>,
    assumptions: Vec<AssumptionForm<'a>>,
    queue: Option<&'a str>,
}

impl<'a> StudentForm<'a> {
    fn of(graded: &'a Graded) -> Self {
        Self {
            id: &graded.id,
            marks: graded.marks.to_f64(),
            milestones: graded.milestones.iter().map(ReachedForm::of).collect(),
            first_slip: graded.first_slip.as_ref().map(SlipForm::of),
            assumptions: graded.assumptions.iter().map(AssumptionForm::of).collect(),
            queue: graded.queue.as_deref(),
        }
    }
}

#[derive(Serialize)]
struct PlaceForm<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    file: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    cell: Option<usize>,
    source_line: Option<usize>,
}

impl<'a> PlaceForm<'a> {
    fn of(place: Option<&'a Place>) -> Self {
        Self {
            file: place.and_then(|place| place.file.as_deref()),
            cell: place.and_then(|place| place.cell),
            source_line: place.map(|place| place.source_line),
        }
    }
}

#[derive(Serialize)]
struct ReachedForm<'a> {
    label: &'a str,
    max: Shortest,
    marks: f64,
    outcome: &'static str,
    #[serde(flatten)]
    place: PlaceForm<'a>,
    reason: &'a str,
}

impl<'a> ReachedForm<'a> {
    fn of(reached: &'a Reached) -> Self {
        Self {
            label: &reached.label,
            max: Shortest(reached.max),
            marks: reached.marks.to_f64(),
            outcome: reached.outcome.name(),
            place: PlaceForm::of(reached.place.as_ref()),
            reason: &reached.reason,
        }
    }
}

#[derive(Serialize)]
struct SlipForm<'a> {
    #[serde(flatten)]
    place: PlaceForm<'a>,
    kind: &'a str,
    message: &'a str,
}

impl<'a> SlipForm<'a> {
    fn of(slip: &'a Slip) -> Self {
        Self {
            place: PlaceForm::of(Some(&slip.place)),
            kind: &slip.kind,
            message: &slip.message,
        }
    }
}

#[derive(Serialize)]
struct AssumptionForm<'a> {
    #[serde(flatten)]
    place: PlaceForm<'a>,
    text: &'a str,
    in_key: bool,
}

impl<'a> AssumptionForm<'a> {
    fn of(assumption: &'a Assumption) -> Self {
        Self {
            place: PlaceForm::of(Some(&assumption.place)),
            text: &assumption.text,
            in_key: assumption.in_key,
        }
    }
}
