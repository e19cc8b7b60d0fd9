//! Labels of letters as texts.

/// How the rate of a letter is noted among the symbols that are written.
pub(crate) fn rate_of(spelled: &str) -> String {
    format!("\\dot {spelled}")
}

/// How the number of a frame is noted where it stands above a letter.
pub(crate) fn raised(number: &str) -> String {
    format!("^{number}")
}

/// A label without spaces and commas.
pub(crate) fn plain(label: &str) -> String {
    let is_left_out = |c: char| c.is_whitespace() || c == ',';
    match label.contains(is_left_out) {
        true => label.replace(is_left_out, ""),
        false => label.to_owned(),
    }
}

/// A piece of LaTeX without its commands: `\\text{d}m` is `{d}m`.
pub(crate) fn without_commands(source: &str) -> String {
    let mut text = String::new();
    let mut rest = source;
    while let Some(at) = rest.find('\\') {
        text.push_str(&rest[..at]);
        rest = rest[at + 1..].trim_start_matches(|c: char| c.is_ascii_alphabetic());
    }
    text.push_str(rest);
    text
}

/// The letters of a label, of which the Greek ones have names of several: `alpha`, `beta` of `alphabeta`.
pub(crate) fn letters_of(label: &str, is_letter: impl Fn(&str) -> bool) -> Vec<String> {
    let label = plain(label);
    let mut letters = vec![];
    let mut rest = label.as_str();
    while let Some(first) = rest.chars().next() {
        let ends = rest.char_indices().map(|(at, c)| at + c.len_utf8());
        let named = ends.filter(|&end| is_letter(&rest[..end])).last();
        let (letter, behind) = rest.split_at(named.unwrap_or(first.len_utf8()));
        letters.push(letter.to_owned());
        rest = behind;
    }
    letters
}
