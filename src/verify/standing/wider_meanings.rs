//! What a letter means in a part of the document, where that has a part of which sentences speak by itself.

use crate::notation::ast::{Kind, Node};
use crate::verify::standing::chains::Link;
use crate::verify::standing::judge::Judge;
use crate::verify::term::letters::{At, Reach, loosely, spelled};
use num_traits::Zero;
use std::collections::BTreeSet;

impl Judge<'_> {
    /// Whether a link holds by what its letters mean in the whole document, where a sentence tells them anew in a section, and
    /// another sentence speaks of the section inside that one in which the line stands: whether it is meant as well is open.
    pub(super) fn holds_by_wider_meanings(&mut self, link: &Link<'_>) -> bool {
        let Some(wider) = self.without_outer_section(link) else {
            return false;
        };
        let at = std::mem::replace(&mut self.at, wider);
        let sides = self.sides(link, &BTreeSet::new());
        let told = sides.ok().filter(|sides| sides.unknown.is_empty());
        let residuals = told.and_then(|sides| self.residuals(&sides.sides).ok());
        self.at = at;
        residuals.is_some_and(|residuals| residuals.iter().all(Zero::is_zero))
    }

    /// The place of a line without the outer sections in which its letters are told anew.
    fn without_outer_section(&self, link: &Link<'_>) -> Option<At> {
        let (inner, outer) = self.at.sections.split_last()?;
        let inner = inner.trim();
        let mut declarations = self.part.declarations.iter();
        if !declarations.any(|d| d.extent.section().is_some_and(|s| s.trim() == inner)) {
            return None;
        }
        let anew: BTreeSet<String> = link
            .sides()
            .into_iter()
            .flat_map(symbols)
            .filter_map(|symbol| self.section_beside_all(symbol))
            .collect();
        let sections = outer.iter().filter(|s| !anew.contains(s.trim()));
        let mut sections: Vec<String> = sections.cloned().collect();
        if sections.len() == outer.len() {
            return None;
        }
        sections.push(inner.to_owned());
        Some(At {
            sections,
            ..self.at.clone()
        })
    }

    /// The section in which a letter is told anew that is told for the whole document.
    fn section_beside_all(&self, symbol: &Node) -> Option<String> {
        let letters = &self.reading.letters;
        let writing = spelled(symbol);
        let found = letters.find(&writing, &loosely(symbol), &self.at, 0)?;
        let Reach::Section(title) = &found.reach else {
            return None;
        };
        let mut all = letters.letters.iter();
        let wider = all.any(|l| l.spelled == writing && l.reach == Reach::All && !l.besides);
        wider.then(|| title.trim().to_owned())
    }
}

/// The letters of a formula.
fn symbols(node: &Node) -> Vec<&Node> {
    match &node.kind {
        Kind::Symbol(_) => vec![node],
        _ => node.children().flat_map(symbols).collect(),
    }
}
