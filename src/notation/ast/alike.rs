//! Trees that say the same wherever they stand.

use super::{DerivativeStyle, FrameLabel, Kind, Node, Number, Style, Symbol};
use num_traits::ToPrimitive;

/// A tree written down without its places, so that others can be found that are like it. No two that differ are written
/// alike.
#[derive(Debug)]
pub(crate) struct Shape(Vec<u8>);

/// Most formulas take no more bytes.
const USUAL: usize = 256;

impl Default for Shape {
    fn default() -> Self {
        Self(Vec::with_capacity(USUAL))
    }
}

impl Shape {
    /// Its bytes.
    pub(crate) fn into_bytes(self) -> Vec<u8> {
        self.0
    }

    pub(crate) fn as_bytes(&self) -> &[u8] {
        &self.0
    }

    /// Seven bits a byte, and in all but the last byte the eighth.
    pub(crate) fn number(&mut self, number: usize) {
        let mut rest = number;
        while rest >= 0x80 {
            self.0.push(rest as u8 | 0x80);
            rest >>= 7;
        }
        self.0.push(rest as u8);
    }

    fn byte(&mut self, byte: u8) {
        self.0.push(byte);
    }

    pub(crate) fn text(&mut self, text: &str) {
        self.bytes(text.as_bytes());
    }

    fn bytes(&mut self, bytes: &[u8]) {
        self.number(bytes.len());
        self.0.extend(bytes);
    }

    /// The tree of a symbol.
    pub(crate) fn of_symbol(symbol: &Symbol) -> Self {
        let mut shape = Self::default();
        shape.symbol(symbol);
        shape
    }

    /// The tree of the rate of a symbol, which no frame is written beside.
    pub(crate) fn of_rate(symbol: &Symbol, order: u8, style: DerivativeStyle) -> Self {
        let mut shape = Self::default();
        shape.rate(order, style, None);
        shape.symbol(symbol);
        shape
    }

    /// Writes a tree behind what is there; `None` for one of which the text tells more than the tree does.
    pub(crate) fn tree(&mut self, node: &Node) -> Option<()> {
        match &node.kind {
            Kind::Number(number) => self.numeral(0, number),
            Kind::Bold(number) => self.numeral(1, number),
            Kind::Symbol(symbol) => self.symbol(symbol),
            Kind::Negate(_) => self.byte(3),
            Kind::Sum(terms) => {
                self.byte(4);
                self.number(terms.len());
                terms
                    .iter()
                    .for_each(|term| self.byte(u8::from(term.negative)));
            }
            Kind::Product(factors) => {
                self.byte(5);
                self.number(factors.len());
                factors
                    .iter()
                    .for_each(|factor| self.byte(factor.operator as u8));
            }
            Kind::Quotient(..) => self.byte(6),
            Kind::Power(..) => self.byte(7),
            Kind::Transpose(_) => self.byte(8),
            Kind::Group(bracket, _) => self.0.extend([9, *bracket as u8]),
            Kind::Norm(_) => self.byte(10),
            Kind::Tuple(entries) => {
                self.byte(11);
                self.number(entries.len());
            }
            Kind::Matrix(rows) => {
                self.byte(12);
                self.number(rows.len());
                rows.iter().for_each(|row| self.number(row.len()));
            }
            Kind::TimeDerivative {
                order,
                style,
                frame,
                ..
            } => self.rate(*order, *style, frame.as_ref()),
            Kind::Function(function, _) => self.0.extend([14, *function as u8]),
            Kind::InFrame(_, label) => {
                self.byte(15);
                self.label(Some(label));
            }
            _ => return None,
        }
        let mut children = node.children();
        children.try_for_each(|child| self.tree(child))
    }

    fn numeral(&mut self, kind: u8, number: &Number) {
        self.byte(kind);
        for part in [number.value.numer(), number.value.denom()] {
            // What fits is not the same as what does not: that takes more bytes.
            match part.to_i64() {
                Some(small) => self.bytes(&small.to_le_bytes()),
                None => self.bytes(&part.to_signed_bytes_le()),
            }
        }
        self.number(number.decimals.map_or(0, |decimals| decimals as usize + 1));
        self.number(number.exponent as usize);
    }

    fn symbol(&mut self, symbol: &Symbol) {
        self.byte(2);
        self.text(&symbol.name);
        let marks = marks(symbol).into_iter().map(usize::from);
        self.number(marks.fold(0, |all, mark| all << 1 | mark));
        self.byte(symbol.primes);
        for indices in [&symbol.subscripts, &symbol.superscripts] {
            self.number(indices.len());
            indices.iter().for_each(|index| self.text(index));
        }
    }

    fn rate(&mut self, order: u8, style: DerivativeStyle, frame: Option<&FrameLabel>) {
        self.0.extend([13, order, style as u8]);
        self.label(frame);
    }

    fn label(&mut self, label: Option<&FrameLabel>) {
        self.byte(u8::from(label.is_some()));
        if let Some(label) = label {
            self.text(&label.text);
        }
    }
}

/// What is drawn on a symbol and stands before it.
pub(super) fn marks(symbol: &Symbol) -> [bool; 10] {
    let Style {
        vector,
        hat,
        bar,
        tensor,
        calligraphic,
        tilde,
        upright,
        other,
    } = symbol.style;
    [
        vector,
        hat,
        bar,
        tensor,
        calligraphic,
        tilde,
        upright,
        other,
        symbol.resultant,
        symbol.variation,
    ]
}
