//! Digits in groups: `12\,000`, `1{,}000{,}000`, `3{,}5`.

use std::borrow::Cow;

/// How many bytes a mark between two groups of digits takes, where a text begins with one; `comma` for `{,}`.
fn mark(text: &str, comma: bool) -> Option<usize> {
    let marks: &[&str] = match comma {
        true => &["{,}"],
        false => &["\\,", "\\ ", "~", "\u{2009}", "\u{202f}", "\u{a0}", " "],
    };
    marks
        .iter()
        .find(|mark| text.starts_with(**mark))
        .map(|mark| mark.len())
}

fn digits(text: &str) -> usize {
    text.bytes().take_while(u8::is_ascii_digit).count()
}

/// How far a number goes on behind its first digits: groups of three behind spaces, and a comma in braces.
pub(crate) fn groups(first: &str, rest: &str) -> usize {
    let whole = first.split('.').next().unwrap_or("");
    let mut at = 0;
    let comma = mark(rest, true).is_some();
    if !(1..=3).contains(&whole.len()) && !comma || first.contains('.') || whole.is_empty() {
        return 0;
    }
    while let Some(length) = mark(&rest[at..], comma) {
        let group = digits(&rest[at + length..]);
        if group == 0 || (!comma && group != 3) {
            break;
        }
        at += length + group;
    }
    let point = rest[at..].strip_prefix('.').map_or(0, digits);
    if at > 0 && point > 0 {
        at + 1 + point
    } else {
        at
    }
}

/// The digits of a number without the marks between its groups; `None` where a comma may part thousands or decimals.
pub(super) fn joined(written: &str) -> Option<Cow<'_, str>> {
    if written
        .bytes()
        .all(|b| b.is_ascii_alphanumeric() || matches!(b, b'.' | b'+' | b'-'))
    {
        return Some(written.into());
    }
    // The lexer takes a bare comma for a part of a number only where the document parts decimals by it.
    let bare = |w: &[u8]| w[0].is_ascii_digit() && w[1] == b',';
    if written.as_bytes().windows(2).any(bare) {
        return Some(written.replace(',', ".").into());
    }
    let parts: Vec<&str> = written.split("{,}").collect();
    let [whole, part] = parts.as_slice() else {
        let bare = |c: &char| c.is_ascii_digit() || *c == '.';
        return Some(written.chars().filter(bare).collect());
    };
    let group = part.split('.').next().unwrap_or("").len() == 3 && whole.len() <= 3;
    match (group, part.contains('.')) {
        (true, true) => Some(format!("{whole}{part}").into()),
        (true, false) if *whole != "0" => None,
        (_, true) => None,
        _ => Some(format!("{whole}.{part}").into()),
    }
}
