//! Other ways to say a sentence, brought to the plain one before the grammar reads it.
//!
//! The rules are data (`rewrites.txt`): a pattern, what it becomes, and a sentence that shows it. They move and replace
//! words, and know nothing of what a sentence means.

use super::reader::{ARTICLES, COPULAS};
use super::rewrite_rules::{ALL, FIRST, Piece, RULES, Rule, is_one_of, rule};
use super::words::{Kind, Token, tokens};

/// A sentence is rewritten no more often.
const MOST_TIMES: usize = 24;

/// A longer sentence is not rewritten, and none becomes longer: a rule may say a subject twice.
const LONGEST: usize = 120;

/// The sentence in plainer words.
pub(crate) fn plainly(tokens: &[Token]) -> Vec<Token> {
    let mut tokens = tokens.to_vec();
    for _ in 0..MOST_TIMES {
        if tokens.len() > LONGEST {
            break;
        }
        let applied = ALL
            .fitting(&tokens)
            .filter_map(|rule| rule.applied(&tokens));
        let Some(next) = applied
            .into_iter()
            .find(|next| *next != tokens && next.len() <= LONGEST)
        else {
            break;
        };
        tokens = next;
    }
    tokens
}

/// The sentence as a rule says it that comes before the grammar.
pub(crate) fn said_first(tokens: &[Token]) -> Option<Vec<Token>> {
    FIRST.fitting(tokens).find_map(|rule| rule.applied(tokens))
}

/// The rules that are found by no word of their example, or leave it as it is: each is a slip of the pen.
pub fn idle_rules() -> Vec<&'static str> {
    let works = |line: &'static str| {
        let (_, example) = line.split_once("##")?;
        let (rule, before) = (rule(line)?, tokens(example.trim(), 1).ok()?);
        let changes = rule.applied(&before)? != before;
        let mut fitting = ALL.fitting(&before);
        (changes && fitting.any(|other| other.pattern == rule.pattern)).then_some(())
    };
    let rules = RULES.lines().filter(|line| !line.starts_with('#'));
    let rules = rules.filter(|line| line.contains("=>"));
    rules.filter(|line| works(line).is_none()).collect()
}

/// Stands for a word that a pattern has among others.
const CHOSEN: char = '|';

/// What the letters of a pattern stand for, and which of several words stood there, the last ones first.
type Bound<'t> = Vec<(char, &'t [Token])>;

impl Rule {
    fn applied(&self, tokens: &[Token]) -> Option<Vec<Token>> {
        if self.whole {
            return self.applied_to_clause(tokens);
        }
        (0..tokens.len()).find_map(|at| {
            let (length, bound) = matched(&self.pattern, &tokens[at..], false)?;
            let mut new = tokens[..at].to_vec();
            new.extend(self.written(&bound, &tokens[at])?);
            new.extend_from_slice(&tokens[at + length..]);
            Some(new)
        })
    }

    /// Applied to the first clause that it fits; clauses end at semicolons. A rule of several clauses is one of the whole
    /// sentence.
    fn applied_to_clause(&self, tokens: &[Token]) -> Option<Vec<Token>> {
        if self.pattern.contains(&Piece::Sign(Kind::Semicolon)) {
            let (_, bound) = matched(&self.pattern, tokens, true)?;
            return self.written(&bound, tokens.first()?);
        }
        let mut start = 0;
        for clause in tokens.split(|t| t.kind == Kind::Semicolon) {
            let end = start + clause.len();
            if let Some(first) = clause.first()
                && let Some((_, bound)) = matched(&self.pattern, clause, true)
                && let Some(written) = self.written(&bound, first)
            {
                let mut new = tokens[..start].to_vec();
                new.extend(written);
                new.extend_from_slice(&tokens[end..]);
                return Some(new);
            }
            start = end + 1;
        }
        None
    }

    /// What the pattern becomes, if it can; words that are put in stand where `near` stands.
    fn written(&self, bound: &Bound<'_>, near: &Token) -> Option<Vec<Token>> {
        let mut new: Vec<Token> = vec![];
        for piece in &self.plain() {
            match piece {
                Piece::Any(c)
                | Piece::One(c)
                | Piece::Formulas(c)
                | Piece::Phrase(c)
                | Piece::Clause(c) => {
                    let found = bound.iter().find(|(letter, _)| letter == c);
                    let at = new.len();
                    new.extend(found.iter().flat_map(|(_, tokens)| tokens.iter().cloned()));
                    // The article that began the sentence is no name where it stands now.
                    if let (Piece::Phrase(_), 1.., [article, _, ..]) = (piece, at, &mut new[at..])
                        && article.column == 1
                        && ARTICLES.contains(&article.lower.as_str())
                    {
                        article.text.clone_from(&article.lower);
                    }
                }
                Piece::Words(words) | Piece::Maybe(words) => {
                    let place = new.last().unwrap_or(near);
                    let stood = bound.iter().rev().find_map(|bound| match bound {
                        (CHOSEN, [word]) if is_one_of(word, words) => Some(word.clone()),
                        _ => None,
                    });
                    let word = || {
                        put_in(
                            Kind::Word,
                            words.first().copied().unwrap_or_default(),
                            place,
                        )
                    };
                    new.push(stood.unwrap_or_else(word));
                }
                Piece::Sign(kind) => {
                    let place = new.last().unwrap_or(near);
                    new.push(put_in(*kind, "", place));
                }
                Piece::Built(pattern) => {
                    let place = new.last().unwrap_or(near);
                    new.push(put_in(Kind::Formula, &built(pattern, bound)?, place));
                }
            }
        }
        Some(new)
    }
}

/// A formula with formulas for the capitals of a pattern; none where one stands for a list of them.
fn built(pattern: &str, bound: &Bound<'_>) -> Option<String> {
    let source = |c: char| bound.iter().find(|(letter, _)| *letter == c);
    let piece = |c: char| match (c, source(c)) {
        ('*', _) => Some(" ".to_owned()),
        (_, Some((_, [one]))) => Some(one.text.clone()),
        (_, Some(_)) => None,
        (c, None) => Some(c.to_string()),
    };
    pattern.chars().map(piece).collect()
}

/// A piece that the author did not write, at the place of another.
pub(crate) fn put_in(kind: Kind, text: &str, near: &Token) -> Token {
    Token {
        kind,
        text: text.to_owned(),
        lower: text.to_lowercase(),
        column: near.column,
    }
}

/// How many pieces a pattern takes, all of them where `whole`, and what its letters stand for.
fn matched<'t>(pattern: &[Piece], tokens: &'t [Token], whole: bool) -> Option<(usize, Bound<'t>)> {
    let Some((piece, rest)) = pattern.split_first() else {
        return (!whole || tokens.is_empty()).then(|| (0, vec![]));
    };
    let behind = |length: usize| {
        let (used, bound) = matched(rest, tokens.get(length..)?, whole)?;
        Some((used + length, bound))
    };
    // A letter that stands twice stands for the same words.
    let letter = |c: char, length: usize| {
        let (used, mut bound) = behind(length)?;
        let own = tokens.get(..length)?;
        let other = bound.iter().find(|(letter, _)| *letter == c);
        let same = |(_, other): &(char, &[Token])| said_alike(other, own);
        other.is_none_or(same).then_some(())?;
        bound.push((c, own));
        Some((used, bound))
    };
    let one_of = |words: &[&str]| {
        let (used, mut bound) = tokens
            .first()
            .filter(|t| is_one_of(t, words))
            .and_then(|_| behind(1))?;
        if words.len() > 1 {
            bound.push((CHOSEN, &tokens[..1]));
        }
        Some((used, bound))
    };
    match piece {
        Piece::Words(words) => one_of(words),
        Piece::Maybe(words) => one_of(words).or_else(|| behind(0)),
        Piece::Sign(kind) => (tokens.first()?.kind == *kind)
            .then_some(())
            .and_then(|()| behind(1)),
        Piece::Built(_) => None,
        Piece::One(c) => letter(*c, 1),
        Piece::Any(c) | Piece::Phrase(c) | Piece::Clause(c) => {
            if matches!(piece, Piece::Phrase(_)) && !begins_phrase(tokens.first()?) {
                return None;
            }
            // The last letter takes all that is left, which may be nothing where it stands for any words.
            let least = usize::from(!matches!(piece, Piece::Any(_)));
            let shortest = match rest.is_empty() && whole {
                true => tokens.len().max(least),
                false => 1,
            };
            let ends = |t: &Token| match piece {
                Piece::Phrase(_) => COPULAS.contains(&t.lower.as_str()),
                Piece::Clause(_) => t.kind == Kind::Comma,
                _ => false,
            };
            let longest = tokens.iter().position(ends).unwrap_or(tokens.len());
            (shortest..=longest).find_map(|length| letter(*c, length))
        }
        Piece::Formulas(c) => list_lengths(tokens).find_map(|length| letter(*c, length)),
    }
}

/// Whether two parts of a sentence have the same words.
fn said_alike(one: &[Token], other: &[Token]) -> bool {
    let mut pairs = one.iter().zip(other);
    one.len() == other.len() && pairs.all(|(one, other)| one.lower == other.lower)
}

fn begins_phrase(token: &Token) -> bool {
    token.kind == Kind::Word
        && (ARTICLES.contains(&token.lower.as_str()) || token.lower.ends_with("'s"))
        && !COPULAS.contains(&token.lower.as_str())
}

/// How many pieces a list may be taken to have: all of them, or fewer where its last letter is what another clause is about.
fn list_lengths(tokens: &[Token]) -> impl Iterator<Item = usize> {
    let whole = formulas(tokens);
    let clause = move |&end: &usize| {
        let behind = end + 1 + formulas(tokens.get(end + 1..).unwrap_or_default());
        let verb = tokens.get(behind).map(|t| t.lower.as_str());
        behind > end + 1 && verb.is_some_and(|verb| COPULAS.contains(&verb))
    };
    let lengths = std::iter::once(whole).chain((1..whole).filter(clause));
    lengths.filter(|length| *length > 0)
}

/// How many pieces a list of formulas takes.
fn formulas(tokens: &[Token]) -> usize {
    let is_formula = |token: &Token| matches!(token.kind, Kind::Formula | Kind::Plain);
    let mut length = 0;
    let mut end = 0;
    while tokens.get(length).is_some_and(is_formula) {
        end = length + 1;
        length = end;
        let comma = tokens.get(length).is_some_and(|t| t.kind == Kind::Comma);
        length += usize::from(comma);
        let and = tokens
            .get(length)
            .is_some_and(|t| matches!(t.lower.as_str(), "and" | "or"));
        length += usize::from(and);
        if !comma && !and {
            break;
        }
    }
    end
}
