//! From the tree back to text: LaTeX, and Unicode as one writes it in plain text.
//!
//! What is printed is read as the same tree again, spans apart, for every tree that the reader makes. Where Unicode has no
//! signs for something, its LaTeX stands in the plain text, which the reader takes too.

mod symbol;

use crate::notation::ast::{
    Bracket, DerivativeStyle, FrameLabel, Function, Kind, Line, Node, Number, Operator, Relation,
};
use num_bigint::BigInt;
use num_rational::BigRational;

/// The way in which a tree is printed.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    Latex,
    Unicode,
}

/// An expression as LaTeX.
///
/// ```
/// use polhode::notation::{Macros, document::Row, print, read_formula};
///
/// let rows = read_formula(r"\bm\omega\times\left(I\,\bm\omega\right)", 0, &Macros::default());
/// let Row::Expression(node) = &rows[0] else { unreachable!("no relation is written") };
/// assert_eq!(print::latex(node), r"\boldsymbol{\omega} \times (I \boldsymbol{\omega})");
/// assert_eq!(print::unicode(node), "ω\u{20d7} × (I ω\u{20d7})");
/// ```
pub fn latex(node: &Node) -> String {
    Form::Latex.sum(node)
}

/// An expression in Unicode.
pub fn unicode(node: &Node) -> String {
    Form::Unicode.sum(node)
}

/// A line as LaTeX, with its labels as tags.
pub fn latex_line(line: &Line) -> String {
    let mut text = Form::Latex.line(line);
    for label in &line.labels {
        text.push_str(
            &match label.strip_prefix('(').and_then(|l| l.strip_suffix(')')) {
                Some(inner) => format!(" \\tag{{{inner}}}"),
                None => format!(" \\label{{{label}}}"),
            },
        );
    }
    text
}

/// A line in Unicode, its labels left out.
pub fn unicode_line(line: &Line) -> String {
    Form::Unicode.line(line)
}

impl Form {
    /// The LaTeX or the Unicode of a sign.
    fn pick<'a>(self, latex: &'a str, unicode: &'a str) -> &'a str {
        match self {
            Self::Latex => latex,
            Self::Unicode => unicode,
        }
    }

    fn line(self, line: &Line) -> String {
        let mut sides = line.sides.iter().map(|side| self.sum(side));
        let mut text = String::new();
        if !line.continues {
            text.extend(sides.next());
            text.push(' ');
        }
        for ((relation, _), side) in line.relations.iter().zip(sides) {
            text.push_str(self.relation(*relation));
            text.push(' ');
            text.push_str(&side);
            text.push(' ');
        }
        text.trim_end().to_owned()
    }

    fn relation(self, relation: Relation) -> &'static str {
        match relation {
            Relation::Equal => "=",
            Relation::Defined => ":=",
            Relation::Approximate => self.pick("\\approx", "≈"),
            Relation::NotEqual => self.pick("\\ne", "≠"),
            Relation::Less => "<",
            Relation::LessOrEqual => self.pick("\\le", "≤"),
            Relation::Greater => ">",
            Relation::GreaterOrEqual => self.pick("\\ge", "≥"),
            Relation::Other => self.pick("\\to", "→"),
        }
    }

    /// What may stand as a side of a relation, in a bracket, in an argument.
    fn sum(self, node: &Node) -> String {
        match &node.kind {
            Kind::Negate(a) => format!("-{}", self.product(a)),
            Kind::PlusMinus(a) => format!("{} {}", self.pick("\\pm", "±"), self.product(a)),
            Kind::Sum(terms) => {
                let mut text = String::new();
                for (i, term) in terms.iter().enumerate() {
                    let (sign, node) = match (&term.node.kind, term.negative) {
                        (Kind::PlusMinus(a), false) => (self.pick("\\pm", "±"), &**a),
                        (_, true) => ("-", &term.node),
                        (_, false) => ("+", &term.node),
                    };
                    match (i, sign) {
                        (0, "+") => {}
                        (0, _) => text.push_str(sign),
                        _ => text.push_str(&format!(" {sign} ")),
                    }
                    text.push_str(&self.product(node));
                }
                text
            }
            _ => self.product(node),
        }
    }

    /// What may stand between plus and minus.
    fn product(self, node: &Node) -> String {
        let Kind::Product(factors) = &node.kind else {
            return self.factor(node);
        };
        let mut text = String::new();
        for (i, factor) in factors.iter().enumerate() {
            let printed = match &factor.node.kind {
                Kind::Negate(a) if factor.operator != Operator::Juxtaposed => {
                    format!("-{}", self.factor(a))
                }
                _ => self.factor(&factor.node),
            };
            let sign = match factor.operator {
                _ if i == 0 => "",
                // Digits beside digits would be one number.
                Operator::Juxtaposed
                    if printed.starts_with(|c: char| c.is_ascii_digit())
                        && (text.ends_with(|c: char| c.is_ascii_digit())
                            || matches!(factors[i - 1].node.kind, Kind::Number(_))) =>
                {
                    " * "
                }
                // Behind dots a bracket would hold the number of the equation.
                Operator::Juxtaposed
                    if printed.starts_with('(')
                        && matches!(factors[i - 1].node.kind, Kind::Ellipsis) =>
                {
                    " * "
                }
                // A bracket close behind a letter would hold its arguments.
                Operator::Juxtaposed if printed.starts_with('(') => "\\,",
                // Between operands a lone x would be the sign of a cross product.
                Operator::Juxtaposed if printed == "x" => self.pick(" ", " * "),
                Operator::Juxtaposed => " ",
                Operator::Dot => self.pick(" \\cdot ", " · "),
                Operator::Cross => self.pick(" \\times ", " × "),
                Operator::Tensor => self.pick(" \\otimes ", " ⊗ "),
            };
            text.push_str(sign);
            text.push_str(&printed);
        }
        text
    }

    /// What may stand beside another factor.
    fn factor(self, node: &Node) -> String {
        match &node.kind {
            Kind::Number(number) => self.number(number),
            Kind::Symbol(symbol) => self.symbol(symbol),
            Kind::Bold(number) => format!("\\mathbf{{{}}}", self.number(number)),
            Kind::Negate(_) | Kind::Sum(_) | Kind::Product(_) | Kind::PlusMinus(_) => {
                let text = self.sum(node);
                // Braces group no sign.
                match text.starts_with(['-', '±']) || text.starts_with("\\pm") {
                    true => format!("({text})"),
                    false => format!("{{{text}}}"),
                }
            }
            Kind::Quotient(a, b) => format!("\\frac{{{}}}{{{}}}", self.sum(a), self.sum(b)),
            Kind::Power(a, b) => format!("{}{}", self.base(a), self.raised(b)),
            Kind::Transpose(a) => format!("{}{}", self.base(a), self.pick("^{T}", "ᵀ")),
            Kind::Skew(a) => format!("[{}]_{{\\times}}", self.sum(a)),
            Kind::Group(bracket, a) => self.group(*bracket, a),
            Kind::Norm(a) => format!("\\left|{}\\right|", self.sum(a)),
            Kind::Tuple(entries) => format!("({})", self.list(entries)),
            Kind::Matrix(rows) => self.grid("bmatrix", rows),
            Kind::Determinant(rows) => self.grid("vmatrix", rows),
            Kind::TimeDerivative {
                operand,
                order,
                style,
                frame,
            } => self.rate(operand, *order, *style, frame.as_ref()),
            Kind::Derivative {
                operand,
                variables,
                partial,
            } => self.derivative(operand, variables, *partial),
            Kind::Function(function, a) => self.function(*function, a),
            Kind::Call(head, arguments) => {
                format!("{}({})", self.factor(head), self.list(arguments))
            }
            Kind::InFrame(a, label) => format!("{}{}", self.framed(a), frame(label)),
            Kind::WithUnit(a, unit) if unit == "deg" => format!("{}^{{\\circ}}", self.base(a)),
            Kind::WithUnit(a, unit) => format!("{}\\,\\text{{{unit}}}", self.factor(a)),
            Kind::Ellipsis => self.pick("\\ldots", "…").to_owned(),
            Kind::Error(message) => format!("\\text{{{message}}}"),
            Kind::Integral { .. } | Kind::IndexedSum { .. } => self.gathered(node),
        }
    }

    /// What a script can hang on; braces keep anything else together.
    fn base(self, node: &Node) -> String {
        match &node.kind {
            Kind::Number(n) if n.exponent == 0 => self.factor(node),
            Kind::Symbol(_)
            | Kind::Group(..)
            | Kind::Norm(_)
            | Kind::Tuple(_)
            | Kind::Matrix(_) => self.factor(node),
            _ => format!("{{{}}}", self.sum(node)),
        }
    }

    fn raised(self, exponent: &Node) -> String {
        let text = self.sum(exponent);
        let digits = text.bytes().all(|b| b.is_ascii_digit());
        if self == Self::Unicode && digits {
            text.chars().map(symbol::superscript).collect()
        } else {
            format!("^{{{text}}}")
        }
    }

    fn framed(self, node: &Node) -> String {
        match &node.kind {
            Kind::Group(..) => self.factor(node),
            _ => format!("{{{}}}", self.sum(node)),
        }
    }

    fn group(self, bracket: Bracket, inner: &Node) -> String {
        let inner = self.sum(inner);
        match bracket {
            Bracket::Round => format!("({inner})"),
            Bracket::Square => format!("[{inner}]"),
            Bracket::Curly => format!("\\{{{inner}\\}}"),
        }
    }

    fn list(self, nodes: &[Node]) -> String {
        let entries: Vec<String> = nodes.iter().map(|node| self.sum(node)).collect();
        entries.join(", ")
    }

    fn grid(self, name: &str, rows: &[Vec<Node>]) -> String {
        let row = |row: &Vec<Node>| {
            let cells: Vec<String> = row.iter().map(|cell| self.sum(cell)).collect();
            cells.join(" & ")
        };
        let rows: Vec<String> = rows.iter().map(row).collect();
        let rows = rows.join(" \\\\ ");
        format!("\\begin{{{name}}} {rows} \\end{{{name}}}")
    }

    fn rate(
        self,
        operand: &Node,
        order: u8,
        style: DerivativeStyle,
        label: Option<&FrameLabel>,
    ) -> String {
        let text = match (style, order, &operand.kind) {
            (DerivativeStyle::Dots, 1..=2, Kind::Symbol(symbol))
                if self == Self::Unicode && label.is_none() =>
            {
                return self.dotted(symbol, order);
            }
            (DerivativeStyle::Dots, ..) => {
                let dots = format!("{}ot", "d".repeat(usize::from(order.min(4))));
                format!("\\{dots}{{{}}}", self.sum(operand))
            }
            (DerivativeStyle::Leibniz, 1, _) => {
                format!("\\frac{{d}}{{dt}}({})", self.sum(operand))
            }
            (DerivativeStyle::Leibniz, ..) => {
                let operand = self.sum(operand);
                format!("\\frac{{d^{{{order}}}}}{{dt^{{{order}}}}}({operand})")
            }
        };
        match label {
            Some(label) => format!("({text}){}", frame(label)),
            None => text,
        }
    }

    fn derivative(self, operand: &Node, variables: &[Node], partial: bool) -> String {
        let d = if partial { "\\partial" } else { "d" };
        let below: String = variables
            .iter()
            .map(|variable| format!("{d} {}", self.factor(variable)))
            .collect();
        format!("\\frac{{{d}}}{{{below}}}({})", self.sum(operand))
    }

    fn function(self, function: Function, argument: &Node) -> String {
        let inner = match &argument.kind {
            Kind::Tuple(entries) => self.list(entries),
            _ => self.sum(argument),
        };
        let name = match function {
            Function::Sqrt => return format!("\\sqrt{{{}}}", self.sum(argument)),
            Function::Trace => "\\operatorname{tr}".to_owned(),
            Function::Vee => "\\operatorname{vee}".to_owned(),
            Function::Diag => "\\operatorname{diag}".to_owned(),
            Function::Skew => "\\operatorname{skew}".to_owned(),
            Function::Sign => "\\operatorname{sgn}".to_owned(),
            Function::Abs => "\\operatorname{abs}".to_owned(),
            other => format!("\\{}", format!("{other:?}").to_lowercase()),
        };
        format!("{name}({inner})")
    }

    /// Integrals and sums reach as far as they can, so that braces must end them.
    fn gathered(self, node: &Node) -> String {
        let scripts = |limits: &Option<(Box<Node>, Box<Node>)>, index: &str| {
            limits.as_ref().map_or(String::new(), |(a, b)| {
                format!("_{{{index}{}}}^{{{}}}", self.sum(a), self.sum(b))
            })
        };
        match &node.kind {
            Kind::Integral {
                integrand,
                variable,
                limits,
            } => {
                let limits = scripts(limits, "");
                let (inner, variable) = (self.sum(integrand), self.factor(variable));
                format!("{{\\int{limits} {{{inner}}} \\,d {variable}}}")
            }
            Kind::IndexedSum {
                index,
                limits,
                body,
            } => {
                let name = self.symbol(index);
                let range = match limits {
                    Some(_) => scripts(limits, &format!("{name} = ")),
                    None => format!("_{{{name}}}"),
                };
                format!("{{\\sum{range} {}}}", self.product(body))
            }
            _ => self.factor(node),
        }
    }

    fn number(self, number: &Number) -> String {
        let ten = BigRational::from_integer(BigInt::from(10));
        let mantissa = &number.value / ten.pow(number.exponent);
        let decimals = number.decimals.unwrap_or(0);
        let scaled = (mantissa * BigInt::from(10).pow(decimals)).to_integer();
        let mut digits = scaled.to_string();
        if number.decimals.is_some() {
            let decimals = decimals as usize;
            let short = (decimals + 1).saturating_sub(digits.len());
            digits.insert_str(0, &"0".repeat(short));
            digits.insert(digits.len() - decimals, '.');
        }
        match number.exponent {
            0 => digits,
            exponent => format!("{digits} \\times 10^{{{exponent}}}"),
        }
    }
}

fn frame(label: &FrameLabel) -> String {
    format!("_{{\\text{{{}}}}}", label.text)
}
