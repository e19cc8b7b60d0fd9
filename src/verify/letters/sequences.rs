//! Three letters in a row that are the components of one quantity: p, q, r; u, v, w; L, M, N; X, Y, Z; A, B, C.

use crate::notation::ast::{Kind, Node, Symbol, Term};
use crate::notation::document::Document;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::values::quantity::Quantity;

impl Reading {
    /// Takes the sequences that the document uses for components; `differences` of A, B and C show that they are moments.
    pub(crate) fn sequences(&mut self, differences: bool) {
        self.rates_and_velocities();
        self.moments_in_a_row();
        let forces = ["X", "Y", "Z"].map(Letter::plain);
        let given = forces.iter().all(|l| self.left_sides.contains(l));
        if self.speaks_of_force && given {
            self.take_components(forces, Quantity::Force);
        }
        let moments = ["A", "B", "C"].map(Letter::plain);
        // "The moments are A and C": of inertia.
        let called = |l: &Letter| self.votes_for(l, Quantity::Moment) > 0;
        let voted = differences
            || called(&moments[0])
                && [0, 2]
                    .iter()
                    .all(|&i| self.left_sides.contains(&moments[i]))
            || moments
                .iter()
                .any(|l| self.votes_for(l, Quantity::Inertia) > 0);
        let bare = moments.iter().all(|l| self.usage.get(l).bare > 0);
        if voted && bare {
            self.take_components(moments, Quantity::Inertia);
        } else if voted && self.usage.get(&moments[0]).bare * self.usage.get(&moments[2]).bare > 0 {
            let [a, _, c] = moments;
            self.components.insert(a, (Quantity::Inertia, 0));
            self.components.insert(c, (Quantity::Inertia, 2));
            self.symmetric = true;
        }
    }

    fn rates_and_velocities(&mut self) {
        for names in [["p", "q", "r"], ["P", "Q", "R"]] {
            let rates = names.map(Letter::plain);
            let moving = |l: &Letter| self.usage.get(l).moving && self.usage.get(l).vector == 0;
            let named = |l: &Letter| self.votes_for(l, Quantity::AngularVelocity) > 0;
            let written = rates.iter().all(|l| self.usage.letters.contains_key(l));
            if rates.iter().filter(|l| moving(l)).count() >= 2
                || written && rates.iter().any(named)
                || self.usage.lists(names)
            {
                self.take_components(rates, Quantity::AngularVelocity);
            }
        }
        for names in [["u", "v", "w"], ["U", "V", "W"]] {
            let velocities = names.map(Letter::plain);
            let moving = |l: &Letter| self.usage.get(l).moving && self.usage.get(l).vector == 0;
            let all_move = [0, 2].iter().all(|&i| moving(&velocities[i]))
                && self.usage.get(&velocities[1]).bare > 0;
            let named = velocities.iter().any(|l| self.components.contains_key(l));
            if !named && (all_move || self.usage.lists(names)) {
                self.take_components(velocities, Quantity::CentreVelocity);
            }
        }
    }

    fn moments_in_a_row(&mut self) {
        let mut rates = ["p", "P"].into_iter().map(Letter::plain);
        let rates = rates.any(|letter| self.components.contains_key(&letter));
        for names in [["ell", "m", "n"], ["l", "m", "n"]] {
            let lower = names.map(Letter::plain);
            let sides = rates && lower.iter().all(|l| self.left_sides.contains(l));
            let bare = lower.iter().all(|l| self.usage.get(l).bare > 0);
            // "Body rates p, q, r, moments ℓ, m, n."
            let called = rates && self.votes_for(&lower[0], Quantity::Moment) > 0;
            let listed = rates && self.usage.lists(names);
            if bare && (sides || called || listed || self.speaks_of_roll && names[0] == "ell") {
                self.take_components(lower, Quantity::Moment);
            }
        }
        // Beside p, q, r "the pitching moment is M"; or lines of roll and yaw alone, `L = …` and `N = …`.
        let number = |name: &str| {
            let used = self.usage.get(&Letter::plain(name));
            used.bare > 0 && used.vector + used.component == 0
        };
        let said = |name: &str| self.left_sides.contains(&Letter::plain(name));
        let lines = |names: [&str; 2]| names.into_iter().all(|name| number(name) && said(name));
        let pair = lines(["L", "N"]) || lines(["M", "N"]) || lines(["L", "M"]);
        for (component, name) in ["L", "M", "N"].into_iter().enumerate().filter(|_| rates) {
            let letter = Letter::plain(name);
            let used = self.usage.get(&letter);
            let number = used.bare > 0 && used.vector + used.component == 0;
            if number && (pair || self.votes_for(&letter, Quantity::Moment) > 0) {
                let part = (Quantity::Moment, component as u8);
                self.components.insert(letter, part);
            }
        }
        for calligraphic in [true, false] {
            let trio = ["L", "M", "N"].map(|name| Letter {
                name: name.to_owned(),
                calligraphic,
            });
            let bare = |l: &Letter| self.usage.get(l).bare > 0;
            // Beside a vector M that no list is made of, an M is its length.
            let vector = |l: &Letter| self.usage.get(l).vector > 0;
            let listed = rates || calligraphic || self.usage.lists(["L", "M", "N"]);
            let apart = !listed && trio.iter().any(vector);
            if trio.iter().all(bare) && self.usage.get(&trio[0]).component == 0 && !apart {
                self.take_components(trio, Quantity::Moment);
            }
        }
    }

    /// "The roll equation": beside p, q, r the L, M or N alone on the left of a line with a rate of one of these.
    pub(crate) fn one_moment_of_the_row(&mut self, document: &Document) {
        let rates = |symbol: &Symbol| {
            let part = self.components.get(&Letter::of(symbol));
            matches!(part, Some((Quantity::AngularVelocity, _))) && symbol.subscripts.is_empty()
        };
        let found = document.lines().filter_map(|line| {
            let [left, right] = line.sides.as_slice() else {
                return None;
            };
            let (Kind::Symbol(symbol), Kind::Sum(terms)) = (&inner(left).kind, &inner(right).kind)
            else {
                return None;
            };
            let row = ["L", "M", "N"];
            let place = row.iter().position(|name| *name == symbol.name)?;
            let plain = symbol.subscripts.is_empty() && !symbol.style.vector;
            let moved = |term: &Term| has_rate_of(&term.node, &rates);
            (plain && terms.iter().any(moved)).then(|| (Letter::of(symbol), place as u8))
        });
        let found: Vec<(Letter, u8)> = found.collect();
        for (letter, place) in found {
            if !self.usage.get(&letter).is_directed() {
                let part = (Quantity::Moment, place);
                self.components.entry(letter).or_insert(part);
            }
        }
    }

    pub(super) fn take_components(&mut self, letters: [Letter; 3], quantity: Quantity) {
        for (component, letter) in letters.into_iter().enumerate() {
            self.components.insert(letter, (quantity, component as u8));
        }
    }
}

/// Whether the rate of such a symbol stands in a node.
fn has_rate_of(node: &Node, wanted: &impl Fn(&Symbol) -> bool) -> bool {
    match &node.kind {
        Kind::TimeDerivative { operand, .. } => {
            matches!(&inner(operand).kind, Kind::Symbol(symbol) if wanted(symbol))
        }
        _ => node.children().any(|child| has_rate_of(child, wanted)),
    }
}
