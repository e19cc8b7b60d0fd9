//! Settings at the head of a document: a YAML block in Markdown, `% polhode:` comments in LaTeX.

use crate::diagnostic::Diagnostic;
use crate::notation::document::FrontMatter;
use crate::source::Span;
use serde_json::{Map, Value};

/// More than this is no front matter.
const LONGEST: usize = 64 * 1024;

/// Reads the block at the head of a text, if there is one, and returns where the text goes on.
pub(crate) fn take(text: &str, front: &mut FrontMatter, troubles: &mut Vec<Diagnostic>) -> usize {
    let start = text.len() - text.trim_start_matches('\u{feff}').len();
    let Some((block, body)) = block(text, start) else {
        return start;
    };
    let yaml = &text[block.clone()];
    match serde_saphyr::from_str::<Value>(yaml) {
        Ok(Value::Object(map)) => settings(map, front),
        Ok(Value::Null) => {}
        Ok(_) => troubles.push(trouble(
            block,
            "the front matter is not a list of keys and values",
        )),
        Err(error) => {
            let first = error.to_string().lines().next().unwrap_or("").to_owned();
            troubles.push(trouble(
                block,
                &format!("the front matter is not read: {first}"),
            ));
        }
    }
    body
}

fn trouble(block: std::ops::Range<usize>, message: &str) -> Diagnostic {
    Diagnostic::warning("front-matter", Span::new(block.start, block.end), message)
}

/// The bytes between the two fences, and the offset behind the second.
fn block(text: &str, start: usize) -> Option<(std::ops::Range<usize>, usize)> {
    let rest = text[start..].strip_prefix("---")?;
    let first = rest.find('\n').filter(|&i| rest[..i].trim().is_empty())? + 1;
    let begin = start + 3 + first;
    let mut at = begin;
    for line in text[begin..].split_inclusive('\n') {
        if at - begin > LONGEST {
            return None;
        }
        if matches!(line.trim_end(), "---" | "...") {
            return Some((begin..at, at + line.len()));
        }
        at += line.len();
    }
    None
}

fn settings(map: Map<String, Value>, front: &mut FrontMatter) {
    for (key, value) in map {
        set(&key, value, front);
    }
}

fn set(key: &str, value: Value, front: &mut FrontMatter) {
    match (key, &value) {
        ("products", Value::String(text)) => front.products = Some(text.clone()),
        ("axes", Value::String(text)) => front.axes = Some(text.clone()),
        ("symbols", Value::Object(symbols)) => {
            let texts = symbols
                .iter()
                .filter_map(|(k, v)| v.as_str().map(|v| (k.clone(), v.to_owned())));
            front.symbols.extend(texts);
        }
        _ => {
            front.other.insert(key.to_owned(), value);
        }
    }
}

/// A LaTeX comment `% polhode: key: value`.
pub(crate) fn comment(text: &str, front: &mut FrontMatter) {
    let Some((key, value)) = text.split_once([':', '=']) else {
        return;
    };
    let (key, value) = (key.trim(), value.trim());
    match key.strip_prefix("symbol ") {
        Some(name) => {
            front
                .symbols
                .insert(name.trim().to_owned(), value.to_owned());
        }
        None => set(key, Value::String(value.to_owned()), front),
    }
}
