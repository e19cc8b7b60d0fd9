//! What is printed is read as the tree that was printed.

use super::outline::{self, latex, plain};
use num_bigint::BigInt;
use num_rational::BigRational;
use polhode::notation::ast::{
    Bracket, DerivativeStyle, Factor, FrameLabel, Function, Kind, Node, Number, Operator, Style,
    Symbol, Term,
};
use polhode::notation::print;
use polhode::source::Span;
use proptest::prelude::*;

fn node(kind: Kind) -> Node {
    Node {
        kind,
        span: Span::default(),
    }
}

fn boxed(kind: Kind) -> Box<Node> {
    Box::new(node(kind))
}

fn number() -> impl Strategy<Value = Kind> {
    (0u32..1000, prop::option::of(0u32..4), -6i32..7).prop_map(|(digits, decimals, exponent)| {
        let decimals = decimals.filter(|&d| d > 0);
        let exponent = if decimals.is_some() { exponent } else { 0 };
        let ten = BigRational::from_integer(BigInt::from(10));
        let scale = exponent - decimals.unwrap_or(0) as i32;
        let value = BigRational::from_integer(BigInt::from(digits)) * ten.pow(scale);
        Kind::Number(Number {
            value,
            decimals,
            exponent,
        })
    })
}

fn style() -> impl Strategy<Value = Style> {
    let plain = Style::default();
    let vector = Style {
        vector: true,
        ..plain
    };
    let hat = Style { hat: true, ..plain };
    let bar = Style { bar: true, ..plain };
    prop::sample::select(vec![
        plain,
        plain,
        plain,
        vector,
        vector,
        hat,
        bar,
        Style {
            vector: true,
            ..hat
        },
        Style {
            tensor: true,
            ..plain
        },
        Style {
            tensor: true,
            ..vector
        },
        Style {
            tensor: true,
            ..bar
        },
        Style {
            calligraphic: true,
            ..plain
        },
        Style {
            tilde: true,
            ..plain
        },
        Style {
            other: true,
            ..plain
        },
    ])
}

fn symbol() -> impl Strategy<Value = Symbol> {
    let letters = [
        "L", "M", "I", "H", "a", "b", "c", "m", "q", "r", "x", "omega", "alpha", "theta", "Omega",
        "ell",
    ];
    let subscripts = [
        "",
        "x",
        "xx",
        "1",
        "12",
        "k+1",
        "G",
        "x'",
        "G or O",
        "x\u{304}x\u{304}",
    ];
    let superscripts = ["", "", "", "(n+1)", "O", "*", "rel", "b"];
    (
        prop::sample::select(letters.to_vec()),
        style(),
        prop::sample::select(subscripts.to_vec()),
        prop::sample::select(superscripts.to_vec()),
        0u8..3,
        prop::sample::select(vec![
            (false, false),
            (false, false),
            (true, false),
            (false, true),
        ]),
    )
        .prop_map(|(name, style, subscript, superscript, primes, flags)| {
            let list = |text: &str| match text {
                "" => vec![],
                text => vec![text.to_owned()],
            };
            // A sum sign before masses goes over the particles of a body.
            let mass = name == "m" && !style.vector;
            Symbol {
                name: name.to_owned(),
                style,
                subscripts: list(subscript),
                superscripts: list(superscript),
                primes,
                resultant: flags.0 && !mass,
                variation: flags.1,
            }
        })
}

fn leaf() -> impl Strategy<Value = Kind> {
    prop_oneof![
        number(),
        symbol().prop_map(Kind::Symbol),
        symbol().prop_map(Kind::Symbol),
        symbol().prop_map(Kind::Symbol),
        Just(Kind::Ellipsis),
    ]
}

fn frame() -> impl Strategy<Value = FrameLabel> {
    prop::sample::select(vec!["XYZ", "xyz", "body", "S0", "in B"]).prop_map(|text| FrameLabel {
        text: text.to_owned(),
        span: Span::default(),
    })
}

/// A factor as the reader makes it.
fn factor(inner: BoxedStrategy<Kind>) -> BoxedStrategy<Kind> {
    let rate = (
        inner.clone(),
        1u8..4,
        prop::option::of(frame()),
        any::<bool>(),
    )
        .prop_filter("dots over dots are one rate", |(kind, ..)| {
            !matches!(kind, Kind::TimeDerivative { .. } | Kind::PlusMinus(_))
        })
        .prop_map(|(kind, order, frame, dots)| Kind::TimeDerivative {
            operand: boxed(kind),
            order,
            style: match dots {
                true => DerivativeStyle::Dots,
                false => DerivativeStyle::Leibniz,
            },
            frame,
        });
    let functions = [
        Function::Sin,
        Function::Cos,
        Function::Arctan,
        Function::Sqrt,
        Function::Exp,
        Function::Trace,
    ];
    let functions = prop::sample::select(functions.to_vec());
    let brackets = prop::sample::select(vec![Bracket::Round, Bracket::Square, Bracket::Curly]);
    let several = prop::collection::vec(inner.clone(), 2..4);
    let inner_of_bars = inner
        .clone()
        .prop_filter("bars and brackets are a part of a matrix", |kind| {
            !matches!(kind, Kind::Matrix(_))
        });
    let group = (brackets, inner_of_bars.clone())
        .prop_map(|(bracket, kind)| Kind::Group(bracket, boxed(kind)));
    prop_oneof![
        4 => leaf(),
        1 => (inner.clone(), inner.clone()).prop_map(|(a, b)| Kind::Quotient(boxed(a), boxed(b))),
        1 => (symbol(), 2u32..12).prop_map(|(symbol, n)| {
            let value = BigRational::from_integer(n.into());
            let exponent = Number { value, decimals: None, exponent: 0 };
            Kind::Power(boxed(Kind::Symbol(symbol)), boxed(Kind::Number(exponent)))
        }),
        1 => group.clone().prop_map(|kind| Kind::Transpose(boxed(kind))),
        1 => symbol().prop_map(|symbol| Kind::Skew(boxed(Kind::Symbol(symbol)))),
        1 => group,
        1 => inner_of_bars.prop_map(|kind| Kind::Norm(boxed(kind))),
        1 => several.clone().prop_map(|kinds| Kind::Tuple(kinds.into_iter().map(node).collect())),
        1 => several.clone().prop_map(|kinds| {
            Kind::Matrix(kinds.into_iter().map(|kind| vec![node(kind)]).collect())
        }),
        1 => several.prop_map(|kinds| {
            Kind::Determinant(vec![kinds.into_iter().map(node).collect()])
        }),
        1 => rate,
        1 => (functions, inner.clone()).prop_map(|(function, kind)| Kind::Function(function, boxed(kind))),
        1 => (symbol(), inner.clone()).prop_filter("a step in a symbol with an argument is not written", |(symbol, _)| {
            !symbol.resultant && !symbol.variation
        }).prop_map(|(symbol, kind)| Kind::Call(boxed(Kind::Symbol(symbol)), vec![node(kind)])),
        1 => (inner.clone(), symbol()).prop_filter("in t it is a rate", |(_, s)| s.superscripts.is_empty() && !s.resultant).prop_map(|(kind, symbol)| Kind::Derivative {
            operand: boxed(kind),
            variables: vec![node(Kind::Symbol(symbol))],
            partial: true,
        }),
        1 => (inner.clone(), prop::option::of((leaf(), leaf()))).prop_map(|(kind, limits)| Kind::Integral {
            integrand: boxed(kind),
            variable: boxed(Kind::Symbol(Symbol { name: "m".into(), ..Symbol::default() })),
            limits: limits.map(|(a, b)| (boxed(a), boxed(b))),
        }),
        1 => (leaf(), leaf(), leaf()).prop_map(|(kind, a, b)| Kind::IndexedSum {
            index: Box::new(Symbol { name: "i".into(), ..Symbol::default() }),
            limits: Some((boxed(a), boxed(b))),
            body: boxed(kind),
        }),
    ]
    .boxed()
}

fn product(inner: BoxedStrategy<Kind>) -> BoxedStrategy<Kind> {
    let operators = prop::sample::select(vec![
        Operator::Juxtaposed,
        Operator::Juxtaposed,
        Operator::Dot,
        Operator::Cross,
        Operator::Tensor,
    ]);
    let factors = prop::collection::vec((operators, factor(inner.clone())), 2..4);
    let factors = factors.prop_map(|factors| {
        let place = |(i, (operator, kind)): (usize, (Operator, Kind))| Factor {
            operator: if i == 0 {
                Operator::Juxtaposed
            } else {
                operator
            },
            sign: Span::default(),
            node: node(kind),
        };
        Kind::Product(factors.into_iter().enumerate().map(place).collect())
    });
    prop_oneof![factor(inner), factors].boxed()
}

/// A tree that shows itself as one line.
struct Tree(Node);

impl std::fmt::Debug for Tree {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&outline::node(&self.0))
    }
}

fn trees() -> impl Strategy<Value = Tree> {
    expression().prop_map(|kind| Tree(node(kind)))
}

fn expression() -> BoxedStrategy<Kind> {
    let leaf = leaf().boxed();
    leaf.prop_recursive(4, 24, 3, |inner| {
        let terms = prop::collection::vec((any::<bool>(), product(inner.clone())), 2..4);
        let sum = terms.prop_map(|terms| {
            let term = |(negative, kind): (bool, Kind)| Term {
                negative,
                sign: Span::default(),
                node: node(kind),
            };
            Kind::Sum(terms.into_iter().map(term).collect())
        });
        let negated = product(inner.clone()).prop_map(|kind| Kind::Negate(boxed(kind)));
        prop_oneof![2 => product(inner), 1 => sum, 1 => negated]
    })
    .boxed()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn latex_is_read_as_it_was_printed(tree in trees()) {
        let Tree(tree) = tree;
        let text = print::latex(&tree);
        prop_assert_eq!(latex(&text), outline::node(&tree), "{}", text);
    }

    #[test]
    fn unicode_is_read_as_it_was_printed(tree in trees()) {
        let Tree(tree) = tree;
        let text = print::unicode(&tree);
        prop_assert_eq!(plain(&text), outline::node(&tree), "{}", text);
    }
}

#[test]
fn a_lone_x_between_operands_is_printed_as_a_factor() {
    let symbol = |name: &str| {
        node(Kind::Symbol(Symbol {
            name: name.to_owned(),
            ..Symbol::default()
        }))
    };
    let factor = |name: &str| Factor {
        operator: Operator::Juxtaposed,
        sign: Span::default(),
        node: symbol(name),
    };
    let tree = node(Kind::Product(["L", "x", "M"].map(factor).into()));
    let text = print::unicode(&tree);
    assert_eq!(text, "L * x M");
    assert_eq!(plain(&text), outline::node(&tree));
}

#[test]
fn a_bracket_behind_dots_is_printed_as_a_factor() {
    let one = Kind::Symbol(Symbol {
        name: "I".to_owned(),
        ..Symbol::default()
    });
    let factor = |kind: Kind| Factor {
        operator: Operator::Juxtaposed,
        sign: Span::default(),
        node: node(kind),
    };
    let bracket = Kind::Group(Bracket::Round, boxed(one));
    let tree = node(Kind::Product([Kind::Ellipsis, bracket].map(factor).into()));
    assert_eq!(print::latex(&tree), r"\ldots * (I)");
    assert_eq!(latex(&print::latex(&tree)), outline::node(&tree));
    assert_eq!(plain(&print::unicode(&tree)), outline::node(&tree));
}
