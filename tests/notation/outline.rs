//! A tree as one line of text, so that a test can show what it expects.

use num_traits::Signed;
use polhode::notation::ast::{
    Bracket, DerivativeStyle, FrameLabel, Kind, Line, Node, Number, Operator, Relation, Symbol,
};
use polhode::notation::document::{Document, Format, Item, Row};
use polhode::notation::{Macros, read, read_formula, reread};

/// The rows of a LaTeX formula, each as a line of text.
#[allow(dead_code, reason = "each test file uses what it needs")]
pub(crate) fn latex(text: &str) -> String {
    rows(&read_formula(text, 0, &Macros::default()))
}

/// The rows of a formula in plain text.
#[allow(dead_code, reason = "each test file uses what it needs")]
pub(crate) fn plain(text: &str) -> String {
    let (empty, _) = read("test", "", Format::Text);
    rows(&reread(&empty, text))
}

/// Asserts what each LaTeX formula is read as.
#[allow(dead_code, reason = "each test file uses what it needs")]
#[track_caller]
pub(crate) fn each_reads(cases: &[(&str, &str)]) {
    for (source, expected) in cases {
        assert_eq!(&latex(source), expected, "{source}");
    }
}

/// Asserts what each formula in plain text is read as.
#[allow(dead_code, reason = "each test file uses what it needs")]
#[track_caller]
pub(crate) fn each_plain_reads(cases: &[(&str, &str)]) {
    for (source, expected) in cases {
        assert_eq!(&plain(source), expected, "{source}");
    }
}

/// The formulas of a document, each row as a line of text.
#[allow(dead_code, reason = "each test file uses what it needs")]
pub(crate) fn document(text: &str, format: Format) -> String {
    formulas(&read("test", text, format).0)
}

#[allow(dead_code, reason = "each test file uses what it needs")]
pub(crate) fn formulas(document: &Document) -> String {
    let formulas = document.items.iter().filter_map(|item| match item {
        Item::Formula(formula) => Some(rows(&formula.rows)),
        _ => None,
    });
    formulas.collect::<Vec<_>>().join("\n")
}

pub(crate) fn rows(rows: &[Row]) -> String {
    rows.iter().map(row).collect::<Vec<_>>().join("\n")
}

pub(crate) fn row(row: &Row) -> String {
    match row {
        Row::Line(line) => self::line(line),
        Row::Expression(node) => self::node(node),
        Row::Unreadable { message, .. } => format!("unreadable: {message}"),
    }
}

pub(crate) fn line(line: &Line) -> String {
    let mut words = vec![];
    let mut sides = line.sides.iter();
    if !line.continues {
        words.extend(sides.next().map(node));
    }
    for ((relation, _), side) in line.relations.iter().zip(sides) {
        words.push(self::relation(*relation).to_owned());
        words.push(node(side));
    }
    words.extend(line.labels.iter().map(|label| format!("#{label}")));
    let ranges = line.ranges.iter();
    words.extend(ranges.map(|(index, values)| format!("{{{index}: {}}}", values.join(" "))));
    words.extend(line.remarks.iter().map(|remark| format!("{remark:?}")));
    words.join(" ")
}

fn relation(relation: Relation) -> &'static str {
    match relation {
        Relation::Equal => "=",
        Relation::Defined => ":=",
        Relation::Approximate => "~",
        Relation::NotEqual => "/=",
        Relation::Less => "<",
        Relation::LessOrEqual => "<=",
        Relation::Greater => ">",
        Relation::GreaterOrEqual => ">=",
        Relation::Other => "?",
    }
}

fn form(head: &str, parts: impl IntoIterator<Item = String>) -> String {
    let parts: Vec<String> = parts.into_iter().collect();
    format!("({head} {})", parts.join(" "))
}

fn grid(head: &str, rows: &[Vec<Node>]) -> String {
    let row = |row: &Vec<Node>| {
        let cells: Vec<String> = row.iter().map(node).collect();
        format!("[{}]", cells.join(" "))
    };
    form(head, rows.iter().map(row))
}

fn at(head: &str, frame: Option<&FrameLabel>) -> String {
    frame.map_or(head.to_owned(), |frame| {
        format!("{head}@{}", frame.text.replace(' ', "·"))
    })
}

pub(crate) fn node(of: &Node) -> String {
    match &of.kind {
        Kind::Number(number) => self::number(number),
        Kind::Symbol(symbol) => self::symbol(symbol),
        Kind::Bold(number) => format!("bold:{}", self::number(number)),
        Kind::Negate(a) => form("-", [node(a)]),
        Kind::Sum(terms) => form(
            "+",
            terms.iter().map(|term| match term.negative {
                true => form("-", [node(&term.node)]),
                false => node(&term.node),
            }),
        ),
        Kind::Product(factors) => {
            let mut parts = vec![];
            for factor in factors {
                match factor.operator {
                    Operator::Juxtaposed => {}
                    Operator::Dot => parts.push("·".to_owned()),
                    Operator::Cross => parts.push("×".to_owned()),
                    Operator::Tensor => parts.push("⊗".to_owned()),
                }
                parts.push(node(&factor.node));
            }
            form("*", parts)
        }
        Kind::Quotient(a, b) => form("/", [node(a), node(b)]),
        Kind::Power(a, b) => form("^", [node(a), node(b)]),
        Kind::Transpose(a) => form("T", [node(a)]),
        Kind::Skew(a) => form("skew", [node(a)]),
        Kind::Group(Bracket::Round, a) => form("group", [node(a)]),
        Kind::Group(Bracket::Square, a) => form("square", [node(a)]),
        Kind::Group(Bracket::Curly, a) => form("curly", [node(a)]),
        Kind::Norm(a) => form("norm", [node(a)]),
        Kind::Tuple(entries) => form("tuple", entries.iter().map(node)),
        Kind::Matrix(rows) => grid("matrix", rows),
        Kind::Determinant(rows) => grid("det", rows),
        Kind::TimeDerivative {
            operand,
            order,
            style,
            frame,
        } => {
            let head = match style {
                DerivativeStyle::Dots => format!("{}ot", "d".repeat(usize::from(*order))),
                DerivativeStyle::Leibniz if *order == 1 => "d/dt".to_owned(),
                DerivativeStyle::Leibniz => format!("d{order}/dt{order}"),
            };
            form(&at(&head, frame.as_ref()), [node(operand)])
        }
        Kind::Derivative {
            operand,
            variables,
            partial,
        } => {
            let head = if *partial { "partial" } else { "d" };
            form(head, std::iter::once(&**operand).chain(variables).map(node))
        }
        Kind::Function(function, a) => form(&format!("{function:?}").to_lowercase(), [node(a)]),
        Kind::Call(head, arguments) => {
            form("call", std::iter::once(&**head).chain(arguments).map(node))
        }
        Kind::InFrame(a, frame) => form(&at("in", Some(frame)), [node(a)]),
        Kind::Integral {
            integrand,
            variable,
            limits,
        } => {
            let limits = limits.iter().flat_map(|(a, b)| [node(a), node(b)]);
            form(
                "int",
                [node(integrand), node(variable)].into_iter().chain(limits),
            )
        }
        Kind::IndexedSum {
            index,
            limits,
            body,
        } => {
            let limits = limits.iter().flat_map(|(a, b)| [node(a), node(b)]);
            form(
                "sum",
                std::iter::once(symbol(index))
                    .chain(limits)
                    .chain([node(body)]),
            )
        }
        Kind::PlusMinus(a) => form("±", [node(a)]),
        Kind::WithUnit(a, unit) => form("unit", [node(a), format!("{unit:?}")]),
        Kind::Ellipsis => "…".to_owned(),
        Kind::Error(message) => format!("<{message}>"),
    }
}

fn number(number: &Number) -> String {
    let value = &number.value;
    assert!(!value.is_negative(), "a number is written without a sign");
    let value = value.to_string();
    match number.decimals {
        Some(decimals) => format!("{value}:{decimals}"),
        None => value,
    }
}

fn symbol(symbol: &Symbol) -> String {
    let style = symbol.style;
    let marks = [
        (symbol.resultant, "sum"),
        (symbol.variation, "delta"),
        (style.vector, "vec"),
        (style.hat, "hat"),
        (style.bar, "bar"),
        (style.tensor, "tensor"),
        (style.calligraphic, "cal"),
        (style.tilde, "tilde"),
        (style.upright, "up"),
        (style.other, "other"),
    ];
    let mut text = String::new();
    for (_, mark) in marks.iter().filter(|(set, _)| *set) {
        text += mark;
        text += ":";
    }
    text += &symbol.name;
    text += &"'".repeat(usize::from(symbol.primes));
    for script in &symbol.subscripts {
        text += "_";
        text += &script.replace(' ', "·");
    }
    for script in &symbol.superscripts {
        text += "^";
        text += &script.replace(' ', "·");
    }
    text
}
