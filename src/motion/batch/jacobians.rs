//! Jacobians of the bodies of a batch.

use crate::motion::{LANES, Lane};
use nalgebra::SMatrix;

/// The Jacobians of one step of many bodies, of 6 rows and `N` columns each, eight bodies side by side.
#[derive(Clone, Debug, Default)]
pub struct Jacobians<const N: usize> {
    len: usize,
    blocks: Vec<[[Lane; 6]; N]>,
}

impl<const N: usize> Jacobians<N> {
    /// Room that grows to the batch when it is first used.
    pub fn new() -> Self {
        Self {
            len: 0,
            blocks: Vec::new(),
        }
    }

    /// For how many bodies there are Jacobians.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The Jacobian of a body, `None` past the last.
    pub fn of_body(&self, body: usize) -> Option<SMatrix<f64, 6, N>> {
        let block = self.blocks.get(body / LANES).filter(|_| body < self.len)?;
        Some(SMatrix::from_fn(|row, column| {
            block[column][row][body % LANES]
        }))
    }

    pub(super) fn resize(&mut self, len: usize) {
        self.len = len;
        let nothing = [[[0.0; LANES]; 6]; N];
        self.blocks.resize(len.div_ceil(LANES), nothing);
    }

    pub(super) fn blocks_mut(&mut self) -> impl Iterator<Item = &mut [[Lane; 6]; N]> {
        self.blocks.iter_mut()
    }
}
