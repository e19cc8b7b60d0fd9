//! A document with some lines in it, and what the crate says of each.

use super::expr::{Atom, Expr, Line, Seen, Vector};
use super::family::Family;
use super::style::Style;
use super::world::Body;
use polhode::notation::{document::Format, read};
use polhode::verify::{Finding, check};

/// A page, and where its lines stand.
pub(crate) struct Page {
    pub(crate) text: String,
    /// The lines of the file on which the lines of the derivation begin.
    places: Vec<usize>,
    plain: bool,
}

impl Page {
    pub(crate) fn new(family: &Family, style: &Style, lines: &[Line]) -> Self {
        let mut page = Self {
            text: opening(family, style, lines),
            places: vec![],
            plain: style.plain,
        };
        for line in lines {
            page.push(&style.line(line));
        }
        page
    }

    fn push(&mut self, line: &str) {
        self.text.push_str("\n\n");
        self.places
            .push(self.text.lines().count() + if self.plain { 1 } else { 2 });
        let display = if self.plain {
            format!("    {line}\n")
        } else {
            format!("$$\n{line}\n$$\n")
        };
        self.text.push_str(&display);
        self.text.push_str("\nThe next line is");
    }

    /// The finding on each line, if there is one.
    pub(crate) fn findings(&self) -> Vec<Option<Finding>> {
        let format = if self.plain {
            Format::Text
        } else {
            Format::Markdown
        };
        let (document, _) = read("corpus", &self.text, format);
        let findings = check(&document).findings;
        let at = |place: &usize| findings.iter().find(|f| f.source_line == *place).cloned();
        self.places.iter().map(at).collect()
    }
}

/// The words before the first line: what the letters are, and what is assumed.
fn opening(family: &Family, style: &Style, lines: &[Line]) -> String {
    let premises = family.premises;
    let formula = |text: String| style.formula(&text);
    let mut text = String::from("# A page\n\n");
    text.push_str(match premises.turning {
        true => "The axes xyz turn with an angular velocity of their own, not that of the body, and XYZ keep their orientation. ",
        false => "The axes xyz are attached to the body, and XYZ keep their orientation. ",
    });
    text.push_str(&(family.said)(style));
    let uses = |vector: Vector| {
        lines.iter().any(|line| {
            line.any(&|e| match e {
                Expr::Whole(v, _) | Expr::Atom(Atom::Part(v, ..)) => *v == vector,
                _ => false,
            })
        })
    };
    for (vector, words) in [
        (Vector::Moment, "The resultant moment is "),
        (Vector::Momentum, "The angular momentum is "),
    ] {
        if uses(vector) {
            text.push_str(words);
            text.push_str(&formula(style.vector(vector)));
            text.push_str(". ");
        }
    }
    if premises.turning {
        text.push_str("The angular velocity of the body is ");
        text.push_str(&formula(
            style.expr(&Expr::Whole(Vector::Omega, Seen::Value)),
        ));
        text.push_str(". The axes turn with angular velocity ");
        text.push_str(&formula(
            style.expr(&Expr::Whole(Vector::Frame, Seen::Value)),
        ));
        text.push_str(". ");
    }
    if premises.body != Body::Full {
        text.push_str("The axes are principal axes. ");
    }
    if premises.body == Body::Symmetric {
        let [a, b] = [0, 1].map(|i| style.atom(Atom::Inertia(i, i, 0)));
        text.push_str(&format!("Assume {}. ", formula(format!("{a} = {b}"))));
    }
    if premises.free {
        text.push_str("No moment acts. ");
    }
    if style.rates {
        text.push_str("The angular velocity has the components $p$, $q$ and $r$. ");
    }
    for line in &family.assumed {
        text.push_str(&format!("Assume {}. ", formula(style.line(line))));
    }
    text.push_str("The first line is");
    text
}
