//! What a line may not be taken for. A claim that the theory has to settle is no definition and is not handed over, no
//! line is proved by itself, and no line is false by one reading of its symbols where another is as near.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, axis, inner, symbols};
use crate::verify::lines::given::{is_in_digits, operands_of_rates};
use crate::verify::lines::line::Read;
use crate::verify::reason;
use crate::verify::theory::Name;
use crate::verify::theory::decide::{passes_filter, reached};
use crate::verify::theory::law::Axes;
use crate::verify::values::atoms::{Atom, Owner};
use crate::verify::values::lower::put_in;
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::symbol::{MAGNITUDE, Meaning};
use crate::verify::values::value::Value;
use crate::verify::verdict::{Finding, Role, Verdict};
use crate::verify::words::book::{has_any, lowered};
use num_traits::Zero;
use std::collections::{BTreeSet, HashMap};

/// Names that kinematics gives to parts of an acceleration or a force.
const NAMED_PARTS: &[&str] = &["coriolis", "centripetal", "centrifugal"];

/// Words that say what angles are.
const ANGLES: &[&str] = &["the angle", "angles", "precess", "nutation", "inclin"];

impl Checker<'_> {
    /// Takes a proof back that rests on the line itself, and what the line was taken for.
    pub(crate) fn withhold_own_proof(&mut self, sides: &[Node], finding: &mut Finding) {
        let own = self.line_name(finding);
        let proved = matches!(finding.verdict, Verdict::Proved(_));
        // Behind its first sign a chain goes on from what that says.
        if proved && sides.len() == 2 && finding.uses.contains(&own) {
            self.end_premises(&BTreeSet::from([own]));
            finding.verdict = Verdict::Undecided;
            finding.uses.clear();
            finding.conditions.clear();
            finding.remarks.clear();
            finding.reason = Some(reason::PROVED_BY_ITSELF.to_owned());
        }
    }

    /// What a line would come to as a claim. A trial leaves nothing behind: no slip, no premise, no reading of a dot.
    pub(crate) fn verdict_as_claim(&mut self, sides: &[Node], finding: &Finding) -> Verdict {
        let own = self.line_name(finding);
        let stood = self.theory.premises().iter().any(|p| p.name == own);
        let (slips, known) = (self.slips.len(), self.known.clone());
        let dots = self.dots_of_lines.clone();
        let mut tried = finding.clone();
        self.claim(sides, &mut tried);
        self.slips.truncate(slips);
        self.known = known;
        self.dots_of_lines = dots;
        if !stood {
            self.end_premises(&BTreeSet::from([own]));
        }
        tried.verdict
    }

    /// Why a claim of something free is for the laws to settle all the same.
    pub(crate) fn is_for_the_laws(&mut self, sides: &[Node], read: &Read) -> Option<&'static str> {
        if self.turns_by_angles(read) {
            return Some("how the angular velocity follows from the angles is not known here");
        }
        if self.is_no_moment_of_its_shape(read) {
            return Some("no shape that the words name has such a moment of inertia");
        }
        if self.is_another_moment(read) {
            return Some("this sum over the masses is another moment of inertia");
        }
        self.has_another_rate(sides, read)
            .then_some("its rate is not the one that follows from the lines before")
    }

    pub(crate) fn belongs_to(&self, variable: Variable, quantity: Quantity) -> bool {
        let owner = self.theory.atoms.owner(variable);
        matches!(owner, Some(Owner::Quantity(found, _)) if *found == quantity)
    }

    /// Whether components of ω are given by the rates of angles that words tell of and by their sines and cosines, or by
    /// such a rate behind lines that were left open.
    fn turns_by_angles(&self, read: &Read) -> bool {
        let atoms = &self.theory.atoms;
        let rate = |v: Variable| {
            let own = matches!(atoms.owner(v), Some(Owner::Symbol(_)));
            own && matches!(atoms.atom(v), Atom::Part { order: 1.., .. })
        };
        let function = |v: Variable| matches!(atoms.atom(v), Atom::Kernel { .. });
        let doubts = self.has_doubts();
        let turns = |entries: &[Fraction]| {
            let all: Vec<Variable> = entries.iter().flat_map(Fraction::variables).collect();
            all.iter().any(|&v| rate(v)) && (doubts || all.iter().any(|&v| function(v)))
        };
        let omega = |entry: &Fraction| {
            let lone = entry.as_variable();
            lone.is_some_and(|v| self.belongs_to(v, Quantity::AngularVelocity))
        };
        let mut equations = read.equations.iter();
        self.text.says(ANGLES)
            && equations.any(|e| e.left.entries.iter().any(omega) && turns(&e.right.entries))
    }

    /// Whether a moment of inertia is given by what the laws know as another one.
    fn is_another_moment(&mut self, read: &Read) -> bool {
        let moment = |checker: &Self, v: Variable| checker.belongs_to(v, Quantity::Inertia);
        read.equations.iter().any(|equation| {
            let pair = equation.left.as_scalar().zip(equation.right.as_scalar());
            let Some((left, right)) = pair else {
                return false;
            };
            let written = right.variables();
            let lone = left.as_variable().is_some_and(|v| moment(self, v));
            lone && right.as_variable().is_none() && {
                let known = self.theory.normal(right).variables();
                known
                    .into_iter()
                    .any(|v| moment(self, v) && !written.contains(&v))
            }
        })
    }

    /// Whether a side that is given as a function of time has another rate than the lines before say.
    fn has_another_rate(&mut self, sides: &[Node], read: &Read) -> bool {
        if !self.speaks_of_time(&sides[1..]) {
            return false;
        }
        read.equations.iter().any(|equation| {
            if equation
                .left
                .as_scalar()
                .and_then(Fraction::as_variable)
                .is_none()
            {
                return false;
            }
            let slope = |checker: &mut Self, side: &Value| -> Fraction {
                let side = side.as_scalar().cloned().unwrap_or_else(Fraction::zero);
                checker.theory.atoms.derivative(&side)
            };
            let rate = slope(self, &equation.left);
            let grows = slope(self, &equation.right);
            let grows = self.theory.normal(&grows).variables();
            let tied = rate.as_variable().is_some_and(|rate| grows.contains(&rate));
            if self.theory.normal(&rate) == rate && !tied {
                return false;
            }
            let entries = equation.residual.entries.iter();
            let rates = entries.map(|entry| self.theory.atoms.derivative(entry));
            let rates = Value {
                entries: rates.collect(),
                ..equation.residual.clone()
            };
            passes_filter(&mut self.theory, &rates) == Some(false)
        })
    }

    /// Why a new symbol gets no meaning by a line: the words before call it by the name of what theory determines.
    pub(crate) fn is_named_by_theory(&mut self, right: &Node, role: Role) -> Option<&'static str> {
        if !matches!(role, Role::Claim | Role::Define) || self.firm {
            return None;
        }
        let said = lowered(&self.sentence);
        // A paragraph between the words and the display ends no sentence.
        let said = said.trim_end_matches([' ', '\n', '.', ':']);
        let clause = said.rsplit(['⟩', '.', ';']).next().unwrap_or_default();
        if has_any(clause, NAMED_PARTS) {
            return Some(
                "the words name a part of the motion, and whether it is this is not decided",
            );
        }
        let potential = clause.contains("potential energy");
        if potential && self.misses_the_height(right) {
            return Some("it is not the weight times the height of the mass centre");
        }
        let derived = role == Role::Claim && self.asserted && clause.contains("energy");
        derived.then_some("the words derive an energy, and whether it is this is not decided")
    }

    /// Whether a new symbol has the letter of a number and is a vector, or that of one component and the index of an axis.
    pub(crate) fn has_letter_of_another_kind(
        &self,
        left: &Node,
        value: &Value,
        role: Role,
    ) -> bool {
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return false;
        };
        let letter = Letter::of(symbol);
        let quantity = self.reading.quantities.get(&letter);
        let number = quantity.is_some_and(|q| q.shape() == Shape::Scalar);
        let part = self.reading.components.contains_key(&letter);
        let indexed = symbol.subscripts.iter().any(|s| axis(s).is_some());
        number && !symbol.style.vector && value.as_scalar().is_none()
            || role == Role::Claim && part && indexed
    }

    /// Whether a dot is read here in another way than a line before had to have it, where both readings are open and only
    /// one of them makes the line hold.
    pub(crate) fn reads_dots_anew(&mut self, both: &[Read], frame: Frame, sides: &[Node]) -> bool {
        let Some(other) = both.iter().find(|read| read.unlabelled != frame) else {
            return false;
        };
        let mut equations = other.equations.iter();
        if equations.all(|e| passes_filter(&mut self.theory, &e.residual) == Some(true)) {
            return false;
        }
        let mut dotted = vec![];
        sides
            .iter()
            .for_each(|side| operands_of_rates(side, &mut dotted));
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let mut entities = self.entities(dotted);
        entities.retain(|&entity| {
            entity != omega && self.theory.atoms.info(entity).shape == Shape::Vector
        });
        let before = |entity| self.dots_of_lines.get(entity);
        if entities.iter().filter_map(before).any(|f| *f != frame) {
            return true;
        }
        self.dots_of_lines
            .extend(entities.into_iter().map(|entity| (entity, frame)));
        false
    }

    /// Why a line that fails may hold in another reading of its symbols, which is as near.
    pub(crate) fn rests_on_a_reading(&mut self, sides: &[Node], read: &Read) -> Option<String> {
        let written: Vec<Variable> = read.residuals().flat_map(Fraction::variables).collect();
        if self.has_two_turns(&written, read) {
            return Some("nothing before says how the body turns on the axes".to_owned());
        }
        if self.stands_on_one_of_two_triads(sides) {
            return Some("nothing before says which of the two triads does not turn".to_owned());
        }
        if self.holds_along_an_axis(&written, read) {
            return Some(
                "it holds for a component along an axis, and not for the length".to_owned(),
            );
        }
        let name = self.value_of_an_instant(&written, sides, read)?;
        Some(format!("the value of {name} may hold at one instant alone"))
    }

    /// Whether the rate of the axes stands beside the angular velocity of the body, and lines do not tie them along each
    /// axis.
    fn has_two_turns(&mut self, written: &[Variable], read: &Read) -> bool {
        let turns = [Quantity::FrameRate, Quantity::AngularVelocity];
        let beside = turns.map(|quantity| written.iter().any(|&v| self.belongs_to(v, quantity)));
        let turning = self.theory.setting.axes == Axes::Turning;
        if !turning || beside != [true; 2] || !self.is_symmetric() {
            return false;
        }
        let turns = turns.map(|quantity| self.theory.atoms.quantity(quantity));
        let rests: Vec<Fraction> = read.residuals().map(|r| self.theory.normal(r)).collect();
        let left = rests.iter().flat_map(Fraction::variables);
        let met: BTreeSet<Variable> = left.chain(written.iter().copied()).collect();
        let axes = met
            .iter()
            .filter_map(|&v| match *self.theory.atoms.atom(v) {
                Atom::Part {
                    entity, component, ..
                } => turns.contains(&entity).then_some(component),
                _ => None,
            });
        axes.collect::<BTreeSet<u8>>().into_iter().any(|axis| {
            let parts = turns.map(|turn| self.theory.atoms.value(turn, axis, 0));
            parts
                .into_iter()
                .all(|part| self.theory.normal(&part) == part)
        })
    }

    /// Whether two moments of inertia are equal: such a body may spin on its axes.
    fn is_symmetric(&mut self) -> bool {
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        let moments = [0, 1, 2].map(|c| self.theory.atoms.value(inertia, c, 0));
        (0..3).any(|i| {
            let apart = moments[i].clone() - moments[(i + 1) % 3].clone();
            self.theory.normal(&apart).is_zero()
        })
    }

    /// Whether a vector is differentiated in a number: the letter may well be that of a Lagrangian.
    pub(crate) fn differentiates_a_vector(&mut self, node: &Node) -> bool {
        let here = match &node.kind {
            Kind::Derivative {
                operand,
                variables,
                partial: true,
            } => {
                let vector = match &inner(operand).kind {
                    Kind::Symbol(symbol) if !symbol.style.vector => self.meaning_of(symbol),
                    _ => Meaning::Pi,
                };
                matches!(vector, Meaning::Whole(entity)
                    if self.theory.atoms.info(entity).shape == Shape::Vector)
                    && self.are_own_numbers(variables)
            }
            _ => false,
        };
        here || node
            .children()
            .any(|child| self.differentiates_a_vector(child))
    }

    /// Whether nodes have numbers of the document in them and nothing else.
    fn are_own_numbers(&mut self, nodes: &[Node]) -> bool {
        self.entities(nodes).into_iter().all(|entity| {
            let info = self.theory.atoms.info(entity);
            info.shape == Shape::Scalar && matches!(info.owner, Owner::Symbol(_))
        })
    }

    /// Whether the line has unit vectors that the document writes with a prime too.
    fn stands_on_one_of_two_triads(&mut self, sides: &[Node]) -> bool {
        let axes: Vec<Letter> = sides
            .iter()
            .flat_map(symbols)
            .filter(|symbol| {
                symbol.primes == 0 && matches!(self.meaning_of(symbol), Meaning::UnitVector(_))
            })
            .map(Letter::of)
            .collect();
        axes.iter()
            .any(|letter| self.reading.usage.primed.contains(letter))
    }

    /// Whether a line holds where the length of a vector in it is the component along one of the axes.
    fn holds_along_an_axis(&mut self, written: &[Variable], read: &Read) -> bool {
        let length = |v: &Variable| match self.theory.atoms.owner(*v) {
            Some(Owner::Quantity(quantity, variant)) if variant == MAGNITUDE => {
                Some((*v, *quantity))
            }
            _ => None,
        };
        let Some((length, quantity)) = written.iter().find_map(length) else {
            return false;
        };
        (0..3).any(|component| {
            let entity = self.theory.atoms.quantity(quantity);
            let part = self.theory.atoms.value(entity, component, 0);
            let image = HashMap::from([(length, part)]);
            read.equations.iter().all(|equation| {
                let entries = equation.residual.entries.iter();
                let residual = Value {
                    entries: entries.map(|entry| put_in(entry, &image)).collect(),
                    ..equation.residual.clone()
                };
                passes_filter(&mut self.theory, &residual) == Some(true)
            })
        })
    }

    /// The line that gives a symbol a number by which a line fails that goes on in time.
    fn value_of_an_instant(
        &mut self,
        written: &[Variable],
        sides: &[Node],
        read: &Read,
    ) -> Option<Name> {
        let atoms = &self.theory.atoms;
        let rate = |&v: &Variable| matches!(atoms.atom(v), Atom::Part { order: 1.., .. });
        let moves = written.iter().any(rate) || self.speaks_of_time(sides);
        if !moves || sides.iter().any(is_in_digits) {
            return None;
        }
        let entries: Vec<Fraction> = read.residuals().cloned().collect();
        let met = reached(&mut self.theory, &entries);
        let atoms = &self.theory.atoms;
        let own = |v: &Variable| matches!(atoms.owner(*v), Some(Owner::Symbol(_)));
        let instants = &self.theory.instants;
        let mut premises = self.theory.premises().iter();
        let found = premises.find(|premise| {
            let momentary = instants.contains_key(&premise.name);
            momentary && met.contains(&premise.name) && premise.preferred.iter().any(own)
        });
        found.map(|premise| premise.name.clone())
    }
}
