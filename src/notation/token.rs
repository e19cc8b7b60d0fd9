//! From the characters of a formula to tokens: LaTeX commands, letters, numbers, brackets.
//!
//! Unicode mathematics becomes the tokens of the LaTeX that means the same (`ω̇₁` is `\dot{\omega}_{1}`), so
//! that one parser reads both. Commands that only change how a formula looks produce no token.

use crate::notation::triads::Triads;
use crate::source::Span;

/// A token and its bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Token<'a> {
    pub(crate) kind: Lexeme<'a>,
    pub(crate) span: Span,
    /// Whether white space stands before it.
    pub(crate) spaced: bool,
}

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Lexeme<'a> {
    /// `\name`, the backslash left out.
    Command(&'a str),
    /// A letter that stands for itself.
    Letter(char),
    /// Digits, with a decimal point where one is written.
    Number(&'a str),
    /// `{` and `}` that group.
    Open,
    Close,
    Superscript,
    Subscript,
    Ampersand,
    /// `\\`
    Row,
    /// A written space, in eighteenths of an em roughly: `\,` 3, `\;` 5, `\quad` 18.
    Space(u8),
    /// Brackets, signs, punctuation, as ASCII where there is an ASCII form.
    Char(char),
    /// `\left|`, `\right|`, `\left.`, `\right.`
    LeftBar,
    RightBar,
    LeftNull,
    RightNull,
    /// `\begin{name}` and `\end{name}`, a column description swallowed.
    Begin(&'a str),
    End(&'a str),
    /// What stands in `\text{…}` and its like.
    Text(&'a str),
    /// What stands in `\tag{…}` and in `\label{…}`.
    Tag(&'a str),
    Label(&'a str),
}

/// How letters that touch are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Letters {
    /// LaTeX: each letter is a symbol.
    Single,
    /// Plain text: known words are symbols or functions (`omega_x`, `Ixx`, `wdot`).
    Words(Triads),
}

/// The first bytes of a text, at most so many and no part of a character.
pub(crate) fn beginning(text: &str, most: usize) -> &str {
    let mut end = most.min(text.len());
    while !text.is_char_boundary(end) {
        end -= 1;
    }
    &text[..end]
}

/// The offset of the brace that closes a group whose inside starts the text.
pub(crate) fn matching_brace(inner: &str) -> Option<usize> {
    let mut depth = 0usize;
    let mut escaped = false;
    for (i, b) in inner.bytes().enumerate() {
        match b {
            _ if escaped => escaped = false,
            b'\\' => escaped = true,
            b'{' => depth += 1,
            b'}' if depth == 0 => return Some(i),
            b'}' => depth -= 1,
            _ => {}
        }
    }
    None
}
