//! Sentences by which an author says what a document means, as they stand in front matter or in a file of their own.

use crate::notation::document::Sentence;
use crate::source::Span;
use std::ops::Range;

/// The key of the list in front matter.
const KEY: &str = "polhode:";

/// The sentences of a text, one a line.
///
/// Lines that begin with `#` are remarks, and so is what stands behind ` #`. A line may begin with a hyphen, as in
/// front matter; the line `polhode:` and the fences of front matter say nothing.
///
/// ```
/// use polhode::notation::sentences;
///
/// let found = sentences("# the ring\n- N is an inertial frame.  # by custom\n");
/// assert_eq!(found[0].text, "N is an inertial frame.");
/// ```
pub fn sentences(text: &str) -> Vec<Sentence> {
    let mut found = vec![];
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let content = line.trim();
        let start = at + (line.len() - line.trim_start().len());
        at += line.len();
        if content.starts_with('#') || matches!(content, "---" | "..." | "-") || is_key(content) {
            continue;
        }
        let skip = if content.starts_with("- ") { 2 } else { 0 };
        found.extend(sentence(text, start + skip..start + content.len()));
    }
    found
}

/// Takes the list of sentences out of the YAML between `block` of a text; blanks stand in its place.
///
/// They are read here and not as YAML: a sentence may begin with a backtick, and each keeps its place.
pub(crate) fn take_list(text: &str, block: Range<usize>) -> (String, Vec<Sentence>) {
    let mut rest = String::new();
    let mut items: Vec<Range<usize>> = vec![];
    let (mut inside, mut hyphen, mut at) = (false, 0, block.start);
    for line in text[block].split_inclusive('\n') {
        let start = at;
        at += line.len();
        let content = line.trim_end();
        let lead = content.len() - content.trim_start().len();
        let shown = content.trim_start();
        if inside {
            let end = start + content.len();
            match items.last_mut() {
                _ if shown.is_empty() || shown.starts_with('#') => {}
                _ if shown == "-" || shown.starts_with("- ") => {
                    hyphen = lead;
                    items.push(start + lead + 1..end);
                }
                Some(item) if lead > hyphen => item.end = end,
                _ => inside = false,
            }
        }
        if !inside {
            inside = is_key(content);
        }
        match inside {
            true => rest.push('\n'),
            false => rest.push_str(line),
        }
    }
    let found = items.into_iter().filter_map(|item| sentence(text, item));
    (rest, found.collect())
}

/// Sentences that YAML has read; their place is where they stand in the block, or all of it.
pub(crate) fn from_yaml(
    value: &serde_json::Value,
    text: &str,
    block: Range<usize>,
) -> Vec<Sentence> {
    let said: Vec<&str> = match value {
        serde_json::Value::String(said) => said.lines().collect(),
        serde_json::Value::Array(list) => list.iter().filter_map(|v| v.as_str()).collect(),
        _ => vec![],
    };
    let said = said
        .into_iter()
        .map(|said| said.trim())
        .filter(|said| !said.is_empty());
    let placed = said.map(|said| {
        let at = text[block.clone()].find(said).map(|at| block.start + at);
        Sentence {
            text: on_one_line(said),
            span: at.map_or(Span::new(block.start, block.end), |at| {
                Span::new(at, at + said.len())
            }),
        }
    });
    placed.collect()
}

/// Whether a line is the key of the list with nothing behind it.
fn is_key(line: &str) -> bool {
    let rest = line.strip_prefix(KEY).map(str::trim_start);
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('#'))
}

/// The sentence that stands in a part of a text: without quotes and without a remark behind it.
fn sentence(text: &str, within: Range<usize>) -> Option<Sentence> {
    let raw = text.get(within.clone())?;
    let start = within.start + (raw.len() - raw.trim_start().len());
    let raw = raw.trim();
    let quote = raw.chars().next().filter(|c| matches!(c, '"' | '\''));
    let quoted = quote.and_then(|quote| Some((quote, inside_quotes(raw, quote)?)));
    let (start, said) = match quoted {
        Some((_, inside)) => (start + 1, inside),
        None => (start, without_remark(raw)),
    };
    let span = Span::new(start, start + said.len());
    let said = match quoted {
        Some(('\'', _)) => said.replace("''", "'"),
        Some(_) => said.replace("\\\"", "\"").replace("\\\\", "\\"),
        None => said.to_owned(),
    };
    (!said.trim().is_empty()).then(|| Sentence {
        text: on_one_line(&said),
        span,
    })
}

/// What stands between a quote and the next one like it, if only a remark follows.
fn inside_quotes(raw: &str, quote: char) -> Option<&str> {
    let mut escaped = false;
    let mut characters = raw.char_indices().skip(1).peekable();
    while let Some((at, c)) = characters.next() {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = quote == '"',
            '\'' if quote == '\'' && characters.next_if(|(_, next)| *next == '\'').is_some() => {}
            c if c == quote => {
                let rest = raw[at + 1..].trim_start();
                return (rest.is_empty() || rest.starts_with('#')).then(|| &raw[1..at]);
            }
            _ => {}
        }
    }
    None
}

/// A line up to a `#` that stands behind a blank and in no formula.
fn without_remark(raw: &str) -> &str {
    let (mut in_formula, mut in_code, mut blank) = (false, false, false);
    for (at, c) in raw.char_indices() {
        match c {
            '$' => in_formula = !in_formula,
            '`' => in_code = !in_code,
            '#' if blank && !in_formula && !in_code => return raw[..at].trim_end(),
            _ => {}
        }
        blank = c.is_whitespace();
    }
    raw
}

/// Line breaks as blanks; every character keeps its place.
fn on_one_line(text: &str) -> String {
    text.trim_end().replace(['\n', '\r', '\t'], " ")
}
