//! A formula as MathML, or as its source where it can't be drawn.

use crate::recent::{Digest, Recent};
use crate::report::html::elements::{Part, harmless_parts};
use maud::{Markup, PreEscaped, html};
use pulldown_latex::{Parser, RenderConfig, Storage, config::DisplayMode, push_mathml};
use std::cell::RefCell;
use std::panic::catch_unwind;
use std::sync::Arc;

/// Longer or deeper formulas are shown as they are written.
const LONGEST: usize = 4_000;
const DEEPEST: usize = 60;

/// Draws a formula in a line of its own; a long one in pieces, so that it goes on in the next line of a narrow page.
pub(in crate::report) fn formula(source: &str) -> Markup {
    shown(bare(source), DisplayMode::Block)
}

/// Draws a formula inside a text.
pub(super) fn inline(source: &str) -> Markup {
    shown(bare(source), DisplayMode::Inline)
}

fn shown(source: &str, mode: DisplayMode) -> Markup {
    match drawn(source, mode) {
        Some(drawn) => html! { (PreEscaped(&*drawn)) },
        None => html! { code { (source) } },
    }
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

/// Formulas of fewer parts are drawn in one piece.
const SHORT: usize = 12;

/// What a drawn formula may be parted before.
const RELATIONS: [&str; 6] = ["=", "≡", "≈", "≠", "≤", "≥"];
const SIGNS: [&str; 3] = ["+", "−", "±"];

/// A drawn formula in pieces, between which a line may end.
fn in_pieces(drawn: String, parts: &[Part]) -> String {
    match pieces(&drawn, parts).as_slice() {
        [] | [_] => drawn,
        pieces => {
            let pieces = html! {
                @for piece in pieces { math displaystyle="true" { (PreEscaped(piece)) } wbr; }
            };
            pieces.into_string()
        }
    }
}

/// A drawn formula, parted before its relations and signs outside of brackets.
fn pieces(drawn: &str, parts: &[Part]) -> Vec<String> {
    let mut pieces: Vec<String> = vec![String::new()];
    if parts.len() < SHORT {
        return pieces;
    }
    let (mut after_sign, mut depth) = (true, 0_usize);
    for part in parts {
        let text = part.operator.as_deref();
        match text {
            Some("(" | "[") => depth += 1,
            Some(")" | "]") => depth = depth.saturating_sub(1),
            _ => {}
        }
        let relates = text.is_some_and(|text| RELATIONS.contains(&text));
        let signed = text.is_some_and(|text| SIGNS.contains(&text)) && !after_sign;
        let parts = depth == 0 && (relates || signed);
        let own = &drawn[part.range.clone()];
        match (parts, pieces.last_mut()) {
            (false, Some(last)) => last.push_str(own),
            // At the beginning of a piece it still stands between two sides.
            _ => pieces.push(own.replacen("<mo", "<mo form=\"infix\"", 1)),
        }
        after_sign = relates;
    }
    pieces.retain(|piece| !piece.is_empty());
    pieces
}

/// Formulas by their LaTeX, and whether they stand apart, as they are drawn.
type Drawn = Recent<Digest, Option<Arc<str>>>;

thread_local! {
    /// The formulas that were drawn last: a class writes the same ones again and again.
    static DRAWN: RefCell<Drawn> = RefCell::new(Recent::of(MOST_BYTES));
}

/// No more bytes of drawn formulas are kept, and no formula whose source is longer.
const MOST_BYTES: usize = 5 << 19;
const LONGEST_KEPT: usize = 300;

/// What each takes besides.
const BYTES: usize = 100;

fn drawn(source: &str, mode: DisplayMode) -> Option<Arc<str>> {
    if source.len() > LONGEST_KEPT {
        return draw(source, mode).map(Arc::from);
    }
    DRAWN.with_borrow_mut(|kept| {
        let key = Digest::of(&(source, mode == DisplayMode::Inline));
        kept.get(&key).unwrap_or_else(|| {
            let drawn: Option<Arc<str>> = draw(source, mode).map(Arc::from);
            let bytes = drawn.as_ref().map_or(0, |drawn| drawn.len()) + BYTES;
            kept.insert(key, drawn.clone(), bytes);
            drawn
        })
    })
}

fn draw(source: &str, mode: DisplayMode) -> Option<String> {
    if source.len() > LONGEST || depth(source) > DEEPEST {
        return None;
    }
    let source = without_alignment(source);
    let drawn = catch_unwind(|| {
        let storage = Storage::new();
        let config = RenderConfig {
            display_mode: mode,
            ..RenderConfig::default()
        };
        let mut drawn = String::new();
        let events: Result<Vec<_>, _> = Parser::new(&source, &storage).collect();
        let events = events.ok()?.into_iter().map(Ok::<_, std::fmt::Error>);
        push_mathml(&mut drawn, events, config).ok()?;
        Some(drawn)
    });
    let drawn = mended(drawn.ok().flatten()?);
    let parts = harmless_parts(&drawn)?;
    Some(match mode {
        DisplayMode::Block => in_pieces(drawn, &parts),
        DisplayMode::Inline => drawn,
    })
}

/// A source without the marks that align its row with others; those of a matrix in it part its cells.
fn without_alignment(source: &str) -> String {
    let parts = source.split('&').scan(0, |depth, part| {
        let (begun, ended) = (
            part.matches("\\begin").count(),
            part.matches("\\end").count(),
        );
        *depth = (*depth + begun).saturating_sub(ended);
        Some([part, if *depth == 0 { " " } else { "&" }])
    });
    let parts: Vec<&str> = parts.flatten().collect();
    parts[..parts.len().saturating_sub(1)].concat()
}

/// What the renderer writes, and what browsers draw as it is meant: a space is no entity, dots over a letter are as large as
/// those of its index, accents don't grow, and no space stands between a function and its power.
const MENDED: [(&str, &str); 10] = [
    ("&amp;nbsp;", "\u{a0}"),
    ("&nbsp;", "\u{a0}"),
    (
        "<mi>˙</mi></mover>",
        "<mo stretchy=\"false\" scriptlevel=\"-1\">˙</mo></mover>",
    ),
    (
        "<mi>¨</mi></mover>",
        "<mo stretchy=\"false\" scriptlevel=\"-1\">¨</mo></mover>",
    ),
    (
        "<mi>→</mi></mover>",
        "<mo stretchy=\"false\">→</mo></mover>",
    ),
    (
        "<mi>^</mi></mover>",
        "<mo stretchy=\"false\">^</mo></mover>",
    ),
    (
        "<mi>~</mi></mover>",
        "<mo stretchy=\"false\">~</mo></mover>",
    ),
    (
        "<msup><mspace width=\"0.1667em\" />",
        "<mspace width=\"0.1667em\" /><msup>",
    ),
    (
        "<msub><mspace width=\"0.1667em\" />",
        "<mspace width=\"0.1667em\" /><msub>",
    ),
    (
        "<msubsup><mspace width=\"0.1667em\" />",
        "<mspace width=\"0.1667em\" /><msubsup>",
    ),
];

/// What stands in what is mended: where none of it is written, nothing is.
const TO_MEND: [&str; 3] = ["&", "</mi></mover>", "<mspace"];

fn mended(drawn: String) -> String {
    let mut mended = drawn;
    for sign in TO_MEND {
        if !mended.contains(sign) {
            continue;
        }
        for (written, meant) in MENDED.iter().filter(|(written, _)| written.contains(sign)) {
            if mended.contains(written) {
                mended = mended.replace(written, meant);
            }
        }
    }
    mended
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
