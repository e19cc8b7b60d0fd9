//! Letters, and what is drawn on and around them.

use super::Parser;
use crate::notation::ast::{DerivativeStyle, FrameLabel, Kind, Node, Style, Symbol};
use crate::notation::token::{Lexeme, Token};

const GREEK: &[&str] = &[
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa",
    "lambda", "mu", "nu", "xi", "omicron", "pi", "rho", "sigma", "tau", "upsilon", "phi", "chi",
    "psi", "omega", "Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma", "Upsilon", "Phi",
    "Psi", "Omega", "ell", "hbar", "infty", "wp", "Re", "Im", "mho", "aleph", "dagger", "ddagger",
    "square", "Box", "diamond", "angle",
];

/// The plain name of a letter command; the variant shapes are the same letter.
pub(super) fn greek(name: &str) -> Option<&'static str> {
    let name = name.strip_prefix("var").unwrap_or(name);
    GREEK.iter().find(|g| **g == name).copied()
}

/// The letter of the set of numbers that a command means where the document doesn't define it: `\R`.
pub(super) fn set_of_numbers(name: &str) -> Option<&'static str> {
    Some(match name {
        "R" | "Reals" | "reals" => "R",
        "N" | "natnums" => "N",
        "C" | "Complex" | "cnums" => "C",
        "Z" => "Z",
        _ => return None,
    })
}

/// Whether a command puts something on its argument.
pub(crate) fn takes_argument(name: &str) -> bool {
    dots(name).is_some() || mark(name).is_some() || matches!(name, "operatorname" | "mathring")
}

fn dots(name: &str) -> Option<u8> {
    Some(match name {
        "dot" => 1,
        "ddot" => 2,
        "dddot" => 3,
        "ddddot" => 4,
        _ => return None,
    })
}

#[derive(Clone, Copy, PartialEq)]
enum Mark {
    Arrow,
    Bold,
    Bar,
    Underline,
    Hat,
    Tilde,
    Calligraphic,
    Upright,
    Sans,
    Board,
    Plain,
    Other,
}

/// Whether a command marks the letter behind it.
pub(super) fn is_mark(name: &str) -> bool {
    mark(name).is_some()
}

fn mark(name: &str) -> Option<Mark> {
    Some(match name {
        "vec" | "overrightarrow" | "va" | "vv" | "Vec" | "vect" => Mark::Arrow,
        // The last ones are names by which authors define it, where the text does not hold the definition.
        "mathbf" | "boldsymbol" | "bm" | "pmb" | "bf" | "mathbfit" | "vb" | "vectorbold"
        | "symbf" | "mathbold" | "mbf" | "bvec" | "bmat" => Mark::Bold,
        "bar" | "overline" => Mark::Bar,
        "underline" | "undertilde" | "utilde" => Mark::Underline,
        "hat" | "widehat" | "vu" => Mark::Hat,
        "tilde" | "widetilde" => Mark::Tilde,
        "mathcal" | "mathscr" | "mathfrak" | "cal" => Mark::Calligraphic,
        "mathrm" | "rm" | "textrm@" | "mathup" => Mark::Upright,
        "mathsf" | "mathtt" | "sf" | "overleftrightarrow" | "tensor" => Mark::Sans,
        "mathbb" | "mathds" | "mathbbm" => Mark::Board,
        "mathit" | "it" | "mathnormal" => Mark::Plain,
        "check" | "breve" | "acute" | "grave" => Mark::Other,
        _ => return None,
    })
}

/// What is drawn over a letter by hand.
#[derive(Clone, Copy, PartialEq)]
enum Over {
    Dot,
    Ring,
    Mark(Mark),
}

impl<'t, 'a> Parser<'t, 'a> {
    /// An accent or an alphabet with its argument, the command itself already read.
    pub(super) fn styled(&mut self, name: &'a str, start: usize) -> Node {
        if self.peek() == Some(Lexeme::Char('*')) {
            self.at += 1;
        }
        let tokens = self.argument();
        if mark(name) == Some(Mark::Bold) && is_sum(tokens) && self.load_follows() {
            return self.sum_sign(false, start);
        }
        if let Some(order) = dots(name) {
            let operand = self.inside(tokens).whole();
            let node = dotted(operand, order);
            let node = Node {
                span: self.since(start),
                ..node
            };
            let node = self.scripts(node, start);
            return self.call(node, start);
        }
        if name == "mathring" {
            let operand = self.inside(tokens).whole();
            let node = self.ringed(operand, 1, start);
            let node = self.scripts(node, start);
            return self.call(node, start);
        }
        if name == "operatorname" || mark(name) == Some(Mark::Upright) {
            return self.upright_word(tokens, start);
        }
        let mut node = self.inside(tokens).whole();
        node.span = self.since(start);
        let node = match mark(name) {
            Some(mark) => marked(node, mark, tokens),
            None => node,
        };
        let node = self.scripts(node, start);
        self.call(node, start)
    }

    /// Whether a marked letter of a moment or a force comes next: `\boldsymbol\Sigma\mathbf M`.
    fn load_follows(&self) -> bool {
        let mut next = self.tokens[self.at..].iter().map(|token| token.kind);
        let mut next = next
            .by_ref()
            .filter(|kind| !matches!(kind, Lexeme::Space(_) | Lexeme::Open));
        let marked = matches!(next.next(), Some(Lexeme::Command(name)) if is_mark(name));
        marked
            && matches!(
                next.next(),
                Some(Lexeme::Letter('M' | 'F' | 'T' | 'N') | Lexeme::Command("tau" | "Gamma"))
            )
    }

    /// `\overset{.}{\omega}` and `\stackrel{\leftrightarrow}{I}`: accents drawn by hand.
    pub(super) fn stacked(&mut self, below: bool, start: usize) -> Node {
        let above = self.argument();
        let base = self.argument_node();
        let drawn = |kind: &Lexeme<'_>| match kind {
            Lexeme::Char('.') | Lexeme::Command("cdot" | "bullet") => Some(Over::Dot),
            Lexeme::Command("rightarrow" | "to" | "rightharpoonup" | "longrightarrow") => {
                Some(Over::Mark(Mark::Arrow))
            }
            Lexeme::Command("leftrightarrow" | "Rightarrow" | "rightleftarrows") => {
                Some(Over::Mark(Mark::Sans))
            }
            Lexeme::Command("circ") => Some(Over::Ring),
            Lexeme::Command("sim") => Some(Over::Mark(Mark::Tilde)),
            Lexeme::Command("wedge") | Lexeme::Superscript => Some(Over::Mark(Mark::Hat)),
            _ => None,
        };
        let kinds: Vec<Lexeme<'_>> = above
            .iter()
            .map(|t| t.kind)
            .filter(|kind| !matches!(kind, Lexeme::Space(_)))
            .collect();
        let over =
            match kinds.as_slice() {
                // A wave, a line or an arrow below marks a vector, as underlining does.
                [
                    Lexeme::Command("sim" | "rightarrow" | "to" | "bar") | Lexeme::Char('-' | '~'),
                ] if below => Some(Over::Mark(Mark::Underline)),
                _ if below => None,
                kinds => kinds.first().and_then(drawn),
            };
        let same = kinds.iter().all(|kind| drawn(kind) == over);
        let place = if below { "under" } else { "over" };
        let node = match over {
            Some(Over::Dot) if same => dotted(base, u8::try_from(kinds.len()).unwrap_or(u8::MAX)),
            Some(Over::Ring) if same => {
                self.ringed(base, u8::try_from(kinds.len()).unwrap_or(u8::MAX), start)
            }
            Some(Over::Mark(mark)) if kinds.len() == 1 => marked(base, mark, &[]),
            _ => self.node(
                Kind::Error(format!("what stands {place} this is not known")),
                start,
            ),
        };
        let span = self.since(start);
        let node = self.scripts(Node { span, ..node }, start);
        self.call(node, start)
    }

    /// `\overset{\circ}{L}`: the rate of L on axes that turn, as books of mechanics in German write it.
    fn ringed(&mut self, operand: Node, order: u8, start: usize) -> Node {
        let label = FrameLabel::new(FrameLabel::TURNING, self.since(start));
        let node = self.scripts(dotted(operand, order), start);
        super::frame_label::in_frame(node, label)
    }

    /// `\mathrm{body}` is one word; `\mathrm{diag}` and its like are functions.
    fn upright_word(&mut self, tokens: &'t [Token<'a>], start: usize) -> Node {
        let word = super::text::plain(tokens);
        if super::function::named(&word).is_some() {
            return self.function(&word, start);
        }
        if let [token] = tokens
            && matches!(token.kind, Lexeme::Command(_) | Lexeme::Number(_))
        {
            let node = self.inside(tokens).whole();
            return self.scripts(node, start);
        }
        // `\mathrm{\dot q}`: the dot stands over an upright letter.
        let dotted =
            |token: &Token<'_>| matches!(token.kind, Lexeme::Command(name) if dots(name).is_some());
        if tokens.first().is_some_and(dotted) {
            let mut node = self.inside(tokens).whole();
            if let Some(symbol) = super::script::symbol_of(&mut node) {
                apply(&mut symbol.style, Mark::Upright);
            }
            return self.scripts(node, start);
        }
        self.upright(word, start)
    }
}

/// A time derivative of what may be one already.
pub(super) fn dotted(operand: Node, more: u8) -> Node {
    let span = operand.span;
    let (operand, order) = match operand.kind {
        Kind::TimeDerivative {
            operand,
            order,
            style: DerivativeStyle::Dots,
            frame: None,
        } => (operand, order.saturating_add(more)),
        kind => (Box::new(Node { kind, span }), more),
    };
    Node {
        kind: Kind::TimeDerivative {
            operand,
            order,
            style: DerivativeStyle::Dots,
            frame: None,
        },
        span,
    }
}

fn marked(mut node: Node, mark: Mark, tokens: &[Token<'_>]) -> Node {
    if let Kind::Number(number) = &node.kind {
        let number = number.clone();
        if matches!(mark, Mark::Bold | Mark::Board | Mark::Arrow | Mark::Sans) {
            node.kind = Kind::Bold(number);
        }
        return node;
    }
    if mark == Mark::Tilde && super::script::symbol_of(&mut node).is_some_and(|s| s.style.vector) {
        let span = node.span;
        return Node {
            kind: Kind::Skew(Box::new(node)),
            span,
        };
    }
    if let Some(symbol) = super::script::symbol_of(&mut node) {
        apply(&mut symbol.style, mark);
        return node;
    }
    // Several letters under one arrow are the name of one vector.
    let letters = tokens.iter().all(|t| matches!(t.kind, Lexeme::Letter(_)));
    if letters && matches!(node.kind, Kind::Product(_)) {
        let mut style = Style::default();
        apply(&mut style, mark);
        let name = super::text::plain(tokens);
        node.kind = Kind::Symbol(Symbol {
            name,
            style,
            ..Symbol::default()
        });
    } else if matches!(mark, Mark::Hat | Mark::Tilde)
        && matches!(node.kind, Kind::Product(_) | Kind::Sum(_))
    {
        // Over a product or a sum it makes the matrix of a cross product.
        let span = node.span;
        node = Node {
            kind: Kind::Skew(Box::new(node)),
            span,
        };
    } else if mark == Mark::Bold && matches!(node.kind, Kind::Sum(_)) {
        mark_each(&mut node, mark);
    }
    node
}

/// `\mathbf{a-b}`: the letters of a sum one by one.
fn mark_each(node: &mut Node, mark: Mark) {
    match super::script::symbol_of(node) {
        Some(symbol) => apply(&mut symbol.style, mark),
        None => node
            .children_mut()
            .into_iter()
            .for_each(|child| mark_each(child, mark)),
    }
}

fn apply(style: &mut Style, mark: Mark) {
    match mark {
        Mark::Arrow if style.vector => style.tensor = true,
        Mark::Underline if style.vector => style.tensor = true,
        Mark::Bar if style.bar => style.tensor = true,
        Mark::Arrow | Mark::Bold | Mark::Underline => style.vector = true,
        Mark::Bar => style.bar = true,
        Mark::Hat => style.hat = true,
        Mark::Tilde => style.tilde = true,
        Mark::Calligraphic => style.calligraphic = true,
        Mark::Upright => style.upright = true,
        Mark::Sans | Mark::Board => style.tensor = true,
        Mark::Plain => {}
        Mark::Other => style.other = true,
    }
}

/// Whether the argument of a mark is the sign of a sum.
fn is_sum(tokens: &[Token<'_>]) -> bool {
    let mut kinds = tokens
        .iter()
        .map(|token| token.kind)
        .filter(|kind| !matches!(kind, Lexeme::Space(_)));
    matches!(kinds.next(), Some(Lexeme::Command("Sigma" | "sum"))) && kinds.next().is_none()
}
