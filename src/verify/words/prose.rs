//! Premises that a document sets in words: "principal axes", "no torque", "attached to the body".

use crate::notation::document::{Document, Item};
use crate::verify::words::book::{Book, has_any};
use crate::verify::words::suppositions::{is_denied, is_of_a_law, principal};
use crate::verify::words::symmetric_body::AXIS_OF_SYMMETRY;
use crate::verify::words::torque_free::torque_free;
use std::sync::LazyLock;

/// What words can set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Said {
    /// The axes turn with the body: Ω = ω.
    BodyAxes,
    /// Axes of the body are spoken of.
    SpeaksOfBodyAxes,
    /// The products of inertia vanish.
    Principal,
    /// The plane with these two axes is a plane of symmetry: the products across it vanish.
    SymmetryPlane(u8, u8),
    /// The product of inertia of these two axes is the only one.
    OnlyProduct(u8, u8),
    /// The body is flat and lies in the plane with these two axes: their moments make up the third.
    Lamina(u8, u8),
    /// No moment acts.
    TorqueFree,
    /// Dots are rates on the body axes.
    DotsOnBody,
    /// Dots are rates seen from space.
    DotsInSpace,
}

impl Said {
    /// The premise in words, as a report shows it.
    pub(crate) fn words(self) -> String {
        match self {
            Self::BodyAxes | Self::SpeaksOfBodyAxes => {
                "axes attached to the body: Ω = ω".to_owned()
            }
            Self::Principal => "principal axes: the products of inertia vanish".to_owned(),
            Self::SymmetryPlane(a, b) => {
                let [a, b] = [a, b].map(axis_name);
                format!("{a}{b} is a plane of symmetry: the products across it vanish")
            }
            Self::OnlyProduct(a, b) => {
                let [a, b] = [a, b].map(axis_name);
                format!("one product of inertia: those but I_{a}{b} vanish")
            }
            Self::Lamina(a, b) => {
                let [c, a, b] = [3 - a - b, a, b].map(axis_name);
                format!("a lamina in the plane {a}{b}: I_{c} = I_{a} + I_{b}")
            }
            Self::TorqueFree => "no torque: ΣM = 0".to_owned(),
            Self::DotsInSpace => "a dot is a rate seen from space".to_owned(),
            Self::DotsOnBody => "a dot is a rate on the body axes".to_owned(),
        }
    }
}

/// What a phrase speaks of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Topic {
    Attached,
    BodyAxes,
    Dots,
    Principal,
    /// A body with an axis of symmetry has no products of inertia on axes along it.
    AxisOfSymmetry,
}

const PHRASES: &[(Topic, &[&str])] = &[
    (
        Topic::Attached,
        &[
            "attached to the body",
            "attached to the rigid body",
            "fixed in the body",
            "fixed to the body",
            "fixed with the body",
            "carried by the body",
            "fixed in the airframe",
            "axes fixed in the",
            "axes in the body",
            "rotate with the body",
            "turn with the body",
            "attached to the rotor",
            "embedded in the body",
        ],
    ),
    (
        Topic::BodyAxes,
        &["body axes", "body-fixed", "body fixed", "body frame"],
    ),
    (Topic::Dots, DOTS),
    (
        Topic::Principal,
        &[
            "principal axes",
            "the principal axis",
            "principal axis system",
            "principal axis frame",
            "principal axis form",
            "principal axis version",
            "principal-axis",
            "principal moments",
            "principal body axes",
            "principal coordinates",
            "principal frame",
            "are principal",
            "be principal",
        ],
    ),
    (Topic::AxisOfSymmetry, AXIS_OF_SYMMETRY),
];
const DOTS: &[&str] = &[
    "dot is taken",
    "dots are",
    "dot denotes",
    "dots denote",
    "dot means",
    "dot is the",
];

static TOPICS: LazyLock<Vec<Topic>> = LazyLock::new(|| {
    let each = PHRASES.iter();
    each.flat_map(|(topic, phrases)| phrases.iter().map(|_| *topic))
        .collect()
});
static BOOK: LazyLock<Book> =
    LazyLock::new(|| Book::of(PHRASES.iter().flat_map(|(_, phrases)| *phrases)));

/// What a piece of prose in small letters sets.
pub(crate) fn said(text: &str) -> Vec<Said> {
    let mut found = vec![];
    let met: Vec<_> = BOOK.places(text).collect();
    let of = |topic| {
        met.iter()
            .filter(move |(which, ..)| TOPICS[*which] == topic)
    };
    let stands = |topic| of(topic).any(|&(_, at, end)| !is_denied(text, at, end));
    if of(Topic::Dots).next().is_some() {
        let clauses = text.split(['.', ';']);
        for clause in clauses.filter(|clause| has_any(clause, DOTS)) {
            if has_any(clause, &["body", "moving", "rotating"]) {
                found.push(Said::DotsOnBody);
            } else if has_any(clause, &["inertial", "in space", "fixed frame"]) {
                found.push(Said::DotsInSpace);
            }
        }
    }
    let attached = |&&(_, at, end): &&(usize, usize, usize)| {
        !is_denied(text, at, end) && !is_of_a_law(text, at)
    };
    if of(Topic::Attached).any(|place| attached(&place)) {
        found.push(Said::BodyAxes);
    } else if stands(Topic::BodyAxes) {
        found.push(Said::SpeaksOfBodyAxes);
    }
    // "Symmetric about its ⟨x⟩-⟨z⟩ plane": what it is symmetric about is not said yet.
    let unsaid = ["symmetric about", "symmetrical about"]
        .iter()
        .filter_map(|words| Some(&text[text.rfind(words)? + words.len()..]))
        .any(|rest| matches!(rest.trim(), "" | "its" | "the"));
    let by_axis = || stands(Topic::AxisOfSymmetry) && !text.contains("plane") && !unsaid;
    if stands(Topic::Principal) || by_axis() || principal(text) {
        found.push(Said::Principal);
    }
    if torque_free(text) {
        found.push(Said::TorqueFree);
    }
    found
}

/// Whether a document speaks of vectors that may be any.
pub(crate) fn speaks_of_any_vector(document: &Document) -> bool {
    let any = [
        "any vector",
        "arbitrary vector",
        "a vector",
        "every vector",
        "some vector",
        "any quantity",
        "any two vectors",
        "generic vector",
        "general vector",
    ];
    document.items.iter().any(|item| match item {
        Item::Prose { text, .. } | Item::Heading { text, .. } => {
            has_any(&text.to_lowercase(), &any)
        }
        _ => false,
    })
}

/// What has no extent across the plane in which it lies.
const THIN: &[&str] = &[
    "rod",
    "wire",
    "balls",
    "particles",
    "masses",
    "dumbbell",
    "dumb-bell",
];

fn axis_name(axis: u8) -> &'static str {
    ["x", "y", "z"][usize::from(axis) % 3]
}

/// A plane of symmetry named by words in small letters and a formula, "symmetric with respect to its ⟨xz⟩ plane", or the
/// plane that a flat body lies in.
pub(crate) fn symmetry_plane(text: &str) -> Vec<Said> {
    if !text.contains("plane") {
        return vec![];
    }
    let symmetric = [
        "plane of symmetry",
        "symmetry plane",
        "symmetric with respect to",
        "symmetrical with respect to",
        "mirror plane",
        "symmetrical about",
        "symmetric about",
    ];
    let flat = has_any(text, &["flat", "thin", "lamina", "plate"])
        && has_any(text, &["lies in the", "lying in the", "in the plane"])
        || THIN.iter().any(|body| {
            let lies = [
                " in the ",
                " lies in the ",
                " lie in the ",
                " lying in the ",
            ];
            lies.iter()
                .any(|words| text.contains(&format!("{body}{words}")))
        });
    let named = match flat || has_any(text, &symmetric) {
        true => named_plane(text),
        false => None,
    };
    let said = |(a, b)| [Said::SymmetryPlane(a, b), Said::Lamina(a, b)];
    let said = named.into_iter().flat_map(said);
    said.take(if flat { 2 } else { 1 }).collect()
}

/// The plane of two axes that a text in small letters names.
fn named_plane(text: &str) -> Option<(u8, u8)> {
    let planes = [
        ("xz", (0, 2)),
        ("xy", (0, 1)),
        ("yz", (1, 2)),
        ("zx", (0, 2)),
        ("yx", (0, 1)),
        ("zy", (1, 2)),
    ];
    let words: Vec<&str> = text.split(|c: char| !c.is_alphanumeric()).collect();
    // "The plane ⟨y = 0⟩": of a formula the sentence keeps letters and digits.
    let spoken: Vec<&str> = text.split_whitespace().collect();
    for (axis, (a, b)) in [("x", (1, 2)), ("y", (0, 2)), ("z", (0, 1))] {
        let close = format!("{axis}0");
        let equation = |w: &[&str]| {
            let apart = w[..2] == [axis, "0"] && w[2].starts_with('⟨');
            apart || w[1] == close && w[2].starts_with('⟨')
        };
        if spoken.windows(3).any(equation) {
            return Some((a, b));
        }
    }
    // "The x-z plane", "the x, z plane", "the plane of x and z", "Oxz".
    let words = words.into_iter().filter(|word| !word.is_empty());
    let words: Vec<&str> = words
        .map(|word| match word.strip_prefix(['o', 'g']) {
            Some(axes) if axes.len() == 2 => axes,
            _ => word,
        })
        .collect();
    let joined = words.iter().filter(|word| **word != "and");
    let joined: Vec<&str> = joined.copied().collect();
    let pairs = joined.windows(2).map(|pair| pair.concat());
    let named: Vec<String> = pairs.chain(words.iter().map(|w| w.to_string())).collect();
    planes
        .iter()
        .find(|(name, _)| named.iter().any(|word| word == name))
        .map(|(_, plane)| *plane)
}

/// "From here on the axes 1, 2, 3 are principal", "number the principal axes 1, 2, 3".
pub(crate) fn turns_to_numbered_axes(text: &str) -> bool {
    let words: Vec<&str> = text
        .split(|c: char| !c.is_alphanumeric())
        .filter(|word| !word.is_empty() && *word != "and")
        .collect();
    let named = |w: &[&str]| w[..2] == ["principal", "axes"] && w[2..] == ["1", "2", "3"];
    let numbered = words.contains(&"number") || words.contains(&"label");
    if numbered && words.windows(5).any(named) {
        return true;
    }
    words
        .windows(4)
        .any(|w| w[..3] == ["1", "2", "3"] && w[3] == "are")
        && words.contains(&"principal")
        && words.contains(&"axes")
}
