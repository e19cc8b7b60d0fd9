//! C.

use super::{Printer, Spelling, digits, header, tolerance};
use crate::emit::lines::Lines;
use crate::emit::routine::{Argument, Letter};
use crate::emit::sample::{self, Case};
use crate::emit::{Precision, Request};

struct C(Precision);

impl C {
    fn scalar(&self) -> &'static str {
        match self.0 {
            Precision::Double => "double",
            Precision::Single => "float",
        }
    }

    /// What single precision adds to literals and functions.
    fn suffix(&self) -> &'static str {
        match self.0 {
            Precision::Double => "",
            Precision::Single => "f",
        }
    }

    fn list(&self, values: &[f64]) -> String {
        let values: Vec<_> = values.iter().map(|value| self.number(*value)).collect();
        format!("{{{}}}", values.join(", "))
    }
}

impl Spelling for C {
    fn number(&self, value: f64) -> String {
        digits(value, self.0) + self.suffix()
    }

    fn letter(&self, letter: &Letter) -> String {
        letter.code.clone()
    }

    fn function(&self, name: &str, inside: &str) -> String {
        format!("{name}{}({inside})", self.suffix())
    }
}

pub(super) fn text(request: &Request, lines: &Lines<'_>) -> String {
    let language = C(request.precision);
    let mut text = String::from("/*\n");
    for line in header(request, lines) {
        text += format!(" * {line}").trim_end();
        text.push('\n');
    }
    text += " */\n";
    if lines.operations().roots > 0 {
        text += "#include <math.h>\n\n";
    }
    text += &signature(request.name(), &language, lines);
    text += &body(&language, lines);
    text += &test(request, &language, lines);
    text
}

fn signature(name: &str, language: &C, lines: &Lines<'_>) -> String {
    let scalar = language.scalar();
    let argument = |argument: &Argument| match argument.is_number {
        true => format!("{scalar} {}", argument.name),
        false => format!(
            "const {scalar} {}[{}]",
            argument.name,
            argument.letters.len()
        ),
    };
    let arguments = lines.routine.arguments.iter().map(argument);
    let outputs = lines.routine.outputs.iter();
    let outputs = outputs.map(|output| format!("{scalar} {}{}", output.name, output.shape()));
    let all: Vec<_> = arguments.chain(outputs).collect();
    format!("void {name}(\n    {})\n{{\n", all.join(",\n    "))
}

fn body(language: &C, lines: &Lines<'_>) -> String {
    let (printer, scalar) = (Printer::new(lines, language), language.scalar());
    let mut text = String::new();
    for (argument, used) in lines.arguments() {
        let name = argument.name;
        if !used.contains(&true) {
            text += &format!("    (void){name};\n");
        } else if !argument.is_number {
            let letters = argument.letters.iter().enumerate().zip(used);
            for ((k, letter), _) in letters.filter(|(_, used)| *used) {
                text += &format!("    const {scalar} {} = {name}[{k}];\n", letter.code);
            }
        }
    }
    for (number, symbol) in lines.named() {
        text += &format!(
            "    const {scalar} t{number} = {};\n",
            printer.done(symbol).0
        );
    }
    for output in &lines.routine.outputs {
        for (place, entry) in output.entries.iter().enumerate() {
            let value = printer.used(*entry).0;
            text += &format!("    {}{} = {value};\n", output.name, output.place(place));
        }
    }
    text + "}\n"
}

/// A program that compares with values of the library.
fn test(request: &Request, language: &C, lines: &Lines<'_>) -> String {
    let (scalar, within) = (language.scalar(), tolerance(request.precision));
    let mut text = format!(
        "
#ifdef POLHODE_TEST
#include <stdio.h>

/* How many values differ by more than rounding of the largest one. */
static int differs(const {scalar} *found, const {scalar} *expected, int count)
{{
    int wrong = 0;
    double largest = 0.0;
    for (int i = 0; i < count; ++i) {{
        const double size = expected[i] < 0 ? -expected[i] : expected[i];
        largest = size > largest ? size : largest;
    }}
    for (int i = 0; i < count; ++i) {{
        const double off = (double)found[i] - (double)expected[i];
        wrong += !((off < 0 ? -off : off) <= {within} * largest);
    }}
    return wrong;
}}

int main(void)
{{
    int wrong = 0;
"
    );
    for case in sample::cases(request) {
        text += &compared(request.name(), language, lines, &case);
    }
    text + "    printf(\"%d values differ from polhode\\n\", wrong);\n    return wrong != 0;\n}\n#endif\n"
}

/// A call of the function, and the comparison of what it returns.
fn compared(function: &str, language: &C, lines: &Lines<'_>, case: &Case) -> String {
    let (mut text, scalar) = (String::from("    {\n"), language.scalar());
    let mut passed = vec![];
    for (argument, values) in lines.routine.arguments.iter().zip(&case.arguments) {
        let (name, count) = (argument.name, values.len());
        let (shape, value) = match argument.is_number {
            true => (String::new(), language.number(values[0])),
            false => (format!("[{count}]"), language.list(values)),
        };
        text += &format!("        const {scalar} {name}{shape} = {value};\n");
        passed.push(name.to_owned());
    }
    let mut comparisons = String::new();
    for (output, values) in lines.routine.outputs.iter().zip(&case.outputs) {
        let (name, count) = (output.name, values.len());
        let first = if output.columns.is_empty() {
            name.to_owned()
        } else {
            format!("{name}[0]")
        };
        let expected = format!("expected_{name}");
        text += &format!(
            "        const {scalar} {expected}[{count}] = {};\n",
            language.list(values)
        );
        text += &format!("        {scalar} {name}{};\n", output.shape());
        comparisons += &format!("        wrong += differs({first}, {expected}, {count});\n");
        passed.push(name.to_owned());
    }
    text + &format!(
        "        {}({});\n{comparisons}    }}\n",
        function,
        passed.join(", ")
    )
}
