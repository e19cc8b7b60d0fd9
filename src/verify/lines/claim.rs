//! Claims: proved, refuted or open.

use crate::algebra::{Fraction, Proof};
use crate::notation::ast::{Kind, Node, Relation, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, axes, axis, inner, symbols};
use crate::verify::lines::line::Read;
use crate::verify::names;
use crate::verify::reason;
use crate::verify::theory::decide::{Decision, decide, needed};
use crate::verify::values::atoms::Entity;
use crate::verify::values::atoms::Owner;
use crate::verify::values::figures::is_number;
use crate::verify::values::lower::{Trouble, TroubleKind};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::symbol::{MAGNITUDE, Meaning};
use crate::verify::verdict::{Finding, Role, Verdict};
use num_traits::Zero;

impl Checker<'_> {
    pub(crate) fn claim(&mut self, sides: &[Node], finding: &mut Finding) {
        if sides.iter().any(|side| self.differentiates_a_vector(side)) {
            finding.reason = Some(reason::SLOPE_OF_VECTOR.to_owned());
            return;
        }
        let readings = match self.readings(sides) {
            Ok(readings) => readings,
            Err(trouble) => {
                if !self.wrong_arithmetic(sides, finding) {
                    self.troubled(sides, trouble, finding);
                }
                return;
            }
        };
        let (mut failed, mut emptied) = (None, false);
        let both = (readings.len() > 1).then(|| readings.clone());
        for read in readings {
            match decide(&mut self.theory, &read.equations) {
                Decision::True(proof) if self.is_emptied(sides, &read, &proof) => emptied = true,
                Decision::True(proof) => {
                    let anew = both.as_ref();
                    if anew.is_some_and(|both| self.reads_dots_anew(both, read.unlabelled, sides)) {
                        finding.reason = Some(reason::OTHER_DOTS.to_owned());
                        return;
                    }
                    self.note_written_out(sides, &read);
                    self.proved(&read, proof, finding);
                    let last = sides.last().filter(|_| read.unlabelled == Frame::Moving);
                    self.proved_as = last.map(|side| (side.span, read));
                    return;
                }
                other => failed = failed.or(Some((read, other))),
            }
        }
        if emptied {
            finding.reason = Some(reason::EMPTIED.to_owned());
            return;
        }
        if let Some((read, decision)) = failed {
            if matches!(decision, Decision::False(_))
                && let Some(proof) = self.proved_without_moment(&read, finding.span)
            {
                return self.proved(&read, proof, finding);
            }
            let open = matches!(decision, Decision::Open(_));
            if open
                && (self.proved_by_rates_of_angles(&read, finding)
                    || self.proved_on_space_axes(sides, finding))
            {
                return;
            }
            if !open
                && (self.is_law_in_space(sides, finding)
                    || self.chooses_another_law(sides, finding)
                    || self.proved_about_the_spin(sides, finding))
            {
                return;
            }
            if !open
                && (self.names_components(sides, finding) || self.names_an_integral(sides, finding))
            {
                return;
            }
            if self.settled_by_squares(&read, open, finding) {
                return;
            }
            if self.loads_the_axle(sides, finding) || self.names_and_claims(sides, finding) {
                return;
            }
            let may_be_given = !read.to_order && (!open || self.is_in_numbers(&sides[1..]));
            if may_be_given && self.is_given(sides, &read) {
                match self.is_for_the_laws(sides, &read) {
                    Some(reason) => finding.reason = Some(reason.to_owned()),
                    None => self.given(sides, finding),
                }
                return;
            }
            if self.seeks_roots(sides, finding)
                || self.hands_over_a_load(sides, finding)
                || self.goes_on(sides, &read, finding)
                || self.grows_from_the_beginning(sides, finding)
                || self.follows_from_rest(sides, &read, finding)
                || self.settled_by_numbers(sides, &read, open, finding)
                || self.holds_still(sides, finding)
                || self.holds_from_the_start(sides, finding)
            {
                return;
            }
            if self.lacks_numbers(sides) {
                if self.takes_numbers(sides, finding) {
                    return;
                }
                finding.reason = Some("nothing before gives the numbers for this".to_owned());
                return;
            }
            self.failed(sides, &read, decision, finding);
        }
    }

    /// `\vec v = d\vec r/dt = \vec\omega\times\vec r`: what a chain calls the velocity of a point, which nothing has spoken
    /// of, and a claim about it.
    fn names_and_claims(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        if sides.len() < 3 || !self.names_velocity(sides) {
            return false;
        }
        let velocity = self.entities(&sides[..1]);
        let [velocity] = velocity.as_slice() else {
            return false;
        };
        if self.theory.mentions_entity(*velocity) || self.is_in_doubt(*velocity) {
            return false;
        }
        let mut tried = finding.clone();
        self.claim(&sides[1..], &mut tried);
        if !matches!(tried.verdict, Verdict::Proved(_) | Verdict::Refuted) {
            return false;
        }
        let mut named = finding.clone();
        self.accept(&sides[..2], Role::Define, &mut named);
        *finding = tried;
        true
    }

    /// A vector that is written out by its own components, `v = v₁b₁ + v₂b₂ + v₃b₃`, is spoken of: it may be any.
    fn note_written_out(&mut self, sides: &[Node], read: &Read) {
        let [left, _] = sides else { return };
        if let Kind::Symbol(symbol) = &inner(left).kind
            && let Meaning::Whole(entity) = self.meaning_of(symbol)
            && self.theory.atoms.info(entity).shape == Shape::Vector
            && read.residuals().all(Zero::is_zero)
        {
            self.known.insert(entity);
        }
    }

    pub(crate) fn proved(&mut self, read: &Read, proof: Proof, finding: &mut Finding) {
        finding.uses = needed(&mut self.theory, &read.equations, &proof);
        finding.conditions = self.conditions(&proof);
        finding.verdict = Verdict::Proved(proof);
        if read.to_order {
            let order = "to the order of small quantities to which it is written";
            finding.remarks.push(order.to_owned());
        }
        if read.ambiguous && self.dots.is_none() {
            let seen = match read.unlabelled {
                Frame::Space => "a dot without a frame is read as the rate seen from space",
                Frame::Moving => "a dot without a frame is read as the rate on the axes used",
            };
            finding.remarks.push(seen.to_owned());
        }
    }

    /// Denominators that must not vanish.
    pub(crate) fn conditions(&mut self, proof: &Proof) -> Vec<String> {
        let mut conditions = vec![];
        for below in proof.arguments().iter().flat_map(|a| &a.conditions) {
            // The length of a unit quaternion needs no mention.
            let value = self.theory.normal(&Fraction::from(below.clone()));
            if is_number(&self.theory.atoms, &value) {
                continue;
            }
            let text = format!("{} \\ne 0", names::polynomial(&self.theory.atoms, below));
            if !conditions.contains(&text) {
                conditions.push(text);
            }
        }
        conditions
    }

    pub(crate) fn failed(
        &mut self,
        sides: &[Node],
        read: &Read,
        decision: Decision,
        finding: &mut Finding,
    ) {
        let unknown = self.unknown_in(sides, Some(read));
        let loose = match decision {
            Decision::False(_) => self
                .is_between_states(read)
                .or_else(|| self.doubt(read))
                .or_else(|| self.on_numbered_axes(sides))
                .or_else(|| self.on_lettered_axes(sides))
                .or_else(|| self.turns_with_the_axes(sides))
                .or_else(|| self.rests_on_a_reading(sides, read)),
            _ => None,
        };
        let approximate = !read.to_order && self.figures.relations.contains(&Relation::Approximate);
        match decision {
            Decision::Open(reason) => finding.reason = Some(reason),
            _ if approximate => {
                finding.reason =
                    Some("an approximation is decided where both sides are numbers".to_owned());
            }
            _ if unknown.is_some() => {
                finding.reason = unknown.map(|name| format!("nothing before says what {name} is"));
            }
            Decision::FalseWithoutWitness => {
                finding.reason = Some(reason::NO_WITNESS.to_owned());
            }
            Decision::False(_) if self.vanishes_by_kernels(read) => {
                finding.reason = Some(reason::NO_WITNESS.to_owned());
            }
            Decision::False(_) if loose.is_some() => {
                finding.reason = loose;
            }
            Decision::False(witness) => {
                finding.verdict = Verdict::Refuted;
                finding.reason = Some("the sides differ".to_owned());
                finding.counterexample = Some(*witness);
                finding.residual = self.residual(read);
                self.carry(&read.equations, finding);
            }
            Decision::True(_) => {}
        }
    }

    /// Whether nothing is left over by what holds of sines, roots and lengths of one.
    fn vanishes_by_kernels(&mut self, read: &Read) -> bool {
        let mut left = read.residuals();
        left.all(|entry| self.theory.kernels_reduced(entry.clone()).is_zero())
    }

    /// The first component that is not zero, in the author's symbols.
    pub(crate) fn residual(&mut self, read: &Read) -> Option<String> {
        read.residuals().find_map(|entry| {
            let reduced = self.theory.normal(entry);
            let entry = &self.theory.kernels_reduced(entry.clone());
            let shown = if entry.numerator().len() <= reduced.numerator().len() {
                entry
            } else {
                &reduced
            };
            (!reduced.is_zero()).then(|| names::fraction(&self.theory.atoms, shown))
        })
    }

    pub(crate) fn troubled(&mut self, sides: &[Node], trouble: Trouble, finding: &mut Finding) {
        finding.place = trouble.span;
        let sure = trouble.kind == TroubleKind::IllTyped
            && !self
                .entities(sides)
                .into_iter()
                .any(|e| self.is_in_doubt(e))
            && self.unknown(sides).is_none()
            && self.all_marked(sides);
        finding.verdict = match trouble.kind {
            TroubleKind::Unreadable => Verdict::Unreadable,
            TroubleKind::IllTyped if sure => Verdict::Refuted,
            _ => Verdict::Undecided,
        };
        finding.reason = Some(trouble.message);
    }

    /// Whether every symbol shows its kind by a mark or an index, or is a quantity of the theory.
    pub(crate) fn all_marked(&mut self, sides: &[Node]) -> bool {
        if sides.iter().any(has_list) {
            return false;
        }
        sides.iter().flat_map(symbols).all(|symbol| {
            let index = symbol.subscripts.iter().any(|s| axis(s).is_some() || axes(s).is_some());
            let marked = symbol.style.vector || index;
            marked || !matches!(
                self.meaning_of(symbol),
                Meaning::Whole(entity) if !matches!(self.theory.atoms.info(entity).shape, Shape::Scalar)
            )
        })
    }

    /// A symbol of the line that neither the document nor the theory has given a meaning, or a quantity that nothing
    /// determines.
    pub(crate) fn unknown(&mut self, sides: &[Node]) -> Option<String> {
        self.unknown_in(sides, None)
    }

    /// The same for a line that fails, but for symbols that the difference is a multiple of: it fails whatever they are.
    fn unknown_in(&mut self, sides: &[Node], failed: Option<&Read>) -> Option<String> {
        let over = sides.iter().flat_map(integrated_over);
        let over: Vec<&Symbol> = over.collect();
        for symbol in sides.iter().flat_map(symbols) {
            let Some(entity) = self
                .entity_named(symbol)
                .filter(|_| !over.contains(&symbol))
            else {
                continue;
            };
            let info = self.theory.atoms.info(entity).clone();
            let strange = match &info.owner {
                Owner::Symbol(_) => true,
                Owner::Quantity(quantity, variant) => {
                    // What ω is between two frames of several, no law here says.
                    let between = variant.matches('^').count() > 1;
                    let of_step = matches!(variant.as_str(), "k" | "n" | "k+1" | "n+1");
                    !variant.is_empty()
                        && variant != MAGNITUDE
                        && !of_step
                        && (between
                            || !matches!(quantity, Quantity::Inertia | Quantity::AngularVelocity))
                }
            };
            // The arrow from one point to another says itself what it is.
            let arrow = symbol.style.vector
                && symbol.name.len() > 1
                && symbol.name.chars().all(|c| c.is_ascii_uppercase());
            // The g of a weight needs no words.
            let weight = symbol.name == "g" && symbol.subscripts.is_empty() && !symbol.style.vector;
            // Beside δω, the δ of a bracket is the same variation.
            let bare = symbol.name == "delta" && symbol.subscripts.is_empty();
            let operator = bare && !self.reading.usage.varied.is_empty();
            let quantity = self.reading.quantities.get(&Letter::of(symbol));
            let varied = symbol.variation && quantity == Some(&Quantity::AngularVelocity);
            // Nothing gives a size in numbers before its vector has one.
            let size = matches!(&info.owner, Owner::Quantity(_, variant) if variant == MAGNITUDE)
                && sides.iter().any(|side| symbols(side).is_empty());
            let named = arrow || weight || operator || varied;
            let unknown = strange && !named && !self.known.contains(&entity);
            let scales = failed.is_some_and(|read| self.only_scales(entity, read));
            let value = self.theory.atoms.value(entity, 0, 0);
            let value = self.theory.normal(&value);
            let open = size && !is_number(&self.theory.atoms, &value);
            if open || unknown && !scales && self.is_free(entity) {
                return Some(format!("`{}`", symbol.name));
            }
        }
        None
    }
}

impl Checker<'_> {
    /// Whether a difference is a power of a symbol that earlier lines have, times something without it.
    fn only_scales(&mut self, entity: Entity, read: &Read) -> bool {
        let variable = self.theory.atoms.part(entity, 0, 0);
        let scalar = self.theory.atoms.info(entity).shape == Shape::Scalar;
        let mut entries = read.residuals().map(|entry| self.theory.normal(entry));
        let scales = entries.all(|rest| {
            let above = rest.numerator();
            let degree = above.degree_in(variable);
            let lower = (0..degree).all(|k| above.coefficient_of(variable, k).is_zero());
            rest.is_zero() || degree > 0 && lower
        });
        self.displayed && scalar && scales && self.theory.mentions_entity(entity)
    }
}

/// Whether a list stands in a node: what brackets around several things mean is the author's own.
fn has_list(node: &Node) -> bool {
    matches!(node.kind, Kind::Tuple(_)) || node.children().any(has_list)
}

/// The variables of the integrals in a formula: the V of dV needs no words.
fn integrated_over(node: &Node) -> Vec<&Symbol> {
    let mut found: Vec<&Symbol> = node.children().flat_map(integrated_over).collect();
    if let Kind::Integral { variable, .. } = &node.kind
        && let Kind::Symbol(symbol) = &variable.kind
    {
        found.push(symbol);
    }
    found
}
