//! The words of plain text: `wxdot`, `I_xx`, `omega_x_dot`, `torque`, and the signs that ASCII spells out.

use super::Lexer;
use crate::notation::parse::is_unit;
use crate::notation::plain_words;
use crate::notation::token::{Letters, Lexeme, beginning};

/// No word of a formula is longer, so no more of the text is looked at for each.
const LONGEST_WORD: usize = 64;

/// Functions that may run into their argument: `sinx`.
const FUNCTIONS: &[&str] = &["sin", "cos", "tan", "exp", "sqrt"];

/// Functions that authors write without a backslash.
const WORDS: &[&str] = &[
    "sin", "cos", "tan", "cot", "sec", "csc", "exp", "sqrt", "det", "diag", "arcsin", "arccos",
    "arctan", "asin", "acos", "atan", "sinh", "cosh", "tanh",
];

/// Letters that are mostly angles.
const ANGLES: &str = "alpha beta gamma delta epsilon varepsilon eta theta vartheta lambda mu nu xi sigma phi varphi chi psi omega";

impl<'a> Lexer<'a> {
    /// Letters that touch: in LaTeX a symbol each, in plain text a word where its meaning is known.
    pub(super) fn letters(&mut self, c: char, start: usize) {
        if self.letters != Letters::Single {
            let word = run(&self.text[start..], |b| b.is_ascii_alphanumeric());
            let name = run(&self.text[start..], |b| {
                b.is_ascii_alphanumeric() || b == b'_'
            });
            if self.crosses(word, start) || self.dotted_name(name, start) || self.word(word, start)
            {
                return;
            }
            self.at = start + 1;
        }
        if self.letters == Letters::Single && self.function_word(start) {
            return;
        }
        self.letter(Lexeme::Letter(c), start);
        self.number_of_letter(start);
    }

    /// `cos(\theta)`, `cos\theta` in LaTeX, without the backslash that it should have.
    fn function_word(&mut self, start: usize) -> bool {
        let word = run(&self.text[start..], |b| b.is_ascii_alphabetic());
        let before = self.text[..start].chars().next_back();
        let behind = self.text[start + word.len()..].trim_start();
        let alone = !before.is_some_and(|c| c.is_alphabetic() || c == '\\');
        let angle = behind
            .strip_prefix('\\')
            .map(|name| run(name, |b| b.is_ascii_alphabetic()));
        let called = behind.starts_with(['(', '^', '{'])
            || behind.starts_with("\\left(")
            || angle.is_some_and(|angle| ANGLES.split(' ').any(|one| one == angle));
        let function = WORDS.iter().find(|function| **function == word);
        let Some(function) = function.filter(|_| alone && called) else {
            return false;
        };
        self.at = start + word.len();
        self.push(Lexeme::Command(function), start);
        true
    }

    /// A word whose meaning is known; its tokens are those of the same thing in LaTeX.
    fn word(&mut self, word: &'a str, start: usize) -> bool {
        self.at = start + word.len();
        if plain_words::is_call(word) && self.rest().starts_with('(') {
            let name = match word {
                "cross" => "crossof",
                "dot" => "dotof",
                "inv" => "inverseof",
                "transpose" => "transposeof",
                _ => word,
            };
            self.push(Lexeme::Command(name), start);
            return true;
        }
        if word == "integral"
            && let Some(behind) = self.rest().trim_start().strip_prefix("of ")
        {
            self.at = self.text.len() - behind.len();
            self.push(Lexeme::Command("int"), start);
            return true;
        }
        let component = match self.letters {
            Letters::Words(triads) => triads.word(word),
            Letters::Single => None,
        };
        if let Some(spelling) = plain_words::word(word).or(component) {
            self.spelled(&spelling, start);
            return true;
        }
        // `sinx` and `Iomega` are two words each.
        let function = FUNCTIONS.iter().find(|f| {
            let rest = word.strip_prefix(**f).unwrap_or("");
            rest.len() == 1 || plain_words::is_greek(rest)
        });
        if let Some(function) = function {
            self.at = start + function.len();
            self.push(Lexeme::Command(function), start);
            return true;
        }
        if word.get(1..).is_some_and(plain_words::is_greek) {
            return false;
        }
        let vowel = word.contains(['a', 'e', 'i', 'o', 'u']);
        let named = word.len() >= 4 && vowel && word.bytes().all(|b| b.is_ascii_alphabetic());
        if named {
            self.push(Lexeme::Text(word), start);
        }
        named
    }

    fn spelled(&mut self, spelling: &plain_words::Spelling<'a>, start: usize) {
        if spelling.dots > 0 {
            let dot = if spelling.dots == 1 { "dot" } else { "ddot" };
            self.push(Lexeme::Command(dot), start);
            self.push(Lexeme::Open, start);
        }
        self.push(spelling.base, start);
        if !spelling.subscript.is_empty() {
            self.push(Lexeme::Subscript, start);
            self.push(Lexeme::Open, start);
            for c in spelling.subscript.chars() {
                self.push(Lexeme::Letter(c), start);
            }
            self.push(Lexeme::Close, start);
        }
        if spelling.dots > 0 {
            self.push(Lexeme::Close, start);
        }
    }

    /// `w_x_dot`, `omega_dot_x`, `dot_L`: a name with the word dot in it.
    fn dotted_name(&mut self, name: &'a str, start: usize) -> bool {
        let dot = |part: &str| matches!(part, "dot" | "ddot");
        let parts: Vec<&'a str> = name.split('_').filter(|part| !part.is_empty()).collect();
        let Some(found) = parts.iter().position(|part| dot(part)) else {
            return false;
        };
        let mut rest = parts.iter().filter(|part| !dot(part));
        let Some(base) = rest.next() else {
            return false;
        };
        let end = start + name.len();
        self.at = end;
        let command = if parts[found] == "dot" { "dot" } else { "ddot" };
        self.push(Lexeme::Command(command), start);
        self.push(Lexeme::Open, start);
        if !self.word(base, start) {
            for c in base.chars() {
                self.push(Lexeme::Letter(c), start);
            }
        }
        for part in rest {
            self.push(Lexeme::Subscript, start);
            self.push(Lexeme::Open, start);
            for c in part.chars() {
                self.push(Lexeme::Letter(c), start);
            }
            self.push(Lexeme::Close, start);
        }
        self.at = end;
        self.push(Lexeme::Close, start);
        true
    }

    /// The x of `w x L`: alone between two operands. Under an integral, or beside another coordinate, it is one.
    fn crosses(&mut self, word: &str, start: usize) -> bool {
        let behind = &self.text[start + word.len()..];
        if word != "x" || !self.spaced || !behind.starts_with([' ', '\t']) {
            return false;
        }
        let next = beginning(behind, LONGEST_WORD).trim_start();
        let operand = next.starts_with(|c: char| c.is_alphanumeric() || matches!(c, '(' | '['));
        let following = run(next, |b| b.is_ascii_alphanumeric());
        let coordinate = matches!(following, "x" | "y" | "z" | "dm" | "dt" | "d");
        let ended = matches!(
            self.out.last().map(|t| t.kind),
            Some(Lexeme::Letter(_) | Lexeme::Close | Lexeme::Text(_) | Lexeme::Char(')' | ']'))
        ) || matches!(self.out.last().map(|t| t.kind), Some(Lexeme::Command(name)) if plain_words::is_greek(name));
        if !operand || coordinate || !ended || self.integral {
            return false;
        }
        self.at = start + 1;
        self.push(Lexeme::Command("times"), start);
        true
    }

    /// Signs that plain text spells with two characters.
    pub(super) fn spelled_sign(&mut self, start: usize) -> bool {
        let rest = &self.text[start..];
        let arrows = ["<=>", "==>", "=>", "-->", "->"];
        let found = arrows.iter().find(|arrow| rest.starts_with(**arrow));
        let (kind, length) = match found {
            Some(arrow) if arrow.contains('-') => (Lexeme::Command("to"), arrow.len()),
            Some(arrow) => (Lexeme::Command("Rightarrow"), arrow.len()),
            None if rest.starts_with("**") => (Lexeme::Superscript, 2),
            None if rest.starts_with("~=") => (Lexeme::Command("approx"), 2),
            None if rest.starts_with("||") => (Lexeme::Char('‖'), 2),
            None if rest.starts_with('@') => (Lexeme::Char('*'), 1),
            None if self.dots_product(rest) => (Lexeme::Command("cdot"), 1),
            None => return false,
        };
        self.at = start + length;
        self.push(kind, start);
        if kind == Lexeme::Superscript {
            self.raised_bracket();
        }
        true
    }

    /// The point of `w.L`, close to both letters, or of `w . (I w)`, with space on both sides.
    fn dots_product(&self, rest: &str) -> bool {
        let letters = self.out.last().is_some_and(|t| {
            matches!(
                t.kind,
                Lexeme::Letter(_) | Lexeme::Command(_) | Lexeme::Close
            ) || self.spaced && matches!(t.kind, Lexeme::Char(')' | ']') | Lexeme::Number(_))
        });
        let Some(behind) = rest.strip_prefix('.').filter(|_| letters) else {
            return false;
        };
        let next = beginning(behind, LONGEST_WORD).trim_start();
        let operand = |c: char| c.is_alphabetic() || self.spaced && matches!(c, '(' | '[');
        behind.starts_with([' ', '\t']) == self.spaced && next.starts_with(operand)
    }

    /// `^(2n)` raises what stands in the bracket, `^-1` the number with its sign.
    pub(super) fn raised_bracket(&mut self) {
        let digits = self.rest().strip_prefix('-').map_or(0, |rest| {
            rest.bytes().take_while(u8::is_ascii_digit).take(8).count()
        });
        if self.letters != Letters::Single && digits > 0 {
            let start = self.at;
            self.push(Lexeme::Open, start);
            self.at += 1;
            self.push(Lexeme::Char('-'), start);
            self.at += digits;
            self.push(Lexeme::Number(&self.text[start + 1..self.at]), start + 1);
            self.push(Lexeme::Close, self.at);
            return;
        }
        if self.letters != Letters::Single && self.rest().starts_with('(') {
            let start = self.at;
            self.at += 1;
            self.push(Lexeme::Open, start);
            self.brackets.push(true);
        }
    }

    /// A bracket, which groups like braces where it was raised.
    pub(super) fn bracket(&mut self, c: char, start: usize) {
        let raised = match c {
            '(' => {
                self.brackets.push(false);
                false
            }
            _ => self.brackets.pop().unwrap_or(false),
        };
        self.push(
            if raised {
                Lexeme::Close
            } else {
                Lexeme::Char(c)
            },
            start,
        );
    }

    /// A unit of measurement behind a number: `kg m^2`, `rad/s`, as far as nothing but units follows.
    pub(super) fn unit(&mut self) {
        if self.letters == Letters::Single {
            return;
        }
        let rest = beginning(self.rest(), LONGEST_WORD);
        let lead = rest.len() - rest.trim_start_matches(' ').len();
        let inner = &rest[lead..];
        let end = inner
            .find(|c: char| {
                !(c.is_alphanumeric() || matches!(c, ' ' | '/' | '^' | '-' | '*' | '·' | '²' | '³'))
            })
            .unwrap_or(inner.len());
        let text = inner[..end].trim_end();
        let sure = [
            "kg", "rad", "Nm", "N m", "N*m", "N·m", "deg", "rpm", "Hz", "m/s",
        ];
        let alone = || self.is_value_with_unit(text, &inner[end..]);
        if is_unit(text) && (sure.iter().any(|unit| text.starts_with(unit)) || alone()) {
            let start = self.at + lead;
            self.at = start + text.len();
            self.push(Lexeme::Text(&inner[..text.len()]), start);
        }
    }
}

impl Lexer<'_> {
    /// Whether a number and a unit of length, time, force or energy are all that stands on the right of a sign:
    /// `R = 0.25 m`. `M = 2 m` is twice a mass.
    fn is_value_with_unit(&self, unit: &str, behind: &str) -> bool {
        let units = ["m", "s", "N", "J", "W", "mm", "cm", "km"];
        let ends = !behind
            .starts_with(|c: char| !c.is_whitespace() && !matches!(c, '.' | ',' | ';' | ')'));
        let before = self.text[..self.at].rsplit(['\n', ',', ';']).next();
        let before = before.unwrap_or_default();
        let Some((left, number)) = before.rsplit_once(['=', '≈', '≃']) else {
            return false;
        };
        let digits = |c: char| c.is_ascii_digit() || matches!(c, '.' | ' ' | '-' | '−');
        let mass = left.trim().ends_with(['m', 'M']) || left.trim().contains('m');
        let whole = !number.contains('.');
        units.contains(&unit)
            && ends
            && number.chars().all(digits)
            && !(unit == "m" && whole && mass)
    }
}

/// The bytes at the start of a text that are of a kind.
fn run(text: &str, kind: impl Fn(u8) -> bool) -> &str {
    let bytes = text.bytes().take(LONGEST_WORD);
    &text[..bytes.take_while(|b| kind(*b)).count()]
}

/// The word of a command of the package physics that sets it between formulas.
pub(super) fn word_between(name: &str) -> Option<&str> {
    const WORDS: [&str; 19] = [
        "if",
        "then",
        "else",
        "otherwise",
        "unless",
        "given",
        "using",
        "assume",
        "since",
        "let",
        "for",
        "all",
        "even",
        "odd",
        "integer",
        "and",
        "or",
        "as",
        "in",
    ];
    name.strip_prefix('q').filter(|word| WORDS.contains(word))
}
