//! The slips that people make, undone one at a time: changes to the text of a line.

use crate::notation::ast::{Factor, Function, Kind, Line, Node, Operator, Symbol, Term};
use crate::source::{Source, Span};
use crate::verify::correction::edit::{Edit, dotted, other_axis, replaced_index, undotted};
use crate::verify::language::messages;
use std::ops::Range;

/// Letters that are tried in the place of one.
const MOST_LETTERS: usize = 40;

/// How unlikely it is that another letter should stand somewhere.
pub(super) const OTHER_LETTER: u32 = 26;

/// How unlikely it is that another axis should stand in an index.
const OTHER_INDEX: u32 = 12;

/// A change that undoes a slip.
pub(super) struct Slip {
    pub(super) edit: Edit,
    /// What it does to the tree of the line, where that is told without reading it anew.
    pub(super) change: Option<Change>,
}

/// What a change to the text of a line does to its tree.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Change {
    /// Another symbol stands in the place of one.
    Symbol(Symbol),
    /// A symbol has a dot.
    Dotted,
    /// A symbol stands squared.
    Squared,
    /// Of a power its base is left, and of a rate what has it.
    Bared,
    /// The node with these bytes is multiplied by a number: numerator and denominator.
    Times(Span, [i64; 2]),
    /// None where the nodes with these bytes are numbers.
    Nothing([Span; 2]),
}

/// The single changes to a line that are so unlikely, but for other letters, the likeliest first.
pub(super) fn slips(source: &Source, line: &Line, costs: Range<u32>) -> Vec<Slip> {
    let written = source.slice(line.span);
    let mut slips = Slips {
        source,
        unicode: !written.is_ascii() && !written.contains('\\'),
        costs,
        is_wanted: false,
        found: vec![],
    };
    for (place, side) in line.sides.iter().enumerate() {
        slips.side(side, place + 1 == line.sides.len());
        slips.node(side);
    }
    in_order(line, slips.found)
}

/// Every symbol of a line changed into others, which are given with their writings.
pub(super) fn other_letters(
    source: &Source,
    line: &Line,
    letters: &[(&str, &Symbol)],
) -> Vec<Slip> {
    let mut found = vec![];
    let mut open: Vec<&Node> = line.sides.iter().rev().collect();
    while let Some(node) = open.pop() {
        let from = open.len();
        open.extend(node.children());
        open[from..].reverse();
        let text = source.slice(node.span).trim();
        if !matches!(&node.kind, Kind::Symbol(symbol) if !symbol.resultant) || text.is_empty() {
            continue;
        }
        let others = letters.iter().filter(|(other, _)| *other != text);
        found.extend(others.take(MOST_LETTERS).map(|(other, symbol)| Slip {
            edit: Edit {
                span: node.span,
                text: (*other).to_owned(),
                kind: "symbol",
                message: messages::should_be(text, other),
                cost: OTHER_LETTER,
            },
            change: Some(Change::Symbol((*symbol).clone())),
        }));
    }
    in_order(line, found)
}

/// The changes within a line, the likeliest first.
fn in_order(line: &Line, mut found: Vec<Slip>) -> Vec<Slip> {
    let inside = |span: Span| line.span.start <= span.start && span.end <= line.span.end;
    found.retain(|slip| inside(slip.edit.span));
    found.sort_by_key(|slip| (slip.edit.cost, slip.edit.span));
    found
}

struct Slips<'a> {
    source: &'a Source,
    /// Whether the line is written in Unicode and not in LaTeX.
    unicode: bool,
    /// How unlikely the slips are that are looked for.
    costs: Range<u32>,
    /// Whether the last one is among them.
    is_wanted: bool,
    found: Vec<Slip>,
}

impl<'a> Slips<'a> {
    fn push(
        &mut self,
        span: Span,
        text: impl FnOnce() -> String,
        kind: &'static str,
        cost: u32,
        message: &str,
    ) {
        self.is_wanted = self.costs.contains(&cost);
        if self.is_wanted {
            let edit = Edit {
                span,
                text: text(),
                kind,
                message: message.to_owned(),
                cost,
            };
            self.found.push(Slip { edit, change: None });
        }
    }

    /// The slip that was found last does this to the tree.
    fn by(&mut self, change: Change) {
        if let Some(slip) = self.found.last_mut().filter(|_| self.is_wanted) {
            slip.change = Some(change);
        }
    }

    /// The slip that was found last puts a two before a node. Before digits it would be one of them.
    fn twice(&mut self, node: &Node) {
        let text = self.slice(node).trim_start_matches(['{', '(', ' ']);
        if !text.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            self.by(Change::Times(node.span, [2, 1]));
        }
    }

    fn slice(&self, node: &Node) -> &'a str {
        self.source.slice(node.span)
    }

    /// A slip of a side as a whole: its sign, a factor on all of it.
    fn side(&mut self, node: &Node, last: bool) {
        let text = self.slice(node);
        if text.is_empty() || matches!(node.kind, Kind::Number(_)) {
            return;
        }
        let sum = matches!(node.kind, Kind::Sum(_) | Kind::Negate(_));
        let whole = match (sum, self.unicode) {
            (true, true) => format!("({text})"),
            (true, false) => format!("\\left({text}\\right)"),
            _ => text.to_owned(),
        };
        let half = if self.unicode {
            "½ "
        } else {
            "\\tfrac{1}{2} "
        };
        self.push(
            node.span,
            || format!("{half}{whole}"),
            "factor",
            14,
            messages::HALF_MISSING,
        );
        self.by(Change::Times(node.span, [1, 2]));
        self.push(
            node.span,
            || format!("2 {whole}"),
            "factor",
            17,
            messages::TWO_MISSING,
        );
        self.twice(node);
        if last {
            let negative = || format!("-{whole}");
            self.push(node.span, negative, "sign", 13, messages::SIGN);
            self.by(Change::Times(node.span, [-1, 1]));
        }
    }

    fn node(&mut self, node: &Node) {
        match &node.kind {
            Kind::Sum(terms) => self.sum(terms),
            Kind::Negate(inside) => {
                let text = self.slice(inside);
                self.push(node.span, || text.into(), "sign", 10, messages::SIGN);
                self.by(Change::Times(node.span, [-1, 1]));
            }
            Kind::Product(factors) => self.product(factors),
            Kind::Symbol(symbol) => self.symbol(node, symbol),
            Kind::TimeDerivative {
                order, frame: None, ..
            } => self.rate(node, *order),
            Kind::Power(base, exponent) => self.power(node, base, exponent),
            Kind::Transpose(inside) => {
                let text = self.slice(inside);
                let message = messages::TRANSPOSED;
                self.push(node.span, || text.into(), "transpose", 16, message);
            }
            Kind::Function(function, _) => self.function(node, *function),
            Kind::Number(_) => self.number(node),
            Kind::Quotient(top, bottom) => self.quotient(node, top, bottom),
            _ => {}
        }
        node.children().for_each(|child| self.node(child));
    }

    fn sum(&mut self, terms: &[Term]) {
        for (place, term) in terms.iter().enumerate() {
            let written = term.sign.start < term.sign.end;
            let (sign, other, cost) = match (written, term.negative) {
                (false, _) => (term.node.span.before(), "-", 11),
                (true, false) => (term.sign, "-", 10),
                (true, true) => (term.sign, if place == 0 { "" } else { "+" }, 10),
            };
            self.push(sign, || other.into(), "sign", cost, messages::SIGN);
            self.by(Change::Times(term.node.span, [-1, 1]));
            let half = if self.unicode {
                "½ "
            } else {
                "\\tfrac{1}{2} "
            };
            let before = term.node.span.before();
            self.push(before, || half.into(), "factor", 19, messages::HALF_MISSING);
            self.by(Change::Times(term.node.span, [1, 2]));
            self.push(before, || "2 ".into(), "factor", 19, messages::TWO_MISSING);
            self.twice(&term.node);
            if written {
                let whole = term.sign.to(term.node.span);
                let message = messages::EXTRA_TERM;
                self.push(whole, String::new, "extra-term", 30, message);
                self.by(Change::Times(term.node.span, [0, 1]));
            }
        }
    }

    fn product(&mut self, factors: &[Factor]) {
        for pair in factors.windows(2) {
            let [first, second] = [&pair[0].node, &pair[1].node];
            let (kind, cost, message) = match pair[1].operator {
                Operator::Cross => ("cross-order", 11, messages::CROSS_ORDER),
                Operator::Tensor => ("factor-order", 11, messages::ORDER),
                Operator::Juxtaposed => ("factor-order", 18, messages::ORDER),
                Operator::Dot => continue,
            };
            let sign = self.source.slice(pair[1].sign).trim();
            let [a, b] = [first, second].map(|node| self.slice(node).trim());
            let text = || format!("{b} {sign} {a}");
            self.push(first.span.to(second.span), text, kind, cost, message);
            if pair[1].operator == Operator::Juxtaposed {
                self.by(Change::Nothing([first.span, second.span]));
            }
        }
    }

    fn symbol(&mut self, node: &Node, symbol: &Symbol) {
        let text = self.slice(node);
        if text.trim().is_empty() {
            return;
        }
        self.push(
            node.span,
            || dotted(text),
            "missing-dot",
            10,
            messages::DOT_MISSING,
        );
        self.by(Change::Dotted);
        let square = if self.unicode { "²" } else { "^2" };
        let squared = || format!("{text}{square}");
        self.push(node.span, squared, "factor", 22, messages::SQUARE_MISSING);
        self.by(Change::Squared);
        let transpose = if self.unicode { "ᵀ" } else { "^T" };
        let transposed = || format!("{text}{transpose}");
        self.push(
            node.span,
            transposed,
            "transpose",
            24,
            messages::TRANSPOSE_MISSING,
        );
        self.by(Change::Nothing([node.span; 2]));
        if self.costs.contains(&OTHER_INDEX) {
            for index in &symbol.subscripts {
                self.index(node, text, symbol, index);
            }
        }
    }

    /// Another axis for each letter of an index.
    fn index(&mut self, node: &Node, text: &str, symbol: &Symbol, index: &str) {
        let characters: Vec<char> = index.chars().collect();
        if characters.len() > 2 {
            return;
        }
        for (place, &c) in characters.iter().enumerate() {
            for other in (0..3).filter_map(|to| other_axis(c, to)) {
                let mut new = characters.clone();
                new[place] = other;
                let new: String = new.into_iter().collect();
                if let Some(text) = replaced_index(text, index, &new).filter(|_| other != c) {
                    self.found.push(Slip {
                        edit: Edit {
                            span: node.span,
                            text,
                            kind: "index",
                            message: messages::should_be(index, &new),
                            cost: OTHER_INDEX,
                        },
                        change: with_index(symbol, new).map(Change::Symbol),
                    });
                }
            }
        }
    }

    fn rate(&mut self, node: &Node, order: u8) {
        let text = self.slice(node);
        if order == 1
            && let Some(text) = undotted(text)
        {
            self.push(node.span, || text, "extra-dot", 13, messages::EXTRA_DOT);
            self.by(Change::Bared);
        }
        for (from, to, kind, message) in [
            ("\\ddot", "\\dot", "extra-dot", messages::EXTRA_DOT),
            ("\\dot", "\\ddot", "missing-dot", messages::DOT_MISSING),
        ] {
            if text.starts_with(from) {
                let text = || text.replacen(from, to, 1);
                self.push(node.span, text, kind, 13, message);
            }
        }
    }

    fn power(&mut self, node: &Node, base: &Node, exponent: &Node) {
        let text = self.slice(base);
        match self.slice(exponent).trim_matches(['{', '}', ' ']) {
            "2" => {
                self.push(
                    node.span,
                    || text.into(),
                    "factor",
                    20,
                    messages::EXTRA_SQUARE,
                );
                self.by(Change::Bared);
            }
            "-1" => {
                let message = messages::EXTRA_INVERSE;
                self.push(node.span, || text.into(), "inverse", 16, message);
            }
            _ => {}
        }
    }

    fn function(&mut self, node: &Node, function: Function) {
        let (from, to) = match function {
            Function::Sin => ("sin", "cos"),
            Function::Cos => ("cos", "sin"),
            _ => return,
        };
        let text = self.slice(node);
        if text.contains(from) {
            let message = messages::should_be(from, to);
            let text = || text.replacen(from, to, 1);
            self.push(node.span, text, "function", 15, &message);
        }
    }

    fn number(&mut self, node: &Node) {
        let Ok(number) = self.slice(node).trim().parse::<u32>() else {
            return;
        };
        if number > 1 && number.is_multiple_of(2) {
            let half = || (number / 2).to_string();
            self.push(node.span, half, "factor", 18, messages::EXTRA_TWO);
            self.by(Change::Times(node.span, [1, 2]));
        }
        if let Some(double) = number.checked_mul(2).filter(|_| number > 0) {
            let double = || double.to_string();
            self.push(node.span, double, "factor", 18, messages::EXTRA_HALF);
            self.by(Change::Times(node.span, [2, 1]));
        }
    }

    fn quotient(&mut self, node: &Node, top: &Node, bottom: &Node) {
        let [above, below] = [top, bottom].map(|node| self.slice(node).trim());
        if above == "1" && below == "2" {
            self.push(node.span, String::new, "factor", 15, messages::EXTRA_HALF);
            self.by(Change::Times(node.span, [2, 1]));
        }
    }
}

/// A symbol that has one index, with another.
fn with_index(symbol: &Symbol, index: String) -> Option<Symbol> {
    (symbol.subscripts.len() == 1).then(|| Symbol {
        subscripts: vec![index],
        ..symbol.clone()
    })
}
