//! LaTeX.

use super::{Printer, Spelling, digits, header};
use crate::emit::lines::Lines;
use crate::emit::routine::{Letter, Output};
use crate::emit::{Precision, Request};

struct Latex;

impl Spelling for Latex {
    fn number(&self, value: f64) -> String {
        let digits = digits(value, Precision::Double);
        match digits.split_once('e') {
            None => digits.trim_end_matches(".0").to_owned(),
            Some(("1", power)) => format!("10^{{{power}}}"),
            Some((mantissa, power)) => format!("{mantissa} \\cdot 10^{{{power}}}"),
        }
    }

    fn letter(&self, letter: &Letter) -> String {
        letter.latex.clone()
    }

    fn named(&self, number: usize) -> String {
        format!("t_{{{number}}}")
    }

    fn product(&self, left: &str, right: &str) -> String {
        let digit = right.starts_with(|c: char| c.is_ascii_digit());
        format!("{left} {}{right}", if digit { "\\cdot " } else { "" })
    }

    fn quotient(&self, left: &str, right: &str) -> String {
        format!("\\frac{{{left}}}{{{right}}}")
    }

    fn divides_in_line(&self) -> bool {
        false
    }

    fn parentheses(&self, inside: &str) -> String {
        format!("\\left({inside}\\right)")
    }

    fn function(&self, name: &str, inside: &str) -> String {
        format!("\\{name}{{{inside}}}")
    }
}

pub(super) fn text(request: &Request, lines: &Lines<'_>) -> String {
    let printer = Printer::new(lines, &Latex);
    let mut text = String::new();
    for line in header(request, lines) {
        text += format!("% {line}").trim_end();
        text.push('\n');
    }
    text += "% Entries of a matrix that are not written are zero. A prime marks what is after the step.\n";
    let named = lines.named();
    let mut rows: Vec<_> = named
        .map(|(number, symbol)| (Latex.named(number), printer.done(symbol).0))
        .collect();
    for output in &lines.routine.outputs {
        for (place, entry) in output.entries.iter().enumerate() {
            let value = printer.used(*entry).0;
            if value != "0" || output.columns.is_empty() {
                rows.push((left(output, place), value));
            }
        }
    }
    let rows: Vec<_> = rows
        .into_iter()
        .map(|(left, right)| format!("{left} &= {right}"))
        .collect();
    text + &format!(
        "\\begin{{align*}}\n{}\n\\end{{align*}}\n",
        rows.join(" \\\\\n")
    )
}

/// What an entry of an output is called: a number of it, or a derivative.
fn left(output: &Output, place: usize) -> String {
    match output.columns.len() {
        0 => output.rows[place].latex.clone(),
        count => {
            let (row, column) = (&output.rows[place / count], &output.columns[place % count]);
            format!(
                "\\frac{{\\partial {}}}{{\\partial {}}}",
                row.latex, column.latex
            )
        }
    }
}
