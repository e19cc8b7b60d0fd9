//! How long an assumption holds: to the end of its section, or to the next case.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::lines::given::{is_in_digits, is_zero};
use crate::verify::lines::scope::ONWARDS;
use crate::verify::reason;
use crate::verify::theory::law::Axes;
use crate::verify::theory::{Name, Premise};
use crate::verify::values::atoms::Owner;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::verdict::{Finding, Role, Verdict};
use crate::verify::words::book::{has_any, lowered};
use crate::verify::words::prose::{Said, said};
use std::collections::{BTreeMap, BTreeSet};

/// The cases of a section, told apart by paragraphs with a title of their own or by words.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cases {
    /// The number of the case that is looked at.
    now: u32,
    /// In which case each assumption was made.
    kept: BTreeMap<Name, u32>,
    /// In which case a display set the motion up.
    set: BTreeMap<Name, u32>,
    /// Assumptions in displays that are none in so many words.
    shown: BTreeSet<Name>,
    /// Whether the sentence speaks of a case that is not the one at hand.
    pub hypothesis: bool,
    /// How many headings stand before.
    section: u32,
    /// In which section a component got a symbol for its value.
    named: BTreeMap<Name, u32>,
    /// In which section and case the axes, which turn at a rate of their own elsewhere, were attached to the body.
    attached: Option<(u32, u32)>,
    /// Whether a spin was disturbed before, as it may be in each case.
    pub disturbed: bool,
}

/// Words that turn to another case.
const TURNS: &[&str] = &[
    "instead",
    "alternatively",
    "conversely",
    "on the other hand",
    "in the other case",
];

/// How a paragraph begins that is one case of several.
const COUNTED: &[&str] = &[
    "case ", "(a) ", "(b) ", "(c) ", "(d) ", "(i) ", "(ii) ", "(iii) ", "(iv) ",
];

/// The level of the title of a paragraph, which stands in its first line.
const RUN_IN: u8 = 5;

impl Cases {
    /// How many headings stand before, and how many cases of the section.
    pub(crate) fn place(&self) -> (u32, u32) {
        (self.section, self.now)
    }

    /// Whether a premise is an assumption of the case at hand.
    pub(crate) fn is_supposed_now(&self, name: &str) -> bool {
        self.kept.get(name) == Some(&self.now)
    }

    /// Whether a display of the section at hand set the motion up by a premise.
    pub(crate) fn is_set_up(&self, name: &str) -> bool {
        self.set.contains_key(name) || self.shown.contains(name)
    }
}

impl Checker<'_> {
    /// A heading ends the assumptions made under headings of its level and below; the title of a paragraph opens a case.
    pub(crate) fn heading(&mut self, level: u8, text: &str, span: Span) {
        if level >= RUN_IN {
            self.open_case();
        } else {
            self.end_section(level, span);
        }
        self.sentence.clear();
        self.last_side = None;
        for said in said(&lowered(text))
            .into_iter()
            .filter(|s| matches!(s, Said::BodyAxes | Said::SpeaksOfBodyAxes))
        {
            self.take(said, span);
        }
    }

    fn end_section(&mut self, level: u8, span: Span) {
        self.lift_setting(level);
        let inner = self.scopes.iter().filter(|(_, l)| *l >= level);
        let mut ended: BTreeSet<String> = inner.map(|(name, _)| name.clone()).collect();
        ended.retain(|name| !self.outlasts(name, span));
        self.end_premises(&ended);
        self.level = level;
        self.end_small_turns();
        self.end_given_attitude();
        self.end_orders(level);
        if let Some(axes) = &mut self.reading.space_axes {
            axes.left = false;
        }
        let before = std::mem::take(&mut self.cases);
        self.cases.section = before.section + 1;
        self.cases.named = before.named;
        self.cases.attached = before.attached;
        self.cases.disturbed = before.disturbed;
        let lasting = before.set.into_keys().filter(|name| !ended.contains(name));
        self.cases.set = lasting.map(|name| (name, 0)).collect();
        self.cases.shown = before.shown;
        self.sought = None;
    }

    /// Sections before the first claim of a document speak for all that follow under their own heading, "Notation" or
    /// "The body", where they say what the body is like: not what acts on it or how it moves, which a case takes.
    fn lift_setting(&mut self, level: u8) {
        if self.findings.iter().any(|f| f.role == Role::Claim) {
            return;
        }
        let shape = |v: Variable| match self.theory.atoms.owner(v) {
            Some(Owner::Quantity(quantity, _)) => {
                matches!(quantity, Quantity::Inertia | Quantity::RelativeMomentum)
            }
            owner => owner.is_some(),
        };
        let premises = self.theory.premises().iter();
        let lasting = premises.filter(|premise| {
            let mut variables = premise.residuals.iter().flat_map(Fraction::variables);
            variables.all(shape)
        });
        let lasting: BTreeSet<String> = lasting.map(|p| p.name.clone()).collect();
        for (name, scope) in &mut self.scopes {
            if lasting.contains(name) {
                *scope = (*scope).min(level.saturating_sub(1));
            }
        }
    }

    /// Notes in which case an assumption was made, or what a sentence gives in passing.
    pub(crate) fn note_assumption(&mut self, name: &str, role: Role) {
        if has_any(&lowered(&self.sentence), ONWARDS) {
            return;
        }
        if role == Role::Assume || role == Role::Given && !self.displayed {
            self.cases.kept.insert(name.to_owned(), self.cases.now);
            if self.displayed && !self.firm {
                self.cases.shown.insert(name.to_owned());
            }
        } else if role != Role::Claim {
            self.cases.set.insert(name.to_owned(), self.cases.now);
        }
    }

    /// Notes that what an earlier case supposed is supposed in this one too.
    pub(crate) fn suppose_again(&mut self, residuals: &[Fraction]) {
        let premises = self.theory.premises().iter();
        for premise in premises.filter(|p| p.residuals == residuals) {
            if let Some(case) = self.cases.kept.get_mut(&premise.name) {
                *case = self.cases.now;
            }
        }
    }

    /// Ends what an earlier section says of another component by the same symbol: a spin n about axis 3, now about axis 1.
    pub(crate) fn pass_name_on(&mut self, sides: &[Node], name: &str) {
        let section = self.cases.section;
        let ended = self.names_of_siblings(sides).into_iter();
        let earlier = |name: &Name| self.cases.named.get(name).is_some_and(|&s| s < section);
        let ended: BTreeSet<Name> = ended.filter(earlier).collect();
        self.end_premises(&ended);
        self.cases.named.insert(name.to_owned(), section);
    }

    /// Notes that a paragraph, in small letters, opens with a title in bold or italics, or that words turn to another case;
    /// whether such a paragraph opens here.
    pub(crate) fn note_case(&mut self, text: &str, span: Span, opens_paragraph: bool) -> bool {
        let before = Span {
            start: span.start.saturating_sub(12),
            end: span.start,
        };
        let before = self.document.source.slice(before);
        let titles = ["\\textbf{", "\\emph{", "\\textit{"];
        let opening = self.document.source.slice(span).trim_start();
        let titled = |t: &&str| before.ends_with(*t) || opening.starts_with(*t);
        let title = before.ends_with(['*', '_']) || titles.iter().any(titled);
        let text = text.trim_start();
        let counted = COUNTED.iter().any(|start| text.starts_with(start));
        let turned = has_any(text, TURNS);
        let opens = opens_paragraph && (title || counted);
        if opens || turned {
            self.open_case();
        }
        opens
    }

    fn open_case(&mut self) {
        self.leave_steady_case();
        self.cases.now += 1;
    }

    /// Notes that the axes are attached to the body in the case at hand.
    pub(crate) fn note_attached(&mut self) {
        self.cases.attached = Some((self.cases.section, self.cases.now));
    }

    /// Where the axes were attached to the body in an earlier case, and now turn in another way, they have a rate of
    /// their own again: "fixed in the body: ⟨Ω₃ = ω₃⟩", and then "not about **e**₃: ⟨Ω₃ = 0⟩".
    fn detach_axes(&mut self, sides: &[Node]) {
        let now = (self.cases.section, self.cases.now);
        let earlier = self.cases.attached.is_some_and(|case| case < now);
        let of_axes = |owner: &Owner| matches!(owner, Owner::Quantity(Quantity::FrameRate, _));
        let met = |checker: &mut Self| {
            let named = checker.entities(sides.first());
            let mut owners = named.iter().map(|e| &checker.theory.atoms.info(*e).owner);
            owners.any(of_axes)
        };
        if earlier && met(self) && self.contradicts(sides) {
            self.axes_turn_apart();
        }
    }

    /// Gives the axes a rate of their own again.
    pub(crate) fn axes_turn_apart(&mut self) {
        self.cases.attached = None;
        self.theory.set(|setting| setting.axes = Axes::Turning);
    }

    /// Ends the assumptions of earlier cases, where a line assumes something else of the same symbols.
    pub(crate) fn turn_to_case(&mut self, sides: &[Node], role: Role) {
        let Some(first) = sides.first() else { return };
        self.end_freedom_from_torque(sides);
        if role == Role::Assume && (self.supposes_anew(sides) || self.turns_about_another(sides)) {
            self.open_case();
        }
        let lone = matches!(inner(first).kind, Kind::Symbol(_));
        let given = role != Role::Define || self.sets_motion(first);
        let says = !self.displayed && !self.asserted && lone && given;
        if role == Role::Assume || says {
            self.detach_axes(sides);
        }
        if lone && matches!(role, Role::Assume | Role::Given) {
            self.set_up_anew(sides);
        }
        if role != Role::Assume && !says || self.cases.kept.values().all(|&c| c == self.cases.now) {
            return;
        }
        let of_siblings = self.names_of_siblings(sides);
        let mut lowering = self.lowering(Frame::Moving);
        let written = sides[..sides.len() - 1].iter();
        let values: Vec<_> = written
            .filter_map(|side| lowering.value(side).ok())
            .collect();
        let entries = values.iter().flat_map(|value| &value.entries);
        let variables: BTreeSet<u32> = entries.flat_map(Fraction::variables).collect();
        let earlier = |name: &Name| {
            let made = self.cases.kept.get(name);
            made.is_some_and(|&case| case < self.cases.now)
        };
        let same = |residual: &Fraction| residual.variables().iter().any(|v| variables.contains(v));
        let mut premises = self.theory.premises().iter();
        // What a vector is made of may take another value: `\boldsymbol\Omega = \dot\theta\,\hat{\imath} + …`, now with θ at rest.
        let made_of = |p: &Premise| {
            p.residuals.len() == 3 && p.preferred.iter().all(|v| !variables.contains(v))
        };
        let meets =
            premises.any(|p| earlier(&p.name) && !made_of(p) && p.residuals.iter().any(same));
        let passed_on = of_siblings.iter().any(earlier);
        // A number for a symbol takes the place of what is no law of others.
        let number = !is_zero(&sides[sides.len() - 1]) && sides[1..].iter().all(is_in_digits);
        let alone = |r: &Fraction| r.variables().iter().all(|v| variables.contains(v));
        let premises = self.theory.premises().iter();
        let values = premises.filter(|p| p.residuals.iter().any(alone));
        let values: BTreeSet<Name> = values.map(|p| p.name.clone()).collect();
        let narrows = number && !values.iter().any(earlier);
        if !meets && !passed_on || narrows || role != Role::Assume && !self.contradicts(sides) {
            return;
        }
        let kept = self.cases.kept.iter();
        let before = kept.filter(|&(_, &case)| case < self.cases.now);
        let mut ended: BTreeSet<Name> = before.map(|(name, _)| name.clone()).collect();
        ended.retain(|name| !self.weighs_something_else(name, &variables));
        ended.retain(|name| !number || values.contains(name));
        if passed_on {
            self.small_across(first);
        } else if self.set_the_spin(&ended) {
            self.end_spin();
        }
        self.cases.kept.retain(|name, _| !ended.contains(name));
        self.end_premises(&ended);
    }

    /// Whether an assumption of an earlier case said what a lone symbol is.
    pub(crate) fn is_set_in_an_earlier_case(&mut self, symbol: &Node) -> bool {
        let Ok(value) = self.lowering(Frame::Moving).value(symbol) else {
            return false;
        };
        let own: Option<Vec<u32>> = value.entries.iter().map(Fraction::as_variable).collect();
        let earlier = |p: &Premise| {
            let made = self.cases.kept.get(&p.name);
            made.is_some_and(|&case| case < self.cases.now)
        };
        let mut premises = self.theory.premises().iter();
        own.is_some_and(|own| {
            premises.any(|p| earlier(p) && own.iter().all(|v| p.preferred.contains(v)))
        })
    }

    /// Whether a line supposed something by this name.
    pub(crate) fn is_supposed(&self, name: &Name) -> bool {
        self.cases.kept.contains_key(name)
    }

    /// Whether a display of an earlier case set something up by this name.
    pub(crate) fn is_set_before(&self, name: &Name) -> bool {
        let case = self.cases.set.get(name);
        case.is_some_and(|&case| case < self.cases.now)
    }

    /// Ends what an earlier case set a component of ω to, where a line sets it to something else; what stands there now
    /// in the place of something small is small too.
    fn set_up_anew(&mut self, sides: &[Node]) {
        let now = self.cases.now;
        if self.cases.set.values().all(|&case| case == now) {
            return;
        }
        let mut lowering = self.lowering(Frame::Moving);
        let mut part = |side: &Node| lowering.scalar(side)?.as_variable();
        let Some(own) = sides.first().and_then(&mut part) else {
            return;
        };
        let rate_of_axes = self.theory.atoms.quantity(Quantity::FrameRate);
        if self.theory.atoms.entity_of(own) == Some(rate_of_axes) && self.contradicts(sides) {
            self.end_component(own);
        }
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        if self.theory.atoms.entity_of(own) != Some(omega) || !self.contradicts(sides) {
            return;
        }
        // What the momentum is made of holds in each case.
        let momentum = |v: Variable| {
            let owner = self.theory.atoms.owner(v);
            matches!(owner, Some(Owner::Quantity(Quantity::Momentum, _)))
        };
        let sets = |r: &Fraction| {
            let met = r.variables();
            met.contains(&own) && !met.into_iter().any(momentum)
        };
        let earlier = |p: &&Premise| self.is_set_before(&p.name) && p.residuals.iter().any(sets);
        let ended: Vec<Premise> = self
            .theory
            .premises()
            .iter()
            .filter(earlier)
            .cloned()
            .collect();
        for premise in ended {
            let before = premise.residuals.iter().flat_map(Fraction::variables);
            let before = before.filter_map(|v| self.theory.atoms.entity_of(v));
            if before
                .collect::<Vec<_>>()
                .iter()
                .any(|e| self.small.contains(e))
            {
                self.small_as_before(&sides[1..]);
            }
            self.end_spin();
            self.cases.set.remove(&premise.name);
            self.end_premises(&BTreeSet::from([premise.name]));
        }
    }

    /// Where two components of ω were small, those across this one are so now: the body spins about another axis in the
    /// same way.
    fn small_across(&mut self, spin: &Node) {
        if let Kind::Symbol(symbol) = &inner(spin).kind
            && let Meaning::Component(_, axis) = self.meaning_of(symbol)
            && self.small_turns.len() == 2
        {
            self.oscillation = None;
            self.small_turns = (0..3).filter(|&c| c != axis).collect();
            self.theory.set(|setting| setting.dropped_axis = None);
        }
    }

    /// Whether a line is not true of what is known.
    fn contradicts(&mut self, sides: &[Node]) -> bool {
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return false;
        };
        let rests: Vec<Fraction> = read.residuals().cloned().collect();
        rests
            .iter()
            .any(|rest| !num_traits::Zero::is_zero(&self.theory.normal(rest)))
    }

    /// Leaves a line open that a bracket sets against the numbers given, and those of its sentence that fail with it:
    /// "for a square plate ($a = b$) we have $I_x = I_y$".
    pub(crate) fn leave_hypothesis(&mut self, sides: &[Node], finding: &mut Finding) {
        if finding.verdict != Verdict::Refuted || self.displayed {
            return;
        }
        let aside = self.sentence.trim_end().ends_with('(');
        self.cases.hypothesis |= aside && self.is_in_numbers(sides);
        if self.cases.hypothesis {
            finding.verdict = Verdict::Undecided;
            finding.reason = Some(reason::OTHER_CASE.to_owned());
            finding.counterexample = None;
        }
    }
}
