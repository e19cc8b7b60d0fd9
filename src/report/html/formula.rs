//! A formula as MathML, or as its source where it can't be drawn.

use maud::{Markup, PreEscaped, html};
use pulldown_latex::{Parser, RenderConfig, Storage, config::DisplayMode, push_mathml};
use std::cell::RefCell;
use std::collections::HashMap;
use std::panic::catch_unwind;

/// Longer or deeper formulas are shown as they are written.
const LONGEST: usize = 4_000;
const DEEPEST: usize = 60;

/// Elements and attributes that a drawn formula may have. There is no link among them, and nothing that is loaded or run.
const ELEMENTS: [&str; 29] = [
    "math",
    "semantics",
    "mrow",
    "mi",
    "mn",
    "mo",
    "mtext",
    "ms",
    "mspace",
    "mfrac",
    "msqrt",
    "mroot",
    "msub",
    "msup",
    "msubsup",
    "munder",
    "mover",
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

/// Draws a formula in a line of its own.
pub(in crate::report) fn formula(source: &str) -> Markup {
    drawn_as(source, DisplayMode::Block)
}

/// Draws a formula inside a text.
pub(super) fn inline(source: &str) -> Markup {
    drawn_as(source, DisplayMode::Inline)
}

/// Whether a formula is drawn in a line of its own, and not shown as it is written.
pub(in crate::report) fn is_drawn(source: &str) -> bool {
    drawn(bare(source), DisplayMode::Block).is_some()
}

/// A source without what parts it from its neighbours.
fn bare(source: &str) -> &str {
    let source = source.trim().trim_start_matches('&');
    source.trim_end_matches("\\\\").trim()
}

fn drawn_as(source: &str, mode: DisplayMode) -> Markup {
    let source = bare(source);
    match drawn(source, mode) {
        Some(drawn) => html! { (PreEscaped(drawn)) },
        None => html! { code { (source) } },
    }
}

thread_local! {
    /// The formulas that were drawn last: a class writes the same ones again and again.
    static DRAWN: RefCell<HashMap<(String, bool), Option<String>>> = RefCell::default();
}

/// No more drawn formulas are kept, and none whose source is longer.
const MOST_KEPT: usize = 1_000;
const LONGEST_KEPT: usize = 300;

fn drawn(source: &str, mode: DisplayMode) -> Option<String> {
    if source.len() > LONGEST_KEPT {
        return draw(source, mode);
    }
    DRAWN.with_borrow_mut(|kept| {
        if kept.len() == MOST_KEPT {
            kept.clear();
        }
        let key = (source.to_owned(), mode == DisplayMode::Inline);
        kept.entry(key)
            .or_insert_with(|| draw(source, mode))
            .clone()
    })
}

fn draw(source: &str, mode: DisplayMode) -> Option<String> {
    if source.len() > LONGEST || depth(source) > DEEPEST {
        return None;
    }
    let aligned = source.replace('&', " ");
    let drawn = catch_unwind(|| {
        let storage = Storage::new();
        let config = RenderConfig {
            display_mode: mode,
            ..RenderConfig::default()
        };
        let mut drawn = String::new();
        let events: Result<Vec<_>, _> = Parser::new(&aligned, &storage).collect();
        let events = events.ok()?.into_iter().map(Ok::<_, std::fmt::Error>);
        push_mathml(&mut drawn, events, config).ok()?;
        Some(drawn)
    });
    drawn.ok().flatten().filter(|drawn| is_harmless(drawn))
}

/// How deep brackets stand in each other.
fn depth(source: &str) -> usize {
    let (mut depth, mut deepest) = (0usize, 0);
    for c in source.chars() {
        match c {
            '{' | '(' | '[' => depth += 1,
            '}' | ')' | ']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        deepest = deepest.max(depth);
    }
    deepest
}

/// Whether a drawn formula has nothing in it but what formulas are drawn with.
fn is_harmless(drawn: &str) -> bool {
    let Ok(tree) = roxmltree::Document::parse(drawn) else {
        return false;
    };
    let elements = tree.descendants().filter(roxmltree::Node::is_element);
    elements.into_iter().all(|element| {
        let name = element.tag_name().name();
        ELEMENTS.contains(&name)
            && element.attributes().all(|attribute| {
                let value = attribute.value().to_ascii_lowercase();
                ATTRIBUTES.contains(&attribute.name())
                    && !value.contains("url")
                    && !value.contains(':')
                    || attribute.name() == "style" && is_plain_style(&value)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_formula_is_drawn_and_what_cannot_be_is_shown_as_text() {
        assert!(
            formula("M_x = I\\dot\\omega_x")
                .into_string()
                .contains("<msub>")
        );
        let shown = formula("\\href{javascript:alert(1)}{<script>}").into_string();
        assert!(
            shown.starts_with("<code>") && !shown.contains("<script>"),
            "{shown}"
        );
        assert!(
            formula(&"{".repeat(100))
                .into_string()
                .starts_with("<code>")
        );
    }

    #[test]
    fn active_content_is_never_let_through() {
        for active in [
            "<math><mi href=\"javascript:a\">x</mi></math>",
            "<math><script>a</script></math>",
            "<math><mi onclick=\"a\">x</mi></math>",
            "<math><mi style=\"background: url(a)\">x</mi></math>",
        ] {
            assert!(!is_harmless(active), "{active}");
        }
        assert!(is_harmless("<math display=\"block\"><mi>x</mi></math>"));
    }
}
