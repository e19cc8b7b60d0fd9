//! The small language in which people say what a document means.
//!
//! `lexicon` reads the words from a file of data, `words` parts a sentence, `reader` goes along it, `phrase`,
//! `hanging`, `gaps`, `extent`, `sign`, `roles`, `subjects`, `predicate`, `decide` and `clause` are the grammar, `bodies` finds
//! the bodies that a text introduces. `rewrite`, `reorder`, `ellipsis`, `anaphora` and `told_apart` bring other wordings to the
//! plain one before the grammar reads them. `declare` reads many sentences, and what each leaves to the others is put in
//! afterwards: `kinds`, `introduce` and `plain_things` say what a name is, `owners`, `together` and `same` whose a quantity is,
//! `entries` what stands in arrays, `named_members` which member has which name, `named_groups` which things a plural
//! means, `hinges`, `places`, `sides`, `body_axes` and `mounted` where points and axes of bodies are, `turns` how they turn, `weights` the letter of
//! gravity. `kept` and `unread` find what still holds of a sentence that is not understood and what it may change,
//! `terms` lists what a statement speaks of, `print` writes statements as sentences again and `manual` tells people
//! about all of it. English stands nowhere else.

mod absences;
mod absolute_motions;
mod across_planes;
mod acting;
pub(crate) mod adjectives;
mod anaphora;
mod angles_about;
mod angles_told;
mod appositions;
mod asides;
mod at_zero;
mod at_zero_placed;
mod attachments;
mod axes_by_number;
mod axes_by_vectors;
mod bases;
mod bodies;
mod body_axes;
mod body_words;
mod both;
mod capital_names;
pub(crate) mod centres;
mod chain_letters;
mod chains;
mod clause;
mod components_along;
mod compound_names;
mod constancy;
mod contacts;
mod coordinates;
mod corners;
mod corresponding;
mod counted;
mod counted_by_name;
pub(crate) mod cues;
mod decide;
mod declare;
mod directed_loads;
mod disturbed;
pub(crate) mod either;
mod element_places;
mod ellipsis;
mod ends_by_names;
mod entries;
mod every_axis;
mod extent;
mod family_loads;
mod family_places;
mod first_rotations;
mod fixed_axes;
mod fixed_in;
mod flat_bodies;
mod floors;
mod forms;
mod frames_by_adjective;
mod frames_by_nodes;
mod frames_shown;
mod gaps;
mod gathered_sizes;
mod generalised_momenta;
mod gyration;
mod hanging;
mod headings;
pub(crate) mod heads;
mod hinges;
mod hung_ends;
mod hung_on_pulleys;
mod hung_rods;
mod impacts;
mod implied;
mod in_lists;
mod in_turn;
mod inclinations;
mod inclined_frames;
pub(crate) mod indexed_lists;
mod introduce;
mod joined_formulas;
mod kept;
mod kept_sizes;
mod kinds;
mod laid_by_angles;
mod laid_rods;
mod letters_at_instants;
mod letters_by_nouns;
mod level_axes;
mod lexicon;
mod listed;
mod listed_between;
mod listed_loads;
mod load_clauses;
mod loaded_bodies;
mod manual;
mod meeting_axes;
mod member_wheels;
mod members;
pub(crate) mod messages;
mod motor_reactions;
mod mounted;
mod moving_planes;
mod named_groups;
mod named_members;
mod named_places;
mod named_things;
mod nicknames;
mod numbered_frames;
mod on_lines;
mod on_rings;
mod one_spring;
mod one_thing;
mod origins;
mod oscillations;
mod other_components;
mod other_loads;
mod own_notation;
mod owners;
mod parallel_frames;
mod parts_by_plural;
pub(crate) mod phrase;
mod placed_by_formula;
mod placed_centres;
mod placed_points;
mod placeholders;
mod places;
mod plain_letters;
mod plain_terms;
mod plain_things;
mod planar;
mod planar_axes;
mod planar_lines;
mod plane_turns;
mod planets;
mod possessions;
mod predicate;
mod print;
mod pulleys;
mod pulleys_on_axes;
mod quoted_words;
pub(crate) mod rate_letters;
mod rate_matrices;
mod rates_behind;
mod reader;
mod remaining_loads;
mod reminders;
mod reorder;
mod respective;
mod rewrite;
mod rewrite_rules;
mod rigid_wholes;
mod roles;
mod rolling_inside;
mod said_otherwise;
mod same;
mod same_lines;
mod senses;
mod sentence_parts;
mod sentence_words;
mod set_off;
mod sides;
mod sign;
mod single_moments;
mod sizes_aside;
mod slopes;
mod spherical_angles;
mod spin_axes;
mod spins;
pub(crate) mod spoken_conditions;
pub mod statement;
mod straight_ways;
mod subjects;
mod suspended;
pub(crate) mod terms;
mod the_axis;
mod there;
mod times;
mod together;
mod told_acting;
mod told_anew;
mod told_apart;
mod told_in_parts;
mod told_loads;
mod told_sizes;
mod told_there_alone;
mod told_vectors;
pub(crate) mod traits;
mod triads;
mod turn_clauses;
mod turned_frames;
mod turned_lines;
mod turned_triads;
mod turned_vectors;
mod turns;
mod understand;
mod unknown_bodies;
mod unread;
mod unsaying;
mod unwound;
mod unwound_beside;
mod upright_normals;
mod values_at_which;
mod vectors_by_components;
mod vectors_by_sums;
mod verticals;
pub(crate) mod wants;
mod weights;
mod wholes_by_plurals;
mod words;
mod wound;
mod written_signs;

pub use declare::{read_declarations, read_sentence};
pub use lexicon::Lexicon;
pub use manual::manual;
pub use print::sentence;
#[doc(hidden)]
pub use rewrite::idle_rules;
use traits::Trait;

/// Whether only bodies have what a noun means: a momentum, an inertia.
pub(crate) fn is_bodily(noun: &str) -> bool {
    let entry = Lexicon::shared().entry(noun, &[lexicon::Class::Noun]);
    entry.is_some_and(|entry| entry.traits.has(Trait::Bodily))
}

/// Whether a noun means a body or a part of one.
pub(crate) fn is_body(noun: &str) -> bool {
    Lexicon::shared()
        .entry(noun, &[lexicon::Class::Thing])
        .is_some()
}

/// The first form of the noun of a body.
pub(crate) fn body_noun(noun: &str) -> Option<&'static str> {
    let entry = Lexicon::shared().entry(noun, &[lexicon::Class::Thing]);
    entry.map(|entry| entry.name)
}

/// Whether a noun means what acts on bodies.
pub(crate) fn is_load(noun: &str) -> bool {
    let entry = Lexicon::shared().entry(noun, &[lexicon::Class::Noun]);
    entry.is_some_and(lexicon::Entry::is_load)
}

/// Whether a noun means a thing of the system: a frame, a point, a body.
pub(crate) fn is_thing(noun: &str) -> bool {
    let things = [lexicon::Class::Place, lexicon::Class::Thing];
    Lexicon::shared().entry(noun, &things).is_some()
}

/// Whether a noun says what quantity a letter is, and no more than that.
pub(crate) fn only_names(noun: &str) -> bool {
    let entry = Lexicon::shared().entry(noun, &[lexicon::Class::Noun]);
    entry.is_some_and(lexicon::Entry::only_names)
}

/// Whether a noun means a quantity.
pub(crate) fn is_quantity(noun: &str) -> bool {
    Lexicon::shared()
        .entry(noun, &[lexicon::Class::Noun])
        .is_some()
}
