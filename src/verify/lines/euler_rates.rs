//! Three lines that give the angular velocity by the rates of angles: whether any sequence of turns has such rates.
//!
//! With e_j = ∂ω/∂q̇_j on body axes, the matrix R of the angles q obeys ∂R/∂q_j = R \[e_j\]×, and equality of its mixed
//! derivatives is ∂e_j/∂q_i − ∂e_i/∂q_j = −e_i × e_j (on space axes with a plus): the Maurer–Cartan equation of the
//! rotation group. It holds for the rates of every sequence and for nothing else, so no table of sequences is needed.

use crate::algebra::{Fraction, Variable};
use crate::mechanics;
use crate::notation::ast::{Function, Kind, Line};
use crate::notation::document::Row;
use crate::notation::reread;
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::correction::edit::edited;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::repair::slips::Slips;
use crate::verify::theory::decide::passes_filter;
use crate::verify::theory::law::Axes;
use crate::verify::values::atoms::{Atom, Entity, Owner, variable_fraction};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::values::value::Value;
use crate::verify::verdict::{Diagnosis, Finding, Verdict};
use nalgebra::{Matrix3, Vector3};
use num_traits::{One, Zero};

/// Lines among which the three components are looked for.
const NEAR: usize = 6;
/// Edits that are tried for a block at most.
const EDITS: usize = 600;

/// What came out for one line of a block.
#[derive(Clone, Debug)]
pub(crate) struct RateLine {
    /// The line.
    span: Span,
    /// The change that makes the three lines rates of a turn; `None` for a line that is right as it stands.
    slip: Option<Diagnosis>,
}

/// A component of ω as a sum of rates of angles.
#[derive(Clone, Debug)]
struct Component {
    line: Line,
    axis: u8,
    value: Fraction,
}

/// e_j with the angle that it belongs to.
type Slopes = Vec<(Variable, Vector3<Fraction>)>;

impl Checker<'_> {
    /// Whether a line is the one to change in three lines of rates that belong to no turn; the verdict is then set.
    pub(crate) fn slips_in_rates(&mut self, line: &Line, finding: &mut Finding) -> bool {
        let known = |lines: &[RateLine]| lines.iter().find(|l| l.span == line.span).cloned();
        if known(&self.rate_lines).is_none() {
            self.judge_rates(line);
        }
        let Some(slip) = known(&self.rate_lines).and_then(|known| known.slip) else {
            return false;
        };
        finding.verdict = Verdict::Refuted;
        finding.reason = Some("no turn of the axes has these three rates".to_owned());
        finding.diagnosis = Some(slip);
        true
    }

    fn judge_rates(&mut self, line: &Line) {
        let Some(block) = self.block_from(line) else {
            return;
        };
        let mut judged: Vec<RateLine> = block
            .iter()
            .map(|component| RateLine {
                span: component.line.span,
                slip: None,
            })
            .collect();
        let on_body = self.theory.setting.axes == Axes::Body;
        if on_body
            && self.is_turn(&vector(&block), true) == Some(false)
            && let Some((at, slip)) = self.slip_of(&block)
        {
            judged[at].slip = Some(slip);
        }
        self.rate_lines.extend(judged);
    }

    /// The three components, from this line on, where nothing determines them yet.
    fn block_from(&mut self, first: &Line) -> Option<Vec<Component>> {
        let document = self.document;
        self.component_on_the_left(first)?;
        let mut block: Vec<Component> = vec![];
        let from = document.lines().skip_while(|line| line.span != first.span);
        for line in from.take(NEAR) {
            let Some(component) = self.component_of_rates(line) else {
                if block.is_empty() {
                    return None;
                }
                continue;
            };
            if block.iter().all(|known| known.axis != component.axis) {
                block.push(component);
            }
        }
        (block.len() == 3).then_some(block)
    }

    /// The component of the angular velocity that stands alone on the left.
    fn component_on_the_left(&mut self, line: &Line) -> Option<(Entity, u8)> {
        let [left, _] = line.sides.as_slice() else {
            return None;
        };
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return None;
        };
        let Meaning::Component(entity, axis) = self.meaning_of(symbol) else {
            return None;
        };
        let omega = Owner::Quantity(Quantity::AngularVelocity, String::new());
        (self.theory.atoms.info(entity).owner == omega).then_some((entity, axis))
    }

    /// `ω_x = …` with rates on the right.
    fn component_of_rates(&mut self, line: &Line) -> Option<Component> {
        let (entity, axis) = self.component_on_the_left(line)?;
        let right = line.sides.last()?;
        let variable = self.theory.atoms.part(entity, axis, 0);
        if self.theory.rule(variable).is_some() {
            return None;
        }
        let entry = self.lowering(Frame::Moving).scalar(right)?;
        self.slopes(&Vector3::new(
            entry.clone(),
            Fraction::zero(),
            Fraction::zero(),
        ))?;
        Some(Component {
            line: line.clone(),
            axis,
            value: entry,
        })
    }

    /// The vectors e_j, where the components are sums of rates of angles and nothing else.
    fn slopes(&mut self, omega: &Vector3<Fraction>) -> Option<Slopes> {
        let mut slopes: Slopes = vec![];
        let mut variables: Vec<Variable> = omega.iter().flat_map(Fraction::variables).collect();
        variables.sort_unstable();
        variables.dedup();
        let mut rest = omega.clone();
        for &rate in &variables {
            let Atom::Part {
                entity,
                component,
                order: 1,
            } = *self.theory.atoms.atom(rate)
            else {
                continue;
            };
            let angle = self.theory.atoms.part(entity, component, 0);
            let slope = omega.map(|entry| entry.partial(rate));
            rest -= slope.map(|entry| entry * variable_fraction(rate));
            slopes.push((angle, slope));
        }
        let angles: Vec<Variable> = slopes.iter().map(|(angle, _)| *angle).collect();
        let of_angles = slopes.iter().flat_map(|(_, e)| e.iter()).all(|entry| {
            entry
                .variables()
                .into_iter()
                .all(|v| match self.theory.atoms.atom(v) {
                    Atom::Kernel {
                        function: Function::Sin | Function::Cos,
                        argument,
                    } => argument
                        .variables()
                        .iter()
                        .all(|v| angles.contains(v) || self.is_angle(*v)),
                    _ => false,
                })
        });
        (of_angles && rest.iter().all(Zero::is_zero)).then_some(slopes)
    }

    /// Whether a variable is a symbol of the document that moves.
    fn is_angle(&self, variable: Variable) -> bool {
        match self.theory.atoms.atom(variable) {
            Atom::Part {
                entity, order: 0, ..
            } => {
                let info = self.theory.atoms.info(*entity);
                matches!(info.owner, Owner::Symbol(_)) && !info.constant
            }
            _ => false,
        }
    }

    /// Whether a sequence of turns has these rates, on axes that the body carries or on axes of fixed orientation; with
    /// `also_between`, on axes that leave one of the turns out too. `None` where the question makes no sense.
    fn is_turn(&mut self, omega: &Vector3<Fraction>, also_between: bool) -> Option<bool> {
        let slopes = self.slopes(omega).filter(|slopes| slopes.len() == 3)?;
        if self.is_integrable(&slopes) {
            return Some(true);
        }
        let angles: Vec<Variable> = slopes.iter().map(|(angle, _)| *angle).collect();
        for angle in angles.into_iter().filter(|_| also_between) {
            for axis in 0..3 {
                for sign in [1, -1] {
                    let turn = self.elementary(axis, angle, sign)?;
                    let turned = slopes
                        .iter()
                        .map(|(angle, e)| (*angle, mechanics::apply(&turn, e)))
                        .collect();
                    if self.is_integrable(&turned) {
                        return Some(true);
                    }
                }
            }
        }
        Some(false)
    }

    /// ∂e_j/∂q_i − ∂e_i/∂q_j = ∓ e_i × e_j for every pair, with one sign for all.
    fn is_integrable(&mut self, slopes: &Slopes) -> bool {
        [1, -1].into_iter().any(|sign| {
            let sign = Fraction::from_ratio(sign, 1);
            let mut residuals = vec![];
            for (i, (q_i, e_i)) in slopes.iter().enumerate() {
                for (q_j, e_j) in &slopes[i + 1..] {
                    let across = mechanics::cross(e_i, e_j);
                    for k in 0..3 {
                        let mut lowering = self.lowering(Frame::Moving);
                        let curl =
                            lowering.partial(&e_j[k], *q_i) - lowering.partial(&e_i[k], *q_j);
                        residuals.push(curl + sign.clone() * across[k].clone());
                    }
                }
            }
            passes_filter(&mut self.theory, &Value::column(residuals)) == Some(true)
        })
    }

    /// The turn about an axis by plus or minus an angle.
    pub(crate) fn elementary(
        &mut self,
        axis: usize,
        angle: Variable,
        sign: i64,
    ) -> Option<Matrix3<Fraction>> {
        let mut lowering = self.lowering(Frame::Moving);
        let sin = lowering.kernel(Function::Sin, variable_fraction(angle))?;
        let cos = lowering.kernel(Function::Cos, variable_fraction(angle))?;
        let sin = sin * Fraction::from_ratio(sign, 1);
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut turn = Matrix3::from_element(Fraction::zero());
        turn[(axis, axis)] = Fraction::one();
        (turn[(i, i)], turn[(j, j)]) = (cos.clone(), cos);
        (turn[(i, j)], turn[(j, i)]) = (-sin.clone(), sin);
        Some(turn)
    }

    /// The cheapest single change of one of the lines after which they are rates of a turn on the body's axes.
    fn slip_of(&mut self, block: &[Component]) -> Option<(usize, Diagnosis)> {
        let mut all = vec![];
        for (at, component) in block.iter().enumerate() {
            let labels = self.frame_labels();
            let slips = Slips::new(&self.document.source, &self.reading, labels);
            let right = component.line.sides.last()?.span;
            let inside = |edit: &crate::verify::correction::edit::Edit| {
                right.start <= edit.span.start && edit.span.end <= right.end
            };
            let edits = slips.of(&component.line.sides).into_iter();
            all.extend(edits.filter(inside).map(|edit| (at, edit)));
        }
        all.sort_by_key(|(at, edit)| (edit.cost, edit.span, *at));
        for (at, edit) in all.into_iter().take(EDITS) {
            let line = &block[at].line;
            let text = edited(
                self.document.source.slice(line.span),
                line.span.start,
                &[&edit],
            );
            let Some(text) = text else { continue };
            let rows = reread(self.document, &text);
            let [Row::Line(changed)] = rows.as_slice() else {
                continue;
            };
            let Some(component) = self.component_of_rates(changed) else {
                continue;
            };
            let mut fixed = block.to_vec();
            fixed[at].value = component.value;
            if self.is_turn(&vector(&fixed), false) == Some(true) {
                let diagnosis = Diagnosis {
                    kind: edit.kind,
                    message: edit.message.clone(),
                    suggestion: Some(text.replace('&', "").trim().to_owned()),
                    place: Some(edit.span),
                };
                return Some((at, diagnosis));
            }
        }
        None
    }
}

fn vector(block: &[Component]) -> Vector3<Fraction> {
    let mut vector = Vector3::from_element(Fraction::zero());
    for component in block {
        vector[usize::from(component.axis) % 3] = component.value.clone();
    }
    vector
}
