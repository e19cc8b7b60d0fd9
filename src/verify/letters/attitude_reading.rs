//! Which letters of a document are its attitude matrix and the parts of its quaternion.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::letters::attitude_layouts::{Layout, is_vector_part};
use crate::verify::letters::turns_from_left::turns_from_left;
use crate::verify::letters::usage::{Letter, inner, symbols, undotted};
use crate::verify::theory::attitude_law::Convention;
use crate::verify::values::spatial::{BODY, LETTERS, WORDS};
use crate::verify::words::attitude_words::{Sentence, Way, rate_in_space, way};
use crate::verify::words::book::has_any;
use crate::verify::words::text::Text;
use std::collections::BTreeMap;

/// A part of a quaternion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// All four numbers.
    Whole,
    /// The conjugate.
    Conjugate,
    /// The vector part.
    Vector,
    /// One number: 0 for the scalar part, 1 to 3 for the vector part.
    Number(u8),
}

/// A spelling: the letter, its subscripts, whether it is marked as a vector.
pub(crate) type Spelling = (Letter, Vec<String>, bool);

/// What is known of the attitude from the document as a whole.
#[derive(Clone, Debug, Default)]
pub(crate) struct AttitudeReading {
    /// The letter of the matrix.
    pub matrix: Option<Letter>,
    /// The letter of the quaternion.
    pub quaternion: Option<Letter>,
    /// Whether columns of four have the scalar last.
    pub scalar_last: bool,
    /// Whether the document multiplies quaternions by `\otimes`, so that this sign makes no dyads.
    pub circled: bool,
    /// Which way matrix and quaternion go.
    pub convention: Convention,
    /// Whether words say so, for the matrix and for the quaternion.
    pub said: [bool; 2],
    pub(crate) parts: BTreeMap<Spelling, Part>,
    /// Where the document goes on in another layout, and in which.
    pub(crate) layouts: Vec<Layout>,
}

/// Superscripts of a conjugate.
const STARS: &[&str] = &[
    "*", "∗", "⋆", "†", "ast", "star", "dagger", "\\ast", "\\star", "\\dagger",
];

impl AttitudeReading {
    /// Reads the document; `taken` tells letters that stand for something else.
    pub(crate) fn of(document: &Text, taken: &impl Fn(&Letter) -> bool) -> Self {
        let mut reading = Self::default();
        let sentences = document.named_sentences();
        let speaks = |word: &str| sentences.iter().any(|s| s.text.contains(word));
        let all: Vec<&Symbol> = document
            .lines()
            .flat_map(|line| &line.sides)
            .flat_map(symbols)
            .collect();
        if speaks("quaternion") || speaks("euler parameter") {
            reading.find_quaternion(&all, sentences, taken);
            reading.name_parts(document, taken);
            document
                .lines()
                .for_each(|line| line.sides.iter().for_each(|side| reading.layout(side)));
            reading.circled = document.lines().any(|line| {
                let mut sides = line.sides.iter();
                sides.any(|side| reading.has_circled_product(side))
            });
            reading.scalar_last |=
                speaks("scalar last") || speaks("scalar-last") || speaks("scalar part last");
        }
        reading.find_matrix(document, sentences, taken);
        let rates = || all.iter().filter(|s| s.name == "omega");
        let labelled = rates().any(|s| !s.superscripts.is_empty()) || wear_labels(rates());
        reading.listen(sentences, labelled);
        let silent = !labelled && sentences.iter().all(|s| rate_in_space(&s.text).is_none());
        if let Some(matrix) = reading.matrix.as_ref().filter(|_| silent) {
            let to_space = !reading.convention.matrix_to_body;
            reading.convention.rate_in_space |= to_space && turns_from_left(document, matrix);
        }
        reading.layouts = reading.layouts(document, taken);
        reading
    }

    /// The part of the quaternion that a symbol stands for.
    pub(crate) fn part(&self, symbol: &Symbol) -> Option<Part> {
        if self.parts.is_empty() {
            return None;
        }
        let starred = symbol
            .superscripts
            .iter()
            .any(|s| STARS.contains(&s.trim()));
        if symbol.primes > 0 || symbol.variation || (!starred && !symbol.superscripts.is_empty()) {
            return None;
        }
        match self.parts.get(&spelling(symbol)).copied()? {
            Part::Whole if starred || symbol.style.bar || symbol.style.tilde => {
                Some(Part::Conjugate)
            }
            _ if starred => None,
            part => Some(part),
        }
    }

    /// Whether the document speaks of an attitude at all.
    pub(crate) fn is_spoken_of(&self) -> bool {
        self.matrix.is_some() || self.quaternion.is_some()
    }

    /// The other ways that matrix and quaternion may go, where no word says which.
    pub(crate) fn other_ways(&self) -> Vec<Self> {
        let open = [
            self.matrix.is_some() && !self.said[0],
            self.quaternion.is_some() && !self.said[1],
        ];
        let flips = [[true, false], [false, true], [true, true]];
        let allowed = flips
            .into_iter()
            .filter(|f| f.iter().zip(&open).all(|(flip, open)| *open || !flip));
        allowed
            .map(|[matrix, quaternion]| {
                let mut other = self.clone();
                other.convention.matrix_to_body ^= matrix;
                other.convention.quaternion_to_body ^= quaternion;
                other
            })
            .collect()
    }

    /// In words, for the report.
    pub(crate) fn describe(&self) -> Vec<String> {
        let way = |to_body: bool| match to_body {
            true => "from components in space to components in the body",
            false => "from components in the body to components in space",
        };
        let matrix = self.matrix.iter().map(|letter| {
            format!(
                "{}: attitude matrix, {}",
                letter.name,
                way(self.convention.matrix_to_body)
            )
        });
        let layout = if self.scalar_last {
            "scalar last"
        } else {
            "scalar first"
        };
        let quaternion = self.quaternion.iter().map(|letter| {
            let to_body = self.convention.quaternion_to_body;
            format!(
                "{}: unit quaternion, {layout}, {}",
                letter.name,
                way(to_body)
            )
        });
        matrix.chain(quaternion).collect()
    }

    pub(crate) fn find_quaternion(
        &mut self,
        all: &[&Symbol],
        said: &[Sentence],
        taken: &impl Fn(&Letter) -> bool,
    ) {
        self.separate_letters(all, said);
        let named = |letter: &Letter| {
            let spoken =
                |s: &Sentence| s.text.contains("quaternion") && s.letters.contains(&letter.name);
            letter.name == "q" || said.iter().any(spoken) || numbered(letter, all)
        };
        let mut letters: Vec<Letter> = vec![];
        for symbol in all {
            let letter = Letter::of(symbol);
            let vector = matches!(
                letter.name.as_str(),
                "omega" | "Omega" | "v" | "r" | "R" | "I"
            );
            let part = self.part(symbol).is_some();
            if !vector && !part && !letters.contains(&letter) && !taken(&letter) && named(&letter) {
                letters.push(letter);
            }
        }
        // A q with three numbers may be Rodrigues', where another letter has four.
        let Some(letter) = letters
            .iter()
            .find(|l| numbered(l, all))
            .or(letters.iter().find(|l| l.name == "q"))
            .or(letters.first())
            .cloned()
        else {
            return;
        };
        self.scalar_last = all
            .iter()
            .any(|s| Letter::of(s) == letter && s.subscripts == ["4"]);
        let bare = all.iter().any(|s| {
            Letter::of(s) == letter && s.subscripts.is_empty() && !s.style.vector && !s.style.bar
        });
        let spoken = is_vector_part(&letter.name, said);
        for symbol in all.iter().filter(|s| Letter::of(s) == letter) {
            let index = match symbol.subscripts.as_slice() {
                [] => "",
                [one] => one.as_str(),
                _ => continue,
            };
            let part = match index {
                "" if symbol.style.vector && (bare || spoken) => Part::Vector,
                "" => Part::Whole,
                "0" | "w" | "s" | "r" | "4" => Part::Number(0),
                "1" | "x" => Part::Number(1),
                "2" | "y" => Part::Number(2),
                "3" | "z" => Part::Number(3),
                "v" | "vec" | "V" | "13" | "1:3" => Part::Vector,
                _ => continue,
            };
            self.parts.insert(spelling(symbol), part);
        }
        self.quaternion = Some(letter);
    }

    /// Four letters of their own: w, x, y, z.
    fn separate_letters(&mut self, all: &[&Symbol], said: &[Sentence]) {
        let families = [["w", "x", "y", "z"], ["a", "b", "c", "d"]];
        for family in families {
            let used = |name: &&str| {
                all.iter()
                    .any(|s| s.name == **name && s.subscripts.is_empty())
            };
            let spoken = |s: &Sentence| {
                let whole = has_any(&s.text, &["scalar part", "vector part", "quaternion"]);
                whole
                    && family
                        .iter()
                        .all(|name| s.letters.iter().any(|l| l == name))
            };
            if family.iter().all(used) && said.iter().any(spoken) {
                for (at, name) in family.iter().enumerate() {
                    let spelling = (Letter::plain(name), vec![], false);
                    self.parts.insert(spelling, Part::Number(at as u8));
                }
                self.quaternion = Some(Letter::plain(family[0]));
                return;
            }
        }
    }

    /// Columns and sums that show where the scalar stands, and that name the parts: `q = [η; ε]`.
    pub(crate) fn layout(&mut self, side: &Node) {
        let entries: Vec<&Node> = match &inner(side).kind {
            Kind::Matrix(rows) if rows.iter().all(|row| row.len() == 1) => {
                rows.iter().flatten().collect()
            }
            Kind::Tuple(entries) => entries.iter().collect(),
            _ => {
                return side.children().for_each(|child| self.layout(child));
            }
        };
        let part = |node: &Node| match &undotted(node).kind {
            Kind::Symbol(symbol) => self.part(symbol),
            _ => None,
        };
        let last = entries.len().saturating_sub(1);
        match entries
            .iter()
            .position(|e| part(e) == Some(Part::Number(0)))
        {
            Some(at) if at == last && last > 0 => self.scalar_last = true,
            _ => {}
        }
    }

    /// Directions and axes, from the words.
    fn listen(&mut self, said: &[Sentence], labelled: bool) {
        let mut axes = vec![];
        let mut before = [false, false];
        for sentence in said {
            let text = &sentence.text;
            let speaks = |letter: &Option<Letter>, word: &str| {
                let named = letter
                    .as_ref()
                    .is_some_and(|l| sentence.letters.contains(&l.name));
                named || text.contains(word)
            };
            let mut about = [
                speaks(&self.matrix, "matrix"),
                speaks(&self.quaternion, "quaternion"),
            ];
            if !about[0] && !about[1] && text.trim_start().starts_with("it ") {
                about = before;
            }
            before = about;
            if let Some(way) = way(text) {
                let to_body = way == Way::ToBody;
                if about[0] && !self.said[0] {
                    (self.convention.matrix_to_body, self.said[0]) = (to_body, true);
                }
                if about[1] && !self.said[1] {
                    (self.convention.quaternion_to_body, self.said[1]) = (to_body, true);
                }
            }
            axes.extend(rate_in_space(text));
        }
        // A label on another ω, or a word of body axes, leaves the plain letter on body axes.
        self.convention.rate_in_space =
            !labelled && !axes.is_empty() && axes.iter().all(|space| *space);
        // What is said of one holds for the other first; the document's lines may show that it does not.
        match self.said {
            [true, false] => {
                self.convention.quaternion_to_body = self.convention.matrix_to_body;
            }
            [false, true] => {
                self.convention.matrix_to_body = self.convention.quaternion_to_body;
            }
            _ => {}
        }
    }
}

/// Whether no symbol of these stands bare, and some wear a label of space axes and others one of the body's: `\omega_s`
/// beside `\omega_b`.
fn wear_labels<'s>(symbols: impl Iterator<Item = &'s &'s Symbol>) -> bool {
    let mut worn = [false, false];
    for symbol in symbols {
        let labels = |known: &[&str]| symbol.subscripts.iter().any(|s| known.contains(&s.trim()));
        match [labels(LETTERS) || labels(WORDS), labels(BODY)] {
            [false, false] => return false,
            [space, body] => worn = [worn[0] || space, worn[1] || body],
        }
    }
    worn == [true, true]
}

pub(super) fn spelling(symbol: &Symbol) -> Spelling {
    (
        Letter::of(symbol),
        symbol.subscripts.clone(),
        symbol.style.vector,
    )
}

/// Whether a letter has the indices 0 to 3, or 1 to 4.
fn numbered(letter: &Letter, all: &[&Symbol]) -> bool {
    let has = |index: &str| {
        all.iter()
            .any(|s| Letter::of(s) == *letter && s.subscripts == [index])
    };
    ["1", "2", "3"].into_iter().all(has) && (has("0") || has("4"))
}
