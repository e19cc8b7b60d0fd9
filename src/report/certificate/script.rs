//! The certificates of a document as a Python script that checks them again with SymPy alone.

use super::{Dialect, Line, lines, quoted, written};
use crate::algebra::{Combination, Polynomial, Ratio, Rational, Reason, Variable};
use crate::report::Checked;

/// The script: one function for each proved line.
pub fn script(checked: &Checked) -> String {
    let mut text = include_str!("recheck.py").to_owned();
    let mut names = vec![];
    for line in lines(checked) {
        let name = line.name.replace('-', "_");
        text.push_str(&function(checked, &line, &name));
        names.push(name);
    }
    let calls: String = names.iter().map(|n| format!("    {n},\n")).collect();
    text.push_str(&format!(
        "\n\nDOCUMENT = {}\nLINES = [\n{calls}]\n\nif __name__ == \"__main__\":\n    main(DOCUMENT, LINES)\n",
        quoted(&checked.report.path)
    ));
    text
}

/// Where a line stands: `notes.md:41`, in a notebook `notes.ipynb, cell 2:4`.
fn place(checked: &Checked, line: &Line<'_>) -> String {
    let (path, number) = (&checked.report.path, line.finding.source_line);
    match line.finding.cell {
        Some(cell) => format!("{path}, cell {cell}:{number}"),
        None => format!("{path}:{number}"),
    }
}

fn function(checked: &Checked, line: &Line<'_>, name: &str) -> String {
    let p = |polynomial: &Polynomial| written(polynomial, line, Dialect::Python);
    let v = |variable: &Variable| format!("v{}", line.numbers[variable]);
    let ratio = |r: &Ratio| format!("{}, {}", p(&r.numerator), p(&r.denominator));
    let combination = |by: &Combination| {
        let cofactors = by.cofactors.iter().map(|(f, c)| format!("({f}, {})", p(c)));
        let cofactors: Vec<_> = cofactors.collect();
        format!("{}, [{}]", p(&by.multiplier), cofactors.join(", "))
    };
    let mut rows = vec![
        format!("\n\ndef {name}():"),
        format!(
            "    c = Certificate({}, {})",
            quoted(&place(checked, line)),
            quoted(&line.finding.source)
        ),
    ];
    for (variable, number) in &line.numbers {
        let latex = quoted(checked.report.variable(*variable));
        rows.push(format!(
            "    v{number} = c.symbol({}, {latex})",
            quoted(&format!("v{number}"))
        ));
    }
    let argument = &line.argument;
    for (variable, rate) in &argument.rates {
        rows.push(format!("    c.rate({}, {})", v(variable), ratio(rate)));
    }
    for (variable, kernel) in &argument.kernels {
        let (function, at) = (quoted(kernel.function), ratio(&kernel.argument));
        rows.push(format!("    c.kernel({}, {function}, {at})", v(variable)));
    }
    for condition in &argument.conditions {
        rows.push(format!("    c.condition({})", p(condition)));
    }
    for fact in &argument.facts {
        let value = p(&fact.value);
        rows.push(match &fact.reason {
            Reason::Premise(name) => format!("    c.premise({value}, {})", quoted(name)),
            Reason::Circle { sine, cosine } => {
                format!("    c.circle({value}, {}, {})", v(sine), v(cosine))
            }
            Reason::Root(root) => format!("    c.root({value}, {})", v(root)),
            Reason::Rate(of) => format!("    c.rate_of({value}, {of})"),
            Reason::Congruence { one, other, by } => {
                format!("    c.congruence({value}, {}, {}, {by})", v(one), v(other))
            }
            Reason::Combination(by) => format!("    c.combination({value}, {})", combination(by)),
        });
    }
    for goal in &argument.goals {
        let (left, right) = (ratio(&goal.left), ratio(&goal.right));
        let by = combination(&goal.by);
        rows.push(format!("    c.goal({left}, {right}, {by})"));
    }
    for bound in &argument.bounds {
        let end = |value: &Rational| p(&Polynomial::constant(value.clone()));
        let (lower, upper) = (end(&bound.lower), end(&bound.upper));
        rows.push(format!(
            "    c.bound({}, {lower}, {upper})",
            ratio(&bound.value)
        ));
    }
    rows.push("    return c\n".to_owned());
    rows.join("\n")
}
