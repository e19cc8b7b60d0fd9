//! Letters of which nothing else is told, and that are called as axes are: they may be the unit vectors along these.

use crate::notation::ast::{Kind, Node, Style, Symbol};
use crate::verify::language::heads::{UNIT_VECTORS, VERTICAL};
use crate::verify::language::statement::{Declaration, Formula, Slot, Statement, Term, slot};
use crate::verify::model::atoms::{Key, Nature, Space};
use crate::verify::model::system::{Axis, FrameId, Turn};
use crate::verify::reading::axes_by_custom::places_of_axes;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{along_of, name_of, node_of, written};
use crate::verify::term::letters::{At, Letter, Meaning, loosely, spelled};
use crate::verify::term::quantity::Quantity;
use std::collections::BTreeSet;

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

    /// A letter of which no sentence tells, that a sentence's own formula has with the mark of a vector, and that is called as
    /// an axis is, is the unit vector along it.
    pub(super) fn name_axes_in_formulas(&mut self) {
        let said = self.declarations.iter().map(|d| &d.statement);
        let formulas = said.flat_map(Statement::formulas).filter_map(node_of);
        let used: BTreeSet<String> = formulas.flat_map(marked_parts).collect();
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            let axes = matches!(what.head, "axes" | "axis");
            for subject in subjects.iter().filter(|_| axes) {
                let axis = name_of(subject).and_then(|name| self.only_axis(&name));
                let letters = ways_to_write(subject).into_iter().skip(1);
                for letter in letters.filter(|letter| used.contains(&spelled(letter))) {
                    let told = self.is_told_as_letter(&letter);
                    if let Some((frame, axis)) = axis.filter(|_| !told) {
                        let along = Meaning::Quantity(Quantity::Axis(frame, axis));
                        let letter = self.letter(&Formula::of(&letter), along, declaration);
                        self.reading.letters.letters.extend(letter);
                    }
                }
            }
        }
    }

    /// Whether a sentence says of a letter what it is.
    fn is_told_as_letter(&self, letter: &Node) -> bool {
        let own = spelled(letter);
        let is_letter = |term: &Term| match term {
            Term::Formula(formula) => node_of(formula).is_some_and(|node| spelled(node) == own),
            _ => false,
        };
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, .. } => subjects.iter().any(is_letter),
            Statement::Same { subjects, others } => subjects.iter().chain(others).any(is_letter),
            _ => false,
        })
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

    /// The axis of a name on a frame or on the one against which it turns, where turns about it lead up or down there.
    pub(super) fn carried_to(
        &self,
        name: &str,
        at: (FrameId, usize),
        (frame, relative): (FrameId, FrameId),
    ) -> (FrameId, usize) {
        let (mut of, axis) = at;
        if self.keeps_axis(relative, name, at) {
            return (relative, axis);
        }
        while ![frame, relative].contains(&of) {
            let turned = &self.reading.system.frames[of];
            match turned.parent.filter(|_| self.turns_about(of) == Some(axis)) {
                Some(parent) => of = parent,
                None => return at,
            }
        }
        (of, axis)
    }

    /// The number of the axis about which a frame turns.
    fn turns_about(&self, frame: FrameId) -> Option<usize> {
        match &self.reading.system.frames[frame].turn {
            Turn::Angle(about, _) | Turn::Rate(Axis::Number(about), _) => Some(*about),
            _ => None,
        }
    }

    /// Whether a frame turns about an axis of another one, and about nothing else.
    fn keeps_axis(&self, frame: FrameId, name: &str, (of, axis): (FrameId, usize)) -> bool {
        let mut own = Some(frame);
        while let Some(current) = own.filter(|&current| current != of) {
            let turned = &self.reading.system.frames[current];
            let about = self.turns_about(current) == Some(axis)
                || turned.turn == Turn::Free && self.is_told_to_turn(current, name);
            own = turned.parent.filter(|_| about);
        }
        own == Some(of)
    }

    /// Whether one sentence tells how a frame turns, and names this axis.
    fn is_told_to_turn(&self, frame: FrameId, name: &str) -> bool {
        let turns = self.declarations.iter().filter_map(|d| {
            let (subjects, slots) = d.statement.does("turn")?;
            let own = subjects.iter().any(|s| self.frame(s) == Some(frame));
            own.then(|| slot(slots, Slot::About).map(along_of).and_then(name_of))
        });
        let told: Vec<Option<String>> = turns.collect();
        matches!(told.as_slice(), [Some(about)] if about == name)
    }

    /// Whether something is an axis of a frame that turns, where another sentence says which axis at rest is vertical.
    pub(super) fn is_axis_beside_vertical(&self, subject: &Term) -> bool {
        let ground = self.reading.system.ground;
        let axes = |term: &Term| name_of(term).map(|name| self.told_axes(&name));
        let at_rest =
            |term: &Term| axes(term).is_some_and(|axes| axes.iter().any(|a| a.0 == ground));
        let turns = axes(subject).is_some_and(|axes| !axes.is_empty()) && !at_rest(subject);
        turns
            && self.declarations.iter().any(|d| match &d.statement {
                Statement::Is { subjects, what } => {
                    what.head == VERTICAL && subjects.iter().any(at_rest)
                }
                _ => false,
            })
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
            for (place, subject) in places_of_axes(subjects) {
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
        if !is_unit_vector(letter) {
            self.reading.letters.customs.named_only.insert(exact);
        }
        let along = Meaning::Quantity(Quantity::Axis(frame, axis));
        let letter = self.letter(&Formula::of(letter), along, declaration);
        let besides = letter.map(|letter| Letter {
            besides: true,
            ..letter
        });
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

/// Whether a letter that is called as an axis can be nothing but the unit vector along it: by its hat, or by custom.
fn is_unit_vector(letter: &Node) -> bool {
    match &letter.kind {
        Kind::Symbol(symbol) => {
            let custom = UNIT_VECTORS.contains(&symbol.name.as_str());
            symbol.style.hat || symbol.style.vector && custom
        }
        _ => false,
    }
}

/// The writings of all symbols of a formula that have the mark of a vector.
fn marked_parts(node: &Node) -> Vec<String> {
    let own = match &node.kind {
        Kind::Symbol(symbol) if symbol.style.vector || symbol.style.hat => Some(spelled(node)),
        _ => None,
    };
    let parts = node.children().flat_map(marked_parts);
    own.into_iter().chain(parts).collect()
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
