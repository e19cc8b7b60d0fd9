//! Rust text, as far as the tests of the house must know it: what is code, what is a literal, where a brace closes.

use std::fs;
use std::path::{Path, PathBuf};

/// A file of the library.
pub(crate) struct Source {
    pub(crate) path: PathBuf,
    /// The text with comments left out and every literal emptied; lines stay where they are.
    pub(crate) code: String,
    /// The string literals.
    pub(crate) literals: Vec<String>,
}

impl Source {
    pub(crate) fn read(path: PathBuf) -> Self {
        let text = fs::read_to_string(&path).expect("readable");
        let (code, literals) = parts(&text);
        Self {
            path,
            code,
            literals,
        }
    }
}

/// The source files of a module: `name.rs`, and all in the folder `name`.
pub(crate) fn files(module: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let single = module.with_extension("rs");
    if single.is_file() {
        found.push(single);
    }
    if module.is_dir() {
        for entry in fs::read_dir(module).expect("a readable folder") {
            let path = entry.expect("readable").path();
            if path.is_dir() {
                found.extend(files(&path));
            } else if !found.contains(&path) && path.extension().is_some_and(|e| e == "rs") {
                found.push(path);
            }
        }
    }
    found.sort();
    found.dedup();
    found
}

/// The code of a text, with a blank for each comment and `""` for each literal, and its string literals.
pub(crate) fn parts(text: &str) -> (String, Vec<String>) {
    let (mut code, mut literals) = (String::new(), vec![]);
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let before = code.chars().next_back();
        let begins = !before.is_some_and(|c| c.is_alphanumeric() || c == '_');
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |at| at + 2)
        } else if let Some((literal, length)) = literal(rest, begins) {
            literals.push(literal.to_owned());
            code.push_str("\"\"");
            length
        } else if let Some(length) = character(rest) {
            code.push_str("' '");
            length
        } else {
            code.push(c);
            rest = &rest[c.len_utf8()..];
            continue;
        };
        let lines = rest[..length].matches('\n').count();
        code.extend(std::iter::repeat_n('\n', lines));
        rest = &rest[length..];
    }
    (code, literals)
}

/// A string literal at the beginning of a text, and the bytes that it takes.
fn literal(text: &str, begins: bool) -> Option<(&str, usize)> {
    let quoted = match text.strip_prefix('b') {
        Some(quoted) if begins => quoted,
        _ => text,
    };
    let raw = quoted.strip_prefix('r').filter(|_| begins);
    if let Some(hashed) = raw {
        let marked = hashed.trim_start_matches('#');
        let marks = "#".repeat(hashed.len() - marked.len());
        if let Some(inside) = marked.strip_prefix('"') {
            let end = inside.find(&format!("\"{marks}"))?;
            let start = text.len() - inside.len();
            return Some((&inside[..end], start + end + 1 + marks.len()));
        }
    }
    let inside = quoted.strip_prefix('"')?;
    let mut escaped = false;
    for (at, c) in inside.char_indices() {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            '"' => return Some((&inside[..at], text.len() - inside.len() + at + 1)),
            _ => {}
        }
    }
    None
}

/// The bytes of a character literal at the beginning of a text; a lifetime is none.
fn character(text: &str) -> Option<usize> {
    let inside = text.strip_prefix('\'')?;
    let first = inside.chars().next()?;
    let content = if first == '\\' {
        1 + inside[1..].chars().next()?.len_utf8()
    } else {
        first.len_utf8()
    };
    let end = inside[content..].find('\'')?;
    let closes = end == 0 || (first == '\\' && end < 10);
    closes.then_some(1 + content + end + 1)
}

/// The text between the brace that opens first and the one that closes it, and where that one stands.
pub(crate) fn braced(code: &str) -> Option<(&str, usize)> {
    let open = code.find('{')?;
    let mut depth = 0;
    for (at, c) in code[open..].char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some((&code[open + 1..open + at], open + at));
        }
    }
    None
}

/// Each place at which a word of the language stands, with the name behind it.
pub(crate) fn declared<'a>(
    code: &'a str,
    word: &'a str,
) -> impl Iterator<Item = (usize, &'a str)> + 'a {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    code.match_indices(word).filter_map(move |(at, _)| {
        let stands = !code[..at].chars().next_back().is_some_and(is_name);
        let name = code[at + word.len()..].strip_prefix(' ')?;
        let end = name.find(|c| !is_name(c)).unwrap_or(name.len());
        (stands && end > 0).then_some((at, &name[..end]))
    })
}

/// The structs with named fields, and how many each has.
pub(crate) fn structs(code: &str) -> Vec<(&str, usize)> {
    let fields = |(at, name)| {
        let head = code[at..].find(['{', ';', '('])?;
        let (body, _) = braced(&code[at..]).filter(|_| code[at + head..].starts_with('{'))?;
        Some((name, members(body)))
    };
    declared(code, "struct").filter_map(fields).collect()
}

/// The entries of a list, at its own depth.
fn members(body: &str) -> usize {
    let (mut depth, mut count, mut pending) = (0, 0, false);
    let code = body.replace("->", "  ");
    for c in code.chars() {
        match c {
            '{' | '(' | '[' | '<' => depth += 1,
            '}' | ')' | ']' | '>' => depth -= 1,
            ',' if depth == 0 => {
                count += usize::from(pending);
                pending = false;
            }
            c if c.is_alphanumeric() && depth == 0 => pending = true,
            _ => {}
        }
    }
    count + usize::from(pending)
}

/// The functions with a body, the line on which each begins, and how many it has.
pub(crate) fn functions(code: &str) -> Vec<(&str, usize, usize)> {
    let lines = |(at, name)| {
        let head = code[at..].find(['{', ';'])?;
        let (_, end) = braced(&code[at..]).filter(|_| code[at + head..].starts_with('{'))?;
        let first = code[..at].matches('\n').count() + 1;
        Some((name, first, code[at..at + end].matches('\n').count() + 1))
    };
    declared(code, "fn").filter_map(lines).collect()
}
