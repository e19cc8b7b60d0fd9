//! Figures that a line shows: what is said of wrong ones, and what is kept of right ones.

use crate::algebra::{Fraction, Interval};
use crate::notation::ast::{Kind, Node};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::Letter;
use crate::verify::lines::decimals::{holds_decimals, only_number, rounded, value};
use crate::verify::theory::Name;
use crate::verify::theory::decide::component;
use crate::verify::values::figures::{Alternative, is_number};
use crate::verify::values::lower::constant;
use crate::verify::values::units::scale;
use crate::verify::verdict::{Counterexample, Diagnosis, Finding, Verdict};
use num_traits::ToPrimitive;

impl Checker<'_> {
    pub(crate) fn wrong_digits(
        &mut self,
        shown: &Node,
        place: usize,
        left: &Interval,
        finding: &mut Finding,
    ) {
        let right = self.lowering(Frame::Moving).value(shown).ok();
        let right = right.and_then(|value| {
            let component = component(&value, place);
            let entry = value.entries.get(place).or(value.entries.first())?;
            let entry = self.theory.normal(entry);
            Some((component, self.theory.number_enclosure(&entry)?.middle()))
        });
        let (component, right) = right.unwrap_or((None, f64::NAN));
        let left = left.middle();
        let text = rounded_to_figures;
        finding.verdict = Verdict::Refuted;
        finding.reason = Some(format!(
            "it is {}, and {} is shown",
            text(left),
            text(right)
        ));
        finding.place = shown.span;
        finding.counterexample = Some(Counterexample {
            symbols: vec![],
            component,
            left: text(left),
            right: text(right),
        });
        finding.diagnosis = self.number_slip(shown, left, right, finding);
    }

    /// What the mistake in a number may be.
    fn number_slip(
        &self,
        shown: &Node,
        left: f64,
        right: f64,
        finding: &Finding,
    ) -> Option<Diagnosis> {
        let quotient = left / right;
        let near = |target: f64| (quotient / target - 1.0).abs() < 5e-3;
        let (kind, message) = if near(-1.0) {
            ("sign", "the sign of this number is wrong")
        } else if (-6..=6).any(|n| n != 0 && near(10_f64.powi(n))) {
            ("factor", "the decimal point of this number is misplaced")
        } else if [2.0, 0.5, 4.0, 0.25].into_iter().any(near) {
            ("factor", "this number is wrong by a factor 2 or 4")
        } else {
            ("arithmetic", "this number is wrong in a digit shown")
        };
        let place = only_number(shown);
        let suggestion = place.and_then(|(number, span)| {
            let scale = right / number.value.to_f64()?;
            let text = rounded(left / scale.abs(), number)?;
            let source = &self.document.source;
            let before = source.slice(Span {
                start: finding.span.start,
                end: span.start,
            });
            let after = source.slice(Span {
                start: span.end,
                end: finding.span.end,
            });
            let negative = matches!(&shown.kind, Kind::Negate(_));
            (!negative).then(|| format!("{before}{text}{after}").trim().to_owned())
        });
        Some(Diagnosis {
            kind,
            message: message.to_owned(),
            suggestion,
            place: Some(place.map_or(shown.span, |(_, span)| span)),
        })
    }

    /// Keeps the figures that a true line shows, for lines that go on with them.
    pub(crate) fn note_figures(&mut self, sides: &[Node], finding: &Finding) {
        if !matches!(finding.verdict, Verdict::Proved(_) | Verdict::Accepted) {
            return;
        }
        let [first, .., last] = sides else { return };
        if self.ends_in_symbols(last) {
            self.figures.decimals |= holds_decimals(last);
            return;
        }
        let (Ok(whole), Ok(shown)) = (
            self.lowering(Frame::Moving).value(first),
            self.lowering(Frame::Moving).value(last),
        ) else {
            return;
        };
        self.figures.decimals |= holds_decimals(last);
        if let Kind::Symbol(symbol) = &first.kind
            && self.reading.scalars.contains(&Letter::of(symbol))
            && self.is_in_numbers(&sides[1..])
        {
            self.figures.scalars.insert(Letter::of(symbol));
        }
        let name = self.line_name(finding);
        if whole.entries.len() != shown.entries.len() {
            return;
        }
        for (of, figure) in whole.entries.iter().zip(&shown.entries) {
            let figure = self.theory.normal(figure);
            if !is_number(&self.theory.atoms, &figure) {
                continue;
            }
            let exact = self.theory.normal(of);
            if !is_number(&self.theory.atoms, &exact) {
                continue;
            }
            if exact != figure {
                self.other_value(of, figure, format!("{name}, as rounded"));
                if let Some((number, _)) = only_number(last) {
                    self.figures.shown.push((value(number), exact));
                }
                continue;
            }
            if let Kind::WithUnit(inside, unit) = &last.kind
                && !scale(unit).is_one()
                && !scale(unit).is_angle()
                && let Some((number, _)) = only_number(inside)
            {
                let number = constant(value(number));
                self.other_value(of, number, format!("{name}, in {unit}"));
            }
        }
    }

    /// Whether the last side of a line that was proved just now comes to no number.
    fn ends_in_symbols(&mut self, last: &Node) -> bool {
        let Some((span, read)) = self.proved_as.take() else {
            return false;
        };
        let as_it_stands = self.reading.space_axes.is_none() && !read.to_order;
        let Some(equation) = read
            .equations
            .last()
            .filter(|_| as_it_stands && span == last.span)
        else {
            return false;
        };
        let mut entries = equation.right.entries.iter();
        entries.all(|entry| {
            let value = self.theory.normal(entry);
            !is_number(&self.theory.atoms, &value)
        })
    }

    fn other_value(&mut self, of: &Fraction, value: Fraction, name: Name) {
        if let Some(variable) = of.as_variable() {
            self.figures.alternatives.push(Alternative {
                variable,
                value,
                name,
            });
        }
    }
}

/// Six figures, without trailing zeros.
fn rounded_to_figures(value: f64) -> String {
    let text = format!("{value:.6e}");
    let short: f64 = text.parse().unwrap_or(value);
    if short.abs() >= 1e-4 && short.abs() < 1e9 || short.abs() < f64::MIN_POSITIVE {
        format!("{short}")
    } else {
        format!("{short:e}")
    }
}
