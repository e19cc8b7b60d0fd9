//! One piece of work for every block, compiled for the instructions of the machine at hand.

use pulp::Arch;

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
    Arch::new().dispatch(
        #[inline(always)]
        || {
            let mut all = true;
            for (i, block) in blocks.iter_mut().enumerate() {
                all &= work(first + i, block);
            }
            all
        },
    )
}
