//! The sentences of a document, with the symbols that stand in them.

use crate::notation::ast::{Kind, Line, Node, Relation, Symbol};
use crate::notation::document::{Document, Formula, Item, Row};
use crate::source::Span;
use crate::verify::letters::attitude_matrix::MATRIX_LETTERS;
use crate::verify::letters::usage::inner;
use crate::verify::words::book::lowered;

/// Bytes of a sentence that are kept: a page without a stop is no sentence.
const LONGEST: usize = 4_000;

/// Whether a sentence may go on in the next paragraph, as round a display or through a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Paragraphs {
    /// It ends with its paragraph.
    Apart,
    /// It goes on.
    Joined,
}

/// A sentence in small letters, on one line.
#[derive(Debug, Default)]
pub(crate) struct Sentence<'d> {
    pieces: Vec<Piece<'d>>,
    length: usize,
}

#[derive(Debug)]
enum Piece<'d> {
    Words(String),
    /// A formula of one symbol.
    Symbol(&'d Symbol, Span),
    /// Any other formula.
    Formula,
}

impl<'d> Sentence<'d> {
    /// The lone symbols in it.
    pub(crate) fn symbols(&self) -> impl Iterator<Item = (&'d Symbol, Span)> {
        self.pieces.iter().filter_map(|piece| match piece {
            Piece::Symbol(symbol, span) => Some((*symbol, *span)),
            _ => None,
        })
    }

    /// Its words, with `⟨n⟩` in the place of its n-th lone symbol and `⟨⟩` in that of any other formula.
    pub(crate) fn numbered(&self) -> String {
        self.text(|n, _| format!("⟨{n}⟩"))
    }

    /// Its words, with `⟨name⟩` in the place of a lone symbol and `⟨⟩` in that of any other formula.
    pub(crate) fn named(&self) -> String {
        self.text(|_, symbol| format!("⟨{}⟩", symbol.name))
    }

    fn text(&self, mark: impl Fn(usize, &Symbol) -> String) -> String {
        let mut text = String::with_capacity(self.length);
        let mut count = 0;
        for piece in &self.pieces {
            match piece {
                Piece::Words(words) => text.push_str(words),
                Piece::Symbol(symbol, _) => {
                    text.push_str(&mark(count, symbol));
                    count += 1;
                }
                Piece::Formula => text.push_str("⟨⟩"),
            }
        }
        text
    }

    fn push(&mut self, piece: Piece<'d>) {
        if self.length < LONGEST {
            self.length += match &piece {
                Piece::Words(words) => words.len(),
                Piece::Symbol(..) | Piece::Formula => 1,
            };
            self.pieces.push(piece);
        }
    }
}

/// Whether a display ends with a stop.
pub(crate) fn closes_sentence(document: &Document, formula: &Formula) -> bool {
    let text = document.source.slice(formula.span);
    let inside = text.trim_end_matches(['$', '\\', ']', ')']).trim_end();
    let inside = inside
        .rfind("\\end{")
        .map_or(inside, |i| inside[..i].trim_end());
    formula.display && inside.ends_with('.')
}

/// The sentences of a document, each heading one of its own.
pub(crate) fn sentences(document: &Document, paragraphs: Paragraphs) -> Vec<Sentence<'_>> {
    let mut all = vec![];
    let mut open = Sentence::default();
    for item in &document.items {
        match item {
            Item::Prose { text, .. } => {
                for words in lowered(text).split_inclusive(['.', '!', '?']) {
                    open.push(Piece::Words(words.replace(['\n', '*'], " ")));
                    if words.ends_with(['.', '!', '?']) {
                        all.push(std::mem::take(&mut open));
                    }
                }
            }
            Item::Formula(formula) => {
                for row in &formula.rows {
                    let lone = match row {
                        Row::Expression(node) => lone(node),
                        Row::Line(line) => bounded(line).filter(|_| !formula.display),
                        _ => None,
                    };
                    open.push(lone.map_or(Piece::Formula, |s| Piece::Symbol(s, formula.span)));
                }
                if closes_sentence(document, formula) {
                    all.push(std::mem::take(&mut open));
                }
            }
            Item::Heading { text, .. } => {
                all.push(std::mem::take(&mut open));
                open.push(Piece::Words(lowered(text)));
                all.push(std::mem::take(&mut open));
            }
            Item::Break if paragraphs == Paragraphs::Apart => all.push(std::mem::take(&mut open)),
            Item::Break => open.push(Piece::Words(" ".to_owned())),
            Item::Comment { .. } => {}
        }
    }
    all.push(open);
    all.retain(|sentence| !sentence.pieces.is_empty());
    all
}

/// The symbol that a formula bounds by a number, the s of "the distance ⟨s > 0⟩".
fn bounded(line: &Line) -> Option<&Symbol> {
    let [left, right] = line.sides.as_slice() else {
        return None;
    };
    let bounds = |relation: &Relation| {
        matches!(
            relation,
            Relation::Greater | Relation::Less | Relation::NotEqual
        )
    };
    match (&left.kind, &right.kind) {
        (Kind::Symbol(symbol), Kind::Number(_)) => {
            let all = line.relations.iter().all(|(relation, _)| bounds(relation));
            all.then_some(symbol)
        }
        _ => None,
    }
}

/// The symbol that a formula is, the matrix `R(q)` of a quaternion included.
fn lone(node: &Node) -> Option<&Symbol> {
    match &inner(node).kind {
        Kind::Symbol(symbol) => Some(symbol),
        Kind::Call(head, arguments) => match (&inner(head).kind, arguments.as_slice()) {
            (Kind::Symbol(symbol), [one])
                if MATRIX_LETTERS.contains(&symbol.name.as_str())
                    && matches!(inner(one).kind, Kind::Symbol(_)) =>
            {
                Some(symbol)
            }
            _ => None,
        },
        _ => None,
    }
}
