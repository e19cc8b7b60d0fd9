//! What plain formulas were read as lately: in a class many write the same ones.

use crate::notation::ast::{packed, unpacked};
use crate::notation::document::Row;
use crate::notation::parse::rows::Reading;
use crate::recent::{Digest, Recent};
use std::cell::RefCell;
use std::sync::Arc;

/// No more bytes of formulas are kept, and none whose text is longer.
const MOST_BYTES: usize = 2 << 20;
const LONGEST: usize = 300;

/// What each takes besides.
const BYTES: usize = 120;

thread_local! {
    /// Formulas of one line by their texts.
    static READ: RefCell<Recent<Digest, Arc<[u8]>>> = RefCell::new(Recent::of(MOST_BYTES));
}

/// What is read in a text whose first byte stands at `offset`, as it was read before or is read now. Spaces around it say
/// nothing.
pub(super) fn read_lately(
    text: &str,
    offset: usize,
    read: impl FnOnce(&str, usize) -> Reading,
) -> Reading {
    let begun = text.trim_start_matches([' ', '\n']);
    let offset = offset + text.len() - begun.len();
    let text = match begun.trim_end_matches([' ', '\n']) {
        // A space behind a backslash is written.
        inner if inner.ends_with('\\') => begun,
        inner => inner,
    };
    if text.len() > LONGEST {
        return read(text, offset);
    }
    let key = Digest::of_bytes(text.as_bytes());
    let known = READ.with_borrow_mut(|kept| kept.get(&key));
    if let Some(line) = known.and_then(|bytes| unpacked(&bytes, offset)) {
        return Reading {
            rows: vec![Row::Line(line)],
            words: vec![],
        };
    }
    let found = read(text, offset);
    if let (None, [Row::Line(line)]) = (found.words.first(), found.rows.as_slice())
        && let Some(bytes) = packed(line, offset)
    {
        let weight = BYTES + bytes.len();
        READ.with_borrow_mut(|kept| kept.insert(key, bytes.into(), weight));
    }
    found
}
