//! Definitions: lines that give a symbol its meaning.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Function, Kind, Line, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, inner, symbols};
use crate::verify::lines::given::is_zero;
use crate::verify::names;
use crate::verify::reason;
use crate::verify::reason::TAKEN_AS_GIVEN;
use crate::verify::theory::{Premise, Taken};
use crate::verify::values::atoms::{Entity, Owner, variable_fraction};
use crate::verify::values::lower::TroubleKind;
use crate::verify::values::quantity::Shape;
use crate::verify::values::symbol::{ANY_POINT, Meaning};
use crate::verify::values::value::Value;
use crate::verify::verdict::{Finding, Role, Verdict};
use crate::verify::words::book::has_any;
use num_traits::Zero;

/// Rows and columns of a matrix that a symbol may stand for.
const LARGEST: usize = 12;

impl Checker<'_> {
    /// A line whose left side is a symbol without a meaning gives it one. Further sides of a chain are then claims.
    pub(crate) fn defines(
        &mut self,
        sides: &[Node],
        line: &Line,
        role: Role,
        finding: &mut Finding,
    ) -> bool {
        if self.defines_function(sides, finding) {
            return true;
        }
        let [left, right, rest @ ..] = sides else {
            return false;
        };
        if !rest.is_empty() && role == Role::Claim && self.names_an_angle(left) {
            self.claim(&sides[1..], finding);
            return true;
        }
        // "⟨a = b = c = d⟩ is supposed": each of them equals the others.
        if role == Role::Assume && !rest.is_empty() && self.are_new_names(sides) {
            return false;
        }
        let Some((entity, place)) = self.new_symbol(left) else {
            return rest.is_empty()
                && (self.defines_entries(left, right, finding)
                    || self.defines_power(sides, finding));
        };
        // λ₂ = λ₃ are two symbols of one letter.
        let other = self
            .new_symbol(right)
            .is_some_and(|(_, at)| at.is_some() && at != place);
        if self.entities([right]).contains(&entity) && !other || line.continues {
            return false;
        }
        if let Some(reason) = self.is_named_by_theory(right, role) {
            finding.reason = Some(reason.to_owned());
            return true;
        }
        if role == Role::Claim && is_zero(right) && self.small.contains(&entity) {
            finding.reason = Some("what is small does not vanish by that".to_owned());
            return true;
        }
        if (role == Role::Claim || self.has_a_frequency(role)) && self.is_in_doubt(entity) {
            let symbol = self.theory.atoms.part(entity, place.unwrap_or(0), 0);
            let name = names::latex(&self.theory.atoms, symbol);
            finding.reason = Some(format!("a line about `{name}` was left open before"));
            return true;
        }
        // What is said of a symbol that earlier lines have already may follow from them, or not.
        if role == Role::Claim
            && self.theory.mentions_part(entity, place)
            && !self.is_new_fact(sides)
        {
            let mut tried = finding.clone();
            self.claim(sides, &mut tried);
            // What "yields" it and is not understood may have made it false.
            let number = symbols(right).is_empty();
            let free = self.is_moment_of_spin(left);
            let derived = self.asserted && !number && !free && self.known.contains(&entity)
                || self.obtained && is_zero(right)
                || self.runs_in_a_circle(left, &sides[1..])
                || self.is_tied_by_square(left);
            let decided = matches!(tried.verdict, Verdict::Proved(_) | Verdict::Refuted);
            if derived || decided && !self.theory.gives_rate_alone(entity) {
                *finding = tried;
                return true;
            }
        }
        let claimed = role == Role::Claim;
        if !self.firm && self.is_more_than_a_name(left, right, claimed, finding)
            || rest.is_empty()
                && (claimed
                    || role == Role::Define && !self.firm && self.is_tied_by_square(left)
                    || self.goes_on_with(role))
                && self.is_frequency(left, right, finding)
            || claimed && rest.is_empty() && self.energy_of_part(left, right, finding)
            || claimed && self.goes_on_from_a_false_line(right, finding)
            || claimed && self.is_energy_behind_a_step(left, finding)
        {
            return true;
        }
        // `λ₂ = λ₃ = 11μ` gives both, the last first.
        let chained = other && !rest.is_empty() && self.entities([right]) == [entity];
        if chained && !self.theory.mentions_part(entity, place) {
            if !self.defines(&sides[1..], line, role, finding) {
                return false;
            }
            let verdict = finding.verdict.clone();
            let both = self.accept_definition(&sides[..2], finding);
            finding.verdict = verdict;
            return both;
        }
        let value = match self.lowering(Frame::Moving).value(right) {
            Ok(value) => value,
            Err(trouble) => {
                if trouble.kind == TroubleKind::Unsupported && role != Role::Claim {
                    finding.verdict = Verdict::Accepted;
                    self.known.insert(entity);
                } else {
                    self.troubled(sides, trouble, finding);
                }
                return true;
            }
        };
        if role != Role::Assume && value.entries.iter().any(|e| self.is_inhomogeneous(e)) {
            finding.reason = Some(reason::MIXED.to_owned());
            return true;
        }
        if self.has_letter_of_another_kind(left, &value, role) {
            finding.reason = Some(reason::OTHER_KIND.to_owned());
            return true;
        }
        if self.is_no_root(left, &value, finding) {
            return true;
        }
        let Some(residuals) = self.bind(entity, place, &value) else {
            return false;
        };
        let preferred: Vec<Variable> = residuals.iter().map(|(v, _)| *v).collect();
        let residuals = residuals.into_iter().map(|(_, r)| r).collect();
        let name = self.line_name(finding);
        // What earlier lines have already is narrowed down, for as long as the section goes.
        let definition = role != Role::Assume || !self.theory.mentions_part(entity, place);
        self.mark_instant(&name, &preferred, &value.entries);
        if self.theory.assume(Premise {
            name: name.clone(),
            residuals,
            preferred,
            definition,
        }) == Taken::Contradiction
        {
            return false;
        }
        self.keep(&name, definition);
        if !definition {
            self.note_assumption(&name, role);
        }
        self.known.insert(entity);
        self.know_coordinates(&value);
        finding.verdict = Verdict::Accepted;
        if role == Role::Claim {
            finding.role = Role::Define;
        }
        if !rest.is_empty() {
            finding.role = role;
            finding.verdict = Verdict::Undecided;
            self.claim(&sides[1..], finding);
        }
        true
    }

    fn are_new_names(&mut self, sides: &[Node]) -> bool {
        let mut names = sides.iter().map(|side| self.new_symbol(side));
        names.all(|name| matches!(name, Some((_, None))))
    }

    /// Leaves a line open that its sentence derives from a false one: "⟨K = …⟩, so the effective moment is ⟨J = …⟩".
    fn goes_on_from_a_false_line(&mut self, right: &Node, finding: &mut Finding) -> bool {
        let before = self.findings.last();
        let slipped = before.filter(|f| f.verdict == Verdict::Refuted);
        // Behind a full stop "thus" speaks of more than the line above.
        let in_one_sentence = slipped.is_some_and(|f| {
            let to = f.span.behind().to(finding.span.before());
            !has_any(self.document.source.slice(to), &[". ", ".\n"])
        });
        if !self.asserted || !in_one_sentence || !self.sentence.contains('⟩') {
            return false;
        }
        let Some(last) = self.last_side.clone() else {
            return false;
        };
        let (false_ones, own) = (self.entities([&last]), self.entities([right]));
        let goes_on = own.iter().any(|entity| {
            let theory = match &self.theory.atoms.info(*entity).owner {
                Owner::Quantity(_, variant) => variant.is_empty(),
                Owner::Symbol(_) => false,
            };
            !theory && false_ones.contains(entity)
        });
        if goes_on {
            finding.reason = Some("it is derived from a line that is false".to_owned());
        }
        goes_on
    }

    /// Whether a side is a function of an angle that nothing has spoken of: the β of `tan β = a/b = 0.05`.
    fn names_an_angle(&mut self, side: &Node) -> bool {
        let Kind::Function(Function::Sin | Function::Cos | Function::Tan, argument) =
            &inner(side).kind
        else {
            return false;
        };
        let Some((entity, None)) = self.new_symbol(argument) else {
            return false;
        };
        let new = !self.known.contains(&entity) && !self.theory.mentions_entity(entity);
        self.known.extend(new.then_some(entity));
        new
    }

    /// ⟨ρ = x i + y j + z k⟩ says what x, y and z are.
    fn know_coordinates(&mut self, value: &Value) {
        let variables = value.entries.iter().filter(|entry| !entry.is_zero());
        let variables: Option<Vec<Variable>> = variables.map(Fraction::as_variable).collect();
        let atoms = &self.theory.atoms;
        let entities = variables.unwrap_or_default().into_iter();
        let entities = entities.filter_map(|variable| atoms.entity_of(variable));
        if value.is_vector() {
            self.known.extend(entities);
        }
    }

    /// `2E = …`, `M^2 = …` for an E and an M that nothing has said anything of.
    fn defines_power(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let whole = |node: &Node| matches!(node.kind, Kind::Number(_));
        let bases: Vec<&Node> = match &inner(&sides[0]).kind {
            Kind::Power(base, exponent) if whole(exponent) => vec![base],
            Kind::Product(factors) => {
                let factors = factors.iter().map(|f| match &f.node.kind {
                    Kind::Power(base, exponent) if whole(exponent) => base,
                    _ => &f.node,
                });
                factors.filter(|node| !whole(node)).collect()
            }
            _ => return false,
        };
        let [base] = bases.as_slice() else {
            return false;
        };
        let Some((entity, None)) = self.new_symbol(base) else {
            return false;
        };
        if self.theory.mentions_entity(entity) {
            return false;
        }
        let mut others = sides[1..].iter().flat_map(symbols);
        if others.any(|symbol| self.meaning_of(symbol) == Meaning::Whole(entity)) {
            return false;
        }
        if let [left, right] = sides
            && self.is_frequency(left, right, finding)
        {
            return true;
        }
        // Nor does it define what a line was to determine that was left open.
        if finding.role == Role::Claim && self.is_in_doubt(entity) {
            let name = self.theory.atoms.info(entity).latex.clone();
            finding.reason = Some(format!("a line about `{name}` was left open before"));
            return true;
        }
        // What words have named and no line speaks of may be so, or not.
        if finding.role == Role::Claim && self.known.contains(&entity) {
            if self.accept_definition(sides, finding) && !self.is_law_of_orbit(&sides[1]) {
                finding.verdict = Verdict::Undecided;
                finding.role = Role::Claim;
                finding.reason = Some(TAKEN_AS_GIVEN.to_owned());
            }
            return true;
        }
        self.accept_definition(sides, finding)
    }

    /// A matrix of new symbols on the left, with signs or zeros among them: each gets its value.
    fn defines_entries(&mut self, left: &Node, right: &Node, finding: &mut Finding) -> bool {
        let Kind::Matrix(rows) = &inner(left).kind else {
            return false;
        };
        let mut new: Vec<Entity> = vec![];
        for entry in rows.iter().flatten() {
            let entry = match &inner(entry).kind {
                Kind::Negate(inside) => inside,
                Kind::Number(_) => continue,
                _ => entry,
            };
            match self.new_symbol(entry) {
                Some((entity, None)) if !self.known.contains(&entity) => new.push(entity),
                _ => return false,
            }
        }
        if finding.role == Role::Claim && self.is_momentum_by_moments(left, right) {
            finding.reason = Some(TAKEN_AS_GIVEN.to_owned());
            return true;
        }
        let sides = [left.clone(), right.clone()];
        let Ok(read) = self.read(&sides, Frame::Moving) else {
            return false;
        };
        for &entity in &new {
            self.theory.atoms.info_mut(entity).constant = false;
        }
        let preferred = new
            .iter()
            .map(|&e| self.theory.atoms.part(e, 0, 0))
            .collect();
        let residuals = read
            .equations
            .into_iter()
            .flat_map(|e| e.residual.entries)
            .collect();
        let name = self.line_name(finding);
        let premise = Premise {
            name: name.clone(),
            residuals,
            preferred,
            definition: true,
        };
        if self.theory.assume(premise) != Taken::Solved || new.is_empty() {
            self.theory.retain(|premise| premise.name != name);
            return false;
        }
        self.keep(&name, true);
        self.known.extend(new);
        finding.verdict = Verdict::Accepted;
        finding.role = Role::Define;
        true
    }

    /// The entity of a lone symbol, or of a component, that has no meaning yet.
    pub(crate) fn new_symbol(&mut self, node: &Node) -> Option<(Entity, Option<u8>)> {
        let symbol = match &inner(node).kind {
            Kind::Symbol(symbol) => symbol,
            Kind::Call(head, arguments) if is_time(arguments) => return self.new_symbol(head),
            _ => return None,
        };
        let (entity, place) = match self.meaning_of(symbol) {
            Meaning::Whole(entity) => (entity, None),
            Meaning::Component(entity, component) => (entity, Some(component)),
            _ => return None,
        };
        let owner = self.theory.atoms.info(entity).owner.clone();
        let strange = match &owner {
            Owner::Symbol(_) => true,
            Owner::Quantity(_, variant) => !variant.is_empty() && variant != ANY_POINT,
        };
        // τ_i with a running index is no new symbol but each component of a known one.
        let running = symbol
            .subscripts
            .iter()
            .any(|s| matches!(s.as_str(), "i" | "j" | "k" | "l"));
        let known_letter = self.reading.quantities.contains_key(&Letter::of(symbol));
        if running && known_letter {
            return None;
        }
        let variable = self.theory.atoms.part(entity, place.unwrap_or(0), 0);
        (strange && self.theory.rule(variable).is_none()).then_some((entity, place))
    }

    /// Residuals that say that an entity, or one component, has a value; its shape becomes the value's.
    pub(crate) fn bind(
        &mut self,
        entity: Entity,
        place: Option<u8>,
        value: &Value,
    ) -> Option<Vec<(Variable, Fraction)>> {
        let shape = match (value.rows, value.columns) {
            (1, 1) => Shape::Scalar,
            (3, 1) | (1, 3) => Shape::Vector,
            (3, 3) => Shape::Matrix,
            (rows @ 1..=LARGEST, columns @ 1..=LARGEST) => Shape::Grid(rows as u8, columns as u8),
            _ => return None,
        };
        // The six numbers of a tensor are no entries of a grid.
        if self.theory.atoms.info(entity).shape == Shape::Symmetric {
            return None;
        }
        // A number stays what it is; of another value the parts may move.
        let moves = value.entries.iter().any(|e| !e.variables().is_empty());
        self.theory.atoms.info_mut(entity).constant &= !moves;
        let mut residual = |component: u8, entry: &Fraction| {
            let variable = self.theory.atoms.part(entity, component, 0);
            (variable, variable_fraction(variable) - entry.clone())
        };
        if let Some(component) = place {
            return (shape == Shape::Scalar).then(|| vec![residual(component, &value.entries[0])]);
        }
        let bound = value
            .entries
            .iter()
            .enumerate()
            .map(|(i, e)| residual(i as u8, e))
            .collect();
        self.theory.atoms.info_mut(entity).shape = shape;
        self.theory.atoms.forget_meanings();
        Some(bound)
    }
}

/// Whether a bracket behind a symbol holds the time alone.
fn is_time(arguments: &[Node]) -> bool {
    let [argument] = arguments else { return false };
    matches!(&inner(argument).kind, Kind::Symbol(s) if s.name == "t" && s.subscripts.is_empty())
}
