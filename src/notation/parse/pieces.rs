//! A formula in pieces: environments of lines are gone into, and rows, gaps, commas and arrows part it.

use super::arrows::{is_arrow, joins_equations};
use super::group::is_sign;
use super::line::{is_script, relation, relations, trimmed};
use super::{closing, nesting};
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
pub(super) enum Break {
    Row,
    Gap,
    Comma,
}

pub(super) struct Piece<'a> {
    pub(super) before: Break,
    pub(super) tokens: Vec<Token<'a>>,
}

/// The pieces of a formula in order, those that go on from the one before joined to it.
pub(super) fn pieces<'a>(tokens: &[Token<'a>]) -> Vec<Piece<'a>> {
    let mut splitter = Splitter {
        pieces: vec![],
        current: Vec::with_capacity(tokens.len()),
        related: false,
        before: Break::Row,
    };
    splitter.split(tokens, "", 0);
    splitter.flush(Break::Row);
    join(splitter.pieces)
}

struct Splitter<'a> {
    pieces: Vec<Piece<'a>>,
    current: Vec<Token<'a>>,
    /// Whether a sign of relation stands in `current`.
    related: bool,
    before: Break,
}

impl<'a> Splitter<'a> {
    fn flush(&mut self, next: Break) {
        let tokens = std::mem::take(&mut self.current);
        self.related = false;
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

    fn relates(&self, token: &Token<'a>) -> bool {
        let script = self.current.last().is_some_and(|t| is_script(t.kind));
        !script && relation(std::slice::from_ref(token)).is_some()
    }

    /// Whether a line is complete so far, so that a `&` behind it parts it from the next.
    fn holds_line(&self) -> bool {
        let spaces = |t: &&Token<'a>| matches!(t.kind, Lexeme::Space(_) | Lexeme::Ampersand);
        let last = self.current.iter().rev().find(|t| !spaces(t));
        self.related && last.is_some_and(|t| !is_sign(t.kind))
    }

    /// Whether the cell behind a `&` begins with a sign of relation.
    fn relation_follows(tokens: &[Token<'a>]) -> bool {
        let next = tokens
            .iter()
            .find(|t| !matches!(t.kind, Lexeme::Space(_) | Lexeme::Ampersand));
        next.is_some_and(|t| relation(std::slice::from_ref(t)).is_some())
    }

    fn split(&mut self, tokens: &[Token<'a>], environment: &str, level: u32) {
        let balanced = tokens.iter().map(nesting).sum::<i32>() == 0;
        let mut environments = 0;
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
                Lexeme::Begin(_) => environments += 1,
                Lexeme::End(_) => environments -= 1,
                _ => {}
            }
            match token.kind {
                // A bracket may reach over the end of a row, but one that is never closed must not.
                Lexeme::Row if !outside && environments == 0 && !balanced => {
                    (depth, ampersands) = (0, 0);
                    self.flush(Break::Row);
                }
                Lexeme::Row | Lexeme::Ampersand if !outside && environments == 0 => {}
                // A formula over several rows has its sign of relation in any of them.
                Lexeme::Row if outside && environment.starts_with("multline") && !self.related => {}
                Lexeme::Row if outside => {
                    ampersands = 0;
                    self.flush(Break::Row);
                }
                Lexeme::Ampersand if outside => {
                    ampersands += 1;
                    let column = ampersands % 2 == 0 && COLUMNS.contains(&environment);
                    let condition = ampersands == 1 && environment == "cases";
                    if ((column || condition) && !Self::relation_follows(&tokens[i..]))
                        || self.holds_line()
                    {
                        self.flush(Break::Gap);
                    }
                }
                Lexeme::Space(width) if outside && width >= 18 => {
                    // A label behind the gap needs to see that one was written.
                    if !self.take_label(tokens, &mut i) {
                        self.flush(Break::Gap);
                    }
                }
                Lexeme::Char(',') if outside && self.parts_digits(tokens, i - 1) => {
                    self.current.push(token);
                }
                Lexeme::Char(',' | ';') if outside => self.flush(Break::Comma),
                Lexeme::Command(name)
                    if outside
                        && (is_arrow(name)
                            || joins_equations(name, &self.current, &tokens[i..])) =>
                {
                    self.flush(Break::Gap);
                }
                Lexeme::Text(text) if outside && super::text::joins(text) => {
                    self.flush(Break::Gap);
                    self.current.push(token);
                }
                _ => {
                    self.related |= outside && self.relates(&token);
                    self.current.push(token);
                }
            }
        }
    }

    /// Whether the comma at an index stands close between two numbers alone: `3,5` may be a decimal, a number of
    /// thousands or a list, but `i = 1,2` counts and `1,2,3` is a list.
    fn parts_digits(&self, tokens: &[Token<'a>], at: usize) -> bool {
        let number = |i: usize| matches!(tokens.get(i).map(|t| t.kind), Some(Lexeme::Number(_)));
        let comma = |i: usize| tokens.get(i).map(|t| t.kind) == Some(Lexeme::Char(','));
        let close = |i: usize| tokens.get(i).is_some_and(|t| !t.spaced);
        let listed = comma(at + 2) || at >= 2 && comma(at - 2);
        at >= 1
            && number(at - 1)
            && number(at + 1)
            && close(at)
            && close(at + 1)
            && !listed
            && (self.pieces.is_empty() || super::range::range(trimmed(&self.current)).is_none())
    }

    /// `(8.6)` and `Eq. (8.6)` behind a gap, as a label on what stands before it.
    fn take_label(&mut self, tokens: &[Token<'a>], i: &mut usize) -> bool {
        let open = *i + length_of_name(&tokens[*i..]);
        if tokens.get(open).is_none_or(|t| t.kind != Lexeme::Char('(')) {
            return false;
        }
        let Some(end) = super::bracket_end(tokens, open) else {
            return false;
        };
        let text = super::text::plain(&tokens[open + 1..end]);
        let last = tokens
            .get(end + 1)
            .is_none_or(|t| matches!(t.kind, Lexeme::Row | Lexeme::Char('.' | ',')));
        if !last || !super::text::is_label(&text) || self.current.is_empty() {
            return false;
        }
        let span = tokens[open].span;
        self.current.push(Token {
            kind: Lexeme::Space(18),
            span,
            spaced: false,
        });
        self.current.extend_from_slice(&tokens[open..=end]);
        *i = end + 1;
        true
    }

    /// Lines in braces, as plain TeX has them: `\displaylines{a = b \\ c = d}`.
    fn lines_in_braces(&mut self, tokens: &[Token<'a>], i: usize, level: u32) -> Option<usize> {
        let open = i + 1;
        if tokens.get(open)?.kind != Lexeme::Open {
            return None;
        }
        let mut depth = 0;
        let close = (open..tokens.len()).find(|&at| {
            match tokens[at].kind {
                Lexeme::Open => depth += 1,
                Lexeme::Close => depth -= 1,
                _ => {}
            }
            depth == 0
        })?;
        self.split(&tokens[open + 1..close], "gathered", level + 1);
        Some(close + 1)
    }

    /// An environment of lines, or a bracket around one, is gone into; the index behind it is returned.
    fn structure(&mut self, tokens: &[Token<'a>], i: usize, level: u32) -> Option<usize> {
        if level > 8 {
            return None;
        }
        if matches!(
            tokens[i].kind,
            Lexeme::Command("displaylines" | "eqalign" | "eqalignno")
        ) {
            return self.lines_in_braces(tokens, i, level);
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
        let listed =
            LISTS.contains(&name) || (matches!(name, "array" | "matrix") && holds_relation(inside));
        let valued = matches!(name, "cases" | "dcases" | "rcases" | "array") && is_valued(inside);
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

/// How many tokens the spaces and the `Eq.` before a number take.
fn length_of_name(tokens: &[Token<'_>]) -> usize {
    let name = |token: &&Token<'_>| {
        matches!(
            token.kind,
            Lexeme::Space(_) | Lexeme::Char('.') | Lexeme::Letter('E' | 'e' | 'q' | 'n')
        )
    };
    let length = tokens.iter().take_while(name).count();
    let text = super::text::plain(&tokens[..length]).to_lowercase();
    match text.trim_end_matches('.') {
        "" | "eq" | "eqn" => length,
        _ => 0,
    }
}

/// Whether a first column without relations says that values stand there: `1 & x > 0 \\ 0 & x < 0`.
fn is_valued(inside: &[Token<'_>]) -> bool {
    let rows = super::split_outside(inside, |t| t.kind == Lexeme::Row);
    let mut firsts = rows
        .into_iter()
        .filter(|row| !trimmed(row).is_empty())
        .map(|row| super::split_outside(row, |t| t.kind == Lexeme::Ampersand));
    let alone = |cells: &Vec<&[Token<'_>]>| {
        // In `a &=& b` the relation has a column of its own.
        let first = cells.first().is_some_and(|cell| holds_relation(cell));
        let next = cells.get(1).is_some_and(|cell| {
            relations(trimmed(cell))
                .first()
                .is_some_and(|(at, ..)| *at == 0)
        });
        !first && !next
    };
    firsts.all(|cells| alone(&cells))
}

/// Whether a sign of relation stands in the rows outside inner brackets.
pub(super) fn holds_relation(tokens: &[Token<'_>]) -> bool {
    !relations(tokens).is_empty()
}

/// Pieces that go on from the one before are joined to it.
fn join(pieces: Vec<Piece<'_>>) -> Vec<Piece<'_>> {
    let mut out: Vec<Piece<'_>> = vec![];
    for piece in pieces {
        match out.last_mut() {
            Some(last) if repeats_equals(last, &piece) => {
                let equals = last.tokens.iter().rposition(is_equals);
                last.tokens.truncate(equals.unwrap_or(last.tokens.len()));
                out.push(piece);
            }
            Some(last) if goes_on(last, &piece) => last.tokens.extend(piece.tokens),
            _ => out.push(piece),
        }
    }
    out
}

fn is_equals(token: &Token<'_>) -> bool {
    token.kind == Lexeme::Char('=')
}

/// `a = b = \\ = c`: the sign at the end of a row, and once more at the beginning of the next, is one.
fn repeats_equals(last: &Piece<'_>, piece: &Piece<'_>) -> bool {
    let ends = trimmed(&last.tokens).last().is_some_and(is_equals);
    let begins = without_empty_groups(trimmed(&piece.tokens));
    ends && piece.before == Break::Row && begins.first().is_some_and(is_equals)
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
    // The sign at the end of `[\omega]_\times` is an index.
    let ended = match trimmed(&last.tokens) {
        [.., before, _] if is_script(before.kind) => None,
        tokens => tokens.last().map(|t| t.kind),
    };
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
