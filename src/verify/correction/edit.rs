//! A change to the text of a line, in the author's own notation.

use crate::source::Span;
use unicode_normalization::UnicodeNormalization;

/// A change to the text of a line.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Edit {
    /// The bytes that are replaced.
    pub(crate) span: Span,
    /// What stands there instead.
    pub(crate) text: String,
    /// The name of the mistake.
    pub(crate) kind: &'static str,
    /// One clause that says it.
    pub(crate) message: String,
    /// How unlikely such a slip is.
    pub(crate) cost: u32,
}

/// The axis `to` in the family of `like`.
pub(crate) fn other_axis(like: char, to: u8) -> Option<char> {
    let families = [['x', 'y', 'z'], ['1', '2', '3'], ['₁', '₂', '₃']];
    let family = families.iter().find(|f| f.contains(&like))?;
    family.get(usize::from(to)).copied()
}

/// The text of a symbol with another index; `None` where the index does not stand there as plain letters.
pub(crate) fn replaced_index(text: &str, from: &str, to: &str) -> Option<String> {
    let at = text.rfind('_').map_or(0, |i| i + 1);
    if let Some(found) = text[at..].find(from) {
        let start = at + found;
        return Some(format!(
            "{}{to}{}",
            &text[..start],
            &text[start + from.len()..]
        ));
    }
    let low = |s: &str| -> String {
        s.chars()
            .map(|c| match c {
                '1' => '₁',
                '2' => '₂',
                '3' => '₃',
                'x' => 'ₓ',
                other => other,
            })
            .collect()
    };
    let (from, to) = (low(from), low(to));
    text.rfind(&from)
        .map(|i| format!("{}{to}{}", &text[..i], &text[i + from.len()..]))
}

/// The text of a symbol with a dot over its letter.
pub(crate) fn dotted(text: &str) -> String {
    let end = text.find(['_', '^']).unwrap_or(text.len());
    let (base, rest) = text.split_at(end);
    let plain = !text.contains('\\') && !text.contains('_');
    if plain {
        let mut characters = base.chars();
        if let Some(first) = characters.next()
            && (!first.is_ascii() || characters.clone().any(|c| !c.is_ascii()))
        {
            return format!("{first}\u{307}{}", characters.as_str());
        }
    }
    let base = base.trim();
    match base.strip_prefix('\\').unwrap_or(base) {
        word if word.chars().all(char::is_alphanumeric) => {
            format!("\\dot {base}{rest}").replace("\\dot \\", "\\dot\\")
        }
        _ => format!("\\dot{{{base}}}{rest}"),
    }
}

/// The text of a symbol without the one dot over its letter; `None` where there is none.
pub(crate) fn undotted(text: &str) -> Option<String> {
    let text = text.trim();
    if let Some(inner) = text.strip_prefix("\\frac{d") {
        return inner
            .trim_end()
            .strip_suffix("}{dt}")
            .map(|inner| inner.trim().to_owned());
    }
    if let Some(rest) = text.strip_prefix("\\dot") {
        let rest = rest.trim_start();
        return Some(
            match rest
                .strip_prefix('{')
                .and_then(|inner| inner.split_once('}'))
            {
                Some((inner, after)) if !inner.contains('{') => format!("{inner}{after}"),
                _ => rest.to_owned(),
            },
        );
    }
    let split: String = text.nfd().collect();
    split
        .contains('\u{307}')
        .then(|| split.replace('\u{307}', ""))
}

/// Edits at different places, as one text.
pub(crate) fn edited(text: &str, offset: u32, edits: &[&Edit]) -> Option<String> {
    let mut sorted: Vec<&&Edit> = edits.iter().collect();
    sorted.sort_by_key(|edit| edit.span);
    let (mut result, mut at) = (String::with_capacity(text.len() + 16), 0);
    for edit in sorted {
        let start = (edit.span.start.checked_sub(offset)?) as usize;
        let end = (edit.span.end.checked_sub(offset)?) as usize;
        if start < at {
            return None;
        }
        result.push_str(text.get(at..start)?);
        result.push_str(&edit.text);
        at = end;
    }
    result.push_str(text.get(at..)?);
    Some(result)
}
