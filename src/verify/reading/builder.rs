//! Goes through the statements and builds the reading: things first, then letters, then what holds.

use crate::algebra::Fraction;
use crate::notation::ast::Kind;
use crate::notation::document::Row;
use crate::verify::facts::Source;
use crate::verify::language::statement::{Declaration, Formula, Slot, Statement, Term};
use crate::verify::model::system::{BodyId, FamilyId, FrameId, PointId, System};
use crate::verify::reading::axes_read::{Bearings, NamedAxes};
use crate::verify::reading::blows_read::{rests_before, tells_letter_at_blow};
use crate::verify::reading::compounds_read::symbols_in;
use crate::verify::reading::elements_read::with_elements;
use crate::verify::reading::instants_read::{instant_of, is_of_instant};
use crate::verify::reading::loads_read::acting_force;
use crate::verify::reading::misheard::heard;
use crate::verify::reading::momentary::is_momentary;
use crate::verify::reading::names::{MASS_CENTRE, index_letter, name_of, node_of, reach_of};
use crate::verify::reading::no_facts::{denies, is_left_to_line};
use crate::verify::reading::operators_read::if_rates_are_told_apart;
use crate::verify::reading::potentials_read::tells_zero_of_potential;
use crate::verify::reading::{Premise, Reading};
use crate::verify::term::letters::{At, Letter, Meaning, Reach, loosely, spelled};
use crate::verify::term::quantity::{Quantity, Spot};
use crate::verify::term::value::Value;
use crate::verify::term::written::{Written, WrittenSymbols};
use std::collections::{BTreeMap, BTreeSet};

/// A reading under way.
pub(crate) struct Builder<'a> {
    pub(super) declarations: &'a [Declaration],
    pub(super) reading: Reading,
    pub(super) frames: BTreeMap<String, FrameId>,
    pub(super) points: BTreeMap<String, PointId>,
    pub(super) bodies: BTreeMap<String, BodyId>,
    pub(super) families: BTreeMap<String, FamilyId>,
    /// Letters and names of axes: a frame and the number of the axis.
    pub(super) axes: NamedAxes,
    pub(super) bearings: Bearings,
    pub(super) gravity: Option<Quantity>,
    /// Particles that stand for bodies.
    pub(super) points_of: Vec<(BodyId, BodyId)>,
    /// Bodies with rotors, and the hubs that carry these.
    pub(super) hubs: Vec<(BodyId, BodyId)>,
    /// Frames that turn about axes through points: of the frame, relative to another.
    pub(super) through: Vec<(FrameId, FrameId, Term, Declaration)>,
}

/// A letter that is the same as another that is the same as another is followed so far.
const MOST_WRITINGS: usize = 8;

/// The premises of a document have no more terms than this in all.
pub(super) const MOST_TERMS: usize = 100_000;

/// Reads declarations about a document that writes these symbols; the variables of the model are numbered from `first` on.
pub(crate) fn build(declarations: &[Declaration], written: Written, first: usize) -> Reading {
    let written = WrittenSymbols::new(written);
    // What holds under a condition is never taken as always true, and what is denied is no fact.
    let (said, wants) = heard(with_elements(declarations, &written));
    let (conditional, always): (Vec<_>, Vec<_>) = said
        .into_iter()
        .filter(|d| !is_left_to_line(d, &written))
        .map(|d| if_rates_are_told_apart(d, declarations, &written))
        .partition(|d| {
            let then = has_condition(d) || is_of_instant(d) || is_momentary(d);
            let at_blow = tells_letter_at_blow(d);
            then && !at_blow && !tells_zero_of_potential(d, declarations) || denies(d)
        });
    let mut builder = Builder::of(&always);
    builder.reading.system.atoms.begin_at(first);
    builder.write_products_as(&written);
    builder.reading.letters.written = written;
    builder.say_conditional(&conditional);
    builder.look_for_blow();
    builder.name_frames();
    builder.name_bodies();
    builder.read_notation();
    builder.turn_by_quaternions();
    builder.turn_frames();
    builder.name_vectors_of_members();
    builder.place_points();
    builder.let_values_change(&conditional);
    builder.finish_bodies();
    builder.place_contacts();
    builder.name_values_at_instants(&conditional);
    let bounds = builder.read_bounds(&always);
    builder.name_axes_in_formulas();
    builder.read_places_at_blow(&conditional);
    builder.read_strikes();
    builder.read_letters();
    builder.step_functions();
    builder.hold_told_places();
    builder.hold_masses();
    builder.hold_all_meanings();
    builder.hold_midpoints();
    builder.hold_corners();
    builder.hold_fixed_frames();
    builder.hold_fixed_vectors();
    builder.make_up_of_references();
    builder.read_bounds(bounds);
    builder.read_premises();
    builder.hold_equations_of_motion();
    builder.read_obeyed();
    builder.vary_laws();
    builder.hold_at_blow();
    builder.read_roles();
    builder.read_instants(&conditional);
    builder.read_candidates();
    builder.name_axes_by_custom();
    builder.say_unheard();
    builder.widen_unused();
    builder.connect_unused(&conditional);
    builder.say_what_unused_want(&wants);
    builder.reading
}

impl<'a> Builder<'a> {
    fn of(declarations: &'a [Declaration]) -> Self {
        Self {
            declarations,
            reading: Reading::default(),
            frames: BTreeMap::new(),
            points: BTreeMap::new(),
            bodies: BTreeMap::new(),
            families: BTreeMap::new(),
            axes: NamedAxes::default(),
            bearings: Bearings::default(),
            gravity: None,
            through: vec![],
            points_of: vec![],
            hubs: vec![],
        }
    }
}

impl Builder<'_> {
    pub(super) fn system(&mut self) -> &mut System {
        &mut self.reading.system
    }

    pub(super) fn source_of(declaration: &Declaration) -> Source {
        Source::Declared(declaration.sentence().to_owned())
    }

    pub(super) fn hold(&mut self, equation: Fraction, declaration: &Declaration) {
        self.reading.terms += equation.numerator().len() + equation.denominator().len();
        if !equation.is_valid() || self.is_full() {
            return self.say_beyond(declaration);
        }
        self.note_law(declaration);
        self.system().atoms.tie(&equation);
        self.reading.premises.push(Premise {
            equation,
            source: Self::source_of(declaration),
            reach: reach_of(&declaration.extent),
        });
    }

    /// Whether no more sentences are taken in: what they say together grew too large.
    pub(super) fn is_full(&self) -> bool {
        self.reading.terms > MOST_TERMS
    }

    /// Each component of two values is the same.
    pub(super) fn hold_equal(&mut self, left: &Value, right: &Value, declaration: &Declaration) {
        let custom = self.reading.letters.component_frame;
        if let Ok((left, right)) = self.reading.system.compared(left, right, custom) {
            for (l, r) in left.entries.iter().zip(&right.entries) {
                self.hold(l.clone() - r.clone(), declaration);
            }
        }
    }

    /// Gives a writing a meaning.
    pub(super) fn denote(
        &mut self,
        formula: &Formula,
        meaning: Meaning,
        declaration: &Declaration,
    ) {
        let reach = reach_of(&declaration.extent);
        self.denote_within(formula, meaning, reach, declaration);
    }

    /// Gives a writing a meaning in a part of the document.
    pub(super) fn denote_within(
        &mut self,
        formula: &Formula,
        meaning: Meaning,
        reach: Reach,
        declaration: &Declaration,
    ) {
        let Some(node) = node_of(formula) else {
            return self.say_unused(declaration);
        };
        if let Meaning::Quantity(place @ Quantity::Position { .. }) = &meaning
            && let Ok(place) = self.system().value_of(place)
        {
            let told = place.entries.iter().flat_map(Fraction::variables);
            self.system().atoms.set_placed(told);
        }
        if self.denotes_opposite(node, &meaning, &reach, declaration) {
            return;
        }
        if let Kind::Matrix(rows) = &node.kind
            && let [row] = rows.as_slice()
            && let [inner] = row.as_slice()
        {
            let inner = Formula {
                source: formula.source.clone(),
                row: Row::Expression(inner.clone()),
            };
            self.denote_within(&inner, meaning.clone(), reach.clone(), declaration);
        }
        let letter = self.letter(formula, meaning, declaration);
        let told = letter.map(|letter| Letter { reach, ..letter });
        self.reading.letters.letters.extend(told);
    }

    /// A writing with a meaning, where a sentence tells it.
    pub(super) fn letter(
        &self,
        formula: &Formula,
        meaning: Meaning,
        declaration: &Declaration,
    ) -> Option<Letter> {
        let node = node_of(formula)?;
        let spelled = spelled(node);
        Some(Letter {
            whole: spelled.contains(['\\', '{', ' ', '[', '^', '(']),
            spelled,
            loose: loosely(node),
            latex: formula.source.clone(),
            meaning,
            reach: reach_of(&declaration.extent),
            sentence: declaration.text.clone(),
            besides: matches!(&declaration.statement, Statement::Is { what, .. } if what.is("also")),
        })
    }

    /// The frame that a term names.
    pub(super) fn frame(&self, term: &Term) -> Option<FrameId> {
        let name = name_of(term)?;
        if let Some(&frame) = self.frames.get(&name) {
            return Some(frame);
        }
        let body = self.bodies.get(name.trim_start_matches("the "))?;
        self.reading.system.bodies[*body].frame
    }

    /// The point that a term names.
    pub(super) fn point(&self, term: &Term) -> Option<PointId> {
        match term {
            Term::Phrase(phrase) if phrase.head == MASS_CENTRE => {
                let body = match phrase.slot(Slot::Of) {
                    Some(of) => self.body(of)?,
                    None => self.only_body()?,
                };
                Some(self.reading.system.bodies[body].centre)
            }
            _ if acting_force(term).is_some() => self.where_acts(acting_force(term)?),
            _ => {
                let name = name_of(term)?;
                let particle = || {
                    self.bodies
                        .get(&name)
                        .map(|&b| self.reading.system.bodies[b].centre)
                };
                self.points.get(&name).copied().or_else(particle)
            }
        }
    }

    /// The place that a term names: a point, or a member of a family.
    pub(super) fn spot(&self, term: &Term) -> Option<Spot> {
        if let Term::Member { family, index } = term {
            let family = *self.families.get(family)?;
            return Some(Spot::Member(family, index_letter(index)));
        }
        self.point(term).map(Spot::Point)
    }

    /// Where a formula of a sentence stands. A letter that is told of another part of the document alone is meant there.
    pub(super) fn place_of(&self, formula: &Formula, declaration: &Declaration) -> At {
        let at = place_in(&reach_of(&declaration.extent));
        let letters = &self.reading.letters;
        let symbols = node_of(formula).into_iter().flat_map(symbols_in);
        let elsewhere = symbols.filter_map(|symbol| {
            let node = node_of(&symbol)?;
            let (exact, loose) = (spelled(node), loosely(node));
            let mut told = letters.letters.iter().filter(|l| l.spelled == exact);
            let reach = &told.next()?.reach;
            let other = letters.find(&exact, &loose, &at, 1).is_none();
            (other && told.all(|l| l.reach == *reach)).then(|| place_in(reach))
        });
        elsewhere.into_iter().next().unwrap_or(at)
    }

    /// What a letter stands for at the place of a declaration.
    pub(super) fn quantity_of(
        &self,
        formula: &Formula,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let at = place_in(&reach_of(&declaration.extent));
        let mut node = node_of(formula)?;
        for _ in 0..MOST_WRITINGS {
            let letters = &self.reading.letters;
            match &letters
                .find(&spelled(node), &loosely(node), &at, 1)?
                .meaning
            {
                Meaning::Quantity(quantity) => return Some(quantity.clone()),
                Meaning::Same(other) => node = other,
                _ => return None,
            }
        }
        None
    }
}

/// A place that a reach covers.
pub(crate) fn place_in(reach: &Reach) -> At {
    match reach {
        Reach::Lines {
            cell, first: line, ..
        }
        | Reach::Occurrence { cell, line, .. }
        | Reach::From { cell, line } => At {
            cell: *cell,
            line: *line,
            sections: vec![],
        },
        Reach::Section(title) => At {
            sections: vec![title.clone()],
            ..At::default()
        },
        Reach::Cells(cells) => At {
            cell: cells.first().copied(),
            ..At::default()
        },
        Reach::Both(a, b) => {
            let (a, b) = (place_in(a), place_in(b));
            At {
                cell: a.cell.or(b.cell),
                line: a.line.max(b.line),
                sections: [a.sections, b.sections].concat(),
            }
        }
        Reach::Any(all) => all.first().map_or_else(At::default, place_in),
        Reach::All => At::default(),
    }
}

impl System {
    /// Whether no letter of which nothing is told stands in a value.
    pub(super) fn is_told(&self, value: &Value) -> bool {
        let variables = value.entries.iter().flat_map(Fraction::variables);
        variables.into_iter().all(|v| !self.atoms.is_unknown(v))
    }

    /// Letters that stand in a declaration are told by it, also inside sines and roots.
    pub(super) fn trust(&mut self, value: &Value) {
        use crate::verify::model::atoms::Nature;
        let variables = |f: &Fraction| f.variables();
        let mut waiting: Vec<_> = value.entries.iter().flat_map(variables).collect();
        let mut seen = BTreeSet::new();
        while let Some(variable) = waiting.pop() {
            if !seen.insert(variable) {
                continue;
            }
            let atom = self.atoms.atom_mut(variable);
            waiting.extend(atom.rate_of);
            match &atom.nature {
                Nature::Unknown => atom.nature = Nature::Quantity,
                Nature::Sine(of) | Nature::Cosine(of) | Nature::Root(of) => {
                    waiting.extend(of.variables());
                }
                _ => {}
            }
        }
    }
}

/// Words of a condition in time.
const WHILES: [&str; 3] = ["before", "after", "during"];

/// Whether a sentence holds under a condition alone: "at `\theta = 0`".
fn has_condition(declaration: &Declaration) -> bool {
    let slots = match &declaration.statement {
        Statement::Is { what, .. } if rests_before(what) => return false,
        // How a body points where its angles are zero tells where these begin.
        Statement::Does {
            subjects,
            verb: "point",
            ..
        } if !subjects.iter().any(|s| matches!(s, Term::Formula(_))) => return false,
        Statement::Is { what, .. } | Statement::Premise(what) => &what.slots,
        Statement::Does { slots, .. } => slots,
        _ => return false,
    };
    slots
        .iter()
        .any(|(slot, term)| is_condition(*slot, term, 0))
}

fn is_condition(slot: Slot, term: &Term, depth: usize) -> bool {
    match term {
        _ if instant_of(slot, term).is_some() => true,
        Term::Phrase(phrase) if WHILES.contains(&phrase.head) => true,
        Term::Phrase(phrase) if depth < 8 => {
            let mut inner = phrase.slots.iter();
            inner.any(|(slot, term)| is_condition(*slot, term, depth + 1))
        }
        _ => false,
    }
}
