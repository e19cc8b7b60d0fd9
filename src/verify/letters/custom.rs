//! What letters mean by the custom of the field, where no word says it.

use crate::notation::ast::{Function, Kind, Node, Symbol, Term};
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::convention::signed;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, axis, inner, symbols};
use crate::verify::values::quantity::Quantity;

impl Reading {
    /// What is left, by the custom of the field.
    pub(crate) fn by_custom(&mut self) {
        let letters: Vec<Letter> = self.usage.letters().map(|(l, _)| l.clone()).collect();
        for letter in letters {
            let free = match letter.name.as_str() {
                "T" | "E" | "N" | "F" | "J" | "Gamma" | "Theta" => true,
                // "A rod of length L".
                "L" | "H" | "M" | "h" => !self.is_directed(&letter.name),
                _ => false,
            };
            let apart = free && self.apart.contains(&letter)
                || self.arms.contains(&letter)
                || self.periods.contains(&letter);
            let apart = apart || self.residuals.contains(&letter);
            if self.quantities.contains_key(&letter) || apart {
                continue;
            }
            if let Some(quantity) = self.custom(&letter) {
                self.quantities.insert(letter, quantity);
            }
        }
        let vector = |name: &str| self.usage.get(&Letter::plain(name)).vector > 0;
        if vector("omega") && vector("Omega") {
            self.part_turns();
        }
    }

    /// Letters that a line sets equal to something with a weight in it, `E = … - mgd\cos\theta`, or with a term beside
    /// that of a rate in which nothing moves but the angle, are no kinetic energies; nor are products of inertia.
    pub(crate) fn note_totals(&mut self, document: &Document) {
        for line in document.lines() {
            let [left, rest @ ..] = line.sides.as_slice() else {
                continue;
            };
            let weight = |symbol: &Symbol| symbol.name == "g" && symbol.subscripts.is_empty();
            if let Kind::Symbol(symbol) = &inner(left).kind
                && (rest.iter().flat_map(symbols).any(weight)
                    || symbol.name != "T" && rest.iter().any(adds_a_potential))
            {
                self.totals.insert(Letter::of(symbol));
            }
            let mirrored = line.sides.iter().flat_map(mirrored_entries);
            self.totals.extend(mirrored.map(Letter::of));
        }
    }

    /// A vector whose rate is the velocity of another point less that of P, `\dot{r} = v_G - v_P`, begins at P and does
    /// not end there: it is no position of P.
    pub(crate) fn note_arms(&mut self, document: &Document) {
        let of_point = |term: &Term| {
            let point = |symbol: &Symbol| {
                matches!(symbol.name.as_str(), "v" | "V")
                    && matches!(symbol.subscripts.as_slice(), [p] if matches!(p.as_str(), "P" | "p"))
            };
            term.negative && matches!(&inner(&term.node).kind, Kind::Symbol(s) if point(s))
        };
        for line in document.lines() {
            for side in &line.sides {
                let Kind::TimeDerivative { operand, .. } = &inner(side).kind else {
                    continue;
                };
                let less = |other: &Node| matches!(&inner(other).kind, Kind::Sum(terms) if terms.iter().any(of_point));
                if let Kind::Symbol(symbol) = &inner(operand).kind
                    && line.sides.iter().any(less)
                {
                    self.arms.insert(Letter::of(symbol));
                }
            }
        }
    }

    /// "With the moments $A$, $A$, $C$": three of the inertia.
    pub(crate) fn listed_moments(&mut self, document: &Document) {
        let letter = |item: &Item| match item {
            Item::Formula(formula) => match formula.rows.as_slice() {
                [Row::Expression(node)] => match &inner(node).kind {
                    Kind::Symbol(symbol) if symbol.subscripts.is_empty() => {
                        Some(Letter::of(symbol))
                    }
                    _ => None,
                },
                _ => None,
            },
            _ => None,
        };
        let joins = |item: &Item| match item {
            Item::Prose { text, .. } => matches!(text.trim(), "," | "and" | ", and"),
            _ => false,
        };
        for items in document.items.windows(6) {
            let [Item::Prose { text, .. }, first, comma, second, and, third] = items else {
                continue;
            };
            let named = text.trim_end().ends_with("moments") && joins(comma) && joins(and);
            let letters = [first, second, third].map(letter);
            let names = letters
                .each_ref()
                .map(|l| l.as_ref().map(|l| l.name.as_str()));
            if named && matches!(names, [Some("A"), Some("A" | "B"), Some("C")]) {
                for letter in letters.into_iter().flatten() {
                    self.vote(letter, Quantity::Inertia, 3);
                }
            }
        }
    }

    /// A w with components that stands beside a ×, or that of a typewriter, is an ω, unless there is an ω, or it stands with x, y and z as the parts of a quaternion do.
    pub(crate) fn typed_w(&mut self, typewriter: bool) {
        let quaternion = ["x", "y", "z"].iter().all(|name| self.has(name));
        let letter = Letter::plain("w");
        let indexed = self.usage.get(&letter).component > 0;
        let moves = indexed || self.usage.get(&letter).moving;
        let crossed = self.usage.is_vector(&letter) && moves && !self.has("omega");
        let typed = typewriter && self.has("w") && (indexed || !self.has("omega"));
        if (indexed || !quaternion) && (typed || crossed) && !self.components.contains_key(&letter)
        {
            self.quantities
                .entry(letter)
                .or_insert(Quantity::AngularVelocity);
        }
    }

    /// Whether a letter is used in the document, with the marks of a rate.
    pub(crate) fn has(&self, name: &str) -> bool {
        let used = self.usage.get(&Letter::plain(name));
        used.vector + used.component + used.bare > 0
    }

    /// Whether a letter is used, and never as a vector or with an index.
    pub(crate) fn has_bare(&self, name: &str) -> bool {
        self.has(name) && !self.is_directed(name)
    }

    /// Whether a letter is used as a vector or with an index.
    fn is_directed(&self, name: &str) -> bool {
        let used = self.usage.get(&Letter::plain(name));
        used.vector + used.component > 0
    }

    /// Whether a letter stands for a mass: the document has a `g` and no vector or component of the letter.
    fn weighs(&self, letter: &Letter) -> bool {
        let used = self.usage.get(letter);
        used.vector + used.component == 0 && self.usage.get(&Letter::plain("g")).bare > 0
    }

    /// Whether a letter for the tensor is only ever a number, in a document that calls the principal moments A, B and C.
    fn is_single_moment(&self, letter: &Letter) -> bool {
        let used = self.usage.get(letter);
        let named = ["A", "B", "C"].map(Letter::plain);
        let moment = |l: &Letter| matches!(self.components.get(l), Some((Quantity::Inertia, _)));
        named.iter().all(moment)
            && !self.left_sides.contains(letter)
            && used.vector + used.tensor + used.double + used.component == 0
    }

    /// Whether a letter has components about x, y and z: the instants t_1, t_2, t_3 have none.
    fn is_on_lettered_axes(&self, letter: &Letter) -> bool {
        let mut axes = ["x", "y", "z"].iter();
        axes.all(|axis| self.usage.has_index(letter, axis))
    }

    /// Whether another letter is the moment already, or is it by a better custom.
    fn has_moment(&self) -> bool {
        let mut whole = self.quantities.values();
        let mut parts = self.components.values();
        whole.any(|q| *q == Quantity::Moment)
            || parts.any(|(q, _)| *q == Quantity::Moment)
            || self.is_directed("M")
            || self.is_directed("tau")
    }

    /// Whether the letter of the momentum is a vector without a mark: `cross(w, H)`. What wheels add to it is one too.
    pub(crate) fn crosses_bare_momentum(&self) -> bool {
        let mut whole = self.quantities.iter();
        whole.any(|(letter, quantity)| {
            *quantity == Quantity::Momentum && self.usage.get(letter).crossed_bare > 0
        })
    }

    /// Whether an i, j or k without a mark is a unit vector: where sums along them are, other than those of a quaternion.
    pub(crate) fn is_plain_unit(&self, symbol: &Symbol) -> bool {
        let moves = |letter: &Letter| self.usage.get(letter).moving;
        // A current i changes in time, and so do the vectors of a triad, more than one of them.
        let triad = ["i", "j", "k"].map(Letter::plain);
        let alone = triad.iter().filter(|letter| moves(letter)).count() < 2;
        let current = moves(&Letter::of(symbol)) && alone;
        let number = self.imaginary && symbol.style.upright;
        !number && self.usage.plain_units && self.attitude.quaternion.is_none() && !current
    }

    /// Whether a position stands beside the velocity of a body, so that the velocity may be that of another point.
    pub(crate) fn drifts_beside_a_point(&self) -> bool {
        self.speaks_of(Quantity::CentreVelocity) && self.speaks_of(Quantity::Position)
    }

    /// Whether a velocity is that of the mass centre: it has the components u, v, w, or it changes under a force and no
    /// position or other velocity is spoken of.
    fn drifts(&self, letter: &Letter) -> bool {
        let of_centre = |(q, _): &(Quantity, u8)| *q == Quantity::CentreVelocity;
        if self.components.values().any(of_centre) {
            return true;
        }
        let taken = |quantity| self.quantities.values().any(|&q| q == quantity);
        let alone = self.usage.subscripts.get(letter);
        let alone = alone.is_none_or(|all| all.iter().all(|s| axis(s).is_some()));
        let moved = self.usage.get(letter).moving && taken(Quantity::Force);
        moved && alone && !taken(Quantity::Position) && !self.components.contains_key(letter)
    }

    /// A body has one angular velocity, and Ω beside its ω is that of the axes. Nor has a rotor in no body a momentum
    /// relative to it.
    pub(crate) fn part_turns(&mut self) {
        let [body, axes] = ["omega", "Omega"].map(Letter::plain);
        let turns = |letter| self.quantities.get(letter) == Some(&Quantity::AngularVelocity);
        if turns(&body) && turns(&axes) {
            self.quantities.insert(axes, Quantity::FrameRate);
        }
        let whole = |letter: &Letter| matches!(letter.name.as_str(), "L" | "H");
        if !self.speaks_of(Quantity::Momentum) {
            for (_, quantity) in self.quantities.iter_mut().filter(|(l, _)| whole(l)) {
                if *quantity == Quantity::RelativeMomentum {
                    *quantity = Quantity::Momentum;
                }
            }
        }
    }

    /// Whether ω is a number of its own beside a body that turns with Ω_1, Ω_2, Ω_3, as in Landau and Lifshitz.
    fn is_frequency_beside_rates(&self) -> bool {
        let [own, rates] = ["omega", "Omega"].map(Letter::plain);
        let number = self.usage.get(&own);
        let called = self.votes_for(&own, Quantity::AngularVelocity) > 0;
        let indices = ["1", "2", "3"]
            .iter()
            .all(|i| self.usage.has_index(&rates, i));
        let flat = number.vector + number.component + number.crossed_bare == 0;
        flat && number.bare > 0 && indices && !called
    }

    /// Whether a symbol is the identity: where words say so, and by the marks on an E, a 1, or an I beside an inertia J.
    pub(crate) fn is_identity(&self, symbol: &Symbol) -> bool {
        let plain = symbol.subscripts.is_empty();
        let marked = symbol.style.vector || symbol.style.tensor;
        let beside_j = || self.usage.get(&Letter::plain("J")).bare > 0;
        match symbol.name.as_str() {
            _ if plain && self.identities.contains(&Letter::of(symbol)) => true,
            "E" | "1" => plain && marked,
            "I" if symbol.subscripts == ["3"] => {
                let [own, j] = ["I", "J"].map(Letter::plain);
                let moments = ["1", "x", "xx"].iter().any(|i| self.usage.has_index(&j, i));
                !self.usage.has_index(&own, "1") && (moments || beside_j())
            }
            // Nobody writes the elements of the identity.
            "I" => {
                let elements = self.usage.get(&Letter::plain("I")).double > 0;
                let momentum =
                    self.quantities.get(&Letter::plain("J")) == Some(&Quantity::Momentum);
                symbol.style.vector && beside_j() && !elements && !momentum
            }
            _ => false,
        }
    }

    /// Whether one component of a letter is all that is written of it, and a line says what it is.
    fn is_lone_component(&self, letter: &Letter) -> bool {
        let used = self.usage.get(letter);
        let met = self.usage.subscripts.get(letter);
        let one = met.is_some_and(|all| all.len() == 1);
        one && used.vector + used.bare == 0 && self.left_sides.contains(letter)
    }

    fn custom(&self, letter: &Letter) -> Option<Quantity> {
        let used = self.usage.get(letter);
        let directed = used.vector + used.component > 0;
        let taken = |quantity| self.quantities.values().any(|&q| q == quantity);
        match letter.name.as_str() {
            "omega" if self.is_frequency_beside_rates() => None,
            "omega" => Some(Quantity::AngularVelocity),
            // The matrix Ω = RᵀṘ.
            "Omega" if used.tensor > 0 && used.component == 0 => None,
            "Omega" if directed && !self.has("omega") && self.axes_without_spin => {
                Some(Quantity::FrameRate)
            }
            "Omega" if directed && (!self.has("omega") || self.is_frequency_beside_rates()) => {
                Some(Quantity::AngularVelocity)
            }
            // The frequency Ω_1 of a wobble about axis 1, beside ω_1.
            "Omega" if self.is_lone_component(letter) => None,
            "Omega" if directed && !self.has_wheel_speeds(letter) => Some(Quantity::FrameRate),
            "Omega" if self.flat && !self.has("omega") => Some(Quantity::AngularVelocity),
            "alpha" if directed => Some(Quantity::AngularAcceleration),
            // Lagrange's function.
            "L" if letter.calligraphic && !directed => None,
            // Beside a momentum L, an H without index or arrow is Hamilton's function.
            "H" if !directed && self.is_directed("L") => Some(Quantity::Energy),
            // Beside a vector H that words call the momentum, an L without index or arrow is a length.
            "L" if !directed && self.is_directed("H") && taken(Quantity::Momentum) => None,
            "L" | "H" if !self.components.contains_key(letter) => Some(Quantity::Momentum),
            "h" | "ell" if directed && !taken(Quantity::Momentum) => Some(Quantity::Momentum),
            "M" if directed || used.resultant > 0 => Some(Quantity::Moment),
            "M" if used.bare > 0 && !self.weighs(letter) && !self.speaks_of_no_torque => {
                Some(Quantity::Moment)
            }
            "tau" => Some(Quantity::Moment),
            "N" | "Gamma" | "T" if directed && !self.has_moment() => Some(Quantity::Moment),
            "I" | "J" if self.is_single_moment(letter) => None,
            "I" | "J" => Some(Quantity::Inertia),
            "Theta" if used.double + used.tensor > 0 => Some(Quantity::Inertia),
            "T" if used.tensor == 0 && !taken(Quantity::Energy) => Some(Quantity::Energy),
            "E" if used.bare > 0
                && self.speaks_of_energy
                && !self.totals.contains(letter)
                && !taken(Quantity::Energy)
                && !self.has_bare("T") =>
            {
                Some(Quantity::Energy)
            }
            "F" if !used.moving && used.tensor == 0 => Some(Quantity::Force),
            "a" if used.vector > 0 && taken(Quantity::Force) => Some(Quantity::Acceleration),
            // Under a hat it is a direction.
            "r" if used.vector > used.hatted => Some(Quantity::Position),
            "v" | "V" if directed && self.drifts(letter) => Some(Quantity::CentreVelocity),
            "v" if !self.components.contains_key(letter) => Some(Quantity::Velocity),
            "V" if directed && !self.components.contains_key(letter) => Some(Quantity::Velocity),
            "m" => Some(Quantity::Mass),
            "t" if self.is_on_lettered_axes(letter) && !self.has_moment() => Some(Quantity::Moment),
            "t" => Some(Quantity::Time),
            _ => None,
        }
    }
}

/// Whether a sum has a term with the rate of an angle, and another that has this angle under a sine or cosine and no rate.
fn adds_a_potential(side: &Node) -> bool {
    let Kind::Sum(terms) = &inner(side).kind else {
        return false;
    };
    if !terms.iter().any(|term| has_turn(&term.node)) {
        return false;
    }
    let rate = |name: &str| matches!(name, "omega" | "Omega" | "w" | "p" | "q" | "r");
    let moves =
        |term: &Node| rates(term).next().is_some() || symbols(term).iter().any(|s| rate(&s.name));
    let angles: Vec<Symbol> = terms.iter().flat_map(|term| rates(&term.node)).collect();
    let potential = |term: &Term| {
        let turned = symbols(&term.node).into_iter().any(|s| angles.contains(s));
        turned && !moves(&term.node) && has_turn(&term.node)
    };
    terms.iter().any(potential)
}

/// The symbols under a derivative in time.
fn rates(node: &Node) -> impl Iterator<Item = Symbol> {
    fn collect(node: &Node, found: &mut Vec<Symbol>) {
        match &node.kind {
            Kind::TimeDerivative { operand, .. } => {
                found.extend(symbols(operand).into_iter().cloned())
            }
            _ => node.children().for_each(|child| collect(child, found)),
        }
    }
    let mut found = vec![];
    collect(node, &mut found);
    found.into_iter()
}

fn has_turn(node: &Node) -> bool {
    matches!(node.kind, Kind::Function(Function::Sin | Function::Cos, _))
        || node.children().any(has_turn)
}

/// Symbols on both sides of the diagonal of a matrix of three rows, as products of inertia stand.
fn mirrored_entries(side: &Node) -> Vec<&Symbol> {
    let Kind::Matrix(rows) = &inner(side).kind else {
        return vec![];
    };
    if rows.len() != 3 || rows.iter().any(|row| row.len() != 3) {
        return vec![];
    }
    let entry = |r: usize, c: usize| match &inner(signed(inner(&rows[r][c])).1).kind {
        Kind::Symbol(symbol) => Some(symbol),
        _ => None,
    };
    let pairs = [(0, 1), (0, 2), (1, 2)];
    let both = pairs.map(|(r, c)| entry(r, c).filter(|_| entry(r, c) == entry(c, r)));
    both.into_iter().flatten().collect()
}
