//! Declarations: sentences that an author writes, one a line.

use super::absences::{part_absences, tell_absences};
use super::anaphora::referring;
use super::angles_told::tell_angles;
use super::attachments::join_attachments;
use super::bases::name_axes_to_bases;
use super::bodies::introduced;
use super::both::{Kinds, counting_letters, tell_both, tell_each};
use super::capital_names::keep_capitals;
use super::compound_names::Compounds;
use super::kept::{kept, may_be_limited, speak_of_subjects};
use super::lexicon::Lexicon;
use super::nicknames::name_by_letters;
use super::plain_terms::in_plain_terms;
use super::reader::Reader;
use super::reorder::axes;
use super::same_lines::on_same_lines;
use super::statement::{Declaration, Extent, Misread, Statement, Touched};
use super::there::say_where;
use super::understand::{Stuck, understood};
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
    let sentences = numbered_sentences(text);
    let parted = sentences.iter().map(|(line, text)| parted(text, *line));
    let mut parted: Vec<_> = parted.collect();
    keep_capitals(&mut parted);
    name_by_letters(&mut parted, lexicon);
    join_attachments(&mut parted);
    tell_angles(&mut parted);
    say_where(&mut parted, lexicon, macros);
    name_axes_to_bases(&mut parted);
    let understood = parted.iter().filter_map(|tokens| tokens.as_deref().ok());
    let mut bodies = introduced(understood.clone(), lexicon);
    let compounds = Compounds::of(understood, lexicon);
    bodies.extend(compounds.told_apart());
    name_by_kinds(&mut parted, &compounds, lexicon);
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

/// The sentences of a text, each with the number of its line.
fn numbered_sentences(text: &str) -> Vec<(usize, String)> {
    let lines = text
        .lines()
        .enumerate()
        .map(|(at, line)| (at + 1, line.trim_end()));
    let told = lines
        .filter(|(_, line)| !line.trim_start().is_empty() && !line.trim_start().starts_with('#'));
    let sentences = told.flat_map(|(line, text)| {
        let each = sentences_of(text).into_iter();
        each.map(move |sentence| (line, sentence))
    });
    sentences.collect()
}

/// The sentences of a line, each at its place: what stands before it is blank.
fn sentences_of(line: &str) -> Vec<String> {
    if line.len() > LONGEST {
        return vec![line.to_owned()];
    }
    let mut sentences = vec![];
    let mut start = 0;
    let mut closing = None;
    for (at, sign) in line.char_indices() {
        match closing {
            Some(end) if sign == end => closing = None,
            Some(_) => {}
            None if "$`\"".contains(sign) => closing = Some(sign),
            None if sign == '.' && ends_sentence(&line[start..at], &line[at + 1..]) => {
                sentences.push((start, at + 1));
                start = at + 1;
            }
            None => {}
        }
    }
    sentences.push((start, line.len()));
    let placed = |(start, end): (usize, usize)| {
        let blank = line[..start].chars().count();
        format!("{}{}", " ".repeat(blank), &line[start..end])
    };
    sentences.into_iter().map(placed).collect()
}

/// Whether a full stop between two texts ends a sentence: behind a word that is not shortened, and before another one that
/// begins as sentences do.
fn ends_sentence(before: &str, behind: &str) -> bool {
    let last = before.split_whitespace().last().unwrap_or_default();
    let shortened = last.contains('.') || SHORTENED.contains(&last.to_lowercase().as_str());
    let next = behind.trim_start();
    let begins = next.starts_with(|c: char| c.is_uppercase() || c == '$' || c == '`');
    !last.is_empty() && !shortened && next.len() < behind.len() && begins
}

/// Words behind which a full stop ends no sentence.
const SHORTENED: [&str; 8] = ["resp", "cf", "fig", "eq", "eqs", "no", "approx", "vs"];

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
fn name_by_kinds(
    sentences: &mut [Result<Vec<Token>, Misread>],
    compounds: &Compounds,
    lexicon: &Lexicon,
) {
    let all = || sentences.iter().flatten().map(Vec::as_slice);
    let (counting, kinds) = (counting_letters(all()), Kinds::of(all()));
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
const GOES_ON: [&str; 7] = ["and", "or", "but", "except", "to", "through", "until"];

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
        let extents = reader.extents().ok();
        let whole = |extents: &Vec<Extent>| extents.is_empty() || *extents == [Extent::Document];
        let extents = extents.filter(|extents| !whole(extents));
        extents.or_else(|| reader.lines_of_formula())
    });
    let mut extents = extents.unwrap_or_else(|| vec![Extent::Document]);
    let limited = extents != [Extent::Document] || may_be_limited;
    let words = reader.quoted_words();
    let signs = reader.written_signs();
    let touched = words.map_or_else(|| reader.touched(limited), Touched::Words);
    let touched = match (touched, signs) {
        (Touched::Everything, Some(signs)) => Touched::WrittenSigns(signs),
        (touched, _) => touched,
    };
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
    let mut before = Reader::new(tokens, end, lexicon, macros, bodies);
    let extents = before.extents().map_or(0, |_| before.at);
    let (extents, clauses) = tokens.split_at(extents);
    let strictly = |clauses: &[Token]| {
        let tokens = [extents, clauses].concat();
        let mut reader = Reader::new(&tokens, end, lexicon, macros, bodies);
        let said = reader.sentence();
        said.map_err(|error| Stuck {
            error,
            left: tokens.len().saturating_sub(reader.at),
        })
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
