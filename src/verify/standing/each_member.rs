//! Lines about any member: what they say they say of each one that has a name.

use crate::notation::ast::{Kind, Line, Node, Symbol};
use crate::verify::standing::chains::Link;
use crate::verify::standing::judge::Judge;
use crate::verify::term::indices::with_number;
use crate::verify::term::letters::spell;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// One line has no more links than this.
const MOST: usize = 36;

impl Judge<'_> {
    /// The links of a line, those about any member of a family as one for each of the members that have names.
    pub(super) fn links_of<'l>(&mut self, line: &'l Line) -> Vec<Link<'l>> {
        let links = self.chain.links(line, &self.at).into_iter();
        let mut links: Vec<Link<'l>> = links.map(|link| self.of_whole(link)).collect();
        while let Some((index, count)) = links.iter().find_map(|link| self.member_index(link)) {
            if links.len() * count > MOST {
                break;
            }
            let each = |link: Link<'l>| -> Vec<Link<'l>> {
                if self.member_index(&link).is_none_or(|(own, _)| own != index) {
                    return vec![link];
                }
                let one = |number: usize| Link {
                    left: Cow::Owned(numbered(&link.left, &index, number)),
                    relation: link.relation,
                    right: Cow::Owned(numbered(&link.right, &index, number)),
                };
                (1..=count).map(one).collect()
            };
            links = links.into_iter().flat_map(each).collect();
        }
        links
    }

    /// A letter of a link that numbers members with names, and how many these are.
    fn member_index(&self, link: &Link<'_>) -> Option<(String, usize)> {
        let mut rules = self.reading.letters.indices.iter();
        if !rules.any(|rule| rule.members.is_some()) {
            return None;
        }
        let mut found = BTreeMap::new();
        let sides = link.sides();
        sides.iter().for_each(|side| self.collect(side, &mut found));
        let mut free = found.into_iter();
        free.find(|(index, _)| !sides.iter().any(|side| sums_over(side, index)))
    }

    fn collect(&self, node: &Node, found: &mut BTreeMap<String, usize>) {
        if let Kind::Symbol(symbol) = &node.kind
            && let Some((index, count)) = self.index_of(symbol)
        {
            found.insert(index, count);
        }
        node.children().for_each(|child| self.collect(child, found));
    }

    /// The index of a letter of which a sentence tells for each member.
    fn index_of(&self, symbol: &Symbol) -> Option<(String, usize)> {
        let letters = &self.reading.letters;
        let index = symbol.subscripts.last()?;
        let count = letters.index(index, &self.at)?.members?;
        let told = |number: usize| {
            let own = with_number(symbol, &number.to_string());
            let found = letters.find(&spell(&own, true), &spell(&own, false), &self.at, 0);
            found.is_some()
        };
        (1..=count).all(told).then(|| (index.clone(), count))
    }
}

/// Whether a sum over an index stands in a formula.
fn sums_over(node: &Node, index: &str) -> bool {
    let own = matches!(&node.kind, Kind::IndexedSum { index: own, .. } if own.name == index);
    own || node.children().any(|child| sums_over(child, index))
}

/// A formula with a number in the place of an index.
fn numbered(node: &Node, index: &str, number: usize) -> Node {
    let mut node = node.clone();
    node.change_symbols(&mut |symbol| {
        if symbol.subscripts.last().is_some_and(|last| last == index) {
            *symbol = with_number(symbol, &number.to_string());
        }
    });
    node
}
