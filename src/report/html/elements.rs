//! The elements of drawn formulas: which there may be, and whether a formula has no others.

use roxmltree::Document as Tree;
use std::ops::Range;

/// Elements and attributes that a drawn formula may have. There is no link among them, and nothing that is loaded or run.
const ELEMENTS: [&str; 29] = [
    "mi",
    "mo",
    "mn",
    "msub",
    "mrow",
    "mover",
    "math",
    "semantics",
    "mtext",
    "ms",
    "mspace",
    "mfrac",
    "msqrt",
    "mroot",
    "msup",
    "msubsup",
    "munder",
    "munderover",
    "mmultiscripts",
    "mprescripts",
    "mtable",
    "mtr",
    "mtd",
    "mpadded",
    "mphantom",
    "mstyle",
    "menclose",
    "none",
    "merror",
];
const ATTRIBUTES: [&str; 27] = [
    "display",
    "displaystyle",
    "scriptlevel",
    "mathvariant",
    "stretchy",
    "symmetric",
    "fence",
    "separator",
    "form",
    "accent",
    "accentunder",
    "lspace",
    "rspace",
    "minsize",
    "maxsize",
    "width",
    "height",
    "depth",
    "voffset",
    "linethickness",
    "columnalign",
    "columnspacing",
    "rowspacing",
    "class",
    "movablelimits",
    "largeop",
    "style",
];

/// What stands directly in a drawn formula.
#[derive(Debug, PartialEq)]
pub(super) struct Part {
    /// Its bytes.
    pub(super) range: Range<usize>,
    /// The text of an operator.
    pub(super) operator: Option<String>,
}

/// The parts of a drawn formula, if there is nothing in it but what formulas are drawn with.
///
/// What is written in the plainest way is gone through once; of all else a parser decides.
pub(super) fn harmless_parts(drawn: &str) -> Option<Vec<Part>> {
    if let Some(parts) = Plain::of(drawn) {
        return Some(parts);
    }
    let tree = Tree::parse(drawn).ok().filter(is_harmless)?;
    let parts = tree.root_element().children().map(|part| Part {
        range: part.range(),
        operator: (part.text().filter(|_| part.has_tag_name("mo"))).map(str::to_owned),
    });
    Some(parts.collect())
}

/// An element that is not closed yet.
struct Open<'d> {
    name: &'d str,
    from: usize,
    /// How many elements stand in it so far.
    parts: usize,
    /// The text at its beginning.
    text: &'d str,
}

/// A formula that is gone through.
struct Plain<'d> {
    open: Vec<Open<'d>>,
    parts: Vec<Part>,
}

impl<'d> Plain<'d> {
    /// The parts of one that is written in the plainest way and is harmless; `None` where a parser must look.
    fn of(drawn: &'d str) -> Option<Vec<Part>> {
        let bytes = drawn.as_bytes();
        let is_odd = |b: &u8| (*b < b' ') | (*b == 0xef) | (*b == b']');
        // All of them are looked at: that is sooner done than to stop at the first.
        let odd = bytes.iter().fold(false, |odd, b| odd | is_odd(b));
        if odd || !drawn.starts_with("<math") {
            return None;
        }
        let mut plain = Self {
            open: vec![],
            parts: vec![],
        };
        let mut from = 0;
        while from < bytes.len() {
            // Nothing stands behind the end of the formula.
            if from > 0 && plain.open.is_empty() {
                return None;
            }
            let tag = bytes[from..].iter().position(|b| *b == b'>')?;
            let end = from + tag + 1;
            let text = bytes[end..].iter().position(|b| *b == b'<');
            let next = text.map_or(bytes.len(), |text| end + text);
            let (tag, text) = (&drawn[from + 1..end - 1], &drawn[end..next]);
            match tag.strip_prefix('/') {
                Some(name) => plain.close(name, end)?,
                None => plain.enter(tag, from, end, text)?,
            }
            plain.has_text(text)?;
            from = next;
        }
        plain.open.is_empty().then_some(plain.parts)
    }

    /// Text may stand in elements that stand in the formula.
    fn has_text(&self, text: &str) -> Option<()> {
        let is_plain = !text.bytes().any(|b| matches!(b, b'&' | b'>'));
        if text.is_empty() || is_plain && self.open.len() > 1 {
            return Some(());
        }
        let entities = text.split('&').skip(1);
        let mut known =
            entities.map(|rest| ["lt;", "gt;", "amp;"].iter().any(|e| rest.starts_with(e)));
        (self.open.len() > 1 && !text.contains('>') && known.all(|known| known)).then_some(())
    }

    /// An element begins, or stands there with nothing in it.
    fn enter(&mut self, tag: &'d str, from: usize, end: usize, text: &'d str) -> Option<()> {
        let (tag, is_empty) = match tag.strip_suffix('/') {
            Some(tag) => (tag.strip_suffix(' ').unwrap_or(tag), true),
            None => (tag, false),
        };
        let space = tag.bytes().position(|b| b == b' ');
        let (name, attributes) = space.map_or((tag, ""), |at| (&tag[..at], &tag[at + 1..]));
        if !ELEMENTS.contains(&name) || !has_plain_attributes(attributes) {
            return None;
        }
        if let Some(outer) = self.open.last_mut() {
            outer.parts += 1;
        }
        let element = Open {
            name,
            from,
            parts: 0,
            text: if is_empty { "" } else { text },
        };
        self.open.push(element);
        if is_empty {
            self.close(name, end)
        } else {
            Some(())
        }
    }

    fn close(&mut self, name: &str, end: usize) -> Option<()> {
        let element = self.open.pop().filter(|open| open.name == name)?;
        if parts_of(name).is_some_and(|fixed| fixed != element.parts) {
            return None;
        }
        if self.open.len() == 1 {
            let text = Some(element.text).filter(|text| name == "mo" && !text.is_empty());
            // One with a sign that is written out is none that is looked for.
            let operator = text.map(str::to_owned);
            let range = element.from..end;
            self.parts.push(Part { range, operator });
        }
        Some(())
    }
}

/// Whether attributes are known ones, each written once and with a plain value.
fn has_plain_attributes(written: &str) -> bool {
    let mut seen: Vec<&str> = vec![];
    let mut rest = written;
    while !rest.is_empty() {
        let Some((name, behind)) = rest.split_once("=\"") else {
            return false;
        };
        let Some((value, behind)) = behind.split_once('"') else {
            return false;
        };
        let is_plain = ATTRIBUTES.contains(&name) && !seen.contains(&name);
        if !is_plain || value.contains(['&', '<']) || !is_harmless_value(name, value) {
            return false;
        }
        seen.push(name);
        rest = match behind.strip_prefix(' ') {
            Some(more) if !more.is_empty() => more,
            None if behind.is_empty() => "",
            _ => return false,
        };
    }
    true
}

/// Whether an attribute with this value neither loads nor runs anything.
fn is_harmless_value(name: &str, value: &str) -> bool {
    let value = value.to_ascii_lowercase();
    !value.contains("url") && !value.contains(':') || name == "style" && is_plain_style(&value)
}

/// How many parts an element has whose parts mean something by their place: a browser draws it as a plain row with others.
fn parts_of(element: &str) -> Option<usize> {
    match element {
        "mfrac" | "mroot" | "msub" | "msup" | "munder" | "mover" => Some(2),
        "msubsup" | "munderover" => Some(3),
        _ => None,
    }
}

/// Whether a drawn formula has nothing in it but what formulas are drawn with.
fn is_harmless(tree: &Tree<'_>) -> bool {
    let elements = tree.descendants().filter(roxmltree::Node::is_element);
    elements.into_iter().all(|element| {
        let name = element.tag_name().name();
        let parts = element.children().filter(roxmltree::Node::is_element);
        ELEMENTS.contains(&name)
            && parts_of(name).is_none_or(|fixed| fixed == parts.count())
            && element.attributes().all(|attribute| {
                let (name, value) = (attribute.name(), attribute.value());
                ATTRIBUTES.contains(&name) && is_harmless_value(name, value)
            })
    })
}

/// Whether a style sets sizes and colours alone.
fn is_plain_style(style: &str) -> bool {
    const PROPERTIES: [&str; 8] = [
        "color",
        "background-color",
        "margin-left",
        "height",
        "border-color",
        "text-align",
        "padding",
        "border",
    ];
    style
        .split(';')
        .filter(|part| !part.trim().is_empty())
        .all(|part| {
            let named = part.split_once(':');
            named.is_some_and(|(property, value)| {
                PROPERTIES.contains(&property.trim()) && !value.contains(['(', '\\'])
            })
        })
}
