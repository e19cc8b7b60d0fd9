//! How words are inflected, and the short form in which the lexicon writes several.

/// The forms between bars; bars between brackets do not part.
pub(crate) fn parted(forms: &'static str) -> Vec<&'static str> {
    let mut inside = false;
    forms
        .split(move |c| {
            inside = (inside || c == '(') && c != ')';
            c == '|' && !inside
        })
        .collect()
}

/// The forms that `cent(re|er)` stands for.
pub(crate) fn alternatives(form: &'static str) -> Vec<String> {
    let Some((before, rest)) = form.split_once('(') else {
        return vec![form.to_owned()];
    };
    let Some((inside, after)) = rest.split_once(')') else {
        return vec![];
    };
    let rests = alternatives(after);
    let one = |a: &str| -> Vec<String> {
        let whole = |rest: &String| format!("{before}{a}{rest}");
        rests.iter().map(whole).collect()
    };
    inside.split('|').flat_map(one).collect()
}

/// The plural of a noun: the ending is on the word before "of" or on the last one.
pub(crate) fn in_plural(noun: &str) -> String {
    const STOPS: [&str; 5] = [" of ", " in ", " to ", " without ", " about "];
    let mut spaces = noun.char_indices().filter(|(_, c)| *c == ' ');
    let end = spaces.find(|(at, _)| STOPS.iter().any(|stop| noun[*at..].starts_with(stop)));
    let (head, rest) = noun.split_at(end.map_or(noun.len(), |(at, _)| at));
    format!("{}{rest}", with_s(head))
}

/// A verb whose first word takes an ending.
pub(crate) fn on_first(verb: &str, ending: fn(&str) -> String) -> String {
    match verb.split_once(' ') {
        Some((first, rest)) => format!("{} {rest}", ending(first)),
        None => ending(verb),
    }
}

pub(crate) fn with_s(word: &str) -> String {
    let hissing = ["s", "x", "z", "ch", "sh"];
    match word.strip_suffix('y') {
        _ if word == "have" => "has".into(),
        Some(stem) if !stem.ends_with(['a', 'e', 'o', 'u']) => format!("{stem}ies"),
        _ if hissing.iter().any(|h| word.ends_with(h)) => format!("{word}es"),
        _ => format!("{word}s"),
    }
}

pub(crate) fn with_ed(word: &str) -> String {
    match word.strip_suffix('e') {
        Some(stem) => format!("{stem}ed"),
        None => format!("{word}ed"),
    }
}
