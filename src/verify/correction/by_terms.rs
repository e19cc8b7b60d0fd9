//! Whether a changed line may hold, told from the one term that is changed, and mostly from one factor of it.
//!
//! Sides are sums: what is left of their difference is what each term adds to it. With one term changed all others add the
//! same. And where a term is a product of numbers, the line holds if the changed factor grows as the term would have to:
//! then that factor alone is worked out anew.

use crate::algebra::Fraction;
use crate::notation::ast::{DerivativeStyle, Factor, Kind, Line, Node, Number, Operator, Symbol};
use crate::source::Span;
use crate::verify::correction::pairs::are_same;
use crate::verify::correction::slips::Change;
use crate::verify::standing::judge::{Judge, Judged};
use crate::verify::standing::trial::Tried;
use foldhash::HashMap;
use num_rational::BigRational;
use num_traits::{One, Zero};
use std::borrow::Cow;
use std::cell::RefCell;
use std::rc::Rc;

/// The forms of letters.
const PLAIN: usize = 0;
const DOTTED: usize = 1;
const SQUARED: usize = 2;

/// A term of a side, and what it adds to the difference of the sides.
struct Term<'l> {
    node: &'l Node,
    negative: bool,
    adds: Fraction,
    /// What it would have to add for the line to hold, the others being as they are.
    wanted: Fraction,
    /// The factors whose product it is; none where they are not all numbers.
    factors: Vec<Factored<'l>>,
}

/// A factor of a term, and what it is worth.
type Factored<'l> = (&'l Node, Fraction);

impl Term<'_> {
    /// The factor that has some bytes, and what it is worth.
    fn factor(&self, place: Span) -> Option<(&Node, &Fraction)> {
        let mut factors = self.factors.iter();
        let (node, value) = factors.find(|(node, _)| holds(node.span, place))?;
        (!value.is_zero()).then_some((node, value))
    }
}

/// The terms of a false line.
pub(super) struct Terms<'l> {
    terms: Vec<Term<'l>>,
    sides: [(Span, Fraction); 2],
    /// What is left of the difference of the sides.
    left_over: Fraction,
    letters: Rc<Letters>,
}

/// What letters come to that were put in so far: as they are, with a dot, squared.
#[derive(Debug, Default)]
pub(super) struct Letters([RefCell<HashMap<Symbol, Tried>>; 3]);

impl Letters {
    /// What a letter comes to in one of these forms, as it is known of this document, of another one, or is found.
    fn value<'n>(
        &self,
        judge: &mut Judge<'_>,
        (symbol, form): (&Symbol, usize),
        node: impl FnOnce() -> Option<Cow<'n, Node>>,
    ) -> Option<Tried> {
        if let Some(known) = self.0[form].borrow().get(symbol) {
            return Some(known.clone());
        }
        let found = match judge.number_of_letter(symbol, form) {
            Some(number) => Tried::Number(number),
            None => {
                let node = node()?;
                judge.tried_letter((symbol, form), &node)
            }
        };
        let mut letters = self.0[form].borrow_mut();
        letters.insert(symbol.clone(), found.clone());
        Some(found)
    }
}

impl<'l> Terms<'l> {
    /// Those of a line of two sides that are numbers; `None` where they do not add up to what is left of it.
    pub(super) fn of(
        judge: &mut Judge<'_>,
        line: &'l Line,
        judged: &Judged,
        letters: &Rc<Letters>,
    ) -> Option<Self> {
        let [left, right] = line.sides.as_slice() else {
            return None;
        };
        let left_over = judge.left_over(line, &judged.sides)?;
        let mut found = Self {
            terms: vec![],
            sides: [left, right].map(|side| (side.span, Fraction::zero())),
            left_over,
            letters: letters.clone(),
        };
        let mut all = Fraction::zero();
        for (at, side) in [left, right].into_iter().enumerate() {
            for (node, negative) in terms(side) {
                let negative = negative != (at == 1);
                let (value, factors) = match factors(judge, node, letters) {
                    Some(found) => found,
                    None => (judge.term(node)?, vec![]),
                };
                let adds = signed(value, negative);
                all += adds.clone();
                let whole = &mut found.sides[at].1;
                *whole = whole.clone() + adds.clone();
                found.terms.push(Term {
                    node,
                    negative,
                    wanted: adds.clone() - found.left_over.clone(),
                    adds,
                    factors,
                });
            }
        }
        (all == found.left_over).then_some(found)
    }

    /// Whether the line may hold with a change at some bytes of it; `None` where its terms don't tell.
    pub(super) fn may_hold(
        &self,
        judge: &mut Judge<'_>,
        place: Span,
        change: &Change,
    ) -> Option<bool> {
        let place = match change {
            Change::Times(of, [over, under]) => {
                if let Some(adds) = self.whole(*of) {
                    let more = adds.clone() * Fraction::from_ratio(over - under, *under);
                    return Some((self.left_over.clone() + more).is_zero());
                }
                *of
            }
            _ => place,
        };
        let term = self.terms.iter().find(|t| holds(t.node.span, place))?;
        match change {
            Change::Nothing(nodes) => {
                let numbers = nodes.iter().all(|&span| {
                    let node = find(term.node, span);
                    node.is_some_and(|node| judge.term(node).is_some())
                });
                numbers.then(|| self.left_over.is_zero())
            }
            _ => self.may_hold_with(judge, term, place, change),
        }
    }

    /// The same for a change in a term.
    fn may_hold_with(
        &self,
        judge: &mut Judge<'_>,
        term: &Term<'_>,
        place: Span,
        change: &Change,
    ) -> Option<bool> {
        if let Some((node, value)) = term.factor(place) {
            let new = match self.changed(judge, node, place, change)? {
                // With a dot over what never changes a term is gone, and no dot was lost.
                Tried::Number(new) if new.is_zero() && *change == Change::Dotted => {
                    return (node.span == place).then_some(false);
                }
                Tried::Number(new) => new,
                // The line would say what a letter is, or set a number beside a vector.
                Tried::New => return Some(false),
                Tried::NoNumber if self.has_others(term) => return Some(false),
                Tried::NoNumber | Tried::Open => return None,
            };
            return are_same(judge, [&term.adds, &new], [&term.wanted, value]);
        }
        let mut node = term.node.clone();
        put(&mut node, place, change)?;
        let adds = signed(judge.term(&node)?, term.negative);
        Some((adds - term.wanted.clone()).is_zero())
    }

    /// What a factor comes to with a change; `None` where that is not told by its tree.
    fn changed(
        &self,
        judge: &mut Judge<'_>,
        node: &Node,
        place: Span,
        change: &Change,
    ) -> Option<Tried> {
        let lone = match (change, &node.kind) {
            (Change::Symbol(symbol), Kind::Symbol(_)) => Some((symbol, PLAIN)),
            (Change::Dotted, Kind::Symbol(own)) => Some((own, DOTTED)),
            (Change::Squared, Kind::Symbol(own)) => Some((own, SQUARED)),
            _ => None,
        };
        let changed = || {
            let mut changed = node.clone();
            put(&mut changed, place, change)?;
            Some(changed)
        };
        match lone {
            Some(letter) => {
                let node = || changed().map(Cow::Owned);
                self.letters.value(judge, letter, node)
            }
            None => Some(judge.tried(&changed()?)),
        }
    }

    /// Whether a number stands beside a term, on its side or on the other one.
    fn has_others(&self, term: &Term<'_>) -> bool {
        let mut terms = self.terms.iter();
        terms.any(|other| other.node.span != term.node.span && !other.adds.is_zero())
    }

    /// What a term or a side adds, by its bytes.
    fn whole(&self, of: Span) -> Option<&Fraction> {
        let terms = self.terms.iter().map(|term| (term.node.span, &term.adds));
        let sides = self.sides.iter().map(|(span, adds)| (*span, adds));
        let mut all = terms.chain(sides);
        all.find(|(span, _)| *span == of).map(|(_, adds)| adds)
    }
}

/// The terms of a side, and whether each is taken away.
fn terms(side: &Node) -> Vec<(&Node, bool)> {
    match &side.kind {
        Kind::Sum(terms) => terms.iter().map(|t| (&t.node, t.negative)).collect(),
        _ => vec![(side, false)],
    }
}

/// What a term is worth, and the factors whose product it is; `None` where they are not all numbers.
fn factors<'l>(
    judge: &mut Judge<'_>,
    term: &'l Node,
    letters: &Letters,
) -> Option<(Fraction, Vec<Factored<'l>>)> {
    // Letters side by side may mean something as a whole, and another one beside them something else.
    if judge.reading.letters.has_phrases() {
        return None;
    }
    let (mut nodes, mut negative) = (vec![], false);
    collect(term, &mut nodes, &mut negative);
    let (mut factors, mut product) = (vec![], Fraction::one());
    for node in nodes {
        let known =
            letter(node).map(|letter| letters.value(judge, letter, || Some(Cow::Borrowed(node))));
        let own = match known {
            Some(Some(Tried::Number(own))) => own,
            Some(_) => return None,
            None => judge.term(node)?,
        };
        product *= own.clone();
        factors.push((node, own));
    }
    Some((judge.normal(&signed(product, negative))?, factors))
}

/// The letter that a node is, and whether with a dot.
fn letter(node: &Node) -> Option<(&Symbol, usize)> {
    match &node.kind {
        Kind::Symbol(symbol) => Some((symbol, PLAIN)),
        Kind::TimeDerivative {
            operand,
            order: 1,
            style: DerivativeStyle::Dots,
            frame: None,
        } => match &operand.kind {
            Kind::Symbol(symbol) if is_plain(symbol) => Some((symbol, DOTTED)),
            _ => None,
        },
        _ => None,
    }
}

/// What is multiplied in a node, and whether a sign stands before it.
fn collect<'l>(node: &'l Node, found: &mut Vec<&'l Node>, negative: &mut bool) {
    let is_plain =
        |factor: &Factor| matches!(factor.operator, Operator::Juxtaposed | Operator::Dot);
    match &node.kind {
        Kind::Product(factors) if factors.iter().all(is_plain) => {
            factors
                .iter()
                .for_each(|factor| collect(&factor.node, found, negative));
        }
        Kind::Negate(inner) => {
            *negative = !*negative;
            collect(inner, found, negative);
        }
        Kind::Group(_, inner) if matches!(inner.kind, Kind::Product(_) | Kind::Negate(_)) => {
            collect(inner, found, negative);
        }
        _ => found.push(node),
    }
}

fn signed(value: Fraction, negative: bool) -> Fraction {
    if negative { -value } else { value }
}

fn holds(whole: Span, part: Span) -> bool {
    whole.start <= part.start && part.end <= whole.end
}

/// The node with these bytes.
fn find(node: &Node, place: Span) -> Option<&Node> {
    match node.span == place {
        true => Some(node),
        false => node
            .children()
            .filter(|child| holds(child.span, place))
            .find_map(|child| find(child, place)),
    }
}

/// Makes a change at some bytes; `None` where they stand in what may be read in another way with it.
fn put(node: &mut Node, place: Span, change: &Change) -> Option<()> {
    if node.span == place && !matches!(node.kind, Kind::Sum(_) | Kind::Group(..)) {
        node.kind = changed(node, change)?;
        return Some(());
    }
    match &mut node.kind {
        Kind::Sum(_) | Kind::Product(_) | Kind::Negate(_) | Kind::Group(..) => {
            let holds = |child: &&mut Node| holds(child.span, place);
            let child = node.children_mut().into_iter().find(holds)?;
            put(child, place, change)
        }
        // A dot is over whatever letter stands under it, and over another dot.
        Kind::TimeDerivative { operand, .. }
            if matches!(change, Change::Symbol(_) | Change::Dotted) =>
        {
            put(operand, place, change)
        }
        _ => None,
    }
}

/// A node, changed.
fn changed(node: &Node, change: &Change) -> Option<Kind> {
    match (change, &node.kind) {
        (Change::Times(_, [-1, 1]), _) => Some(Kind::Negate(Box::new(node.clone()))),
        (Change::Times(_, [over, under]), _) => Some(multiplied(node, *over, *under)),
        (Change::Symbol(other), Kind::Symbol(_)) => Some(Kind::Symbol(other.clone())),
        (Change::Dotted, Kind::Symbol(own)) if is_plain(own) => Some(Kind::TimeDerivative {
            operand: Box::new(node.clone()),
            order: 1,
            style: DerivativeStyle::Dots,
            frame: None,
        }),
        (Change::Squared, Kind::Symbol(own)) if is_plain(own) => {
            let two = Node {
                kind: number(2, 1),
                span: node.span,
            };
            Some(Kind::Power(Box::new(node.clone()), Box::new(two)))
        }
        (
            Change::Bared,
            Kind::Power(inner, _)
            | Kind::TimeDerivative {
                operand: inner,
                order: 1,
                ..
            },
        ) => Some(inner.kind.clone()),
        _ => None,
    }
}

/// A node times a number.
fn multiplied(node: &Node, over: i64, under: i64) -> Kind {
    let factor = |node| Factor {
        operator: Operator::Juxtaposed,
        sign: Span::default(),
        node,
    };
    let number = Node {
        kind: number(over, under),
        span: node.span,
    };
    Kind::Product(vec![factor(number), factor(node.clone())])
}

fn number(over: i64, under: i64) -> Kind {
    Kind::Number(Number {
        value: BigRational::new(over.into(), under.into()),
        decimals: None,
        exponent: 0,
    })
}

/// Whether nothing is drawn on a letter or stands above it.
fn is_plain(symbol: &Symbol) -> bool {
    let alone = symbol.superscripts.is_empty() && symbol.primes == 0 && !symbol.resultant;
    alone && !symbol.variation && symbol.style == Default::default()
}
