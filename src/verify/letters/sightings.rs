//! What the formulas of a document show of the letters in them.

use crate::notation::ast::{Factor, Function, Kind, Line, Node, Operator, Symbol};
use crate::verify::letters::skew_marks::is_rate_of_turn;
use crate::verify::letters::usage::{Letter, Usage, axes, axis, inner, symbols, worn};
use crate::verify::letters::wholes::{is_cross, lone, terms};
use crate::verify::lines::index::is_equality;
use crate::verify::values::written_out::{along_plain_units, along_vectors_xyz, plain_list};

impl Usage {
    pub(crate) fn line(&mut self, line: &Line) {
        for side in &line.sides {
            self.node(side);
        }
        self.lists.extend(line.sides.iter().filter_map(plain_list));
        if let [left, list] = line.sides.as_slice()
            && let (Kind::Symbol(whole), Some(names)) = (&inner(left).kind, plain_list(list))
        {
            self.listed.push((Letter::of(whole), names));
        }
        self.plain_units |= line.sides.iter().any(|side| along_plain_units(inner(side)));
        self.vectors_xyz |= line.sides.iter().any(|side| along_vectors_xyz(inner(side)));
        let square = |side: &Node| matches!(inner(side).kind, Kind::Matrix(_) | Kind::Skew(_));
        if !line.sides.iter().any(square) {
            line.sides.iter().for_each(|side| self.under_tilde(side));
        }
        // What is set against a column is a vector, and against a square of numbers a tensor.
        for pair in line.sides.windows(2) {
            if let (Kind::Symbol(symbol), Some(columns)) =
                (&inner(&pair[0]).kind, columns(&pair[1]))
                && !symbol.style.tilde
            {
                let used = self.letters.entry(Letter::of(symbol)).or_default();
                match columns {
                    1 if is_long(&pair[1]) => {}
                    1 => {
                        used.vector += 1;
                        used.hatted += usize::from(symbol.style.vector && symbol.style.hat);
                    }
                    _ => used.tensor += 1,
                }
            }
        }
        if let Some(Kind::Symbol(symbol)) = line.sides.first().map(|side| &called(side).kind)
            && symbol.subscripts.is_empty()
            && let Some(rows) = line.sides.iter().find_map(square_of)
        {
            self.squares.insert(Letter::of(symbol), rows);
            if line.sides.iter().any(has_minus_beside_diagonal) {
                self.negated.insert(Letter::of(symbol));
            }
        }
        // Of `P(t) = e^{At} = [...]` too.
        if let [first, _, rest @ ..] = line.sides.as_slice()
            && let Kind::Symbol(symbol) = &called(first).kind
            && rest.iter().any(|side| columns(side).is_some_and(|n| n > 1))
        {
            self.letters.entry(Letter::of(symbol)).or_default().tensor += 1;
        }
        self.beside_a_cross(line);
        self.named_components(line);
        for pair in line.sides.windows(2) {
            self.turned_column(&pair[0], &pair[1]);
            self.along_a_unit(&pair[0], &pair[1]);
            self.named_length(&pair[0], &pair[1]);
        }
    }

    /// What is added to a cross product, or is equal to one, is a vector: the N of `dH/dt + w x H = N`.
    fn beside_a_cross(&mut self, line: &Line) {
        let of_numbers = |node: &Node| {
            let mut factors = node.children();
            factors.any(|factor| symbols(factor).is_empty())
        };
        let mut all = line.sides.iter().flat_map(terms);
        if all.any(|term| is_cross(term) && !of_numbers(term) || applies_skew(term)) {
            let lone = line.sides.iter().flat_map(terms).filter_map(lone);
            let bare = lone.filter(|symbol| symbol.subscripts.is_empty() && !symbol.style.vector);
            for symbol in bare {
                let entry = self.letters.entry(Letter::of(symbol)).or_default();
                entry.vector += 1;
                entry.crossed_bare += 1;
            }
        }
    }

    /// The angles of a list move where the list does: those of `η = [φ, θ, ψ]^T`, under the dot of `ω = T \dot η`.
    pub(super) fn angles_of_a_list(&mut self) {
        for (whole, names) in std::mem::take(&mut self.listed) {
            let angles = names.iter().all(|name| name.len() > 1);
            if angles && self.get(&whole).moving {
                for name in &names {
                    self.letters.entry(Letter::plain(name)).or_default().moving = true;
                }
            }
        }
    }

    /// Notes letters with a tilde that are a side or a term.
    fn under_tilde(&mut self, side: &Node) {
        match &inner(side).kind {
            Kind::Symbol(symbol) if symbol.style.tilde => {
                self.apart_under_tilde.insert(Letter::of(symbol));
            }
            Kind::Sum(terms) => terms.iter().for_each(|term| self.under_tilde(&term.node)),
            _ => {}
        }
    }

    /// What the equalities of a line name; a bound names nothing.
    fn named_components(&mut self, line: &Line) {
        let pairs = line.sides.windows(2).zip(&line.relations);
        for (pair, _) in pairs.filter(|(_, (relation, _))| is_equality(*relation)) {
            self.named_component(&pair[0], &pair[1]);
            self.named_component(&pair[1], &pair[0]);
        }
    }

    /// `L = |L|`: the bare letter is the length.
    fn named_length(&mut self, bare: &Node, length: &Node) {
        let (Kind::Symbol(bare), Kind::Norm(inside)) = (&inner(bare).kind, &inner(length).kind)
        else {
            return;
        };
        let of_its_own = matches!(&inner(inside).kind, Kind::Symbol(s) if s.name == bare.name && s.subscripts.is_empty());
        if of_its_own && !bare.style.vector && bare.subscripts.is_empty() {
            self.lengths.insert(Letter::of(bare));
        }
    }

    /// `ω_z = ω`: the bare letter is that component.
    fn named_component(&mut self, whole: &Node, part: &Node) {
        let (Kind::Symbol(bare), Kind::Symbol(component)) = (&inner(whole).kind, &inner(part).kind)
        else {
            return;
        };
        let unmarked = !bare.style.vector && bare.subscripts.is_empty();
        let index = component.subscripts.iter().find_map(|s| axis(s));
        if let (true, Some(index)) = (unmarked && bare.name == component.name, index) {
            self.components_named.insert(Letter::of(bare), index);
        }
    }

    /// `\boldsymbol\omega = \omega\,\mathbf k`: the bare letter is a number.
    fn along_a_unit(&mut self, whole: &Node, along: &Node) {
        let (Kind::Symbol(whole), Kind::Product(factors)) =
            (&inner(whole).kind, &inner(along).kind)
        else {
            return;
        };
        if let [bare, unit] = factors.as_slice()
            && let (Kind::Symbol(bare), Kind::Symbol(unit)) = (&bare.node.kind, &unit.node.kind)
            && (unit.style.hat || unit.style.vector)
            && whole.style.vector
            && !bare.style.vector
            && (&bare.name, &bare.subscripts) == (&whole.name, &whole.subscripts)
        {
            self.numbers.insert(Letter::of(bare));
        }
    }

    pub(crate) fn node(&mut self, node: &Node) {
        match &node.kind {
            Kind::Symbol(symbol) => self.symbol(symbol),
            Kind::TimeDerivative { operand, .. } => {
                self.moving(operand);
                self.node(operand);
            }
            Kind::Call(head, arguments) => {
                if arguments
                    .iter()
                    .any(|a| matches!(&a.kind, Kind::Symbol(s) if s.name == "t"))
                {
                    self.moving(head);
                    if let Kind::Symbol(symbol) = &inner(head).kind {
                        self.functions_of_time.insert(Letter::of(symbol));
                    }
                }
                self.called(head, arguments);
                self.node(head);
                arguments.iter().for_each(|a| self.node(a));
            }
            Kind::Skew(operand) => {
                self.vector_operand(operand);
                self.node(operand);
            }
            Kind::Transpose(operand) => {
                self.transposed(operand);
                self.node(operand);
            }
            Kind::Function(Function::Det, operand) => {
                if let Kind::Symbol(symbol) = &inner(operand).kind {
                    self.letters.entry(Letter::of(symbol)).or_default().tensor += 1;
                }
                self.node(operand);
            }
            Kind::Derivative {
                operand, variables, ..
            } => {
                self.derived(operand, variables);
                let children = node.children();
                children.for_each(|child| self.node(child));
            }
            Kind::Power(base, exponent) => {
                self.cubed(base, exponent);
                self.node(base);
                self.node(exponent);
            }
            Kind::Product(factors) => {
                self.crossed(factors);
                factors.iter().for_each(|factor| self.node(&factor.node));
            }
            _ => node.children().for_each(|child| self.node(child)),
        }
    }

    /// Nobody transposes a number: the ω of `\omega^T I\,\omega` is a vector.
    fn transposed(&mut self, operand: &Node) {
        if let Kind::Symbol(symbol) = &inner(operand).kind {
            let used = self.letters.entry(Letter::of(symbol)).or_default();
            match symbol.name.as_str() {
                "omega" | "Omega" | "w" | "L" | "H" | "h" | "M" | "tau" => used.vector += 1,
                "I" | "J" | "Theta" => used.tensor += 1,
                _ => {}
            }
        }
    }

    /// Of a vector no third power is taken: the R of `R^3` beside a vector **R** is its length.
    fn cubed(&mut self, base: &Node, exponent: &Node) {
        let high = matches!(&exponent.kind, Kind::Number(n) if n.value > two());
        if let Kind::Symbol(symbol) = &inner(base).kind
            && high
            && !symbol.style.vector
            && symbol.subscripts.is_empty()
        {
            self.lengths.insert(Letter::of(symbol));
        }
    }

    fn moving(&mut self, operand: &Node) {
        // Nobody differentiates a sum with a constant in it: of `\frac{d}{dt}(s + p\cos\theta)` the s moves.
        if let Kind::Sum(terms) = &inner(operand).kind {
            for term in terms {
                if let Kind::Symbol(symbol) = &inner(&term.node).kind
                    && !symbol.style.vector
                {
                    self.moving(&term.node);
                }
            }
        }
        if let Kind::Symbol(symbol) = &inner(operand).kind {
            self.letters.entry(Letter::of(symbol)).or_default().moving = true;
            self.moving.insert(worn(symbol));
        }
    }

    /// The factors beside a × are vectors, other than the ℓ of `\mathbf k\times\ell\,\mathbf i`.
    fn crossed(&mut self, factors: &[Factor]) {
        let operands: Vec<&[Factor]> = factors
            .chunk_by(|_, next| next.operator != Operator::Cross)
            .collect();
        for (i, operand) in operands.iter().enumerate() {
            let marked = |f: &Factor| matches!(&inner(&f.node).kind, Kind::Symbol(s) if s.style.vector || s.style.hat);
            // What stands behind a ∇ is no vector either.
            let directed = |f: &Factor| marked(f) || matches!(f.node.kind, Kind::Error(_));
            let ends = [
                operand.first().filter(|_| i > 0),
                operand.last().filter(|_| i + 1 < operands.len()),
            ];
            for end in ends.into_iter().flatten() {
                if marked(end) || !operand.iter().any(directed) {
                    self.vector_operand(&end.node);
                }
            }
        }
    }

    fn vector_operand(&mut self, operand: &Node) {
        if let Kind::Symbol(symbol) = &inner(operand).kind
            && symbol.subscripts.iter().all(|s| axis(s).is_none())
        {
            let entry = self.letters.entry(Letter::of(symbol)).or_default();
            entry.vector += 1;
            entry.hatted += usize::from(symbol.style.vector && symbol.style.hat);
            entry.crossed_bare += usize::from(!symbol.style.vector && !symbol.style.bar);
        }
    }

    fn symbol(&mut self, symbol: &Symbol) {
        self.keep_marked(symbol);
        let entry = self.letters.entry(Letter::of(symbol)).or_default();
        let index = symbol.subscripts.iter().find_map(|s| axis(s));
        let index = index.filter(|_| !self.wholes.counts(symbol));
        let double = symbol.subscripts.iter().find_map(|s| axes(s));
        if symbol.style.tensor {
            entry.tensor += 1;
        } else if double.is_some() {
            entry.double += 1;
        } else if index.is_some() {
            entry.component += 1;
        } else if symbol.style.vector || symbol.style.bar && !is_number_under_bar(symbol) {
            entry.vector += 1;
            entry.hatted += usize::from(symbol.style.hat);
        } else {
            entry.bare += 1;
            entry.hats += usize::from(symbol.style.hat);
        }
        entry.resultant += usize::from(symbol.resultant);
        entry.naked += usize::from(symbol.subscripts.is_empty());
        if symbol.primes == 1 && symbol.subscripts.is_empty() {
            self.primed.insert(Letter::of(symbol));
        }
        self.superscripts
            .entry(Letter::of(symbol))
            .or_default()
            .insert(symbol.superscripts.clone());
        let subscripts = self.subscripts.entry(Letter::of(symbol)).or_default();
        subscripts.extend(symbol.subscripts.iter().cloned());
    }
}

/// Whether a side lists more numbers than a vector or a quaternion has.
fn is_long(side: &Node) -> bool {
    match &inner(side).kind {
        Kind::Transpose(row) => {
            matches!(&inner(row).kind, Kind::Matrix(rows) if rows.iter().any(|row| row.len() > 4))
        }
        Kind::Matrix(rows) => rows.len() > 4,
        _ => false,
    }
}

/// Whether a term is the matrix of a cross product on a vector that makes such a matrix too: `\omega^\times J\omega`.
fn applies_skew(term: &Node) -> bool {
    let Kind::Product(factors) = &inner(term).kind else {
        return false;
    };
    let skew = factors
        .iter()
        .find_map(|factor| match &inner(&factor.node).kind {
            Kind::Skew(operand) => Some(inner(operand)),
            _ => None,
        });
    let last = factors.last().map(|factor| inner(&factor.node));
    let of_vector = match (skew.map(|node| &node.kind), last.map(|node| &node.kind)) {
        (Some(Kind::Symbol(skew)), Some(Kind::Symbol(last))) => skew == last,
        _ => false,
    };
    of_vector
        && !factors
            .iter()
            .any(|f| matches!(f.node.kind, Kind::Transpose(_)))
}

/// The rows of a square matrix, other than three.
fn square_of(side: &Node) -> Option<u8> {
    let Kind::Matrix(rows) = &inner(side).kind else {
        return None;
    };
    let square = rows.len() > 1 && rows.iter().all(|row| row.len() == rows.len());
    (square && rows.len() != 3).then(|| u8::try_from(rows.len()).ok())?
}

fn has_minus_beside_diagonal(side: &Node) -> bool {
    let Kind::Matrix(rows) = &inner(side).kind else {
        return false;
    };
    let beside = rows.iter().enumerate().flat_map(|(r, row)| {
        let entries = row.iter().enumerate();
        entries
            .filter(move |(c, _)| *c != r)
            .map(|(_, entry)| entry)
    });
    beside
        .into_iter()
        .any(|entry| matches!(entry.kind, Kind::Negate(_)))
}

/// What stands before a bracket.
fn called(node: &Node) -> &Node {
    match &inner(node).kind {
        Kind::Call(head, _) => head,
        _ => inner(node),
    }
}

fn two() -> num_rational::BigRational {
    num_rational::BigRational::from_integer(2.into())
}

/// Whether a bar over a letter means the mass centre, about which a moment of inertia is taken.
fn is_number_under_bar(symbol: &Symbol) -> bool {
    matches!(symbol.name.as_str(), "I" | "J")
}

/// How many columns a side has that is written out row by row, or as a list of three, whatever it is multiplied by:
/// `\frac{s}{\sqrt 5} [1, 2, 0]^T`.
fn columns(side: &Node) -> Option<usize> {
    match &inner(side).kind {
        Kind::Matrix(rows) if rows.len() > 1 => rows.first().map(Vec::len),
        Kind::Tuple(entries) => (entries.len() == 3).then_some(1),
        Kind::Transpose(row) => {
            matches!(&inner(row).kind, Kind::Matrix(rows) if rows.len() == 1 && rows[0].len() > 1)
                .then_some(1)
        }
        Kind::Quotient(above, _) | Kind::WithUnit(above, _) => columns(above),
        Kind::Product(factors) if is_rate_of_turn(factors) => Some(3),
        Kind::Product(factors) => factors.last().and_then(|factor| columns(&factor.node)),
        _ => None,
    }
}
