//! Declarations: sentences that an author writes, one a line.

use super::absences::part_absences;
use super::anaphora::{referring, with_it_inside, with_its};
use super::at_zero::tell_axes_at_zero;
use super::bodies::introduced;
use super::body_axes::{end_the_same, fix_pivots, part_centres, tell_normals, turn_to_frames};
use super::capital_names::keep_capitals;
use super::clause::Said;
use super::constancy::tell_constants;
use super::counted::{lay_in_turn, number_counted, part_first};
use super::disturbed::tell_disturbed;
use super::ellipsis::{joint_weakness, parted_at};
use super::entries::{tell_entries, tell_parts};
use super::fixed_axes::name_fixed_axes;
use super::flat_bodies::turn_in_own_planes;
use super::gyration::tell_gyration;
use super::hinges::{name_ends, tell_hinges};
use super::in_turn::{part_letters, part_respectively};
use super::introduce::introduce;
use super::kept::{kept, may_be_limited, speak_of_subjects};
use super::kinds::{
    centre_shapes, fix_frames, name_numbered, name_positions, name_the_only_one, place_particles,
    shape_by_name, show_frames, tell_axes, tell_mass_centres,
};
use super::lexicon::Lexicon;
use super::member_wheels::turn_members;
use super::mounted::mount_wheels;
use super::named_members::name_members;
use super::numbered_frames::name_frames_by_numbers;
use super::on_lines::place_on_lines;
use super::on_rings::place_on_rings;
use super::owners::{give_to_bodies, say_of_loads};
use super::placed_centres::name_placed_centres;
use super::placed_points::name_placed_points;
use super::places::{begin_rods, tell_places, tell_reach};
use super::plain_letters::{name_bodies, write_letters};
use super::plain_things::{
    hang_on_quantities, name_plainly, say_of_things, tell_named_things, tell_upright_axes,
};
use super::planar::turn_in_planes;
use super::reader::Reader;
use super::reorder::{
    axes, compounds, described_first, fronted, indexed_by_any, possessives, told_beside,
    without_brackets, without_ranges,
};
use super::rewrite::plainly;
use super::rigid_wholes::fix_particles;
use super::same::{
    leave_long_names, name_by_formulas, share_owners, tell_columns, tell_relations, tell_the_same,
};
use super::sides::tell_sides;
use super::spins::turn_about_axes_of_symmetry;
use super::statement::{Declaration, Extent, Misread, Statement, Touched};
use super::suspended::tell_suspended;
use super::together::join_together;
use super::told_apart::told_apart;
use super::told_in_parts::say_in_parts;
use super::turned_lines::turn_lines;
use super::turns::{tell_matrices, tell_turning, turn_by_aircraft_angles, turn_in_order};
use super::weights::tell_gravity;
use super::words::{Token, tokens, wrong};
use crate::notation::Macros;
use std::collections::BTreeSet;

/// A sentence longer than this is not read.
const LONGEST: usize = 10_000;

/// Reads the sentences of a text, one a line. Lines that begin with `#` are remarks. A sentence that is not understood
/// is among the declarations as such, beside what is wrong with it.
pub fn read_declarations(
    text: &str,
    macros: &Macros,
    lexicon: &Lexicon,
) -> (Vec<Declaration>, Vec<Misread>) {
    let lines = text
        .lines()
        .enumerate()
        .map(|(at, line)| (at + 1, line.trim_end()));
    let sentences = lines
        .filter(|(_, line)| !line.trim_start().is_empty() && !line.trim_start().starts_with('#'));
    let sentences: Vec<_> = sentences.collect();
    let parted = sentences.iter().map(|(line, text)| parted(text, *line));
    let mut parted: Vec<_> = parted.collect();
    keep_capitals(&mut parted);
    let understood = parted.iter().filter_map(|tokens| tokens.as_deref().ok());
    let bodies = introduced(understood, lexicon);
    let (mut declarations, mut misread) = (vec![], vec![]);
    let mut before: Vec<&[Token]> = vec![];
    for ((line, sentence), tokens) in sentences.iter().zip(&parted) {
        let line = *line;
        let reader = |tokens: &[Token]| read(tokens, sentence, line, macros, lexicon, &bodies);
        let said = match tokens {
            Ok(tokens) => {
                let said = reader(tokens).or_else(|error| {
                    let others = referring(tokens, &before, lexicon);
                    let read = others.iter().find_map(|other| reader(other).ok());
                    read.ok_or(error)
                });
                before.push(tokens);
                said
            }
            Err(error) => Err(error.clone()),
        };
        match said {
            Ok(said) => declarations.extend(said),
            Err(error) => {
                let tokens = tokens.as_deref().unwrap_or_default();
                let (kept, rest) = kept(tokens, &reader);
                if let Some(rest) = rest {
                    let from_start = rest.first() == tokens.first();
                    let limited = from_start && may_be_limited(rest);
                    let mut unread = unread(rest, limited, (sentence, line), macros, lexicon);
                    for part in &mut unread {
                        speak_of_subjects(part, &kept);
                    }
                    declarations.extend(unread);
                    misread.push(error);
                }
                declarations.extend(kept);
            }
        }
    }
    part_absences(&mut declarations);
    (in_plain_terms(declarations, macros, lexicon), misread)
}

/// What sentences say, in the terms that the model has: each thing by one name, letters as formulas.
fn in_plain_terms(
    mut declarations: Vec<Declaration>,
    macros: &Macros,
    lexicon: &Lexicon,
) -> Vec<Declaration> {
    name_frames_by_numbers(&mut declarations);
    let respectively = part_first(part_respectively(declarations));
    declarations = turn_in_order(part_centres(part_letters(respectively)));
    write_letters(&mut declarations, lexicon, macros);
    name_bodies(&mut declarations);
    say_of_things(&mut declarations);
    hang_on_quantities(&mut declarations);
    tell_disturbed(&mut declarations);
    tell_normals(&mut declarations);
    end_the_same(&mut declarations);
    share_owners(&mut declarations);
    tell_the_same(&mut declarations);
    tell_columns(&mut declarations);
    leave_long_names(&mut declarations);
    name_by_formulas(&mut declarations);
    tell_relations(&mut declarations);
    tell_turning(&mut declarations);
    tell_matrices(&mut declarations);
    name_plainly(&mut declarations);
    say_of_loads(&mut declarations);
    name_fixed_axes(&mut declarations, macros);
    tell_upright_axes(&mut declarations);
    name_members(&mut declarations);
    number_counted(&mut declarations);
    fix_particles(&mut declarations);
    lay_in_turn(&mut declarations);
    name_placed_points(&mut declarations);
    tell_named_things(&mut declarations);
    tell_places(&mut declarations);
    tell_reach(&mut declarations);
    tell_sides(&mut declarations);
    give_to_bodies(&mut declarations);
    join_together(&mut declarations);
    tell_gravity(&mut declarations);
    turn_by_aircraft_angles(&mut declarations);
    tell_constants(&mut declarations);
    name_positions(&mut declarations);
    place_particles(&mut declarations);
    name_numbered(&mut declarations);
    tell_axes(&mut declarations);
    tell_ends(&mut declarations, macros);
    move_along_lines(&mut declarations, macros);
    tell_gyration(&mut declarations, macros);
    fix_frames(&mut declarations);
    shape_by_name(&mut declarations, lexicon);
    centre_shapes(&mut declarations);
    tell_parts(&mut declarations);
    tell_entries(&mut declarations);
    show_frames(&mut declarations);
    introduce(&mut declarations);
    name_the_only_one(&mut declarations, lexicon);
    tell_mass_centres(&mut declarations);
    turn_about_axes(&mut declarations);
    say_in_parts(declarations)
}

/// Where bodies end, and where they are joined.
fn tell_ends(declarations: &mut Vec<Declaration>, macros: &Macros) {
    tell_axes_at_zero(declarations);
    tell_hinges(declarations);
    name_ends(declarations);
    begin_rods(declarations, macros);
    name_placed_centres(declarations);
}

/// What turns about the axes of frames and bodies, and what is fixed there.
fn turn_about_axes(declarations: &mut Vec<Declaration>) {
    turn_members(declarations);
    mount_wheels(declarations);
    turn_to_frames(declarations);
    fix_pivots(declarations);
    turn_about_axes_of_symmetry(declarations);
}

/// What slides, hangs and turns in a plane gets its place and its turn by the lines that sentences speak of.
fn move_along_lines(declarations: &mut Vec<Declaration>, macros: &Macros) {
    place_on_lines(declarations);
    place_on_rings(declarations);
    tell_suspended(declarations, macros);
    turn_lines(declarations, macros);
    turn_in_planes(declarations, macros);
    turn_in_own_planes(declarations);
}

/// Reads one sentence. It makes several declarations where it speaks of several things or parts of the document.
pub fn read_sentence(
    sentence: &str,
    line: usize,
    macros: &Macros,
    lexicon: &Lexicon,
) -> Result<Vec<Declaration>, Misread> {
    let tokens = parted(sentence, line)?;
    let bodies = introduced(std::iter::once(tokens.as_slice()), lexicon);
    read(&tokens, sentence, line, macros, lexicon, &bodies)
}

fn parted(sentence: &str, line: usize) -> Result<Vec<Token>, Misread> {
    match sentence.len() > LONGEST {
        true => Err(wrong(
            line,
            1,
            "the sentence is too long",
            "say it in several",
        )),
        false => tokens(sentence, line),
    }
}

/// Words by which a list of parts of the document goes on.
const GOES_ON: [&str; 4] = ["and", "or", "but", "except"];

/// A sentence that is not understood: of which parts of the document, and of which letters it speaks.
fn unread(
    tokens: &[Token],
    may_be_limited: bool,
    (sentence, line): (&str, usize),
    macros: &Macros,
    lexicon: &Lexicon,
) -> Vec<Declaration> {
    let bodies = BTreeSet::new();
    let mut reader = Reader::new(tokens, (line, 1), lexicon, macros, &bodies);
    // What is said of lines concerns these lines, and what follows from them elsewhere.
    let of_lines = reader.spoken_of().ok().flatten();
    let extents = of_lines.clone().or_else(|| {
        reader.at = 0;
        reader.extents().ok().filter(|extents| !extents.is_empty())
    });
    let mut extents = extents.unwrap_or_else(|| vec![Extent::Document]);
    let limited = extents != [Extent::Document] || may_be_limited;
    let touched = reader.touched(limited);
    // Parts that go on in words that are not understood may be anywhere.
    if GOES_ON.contains(&reader.word()) {
        extents = vec![Extent::Document];
    }
    let letters = reader.letters_told().unwrap_or_default();
    let of_extent = |extent, touched: &Touched| Declaration {
        statement: Statement::Unread {
            letters: letters.clone(),
            touched: touched.clone(),
        },
        extent,
        text: sentence.trim().to_owned(),
        line,
    };
    let no_letters = Touched::Letters {
        formulas: vec![],
        anew: false,
    };
    let elsewhere = of_lines.map(|_| of_extent(Extent::Document, &no_letters));
    let there = extents
        .into_iter()
        .map(|extent| of_extent(extent, &touched));
    there.chain(elsewhere).collect()
}

fn read(
    tokens: &[Token],
    sentence: &str,
    line: usize,
    macros: &Macros,
    lexicon: &Lexicon,
    bodies: &BTreeSet<String>,
) -> Result<Vec<Declaration>, Misread> {
    let end = (
        line,
        sentence.trim_end().trim_end_matches('.').chars().count() + 1,
    );
    let reader = |tokens| Reader::new(tokens, end, lexicon, macros, bodies);
    let mut before = reader(tokens);
    let extents = before.extents().map_or(0, |_| before.at);
    let (extents, clauses) = tokens.split_at(extents);
    let strictly = |clauses: &[Token]| {
        let tokens = [extents, clauses].concat();
        Reader::new(&tokens, end, lexicon, macros, bodies).sentence()
    };
    let said = understood(clauses, lexicon, &strictly)?;
    let declaration = |(extent, statement)| Declaration {
        statement,
        extent,
        text: sentence.trim().to_owned(),
        line,
    };
    Ok(said.into_iter().map(declaration).collect())
}

/// A sentence of more words is not parted.
const LONGEST_JOINED: usize = 120;

/// A sentence is read in so many ways at most.
const MOST_READINGS: usize = 150;

/// What a sentence says: as it stands, in plainer words, or parted where it joins clauses. Each step has to bring the
/// reader further along than the one before.
fn understood(
    tokens: &[Token],
    lexicon: &Lexicon,
    strictly: &impl Fn(&[Token]) -> Result<Vec<Said>, Misread>,
) -> Result<Vec<Said>, Misread> {
    let first = match strictly(tokens) {
        Ok(said) => return Ok(said),
        Err(error) => error,
    };
    if tokens.len() > LONGEST_JOINED {
        return Err(first);
    }
    let mut left = MOST_READINGS;
    let mut now = plainly(&compounds(&possessives(&axes(tokens), lexicon), lexicon));
    let mut error = match strictly(&now) {
        Ok(said) => return Ok(said),
        Err(error) => error,
    };
    let others = [
        told_apart(&now, lexicon),
        Some(without_brackets(&now)),
        without_ranges(&now),
        indexed_by_any(&now),
        described_first(&now, lexicon),
        told_beside(&now, lexicon),
        with_its(&now, lexicon),
        with_it_inside(&now, lexicon),
    ];
    for other in others.into_iter().flatten().chain(fronted(&now, lexicon)) {
        let other = plainly(&other);
        match strictly(&other) {
            Ok(said) => return Ok(said),
            Err(later) if later.column > error.column => (now, error) = (other, later),
            Err(_) => {}
        }
    }
    loop {
        match parted_further(&now, &error, lexicon, strictly, &mut left) {
            Parted::Understood(said) => return Ok(said),
            Parted::Further(next, later) => (now, error) = (next, later),
            Parted::Stuck => return Err(first),
        }
    }
}

/// What parting a sentence at one more place brought.
enum Parted {
    Understood(Vec<Said>),
    /// It is read further, to another error.
    Further(Vec<Token>, Misread),
    Stuck,
}

/// Parts a sentence at each place where it may join clauses, until it is understood.
fn parted_further(
    now: &[Token],
    error: &Misread,
    lexicon: &Lexicon,
    strictly: &impl Fn(&[Token]) -> Result<Vec<Said>, Misread>,
    left: &mut usize,
) -> Parted {
    let mut joints: Vec<usize> = (0..now.len()).rev().collect();
    // Where clauses are joined by a word they part sooner than at a comma, which may be one of a list.
    joints.sort_by_key(|&at| joint_weakness(now, at));
    let mut further: Option<(Vec<Token>, Misread)> = None;
    for candidate in joints
        .into_iter()
        .flat_map(|at| parted_at(now, at, lexicon))
    {
        let Some(fewer) = left.checked_sub(1) else {
            return Parted::Stuck;
        };
        *left = fewer;
        let candidate = plainly(&candidate);
        match strictly(&candidate) {
            Ok(said) if said.iter().all(|(_, statement)| statement.says_something()) => {
                return Parted::Understood(said);
            }
            Err(other) => {
                let best = further
                    .as_ref()
                    .map_or(error.column, |(_, best)| best.column);
                if other.column > best {
                    further = Some((candidate, other));
                }
            }
            Ok(_) => {}
        }
    }
    further.map_or(Parted::Stuck, |(next, later)| Parted::Further(next, later))
}
