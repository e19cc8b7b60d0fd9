//! Moments of inertia that words give a letter: "with I for the moment of inertia about the axis of symmetry and I' about
//! a diameter".

use crate::notation::ast::Symbol;
use crate::notation::document::Document;
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::spin_axis::{axis_of, spin_axis};
use crate::verify::letters::usage::{Letter, axis};
use crate::verify::theory::Premise;
use crate::verify::values::atoms::variable_fraction;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::words::book::has_any;
use crate::verify::words::moments_by_adjective::by_adjective;
use crate::verify::words::phrases::ends_with_a_wheel;
use crate::verify::words::prose::Said;
use crate::verify::words::sentences::{Paragraphs, sentences};
use crate::verify::words::symmetric_body::equal_moments;

/// The axis that words name.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Named {
    /// By letters or numbers.
    Axes(Vec<u8>),
    /// The axis of symmetry.
    Axial,
    /// Any axis across it.
    Transverse,
}

/// A letter and the axis that its moment is about.
#[derive(Clone, Debug)]
pub(crate) struct NamedMoment {
    pub(crate) symbol: Symbol,
    /// The components of the tensor that it stands for.
    pub(crate) components: Vec<u8>,
    pub(crate) span: Span,
}

/// A sentence with `⟨n⟩` in the place of its n-th symbol.
struct Numbered<'d> {
    text: String,
    symbols: Vec<(&'d Symbol, Span)>,
    /// Whether the sentence before it speaks of the axis of symmetry, which "this axis" then is.
    behind_axis: bool,
}

const PHRASES: &[&str] = &[
    "moment of inertia about",
    "moments of inertia about",
    "moment of inertia ⟨",
    "moments of inertia ⟨",
    "moment of inertia is ⟨",
    "moments of inertia are ⟨",
];
const AXIAL: &[&str] = &[
    "symmetry",
    "spin axis",
    "shaft",
    "figure axis",
    "axis of figure",
    "axle",
    "polar axis",
    "its own axis",
    "its axis",
    "the normal",
    "its normal",
];
/// The axis of symmetry of a flat body.
const ACROSS_PLANE: &[&str] = &[
    "the normal of",
    "normal to its plane",
    "normal to its face",
    "normal to the dis",
    "perpendicular to its plane",
    "perpendicular to its face",
    "perpendicular to the dis",
    "perpendicular to the plane of the dis",
];
/// Words behind the letter of an axis that is the one of symmetry.
const ALONG: &[&str] = &[
    "axis",
    "along",
    "points along the normal",
    "is along the normal",
    "is the normal",
    "is normal to",
    "is perpendicular to its plane",
    "is perpendicular to its face",
    "is perpendicular to the dis",
];
const TRANSVERSE: &[&str] = &[
    "diameter",
    "transverse",
    "perpendicular",
    "at right angles",
    "normal to",
    "equatorial",
    "every other",
    "any other",
];
/// Words before the letter of a rate: "turns at ⟨n⟩ about the x axis".
const RATES: &[&str] = &[
    " at",
    " rate",
    " speed",
    " velocity",
    " torque",
    " couple",
    " force",
];
/// Words that may stand between a letter and what it is called.
const BETWEEN: &[&str] = &[
    "be",
    "is",
    "for",
    "the",
    "its",
    "denote",
    "denotes",
    "as",
    "stands",
    "stand",
    "are",
    "one",
    "that",
    "principal",
    "central",
    "constant",
    "a",
    "about",
];

/// The moments that a document names in words.
pub(crate) fn named_moments(document: &Document) -> Vec<NamedMoment> {
    let all = sentences(document, Paragraphs::Joined);
    let mut behind_axis = false;
    let numbered = all.iter().map(|sentence| {
        let text = sentence.numbered();
        let speaks = has_any(&text, AXIAL) || text.contains("symmetric about");
        Numbered {
            symbols: sentence.symbols().collect(),
            behind_axis: std::mem::replace(&mut behind_axis, speaks),
            text,
        }
    });
    let sentences: Vec<Numbered> = numbered.collect();
    let told = sentences.iter().find_map(axis_of_symmetry);
    let along = told.or_else(|| spin_axis(document)).unwrap_or(2);
    let across: Vec<u8> = (0..3).filter(|&c| c != along).collect();
    let mut found: Vec<NamedMoment> = vec![];
    for sentence in &sentences {
        for (at, named) in sentence.named() {
            let Some(&(symbol, span)) = sentence.symbols.get(at) else {
                continue;
            };
            let components = match named {
                Named::Axes(components) => components,
                Named::Axial => vec![along],
                Named::Transverse => across.clone(),
            };
            if found.iter().all(|other| other.symbol != *symbol) {
                found.push(NamedMoment {
                    symbol: symbol.clone(),
                    components,
                    span,
                });
            }
        }
    }
    found
}

impl Numbered<'_> {
    /// Symbols by their place, with the axis that the words give each.
    fn named(&self) -> Vec<(usize, Named)> {
        let told = by_adjective(&self.text).into_iter();
        let mut found: Vec<(usize, Named)> = told
            .map(|(symbol, axial)| match axial {
                true => (symbol, Named::Axial),
                false => (symbol, Named::Transverse),
            })
            .collect();
        let start = PHRASES.iter().find_map(|phrase| self.text.find(phrase));
        let of_body = |start: &usize| !ends_with_a_wheel(&self.text[..*start]);
        let Some(start) = start.filter(of_body) else {
            return found;
        };
        let before = self.text[..start].rfind('⟨').unwrap_or(start);
        // Each "about …" with the symbol right before it, or right behind it.
        for (at, _) in self.text[before..].match_indices("about ") {
            let at = before + at;
            let words = self.text[at + "about ".len()..]
                .split([',', ';', '.'])
                .next();
            let words = words.unwrap_or_default().split("about ").next();
            let words = words.unwrap_or_default();
            let end = words.find(" and ").unwrap_or(words.len());
            let axes = self.axes(words).map(|axes| (axes, ""));
            let Some((named, rest)) = axes.or_else(|| self.axis(&words[..end], &self.text[..at]))
            else {
                continue;
            };
            let own = self.symbol_before(at);
            // "About it is ⟨A⟩ and about any diameter ⟨C⟩": the verb is not said again.
            let again = self.text[..at].ends_with("⟩ and ");
            let behind = || self.symbol_behind(rest, again);
            if let Some(symbol) = own.or_else(behind) {
                found.push((symbol, named));
            }
        }
        found
    }

    /// The symbol before a place, with nothing but a naming between.
    fn symbol_before(&self, at: usize) -> Option<usize> {
        let text = &self.text[..at];
        let open = text.rfind('⟨')?;
        let (number, words) = text[open + '⟨'.len_utf8()..].split_once('⟩')?;
        let lead = text[..open].trim_end();
        if RATES.iter().any(|word| lead.ends_with(word)) {
            return None;
        }
        let words = words
            .replace(" of inertia", "")
            .replace("moments", "")
            .replace("moment", "");
        let naming = words.split_whitespace().all(|word| BETWEEN.contains(&word));
        naming.then(|| number.parse().ok())?
    }

    /// The symbol after words for an axis: "about the shaft is ⟨I⟩", "about any other axis through ⟨G⟩ it is ⟨A⟩".
    fn symbol_behind(&self, words: &str, again: bool) -> Option<usize> {
        let text = words.trim_start();
        let text = text.strip_prefix("axis ").unwrap_or(text);
        let through = ["through ", "at "].iter().any(|w| text.starts_with(w));
        let verb = through.then(|| text.find(" is ⟨")).flatten();
        let text = verb.map_or(text, |at| &text[at + 1..]);
        let text = text.strip_prefix("it ").unwrap_or(text);
        let text = ["is ", "be ", "by ", "called "]
            .iter()
            .find_map(|w| text.strip_prefix(w))
            .or(Some(text).filter(|_| again))?;
        text.strip_prefix('⟨')?.split_once('⟩')?.0.parse().ok()
    }

    /// The axis that words name behind others, and what stands behind its name.
    fn axis<'t>(&self, words: &'t str, before: &str) -> Option<(Named, &'t str)> {
        let place = |list: &[&str]| {
            list.iter()
                .filter_map(|w| words.find(w).map(|at| at + w.len()))
                .min()
        };
        if let Some(end) = place(ACROSS_PLANE) {
            return Some((Named::Axial, &words[end..]));
        }
        let (axial, transverse) = (place(AXIAL), place(TRANSVERSE));
        match (axial, transverse) {
            (_, Some(end)) => Some((Named::Transverse, &words[end..])),
            (Some(end), None) => Some((Named::Axial, &words[end..])),
            (None, None) => {
                let this = ["this axis", "that axis", "it "];
                let this = this.iter().find_map(|axis| words.strip_prefix(axis));
                if let Some(rest) = this.filter(|_| self.behind_axis || has_any(before, AXIAL)) {
                    return Some((Named::Axial, rest));
                }
                // "About ⟨z⟩ it is ⟨C⟩."
                if let Some(end) = words.find('⟩').map(|at| at + '⟩'.len_utf8())
                    && words.starts_with('⟨')
                    && let Some(component) = self.axis_called(&words[..end])
                {
                    return Some((Named::Axes(vec![component]), &words[end..]));
                }
                let (at, _) = words.match_indices("axis").next()?;
                let near = |text: &str, from_end: bool| {
                    let mut all = text.split([' ', '-']).filter(|w| !w.is_empty());
                    let word = if from_end {
                        all.next_back()
                    } else {
                        all.next()
                    };
                    word.and_then(|word| self.axis_called(word))
                };
                let behind = &words[at + "axis".len()..];
                let component = near(&words[..at], true).or_else(|| near(behind, false))?;
                Some((Named::Axes(vec![component]), behind))
            }
        }
    }

    /// "The axes 1 and 2", "the x and y axes": more than one.
    fn axes(&self, words: &str) -> Option<Named> {
        let (before, behind) = words.split_once("axes")?;
        let joins = |word: &&str| matches!(*word, "and" | "or" | "&" | "the") || word.is_empty();
        let split =
            |text: &'_ str| -> Vec<String> { text.split([' ', '-']).map(str::to_owned).collect() };
        let run = |words: Vec<String>| -> Vec<u8> {
            let words = words.iter().map(String::as_str).filter(|w| !joins(w));
            words.map_while(|word| self.axis_called(word)).collect()
        };
        let mut last = split(before);
        last.reverse();
        let (mut left, right) = (run(last), run(split(behind)));
        left.reverse();
        let all = if left.is_empty() { right } else { left };
        (all.len() > 1).then_some(Named::Axes(all))
    }

    /// The axis that a word or a symbol names.
    fn axis_called(&self, word: &str) -> Option<u8> {
        let Some(number) = word.strip_prefix('⟨').and_then(|w| w.strip_suffix('⟩')) else {
            return axis(word);
        };
        axis(&self.symbols.get(number.parse::<usize>().ok()?)?.0.name)
    }
}

/// The axis that is said to be the one of symmetry: "the ⟨x⟩ axis is the shaft".
fn axis_of_symmetry(sentence: &Numbered) -> Option<u8> {
    let text = &sentence.text;
    let about = ["symmetric about ", "symmetrical about "].iter();
    let about = about.filter_map(|words| Some(text.split_once(words)?.1));
    let said = about.filter_map(|rest| {
        let words: Vec<&str> = rest.split([' ', ',', '.', ';']).take(5).collect();
        let at = words.iter().position(|word| *word == "axis")?;
        let near = [
            words.get(at + 1),
            at.checked_sub(1).and_then(|i| words.get(i)),
        ];
        near.into_iter()
            .flatten()
            .find_map(|word| sentence.axis_called(word))
    });
    if let Some(axis) = said.into_iter().next() {
        return Some(axis);
    }
    if !has_any(text, AXIAL) {
        return None;
    }
    sentence
        .symbols
        .iter()
        .enumerate()
        .find_map(|(at, (symbol, _))| {
            let mark = format!("⟨{at}⟩");
            let behind = text.split_once(&mark).map_or("", |(_, behind)| behind);
            let mut along = ALONG.iter();
            let named = along.any(|words| behind.trim_start().starts_with(words));
            let about = text.contains(&format!("about the {mark}"));
            (named && !about).then(|| axis_of(symbol))?
        })
}

impl Reading {
    /// A bare letter that words call a moment about an axis is that component.
    pub(crate) fn by_moments(&mut self, document: &Document) {
        self.moments = named_moments(document);
        for moment in equal_moments(document, &self.usage) {
            if self
                .moments
                .iter()
                .all(|other| other.symbol != moment.symbol)
            {
                self.moments.push(moment);
            }
        }
        for moment in &self.moments {
            let letter = Letter::of(&moment.symbol);
            let bare = moment.symbol.subscripts.is_empty() && moment.symbol.primes == 0;
            let marked = moment.symbol.style.vector || moment.symbol.style.tensor;
            if bare && !marked && !self.components.contains_key(&letter) {
                self.components
                    .insert(letter, (Quantity::Inertia, moment.components[0]));
            }
        }
    }
}

impl Checker<'_> {
    /// Takes the moments that words name as the components that they are.
    pub(crate) fn moments_in_words(&mut self) {
        let moments = self.reading.moments.clone();
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        for moment in &moments {
            let (own, place) = match self.meaning_of(&moment.symbol) {
                Meaning::Whole(entity) => (entity, 0),
                Meaning::Component(entity, component) => (entity, component),
                _ => continue,
            };
            let name = format!("the moment of inertia called {}", moment.symbol.name);
            let value = self.theory.atoms.value(own, place, 0);
            let parts = moment
                .components
                .iter()
                .map(|&c| self.theory.atoms.part(inertia, c, 0));
            let parts: Vec<u32> = parts
                .filter(|&part| variable_fraction(part) != value)
                .collect();
            if own != inertia {
                self.theory.atoms.info_mut(own).constant = true;
            }
            self.known.insert(own);
            self.theory.assume(Premise {
                name,
                residuals: parts
                    .iter()
                    .map(|&p| variable_fraction(p) - value.clone())
                    .collect(),
                preferred: parts,
                definition: true,
            });
            if moments.len() > 1 {
                self.take(Said::Principal, moment.span);
            }
        }
    }
}
