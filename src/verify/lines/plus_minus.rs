//! Both roots in one line: `\lambda = -b \pm \sqrt{b^2 - c}` of an equation above, and the principal moments of two axes,
//! `I_{1,2} = \frac12(I_{xx} + I_{yy}) \pm \sqrt{\ldots}`.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::{Item, Row};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::lines::given::is_zero;
use crate::verify::theory::Theory;
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::theory::law::inertia;
use crate::verify::values::atoms::{Atom, variable_fraction};
use crate::verify::values::lower::put_in;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::value::Value;
use crate::verify::verdict::{Counterexample, Finding, Verdict};
use crate::verify::words::book::{has_any, lowered};
use std::collections::{BTreeSet, HashMap};

/// Words for the roots of the equation that stands right above.
const ROOTS: &[&str] = &["root", "quadratic", "solutions", "solved for"];

/// Equations that roots may be of, the last ones.
const MOST_EQUATIONS: usize = 6;

impl Checker<'_> {
    /// Keeps an equation that has zero on its right, in a document that speaks of roots; and any other that is proved, whose
    /// roots a line may give, though not refuse.
    pub(crate) fn note_equation(&mut self, sides: &[Node], finding: &Finding) {
        let [_, right] = sides else { return };
        let holds = !matches!(finding.verdict, Verdict::Refuted | Verdict::Unreadable);
        let proved = matches!(finding.verdict, Verdict::Proved(_));
        let zero = is_zero(right);
        if !holds || !zero && !proved || !self.text.says(&["\\pm", "±", "root"]) {
            return;
        }
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return;
        };
        if let [only] = read.residuals().collect::<Vec<_>>().as_slice() {
            let kept = match zero {
                true => &mut self.equations,
                false => &mut self.balances,
            };
            if kept.len() == MOST_EQUATIONS {
                kept.remove(0);
            }
            kept.push((*only).clone());
        }
    }

    /// Decides a line with ± by putting both values in for the symbol on its left.
    pub(crate) fn has_both_roots(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, right] = sides else { return false };
        if count(right) != 1 {
            return false;
        }
        // Beside a number, the letter of a vector is its size.
        let mut one = right.clone();
        choose(&mut one, false);
        self.note_scalars(&[left.clone(), one]);
        // What the document supposes may be the very equation, or that products vanish which words only lead away from.
        let names = self.theory.premises().iter().map(|p| p.name.clone());
        let names: BTreeSet<String> = names.collect();
        let values = self.lowering_without(names.clone(), |lowering| {
            [false, true].map(|negative| {
                let mut side = right.clone();
                choose(&mut side, negative);
                lowering.value(&side).ok()
            })
        });
        let [Some(plus), Some(minus)] = values else {
            return false;
        };
        let (Some(plus), Some(minus)) = (plus.as_scalar(), minus.as_scalar()) else {
            return false;
        };
        let Some((unknown, residual)) = self.equation_of_roots(left, plus) else {
            return self.are_roots_of_a_balance(left, [plus, minus], &names, finding);
        };
        let equations = at_each(&residual, unknown, [plus, minus]);
        let decision = self
            .theory
            .without(names, |theory| decide(theory, &equations));
        match decision {
            Decision::True(proof) => finding.verdict = Verdict::Proved(proof),
            Decision::False(witness) => fails_at(*witness, finding),
            _ => return false,
        }
        true
    }

    /// Whether the formula behind words of principal moments has a product of inertia in a power: it leads to other axes,
    /// which are principal.
    pub(crate) fn seeks_moments(&mut self, span: Span) -> bool {
        let next = self.document.items.iter().find_map(|item| match item {
            Item::Formula(formula) if formula.span.start >= span.end => Some(formula),
            _ => None,
        });
        let mut powers = vec![];
        let sides = next.into_iter().flat_map(|formula| &formula.rows);
        let sides = sides.filter_map(|row| match row {
            Row::Line(line) => Some(&line.sides),
            _ => None,
        });
        sides.flatten().for_each(|side| bases(side, &mut powers));
        powers
            .into_iter()
            .any(|base| self.product_of_inertia(base).is_some())
    }

    /// Whether both values satisfy a proved equation above that is written with terms on both sides.
    fn are_roots_of_a_balance(
        &mut self,
        left: &Node,
        values: [&Fraction; 2],
        names: &BTreeSet<String>,
        finding: &mut Finding,
    ) -> bool {
        let Some(own) = self.own_variable(left) else {
            return false;
        };
        let balances = self.balances.iter().rev();
        let second = balances.filter(|residual| residual.numerator().degree_in(own) == 2);
        let second: Vec<Fraction> = second.cloned().collect();
        let decisions = second.iter().map(|residual| {
            let equations = at_each(residual, own, values);
            let decided = |theory: &mut Theory| decide(theory, &equations);
            self.theory.without(names.clone(), decided)
        });
        let mut last_fails = None;
        for (at, decision) in decisions.enumerate() {
            match decision {
                Decision::True(proof) => {
                    finding.verdict = Verdict::Proved(proof);
                    return true;
                }
                Decision::False(witness) if at == 0 => last_fails = Some(witness),
                _ => {}
            }
        }
        // Only words tie it to the last of them.
        let words = lowered(&self.sentence);
        let Some(witness) = last_fails.filter(|_| has_any(&words, ROOTS)) else {
            return false;
        };
        fails_at(*witness, finding);
        true
    }

    /// The variable that a symbol stands for, whatever label its roots have.
    fn own_variable(&mut self, left: &Node) -> Option<u32> {
        let mut bare = left.clone();
        bare.change_symbols(&mut |symbol| {
            symbol.subscripts.clear();
        });
        let own = self.lowering(Frame::Moving).value(&bare).ok();
        own.and_then(|own| own.as_scalar().and_then(Fraction::as_variable))
    }

    /// The equation that the symbol on the left is to satisfy, and the variable in it that stands for the symbol.
    fn equation_of_roots(&mut self, left: &Node, value: &Fraction) -> Option<(u32, Fraction)> {
        let own = self.own_variable(left);
        let second =
            |residual: &&Fraction| own.is_some_and(|own| residual.numerator().degree_in(own) == 2);
        if let Some(residual) = self.equations.iter().rev().find(second) {
            return Some((own?, residual.clone()));
        }
        self.equation_of_moments(left, value)
    }

    /// (λ − I_aa)(λ − I_bb) = I_ab², where the entries of the axes a and b stand in the value and the letter is that of the
    /// inertia, or the words speak of principal moments.
    fn equation_of_moments(&mut self, left: &Node, value: &Fraction) -> Option<(u32, Fraction)> {
        let Kind::Symbol(Symbol { name, .. }) = &inner(left).kind else {
            return None;
        };
        let named = self.reading.quantities.get(&Letter::plain(name)) == Some(&Quantity::Inertia);
        if !named && !self.sentence.to_lowercase().contains("principal") {
            return None;
        }
        let tensor = inertia(&mut self.theory.atoms, self.theory.setting.products);
        let met: BTreeSet<u32> = value
            .variables()
            .into_iter()
            .flat_map(|v| self.theory.atoms.with_arguments(v))
            .collect();
        let latex = "\\lambda".to_owned();
        let unknown = self.theory.atoms.special(Atom::Opaque { latex });
        [(0, 1), (1, 2), (2, 0)].into_iter().find_map(|(a, b)| {
            let entries = [(a, a), (b, b), (a, b)].map(|at| tensor[at].clone());
            let inside = entries.iter().flat_map(Fraction::variables);
            let inside: BTreeSet<u32> = inside.collect();
            if !inside.iter().all(|v| met.contains(v)) {
                return None;
            }
            let [first, second, product] = entries;
            let root = variable_fraction(unknown);
            let sides = (root.clone() - first) * (root - second);
            Some((unknown, sides - product.clone() * product))
        })
    }
}

fn fails_at(witness: Counterexample, finding: &mut Finding) {
    finding.verdict = Verdict::Refuted;
    finding.reason = Some("the values do not satisfy the equation".to_owned());
    finding.counterexample = Some(witness);
}

/// What vanishes, with each of two values for an unknown.
fn at_each(residual: &Fraction, unknown: u32, values: [&Fraction; 2]) -> [Equation; 2] {
    values.map(|value| {
        let images = HashMap::from([(unknown, value.clone())]);
        Equation::vanishing(Value::scalar(put_in(residual, &images)))
    })
}

/// The bases of the powers in a node.
fn bases<'n>(node: &'n Node, found: &mut Vec<&'n Node>) {
    if let Kind::Power(base, _) = &node.kind {
        found.push(base);
    }
    node.children().for_each(|child| bases(child, found));
}

/// How many signs ± stand in a node.
fn count(node: &Node) -> usize {
    let own = usize::from(matches!(node.kind, Kind::PlusMinus(_)));
    own + node.children().map(count).sum::<usize>()
}

/// Puts one sign in the place of ±.
fn choose(node: &mut Node, negative: bool) {
    if let Kind::PlusMinus(inside) = &node.kind {
        let inside = inside.clone();
        node.kind = match negative {
            true => Kind::Negate(inside),
            false => inside.kind,
        };
        return;
    }
    node.children_mut()
        .into_iter()
        .for_each(|child| choose(child, negative));
}
