//! A formula as rows: environments of lines, line breaks, and several relations beside one another.

use super::line::{Marks, read, relations, take_marks, trimmed};
use super::{closing, nesting};
use crate::notation::ast::{Kind, Line};
use crate::notation::document::Row;
use crate::notation::token::{Lexeme, Token};

/// Environments whose rows are lines.
const LISTS: &[&str] = &[
    "aligned",
    "align",
    "alignat",
    "alignedat",
    "flalign",
    "gather",
    "gathered",
    "split",
    "eqnarray",
    "multline",
    "multlined",
    "equation",
    "subequations",
    "cases",
    "dcases",
    "rcases",
    "displaymath",
    "math",
    "dmath",
    "dgroup",
    "empheq",
    "subnumcases",
    "numcases",
    "IEEEeqnarray",
];

/// Environments in which every second `&` separates columns of equations.
const COLUMNS: &[&str] = &[
    "align",
    "aligned",
    "alignat",
    "alignedat",
    "flalign",
    "cases",
    "dcases",
    "rcases",
];

/// What stands between two pieces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Break {
    Row,
    Gap,
    Comma,
}

struct Piece<'a> {
    before: Break,
    tokens: Vec<Token<'a>>,
}

/// The rows of a formula.
pub(crate) fn rows(tokens: &[Token<'_>]) -> Vec<Row> {
    let mut splitter = Splitter {
        pieces: vec![],
        current: vec![],
        before: Break::Row,
    };
    splitter.split(tokens, "", 0);
    splitter.flush(Break::Row);
    let mut out = Rows::default();
    for piece in join(splitter.pieces) {
        out.piece(piece);
    }
    out.settle();
    out.rows
}

struct Splitter<'a> {
    pieces: Vec<Piece<'a>>,
    current: Vec<Token<'a>>,
    before: Break,
}

impl<'a> Splitter<'a> {
    fn flush(&mut self, next: Break) {
        let tokens = std::mem::take(&mut self.current);
        if !trimmed(&tokens).is_empty() {
            self.pieces.push(Piece {
                before: self.before,
                tokens,
            });
            self.before = next;
        } else if next == Break::Row {
            self.before = next;
        }
    }

    fn split(&mut self, tokens: &[Token<'a>], environment: &str, level: u32) {
        let mut depth = 0;
        let mut ampersands = 0;
        let mut i = 0;
        while i < tokens.len() {
            let token = tokens[i];
            let next = if depth == 0 {
                self.structure(tokens, i, level)
            } else {
                None
            };
            if let Some(next) = next {
                i = next;
                continue;
            }
            let outside = depth == 0;
            depth = (depth + nesting(&token)).max(0);
            i += 1;
            match token.kind {
                Lexeme::Row if outside => {
                    ampersands = 0;
                    self.flush(Break::Row);
                }
                Lexeme::Ampersand if outside => {
                    ampersands += 1;
                    if ampersands % 2 == 0 && COLUMNS.contains(&environment)
                        || (ampersands == 1 && environment == "cases")
                    {
                        self.flush(Break::Gap);
                    }
                }
                Lexeme::Space(width) if outside && width >= 18 => {
                    // A label behind the gap needs to see that one was written.
                    let label_follows = tokens.get(i).is_some_and(|t| t.kind == Lexeme::Char('('));
                    if !(label_follows && self.take_label(tokens, &mut i)) {
                        self.flush(Break::Gap);
                    }
                }
                Lexeme::Char(',' | ';') if outside => self.flush(Break::Comma),
                Lexeme::Command(name) if outside && is_arrow(name) => self.flush(Break::Gap),
                Lexeme::Text(text) if outside && super::text::joins(text) => self.flush(Break::Gap),
                _ => self.current.push(token),
            }
        }
    }

    /// `(8.6)` behind a gap, as a label on what stands before it.
    fn take_label(&mut self, tokens: &[Token<'a>], i: &mut usize) -> bool {
        let Some(end) = super::bracket_end(tokens, *i) else {
            return false;
        };
        let text = super::text::plain(&tokens[*i + 1..end]);
        let last = tokens
            .get(end + 1)
            .is_none_or(|t| matches!(t.kind, Lexeme::Row | Lexeme::Char('.' | ',')));
        if !last || !super::text::is_label(&text) || self.current.is_empty() {
            return false;
        }
        let span = tokens[*i].span;
        self.current.push(Token {
            kind: Lexeme::Space(18),
            span,
            spaced: false,
        });
        self.current.extend_from_slice(&tokens[*i..=end]);
        *i = end + 1;
        true
    }

    /// An environment of lines, or a bracket around one, is gone into; the index behind it is returned.
    fn structure(&mut self, tokens: &[Token<'a>], i: usize, level: u32) -> Option<usize> {
        if level > 8 {
            return None;
        }
        let opens = matches!(
            tokens[i].kind,
            Lexeme::LeftNull | Lexeme::Char('{' | '[' | '(')
        );
        let begin = i + usize::from(opens);
        let Lexeme::Begin(name) = tokens.get(begin)?.kind else {
            return None;
        };
        let end = closing(tokens, begin);
        let inside = tokens.get(begin + 1..end)?;
        let listed = LISTS.contains(&name) || (name == "array" && holds_relation(inside));
        let valued = matches!(name, "cases" | "dcases" | "array") && !holds_relation(inside);
        if !listed || valued {
            return None;
        }
        let mut after = (end + 1).min(tokens.len());
        let closes = matches!(
            tokens.get(after).map(|t| t.kind),
            Some(Lexeme::RightNull | Lexeme::Char('}' | ']' | ')') | Lexeme::RightBar)
        );
        after += usize::from(closes);
        self.split(inside, name, level + 1);
        Some(after)
    }
}

fn is_arrow(name: &str) -> bool {
    matches!(
        name,
        "Rightarrow"
            | "Longrightarrow"
            | "implies"
            | "iff"
            | "Leftrightarrow"
            | "therefore"
            | "because"
            | "hookrightarrow"
            | "Longleftrightarrow"
            | "Leftarrow"
            | "leadsto"
            | "downarrow"
            | "Downarrow"
            | "impliedby"
            | "rightsquigarrow"
    )
}

/// Whether a sign of relation stands in the rows outside inner brackets.
fn holds_relation(tokens: &[Token<'_>]) -> bool {
    !relations(tokens).is_empty()
}

/// Pieces that go on from the one before are joined to it.
fn join(pieces: Vec<Piece<'_>>) -> Vec<Piece<'_>> {
    let mut out: Vec<Piece<'_>> = vec![];
    for piece in pieces {
        match out.last_mut() {
            Some(last) if goes_on(last, &piece) => last.tokens.extend(piece.tokens),
            _ => out.push(piece),
        }
    }
    out
}

fn goes_on(last: &Piece<'_>, piece: &Piece<'_>) -> bool {
    let signs = |kind: Option<Lexeme<'_>>| {
        matches!(
            kind,
            Some(
                Lexeme::Char('+' | '-' | '/' | '*')
                    | Lexeme::Command("times" | "cdot" | "pm" | "mp")
            )
        )
    };
    let tokens = without_empty_groups(trimmed(&piece.tokens));
    let first = tokens.first().map(|t| t.kind);
    let ended = trimmed(&last.tokens).last().map(|t| t.kind);
    let related = |piece: &Piece<'_>| !relations(trimmed(&piece.tokens)).is_empty();
    let open_end = signs(ended) || ended == Some(Lexeme::Char('='));
    let first_is_relation = relations(tokens).first().is_some_and(|(at, ..)| *at == 0);
    match piece.before {
        Break::Comma => false,
        _ if open_end => true,
        _ if first_is_relation => piece.before == Break::Gap && related(last),
        _ => {
            let plus = first == Some(Lexeme::Char('+'));
            signs(first) && related(last) && (plus || !related(piece))
        }
    }
}

/// `{}` stands before a sign only for its spacing.
fn without_empty_groups<'t, 'a>(tokens: &'t [Token<'a>]) -> &'t [Token<'a>] {
    match tokens {
        [open, close, rest @ ..] if open.kind == Lexeme::Open && close.kind == Lexeme::Close => {
            rest
        }
        _ => tokens,
    }
}

#[derive(Default)]
struct Rows {
    rows: Vec<Row>,
    /// `i = 1` was just read: numbers behind a comma go on with it.
    pending: Option<(String, Vec<String>)>,
}

impl Rows {
    fn piece(&mut self, piece: Piece<'_>) {
        let mut tokens = piece.tokens;
        let marks = take_marks(&mut tokens);
        let body = trimmed(&tokens);
        if body.is_empty() {
            return self.attach(marks);
        }
        if let Some(range) = range_in_brackets(body) {
            return self.range(range);
        }
        if let ([one], Some((_, values)), Break::Comma) = (body, &mut self.pending, piece.before)
            && let Lexeme::Number(value) = one.kind
        {
            values.push(value.to_owned());
            return;
        }
        self.settle();
        if piece.before != Break::Row
            && let Some(range) = range(body)
            && self.last_line().is_some()
        {
            self.pending = Some(range);
            return;
        }
        self.rows.push(read(body, marks));
    }

    fn last_line(&mut self) -> Option<&mut Line> {
        match self.rows.last_mut() {
            Some(Row::Line(line)) => Some(line),
            _ => None,
        }
    }

    fn attach(&mut self, marks: Marks) {
        if let Some(line) = self.last_line() {
            line.labels.extend(marks.labels);
            line.remarks.extend(marks.remarks);
        }
    }

    fn range(&mut self, range: (String, Vec<String>)) {
        if let Some(line) = self.last_line() {
            line.ranges.push(range);
        }
    }

    fn settle(&mut self) {
        if let Some(range) = self.pending.take() {
            self.range(range);
        }
    }
}

/// `(i = 1, 2, 3)`.
fn range_in_brackets(tokens: &[Token<'_>]) -> Option<(String, Vec<String>)> {
    let [open, inner @ .., close] = tokens else {
        return None;
    };
    if open.kind != Lexeme::Char('(') || close.kind != Lexeme::Char(')') {
        return None;
    }
    range(inner)
}

/// `i = 1, 2, 3`: an index letter and whole numbers or axes.
fn range(tokens: &[Token<'_>]) -> Option<(String, Vec<String>)> {
    let [index, equals, values @ ..] = tokens else {
        return None;
    };
    let Lexeme::Letter(letter @ ('i' | 'j' | 'k' | 'n' | 'a' | 'b')) = index.kind else {
        return None;
    };
    if equals.kind != Lexeme::Char('=') || values.is_empty() {
        return None;
    }
    let mut out = vec![];
    for part in super::split_outside(values, |t| t.kind == Lexeme::Char(',')) {
        match trimmed(part) {
            [one] => match one.kind {
                Lexeme::Number(value) => out.push(value.to_owned()),
                Lexeme::Letter(axis @ 'x'..='z') => out.push(axis.to_string()),
                Lexeme::Command("dots" | "ldots" | "cdots") => out.push("…".into()),
                _ => return None,
            },
            _ => return None,
        }
    }
    Some((letter.to_string(), spelled(out)))
}

/// `1, …, 3` with what was left out.
fn spelled(values: Vec<String>) -> Vec<String> {
    if let [first, dots, last] = values.as_slice()
        && dots == "…"
        && let (Ok(first), Ok(last)) = (first.parse::<u32>(), last.parse::<u32>())
        && last < first.saturating_add(20)
    {
        return (first..=last).map(|n| n.to_string()).collect();
    }
    values
}

/// Whether any node of the rows is an error; a formula with one is still read around it.
pub(crate) fn first_error(row: &Row) -> Option<(String, crate::source::Span)> {
    match row {
        Row::Unreadable { message, span, .. } => Some((message.clone(), *span)),
        Row::Line(line) => line.sides.iter().find_map(error_in),
        Row::Expression(node) => error_in(node),
    }
}

fn error_in(node: &crate::notation::ast::Node) -> Option<(String, crate::source::Span)> {
    match &node.kind {
        Kind::Error(message) => Some((message.clone(), node.span)),
        _ => node.children().into_iter().find_map(error_in),
    }
}
