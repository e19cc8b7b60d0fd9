//! Sums and signs.

use super::Parser;
use crate::notation::ast::{Kind, Node, Term};
use crate::notation::token::Lexeme;
use crate::source::Span;

#[derive(Clone, Copy, PartialEq)]
enum Sign {
    Plus,
    Minus,
    Either,
}

impl Parser<'_, '_> {
    /// Terms with their signs.
    pub(super) fn sum(&mut self) -> Node {
        let start = self.at;
        let mut terms: Vec<Term> = vec![];
        loop {
            self.skip_spaces();
            let (sign, span) = self.sign();
            if sign.is_none() && !terms.is_empty() {
                break;
            }
            let before = self.at;
            let mut node = self.product();
            if sign == Some(Sign::Either) {
                node = Node {
                    span: span.to(node.span),
                    kind: Kind::PlusMinus(Box::new(node)),
                };
            }
            let broken = matches!(node.kind, Kind::Error(_)) && self.at == before;
            terms.push(Term {
                negative: sign == Some(Sign::Minus),
                sign: span,
                node,
            });
            self.skip_spaces();
            if broken || self.at_end() {
                break;
            }
        }
        self.close(terms, start)
    }

    /// What a sum over an index adds up, which a minus may lead: `\sum_i -m_i [r_i]^2`.
    pub(super) fn product_with_sign(&mut self) -> Node {
        let start = self.at;
        self.skip_spaces();
        if self.peek() != Some(Lexeme::Char('-')) {
            return self.product();
        }
        let (sign, span) = self.sign();
        let node = self.product();
        let terms = vec![Term {
            negative: sign == Some(Sign::Minus),
            sign: span,
            node,
        }];
        self.close(terms, start)
    }

    fn close(&self, mut terms: Vec<Term>, start: usize) -> Node {
        if terms.len() > 1 {
            return self.node(Kind::Sum(terms), start);
        }
        match terms.pop() {
            None => self.error(self.unexpected()),
            Some(term) if term.negative => Node {
                span: term.sign.to(term.node.span),
                kind: Kind::Negate(Box::new(term.node)),
            },
            Some(term) => term.node,
        }
    }

    /// A run of signs as one: `+ -` is a minus.
    fn sign(&mut self) -> (Option<Sign>, Span) {
        let mut sign = None;
        let mut span = Span {
            start: self.here().start,
            end: self.here().start,
        };
        loop {
            let next = match self.peek() {
                Some(Lexeme::Char('+')) => Sign::Plus,
                Some(Lexeme::Char('-')) => Sign::Minus,
                Some(Lexeme::Command("pm" | "mp")) => Sign::Either,
                _ => return (sign, span),
            };
            span = if sign.is_none() {
                self.here()
            } else {
                span.to(self.here())
            };
            sign = Some(match (sign, next) {
                (Some(Sign::Either), _) | (_, Sign::Either) => Sign::Either,
                (Some(Sign::Minus), Sign::Minus) => Sign::Plus,
                (Some(Sign::Minus), Sign::Plus) => Sign::Minus,
                (_, next) => next,
            });
            self.at += 1;
            self.skip_spaces_and_groups();
        }
    }

    /// `{}` is written before a sign only for its spacing.
    fn skip_spaces_and_groups(&mut self) {
        self.skip_spaces();
        while self.peek() == Some(Lexeme::Open) && self.peek_at(1) == Some(Lexeme::Close) {
            self.at += 2;
            self.skip_spaces();
        }
    }
}
