//! Which letter a quantity gets where the author has none, and which index.

use crate::verify::derivation::nouns::Key;
use crate::verify::derivation::plan::Subject;
use crate::verify::derivation::story::Story;
use crate::verify::language::statement::Term;
use crate::verify::reading::names::name_of;

impl Story {
    /// The index that tells the letters of one thing from those of another.
    pub(super) fn index(&self, key: Key) -> Option<String> {
        let bodies = &self.plan.bodies;
        let of_body = |body: usize| {
            let subject = bodies.iter().find(|subject| subject.body == body)?;
            (bodies.len() > 1).then(|| self.label_of_body(subject))
        };
        let of_point = |body: usize| {
            let subject = bodies.iter().find(|subject| subject.body == body)?;
            match &subject.centre_term {
                Term::Phrase(_) => of_body(body),
                centre => (bodies.len() > 1).then(|| label_of(centre)),
            }
        };
        match key {
            Key::Turn(frame) => {
                let mut frames = self.plan.frames.iter();
                let (_, term) = frames.find(|(f, _)| *f == frame)?;
                (self.plan.frames.len() > 1).then(|| label_of(term))
            }
            Key::Load(body, _) | Key::MomentOfLoad(body, _) => match of_body(body) {
                Some(index) if matches!(key, Key::MomentOfLoad(..)) => Some(format!("W,{index}")),
                None if matches!(key, Key::MomentOfLoad(..)) => Some("W".to_owned()),
                index => index,
            },
            Key::Upward(body) => {
                let vertical = self.plan.vertical.as_ref().map(label_of)?;
                Some(match of_body(body) {
                    Some(index) => format!("{index},{vertical}"),
                    None => vertical,
                })
            }
            Key::Way(body) | Key::Velocity(body) | Key::Acceleration(body) => of_point(body),
            Key::Sought => None,
            other => of_body(other.body()?),
        }
    }

    /// The label of a body: its initial where no other body has it.
    pub(super) fn label_of_body(&self, subject: &Subject) -> String {
        let label = label_of(&subject.term);
        let initial = |subject: &Subject| {
            let name = name_of(&subject.term).unwrap_or_default();
            name.chars().next()
        };
        let own = initial(subject);
        let same = self
            .plan
            .bodies
            .iter()
            .filter(|other| initial(other) == own);
        match (label.starts_with('\\'), own) {
            (true, Some(own)) if same.count() == 1 => own.to_string(),
            _ => label,
        }
    }
}

impl Key {
    /// The body that it is of.
    fn body(self) -> Option<usize> {
        Some(match self {
            Self::Mass(body)
            | Self::Way(body)
            | Self::Velocity(body)
            | Self::Acceleration(body)
            | Self::Momentum(body)
            | Self::Force(body)
            | Self::AngularMomentum(body)
            | Self::Moment(body)
            | Self::Upward(body)
            | Self::Kinetic(body)
            | Self::Potential(body)
            | Self::Total(body)
            | Self::Load(body, _)
            | Self::MomentOfLoad(body, _) => body,
            Self::Turn(_) | Self::Sought => return None,
        })
    }

    pub(super) fn is_of(self, body: usize) -> bool {
        self.body() == Some(body)
    }

    /// The customary letters, the most usual one first.
    pub(super) fn letters(self) -> &'static [&'static str] {
        match self {
            Self::Turn(_) => &["\\vec{\\omega}", "\\vec{\\Omega}", "\\vec{w}"],
            Self::Mass(_) => &["m", "M", "\\mu"],
            Self::Way(_) => &["\\vec{r}", "\\vec{R}", "\\vec{s}"],
            Self::Velocity(_) => &["\\vec{v}", "\\vec{u}", "\\vec{V}"],
            Self::Acceleration(_) => &["\\vec{a}", "\\vec{A}", "\\vec{b}"],
            Self::Momentum(_) => &["\\vec{p}", "\\vec{P}", "\\vec{q}"],
            Self::Force(_) => &["\\vec{F}", "\\vec{R}", "\\vec{f}"],
            Self::AngularMomentum(_) => &["\\vec{L}", "\\vec{H}", "\\vec{\\Lambda}"],
            Self::Moment(_) => &["\\vec{M}", "\\vec{\\tau}", "\\vec{D}"],
            Self::Upward(_) => &["L", "H", "\\Lambda"],
            Self::Kinetic(_) => &["T", "K", "\\mathcal{T}"],
            Self::Potential(_) => &["V", "U", "\\mathcal{V}"],
            Self::Total(_) => &["E", "\\mathcal{E}", "\\mathcal{H}"],
            Self::Load(..) => &["\\vec{W}", "\\vec{G}", "\\vec{K}"],
            Self::MomentOfLoad(..) => &["\\vec{M}", "\\vec{\\tau}", "\\vec{D}"],
            Self::Sought => &[],
        }
    }
}

/// The label of a thing in an index: its letter, or the word.
pub(super) fn label_of(term: &Term) -> String {
    let name = match term {
        Term::Formula(formula) => formula.source.clone(),
        term => name_of(term).unwrap_or_default(),
    };
    let is_word = name.chars().all(char::is_alphabetic) && name.chars().count() > 2;
    match is_word || name.contains(' ') {
        true => format!("\\text{{{name}}}"),
        false => name,
    }
}
