//! How the letters of a document are used: with marks of a vector, with indices, under a dot.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::applied::applied;
use crate::verify::letters::wholes::Wholes;
use std::collections::{BTreeMap, BTreeSet};

/// A letter as people tell letters apart: `L` and `𝓛` are two.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Letter {
    /// Its name.
    pub name: String,
    /// Whether it is calligraphic.
    pub calligraphic: bool,
}

impl Letter {
    /// The letter of a symbol.
    pub(crate) fn of(symbol: &Symbol) -> Self {
        Self {
            name: symbol.name.clone(),
            calligraphic: symbol.style.calligraphic,
        }
    }

    /// A plain letter.
    pub(crate) fn plain(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            calligraphic: false,
        }
    }
}

/// What is seen of a letter in the whole document.
#[derive(Clone, Debug, Default)]
pub(crate) struct Use {
    /// Times with a mark of a vector, or as a factor of a cross product.
    pub vector: usize,
    /// Times with a mark of a tensor.
    pub tensor: usize,
    /// Times with one index of a component.
    pub component: usize,
    /// Times with two indices.
    pub double: usize,
    /// Times with neither mark nor index.
    pub bare: usize,
    /// Times with the mark of a vector and a hat.
    pub hatted: usize,
    /// Times without any index, a word or a point included.
    pub naked: usize,
    /// Under a hat alone.
    pub hats: usize,
    /// Times as a factor of a cross product without a mark.
    pub crossed_bare: usize,
    /// Times as a resultant: ΣM, ΣF.
    pub resultant: usize,
    /// Whether it stands under a derivative in time, or is called with `t`.
    pub moving: bool,
}

impl Use {
    /// Whether it is a vector or a tensor anywhere, or a component of one.
    pub(crate) fn is_directed(&self) -> bool {
        self.vector + self.tensor + self.component + self.double > 0
    }
}

/// The uses of all letters.
#[derive(Clone, Debug, Default)]
pub(crate) struct Usage {
    pub(crate) letters: BTreeMap<Letter, Use>,
    /// Subscripts met on each letter.
    pub subscripts: BTreeMap<Letter, BTreeSet<String>>,
    /// Letters with `(t)` behind them.
    pub functions_of_time: BTreeSet<Letter>,
    /// Superscripts met on each letter.
    pub(crate) superscripts: BTreeMap<Letter, BTreeSet<Vec<String>>>,
    /// Letters with subscripts and superscripts that stand under a derivative in time.
    pub(crate) moving: BTreeSet<(Letter, Vec<String>, Vec<String>)>,
    /// Symbols whose index is a part of their name.
    pub wholes: Wholes,
    /// Letters that are something else under a tilde: they stand alone or in a sum with it.
    pub apart_under_tilde: BTreeSet<Letter>,
    /// Letters that without mark or index are the length of their vector: `L = |L|`.
    pub lengths: BTreeSet<Letter>,
    /// Letters of vectors that without a mark are numbers: `\boldsymbol\omega = \omega\,\mathbf k`.
    pub(crate) numbers: BTreeSet<Letter>,
    /// Lists of three plain letters: `[p, q, r]^T`.
    pub(crate) lists: BTreeSet<[String; 3]>,
    /// Letters that a line says to be such a list.
    pub(crate) listed: Vec<(Letter, [String; 3])>,
    /// Letters that stand with a prime and no index: `J'`.
    pub(crate) primed: BTreeSet<Letter>,
    /// Rows of the square matrices that letters without an index are set against, other than three.
    pub(crate) squares: BTreeMap<Letter, u8>,
    /// Letters of such matrices with a minus beside the diagonal.
    pub(crate) negated: BTreeSet<Letter>,
    /// Letters with the mark of a vector that lines apply to vectors.
    pub(crate) applied: BTreeSet<Letter>,
    /// Whether a vector k stands beside numbered unit vectors, and no i and j do.
    pub k_alone: bool,
    /// Whether the plain letters i, j, k are written for unit vectors: `w_x i + w_y j + w_z k`.
    pub plain_units: bool,
    /// Whether vectors called x, y, z are the unit vectors: `p\vec x + q\vec y + r\vec z`.
    pub vectors_xyz: bool,
    /// Letters without an index that stand under a derivative, each with the letter it is taken in.
    pub(crate) differentiated: Vec<(Letter, Letter)>,
    /// Letters that stand beside themselves behind that of a matrix, which comes first: `\omega' = R\omega`.
    pub(crate) turned: Vec<[Letter; 2]>,
    /// Symbols with two indices and something else besides: `I_{s,xx}`, `I'_{xx}`.
    pub(crate) entries: Vec<Symbol>,
    /// Symbols with a δ before them.
    pub(crate) varied: Vec<Symbol>,
    /// Letters of right sides, each with the letter that it is called with: `f(\omega)`.
    pub(crate) called: Vec<(Letter, Letter)>,
    /// A letter without mark or index beside one of its components: `ω_z = ω`.
    pub components_named: BTreeMap<Letter, u8>,
}

/// The index of an axis: `x`, `1` → 0 and so on.
pub(crate) fn axis(index: &str) -> Option<u8> {
    match index {
        "x" | "1" => Some(0),
        "y" | "2" => Some(1),
        "z" | "3" => Some(2),
        _ => None,
    }
}

/// Row and column of a double index, of one family: `xy`, `12`.
pub(crate) fn axes(index: &str) -> Option<(u8, u8)> {
    let mut characters = index.chars().filter(|c| !c.is_whitespace() && *c != ',');
    let (first, second) = (characters.next()?, characters.next()?);
    let one_family = first.is_ascii_digit() == second.is_ascii_digit();
    if characters.next().is_some() || !one_family {
        return None;
    }
    Some((
        axis(first.encode_utf8(&mut [0; 4]))?,
        axis(second.encode_utf8(&mut [0; 4]))?,
    ))
}

impl Usage {
    /// Goes through every formula of a document.
    pub(crate) fn of(document: &Document) -> Self {
        let mut usage = Self {
            wholes: Wholes::of(document),
            ..Self::default()
        };
        for item in &document.items {
            let Item::Formula(formula) = item else {
                continue;
            };
            for row in &formula.rows {
                match row {
                    Row::Line(line) => usage.line(line),
                    Row::Expression(node) => usage.node(node),
                    Row::Unreadable { .. } => {}
                }
            }
        }
        usage.applied = applied(document);
        usage.angles_of_a_list();
        usage.columns_of_functions();
        usage.turned_columns();
        let vector = |name: &str| usage.get(&Letter::plain(name)).vector > 0;
        let mut bases = ["e", "b", "u", "a"].iter().map(|name| Letter::plain(name));
        let numbered = |letter: Letter| ["1", "2", "3"].iter().all(|i| usage.has_index(&letter, i));
        let alone = vector("k") && !vector("i") && !vector("j") && bases.any(numbered);
        usage.k_alone = alone;
        usage
    }

    /// What is seen of a letter.
    pub(crate) fn get(&self, letter: &Letter) -> Use {
        self.letters.get(letter).cloned().unwrap_or_default()
    }

    /// The letters, in alphabetical order.
    pub(crate) fn letters(&self) -> impl Iterator<Item = (&Letter, &Use)> {
        self.letters.iter()
    }

    /// Whether a letter stands for a vector where nothing is written on it.
    pub(crate) fn is_vector(&self, letter: &Letter) -> bool {
        // Beside the unit vectors x, y, z the bare letters are coordinates.
        let coordinate = self.vectors_xyz && matches!(letter.name.as_str(), "x" | "y" | "z");
        !coordinate && self.letters.get(letter).is_some_and(|u| u.vector > 0)
    }

    /// Whether this symbol, subscripts and all, is differentiated in time somewhere.
    pub(crate) fn moves(&self, symbol: &Symbol) -> bool {
        self.moving.contains(&worn(symbol))
    }

    /// Whether superscripts tell apart what a letter stands for.
    pub(crate) fn is_labelled(&self, letter: &Letter) -> bool {
        self.superscripts
            .get(letter)
            .is_some_and(|met| met.len() > 1)
    }

    /// The angle that moves, where there is one and only one.
    pub(crate) fn only_angle(&self) -> Option<Letter> {
        let angle = |l: &&Letter| {
            let names = ["theta", "phi", "psi", "varphi", "vartheta"];
            names.contains(&l.name.as_str()) && self.get(l).moving && self.get(l).bare > 0
        };
        let mut found = self.letters.keys().filter(angle);
        let first = found.next()?;
        found.next().is_none().then(|| first.clone())
    }

    /// Whether some letter has components on axes with primes.
    pub(crate) fn has_primed_axes(&self) -> bool {
        let primed = |s: &String| s.contains('\'') && s.starts_with(['x', 'y', 'z']);
        self.subscripts.values().flatten().any(primed)
    }

    /// Whether a letter is met with a subscript.
    pub(crate) fn has_index(&self, letter: &Letter, index: &str) -> bool {
        self.subscripts
            .get(letter)
            .is_some_and(|met| met.contains(index))
    }

    /// Whether velocities or accelerations of a mass centre are met: `\mathbf a_G`.
    pub(crate) fn speaks_of_a_centre(&self) -> bool {
        let centre = |index| {
            ["a", "v"]
                .iter()
                .any(|name| self.has_index(&Letter::plain(name), index))
        };
        ["G", "c", "C", "cm", "CM"].into_iter().any(centre)
    }

    /// Whether a letter is met with a double index of letters: `I_{xx}`.
    pub(crate) fn has_lettered_entries(&self, letter: &Letter) -> bool {
        let lettered = |s: &String| axes(s).is_some() && s.starts_with(['x', 'y', 'z']);
        self.subscripts
            .get(letter)
            .is_some_and(|met| met.iter().any(lettered))
    }

    /// Whether the z under a letter is the vertical: beside a vector k and numbered unit vectors, or where the angular
    /// velocity has the components 1, 2, 3, or the unit vectors these numbers, and the letter no other than this one.
    pub(crate) fn z_is_vertical(&self, letter: &Letter) -> bool {
        let (omega, unit) = (Letter::plain("omega"), Letter::plain("e"));
        let all = |letter: &Letter| ["1", "2", "3"].iter().all(|a| self.has_index(letter, a));
        let any = |letter: &Letter, axes: &[&str]| axes.iter().any(|a| self.has_index(letter, a));
        let units = all(&unit) && !any(&unit, &["0", "x", "y", "z"]);
        let numbered = (all(&omega) || units) && !any(&omega, &["x", "y", "z"]);
        self.k_alone || numbered && !any(letter, &["1", "2", "3", "x", "y"])
    }

    /// Whether symbols stand for values before and behind a step: `\omega_{k+1}`.
    pub(crate) fn counts_steps(&self) -> bool {
        let mut met = self.subscripts.values().flatten();
        met.any(|label| label.contains('+'))
    }

    /// Whether three plain letters are listed as the components of a vector.
    pub(crate) fn lists(&self, names: [&str; 3]) -> bool {
        self.lists.contains(&names.map(str::to_owned))
    }

    /// Whether a letter always wears these superscripts, so that they tell nothing apart: ᴺωᴮ.
    pub(crate) fn always_wears(&self, letter: &Letter, superscripts: &[String]) -> bool {
        self.superscripts
            .get(letter)
            .is_some_and(|met| met.len() == 1 && met.iter().all(|s| s == superscripts))
    }
}

/// A letter with all that is written beside it.
pub(crate) fn worn(symbol: &Symbol) -> (Letter, Vec<String>, Vec<String>) {
    (
        Letter::of(symbol),
        symbol.subscripts.clone(),
        symbol.superscripts.clone(),
    )
}

/// A node without the brackets around it.
pub(crate) fn inner(node: &Node) -> &Node {
    match &node.kind {
        Kind::Group(_, inside) => inner(inside),
        _ => node,
    }
}

/// A node without the brackets and the dots on it.
pub(crate) fn undotted(node: &Node) -> &Node {
    match &inner(node).kind {
        Kind::TimeDerivative { operand, .. } => undotted(operand),
        _ => inner(node),
    }
}

/// All symbols of a node, from left to right.
pub(crate) fn symbols(node: &Node) -> Vec<&Symbol> {
    fn collect<'n>(node: &'n Node, found: &mut Vec<&'n Symbol>) {
        match &node.kind {
            Kind::Symbol(symbol) => found.push(symbol),
            _ => node.children().for_each(|child| collect(child, found)),
        }
    }
    let mut found = Vec::with_capacity(8);
    collect(node, &mut found);
    found
}
