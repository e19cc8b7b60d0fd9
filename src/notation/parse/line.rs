//! One relation: sides, signs of relation, labels and remarks.

use super::factor::is_relation;
use super::letter::set_of_numbers;
use super::text::{Words, is_constant, is_unit, words};
use super::{Parser, nesting};
use crate::notation::ast::{Kind, Line, Node, Relation};
use crate::notation::document::Row;
use crate::notation::token::{Lexeme, Token};
use crate::source::Span;

/// Labels and remarks beside a line.
#[derive(Debug, Default)]
pub(super) struct Marks {
    pub(super) labels: Vec<String>,
    pub(super) remarks: Vec<String>,
    /// Words before the line, which are part of the sentence that it stands in.
    pub(super) words: Vec<(String, Span)>,
}

/// Takes tags, labels, remarks and words out of a row's tokens.
pub(super) fn take_marks(tokens: &mut Vec<Token<'_>>) -> Marks {
    without_end_mark(tokens);
    without_range(tokens);
    let mut marks = Marks::default();
    let mut shown = vec![];
    let mut depth = 0;
    let mut before: Option<Lexeme<'_>> = None;
    // A unit stands behind a number, a bracket or another unit.
    let mut measured = false;
    let named = named_side(tokens);
    tokens.retain(|token| {
        depth += nesting(token);
        let behind_value = measured;
        measured = measures(token.kind, measured);
        match token.kind {
            Lexeme::Tag(text) => shown.push(super::text::tag(text)),
            Lexeme::Label(text) => marks.labels.push(text.to_owned()),
            Lexeme::Text(text)
                if depth == 0
                    && named != Some(token.span)
                    && !is_constant(text)
                    && !(behind_value && is_unit(text))
                    && !is_operand(text, before) =>
            {
                match words(text) {
                    Words::Label(label) => shown.push(label),
                    Words::Remark(remark) if remark.is_empty() => {}
                    Words::Remark(remark) if before.is_none() => {
                        marks.words.push((remark, token.span));
                    }
                    Words::Remark(remark) => marks.remarks.push(remark),
                }
            }
            Lexeme::Space(_) | Lexeme::Ampersand => return true,
            kind => {
                before = Some(kind);
                return true;
            }
        }
        false
    });
    shown.extend(trailing_label(tokens));
    shown.append(&mut marks.labels);
    marks.labels = shown;
    marks
}

/// Takes the box off that closes a proof, and a number on it.
fn without_end_mark(tokens: &mut Vec<Token<'_>>) {
    let is_box = |kind: Lexeme<'_>| match kind {
        Lexeme::Char(c) => matches!(c, '∎' | '■' | '□' | '◻' | '◼' | '▪' | '▫'),
        Lexeme::Command(name) => matches!(
            name,
            "blacksquare" | "square" | "Box" | "qed" | "qedhere" | "qedsymbol" | "QED"
        ),
        _ => false,
    };
    let Some(at) = tokens.iter().rposition(|t| is_box(t.kind)) else {
        return;
    };
    let mut behind = tokens[at + 1..].iter();
    let mut scripted = false;
    let closes = behind.all(|t| {
        let number = matches!(t.kind, Lexeme::Number(_) | Lexeme::Letter(_)) && scripted;
        scripted |= is_script(t.kind);
        let script = scripted && matches!(t.kind, Lexeme::Open | Lexeme::Close);
        number || script || is_script(t.kind) || is_blank(t) || t.kind == Lexeme::Char('.')
    });
    // A sign before it waits for an operand, and a square alone is a letter.
    let before = trimmed(&tokens[..at]).last();
    let waits = |t: &Token<'_>| super::group::is_sign(t.kind) || is_script(t.kind);
    let letter = before.is_none() && tokens[at].kind == Lexeme::Command("square");
    if closes && !letter && !before.is_some_and(waits) {
        tokens.truncate(at);
    }
}

/// Takes off the set of columns or matrices that a value is of, behind an equation: `v = w \in \mathbb R^3`.
fn without_range(tokens: &mut Vec<Token<'_>>) {
    let is_in = |t: &Token<'_>| t.kind == Lexeme::Command("in");
    let Some(at) = tokens.iter().rposition(is_in) else {
        return;
    };
    let mut behind = tokens[at + 1..].iter().filter(|t| !is_blank(t));
    let board = behind.next().is_some_and(|t| match t.kind {
        Lexeme::Command(name) => name == "mathbb" || set_of_numbers(name).is_some(),
        _ => false,
    });
    let of_numbers = behind.all(|t| match t.kind {
        Lexeme::Letter(_) | Lexeme::Number(_) | Lexeme::Open | Lexeme::Close => true,
        Lexeme::Command(name) => name == "times",
        kind => is_script(kind),
    });
    // Alone it says of what kind the value is, and relates nothing.
    let before = relations(&tokens[..at]);
    let related = before.is_empty() || before.iter().any(|(.., r)| *r == Relation::Equal);
    let closed = tokens[..at].iter().map(nesting).sum::<i32>() == 0;
    if board && of_numbers && closed && related {
        tokens.truncate(at);
    }
}

/// Whether a unit may stand behind a token, given whether one might before it.
fn measures(kind: Lexeme<'_>, measured: bool) -> bool {
    match kind {
        Lexeme::Number(_) | Lexeme::Char(')' | ']' | '/') | Lexeme::End(_) => true,
        Lexeme::Text(_) | Lexeme::Space(_) | Lexeme::Command("cdot") | Lexeme::Superscript => {
            measured
        }
        _ => false,
    }
}

/// The text that is the whole left side of a row: `\text{Torque} = I\alpha`.
fn named_side(tokens: &[Token<'_>]) -> Option<Span> {
    let [first, rest @ ..] = trimmed(tokens) else {
        return None;
    };
    let next = rest.iter().find(|t| !is_blank(t))?;
    let related = relation(std::slice::from_ref(next)).is_some();
    match first.kind {
        Lexeme::Text(text) if related && !super::text::joins(text) => Some(first.span),
        _ => None,
    }
}

/// Whether a text is a part of the expression: a name such as `\text{Iyy}`, a unit, or whatever stands where only an
/// operand can.
fn is_operand(text: &str, before: Option<Lexeme<'_>>) -> bool {
    match before {
        Some(Lexeme::Subscript | Lexeme::Superscript) => true,
        Some(Lexeme::Char('=' | '+' | '-' | '/' | '*')) => true,
        Some(Lexeme::Command(name)) if super::factor::is_operator(name) => true,
        Some(Lexeme::Number(_)) if is_unit(text) => true,
        _ => super::text::is_symbol(text) || super::function::named(text.trim()).is_some(),
    }
}

/// `\quad (8.6)`, `--- (3)`, `\dots (4)`, `.\;(1)` and `(eq:name)` at the end of a relation.
fn trailing_label(tokens: &mut Vec<Token<'_>>) -> Option<String> {
    let close = tokens.len().checked_sub(1)?;
    if tokens[close].kind != Lexeme::Char(')') {
        return None;
    }
    let open = tokens.iter().rposition(|t| t.kind == Lexeme::Char('('))?;
    let label = super::text::plain(&tokens[open + 1..close]);
    let mut start = open;
    while start > 0
        && matches!(
            tokens[start - 1].kind,
            Lexeme::Char('-' | '.' | '–' | '—')
                | Lexeme::Command("dots" | "ldots" | "cdots" | "dotsb")
                | Lexeme::Space(_)
        )
    {
        start -= 1;
    }
    let lead = &tokens[start..open];
    let dashes = lead
        .iter()
        .filter(|t| matches!(t.kind, Lexeme::Char('-' | '.' | '–' | '—')))
        .count();
    let dots = lead.iter().any(|t| matches!(t.kind, Lexeme::Command(_)));
    let gap = lead
        .iter()
        .any(|t| matches!(t.kind, Lexeme::Space(width) if width >= 18));
    let set_apart = dashes >= 2 || dots || gap || is_numbered(lead, &label);
    if !(super::text::is_named_label(&label) || set_apart && super::text::is_label(&label)) {
        return None;
    }
    tokens.truncate(start);
    Some(format!("({label})"))
}

/// Whether a whole number in brackets is that of the formula before it: a thick space parts it from that, which no author puts
/// before a factor two.
fn is_numbered(lead: &[Token<'_>], label: &str) -> bool {
    let digits = !label.is_empty() && label.bytes().all(|b| b.is_ascii_digit());
    let thick = |t: &Token<'_>| matches!(t.kind, Lexeme::Space(width) if width >= 5);
    digits && lead.last().is_some_and(thick)
}

pub(super) fn is_script(kind: Lexeme<'_>) -> bool {
    matches!(kind, Lexeme::Subscript | Lexeme::Superscript)
}

/// The signs of relation outside brackets, each with the tokens that it takes.
pub(super) fn relations(tokens: &[Token<'_>]) -> Vec<(usize, usize, Relation)> {
    let mut found = vec![];
    let mut depth = 0;
    let mut i = 0;
    while i < tokens.len() {
        depth = (depth + nesting(&tokens[i])).max(0);
        let script = i.checked_sub(1).is_some_and(|i| is_script(tokens[i].kind));
        if depth == 0
            && !script
            && let Some((relation, length)) = relation(&tokens[i..])
        {
            found.push((i, length, relation));
            i += length;
        } else {
            i += 1;
        }
    }
    found
}

pub(super) fn relation(tokens: &[Token<'_>]) -> Option<(Relation, usize)> {
    let kind = |i: usize| tokens.get(i).map(|t| t.kind);
    Some(match kind(0)? {
        Lexeme::Char('=') => match kind(1) {
            Some(Lexeme::Char('=')) => (Relation::Equal, 2),
            Some(Lexeme::Char(':')) => (Relation::Defined, 2),
            _ => (Relation::Equal, 1),
        },
        Lexeme::Char(':') if kind(1) == Some(Lexeme::Char('=')) => (Relation::Defined, 2),
        Lexeme::Char('<') if kind(1) == Some(Lexeme::Char('=')) => (Relation::LessOrEqual, 2),
        Lexeme::Char('>') if kind(1) == Some(Lexeme::Char('=')) => (Relation::GreaterOrEqual, 2),
        Lexeme::Char(sign @ ('<' | '>')) if kind(1) == Some(Lexeme::Char(sign)) => {
            (Relation::Other, 2)
        }
        Lexeme::Char('<') => (Relation::Less, 1),
        Lexeme::Char('>') => (Relation::Greater, 1),
        Lexeme::Char('!') if kind(1) == Some(Lexeme::Char('=')) => (Relation::NotEqual, 2),
        Lexeme::Command(name) => match name {
            "equiv" | "triangleq" | "coloneqq" | "coloneq" | "eqdef" | "doteq" => {
                (Relation::Defined, 1)
            }
            "approx" | "simeq" | "cong" | "lesssim" | "gtrsim" => (Relation::Approximate, 1),
            "ne" | "neq" => (Relation::NotEqual, 1),
            "lt" => (Relation::Less, 1),
            "gt" => (Relation::Greater, 1),
            "le" | "leq" | "leqslant" => (Relation::LessOrEqual, 1),
            "ge" | "geq" | "geqslant" => (Relation::GreaterOrEqual, 1),
            "not" => {
                let (denied, length) = relation(tokens.get(1..2)?)?;
                let denies = match denied {
                    Relation::Equal => Relation::NotEqual,
                    _ => Relation::Other,
                };
                (denies, 1 + length)
            }
            "stackrel" | "overset" | "underset" => return stacked(tokens),
            name if is_relation(name) => (Relation::Other, 1),
            _ => return None,
        },
        _ => return None,
    })
}

/// `\stackrel{\text{def}}{=}` defines; any other word above an equals sign is a remark on it.
fn stacked(tokens: &[Token<'_>]) -> Option<(Relation, usize)> {
    // Both are short; no more is looked at for each of them.
    let tokens = &tokens[..tokens.len().min(40)];
    let group = |from: usize| match tokens.get(from)?.kind {
        Lexeme::Open => Some((from + 1, super::closing(tokens, from))),
        _ => Some((from, from + 1)),
    };
    let (from, to) = group(1)?;
    let above = super::text::plain(tokens.get(from..to)?);
    let next = to + usize::from(tokens.get(to).is_some_and(|t| t.kind == Lexeme::Close));
    let (from, to) = group(next)?;
    let base = tokens
        .get(from..to)
        .filter(|_| to < tokens.len() || to == from + 1)?;
    if matches!(
        base.first()?.kind,
        Lexeme::Command("stackrel" | "overset" | "underset")
    ) {
        return None;
    }
    let (inner, _) = relation(base)?;
    let length = to + usize::from(tokens.get(to).is_some_and(|t| t.kind == Lexeme::Close));
    let defines = matches!(above.as_str(), "def" | "def." | "Delta" | "△" | "triangle");
    Some((if defines { Relation::Defined } else { inner }, length))
}

/// Reads the tokens of one row.
pub(super) fn read(tokens: &[Token<'_>], marks: Marks) -> Row {
    let tokens = trimmed(tokens);
    let span = tokens
        .iter()
        .map(|t| t.span)
        .reduce(|a, b| a.to(b))
        .unwrap_or_default();
    let found = relations(tokens);
    if found.is_empty() {
        return expression(spoken_of(tokens), span);
    }
    let continues = found[0].0 == 0;
    let mut sides = vec![];
    let mut start = 0;
    for &(at, length, _) in &found {
        if at > 0 || !continues {
            sides.push(side(&tokens[start..at], tokens[at].span));
        }
        start = at + length;
    }
    sides.push(side(
        &tokens[start..],
        Span {
            start: span.end,
            end: span.end,
        },
    ));
    let relations = found
        .iter()
        .map(|&(at, length, relation)| (relation, tokens[at].span.to(tokens[at + length - 1].span)))
        .collect();
    Row::Line(Line {
        sides,
        relations,
        continues,
        labels: marks.labels,
        ranges: vec![],
        remarks: marks.remarks,
        span,
    })
}

/// Whether tokens say nothing that could hold or have a value: a sign that is only spoken of, or the number of a line,
/// `(13.21.1)`.
pub(super) fn is_mention(tokens: &[Token<'_>]) -> bool {
    let sign = |t: &Token<'_>| {
        let relation = relation(std::slice::from_ref(t)).is_some();
        relation || super::group::is_sign(t.kind) || t.kind == Lexeme::Command("not")
    };
    match tokens {
        [] => false,
        [open, inner @ .., close]
            if open.kind == Lexeme::Char('(') && close.kind == Lexeme::Char(')') =>
        {
            let label = super::text::plain(inner);
            let parts = label.split('.').count();
            parts > 2 && label.split('.').all(|part| part.parse::<u16>().is_ok())
        }
        _ => tokens.iter().all(sign),
    }
}

/// The thing that tokens without a relation name: of `x-`, which a word goes on from, and of `N: \{O, x, y, z\}`, which
/// lists what belongs to it, only the first.
fn spoken_of<'t, 'a>(tokens: &'t [Token<'a>]) -> &'t [Token<'a>] {
    if let [named @ .., last] = tokens
        && last.kind == Lexeme::Char('-')
        && !trimmed(named).is_empty()
    {
        return trimmed(named);
    }
    let colon = tokens.iter().position(|t| t.kind == Lexeme::Char(':'));
    if let Some(at) = colon {
        let list = trimmed(&tokens[at + 1..]);
        let opens = list.first().is_some_and(|t| t.kind == Lexeme::Char('{'));
        let whole = opens && super::bracket_end(list, 0) == Some(list.len() - 1);
        let several = list.iter().any(|t| t.kind == Lexeme::Char(','));
        if whole && several && at > 0 {
            return trimmed(&tokens[..at]);
        }
    }
    tokens
}

fn expression(tokens: &[Token<'_>], span: Span) -> Row {
    let node = Parser::new(tokens, span).side();
    match node.kind {
        Kind::Error(message) => Row::Unreadable {
            message,
            help: None,
            span: node.span,
        },
        _ => Row::Expression(node),
    }
}

fn side(tokens: &[Token<'_>], end: Span) -> Node {
    Parser::new(trimmed(tokens), end).side()
}

fn is_blank(token: &Token<'_>) -> bool {
    matches!(token.kind, Lexeme::Space(_) | Lexeme::Ampersand)
}

/// Without spaces, alignment marks and the punctuation of the sentence at the ends.
pub(super) fn trimmed<'t, 'a>(tokens: &'t [Token<'a>]) -> &'t [Token<'a>] {
    let blank = |t: &&Token<'_>| is_blank(t);
    let closing =
        |t: &&Token<'_>| is_blank(t) || matches!(t.kind, Lexeme::Char('.' | ',' | ';' | ':'));
    let from = tokens.iter().take_while(blank).count();
    let to = tokens[from..].iter().rev().take_while(closing).count();
    &tokens[from..tokens.len() - to]
}
