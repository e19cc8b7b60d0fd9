//! What in a plain text looks like mathematics.

use crate::notation::parse::is_unit;
use crate::notation::plain_words;
use crate::notation::unicode;

/// How much a word looks like mathematics.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd)]
enum Look {
    Words,
    /// Could be either: a bracket, a number, a lone letter.
    Weak,
    Strong,
}

/// Short words of English that are no letters of a formula.
const SHORT: &[&str] = &[
    "a", "an", "as", "at", "be", "by", "do", "if", "in", "is", "it", "no", "of", "on", "or", "so",
    "to", "up", "us", "we", "he", "my", "go", "am", "me", "eq", "vs", "ok",
];

/// A point with space on both sides is that of a product: `w . (I w)`.
const DOT: &str = ".";

const ARROWS: &[&str] = &["=>", "==>", "->", "-->", "<=>", "⇒", "⟹", "→", "⇔", "∴"];

/// Whether a word is a bracket and one letter of a list: the beginning of `(a, b, c)`.
fn opens_list(word: &str) -> bool {
    let inside = word
        .strip_prefix('(')
        .and_then(|rest| rest.strip_suffix(','));
    inside.is_some_and(|letter| letter.len() == 1 && letter.chars().all(char::is_alphabetic))
}

/// The box that closes a proof, with a number on it or none.
fn is_end_mark(word: &str) -> bool {
    let number = |c: char| c == '_' || c.is_ascii_digit() || unicode::script(c).is_some();
    matches!(word.trim_end_matches(number), "∎" | "■" | "□")
}

fn look(word: &str) -> Look {
    let core = word.trim_matches(['.', ',', ';', ':']);
    let foreign = core.contains(unicode::is_ideograph);
    if foreign || ARROWS.contains(&core) || is_end_mark(core) {
        return Look::Words;
    }
    let strong = core.chars().any(|c| {
        matches!(
            c,
            '=' | '^' | '_' | '½' | '×' | '·' | '−' | '√' | '∂' | '∫' | '≈' | '≠' | '≡'
        ) || !c.is_ascii()
            && (('Α'..='ω').contains(&c)
                || ('\u{300}'..='\u{36f}').contains(&c)
                || unicode::script(c).is_some()
                || !unicode::decomposed(c).1.is_empty())
    });
    let known = |word: &str| plain_words::word(word).is_some();
    // "The product w2*w3": no word of English has a star in it.
    let product = core.contains('*') && core.split('*').all(known);
    if strong || known(core) || product || is_rate(core) || is_called_by_word(core) {
        return Look::Strong;
    }
    if word == DOT || opens_list(word) {
        return Look::Weak;
    }
    if core.contains(['/', '^', '*']) && is_unit(core) {
        return Look::Weak;
    }
    let sentence_letter = matches!(core, "A" | "I") && word != core;
    let mut runs = core
        .split(|c: char| !c.is_alphanumeric())
        .filter(|run| !run.is_empty());
    let called = |run: &str| plain_words::is_call(run) && core.contains(&format!("{run}("));
    // The a of `(a+b)` is no article.
    let term = |run: &str| run == "a" && core.contains(['+', '-', '*', '/']);
    let english = |run: &str| is_english(run) && !known(run) && !called(run) && !term(run);
    if core.is_empty() || sentence_letter || runs.any(english) {
        return Look::Words;
    }
    Look::Weak
}

/// `cos(angle)`: a function of what has a word for its name.
fn is_called_by_word(word: &str) -> bool {
    let parts = word.strip_suffix(')').and_then(|rest| rest.split_once('('));
    parts.is_some_and(|(function, name)| {
        matches!(function, "sin" | "cos" | "tan")
            && name.len() > 2
            && name.bytes().all(|b| b.is_ascii_lowercase())
    })
}

/// More than two letters, or one of the short words.
fn is_english(run: &str) -> bool {
    // The dwz of `dwz/dt`, and the dm of an integral.
    let differential = run
        .strip_prefix('d')
        .is_some_and(|rest| plain_words::word(rest).is_some() || is_component(rest));
    if differential {
        return false;
    }
    let letters = run.chars().filter(|c| c.is_alphabetic()).count();
    letters > 2 || SHORT.contains(&run.to_ascii_lowercase().as_str()) && !matches!(run, "A")
}

/// A letter and its axis: `Qx`, `v1`.
fn is_component(run: &str) -> bool {
    let mut characters = run.chars();
    let letter = characters.next().is_some_and(char::is_alphabetic);
    let axis = matches!(characters.next(), Some('x' | 'y' | 'z' | '1' | '2' | '3'));
    letter && axis && characters.next().is_none()
}

/// `dT/dt`.
fn is_rate(word: &str) -> bool {
    let mut parts = word.splitn(2, '/');
    let differential =
        |part: Option<&str>| part.is_some_and(|p| p.starts_with('d') && p.chars().count() <= 4);
    differential(parts.next()) && differential(parts.next())
}

fn is_relation(word: &str) -> bool {
    matches!(word, "=" | "≈" | "≡" | ":=" | "≔" | "==" | "~=")
}

fn is_order(word: &str) -> bool {
    matches!(word, "<" | ">" | "<=" | ">=" | "≤" | "≥" | "≪" | "≫")
}

fn is_constant(word: &str) -> bool {
    let word = word.trim_end_matches(['.', ',', ';']);
    matches!(word, "const" | "constant")
}

/// The body of a line and the label behind it: `L = I w   (2)`.
pub(super) fn labelled(text: &str) -> (&str, Option<&str>) {
    let whole = (text, None);
    let Some(inner) = text.strip_suffix(')') else {
        return whole;
    };
    let Some(open) = inner.rfind('(') else {
        return whole;
    };
    let before = &text[..open];
    let body = before.trim_end_matches([' ', '\t', '.', '·', '…', '-', '—']);
    let apart = before[body.len()..].chars().count() > 1 || before.ends_with('\t');
    let label = inner[open + 1..].trim();
    let short = label.len() <= 8 && label.starts_with(|c: char| c.is_ascii_alphanumeric());
    let plain = label
        .bytes()
        .all(|b| b.is_ascii_alphanumeric() || matches!(b, b'.' | b'\'' | b'-'));
    match apart && short && plain && !body.is_empty() {
        true => (body, Some(label)),
        false => whole,
    }
}

/// The bytes of a list marker and the space behind it: `- `, `* `, `1. `, `(a) `.
pub(super) fn marker(text: &str) -> usize {
    let Some(space) = text.find(' ') else {
        return 0;
    };
    let word = &text[..space];
    let number = word.trim_start_matches('(').trim_end_matches(['.', ')']);
    let counted = word.ends_with(['.', ')'])
        && (1..=3).contains(&number.len())
        && (number.bytes().all(|b| b.is_ascii_digit())
            || (number.len() == 1 && word.ends_with(')'))
            || number.bytes().all(|b| matches!(b, b'i' | b'v' | b'x')));
    // A note may stand as a comment of some program.
    if counted || matches!(word, "-" | "*" | "•" | "–" | "+" | "o" | "%" | "%%" | "//") {
        text.len() - text[space..].trim_start().len()
    } else {
        0
    }
}

/// Whether every word of a text may belong to a formula.
pub(super) fn is_mathematical(text: &str) -> bool {
    let letter = |word: &str| matches!(word.trim_end_matches(','), "A" | "I" | "a");
    let rate = text.contains("/dt");
    let frame = |word: &str| {
        let inside = word
            .strip_prefix('(')
            .and_then(|rest| rest.strip_suffix(')'));
        rate && inside.is_some_and(plain_words::is_frame)
    };
    text.split_whitespace().all(|word| {
        look(word) != Look::Words
            || letter(word)
            || frame(word)
            || is_constant(word)
            || ARROWS.contains(&word)
            || is_end_mark(word)
    })
}

/// Signs of relation, of which a line of a derivation has one.
pub(super) const RELATIONS: [char; 6] = ['=', '≈', '≠', '≡', '<', '>'];

/// A line that is a formula as a whole: a relation, and no words but a name before it.
pub(super) fn is_formula(text: &str) -> bool {
    let related = text.contains(RELATIONS);
    let mut words = text.split_whitespace();
    let named = words
        .next()
        .is_some_and(|w| w.chars().all(char::is_alphabetic))
        && words.next().is_some_and(is_relation);
    let body = match named {
        true => text.trim_start().split_once(char::is_whitespace),
        false => None,
    };
    let body = body.map_or(text, |(_, rest)| rest);
    related && is_mathematical(&body.replace("= integral of ", "= ∫ "))
}

/// The symbols of an entry in a list of symbols, `w    angular velocity`, `Mx, My, Mz    moments`: their bytes, and those
/// up to the words.
pub(super) fn entry(text: &str) -> Option<(usize, usize)> {
    let end = text.find("  ").into_iter().chain(text.find('\t')).min()?;
    let (symbols, rest) = text.split_at(end);
    let name = |symbol: &str| {
        symbol.len() <= 6
            && symbol.starts_with(char::is_alphabetic)
            && symbol.chars().all(|c| c.is_alphanumeric() || c == '_')
            && look(symbol) != Look::Words
    };
    let mut names = symbols.split(&[',', ' ']).filter(|name| !name.is_empty());
    let listed = !symbols.is_empty() && names.all(name);
    let words = rest.trim_start();
    let spoken = words.split_whitespace().next().is_some_and(|word| {
        word.len() > 2 && word.chars().all(char::is_alphabetic) && look(word) == Look::Words
    });
    (listed && spoken).then_some((end, text.len() - words.len()))
}

/// A run of mathematical words under construction.
struct Run {
    start: usize,
    end: usize,
    strong: bool,
}

/// The runs of words that hold something strongly mathematical, as ranges of bytes.
pub(super) fn runs(text: &str) -> Vec<(usize, usize)> {
    let mut out: Vec<Run> = vec![];
    let mut run: Option<Run> = None;
    let mut before = None;
    let mut at = 0;
    for piece in text.split_inclusive(char::is_whitespace) {
        let word = piece.trim_end();
        if !word.is_empty() {
            let end = at + word.trim_end_matches(['.', ',', ';', ':']).len();
            let held = is_held(word, &text[at + piece.len()..]);
            if held || belongs(word, run.as_ref().map(|run| &text[run.start..run.end])) {
                // A sign of order opens no line: there it marks what somebody else wrote.
                let order = run.is_some() && is_order(word);
                let strong = look(word) == Look::Strong || held || order;
                let mut next = run.take().unwrap_or(Run {
                    start: at,
                    end,
                    strong: false,
                });
                // A name in words stands before its sign: "the energy = ½ I ω²".
                if next.end == end && is_relation(word) {
                    next.start = before.unwrap_or(at);
                }
                next.end = end.max(next.start);
                next.strong |= strong;
                // The commas of `ω = (p, q, r)` stand inside it.
                let inside = word.ends_with(',') && is_open(&text[next.start..next.end]);
                if word.ends_with(['.', ',', ';', ':']) && !inside && word != DOT {
                    out.push(next);
                } else {
                    run = Some(next);
                }
            } else {
                out.extend(run.take());
            }
            before = word.chars().all(char::is_alphabetic).then_some(at);
        }
        at += piece.len();
    }
    out.extend(run);
    out.into_iter()
        .filter(|run| run.strong && run.end > run.start)
        .map(|run| {
            (
                run.start,
                run.start + closed(&text[run.start..run.end]).len(),
            )
        })
        .flat_map(|(start, end)| unbracketed(text, start, end))
        .collect()
}

/// The lines of a bracket that holds nothing else: "(M = 0, N = 0)".
fn unbracketed(text: &str, start: usize, end: usize) -> Vec<(usize, usize)> {
    let whole = vec![(start, end)];
    let inside = text[start..end]
        .strip_prefix('(')
        .and_then(|rest| rest.strip_suffix(')'));
    let Some(inside) = inside.filter(|inside| !inside.contains(['(', ')'])) else {
        return whole;
    };
    let mut lines = vec![];
    let mut at = start + 1;
    for piece in inside.split(", ") {
        if !piece.contains('=') {
            return whole;
        }
        lines.push((at, at + piece.len()));
        at += piece.len() + ", ".len();
    }
    lines
}

/// Whether the words behind a lone letter say that it is a symbol: "suppose p constant", "C is the moment of inertia about
/// the axis and A the one about any diameter", "h the momentum of the wheels".
fn is_held(word: &str, behind: &str) -> bool {
    let lone = |of: fn(&u8) -> bool| word.len() == 1 && word.bytes().all(|b| of(&b));
    let starts = |words: &[&str]| words.iter().any(|words| behind.starts_with(words));
    lone(u8::is_ascii_lowercase) && starts(HELD)
        || lone(u8::is_ascii_alphabetic) && (starts(NAMED) || is_given_a_name(behind))
}

/// Words behind a letter of what keeps its value.
const HELD: &[&str] = &["constant", "is constant", "stays constant", "held constant"];
/// Words behind a letter that say which moment of inertia it is; no article has them behind it.
const NAMED: &[&str] = &[
    "is the one about",
    "the one about",
    "is that about",
    "that about",
];

/// Whether words behind a letter say which quantity it is: "the external torque", "is its inertia matrix". No article of
/// English has another behind it.
fn is_given_a_name(behind: &str) -> bool {
    let named = ["is the ", "the ", "is its ", "its "];
    let named = named.iter().find_map(|lead| behind.strip_prefix(lead));
    let nouns = [
        "moment", "moments", "momentum", "inertia", "torque", "velocity", "energy", "mass",
        "couple", "distance", "radius", "angle", "length",
    ];
    named.is_some_and(|words| {
        let mut first = words.split_whitespace().take(3);
        first.any(|word| nouns.contains(&word.trim_end_matches(['.', ',', ';', ':'])))
    })
}

/// A text without a bracket that words go on from: `N = 0 (T` of "N = 0 (T may act)".
fn closed(text: &str) -> &str {
    match text
        .rfind('(')
        .filter(|&at| at > 0 && !text[at..].contains(')'))
    {
        Some(open) => text[..open].trim_end(),
        None => text,
    }
}

/// Whether a bracket of a text is not closed in it.
fn is_open(text: &str) -> bool {
    let opened = text.matches(['(', '[']).count();
    opened > text.matches([')', ']']).count()
}

/// Whether a word goes on with the run before it.
fn belongs(word: &str, run: Option<&str>) -> bool {
    let operators = [
        '=', '+', '-', '−', '/', '*', '(', '×', '·', '<', '>', '≤', '≥',
    ];
    let open = run.is_some_and(|run| run.ends_with(operators));
    let letter = word.trim_end_matches(['.', ',', ':', ';']).len() == 1;
    // "I_xz = integral of x*z dm".
    let integral = match word {
        "integral" => run.is_some_and(|run| run.trim_end().ends_with('=')),
        "of" => run.is_some_and(|run| run.trim_end().ends_with("integral")),
        _ => false,
    };
    integral
        || look(word) != Look::Words
        || (open && (letter || is_constant(word)))
        || (run.is_some() && matches!(word, "A" | "I" | "a"))
}
