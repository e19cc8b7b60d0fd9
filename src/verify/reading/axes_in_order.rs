//! Axes of two frames that are the same where the angle between the frames is zero.

use crate::verify::language::heads::NORMAL;
use crate::verify::language::statement::{Declaration, Slot, Statement, Term};
use crate::verify::model::system::FrameId;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::compounds_read::symbols_in;
use crate::verify::reading::names::{UNIT_VECTOR, name_of, name_of_formula, nodes_of};

impl Builder<'_> {
    /// The axis of one of two frames that has its place in the other as well, where the two triads have names of their own
    /// and no sentence says of that axis of the other anything else.
    pub(super) fn axis_in_order(
        &self,
        about: &Term,
        frame: FrameId,
        relative: FrameId,
    ) -> Option<usize> {
        let name = name_of(about)?;
        let mut both = [(frame, relative), (relative, frame)].into_iter();
        let (axis, other) = both.find_map(|(of, other)| Some((self.axes.of(&name, of)?, other)))?;
        let there = self
            .axes
            .iter()
            .filter(|(_, place)| **place == (other, axis));
        let names: Vec<&String> = there.map(|(name, _)| name).collect();
        // What is along it says nothing of how it lies itself.
        let spoken_of = |d: &Declaration| match &d.statement {
            Statement::Is { what, .. } if what.head == "axes" => false,
            Statement::Does { verb: "turn", .. } => false,
            Statement::Is { subjects, .. } | Statement::Does { subjects, .. } => {
                let subjects = subjects.iter().filter_map(name_of);
                let mut subjects = subjects.filter(|subject| *subject != name);
                subjects.any(|subject| names.contains(&&subject))
            }
            _ => false,
        };
        // That it points along this one is what its place says.
        let confirms = |d: &Declaration| match &d.statement {
            Statement::Does {
                subjects,
                verb: "point",
                slots,
            } => {
                let own = |subject: &Term| name_of(subject).is_some_and(|n| names.contains(&&n));
                matches!(slots.as_slice(), [(Slot::Along, along)] if name_of(along).as_ref() == Some(&name))
                    && subjects.iter().all(own)
            }
            _ => false,
        };
        let related = |d: &Declaration| self.relates_axes(d, frame, relative);
        let mut others = self.declarations.iter().filter(|d| !confirms(d));
        (!others.any(|d| spoken_of(d) || related(d))).then_some(axis)
    }

    /// Whether a sentence that speaks of axes of both frames tells more than the angle between two.
    pub(super) fn tells_how_axes_lie(
        &self,
        declaration: &Declaration,
        one: FrameId,
        other: FrameId,
    ) -> bool {
        let told = match &declaration.statement {
            Statement::Holds(_) => true,
            Statement::Does { verb, .. } => *verb != "turn",
            Statement::Is { what, .. } => {
                matches!(what.head, UNIT_VECTOR | NORMAL | "parallel" | "orthogonal")
            }
            _ => false,
        };
        let shared = |name: &String| {
            let of = |frame| self.axes.of(name, frame).is_some();
            of(one) && of(other)
        };
        told && self.relates_axes(declaration, one, other)
            && !names_in(declaration).iter().any(shared)
    }

    /// Whether a sentence speaks of axes of both frames: then it may say how these lie.
    pub(super) fn relates_axes(
        &self,
        declaration: &Declaration,
        one: FrameId,
        other: FrameId,
    ) -> bool {
        let names = names_in(declaration);
        let of = |frame| names.iter().any(|name| self.axes.of(name, frame).is_some());
        of(one) && of(other)
    }
}

/// The names and letters in a sentence.
fn names_in(declaration: &Declaration) -> Vec<String> {
    let terms = declaration.statement.terms().into_iter();
    let formulas = declaration.statement.formulas().into_iter();
    let letters = formulas.flat_map(nodes_of).flat_map(symbols_in);
    let letters = letters.map(|letter| name_of_formula(&letter));
    terms.filter_map(name_of).chain(letters).collect()
}
