//! Commands: which of them are tokens, which say nothing, which take a text.

use super::Lexer;
use super::word::word_between;
use crate::notation::token::{Lexeme, Token, beginning};

/// Whether a command gives the bracket behind it its size.
fn is_size(name: &str) -> bool {
    let size = name.trim_end_matches(['l', 'r', 'm']);
    matches!(size, "big" | "Big" | "bigg" | "Bigg")
}

/// Whether a command only changes the look.
fn is_silent(name: &str) -> bool {
    matches!(
        name,
        "displaystyle"
            | "textstyle"
            | "scriptstyle"
            | "limits"
            | "nolimits"
            | "nonumber"
            | "notag"
            | "middle"
            | "!"
            | "mathstrut"
            | "strut"
            | "noindent"
            | "centering"
            | "allowbreak"
            | "nobreak"
            | "null"
            | "mathord"
            | "mathbin"
            | "mathrel"
            | "mathop"
            | "mathopen"
            | "mathclose"
            | "mathpunct"
            | "mathinner"
            | "ensuremath"
            | "boxed"
            | "Aboxed"
            | "fbox"
            | "small"
            | "large"
            | "Large"
            | "normalsize"
            | "relax"
            | "protect"
            | "unboldmath"
            | "cancel"
            | "left@"
            | "hline"
            | "par"
            | "bcancel"
            | "xcancel"
            | "sout"
            | "displaylimits"
            | "framebox"
            | "underbracket"
            | "vcenter"
            | "mathllap"
            | "mathrlap"
            | "mathclap"
            | "llap"
            | "rlap"
            | "clap"
            | "eval"
            | "IEEEyesnumber"
            | "IEEEnonumber"
            | "IEEEyessubnumber"
            | "IEEEeqnarraynumspace"
    )
}

/// Whether the one argument of a command says nothing.
fn says_nothing(name: &str) -> bool {
    matches!(
        name,
        "phantom"
            | "hphantom"
            | "vphantom"
            | "vspace"
            | "color"
            | "cite"
            | "footnote"
            | "footnotemark"
            | "textcircled"
            | "intertext@"
            | "eqref"
            | "ref"
            | "autoref"
            | "cref"
            | "Cref"
            | "require"
            | "htmlClass"
            | "htmlId"
            | "htmlStyle"
            | "htmlData"
            | "cssId"
            | "class"
            | "href"
            | "enclose"
            | "mspace"
    )
}

fn is_script(token: &Token<'_>) -> bool {
    matches!(token.kind, Lexeme::Subscript | Lexeme::Superscript)
}

/// Whether the argument of a command is a text.
fn is_text(name: &str) -> bool {
    matches!(
        name,
        "text"
            | "mbox"
            | "textrm"
            | "textit"
            | "textbf"
            | "hbox"
            | "intertext"
            | "shortintertext"
            | "textnormal"
            | "textsf"
            | "textup"
            | "qq"
    )
}

impl<'a> Lexer<'a> {
    pub(super) fn command(&mut self, start: usize) {
        let length = self
            .rest()
            .bytes()
            .take_while(u8::is_ascii_alphabetic)
            .count();
        let length = if length > 0 {
            length
        } else {
            self.rest().chars().next().map_or(0, char::len_utf8)
        };
        let name = &self.rest()[..length];
        self.at += length;
        match name {
            "underline" if self.holds_relation() => {}
            // A reference mark, and no label.
            "#" if self.out.last().is_some_and(is_script) => {
                self.out.pop();
            }
            "\\" | "cr" | "newline" | "tabularnewline" => self.row(start),
            "," | "thinspace" => self.push(Lexeme::Space(3), start),
            ":" | ">" | "medspace" => self.push(Lexeme::Space(4), start),
            ";" | "thickspace" => self.push(Lexeme::Space(5), start),
            " " | "\n" | "enspace" | "space" | "nobreakspace" => self.push(Lexeme::Space(6), start),
            "quad" => self.push(Lexeme::Space(18), start),
            "qquad" => self.push(Lexeme::Space(36), start),
            "hspace" => self.hspace(start),
            "hfill" | "hfil" => self.push(Lexeme::Space(18), start),
            "hskip" => {
                self.dimension();
                self.push(Lexeme::Space(18), start);
            }
            "kern" | "mkern" | "mskip" | "vskip" => self.dimension(),
            "smash" | "bbox" => self.option(),
            // Of the package physics, where no brace follows: a bracket that grows.
            "qty" | "quantity" if !self.rest().trim_start().starts_with('{') => {}
            "cp" | "crossproduct" => self.push(Lexeme::Command("cross"), start),
            "dotproduct" => self.push(Lexeme::Command("vdot"), start),
            "langle" => self.push(Lexeme::Char('⟨'), start),
            "rangle" => self.push(Lexeme::Char('⟩'), start),
            "lfloor" => self.push(Lexeme::Char('⌊'), start),
            "rfloor" => self.push(Lexeme::Char('⌋'), start),
            "eqno" | "leqno" => self.equation_number(start),
            "{" | "lbrace" => self.push(Lexeme::Char('{'), start),
            "}" | "rbrace" => self.push(Lexeme::Char('}'), start),
            "lbrack" => self.push(Lexeme::Char('['), start),
            "rbrack" => self.push(Lexeme::Char(']'), start),
            "lvert" => self.push(Lexeme::LeftBar, start),
            "rvert" => self.push(Lexeme::RightBar, start),
            "vert" | "mid" => self.push(Lexeme::Char('|'), start),
            "|" | "Vert" | "lVert" | "rVert" => self.push(Lexeme::Char('‖'), start),
            // Exported Markdown escapes what it need not.
            "_" => self.push(Lexeme::Subscript, start),
            "#" | "$" | "%" | "&" | "*" => {
                self.push(Lexeme::Char(name.chars().next().unwrap_or(' ')), start)
            }
            "newcommand"
            | "renewcommand"
            | "providecommand"
            | "DeclareMathOperator"
            | "def"
            | "gdef"
            | "let" => self.definition(name),
            "left" | "right" => self.delimiter(name == "left", start),
            "begin" | "end" => self.environment(name == "begin", start),
            "tag" | "label" => self.tag(name == "tag", start),
            "textcolor" | "colorbox" | "cancelto" => {
                let _ = self.braced();
            }
            // Without a brace the font is that of the letter behind it.
            "textbf" | "textit" if !self.rest().trim_start().starts_with('{') => {
                let font = if name == "textbf" { "mathbf" } else { "mathit" };
                self.push(Lexeme::Command(font), start);
            }
            _ if is_text(name) => {
                let text = unwrapped(self.braced());
                match index_behind(text).filter(|_| self.rest().trim_start().starts_with('=')) {
                    Some((words, index)) => {
                        self.push(Lexeme::Text(words), start);
                        self.push(Lexeme::Letter(index), start);
                    }
                    None => self.push(Lexeme::Text(text), start),
                }
            }
            "qc" | "qcomma" => self.push(Lexeme::Char(','), start),
            _ if is_size(name) => self.sized = Some(start),
            _ if is_silent(name) => {}
            _ if says_nothing(name) => {
                self.starred();
                let _ = self.braced();
            }
            _ => self.push(
                word_between(name).map_or(Lexeme::Command(name), Lexeme::Text),
                start,
            ),
        }
    }

    /// A definition states nothing; what it defines is known already.
    fn definition(&mut self, name: &str) {
        self.starred();
        let rest = beginning(self.rest(), 80);
        let brace = rest.find('{').unwrap_or(rest.len());
        if name == "let" {
            let names = rest.trim_start_matches(['\\', ' ', '=']);
            self.at += rest.len() - names.len();
            let letters = |c: char| c.is_ascii_alphabetic() || matches!(c, '\\' | '=');
            self.at += names.len() - names.trim_start_matches(letters).len();
            return;
        }
        let named = rest[..brace].contains('\\');
        if named {
            self.at += brace;
        } else {
            let _ = self.braced();
        }
        let rest = beginning(self.rest(), 80);
        let brace = rest.find('{').unwrap_or(rest.len());
        let options = rest[..brace].trim();
        if options.is_empty() || options.starts_with('[') {
            self.at += brace;
        }
        let _ = self.braced();
    }

    /// TeX's own `\eqno(3)`.
    fn equation_number(&mut self, start: usize) {
        let braced = self.braced();
        if !braced.is_empty() {
            return self.push(Lexeme::Tag(braced.trim()), start);
        }
        let rest = self.rest().trim_start();
        let Some(inner) = rest.strip_prefix('(') else {
            return;
        };
        let length = beginning(inner, 40).find(')').unwrap_or(0);
        self.at = self.text.len() - inner.len() + (length + 1).min(inner.len());
        self.push(Lexeme::Tag(&inner[..length]), start);
    }

    /// `\\`, `\\*`, `\\[4pt]`.
    fn row(&mut self, start: usize) {
        self.starred();
        let rest = self.rest().trim_start_matches([' ', '\t']);
        if let Some(inner) = rest.strip_prefix('[')
            && let Some(length) = beginning(inner, 20).find(']')
            && inner[..length]
                .trim_start_matches(['-', ' '])
                .starts_with(|c: char| c.is_ascii_digit() || c == '.')
            && inner[..length].ends_with(|c: char| c.is_ascii_alphabetic())
        {
            self.at = self.text.len() - inner.len() + length + 1;
        }
        self.push(Lexeme::Row, start);
    }

    fn delimiter(&mut self, left: bool, start: usize) {
        let rest = self.rest().trim_start();
        let mut skip = self.rest().len() - rest.len();
        let kind = match rest.as_bytes() {
            [b'|', ..] | [b'\\', b'|', ..] if rest.starts_with('|') => {
                skip += 1;
                if left {
                    Lexeme::LeftBar
                } else {
                    Lexeme::RightBar
                }
            }
            [b'.', ..] => {
                skip += 1;
                if left {
                    Lexeme::LeftNull
                } else {
                    Lexeme::RightNull
                }
            }
            _ if rest.starts_with("\\vert")
                || rest.starts_with("\\lvert")
                || rest.starts_with("\\rvert") =>
            {
                skip += if rest.starts_with("\\vert") { 5 } else { 6 };
                if left {
                    Lexeme::LeftBar
                } else {
                    Lexeme::RightBar
                }
            }
            // Any other bracket is read as itself.
            _ => {
                self.sized = Some(start);
                return;
            }
        };
        self.at += skip;
        self.push(kind, start);
    }

    fn environment(&mut self, begin: bool, start: usize) {
        let name = self.braced().trim_end_matches('*');
        if begin
            && matches!(
                name,
                "array"
                    | "alignat"
                    | "alignedat"
                    | "xalignat"
                    | "IEEEeqnarray"
                    | "tabular"
                    | "subarray"
                    | "numcases"
                    | "subnumcases"
                    | "empheq"
            )
        {
            let rest = self.rest().trim_start();
            if rest.starts_with('[')
                && let Some(close) = beginning(rest, 40).find(']')
            {
                self.at = self.text.len() - rest.len() + close + 1;
            }
            let _ = self.braced();
        }
        if begin && self.rest().starts_with("[t]")
            || self.rest().starts_with("[c]")
            || self.rest().starts_with("[b]")
        {
            self.at += 3;
        }
        self.push(
            if begin {
                Lexeme::Begin(name)
            } else {
                Lexeme::End(name)
            },
            start,
        );
    }

    fn tag(&mut self, tag: bool, start: usize) {
        self.starred();
        let text = self.braced().trim();
        self.push(
            if tag {
                Lexeme::Tag(text)
            } else {
                Lexeme::Label(text)
            },
            start,
        );
    }
}

/// Words in upright letters may be wrapped more than once: `\text{\text{hub}}`.
fn unwrapped(mut text: &str) -> &str {
    while let Some((name, inner)) = text
        .trim()
        .strip_prefix('\\')
        .and_then(|rest| rest.split_once('{'))
        && is_text(name)
        && let Some(inner) = inner.strip_suffix('}')
        && !inner.contains(['{', '}'])
    {
        text = inner;
    }
    text
}

/// The words and the index of `for i`, before the values of the index.
fn index_behind(text: &str) -> Option<(&str, char)> {
    let (words, index) = text.trim_end().rsplit_once(' ')?;
    let words = words.trim();
    let mut letters = index.chars();
    let index = letters.next().filter(|letter| "ijkn".contains(*letter))?;
    if letters.next().is_some() {
        return None;
    }
    matches!(words, "for" | "for all" | "for each" | "with" | "where").then_some((words, index))
}
