//! Symbols that are used before they are defined: "$\dot\omega_1 = -k\,\omega_2$, where $k = …$".

use crate::notation::ast::{Kind, Line, Node, Symbol};
use crate::notation::document::{Formula, Item, Row};
use crate::verify::check::Checker;
use crate::verify::letters::usage::{inner, symbols};
use crate::verify::lines::defined_squares::is_two;
use crate::verify::lines::functions::gives_a_rate_by_name;
use crate::verify::lines::index::is_equality;
use crate::verify::lines::pendulum::{squared, swung};
use crate::verify::values::atoms::{Entity, Owner};
use crate::verify::values::symbol::MAGNITUDE;
use crate::verify::verdict::{Finding, Role};
use crate::verify::words::book::lowered;
use crate::verify::words::points_in_words::lone;
use std::collections::BTreeSet;

/// Items that are looked at behind a formula.
const FARTHEST: usize = 12;

/// Words right behind a line that suppose it.
const SUPPOSED_BEHIND: &[&str] = &[
    "may be assumed",
    "can be assumed",
    "is assumed",
    "are assumed",
    "will be assumed",
    "may be supposed",
    "is supposed",
];

/// How a sentence begins that names a case before its main clause.
const OPENINGS: &[&str] = &["For ", "At ", "In "];
/// How its main clause begins.
const MAIN_CLAUSES: &[&str] = &[
    "one finds",
    "one gets",
    "one obtains",
    "we find",
    "we get",
    "we obtain",
    "this gives",
    "this becomes",
    "it follows",
];

/// Words right before a formula that says by its form what a new symbol in it is: "if we write ⟨T = ½ J ω²⟩".
const WRITTEN: &[&str] = &[
    "we write",
    "one writes",
    "us write",
    "written as",
    "in the form",
    "we put",
    "one puts",
];

impl<'a> Checker<'a> {
    /// "No friction: ⟨\dot h = 0⟩ may be assumed": the words that suppose a line stand behind it; or a main clause does,
    /// for which it is the condition: "For the end of the rod, ⟨a = l/2⟩ and ⟨b = c = 0⟩, one finds".
    pub(crate) fn hear_ahead(&mut self, at: usize) {
        let Some((formula, text)) = self.formula_and_text(at) else {
            return;
        };
        if formula.display {
            return;
        }
        let supposed = SUPPOSED_BEHIND.iter().any(|words| text.starts_with(words));
        let behind = self.behind_list(at);
        let main = behind.and_then(|(_, text)| text.strip_prefix(", "));
        let main =
            main.is_some_and(|main| MAIN_CLAUSES.iter().any(|words| main.starts_with(words)));
        let sentence = self.sentence.trim_start();
        let opens = OPENINGS.iter().any(|word| sentence.starts_with(word));
        if supposed || main && opens {
            self.mark = self.mark.or(Some(Role::Assume));
        }
    }

    /// The prose behind a formula, or behind the next one of its list, and where that formula stands: "⟨a⟩ and ⟨b⟩ at".
    pub(crate) fn behind_list(&self, at: usize) -> Option<(usize, &'a str)> {
        let text = |at| Some((at, self.formula_and_text(at)?.1));
        match text(at)? {
            (_, "and" | ", and" | ",") => text(at + 2),
            behind => Some(behind),
        }
    }

    /// A formula, and the prose right behind it.
    fn formula_and_text(&self, at: usize) -> Option<(&'a Formula, &'a str)> {
        match (
            self.document.items.get(at)?,
            self.document.items.get(at + 1)?,
        ) {
            (Item::Formula(formula), Item::Prose { text, .. }) => Some((formula, text.trim())),
            _ => None,
        }
    }

    /// Looks for definitions behind a formula that name symbols of it. They are taken in at once; or, where the other
    /// way is tried, the formula itself says what they are, and the definition is a claim.
    pub(crate) fn look_ahead(&mut self, at: usize) {
        let Some(Item::Formula(formula)) = self.document.items.get(at) else {
            return;
        };
        if self.writes_a_form() {
            return;
        }
        // `\dot\omega = f(\omega)` says by itself what f is, and what stands behind is a claim.
        if lines_of(formula).any(|line| gives_a_rate_by_name(&line.sides)) {
            return;
        }
        // The motion that is known by then says what the frequency is, and what stands behind is a claim.
        let behind = &self.document.items[..at];
        if lines_of(formula).any(|line| {
            self.frequency_in_equation(&line.sides).is_some()
                || writes_oscillation_again(behind, &line.sides)
        }) {
            return;
        }
        let mut used: BTreeSet<Entity> = BTreeSet::new();
        for row in &formula.rows {
            if let Row::Line(line) = row {
                self.defined_behind(line, &used);
                let own = line.sides.first().and_then(|side| self.new_symbol(side));
                let strangers = self.strangers(&line.sides);
                let own = |e: &Entity| own.is_some_and(|(entity, _)| entity == *e);
                used.extend(strangers.into_iter().filter(|e| !own(e)));
            }
        }
        if used.is_empty() {
            return;
        }
        let behind = &self.document.items[at + 1..];
        for line in lines_behind(behind) {
            self.defined_behind(line, &used);
        }
        // What a function of several arguments is, no use of it tells: `τ = Y(ω, \dot ω) θ`, and then a line `Y(…) = …`.
        let sides = lines_of(formula).flat_map(|line| &line.sides);
        let called: Vec<(&str, usize)> = sides.flat_map(calls).collect();
        for line in next_lines(behind).filter(|_| !called.is_empty()) {
            let left = line.sides.first().and_then(call);
            if left.is_some_and(|left| called.contains(&left)) {
                self.defined_behind(line, &used);
            }
        }
    }

    /// A line that says what a symbol is that was used before.
    fn defined_behind(&mut self, line: &'a Line, used: &BTreeSet<Entity>) {
        // The ⟨n ≠ 0⟩ of ⟨ω₂ = n ≠ 0⟩ says nothing of the kind.
        if !line.relations.iter().any(|(r, _)| is_equality(*r)) {
            return;
        }
        // "With ⟨ν² = … > 0⟩."
        let (left, right) = match line.sides.as_slice() {
            [left, right] => (left, right),
            [left, right, sign] if matches!(sign.kind, Kind::Number(_)) => (left, right),
            _ => return,
        };
        let symbol = match &left.kind {
            Kind::Call(head, _) => head,
            Kind::Power(base, two) if is_two(two) => base,
            _ => left,
        };
        let Some((entity, place)) = self.new_symbol(symbol) else {
            return;
        };
        let squared = !std::ptr::eq(symbol, left) && matches!(left.kind, Kind::Power(..));
        // The coefficients a_1, a_2, a_3 are each defined.
        let own = matches!(self.theory.atoms.info(entity).owner, Owner::Symbol(_));
        if place.is_some() && !squared && !own {
            return;
        }
        let known = place.is_none() && self.known.contains(&entity);
        let known = known || self.theory.mentions_part(entity, place);
        if known || !used.contains(&entity) || line.continues {
            return;
        }
        // What a law says of it needs no line.
        if matches!(&left.kind, Kind::Symbol(symbol) if self.moment_about_axis(symbol).is_some()) {
            return;
        }
        // What it is made of must be known already.
        if !self.strangers(std::slice::from_ref(right)).is_empty() {
            return;
        }
        // What a function is, its use does not tell.
        let function = matches!(left.kind, Kind::Call(..));
        self.looked_ahead |= !function;
        if self.reading.by_use && !function {
            self.implicit.insert(entity);
        } else if self.done.insert(line.span.start) {
            self.line(line, Role::Define);
        }
    }

    /// Whether the words right before a formula have it say by its form what a symbol is.
    fn writes_a_form(&self) -> bool {
        let said = self.sentence.trim_end();
        // Nothing that stands before the last formula counts.
        let last = said.rsplit('⟩').next().unwrap_or_default();
        let last = lowered(last);
        WRITTEN.iter().any(|words| last.ends_with(words))
    }

    /// Symbols that no line before has, those included that have the letter of a quantity with a label of their own.
    pub(crate) fn unmentioned(&mut self, sides: &[Node]) -> BTreeSet<Entity> {
        let mut found: BTreeSet<Entity> = self.entities(sides).into_iter().collect();
        found.retain(|&entity| {
            let own = match &self.theory.atoms.info(entity).owner {
                Owner::Symbol(_) => true,
                Owner::Quantity(_, label) => !label.is_empty() && label != MAGNITUDE,
            };
            own && !self.theory.mentions_entity(entity)
        });
        found
    }

    /// Symbols of the document that nothing is known of.
    fn strangers(&mut self, sides: &[Node]) -> BTreeSet<Entity> {
        let mut found = BTreeSet::new();
        for entity in self.entities(sides) {
            let own = matches!(self.theory.atoms.info(entity).owner, Owner::Symbol(_));
            if own && !self.known.contains(&entity) && !self.theory.mentions_entity(entity) {
                found.insert(entity);
            }
        }
        found
    }

    /// A line that says what a symbol is by its use, where the definition behind it is to be checked against that.
    pub(crate) fn says_by_use(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let written = self.writes_a_form() && sides.len() == 2;
        let strangers = match written {
            true => self.unmentioned(sides),
            false => self.strangers(sides),
        };
        let one = strangers.len() == 1;
        let implicit = strangers.iter().all(|e| self.implicit.contains(e));
        let named = |side| self.new_symbol(side).is_some();
        if !one || !(implicit || written && !sides.first().is_some_and(named)) {
            return false;
        }
        let accepted = self.accept_definition(sides, finding);
        if accepted {
            self.known.extend(strangers);
        }
        accepted
    }
}

/// Whether `\ddot x + w^2 x = 0` stands in a document that had an equation for the second rate of x before: that one says
/// what w is.
fn writes_oscillation_again(before: &[Item], sides: &[Node]) -> bool {
    let Some(swung) = sides.iter().find_map(swung) else {
        return false;
    };
    let mut lines = before.iter().filter_map(|item| match item {
        Item::Formula(formula) => Some(lines_of(formula)),
        _ => None,
    });
    // Of `\ddot x = k^2 x`, a growth, no frequency is known.
    let grows = matches!(sides, [left, right]
        if matches!(inner(left).kind, Kind::TimeDerivative { .. })
            && matches!(inner(right).kind, Kind::Product(_)));
    if grows {
        return false;
    }
    let again = |line: &Line| line.sides.iter().any(|side| swings(side, &swung));
    sides.iter().any(|side| squared(side).is_some()) && lines.any(|mut lines| lines.any(again))
}

/// Whether the second rate of a symbol stands in a node.
fn swings(node: &Node, symbol: &Symbol) -> bool {
    let own = match &node.kind {
        Kind::TimeDerivative {
            operand, order: 2, ..
        } => lone(operand) == Some(symbol),
        _ => false,
    };
    own || node.children().any(|c| swings(c, symbol))
}

fn lines_of(formula: &Formula) -> impl Iterator<Item = &Line> {
    formula.rows.iter().filter_map(|row| match row {
        Row::Line(line) => Some(line),
        _ => None,
    })
}

/// Functions of several arguments that are called, and of how many.
fn calls(node: &Node) -> Vec<(&str, usize)> {
    let inside = node.children().flat_map(calls);
    call(node).into_iter().chain(inside).collect()
}

fn call(node: &Node) -> Option<(&str, usize)> {
    let Kind::Call(head, arguments) = &node.kind else {
        return None;
    };
    let name = symbols(head).first()?.name.as_str();
    (arguments.len() > 1).then_some((name, arguments.len()))
}

/// The lines of the next formulas of a section.
fn next_lines(items: &[Item]) -> impl Iterator<Item = &Line> {
    let section = items
        .iter()
        .take(FARTHEST)
        .take_while(|item| !matches!(item, Item::Heading { .. }));
    let formulas = section.filter_map(|item| match item {
        Item::Formula(formula) => Some(formula),
        _ => None,
    });
    formulas.flat_map(lines_of)
}

/// The lines of the clause that opens behind a formula with "where" or "with".
fn lines_behind(items: &[Item]) -> Vec<&Line> {
    let mut lines = vec![];
    let mut open = false;
    for item in items.iter().take(FARTHEST) {
        match item {
            Item::Break | Item::Comment { .. } => {}
            Item::Heading { .. } => break,
            Item::Prose { text, .. } => {
                let text = text.trim_start_matches([',', ' ', '\n', ';', ':']);
                let opens = ["where", "with", "here", "in which"];
                open |= opens
                    .iter()
                    .any(|word| text.to_lowercase().starts_with(word));
                if !open || text.contains(". ") || text.trim_end().ends_with('.') {
                    break;
                }
            }
            Item::Formula(formula) if open => {
                lines.extend(lines_of(formula));
            }
            Item::Formula(_) => break,
        }
    }
    lines
}
