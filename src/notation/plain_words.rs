//! What the words of plain text are in LaTeX: `omega`, `Ixx`, `wxdot`.

use crate::notation::token::Lexeme;

/// A word of plain text as a symbol: `wxdot` is ω with the subscript x and one dot.
pub(crate) struct Spelling<'a> {
    pub(crate) base: Lexeme<'a>,
    pub(crate) subscript: &'a str,
    pub(crate) dots: u8,
}

const GREEK: &[&str] = &[
    "alpha", "beta", "gamma", "delta", "epsilon", "eta", "theta", "kappa", "lambda", "mu", "nu",
    "xi", "pi", "rho", "sigma", "tau", "phi", "chi", "psi", "omega", "Omega", "Gamma", "Delta",
    "Theta", "Lambda", "Sigma", "Phi", "Psi", "ell",
];

/// Whether a word is the name of a Greek letter.
pub(crate) fn is_greek(word: &str) -> bool {
    GREEK.contains(&word)
}

const WORDS: &[&str] = &[
    "sin", "cos", "tan", "cot", "exp", "ln", "log", "sqrt", "det", "tr", "arctan", "arcsin",
    "arccos", "sinh", "cosh", "tanh", "cross", "skew", "sum",
];

/// Whether a word with a bracket right behind it calls a function, as programs write it: `dot(a, b)`, `inv(I)`.
pub(crate) fn is_call(word: &str) -> bool {
    matches!(
        word,
        "dot" | "cross" | "inv" | "norm" | "transpose" | "trace" | "diag" | "abs"
    )
}

/// Words that say in brackets from which frame a rate is seen: `dH/dt (inertial)`.
pub(crate) fn is_frame(word: &str) -> bool {
    matches!(
        word,
        "inertial" | "space" | "fixed" | "body" | "rotating" | "moving" | "relative"
    )
}

/// What a word of plain text stands for, where it is known: Greek names, functions, components that run
/// together (`Ixx`, `wx`, `L1`), each with `dot` behind it or in it.
pub(crate) fn word(word: &str) -> Option<Spelling<'_>> {
    if let Some(spelling) = dot_inside(word) {
        return Some(spelling);
    }
    let (stem, dots) = undotted(word);
    if let Some(name) = WORDS
        .iter()
        .chain(GREEK)
        .find(|w| w.as_bytes().first() == stem.as_bytes().first() && **w == stem)
    {
        let base = match *name {
            "cross" => Lexeme::Command("times"),
            name => Lexeme::Command(name),
        };
        return Some(Spelling {
            base,
            subscript: "",
            dots,
        });
    }
    let mut letters = stem.chars();
    if let (Some(c), None, true) = (letters.next(), letters.next(), dots > 0)
        && c.is_ascii_alphabetic()
    {
        return Some(Spelling {
            base: Lexeme::Letter(c),
            subscript: "",
            dots,
        });
    }
    let (head, tail) = split_components(stem)?;
    let base = match head {
        "omega" => Lexeme::Command("omega"),
        "Omega" => Lexeme::Command("Omega"),
        "tau" => Lexeme::Command("tau"),
        _ => Lexeme::Letter(head.chars().next()?),
    };
    (!tail.is_empty() || dots > 0).then_some(Spelling {
        base,
        subscript: tail,
        dots,
    })
}

/// `wdotx`, `omegadot1`: the dot before the index.
fn dot_inside(word: &str) -> Option<Spelling<'_>> {
    let (head, subscript) = word.rsplit_once("dot")?;
    if !matches!(subscript, "x" | "y" | "z" | "0" | "1" | "2" | "3") {
        return None;
    }
    let (head, dots) = match head.strip_suffix('d') {
        Some(twice) if !twice.is_empty() => (twice, 2),
        _ => (head, 1),
    };
    let mut letters = head.chars();
    let base = match (letters.next(), letters.next()) {
        (Some(letter), None) if letter.is_ascii_alphabetic() => Lexeme::Letter(letter),
        _ => Lexeme::Command(GREEK.iter().copied().find(|name| *name == head)?),
    };
    Some(Spelling {
        base,
        subscript,
        dots,
    })
}

/// A word without the dots at its end, and how many these are.
pub(crate) fn undotted(word: &str) -> (&str, u8) {
    match word.strip_suffix("ddot") {
        Some(stem) if !stem.is_empty() => (stem, 2),
        _ => match word.strip_suffix("dot") {
            Some(stem) if !stem.is_empty() => (stem, 1),
            _ => (word, 0),
        },
    }
}

/// Whether a word is a capital and two axes: the `Bxx` of a box.
pub(crate) fn is_entry(word: &str) -> bool {
    let axes = |b: &u8| matches!(b, b'x' | b'y' | b'z');
    matches!(word.as_bytes(), [head, row, column] if head.is_ascii_uppercase() && axes(row) && axes(column))
}

/// Splits `Ixx` into I and xx; only letters that have components, and only axes as components.
fn split_components(stem: &str) -> Option<(&str, &str)> {
    if is_entry(stem) {
        return Some(stem.split_at(1));
    }
    let head = [
        "omega", "Omega", "tau", "I", "J", "L", "H", "M", "N", "h", "w", "T", "v", "a", "F", "r",
        "P", "D",
    ]
    .into_iter()
    .find(|head| stem.starts_with(head))?;
    let tail = &stem[head.len()..];
    let axes = tail.bytes().all(|b| matches!(b, b'x' | b'y' | b'z'))
        || tail.bytes().all(|b| matches!(b, b'1'..=b'3'));
    // The tensor, and what it gives, about a point: `IG`, `HO`.
    let point = matches!(head, "I" | "J" | "L" | "H" | "M") && matches!(tail, "G" | "O" | "C")
        || matches!(head, "I" | "J") && matches!(tail, "b" | "c" | "B");
    if point {
        return Some((head, tail));
    }
    let long = if matches!(head, "I" | "J" | "P" | "D") {
        2
    } else {
        1
    };
    // A P or a D with one axis may well be two letters.
    let product = !matches!(head, "P" | "D") || tail.len() == 2;
    (axes && product && tail.len() <= long).then_some((head, tail))
}
