//! What a sentence says, before anything is known of the things that it names.
//!
//! A statement is a clause with its parts in slots. It names things (frames, points, bodies) as the author does and
//! symbols as they are written; `reading` looks both up and builds the model.

use crate::notation::document::Row;
use std::fmt;

/// A declaration: what it says, for which part of the document, and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Declaration {
    /// What it says.
    pub statement: Statement,
    /// For which part of the document; several in one sentence narrow each other.
    pub extent: Extent,
    /// The sentence as written.
    pub text: String,
    /// The line on which it stands in what declares it, from 1.
    pub line: usize,
}

/// The part of a document that a sentence speaks of.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub enum Extent {
    /// All of it.
    #[default]
    Document,
    /// Lines of the file, or of a cell of a notebook; `last` is `None` for "from line 38 on".
    Lines {
        /// The cell, from 0.
        cell: Option<usize>,
        /// The first line, from 1.
        first: usize,
        /// The last line.
        last: Option<usize>,
    },
    /// Cells of a notebook, from 0.
    Cells(Vec<usize>),
    /// Under the heading with these words.
    Section(String),
    /// From the line with one label to the line with the other.
    Between(String, String),
    /// The n-th time, from 1, that a formula stands on a line.
    Occurrence {
        /// Which one, from 1.
        number: usize,
        /// The formula as written.
        formula: String,
        /// The cell, from 0.
        cell: Option<usize>,
        /// The line.
        line: usize,
    },
    /// Both at once.
    Both(Box<Extent>, Box<Extent>),
}

impl Extent {
    /// The heading under which a sentence holds, if it names one.
    pub(crate) fn section(&self) -> Option<&str> {
        match self {
            Self::Section(title) => Some(title),
            Self::Both(one, other) => one.section().or_else(|| other.section()),
            _ => None,
        }
    }
}

/// A formula inside a sentence.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// As written, without its dollar signs.
    pub source: String,
    /// As read.
    pub row: Row,
}

/// What a sentence is about, or what a slot holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Term {
    /// A formula.
    Formula(Formula),
    /// A thing by its name, article and markup taken off: `B`, `hub`, `O'`, `spacecraft`. A name in dollars is a
    /// [`Term::Formula`]; which of the two an author takes makes no difference to `reading`.
    Name(String),
    /// A member of a family: "wheel $i$", "particle $a$", "element $\text{d}m$".
    Member {
        /// The family in the singular: `wheel`.
        family: String,
        /// The index.
        index: Formula,
    },
    /// A thing or a quantity by what it is: "the mass centre of the wheel", "the axis through O along $n$".
    Phrase(Box<NounPhrase>),
    /// The number of an axis, an entry or a step: "third", "3", "(2, 3)".
    Numbers(Vec<usize>),
}

/// A noun with what hangs on it.
#[derive(Clone, Debug, PartialEq)]
pub struct NounPhrase {
    /// The entry of the lexicon, by its first form: `angular velocity`.
    pub head: &'static str,
    /// Adjectives by the first form of their entries: `inertial`, `uniform`, `thin`, `constant`, `total`.
    pub adjectives: Vec<&'static str>,
    /// Slots in the order in which they were said; one slot may be there twice ("fixed in N and in B").
    pub slots: Vec<(Slot, Term)>,
}

/// How something hangs on a noun or a verb.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Slot {
    /// "of the body", "on the body" behind force and moment, "of mass $m$" (then the term is a phrase).
    Of,
    /// "about O", "about the axis through O along $n$", "symmetric about $g$".
    About,
    /// "relative to N", "from O" behind a position.
    RelativeTo,
    /// "seen from N".
    SeenFrom,
    /// "along $n$", "along z".
    Along,
    /// "on B", "in components on B", "has components on B".
    On,
    /// "fixed in N", "at rest relative to N".
    FixedIn,
    /// "with velocities relative to O".
    VelocitiesRelativeTo,
    /// "by the angle $\theta$", "by `$R$`", "by $r$".
    By,
    /// "at the rate $\Omega$", "at P", "at the distance $a$"; "at $t = 0$" and "when $t = 0$" on any noun or verb: what is
    /// said is said for then alone.
    At,
    /// "through O".
    Through,
    /// "from components on B", "from O to G": the beginning.
    From,
    /// "to components on N", "from O to G": the end.
    To,
    /// "in the order z, y, x": one slot for each.
    InOrder,
    /// "between n and z": one slot for each.
    Between,
    /// "in $\omega$": the variable of a Jacobian, "to first order in $p$".
    In,
    /// "to second order in $p$".
    InSecondOrder,
    /// "above O", "with their middles at G" and the like: what else a verb or noun takes. An adverb is a phrase by its
    /// first form, with its object as `Of`: "below O", "after the impact", "per unit length".
    With,
    /// "component $j$", "entry (2, 3)", "the third axis": which one.
    Which,
    /// "any $v$", "for any frames X and Y": letters that stand for anything.
    ForAny,
    /// "on wheel $i$" where a load also says whose it is: "the moment of the hub on wheel $i$".
    Upon,
}

/// What a sentence says.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// "N is an inertial frame", "$L$ is the angular momentum of …", "P, Q, R are the components of … on B",
    /// "$s$ and $z$ are constant" (head `constant`). `respectively` for one noun of several subjects is the rule.
    Is {
        /// What it is about.
        subjects: Vec<Term>,
        /// What it is said to be.
        what: NounPhrase,
    },
    /// "A is the same as B", "`$a$`, `$b$` are also written `$c$`, `$d$`", "`$p$` is `$m v$`": pairs.
    Same {
        /// New writings.
        subjects: Vec<Term>,
        /// What they stand for.
        others: Vec<Term>,
    },
    /// A verb of motion or place with its slots: "B turns relative to N about z by the angle $\theta$", "G lies at the
    /// distance $a$ from O along z", "P is placed from O by $r$", "the disc rolls on the floor at C without slipping",
    /// "$R$ takes components on B to components on N", "the spacecraft consists of the hub and the wheels", "`$i$` numbers
    /// the wheels", "the axis of the disc passes through O", "the force $F$ acts at P". "`$u = v$` at `$t = 0$`" is `hold`
    /// with the formula as its subject; "does not turn" is `keep its direction`, "does not slip" is `grip`.
    Does {
        /// What it is about.
        subjects: Vec<Term>,
        /// The entry of the lexicon, by its first form: `turn`, `lie`, `roll`, `take`, `consist`, `number`, `act`, `pass`.
        verb: &'static str,
        /// What hangs on the verb. Parts of "consists of", the counted of "numbers" are `Of`.
        slots: Vec<(Slot, Term)>,
    },
    /// A bare formula that holds: "$\omega = \omega n$".
    Holds(Formula),
    /// "Line 15 holds at $t = 0$", "line 15 holds to first order in $p$": what is said of lines, with slots.
    LineHolds {
        /// Which lines; an empty extent is none.
        lines: Extent,
        /// `At`, `In` (first order in), or an extent's words.
        slots: Vec<(Slot, Term)>,
    },
    /// "$\theta$ lies between $0$ and $\pi/2$": bounds, as formulas.
    Bounds {
        /// What is bounded.
        subject: Formula,
        /// From.
        lower: Formula,
        /// To.
        upper: Formula,
    },
    /// "`$I\omega^2$` means `$\omega\cdot(I\omega)$`".
    Means {
        /// What is written.
        written: Formula,
        /// What it stands for.
        meaning: Formula,
    },
    /// A rule for marks, labels and customs of notation.
    Notation {
        /// What carries the meaning.
        sign: Sign,
        /// What it means.
        meaning: NotationMeaning,
    },
    /// "Line 5 is given", "lines 3 to 5 are left out", "line 168 defines `$\Phi$`".
    Role {
        /// Which lines.
        lines: Extent,
        /// What they are.
        role: DeclaredRole,
    },
    /// "The axes of B are principal axes of the body", "no moment acts on the body about G", "the weight and the force at
    /// O are the only loads on the top", "the potential energy is zero at O", "the mass centre of wheel $i$ is fixed in B",
    /// "space has four dimensions": a premise by its head, with slots as in a phrase.
    Premise(NounPhrase),
    /// A sentence that was not understood.
    Unread {
        /// The letters that it says something of, where it says no more than what these are; else none.
        letters: Vec<Formula>,
        /// What it may change the meaning of.
        touched: Touched,
    },
}

/// What a sentence that was not understood may change the meaning of.
#[derive(Clone, Debug, PartialEq)]
pub enum Touched {
    /// The letters of its formulas.
    Letters {
        /// The formulas.
        formulas: Vec<Formula>,
        /// Whether they may mean something else than other sentences tell: for any labels, or in a part of the document.
        anew: bool,
    },
    /// Letters as they are written, whatever other sentences tell of them.
    Written(Vec<Formula>),
    /// What carries one of these signs.
    Signs(Vec<Sign>),
    /// What carries one of these words.
    Words(Vec<String>),
    /// What carries a sign that is written in one of these ways, by a rule for it.
    WrittenSigns(Vec<String>),
    /// It may be a rule for all that is written.
    Everything,
}

/// What carries a meaning by a rule.
#[derive(Clone, Debug, PartialEq)]
pub enum Sign {
    /// `dot`, `tilde`, `hat`, `wide hat`, `bar`, `prime`, `no mark`, `no label`, `underline`.
    Mark(&'static str),
    /// "the label `$abs$`", "the labels 1, 2, 3", with "on a rate" or "on brackets" where it says so.
    Label {
        /// The labels as written, dollars taken off.
        labels: Vec<String>,
        /// Whether it stands on rates or brackets alone.
        on_whole: bool,
    },
    /// "braces", "a frame at the upper left", "a full stop between vectors", "a repeated index", "repeated cross products".
    Custom(&'static str),
    /// An operator as written: "`$d/dt$`", "`$\partial_t$`", "`$\mathbf\omega\times$`", "`a x b`".
    Operator(Formula),
}

/// What a mark, a label or an operator means.
#[derive(Clone, Debug, PartialEq)]
pub enum NotationMeaning {
    /// A noun of the lexicon: "the cross-product matrix", "the rate seen from B", "components on N", "the dot product".
    Noun(NounPhrase),
    /// One of the fixed meanings: `itself`, `the same`, `summed`, `from the right`, `entry by entry`, `that frame`,
    /// `row by row`.
    Fixed(&'static str),
    /// "takes functions of `$\psi, \theta$`".
    FunctionsOf(Vec<Formula>),
}

/// A role that an author declares.
#[derive(Clone, Debug, PartialEq)]
pub enum DeclaredRole {
    /// "is given".
    Given,
    /// "is assumed".
    Assume,
    /// "is a claim".
    Claim,
    /// "is a definition", "defines `$X$`".
    Define(Option<Formula>),
    /// "is left out".
    LeftOut,
    /// "starts from `$X$`": the side that is missing before its first sign of relation.
    StartsFrom(Formula),
    /// "continues line 5": the side that is missing is the first of the chain that stands there.
    GoesOnFrom(Extent),
}

/// Why a sentence is not understood.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Misread {
    /// The line on which the sentence stands, from 1.
    pub line: usize,
    /// The column of the first character that is not understood, from 1.
    pub column: usize,
    /// What is wrong, as one clause.
    pub message: String,
    /// What could stand there instead.
    pub help: Option<String>,
}

impl fmt::Display for Misread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "line {}, column {}: {}",
            self.line, self.column, self.message
        )?;
        match &self.help {
            Some(help) => write!(f, "; {help}"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for Misread {}

impl Statement {
    /// "The frame B is fixed in the body": it is a frame that is.
    pub(crate) fn is_of(&mut self, kind: Option<&'static str>) {
        let (Self::Is { what, .. }, Some(kind)) = (self, kind) else {
            return;
        };
        match what.head {
            "fixed" => what.head = kind,
            described @ ("inertial" | "body-fixed") => {
                what.head = kind;
                what.adjectives.push(described);
            }
            _ => {}
        }
    }

    /// Whether it is more than a formula that relates nothing.
    pub(crate) fn says_something(&self) -> bool {
        !matches!(self, Self::Holds(formula) if matches!(formula.row, Row::Expression(_)))
    }

    /// What a letter or a thing is said to be.
    pub(crate) fn noun_phrase(&self) -> Option<NounPhrase> {
        match self {
            Self::Is { what, .. } => Some(what.clone()),
            _ => None,
        }
    }
}

impl NounPhrase {
    /// A noun with what hangs on it.
    pub(crate) fn new(head: &'static str, slots: Vec<(Slot, Term)>) -> Self {
        Self {
            head,
            adjectives: vec![],
            slots,
        }
    }

    /// The first term in a slot.
    pub fn slot(&self, wanted: Slot) -> Option<&Term> {
        slot(&self.slots, wanted)
    }

    /// The terms in a slot, in order.
    pub fn all(&self, slot: Slot) -> impl Iterator<Item = &Term> {
        let terms = self.slots.iter().filter(move |(s, _)| *s == slot);
        terms.map(|(_, term)| term)
    }

    /// Whether it has an adjective.
    pub fn is(&self, adjective: &str) -> bool {
        self.adjectives.contains(&adjective)
    }
}

/// The first term that hangs on a verb or a noun so.
pub(crate) fn slot(slots: &[(Slot, Term)], wanted: Slot) -> Option<&Term> {
    slots
        .iter()
        .find(|(slot, _)| *slot == wanted)
        .map(|(_, term)| term)
}
