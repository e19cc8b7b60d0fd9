//! Matrices, columns, determinants.

use super::{Parser, closing, split_outside};
use crate::notation::ast::{Function, Kind, Node};
use crate::notation::token::{Lexeme, Token};

impl<'t, 'a> Parser<'t, 'a> {
    /// An environment inside an expression.
    pub(super) fn environment(&mut self, name: &'a str, start: usize) -> Node {
        let end = closing(self.tokens, start);
        let inside = &self.tokens[(start + 1).min(end)..end];
        self.at = (end + 1).min(self.tokens.len());
        let node = match name {
            "vmatrix" | "Vmatrix" | "vsmallmatrix" => match self.cells(inside) {
                Ok(rows) => self.node(Kind::Determinant(rows), start),
                Err(node) => node,
            },
            "matrix" | "bmatrix" | "pmatrix" | "Bmatrix" | "smallmatrix" | "bsmallmatrix"
            | "psmallmatrix" | "array" => match self.cells(inside) {
                Ok(rows) => self.matrix(rows, start),
                Err(node) => node,
            },
            "cases" | "dcases" | "rcases" => self.spanning("a value by cases is not read", start),
            _ if !inside.iter().any(|t| t.kind == Lexeme::Row) && !inside.is_empty() => {
                self.inside(inside).whole()
            }
            _ => self.spanning(&format!("the environment {name} is not known here"), start),
        };
        self.scripts(node, start)
    }

    /// A matrix of these cells; one that holds nothing but a diagonal matrix is that one.
    fn matrix(&self, mut rows: Vec<Vec<Node>>, start: usize) -> Node {
        let diagonal = |node: &Node| matches!(node.kind, Kind::Function(Function::Diag, _));
        if let [row] = rows.as_mut_slice()
            && row.len() == 1
            && let Some(only) = row.pop_if(|node| diagonal(node))
        {
            return only;
        }
        self.node(Kind::Matrix(rows), start)
    }

    /// `\dmat{a, b, c}`: the diagonal matrix of these.
    pub(super) fn diagonal(&mut self, start: usize) -> Node {
        let inside = self.argument();
        let entries = split_outside(inside, |t| t.kind == Lexeme::Char(','))
            .into_iter()
            .map(|entry| self.inside(entry).whole())
            .collect();
        let tuple = self.node(Kind::Tuple(entries), start);
        self.node(Kind::Function(Function::Diag, Box::new(tuple)), start)
    }

    fn zero(&self) -> Node {
        Node {
            kind: Kind::Number(super::product::read_number("0")),
            span: self.here(),
        }
    }

    fn spanning(&self, message: &str, start: usize) -> Node {
        self.node(Kind::Error(message.to_owned()), start)
    }

    /// The cells of a matrix; all rows are of one length.
    fn cells(&self, inside: &'t [Token<'a>]) -> Result<Vec<Vec<Node>>, Node> {
        // What is left blank in a matrix of several columns is zero.
        let blank = |cell: &[Token<'_>]| cell.iter().all(|t| matches!(t.kind, Lexeme::Space(_)));
        let mut rows: Vec<&'t [Token<'a>]> = split_outside(inside, |t| t.kind == Lexeme::Row);
        if rows.last().is_some_and(|row| row.is_empty()) {
            rows.pop();
        }
        let spaced = !rows.is_empty() && rows.iter().all(|row| is_spaced(row));
        let cells: Vec<Vec<Node>> = rows
            .into_iter()
            .map(|row| {
                let cells = split_outside(row, |t| t.kind == Lexeme::Ampersand);
                let cells = if spaced { every_other(&cells) } else { cells };
                let several = cells.len() > 1;
                let read = |cell: &'t [Token<'a>]| {
                    let inside = self.inside(cell);
                    match several && blank(cell) {
                        true => inside.zero(),
                        false => inside.whole(),
                    }
                };
                cells.into_iter().map(read).collect()
            })
            .collect();
        let width = cells.first().map_or(0, Vec::len);
        match cells.iter().position(|row| row.len() != width) {
            _ if width == 0 => Err(self.error("a matrix without cells")),
            Some(row) => Err(self.error(format!(
                "row {} of a matrix has another length than row 1",
                row + 1
            ))),
            None => Ok(cells),
        }
    }
}

/// `a && b && c`: whether the cells of a row stand two signs apart and none is left blank, so that the columns between them are
/// space.
fn is_spaced(row: &[Token<'_>]) -> bool {
    let cells = split_outside(row, |t| t.kind == Lexeme::Ampersand);
    let mut at = 0;
    let odd = cells.len() % 2 == 1 && cells.len() > 1;
    odd && cells.iter().enumerate().all(|(place, cell)| {
        let begins = at;
        at += cell.len() + 1;
        match (place % 2, begins.checked_sub(1)) {
            (1, Some(before)) => {
                let signs = row.get(before).zip(row.get(begins));
                cell.is_empty()
                    && signs.is_some_and(|(one, other)| one.span.end == other.span.start)
            }
            _ => !cell.iter().all(|t| matches!(t.kind, Lexeme::Space(_))),
        }
    })
}

/// The first, third and further cells.
fn every_other<'t, 'a>(cells: &[&'t [Token<'a>]]) -> Vec<&'t [Token<'a>]> {
    cells.iter().step_by(2).copied().collect()
}
