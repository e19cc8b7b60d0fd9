//! Letters with everything that hangs on them.

use super::Form;
use crate::notation::ast::{Style, Symbol};

impl Form {
    pub(super) fn symbol(self, symbol: &Symbol) -> String {
        self.marked(symbol, self.letter(symbol), "")
    }

    /// A letter with one dot or two as a combining mark, where Unicode can draw that.
    pub(super) fn dotted(self, symbol: &Symbol, order: u8) -> String {
        let dots = if order == 1 { "\u{307}" } else { "\u{308}" };
        let letter = self.letter(symbol);
        if letter.contains('\\') || symbol.resultant || symbol.variation {
            let command = if order == 1 { "dot" } else { "ddot" };
            return format!("\\{command}{{{}}}", self.symbol(symbol));
        }
        self.marked(symbol, letter, dots)
    }

    fn marked(self, symbol: &Symbol, letter: String, dots: &str) -> String {
        let mut text = letter;
        text.push_str(dots);
        text.push_str(&"'".repeat(usize::from(symbol.primes)));
        if !symbol.subscripts.is_empty() {
            let entries: Vec<String> = symbol.subscripts.iter().map(|s| script(s)).collect();
            text.push_str(&format!("_{{{}}}", entries.join(",")));
        }
        for superscript in &symbol.superscripts {
            text.push_str(&format!("^{{{}}}", raised(superscript)));
        }
        if symbol.variation {
            text = format!("{}{text}", self.pick("\\delta ", "δ "));
        }
        if symbol.resultant {
            text = format!("{}{text}", self.pick("\\sum ", "∑ "));
        }
        text
    }

    /// The letter with its style.
    fn letter(self, symbol: &Symbol) -> String {
        let style = symbol.style;
        let name = self.name(symbol);
        if self == Self::Unicode && drawable(style) && !name.contains('\\') {
            let marks = [
                (style.hat, '\u{302}'),
                (style.tilde, '\u{303}'),
                (style.bar, '\u{304}'),
                (style.vector, '\u{20d7}'),
            ];
            let marks = marks.iter().filter(|(set, _)| *set).map(|(_, mark)| *mark);
            return name.chars().chain(marks).collect();
        }
        let bold = if name.starts_with('\\') {
            "boldsymbol"
        } else {
            "mathbf"
        };
        let wide = symbol.name.chars().count() > 1 && !name.starts_with('\\');
        let commands: &[(bool, &str)] = &[
            (style.calligraphic, "mathcal"),
            (style.other, "check"),
            (style.tilde, "tilde"),
            (style.hat, "hat"),
            (style.bar, "bar"),
            (style.bar && style.tensor, "bar"),
            (style.vector && (style.tensor || wide), "vec"),
            (style.vector && style.tensor, "vec"),
            (style.vector && !style.tensor && !wide, bold),
            (style.tensor && !style.bar && !style.vector, "mathsf"),
        ];
        let mut text = name;
        for (_, command) in commands.iter().filter(|(set, _)| *set) {
            text = format!("\\{command}{{{text}}}");
        }
        text
    }

    fn name(self, symbol: &Symbol) -> String {
        let name = &symbol.name;
        if symbol.style.upright {
            return format!("\\mathrm{{{name}}}");
        }
        if name.chars().count() <= 1 {
            return name.clone();
        }
        match greek(name) {
            Some(c) if self == Self::Unicode => c.to_string(),
            _ if symbol.style.vector && name.bytes().all(|b| b.is_ascii_uppercase()) => {
                name.clone()
            }
            _ => format!("\\{name}"),
        }
    }
}

/// Whether combining marks can draw a style.
fn drawable(style: Style) -> bool {
    !style.tensor && !style.calligraphic && !style.other && !style.upright
}

/// The entry of a subscript; what is more than letters and digits is set as text.
fn script(entry: &str) -> String {
    let mut out = String::new();
    let mut characters = entry.chars().peekable();
    let plain = |c: char| c.is_ascii_alphanumeric() || "+-/'()".contains(c);
    if !entry
        .chars()
        .all(|c| plain(c) || matches!(c, '\u{303}' | '\u{304}'))
    {
        return format!("\\text{{{entry}}}");
    }
    while let Some(c) = characters.next() {
        let over = characters.next_if(|next| !plain(*next));
        match over {
            Some('\u{303}') => out.push_str(&format!("\\tilde{{{c}}}")),
            Some(_) => out.push_str(&format!("\\bar{{{c}}}")),
            None => out.push(c),
        }
    }
    out
}

/// A label above a letter: some need no mark that they are no power.
fn raised(label: &str) -> String {
    let bracketed = label.starts_with('(') && label.ends_with(')');
    let capital = matches!(label.as_bytes(), [b'A'..=b'Z']) && label != "T";
    if bracketed || capital || matches!(label, "*" | "+" | "-") {
        label.to_owned()
    } else {
        format!("\\text{{{label}}}")
    }
}

/// The raised form of a digit.
pub(super) fn superscript(digit: char) -> char {
    match digit {
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        other => other,
    }
}

fn greek(name: &str) -> Option<char> {
    const LOWER: &[(&str, char)] = &[
        ("alpha", 'α'),
        ("beta", 'β'),
        ("gamma", 'γ'),
        ("delta", 'δ'),
        ("epsilon", 'ε'),
        ("zeta", 'ζ'),
        ("eta", 'η'),
        ("theta", 'θ'),
        ("kappa", 'κ'),
        ("lambda", 'λ'),
        ("mu", 'μ'),
        ("nu", 'ν'),
        ("xi", 'ξ'),
        ("pi", 'π'),
        ("rho", 'ρ'),
        ("sigma", 'σ'),
        ("tau", 'τ'),
        ("phi", 'φ'),
        ("chi", 'χ'),
        ("psi", 'ψ'),
        ("omega", 'ω'),
        ("Gamma", 'Γ'),
        ("Delta", 'Δ'),
        ("Theta", 'Θ'),
        ("Lambda", 'Λ'),
        ("Phi", 'Φ'),
        ("Psi", 'Ψ'),
        ("Omega", 'Ω'),
        ("ell", 'ℓ'),
        ("angle", '∠'),
    ];
    LOWER.iter().find(|(n, _)| *n == name).map(|(_, c)| *c)
}
