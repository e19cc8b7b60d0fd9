//! Sentences of which nothing was made: which lines they keep from being proved or denied.

use crate::notation::ast::{DerivativeStyle, Function, Kind, Node, Symbol};
use crate::notation::document::Row;
use crate::notation::print;
use crate::verify::language::heads::{BOLD_LETTER, DECIMAL_NUMBERS, FRAME_AT_UPPER};
use crate::verify::language::statement::{Formula, Sign, Slot, Statement, Term};
use crate::verify::language::wants::Wants;
use crate::verify::reading::Reading;
use crate::verify::reading::names::{letter_of, node_of, nodes_of};
use crate::verify::reading::operators_read::rate_in_time;
use crate::verify::reading::ways_written::may_be_written_as;
use crate::verify::term::letters::{At, Letters, Mark, Reach, letter_names, spelled};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Letters that mean what they do by custom, where no sentence says otherwise.
const BY_CUSTOM: [&str; 5] = ["t", "pi", "delta", "epsilon", "varepsilon"];

/// Marks that stand on letters alone.
const ON_LETTERS: [&str; 7] = ["dot", "two", "tilde", "hat", "wide", "underline", "arrow"];

/// Commands by which a document defines its own.
const DEFINING: [&str; 4] = ["\\newcommand", "\\renewcommand", "\\def\\", "\\DeclareMath"];

/// What the parts of an array are called.
const PARTS: [&str; 3] = ["column", "row", "entry"];

/// A sentence that nothing was made of.
#[derive(Clone, Debug)]
pub(crate) struct Unused {
    pub(crate) sentence: String,
    pub(crate) understood: bool,
    /// What it says makes the model larger than what is worked out.
    pub(crate) beyond: bool,
    /// It says what quantity a letter is.
    pub(crate) names: bool,
    /// It says what something is: without it nothing that hangs on that is known.
    pub(crate) tells: bool,
    /// What would help, where that is known.
    pub(crate) wants: Option<Wants>,
    pub(crate) reach: Reach,
    /// The letters that it says something of, where it says no more than what these are: without marks, and of a sentence that
    /// was not understood without labels.
    pub(crate) letters: Option<BTreeSet<String>>,
    /// The letters that it is about, as they are printed.
    pub(crate) about: BTreeSet<String>,
    /// The letters that are connected with what it names, in sets that sentences share.
    pub(crate) connected: Option<Vec<Arc<BTreeSet<String>>>>,
    pub(crate) touches: Touches,
}

/// Of what a sentence that was not understood may change the meaning.
#[derive(Clone, Debug)]
pub(crate) enum Touches {
    Letters {
        /// Of these letters without their marks and labels.
        names: BTreeSet<String>,
        /// Of these formulas as they are written.
        wholes: Vec<String>,
        /// Whatever other sentences tell of them.
        anew: bool,
    },
    /// Of these formulas as they are written, whatever other sentences tell of them.
    Written(Vec<String>),
    /// Of what carries one of these signs.
    Signs(Vec<Sign>),
    /// Of what carries one of these words.
    Words(Vec<String>),
    /// Of what carries a sign that is written in one of these ways.
    WrittenSigns(Vec<String>),
    Everything,
}

/// Formulas, and the letters in them of which nothing is told.
#[derive(Clone, Copy)]
pub(crate) struct Written<'n> {
    pub(crate) nodes: &'n [&'n Node],
    pub(crate) unknown: &'n [String],
    /// The text of the document.
    pub(crate) text: &'n str,
}

impl Unused {
    /// Whether formulas may mean something else by it. What other sentences tell of a letter it does not take back, unless it
    /// is said of any labels or of a part of the document.
    fn may_change(&self, written: Written<'_>, letters: &Letters) -> bool {
        let mut nodes = written.nodes.iter();
        match &self.touches {
            Touches::Everything => true,
            Touches::Words(words) => {
                let lines = lines_of(written);
                words.iter().any(|word| lines.contains(word))
            }
            // A command of the document may write any sign.
            Touches::WrittenSigns(signs) => {
                let lines = lines_of(written);
                let own = DEFINING
                    .iter()
                    .any(|command| written.text.contains(command));
                own || signs.iter().any(|sign| lines.contains(sign))
            }
            Touches::Signs(signs) => nodes.any(|node| signs.iter().any(|sign| carries(node, sign))),
            Touches::Written(wholes) => {
                nodes.any(|node| wholes.iter().any(|whole| stands_in(node, whole)))
            }
            Touches::Letters { names, anew, .. } if *anew => {
                nodes.any(|node| names_one(node, names))
            }
            Touches::Letters { names, wholes, .. } => {
                let names = self.letters.as_ref().unwrap_or(names);
                has_untold(written, wholes, letters) || !names.is_disjoint(&untold_in(written))
            }
        }
    }

    /// Whether it is a rule for signs and words that formulas carry, and tells nothing of how things are.
    fn is_rule(&self) -> bool {
        let of_notation = |sign: &Sign| match sign {
            Sign::Label { .. } | Sign::Custom(_) => true,
            // Others may be the signs of products.
            Sign::Mark(mark) => {
                let mark = mark.split(' ').next().unwrap_or_default();
                ON_LETTERS.contains(&mark)
            }
            Sign::Operator(_) => false,
        };
        match &self.touches {
            Touches::Signs(signs) => signs.iter().all(of_notation),
            Touches::WrittenSigns(_) => true,
            _ => false,
        }
    }

    /// Whether lines may mean something else by it.
    fn blocks(&self) -> bool {
        !self.understood || self.tells
    }

    fn may_tell_of(&self, letters: &BTreeSet<String>) -> bool {
        let one_in = |own: &BTreeSet<String>| letters.iter().any(|letter| own.contains(letter));
        match (&self.letters, &self.connected) {
            (Some(own), _) => one_in(own),
            (None, Some(connected)) => connected.iter().any(|own| one_in(own)),
            (None, None) => true,
        }
    }
}

impl Reading {
    /// The sentences of which nothing was made, and that speak of a place.
    fn unused_at(&self, at: &At) -> impl Iterator<Item = &Unused> {
        let all = self.unused.iter();
        all.filter(move |unused| unused.reach.covers(at, 0))
    }

    /// A sentence of which nothing was made, and which may tell something of the letters of formulas at a place. One that was
    /// not understood may tell of anything, but for a rule of notation, which changes what carries its sign.
    pub(crate) fn unused_of(
        &self,
        letters: &BTreeSet<String>,
        written: Written<'_>,
        at: &At,
    ) -> Option<&str> {
        let tells = |unused: &&Unused| match unused.is_rule() {
            true => unused.may_change(written, &self.letters),
            false => !unused.understood || unused.may_tell_of(letters),
        };
        let found = self.unused_at(at).find(tells);
        found.map(|unused| unused.sentence.as_str())
    }

    /// Whether a sentence of which nothing was made tells of one of these letters.
    pub(crate) fn tells_unused(&self, letters: &BTreeSet<String>, at: &At) -> bool {
        let mut all = self.unused_at(at);
        all.any(|unused| unused.letters.is_some() && unused.may_tell_of(letters))
    }

    /// Whether a sentence of which nothing was made is about a letter: what a line says of it may be something else.
    pub(crate) fn is_about_unused(&self, letter: &str, at: &At) -> bool {
        self.unused_at(at)
            .any(|unused| unused.about.contains(letter))
    }

    /// Whether a sentence that was not understood, or of which nothing was made, says what a letter is.
    pub(crate) fn is_named_in_vain(&self, letter: &str, at: &At) -> bool {
        let names = |unused: &Unused| !unused.understood || unused.names;
        self.unused_at(at)
            .any(|unused| names(unused) && unused.about.contains(letter))
    }

    /// A sentence that was not understood, without which nothing can be said of formulas at a place.
    pub(crate) fn unread_of(&self, written: Written<'_>, at: &At) -> Option<&str> {
        let tells = |unused: &&Unused| unused.blocks() && unused.may_change(written, &self.letters);
        let found = self.unused_at(at).find(tells);
        found.map(|unused| unused.sentence.as_str())
    }
}

/// The letters in the subjects of a sentence, as they are printed.
pub(super) fn letters_of_subjects(statement: &Statement) -> BTreeSet<String> {
    fn collect(node: &Node, letters: &mut BTreeSet<String>) {
        if matches!(node.kind, Kind::Symbol(_)) {
            letters.insert(print::latex(node));
        }
        node.children().for_each(|child| collect(child, letters));
    }
    let mut letters = BTreeSet::new();
    for subject in statement.subjects() {
        let letter = match subject {
            Term::Formula(letter) => Some(letter),
            term => array_said(term),
        };
        if let Some(formula) = letter {
            nodes_of(formula)
                .iter()
                .for_each(|node| collect(node, &mut letters));
        }
    }
    letters
}

/// The letter of an array of which a term names the parts: "the columns of `$X$`".
pub(super) fn array_said(term: &Term) -> Option<&Formula> {
    match term {
        Term::Phrase(parts) if PARTS.contains(&parts.head) => letter_of(parts.slot(Slot::Of)?),
        _ => None,
    }
}

/// The lines of the text on which formulas stand, to their ends.
fn lines_of(written: Written<'_>) -> &str {
    let Written { nodes, text, .. } = written;
    let start = nodes.iter().map(|node| node.span.start as usize).min();
    let end = nodes.iter().map(|node| node.span.end as usize).max();
    let (Some(start), Some(end)) = (start, end) else {
        return "";
    };
    let first = text.get(..start).and_then(|before| before.rfind('\n'));
    let last = text.get(end..).and_then(|behind| behind.find('\n'));
    let (first, last) = (first.unwrap_or(0), last.map_or(text.len(), |at| end + at));
    text.get(first..last).unwrap_or(text)
}

fn stands_in(node: &Node, whole: &str) -> bool {
    spelled(node) == whole || node.children().any(|child| stands_in(child, whole))
}

/// Whether formulas have one of some writings of which no sentence tells as a whole: what its letter and its labels mean apart
/// is not what it means.
fn has_untold(written: Written<'_>, wholes: &[String], letters: &Letters) -> bool {
    let told = |whole: &str| letters.letters.iter().any(|l| l.spelled == whole);
    let mut untold = wholes.iter().filter(|whole| !told(whole));
    untold.any(|whole| written.nodes.iter().any(|node| stands_in(node, whole)))
}

/// Whether a formula has one of some names, as a letter or in a label.
pub(super) fn names_one(node: &Node, names: &BTreeSet<String>) -> bool {
    let in_label = |label: &str| names.iter().any(|name| label.contains(name.as_str()));
    let own = match &node.kind {
        Kind::Symbol(symbol) => names.contains(&symbol.name) || scripts(symbol).any(in_label),
        _ => frame_label(node).is_some_and(in_label),
    };
    own || node.children().any(|child| names_one(child, names))
}

fn scripts(symbol: &Symbol) -> impl Iterator<Item = &str> {
    let all = symbol.subscripts.iter().chain(&symbol.superscripts);
    all.map(String::as_str)
}

/// The frame that is written beside a derivative or a bracket.
fn frame_label(node: &Node) -> Option<&str> {
    match &node.kind {
        Kind::TimeDerivative { frame, .. } => frame.as_ref().map(|label| label.text.as_str()),
        Kind::InFrame(_, label) => Some(label.text.as_str()),
        _ => None,
    }
}

/// Whether a sign stands anywhere in a formula, or may; of a sign that is not looked for it may.
pub(super) fn carries(node: &Node, sign: &Sign) -> bool {
    let own = match sign {
        _ if matches!(node.kind, Kind::Error(_)) => true,
        Sign::Mark(mark) => carries_mark(node, mark),
        Sign::Label { labels, .. } => labels.iter().any(|label| {
            let name = label.trim_matches(['$', '"', '\\', '{', '}']);
            names_one(node, &BTreeSet::from([name.to_owned()]))
        }),
        Sign::Custom(custom) => carries_custom(node, custom),
        // Where a sign is not read, it is not read on a line either.
        Sign::Operator(operator) if is_unread(operator) => false,
        Sign::Operator(operator) => match (style_of_rate(operator), &node.kind) {
            (Some(written), Kind::TimeDerivative { style, .. }) => *style == written,
            (Some(_), _) => false,
            (None, _) => node_of(operator).is_none_or(|operator| may_be_written_as(node, operator)),
        },
    };
    own || node.children().any(|child| carries(child, sign))
}

fn is_unread(formula: &Formula) -> bool {
    match &formula.row {
        Row::Unreadable { .. } => true,
        Row::Expression(node) => matches!(node.kind, Kind::Error(_)),
        Row::Line(_) => false,
    }
}

/// How a formula writes a rate in time, if it is one or the operator of one.
fn style_of_rate(formula: &Formula) -> Option<DerivativeStyle> {
    match node_of(formula).map(|node| &node.kind) {
        Some(Kind::TimeDerivative { style, .. }) => Some(*style),
        _ if rate_in_time(&formula.source) == Some(Mark::Leibniz) => Some(DerivativeStyle::Leibniz),
        _ => None,
    }
}

fn carries_mark(node: &Node, mark: &str) -> bool {
    let symbol = match &node.kind {
        Kind::Symbol(symbol) => Some(symbol),
        _ => None,
    };
    let style = symbol.map(|symbol| symbol.style).unwrap_or_default();
    let is_matrix = matches!(node.kind, Kind::Skew(_));
    match mark.split(' ').next().unwrap_or_default() {
        "dot" | "two" => match &node.kind {
            Kind::TimeDerivative { style, .. } => *style == DerivativeStyle::Dots,
            _ => false,
        },
        "cross" => is_matrix,
        "tilde" => style.tilde || is_matrix,
        "hat" | "wide" => style.hat || is_matrix,
        "underline" | "arrow" => style.vector || style.tensor,
        script @ ("wedge" | "vee" | "star" | "dagger") => {
            let written = if script == "star" { "*" } else { script };
            let stands = |name: &str| name == written || name == script;
            let is_vector = matches!(node.kind, Kind::Function(Function::Vee, _));
            is_matrix
                || is_vector
                || symbol.is_some_and(|s| stands(&s.name) || scripts(s).any(stands))
        }
        "prime" => symbol.is_some_and(|s| s.primes > 0) || matches!(node.kind, Kind::Transpose(_)),
        _ => true,
    }
}

fn carries_custom(node: &Node, custom: &str) -> bool {
    let at_upper = custom.starts_with(FRAME_AT_UPPER);
    match &node.kind {
        Kind::Symbol(symbol) if at_upper => !symbol.superscripts.is_empty(),
        Kind::Power(..) if at_upper => true,
        _ if at_upper => frame_label(node).is_some(),
        Kind::Symbol(symbol) if custom == BOLD_LETTER => symbol.style.vector,
        Kind::Number(number) if custom == DECIMAL_NUMBERS => number.decimals.is_some(),
        _ if [BOLD_LETTER, DECIMAL_NUMBERS].contains(&custom) => false,
        Kind::Group(..) | Kind::Tuple(_) | Kind::Matrix(_) | Kind::Call(..) => true,
        Kind::InFrame(..) | Kind::Skew(_) | Kind::Norm(_) => true,
        _ => !custom.contains("brackets") && custom != "braces",
    }
}

/// The letters of formulas that are unknown or mean what they do by custom, without marks and labels.
fn untold_in(written: Written<'_>) -> BTreeSet<String> {
    fn collect(node: &Node, unknown: &mut BTreeMap<&str, bool>, names: &mut BTreeSet<String>) {
        if let Kind::Symbol(symbol) = &node.kind {
            let found = unknown.get_mut(print::latex(node).as_str());
            if found.map(|found| *found = true).is_some()
                || BY_CUSTOM.contains(&symbol.name.as_str())
            {
                names.insert(symbol.name.clone());
            }
        }
        node.children()
            .for_each(|child| collect(child, unknown, names));
    }
    let unknown = written.unknown.iter().map(|u| (u.as_str(), false));
    let mut unknown: BTreeMap<&str, bool> = unknown.collect();
    let (nodes, mut names) = (written.nodes.iter(), BTreeSet::new());
    nodes.for_each(|node| collect(node, &mut unknown, &mut names));
    match unknown.values().all(|found| *found) {
        true => names,
        // One that is written otherwise, as a function of some letters is, may be any of them.
        false => written
            .nodes
            .iter()
            .copied()
            .flat_map(letter_names)
            .collect(),
    }
}
