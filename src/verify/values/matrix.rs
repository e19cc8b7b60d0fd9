//! Matrices and determinants that are written out.

use crate::algebra::Fraction;
use crate::notation::ast::Node;
use crate::verify::values::lower::{Lowered, Lowering, TroubleKind, trouble};
use crate::verify::values::value::{ShapeMismatch, Value};
use num_traits::Zero;

impl Lowering<'_> {
    pub(crate) fn grid(&mut self, node: &Node, rows: &[Vec<Node>]) -> Lowered {
        let columns = rows.first().map_or(0, Vec::len);
        if rows.is_empty() || columns == 0 || rows.iter().any(|row| row.len() != columns) {
            return Err(trouble(
                TroubleKind::Unreadable,
                node.span,
                "the rows of this matrix differ in length",
            ));
        }
        let blocks: Vec<Vec<Value>> = rows
            .iter()
            .map(|row| row.iter().map(|entry| self.value(entry)).collect())
            .collect::<Result<_, _>>()?;
        joined(&blocks).map_err(|m| trouble(TroubleKind::IllTyped, node.span, m))
    }

    /// A list of components; of a number and a vector it is a column of four.
    pub(crate) fn tuple(&mut self, node: &Node, entries: &[Node]) -> Lowered {
        let values: Vec<Value> = entries
            .iter()
            .map(|entry| self.value(entry))
            .collect::<Result<_, _>>()?;
        // Three columns beside one another are a matrix.
        if values.len() == 3 && values.iter().all(|v| (v.rows, v.columns) == (3, 1)) {
            return joined(&[values]).map_err(|m| trouble(TroubleKind::IllTyped, node.span, m));
        }
        match self.stacked(&values) {
            Some(column) => Ok(column),
            None => joined(&[values])
                .map(|value| value.transposed())
                .map_err(|m| trouble(TroubleKind::IllTyped, node.span, m)),
        }
    }

    /// A determinant; with unit vectors in its first row it is a cross product.
    pub(crate) fn determinant(&mut self, node: &Node, rows: &[Vec<Node>]) -> Lowered {
        let ill = |ShapeMismatch(message)| trouble(TroubleKind::IllTyped, node.span, message);
        let values: Vec<Vec<Value>> = rows
            .iter()
            .map(|row| row.iter().map(|entry| self.value(entry)).collect())
            .collect::<Result<_, _>>()?;
        let vector_row = values
            .first()
            .is_some_and(|row| row.len() == 3 && row.iter().all(Value::is_vector));
        if !vector_row {
            return self
                .grid(node, rows)?
                .determinant()
                .map(Value::scalar)
                .map_err(ill);
        }
        let rest =
            joined(&values[1..]).map_err(|m| trouble(TroubleKind::IllTyped, node.span, m))?;
        if (rest.rows, rest.columns) != (2, 3) {
            return Err(trouble(
                TroubleKind::IllTyped,
                node.span,
                "a determinant of unequal sides",
            ));
        }
        let mut sum = Value::scalar(Fraction::zero());
        for (c, unit) in values[0].iter().enumerate() {
            let (i, j) = ((c + 1) % 3, (c + 2) % 3);
            let minor = rest.at(0, i).clone() * rest.at(1, j).clone()
                - rest.at(0, j).clone() * rest.at(1, i).clone();
            sum = sum.plus(&unit.scaled(&minor), false).map_err(ill)?;
        }
        Ok(sum)
    }
}

/// One grid of a grid of blocks; scalar zeros grow to the size of their row and column.
fn joined(blocks: &[Vec<Value>]) -> Result<Value, String> {
    let columns = blocks.first().map_or(0, Vec::len);
    let width = |c: usize| blocks.iter().map(|row| row[c].columns).max().unwrap_or(1);
    let height = |r: usize| blocks[r].iter().map(|v| v.rows).max().unwrap_or(1);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut entries = vec![];
    for (r, row) in blocks.iter().enumerate() {
        for i in 0..height(r) {
            for (block, &wide) in row.iter().zip(&widths) {
                let fits = block.rows == height(r) && block.columns == wide;
                let null = block.is_scalar() && block.is_zero();
                if !(fits || null) {
                    return Err(format!("{} does not fit beside the others", block.shape()));
                }
                entries.extend((0..wide).map(|j| {
                    if fits {
                        block.at(i, j).clone()
                    } else {
                        Fraction::zero()
                    }
                }));
            }
        }
    }
    let rows = (0..blocks.len()).map(height).sum();
    Ok(Value {
        rows,
        columns: widths.iter().sum(),
        entries,
    })
}
