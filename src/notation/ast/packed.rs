//! Plain trees in few bytes, places included, so that many are kept in little memory.
//!
//! Places are counted from a first byte, and a tree may be unpacked as if it began at another one.

use super::alike::marks;
use super::{
    Bracket, DerivativeStyle, Factor, FrameLabel, Kind, Line, Node, Number, Operator, Relation,
    Style, Symbol, Term,
};
use crate::source::Span;
use num_rational::BigRational;
use num_traits::ToPrimitive;

const RELATIONS: [Relation; 9] = [
    Relation::Equal,
    Relation::Defined,
    Relation::Approximate,
    Relation::NotEqual,
    Relation::Less,
    Relation::LessOrEqual,
    Relation::Greater,
    Relation::GreaterOrEqual,
    Relation::Other,
];
const OPERATORS: [Operator; 4] = [
    Operator::Juxtaposed,
    Operator::Dot,
    Operator::Cross,
    Operator::Tensor,
];
const BRACKETS: [Bracket; 3] = [Bracket::Round, Bracket::Square, Bracket::Curly];
const STYLES: [DerivativeStyle; 2] = [DerivativeStyle::Dots, DerivativeStyle::Leibniz];

/// Lines longer than this take more.
const USUAL: usize = 512;

/// A line whose first byte is this one of its source; `None` for one that is not plain.
pub(crate) fn packed(line: &Line, first: usize) -> Option<Vec<u8>> {
    let Line {
        sides,
        relations,
        continues,
        labels,
        ranges,
        remarks,
        span,
    } = line;
    if !labels.is_empty() || !ranges.is_empty() || !remarks.is_empty() {
        return None;
    }
    let mut packer = Packer {
        bytes: Vec::with_capacity(USUAL),
        first: u32::try_from(first).ok().filter(|first| *first > 0)?,
    };
    packer.span(*span)?;
    packer.bytes.push(u8::from(*continues));
    packer.number(relations.len());
    for (relation, span) in relations {
        packer.bytes.push(*relation as u8);
        packer.span(*span)?;
    }
    packer.number(sides.len());
    sides.iter().try_for_each(|side| packer.node(side))?;
    packer.bytes.shrink_to_fit();
    Some(packer.bytes)
}

/// The line of which these are the bytes, as if it stood behind so many others.
pub(crate) fn unpacked(bytes: &[u8], first: usize) -> Option<Line> {
    let mut packet = Packet {
        bytes,
        first: u32::try_from(first).ok()?,
    };
    Some(Line {
        span: packet.span()?,
        continues: packet.byte()? == 1,
        relations: packet.each(|own| {
            let relation = own.one_of(&RELATIONS)?;
            Some((relation, own.span()?))
        })?,
        sides: packet.each(Packet::node)?,
        labels: vec![],
        ranges: vec![],
        remarks: vec![],
    })
}

struct Packer {
    bytes: Vec<u8>,
    first: u32,
}

impl Packer {
    /// Seven bits a byte, and in all but the last byte the eighth.
    fn number(&mut self, number: usize) {
        let mut rest = number;
        while rest >= 0x80 {
            self.bytes.push(rest as u8 | 0x80);
            rest >>= 7;
        }
        self.bytes.push(rest as u8);
    }

    fn text(&mut self, text: &str) {
        self.number(text.len());
        self.bytes.extend(text.as_bytes());
    }

    /// Where nothing is written there may be no place.
    fn span(&mut self, span: Span) -> Option<()> {
        if span == Span::default() {
            self.bytes.push(0);
            return Some(());
        }
        let start = span.start.checked_sub(self.first)?;
        self.number(start as usize + 1);
        self.number(span.end.checked_sub(span.start)? as usize);
        Some(())
    }

    fn node(&mut self, node: &Node) -> Option<()> {
        self.span(node.span)?;
        match &node.kind {
            Kind::Number(number) => self.numeral(number),
            Kind::Symbol(symbol) => {
                self.symbol(symbol);
                Some(())
            }
            Kind::Negate(inner) => self.inside(2, inner),
            Kind::Sum(terms) => {
                self.bytes.push(3);
                self.number(terms.len());
                terms.iter().try_for_each(|term| {
                    self.bytes.push(u8::from(term.negative));
                    self.span(term.sign)?;
                    self.node(&term.node)
                })
            }
            Kind::Product(factors) => {
                self.bytes.push(4);
                self.number(factors.len());
                factors.iter().try_for_each(|factor| {
                    self.bytes.push(factor.operator as u8);
                    self.span(factor.sign)?;
                    self.node(&factor.node)
                })
            }
            Kind::Quotient(above, below) => {
                self.inside(5, above)?;
                self.node(below)
            }
            Kind::Power(base, exponent) => {
                self.inside(6, base)?;
                self.node(exponent)
            }
            Kind::Group(bracket, inner) => {
                self.bytes.extend([7, *bracket as u8]);
                self.node(inner)
            }
            Kind::TimeDerivative {
                operand,
                order,
                style,
                frame,
            } => {
                self.bytes.extend([8, *order, *style as u8]);
                self.bytes.push(u8::from(frame.is_some()));
                frame.iter().try_for_each(|frame| self.label(frame))?;
                self.node(operand)
            }
            Kind::InFrame(inner, frame) => {
                self.bytes.push(9);
                self.label(frame)?;
                self.node(inner)
            }
            _ => None,
        }
    }

    fn inside(&mut self, kind: u8, inner: &Node) -> Option<()> {
        self.bytes.push(kind);
        self.node(inner)
    }

    fn numeral(&mut self, number: &Number) -> Option<()> {
        let is_plain = number.decimals.is_none() && number.exponent == 0;
        let whole = number.value.is_integer().then(|| number.value.numer());
        let small = whole.and_then(ToPrimitive::to_u32).filter(|_| is_plain)?;
        self.bytes.push(0);
        self.number(small as usize);
        Some(())
    }

    fn symbol(&mut self, symbol: &Symbol) {
        self.bytes.push(1);
        self.text(&symbol.name);
        let marks = marks(symbol).into_iter().map(usize::from);
        self.number(marks.fold(0, |all, mark| all << 1 | mark));
        self.bytes.push(symbol.primes);
        for indices in [&symbol.subscripts, &symbol.superscripts] {
            self.number(indices.len());
            indices.iter().for_each(|index| self.text(index));
        }
    }

    fn label(&mut self, label: &FrameLabel) -> Option<()> {
        self.text(&label.text);
        self.span(label.span)
    }
}

/// What is left to unpack.
struct Packet<'b> {
    bytes: &'b [u8],
    first: u32,
}

impl<'b> Packet<'b> {
    fn byte(&mut self) -> Option<u8> {
        let (byte, rest) = self.bytes.split_first()?;
        self.bytes = rest;
        Some(*byte)
    }

    fn number(&mut self) -> Option<usize> {
        let (mut number, mut shift) = (0, 0);
        loop {
            let byte = self.byte()?;
            number |= usize::from(byte & 0x7f) << shift;
            shift += 7;
            if byte < 0x80 {
                return Some(number);
            }
        }
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> Option<T> {
        let place = self.byte()?;
        all.get(usize::from(place)).copied()
    }

    fn text(&mut self) -> Option<&'b str> {
        let length = self.number()?;
        let (text, rest) = self.bytes.split_at_checked(length)?;
        self.bytes = rest;
        std::str::from_utf8(text).ok()
    }

    fn each<T>(&mut self, one: impl Fn(&mut Self) -> Option<T>) -> Option<Vec<T>> {
        let count = self.number()?;
        let mut all = Vec::with_capacity(count);
        for _ in 0..count {
            all.push(one(self)?);
        }
        Some(all)
    }

    fn span(&mut self) -> Option<Span> {
        let Some(start) = self.number()?.checked_sub(1) else {
            return Some(Span::default());
        };
        let start = self.first.checked_add(u32::try_from(start).ok()?)?;
        let length = u32::try_from(self.number()?).ok()?;
        let end = start.checked_add(length)?;
        Some(Span { start, end })
    }

    fn node(&mut self) -> Option<Node> {
        let span = self.span()?;
        let kind = match self.byte()? {
            0 => Kind::Number(Number {
                value: BigRational::from_integer(self.number()?.into()),
                decimals: None,
                exponent: 0,
            }),
            1 => Kind::Symbol(self.symbol()?),
            2 => Kind::Negate(self.boxed()?),
            3 => Kind::Sum(self.each(|own| {
                Some(Term {
                    negative: own.byte()? == 1,
                    sign: own.span()?,
                    node: own.node()?,
                })
            })?),
            4 => Kind::Product(self.each(|own| {
                Some(Factor {
                    operator: own.one_of(&OPERATORS)?,
                    sign: own.span()?,
                    node: own.node()?,
                })
            })?),
            5 => Kind::Quotient(self.boxed()?, self.boxed()?),
            6 => Kind::Power(self.boxed()?, self.boxed()?),
            7 => Kind::Group(self.one_of(&BRACKETS)?, self.boxed()?),
            8 => self.rate()?,
            _ => {
                let label = self.label()?;
                Kind::InFrame(self.boxed()?, label)
            }
        };
        Some(Node { kind, span })
    }

    fn rate(&mut self) -> Option<Kind> {
        let (order, style) = (self.byte()?, self.one_of(&STYLES)?);
        let frame = match self.byte()? {
            0 => None,
            _ => Some(self.label()?),
        };
        Some(Kind::TimeDerivative {
            operand: self.boxed()?,
            order,
            style,
            frame,
        })
    }

    fn boxed(&mut self) -> Option<Box<Node>> {
        self.node().map(Box::new)
    }

    fn label(&mut self) -> Option<FrameLabel> {
        Some(FrameLabel {
            text: self.text()?.to_owned(),
            span: self.span()?,
        })
    }

    fn symbol(&mut self) -> Option<Symbol> {
        let name = self.text()?.to_owned();
        let marks = self.number()?;
        let mark = |place: usize| marks >> (9 - place) & 1 == 1;
        let index = |own: &mut Self| own.text().map(str::to_owned);
        Some(Symbol {
            name,
            style: Style {
                vector: mark(0),
                hat: mark(1),
                bar: mark(2),
                tensor: mark(3),
                calligraphic: mark(4),
                tilde: mark(5),
                upright: mark(6),
                other: mark(7),
            },
            resultant: mark(8),
            variation: mark(9),
            primes: self.byte()?,
            subscripts: self.each(index)?,
            superscripts: self.each(index)?,
        })
    }
}
