//! What sentences say in the terms that the model has: one pass after another, each brings one way to say a thing to the plain one.

use super::absolute_motions::tell_absolute_motions;
use super::across_planes::name_axes_across;
use super::angles_about::place_by_angles;
use super::at_zero::tell_axes_at_zero;
use super::at_zero_placed::place_at_zero;
use super::axes_by_number::name_axes_by_number;
use super::axes_by_vectors::name_axes_by_vectors;
use super::body_axes::{end_the_same, fix_pivots, part_centres, tell_normals, turn_to_frames};
use super::centres::centre_shapes;
use super::components_along::{take_across_planes, take_along_axes};
use super::constancy::tell_constants;
use super::contacts::{place_contact_forces, tell_contacts};
use super::coordinates::tell_coordinates;
use super::corners::place_corners;
use super::counted::{lay_in_turn, number_counted, part_first};
use super::directed_loads::direct_loads;
use super::disturbed::tell_disturbed;
use super::element_places::{place_elements, tell_places_of_particles};
use super::ends_by_names::end_by_names;
use super::entries::{tell_entries, tell_parts};
use super::family_loads::tell_loads_of_families;
use super::fixed_axes::name_fixed_axes;
use super::flat_bodies::turn_in_own_planes;
use super::floors::lay_floors;
use super::frames_by_adjective::{fix_body_frames, fix_carried_frames, tell_body_frames};
use super::frames_shown::show_frames;
use super::gathered_sizes::gather_sizes;
use super::generalised_momenta::tell_generalised_momenta;
use super::gyration::tell_gyration;
use super::hinges::{name_ends, tell_hinges};
use super::hung_rods::{lay_hung_rods, name_rod_lines};
use super::impacts::{hang_at_impact, place_what_strikes};
use super::in_turn::{part_letters, part_respectively};
use super::indexed_lists::part_indexed;
use super::introduce::introduce;
use super::kept_sizes::keep_sizes;
use super::kinds::{
    fix_frames, name_numbered, name_positions, name_the_only_one, place_particles, shape_by_name,
    tell_axes, tell_mass_centres,
};
use super::laid_by_angles::lay_by_angles;
use super::laid_rods::fix_ends;
use super::letters_at_instants::tell_letters_at_instants;
use super::letters_by_nouns::say_of_letters;
use super::level_axes::{name_level_axes, tell_axes_that_point_down};
use super::lexicon::Lexicon;
use super::listed_between::{list_next_loads, name_by_agents};
use super::listed_loads::act_as_listed;
use super::meeting_axes::fix_meeting_points;
use super::member_wheels::turn_members;
use super::motor_reactions::tell_reactions_of_motors;
use super::mounted::mount_wheels;
use super::moving_planes::carry_planes;
use super::named_groups::name_groups;
use super::named_members::name_members;
use super::numbered_frames::name_frames_by_numbers;
use super::on_lines::place_on_lines;
use super::on_rings::place_on_rings;
use super::one_spring::name_the_only_spring;
use super::origins::{name_origins, take_axes_through_origins};
use super::oscillations::name_oscillations;
use super::own_notation::tell_own_notation;
use super::owners::{give_to_bodies, say_of_loads};
use super::parallel_frames::tell_parallel_frames;
use super::parts_by_plural::tell_parts_by_plural;
use super::placed_by_formula::place_by_formulas;
use super::placed_centres::name_placed_centres;
use super::placed_points::name_placed_points;
use super::places::{begin_rods, tell_places, tell_reach};
use super::plain_letters::{name_bodies, write_letters};
use super::plain_things::{
    hang_on_quantities, name_plainly, say_of_things, tell_named_things, tell_upright_axes,
};
use super::planar::turn_in_planes;
use super::plane_turns::turn_across_planes;
use super::planets::place_planets;
use super::pulleys::hang_on_pulleys;
use super::pulleys_on_axes::hang_beside_axes;
use super::rates_behind::give_rates_behind;
use super::remaining_loads::list_remaining_loads;
use super::rigid_wholes::fix_particles;
use super::rolling_inside::tell_distances_of_rollers;
use super::said_otherwise::say_plainly;
use super::same::{
    leave_long_names, name_by_formulas, share_owners, tell_columns, tell_relations, tell_the_same,
};
use super::senses::tell_senses;
use super::sides::tell_sides;
use super::single_moments::tell_single_moments;
use super::sizes_aside::give_sizes_aside;
use super::slopes::lay_slopes;
use super::spin_axes::name_spin_axes;
use super::spins::turn_about_axes_of_symmetry;
use super::statement::Declaration;
use super::straight_ways::move_on_lines;
use super::suspended::tell_suspended;
use super::together::join_together;
use super::told_anew::part_points_told_anew;
use super::told_in_parts::say_in_parts;
use super::told_there_alone::tell_frames_of_parts;
use super::told_vectors::{turn_about_told_vectors, turn_about_ways, turn_at_told_rates};
use super::triads::name_triads;
use super::turned_lines::turn_lines;
use super::turns::{tell_matrices, tell_turning, turn_by_aircraft_angles, turn_in_order};
use super::unknown_bodies::leave_unknown_bodies;
use super::unwound::unwind_strings;
use super::unwound_beside::unwind_beside_axes;
use super::upright_normals::tell_upright_normals;
use super::vectors_by_sums::tell_vectors_by_sums;
use super::weights::tell_gravity;
use super::wholes_by_plurals::join_uncounted;
use crate::notation::Macros;

/// What sentences say, in the terms that the model has: each thing by one name, letters as formulas.
pub(crate) fn in_plain_terms(
    declarations: Vec<Declaration>,
    macros: &Macros,
    lexicon: &Lexicon,
) -> Vec<Declaration> {
    let mut declarations = name_things(declarations, macros, lexicon);
    tell_turns(&mut declarations, macros);
    tell_reactions_of_motors(&mut declarations);
    name_the_only_spring(&mut declarations);
    tell_loads_of_families(&mut declarations, macros);
    count_members(&mut declarations);
    place_points(&mut declarations, macros);
    tell_loads(&mut declarations, macros);
    tell_axes(&mut declarations);
    name_axes_across(&mut declarations);
    tell_ends(&mut declarations, macros);
    move_along_lines(&mut declarations, macros);
    tell_gyration(&mut declarations, macros);
    name_oscillations(&mut declarations, macros);
    fix_frames(&mut declarations);
    tell_shapes(&mut declarations, lexicon);
    show_frames(&mut declarations);
    introduce(&mut declarations);
    name_the_only_one(&mut declarations, lexicon);
    tell_mass_centres(&mut declarations);
    turn_about_axes(&mut declarations);
    tell_generalised_momenta(&mut declarations);
    part_points_told_anew(&mut declarations);
    say_in_parts(declarations)
}

/// Letters and names, and whose each quantity is.
fn name_things(
    mut declarations: Vec<Declaration>,
    macros: &Macros,
    lexicon: &Lexicon,
) -> Vec<Declaration> {
    say_of_letters(&mut declarations);
    give_sizes_aside(&mut declarations);
    fix_carried_frames(&mut declarations);
    fix_body_frames(&mut declarations);
    tell_body_frames(&mut declarations);
    tell_letters_at_instants(&mut declarations);
    take_along_axes(&mut declarations);
    take_across_planes(&mut declarations);
    tell_senses(&mut declarations, macros);
    list_next_loads(&mut declarations);
    name_by_agents(&mut declarations);
    tell_own_notation(&mut declarations);
    name_frames_by_numbers(&mut declarations, macros);
    name_axes_by_number(&mut declarations);
    tell_coordinates(&mut declarations, macros);
    name_origins(&mut declarations);
    take_axes_through_origins(&mut declarations);
    tell_frames_of_parts(&mut declarations);
    tell_parallel_frames(&mut declarations);
    part_indexed(&mut declarations, macros);
    let respectively = part_first(part_respectively(declarations));
    declarations = turn_in_order(part_centres(part_letters(respectively)));
    write_letters(&mut declarations, lexicon, macros);
    name_bodies(&mut declarations);
    join_uncounted(&mut declarations);
    say_of_things(&mut declarations);
    hang_on_quantities(&mut declarations);
    tell_disturbed(&mut declarations);
    tell_single_moments(&mut declarations);
    gather_sizes(&mut declarations);
    give_rates_behind(&mut declarations);
    tell_vectors_by_sums(&mut declarations);
    tell_upright_normals(&mut declarations);
    tell_normals(&mut declarations);
    end_the_same(&mut declarations);
    tell_absolute_motions(&mut declarations);
    share_owners(&mut declarations);
    tell_the_same(&mut declarations);
    tell_columns(&mut declarations);
    leave_long_names(&mut declarations);
    name_by_formulas(&mut declarations);
    tell_relations(&mut declarations);
    say_plainly(&mut declarations, macros);
    leave_unknown_bodies(&mut declarations);
    turn_about_told_vectors(&mut declarations, macros);
    declarations
}

/// Turns of frames and bodies, and the axes about which they turn.
fn tell_turns(declarations: &mut Vec<Declaration>, macros: &Macros) {
    tell_axes(declarations);
    place_by_angles(declarations, macros);
    name_triads(declarations);
    turn_at_told_rates(declarations);
    tell_turning(declarations);
    tell_matrices(declarations);
    name_plainly(declarations);
    say_of_loads(declarations);
    name_axes_by_vectors(declarations);
    name_fixed_axes(declarations, macros);
    tell_upright_axes(declarations);
    carry_planes(declarations);
    lay_floors(declarations);
    tell_contacts(declarations);
}

/// Members of families, by their numbers and names.
fn count_members(declarations: &mut Vec<Declaration>) {
    name_groups(declarations);
    name_members(declarations);
    place_elements(declarations);
    tell_places_of_particles(declarations);
    number_counted(declarations);
    name_spin_axes(declarations);
    fix_particles(declarations);
    lay_in_turn(declarations);
}

/// Points by the things and sides where they lie.
fn place_points(declarations: &mut Vec<Declaration>, macros: &Macros) {
    name_placed_points(declarations);
    tell_named_things(declarations);
    tell_places(declarations);
    tell_reach(declarations);
    tell_sides(declarations);
    place_corners(declarations, macros);
}

/// Loads and constants, and the positions of particles.
fn tell_loads(declarations: &mut Vec<Declaration>, macros: &Macros) {
    place_contact_forces(declarations);
    direct_loads(declarations, macros);
    tell_parts_by_plural(declarations);
    give_to_bodies(declarations);
    list_remaining_loads(declarations);
    act_as_listed(declarations);
    join_together(declarations);
    tell_gravity(declarations);
    turn_by_aircraft_angles(declarations);
    tell_constants(declarations);
    name_positions(declarations);
    place_by_formulas(declarations);
    place_particles(declarations);
    name_numbered(declarations);
}

/// Bodies by their shapes, and entries of their tensors.
fn tell_shapes(declarations: &mut Vec<Declaration>, lexicon: &Lexicon) {
    shape_by_name(declarations, lexicon);
    centre_shapes(declarations);
    tell_parts(declarations);
    tell_entries(declarations);
    keep_sizes(declarations);
}

/// Where bodies end, and where they are joined.
fn tell_ends(declarations: &mut Vec<Declaration>, macros: &Macros) {
    turn_about_ways(declarations, macros);
    place_planets(declarations, macros);
    let downward = hang_at_impact(declarations, macros);
    tell_axes_that_point_down(declarations);
    name_level_axes(declarations);
    tell_axes_at_zero(declarations);
    place_at_zero(declarations);
    tell_hinges(declarations);
    name_ends(declarations);
    end_by_names(declarations);
    fix_ends(declarations);
    lay_by_angles(declarations, macros);
    lay_hung_rods(declarations, macros);
    place_what_strikes(declarations, &downward, macros);
    begin_rods(declarations, macros);
    name_rod_lines(declarations);
    name_placed_centres(declarations);
}

/// What turns about the axes of frames and bodies, and what is fixed there.
fn turn_about_axes(declarations: &mut Vec<Declaration>) {
    fix_meeting_points(declarations);
    turn_members(declarations);
    mount_wheels(declarations);
    turn_to_frames(declarations);
    fix_pivots(declarations);
    turn_about_axes_of_symmetry(declarations);
}

/// What slides, hangs and turns in a plane gets its place and its turn by the lines that sentences speak of.
fn move_along_lines(declarations: &mut Vec<Declaration>, macros: &Macros) {
    move_on_lines(declarations);
    lay_slopes(declarations);
    unwind_beside_axes(declarations, macros);
    unwind_strings(declarations, macros);
    hang_beside_axes(declarations, macros);
    hang_on_pulleys(declarations, macros);
    place_on_lines(declarations);
    place_on_rings(declarations);
    tell_suspended(declarations, macros);
    tell_distances_of_rollers(declarations, macros);
    turn_lines(declarations, macros);
    turn_in_planes(declarations, macros);
    turn_in_own_planes(declarations);
    turn_across_planes(declarations);
}
