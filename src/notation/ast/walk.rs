//! The way through a tree, from each node to those right below it.

use super::{Factor, Kind, Node, Symbol, Term};
use std::iter::Flatten;
use std::mem::replace;
use std::slice;

/// The lower and the upper limit, where they are written.
fn ends(limits: &Option<(Box<Node>, Box<Node>)>) -> [Option<&Node>; 2] {
    match limits {
        Some((lower, upper)) => [Some(lower), Some(upper)],
        None => [None; 2],
    }
}

/// The nodes right below a node that are still to come: one ahead of the others.
struct Children<'n> {
    first: Option<&'n Node>,
    rest: Rest<'n>,
}

enum Rest<'n> {
    Few([Option<&'n Node>; 3]),
    Nodes(slice::Iter<'n, Node>),
    Terms(slice::Iter<'n, Term>),
    Factors(slice::Iter<'n, Factor>),
    Rows(Flatten<slice::Iter<'n, Vec<Node>>>),
}

impl<'n> Iterator for Children<'n> {
    type Item = &'n Node;

    #[inline]
    fn next(&mut self) -> Option<&'n Node> {
        if self.first.is_some() {
            return self.first.take();
        }
        match &mut self.rest {
            Rest::Few([next, then, last]) => replace(next, replace(then, last.take())),
            Rest::Nodes(nodes) => nodes.next(),
            Rest::Terms(terms) => terms.next().map(|term| &term.node),
            Rest::Factors(factors) => factors.next().map(|factor| &factor.node),
            Rest::Rows(nodes) => nodes.next(),
        }
    }
}

impl Node {
    /// The nodes right below a node, in their order.
    pub fn children(&self) -> impl Iterator<Item = &Self> {
        let (first, rest): (Option<&Self>, _) = match &self.kind {
            Kind::Number(_) | Kind::Symbol(_) | Kind::Bold(_) | Kind::Ellipsis | Kind::Error(_) => {
                (None, Rest::Few([None; 3]))
            }
            Kind::Negate(a)
            | Kind::Transpose(a)
            | Kind::Skew(a)
            | Kind::Group(_, a)
            | Kind::Norm(a)
            | Kind::Function(_, a)
            | Kind::InFrame(a, _)
            | Kind::PlusMinus(a)
            | Kind::WithUnit(a, _)
            | Kind::TimeDerivative { operand: a, .. } => (Some(a), Rest::Few([None; 3])),
            Kind::Quotient(a, b) | Kind::Power(a, b) => (Some(a), Rest::Few([Some(b), None, None])),
            Kind::Sum(terms) => (None, Rest::Terms(terms.iter())),
            Kind::Product(factors) => (None, Rest::Factors(factors.iter())),
            Kind::Tuple(entries) => (None, Rest::Nodes(entries.iter())),
            Kind::Matrix(rows) | Kind::Determinant(rows) => {
                (None, Rest::Rows(rows.iter().flatten()))
            }
            Kind::Derivative {
                operand: head,
                variables: rest,
                ..
            }
            | Kind::Call(head, rest) => (Some(head), Rest::Nodes(rest.iter())),
            Kind::Integral {
                integrand,
                variable,
                limits,
            } => {
                let [lower, upper] = ends(limits);
                (Some(integrand), Rest::Few([Some(variable), lower, upper]))
            }
            Kind::IndexedSum { limits, body, .. } => {
                let [lower, upper] = ends(limits);
                (Some(body), Rest::Few([lower, upper, None]))
            }
        };
        Children { first, rest }
    }

    /// The nodes right below a node, to be changed.
    pub fn children_mut(&mut self) -> Vec<&mut Self> {
        match &mut self.kind {
            Kind::Number(_) | Kind::Symbol(_) | Kind::Bold(_) | Kind::Ellipsis | Kind::Error(_) => {
                vec![]
            }
            Kind::Negate(a)
            | Kind::Transpose(a)
            | Kind::Skew(a)
            | Kind::Group(_, a)
            | Kind::Norm(a)
            | Kind::Function(_, a)
            | Kind::InFrame(a, _)
            | Kind::PlusMinus(a)
            | Kind::WithUnit(a, _)
            | Kind::TimeDerivative { operand: a, .. } => vec![a],
            Kind::Quotient(a, b) | Kind::Power(a, b) => vec![a, b],
            Kind::Sum(terms) => terms.iter_mut().map(|t| &mut t.node).collect(),
            Kind::Product(factors) => factors.iter_mut().map(|f| &mut f.node).collect(),
            Kind::Tuple(entries) => entries.iter_mut().collect(),
            Kind::Matrix(rows) | Kind::Determinant(rows) => rows.iter_mut().flatten().collect(),
            Kind::Derivative {
                operand, variables, ..
            } => std::iter::once(&mut **operand).chain(variables).collect(),
            Kind::Call(head, arguments) => std::iter::once(&mut **head).chain(arguments).collect(),
            Kind::Integral {
                integrand,
                variable,
                limits,
            } => {
                let limits = limits.iter_mut().flat_map(|(a, b)| [&mut **a, &mut **b]);
                [&mut **integrand, &mut **variable]
                    .into_iter()
                    .chain(limits)
                    .collect()
            }
            Kind::IndexedSum { limits, body, .. } => {
                let limits = limits.iter_mut().flat_map(|(a, b)| [&mut **a, &mut **b]);
                std::iter::once(&mut **body).chain(limits).collect()
            }
        }
    }

    /// Changes every symbol of the node.
    pub fn change_symbols(&mut self, change: &mut impl FnMut(&mut Symbol)) {
        if let Kind::Symbol(symbol) = &mut self.kind {
            change(symbol);
        }
        for child in self.children_mut() {
            child.change_symbols(change);
        }
    }
}
