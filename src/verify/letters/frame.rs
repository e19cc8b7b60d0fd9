//! Which frame a label means: by the words of the document, by its other labels, or by custom.

use crate::notation::ast::{FrameLabel, Kind, Node, Symbol};
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::relative_turn::turning_and_still;
use crate::verify::letters::usage::inner;
use crate::verify::words::book::has_any;
use std::collections::{BTreeMap, BTreeSet};

/// The frame that a derivative is taken in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Frame {
    /// Of fixed orientation.
    Space,
    /// The axes used, which turn.
    Moving,
}

/// Words that say of a frame that it turns, or does not; the first that fits decides.
const WORDS: &[(Frame, &[&str])] = &[
    (
        Frame::Space,
        &[
            "not turn",
            "not rotat",
            "non-rotating",
            "nonrotating",
            "not mov",
        ],
    ),
    (
        Frame::Moving,
        &[
            "turn", "rotat", "moves", "moving", "body", "attached", "spin", "welded",
        ],
    ),
    (
        Frame::Space,
        &[
            "inertial",
            "galile",
            "newtonian",
            "fixed",
            "space",
            "laborator",
            "absolute",
            "at rest",
        ],
    ),
];
/// What a label may stand behind that turns: "fixed in the rotor $R$".
const BODIES: &[&str] = &[
    " body",
    " solid",
    " rotor",
    " satellite",
    " spacecraft",
    " aircraft",
    " vehicle",
    " gyroscope",
    " top",
    " disc",
    " disk",
    " plate",
    " platform",
];
/// Words whose initials are letters of frames.
const INITIALS: &[(Frame, &str)] = &[
    (Frame::Space, "fixed"),
    (Frame::Space, "inertial"),
    (Frame::Space, "space"),
    (Frame::Space, "laboratory"),
    (Frame::Space, "ground"),
    (Frame::Space, "earth"),
    (Frame::Moving, "rotating"),
    (Frame::Moving, "turning"),
    (Frame::Moving, "moving"),
    (Frame::Moving, "body"),
    (Frame::Moving, "satellite"),
    (Frame::Moving, "rotor"),
];
/// How far behind a label words may still speak of it.
const NEAR: usize = 80;

/// The frames that a document names by labels.
#[derive(Clone, Debug, Default)]
pub(crate) struct Frames {
    named: BTreeMap<String, Frame>,
    /// The labels of derivatives.
    written: BTreeSet<String>,
}

impl Frames {
    /// What a document says of the labels that it writes.
    pub(crate) fn of(document: &Document) -> Self {
        let mut written = BTreeSet::new();
        for item in &document.items {
            let Item::Formula(formula) = item else {
                continue;
            };
            for row in &formula.rows {
                if let Row::Line(line) = row {
                    line.sides.iter().for_each(|side| {
                        labels(side, &mut |label| {
                            written.insert(key(&label.text));
                        });
                    });
                }
            }
        }
        let mut frames = Self::default();
        if !written.is_empty() {
            if let Some((turning, still)) = turning_and_still(document, &written) {
                frames.named = [(turning, Frame::Moving), (still, Frame::Space)].into();
            }
            frames.by_words(document, &written);
            frames.by_plain_words(document, &written);
            frames.by_initials(document, &written);
            frames.by_neighbours(&written);
        }
        frames.written = written;
        frames
    }

    /// The frame of a label; `None` where nothing says which.
    pub(crate) fn of_label(&self, label: &FrameLabel) -> Option<Frame> {
        self.of_text(&label.text)
    }

    /// The frame of a label at a symbol.
    pub(crate) fn of_text(&self, label: &str) -> Option<Frame> {
        let named = self.named.get(&key(label)).copied();
        named.or_else(|| by_custom(label))
    }

    /// The same for a label that derivatives have too.
    pub(crate) fn of_derivatives(&self, label: &str) -> Option<Frame> {
        let written = self.written.contains(&key(label));
        self.of_text(label).filter(|_| written)
    }

    /// "$R_0$ is a Galilean frame", "the body frame $B$".
    fn by_words(&mut self, document: &Document, written: &BTreeSet<String>) {
        let items = &document.items;
        let prose = |at: Option<usize>| match at.and_then(|at| items.get(at)) {
            Some(Item::Prose { text, .. }) => text.to_lowercase(),
            _ => String::new(),
        };
        for (at, item) in items.iter().enumerate() {
            let Item::Formula(formula) = item else {
                continue;
            };
            let [Row::Expression(node)] = formula.rows.as_slice() else {
                continue;
            };
            let Some(name) = name(node).filter(|name| written.contains(name)) else {
                continue;
            };
            let before = prose(at.checked_sub(1));
            let behind = prose(Some(at + 1));
            let clause = behind.split(['.', ';', ',']).next().unwrap_or_default();
            let clause: String = clause.chars().take(NEAR).collect();
            let verb = [" is ", " be ", " turns ", " rotates ", " moves ", " does "]
                .iter()
                .any(|verb| clause.starts_with(verb));
            let lead = before.rsplit(['.', ';', ',']).next().unwrap_or_default();
            let lead_words = lead.trim_end();
            let lead = ["frame", "axes", "frame of reference", "system", "observer"]
                .iter()
                .find_map(|noun| lead_words.strip_suffix(noun));
            let noun: Option<String> = lead.map(|lead| {
                let words: Vec<&str> = lead.rsplit(' ').take(3).collect();
                words.join(" ")
            });
            let said = noun.as_deref().and_then(in_words);
            let said = said.or_else(|| {
                BODIES
                    .iter()
                    .any(|b| lead_words.ends_with(b))
                    .then_some(Frame::Moving)
            });
            let said = said.or_else(|| in_words(&clause).filter(|_| verb));
            if let Some(frame) = said {
                self.named.entry(name).or_insert(frame);
            }
        }
    }

    /// "Frame 1 is inertial, frame 2 is welded to the body", with the names in the words.
    fn by_plain_words(&mut self, document: &Document, written: &BTreeSet<String>) {
        for item in &document.items {
            let Item::Prose { text, .. } = item else {
                continue;
            };
            let text = text.to_lowercase();
            for clause in text.split(['.', ';', ',']) {
                for name in written {
                    let subject = format!("frame {} is ", name.to_lowercase());
                    let said = clause.split_once(&subject).map(|(_, rest)| rest);
                    if let Some(frame) = said.and_then(in_words) {
                        self.named.entry(name.clone()).or_insert(frame);
                    }
                }
            }
        }
    }

    /// Two letters that mostly mean one frame, as F and R do, are initials where the words have a fixed frame and a
    /// rotating one.
    fn by_initials(&mut self, document: &Document, written: &BTreeSet<String>) {
        let both: Vec<&String> = written.iter().collect();
        let [one, other] = both.as_slice() else {
            return;
        };
        let known = [one, other].map(|text| self.of_text(text));
        let short = [one, other].iter().all(|text| text.len() == 1);
        if !short || known[0].is_none() || known[0] != known[1] {
            return;
        }
        let text = document.source.text.to_lowercase();
        let words: BTreeSet<&str> = text.split(|c: char| !c.is_alphabetic()).collect();
        let means = |label: &str, frame: Frame| {
            let initial = label.to_lowercase();
            let mut initials = INITIALS.iter().filter(|(of, _)| *of == frame);
            initials.any(|(_, word)| word.starts_with(&initial) && words.contains(word))
        };
        for (still, turning) in [(one, other), (other, one)] {
            if means(still, Frame::Space) && means(turning, Frame::Moving) {
                self.named.insert((*still).clone(), Frame::Space);
                self.named.insert((*turning).clone(), Frame::Moving);
            }
        }
    }

    /// Beside an `R_0` an `R` turns, beside a `B'` that turns a `B` does not; of two labels one turns.
    fn by_neighbours(&mut self, written: &BTreeSet<String>) {
        let known = |frames: &Self, text: &str| {
            let named = frames.named.get(text).copied();
            named.or_else(|| by_custom(text))
        };
        for text in written {
            let base = text.trim_end_matches(['0', '\'']);
            let marked = text.len() > base.len() && written.contains(base);
            if !marked || base.is_empty() {
                continue;
            }
            let primed = text.ends_with('\'');
            let (still, turning) = if primed {
                (base, text.as_str())
            } else {
                (text.as_str(), base)
            };
            if known(self, still) == known(self, turning) && !self.named.contains_key(base) {
                self.named.insert(still.to_owned(), Frame::Space);
                self.named.insert(turning.to_owned(), Frame::Moving);
            }
        }
        let both: Vec<&String> = written.iter().collect();
        if let [first, second] = both.as_slice() {
            for (one, other) in [(first, second), (second, first)] {
                // What the words say of one outweighs what the letter of the other mostly means.
                let said = self.named.get(*one).copied();
                let free = !self.named.contains_key(*other);
                let custom = by_custom(other);
                let other_frame = match (known(self, one), custom) {
                    (Some(frame), None) => Some(frame.other()),
                    (Some(frame), Some(same)) if said == Some(same) => Some(frame.other()),
                    (Some(Frame::Space), Some(Frame::Space)) if rests_before(one, other) => {
                        Some(Frame::Moving)
                    }
                    _ => None,
                };
                if let Some(frame) = other_frame.filter(|_| free) {
                    self.named.insert((*other).clone(), frame);
                }
            }
        }
    }
}

impl Frame {
    fn other(self) -> Self {
        match self {
            Self::Space => Self::Moving,
            Self::Moving => Self::Space,
        }
    }
}

/// Goes through the labels of a tree.
pub(crate) fn labels(node: &Node, look: &mut impl FnMut(&FrameLabel)) {
    match &node.kind {
        Kind::TimeDerivative {
            frame: Some(label), ..
        }
        | Kind::InFrame(_, label) => look(label),
        _ => {}
    }
    node.children().for_each(|child| labels(child, look));
}

/// Where something that is fixed may be so that it does not turn.
const STILL: &[&str] = &[
    "space",
    "inertial",
    "ground",
    "earth",
    "room",
    "laborator",
    "star",
    "galile",
    "newtonian",
    "absolute",
    "table",
    "foundation",
];

/// "Fixed in the spacecraft" turns as that does.
fn fixed_in(text: &str) -> Option<Frame> {
    let lead = [
        "fixed in ",
        "fixed to ",
        "fixed on ",
        "fixed with respect to ",
        "fixed relative to ",
        "embedded in ",
        "rigidly connected ",
    ];
    let place = lead
        .iter()
        .find_map(|lead| Some(text.split_once(lead)?.1))?;
    Some(match has_any(place, STILL) {
        true => Frame::Space,
        false => Frame::Moving,
    })
}

fn in_words(text: &str) -> Option<Frame> {
    // A spacecraft is no space.
    let text = text.replace("spacecraft", "craft");
    if let Some(frame) = fixed_in(&text) {
        return Some(frame);
    }
    let said = WORDS.iter().find(|(_, words)| has_any(&text, words));
    said.map(|(frame, _)| *frame)
}

/// A label without the signs around it.
fn key(label: &str) -> String {
    label
        .chars()
        .filter(|c| c.is_alphanumeric() || *c == '\'')
        .collect()
}

/// The label that a lone symbol would be, in brackets or not: "the solid $(S)$".
fn name(node: &Node) -> Option<String> {
    match &inner(node).kind {
        // A vector is none: "any vector ⟨**A**⟩ is looked at from a frame that turns".
        Kind::Symbol(symbol) if !symbol.style.vector => Some(label_of(symbol)),
        _ => None,
    }
}

/// The label that a symbol would be.
pub(crate) fn label_of(symbol: &Symbol) -> String {
    let primes = "'".repeat(symbol.primes.into());
    format!("{}{}{primes}", symbol.name, symbol.subscripts.concat())
}

/// Whether of two letters that either stand for a frame at rest the first does: the R beside an S turns.
fn rests_before(one: &str, other: &str) -> bool {
    let place = |label: &str| {
        ["N", "I", "S", "E", "F", "A", "R"]
            .iter()
            .position(|l| *l == label)
    };
    place(one)
        .zip(place(other))
        .is_some_and(|(one, other)| one < other)
}

/// The frame of a label by what people write.
fn by_custom(label: &str) -> Option<Frame> {
    let text: String = label.chars().filter(|c| c.is_alphanumeric()).collect();
    let lower = text.to_lowercase();
    let lower = lower
        .strip_prefix("in")
        .filter(|rest| rest.len() < 3 && !rest.is_empty())
        .unwrap_or(&lower);
    if label.trim() == "'" {
        return Some(Frame::Moving);
    }
    match text.as_str() {
        "XYZ" | "XY" | "N" | "A" | "E" | "OXYZ" | "S0" | "R0" | "F" | "I" | "S" | "R" => {
            return Some(Frame::Space);
        }
        "xyz" | "xy" | "123" | "e1e2e3" | "B" | "b" | "Oxyz" | "Gxyz" | "M" | "R1" | "S1" => {
            return Some(Frame::Moving);
        }
        _ => {}
    }
    match lower {
        "space" | "inertial" | "fixed" | "f" | "n" | "i" | "in" | "lab" | "abs" | "absolute"
        | "world" | "w" | "inert" | "ground" | "room" | "labo" | "laboratory" | "outside"
        | "stars" | "0" | "s" | "fix" | "s0" | "r0" => Some(Frame::Space),
        "body" | "rot" | "rotating" | "b" | "m" | "moving" | "rel" | "relative" | "bodyfixed"
        | "r" | "rotate" | "turning" | "s1" | "r1" | "1" | "bodyaxes" | "rotatingframe"
        | "local" | "platform" | "hull" | "satellite" | "spacecraft" | "craft" | "vehicle"
        | "aircraft" | "table" | "turntable" | "carrier" | "cage" | "gimbal" | "ring"
        | "instrument" | "precessing" | "nodes" => Some(Frame::Moving),
        _ => None,
    }
}
