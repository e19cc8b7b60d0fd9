//! What words say does not change: "θ, φ̇ and ψ̇ are constant", "turns at the constant rate Ω".

use crate::algebra::Variable;
use crate::notation::ast::{DerivativeStyle, Function, Kind, Node};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::theory::{Premise, Taken};
use crate::verify::values::atoms::{Owner, variable_fraction};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::MAGNITUDE;
use crate::verify::values::value::Value;
use crate::verify::verdict::{FromProse, Role};
use crate::verify::words::book::{has_any, lowered};
use crate::verify::words::role::Words;
use crate::verify::words::running_sentence::keep_end;
use num_traits::Zero;
use std::collections::BTreeSet;

/// Words behind a list of symbols.
const BEHIND: &[&str] = &[
    "is constant",
    "are constant",
    "are all constant",
    "are both constant",
    "remain constant",
    "remains constant",
    "stay constant",
    "stays constant",
    "constant",
    "be constant",
    "both be constant",
    "now be constant",
    "be fixed",
    "held constant",
    "a constant",
    "is a constant",
    "is fixed",
    "are fixed",
    "is held fixed",
    "do not change",
    "does not change",
];
/// Words before a symbol.
const BEFORE: &[&str] = &[
    "constant rate",
    "constant speed",
    "constant angular velocity",
    "constant angular speed",
    "constant spin",
    "constant spin momentum",
    "constant angular momentum",
    "constant momentum",
    "constant wheel momentum",
    "constant rates",
    "constant torque",
    "constant moment",
    "constant couple",
    "constant torques",
    "constant control torque",
    "constant external torque",
    "constant driving torque",
    "with constant",
    "with the constant",
    "for constant",
    "uniform rate",
    "uniform speed",
    "uniform angular velocity",
    "uniform angular speed",
    "uniform spin",
    "steady angular velocity",
    "with uniform",
    "at uniform",
    "with a steady",
    "steady rate",
    "steady speed",
    "constant angle",
    "fixed angle",
    "steadily at",
    "steadily at the rate",
    "steadily with the rate",
    "steadily at a rate",
    "at constant",
    "at a constant",
    "at the constant",
];

/// Of a body that turns about one axis: its speed, without a letter.
const SPEED: &[&str] = &[
    "at constant speed",
    "at a constant speed",
    "at constant angular speed",
    "at constant angular velocity",
    "at constant rotational speed",
    "at steady speed",
    "at uniform speed",
    "for constant speed",
    "with constant speed",
    "once the speed is constant",
    "when the speed is constant",
    "if the speed is constant",
];

/// The name of a premise.
const STEADY: &str = "constant speed";

/// Words of a supposition: what it calls constant may change elsewhere.
const SUPPOSED: &[&str] = &["suppose", "assume", "while", "when", "if"];

fn supposes(sentence: &str) -> bool {
    let sentence = lowered(sentence);
    // What is constant now was not so before.
    if sentence.contains("now let") || sentence.contains("let now") {
        return true;
    }
    let mut words = sentence.split(|c: char| !c.is_alphabetic());
    words.any(|word| SUPPOSED.contains(&word))
}

impl Reading {
    /// Letters of a list that a supposition calls constant move, as far as the rest of the document goes.
    pub(crate) fn supposed_constant(&mut self, before: &str, text: &str, listed: &mut Vec<Letter>) {
        let text = text.trim_start().trim_start_matches(',').trim();
        if matches!(text, "" | "and" | "and the") {
            return;
        }
        let constant = BEHIND.iter().any(|words| text.starts_with(words));
        for letter in listed.drain(..).filter(|_| constant && supposes(before)) {
            self.usage.letters.entry(letter).or_default().moving = true;
        }
    }
}

impl Checker<'_> {
    /// Notes an expression that the words may call constant.
    pub(crate) fn note_expression(&mut self, node: &Node) {
        let mut before = self.sentence.trim_end().to_owned();
        keep_end(&mut before, 200);
        before = before.to_lowercase();
        keep_end(&mut before, 100);
        let uniform = before.ends_with("with the angular velocity")
            && (before.contains("uniformly") || before.contains("steadily"));
        if uniform || BEFORE.iter().any(|words| before.ends_with(words)) {
            // "With constant ⟨Ω⟩": the vector.
            let vector = matches!(&node.kind, Kind::Symbol(symbol) if symbol.style.vector);
            let supposed =
                (vector || !supposes(&self.sentence)) && !Words::of(&self.sentence).derive();
            self.constant_in_words(node, supposed);
        }
        self.turns_near(node);
        self.rate_of_free_motion(node);
        self.is_any_again(node);
        self.small_before(node);
        self.turning_axes(node);
        self.turns_in_plane(node);
        if before.ends_with("vertical is") {
            let value = self.lowering(Frame::Moving).value(node);
            self.vertical = value.ok().filter(Value::is_vector).or(self.vertical.take());
        }
        self.spin_is_about(node);
        self.note_abbreviation(node);
        self.spins_on_axes(node);
        self.named.push(node.clone());
    }

    /// Takes what a piece of prose behind expressions, in small letters, calls constant.
    pub(crate) fn constants_in_words(&mut self, text: &str, span: Span) {
        let text = text.trim_start();
        if self.is_steady(text) {
            self.turns_steadily(text, span);
        }
        self.wheels_turn_steadily(text, span);
        let rest = text.trim_start_matches(',').trim_start();
        let goes_on = rest.is_empty() || rest.starts_with("and ");
        if goes_on && rest.split_whitespace().count() <= 4 && !rest.contains(['.', ';', ':']) {
            return;
        }
        let named = std::mem::take(&mut self.named);
        self.spins_about_numbered_axis(text, &named, span);
        self.zero_components(text, &named, span);
        self.turns_about_one_axis_only(text, span);
        self.vanishing_function(text, &named, span);
        self.small_behind(text, &named);
        let constant = BEHIND.iter().any(|words| rest.starts_with(words));
        // What is "a constant of the motion" is for laws to say.
        let of_motion = has_any(rest, &["constant of", "constants of"]);
        if constant && !of_motion && !Words::of(&self.sentence).derive() {
            let supposed = supposes(&self.sentence);
            named
                .iter()
                .for_each(|node| self.constant_in_words(node, supposed));
        }
    }

    /// Whether words have the body turn steadily: "at constant speed" about one axis, or supposed to have a constant
    /// angular velocity, for which they give no letter.
    fn is_steady(&mut self, text: &str) -> bool {
        let about_axis = has_any(text, SPEED) && self.only_axis_of_turn().is_some();
        let vector = "constant angular velocity";
        let behind = text.find(vector).map(|at| &text[at + vector.len()..]);
        let unnamed = behind.is_some_and(|rest| rest.contains(|c: char| c.is_alphanumeric()));
        let of_body =
            || has_any(text, &["body", "rotor", "it "]) && !has_any(text, &["axes", "frame"]);
        about_axis || unnamed && supposes(text) && of_body()
    }

    /// The axis that all of the angular velocity is about, by words or by earlier lines.
    fn only_axis_of_turn(&mut self) -> Option<u8> {
        let by_words = self.reading.fixed_axis;
        by_words.or(self.reading.plane.then_some(2)).or_else(|| {
            let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
            let parts = self.theory.atoms.vector(omega, 0);
            let parts = parts.each_ref().map(|part| self.theory.normal(part));
            let mut along = (0..3).filter(|&axis| !parts[usize::from(axis)].is_zero());
            along.next().filter(|_| along.next().is_none())
        })
    }

    fn turns_steadily(&mut self, text: &str, span: Span) {
        let axes = match self.only_axis_of_turn() {
            Some(axis) => vec![axis],
            None => vec![0, 1, 2],
        };
        self.stay_in_words(STEADY, Quantity::AngularVelocity, &axes, span);
        // "At constant speed, …": the condition of one case.
        let mut clauses = text.split(['.', ';', ':']).map(str::trim_start);
        if clauses.any(|clause| SPEED.iter().any(|words| clause.starts_with(words))) {
            self.note_assumption(STEADY, Role::Assume);
        }
    }

    /// Ends the condition of a case that is over.
    pub(crate) fn leave_steady_case(&mut self) {
        if self.is_supposed(&STEADY.to_owned()) {
            self.end_premises(&BTreeSet::from([STEADY.to_owned()]));
        }
    }

    /// Takes in that components of a quantity do not change, as the words in a place say.
    pub(crate) fn stay_in_words(
        &mut self,
        name: &str,
        quantity: Quantity,
        axes: &[u8],
        span: Span,
    ) {
        let entity = self.theory.atoms.quantity(quantity);
        let rates = axes.iter();
        let rates = rates.map(|&axis| self.theory.atoms.part(entity, axis, 1));
        let rates: Vec<Variable> = rates.collect();
        let premise = Premise {
            name: name.to_owned(),
            residuals: rates.iter().map(|&rate| variable_fraction(rate)).collect(),
            preferred: rates,
            definition: false,
        };
        self.take_from_words(premise, span);
    }

    /// Takes in what words say to the end of their section, and reports it; whether it is solved for something.
    /// "With the axle horizontal (⟨\cos\theta⟩ vanishes)".
    fn vanishing_function(&mut self, text: &str, named: &[Node], span: Span) {
        let vanishes = ["vanishes", "is zero", "being zero"];
        let Some(node) = named
            .last()
            .filter(|_| vanishes.iter().any(|w| text.starts_with(w)))
        else {
            return;
        };
        if !matches!(
            inner(node).kind,
            Kind::Function(Function::Sin | Function::Cos, _)
        ) {
            return;
        }
        let Some(value) = self.lowering(Frame::Moving).scalar(node) else {
            return;
        };
        self.take_from_words(
            Premise {
                name: "a function of an angle that vanishes by the words".to_owned(),
                preferred: value.variables(),
                residuals: vec![value],
                definition: false,
            },
            span,
        );
    }

    pub(crate) fn take_from_words(&mut self, premise: Premise, span: Span) -> bool {
        let name = premise.name.clone();
        let taken = self.theory.assume(premise);
        let taken = matches!(taken, Taken::Solved | Taken::Kept);
        if taken {
            self.keep(&name, false);
            self.tell(span, name);
        }
        taken
    }

    /// Assumes that the rate of a symbol of the document is zero; what laws determine is for a claim to say. The rate ω
    /// at which a body turns is a number of its own, where the letter is a vector elsewhere.
    fn constant_in_words(&mut self, node: &Node, supposed: bool) {
        let bare = match &node.kind {
            Kind::Symbol(symbol) if !symbol.style.vector => Letter::of(symbol),
            _ => {
                self.stays(node, supposed);
                return;
            }
        };
        // Where the vector has a mark, a letter without one is its length.
        let number = self.reading.quantities.get(&bare) == Some(&Quantity::RelativeMomentum)
            && self.reading.usage.get(&bare).vector > 0;
        if !number && self.stays(node, supposed) {
            return;
        }
        let before = self.reading.scalars.clone();
        self.reading.scalars.insert(bare);
        self.stays(node, supposed);
        self.reading.scalars = before;
    }

    fn stays(&mut self, node: &Node, supposed: bool) -> bool {
        let rate = Node {
            kind: Kind::TimeDerivative {
                operand: Box::new(node.clone()),
                order: 1,
                style: DerivativeStyle::Dots,
                frame: None,
            },
            span: node.span,
        };
        let Ok(value) = self.lowering(Frame::Moving).value(&rate) else {
            return false;
        };
        let parts: Vec<u32> = value
            .entries
            .iter()
            .filter_map(|e| e.as_variable())
            .collect();
        let about_axis = self.reading.fixed_axis.is_some();
        let own = |&v: &u32| match self.theory.atoms.owner(v) {
            Some(Owner::Symbol(_)) => true,
            Some(Owner::Quantity(quantity, variant)) => {
                let rate = matches!(quantity, Quantity::AngularVelocity | Quantity::FrameRate);
                let speed = variant == MAGNITUDE;
                (supposed || speed || about_axis) && rate
                    || matches!(quantity, Quantity::Moment | Quantity::RelativeMomentum)
            }
            None => false,
        };
        if parts.is_empty() || parts.len() != value.entries.len() || !parts.iter().all(own) {
            return false;
        }
        let text = self.document.source.slice(node.span).trim().to_owned();
        let premise = Premise {
            name: format!("{text} is constant"),
            residuals: value.entries,
            preferred: parts,
            definition: false,
        };
        self.take_from_words(premise, node.span)
    }

    /// Reports a premise that words set.
    pub(crate) fn tell(&mut self, span: Span, premise: String) {
        let source_line = self.document.place(span.start).line;
        self.from_prose.push(FromProse {
            span,
            source_line,
            premise,
        });
    }
}
