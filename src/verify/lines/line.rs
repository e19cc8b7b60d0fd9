//! One line: its equations, and its verdict by its role.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Line, Node, Relation};
use crate::notation::document::line_name;
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::lines::constancy::keep_their_value;
use crate::verify::lines::given::is_zero;
use crate::verify::reason;
use crate::verify::theory::Name;
use crate::verify::theory::decide::Equation;
use crate::verify::values::atoms::Owner;
use crate::verify::values::lower::{Lowering, Trouble, TroubleKind};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::value::{Value, units_in_size};
use crate::verify::verdict::{Finding, Role, Verdict};
use std::collections::BTreeSet;

/// False lines of a document whose mistakes are searched for: a search takes as long as hundreds of true lines.
pub(crate) const SEARCHES: usize = 200;

/// The equations of a line, read with one meaning of the dots that carry no frame.
#[derive(Clone)]
pub(crate) struct Read {
    pub(crate) equations: Vec<Equation>,
    pub(crate) unlabelled: Frame,
    pub(crate) ambiguous: bool,
    /// Whether the line is taken to the order of small quantities to which it is written.
    pub(crate) to_order: bool,
}

impl Read {
    /// Exact equations on the axes used.
    pub(crate) fn of(equations: Vec<Equation>) -> Self {
        Self {
            equations,
            unlabelled: Frame::Moving,
            ambiguous: false,
            to_order: false,
        }
    }

    /// What must vanish, entry by entry.
    pub(crate) fn residuals(&self) -> impl Iterator<Item = &Fraction> {
        self.equations.iter().flat_map(|e| &e.residual.entries)
    }
}

impl Checker<'_> {
    /// Decides a line on the axes that are set, and keeps what it says.
    pub(crate) fn line_as_set(&mut self, line: &Line, role: Role) {
        let mut finding = self.blank(line, role);
        self.settle(line, role, &mut finding);
        self.withhold_own_proof(&line.sides, &mut finding);
        self.measure(&line.sides, &mut finding);
        self.withhold_inhomogeneous(&line.sides, &mut finding);
        self.withhold_changing_energy(&line.sides, &mut finding);
        self.leave_hypothesis(&line.sides, &mut finding);
        self.withhold_value(line, &mut finding);
        self.withhold_false_value(line, &mut finding);
        self.note_doubt(line, &finding);
        self.note_energies(&line.sides, &finding);
        self.note_oscillation(&line.sides, &finding);
        self.note_sought(&line.sides, &finding);
        self.note_equation(&line.sides, &finding);
        self.note_quadric(&line.sides, &finding);
        self.note_lone_moment(&line.sides, &finding);
        self.note_product(&line.sides);
        let unexplained = finding.counterexample.is_some() && finding.diagnosis.is_none();
        if finding.verdict == Verdict::Refuted && unexplained && !self.reading.on_trial {
            match self.slips.len() <= SEARCHES {
                true => self.diagnose(line, &mut finding),
                false => finding.remarks.push(reason::MANY_FALSE.to_owned()),
            }
        }
        self.reading.scalars.clear();
        self.last_side = line.sides.last().cloned();
        self.note(finding);
    }

    pub(crate) fn blank(&self, line: &Line, role: Role) -> Finding {
        Finding {
            label: line.labels.first().cloned(),
            ..Finding::undecided(self.document, role, line.span)
        }
    }

    /// Says that a row could not be read.
    pub(crate) fn unreadable(&mut self, message: &str, help: Option<&str>, span: Span) {
        let line = Line {
            sides: vec![],
            relations: vec![],
            continues: false,
            labels: vec![],
            ranges: vec![],
            remarks: vec![],
            span,
        };
        let mut finding = self.blank(&line, Role::Claim);
        finding.verdict = Verdict::Unreadable;
        finding.reason = Some(message.to_owned());
        finding.remarks.extend(help.map(str::to_owned));
        self.note(finding);
    }

    pub(crate) fn settle(&mut self, line: &Line, role: Role, finding: &mut Finding) {
        self.proved_as = None;
        if self.no_equation(line, role, finding) {
            return;
        }
        if self.reading.beginnings.contains(&line.span.start) {
            finding.verdict = Verdict::Accepted;
            finding.role = Role::Given;
            self.now_known(&line.sides);
            return;
        }
        let mut sides: Vec<Node> = line.sides.clone();
        if line.continues {
            match self.last_side.clone() {
                Some(side) => sides.insert(0, side),
                None => {
                    finding.reason = Some(reason::GOES_ON_FROM_NONE.to_owned());
                    return;
                }
            }
        }
        // What is written with ≈ can be proved.
        let exact = |(relation, _): &(Relation, _)| *relation != Relation::Approximate;
        let nothing = sides.last().is_some_and(is_zero);
        let exact = line.relations.iter().all(exact);
        // A display drops nothing by itself.
        let drops = match nothing {
            true => !(exact && self.displayed),
            false => exact,
        };
        if drops && self.is_first_order(&sides) {
            finding.verdict = Verdict::Accepted;
            finding.role = Role::Assume;
            finding
                .remarks
                .push("to first order in what is small".to_owned());
            return;
        }
        keep_their_value(&mut sides);
        self.put_at_the_step(&mut sides);
        let Some(gained) = self.puts_integral_for_gain(&mut sides) else {
            finding.reason = Some(reason::INTEGRAL.to_owned());
            return;
        };
        if let Some(points) = &self.reading.points {
            points.unlabel_integrals(&mut sides);
        }
        self.figures.relations = line.relations.iter().map(|(r, _)| *r).collect();
        if let Some(span) = sides.iter().find_map(error_in) {
            finding.verdict = Verdict::Unreadable;
            finding.reason = Some(span.0);
            finding.place = span.1;
            return;
        }
        let disturbs = self.is_disturbance(&sides);
        self.note_triad(&sides);
        self.note_origin(&sides);
        self.leave_axes_behind(&sides);
        self.note_turned_moments(&sides);
        self.note_written_products(&sides);
        self.note_translation(&sides);
        self.note_wheel_energy(&sides);
        self.note_scalars(&sides);
        self.note_other_moments(&sides);
        self.note_other_energy(&sides, role);
        self.note_libration(&sides);
        self.note_cone_by_line(&sides);
        let role = self.role_by_content(role, &sides);
        if role == Role::Claim && self.names_a_moment(&sides) {
            finding.verdict = Verdict::Accepted;
            finding.role = Role::Given;
            finding.remarks.push(reason::NAMES_A_MOMENT.to_owned());
            return;
        }
        let role = match disturbs {
            true => Role::Assume,
            false => role,
        };
        finding.role = role;
        self.turn_to_case(&sides, role);
        if role == Role::Claim {
            self.take_pendulum(&sides);
            self.tie_new_symbols(&sides, finding);
            self.tie_weight(&sides, finding);
        }
        let settled = self.has_both_roots(&sides, finding)
            || self.takes_small_angle(&sides, finding)
            || self.tells_where_it_starts(&sides, finding)
            || self.vanishes_for(&sides, finding)
            || self.is_angle_of_principal_axes(&sides, role, finding)
            || self.finds_the_root(&sides, finding)
            || self.slips_in_integral(&sides, finding)
            || self.slips_in_unnamed_law(&sides, finding)
            || self.is_law_of_labelled_body(&sides, finding)
            || self.brings_wheels(&sides, finding)
            || self.brings_parts(&sides, finding)
            || self.tells_when_it_stops(&sides, finding)
            || self.says_by_use(&sides, finding)
            || role == Role::Claim && self.gives_a_turn(&sides, finding)
            || self.is_angle_of_momentum(&sides, finding)
            || !self.firm && self.precesses(&sides, finding)
            || !self.firm && self.solves_motion(&sides, finding)
            || role == Role::Claim
                && (self.is_law_of_flat_body(&sides, finding)
                    || self.are_equal_by_symmetry(&sides, finding))
            || self.is_principal_moment(&sides, finding)
            || self.defines_a_square(&sides, role, finding)
            || self.names_the_mean(&sides, finding)
            || self.steps_implicitly(&sides, role, finding)
            || self.defines(&sides, line, role, finding)
            || self.turns_to_step(&sides, role, finding)
            || !line.continues && self.slips_in_rates(line, finding)
            || role != Role::Assume && self.works_out(&sides, role, finding);
        if !settled && !self.goes_wrong_behind(&sides, role, finding) {
            match role {
                Role::Claim => self.claim(&sides, finding),
                _ => self.accept(&sides, role, finding),
            }
        }
        self.note_step(&sides, finding);
        self.leave_gain_open(gained, finding);
        self.note_flat_body(&sides, line.span);
        self.note_figures(&sides, finding);
    }

    /// A velocity of the origin that the document speaks of is not zero.
    fn note_origin(&mut self, sides: &[Node]) {
        let entities = self.entities(sides);
        let of_origin = |&entity: &_| {
            let owner = &self.theory.atoms.info(entity).owner;
            matches!(owner, Owner::Quantity(Quantity::OriginVelocity, _))
        };
        if !self.theory.setting.origin_moves && entities.iter().any(of_origin) {
            self.theory.set(|setting| setting.origin_moves = true);
        }
    }

    /// Works with some premises left out.
    pub(crate) fn lowering_without<R>(
        &mut self,
        names: BTreeSet<Name>,
        work: impl FnOnce(&mut Lowering<'_>) -> R,
    ) -> R {
        let (reading, functions, figures) = (&self.reading, &self.functions, &self.figures);
        self.theory.without(names, |theory| {
            work(&mut Lowering {
                theory,
                reading,
                unlabelled: Frame::Moving,
                met_unlabelled: false,
                in_space: false,
                functions,
                figures,
            })
        })
    }

    pub(crate) fn lowering(&mut self, unlabelled: Frame) -> Lowering<'_> {
        Lowering {
            theory: &mut self.theory,
            reading: &self.reading,
            unlabelled,
            met_unlabelled: false,
            in_space: false,
            functions: &self.functions,
            figures: &self.figures,
        }
    }

    pub(crate) fn read(&mut self, sides: &[Node], unlabelled: Frame) -> Result<Read, Trouble> {
        self.read_on(sides, unlabelled, false)
    }

    /// Reads with every vector on space axes, or as it stands.
    pub(crate) fn read_on(
        &mut self,
        sides: &[Node],
        unlabelled: Frame,
        in_space: bool,
    ) -> Result<Read, Trouble> {
        let mut lowering = self.lowering(unlabelled);
        lowering.in_space = in_space;
        let values: Vec<Value> = sides
            .iter()
            .map(|side| lowering.side(side))
            .collect::<Result<_, _>>()?;
        let ambiguous = lowering.met_unlabelled;
        let values = units_in_size(lowering.sides_aligned(values));
        let mut equations = vec![];
        for (i, pair) in values.windows(2).enumerate() {
            let equation = Equation::between(pair[0].clone(), pair[1].clone());
            equations.push(equation.map_err(|mismatch| Trouble {
                kind: TroubleKind::IllTyped,
                message: format!("the sides differ in kind: {}", mismatch.0),
                span: sides[i].span.to(sides[i + 1].span),
            })?);
        }
        Ok(Read {
            equations,
            unlabelled,
            ambiguous,
            to_order: false,
        })
    }

    fn note(&mut self, finding: Finding) {
        let place = (finding.source_line, finding.cell);
        *self.on_line.entry(place).or_default() += 1;
        self.findings.push(finding);
    }

    pub(crate) fn line_name(&self, finding: &Finding) -> String {
        let place = (finding.source_line, finding.cell);
        let name = line_name(finding.cell, finding.source_line);
        match self.on_line.get(&place) {
            None | Some(0) => name,
            Some(n) => format!("{name} ({})", n + 1),
        }
    }
}

/// The first error of a tree.
fn error_in(node: &Node) -> Option<(String, Span)> {
    match &node.kind {
        Kind::Error(message) => Some((message.clone(), node.span)),
        _ => node.children().find_map(error_in),
    }
}
