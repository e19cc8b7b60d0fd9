//! Rust.

use super::{Printer, Spelling, digits, header, tolerance, unpacked};
use crate::emit::lines::Lines;
use crate::emit::routine::{Argument, Letter, Output};
use crate::emit::{Precision, Request, sample};

struct Rust(Precision);

impl Spelling for Rust {
    fn number(&self, value: f64) -> String {
        digits(value, self.0)
    }

    fn letter(&self, letter: &Letter) -> String {
        letter.code.clone()
    }

    fn function(&self, name: &str, inside: &str) -> String {
        match inside.contains(' ') || inside.contains('*') {
            true => format!("({inside}).{name}()"),
            false => format!("{inside}.{name}()"),
        }
    }
}

pub(super) fn text(request: &Request, lines: &Lines<'_>) -> String {
    let scalar = match request.precision {
        Precision::Double => "f64",
        Precision::Single => "f32",
    };
    let mut text = String::new();
    for line in header(request, lines) {
        text += format!("// {line}").trim_end();
        text.push('\n');
    }
    text += &format!("\n/// {}\n", request.of.told().1);
    text += "#[allow(clippy::all, reason = \"written by a program\")]\n";
    text += &signature(request.name(), scalar, lines);
    text += &body(&Rust(request.precision), lines);
    text += &test(request, lines);
    text
}

/// The type of an array of such a shape, `[3][6]`.
fn array(scalar: &str, shape: &[usize]) -> String {
    let inner = scalar.to_owned();
    shape
        .iter()
        .rev()
        .fold(inner, |inner, n| format!("[{inner}; {n}]"))
}

fn shape(output: &Output) -> Vec<usize> {
    let columns = Some(output.columns.len()).filter(|count| *count > 0);
    [output.rows.len()].into_iter().chain(columns).collect()
}

/// One thing, or more in parentheses.
fn tuple(things: &[String]) -> String {
    match things {
        [one] => one.clone(),
        more => format!("({})", more.join(", ")),
    }
}

fn signature(name: &str, scalar: &str, lines: &Lines<'_>) -> String {
    let argument = |(argument, used): (&Argument, Vec<bool>)| {
        let kind = match argument.is_number {
            true => scalar.to_owned(),
            false => format!("&{}", array(scalar, &[used.len()])),
        };
        let unused = if used.contains(&true) { "" } else { "_" };
        format!("    {unused}{}: {kind},\n", argument.name)
    };
    let arguments: String = lines.arguments().map(argument).collect();
    let outputs = &lines.routine.outputs;
    let returned: Vec<_> = outputs.iter().map(|o| array(scalar, &shape(o))).collect();
    format!("pub fn {name}(\n{arguments}) -> {} {{\n", tuple(&returned))
}

fn body(spelling: &Rust, lines: &Lines<'_>) -> String {
    let printer = Printer::new(lines, spelling);
    let mut text = String::new();
    for (argument, used) in lines.arguments() {
        if let Some(names) = unpacked(argument, &used) {
            text += &format!("    let [{}] = *{};\n", names.join(", "), argument.name);
        }
    }
    for (number, symbol) in lines.named() {
        text += &format!("    let t{number} = {};\n", printer.done(symbol).0);
    }
    for output in &lines.routine.outputs {
        let entries = output
            .entries
            .iter()
            .map(|entry| printer.used(*entry).0)
            .enumerate();
        let entries: Vec<_> = entries.filter(|(_, entry)| *entry != "0.0").collect();
        let changes = if entries.is_empty() { "" } else { "mut " };
        let zeros = array("0.0", &shape(output));
        text += &format!("    let {changes}{} = {zeros};\n", output.name);
        for (place, entry) in entries {
            text += &format!("    {}{} = {entry};\n", output.name, output.place(place));
        }
    }
    let names: Vec<_> = lines
        .routine
        .outputs
        .iter()
        .map(|o| o.name.to_owned())
        .collect();
    text + &format!("    {}\n}}\n", tuple(&names))
}

/// A module that compares with values of the library.
fn test(request: &Request, lines: &Lines<'_>) -> String {
    let list = |values: &[f64]| {
        let values: Vec<_> = values
            .iter()
            .map(|v| digits(*v, request.precision))
            .collect();
        format!("[{}]", values.join(", "))
    };
    let (name, within) = (request.name(), tolerance(request.precision));
    let mut text = format!(
        "\n#[cfg(test)]\nmod tests {{\n    #[test]\n    fn {name}_agrees_with_polhode() {{\n"
    );
    for case in sample::cases(request) {
        let arguments = lines.routine.arguments.iter().zip(&case.arguments);
        let given: Vec<_> = arguments
            .map(|(argument, values)| match argument.is_number {
                true => digits(values[0], request.precision),
                false => format!("&{}", list(values)),
            })
            .collect();
        text += &format!("        let found = super::{name}({});\n", given.join(", "));
        for (n, output) in lines.routine.outputs.iter().enumerate() {
            let found = match lines.routine.outputs.len() {
                1 => "found".to_owned(),
                _ => format!("found.{n}"),
            };
            let found = match output.columns.is_empty() {
                true => format!("&{found}"),
                false => format!("{found}.as_flattened()"),
            };
            text += &format!("        close({found}, &{});\n", list(&case.outputs[n]));
        }
    }
    let scalar = if request.precision == Precision::Single {
        "f32"
    } else {
        "f64"
    };
    text + &format!(
        "    }}

    /// To rounding of the largest value.
    fn close(found: &[{scalar}], expected: &[{scalar}]) {{
        assert_eq!(found.len(), expected.len());
        let largest = expected.iter().fold(0.0, |most: {scalar}, value| most.max(value.abs()));
        for (found, expected) in found.iter().zip(expected) {{
            assert!((found - expected).abs() <= {within} * largest, \"{{found}} for {{expected}}\");
        }}
    }}
}}
"
    )
}
