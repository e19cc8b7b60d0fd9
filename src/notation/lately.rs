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

#[cfg(test)]
mod tests {
    use super::read_lately;
    use crate::notation::document::Row;
    use crate::notation::lexer::tokens;
    use crate::notation::parse::rows::{Reading, rows};
    use crate::notation::token::Letters;

    fn read(text: &str, offset: usize) -> Reading {
        rows(&tokens(text, offset, Letters::Single, false))
    }

    #[test]
    fn a_formula_is_read_the_same_wherever_it_stands() {
        for plain in [
            r"M_x = \dot L_x + \omega_y L_z - \omega_z L_y",
            r"3\omega_z \frac{dL_x}{dt} = -\frac{1}{2}I_{xz}^2 (\omega_z + \ddot\omega_x')",
            r"\vec M = (\dot{\vec L})_{xyz} + \vec\omega\times\mathbf L \equiv a \cdot b",
            r"= \left[\frac{d L}{dt}\right]_{B} \ne 0",
        ] {
            let plainly = |of: &Reading| matches!(of.rows.as_slice(), [Row::Line(_)]);
            for offset in [7, 1_000] {
                let before = read_lately(plain, offset, read);
                assert!(plainly(&before), "{plain}");
                assert_eq!(before.rows, read(plain, offset).rows, "{plain}");
                let spaced = format!("\n {plain}  ");
                let again = read_lately(&spaced, offset - 2, |_, _| unreachable!("it is kept"));
                assert_eq!(again.rows, before.rows, "{plain}");
            }
        }
    }

    #[test]
    fn what_is_not_plain_is_read_anew() {
        for odd in [r"a = b \tag{1}", r"\sin a = b", r"a = 2.50\ ", "a", ""] {
            let mut times = 0;
            for _ in 0..2 {
                let found = read_lately(odd, 7, |text, offset| {
                    times += 1;
                    read(text, offset)
                });
                assert_eq!(found.rows, read(odd, 7).rows, "{odd}");
            }
            assert_eq!(times, 2, "{odd}");
        }
    }
}
