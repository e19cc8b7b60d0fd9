//! The slips that people make, as changes to the text of a line.

use crate::notation::ast::{FrameLabel, Kind, Node, Symbol, Term};
use crate::source::{Source, Span};
use crate::verify::correction::edit::{Edit, dotted, undotted};
use crate::verify::letters::frame::Frame;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::Letter;
use crate::verify::values::quantity::Quantity;

/// What the edits of a line are made from.
pub(crate) struct Slips<'a> {
    /// The text.
    pub(crate) source: &'a Source,
    /// Letters.
    pub(crate) reading: &'a Reading,
    /// A label for each frame, as the document writes them: space, moving.
    pub(crate) labels: [String; 2],
    /// Whether the line is written in Unicode rather than in LaTeX.
    unicode: bool,
    pub(crate) edits: Vec<Edit>,
}

impl<'a> Slips<'a> {
    /// No edits yet.
    pub(crate) fn new(source: &'a Source, reading: &'a Reading, labels: [String; 2]) -> Self {
        Self {
            source,
            reading,
            labels,
            unicode: false,
            edits: vec![],
        }
    }

    /// All single slips in the sides of a line.
    pub(crate) fn of(mut self, sides: &[Node]) -> Vec<Edit> {
        let written = |side: &Node| self.source.slice(side.span);
        self.unicode = sides.iter().any(|s| !written(s).is_ascii())
            && !sides.iter().any(|s| written(s).contains('\\'));
        for (i, side) in sides.iter().enumerate() {
            self.side(side, i + 1 == sides.len());
            self.node(side);
        }
        self.edits.sort_by_key(|edit| (edit.cost, edit.span));
        self.edits
    }

    pub(crate) fn push(
        &mut self,
        span: Span,
        text: impl Into<String>,
        kind: &'static str,
        cost: u32,
        message: impl Into<String>,
    ) {
        self.edits.push(Edit {
            span,
            text: text.into(),
            kind,
            message: message.into(),
            cost,
        });
    }

    pub(crate) fn slice(&self, node: &Node) -> &'a str {
        self.source.slice(node.span)
    }

    /// Slips of a side as a whole: its sign, a factor on all of it.
    fn side(&mut self, node: &Node, last: bool) {
        let text = self.slice(node);
        if text.is_empty() || matches!(node.kind, Kind::Number(_)) {
            return;
        }
        let sum = matches!(node.kind, Kind::Sum(_) | Kind::Negate(_));
        let unicode = self.unicode;
        let half = if unicode { "½" } else { "\\tfrac{1}{2}" };
        let whole = match (sum, unicode) {
            (true, true) => format!("({text})"),
            (true, false) => format!("\\left({text}\\right)"),
            _ => text.to_owned(),
        };
        let space = if unicode { " " } else { "" };
        self.push(
            node.span,
            format!("{half}{space}{whole}"),
            "factor",
            14,
            "a factor ½ is missing",
        );
        self.push(
            node.span,
            format!("2{space}{whole}"),
            "factor",
            17,
            "a factor 2 is missing",
        );
        if !sum && last {
            self.push(
                node.span,
                format!("-{text}"),
                "sign",
                13,
                "the sign is wrong",
            );
        }
    }

    fn node(&mut self, node: &Node) {
        match &node.kind {
            Kind::Sum(terms) => self.sum(node, terms),
            Kind::Negate(inside) => {
                let text = self.slice(inside).to_owned();
                self.push(node.span, text, "sign", 10, "the sign is wrong");
            }
            Kind::Symbol(symbol) => self.symbol(node, symbol),
            Kind::TimeDerivative {
                operand,
                frame: label,
                order,
                ..
            } => {
                let single = *order == 1 && label.is_none();
                if single
                    && matches!(operand.kind, Kind::Symbol(_))
                    && let Some(text) = undotted(self.slice(node))
                {
                    self.push(node.span, text, "extra-dot", 14, "a dot too many");
                }
                if let Some(label) = label {
                    let now = self.reading.frames.of_label(label);
                    let text = self.other_label(label, now);
                    let message = format!("the frame should be {text}");
                    self.push(label.span, text, "frame", 10, message);
                }
            }
            Kind::Product(factors) => {
                self.swapped(factors);
                if let [tensor, group] = factors.as_slice() {
                    self.tensor_put_first(node, &tensor.node, &group.node);
                }
            }
            Kind::Call(head, arguments) => {
                if let [group] = arguments.as_slice() {
                    self.tensor_put_first(node, head, group);
                }
            }
            Kind::Power(base, exponent) => {
                let base_text = self.slice(base).to_owned();
                match self.slice(exponent).trim_matches(['{', '}', ' ']) {
                    "2" => self.push(node.span, base_text, "factor", 24, "a square too many"),
                    "-1" => self.push(node.span, base_text, "inverse", 5, "an inverse too many"),
                    _ => {}
                }
            }
            Kind::Transpose(inside) => {
                let text = self.slice(inside).to_owned();
                self.push(node.span, text, "transpose", 16, "a transpose too many");
            }
            Kind::Number(number) => {
                for (n, message) in [(2, "a factor ½ too many"), (0, "a factor 2 too many")] {
                    let value = &number.value
                        * num_rational::BigRational::from(num_bigint::BigInt::from(2));
                    let value = if n == 2 {
                        value
                    } else {
                        value / num_bigint::BigInt::from(4)
                    };
                    let text = if value.is_integer() {
                        value.to_integer().to_string()
                    } else {
                        format!("\\tfrac{{{}}}{{{}}}", value.numer(), value.denom())
                    };
                    self.push(node.span, text, "factor", 18, message);
                }
            }
            Kind::Quotient(top, bottom) if self.is_half(top, bottom) => {
                self.push(node.span, "", "factor", 15, "a factor ½ too many");
            }
            _ => {}
        }
        for child in node.children() {
            self.node(child);
        }
        self.transposes(node);
    }

    /// The label of the other frame: in the other case where that is one, otherwise as the document writes it.
    fn other_label(&self, label: &FrameLabel, now: Option<Frame>) -> String {
        let text = self.source.slice(label.span);
        let turned = if now == Some(Frame::Space) {
            text.to_lowercase()
        } else {
            text.to_uppercase()
        };
        let other = FrameLabel {
            text: turned.clone(),
            span: label.span,
        };
        match (self.reading.frames.of_label(&other), now) {
            (Some(found), Some(now)) if found != now && !text.contains('\\') => turned,
            (_, Some(Frame::Space)) => self.labels[1].clone(),
            _ => self.labels[0].clone(),
        }
    }

    fn is_half(&self, top: &Node, bottom: &Node) -> bool {
        self.slice(top).trim() == "1" && self.slice(bottom).trim() == "2"
    }

    fn sum(&mut self, node: &Node, terms: &[Term]) {
        for (i, term) in terms.iter().enumerate() {
            let flipped = if term.negative { "+" } else { "-" };
            if term.sign.start < term.sign.end {
                let text = if i == 0 && term.negative { "" } else { flipped };
                self.push(term.sign, text, "sign", 10, "the sign is wrong");
            } else {
                self.push(
                    term.node.span.before(),
                    "-",
                    "sign",
                    11,
                    "the sign is wrong",
                );
            }
            let whole = term.sign.to(term.node.span);
            let whole = if term.sign.start == term.sign.end {
                term.node.span
            } else {
                whole
            };
            if terms.len() > 1 && (i != 0 || term.negative) {
                self.push(
                    whole,
                    "",
                    "extra-term",
                    30,
                    "this term does not belong here",
                );
            }
        }
        self.difference(node, terms);
    }

    fn symbol(&mut self, node: &Node, symbol: &Symbol) {
        let text = self.slice(node);
        if text.is_empty() {
            return;
        }
        let dotted = dotted(text);
        self.push(node.span, dotted, "missing-dot", 10, "a dot is missing");
        for index in &symbol.subscripts {
            self.index(node, text, index);
        }
        let quantity = self.reading.quantities.get(&Letter::of(symbol)).copied();
        let inertial = quantity == Some(Quantity::Inertia) || self.moment(symbol).is_some();
        let parameter =
            quantity.is_none() && text.len() == 1 && text.bytes().all(|b| b.is_ascii_uppercase());
        if parameter || (inertial && self.moment(symbol).is_some()) {
            let square = if self.unicode { "²" } else { "^2" };
            self.push(
                node.span,
                format!("{text}{square}"),
                "factor",
                22,
                "a square is missing",
            );
        }
        if let (Some(Quantity::AngularVelocity | Quantity::FrameRate), Some(other)) =
            (quantity, self.other_rate(quantity))
        {
            let new = text.replace(
                &crate::verify::values::symbol::latex_name(&symbol.name),
                &other,
            );
            self.push(
                node.span,
                new,
                "symbol",
                16,
                "the angular velocity is that of the other frame",
            );
        }
    }

    /// ω for Ω and Ω for ω, where the document has both.
    fn other_rate(&self, quantity: Option<Quantity>) -> Option<String> {
        let wanted = if quantity == Some(Quantity::FrameRate) {
            Quantity::AngularVelocity
        } else {
            Quantity::FrameRate
        };
        let letter = self
            .reading
            .quantities
            .iter()
            .find(|(_, q)| **q == wanted)?
            .0;
        Some(crate::verify::values::symbol::latex_name(&letter.name))
    }
}
