//! Declarations: sentences that an author writes, one a line.

use super::absences::{part_absences, tell_absences};
use super::anaphora::{referring, with_it_inside, with_its};
use super::bodies::introduced;
use super::both::{Kinds, counting_letters, tell_both, tell_each};
use super::capital_names::keep_capitals;
use super::clause::Said;
use super::compound_names::Compounds;
use super::ellipsis::{joint_weakness, parted_at};
use super::in_lists::{join_adjectives, tell_listed_apart};
use super::kept::{kept, may_be_limited, speak_of_subjects};
use super::lexicon::Lexicon;
use super::plain_terms::in_plain_terms;
use super::reader::Reader;
use super::reorder::{
    axes, compounds, described_first, fronted, indexed_by_any, possessives, tell_ends_of_lines,
    told_beside, without_brackets, without_ranges,
};
use super::rewrite::plainly;
use super::same_lines::on_same_lines;
use super::statement::{Declaration, Extent, Misread, Statement, Touched};
use super::there::say_where;
use super::told_apart::told_apart;
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
    say_where(&mut parted, lexicon, macros);
    let understood = parted.iter().filter_map(|tokens| tokens.as_deref().ok());
    let bodies = introduced(understood, lexicon);
    name_by_kinds(&mut parted, lexicon);
    let (mut declarations, mut misread) = (vec![], vec![]);
    let mut before: Vec<&[Token]> = vec![];
    for ((line, sentence), tokens) in sentences.iter().zip(&parted) {
        let line = *line;
        let reader = |tokens: &[Token]| read(tokens, sentence, line, macros, lexicon, &bodies);
        let said = match tokens {
            Ok(tokens) => {
                let said = reader(tokens).or_else(|error| {
                    let others = reminding(tokens, &before, lexicon, macros);
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
    tell_absences(&mut declarations);
    (in_plain_terms(declarations, macros, lexicon), misread)
}

/// The sentence with what others said before in the place of the words that remind of it, each reading on its own.
fn reminding(
    tokens: &[Token],
    before: &[&[Token]],
    lexicon: &Lexicon,
    macros: &Macros,
) -> Vec<Vec<Token>> {
    let last = before.last();
    let there = last.and_then(|before| on_same_lines(tokens, before, lexicon, macros));
    let meant = referring(&axes(tokens), before, lexicon);
    there.into_iter().chain(meant).collect()
}

/// Names bodies by what sentences together say of their kinds: "both gimbals", "each wheel", "the pendulum arm".
fn name_by_kinds(sentences: &mut [Result<Vec<Token>, Misread>], lexicon: &Lexicon) {
    let all = || sentences.iter().flatten().map(Vec::as_slice);
    let (counting, kinds) = (counting_letters(all()), Kinds::of(all()));
    let compounds = Compounds::of(all(), lexicon);
    for tokens in sentences.iter_mut().flatten() {
        if let Some(shorter) = compounds.shortened(tokens, lexicon) {
            *tokens = shorter;
        }
        let named = tell_both(tokens, &kinds).or_else(|| tell_each(tokens, &counting));
        if let Some(named) = named {
            *tokens = named;
        }
    }
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
    let ordered = compounds(&possessives(&axes(tokens), lexicon), lexicon);
    let listed = tell_ends_of_lines(&join_adjectives(&ordered, lexicon));
    let mut now = plainly(&tell_listed_apart(&listed).unwrap_or(listed));
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
