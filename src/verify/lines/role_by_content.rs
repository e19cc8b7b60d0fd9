//! What a line does by what stands in it, whatever its sentence says.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::particles::PLACES;
use crate::verify::letters::usage::{inner, symbols, undotted};
use crate::verify::lines::defined_squares::is_two;
use crate::verify::lines::given::is_zero;
use crate::verify::values::atoms::Owner;
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::symbol::{MAGNITUDE, Meaning};
use crate::verify::verdict::{Role, Verdict};
use crate::verify::words::book::{has_any, lowered};
use num_traits::Zero;
use std::collections::BTreeSet;

/// What turns steadily.
const STEADY: &[&str] = &[
    "constant speed",
    "constant rate",
    "constant spin",
    "constant angular velocity",
    "constant angular speed",
];

impl Checker<'_> {
    /// The role that a sentence gives, unless the line could not play it: what the laws determine and nothing new
    /// stands in is a claim, whatever "with" or "where" is before it.
    pub(crate) fn role_by_content(&mut self, role: Role, sides: &[Node]) -> Role {
        let [left, rest @ ..] = sides else {
            return role;
        };
        let nothing = |side: &Node| {
            is_zero(side) || matches!(&side.kind, Kind::Symbol(s) if s.name == "const")
        };
        if !self.displayed && self.constrained && rest.last().is_some_and(nothing) {
            return Role::Assume;
        }
        let rates = sides.split_last().filter(|(last, _)| is_zero(last));
        let still = rates
            .is_some_and(|(_, rates)| rates.iter().all(|rate| self.is_said_to_be_constant(rate)));
        let still = still || rates.is_some_and(|(_, rates)| self.names_steady_motion(rates));
        let on_principal_axes = rates.is_some_and(|(_, all)| self.says_of_principal_axes(all));
        let named = self.names_a_steady_case()
            || rates.is_some_and(|(_, rates)| self.names_steady_motion(rates));
        let steady = still && self.displayed && named;
        let now = rates.is_some() && self.says_now();
        if steady
            || !self.displayed
                && (still || now || on_principal_axes || self.are_said_to_be_equal(sides))
        {
            return Role::Assume;
        }
        if role == Role::Claim && self.writes_coordinates(sides) {
            return Role::Define;
        }
        if role == Role::Claim || self.firm {
            return role;
        }
        // What a derivative is follows from what is differentiated.
        let slope = match &inner(left).kind {
            Kind::Derivative { .. } => !rest.last().is_some_and(is_zero),
            Kind::TimeDerivative { order, .. } => *order > 1 && role == Role::Define,
            _ => false,
        };
        if slope {
            return Role::Claim;
        }
        let alone = |side: &Node| matches!(inner(side).kind, Kind::Symbol(_));
        // `T = 2π/Ω = 3.1 s` works a number out.
        let numeral = |side: &Node| symbols(side).iter().all(|symbol| symbol.name == "pi");
        if let [middle @ .., last] = rest
            && numeral(last)
            && !is_zero(last)
            && middle.iter().any(|side| !alone(side) && !numeral(side))
        {
            return Role::Claim;
        }
        if role == Role::Define && self.runs_in_a_circle(left, rest) {
            return Role::Claim;
        }
        // What a law says of a frequency is no matter of definition.
        let base = match &inner(left).kind {
            Kind::Power(base, two) if is_two(two) => base,
            _ => left,
        };
        if role == Role::Define && self.is_tied_by_square(base) {
            return Role::Claim;
        }
        // A sum that vanishes says of nothing new what it is.
        let sum = matches!(inner(left).kind, Kind::Sum(_)) && rest.last().is_some_and(is_zero);
        if role == Role::Define && sum && !self.brings_something_new(sides) {
            return Role::Claim;
        }
        if sides.iter().any(nothing) || sides.iter().all(alone) || self.sets_a_magnitude(sides) {
            return role;
        }
        // One triad by another: neither is determined.
        let axis = matches!(&inner(left).kind, Kind::Symbol(symbol) if matches!(self.meaning_of(symbol), Meaning::UnitVector(_)));
        if axis {
            return role;
        }
        let alone_left = matches!(undotted(left).kind, Kind::Symbol(_));
        let number = |side: &Node| symbols(side).is_empty();
        // "Choose the angle such that ⟨tan 2θ = …⟩".
        if matches!(&inner(left).kind, Kind::Function(..)) && self.chooses_such_that() {
            return role;
        }
        // "We take ⟨|h|² = 2 J T⟩": no definition, and no law that it could be.
        if self.picked && !self.displayed && role == Role::Assume && !alone_left {
            return role;
        }
        let by_turning = self.gives_rate_of_angle(left, rest);
        if alone_left && self.is_set_in_an_earlier_case(left) {
            return role;
        }
        let free = |checker: &mut Self| {
            checker.is_free_value(left) || checker.is_rate_with_a_free_part(left)
        };
        if alone_left && (rest.iter().any(number) || !by_turning && free(self))
            || self.new_symbol(left).is_some()
        {
            return role;
        }
        match self.brings_something_new(sides) || self.supposes_of_the_next_axis(role, left) {
            true => role,
            false => Role::Claim,
        }
    }

    fn chooses_such_that(&self) -> bool {
        let said = lowered(&self.sentence);
        let said = said.trim_end_matches(|c: char| c == '.' || c.is_whitespace());
        let such = ["such that", "so that"]
            .iter()
            .find_map(|words| said.strip_suffix(words));
        such.is_some_and(|before| has_any(before, &["choose", "take", "pick"]))
    }

    /// Whether a line goes on with an assumption that the same formula makes of another axis: `M_1 = -k\omega_1,
    /// M_2 = -k\omega_2`.
    fn supposes_of_the_next_axis(&mut self, role: Role, left: &Node) -> bool {
        let Some(before) = self.findings.last() else {
            return false;
        };
        if (before.role, &before.verdict) != (role, &Verdict::Accepted) {
            return false;
        }
        let place = before.span.start;
        let earlier = self
            .beside
            .iter()
            .find(|(side, _)| side.span.start == place);
        let Some(earlier) = earlier.map(|(side, _)| side.clone()) else {
            return false;
        };
        let mut component = |side: &Node| match &inner(side).kind {
            Kind::Symbol(symbol) => match self.meaning_of(symbol) {
                Meaning::Component(entity, axis) => Some((entity, axis)),
                _ => None,
            },
            _ => None,
        };
        let pair = component(&earlier).zip(component(left));
        pair.is_some_and(|(one, other)| one.0 == other.0 && one.1 != other.1)
    }

    /// Whether a line only gives the three components of a vector their names: `\omega = p\,i + q\,j + r\,k`.
    pub(crate) fn writes_components(&mut self, sides: &[Node]) -> bool {
        let [left, right] = sides else { return false };
        let Kind::Symbol(whole) = &inner(left).kind else {
            return false;
        };
        let Kind::Sum(terms) = &inner(right).kind else {
            return false;
        };
        let vector = self.entity_named(whole);
        let vector = vector.is_some_and(|v| self.theory.atoms.info(v).shape == Shape::Vector);
        let mut axes = BTreeSet::new();
        let mut names = |checker: &mut Self, term: &Node| {
            let met: Vec<Meaning> = symbols(term)
                .into_iter()
                .map(|symbol| checker.meaning_of(symbol))
                .collect();
            let product = matches!(inner(term).kind, Kind::Product(_));
            match met.as_slice() {
                [part, Meaning::UnitVector(axis)] => {
                    product && part.entity().is_some() && axes.insert(*axis)
                }
                _ => false,
            }
        };
        let plain = terms
            .iter()
            .all(|term| !term.negative && names(self, &term.node));
        vector && plain && axes.len() == 3
    }

    /// Whether a line gives the components of a place by the letters of the axes: `\mathbf r = x\,i + y\,j + z\,k`.
    fn writes_coordinates(&mut self, sides: &[Node]) -> bool {
        let [left, right] = sides else { return false };
        let place =
            matches!(&inner(left).kind, Kind::Symbol(s) if PLACES.contains(&s.name.as_str()));
        if !place || !self.writes_components(sides) {
            return false;
        }
        let met = symbols(right);
        let named = |pair: &[&Symbol]| {
            let axis = match self.meaning_of(pair[1]) {
                Meaning::UnitVector(axis) => usize::from(axis),
                _ => return false,
            };
            pair[0].subscripts.is_empty()
                && ["x", "y", "z"].get(axis) == Some(&pair[0].name.as_str())
        };
        met.chunks(2).all(named)
    }

    /// Whether a symbol of the document stands in a line that nothing before says anything of.
    fn brings_something_new(&mut self, sides: &[Node]) -> bool {
        sides.iter().flat_map(symbols).any(|symbol| {
            let Some(entity) = self.entity_named(symbol) else {
                return false;
            };
            let place = match self.meaning_of(symbol) {
                Meaning::Component(_, place) => Some(place),
                _ => None,
            };
            let own = matches!(self.theory.atoms.info(entity).owner, Owner::Symbol(_));
            let variable = self.theory.atoms.part(entity, place.unwrap_or(0), 0);
            own && self.theory.rule(variable).is_none() && !self.theory.mentions_part(entity, place)
        })
    }

    /// "Now ⟨\dot\omega = 0⟩": what vanishes from here on.
    fn says_now(&self) -> bool {
        let words = lowered(self.sentence.rsplit(['⟩', '.']).next().unwrap_or_default());
        matches!(words.trim(), "now" | "now let" | "but now")
    }

    /// "At constant speed we have": words that name a case and claim nothing.
    fn names_a_steady_case(&self) -> bool {
        let words = lowered(self.sentence.rsplit('⟩').next().unwrap_or_default());
        let clause = words.trim().trim_end_matches([',', ':', '.']);
        let clause = clause.rsplit('.').next().unwrap_or_default().trim();
        let clause = ["we have", "one has", "this means", "that is", "i.e."]
            .iter()
            .find_map(|end| clause.strip_suffix(end))
            .unwrap_or(clause);
        let clause = clause.trim().trim_end_matches(',');
        let clause = ["at a ", "at ", "for a ", "for ", "in a "]
            .iter()
            .find_map(|lead| clause.strip_prefix(lead));
        clause.is_some_and(|clause| STEADY.contains(&clause))
    }

    /// "In a steady precession we have ⟨\dot\theta = \ddot\theta = 0⟩": rates that vanish in a motion that is named, and are
    /// not derived.
    fn names_steady_motion(&self, rates: &[Node]) -> bool {
        let words = lowered(self.sentence.rsplit('⟩').next().unwrap_or_default());
        let clause = words.trim().trim_end_matches([',', ':']).trim_end();
        let clause = clause.rsplit(['.', ';', ',']).next().unwrap_or_default();
        let said = ["we have", "one has", "there is", "we put", "we set"];
        let clause = clause.trim();
        let clause = said
            .iter()
            .find_map(|end| clause.strip_suffix(end))
            .unwrap_or(clause);
        let named = ["in a ", "in the ", "for a ", "for the ", "during a ", "in "]
            .iter()
            .find_map(|lead| clause.strip_prefix(lead));
        let motions = ["precession", "motion", "state", "turn", "spin", "rotation"];
        let steady = named.is_some_and(|named| {
            let words: Vec<&str> = named.split_whitespace().collect();
            let kind = ["steady", "regular", "uniform", "stationary"];
            let is = |list: &[&str], word: Option<&&str>| word.is_some_and(|w| list.contains(w));
            is(&kind, words.first()) && is(&motions, words.last()) && words.len() <= 3
        });
        let rate = |node: &Node| matches!(inner(node).kind, Kind::TimeDerivative { .. });
        steady && rates.iter().all(rate)
    }

    /// "On the principal axes, ⟨D = E = F = 0⟩": products of inertia that vanish there.
    fn says_of_principal_axes(&mut self, products: &[Node]) -> bool {
        let words = self.sentence.rsplit('⟩').next().unwrap_or_default();
        // One that was supposed to vanish before does so here.
        lowered(words).contains("principal")
            && products
                .iter()
                .any(|product| self.product_of_inertia(product).is_some())
            && products
                .iter()
                .all(|product| self.product_of_inertia(product).is_some() || self.vanishes(product))
    }

    /// "The four speeds are equal, ⟨a = b = c = d⟩": symbols of the document that no law determines.
    fn are_said_to_be_equal(&mut self, sides: &[Node]) -> bool {
        let words = lowered(self.sentence.rsplit('⟩').next().unwrap_or_default());
        let said = [
            "are equal",
            "are all equal",
            "are the same",
            "are all the same",
            "is the same for",
        ];
        // "For a cube, ⟨a = b = c⟩".
        let clause = words.rsplit(['.', ';', ')']).next().unwrap_or_default();
        let kinds = ["for a ", "for an ", "in the case of a ", "if it is a "];
        let case = clause.trim_end().ends_with(',')
            && kinds
                .iter()
                .any(|words| clause.trim_start().starts_with(words));
        let lone = |side: &Node| matches!(inner(side).kind, Kind::Symbol(_));
        if self.asserted || !case && !has_any(&words, &said) || !sides.iter().all(lone) {
            return false;
        }
        self.entities(sides).into_iter().all(|entity| {
            let own = matches!(self.theory.atoms.info(entity).owner, Owner::Symbol(_));
            own && self.is_free(entity)
        })
    }

    fn vanishes(&mut self, node: &Node) -> bool {
        let value = self.lowering(Frame::Moving).value(node);
        value.is_ok_and(|value| {
            let mut entries = value.entries.iter();
            entries.all(|entry| self.theory.normal(entry).is_zero())
        })
    }

    /// "They run at constant speed, ⟨\dot s = 0⟩": the rate of a symbol of the document, which no law determines; or of ω,
    /// where the words name such a case and claim nothing, or suppose "a steady turn".
    fn is_said_to_be_constant(&mut self, left: &Node) -> bool {
        let words = self.sentence.rsplit('⟩').next().unwrap_or_default();
        let words = words.to_lowercase();
        let said = words.contains("constant");
        let clause = words.trim().trim_end_matches([',', ':']);
        let clause = clause.rsplit(['.', '\n']).next().unwrap_or_default().trim();
        let clause = clause.strip_prefix("at ").unwrap_or(clause);
        let case = !self.asserted && STEADY.contains(&clause) || self.names_a_steady_case();
        let Kind::TimeDerivative { operand, .. } = &inner(left).kind else {
            return false;
        };
        let entities = self.entities([&**operand]);
        let steady = has_any(&words, &["steady", "uniform", "in trim", "equilibrium"]);
        let case = case || steady;
        let own = |entity| match &self.theory.atoms.info(entity).owner {
            Owner::Symbol(_) => said,
            Owner::Quantity(quantity, _) => case && *quantity == Quantity::AngularVelocity,
        };
        (said || steady) && !entities.is_empty() && entities.into_iter().all(own)
    }

    /// Whether a line only names a moment: "the axes coincide at ⟨t = 0⟩", "(⟨φ = 0⟩ at rest)".
    pub(crate) fn names_a_moment(&mut self, sides: &[Node]) -> bool {
        let [left, rest @ ..] = sides else {
            return false;
        };
        let pi = |symbol: &&Symbol| symbol.name == "pi" && symbol.subscripts.is_empty();
        let number = |side: &Node| symbols(side).iter().all(pi);
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return false;
        };
        // In a list of data it is one of them: "⟨m = 2⟩, the final length ⟨s = 3⟩".
        let data = self.findings.last().is_some_and(|before| {
            let handed = matches!(before.role, Role::Given | Role::Define);
            let near = || before.source_line + 1 >= self.document.place(left.span.start).line;
            handed && !rest.iter().all(is_zero) && near()
        });
        if data || self.displayed || self.asserted || !rest.iter().all(number) {
            return false;
        }
        let Meaning::Whole(entity) = self.meaning_of(symbol) else {
            return false;
        };
        let info = self.theory.atoms.info(entity);
        match info.owner {
            Owner::Quantity(quantity, _) => quantity == Quantity::Time,
            Owner::Symbol(_) => {
                let moves = !info.constant && info.shape == Shape::Scalar;
                moves && self.is_free(entity) && !self.is_in_doubt(entity)
            }
        }
    }

    /// Whether a line speaks of the magnitude of a vector, or of a symbol that a relation has: it may set an angle by it,
    /// or a value, which no law determines.
    fn sets_a_magnitude(&mut self, sides: &[Node]) -> bool {
        sides.iter().flat_map(symbols).any(|symbol| {
            let Meaning::Whole(entity) = self.meaning_of(symbol) else {
                return false;
            };
            let owner = &self.theory.atoms.info(entity).owner;
            matches!(owner, Owner::Quantity(_, variant) if variant == MAGNITUDE)
                || self.theory.is_in_relation(entity)
        })
    }
}
