//! Rules for operators: d/dt, δ/δt, `a\times`, and commands of the author.

use crate::notation::ast::{DerivativeStyle, Factor, FrameLabel, Kind, Node, Operator};
use crate::notation::document::Row;
use crate::notation::{Macros, read_formula};
use crate::verify::language::heads::{
    CROSS_PRODUCT, DERIVATIVE, DOT_PRODUCT, PARTIAL_DERIVATIVE, PRODUCT_OF_QUATERNIONS,
    QUATERNION_DOT, QUATERNION_PRODUCT,
};
use crate::verify::language::statement::{
    Declaration, Extent, Formula, NotationMeaning, NounPhrase, Sign, Slot, Statement, Term,
};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{letter_of, name_of, node_of, reach_of};
use crate::verify::reading::unused::Touches;
use crate::verify::term::customs::BracketProduct;
use crate::verify::term::labels::plain;
use crate::verify::term::letters::{Effect, LabelRule, Mark, MarkRule, Reach, spelled};
use crate::verify::term::written::{TURNING_RATE, WrittenSymbols};

/// The signs of a cross product.
const CROSSES: [&str; 2] = ["\\times", "\\wedge"];

/// Whether a writing ends with a star that stands before something.
fn ends_with_star(written: &str) -> bool {
    let stars = ["\\ast", "\\star", "*"];
    stars.iter().any(|star| written.trim_end().ends_with(star))
}

impl Builder<'_> {
    /// Whether a sentence says which product two vectors in brackets are.
    pub(super) fn read_product_in_brackets(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> bool {
        let product = match what.head {
            CROSS_PRODUCT => BracketProduct::Cross,
            DOT_PRODUCT => BracketProduct::Dot,
            _ => return false,
        };
        let Some((opening, list)) = in_brackets(subjects) else {
            return false;
        };
        // Of what stands in the brackets, in the same order.
        let of = what.all(Slot::Of).filter_map(letter_of).filter_map(node_of);
        let of: Vec<String> = of.map(spelled).collect();
        let everywhere = declaration.extent == Extent::Document;
        match everywhere && of.len() == 2 && of == list {
            true => {
                let products = &mut self.reading.letters.customs.products;
                products.in_brackets.insert(opening, product);
            }
            false => {
                self.say_unused(declaration);
                // Any letters may stand in such brackets.
                let sentence = declaration.sentence();
                let own = self.reading.unused.iter_mut();
                own.filter(|u| u.sentence == sentence).for_each(|unused| {
                    (unused.touches, unused.tells) = (Touches::Everything, true);
                });
            }
        }
        true
    }

    /// "`d/dt` is the rate seen from N", "`\omega\times` is the cross-product matrix of `\omega`".
    pub(super) fn read_operator_rule(
        &mut self,
        formula: &Formula,
        meaning: &NotationMeaning,
        effect: Effect,
        declaration: &Declaration,
    ) {
        let written = formula.source.as_str();
        let reach = reach_of(&declaration.extent);
        let rate = matches!(effect, Effect::RateSeenFrom(_));
        if effect == Effect::CrossProductMatrix
            && let NotationMeaning::Noun(phrase) = meaning
            && let Some(Term::Formula(of)) = phrase.slot(Slot::Of)
            && CROSSES
                .iter()
                .any(|sign| written.trim_end().ends_with(sign))
        {
            let letters = &mut self.reading.letters.crossing;
            letters.extend(node_of(of).map(spelled));
        } else if effect == Effect::CrossProductMatrix && ends_with_star(written) {
            // A star between letters is read as a product like any other.
            self.say_unused(declaration);
        } else if rate && self.names_its_frame(written, &effect) {
            // Its own command says from where the rate is seen.
        } else if let Some(label) = label_of_rate(written).filter(|_| rate) {
            self.read_labelled_rate(label, effect, reach, declaration);
        } else if let Some(mark) = rate_in_time(written).filter(|&m| rate || m == Mark::Partial) {
            self.reading.letters.marks.push(MarkRule {
                mark,
                effect,
                reach,
            });
        } else if rate || node_of(formula).is_none() {
            self.say_unused(declaration);
        }
    }

    /// "`\frac{d'}{dt}` is the rate seen from B": what is said of a rate with a label is said of no other.
    fn read_labelled_rate(
        &mut self,
        label: String,
        effect: Effect,
        reach: Reach,
        declaration: &Declaration,
    ) {
        let letters = &self.reading.letters;
        let named = letters.frame(&label).is_some();
        if named && !self.is_seen_from(&effect, &label) {
            return self.say_unused(declaration);
        }
        // Where no d/dt is written beside it a δ is read as a d.
        let marks = &letters.written;
        if label == FrameLabel::DELTA && !marks.has(TURNING_RATE) {
            self.reading.letters.marks.push(MarkRule {
                mark: Mark::Leibniz,
                effect: effect.clone(),
                reach: reach.clone(),
            });
        }
        let labels = match label.as_str() {
            FrameLabel::DELTA => vec![FrameLabel::DELTA, FrameLabel::TURNING],
            _ => vec![label.as_str()],
        };
        for label in labels {
            self.reading.letters.labels.push(LabelRule {
                label: label.to_owned(),
                effect: effect.clone(),
                on_whole: true,
                component: None,
                reach: reach.clone(),
            });
        }
    }

    /// The cross product of vectors of a plane is its component across that.
    pub(super) fn read_cross_across(&mut self, component: &NounPhrase, said: &Declaration) {
        let along = component.slot(Slot::Along);
        let Some(axis) = along.and_then(|along| self.direction(along, said, None)) else {
            return self.say_unused(said);
        };
        let products = &mut self.reading.letters.customs.products;
        products.across.push((reach_of(&said.extent), axis));
    }

    /// Whether an effect is a rate seen from the frame of this name.
    fn is_seen_from(&self, effect: &Effect, label: &str) -> bool {
        match effect {
            Effect::RateSeenFrom(frame) => {
                let name = &self.reading.system.frames[*frame].name;
                name.trim_end_matches("~cal") == label
            }
            _ => false,
        }
    }

    /// Whether an operator is a command of the author that ends with the name of the frame: `\ddtA`.
    fn names_its_frame(&self, written: &str, effect: &Effect) -> bool {
        let Effect::RateSeenFrom(frame) = effect else {
            return false;
        };
        let name = &self.reading.system.frames[*frame].name;
        let letters =
            |text: &str| -> String { text.chars().filter(|c| c.is_alphabetic()).collect() };
        let (command, name) = (
            letters(written.trim()),
            letters(name.trim_end_matches("~cal")),
        );
        let single = written.trim().strip_prefix('\\') == Some(command.as_str());
        single && !name.is_empty() && command.ends_with(&name)
    }
}

/// Whether a sentence says of a writing of a derivative what it shows: "`\diff{f}{t}` is the derivative of f in t".
pub(super) fn reads_derivative(subjects: &[Term], what: &NounPhrase) -> bool {
    let partial = what.head == PARTIAL_DERIVATIVE;
    if !partial && what.head != DERIVATIVE {
        return false;
    }
    let [Term::Formula(written)] = subjects else {
        return false;
    };
    let own = |node: &Node, slot: Slot| what.slot(slot).and_then(name_of) == Some(spelled(node));
    match node_of(written).map(|node| &node.kind) {
        Some(Kind::Derivative {
            operand,
            variables,
            partial: round,
        }) => {
            let variable = matches!(variables.as_slice(), [only] if own(only, Slot::In));
            *round == partial && variable && own(operand, Slot::Of)
        }
        Some(Kind::TimeDerivative {
            operand,
            order: 1,
            style: DerivativeStyle::Leibniz,
            frame: None,
        }) => {
            let in_time = what.slot(Slot::In).and_then(name_of).as_deref() == Some("t");
            !partial && in_time && own(operand, Slot::Of)
        }
        _ => false,
    }
}

/// Whether a derivative is written with δ: `\delta/\delta t`.
fn is_rate_of_deltas(written: &str) -> bool {
    let plain: String = written.chars().filter(|c| !c.is_whitespace()).collect();
    plain.contains("\\delta") && plain.trim_end_matches('}').ends_with("\\deltat")
}

/// Whether a derivative is one in time, with d, with δ or with ∂.
pub(super) fn rate_in_time(written: &str) -> Option<Mark> {
    let plain: String = written
        .chars()
        .filter(|c| !c.is_whitespace() && !"\\{}_".contains(*c))
        .collect();
    if plain.ends_with("partialt") {
        return Some(Mark::Partial);
    }
    let total = written.contains("dt")
        || plain.ends_with("dt")
        || written.contains("{t}")
        || is_rate_of_deltas(written);
    total.then_some(Mark::Leibniz)
}

/// The sentence, or one that was not understood in its place: what δ/δt is beside d/dt is told of lines that write both.
pub(super) fn if_rates_are_told_apart(
    said: Declaration,
    all: &[Declaration],
    written: &WrittenSymbols,
) -> Declaration {
    let operator = |d: &Declaration| match &d.statement {
        Statement::Notation {
            sign: Sign::Operator(formula),
            ..
        } => Some(formula.source.clone()),
        _ => None,
    };
    let total = |written: String| {
        rate_in_time(&written) == Some(Mark::Leibniz) && !is_rate_of_deltas(&written)
    };
    match operator(&said) {
        Some(writing)
            if is_rate_of_deltas(&writing)
                && !written.has(TURNING_RATE)
                && all.iter().filter_map(operator).any(total) =>
        {
            said.not_understood()
        }
        _ => said,
    }
}

/// "`$\times$` means the component of the cross product along z", "`$a\times b$` means its component along z".
pub(super) fn component_of_cross<'m>(
    sign: &Sign,
    meaning: &'m NotationMeaning,
) -> Option<&'m NounPhrase> {
    let (Sign::Operator(written), NotationMeaning::Noun(what)) = (sign, meaning) else {
        return None;
    };
    let cross = |f: &Factor| f.operator == Operator::Cross;
    let crosses = written.source.trim() == "\\times"
        || match node_of(written).map(|node| &node.kind) {
            Some(Kind::Product(factors)) => factors.iter().any(cross),
            _ => false,
        };
    let own = match what.slot(Slot::Of) {
        None => true,
        Some(Term::Phrase(of)) => of.head == CROSS_PRODUCT,
        Some(of) => of == &Term::Formula(written.clone()),
    };
    (crosses && own && what.head == "component").then_some(what)
}

/// "A dot between quaternions means the quaternion product", "quaternions side by side mean …".
pub(super) fn is_quaternion_product(sign: &Sign, meaning: &NotationMeaning) -> bool {
    match (sign, meaning) {
        (Sign::Custom(between), NotationMeaning::Noun(product)) => {
            [QUATERNION_DOT, PRODUCT_OF_QUATERNIONS].contains(between)
                && product.head == QUATERNION_PRODUCT
        }
        _ => false,
    }
}

/// What is written beside the d of a rate: the b of `\frac{{}^b d^2}{dt^2}`, the R of `\frac{d_R}{dt}`, the prime of
/// `\frac{d'}{dt}`, the δ of `\frac{\delta}{\delta t}`.
fn label_of_rate(written: &str) -> Option<String> {
    if is_rate_of_deltas(written) {
        return Some(FrameLabel::DELTA.to_owned());
    }
    let frame = |text: &str| match read_formula(text, 0, &Macros::default()).as_slice() {
        [Row::Expression(node)] => match &node.kind {
            Kind::TimeDerivative { frame, .. } => frame.as_ref().map(|label| plain(&label.text)),
            _ => None,
        },
        _ => None,
    };
    frame(written).or_else(|| frame(&format!("{written} q")))
}

/// How the brackets of a list open, and what stands in them.
fn in_brackets(subjects: &[Term]) -> Option<(char, Vec<String>)> {
    let [Term::Formula(formula)] = subjects else {
        return None;
    };
    let Kind::Tuple(list) = &node_of(formula)?.kind else {
        return None;
    };
    let opening = formula.source.trim_start().chars().next()?;
    Some((opening, list.iter().map(spelled).collect()))
}
