//! "The angles and their rates are small", where one sentence tells which letters the angles are.

use super::rewrite::put_in;
use super::statement::Misread;
use super::words::{Kind, Token};

/// Words for how angles change.
const RATES: [&str; 3] = ["rates", "derivatives", "velocities"];

/// Puts the letters of the angles in the place of "the angles" and "the angles and their rates" at the beginning of sentences.
pub(super) fn tell_angles(sentences: &mut [Result<Vec<Token>, Misread>]) {
    let mut told = sentences.iter().flatten().filter_map(|s| angles_told(s));
    let (Some(angles), None) = (told.next(), told.next()) else {
        return;
    };
    for tokens in sentences.iter_mut().flatten() {
        let word = |at: usize| tokens.get(at).map_or("", |t: &Token| t.lower.as_str());
        if word(0) != "the" || word(1) != "angles" {
            continue;
        }
        let rates = word(2) == "and" && word(3) == "their" && RATES.contains(&word(4));
        let behind = if rates { 5 } else { 2 };
        if !matches!(word(behind), "are" | "stay" | "remain") {
            continue;
        }
        let near = tokens[0].clone();
        let changes = angles.iter().filter(|_| rates);
        let changes = changes.map(|angle| format!("\\dot{{{}}}", angle.text));
        let letters = angles.iter().map(|angle| angle.text.clone());
        let letters: Vec<String> = letters.chain(changes).collect();
        let mut list = vec![];
        for (at, letter) in letters.iter().enumerate() {
            if at > 0 {
                list.push(put_in(Kind::Comma, ",", &near));
            }
            list.push(put_in(Kind::Formula, letter, &near));
        }
        *tokens = [&list, &tokens[behind..]].concat();
    }
}

/// "`$a$`, `$b$`, `$c$` are the Euler angles of B relative to N": the letters of several angles.
fn angles_told(tokens: &[Token]) -> Option<Vec<Token>> {
    let listed = |t: &&Token| t.kind == Kind::Formula || t.kind == Kind::Comma || t.lower == "and";
    let list = tokens.iter().take_while(listed).count();
    let mut rest = tokens.get(list..)?.iter().map(|t| t.lower.as_str());
    let are = rest.next() == Some("are");
    let angles = rest.any(|word| word == "angles");
    let letters = tokens[..list].iter().filter(|t| t.kind == Kind::Formula);
    let letters: Vec<Token> = letters.cloned().collect();
    (are && angles && letters.len() > 1).then_some(letters)
}
