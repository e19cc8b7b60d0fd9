//! Letters of which nothing else is told, and that are called as axes are: they may be the unit vectors along these.

use crate::notation::ast::{Kind, Node, Style, Symbol};
use crate::verify::language::statement::{Declaration, Formula, Slot, Statement, Term};
use crate::verify::model::atoms::{Key, Nature, Space};
use crate::verify::model::system::FrameId;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{name_of, node_of, written};
use crate::verify::term::letters::{At, Letter, Meaning, loosely, spelled};
use crate::verify::term::quantity::Quantity;

/// The marks of unit vectors: `\vec n`, `\hat n`, `\hat{\mathbf n}`.
const MARKS: [(bool, bool); 3] = [(true, false), (false, true), (true, true)];

impl Builder<'_> {
    /// "n, w, u are the axes of E": the n of a formula is the unit vector along that axis where it fits.
    pub(super) fn name_axes_by_custom(&mut self) {
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            if !matches!(what.head, "axes" | "axis") {
                continue;
            }
            for subject in subjects {
                let Some(axis) = name_of(subject).and_then(|name| self.only_axis(&name)) else {
                    continue;
                };
                for letter in ways_to_write(subject) {
                    self.name_axis_by_custom(&letter, axis, declaration);
                }
            }
        }
    }

    /// The axis of a name, where all axes that have it are the same one.
    fn only_axis(&mut self, name: &str) -> Option<(FrameId, usize)> {
        let places = self.told_axes(name);
        let first = *places.first()?;
        let along = self.system().axis(first.0, first.1);
        let mut others = places.iter().skip(1);
        let same = others.all(|&(frame, axis)| self.system().axis(frame, axis) == along);
        same.then_some(first)
    }

    /// The axes of frames to which sentences give a name.
    pub(super) fn told_axes(&self, name: &str) -> Vec<(FrameId, usize)> {
        let mut told = vec![];
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            let frame = what.slot(Slot::Of).and_then(|of| self.frame(of));
            let which = what.slot(Slot::Which);
            for (place, subject) in subjects.iter().enumerate() {
                let axis = match what.head {
                    "axes" => Some(place).filter(|place| *place < 3),
                    "axis" => which.and_then(|which| self.number_of_axis(which)),
                    _ => None,
                };
                let own = name_of(subject).as_deref() == Some(name);
                told.extend(frame.zip(axis).filter(|_| own));
            }
        }
        told
    }

    fn name_axis_by_custom(
        &mut self,
        letter: &Node,
        (frame, axis): (FrameId, usize),
        declaration: &Declaration,
    ) {
        let (exact, loose) = (spelled(letter), loosely(letter));
        let letters = &self.reading.letters;
        let at = At::default();
        let told = letters.find(&exact, &loose, &at, 0).is_some()
            || letters.besides(&exact, &at).is_some();
        if told || !letters.written.has(&exact) || self.stands_in_sentences(letter) {
            return;
        }
        let along = Meaning::Quantity(Quantity::Axis(frame, axis));
        let letter = self.letter(&Formula::of(letter), along, declaration);
        let besides = letter.map(|letter| Letter {
            besides: true,
            ..letter
        });
        self.reading.letters.customs.named_only.insert(exact);
        self.reading.letters.letters.extend(besides);
    }

    /// Whether a formula of a sentence takes a letter for a number or a vector of its own.
    fn stands_in_sentences(&self, letter: &Node) -> bool {
        let text = crate::notation::print::latex(letter);
        let key = Key {
            space: Space::Unknown,
            ..Key::new(text)
        };
        let atoms = &self.reading.system.atoms;
        let known = atoms.find(&key);
        known.is_some_and(|letter| atoms.atom(letter).nature != Nature::Unknown)
    }
}

/// The writings that a formula may have for the unit vector along an axis: as it is named, or with the mark of a vector.
fn ways_to_write(subject: &Term) -> Vec<Node> {
    let node = match subject {
        Term::Name(name) => written(name).and_then(|name| node_of(&name).cloned()),
        Term::Formula(formula) => node_of(formula).cloned(),
        _ => None,
    };
    let Some(node) = node else { return vec![] };
    let Kind::Symbol(plain) = &node.kind else {
        return vec![];
    };
    if plain.style != Style::default() {
        return vec![];
    }
    let marked = MARKS.map(|(vector, hat)| Style {
        vector,
        hat,
        ..Style::default()
    });
    let styles = [Style::default()].into_iter().chain(marked);
    let written = |style| Node {
        kind: Kind::Symbol(Symbol {
            style,
            ..plain.clone()
        }),
        span: node.span,
    };
    styles.map(written).collect()
}
