//! What the front matter of a key sets: marks, and how they are given.

use crate::notation::SETTINGS;
use crate::notation::document::FrontMatter;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::fmt;
use std::iter::Sum;
use std::ops::Add;

/// Marks, exact to a thousandth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Marks(u64);

impl Marks {
    /// The largest number of marks for one milestone.
    const MOST: f64 = 1_000_000.0;

    /// Marks from a number; `None` where it is negative, no number, or finer than a thousandth.
    pub fn new(number: f64) -> Option<Self> {
        let thousandths = number * 1000.0;
        let near = (thousandths - thousandths.round()).abs() < 1e-6;
        let fits = (0.0..=Self::MOST).contains(&number) && near;
        fits.then(|| Self(thousandths.round() as u64))
    }

    /// Half of them, rounded up to a thousandth.
    pub fn half(self) -> Self {
        Self(self.0.div_ceil(2))
    }

    /// The nearest multiple of a step; the larger of two that are as near.
    pub fn rounded_to(self, step: Self) -> Self {
        match step.0 {
            0 => self,
            step => Self((self.0 + step / 2) / step * step),
        }
    }

    /// As a number.
    pub fn to_f64(self) -> f64 {
        self.0 as f64 / 1000.0
    }

    /// The whole number that it is, if it is one.
    pub fn whole(self) -> Option<u64> {
        self.0.is_multiple_of(1000).then_some(self.0 / 1000)
    }
}

impl Add for Marks {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sum for Marks {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(Self::default(), Add::add)
    }
}

impl fmt::Display for Marks {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.to_f64())
    }
}

/// What a line is given that only carries on an earlier slip.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FollowThrough {
    /// All marks of the milestone.
    #[default]
    Full,
    /// Half of them.
    Half,
    /// None.
    None,
}

/// How marks are given.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Policy {
    /// Labels with their marks, in the order of the front matter.
    pub(super) marks: Vec<(String, Marks)>,
    pub(super) follow_through: FollowThrough,
    /// Whether a milestone needs lines that lead to it.
    pub(super) working: bool,
    /// Labels of milestones that need a line of their own.
    pub(super) shown: Vec<String>,
    /// The sum of a student's marks is rounded to a multiple of this.
    pub(super) rounding: Option<Marks>,
    /// How many named rules a line may use that no earlier line of the student used.
    pub(super) most_rules: Option<usize>,
}

impl Policy {
    /// Reads the policy of a key, and says what is wrong with it.
    pub(super) fn read(front: &FrontMatter) -> (Self, Vec<String>) {
        let mut policy = Self {
            working: true,
            ..Self::default()
        };
        let mut wrong = vec![];
        let setting = |name: &str| structure(front.other.get(name));
        let word = |name: &str| {
            let value = front.other.get(name);
            value.map(|v| v.as_str().unwrap_or("").trim().to_owned())
        };
        wrong.extend(front.other.keys().filter_map(|name| unknown(name)));
        policy.read_marks(setting("marks"), &mut wrong);
        match word("follow_through").as_deref() {
            None | Some("full") => {}
            Some("half") => policy.follow_through = FollowThrough::Half,
            Some("none") => policy.follow_through = FollowThrough::None,
            Some(_) => wrong.push("`follow_through` is full, half or none".to_owned()),
        }
        match word("working").as_deref() {
            None | Some("required") => {}
            Some("optional") => policy.working = false,
            Some(_) => wrong.push("`working` is required or optional".to_owned()),
        }
        match setting("shown").as_ref().map(labels) {
            None => {}
            Some(Some(labels)) => policy.shown = labels,
            Some(None) => {
                wrong.push("`shown` is no list of labels; write shown: [\"(1)\"]".to_owned())
            }
        }
        policy.rounding = setting("rounding").and_then(|value| {
            let step = value.as_f64().and_then(Marks::new);
            let step = step.filter(|step| *step > Marks::default());
            if step.is_none() {
                wrong.push("`rounding` is no step of marks; write rounding: 0.5".to_owned());
            }
            step
        });
        policy.most_rules = setting("most_rules").and_then(|value| {
            let most = value.as_u64().and_then(|most| usize::try_from(most).ok());
            if most.is_none() {
                wrong.push("`most_rules` is no number of rules; write most_rules: 2".to_owned());
            }
            most
        });
        (policy, wrong)
    }

    fn read_marks(&mut self, setting: Option<Value>, wrong: &mut Vec<String>) {
        let map = match setting {
            None => return,
            Some(Value::Object(map)) => map,
            Some(_) => {
                let why = "`marks` is no list of labels; write marks: {\"(1)\": 2}";
                return wrong.push(why.to_owned());
            }
        };
        for (label, value) in map {
            match value.as_f64().and_then(Marks::new) {
                Some(marks) => self.marks.push((label, marks)),
                None => wrong.push(format!(
                    "`marks` gives {label} no number of marks; write {label}: 2"
                )),
            }
        }
    }

    /// The marks of a student from those of the milestones.
    pub(super) fn total(&self, marks: impl Iterator<Item = Marks>) -> Marks {
        let sum: Marks = marks.sum();
        self.rounding.map_or(sum, |step| sum.rounded_to(step))
    }
}

/// What the front matter of a key may set.
fn settings() -> impl Iterator<Item = &'static str> {
    let of_comments = SETTINGS.into_iter().filter(|name| *name != "id");
    of_comments.chain(["symbols", "polhode"])
}

/// What other programs read there.
const ABOUT: [&str; 34] = [
    "id",
    "title",
    "subtitle",
    "author",
    "authors",
    "date",
    "lang",
    "language",
    "abstract",
    "keywords",
    "tags",
    "categories",
    "subject",
    "description",
    "course",
    "institute",
    "layout",
    "output",
    "format",
    "documentclass",
    "classoption",
    "geometry",
    "fontsize",
    "papersize",
    "header-includes",
    "bibliography",
    "csl",
    "toc",
    "number-sections",
    "numbersections",
    "jupyter",
    "jupytext",
    "kernelspec",
    "license",
];

/// What to say of a name that sets nothing.
fn unknown(name: &str) -> Option<String> {
    if settings().any(|known| known == name) || ABOUT.contains(&name) {
        return None;
    }
    let near = settings().map(|known| (strsim::jaro_winkler(known, name), known));
    let near = near.max_by(|a, b| a.0.total_cmp(&b.0));
    Some(match near.filter(|(likeness, _)| *likeness > 0.8) {
        Some((_, known)) => format!("`{name}` is no setting of a key; did you mean `{known}`?"),
        None => format!(
            "`{name}` is no setting of a key; the settings are {}",
            settings().collect::<Vec<_>>().join(", ")
        ),
    })
}

/// A list of labels.
fn labels(value: &Value) -> Option<Vec<String>> {
    let labels = value.as_array()?.iter();
    labels
        .map(|label| label.as_str().map(str::to_owned))
        .collect()
}

/// A setting as YAML has it; in a comment of LaTeX it stands as text.
fn structure(value: Option<&Value>) -> Option<Value> {
    match value? {
        Value::String(text) => Some(serde_saphyr::from_str(text).unwrap_or(Value::Null)),
        other => Some(other.clone()),
    }
}
