//! Goes through a document from top to bottom and keeps what is in force.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::notation::document::{Document, Formula, Item, Row};
use crate::source::Span;
use crate::verify::letters::convention::convention;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::half_angles::writes_half_angles;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::space_axes::SpaceAxes;
use crate::verify::letters::triad::Triad;
use crate::verify::lines::cases::Cases;
use crate::verify::lines::dimensions::Dimensions;
use crate::verify::lines::doubt::Doubts;
use crate::verify::lines::euler_rates::RateLine;
use crate::verify::lines::index::merged;
use crate::verify::lines::limits::Limit;
use crate::verify::lines::line::Read;
use crate::verify::lines::named_roots::Sought;
use crate::verify::lines::oscillation::Oscillation;
use crate::verify::lines::semi_axes::Quadric;
use crate::verify::lines::signs::Order;
use crate::verify::names;
use crate::verify::repair::carried::Slip;
use crate::verify::spelling::spell;
use crate::verify::theory::law::{Axes, Dynamics, Setting};
use crate::verify::theory::more_moments::OtherMoments;
use crate::verify::theory::{Premise, Theory};
use crate::verify::values::atoms::Entity;
use crate::verify::values::figures::Figures;
use crate::verify::values::lower::FunctionOf;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::value::Value;
use crate::verify::verdict::{Convention, Finding, FromProse, Passed, Report, Role};
use crate::verify::words::point_masses::PointMass;
use crate::verify::words::premise::inertia_changes;
use crate::verify::words::prose::speaks_of_any_vector;
use crate::verify::words::text::Text;
use std::cell::OnceCell;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// Findings in the order of the document.
fn in_order(mut findings: Vec<Finding>) -> Vec<Finding> {
    findings.sort_by_key(|finding| finding.span.start);
    findings
}

/// What is in force at a place of the document.
pub(super) struct Checker<'a> {
    pub(super) document: &'a Document,
    pub(super) text: &'a Text<'a>,
    /// The symbols as the document writes them, and its labels of frames, once they were asked for.
    pub(super) written: OnceCell<Vec<Vec<&'a str>>>,
    pub(super) frame_labels: OnceCell<[String; 2]>,
    /// The nodes of words that a line could have, as they were read for others.
    pub(super) words: HashMap<String, Option<Node>>,
    pub(super) reading: Reading,
    pub(super) theory: Theory,
    pub(super) functions: HashMap<String, FunctionOf>,
    /// Entities that the words or an accepted line have given a meaning.
    pub(super) known: BTreeSet<Entity>,
    /// Symbols that say how moments and forces act: the c of `M = -cω`.
    pub(super) loads: BTreeSet<Entity>,
    /// Whether the words fix what a dot without a frame means.
    pub(super) dots: Option<Frame>,
    /// What the dots of vectors have to mean for earlier lines to hold.
    pub(super) dots_of_lines: BTreeMap<Entity, Frame>,
    /// How the claim that was proved last was read, and where it ends.
    pub(super) proved_as: Option<(Span, Read)>,
    /// The last side of the line before, for lines that go on.
    pub(super) last_side: Option<Node>,
    /// Whether the sentence derives the line at hand: "hence", "gives".
    pub(super) asserted: bool,
    /// Whether the words right before the formula at hand say that it was worked out.
    pub(super) obtained: bool,
    /// Whether the role of the line is in so many words: a mark, "assume", "given".
    pub(super) firm: bool,
    pub(super) picked: bool,
    /// Whether the sentence names a constraint: "does not slip", "is fixed".
    pub(super) constrained: bool,
    /// Whether the words speak of vectors that may be any.
    pub(super) any_vector: bool,
    /// Whether the line at hand stands apart from the text.
    pub(super) displayed: bool,
    /// The first and the last side of each line of the formula at hand.
    pub(super) beside: Vec<(Node, Node)>,
    pub(super) findings: Vec<Finding>,
    /// How many findings each line of the source has.
    pub(super) on_line: HashMap<(usize, Option<usize>), usize>,
    /// Lines of rates of angles that were judged together.
    pub(super) rate_lines: Vec<RateLine>,
    /// What lines that were left open leave in doubt.
    pub(super) doubts: Doubts,
    /// False lines so far.
    pub(super) slips: Vec<Slip>,
    pub(super) sentence: String,
    /// The words of the paragraph that led into the display before, where the sentence goes on.
    pub(super) led_in: String,
    /// Whether a display stands right behind the item at hand.
    pub(super) goes_into_display: bool,
    /// What lines on the body's axes suppose, where other lines stand on axes of fixed orientation.
    pub(super) on_body: Vec<Premise>,
    /// The vertical on the axes used, where the words say what it is there.
    pub(super) vertical: Option<Value>,
    /// What is called small.
    pub(super) small: BTreeSet<Entity>,
    /// Components of the angular velocity that are called small.
    pub(super) small_turns: BTreeSet<u8>,
    /// Whether equations are taken to first order in what is small.
    pub(super) linear: bool,
    /// Expressions of a list that the words have named last.
    pub(super) named: Vec<Node>,
    /// The lone symbol that the text had last.
    pub(super) last_alone: Option<Node>,
    /// Places of lines that were taken in ahead of their turn.
    pub(super) done: BTreeSet<u32>,
    /// Whether a definition stood behind the first use of its symbol.
    pub(super) looked_ahead: bool,
    /// Symbols that their first use defines.
    pub(super) implicit: BTreeSet<Entity>,
    /// Whether a paragraph ended since the last words or formula.
    pub(super) broken: bool,
    /// The role that a comment sets for the next formula.
    pub(super) mark: Option<Role>,
    /// Whether nothing stands between a display that was claimed and what comes now.
    pub(super) behind_claim: bool,
    /// Whether the words behind this formula are of one instant.
    pub(super) instant_behind: bool,
    /// Names of premises with the level of the heading that they stand under.
    pub(super) scopes: Vec<(String, u8)>,
    /// Lines that say what a step is, and in which section and case.
    pub(super) steps: Vec<(String, (u32, u32))>,
    pub(super) level: u8,
    /// The case that is looked at.
    pub(super) cases: Cases,
    /// How the components of the angular velocity were named last.
    pub(super) triad: Option<Triad>,
    pub(super) convention: Convention,
    pub(super) figures: Figures,
    /// What symbols are measured in.
    pub(super) dimensions: Dimensions,
    /// The potential energy.
    pub(super) potential: Option<Entity>,
    /// How many findings stood before the equation of an oscillation, and the square of its frequency.
    pub(super) oscillation: Option<Oscillation>,
    /// Values that the sentence lets something go to.
    pub(super) limits: Vec<Limit>,
    /// Point masses that words have further on, and where.
    pub(super) point_masses: Option<(Vec<PointMass>, Span)>,
    /// The surface that a line is the equation of.
    pub(super) quadric: Option<Quadric>,
    /// The product of inertia that a line said last what it is.
    pub(super) last_product: Option<Node>,
    /// The equation above, for one of its symbols.
    pub(super) sought: Option<Sought>,
    /// The last equations whose roots a line with ± may give.
    pub(super) equations: Vec<Fraction>,
    /// The last proved equations with terms on both sides.
    pub(super) balances: Vec<Fraction>,
    /// What vanishes at the border of the values for which roots are real.
    pub(super) border: Option<Fraction>,
    /// Which quantities are greater than others.
    pub(super) orders: Vec<Order>,
    /// What lines or words call positive.
    pub(super) positive: BTreeSet<Variable>,
    pub(super) from_prose: Vec<FromProse>,
    passed: Vec<Passed>,
}

impl<'a> Checker<'a> {
    pub(super) fn new(text: &'a Text<'a>, reading: Reading) -> Self {
        let document: &Document = text;
        let (products, convention) = convention(document, &reading);
        let own_rate = reading
            .quantities
            .values()
            .any(|&q| q == Quantity::FrameRate);
        let axes = match document.front_matter.axes.as_deref() {
            Some("body") => Axes::Body,
            Some("turning") => Axes::Turning,
            _ if own_rate || reading.carried_spin.is_some() => Axes::Turning,
            _ => Axes::Body,
        };
        let setting = Setting {
            axes,
            products,
            dynamics: Dynamics::Inverse,
            origin_moves: false,
            dropped_axis: None,
            translation: None,
            wheel_inertia: None,
            energy_of_parts: None,
            drifts: reading.speaks_of(Quantity::CentreVelocity),
            newton: !reading.usage.speaks_of_a_centre() && !reading.drifts_beside_a_point(),
            rigid: !inertia_changes(document, &reading),
            gyrostat: reading.wheels_apart || reading.speaks_of(Quantity::RelativeMomentum),
            other_moments: OtherMoments::default(),
            parallel_axes: [None; 2],
            attitude: reading.attitude.convention,
            attitude_given: false,
            half_angles: writes_half_angles(document),
        };
        let mut checker = Self {
            document,
            text,
            written: OnceCell::new(),
            frame_labels: OnceCell::new(),
            words: HashMap::new(),
            theory: Theory::new(setting),
            functions: HashMap::new(),
            known: BTreeSet::new(),
            loads: BTreeSet::new(),
            dots: None,
            dots_of_lines: BTreeMap::new(),
            proved_as: None,
            last_side: None,
            asserted: false,
            obtained: false,
            firm: false,
            constrained: false,
            picked: false,
            displayed: false,
            any_vector: speaks_of_any_vector(document),
            beside: vec![],
            findings: vec![],
            on_line: HashMap::new(),
            rate_lines: vec![],
            slips: vec![],
            doubts: Doubts::default(),
            sentence: String::new(),
            led_in: String::new(),
            goes_into_display: false,
            on_body: vec![],
            vertical: None,
            small: BTreeSet::new(),
            small_turns: BTreeSet::new(),
            linear: false,
            named: vec![],
            last_alone: None,
            done: BTreeSet::new(),
            looked_ahead: false,
            implicit: BTreeSet::new(),
            broken: false,
            mark: None,
            behind_claim: false,
            instant_behind: false,
            scopes: vec![],
            steps: vec![],
            level: 0,
            cases: Cases::default(),
            triad: None,
            convention,
            figures: Figures::default(),
            dimensions: Dimensions::default(),
            potential: None,
            oscillation: None,
            point_masses: None,
            sought: None,
            quadric: None,
            limits: vec![],
            last_product: None,
            equations: vec![],
            balances: vec![],
            border: None,
            orders: vec![],
            positive: BTreeSet::new(),
            from_prose: vec![],
            passed: vec![],
            reading,
        };
        let space_axes = checker.reading.space_axes.as_ref();
        checker.theory.atoms.inertia_letters = space_axes.and_then(SpaceAxes::two_letters);
        spell(document, &checker.reading, &mut checker.theory.atoms);
        if checker.reading.on_chosen_axes {
            checker.choose_axes();
        }
        checker.single_moments();
        checker.moments_in_words();
        if checker.reading.turns_from.is_none() {
            checker.turns_about_fixed_axis();
        }
        checker.wheel_lies_along_axis();
        checker.rotor_is_alone();
        checker.carries_a_spin();
        checker.brake_acts();
        checker.turns_at_its_number();
        checker.turns_round();
        checker.note_parallel_axes();
        checker.tie_moving_point();
        checker.tie_particles();
        checker.note_cones();
        checker.name_components();
        checker.keep_momentum_between_states();
        checker.take_uniform_box();
        checker.find_point_masses();
        if let Some(angles) = checker.reading.euler_angles.clone() {
            checker.take_euler_angles(&angles);
        }
        checker
    }

    pub(super) fn report(self) -> Report {
        Report {
            readings: self.readings_in_words(),
            path: self.document.source.name.clone(),
            products: self.convention,
            findings: merged(in_order(self.findings)),
            from_prose: self.from_prose,
            passed: self.passed,
            variables: names::all(&self.theory.atoms),
            meaning: vec![],
            questions: vec![],
            unused: vec![],
        }
    }

    fn readings_in_words(&self) -> Vec<String> {
        let commas = self.document.macros.decimal_comma;
        let commas = commas.then(|| "decimal commas: 2,5 is 5/2".to_owned());
        self.reading.describe().into_iter().chain(commas).collect()
    }

    pub(super) fn item(&mut self, item: &Item) {
        match item {
            Item::Heading { level, text, span } => {
                self.behind_claim = false;
                self.heading(*level, text, *span);
            }
            Item::Prose { text, span } => {
                self.behind_claim &= text.trim().is_empty();
                self.prose(text, *span);
            }
            Item::Break => self.end_paragraph(),
            Item::Comment { text, .. } => self.comment(text),
            Item::Formula(formula) => self.formula(formula),
        }
    }

    fn comment(&mut self, text: &str) {
        self.mark = match text.trim() {
            "assume" => Some(Role::Assume),
            "claim" => Some(Role::Claim),
            "define" => Some(Role::Define),
            "given" => Some(Role::Given),
            _ => self.mark,
        };
    }

    fn formula(&mut self, formula: &Formula) {
        self.reading.attitude.turn_to(formula.span.start);
        self.displayed = formula.display;
        self.take_point_masses(formula.span);
        self.note_unnamed_plane(formula.span);
        if self.reading.turns_from == Some(formula.span.start) {
            self.turns_about_fixed_axis();
        }
        if formula.display {
            self.named.clear();
        }
        let says = |row: &Row| !matches!(row, Row::Expression(_));
        let said = formula.rows.iter().any(says);
        let heard = match said {
            true => self.listen(formula.display),
            false => Role::Claim,
        };
        // Right behind a display that is claimed, no words suppose the next one.
        let role = match self.behind_claim && formula.display && self.mark.is_none() {
            true => Role::Claim,
            false => heard,
        };
        let ends = |row: &Row| match row {
            Row::Line(line) => line.sides.first().cloned().zip(line.sides.last().cloned()),
            _ => None,
        };
        self.beside = match formula.rows.len() {
            2..=3 => formula.rows.iter().filter_map(ends).collect(),
            _ => vec![],
        };
        for row in &formula.rows {
            match row {
                Row::Line(line) if self.done.contains(&line.span.start) => {}
                Row::Line(line) => {
                    self.named.clear();
                    self.line(line, role);
                    // "And ⟨ω_z = ω⟩ constant."
                    let lone = |side: &&Node| matches!(side.kind, Kind::Symbol(_));
                    let last = line.sides.last().filter(|_| !formula.display);
                    self.named.extend(last.filter(lone).cloned());
                }
                Row::Expression(node) => {
                    self.note_expression(node);
                    self.expression(node);
                }
                Row::Unreadable {
                    message,
                    help,
                    span,
                } => self.unreadable(message, help.as_deref(), *span),
            }
        }
        self.mark = None;
        self.behind_claim = formula.display && said && role == Role::Claim;
        self.note_only_product(formula);
        self.hear_formula(formula);
        self.broken = false;
    }

    /// An expression that stands alone names its symbols.
    fn expression(&mut self, node: &Node) {
        self.now_known([node]);
        let place = self.document.place(node.span.start);
        self.passed.push(Passed {
            span: node.span,
            source_line: place.line,
            cell: place.cell,
            what: "expression",
        });
    }
}
