//! What a sentence says: as it stands, in plainer words, in another order, or parted where it joins clauses.

use super::anaphora::{with_it_inside, with_its};
use super::asides::asides_apart;
use super::clause::Said;
use super::ellipsis::{joint_weakness, parted_at};
use super::fixed_in::fixed_in_named;
use super::in_lists::{join_adjectives, tell_listed_apart};
use super::lexicon::Lexicon;
use super::load_clauses::loads_apart;
use super::placeholders::with_letter_inside;
use super::reminders::reminded_at_start;
use super::reorder::{
    axes, compounds, described_first, indexed_by_any, possessives, tell_ends_of_lines, told_beside,
    without_brackets, without_ranges,
};
use super::respective::each_with_its_own;
use super::rewrite::{plainly, said_first};
use super::set_off::{front_behind_subject, fronted, without_commas};
use super::statement::Misread;
use super::told_apart::told_apart;
use super::turn_clauses::{turns_apart, turns_named};
use super::values_at_which::value_at_which;
use super::words::{Kind, Token};
use std::collections::BTreeSet;

/// A sentence of more words is not parted.
const LONGEST_JOINED: usize = 120;

/// A sentence is parted in so many ways at most.
const MOST_PARTINGS: usize = 150;

/// So many ways to say a sentence are taken further, and so many are read, at most.
const MOST_TAKEN: usize = 8;
const MOST_READ: usize = 80;

/// Where the grammar did not go on.
pub(crate) struct Stuck {
    pub(crate) error: Misread,
    /// How many words are left from there on.
    pub(crate) left: usize,
}

/// A way to say a sentence that the grammar does not understand.
struct Way {
    tokens: Vec<Token>,
    stuck: Stuck,
}

/// A sentence has so many asides in each other at most.
const DEEPEST: usize = 3;

/// What a sentence says as it stands, or with what it says aside as sentences of their own.
pub(crate) fn understood(
    tokens: &[Token],
    lexicon: &Lexicon,
    strictly: &impl Fn(&[Token]) -> Result<Vec<Said>, Stuck>,
) -> Result<Vec<Said>, Misread> {
    understood_apart(tokens, DEEPEST, lexicon, strictly)
}

fn understood_apart(
    tokens: &[Token],
    deep: usize,
    lexicon: &Lexicon,
    strictly: &impl Fn(&[Token]) -> Result<Vec<Said>, Stuck>,
) -> Result<Vec<Said>, Misread> {
    let clauses = |way: &[Token]| {
        let clauses = way.split(|t| t.kind == Kind::Semicolon);
        let said = clauses.map(|clause| understood_apart(clause, deep - 1, lexicon, strictly));
        said.collect::<Result<Vec<_>, _>>().ok()
    };
    let apart = || {
        let ways = match deep {
            0 => vec![],
            _ => asides_apart(tokens, lexicon),
        };
        let said = ways.iter().find_map(|way| clauses(way));
        said.map(|said| said.concat())
    };
    understood_whole(tokens, lexicon, strictly, apart)
}

/// What a sentence says. The ways to say it are tried from the one on of which the grammar leaves the fewest words.
fn understood_whole(
    tokens: &[Token],
    lexicon: &Lexicon,
    strictly: &impl Fn(&[Token]) -> Result<Vec<Said>, Stuck>,
    apart: impl Fn() -> Option<Vec<Said>>,
) -> Result<Vec<Said>, Misread> {
    let said = said_first(tokens).or_else(|| with_letter_inside(tokens));
    let tokens = said.as_deref().unwrap_or(tokens);
    let reminded =
        reminded_at_start(tokens, lexicon).or_else(|| each_with_its_own(tokens, lexicon));
    let tokens = reminded.as_deref().unwrap_or(tokens);
    let told = loads_apart(tokens, lexicon)
        .or_else(|| turns_named(tokens))
        .or_else(|| fixed_in_named(tokens));
    let tokens = told.as_deref().unwrap_or(tokens);
    let first = match strictly(tokens) {
        Ok(said) => return Ok(said),
        Err(stuck) => stuck.error,
    };
    let turns = turns_apart(tokens, lexicon);
    let tokens = turns.as_deref().unwrap_or(tokens);
    if let Some(Ok(said)) = turns.as_deref().map(strictly) {
        return Ok(said);
    }
    if tokens.len() > LONGEST_JOINED {
        return apart().ok_or(first);
    }
    let told = value_at_which(tokens);
    let tokens = told.as_deref().unwrap_or(tokens);
    let ordered = compounds(&possessives(&axes(tokens), lexicon), lexicon);
    let listed = tell_ends_of_lines(&join_adjectives(&ordered, lexicon));
    let tokens = plainly(&tell_listed_apart(&listed).unwrap_or(listed));
    let stuck = match strictly(&tokens) {
        Ok(said) => return Ok(said),
        Err(stuck) => stuck,
    };
    let ways = match said_otherwise(Way { tokens, stuck }, lexicon, strictly) {
        Ok(said) => return Ok(said),
        Err(ways) => ways,
    };
    if let Some(said) = apart() {
        return Ok(said);
    }
    for mut now in ways {
        let mut left = MOST_PARTINGS;
        loop {
            match parted_further(&now, lexicon, strictly, &mut left) {
                Parted::Understood(said) => return Ok(said),
                Parted::Further(next) => now = next,
                Parted::Stuck => break,
            }
        }
    }
    Err(first)
}

/// What a sentence says in another way; else the one that was given, and those of which the grammar leaves the fewest words.
fn said_otherwise(
    given: Way,
    lexicon: &Lexicon,
    strictly: &impl Fn(&[Token]) -> Result<Vec<Said>, Stuck>,
) -> Result<Vec<Said>, Vec<Way>> {
    let mut seen = BTreeSet::from([words(&given.tokens)]);
    let mut ways = vec![given];
    let mut read = 0;
    for taken in 0..MOST_TAKEN {
        let Some(way) = ways.get(taken) else {
            break;
        };
        for other in other_ways(&way.tokens.clone(), lexicon) {
            if read == MOST_READ {
                break;
            }
            let tokens = plainly(&other);
            if !seen.insert(words(&tokens)) {
                continue;
            }
            read += 1;
            match strictly(&tokens) {
                Ok(said) => return Ok(said),
                Err(stuck) => ways.push(Way { tokens, stuck }),
            }
        }
        ways[taken + 1..].sort_by_key(|way| way.stuck.left);
    }
    ways[1..].sort_by_key(|way| way.stuck.left);
    ways.truncate(MOST_PARTED);
    Err(ways)
}

/// So many ways to say a sentence are parted.
const MOST_PARTED: usize = 2;

fn words(tokens: &[Token]) -> Vec<String> {
    tokens.iter().map(|token| token.text.clone()).collect()
}

/// The sentence in another order of words, or with its clauses told apart.
fn other_ways(tokens: &[Token], lexicon: &Lexicon) -> Vec<Vec<Token>> {
    let others = [
        told_apart(tokens, lexicon),
        Some(without_brackets(tokens)),
        without_ranges(tokens),
        indexed_by_any(tokens),
        described_first(tokens, lexicon),
        told_beside(tokens, lexicon),
        with_its(tokens, lexicon),
        with_it_inside(tokens, lexicon),
    ];
    let others = others.into_iter().flatten();
    let ordered = [
        fronted(tokens, lexicon),
        without_commas(tokens, lexicon),
        front_behind_subject(tokens, lexicon),
    ];
    others.chain(ordered.into_iter().flatten()).collect()
}

/// What parting a sentence at one more place brought.
enum Parted {
    Understood(Vec<Said>),
    /// It is read further, to another error.
    Further(Way),
    Stuck,
}

/// Parts a sentence at each place where it may join clauses, until it is understood.
fn parted_further(
    now: &Way,
    lexicon: &Lexicon,
    strictly: &impl Fn(&[Token]) -> Result<Vec<Said>, Stuck>,
    left: &mut usize,
) -> Parted {
    let mut joints: Vec<usize> = (0..now.tokens.len()).rev().collect();
    // Where clauses are joined by a word they part sooner than at a comma, which may be one of a list.
    joints.sort_by_key(|&at| joint_weakness(&now.tokens, at));
    let mut further: Option<Way> = None;
    let joints = joints.into_iter();
    for candidate in joints.flat_map(|at| parted_at(&now.tokens, at, lexicon)) {
        let Some(fewer) = left.checked_sub(1) else {
            return Parted::Stuck;
        };
        *left = fewer;
        let tokens = plainly(&candidate);
        match strictly(&tokens) {
            Ok(said) if said.iter().all(|(_, statement)| statement.says_something()) => {
                return Parted::Understood(said);
            }
            Err(stuck) => {
                let best = further.as_ref().unwrap_or(now);
                if stuck.left < best.stuck.left {
                    further = Some(Way { tokens, stuck });
                }
            }
            Ok(_) => {}
        }
    }
    further.map_or(Parted::Stuck, Parted::Further)
}
