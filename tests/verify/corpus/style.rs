//! How a document writes its symbols, and its lines in that notation.

use super::expr::{Atom, Expr, Line, Point, Seen, Vector};
use super::random::Random;

/// A choice of letters and marks.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Style {
    /// Plain text in Unicode rather than LaTeX.
    pub(crate) plain: bool,
    /// Indices 1, 2, 3 rather than x, y, z.
    pub(crate) digits: bool,
    pub(crate) momentum: &'static str,
    pub(crate) moment: &'static str,
    pub(crate) inertia: &'static str,
    /// Moments of inertia with one index.
    pub(crate) single: bool,
    /// p, q, r for the components of ω.
    pub(crate) rates: bool,
    /// The command that marks a vector.
    pub(crate) dress: &'static str,
    /// Rates as quotients rather than dots.
    pub(crate) quotients: bool,
    /// The letter of the vector from a moving point to the mass centre.
    pub(crate) arm: &'static str,
}

const LATEX_MOMENTS: &[&str] = &["\\Sigma M", "M", "N", "\\tau", "\\Gamma"];
const PLAIN_MOMENTS: &[&str] = &["ΣM", "M", "τ"];

impl Style {
    /// The manner of the book.
    pub(crate) const BOOK: Self = Self {
        plain: false,
        digits: false,
        momentum: "L",
        moment: "\\Sigma M",
        inertia: "I",
        single: false,
        rates: false,
        dress: "\\vec",
        quotients: false,
        arm: "r",
    };

    pub(crate) fn draw(random: &mut Random) -> Self {
        let plain = random.one_in(5);
        let moments = if plain { PLAIN_MOMENTS } else { LATEX_MOMENTS };
        let one =
            |random: &mut Random, from: &[&'static str]| random.pick(from).copied().unwrap_or("");
        Self {
            plain,
            digits: random.one_in(3),
            momentum: one(random, &["L", "L", "H"]),
            moment: one(random, moments),
            inertia: one(random, &["I", "I", "J"]),
            single: random.one_in(2),
            rates: !plain && random.one_in(6),
            dress: one(random, &["\\vec", "\\mathbf", "\\boldsymbol", "\\vec"]),
            quotients: random.one_in(5),
            arm: one(random, &["r", "\\rho"]),
        }
    }

    /// The same letters in LaTeX.
    pub(crate) fn in_latex(self) -> Self {
        let moment = match self.moment {
            "ΣM" => "\\Sigma M",
            "τ" => "\\tau",
            other => other,
        };
        Self {
            plain: false,
            moment,
            ..self
        }
    }

    /// A formula in a sentence.
    pub(crate) fn formula(&self, text: &str) -> String {
        match self.plain {
            true => text.to_owned(),
            false => format!("${text}$"),
        }
    }

    fn axis(&self, i: usize) -> char {
        let names = if self.digits {
            ['1', '2', '3']
        } else {
            ['x', 'y', 'z']
        };
        names[i % 3]
    }

    fn letter(&self, vector: Vector) -> &'static str {
        match (vector, self.plain) {
            (Vector::Omega, true) => "ω",
            (Vector::Omega, false) => "\\omega",
            (Vector::Frame, true) => "Ω",
            (Vector::Frame, false) => "\\Omega",
            (Vector::Momentum | Vector::CentreMomentum | Vector::PointMomentum, _) => self.momentum,
            (Vector::Moment | Vector::CentreMoment | Vector::PointMoment, _) => self.moment,
            (Vector::Velocity | Vector::CentreVelocity | Vector::PointVelocity, _) => "v",
            (Vector::Force, _) => "F",
            (Vector::LinearMomentum, _) if self.rates || self.plain => "Q",
            (Vector::LinearMomentum, _) => "p",
            (Vector::Arm, _) if self.rates => "\\rho",
            (Vector::Arm, _) => self.arm,
        }
    }

    /// A letter with dots and subscript.
    fn dotted(&self, letter: &str, subscript: &str, dots: u8) -> String {
        let subscript = match subscript.len() {
            0 => String::new(),
            1 => format!("_{subscript}"),
            _ if self.plain => format!("_{subscript}"),
            _ => format!("_{{{subscript}}}"),
        };
        match (dots, self.plain, self.quotients) {
            (0, ..) => format!("{letter}{subscript}"),
            (1, true, _) => format!("{letter}\u{307}{subscript}"),
            (1, false, true) => format!("\\frac{{d {letter}{subscript}}}{{dt}}"),
            (1, false, false) => format!("\\dot{{{letter}}}{subscript}"),
            _ => format!("\\ddot{{{letter}}}{subscript}"),
        }
    }

    pub(crate) fn atom(&self, atom: Atom) -> String {
        match atom {
            Atom::Part(Vector::Omega, i, dots) if self.rates => {
                self.dotted(["p", "q", "r"][i % 3], "", dots)
            }
            Atom::Part(vector, i, dots) => {
                self.dotted(self.letter(vector), &self.axis(i).to_string(), dots)
            }
            Atom::Inertia(i, j, dots) => {
                let both: String = [self.axis(i), self.axis(j)].iter().collect();
                let index = if self.single && i == j {
                    self.axis(i).to_string()
                } else {
                    both
                };
                self.dotted(self.inertia, &index, dots)
            }
            Atom::Energy(dots) => self.dotted("T", "", dots),
            Atom::Quaternion(i, dots) => self.dotted(["w", "x", "y", "z"][i % 4], "", dots),
            Atom::Partial((vector, i, dots), j) => {
                let [top, bottom] =
                    [(vector, i, dots), (Vector::Omega, j, 0)].map(|(vector, i, dots)| {
                        Style {
                            quotients: false,
                            ..*self
                        }
                        .atom(Atom::Part(vector, i, dots))
                    });
                self.partial(&top, &bottom)
            }
            Atom::EnergyPartial(i) => {
                self.partial("T", &self.atom(Atom::Part(Vector::Omega, i, 0)))
            }
            Atom::Mass => "m".to_owned(),
            Atom::About(point, i, j) => {
                let label = if point == Point::Centre { "G" } else { "O" };
                format!("{}^{label}", self.atom(Atom::Inertia(i, j, 0)))
            }
            Atom::Place(i) => format!("{}_G", ["x", "y", "z"][i % 3]),
        }
    }

    fn partial(&self, top: &str, bottom: &str) -> String {
        match self.plain {
            true => format!("∂{top}/∂{bottom}"),
            false => format!("\\frac{{\\partial {top}}}{{\\partial {bottom}}}"),
        }
    }

    /// A whole vector.
    pub(crate) fn vector(&self, vector: Vector) -> String {
        let letter = self.letter(vector);
        let (sum, letter) = match letter.strip_prefix("\\Sigma ") {
            Some(rest) => ("\\Sigma ", rest),
            None => ("", letter),
        };
        let label = match vector {
            Vector::CentreVelocity | Vector::CentreMomentum | Vector::CentreMoment => "_G",
            Vector::PointVelocity | Vector::PointMomentum | Vector::PointMoment => "_P",
            _ => "",
        };
        match self.plain {
            true => format!("{sum}{letter}{label}"),
            false => format!("{sum}{}{{{letter}}}{label}", self.dress),
        }
    }

    fn attitude(&self, dots: u8, turned: bool) -> String {
        match (turned, dots > 0 && self.quotients) {
            (false, _) => self.dotted("R", "", dots),
            (true, true) => format!("({})^T", self.dotted("R", "", dots)),
            (true, false) => format!("{}^T", self.dotted("R", "", dots)),
        }
    }

    fn whole(&self, vector: Vector, seen: Seen) -> String {
        let name = self.vector(vector);
        let label = match (seen, self.digits) {
            (Seen::Value, _) => return name,
            (Seen::Space, _) => "XYZ",
            (Seen::Moving, _) => "xyz",
        };
        match (self.plain, self.quotients) {
            (true, _) => format!("(d{name}/dt)_{label}"),
            (false, true) => format!("\\left(\\frac{{d {name}}}{{dt}}\\right)_{{{label}}}"),
            (false, false) => format!("(\\dot{{{name}}})_{{{label}}}"),
        }
    }

    pub(crate) fn line(&self, line: &Line) -> String {
        format!("{} = {}", self.expr(&line.left), self.expr(&line.right))
    }

    pub(crate) fn expr(&self, expr: &Expr) -> String {
        match expr {
            Expr::Number(a, 1) => a.to_string(),
            Expr::Number(1, 2) if self.plain => "½".to_owned(),
            Expr::Number(a, b) if self.plain => format!("({a}/{b})"),
            Expr::Number(a, b) => format!("\\tfrac{{{a}}}{{{b}}}"),
            Expr::Atom(atom) => self.atom(*atom),
            Expr::Whole(vector, seen) => self.whole(*vector, *seen),
            Expr::Tensor(dots) => self.dotted(self.inertia, "", *dots),
            Expr::Attitude(dots, turned) => self.attitude(*dots, *turned),
            Expr::Skew => format!("[{}]_\\times", self.vector(Vector::Omega)),
            Expr::Identity => "\\mathbf{1}".to_owned(),
            Expr::Sum(terms) => self.sum(terms),
            Expr::Product(factors) => factors
                .iter()
                .map(|factor| self.factor(factor))
                .collect::<Vec<_>>()
                .join(" "),
            Expr::Quotient(a, b) if self.plain => {
                format!("{} / {}", self.factor(a), self.divisor(b))
            }
            Expr::Quotient(a, b) => format!("\\frac{{{}}}{{{}}}", self.expr(a), self.expr(b)),
            Expr::Square(a) => self.square(a),
            Expr::Rate(a) if self.plain => format!("d/dt ({})", self.expr(a)),
            Expr::Rate(a) => format!("\\frac{{d}}{{dt}} \\left( {} \\right)", self.expr(a)),
            Expr::Cross(a, b) => {
                let sign = if self.plain { "×" } else { "\\times" };
                format!("{} {sign} {}", self.operand(a), self.operand(b))
            }
            Expr::Dot(a, b) => {
                let sign = if self.plain { "·" } else { "\\cdot" };
                format!("{} {sign} {}", self.operand(a), self.operand(b))
            }
            Expr::Column(entries) => self.grid(entries, 1),
            Expr::Matrix(entries) => self.grid(entries, 3),
        }
    }

    fn sum(&self, terms: &[(bool, Expr)]) -> String {
        let mut text = String::new();
        let minus = if self.plain { "−" } else { "-" };
        for (i, (negative, term)) in terms.iter().enumerate() {
            let written = match term {
                Expr::Sum(_) => format!("({})", self.expr(term)),
                _ => self.expr(term),
            };
            match (i, negative) {
                (0, false) => {}
                (0, true) => text.push_str(minus),
                (_, false) => text.push_str(" + "),
                (_, true) => text.push_str(&format!(" {minus} ")),
            }
            text.push_str(&written);
        }
        text
    }

    fn factor(&self, expr: &Expr) -> String {
        match expr {
            Expr::Sum(_) | Expr::Cross(..) | Expr::Dot(..) => format!("({})", self.expr(expr)),
            Expr::Quotient(..) if self.plain => format!("({})", self.expr(expr)),
            _ => self.expr(expr),
        }
    }

    fn divisor(&self, expr: &Expr) -> String {
        match expr {
            Expr::Product(_) => format!("({})", self.expr(expr)),
            _ => self.factor(expr),
        }
    }

    /// An operand of × or ·.
    fn operand(&self, expr: &Expr) -> String {
        match expr {
            Expr::Product(_) => format!("({})", self.expr(expr)),
            _ => self.factor(expr),
        }
    }

    fn square(&self, base: &Expr) -> String {
        let exponent = if self.plain { "²" } else { "^2" };
        match base {
            Expr::Atom(
                Atom::Part(_, _, 0)
                | Atom::Inertia(_, _, 0)
                | Atom::Energy(0)
                | Atom::Quaternion(_, 0),
            ) => {
                format!("{}{exponent}", self.expr(base))
            }
            _ => format!("({}){exponent}", self.expr(base)),
        }
    }

    fn grid(&self, entries: &[Expr], columns: usize) -> String {
        let rows: Vec<String> = entries
            .chunks(columns)
            .map(|row| {
                row.iter()
                    .map(|e| self.expr(e))
                    .collect::<Vec<_>>()
                    .join(" & ")
            })
            .collect();
        format!(
            "\\begin{{bmatrix}} {} \\end{{bmatrix}}",
            rows.join(" \\\\ ")
        )
    }
}
