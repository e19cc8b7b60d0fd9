//! Operations as text: what the languages have in common.

mod c;
mod latex;
mod python;
mod rust;

use crate::emit::graph::{Operation, Symbol};
use crate::emit::lines::Lines;
use crate::emit::routine::{Argument, Letter, Output};
use crate::emit::{Language, Precision, Request};

/// The code of a request.
pub(super) fn text(request: &Request, lines: &Lines<'_>) -> String {
    match request.language {
        Language::Rust => rust::text(request, lines),
        Language::C => c::text(request, lines),
        Language::Python => python::text(request, lines),
        Language::Latex => latex::text(request, lines),
    }
}

/// How a language spells expressions.
trait Spelling {
    fn number(&self, value: f64) -> String;
    fn letter(&self, letter: &Letter) -> String;
    fn named(&self, number: usize) -> String {
        format!("t{number}")
    }
    fn product(&self, left: &str, right: &str) -> String {
        format!("{left}*{right}")
    }
    fn quotient(&self, left: &str, right: &str) -> String {
        format!("{left}/{right}")
    }
    /// Whether operands of a quotient need parentheses.
    fn divides_in_line(&self) -> bool {
        true
    }
    fn parentheses(&self, inside: &str) -> String {
        format!("({inside})")
    }
    fn function(&self, name: &str, inside: &str) -> String;
}

/// How tightly an expression holds together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Hold {
    Sum,
    Product,
    Whole,
}

/// Expressions in one spelling.
struct Printer<'a, S> {
    lines: &'a Lines<'a>,
    spelling: &'a S,
    letters: Vec<&'a Letter>,
}

impl<'a, S: Spelling> Printer<'a, S> {
    fn new(lines: &'a Lines<'a>, spelling: &'a S) -> Self {
        let arguments = lines.routine.arguments.iter();
        Self {
            letters: arguments.flat_map(|argument| &argument.letters).collect(),
            lines,
            spelling,
        }
    }

    /// A symbol where it is used: its name, if it has one.
    fn used(&self, symbol: Symbol) -> (String, Hold) {
        match self.lines.number_of(symbol) {
            Some(number) => (self.spelling.named(number), Hold::Whole),
            None => self.done(symbol),
        }
    }

    /// The operation itself.
    fn done(&self, symbol: Symbol) -> (String, Hold) {
        let spelling = self.spelling;
        let function = |name, a| (spelling.function(name, &self.used(a).0), Hold::Whole);
        match self.lines.operation(symbol) {
            Operation::Input(n) => (spelling.letter(self.letters[n]), Hold::Whole),
            Operation::Constant(bits) => (spelling.number(f64::from_bits(bits)), Hold::Whole),
            Operation::Negative(a) => (format!("-{}", self.right(a, Hold::Product)), Hold::Product),
            Operation::Sum(a, b) => {
                let sides = (self.left(a, Hold::Sum), self.right(b, Hold::Product));
                (format!("{} + {}", sides.0, sides.1), Hold::Sum)
            }
            Operation::Difference(a, b) => {
                let sides = (self.left(a, Hold::Sum), self.right(b, Hold::Product));
                (format!("{} - {}", sides.0, sides.1), Hold::Sum)
            }
            Operation::Product(a, b) => {
                let sides = (self.left(a, Hold::Product), self.right(b, Hold::Whole));
                (spelling.product(&sides.0, &sides.1), Hold::Product)
            }
            Operation::Quotient(a, b) if spelling.divides_in_line() => {
                let sides = (self.left(a, Hold::Product), self.right(b, Hold::Whole));
                (spelling.quotient(&sides.0, &sides.1), Hold::Product)
            }
            Operation::Quotient(a, b) => {
                let text = spelling.quotient(&self.used(a).0, &self.used(b).0);
                (text, Hold::Whole)
            }
            Operation::Root(a) => function("sqrt", a),
            Operation::Sine(a) => function("sin", a),
            Operation::Cosine(a) => function("cos", a),
        }
    }

    /// An operand that nothing stands before.
    fn left(&self, symbol: Symbol, least: Hold) -> String {
        let (text, hold) = self.used(symbol);
        match hold >= least {
            true => text,
            false => self.spelling.parentheses(&text),
        }
    }

    /// An operand behind an operator: a sign of its own would be a second operator.
    fn right(&self, symbol: Symbol, least: Hold) -> String {
        let (text, hold) = self.used(symbol);
        match hold >= least && !text.starts_with('-') {
            true => text,
            false => self.spelling.parentheses(&text),
        }
    }
}

impl Output {
    /// The place of an entry behind the name: `[1]`, or `[1][2]` in a matrix.
    fn place(&self, entry: usize) -> String {
        match self.columns.len() {
            0 => format!("[{entry}]"),
            count => format!("[{}][{}]", entry / count, entry % count),
        }
    }

    /// The dimensions: `[3]`, or `[3][6]`.
    fn shape(&self) -> String {
        match self.columns.len() {
            0 => format!("[{}]", self.rows.len()),
            count => format!("[{}][{count}]", self.rows.len()),
        }
    }
}

/// Names for the numbers of an argument, `_` where no line uses one; none if it is a number itself, or nothing uses it.
fn unpacked<'a>(argument: &'a Argument, used: &[bool]) -> Option<Vec<&'a str>> {
    let name = |(letter, used): (&'a Letter, &bool)| if *used { letter.code.as_str() } else { "_" };
    let names = argument.letters.iter().zip(used).map(name);
    (!argument.is_number && used.contains(&true)).then(|| names.collect())
}

/// A number in the digits that it takes to be read back.
fn digits(value: f64, precision: Precision) -> String {
    match precision {
        Precision::Double => format!("{value:?}"),
        Precision::Single => format!("{:?}", value as f32),
    }
}

/// The part of the largest value by which rounding may part the code from the library, in the tests.
fn tolerance(precision: Precision) -> &'static str {
    match precision {
        Precision::Double => "1e-13",
        Precision::Single => "1e-5",
    }
}

/// What stands before the code, line by line: what it computes, of what, in which order.
fn header(request: &Request, lines: &Lines<'_>) -> Vec<String> {
    let mut text = vec![request.of.told().1.to_owned(), String::new()];
    if let crate::emit::KnownInertia::Tensor(t) = &request.known {
        let rows = [0, 1, 2].map(|r| format!("{:?}, {:?}, {:?}", t[(r, 0)], t[(r, 1)], t[(r, 2)]));
        text.push(format!("The tensor I is [{}], kg m^2.", rows.join("; ")));
    }
    text.push("Takes".to_owned());
    for argument in &lines.routine.arguments {
        let shape = match argument.is_number {
            true => String::new(),
            false => format!("[{}]", argument.letters.len()),
        };
        text.push(format!("    {}{shape}: {}", argument.name, argument.about));
    }
    text.push("Returns".to_owned());
    for output in &lines.routine.outputs {
        let listed = |letters: &[Letter]| {
            let names: Vec<_> = letters.iter().map(|letter| letter.code.as_str()).collect();
            names.join(", ")
        };
        text.push(format!(
            "    {}{}: {}",
            output.name,
            output.shape(),
            output.about
        ));
        if !output.columns.is_empty() {
            text.push(format!("        rows {}", listed(&output.rows)));
            text.push(format!("        columns {}", listed(&output.columns)));
        }
    }
    text.push(format!("Does {}.", lines.operations()));
    text.push(format!("Written by polhode {}.", env!("CARGO_PKG_VERSION")));
    text
}
