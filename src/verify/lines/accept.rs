//! Assumptions, given lines and definitions: what a document adds to the laws.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::Node;
use crate::verify::check::Checker;
use crate::verify::lines::line::Read;
use crate::verify::theory::decide::passes_filter;
use crate::verify::theory::{Premise, Taken};
use crate::verify::values::atoms::Owner;
use crate::verify::values::lower::TroubleKind;
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Finding, Role, Verdict};

/// Words for the equations that a change of the indices gives.
const CYCLIC: &[&str] = &["cyclic", "permutation", "permuting"];

impl Checker<'_> {
    /// Takes a line in as a definition, whatever its words made of it; false where it can't be one.
    pub(crate) fn accept_definition(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        self.accept(sides, Role::Define, finding);
        let accepted = finding.verdict == Verdict::Accepted;
        if accepted {
            finding.role = Role::Define;
        }
        accepted
    }

    /// Whether a chain gives something its meaning and goes on with a side that is not equal to it: the second sign of
    /// `tan β = b/a = 2 tan α` is a claim.
    pub(crate) fn goes_wrong_behind(
        &mut self,
        sides: &[Node],
        role: Role,
        finding: &mut Finding,
    ) -> bool {
        if role != Role::Define || sides.len() < 3 {
            return false;
        }
        let mut tried = finding.clone();
        tried.role = Role::Claim;
        self.claim(&sides[1..], &mut tried);
        let wrong = tried.verdict == Verdict::Refuted;
        if wrong {
            *finding = tried;
        }
        wrong
    }

    /// Takes a given line, an assumption or a definition in.
    pub(crate) fn accept(&mut self, sides: &[Node], role: Role, finding: &mut Finding) {
        let mut readings = match self.readings(sides) {
            Ok(readings) => readings,
            Err(trouble) if trouble.kind == TroubleKind::Unsupported => {
                // What is only named, such as an integral that defines a product, contradicts nothing.
                finding.verdict = if role == Role::Define {
                    Verdict::Accepted
                } else {
                    Verdict::Undecided
                };
                finding.reason = Some(trouble.message);
                return;
            }
            Err(trouble) => return self.troubled(sides, trouble, finding),
        };
        let holds = |checker: &mut Self, read: &Read| {
            read.equations
                .iter()
                .all(|e| passes_filter(&mut checker.theory, &e.residual) == Some(true))
        };
        let index = (0..readings.len())
            .find(|&i| holds(self, &readings[i]))
            .unwrap_or(0);
        let read = readings.swap_remove(index);
        // One of Euler's equations stands for the three.
        if role != Role::Define
            && self.text.says(CYCLIC)
            && self.proved_without_moment(&read, finding.span).is_some()
        {
            finding.verdict = Verdict::Accepted;
            return;
        }
        let mut residuals = against_last(&read);
        self.roots_of_squares(&read, &mut residuals);
        if !residuals.iter().all(Fraction::is_valid) {
            finding.reason = Some("something is divided by zero".to_owned());
            return;
        }
        let left = read.equations.first().map(|e| e.left.entries.clone());
        let left = left.unwrap_or_default();
        let mut preferred: Vec<Variable> = left.iter().flat_map(Fraction::variables).collect();
        // A momentum that is given says how the body turns.
        let normals: Vec<Fraction> = left.iter().map(|entry| self.theory.normal(entry)).collect();
        let omega = Some(Owner::Quantity(Quantity::AngularVelocity, String::new()));
        let turning = normals.iter().flat_map(Fraction::variables);
        preferred.extend(turning.filter(|&v| self.theory.atoms.owner(v) == omega.as_ref()));
        preferred.extend(self.rates_of_turn(&normals));
        let name = self.line_name(finding);
        let definition = role == Role::Define;
        let given_attitude = self.writes_attitude_out(sides);
        if definition && let Some(new) = self.new_on_the_right(&normals, &read) {
            preferred = vec![new];
        }
        if let Some(first) = read.equations.first() {
            let left: Option<Vec<Variable>> = first
                .left
                .entries
                .iter()
                .map(Fraction::as_variable)
                .collect();
            self.mark_instant(&name, &left.unwrap_or_default(), &first.right.entries);
        }
        if let Some(last) = read.equations.last() {
            let left = read.equations.iter().flat_map(|e| &e.left.entries);
            let left: Option<Vec<Variable>> = left.map(Fraction::as_variable).collect();
            self.mark_rest(&name, &left.unwrap_or_default(), &last.right.entries);
        }
        let premise = Premise {
            name: name.clone(),
            residuals: residuals.clone(),
            preferred,
            definition,
        };
        match self.theory.assume(premise) {
            Taken::Contradiction if given_attitude => {
                self.end_given_attitude();
                finding.reason = Some("the attitude is known by another matrix".to_owned());
            }
            Taken::Contradiction if self.fits_rounded(sides, finding) => {}
            Taken::Contradiction => {
                finding.verdict = Verdict::Refuted;
                finding.reason =
                    Some("nothing satisfies this together with what stands before".to_owned());
                finding.residual = self.residual(&read);
            }
            Taken::Known => {
                finding.verdict = Verdict::Accepted;
                self.suppose_again(&residuals);
            }
            Taken::Solved | Taken::Kept => {
                finding.verdict = Verdict::Accepted;
                self.keep(&name, definition);
                // Names of components are no case that another one takes the place of.
                if !self.writes_components(sides) {
                    self.note_assumption(&name, role);
                }
                if self.small_turns.len() == 2 || self.linear && !self.small.is_empty() {
                    self.drop_second_order();
                }
            }
        }
        self.now_known(sides);
    }

    /// The symbol that a definition is of, where its left side has a value and one symbol of its right side is new: the n
    /// that "⟨p = Cn⟩ defines", where p is ∂L/∂ψ̇.
    fn new_on_the_right(&self, left: &[Fraction], read: &Read) -> Option<Variable> {
        if left.iter().any(|side| side.as_variable().is_some()) {
            return None;
        }
        let right = read.equations.last()?.right.as_scalar()?;
        let new = |v: &Variable| {
            let own = matches!(self.theory.atoms.owner(*v), Some(Owner::Symbol(_)));
            let entity = self.theory.atoms.entity_of(*v);
            own && entity.is_some_and(|entity| !self.theory.mentions_entity(entity))
        };
        let variables = right.variables();
        let mut found = variables.iter().copied().filter(new);
        found.next().filter(|_| found.next().is_none())
    }

    /// Whether numbers that contradict what stands before are those that it gives, rounded.
    fn fits_rounded(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        if finding.role == Role::Claim || !self.is_in_numbers(&sides[1..]) {
            return false;
        }
        let mut claim = finding.clone();
        claim.role = Role::Claim;
        self.claim(sides, &mut claim);
        let fits = matches!(claim.verdict, Verdict::Proved(_));
        if fits {
            *finding = claim;
        }
        fits
    }
}

/// What a line says, each side of a chain against the last: of `a = b = 0` that both are zero.
fn against_last(read: &Read) -> Vec<Fraction> {
    let mut residuals: Vec<Vec<Fraction>> = read
        .equations
        .iter()
        .map(|e| e.residual.entries.clone())
        .collect();
    for i in (1..residuals.len()).rev() {
        let (before, after) = residuals.split_at_mut(i);
        let (Some(left), Some(right)) = (before.last_mut(), after.first()) else {
            break;
        };
        if left.len() == right.len() {
            left.iter_mut()
                .zip(right)
                .for_each(|(l, r)| *l += r.clone());
        }
    }
    residuals.into_iter().flatten().collect()
}
