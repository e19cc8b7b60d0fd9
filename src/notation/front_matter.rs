//! Settings at the head of a document: a YAML block in Markdown, `% polhode:` comments in LaTeX.

use crate::diagnostic::Diagnostic;
use crate::notation::document::{FrontMatter, Sentence};
use crate::notation::sentences::{from_yaml, take_list};
use crate::source::Span;
use serde_json::{Map, Value};

/// Keys that a LaTeX comment may set, beside `symbol NAME`; any other comment is a sentence.
pub(crate) const SETTINGS: [&str; 9] = [
    "marks",
    "follow_through",
    "working",
    "shown",
    "rounding",
    "most_rules",
    "products",
    "axes",
    "id",
];

/// More than this is no front matter.
const LONGEST: usize = 64 * 1024;

/// Reads the block at the head of a text, if there is one, and returns where the text goes on.
pub(crate) fn take(text: &str, front: &mut FrontMatter, troubles: &mut Vec<Diagnostic>) -> usize {
    let start = text.len() - text.trim_start_matches('\u{feff}').len();
    let Some((block, body)) = block(text, start) else {
        return start;
    };
    let (yaml, sentences) = take_list(text, block.clone());
    front.sentences.extend(sentences);
    match serde_saphyr::from_str::<Value>(&yaml) {
        Ok(Value::Object(mut map)) => {
            if let Some(said) = map.remove("polhode") {
                let found = from_yaml(&said, text, block.clone());
                if found.is_empty() {
                    troubles.push(trouble(block, "`polhode` is no list of sentences"));
                }
                front.sentences.extend(found);
            }
            settings(map, front);
        }
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

/// A LaTeX comment `% polhode: key: value` or `% polhode: Sentence.`, from behind its colon at `offset` on.
pub(crate) fn comment(text: &str, offset: usize, front: &mut FrontMatter) {
    let setting = text
        .split_once([':', '='])
        .map(|(key, value)| (key.trim(), value.trim()));
    match setting {
        Some((key, value)) if SETTINGS.contains(&key) => {
            set(key, Value::String(value.to_owned()), front);
        }
        Some((key, value)) if key.starts_with("symbol ") => {
            let name = key["symbol ".len()..].trim().to_owned();
            front.symbols.insert(name, value.to_owned());
        }
        _ => {
            let start = offset + (text.len() - text.trim_start().len());
            let said = text.trim();
            if !said.is_empty() {
                front.sentences.push(Sentence {
                    text: said.to_owned(),
                    span: Span::new(start, start + said.len()),
                });
            }
        }
    }
}
