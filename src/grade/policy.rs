//! What the front matter of a key sets: marks, and how they are given.

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
}

impl Policy {
    /// Reads the policy of a key, and says what is wrong with it.
    pub(super) fn read(front: &FrontMatter) -> (Self, Vec<String>) {
        let mut policy = Self {
            working: true,
            ..Self::default()
        };
        let mut wrong = vec![];
        let word = |key: &str| {
            front
                .other
                .get(key)
                .map(|v| v.as_str().unwrap_or("").trim().to_owned())
        };
        match structure(front.other.get("marks")) {
            None => {}
            Some(Value::Object(map)) => {
                for (label, value) in map {
                    match value.as_f64().and_then(Marks::new) {
                        Some(marks) => policy.marks.push((label, marks)),
                        None => wrong.push(format!(
                            "`marks` gives {label} no number of marks; write {label}: 2"
                        )),
                    }
                }
            }
            Some(_) => {
                wrong.push("`marks` is no list of labels; write marks: {\"(1)\": 2}".to_owned())
            }
        }
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
        match structure(front.other.get("shown")) {
            None => {}
            Some(Value::Array(labels)) if labels.iter().all(Value::is_string) => {
                policy.shown = labels
                    .iter()
                    .filter_map(Value::as_str)
                    .map(str::to_owned)
                    .collect();
            }
            Some(_) => {
                wrong.push("`shown` is no list of labels; write shown: [\"(1)\"]".to_owned())
            }
        }
        (policy, wrong)
    }
}

/// A setting as YAML has it; in a comment of LaTeX it stands as text.
fn structure(value: Option<&Value>) -> Option<Value> {
    match value? {
        Value::String(text) => Some(serde_saphyr::from_str(text).unwrap_or(Value::Null)),
        other => Some(other.clone()),
    }
}
