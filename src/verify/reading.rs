//! From statements to the model: which frames, points, bodies and loads there are, what letters denote, what holds.

pub(crate) mod about_read;
pub(crate) mod adapted_axes;
mod any_put_in;
pub(crate) mod any_read;
mod arithmetic_read;
mod attitudes_read;
mod axes_besides;
mod axes_by_custom;
pub(crate) mod axes_in_order;
pub(crate) mod axes_read;
mod axis_names;
pub(crate) mod balance_read;
pub(crate) mod bases_read;
pub(crate) mod blows_read;
pub(crate) mod bodies_read;
pub(crate) mod body_ends;
pub(crate) mod body_lines;
pub(crate) mod bounds_read;
pub(crate) mod boxes_read;
pub(crate) mod builder;
pub(crate) mod changes_read;
mod columns_read;
pub(crate) mod components_read;
pub(crate) mod compounds_read;
pub(crate) mod connected;
pub(crate) mod constants_read;
mod contact_letters;
pub(crate) mod contact_read;
mod contradictory;
pub(crate) mod coordinates_read;
pub(crate) mod corners_read;
mod customary_notation;
pub(crate) mod definitions_read;
pub(crate) mod densities_read;
pub(crate) mod directions_read;
pub(crate) mod elements_read;
pub(crate) mod elements_spoken;
pub(crate) mod ellipsoids_read;
mod floating_frames;
pub(crate) mod formulas_read;
pub(crate) mod frames_read;
mod gears_read;
pub(crate) mod impacts_read;
pub(crate) mod incline_read;
pub(crate) mod inertia_read;
pub(crate) mod instants;
pub(crate) mod instants_read;
pub(crate) mod label_read;
pub(crate) mod late_read;
pub(crate) mod lengths_read;
pub(crate) mod letters_read;
mod listed_frames;
pub(crate) mod load_quantities_read;
mod loads_between;
mod loads_outside;
pub(crate) mod loads_read;
pub(crate) mod lying_read;
mod makeup_lost;
mod makeup_read;
pub(crate) mod massless_read;
mod matrices_read;
mod misheard;
mod momentary;
pub(crate) mod named_loads_read;
pub(crate) mod names;
pub(crate) mod no_facts;
mod no_loads_read;
pub(crate) mod notation_read;
mod numbered_axes;
pub(crate) mod only_loads_read;
pub(crate) mod only_moments_read;
pub(crate) mod operators_read;
pub(crate) mod order;
pub(crate) mod orders_read;
pub(crate) mod oscillations_read;
mod pairs_read;
pub(crate) mod parallels_read;
pub(crate) mod parents_read;
mod particle_loads;
pub(crate) mod perpendicular_read;
mod points_read;
pub(crate) mod points_spoken;
mod potentials_of_loads;
pub(crate) mod potentials_read;
pub(crate) mod premises_read;
mod principal_axes_read;
pub(crate) mod products_read;
pub(crate) mod pyramids_read;
pub(crate) mod quantities_read;
pub(crate) mod quaternions_read;
pub(crate) mod rate_matrices_read;
mod rates_read;
pub(crate) mod reactions_read;
pub(crate) mod reference_motion;
pub(crate) mod references_read;
pub(crate) mod relations_read;
mod relative_motion_read;
mod rest_of_whole;
pub(crate) mod rest_read;
pub(crate) mod rotations_read;
pub(crate) mod shape_axes;
pub(crate) mod shapes_read;
pub(crate) mod signs_read;
mod sizes_read;
mod small_oscillations;
pub(crate) mod smooth_read;
pub(crate) mod springs_read;
mod steady_read;
pub(crate) mod step_functions;
pub(crate) mod steps_read;
pub(crate) mod surface_read;
pub(crate) mod symmetry_axes;
pub(crate) mod symmetry_read;
pub(crate) mod told_twice;
mod touched;
mod travel_read;
mod turn_order;
pub(crate) mod turns_read;
mod type_read;
mod unbound;
pub(crate) mod unused;
pub(crate) mod unused_letters;
mod unused_read;
mod values_told;
pub(crate) mod vectors_read;
mod wants;
mod ways_written;
mod wheel_rims;
pub(crate) mod wheels_read;
pub(crate) mod wholes;
pub(crate) mod work_frame;
mod working_loads_read;
mod zeros_read;

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::notation::print::latex;
use crate::verify::Role;
use crate::verify::facts::Source;
use crate::verify::facts::small::Small;
use crate::verify::model::common_list::CommonList;
use crate::verify::model::swings::Swing;
use crate::verify::model::system::System;
use crate::verify::reading::instants::Instants;
use crate::verify::reading::unused::Unused;
use crate::verify::term::letters::{At, Letters, Reach, spelled};
use crate::verify::term::value::Shape;
use std::collections::{BTreeSet, HashMap};

/// Something that is declared to hold.
#[derive(Clone, Debug)]
pub(crate) struct Premise {
    /// This vanishes.
    pub(crate) equation: Fraction,
    pub(crate) source: Source,
    pub(crate) reach: Reach,
}

/// What sentences say that lines are for.
#[derive(Clone, Debug)]
pub(crate) struct LineRole {
    /// The lines.
    pub(crate) reach: Reach,
    /// `None` for lines that are left out.
    pub(crate) role: Option<Role>,
    /// The letter that they define, in LaTeX: no other line does.
    pub(crate) defines: Option<String>,
}

impl LineRole {
    pub(crate) fn new(reach: Reach, role: Option<Role>) -> Self {
        Self {
            reach,
            role,
            defines: None,
        }
    }
}

/// What a document is taken to say.
#[derive(Clone, Debug, Default)]
pub(crate) struct Reading {
    pub(crate) system: System,
    pub(crate) letters: Letters,
    pub(crate) premises: CommonList<Premise>,
    /// How many terms the premises have in all.
    pub(crate) terms: usize,
    pub(crate) roles: Vec<LineRole>,
    /// The premises that are in force, by their places in the list.
    pub(crate) taken: Vec<usize>,
    /// What accepted lines have told.
    pub(crate) settled: Vec<Premise>,
    /// Shapes of letters that sentences speak of and lines define.
    pub(crate) shapes: HashMap<String, Shape>,
    /// Lines that hold for a part of the document: which, and where.
    pub(crate) held: Vec<(Reach, Reach)>,
    pub(crate) sizes: Sizes,
    pub(crate) instants: Instants,
    /// Sentences that nothing was made of.
    pub(crate) unused: Vec<Unused>,
}

/// What is said of sizes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sizes {
    /// What is greater than zero, and where: sides of inequalities, the greater less the smaller.
    pub(crate) orders: Vec<(Reach, Fraction)>,
    /// Lines that hold to first order in these variables.
    pub(crate) small: Vec<(Reach, Small)>,
    /// Remainders, where they are told, as they are spelled, and what is small by them.
    pub(crate) remainders: Vec<(Reach, String, Small)>,
    /// What is told of motions nearby.
    pub(crate) changes: Changes,
    /// The letters of the state from which others are small deviations, as they are spelled.
    pub(crate) reference: BTreeSet<String>,
    /// Letters that small oscillations tell.
    pub(crate) swings: Vec<Swing>,
    /// The small disturbances of reference values.
    pub(crate) disturbances: BTreeSet<Variable>,
}

/// What is told of first-order changes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Changes {
    /// Whether sentences tell of any.
    pub(crate) told: bool,
    /// The small disturbances beside them: it is open whether these are changes as well.
    pub(crate) disturbances: BTreeSet<Variable>,
    /// The premises that hold in any motion of the system, by their places in the list.
    pub(crate) laws: Vec<usize>,
    /// The lines that define letters.
    pub(crate) definitions: Vec<(Fraction, Source)>,
    /// Jacobians that are not worked out yet.
    pub(crate) jacobians: Vec<Jacobian>,
}

/// A letter for the partial derivatives of a vector, which may be defined further below.
#[derive(Clone, Debug)]
pub(crate) struct Jacobian {
    pub(crate) letter: Node,
    pub(crate) of: Node,
    pub(crate) by: Vec<Node>,
    /// Whether each component of the vector has a column, and not a row.
    pub(crate) transposed: bool,
    pub(crate) sentence: String,
}

impl Reading {
    /// Whether a line is left out.
    pub(crate) fn left_out(&self, at: &At) -> bool {
        self.roles
            .iter()
            .any(|line| line.role.is_none() && line.reach.covers(at, 0))
    }

    /// Whether links speak of nothing but the state from which others are small deviations: they choose it.
    pub(crate) fn chooses_reference(&self, sides: &[&Node]) -> bool {
        fn symbols<'n>(node: &'n Node, found: &mut Vec<&'n Node>) {
            match &node.kind {
                Kind::Symbol(_) => found.push(node),
                _ => node.children().for_each(|child| symbols(child, found)),
            }
        }
        let mut found = vec![];
        sides.iter().for_each(|side| symbols(side, &mut found));
        let known = |symbol: &Node| self.sizes.reference.contains(&spelled(symbol));
        !found.is_empty() && found.into_iter().all(known)
    }

    /// What is small at a place.
    pub(crate) fn small_at(&self, at: &At) -> Small {
        let reaching = self.sizes.small.iter();
        let reaching = reaching.filter(|(lines, _)| lines.covers(at, 0));
        reaching.fold(Small::default(), |all, (_, small)| all.and(small))
    }

    /// What is small by the remainders that formulas write at a place.
    pub(crate) fn small_by_remainders(&self, sides: &[Node], at: &At) -> Small {
        fn has(node: &Node, remainder: &str) -> bool {
            spelled(node) == remainder || node.children().any(|child| has(child, remainder))
        }
        let mut small = Small::default();
        for (reach, remainder, own) in &self.sizes.remainders {
            if reach.covers(at, 0) && sides.iter().any(|side| has(side, remainder)) {
                small = small.and(own);
            }
        }
        small
    }

    /// The role that is declared of a line. One that defines a letter is no role of what does not speak of this.
    pub(crate) fn role(&self, at: &At, sides: &[&Node]) -> Option<Role> {
        let speaks = |line: &LineRole| {
            let letter = line.defines.as_deref();
            letter.is_none_or(|letter| sides.iter().any(|side| stands_in(letter, side)))
        };
        let mut all = self.roles.iter().rev();
        let found = all.find(|line| line.reach.covers(at, 0) && speaks(line));
        found.and_then(|line| line.role)
    }

    /// Whether nothing but that a line holds at one instant makes it given.
    pub(crate) fn is_given_at_start(&self, at: &At) -> bool {
        let own = self.roles.iter().filter(|line| line.reach.covers(at, 0));
        self.instants.at(at).is_some() && own.count() == 1
    }

    /// Whether a sentence says that lines define a letter, and no line at this place.
    pub(crate) fn is_defined_elsewhere(&self, letter: &str, at: &At) -> bool {
        let defines = |line: &&LineRole| line.defines.as_deref() == Some(letter);
        let mut own = self.roles.iter().filter(defines).peekable();
        own.peek().is_some() && !own.any(|line| line.reach.covers(at, 0))
    }

    /// Whether a sentence says that lines at this place define a letter.
    pub(crate) fn is_defined_at(&self, letter: &str, at: &At) -> bool {
        let own = |line: &LineRole| line.reach.covers(at, 0);
        let mut all = self.roles.iter();
        all.any(|line| line.defines.as_deref() == Some(letter) && own(line))
    }

    /// For which part of the document a line holds that was accepted at a place. What is assumed tells nothing of what
    /// stands before, unless a sentence says where it holds.
    pub(crate) fn reach_of_line(&self, at: &At, assumed: bool) -> Reach {
        if let Some((_, reach)) = self.held.iter().find(|(lines, _)| lines.covers(at, 0)) {
            return reach.clone();
        }
        // What is assumed under a premise of a part of the document ends with that part.
        let mut reach = match assumed {
            true => Reach::From {
                cell: at.cell,
                line: at.line,
            },
            false => Reach::All,
        };
        for premise in self.taken.iter().map(|&i| &self.premises[i].reach) {
            if *premise != Reach::All && !reach.holds(premise) {
                reach = match reach {
                    Reach::All => premise.clone(),
                    other => Reach::Both(Box::new(other), Box::new(premise.clone())),
                };
            }
        }
        reach
    }

    /// The premises that reach a place.
    pub(crate) fn active_premises(&self, at: &At) -> Vec<usize> {
        let reaching = self
            .premises
            .iter()
            .enumerate()
            .filter(|(_, p)| p.reach.covers(at, 0));
        reaching.map(|(index, _)| index).collect()
    }

    /// The premises in force, those of the whole document first.
    pub(crate) fn premises_in_force(&self) -> Vec<(Fraction, Source)> {
        let mut premises: Vec<&Premise> = self.taken.iter().map(|&i| &self.premises[i]).collect();
        premises.sort_by_key(|p| p.reach.narrowness());
        premises
            .into_iter()
            .map(|p| (p.equation.clone(), p.source.clone()))
            .collect()
    }
}

/// Whether a formula has a part that is written so in LaTeX.
fn stands_in(letter: &str, node: &Node) -> bool {
    latex(node) == letter || node.children().any(|child| stands_in(letter, child))
}
