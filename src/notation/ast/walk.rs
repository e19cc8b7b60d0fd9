//! The way through a tree, from each node to those right below it.

use super::{Kind, Node, Symbol};

impl Node {
    /// The nodes right below a node.
    pub fn children(&self) -> Vec<&Self> {
        let mut children = vec![];
        self.each_child(&mut |child| children.push(child));
        children
    }

    /// Visits the nodes right below a node in their order.
    pub fn each_child<'n>(&'n self, visit: &mut dyn FnMut(&'n Self)) {
        match &self.kind {
            Kind::Number(_) | Kind::Symbol(_) | Kind::Bold(_) | Kind::Ellipsis | Kind::Error(_) => {
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
            | Kind::TimeDerivative { operand: a, .. } => visit(a),
            Kind::Quotient(a, b) | Kind::Power(a, b) => [a, b].into_iter().for_each(|n| visit(n)),
            Kind::Sum(terms) => terms.iter().for_each(|t| visit(&t.node)),
            Kind::Product(factors) => factors.iter().for_each(|f| visit(&f.node)),
            Kind::Tuple(entries) => entries.iter().for_each(visit),
            Kind::Matrix(rows) | Kind::Determinant(rows) => rows.iter().flatten().for_each(visit),
            Kind::Derivative {
                operand: head,
                variables: rest,
                ..
            }
            | Kind::Call(head, rest) => {
                visit(head);
                rest.iter().for_each(visit);
            }
            Kind::Integral {
                integrand,
                variable,
                limits,
            } => {
                visit(integrand);
                visit(variable);
                let limits = limits.iter().flat_map(|(a, b)| [a, b]);
                limits.for_each(|n| visit(n));
            }
            Kind::IndexedSum { limits, body, .. } => {
                visit(body);
                let limits = limits.iter().flat_map(|(a, b)| [a, b]);
                limits.for_each(|n| visit(n));
            }
        }
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
