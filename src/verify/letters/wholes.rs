//! Symbols whose index is a part of their name, not the number of an axis: `\mathbf r_2`, the ω₁ after a step from ω₀.

use crate::notation::ast::{Factor, Kind, Line, Node, Operator, Symbol};
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::usage::{Letter, axis, inner, symbols};
use crate::verify::values::written_out::is_directed;
use std::collections::BTreeSet;

/// A letter and what is written under it.
type Name = (Letter, Vec<String>);

/// The symbols of a document whose index is a part of the name.
#[derive(Clone, Debug, Default)]
pub(crate) struct Wholes {
    /// Of any shape: `A_2 = [[…]]`.
    named: BTreeSet<Name>,
    /// Symbols that a line sets equal to a matrix of three rows and columns, or words call a tensor.
    grids: BTreeSet<Name>,
    /// Vectors among them that are told by a number.
    vectors: BTreeSet<Name>,
    /// Letters whose numbers go beyond the three of the axes: the rotors `Ω_1` to `Ω_4`.
    counted: BTreeSet<Letter>,
}

impl Wholes {
    /// Goes through every line of a document.
    pub(crate) fn of(document: &Document) -> Self {
        let mut wholes = Self::default();
        wholes.tensors_in_words(document);
        let mut met: Vec<&Symbol> = vec![];
        let mut used: Vec<&Symbol> = vec![];
        let mut summed: Vec<(Letter, &Symbol)> = vec![];
        let formulas = document.items.iter().filter_map(|item| match item {
            Item::Formula(formula) => Some(formula),
            _ => None,
        });
        for row in formulas.flat_map(|formula| &formula.rows) {
            match row {
                Row::Line(line) => {
                    wholes.line(line);
                    wholes.opposite(line);
                    wholes.stage(line);
                    met.extend(line.sides.iter().flat_map(symbols));
                    line.sides.iter().for_each(|side| crossed(side, &mut used));
                    line.sides
                        .iter()
                        .for_each(|side| beside_bare(side, &mut summed));
                    line.sides
                        .iter()
                        .for_each(|side| multiplied(side, &mut summed));
                    if line.sides.iter().flat_map(terms).any(is_cross) {
                        used.extend(line.sides.iter().flat_map(terms).filter_map(lone));
                    }
                }
                Row::Expression(node) => met.extend(symbols(node)),
                Row::Unreadable { .. } => {}
            }
        }
        let beyond = met.iter().filter(|s| is_beyond_axes(s));
        wholes.counted = beyond.map(|s| Letter::of(s)).collect();
        // The ω_0 of `ω - ω_0` is a vector where ω is one.
        let hatted = met.iter().copied().filter(|s| s.style.hat);
        let crossed: BTreeSet<Letter> = used
            .iter()
            .copied()
            .filter(|s| s.subscripts.is_empty())
            .chain(hatted)
            .map(Letter::of)
            .collect();
        let summed = summed
            .into_iter()
            .filter(|(letter, _)| crossed.contains(letter));
        used.extend(summed.map(|(_, symbol)| symbol));
        used.retain(|symbol| number(symbol).is_some() && !is_basis(symbol));
        for symbol in used {
            wholes.numbered(symbol, &met);
        }
        wholes
    }

    /// Whether the index of a symbol is a part of its name.
    pub(crate) fn names(&self, symbol: &Symbol) -> bool {
        let name = (Letter::of(symbol), symbol.subscripts.clone());
        self.named.contains(&name) || self.vectors.contains(&name) || self.counts(symbol)
    }

    /// Whether the number under a symbol only tells it from others, and is that of no axis.
    pub(crate) fn counts(&self, symbol: &Symbol) -> bool {
        let digit = number(symbol).is_some_and(|n| n.len() == 1);
        digit && self.counted.contains(&Letter::of(symbol))
    }

    /// Whether a symbol is a vector that a number tells from others of its letter.
    pub(crate) fn is_vector(&self, symbol: &Symbol) -> bool {
        let name = (Letter::of(symbol), symbol.subscripts.clone());
        self.vectors.contains(&name)
    }

    /// Whether a symbol is a matrix of three rows and columns.
    pub(crate) fn is_grid(&self, symbol: &Symbol) -> bool {
        let name = (Letter::of(symbol), symbol.subscripts.clone());
        self.grids.contains(&name)
    }

    /// "The inertia tensor $I_C$", "$I_b$ is the tensor".
    fn tensors_in_words(&mut self, document: &Document) {
        let tensor = |text: &str| {
            let text = text.to_lowercase();
            let called = |words: &&str| text.trim_end().ends_with(*words);
            ["tensor", "inertia matrix"].iter().any(called)
        };
        let behind = |text: &str| {
            let clause = text.split(['.', ';', ',']).next().unwrap_or_default();
            let is = [" is the ", " denotes the "].iter();
            is.filter_map(|verb| text.strip_prefix(verb))
                .next()
                .is_some()
                && clause.contains("inertia tensor")
        };
        for (at, item) in document.items.iter().enumerate() {
            let Item::Formula(formula) = item else {
                continue;
            };
            let [Row::Expression(node)] = formula.rows.as_slice() else {
                continue;
            };
            let prose = |at: Option<usize>| match at.and_then(|at| document.items.get(at)) {
                Some(Item::Prose { text, .. }) => text.as_str(),
                _ => "",
            };
            let named = tensor(prose(at.checked_sub(1))) || behind(prose(Some(at + 1)));
            if let Kind::Symbol(symbol) = &inner(node).kind
                && named
            {
                self.grids
                    .insert((Letter::of(symbol), symbol.subscripts.clone()));
            }
        }
    }

    fn line(&mut self, line: &Line) {
        let [left, rest @ ..] = line.sides.as_slice() else {
            return;
        };
        let (Kind::Symbol(symbol), Some(right)) = (&inner(left).kind, rest.first()) else {
            return;
        };
        let grid = rest.iter().any(is_grid);
        let square = |rows: &[Vec<Node>]| rows.len() == 3 && rows.iter().all(|r| r.len() == 3);
        if matches!(&inner(right).kind, Kind::Matrix(rows) if square(rows)) {
            self.grids
                .insert((Letter::of(symbol), symbol.subscripts.clone()));
        }
        let indexed = symbol.subscripts.iter().any(|s| axis(s).is_some());
        let square = is_square_of(right, &Letter::of(symbol));
        if indexed && (grid || square || symbol.style.vector && is_directed(right, symbol)) {
            self.named
                .insert((Letter::of(symbol), symbol.subscripts.clone()));
        }
    }

    /// `r_2 = -r_1`, where r₁ was written out: both are wholes.
    fn opposite(&mut self, line: &Line) {
        let [left, right] = line.sides.as_slice() else {
            return;
        };
        let right = match &inner(right).kind {
            Kind::Negate(inside) => inside,
            _ => right,
        };
        let (Kind::Symbol(one), Kind::Symbol(other)) = (&inner(left).kind, &inner(right).kind)
        else {
            return;
        };
        let name = |s: &Symbol| (Letter::of(s), s.subscripts.clone());
        if name(one).0 == name(other).0 && self.named.contains(&name(other)) {
            self.named.insert(name(one));
        }
    }

    /// `k_1 = f(\omega_n)`: a slope of the rates, one of the stages of a step.
    fn stage(&mut self, line: &Line) {
        let [left, right, ..] = line.sides.as_slice() else {
            return;
        };
        let (Kind::Symbol(symbol), Kind::Call(head, arguments)) =
            (&inner(left).kind, &inner(right).kind)
        else {
            return;
        };
        let rates = |s: &&Symbol| matches!(s.name.as_str(), "omega" | "w" | "x");
        let whole = |s: &Symbol| s.subscripts.iter().all(|index| axis(index).is_none());
        let of_rates = arguments
            .iter()
            .flat_map(symbols)
            .find(rates)
            .is_some_and(whole);
        let function = matches!(&inner(head).kind, Kind::Symbol(f) if f.subscripts.is_empty());
        if of_rates && function && number(symbol).is_some() && !rates(&symbol) {
            self.vectors
                .insert((Letter::of(symbol), symbol.subscripts.clone()));
        }
    }

    /// Takes in a symbol with a number that is used as a vector, and with it the others of its letter.
    fn numbered(&mut self, symbol: &Symbol, met: &[&Symbol]) {
        let letter = Letter::of(symbol);
        let same: Vec<&Symbol> = met
            .iter()
            .copied()
            .filter(|s| Letter::of(s) == letter)
            .collect();
        let marked = |s: &Symbol| s.style.vector || s.style.bar;
        let plain = |s: &Symbol| {
            same.iter()
                .any(|o| !marked(o) && o.subscripts == s.subscripts)
        };
        let axes = ["3", "x", "y", "z"];
        let components = same
            .iter()
            .flat_map(|s| &s.subscripts)
            .any(|s| axes.contains(&s.as_str()));
        // ω₁ is the value after a step only beside an ω₀, and where no ω₃ is met.
        let steps = |s: &Symbol| number(s).is_some_and(|n| axis(n).is_none());
        let stepped = !components && same.iter().any(|s| steps(s));
        for other in same.iter().filter(|s| number(s).is_some()) {
            let whole = match (marked(symbol), marked(other)) {
                (true, true) => steps(other) || !plain(other),
                (false, false) => stepped || steps(other),
                _ => false,
            };
            if whole {
                let name = (letter.clone(), other.subscripts.clone());
                self.vectors.insert(name);
            }
        }
    }
}

/// Whether a node is the square of a letter's vector, which programs call L2: `dot(L, L)`, `|L|^2`, `L^T L`.
fn is_square_of(node: &Node, letter: &Letter) -> bool {
    let own = |node: &Node| matches!(&inner(node).kind, Kind::Symbol(s) if s.subscripts.is_empty() && Letter::of(s) == *letter);
    match &inner(node).kind {
        Kind::Product(factors) => match factors.as_slice() {
            [first, second] => {
                let row = match &inner(&first.node).kind {
                    Kind::Transpose(inside) => own(inside),
                    _ => second.operator == Operator::Dot && own(&first.node),
                };
                row && own(&second.node)
            }
            _ => false,
        },
        Kind::Power(base, exponent) => {
            let base = match &inner(base).kind {
                Kind::Norm(inside) => inside,
                _ => base,
            };
            let two = matches!(&exponent.kind, Kind::Number(n) if n.value == num_rational::BigRational::from_integer(2.into()));
            two && own(base)
        }
        _ => false,
    }
}

/// The number under a symbol, if that is all that is written there: 0, 1, 1/2.
fn number(symbol: &Symbol) -> Option<&str> {
    let [index] = symbol.subscripts.as_slice() else {
        return None;
    };
    let digits = index.chars().all(|c| c.is_ascii_digit() || c == '/');
    (digits && !index.is_empty()).then_some(index)
}

/// Whether the number under a plain letter is more than that of the last axis; of a quaternion there are four.
fn is_beyond_axes(symbol: &Symbol) -> bool {
    let quaternion = [
        "q",
        "e",
        "epsilon",
        "varepsilon",
        "beta",
        "lambda",
        "eta",
        "p",
    ];
    number(symbol).is_some_and(|n| matches!(n, "4" | "5" | "6" | "7" | "8" | "9"))
        && !symbol.style.vector
        && !quaternion.contains(&symbol.name.as_str())
}

/// Whether a symbol is a unit vector of some axes: `\mathbf e_1`.
fn is_basis(symbol: &Symbol) -> bool {
    let names = ["e", "b", "n", "u", "E", "i", "j", "k"];
    symbol.style.hat || names.contains(&symbol.name.as_str())
}

/// The symbols that stand beside a ×, alone or in a sum.
fn crossed<'a>(node: &'a Node, found: &mut Vec<&'a Symbol>) {
    match &node.kind {
        Kind::Product(factors) => {
            let operands: Vec<&[Factor]> = factors
                .chunk_by(|_, next| next.operator != Operator::Cross)
                .collect();
            if operands.len() > 1 {
                // In `ω × I₁ ω` the vector is the product, unless a mark says that the first factor is one.
                let vectors = operands.iter().flat_map(|operand| match operand {
                    [only] => terms(&only.node),
                    [first, .., last] => [&first.node, &last.node]
                        .into_iter()
                        .filter(|end| lone(end).is_some_and(|symbol| symbol.style.vector))
                        .collect(),
                    [] => vec![],
                });
                found.extend(vectors.filter_map(lone));
            }
        }
        Kind::Skew(operand) => found.extend(terms(operand).into_iter().filter_map(lone)),
        _ => {}
    }
    node.children().for_each(|child| crossed(child, found));
}

/// The symbols with a number that stand in a sum with their own letter bare.
fn beside_bare<'a>(node: &'a Node, found: &mut Vec<(Letter, &'a Symbol)>) {
    if let Kind::Sum(_) = &node.kind {
        let all: Vec<&Symbol> = terms(node).into_iter().filter_map(lone).collect();
        let bare = all
            .iter()
            .filter(|s| s.subscripts.is_empty() && s.primes == 0);
        for letter in bare.map(|s| Letter::of(s)) {
            let same = all
                .iter()
                .filter(|s| Letter::of(s) == letter && number(s).is_some());
            found.extend(same.map(|s| (letter.clone(), *s)));
        }
    }
    node.children().for_each(|child| beside_bare(child, found));
}

/// The symbols of one letter that stand in a sum with a 0 under one of them, and are multiplied together: `J(\omega_1 - \omega_0)`.
fn multiplied<'a>(node: &'a Node, found: &mut Vec<(Letter, &'a Symbol)>) {
    // `J(\omega_1 - \omega_0)` may be read as a call.
    let factors: Vec<&Node> = match &node.kind {
        Kind::Product(factors) => factors.iter().map(|factor| &factor.node).collect(),
        Kind::Call(_, arguments) => arguments.iter().collect(),
        _ => vec![],
    };
    for factor in factors {
        let terms = terms(factor);
        let all: Vec<&Symbol> = terms.iter().filter_map(|term| lone(term)).collect();
        let one = all
            .windows(2)
            .all(|pair| Letter::of(pair[0]) == Letter::of(pair[1]));
        let begins = all.iter().any(|s| number(s) == Some("0"));
        if terms.len() > 1 && all.len() == terms.len() && one && begins {
            found.extend(all.into_iter().map(|s| (Letter::of(s), s)));
        }
    }
    node.children().for_each(|child| multiplied(child, found));
}

/// The terms of a sum, or the node itself.
pub(crate) fn terms(node: &Node) -> Vec<&Node> {
    match &inner(node).kind {
        Kind::Sum(terms) => terms.iter().map(|term| inner(&term.node)).collect(),
        _ => vec![inner(node)],
    }
}

/// Whether a term is a product with a ×, and not with a dot as well.
pub(super) fn is_cross(node: &Node) -> bool {
    let Kind::Product(factors) = &node.kind else {
        return false;
    };
    let has = |operator| factors.iter().any(|f| f.operator == operator);
    has(Operator::Cross) && !has(Operator::Dot)
}

/// The symbol that a term is, but for its sign and dots.
pub(super) fn lone(node: &Node) -> Option<&Symbol> {
    match &inner(node).kind {
        Kind::Symbol(symbol) => Some(symbol),
        Kind::Negate(inside) => lone(inside),
        Kind::TimeDerivative { operand, .. } => lone(operand),
        _ => None,
    }
}

/// Whether a side is written out row by row, with a number before it perhaps: `\frac{1}{\sqrt 5} [1, 2, 0]^T`.
fn is_grid(side: &Node) -> bool {
    match &inner(side).kind {
        Kind::Matrix(rows) => rows.len() > 1,
        Kind::Tuple(entries) => entries.len() == 3,
        Kind::Quotient(above, below) => is_grid(above) && symbols(below).is_empty(),
        Kind::Product(factors) => {
            let grids = factors.iter().filter(|factor| is_grid(&factor.node));
            // `b*(sin g, 0, cos g)`; a point between two vectors makes a number of them.
            let plain = |factor: &&Factor| {
                let met = symbols(&factor.node);
                met.iter().all(|symbol| !symbol.style.vector)
            };
            let number = |f: &Factor| f.operator == Operator::Dot && !symbols(&f.node).is_empty();
            !factors.iter().any(number)
                && grids.count() == 1
                && factors
                    .iter()
                    .filter(|f| !is_grid(&f.node))
                    .all(|f| plain(&f))
        }
        _ => false,
    }
}
