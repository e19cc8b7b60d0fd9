//! Documents whose plain letters stand on axes of fixed orientation, and where a label puts the others on the body's:
//! `I = R I_b R^T`.

use crate::notation::ast::{Kind, Node, Operator, Symbol};
use crate::notation::document::Document;
use crate::verify::letters::usage::{Letter, axes, axis, inner, symbols};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::spatial::{LETTERS, WORDS};
use crate::verify::words::attitude_words::{SPACE as WORDS_OF_SPACE, rate_in_space};
use crate::verify::words::book::has_any;
use crate::verify::words::text::Text;
use std::collections::BTreeMap;

/// Labels of the body's axes, beside the one that the document writes on its tensor.
const BODY: &[&str] = &["b", "B", "body", "bod", "Body"];

/// What a document says by writing its inertia as one that turns with the body.
#[derive(Clone, Debug, Default)]
pub(crate) struct SpaceAxes {
    /// The letter of the inertia.
    inertia: Option<Letter>,
    /// The label of the same tensor on the body's axes.
    pub label: String,
    /// The letter of it there, where that is another one: the J of `I = R J R^T`.
    body_letter: Option<Letter>,
    /// Whether the line that is being read speaks of the body's axes, so that plain letters are turned.
    pub beside_body: bool,
    /// Whether the section works on the body's axes, plain letters and all.
    pub left: bool,
}

/// Words of a sentence that turns to the body's axes: "we solve it on body axes".
const ON_BODY: &[&str] = &[
    "on body axes",
    "on the body axes",
    "in body axes",
    "in the body frame",
    "in body coordinates",
];

/// Whether a sentence in small letters says that what follows stands on the body's axes.
pub(crate) fn turns_to_body(sentence: &str) -> bool {
    let works = has_any(
        sentence,
        &[
            "we solve",
            "we work",
            "we now",
            "now we",
            "we turn",
            "we integrate",
        ],
    );
    works && has_any(sentence, ON_BODY) && !has_any(sentence, WORDS_OF_SPACE)
}

impl SpaceAxes {
    /// Looks for a line that says what the inertia is on space axes, by the matrix that is the document's attitude.
    pub(crate) fn of(
        document: &Text,
        matrix: Option<&Letter>,
        quantities: &BTreeMap<Letter, Quantity>,
        to_body: bool,
    ) -> Option<Self> {
        let of = |quantity: Quantity| {
            move |plain: &Symbol| quantities.get(&Letter::of(plain)) == Some(&quantity)
        };
        let tensor =
            turned_tensor(document, matrix).filter(|(plain, _)| of(Quantity::Inertia)(plain));
        let letters = || turned_letters(document, matrix, &of(Quantity::Inertia), to_body);
        if tensor.is_none()
            && let Some((plain, body)) = letters()
        {
            return Some(Self {
                inertia: Some(plain),
                body_letter: Some(body),
                ..Self::default()
            });
        }
        let rate = || turned_vector(document, matrix?, &of(Quantity::AngularVelocity));
        let momentum = || {
            let turned = turned_vector(document, matrix?, &of(Quantity::Momentum));
            turned.filter(|(_, labelled)| !is_by_plain_rate(document, labelled, quantities))
        };
        let (_, labelled) = tensor.or_else(rate).or_else(momentum)?;
        let found = Self {
            label: labelled.subscripts.concat().trim().to_owned(),
            inertia: tensor.map(|(plain, _)| Letter::of(plain)),
            ..Self::default()
        };
        // Where ω wears no label, words may put it on the body's axes all the same.
        let mut all = document
            .lines()
            .flat_map(|line| &line.sides)
            .flat_map(symbols);
        let labelled_rate = all.any(|s| s.name == "omega" && found.without_label(s).is_some());
        let on_body =
            |clause: &str| clause.contains("⟨omega⟩") && rate_in_space(clause) == Some(false);
        let said = document.named_sentences();
        let mut clauses = said.iter().flat_map(|s| s.text.split([',', ';']));
        let denied = clauses.any(on_body);
        (labelled_rate || !denied).then_some(found)
    }

    /// The letters of the inertia on space axes and on the body's, where these are two.
    pub(crate) fn two_letters(&self) -> Option<[String; 2]> {
        let letters = [self.inertia.as_ref()?, self.body_letter.as_ref()?];
        Some(letters.map(|letter| letter.name.clone()))
    }

    /// A symbol without the label that puts it on the body's axes; `None` where it has none.
    pub(crate) fn without_label(&self, symbol: &Symbol) -> Option<Symbol> {
        let letter = Letter::of(symbol);
        if self.body_letter.as_ref() == Some(&letter) {
            let plain = self.inertia.clone()?;
            let mut bare = symbol.clone();
            (bare.name, bare.style.calligraphic) = (plain.name, plain.calligraphic);
            return Some(bare);
        }
        let inertia = self.inertia.as_ref() == Some(&letter);
        // The ω_0 beside an I_0 is that at the beginning.
        let lettered = self.label.chars().all(char::is_alphabetic);
        let labels = |text: &str| {
            let text = text.trim();
            BODY.contains(&text) || text == self.label && (inertia || lettered)
        };
        let mut bare = symbol.clone();
        bare.subscripts.retain(|text| !labels(text));
        (bare != *symbol).then_some(bare)
    }

    /// Whether a formula is a number made of whole vectors and tensors without the label by sums and products: it is
    /// the same on all axes.
    pub(crate) fn is_invariant(&self, side: &Node) -> bool {
        let whole = |symbol: &Symbol| {
            symbol.subscripts.is_empty() && symbol.superscripts.is_empty() && !symbol.style.hat
        };
        let kind = match &side.kind {
            Kind::Symbol(symbol) => return whole(symbol),
            Kind::Number(_)
            | Kind::Negate(_)
            | Kind::Sum(_)
            | Kind::Product(_)
            | Kind::Quotient(..)
            | Kind::Transpose(_)
            | Kind::Skew(_)
            | Kind::Group(..)
            | Kind::Norm(_) => true,
            Kind::Power(_, exponent) => matches!(exponent.kind, Kind::Number(_)),
            _ => false,
        };
        kind && side.children().all(|child| self.is_invariant(child))
    }

    /// Whether a symbol of a formula is labelled so.
    pub(crate) fn labels_any(&self, sides: &[Node]) -> bool {
        let mut all = sides.iter().flat_map(symbols);
        all.any(|symbol| self.without_label(symbol).is_some())
    }
}

/// The letter of a tensor that is turned from the body's axes to those of the world, and its labels there and here:
/// `I_w = R I_b R^T`.
pub(crate) fn turned_labels(document: &Document) -> Option<(String, String, String)> {
    document.lines().find_map(|line| {
        let [left, right] = line.sides.as_slice() else {
            return None;
        };
        let Kind::Symbol(world) = &inner(left).kind else {
            return None;
        };
        let Kind::Product(factors) = &inner(right).kind else {
            return None;
        };
        let opens = !matches!(factors.first()?.node.kind, Kind::Transpose(_));
        let (_, body, _) = turned(right).filter(|_| opens)?;
        let labels = [world, body].map(|symbol| symbol.subscripts.concat().trim().to_owned());
        let [there, here] = labels;
        let told = BODY.contains(&here.as_str())
            && (WORDS.contains(&there.as_str()) || LETTERS.contains(&there.as_str()));
        let same = Letter::of(world) == Letter::of(body);
        (told && same && [world, body].into_iter().all(is_label))
            .then(|| (world.name.clone(), there, here))
    })
}

/// Whether a line of a document writes a tensor as one that is turned: `I = R I_b R^T`.
pub(crate) fn turns_a_tensor(document: &Document) -> bool {
    turned_tensor(document, None).is_some()
}

/// The tensor without and with the label.
fn turned_tensor<'d>(
    document: &'d Document,
    matrix: Option<&Letter>,
) -> Option<(&'d Symbol, &'d Symbol)> {
    document.lines().find_map(|line| {
        let mut pairs = line.sides.windows(2);
        pairs.find_map(|pair| {
            let either = [(&pair[0], &pair[1]), (&pair[1], &pair[0])];
            either.into_iter().find_map(|(left, right)| {
                let plain = tensor(left)?;
                let (by, labelled, _) = turned(right)?;
                let same = Letter::of(plain) == Letter::of(labelled);
                let known = matrix.is_none_or(|matrix| *matrix == Letter::of(by));
                let told = is_label(labelled) && plain.subscripts.is_empty();
                (same && known && told && plain.primes == labelled.primes)
                    .then_some((plain, labelled))
            })
        })
    })
}

/// The letters of two tensors in `I = R J R^T`, first the one on space axes, where the matrix takes components `to_body`
/// or the other way.
fn turned_letters(
    document: &Document,
    matrix: Option<&Letter>,
    kind: &dyn Fn(&Symbol) -> bool,
    to_body: bool,
) -> Option<(Letter, Letter)> {
    document.lines().find_map(|line| {
        let [left, right] = line.sides.as_slice() else {
            return None;
        };
        let left = tensor(left)?;
        let (by, right, transposed_first) = turned(right)?;
        let known = matrix.is_none_or(|matrix| *matrix == Letter::of(by));
        let bare = |s: &Symbol| s.subscripts.is_empty() && s.primes == 0 && kind(s);
        let [left_letter, right_letter] = [left, right].map(Letter::of);
        let two = known && bare(left) && bare(right) && left_letter != right_letter;
        let left_in_space = transposed_first == to_body;
        two.then_some(match left_in_space {
            true => (left_letter, right_letter),
            false => (right_letter, left_letter),
        })
    })
}

/// The vector without and with the label in `ω = R ω_b`, for a vector of a kind.
fn turned_vector<'d>(
    document: &'d Document,
    matrix: &Letter,
    kind: &dyn Fn(&Symbol) -> bool,
) -> Option<(&'d Symbol, &'d Symbol)> {
    let lone = |node: &'d Node| match &inner(node).kind {
        Kind::Symbol(symbol) => Some(symbol),
        _ => None,
    };
    document.lines().find_map(|line| {
        let [left, right] = line.sides.as_slice() else {
            return None;
        };
        let Kind::Product(factors) = &inner(right).kind else {
            return None;
        };
        let [turn, vector] = factors.as_slice() else {
            return None;
        };
        let (plain, turn, labelled) = (lone(left)?, lone(&turn.node)?, lone(&vector.node)?);
        let by = vector.operator == Operator::Juxtaposed && Letter::of(turn) == *matrix;
        let same = Letter::of(plain) == Letter::of(labelled) && kind(plain);
        let on_body = BODY.contains(&labelled.subscripts.concat().trim());
        let told = on_body && is_label(labelled) && plain.subscripts.is_empty();
        (by && same && told && !plain.style.hat).then_some((plain, labelled))
    })
}

/// The letter of a momentum that stands in space without a label, `\mathbf L = R\,\mathbf L_b`, where `\mathbf L_b = \mathbf I\boldsymbol\omega`
/// has all else on the body's axes.
pub(crate) fn momentum_in_space(
    document: &Document,
    matrix: &Letter,
    quantities: &BTreeMap<Letter, Quantity>,
) -> Option<Letter> {
    let momentum = |s: &Symbol| quantities.get(&Letter::of(s)) == Some(&Quantity::Momentum);
    let turned = turned_vector(document, matrix, &momentum);
    let beside = |labelled| is_by_plain_rate(document, labelled, quantities);
    turned
        .filter(|(_, labelled)| beside(labelled))
        .map(|(plain, _)| Letter::of(plain))
}

/// Whether a line gives the labelled momentum by a rate without a label, which then stands on the body's axes.
fn is_by_plain_rate(
    document: &Document,
    momentum: &Symbol,
    quantities: &BTreeMap<Letter, Quantity>,
) -> bool {
    let rate = |s: &Symbol| quantities.get(&Letter::of(s)) == Some(&Quantity::AngularVelocity);
    let is_momentum = |side: &Node| matches!(&inner(side).kind, Kind::Symbol(s) if s == momentum);
    let plain = |s: &&Symbol| s.subscripts.is_empty() && rate(s);
    document.lines().any(|line| {
        line.sides.iter().any(is_momentum) && line.sides.iter().flat_map(symbols).any(|s| plain(&s))
    })
}

/// Whether a symbol has one subscript, and no index of a component.
fn is_label(symbol: &Symbol) -> bool {
    matches!(symbol.subscripts.as_slice(), [one] if axis(one).is_none() && axes(one).is_none())
}

/// A symbol, its inverse, or its value at a time: `I`, `I^{-1}`, `I(t)`.
fn tensor(node: &Node) -> Option<&Symbol> {
    match &inner(node).kind {
        Kind::Symbol(symbol) => Some(symbol),
        Kind::Power(base, _) => tensor(base),
        Kind::Call(head, arguments) if arguments.len() == 1 => tensor(head),
        _ => None,
    }
}

/// The R and the A of `R A R^T` or `R^T A R`, and whether it is the second.
fn turned(node: &Node) -> Option<(&Symbol, &Symbol, bool)> {
    let Kind::Product(factors) = &inner(node).kind else {
        return None;
    };
    let [first, middle, last] = factors.as_slice() else {
        return None;
    };
    let beside = [middle, last].map(|f| f.operator == Operator::Juxtaposed);
    let (by, transposed_first) = match (&first.node.kind, &last.node.kind) {
        (_, Kind::Transpose(inside)) if tensor(inside)? == tensor(&first.node)? => (inside, false),
        (Kind::Transpose(inside), _) if tensor(inside)? == tensor(&last.node)? => (inside, true),
        _ => return None,
    };
    let found = (tensor(by)?, tensor(&middle.node)?, transposed_first);
    (beside == [true; 2]).then_some(found)
}
