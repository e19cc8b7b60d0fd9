//! The tree that a formula is read into.
//!
//! The tree says what was *written*, not what it means: `I\omega` is a product by juxtaposition,
//! whether I is a tensor or a number; `[a]` is a bracket, whether it groups or makes a skew matrix. What
//! a symbol stands for is decided for the document as a whole by `verify`. Every node knows its bytes.

mod alike;
mod packed;
mod walk;

pub(crate) use alike::Shape;
pub(crate) use packed::{packed, unpacked};

use crate::source::Span;
use num_rational::BigRational;
use num_traits::One;
use std::hash::{Hash, Hasher};

/// A piece of a formula and its place in the source.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// What it is.
    pub kind: Kind,
    /// Where it stands, decorations (`\underbrace`, `\boxed`, spaces inside) included.
    pub span: Span,
}

impl Node {
    /// Whether −1 is written, as in the exponent of an inverse.
    pub(crate) fn is_minus_one(&self) -> bool {
        let one = |node: &Self| matches!(&node.kind, Kind::Number(n) if n.value.is_one());
        matches!(&self.kind, Kind::Negate(inside) if one(inside))
    }
}

/// What a [`Node`] is.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// A number, exactly as written; `5.0\times 10^{-5}` is one number.
    Number(Number),
    /// A letter with everything that hangs on it.
    Symbol(Symbol),
    /// A bold or plain 1 or 0 that must be an identity or a null vector: `\mathbf{1}`, `\mathbf 0`.
    Bold(Number),
    /// A leading minus.
    Negate(Box<Node>),
    /// Terms with their signs: `a - b + c`. The first sign is `Plus` unless a minus is written; a sum has
    /// at least two terms.
    Sum(Vec<Term>),
    /// Factors from left to right, at least two.
    Product(Vec<Factor>),
    /// `\frac{a}{b}` or `a/b`.
    Quotient(Box<Node>, Box<Node>),
    /// `a^{b}`, but not transposes, inverses of a symbol's index, dots or skew marks, which have their own kinds.
    /// `A^{-1}` is a power.
    Power(Box<Node>, Box<Node>),
    /// `A^T`, `A^{\mathsf T}`, `A^\top`.
    Transpose(Box<Node>),
    /// `[a]_\times`, `a^\times`, `\tilde a` on a bold letter, `S(a)`, `\mathrm{skew}(a)`.
    Skew(Box<Node>),
    /// Brackets around one expression: `(a+b)`, `[a]`, `\{a\}`.
    Group(Bracket, Box<Node>),
    /// `|a|`, `\lVert a \rVert`.
    Norm(Box<Node>),
    /// `(a, b, c)` or `[a, b, c]` or `[a \; b \; c]`: a list of components.
    Tuple(Vec<Node>),
    /// A matrix, row by row; columns and rows are matrices of one column or row.
    Matrix(Vec<Vec<Node>>),
    /// `\begin{vmatrix}` or `\det` of a matrix written out.
    Determinant(Vec<Vec<Node>>),
    /// A derivative in time: dots over an operand, `\frac{d}{dt}`, `\dv{}{t}`, `wdot`.
    TimeDerivative {
        /// What is differentiated.
        operand: Box<Node>,
        /// How often.
        order: u8,
        /// Dots or a quotient of differentials; people use both for different frames.
        style: DerivativeStyle,
        /// The frame the author wrote beside it: `_{XYZ}`, `|_{R_0}`, `{}^N d`.
        frame: Option<FrameLabel>,
    },
    /// An ordinary or partial derivative in something other than time, `\frac{\partial f}{\partial x}`,
    /// `\nabla_x f`; order above 1 by repeated entries in `variables`.
    Derivative {
        /// What is differentiated.
        operand: Box<Node>,
        /// In what.
        variables: Vec<Node>,
        /// `∂` (true) or `d`.
        partial: bool,
    },
    /// A named function: sin, cos, tan, exp, ln, sqrt, arctan, det, tr, …
    Function(Function, Box<Node>),
    /// A symbol directly followed by a parenthesised list: `R(t)`, `F(\omega)`, but also `m(a+b)`. Only
    /// `verify` can tell a call from a product. The arguments are at least one.
    Call(Box<Node>, Vec<Node>),
    /// Something in brackets, or followed by a bar, with a frame label: `(L)_{xyz}`, `[a]_B`.
    InFrame(Box<Node>, FrameLabel),
    /// An integral; never evaluated by the reader.
    Integral {
        /// What is integrated.
        integrand: Box<Node>,
        /// The variable after the d: `t`, `m`, `V`.
        variable: Box<Node>,
        /// Lower and upper limit, where both are written.
        limits: Option<(Box<Node>, Box<Node>)>,
    },
    /// `\sum_{i=1}^{3} …` with an index. `\sum M` without one is the resultant and is part of the symbol.
    IndexedSum {
        /// The index letter.
        index: Box<Symbol>,
        /// Lower and upper limit, where written.
        limits: Option<(Box<Node>, Box<Node>)>,
        /// The summand.
        body: Box<Node>,
    },
    /// `\pm` or `\mp` before something: no single value.
    PlusMinus(Box<Node>),
    /// A number or expression with a unit of measurement after it; the unit as SI factors would be is not
    /// needed: its text is kept.
    WithUnit(Box<Node>, String),
    /// `\ldots`, `\cdots`: something left out.
    Ellipsis,
    /// What could not be read, and what was expected there.
    Error(String),
}

/// A number as it was written.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// Its exact value.
    pub value: BigRational,
    /// Digits after the decimal point as written (`2.50` has two); `None` for an integer. With an
    /// exponent the place value of the last digit is `10^(exponent − decimals)`.
    pub decimals: Option<u32>,
    /// The written power of ten.
    pub exponent: i32,
}

/// A term of a sum.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// `true` for a minus before it.
    pub negative: bool,
    /// The bytes of the sign; empty at the start of a first term without one.
    pub sign: Span,
    /// The term without its sign.
    pub node: Node,
}

/// A factor of a product.
#[derive(Clone, Debug, PartialEq)]
pub struct Factor {
    /// How it is joined to the factor on its left; `Juxtaposed` for the first.
    pub operator: Operator,
    /// The bytes of the operator; empty where nothing is written.
    pub sign: Span,
    /// The factor.
    pub node: Node,
}

/// A sign of multiplication.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// Nothing written, or `*`.
    Juxtaposed,
    /// `\cdot`, `·`.
    Dot,
    /// `\times`, `\wedge`.
    Cross,
    /// `\otimes`, or `\circ` between quaternions.
    Tensor,
}

/// The shape of a bracket.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bracket {
    /// `( )`
    Round,
    /// `[ ]`
    Square,
    /// `\{ \}`
    Curly,
}

/// How a derivative in time is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DerivativeStyle {
    /// `\dot a`
    Dots,
    /// `\frac{da}{dt}`
    Leibniz,
}

/// A frame written beside a derivative or a bracket: `XYZ`, `\text{body}`, `S_0`; its bytes, and its text with
/// commands and braces taken off (`S0`, `in B`).
#[derive(Clone, Debug, PartialEq)]
pub struct FrameLabel {
    /// The label as plain text.
    pub text: String,
    /// Where.
    pub span: Span,
}

impl FrameLabel {
    /// Of axes that turn, for which d' stands (Landau and Lifshitz, Mechanics, § 36).
    pub(crate) const TURNING: &str = "'";
    /// Of a rate that is written with δ in the place of d, until the document tells what that means.
    pub(crate) const DELTA: &str = "δ";

    pub(crate) fn new(text: &str, span: Span) -> Self {
        Self {
            text: text.to_owned(),
            span,
        }
    }
}

/// A letter or a word with everything that hangs on it.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Symbol {
    /// The letter as plain text: `omega`, `Omega`, `L`, `ell`, `I`, `wdot` never (that is a time derivative).
    pub name: String,
    /// What is drawn on or around the letter.
    pub style: Style,
    /// Each entry of the subscript: `_{xy}` on a tensor is `["xy"]`, `_{k+1}` is `["k+1"]`,
    /// `_{x,k}` is `["x", "k"]`, `_{G \text{ or } O}` is `["G or O"]`. Commands and braces are taken off.
    pub subscripts: Vec<String>,
    /// Superscripts that are no powers: `^{(n+1)}`, `^O`, `{}^{B}`, a star.
    pub superscripts: Vec<String>,
    /// The number of primes.
    pub primes: u8,
    /// `\Sigma M`, `\sum F`: the resultant is meant.
    pub resultant: bool,
    /// `\delta x`, `\Delta x`: a variation or increment written before the letter.
    pub variation: bool,
}

/// Of what tells most symbols apart.
impl Hash for Symbol {
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write(self.name.as_bytes());
        for index in self.subscripts.iter().chain(&self.superscripts) {
            state.write(index.as_bytes());
        }
        state.write_u8(self.primes << 1 | u8::from(self.style.vector));
    }
}

/// What is drawn on or around a letter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct Style {
    /// `\vec`, `\overrightarrow`, `\mathbf`, `\boldsymbol`, `\bm`, `\underline`, `\bar` once: marks that make a vector.
    pub vector: bool,
    /// `\hat`: a unit vector, or a quantity with a hat.
    pub hat: bool,
    /// `\bar`, `\overline` once: a vector for some, a mean for others.
    pub bar: bool,
    /// `\mathbb`, `\overline{\overline I}`, `\vec{\vec I}`, `\underline{\underline{I}}`, `\mathsf`: a tensor.
    pub tensor: bool,
    /// `\mathcal`, `\mathscr`: another letter.
    pub calligraphic: bool,
    /// `\tilde`, `\widetilde`.
    pub tilde: bool,
    /// `\mathrm`, `\text`: upright, a word rather than a letter.
    pub upright: bool,
    /// `\Delta`-free star, `\check`, `\breve`: another letter.
    pub other: bool,
}

/// A function with a name of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "each is the function of that name")]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Cot,
    Sec,
    Csc,
    Arcsin,
    Arccos,
    Arctan,
    Sinh,
    Cosh,
    Tanh,
    Exp,
    Ln,
    Sqrt,
    Det,
    Trace,
    Vee,
    Diag,
    Skew,
    Sign,
    Abs,
    Min,
    Max,
}

/// A relation between two sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// `=`, `&=&`.
    Equal,
    /// `\equiv`, `:=`, `\triangleq`, `\stackrel{def}{=}`: says that the left side is defined.
    Defined,
    /// `\approx`, `\simeq`, `\cong`.
    Approximate,
    /// `\ne`.
    NotEqual,
    /// `<`
    Less,
    /// `\le`
    LessOrEqual,
    /// `>`
    Greater,
    /// `\ge`
    GreaterOrEqual,
    /// `\propto`, `\sim`, `\to`, `\mapsto`, `\in`, `\perp`, `\parallel`: not an equation that can be decided.
    Other,
}

/// One line of a derivation: `a = b = c`.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// The sides, one more than the relations. Where the line goes on from the line before (`&= b`), the
    /// first side is missing and there are as many sides as relations.
    pub sides: Vec<Node>,
    /// The relations and their places.
    pub relations: Vec<(Relation, Span)>,
    /// `true` where the line begins with a relation, so that its first side is the last one of the line before.
    pub continues: bool,
    /// `\tag{5}`, `\label{…}`, `\text{--- (5)}`: `(5)`, as written but with the brackets always there for tags and
    /// remarks, and the bare name for `\label`. The first is the one shown.
    pub labels: Vec<String>,
    /// `(i = 1, 2, 3)` after a line: the index and its values.
    pub ranges: Vec<(String, Vec<String>)>,
    /// Remarks in `\text{…}` that are no labels, in order.
    pub remarks: Vec<String>,
    /// All the bytes of the line, labels and remarks left out.
    pub span: Span,
}
