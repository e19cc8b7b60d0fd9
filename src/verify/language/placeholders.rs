//! Marks that are shown around a dot: "`$[\cdot\times]$` is the cross-product matrix of the letter inside" as "`$[v\times]$`
//! is the cross-product matrix of `$v$`, for any vector `$v$`".

use super::rewrite::put_in;
use super::words::{Kind, Token};

/// What stands for something inside a mark.
const DOT: &str = "\\cdot";

/// A letter in the place of the dot.
const LETTER: &str = "v";

/// Words for where it stands.
const INSIDE: [&str; 3] = ["inside", "within", "enclosed"];

/// The sentence with a letter for the dot and for "the letter inside".
pub(super) fn with_letter_inside(tokens: &[Token]) -> Option<Vec<Token>> {
    let [mark, middle @ .., the, noun, inside] = tokens else {
        return None;
    };
    let shown = mark.kind == Kind::Formula && mark.text.matches(DOT).count() == 1;
    let said = the.lower == "the" && INSIDE.contains(&inside.lower.as_str());
    let vector = matches!(noun.lower.as_str(), "letter" | "vector" | "column");
    (shown && said && vector).then_some(())?;
    let mark = put_in(Kind::Formula, &mark.text.replace(DOT, LETTER), mark);
    let letter = put_in(Kind::Formula, LETTER, noun);
    let comma = put_in(Kind::Comma, "", noun);
    let any = ["for", "any", "vector"].map(|word| put_in(Kind::Word, word, noun));
    let told = [&[mark], middle, &[letter.clone(), comma], &any, &[letter]];
    Some(told.concat())
}
