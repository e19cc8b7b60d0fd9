//! Definitions inside formulas.

use super::name;

/// Where a definition with a body in braces ends that begins at an offset.
pub(super) fn definition_end(text: &str, at: usize, braces: &[usize]) -> Option<usize> {
    let defines = name(&text[at..]);
    if !DEFINES.contains(&defines) {
        return None;
    }
    let behind = |brace: usize| {
        braces
            .get(brace)
            .filter(|&&end| end < text.len())
            .map(|end| end + 1)
    };
    let skip = |at: usize, what: fn(char) -> bool| {
        let rest = &text[at..];
        at + rest.len() - rest.trim_start_matches(what).len()
    };
    let mut at = skip(at + 1 + defines.len(), |c| c.is_whitespace() || c == '*');
    at = match text[at..].starts_with('{') {
        true => behind(at)?,
        false => at + text[at..].find(['{', '['])?,
    };
    while text[skip(at, char::is_whitespace)..].starts_with('[') {
        at += text[at..].find(']')? + 1;
    }
    at = skip(at, char::is_whitespace);
    behind(at).filter(|_| text[at..].starts_with('{'))
}

/// Commands that define another one, with a body in braces.
const DEFINES: [&str; 6] = [
    "newcommand",
    "renewcommand",
    "providecommand",
    "DeclareMathOperator",
    "def",
    "gdef",
];

/// For each opening brace of a text the offset of the one that closes it; the length of the text elsewhere.
pub(super) fn braces(text: &str) -> Vec<usize> {
    let mut closing = vec![text.len(); text.len()];
    let mut open = vec![];
    let mut escaped = false;
    for (i, b) in text.bytes().enumerate() {
        match b {
            _ if escaped => escaped = false,
            b'\\' => escaped = true,
            b'{' => open.push(i),
            b'}' => {
                if let Some(start) = open.pop() {
                    closing[start] = i;
                }
            }
            _ => {}
        }
    }
    closing
}

/// Whether all that a text opens is closed in it: macros may stand for one half of a bracket or an environment.
pub(super) fn is_whole(text: &str) -> bool {
    let mut open = [0i32; 2];
    let mut at = 0;
    while let Some(i) = text[at..].find('\\') {
        at += i;
        let name = name(&text[at..]);
        match name {
            "begin" => open[0] += 1,
            "end" => open[0] -= 1,
            "left" => open[1] += 1,
            "right" => open[1] -= 1,
            _ => {}
        }
        if open.iter().any(|&open| open < 0) {
            return false;
        }
        at += 1 + name.len();
    }
    open == [0; 2]
}
