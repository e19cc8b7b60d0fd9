//! Where a pattern, a command or the end of a paragraph stands in the bytes of a text.

/// The offset of a command that no letter follows.
pub(super) fn find_command(bytes: &[u8], command: &[u8]) -> Option<usize> {
    let mut from = 0;
    while let Some(i) = find(&bytes[from..], command) {
        let end = from + i + command.len();
        if !bytes.get(end).is_some_and(u8::is_ascii_alphabetic) {
            return Some(from + i);
        }
        from = end;
    }
    None
}

/// The offset of a pattern.
pub(crate) fn find(bytes: &[u8], pattern: &[u8]) -> Option<usize> {
    let first = *pattern.first()?;
    let mut from = 0;
    while let Some(i) = bytes[from..].iter().position(|b| *b == first) {
        if bytes[from + i..].starts_with(pattern) {
            return Some(from + i);
        }
        from += i + 1;
    }
    None
}

/// The offset of a pattern with no backslash before it.
pub(super) fn find_unescaped(bytes: &[u8], pattern: &[u8]) -> Option<usize> {
    let mut i = 0;
    while i < bytes.len() {
        if bytes[i..].starts_with(pattern) {
            return Some(i);
        }
        i += if bytes[i] == b'\\' { 2 } else { 1 };
    }
    None
}

/// Whether a line holds nothing but white space.
pub(super) fn blank_line(bytes: &[u8]) -> bool {
    bytes
        .iter()
        .take_while(|b| **b != b'\n')
        .all(u8::is_ascii_whitespace)
}

/// Where the paragraph ends: at a blank line, or at the end of the text.
pub(super) fn paragraph_end(bytes: &[u8], from: usize) -> usize {
    let mut at = from;
    while let Some(i) = find(&bytes[at..], b"\n") {
        let next = at + i + 1;
        if blank_line(&bytes[next..]) {
            return at + i;
        }
        at = next;
    }
    bytes.len()
}
