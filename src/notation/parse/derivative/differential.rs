//! What stands above and below the line of a derivative: a d with its frame, its order and what follows it.

use crate::notation::ast::FrameLabel;
use crate::notation::token::{Lexeme, Token};

/// What a numerator or a denominator of differentials says.
pub(super) struct Differential<'t, 'a> {
    pub(super) partial: bool,
    pub(super) order: u8,
    /// A frame written beside the d: `{}^{N}d`.
    pub(super) frame: Option<FrameLabel>,
    pub(super) rest: &'t [Token<'a>],
}

/// `\tilde d`, `\mathring{d}`, `d^*`: a d that is marked for axes that turn, and how many tokens it takes.
fn marked_d(tokens: &[Token<'_>]) -> Option<usize> {
    let kinds: Vec<Lexeme<'_>> = tokens.iter().take(5).map(|t| t.kind).collect();
    let star = |kind: &Lexeme<'_>| {
        matches!(
            kind,
            Lexeme::Char('*') | Lexeme::Command("ast" | "star" | "circ" | "prime")
        )
    };
    match kinds.as_slice() {
        [
            Lexeme::Command("tilde" | "mathring" | "widetilde"),
            Lexeme::Letter('d'),
            ..,
        ] => Some(2),
        [
            Lexeme::Command("tilde" | "mathring" | "widetilde"),
            Lexeme::Open,
            Lexeme::Letter('d'),
            Lexeme::Close,
            ..,
        ] => Some(4),
        [
            Lexeme::Letter('d'),
            Lexeme::Superscript,
            Lexeme::Open,
            mark,
            Lexeme::Close,
        ] if star(mark) => Some(5),
        [Lexeme::Letter('d'), Lexeme::Superscript, mark, ..] if star(mark) => Some(3),
        _ => None,
    }
}

/// How many tokens a `d` or `∂` takes at the start of a slice, and whether it is partial.
pub(in crate::notation::parse) fn mark(tokens: &[Token<'_>]) -> Option<(usize, bool)> {
    let kind = |i: usize| tokens.get(i).map(|t| t.kind);
    match kind(0)? {
        Lexeme::Letter('d') | Lexeme::Text("d") | Lexeme::Command("dd" | "dif" | "diff") => {
            Some((1, false))
        }
        Lexeme::Command("partial") => Some((1, true)),
        Lexeme::Open => grouped_mark(tokens),
        Lexeme::Command("mathrm" | "rm" | "mathit" | "operatorname") => match kind(1)? {
            Lexeme::Letter('d') => Some((2, false)),
            // Scanned formulas have spaces inside: `\mathrm{~d} t`.
            Lexeme::Open => {
                let spaces = |&i: &usize| matches!(kind(i), Some(Lexeme::Space(_)));
                let letter = 2 + (2..).take_while(spaces).count();
                let close = letter + 1 + (letter + 1..).take_while(spaces).count();
                (kind(letter) == Some(Lexeme::Letter('d')) && kind(close) == Some(Lexeme::Close))
                    .then_some((close + 1, false))
            }
            _ => None,
        },
        _ => None,
    }
}

/// What an author's own `\dd` leaves: a group, or a few in each other, with nothing else in it.
fn grouped_mark(tokens: &[Token<'_>]) -> Option<(usize, bool)> {
    let near = &tokens[..tokens.len().min(4)];
    let opened = near.iter().take_while(|t| t.kind == Lexeme::Open).count();
    let inside = tokens.get(opened..)?;
    if inside.first()?.kind == Lexeme::Open {
        return None;
    }
    let (length, partial) = mark(inside)?;
    let closing = inside.get(length..length + opened)?;
    let closed = closing.iter().all(|t| t.kind == Lexeme::Close);
    closed.then_some((length + 2 * opened, partial))
}

pub(in crate::notation::parse) fn order(tokens: &[Token<'_>]) -> Option<(usize, u8)> {
    let kind = |i: usize| tokens.get(i).map(|t| t.kind);
    let digits = |k: Option<Lexeme<'_>>| match k {
        Some(Lexeme::Number(digits)) => digits.parse::<u8>().ok().filter(|n| (1..=8).contains(n)),
        _ => None,
    };
    // `\dd[2]{x}` of the package physics.
    if kind(0) == Some(Lexeme::Char('[')) && kind(2) == Some(Lexeme::Char(']')) {
        return digits(kind(1)).map(|n| (3, n));
    }
    if kind(0) != Some(Lexeme::Superscript) {
        return Some((0, 1));
    }
    match kind(1)? {
        Lexeme::Open if kind(3) == Some(Lexeme::Close) => digits(kind(2)).map(|n| (4, n)),
        one => digits(Some(one)).map(|n| (2, n)),
    }
}

pub(super) fn above<'t, 'a>(tokens: &'t [Token<'a>]) -> Option<Differential<'t, 'a>> {
    let (frame, tokens) = prescript(tokens);
    let mut frame = frame.map(label);
    let marked = marked_d(tokens);
    let (length, partial) = match marked {
        Some(length) => (length, false),
        None => mark(tokens)?,
    };
    let turns = |token: &Token<'_>| token.kind == Lexeme::Char('\'');
    let (below, mut rest) = subscript(&tokens[length..]);
    frame = frame.or(below.map(label));
    if marked.is_some() {
        frame = frame.or(Some(FrameLabel::new(FrameLabel::TURNING, tokens[0].span)));
    } else if let Some(mark) = rest.first().filter(|t| turns(t)) {
        frame = frame.or(Some(FrameLabel::new(FrameLabel::TURNING, mark.span)));
        rest = &rest[1..];
    }
    // Beside a d whose frame is told another one belongs to what follows: `^N d\,^N\omega`.
    let raised = rest.first().is_some_and(|t| t.kind == Lexeme::Superscript);
    if frame.is_some() && raised && frame_above(rest).0.is_some() {
        return Some(Differential {
            partial,
            order: 1,
            frame,
            rest: trim(rest),
        });
    }
    let (above, tokens) = frame_above(rest);
    frame = frame.or(above.map(label));
    let (more, order) = order(tokens)?;
    let rest = trim(&tokens[more..]);
    Some(Differential {
        partial,
        order,
        frame,
        rest,
    })
}

/// The tokens of a script as the label of a frame.
fn label(tokens: &[Token<'_>]) -> FrameLabel {
    FrameLabel {
        text: crate::notation::parse::text::plain(tokens),
        span: tokens
            .iter()
            .map(|t| t.span)
            .reduce(|a, b| a.to(b))
            .unwrap_or_default(),
    }
}

pub(super) fn trim<'t, 'a>(tokens: &'t [Token<'a>]) -> &'t [Token<'a>] {
    let blank = |t: &&Token<'_>| matches!(t.kind, Lexeme::Space(_));
    let from = tokens.iter().take_while(blank).count();
    let to = tokens[from..].iter().rev().take_while(blank).count();
    &tokens[from..tokens.len() - to]
}

/// `_B` behind a d, as in `\frac{d_B L}{dt}`.
fn subscript<'t, 'a>(tokens: &'t [Token<'a>]) -> (Option<&'t [Token<'a>]>, &'t [Token<'a>]) {
    match tokens {
        [first, rest @ ..] if first.kind == Lexeme::Subscript => script(rest),
        _ => (None, tokens),
    }
}

/// `^{N}` behind a d, as in `\frac{d^N L}{dt}`; a number there is the order.
fn frame_above<'t, 'a>(tokens: &'t [Token<'a>]) -> (Option<&'t [Token<'a>]>, &'t [Token<'a>]) {
    let raised = match tokens {
        [first, rest @ ..] if first.kind == Lexeme::Superscript => script(rest),
        _ => return (None, tokens),
    };
    let names = |label: &[Token<'_>]| match label.last().map(|t| t.kind) {
        Some(Lexeme::Letter(c)) => c.is_ascii_uppercase(),
        Some(Lexeme::Close) => matches!(label[0].kind, Lexeme::Command(_)),
        Some(Lexeme::Text(_)) => true,
        _ => false,
    };
    match raised {
        (Some(label), rest) if names(label) => (Some(label), rest),
        _ => (None, tokens),
    }
}

/// `D t` below a line makes the D above it a d, and `\delta t` a δ: `\frac{D L}{D t}`, `\frac{\delta L}{\delta t}`.
pub(super) fn total<'t, 'a>(
    top: &'t [Token<'a>],
    bottom: &[Token<'a>],
) -> Option<Differential<'t, 'a>> {
    let (top, bottom) = (trim(top), trim(bottom));
    let small = |tokens: &[Token<'_>]| match tokens.first()?.kind {
        Lexeme::Command("delta") | Lexeme::Letter('δ') => Some(1),
        _ => None,
    };
    let (length, below, frame) = match (total_mark(top), small(top)) {
        (Some(length), _) => (length, total_mark(bottom)?, None),
        (None, Some(length)) => (
            length,
            small(bottom)?,
            Some(FrameLabel::new(FrameLabel::DELTA, top[0].span)),
        ),
        (None, None) => return None,
    };
    let time = trim(&bottom[below..]);
    let total = matches!(time, [t] if t.kind == Lexeme::Letter('t'));
    total.then_some(Differential {
        partial: false,
        order: 1,
        frame,
        rest: trim(&top[length..]),
    })
}

/// How many tokens a D takes at the start of a slice, upright or not.
pub(super) fn total_mark(tokens: &[Token<'_>]) -> Option<usize> {
    let kind = |i: usize| tokens.get(i).map(|t| t.kind);
    let letter = |i: usize| kind(i) == Some(Lexeme::Letter('D'));
    match kind(0)? {
        Lexeme::Letter('D') => Some(1),
        Lexeme::Command("mathrm" | "rm") if letter(1) => Some(2),
        Lexeme::Command("mathrm") if letter(2) && kind(3) == Some(Lexeme::Close) => Some(4),
        _ => None,
    }
}

/// `{}^{N}` before the rest.
fn prescript<'t, 'a>(tokens: &'t [Token<'a>]) -> (Option<&'t [Token<'a>]>, &'t [Token<'a>]) {
    let kinds = (
        tokens.first().map(|t| t.kind),
        tokens.get(1).map(|t| t.kind),
        tokens.get(2).map(|t| t.kind),
    );
    let skip = match kinds {
        (Some(Lexeme::Open), Some(Lexeme::Close), Some(Lexeme::Superscript)) => 3,
        (Some(Lexeme::Superscript), ..) => 1,
        _ => return (None, tokens),
    };
    script(&tokens[skip..])
}

/// The argument of a script and what follows it.
pub(super) fn script<'t, 'a>(
    tokens: &'t [Token<'a>],
) -> (Option<&'t [Token<'a>]>, &'t [Token<'a>]) {
    match tokens.first().map(|t| t.kind) {
        Some(Lexeme::Open) => {
            let close = crate::notation::parse::closing(tokens, 0);
            (
                Some(&tokens[1..close]),
                &tokens[(close + 1).min(tokens.len())..],
            )
        }
        Some(_) => (Some(&tokens[..1]), &tokens[1..]),
        None => (None, tokens),
    }
}
