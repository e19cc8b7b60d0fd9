//! LaTeX files: sections, prose, displays, comments that set something.

use crate::diagnostic::Diagnostic;
use crate::notation::delimiters::{Dialect, find, regions};
use crate::notation::document::{FrontMatter, Item, push_prose};
use crate::notation::macros::Macros;
use crate::notation::token::{beginning, matching_brace};
use crate::notation::{formula, front_matter};
use crate::source::Span;

/// Commands whose argument is no prose.
const SILENT: &[&str] = &[
    "label",
    "ref",
    "eqref",
    "cite",
    "citep",
    "citet",
    "usepackage",
    "documentclass",
    "vspace",
    "hspace",
    "pagestyle",
    "bibliography",
    "includegraphics",
    "input",
    "include",
    "setlength",
    "newcommand",
    "renewcommand",
    "DeclareMathOperator",
    "pageref",
    "autoref",
    "cref",
    "author",
    "date",
    "begin",
    "end",
    "setcounter",
    "numberwithin",
    "providecommand",
    "url",
];

const SECTIONS: &[(&str, u8)] = &[
    ("part", 1),
    ("chapter", 1),
    ("section", 2),
    ("subsection", 3),
    ("subsubsection", 4),
    ("paragraph", 5),
    ("title", 1),
];

/// No heading and no argument that is passed over is longer than this.
const LONGEST_ARGUMENT: usize = 1000;

/// The items of a file.
pub(crate) fn items(
    text: &str,
    macros: &Macros,
    front: &mut FrontMatter,
    troubles: &mut Vec<Diagnostic>,
) -> Vec<Item> {
    let begin = "\\begin{document}";
    let start = text.find(begin).map_or(0, |i| i + begin.len());
    let end = text[start..]
        .find("\\end{document}")
        .map_or(text.len(), |i| start + i);
    let mut reader = Reader {
        text,
        front,
        items: vec![],
        done: 0,
    };
    reader.settings(&text[..start]);
    if let Some(i) = text[..start].find("\\title{") {
        reader.words(
            i,
            i + matching_brace(&text[i + 7..start]).map_or(7, |n| n + 8),
        );
    }
    let mut at = start;
    for region in regions(&text[start..end], Dialect::Latex) {
        reader.words(at, start + region.outer.start);
        // A formula in a heading names its subject; it states nothing.
        at = reader.done.max(start + region.outer.end);
        if reader.done > start + region.outer.start {
            continue;
        }
        let inner = &text[start..end][region.inner.clone()];
        let found = formula(inner, start, &region, macros);
        reader.items.extend(found);
    }
    reader.words(at, end);
    if text[start..end].contains("\\input{") {
        let at = start + text[start..end].find("\\input{").unwrap_or(0);
        let note = "another file is included here; only this one is read";
        troubles.push(Diagnostic::note("input", Span::new(at, at + 6), note));
    }
    reader.items
}

struct Reader<'a> {
    text: &'a str,
    front: &'a mut FrontMatter,
    items: Vec<Item>,
    /// Up to where the file is read.
    done: usize,
}

impl Reader<'_> {
    /// Comments of the preamble that set something.
    fn settings(&mut self, preamble: &str) {
        let mut end = 0;
        for line in preamble.split_inclusive('\n') {
            end += line.len();
            if let Some(setting) = line
                .trim_start()
                .strip_prefix('%')
                .and_then(|l| l.trim_start().strip_prefix("polhode:"))
            {
                front_matter::comment(setting, end - setting.len(), self.front);
            }
        }
    }

    fn prose(&mut self, words: &str, start: usize, end: usize) {
        push_prose(&mut self.items, words, Span::new(start, end));
    }

    /// The text between two formulas.
    fn words(&mut self, start: usize, end: usize) {
        let mut at = start;
        while at < end {
            let rest = &self.text[at..end];
            let plain = rest
                .find(['\\', '%', '\n', '{', '}', '~'])
                .unwrap_or(rest.len());
            self.prose(&rest[..plain], at, at + plain);
            at += plain;
            let rest = &self.text[at..end];
            at += match rest.as_bytes().first() {
                None => 0,
                Some(b'%') => self.comment(rest, at),
                Some(b'\n') => self.line_break(rest, at),
                Some(b'\\') => self.command(rest, at),
                Some(b'~') => {
                    self.prose(" ", at, at + 1);
                    1
                }
                Some(_) => 1,
            };
        }
    }

    fn comment(&mut self, rest: &str, at: usize) -> usize {
        let length = rest.find('\n').unwrap_or(rest.len());
        let text = rest[1..length].trim();
        match rest[1..length].trim_start().strip_prefix("polhode:") {
            Some(setting) => {
                front_matter::comment(setting, at + length - setting.len(), self.front)
            }
            None => {
                let span = Span::new(at, at + length);
                self.items.push(Item::Comment {
                    text: text.to_owned(),
                    span,
                });
            }
        }
        length.max(1)
    }

    /// A blank line ends a paragraph.
    fn line_break(&mut self, rest: &str, at: usize) -> usize {
        let blank = rest[1..]
            .find('\n')
            .is_some_and(|i| rest[1..=i].trim().is_empty());
        if blank {
            self.items.push(Item::Break);
        } else {
            self.prose(" ", at, at + 1);
        }
        1
    }

    fn command(&mut self, rest: &str, at: usize) -> usize {
        let length = rest[1..]
            .bytes()
            .take_while(u8::is_ascii_alphabetic)
            .count();
        if length == 0 {
            let character = rest[1..].chars().next();
            self.prose(" ", at, at + 1);
            return 1 + character.map_or(0, char::len_utf8);
        }
        let name = &rest[1..=length];
        let mut used = 1 + length;
        if rest[used..].starts_with('*') {
            used += 1;
        }
        if let Some((_, level)) = SECTIONS.iter().find(|(section, _)| *section == name) {
            let length = self.heading(at + used, *level, at);
            self.done = at + used + length;
            return used + length;
        }
        if name == "footnote" {
            self.prose(" ", at, at + used);
        }
        if matches!(name, "item" | "par") {
            self.items.push(Item::Break);
        }
        if SILENT.contains(&name) {
            if name == "begin" || name == "end" {
                self.items.push(Item::Break);
            }
            used += skip_arguments(&rest[used..]);
        }
        used
    }

    fn heading(&mut self, from: usize, level: u8, at: usize) -> usize {
        // Formulas may stand in it, so it ends where the file says and not at the next of them.
        let rest = beginning(&self.text[from..], LONGEST_ARGUMENT);
        let Some(inner) = rest.strip_prefix('{') else {
            return 0;
        };
        let length = matching_brace(inner).unwrap_or(0);
        let text = inner[..length].replace(['$', '\\', '{', '}'], "");
        let span = Span::new(at, at + length);
        self.items.push(Item::Heading { level, text, span });
        length + 2
    }
}

fn skip_arguments(text: &str) -> usize {
    let mut used = 0;
    loop {
        let rest = beginning(&text[used..], LONGEST_ARGUMENT);
        if let Some(inner) = rest.strip_prefix('{')
            && let Some(length) = matching_brace(inner)
        {
            used += length + 2;
        } else if rest.starts_with('[')
            && let Some(length) = find(rest.as_bytes(), b"]")
        {
            used += length + 1;
        } else {
            return used;
        }
    }
}
