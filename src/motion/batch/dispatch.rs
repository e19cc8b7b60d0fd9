//! The blocks of a batch shared out, and one piece of work for each compiled for the machine at hand.

use super::Failed;
use pulp::{Arch, Simd, WithSimd};

/// Calls `work` with all blocks; the body that failed first.
#[cfg(not(feature = "parallel"))]
pub(super) fn for_each_share<B: Send>(
    blocks: &mut [B],
    work: impl Fn(usize, &mut [B]) -> Option<Failed> + Sync,
) -> Option<Failed> {
    work(0, blocks)
}

/// Calls `work` with shares of the blocks and the place of the first of each, on all threads; the body
/// that failed first.
#[cfg(feature = "parallel")]
pub(super) fn for_each_share<B: Send>(
    blocks: &mut [B],
    work: impl Fn(usize, &mut [B]) -> Option<Failed> + Sync,
) -> Option<Failed> {
    use rayon::{iter::IndexedParallelIterator, iter::ParallelIterator, slice::ParallelSliceMut};
    /// Blocks for a thread at a time: enough to be worth the handing out, few enough to even out.
    const SHARE: usize = 64;
    blocks
        .par_chunks_mut(SHARE)
        .enumerate()
        .map(|(share, blocks)| work(share * SHARE, blocks))
        .reduce(|| None, Failed::first)
}

/// Calls `work` with the place of every block and the block, in the widest registers; the body that failed first,
/// of which the work says the lane.
pub(super) fn for_each_block<B: Send>(
    blocks: &mut [B],
    work: impl Fn(usize, &mut B) -> Option<Failed> + Sync,
) -> Option<Failed> {
    for_each_share(blocks, |first, blocks| {
        Arch::new().dispatch(Run {
            blocks,
            first,
            work: &work,
        })
    })
}

/// The loop over the blocks. A closure here would be compiled apart, for the least of machines.
struct Run<'a, B, F> {
    blocks: &'a mut [B],
    first: usize,
    work: &'a F,
}

impl<B, F: Fn(usize, &mut B) -> Option<Failed>> WithSimd for Run<'_, B, F> {
    type Output = Option<Failed>;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn with_simd<S: Simd>(self, _: S) -> Option<Failed> {
        let mut failed = None;
        for (i, block) in self.blocks.iter_mut().enumerate() {
            if let Some(found) = (self.work)(self.first + i, block) {
                failed = Failed::first(failed, Some(found.in_block(self.first + i)));
            }
        }
        failed
    }
}
