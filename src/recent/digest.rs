//! Short names of long things, so that little is kept of what is looked for.

use std::hash::{BuildHasher, Hash, Hasher, RandomState};
use std::sync::OnceLock;

/// What a thing is looked for by: 128 bits, made with a key that each run has of its own.
///
/// Two things have one digest with a probability of 2⁻¹²⁸, and who does not know the key can't make two that do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Digest([u64; 2]);

static KEY: OnceLock<RandomState> = OnceLock::new();

impl Digest {
    /// Of something whose hash takes in all of it.
    pub fn of(thing: &(impl Hash + ?Sized)) -> Self {
        let mut all = Bytes(Vec::with_capacity(USUAL));
        thing.hash(&mut all);
        Self::of_bytes(&all.0)
    }

    /// Of some bytes.
    pub fn of_bytes(bytes: &[u8]) -> Self {
        let mut hasher = KEY.get_or_init(Default::default).build_hasher();
        hasher.write(bytes);
        let first = hasher.finish();
        // All of the hidden state goes into both halves.
        hasher.write_u8(0);
        Self([first, hasher.finish()])
    }
}

/// Most things have no more bytes.
const USUAL: usize = 1_024;

/// All that a thing says of itself, so that the key meets it in one piece.
struct Bytes(Vec<u8>);

impl Hasher for Bytes {
    fn write(&mut self, bytes: &[u8]) {
        self.0.extend_from_slice(bytes);
    }

    fn finish(&self) -> u64 {
        0
    }
}
