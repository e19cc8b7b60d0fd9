//! Sentences that leave open which of two things is so: "O is the mass centre of the body or a point fixed in N."

/// Articles with which what something is begins.
const ARTICLES: [&str; 3] = ["a", "an", "the"];

/// Longer sentences are not parted.
const LONGEST: usize = 400;

/// The two sentences of which one is meant, if it is one that says of something that it is one thing or another.
pub(crate) fn cases(sentence: &str) -> Option<[String; 2]> {
    let said = sentence.trim().trim_end_matches('.');
    let (one, other) = said.split_once(" or ")?;
    let plain = said.len() <= LONGEST && !other.contains(" or ") && !said.contains(['$', '`', ',']);
    let (verb, _) = [" is ", " are "]
        .into_iter()
        .filter_map(|verb| Some((verb, one.find(verb)?)))
        .min_by_key(|(_, at)| *at)?;
    let (subject, what) = one.split_once(verb)?;
    let begins = |text: &str| {
        let first = text.split_whitespace().next();
        first.is_some_and(|first| ARTICLES.contains(&first))
    };
    let told = plain && begins(what) && begins(other);
    told.then(|| [format!("{one}."), format!("{subject}{verb}{other}.")])
}
