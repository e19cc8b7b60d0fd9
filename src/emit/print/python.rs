//! Python.

use super::{Printer, Spelling, digits, header, tolerance, unpacked};
use crate::emit::lines::Lines;
use crate::emit::routine::{Letter, Output};
use crate::emit::{Precision, Request, sample};

struct Python;

impl Spelling for Python {
    fn number(&self, value: f64) -> String {
        digits(value, Precision::Double)
    }

    fn letter(&self, letter: &Letter) -> String {
        letter.code.clone()
    }

    /// A power takes numbers of any library, as the root of `math` does not.
    fn function(&self, name: &str, inside: &str) -> String {
        match name {
            "sqrt" => format!("({inside})**0.5"),
            _ => format!("math.{name}({inside})"),
        }
    }
}

pub(super) fn text(request: &Request, lines: &Lines<'_>) -> String {
    let name = request.name();
    let names: Vec<_> = lines.routine.arguments.iter().map(|a| a.name).collect();
    let mut text = format!("def {name}({}):\n    \"\"\"", names.join(", "));
    for (n, line) in header(request, lines).iter().enumerate() {
        let indent = if n == 0 { "" } else { "    " };
        text += format!("{indent}{line}").trim_end();
        text.push('\n');
    }
    text += "    \"\"\"\n";
    text += &body(lines);
    text += &test(request, lines);
    text + &format!("\n\nif __name__ == \"__main__\":\n    test_{name}()\n")
}

fn body(lines: &Lines<'_>) -> String {
    let printer = Printer::new(lines, &Python);
    let mut text = String::new();
    for (argument, used) in lines.arguments() {
        if let Some(names) = unpacked(argument, &used) {
            // One name alone would take the whole sequence.
            let comma = if names.len() == 1 { "," } else { "" };
            text += &format!("    {}{comma} = {}\n", names.join(", "), argument.name);
        }
    }
    for (number, symbol) in lines.named() {
        text += &format!("    t{number} = {}\n", printer.done(symbol).0);
    }
    for output in &lines.routine.outputs {
        text += &format!("    {} = {}\n", output.name, zeros(output));
        for (place, entry) in output.entries.iter().enumerate() {
            let value = printer.used(*entry).0;
            if value != "0.0" {
                text += &format!("    {}{} = {value}\n", output.name, output.place(place));
            }
        }
    }
    let names: Vec<_> = lines
        .routine
        .outputs
        .iter()
        .map(|output| output.name)
        .collect();
    text + &format!("    return {}\n", names.join(", "))
}

fn zeros(output: &Output) -> String {
    let rows = output.rows.len();
    match output.columns.len() {
        0 => format!("[0.0] * {rows}"),
        columns => format!("[[0.0] * {columns} for _ in range({rows})]"),
    }
}

/// A function that compares with values of the library.
fn test(request: &Request, lines: &Lines<'_>) -> String {
    let list = |values: &[f64]| {
        let values: Vec<_> = values.iter().map(|value| Python.number(*value)).collect();
        format!("[{}]", values.join(", "))
    };
    let (name, within) = (request.name(), tolerance(Precision::Double));
    let mut text = format!(
        "\n\ndef test_{name}():\n    \"\"\"Against values of polhode, to rounding of the largest one.\"\"\"\n    for arguments, expected in [\n"
    );
    for case in sample::cases(request) {
        let arguments = lines.routine.arguments.iter().zip(&case.arguments);
        let given: Vec<_> = arguments
            .map(|(argument, values)| match argument.is_number {
                true => Python.number(values[0]),
                false => list(values),
            })
            .collect();
        let expected: Vec<_> = case.outputs.iter().map(|values| list(values)).collect();
        text += &format!(
            "        ([{}], [{}]),\n",
            given.join(", "),
            expected.join(", ")
        );
    }
    let one = if lines.routine.outputs.len() == 1 {
        "[found]"
    } else {
        "found"
    };
    text + &format!(
        "    ]:
        found = {name}(*arguments)
        for values, right in zip({one}, expected):
            flat = sum(values, []) if isinstance(values[0], list) else values
            assert len(flat) == len(right)
            largest = max(map(abs, right))
            assert all(abs(a - b) <= {within} * largest for a, b in zip(flat, right)), (flat, right)
"
    )
}
