//! A line back from its text, so that a suggested repair can be put to the oracle.

use super::expr::{Atom, Expr, Line, Seen, Vector, cross, dot, over, rate, square};
use super::symbol::moving;

/// Reads an equation in the notation that `style` writes, or that a repair in it may use.
pub(crate) fn line(text: &str) -> Option<Line> {
    let clean = text
        .replace("\\left", "")
        .replace("\\right", "")
        .replace("\\,", " ")
        .replace('−', "-")
        .replace('Ḣ', "H\u{307}")
        .replace('Ṫ', "T\u{307}")
        .replace("\\boldsymbol", "\\vec")
        .replace("\\mathbf", "\\vec")
        .replace("\\dfrac", "\\frac")
        .replace("\\tfrac", "\\frac");
    let mut reader = Reader { rest: &clean };
    let left = reader.sum()?;
    reader.take("=").then_some(())?;
    let right = reader.sum()?;
    reader
        .rest
        .trim()
        .is_empty()
        .then_some(Line { left, right })
}

pub(super) struct Reader<'a> {
    pub(super) rest: &'a str,
}

impl<'a> Reader<'a> {
    pub(super) fn take(&mut self, text: &str) -> bool {
        self.rest = self.rest.trim_start();
        match self.rest.strip_prefix(text) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    /// Reads with `read`, or goes back.
    fn attempt<T>(&mut self, read: impl Fn(&mut Self) -> Option<T>) -> Option<T> {
        let before = self.rest;
        let found = read(self);
        if found.is_none() {
            self.rest = before;
        }
        found
    }

    fn sum(&mut self) -> Option<Expr> {
        let negative = self.take("-");
        let mut terms = vec![(negative, self.term()?)];
        loop {
            let negative = match (self.take("+"), self.take("-")) {
                (false, false) => break,
                (_, negative) => negative,
            };
            terms.push((negative, self.term()?));
        }
        match terms.as_slice() {
            [(false, _)] => terms.pop().map(|(_, e)| e),
            _ => Some(Expr::Sum(terms)),
        }
    }

    fn term(&mut self) -> Option<Expr> {
        let mut left = self.product()?;
        loop {
            if self.take("\\times") || self.take("×") {
                left = cross(left, self.product()?);
            } else if self.take("\\cdot") || self.take("·") {
                left = dot(left, self.product()?);
            } else {
                return Some(left);
            }
        }
    }

    /// What stands before a T in the exponent, turned over.
    pub(super) fn transposed(&mut self, inside: Expr) -> Expr {
        match inside {
            Expr::Attitude(dots, turned) => {
                let turns = self.take("^T") || self.take("^{T}");
                Expr::Attitude(dots, turned != turns)
            }
            other => other,
        }
    }

    /// Factors side by side; a stroke divides what stands before it by the factor behind it.
    fn product(&mut self) -> Option<Expr> {
        let mut factors = vec![self.factor()?];
        loop {
            if self.take("/") {
                let below = self.factor()?;
                factors = vec![over(joined(factors)?, below)];
            } else if let Some(factor) = self.attempt(Self::factor) {
                factors.push(factor);
            } else {
                return joined(factors);
            }
        }
    }

    fn factor(&mut self) -> Option<Expr> {
        let base = self.primary()?;
        let squared = ["^2", "^{2}", "²"]
            .iter()
            .any(|exponent| self.take(exponent));
        Some(if squared { square(base) } else { base })
    }

    fn primary(&mut self) -> Option<Expr> {
        self.rest = self.rest.trim_start();
        if self.take("½") {
            return Some(Expr::Number(1, 2));
        }
        if let Some(seen) = self.attempt(Self::seen_rate) {
            return Some(seen);
        }
        if self.take("[\\vec{\\omega}]_\\times") {
            return Some(Expr::Skew);
        }
        if self.take("\\vec{1}") {
            return Some(Expr::Identity);
        }
        if self.take("(") || self.take("[") {
            let inside = self.sum()?;
            (self.take(")") || self.take("]")).then_some(())?;
            return Some(self.transposed(inside));
        }
        if self.take("\\begin{bmatrix}") {
            return self.grid();
        }
        let readers: [fn(&mut Self) -> Option<Expr>; 5] = [
            Self::rate,
            Self::partial,
            Self::fraction,
            Self::number,
            Self::symbol,
        ];
        readers.into_iter().find_map(|read| self.attempt(read))
    }

    fn number(&mut self) -> Option<Expr> {
        let end = self
            .rest
            .find(|c: char| !c.is_ascii_digit())
            .unwrap_or(self.rest.len());
        let (digits, rest) = self.rest.split_at(end);
        self.rest = rest;
        digits.parse().ok().map(|n| Expr::Number(n, 1))
    }

    fn fraction(&mut self) -> Option<Expr> {
        self.take("\\frac{").then_some(())?;
        let top = self.sum()?;
        (self.take("}") && self.take("{")).then_some(())?;
        let bottom = self.sum()?;
        self.take("}").then_some(over(top, bottom))
    }

    /// d/dt of a symbol or of what stands in parentheses behind it.
    fn rate(&mut self) -> Option<Expr> {
        if self.take("\\frac{d}{dt}") || self.take("d/dt") {
            return Some(rate(self.primary()?));
        }
        self.take("\\frac{d ").then_some(())?;
        let inside = self.symbol()?;
        self.take("}{dt}").then_some(())?;
        moving(inside)
    }

    /// (dL/dt)_XYZ, with a dot or a quotient inside.
    fn seen_rate(&mut self) -> Option<Expr> {
        self.take("(").then_some(())?;
        let inside = if self.take("d") {
            let inside = self.symbol()?;
            self.take("/dt").then_some(())?;
            moving(inside)?
        } else {
            self.attempt(Self::rate).or_else(|| self.symbol())?
        };
        self.take(")").then_some(())?;
        let space = ["_{XYZ}", "_XYZ"].iter().any(|label| self.take(label));
        let body = !space && ["_{xyz}", "_xyz"].iter().any(|label| self.take(label));
        match inside {
            Expr::Whole(vector, Seen::Moving) if space => Some(Expr::Whole(vector, Seen::Space)),
            Expr::Whole(..) if body => Some(inside),
            _ => None,
        }
    }

    fn partial(&mut self) -> Option<Expr> {
        let braces = self.take("\\frac{\\partial");
        (braces || self.take("∂")).then_some(())?;
        let top = self.symbol()?;
        let between = if braces {
            self.take("}{\\partial")
        } else {
            self.take("/∂")
        };
        between.then_some(())?;
        let bottom = self.symbol()?;
        (!braces || self.take("}")).then_some(())?;
        match (top, bottom) {
            (
                Expr::Atom(Atom::Part(vector, i, dots)),
                Expr::Atom(Atom::Part(Vector::Omega, j, 0)),
            ) => Some(Expr::Atom(Atom::Partial((vector, i, dots), j))),
            (Expr::Atom(Atom::Energy(0)), Expr::Atom(Atom::Part(Vector::Omega, j, 0))) => {
                Some(Expr::Atom(Atom::EnergyPartial(j)))
            }
            _ => None,
        }
    }

    fn grid(&mut self) -> Option<Expr> {
        let mut entries = vec![];
        loop {
            entries.push(self.sum()?);
            if self.take("\\end{bmatrix}") {
                break;
            }
            (self.take("&") || self.take("\\\\")).then_some(())?;
        }
        match entries.len() {
            3 => Some(Expr::Column(entries)),
            9 => Some(Expr::Matrix(entries)),
            _ => None,
        }
    }
}

fn joined(mut factors: Vec<Expr>) -> Option<Expr> {
    match factors.len() {
        0 => None,
        1 => factors.pop(),
        _ => Some(Expr::Product(factors)),
    }
}
