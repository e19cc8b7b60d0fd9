//! From the characters of a formula to tokens.

mod argument;
mod command;
mod word;

use crate::notation::parse::groups;
use crate::notation::token::{Letters, Lexeme, Token, beginning};
use crate::notation::unicode;
use crate::source::Span;

/// The tokens of a formula whose first byte stands at `offset` of the source. Where a document parts decimals by a comma,
/// `2,5` is one number.
pub(crate) fn tokens(
    text: &str,
    offset: usize,
    letters: Letters,
    decimal_comma: bool,
) -> Vec<Token<'_>> {
    let mut lexer = Lexer {
        text,
        offset,
        at: 0,
        letters,
        decimal_comma,
        spaced: false,
        sized: None,
        brackets: vec![],
        integral: false,
        out: Vec::with_capacity(text.len() / 2),
    };
    while lexer.step() {}
    without_empty_scripts(lexer.out)
}

/// The tokens without `^{}` and `_{}`, which macros leave where an argument is empty.
fn without_empty_scripts(tokens: Vec<Token<'_>>) -> Vec<Token<'_>> {
    let mut kept: Vec<Token<'_>> = Vec::with_capacity(tokens.len());
    for token in tokens {
        kept.push(token);
        if let [.., script, open, close] = kept.as_slice()
            && matches!(script.kind, Lexeme::Superscript | Lexeme::Subscript)
            && open.kind == Lexeme::Open
            && close.kind == Lexeme::Close
        {
            kept.truncate(kept.len() - 3);
        }
    }
    kept
}

struct Lexer<'a> {
    text: &'a str,
    offset: usize,
    at: usize,
    letters: Letters,
    decimal_comma: bool,
    spaced: bool,
    /// Where the command stands that sizes the bracket to come, which is a part of it: `\left(`.
    sized: Option<usize>,
    /// For each open parenthesis of plain text, whether it stands for braces.
    brackets: Vec<bool>,
    /// Whether an integral was met, under which x is a coordinate.
    integral: bool,
    out: Vec<Token<'a>>,
}

impl<'a> Lexer<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn push(&mut self, kind: Lexeme<'a>, start: usize) {
        let start = self.sized.take().unwrap_or(start);
        let span = Span::new(self.offset + start, self.offset + self.at);
        self.integral |= matches!(kind, Lexeme::Command("int" | "iint" | "iiint"));
        self.out.push(Token {
            kind,
            span,
            spaced: std::mem::take(&mut self.spaced),
        });
    }

    /// Reads one token; `false` at the end of the text.
    fn step(&mut self) -> bool {
        let start = self.at;
        let Some(c) = self.rest().chars().next() else {
            return false;
        };
        self.at += c.len_utf8();
        match c {
            _ if c.is_whitespace() => self.spaced = true,
            '\\' => self.command(start),
            '%' => self.comment(start),
            '{' => self.push(Lexeme::Open, start),
            '}' => self.push(Lexeme::Close, start),
            '^' => {
                self.push(Lexeme::Superscript, start);
                self.raised_bracket();
            }
            '_' => self.subscript(start),
            '&' => self.ampersand(start),
            // Inside a formula only a box has them: `\fbox{$a = b$}`.
            '$' => {}
            '~' if self.letters == Letters::Single => self.push(Lexeme::Space(6), start),
            '0'..='9' | '.' if c != '.' || self.digit_follows() => self.number(start),
            'a'..='z' | 'A'..='Z' => self.letters(c, start),
            '(' | ')' => self.bracket(c, start),
            '!'..='~' if self.letters != Letters::Single && self.spelled_sign(start) => {}
            '!'..='~' => self.push(Lexeme::Char(c), start),
            _ => self.unicode(c, start),
        }
        true
    }

    /// `&`, or the character that web pages write with it: `&lt;`, `&#8211;`.
    fn ampersand(&mut self, start: usize) {
        let written = beginning(self.rest(), 9).split_once(';');
        let entity = written.and_then(|(name, _)| Some((name.len() + 1, unicode::entity(name)?)));
        let Some((length, c)) = entity else {
            return self.push(Lexeme::Ampersand, start);
        };
        self.at += length;
        match c {
            '&' => self.push(Lexeme::Ampersand, start),
            '!'..='~' => self.push(Lexeme::Char(c), start),
            _ if c.is_whitespace() => self.spaced = true,
            _ => self.unicode(c, start),
        }
    }

    fn digit_follows(&self) -> bool {
        self.rest().starts_with(|c: char| c.is_ascii_digit())
            && !matches!(self.out.last().map(|t| t.kind), Some(Lexeme::Letter(_)))
    }

    /// A comment runs to the end of its line; in plain text `%` is a sign.
    fn comment(&mut self, start: usize) {
        if self.letters != Letters::Single {
            return self.push(Lexeme::Char('%'), start);
        }
        self.at += self.rest().find('\n').unwrap_or(self.rest().len());
        self.spaced = true;
    }

    fn number(&mut self, start: usize) {
        if self.fraction_of_digits(start) {
            return;
        }
        let digits = |s: &str| s.bytes().take_while(u8::is_ascii_digit).count();
        self.at += digits(self.rest());
        if !self.text[start..].starts_with('.') && self.rest().starts_with('.') {
            let after = digits(&self.rest()[1..]);
            if after > 0 {
                self.at += 1 + after;
            }
        }
        let scripted = |kind| matches!(kind, Lexeme::Subscript | Lexeme::Superscript);
        let script = match self.out.as_slice() {
            [.., mark, last] if last.kind == Lexeme::Open => scripted(mark.kind),
            [.., last] => scripted(last.kind),
            [] => false,
        };
        let decimals = self.decimals_behind_comma(start);
        if decimals > 0 && !script {
            self.at += 1 + decimals;
        } else if !script {
            self.at += groups(&self.text[start..self.at], beginning(self.rest(), 64));
        }
        self.exponent();
        self.push(Lexeme::Number(&self.text[start..self.at]), start);
        self.unit();
    }

    /// The digits behind a decimal comma; none where the comma parts a list: `(2,5)`, `1,2,3`, `i = 1,2`.
    fn decimals_behind_comma(&self, start: usize) -> usize {
        let digits = |s: &str| s.bytes().take_while(u8::is_ascii_digit).count();
        let Some(behind) = self.rest().strip_prefix(',').filter(|_| self.decimal_comma) else {
            return 0;
        };
        let length = digits(behind);
        let next = &behind[length..];
        let goes_on = next.strip_prefix(',').is_some_and(|s| digits(s) > 0);
        let before = |n: usize| self.out.iter().rev().nth(n).map(|t| t.kind);
        let bracket = matches!(before(0), Some(Lexeme::Char('(' | '[')));
        let alone = bracket && next.trim_start().starts_with([')', ']']);
        let listed = before(0) == Some(Lexeme::Char(',')) && !self.spaced;
        let counts = before(0) == Some(Lexeme::Char('='))
            && matches!(before(1), Some(Lexeme::Letter('i'..='n')))
            && !matches!(before(2), Some(Lexeme::Letter(_) | Lexeme::Close));
        let whole = !self.text[start..self.at].contains('.');
        match whole && !goes_on && !alone && !listed && !counts {
            true => length,
            false => 0,
        }
    }

    /// `\frac12`: a command takes one digit for an argument, as in TeX.
    fn fraction_of_digits(&mut self, start: usize) -> bool {
        let after_fraction = matches!(
            self.out.last().map(|token| token.kind),
            Some(Lexeme::Command(
                "frac" | "tfrac" | "dfrac" | "cfrac" | "sfrac" | "nicefrac" | "flatfrac"
            ))
        );
        let mut digits = self.text[start..].bytes().take(2);
        let two = digits.len() == 2 && digits.all(|b| b.is_ascii_digit());
        if !after_fraction || !two {
            return false;
        }
        for start in [start, start + 1] {
            self.at = start + 1;
            self.push(Lexeme::Number(&self.text[start..self.at]), start);
        }
        true
    }

    /// `1.5e-3`, in plain text only, where `e` is not the number e.
    fn exponent(&mut self) {
        let rest = self.rest().as_bytes();
        if self.letters == Letters::Single || !matches!(rest.first(), Some(b'e' | b'E')) {
            return;
        }
        let sign = usize::from(matches!(rest.get(1), Some(b'+' | b'-')));
        let digits = rest[1 + sign..]
            .iter()
            .take_while(|b| b.is_ascii_digit())
            .count();
        if (1..=4).contains(&digits) {
            self.at += 1 + sign + digits;
        }
    }

    /// A letter with the combining marks that follow it, as accents around it.
    fn letter(&mut self, letter: Lexeme<'a>, start: usize) {
        let marks: Vec<&'static str> = self.rest().chars().map_while(unicode::mark).collect();
        for _ in 0..marks.len() {
            self.at += self.rest().chars().next().map_or(0, char::len_utf8);
        }
        self.accented(letter, &marks, start);
    }

    fn accented(&mut self, letter: Lexeme<'a>, marks: &[&'static str], start: usize) {
        for mark in marks.iter().rev() {
            self.push(Lexeme::Command(mark), start);
            self.push(Lexeme::Open, start);
        }
        self.push(letter, start);
        for _ in marks {
            self.push(Lexeme::Close, start);
        }
    }

    fn unicode(&mut self, c: char, start: usize) {
        if let Some(script) = unicode::script(c) {
            return self.script(script, start);
        }
        if let Some((n, d)) = unicode::vulgar_fraction(c) {
            self.push(Lexeme::Command("frac"), start);
            for digit in [n, d] {
                self.push(Lexeme::Open, start);
                self.push(Lexeme::Number(digit), start);
                self.push(Lexeme::Close, start);
            }
            return;
        }
        if c == '°' {
            for kind in [
                Lexeme::Superscript,
                Lexeme::Open,
                Lexeme::Command("circ"),
                Lexeme::Close,
            ] {
                self.push(kind, start);
            }
            return;
        }
        if c == '″' {
            self.push(Lexeme::Char('\''), start);
            return self.push(Lexeme::Char('\''), start);
        }
        let (base, mut marks) = unicode::decomposed(c);
        let lexeme = unicode::lexeme(base);
        while let Some(mark) = self.rest().chars().next().and_then(unicode::mark) {
            marks.push(mark);
            self.at += self.rest().chars().next().map_or(0, char::len_utf8);
        }
        marks.extend(unicode::alphabet(c));
        match lexeme {
            Some(lexeme) => {
                self.accented(lexeme, &marks, start);
                if base.is_alphabetic() {
                    self.number_of_letter(start);
                }
            }
            None if c.is_alphabetic() => self.accented(Lexeme::Letter(c), &marks, start),
            // Marks of direction and zero-width spaces are invisible, so they must not change a meaning.
            None if unicode::invisible(c) => {}
            None => self.push(Lexeme::Char(c), start),
        }
    }

    /// `_`; in plain text the letters and digits behind it are one subscript, as in `I_xx`.
    fn subscript(&mut self, start: usize) {
        self.push(Lexeme::Subscript, start);
        let alphanumeric = |c: &char| c.is_ascii_alphanumeric();
        let length = self.rest().chars().take_while(alphanumeric).count();
        if self.letters == Letters::Single || length < 2 {
            return;
        }
        let end = self.at + length;
        self.push(Lexeme::Open, self.at);
        while self.at < end {
            let start = self.at;
            self.at += 1;
            let text = &self.text[start..self.at];
            match text.chars().next() {
                Some(c) if c.is_ascii_alphabetic() => self.push(Lexeme::Letter(c), start),
                _ => self.push(Lexeme::Number(text), start),
            }
        }
        self.push(Lexeme::Close, self.at);
    }

    /// In plain text the name of an axis close behind a letter with a dot, or a Greek one: `ḣx`, `ω̇z`.
    fn axis_of_letter(&mut self) -> bool {
        let mut written = self.text[..self.at].chars().rev();
        let own = written.find(|&c| unicode::mark(c).is_none());
        let behind = &self.text[self.at..];
        let label = match self.letters {
            Letters::Words(triads) if own == Some('ω') => {
                let mut label = behind.chars().take(1);
                label.any(|label| triads.labels_rate(label))
            }
            _ => false,
        };
        let axis = label || behind.starts_with(['x', 'y', 'z']);
        // A raised digit is a power of it: `ωx²`.
        let name = |c: char| c.is_alphabetic() || c.is_ascii_digit();
        let ended = !behind[usize::from(axis)..].starts_with(name);
        let marked = !self.text[..self.at].ends_with(|c: char| c.is_ascii());
        let vector = own.is_some_and(|c| "ωΩτhHLMNwTvaFr".contains(unicode::decomposed(c).0));
        if !axis || !ended || !marked || !vector {
            return false;
        }
        let start = self.at;
        self.push(Lexeme::Subscript, start);
        self.at += 1;
        let axis = behind.chars().next().map(Lexeme::Letter);
        axis.into_iter().for_each(|axis| self.push(axis, start));
        true
    }

    /// In plain text digits close behind a letter are its index: `ω1`, `m2`; behind the d of `d2θ/dt2` its order.
    fn number_of_letter(&mut self, start: usize) {
        if self.letters == Letters::Single || self.axis_of_letter() {
            return;
        }
        let length = self.rest().bytes().take_while(u8::is_ascii_digit).count();
        if !(1..=2).contains(&length) {
            return;
        }
        let text = &self.text[..self.at];
        let order = text.ends_with('d') || text.ends_with("dt");
        let mark = if order {
            Lexeme::Superscript
        } else {
            Lexeme::Subscript
        };
        self.push(mark, start);
        let start = self.at;
        self.at += length;
        self.push(Lexeme::Number(&self.text[start..self.at]), start);
    }

    /// A run of raised or lowered characters.
    fn script(&mut self, first: unicode::Script, start: usize) {
        let mark = if first.raised {
            Lexeme::Superscript
        } else {
            Lexeme::Subscript
        };
        self.push(mark, start);
        self.push(Lexeme::Open, start);
        self.push(first.lexeme, start);
        while let Some(next) = self.rest().chars().next() {
            let Some(script) = unicode::script(next).filter(|s| s.raised == first.raised) else {
                break;
            };
            let start = self.at;
            self.at += next.len_utf8();
            match (self.out.last_mut().map(|t| &mut t.kind), script.lexeme) {
                // `x¹²` is the twelfth power and no product.
                (Some(last), Lexeme::Number(digit)) if first.raised => {
                    if let Lexeme::Number(tens) = *last {
                        *last = unicode::two_digits(tens, digit)
                            .map_or(Lexeme::Char('?'), Lexeme::Number);
                    } else {
                        self.push(script.lexeme, start);
                    }
                }
                _ => self.push(script.lexeme, start),
            }
        }
        self.push(Lexeme::Close, start);
    }
}
