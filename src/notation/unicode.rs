//! What the characters of Unicode mathematics are in LaTeX.

use crate::notation::token::Lexeme;
use unicode_normalization::char::decompose_canonical;

/// A raised or lowered character.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Script {
    pub(crate) raised: bool,
    pub(crate) lexeme: Lexeme<'static>,
}

const DIGITS: [&str; 10] = ["0", "1", "2", "3", "4", "5", "6", "7", "8", "9"];

/// `₁`, `ₓ`, `²`, `ᵀ`.
pub(crate) fn script(c: char) -> Option<Script> {
    let lowered = |lexeme| {
        Some(Script {
            raised: false,
            lexeme,
        })
    };
    let raised = |lexeme| {
        Some(Script {
            raised: true,
            lexeme,
        })
    };
    let digit = |d: u32| Lexeme::Number(DIGITS[d as usize % 10]);
    match c {
        '₀'..='₉' => lowered(digit(c as u32 - '₀' as u32)),
        '⁴'..='⁹' => raised(digit(c as u32 - '⁰' as u32)),
        '⁰' => raised(digit(0)),
        '¹' => raised(digit(1)),
        '²' => raised(digit(2)),
        '³' => raised(digit(3)),
        '⁻' => raised(Lexeme::Char('-')),
        '⁺' => raised(Lexeme::Char('+')),
        '₊' => lowered(Lexeme::Char('+')),
        '₋' => lowered(Lexeme::Char('-')),
        'ᵀ' => raised(Lexeme::Letter('T')),
        'ᵗ' => raised(Lexeme::Letter('t')),
        'ˣ' => raised(Lexeme::Command("times")),
        'ⁿ' => raised(Lexeme::Letter('n')),
        'ᵢ' => lowered(Lexeme::Letter('i')),
        'ⱼ' => lowered(Lexeme::Letter('j')),
        'ₓ' => lowered(Lexeme::Letter('x')),
        'ᵧ' => lowered(Lexeme::Letter('y')),
        'ₐ' => lowered(Lexeme::Letter('a')),
        'ₑ' => lowered(Lexeme::Letter('e')),
        'ₒ' => lowered(Lexeme::Letter('o')),
        'ₖ' => lowered(Lexeme::Letter('k')),
        'ₘ' => lowered(Lexeme::Letter('m')),
        'ₙ' => lowered(Lexeme::Letter('n')),
        'ₚ' => lowered(Lexeme::Letter('p')),
        'ₛ' => lowered(Lexeme::Letter('s')),
        'ₜ' => lowered(Lexeme::Letter('t')),
        _ => None,
    }
}

/// Two digits as one number.
pub(crate) fn two_digits(tens: &str, ones: &str) -> Option<&'static str> {
    const NUMBERS: &str = "10111213141516171819202122232425262728293031323334353637383940\
                           41424344454647484950515253545556575859606162636465666768697071\
                           727374757677787980818283848586878889909192939495969798990001020304050607080\
                           9";
    let number: usize = format!("{tens}{ones}").parse().ok()?;
    let at = match (tens.len(), number) {
        (1, 10..) => number - 10,
        (1, _) => number + 90,
        _ => return None,
    };
    NUMBERS.get(2 * at..2 * at + 2)
}

/// `½` as numerator and denominator.
pub(crate) fn vulgar_fraction(c: char) -> Option<(&'static str, &'static str)> {
    Some(match c {
        '½' => ("1", "2"),
        '⅓' => ("1", "3"),
        '⅔' => ("2", "3"),
        '¼' => ("1", "4"),
        '¾' => ("3", "4"),
        '⅕' => ("1", "5"),
        '⅙' => ("1", "6"),
        '⅛' => ("1", "8"),
        _ => return None,
    })
}

/// The sign that web pages name so: `lt`, `minus`, `#8211`. Letters and digits stand for themselves there.
pub(crate) fn entity(name: &str) -> Option<char> {
    let number = match name.strip_prefix('#') {
        Some(code) => match code.strip_prefix(['x', 'X']) {
            Some(code) => u32::from_str_radix(code, 16).ok(),
            None => code.parse().ok(),
        },
        None => None,
    };
    let named = match name {
        "lt" => '<',
        "gt" => '>',
        "le" => '≤',
        "ge" => '≥',
        "ne" => '≠',
        "amp" => '&',
        "minus" | "ndash" => '−',
        "nbsp" | "thinsp" => ' ',
        "times" => '×',
        "middot" | "sdot" => '·',
        _ => char::from_u32(number?)?,
    };
    let other =
        named.is_control() || named.is_ascii_alphanumeric() || matches!(named, '\\' | '{' | '}');
    (!other).then_some(named)
}

/// The accent that a combining mark draws.
pub(crate) fn mark(c: char) -> Option<&'static str> {
    Some(match c {
        '\u{307}' => "dot",
        '\u{308}' => "ddot",
        '\u{30a}' => "mathring",
        '\u{302}' => "hat",
        '\u{303}' => "tilde",
        '\u{304}' | '\u{305}' => "bar",
        '\u{20d7}' => "vec",
        '\u{332}' => "underline",
        _ => return None,
    })
}

/// A letter and the accents in it: `ẋ` is x with a dot.
pub(crate) fn decomposed(c: char) -> (char, Vec<&'static str>) {
    let mut base = c;
    let mut marks = vec![];
    let mut foreign = false;
    decompose_canonical(c, |part| match mark(part) {
        Some(mark) => marks.push(mark),
        None if part as u32 >= 0x300 && (part as u32) < 0x370 => foreign = true,
        None => base = part,
    });
    if foreign { (c, vec![]) } else { (base, marks) }
}

/// Characters that nobody sees and that change nothing.
pub(crate) fn invisible(c: char) -> bool {
    matches!(c, '\u{200b}'..='\u{200f}' | '\u{2060}'..='\u{2065}' | '\u{feff}' | '\u{ad}')
}

/// Characters that make a text look other than it is: they turn the direction of writing, or end it for some programs.
pub(crate) fn deceptive(c: char) -> bool {
    matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\0')
}

/// The byte with which every such mark but NUL begins.
pub(crate) const FIRST_BYTE_OF_A_MARK: u8 = 0xe2;

/// A stop or a bracket of Chinese and Japanese as that of ASCII.
pub(crate) fn plain_stop(c: char) -> Option<char> {
    Some(match c {
        '，' | '、' => ',',
        '。' => '.',
        '：' => ':',
        '；' => ';',
        '（' => '(',
        '）' => ')',
        _ => return None,
    })
}

/// Whether a character is a whole word of Chinese or Japanese, or a part of one.
pub(crate) fn is_ideograph(c: char) -> bool {
    matches!(c, '\u{3040}'..='\u{30ff}' | '\u{3400}'..='\u{4dbf}' | '\u{4e00}'..='\u{9fff}')
}

/// What a character outside ASCII is in LaTeX.
pub(crate) fn lexeme(c: char) -> Option<Lexeme<'static>> {
    use Lexeme::{Char, Command, Letter};
    Some(match c {
        'ı' => Letter('i'),
        'a'..='z' | 'A'..='Z' => Letter(c),
        'α'..='ω' | 'Α'..='Ω' | 'ϕ' | 'ϑ' | 'ϵ' | 'ϖ' | 'ϱ' => Command(greek(c)?),
        '\u{2126}' => Command("Omega"),
        '×' | '✕' | '⨯' | '⨉' => Command("times"),
        '·' | '⋅' | '∙' | '•' => Command("cdot"),
        '−' | '–' => Char('-'),
        '∗' => Char('*'),
        '∕' | '⁄' | '÷' => Char('/'),
        '′' => Char('\''),
        '√' => Command("sqrt"),
        '∛' => Command("cbrt"),
        '⊥' => Command("perp"),
        '∥' => Command("parallel"),
        'ⅆ' => Letter('d'),
        'ⅇ' => Letter('e'),
        'ℎ' => Letter('h'),
        '∫' => Command("int"),
        '∭' => Command("iiint"),
        '∑' => Command("sum"),
        '∂' => Command("partial"),
        '∠' => Command("angle"),
        '∇' => Command("nabla"),
        '≡' => Command("equiv"),
        '≈' => Command("approx"),
        '≃' => Command("simeq"),
        '≠' => Command("ne"),
        '≤' => Command("le"),
        '≥' => Command("ge"),
        '≪' | '≫' => Command("ll"),
        '≔' => Command("coloneqq"),
        '∝' => Command("propto"),
        '→' => Command("to"),
        '⇒' | '⟹' => Command("Rightarrow"),
        '⇔' => Command("iff"),
        '∴' => Command("therefore"),
        '⊗' => Command("otimes"),
        '∘' => Command("circ"),
        '∧' => Command("wedge"),
        '∨' => Command("vee"),
        '±' => Command("pm"),
        '∓' => Command("mp"),
        '…' | '⋯' => Command("dots"),
        '⊤' | '⟙' => Command("top"),
        '⟨' => Char('⟨'),
        '⟩' => Char('⟩'),
        'ℓ' => Command("ell"),
        '‖' => Char('‖'),
        '“' | '”' => Char('"'),
        _ => return plain_stop(c).map(Char).or_else(|| mathematical(c)),
    })
}

/// The command of a Greek letter; none where a Latin one is drawn alike, for which LaTeX has no command.
fn greek(c: char) -> Option<&'static str> {
    const LOWER: [&str; 25] = [
        "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa",
        "lambda", "mu", "nu", "xi", "", "pi", "rho", "sigma", "sigma", "tau", "upsilon", "phi",
        "chi", "psi", "omega",
    ];
    const UPPER: [&str; 25] = [
        "", "", "Gamma", "Delta", "", "", "", "Theta", "", "", "Lambda", "", "", "Xi", "", "Pi",
        "", "", "Sigma", "", "Upsilon", "Phi", "", "Psi", "Omega",
    ];
    let name = match c {
        'α'..='ω' => LOWER.get(c as usize - 'α' as usize).copied(),
        'Α'..='Ω' => UPPER.get(c as usize - 'Α' as usize).copied(),
        'ϕ' => Some("phi"),
        'ϑ' => Some("theta"),
        'ϵ' => Some("epsilon"),
        'ϖ' => Some("pi"),
        'ϱ' => Some("rho"),
        _ => None,
    };
    name.filter(|name| !name.is_empty())
}

/// The command that an alphabet of mathematics stands for: 𝐋 is a bold letter, ℒ a calligraphic one.
pub(crate) fn alphabet(c: char) -> Option<&'static str> {
    Some(match c {
        'ℬ' | 'ℰ' | 'ℱ' | 'ℋ' | 'ℐ' | 'ℒ' | 'ℳ' | 'ℛ' | '𝒜'..='𝔷' => {
            "mathcal"
        }
        'ℂ' | 'ℍ' | 'ℕ' | 'ℙ' | 'ℚ' | 'ℝ' | 'ℤ' | '𝔸'..='𝕫' => "mathbb",
        '𝐀'..='𝐳' | '𝑨'..='𝒛' | '𝚨'..='𝛡' | '𝜜'..='𝝕' => "mathbf",
        '𝖠'..='𝗓' => "mathsf",
        _ => return None,
    })
}

/// Letters of mathematics that stand outside the run of their alphabet.
fn letterlike(c: char) -> Option<char> {
    Some(match c {
        'ℬ' => 'B',
        'ℂ' => 'C',
        'ℰ' => 'E',
        'ℱ' => 'F',
        'ℋ' | 'ℍ' => 'H',
        'ℐ' => 'I',
        'ℒ' => 'L',
        'ℳ' => 'M',
        'ℕ' => 'N',
        'ℙ' => 'P',
        'ℚ' => 'Q',
        'ℛ' | 'ℝ' => 'R',
        'ℤ' => 'Z',
        _ => return None,
    })
}

/// The letters of the mathematical alphabets (𝐋, 𝜔) are those of the plain one.
fn mathematical(c: char) -> Option<Lexeme<'static>> {
    let n = c as u32;
    let latin = |n: u32| {
        let n = n % 52;
        char::from_u32(if n < 26 {
            u32::from(b'A') + n
        } else {
            u32::from(b'a') + n - 26
        })
        .map(Lexeme::Letter)
    };
    if let Some(letter) = letterlike(c) {
        return Some(Lexeme::Letter(letter));
    }
    match n {
        0x1D400..=0x1D6A3 => latin(n - 0x1D400),
        0x1D6A8..=0x1D7A7 => {
            let n = (n - 0x1D6A8) % 58;
            let c = match n {
                0..=24 => char::from_u32('Α' as u32 + n)?,
                26..=50 => char::from_u32('α' as u32 + n - 26)?,
                _ => return None,
            };
            greek(c).map(Lexeme::Command)
        }
        _ => None,
    }
}
