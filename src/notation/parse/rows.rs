//! A formula as rows: what each of its pieces is, and what belongs to a row beside it.

use super::line::{Marks, read, take_marks, trimmed};
use super::pieces::{Break, Piece, holds_relation, pieces};
use super::range::{Range, index_value, range, range_in_brackets, spelled};
use crate::notation::ast::{Kind, Line};
use crate::notation::document::Row;
use crate::notation::token::{Lexeme, Token};
use crate::source::Span;

/// The rows of a formula, and the words between them.
#[derive(Debug, Default)]
pub(crate) struct Reading {
    /// The rows.
    pub(crate) rows: Vec<Row>,
    /// Words of the sentence, each with the index of the row before which they stand.
    pub(crate) words: Vec<(usize, String, Span)>,
}

/// Reads the rows of a formula.
pub(crate) fn rows(tokens: &[Token<'_>]) -> Reading {
    let mut out = Rows::default();
    let physics = |t: &Token<'_>| matches!(t.kind, Lexeme::Command(name) if name.ends_with("mqty") || name.starts_with("mdet") || name.contains("matrix"));
    let tokens = super::over::with_fractions(tokens);
    let spelled = match tokens.iter().any(physics) {
        true => super::group::ungrouped(&super::physics::spelled_out(&tokens)),
        false => super::group::ungrouped(&tokens),
    };
    let mut pieces = pieces(&spelled).into_iter().peekable();
    while let Some(piece) = pieces.next() {
        let beside = pieces.peek().is_some_and(|next| next.before == Break::Gap);
        match leading_label(&piece).filter(|_| beside) {
            Some(label) => out.ahead.labels.push(label),
            None => out.piece(piece),
        }
    }
    out.end()
}

/// The inside of brackets that hold all the tokens.
fn bracketed<'t, 'a>(tokens: &'t [Token<'a>]) -> Option<&'t [Token<'a>]> {
    let [open, inner @ .., _] = tokens else {
        return None;
    };
    let round = open.kind == Lexeme::Char('(');
    (round && super::bracket_end(tokens, 0) == Some(tokens.len() - 1)).then_some(inner)
}

/// `(a)` before a line is its label.
fn leading_label(piece: &Piece<'_>) -> Option<String> {
    let label = super::text::plain(bracketed(trimmed(&piece.tokens))?);
    (piece.before == Break::Row && super::text::is_label(&label)).then(|| format!("({label})"))
}

#[derive(Default)]
struct Rows {
    read: Reading,
    /// `i = 1` was just read: numbers behind a comma go on with it.
    pending: Option<Range>,
    /// Labels and words that wait for the line they stand before.
    ahead: Marks,
}

impl Rows {
    fn piece(&mut self, piece: Piece<'_>) {
        let mut tokens = piece.tokens;
        let mut marks = take_marks(&mut tokens);
        let body = trimmed(&tokens);
        if body.is_empty() || super::line::is_mention(body) {
            return self.attach(marks);
        }
        if let Some(range) = range_in_brackets(body) {
            return self.range(range);
        }
        if body[0].kind == Lexeme::Command("forall") && self.last_line().is_some() {
            return self.attach(Marks {
                remarks: vec![super::text::plain(body)],
                ..marks
            });
        }
        if let ([one], Some((_, values)), Break::Comma) = (body, &mut self.pending, piece.before)
            && let Some(value) = index_value(one.kind)
        {
            values.push(value);
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
        match bracketed(body).filter(|inner| holds_relation(inner)) {
            // `a = b \quad (c = 0)`: what stands in brackets is a condition.
            Some(inner) if self.last_line().is_some() => {
                let mut inner = inner.to_vec();
                marks.words.extend(take_marks(&mut inner).words);
                if marks.words.is_empty() {
                    marks.words.push(("if".into(), body[0].span));
                }
                self.line(&inner, marks);
            }
            _ => self.line(body, marks),
        }
    }

    /// What stands before a line goes with it.
    fn line(&mut self, body: &[Token<'_>], mut marks: Marks) {
        let mut ahead = std::mem::take(&mut self.ahead);
        ahead.labels.append(&mut marks.labels);
        marks.labels = ahead.labels;
        let at = self.read.rows.len();
        let words = ahead
            .words
            .into_iter()
            .chain(std::mem::take(&mut marks.words));
        let words: Vec<_> = words.map(|(text, span)| (at, text, span)).collect();
        self.read.words.extend(words);
        self.read.rows.push(read(body, marks));
    }

    fn last_line(&mut self) -> Option<&mut Line> {
        match self.read.rows.last_mut() {
            Some(Row::Line(line)) => Some(line),
            _ => None,
        }
    }

    fn attach(&mut self, marks: Marks) {
        self.ahead.words.extend(marks.words);
        match self.last_line() {
            Some(line) => {
                line.labels.extend(marks.labels);
                line.remarks.extend(marks.remarks);
            }
            None => self.ahead.labels.extend(marks.labels),
        }
    }

    fn end(mut self) -> Reading {
        self.settle();
        let words = std::mem::take(&mut self.ahead.words).into_iter();
        if let Some(line) = self.last_line() {
            line.remarks.extend(words.map(|(text, _)| text));
        }
        self.read
    }

    fn range(&mut self, range: Range) {
        if let Some(line) = self.last_line() {
            line.ranges.push(range);
        }
    }

    fn settle(&mut self) {
        if let Some((index, values)) = self.pending.take() {
            self.range((index, spelled(values)));
        }
    }
}

/// Whether any node of the rows is an error; a formula with one is still read around it.
pub(crate) fn first_error(row: &Row) -> Option<(String, Span)> {
    match row {
        Row::Unreadable { message, span, .. } => Some((message.clone(), *span)),
        Row::Line(line) => line.sides.iter().find_map(error_in),
        Row::Expression(node) => error_in(node),
    }
}

pub(super) fn error_in(node: &crate::notation::ast::Node) -> Option<(String, Span)> {
    match &node.kind {
        Kind::Error(message) => Some((message.clone(), node.span)),
        _ => {
            let mut found = None;
            node.children()
                .for_each(|child| found = found.take().or_else(|| error_in(child)));
            found
        }
    }
}
