#![doc = include_str!("certificate.md")]

use crate::algebra::{
    Argument, Combination, Monomial, Polynomial, Proof, Ratio, Rational, Reason, Variable,
};
use crate::report::Checked;
use crate::verify::{Finding, Verdict};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

mod name;
mod script;

pub use name::folder;
pub use script::script;

/// A file to write.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Its name, of letters, digits, dots, hyphens and underscores alone.
    pub name: String,
    /// What is in it.
    pub text: String,
}

/// The certificates of a document, one for each proved line in their order, and the script that checks them again.
pub fn files(checked: &Checked) -> Vec<File> {
    let lines = lines(checked);
    let mut files: Vec<File> = lines
        .iter()
        .map(|line| File {
            name: format!("{}.txt", line.name),
            text: text(checked, line),
        })
        .collect();
    files.push(File {
        name: "recheck.py".to_owned(),
        text: script(checked),
    });
    files
}

/// A proved line as it is written: variables numbered from 0, all arguments in one.
struct Line<'a> {
    finding: &'a Finding,
    name: String,
    /// Each variable's number in the file.
    numbers: BTreeMap<Variable, usize>,
    argument: Argument,
}

fn lines(checked: &Checked) -> Vec<Line<'_>> {
    let mut met: BTreeMap<String, usize> = BTreeMap::new();
    let mut lines = vec![];
    for finding in &checked.report.findings {
        let Verdict::Proved(proof) = &finding.verdict else {
            continue;
        };
        let place = match finding.cell {
            Some(cell) => format!("cell-{cell}-line-{:04}", finding.source_line),
            None => format!("line-{:04}", finding.source_line),
        };
        let times = met.entry(place.clone()).or_default();
        *times += 1;
        let name = match *times {
            1 => place,
            n => format!("{place}-{n}"),
        };
        let argument = joined(proof);
        let numbers = variables(&argument).into_iter().zip(0..).collect();
        lines.push(Line {
            finding,
            name,
            numbers,
            argument,
        });
    }
    lines
}

/// All arguments of a proof as one.
fn joined(proof: &Proof) -> Argument {
    let mut whole = Argument::default();
    for argument in proof.arguments() {
        let before = whole.facts.len();
        let moved = |by: &Combination| Combination {
            multiplier: by.multiplier.clone(),
            cofactors: by
                .cofactors
                .iter()
                .map(|(fact, c)| (fact + before, c.clone()))
                .collect(),
        };
        for fact in &argument.facts {
            let mut fact = fact.clone();
            match &mut fact.reason {
                Reason::Rate(of) => *of += before,
                Reason::Congruence { by, .. } => *by += before,
                Reason::Combination(by) => *by = moved(by),
                Reason::Premise(_) | Reason::Circle { .. } | Reason::Root(_) => {}
            }
            whole.facts.push(fact);
        }
        for goal in &argument.goals {
            let mut goal = goal.clone();
            goal.by = moved(&goal.by);
            whole.goals.push(goal);
        }
        whole.bounds.extend(argument.bounds.iter().cloned());
        whole.rates.extend(argument.rates.clone());
        whole.kernels.extend(argument.kernels.clone());
        for condition in &argument.conditions {
            if !whole.conditions.contains(condition) {
                whole.conditions.push(condition.clone());
            }
        }
    }
    whole
}

/// Every variable that an argument names.
fn variables(argument: &Argument) -> BTreeSet<Variable> {
    let mut found = BTreeSet::new();
    let ratio = |r: &Ratio, found: &mut BTreeSet<Variable>| {
        found.extend(r.numerator.variables());
        found.extend(r.denominator.variables());
    };
    let combination = |by: &Combination, found: &mut BTreeSet<Variable>| {
        found.extend(by.multiplier.variables());
        found.extend(by.cofactors.iter().flat_map(|(_, c)| c.variables()));
    };
    for goal in &argument.goals {
        ratio(&goal.left, &mut found);
        ratio(&goal.right, &mut found);
        combination(&goal.by, &mut found);
    }
    for bound in &argument.bounds {
        ratio(&bound.value, &mut found);
    }
    for fact in &argument.facts {
        found.extend(fact.value.variables());
        if let Reason::Combination(by) = &fact.reason {
            combination(by, &mut found);
        }
    }
    for (variable, rate) in &argument.rates {
        found.insert(*variable);
        ratio(rate, &mut found);
    }
    for (variable, kernel) in &argument.kernels {
        found.insert(*variable);
        ratio(&kernel.argument, &mut found);
    }
    found.extend(argument.conditions.iter().flat_map(Polynomial::variables));
    found
}

/// One certificate.
fn text(checked: &Checked, line: &Line<'_>) -> String {
    let p = |polynomial: &Polynomial| written(polynomial, line, Dialect::Text);
    let v = |variable: &Variable| format!("v{}", line.numbers[variable]);
    let ratio = |r: &Ratio| format!("({}) / ({})", p(&r.numerator), p(&r.denominator));
    let mut rows = vec![
        "polhode-certificate/1".to_owned(),
        format!("document {}", quoted(&checked.report.path)),
        format!("line {}", line.finding.source_line),
        format!("source {}", quoted(&line.finding.source)),
    ];
    if let Some(cell) = line.finding.cell {
        rows.insert(2, format!("cell {cell}"));
    }
    for (variable, number) in &line.numbers {
        let name = checked.report.variable(*variable);
        rows.push(format!("symbol v{number} {}", quoted(name)));
    }
    let argument = &line.argument;
    for (variable, rate) in &argument.rates {
        rows.push(format!("rate {} {}", v(variable), ratio(rate)));
    }
    for (variable, kernel) in &argument.kernels {
        let (function, at) = (kernel.function, ratio(&kernel.argument));
        rows.push(format!("kernel {} {function} {at}", v(variable)));
    }
    rows.extend(
        argument
            .conditions
            .iter()
            .map(|c| format!("condition {}", p(c))),
    );
    let combination = |by: &Combination, rows: &mut Vec<String>| {
        rows.push(format!("multiplier {}", p(&by.multiplier)));
        for (fact, cofactor) in &by.cofactors {
            rows.push(format!("cofactor f{fact} {}", p(cofactor)));
        }
    };
    for (index, fact) in argument.facts.iter().enumerate() {
        let reason = match &fact.reason {
            Reason::Premise(name) => format!("premise {}", quoted(name)),
            Reason::Circle { sine, cosine } => format!("circle {} {}", v(sine), v(cosine)),
            Reason::Root(root) => format!("root {}", v(root)),
            Reason::Rate(of) => format!("rate f{of}"),
            Reason::Congruence { one, other, by } => {
                format!("congruence {} {} f{by}", v(one), v(other))
            }
            Reason::Combination(_) => "combination".to_owned(),
        };
        rows.push(format!("fact f{index} {}", p(&fact.value)));
        rows.push(format!("reason {reason}"));
        if let Reason::Combination(by) = &fact.reason {
            combination(by, &mut rows);
        }
    }
    for goal in &argument.goals {
        rows.push("goal".to_owned());
        rows.push(format!("left {}", ratio(&goal.left)));
        rows.push(format!("right {}", ratio(&goal.right)));
        combination(&goal.by, &mut rows);
    }
    for bound in &argument.bounds {
        rows.push(format!("bound {}", ratio(&bound.value)));
        rows.push(format!("lower {}", bound.lower));
        rows.push(format!("upper {}", bound.upper));
    }
    rows.push("end\n".to_owned());
    rows.join("\n")
}

/// Terms that Python reads as a sum; its reader nests one level deeper with each.
const LONGEST_SUM: usize = 40;

/// How products, powers and fractions are written.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Dialect {
    Text,
    Python,
}

/// A polynomial in the variables' numbers: `3/2*v0^2*v1 - v2`.
fn written(polynomial: &Polynomial, line: &Line<'_>, dialect: Dialect) -> String {
    if polynomial.is_empty() {
        return "0".to_owned();
    }
    if dialect == Dialect::Python && polynomial.len() > LONGEST_SUM {
        let alone = |(m, c): &(Monomial, Rational)| Polynomial::term(m.clone(), c.clone());
        let terms = polynomial.terms().iter();
        let terms: Vec<String> = terms.map(|t| written(&alone(t), line, dialect)).collect();
        return format!("Add({})", terms.join(", "));
    }
    let mut text = String::new();
    for (monomial, coefficient) in polynomial.terms() {
        let (negative, size) = (coefficient.is_negative(), coefficient.abs());
        text.push_str(match (text.is_empty(), negative) {
            (true, true) => "-",
            (true, false) => "",
            (false, true) => " - ",
            (false, false) => " + ",
        });
        let powers = monomial.powers();
        let mut factors = vec![];
        let number = size.to_string();
        if number != "1" || powers.is_empty() {
            factors.push(match (dialect, number.split_once('/')) {
                (Dialect::Python, Some((n, d))) => format!("Rational({n}, {d})"),
                (Dialect::Python, None) if powers.is_empty() => format!("Integer({number})"),
                _ => number,
            });
        }
        for (variable, exponent) in powers {
            let number = line.numbers.get(&variable).copied().unwrap_or(usize::MAX);
            let mut factor = format!("v{number}");
            if exponent > 1 {
                let sign = if dialect == Dialect::Text { "^" } else { "**" };
                let _ = write!(factor, "{sign}{exponent}");
            }
            factors.push(factor);
        }
        text.push_str(&factors.join("*"));
    }
    text
}

/// A text in double quotes, in ASCII, on one line: `\` and `"` behind a backslash, everything else that is not
/// printable ASCII as `\u0000` or `\U00000000`. Python reads it as the same text.
fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            ' '..='~' => out.push(c),
            c if (c as u32) < 0x1_0000 => {
                let _ = write!(out, "\\u{:04x}", c as u32);
            }
            c => {
                let _ = write!(out, "\\U{:08x}", c as u32);
            }
        }
    }
    out.push('"');
    out
}
