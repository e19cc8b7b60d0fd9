//! The blocks of a batch shared out, and one piece of work for each compiled for the machine at hand.

use pulp::{Arch, Simd, WithSimd};

/// Calls `work` with all blocks; whether it was true.
#[cfg(not(feature = "parallel"))]
pub(super) fn for_each_share<B: Send>(
    blocks: &mut [B],
    work: impl Fn(usize, &mut [B]) -> bool + Sync,
) -> bool {
    work(0, blocks)
}

/// Calls `work` with shares of the blocks and the place of the first of each, on all threads; whether it was true of all.
#[cfg(feature = "parallel")]
pub(super) fn for_each_share<B: Send>(
    blocks: &mut [B],
    work: impl Fn(usize, &mut [B]) -> bool + Sync,
) -> bool {
    use rayon::{iter::IndexedParallelIterator, iter::ParallelIterator, slice::ParallelSliceMut};
    /// Blocks for a thread at a time: enough to be worth the handing out, few enough to even out.
    const SHARE: usize = 64;
    blocks
        .par_chunks_mut(SHARE)
        .enumerate()
        .map(|(share, blocks)| work(share * SHARE, blocks))
        .reduce(|| true, |a, b| a && b)
}

/// Calls `work` with the place of every block and the block, in the widest registers; whether it was true of all.
pub(super) fn for_each_block<B: Send>(
    blocks: &mut [B],
    work: impl Fn(usize, &mut B) -> bool + Sync,
) -> bool {
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

impl<B, F: Fn(usize, &mut B) -> bool> WithSimd for Run<'_, B, F> {
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> bool {
        let mut all = true;
        for (i, block) in self.blocks.iter_mut().enumerate() {
            all &= (self.work)(self.first + i, block);
        }
        all
    }
}
