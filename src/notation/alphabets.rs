//! Letters of other alphabets that are drawn as Latin ones are.

/// Each letter with the Latin one that it looks like.
const ALIKE: &str =
    "аaеeоoрpсcуyхxіiјjѕsԁdһhԛqԝwАAВBЕEКKМMНHОOРPСCТTУYХXІIЈJЅSΑAΒBΕEΖZΗHΙIΚKΜMΝNΟOΡPΤTΥYΧXοo";

/// The first letter of a text that looks like a Latin one and is another, with that Latin one. A letter in a word of its own
/// alphabet deceives nobody.
///
/// ```
/// use polhode::notation::lookalike;
///
/// assert_eq!(lookalike("M_\u{445}"), Some(('\u{445}', 'x')));
/// assert_eq!(lookalike("Ольга"), None);
/// ```
pub fn lookalike(text: &str) -> Option<(char, char)> {
    if text.is_ascii() {
        return None;
    }
    let letters: Vec<char> = text.chars().collect();
    let same = |at: Option<usize>, c: char| {
        let neighbour = at.and_then(|at| letters.get(at));
        neighbour.is_some_and(|&other| !other.is_ascii() && block(other) == block(c))
    };
    letters.iter().enumerate().find_map(|(at, &c)| {
        let latin = latin(c)?;
        let in_word = same(at.checked_sub(1), c) || same(Some(at + 1), c);
        (!in_word).then_some((c, latin))
    })
}

fn latin(c: char) -> Option<char> {
    let mut pairs = ALIKE
        .chars()
        .step_by(2)
        .zip(ALIKE.chars().skip(1).step_by(2));
    pairs.find(|(own, _)| *own == c).map(|(_, latin)| latin)
}

/// Greek and Cyrillic letters stand 256 to a block.
fn block(c: char) -> u32 {
    u32::from(c) >> 8
}
