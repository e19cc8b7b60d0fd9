//! One piece of work for every block, compiled for the instructions of the machine at hand.

use pulp::{Arch, Simd, WithSimd};

/// Calls `work` with the place of every block and the block; whether it was true of all.
#[cfg(not(feature = "parallel"))]
pub(super) fn for_each_block<B: Send>(
    blocks: &mut [B],
    work: impl Fn(usize, &mut B) -> bool + Sync,
) -> bool {
    run(blocks, 0, &work)
}

/// Calls `work` with the place of every block and the block; whether it was true of all.
#[cfg(feature = "parallel")]
pub(super) fn for_each_block<B: Send>(
    blocks: &mut [B],
    work: impl Fn(usize, &mut B) -> bool + Sync,
) -> bool {
    use rayon::{iter::IndexedParallelIterator, iter::ParallelIterator, slice::ParallelSliceMut};
    /// Blocks for a thread at a time: enough to be worth the handing out, few enough to even out.
    const SHARE: usize = 64;
    blocks
        .par_chunks_mut(SHARE)
        .enumerate()
        .map(|(share, blocks)| run(blocks, share * SHARE, &work))
        .reduce(|| true, |a, b| a && b)
}

fn run<B>(blocks: &mut [B], first: usize, work: &impl Fn(usize, &mut B) -> bool) -> bool {
    Arch::new().dispatch(Run {
        blocks,
        first,
        work,
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
